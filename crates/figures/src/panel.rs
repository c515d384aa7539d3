//! A plot among others on one canvas, with curves that may share a colour.

use crate::escapement::axes::blank;
use crate::markers::{Mark, marks};
use crate::number::trimmed;
use crate::plot::{Axis, Plot, Side};
use crate::svg::canvas::Canvas;
use crate::svg::label::Label;
use crate::svg::path::Path;
use crate::svg::placing::Placing;
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{GRID, INK, Shade};
use crate::trace::{thinned, within};
use nalgebra::Vector2;

/// Width of a figure of panels, in pixels.
pub const WIDTH: u32 = 640;
/// How much of a panel's margins the next one may take.
const OVERLAP: f64 = 40.0;
/// Length of a tick, and from the middle of a number to its base line, in pixels.
const TICK: f64 = 6.0;
const MIDDLE: f64 = 7.5;
/// Room between the labels beside a frame, in pixels.
const LINE: f64 = 23.0;

/// How a curve looks.
#[derive(Clone, Copy, Debug)]
pub struct Stroke {
    /// Its colour.
    pub shade: Shade,
    /// Its width in pixels.
    pub width: f64,
    /// Its dashes and gaps; none for an unbroken curve.
    pub dashes: Option<&'static str>,
    /// What it is, for pages and tests.
    pub class: &'static str,
}

/// One plot on a canvas with several.
#[derive(Clone, Debug)]
pub struct Panel {
    plot: Plot,
    corner: Pixels,
}

impl Panel {
    /// Panels of these heights, margins included, one under another from `top` on: where each begins, and where the
    /// last ends.
    pub fn stack<const N: usize>(top: f64, heights: [u32; N]) -> ([Pixels; N], f64) {
        let mut y = top;
        let corners = heights.map(|height| {
            let corner = Vector2::new(0.0, y);
            y += f64::from(height) - OVERLAP;
            corner
        });
        (corners, y + OVERLAP)
    }

    /// A panel of a figure's width.
    pub fn new(corner: Pixels, height: u32, level: Axis, left: Axis) -> Self {
        Self::sized(corner, (WIDTH, height), level, left)
    }

    /// A panel of any size, margins included.
    pub fn sized(corner: Pixels, size: (u32, u32), level: Axis, left: Axis) -> Self {
        let right = blank(&left);
        Self { plot: Plot { size, level, left, right, curves: Vec::new() }, corner }
    }

    /// Where values of both axes meet on the page.
    pub fn at(&self, (x, y): (f64, f64)) -> Pixels {
        self.corner + self.plot.place(Side::Left, x, y)
    }

    /// The upper left and the lower right corner of the frame.
    pub fn corners(&self) -> [Pixels; 2] {
        let (level, left) = (&self.plot.level.range, &self.plot.left.range);
        [self.at((level.start, left.end)), self.at((level.end, left.start))]
    }

