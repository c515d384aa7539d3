//! A clockmaker's questions: settling, sensitivity, accelerations and mean speed of the thesis's mechanisms.

use crate::rows::{example, number, number_with};
use geneva_case1973::{Column, Row, strongest, weakest};
use geneva_documents::meyer::runs::table::rows;
use geneva_press::numbers::signed;
use geneva_press::table::{Cells, Table};

/// The followers compared: parts of the inertia of the example's.
pub const PARTS: [f64; 7] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];

/// A number of a row's mechanism with so many times less inertia of its follower.
pub fn lighter(row: &Row, part: f64, key: &str) -> anyhow::Result<f64> {
    number_with(row, |question| question.follower_inertia /= part, key)
}

/// How soon four pins come to the steady motion, with followers of another size, by three measures.
pub fn settling() -> anyhow::Result<Table> {
    let row = example()?;
    let cell = |part: &f64, (_, key, scale, digits): &(&str, &str, f64, usize)| {
        Ok(format!("{:.digits$}", scale * lighter(row, *part, key)?))
    };
    let columns = [
        ("inertia, driver <br>over follower", "inertia_ratio", 1.0, 2),
        ("multiplier", "multiplier", 1.0, 3),
        ("engagements <br>to 1 %", "small_difference_engagements", 1.0, 1),
        ("period, <small>ms</small>", "period", 1e3, 1),
        ("time to 1 %, <small>ms</small>", "small_difference_rise_time", 1e3, 1),
        ("rise time, <br>profile, <small>ms</small>", "profile_rise_time", 1e3, 1),
        ("rise time, <br>average, <small>ms</small>", "average_rise_time", 1e3, 1),
    ];
    Table::with_rows(Cells::NamedNumbers, PARTS)
        .column("follower's inertia", |part| if *part > 1.0 { format!("1/{part}") } else { "as run".to_owned() })
        .columns(columns, |(head, ..)| (*head).to_owned(), cell)
        .finish()
}

/// What one per cent of each quantity makes in a day, and what half the friction does.
pub fn sensitivity() -> anyhow::Result<Table> {
    let rates = [
        ("torque", "torque_rate_s_a_day"),
        ("friction", "friction_rate_s_a_day"),
        ("driver", "driver_inertia_rate_s_a_day"),
        ("follower", "follower_inertia_rate_s_a_day"),
    ];
    Table::with_rows(Cells::NamedNumbers, weakest(rows()))
        .column("mechanism", |row| name(row))
        .columns(
            rates,
            |(of, _)| format!("{of}, <small>s a day</small>"),
            |row, (_, key)| Ok(signed(number(row, key)?, 0)),
        )
        .column("exponent of <br>friction", |row| Ok(signed(number(row, "friction_power")?, 3)))
        .column("half the <br>friction", |row| Ok(signed(100.0 * number(row, "half_friction_gain")?, 0) + "&nbsp;%"))
        .finish()
}

/// The greatest accelerations and forces of the strongest run of each mechanism and friction.
pub fn accelerations() -> anyhow::Result<Table> {
    let thousands = |row: &Row, key| Ok(signed(number(row, key)? / 1e3, 1));
    let degrees = |row: &Row, key| Ok(signed(number(row, key)?, 1) + "°");
    Table::with_rows(Cells::NamedNumbers, strongest(rows()))
        .column("run", |row| with_torque(row))
        .column("driver", |row| thousands(row, "driver_acceleration"))
        .column("driver <br>at", |row| degrees(row, "driver_acceleration_angle_deg"))
        .column("follower", |row| thousands(row, "follower_acceleration"))
        .column("follower <br>at", |row| degrees(row, "follower_acceleration_angle_deg"))
        .column("follower's <br>jump", |row| thousands(row, "follower_acceleration_jump"))
        .column("pin force, <small>× spring’s</small>", |row| Ok(signed(number(row, "pin_force_ratio")?, 1)))
        .finish()
}

/// The average of the thesis beside the mean speed over a revolution.
pub fn mean_speed() -> anyhow::Result<Table> {
    let printed = |row: &Row| (row.number(Column::Peak) + row.number(Column::Minimum)) / 2.0;
    Table::with_rows(Cells::NamedNumbers, weakest(rows()))
        .column("run", |row| with_torque(row))
        .column("printed <br>extremes", |row| format!("{:.1}", printed(row)))
        .column("right <br>extremes", |row| Ok(format!("{:.1}", number(row, "mean_of_extremes")?)))
        .column("over a <br>revolution", |row| Ok(format!("{:.1}", number(row, "mean_speed")?)))
        .column("too great <br>by the factor", |row| {
            Ok(format!("{:.2}", number(row, "mean_of_extremes")? / number(row, "mean_speed")?))
        })
        .finish()
}

fn name(row: &Row) -> String {
    format!("{} pins, μ&nbsp;=&nbsp;{}", row.mechanism.pins(), row.printed(Column::Friction))
}

/// The mechanism, friction and torque of a run.
pub fn with_torque(row: &Row) -> String {
    format!("{}, K&nbsp;=&nbsp;{}", name(row), row.printed(Column::Torque))
}
