//! The comparison of the runs: how many cells are reproduced, how likely the tables are, and what chance would give.

use super::{Number, most};
use crate::lookup::judged;
use crate::numbers::{fixed, significant};
use crate::rows::score;
use anyhow::Context;
use geneva_ask::number_format::no_greater;
use geneva_case1973::chance::ShuffleScope;
use geneva_case1973::fitted::InertiaFit;
use geneva_case1973::rise_times::{DefinitionTrial, OF_A_PART, TorqueGroup, groups};
use geneva_case1973::weighing::{Others, margins};
use geneva_case1973::{
    Column, ColumnFit, EXPLAINED, Hypothesis, Reset, Row, Score, Trend, pairs_by_friction, pairs_by_torque, rows_of,
    series,
};
use geneva_documents::meyer::runs::statistics::{LITTLE, shuffled, statistic};
use geneva_documents::meyer::runs::study::{explained, scores};
use geneva_documents::meyer::runs::table::rows;
use geneva_documents::meyer::terms::MISSING;
use geneva_evidence::{Decimal, Judged, Verdict, numbers_in};
use geneva_kinematics::Mechanism;

/// The numbers of the chapter on the runs.
pub const NUMBERS: &[(&str, Number)] = &[
    ("runs.four", || Ok((rows().len() - others().count()).to_string())),
    ("runs.minima", || rounded("runs.minima")),
    ("runs.periods", || rounded("runs.periods")),
    ("runs.peaks", || rounded("runs.peaks")),
    ("runs.peaks-lagged", || rounded("runs.peaks-lagged")),
    ("runs.exact", || rounded("runs.exact")),
    ("runs.exact.mechanisms", || rounded("runs.exact.mechanisms")),
    ("runs.others", || Ok((EXPLAINED.len() * others().count()).to_string())),
    ("runs.others-by-the-mechanisms", || rounded("runs.others-by-the-mechanisms")),
    ("runs.others-by-the-program", || rounded("runs.others-by-the-program")),
    ("runs.by-chance", || rounded("runs.by-chance")),
    ("runs.others.by-chance", || rounded("runs.others.by-chance")),
    ("runs.others.by-chance.mechanisms", || rounded("runs.others.by-chance.mechanisms")),
    ("runs.others.as-many", || Ok(format!("{}&nbsp;%", rounded("runs.others.as-many")?))),
    ("runs.groups", || Ok(series(rows()).count().to_string())),
    ("runs.reset", || rounded("runs.reset")),
    ("runs.reset.one-row", || Ok(fixed(number("runs.reset.one-row")?.floor(), 0))),
    ("runs.margin", || Ok(fixed(number("runs.margin")?.floor(), 0))),
    ("runs.margin.one-row", || Ok(fixed(number("runs.margin.one-row")?.floor(), 0))),
    ("runs.margin.one-row.odds", || Ok(odds(number("runs.margin.one-row")?))),
    ("runs.sampled", || rounded("runs.sampled")),
    ("runs.sampled.odds", || Ok(odds(number("runs.sampled")?))),
    ("runs.sampled.most", || {
        Ok(fixed(most(&margins(scores(), Others::TruePeaks).context("a hypothesis that was not compared")?), 0))
    }),
    ("freed.six", || rounded("freed.six")),
    ("freed.three", || rounded("freed.three")),
    ("freed.six.quarter", || rounded("freed.six.quarter")),
    ("freed.three.quarter", || rounded("freed.three.quarter")),
    ("freed.six.less-friction", || rounded("freed.six.less-friction")),
    ("freed.three.less-friction", || {
        let freed = InertiaFit::with_friction(rows_of(rows(), Mechanism::THREE_PIN), Reset::OfTheMechanism, LITTLE);
        Ok(freed.context("no inertias give a table a motion")?.within_one().to_string())
    }),
    ("runs.least-spread", || Ok(format!("{:.2}", least_spread()))),
    ("runs.spreads", || {
        let [peak, minimum, period] = best()?.fits.each_ref().map(|fit| format!("{:.2}", fit.likelihoods[0].spread));
        Ok(format!("{peak}, {minimum} and {period}"))
    }),
    ("runs.fifth", || Ok(fixed(number("runs.fifth")?.floor(), 0))),
    ("runs.lag.normal", || Ok(fixed(number("runs.lag.normal")?, 1))),
    ("runs.lag.exponential", || Ok(fixed(number("runs.lag.exponential")?, 1))),
    ("runs.lag.by-table", || Ok(fixed(number("runs.lag.by-table")?, 1))),
    ("runs.torques", || found("torque", Verdict::Reproduced)),
    ("runs.frictions", || found("friction", Verdict::Reproduced)),
    ("runs.frictions.read", || found("friction", Verdict::ReadOff)),
    ("runs.frictions.most-off", || {
        let off = |judged: &&Judged| Some((judged.computed? - judged.printed_number()?).abs());
        let most = data("friction")?.iter().filter_map(off).fold(0.0, f64::max);
        // None is farther off: rounded up.
        Ok(fixed((1e3 * most).ceil() / 1e3, 3))
    }),
    ("rise.longer", || {
        let said = numbers_in(judged("meyer.abstract.fifty")?.claim.printed);
        let (_, most) = said.first().context("the abstract's number is lost")?;
        Ok(rows().iter().filter(|row| 1e3 * row.number(Column::Rise) > *most).count().to_string())
    }),
    ("rise.tried", || Ok(explained().len().to_string())),
    ("rise.most", || Ok(most_explained(|_| true).to_string())),
    ("rise.most.own-part", || Ok(most_explained(is_to_one_per_cent).to_string())),
    ("rise.chance", || rounded("rise.chance")),
    ("rise.by-chance.most", || greatest(shuffled(ShuffleScope::InTables))),
    ("rise.by-chance.usual", || rounded("rise.by-chance.usual")),
    ("rise.by-chance.equal-torques", || rounded("rise.by-chance.equal-torques")),
    ("rise.by-chance.equal-torques.most", || greatest(shuffled(ShuffleScope::AmongEqualTorques))),
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
    ("rise.groups", || Ok(groups(rows()).len().to_string())),
    ("rise.groups.without", || Ok(groups(rows()).iter().filter(|group| !group.possible).count().to_string())),
    ("rise.groups.but-for-one", || {
        Ok(groups(rows()).iter().filter(|group| bears_one_number(group)).count().to_string())
    }),
];

