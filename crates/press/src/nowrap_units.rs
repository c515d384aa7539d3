//! A number and its unit stay on one line, and so does a letter with the number that it is equal to, and the number of an
//! equation.

use crate::html::GLUED;

/// The units that the pages write behind a number, as they stand in text: those of several words first.
const UNITS: &[&str] = &[
    "in lb s²",
    "in lb sec²",
    "in lb",
    "N m",
    "kg m²",
    "kg/m³",
    "%",
    "°C",
    "mm",
    "cm",
    "m",
    "km",
    "inch",
    "ms",
    "s",
    "min",
    "h",
    "rad/s²",
    "rad/s",
    "rad/sec",
    "rad",
    "mm/s",
    "m/s²",
    "m/s",
    "km/s",
    "rpm",
    "N",
    "kg",
    "g",
    "kB",
    "MB",
    "W",
    "J",
    "kJ",
    "V",
    "A",
    "Ω",
    "Hz",
    "kHz",
    "Pa",
    "kPa",
    "MPa",
    "GPa",
    "eV",
    "keV",
    "MeV",
    "K",
];

/// What a tag begins, up to its end, that is left as it is: code, what breaks no lines or has rules of its own, and numbers that
/// a script compares with those it shows.
const KEPT: &[&str] = &["pre", "code", "math", "svg", "script", "style", "textarea", "output"];

/// The words of a caption: of a figure that moves, its script compares them, too. Other captions come here as they are to stay.
const SAYS: &str = "<span class=\"says\"";

/// A page in Markdown or HTML, with a space that breaks no line between each number and its unit, and with the numbers of
/// equations in one piece.
pub(crate) fn tied(page: &str) -> String {
    tie(page, true)
}

/// A page as [`tied`] has it, but without a tag around the numbers of equations, of which the ledger has too many.
pub(crate) fn tied_without_tags(page: &str) -> String {
    tie(page, false)
}

fn tie(page: &str, with_tags: bool) -> String {
    let mut out = String::with_capacity(page.len() + page.len() / 64);
    let mut rest = page;
    while !rest.is_empty() {
        if let Some(behind) = rest.strip_prefix("&nbsp;") {
            out.push('\u{a0}');
            rest = behind;
            continue;
        }
        let kept = kept(rest);
        if kept > 0 {
            let (before, behind) = rest.split_at(kept);
            out.push_str(before);
            rest = behind;
            continue;
        }
        let Some(c) = rest.chars().next() else { break };
        if let Some((unit, length)) = unit(rest).filter(|_| out.ends_with(is_digit)) {
            out.push('\u{a0}');
            out.push_str(&unit.replace(' ', "\u{a0}"));
            rest = &rest[length..];
            continue;
        }
        if rest.starts_with(" · 10") && out.ends_with(|c: char| c.is_ascii_digit()) {
            out.push_str("\u{a0}·\u{a0}");
            rest = &rest[" · ".len()..];
            continue;
        }
        if rest.starts_with(" = ")
            && ends_with_letter(&out)
            && rest[3..].trim_start_matches('.').starts_with(|c: char| c.is_ascii_digit() || c == '−')
        {
            out.push_str("\u{a0}=\u{a0}");
            rest = &rest[3..];
            continue;
        }
        let numbers = if with_tags { hyphenated(rest) } else { 0 };
        if numbers > 0 && out.ends_with(['(', ' ', '\n', '\u{a0}']) {
            out.push_str(&format!("{GLUED}{}</span>", &rest[..numbers]));
            rest = &rest[numbers..];
            continue;
        }
        out.push(c);
        rest = &rest[c.len_utf8()..];
    }
    out
}

/// How long the numbers are that begin here and are joined by hyphens, such as those of an equation or of a day.
fn hyphenated(text: &str) -> usize {
    let length = text.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(text.len());
    let parts = text[..length].split('-');
    let is_one = parts.clone().count() > 1 && parts.into_iter().all(|part| !part.is_empty());
    if is_one && text[length..].starts_with([')', ' ', '\n', '.', ',', ';', ':']) { length } else { 0 }
}

