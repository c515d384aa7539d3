//! Where the 2 of the Coriolis acceleration comes from: a bead on a turning lever at three moments.

use crate::parts::{arc, arc_arrow, arrow, axis, draw_number};
use crate::svg::{Canvas, DrawingKind, Label, Path, Pixels, Sense, Shape, heading};
use crate::theme::{CORIOLIS, FOLLOWER, INK, PAPER, RELATIVE};
use crate::{Figure, Series, Words};
use nalgebra::Vector2;

/// Size of the drawing and where the lever's pivot is, in pixels.
const SIZE: Pixels = Vector2::new(480.0, 402.0);
const PIVOT: Pixels = Vector2::new(20.0, 288.0);
/// What the bead slides in one step, and its distance from the pivot at the middle moment, in pixels.
const SLIDE: f64 = 80.0;
const MIDDLE: f64 = 222.0;
/// The lever's angle at the first moment and what it turns in one step, in radians.
const FIRST: f64 = 0.07;
const TURN: f64 = 0.4;
/// Length of the lever, radius of the bead and width of the strips, in pixels.
const LEVER: f64 = 332.0;
const BEAD: f64 = 7.0;
const STRIP: f64 = 8.0;
/// The first line of the words below, and from line to line.
const WORDS: f64 = 344.0;
const LINE: f64 = 36.0;