/// The most rows that any of these definitions explains, as run or for the mechanism.
/// The printed rise times with more torque and all else the same.
fn with_more_torque() -> Trend {
    Trend::count(Column::Rise, pairs_by_torque(rows()))
}

/// The printed rise times with more friction and all else the same.
fn with_more_friction() -> Trend {
    Trend::count(Column::Rise, pairs_by_friction(rows()))
}

fn most_explained(wanted: fn(&DefinitionTrial) -> bool) -> usize {
    let own = explained().iter().filter(|tried| wanted(tried));
    own.map(|tried| tried.as_run.rows().max(tried.ideal.rows())).max().unwrap_or(0)
}

/// Whether a definition lets the thesis's own part be missing, of its own quantity or of the average terminal velocity.
fn is_to_one_per_cent(tried: &DefinitionTrial) -> bool {
    tried.near.is_some_and(|near| near.is_part_of_a_velocity(MISSING))
}

/// A reading of the thesis's own definition of the rise: until the velocity is steady at every angle, or the average of peak
/// and minimum.
pub(super) fn own_reading(reading: usize) -> anyhow::Result<&'static DefinitionTrial> {
    let is_it =
        |tried: &&DefinitionTrial| tried.name == OF_A_PART[reading].name && tried.is_to_a_part_of_itself(MISSING);
    explained().iter().find(is_it).context("a definition that was not tried")
}

/// How many rows a reading of the thesis's own definition explains, as run.
fn own_meaning(reading: usize) -> anyhow::Result<String> {
    Ok(own_reading(reading)?.as_run.rows().to_string())
}

/// How many rows have this verdict on a value.
fn found(value: &str, verdict: Verdict) -> anyhow::Result<String> {
    Ok(data(value)?.iter().filter(|judged| judged.verdict == verdict).count().to_string())
}

/// The verdicts on a value in all rows.
fn data(value: &str) -> anyhow::Result<Vec<&'static Judged>> {
    rows().iter().map(|row| judged(&format!("meyer.app-e.{}.{value}", row.slug()))).collect()
}

/// The reset after a quarter of a turn, the inertias of Fig. 11, printed peaks.
fn best() -> anyhow::Result<&'static Score<'static>> {
    score(&Hypothesis::WITHOUT_LAG)
}

/// A number of the study that has two routes in the ledger, by the first of them.
fn number(name: &str) -> anyhow::Result<f64> {
    statistic(name).and_then(|of| (of.first)()).with_context(|| format!("no such number of the study: {name}"))
}

fn rounded(name: &str) -> anyhow::Result<String> {
    Ok(fixed(number(name)?, 0))
}

/// The rows of six and three pins.
fn others() -> impl Iterator<Item = &'static Row> {
    rows().iter().filter(|row| row.mechanism != Mechanism::FOUR_PIN)
}

fn greatest(counts: &[usize]) -> anyhow::Result<String> {
    Ok(counts.iter().max().context("no shuffles")?.to_string())
}

