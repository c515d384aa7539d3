//! Do the sources and the book print what the programs compute? Their displays are read, evaluated and compared.
//!
//! The ledger reads the characters; here is said what their letters stand for, by the formula crates. And would a
//! misprint be noticed? Each is made by rule and must be refuted, if it can be read at all.

mod book;
mod claims;
mod escapement;
mod expressions;
mod inline;
mod joints;
mod mechanisms;
mod notation;
mod proofs;

use geneva_evidence::tex::{Class, Misprint, misprints};
use std::collections::BTreeMap;

/// A number between zero and one, one of many that are spread evenly, the same on every machine.
fn spread(number: usize, which: usize) -> f64 {
    const PRIMES: [f64; 14] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0, 41.0, 43.0];
    ((number + 1) as f64 * PRIMES[which].sqrt()).fract()
}

/// Misprints that make no difference: whose equation, why it says the same, and the changes.
type Harmless = [(&'static str, &'static str, &'static [&'static str])];

/// What became of all misprints in some equations.
#[derive(Default)]
struct Misprints {
    refuted: BTreeMap<Class, usize>,
    /// What cannot be read any more is noticed too, but proves nothing.
    unreadable: usize,
    survivors: Vec<(String, Misprint)>,
}

impl Misprints {
    /// Makes all misprints of somebody's equation, and sees whether it still holds; how many are refuted.
    fn make(&mut self, whose: &str, tex: &str, holds: impl Fn(&str) -> Option<bool>) -> usize {
        let mut refuted = 0;
        for misprint in misprints(tex) {
            match holds(&misprint.tex) {
                Some(false) => {
                    refuted += 1;
                    *self.refuted.entry(misprint.class).or_default() += 1;
                }
                Some(true) => self.survivors.push((whose.to_owned(), misprint)),
                None => self.unreadable += 1,
            }
        }
        refuted
    }

    /// Those that make no difference are known, each with its reason, and no others are.
    #[track_caller]
    fn are_noticed_but_for(&self, harmless: &Harmless) {
        let (refuted, unreadable) = (self.refuted.values().sum::<usize>(), self.unreadable);
        println!("{refuted} refuted, {} not; {unreadable} cannot be read: {:?}", self.survivors.len(), self.refuted);
        let known = || harmless.iter().flat_map(|(whose, reason, of)| of.iter().map(move |of| (*whose, *of, *reason)));
        let is = |(of, misprint): &(String, Misprint), whose: &str, change: &str| {
            of.starts_with(whose) && misprint.change == change
        };
        let unknown = |survivor: &&(String, Misprint)| !known().any(|(whose, change, _)| is(survivor, whose, change));
        let unknown = self.survivors.iter().filter(unknown);
        let new: Vec<_> = unknown.map(|(of, misprint)| format!("{of} {}: {}", misprint.change, misprint.tex)).collect();
        assert!(new.is_empty(), "{} misprints make no difference:\n{}", new.len(), new.join("\n"));
        for (whose, change, reason) in known() {
            let left = self.survivors.iter().filter(|survivor| is(survivor, whose, change)).count();
            assert_eq!(left, 1, "{whose} {change}: it makes a difference, though {reason}");
        }
    }
}
