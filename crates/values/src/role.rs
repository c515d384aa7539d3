//! Numbers that are no results: dates, references, and parts of formulas, told by their form and by the words before them.

use crate::numeral::{Form, Numeral, run};

/// What a number seems to be, if it is no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A year, a day or a time of day.
    Date,
    /// The number of a figure, a section, a work, a standard or a version, or a mark of a list.
    Reference,
    /// A number of a formula, which its author gives.
    Given,
}

impl Role {
    /// The word for it in a record.
    pub fn name(self) -> &'static str {
        match self {
            Self::Date => "date",
            Self::Reference => "reference",
            Self::Given => "given",
        }
    }
}

/// Words before the number of a thing.
const REFERENCES: &str = " fig figs figure figures eq eqs eqn equation equations section sections sec sect chapter chapters \
    chap ch table tables tab appendix ref refs reference references page pages p pp vol volume no nr step item part lemma \
    theorem corollary definition version iso iec din en ieee rfc ansi astm example exercise problem algorithm listing line \
    lines note footnote issue release edition ";
const MONTHS: &str = " january february march april may june july august september october november december jan feb mar apr \
    jun jul aug sep sept oct nov dec ";

fn is_listed(list: &str, word: &str) -> bool {
    !word.is_empty() && list.contains(&format!(" {} ", word.to_lowercase()))
}

/// What a number seems to be. `before` has the words before it, the nearest first, and `last` is the role of the number before it.
pub(crate) fn role_of(text: &str, at: usize, read: &Numeral, before: &[&str], last: Option<Role>) -> Option<Role> {
    match read.form {
        Form::Date => return Some(Role::Date),
        Form::Name => return Some(Role::Reference),
        Form::Coefficient => return Some(Role::Given),
        Form::Plain => {}
    }
    if !read.unit.is_empty() || !read.scale.is_empty() {
        return None;
    }
    let is_integer = !read.digits.contains(['.', ',', '-']);
    let word = before.first().copied().unwrap_or_default();
    let second = before.get(1).copied().unwrap_or_default();
    if opens_line(text, at, read.end) || (is_bracketed(text, at, read.end) && is_integer) || is_listed(REFERENCES, word)
    {
        return Some(Role::Reference);
    }
    // Figures 3 and 4.
    let joins = matches!(word, "and" | "to" | "or") && second == "#" || word == "#" && joins_numbers(text, at);
    if joins && last == Some(Role::Reference) && read.digits.len() <= 3 {
        return last;
    }
    let is_acronym = word.len() >= 2 && word.chars().all(|c| c.is_ascii_uppercase());
    if is_integer && is_acronym && read.digits.len() >= 3 {
        return Some(Role::Reference);
    }
    if is_integer && (is_listed(MONTHS, word) || is_listed(MONTHS, word_behind(text, read.end))) && word != "may" {
        return Some(Role::Date);
    }
    let is_year = is_integer
        && read.digits.len() == 4
        && matches!(read.digits.as_bytes(), [b'1', b'5'..=b'9', ..] | [b'2', b'0', ..]);
    is_year.then_some(Role::Date)
}

/// Whether a number in a formula is a small integer in a sum or product with letters, as both in `k^2 - 2k + 1`.
pub(crate) fn is_among_letters(text: &str, at: usize, read: &Numeral) -> bool {
    /// Longest side of an equation, in bytes, either way.
    const LONGEST: usize = 200;
    /// Commands that stand for no quantity.
    const SIGNS: &str =
        " cdot times pm left right frac dfrac tfrac sqrt text mathrm quad qquad approx le ge leq geq to displaystyle ";
    let is_small = read.digits.len() <= 3 && !read.digits.contains(['.', ',']);
    // In a formula k is a letter, not a thousand.
    if !is_small || !read.unit.is_empty() || read.scale.len() > 1 {
        return false;
    }
    let ends_side = |c: char| "=<>≈$&\n".contains(c);
    let before = &text[boundary(text, at.saturating_sub(LONGEST))..at];
    let before = before.rsplit(ends_side).next().unwrap_or_default();
    let behind = &text[read.whole_end..boundary(text, (read.whole_end + LONGEST).min(text.len()))];
    let behind = behind.split(ends_side).next().unwrap_or_default();
    let has_letter = |side: &str| {
        side.split_inclusive(|c: char| !c.is_alphabetic())
            .scan('\0', |last, word| {
                let opener = std::mem::replace(last, word.chars().next_back().unwrap_or('\0'));
                Some((opener, word.trim_end_matches(|c: char| !c.is_alphabetic())))
            })
            .any(|(opener, word)| {
                let is_sign = opener == '\\' && SIGNS.contains(&format!(" {word} "));
                !word.is_empty() && !is_sign
            })
    };
    has_letter(before) || has_letter(behind)
}

fn word_behind(text: &str, at: usize) -> &str {
    let rest = text[at..].trim_start_matches([' ', '\n', '~']);
    &rest[..rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len()).min(rest.len())]
}

/// Whether only a comma or a dash is between a number and the one before it.
fn joins_numbers(text: &str, at: usize) -> bool {
    let before = text[..at].trim_end_matches([' ', ',', '–', '-', '&']);
    before.len() < at && before.ends_with(|c: char| c.is_ascii_digit() || c == ')')
}

/// Whether the number is the mark of an item or the number of a heading.
fn opens_line(text: &str, at: usize, end: usize) -> bool {
    let before = text[..at].trim_end_matches([' ', '\t', '>', '*']);
    let heads = before.trim_end_matches('#');
    let is_heading = heads.len() < before.len() && (heads.is_empty() || heads.ends_with('\n'));
    let is_first = before.is_empty() || before.ends_with('\n');
    let mark = text[end..].strip_prefix(['.', ')']).is_some_and(|rest| rest.starts_with([' ', '\t', '\n']));
    is_heading || (is_first && mark && end - at <= 3)
}

/// Whether the number is in square brackets with nothing but other numbers, or alone in round ones behind `Eq.`.
fn is_bracketed(text: &str, at: usize, end: usize) -> bool {
    let is_of_list = |c: char| c.is_ascii_digit() || matches!(c, ',' | ' ' | '–' | '-');
    let before = &text[boundary(text, at.saturating_sub(40))..at];
    let opens = before.trim_end_matches(is_of_list).ends_with('[');
    let mut behind = run(text, end);
    let rest = text[behind..].bytes().take(40).take_while(|byte| is_of_list(char::from(*byte))).count();
    behind += rest;
    opens && text.get(behind..).is_some_and(|rest| rest.starts_with(']')) && !text[behind..].starts_with("](")
}

fn boundary(text: &str, at: usize) -> usize {
    (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len())
}
