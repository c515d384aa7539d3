//! Of the pin in the slot: the wheel's acceleration at the instant of the problem, and the answers to the exercises.

use super::kinds::{SERIES, TRIANGLE, VECTORS};
use super::second_routes::contact::{Stance, dot, moment};
use anyhow::Context;
use geneva_documents::pin::PinProblem;
use geneva_evidence::{Evidence, Form, Numbers, OwnNumber};
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_triangle::TriangleSolution;
use geneva_kinematics::quick_return::{Drive, series};
use geneva_kinematics::wheel::{Wheel, acceleration_ratio};
use std::f64::consts::PI;

/// The numbers of the chapter.
pub(super) fn numbers() -> Vec<OwnNumber> {
    let speed = Form::Text("{3}&nbsp;rad/s");
    let lengths = [Form::Text("{3}&nbsp;mm"), Form::Text("{3}&nbsp;mm/s")];
    let degrees = Form::Text("{.1}°");
    vec![
        acceleration("pin.acceleration", PinProblem::printed),
        OwnNumber::new("pin.peak-speed", speed, Evidence::CLOSED_FORM, || {
            Ok(Wheel::new(4)?.peak_velocity() * PinProblem::printed()?.driver_speed)
        })
        .with_second_route("the wheel is more than twice as fast", VECTORS, || {
            Ok(stance(4, 0.0).ratio * PinProblem::printed()?.driver_speed)
        }),
        OwnNumber::new("pin.peak-acceleration", ACCELERATION, Evidence::CLOSED_FORM, || {
            Ok(Wheel::new(4)?.acceleration_peak().ratio * PinProblem::printed()?.driver_speed.powi(2))
        })
        .with_second_route("later the acceleration is greater", VECTORS, || {
            Ok(greatest_bend(4) * PinProblem::printed()?.driver_speed.powi(2))
        }),
        acceleration("pin.entry-acceleration", || {
            let half = PinProblem::printed()?.mechanism.engagement_half_angle();
            wheel_at(4, 180.0 - half.to_degrees())
        }),
        later_measure("pin.165.radius", lengths[0], |of| of.slot_radius, |of| of[0]),
        later_measure("pin.165.slot-angle", degrees, |of| of.angle_at_pivot.to_degrees(), |of| of[1]),
        later_measure("pin.165.velocity-angle", degrees, |of| of.velocity_angle.to_degrees(), |of| of[2]),
        later_measure("pin.165.slot-point-speed", lengths[1], |of| of.slot_point_speed, |of| of[3]),
        later_measure("pin.165.sliding-speed", lengths[1], |of| of.sliding_speed, |of| of[4]),
        later_measure("pin.165.wheel-speed", speed, |of| of.follower_speed, |of| of[5]),
        acceleration("pin.165.acceleration", || wheel_at(4, LATER)),
        six_station_measure("pin.six.radius", lengths[0], |of| of.slot_radius, |of| of[0]),
        six_station_measure("pin.six.slot-angle", degrees, |of| of.angle_at_pivot.to_degrees(), |of| of[1]),
        six_station_measure("pin.six.velocity-angle", degrees, |of| of.velocity_angle.to_degrees(), |of| of[2]),
        six_station_measure("pin.six.slot-point-speed", lengths[1], |of| of.slot_point_speed, |of| of[3]),
        six_station_measure("pin.six.sliding-speed", lengths[1], |of| of.sliding_speed, |of| of[4]),
        six_station_measure("pin.six.wheel-speed", speed, |of| of.follower_speed, |of| of[5]),
    ]
}

const ACCELERATION: &str = "{3}&nbsp;rad/s²";

/// The crank angle φ of the first exercise, in degrees.
const LATER: f64 = 165.0;

/// The wheel of so many stations with the crank and the driver of the problem, at a crank angle φ in degrees.
fn wheel_at(stations: u32, crank: f64) -> Numbers<PinProblem> {
    let printed = PinProblem::printed()?;
    let mechanism = Wheel::new(stations)?.pin_and_slot(printed.mechanism.crank_radius())?;
    Ok(PinProblem { mechanism, crank: Turn::from_degrees(crank), driver_speed: printed.driver_speed })
}

/// Crank and slot of a wheel of so many stations in vectors, at an angle in radians from the line of centres.
fn stance(stations: u32, angle: f64) -> Stance {
    Stance::new(1.0 / (PI / f64::from(stations)).sin(), angle)
}

/// Measures of the triangle of axes and pin, and of the velocities: by the triangle's laws, and as [`measures`] has them.
type Measures = [f64; 6];

