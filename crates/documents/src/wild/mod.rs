//! What public pages, calculators and programs say about Geneva wheels.
//!
//! The pages are not documents that the book mirrors. We take single statements from them, each with its address and
//! the day on which a stored copy of the page was read. Formulas are set as they say, in the letters of the page. Where
//! the words and letters of a page can be read in two ways, we read them in the way in which they are right, if there
//! is one. The files go by what is stated: how long the driver turns, the sizes, what a letter means, the motion,
//! wheels that are shipped as examples. What a program builds is an example, whether it works or not, but what the
//! program or a page says is a statement. [`TAKEN_WHOLE`] lists the pages of which we took every formula.

mod discs;
mod epicyclic;
mod fit;
mod labels;
mod models;
mod motion;
mod pages;
mod ratios;
mod sizes;
mod steps;
mod textbook;
mod turning;

pub use pages::{CONTENTS, TAKEN_WHOLE};
pub use ratios::ratio;

use fit::{Fit, formula, number};
use geneva_evidence::{Cache, Claim, Consequence, Document, Evidence, Finding, Locator, Origin, Slip, Stated};
use pages::*;
use std::f64::consts::PI;

/// What stands between an address and the day in a locator.
const AS_READ: &str = ", as read on ";

/// The locator of a page: its address, and when a stored copy of it was read.
macro_rules! page {
    ($address:literal) => {
        page!($address, "2026-11-22")
    };
    ($address:literal, $day:literal) => {
        concat!($address, ", as read on ", $day)
    };
}
use page;

/// Statements on public pages and in public programs, each with its address.
pub static WILD: Document = Document {
    slug: "wild",
    title: "pages elsewhere",
    citation: "Statements on public pages and in public programs, each with the address of its source and the day on \
        which a stored copy was read.",
    inventory: None,
    claims,
    answers: &[],
    given: Vec::new,
    conclusions: &[],
    // Each page has letters of its own; what they stand for is told with each statement.
    symbols: &[],
    units: &[
        ("angular speed of the wheel", "rad/s"),
        ("speed of the pin", "mm/s"),
        ("acceleration of the pin", "mm/s²"),
        ("angle", "°"),
        ("how far the driver turns", "°"),
        ("radius", "mm"),
        ("distance", "mm"),
        ("rest of a wheel", "%"),
        ("part of the cycle", "%"),
        ("part of the time", ""),
        ("rest over move", ""),
        ("time of a move over the time of a rest", ""),
        ("teeth", ""),
    ],
    test: "cargo test -p geneva-documents --test verdicts wild_stands",
    cache: Cache::new(),
};

/// A page.
const fn at(locator: &'static str) -> Locator {
    Locator::new(&WILD, locator)
}

/// A heading, and the statements under it.
pub type Subject = (&'static str, fn() -> Vec<Claim>);

/// A topic, and the statements about it.
pub const SUBJECTS: &[Subject] = &[
    ("How long a wheel moves and rests", turning::claims),
    ("How many steps there are", steps::claims),
    ("Sizes", sizes::claims),
    ("What a letter means", labels::claims),
    ("Wheels that programs build", models::claims),
    ("The locking disc", discs::claims),
    ("How a wheel moves", motion::claims),
    ("A pin on a pinion", epicyclic::claims),
    ("A textbook problem, continued", textbook::claims),
];

/// All statements, by what they are about.
pub fn claims() -> Vec<Claim> {
    SUBJECTS.iter().flat_map(|(_, claims)| claims()).collect()
}

/// The address of the page on which a statement stands, and the day on which it was read, from the claim's locator.
pub fn read(locator: &str) -> Option<(&str, &str)> {
    locator.split_once(AS_READ)
}

/// Whether every formula of the page at this address was taken, and not only single statements.
pub fn is_taken_whole(address: &str) -> bool {
    TAKEN_WHOLE.iter().filter_map(|place| read(place.text())).any(|(known, _)| known == address)
}

/// The identifier of what was read at this address, if it is part of a repository that was at hand.
pub fn content(address: &str) -> Option<&'static str> {
    let of = |(place, _): &&(Locator, &str)| read(place.text()).is_some_and(|(known, _)| known == address);
    CONTENTS.iter().find(of).map(|(_, content)| *content)
}

