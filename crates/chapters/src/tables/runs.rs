//! The thesis's runs: what explains the printed tables, what does not matter to them, and the correct values.

use crate::lookup::judged;
use crate::rows::NONE;
use anyhow::Context;
use geneva_case1973::fitted::{InertiaFit, most_within_one};
use geneva_case1973::integrator as integrators;
use geneva_case1973::likelihood::Law;
use geneva_case1973::weighing::Others;
use geneva_case1973::{
    Column, ColumnFit, Constants, Hypothesis, Lag, PeakReading, Reset, Row, Score, SixPin, Weighing, rows_of, series,
    slug,
};
use geneva_documents::meyer::runs::data;
use geneva_documents::meyer::runs::statistics::STATISTICS;
use geneva_documents::meyer::runs::study::{delays as all_delays, scores};
use geneva_documents::meyer::runs::table::{expected, rows};
use geneva_evidence::Verdict;
use geneva_kinematics::Mechanism;
use geneva_press::html::{Cells, Table, table};
use geneva_press::numbers::{fixed, signed};

/// The hypotheses, how many cells each explains, and how likely it makes the tables.
pub(super) fn hypotheses() -> anyhow::Result<Table> {
    let rows = (1..).zip(scores()).map(|(number, score)| {
        let Hypothesis { reset, six_pin, reading, constants, lag } = score.hypothesis;
        let besides = match (constants, lag) {
            (Constants::AsListed, Lag::None) => "π as listed",
            (Constants::Exact, Lag::None) => "–",
            _ => "π and lag as listed",
        };
        let said = [
            if reset == Reset::QuarterTurn { "90°" } else { "360°/m" },
            if six_pin == SixPin::AsDrawn { "Fig. 11" } else { "heading" },
            if reading == PeakReading::OnTheGrid { "largest printed" } else { "true" },
            besides,
        ];
        let mut row = vec![number.to_string()];
        row.extend(said.map(str::to_owned));
        row.push(score.within_one().to_string());
        row.extend(logs(score));
        Ok(row)
    });
    let head = [
        "No.",
        "Reset <br>after",
        "Six-pin <br>inertias",
        "Peaks",
        "In addition",
        "Within one <br>unit, of 147",
        "ln L, <br>normal",
        "ln L, <br>exponential",
    ];
    let says = "Ten hypotheses about the 49 runs, with the number of cells within one unit of the last printed place, and the \
                log-likelihood";
    table(says, Cells::Numbers, &head, rows)
}