    /// Draws frame, grid and marks, with or without the numbers of the level axis: in few elements, as a figure has
    /// several panels.
    pub fn draw(&self, canvas: &mut Canvas, numbered: bool) {
        let [least, greatest] = self.corners();
        let level: Vec<(f64, f64)> = self.plot.level.marks.iter().map(|x| (self.at((*x, self.zero())).x, *x)).collect();
        let left: Vec<(f64, f64)> =
            self.plot.left.marks.iter().map(|y| (self.at((self.plot.level.range.start, *y)).y, *y)).collect();
        let corner = |x: f64, y: f64| Vector2::new(x, y);
        let frame = Path::start_rounded(&least, 1).line_to(&corner(least.x, greatest.y)).line_to(&greatest);
        let (mut grid, mut ticks) = (None, frame.line_to(&corner(greatest.x, least.y)));
        let mut line = |from: Pixels, to: Pixels| {
            let begun = grid.take().map_or_else(|| Path::start_rounded(&from, 1), |path: Path| path.again_at(&from));
            grid = Some(begun.line_to(&to));
        };
        for (x, _) in &level {
            line(corner(*x, least.y), corner(*x, greatest.y));
            ticks = ticks.again_at(&corner(*x, greatest.y)).line_by(&corner(0.0, TICK));
        }
        for (y, _) in &left {
            line(corner(least.x, *y), corner(greatest.x, *y));
            ticks = ticks.again_at(&corner(least.x, *y)).line_by(&corner(-TICK, 0.0));
        }
        if let Some(grid) = grid {
            canvas.draw(Shape::path(grid).stroke(GRID, 1.0).class("grid"));
        }
        canvas.draw(Shape::path(ticks).stroke(INK, 1.0).class("axes"));
        let number = |canvas: &mut Canvas, x: f64, y: f64, text: &str| {
            canvas.draw_markup(format!("<text x=\"{}\" y=\"{}\">{text}</text>", trimmed(x, 1), trimmed(y, 1)));
        };
        canvas.group("fill=\"currentColor\" text-anchor=\"end\"", |canvas| {
            left.iter().for_each(|(at, y)| number(canvas, least.x - 12.0, at + MIDDLE, &self.plot.left.written(*y)));
        });
        if numbered {
            canvas.group("fill=\"currentColor\" text-anchor=\"middle\"", |canvas| {
                let below = greatest.y + TICK + 20.0;
                level.iter().for_each(|(at, x)| number(canvas, *at, below, &self.plot.level.written(*x)));
            });
        }
    }

    /// A value of the upright axis that there is.
    fn zero(&self) -> f64 {
        self.plot.left.range.start
    }

    /// Writes the name of the upright axis, above the frame.
    pub fn name(&self, canvas: &mut Canvas, label: &Label) {
        let at = self.corners()[0] - Vector2::new(58.0, 25.0);
        canvas.label(&at, &Vector2::new(1.0, 0.0), 0.0, &label.clone().bare());
    }

    /// Writes the name of the level axis, below its numbers.
    pub fn foot(&self, canvas: &mut Canvas, label: &Label) {
        let [least, greatest] = self.corners();
        canvas.label(
            &Vector2::new((least.x + greatest.x) / 2.0, greatest.y),
            &Vector2::new(0.0, 1.0),
            50.0,
            &label.clone().bare(),
        );
    }

