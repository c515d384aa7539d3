//! What to change first on a wheel that was checked. Every remedy is carried out before it is given: with it, the wheel turns.

use super::check_advice::{PartSizes, change_words, design_arguments, part_words};
use super::check_certainty::{ShallowSlot, too_coarse};
use super::design::WheelDesign;
use super::question::WheelQuestion;
use crate::number_format::{number, to_digits};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Sizes;
use geneva_kinematics::wheel::as_built::{
    AsBuiltWheel, BuiltError, Culprit, MeasuredSize, MeasuredWheel, NearestWheel, SizeChange,
};

/// Digits with which the sizes of a remedy are given: as few as will do.
const DIGITS: std::ops::RangeInclusive<usize> = 4..=8;

/// A remedy: sizes to make, in millimetres or radians, and then one size to change for all that the parts lack.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WheelRemedy {
    /// The sizes to make, the worst first, with the digits that are given, and what was measured instead.
    sizes: Vec<RemedySize>,
    /// Significant digits of the sizes.
    digits: usize,
    /// The change after that.
    change: Option<SizeChange>,
    /// A new wheel and a new driver for the axes as they are; none where these are not what is kept.
    rebuilt: Option<Sizes>,
    /// The arguments of `geneva wheel` that design the parts; none where no part is new.
    pub(super) design: Option<String>,
}

/// A size to make, in millimetres or radians.
#[derive(Clone, Copy, Debug, PartialEq)]
struct RemedySize {
    size: MeasuredSize,
    measured: f64,
    value: f64,
}

impl WheelRemedy {
    /// The remedy in words.
    fn words(&self) -> String {
        if let Some(sizes) = &self.rebuilt {
            return rebuilding_words(sizes);
        }
        let mut work: Vec<String> = Vec::new();
        for RemedySize { size, measured, value } in &self.sizes {
            // Several worn slots or arcs are of one wheel.
            let is_same =
                |of: &&RemedySize| of.size.name() == size.name() && of.value == *value && of.measured > of.value;
            let of_all = size.size_of_all().filter(|_| self.sizes.iter().filter(is_same).count() > 1);
            let words = part_words(of_all.unwrap_or(*size), *measured, *value, self.digits);
            if !work.contains(&words) {
                work.push(words);
            }
        }
        work.extend(self.change.map(change_words));
        work.join(", then ")
    }

    /// The wheel after the remedy, its change by this part larger, dimensionless.
    pub(super) fn carried_out(&self, built: &AsBuiltWheel, more: f64) -> AsBuiltWheel {
        if let Some(sizes) = &self.rebuilt {
            return AsBuiltWheel::from(sizes);
        }
        let mut mended = built.clone();
        for RemedySize { size, value, .. } in &self.sizes {
            mended.set(*size, *value);
        }
        self.change.map_or(mended.clone(), |change| {
            mended.changed(SizeChange { size: change.size, by: change.by * (1.0 + more) })
        })
    }
}

/// The remedies of a wheel, the best first: the right values of the sizes that contradict the others, a thicker pin or a larger disc for
/// worn slots or arcs, and, if it is known whether the wheel turns, the least change with which it does.
pub(super) fn remedies(
    measured: &MeasuredWheel,
    nearest: &NearestWheel,
    culprits: &[Culprit],
    built: &AsBuiltWheel,
    shallow: &[ShallowSlot],
    is_known: bool,
) -> Result<Vec<WheelRemedy>, BuiltError> {
    let turn = built.turn()?;
    let mut found = Vec::new();
    let is_enough = |remedy: &WheelRemedy| remedy.carried_out(built, 0.0).turn().is_ok_and(|turn| turn.is_driven());
    if !culprits.is_empty() {
        let design = design_arguments(measured, &PartSizes::from(nearest));
        let rounded = |digits: usize| -> WheelRemedy {
            let sizes = culprits.iter().map(|culprit| RemedySize {
                size: culprit.size,
                measured: culprit.measured,
                value: to_precision(culprit.size, culprit.expected, digits),
            });
            WheelRemedy { sizes: sizes.collect(), digits, change: None, rebuilt: None, design: design.clone() }
        };
        let finest = rounded(*DIGITS.end());
        let mended = DIGITS.map(rounded).find(is_enough).or_else(|| {
            if !is_known {
                return Some(rounded(*DIGITS.start()));
            }
            let after = finest.carried_out(built, 0.0);
            let change = *after.least_changes().ok()?.first()?;
            Some(WheelRemedy { change: Some(change), ..finest.clone() })
        });
        found.extend(mended);
        let for_axes = for_axes(measured, nearest, culprits);
        found.extend(for_axes.filter(|remedy| !is_known || is_enough(remedy)));
        let for_worn = for_worn_part(measured, nearest, culprits);
        found.extend(for_worn.filter(|remedy| !is_known || is_enough(remedy)));
    }
    // What may be chance is nothing to mend.
    if is_known && turn.jam.as_ref().is_some_and(|jam| too_coarse(measured, jam).is_none()) {
        let changes = built.least_changes()?;
        let is_deeper = |change: &&SizeChange| matches!(change.size, MeasuredSize::SlotEnd(_)) && !shallow.is_empty();
        let change = changes.iter().find(is_deeper).or(changes.first()).copied();
        found.extend(change.map(|change| WheelRemedy {
            sizes: Vec::new(),
            digits: *DIGITS.start(),
            change: Some(change),
            rebuilt: None,
            design: None,
        }));
    }
    Ok(found)
}

