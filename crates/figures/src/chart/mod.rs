//! The grammar of the charts: a figure says what it shows, and the rest is laid out here.
//!
//! A [`Chart`] is a key, and [`Panel`]s one under another or in columns. A panel has axes and layers: areas, curves,
//! marks and lines of reference, all in data of the axes; and names, which find their places by themselves. plotters
//! draws frame, grid, numbers and layers on a [pen](pen::Pen) that writes our SVG.

mod axis;
mod frame;
mod look;
mod names;
mod panel;
mod pen;
mod trace;

pub(crate) use axis::{AxisScale, ChartAxis};
pub(crate) use look::{LineStyle, MarkShape, Marker, kind, of_mechanism};
pub(crate) use names::Spot;
pub(crate) use panel::{NUMBER_ROOM, Panel};

use crate::svg::{Canvas, DrawingKind, Label, Pixels, Shape, escape};
use crate::{Figure, Series, Words};
use look::draw_marks;
use nalgebra::Vector2;
use panel::PanelColumn;

/// Width of a figure, in pixels.
const WIDTH: f64 = 640.0;
/// From line to line of the key, and from the left side to it, in pixels.
const LINE: f64 = 28.0;
const LEFT: f64 = 16.0;
/// Room below all, in pixels.
const BOTTOM_MARGIN: f64 = 6.0;
/// Length of a piece of curve in the key, room of a mark, and from either to its name.
const PIECE: f64 = 44.0;
const MARK: f64 = 15.0;
const GAP: f64 = 9.0;

/// An entry of a chart's key: a piece of a curve, marks, and what they stand for.
#[derive(Clone, Debug)]
pub(crate) struct LegendEntry {
    stroke: Option<LineStyle>,
    markers: Vec<Marker>,
    label: Label,
}

impl LegendEntry {
    /// A curve and what it stands for.
    pub(crate) fn curve(stroke: LineStyle, label: Label) -> Self {
        Self { stroke: Some(stroke), markers: Vec::new(), label }
    }

    /// Marks and what they stand for.
    pub(crate) fn marks(markers: impl IntoIterator<Item = Marker>, label: Label) -> Self {
        Self { stroke: None, markers: markers.into_iter().collect(), label }
    }

    /// A curve with marks on it, and what they stand for.
    pub(crate) fn curve_with_marks((stroke, marker): (LineStyle, Marker), label: Label) -> Self {
        Self { stroke: Some(stroke), markers: vec![marker], label }
    }

    /// Words alone.
    pub(crate) fn words(label: Label) -> Self {
        Self { stroke: None, markers: Vec::new(), label }
    }

    fn sample(&self) -> f64 {
        if self.stroke.is_some() { PIECE } else { MARK * self.markers.len() as f64 }
    }

    fn width(&self) -> f64 {
        self.sample() + self.label.width() + 2.0 * GAP
    }

    fn draw(&self, canvas: &mut Canvas, at: &Pixels) {
        let right = Vector2::new(1.0, 0.0);
        if let Some(stroke) = &self.stroke {
            canvas.draw(stroke.class("sample").apply_to(Shape::line(at, &(at + right * PIECE))));
        }
        let pitch = self.sample() / self.markers.len().max(1) as f64;
        for (k, marker) in self.markers.iter().enumerate() {
            draw_marks(canvas, &[at + right * (pitch * (k as f64 + 0.5))], &marker.class("sample"));
        }
        canvas.label(&(at + right * self.sample()), &right, GAP, &self.label.clone().bare());
    }
}

/// What a figure with axes shows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Chart {
    key: Vec<LegendEntry>,
    panels: Vec<Panel>,
    columns: usize,
}

impl Chart {
    /// Panels one under another.
    pub(crate) fn new(panels: impl IntoIterator<Item = Panel>) -> Self {
        Self { panels: panels.into_iter().collect(), ..Self::default() }
    }

    /// Sets the panels row by row in so many columns.
    pub(crate) fn in_columns(self, columns: usize) -> Self {
        Self { columns, ..self }
    }

