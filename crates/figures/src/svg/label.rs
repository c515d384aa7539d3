//! Text with italic symbols and subscripts, on a halo of its ground's colour.

use super::view::Pixels;
use crate::number::{format_trimmed, with_minus_sign};
use crate::theme::{Colour, INK};

/// The look of a label's halo, but for its colour: attributes of a `text` element.
pub(crate) const HALO: &str = " stroke-width=\"5\" stroke-linejoin=\"round\" paint-order=\"stroke\"";

/// Height of the letters of a label, in pixels of the view box.
pub(crate) const TEXT_SIZE: f64 = 22.0;
/// Height of a subscript's letters over that of its symbol.
const SUBSCRIPT: f64 = 0.84;
/// How far a subscript stands below the line.
const DROP: f64 = 7.0;
/// How far a superscript stands above the line.
const RISE: f64 = 10.0;
/// The signs of powers, and how far they stand from a slanted letter.
const POWERS: [char; 2] = ['²', '³'];
const FROM_LETTER: f64 = 4.0;
/// Half the height of a digit: from the middle of a label to its base line.
const HALF_HEIGHT: f64 = 0.36 * TEXT_SIZE;
/// Heights above and below the base line that letters reach at most, over the text's size.
const ASCENT: f64 = 0.76;
const ASCENT_UNDER_DOTS: f64 = 0.96;
const DESCENT: f64 = 0.22;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Upright,
    Italic,
    Subscript,
    Superscript,
}

/// Where a label may stand: so far from a point, in a direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LabelPosition {
    /// What the label belongs to.
    pub point: Pixels,
    /// Which way from there, of any length.
    pub towards: Pixels,
    /// How far from there, in pixels.
    pub distance: f64,
}

/// A line of text made of symbols, subscripts and words.
#[derive(Clone, Debug)]
pub(crate) struct Label {
    runs: Vec<(Style, String)>,
    colour: Colour,
    haloed: bool,
    part: String,
}

impl Label {
    /// A label that begins with a symbol, in italics.
    pub(crate) fn symbol(letter: &str) -> Self {
        Self::words("").and_symbol(letter)
    }

    /// The symbol of a part of the drawing, as [`parts::part`](crate::parts::part) names it: the two light up together.
    pub(crate) fn part(letter: &str) -> Self {
        Self::symbol(letter).of_part(letter)
    }

    /// Says which part of the drawing the label names.
    pub(crate) fn of_part(mut self, letter: &str) -> Self {
        self.part = letter.to_owned();
        self
    }

    /// The part of the drawing that the label names.
    pub(crate) fn names(&self) -> Option<&str> {
        (!self.part.is_empty()).then_some(&self.part)
    }

    /// A label that begins with upright text.
    pub(crate) fn words(text: &str) -> Self {
        Self { runs: Vec::new(), colour: INK, haloed: true, part: String::new() }.and(text)
    }

    /// Adds upright text; hyphens become minus signs.
    pub(crate) fn and(mut self, text: &str) -> Self {
        if !text.is_empty() {
            self.runs.push((Style::Upright, with_minus_sign(text)));
        }
        self
    }

    /// Adds a symbol in italics.
    pub(crate) fn and_symbol(mut self, letter: &str) -> Self {
        self.runs.push((Style::Italic, letter.to_owned()));
        self
    }

    /// A label that begins with a rate of change: see [`and_rate`](Self::and_rate).
    pub(crate) fn rate(letter: &str, order: usize) -> Self {
        Self::words("").and_rate(letter, order)
    }

    /// Adds a symbol's rate of change with time: the letter in italics under one dot, two or three.
    pub(crate) fn and_rate(self, letter: &str, order: usize) -> Self {
        self.and_symbol(&with_dots(letter, order))
    }

    /// Adds a subscript.
    pub(crate) fn sub(self, index: &str) -> Self {
        self.index(Style::Subscript, index)
    }

    /// Adds a superscript; a subscript that follows stands under it.
    pub(crate) fn sup(self, index: &str) -> Self {
        self.index(Style::Superscript, index)
    }

