//! A vector diagram in numbered steps, the last one larger than the others: how the steps lie on the page.

use super::instant::{cleared, format_with_unit};
use crate::parts::{WIDTH, arrow, draw_number, scale_bar};
use crate::svg::{
    Canvas, DASHED, Label, Pixels, Placing, Shape, View, leader, positions_around, positions_beside_line,
};
use crate::theme::{Colour, INK, PAPER};
use nalgebra::Vector2;

/// The largest that the vectors may be: width and height in pixels.
const ROOM: Pixels = Vector2::new(208.0, 214.0);
/// How many times as large the last step is: its labels, with their values, need room.
const LARGER: f64 = 1.5;
/// Free space above and below the vectors, in pixels: in the small steps and in the last one.
const MARGIN: f64 = 42.0;
const LAST_MARGIN: f64 = 52.0;
/// From line to line of a step's words, and from their first line to the top of the step.
const LINE: f64 = 34.0;
const FIRST_LINE: f64 = 22.0;
/// Left of a step's number, and of its words.
const NUMBER: f64 = 20.0;
const WORDS: f64 = 40.0;
/// How far a line of known direction goes beyond its ends, in pixels.
const BEYOND: f64 = 36.0;
/// A vector of fewer pixels is not drawn.
const SHORTEST: f64 = 1.0;
const SCALE_BAR: f64 = 48.0;
/// How far the vectors of the last step may stand from the middle, in pixels.
const SHIFTS: [f64; 5] = [0.0, -40.0, 40.0, -80.0, 80.0];
/// How far labels may stand from their vectors, in pixels.
const NEAR: [f64; 7] = [10.0, 16.0, 24.0, 36.0, 52.0, 72.0, 96.0];

/// One vector of a diagram.
#[derive(Clone, Debug)]
pub(super) struct DiagramArrow {
    /// Its class in the drawing.
    pub name: &'static str,
    /// Its symbol.
    pub symbol: Label,
    /// Where it begins, from the pole.
    pub tail: Vector2<f64>,
    /// The vector.
    pub vector: Vector2<f64>,
    /// Its colour.
    pub colour: Colour,
    /// Why it is zero, where it is.
    pub if_zero: &'static str,
}

/// A line of known direction on which a vector of unknown length ends.
#[derive(Clone, Debug)]
pub(super) struct Direction {
    /// Its class in the drawing.
    pub name: &'static str,
    /// A few words beside it.
    pub words: &'static str,
    /// Where it begins.
    pub from: Vector2<f64>,
    /// Unit vector along it.
    pub along: Vector2<f64>,
    /// Where it meets the other one.
    pub meeting: Vector2<f64>,
    /// Its colour.
    pub colour: Colour,
}

/// One step: its words, and how much of the diagram has been drawn by then.
#[derive(Clone, Debug)]
pub(super) struct DiagramStep {
    /// Lines of words.
    pub words: Vec<Label>,
    /// So many of the vectors.
    pub arrows: usize,
    /// Whether the two directions are drawn.
    pub directions: bool,
}

/// A diagram with its steps. The last one has the whole width, and the values.
#[derive(Clone, Debug)]
pub(super) struct Diagram {
    /// The vectors, in the order of drawing.
    pub arrows: Vec<DiagramArrow>,
    /// The two directions that close the diagram.
    pub directions: [Direction; 2],
    /// The steps but for the last, in pairs.
    pub steps: Vec<DiagramStep>,
    /// Words of the last step.
    pub closing: Vec<Label>,
    /// Unit of the vectors.
    pub unit: String,
}

