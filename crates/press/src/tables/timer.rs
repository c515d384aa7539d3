//! What a clockmaker asks: settling, sensitivity, accelerations and mean speed of the thesis's mechanisms.

use crate::html::{Cells, Table, table};
use crate::maths::formula;
use crate::numbers::signed;
use crate::rows::{engagement, example, parameters};
use geneva_dynamics::timer::{Accelerations, Sensitivities, Settling};
use geneva_dynamics::{Inertias, Parameters};
use geneva_ledger::meyer::runs::choice::{strongest, weakest};
use geneva_ledger::meyer::runs::{Column, Hypothesis, Row};

/// Seconds of a day.
const DAY: f64 = 86_400.0;

/// How fast four pins settle, with followers of another size, down to a part.
pub fn settling() -> anyhow::Result<Table> {
    const PART: f64 = 0.01;
    let own = parameters(example()?)?;
    let rows = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0].map(|part| {
        let inertias = Inertias::new(own.inertias().driver(), own.inertias().follower() / part)?;
        let settling = Settling::new(&Parameters::new(own.mechanism(), inertias, own.torque(), own.friction())?)?;
        let name = if part > 1.0 { format!("1/{part}") } else { "as run".to_owned() };
        Ok(vec![
            name,
            format!("{:.3}", inertias.ratio()),
            format!("{:.4}", settling.multiplier),
            format!("{:.2}", settling.engagements(PART)),
            format!("{:.1}", 1e3 * settling.period),
            format!("{:.1}", 1e3 * settling.time(PART)),
        ])
    });
    let ratio = formula("I_D/I_f", false)?;
    let head = ["Follower", &ratio, "multiplier", "engagements to 1%", "period, ms", "time to 1%, ms"];
    table("Settling with a lighter follower", Cells::NamedNumbers, &head, rows)
}

/// Powers of the mean speed, and what one per cent of each quantity costs a day.
pub fn sensitivity() -> anyhow::Result<Table> {
    let rows = weakest().map(|row| {
        let found = Sensitivities::new(&parameters(row)?)?;
        let powers = [found.torque, found.friction, found.driver_inertia, found.follower_inertia];
        let mut cells = vec![name(row)];
        cells.extend(powers.map(|power| signed(power, 3)));
        cells.extend(powers.map(|power| signed(DAY * power / 100.0, 0)));
        Ok(cells)
    });
    let symbols = ["K", r"\mu", "I_D", "I_f"].map(|symbol| formula(symbol, false));
    let [torque, friction, driver, follower] = symbols;
    let (torque, friction, driver, follower) = (torque?, friction?, driver?, follower?);
    let costs = [&torque, &friction, &driver, &follower].map(|symbol| format!("1% of {symbol}, s a day"));
    let mut head = vec!["Mechanism", &torque, &friction, &driver, &follower];
    head.extend(costs.iter().map(String::as_str));
    table("Sensitivities of the mean speed", Cells::NamedNumbers, &head, rows)
}

/// The greatest accelerations and forces of the strongest run of each mechanism and friction.
pub fn accelerations() -> anyhow::Result<Table> {
    let rows = strongest().map(|row| {
        let found = Accelerations::new(&parameters(row)?)?;
        let degrees = |angle: f64| signed(angle.to_degrees(), 1) + "°";
        Ok(vec![
            with_torque(row),
            signed(found.driver.value / 1e3, 1),
            degrees(found.driver.angle),
            signed(found.follower.value / 1e3, 1),
            degrees(found.follower.angle),
            signed(found.jump / 1e3, 2),
            signed(found.normal_moment.value / row.torque(), 2),
        ])
    });
    let force = formula("N r/K", false)?;
    let head = ["Run", "driver, 1000 rad/s²", "at", "follower, 1000 rad/s²", "at", "its jump", &force];
    table("Accelerations of the members", Cells::NamedNumbers, &head, rows)
}

/// The average of the thesis beside the mean speed over a revolution.
pub fn mean_speed() -> anyhow::Result<Table> {
    let rows = weakest().map(|row| {
        let steady = engagement(row, &Hypothesis::IDEAL)?.steady_state()?;
        let printed = (row.number(Column::Peak) + row.number(Column::Minimum)) / 2.0;
        Ok(vec![
            with_torque(row),
            format!("{printed:.1}"),
            format!("{:.1}", steady.mean_of_extremes()),
            format!("{:.2}", steady.mean_speed),
            format!("{:.2}", printed / steady.mean_speed),
            format!("{:.2}", steady.mean_of_extremes() / steady.mean_speed),
        ])
    });
    let head =
        ["Run", "printed extremes", "right extremes", "revolution", "printed over revolution", "right over revolution"];
    table("Two meanings of the average terminal velocity", Cells::NamedNumbers, &head, rows)
}

fn name(row: &Row) -> String {
    format!("{} pins, μ&nbsp;=&nbsp;{}", row.mechanism.pins(), row.printed(Column::Friction))
}

fn with_torque(row: &Row) -> String {
    format!("{}, K&nbsp;=&nbsp;{}", name(row), row.printed(Column::Torque))
}
