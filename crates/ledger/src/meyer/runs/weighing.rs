//! By how much one hypothesis makes the tables likelier than others, and whether that depends on how the errors are taken.

use super::*;
use geneva_dynamics::likelihood::{LEAST_SPREAD, Law};

/// How the errors of the printed numbers are taken, and which rows count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weighing {
    /// Whether the errors of a column have a spread of their own in each table, or one in all three.
    pub by_table: bool,
    /// The least spread, in units of the last printed place.
    pub least_spread: f64,
    /// Of the rows with one mechanism and one friction the one that counts, from the weakest spring on; none if all do.
    ///
    /// If there are not so many rows, the last one counts.
    pub only: Option<usize>,
}

impl Weighing {
    /// One spread for each column.
    pub const BY_COLUMN: Self = Self { by_table: false, least_spread: LEAST_SPREAD, only: None };

    /// A spread for each column of each table.
    pub const BY_TABLE: Self = Self { by_table: true, ..Self::BY_COLUMN };

    /// A spread for each column of each table, none below half a unit, which is what the rounding of a number hides.
    pub const COARSE: Self = Self { least_spread: 0.5, ..Self::BY_TABLE };

    /// The coarse weighing with one row for each mechanism and friction: the weakest spring's, the next one's and so on.
    ///
    /// Rows with one mechanism and one friction follow from each other by the law of similarity, so their errors are not
    /// independent of each other.
    pub fn one_row_of_each() -> impl Iterator<Item = Self> {
        let most = series().map(<[Row]>::len).max().unwrap_or(0);
        (0..most).map(|only| Self { only: Some(only), ..Self::COARSE })
    }

    /// The logarithm of the likelihood of the tables under a hypothesis, each spread as it suits the hypothesis best.
    ///
    /// Negative infinity if a run came to no end.
    pub fn log_likelihood(&self, score: &Score, law: Law) -> f64 {
        let of = |units: Option<Vec<f64>>| {
            let units = units?;
            let best = law.of(&units);
            // The likelihood falls to either side of the best spread.
            Some(if best.spread < self.least_spread { law.log_likelihood(&units, self.least_spread) } else { best.log })
        };
        self.errors(score).map(of).sum::<Option<f64>>().unwrap_or(f64::NEG_INFINITY)
    }

    /// By how much the logarithm for one hypothesis is above the greatest for any of the compared ones that `others`
    /// accepts.
    pub fn margin(&self, one: &Score, law: Law, others: impl Fn(&Hypothesis) -> bool) -> f64 {
        let own = self.log_likelihood(one, law);
        let others = scores().iter().filter(|other| others(&other.hypothesis));
        others.map(|other| own - self.log_likelihood(other, law)).fold(f64::INFINITY, f64::min)
    }

