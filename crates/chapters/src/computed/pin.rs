//! Of the pin in the slot: the wheel's acceleration at the instant of the problem, and the answers to the exercises.

use super::{Number, degrees, with_unit};
use anyhow::Context;
use geneva_documents::pin::Instant;
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_triangle::TriangleSolution;
use geneva_kinematics::wheel::{Wheel, acceleration_ratio};

/// The numbers of the chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("pin.acceleration", || acceleration(&Instant::printed()?)),
    ("pin.peak-speed", || {
        let driver = Instant::printed()?.driver_speed;
        Ok(with_unit(Wheel::new(4)?.peak_velocity() * driver, 3, "rad/s"))
    }),
    ("pin.peak-acceleration", || {
        let driver = Instant::printed()?.driver_speed;
        Ok(with_unit(Wheel::new(4)?.acceleration_peak().ratio * driver * driver, 3, "rad/s²"))
    }),
    ("pin.entry-acceleration", || {
        let half = Instant::printed()?.mechanism.engagement_half_angle();
        acceleration(&at(4, 180.0 - half.to_degrees())?)
    }),
    ("pin.165.radius", || later(|of| with_unit(of.slot_radius, 3, "mm"))),
    ("pin.165.slot-angle", || later(|of| degrees(of.angle_at_pivot))),
    ("pin.165.velocity-angle", || later(|of| degrees(of.velocity_angle))),
    ("pin.165.slot-point-speed", || later(|of| with_unit(of.slot_point_speed, 3, "mm/s"))),
    ("pin.165.sliding-speed", || later(|of| with_unit(of.sliding_speed, 3, "mm/s"))),
    ("pin.165.wheel-speed", || later(|of| with_unit(of.follower_speed, 3, "rad/s"))),
    ("pin.165.acceleration", || acceleration(&at(4, LATER)?)),
    ("pin.six.radius", || with_six(|of| with_unit(of.slot_radius, 3, "mm"))),
    ("pin.six.slot-angle", || with_six(|of| degrees(of.angle_at_pivot))),
    ("pin.six.velocity-angle", || with_six(|of| degrees(of.velocity_angle))),
    ("pin.six.slot-point-speed", || with_six(|of| with_unit(of.slot_point_speed, 3, "mm/s"))),
    ("pin.six.sliding-speed", || with_six(|of| with_unit(of.sliding_speed, 3, "mm/s"))),
    ("pin.six.wheel-speed", || with_six(|of| with_unit(of.follower_speed, 3, "rad/s"))),
];

/// The crank angle φ of the first exercise, in degrees.
const LATER: f64 = 165.0;

/// The wheel of so many stations with the crank and the driver of the problem, at a crank angle φ in degrees.
fn at(stations: u32, crank: f64) -> anyhow::Result<Instant> {
    let printed = Instant::printed()?;
    let mechanism = Wheel::new(stations)?.pin_and_slot(printed.mechanism.crank_radius())?;
    Ok(Instant { mechanism, crank: Turn::from_degrees(crank), driver_speed: printed.driver_speed })
}

fn later(write: fn(&TriangleSolution) -> String) -> anyhow::Result<String> {
    Ok(write(&at(4, LATER)?.by_triangle()))
}

fn with_six(write: fn(&TriangleSolution) -> String) -> anyhow::Result<String> {
    let crank = Instant::printed()?.crank.degrees();
    Ok(write(&at(6, crank)?.by_triangle()))
}

/// The wheel's angular acceleration, positive where it speeds up.
///
/// By the formula, if the pin's place differentiated twice says the same; an error else.
fn acceleration(at: &Instant) -> anyhow::Result<String> {
    use geneva_kinematics::quick_return::{Drive, series};
    let (radius, distance) = (at.mechanism.crank_radius(), at.mechanism.centre_distance());
    let squared = at.driver_speed * at.driver_speed;
    // θ decreases while the driver turns counter-clockwise.
    let by_formula = -acceleration_ratio(&at.mechanism.ratio(), &at.crank.supplement()) * squared;
    let rates = series::polar_rates(&distance, &radius, &at.crank, &Drive::steady(at.driver_speed));
    // The wheel turns clockwise.
    let by_series = -rates.context("the pin is on the pivot")?.angular_acceleration;
    anyhow::ensure!(
        (by_formula - by_series).abs() <= 1e-11 * squared,
        "{by_formula} by formula, {by_series} by series"
    );
    Ok(with_unit(by_formula, 3, "rad/s²"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_answers_of_the_exercises_are_on_the_series_of_the_figure() {
        let printed = Instant::printed().expect("a mechanism");
        let figure =
            geneva_figures::pin::over_the_engagement(&printed.mechanism, &printed.crank, printed.driver_speed, "mm");
        // The problem counts its angle from the other side of the driver's axis.
        let row = figure.series.rows.iter().find(|row| (row[0] + 180.0 - LATER).abs() < 1e-9).expect("each degree");
        assert_eq!(
            with_unit(row[1], 3, "rad/s"),
            later(|of| with_unit(of.follower_speed, 3, "rad/s")).expect("a number")
        );
        assert_eq!(with_unit(row[2], 3, "rad/s²"), acceleration(&at(4, LATER).expect("an instant")).expect("a number"));
        assert_eq!(with_unit(row[3], 3, "mm/s"), later(|of| with_unit(of.sliding_speed, 3, "mm/s")).expect("a number"));
    }
}
