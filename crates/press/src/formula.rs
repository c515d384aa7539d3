//! One formula, from TeX to MathML, while the book is built.
//!
//! A reader's browser sets MathML itself: no script, and no markup besides. The same TeX gives the same bytes
//! on every run.

use std::sync::LazyLock;

use crate::html::escape;
use anyhow::{Context, anyhow, ensure};
use math_core::{LatexError, LatexToMathML, MathCoreConfig, MathDisplay};

/// The markup of one formula, on one line; it may stand in HTML and in Markdown alike, table cells included.
///
/// A displayed formula comes in a `<span class="display">`, in pieces between which its line may break; one that
/// is aligned in a table has no such places, and scrolls where it is wider than the page. What the book's font has no sign
/// for is an error, and so is an equation that would be numbered without a `\tag`.
pub fn formula(tex: &str, display: bool) -> anyhow::Result<String> {
    let tex = tex.trim();
    // A display with a number of its own is an equation, whether it says so or not; its lines may be aligned.
    let is_equation = !tex.contains(r"\begin{") || tex.starts_with(r"\begin{aligned}");
    let wrapped =
        (display && tex.contains(r"\tag{") && is_equation).then(|| format!(r"\begin{{equation}}{tex}\end{{equation}}"));
    let markup = markup(wrapped.as_deref().unwrap_or(tex), display).with_context(|| format!("the formula `{tex}`"))?;
    if !display {
        return Ok(markup);
    }
    let in_one_row = markup.strip_prefix(NUMBERED[0]).and_then(|rest| rest.strip_suffix(NUMBERED[2]));
    Ok(match in_one_row.and_then(|row| row.split_once(NUMBERED[1])).filter(|(row, _)| !row.contains("<mtr>")) {
        Some((equation, number)) => {
            let pieces = breakable(&format!("<math display=\"block\">{equation}</math>"));
            format!(
                "<span class=\"display numbered{}\"><span>{pieces}</span><math>{number}</math></span>",
                long(&pieces)
            )
        }
        None => {
            let pieces = breakable(&markup);
            format!("<span class=\"display{}\">{pieces}</span>", long(&pieces))
        }
    })
}

/// A piece of TeX as markup if it is TeX, else as text.
pub fn tex_or_text(text: &str) -> anyhow::Result<String> {
    // Dots between words are no formula.
    let words = text.replace(r" \ldots", "\u{a0}…");
    if words.contains(['\\', '{', '=']) { formula(text, false) } else { Ok(escape(&words)) }
}

/// The class of a display with a piece of many signs, which is set smaller on a phone.
fn long(pieces: &str) -> &'static str {
    const MANY: usize = 24;
    if pieces.split("</math>").any(|piece| signs(piece) > MANY) { " long" } else { "" }
}

/// How many letters, numbers and operators there are in a piece of markup.
fn signs(markup: &str) -> usize {
    ["<mi>", "<mn>", "<mo>", "<mo "].iter().map(|sign| markup.matches(sign).count()).sum()
}

/// What stands before, between and behind an equation in one row and its number.
const NUMBERED: [&str; 3] = [
    "<math display=\"block\"><mtable displaystyle=\"true\" scriptlevel=\"0\" style=\"width: 100%\"><mtr><mtd style=\"width: \
     50%\"></mtd><mtd>",
    "</mtd><mtd style=\"width: 50%;text-align: right;justify-items: end;\">",
    "</mtd></mtr></mtable></math>",
];

/// A formula in pieces, each a `math` element: its line may break between them, as TeX breaks it, before a sign that relates
/// or adds and behind a wide space, but not within braces, fractions and roots. No browser breaks inside one element. A
/// formula of few signs fits every screen, and stays whole.
pub fn breakable(markup: &str) -> String {
    const FEW: usize = 14;
    if signs(markup) <= FEW {
        return markup.to_owned();
    }
    let inner = markup.strip_prefix("<math display=\"block\">").or_else(|| markup.strip_prefix("<math>"));
    let Some((inner, behind)) = inner.and_then(|inner| inner.split_once("</math>")) else { return markup.to_owned() };
    let places = places(inner);
    if places.is_empty() {
        return markup.to_owned();
    }
    let starts = std::iter::once(0).chain(places.iter().copied());
    let ends = places.iter().copied().chain([inner.len()]);
    let has_parts = places.iter().any(|place| inner[..*place].ends_with(WIDE_SPACE));
    let pieces = starts.zip(ends).map(|(from, to)| {
        let piece = &inner[from..to];
        // At the beginning of a row a sign would be taken for that of a number.
        let begins_with_sign = from > 0 && (piece.starts_with("<mo>") || piece.starts_with("<mo "));
        let piece = if begins_with_sign { piece.replacen("<mo", "<mo form=\"infix\"", 1) } else { piece.to_owned() };
        // A part of a formula that a wide space ends stays on one line if there is room.
        let begin =
            if has_parts && (from == 0 || inner[..from].ends_with(WIDE_SPACE)) { "<span class=\"part\">" } else { "" };
        let end = if has_parts && (to == inner.len() || piece.ends_with(WIDE_SPACE)) { "</span>" } else { "" };
        // The style sheet has the space, on both sides, so that a part alone on its line is in the middle.
        let piece = if has_parts { piece.trim_end_matches(WIDE_SPACE) } else { &piece };
        format!("{begin}<math>{piece}</math>{end}")
    });
    pieces.collect::<String>() + behind
}

