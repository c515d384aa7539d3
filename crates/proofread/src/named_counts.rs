//! Counts by kind and name.

/// Most names that are told apart.
const MOST_NAMES: usize = 200;
/// Longest name, in characters.
const LONGEST_NAME: usize = 60;
/// What stands for all further names.
const OTHERS: &str = "others";

/// How often something occurs, by its kind and its name; the name is empty where a kind has none.
///
/// ```
/// use proofread::{CheckOptions, TextFormat, UncheckedKind, proofread};
///
/// let report = proofread(r"$\foo{7} = 36$, $x + 1 = 2$, $2 - y = 3$", TextFormat::Markdown, CheckOptions::default())?;
/// let counts: Vec<_> = report.not_checked.iter().collect();
/// assert_eq!(counts, [(UncheckedKind::Command, "\\foo", 1), (UncheckedKind::Letter, "", 2)]);
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedCounts<K>(Vec<(K, String, usize)>);

impl<K> Default for NamedCounts<K> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<K: Copy + Ord> NamedCounts<K> {
    /// Counts one more, or several.
    pub(crate) fn count(&mut self, kind: K, name: &str, times: usize) {
        let name = name.char_indices().nth(LONGEST_NAME).map_or(name, |(end, _)| &name[..end]);
        let place =
            |name: &str| self.0.binary_search_by(|(its, of, _)| its.cmp(&kind).then_with(|| of.as_str().cmp(name)));
        let name = if place(name).is_err() && self.0.len() >= MOST_NAMES { OTHERS } else { name };
        match place(name) {
            Ok(at) => self.0[at].2 += times,
            Err(at) => self.0.insert(at, (kind, name.to_owned(), times)),
        }
    }

    /// Counts one less, if there is one.
    #[cfg(feature = "cli")]
    pub(crate) fn discount(&mut self, kind: K, name: &str) {
        let name = name.char_indices().nth(LONGEST_NAME).map_or(name, |(end, _)| &name[..end]);
        let at = |name: &str| self.0.iter().position(|(its, of, _)| *its == kind && of == name);
        if let Some(at) = at(name).or_else(|| at(OTHERS)) {
            self.0[at].2 -= 1;
            self.0.retain(|(.., times)| *times > 0);
        }
    }

    /// Adds other counts.
    pub fn add(&mut self, other: &Self) {
        other.iter().for_each(|(kind, name, times)| self.count(kind, name, times));
    }

    /// Kinds, names and counts, in the order of the kinds and of the names.
    pub fn iter(&self) -> impl Iterator<Item = (K, &str, usize)> {
        self.0.iter().map(|(kind, name, times)| (*kind, name.as_str(), *times))
    }

    /// All counts together.
    pub fn total(&self) -> usize {
        self.iter().map(|(.., times)| times).sum()
    }
}
