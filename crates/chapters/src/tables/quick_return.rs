//! The quick-return mechanism's vectors with their directions and senses, and what other readings would give.

use crate::questions::{field, question, value};
use anyhow::Context;
use geneva_documents::quick_return::with_printed_angle;
use geneva_press::maths::formula;
use geneva_press::numbers::fixed;
use geneva_press::table::{Cells, Table};

/// Every velocity and acceleration of the printed instant: magnitude, direction, sense.
pub(super) fn terms() -> anyhow::Result<Table> {
    let lever = question("lever")?;
    let directed = VECTORS.map(|(symbol, key)| Ok((symbol, key, field(&lever, key)?)));
    let directed = directed.into_iter().collect::<anyhow::Result<Vec<_>>>()?;
    Table::with_rows(Cells::Words, directed)
        .column("Vector", |(symbol, ..)| formula(symbol, false))
        .column("Magnitude", |(_, key, vector)| match vector.direction() {
            Some(_) => Ok(format!("{:.4}&nbsp;{}", value(&lever, key)?, vector.unit)),
            None => Ok("0".to_owned()),
        })
        .column("Direction", |(.., vector)| {
            vector.direction().map_or_else(|| "–".to_owned(), |direction| format!("{}°", fixed(direction, 2)))
        })
        .column("Sense", |(.., vector)| match vector.direction() {
            Some(direction) => words(&lever, direction),
            None => Ok("none".to_owned()),
        })
        .finish()
}

/// The printed data on the branch of the source, on the other one, and with the angle printed for the velocities.
pub(super) fn branches() -> anyhow::Result<Table> {
    let (far, near) = (question("lever")?, question("lever-near")?);
    let printed = with_printed_angle();
    // Symbol, unit, the number on a branch, and with the printed angle.
    let quantities: [(&str, &str, Reading, f64); 10] = [
        ("r", "in m", Reading::Number("pin_distance_m"), value(&far, "pin_distance_m")?),
        (r"\beta", "in degrees", Reading::Number("angle_at_pin_deg"), value(&far, "crank_angle_deg")?),
        ("v_4", "in m/s, across", Reading::Across("lever_point_velocity_m_s"), printed.lever_point_speed),
        (r"v_\mathrm{rel}", "in m/s, along", Reading::Along("sliding_velocity_m_s"), -printed.sliding_speed),
        (r"\dot\varphi", "in rad/s", Reading::Number("lever_speed_rad_s"), printed.lever_speed),
        (
            r"a_4^\mathrm{n}",
            "in m/s², along",
            Reading::Along("lever_point_normal_acceleration_m_s2"),
            -printed.lever_normal,
        ),
        (r"a_\mathrm{Cor}", "in m/s², across", Reading::Across("coriolis_acceleration_m_s2"), -printed.coriolis),
        (
            r"a_\mathrm{rel}^\mathrm{t}",
            "in m/s², along",
            Reading::Along("sliding_tangential_acceleration_m_s2"),
            -printed.sliding_acceleration,
        ),
        (
            r"a_4^\mathrm{t}",
            "in m/s², across",
            Reading::Across("lever_point_tangential_acceleration_m_s2"),
            -printed.lever_tangential,
        ),
        (r"\ddot\varphi", "in rad/s²", Reading::Number("lever_acceleration_rad_s2"), -printed.lever_acceleration),
    ];
    Table::with_rows(Cells::NamedNumbers, quantities)
        .column("Quantity", |(symbol, unit, ..)| Ok(format!("{} {unit}", formula(symbol, false)?)))
        .column("Far point", |(_, _, reading, _)| Ok(fixed(reading.of(&far)?, 4)))
        .column("Near point", |(_, _, reading, _)| Ok(fixed(reading.of(&near)?, 4)))
        .column("With the misprinted angle", |(.., misprinted)| fixed(*misprinted, 4))
        .finish()
}

/// How a number of an answer is read, by its key.
enum Reading {
    /// As it is.
    Number(&'static str),
    /// The size of a vector along the lever, outwards positive.
    Along(&'static str),
    /// The size of a vector across the lever, counter-clockwise positive.
    Across(&'static str),
}

impl Reading {
    /// The number in the answer to a question.
    fn of(&self, lever: &str) -> anyhow::Result<f64> {
        match self {
            Self::Number(key) => value(lever, key),
            Self::Along(key) => signed(lever, key, 0.0),
            Self::Across(key) => signed(lever, key, 90.0),
        }
    }
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