    /// What curves and marks stand for, above the panels.
    pub(crate) fn key(self, entries: impl IntoIterator<Item = LegendEntry>) -> Self {
        Self { key: entries.into_iter().collect(), ..self }
    }

    /// The figure with its words and the numbers behind it.
    pub(crate) fn figure(self, words: Words, series: Series) -> Figure {
        let places = self.key_places();
        let head = places.last().map_or(0.0, |at| at.y + LINE / 2.0);
        let rows = || self.panels.chunks(self.columns.max(1));
        let room = |row: &[Panel]| row.iter().map(Panel::room).fold(0.0, f64::max);
        let panels: f64 = rows().map(room).sum();
        let size = Vector2::new(WIDTH, head + panels + BOTTOM_MARGIN);
        let mut canvas = Canvas::new(size.x, size.y);
        for (entry, at) in self.key.iter().zip(&places) {
            entry.draw(&mut canvas, at);
        }
        let mut top = head;
        for row in rows() {
            for (number, panel) in row.iter().enumerate() {
                draw_panel(panel, &mut canvas, size, &PanelColumn::new(number, self.columns, size.x), top);
            }
            top += room(row);
        }
        words.figure(canvas, DrawingKind::Plot, series)
    }

    /// The panels one under another, below what `draw` draws on so much of the page's height.
    pub(crate) fn figure_below(
        self,
        words: Words,
        series: Series,
        above: f64,
        draw: impl FnOnce(&mut Canvas),
    ) -> Figure {
        let height: f64 = self.panels.iter().map(Panel::room).sum();
        let size = Vector2::new(WIDTH, above + height + BOTTOM_MARGIN);
        let mut canvas = Canvas::new(size.x, size.y);
        draw(&mut canvas);
        let mut top = above;
        for panel in &self.panels {
            draw_panel(panel, &mut canvas, size, &PanelColumn::new(0, 1, size.x), top);
            top += panel.room();
        }
        words.figure(canvas, DrawingKind::Plot, series)
    }

    /// Where the entries of the key begin: in equal columns, or one after another if that takes fewer lines.
    fn key_places(&self) -> Vec<Pixels> {
        let room = WIDTH - LEFT;
        let widest = self.key.iter().map(LegendEntry::width).fold(1.0, f64::max);
        let columns = ((room / widest) as usize).clamp(1, self.key.len().max(1));
        let place = |x: f64, line: usize| Vector2::new(LEFT + x, 18.0 + LINE * line as f64);
        let (mut flowing, mut x, mut line) = (Vec::new(), 0.0, 0);
        for width in self.key.iter().map(LegendEntry::width) {
            if x > 0.0 && x + width > room {
                (x, line) = (0.0, line + 1);
            }
            flowing.push(place(x, line));
            x += width + GAP;
        }
        if line + 1 < self.key.len().div_ceil(columns) {
            return flowing;
        }
        (0..self.key.len()).map(|k| place(room / columns as f64 * (k % columns) as f64, k / columns)).collect()
    }
}

