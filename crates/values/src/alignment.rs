//! Two lists of characters in the same order: what stayed, what was changed in its place, and what was moved with its row.
//!
//! In a table there are hardly words around a number, so its place among the others says which it is. What stayed is a longest list
//! that is in the same order in both, as in a comparison of two versions of a file. So two numbers that changed places are two
//! changes, and a row that came in is none.

use std::collections::HashMap;
use std::hash::Hash;
use std::ops::Range;

/// How often a gap between what stayed is looked at again.
const DEEPEST: usize = 12;

/// Pairs of places in an old and a new list that belong together, in order, each with whether it is sure: other pairs are as many
/// items in the old list as in the new one, between two that stayed. What is in no pair came in, went away or was moved.
pub(crate) fn aligned<T: Eq + Hash>(old: &[T], new: &[T]) -> Vec<(usize, usize, bool)> {
    let mut pairs = Vec::new();
    gap(old, new, 0..old.len(), 0..new.len(), 0, &mut pairs);
    pairs.sort_unstable();
    pairs
}

fn gap<T: Eq + Hash>(
    old: &[T],
    new: &[T],
    mut mine: Range<usize>,
    mut found: Range<usize>,
    depth: usize,
    pairs: &mut Vec<(usize, usize, bool)>,
) {
    while !mine.is_empty() && !found.is_empty() && old[mine.start] == new[found.start] {
        pairs.push((mine.start, found.start, true));
        (mine.start, found.start) = (mine.start + 1, found.start + 1);
    }
    while !mine.is_empty() && !found.is_empty() && old[mine.end - 1] == new[found.end - 1] {
        (mine.end, found.end) = (mine.end - 1, found.end - 1);
        pairs.push((mine.end, found.end, true));
    }
    if mine.is_empty() || found.is_empty() {
        return;
    }
    let stayed = if depth < DEEPEST { in_order(&unique_pairs(old, new, &mine, &found)) } else { Vec::new() };
    if stayed.is_empty() {
        if mine.len() == found.len() {
            let is_sure = mine.len() == 1;
            pairs.extend(mine.zip(found).map(|(mine, found)| (mine, found, is_sure)));
        }
        return;
    }
    let (mut from, end) = ([mine.start, found.start], [mine.end, found.end]);
    for [mine, found] in stayed.into_iter().map(|(mine, found)| [mine, found]).chain([end]) {
        gap(old, new, from[0]..mine, from[1]..found, depth + 1, pairs);
        if [mine, found] != end {
            pairs.push((mine, found, true));
        }
        from = [mine + 1, found + 1];
    }
}

/// The items that are once in a part of either list, by their places in the old one.
fn unique_pairs<T: Eq + Hash>(old: &[T], new: &[T], mine: &Range<usize>, found: &Range<usize>) -> Vec<(usize, usize)> {
    // For each item how often it is in either part, and where it is last.
    let mut seen: HashMap<&T, [(usize, usize); 2]> = HashMap::new();
    for (which, list, range) in [(0, old, mine), (1, new, found)] {
        for at in range.clone() {
            let (count, last) = &mut seen.entry(&list[at]).or_default()[which];
            (*count, *last) = (*count + 1, at);
        }
    }
    let pair = |at| match seen.get(&old[at]) {
        Some([(1, _), (1, other)]) => Some((at, *other)),
        _ => None,
    };
    mine.clone().filter_map(pair).collect()
}

/// A longest list of pairs in which both places grow. The first places grow already.
fn in_order(pairs: &[(usize, usize)]) -> Vec<(usize, usize)> {
    // For each length the pair that ends a list of that length with the smallest second place.
    let mut ends: Vec<usize> = Vec::new();
    let mut before: Vec<Option<usize>> = vec![None; pairs.len()];
    for (at, (_, found)) in pairs.iter().enumerate() {
        let length = ends.partition_point(|end| pairs[*end].1 < *found);
        before[at] = length.checked_sub(1).map(|shorter| ends[shorter]);
        if length == ends.len() {
            ends.push(at);
        } else {
            ends[length] = at;
        }
    }
    let mut longest: Vec<(usize, usize)> =
        std::iter::successors(ends.last().copied(), |at| before[*at]).map(|at| pairs[at]).collect();
    longest.reverse();
    longest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pairs(old: &str, new: &str) -> Vec<(usize, usize)> {
        let [old, new] = [old, new].map(|text| text.bytes().collect::<Vec<_>>());
        aligned(&old, &new).into_iter().map(|(mine, found, _)| (mine, found)).collect()
    }

    #[test]
    fn what_stayed_is_in_order() {
        assert_eq!(pairs("abc", "abc"), [(0, 0), (1, 1), (2, 2)]);
        assert_eq!(pairs("abc", "axbc"), [(0, 0), (1, 2), (2, 3)]);
        assert_eq!(pairs("abcd", "ad"), [(0, 0), (3, 1)]);
        assert_eq!(pairs("", "abc"), []);
    }

    #[test]
    fn items_that_changed_places_are_two_changes() {
        // Each is paired with what is in its place now.
        assert_eq!(pairs("abcdefg", "afcdebg"), (0..7).map(|at| (at, at)).collect::<Vec<_>>());
        // Neighbours: one stayed, and the other one is in no pair.
        assert_eq!(pairs("abcd", "acbd").len(), 3);
    }

    #[test]
    fn many_equal_items_take_no_time() {
        let old = vec![0u8; 100_000];
        let mut new = old.clone();
        new[50_000] = 1;
        assert_eq!(aligned(&old, &new).len(), old.len());
        let alternating: Vec<u8> = (0..100_000).map(|at| (at % 2) as u8).collect();
        let other: Vec<u8> = (0..100_001).map(|at| (at % 3) as u8).collect();
        assert!(aligned(&alternating, &other).len() <= alternating.len());
    }
}
