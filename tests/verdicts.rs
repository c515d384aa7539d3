//! Does every claim stand as recorded, and would it be noticed if it did not?

use geneva_ledger::{Check, Claim, Decimal, Entry, Finding, Route, Verdict, Work, claims, judge, verdict, verdicts};
use std::collections::HashSet;

#[test]
fn every_claim_stands_as_recorded() {
    let wrong: Vec<_> = verdicts()
        .iter()
        .filter(|judged| !judged.holds())
        .map(|judged| format!("{}: {}", judged.claim.id, judged.complaints().join("; ")))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn ids_are_unique_and_start_with_their_source() {
    let mut seen = HashSet::new();
    for claim in claims() {
        assert!(seen.insert(claim.id), "{} stands twice", claim.id);
        let name = claim.id.strip_prefix(claim.work.slug()).and_then(|rest| rest.strip_prefix('.'));
        let well_formed = name.is_some_and(|name| {
            !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || ".-".contains(c))
        });
        assert!(well_formed, "{}: an id is the source's name, a point, and lower-case words", claim.id);
    }
}

#[test]
fn every_claim_is_checked_twice_unless_a_datum_is_missing() {
    for claim in claims() {
        match &claim.check {
            Check::Missing { reason } => assert!(!reason.is_empty(), "{}", claim.id),
            check => assert_eq!(check.evidence().len(), 2, "{}", claim.id),
        }
        assert!(!claim.meaning.is_empty() && !claim.locator.is_empty() && !claim.printed.is_empty(), "{}", claim.id);
    }
}

#[test]
fn the_two_routes_of_a_number_do_not_round_alike_everywhere() {
    // Two routes that gave the same bits for every number would be one route under two names.
    let numbers: Vec<_> = verdicts().iter().filter_map(|judged| judged.computed.zip(judged.witnessed)).collect();
    let different = numbers.iter().filter(|(computed, witnessed)| computed != witnessed).count();
    assert!(different > numbers.len() / 3, "only {different} of {} numbers differ in their last bits", numbers.len());
}

#[test]
fn an_erratum_names_claims_that_exist_and_says_why() {
    for claim in claims() {
        let Some(erratum) = &claim.erratum else { continue };
        assert_ne!(erratum.corrected, claim.printed, "{}: the correction changes nothing", claim.id);
        assert!(!erratum.reason.is_empty() && !erratum.witness.is_empty(), "{}", claim.id);
        for heir in erratum.inherited_by {
            let heir = verdict(heir).unwrap_or_else(|| panic!("{}: no claim {heir} to inherit the slip", claim.id));
            // An heir is wrong itself, or shows what it would be with the slip in it.
            let shows = heir.verdict != Verdict::Reproduced || heir.from_rounded.is_some();
            assert!(shows, "{}: {} does not show the slip", claim.id, heir.claim.id);
        }
    }
}

#[test]
fn a_wrong_digit_in_any_reproduced_number_is_noticed() {
    let mut tried = 0;
    for claim in claims().iter().filter(|claim| claim.expected == Verdict::Reproduced) {
        if !matches!(claim.check, Check::Number { .. }) {
            continue;
        }
        for (at, digit) in claim.printed.char_indices().filter(|(_, c)| c.is_ascii_digit()) {
            let other = char::from_digit((digit.to_digit(10).expect("a digit") + 1) % 10, 10).expect("a digit");
            let mut wrong = claim.printed.to_owned();
            wrong.replace_range(at..=at, &other.to_string());
            assert!(wrong.parse::<Decimal>().is_ok(), "{wrong}");
            assert!(!judge(with_printed(claim, wrong.clone())).holds(), "{}: {wrong} went unnoticed", claim.id);
            tried += 1;
        }
    }
    assert!(tried > 20, "only {tried} digits were tried");
}

#[test]
fn a_wrong_formula_is_noticed() {
    // Each route of each claim in turn is replaced by one that gives something else.
    let leaked =
        |claim: &Claim, check: Check| -> &'static Claim { Box::leak(Box::new(Claim { check, ..claim.clone() })) };
    let wrong = |evidence| Route { evidence, run: (|| 0.123_456_789) as fn() -> f64 };
    let fails = |evidence| Route { evidence, run: (|| Finding::new(false, "made to fail")) as fn() -> Finding };
    for claim in claims() {
        let mut broken = Vec::new();
        match claim.check.clone() {
            Check::Number { computed, witness, from_rounded, resolution } => {
                let (first, second) = (wrong(computed.evidence), wrong(witness.evidence));
                broken.push(Check::Number { computed: first, witness, from_rounded, resolution });
                broken.push(Check::Number { computed, witness: second, from_rounded, resolution });
            }
            Check::Form { printed, corrected, witness } => {
                let (first, second) = (fails(printed.evidence), fails(witness.evidence));
                broken.push(Check::Form { printed: printed.clone(), corrected, witness: second });
                match corrected {
                    None => broken.push(Check::Form { printed: first, corrected, witness }),
                    Some(_) => broken.push(Check::Form { printed, corrected: Some(first.run), witness }),
                }
            }
            Check::Missing { .. } => {}
        }
        for check in broken {
            let judged = judge(leaked(claim, check.clone()));
            assert!(!judged.holds(), "{} stands with a wrong route: {check:?}", claim.id);
        }
    }
}

#[test]
fn a_removed_claim_is_noticed() {
    // The coverage test looks every claim of the inventory up; without this one it would find nothing.
    for work in Work::ALL {
        let listed = work.inventory().iter().flat_map(|line| line.entries);
        let ids: Vec<_> = listed.filter_map(Entry::claimed).collect();
        assert_eq!(ids.len(), work.claims().len(), "{work}: a claim is listed and gone, or made and not listed");
    }
}

fn with_printed(claim: &Claim, printed: String) -> &'static Claim {
    Box::leak(Box::new(Claim { printed: printed.leak(), ..claim.clone() }))
}