/// The smallest of all the spreads that suit a hypothesis best, in units of the last place.
fn least_spread() -> f64 {
    let spreads = |fit: &ColumnFit| fit.likelihoods.map(|likelihood| likelihood.spread);
    scores().iter().flat_map(|score| &score.fits).flat_map(spreads).fold(f64::INFINITY, f64::min)
}

/// How many times as likely at least, for a difference of ln L: rounded down, to two digits, in millions, or to a power of ten.
fn odds(difference: f64) -> String {
    let decades = difference / std::f64::consts::LN_10;
    let times = difference.exp();
    match decades {
        _ if decades >= 9.0 => format!("10<sup>{}</sup>", decades.floor()),
        _ if decades >= 6.0 => format!("{:.0} million", (times / 1e6).floor()),
        _ if decades >= 1.0 => significant(no_greater(times, 2), 2),
        _ => fixed(times.floor(), 0),
    }
}

/// Whether a group has one number for its rows, if need be without one of them.
fn bears_one_number(group: &TorqueGroup) -> bool {
    group.possible || !group.misread.is_empty()
}

#[cfg(test)]
mod tests {
    use super::super::least;
    use super::*;
    use geneva_case1973::Weighing;
    use geneva_case1973::chance;
    use geneva_case1973::likelihood::{LEAST_SPREAD, Law};
    use geneva_case1973::weighing::margins_by_one_row_of_each;
    use geneva_documents::meyer::runs::statistics::{OTHERS, STATISTICS};

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
        let one_row = |others| least(&margins_by_one_row_of_each(scores(), others).expect("compared"));
        for others in [Others::AnotherReset, Others::AnotherResetOrInertias] {
            let [columns, tables, coarse] = [Weighing::BY_COLUMN, Weighing::BY_TABLE, Weighing::COARSE]
                .map(|weighing| least(&Law::ALL.map(|law| weighing.margin(scores(), law, others).expect("compared"))));
            let one_row = one_row(others);
            assert!(columns > tables && tables > coarse && coarse > one_row, "{columns} {tables} {coarse} {one_row}");
            assert!(one_row > 20.0, "{one_row}");
        }
        // Whether the peaks are true or printed is decided by all rows only.
        assert!(number("runs.sampled").expect("compared") > 5.0 && one_row(Others::TruePeaks) < 0.0);
    }

    #[test]
    fn every_number_of_the_study_has_two_routes_or_a_reason_why_not() {
        const COUNTED: &str = "counts what is printed, or what we tried";
        const VERDICTS: &str = "says what the verdicts of the ledger are, each of which has two routes";
        const ONE_WAY: &str = "is computed in one way only";
        let elsewhere = [
            ("runs.four", COUNTED),
            ("runs.others", COUNTED),
            ("runs.groups", COUNTED),
            ("rise.tried", COUNTED),
            ("rise.longer", COUNTED),
            ("rise.torque.", COUNTED),
            ("rise.friction.", COUNTED),
            ("rise.groups", COUNTED),
            ("rise.groups.", COUNTED),
            ("runs.torques", VERDICTS),
            ("runs.frictions", VERDICTS),
            ("runs.frictions.", VERDICTS),
            ("runs.to-one-unit", VERDICTS),
            ("runs.in-error", VERDICTS),
            ("freed.three.less-friction", ONE_WAY),
            ("runs.sampled.most", ONE_WAY),
            ("runs.least-spread", ONE_WAY),
            ("runs.spreads", ONE_WAY),
            ("rise.most", ONE_WAY),
            ("rise.most.own-part", ONE_WAY),
            ("rise.by-chance.most", ONE_WAY),
            ("rise.by-chance.equal-torques.most", ONE_WAY),
            ("rise.profile", ONE_WAY),
            ("rise.average", ONE_WAY),
        ];
        let in_two_ways = |name: &str| statistic(name.trim_end_matches(".odds")).is_some();
        let is_in = |known: &str, name: &str| name == known || (known.ends_with('.') && name.starts_with(known));
        for (name, _) in NUMBERS {
            let reason = elsewhere.iter().find(|(known, _)| is_in(known, name));
            assert!(in_two_ways(name) != reason.is_some(), "{name}: two routes, or a reason why not ({reason:?})");
        }
        for (known, reason) in elsewhere {
            assert!(NUMBERS.iter().any(|(name, _)| is_in(known, name)), "no number is called {known}, which {reason}");
        }
        for statistic in &STATISTICS {
            assert!(NUMBERS.iter().any(|(name, _)| *name == statistic.name), "nothing says {}", statistic.name);
        }
    }

    #[test]
    fn odds_are_said_in_the_size_they_have() {
        assert_eq!([2.0, 6.969, 7.1, 15.0, 300.0].map(odds), ["7", "1000", "1200", "3 million", "10<sup>130</sup>"]);
    }
}
