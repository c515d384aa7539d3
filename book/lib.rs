//! The chapters of the book, each compiled and run as documentation tests; nothing else.
//!
//! A test writes the list from that of the pages, which stands in the book builder.

macro_rules! chapters {
    ($($name:ident = $path:literal),+ $(,)?) => { $(#[cfg(doctest)] #[doc = include_str!($path)] pub mod $name {})+ };
}

chapters! {
    preface = "src/preface.md",
    pin = "src/pin.md",
    jazar = "src/jazar.md",
    making = "src/making.md",
    quick_return = "src/quick-return.md",
    escapement = "src/escapement.md",
    program = "src/program.md",
    runs = "src/runs.md",
    mistake = "src/mistake.md",
    never_printed = "src/never-printed.md",
    terminal_speed = "src/terminal-speed.md",
    timer = "src/timer.md",
    joints = "src/joints.md",
    wild = "src/wild.md",
    errata = "src/errata.md",
    errata_small = "src/errata-small.md",
    errata_copy = "src/errata-copy.md",
    method = "src/method.md",
    ledger = "src/ledger.md",
    ledger_jazar = "src/ledger-jazar.md",
    ledger_meyer = "src/ledger-meyer.md",
    ledger_meyer_motion = "src/ledger-meyer-motion.md",
    ledger_meyer_study = "src/ledger-meyer-study.md",
    ledger_meyer_program = "src/ledger-meyer-program.md",
    ledger_meyer_runs = "src/ledger-meyer-runs.md",
    ledger_meyer_more_runs = "src/ledger-meyer-more-runs.md",
    ledger_wild = "src/ledger-wild.md",
    ledger_wild_parts = "src/ledger-wild-parts.md",
    coverage = "src/coverage.md",
    coverage_meyer = "src/coverage-meyer.md",
    about = "src/about.md",
    glossary = "src/glossary.md",
    solver = "src/solver.md",
    mimic = "src/mimic.md",
    architecture = "src/architecture.md",
}
