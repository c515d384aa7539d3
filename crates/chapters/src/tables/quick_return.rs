//! The quick-return mechanism's vectors with their directions and senses, and what other readings would give.

use crate::questions::{field, question, value};
use anyhow::Context;
use geneva_documents::quick_return::with_printed_angle;
use geneva_press::html::{Cells, Table, table};
use geneva_press::maths::formula;
use geneva_press::numbers::fixed;

/// Every velocity and acceleration of the printed instant: magnitude, direction, sense.
pub(super) fn terms() -> anyhow::Result<Table> {
    let lever = question("lever")?;
    let rows = VECTORS.into_iter().map(|(symbol, key)| {
        let (symbol, vector) = (formula(symbol, false)?, field(&lever, key)?);
        let Some(direction) = vector.direction() else {
            return Ok(vec![symbol, "0".to_owned(), "–".to_owned(), "none".to_owned()]);
        };
        let length = format!("{:.4}&nbsp;{}", value(&lever, key)?, vector.unit);
        Ok(vec![symbol, length, format!("{}°", fixed(direction, 2)), words(&lever, direction)?])
    });
    let head = ["Vector", "Magnitude", "Direction", "Sense"];
    let caption = "All vectors of the problem. Directions are angles, counted counter-clockwise from the line from the lever’s \
     pivot to the crank’s axis";
    table(caption, Cells::Words, &head, rows)
}

/// The printed data on the branch of the source, on the other one, and with the angle printed for the velocities.
pub(super) fn branches() -> anyhow::Result<Table> {
    let (far, near) = (question("lever")?, question("lever-near")?);
    let column = |lever: &str| -> anyhow::Result<[f64; 10]> {
        Ok([
            value(lever, "pin_distance_m")?,
            value(lever, "angle_at_pin_deg")?,
            across(lever, "lever_point_velocity_m_s")?,
            along(lever, "sliding_velocity_m_s")?,
            value(lever, "lever_speed_rad_s")?,
            along(lever, "lever_point_normal_acceleration_m_s2")?,
            across(lever, "coriolis_acceleration_m_s2")?,
            along(lever, "sliding_tangential_acceleration_m_s2")?,
            across(lever, "lever_point_tangential_acceleration_m_s2")?,
            value(lever, "lever_acceleration_rad_s2")?,
        ])
    };
    let printed = with_printed_angle();
    let with_printed_angle = [
        value(&far, "pin_distance_m")?,
        value(&far, "crank_angle_deg")?,
        printed.lever_point_speed,
        -printed.sliding_speed,
        printed.lever_speed,
        -printed.lever_normal,
        -printed.coriolis,
        -printed.sliding_acceleration,
        -printed.lever_tangential,
        -printed.lever_acceleration,
    ];
    let (far, near) = (column(&far)?, column(&near)?);
    let names = [
        ("r", "in m"),
        (r"\beta", "in degrees"),
        ("v_4", "in m/s, across"),
        (r"v_\mathrm{rel}", "in m/s, along"),
        (r"\dot\varphi", "in rad/s"),
        (r"a_4^\mathrm{n}", "in m/s², along"),
        (r"a_\mathrm{Cor}", "in m/s², across"),
        (r"a_\mathrm{rel}^\mathrm{t}", "in m/s², along"),
        (r"a_4^\mathrm{t}", "in m/s², across"),
        (r"\ddot\varphi", "in rad/s²"),
    ];
    let rows = names.into_iter().enumerate().map(|(at, (symbol, unit))| {
        let mut row = vec![format!("{} {unit}", formula(symbol, false)?)];
        row.extend([far[at], near[at], with_printed_angle[at]].map(|value| fixed(value, 4)));
        Ok(row)
    });
    let head = ["Quantity", "Far point", "Near point", "With the misprinted angle"];
    table(
        "The problem solved at both points of the crank’s circle, and with the misprinted angle",
        Cells::NamedNumbers,
        &head,
        rows,
    )
}