    /// The errors that have one spread, in units of the last printed place; none if a run came to no end.
    fn errors(&self, score: &Score) -> impl Iterator<Item = Option<Vec<f64>>> {
        let (only, mut runs) = (self.only, score.runs.iter());
        let mut counting = Vec::new();
        for own in series() {
            let chosen = only.map(|only| only.min(own.len() - 1));
            let of_rows = own.iter().zip(runs.by_ref()).enumerate();
            counting.extend(of_rows.filter(|(at, _)| chosen.is_none_or(|only| only == *at)).map(|(_, of)| of));
        }
        let tables: Vec<&[Mechanism]> =
            if self.by_table { Mechanism::ALL.chunks(1).collect() } else { vec![&Mechanism::ALL] };
        let together = tables.into_iter().flat_map(|table| EXPLAINED.map(|column| (table, column)));
        let of = move |(table, column): (&[Mechanism], Column)| {
            let off = |(row, run): &(&Row, &Option<Run>)| {
                Some((row.number(column) - run.as_ref()?.number(column)).abs() / column.unit())
            };
            counting.iter().filter(|(row, _)| table.contains(&row.mechanism)).map(off).collect()
        };
        together.map(of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: Weighing = Weighing::BY_COLUMN;

    /// The chance that an error with this spread is rounded to a number so many units away: its density summed by
    /// Simpson's rule, from the lower end of the unit to the upper one.
    fn chance(law: Law, off: f64, spread: f64) -> f64 {
        let density = |error: f64| match law {
            Law::Normal => libm::exp(-error * error / (2.0 * spread * spread)) / (spread * (2.0 * PI).sqrt()),
            Law::Exponential => libm::exp(-error.abs() / spread) / (2.0 * spread),
        };
        let simpson = |low: f64, high: f64| {
            let halves = (8.0 / spread).clamp(4.0, 600.0).ceil();
            let step = (high - low) / (2.0 * halves);
            let inner = (1..2 * halves as u32).map(|k| {
                let weight = if k % 2 == 1 { 4.0 } else { 2.0 };
                weight * density(low + step * f64::from(k))
            });
            step / 3.0 * (density(low) + inner.sum::<f64>() + density(high))
        };
        let (low, high) = (off - 0.5, off + 0.5);
        // The exponential density has an edge at zero.
        if low < 0.0 { simpson(low, 0.0) + simpson(0.0, high) } else { simpson(low, high) }
    }

    /// The greatest logarithm of the likelihood of some errors over all spreads, sought by ever smaller steps up and down.
    fn greatest(law: Law, units: &[f64], least: f64) -> f64 {
        let at = |spread: f64| units.iter().map(|off| libm::log(chance(law, *off, spread))).sum::<f64>();
        let first: f64 = units.iter().sum::<f64>() / units.len() as f64 + 0.1;
        let (mut spread, mut factor) = (first.max(least), 2.0);
        let mut best = at(spread);
        while factor > 1.01 {
            let next = [spread * factor, (spread / factor).max(least)].map(|spread| (at(spread), spread));
            match next.into_iter().find(|(log, _)| *log > best) {
                Some((log, better)) => (best, spread) = (log, better),
                None => factor = factor.sqrt(),
            }
        }
        best
    }

    #[test]
    fn the_likelihoods_are_those_of_the_densities_summed_directly() {
        for score in scores().iter().skip(1).step_by(2) {
            for weighing in
                [ALL, Weighing { by_table: true, ..ALL }, Weighing { least_spread: 0.5, only: Some(1), ..ALL }]
            {
                for law in Law::ALL {
                    let errors = weighing.errors(score).map(|units| units.expect("runs"));
                    let summed: f64 = errors.map(|units| greatest(law, &units, weighing.least_spread)).sum();
                    let found = weighing.log_likelihood(score, law);
                    assert!((found - summed).abs() < 0.02, "{weighing:?} {law:?}: {found} {summed}");
                }
            }
        }
    }

    #[test]
    fn with_one_spread_for_a_column_it_is_the_likelihood_of_the_score() {
        for score in scores() {
            let own = Law::ALL.map(|law| ALL.log_likelihood(score, law));
            assert!(own.iter().zip(score.likelihoods()).all(|(own, of_score)| (own - of_score).abs() < 1e-9));
        }
    }

    #[test]
    fn a_run_without_end_makes_the_tables_impossible_and_one_row_of_each_friction_can_count() {
        let mut score = scores()[0].clone();
        let counts = |weighing: &Weighing, score: &Score| {
            weighing.errors(score).map(|of| of.map(|of| of.len())).collect::<Vec<_>>()
        };
        assert_eq!(counts(&ALL, &score), [Some(49); 3]);
        assert_eq!(counts(&Weighing { only: Some(4), ..ALL }, &score), [Some(series().count()); 3]);
        assert_eq!(counts(&Weighing { by_table: true, only: Some(0), ..ALL }, &score), [Some(4); 9]);
        score.runs[3] = None;
        assert_eq!(ALL.log_likelihood(&score, Law::Normal), f64::NEG_INFINITY);
        assert!(Weighing { only: Some(0), ..ALL }.log_likelihood(&score, Law::Normal).is_finite());
    }
}
