//! The reset angle of the driver's angle: with every pin the engagement begins again.

use super::*;
use crate::meyer::slips::RESET_ANGLE;
use geneva_evidence::Decimal;
use geneva_evidence::agreement::joined;

/// The reset angle of the driver's angle. A quarter of a turn is right for four pins only.
pub(super) fn reset(
    id: &'static str,
    place: Locator,
    meaning: &'static str,
    said: &'static str,
    corrected: &'static str,
) -> Claim {
    place
        .statement(id, said, meaning)
        .first_route(Evidence::CLOSED_FORM, |stated| resets(|at| modulus(at, stated)))
        .second_route(Evidence::VECTORS, |stated| {
            let agree = |at: &&Mechanism| {
                (0..100).all(|k| {
                    let angle = (f64::from(k) + 0.5) * 0.0625;
                    let crank = Turn::from_radians(angle % modulus(at, stated) - at.engagement_half_angle());
                    // The modulus is printed to four places.
                    (at.pin_distance(&crank) - nearest_pin(at, angle)).abs() < 1e-3
                })
            };
            let all = Mechanism::ALL;
            let pins: Vec<u32> = all.iter().filter(agree).map(|at| at.pins()).collect();
            let only = if pins.len() == all.len() { "" } else { "only " };
            Finding::new(
                pins.len() == all.len(),
                format!(
                    "the angle in the slot, reset as this form says, agrees {only}for {} pins with the angle of the \
                     pin nearest to the follower's axis",
                    joined(&pins)
                ),
            )
        })
        .corrected(corrected, RESET_ANGLE)
}

/// The angle after which the driver's angle is reset: the angle between two pins, if the correction gives it, or as
/// printed.
fn modulus(at: &Mechanism, stated: Stated) -> f64 {
    let said = stated.decimals();
    let is = |said: &Decimal, angle: f64| said.is_rounding_of(angle) || said.is_rounding_of(angle.to_degrees());
    let pitch = at.driver_pitch_angle();
    // Each of the angles is one between two pins or half of one.
    let known = said.iter().all(|said| {
        let pitches = Mechanism::ALL.iter().map(|at| at.driver_pitch_angle());
        pitches.into_iter().any(|pitch| is(said, pitch) || is(said, pitch / 2.0))
    });
    let corrected = if known && said.iter().any(|said| is(said, pitch)) { pitch } else { f64::INFINITY };
    stated.pick(corrected, MEYER.printed_number("meyer.listing.quarter-turn"))
}

/// Whether the reset angle runs from entry to exit and no farther, for each escapement with its modulus.
fn resets(modulus: impl Fn(&Mechanism) -> f64) -> Finding {
    let ends: Vec<String> = Mechanism::ALL
        .iter()
        .filter(|at| {
            let end = modulus(at) - at.engagement_half_angle();
            // The modulus is printed to four places.
            (end - at.engagement_half_angle()).abs() > 1e-4
        })
        .map(|at| {
            let [from, to] =
                [-at.engagement_half_angle(), modulus(at) - at.engagement_half_angle()].map(f64::to_degrees);
            format!("from {from:.0}° to {to:.0}° for {} pins", at.pins())
        })
        .collect();
    let how = if ends.is_empty() {
        "the angle in the slot runs from entry to exit for each of the three mechanisms".to_owned()
    } else {
        format!("the angle in the slot does not run from entry to exit, but {}", joined(&ends))
    };
    Finding::new(ends.is_empty(), how)
}

/// Distance of the pin nearest to the follower's axis, of all pins by coordinates, when the driver has turned so far
/// from the entry of one of them.
pub(super) fn nearest_pin(at: &Mechanism, turned: f64) -> f64 {
    let axis = Vector2::new(at.centre_distance_ratio(), 0.0);
    let place = |pin: u32| {
        Turn::from_radians(turned - at.engagement_half_angle() + at.driver_pitch_angle() * f64::from(pin)).direction()
    };
    (0..at.pins()).map(|pin| (place(pin) - axis).norm()).fold(f64::INFINITY, f64::min)
}
