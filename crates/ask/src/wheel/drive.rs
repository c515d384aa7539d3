//! What the motor feels, as it is reported.

use super::design::WheelDesign;
use super::friction::{disc, held_torque};
use crate::number_format::{as_typed, degrees, rounded_up, to_digits};
use crate::{Error, Needs, ReportField, Rounding};
use geneva_kinematics::indexing::Indexing;

const LOADED: Needs = Needs::SPEED.union(Needs::INERTIA);
const GEARED: Needs = LOADED.union(Needs::GEAR_RATIO);
const STARTED: Needs = LOADED.union(Needs::DRIVER_INERTIA).union(Needs::DRIVE_TORQUE);

/// The speed droop, over the driver's speed, above which a maker is warned: our choice.
const MOST_DROOP: f64 = 0.1;

/// A warning of a driver that loses too much of its speed in each index, with the inertia that it needs.
pub(super) fn droop_warning(design: &WheelDesign) -> Result<Option<String>, Error> {
    let Some(inertia) = design.question.driver_inertia else { return Ok(None) };
    let Some(loads) = design.loads(design.wheel.indexing())? else { return Ok(None) };
    let droop = loads.speed_droop(inertia)?;
    // Of 1 − 1/√(1 + J v²/I) with I unknown.
    let enough = loads.reflected_inertia().peak / (1.0 / ((1.0 - MOST_DROOP) * (1.0 - MOST_DROOP)) - 1.0);
    Ok((droop > MOST_DROOP).then(|| {
        format!(
            "--driver-inertia {}: in each index the driver loses {} % of its speed unless the motor helps, and more than {} % is much \
             (our choice), so the motion and the loads are not those of a constant speed; take {} kg m² or more",
            as_typed(inertia),
            to_digits(100.0 * droop, 2),
            as_typed(100.0 * MOST_DROOP),
            rounded_up(enough)
        )
    }))
}

