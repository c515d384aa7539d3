//! The comparison of the runs: how many cells are reproduced, how likely the tables are, and what chance would give.

use super::kinds::{DENSITIES, LEDGER, PRINTED, QUADRATURE, STUDY, TANGENTS};
use super::most;
use super::second_routes::NEWTON;
use super::second_routes::contact::ContactModel;
use super::second_routes::definitions;
use super::second_routes::motion::SteppedEngagement;
use super::second_routes::printed_rows::{groups_with_one_rise, rises_with_more};
use super::second_routes::rise::SteppedRise;
use super::second_routes::spread::best_spread;
use crate::lookup::judged;
use crate::rows::{NONE, score};
use anyhow::Context;
use geneva_ask::number_format::no_greater;
use geneva_case1973::chance::ShuffleScope;
use geneva_case1973::fitted::InertiaFit;
use geneva_case1973::likelihood::Law;
use geneva_case1973::rise_times::{DefinitionTrial, OF_A_PART, TorqueGroup, groups};
use geneva_case1973::weighing::{Others, margins};
use geneva_case1973::witness::{densities, gauss_newton};
use geneva_case1973::{
    Column, EXPLAINED, Hypothesis, Reset, Row, Score, Trend, Weighing, pairs_by_friction, pairs_by_torque, rows_of,
    series,
};
use geneva_documents::meyer::runs::statistics::{LITTLE, shuffled, statistic};
use geneva_documents::meyer::runs::study::{explained, scores};
use geneva_documents::meyer::runs::table::rows;
use geneva_documents::meyer::terms::MISSING;
use geneva_evidence::{Decimal, Judged, Verdict, numbers_in};
use geneva_evidence::{Form, Numbers, OwnNumber};
use geneva_kinematics::Mechanism;
use geneva_press::numbers::{fixed, significant};
use std::sync::OnceLock;

