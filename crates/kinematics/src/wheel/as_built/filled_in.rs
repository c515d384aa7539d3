//! What was not measured of a wheel, by a rule: as a design has it by default for the sizes that were measured.
//!
//! A fit leaves open what no measurement tells, and its place there would rest on the uncertainties of other sizes. So a pin of
//! which only the slot was measured has the usual play in it, and so on. Where the cut in the disc was measured, it tells what it
//! was drawn for, and the fit stands.

use super::designed_wheel::right_wheel;
use super::measured::{MeasuredSize, MeasuredWheel};
use super::right_wheel::{Free, LEAST_HORN};
use crate::indexing::Indexing;
use crate::wheel::sizing::pin_and_play;
use crate::wheel::{Choices, Play, Scale, Sizes};

impl MeasuredWheel {
    /// The sizes of a fit with those that parts had when they were new, as far as these were measured: a right wheel has them.
    pub(super) fn as_new(&self, fitted: &Free) -> Free {
        use MeasuredSize as Size;
        let new =
            [(1, Size::NewPinDiameter), (2, Size::NewSlotWidth), (4, Size::NewArcRadius), (5, Size::NewDiscRadius)];
        let mut free = *fitted;
        for (k, of) in new {
            free[k] = self.mean(|size| size == of).unwrap_or(free[k]);
        }
        free
    }

    /// The sizes of a fit with those that were not measured as a design has them by default for those that were; the fit itself where
    /// there is no such design, or where the cut in the disc was measured.
    pub(super) fn filled_in(&self, fitted: &Free) -> Free {
        use MeasuredSize as Size;
        let has_cut = self.has(|size| matches!(size, Size::CrescentCentre | Size::CrescentRadius));
        let filled_in = if has_cut { None } else { self.by_default(fitted) };
        filled_in.unwrap_or(*fitted)
    }

    fn by_default(&self, fitted: &Free) -> Option<Free> {
        use MeasuredSize as Size;
        let of = |k: usize, is_it: fn(Size) -> bool| self.has(is_it).then_some(fitted[k]);
        let pin = of(1, |size| matches!(size, Size::PinDiameter | Size::NewPinDiameter));
        let slot = of(2, |size| matches!(size, Size::SlotWidth(_) | Size::NewSlotWidth));
        let end = of(3, |size| matches!(size, Size::SlotEnd(_)));
        let arc = of(4, |size| matches!(size, Size::ArcRadius(_) | Size::NewArcRadius));
        let disc = of(5, |size| matches!(size, Size::DiscRadius | Size::NewDiscRadius));
        let (wheel, a) = (self.wheel(), fitted[0]);
        let axes = a / libm::sin(wheel.half_pitch_angle());
        let usual = |pin_diameter: Option<f64>| {
            pin_and_play(wheel, [a, axes], &Choices { pin_diameter, ..Choices::default() }).ok()
        };
        let (pin_diameter, slot_play) = match (pin, slot) {
            (Some(pin), Some(slot)) => (pin, (slot - pin).max(0.0)),
            (None, Some(slot)) => {
                let (_, play) = usual(Some(slot))?;
                (slot - play.slot, play.slot)
            }
            (pin, None) => {
                let (pin, play) = usual(pin)?;
                (pin, play.slot)
            }
        };
        let locking = arc.zip(disc).map_or(slot_play, |(arc, disc)| (2.0 * (arc - disc)).max(0.0));
        let choices = Choices {
            pin_diameter: Some(pin_diameter),
            play: Some(Play { slot: slot_play, locking, bore: 0.0, pin: 0.0 }),
            bottom_clearance: end.map(|end| (axes - a - end).max(0.0)),
            locking_arc_radius: arc.or(disc.map(|disc| disc + locking / 2.0)),
            ..Choices::default()
        };
        let sizes = Sizes::new(*wheel, Scale::CrankRadius(a), &choices).ok()?;
        let mut free = right_wheel(&sizes);
        free[0] = a;
        for (k, measured) in [(1, pin), (2, slot), (3, end), (4, arc), (5, disc)] {
            free[k] = measured.unwrap_or(free[k]);
        }
        (sizes.horn_thickness >= LEAST_HORN * pin_diameter).then_some(free)
    }
}