/// From vectors: the pin's distance from the wheel's axis, the angle there, and the angle between the pin's velocity and the slot,
/// in degrees; the speeds of the slot's point and of the sliding; and the wheel's speed.
fn measures(stations: u32, crank: f64) -> Numbers<Measures> {
    let printed = PinProblem::printed()?;
    let (size, speed) = (printed.mechanism.crank_radius(), printed.driver_speed);
    let Stance { velocity, radius, along, across, ratio, .. } = stance(stations, (180.0 - crank).to_radians());
    let [sliding, of_slot] = [along, across].map(|way| dot(velocity, way).abs());
    let to_driver = [-1.0, 0.0];
    let at_axis = moment(to_driver, along).abs().atan2(dot(to_driver, along));
    let lengths = [size * radius, at_axis.to_degrees(), of_slot.atan2(sliding).to_degrees()];
    let [a, b, c] = lengths;
    Ok([a, b, c, size * speed * of_slot, size * speed * sliding, speed * ratio])
}

/// A measure of the first exercise.
fn later_measure(
    id: &'static str,
    form: Form,
    of: fn(&TriangleSolution) -> f64,
    again: fn(Measures) -> f64,
) -> OwnNumber {
    OwnNumber::new(id, form, TRIANGLE, move || Ok(of(&wheel_at(4, LATER)?.by_triangle()))).with_second_route(
        "the answer to an exercise",
        VECTORS,
        move || Ok(again(measures(4, LATER)?)),
    )
}

/// The crank angle φ of the problem, in degrees.
fn crank() -> Numbers<f64> {
    Ok(PinProblem::printed()?.crank.degrees())
}

/// A measure of the exercise with six stations.
fn six_station_measure(
    id: &'static str,
    form: Form,
    of: fn(&TriangleSolution) -> f64,
    again: fn(Measures) -> f64,
) -> OwnNumber {
    OwnNumber::new(id, form, TRIANGLE, move || Ok(of(&wheel_at(6, crank()?)?.by_triangle()))).with_second_route(
        "the answer to an exercise",
        VECTORS,
        move || Ok(again(measures(6, crank()?)?)),
    )
}

/// The wheel's angular acceleration at an instant, positive where it speeds up: by the formula, and from the pin's place
/// differentiated twice.
fn acceleration<E>(id: &'static str, instant: fn() -> Result<PinProblem, E>) -> OwnNumber
where
    Box<dyn std::error::Error + Send + Sync>: From<E>,
    E: 'static,
{
    OwnNumber::new(id, ACCELERATION, Evidence::CLOSED_FORM, move || {
        let at = instant()?;
        // θ decreases while the driver turns counter-clockwise.
        Ok(-acceleration_ratio(&at.mechanism.ratio(), &at.crank.supplement()) * at.driver_speed * at.driver_speed)
    })
    .with_second_route("the wheel is accelerated so", SERIES, move || {
        let at = instant()?;
        let (radius, distance) = (at.mechanism.crank_radius(), at.mechanism.centre_distance());
        let rates = series::polar_rates(&distance, &radius, &at.crank, &Drive::steady(at.driver_speed));
        // The wheel turns clockwise.
        Ok(-rates.context("the pin is on the pivot")?.angular_acceleration)
    })
}

/// The greatest acceleration of the wheel over the square of the driver's speed, sought between entry and the line of centres.
fn greatest_bend(stations: u32) -> f64 {
    let bend = |angle: f64| stance(stations, angle).bend;
    let (mut low, mut high) = (PI / f64::from(stations) - PI / 2.0, 0.0);
    for _ in 0..100 {
        let [left, right] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
        if bend(left) < bend(right) { low = left } else { high = right }
    }
    bend(f64::midpoint(low, high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_press::numbers::significant;

    #[test]
    fn the_answers_of_the_exercises_are_on_the_series_of_the_figure() {
        let printed = PinProblem::printed().expect("a mechanism");
        let figure =
            geneva_figures::pin::over_the_engagement(&printed.mechanism, &printed.crank, printed.driver_speed, "mm");
        // The problem counts its angle from the other side of the driver's axis.
        let row = figure.series.rows.iter().find(|row| (row[0] + 180.0 - LATER).abs() < 1e-9).expect("each degree");
        let shown = |number: f64, unit: &str| format!("{}&nbsp;{unit}", significant(number, 3));
        let own = |name: &str| crate::computed::own_text(name).expect("a number");
        assert_eq!(shown(row[1], "rad/s"), own("pin.165.wheel-speed"));
        assert_eq!(shown(row[2], "rad/s²"), own("pin.165.acceleration"));
        assert_eq!(shown(row[3], "mm/s"), own("pin.165.sliding-speed"));
    }
}
