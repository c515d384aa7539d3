//! What both notations of office programs have in common: formulas in MathML on the page, and on one line of the text.

use super::super::words::{number_length, plain_chars};
use super::page::MadePage;
use crate::token::{MathFunction, signs};

/// A leaf of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Leaf {
    /// The element of MathML with its attributes.
    element: &'static str,
    pub text: String,
}

impl Leaf {
    /// Whether it is a word of upright letters, or a part of one.
    pub(super) fn is_word(&self) -> bool {
        self.element == "mtext" && self.text.chars().all(char::is_alphabetic)
    }
}

/// How letters of a formula are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Letters {
    /// As quantities, each letter for itself.
    Italic,
    /// As units and words.
    Upright,
    /// As running text.
    Text,
}

/// The leaves in a stretch of a formula.
pub(super) fn leaves(text: &str, letters: Letters) -> Vec<Leaf> {
    if letters == Letters::Text {
        return vec![Leaf { element: "mtext", text: text.to_owned() }];
    }
    let chars: Vec<char> = text.chars().collect();
    let plain = plain_chars(&signs(text, 0));
    // A sign that is left out or is made of several has no number behind it.
    let number_at = |at: usize| if plain.len() == chars.len() { number_length(&plain[at..]) } else { 0 };
    let (mut out, mut at) = (Vec::new(), 0);
    while let Some(&c) = chars.get(at) {
        let run = |is: &dyn Fn(char) -> bool| chars[at..].iter().take_while(|c| is(**c)).count();
        let digits = number_at(at).max(run(&|c| c.is_ascii_digit()));
        let word = run(&|c| c.is_alphabetic() || "°%".contains(c));
        let name: String = chars[at..at + run(&|c| c.is_ascii_alphabetic())].iter().collect();
        let is_degree = c == '°' && chars.get(at + 1).is_some_and(|c| "CF".contains(*c)) && word == 2;
        let (element, length) = if c.is_whitespace() {
            ("mspace", 1)
        } else if digits > 0 {
            ("mn", digits)
        } else if MathFunction::from_name(&name).is_some() && !(letters == Letters::Upright && name == MINUTE) {
            ("mi", name.len())
        } else if letters == Letters::Upright && word > 0 {
            ("mtext", word)
        } else if is_degree {
            ("mi", 2)
        } else if c.is_alphabetic() || "°%".contains(c) {
            ("mi", 1)
        } else if c == ',' && parts_digits(&chars, at) {
            (DECIMAL_COMMA, 1)
        } else {
            ("mo", 1)
        };
        out.push(Leaf { element, text: chars[at..at + length].iter().collect() });
        at += length;
    }
    out
}

/// A comma that touches digits on both sides, which is no separator of a list with space.
const DECIMAL_COMMA: &str = "mo separator=\"false\"";

/// Whether the comma at `at` has a digit on either side.
fn parts_digits(chars: &[char], at: usize) -> bool {
    let digit = |at: Option<usize>| at.and_then(|at| chars.get(at)).is_some_and(char::is_ascii_digit);
    digit(at.checked_sub(1)) && digit(Some(at + 1))
}

/// The tag that closes an element with these attributes.
fn closing(element: &str) -> String {
    format!("</{}>", element.split(' ').next().unwrap_or_default())
}

/// Adds a leaf to a formula.
pub(super) fn add(page: &mut MadePage, leaf: &Leaf) {
    if leaf.element == "mspace" {
        page.tags("<mspace/>");
        return page.shown(" ");
    }
    if leaf.element == "mtext" && leaf.text == MINUTE {
        // Letter by letter it is no function.
        for letter in leaf.text.chars() {
            page.tags("<mi mathvariant=\"normal\">");
            page.characters(letter.encode_utf8(&mut [0; 4]));
            page.tags("</mi>");
        }
        return;
    }
    element(page, leaf.element, &leaf.text);
}

/// A unit that is also a function.
const MINUTE: &str = "min";

/// Adds leaves that the line shows already, from this byte on.
pub(super) fn add_at(page: &mut MadePage, of: &[Leaf], mut at: usize) {
    for leaf in of {
        page.tags(&format!("<{}>", leaf.element));
        page.characters_at(&leaf.text, at);
        page.tags(&closing(leaf.element));
        at += leaf.text.len();
    }
}

/// Whether a leaf is space.
pub(super) fn is_space(leaf: &Leaf) -> bool {
    leaf.element == "mspace"
}

/// Adds an element with text in it.
pub(super) fn element(page: &mut MadePage, name: &str, text: &str) {
    page.tags(&format!("<{name}>"));
    page.characters(text);
    page.tags(&closing(name));
}

/// Adds an element with text in it that the line shows otherwise, or not at all.
pub(super) fn element_shown_as(page: &mut MadePage, name: &str, text: &str, shown: &str) {
    let at = page.text.len();
    page.shown(shown);
    page.tags(&format!("<{name}>"));
    page.sign_for(text, crate::token::Span::new(at, page.text.len()));
    page.tags(&format!("</{name}>"));
}

/// Adds a part in brackets on the line, if it has more than one number or letter in it.
pub(super) fn bracketed(page: &mut MadePage, part: &mut dyn FnMut(&mut MadePage)) {
    let start = page.text.len();
    page.tags("<mrow>");
    page.shown("(");
    let inside = page.text.len();
    part(page);
    page.tags("</mrow>");
    let is_short = page.text.get(inside..).is_some_and(|text| text.chars().all(|c| c.is_alphanumeric() || c == '.'));
    if is_short && page.text.len() > inside {
        page.close_gap(start, inside);
    } else {
        page.shown(")");
    }
}

/// The sign above a letter, as the reader of MathML knows it.
pub(super) fn accent(sign: &str) -> &str {
    match sign {
        "\u{302}" | "\u{5e}" | "ˆ" => "^",
        "\u{20d7}" | "→" => "→",
        "\u{307}" | "˙" => "˙",
        "\u{308}" | "¨" => "¨",
        "\u{304}" | "\u{305}" | "\u{332}" | "‾" | "―" | "_" | "ˉ" => "¯",
        other => other,
    }
}

/// The character of a font of symbols, by its number there.
pub(super) fn symbol(number: Option<&str>) -> char {
    let number = number.and_then(|number| u32::from_str_radix(number, 16).ok()).map(|number| number & 0xff);
    match number {
        Some(0xb4) => '×',
        Some(0xd7) => '·',
        Some(0xb8) => '÷',
        Some(0xb1) => '±',
        Some(0xbb) => '≈',
        Some(0xb9) => '≠',
        Some(0xa3) => '≤',
        Some(0xb3) => '≥',
        Some(0xb0) => '°',
        Some(0xd6) => '√',
        Some(0x2d) => '−',
        Some(0x6d) => 'μ',
        Some(0x70) => 'π',
        Some(0x57) => 'Ω',
        Some(0x44) => 'Δ',
        Some(of @ 0x28..=0x3f) => char::from_u32(of).unwrap_or('\u{fffc}'),
        _ => '\u{fffc}',
    }
}
