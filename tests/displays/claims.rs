//! The equations of the sources, as the ledger prints and corrects them, hold or fail as its verdicts say.
//!
//! Each is evaluated somewhere: by the ledger itself, with values for every letter from vectors and Newton's laws; or
//! here, with values from the formula crates. Or it is checked like a statement, with a neighbour made by hand. Which,
//! it says itself.

use super::letters::{equation, states};
use super::{Harmless, Misprints};
use geneva_ledger::tex::{Class, Display};
use geneva_ledger::{Check, Claim, Kind, Verdict, Work};
use std::collections::BTreeMap;

/// Printed equations that cannot be evaluated as they are; their corrections can.
const ILLEGIBLE: &[(&str, &str)] = &[
    ("pin.centre-distance", "a bar where the root sign was"),
    ("meyer.app-b.example.second", LETTER_FOR_FIGURE),
    ("meyer.app-b.example.first", LETTER_FOR_FIGURE),
    ("meyer.app-b.example.place", LETTER_FOR_FIGURE),
];

const LETTER_FOR_FIGURE: &str = "a name with a letter for its figure, which names nothing";

/// Misprints that make no difference.
const HARMLESS: &Harmless = &[
    (
        "quick-return.rate-conversion",
        "a fraction that is one is one turned over too",
        &["piece 16: the fraction is turned over", "piece 27: the fraction is turned over"],
    ),
    (
        "quick-return.sum-of-places-by-points",
        "the letter has the same meaning without its index",
        &["piece 1: the index is lost"],
    ),
    ("wild.counter.rim", "two divisors may change places", &["piece 15: the quotient is turned over"]),
    ("jazar.eq-5.34", "both signs are meant", &["piece 0: a minus is put before it"]),
    ("meyer.phi-0", NAMED_TWICE, &HANDING_OVER[0]),
    ("meyer.theta-0", NAMED_TWICE, &HANDING_OVER[1]),
    (
        "meyer.acceleration-by-quotient",
        "a constant has no rate of change",
        &[
            "piece 32: - becomes +",
            "piece 33: 1 becomes 2",
            "piece 33: 1 becomes 0",
            "piece 52: 1 becomes 2",
            "piece 52: 1 becomes 0",
            "piece 53: + becomes -",
            "piece 55: what is raised is lost",
            "piece 56: 2 becomes 3",
            "piece 56: 2 becomes 1",
        ],
    ),
    (
        "meyer.app-a.four-slots.centre-equation",
        "at half a right angle sine and cosine are equal",
        &[r"piece 7: \sin becomes \cos", r"piece 20: \sin becomes \cos"],
    ),
    (
        "meyer.app-a.four-slots.radius-equation",
        "four slots: both radii are one, both angles half a right angle",
        &[
            "piece 0: R becomes r",
            "piece 2: the fraction is turned over",
            "piece 4: r becomes R",
            "piece 4: r is lost",
            r"piece 5: \sin becomes \cos",
            r"piece 6: \theta_o becomes \phi_o",
            "piece 7: the index is lost",
            r"piece 11: \sin becomes \cos",
            r"piece 12: \phi_o becomes \theta_o",
            "piece 13: the index is lost",
            "piece 17: the fraction is turned over",
            r"piece 20: \sin becomes \cos",
            r"piece 26: \sin becomes \cos",
        ],
    ),
    ("meyer.app-a.three-slots.radius-equation", ONE_RADIUS, &LOST),
    ("meyer.app-a.six-slots.radius-equation", ONE_RADIUS, &LOST),
    ("meyer.virtual-work", NAMED_TWICE, &[r"piece 3: Q_\theta becomes \tau", r"piece 9: \tau becomes Q_\theta"]),
    ("meyer.generalised-torque", NAMED_TWICE, &[r"piece 0: Q_\theta becomes \tau", r"piece 4: \tau becomes Q_\theta"]),
    ("meyer.eq-1-15", NAMED_TWICE, &[r"piece 0: \tau_1 becomes K", r"piece 4: K becomes \tau_1"]),
    (
        "meyer.singularity.ratio",
        "a fraction that is one is one turned over too",
        &["piece 2: the fraction is turned over"],
    ),
    ("meyer.app-b.example.place", "B is X at the start", &["piece 10: B becomes X"]),
    ("meyer.app-b.s", "S has the sign of F", &["piece 9: F becomes S", "piece 21: F becomes S"]),
    (
        "meyer.app-d.acceleration",
        "the acceleration at the start is the one with the index",
        &["piece 4: the index is lost"],
    ),
];

/// The angles at the hand-over have two names each in their displays.
const HANDING_OVER: [[&str; 3]; 2] = [
    [r"piece 0: \phi becomes \phi_0", r"piece 2: \phi_0 becomes \phi", "piece 3: the index is lost"],
    [r"piece 0: \theta becomes \theta_0", r"piece 2: \theta_0 becomes \theta", "piece 3: the index is lost"],
];

