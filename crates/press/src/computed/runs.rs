//! The comparison of the runs: how many cells are reproduced, how likely the tables are, and what chance would give.

use super::Number;
use crate::lookup::judged;
use crate::numbers::fixed;
use crate::rows::score;
use anyhow::Context;
use geneva_dynamics::likelihood::Law;
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::rise_times::{
    Group, OF_A_PART, Tried, explained, groups, with_more_friction, with_more_torque,
};
use geneva_ledger::meyer::runs::{
    Column, EXPLAINED, Fit, Hypothesis, Reading, Row, Run, Score, delays, interval, rows, scores,
};
use geneva_ledger::meyer::terms::MISSING;
use geneva_ledger::{Decimal, Judged, Verdict};

/// The numbers of the chapter on the runs.
pub const NUMBERS: &[(&str, Number)] = &[
    ("runs.four", || Ok((rows().len() - others().count()).to_string())),
    ("runs.minima", || within(best()?, Column::Minimum)),
    ("runs.periods", || within(best()?, Column::Period)),
    ("runs.peaks", || within(best()?, Column::Peak)),
    ("runs.peaks-lagged", || within(lagged(0.1)?, Column::Peak)),
    ("runs.exact", || Ok(exact(score(&Hypothesis::as_run())?).to_string())),
    ("runs.exact.mechanisms", || Ok(exact(score(&Hypothesis::IDEAL)?).to_string())),
    ("runs.others", || Ok((EXPLAINED.len() * others().count()).to_string())),
    ("runs.others-by-the-mechanisms", || Ok(of_others(score(&Hypothesis::IDEAL)?).to_string())),
    ("runs.others-by-the-program", || Ok(of_others(lagged(0.1)?).to_string())),
    ("runs.by-chance", || Ok(fixed(Mechanism::ALL.map(by_chance).into_iter().sum::<anyhow::Result<f64>>()?, 0))),
    ("runs.others.by-chance", || {
        let others = [Mechanism::SIX_PIN, Mechanism::THREE_PIN];
        Ok(fixed(others.map(by_chance).into_iter().sum::<anyhow::Result<f64>>()?, 0))
    }),
    ("runs.margin", || Ok(fixed(margin()?.floor(), 0))),
    ("runs.margin.odds", || Ok(odds(margin()?))),
    ("runs.margin.coarse", || Ok(fixed(coarse_margin()?.floor(), 0))),
    ("runs.sampled", || Ok(fixed(sampled()?[0], 0))),
    ("runs.sampled.exponential", || Ok(fixed(sampled()?[1], 0))),
    ("runs.sampled.odds", || Ok(odds(sampled()?[0]))),
    ("runs.least-spread", || Ok(format!("{:.2}", least_spread()))),
    ("runs.spreads", || {
        let [peak, minimum, period] = best()?.fits.each_ref().map(|fit| format!("{:.2}", fit.likelihoods[0].spread));
        Ok(format!("{peak}, {minimum} and {period}"))
    }),
    ("runs.fifth", || Ok(fixed(against_a_fifth()?.floor(), 0))),
    ("runs.lag.normal", || Ok(fixed(for_the_lag()?[0], 1))),
    ("runs.lag.exponential", || Ok(fixed(for_the_lag()?[1], 1))),
    ("runs.torques", || found("torque", Verdict::Reproduced)),
    ("runs.frictions", || found("friction", Verdict::Reproduced)),
    ("runs.frictions.read", || found("friction", Verdict::ReadOff)),
    ("runs.frictions.most-off", || {
        let off = |judged: &&Judged| Some((judged.computed? - judged.printed_number()?).abs());
        Ok(fixed(data("friction")?.iter().filter_map(off).fold(0.0, f64::max), 3))
    }),
    ("rise.tried", || Ok(explained().len().to_string())),
    ("rise.most", || Ok(most_explained(|_| true).to_string())),
    ("rise.most.own-part", || Ok(most_explained(|tried| tried.part == Some(MISSING)).to_string())),
    ("rise.chance", || Ok(fixed(explained().iter().map(|tried| tried.as_run.by_chance).fold(0.0, f64::max), 0))),
    ("rise.profile", || own_meaning(0)),
    ("rise.average", || own_meaning(1)),
    ("rise.torque.pairs", || Ok(with_more_torque().pairs.to_string())),
    ("rise.torque.up", || Ok(with_more_torque().up.to_string())),
    ("rise.torque.equal", || Ok(with_more_torque().equal.to_string())),
    ("rise.friction.pairs", || Ok(with_more_friction().pairs.to_string())),
    ("rise.friction.up", || Ok(with_more_friction().up.to_string())),
    ("rise.friction.equal", || Ok(with_more_friction().equal.to_string())),
    ("runs.to-one-unit", || {
        let only_to_a_unit = |row: &&Row| -> anyhow::Result<usize> {
            let mut count = 0;
            for column in ["max", "min", "period"] {
                let judged = judged(&format!("meyer.app-e.{}.{column}", row.slug()))?;
                let exact = judged.claim.printed.parse::<Decimal>().ok().zip(judged.computed);
                let rounds = exact.is_some_and(|(printed, computed)| printed.is_rounding_of(computed));
                count += usize::from(judged.verdict == Verdict::ReproducedInError && !rounds);
            }
            Ok(count)
        };
        Ok(rows().iter().map(|row| only_to_a_unit(&row)).sum::<anyhow::Result<usize>>()?.to_string())
    }),
    ("runs.in-error", || {
        let all = rows().iter().flat_map(|row| ["max", "min", "period"].map(|column| (row, column)));
        let verdicts = all.map(|(row, column)| Ok(judged(&format!("meyer.app-e.{}.{column}", row.slug()))?.verdict));
        let verdicts = verdicts.collect::<anyhow::Result<Vec<_>>>()?;
        Ok(verdicts.iter().filter(|verdict| **verdict == Verdict::ReproducedInError).count().to_string())
    }),
    ("rise.groups", || Ok(groups().len().to_string())),
    ("rise.groups.without", || Ok(groups().iter().filter(|group| !group.possible).count().to_string())),
    ("rise.groups.but-for-one", || Ok(groups().iter().filter(|group| bears_one_number(group)).count().to_string())),
];

