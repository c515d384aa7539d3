//! Where there is one acceleration: the follower must not lock, and the driver must not jam.
//!
//! **Locking.** A normal force on the leading flank turns the follower with the arm R − σ μ ρ less the journal's. R is
//! least on the line of centres, a − 1, where the pin's surface slides outward (σ = +): so λ > 0 everywhere if and only
//! if μ ρ + μ_b r_b √(1 + μ²) < a − 1. On the trailing flank the journal's arm is added instead, and the pin slides
//! outward only where R exceeds a − 1: there λ > 0 all the more.
//!
//! **Jamming.** With λ > 0 the equation's left side, as a function of θ'', has the slopes I_D/I_f + m q, one for each
//! flank; both must be positive, as A > |D| must in the ideal model, to which the margin goes over. No closed form is
//! known for where the least of them is: it is looked for on a grid, and about its lowest point refined.

use super::equation::Escapement;
use crate::{DynamicsError, Sign};
use geneva_kinematics::Mechanism;

/// The least factor of θ'' over I_f in an engagement, over both flanks; positive in a sound escapement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastJointMargin {
    /// I_D/I_f + m q there, dimensionless; A − |D| if the joints are ideal.
    pub margin: f64,
    /// Crank angle in radians from the line of centres.
    pub angle: f64,
    /// The flank on which that is; plus for the leading one.
    pub flank: Sign,
}

/// Radius in crank radii from which on the ends of two neighbouring slots run into one another: 1 − 1/a.
///
/// The slots end about the points where the pin's centre is nearest to the axis, a − 1 from it and 2π/n apart; half
/// their distance is (a − 1) sin(π/n). The equation of motion does not ask for it: the slots may lie in two planes.
///
/// ```
/// use geneva_dynamics::joints::largest_pin_radius;
/// use geneva_kinematics::Mechanism;
///
/// assert_eq!(largest_pin_radius(Mechanism::THREE_PIN), 0.5); // a = 2, in crank radii
/// ```
pub fn largest_pin_radius(mechanism: Mechanism) -> f64 {
    1.0 - 1.0 / mechanism.centre_distance_ratio()
}

/// Points of the grid over one engagement.
const GRID: u32 = 2048;

impl Escapement {
    /// An error unless the equation of motion has one solution in every pose and at every speed.
    pub(super) fn exists(&self) -> Result<(), DynamicsError> {
        let lever = self.parameters().mechanism().centre_distance_ratio() - 1.0;
        let taken = self.parameters().friction() * self.joints().pin_radius + self.journals.follower;
        // Written so that what is not a number is refused.
        let turns = taken < lever;
        if !turns {
            return Err(DynamicsError::SelfLocking { taken, lever });
        }
        let LeastJointMargin { margin, angle, .. } = self.least_margin();
        if margin > 0.0 { Ok(()) } else { Err(DynamicsError::Jams { margin, angle }) }
    }

    /// The least factor of θ'' in the engagement: how far the escapement is from jamming.
    ///
    /// ```
    /// use geneva_dynamics::joints::{Escapement, Joints};
    /// use geneva_dynamics::{Inertias, Parameters, existence};
    /// use geneva_kinematics::Mechanism;
    ///
    /// // With ideal joints it is A − |D|.
    /// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(0.1, 1.0)?, 1.0, 0.2)?;
    /// let ideal = Escapement::new(&timer, Joints::IDEAL)?;
    /// let expected = existence::least_margin(Mechanism::FOUR_PIN, 0.1, 0.2)?;
    /// assert!((ideal.least_margin().margin - expected.margin).abs() < 1e-12);
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    pub fn least_margin(&self) -> LeastJointMargin {
        let half = self.parameters().mechanism().engagement_half_angle();
        let step = 2.0 * half / f64::from(GRID);
        let candidates = Sign::BOTH.into_iter().map(|flank| {
            let at = |angle: f64| self.margin(angle.clamp(-half, half), flank);
            let nodes = (0..=GRID).map(|k| step * f64::from(k) - half);
            let worst = nodes.fold((f64::INFINITY, 0.0), |best, angle| {
                let margin = at(angle);
                if margin < best.0 { (margin, angle) } else { best }
            });
            let (margin, angle) = refined(at, worst, step);
            LeastJointMargin { margin, angle: angle.clamp(-half, half), flank }
        });
        candidates.fold(LeastJointMargin { margin: f64::INFINITY, angle: 0.0, flank: Sign::Plus }, |best, new| {
            if new.margin < best.margin { new } else { best }
        })
    }

    /// I_D/I_f + m q at an angle, on a flank.
    fn margin(&self, angle: f64, flank: Sign) -> f64 {
        let place = self.place(angle);
        let sliding = Sign::from_number(place.reach.sliding(&self.joints().pin_radius, flank));
        let arms = self.arms(&place.reach, flank, sliding);
        place.terms.slope(&(arms.driver / arms.follower))
    }
}

/// Value and place of the lowest point within a step of one that is known, by thirds.
fn refined(at: impl Fn(f64) -> f64, worst: (f64, f64), step: f64) -> (f64, f64) {
    let (mut low, mut high, mut best) = (worst.1 - step, worst.1 + step, worst);
    for _ in 0..60 {
        let third = (high - low) / 3.0;
        let (first, second) = (low + third, high - third);
        let (left, right) = (at(first), at(second));
        let lower = if left < right { (left, first) } else { (right, second) };
        if lower.0 < best.0 {
            best = lower;
        }
        if left < right { high = second } else { low = first }
    }
    best
}
