//! One frame with its axes, and what it shows: areas, curves, marks, lines of reference and names.

use super::axis::ChartAxis;
use super::frame::Frame;
use super::look::{LineStyle, Marker};
use super::names::{Name, Spot, write};
use super::pen::{ENLARGED, Look, Pen, colour};
use crate::parts::arrow;
use crate::svg::{Canvas, Label, Pixels, Placing};
use crate::theme::Colour;
use nalgebra::Vector2;
use plotters::prelude::*;
use std::ops::Range;

/// Room at the left and the right of a frame: for the numbers of the axes; beside another panel, at the right, less.
const SIDE: f64 = 70.0;
const BETWEEN: f64 = 28.0;
/// From the side of a panel to its titles.
const INDENT: f64 = 8.0;
/// Room above a frame: for the title of the y axis; below it for the numbers of the x axis, and for its title.
const ABOVE: f64 = 44.0;
const NUMBERS: f64 = 34.0;
/// Room below a frame whose x axis has no numbers: the lowest number of its y axis ends there.
const UNNUMBERED: f64 = 16.0;
const TITLE: f64 = 36.0;
/// More room below numbers that have no title below them: the next panel's title keeps clear of them.
const APART: f64 = 8.0;
/// From a frame to the middle of the title above it, and how much higher a title with a subscript is.
const TITLE_HEIGHT: f64 = 25.0;
const LIFT: f64 = 6.0;
/// Length of a tick; the numbers are twice as far from the frame.
const TICK: f64 = 6.0;
/// Room of the numbers at the left of a frame, in pixels.
pub(crate) const NUMBER_ROOM: f64 = SIDE - 2.0 * TICK;

/// What is drawn in a frame, in data of its axes.
#[derive(Clone, Debug)]
enum Layer {
    /// A filled area, under the grid.
    Area { corners: Vec<(f64, f64)>, colour: Colour, class: &'static str },
    /// A curve, as far as it lies in the frame.
    Curve { points: Vec<(f64, f64)>, stroke: LineStyle },
    /// Equal marks, as far as they lie in the frame.
    Marks { points: Vec<(f64, f64)>, marker: Marker },
}

/// What becomes infinite for an instant, such as the acceleration in a blow: it leaves the frame.
#[derive(Clone, Copy, Debug)]
struct Impulse {
    x: f64,
    upwards: bool,
    stroke: LineStyle,
}

/// From where to where on the page a panel goes, and its frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PanelColumn {
    panel: [f64; 2],
    frame: [f64; 2],
}

impl PanelColumn {
    /// The column of this number, of so many on a page of this width.
    pub(crate) fn new(number: usize, columns: usize, width: f64) -> Self {
        if columns < 2 {
            return Self { panel: [0.0, width], frame: [SIDE, width - SIDE] };
        }
        let [left, right] = [number, number + 1].map(|k| width * k as f64 / columns as f64);
        Self { panel: [left, right], frame: [left + SIDE, right - BETWEEN] }
    }
}

/// A frame with axes and what it shows, drawn in the order in which it is added; areas lie under the grid.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    height: f64,
    x: ChartAxis,
    left: ChartAxis,
    right: ChartAxis,
    layers: Vec<Layer>,
    impulses: Vec<Impulse>,
    names: Vec<Name>,
}

impl Panel {
    /// An empty frame of this height in pixels.
    pub(crate) fn new(height: f64, x: &ChartAxis, left: &ChartAxis) -> Self {
        let right = left.blank();
        Self {
            height,
            x: x.clone(),
            left: left.clone(),
            right,
            layers: Vec::new(),
            impulses: Vec::new(),
            names: Vec::new(),
        }
    }

    /// Other marks and words at the right: for what belongs to the same heights.
    pub(crate) fn right_axis(self, right: ChartAxis) -> Self {
        Self { right, ..self }
    }

    /// A filled area, given by its corners.
    pub(crate) fn area(
        mut self,
        corners: impl IntoIterator<Item = (f64, f64)>,
        colour: Colour,
        class: &'static str,
    ) -> Self {
        self.layers.push(Layer::Area { corners: corners.into_iter().collect(), colour, class });
        self
    }

    /// A filled area over a range of the x axis, from the foot of the frame to its top.
    pub(crate) fn band(self, range: Range<f64>, colour: Colour, class: &'static str) -> Self {
        let Range { start, end } = self.left.range;
        let corners = [(range.start, start), (range.start, end), (range.end, end), (range.end, start)];
        self.area(corners, colour, class)
    }

    /// A curve, as far as it lies in the frame.
    pub(crate) fn curve(mut self, points: impl IntoIterator<Item = (f64, f64)>, stroke: LineStyle) -> Self {
        self.layers.push(Layer::Curve { points: points.into_iter().collect(), stroke });
        self
    }

