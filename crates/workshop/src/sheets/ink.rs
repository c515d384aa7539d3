//! Lines and texts of a sheet in millimetres on paper, from its upper left corner, as SVG.

use crate::geometry::{Point, point_along};
use crate::svg::path_data;
use geneva_kinematics::wheel::{Edge, Loop};
use std::fmt::Write;

/// Height of the digits of a size over the size of its font; widths below are those of Helvetica and Arial.
const CAPITAL: f64 = 0.716;
const DESCENT: f64 = 0.22;

/// Sizes of fonts in millimetres: capitals are 2.5 mm high, the least height of ISO 3098 for A4 and A3 but for its 1.8 mm.
pub(super) const TEXT: f64 = 3.5;
pub(super) const SMALL: f64 = 2.5;

/// Chords of an arc that are kept to find what it crosses.
const CHORDS: u32 = 16;

/// A line's look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pen {
    /// Edges of the part.
    Thick,
    /// Dimensions, leaders, frames.
    Thin,
    /// Axes and circles of centres: long dashes and dots.
    Centre,
    /// Edges behind the part.
    Hidden,
    /// What is filled: arrows.
    Solid,
}

const PENS: [(Pen, &str); 5] = [
    (Pen::Thick, "fill=\"none\" stroke=\"#000\" stroke-width=\"0.5\""),
    (Pen::Thin, "fill=\"none\" stroke=\"#000\" stroke-width=\"0.25\""),
    (Pen::Centre, "fill=\"none\" stroke=\"#000\" stroke-width=\"0.25\" stroke-dasharray=\"6 1 0.5 1\""),
    (Pen::Hidden, "fill=\"none\" stroke=\"#000\" stroke-width=\"0.25\" stroke-dasharray=\"2 1\""),
    (Pen::Solid, "fill=\"#000\""),
];

/// A text that was written, with the room it takes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WrittenText {
    /// Its letters.
    pub text: String,
    /// Its least and its greatest corner, in millimetres.
    pub corners: [Point; 2],
}

/// A drawing as it grows.
#[derive(Clone, Debug, Default)]
pub(super) struct Ink {
    paths: [String; 5],
    letters: String,
    /// The texts.
    pub texts: Vec<WrittenText>,
    /// All straight lines, and chords of the others.
    pub segments: Vec<[Point; 2]>,
}

impl Ink {
    /// A line through points.
    pub(super) fn line(&mut self, pen: Pen, points: &[Point]) {
        self.segments.extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
        let path = &mut self.paths[PENS.iter().position(|(of, _)| *of == pen).unwrap_or(0)];
        for (k, p) in points.iter().enumerate() {
            // Writing to a string cannot fail.
            let _ = write!(path, "{}{} {}", if k == 0 { 'M' } else { 'L' }, number(p.x), number(p.y));
        }
        if pen == Pen::Solid {
            path.push('Z');
        }
    }

    /// A closed line that was moved to its place on paper, whose second axis points down; arcs stay arcs.
    pub(super) fn outline(&mut self, pen: Pen, of: &Loop) {
        let chords = |edge: &Edge| {
            let count = if matches!(edge, Edge::Line { .. }) { 1 } else { CHORDS };
            let edge = *edge;
            let at =
                move |k: u32| point_along(&edge, f64::from(k) / f64::from(count)).component_mul(&Point::new(1.0, -1.0));
            (0..count).map(move |k| [at(k), at(k + 1)])
        };
        self.segments.extend(of.edges.iter().flat_map(chords));
        self.paths[PENS.iter().position(|(of, _)| *of == pen).unwrap_or(0)] += &path_data(of, Point::zeros());
    }

    /// A circle, by its middle on paper.
    pub(super) fn circle(&mut self, pen: Pen, middle: Point, radius: f64) {
        self.outline(pen, &Loop::circle(Point::new(middle.x, -middle.y), radius, true));
    }

    /// A rectangle, by its least and its greatest corner.
    pub(super) fn rectangle(&mut self, pen: Pen, a: Point, b: Point) {
        self.line(pen, &[a, Point::new(b.x, a.y), b, Point::new(a.x, b.y), a]);
    }

    /// An arrow that points at its tip from another place.
    pub(super) fn arrow(&mut self, tip: Point, from: Point) {
        let along = (from - tip).try_normalize(1e-9).unwrap_or(Point::new(1.0, 0.0));
        let (back, aside) = (tip + along * 3.0, Point::new(-along.y, along.x) * 0.5);
        self.line(Pen::Solid, &[tip, back + aside, back - aside]);
    }

    /// A text on its base line, from its left end. It is drawn as wide as it is taken to be, whatever the font.
    pub(super) fn text(&mut self, at: Point, size: f64, text: &str) {
        let width = text_width(text, size);
        let corners = [Point::new(at.x, at.y - CAPITAL * size), Point::new(at.x + width, at.y + DESCENT * size)];
        self.texts.push(WrittenText { text: text.to_owned(), corners });
        let escaped = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let _ = writeln!(
            self.letters,
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" textLength=\"{}\" \
             lengthAdjust=\"spacingAndGlyphs\">{escaped}</text>",
            number(at.x),
            number(at.y),
            number(size),
            number(width),
        );
    }

    /// The drawing's elements.
    pub(super) fn markup(&self) -> String {
        let mut all = String::new();
        for ((_, look), path) in PENS.iter().zip(&self.paths).filter(|(_, path)| !path.is_empty()) {
            let _ = writeln!(all, "<path {look} d=\"{path}\"/>");
        }
        format!("{all}<g font-family=\"Arial, Helvetica, 'Liberation Sans', sans-serif\">\n{}</g>\n", self.letters)
    }
}

/// A number with ten thousandths of a millimetre.
fn number(x: f64) -> String {
    let text = format!("{x:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Width of a text in a font of this size, in millimetres.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().map(letter_width).sum::<f64>() * size
}

/// Width of a letter over the size of its font, as in Helvetica and Arial.
fn letter_width(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' => 0.222,
        ' ' | '.' | ',' | ':' | ';' | '/' | 't' | 'f' | 'I' => 0.278,
        'r' | '(' | ')' | '-' => 0.333,
        'c' | 'k' | 's' | 'v' | 'x' | 'y' | 'z' | 'J' => 0.5,
        '+' | '−' | '×' | '±' | '=' => 0.584,
        'F' | 'T' | 'Z' => 0.611,
        'A' | 'B' | 'E' | 'K' | 'P' | 'S' | 'V' | 'X' | 'Y' => 0.667,
        'w' | 'C' | 'D' | 'H' | 'N' | 'R' | 'U' => 0.722,
        'G' | 'O' | 'Q' | 'Ø' => 0.778,
        'm' | 'M' => 0.833,
        'W' => 0.944,
        '°' => 0.4,
        _ => 0.556,
    }
}

/// A text in lines of at most this width, in millimetres.
pub(super) fn wrapped(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width(line, size) + text_width(" ", size) + text_width(word, size) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
