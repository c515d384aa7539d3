//! Does every claim still have its recorded verdict, and would a change be noticed?

use geneva_ledger::meyer::runs::data::inputs;
use geneva_ledger::{
    Check, Choice, Claim, Decimal, Decision, Erratum, Evidence, Finding, Judged, Kind, Number, Place, Reading, Route,
    Stated, Test, Truth, Verdict, Work, another, claim, claims, judge, looked_up_by, numbers_in, slips, verdicts,
};
use std::collections::{BTreeSet, HashSet};
use std::sync::{Arc, Mutex, OnceLock};

#[path = "verdicts/kinds.rs"]
mod kinds;

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
fn what_holds_for_all_cases_says_for_how_many_and_none_is_not_enough() {
    let even = |numbers: &[u32]| {
        let finding = Finding::for_all(numbers, |n| n % 2 == 0, |count, all| format!("{count} of {all}"));
        (finding.holds, finding.how)
    };
    assert_eq!(even(&[2, 4]), (true, "2 of 2".to_owned()));
    assert_eq!(even(&[2, 3, 4]), (false, "2 of 3".to_owned()));
    assert_eq!(even(&[]), (false, "0 of 0".to_owned()));
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
fn every_claim_says_what_and_where_and_what_is_missing_if_anything_is() {
    for claim in claims() {
        assert!(!claim.meaning.is_empty() && !claim.locator.is_empty() && !claim.printed.is_empty(), "{}", claim.id);
        if let Check::Missing { reason } = &claim.check {
            assert!(!reason.is_empty(), "{}", claim.id);
        }
    }
}

#[test]
fn an_erratum_says_what_why_and_who_else_says_so() {
    for claim in claims() {
        let Some(erratum) = &claim.erratum else { continue };
        assert_ne!(erratum.corrected, claim.printed, "{}: the correction changes nothing", claim.id);
        assert!(!erratum.slip.reason.is_empty() && !erratum.slip.witness.is_empty(), "{}", claim.id);
    }
}

#[test]
fn an_answer_is_a_claim_of_its_source() {
    for work in Work::ALL {
        for id in work.answers() {
            assert!(claim(id).is_some_and(|claim| claim.work == *work), "{work}: no claim {id} is an answer");
        }
    }
}

#[test]
fn a_conclusion_is_a_statement_of_its_source() {
    for work in Work::ALL {
        for (id, shown) in work.conclusions() {
            let found = claim(id).filter(|claim| claim.work == *work && claim.kind == Kind::Statement);
            assert!(found.is_some() && !shown.is_empty(), "{work}: no statement {id} is concluded");
        }
    }
}

#[test]
fn what_a_slip_does_is_not_contradicted_by_its_places() {
    let faults: Vec<_> = slips().iter().flat_map(|slip| slip.faults()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_statement_or_figure_has_a_neighbour_that_is_refused() {
    let sentence = |claim: &&Claim| matches!(claim.kind, Kind::Statement | Kind::Figure | Kind::Example);
    let without = |claim: &&Claim| !matches!(claim.check, Check::Statement { .. } | Check::Missing { .. });
    let ids: Vec<_> = claims().iter().filter(sentence).filter(without).map(|claim| claim.id).collect();
    assert!(ids.is_empty(), "{} without a neighbour: {}", ids.len(), ids.join(", "));
    for claim in claims() {
        if let Check::Statement { neighbour, .. } = claim.check {
            assert!(neighbour.is_none_or(|words| !words.is_empty() && words != claim.printed), "{}", claim.id);
        }
    }
}

#[test]
fn a_wrong_digit_in_a_number_is_noticed() {
    // The neighbouring digit in each place; in the last one of a reading the next that is out of its reach, on whichever
    // side of the printed number the computed one is.
    let mut tried = 0;
    for claim in claims().iter().filter(|claim| claim.kind == Kind::Value) {
        let Check::Number { resolution, .. } = &claim.check else { continue };
        let last = claim.printed.rfind(|c: char| c.is_ascii_digit());
        let unit = claim.printed.parse::<Decimal>().expect("a number").unit_in_last_place().to_f64_fast();
        for (at, digit) in claim.printed.char_indices().filter(|(_, c)| c.is_ascii_digit()) {
            let reach = resolution.as_ref().filter(|_| Some(at) == last).map_or(0.0, |run| run() / unit);
            let step = (2.0 * reach) as u32 + 1;
            assert!(step < 10, "{}: {step} digits are within reach", claim.id);
            let other = char::from_digit((digit.to_digit(10).expect("a digit") + step) % 10, 10).expect("a digit");
            let mut wrong = claim.printed.to_owned();
            wrong.replace_range(at..=at, &other.to_string());
            assert!(wrong.parse::<Decimal>().is_ok(), "{wrong}");
            let judged = judge(with_printed(claim, wrong.clone()));
            let noticed = judged.verdict != claim.expected || !judged.faults.is_empty();
            // A number that is corrected stays wrong with another digit: what must not happen is that it is accepted.
            let still_wrong = matches!(claim.expected, Verdict::Corrected | Verdict::NotReproduced);
            assert!(noticed || still_wrong, "{}: {wrong} went unnoticed", claim.id);
            tried += 1;
        }
    }
    assert!(tried > 500, "only {tried} digits were tried");
}

/// Sentences with a number that may be another, and why.
const NOT_TOLD: [(&str, &str); 4] = [
    ("meyer.steel", "steels differ by more than its last digit, as its reading says"),
    ("meyer.conclusion.the-three", "other pairs of pins and slots work as well, as the correction beside it says"),
    ("wild.openscad.cut", "sizes that somebody chose: wheels of other sizes clear the disc as well"),
    ("wild.cosmo.cut", "clearances that somebody chose: with larger ones the wheel clears the disc as well"),
];

#[test]
fn a_wrong_number_in_a_sentence_is_noticed() {
    // Each number that stands in a sentence, in digits or in words, becomes another; in a correction each in digits.
    let (mut tried, mut unnoticed, mut not_told) = (0, Vec::new(), HashSet::new());
    for claim in claims().iter().filter(|claim| matches!(claim.check, Check::Statement { .. })) {
        let right = claim.right_characters();
        for (at, _) in numbers_in(right) {
            if claim.erratum.is_some() && right[at.clone()].contains(|c: char| c.is_ascii_alphabetic()) {
                continue;
            }
            let mut wrong = right.to_owned();
            wrong.replace_range(at.clone(), &another(&right[at]));
            let other = match &claim.erratum {
                None => with_printed(claim, wrong.clone()),
                Some(erratum) => {
                    let erratum = Erratum { corrected: wrong.clone().leak(), ..*erratum };
                    Box::leak(Box::new(Claim { erratum: Some(erratum), ..claim.clone() }))
                }
            };
            let judged = judge(other);
            tried += 1;
            if judged.verdict != claim.expected || !judged.faults.is_empty() {
                continue;
            }
            if NOT_TOLD.iter().any(|(id, _)| *id == claim.id) {
                not_told.insert(claim.id);
            } else {
                unnoticed.push(format!("{}: {wrong}", claim.id));
            }
        }
    }
    assert!(unnoticed.is_empty(), "{} of {tried} went unnoticed:\n{}", unnoticed.len(), unnoticed.join("\n"));
    assert!(tried > 150, "only {tried} numbers were tried");
    for (id, _) in NOT_TOLD {
        assert!(not_told.contains(id), "{id}: each other number is noticed; the entry is not needed any more");
    }
}

#[test]
fn a_wrong_route_is_noticed() {
    // Each route of each claim in turn is replaced by one that gives something else; that of a statement also by one
    // that accepts everything.
    let leaked =
        |claim: &Claim, check: Check| -> &'static Claim { Box::leak(Box::new(Claim { check, ..claim.clone() })) };
    let number = |evidence: Evidence| Route { evidence, run: Arc::new(|| 0.123_456_789) as Arc<Number> };
    let fails =
        |evidence: Evidence| Route { evidence, run: Arc::new(|| Finding::new(false, "made to fail")) as Arc<Test> };
    let decides = |evidence: Evidence| {
        [false, true].map(|holds| {
            let run: Arc<Choice> = Arc::new(move |_| Finding::new(holds, "made up"));
            Route { evidence, run }
        })
    };
    for claim in claims() {
        let mut broken = Vec::new();
        match remembered(claim.check.clone()) {
            Check::Number { computed, witness, from_rounded, resolution, right } => {
                let with = |computed: &Route<Number>, witness: &Route<Number>, right| {
                    let [computed, witness] = [computed, witness].map(Route::clone);
                    let (from_rounded, resolution) = (from_rounded.clone(), resolution.clone());
                    Check::Number { computed, witness, from_rounded, resolution, right }
                };
                broken.push(with(&number(computed.evidence), &witness, right.clone()));
                broken.push(with(&computed, &number(witness.evidence), right.clone()));
                if let Some([one, other]) = right {
                    broken.push(with(&computed, &witness, Some([number(one.evidence), other.clone()])));
                    broken.push(with(&computed, &witness, Some([one, number(other.evidence)])));
                }
            }
            Check::Equation { first, witness, said, also } => {
                let with = |first: &Route<Decision>, witness: &Route<Reading>, also: Option<Route<Test>>| {
                    Check::Equation { first: first.clone(), witness: witness.clone(), said, also }
                };
                let refuses: Arc<Decision> = Arc::new(|_| Finding::new(false, "made to fail"));
                let reads_wrong: Arc<Reading> = Arc::new(|_| Some(false));
                broken.push(with(&Route { evidence: first.evidence, run: refuses }, &witness, also.clone()));
                broken.push(with(&first, &Route { evidence: witness.evidence, run: reads_wrong }, also.clone()));
                broken.extend(also.map(|also| with(&first, &witness, Some(fails(also.evidence)))));
            }
            Check::Statement { first, witness, neighbour } => {
                let with = |first: &Route<Choice>, witness: &Route<Choice>| {
                    let [first, witness] = [first, witness].map(Route::clone);
                    Check::Statement { first, witness, neighbour }
                };
                broken.extend(decides(first.evidence).iter().map(|route| with(route, &witness)));
                broken.extend(decides(witness.evidence).iter().map(|route| with(&first, route)));
            }
            Check::Missing { .. } => {}
        }
        for check in broken {
            let judged = judge(leaked(claim, check.clone()));
            assert!(!judged.holds(), "{} stands with a wrong route: {check:?}", claim.id);
        }
    }
}

/// What spoils a formula: a name that stands for nothing, a brace too many or too few, nothing at all, a division by zero.
fn spoils(formula: &str) -> [String; 6] {
    let sides = |left: &str, right: &str| format!("{left} = {right}");
    [
        sides(r"\zeta", formula),
        format!("{formula}{{"),
        format!("}}{formula}"),
        String::new(),
        sides(formula, r"\frac{1}{0}"),
        sides(formula, r"\frac{1}{1 - 1}"),
    ]
}

#[test]
fn a_formula_that_cannot_be_evaluated_is_a_fault_of_its_own_claim_and_ends_nothing() {
    let (mut not_evaluated, mut judged) = (0, 0);
    for claim in claims() {
        let Check::Equation { first: decide, witness, .. } = &claim.check else { continue };
        let mut first = true;
        for spoiled in spoils(claim.right_characters()) {
            assert_ne!((witness.run)(&spoiled), Some(true), "{}: {spoiled}", claim.id);
            let finding = (decide.run)(&spoiled);
            assert!(!finding.holds, "{}: {spoiled}", claim.id);
            // A line of a longer display may be empty, and the display is only false then.
            if finding.evaluated {
                continue;
            }
            not_evaluated += 1;
            if std::mem::take(&mut first) {
                let found = judge(with_printed(claim, spoiled.clone()));
                assert!(!found.holds() && !has_stopped(&found), "{}: {spoiled}: {:?}", claim.id, found.faults);
                judged += 1;
            }
        }
    }
    assert!(not_evaluated > 300 && judged > 50, "{not_evaluated} were not evaluated, {judged} judged");
}

#[test]
fn no_characters_end_the_program() {
    // What a check cannot deal with is a fault of its claim: the judge comes back, for whatever is printed.
    let many = ["", "0", "-", "4,", "1/0", r"\frac{}{0} = ^", "999999999999999999999", "1.5708, 1.0472 and one"];
    let mut stopped = 0;
    for claim in claims() {
        let claim = Claim { check: remembered(claim.check.clone()), ..claim.clone() };
        // A statement without numbers has no characters to read. What takes the first for one meets too few or too many.
        let reads = !matches!(claim.check, Check::Statement { .. }) || !numbers_in(claim.printed).is_empty();
        for printed in if reads { &many[..] } else { &many[6..] } {
            let judged = judge(with_printed(&claim, (*printed).to_owned()));
            stopped += usize::from(has_stopped(&judged));
            assert!(!has_stopped(&judged) || !judged.holds(), "{}: {printed}", claim.id);
        }
    }
    println!("{stopped} checks stopped");
}

#[test]
fn a_check_that_stops_is_a_fault_of_its_own_claim() {
    let stopping = Place::new(Work::Pin, "nowhere")
        .value("made-up", "1", "", "a number")
        .by(Evidence::ClosedForm, || panic!("made to stop"))
        .by(Evidence::Jet, || 1.0);
    let judged = judge(Box::leak(Box::new(stopping)));
    assert_eq!(judged.faults, ["the check stopped: made to stop"]);
    assert!(!judged.holds());
}

fn has_stopped(judged: &Judged) -> bool {
    judged.faults.iter().any(|fault| fault.starts_with("the check stopped"))
}

/// The check with routes that run once for the same characters: only those of a statement are told them.
fn remembered(check: Check) -> Check {
    fn number(run: Arc<Number>) -> Arc<Number> {
        let found = OnceLock::new();
        Arc::new(move || *found.get_or_init(|| run()))
    }
    fn test(run: Arc<Test>) -> Arc<Test> {
        let found = OnceLock::new();
        Arc::new(move || Finding::clone(found.get_or_init(|| run())))
    }
    fn choice(run: Arc<Choice>) -> Arc<Choice> {
        let found = Mutex::new(Vec::<(Stated, Finding)>::new());
        Arc::new(move |stated| {
            let known =
                |all: &[(Stated, Finding)]| all.iter().find(|(of, _)| *of == stated).map(|(_, found)| found.clone());
            if let Some(finding) = known(&found.lock().expect("no route stops while it is locked")) {
                return finding;
            }
            let finding = run(stated);
            found.lock().expect("no route stops while it is locked").push((stated, finding.clone()));
            finding
        })
    }
    fn route<R: ?Sized>(Route { evidence, run }: Route<R>, remember: fn(Arc<R>) -> Arc<R>) -> Route<R> {
        Route { evidence, run: remember(run) }
    }
    match check {
        Check::Number { computed, witness, from_rounded, resolution, right } => Check::Number {
            computed: route(computed, number),
            witness: route(witness, number),
            from_rounded: from_rounded.map(number),
            resolution: resolution.map(number),
            right: right.map(|both| both.map(|one| route(one, number))),
        },
        Check::Equation { first, witness, said, also } => {
            Check::Equation { first, witness, said, also: also.map(|also| route(also, test)) }
        }
        Check::Statement { first, witness, neighbour } => {
            Check::Statement { first: route(first, choice), witness: route(witness, choice), neighbour }
        }
        Check::Missing { reason } => Check::Missing { reason },
    }
}

fn with_printed(claim: &Claim, printed: String) -> &'static Claim {
    Box::leak(Box::new(Claim { printed: printed.leak(), ..claim.clone() }))
}

/// The evidence of the two routes of a claim, with the ids of the claims that each looks up; of the routes to the right number,
/// if the others follow a slip. None if there are no routes.
fn what_routes_rest_on(claim: &Claim) -> Option<[(Evidence, BTreeSet<&'static str>); 2]> {
    let stated = Stated::right(claim.right_characters());
    Some(match &claim.check {
        Check::Number { right: Some(routes), .. } => {
            routes.each_ref().map(|route| (route.evidence, looked_up_by(|| (route.run)()).1))
        }
        Check::Number { computed, witness, .. } => {
            [computed, witness].map(|route| (route.evidence, looked_up_by(|| (route.run)()).1))
        }
        Check::Equation { first, .. } => {
            let kinds = claim.check.evidence();
            [
                (kinds[0], looked_up_by(|| (first.run)(claim.printed)).1),
                (kinds[1], looked_up_by(|| claim.witnessed()).1),
            ]
        }
        Check::Statement { first, witness, .. } => {
            [first, witness].map(|route| (route.evidence, looked_up_by(|| (route.run)(stated)).1))
        }
        Check::Missing { .. } => return None,
    })
}

/// Claims with their routes, each by its evidence and the claims that it looks up.
type Routes<'a> = Vec<(&'a str, [(Evidence, BTreeSet<&'a str>); 2])>;

/// The claims that rest on nothing but each other. What is computed is a ground to rest on. A route that only compares with other
/// places of the source is one if a claim of one of these places has a ground.
fn in_circles<'a>(routes: &Routes<'a>) -> Vec<&'a str> {
    let mut grounded: HashSet<&str> = HashSet::new();
    loop {
        let before = grounded.len();
        for (id, routes) in routes {
            let ground = |(evidence, ids): &(Evidence, BTreeSet<&str>)| {
                *evidence != Evidence::OtherPlaceInSource
                    || ids.is_empty()
                    || ids.iter().any(|other| other != id && grounded.contains(other))
            };
            if routes.iter().any(ground) {
                grounded.insert(id);
            }
        }
        if grounded.len() == before {
            return routes.iter().map(|(id, _)| *id).filter(|id| !grounded.contains(id)).collect();
        }
    }
}

#[test]
fn no_claims_rest_on_nothing_but_each_other() {
    let (compares, on) = (Evidence::OtherPlaceInSource, |id| BTreeSet::from([id]));
    let computed = ("computed", [(Evidence::Vectors, on("first")), (compares, on("first"))]);
    let two = |first| {
        vec![
            ("first", [(compares, on(first)), (compares, on("second"))]),
            ("second", [(compares, on("first")), (compares, on("second"))]),
        ]
    };
    assert_eq!(in_circles(&two("second")), ["first", "second"]);
    let mut three = two("computed");
    three.push(computed);
    assert!(in_circles(&three).is_empty());

    let routes = claims().iter().filter_map(|claim| Some((claim.id, what_routes_rest_on(claim)?))).collect();
    let circles = in_circles(&routes);
    assert!(circles.is_empty(), "in circles: {}", circles.join(", "));
}

#[test]
fn the_routes_of_a_value_share_no_printed_result() {
    let given: HashSet<String> = claims()
        .iter()
        .filter(|claim| claim.check.evidence() == [Evidence::OtherPlaceInSource; 2])
        .map(|claim| claim.id.to_owned())
        .chain(inputs())
        .collect();
    let mut shared = Vec::new();
    for claim in claims().iter().filter(|claim| claim.kind == Kind::Value && !given.contains(claim.id)) {
        let Some([(_, one), (_, other)]) = what_routes_rest_on(claim) else { continue };
        for id in one.intersection(&other).filter(|id| !given.contains(**id)) {
            shared.push(format!("{}: {id}", claim.id));
        }
    }
    assert!(shared.is_empty(), "{}", shared.join("\n"));
}