const NAMED_TWICE: &str = "what is set equal is named twice";
const ONE_RADIUS: &str = "the radius is one, and the angles are those at the hand-over";
const LOST: [&str; 3] = ["piece 4: r is lost", "piece 7: the index is lost", "piece 13: the index is lost"];

/// The equations of all sources that are evaluated: all but those that have a neighbour.
fn equations() -> impl Iterator<Item = &'static Claim> {
    let is_evaluated = |claim: &&Claim| matches!(claim.check, Check::Equation { .. });
    geneva_ledger::claims().iter().filter(|claim| claim.kind == Kind::Equation).filter(is_evaluated)
}

/// Whether a claim's equation holds with given characters.
fn evaluation(claim: &'static Claim) -> impl Fn(&str) -> Result<bool, String> {
    let states = if claim.check.reader().is_some() { Vec::new() } else { states(claim) };
    move |tex| match claim.check.reader() {
        Some(reader) => (reader.holds)(tex).ok_or_else(|| "the ledger cannot read it".to_owned()),
        None => Display::read(tex).and_then(|display| display.holds(&states)).map_err(|error| error.to_string()),
    }
}

#[test]
fn every_equation_is_read_or_has_a_neighbour() {
    let mut count: BTreeMap<Work, [usize; 3]> = BTreeMap::new();
    for claim in geneva_ledger::claims().iter().filter(|claim| claim.kind == Kind::Equation) {
        let way = match claim.check {
            Check::Equation { .. } => usize::from(claim.check.reader().is_none()),
            Check::Statement { .. } => 2,
            _ => panic!("{}: nobody reads it, and it has no neighbour", claim.id),
        };
        count.entry(claim.work).or_default()[way] += 1;
    }
    println!("read by the ledger, read here, with a neighbour made by hand: {count:?}");
}

#[test]
fn equations_hold_or_fail_as_the_verdicts_say() {
    let (mut wrong, mut count) = (Vec::new(), BTreeMap::new());
    for claim in equations() {
        let (holds, reader) = (evaluation(claim), claim.check.reader());
        let right = holds(&equation(claim, claim.right_characters()));
        // What is not ours to print says the same in the letters of mathematics.
        let printed = if reader.is_some_and(|reader| reader.said.is_some()) {
            right.clone()
        } else {
            holds(&equation(claim, claim.printed))
        };
        let illegible = ILLEGIBLE.iter().any(|(id, _)| *id == claim.id);
        let as_expected = match (claim.expected, &printed) {
            (Verdict::Reproduced, Ok(true)) => true,
            (Verdict::Corrected, Ok(false)) => true,
            (Verdict::Corrected, Err(_)) => illegible,
            _ => false,
        };
        if as_expected && right == Ok(true) {
            let counted: &mut [u32; 2] = count.entry(claim.work).or_default();
            counted[usize::from(claim.erratum.is_some())] += 1;
        } else {
            wrong.push(format!("{}: `{}`: {printed:?}, put right {right:?}", claim.id, claim.printed));
        }
    }
    println!("right as printed, and corrected: {count:?}");
    let way_out = "give what its letters stand for in `letters.rs`, or check it like a statement, with a neighbour";
    assert!(wrong.is_empty(), "{}\nIf nothing is wrong: {way_out}", wrong.join("\n"));
    let least = [
        (Work::Pin, [8, 1]),
        (Work::QuickReturn, [22, 2]),
        (Work::Jazar2003, [27, 2]),
        (Work::Meyer1973, [28, 4]),
        (Work::Wild, [25, 8]),
    ];
    for (work, [right, put_right]) in least {
        let found = count.get(&work).copied().unwrap_or_default();
        assert!(found[0] >= right && found[1] >= put_right, "{work}: {found:?}");
    }
}

#[test]
fn every_misprint_in_a_source_is_noticed() {
    let mut misprints = Misprints::default();
    let mut by_work: BTreeMap<Work, usize> = BTreeMap::new();
    for claim in equations() {
        let holds = evaluation(claim);
        let refuted = misprints.make(claim.id, &equation(claim, claim.right_characters()), |tex| holds(tex).ok());
        assert!(refuted > 0, "{}: no misprint is refuted", claim.id);
        *by_work.entry(claim.work).or_default() += refuted;
    }
    println!("{by_work:?}");
    misprints.are_noticed_but_for(HARMLESS);
    assert!(Class::ALL.iter().all(|class| misprints.refuted.contains_key(class)), "{:?}", misprints.refuted);
    // The book says how many there are.
    let (refuted, harmless) = (misprints.refuted.values().sum::<usize>(), misprints.survivors.len());
    let record = format!("refuted,{refuted}\nunreadable,{}\nharmless,{harmless}\n", misprints.unreadable);
    let file = crate::path("book/records/misprints.csv");
    if !std::fs::read_to_string(&file).is_ok_and(|standing| standing == record) {
        std::fs::write(&file, &record).expect("written");
        panic!("{} was not up to date and is now: look at the difference and test again", file.display());
    }
}