/// The slip of a claim that is found in the page's own formula or number.
const fn slip(reason: &'static str, witness: &'static str, changes: &'static str) -> Slip {
    Slip { id: "", reason, witness, origin: Origin::Concept, consequence: Consequence::Result, changes }
}

#[cfg(test)]
mod tests {
    use super::fit::ANY;
    use super::*;
    use crate::LEDGER;
    use geneva_evidence::Truth;
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

    fn is_hash(text: &str) -> bool {
        text.len() == 40 && text.chars().all(|c| c.is_ascii_digit() || ('a'..='f').contains(&c))
    }

    #[test]
    fn evidence_in_a_repository_does_not_move() {
        // Files that were read one by one, without the repository that tells what identifies them.
        const ALONE: [&str; 4] = ["FreeCAD/", "MHSGhali/", "cool-japan/", "edtechd/"];
        let addresses: BTreeSet<_> = claims().iter().filter_map(|claim| Some(read(claim.locator)?.0)).collect();
        let mut files = 0;
        for address in addresses {
            assert!(!address.contains("/HEAD/"), "{address}: name the commit");
            let Some(path) = address.strip_prefix("https://github.com/") else {
                assert_eq!(content(address), None, "{address}");
                continue;
            };
            if path.contains("/pull/") {
                continue;
            }
            let commit = path.split('/').nth(3).unwrap_or_default();
            assert!(is_hash(commit), "{address}: `{commit}` is no commit");
            let found = content(address).and_then(|content| {
                let (kind, hash) = content.strip_prefix("swh:1:")?.split_once(':')?;
                (["cnt", "dir"].contains(&kind) && is_hash(hash)).then_some(kind)
            });
            let alone = ALONE.iter().any(|owner| path.starts_with(owner));
            assert_eq!(found.is_none(), alone, "{address}");
            assert_eq!(found == Some("dir"), path.contains("/tree/"), "{address}");
            files += 1;
        }
        assert_eq!(CONTENTS.len() + 7, files);
    }

    #[test]
    fn what_is_taken_whole_is_a_page_of_some_statements() {
        for place in TAKEN_WHOLE {
            let (address, _) = read(place.text()).expect("an address and a day");
            assert!(is_taken_whole(address));
            assert!(claims().iter().any(|claim| claim.locator == place.text()), "{address}");
        }
        assert!(!is_taken_whole("https://unseel.com/engineering/geneva-drive"));
    }

    #[test]
    fn right_statements_are_listed_as_well_as_wrong_ones() {
        let addresses = |truth| -> BTreeSet<&str> {
            let of_truth = LEDGER.verdicts_of(&WILD).into_iter().filter(|judged| judged.truth() == truth);
            of_truth.filter_map(|judged| Some(read(judged.claim.locator)?.0)).collect()
        };
        assert!(addresses(Truth::Right).len() >= 12 && addresses(Truth::Wrong).len() >= 8);
    }

