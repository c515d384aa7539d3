//! What chance would explain of the tables: the computed numbers of a table dealt out to its rows at random.
//!
//! The expectation is counted exactly, from the pairs of a row and a computed number that agree. The distribution is
//! sampled.

use crate::scores::Score;
use crate::{Column, EXPLAINED, Row};
use geneva_kinematics::Mechanism;

/// Which printed numbers may trade places in a shuffle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShuffleScope {
    /// All numbers of a column of a table.
    InTables,
    /// Only the numbers of a column of a table whose rows have the same torque.
    AmongEqualTorques,
}

/// For the printed number of each row, of which rows the computed numbers are within a unit.
type Agreements = Vec<Vec<bool>>;

/// Cells of these mechanisms' peaks, minima and periods within one unit of the last place, if the computed numbers of each
/// column of each table are dealt out at random: how many are to be expected. None if a run came to no end.
pub fn expected_cells(score: &Score, mechanisms: &[Mechanism]) -> Option<f64> {
    Some(columns(score)?.iter().map(|near| expected(near, score.rows, mechanisms)).sum())
}

/// Printed rise times within one unit of these times, if the times of each table are dealt out at random: how many are to
/// be expected.
pub(crate) fn expected_rises(rows: &[Row], times: &[f64]) -> f64 {
    expected(&rises(rows, times), rows, &Mechanism::ALL)
}

/// Each computed number comes to each row of its table equally often.
fn expected(near: &Agreements, rows: &[Row], mechanisms: &[Mechanism]) -> f64 {
    let of = |mechanism: &Mechanism| {
        let own = places(rows, &[*mechanism]);
        let pairs: usize = own.iter().map(|at| own.iter().filter(|of| near[*at][**of]).count()).sum();
        pairs as f64 / own.len() as f64
    };
    mechanisms.iter().map(of).sum()
}

/// How many of these cells each of some shuffles of the computed numbers explains; none if a run came to no end.
pub fn shuffles_of_cells(score: &Score, mechanisms: &[Mechanism], shuffles: usize) -> Option<Vec<usize>> {
    let columns = columns(score)?;
    let own = places(score.rows, mechanisms);
    let mut dealer = Dealer::new(score.rows, ShuffleScope::InTables);
    let mut one = || -> usize { columns.iter().map(|near| explained_by(near, dealer.deal(), &own)).sum() };
    Some((0..shuffles).map(|_| one()).collect())
}

/// How many printed rise times the best of some lists of computed times explains, a time for each row, in each of some
/// shuffles of the printed times.
pub(crate) fn shuffles_of_rises<'a>(
    rows: &[Row],
    times: impl Iterator<Item = &'a [f64]>,
    shuffled: ShuffleScope,
    shuffles: usize,
) -> Vec<usize> {
    let agreements: Vec<Agreements> = times.map(|times| rises(rows, times)).collect();
    let all: Vec<usize> = (0..rows.len()).collect();
    let mut dealer = Dealer::new(rows, shuffled);
    let mut one = || {
        let dealt = dealer.deal();
        agreements.iter().map(|near| explained_by(near, dealt, &all)).max().unwrap_or(0)
    };
    (0..shuffles).map(|_| one()).collect()
}

/// Peaks, minima and periods: which computed numbers are near which printed ones.
fn columns(score: &Score) -> Option<Vec<Agreements>> {
    let of = |(at, column)| {
        let computed = score.results.iter().map(|results| Some(results.as_ref()?[at]));
        Some(near(column, score.rows, &computed.collect::<Option<Vec<_>>>()?))
    };
    EXPLAINED.into_iter().enumerate().map(of).collect()
}

/// Rise times: which computed ones are near which printed ones.
fn rises(rows: &[Row], times: &[f64]) -> Agreements {
    near(Column::Rise, rows, times)
}

fn near(column: Column, rows: &[Row], computed: &[f64]) -> Agreements {
    let of = |row: &Row| computed.iter().map(|computed| column.is_within_one(row.number(column), *computed)).collect();
    rows.iter().map(of).collect()
}

/// How many of these rows have a computed number near the printed one, if each has the number of the row dealt to it.
fn explained_by(near: &Agreements, dealt: &[usize], own: &[usize]) -> usize {
    own.iter().filter(|at| near[**at][dealt[**at]]).count()
}

/// The places of the rows of these mechanisms among all rows.
fn places(rows: &[Row], mechanisms: &[Mechanism]) -> Vec<usize> {
    (0..rows.len()).filter(|at| mechanisms.contains(&rows[*at].mechanism)).collect()
}

/// Deals out rows at random, always in the same sequence.
struct Dealer {
    /// Marsaglia's xorshift.
    state: u64,
    /// Rows that may trade places.
    hands: Vec<Vec<usize>>,
    dealt: Vec<usize>,
}

impl Dealer {
    /// A dealer of these rows, of which only some may trade places.
    fn new(rows: &[Row], shuffled: ShuffleScope) -> Self {
        let mut hands: Vec<Vec<usize>> = Vec::new();
        for (at, row) in rows.iter().enumerate() {
            let alike = |hand: &&mut Vec<usize>| {
                let other = &rows[hand[0]];
                let torque = || other.printed(Column::Torque) == row.printed(Column::Torque);
                other.mechanism == row.mechanism && (shuffled == ShuffleScope::InTables || torque())
            };
            match hands.iter_mut().find(alike) {
                Some(hand) => hand.push(at),
                None => hands.push(vec![at]),
            }
        }
        Self { state: 1973, hands, dealt: (0..rows.len()).collect() }
    }

    /// The next deal: for each row the row whose number it gets.
    fn deal(&mut self) -> &[usize] {
        for hand in &self.hands {
            for last in (1..hand.len()).rev() {
                self.state ^= self.state << 13;
                self.state ^= self.state >> 7;
                self.state ^= self.state << 17;
                let other = ((u128::from(self.state) * (last as u128 + 1)) >> 64) as usize;
                self.dealt.swap(hand[last], hand[other]);
            }
        }
        &self.dealt
    }
}
