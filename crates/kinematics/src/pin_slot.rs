//! A pin on a crank in the slot of a follower: the shape of the mechanism and its rates.
//!
//! Notation: `R` crank radius, `l` centre distance, `k = l / R` their ratio; θ crank angle from the line of centres,
//! zero when the pin is nearest to the follower's pivot; `r` distance of the pin from that pivot. The formulas take
//! the ratio `k` and give lengths in crank radii.

use crate::error::length;
use crate::{Field, Jet, KinematicsError, Turn};
use nalgebra::Vector2;

/// A crank with a pin and a follower with a slot through its own pivot, outside the crank's circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinSlot {
    crank_radius: f64,
    centre_distance: f64,
}

impl PinSlot {
    /// A mechanism from its crank radius (> 0) and centre distance (> crank radius), in one unit of length.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Length`] and [`KinematicsError::CentreDistance`] for other lengths, and for infinite ones.
    pub fn new(crank_radius: f64, centre_distance: f64) -> Result<Self, KinematicsError> {
        let crank_radius = length("crank radius", crank_radius)?;
        if !(centre_distance > crank_radius && centre_distance.is_finite()) {
            return Err(KinematicsError::CentreDistance { asked: centre_distance, crank_radius });
        }
        Ok(Self { crank_radius, centre_distance })
    }

    /// Distance of the pin's centre from the driver's axis, in the unit of the mechanism.
    pub fn crank_radius(&self) -> f64 {
        self.crank_radius
    }

    /// Distance between the two axes, in the unit of the mechanism.
    pub fn centre_distance(&self) -> f64 {
        self.centre_distance
    }

    /// Centre distance over crank radius, dimensionless, above 1.
    pub fn ratio(&self) -> f64 {
        self.centre_distance / self.crank_radius
    }

    /// Largest crank angle, in radians from the line of centres, at which the pin moves along the slot: cos θ = R / l.
    ///
    /// Between minus and plus this angle the follower turns against the driver; at both ends it stands still.
    pub fn engagement_half_angle(&self) -> f64 {
        libm::acos(self.crank_radius / self.centre_distance)
    }
}

/// Position of the pin seen from the follower's pivot, in crank radii; first coordinate along the line of centres.
pub fn pin_from_pivot<S: Field>(ratio: &S, crank: &Turn<S>) -> Vector2<S> {
    Vector2::new(ratio.clone() - crank.cos.clone(), crank.sin.clone())
}

/// Path of the pin seen from the follower's pivot for a moving crank, in crank radii, as a power series.
pub fn pin_path<S: Field, const N: usize>(ratio: &S, crank: &Turn<Jet<S, N>>) -> Vector2<Jet<S, N>> {
    pin_from_pivot(&Jet::constant(ratio.clone()), crank)
}

/// Square of the pin's distance from the follower's pivot, in squared crank radii: 1 + k² − 2 k cos θ.
///
/// The law of cosines in the triangle of the two axes and the pin.
#[inline]
pub fn slot_radius_squared<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    S::one() + ratio.clone() * ratio.clone() - S::integer(2) * ratio.clone() * crank.cos.clone()
}

/// Angular velocity of the follower over that of the crank, dimensionless: (k cos θ − 1) / (1 + k² − 2 k cos θ).
///
/// Positive while the two turn in opposite senses; zero where the pin moves along the slot, k cos θ = 1.
pub fn velocity_ratio<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    (ratio.clone() * crank.cos.clone() - S::one()) / slot_radius_squared(ratio, crank)
}

/// Slot radius times its rate of change with the crank angle, r dr/dθ, in squared crank radii: k sin θ.
///
/// Free of the root in `r`, so exact over the rationals; divide by `r` for the sliding speed over the crank speed.
pub fn sliding_product<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    ratio.clone() * crank.sin.clone()
}