    #[test]
    fn what_a_slip_is_said_to_do_is_computed() {
        let times = |number: f64, places: usize| format!("{number:.places$}");
        let [four, six, eight] = [4, 6, 8].map(Fit::by_vectors);
        let (planned, takes) = (|fit: &Fit| fit.step, |fit: &Fit| fit.moving);
        let root = |slots: f64| (2.0 + 2.0 * libm::cos(PI / slots)).sqrt();
        let on_the_line = libm::hypot(six.centres, six.crank) / six.crank;
        let said = [
            ("firgelli-time.dwell", "twice", times(takes(&six) / planned(&six), 0), "2"),
            ("firgelli-time.dwell", "three times", times(takes(&eight) / planned(&eight), 0), "3"),
            ("firgelli-time.centres", "1.7", times(six.rim / libm::sin(PI / 6.0) / six.centres, 1), "1.7"),
            ("firgelli-indexing.centres", "1.41", times(four.centres / four.crank, 2), "1.41"),
            ("firgelli-indexing.centres", "1.85", times(root(4.0), 2), "1.85"),
            ("firgelli-form.speed", "1.4", times(four.centres / four.crank, 1), "1.4"),
            ("firgelli-form.speed", "twice", times(six.centres / six.crank, 0), "2"),
            ("oxiphysics.speed", "less than one half", times(libm::ceil(20.0 / on_the_line) / 20.0, 2), "0.45"),
            ("oxiphysics.speed", "true ratio is one", times(six.crank / (six.centres - six.crank), 0), "1"),
            ("mecha-external.gears", "ratio must be 10", times(epicyclic::least_ratio(5), 0), "10"),
            ("mecha-internal.gears", "ratio must be 10", times(epicyclic::least_ratio(5), 0), "10"),
        ];
        let changes = |id: &str| LEDGER.slip(id).map_or("", |places| places.slip.changes);
        for (id, words, computed, expected) in said {
            let id = format!("wild.{id}");
            assert!(changes(&id).contains(words), "{id}: {}", changes(&id));
            assert_eq!(computed, expected, "{id}: {words}");
        }
        for (id, words) in [
            ("wild.freecad.cut", "by 0.17 mm"),
            ("wild.freecad.arcs", "up to 2.66 mm"),
            ("wild.sdfx.cut", "by 0.05 mm"),
            ("wild.cherry-pitter.cam", "17°"),
        ] {
            let judged = LEDGER.verdict(id).expect("a claim");
            assert!(judged.findings.iter().any(|(_, found)| found.how.contains(words)), "{:?}", judged.findings);
            assert!(changes(id).contains(words), "{id}");
        }
        // Rounded as their reading says.
        for (id, right) in [("wild.unseel.six", "67"), ("wild.unseel.eight", "62.5")] {
            let judged = LEDGER.verdict(id).expect("a claim");
            assert_eq!(judged.corrected().as_deref(), Some(right), "{id}");
        }
        // Other tests than four slots, as the chapter says.
        for (slots, degrees) in [(5, 108.0), (8, 135.0)] {
            assert!((Fit::by_vectors(slots).moving.to_degrees() - degrees).abs() < 1e-9, "{slots} slots");
        }
        // Too far apart up to five slots, too close from six on.
        for slots in ANY {
            let wheel = Fit::by_vectors(slots);
            assert_eq!(root(wheel.slots) > wheel.centres / wheel.crank, slots < 6, "{slots} slots");
        }
    }

    /// For which numbers of slots a wrong formula or example is right, as its check counts them; none if it does not count.
    fn right_for(judged: &geneva_evidence::Judged) -> Option<Vec<u32>> {
        let (_, finding) = judged.findings.iter().find(|(form, _)| *form == "as printed")?;
        let (_, counted) =
            finding.how.split_once(&format!("from {} to {}, and it is right ", ANY.start(), ANY.end()))?;
        let words = counted.split(|c: char| !c.is_ascii_digit()).filter_map(|digits| digits.parse().ok());
        Some(words.collect())
    }

    #[test]
    fn five_and_eight_slots_refute_every_wrong_formula() {
        let wrong = LEDGER.verdicts_of(&WILD).into_iter().filter(|judged| judged.truth() == Truth::Wrong);
        let counted: Vec<_> = wrong.filter_map(|judged| Some((judged.claim.id, right_for(judged)?))).collect();
        assert!(counted.len() >= 12, "{counted:?}");
        for (id, slots) in &counted {
            assert!(!slots.contains(&5) && !slots.contains(&8), "{id} is right for {slots:?}");
        }
        // Three and six refute neither ratio of teeth.
        let teeth = |(id, _): &&(&str, Vec<u32>)| id.ends_with(".gears");
        let teeth: Vec<_> = counted.iter().filter(teeth).map(|(_, slots)| slots.clone()).collect();
        assert_eq!(teeth, [vec![3, 4, 6], vec![3, 4, 6]]);
        // The classes of the chapter: at four slots alone, at three, four and six, and at none.
        let equations = counted
            .iter()
            .filter(|(id, _)| LEDGER.claim(id).is_some_and(|claim| claim.kind == geneva_evidence::Kind::Equation));
        for (id, slots) in equations {
            assert!([&[][..], &[4], &[3, 4, 6]].contains(&&slots[..]), "{id} is right for {slots:?}");
        }
    }
}
