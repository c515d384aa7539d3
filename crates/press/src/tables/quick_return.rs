//! The quick-return mechanism's vectors with their directions and senses, and what other readings would give.

use crate::html::{Cells, Table, table};
use crate::maths::formula;
use crate::numbers::fixed;
use anyhow::Context;
use geneva_kinematics::Turn;
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::quick_return::{Branch, Motion};
use geneva_ledger::quick_return::{Instant, with_printed_angle};
use nalgebra::Vector2;

/// A part of a vector that is zero but for rounding, relative to the vector.
const NOTHING: f64 = 1e-9;

/// Every velocity and acceleration of the printed instant: magnitude, direction, sense.
pub fn terms() -> anyhow::Result<Table> {
    let motion = Instant::printed()?.by_diagrams().context("the pin is on the pivot")?;
    let rows = vectors(&motion).into_iter().map(|(symbol, unit, vector)| {
        let symbol = formula(symbol, false)?;
        Ok(if vector.norm() == 0.0 {
            vec![symbol, "0".to_owned(), "–".to_owned(), "none".to_owned()]
        } else {
            let length = format!("{:.4}&nbsp;{unit}", vector.norm());
            vec![symbol, length, format!("{}°", fixed(direction(&vector), 2)), words(&vector, &motion)]
        })
    });
    let head = ["Vector", "Magnitude", "Direction", "Sense"];
    let caption = "All vectors of the problem. Directions are angles, counted counter-clockwise from the line from the lever’s \
     pivot to the crank’s axis";
    table(caption, Cells::Words, &head, rows)
}

/// The printed data on the branch of the source, on the other one, and with the angle printed for the velocities.
pub fn branches() -> anyhow::Result<Table> {
    let [far, near] = [Branch::Far, Branch::Near].map(Instant::on);
    let (far, near) = (far?, near?);
    let with_printed_angle = with_printed_angle();
    let columns = [&far, &near].map(|instant| -> anyhow::Result<[f64; 10]> {
        let motion = instant.by_diagrams().context("the pin is on the pivot")?;
        let along = motion.velocities.position.normalize();
        let across = quarter_turn(&along);
        let terms = &motion.accelerations;
        Ok([
            instant.position.pin_distance,
            instant.position.angle_at_pin().to_degrees(),
            motion.velocities.slot_point_velocity.dot(&across),
            motion.velocities.sliding_velocity.dot(&along),
            motion.velocities.follower_speed,
            terms.follower_normal.dot(&along),
            terms.coriolis.dot(&across),
            terms.sliding_tangential.dot(&along),
            terms.follower_tangential.dot(&across),
            terms.follower_acceleration,
        ])
    });
    let [far_column, near_column] = columns;
    let (far_column, near_column) = (far_column?, near_column?);
    let with_printed_angle = [
        far.position.pin_distance,
        far.position.crank.degrees(),
        with_printed_angle.lever_point_speed,
        -with_printed_angle.sliding_speed,
        with_printed_angle.lever_speed,
        -with_printed_angle.lever_normal,
        -with_printed_angle.coriolis,
        -with_printed_angle.sliding_acceleration,
        -with_printed_angle.lever_tangential,
        -with_printed_angle.lever_acceleration,
    ];
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
        row.extend([far_column[at], near_column[at], with_printed_angle[at]].map(|value| fixed(value, 4)));
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

/// Symbol, unit and vector: three velocities, then the seven terms of the acceleration.
fn vectors(motion: &Motion<f64>) -> [(&'static str, &'static str, Vector2<f64>); 10] {
    let (velocities, terms) = (&motion.velocities, &motion.accelerations);
    let (speed, acceleration) = ("m/s", "m/s²");
    [
        (r"\vec{v}_2", speed, velocities.pin_velocity),
        (r"\vec{v}_4", speed, velocities.slot_point_velocity),
        (r"\vec{v}_\mathrm{rel}", speed, velocities.sliding_velocity),
        (r"\vec{a}_2^\mathrm{n}", acceleration, motion.pin_normal),
        (r"\vec{a}_2^\mathrm{t}", acceleration, motion.pin_tangential),
        (r"\vec{a}_4^\mathrm{n}", acceleration, terms.follower_normal),
        (r"\vec{a}_4^\mathrm{t}", acceleration, terms.follower_tangential),
        (r"\vec{a}_\mathrm{rel}^\mathrm{n}", acceleration, terms.sliding_normal),
        (r"\vec{a}_\mathrm{rel}^\mathrm{t}", acceleration, terms.sliding_tangential),
        (r"\vec{a}_\mathrm{Cor}", acceleration, terms.coriolis),
    ]
}

/// Degrees counter-clockwise from the direction lever pivot → crank axis, in (−180°, 180°].
fn direction(vector: &Vector2<f64>) -> f64 {
    Turn { cos: vector.x, sin: vector.y }.degrees()
}

/// The sense of a vector that is along the lever or the crank, or across one of them.
fn words(vector: &Vector2<f64>, motion: &Motion<f64>) -> String {
    let is_zero = |part: f64, other: &Vector2<f64>| part.abs() <= NOTHING * vector.norm() * other.norm();
    for (name, place, centre) in
        [("lever", &motion.velocities.position, "the lever’s pivot"), ("crank", &motion.crank, "the crank’s axis")]
    {
        let (along, across) = (vector.dot(place), vector.dot(&quarter_turn(place)));
        if is_zero(across, place) {
            let to = if along < 0.0 { "towards" } else { "away from" };
            return format!("along the {name}, {to} {centre}");
        }
        if is_zero(along, place) {
            let sense = if across > 0.0 { "counter-clockwise" } else { "clockwise" };
            return format!("across the {name}, {sense}");
        }
    }
    "neither along nor across".to_owned()
}
