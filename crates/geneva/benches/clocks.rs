//! The clocks that people feel: from the command to its last line, the program's start included.
//!
//! Each sample is a process of its own, for within one the verdicts are derived once and kept.

use divan::Bencher;
use std::process::{Command, Stdio};

fn main() {
    divan::main();
}

fn run(arguments: &[&str]) {
    let mut program = Command::new(env!("CARGO_BIN_EXE_geneva"));
    let status = program.args(arguments).stdout(Stdio::null()).status().expect("the program starts");
    assert!(status.success(), "{arguments:?}: {status}");
}

#[divan::bench(sample_count = 10)]
fn all_verdicts(bencher: Bencher) {
    bencher.bench(|| run(&["claims", "--format", "json"]));
}

#[divan::bench(sample_count = 10, args = ["pin", "quick-return", "jazar", "meyer", "wild"])]
fn verdicts_of(bencher: Bencher, source: &str) {
    bencher.bench(|| run(&["claims", "--source", source, "--format", "json"]));
}
