//! What public pages, calculators and programs say about Geneva wheels.
//!
//! No document that is mirrored, but single statements: of each its address and the day on which a stored copy of it
//! was read. Formulas are set as they say, in the letters of the page. Where a page can be read in two ways it is read
//! in the way in which it is right, if there is one. The files go by what is stated: how long the driver turns, the
//! sizes, the motion, wheels that are shipped as examples.

mod epicyclic;
mod fit;
mod models;
mod motion;
mod sizes;
mod steps;
mod turning;

use crate::{Claim, Consequence, Evidence, Finding, Origin, Place, Slip, Stated, Work};
use Evidence::{AutomaticDerivative, ClosedForm, Jet as Series, Vectors};
use fit::{Fit, formula, number};
use std::f64::consts::PI;

/// What stands between an address and the day in a locator.
const AS_READ: &str = ", as read on ";

/// The locator of a page: its address, and when a stored copy of it was read.
macro_rules! page {
    ($address:literal) => {
        concat!($address, ", as read on 2026-11-22")
    };
}
use page;

/// A page.
const fn at(locator: &'static str) -> Place {
    Place::new(Work::Wild, locator)
}

/// All statements, by what they are about.
pub fn claims() -> Vec<Claim> {
    [turning::claims(), steps::claims(), sizes::claims(), models::claims(), motion::claims(), epicyclic::claims()]
        .concat()
}

/// The address of the page on which a statement stands, and the day on which it was read, from the claim's locator.
pub fn read(locator: &str) -> Option<(&str, &str)> {
    locator.split_once(AS_READ)
}

/// The slip of a claim that is found in the page's own formula or number.
const fn slip(reason: &'static str, witness: &'static str, changes: &'static str) -> Slip {
    Slip { id: "", reason, witness, origin: Origin::Concept, consequence: Consequence::Result, changes }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Truth, verdicts_of};
    use std::collections::BTreeSet;

    #[test]
    fn every_statement_has_an_address_and_a_day() {
        for claim in claims() {
            let (address, day) = read(claim.locator).unwrap_or_else(|| panic!("{}: {}", claim.id, claim.locator));
            assert!(address.starts_with("https://") || address.starts_with("http://"), "{}: {address}", claim.id);
            let digits = day.split('-').map(str::len).collect::<Vec<_>>();
            assert!(digits == [4, 2, 2] && day.starts_with("20"), "{}: {day}", claim.id);
        }
    }

    #[test]
    fn right_statements_are_listed_as_well_as_wrong_ones() {
        let addresses = |truth| -> BTreeSet<&str> {
            let of_truth = verdicts_of(Work::Wild).into_iter().filter(|judged| judged.truth() == truth);
            of_truth.filter_map(|judged| Some(read(judged.claim.locator)?.0)).collect()
        };
        assert!(addresses(Truth::Right).len() >= 12 && addresses(Truth::Wrong).len() >= 8);
    }
}
