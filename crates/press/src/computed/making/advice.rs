//! Of the chapter on making a wheel: fits, tolerances of all sizes together, and cams for comparison.

use super::{Number, rounded_down, sizes, told};
use crate::numbers::fixed;
use anyhow::Context;
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{SharedTolerance, Wheel};
use std::f64::consts::PI;

/// The numbers of this chapter's advice.
pub const NUMBERS: &[(&str, Number)] = &[
    ("making.fit-3", || Ok(fit_told(3.0, 6.0))),
    ("making.fit-6", || Ok(fit_told(6.0, 10.0))),
    ("making.fit-10", || Ok(fit_told(10.0, 18.0))),
    ("making.fit-18", || Ok(fit_told(18.0, 30.0))),
    ("making.all.locking", || together(|of| of.locking)),
    ("making.all.nearer", || together(|of| of.nearer)),
    ("making.all.farther", || together(|of| of.farther)),
    ("making.all.crank", || together(|of| of.crank)),
    ("making.all.width", || together(|of| of.width)),
    ("making.all.direction-rim", || together(|of| of.direction * wheel_radius())),
    ("making.all.slot-end", || Ok(told(rounded_down(shared()?.slot_end)))),
    ("making.rms-share.3", || rms_share_told(3)),
    ("making.rms-share.4", || rms_share_told(4)),
    ("making.rms-share.5", || rms_share_told(5)),
    ("making.rms-share.6", || rms_share_told(6)),
    ("making.rms-share.8", || rms_share_told(8)),
    ("making.rms-share.10", || rms_share_told(10)),
    ("making.rms-share.12", || rms_share_told(12)),
    ("making.cam.four", || cam(4)),
    ("making.cam.six", || cam(6)),
    ("making.cam.eight", || cam(8)),
];

fn shared() -> anyhow::Result<SharedTolerance> {
    sizes()?.shared_tolerance().context("bores that leave something")
}

fn wheel_radius() -> f64 {
    sizes().map_or(f64::NAN, |sizes| sizes.wheel_radius)
}

/// What one size may be wrong by if all are, rounded down to a ten-thousandth of a millimetre.
fn together(of: fn(&SharedTolerance) -> f64) -> anyhow::Result<String> {
    Ok(format!("{}&nbsp;mm", fixed((of(&shared()?) * 1e4).floor() / 1e4, 4)))
}

/// Least and greatest play of the fit H8/e8 for diameters over one and up to another number of millimetres, in µm.
///
/// By the formulas of ISO 286-1 (first edition, 1988, annex A) for the geometric mean D of the range: the grade 8 has the
/// tolerance 25 i with i = 0.45 ∛D + 0.001 D, and a shaft e is thinner by 11 D^0.41 at least, both rounded. Hole and shaft have
/// one such tolerance each.
fn fit(over: f64, up_to: f64) -> [f64; 2] {
    let mean = (over * up_to).sqrt();
    let grade = (25.0 * (0.45 * libm::cbrt(mean) + 0.001 * mean)).round();
    let least = (11.0 * libm::pow(mean, 0.41)).round();
    [least, least + 2.0 * grade]
}

fn fit_told(over: f64, up_to: f64) -> String {
    let [least, most] = fit(over, up_to).map(|play| fixed(play / 1000.0, 3));
    format!("{least} to {most}&nbsp;mm")
}

/// Root mean square of the crank's torque over a turn, over its peak, dimensionless: without friction it depends on the numbers
/// of stations and pins alone.
fn rms_share(stations: u32) -> anyhow::Result<f64> {
    let wheel = Wheel::new(stations)?;
    let loads = WheelLoads::new(&wheel, 1.0, 0.0, 1.0)?;
    Ok(loads.rms_crank_torque() / loads.crank_torque().driving.value)
}

fn rms_share_told(stations: u32) -> anyhow::Result<String> {
    Ok(fixed(rms_share(stations)?, 3))
}

/// Greatest acceleration of the modified-sine law over the whole rise and the time of the rise squared, dimensionless: the
/// acceleration is a sine of the period 1/2 in the first and last eighth and of 3/2 between.
const MODIFIED_SINE: f64 = 4.0 * PI * PI / (4.0 + PI);

/// The greatest acceleration of a cam with that law over the wheel's, for the same step in the same time.
fn cam(stations: u32) -> anyhow::Result<String> {
    Ok(fixed(cam_ratio(stations)?, 2))
}

fn cam_ratio(stations: u32) -> anyhow::Result<f64> {
    let wheel = Wheel::new(stations)?;
    // Driver's turn in an index, and the wheel's, in radians.
    let (index, step) = (2.0 * PI * wheel.motion_fraction(), 2.0 * PI / f64::from(stations));
    Ok(MODIFIED_SINE * step / (index * index) / wheel.acceleration_peak().ratio)
}

