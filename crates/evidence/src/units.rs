//! In which unit a document prints which quantity: what a claim says that it is decides its unit.

use crate::document::{Claim, Kind, QuantityUnit};

/// The unit of what a claim of a number is about; none if nothing is said of it.
pub(crate) fn expected_unit(claim: &Claim) -> Option<QuantityUnit> {
    let named = claim.document.units.iter().filter_map(|unit| Some((claim.meaning.find(unit.0)?, unit)));
    named.min_by_key(|(at, (words, _))| (*at, usize::MAX - words.len())).map(|(_, unit)| *unit)
}

/// What is wrong with the unit of a claim, if something is.
pub(crate) fn unit_fault(claim: &Claim) -> Option<String> {
    let (words, unit) = expected_unit(claim).filter(|_| claim.kind == Kind::Value)?;
    let named = |unit: &str| if unit.is_empty() { "no unit".to_owned() } else { format!("the unit {unit}") };
    (claim.unit != unit)
        .then(|| format!("it has {}, but the source prints \"{words}\" with {}", named(claim.unit), named(unit)))
}