    /// Whether a part of it stands below the line.
    pub(crate) fn has_subscript(&self) -> bool {
        self.runs.iter().any(|(style, _)| *style == Style::Subscript)
    }

    /// Adds an index. An empty one is left out: browsers ignore the shift of an empty span, and what follows would drop.
    fn index(mut self, style: Style, index: &str) -> Self {
        if !index.is_empty() {
            self.runs.push((style, index.to_owned()));
        }
        self
    }

    /// Adds another label's text, in this one's colours.
    pub(crate) fn and_label(mut self, other: &Self) -> Self {
        self.runs.extend(other.runs.iter().cloned());
        self
    }

    /// Sets the colour of the letters.
    pub(crate) fn in_colour(mut self, colour: Colour) -> Self {
        self.colour = colour;
        self
    }

    /// Leaves out the halo, for a label on a plain face.
    pub(crate) fn bare(mut self) -> Self {
        self.haloed = false;
        self
    }

    /// The colour of the letters.
    pub(crate) fn colour(&self) -> Colour {
        self.colour
    }

    /// The label's first word alone.
    pub(crate) fn first_word(&self) -> Self {
        let first = self.runs.first().map(|(style, text)| (*style, text.split(' ').next().unwrap_or(text).to_owned()));
        Self { runs: first.into_iter().collect(), ..self.clone() }
    }

    /// The lines of a label of words, which are parted by line feeds.
    pub(crate) fn lines(&self) -> Vec<Self> {
        let text: String = self.runs.iter().map(|(_, text)| text.as_str()).collect();
        text.lines().map(|line| Self { runs: Vec::new(), ..self.clone() }.and(line)).collect()
    }

    /// The label's markup, so far from `point` in the direction of `towards` (an offset of any length).
    ///
    /// Sideways the label begins or ends there; above and below it is centred. Its halo has the colour of the `ground`.
    pub(crate) fn markup_beside(&self, point: &Pixels, towards: &Pixels, distance: f64, ground: &str) -> String {
        let (x, base, anchor) = anchored(point, towards, distance);
        self.markup(x, base, anchor, ground)
    }

    /// The least and the greatest corner of the room that the same label takes; `width` is its [width](Self::width).
    pub(crate) fn extent(&self, width: f64, point: &Pixels, towards: &Pixels, distance: f64) -> [Pixels; 2] {
        let (x, base, anchor) = anchored(point, towards, distance);
        let left = match anchor {
            "start" => x,
            "end" => x - width,
            _ => x - width / 2.0,
        };
        let lowered = self.has_subscript();
        let below = DESCENT * TEXT_SIZE + if lowered { DROP - 2.0 } else { 0.0 };
        let raised = self.runs.iter().any(|(style, _)| *style == Style::Superscript);
        let is_dotted = self.runs.iter().any(|(_, text)| text.contains(DOTS));
        let letters = if is_dotted { ASCENT_UNDER_DOTS } else { ASCENT } * TEXT_SIZE;
        let above = if raised { letters.max(RISE + ASCENT * SUBSCRIPT * TEXT_SIZE) } else { letters };
        [Pixels::new(left, base - above), Pixels::new(left + width, base + below)]
    }

    /// A generous guess at the label's width, in pixels: fonts differ.
    pub(crate) fn width(&self) -> f64 {
        let shifts = self.runs.windows(2).map(|pair| aside(&pair[0], &pair[1]));
        let letters = self.runs.iter().map(|(style, text)| {
            let size = if matches!(style, Style::Subscript | Style::Superscript) { SUBSCRIPT } else { 1.0 };
            text.chars().map(letter_width).sum::<f64>() * size * TEXT_SIZE
        });
        letters.sum::<f64>() + shifts.sum::<f64>()
    }

