//! A table as rows of cells, with the numbers in them.

use super::characters::PlainCharacters;
use super::scanner::{Comma, PrintedNumber, Scanner};
use crate::reader::TextFormat;
use crate::token::Span;
use crate::unit::{currency, is_currency_sign, unit};

/// A cell of a table.
#[derive(Clone, Debug, Default)]
pub(super) struct TableCell {
    /// As one line.
    pub text: String,
    /// Its number, if it has nothing else but a unit, a share or marks of a footnote.
    pub number: Option<PrintedNumber>,
    /// The unit or the currency of the number; empty if it has none or is in per cent.
    pub unit: String,
    /// Whether the number is in per cent.
    pub is_percent: bool,
    /// The share in brackets behind the number.
    pub share: Option<PrintedNumber>,
    /// Where it is in the file.
    pub at: Span,
}

impl TableCell {
    /// The cell with this text, which begins `base` bytes into what `place` finds in the file.
    pub(super) fn new(text: &str, base: usize, format: TextFormat, place: &dyn Fn(Span) -> Span) -> Self {
        let base = base + text.len() - text.trim_start().len();
        let text = text.trim();
        let plain = PlainCharacters::new(text, format);
        let all = plain.span(0..plain.chars.len());
        let in_text = |span: Span| place(Span::new(base + span.start as usize, base + span.end as usize));
        let at = in_text(if plain.chars.is_empty() { Span::new(0, 0) } else { all });
        let mut cell = Self { text: plain.line(0..plain.chars.len()), at, ..Self::default() };
        let mut here = Scanner::new(&plain.chars, 0);
        while here.take_one_of(" \n").is_some() {}
        let before = take_unit(&mut here, |word| currency(word).is_some());
        while here.take_one_of(" \n").is_some() {}
        let start = here.at;
        let Some(number) = here.number(Comma::Groups) else { return cell };
        let end = here.at;
        here.skip_space();
        let behind = take_unit(&mut here, |word| word.chars().count() > 1 && unit(word).is_some());
        cell.unit = before.or(behind).unwrap_or_default();
        let is_percent = here.take('%');
        here.skip_space();
        let mut share = None;
        if here.take('(') || here.take('[') {
            share = here.number(Comma::Groups);
            here.skip_space();
            share = share.filter(|_| here.take('%'));
            while !here.is_at_end() && !matches!(here.peek(), ')' | ']') {
                here.at += 1;
            }
            here.at += 1;
        }
        // Marks of a footnote, or stars.
        here.take('^');
        while here.take_one_of(" \n*†‡§^()").is_some() {}
        if !here.is_at_end() && here.peek().is_ascii_lowercase() && here.at + 1 == plain.chars.len() {
            here.at += 1;
        }
        if here.at >= plain.chars.len() {
            (cell.number, cell.is_percent, cell.share) = (Some(number), is_percent, share);
            if share.is_none() {
                cell.at = in_text(plain.span(start..end));
            }
        }
        cell
    }

    /// Whether nothing is in it, or a mark for nothing.
    pub(super) fn is_empty(&self) -> bool {
        let text = self.text.trim_matches([' ', '–', '—', '-', '−', '.', '…']);
        text.is_empty() || text.eq_ignore_ascii_case("n/a") || text.eq_ignore_ascii_case("na")
    }
}

/// The sign of a currency, or a unit by its name or sign, with its exponent; nothing is taken if none is here.
fn take_unit(here: &mut Scanner<'_>, is_unit: impl Fn(&str) -> bool) -> Option<String> {
    if is_currency_sign(here.peek()) {
        return here.take_one_of("$€£").map(String::from);
    }
    let mut ahead = *here;
    let mut word = ahead.word();
    if !is_unit(&word) {
        return None;
    }
    let sign = currency(&word).map(str::to_owned);
    word.extend(ahead.take_one_of("²³"));
    *here = ahead;
    Some(sign.unwrap_or(word))
}

/// A table.
#[derive(Clone, Debug, Default)]
pub(super) struct TextTable {
    pub rows: Vec<Vec<TableCell>>,
}

impl TextTable {
    pub(super) fn cell(&self, row: usize, column: usize) -> Option<&TableCell> {
        self.rows.get(row)?.get(column)
    }

    /// How many columns the longest row has.
    pub(super) fn width(&self) -> usize {
        self.rows.iter().map(Vec::len).max().unwrap_or_default()
    }
}
