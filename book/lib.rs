//! The chapters of the book, and the document beside it that has an example, compiled and run as documentation tests; nothing
//! else.
//!
//! A test writes the list from that of the pages, which stands in the book builder.

macro_rules! chapters {
    ($($name:ident = $path:literal),+ $(,)?) => { $(#[cfg(doctest)] #[doc = include_str!($path)] pub mod $name {})+ };
}

#[cfg(doctest)]
#[doc = include_str!("../docs/solver.md")]
pub mod solver {}

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
    your_document = "src/your-document.md",
    proofread = "src/proofread.md",
    found = "src/found.md",
    errata = "src/errata.md",
    errata_elsewhere = "src/errata-elsewhere.md",
    open = "src/open.md",
    method = "src/method.md",
    about = "src/about.md",
    glossary = "src/glossary.md",
    ledger = "src/ledger.md",
    coverage = "src/coverage.md",
    mimic = "src/mimic.md",
}
