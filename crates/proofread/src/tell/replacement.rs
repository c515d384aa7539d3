//! A hint as an edit of the text.

use crate::reader::TextFormat;
use crate::tell::hint::Hint;

impl Hint {
    /// What to write at the place instead, in a text of this format; none if the hint leaves it open, or is about something that is
    /// written in another way than the hint names it.
    ///
    /// A number keeps the way in which it is written: its separators and its decimal sign.
    ///
    /// ```
    /// use proofread::{CheckOptions, TextFormat, proofread};
    ///
    /// let (text, format) = (r"It is $\tan 31.0^\circ = 0{,}609$.", TextFormat::Markdown);
    /// let report = proofread(text, format, CheckOptions::default())?;
    /// let hint = report.findings[0].hint.as_ref().expect("a hint");
    /// assert_eq!(&text[hint.at.range()], "0{,}609");
    /// assert_eq!(hint.replacement(text, format).as_deref(), Some("0{,}601"));
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn replacement(&self, text: &str, format: TextFormat) -> Option<String> {
        replacement(self, text.get(self.at.range())?, format)
    }
}

/// What replaces the stretch of a hint, of which `source` is the text.
fn replacement(hint: &Hint, source: &str, format: TextFormat) -> Option<String> {
    let is_tex = matches!(format, TextFormat::Markdown | TextFormat::Latex);
    if hint.words.starts_with("the square of ") {
        return (is_tex && source.ends_with(')')).then(|| format!("{source}^2"));
    }
    let mut words = hint.words.split('`');
    let (new, old) = match [words.next()?, words.next()?, words.next()?, words.next()?] {
        ["", new, " for ", old] => (new, old),
        _ => return None,
    };
    match (new, old) {
        ("−", "+") => (source == "+").then(|| "-".to_owned()),
        ("+", "−") => matches!(source, "-" | "−").then(|| "+".to_owned()),
        _ if is_number(new) && is_number(old) => number(new, old, source),
        // A unit that is raised, as it stands.
        _ if source == old && new.strip_prefix(old).is_some_and(|power| power.starts_with('^')) => {
            is_tex.then(|| new.to_owned())
        }
        _ => exponent(new, old, source),
    }
}

fn is_number(text: &str) -> bool {
    text.contains(|c: char| c.is_ascii_digit()) && text.chars().all(|c| c.is_ascii_digit() || ".,".contains(c))
}

/// A number for another one, as the text writes it.
fn number(new: &str, old: &str, source: &str) -> Option<String> {
    if source == old {
        return Some(new.to_owned());
    }
    // With a comma where we have a point, if it has no other commas.
    for comma in ["{,}", ","] {
        if !old.contains(',')
            && !new.contains(',')
            && source.matches(comma).count() == 1
            && source.replacen(comma, ".", 1) == old
        {
            return Some(new.replace('.', comma));
        }
    }
    // Digit by digit, if nothing else differs.
    let separators = |text: &str| text.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect::<String>();
    let digits = |text: &str| text.chars().filter(char::is_ascii_digit).collect::<String>();
    if separators(new) != separators(old) || digits(source) != digits(old) {
        return None;
    }
    let is_plain = |c: char| c.is_ascii_digit() || ".,{} ~'’\u{a0}\u{2009}\u{202f}\\".contains(c);
    let mut others = new.chars().filter(char::is_ascii_digit);
    let written = |c: char| if c.is_ascii_digit() { others.next().unwrap_or(c) } else { c };
    source.chars().all(is_plain).then(|| source.chars().map(written).collect())
}

