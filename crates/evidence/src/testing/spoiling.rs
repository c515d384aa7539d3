//! What is spoilt: digits, numbers in sentences, routes, formulas.

use super::{Guarded, Report};
use crate::account::with_next_digit;
use crate::{
    Check, ChoiceFn, Claim, Decimal, DecisionFn, Erratum, Evidence, Finding, Judged, Kind, Locator, NumberFn,
    ReadingFn, Route, Stated, TestFn, Verdict, another, judge, judge_characters, numbers_in,
};
use std::collections::{HashMap, HashSet};
use std::panic::resume_unwind;
use std::sync::{Arc, Mutex, OnceLock};

/// The statements, figures and examples without a neighbour that their routes must refuse, or with one that says nothing.
pub fn statement_neighbours(guarded: Guarded) -> Report {
    let sentence = |claim: &&&Claim| matches!(claim.kind, Kind::Statement | Kind::Figure | Kind::Example);
    let (mut tried, mut faults) = (0, Vec::new());
    for claim in guarded.ledger.claims().iter().filter(sentence) {
        tried += 1;
        match claim.check {
            Check::Missing { .. } => {}
            Check::Statement { neighbour, .. } => {
                if neighbour.is_some_and(|words| words.is_empty() || words == claim.printed) {
                    faults.push(format!("{}: the neighbour is what is printed, or nothing", claim.id));
                }
            }
            _ => faults.push(format!("{} has no neighbour", claim.id)),
        }
    }
    Report::new(tried, faults)
}

/// The printed numbers in which another digit goes unnoticed. In each place the neighbouring digit is tried; in the last one
/// of a reading the next that is out of its reach, on whichever side of the printed number the computed one is.
pub fn wrong_digits(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for claim in guarded.ledger.claims().iter().filter(|claim| claim.kind == Kind::Value) {
        let Check::Number { resolution, .. } = &claim.check else { continue };
        let last = claim.printed.rfind(|c: char| c.is_ascii_digit());
        let Ok(printed) = claim.printed.parse::<Decimal>() else {
            faults.push(format!("{}: {} is no number", claim.id, claim.printed));
            continue;
        };
        let unit = printed.unit_in_last_place().to_f64_fast();
        for (at, _) in claim.printed.char_indices().filter(|(_, c)| c.is_ascii_digit()) {
            let reach = resolution.as_ref().filter(|_| Some(at) == last).map_or(0.0, |run| run() / unit);
            let Some(wrong) = with_next_digit(claim.printed, at, (2.0 * reach) as u32 + 1) else {
                faults.push(format!("{}: every digit is within reach, {reach} units", claim.id));
                continue;
            };
            let judged = judge_characters(claim, wrong.clone().into());
            // A number that is corrected stays wrong with another digit: what must not happen is that it is accepted.
            let still_wrong = matches!(claim.expected, Verdict::Corrected | Verdict::NotReproduced);
            if !is_noticed(&judged) && !still_wrong {
                faults.push(format!("{}: {wrong} went unnoticed", claim.id));
            }
            tried += 1;
        }
    }
    Report::new(tried, faults)
}

/// The sentences in which another number goes unnoticed. Each number that stands in a sentence, in digits or in words, becomes
/// another; in a correction each in digits.
pub fn other_numbers_in_sentences(guarded: Guarded) -> Report {
    let (mut tried, mut faults, mut free) = (0, Vec::new(), HashSet::new());
    for claim in guarded.ledger.claims().iter().filter(|claim| matches!(claim.check, Check::Statement { .. })) {
        let right = claim.right_characters();
        for (at, _) in numbers_in(right) {
            if claim.erratum.is_some() && right[at.clone()].contains(|c: char| c.is_ascii_alphabetic()) {
                continue;
            }
            let mut wrong = right.to_owned();
            wrong.replace_range(at.clone(), &another(&right[at]));
            let judged = match &claim.erratum {
                None => judge_characters(claim, wrong.clone().into()),
                Some(erratum) => {
                    let erratum = Erratum { corrected: wrong.clone().leak(), ..*erratum };
                    judge(Box::leak(Box::new(Claim { erratum: Some(erratum), ..Claim::clone(claim) })))
                }
            };
            tried += 1;
            if is_noticed(&judged) {
                continue;
            }
            if guarded.free_numbers.iter().any(|(id, _)| *id == claim.id) {
                free.insert(claim.id);
            } else {
                faults.push(format!("{}: {wrong} went unnoticed", claim.id));
            }
        }
    }
    let needless = guarded.free_numbers.iter().filter(|(id, _)| !free.contains(id));
    faults.extend(needless.map(|(id, _)| format!("{id}: each other number is noticed; the exception is not needed")));
    Report::new(tried, faults)
}

