//! What the letters of a source stand for, once for every check of its equations.

use crate::Evidence;
use crate::tex::{Exact, Moment};

/// What letters stand for: as exact expressions for a proof, and by numbers for a witness. The two must share no formula:
/// one is wrong only where the other is right.
#[derive(Clone, Copy, Debug)]
pub struct Vocabulary {
    /// Exact expressions.
    pub exact: Exact,
    /// What kind of evidence the numbers are.
    pub evidence: Evidence,
    /// Numbers in a few states of motion.
    pub numbers: fn() -> &'static [Moment],
}

impl Vocabulary {
    /// Puts together what the letters stand for.
    pub const fn new(exact: Exact, evidence: Evidence, numbers: fn() -> &'static [Moment]) -> Self {
        Self { exact, evidence, numbers }
    }
}

/// The characters with the names of the numbers that are printed at their dots, one after the other; a name for an angle has
/// its unit in it.
pub(crate) fn filled(names: &'static [&'static str]) -> impl Fn(&str) -> String + Clone + Send + Sync + 'static {
    move |tex| {
        names.iter().fold(tex.to_owned(), |tex, name| {
            let dots = [r"\ldots^\circ", r"\ldots^{\circ}", r"\ldots"];
            // The first dots, with their unit if they have one.
            let first = tex.find(r"\ldots");
            let dots = dots.into_iter().find(|dots| first.is_some() && tex.find(dots) == first);
            dots.map_or_else(|| tex.clone(), |dots| tex.replacen(dots, &format!("{name} "), 1))
        })
    }
}

/// The characters as the other side of an equation with this one.
pub(crate) fn equal_to(side: &'static str) -> impl Fn(&str) -> String + Clone + Send + Sync + 'static {
    move |tex| format!("{side} = {tex}")
}
