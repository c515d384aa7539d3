//! What chance would explain, by sampling: the second route to `chance`.
//!
//! The numbers of a column are dealt out by giving each a random key and sorting by the keys. The generator is another one
//! than in `chance`.

use crate::{Column, Row, Score};
use geneva_kinematics::Mechanism;

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Some numbers in a random order.
    fn shuffled(&mut self, numbers: &[f64]) -> Vec<f64> {
        let mut keyed: Vec<(u64, f64)> = numbers.iter().map(|number| (self.next(), *number)).collect();
        keyed.sort_by_key(|(key, _)| *key);
        keyed.into_iter().map(|(_, number)| number).collect()
    }
}

/// How many of these mechanisms' peaks, minima and periods are within a unit of the computed ones, in each of some deals of
/// the computed numbers of each column of each table. None if a run came to no end.
pub fn cells(score: &Score, mechanisms: &[Mechanism], deals: usize) -> Option<Vec<usize>> {
    let mut random = Random(1);
    let mut counts = vec![0; deals];
    for mechanism in mechanisms {
        for (at, column) in [Column::Peak, Column::Minimum, Column::Period].into_iter().enumerate() {
            let (mut printed, mut computed) = (Vec::new(), Vec::new());
            for (row, results) in score.rows.iter().zip(&score.results).filter(|(row, _)| row.mechanism == *mechanism) {
                printed.push(row.number(column));
                computed.push((*results)?[at]);
            }
            for count in &mut counts {
                *count += near(column, &printed, &random.shuffled(&computed));
            }
        }
    }
    Some(counts)
}

/// How many printed rise times are within a unit of the computed ones of some definition, whichever explains most, in each of
/// some deals of the printed times of each table, or of those rows of a table only that have the same torque.
pub fn rises(rows: &[Row], definitions: &[&[f64]], with_equal_torques: bool, deals: usize) -> Vec<usize> {
    let mut random = Random(2);
    // The places of the rows that may trade their times.
    let mut hands: Vec<Vec<usize>> = Vec::new();
    for (place, row) in rows.iter().enumerate() {
        let trades =
            |other: &Row| other.mechanism == row.mechanism && (!with_equal_torques || other.torque() == row.torque());
        match hands.iter().position(|hand| trades(&rows[hand[0]])) {
            Some(hand) => hands[hand].push(place),
            None => hands.push(vec![place]),
        }
    }
    let mut deal = || {
        let mut printed = vec![0.0; rows.len()];
        for hand in &hands {
            let own: Vec<f64> = hand.iter().map(|place| rows[*place].number(Column::Rise)).collect();
            for (place, time) in hand.iter().zip(random.shuffled(&own)) {
                printed[*place] = time;
            }
        }
        definitions.iter().map(|times| near(Column::Rise, &printed, times)).max().unwrap_or(0)
    };
    (0..deals).map(|_| deal()).collect()
}

/// How many of some numbers are within a unit of the last printed place of the others, one by one.
fn near(column: Column, printed: &[f64], computed: &[f64]) -> usize {
    let units = printed.iter().zip(computed).map(|(printed, computed)| ((printed - computed) / column.unit()).abs());
    units.filter(|units| *units <= 1.0 + 1e-9).count()
}
