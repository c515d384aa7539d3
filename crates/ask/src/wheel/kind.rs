//! The three kinds of wheel.

use geneva_figures::{Figure, stations};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use geneva_kinematics::wheel::Wheel;

/// Kinds of wheel: how wheel and driver are arranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WheelKind {
    /// Driver beside the wheel: they turn in opposite senses.
    External,
    /// Driver inside the wheel: they turn in the same sense, the wheel for more than half of each turn.
    Internal,
    /// Axes that cross at right angles: half of each turn is motion, half is dwell.
    Spherical,
}

impl WheelKind {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::External, Self::Internal, Self::Spherical];

    /// Its name at the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::External => "external",
            Self::Internal => "internal",
            Self::Spherical => "spherical",
        }
    }

    /// How wheel and driver are arranged.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::External => "Driver beside the wheel: they turn in opposite senses",
            Self::Internal => {
                "Driver inside the wheel: they turn in the same sense, the wheel for more than half of each turn"
            }
            Self::Spherical => "Axes that cross at right angles: half of each turn is motion, half is dwell",
        }
    }

    /// What is measured from where.
    pub(super) fn introduction(self) -> &'static str {
        match self {
            Self::External => {
                "Crank angles are measured at the driver's axis from the line of centres, which joins the two axes. The \
                 driver turns at constant speed. While a pin is in a slot, the wheel turns in the opposite sense. It slows \
                 down past the line of centres just as it sped up before it."
            }
            Self::Internal => {
                "The driver is inside the wheel, whose slots open inwards. Crank angles are measured from mid-index, where \
                 the pin is deepest in its slot; it is then on the line of centres, on the far side of the driver's axis. \
                 The driver turns at constant speed, and the wheel in the same sense. The wheel slows down past mid-index \
                 just as it sped up before it."
            }
            Self::Spherical => {
                "The axes cross at right angles. The slots follow meridians of a sphere about the crossing point, and the \
                 pin points to it. Crank angles are measured from mid-index, where the pin is deepest in its slot. The driver \
                 turns at constant speed. The wheel slows down past mid-index just as it sped up before it."
            }
        }
    }

    /// Where crank angles are measured from.
    pub(super) fn middle(self) -> &'static str {
        match self {
            Self::External => "the line of centres",
            Self::Internal | Self::Spherical => "mid-index",
        }
    }

    /// A crank angle in words: how far before or past the middle, with its size as it is written.
    pub(super) fn place(self, degrees: f64, written: &str) -> String {
        let (with, on) = if self == Self::External { ("with a pin ", "on ") } else { ("", "at ") };
        let middle = self.middle();
        if degrees.abs() < 1e-9 {
            return format!("{with}{on}{middle}");
        }
        let side = if degrees < 0.0 { "before" } else { "past" };
        format!("{with}{written}° {side} {middle}")
    }
}

/// A wheel of any kind; lengths are in crank radii.
#[derive(Clone, Copy, Debug)]
pub enum AnyWheel {
    /// One with its driver beside it.
    External(Wheel),
    /// One with its driver inside.
    Internal(InternalWheel),
    /// One whose axis crosses the driver's.
    Spherical(SphericalWheel),
}

impl AnyWheel {
    /// The wheel of this kind with so many stations, and so many pins on its driver.
    ///
    /// # Errors
    ///
    /// Numbers of stations or pins that the kind can't have.
    pub fn new(kind: WheelKind, stations: u32, pins: u32) -> Result<Self, KinematicsError> {
        Ok(match kind {
            WheelKind::External => Self::External(Wheel::with_pins(stations, pins)?),
            WheelKind::Internal => Self::Internal(InternalWheel::with_pins(stations, pins)?),
            WheelKind::Spherical => Self::Spherical(SphericalWheel::with_pins(stations, pins)?),
        })
    }

    /// Its kind.
    pub fn kind(&self) -> WheelKind {
        match self {
            Self::External(_) => WheelKind::External,
            Self::Internal(_) => WheelKind::Internal,
            Self::Spherical(_) => WheelKind::Spherical,
        }
    }

    /// The indexing that all kinds share.
    pub fn indexing(&self) -> &dyn Indexing {
        match self {
            Self::External(wheel) => wheel,
            Self::Internal(wheel) => wheel,
            Self::Spherical(wheel) => wheel,
        }
    }

    /// Distance between the axes; none where they cross.
    pub fn centre_distance_ratio(&self) -> Option<f64> {
        match self {
            Self::External(wheel) => Some(wheel.centre_distance_ratio()),
            Self::Internal(wheel) => Some(wheel.centre_distance_ratio()),
            Self::Spherical(_) => None,
        }
    }

    /// Distance of a pin's centre from the wheel's axis as it enters.
    pub fn wheel_radius_ratio(&self) -> f64 {
        match self {
            Self::External(wheel) => wheel.wheel_radius_ratio(),
            Self::Internal(wheel) => wheel.wheel_radius_ratio(),
            Self::Spherical(wheel) => wheel.sphere_radius_ratio(),
        }
    }

    /// From where a pin's centre enters to where it is deepest, along the slot.
    pub fn slot_length_ratio(&self) -> f64 {
        match self {
            Self::External(wheel) => wheel.slot_length_ratio(),
            Self::Internal(wheel) => wheel.slot_length_ratio(),
            Self::Spherical(wheel) => wheel.slot_length_ratio(),
        }
    }

    /// A drawing that is not to scale.
    pub fn drawing(&self) -> Figure {
        match self {
            Self::External(wheel) => stations::mechanism(wheel),
            Self::Internal(wheel) => stations::internal_mechanism(wheel),
            Self::Spherical(wheel) => stations::spherical_mechanism(wheel),
        }
    }
}
