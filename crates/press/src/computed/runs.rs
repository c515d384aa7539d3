//! The comparison of the runs: how many cells are reproduced, how likely the tables are, and what chance would give.

use super::{Number, least, most};
use crate::lookup::judged;
use crate::numbers::fixed;
use crate::rows::score;
use anyhow::Context;
use geneva_case1973::chance::{self, Shuffled};
use geneva_case1973::choice::rows_of;
use geneva_case1973::fitted::Freed;
use geneva_case1973::likelihood::Law;
use geneva_case1973::rise_times::{with_more_friction, with_more_torque};
use geneva_case1973::weighing::{Others, margins, margins_by_one_row_of_each};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::rise_times::{Group, OF_A_PART, Tried, explained, groups};
use geneva_ledger::meyer::runs::{
    Column, EXPLAINED, Fit, Hypothesis, Reset, Row, Score, Weighing, delays, interval, rows, scores, series,
};
use geneva_ledger::meyer::terms::MISSING;
use geneva_ledger::{Decimal, Judged, Verdict};
use std::sync::OnceLock;

/// The numbers of the chapter on the runs.
pub const NUMBERS: &[(&str, Number)] = &[
    ("runs.four", || Ok((rows().len() - others().count()).to_string())),
    ("runs.minima", || within(best()?, Column::Minimum)),
    ("runs.periods", || within(best()?, Column::Period)),
    ("runs.peaks", || within(best()?, Column::Peak)),
    ("runs.peaks-lagged", || within(lagged(0.1)?, Column::Peak)),
    ("runs.exact", || Ok(exact(score(&Hypothesis::AS_RUN)?).to_string())),
    ("runs.exact.mechanisms", || Ok(exact(score(&Hypothesis::IDEAL)?).to_string())),
    ("runs.others", || Ok((EXPLAINED.len() * others().count()).to_string())),
    ("runs.others-by-the-mechanisms", || Ok(score(&Hypothesis::IDEAL)?.within_one_of(&OTHERS).to_string())),
    ("runs.others-by-the-program", || Ok(lagged(0.1)?.within_one_of(&OTHERS).to_string())),
    ("runs.by-chance", || expected(&Hypothesis::AS_RUN, &Mechanism::ALL)),
    ("runs.others.by-chance", || expected(&Hypothesis::AS_RUN, &OTHERS)),
    ("runs.others.by-chance.mechanisms", || expected(&Hypothesis::IDEAL, &OTHERS)),
    ("runs.others.as-many", || Ok(format!("{}&nbsp;%", fixed(100.0 * as_many_by_chance()?, 0)))),
    ("runs.groups", || Ok(series().count().to_string())),
    ("runs.reset", || Ok(fixed(weakest(Others::AnotherReset)?.floor(), 0))),
    ("runs.reset.one-row", || Ok(fixed(with_one_row_of_each(Others::AnotherReset)?.floor(), 0))),
    ("runs.margin", || Ok(fixed(weakest(Others::AnotherResetOrInertias)?.floor(), 0))),
    ("runs.margin.one-row", || Ok(fixed(with_one_row_of_each(Others::AnotherResetOrInertias)?.floor(), 0))),
    ("runs.margin.one-row.odds", || Ok(odds(with_one_row_of_each(Others::AnotherResetOrInertias)?))),
    ("runs.sampled", || Ok(fixed(weakest(Others::TruePeaks)?, 0))),
    ("runs.sampled.odds", || Ok(odds(weakest(Others::TruePeaks)?))),
    ("runs.sampled.most", || Ok(fixed(most(&margins(scores(), Others::TruePeaks).context(NOT_COMPARED)?), 0))),
    ("freed.six", || Ok(freed(Reset::OfTheMechanism, Mechanism::SIX_PIN)?.within_one().to_string())),
    ("freed.three", || Ok(freed(Reset::OfTheMechanism, Mechanism::THREE_PIN)?.within_one().to_string())),
    ("freed.six.quarter", || Ok(freed(Reset::QuarterTurn, Mechanism::SIX_PIN)?.within_one().to_string())),
    ("freed.three.quarter", || Ok(freed(Reset::QuarterTurn, Mechanism::THREE_PIN)?.within_one().to_string())),
    ("freed.six.less-friction", || less_friction(Mechanism::SIX_PIN)),
    ("freed.three.less-friction", || less_friction(Mechanism::THREE_PIN)),
    ("runs.least-spread", || Ok(format!("{:.2}", least_spread()))),
    ("runs.spreads", || {
        let [peak, minimum, period] = best()?.fits.each_ref().map(|fit| format!("{:.2}", fit.likelihoods[0].spread));
        Ok(format!("{peak}, {minimum} and {period}"))
    }),
    ("runs.fifth", || Ok(fixed(against_a_fifth()?.floor(), 0))),
    ("runs.lag.normal", || Ok(fixed(for_the_lag()?[0], 1))),
    ("runs.lag.exponential", || Ok(fixed(for_the_lag()?[1], 1))),
    ("runs.lag.by-table", || {
        let [with, without] = [lagged(0.1)?, lagged(0.0)?];
        let margin =
            |law| Weighing::BY_TABLE.log_likelihood(with, law) - Weighing::BY_TABLE.log_likelihood(without, law);
        Ok(fixed(least(&Law::ALL.map(margin)), 1))
    }),
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
    ("rise.by-chance.most", || greatest(by_chance(Shuffled::InTables))),
    ("rise.by-chance.usual", || usual(by_chance(Shuffled::InTables))),
    ("rise.by-chance.equal-torques", || usual(by_chance(Shuffled::AmongEqualTorques))),
    ("rise.by-chance.equal-torques.most", || greatest(by_chance(Shuffled::AmongEqualTorques))),
    ("rise.profile", || own_meaning(0)),
    ("rise.average", || own_meaning(1)),
    ("rise.torque.pairs", || Ok(with_more_torque(rows()).pairs.to_string())),
    ("rise.torque.up", || Ok(with_more_torque(rows()).up.to_string())),
    ("rise.torque.equal", || Ok(with_more_torque(rows()).equal.to_string())),
    ("rise.friction.pairs", || Ok(with_more_friction(rows()).pairs.to_string())),
    ("rise.friction.up", || Ok(with_more_friction(rows()).up.to_string())),
    ("rise.friction.equal", || Ok(with_more_friction(rows()).equal.to_string())),
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
fn best() -> anyhow::Result<&'static Score<'static>> {
    score(&Hypothesis::WITHOUT_LAG)
}

/// The program as listed with its sign late by this part of a print interval.
fn lagged(part: f64) -> anyhow::Result<&'static Score<'static>> {
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

/// How many cells of these mechanisms chance would give with a hypothesis's numbers: the expectation.
fn expected(hypothesis: &Hypothesis, mechanisms: &[Mechanism]) -> anyhow::Result<String> {
    Ok(fixed(chance::expected_cells(score(hypothesis)?, mechanisms).context(NO_END)?, 0))
}

/// The part of all shuffles of the mechanisms' own numbers with six and three pins that gives as many cells as they do.
fn as_many_by_chance() -> anyhow::Result<f64> {
    let ideal = score(&Hypothesis::IDEAL)?;
    let found = ideal.within_one_of(&OTHERS);
    let counts = chance::shuffles_of_cells(ideal, &OTHERS, SHUFFLES).context(NO_END)?;
    Ok(counts.iter().filter(|count| **count >= found).count() as f64 / SHUFFLES as f64)
}

const NO_END: &str = "a run of the program comes to no end";

/// Shuffles that stand for all.
pub const SHUFFLES: usize = 10_000;

/// How many rows the best definition of a rise time explains in each shuffle of the printed times.
fn by_chance(shuffled: Shuffled) -> &'static [usize] {
    static COUNTS: [OnceLock<Vec<usize>>; 2] = [const { OnceLock::new() }; 2];
    let own = usize::from(shuffled == Shuffled::AmongEqualTorques);
    COUNTS[own].get_or_init(|| chance::shuffles_of_definitions(rows(), explained(), shuffled, SHUFFLES))
}

fn greatest(counts: &[usize]) -> anyhow::Result<String> {
    Ok(counts.iter().max().context("no shuffles")?.to_string())
}

/// The count in the middle of all.
fn usual(counts: &[usize]) -> anyhow::Result<String> {
    let mut sorted = counts.to_vec();
    sorted.sort_unstable();
    Ok(sorted.get(sorted.len() / 2).context("no shuffles")?.to_string())
}

fn weakest(others: Others) -> anyhow::Result<f64> {
    Ok(least(&margins(scores(), others).context(NOT_COMPARED)?))
}

/// The weakest margin, by either law, if only one row for each mechanism and friction counts.
fn with_one_row_of_each(others: Others) -> anyhow::Result<f64> {
    Ok(least(&margins_by_one_row_of_each(scores(), others).context(NOT_COMPARED)?))
}

const NOT_COMPARED: &str = "a hypothesis that was not compared";

/// A table with the inertias that fit it best.
fn freed(reset: Reset, mechanism: Mechanism) -> anyhow::Result<Freed> {
    Freed::inertias(rows_of(rows(), mechanism), reset).context(NO_MOTION)
}

/// How many results of a table the right reset gives with the best inertias and a hundredth of the printed frictions.
fn less_friction(mechanism: Mechanism) -> anyhow::Result<String> {
    let freed = Freed::with_friction(rows_of(rows(), mechanism), Reset::OfTheMechanism, 0.01).context(NO_MOTION)?;
    Ok(freed.within_one().to_string())
}

const NO_MOTION: &str = "no inertias give a table a motion";

/// The mechanisms for which the program's reset is wrong.
const OTHERS: [Mechanism; 2] = [Mechanism::SIX_PIN, Mechanism::THREE_PIN];

/// By how much ln L of one is above that of another, by either law.
fn above(one: &Score, other: &Score) -> [f64; 2] {
    let [a, b] = [one.likelihoods(), other.likelihoods()];
    [a[0] - b[0], a[1] - b[1]]
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

/// How many times as likely, for a difference of ln L: in words to two digits, or a power of ten.
fn odds(difference: f64) -> String {
    let decades = difference / std::f64::consts::LN_10;
    match decades {
        _ if decades >= 9.0 => format!("10<sup>{}</sup>", decades.floor()),
        _ if decades >= 6.0 => format!("{:.0} million", difference.exp() / 1e6),
        _ => {
            let unit = libm::pow(10.0, (decades.floor() - 1.0).max(0.0));
            format!("{:.0}", (difference.exp() / unit).round() * unit)
        }
    }
}

/// Whether a group has one number for its rows, if need be without one of them.
fn bears_one_number(group: &Group) -> bool {
    group.possible || !group.misread.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_case1973::likelihood::LEAST_SPREAD;

    #[test]
    fn chance_explains_a_part_and_the_program_nearly_all() {
        let best = best().expect("compared");
        let chance = chance::expected_cells(best, &Mechanism::ALL).expect("runs");
        assert!(3.0 * chance < best.within_one() as f64, "{chance}");
        assert!(best.within_one_of(&OTHERS) + 3 >= EXPLAINED.len() * others().count());
        let by_the_mechanisms = score(&Hypothesis::IDEAL).expect("compared").within_one_of(&OTHERS);
        assert!(3 * by_the_mechanisms < best.within_one_of(&OTHERS));
    }

    #[test]
    fn no_spread_that_is_found_is_at_the_end_of_those_that_are_tried() {
        assert!(least_spread() > 2.0 * LEAST_SPREAD, "{}", least_spread());
    }

    #[test]
    fn the_margins_shrink_with_milder_weighings_but_decide_with_each() {
        for others in [Others::AnotherReset, Others::AnotherResetOrInertias] {
            let [columns, tables, coarse] = [Weighing::BY_COLUMN, Weighing::BY_TABLE, Weighing::COARSE]
                .map(|weighing| least(&Law::ALL.map(|law| weighing.margin(scores(), law, others).expect("compared"))));
            let one_row = with_one_row_of_each(others).expect("compared");
            assert!(columns > tables && tables > coarse && coarse > one_row, "{columns} {tables} {coarse} {one_row}");
            assert!(one_row > 20.0, "{one_row}");
        }
        // Whether the peaks are true or printed is decided by all rows only.
        assert!(weakest(Others::TruePeaks).expect("compared") > 5.0);
        assert!(with_one_row_of_each(Others::TruePeaks).expect("compared") < 0.0);
    }

    #[test]
    fn odds_are_said_in_the_size_they_have() {
        assert_eq!([7.0, 15.0, 300.0].map(odds), ["1100", "3 million", "10<sup>130</sup>"]);
    }
}
