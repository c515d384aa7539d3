//! Curves over axes: plotters draws the frame, the grid and the curves; labels are ours.
//!
//! plotters counts whole pixels, so it draws ten times larger inside a group that is scaled down. Its fixed colours
//! are replaced afterwards. Names of axes and curves have symbols and subscripts, which it does not set: the caller
//! labels the finished plot.

use crate::number::{fixed, power_of_ten, trimmed, with_minus_sign};
use crate::svg::canvas::Canvas;
use crate::svg::label::{TEXT_SIZE, escape};
use crate::svg::view::Pixels;
use crate::theme::{GRID, INK, Shade, resolve};
use nalgebra::Vector2;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::prelude::*;
use std::ops::Range;

/// How many times larger plotters draws.
const ENLARGED: u32 = 10;
/// plotters writes a font's size divided by this.
const WRITTEN_SMALLER: f64 = 1.24;
/// The size to ask plotters for.
const FONT_SIZE: f64 = TEXT_SIZE * WRITTEN_SMALLER * ENLARGED as f64;
/// Room at the left and the right of the frame, in pixels: for the marks' numbers.
const SIDE: u32 = 66;
/// Room above and below the frame, in pixels: for the names of the axes.
const ABOVE: u32 = 44;
const BELOW: u32 = 70;
/// From an upright axis to the marks' numbers, in pixels.
const GAP: u32 = 12;
/// The part of the room below that the marks' numbers take, in pixels.
const LEVEL_MARKS: u32 = 40;

/// One axis: what it covers, and the marks on it.
#[derive(Clone, Debug)]
pub struct Axis {
    /// From the least to the greatest value.
    pub range: Range<f64>,
    /// Where the marks are.
    pub marks: Vec<f64>,
    /// Digits after the point of the marks' numbers; at most so many where the scale is logarithmic.
    pub decimals: usize,
    /// How its values are spaced.
    pub scale: Scale,
}

/// How the values of an axis are spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences, equal lengths.
    Even,
    /// Equal ratios, equal lengths; only for values above zero.
    Logarithmic,
    /// The same, with marks at powers of ten that are written as such.
    Decades,
    /// Equal ratios, equal lengths to either side of zero; near it, below a half, equal differences: arsinh(2 x).
    Signed,
}

impl Axis {
    /// How far along the axis a value lies: 0 at its start, 1 at its end.
    pub fn share(&self, value: f64) -> f64 {
        let Range { start, end } = self.range;
        match self.scale {
            Scale::Even => (value - start) / (end - start),
            Scale::Logarithmic | Scale::Decades => libm::log(value / start) / libm::log(end / start),
            Scale::Signed => {
                let [low, at, high] = [start, value, end].map(|x| libm::asinh(2.0 * x));
                (at - low) / (high - low)
            }
        }
    }

    /// A mark's number as it is written.
    pub fn written(&self, value: f64) -> String {
        match self.scale {
            Scale::Even => with_minus_sign(&fixed(value, self.decimals)),
            Scale::Logarithmic => trimmed(value, self.decimals),
            Scale::Signed => with_minus_sign(&trimmed(value, self.decimals)),
            Scale::Decades => power_of_ten(value),
        }
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        limit.0 + libm::round(self.share(*value) * f64::from(limit.1 - limit.0)) as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.marks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        self.written(*value)
    }
}

/// Which of the two upright axes a curve is read on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The axis at the left.
    Left,
    /// The axis at the right.
    Right,
}

/// A curve through given points.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Values on the level axis and on the upright one.
    pub points: Vec<(f64, f64)>,
    /// Where its values are read.
    pub side: Side,
    /// Its colour; no two curves of a plot have the same.
    pub shade: Shade,
    /// Its dashes and gaps in pixels; none for an unbroken curve.
    pub dashes: Option<[u32; 2]>,
}

/// Curves over a level axis and two upright ones.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// The level axis.
    pub level: Axis,
    /// The upright axis at the left.
    pub left: Axis,
    /// The upright axis at the right.
    pub right: Axis,
    /// The curves, drawn in this order.
    pub curves: Vec<Curve>,
}

impl Plot {
    /// Where a value of the level axis and one of an upright axis meet on the page.
    pub fn place(&self, side: Side, x: f64, y: f64) -> Pixels {
        let upright = if side == Side::Left { &self.left } else { &self.right };
        let (width, height) =
            (f64::from(self.size.0) - 2.0 * f64::from(SIDE), f64::from(self.size.1) - f64::from(ABOVE + BELOW));
        let (left, top) = (f64::from(SIDE), f64::from(ABOVE));
        Vector2::new(left + self.level.share(x) * width, top + (1.0 - upright.share(y)) * height)
    }

    /// The canvas with frame, grid and curves, ready for labels.
    pub fn canvas(&self) -> Canvas {
        let mut canvas = Canvas::new(f64::from(self.size.0), f64::from(self.size.1));
        match self.draw() {
            Ok(markup) => canvas.draw_markup(markup),
            // A string takes all that is written to it. Should plotters fail all the same, the page says so.
            Err(error) => canvas.draw_markup(format!("<desc>plot failed: {}</desc>", escape(&error.to_string()))),
        }
        canvas
    }

