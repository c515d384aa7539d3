//! Work and nesting are bounded by the length of a text, whatever its structure.

use crate::structures::{self, Structure};
use proofread::{Options, proofread};

/// The steps that a text takes. The search for hints has a bound of its own.
fn steps(text: &str, (name, format, _): &Structure) -> u64 {
    let options = Options { hint_effort: 20_000, ..Options::default() };
    match proofread(text, *format, options) {
        Ok(report) => report.effort.steps,
        Err(why) => {
            assert_eq!(*name, "lists in each other", "{why}");
            0
        }
    }
}

#[test]
fn four_times_the_text_is_less_than_six_times_the_work() {
    // What is done once for any text, such as the search for hints, counts as a few hundred tokens.
    const ONCE: u64 = 40_000;
    let mut over = Vec::new();
    for structure in structures::all() {
        let (name, format, grown) = &structure;
        let sizes = [3_000, 12_000, 48_000].map(|size| steps(&grown(size), &structure));
        for pair in sizes.windows(2) {
            if pair[1] >= 6 * pair[0].max(ONCE) {
                over.push(format!("{format:?}, {name}: {sizes:?} steps for four times the text each"));
            }
        }
    }
    assert!(over.is_empty(), "{}", over.join("\n"));
}