/// Signs of raised digits.
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// A power for another one, of which the text at hand is the exponent.
fn exponent(new: &str, old: &str, source: &str) -> Option<String> {
    let ((base, new), (old_base, old)) = (new.rsplit_once('^')?, old.rsplit_once('^')?);
    let whole = |text: &str| text.replace('−', "-").parse::<i32>().ok();
    let (new, old) = (whole(new)?, whole(old).filter(|_| base == old_base)?);
    // A sign that stands alone behind the caret has no braces, and what takes its place may need some.
    let in_braces = source.contains('{') || !source.starts_with('^');
    let is_raised = |c: char| RAISED.contains(&c) || c == '⁻';
    if source.chars().all(is_raised) {
        let raised = |of: i32| {
            let sign = if of < 0 { "⁻" } else { "" };
            let digit = |c: char| c.to_digit(10).and_then(|digit| RAISED.get(digit as usize)).copied();
            sign.to_owned() + &of.unsigned_abs().to_string().chars().filter_map(digit).collect::<String>()
        };
        return (raised(old) == source).then(|| raised(new));
    }
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '-' | '−');
    let start = source.find(is_part)?;
    let length = source[start..].find(|c| !is_part(c)).unwrap_or(source.len() - start);
    let (before, rest) = source.split_at(start);
    let (written, behind) = rest.split_at(length);
    let is_all = before.chars().chain(behind.chars()).all(|c| "^{} ()".contains(c));
    if !is_all || whole(written) != Some(old) {
        return None;
    }
    let sign = if written.contains('−') { "−" } else { "-" };
    let new = new.to_string().replace('-', sign);
    let needs_braces = !in_braces && new.chars().count() > 1;
    Some(if needs_braces { format!("{before}{{{new}}}{behind}") } else { format!("{before}{new}{behind}") })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{CheckOptions, proofread};
    use crate::tell::edit::EditKind;
    use crate::token::Span;

    fn replaced(words: &str, source: &str) -> Option<String> {
        let hint = Hint { words: words.to_owned(), at: Span::default(), kind: EditKind::Digit };
        replacement(&hint, source, TextFormat::Markdown)
    }

    #[test]
    fn a_number_keeps_the_way_in_which_it_is_written() {
        for (words, source, wanted) in [
            ("`0.601` for `0.609`", "0.609", Some("0.601")),
            ("`0.601` for `0.609`", "0,609", Some("0,601")),
            ("`0.601` for `0.609`", "0{,}609", Some("0{,}601")),
            ("`0.005631` for `0.0005631`", "0{,}0005631", Some("0{,}005631")),
            ("`12400` for `12300`", r"12\,300", Some(r"12\,400")),
            ("`12400` for `12300`", "12\u{202f}300", Some("12\u{202f}400")),
            ("`86,400` for `86.400`", "86.400", Some("86,400")),
            // Digits that stand elsewhere are not to be guessed.
            ("`1240` for `12400`", r"12\,400", None),
            ("`0.601` for `0.609`", r"\result", None),
            ("`0.601` for `0.609`", "0.608", None),
            ("`12` for `13`", "1x3", None),
            ("`−` for `+` in `1 + 2`", "+", Some("-")),
            ("`+` for `−` in `1 − 2`", "−", Some("+")),
            ("`+` for `−` in `1 − 2`", r"\mp", None),
            ("a factor 2 on one of the two sides", "7", None),
            ("the opposite sign on one of the two sides", "7", None),
            ("the exponent 2 outside the bracket", "^2", None),
            ("`m^2` for `m`", "m", Some("m^2")),
            ("`m^2` for `m`", r"\metre", None),
            ("the square of `(2.0 cm)`", ")", Some(")^2")),
            ("the square of `(2.0 cm)`", r"\right)", Some(r"\right)^2")),
            ("the square of `(2.0 cm)`", "</mo>", None),
            ("", "1", None),
        ] {
            assert_eq!(replaced(words, source).as_deref(), wanted, "{words} in {source}");
        }
    }

    #[test]
    fn an_exponent_keeps_its_braces_or_gets_some() {
        for (words, source, wanted) in [
            ("`10^−11` for `10^11`", "^{11}", Some("^{-11}")),
            ("`10^−1` for `10^1`", "^1", Some("^{-1}")),
            ("`10^3` for `10^2`", "^2", Some("^3")),
            ("`10^11` for `10^−11`", "^{−11}", Some("^{11}")),
            ("`10^−3` for `10^−2`", "⁻²", Some("⁻³")),
            ("`10^4` for `10^3`", "3", Some("4")),
            ("`10^3` for `10^2`", r"^{\two}", None),
            ("`10^3` for `10^2`", "^5", None),
            ("`10^3` for `2^2`", "^2", None),
        ] {
            assert_eq!(replaced(words, source).as_deref(), wanted, "{words} in {source}");
        }
    }

    #[test]
    fn what_a_fix_changes_agrees() {
        for (format, text) in [
            (TextFormat::Markdown, r"It is $\tan 31.0^\circ = 0.609$."),
            (TextFormat::Markdown, r"$(46.6\ \mathrm{W})(86.400\ \mathrm{s}) = 4.03\times10^6\ \mathrm{J}$"),
            (
                TextFormat::Latex,
                r"$\frac{1000\ \mathrm{MeV}}{8.62\times10^{11}\ \mathrm{MeV/K}} = 1.16\times10^{13}\ \mathrm{K}$",
            ),
            (TextFormat::Markdown, "$239.052157 - 239.046526 = 0.0005631$"),
            (TextFormat::Markdown, "$1/4.000 = 0.750$"),
            (TextFormat::Latex, r"Es ist $1/4{,}000 = 0{,}750$ und $1/8{,}0 = 0{,}125$ und $1/5{,}0=0{,}200$."),
            (TextFormat::Markdown, r"$\pi (2.0\ \mathrm{cm}) (3.0\ \mathrm{cm}) = 37.7\ \mathrm{cm}^3$"),
            (TextFormat::Html, "<p>It is 239.052157 − 239.046526 = 0.0005631.</p>"),
            (TextFormat::Xml, "<math><mrow><mn>1</mn><mo>/</mo><mn>4.000</mn><mo>=</mo><mn>0.750</mn></mrow></math>"),
            (TextFormat::Plain, "1/4.000 = 0.750"),
        ] {
            let findings = |text: &str| proofread(text, format, CheckOptions::default()).expect("it is read").findings;
            let before = findings(text);
            let hint = before.first().and_then(|of| of.hint.clone()).unwrap_or_else(|| panic!("no hint for {text}"));
            let new = replacement(&hint, &text[hint.at.range()], format);
            let new = new.unwrap_or_else(|| panic!("no edit for {hint:?} in {text}"));
            let mut after = text.to_owned();
            after.replace_range(hint.at.range(), &new);
            assert_eq!(findings(&after).len(), before.len() - 1, "{text}\n{after}");
        }
    }
}
