//! What is said of sizes that do not fit: what, by how much, and what to change.

use crate::KinematicsError;
use thiserror::Error;

/// Sizes of which no two parts can be made that run in each other.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum SizesError {
    /// A number of stations or pins, or a length, that no wheel has.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// A play that is negative or not finite.
    #[error("{name} {asked} mm: it must be zero or more and finite; give how much wider the hollow is")]
    Play {
        /// Which play.
        name: &'static str,
        /// What was asked for, in millimetres.
        asked: f64,
    },
    /// Parts in each other's way.
    #[error("{what}, by {by:.4} mm; {change}")]
    DoesNotFit {
        /// What is in the way.
        what: &'static str,
        /// By how much, in millimetres.
        by: f64,
        /// What to change.
        change: &'static str,
    },
    /// A shaft that leaves no material, or that something runs against.
    #[error(
        "{name}, diameter {asked} mm: it must be less than {most:.4} mm{}",
        if *most > 0.0 { "; take a thinner shaft" } else { ", so there is no room for one in the plane of the wheel" }
    )]
    Shaft {
        /// Which shaft.
        name: &'static str,
        /// The diameter that was asked for, in millimetres.
        asked: f64,
        /// What it must be below, in millimetres.
        most: f64,
    },
}
