//! Where the equation of motion has one solution: how much friction a given pair of inertias can bear.
//!
//! One solution means A > |D| ([`equation`]). The geometry is even in θ, so one half of the engagement
//! is enough; instead of θ we use h = a cos θ − 1, from 0 where the pin leaves to a − 1 on the line of centres.
//! With b = a² − 1 and i = I_D / I_f: R² = b − 2 h, a sin θ = g = √(a² − (1 + h)²) in crank radii, and
//!
//! A − |D| = i − h (μ g − h) / R⁴.
//!
//! **Critical friction.** A = |D| at μ(h) = (i R⁴ + h²) / (h g) = N(h) / g with N = α/h − β + γ h, where α = i b², β =
//! 4 i b, γ = 4 i + 1. It has one minimum. Where N grows, it grows (1/g does too). Where N falls, it is strictly
//! convex, because (N/g)'' g / N ≥ N''/N + 2 (N'/N) m + 3 m² with m = (1 + h)/g², a quadratic in m whose discriminant
//! has the sign of N'² − 3 N N''. With h in units of √(α/γ), h = u √(α/γ), that is u⁴ − 8 u² + 6 κ u − 5 up to a
//! positive factor, where κ = 4 √(i / (4 i + 1)) < 2, so it is below u⁴ − 8 u² + 12 u − 5 = (u − 1)² (u² + 2 u − 5) ≤ 0
//! for 0 < u ≤ 1, which is where N falls. So the derivative changes its sign once, and bisection finds the place.
//!
//! **Surely enough.** Most frictions lie far below the critical one, and less than the minimum is enough to tell. With
//! N = α/h − β + γ h ≥ 2 √(α γ) − β and g ≤ √b it is at least 2 √(b i)/(√(4 i + 1) + 2 √i). After a few bisections, with
//! the minimum between two h, it is at least that of T/G there, where T and G are the tangents of N and g at a place c
//! between: N is convex and g concave, so that T ≤ N and G ≥ g. The quotient of two straight lines has its least value
//! at an end, and if c is near the minimum, it is nearly level.
//!
//! **Least margin.** h (μ g − h) / R⁴ > w means μ > μ(h) for i = w, an interval of h: so W(h) = h (μ g − h)/R⁴ rises to
//! one maximum and falls again, wherever it is positive, and bisection finds that too. Its places do not depend on i.
//!
//! The algebra is proven in [`existence_proofs`](crate::existence_proofs).

use crate::error::{not_negative, positive};
use crate::{DynamicsError, Pose, equation};
use geneva_kinematics::Mechanism;
use geneva_kinematics::bisection::{bisect, bisect_times};

/// The least friction at which the equation of motion fails to have one solution, and where that happens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalFriction {
    /// Coefficient of friction, dimensionless; infinite if it is too great for a number.
    pub friction: f64,
    /// Crank angle in radians to either side of the line of centres.
    pub angle: f64,
}

/// The least excess of A over |D| while a pin is in its slot, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastMargin {
    /// A − |D| there, dimensionless; one solution everywhere if and only if it is positive.
    pub margin: f64,
    /// Crank angle in radians to either side of the line of centres.
    pub angle: f64,
}

/// A − |D| at a pose, for I_D / I_f and μ; dimensionless.
///
/// ```
/// use geneva_dynamics::Pose;
/// use geneva_dynamics::existence::margin;
/// use geneva_kinematics::Turn;
///
/// // As the pin leaves, at 60° with a = 2, the follower is at rest: only the driver's inertia is felt.
/// let exit = Pose::new(&2.0, &Turn::from_degrees(60.0));
/// assert!((margin(&exit, 3.0, 0.2) - 3.0).abs() < 1e-12); // I_D = 3 I_f
/// ```
pub fn margin(pose: &Pose<f64>, inertia_ratio: f64, friction: f64) -> f64 {
    equation::coefficient_a(pose, &inertia_ratio) - equation::coefficient_d(pose, &friction).abs()
}

