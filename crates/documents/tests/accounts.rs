//! Is what a reader is told of a check true, also of characters that he puts in?

use geneva_documents::LEDGER;
use geneva_evidence::{Account, Check, Decimal, MOST_CHARACTERS, Taken, Verdict};

/// The words of an account under a label; empty if it has none.
fn told<'a>(account: &'a Account, label: &str) -> &'a str {
    account.lines.iter().find(|(of, _)| *of == label).map_or("", |(_, text)| text)
}

#[test]
fn every_check_names_a_near_miss_that_both_routes_refuse_and_that_is_not_right() {
    let mut without = Vec::new();
    for claim in LEDGER.claims() {
        let account = Account::for_claim(claim);
        let near = told(&account, "Near miss");
        if near.is_empty() {
            without.push(claim.id);
            continue;
        }
        assert!(near.ends_with("both routes refuse it"), "{}: {near}", claim.id);
        assert_eq!(told(&account, "Record"), "as recorded", "{}", claim.id);
        let digits = near.split(' ').next().and_then(|digits| digits.parse::<Decimal>().ok());
        if let (Some(digits), Check::Number { .. }) = (digits, &claim.check) {
            let right = account.judged.right_value.or(account.judged.computed).expect("a number");
            assert!(!digits.is_rounding_of(right), "{}: {near} is right", claim.id);
        }
    }
    // What is missing has nothing to refuse.
    let checked = |id: &&&str| !matches!(LEDGER.claim(id).expect("a claim").check, Check::Missing { .. });
    assert_eq!(without.iter().filter(checked).collect::<Vec<_>>(), Vec::<&&str>::new());
}

#[test]
fn who_puts_the_correction_in_is_told_that_it_holds() {
    let mut tried = 0;
    for claim in LEDGER.claims() {
        let Some(erratum) = claim.erratum.as_ref().filter(|erratum| !erratum.corrected.is_empty()) else { continue };
        if matches!(claim.check, Check::Number { .. }) {
            continue;
        }
        tried += 1;
        let account = Account::for_characters(claim, erratum.corrected).expect("short enough");
        assert_eq!(account.judged.verdict, Verdict::Reproduced, "{}: {}", claim.id, account.text());
    }
    assert!(tried > 50, "{tried} corrections");
}

#[test]
fn the_angle_between_two_pins_is_right_in_every_form_and_no_other_angle_is() {
    let claim = LEDGER.claim("meyer.listing.fold").expect("a claim");
    let right =
        ["2π/m", "X (MOD(THETA,6.2832/M))+X0", "360°/m", "360 / m", "2*PI/M", "2 \\pi / n", "1.5708, 1.0472, 2.0944"];
    let wrong = [
        "π/m",
        "X (MOD(THETA,1.5708))+X0",
        "180°/m",
        "6.2732/M",
        "1.0472",
        "3π/m",
        "2π/4",
        "/m",
        "°/m",
        "π",
        "2π/m: 1.5709",
    ];
    for (form, verdict) in
        right.map(|form| (form, Verdict::Reproduced)).into_iter().chain(wrong.map(|form| (form, Verdict::Corrected)))
    {
        let account = Account::for_characters(claim, form).expect("short enough");
        assert_eq!(account.judged.verdict, verdict, "{form}: {}", account.text());
    }
}

#[test]
fn who_puts_the_right_number_in_is_told_that_it_is_right() {
    let mut tried = 0;
    for claim in LEDGER.claims() {
        let judged = LEDGER.verdict(claim.id).expect("a claim");
        let (Check::Number { .. }, Some(right), Some(corrected)) =
            (&claim.check, judged.right_value, judged.corrected())
        else {
            continue;
        };
        if judged.computed == Some(right)
            || corrected
                .parse::<Decimal>()
                .is_ok_and(|of| judged.computed.is_some_and(|computed| of.is_rounding_of(computed)))
        {
            continue;
        }
        tried += 1;
        let account = Account::for_characters(claim, &corrected).expect("short enough");
        assert!(told(&account, "Found").contains("but of the right number"), "{}: {}", claim.id, account.text());
    }
    assert!(tried > 30, "{tried} numbers");
}

#[test]
fn words_that_change_nothing_are_told_to_be_unread_and_what_cannot_be_read_proves_nothing() {
    for (id, characters, taken) in [
        ("pin.driver-sense", "clockwise", Taken::Unread),
        ("pin.problem-figure", "banana", Taken::Unread),
        ("pin.radius", "3x", Taken::Unreadable),
        ("pin.radius", "9", Taken::Read),
        ("meyer.eq-1-17", "x^", Taken::Unreadable),
        ("meyer.eq-1-17", "0 = 1", Taken::Read),
    ] {
        let account = Account::for_characters(LEDGER.claim(id).expect("a claim"), characters).expect("short enough");
        assert_eq!(account.taken, Some(taken), "{id}: {}", account.text());
    }
}

#[test]
fn no_characters_keep_a_check_for_long() {
    // Each of these took seconds, or would never end.
    let hostile = [
        format!("v_{{P'}}={}2", "2^".repeat(100)),
        format!("v_{{P'}}={}2{}", "{".repeat(90), "^2}".repeat(90)),
        "10^{10^{10^{10}}}=1".to_owned(),
        "(".repeat(MOST_CHARACTERS),
        "|".repeat(MOST_CHARACTERS - 1),
        "-".repeat(MOST_CHARACTERS),
        r"\sqrt".repeat(400),
        r"\frac{1}{".repeat(200),
        "+x".repeat(MOST_CHARACTERS / 2),
    ];
    for claim in LEDGER.claims().iter().filter(|claim| matches!(claim.check, Check::Equation { .. })).step_by(9) {
        for characters in &hostile {
            let account = Account::for_characters(claim, characters).expect("short enough");
            assert_ne!(account.judged.verdict, Verdict::Reproduced, "{}: {characters:.60}", claim.id);
        }
    }
    let long = "9".repeat(MOST_CHARACTERS + 1);
    assert!(Account::for_characters(LEDGER.claims()[0], &long).is_err());
}
