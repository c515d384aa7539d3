//! What is to be done after a pause. Nothing here asks what time it is.

use std::collections::BTreeMap;
use std::time::Instant;

/// What waits, and until when.
pub(super) struct Debouncer<K>(BTreeMap<K, Instant>);

impl<K> Default for Debouncer<K> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<K: Ord + Clone> Debouncer<K> {
    /// Lets something wait until `due`, and no longer until the time that was said before.
    pub(super) fn schedule(&mut self, what: K, due: Instant) {
        self.0.insert(what, due);
    }

    /// Lets something that waits already wait on, and anything else until `due`.
    pub(super) fn schedule_also(&mut self, what: K, due: Instant) {
        self.0.entry(what).or_insert(due);
    }

    /// Forgets what waits.
    pub(super) fn cancel(&mut self, what: &K) {
        self.0.remove(what);
    }

    /// When the first is due.
    pub(super) fn next_due(&self) -> Option<Instant> {
        self.0.values().min().copied()
    }

    /// Takes what has been due longest.
    pub(super) fn take_due(&mut self, now: Instant) -> Option<K> {
        let (what, _) = self.0.iter().filter(|(_, due)| **due <= now).min_by_key(|(_, due)| **due)?;
        let what = what.clone();
        self.0.remove(&what);
        Some(what)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn a_later_change_puts_off_what_waits() {
        let start = Instant::now();
        let at = |ms: u64| start + Duration::from_millis(ms);
        let mut waiting = Debouncer::default();
        waiting.schedule("a", at(300));
        assert_eq!((waiting.take_due(at(299)), waiting.next_due()), (None, Some(at(300))));
        waiting.schedule("a", at(500));
        assert_eq!(waiting.take_due(at(300)), None);
        assert_eq!((waiting.take_due(at(500)), waiting.take_due(at(900)), waiting.next_due()), (Some("a"), None, None));
    }

    #[test]
    fn what_has_waited_longest_comes_first() {
        let start = Instant::now();
        let at = |ms: u64| start + Duration::from_millis(ms);
        let mut waiting = Debouncer::default();
        waiting.schedule("a", at(20));
        waiting.schedule("b", at(10));
        waiting.schedule("c", at(5));
        waiting.cancel(&"c");
        waiting.schedule_also("a", at(1));
        waiting.schedule_also("d", at(30));
        assert_eq!(waiting.next_due(), Some(at(10)));
        let order: Vec<_> = std::iter::from_fn(|| waiting.take_due(at(100))).collect();
        assert_eq!(order, ["b", "a", "d"]);
    }
}
