//! Sizes that no made wheel has, and how far made sizes are from the drawn ones.

use super::random::SplitMix64;
use thiserror::Error;

/// A size that no wheel has, however badly it was made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum BuiltError {
    /// A length that is not positive and finite.
    #[error("{name} {} mm: it must be positive and finite; measure it again", short(*asked))]
    Length {
        /// Which length.
        name: &'static str,
        /// The length that was given, in millimetres.
        asked: f64,
    },
    /// A direction that is half a pitch or more off, or not finite.
    #[error(
        "{name} {:.2}° off: it must be within {:.2}°, half a pitch, of its right place; count the slots again",
        .asked.to_degrees(),
        .most.to_degrees()
    )]
    Direction {
        /// Which direction.
        name: &'static str,
        /// The error that was given, in radians.
        asked: f64,
        /// What its size must be below, in radians.
        most: f64,
    },
    /// A slot as wide as the wheel.
    #[error(
        "width of a slot {} mm: it must be at most {} mm, just below the wheel's diameter; measure it again",
        short(*asked),
        short_below(*most)
    )]
    TooWide {
        /// The width that was given, in millimetres.
        asked: f64,
        /// What it must be below, in millimetres.
        most: f64,
    },
    /// A crank as long as the centre distance.
    #[error(
        "crank radius {} mm: it must be at most {} mm, just below the centre distance; measure both again",
        short(*asked),
        short_below(*most)
    )]
    CrankTooLong {
        /// The crank radius that was given, in millimetres.
        asked: f64,
        /// What it must be below, in millimetres.
        most: f64,
    },
    /// A mouth that doesn't come to the rim, or leaves nothing of a wall.
    #[error(
        "{name} {} mm: it must be at most {} mm, or it leaves nothing of a slot's wall or doesn't come to the rim; measure it again",
        short(*asked),
        short_below(*most)
    )]
    Mouth {
        /// Which size of the mouths.
        name: &'static str,
        /// The size that was given, in millimetres.
        asked: f64,
        /// What it must be below, in millimetres.
        most: f64,
    },
    /// An angle that no chamfer has.
    #[error("angle of the chamfer {:.2}°: it must be above 0° and below 90°; measure it again", .asked.to_degrees())]
    ChamferAngle {
        /// The angle to the slot's wall that was given, in radians.
        asked: f64,
    },
    /// A lead-in that opens by more than its own length.
    #[error(
        "flare of the lead-in {} mm: it must be at most {} mm, the length of the lead-in; measure both again",
        short(*asked),
        short(*most)
    )]
    Flare {
        /// The flare that was given, in millimetres.
        asked: f64,
        /// What it must be at most, in millimetres.
        most: f64,
    },
}

/// A length to four significant digits.
fn short(length: f64) -> f64 {
    format!("{length:.3e}").parse().unwrap_or(length)
}

/// The greatest length of four significant digits, or the one before it, that is below another.
fn short_below(length: f64) -> f64 {
    let nearest = short(length);
    if nearest < length { nearest } else { short(length * (1.0 - 1e-3)) }
}

/// How the errors of a size are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorShape {
    /// Every error up to the greatest is equally likely.
    Uniform,
    /// A normal distribution whose standard deviation is a third of the greatest error; larger errors are drawn again.
    Normal,
}

impl ErrorShape {
    /// The next error over the greatest, from −1 to 1.
    pub(crate) fn draw(self, random: &mut SplitMix64) -> f64 {
        match self {
            Self::Uniform => random.next_signed(),
            Self::Normal => loop {
                let part = random.next_normal() / 3.0;
                if part.abs() <= 1.0 {
                    return part;
                }
            },
        }
    }
}

/// The greatest error of each size, to either side, in millimetres.
///
/// ```
/// use geneva_kinematics::wheel::as_built::SizeErrors;
///
/// let errors = SizeErrors { centre_distance: 0.05, ..SizeErrors::from_greatest(0.1) };
/// assert_eq!((errors.centre_distance, errors.pin_diameter), (0.05, 0.1)); // mm
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeErrors {
    /// Of the distance between the axes, in millimetres.
    pub centre_distance: f64,
    /// Of the distance of a pin from the driver's axis, in millimetres.
    pub crank_radius: f64,
    /// Of a pin's diameter, in millimetres.
    pub pin_diameter: f64,
    /// Of a slot's width, in millimetres.
    pub slot_width: f64,
    /// Of the distance of a slot's end from the wheel's axis, in millimetres.
    pub slot_end: f64,
    /// Of the rim's radius at a slot, in millimetres.
    pub tip_radius: f64,
    /// Of the radius of a locking arc, in millimetres.
    pub arc_radius: f64,
    /// Of the radius of the locking disc, in millimetres.
    pub disc_radius: f64,
    /// Of the radius of a crescent, in millimetres.
    pub crescent_radius: f64,
    /// Of the place of a slot at the rim, of the centres of locking arcs and crescents and of a pin, across and along their
    /// radius, in millimetres.
    pub place: f64,
}

impl SizeErrors {
    /// Errors of all sizes with one greatest error, in millimetres.
    pub const fn from_greatest(error: f64) -> Self {
        Self {
            centre_distance: error,
            crank_radius: error,
            pin_diameter: error,
            slot_width: error,
            slot_end: error,
            tip_radius: error,
            arc_radius: error,
            disc_radius: error,
            crescent_radius: error,
            place: error,
        }
    }
}

/// A measurement that can't be used.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum MeasuredError {
    /// A length that is not positive and finite, or a direction that is not finite.
    #[error("{name} {asked}: it must be finite, and a length above zero; measure it again")]
    Value {
        /// Which size.
        name: &'static str,
        /// The value that was given, in millimetres or radians.
        asked: f64,
    },
    /// An uncertainty that is not positive and finite.
    #[error("uncertainty of {name} {asked}: it must be positive and finite; give how far the value may be off")]
    Uncertainty {
        /// Which size.
        name: &'static str,
        /// The uncertainty that was given, in millimetres or radians.
        asked: f64,
    },
    /// A slot or an arc that there is not.
    #[error("{name} number {asked}: the wheel has numbers 1 to {most}; give one of these, or none for all")]
    Number {
        /// Which size.
        name: &'static str,
        /// The number that was given, from 1.
        asked: usize,
        /// The greatest number.
        most: usize,
    },
    /// Nothing that gives the wheel a size.
    #[error(
        "nothing tells how large the wheel is; measure the centre distance, the crank radius or the outside diameter"
    )]
    NoScale,
}