impl Diagram {
    /// The steps in two columns, the last one across both and larger, each with its scale bar.
    pub(super) fn draw(&self) -> Canvas {
        let ends = self.arrows.iter().flat_map(|at| [at.tail, at.tail + at.vector]);
        let fitted = View::fitting(ends.clone(), ROOM, Pixels::zeros());
        let (scale, y) = (fitted.scale, |end: Vector2<f64>| end.y * fitted.scale);
        let drawn = ends.clone().map(y).fold(0.0, f64::max) - ends.map(y).fold(0.0, f64::min);
        let drawn = drawn.max(40.0);
        let view = |x: f64, y: f64, larger: f64| View {
            origin: fitted.origin * larger + Vector2::new(x, y),
            scale: scale * larger,
        };

        let closing = self.closing_step(scale);
        let rows: Vec<f64> = self.steps.chunks(2).map(|row| head(row) + drawn + 2.0 * MARGIN).collect();
        let top: f64 = rows.iter().sum::<f64>() + SCALE_BAR;
        let last = head(std::slice::from_ref(&closing));
        let height = top + last + LARGER * drawn + 2.0 * LAST_MARGIN + SCALE_BAR;
        let mut canvas = Canvas::new(WIDTH, height);
        let mut above = 0.0;
        for (row, steps) in self.steps.chunks(2).enumerate() {
            let bottom = above + rows.get(row).copied().unwrap_or_default();
            for (column, step) in steps.iter().enumerate() {
                let left = WIDTH / 2.0 * column as f64;
                let centre = (left + WIDTH / 4.0, bottom - MARGIN - drawn / 2.0);
                let number = 2 * row + column + 1;
                let corners = [Vector2::new(left, above), Vector2::new(left + WIDTH / 2.0, bottom)];
                self.step(&mut canvas, step, number, corners, &view(centre.0, centre.1, 1.0), false);
            }
            above = bottom;
        }
        let count = self.steps.len();
        let bar = |canvas: &mut Canvas, bottom: f64, scale: f64, steps: &str| {
            let start = Vector2::new(NUMBER, bottom - SCALE_BAR / 2.0);
            scale_bar(canvas, &start, scale, false, &format!("{} in step{steps}", self.unit));
        };
        bar(&mut canvas, top, scale, &format!("s 1 {} {count}", if count == 2 { "and" } else { "to" }));
        let bottom = height - SCALE_BAR;
        let corners = [Vector2::new(0.0, top), Vector2::new(WIDTH, bottom)];
        let at = |shift: f64| view(WIDTH / 2.0 + shift, bottom - LAST_MARGIN - LARGER * drawn / 2.0, LARGER);
        let draw = |canvas: &mut Canvas, shift: f64| self.step(canvas, &closing, count + 1, corners, &at(shift), true);
        // Where the labels, which are long here, have most room.
        let cost = |shift: f64| draw(&mut Canvas::new(WIDTH, height), shift);
        let shifts = SHIFTS.map(|shift| (cost(shift), shift));
        let (_, shift) = shifts.into_iter().fold(shifts[0], |best, at| if at.0 < best.0 - 1e-6 { at } else { best });
        draw(&mut canvas, shift);
        bar(&mut canvas, height, scale * LARGER, &format!(" {}", count + 1));
        canvas
    }

    /// The magnitude of the vector of this name, with its unit; zero needs none.
    pub(super) fn value_of(&self, name: &str) -> String {
        let arrow = self.arrows.iter().find(|arrow| arrow.name == name);
        arrow.map_or(String::new(), |arrow| self.written(arrow))
    }

    fn written(&self, arrow: &DiagramArrow) -> String {
        let value = self.value(arrow);
        if value == 0.0 { "0".to_owned() } else { format_with_unit(value, &self.unit) }
    }

    /// The last step: its words, then what is zero and therefore not drawn.
    fn closing_step(&self, scale: f64) -> DiagramStep {
        let mut words = self.closing.clone();
        for arrow in self.arrows.iter().filter(|arrow| arrow.vector.norm() * scale < SHORTEST) {
            let value = self.value(arrow);
            let why = if value == 0.0 { arrow.if_zero } else { "too short to be seen" };
            words.push(arrow.symbol.clone().in_colour(INK).and(&format!(" = {}: {why}", self.written(arrow))));
        }
        DiagramStep { words, arrows: self.arrows.len(), directions: true }
    }

    /// The magnitude of a vector, as it is written.
    fn value(&self, arrow: &DiagramArrow) -> f64 {
        let greatest = self.arrows.iter().map(|arrow| arrow.vector.norm()).fold(0.0, f64::max);
        cleared(arrow.vector.norm(), greatest)
    }

