//! The outline of a slotted wheel, with true arcs.

use crate::svg::path::{Path, Sense};
use crate::svg::view::{Pixels, View};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Half the width of a slot, in crank radii.
pub const SLOT_HALF_WIDTH: f64 = 0.07;
/// Radius of the locking arcs, in crank radii.
const LOCKING_RADIUS: f64 = 0.66;
/// How far the ratio of the lengths may be from that of a whole number of stations.
const STATION_TOLERANCE: f64 = 1e-6;

/// Distance of a wheel's rim from its pivot: where the pin enters and leaves the slot, √(l² − R²).
pub fn rim_radius(mechanism: &PinSlot) -> f64 {
    let (l, r) = (mechanism.centre_distance(), mechanism.crank_radius());
    ((l - r) * (l + r)).sqrt()
}

/// The number of slots of the wheel that the pin turns by whole stations: sin(π / n) = R / l.
///
/// `None` where no whole number of slots belongs to these lengths.
pub fn stations(mechanism: &PinSlot) -> Option<u32> {
    let count = PI / libm::asin(mechanism.ratio().recip());
    let whole = libm::round(count);
    ((count - whole).abs() < STATION_TOLERANCE * count).then_some(whole as u32)
}

/// Outline of the follower about the plane's origin, one slot turned to `slot_angle` (radians).
///
/// A wheel with the mechanism's number of slots and the locking arcs between them; where no whole number of slots
/// belongs to its lengths, a disk with one slot.
pub fn outline(mechanism: &PinSlot, slot_angle: f64, view: &View) -> Path {
    let stations = stations(mechanism);
    let slots = stations.unwrap_or(1);
    let step = 2.0 * PI / f64::from(slots);
    let rim = rim_radius(mechanism);
    let unit = mechanism.crank_radius();
    let half_width = SLOT_HALF_WIDTH * unit;
    let (tip, bottom) = ((rim * rim - half_width * half_width).sqrt(), mechanism.centre_distance() - unit);
    let locking = LOCKING_RADIUS * unit;
    let at = |angle: f64, x: f64, y: f64| -> Pixels {
        let turn = Turn::from_radians(angle);
        view.place(&Vector2::new(x * turn.cos - y * turn.sin, x * turn.sin + y * turn.cos))
    };
    let [rim_px, slot_px, locking_px] = [rim, half_width, locking].map(|radius| radius * view.scale);

    let mut path = Path::start(&at(slot_angle, tip, -half_width));
    for k in 0..slots {
        let slot = slot_angle + step * f64::from(k);
        let between = slot + step / 2.0;
        path = path.line_to(&at(slot, bottom, -half_width));
        path = path.arc_to(slot_px, Sense::Clockwise, &at(slot, bottom, half_width));
        path = path.line_to(&at(slot, tip, half_width));
        if stations.is_some() {
            let (x, y) = rim_meets_circle(rim, mechanism.centre_distance(), locking);
            path = path.arc_to(rim_px, Sense::CounterClockwise, &at(between, x, -y));
            path = path.arc_to(locking_px, Sense::Clockwise, &at(between, x, y));
        } else {
            path = path.arc_to(rim_px, Sense::CounterClockwise, &at(between, rim, 0.0));
        }
        path = path.arc_to(rim_px, Sense::CounterClockwise, &at(slot + step, tip, -half_width));
    }
    path.close()
}

/// Where the rim meets a circle about a point on the first axis, above that axis.
fn rim_meets_circle(rim: f64, centre: f64, radius: f64) -> (f64, f64) {
    let x = (centre * centre + rim * rim - radius * radius) / (2.0 * centre);
    (x, (rim * rim - x * x).max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stations_follow_from_the_lengths() {
        for n in 3..=12 {
            let ratio = libm::sin(PI / f64::from(n)).recip();
            let mechanism = PinSlot::new(2.0, 2.0 * ratio).expect("possible");
            assert_eq!(stations(&mechanism), Some(n));
        }
        assert_eq!(stations(&PinSlot::new(2.0, 3.1).expect("possible")), None);
    }

    #[test]
    fn the_locking_arc_keeps_clear_of_the_slots_and_reaches_the_rim() {
        for n in 3..=12 {
            let ratio = libm::sin(PI / f64::from(n)).recip();
            let (x, y) = rim_meets_circle((ratio * ratio - 1.0).sqrt(), ratio, LOCKING_RADIUS);
            assert!(y > 0.0, "{n} stations");
            let from_slot = libm::sin(PI / f64::from(n) - libm::atan2(y, x)) * x.hypot(y);
            assert!(from_slot > SLOT_HALF_WIDTH, "{n} stations: {from_slot}");
        }
    }
}
