//! A size for a wheel of which none is given.
//!
//! A small wheel needs a large force at the pin to turn its table, and a large one spends it on itself. With the table's moment
//! of inertia `J` and the wheel's `b aⁿ` on a crank `a` (n = 5 where pin and thickness grow with the size), the force goes as
//! (J + b aⁿ)/a and the crank torque as J + b aⁿ. The force is least where the wheel has a fair share of the inertia, but the
//! minimum is flat: where the wheel has a tenth of the table's, the crank torque is only a tenth above that of the table alone.
//! That share is our choice.

use super::question::WheelQuestion;
use super::sized::{own_inertia, sizes};
use crate::Error;
use geneva_kinematics::wheel::{Scale, Wheel};

/// The wheel's moment of inertia over the table's at the recommended size, dimensionless.
const SHARE: f64 = 0.1;
/// The crank radius in millimetres of a wheel that turns nothing but itself: a size for the hand.
const WITHOUT_LOAD: f64 = 25.0;
/// The least and the greatest recommended crank radius, in millimetres.
const LEAST: f64 = 6.3;
const MOST: f64 = 1000.0;
/// The preferred numbers R20 of ISO 3 in one decade, as they are rounded there, in hundredths.
const R20: [u32; 20] =
    [100, 112, 125, 140, 160, 180, 200, 224, 250, 280, 315, 355, 400, 450, 500, 560, 630, 710, 800, 900];

/// The crank radius in millimetres that suits a load: the least preferred number (ISO 3, R20) at which the wheel has at least a
/// tenth of its table's moment of inertia, in kg m².
///
/// # Errors
///
/// Choices of the question that fit no such wheel.
pub(super) fn recommended_crank_radius(
    wheel: &Wheel,
    question: &WheelQuestion,
    table_inertia: Option<f64>,
    density: f64,
) -> Result<f64, Error> {
    let Some(table) = table_inertia.filter(|inertia| *inertia > 0.0) else { return Ok(WITHOUT_LOAD) };
    let own = |radius: f64| {
        let sizes = sizes(*wheel, Scale::CrankRadius(radius), question).ok()?;
        own_inertia(Some(&sizes), question.thickness.or(Some(sizes.pin_diameter)), density).ok()?
    };
    let is_enough = |radius: &f64| own(*radius).is_some_and(|own| own >= SHARE * table);
    Ok(preferred_numbers().find(is_enough).unwrap_or(MOST))
}

/// The preferred numbers in the range of recommended crank radii, in millimetres.
pub(super) fn preferred_numbers() -> impl Iterator<Item = f64> {
    [1.0, 10.0, 100.0, 1000.0]
        .into_iter()
        .flat_map(|decade| R20.map(|number| f64::from(number) * decade / 100.0))
        .filter(|radius| (LEAST..=MOST).contains(radius))
}
