//! A pin on a crank in the slot of a follower: the shape of the mechanism and its rates.
//!
//! Notation: `R` crank radius, `l` centre distance, `k = l / R` their ratio; θ crank angle from the line of centres,
//! zero when the pin is nearest to the follower's pivot; `r` distance of the pin from that pivot. The formulas take
//! the ratio `k` and give lengths in crank radii.

use crate::error::length;
use crate::{Field, Jet, KinematicsError, Turn};
use nalgebra::Vector2;

/// A crank with a pin and a follower with a slot through its own pivot, outside the crank's circle.
///
/// ```
/// use geneva_kinematics::pin_slot::PinSlot;
/// use std::f64::consts::FRAC_PI_3;
///
/// let mechanism = PinSlot::new(30.0, 60.0)?; // crank radius and centre distance in mm
/// assert_eq!(mechanism.ratio(), 2.0);
/// assert!((mechanism.engagement_half_angle() - FRAC_PI_3).abs() < 1e-15); // cos 60° = 30 / 60
/// assert!(PinSlot::new(60.0, 30.0).is_err()); // the follower's pivot must be outside the crank's circle
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
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
///
/// ```
/// use geneva_kinematics::pin_slot::pin_from_pivot;
/// use geneva_kinematics::{Turn, rational};
/// use nalgebra::Vector2;
///
/// let crank = Turn::from_half_tangent(&rational(1, 2)); // cosine 3/5, sine 4/5
/// assert_eq!(pin_from_pivot(&rational(2, 1), &crank), Vector2::new(rational(7, 5), rational(4, 5)));
/// ```
pub fn pin_from_pivot<S: Field>(ratio: &S, crank: &Turn<S>) -> Vector2<S> {
    Vector2::new(ratio.clone() - crank.cos.clone(), crank.sin.clone())
}

/// Path of the pin seen from the follower's pivot for a moving crank, in crank radii, as a power series.
///
/// ```
/// use geneva_kinematics::pin_slot::{pin_path, sliding_product};
/// use geneva_kinematics::{Turn, rational};
///
/// // Half the rate of r² is r dr/dθ.
/// let (ratio, crank) = (rational(2, 1), Turn::from_half_tangent(&rational(1, 2)));
/// let path = pin_path(&ratio, &crank.moving::<2>(rational(1, 1)));
/// assert_eq!(path.dot(&path).rate() / rational(2, 1), sliding_product(&ratio, &crank));
/// ```
pub fn pin_path<S: Field, const N: usize>(ratio: &S, crank: &Turn<Jet<S, N>>) -> Vector2<Jet<S, N>> {
    pin_from_pivot(&Jet::constant(ratio.clone()), crank)
}

/// Square of the pin's distance from the follower's pivot, in squared crank radii: 1 + k² − 2 k cos θ.
///
/// The law of cosines in the triangle of the two axes and the pin.
///
/// ```
/// use geneva_kinematics::pin_slot::slot_radius_squared;
/// use geneva_kinematics::{Turn, rational};
///
/// // With k = 2 and cos θ = 3/5 the pin is at (7/5, 4/5) from the pivot: 49/25 + 16/25.
/// let crank = Turn::from_half_tangent(&rational(1, 2));
/// assert_eq!(slot_radius_squared(&rational(2, 1), &crank), rational(13, 5));
/// ```
#[inline]
pub fn slot_radius_squared<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    S::one() + ratio.clone() * ratio.clone() - S::integer(2) * ratio.clone() * crank.cos.clone()
}

/// Angular velocity of the follower over that of the crank, dimensionless: (k cos θ − 1) / (1 + k² − 2 k cos θ).
///
/// Positive while the two turn in opposite senses; zero where the pin moves along the slot, k cos θ = 1.
///
/// ```
/// use geneva_kinematics::pin_slot::velocity_ratio;
/// use geneva_kinematics::{Turn, rational};
///
/// let middle = Turn { cos: rational(1, 1), sin: rational(0, 1) };
/// assert_eq!(velocity_ratio(&rational(2, 1), &middle), rational(1, 1)); // 1 / (k − 1)
/// let entry = Turn::from_half_tangent(&rational(1, 2)); // cos θ = 3/5: with k = 5/3 the pin moves along the slot
/// assert_eq!(velocity_ratio(&rational(5, 3), &entry), rational(0, 1));
/// ```
pub fn velocity_ratio<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    (ratio.clone() * crank.cos.clone() - S::one()) / slot_radius_squared(ratio, crank)
}

/// Slot radius times its rate of change with the crank angle, r dr/dθ, in squared crank radii: k sin θ.
///
/// Free of the root in `r`, so exact over the rationals; divide by `r` for the sliding speed over the crank speed.
///
/// ```
/// use geneva_kinematics::Turn;
/// use geneva_kinematics::pin_slot::sliding_product;
///
/// // With k = 2 the pin leaves at 60°, at r = √3 crank radii, along the slot: r dr/dθ = √3.
/// assert!((sliding_product(&2.0, &Turn::from_degrees(60.0)) - 3_f64.sqrt()).abs() < 1e-15);
/// ```
pub fn sliding_product<S: Field>(ratio: &S, crank: &Turn<S>) -> S {
    ratio.clone() * crank.sin.clone()
}
