//! In which range the numbers of an argument make sense, by their unit: wide, so that no machine is left out, and narrow enough to tell
//! a slip of the keyboard or a wrong unit from a number that is meant.

use super::{Argument, ArgumentSlot};

/// Units of arguments with the least number above zero and the greatest that make sense; our choice.
const RANGES: &[(&str, [f64; 2])] = &[
    // From a micrometre to twenty metres.
    ("MM", [0.001, 20_000.0]),
    // Up to what small spindles and turbines do.
    ("R", [1e-6, 200_000.0]),
    ("W", [1e-7, 20_000.0]),
    ("S", [1e-6, 1e7]),
    ("DEG", [0.01, 360.0]),
    ("KG", [1e-6, 1e6]),
    // A wheel of a watch has 1e-12 kg m².
    ("KGM2", [1e-15, 1e6]),
    ("NM", [1e-12, 1e6]),
    ("MU", [1e-6, 10.0]),
    ("I", [1e-4, 1e4]),
    // From foam to diamond.
    ("GPA", [1e-4, 1300.0]),
    ("MPA", [1e-3, 1e5]),
    ("NU", [1e-6, 0.5]),
    // From aerogel to osmium.
    ("KGM3", [1.0, 25_000.0]),
    ("COUNT", [2.0, 12.0]),
];

/// The least play or error of a length that makes sense, in millimetres: a nanometre.
const LEAST_PLAY: f64 = 1e-6;

impl Argument {
    /// The least number above zero and the greatest that make sense, in the argument's own unit; none where the wheel says so itself, and
    /// of what is no number.
    pub fn range(&self) -> Option<[f64; 2]> {
        let (_, range) = RANGES.iter().find(|(unit, _)| *unit == self.unit)?;
        match self.place {
            ArgumentSlot::LengthOrZero(_) | ArgumentSlot::SignedLength(_) => Some([LEAST_PLAY, range[1]]),
            ArgumentSlot::Degrees(_) => None,
            _ => Some(*range),
        }
    }

    /// Whether a number, in the argument's own unit, is zero or in its range; what is no number at all is refused elsewhere.
    pub(in crate::wheel) fn makes_sense(&self, value: f64) -> bool {
        let is_in = |[least, most]: [f64; 2]| (least..=most).contains(&value.abs());
        value == 0.0 || value.is_nan() || self.range().is_none_or(is_in)
    }
}
