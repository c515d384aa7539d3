//! The thesis's runs: what explains the printed tables, what does not matter to them, and the correct values.

use crate::lookup::judged;
use crate::printed_cells::{self, HEADS, PrintedCell};
use crate::rows::NONE;
use anyhow::Context;
use geneva_case1973::fitted::{InertiaFit, most_within_one};
use geneva_case1973::integrator as integrators;
use geneva_case1973::likelihood::Law;
use geneva_case1973::weighing::Others;
use geneva_case1973::{
    Column, ColumnFit, Constants, EXPLAINED, Hypothesis, Lag, PeakReading, Reset, Row, Score, SixPin, Weighing,
    rows_of, series, slug,
};
use geneva_documents::meyer::runs::data;
use geneva_documents::meyer::runs::statistics::STATISTICS;
use geneva_documents::meyer::runs::study::{delays as all_delays, scores};
use geneva_documents::meyer::runs::table::{expected, rows};
use geneva_evidence::Verdict;
use geneva_kinematics::Mechanism;
use geneva_press::numbers::{fixed, signed};
use geneva_press::table::{Cells, Columns, Table};

/// The hypotheses, how many cells each explains, and how likely it makes the tables.
pub(super) fn hypotheses() -> anyhow::Result<Table> {
    let reset = |of: Reset| if of == Reset::QuarterTurn { "90°" } else { "360°/m" };
    let inertias = |of: SixPin| if of == SixPin::AsDrawn { "Fig. 11" } else { "heading" };
    let peaks = |of: PeakReading| if of == PeakReading::OnTheGrid { "largest printed" } else { "true" };
    let besides = |of: Hypothesis| match (of.constants, of.lag) {
        (Constants::AsListed, Lag::None) => "π as listed",
        (Constants::Exact, Lag::None) => "–",
        _ => "π and lag as listed",
    };
    let columns = Table::with_rows(Cells::Numbers, (1_u32..).zip(scores()))
        .column("No.", |(number, _)| *number)
        .column("Reset <br>after", |(_, score)| reset(score.hypothesis.reset))
        .column("Six-pin <br>inertias", |(_, score)| inertias(score.hypothesis.six_pin))
        .column("Peaks", |(_, score)| peaks(score.hypothesis.reading))
        .column("In addition", |(_, score)| besides(score.hypothesis))
        .column("Within one <br>unit, of 147", |(_, score)| score.within_one());
    with_likelihoods(columns, |(_, score)| score).finish()
}

/// How much likelier the best combination makes the tables than others, by how the errors are taken.
pub(super) fn weighings() -> anyhow::Result<Table> {
    // The least of the margins that some weighings give, by a law.
    let least = |weighings: &[Weighing], others, law| {
        let all = weighings.iter().map(|weighing| weighing.margin(scores(), law, others)).collect::<Option<Vec<_>>>();
        let all = all.context("a hypothesis that was not compared")?;
        Ok(fixed(all.into_iter().fold(f64::INFINITY, f64::min), 0))
    };
    let one_row: Vec<Weighing> = Weighing::one_row_of_each(rows()).collect();
    let one_row_of_each =
        format!("and only one row for each mechanism and friction, {} of {}", series(rows()).count(), rows().len());
    let ways: [(&str, &[Weighing]); 4] = [
        ("one spread for each column", &[Weighing::BY_COLUMN]),
        ("a spread for each column of each table", &[Weighing::BY_TABLE]),
        ("and no spread below half a unit", &[Weighing::COARSE]),
        (&one_row_of_each, &one_row),
    ];
    let [normal, exponential] = Law::ALL;
    let margins = [
        ("Another reset, <br>normal", Others::AnotherReset, normal),
        ("Another reset, <br>exponential", Others::AnotherReset, exponential),
        ("Another reset or <br>inertias, normal", Others::AnotherResetOrInertias, normal),
        ("Another reset or <br>inertias, exponential", Others::AnotherResetOrInertias, exponential),
    ];
    Table::with_rows(Cells::NamedNumbers, ways)
        .column("How the errors are taken", |(name, _)| *name)
        .columns(
            margins,
            |(head, ..)| (*head).to_owned(),
            |(_, weighings), (_, others, law)| least(weighings, *others, *law),
        )
        .finish()
}

