//! What chance would explain of the tables: the computed numbers of a table dealt out to its rows at random.

use super::rise_times::{Tried, explained};
use super::*;

/// How many cells chance would explain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chance {
    /// Cells within one unit of the last place as the numbers belong.
    pub found: usize,
    /// How many are to be expected if they are dealt out at random.
    pub expected: f64,
}

/// Which printed numbers may trade places in a shuffle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shuffled {
    /// All numbers of a column of a table.
    InTables,
    /// Only the numbers of a column of a table whose rows have the same torque.
    AmongEqualTorques,
}

/// For the printed numbers of a column, which computed numbers are within a unit of each: a bit for each row.
type Near = Vec<u64>;

/// What chance would explain of these mechanisms' peaks, minima and periods, each column of each table for itself; none
/// if a run came to no end.
pub fn of_cells(score: &Score, mechanisms: &[Mechanism]) -> Option<Chance> {
    let columns = columns(score)?;
    let own = rows_of(mechanisms);
    let found = columns.iter().map(|near| own.iter().filter(|at| near[**at] >> **at & 1 == 1).count()).sum();
    // Each computed number comes to each row of its table equally often.
    let expected = |near: &Near| -> f64 {
        let of = |mechanism: &Mechanism| {
            let own = rows_of(&[*mechanism]);
            let pairs: usize = own.iter().map(|at| own.iter().filter(|of| near[*at] >> **of & 1 == 1).count()).sum();
            pairs as f64 / own.len() as f64
        };
        mechanisms.iter().map(of).sum()
    };
    Some(Chance { found, expected: columns.iter().map(expected).sum() })
}

/// How many of these cells each of some shuffles of the computed numbers explains; none if a run came to no end.
pub fn shuffles_of_cells(score: &Score, mechanisms: &[Mechanism], shuffles: usize) -> Option<Vec<usize>> {
    let columns = columns(score)?;
    let own = rows_of(mechanisms);
    let mut dealer = Dealer::new(Shuffled::InTables);
    let mut one = || -> usize { columns.iter().map(|near| explained_by(near, dealer.deal(), &own)).sum() };
    Some((0..shuffles).map(|_| one()).collect())
}

/// How many printed rise times the best of all definitions explains, of the runs or of the mechanisms, in each of some
/// shuffles of the printed times.
pub fn shuffles_of_definitions(shuffled: Shuffled, shuffles: usize) -> Vec<usize> {
    let printed: Vec<f64> = rows().iter().map(|row| row.number(Column::Rise)).collect();
    let both = |tried: &Tried| [&tried.as_run, &tried.ideal].map(|of| near(Column::Rise, &printed, &of.times));
    let definitions: Vec<Near> = explained().iter().flat_map(both).collect();
    let all: Vec<usize> = (0..printed.len()).collect();
    let mut dealer = Dealer::new(shuffled);
    let mut one = || {
        let dealt = dealer.deal();
        definitions.iter().map(|near| explained_by(near, dealt, &all)).max().unwrap_or(0)
    };
    (0..shuffles).map(|_| one()).collect()
}

/// Peaks, minima and periods: which computed numbers are near which printed ones.
fn columns(score: &Score) -> Option<Vec<Near>> {
    let of = |column: Column| {
        let printed: Vec<f64> = rows().iter().map(|row| row.number(column)).collect();
        let computed: Vec<f64> =
            score.runs.iter().map(|run| Some(run.as_ref()?.number(column))).collect::<Option<_>>()?;
        Some(near(column, &printed, &computed))
    };
    EXPLAINED.into_iter().map(of).collect()
}

fn near(column: Column, printed: &[f64], computed: &[f64]) -> Near {
    let bits = |printed: &f64| {
        let is_near = |(at, computed): (usize, &f64)| u64::from(column.is_within_one(*printed, *computed)) << at;
        computed.iter().enumerate().map(is_near).sum()
    };
    printed.iter().map(bits).collect()
}

/// How many of these rows have a computed number near the printed one, if each has the number of the row dealt to it.
fn explained_by(near: &Near, dealt: &[usize], own: &[usize]) -> usize {
    own.iter().map(|at| (near[*at] >> dealt[*at] & 1) as usize).sum()
}

/// The places of the rows of these mechanisms among all rows.
fn rows_of(mechanisms: &[Mechanism]) -> Vec<usize> {
    (0..rows().len()).filter(|at| mechanisms.contains(&rows()[*at].mechanism)).collect()
}

