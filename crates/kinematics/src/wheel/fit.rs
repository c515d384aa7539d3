//! Errors about sizes that don't fit: what is in the way, by how much, and what to change.

use crate::KinematicsError;
use std::fmt;
use thiserror::Error;

/// A change of what was chosen that makes room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// A thinner pin.
    ThinnerPin,
    /// A thinner horn.
    ThinnerHorn,
    /// Less play of slot, locking arc or both.
    LessPlay,
    /// Less depth of the slots, at their bottom.
    LessDepth,
    /// A thicker horn.
    ThickerHorn,
}

/// A size of a mouth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MouthSize {
    /// How much of a wall a chamfer takes.
    Chamfer,
    /// Radius of a rounded mouth.
    Radius,
    /// How much of a wall a lead-in takes.
    LeadIn,
    /// How far a lead-in opens on each side.
    Flare,
}

impl fmt::Display for MouthSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Chamfer => "mouth chamfer",
            Self::Radius => "mouth radius",
            Self::LeadIn => "lead-in",
            Self::Flare => "flare of the lead-in",
        })
    }
}

/// A part on a shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShaftOf {
    /// The wheel.
    Wheel,
    /// The driver, in the plane of the wheel.
    Driver,
    /// The driver's plate.
    Plate,
}

impl fmt::Display for Remedy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ThinnerPin => "a thinner pin",
            Self::ThinnerHorn => "a thinner horn",
            Self::LessPlay => "less play",
            Self::LessDepth => "shallower slots",
            Self::ThickerHorn => "a thicker horn",
        })
    }
}

impl ShaftOf {
    /// Where else a shaft that is too thick may have room.
    fn or_elsewhere(self) -> &'static str {
        if self == Self::Driver { ", or let it end in the plate, which has its own bore" } else { "" }
    }
}

impl fmt::Display for ShaftOf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Wheel => "wheel's",
            Self::Driver => "driver's",
            Self::Plate => "the plate's",
        })
    }
}

/// A length in millimetres with as many decimals as count: fewer where it is long.
fn told(length: f64) -> String {
    let decimals = if length >= 10.0 {
        1
    } else if length >= 1.0 {
        2
    } else {
        4
    };
    format!("{length:.decimals$}")
}

fn joined_by_or(remedies: &[Remedy]) -> String {
    remedies.iter().map(Remedy::to_string).collect::<Vec<_>>().join(" or ")
}

/// Sizes from which no working parts can be made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum SizesError {
    /// A number of stations or pins, or a length, that no wheel has.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// A play or a clearance that is negative or not finite.
    #[error(
        "{name} {asked} mm: it must be finite and not negative; give zero or more, by how much the hollow is wider or deeper"
    )]
    Play {
        /// Which play or clearance.
        name: &'static str,
        /// What was asked for, in millimetres.
        asked: f64,
    },
    /// Parts in each other's way.
    #[error("{what} by {} mm; choose {}", told(*by), joined_by_or(remedies))]
    DoesNotFit {
        /// What is in the way.
        what: &'static str,
        /// By how much, in millimetres.
        by: f64,
        /// What to change: one of these, or more.
        remedies: &'static [Remedy],
    },
    /// A mouth of the slots that leaves too little of horn, rim or wall.
    #[error(
        "{name} {asked} mm: {reason}; give more than 0 and less than {most:.4} mm{}",
        if remedies.is_empty() { String::new() } else { format!(", or choose {}", joined_by_or(remedies)) }
    )]
    Mouth {
        /// Which size of the mouth.
        name: MouthSize,
        /// What was asked for, in millimetres.
        asked: f64,
        /// What it must be below, in millimetres.
        most: f64,
        /// What is in the way.
        reason: &'static str,
        /// What to change besides.
        remedies: &'static [Remedy],
    },
    /// A lead-in so flat that it is a straight wall.
    #[error(
        "flare of the lead-in {asked} mm: so flat an arc is a straight wall; give {least} mm or more, a thousandth of its length"
    )]
    TooFlat {
        /// The flare that was asked for, in millimetres.
        asked: f64,
        /// What it must be at least, in millimetres.
        least: f64,
    },
    /// A chamfer whose face is along the wall or across it.
    #[error("chamfer angle {}°: give more than 0° and less than 90°, from the slot's wall; 10° to 20° let the pin in softly", asked.to_degrees())]
    ChamferAngle {
        /// What was asked for, in radians.
        asked: f64,
    },
    /// A shaft that leaves no material, or that something runs against.
    #[error(
        "{name} shaft, diameter {asked} mm: {}",
        if *most > 0.0 {
            format!("it must be less than {most:.4} mm; give a thinner shaft{}", name.or_elsewhere())
        } else {
            "there is no room for one; let it end in the plate, or choose a thinner pin or less play".to_owned()
        }
    )]
    Shaft {
        /// Which shaft.
        name: ShaftOf,
        /// The diameter that was asked for, in millimetres.
        asked: f64,
        /// What it must be below, in millimetres.
        most: f64,
    },
}

impl SizesError {
    /// What is wrong, without what to change.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let thick = Choices { pin_diameter: Some(60.0), ..Choices::default() }; // mm, on a crank of 50 mm
    /// let refused = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &thick).expect_err("too thick");
    /// assert!(refused.to_string().starts_with(&refused.reason()) && !refused.reason().contains("choose"));
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn reason(&self) -> String {
        match self {
            Self::DoesNotFit { what, by, .. } => format!("{what} by {} mm", told(*by)),
            Self::Mouth { name, asked, reason, .. } => format!("{name} {asked} mm: {reason}"),
            Self::TooFlat { asked, .. } => {
                format!("flare of the lead-in {asked} mm: so flat an arc is a straight wall")
            }
            Self::ChamferAngle { asked } => format!("chamfer angle {}°", asked.to_degrees()),
            // How thick it may be depends on what else is changed.
            Self::Shaft { name, asked, most } if *most > 0.0 => {
                format!("{name} shaft, diameter {asked} mm: it is too thick for the parts around it")
            }
            Self::Shaft { name, asked, .. } => format!("{name} shaft, diameter {asked} mm: there is no room for one"),
            Self::Kinematics(_) | Self::Play { .. } => self.to_string(),
        }
    }
}