/// The fields of the motor.
pub(super) fn fields(design: &WheelDesign, wheel: &(impl Indexing + ?Sized)) -> Result<Vec<ReportField>, Error> {
    let (loads, question) = (design.loads(wheel)?, &design.question);
    let loads = loads.as_ref();
    let reflected = loads.map(|loads| loads.reflected_inertia());
    let holding = loads.zip(question.held_torque).map(|(loads, held)| loads.holding_torque(held)).transpose()?;
    let droop = loads.zip(question.driver_inertia).map(|(loads, inertia)| loads.speed_droop(inertia)).transpose()?;
    let asked = loads.zip(question.drive_torque.zip(question.driver_inertia));
    let start = asked.map(|(loads, (torque, inertia))| loads.run_up(torque, inertia)).transpose()?;
    let run = start.flatten();
    let time = ReportField::in_unit("run_up_time_s", run.map(|run| run.time), "s").needing(STARTED);
    let time = match (start, run) {
        (Some(_), None) => {
            time.words("start in mid-index", "this torque can't bring the driver to its speed within a hundred turns")
        }
        (_, run) => {
            let turned = run.map_or_else(String::new, |run| degrees(run.angle));
            time.line(
                "start in mid-index",
                format!("until the driver has its speed, with that torque; it turns {turned}°"),
            )
        }
    };
    let disc_force = match (&design.sizes, question.disc_friction) {
        (Some(sizes), Some(friction)) => {
            disc(sizes, friction).map(|disc| disc.force(held_torque(question))).transpose()?
        }
        _ => None,
    };
    let ratio = question.gear_ratio;
    let geared = |torque: Option<f64>| torque.zip(ratio).map(|(torque, ratio)| torque / ratio);
    let motor_speed = design.driver_speed.zip(ratio).map(|(speed, ratio)| speed.rpm() * ratio);
    let newton_metres = |key, value: Option<f64>| ReportField::in_unit(key, value, "N m");
    let inertia = |key, value: Option<f64>| ReportField::in_unit(key, value, "kg m²");
    let own = design.masses().map(|masses| masses.driver_inertia);
    let driver = question.driver_inertia.or(own).unwrap_or(0.0);
    let at_motor = match (question.driver_inertia, own) {
        (Some(_), _) => {
            "inertia at the motor in mid-index, of the wheel and of all that turns with the driver: (J v² + driver's) / gear ratio²"
        }
        (None, Some(_)) => {
            "inertia at the motor in mid-index, of the wheel and of the driver's own parts: (J v² + driver's) / gear ratio²; give \
             --driver-inertia if more turns with the driver"
        }
        (None, None) => {
            "reflected inertia at the motor in mid-index, of the wheel alone: J v² / gear ratio²; --driver-inertia adds the driver's"
        }
    };
    Ok(vec![
        inertia("reflected_inertia_kgm2", reflected.map(|reflected| reflected.peak))
            .line(
                "reflected inertia",
                "of the wheel at the driver's shaft in mid-index: J v², v the peak velocity ratio",
            )
            .needing(LOADED),
        inertia("mean_reflected_inertia_kgm2", reflected.map(|reflected| reflected.mean))
            .line("", "its mean over a turn of the driver")
            .needing(LOADED),
        newton_metres("dwell_crank_torque_nm", loads.map(|loads| loads.dwell_crank_torque()))
            .line("crank torque in the dwell", "what the locking disc, as in the middle part of the dwell, and the driver's own friction take")
            .needing(LOADED),
        ReportField::in_unit("locking_disc_force_n", disc_force, "N")
            .line("force on the locking disc", "with which the wheel presses on it in the middle part of the dwell: held torque, or else friction torque, / arm of the force at \
                 the locking arc's end, with the wheel turned through its play; near the ends of the dwell it is greater")
            .needing(Needs::SIZE.union(Needs::DISC_FRICTION)),
        newton_metres("breakaway_torque_nm", loads.map(|loads| loads.breakaway_torque()))
            .line("breakaway torque", "at the crank, after a stop in mid-index: friction alone")
            .needing(LOADED),
        newton_metres("holding_torque_nm", holding)
            .line("holding torque", "at the crank, in a stop in mid-index: torque on the wheel × peak velocity ratio")
            .needing(LOADED.union(Needs::HELD_TORQUE)),
        ReportField::in_unit("speed_droop", droop, "× driver speed")
            .line("speed droop", "in mid-index, without the motor's help: 1 − 1/√(1 + J v²/driver's inertia)")
            .needing(LOADED.union(Needs::DRIVER_INERTIA))
            .rounded(Rounding::Significant(3)),
        time,
        ReportField::in_unit("run_up_angle_deg", run.map(|run| run.angle.to_degrees()), "°").needing(STARTED),
        ReportField::in_unit("motor_speed_rpm", motor_speed, "rpm")
            .line("motor speed", "driver speed × gear ratio")
            .needing(Needs::SPEED.union(Needs::GEAR_RATIO)),
        newton_metres("motor_peak_torque_nm", geared(loads.map(|loads| loads.crank_torque().driving.value)))
            .line("motor torque", "its peak: peak crank torque / gear ratio; the gear takes more")
            .needing(GEARED),
        newton_metres("motor_rms_torque_nm", geared(loads.map(|loads| loads.rms_crank_torque())))
            .line("", "its RMS")
            .needing(GEARED),
        inertia("motor_reflected_inertia_kgm2", geared(geared(reflected.map(|reflected| reflected.peak + driver))))
            .line("", at_motor)
            .needing(GEARED),
        inertia("motor_mean_reflected_inertia_kgm2", geared(geared(reflected.map(|reflected| reflected.mean + driver))))
            .line("", "its mean")
            .needing(GEARED),
    ])
}

#[cfg(test)]
mod tests {
    use crate::{MechanismReport, ReportField, answer};
    use approx::assert_relative_eq;
    use std::f64::consts::{PI, TAU};

    const SIX: &str = "wheel --stations 6 --crank-radius 40 --rpm 50 --total-inertia 0.0246 --thickness 12";

    fn report(more: &str) -> MechanismReport {
        answer(&format!("{SIX} {more}")).expect(more)
    }

    fn number(report: &MechanismReport, key: &str) -> f64 {
        report.field(key).and_then(ReportField::number).expect(key)
    }

    #[test]
    fn the_motor_feels_what_the_gear_leaves() {
        let report = report("--gear-ratio 8 --held-torque 0.7 --driver-inertia 0.0246");
        // Of six stations the wheel is as fast as its driver in mid-index.
        assert_relative_eq!(number(&report, "reflected_inertia_kgm2"), 0.0246, max_relative = 1e-12);
        // The motor turns the wheel and the flywheel.
        assert_relative_eq!(number(&report, "motor_reflected_inertia_kgm2"), 2.0 * 0.0246 / 64.0, max_relative = 1e-12);
        let mean = number(&report, "mean_reflected_inertia_kgm2") + 0.0246;
        assert_relative_eq!(number(&report, "motor_mean_reflected_inertia_kgm2"), mean / 64.0, max_relative = 1e-12);
        assert_relative_eq!(number(&report, "motor_speed_rpm"), 400.0, max_relative = 1e-12);
        assert_relative_eq!(number(&report, "holding_torque_nm"), 0.7, max_relative = 1e-12);
        // Two equal inertias share the energy of one.
        assert_relative_eq!(number(&report, "speed_droop"), 1.0 - 0.5_f64.sqrt(), max_relative = 1e-12);
        let peak = number(&report, "motor_peak_torque_nm") * 8.0;
        assert_relative_eq!(peak, number(&report, "peak_crank_torque_nm"), max_relative = 1e-12);
        assert_relative_eq!(number(&report, "peak_power_w"), peak * 50.0 * TAU / 60.0, max_relative = 1e-12);
    }