/// The markup of the space between two formulas in a row.
const WIDE_SPACE: &str = "<mspace width=\"2em\"/>";

/// Where the row of a formula may break.
fn places(inner: &str) -> Vec<usize> {
    const SIGNS: [&str; 10] = ["=", "&lt;", "&gt;", "≤", "≥", "≈", "≠", "+", "−", "⇒"];
    let (mut places, mut depth) = (Vec::new(), 0);
    for (at, _) in inner.match_indices('<') {
        let Some((tag, rest)) = inner[at..].split_once('>') else { break };
        if tag.starts_with("</") {
            depth -= 1;
        } else if tag.ends_with('/') {
            if depth == 0 && inner[at..].starts_with(WIDE_SPACE) {
                places.push(at + WIDE_SPACE.len());
            }
        } else {
            // A sign of a number says that it has no space before it.
            let is_sign = ["<mo", "<mo rspace=\"0\""].contains(&tag);
            if depth == 0 && is_sign && rest.split('<').next().is_some_and(|sign| SIGNS.contains(&sign)) {
                places.push(at);
            }
            depth += 1;
        }
    }
    places.retain(|place| (1..inner.len()).contains(place));
    places.dedup();
    places
}

fn markup(tex: &str, display: bool) -> anyhow::Result<String> {
    static CONVERTER: LazyLock<LatexToMathML> =
        LazyLock::new(|| LatexToMathML::new(MathCoreConfig::default()).expect("no macros of our own"));
    let style = if display { MathDisplay::Block } else { MathDisplay::Inline };
    // The second formula is there to be counted: its number is 1 unless the first has taken that.
    let both = [(tex, style), (r"\begin{equation}x\end{equation}", MathDisplay::Block)];
    let mut converted = CONVERTER.convert_all(&both).into_iter();
    let (Some(first), Some(counted)) = (converted.next(), converted.next()) else { unreachable!("two formulas") };
    let math = first.map_err(|error| explained(&error, tex))?.mathml;
    let numbered = !counted.is_ok_and(|equation| equation.mathml.contains("(1)"));
    ensure!(!numbered, "an equation without a \\tag{{…}} or \\notag would get a number of its own");
    shield(&bare(&math))
}

/// The markup without spaces of no width, and without the rows around an upright letter that held nothing else.
fn bare(markup: &str) -> String {
    const ROW: &str = "<mrow><mspace/>";
    let mut out = String::with_capacity(markup.len());
    let mut rest = markup;
    while let Some((before, after)) = rest.split_once(ROW) {
        out.push_str(before);
        rest = match after.split_once("</mi></mrow>") {
            Some((letter, behind)) if letter.starts_with("<mi") && letter.matches('<').count() == 1 => {
                out.push_str(letter);
                out.push_str("</mi>");
                behind
            }
            _ => {
                out.push_str(ROW);
                after
            }
        };
    }
    out + rest
}

/// What is wrong, and where.
fn explained(error: &LatexError, tex: &str) -> anyhow::Error {
    let message = error.to_string();
    let message = message.trim_end_matches('.');
    match tex.get(error.0.start..).filter(|rest| !rest.is_empty() && error.0.start > 0) {
        Some(rest) => anyhow!("{message}, at `{rest}`"),
        None => anyhow!("{message}"),
    }
}

/// The text between the tags, with whatever Markdown or mdBook would take for its own as an entity; an error
/// for a sign that the book's font does not have.
fn shield(markup: &str) -> anyhow::Result<String> {
    let mut out = String::with_capacity(markup.len());
    let mut in_tag = false;
    for c in markup.chars() {
        match c {
            '<' => in_tag = true,
            '>' => in_tag = false,
            _ if in_tag => {}
            '\n' => {
                out.push(' ');
                continue;
            }
            '\\' | '`' | '*' | '_' | '[' | ']' | '~' | '|' | '\'' | '"' | '-' | '.' | '^' | '$' | '{' => {
                out.push_str(&format!("&#{};", u32::from(c)));
                continue;
            }
            _ => ensure!(has_sign(c), "the book's mathematical font has no `{c}` (U+{:04X})", u32::from(c)),
        }
        out.push(c);
    }
    Ok(out)
}

