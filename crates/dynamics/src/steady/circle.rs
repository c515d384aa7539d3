//! The angle in which the coefficients of the equation of motion are as simple as they can be.
//!
//! Let ρ = φ'/θ' be the velocity ratio and k = a sin θ / R², the pin's sliding per radian over its distance from the
//! pivot, both as the driver turns at a radian per unit of time. The point (ρ, k) runs on a circle: with ψ = θ + 2 φ
//! and c = 1/(a² − 1),
//!
//! ρ = c (1 + a cos ψ), k = c a sin ψ, dψ/dθ = 1 + 2 ρ, dρ/dψ = −k, dk/dψ = ρ − c.
//!
//! The four coefficients over I_f become A = i + ρ², B = ρ ρ', C = μ k ρ', D = μ k ρ with ρ' = −k (1 + 2 ρ): Meyer
//! 1973, after Eq. (1-18). The pin enters and leaves where ρ = 0, at ψ = ∓(π/2 + π/n).
//!
//! As a variable to compute with, w = tan(ψ/4) needs no sine: all the above are rational in it. It runs from 0 on the
//! line of centres to 1 where the crank points away from the follower. The motion before the line of centres is
//! the mirror image, ρ the same and k with the other sign; so w ≥ 0 is enough.

use geneva_kinematics::Mechanism;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// The circle of one mechanism.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circle {
    /// a, dimensionless.
    pub ratio: f64,
    /// c = 1/(a² − 1), the circle's centre on the axis of ρ, dimensionless.
    pub centre: f64,
    /// c a, its radius, dimensionless.
    pub radius: f64,
    /// w where the pin leaves, dimensionless.
    pub exit: f64,
    /// Real and imaginary part of the w where 1 + 2 ρ = 0, dimensionless.
    pub far: (f64, f64),
}

/// One place on the circle.
#[derive(Clone, Copy, Debug)]
pub(super) struct CirclePoint {
    /// ρ, the velocity ratio, dimensionless: follower's speed over driver's.
    pub rho: f64,
    /// k, the sliding ratio, dimensionless: sliding per radian over R, positive past the line of centres.
    pub k: f64,
    /// dψ/dw, the Jacobian, in radians for a w of one.
    pub jacobian: f64,
}

impl CirclePoint {
    /// dψ/dθ, the angular velocity of ψ over the driver's, dimensionless.
    #[inline]
    pub(super) fn angular_velocity(&self) -> f64 {
        1.0 + 2.0 * self.rho
    }
}

/// In the order of [`Mechanism::ALL`].
static CIRCLES: LazyLock<[Circle; 3]> = LazyLock::new(|| Mechanism::ALL.map(Circle::new));

impl Circle {
    /// The circle of a mechanism, made at the first call.
    pub(super) fn lookup(mechanism: Mechanism) -> Self {
        CIRCLES[mechanism.index()]
    }

    fn new(mechanism: Mechanism) -> Self {
        let (ratio, centre) =
            (mechanism.centre_distance_ratio(), 1.0 / (mechanism.centre_distance_ratio_squared() - 1.0));
        let exit = libm::tan(PI / 8.0 + PI / (4.0 * f64::from(mechanism.slots())));
        let imaginary = 1.0 / (centre * (ratio + 1.0) * (ratio + 1.0));
        let far = ((1.0 - imaginary * imaginary).sqrt(), imaginary);
        Self { ratio, centre, radius: centre * ratio, exit, far }
    }

    /// The place at w.
    #[inline]
    pub(super) fn place(&self, w: f64) -> CirclePoint {
        let scale = 1.0 / (1.0 + w * w);
        let (sin, cos) = (2.0 * w * scale, (1.0 - w * w) * scale);
        let rho = self.centre + self.radius * ((cos - sin) * (cos + sin));
        CirclePoint { rho, k: self.radius * (2.0 * sin * cos), jacobian: 4.0 * scale }
    }

    /// θ at w, in radians; not negative.
    pub(super) fn angle(&self, w: f64) -> f64 {
        // a − 1, without the loss of digits.
        let less = 1.0 / (self.centre * (self.ratio + 1.0));
        2.0 * libm::atan2(2.0 * w * less, (1.0 - w * w) * (self.ratio + 1.0))
    }

    /// w, dimensionless, at θ, for θ from 0 to π.
    pub(super) fn w_at_angle(&self, angle: f64) -> f64 {
        let less = 1.0 / (self.centre * (self.ratio + 1.0));
        let (sin, cos) = (libm::sin(angle / 2.0) * (self.ratio + 1.0), libm::cos(angle / 2.0) * less);
        sin / (cos + libm::hypot(sin, cos))
    }
}