    fn markup(&self, x: f64, base: f64, anchor: &str, ground: &str) -> String {
        let mut spans = String::new();
        let mut lowered = 0.0;
        for (k, run) in self.runs.iter().enumerate() {
            let (style, text) = run;
            let wanted = match style {
                Style::Subscript => DROP,
                Style::Superscript => -RISE,
                Style::Upright | Style::Italic => 0.0,
            };
            let mut shift = if wanted == lowered {
                String::new()
            } else {
                format!(" dy=\"{}\"", format_trimmed(wanted - lowered, 2))
            };
            lowered = wanted;
            let before = k.checked_sub(1).and_then(|before| self.runs.get(before));
            let aside = before.map_or(0.0, |before| aside(before, run));
            if aside != 0.0 {
                shift = format!(" dx=\"{}\"{shift}", format_trimmed(aside, 2));
            }
            // The halo of a power would hide a part of the letter before it.
            let is_power = *style == Style::Superscript || (k > 0 && text.starts_with(POWERS));
            let halo = if is_power && self.haloed { " stroke=\"none\"" } else { "" };
            let look = match style {
                Style::Upright => String::new(),
                Style::Italic => " font-style=\"italic\"".to_owned(),
                Style::Subscript | Style::Superscript => {
                    format!(" font-size=\"{}\"", format_trimmed(SUBSCRIPT * TEXT_SIZE, 2))
                }
            };
            spans += &format!("<tspan{shift}{look}{halo}>{}</tspan>", escape(text));
        }
        let halo = if self.haloed { format!(" stroke=\"{ground}\"{HALO}") } else { String::new() };
        let part =
            if self.part.is_empty() { String::new() } else { format!(" data-letter=\"{}\"", escape(&self.part)) };
        format!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\" fill=\"{}\"{halo}{part}>{spans}</text>",
            format_trimmed(x, 2),
            format_trimmed(base, 2),
            self.colour.0,
        )
    }
}

/// Where a label so far from `point` in the direction of `towards` has its x and its base line, and its anchor there.
fn anchored(point: &Pixels, towards: &Pixels, distance: f64) -> (f64, f64, &'static str) {
    let direction = towards.try_normalize(1e-12).unwrap_or_default();
    let at = point + direction * distance;
    let anchor = match direction.x {
        x if x > 0.35 => "start",
        x if x < -0.35 => "end",
        _ => "middle",
    };
    (at.x, at.y + HALF_HEIGHT * (1.0 + 0.8 * direction.y), anchor)
}

/// How far a run is moved along its line, in pixels: a subscript back under the superscript before it, a power away from the
/// slanted letter before it, which leans over its dots.
fn aside((before, over): &(Style, String), (style, text): &(Style, String)) -> f64 {
    match (before, style) {
        // Less than in the widest fonts: the two stand apart in height.
        (Style::Superscript, Style::Subscript) => {
            -over.chars().map(letter_width).sum::<f64>() * SUBSCRIPT * TEXT_SIZE * 0.9
        }
        (Style::Italic, Style::Upright) if text.starts_with(POWERS) => FROM_LETTER,
        _ => 0.0,
    }
}

/// The dots above a letter whose first, second or third rate of change is meant.
const DOTS: [char; 3] = ['\u{307}', '\u{308}', '\u{20db}'];

/// A letter under so many dots, at most three; without any for the letter itself.
pub(super) fn with_dots(letter: &str, dots: usize) -> String {
    letter.chars().chain(dots.checked_sub(1).and_then(|k| DOTS.get(k)).copied()).collect()
}

/// Width of a letter over the text's size in a wide font.
fn letter_width(letter: char) -> f64 {
    match letter {
        letter if DOTS.contains(&letter) => 0.0,
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | ' ' | '|' | '²' => 0.34,
        't' | 'f' | 'r' | '(' | ')' | '/' | '-' => 0.4,
        'm' | 'w' | 'M' | 'W' | 'ω' | '−' | '=' | '+' | '×' | '⊥' => 0.84,
        letter if letter.is_uppercase() => 0.7,
        _ => 0.62,
    }
}

/// Text with the characters that mean something in XML written as entities.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