#[cfg(test)]
mod tests {
    use super::super::sizes_of;
    use super::*;
    use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes};

    #[test]
    fn the_fits_are_those_of_the_standards_table() {
        let ranges = [(3.0, 6.0), (6.0, 10.0), (10.0, 18.0), (18.0, 30.0)].map(|(over, up_to)| fit(over, up_to));
        assert_eq!(ranges, [[20.0, 56.0], [25.0, 69.0], [32.0, 86.0], [40.0, 106.0]]);
        // The chapter says that the program's play is in the fit for its own pin and beyond it for a larger one.
        let sizes = sizes().expect("fits");
        assert!((6.0..10.0).contains(&sizes.pin_diameter) && (25.0..69.0).contains(&(1000.0 * sizes.play.slot)));
        let large = sizes_of("looser").expect("fits");
        assert!((18.0..30.0).contains(&large.pin_diameter) && 1000.0 * large.play.slot > 1.4 * 106.0);
    }

    #[test]
    fn without_friction_the_rms_torque_is_the_same_part_of_the_peak_at_any_inertia_and_speed() {
        for stations in [3, 6, 8, 12] {
            let wheel = Wheel::new(stations).expect("possible");
            let loads = WheelLoads::new(&wheel, 0.37, 0.0, 21.0).expect("possible");
            let share = loads.rms_crank_torque() / loads.crank_torque().driving.value;
            assert!((share / rms_share(stations).expect("one") - 1.0).abs() < 1e-9, "{stations}");
            // By many equal steps.
            let end = wheel.engagement_half_angle();
            let torque = |step: u32| {
                let motion = wheel.engaged(end * (f64::from(step) / 5e3 - 1.0)).expect("in the slot");
                motion.acceleration * motion.velocity
            };
            let all: Vec<f64> = (0..=10_000).map(torque).collect();
            let square = all.iter().map(|torque| torque * torque).sum::<f64>() * end / 5e3 / (2.0 * PI);
            let peak = all.iter().copied().fold(0.0, f64::max);
            assert!((square.sqrt() / peak / share - 1.0).abs() < 1e-4, "{stations}");
        }
    }

    #[test]
    fn a_cam_in_the_same_time_has_less_acceleration_with_few_stations_and_more_with_many() {
        // The law by its definition, integrated twice over a rise of one in the time one.
        let law = |time: f64| {
            let time = if time > 0.5 { 1.0 - time } else { time };
            let sine = if time < 0.125 { (4.0 * PI * time).sin() } else { ((PI + 4.0 * PI * time) / 3.0).sin() };
            MODIFIED_SINE * sine
        };
        let steps = 100_000;
        let (mut speed, mut rise) = (0.0, 0.0);
        for step in 0..steps {
            let time = (f64::from(step) + 0.5) / f64::from(steps);
            let acceleration = if time > 0.5 { -law(time) } else { law(time) };
            speed += acceleration / f64::from(steps);
            rise += speed / f64::from(steps);
        }
        assert!(
            (rise - 1.0).abs() < 1e-4 && speed.abs() < 1e-6 && (MODIFIED_SINE - 5.528).abs() < 5e-4,
            "{rise} {speed}"
        );
        let ratio = |stations: u32| cam_ratio(stations).expect("possible");
        assert!(ratio(4) < 0.7 && ratio(6) < 1.0 && ratio(7) > 1.0 && ratio(8) > 1.1);
    }

    #[test]
    fn the_chapters_words_about_tolerances_hold() {
        let (sizes, limit) = (sizes().expect("fits"), shared().expect("one"));
        let gap = sizes.locking_gap().expect("a disc");
        // A third of the gap for each of three sizes and the bores' play would be more than the gap.
        assert!(3.0 * limit.locking + sizes.play.bore < gap && 3.0 * gap / 3.0 + sizes.play.bore > gap);
        // All limits grow with the play.
        let choices = Choices { play: Some(Play::of(2.0 * sizes.play.slot)), ..Choices::default() };
        let twice = Sizes::new(sizes.wheel, Scale::CrankRadius(sizes.crank_radius), &choices).expect("fits");
        let twice = twice.shared_tolerance().expect("one");
        for (one, two) in [(limit.locking, twice.locking), (limit.crank, twice.crank), (limit.width, twice.width)] {
            assert!((two / one - 2.0).abs() < 0.1, "{one} {two}");
        }
        // A disc that is only smaller and an arc that is only larger leave the gap to axes and bores.
        let nearer = sizes.centre_tolerance().nearer - sizes.play.bore;
        assert!(nearer > 2.0 * limit.nearer, "{nearer}");
    }
}
