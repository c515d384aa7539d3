//! Work and nesting are bounded by the length of a text, whatever its structure.

use crate::structures::{self, Structure};
use proofread::{CheckOptions, TextFormat, proofread};

/// The steps that a text takes. The search for hints has a bound of its own.
fn steps(text: &str, (name, format, _): &Structure) -> u64 {
    let options = CheckOptions { hint_effort: 20_000, ..CheckOptions::default() };
    match proofread(text, *format, options) {
        Ok(report) => report.effort.steps,
        Err(why) => {
            assert_eq!(*name, "lists in each other", "{why}");
            0
        }
    }
}

/// Bytes of the shorter of two texts, how often as long the other one is, and below how often as much its work must be: the shorter one
/// has less around each formula than is looked at.
const SHORT: usize = 2_000;
const TIMES: usize = 8;
const WORK: u64 = 16;

/// Grows every second structure, from this one on.
fn grow_every_second(first: usize) {
    // What is done once for any text, such as the search for hints, counts as a few hundred tokens.
    const ONCE: u64 = 40_000;
    // Short formulas take most: what stands around each is searched for words, and a macro may stand for ten times as much.
    const MOST_FOR_A_BYTE: u64 = 350;
    let mut over = Vec::new();
    for structure in structures::all().into_iter().skip(first).step_by(2) {
        let (name, format, grown) = &structure;
        let [short, long] = [SHORT, TIMES * SHORT].map(|size| steps(&grown(size), &structure));
        let bytes = (TIMES * SHORT) as u64;
        if long > ONCE + MOST_FOR_A_BYTE * bytes {
            over.push(format!("{format:?}, {name}: {} steps for each byte", long / bytes));
        }
        if long >= WORK * short.max(ONCE) {
            over.push(format!("{format:?}, {name}: {short} and {long} steps for {TIMES} times the text"));
        }
    }
    assert!(over.is_empty(), "{}", over.join("\n"));
}

// In two halves, which run side by side.
#[test]
fn eight_times_the_text_is_less_than_sixteen_times_the_work() {
    grow_every_second(0);
}

#[test]
fn eight_times_the_text_is_less_than_sixteen_times_the_work_in_other_structures() {
    grow_every_second(1);
}

#[test]
fn a_search_for_hints_costs_little_and_nothing_for_long_sides() {
    let effort = |text: &str| {
        let report = proofread(text, TextFormat::Markdown, CheckOptions::default()).expect("it can be read");
        assert_eq!(report.findings.len(), 1, "{}", &text[..20]);
        report.effort
    };
    let sum = |terms: usize| effort(&format!("${}1=3$", "1.1+".repeat(terms)));
    assert!(sum(20).hints > 0);
    for terms in [250, 1000, 2900] {
        let found = sum(terms);
        assert!(found.hints == 0 && found.steps < 400 * terms as u64, "{terms}: {found:?}");
    }
    // An edit is judged under a few readings, and made when it is tried.
    let searched = sum(60);
    assert!(searched.steps < 30 * searched.hints as u64, "{searched:?}");
}
