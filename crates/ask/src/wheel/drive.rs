//! What the motor feels, as it is reported.

use super::design::WheelDesign;
use super::friction::{disc, held_torque};
use crate::number_format::degrees;
use crate::{Error, Needs, ReportField, Rounding};
use geneva_kinematics::indexing::Indexing;

const LOADED: Needs = Needs::SPEED.union(Needs::INERTIA);
const GEARED: Needs = LOADED.union(Needs::GEAR_RATIO);
const STARTED: Needs = LOADED.union(Needs::DRIVER_INERTIA).union(Needs::DRIVE_TORQUE);

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
        (Some(_), None) => time.words("start in mid-index", "this torque can't bring the driver to its speed"),
        (_, run) => {
            let turned = run.map_or_else(String::new, |run| degrees(run.angle));
            time.line("start in mid-index", format!("until the driver has its speed, with that torque; it turns {turned}°"))
        }
    };
    let disc_force = match (&design.sizes, question.disc_friction) {
        (Some(sizes), Some(friction)) => {
            disc(sizes, friction).map(|disc| disc.force(held_torque(design))).transpose()?
        }
        _ => None,
    };
    let ratio = question.gear_ratio;
    let geared = |torque: Option<f64>| torque.zip(ratio).map(|(torque, ratio)| torque / ratio);
    let motor_speed = question.speed().zip(ratio).map(|(speed, ratio)| speed.rpm() * ratio);
    let newton_metres = |key, value: Option<f64>| ReportField::in_unit(key, value, "N m");
    let inertia = |key, value: Option<f64>| ReportField::in_unit(key, value, "kg m²");
    Ok(vec![
        inertia("reflected_inertia_kgm2", reflected.map(|reflected| reflected.peak))
            .line("reflected inertia", "of the wheel at the driver's shaft in mid-index: J v², v the peak velocity ratio")
            .needing(LOADED),
        inertia("mean_reflected_inertia_kgm2", reflected.map(|reflected| reflected.mean))
            .line("", "its mean over a turn of the driver")
            .needing(LOADED),
        newton_metres("dwell_crank_torque_nm", loads.map(|loads| loads.dwell_crank_torque()))
            .line("crank torque in the dwell", "what the locking disc and the driver's own friction take")
            .needing(LOADED),
        ReportField::in_unit("locking_disc_force_n", disc_force, "N")
            .line("force on the locking disc", "in the dwell: torque on the wheel / arm of the arc's end, at most")
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
        inertia("motor_reflected_inertia_kgm2", geared(geared(reflected.map(|reflected| reflected.peak))))
            .line("", "reflected inertia at the motor in mid-index: / gear ratio²")
            .needing(GEARED),
        inertia("motor_mean_reflected_inertia_kgm2", geared(geared(reflected.map(|reflected| reflected.mean))))
            .line("", "its mean")
            .needing(GEARED),
    ])
}