    #[test]
    fn without_a_flywheel_the_motor_feels_wheel_and_driver_and_says_so() {
        let alone = report("--gear-ratio 8");
        let field = alone.field("motor_reflected_inertia_kgm2").expect("a field");
        let own = number(&alone, "driver_own_inertia_kgm2");
        assert!(own > 1e-4);
        assert_relative_eq!(field.number().expect("an inertia"), (0.0246 + own) / 64.0, max_relative = 1e-12);
        assert!(field.line.as_ref().is_some_and(|line| line.meaning.contains("of the driver's own parts")));
        // Without a size it is the wheel alone.
        let bare = answer("wheel --stations 6 --rpm 50 --total-inertia 0.0246 --gear-ratio 8").expect("an answer");
        let field = bare.field("motor_reflected_inertia_kgm2").expect("a field");
        assert_relative_eq!(field.number().expect("an inertia"), 0.0246 / 64.0, max_relative = 1e-12);
        assert!(field.line.as_ref().is_some_and(|line| line.meaning.contains("of the wheel alone")));
    }

    #[test]
    fn a_flywheel_that_is_too_light_is_warned_of_with_one_that_is_not() {
        let warned = |more: &str| {
            let report = report(more);
            let line = report.field("warnings").expect("warnings").line.clone();
            line.map_or_else(String::new, |line| line.meaning.into_owned())
        };
        // Two equal inertias share the energy of one: the speed falls by 29 %.
        let said = warned("--driver-inertia 0.0246");
        assert!(said.contains("--driver-inertia 0.0246: in each index the driver loses 29 % of its speed"), "{said}");
        assert!(said.contains("more than 10 %") && said.contains("our choice"), "{said}");
        let enough = said.split("take ").nth(1).and_then(|rest| rest.split(' ').next()).expect("an inertia");
        assert!(!warned(&format!("--driver-inertia {enough}")).contains("loses"), "{enough}");
        let less = 0.999 * enough.parse::<f64>().expect("a number");
        assert!(warned(&format!("--driver-inertia {less}")).contains("loses 10 %"), "{less}");
        assert!(!warned("").contains("loses"));
        // Of an internal wheel, too, and of one without a size.
        let other =
            answer("wheel --stations 6 --type internal --rpm 60 --inertia 0.01 --driver-inertia 0.001").expect("loads");
        let line = other.field("warnings").and_then(|field| field.line.clone()).expect("a warning");
        assert!(line.meaning.contains("loses"));
    }

    #[test]
    fn a_start_ends_or_is_said_not_to() {
        // Frictionless: the torque's work is the energy of driver and wheel.
        let start = report("--driver-inertia 0.05 --drive-torque 3");
        let work = 3.0 * number(&start, "run_up_angle_deg").to_radians();
        let speed = 50.0 * TAU / 60.0;
        assert!(work > 0.5 * 0.05 * speed * speed && work < 0.5 * 0.0746 * speed * speed, "{work}");
        assert!(number(&start, "run_up_time_s") > 0.0);
        let weak = report("--driver-inertia 0.05 --drive-torque 0.5 --friction-torque 2");
        let field = weak.field("run_up_time_s").expect("a field");
        assert_eq!(field.number(), None);
        assert!(field.line.as_ref().is_some_and(|line| line.meaning.contains("can't bring")));
    }

