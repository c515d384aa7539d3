//! What to change first on a wheel that was checked. Every remedy is carried out before it is given: with it, the wheel turns.

use super::check_certainty::{ShallowSlot, too_coarse};
use super::check_words::{named, with_unit};
use crate::number_format::{number, to_digits};
use geneva_kinematics::wheel::as_built::{
    AsBuiltWheel, BuiltError, Culprit, MeasuredSize, MeasuredWheel, NearestWheel, SizeChange,
};

/// Digits with which the sizes of a remedy are given: as few as will do.
const DIGITS: std::ops::RangeInclusive<usize> = 4..=8;

/// A remedy: sizes to make, in millimetres or radians, and then one size to change for all that the parts lack.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WheelRemedy {
    /// The sizes to make, the worst first, with the digits that are given.
    sizes: Vec<(MeasuredSize, f64)>,
    /// Significant digits of the sizes.
    digits: usize,
    /// The change after that.
    change: Option<SizeChange>,
}

impl WheelRemedy {
    /// The remedy in words.
    fn words(&self) -> String {
        let sizes: Vec<String> = self
            .sizes
            .iter()
            .map(|(size, value)| format!("{} {}", named(*size), with_unit(*size, *value, self.digits)))
            .collect();
        let sizes = (!sizes.is_empty()).then(|| format!("make {}", sizes.join(", then ")));
        let change = self.change.map(|change| {
            let sense = if change.by > 0.0 { "larger" } else { "smaller" };
            format!("make {} {} mm {sense}, and a little more for play", named(change.size), number(change.by.abs()))
        });
        sizes.into_iter().chain(change).collect::<Vec<_>>().join("; then ")
    }

    /// The wheel after the remedy, its change by this part larger, dimensionless.
    pub(super) fn carried_out(&self, built: &AsBuiltWheel, more: f64) -> AsBuiltWheel {
        let mut mended = built.clone();
        for (size, value) in &self.sizes {
            mended.set(*size, *value);
        }
        self.change.map_or(mended.clone(), |change| {
            mended.changed(SizeChange { size: change.size, by: change.by * (1.0 + more) })
        })
    }
}

/// The remedies of a wheel, in words, the best first: the right values of the sizes that contradict the others, and, if it is known
/// whether it turns, the least change with which it does.
pub(super) fn remedies(
    measured: &MeasuredWheel,
    nearest: &NearestWheel,
    built: &AsBuiltWheel,
    shallow: &[ShallowSlot],
    is_known: bool,
) -> Result<Vec<WheelRemedy>, BuiltError> {
    let culprits: Vec<&Culprit> = nearest.culprit.iter().chain(&nearest.further_culprits).collect();
    let turn = built.turn()?;
    let mut found = Vec::new();
    if !culprits.is_empty() {
        let rounded = |digits: usize| -> WheelRemedy {
            let sizes =
                culprits.iter().map(|culprit| (culprit.size, to_precision(culprit.size, culprit.expected, digits)));
            WheelRemedy { sizes: sizes.collect(), digits, change: None }
        };
        let is_enough = |remedy: &WheelRemedy| remedy.carried_out(built, 0.0).turn().is_ok_and(|turn| turn.is_driven());
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
        }));
    }
    Ok(found)
}

/// The remedies in one sentence; none if there are none.
pub(super) fn first_change(remedies: &[WheelRemedy]) -> Option<String> {
    let words: Vec<String> = remedies.iter().map(WheelRemedy::words).collect();
    (!words.is_empty()).then(|| words.join("; or, to make it turn at all, "))
}

/// A size in millimetres or radians as it is told with so many significant digits.
fn to_precision(size: MeasuredSize, value: f64, digits: usize) -> f64 {
    let factor = if matches!(size, MeasuredSize::SlotDirection(_)) { 1_f64.to_degrees() } else { 1.0 };
    let told = to_digits((value * factor).abs(), digits);
    told.parse::<f64>().map_or(value, |told| told.copysign(value) / factor)
}
