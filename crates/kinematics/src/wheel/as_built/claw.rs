//! How far the locking disc in an arc lets the wheel turn.
//!
//! A claw of the disc is what is left of it between two crescents. It is in one locking arc, between two horns. A horn ends
//! at the rim or where arc and slot meet, and its side towards the claw is the arc. At each distance r from the wheel's axis
//! the claw reaches up to the angle U(r) from the line of centres, and the arc opens by o(r) to either side of its middle. So
//! the upper horn stops the wheel where its arc's middle is at the greatest of U(r) − o(r). Claw and horn can meet in these
//! ways only: the tip of the horn at the disc's rim or in the crescent, an edge of the crescent on the arc, and the disc's rim along the
//! arc. Two hollow sides never meet between their ends. The lower horn is the mirror image.

use super::contact::BuiltContact;

/// A crescent as seen from the wheel's axis, or its mirror image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// Distance of its centre from the wheel's axis, in millimetres.
    pub distance: f64,
    /// Angle of its centre from the line of centres, in radians.
    pub angle: f64,
    /// Its radius, in millimetres.
    pub radius: f64,
    /// Whether it is closed towards the wheel's axis, so that no horn comes into it.
    pub is_closed: bool,
}

/// A claw in its arc, as the upper horn sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Claw {
    /// Distance of the axes, in millimetres.
    pub axes: f64,
    /// Radius of the disc, in millimetres.
    pub disc: f64,
    /// Lower and upper end of the claw on the disc's rim: angles at the driver's axis from the line of centres, in radians.
    pub ends: [f64; 2],
    /// The crescent at its upper end.
    pub cut: Cut,
    /// Radius and centre of the locking arc, in millimetres.
    pub arc: [f64; 2],
    /// How far out the horn goes, in millimetres.
    pub horn: f64,
}

/// Where an arc's middle is at least.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClawLimit {
    /// Its angle from the line of centres, in radians.
    pub angle: f64,
    /// By what.
    pub contact: BuiltContact,
    /// How far from the wheel's axis, in millimetres.
    pub radius: f64,
    /// How deep the parts are in each other along the radius, in millimetres; zero unless they are.
    pub overlap: f64,
}

/// An angle from its cosine, and what is missing; beyond 1 what is missing as an angle below zero, so that it goes on continuously.
fn opening(cosine: f64, missing: f64, distance: f64) -> (f64, f64) {
    if cosine > 1.0 { (-missing / distance, missing) } else { (libm::acos(cosine.max(-1.0)), 0.0) }
}

impl Claw {
    /// The half angle of the arc's opening at a distance from the wheel's axis, in radians; below zero where the arc does not
    /// reach so deep, with by how much it does not.
    fn arc_opening(&self, r: f64) -> (f64, f64) {
        let [radius, centre] = self.arc;
        let cosine = (r * r + centre * centre - radius * radius) / (2.0 * r * centre);
        opening(cosine, centre - radius - r, r)
    }

    /// A point of the disc's rim: its distance from the wheel's axis and its angle from the line of centres.
    fn rim(&self, tau: f64) -> [f64; 2] {
        let (sin, cos) = libm::sincos(tau);
        let (x, y) = (self.axes - self.disc * cos, self.disc * sin);
        [libm::hypot(x, y), libm::atan2(y, x)]
    }

    /// The angle on the disc's rim, from the line of centres, up to which the horn can reach; none if it reaches no part of it.
    fn reach(&self) -> Option<f64> {
        let (c, z) = (self.axes, self.disc);
        let cosine = (c * c + z * z - self.horn * self.horn) / (2.0 * c * z);
        (cosine < 1.0).then(|| libm::acos(cosine.max(-1.0)))
    }

    /// The least angle of the arc's middle, in radians from the line of centres, that the upper horn leaves. None if the claw is
    /// not within the horn's reach.
    pub(super) fn limit(&self) -> Option<ClawLimit> {
        let reach = self.reach()?;
        let [low, high] = self.ends;
        let upper = if self.cut.is_closed && high > 0.0 { high.max(reach) } else { high };
        if low >= upper || low >= reach || upper <= -reach {
            return None;
        }
        let mut least =
            ClawLimit { angle: f64::NEG_INFINITY, contact: BuiltContact::DiscInArc, radius: self.horn, overlap: 0.0 };
        let mut candidate = |angle: f64, contact, radius: f64, beyond: f64| {
            let (opening, missing) = self.arc_opening(radius);
            if angle - opening > least.angle {
                least = ClawLimit { angle: angle - opening, contact, radius, overlap: missing.max(beyond) };
            }
        };
        let nearest = low.max(0.0).min(upper);
        if nearest == 0.0 {
            candidate(0.0, BuiltContact::DiscInArc, self.axes - self.disc, 0.0);
        } else {
            let [r, angle] = self.rim(nearest);
            candidate(angle, BuiltContact::OpeningEdge, r, 0.0);
        }
        if upper >= reach {
            let [r, angle] = self.rim(reach);
            candidate(angle, BuiltContact::DiscInArc, r, 0.0);
        } else {
            if upper > 0.0 {
                let [r, angle] = self.rim(upper);
                candidate(angle, BuiltContact::OpeningEdge, r, 0.0);
            }
            let (r, Cut { distance: s, radius, .. }) = (self.horn, self.cut);
            let cosine = (r * r + s * s - radius * radius) / (2.0 * r * s);
            let (opening, missing) = opening(cosine, (r - s).abs() - radius, r);
            candidate(self.cut.angle - opening, BuiltContact::Crescent, r, missing);
        }
        // Along the arc: circle in circle.
        let [radius, centre] = self.arc;
        let within = radius - self.disc;
        let cosine = (self.axes * self.axes + centre * centre - within * within) / (2.0 * self.axes * centre);
        if within > 0.0 && cosine <= 1.0 {
            let turned = libm::acos(cosine.max(-1.0));
            let (sin, cos) = libm::sincos(turned);
            let tau = libm::atan2(centre * sin, centre * cos - self.axes);
            if tau >= low.max(0.0) && tau <= upper.min(reach) {
                let radius = self.rim(tau)[0];
                if -turned > least.angle {
                    least = ClawLimit { angle: -turned, contact: BuiltContact::DiscInArc, radius, overlap: 0.0 };
                }
            }
        }
        Some(least)
    }
}
