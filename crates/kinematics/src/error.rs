//! What the mechanisms refuse, each with the value, the allowed range and what to do.

use crate::wheel::STATIONS;
use thiserror::Error;

/// A mechanism that cannot be built, or an angle at which it has no position or no motion.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum KinematicsError {
    /// A length that is not positive and finite.
    #[error("{name} {asked}: it must be positive and finite; give a length above zero")]
    Length {
        /// Which length.
        name: &'static str,
        /// The length that was asked for, in the caller's unit.
        asked: f64,
    },
    /// Another size that must be positive and finite and is not.
    #[error("{name} {asked}: it must be positive and finite; give a number above zero")]
    Size {
        /// What it is the size of.
        name: &'static str,
        /// What was asked for, in the caller's unit.
        asked: f64,
    },
    /// The centre distance of a pin in a slot is not finite and greater than the crank radius.
    #[error(
        "centre distance {asked}: it must be finite and greater than the crank radius {crank_radius}; move the centres \
         apart or shorten the crank"
    )]
    CentreDistance {
        /// The distance that was asked for, in the caller's unit.
        asked: f64,
        /// The crank radius that it must exceed, in the same unit.
        crank_radius: f64,
    },
    /// The number of a wheel's stations is outside [`STATIONS`].
    #[error("{0} stations: a wheel has from {least} to {most}; give a number in this range", least = STATIONS.start(), most = STATIONS.end())]
    Stations(u32),
    /// So many pins do not fit: one would enter before the one before it has left, or there is none at all.
    #[error(
        "{asked} pins: a driver for {stations} stations has {}, because otherwise a pin would enter before the previous one \
         has left; give {}",
        if *most == 1 { "only 1".to_owned() } else { format!("1 to {most}") },
        if *most == 1 { "1" } else { "a number in this range" }
    )]
    Pins {
        /// How many were asked for.
        asked: u32,
        /// The greatest number that fits.
        most: u32,
        /// The number of stations.
        stations: u32,
    },
    /// The axes of a wheel are so far apart that nothing of one part is near the other.
    #[error("centre distance {asked} mm: so far apart, the parts are nowhere near each other; give {most} mm at most")]
    TooFarApart {
        /// The distance that was asked for, in millimetres.
        asked: f64,
        /// The greatest that is looked at, in millimetres.
        most: f64,
    },
    /// The distances of driver and wheel stay nearly the same over so much of the turn that the least one is not found from
    /// the crank angles that may be looked at.
    #[error("{limit} crank angles are too few to find the least clearance; give a thicker pin or more play")]
    TooManyAngles {
        /// Crank angles that may be looked at.
        limit: u32,
    },
    /// The axes of a wheel stand where its pin never passes the rim.
    #[error(
        "centre distance wrong by a fraction of {asked}: the pin enters its slot only if this is more than {least:.4} and less \
         than {most:.4}; give a fraction in this range"
    )]
    Misplaced {
        /// The part that was asked for, dimensionless.
        asked: f64,
        /// The least part, dimensionless.
        least: f64,
        /// The greatest part, dimensionless.
        most: f64,
    },
    /// A wheel's crank angle beyond half a turn to either side, or not finite, in radians.
    #[error("crank angle {0} rad: within a turn it goes from −π to π; count whole turns separately")]
    Turn(f64),
    /// A wheel's crank angle outside the engagement, or not finite.
    #[error(
        "crank angle {asked} rad: the pin is in the slot from −{most:.4} to {most:.4} rad from the line of centres; give an \
         angle in this range"
    )]
    OutsideEngagement {
        /// The angle asked for, in radians.
        asked: f64,
        /// The greatest angle allowed to either side, in radians.
        most: f64,
    },
    /// A wheel angle that no pin in a slot gives, or that is not finite.
    #[error(
        "wheel angle {asked} rad: during an index it goes from −{most:.4} to {most:.4} rad; give an angle in this range"
    )]
    WheelAngle {
        /// The angle asked for, in radians.
        asked: f64,
        /// The greatest to either side of the middle, in radians.
        most: f64,
    },
    /// Lengths of a quick-return mechanism so different that their ratio is not a number a machine can hold.
    #[error(
        "ground distance {ground} and crank {crank}: their ratio is too large or too small to compute with; give lengths of \
         one mechanism"
    )]
    Ratio {
        /// The ground distance, in the caller's unit.
        ground: f64,
        /// The crank's length, in the same unit.
        crank: f64,
    },
    /// An angle that is not finite.
    #[error("{name} {asked}: it must be finite; give an angle in degrees")]
    Angle {
        /// Which angle.
        name: &'static str,
        /// The angle that was asked for, in degrees.
        asked: f64,
    },
    /// The lever's ray does not meet the crank's circle.
    #[error(
        "lever angle {asked}° is out of reach: the lever swings {} −{limit:.4}° and {limit:.4}° from the direction to the \
         crank's axis; give an angle in this range, or a crank angle (all are possible)",
        if *open { "between, but not to," } else { "between" }
    )]
    BeyondTheSwing {
        /// The lever angle that was asked for, in degrees.
        asked: f64,
        /// The greatest possible, in degrees; it is excluded if `open`.
        limit: f64,
        /// Whether the limit itself is impossible.
        open: bool,
    },
    /// The lever's pivot is inside the crank's circle or on it: its ray leaves the circle once.
    #[error(
        "lever angle {asked}°, near branch: the crank is at least as long as the ground distance, so the lever's ray meets \
         the crank's circle only once; take the far branch"
    )]
    OnlyFar {
        /// The lever angle that was asked for, in degrees.
        asked: f64,
    },
    /// The pin is on the lever's pivot, where the lever has no direction.
    #[error(
        "crank angle 180°: with a crank as long as the ground distance, the pin is on the lever's pivot and the lever has \
         no direction; give any other crank angle"
    )]
    PinOnPivot,
}

/// The length, if it is positive and finite.
pub(crate) fn length(name: &'static str, asked: f64) -> Result<f64, KinematicsError> {
    if asked > 0.0 && asked.is_finite() { Ok(asked) } else { Err(KinematicsError::Length { name, asked }) }
}

/// The size, if it is positive and finite.
pub(crate) fn size(name: &'static str, asked: f64) -> Result<f64, KinematicsError> {
    if asked > 0.0 && asked.is_finite() { Ok(asked) } else { Err(KinematicsError::Size { name, asked }) }
}
