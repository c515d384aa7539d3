//! In how many places two formulas differ.

use super::pieces::pieces;

/// What an alignment of two formulas costs: first the pieces that are put in, left out or exchanged, then the places in which
/// they are.
type Cost = (usize, usize);

/// In how many places one formula has other pieces than another: the runs of changed pieces in the alignment with the fewest
/// changed pieces. Blanks, spacing and the sizes of brackets don't count.
pub fn places_changed(was: &str, is: &str) -> usize {
    let [was, is] = [was, is].map(pieces);
    let nowhere = (usize::MAX, usize::MAX);
    // The least cost for the pieces so far of `was` and the first so many of `is`: with the last ones alike, and with them changed.
    let mut row: Vec<[Cost; 2]> = (0..=is.len()).map(|put_in| [nowhere, (put_in, put_in.min(1))]).collect();
    row[0] = [(0, 0), nowhere];
    for (left_out, piece) in was.iter().enumerate() {
        let before = row;
        row = vec![[nowhere, (left_out + 1, 1)]];
        for (at, other) in is.iter().enumerate() {
            let ways = [before[at], before[at + 1], row[at]].map(changed);
            let alike = if piece.text == other.text { before[at][0].min(before[at][1]) } else { nowhere };
            row.push([alike, ways.into_iter().min().unwrap_or(nowhere)]);
        }
    }
    let last = row[is.len()];
    last[0].min(last[1]).1
}

/// The cost after one more changed piece.
fn changed([alike, changed]: [Cost; 2]) -> Cost {
    let begun = (alike.0.saturating_add(1), alike.1.saturating_add(1));
    let gone_on = (changed.0.saturating_add(1), changed.1);
    begun.min(gone_on)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_runs_of_changed_pieces() {
        for (was, is, places) in [
            ("a = b", "a = b", 0),
            ("a = b", r"a\, =\ b", 0),
            ("a = b + c", "a = b - c", 1),
            ("a = b + c", "a = b", 1),
            ("a = b", "a = b + c", 1),
            (r"F = P \cos\theta + I_f", r"F = f \cos\phi + I_f", 2),
            ("(1 + a^2)^{3/2}", "(1 - a^2)^{5/2}", 2),
            ("", "a = b", 1),
            ("x a y b z", "a b", 3),
        ] {
            assert_eq!(places_changed(was, is), places, "{was} and {is}");
            assert_eq!(places_changed(is, was), places, "{is} and {was}");
        }
    }
}
