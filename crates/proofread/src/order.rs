//! The order of things by their places.

/// Sorts by a key; what has the same key stays in its order.
///
/// There is one sort of keys and places, whatever is put in order: in the page's module a sort of its own for each type would be a
/// tenth of the code.
pub(crate) fn sort_by_place<T, K: Into<PlaceKey>>(items: &mut Vec<T>, key: impl Fn(&T) -> K) {
    let mut order: Vec<(PlaceKey, usize)> = items.iter().enumerate().map(|(at, item)| (key(item).into(), at)).collect();
    if order.is_sorted() {
        return;
    }
    order.sort_unstable();
    let mut left: Vec<Option<T>> = std::mem::take(items).into_iter().map(Some).collect();
    items.extend(order.iter().filter_map(|(_, at)| left[*at].take()));
}

/// What is compared: two numbers, the first one first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct PlaceKey(usize, usize);

impl From<usize> for PlaceKey {
    fn from(place: usize) -> Self {
        Self(place, 0)
    }
}

impl From<(usize, usize)> for PlaceKey {
    fn from((first, second): (usize, usize)) -> Self {
        Self(first, second)
    }
}

impl From<crate::token::Span> for PlaceKey {
    fn from(span: crate::token::Span) -> Self {
        Self(span.start as usize, span.end as usize)
    }
}

/// A number, from the least to the greatest as [`f64::total_cmp`] has them.
pub(crate) struct NumberKey(pub f64);

impl From<NumberKey> for PlaceKey {
    fn from(NumberKey(number): NumberKey) -> Self {
        let bits = number.to_bits();
        let ordered = if bits >> 63 == 0 { bits | 1 << 63 } else { !bits };
        Self((ordered >> 32) as usize, (ordered & 0xffff_ffff) as usize)
    }
}

/// Sorts words and takes out those that occur twice, for lists of a few.
pub(crate) fn sort_few_without_repeats<T: Ord>(items: &mut Vec<T>) {
    let mut out: Vec<T> = Vec::with_capacity(items.len());
    for item in items.drain(..) {
        if let Err(at) = out.binary_search(&item) {
            out.insert(at, item);
        }
    }
    *items = out;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_the_same_key_stays_in_its_order() {
        let mut items = vec![(3_usize, "a"), (1, "b"), (3, "c"), (1, "d"), (2, "e")];
        sort_by_place(&mut items, |of| of.0);
        assert_eq!(items.iter().map(|of| of.1).collect::<String>(), "bdeac");
        let mut items = vec![(0_usize, 2_usize), (0, 1), (0, 3)];
        sort_by_place(&mut items, |of| *of);
        assert_eq!(items, [(0, 1), (0, 2), (0, 3)]);
        let mut numbers = vec![2.0, -1.0, 0.0, f64::MIN_POSITIVE, -3.5, 1e300, -0.0, -1e-300];
        let mut expected = numbers.clone();
        expected.sort_by(f64::total_cmp);
        sort_by_place(&mut numbers, |of| NumberKey(*of));
        assert_eq!(
            numbers.iter().map(|of| of.to_bits()).collect::<Vec<_>>(),
            expected.iter().map(|of| of.to_bits()).collect::<Vec<_>>()
        );
    }

    #[test]
    fn a_few_words_are_sorted_once_each() {
        let mut words = vec!["b", "a", "b", "c", "a"];
        sort_few_without_repeats(&mut words);
        assert_eq!(words, ["a", "b", "c"]);
    }
}