/// How much likelier the best combination makes the tables than others, by how the errors are taken.
pub(super) fn weighings() -> anyhow::Result<Table> {
    let margins = [Others::AnotherReset, Others::AnotherResetOrInertias];
    // The least of the margins that some weighings give, by each law.
    let least = |weighings: &[Weighing]| {
        let of = |others, law| {
            let all =
                weighings.iter().map(|weighing| weighing.margin(scores(), law, others)).collect::<Option<Vec<_>>>();
            let all = all.context("a hypothesis that was not compared")?;
            Ok(fixed(all.into_iter().fold(f64::INFINITY, f64::min), 0))
        };
        margins.into_iter().flat_map(|others| Law::ALL.map(|law| of(others, law))).collect::<anyhow::Result<Vec<_>>>()
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
    let rows = ways.map(|(name, weighings)| Ok([vec![name.to_owned()], least(weighings)?].concat()));
    let head = [
        "How the errors are taken",
        "Another reset, <br>normal",
        "Another reset, <br>exponential",
        "Another reset or <br>inertias, normal",
        "Another reset or <br>inertias, exponential",
    ];
    let says = "How much greater ln L is with the reset after 90° and the inertias of Fig. 11 than with the best of \
                the other combinations. Each of the last two lines keeps the conditions of the line above it and adds \
                one. For the last line we formed several sets of rows, each with one row from every group: the rows \
                with the weakest springs, those with the next stronger ones, and so on. The line shows the smallest \
                difference of all sets";
    table(says, Cells::NamedNumbers, &head, rows)
}

/// What the best inertias could explain with either reset.
pub(super) fn freed() -> anyhow::Result<Table> {
    let of = |mechanism: Mechanism, reset: Reset| {
        let none = "no inertias give a table a motion";
        let table = rows_of(rows(), mechanism);
        let freed = InertiaFit::new(table, reset).context(none)?;
        let [driver, follower] = freed.inertias.map(|inertia| format!("{:.1}", 1e6 * inertia));
        let angle = Hypothesis { reset, ..Hypothesis::WITHOUT_LAG }.angle(table.first().context(none)?).to_degrees();
        Ok(vec![
            mechanism.pins().to_string(),
            format!("{angle:.0}°"),
            driver,
            follower,
            format!("{} of {}", freed.within_one(), freed.misfits.len()),
            format!("{:.1}", freed.mean_misfit()),
            most_within_one(table, reset).context(none)?.to_string(),
        ])
    };
    let others = [Mechanism::SIX_PIN, Mechanism::THREE_PIN];
    let rows = others.into_iter().flat_map(|it| [Reset::OfTheMechanism, Reset::QuarterTurn].map(|reset| of(it, reset)));
    let head = [
        "Pins",
        "Reset <br>after",
        "Driver, <br>best",
        "Follower, <br>best",
        "Within <br>one unit",
        "Misfit, root <br>mean square",
        "Most within one <br>unit, any inertias",
    ];
    let says = "The inertias that fit a table best with either reset, by least squares, in 10⁻⁶ in lb s²; all frictions and \
                torques are as printed, and peaks are the true ones";
    table(says, Cells::Numbers, &head, rows)
}

/// The peaks that neither the program nor the mechanism gives.
pub(super) fn unexplained() -> anyhow::Result<Table> {
    let wrong = |row: &&Row| expected(row, Column::Peak) == Some(Verdict::Corrected);
    let rows = rows().iter().filter(wrong).map(|row| {
        let id = format!("meyer.app-e.{}.max", row.slug());
        let judged = judged(&id)?;
        let printed = judged.printed_number().context("no printed number")?;
        let mut cells = vec![
            row.mechanism.pins().to_string(),
            row.printed(Column::Friction).to_owned(),
            row.printed(Column::Torque).to_owned(),
            row.printed(Column::Peak).to_owned(),
        ];
        for number in [judged.computed, judged.right_value] {
            let number = number.context("no computed number")?;
            cells.extend([format!("{number:.1}"), signed((printed - number) / Column::Peak.unit(), 1)]);
        }
        Ok(cells)
    });
    let head =
        ["Pins", "μ", "K", "Printed", "Program's <br>value", "off the <br>program's", "Right", "off the <br>right one"];
    table("The two peaks that the program does not reproduce to within one unit, in rad/s", Cells::Numbers, &head, rows)
}

/// The numbers of our own that were computed in two ways.
pub(super) fn statistics() -> anyhow::Result<Table> {
    let rows = STATISTICS.iter().map(|of| {
        let number = (of.first)().with_context(|| format!("{}: a run comes to no end", of.name))?;
        let (number, within) = match of.within {
            0.0 => (fixed(number, 0), "0".to_owned()),
            within => (fixed(number, 2), within.to_string()),
        };
        Ok(vec![of.meaning.to_owned(), number, of.by.to_owned(), within])
    });
    let head = ["Number", "First way", "Second way", "Agree to <br>within"];
    let says = "Statistics of the runs that we computed in two ways, and how closely the two must agree";
    table(says, Cells::Words, &head, rows)
}

/// The hypotheses column by column.
pub(super) fn by_column() -> anyhow::Result<Table> {
    let rows = (1..).zip(scores()).map(|(number, score)| {
        let mut row = vec![number.to_string()];
        row.extend(score.fits.iter().flat_map(|fit| [counts(fit), signed(100.0 * fit.worst, 1)]));
        Ok(row)
    });
    let head = ["No.", "Peaks", "worst, <br>%", "Minima", "worst, <br>%", "Periods", "worst, <br>%"];
    let says = "The ten hypotheses column by column: how many of the 49 cells agree to the printed digit / to within \
                one unit, and the worst relative deviation (printed/computed − 1)";
    table(says, Cells::Numbers, &head, rows)
}

/// Delays of the sign of the friction.
pub(super) fn delays() -> anyhow::Result<Table> {
    let rows = all_delays().iter().map(|(delay, score)| {
        let [peak, minimum, period] = &score.fits;
        let mut row = vec![if *delay > 0.0 { format!("{:.3} ms", 1e3 * delay) } else { "none".to_owned() }];
        row.push(score.within_one().to_string());
        row.extend(logs(score));
        row.extend([counts(peak), signed(100.0 * peak.mean, 2), counts(minimum), counts(period)]);
        Ok(row)
    });
    let head = [
        "Lag of <br>the sign",
        "of 147",
        "ln L, <br>normal",
        "ln L, <br>exponential",
        "Peaks",
        "mean off, <br>%",
        "Minima",
        "Periods",
    ];
    let says = "The program as listed except for the lag: number of cells that agree to the printed digit / to within \
                one unit, and the mean relative deviation of the peaks (printed/computed − 1)";
    table(says, Cells::Numbers, &head, rows)
}

/// What changes when the integrator differs in ways that the thesis leaves open.
pub(super) fn integrator() -> anyhow::Result<Table> {
    let changes = integrators::changes(rows()).context("a run of the program of 1973 comes to no end")?;
    let rows = changes.iter().map(|(variant, changes)| {
        let mut row = vec![variant.name.to_owned()];
        row.extend(changes.iter().flat_map(|change| change.most.map(|most| format!("{:.1}", 1e6 * most))));
        row.push(changes.iter().map(|change| change.printed_otherwise).sum::<usize>().to_string());
        Ok(row)
    });
    let head = [
        "Changed",
        "Peak",
        "Minimum",
        "Period",
        "Peak, with <br>the lag",
        "Minimum, <br>with the lag",
        "Period, with <br>the lag",
        "Other <br>digits",
    ];
    let says = "Largest changes, in millionths, if the integrator differs in ways that the thesis leaves open";
    table(says, Cells::NamedNumbers, &head, rows)
}

/// Cells to the printed digit, and within one unit.
fn counts(fit: &ColumnFit) -> String {
    format!("{} / {}", fit.exact, fit.within_one)
}

fn logs(score: &Score) -> [String; 2] {
    score.likelihoods().map(|log| signed(log, 1))
}

/// The inertias of each table, as they are found from its results.
pub(super) fn inertias() -> anyhow::Result<Table> {
    let rows = Mechanism::ALL.map(|mechanism| {
        let uncertainties = data::uncertainties(mechanism).context("the results do not tell two inertias")?;
        let found = data::inertias(mechanism).into_iter().zip(uncertainties);
        let mut row = vec![mechanism.pins().to_string()];
        for (member, (inertia, uncertainty)) in ["driver", "follower"].into_iter().zip(found) {
            let heading = judged(&format!("meyer.app-e.{mechanism}.{member}", mechanism = slug(mechanism)))?;
            row.push(format!("{:.2} ± {:.2}", 1e6 * inertia, 1e6 * uncertainty));
            row.push(heading.claim.printed.to_owned());
        }
        Ok(row)
    });
    let head = [
        "Pins",
        "Driver, <br>found",
        "Driver, in <br>the heading",
        "Follower, <br>found",
        "Follower, in <br>the heading",
    ];
    let says = "Moments of inertia that best reproduce the peaks, minima and periods of a table, in 10⁻⁶ in lb s²; all \
                frictions and torques are as printed";
    table(says, Cells::Numbers, &head, rows)
}

/// The runs with six pins, printed and corrected.
pub(super) fn six_pin() -> anyhow::Result<Table> {
    corrected(Mechanism::SIX_PIN, &Hypothesis::IDEAL)
}

/// The runs with four pins, printed and corrected.
pub(super) fn four_pin() -> anyhow::Result<Table> {
    corrected(Mechanism::FOUR_PIN, &Hypothesis::IDEAL)
}

/// The runs with three pins, printed and corrected.
pub(super) fn three_pin() -> anyhow::Result<Table> {
    corrected(Mechanism::THREE_PIN, &Hypothesis::IDEAL)
}

/// The runs with six pins and the inertias of the table's heading, printed and corrected.
pub(super) fn six_pin_as_headed() -> anyhow::Result<Table> {
    corrected(Mechanism::SIX_PIN, &Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::IDEAL })
}