/// The most rows that any of these definitions explains, as run or for the mechanism.
fn most_explained(wanted: fn(&Tried) -> bool) -> usize {
    let own = explained().iter().filter(|tried| wanted(tried));
    own.map(|tried| tried.as_run.rows().max(tried.ideal.rows())).max().unwrap_or(0)
}

/// How many rows a reading of the thesis's own definition explains, as run.
fn own_meaning(reading: usize) -> anyhow::Result<String> {
    let is_it = |tried: &&Tried| tried.name == OF_A_PART[reading].name && tried.part == Some(MISSING);
    let tried = explained().iter().find(is_it).context("a definition that was not tried")?;
    Ok(tried.as_run.rows().to_string())
}

/// How many rows have this verdict on a value.
fn found(value: &str, verdict: Verdict) -> anyhow::Result<String> {
    Ok(data(value)?.iter().filter(|judged| judged.verdict == verdict).count().to_string())
}

/// The verdicts on a value in all rows.
fn data(value: &str) -> anyhow::Result<Vec<&'static Judged>> {
    rows().iter().map(|row| judged(&format!("meyer.app-e.{}.{value}", row.slug()))).collect()
}

/// How many cells a hypothesis gives to the printed digit.
fn exact(score: &Score) -> usize {
    score.fits.iter().map(|fit| fit.exact).sum()
}

/// The reset after a quarter of a turn, the inertias of Fig. 11, printed peaks.
fn best() -> anyhow::Result<&'static Score> {
    score(&Hypothesis::WITHOUT_LAG)
}

/// The program as listed with its sign late by this part of a print interval.
fn lagged(part: f64) -> anyhow::Result<&'static Score> {
    let found = delays().iter().find(|(delay, _)| (delay / interval() - part).abs() < 1e-9);
    found.map(|(_, score)| score).context("a delay that was not tried")
}

fn within(score: &Score, column: Column) -> anyhow::Result<String> {
    Ok(score.on(column).context("a column that is not explained")?.within_one.to_string())
}

/// The rows of six and three pins.
fn others() -> impl Iterator<Item = &'static Row> {
    rows().iter().filter(|row| row.mechanism != Mechanism::FOUR_PIN)
}

/// Cells of six and three pins that are within one unit.
fn of_others(score: &Score) -> usize {
    let near = |(row, run): (&Row, &Option<Run>)| {
        let near =
            |column: &Column| run.is_some_and(|run| column.is_within_one(row.number(*column), run.number(*column)));
        EXPLAINED.iter().filter(|column| near(column)).count()
    };
    let all = rows().iter().zip(&score.runs).filter(|(row, _)| row.mechanism != Mechanism::FOUR_PIN);
    all.map(near).sum()
}

/// How many cells of a table would be within one unit if the computed numbers of each of its columns were dealt out to its
/// rows at random: the expectation.
fn by_chance(mechanism: Mechanism) -> anyhow::Result<f64> {
    let score = lagged(0.1)?;
    let own: Vec<_> = rows().iter().zip(&score.runs).filter(|(row, _)| row.mechanism == mechanism).collect();
    let mut pairs = 0_u32;
    for (row, _) in &own {
        for (_, run) in &own {
            let run = run.as_ref().context("a run of the program comes to no end")?;
            let near = |column: &&Column| column.is_within_one(row.number(**column), run.number(**column));
            pairs += EXPLAINED.iter().filter(near).count() as u32;
        }
    }
    Ok(f64::from(pairs) / own.len() as f64)
}