    /// Equal marks at points, as far as they lie in the frame.
    pub(crate) fn marks(mut self, points: impl IntoIterator<Item = (f64, f64)>, marker: Marker) -> Self {
        self.layers.push(Layer::Marks { points: points.into_iter().collect(), marker });
        self
    }

    /// An arrow from zero to the top of the frame, or to its foot: what becomes infinite for an instant.
    pub(crate) fn impulse(mut self, x: f64, upwards: bool, stroke: LineStyle) -> Self {
        self.impulses.push(Impulse { x, upwards, stroke });
        self
    }

    /// A line from the foot of the frame to its top.
    pub(crate) fn vertical(self, x: f64, stroke: LineStyle) -> Self {
        let Range { start, end } = self.left.range;
        self.curve([(x, start), (x, end)], stroke)
    }

    /// A line across the frame.
    pub(crate) fn horizontal(self, y: f64, stroke: LineStyle) -> Self {
        let Range { start, end } = self.x.range;
        self.curve([(start, y), (end, y)], stroke)
    }

    /// A name near one of the points, first in this direction (radians, counter-clockwise as seen).
    pub(crate) fn name_near(self, points: impl IntoIterator<Item = (f64, f64)>, first: f64, label: Label) -> Self {
        self.name(label, Spot::Near(points.into_iter().collect(), first))
    }

    /// A name where it may stand.
    pub(crate) fn name(mut self, label: Label, spot: Spot) -> Self {
        self.names.push(Name { label, spot });
        self
    }

    /// The values at the foot of the frame and at its top.
    pub(crate) fn ends(&self) -> [f64; 2] {
        let Range { start, end } = self.left.range;
        [start, end]
    }

    /// The room that it takes, from the line above its frame to the end of what stands below.
    pub(crate) fn room(&self) -> f64 {
        let below = match (self.x.numbered && !self.x.ticks.is_empty(), &self.x.title) {
            (true, Some(_)) => NUMBERS + TITLE,
            (true, None) => NUMBERS + APART,
            (false, Some(_)) => UNNUMBERED + TITLE,
            (false, None) => UNNUMBERED,
        };
        self.above() + self.height + below
    }

    /// Room above the frame: for the title of the y axis.
    fn above(&self) -> f64 {
        if self.left.title.is_some() { ABOVE + self.lift() } else { ABOVE / 2.0 }
    }

    /// How much higher its titles are, so that no subscript touches the highest number.
    fn lift(&self) -> f64 {
        let titles = [&self.left.title, &self.right.title];
        if titles.into_iter().flatten().any(Label::has_subscript) { LIFT } else { 0.0 }
    }

    fn frame(&self, column: &PanelColumn, top: f64) -> Frame {
        let above = self.above();
        let [left, right] = column.frame;
        let corner = Vector2::new(left, top + above);
        let end = Vector2::new(right, top + above + self.height);
        Frame::new([corner, end], &self.x, &self.left)
    }

