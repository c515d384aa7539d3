//! TeX between the marks that documents put around it: dollar signs, `\(`, `\[`, and the environments of displays.

use super::shortcodes::WIDE;
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
/// Environments whose content is a display, too, though fewer programs know them.
pub(crate) const MORE_DISPLAYS: [&str; 9] =
    ["flalign*", "alignat", "alignat*", "math", "dmath", "IEEEeqnarray", "IEEEeqnarray*", "IEEEeqnarraybox", "empheq"];

/// Whether a single dollar sign opens a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dollars {
    /// Only two do, as in pages that MathJax sets.
    Double,
    /// One does, too, if no space is just inside it, or if it is plainly a formula, so that sums of money are none.
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
    let open = open + length_of_columns(name, &text[at + open..]);
    searches.end(text, at + open, &end).map(|found| (open, found, end.len()))
}

/// The bytes of the arguments behind the start of an environment that takes some: a number of columns, or their kinds.
pub(crate) fn length_of_columns(name: &str, behind: &str) -> usize {
    /// Longest argument, in bytes.
    const LONGEST: usize = 60;
    let optional = behind.strip_prefix('[').and_then(|rest| rest.find(']')).filter(|length| *length < LONGEST);
    let optional = optional.filter(|_| TAKES_KINDS.contains(&name)).map_or(0, |length| length + 2);
    let argument = behind[optional..].strip_prefix('{').and_then(|rest| rest.split_once('}')).map(|(inside, _)| inside);
    let is_number =
        |number: &&str| !number.is_empty() && number.len() < 3 && number.chars().all(|c| c.is_ascii_digit());
    let is_argument = |inside: &&str| match name {
        "alignat" | "alignat*" => is_number(inside),
        _ => TAKES_KINDS.contains(&name) && inside.len() < LONGEST,
    };
    optional + argument.filter(is_argument).map_or(0, |inside| inside.len() + 2)
}

/// Displays before whose rows the kinds of their columns, or the name of another display, stand as an argument.
const TAKES_KINDS: [&str; 4] = ["IEEEeqnarray", "IEEEeqnarray*", "IEEEeqnarraybox", "empheq"];

/// A formula between single dollar signs, as pandoc tells it from sums of money; `spaced` says that space may be inside them.
fn single_dollar_formula(text: &str, at: usize, spaced: bool) -> Option<(usize, usize, usize)> {
    let bytes = text.as_bytes();
    let first = *bytes.get(at + 1)?;
    // Behind a shortcode of Hugo it is a mark.
    let spaced = spaced || text[..at].ends_with(WIDE);
    // A sum of money stands before the sign: 5 $ and 6 $.
    let opens_apart = first.is_ascii_whitespace() && !spaced;
    if opens_apart
        && text[..at].trim_end_matches([' ', '\u{a0}']).ends_with(|c: char| c.is_alphanumeric() && !c.is_alphabetic())
    {
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
    let apart = opens_apart || (before.is_ascii_whitespace() && !spaced);
    let is_one = || {
        text.get(at + 1..end).is_some_and(is_plainly_formula)
            && !bytes.get(end + 1).is_some_and(u8::is_ascii_alphanumeric)
    };
    (!digit_behind && text.is_char_boundary(end) && (!apart || is_one())).then_some((1, end, 1))
}

/// Longest formula with space inside its dollar signs, in bytes.
const LONGEST_APART: usize = 500;

/// Whether what is between two dollar signs is a formula and no text between two sums of money: it has a relation with something on
/// both sides, and no words.
fn is_plainly_formula(inside: &str) -> bool {
    const SIGNS: [char; 6] = ['=', '<', '>', '≈', '≤', '≥'];
    const COMMANDS: [&str; 8] = ["\\approx", "\\le", "\\ge", "\\ne", "\\sim", "\\equiv", "\\implies", "\\in"];
    let trimmed = inside.trim();
    let relates = trimmed.contains(SIGNS) || COMMANDS.iter().any(|command| trimmed.contains(command));
    let open = |c: char| "=<>≈≤≥+*/,.;:".contains(c);
    if trimmed.len() > LONGEST_APART
        || !relates
        || trimmed.starts_with(open)
        || trimmed.ends_with(|c| open(c) || c == '-')
    {
        return false;
    }
    // The words of text that no command or braces hold.
    let (mut depth, mut letters, mut in_command) = (0usize, 0usize, false);
    for c in trimmed.chars() {
        match c {
            '\\' => (in_command, letters) = (true, 0),
            '{' => (in_command, letters, depth) = (false, 0, depth + 1),
            '}' => (in_command, letters, depth) = (false, 0, depth.saturating_sub(1)),
            c if c.is_alphabetic() && in_command => {}
            c if c.is_alphabetic() && depth == 0 => letters += 1,
            _ => (in_command, letters) = (false, 0),
        }
        if letters > 2 {
            return false;
        }
    }
    true
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
        assert_eq!(formulas_in("Pay $5 = 500 cents or $ 6, $3 + $4 = $7, or 5 $ = 500 and 3 $ more."), [""; 0]);
        assert_eq!(formulas_in("With $a = 3 and $b = 4, $c is 5; 5 $ + 3 $ = 8 $; $x > 2 $y"), [""; 0]);
    }

    #[test]
    fn space_may_be_inside_what_is_plainly_a_formula() {
        let text = r"It is $2 - 4 = -3 $, and $ \frac{1}{2} = 0.5 $, and $ x \approx 2 \text{ metres}$, and $ 7 $.";
        assert_eq!(formulas_in(text), ["2 - 4 = -3 ", r" \frac{1}{2} = 0.5 ", r" x \approx 2 \text{ metres}"]);
    }

    #[test]
    fn a_mark_without_an_end_is_not_searched_for_twice() {
        let text = r"\( $$ ".repeat(200_000);
        assert!(formulas(&text, &[], Dollars::Single).len() <= 200_000);
    }
}