/// By how much ln L of the best combination is above that of any with another reset angle or other inertias, by the law of
/// error that is kinder to the others.
fn margin() -> anyhow::Result<f64> {
    let best = best()?;
    let others = scores().iter().filter(|other| is_another_combination(other, best));
    let margins = others.flat_map(|other| above(best, other));
    Ok(margins.fold(f64::INFINITY, f64::min))
}

/// The margin of the best combination if no error may spread by less than half a unit.
fn coarse_margin() -> anyhow::Result<f64> {
    const COARSE: f64 = 0.5;
    let log = |score: &Score, law: usize| {
        let of_column = |(column, fit): (Column, &Fit)| {
            let off = |(row, run): (&Row, &Option<Run>)| {
                Some((row.number(column) - run.as_ref()?.number(column)).abs() / column.unit())
            };
            let units: Option<Vec<f64>> = rows().iter().zip(&score.runs).map(off).collect();
            // The likelihood falls to either side of the spread that suits best.
            Some(Law::ALL[law].log_likelihood(&units?, fit.likelihoods[law].spread.max(COARSE)))
        };
        EXPLAINED.into_iter().zip(&score.fits).map(of_column).sum::<Option<f64>>()
    };
    let best = best()?;
    let mut least = f64::INFINITY;
    for other in scores().iter().filter(|other| is_another_combination(other, best)) {
        for law in [0, 1] {
            let of = |score| log(score, law).context("a run of the program comes to no end");
            least = least.min(of(best)? - of(other)?);
        }
    }
    Ok(least)
}

/// Whether reset angle or inertias differ.
fn is_another_combination(one: &Score, other: &Score) -> bool {
    let [one, other] = [one, other].map(|score| (score.hypothesis.reset, score.hypothesis.six_pin));
    one != other
}

/// By how much ln L of one is above that of another, by either law.
fn above(one: &Score, other: &Score) -> [f64; 2] {
    let [a, b] = [one.likelihoods(), other.likelihoods()];
    [a[0] - b[0], a[1] - b[1]]
}

/// By how much ln L is greater if the peaks were read off the print-out.
fn sampled() -> anyhow::Result<[f64; 2]> {
    Ok(above(best()?, score(&Hypothesis { reading: Reading::True, ..Hypothesis::WITHOUT_LAG })?))
}

/// By how much ln L is greater with the lag that the thesis gives than with the best of a fifth of an interval or more.
fn against_a_fifth() -> anyhow::Result<f64> {
    let listed = lagged(0.1)?;
    let later = delays().iter().filter(|(delay, _)| *delay > 0.19 * interval());
    Ok(later.flat_map(|(_, score)| above(listed, score)).fold(f64::INFINITY, f64::min))
}

/// By how much ln L differs between the lag that the thesis gives and none: against it by the normal law, for it by the
/// other.
fn for_the_lag() -> anyhow::Result<[f64; 2]> {
    let [normal, exponential] = above(lagged(0.1)?, lagged(0.0)?);
    Ok([-normal, exponential])
}

/// The smallest of all the spreads that suit a hypothesis best, in units of the last place.
fn least_spread() -> f64 {
    let spreads = |fit: &Fit| fit.likelihoods.map(|likelihood| likelihood.spread);
    scores().iter().flat_map(|score| &score.fits).flat_map(spreads).fold(f64::INFINITY, f64::min)
}

/// How many times as likely, for a difference of ln L: a round number in words, or a power of ten.
fn odds(difference: f64) -> String {
    let decades = difference / std::f64::consts::LN_10;
    match decades {
        _ if decades >= 9.0 => format!("10<sup>{}</sup>", decades.floor()),
        _ if decades >= 6.0 => format!("{:.0} million", difference.exp() / 1e6),
        _ => format!("{:.0}", difference.exp()),
    }
}

/// Whether a group has one number for its rows, if need be without one of them.
fn bears_one_number(group: &Group) -> bool {
    group.possible || !group.misread.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_dynamics::likelihood::LEAST_SPREAD;

    #[test]
    fn chance_explains_a_part_and_the_program_nearly_all() {
        let best = best().expect("compared");
        let chance: f64 = Mechanism::ALL.map(|of| by_chance(of).expect("runs")).iter().sum();
        assert!(3.0 * chance < best.within_one() as f64, "{chance}");
        assert!(of_others(best) + 3 >= EXPLAINED.len() * others().count());
        assert!(3 * of_others(score(&Hypothesis::IDEAL).expect("compared")) < of_others(best));
    }

    #[test]
    fn no_spread_that_is_found_is_at_the_end_of_those_that_are_tried() {
        assert!(least_spread() > 2.0 * LEAST_SPREAD, "{}", least_spread());
        assert!(coarse_margin().expect("compared") < margin().expect("compared"));
    }

    #[test]
    fn odds_are_said_in_the_size_they_have() {
        assert_eq!([7.0, 15.0, 300.0].map(odds), ["1097", "3 million", "10<sup>130</sup>"]);
    }
}