/// Deals out rows at random, the same in every run of the program.
struct Dealer {
    /// Marsaglia's xorshift.
    state: u64,
    /// Rows that may trade places.
    hands: Vec<Vec<usize>>,
    dealt: Vec<usize>,
}

impl Dealer {
    fn new(shuffled: Shuffled) -> Self {
        let mut hands: Vec<Vec<usize>> = Vec::new();
        for (at, row) in rows().iter().enumerate() {
            let alike = |hand: &&mut Vec<usize>| {
                let other = &rows()[hand[0]];
                let torque = || other.printed(Column::Torque) == row.printed(Column::Torque);
                other.mechanism == row.mechanism && (shuffled == Shuffled::InTables || torque())
            };
            match hands.iter_mut().find(alike) {
                Some(hand) => hand.push(at),
                None => hands.push(vec![at]),
            }
        }
        Self { state: 1973, hands, dealt: (0..rows().len()).collect() }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counting_pairs_and_sampling_expect_as_much_of_chance() {
        const SHUFFLES: usize = 4000;
        for (score, mechanisms) in
            scores().iter().flat_map(|score| Mechanism::ALL.map(|mechanism| (score, [mechanism])))
        {
            let chance = of_cells(score, &mechanisms).expect("runs");
            let sampled = shuffles_of_cells(score, &mechanisms, SHUFFLES).expect("runs");
            assert_mean(&sampled, chance.expected);
        }
    }

    #[test]
    fn counting_pairs_and_sampling_expect_as_much_of_each_definition() {
        const SHUFFLES: usize = 1000;
        let printed: Vec<f64> = rows().iter().map(|row| row.number(Column::Rise)).collect();
        let all: Vec<usize> = (0..printed.len()).collect();
        for of in explained().iter().flat_map(|tried| [&tried.as_run, &tried.ideal]) {
            let near = near(Column::Rise, &printed, &of.times);
            let mut dealer = Dealer::new(Shuffled::InTables);
            let sampled: Vec<usize> = (0..SHUFFLES).map(|_| explained_by(&near, dealer.deal(), &all)).collect();
            assert_mean(&sampled, of.by_chance);
        }
    }

    /// Asserts that the mean of some counts is what is expected, but for chance: 4.5 standard errors.
    #[track_caller]
    fn assert_mean(counts: &[usize], expected: f64) {
        let number = counts.len() as f64;
        let mean = counts.iter().sum::<usize>() as f64 / number;
        let square = |count: &usize| (*count as f64 - mean) * (*count as f64 - mean);
        let standard_error = (counts.iter().map(square).sum::<f64>() / number).sqrt() / number.sqrt();
        assert!(
            (mean - expected).abs() <= 4.5 * standard_error + 1e-9,
            "{mean} ± {standard_error}, expected {expected}"
        );
    }

    #[test]
    fn what_is_found_is_what_the_score_counts() {
        for score in scores() {
            assert_eq!(of_cells(score, &Mechanism::ALL).expect("runs").found, score.within_one());
        }
    }

    #[test]
    fn the_best_of_all_definitions_explains_more_by_chance_than_each_of_them_but_less_than_as_it_is() {
        let mean = |counts: &[usize]| counts.iter().sum::<usize>() as f64 / counts.len() as f64;
        let [anywhere, alike] =
            [Shuffled::InTables, Shuffled::AmongEqualTorques].map(|of| shuffles_of_definitions(of, 1000));
        let one = explained().iter().map(|tried| tried.as_run.by_chance).fold(0.0, f64::max);
        // Where the torque is kept, so is what all definitions have in common.
        assert!(one < mean(&anywhere) && mean(&anywhere) < mean(&alike), "{one}");
        let found = explained().iter().map(|tried| tried.as_run.rows().max(tried.ideal.rows())).max();
        assert!(anywhere.iter().chain(&alike).max() < found.as_ref());
    }

    #[test]
    fn a_deal_gives_each_row_one_of_its_hand() {
        for shuffled in [Shuffled::InTables, Shuffled::AmongEqualTorques] {
            let mut dealer = Dealer::new(shuffled);
            for _ in 0..100 {
                let mut dealt = dealer.deal().to_vec();
                for (at, from) in dealt.iter().enumerate() {
                    let [row, other] = [at, *from].map(|at| &rows()[at]);
                    assert_eq!(row.mechanism, other.mechanism);
                    if shuffled == Shuffled::AmongEqualTorques {
                        assert_eq!(row.printed(Column::Torque), other.printed(Column::Torque));
                    }
                }
                dealt.sort_unstable();
                assert_eq!(dealt, (0..rows().len()).collect::<Vec<_>>());
            }
        }
    }
}
