//! A clockmaker's questions: settling, sensitivity, accelerations and mean speed of the thesis's mechanisms.

use crate::html::{Cells, Table, table};
use crate::numbers::signed;
use crate::rows::{engagement, example, parameters};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::{Accelerations, Sensitivities, Settling};
use geneva_dynamics::{Inertias, Parameters};
use geneva_figures::timer::Settled;
use geneva_ledger::meyer::runs::choice::{strongest, weakest};
use geneva_ledger::meyer::runs::{Column, Hypothesis, Row};

/// Seconds of a day.
pub const DAY: f64 = 86_400.0;

/// The followers compared: parts of the inertia of the example's.
const PARTS: [f64; 7] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
/// A motion counts as settled when a small difference is down to this part of itself.
const SETTLED: f64 = 0.01;

/// A row's mechanism with so many times less inertia of its follower.
fn lighter(row: &Row, part: f64) -> anyhow::Result<(Inertias, Settling)> {
    let own = parameters(row)?;
    let inertias = Inertias::new(own.inertias().driver(), own.inertias().follower() / part)?;
    Ok((inertias, Settling::new(&Parameters::new(own.mechanism(), inertias, own.torque(), own.friction())?)?))
}

/// How long each of the compared followers takes to settle, in seconds.
pub fn settling_times() -> anyhow::Result<Vec<f64>> {
    PARTS.iter().map(|part| Ok(lighter(example()?, *part)?.1.time(SETTLED))).collect()
}

/// What each of the compared followers does, for a drawing.
pub fn settled() -> anyhow::Result<Vec<Settled>> {
    let of = |part: &f64| {
        let found = lighter(example()?, *part)?.1;
        let time = found.time(SETTLED);
        Ok(Settled { part: 1.0 / part, engagements: found.engagements(SETTLED), period: found.period, time })
    };
    PARTS.iter().map(of).collect()
}

/// How long each of the lighter followers takes to settle over the one as run, with every mechanism and friction.
pub fn lighter_times() -> anyhow::Result<Vec<f64>> {
    let mut times = Vec::new();
    for row in weakest() {
        let as_run = lighter(row, 1.0)?.1.time(SETTLED);
        for part in &PARTS[1..] {
            times.push(lighter(row, *part)?.1.time(SETTLED) / as_run);
        }
    }
    Ok(times)
}

/// How fast four pins settle, with followers of another size, down to a part.
pub fn settling() -> anyhow::Result<Table> {
    let rows = PARTS.map(|part| {
        let (inertias, settling) = lighter(example()?, part)?;
        let name = if part > 1.0 { format!("1/{part}") } else { "as run".to_owned() };
        Ok(vec![
            name,
            format!("{:.2}", inertias.ratio()),
            format!("{:.3}", settling.multiplier),
            format!("{:.1}", settling.engagements(SETTLED)),
            format!("{:.1}", 1e3 * settling.period),
            format!("{:.1}", 1e3 * settling.time(SETTLED)),
        ])
    });
    let head = [
        "follower's inertia",
        "inertia, driver <br>over follower",
        "multiplier",
        "engagements <br>to 1 %",
        "period, <small>ms</small>",
        "time to 1 %, <small>ms</small>",
    ];
    let caption = format!(
        "Settling with a lighter follower: {}, with the same driver, friction and torque. The multiplier is the \
         fraction of a small difference in the squared speed that is left after one engagement. The columns “to 1 %” \
         give the number of engagements and the time in which this difference falls to one per cent",
        with_torque(example()?).replace("&nbsp;", " ") + " in lb"
    );
    table(&caption, Cells::NamedNumbers, &head, rows)
}

/// What one per cent of each quantity makes in a day, and what half the friction does.
pub fn sensitivity() -> anyhow::Result<Table> {
    let rows = weakest().map(|row| {
        let own = parameters(row)?;
        let found = Sensitivities::new(&own)?;
        let powers = [found.torque, found.friction, found.driver_inertia, found.follower_inertia];
        let mut cells = vec![name(row)];
        cells.extend(powers.map(|power| signed(DAY * power / 100.0, 0)));
        cells.push(signed(found.friction, 3));
        cells.push(signed(100.0 * (oiled(&own)? - 1.0), 0) + "&nbsp;%");
        Ok(cells)
    });
    let head = [
        "mechanism",
        "torque, <small>s a day</small>",
        "friction, <small>s a day</small>",
        "driver, <small>s a day</small>",
        "follower, <small>s a day</small>",
        "exponent of <br>friction",
        "half the <br>friction",
    ];
    let caption = "What changes the rate. Four columns give, to first order, the seconds that the timer gains in a day \
                   (or loses, with a minus) if the torque, the friction, or the inertia of driver or follower is one \
                   per cent larger. The mean speed is proportional to a power of the friction, whose exponent is in \
                   the next column. The last column says how much faster the timer runs with half the friction. The \
                   mechanisms are ideal, with the inertias of the thesis's runs. The values are the same for a spring \
                   of any strength";
    table(caption, Cells::NamedNumbers, &head, rows)
}

/// Mean speed with half the friction over that with all of it.
pub fn oiled(own: &Parameters) -> anyhow::Result<f64> {
    let oiled = Parameters::new(own.mechanism(), own.inertias(), own.torque(), own.friction() / 2.0)?;
    let speed = |of: &Parameters| Ok::<_, anyhow::Error>(Engagement::new(of)?.steady_state()?.mean_speed);
    Ok(speed(&oiled)? / speed(own)?)
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
            signed(found.jump / 1e3, 1),
            signed(found.normal_moment.value / row.torque(), 1),
        ])
    });
    let head = [
        "run",
        "driver",
        "driver <br>at",
        "follower",
        "follower <br>at",
        "follower's <br>jump",
        "pin force, <small>× spring’s</small>",
    ];
    let caption = "Accelerations of the greatest magnitude, in 1000 rad/s², each with the driver's angle from the line \
                   of centres. Then follow the jump of the follower's acceleration when the next pin takes over, and \
                   the greatest force on the pin, divided by the spring's force at the crank radius. The mechanisms \
                   are ideal. For each friction the table shows the run of the thesis with the strongest spring";
    table(caption, Cells::NamedNumbers, &head, rows)
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
            format!("{:.1}", steady.mean_speed),
            format!("{:.2}", steady.mean_of_extremes() / steady.mean_speed),
        ])
    });
    let head =
        ["run", "printed <br>extremes", "right <br>extremes", "over a <br>revolution", "too great <br>by the factor"];
    let caption = "Two meanings of an average speed, in rad/s. One is the mean of peak and minimum, from the numbers \
                   that the thesis prints and from the right numbers. The other is the mean over a revolution. The \
                   factor is the right mean of peak and minimum divided by the mean over a revolution. For each \
                   mechanism and friction the table shows the run with the weakest spring";
    table(caption, Cells::NamedNumbers, &head, rows)
}

fn name(row: &Row) -> String {
    format!("{} pins, μ&nbsp;=&nbsp;{}", row.mechanism.pins(), row.printed(Column::Friction))
}

fn with_torque(row: &Row) -> String {
    format!("{}, K&nbsp;=&nbsp;{}", name(row), row.printed(Column::Torque))
}
