//! What measurements are fine enough to say: whether a wheel that seems to jam does, and which slots are too shallow.
//!
//! A size is measured with an uncertainty, and where several meet their uncertainties add up as squares. Of many slots, each
//! measured by itself, some seem too narrow by chance. So that a right wheel is not accused, less must be missing than chance takes
//! from the worst of them.

use geneva_kinematics::wheel::as_built::{AsBuiltWheel, BuiltContact, Jam, MeasuredSize, MeasuredWheel};

/// Measurements that are too coarse to say that a wheel jams.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TooCoarse {
    /// How much seems missing, in millimetres.
    pub missing: f64,
    /// How much seems missing by chance, in millimetres.
    pub by_chance: f64,
    /// The uncertainty of each size, over what it is, with which what is missing now would be more than chance, dimensionless.
    pub finer: f64,
}

/// A slot that is too shallow for its pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ShallowSlot {
    /// Its number, from 0.
    pub slot: usize,
    /// How much depth is missing, in millimetres.
    pub missing: f64,
}

/// The sizes that meet at a contact; a number is that of the slot or arc.
fn meeting(contact: BuiltContact, size: MeasuredSize) -> bool {
    use MeasuredSize as Size;
    let of_axes = matches!(size, Size::CentreDistance | Size::CrankRadius);
    match contact {
        BuiltContact::PinOnWall | BuiltContact::PinAtMouth | BuiltContact::PinOnFace => {
            of_axes || matches!(size, Size::PinDiameter | Size::SlotWidth(_) | Size::SlotDirection(_) | Size::TipRadius)
        }
        BuiltContact::PinAtBottom => {
            of_axes || matches!(size, Size::PinDiameter | Size::SlotWidth(_) | Size::SlotEnd(_))
        }
        BuiltContact::DiscInArc | BuiltContact::OpeningEdge => {
            of_axes || matches!(size, Size::DiscRadius | Size::ArcRadius(_) | Size::ArcCentre(_))
        }
        BuiltContact::Crescent => {
            of_axes
                || matches!(size, Size::CrescentCentre | Size::CrescentRadius | Size::TipRadius | Size::ArcRadius(_))
        }
        BuiltContact::Nothing => false,
    }
}

/// What seems missing by chance where parts meet in these contacts, in millimetres: of a kind of size the least certain one counts.
fn by_chance(measured: &MeasuredWheel, contacts: &[BuiltContact]) -> f64 {
    let meets = |size: MeasuredSize| contacts.iter().any(|contact| meeting(*contact, size));
    let mut kinds: Vec<(&'static str, f64)> = Vec::new();
    let mut measured_by_itself = 1_usize;
    for of in measured.sizes().iter().filter(|of| meets(of.size)) {
        measured_by_itself = measured_by_itself.max(of.size.number().map_or(1, |number| number + 1));
        // A direction is an angle, at the rim's radius at most.
        let arm = if matches!(of.size, MeasuredSize::SlotDirection(_)) { rim(measured) } else { 1.0 };
        let uncertainty = of.uncertainty * arm;
        match kinds.iter_mut().find(|(name, _)| *name == of.size.name()) {
            Some((_, greatest)) => *greatest = greatest.max(uncertainty),
            None => kinds.push((of.size.name(), uncertainty)),
        }
    }
    let together = kinds.iter().map(|(_, uncertainty)| uncertainty * uncertainty).sum::<f64>().sqrt();
    // The greatest of so many normal errors to either side is about this many standard deviations.
    together * (2.0 * libm::log(2.0 * measured_by_itself as f64)).sqrt()
}

/// The measured radius of the rim in millimetres; zero if it was not measured.
fn rim(measured: &MeasuredWheel) -> f64 {
    let of = measured.sizes().iter().find(|of| of.size == MeasuredSize::TipRadius);
    of.map_or(0.0, |of| of.value)
}

/// Whether measurements are too coarse to say that a wheel jams as it seems to.
pub(super) fn too_coarse(measured: &MeasuredWheel, jam: &Jam) -> Option<TooCoarse> {
    let missing = -jam.free.room();
    let by_chance = by_chance(measured, &[jam.free.backward.contact, jam.free.forward.contact]);
    (missing < by_chance).then(|| TooCoarse { missing, by_chance, finer: (missing / by_chance).max(0.0) })
}

/// Whether a size that no wheel seems to have may be such by chance: by so much in millimetres.
pub(super) fn is_chance(measured: &MeasuredWheel, by: f64) -> bool {
    use BuiltContact::{Crescent, DiscInArc, PinAtBottom, PinOnWall};
    by < by_chance(measured, &[PinOnWall, PinAtBottom, DiscInArc, Crescent])
}

/// The slots whose measured ends are too shallow for the pins, by more than chance.
pub(super) fn shallow_slots(measured: &MeasuredWheel, built: &AsBuiltWheel) -> Vec<ShallowSlot> {
    let is_measured = |slot: usize| {
        let is_end = |size| matches!(size, MeasuredSize::SlotEnd(number) if number.is_none_or(|number| number == slot));
        measured.sizes().iter().any(|of| is_end(of.size))
    };
    let chance = by_chance(measured, &[BuiltContact::PinAtBottom]);
    let depths = built.missing_depths().into_iter().enumerate();
    let missing = depths.filter(|(slot, missing)| *missing > chance && is_measured(*slot));
    missing.map(|(slot, missing)| ShallowSlot { slot, missing }).collect()
}
