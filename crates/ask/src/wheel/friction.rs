//! What rubs in a wheel and its driver, from what a question says of it.

use super::arguments::FRICTION;
use super::fitting::{Fit, refusal, remedies_among};
use super::question::{WheelQuestion, given};
use crate::Error;
use crate::number_format::as_typed;
use geneva_dynamics::DynamicsError;
use geneva_dynamics::wheel_loads::{DwellContact, Friction};
use geneva_kinematics::wheel::Sizes;

/// Millimetres of a metre.
const MILLI: f64 = 1000.0;

/// All friction of the question, with a pin of this radius in millimetres, if it has one. That of bearings and disc needs a size.
///
/// # Errors
///
/// Friction of bearings without diameters, and of a disc that draws its arc in.
pub(super) fn friction(
    question: &WheelQuestion,
    crank_radius: Option<f64>,
    pin_radius: Option<f64>,
    sizes: Option<&Sizes>,
) -> Result<Friction, Error> {
    // Without a size the force on the bearings is unknown.
    let [wheel_bearing, driver_bearing] = if crank_radius.is_some() { bearings(question)? } else { [0.0; 2] };
    let ratio = |arm: f64| crank_radius.map_or(0.0, |radius| arm / radius);
    let dwell_torque = |question: &WheelQuestion| {
        let disc = sizes.zip(question.disc_friction).and_then(|(sizes, friction)| disc(sizes, friction));
        disc.map(|disc| disc.driver_torque(held_torque(question), driver_bearing / MILLI)).transpose()
    };
    let draws_in = "friction of the locking disc draws the locking arc in, so the driver locks in the dwell";
    let found = dwell_torque(question);
    let dwell_torque = found.map_err(|error| locked(error, draws_in, question, |other| dwell_torque(other).is_ok()))?;
    Ok(Friction {
        wheel_torque: question.friction_torque.unwrap_or(0.0),
        pin: question.pin_friction.unwrap_or(0.0),
        pin_radius: pin_radius.map_or(0.0, ratio),
        wheel_bearing: ratio(wheel_bearing),
        driver_bearing: ratio(driver_bearing),
        driver_torque: question.driver_friction.unwrap_or(0.0),
        dwell_torque: dwell_torque.unwrap_or(0.0),
    })
}

/// The error about friction that locks a mechanism, with why it does and the arguments that free it; `turns` says whether that of a
/// question does. Any other error is left as it is.
pub(super) fn locked(
    error: DynamicsError,
    reason: &str,
    question: &WheelQuestion,
    turns: impl Fn(&WheelQuestion) -> bool,
) -> Error {
    match error {
        DynamicsError::SelfLocking { .. } if !question.is_trial => {
            let fits = |other: &WheelQuestion| if turns(other) && other.is_in_range() { Fit::Well } else { Fit::Not };
            Error::Argument(refusal(reason, &remedies_among(FRICTION, question, &fits)))
        }
        error => error.into(),
    }
}

/// The torque in N m that presses the locking arc on the disc in the dwell: what is given, or at most what the friction on the wheel
/// leaves in it.
pub(super) fn held_torque(question: &WheelQuestion) -> f64 {
    question.held_torque.or(question.friction_torque).unwrap_or(0.0)
}

/// The locking disc in an arc of the wheel, which is turned through its play until the arc's end rests on the disc; none without a disc.
pub(super) fn disc(sizes: &Sizes, friction: f64) -> Option<DwellContact> {
    let (end_angle, radius) = (sizes.disc_reach()?, sizes.locking_disc?.radius / MILLI);
    Some(DwellContact { centre_distance: sizes.centre_distance / MILLI, radius, end_angle, friction })
}

/// Arms of the friction of the bearings of wheel and driver, in millimetres: their coefficient times half the diameter.
fn bearings(question: &WheelQuestion) -> Result<[f64; 2], Error> {
    let Some(friction) = question.bearing_friction else { return Ok([0.0; 2]) };
    let refused = |bearing: &str, option: &str| {
        Err(refused!(
            "--bearing-friction {}: the diameter at which the {bearing} bearing rubs is missing; add --{option} MM",
            as_typed(friction)
        ))
    };
    let arm = |diameter: f64| friction * diameter / 2.0;
    let of_wheel = question.wheel_bearing.or(given(question.wheel_shaft));
    let of_driver = question.driver_bearing.or(given(question.plate_shaft)).or(given(question.driver_shaft));
    match (of_wheel, of_driver) {
        (Some(wheel), Some(driver)) => Ok([arm(wheel), arm(driver)]),
        (None, _) => refused("wheel's", "wheel-bearing"),
        (_, None) => refused("driver's", "driver-bearing"),
    }
}
