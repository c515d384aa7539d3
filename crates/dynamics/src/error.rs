//! Why there is no answer: one type for the whole crate.

/// A value that no escapement can have, or a motion that it does not have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DynamicsError {
    /// A quantity that must be positive and finite is not.
    #[error("{name} {asked}: it must be positive and finite; give a number above zero")]
    NotPositive {
        /// Which quantity.
        name: &'static str,
        /// What was asked for, in the quantity's own unit.
        asked: f64,
    },
    /// A quantity that must be finite and not negative is not.
    #[error("{name} {asked}: it must be finite and not negative; give zero or more")]
    Negative {
        /// Which quantity.
        name: &'static str,
        /// What was asked for, in the quantity's own unit.
        asked: f64,
    },
    /// A quantity that must be finite is not.
    #[error("{name} {asked}: it must be finite; give a number")]
    NotFinite {
        /// Which quantity.
        name: &'static str,
        /// What was asked for, in the quantity's own unit.
        asked: f64,
    },
    /// A quantity outside its range.
    #[error("{name} {asked}: it must be from {least} to {most}; give a number in this range")]
    OutOfRange {
        /// Which quantity.
        name: &'static str,
        /// What was asked for, in the quantity's own unit.
        asked: f64,
        /// The least that is allowed, in the same unit.
        least: f64,
        /// The greatest that is allowed, in the same unit.
        most: f64,
    },
    /// A speed of the driver that is negative or not finite, or whose square is not finite.
    #[error(
        "{name} {asked}: it must not be negative, because friction is taken to oppose forward motion, and its square must \
         be finite; give zero or more"
    )]
    Speed {
        /// Which speed.
        name: &'static str,
        /// What was asked for, in radians per unit of time.
        asked: f64,
    },
    /// So much friction that somewhere no acceleration, or more than one, obeys the equation of motion.
    #[error(
        "friction coefficient {asked} is too high for this mechanism: from about {} on it may jam, because the motion is \
         not determined {:.1}° from the line of centres; give less friction or a driver with more inertia",
        four_digits(*.limit),
        .angle.to_degrees()
    )]
    TooMuchFriction {
        /// What was asked for, dimensionless.
        asked: f64,
        /// The friction that it must stay below, dimensionless.
        limit: f64,
        /// Crank angle in radians, to either side of the line of centres, where the limit is first reached.
        angle: f64,
    },
    /// A ≤ |D|, or a coefficient that is not a number: no acceleration, or more than one.
    #[error(
        "A = {} is not more than |D| = {}, so the motion is not determined; lower the friction or raise the driver's \
         inertia",
        four_digits(*.a),
        four_digits(*.d)
    )]
    NotUnique {
        /// A, dimensionless.
        a: f64,
        /// |D|, dimensionless.
        d: f64,
    },
    /// A reset angle that is not positive, or that takes the pin past the far side of its circle.
    #[error(
        "reset angle {asked} rad: the driver's angle must be reset after more than 0 and less than {} rad, where the pin \
         is farthest from the follower; give 2π over the number of pins, or another angle in this range",
        four_digits(*.limit)
    )]
    Reset {
        /// What was asked for, in radians.
        asked: f64,
        /// The greatest possible, in radians: π + π/m.
        limit: f64,
    },
    /// So near the critical friction, or with such different inertias, that the motion has no scale to be computed at.
    #[error(
        "A - |D| = {margin:.1e} at a crank angle of {:.2}°: the motion changes there too quickly to be computed; lower the \
         friction, or choose inertias that differ less",
        .angle.to_degrees()
    )]
    TooSharp {
        /// Crank angle in radians where the equation changes too quickly.
        angle: f64,
        /// A − |D| there, dimensionless.
        margin: f64,
    },
    /// Nothing brakes faster running more than slower running: the speed grows without end.
    #[error(
        "there is no terminal speed, because a difference of speeds doesn't shrink from one engagement to the next (the \
         multiplier is {}); give friction that grows with the load, in the slot or in the bearings",
        four_digits(*.multiplier)
    )]
    NoTerminalSpeed {
        /// Multiplier of the return map, dimensionless; one, or within rounding of it.
        multiplier: f64,
    },
    /// More engagements, or more printed lines, than are allowed.
    #[error("more than {limit} {name} are needed; allow more, or give less time or more friction")]
    TooMany {
        /// Engagements, or printed lines.
        name: &'static str,
        /// How many are allowed.
        limit: usize,
    },
    /// A pin as thick as its crank is long, or thicker.
    #[error(
        "pin radius {asked} crank radii: it must be below 1, because otherwise the pin's surface slides one way only; give \
         a thinner pin"
    )]
    PinTooThick {
        /// The radius that was asked for, in crank radii.
        asked: f64,
    },
    /// A constant drag torque on the driver that the driving torque does not overcome.
    #[error(
        "driver's drag torque {asked}: the driving torque {torque} can't overcome it; give less drag torque or more torque"
    )]
    DragTorque {
        /// What was asked for, in the unit of the driving torque.
        asked: f64,
        /// The driving torque, in its own unit.
        torque: f64,
    },
    /// Friction on the pin's surface and in the follower's journal holds the follower against any normal force.
    #[error(
        "the mechanism locks itself: the friction of pin and follower's journal has an arm of {} crank radii, but on the \
         line of centres the normal force has only {}; give a thinner pin, a thinner journal or less friction",
        four_digits(*.taken),
        four_digits(*.lever)
    )]
    SelfLocking {
        /// μ ρ + μ_b r_b √(1 + μ²), the arm of the friction in crank radii.
        taken: f64,
        /// a − 1, the arm of the normal force on the line of centres, in crank radii.
        lever: f64,
    },
    /// With these joints somewhere no acceleration, or more than one, obeys the equation of motion.
    #[error(
        "the mechanism may jam {:.1}° from the line of centres: the motion is determined only where the factor of the \
         acceleration is positive, but there it is {}; give less friction, thinner joints or a driver with more inertia",
        .angle.to_degrees(),
        four_digits(*.margin)
    )]
    Jams {
        /// The factor of θ'' over I_f there, dimensionless; not positive.
        margin: f64,
        /// Crank angle in radians from the line of centres.
        angle: f64,
    },
    /// A crank angle outside the engagement, or not a number.
    #[error(
        "crank angle {asked} rad: a pin is in its slot from -{limit:.4} to {limit:.4} rad; give an angle in this range"
    )]
    OutsideTheSlot {
        /// What was asked for, in radians.
        asked: f64,
        /// Greatest angle to either side of the line of centres, in radians.
        limit: f64,
    },
    /// The driver comes to rest within an engagement.
    #[error(
        "the driver comes to rest about {:.1}° from the line of centres, because friction takes more than the torque \
         gives; give more torque, less drag torque or a faster start",
        .angle.to_degrees()
    )]
    Stalls {
        /// Crank angle in radians about which it does.
        angle: f64,
    },
    /// No speed was found that the return map leaves unchanged.
    #[error(
        "no steady speed was found: an engagement entered at {} is left at {}; give more steps, less drag torque or more \
         friction that grows with the load",
        four_digits(*.entry),
        four_digits(*.exit)
    )]
    NotRepeated {
        /// Speed at the last entry that was tried, in radians per unit of time.
        entry: f64,
        /// Speed at the exit that it led to, in radians per unit of time.
        exit: f64,
    },
    /// The steps that are allowed do not reach the tolerance.
    #[error(
        "relative tolerance {tolerance}: even with the most steps allowed, halving them still changes the result by \
         {reached:.1e}; allow more, or give less friction or inertias that differ less"
    )]
    NotSettled {
        /// Relative tolerance that was asked for, dimensionless.
        tolerance: f64,
        /// Relative change when the steps were last halved, dimensionless.
        reached: f64,
    },
}

/// A number in a message, to four significant digits.
fn four_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    rounded.to_string()
}

/// The value, if it is positive and finite.
pub(crate) fn positive(name: &'static str, asked: f64) -> Result<f64, DynamicsError> {
    if asked > 0.0 && asked.is_finite() { Ok(asked) } else { Err(DynamicsError::NotPositive { name, asked }) }
}

/// The value, if it is finite and not negative.
pub(crate) fn not_negative(name: &'static str, asked: f64) -> Result<f64, DynamicsError> {
    if asked >= 0.0 && asked.is_finite() { Ok(asked) } else { Err(DynamicsError::Negative { name, asked }) }
}