/// What the best inertias could explain with either reset.
pub(super) fn freed() -> anyhow::Result<Table> {
    let of = |mechanism: Mechanism, reset: Reset| {
        let none = "no inertias give a table a motion";
        let table = rows_of(rows(), mechanism);
        let freed = InertiaFit::new(table, reset).context(none)?;
        let angle = Hypothesis { reset, ..Hypothesis::WITHOUT_LAG }.angle(table.first().context(none)?).to_degrees();
        let most = most_within_one(table, reset).context(none)?;
        Ok::<_, anyhow::Error>((mechanism, angle, freed, most))
    };
    let others = [Mechanism::SIX_PIN, Mechanism::THREE_PIN];
    let fits = others.into_iter().flat_map(|it| [Reset::OfTheMechanism, Reset::QuarterTurn].map(|reset| of(it, reset)));
    Table::with_rows(Cells::Numbers, fits.collect::<Result<Vec<_>, _>>()?)
        .column("Pins", |(mechanism, ..)| mechanism.pins())
        .column("Reset <br>after", |(_, angle, ..)| format!("{angle:.0}°"))
        .column("Driver, <br>best", |(_, _, fit, _)| format!("{:.1}", 1e6 * fit.inertias[0]))
        .column("Follower, <br>best", |(_, _, fit, _)| format!("{:.1}", 1e6 * fit.inertias[1]))
        .column("Within <br>one unit", |(_, _, fit, _)| format!("{} of {}", fit.within_one(), fit.misfits.len()))
        .column("Misfit, root <br>mean square", |(_, _, fit, _)| format!("{:.1}", fit.mean_misfit()))
        .column("Most within one <br>unit, any inertias", |(.., most)| most.to_string())
        .finish()
}

/// The peaks that neither the program nor the mechanism gives.
pub(super) fn unexplained() -> anyhow::Result<Table> {
    let wrong = |row: &&Row| expected(row, Column::Peak) == Some(Verdict::Corrected);
    let of = |row: &'static Row| {
        let judged = judged(&format!("meyer.app-e.{}.max", row.slug()))?;
        let all = [judged.printed_number(), judged.computed, judged.right_value];
        let [printed, programs, right] = all.map(|number| number.context("a number is missing"));
        Ok::<_, anyhow::Error>((row, printed?, programs?, right?))
    };
    let off = |printed: f64, number: f64| signed((printed - number) / Column::Peak.unit(), 1);
    let peaks = rows().iter().filter(wrong).map(of).collect::<Result<Vec<_>, _>>()?;
    Table::with_rows(Cells::Numbers, peaks)
        .column("Pins", |(row, ..)| row.mechanism.pins())
        .column("μ", |(row, ..)| row.printed(Column::Friction))
        .column("K", |(row, ..)| row.printed(Column::Torque))
        .column("Printed", |(row, ..)| row.printed(Column::Peak))
        .column("Program's <br>value", |(_, _, programs, _)| format!("{programs:.1}"))
        .column("off the <br>program's", |(_, printed, programs, _)| off(*printed, *programs))
        .column("Right", |(.., right)| format!("{right:.1}"))
        .column("off the <br>right one", |(_, printed, _, right)| off(*printed, *right))
        .finish()
}

/// The numbers of our own that were computed in two ways.
pub(super) fn statistics() -> anyhow::Result<Table> {
    let digits = |within: f64| if within == 0.0 { 0 } else { 2 };
    Table::with_rows(Cells::Words, &STATISTICS)
        .column("Number", |of| of.meaning)
        .column("First way", |of| {
            let number = (of.first)().with_context(|| format!("{}: a run comes to no end", of.name))?;
            Ok(fixed(number, digits(of.within)))
        })
        .column("Second way", |of| of.by)
        .column("Agree to <br>within", |of| of.within.to_string())
        .finish()
}

/// The hypotheses column by column.
pub(super) fn by_column() -> anyhow::Result<Table> {
    let worst = |fit: &ColumnFit| signed(100.0 * fit.worst, 1);
    Table::with_rows(Cells::Numbers, (1_u32..).zip(scores()))
        .column("No.", |(number, _)| *number)
        .column("Peaks", |(_, score)| counts(&score.fits[0]))
        .column("worst, <br>%", |(_, score)| worst(&score.fits[0]))
        .column("Minima", |(_, score)| counts(&score.fits[1]))
        .column("worst, <br>%", |(_, score)| worst(&score.fits[1]))
        .column("Periods", |(_, score)| counts(&score.fits[2]))
        .column("worst, <br>%", |(_, score)| worst(&score.fits[2]))
        .finish()
}

/// Delays of the sign of the friction.
pub(super) fn delays() -> anyhow::Result<Table> {
    let lag = |delay: f64| if delay > 0.0 { format!("{:.3} ms", 1e3 * delay) } else { "none".to_owned() };
    let columns = Table::with_rows(Cells::Numbers, all_delays())
        .column("Lag of <br>the sign", |(delay, _)| lag(*delay))
        .column("of 147", |(_, score)| score.within_one());
    with_likelihoods(columns, |(_, score)| score)
        .column("Peaks", |(_, score)| counts(&score.fits[0]))
        .column("mean off, <br>%", |(_, score)| signed(100.0 * score.fits[0].mean, 2))
        .column("Minima", |(_, score)| counts(&score.fits[1]))
        .column("Periods", |(_, score)| counts(&score.fits[2]))
        .finish()
}

