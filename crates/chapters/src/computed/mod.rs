//! Our numbers in a sentence: what a chapter says with a number that no source prints.

mod built;
mod escapement;
pub(crate) mod found;
mod front;
mod jazar;
mod joints;
mod kinds;
#[cfg(test)]
mod leaned_on;
pub mod making;
mod method;
mod mimic;
mod mistake;
mod never_printed;
mod pin;
mod program;
pub mod runs;
mod second_routes;
mod terminal_speed;
pub mod timer;
mod wild;

use geneva_evidence::OwnNumber;
use geneva_evidence::agreement::range;

use geneva_press::book::MakeText;
use std::sync::OnceLock;

/// The numbers of our own, chapter by chapter.
pub fn own_numbers() -> &'static [OwnNumber] {
    static NUMBERS: OnceLock<Vec<OwnNumber>> = OnceLock::new();
    NUMBERS.get_or_init(|| {
        [
            built::numbers(),
            escapement::numbers(),
            found::numbers(),
            front::numbers(),
            jazar::numbers(),
            joints::numbers(),
            making::numbers(),
            method::numbers(),
            mimic::numbers(),
            mistake::numbers(),
            never_printed::numbers(),
            pin::numbers(),
            program::numbers(),
            runs::numbers(),
            terminal_speed::numbers(),
            timer::numbers(),
            wild::numbers(),
        ]
        .into_iter()
        .flatten()
        .collect()
    })
}

/// What a chapter says of ours and is no number: lists of names, and what somebody else reports.
pub const OWN_WORDS: &[(&str, MakeText)] = &[
    mimic::WORDS[0],
    program::WORDS[0],
    timer::WORDS[0],
    timer::WORDS[1],
    timer::WORDS[2],
    timer::WORDS[3],
    timer::WORDS[4],
];

/// The names of all numbers and words; each is said in some chapter.
pub fn names() -> impl Iterator<Item = &'static str> {
    let numbers = own_numbers().iter().map(|number| number.id);
    numbers.chain(OWN_WORDS.iter().map(|(name, _)| *name))
}

/// The characters of the number or the words of this name.
#[cfg(test)]
fn own_text(name: &str) -> anyhow::Result<String> {
    geneva_press::computed_number(&crate::BOOK, name)
}

/// The least of some numbers.
fn least(all: &[f64]) -> f64 {
    range(all.iter().copied())[0]
}

/// The greatest of some numbers.
fn most(all: &[f64]) -> f64 {
    range(all.iter().copied())[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::{Backing, ids_with_backing};

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
        assert_eq!(ids_with_backing(own_numbers(), Backing::OneRoute), leaned_on::ALONE);
        let mut known: Vec<_> = names().collect();
        // A claim's id gives the claim's number.
        known.extend(crate::BOOK.ledger.claims().iter().map(|claim| claim.id));
        let count = known.len();
        known.sort_unstable();
        known.dedup();
        assert_eq!(known.len(), count);
    }
}