/// Nothing that is written can fail. Should plotters fail all the same, the page says so.
fn draw_panel(panel: &Panel, canvas: &mut Canvas, size: Pixels, column: &PanelColumn, top: f64) {
    if let Err(error) = panel.draw(canvas, size, column, top) {
        canvas.draw_markup(format!("<desc>plot failed: {}</desc>", escape(&error.to_string())));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn, number};
    use crate::theme::DRIVER;

    fn figure(chart: Chart) -> Figure {
        chart.figure(Words::new("a", "b", "c", "d"), Series::new([("x", "1")], []))
    }

    fn panel() -> Panel {
        let axis = ChartAxis::whole(0.0..1.0, [0.0, 1.0]);
        Panel::new(200.0, &axis, &axis)
    }

    #[test]
    fn curves_and_marks_end_on_the_frame() {
        let points = [(-1.0, 0.5), (0.5, 0.5), (0.5, 3.0), (0.75, 0.25)];
        let some = figure(Chart::new([panel().curve(points, LineStyle::new(DRIVER)).marks(points, kind(3).1)]));
        assert_drawn(&some);
        let data = ParsedDrawing::parse(&some).elements("curve")[0].attribute("d").expect("a path").to_owned();
        let corners: Vec<f64> = data.split(['M', 'L', ' ']).filter_map(|word| word.parse().ok()).collect();
        let heights: Vec<f64> = corners.iter().skip(1).step_by(2).copied().collect();
        let widths: Vec<f64> = corners.iter().step_by(2).copied().collect();
        // In from the left, out at the top, and in again.
        assert_eq!((data.matches('M').count(), widths[0], heights.len()), (2, 70.0, 5), "{data}");
        assert!(
            heights.iter().all(|y| (22.0..=222.0).contains(y)) && widths.iter().all(|x| (70.0..=570.0).contains(x))
        );
        assert_eq!(
            ParsedDrawing::parse(&some).elements("marks")[0].attribute("d").expect("a path").matches('M').count(),
            2
        );
        for outside in [[(0.2, 2.0), (0.8, 3.0)], [(-0.2, 0.9), (0.1, 1.3)], [(2.0, 0.1), (2.0, 0.9)]] {
            let none = figure(Chart::new([panel().curve(outside, LineStyle::new(DRIVER))]));
            assert_eq!(ParsedDrawing::parse(&none).count("curve"), 0, "{outside:?}");
        }
    }

    #[test]
    fn columns_share_the_width_and_a_row_is_as_high_as_its_highest_panel() {
        let high = |height: f64| {
            let axis = ChartAxis::whole(0.0..1.0, [0.0, 1.0]);
            Panel::new(height, &axis, &axis).curve([(0.0, 0.0), (1.0, 1.0)], LineStyle::new(DRIVER))
        };
        let chart = Chart::new([high(100.0), high(200.0), high(100.0)]).in_columns(2);
        let figure = figure(chart);
        assert_drawn(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        let ends = [0, 1, 2].map(|number| {
            let path = drawing.path("curve", number);
            [path[0], path[path.len() - 1]]
        });
        assert!(ends[0][1].x < ends[1][0].x && ends[1][1].x < WIDTH, "{ends:?}");
        assert!(ends[2][0].x == ends[0][0].x && ends[2][1].y > ends[1][0].y, "{ends:?}");
    }

    #[test]
    fn names_beside_the_frame_keep_apart() {
        let name = |panel: Panel, y: f64| panel.name(Label::words("x"), Spot::Beside(y));
        let figure = figure(Chart::new([[0.5, 0.5, 0.52, 0.0].into_iter().fold(panel(), name)]));
        let drawing = ParsedDrawing::parse(&figure);
        let mut heights: Vec<f64> = drawing.elements("leader").iter().map(|line| number(line, "y2")).collect();
        heights.sort_by(f64::total_cmp);
        assert_eq!(heights.len(), 4);
        assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > 22.0), "{heights:?}");
    }

    #[test]
    fn a_name_that_has_no_room_is_left_out_and_one_on_a_curve_interrupts_it() {
        let curve = [(0.0, 0.5), (0.5, 0.5), (1.0, 0.5)];
        let panel = panel().curve(curve, LineStyle::new(DRIVER)).name(Label::words("on"), Spot::On(curve.to_vec()));
        let figure = figure(Chart::new([panel.name(Label::words("under"), Spot::Free(vec![[0.5, 0.5]]))]));
        let drawing = ParsedDrawing::parse(&figure);
        assert_eq!(drawing.count("ground"), 1);
        assert!(drawing.texts().contains(&"on".to_owned()) && !drawing.texts().contains(&"under".to_owned()));
    }

    #[test]
    fn long_entries_of_a_key_stand_one_under_another() {
        let places = |names: &[&str]| {
            let entries = names.iter().map(|name| LegendEntry::curve_with_marks(kind(0), Label::words(name)));
            Chart::new([]).key(entries).key_places()
        };
        let long = "a name that takes more than half of the width of a figure";
        assert!(places(&["one", "two", "three"]).iter().all(|at| at.y == 18.0));
        assert!(places(&[long, long]).windows(2).all(|pair| pair[0].x == pair[1].x && pair[0].y < pair[1].y));
        assert!(places(&[]).is_empty());
    }
}