/// A new wheel and a new driver for axes that are not the right distance apart for the old ones, with the other sizes as they should be;
/// none where the axes are right.
fn for_axes(measured: &MeasuredWheel, nearest: &NearestWheel, culprits: &[Culprit]) -> Option<WheelRemedy> {
    let axes = culprits.iter().find(|culprit| culprit.size == MeasuredSize::CentreDistance)?.measured;
    let right = PartSizes::from(nearest);
    let crank_radius = axes * libm::sin(measured.wheel().half_pitch_angle());
    let bottom = right.centre_distance - right.crank_radius - right.slot_end;
    let sizes = PartSizes { centre_distance: axes, crank_radius, slot_end: axes - crank_radius - bottom, ..right };
    let design = design_arguments(measured, &sizes)?;
    let rebuilt = WheelQuestion::parse(&design).and_then(WheelDesign::new).ok()?.sizes;
    rebuilt.is_some().then_some(WheelRemedy {
        sizes: Vec::new(),
        digits: *DIGITS.start(),
        change: None,
        rebuilt,
        design: Some(design),
    })
}

/// The parts to make for axes that stay where they are, in words.
fn rebuilding_words(sizes: &Sizes) -> String {
    format!(
        "leave the axes {} mm apart and make a new wheel with an outside diameter of {} mm and a new driver with the pin {} mm from its axis",
        number(sizes.centre_distance),
        number(2.0 * sizes.tip_radius),
        number(sizes.crank_radius)
    )
}

/// A thicker pin for slots that are all as much too wide, or a larger disc for such arcs, with the play of the right wheel; none for other
/// culprits.
fn for_worn_part(measured: &MeasuredWheel, nearest: &NearestWheel, culprits: &[Culprit]) -> Option<WheelRemedy> {
    use MeasuredSize as Size;
    let first = culprits.first()?;
    let name = first.size.name();
    let values: Vec<f64> = measured.sizes().iter().filter(|of| of.size.name() == name).map(|of| of.value).collect();
    let uncertainty = measured.sizes().iter().map(|of| of.uncertainty).fold(0.0, f64::max);
    let [least, most] = values.iter().fold([f64::INFINITY, 0.0], |[least, most], of| [of.min(least), of.max(most)]);
    let is_alike = culprits.iter().all(|of| of.size.name() == name && of.measured > of.expected)
        && culprits.len() == values.len()
        && most - least <= ALIKE * uncertainty;
    let right = PartSizes::from(nearest);
    let (size, is_partner, now, value, sizes) = match first.size {
        Size::SlotWidth(_) => {
            // The narrowest slot must let it in.
            let pin_diameter = least - (nearest.slot_width - nearest.pin_diameter).max(0.0);
            let is_pin: fn(Size) -> bool = |size| size == Size::PinDiameter;
            let sizes = PartSizes { pin_diameter, slot_width: least, ..right };
            (Size::PinDiameter, is_pin, nearest.pin_diameter, pin_diameter, sizes)
        }
        Size::ArcRadius(_) => {
            let disc_radius = least - (nearest.arc_radius - nearest.disc_radius).max(0.0);
            let is_disc: fn(Size) -> bool = |size| size == Size::DiscRadius;
            let sizes = PartSizes { disc_radius, arc_radius: least, ..right };
            (Size::DiscRadius, is_disc, nearest.disc_radius, disc_radius, sizes)
        }
        _ => return None,
    };
    let is_measured = measured.sizes().iter().any(|of| is_partner(of.size));
    let digits = *DIGITS.start();
    (is_alike && is_measured).then(|| WheelRemedy {
        sizes: vec![RemedySize { size, measured: now, value: to_precision(size, value, digits) }],
        digits,
        change: None,
        rebuilt: None,
        design: design_arguments(measured, &sizes),
    })
}

/// Uncertainties by which slots or arcs may differ that are worn alike: our choice.
const ALIKE: f64 = 4.0;

/// The remedies in one sentence; none if there are none.
pub(super) fn first_change(remedies: &[WheelRemedy]) -> Option<String> {
    let words: Vec<String> = remedies
        .iter()
        .map(|remedy| {
            let is_to_turn = remedy.sizes.is_empty() && remedy.rebuilt.is_none();
            format!("{}{}", if is_to_turn { "to make it turn at all, " } else { "" }, remedy.words())
        })
        .collect();
    match &words[..] {
        [] => None,
        // The only one needs no reason.
        [only] => Some(only.trim_start_matches("to make it turn at all, ").to_owned()),
        _ => Some(words.join("; or, ")),
    }
}

/// A size in millimetres or radians as it is told with so many significant digits.
fn to_precision(size: MeasuredSize, value: f64, digits: usize) -> f64 {
    let factor = if matches!(size, MeasuredSize::SlotDirection(_)) { 1_f64.to_degrees() } else { 1.0 };
    let told = to_digits((value * factor).abs(), digits);
    told.parse::<f64>().map_or(value, |told| told.copysign(value) / factor)
}
