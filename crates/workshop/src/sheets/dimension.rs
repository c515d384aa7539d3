//! Sizes as they are written on a sheet.

use super::length::mm;
use super::limits::{LimitOrigin, Limits};
use geneva_kinematics::wheel::ToleranceClass;

/// What a dimension on a sheet measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// Width of the slots.
    SlotWidth,
    /// From the wheel's axis to the middle of a slot's round end.
    SlotEnd,
    /// Radius of a slot's round end.
    SlotEndRadius,
    /// How much of a slot's wall a mouth takes, from the wheel radius.
    MouthLength,
    /// Radius of a mouth.
    MouthRadius,
    /// Diameter over the wheel's rim.
    Rim,
    /// Radius of the locking arcs.
    LockingArc,
    /// Diameter of the circle on which the locking arcs have their middles.
    LockingArcCentres,
    /// Diameter of a bore.
    Bore,
    /// Width of a keyway.
    KeywayWidth,
    /// From the bottom of a keyway, or from a flat, to the opposite side of the bore.
    AcrossBore,
    /// Diameter of a hole that holds a part on its hub.
    HubHole,
    /// Diameter of the circle of these holes.
    HubCircle,
    /// Diameter of a hole between locking disc and plate.
    DowelHole,
    /// Diameter of the circle of these holes.
    DowelCircle,
    /// Width of a nut's pocket across its flats.
    NutWidth,
    /// Depth of a nut's pocket or of a shoulder.
    PocketDepth,
    /// Diameter of the locking disc.
    Disc,
    /// Radius of the crescent.
    Crescent,
    /// From the driver's axis to the middle of the crescent.
    CrescentCentre,
    /// From one edge of the crescent's opening to the other.
    Opening,
    /// Inner diameter of an internal wheel's ring.
    RingInside,
    /// Outer radius of the locking segment.
    SegmentOuter,
    /// Inner radius of the locking segment.
    SegmentInner,
    /// From one end of the locking segment's outer arc to the other.
    SegmentChord,
    /// Diameter of the plate.
    Plate,
    /// From the driver's axis to the middle of a pin.
    CrankRadius,
    /// Diameter of a pin's hole.
    PinHole,
    /// Diameter of a pin.
    Pin,
    /// Length of a pin.
    PinLength,
    /// Thickness of a part.
    Thickness,
    /// From axis to axis on the base plate.
    AxisDistance,
    /// From the base plate's edge to the wheel's axis.
    AxisPlace,
    /// Length of the base plate, along the line of its axes.
    BaseLength,
    /// Width of the base plate.
    BaseWidth,
    /// Radius of the base plate's corners.
    BaseCorner,
    /// Diameter of a shoulder's hole.
    Shoulder,
    /// Diameter of a hole that holds the base plate.
    FixingHole,
    /// From fixing hole to fixing hole along the base plate.
    FixingLength,
    /// From fixing hole to fixing hole across the base plate.
    FixingWidth,
}

/// A dimension as it is written on a sheet.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PrintedDimension {
    /// What it measures.
    pub measured: Measured,
    /// The size, in millimetres.
    pub nominal: f64,
    /// By how much the size may be below and above, in millimetres with the sign; the general tolerances if there are none.
    pub limits: Option<[f64; 2]>,
    /// The class of ISO 286 with these limits.
    pub class: Option<ToleranceClass>,
    /// Where the limits come from.
    pub origin: LimitOrigin,
    /// Text before the limits, as it is on the sheet.
    pub text: String,
}

impl PrintedDimension {
    /// A dimension with what is written before and behind its size.
    pub(super) fn new(measured: Measured, before: &str, nominal: f64, behind: &str) -> Self {
        let text = format!("{before}{}{behind}", mm(nominal));
        Self { measured, nominal, limits: None, class: None, origin: LimitOrigin::Standard, text }
    }

    /// The dimension with limits; the class, if any, is written behind the size.
    pub(super) fn limited(mut self, limits: Limits) -> Self {
        if let Some(class) = limits.class {
            self.text = format!("{} {}", self.text, class.name());
        }
        self.limits = Some([limits.lower, limits.upper]);
        (self.class, self.origin) = (limits.class, limits.origin);
        self
    }

    /// Limits as they are written in one line; none where the general tolerances hold.
    pub fn limit_text(&self) -> Option<String> {
        self.limit_words().map(|words| words.unwrap_or_else(|[upper, lower]| format!("{upper}/{lower}")))
    }

    /// Limits as they are written: one text, or an upper and a lower one.
    pub(super) fn limit_words(&self) -> Option<Result<String, [String; 2]>> {
        let [lower, upper] = self.limits?;
        Some(Limits { class: self.class, ..Limits::new([lower, upper]) }.words())
    }
}
