//! The name that was probably meant.

/// The name among these that is most like another one; none if there are none.
///
/// ```
/// assert_eq!(geneva_evidence::nearest_name("radios", ["length", "radius"]), Some("radius"));
/// assert_eq!(geneva_evidence::nearest_name("radios", []), None);
/// ```
pub fn nearest_name<'a>(name: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    names.into_iter().max_by(|a, b| strsim::jaro(name, a).total_cmp(&strsim::jaro(name, b)))
}
