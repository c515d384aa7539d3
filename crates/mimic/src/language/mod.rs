//! The simulation language MIMIC: a deck of cards is read, sorted, compiled and run.
//!
//! No implementation and no manual of MIMIC are at hand. What is known comes from the program and the text of
//! MEYER, Appendix B, and from one other deck, the predators and prey of an encyclopedia
//! (<https://en.wikipedia.org/wiki/MIMIC>). Whatever goes beyond these two is assumed: the tables
//! [`FUNCTIONS`] and [`CARDS`] say of each word where it comes from, and what is open in the running of a deck is a
//! field of [`RunOptions`].
//!
//! ```
//! use geneva_mimic::language::{CardLayout, Deck, Program, RunOptions};
//!
//! let deck = Deck::read(
//!     "* a spring and a damper
//!      PAR(C,K)
//!      DT     .5
//!      2DX    -(C*1DX+K*X)
//!      1DX    INT(2DX,0.)
//!      X      INT(1DX,1.)
//!      FIN(T,2.)
//!      OUT(T,X)
//!      END
//!      .5 4.
//!      0. 4.",
//!     CardLayout::Free,
//! )?;
//! let program = Program::new(&deck)?;
//! let runs = program.runs(&deck.data_sets()?, &RunOptions::default())?;
//! assert_eq!(runs[1].columns, ["T", "X"]);
//! let last = &runs[1].rows[4];
//! assert!((last[1] - libm::cos(2.0 * last[0])).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! From deck to run, a file for each step: `card` parts the text into cards and these into fields, `token` and
//! `expression` read what stands in them, `reading` puts it together as a `tree`, `graph`, `known` and `sorting` find the
//! order and what is known before, `types` tells numbers from truths, `compile` makes a `program` of flat `code`, `run` and
//! `machine` integrate it, and `printout` is what the line printer wrote.

mod card;
mod code;
mod compile;
mod control;
mod data;
mod deck;
mod diagnostic;
mod digits;
mod expression;
mod function;
mod graph;
mod known;
mod machine;
mod origin;
mod printout;
mod program;
mod reading;
mod run;
mod sorting;
mod token;
mod tree;
mod trouble;
mod types;

pub use card::CardLayout;
pub use control::{CARDS, Card};
pub use data::DataSet;
pub use deck::listing_in;
pub use diagnostic::{Diagnostic, Diagnostics, Problem, nearest_to};
pub use function::{BuiltinFunction, FUNCTIONS, WordEvidence};
pub use printout::{line_plot, print_out};
pub use program::Program;
pub use run::{DeckRun, DeckRuns, Plot, RememberedPoints, RunOptions};
pub use sorting::{Schedule, SortedStatement};
pub use tree::Deck;
pub use trouble::{FaultOrigin, RunError, Trouble};

/// The decks of this project, each under its name.
pub const DECKS: [(&str, &str); 9] = [
    ("escapement", include_str!("../../decks/escapement.mim")),
    ("oscillator", include_str!("../../decks/oscillator.mim")),
    ("misprinted", include_str!("../../decks/misprinted.mim")),
    ("decay", include_str!("../../decks/decay.mim")),
    ("predators", include_str!("../../decks/predators.mim")),
    ("switch", include_str!("../../decks/switch.mim")),
    ("thermostat", include_str!("../../decks/thermostat.mim")),
    ("delayed", include_str!("../../decks/delayed.mim")),
    ("vanderpol", include_str!("../../decks/vanderpol.mim")),
];

/// The text of a deck of this project.
///
/// ```
/// use geneva_mimic::language::{CardLayout, Deck, deck_named};
///
/// let text = deck_named("decay").expect("a deck of this project");
/// assert!(Deck::read(text, CardLayout::Free).is_ok());
/// assert_eq!(deck_named("growth"), None);
/// ```
pub fn deck_named(name: &str) -> Option<&'static str> {
    DECKS.iter().find(|(of, _)| *of == name).map(|(_, text)| *text)
}