/// A digit, or one of an exponent.
fn is_digit(c: char) -> bool {
    c.is_ascii_digit() || matches!(c, '⁰' | '¹' | '²' | '³' | '⁴'..='⁹')
}

/// Whether a text ends with a letter by itself.
fn ends_with_letter(text: &str) -> bool {
    let mut last = text.chars().rev();
    last.next().is_some_and(char::is_alphabetic) && !last.next().is_some_and(|c| c.is_alphanumeric() || c == '.')
}

/// How long what begins here is that is not text: code, a tag, or an element that is kept as it is.
fn kept(text: &str) -> usize {
    if text.starts_with('`') {
        let fence = text.len() - text.trim_start_matches('`').len();
        let end = text[fence..].find(&text[..fence]).map_or(0, |at| at + fence);
        return fence + end;
    }
    let Some(tag) = text.strip_prefix('<') else { return 0 };
    if text.starts_with(SAYS) {
        return text.find("</span>").unwrap_or(0);
    }
    let name = tag.find(|c: char| !c.is_ascii_alphanumeric()).map_or("", |end| &tag[..end]);
    let end = if KEPT.contains(&name) {
        text.find(&format!("</{name}>"))
    } else {
        text.find('>').filter(|_| !name.is_empty())
    };
    end.map_or(0, |end| end + 1)
}

/// The unit behind the blanks that begin here, at most one line end among them, and the length of both.
fn unit(text: &str) -> Option<(&'static str, usize)> {
    let behind = text.trim_start_matches([' ', '\n']);
    let blanks = text.len() - behind.len();
    let is_one_line = text[..blanks].matches('\n').count() < 2;
    let is_whole = |unit: &&&str| {
        let next = behind.strip_prefix(**unit).map(|rest| rest.chars().next());
        next.is_some_and(|next| {
            next.is_none_or(|c| !c.is_alphanumeric() && !['/', '²', '³', '-', '=', '('].contains(&c))
        })
    };
    let unit = UNITS.iter().find(is_whole).filter(|_| blanks > 0 && is_one_line)?;
    Some((unit, blanks + unit.len()))
}

#[cfg(test)]
mod tests {
    use super::{tied, tied_without_tags};

    #[test]
    fn a_number_keeps_its_unit() {
        assert_eq!(tied("10 mm thick, 0.1 N m, 1\nrad/s."), "10\u{a0}mm thick, 0.1\u{a0}N\u{a0}m, 1\u{a0}rad/s.");
        assert_eq!(tied("<td title=\"5 mm\">5 mm</td>"), "<td title=\"5 mm\">5\u{a0}mm</td>");
        assert_eq!(tied("95 % of 2 kg m²"), "95\u{a0}% of 2\u{a0}kg\u{a0}m²");
        assert_eq!(tied("3 · 10⁻⁶ in lb s²"), "3\u{a0}·\u{a0}10⁻⁶\u{a0}in\u{a0}lb\u{a0}s²");
        assert_eq!(tied("at φ = 20°, θ = −5"), "at φ\u{a0}=\u{a0}20°, θ\u{a0}=\u{a0}−5");
        assert_eq!(tied("μ = .30"), "μ\u{a0}=\u{a0}.30");
        let in_one_piece = "so (<span class=\"glued\">1-18</span>) of <span class=\"glued\">2026-11-23</span>.";
        assert_eq!(tied("so (1-18) of 2026-11-23."), in_one_piece);
        assert_eq!(tied(in_one_piece), in_one_piece);
        assert_eq!(tied_without_tags("(1-18) at 5 mm"), "(1-18) at 5\u{a0}mm");
    }

    #[test]
    fn what_is_no_unit_and_what_is_code_stays() {
        for text in [
            "4 slots, 3 sources, 2 marks",
            "`--size 5 mm`, ``a ` 5 mm``",
            "```sh\nwheel --size 5 mm\n```\n",
            "<pre><code>5 mm</code></pre><svg><text>5 mm</text></svg>",
            "in 1973\n\nm is",
            "a < 5 and mm",
            "pins = 3, a = b",
            "[a](ledger.md#eq-1-18), 1-, five-digit, a (1-pin) wheel, --at -30",
        ] {
            assert_eq!(tied(text), text);
        }
    }
}
