//! The lever's angle, angular velocity and angular acceleration over a turn of the crank.

use super::instant::{Instant, written};
use super::panels::{PITCH, corner, plot, rows};
use super::symbols::{alpha, omega};
use crate::figure::{Figure, Words};
use crate::number::{degrees, significant};
use crate::plot::{Plot, Side};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::path::Path;
use crate::svg::placing::{Place, Placing, around};
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{FILL, FOLLOWER, GRID, INK, PAPER};
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn, Strokes};
use nalgebra::Vector2;
use std::f64::consts::PI;

const WIDTH: f64 = 640.0;
/// Room above the first panel: for the words on the strokes.
const HEADER: f64 = 62.0;
/// Room that the panels take, with the name of the common axis.
const PANELS: f64 = 3.0 * PITCH + 68.0;
/// A stroke of fewer pixels is not named at its place.
const NARROWEST: f64 = 50.0;

/// ψ, ω₄ and α₄ over a whole turn of the crank at constant speed, one under another, with the instant in all three.
///
/// Of `drive` only the speed counts, in radians per second. The fast stroke is on a tinted ground, the slow one on a
/// plain one. A lever that turns round and round has half turns instead of strokes. Series, each degree: φ, ψ, ω₄, α₄.
pub fn over_a_turn(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>) -> Figure {
    let drive = Drive::steady(drive.speed);
    let instant = Instant::new(linkage, position, &drive);
    let (strokes, rows) = (linkage.strokes(), rows(linkage, &drive));
    let plots = [1, 2, 3].map(|column| plot(&rows, column));
    let mut canvas = Canvas::new(WIDTH, HEADER + PANELS);
    let last = plots.len() - 1;
    for (k, plot) in plots.iter().enumerate() {
        ground(&mut canvas, plot, &corner(HEADER, k), &strokes);
        plot.draw_on(&mut canvas, &corner(HEADER, k), k == last);
    }
    header(&mut canvas, &plots[0], &strokes);
    let values = values(&instant, &drive, strokes.swing_limit.is_none());
    for (k, (plot, value)) in plots.iter().zip(values).enumerate() {
        name(&mut canvas, plot, k);
        mark(&mut canvas, plot, k, instant.crank_angle.to_degrees(), value, &rows);
    }
    let foot = corner(HEADER, last) + plots[last].place(Side::Left, 180.0, plots[last].left.range.start);
    let axis = Label::words("crank angle ").and_symbol("φ").and(" in degrees");
    canvas.label(&foot, &Vector2::new(0.0, 1.0), 50.0, &axis);

    let (phi, psi) = (degrees(instant.crank_angle), degrees(instant.lever_angle));
    let columns = [("phi", "deg"), ("psi", "deg"), ("omega_4", "rad/s"), ("alpha_4", "rad/s^2")];
    let (stroke, there) = match strokes.swing_limit {
        Some(limit) => ("stroke", format!("swings between −{0} and {0}", degrees(limit))),
        None => ("half turn", "turns round and round, fast while it points away from the crank's axis".to_owned()),
    };
    let words = Words {
        id: "quick-return-turn".to_owned(),
        title: "Motion of the lever over a turn of the crank".to_owned(),
        description: format!(
            "Three curves over the crank angle from 0° to 360°: the lever's angle, its angular velocity and its angular \
             acceleration, at a constant crank speed of {}. The lever {there}. The slow {stroke} takes {} of the crank's \
             turn, the fast one {}{}. At a crank angle of {phi} the lever is at {psi}; its \
             angular velocity is {}, its angular acceleration {}.",
            written(drive.speed, "rad/s"),
            degrees(strokes.slow),
            degrees(strokes.fast),
            ratio(&strokes).map_or(String::new(), |ratio| format!("; their ratio is {ratio}")),
            written(instant.lever_speed(&drive), "rad/s"),
            written(instant.lever_acceleration(&drive), "rad/s²"),
        ),
        caption: format!(
            "A whole turn of the crank at constant speed. Tinted: the fast {stroke}. The line marks the instant of the \
             diagrams."
        ),
    };
    words.figure(canvas, Kind::Panels, Series::new(columns, rows))
}

/// Time of the slow stroke over that of the fast one, if there is a fast one.
fn ratio(strokes: &Strokes) -> Option<String> {
    (strokes.fast > 1e-9).then(|| significant(strokes.time_ratio(), 4))
}

/// Crank angles in degrees at which the fast stroke begins and ends.
fn fast(strokes: &Strokes) -> [f64; 2] {
    let half = strokes.fast.to_degrees() / 2.0;
    [180.0 - half, 180.0 + half]
}

/// The tinted ground of the fast stroke, with its edges.
fn ground(canvas: &mut Canvas, plot: &Plot, corner: &Pixels, strokes: &Strokes) {
    let [begin, end] = fast(strokes);
    let range = &plot.left.range;
    let at = |x: f64, y: f64| corner + plot.place(Side::Left, x, y);
    let outline = Path::start(&at(begin, range.start)).line_to(&at(begin, range.end)).line_to(&at(end, range.end));
    canvas.draw(Shape::path(outline.line_to(&at(end, range.start)).close()).fill(FILL).class("fast"));
    for x in [begin, end] {
        let edge = Shape::line(&at(x, range.start), &at(x, range.end)).stroke(INK, 1.0).dashed("1 4");
        canvas.draw(edge.class("reversal"));
    }
}

