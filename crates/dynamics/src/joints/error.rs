//! What joints an escapement cannot have, and why there is no steady motion with them.

use super::STEPS;
use std::fmt;

/// Why an escapement with these joints cannot be, or does not run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointError {
    /// A size, friction or preload that is negative or not finite.
    Value {
        /// Which.
        name: &'static str,
        /// What was asked for.
        asked: f64,
    },
    /// A pin as thick as its crank is long, or thicker.
    PinTooThick {
        /// Radius over crank radius that was asked for.
        asked: f64,
    },
    /// A preload on the driver that the driving torque does not overcome.
    Preload {
        /// What was asked for.
        asked: f64,
        /// The driving torque.
        torque: f64,
    },
    /// Friction on the pin's surface and in the follower's journal holds the follower against any normal force.
    SelfLocking {
        /// μ ρ + μ_b r_b √(1 + μ²), the arm of the friction in crank radii.
        taken: f64,
        /// a − 1, the arm of the normal force on the line of centres.
        lever: f64,
    },
    /// Somewhere no acceleration, or more than one, obeys the equation of motion.
    NotUnique {
        /// The factor of θ'' over I_f there; not positive.
        margin: f64,
        /// Crank angle in radians from the line of centres.
        angle: f64,
    },
    /// A crank angle outside the engagement, or not a number.
    Angle {
        /// What was asked for.
        asked: f64,
        /// Greatest angle to either side of the line of centres.
        limit: f64,
    },
    /// A speed that is negative or not finite, or whose square is.
    Speed(f64),
    /// A number of steps outside [`STEPS`].
    Steps(u32),
    /// The driver comes to rest within an engagement.
    Stalls {
        /// Crank angle in radians about which it does.
        angle: f64,
    },
    /// Nothing brakes faster running more than slower running: the speed grows without end.
    NoTerminalSpeed {
        /// Factor by which two motions approach one another in one engagement; one, or within rounding of it.
        contraction: f64,
    },
    /// No speed was found that an engagement hands on unchanged.
    NotRepeated {
        /// Speed at the last entry that was tried.
        entry: f64,
        /// Speed at the exit that it led to.
        exit: f64,
    },
    /// The steps that are allowed do not reach the tolerance.
    NotSettled {
        /// Relative tolerance that was asked for.
        tolerance: f64,
        /// Relative change when the steps were last halved.
        reached: f64,
    },
}

impl fmt::Display for JointError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value { name, asked } => {
                write!(f, "{name} {asked}: it must be finite and not negative; give zero or more")
            }
            Self::PinTooThick { asked } => write!(
                f,
                "pin radius {asked} crank radii: it must be below 1, or the pin's surface slides one way only; give a \
                 thinner pin"
            ),
            Self::Preload { asked, torque } => write!(
                f,
                "driver's preload {asked}: the driving torque {torque} does not overcome it; give less preload or more \
                 torque"
            ),
            Self::SelfLocking { taken, lever } => write!(
                f,
                "self-locking: friction of pin and follower's journal has the arm {taken} crank radii, and on the line \
                 of centres the normal force has only {lever}; give a thinner pin, a thinner journal or less friction"
            ),
            Self::NotUnique { margin, angle } => write!(
                f,
                "the factor of the acceleration is {margin} at {angle} rad from the line of centres, and must be \
                 positive for one solution; give less friction, thinner joints or a driver with more inertia"
            ),
            Self::Angle { asked, limit } => {
                write!(
                    f,
                    "crank angle {asked} rad: a pin is in its slot from -{limit} to {limit}; give an angle between"
                )
            }
            Self::Speed(asked) => {
                write!(
                    f,
                    "driver speed {asked}: it and its square must be finite, and it not negative; give zero or more"
                )
            }
            Self::Steps(asked) => write!(
                f,
                "{asked} steps: they must be from {} to {}; give a number between",
                STEPS.start(),
                STEPS.end()
            ),
            Self::Stalls { angle } => write!(
                f,
                "the driver comes to rest at about {angle} rad from the line of centres: friction takes more than the \
                 torque gives; give more torque, less preload or a faster start"
            ),
            Self::NoTerminalSpeed { contraction } => write!(
                f,
                "no terminal speed: an engagement takes a difference of speeds to {contraction} of itself; give \
                 friction that grows with the load, in the slot or in the bearings"
            ),
            Self::NotRepeated { entry, exit } => write!(
                f,
                "no steady speed found: an engagement entered at {entry} is left at {exit}; give more steps, less \
                 preload or more friction that grows with the load"
            ),
            Self::NotSettled { tolerance, reached } => write!(
                f,
                "relative tolerance {tolerance}: with the most steps allowed, halving them still changes the result by \
                 {reached}; allow more, or take less friction or inertias that are less different"
            ),
        }
    }
}

impl std::error::Error for JointError {}
