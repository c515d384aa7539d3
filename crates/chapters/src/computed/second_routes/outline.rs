//! The tips of a wheel's horns beside the cut of a locking disc, place by place as the crank turns.

use super::contact::{add_scaled, dot, moment};
use std::f64::consts::PI;

/// A wheel and a disc with a cut in it; lengths in one unit.
pub(crate) struct Cut {
    /// Number of slots.
    pub slots: f64,
    /// Distance of the axes.
    pub centre_distance: f64,
    /// Distance of the pin from the driver's axis.
    pub crank_radius: f64,
    /// Radius of the wheel's rim.
    pub rim: f64,
    /// Radius of the wheel's locking arcs, which are about the driver's axis while the wheel rests.
    pub arc: f64,
    /// Radius of the disc.
    pub disc: f64,
    /// Distance of the cut's centre from the driver's axis, on the pin's line.
    pub centre: f64,
    /// Radius of the cut.
    pub radius: f64,
}

impl Cut {
    /// The least distance of a horn's tip from the disc while the crank turns through an engagement; below zero how deep a tip is in
    /// the disc.
    pub(crate) fn least_gap(&self) -> f64 {
        const PLACES: i32 = 5000;
        let (half, tip) = (PI / 2.0 - PI / self.slots, self.tip_angle());
        let axis = [self.centre_distance, 0.0];
        let mut least = f64::INFINITY;
        for place in -PLACES..=PLACES {
            let (sine, cosine) = (half * f64::from(place) / f64::from(PLACES)).sin_cos();
            let along_pin = [cosine, sine];
            let to_pin = add_scaled(along_pin.map(|part| self.crank_radius * part), -1.0, axis);
            let slot = to_pin.map(|part| part / dot(to_pin, to_pin).sqrt());
            for side in [-tip, tip] {
                let (sine, cosine) = side.sin_cos();
                let towards = [slot[0] * cosine - slot[1] * sine, slot[0] * sine + slot[1] * cosine];
                let at = add_scaled(axis, self.rim, towards);
                let from_centre = [dot(at, along_pin) - self.centre, moment(along_pin, at)];
                let from_cut = self.radius - dot(from_centre, from_centre).sqrt();
                least = least.min(from_cut.max(dot(at, at).sqrt() - self.disc));
            }
        }
        least
    }

    /// The angle between a slot and the horn's tip beside it, where a locking arc meets the rim: the resting driver's axis is half
    /// the angle between two slots away from each of them.
    fn tip_angle(&self) -> f64 {
        let Self { centre_distance: c, rim, arc, .. } = *self;
        PI / self.slots - ((c * c + rim * rim - arc * arc) / (2.0 * c * rim)).acos()
    }
}