/// The numbers of the chapter on the runs.
pub fn numbers() -> Vec<OwnNumber> {
    let [program, mechanisms, margin, fit] = [
        "the program explains the tables",
        "the mechanisms do hardly better than chance",
        "the tables are likelier so",
        "only the wrong reset fits",
    ];
    let (lag, chance, per_cent) = ("the lag is not decided", "chance explains less", "{.0}&nbsp;%");
    let [down, odds] =
        [Form::Written(rounded_down), Form::Written(|numbers| numbers.iter().map(|n| odds_of(*n)).collect())];
    let more_torque = || rises_with_more(Column::Torque, Column::Friction);
    let more_friction = || rises_with_more(Column::Friction, Column::Torque);
    let (trend_of_torque, trend_of_friction) =
        ("more torque does not always shorten the rise", "more friction does not shorten the rise");
    vec![
        OwnNumber::count("runs.four", || Ok(rows().len() - six_and_three_pins().count())),
        statistic_number("runs.minima", "{.0}", program),
        statistic_number("runs.periods", "{.0}", program),
        statistic_number("runs.peaks", "{.0}", program),
        statistic_number("runs.peaks-lagged", "{.0}", lag),
        statistic_number("runs.exact", "{.0}", program),
        statistic_number("runs.exact.mechanisms", "{.0}", mechanisms),
        OwnNumber::count("runs.others", || Ok(EXPLAINED.len() * six_and_three_pins().count())),
        statistic_number("runs.others-by-the-mechanisms", "{.0}", mechanisms),
        statistic_number("runs.others-by-the-program", "{.0}", program),
        statistic_number("runs.by-chance", "{.0}", chance),
        statistic_number("runs.others.by-chance", "{.0}", chance),
        statistic_number("runs.others.by-chance.mechanisms", "{.0}", mechanisms),
        statistic_number("runs.others.as-many", per_cent, mechanisms),
        OwnNumber::count("runs.groups", || Ok(series(rows()).count())),
        statistic_number("runs.reset", "{.0}", margin),
        statistic_number("runs.reset.one-row", down, margin),
        statistic_number("runs.margin", down, margin),
        statistic_number("runs.margin.one-row", down, margin),
        statistic_number("runs.margin.one-row.odds", odds, margin),
        statistic_number("runs.sampled", "{.0}", "the peaks were read from the print-out"),
        statistic_number("runs.sampled.odds", odds, "the peaks were read from the print-out"),
        OwnNumber::new("runs.sampled.most", "{.0}", STUDY, || {
            Ok(most(&margins(scores(), Others::TruePeaks).context("a hypothesis that was not compared")?))
        })
        .with_second_route("the peaks were read from the print-out", DENSITIES, || Ok(most(&margins_by_densities()?)))
        .with_allowance(0.05),
        statistic_number("freed.six", "{.0}", fit),
        statistic_number("freed.three", "{.0}", fit),
        statistic_number("freed.six.quarter", "{.0}", fit),
        statistic_number("freed.three.quarter", "{.0}", fit),
        statistic_number("freed.six.less-friction", "{.0}", fit),
        OwnNumber::new("freed.three.less-friction", "{.0}", STUDY, || {
            let freed = InertiaFit::with_friction(rows_of(rows(), Mechanism::THREE_PIN), Reset::OfTheMechanism, LITTLE);
            Ok(freed.context("no inertias give a table a motion")?.within_one())
        })
        .with_second_route(fit, TANGENTS, || with_little_friction(Mechanism::THREE_PIN)),
        OwnNumber::new("runs.least-spread", "{.2}", STUDY, || {
            let spreads = |score: &Score| score.fits.map(|fit| fit.likelihoods.map(|likelihood| likelihood.spread));
            Ok(super::least(&scores().iter().flat_map(spreads).flatten().collect::<Vec<_>>()))
        })
        .with_second_route("no spread is at the limit", DENSITIES, || {
            let spreads = |score: &Score| [0, 1, 2].map(|at| Law::ALL.map(|law| best_spread(law, &errors(score, at))));
            Ok(super::least(&scores().iter().flat_map(spreads).flatten().collect::<Vec<_>>()))
        }),
        OwnNumber::new("runs.spreads", "{.2}, {.2} and {.2}", STUDY, || {
            Ok(best()?.fits.each_ref().map(|fit| fit.likelihoods[0].spread))
        })
        .with_second_route("the minima fit best", DENSITIES, || {
            let best = best()?;
            Ok([0, 1, 2].map(|at| best_spread(Law::Normal, &errors(best, at))))
        }),
        statistic_number("runs.fifth", down, lag),
        statistic_number("runs.lag.normal", "{.1}", lag),
        statistic_number("runs.lag.exponential", "{.1}", lag),
        statistic_number("runs.lag.by-table", "{.1}", lag),
        verdict_count("runs.torques", "torque", Verdict::Reproduced),
        verdict_count("runs.frictions", "friction", Verdict::Reproduced),
        verdict_count("runs.frictions.read", "friction", Verdict::ReadOff),
        OwnNumber::new("runs.frictions.most-off", Form::Written(rounded_up), LEDGER, || {
            let off = |judged: &&Judged| Some((judged.computed? - judged.printed_number()?).abs());
            Ok(verdicts_on("friction")?.iter().filter_map(off).fold(0.0, f64::max))
        })
        .with_second_route("the frictions agree so well", LEDGER, || {
            let off = |judged: &&Judged| Some((judged.witnessed? - judged.printed_number()?).abs());
            Ok(verdicts_on("friction")?.iter().filter_map(off).fold(0.0, f64::max))
        }),
        OwnNumber::count("rise.longer", || {
            let said = numbers_in(judged("meyer.abstract.fifty")?.claim.printed);
            let (_, most) = said.first().context("the abstract's number is lost")?;
            Ok(rows().iter().filter(|row| 1e3 * row.number(Column::Rise) > *most).count())
        }),
        OwnNumber::count("rise.tried", || Ok(explained().len())),
        OwnNumber::new("rise.most", "{.0}", QUADRATURE, || Ok(most_explained(|_| true))).with_second_route(
            "no definition explains the rises",
            NEWTON,
            || Ok(most_by_motion()?[0]),
        ),
        OwnNumber::new("rise.most.own-part", "{.0}", QUADRATURE, || Ok(most_explained(is_to_one_per_cent)))
            .with_second_route("no definition with the thesis's part explains them", NEWTON, || {
                Ok(most_by_motion()?[1])
            }),
        statistic_number("rise.chance", "{.0}", chance),
        // The greatest count of a sample is of these deals alone: others have another.
        OwnNumber::new("rise.by-chance.most", "{.0}", STUDY, || greatest_count(shuffled(ShuffleScope::InTables))),
        statistic_number("rise.by-chance.usual", "{.0}", chance),
        statistic_number("rise.by-chance.equal-torques", "{.0}", chance),
        OwnNumber::new("rise.by-chance.equal-torques.most", "{.0}", STUDY, || {
            greatest_count(shuffled(ShuffleScope::AmongEqualTorques))
        }),
        rises_by_own_definition("rise.profile", 0, |rise| rise.until_profile(MISSING)),
        rises_by_own_definition("rise.average", 1, |rise| rise.until_average(MISSING)),
        trend("rise.torque.pairs", trend_of_torque, || with_more_torque().pairs, move || more_torque()[0]),
        trend("rise.torque.up", trend_of_torque, || with_more_torque().up, move || more_torque()[1]),
        trend("rise.torque.equal", trend_of_torque, || with_more_torque().equal, move || more_torque()[2]),
        trend("rise.friction.pairs", trend_of_friction, || with_more_friction().pairs, move || more_friction()[0]),
        trend("rise.friction.up", trend_of_friction, || with_more_friction().up, move || more_friction()[1]),
        trend("rise.friction.equal", trend_of_friction, || with_more_friction().equal, move || more_friction()[2]),
        OwnNumber::count("runs.to-one-unit", || rows().iter().map(only_to_a_unit).sum::<Numbers<usize>>()),
        OwnNumber::count("runs.in-error", || {
            let all = rows().iter().flat_map(|row| RESULTS.map(|column| (row, column)));
            let verdicts =
                all.map(|(row, column)| Ok(judged(&format!("meyer.app-e.{}.{column}", row.slug()))?.verdict));
            let verdicts = verdicts.collect::<Numbers<Vec<_>>>()?;
            Ok(verdicts.iter().filter(|verdict| **verdict == Verdict::ReproducedInError).count())
        }),
        OwnNumber::count("rise.groups", || Ok(groups(rows()).len())),
        trend(
            "rise.groups.without",
            ONE_NUMBER,
            || groups(rows()).iter().filter(|group| !group.possible).count(),
            || groups(rows()).len() - groups_with_one_rise(0),
        ),
        trend(
            "rise.groups.but-for-one",
            ONE_NUMBER,
            || groups(rows()).iter().filter(|group| bears_one_number(group)).count(),
            || groups_with_one_rise(1),
        ),
    ]
}

