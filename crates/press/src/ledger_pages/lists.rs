//! Lists: the classes of verdict, the kinds of evidence, the tolerances, the letters of a source.

use super::inline::badge;
use crate::book::{Book, NotationLetter};
use crate::chain::scientific;
use crate::formula::tex_or_text;
use crate::html::escape;
use crate::table::{Cells, Table};
use crate::{lookup, maths};
use anyhow::Context;
use geneva_evidence::{Judged, PlainVerdict, Symbol, Verdict};

/// The name of a table of letters, or its beginning.
pub const LETTERS: &str = "Letters";

/// The five plain verdicts with their meaning and how many claims of the documents have each.
pub fn verdicts(book: &Book) -> anyhow::Result<Table> {
    let count = |of| lookup::verdicts_of_documents(book.ledger).filter(|judged| judged.plain() == of).count();
    Table::with_rows(Cells::Words, PlainVerdict::ALL)
        .column("Verdict", |plain| badge(**plain))
        .column("What it means", |plain| escape(plain.meaning()))
        .column("Claims", |plain| count(**plain))
        .finish()
}

/// Which classes of verdict in the data are which plain verdict on the pages, with their meaning and how many claims of the
/// documents have each. A class that claims have in a document and in its copy has a row for each.
pub fn classes_of_verdict(book: &Book) -> anyhow::Result<Table> {
    let count = |plain, class| {
        let has = |judged: &&Judged| (judged.plain(), judged.verdict) == (plain, class);
        lookup::verdicts_of_documents(book.ledger).filter(has).count()
    };
    let of_plain = |plain: &PlainVerdict| {
        let plain = *plain;
        let is_row = move |class: &&Verdict| class.plain(false) == plain || count(plain, **class) > 0;
        Verdict::ALL.iter().filter(is_row).map(move |class| (*class, plain)).collect::<Vec<_>>()
    };
    Table::with_rows(Cells::Words, PlainVerdict::ALL.iter().flat_map(of_plain))
        .column("In the data", |(class, _)| format!("<code>{class}</code>"))
        .column("On the pages", |(_, plain)| plain.words())
        .column("What the class means", |(class, _)| escape(class.meaning()))
        .column("Claims", |(class, plain)| count(*plain, *class))
        .finish()
}

/// The kinds of evidence and how many claims of the documents use each.
pub fn evidence(book: &Book) -> anyhow::Result<Table> {
    let uses = |judged: &Judged, kind| judged.claim.check.evidence().contains(kind);
    Table::with_rows(Cells::Words, book.ledger.evidence())
        .column("Evidence", |kind| kind.to_string())
        .column("What it is", |kind| escape(kind.meaning))
        .column("Claims", |kind| lookup::verdicts_of_documents(book.ledger).filter(|judged| uses(judged, kind)).count())
        .finish()
}

/// The tolerances that are not printed digits.
pub fn tolerances(book: &Book) -> anyhow::Result<Table> {
    Table::with_rows(Cells::Words, book.ledger.tolerances())
        .column("Tolerance", |tolerance| tolerance.name)
        .column("Relative", |tolerance| scientific(&format!("{:e}", tolerance.relative)))
        .column("Why", |tolerance| escape(tolerance.reason))
        .finish()
}

/// The letters that stand for one thing in the whole book.
pub fn notation(book: &Book) -> anyhow::Result<Table> {
    Table::with_rows(Cells::Words, (book.notation)())
        .column("Letter", |letter| maths::formula(letter.tex, false))
        .column("What it stands for", |letter| escape(letter.meaning))
        .column("How it counts", |letter| escape(letter.counted))
        .finish()
}

/// The letters of a source and the book's: first those of the whole book, in the same order for each source.
pub fn symbols(book: &Book, slug: &str) -> anyhow::Result<Table> {
    let symbols = lookup::document(book.ledger, slug)?.symbols;
    let notation = (book.notation)();
    let is_of_all = |of: &&Symbol| notation.iter().any(|letter| letter.tex == of.ours);
    let of_all = notation.iter().flat_map(|letter| symbols.iter().filter(|symbol| symbol.ours == letter.tex));
    let others = symbols.iter().filter(|symbol| !is_of_all(symbol));
    let printed = |symbol: &Symbol| {
        // A letter is set as in a formula, with or without an index.
        let is_letter = |letter: &str| letter.contains('_') || letter.chars().count() == 1;
        let letters = with_indices(symbol.printed);
        match letters.split(", ").all(is_letter) {
            true => maths::formula(&letters, false),
            false => tex_or_text(symbol.printed),
        }
    };
    Table::with_rows(Cells::Letters, of_all.chain(others))
        .column("In this book", |symbol| maths::formula(symbol.ours, false))
        .column("What it stands for", |symbol| escape(&meaning(&notation, symbol)))
        .column("In the source", |symbol| printed(symbol))
        .finish()
}

/// What a letter of the book stands for in the chapters on a source: both are named, the letter in TeX.
pub fn letter(book: &Book, of: &str) -> anyhow::Result<String> {
    let (slug, tex) =
        of.split_once(' ').with_context(|| format!("`{of}`: give a source and a letter, as in `source K`"))?;
    let symbols = lookup::document(book.ledger, slug)?.symbols;
    let symbol = symbols.iter().find(|symbol| symbol.ours == tex);
    let symbol = symbol.ok_or_else(|| lookup::unknown("letter", tex, symbols.iter().map(|symbol| symbol.ours)))?;
    Ok(escape(&meaning(&(book.notation)(), symbol)))
}

/// What a letter stands for: as the whole book has it, and what else is to be said in the chapters on the source.
fn meaning(notation: &[NotationLetter], symbol: &Symbol) -> String {
    let of_all = notation.iter().find(|letter| letter.tex == symbol.ours);
    let parts = [of_all.map_or("", |letter| letter.meaning), symbol.meaning];
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
    use super::with_indices;

    #[test]
    fn a_digit_behind_a_letter_is_its_index() {
        let letters = ["l2", "P2P4, P2/P4", "r, l4", "f_1, f_2", "12"].map(with_indices);
        assert_eq!(letters, ["l_2", "P_2P_4, P_2/P_4", "r, l_4", "f_1, f_2", "12"]);
    }
}
