//! The outline of a slotted wheel, with true arcs.

use crate::svg::{Path, Pixels, Sense, Shape, View};
use crate::theme::{FILL, FOLLOWER};
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::PinSlot;
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Half the width of a slot where only one pin is looked at, in crank radii.
pub(crate) const SLOT_HALF_WIDTH: f64 = 0.07;
/// Radius of the locking arcs there, in crank radii.
const LOCKING_RADIUS: f64 = 0.66;
/// Half the width of a slot of a whole wheel, in crank radii.
const HALF_WIDTH: f64 = 0.08;
/// A wheel of a smaller radius than this (pixels) is written to tenths of a pixel.
const SMALL: f64 = 120.0;
/// How far the ratio of the lengths may be from that of a whole number of stations.
const STATION_TOLERANCE: f64 = 1e-6;

/// Lengths of a slotted wheel, all in one unit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Star {
    /// How many slots.
    pub slots: u32,
    /// Radius of the rim.
    pub rim: f64,
    /// From the pivot to the deepest place of the pin's centre: there a slot ends, in a half circle.
    pub bottom: f64,
    /// Half the width of a slot.
    pub half_width: f64,
    /// From the pivot to the centre of a locking arc, which is the driver's axis while the wheel is locked.
    pub centre: f64,
    /// Radius of the locking arcs; none for a disk without them.
    pub locking: Option<f64>,
}

impl Star {
    /// The wheel that belongs to a pin in a slot: with locking arcs where its lengths are those of whole stations,
    /// a disk with one slot where they are not.
    pub(crate) fn of_pin_slot(mechanism: &PinSlot) -> Self {
        let (stations, unit) = (stations(mechanism), mechanism.crank_radius());
        Self {
            slots: stations.unwrap_or(1),
            rim: rim_radius(mechanism),
            bottom: mechanism.centre_distance() - unit,
            half_width: SLOT_HALF_WIDTH * unit,
            centre: mechanism.centre_distance(),
            locking: stations.map(|_| LOCKING_RADIUS * unit),
        }
    }

    /// A wheel of whole stations, in crank radii.
    ///
    /// The radius of the locking arcs is free. The slot's centre line passes the driver's axis at one crank radius
    /// while the wheel is locked, for any number of stations; so the wall between slot and locking arc is
    /// 1 − half width − locking radius thick at its thinnest, and is made as thick as the slot is wide.
    pub(crate) fn of_wheel(wheel: &Wheel) -> Self {
        let ratio = wheel.centre_distance_ratio();
        let wall = 2.0 * HALF_WIDTH;
        Self {
            slots: wheel.stations(),
            rim: wheel.wheel_radius_ratio(),
            bottom: wheel.wheel_radius_ratio() - wheel.slot_length_ratio(),
            half_width: HALF_WIDTH,
            centre: ratio,
            locking: Some(1.0 - HALF_WIDTH - wall),
        }
    }

    /// Outline about the plane's origin, one slot turned to `slot_angle` (radians).
    pub(crate) fn outline(&self, slot_angle: f64, view: &View) -> Path {
        let step = 2.0 * PI / f64::from(self.slots);
        let Self { rim, bottom, half_width, .. } = *self;
        let tip = (rim * rim - half_width * half_width).sqrt();
        let at = |angle: f64, x: f64, y: f64| -> Pixels {
            let turn = Turn::from_radians(angle);
            view.place(&Vector2::new(x * turn.cos - y * turn.sin, x * turn.sin + y * turn.cos))
        };
        let [rim_px, slot_px] = [rim, half_width].map(|radius| radius * view.scale);

        let decimals = if rim_px < SMALL { 1 } else { 2 };
        let mut path = Path::start_rounded(&at(slot_angle, tip, -half_width), decimals);
        for k in 0..self.slots {
            let slot = slot_angle + step * f64::from(k);
            let between = slot + step / 2.0;
            path = path.line_to(&at(slot, bottom, -half_width));
            path = path.arc_to(slot_px, Sense::Clockwise, &at(slot, bottom, half_width));
            path = path.line_to(&at(slot, tip, half_width));
            if let Some(locking) = self.locking {
                let (x, y) = rim_meets_circle(rim, self.centre, locking);
                path = path.arc_to(rim_px, Sense::CounterClockwise, &at(between, x, -y));
                path = path.arc_to(locking * view.scale, Sense::Clockwise, &at(between, x, y));
            } else {
                path = path.arc_to(rim_px, Sense::CounterClockwise, &at(between, rim, 0.0));
            }
            path = path.arc_to(rim_px, Sense::CounterClockwise, &at(slot + step, tip, -half_width));
        }
        path.close()
    }

    /// The wheel as a body, its outline so many pixels wide.
    pub(crate) fn body(&self, slot_angle: f64, view: &View, width: f64) -> Shape {
        let outline = Shape::path(self.outline(slot_angle, view)).fill(FILL).stroke(FOLLOWER, width);
        outline.attribute("stroke-linejoin", "round")
    }

    /// Half the angle that a locking arc takes as seen from its centre, in radians; zero without locking arcs.
    pub(crate) fn locking_half_angle(&self) -> f64 {
        self.locking.map_or(0.0, |radius| {
            let (x, y) = rim_meets_circle(self.rim, self.centre, radius);
            libm::atan2(y, self.centre - x)
        })
    }
}

/// Distance of a wheel's rim from its pivot: where the pin enters and leaves the slot, √(l² − R²).
pub(crate) fn rim_radius(mechanism: &PinSlot) -> f64 {
    let (l, r) = (mechanism.centre_distance(), mechanism.crank_radius());
    ((l - r) * (l + r)).sqrt()
}

/// The number of slots of the wheel that the pin turns by whole stations: sin(π / n) = R / l.
///
/// `None` where no whole number of slots belongs to these lengths.
pub(crate) fn stations(mechanism: &PinSlot) -> Option<u32> {
    let count = PI / libm::asin(mechanism.ratio().recip());
    let whole = libm::round(count);
    ((count - whole).abs() < STATION_TOLERANCE * count).then_some(whole as u32)
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
        for n in 3..=60 {
            let wheel = Wheel::new(n).expect("possible");
            let mechanism = PinSlot::new(1.0, wheel.centre_distance_ratio()).expect("possible");
            for star in [Star::of_pin_slot(&mechanism), Star::of_wheel(&wheel)] {
                let radius = star.locking.expect("whole stations");
                let (x, y) = rim_meets_circle(star.rim, star.centre, radius);
                assert!(y > 0.0 && star.centre - radius < star.rim, "{n} stations");
                let wall = libm::sin(PI / f64::from(n) - libm::atan2(y, x)) * x.hypot(y) - star.half_width;
                assert!(wall >= 1.0 - star.half_width - radius - 1e-12, "{n} stations: {wall}");
                assert!(star.bottom > star.half_width, "{n} stations");
            }
        }
    }
}
