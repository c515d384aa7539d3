//! Text with italic symbols and subscripts, on a halo of the paper's colour.

use super::view::Pixels;
use crate::number::{trimmed, with_minus_sign};
use crate::theme::{INK, PAPER, Shade};

/// Height of the letters of a label, in pixels of the view box.
pub const TEXT_SIZE: f64 = 21.0;
/// Height of a subscript's letters over that of its symbol.
const SUBSCRIPT: f64 = 0.74;
/// How far a subscript stands below the line.
const DROP: f64 = 6.0;
/// Half the height of a digit: from the middle of a label to its base line.
const HALF_HEIGHT: f64 = 0.36 * TEXT_SIZE;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Upright,
    Italic,
    Subscript,
}

/// A line of text made of symbols, subscripts and words.
#[derive(Clone, Debug)]
pub struct Label {
    runs: Vec<(Style, String)>,
    shade: Shade,
    halo: Shade,
    haloed: bool,
}

impl Label {
    /// A label that begins with a symbol, in italics.
    pub fn symbol(letter: &str) -> Self {
        Self::words("").and_symbol(letter)
    }

    /// A label that begins with upright text.
    pub fn words(text: &str) -> Self {
        Self { runs: Vec::new(), shade: INK, halo: PAPER, haloed: true }.and(text)
    }

    /// Adds upright text; hyphens become minus signs.
    pub fn and(mut self, text: &str) -> Self {
        if !text.is_empty() {
            self.runs.push((Style::Upright, with_minus_sign(text)));
        }
        self
    }

    /// Adds a symbol in italics.
    pub fn and_symbol(mut self, letter: &str) -> Self {
        self.runs.push((Style::Italic, letter.to_owned()));
        self
    }

    /// Adds a subscript.
    pub fn sub(mut self, index: &str) -> Self {
        self.runs.push((Style::Subscript, index.to_owned()));
        self
    }

    /// Sets the colour of the letters.
    pub fn shade(mut self, shade: Shade) -> Self {
        self.shade = shade;
        self
    }

    /// Sets the colour of the halo: that of the face the label stands on.
    pub fn on(mut self, halo: Shade) -> Self {
        self.halo = halo;
        self
    }

    /// Leaves out the halo, for a label on a plain face.
    pub fn bare(mut self) -> Self {
        self.haloed = false;
        self
    }

    /// The label's markup, so far from `point` in the direction of `towards` (an offset of any length).
    ///
    /// Sideways the label begins or ends there; above and below it is centred.
    pub fn beside(&self, point: &Pixels, towards: &Pixels, distance: f64) -> String {
        let direction = towards.try_normalize(1e-12).unwrap_or_default();
        let at = point + direction * distance;
        let anchor = match direction.x {
            x if x > 0.35 => "start",
            x if x < -0.35 => "end",
            _ => "middle",
        };
        let base = at.y + HALF_HEIGHT * (1.0 + 0.8 * direction.y);
        self.markup(at.x, base, anchor)
    }

    fn markup(&self, x: f64, base: f64, anchor: &str) -> String {
        let mut spans = String::new();
        let mut lowered = 0.0;
        for (style, text) in &self.runs {
            let wanted = if *style == Style::Subscript { DROP } else { 0.0 };
            let shift =
                if wanted == lowered { String::new() } else { format!(" dy=\"{}\"", trimmed(wanted - lowered, 2)) };
            lowered = wanted;
            let look = match style {
                Style::Upright => String::new(),
                Style::Italic => " font-style=\"italic\"".to_owned(),
                Style::Subscript => format!(" font-size=\"{}\"", trimmed(SUBSCRIPT * TEXT_SIZE, 2)),
            };
            spans += &format!("<tspan{shift}{look}>{}</tspan>", escape(text));
        }
        let halo = if self.haloed {
            format!(" stroke=\"{}\" stroke-width=\"5\" stroke-linejoin=\"round\" paint-order=\"stroke\"", self.halo.css)
        } else {
            String::new()
        };
        format!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\" fill=\"{}\"{halo}>{spans}</text>",
            trimmed(x, 2),
            trimmed(base, 2),
            self.shade.css,
        )
    }
}

/// Text with the characters that mean something in XML written as entities.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