/// What the groups of rise times are to show.
const ONE_NUMBER: &str = "no one number fits the rise times";

/// The columns of results, by the names of their claims.
const RESULTS: [&str; 3] = ["max", "min", "period"];

/// The number of cells of a row that are within a unit of the printed ones without being rounded to them.
fn only_to_a_unit(row: &Row) -> Numbers<usize> {
    let mut count = 0;
    for column in RESULTS {
        let judged = judged(&format!("meyer.app-e.{}.{column}", row.slug()))?;
        let exact = judged.claim.printed.parse::<Decimal>().ok().zip(judged.computed);
        let rounds = exact.is_some_and(|(printed, computed)| printed.is_rounding_of(computed));
        count += usize::from(judged.verdict == Verdict::ReproducedInError && !rounds);
    }
    Ok(count)
}

/// A statistic of the study by both its routes, under its own name or with *odds* behind it.
fn statistic_number(id: &'static str, form: impl Into<Form>, conclusion: &'static str) -> OwnNumber {
    let name = id.trim_end_matches(".odds");
    let of = move || statistic(name).with_context(|| format!("no such number of the study: {name}"));
    let number = OwnNumber::new(id, form, STUDY, move || Ok((of()?.first)().context(NONE)?));
    let number = number.with_second_route(conclusion, STUDY, move || Ok((of()?.second)().context(NONE)?));
    number.with_allowance(statistic(name).map_or(0.0, |statistic| statistic.within))
}

/// A count of what the printed rows say among themselves, counted in two ways.
fn trend(
    id: &'static str,
    conclusion: &'static str,
    count: fn() -> usize,
    again: impl Fn() -> usize + Send + Sync + 'static,
) -> OwnNumber {
    OwnNumber::new(id, "{.0}", PRINTED, move || Ok(count())).with_second_route(conclusion, PRINTED, move || Ok(again()))
}

