//! Our numbers in a sentence: what a chapter says with a number that no source prints.

mod built;
mod escapement;
pub(crate) mod found;
mod front;
mod joints;
mod kinds;
#[cfg(test)]
mod leaned_on;
pub mod making;
mod method;
mod mimic;
mod mistake;
mod never_printed;
mod own_number;
mod pin;
mod program;
pub mod runs;
mod second_routes;
mod solver;
mod terminal_speed;
pub mod timer;
mod wild;

pub use own_number::{Backing, Form, GIVEN, IntoNumbers, Numbers, OwnNumber, RECORD, RouteKind};

use crate::lookup;
use anyhow::anyhow;
use std::sync::OnceLock;

/// What a chapter says of ours and is no number: a list of names, or what somebody else reports.
pub type Phrase = fn() -> anyhow::Result<String>;

/// The numbers of our own, chapter by chapter.
pub fn own_numbers() -> &'static [OwnNumber] {
    static NUMBERS: OnceLock<Vec<OwnNumber>> = OnceLock::new();
    NUMBERS.get_or_init(|| {
        [
            built::numbers(),
            escapement::numbers(),
            found::numbers(),
            front::numbers(),
            joints::numbers(),
            making::numbers(),
            method::numbers(),
            mimic::numbers(),
            mistake::numbers(),
            never_printed::numbers(),
            pin::numbers(),
            program::numbers(),
            runs::numbers(),
            solver::numbers(),
            terminal_speed::numbers(),
            timer::numbers(),
            wild::numbers(),
        ]
        .into_iter()
        .flatten()
        .collect()
    })
}

/// What has no digits to be checked.
const WORDS: &[&[(&str, Phrase)]] = &[mimic::WORDS, program::WORDS, timer::WORDS];

/// The names of all numbers and words; each is said in some chapter.
pub fn names() -> impl Iterator<Item = &'static str> {
    let numbers = own_numbers().iter().map(|number| number.id);
    numbers.chain(WORDS.iter().copied().flatten().map(|(name, _)| *name))
}

/// The number or the words of this name.
pub fn by_name(name: &str) -> anyhow::Result<String> {
    if let Some(number) = own_numbers().iter().find(|number| number.id == name) {
        return number.show().map_err(|error| anyhow!(error));
    }
    let words = WORDS.iter().copied().flatten().find(|(known, _)| *known == name).map(|(_, words)| words);
    words.ok_or_else(|| lookup::unknown("number", name, names()))?()
}

/// The ids of the numbers that are backed so, in the order of the chapters: with [`Backing::OneRoute`] those that one route alone
/// gives.
pub fn ids_with_backing(backing: Backing) -> Vec<&'static str> {
    own_numbers().iter().filter(|number| number.backing() == backing).map(|number| number.id).collect()
}

/// The least of some numbers.
fn least(all: &[f64]) -> f64 {
    all.iter().copied().fold(f64::INFINITY, f64::min)
}

/// The greatest of some numbers.
fn most(all: &[f64]) -> f64 {
    all.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_routes_agree_and_would_not_with_one_of_them_off_by_a_hundredth() {
        for number in own_numbers() {
            let [first, second] = number.run_routes().unwrap_or_else(|error| panic!("{error}"));
            number.compare(&first, &second).unwrap_or_else(|error| panic!("{error}"));
            if number.backing() == Backing::TwoRoutes {
                let off = |n: &f64| if *n == 0.0 { 1.0 } else { 1.01 * n + 2.0 * number.allowance };
                let off: Vec<f64> = second.iter().map(off).collect();
                assert!(number.compare(&first, &off).is_err(), "{}: {first:?} and {off:?} agree", number.id);
            }
        }
    }

    #[test]
    fn what_a_conclusion_leans_on_has_two_routes() {
        for id in leaned_on::LEANED_ON {
            let number = own_numbers().iter().find(|number| number.id == *id);
            assert_eq!(number.map(OwnNumber::backing), Some(Backing::TwoRoutes), "{id}");
        }
        for number in own_numbers() {
            let is_leaned_on = leaned_on::LEANED_ON.contains(&number.id);
            assert_eq!(is_leaned_on, !number.conclusion.is_empty(), "{}", number.id);
        }
    }

    #[test]
    fn few_numbers_have_one_route_and_no_name_is_given_twice() {
        // Each new one is a number that nothing else vouches for.
        assert_eq!(ids_with_backing(Backing::OneRoute), leaned_on::ALONE);
        let mut known: Vec<_> = names().collect();
        let count = known.len();
        known.sort_unstable();
        known.dedup();
        assert_eq!(known.len(), count);
    }
}
