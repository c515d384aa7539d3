//! Faults that were found in one claim and can be in any other: what is looked for here in all of them.

use geneva_documents::LEDGER;
use geneva_evidence::testing::reliance;
use geneva_evidence::{Check, Claim, Finding, Stated, Truth};

#[test]
fn claims_on_one_quantity_show_one_computed_number() {
    let computed = |id: &str| LEDGER.verdict(id).and_then(|judged| judged.computed).expect("a computed number");
    for [one, other] in [
        ["jazar.ex-c.dwell", "jazar.ex-c.dwell-seconds"],
        ["jazar.ex-d.driver-speed", "jazar.ex-d.peak"],
        ["pin.radius", "wild.holooly.radius"],
        ["pin.angle-at-pivot", "pin.slot-point-velocity-direction"],
        ["pin.angle-at-pivot", "pin.sliding-velocity-direction"],
        ["pin.angle-at-pivot", "wild.holooly.angle"],
        ["pin.sliding-speed", "wild.holooly.sliding"],
        ["pin.follower-speed", "wild.holooly.speed"],
    ] {
        let (a, b) = (computed(one), computed(other));
        assert!((a - b).abs() <= 1e-12 * a.abs(), "{one}: {a}, and {other}: {b}");
    }
}

/// What both routes of a statement find for its neighbour.
fn neighbours_found() -> Vec<(&'static Claim, [Finding; 2])> {
    let found = |claim: &'static Claim| {
        let Check::Statement { first, witness, neighbour: Some(_) } = &claim.check else { return None };
        let wrong = Stated::wrong(claim.printed);
        Some((claim, [(first.run)(wrong), (witness.run)(wrong)]))
    };
    LEDGER.claims().iter().copied().filter_map(found).collect()
}

#[test]
fn a_neighbour_is_false_in_every_case_of_its_test() {
    // What is tried with each number of stations says for how many the neighbour fails.
    let mut partly = Vec::new();
    for (claim, findings) in neighbours_found() {
        for finding in findings {
            let fails_in_some = finding.how.starts_with("for ") && finding.how.contains(" numbers of stations, from ");
            if fails_in_some || finding.how.starts_with("with ") && finding.how.contains("stations it is not true") {
                partly.push(format!("{}: {}", claim.id, finding.how));
            }
        }
    }
    assert!(partly.is_empty(), "{} are true in some cases:\n{}", partly.len(), partly.join("\n"));
}

/// The senses and directions that a text names, in their order, each by a word and whether it is the first of its pair.
fn senses(text: &str) -> Vec<(&'static str, bool)> {
    const PAIRS: [(&str, [&str; 2]); 5] = [
        ("turn", ["counterclockwise", "clockwise"]),
        ("page", ["out of the page", "into the page"]),
        ("side", ["to the left", "to the right"]),
        ("height", ["up and", "down and"]),
        ("line", ["from the horizontal", "from the vertical"]),
    ];
    let text = text.replace("counter-clockwise", "counterclockwise");
    let mut found = Vec::new();
    for (kind, [one, other]) in PAIRS {
        let places = text.match_indices(other).filter(|(at, _)| !text[..*at].ends_with("counter"));
        found.extend(places.map(|(at, _)| (at, kind, false)));
        found.extend(text.match_indices(one).map(|(at, _)| (at, kind, true)));
    }
    found.sort_unstable();
    found.into_iter().map(|(_, kind, first)| (kind, first)).collect()
}

#[test]
fn the_neighbour_of_a_claim_on_senses_exchanges_all_of_them() {
    // Each other exchange says something of how the senses go together, which is another claim's matter.
    assert_eq!(senses("counter-clockwise, then clockwise"), [("turn", true), ("turn", false)]);
    let mut tried = 0;
    for claim in LEDGER.claims() {
        let Check::Statement { neighbour: Some(neighbour), .. } = claim.check else { continue };
        let said = match senses(claim.meaning) {
            none if none.is_empty() => senses(claim.printed),
            said => said,
        };
        if said.is_empty() {
            continue;
        }
        let exchanged: Vec<_> =
            said.iter().filter(|(kind, _)| *kind != "line").map(|(kind, is)| (*kind, !is)).collect();
        assert_eq!(senses(neighbour), exchanged, "{}: {neighbour}", claim.id);
        tried += 1;
    }
    assert!(tried >= 6, "only {tried} claims on senses");
}

