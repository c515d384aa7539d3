//! By how much a wrong formula is wrong.

use super::fit::{Fit, Letters};
use super::{motion, sizes, turning};
use crate::WILD;
use geneva_evidence::tex::{self, Moment};

/// What the wrong formula of a claim gives over what the right one gives, for a wheel of so many slots: dimensionless. A
/// formula for the wheel's speed is taken on the line of centres.
///
/// None for a claim that is no wrong formula of this kind, and for numbers of slots that no wheel has.
pub fn ratio(id: &str, slots: u32) -> Option<f64> {
    let of_sizes: Option<Letters> = match id {
        "wild.firgelli-time.dwell" => Some(turning::resting),
        "wild.firgelli-time.index" => Some(turning::index),
        "wild.firgelli-time.centres" => Some(sizes::centres),
        "wild.firgelli-time.driver" => Some(sizes::driver),
        "wild.firgelli-indexing.centres" => Some(sizes::centres_by_the_root),
        "wild.oxiphysics.rim" => Some(sizes::rim),
        _ => None,
    };
    let letters = match of_sizes {
        Some(letters) => letters(&Fit::by_wheel(slots)),
        None if id == "wild.firgelli-form.speed" => motion::greatest_speed(slots)?,
        None => return None,
    };
    let claim = WILD.claim(id)?;
    let moment = Moment::default().with(letters);
    let given = |formula: &str| Some(tex::value(formula.split_once('=')?.1, moment.letters()));
    let ratio = given(claim.printed)? / given(claim.erratum.as_ref()?.corrected)?;
    ratio.is_finite().then_some(ratio)
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::agreement::agrees;
    use std::f64::consts::PI;

    #[test]
    fn the_ratios_are_those_of_the_formulas_by_hand() {
        for slots in 3..=60_u32 {
            let n = f64::from(slots);
            let (sine, cosine) = (libm::sin(PI / n), libm::cos(PI / n));
            for (name, by_hand) in [
                ("firgelli-time.dwell", 2.0 * (n - 1.0) / (n + 2.0)),
                ("firgelli-time.index", 2.0 / (n - 2.0)),
                ("firgelli-time.centres", cosine / sine),
                ("firgelli-time.driver", (1.0 - cosine) / sine),
                ("firgelli-indexing.centres", (2.0 + 2.0 * cosine).sqrt() * sine),
                ("oxiphysics.rim", (1.0 + sine * sine).sqrt() / cosine),
                ("firgelli-form.speed", 1.0 / sine),
            ] {
                let ratio = ratio(&format!("wild.{name}"), slots).expect("a formula");
                assert!(agrees(ratio, by_hand), "{name}, {slots} slots: {ratio}");
            }
        }
        assert_eq!(ratio("wild.firgelli-time.dwell", 2), None);
        assert_eq!(ratio("wild.anvilate.dwell", 6), None);
    }
}