/// A bead that slides outwards at constant speed on a lever that turns at constant speed, at three moments.
///
/// Each step of its way is drawn as a slide along the lever and a carry around the pivot. Two strips show what the
/// second step has more than the first, across the lever. Series: a row for each moment; the bead's distance from the
/// pivot over what it slides in a step, the lever's angle, and its coordinates over the same.
pub fn bead_on_a_lever() -> Figure {
    let mut canvas = Canvas::new(SIZE.x, SIZE.y);
    let at = |distance: f64, angle: f64| PIVOT + heading(angle) * distance;
    let [one, two, three] = [0.0, 1.0, 2.0].map(|k| FIRST + k * TURN);
    for angle in [one, two, three] {
        canvas.draw(
            Shape::line(&PIVOT, &at(LEVER, angle)).stroke(INK, 1.2).attribute("stroke-opacity", "0.45").class("lever"),
        );
    }
    steps(&mut canvas, at, [one, two, three]);
    strips(&mut canvas, at, [one, two, three]);
    for (k, angle) in [one, two, three].into_iter().enumerate() {
        let bead = at(MIDDLE + (k as f64 - 1.0) * SLIDE, angle);
        canvas.draw(Shape::circle(&bead, BEAD).fill(PAPER).stroke(INK, 2.0).class("bead"));
        let (side, name) = [(-1.3, "A"), (2.4, "B"), (2.0, "C")][k];
        canvas.label(&bead, &heading(side), 15.0, &Label::words(name));
    }
    axis(&mut canvas, &PIVOT, INK);
    canvas.label(&PIVOT, &heading(-1.6), 20.0, &Label::words("O"));

    let row = |k: f64| {
        let (distance, angle) = (MIDDLE / SLIDE + k - 1.0, FIRST + k * TURN);
        let towards = heading(angle);
        [k, distance, angle.to_degrees(), distance * towards.x, -distance * towards.y]
    };
    let columns = [("moment", "1"), ("r/(v dt)", "1"), ("angle", "deg"), ("x/(v dt)", "1"), ("y/(v dt)", "1")];
    let series = Series::new(columns, [0.0, 1.0, 2.0].map(row));
    let words = Words::new(
        "quick-return-bead",
        "A bead that slides on a turning lever, at three moments",
        "A lever in three positions, equal times Δt apart, with a bead on it that slides outwards, at A, B and C. Each step of \
         the bead is drawn as a slide along the lever by v Δt and a carry around the pivot by the angle ω Δt. Two strips of \
         equal length, both across the lever, show how much farther the second step goes: the slide has turned with the lever, \
         and the carry is longer because the bead is farther out. Each is v Δt times ω Δt.",
        "A bead on a turning lever, at three moments Δt apart. In each step the bead slides along the lever (green), \
         and the lever carries it around the pivot (blue). The dashed line is the first slide, drawn again at B. \
         Across the lever, the second step goes farther than the first by two strips, each v Δt · ω Δt long. The \
         speeds v and ω are constant, and the angles are exaggerated for clarity.",
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

/// From each moment to the next: along the lever, then around the pivot.
fn steps(canvas: &mut Canvas, at: impl Fn(f64, f64) -> Pixels, [one, two, three]: [f64; 3]) {
    for (distance, angle, next) in [(MIDDLE, one, two), (MIDDLE + SLIDE, two, three)] {
        arrow(canvas, &at(distance - SLIDE, angle), &at(distance, angle), RELATIVE, 3.5, "slide");
        let path = Path::start(&at(distance, angle));
        let path = path.arc(distance, false, Sense::CounterClockwise, &at(distance, next));
        canvas.draw(Shape::path(path).stroke(FOLLOWER, 3.5).class("carry"));
        arc_arrow(canvas, &PIVOT, 62.0, angle, next, INK, 1.5);
        let turned = Label::symbol("ω").and(" Δ").and_symbol("t");
        canvas.label(&at(62.0, (angle + next) / 2.0), &heading((angle + next) / 2.0), 6.0, &turned);
    }
    let slid = Label::symbol("v").and(" Δ").and_symbol("t").in_colour(RELATIVE);
    canvas.label(&at(MIDDLE - SLIDE / 2.0, one), &Vector2::new(0.0, 1.0), 15.0, &slid);
    canvas.label(&at(MIDDLE + SLIDE / 2.0, two), &heading(two + 1.57), 12.0, &slid);
    let carried = Label::symbol("r").and("\u{2009}").and_symbol("ω").and(" Δ").and_symbol("t").in_colour(FOLLOWER);
    let right = Vector2::new(1.0, 0.0);
    canvas.label(&at(MIDDLE, one + 0.42 * TURN), &right, 10.0, &carried);
    canvas.label(&at(MIDDLE + SLIDE, two + 0.4 * TURN), &right, 10.0, &carried);
}

/// What the second step has more than the first, and what that is.
fn strips(canvas: &mut Canvas, at: impl Fn(f64, f64) -> Pixels, [one, two, three]: [f64; 3]) {
    let (bead, slid) = (at(MIDDLE, two), at(MIDDLE + SLIDE, two));
    let unturned = bead + heading(one) * SLIDE;
    canvas.draw(Shape::line(&bead, &unturned).stroke(RELATIVE, 2.0).dashed("6 4").class("unturned"));
    canvas.draw(Shape::line(&unturned, &slid).stroke(CORIOLIS, STRIP).class("turned"));
    // Around the pivot as far as in the first step; the rest is the other strip.
    let far = MIDDLE + SLIDE;
    let as_before = two + TURN * MIDDLE / far;
    let path = Path::start(&at(far, as_before)).arc(far, false, Sense::CounterClockwise, &at(far, three));
    canvas.draw(Shape::path(path).stroke(CORIOLIS, STRIP).class("farther"));
    let right = Vector2::new(1.0, 0.0);
    let strips = [unturned.lerp(&slid, 0.5), at(far, (as_before + three) / 2.0)];
    let words = ["the slide turns with the lever", "the carry is longer farther out"];
    for (k, (strip, words)) in strips.iter().zip(words).enumerate() {
        draw_number(canvas, &(strip + right * 24.0), k + 1);
        let length = Label::symbol("v").and(" Δ").and_symbol("t").and(" · ");
        let length = length.and_symbol("ω").and(" Δ").and_symbol("t").in_colour(CORIOLIS);
        canvas.label(strip, &right, 42.0, &length);
        let line = Vector2::new(26.0, WORDS + LINE * k as f64);
        draw_number(canvas, &line, k + 1);
        canvas.label(&(line + right * 24.0), &right, 0.0, &Label::words(words).bare());
    }
    arc(canvas, &bead, 46.0, one, two, INK, 1.2);
}