/// The claims that agree with their record with a wrong route. Each route in turn is replaced by one that gives something else;
/// that of a statement also by one that accepts everything.
pub fn wrong_routes(guarded: Guarded) -> Report {
    let number = |evidence| Route::new(evidence, Arc::new(|| 0.123_456_789) as Arc<NumberFn>);
    let fails = |evidence| Route::new(evidence, Arc::new(|| Finding::new(false, "made to fail")) as Arc<TestFn>);
    let decides = |evidence: &'static Evidence| {
        [false, true].map(|holds| {
            let run: Arc<ChoiceFn> = Arc::new(move |_| Finding::new(holds, "made up"));
            Route::new(evidence, run)
        })
    };
    let (mut tried, mut faults) = (0, Vec::new());
    for claim in guarded.ledger.claims() {
        let mut broken = Vec::new();
        match remembered(claim.check.clone()) {
            Check::Number { computed, witness, from_rounded, resolution, right } => {
                let with = |computed: &Route<NumberFn>, witness: &Route<NumberFn>, right| {
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
                let with = |first: &Route<DecisionFn>, witness: &Route<ReadingFn>, also: Option<Route<TestFn>>| {
                    Check::Equation { first: first.clone(), witness: witness.clone(), said, also }
                };
                let refuses: Arc<DecisionFn> = Arc::new(|_| Finding::new(false, "made to fail"));
                let reads_wrong: Arc<ReadingFn> = Arc::new(|_| Some(false));
                broken.push(with(&Route::new(first.evidence, refuses), &witness, also.clone()));
                broken.push(with(&first, &Route::new(witness.evidence, reads_wrong), also.clone()));
                broken.extend(also.map(|also| with(&first, &witness, Some(fails(also.evidence)))));
            }
            Check::Statement { first, witness, neighbour } => {
                let with = |first: &Route<ChoiceFn>, witness: &Route<ChoiceFn>| {
                    let [first, witness] = [first, witness].map(Route::clone);
                    Check::Statement { first, witness, neighbour }
                };
                broken.extend(decides(first.evidence).iter().map(|route| with(route, &witness)));
                broken.extend(decides(witness.evidence).iter().map(|route| with(&first, route)));
            }
            Check::Missing { .. } => {}
        }
        for check in broken {
            tried += 1;
            let spoilt = Claim { check: check.clone(), ..Claim::clone(claim) };
            if judge(Box::leak(Box::new(spoilt))).matches_record() {
                faults.push(format!("{} agrees with its record with a wrong route: {check:?}", claim.id));
            }
        }
    }
    Report::new(tried, faults)
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

/// The spoilt formulas that are accepted or that stop the judge. What cannot be evaluated is neither right nor wrong. The places
/// counted are the formulas that could not be evaluated.
pub fn spoilt_formulas(guarded: Guarded) -> Report {
    let (mut not_evaluated, mut faults) = (0, Vec::new());
    for claim in guarded.ledger.claims() {
        let Check::Equation { first: decide, witness, .. } = &claim.check else { continue };
        let mut first = true;
        for spoilt in spoils(claim.right_characters()) {
            let finding = (decide.run)(&spoilt);
            if finding.holds || (witness.run)(&spoilt) == Some(true) {
                faults.push(format!("{} accepts {spoilt}", claim.id));
            }
            // A line of a longer display may be empty, and the display is only false then.
            if finding.evaluated {
                continue;
            }
            not_evaluated += 1;
            if std::mem::take(&mut first) {
                let judged = judge_characters(claim, spoilt.clone().into());
                if judged.matches_record() || has_stopped(&judged) {
                    faults.push(format!("{}: {spoilt}: {:?}", claim.id, judged.faults));
                }
            }
        }
    }
    Report::new(not_evaluated, faults)
}

/// The characters with which a check stops. The judge comes back, whatever is printed.
pub fn endless_characters(guarded: Guarded) -> Report {
    const MANY: [&str; 8] =
        ["", "0", "-", "4,", "1/0", r"\frac{}{0} = ^", "999999999999999999999", "1.5708, 1.0472 and one"];
    let (mut tried, mut faults) = (0, Vec::new());
    for claim in guarded.ledger.claims() {
        let check = remembered(claim.check.clone());
        let claim: &'static Claim = Box::leak(Box::new(Claim { check, ..Claim::clone(claim) }));
        // A statement without numbers has no characters to read. What takes the first for one meets too few or too many.
        let reads = !matches!(claim.check, Check::Statement { .. }) || !numbers_in(claim.printed).is_empty();
        for printed in if reads { &MANY[..] } else { &MANY[6..] } {
            tried += 1;
            // Where there is no unwinding, as in a page, a check that stops ends the program.
            if has_stopped(&judge_characters(claim, (*printed).into())) {
                faults.push(format!("{}: {printed}", claim.id));
            }
        }
    }
    Report::new(tried, faults)
}

/// Whether a check that panics is no fault of its own claim, for each document.
pub fn stopped_checks(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for document in guarded.ledger.documents() {
        tried += 1;
        let stopping = Locator::new(document, "nowhere")
            .value("made-up", "1", "", "a number")
            .first_route(Evidence::CLOSED_FORM, || resume_unwind(Box::new("made to stop")))
            .second_route(Evidence::JET, || 1.0);
        let judged = judge(Box::leak(Box::new(stopping)));
        if judged.faults != ["the check stopped: made to stop"] || judged.matches_record() {
            faults.push(format!("{document}: {:?}", judged.faults));
        }
    }
    Report::new(tried, faults)
}

fn is_noticed(judged: &Judged) -> bool {
    judged.verdict != judged.claim.expected || !judged.faults.is_empty()
}

fn has_stopped(judged: &Judged) -> bool {
    judged.faults.iter().any(|fault| fault.starts_with("the check stopped"))
}

/// The check with routes that run once for the same characters: only those of a statement are told them.
fn remembered(check: Check) -> Check {
    fn number(run: Arc<NumberFn>) -> Arc<NumberFn> {
        let found = OnceLock::new();
        Arc::new(move || *found.get_or_init(|| run()))
    }
    fn test(run: Arc<TestFn>) -> Arc<TestFn> {
        let found = OnceLock::new();
        Arc::new(move || Finding::clone(found.get_or_init(|| run())))
    }
    fn choice(run: Arc<ChoiceFn>) -> Arc<ChoiceFn> {
        // A route that stops while the list is locked does not harm it.
        let found = Mutex::new(HashMap::<(bool, String), Finding>::new());
        Arc::new(move |stated: Stated<'_>| {
            let key = (stated.pick(true, false), stated.characters().to_owned());
            if let Some(finding) = found.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).get(&key) {
                return finding.clone();
            }
            let finding = run(stated);
            found.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).insert(key, finding.clone());
            finding
        })
    }
    fn route<R: ?Sized>(Route { evidence, run, stated_at }: Route<R>, remember: fn(Arc<R>) -> Arc<R>) -> Route<R> {
        Route { evidence, run: remember(run), stated_at }
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
