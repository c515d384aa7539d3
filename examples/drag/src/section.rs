//! The section as a document, and what its claims have in common.

use crate::letters::States;
use crate::reader;
use crate::steps::{gauss, simpson};
use geneva_evidence::{Cache, Claim, Document, Finding, InventoryFile, Locator, ROUTES, Stated, Symbol};

/// The section.
pub static SECTION: Document = Document {
    slug: "drag",
    title: "section",
    citation: "Drag Force and Terminal Speed, a section of University Physics Volume 1, OpenStax, as of September 2022, CC BY 4.0",
    inventory: Some(InventoryFile {
        path: "examples/drag/section.inventory",
        text: include_str!("../section.inventory"),
    }),
    claims: crate::claims::all,
    answers: crate::claims::ANSWERS,
    given: Vec::new,
    conclusions: &[],
    symbols: &[
        Symbol { printed: "F_D", ours: "F_D", meaning: "drag force" },
        Symbol { printed: "C", ours: "C", meaning: "drag coefficient" },
        Symbol { printed: "ρ", ours: r"\rho", meaning: "density of the fluid" },
        Symbol { printed: "A", ours: "A", meaning: "area that faces the fluid" },
        Symbol { printed: "v_T", ours: "v_T", meaning: "terminal speed" },
        Symbol { printed: "b", ours: "b", meaning: "factor between drag and speed, or between drag and its square" },
        Symbol { printed: "η", ours: r"\eta", meaning: "viscosity" },
    ],
    units: crate::claims::UNITS,
    test: "cargo test -p geneva-example-drag",
    cache: Cache::new(),
};

/// Acceleration of a falling body that the section computes with, in m/s².
pub(crate) const GRAVITY: f64 = 9.80;
/// Density of air that the section assumes, in kg/m³.
pub(crate) const AIR: f64 = 1.21;

/// A place in the section.
pub(crate) const fn at(line: &'static str) -> Locator {
    Locator::new(&SECTION, line)
}

/// The number that a claim of the section prints.
pub(crate) fn printed(id: &str) -> f64 {
    SECTION.printed_number(id)
}

/// An equation whose characters are read in states from two places.
#[track_caller]
pub(crate) fn law(
    line: &'static str,
    id: &'static str,
    printed: &'static str,
    meaning: &'static str,
    states: &'static States,
) -> Claim {
    at(line)
        .equation(id, printed, meaning)
        .evaluated(states.kinds[0], |tex| {
            Finding::of_reading(reader::holds(tex, &states.first, |ends, curve| gauss(ends, curve)))
        })
        .read(states.kinds[1], |tex| reader::holds(tex, &states.second, |ends, curve| simpson(ends, curve)))
}

/// Whether two numbers are equal, as far as arithmetic goes.
pub(crate) fn is_near(one: f64, other: f64) -> bool {
    ROUTES.agrees(one, other)
}

/// Whether the numbers of a sentence are these, each rounded to so many digits that count.
pub(crate) fn rounds(stated: Stated<'_>, values: &[(f64, i32)]) -> bool {
    let numbers = stated.numbers();
    numbers.len() == values.len()
        && numbers.iter().zip(values).all(|(number, (value, digits))| is_near(*number, to_digits(*value, *digits)))
}

/// A positive number rounded to so many digits that count.
pub(crate) fn to_digits(value: f64, digits: i32) -> f64 {
    let unit = libm::pow(10.0, libm::floor(libm::log10(value)) + 1.0 - f64::from(digits));
    libm::round(value / unit) * unit
}

/// Sine and cosine of an angle in degrees.
pub(crate) fn turned(degrees: f64) -> [f64; 2] {
    let angle = degrees.to_radians();
    [libm::sin(angle), libm::cos(angle)]
}