/// The friction from which on A > |D| fails somewhere in the engagement, for I_D / I_f (positive and finite).
///
/// ```
/// use geneva_dynamics::existence::{critical_friction, least_margin};
/// use geneva_kinematics::Mechanism;
///
/// let critical = critical_friction(Mechanism::FOUR_PIN, 0.1)?; // I_D = 0.1 I_f
/// let there = least_margin(Mechanism::FOUR_PIN, 0.1, critical.friction)?;
/// assert!(there.margin.abs() < 1e-12); // A = |D|, once in the engagement,
/// assert!((there.angle - critical.angle).abs() < 1e-5); // at this angle in rad
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::NotPositive`].
pub fn critical_friction(mechanism: Mechanism, inertia_ratio: f64) -> Result<CriticalFriction, DynamicsError> {
    let inertia = positive("driver inertia over follower inertia", inertia_ratio)?;
    let half = Half::new(mechanism);
    // All over 1 + i, so that no inertia ratio is too great.
    let (part, rest) = (inertia / (1.0 + inertia), 1.0 / (1.0 + inertia));
    let h = bisect([0.0, half.ratio - 1.0], |h| half.falling(part, rest, h))[1];
    let square = half.radius_squared(h);
    let friction = (inertia * (square * (square / h)) + h) / half.cross_squared(h).sqrt();
    Ok(CriticalFriction { friction, angle: half.angle(h) })
}

/// Whether the friction is below the critical one by so much that a cheap lower bound of it is enough to tell, for
/// I_D / I_f and μ.
///
/// For those who judge many escapements, as a map does: true only of a friction below [`critical_friction`], but false of
/// some of these, and of all where I_D / I_f is not within 10⁻¹⁰⁰ to 10¹⁰⁰.
///
/// ```
/// use geneva_dynamics::existence::{critical_friction, surely_below_critical};
/// use geneva_kinematics::Mechanism;
///
/// let critical = critical_friction(Mechanism::FOUR_PIN, 0.1)?.friction;
/// assert!(surely_below_critical(Mechanism::FOUR_PIN, 0.1, critical / 2.0));
/// assert!(!surely_below_critical(Mechanism::FOUR_PIN, 0.1, critical));
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
pub fn surely_below_critical(mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> bool {
    let inertia = inertia_ratio;
    // Within this range nothing overflows or loses its digits; the margin is far more than what rounding can do.
    if !(1e-100..=1e100).contains(&inertia) {
        return false;
    }
    let (half, friction) = (Half::new(mechanism), friction * (1.0 + 1e-9));
    let (root, whole) = (inertia.sqrt(), (4.0 * inertia + 1.0).sqrt());
    if friction * (whole + 2.0 * root) < 2.0 * half.shape.sqrt() * root {
        return true;
    }
    let [low, high] = bisect_times(BISECTIONS, [0.0, half.ratio - 1.0], |h| half.falling(inertia, 1.0, h));
    let c = f64::midpoint(low, high);
    let (square, across) = (half.radius_squared(c), half.cross_squared(c).sqrt());
    let numerator = inertia * square * (square / c) + c;
    let change = 4.0 * inertia + 1.0 - inertia * (half.shape / c) * (half.shape / c);
    [low, high].into_iter().all(|h| {
        let (tangent, over) = (numerator + change * (h - c), across - (1.0 + c) / across * (h - c));
        friction * over < tangent
    })
}

/// Bisections after which the lower bound is within some thousandths of the critical friction. Measured.
const BISECTIONS: u32 = 6;

/// The least A − |D| in the engagement, for I_D / I_f (positive and finite) and μ (finite, not negative).
///
/// Without friction it is I_D / I_f, where the pin enters and leaves; with friction it is less.
///
/// ```
/// use geneva_dynamics::existence::least_margin;
/// use geneva_kinematics::Mechanism;
/// use std::f64::consts::FRAC_PI_4;
///
/// // Without friction the driver feels least inertia where the follower is at rest: its own.
/// let least = least_margin(Mechanism::FOUR_PIN, 0.1, 0.0)?;
/// assert!((least.margin - 0.1).abs() < 1e-15 && (least.angle - FRAC_PI_4).abs() < 1e-15);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::NotPositive`] for the inertias, [`DynamicsError::Negative`] for the friction.
pub fn least_margin(mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> Result<LeastMargin, DynamicsError> {
    let inertia = positive("driver inertia over follower inertia", inertia_ratio)?;
    let (worst, angle) = worst(mechanism, not_negative("friction coefficient", friction)?);
    Ok(LeastMargin { margin: inertia - worst, angle })
}

/// The ratio I_D / I_f, dimensionless, that must be exceeded for one solution everywhere with this friction: zero
/// without friction.
///
/// ```
/// use geneva_dynamics::existence::{critical_friction, critical_inertia_ratio};
/// use geneva_kinematics::Mechanism;
///
/// // It undoes `critical_friction`.
/// let friction = critical_friction(Mechanism::FOUR_PIN, 0.1)?.friction;
/// assert!((critical_inertia_ratio(Mechanism::FOUR_PIN, friction)? - 0.1).abs() < 1e-12);
/// assert_eq!(critical_inertia_ratio(Mechanism::FOUR_PIN, 0.0)?, 0.0);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::Negative`] for a friction that is negative or not finite.
pub fn critical_inertia_ratio(mechanism: Mechanism, friction: f64) -> Result<f64, DynamicsError> {
    Ok(worst(mechanism, not_negative("friction coefficient", friction)?).0)
}

/// The greatest h (μ g − h) / R⁴ and its crank angle.
fn worst(mechanism: Mechanism, friction: f64) -> (f64, f64) {
    let half = Half::new(mechanism);
    if friction == 0.0 {
        return (0.0, half.angle(0.0));
    }
    // Sine and cosine of the angle of friction, so that no friction is too great: W = h (sin λ g − cos λ h)/(cos λ R⁴).
    let scale = libm::hypot(1.0, friction);
    let (sin, cos) = (friction / scale, 1.0 / scale);
    // Above this h, where the friction's line leaves the slot, W is negative: μ g = h.
    let end = sin * ((sin * sin + half.shape).sqrt() - sin);
    let rising = |h: f64| {
        let (g2, square) = (half.cross_squared(h), half.radius_squared(h));
        let g = g2.sqrt();
        // −dW/dθ times R⁶ cos λ, which has the sign of dW/dh: h falls as θ grows.
        let from_friction = (g2 - h * h - h) * square + 4.0 * g2 * h;
        sin * from_friction - cos * 2.0 * h * g * (square + 2.0 * h) > 0.0
    };
    let h = bisect([0.0, end], rising)[1];
    let square = half.radius_squared(h);
    (h * (friction * half.cross_squared(h).sqrt() - h) / (square * square), half.angle(h))
}

/// One half of the engagement, by h = a cos θ − 1.
struct Half {
    /// a.
    ratio: f64,
    /// b = a² − 1.
    shape: f64,
}

impl Half {
    fn new(mechanism: Mechanism) -> Self {
        Self { ratio: mechanism.centre_distance_ratio(), shape: mechanism.centre_distance_ratio_squared() - 1.0 }
    }

    /// R² / r² = b − 2 h.
    fn radius_squared(&self, h: f64) -> f64 {
        self.shape - 2.0 * h
    }

    /// a² sin² θ = a² − (1 + h)², as a product that loses no digits near the line of centres.
    fn cross_squared(&self, h: f64) -> f64 {
        (self.ratio - 1.0 - h) * (self.ratio + 1.0 + h)
    }

    /// Whether (i R⁴ + h²) / (h g) falls at h, for i = part/rest.
    fn falling(&self, part: f64, rest: f64, h: f64) -> bool {
        let square = self.radius_squared(h);
        let numerator = part * square * square + rest * h * h;
        let change = h * (rest * 2.0 * h - part * 4.0 * square) - numerator;
        // The derivative, times h² g³ rest.
        change * self.cross_squared(h) + numerator * h * (1.0 + h) < 0.0
    }

    fn angle(&self, h: f64) -> f64 {
        libm::atan2(self.cross_squared(h).max(0.0).sqrt(), 1.0 + h)
    }
}
