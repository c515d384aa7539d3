//! What plotters draws on: our SVG itself, in parts of a pixel, in the colours and dashes of the figures.
//!
//! plotters knows whole pixels and fixed colours. So the page is a hundred times larger for it, and a colour is the
//! number of a look in a table: what is drawn with it has that look. Lines of one look are one path.

use super::look::{LineStyle, Marker, draw_marks};
use super::trace::thin_out;
use crate::number::format_trimmed;
use crate::svg::{Canvas, Path, Pixels, Shape, TEXT_SIZE, escape};
use crate::theme::{Colour, GRID, INK};
use nalgebra::Vector2;
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};
use std::convert::Infallible;

/// How many times larger the page is for plotters.
pub(super) const ENLARGED: f64 = 100.0;

/// How something looks.
#[derive(Clone, Debug)]
pub(super) enum Look {
    /// Frame and marks of the axes, and their numbers.
    Frame,
    /// Lines across the frame.
    Grid,
    /// A curve.
    Line(LineStyle),
    /// Marks.
    Marks(Marker),
    /// A filled area of a class.
    Area(Colour, &'static str),
}

/// The number of a look in the table as a colour for plotters.
pub(super) fn colour(number: usize) -> RGBColor {
    let [_, red, green, blue] = u32::try_from(number).unwrap_or_default().to_be_bytes();
    RGBColor(red, green, blue)
}

/// Draws for plotters on a canvas.
pub(super) struct Pen<'a> {
    canvas: &'a mut Canvas,
    size: (u32, u32),
    looks: &'a [Look],
    lines: Vec<(usize, Path)>,
    marks: Vec<(usize, Vec<Pixels>)>,
    numbers: Vec<(&'static str, Vec<String>)>,
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl<'a> Pen<'a> {
    /// A pen with these looks for a canvas of this size in pixels.
    pub(super) fn new(canvas: &'a mut Canvas, size: Pixels, looks: &'a [Look]) -> Self {
        let size = ((size.x * ENLARGED) as u32, (size.y * ENLARGED) as u32);
        Self { canvas, size, looks, lines: Vec::new(), marks: Vec::new(), numbers: Vec::new() }
    }

    fn look(&self, colour: BackendColor) -> Option<(usize, Look)> {
        let (red, green, blue) = colour.rgb;
        let number = u32::from_be_bytes([0, red, green, blue]) as usize;
        let visible = colour.alpha > 0.0;
        self.looks.get(number).filter(|_| visible).map(|look| (number, look.clone()))
    }

    /// Adds a line to the path of its look.
    fn add(&mut self, number: usize, points: &[Pixels]) {
        if self.lines.iter().all(|(known, _)| *known != number) {
            self.lines.push((number, Path::empty(1)));
        }
        let Some((_, path)) = self.lines.iter_mut().find(|(known, _)| *known == number) else { return };
        let begun = std::mem::replace(path, Path::empty(1));
        if let [first, rest @ ..] = points {
            *path = rest.iter().fold(begun.again_at(first), Path::line_to);
        }
    }
}

fn pixels((x, y): BackendCoord) -> Pixels {
    Vector2::new(f64::from(x), f64::from(y)) / ENLARGED
}

impl DrawingBackend for Pen<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    /// Writes what has been drawn since the last time.
    fn present(&mut self) -> Drawn {
        for (number, path) in std::mem::take(&mut self.lines) {
            let shape = Shape::path(path);
            match self.looks.get(number) {
                Some(Look::Grid) => self.canvas.draw(shape.stroke(GRID, 0.8).class("grid")),
                Some(Look::Line(stroke)) => self.canvas.draw(stroke.apply_to(shape)),
                _ => self.canvas.draw(shape.stroke(INK, 1.0).class("axes")),
            }
        }
        for (number, places) in std::mem::take(&mut self.marks) {
            if let Some(Look::Marks(marker)) = self.looks.get(number) {
                draw_marks(self.canvas, &places, marker);
            }
        }
        for (anchor, numbers) in std::mem::take(&mut self.numbers) {
            let attributes = format!("fill=\"{}\" text-anchor=\"{anchor}\"", INK.0);
            self.canvas.group(&attributes, |canvas| numbers.into_iter().for_each(|text| canvas.draw_markup(text)));
        }
        Ok(())
    }

    fn draw_pixel(&mut self, _: BackendCoord, _: BackendColor) -> Drawn {
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Drawn {
        if let Some((number, look)) = self.look(style.color()) {
            let points: Vec<Pixels> = path.into_iter().map(pixels).collect();
            self.add(number, &if matches!(look, Look::Line(_)) { thin_out(&points) } else { points });
        }
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, _: u32, style: &S, _: bool) -> Drawn {
        if let Some((number, _)) = self.look(style.color()) {
            let at = pixels(centre);
            match self.marks.iter_mut().find(|(known, _)| *known == number) {
                Some((_, places)) => places.push(at),
                None => self.marks.push((number, vec![at])),
            }
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, corners: I, style: &S) -> Drawn {
        if let Some((_, Look::Area(colour, class))) = self.look(style.color()) {
            let corners: Vec<Pixels> = corners.into_iter().map(pixels).collect();
            self.canvas.draw(Shape::path(Path::through(&corners, 1)).fill(colour).class(class));
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn {
        if text.is_empty() {
            return Ok(());
        }
        let place = style.anchor();
        let anchor = match place.h_pos {
            HPos::Left => "start",
            HPos::Center => "middle",
            HPos::Right => "end",
        };
        let drop = match place.v_pos {
            VPos::Top => 0.72,
            VPos::Center => 0.36,
            VPos::Bottom => 0.0,
        };
        let base = pixels(at) + Vector2::new(0.0, drop * TEXT_SIZE);
        let (x, y) = (format_trimmed(base.x, 1), format_trimmed(base.y, 1));
        let text = format!("<text x=\"{x}\" y=\"{y}\">{}</text>", escape(text));
        match self.numbers.iter_mut().find(|(known, _)| *known == anchor) {
            Some((_, texts)) => texts.push(text),
            None => self.numbers.push((anchor, vec![text])),
        }
        Ok(())
    }

    /// No font is read. plotters asks only whether numbers at the right of a frame are of one width, and sets those
    /// that are flush left beside the axis.
    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        _: &str,
        _: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        Ok((1, 1))
    }
}