fn corrected(mechanism: Mechanism, hypothesis: &Hypothesis) -> anyhow::Result<Table> {
    let first = rows_of(rows(), mechanism).first().context("a table without rows")?;
    let cells = rows_of(rows(), mechanism).iter().map(|row| printed_and_right(row, hypothesis));
    let head = [
        "μ",
        "K",
        "Peak, <br>printed",
        "Peak, <br>right",
        "off by, <br>%",
        "Minimum, <br>printed",
        "Minimum, <br>right",
        "Period, <br>printed",
        "Period, <br>right",
    ];
    let [driver, follower] = hypothesis.inertias(first).map(|inertia| fixed(1e6 * inertia, 0));
    let says = format!(
        "{} pins, printed and right values: K in in·lb, speeds in rad/s, periods in s; the driver's inertia is {driver} · \
         10⁻⁶ in lb s², and the follower's is {follower} · 10⁻⁶ in lb s²",
        match mechanism.pins() {
            3 => "Three",
            4 => "Four",
            _ => "Six",
        }
    );
    table(&says, Cells::Numbers, &head, cells)
}

fn printed_and_right(row: &Row, hypothesis: &Hypothesis) -> anyhow::Result<Vec<String>> {
    let [peak, minimum, period] = hypothesis.results(row).context(NONE)?;
    let off = |column, value: f64| signed(100.0 * (row.number(column) / value - 1.0), 0);
    let printed = |column| row.printed(column).to_owned();
    Ok(vec![
        printed(Column::Friction),
        printed(Column::Torque),
        printed(Column::Peak),
        format!("{peak:.1}"),
        off(Column::Peak, peak),
        printed(Column::Minimum),
        format!("{minimum:.2}"),
        printed(Column::Period),
        format!("{period:.5}"),
    ])
}