    /// Draws it on a canvas of this size, in a column, from `top` on.
    pub(crate) fn draw(
        &self,
        canvas: &mut Canvas,
        size: Pixels,
        column: &PanelColumn,
        top: f64,
    ) -> Result<(), Box<dyn std::error::Error + '_>> {
        let frame = self.frame(column, top);
        self.plot(canvas, size, &frame)?;
        self.titles(canvas, column, &frame);
        for (impulse, [from, to]) in self.impulses.iter().zip(self.arrows(&frame)) {
            arrow(canvas, &from, &to, impulse.stroke.colour, impulse.stroke.width, impulse.stroke.class);
        }
        let all = self.placing(&frame, |_| true);
        let off_curves = self.placing(&frame, |curve| !self.is_named(curve));
        write(canvas, &frame, all, off_curves, &self.names);
        Ok(())
    }

    /// Frame, grid, numbers and layers, by plotters.
    fn plot(&self, canvas: &mut Canvas, size: Pixels, frame: &Frame) -> Result<(), Box<dyn std::error::Error + '_>> {
        let looks: Vec<Look> =
            [Look::Frame, Look::Grid].into_iter().chain(self.layers.iter().map(Layer::look)).collect();
        let large = |length: f64| (length * ENLARGED) as u32;
        let [least, greatest] = frame.corners();
        let (below, beside) = (size.y - greatest.y, size.x - greatest.x);
        let root = Pen::new(canvas, size, &looks).into_drawing_area();
        let mut chart = ChartBuilder::on(&root)
            .margin_top(large(least.y))
            .margin_left(large(least.x - SIDE))
            .margin_right(large(beside - beside.min(SIDE)))
            .margin_bottom(large(below - below.min(NUMBERS)))
            .x_label_area_size(large(below.min(NUMBERS)))
            .y_label_area_size(large(SIDE))
            .right_y_label_area_size(large(beside.min(SIDE)))
            .build_cartesian_2d(self.x.clone(), self.left.clone())?
            .set_secondary_coord(self.x.clone(), self.right.clone());
        let number = |k: usize| colour(k + 2);
        for (k, layer) in self.layers.iter().enumerate() {
            if let Layer::Area { corners, .. } = layer {
                chart.draw_series([Polygon::new(corners.clone(), number(k).filled())])?;
            }
        }
        let (axes, grid) = (colour(0), colour(1));
        let mut mesh = chart.configure_mesh();
        if !self.x.grid {
            mesh.disable_x_mesh();
        }
        mesh.set_all_tick_mark_size(large(TICK))
            .axis_style(axes)
            .label_style(("sans-serif", 1).into_font().color(&axes))
            .bold_line_style(grid)
            .light_line_style(TRANSPARENT)
            .draw()?;
        chart
            .configure_secondary_axes()
            .set_all_tick_mark_size(large(TICK))
            .axis_style(axes)
            .label_style(("sans-serif", 1).into_font().color(&axes))
            .draw()?;
        let ends = &self.x.range;
        let top = [ends.start, ends.end].map(|x| (x, self.left.range.end));
        chart.draw_series([PathElement::new(top.to_vec(), axes)])?;
        root.present()?;
        for (k, layer) in self.layers.iter().enumerate() {
            let style = number(k);
            match layer {
                Layer::Area { .. } => {}
                Layer::Curve { points, .. } => {
                    for part in frame.parts(points) {
                        chart.draw_series(LineSeries::new(part, style))?;
                    }
                }
                Layer::Marks { points, .. } => {
                    let inside = points.iter().filter(|(x, y)| frame.contains(&frame.place(*x, *y)));
                    let marks = inside.map(|point| Circle::new(*point, 1, style));
                    chart.draw_series(marks)?;
                }
            }
            root.present()?;
        }
        Ok(())
    }

    fn titles(&self, canvas: &mut Canvas, column: &PanelColumn, frame: &Frame) {
        let [least, greatest] = frame.corners();
        let [left, end] = column.panel;
        let (right, up) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, TITLE_HEIGHT + self.lift()));
        if let Some(title) = &self.left.title {
            canvas.label(&Vector2::new(left + INDENT, least.y - up.y), &right, 0.0, &title.clone().bare());
        }
        if let Some(title) = &self.right.title {
            canvas.label(&Vector2::new(end - INDENT, least.y - up.y), &-right, 0.0, &title.clone().bare());
        }
        if let Some(title) = &self.x.title {
            let foot = Vector2::new((least.x + greatest.x) / 2.0, greatest.y + 50.0);
            canvas.label(&foot, &up, 0.0, &title.clone().bare());
        }
    }

    /// Tail and tip of each impulse.
    fn arrows(&self, frame: &Frame) -> Vec<[Pixels; 2]> {
        let Range { start, end } = self.left.range;
        let arrow = |of: &Impulse| [0.0, if of.upwards { end } else { start }].map(|y| frame.place(of.x, y));
        self.impulses.iter().map(arrow).collect()
    }

    /// Whether a curve has its name on it.
    fn is_named(&self, curve: &[(f64, f64)]) -> bool {
        self.names.iter().any(|name| matches!(&name.spot, Spot::On(points) if points == curve))
    }

    /// What names keep clear of, within the frame: marks, and those of the curves that are asked for.
    fn placing(&self, frame: &Frame, avoided: impl Fn(&[(f64, f64)]) -> bool) -> Placing {
        let [least, greatest] = frame.corners();
        let room = Vector2::new(6.0, 4.0);
        let mut placing = Placing::new(least + room, greatest - room);
        for [from, to] in self.arrows(frame) {
            placing.avoid(&from, &to, 2.0);
        }
        for layer in &self.layers {
            match layer {
                Layer::Area { .. } => {}
                Layer::Curve { points, .. } if !avoided(points) => {}
                Layer::Curve { points, stroke } => {
                    let places: Vec<Pixels> = points.iter().map(|(x, y)| frame.place(*x, *y)).collect();
                    placing.avoid_all(&super::trace::thin_out(&places), if stroke.width < 1.5 { 0.3 } else { 2.0 });
                }
                Layer::Marks { points, marker } => {
                    let room = Vector2::new(1.0, 1.0) * (marker.size / 2.0 + 1.0);
                    for at in points.iter().map(|(x, y)| frame.place(*x, *y)) {
                        placing.take([at - room, at + room]);
                    }
                }
            }
        }
        placing
    }
}

impl Layer {
    fn look(&self) -> Look {
        match self {
            Self::Area { colour, class, .. } => Look::Area(*colour, class),
            Self::Curve { stroke, .. } => Look::Line(*stroke),
            Self::Marks { marker, .. } => Look::Marks(*marker),
        }
    }
}
