//! The order of the statements: each behind those whose results it needs at the same time.

/// The groups of nodes that need each other, each behind the groups that it needs. `needs` has the nodes that each node
/// needs. Most groups have one node.
///
/// Tarjan's algorithm, which looks once at each node and each need; a chain of any length takes no deeper stack.
pub(super) fn components(needs: &[Vec<usize>]) -> Vec<Vec<usize>> {
    const NEW: usize = usize::MAX;
    let (mut index, mut low) = (vec![NEW; needs.len()], vec![0; needs.len()]);
    let (mut waiting, mut is_waiting) = (Vec::new(), vec![false; needs.len()]);
    let (mut found, mut next) = (Vec::new(), 0);
    for root in 0..needs.len() {
        if index[root] != NEW {
            continue;
        }
        // The way from the root: nodes, and how many of their needs have been looked at.
        let mut way = vec![(root, 0)];
        while let Some((node, looked_at)) = way.last_mut() {
            let node = *node;
            if *looked_at == 0 && index[node] == NEW {
                (index[node], low[node]) = (next, next);
                next += 1;
                waiting.push(node);
                is_waiting[node] = true;
            }
            if let Some(&other) = needs[node].get(*looked_at) {
                *looked_at += 1;
                if index[other] == NEW {
                    way.push((other, 0));
                } else if is_waiting[other] {
                    low[node] = low[node].min(index[other]);
                }
                continue;
            }
            way.pop();
            if let Some((before, _)) = way.last() {
                low[*before] = low[*before].min(low[node]);
            }
            if low[node] == index[node] {
                let start = waiting.iter().rposition(|of| *of == node).unwrap_or(0);
                let mut group = waiting.split_off(start);
                group.iter().for_each(|of| is_waiting[*of] = false);
                group.sort_unstable();
                found.push(group);
            }
        }
    }
    found
}

/// A circle in a group of nodes that need each other: each needs the next, and the last the first. It begins with the
/// first node of the group and is as short as a circle through it can be.
pub(super) fn circle(group: &[usize], needs: &[Vec<usize>]) -> Vec<usize> {
    let Some(&first) = group.first() else { return Vec::new() };
    let mut from = std::collections::BTreeMap::new();
    let mut next = std::collections::VecDeque::from([first]);
    while let Some(node) = next.pop_front() {
        for &other in &needs[node] {
            if other == first {
                let mut way = vec![node];
                while let Some(before) = way.last().filter(|last| **last != first).and_then(|last| from.get(last)) {
                    way.push(*before);
                }
                way.reverse();
                return way;
            }
            if group.binary_search(&other).is_ok() && !from.contains_key(&other) {
                from.insert(other, node);
                next.push_back(other);
            }
        }
    }
    vec![first]
}

/// One statement in the sorted program.
#[derive(Clone, Debug, PartialEq)]
pub struct SortedStatement {
    /// Its card, counted from 1.
    pub card: usize,
    /// Its place among the statements of the deck.
    pub(super) statement: usize,
    /// Its result.
    pub result: String,
    /// The control variable that it stands under.
    pub control: Option<String>,
    /// When it is computed.
    pub when: Schedule,
    /// Whether nothing that is printed, plotted or integrated, nor the end of the run, depends on it.
    pub is_dead: bool,
}

/// When a statement is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Schedule {
    /// Once in a run: all that it needs is known before.
    Once,
    /// At every evaluation of the derivatives.
    Always,
}
