//! What can't be mounted, and what to change.

use geneva_kinematics::KinematicsError;
use thiserror::Error;

/// What can't be mounted as it was chosen: which part, by how much, and what to change.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MountingError {
    /// A tolerance that no mesh has.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// An archive that could not be packed.
    #[error("the file could not be packed: {0}")]
    Archive(String),
    /// A kerf that no cut has, or that is too wide for a part.
    #[error(
        "kerf {kerf} mm: {}; give the width that the beam takes away",
        part.map_or_else(
            || "it must be finite and not negative".to_owned(),
            |part| format!("it is too wide for a hollow or a hole of the {part}")
        )
    )]
    Kerf {
        /// What was asked for, in millimetres.
        kerf: f64,
        /// Which part, if it is too wide for one.
        part: Option<&'static str>,
    },
    /// A thickness that is not positive and finite.
    #[error("thickness {asked} mm: it must be above zero and finite; give how thick the {part} is")]
    Thickness {
        /// Of which part.
        part: &'static str,
        /// What was asked for, in millimetres.
        asked: f64,
    },
    /// A keyway, a flat or a shoulder without a shaft.
    #[error("{part}: {what} needs a shaft, and its diameter is missing; give it in millimetres")]
    NoShaft {
        /// Which part.
        part: &'static str,
        /// What needs one.
        what: &'static str,
    },
    /// A shaft for which the standard has no key.
    #[error(
        "{part}: DIN 6885 has keys for shafts from {least} to {most} mm, not for {shaft} mm; choose such a shaft, or a flat"
    )]
    Keyed {
        /// Which part.
        part: &'static str,
        /// Diameter of the shaft, in millimetres.
        shaft: f64,
        /// Least diameter with a key, in millimetres.
        least: f64,
        /// Greatest diameter with a key, in millimetres.
        most: f64,
    },
    /// A flat that is not on its shaft.
    #[error(
        "{part}: a flat {across} mm from the opposite side of a shaft of {shaft} mm; it must be more than half of the shaft and \
         less than all of it"
    )]
    Flat {
        /// Which part.
        part: &'static str,
        /// From the flat to the opposite side, in millimetres.
        across: f64,
        /// Diameter of the shaft, in millimetres.
        shaft: f64,
    },
    /// A flat that does not hold its part.
    #[error(
        "{part}: a shaft of {shaft} mm that is {across} mm across its flat turns in a bore with {play:.3} mm of play, as much as the flat \
         is deep; choose a deeper flat, or less play of the bore"
    )]
    LooseFlat {
        /// Which part.
        part: &'static str,
        /// From the flat to the opposite side, in millimetres.
        across: f64,
        /// Diameter of the shaft, in millimetres.
        shaft: f64,
        /// Diameter of the bore less that of the shaft, in millimetres.
        play: f64,
    },
    /// A pattern whose numbers make no holes.
    #[error("{what} {asked}: it must be {range}; give such a number")]
    Pattern {
        /// Which number.
        what: &'static str,
        /// What was asked for.
        asked: f64,
        /// What it may be.
        range: &'static str,
    },
    /// A base plate for an internal wheel.
    #[error(
        "an internal wheel has its shaft in front and its driver's behind, so no base plate carries both; leave it out"
    )]
    BaseOfInternal,
    /// A bush on a screw in an internal wheel, whose ring plate leaves no room for head or nut.
    #[error(
        "the screw {screw} in a bush of {pin} mm has its head or nut above the ring, where the ring plate is {room:.3} mm away; choose a pin \
         of {thread} mm, which is then the screw itself, or a dowel"
    )]
    HeadUnderRing {
        /// The screw's thread.
        screw: &'static str,
        /// Diameter of the screw, in millimetres.
        thread: f64,
        /// Diameter of the pin, in millimetres.
        pin: f64,
        /// Gap between bush and ring plate, in millimetres.
        room: f64,
    },
    /// A screw that is thicker than the pin.
    #[error("the screw {screw} is thicker than the pin of {pin} mm; choose a thinner screw, or a thicker pin")]
    ThickScrew {
        /// The screw's thread.
        screw: &'static str,
        /// Diameter of the pin, in millimetres.
        pin: f64,
    },
    /// A bush between screw and pin without a wall.
    #[error(
        "the screw {screw} needs a pin as thick as the screw or of at least {least} mm, which leaves a wall to its bush, not of {pin} \
         mm; choose a thinner screw, or a thicker pin"
    )]
    ThinBush {
        /// The screw's thread.
        screw: &'static str,
        /// Diameter of the pin, in millimetres.
        pin: f64,
        /// What it is at least with a bush, in millimetres.
        least: f64,
    },
    /// A hole that comes out of its part, or runs into another hole.
    #[error("{part}: {hole} runs into {other} by {by:.3} mm; {remedy}")]
    BreaksOut {
        /// Which part.
        part: &'static str,
        /// Which hole.
        hole: &'static str,
        /// What it runs into.
        other: &'static str,
        /// By how much, in millimetres.
        by: f64,
        /// What to change.
        remedy: &'static str,
    },
    /// A locking disc or segment in one piece with a plate that it touches nowhere.
    #[error(
        "{part}: {hole} of the plate is wider than the {part}, so the two can't be one piece; choose a thinner shaft of the plate, or two \
         pieces"
    )]
    Floating {
        /// Which part.
        part: &'static str,
        /// Over which hole of the plate it is.
        hole: &'static str,
        /// The width of a round hole that the part just covers, in millimetres.
        width: f64,
    },
    /// A pocket or a shoulder that is as deep as its part is thick.
    #[error(
        "{part}: {hole} has a pocket of {depth} mm, but the part is only {thickness} mm thick; {remedy}, or a thicker part"
    )]
    TooDeep {
        /// Which part.
        part: &'static str,
        /// Which hole.
        hole: &'static str,
        /// Depth of the pocket, in millimetres.
        depth: f64,
        /// Thickness of the part, in millimetres.
        thickness: f64,
        /// What to change.
        remedy: &'static str,
    },
}
