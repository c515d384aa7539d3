//! Lists: the classes of verdict, the kinds of evidence, the tolerances, the letters of a source.

use super::inline::badge;
use crate::html::{Cells, Table, escape, table, tex_or_text};
use crate::tables::chain::scientific;
use crate::{lookup, maths};
use anyhow::Context;
use geneva_documents::LEDGER;
use geneva_evidence::{Judged, Symbol, Verdict};
use geneva_figures::notation::NOTATION;

/// The classes of verdict with their meaning and how many claims of the documents have each.
pub fn verdicts() -> anyhow::Result<Table> {
    let rows = Verdict::ALL.iter().map(|verdict| {
        let count = lookup::of_documents().filter(|judged| judged.verdict == *verdict).count();
        Ok(vec![badge(*verdict), escape(verdict.meaning()), verdict.truth().to_string(), count.to_string()])
    });
    table("Classes of verdict", Cells::Words, &["Verdict", "What it means", "Is it right?", "Claims"], rows)
}

/// The kinds of evidence and how many claims of the documents use each.
pub fn evidence() -> anyhow::Result<Table> {
    let rows = LEDGER.evidence().iter().map(|kind| {
        let uses = |judged: &&Judged| judged.claim.check.evidence().contains(kind);
        let count = lookup::of_documents().filter(uses).count();
        Ok(vec![kind.to_string(), escape(kind.meaning), count.to_string()])
    });
    table("Kinds of evidence", Cells::Words, &["Evidence", "What it is", "Claims"], rows)
}

/// The tolerances that are not printed digits.
pub fn tolerances() -> anyhow::Result<Table> {
    let rows = LEDGER.tolerances().into_iter().map(|tolerance| {
        let relative = scientific(&format!("{:e}", tolerance.relative))?;
        Ok(vec![tolerance.name.to_owned(), relative, escape(tolerance.reason)])
    });
    table("Tolerances", Cells::Words, &["Tolerance", "Relative", "Why"], rows)
}

/// The letters of the triangle, which are the same in the whole book.
pub fn notation() -> anyhow::Result<Table> {
    let rows = NOTATION
        .iter()
        .map(|letter| Ok(vec![maths::formula(letter.tex, false)?, escape(letter.meaning), escape(letter.counted)]));
    table("Letters of this book", Cells::Words, &["Letter", "What it stands for", "How it counts"], rows)
}

/// The letters of a source and the book's: first those of the triangle, in the same order for each source.
pub fn symbols(slug: &str) -> anyhow::Result<Table> {
    let symbols = lookup::work(slug)?.symbols;
    let is_of_triangle = |of: &&Symbol| NOTATION.iter().any(|letter| letter.tex == of.ours);
    let triangle = NOTATION.iter().flat_map(|letter| symbols.iter().filter(|symbol| symbol.ours == letter.tex));
    let others = symbols.iter().filter(|symbol| !is_of_triangle(symbol));
    let rows = triangle.chain(others).map(|symbol| {
        let meaning = meaning(symbol);
        // A letter is set as in a formula, with or without an index.
        let is_letter = |letter: &str| letter.contains('_') || letter.chars().count() == 1;
        let letters = with_indices(symbol.printed);
        let printed = match letters.split(", ").all(is_letter) {
            true => maths::formula(&letters, false),
            false => tex_or_text(symbol.printed),
        };
        Ok(vec![maths::formula(symbol.ours, false)?, escape(&meaning), printed?])
    });
    table("Letters", Cells::Words, &["In this book", "What it stands for", "In the source"], rows)
}

/// What a letter of the book stands for in the chapters on a source: both are named, the letter in TeX.
pub fn letter(of: &str) -> anyhow::Result<String> {
    let (slug, tex) = of.split_once(' ').with_context(|| format!("`{of}`: give a source and a letter, `meyer K`"))?;
    let symbols = lookup::work(slug)?.symbols;
    let symbol = symbols.iter().find(|symbol| symbol.ours == tex);
    let symbol = symbol.ok_or_else(|| lookup::unknown("letter", tex, symbols.iter().map(|symbol| symbol.ours)))?;
    Ok(escape(&meaning(symbol)))
}

/// What a letter stands for: as the whole book has it, and what else is to be said in the chapters on the source.
fn meaning(symbol: &Symbol) -> String {
    let of_triangle = NOTATION.iter().find(|letter| letter.tex == symbol.ours);
    let parts = [of_triangle.map_or("", |letter| letter.meaning), symbol.meaning];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("; ")
}

/// Letters in TeX: a digit behind a letter is its index.
fn with_indices(letters: &str) -> String {
    let before = std::iter::once(' ').chain(letters.chars());
    let tex = letters
        .chars()
        .zip(before)
        .map(|(c, before)| if c.is_ascii_digit() && before.is_alphabetic() { format!("_{c}") } else { c.to_string() });
    tex.collect()
}

#[cfg(test)]
mod tests {
    use super::{letter, with_indices};

    #[test]
    fn a_letter_says_what_the_table_says_and_an_unknown_one_is_refused() {
        assert_eq!(letter("meyer K").expect("a letter"), "torque of the spring");
        assert_eq!(letter("pin R").expect("a letter"), "crank radius");
        for wrong in ["meyer", "meyer Kk", "mayer K"] {
            assert!(letter(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_digit_behind_a_letter_is_its_index() {
        let letters = ["l2", "P2P4, P2/P4", "r, l4", "f_1, f_2", "12"].map(with_indices);
        assert_eq!(letters, ["l_2", "P_2P_4, P_2/P_4", "r, l_4", "f_1, f_2", "12"]);
    }
}