/// What changes when the integrator differs in ways that the thesis leaves open.
pub(super) fn integrator() -> anyhow::Result<Table> {
    let changes = integrators::changes(rows()).context("a run of the program of 1973 comes to no end")?;
    let heads = [
        "Peak",
        "Minimum",
        "Period",
        "Peak, with <br>the lag",
        "Minimum, <br>with the lag",
        "Period, with <br>the lag",
    ];
    Table::with_rows(Cells::NamedNumbers, changes)
        .column("Changed", |(variant, _)| variant.name)
        .columns(
            heads.into_iter().enumerate(),
            |(_, head)| (*head).to_owned(),
            |(_, changes), (at, _)| format!("{:.1}", 1e6 * changes[at / 3].most[at % 3]),
        )
        .column("Other <br>digits", |(_, changes)| changes.iter().map(|change| change.printed_otherwise).sum::<usize>())
        .finish()
}

/// Cells to the printed digit, and within one unit.
fn counts(fit: &ColumnFit) -> String {
    format!("{} / {}", fit.exact, fit.within_one)
}

/// Adds the log-likelihoods of a row's score, by each law.
fn with_likelihoods<R>(table: Columns<R>, score: impl Fn(&R) -> &Score<'static>) -> Columns<R> {
    table.columns(
        ["normal", "exponential"].into_iter().enumerate(),
        |(_, law)| format!("ln L, <br>{law}"),
        |row, (at, _)| signed(score(row).likelihoods()[*at], 1),
    )
}

/// The inertias of each table, as they are found from its results.
pub(super) fn inertias() -> anyhow::Result<Table> {
    let of = |mechanism: Mechanism| {
        let uncertainties = data::uncertainties(mechanism).context("the results do not tell two inertias")?;
        Ok::<_, anyhow::Error>((mechanism, data::inertias(mechanism), uncertainties))
    };
    let found = Mechanism::ALL.map(of).into_iter().collect::<Result<Vec<_>, _>>()?;
    let members = |table: Columns<(Mechanism, [f64; 2], [f64; 2])>, (at, member): (usize, &str)| {
        let (upper, id) = (if at == 0 { "Driver" } else { "Follower" }, member);
        table
            .column(format!("{upper}, <br>found"), |(_, inertias, uncertainties)| {
                format!("{:.2} ± {:.2}", 1e6 * inertias[at], 1e6 * uncertainties[at])
            })
            .column(format!("{upper}, in <br>the heading"), |(mechanism, ..)| {
                Ok(judged(&format!("meyer.app-e.{}.{id}", slug(*mechanism)))?.claim.printed.to_owned())
            })
    };
    let pins = Table::with_rows(Cells::Numbers, found).column("Pins", |(mechanism, ..)| mechanism.pins());
    ["driver", "follower"].into_iter().enumerate().fold(pins, members).finish()
}

/// The runs with six pins: printed, as run, and right.
pub(super) fn six_pin() -> anyhow::Result<Table> {
    as_printed_run_and_right(Mechanism::SIX_PIN, |cell| Ok(cell.right))
}

/// The runs with four pins: printed, as run, and right.
pub(super) fn four_pin() -> anyhow::Result<Table> {
    as_printed_run_and_right(Mechanism::FOUR_PIN, |cell| Ok(cell.right))
}

/// The runs with three pins: printed, as run, and right.
pub(super) fn three_pin() -> anyhow::Result<Table> {
    as_printed_run_and_right(Mechanism::THREE_PIN, |cell| Ok(cell.right))
}

/// The runs with six pins, right for the inertias of the table's heading, which the runs did not have.
pub(super) fn six_pin_as_headed() -> anyhow::Result<Table> {
    const AS_HEADED: Hypothesis = Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::IDEAL };
    as_printed_run_and_right(Mechanism::SIX_PIN, |cell| {
        let results = AS_HEADED.results(cell.row).context(NONE)?;
        let explained = EXPLAINED.iter().position(|column| *column == cell.column);
        explained.and_then(|at| results.get(at).copied()).context(NONE)
    })
}

/// The printed numbers of a mechanism's runs, each with what the program gives and what is right on its line.
fn as_printed_run_and_right(
    mechanism: Mechanism,
    right: impl Fn(&PrintedCell) -> anyhow::Result<f64>,
) -> anyhow::Result<Table> {
    let of = |cell: PrintedCell| Ok::<_, anyhow::Error>((right(&cell)?, cell));
    let cells = printed_cells::of_rows(rows_of(rows(), mechanism))?.into_iter().map(of);
    Table::with_rows(Cells::Grouped, cells.collect::<Result<Vec<_>, _>>()?)
        .column("Run", |(_, cell)| {
            format!("μ = {} <br>K = {}", cell.given(Column::Friction), cell.given(Column::Torque))
        })
        .column("Quantity", |(_, cell)| cell.quantity)
        .column("printed", |(_, cell)| format!("<a href=\"ledger.html#{}\">{}</a>", cell.id, cell.printed()))
        .column("as run", |(_, cell)| cell.to_places(cell.as_run))
        .column("right", |(right, cell)| cell.to_places(*right))
        .with_data(HEADS, |(right, cell)| {
            let [mechanism, friction, torque, quantity, printed] = cell.words();
            let [as_run, right] = [cell.as_run, *right].map(|number| format!("{number:.6}"));
            [mechanism, friction, torque, quantity, printed, as_run, right]
        })
        .finish()
}
