//! What is to be done after a pause. Nothing here asks what time it is.

use std::collections::BTreeMap;

/// What waits, and until when, by any clock.
pub(super) struct Debouncer<K, T>(BTreeMap<K, T>);

impl<K, T> Default for Debouncer<K, T> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<K: Ord + Clone, T: Ord + Copy> Debouncer<K, T> {
    /// Lets something wait until `due`, and no longer until the time that was said before.
    pub(super) fn schedule(&mut self, what: K, due: T) {
        self.0.insert(what, due);
    }

    /// Lets something that waits already wait on, and anything else until `due`.
    pub(super) fn schedule_also(&mut self, what: K, due: T) {
        self.0.entry(what).or_insert(due);
    }

    /// Forgets what waits.
    pub(super) fn cancel(&mut self, what: &K) {
        self.0.remove(what);
    }

    /// When the first is due.
    pub(super) fn next_due(&self) -> Option<T> {
        self.0.values().min().copied()
    }

    /// Takes what has been due longest.
    pub(super) fn take_due(&mut self, now: T) -> Option<K> {
        let (what, _) = self.0.iter().filter(|(_, due)| **due <= now).min_by_key(|(_, due)| **due)?;
        let what = what.clone();
        self.0.remove(&what);
        Some(what)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_later_change_puts_off_what_waits() {
        let mut waiting = Debouncer::default();
        waiting.schedule("a", 300);
        assert_eq!((waiting.take_due(299), waiting.next_due()), (None, Some(300)));
        waiting.schedule("a", 500);
        assert_eq!(waiting.take_due(300), None);
        assert_eq!((waiting.take_due(500), waiting.take_due(900), waiting.next_due()), (Some("a"), None, None));
    }

    #[test]
    fn what_has_waited_longest_comes_first() {
        let mut waiting = Debouncer::default();
        waiting.schedule("a", 20);
        waiting.schedule("b", 10);
        waiting.schedule("c", 5);
        waiting.cancel(&"c");
        waiting.schedule_also("a", 1);
        waiting.schedule_also("d", 30);
        assert_eq!(waiting.next_due(), Some(10));
        let order: Vec<_> = std::iter::from_fn(|| waiting.take_due(100)).collect();
        assert_eq!(order, ["b", "a", "d"]);
    }
}