    /// Draws a curve as far as it lies in the frame, and gives its points on the page.
    pub fn curve(&self, canvas: &mut Canvas, points: &[(f64, f64)], stroke: Stroke) -> Vec<Pixels> {
        let places: Vec<Pixels> = points.iter().map(|point| self.at(*point)).collect();
        let frame = self.corners();
        let drawn = thinned(&places);
        let mut path: Option<Path> = None;
        let mut end: Option<Pixels> = None;
        for pair in drawn.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let Some([from, to]) = within(&from, &to, &frame) else { continue };
            let begun = match path {
                Some(path) if end == Some(from) => path,
                Some(path) => path.again_at(&from),
                None => Path::start_rounded(&from, 1),
            };
            path = Some(begun.line_to(&to));
            end = Some(to);
        }
        if let Some(path) = path {
            let shape = Shape::path(path).stroke(stroke.shade, stroke.width).class(stroke.class);
            canvas.draw(match stroke.dashes {
                Some(dashes) => shape.dashed(dashes),
                None => shape,
            });
        }
        let inside = |at: &Pixels| at.x >= frame[0].x && at.x <= frame[1].x && at.y >= frame[0].y && at.y <= frame[1].y;
        places.into_iter().filter(inside).collect()
    }

    /// Draws equal marks at the points, so many pixels wide, on a thin rim of the paper's colour.
    pub fn marks(&self, canvas: &mut Canvas, points: &[(f64, f64)], (shade, mark): (Shade, Mark), size: f64) {
        let places: Vec<Pixels> = points.iter().map(|point| self.at(*point)).collect();
        marks(canvas, &places, (shade, mark), size);
    }

    /// What keeps the labels within the frame.
    pub fn placing(&self) -> Placing {
        let [least, greatest] = self.corners();
        Placing::within(least + Vector2::new(6.0, 4.0), greatest - Vector2::new(6.0, 4.0))
    }

    /// Writes labels to the right of the frame, each as near to the height of its curve's end as the others allow.
    pub fn beside(&self, canvas: &mut Canvas, labels: Vec<(f64, Label, Shade)>) {
        let [least, greatest] = self.corners();
        let mut labels: Vec<(f64, f64, Label, Shade)> =
            labels.into_iter().map(|(value, label, shade)| (self.at((0.0, value)).y, value, label, shade)).collect();
        labels.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut heights: Vec<f64> = labels.iter().map(|(y, ..)| y.clamp(least.y + 8.0, greatest.y - 8.0)).collect();
        for _ in 0..400 {
            for k in 1..heights.len() {
                let close = LINE - (heights[k] - heights[k - 1]);
                if close > 0.0 {
                    heights[k - 1] -= close / 2.0;
                    heights[k] += close / 2.0;
                }
            }
            if let Some(first) = heights.first_mut() {
                *first = first.max(least.y);
            }
            if let Some(last) = heights.last_mut() {
                *last = last.min(greatest.y - 8.0);
            }
        }
        for ((y, _, label, shade), height) in labels.iter().zip(heights) {
            let [from, to] = [Vector2::new(greatest.x + 2.0, *y), Vector2::new(greatest.x + 13.0, height)];
            canvas.draw(Shape::line(&from, &to).stroke(*shade, 1.0).class("leader"));
            canvas.label(&to, &Vector2::new(1.0, 0.0), 3.0, &label.clone().shade(*shade).bare());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::Scale;
    use crate::theme::DRIVER;

    fn panel() -> Panel {
        let axis = Axis { range: 0.0..1.0, marks: vec![0.0, 1.0], decimals: 0, scale: Scale::Even };
        Panel::new(Vector2::new(0.0, 0.0), 300, axis.clone(), axis)
    }

    #[test]
    fn a_curve_ends_on_the_frame() {
        let (panel, mut canvas) = (panel(), Canvas::new(640.0, 300.0));
        let stroke = Stroke { shade: DRIVER, width: 2.0, dashes: None, class: "curve" };
        let [least, greatest] = panel.corners();
        let shown = panel.curve(&mut canvas, &[(-1.0, 0.5), (0.5, 0.5), (0.5, 3.0), (0.75, 0.25)], stroke);
        assert_eq!(shown.len(), 2);
        let svg = canvas.finish(crate::svg::canvas::Kind::Plot, "a", "b", "c");
        let data = svg.lines().find(|line| line.contains("curve")).expect("drawn");
        assert!(data.contains(&format!("M{} {}", least.x, (least.y + greatest.y) / 2.0)), "{data}");
        assert_eq!(data.matches('M').count(), 2, "{data}");
        for outside in [[(0.2, 2.0), (0.8, 3.0)], [(-0.2, 0.9), (0.1, 1.3)], [(2.0, 0.1), (2.0, 0.9)]] {
            let mut canvas = Canvas::new(640.0, 300.0);
            panel.curve(&mut canvas, &outside, stroke);
            assert!(!canvas.finish(crate::svg::canvas::Kind::Plot, "a", "b", "c").contains("curve"), "{outside:?}");
        }
    }

    #[test]
    fn labels_beside_the_frame_keep_apart() {
        let (panel, mut canvas) = (panel(), Canvas::new(640.0, 300.0));
        panel.beside(&mut canvas, [0.5, 0.5, 0.52, 0.0].map(|y| (y, Label::words("x"), DRIVER)).to_vec());
        let svg = canvas.finish(crate::svg::canvas::Kind::Plot, "a", "b", "c");
        let document = roxmltree::Document::parse(&svg).expect("well-formed");
        let lines = crate::checks::named(&document, "leader");
        let mut heights: Vec<f64> = lines.iter().map(|line| crate::checks::number(line, "y2")).collect();
        heights.sort_by(f64::total_cmp);
        assert_eq!(heights.len(), 4);
        assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > LINE - 0.5), "{heights:?}");
    }
}