fn has_sign(c: char) -> bool {
    const CHARACTERS: &str = include_str!("../../../book/theme/maths/characters.txt");
    // Operators that are not drawn: an empty delimiter, the application of a function.
    const INVISIBLE: std::ops::RangeInclusive<char> = '\u{2061}'..='\u{2064}';
    CHARACTERS.contains(c) || INVISIBLE.contains(&c)
}

/// A piece of TeX, or a few words, with what differs from another marked where one stretch of letters does.
///
/// A change that begins or ends inside a fraction or an exponent is widened until the piece can be set.
pub fn mark_changes(tex: &str, other: &str) -> anyhow::Result<String> {
    let plain = tex_or_text(tex)?;
    let (ours, theirs) = (tokens(tex), tokens(other));
    let head = ours.iter().zip(&theirs).take_while(|(one, other)| one == other).count();
    let most = ours.len().min(theirs.len()) - head;
    let tail = ours.iter().rev().zip(theirs.iter().rev()).take(most).take_while(|(one, other)| one == other).count();
    let (from, to) = (head, ours.len() - tail);
    if from == to || !plain.contains("<math") {
        return Ok(plain);
    }
    let widened = (0..=WIDEST).flat_map(|by| (0..=by).map(move |left| (left, by - left)));
    for (left, right) in widened.filter(|(left, right)| *left <= from && to + right <= ours.len()) {
        let (before, inside, behind) = (&ours[..from - left], &ours[from - left..to + right], &ours[to + right..]);
        if !is_closed(inside) {
            continue;
        }
        let marked = format!("{}{{{MARK}{}}}{}", before.concat(), inside.concat(), behind.concat());
        if let Ok(marked) = formula(&marked, false) {
            return Ok(marked.replace(MARKED, "class=\"changed\""));
        }
    }
    Ok(plain)
}

/// Whether each brace that opens in it closes in it.
fn is_closed(tokens: &[&str]) -> bool {
    let depths = tokens.iter().scan(0, |depth, token| {
        *depth += match *token {
            "{" => 1,
            "}" => -1,
            _ => 0,
        };
        Some(*depth)
    });
    let depths: Vec<i32> = depths.collect();
    depths.iter().all(|depth| *depth >= 0) && depths.last().is_none_or(|depth| *depth == 0)
}

/// By how many tokens a change is widened at most.
const WIDEST: usize = 12;
/// A colour that no formula has, in TeX and in markup: it gives way to a class.
const MARK: &str = r"\color[RGB]{1,2,3}";
const MARKED: &str = "style=\"color:#010203;\"";

