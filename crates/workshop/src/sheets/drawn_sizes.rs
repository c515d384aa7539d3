//! The sizes of an external or an internal wheel, as the sheets ask for them.

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::Sizes;

/// Sizes of a wheel of either kind; lengths in millimetres.
#[derive(Clone, Copy, Debug)]
pub(super) enum DrawnSizes<'a> {
    External(&'a Sizes),
    Internal(&'a InternalSizes),
}

/// Reads a field that sizes of both kinds have under one name.
macro_rules! of_both {
    ($($(#[$doc:meta])* $name:ident),+ $(,)?) => {
        $($(#[$doc])* pub(super) fn $name(self) -> f64 {
            match self {
                Self::External(sizes) => sizes.$name,
                Self::Internal(sizes) => sizes.$name,
            }
        })+
    };
}

impl<'a> DrawnSizes<'a> {
    of_both! {
        /// Diameter of a pin.
        pin_diameter,
        /// Distance of a pin's centre from the driver's axis.
        crank_radius,
        /// Distance between the axes.
        centre_distance,
        /// Distance of a pin's centre from the wheel's axis as it enters.
        wheel_radius,
        /// Distance of the centre of a slot's round end from the wheel's axis.
        slot_end,
        /// Radius of the driver's plate.
        plate_radius,
    }

    /// The indexing of both.
    pub(super) fn indexing(self) -> &'a dyn Indexing {
        match self {
            Self::External(sizes) => &sizes.wheel,
            Self::Internal(sizes) => &sizes.wheel,
        }
    }

    /// How many pins the driver has.
    pub(super) fn pins(self) -> u32 {
        self.indexing().pins()
    }

    /// How much wider a slot is than a pin.
    pub(super) fn slot_play(self) -> f64 {
        match self {
            Self::External(sizes) => sizes.play.slot,
            Self::Internal(sizes) => sizes.play.slot,
        }
    }

    /// How much wider a bore is than its shaft.
    pub(super) fn bore_play(self) -> f64 {
        match self {
            Self::External(sizes) => sizes.play.bore,
            Self::Internal(sizes) => sizes.play.bore,
        }
    }

    /// Whether the wheel is a ring with the driver inside it.
    pub(super) fn is_internal(self) -> bool {
        matches!(self, Self::Internal(_))
    }
}