    /// Draws one step between two corners of the page; tells how well its labels are placed, the less the better.
    fn step(
        &self,
        canvas: &mut Canvas,
        step: &DiagramStep,
        number: usize,
        corners: [Pixels; 2],
        at: &View,
        last: bool,
    ) -> f64 {
        let [corner, end] = corners;
        let line = |x: f64, k: usize| corner + Vector2::new(x, FIRST_LINE + LINE * k as f64);
        draw_number(canvas, &line(NUMBER, 0), number);
        for (k, words) in step.words.iter().enumerate() {
            canvas.label(&line(WORDS, k), &Vector2::new(1.0, 0.0), 0.0, &words.clone().bare());
        }
        let below = corner.y + head(std::slice::from_ref(step));
        let mut placing = Placing::new(Vector2::new(corner.x + 6.0, below), end - Vector2::new(6.0, 0.0));
        let arrows: Vec<&DiagramArrow> = self.arrows.iter().take(step.arrows).collect();
        let long = |arrow: &&&DiagramArrow| arrow.vector.norm() * at.scale >= SHORTEST;
        if step.directions {
            for direction in &self.directions {
                let (from, to) = direction.ends(at);
                let line = Shape::line(&from, &to).stroke(direction.colour, 1.3).dashed(DASHED);
                canvas.draw(if last { line.attribute("stroke-opacity", "0.6") } else { line.class(direction.name) });
                placing.avoid(&from, &to, 0.5);
            }
        }
        for (k, drawn) in arrows.iter().enumerate().filter(|(_, arrow)| long(arrow)) {
            let (from, to) = (at.place(&drawn.tail), at.place(&(drawn.tail + drawn.vector)));
            // The first one is the widest: where all lie in one line it is seen behind the others.
            let width = if k == 0 { 4.5 } else { 3.0 };
            arrow(canvas, &from, &to, drawn.colour, width, if last { drawn.name } else { "step" });
            placing.avoid(&from, &to, 1.5);
        }
        let pole = at.place(&Vector2::zeros());
        canvas.draw(Shape::circle(&pole, 4.0).fill(INK).class("pole"));
        placing.take([pole - Vector2::new(5.0, 5.0), pole + Vector2::new(5.0, 5.0)]);
        if step.directions && !last {
            let meeting = at.place(&self.directions[0].meeting);
            canvas.draw(Shape::circle(&meeting, 5.0).stroke(INK, 1.5).fill(PAPER).class("meeting"));
            placing.take([meeting - Vector2::new(5.0, 5.0), meeting + Vector2::new(5.0, 5.0)]);
        }
        for drawn in arrows.iter().filter(long) {
            let (from, to) = (at.place(&drawn.tail), at.place(&(drawn.tail + drawn.vector)));
            let label = drawn.symbol.clone().in_colour(drawn.colour);
            let value = if last { format!(" = {}", self.written(drawn)) } else { String::new() };
            let elsewhere = positions_around(&from.lerp(&to, 0.5), 0.0, &NEAR);
            let places = positions_beside_line(&from, &to, &NEAR).into_iter().chain(elsewhere);
            if let Some(place) = placing.put(canvas, &label.and(&value), places) {
                leader(canvas, &place);
            }
        }
        if step.directions && !last {
            for direction in &self.directions {
                let (from, to) = direction.ends(at);
                let places = positions_beside_line(&from, &to, &[10.0, 16.0, 24.0, 36.0]);
                placing.put(canvas, &Label::words(direction.words).in_colour(direction.colour), places);
            }
        }
        placing.put(canvas, &Label::symbol("o"), positions_around(&pole, 0.0, &[8.0, 12.0, 18.0, 26.0]));
        placing.spent()
    }
}

impl Direction {
    /// The ends of the line as it is drawn: beyond where it begins and where it meets the other.
    fn ends(&self, at: &View) -> (Pixels, Pixels) {
        let along = Vector2::new(self.along.x, -self.along.y) * BEYOND;
        let along = if (self.meeting - self.from).dot(&self.along) < 0.0 { -along } else { along };
        (at.place(&self.from) - along, at.place(&self.meeting) + along)
    }
}

/// Height of the words of a row of steps.
fn head(row: &[DiagramStep]) -> f64 {
    let lines = row.iter().map(|step| step.words.len()).max().unwrap_or_default();
    FIRST_LINE + LINE * lines as f64 - 10.0
}
