//! TeX between the marks that documents put around it: dollar signs, `\(`, `\[`, and the environments of displays.

use std::ops::Range;

/// Longest formula that is read, in bytes.
const LONGEST: usize = 20_000;
/// How far behind a dollar sign inside braces the end of the formula is searched for, in bytes.
pub(crate) const FARTHEST: usize = 500;

/// Environments whose content is a display.
pub(crate) const DISPLAYS: [&str; 12] = [
    "equation",
    "equation*",
    "align",
    "align*",
    "eqnarray",
    "eqnarray*",
    "gather",
    "gather*",
    "multline",
    "multline*",
    "displaymath",
    "flalign",
];
const MORE_DISPLAYS: [&str; 5] = ["flalign*", "alignat", "alignat*", "math", "dmath"];

/// Whether a single dollar sign opens a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dollars {
    /// Only two do, as in pages that MathJax sets.
    Double,
    /// One does, too, if no space is inside it, so that sums of money are none.
    Single,
    /// One does, whatever stands inside it, as in a notebook.
    Spaced,
}

/// A formula and its marks, in bytes of the text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DelimitedFormula {
    pub whole: Range<usize>,
    pub inside: Range<usize>,
}

/// Searches for the same end again and again without reading the same stretch twice.
#[derive(Default)]
struct Searches(Vec<(String, usize)>);

impl Searches {
    fn end(&mut self, text: &str, from: usize, end: &str) -> Option<usize> {
        let known = self.0.iter().position(|(of, _)| of == end).unwrap_or_else(|| {
            self.0.push((end.to_owned(), 0));
            self.0.len() - 1
        });
        // Up to here there is none.
        let none_until = &mut self.0[known].1;
        let start = from.max((*none_until).saturating_sub(end.len()));
        let mut limit = text.len().min(from + LONGEST);
        while !text.is_char_boundary(limit) {
            limit -= 1;
        }
        let mut start = start.min(limit);
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        match text[start..limit].find(end) {
            Some(at) => Some(start + at),
            None => {
                *none_until = limit;
                None
            }
        }
    }
}

/// The formulas of a text in their order, outside the stretches to skip, which are in their order, too.
pub(crate) fn formulas(text: &str, skip: &[Range<usize>], dollars: Dollars) -> Vec<DelimitedFormula> {
    let bytes = text.as_bytes();
    let mut out = Vec::new();
    let mut searches = Searches::default();
    let mut skipped = skip.iter().peekable();
    let mut at = 0;
    while at < bytes.len() {
        while skipped.next_if(|range| range.end <= at).is_some() {}
        if let Some(range) = skipped.peek()
            && range.contains(&at)
        {
            at = range.end;
            continue;
        }
        let rest = &bytes[at..];
        let found = match rest {
            [b'\\', b'\\', open @ (b'[' | b'('), ..] => {
                let end = if *open == b'[' { "\\\\]" } else { "\\\\)" };
                searches.end(text, at + 3, end).map(|end| (3, end, 3))
            }
            [b'\\', open @ (b'[' | b'('), ..] => {
                let end = if *open == b'[' { "\\]" } else { "\\)" };
                searches.end(text, at + 2, end).map(|end| (2, end, 2))
            }
            [b'\\', b'b', ..] if text[at..].starts_with("\\begin{") => environment(text, at, &mut searches),
            [b'\\', ..] => None,
            [b'$', b'$', ..] => searches.end(text, at + 2, "$$").map(|end| (2, end, 2)),
            [b'$', ..] if dollars != Dollars::Double => single_dollar_formula(text, at, dollars == Dollars::Spaced),
            _ => {
                at += 1;
                continue;
            }
        };
        match found {
            Some((open, end, close)) => {
                out.push(DelimitedFormula { whole: at..end + close, inside: at + open..end });
                at = end + close;
            }
            // What a backslash escapes is no mark.
            None if rest[0] == b'\\' => at += 2,
            None if rest.starts_with(b"$$") => at += 2,
            None => at += 1,
        }
        while !text.is_char_boundary(at.min(text.len())) {
            at += 1;
        }
    }
    out
}

fn environment(text: &str, at: usize, searches: &mut Searches) -> Option<(usize, usize, usize)> {
    let behind = &text[at + 7..];
    let name = behind.get(..behind.find('}').filter(|end| *end < 20)?)?;
    if !DISPLAYS.contains(&name) && !MORE_DISPLAYS.contains(&name) {
        return None;
    }
    let end = format!("\\end{{{name}}}");
    let open = 7 + name.len() + 1;
    searches.end(text, at + open, &end).map(|found| (open, found, end.len()))
}

/// A formula between single dollar signs, as pandoc tells it from sums of money; `spaced` says that space may be inside them.
fn single_dollar_formula(text: &str, at: usize, spaced: bool) -> Option<(usize, usize, usize)> {
    let bytes = text.as_bytes();
    let first = *bytes.get(at + 1)?;
    if first.is_ascii_whitespace() && !spaced {
        return None;
    }
    let (mut end, mut lines, mut depth) = (at + 1, 0, 0usize);
    // A mark inside braces belongs to text in the formula, unless no other one follows.
    let mut inside = None;
    let end = loop {
        if inside.is_some_and(|inside| end > inside + FARTHEST) {
            break inside?;
        }
        match bytes.get(end) {
            Some(b'\\') => end += 1,
            Some(b'{') => depth += 1,
            Some(b'}') => depth = depth.saturating_sub(1),
            Some(b'$') if depth == 0 => break end,
            Some(b'$') => inside = inside.or(Some(end)),
            Some(b'\n') => {
                lines += 1;
                let blank = bytes.get(end + 1..).is_some_and(|rest| rest.first() == Some(&b'\n'));
                if blank || lines > 5 {
                    break inside?;
                }
            }
            Some(_) => {}
            None => break inside?,
        }
        end += 1;
    };
    let before = bytes.get(end - 1)?;
    let digit_behind = bytes.get(end + 1).is_some_and(u8::is_ascii_digit);
    ((spaced || !before.is_ascii_whitespace()) && !digit_behind && text.is_char_boundary(end)).then_some((1, end, 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formulas_in(text: &str) -> Vec<&str> {
        formulas(text, &[], Dollars::Single).into_iter().map(|of| &text[of.inside]).collect()
    }

    #[test]
    fn marks_of_every_kind_are_found() {
        let text = r"a $x=1$ b $$y=2$$ c \(z=3\) d \\(w=4\\) \[v=5\] \begin{align}u=6\end{align} \$5 and \$6";
        assert_eq!(formulas_in(text), ["x=1", "y=2", "z=3", "w=4", "v=5", "u=6"]);
    }

    #[test]
    fn money_is_no_formula() {
        assert_eq!(formulas_in("It costs $5 and $6 more, $ 7 or 8 $."), [""; 0]);
    }

    #[test]
    fn a_mark_without_an_end_is_not_searched_for_twice() {
        let text = r"\( $$ ".repeat(200_000);
        assert!(formulas(&text, &[], Dollars::Single).len() <= 200_000);
    }
}