    /// Draws frame, grid and curves on a larger canvas, this far from its corner; with or without the level axis's
    /// numbers, which a plot under this one may have for both.
    pub fn draw_on(&self, canvas: &mut Canvas, corner: &Pixels, numbered: bool) {
        let is_level_number = |line: &&str| line.starts_with("<text") && line.contains("text-anchor=\"middle\"");
        let markup = match self.draw() {
            Ok(markup) if numbered => markup,
            Ok(markup) => markup.lines().filter(|line| !is_level_number(line)).collect::<Vec<_>>().join("\n"),
            Err(error) => format!("<desc>plot failed: {}</desc>", escape(&error.to_string())),
        };
        let place = format!("transform=\"translate({} {})\"", trimmed(corner.x, 2), trimmed(corner.y, 2));
        canvas.group(&place, |canvas| canvas.draw_markup(markup));
    }

    /// plotters' elements, one to a line, in a group that scales them down.
    fn draw(&self) -> Result<String, Box<dyn std::error::Error>> {
        let k = ENLARGED;
        let mut buffer = String::new();
        {
            let root = SVGBackend::with_string(&mut buffer, (self.size.0 * k, self.size.1 * k)).into_drawing_area();
            let font = ("sans-serif", FONT_SIZE).into_font().color(&INK.stand_in);
            let mut chart = ChartBuilder::on(&root)
                .margin_top(ABOVE * k)
                .margin_bottom((BELOW - LEVEL_MARKS) * k)
                .x_label_area_size(LEVEL_MARKS * k)
                .y_label_area_size(SIDE * k)
                .right_y_label_area_size(SIDE * k)
                .build_cartesian_2d(self.level.clone(), self.left.clone())?
                .set_secondary_coord(self.level.clone(), self.right.clone());
            chart
                .configure_mesh()
                .set_all_tick_mark_size(6 * k)
                .label_style(font.clone())
                .axis_style(INK.stand_in.stroke_width(k))
                .bold_line_style(GRID.stand_in.stroke_width(k / 2))
                .light_line_style(TRANSPARENT)
                .draw()?;
            chart
                .configure_secondary_axes()
                .set_all_tick_mark_size(6 * k)
                .label_style(font)
                .axis_style(INK.stand_in.stroke_width(k))
                .draw()?;
            for curve in &self.curves {
                let line = LineSeries::new(curve.points.iter().copied(), curve.shade.stand_in.stroke_width(3 * k));
                match curve.side {
                    Side::Left => chart.draw_series(line)?,
                    Side::Right => chart.draw_secondary_series(line)?,
                };
            }
            root.present()?;
        }
        Ok(self.finished(&buffer))
    }

    /// plotters' output as a group: one element to a line, dashes and colours set, without what says nothing.
    fn finished(&self, svg: &str) -> String {
        let mut elements = format!(
            "<g transform=\"scale({})\" font-size=\"{}\">",
            1.0 / f64::from(ENLARGED),
            TEXT_SIZE * f64::from(ENLARGED)
        );
        // Every text has the same font, in a size that plotters writes with rounding error: the group has it.
        let font = format!(" font-family=\"sans-serif\" font-size=\"{}\"", FONT_SIZE / WRITTEN_SMALLER);
        for element in svg.split('<').skip(1).map(str::trim).filter(|element| !is_frame(element)) {
            // The end of a text stays on its line.
            let lead = if element.starts_with('/') { "<" } else { "\n<" };
            let element = element.replace(" opacity=\"1\"", "").replace(&font, "").replace('\n', "");
            elements += &format!("{lead}{}", self.beside_right_axis(element));
        }
        for curve in &self.curves {
            if let Some(dashes) = curve.dashes {
                let colour = format!("stroke=\"{}\"", curve.shade.stand_in_hex());
                let pattern = dashes.map(|length| (length * ENLARGED).to_string()).join(" ");
                elements = elements.replace(&colour, &format!("{colour} stroke-dasharray=\"{pattern}\""));
            }
        }
        format!("{}\n</g>", resolve(&elements))
    }

    /// The same element; if it is a number beside the right axis that plotters has set flush right, by a guess at its
    /// width that can lie outside the image, then flush left beside the axis.
    fn beside_right_axis(&self, element: String) -> String {
        let start = f64::from((self.size.0 - SIDE) * ENLARGED);
        let written = element.strip_prefix("text x=\"").and_then(|rest| rest.split_once('"'));
        match written.map(|(x, rest)| (x.parse::<f64>(), rest)) {
            Some((Ok(x), rest)) if x > start && rest.contains("text-anchor=\"end\"") => {
                let rest = rest.replace("text-anchor=\"end\"", "text-anchor=\"start\"");
                format!("text x=\"{}\"{rest}", start + f64::from(GAP * ENLARGED))
            }
            _ => element,
        }
    }
}

/// Whether this is the frame of plotters' own image, which the canvas replaces.
fn is_frame(element: &str) -> bool {
    element.is_empty() || element.starts_with("svg") || element.starts_with("/svg")
}