/// Symbols and keys of three velocities, then of the seven terms of the acceleration.
const VECTORS: [(&str, &str); 10] = [
    (r"\vec{v}_2", "pin_velocity_m_s"),
    (r"\vec{v}_4", "lever_point_velocity_m_s"),
    (r"\vec{v}_\mathrm{rel}", "sliding_velocity_m_s"),
    (r"\vec{a}_2^\mathrm{n}", "pin_normal_acceleration_m_s2"),
    (r"\vec{a}_2^\mathrm{t}", "pin_tangential_acceleration_m_s2"),
    (r"\vec{a}_4^\mathrm{n}", "lever_point_normal_acceleration_m_s2"),
    (r"\vec{a}_4^\mathrm{t}", "lever_point_tangential_acceleration_m_s2"),
    (r"\vec{a}_\mathrm{rel}^\mathrm{n}", "sliding_normal_acceleration_m_s2"),
    (r"\vec{a}_\mathrm{rel}^\mathrm{t}", "sliding_tangential_acceleration_m_s2"),
    (r"\vec{a}_\mathrm{Cor}", "coriolis_acceleration_m_s2"),
];

/// A vector along the lever: its size, outwards positive.
fn along(lever: &str, key: &str) -> anyhow::Result<f64> {
    signed(lever, key, 0.0)
}

/// A vector across the lever: its size, counter-clockwise positive.
fn across(lever: &str, key: &str) -> anyhow::Result<f64> {
    signed(lever, key, 90.0)
}

/// The size of a vector, positive in a direction that is so many degrees from the lever's, negative against it.
fn signed(lever: &str, key: &str, from_lever: f64) -> anyhow::Result<f64> {
    let (size, angle) = (value(lever, key)?, value(lever, "lever_angle_deg")?);
    let direction = field(lever, key)?.direction().with_context(|| format!("`{key}` is zero"))?;
    Ok(if turned(angle + from_lever, direction).abs() < 90.0 { size } else { -size })
}

/// From one direction to another, from −180° to 180°.
fn turned(from: f64, to: f64) -> f64 {
    (to - from + 180.0).rem_euclid(360.0) - 180.0
}

/// The sense of a vector that is along the lever or the crank, or across one of them.
fn words(lever: &str, direction: f64) -> anyhow::Result<String> {
    /// Degrees that are none but for rounding.
    const NOTHING: f64 = 1e-6;
    for (name, key, centre) in
        [("lever", "lever_angle_deg", "the lever’s pivot"), ("crank", "crank_angle_deg", "the crank’s axis")]
    {
        let turned = turned(value(lever, key)?, direction);
        let is = |degrees: f64| (turned - degrees).abs() <= NOTHING;
        if is(0.0) || is(180.0) || is(-180.0) {
            let to = if is(0.0) { "away from" } else { "towards" };
            return Ok(format!("along the {name}, {to} {centre}"));
        }
        if is(90.0) || is(-90.0) {
            let sense = if is(90.0) { "counter-clockwise" } else { "clockwise" };
            return Ok(format!("across the {name}, {sense}"));
        }
    }
    Ok("neither along nor across".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sense_is_told_in_each_direction() {
        let lever = question("lever").expect("a question");
        let of = |key: &str, degrees: f64| {
            words(&lever, value(&lever, key).expect("an angle") + degrees).expect("words").replace('’', "'")
        };
        for (key, name, centre) in
            [("lever_angle_deg", "lever", "the lever's pivot"), ("crank_angle_deg", "crank", "the crank's axis")]
        {
            assert_eq!(of(key, 0.0), format!("along the {name}, away from {centre}"));
            for turned in [180.0, -180.0, 540.0] {
                assert_eq!(of(key, turned), format!("along the {name}, towards {centre}"));
            }
            assert_eq!(of(key, 90.0), format!("across the {name}, counter-clockwise"));
            assert_eq!(of(key, 270.0), format!("across the {name}, clockwise"));
        }
        assert_eq!(of("lever_angle_deg", 45.0), "neither along nor across");
    }
}
