//! The reset angle of the driver's angle: with every pin the engagement begins again.

use super::*;
use crate::meyer::slips::RESET_ANGLE;
use geneva_evidence::Decimal;
use geneva_evidence::agreement::joined;
use std::f64::consts::{PI, TAU};

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

/// The angle after which the driver's angle is reset, as the characters say: an angle divided by the number of pins if they divide
/// one by a letter, the angle between two pins if they name that of each mechanism and nothing else than such angles and their
/// halves, or else the first angle that they name, in radians or degrees. Without a number it is that of the line of the program.
fn modulus(at: &Mechanism, stated: Stated) -> f64 {
    let said = stated.decimals();
    let pitches = Mechanism::ALL.map(|at| at.driver_pitch_angle());
    let is = |said: &Decimal, angle: f64| said.is_rounding_of(angle) || said.is_rounding_of(angle.to_degrees());
    let is_known = |said: &Decimal| pitches.iter().any(|pitch| is(said, *pitch) || is(said, pitch / 2.0));
    if let Some((angle, number)) = divided_by_pins(stated.characters()) {
        // What is said beside the quotient must not contradict it.
        let is_of_it = |said: &Decimal| said.to_f64() == 0.0 || Some(said.to_f64()) == number || is_known(said);
        return if said.iter().all(is_of_it) { angle / f64::from(at.pins()) } else { f64::INFINITY };
    }
    let names_each = pitches.iter().all(|pitch| said.iter().any(|said| is(said, *pitch)));
    if names_each {
        return if said.iter().all(is_known) { at.driver_pitch_angle() } else { f64::INFINITY };
    }
    said.first().map_or_else(|| MEYER.printed_number("meyer.listing.quarter-turn"), |said| in_radians(said.to_f64()))
}

/// An angle of at most a turn, in radians or degrees, in radians.
fn in_radians(angle: f64) -> f64 {
    // A turn in radians, to four places.
    if angle > TAU + 1e-4 { angle.to_radians() } else { angle }
}

/// The angle in radians that the characters divide by a letter, as in 2π/m, 6.2832/M or 360°/m, and the number in it, if any.
fn divided_by_pins(said: &str) -> Option<(f64, Option<f64>)> {
    let mut places = said.char_indices().filter(|(_, c)| *c == '/').map(|(at, _)| at);
    places.find_map(|at| {
        said[at + 1..].trim_start().chars().next().filter(|c| c.is_alphabetic())?;
        let before = said[..at].trim_end().trim_end_matches('°');
        let of_pi = ["π", "\\pi", "PI", "pi"].iter().find_map(|pi| before.strip_suffix(pi));
        let factor = of_pi.unwrap_or(before).trim_end().trim_end_matches(['*', '·', '×']).trim_end();
        let start = factor
            .rfind(|c: char| !c.is_ascii_digit() && c != '.')
            .map_or(0, |at| at + factor[at..].chars().next().map_or(0, char::len_utf8));
        let number = factor[start..].parse::<f64>().ok();
        match of_pi {
            Some(_) => Some((number.unwrap_or(1.0) * PI, number)),
            None => number.map(|angle| (in_radians(angle), number)),
        }
    })
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
