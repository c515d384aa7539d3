//! What joints do to the steady motion, beside the same escapement with ideal ones.

use super::Joints;
use super::equation::Escapement;
use super::passage::JointPassage;
use crate::DynamicsError;
use crate::Parameters;

/// A size of the joints that a series goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Varied {
    /// Radius of the pin.
    PinRadius,
    /// Radius of both journals, the same for both.
    Journals,
    /// Radius of the driver's journal.
    DriverJournal,
    /// Radius of the follower's journal.
    FollowerJournal,
    /// Friction of the journals.
    BearingFriction,
    /// Constant torque on the driver.
    DriverDragTorque,
    /// Constant torque on the follower.
    FollowerDragTorque,
}

impl Varied {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::PinRadius,
        Self::Journals,
        Self::DriverJournal,
        Self::FollowerJournal,
        Self::BearingFriction,
        Self::DriverDragTorque,
        Self::FollowerDragTorque,
    ];

    /// The joints with this size at another value.
    pub fn set(self, joints: &Joints, value: f64) -> Joints {
        match self {
            Self::PinRadius => Joints { pin_radius: value, ..*joints },
            Self::Journals => Joints { driver_journal: value, follower_journal: value, ..*joints },
            Self::DriverJournal => Joints { driver_journal: value, ..*joints },
            Self::FollowerJournal => Joints { follower_journal: value, ..*joints },
            Self::BearingFriction => Joints { bearing_friction: value, ..*joints },
            Self::DriverDragTorque => Joints { driver_drag_torque: value, ..*joints },
            Self::FollowerDragTorque => Joints { follower_drag_torque: value, ..*joints },
        }
    }
}

/// Effect of joints on the steady motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// The value of what is varied, in its own unit: that of the field of [`Joints`].
    pub value: f64,
    /// Mean speed over that with ideal joints, dimensionless.
    pub mean_speed: f64,
    /// Factor by which one engagement reduces a difference of speeds, dimensionless.
    pub multiplier: f64,
    /// Engagements in which a difference falls to 1/e, dimensionless: −1 / ln of the multiplier.
    pub decay_constant: f64,
    /// Greatest less least speed, over the mean, dimensionless.
    pub swing: f64,
    /// The steady motion itself.
    pub state: JointPassage,
}

/// Relative tolerance of the steady states.
const TOLERANCE: f64 = 1e-9;

/// The effects of these joints, one by one, each with the value that it is to be listed by.
///
/// ```
/// use geneva_dynamics::joints::{Joints, effects};
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let both = effects(&timer, [(0.0, Joints::IDEAL), (0.1, Joints::journals(0.1, 0.1))])?;
/// assert_eq!(both[0].mean_speed, 1.0); // over the mean speed with ideal joints
/// assert!(both[1].mean_speed < 1.0); // journals with friction slow it down
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// As for [`Escapement::new`] and [`Escapement::steady_state`]; without friction in the slot the ideal escapement has
/// no terminal speed to compare with ([`DynamicsError::NoTerminalSpeed`]).
pub fn effects(
    parameters: &Parameters,
    joints: impl IntoIterator<Item = (f64, Joints)>,
) -> Result<Vec<Effect>, DynamicsError> {
    let steady = |joints| -> Result<JointPassage, DynamicsError> {
        Ok(Escapement::new(parameters, joints)?.steady_state(TOLERANCE)?.state)
    };
    let ideal = steady(Joints::IDEAL)?;
    let effect = |(value, joints)| {
        let state = steady(joints)?;
        Ok(Effect {
            value,
            mean_speed: state.mean_speed / ideal.mean_speed,
            multiplier: state.multiplier,
            decay_constant: -1.0 / libm::log(state.multiplier),
            swing: (state.peak.speed - state.minimum.speed) / state.mean_speed,
            state,
        })
    };
    joints.into_iter().map(effect).collect()
}

/// The effects while one size goes through these values and the others stay: what a figure draws.
///
/// ```
/// use geneva_dynamics::joints::{Joints, Varied, series};
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let values = [0.0, 0.1, 0.2]; // of the driver's drag torque, in the unit of the torque
/// let series = series(&timer, &Joints::IDEAL, Varied::DriverDragTorque, values)?;
/// // A drag torque on the driver is torque that is missing: speeds go as its root.
/// for effect in series {
///     assert!((effect.mean_speed - (1.0 - effect.value).sqrt()).abs() < 1e-8);
/// }
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// As for [`effects`].
pub fn series(
    parameters: &Parameters,
    joints: &Joints,
    varied: Varied,
    values: impl IntoIterator<Item = f64>,
) -> Result<Vec<Effect>, DynamicsError> {
    effects(parameters, values.into_iter().map(|value| (value, varied.set(joints, value))))
}