/// The two strokes with their crank angles and the time ratio; above the first panel, over their parts, their names.
fn header(canvas: &mut Canvas, plot: &Plot, strokes: &Strokes) {
    let stroke = if strokes.swing_limit.is_some() { "stroke" } else { "half turn" };
    let ratio = ratio(strokes).map_or(String::new(), |ratio| format!(", time ratio {ratio}"));
    let words = format!("Slow {stroke} {}, fast {}{ratio}", degrees(strokes.slow), degrees(strokes.fast));
    let start = Vector2::new(20.0, 20.0);
    canvas.label(&start, &Vector2::new(1.0, 0.0), 0.0, &Label::words(&words).bare());
    let [begin, end] = fast(strokes);
    let x = |phi: f64| plot.place(Side::Left, phi, 0.0).x;
    let row = 54.0;
    for (from, to, name) in [(0.0, begin, "slow"), (begin, end, "fast"), (end, 360.0, "slow")] {
        let ends = [x(from) + 2.0, x(to) - 2.0];
        if ends[1] - ends[0] >= NARROWEST {
            let ends = ends.map(|x| Vector2::new(x, row + 15.0));
            canvas.draw(Shape::line(&ends[0], &ends[1]).stroke(GRID, 2.0).class("stroke"));
            canvas.label(&Vector2::new((ends[0].x + ends[1].x) / 2.0, row), &Pixels::zeros(), 0.0, &Label::words(name));
        }
    }
}

/// ψ in degrees as the curve has it, ω₄ and α₄ at the instant, each with its label.
fn values(instant: &Instant, drive: &Drive<f64>, turns: bool) -> [(f64, Label); 3] {
    let psi = instant.lever_angle.to_degrees();
    let psi = if turns && instant.crank_angle > PI && psi < 0.0 { psi + 360.0 } else { psi };
    let (speed, rate) = (instant.lever_speed(drive), instant.lever_acceleration(drive));
    [
        (psi, Label::symbol("ψ").and(&format!(" = {}", degrees(psi.to_radians())))),
        (speed, omega("4").and(&format!(" = {}", written(speed, "rad/s")))),
        (rate, alpha("4").and(&format!(" = {}", written(rate, "rad/s²")))),
    ]
}

/// The name of a panel's axis, above its left corner.
fn name(canvas: &mut Canvas, plot: &Plot, k: usize) {
    let label = match k {
        0 => Label::symbol("ψ").and(" in degrees"),
        1 => omega("4").and(" in rad/s"),
        _ => alpha("4").and(" in rad/s²"),
    };
    let at = corner(HEADER, k) + plot.place(Side::Left, 0.0, plot.left.range.end) - Vector2::new(58.0, 25.0);
    canvas.label(&at, &Vector2::new(1.0, 0.0), 0.0, &label.shade(FOLLOWER));
}

/// The instant in one panel: an upright, a dot and the value.
fn mark(canvas: &mut Canvas, plot: &Plot, k: usize, phi: f64, (value, label): (f64, Label), rows: &[[f64; 4]]) {
    let corner = corner(HEADER, k);
    let at = |x: f64, y: f64| corner + plot.place(Side::Left, x, y);
    let range = &plot.left.range;
    let (foot, head) = (at(phi, range.start), at(phi, range.end));
    canvas.draw(Shape::line(&foot, &head).stroke(INK, 1.4).dashed("5 4").class("instant"));
    let dot = at(phi, value);
    canvas.draw(Shape::circle(&dot, 5.5).fill(FOLLOWER).stroke(PAPER, 1.5).class("now"));
    let mut placing = Placing::within(at(0.0, range.end), at(360.0, range.start));
    let points: Vec<Pixels> = rows.iter().map(|row| at(row[0], row[k + 1])).collect();
    placing.avoid_all(&points, 2.0);
    placing.avoid(&foot, &head, 0.02);
    let label = label.shade(FOLLOWER);
    let aside = around(&dot, 0.4, &[10.0, 16.0, 24.0, 36.0, 50.0, 66.0]);
    // Above and below the dot, and as far to the side as the frame wants it.
    let half = label.width() / 2.0 + 6.0;
    let level = [0.0, -30.0, 30.0, -60.0, 60.0].into_iter().flat_map(|shift| {
        let x = (dot.x + shift).clamp(at(0.0, value).x + half, at(360.0, value).x - half);
        [-1.0, 1.0].into_iter().flat_map(move |y| {
            let towards = Vector2::new(0.0, y);
            [20.0, 28.0, 38.0, 50.0, 64.0].map(|distance| Place { point: Vector2::new(x, dot.y), towards, distance })
        })
    });
    placing.put(canvas, &label, aside.into_iter().chain(level));
}
