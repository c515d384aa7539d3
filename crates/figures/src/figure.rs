//! A figure: the drawing, its words and its numbers.

use crate::series::Series;
use crate::svg::{Canvas, DrawingKind, HALO};
use crate::theme::PAPER;
use std::panic::Location;

/// A drawing with its text alternative, its caption and the numbers it was drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The figure's one name, in lower-case letters and hyphens; the ids inside the SVG begin with it.
    pub id: String,
    /// What the figure is, in a few words.
    pub title: String,
    /// One or two sentences that stand for the drawing where it cannot be seen.
    pub description: String,
    /// What to look at, in a sentence of plain text.
    pub caption: String,
    /// The drawing: one `svg` element without blank lines, one element to a line.
    pub svg: String,
    /// The numbers behind the drawing.
    pub series: Series,
    /// The file that draws it.
    pub source: &'static str,
}

impl Figure {
    /// The drawing as a file of its own, with fixed colours: each custom property, which only a page can set and only a
    /// browser understands, gives way to what stands behind it.
    pub fn standalone(&self) -> String {
        with_fixed_colours(&self.svg) + "\n"
    }

    /// The drawing as it stands on a page whose style sheet has the look of a label's halo (class `halo`, and the outline of
    /// every outlined `text`), so that a page of many drawings doesn't repeat it at each label.
    pub fn on_a_page(&self) -> String {
        let of_paper = format!(" stroke=\"{}\"{HALO}", PAPER.0);
        self.svg.trim_end().replace(&of_paper, " class=\"halo\"").replace(HALO, "")
    }
}

fn with_fixed_colours(svg: &str) -> String {
    let mut parts = svg.split("var(--");
    let mut fixed = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(')').and_then(|(property, rest)| Some((property.split_once(", ")?.1, rest))) {
            Some((colour, rest)) => fixed.extend([colour, rest]),
            None => fixed.extend(["var(--", part]),
        }
    }
    with_mixed_colours(fixed)
}

/// Each mixture of two fixed colours, which other programs than browsers don't know, as one colour.
fn with_mixed_colours(mut svg: String) -> String {
    const MIXTURE: &str = "color-mix(in srgb, ";
    // A mixture may hold another one: the last that begins is the innermost.
    while let Some(start) = svg.rfind(MIXTURE) {
        let Some(length) = svg[start..].find(')') else { return svg };
        let Some(colour) = mixed(&svg[start + MIXTURE.len()..start + length]) else { return svg };
        svg.replace_range(start..=start + length, &colour);
    }
    svg
}

/// The colour that so many per cent of one and the rest of another make: `#ff0000 25%, #ffffff`.
fn mixed(parts: &str) -> Option<String> {
    let (first, below) = parts.split_once(", ")?;
    let (colour, percent) = first.strip_suffix('%')?.split_once(' ')?;
    let share = percent.parse::<f64>().ok()? / 100.0;
    let channel = |colour: &str, at: usize| Some(f64::from(u8::from_str_radix(colour.get(at..at + 2)?, 16).ok()?));
    let mixed = |at| Some((share * channel(colour, at)? + (1.0 - share) * channel(below, at)?).round() as u8);
    Some(format!("#{:02x}{:02x}{:02x}", mixed(1)?, mixed(3)?, mixed(5)?))
}

/// The words of a figure, before it is drawn.
pub(crate) struct Words {
    id: String,
    title: String,
    description: String,
    caption: String,
    source: &'static str,
}

impl Words {
    /// A figure's name, title, description and caption, written in the file that draws it.
    #[track_caller]
    pub(crate) fn new(
        id: impl Into<String>,
        title: impl Into<String>,
        description: impl Into<String>,
        caption: impl Into<String>,
    ) -> Self {
        let source = Location::caller().file();
        let (id, title) = (id.into(), title.into());
        Self { id, title, description: description.into(), caption: caption.into(), source }
    }

    /// The figure that these words, this canvas and these numbers make.
    pub(crate) fn figure(self, canvas: Canvas, kind: DrawingKind, series: Series) -> Figure {
        let svg = canvas.finish(kind, &self.id, &self.title, &self.description);
        let Self { id, title, description, caption, source } = self;
        Figure { id, title, description, caption, svg, series, source }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_the_page_give_way_to_their_fallbacks() {
        let svg = "<g fill=\"var(--a, #111)\" stroke=\"var(--b)\"><path stroke=\"var(--c, #222)\"/></g>";
        assert_eq!(with_fixed_colours(svg), "<g fill=\"#111\" stroke=\"var(--b)\"><path stroke=\"#222\"/></g>");
        assert_eq!(with_fixed_colours("<g/>"), "<g/>");
        let svg = "<text stroke=\"color-mix(in srgb, var(--a, #ff0000) 25%, color-mix(in srgb, var(--b, #000000) \
                   var(--c, 50%), var(--d, #ffffff)))\">";
        assert_eq!(with_fixed_colours(svg), "<text stroke=\"#a06060\">");
        assert_eq!(with_fixed_colours("color-mix(in srgb, red 5%, blue)"), "color-mix(in srgb, red 5%, blue)");
    }
}
