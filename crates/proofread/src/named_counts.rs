//! Counts by kind and name.

use std::collections::BTreeMap;

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
pub struct NamedCounts<K>(BTreeMap<(K, String), usize>);

impl<K> Default for NamedCounts<K> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<K: Copy + Ord> NamedCounts<K> {
    /// Counts one more, or several.
    pub(crate) fn count(&mut self, kind: K, name: &str, times: usize) {
        let short: String = name.chars().take(LONGEST_NAME).filter(|c| !c.is_control()).collect();
        let known = self.0.len() < MOST_NAMES || self.0.contains_key(&(kind, short.clone()));
        *self.0.entry((kind, if known { short } else { OTHERS.to_owned() })).or_default() += times;
    }

    /// Adds other counts.
    pub fn add(&mut self, other: &Self) {
        other.iter().for_each(|(kind, name, times)| self.count(kind, name, times));
    }

    /// Kinds, names and counts, in the order of the kinds.
    pub fn iter(&self) -> impl Iterator<Item = (K, &str, usize)> {
        self.0.iter().map(|((kind, name), times)| (*kind, name.as_str(), *times))
    }

    /// All counts together.
    pub fn total(&self) -> usize {
        self.0.values().sum()
    }
}