/// The numbers of the equations that a text names, as in `Eqs. (5.30) to (5.32)`.
fn equations_named(text: &str) -> Vec<&str> {
    let numbers = text.split('(').skip(1).filter_map(|rest| rest.split(')').next());
    let is_number = |number: &&str| {
        let parts = number.split(['.', '-']).collect::<Vec<_>>();
        parts.len() == 2 && parts.iter().all(|part| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit()))
    };
    numbers.filter(is_number).collect()
}

/// Equations that a reading names although nothing is read off them.
const NAMED_ONLY: [(&str, &str); 1] = [("meyer.singularity.conclusion", "1-18")];

#[test]
fn an_equation_that_a_reading_names_is_one_that_the_check_uses() {
    assert_eq!(equations_named("Eqs. (1-4) and (5.30), part (a)"), ["1-4", "5.30"]);
    let (mut elsewhere, mut named) = (Vec::new(), 0);
    for claim in LEDGER.claims() {
        let (Some(reading), Some([(_, one), (_, other)])) = (claim.reading, reliance(claim)) else {
            continue;
        };
        for equation in equations_named(reading) {
            let used = one.union(&other).copied().chain([claim.id]);
            let mut locators = used.filter_map(|id| LEDGER.claim(id)).map(|claim| claim.locator);
            let is_used = locators.any(|locator| equations_named(locator).contains(&equation));
            if !is_used && !NAMED_ONLY.contains(&(claim.id, equation)) {
                elsewhere.push(format!("{}: ({equation})", claim.id));
            }
            named += 1;
        }
    }
    assert!(elsewhere.is_empty(), "{} of {named} are not used:\n{}", elsewhere.len(), elsewhere.join("\n"));
}

/// What a reading or a reason says of another place of its source: the words, that place's claim, and the answer that they rely on.
const RELIED_ON: [(&str, &str, Truth); 4] = [
    ("it is open whether as a need or as a choice", "meyer.always-engaged", Truth::Open),
    ("printed 90° is a claim of its own", "meyer.app-b.fold", Truth::Wrong),
    (
        "the printed reset, which gives that X for four pins only, is a claim of its own",
        "meyer.app-b.fold",
        Truth::Wrong,
    ),
    ("the minus sign that it has lost in the copy", "jazar.eq-5.29", Truth::Wrong),
];

#[test]
fn a_reading_that_relies_on_another_place_agrees_with_that_places_claim() {
    let texts = || {
        let of = |claim: &'static Claim| {
            let missing = if let Check::Missing { reason } = claim.check { Some(reason) } else { None };
            [claim.reading, missing].into_iter().flatten().map(|text| (claim.id, text))
        };
        LEDGER.claims().iter().copied().flat_map(of)
    };
    for (words, id, answer) in RELIED_ON {
        let judged = LEDGER.verdict(id).unwrap_or_else(|| panic!("no claim {id}"));
        assert_eq!(judged.truth(), answer, "{id}, of which a reading says: {words}");
        assert!(texts().any(|(_, text)| text.contains(words)), "no reading says: {words}");
    }
    // Whoever says such a thing of another place is listed.
    for (id, text) in texts() {
        for mark in ["it is open", "a claim of its own", "lost in the copy", "is wrong there", "is right there"] {
            let is_listed = RELIED_ON.iter().any(|(words, ..)| words.contains(mark) && text.contains(words));
            assert!(!text.contains(mark) || is_listed, "{id} relies on another place and is not listed: {text}");
        }
    }
}

#[test]
fn a_neighbour_says_what_no_claim_of_its_source_says() {
    let plain = |text: &str| text.to_lowercase().split_whitespace().collect::<Vec<_>>().join(" ");
    let mut tried = 0;
    for claim in LEDGER.claims() {
        let Check::Statement { neighbour: Some(neighbour), .. } = claim.check else { continue };
        let said = plain(neighbour);
        for other in LEDGER.claims().iter().filter(|other| other.document == claim.document) {
            assert!(
                said != plain(other.meaning) && said != plain(other.printed),
                "the near miss of {} is what {} says: {neighbour}",
                claim.id,
                other.id
            );
        }
        tried += 1;
    }
    assert!(tried > 100, "only {tried} near misses");
}