/// Numbers rounded down: none is less.
fn rounded_down(numbers: &[f64]) -> String {
    numbers.iter().map(|number| fixed(number.floor(), 0)).collect()
}

/// Numbers rounded up to three decimals: none is farther off.
fn rounded_up(numbers: &[f64]) -> String {
    numbers.iter().map(|number| fixed((1e3 * number).ceil() / 1e3, 3)).collect()
}

/// The margins of all rows over true peaks, by densities: by each weighing with each law.
fn margins_by_densities() -> Numbers {
    let mut margins = Vec::new();
    for weighing in [Weighing::BY_COLUMN, Weighing::BY_TABLE, Weighing::COARSE] {
        for law in Law::ALL {
            let of = |score: &Score| densities::log_likelihood(&weighing, score, law).ok_or(NONE);
            let others = scores().iter().filter(|score| Others::TruePeaks.include(&score.hypothesis));
            let others = others.map(of).collect::<Result<Vec<_>, _>>()?;
            margins.push(of(best()?)? - most(&others));
        }
    }
    Ok(margins)
}

/// How far a column of a score is off, row by row, in units of the last printed place.
fn errors(score: &Score, at: usize) -> Vec<f64> {
    let off = |(row, results): (&Row, &Option<[f64; 3]>)| {
        results.map_or(f64::NAN, |results| row.misfit(EXPLAINED[at], results[at]).abs())
    };
    score.rows.iter().zip(&score.results).map(off).collect()
}

/// Cells of a mechanism within one unit with the best inertias and as good as no friction, by the method of Gauss and Newton.
fn with_little_friction(mechanism: Mechanism) -> Numbers<usize> {
    let changed = |row: &Row| {
        let friction = (LITTLE * row.friction()).to_string();
        let cell = |column| if column == Column::Friction { &friction } else { row.printed(column) };
        Ok(Row::read(mechanism, &Column::ALL.map(cell).join(" "), row.given)?)
    };
    let table = rows_of(rows(), mechanism).iter().map(changed).collect::<Numbers<Vec<_>>>()?;
    let reset = Hypothesis::IDEAL.angle(table.first().ok_or(NONE)?);
    let (_, misfits) = gauss_newton::inertias(&table, reset).ok_or(NONE)?;
    Ok(misfits.iter().filter(|misfit| misfit.abs() <= 1.0 + 1e-9).count())
}

/// The printed rise times with more torque and all else the same.
fn with_more_torque() -> Trend {
    Trend::count(Column::Rise, pairs_by_torque(rows()))
}

/// The printed rise times with more friction and all else the same.
fn with_more_friction() -> Trend {
    Trend::count(Column::Rise, pairs_by_friction(rows()))
}

/// The most rows that any of these definitions explains, as run or for the mechanism.
fn most_explained(wanted: fn(&DefinitionTrial) -> bool) -> usize {
    let own = explained().iter().filter(|tried| wanted(tried));
    own.map(|tried| tried.as_run.rows().max(tried.ideal.rows())).max().unwrap_or(0)
}

/// The most rows that any definition explains, and any with the thesis's own part, with the starts in steps; found once.
fn most_by_motion() -> Numbers<[usize; 2]> {
    static MOST: OnceLock<Option<[usize; 2]>> = OnceLock::new();
    Ok(MOST.get_or_init(|| definitions::most_explained(rows(), MISSING)).ok_or(NONE)?)
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
fn rises_by_own_definition(id: &'static str, reading: usize, until: fn(&SteppedRise<'_>) -> Option<f64>) -> OwnNumber {
    OwnNumber::new(id, "{.0}", QUADRATURE, move || Ok(own_reading(reading)?.as_run.rows())).with_second_route(
        "the thesis's own definition explains few rises",
        NEWTON,
        move || {
            let is_near = |row: &&Row| {
                let engagement = SteppedEngagement::new(ContactModel::of_run(&Hypothesis::WITHOUT_LAG, row));
                let time = SteppedRise::new(&engagement).as_ref().and_then(until);
                time.is_some_and(|time| row.misfit(Column::Rise, time).abs() <= 1.0 + 1e-9)
            };
            Ok(rows().iter().filter(is_near).count())
        },
    )
}

/// How many rows have this verdict on a value.
fn verdict_count(id: &'static str, value: &'static str, verdict: Verdict) -> OwnNumber {
    OwnNumber::count(id, move || Ok(verdicts_on(value)?.iter().filter(|judged| judged.verdict == verdict).count()))
}

