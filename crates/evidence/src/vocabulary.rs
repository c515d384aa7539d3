//! What the letters of a source stand for, once for every check of its equations.

use crate::Evidence;
use crate::tex::{Exact, Moment};
use std::panic::Location;

/// What letters stand for: as exact expressions for a proof, and by numbers for a witness. The two must share no formula:
/// one is wrong only where the other is right.
#[derive(Clone, Copy, Debug)]
pub struct Vocabulary {
    /// Exact expressions.
    pub exact: Exact,
    /// What kind of evidence the numbers are.
    pub evidence: &'static Evidence,
    /// Numbers in a few states of motion.
    pub numbers: fn() -> &'static [Moment],
    /// The line of our code that puts them together.
    pub stated_at: &'static Location<'static>,
}

impl Vocabulary {
    /// Puts together what the letters stand for.
    #[track_caller]
    pub const fn new(exact: Exact, evidence: &'static Evidence, numbers: fn() -> &'static [Moment]) -> Self {
        Self { exact, evidence, numbers, stated_at: Location::caller() }
    }
}

/// The characters with the names of the numbers that are printed at their dots, one after the other. A name with the sign of
/// degrees is of an angle that is printed with that sign; without it, so many radians would stand there.
pub fn filled(names: &'static [&'static str]) -> impl Fn(&str) -> String + Clone + Send + Sync + 'static {
    move |tex| {
        names.iter().fold(tex.to_owned(), |tex, name| {
            let angle = name.strip_suffix(r"^\circ");
            let units = [r"\ldots^\circ", r"\ldots^{\circ}"];
            // The first dots, with their unit if they have one.
            let first = tex.find(r"\ldots");
            let with_unit =
                units.into_iter().find(|dots| angle.is_some() && first.is_some() && tex.find(dots) == first);
            match (with_unit, angle) {
                (Some(dots), Some(angle)) => tex.replacen(dots, &format!("{angle} "), 1),
                (_, Some(angle)) => tex.replacen(r"\ldots", &format!(r"(180 {angle} / \pi) "), 1),
                (_, None) => tex.replacen(r"\ldots", &format!("{name} "), 1),
            }
        })
    }
}

/// The characters as the other side of an equation with this one, unless they are an equation already.
pub fn equal_to(side: &'static str) -> impl Fn(&str) -> String + Clone + Send + Sync + 'static {
    move |tex| if tex.contains('=') { tex.to_owned() } else { format!("{side} = {tex}") }
}
