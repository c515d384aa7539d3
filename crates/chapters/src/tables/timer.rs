//! A clockmaker's questions: settling, sensitivity, accelerations and mean speed of the thesis's mechanisms.

use crate::rows::{example, number, number_with};
use geneva_case1973::{Column, Row, strongest, weakest};
use geneva_documents::meyer::runs::table::rows;
use geneva_press::html::{Cells, Table, table};
use geneva_press::numbers::signed;

/// The followers compared: parts of the inertia of the example's.
pub const PARTS: [f64; 7] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];

/// A number of a row's mechanism with so many times less inertia of its follower.
pub fn lighter(row: &Row, part: f64, key: &str) -> anyhow::Result<f64> {
    number_with(row, |question| question.follower_inertia /= part, key)
}

/// How soon four pins come to the steady motion, with followers of another size, by three measures.
pub fn settling() -> anyhow::Result<Table> {
    let row = example()?;
    let rows = PARTS.map(|part| {
        let of = |key| lighter(row, part, key);
        let name = if part > 1.0 { format!("1/{part}") } else { "as run".to_owned() };
        Ok(vec![
            name,
            format!("{:.2}", of("inertia_ratio")?),
            format!("{:.3}", of("multiplier")?),
            format!("{:.1}", of("small_difference_engagements")?),
            format!("{:.1}", 1e3 * of("period")?),
            format!("{:.1}", 1e3 * of("small_difference_rise_time")?),
            format!("{:.1}", 1e3 * of("profile_rise_time")?),
            format!("{:.1}", 1e3 * of("average_rise_time")?),
        ])
    });
    let head = [
        "follower's inertia",
        "inertia, driver <br>over follower",
        "multiplier",
        "engagements <br>to 1 %",
        "period, <small>ms</small>",
        "time to 1 %, <small>ms</small>",
        "rise time, <br>profile, <small>ms</small>",
        "rise time, <br>average, <small>ms</small>",
    ];
    let caption = format!(
        "The rise with a lighter follower: {}, with only the follower's inertia changed. The multiplier is the \
         fraction of a small difference in the squared speed that is left after one engagement. The columns “to 1 %” \
         give the number of engagements and the time in which this difference falls to one per cent. The last two \
         columns give the rise time from rest, by the profile and by the average",
        with_torque(row).replace("&nbsp;", " ") + " in lb"
    );
    table(&caption, Cells::NamedNumbers, &head, rows)
}

/// What one per cent of each quantity makes in a day, and what half the friction does.
pub fn sensitivity() -> anyhow::Result<Table> {
    let rows = weakest(rows()).map(|row| {
        let rates = [
            "torque_rate_s_a_day",
            "friction_rate_s_a_day",
            "driver_inertia_rate_s_a_day",
            "follower_inertia_rate_s_a_day",
        ];
        let rates = rates.map(|rate| Ok(signed(number(row, rate)?, 0)));
        let mut cells = vec![name(row)];
        cells.extend(rates.into_iter().collect::<anyhow::Result<Vec<_>>>()?);
        cells.push(signed(number(row, "friction_power")?, 3));
        cells.push(signed(100.0 * number(row, "half_friction_gain")?, 0) + "&nbsp;%");
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
                   per cent larger. For small changes the mean speed is proportional to a power of the friction, whose \
                   exponent is in the next column. The last column says how much faster the timer runs with half the \
                   friction. The mechanisms are ideal, with the inertias of the thesis's runs. The values are the same \
                   for a spring of any strength";
    table(caption, Cells::NamedNumbers, &head, rows)
}

/// The greatest accelerations and forces of the strongest run of each mechanism and friction.
pub fn accelerations() -> anyhow::Result<Table> {
    let rows = strongest(rows()).map(|row| {
        let of = |key| number(row, key);
        let degrees = |key| Ok::<_, anyhow::Error>(signed(of(key)?, 1) + "°");
        Ok(vec![
            with_torque(row),
            signed(of("driver_acceleration")? / 1e3, 1),
            degrees("driver_acceleration_angle_deg")?,
            signed(of("follower_acceleration")? / 1e3, 1),
            degrees("follower_acceleration_angle_deg")?,
            signed(of("follower_acceleration_jump")? / 1e3, 1),
            signed(of("pin_force_ratio")?, 1),
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
                   of centres. The last two columns give the jump of the follower's acceleration when the next pin \
                   takes over, and the greatest force on the pin, divided by the spring's force at the crank radius. \
                   The mechanisms are ideal. For each friction value, the table shows the thesis's run with the \
                   strongest spring";
    table(caption, Cells::NamedNumbers, &head, rows)
}

/// The average of the thesis beside the mean speed over a revolution.
pub fn mean_speed() -> anyhow::Result<Table> {
    let rows = weakest(rows()).map(|row| {
        let [of_extremes, mean] = [number(row, "mean_of_extremes")?, number(row, "mean_speed")?];
        let printed = (row.number(Column::Peak) + row.number(Column::Minimum)) / 2.0;
        Ok(vec![
            with_torque(row),
            format!("{printed:.1}"),
            format!("{of_extremes:.1}"),
            format!("{mean:.1}"),
            format!("{:.2}", of_extremes / mean),
        ])
    });
    let head =
        ["run", "printed <br>extremes", "right <br>extremes", "over a <br>revolution", "too great <br>by the factor"];
    let caption = "Two meanings of an average speed, in rad/s. One is the mean of peak and minimum, first from \
                   the numbers that the thesis prints, then from the right ones, which we computed for the mechanism. \
                   The other is the mean over a revolution. The factor is the mean of the right extremes divided by \
                   the mean over a revolution. For each mechanism and friction value, the table shows the run with \
                   the weakest spring";
    table(caption, Cells::NamedNumbers, &head, rows)
}

fn name(row: &Row) -> String {
    format!("{} pins, μ&nbsp;=&nbsp;{}", row.mechanism.pins(), row.printed(Column::Friction))
}

fn with_torque(row: &Row) -> String {
    format!("{}, K&nbsp;=&nbsp;{}", name(row), row.printed(Column::Torque))
}