/// The tokens of TeX: commands, and single characters.
fn tokens(tex: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = tex;
    while let Some(first) = rest.chars().next() {
        let behind = &rest[first.len_utf8()..];
        let letters = behind.chars().take_while(char::is_ascii_alphabetic).count();
        let length = match (first, letters, behind.chars().next()) {
            // A command is a name, or one sign of any kind.
            ('\\', 0, Some(sign)) => 1 + sign.len_utf8(),
            ('\\', ..) => 1 + letters,
            _ => first.len_utf8(),
        };
        let (token, behind) = rest.split_at(length);
        tokens.push(token);
        rest = behind;
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stay_words_and_tex_becomes_markup() {
        assert_eq!(tex_or_text("10 mm").expect("text"), "10 mm");
        assert!(tex_or_text(r"\sqrt{2}").expect("TeX").contains("math"));
    }

    #[test]
    fn a_display_may_bear_the_number_of_its_source() {
        let markup = formula(r"a = b \tag{1-7}", true).expect("an equation");
        assert!(markup.contains("1") && !markup.contains("tag"), "{markup}");
        assert!(
            markup.starts_with("<span class=\"display numbered\"><span><math") && !markup.contains("<mtable"),
            "{markup}"
        );
        assert!(formula(r"a = b \tag{1-7}", false).is_err(), "a formula in a line has no number");
    }

    #[test]
    fn mathml_and_nothing_else() {
        assert_eq!(formula("a_1", false).unwrap(), "<math><msub><mi>a</mi><mn>1</mn></msub></math>");
        let broken = formula("a_1 a_2 a_3 a_4 = -b_1 b_2 b_3 b_4 + c", true).unwrap();
        let pieces: Vec<&str> = broken.split("<math>").collect();
        assert_eq!(pieces.len(), 4, "{broken}");
        assert!(
            pieces[2].starts_with("<mo form=\"infix\"") && pieces[3].starts_with("<mo form=\"infix\">+"),
            "{broken}"
        );
        // A dotted letter behind a wide space is no sign.
        let dotted =
            formula(r"\dot r = R\dot\theta\sin\beta, \qquad r\dot\varphi = R\dot\theta\cos\beta", true).unwrap();
        assert_eq!(dotted.matches("<mover accent=\"true\">").count(), 4, "{dotted}");
        assert_eq!(dotted.matches("form=\"infix\"").count(), 2, "{dotted}");
        let parts: Vec<&str> = dotted.split("<span class=\"part\">").collect();
        assert!(parts.len() == 3 && parts[1..].iter().all(|part| part.matches("<math>").count() == 2), "{dotted}");
        // An upright letter is a letter and nothing besides.
        let upright = formula(r"a^\mathrm{n}_\mathrm{rel}", false).unwrap();
        assert_eq!(upright, "<math><msubsup><mi>a</mi><mi>rel</mi><mi mathvariant=\"normal\">n</mi></msubsup></math>");
        let whole = formula("\\frac{a_1 a_2 a_3 a_4 + b_1 b_2 b_3 b_4}{c = d}", true).unwrap();
        assert_eq!(whole.matches("<math").count(), 1, "{whole}");
        let display = formula(" a ", true).unwrap();
        assert_eq!(display, "<span class=\"display\"><math display=\"block\"><mi>a</mi></math></span>");
    }

    #[test]
    fn what_the_font_cannot_show_is_refused() {
        for tex in ["é", "\\text{é}", "\\mathcal{L}", "\\mathsf{x}"] {
            let error = format!("{:#}", formula(tex, false).unwrap_err());
            assert!(error.contains("font has no"), "{error}");
        }
        for tex in [
            "45°",
            "\\mathbf{x}^{y^z}",
            "\\boldsymbol{\\omega} \\times \\vec{r}",
            "\\Bigl(x\\Bigr)",
            "\\left.\\frac{\\frac ab}{\\frac cd}\\right|_0",
            "\\sum_{i=1}^n \\dddot{x} \\widehat{ABC}",
            "\\text{if } \\mathrm{d}x \\iff 1",
        ] {
            assert!(formula(tex, true).is_ok(), "{tex}");
        }
    }

    #[test]
    fn roots_are_right_without_braces() {
        assert_eq!(formula("\\sqrt 2x", false).unwrap(), formula("\\sqrt{2}x", false).unwrap());
    }

    #[test]
    fn an_error_says_where() {
        let error = format!("{:#}", formula("a + \\nosuch + b", false).unwrap_err());
        assert_eq!(error, "the formula `a + \\nosuch + b`: Unknown command \"\\nosuch\", at `\\nosuch + b`");
    }

    #[test]
    fn a_misprint_is_marked_where_it_stands() {
        let mark = "<mrow class=\"changed\"><mn>3</mn></mrow>";
        for (tex, other) in [("x^{3/2}+y", "x^{5/2}+y"), (r"\frac{3}{2}a", r"\frac{5}{2}a"), ("x=3", "x=5")] {
            let marked = mark_changes(tex, other).unwrap();
            assert_eq!(marked.matches(mark).count(), 1, "{marked}");
            assert_eq!(marked.replace(mark, "<mn>3</mn>"), mark_changes(tex, tex).unwrap());
        }
        // A change from the top of a fraction to its foot takes in the fraction.
        let wide = mark_changes(r"a+\frac{b}{c}", r"a+\frac{d}{e}").unwrap();
        assert!(wide.contains("<mrow class=\"changed\"><mfrac>"), "{wide}");
        let same_end = mark_changes(r"2 \frac{a - 1}{n}", r"2 \frac{a + 1}{2n}").unwrap();
        assert!(same_end.ends_with("<mi>n</mi></mfrac></mrow></math>"), "{same_end}");
        assert_eq!(mark_changes("lost words", "found words").unwrap(), "lost words");
    }

    #[test]
    fn an_equation_has_the_number_that_its_author_gives() {
        assert!(formula("\\begin{align} a &= b \\tag{3.1} \\\\ &= c \\notag \\end{align}", true).is_ok());
        let error = format!("{:#}", formula("\\begin{align} a &= b \\end{align}", true).unwrap_err());
        assert!(error.contains("a number of its own"), "{error}");
    }

    #[test]
    fn the_same_bytes_on_every_run() {
        let tex =
            "\\begin{aligned} a &= \\sqrt{\\frac{b}{c}} \\\\ \\left(\\dot x\\right) &= \\overline{d} \\end{aligned}";
        let once = formula(tex, true).unwrap();
        for _ in 0..20 {
            assert_eq!(std::thread::spawn(move || formula(tex, true).unwrap()).join().unwrap(), once);
        }
        assert!(!once.contains('\n'));
    }
}