/// The verdicts on a value in all rows.
fn verdicts_on(value: &str) -> anyhow::Result<Vec<&'static Judged>> {
    rows().iter().map(|row| judged(&format!("meyer.app-e.{}.{value}", row.slug()))).collect()
}

/// The reset after a quarter of a turn, the inertias of Fig. 11, printed peaks.
fn best() -> anyhow::Result<&'static Score<'static>> {
    score(&Hypothesis::WITHOUT_LAG)
}

/// The rows of six and three pins.
fn six_and_three_pins() -> impl Iterator<Item = &'static Row> {
    rows().iter().filter(|row| row.mechanism != Mechanism::FOUR_PIN)
}

fn greatest_count(counts: &[usize]) -> Numbers<usize> {
    Ok(counts.iter().copied().max().context("no shuffles")?)
}

/// How many times as likely at least, for a difference of ln L: rounded down, to two digits, in millions, or to a power of ten.
fn odds_of(difference: f64) -> String {
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
    use geneva_case1973::chance;
    use geneva_case1973::likelihood::LEAST_SPREAD;
    use geneva_case1973::weighing::margins_by_one_row_of_each;
    use geneva_case1973::witness::sampling;
    use geneva_documents::meyer::runs::statistics::{OTHERS, SHUFFLES, STATISTICS};
    use geneva_evidence::Backing;

    #[test]
    fn chance_explains_a_part_and_the_program_nearly_all() {
        let best = best().expect("compared");
        let chance = chance::expected_cells(best, &Mechanism::ALL).expect("runs");
        assert!(3.0 * chance < best.within_one() as f64, "{chance}");
        assert!(best.within_one_of(&OTHERS) + 3 >= EXPLAINED.len() * six_and_three_pins().count());
        let by_the_mechanisms = score(&Hypothesis::IDEAL).expect("compared").within_one_of(&OTHERS);
        assert!(3 * by_the_mechanisms < best.within_one_of(&OTHERS));
    }

    fn number(name: &str) -> f64 {
        crate::computed::own_text(name).expect("a number").parse().expect("digits alone")
    }

    #[test]
    fn no_spread_that_is_found_is_at_the_end_of_those_that_are_tried() {
        let least = number("runs.least-spread");
        assert!(least > 2.0 * LEAST_SPREAD, "{least}");
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
        let sampled = statistic("runs.sampled").and_then(|of| (of.first)()).expect("compared");
        assert!(sampled > 5.0 && one_row(Others::TruePeaks) < 0.0);
    }

    #[test]
    fn every_statistic_of_the_study_is_said_and_few_numbers_have_one_route() {
        for statistic in &STATISTICS {
            let said = numbers().into_iter().find(|number| number.id == statistic.name);
            let backing = said.as_ref().map(OwnNumber::backing);
            assert_eq!(backing, Some(Backing::TwoRoutes), "nothing says {} by its two routes", statistic.name);
        }
        let alone: Vec<_> = numbers().iter().filter(|of| of.backing() == Backing::OneRoute).map(|of| of.id).collect();
        assert_eq!(alone, ["rise.by-chance.most", "rise.by-chance.equal-torques.most"]);
    }

    #[test]
    fn no_shuffle_by_another_generator_explains_as_many_rises_as_the_best_definition() {
        let times: Vec<&[f64]> =
            explained().iter().flat_map(|tried| [&tried.as_run.times[..], &tried.ideal.times]).collect();
        for (with_equal_torques, name) in [(false, "rise.by-chance.most"), (true, "rise.by-chance.equal-torques.most")]
        {
            let counts = sampling::rises(rows(), &times, with_equal_torques, SHUFFLES);
            let greatest = counts.into_iter().max().expect("shuffles");
            assert!(greatest < most_explained(|_| true), "{greatest}");
            // By one at most another greatest count than the one that is said.
            assert!((number(name) - greatest as f64).abs() <= 1.0, "{name}: {greatest}");
        }
    }

    #[test]
    fn odds_are_said_in_the_size_they_have() {
        assert_eq!([2.0, 6.969, 7.1, 15.0, 300.0].map(odds_of), ["7", "1000", "1200", "3 million", "10<sup>130</sup>"]);
    }
}
