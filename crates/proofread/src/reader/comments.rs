//! The sign `%` in TeX: a comment, or in a text in Markdown also per cent without a backslash.

use super::unread::{UnreadKind, UnreadParts, note};
use crate::token::SourceChar;

/// How far behind a sign the equation of its line is looked for, in characters.
pub(super) const FAR: usize = 200;

/// Whether the sign behind a digit is one of per cent, by the rest of its line: an equation goes on there, or nothing but marks does.
pub(super) fn is_percent_behind_digit(line: &str) -> bool {
    line.contains(['=', '≈']) || line.contains("\\approx") || line.chars().all(|c| " \\)}]&.,".contains(c))
}

/// Counts the comments in a formula in Markdown, which are not shown.
pub(super) fn note_comments(formula: &str, unread: &mut UnreadParts) {
    for line in formula.lines() {
        let mut rest = line;
        while let Some((before, behind)) = rest.split_once('%') {
            rest = behind;
            let is_sign = before.ends_with('\\')
                || behind.trim().is_empty()
                || (before.ends_with(|c: char| c.is_ascii_digit())
                    && is_percent_behind_digit(&behind[..behind.floor_char_boundary(FAR)]));
            if !is_sign {
                note(unread, UnreadKind::Comment, "", behind);
                break;
            }
        }
    }
}

/// The characters without comments, each up to the next character that is shown.
pub(super) fn without_comments(signs: &[SourceChar]) -> Vec<SourceChar> {
    let (mut out, mut at): (Vec<SourceChar>, usize) = (Vec::with_capacity(signs.len()), 0);
    while let Some(sign) = signs.get(at) {
        at += 1;
        if sign.c != '%' || out.last().is_some_and(|last| last.c == '\\') {
            out.push(*sign);
            continue;
        }
        let is_next = |at: usize, fits: fn(char) -> bool| signs.get(at).is_some_and(|next| fits(next.c));
        while is_next(at, |c| c != '\n') {
            at += 1;
        }
        while is_next(at, char::is_whitespace) {
            at += 1;
        }
    }
    out
}
