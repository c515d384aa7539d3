//! The chapters of the book, each compiled and run as documentation tests; nothing else.

macro_rules! chapters {
    ($($name:ident = $path:literal),+ $(,)?) => {
        $(#[cfg(doctest)] #[doc = include_str!($path)] pub mod $name {})+

        /// The chapters' files, beside this one; a test compares them with the book's table of contents.
        pub const CHAPTERS: &[&str] = &[$($path),+];
    };
}

chapters! {
    preface = "src/preface.md",
    pin = "src/pin.md",
    quick_return = "src/quick-return.md",
    jazar = "src/jazar.md",
    errata = "src/errata.md",
    ledger = "src/ledger.md",
    coverage = "src/coverage.md",
    house = "src/house.md",
}