    #[test]
    fn friction_counts_in_every_load_and_its_absence_is_said() {
        let none = report("");
        let meaning = |of: &MechanismReport| of.field("mean_crank_torque_nm").unwrap().line.clone().unwrap().meaning;
        assert_eq!(number(&none, "mean_crank_torque_nm"), 0.0);
        assert!(meaning(&none).contains("frictionless"));
        let all = "--friction-torque 0.1 --pin-friction 0.15 --disc-friction 0.15 --bearing-friction 0.1 --wheel-bearing 20 \
                   --driver-bearing 20 --driver-friction 0.02";
        let rubbed = report(all);
        assert!(!meaning(&rubbed).contains("frictionless"));
        for key in [
            "peak_wheel_torque_nm",
            "peak_pin_force_n",
            "peak_crank_torque_nm",
            "rms_crank_torque_nm",
            "mean_crank_torque_nm",
            "peak_power_w",
            "breakaway_torque_nm",
            "dwell_crank_torque_nm",
        ] {
            assert!(number(&rubbed, key) > number(&none, key), "{key}");
        }
        assert!(number(&rubbed, "braking_crank_torque_nm") > number(&none, "braking_crank_torque_nm"));
        // Each friction alone takes something.
        let mean = |more: &str| number(&report(more), "mean_crank_torque_nm");
        let table = mean("--friction-torque 0.1");
        assert_relative_eq!(table, 0.1 / 6.0, max_relative = 1e-12);
        for more in [
            "--pin-friction 0.15",
            "--bearing-friction 0.1 --wheel-bearing 20 --driver-bearing 20",
            "--disc-friction 0.15",
        ] {
            assert!(mean(&format!("--friction-torque 0.1 {more}")) > table, "{more}");
        }
        // The disc rubs in the dwell only, two thirds of the turn.
        let disc = report("--friction-torque 0.1 --disc-friction 0.15");
        let dwell = number(&disc, "dwell_crank_torque_nm");
        assert_relative_eq!(number(&disc, "mean_crank_torque_nm"), table + dwell * 2.0 / 3.0, max_relative = 1e-12);
        let (force, radius) = (number(&disc, "locking_disc_force_n"), number(&disc, "locking_radius_mm"));
        assert_relative_eq!(dwell, 0.15 * force * radius / 1e3, max_relative = 1e-12);
    }

    /// The end of a locking arc, as a point that the wheel takes along: it is turned until it is on the disc. The arm of a force of the disc
    /// is how fast the point then comes nearer to the driver's axis (virtual work), by finite differences.
    #[test]
    fn the_force_on_the_disc_has_the_arm_of_the_wheel_as_turned_in_its_play() {
        let mut greatest = 0.0_f64;
        for stations in [3, 4, 6, 8, 12] {
            for locking in ["0.05", "0.3", "1", "2"] {
                let asked = format!(
                    "wheel --stations {stations} --crank-radius 40 --rpm 50 --total-inertia 0.1 --locking-play {locking} --friction-torque 0.1"
                );
                let of = |friction: &str| answer(&format!("{asked} --disc-friction {friction}")).expect(&asked);
                let (smooth, rough) = (of("0"), of("0.15"));
                let [centres, arc, rim, radius] =
                    ["centre_distance_mm", "locking_arc_radius_mm", "tip_radius_mm", "locking_radius_mm"]
                        .map(|key| number(&smooth, key));
                // As drawn, by bisection along the arc: where it meets the rim. From the wheel's axis, the driver's is at (centres, 0).
                let at = |angle: f64| [centres - arc * angle.cos(), arc * angle.sin()];
                let (mut low, mut high) = (0.0, PI);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let [x, y] = at(middle);
                    if x.hypot(y) < rim { low = middle } else { high = middle }
                }
                let [x, y] = at(low);
                let turned = |turn: f64| [x * turn.cos() + y * turn.sin(), y * turn.cos() - x * turn.sin()];
                let away = |turn: f64| (turned(turn)[0] - centres).hypot(turned(turn)[1]);
                let (mut loose, mut deep) = (0.0, 0.5);
                for _ in 0..60 {
                    let middle = 0.5 * (loose + deep);
                    if away(middle) > radius { loose = middle } else { deep = middle }
                }
                let arm = (away(loose - 1e-6) - away(loose + 1e-6)) / 2e-6;
                let force = number(&smooth, "locking_disc_force_n");
                assert_relative_eq!(force * arm / 1e3, 0.1, max_relative = 1e-7);
                // The rubbing is along the disc and has the other arm.
                let [x, y] = turned(loose);
                let across = (x * (centres - x) - y * y) / radius;
                let force = number(&rough, "locking_disc_force_n");
                assert_relative_eq!(force * (arm - 0.15 * across) / 1e3, 0.1, max_relative = 1e-7);
                let drawn = centres * low.sin();
                greatest = greatest.max((arm / drawn - 1.0).abs());
            }
        }
        // The arm of the wheel as drawn would be another one by more than the test lets pass.
        assert!(greatest > 0.01, "{greatest}");
    }

    #[test]
    fn a_bearing_without_a_diameter_is_refused() {
        let error = answer(&format!("{SIX} --bearing-friction 0.1 --wheel-bearing 20")).unwrap_err().to_string();
        assert!(error.contains("--bearing-friction 0.1") && error.contains("add --driver-bearing MM"), "{error}");
    }
}
