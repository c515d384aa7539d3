//! What is wrong in a source: one slip, in one place or in many.

use crate::slugs::slugs;

/// What is wrong in one place, and the slip that it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Erratum {
    /// What should be printed there. Empty for a number whose check computes the right one.
    pub corrected: &'static str,
    /// In how many places of an equation the printed characters are others than the corrected ones.
    pub places: usize,
    /// The slip.
    pub slip: Slip,
}

/// One thing that is wrong. Every claim that it reaches refers to it; it is counted once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slip {
    /// The id of the claim in which the slip is made. Empty if it is the claim at hand.
    pub id: &'static str,
    /// Why it is wrong.
    pub reason: &'static str,
    /// Which second witness says so, in words.
    pub witness: &'static str,
    /// Where it comes from.
    pub origin: Origin,
    /// What it does to the reader of the source.
    pub consequence: Consequence,
    /// What changes when it is put right, in a sentence. May be empty if nothing but the place itself does.
    pub changes: &'static str,
}

/// Where a slip comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Origin {
    /// A character that is lost or changed in the copy at hand.
    Copy,
    /// A wrong or missing word, sign or symbol.
    Misprint,
    /// A wrong or carelessly rounded computation.
    Arithmetic,
    /// A wrong idea.
    Concept,
    /// Nothing that is printed shows where it comes from.
    Unknown,
}

/// The least relative deviation of an answer that counts as a wrong result: half a per cent.
///
/// Rounding to two digits can change any number by that much or more: half a unit of the second digit is at least 0.5 in 99.
/// What is wrong by less is wrong in its last digits, and no data of two digits would show it.
pub const FELT: f64 = 0.005;

/// What a slip does, the most serious consequence first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Consequence {
    /// An answer, a number in a table or a curve is wrong, by [`FELT`] or more.
    Result,
    /// Something that the source concludes is false: the claim is among the [`conclusions`](crate::Document::conclusions).
    Conclusion,
    /// A sentence that describes something is false; the source concludes nothing false from it.
    Remark,
    /// A printed number is wrong, and no answer is wrong by [`FELT`] or more.
    Number,
    /// A displayed equation is false; nothing after it uses it so.
    Derivation,
    /// A label, a reference, a unit or a name is wrong.
    Wording,
    /// A character of the copy is wrong; nothing is said of the original.
    Copy,
}

slugs!(Origin {
    Copy = "copy",
    Misprint = "misprint",
    Arithmetic = "arithmetic",
    Concept = "concept",
    Unknown = "unknown",
});

slugs!(Consequence {
    Result = "result",
    Conclusion = "conclusion",
    Remark = "remark",
    Number = "number",
    Derivation = "derivation",
    Wording = "wording",
    Copy = "copy",
});

impl Origin {
    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Copy => {
                "a character that is lost or changed in the copy we had, which says nothing about the original"
            }
            Self::Misprint => "a slip of the pen or a misprint: a wrong or missing word, sign or symbol",
            Self::Arithmetic => "a wrong or carelessly rounded computation",
            Self::Concept => "a wrong idea",
            Self::Unknown => "we cannot tell",
        }
    }
}

impl Consequence {
    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Result => "an answer, a tabulated number or a curve is wrong, by half a per cent or more",
            Self::Conclusion => "something that the source concludes is false",
            Self::Remark => {
                "a sentence that describes something is false, but the source concludes nothing false from it"
            }
            Self::Number => "a printed number is wrong, but no answer is wrong by half a per cent or more",
            Self::Derivation => "a displayed equation is false, but nothing after it uses it in that form",
            Self::Wording => "a label, a reference, a unit or a name is wrong",
            Self::Copy => "a character of the copy we had is wrong, which says nothing about the original",
        }
    }

    /// The meaning written as a heading.
    pub fn heading(self) -> String {
        let mut characters = self.meaning().chars();
        characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_to_two_digits_can_change_any_number_by_as_much() {
        // Half a unit of the second digit, over the greatest number of that size.
        let least = (10..=99).map(|digits| 0.5 / (f64::from(digits) + 0.5)).fold(f64::INFINITY, f64::min);
        assert!((FELT..1.01 * FELT).contains(&least), "{least}");
    }
}
