//! The motion that repeats itself.
//!
//! One engagement takes u at entry to a u at exit that grows with it, and the passage knows how fast: its multiplier
//! is the slope of that function. So Newton's method finds the u that is handed on unchanged.

use super::equation::Escapement;
use super::passage::{JointPassage, STEPS};
use crate::DynamicsError;

/// A steady state with what halving the steps told of its error.
///
/// ```
/// use geneva_dynamics::joints::{Escapement, Joints};
/// use geneva_dynamics::steady::Engagement;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// // With ideal joints the Runge-Kutta steps find what the quadrature finds.
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let settled = Escapement::new(&timer, Joints::IDEAL)?.steady_state(1e-9)?;
/// let exact = Engagement::new(&timer)?.steady_state()?;
/// assert!((settled.state.mean_speed / exact.mean_speed - 1.0).abs() < 1e-8);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SettledPassage {
    /// The passage that repeats itself, with the finer steps.
    pub state: JointPassage,
    /// Steps that an engagement was divided into at last.
    pub steps: u32,
    /// Greatest relative change, dimensionless, of entry speed, peak, minimum, period and multiplier when the steps
    /// were last halved.
    pub change: f64,
}

/// Most trials for the speed that repeats itself; a handful is enough unless a drag torque nearly stalls the driver.
const MOST_TRIALS: u32 = 200;
/// Steps of the first attempt.
const FIRST_STEPS: u32 = 256;

impl Escapement {
    /// The passage that repeats itself, the steady state, in about so many steps an engagement ([`STEPS`]). Its error
    /// falls as their fourth power.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::OutOfRange`]; [`DynamicsError::NoTerminalSpeed`] if only constant torques brake, or nothing does;
    /// [`DynamicsError::Stalls`] if the driver slows down until it stops on the way; [`DynamicsError::NotRepeated`] if no
    /// speed was found that repeats itself.
    pub fn steady_state_in(&self, steps: u32) -> Result<JointPassage, DynamicsError> {
        let mut passage = self.running(steps)?;
        for _ in 0..MOST_TRIALS {
            let (entry, exit) = (passage.entry_speed, passage.exit_speed);
            let rest = 1.0 - passage.multiplier;
            // Within rounding: the multiplier is a sum over all steps.
            if rest <= 1e-12 {
                return Err(DynamicsError::NoTerminalSpeed { multiplier: passage.multiplier });
            }
            let excess = (exit - entry) * (exit + entry);
            if excess.abs() <= 4.0 * f64::EPSILON * entry * entry {
                return Ok(passage);
            }
            let next = self.nearer(entry * entry + excess / rest, exit, steps)?;
            let left = (next.exit_speed - next.entry_speed).abs();
            // Rounding keeps a passage of many steps from repeating itself to the last place.
            if left >= (exit - entry).abs() && left <= 1e-12 * next.entry_speed {
                return Ok(passage);
            }
            passage = next;
        }
        Err(DynamicsError::NotRepeated { entry: passage.entry_speed, exit: passage.exit_speed })
    }

    /// The passage from a square of the speed, or if that stalls, the one that follows on the last.
    ///
    /// u at exit grows with u at entry, so that passages which follow on one another go the right way, if slowly.
    fn nearer(&self, square: f64, exit: f64, steps: u32) -> Result<JointPassage, DynamicsError> {
        let follow = || self.passage_of_square(exit * exit, steps);
        if !(square > 0.0 && square.is_finite()) {
            return follow();
        }
        match self.passage_of_square(square, steps) {
            Err(DynamicsError::Stalls { .. }) => follow(),
            other => other,
        }
    }

    /// The steady state, with the steps halved until they change it by no more than a relative `tolerance`.
    ///
    /// # Errors
    ///
    /// As for [`Escapement::steady_state_in`], and [`DynamicsError::NotSettled`] if the most steps do not reach it.
    pub fn steady_state(&self, tolerance: f64) -> Result<SettledPassage, DynamicsError> {
        let mut steps = FIRST_STEPS;
        let mut coarse = self.steady_state_in(steps)?;
        loop {
            steps *= 2;
            let fine = self.steady_state_in(steps)?;
            let change = change(&coarse, &fine);
            if change <= tolerance {
                return Ok(SettledPassage { state: fine, steps, change });
            }
            if steps >= *STEPS.end() {
                return Err(DynamicsError::NotSettled { tolerance, reached: change });
            }
            coarse = fine;
        }
    }

    /// A passage that does not stall, entered as fast as need be.
    fn running(&self, steps: u32) -> Result<JointPassage, DynamicsError> {
        let mut square = self.parameters().drive();
        let mut tried = self.passage_of_square(square, steps);
        for _ in 0..20 {
            match tried {
                Err(DynamicsError::Stalls { .. }) => square *= 4.0,
                other => return other,
            }
            tried = self.passage_of_square(square, steps);
        }
        tried
    }
}

/// The greatest relative change of what a steady state is made of.
fn change(old: &JointPassage, new: &JointPassage) -> f64 {
    let of = |state: &JointPassage| {
        [state.entry_speed, state.peak.speed, state.minimum.speed, state.duration, state.multiplier]
    };
    of(old).into_iter().zip(of(new)).map(|(old, new)| ((new - old) / new).abs()).fold(0.0, f64::max)
}
