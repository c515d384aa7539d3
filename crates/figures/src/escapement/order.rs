//! By which power of the step the error falls: on a smooth problem, and on one with a switch.

use super::axes::{blank, decades};
use super::problems::{Errors, errors, observed_order};
use crate::figure::{Figure, Words};
use crate::number::fixed;
use crate::plot::{Curve, Plot, Side};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::path::Path;
use crate::svg::placing::{Place, Placing};
use crate::svg::shape::{DASHED, Shape};
use crate::svg::view::Pixels;
use crate::theme::{DRIVER, FOLLOWER, INK, PAPER, Shade};
use nalgebra::Vector2;

const SIZE: (u32, u32) = (640, 520);
/// The reference lines lie so many times above the errors.
const ABOVE: f64 = 8.0;
/// Digits after the point of an error in the series: the smallest are near the last place of a number of size one.
const DECIMALS: usize = 18;
/// How far labels may stand from their curves, in pixels.
const NEAR: [f64; 5] = [16.0, 22.0, 30.0, 40.0, 54.0];

/// Error over step length of the integrator with steps of one length, on logarithmic axes, with lines of slope 4 and 1.
///
/// The smooth problem is x'' = −x, from 1 at rest to time 4. The one with a switch is x' = 1 before x = s and 2 beyond,
/// from 0 to time 1, and its error the greatest over places of s. Series: the step, both errors.
pub fn order() -> Figure {
    let errors = errors();
    let plot = plot(&errors);
    let mut canvas = plot.canvas();
    draw(&mut canvas, &plot, &errors);

    let [smooth, switched] = [observed_order(&errors, |at| at.smooth), observed_order(&errors, |at| at.switched)]
        .map(|order| fixed(order, 2));
    let columns = [("h", "1"), ("smooth", "1"), ("switch", "1")];
    let rows = errors.iter().map(|at| [at.step, at.smooth, at.switched]);
    let series = Series { decimals: DECIMALS, ..Series::new(columns, rows) };
    let words = Words {
        id: "integrator-order".to_owned(),
        title: "Error over step length, for a smooth problem and for one with a switch".to_owned(),
        description: format!(
            "Two rows of points on logarithmic axes, the step length to the right, the error upwards. The errors of \
             the smooth problem lie along a line of slope 4 (observed: {smooth}), those of the problem with a switch, \
             far above, along one of slope 1 (observed: {switched})."
        ),
        caption: "Half the step, a sixteenth of the error: so it is while the right-hand side is smooth. Where it \
                  switches within a step, half the step gives only half the error, whatever the method's order."
            .to_owned(),
    };
    words.figure(canvas, Kind::Plot, series)
}

fn plot(errors: &[Errors]) -> Plot {
    let steps = || errors.iter().map(|at| at.step);
    let values = || errors.iter().flat_map(|at| [at.smooth, at.switched]).filter(|error| *error > 0.0);
    let level = decades(steps().fold(1.0, f64::min), steps().fold(0.0, f64::max), 1);
    let left = decades(values().fold(1.0, f64::min), 1.0, 2);
    let curve = |value: fn(&Errors) -> f64, shade, dashes| Curve {
        points: errors.iter().map(|at| (at.step, value(at))).filter(|(_, error)| *error > 0.0).collect(),
        side: Side::Left,
        shade,
        dashes,
    };
    let curves = vec![curve(|at| at.switched, DRIVER, Some([10, 6])), curve(|at| at.smooth, FOLLOWER, None)];
    let right = blank(&left);
    Plot { size: SIZE, level, left, right, curves }
}

/// Marks, lines of reference, names.
fn draw(canvas: &mut Canvas, plot: &Plot, errors: &[Errors]) {
    let (right, down) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0));
    let (steps, values) = (&plot.level.range, &plot.left.range);
    let at = |x: f64, y: f64| plot.place(Side::Left, x, y);
    let (corner, end) = (at(steps.start, values.end), at(steps.end, values.start));
    canvas.label(&(corner - down * 26.0), &right, -48.0, &Label::words("error at the end"));
    let foot = Vector2::new((corner.x + end.x) / 2.0, end.y);
    canvas.label(&foot, &down, 50.0, &Label::words("step ").and_symbol("h"));
    let mut placing = Placing::within(corner + Vector2::new(6.0, 4.0), end - Vector2::new(6.0, 4.0));
    let (Some(first), Some(last)) = (errors.first(), errors.last()) else { return };
    let references = [(first.switched, 1.0), (first.smooth, 4.0)].map(|(error, slope)| {
        let value = |step: f64| ABOVE * error * libm::pow(step / first.step, slope);
        // As far as the frame goes.
        let share = plot.left.share(value(first.step));
        let top = if share <= 1.0 {
            first.step
        } else {
            first.step * libm::pow(values.end / value(first.step), slope.recip())
        };
        [at(last.step, value(last.step).max(values.start)), at(top, value(top))]
    });
    for [from, to] in &references {
        canvas.draw(Shape::line(from, to).stroke(INK, 1.3).dashed(DASHED).class("slope"));
        placing.avoid(from, to, 1.5);
    }
    for (curve, square) in plot.curves.iter().zip([true, false]) {
        let points: Vec<Pixels> = curve.points.iter().map(|(x, y)| at(*x, *y)).collect();
        placing.avoid_all(&points, 2.0);
        points.iter().for_each(|point| mark(canvas, point, square, curve.shade));
    }
    let labels = [("slope 1", "with a switch", DRIVER), ("slope 4", "smooth", FOLLOWER)];
    for (([from, to], curve), (slope, name, shade)) in references.iter().zip(&plot.curves).zip(labels) {
        let above = |from: &Pixels, to: &Pixels, side: f64| -> Vec<Place> {
            let along = to - from;
            let towards = Vector2::new(along.y, -along.x) * side;
            let places = [0.5, 0.4, 0.6, 0.3, 0.7].into_iter().flat_map(|share| {
                let point = from.lerp(to, share);
                NEAR.map(move |distance| Place { point, towards, distance })
            });
            places.collect()
        };
        placing.put(canvas, &Label::words(slope), above(from, to, 1.0));
        if let [(x, y), .., (u, v)] = curve.points.as_slice() {
            let (start, end) = (at(*u, *v), at(*x, *y));
            placing.put(canvas, &Label::words(name).shade(shade), above(&start, &end, -1.0));
        }
    }
}

/// A point: a square or a circle.
fn mark(canvas: &mut Canvas, at: &Pixels, square: bool, shade: Shade) {
    let shape = if square {
        let corner = |x: f64, y: f64| at + Vector2::new(x, y) * 4.5;
        let path = Path::start(&corner(-1.0, -1.0)).line_to(&corner(1.0, -1.0)).line_to(&corner(1.0, 1.0));
        Shape::path(path.line_to(&corner(-1.0, 1.0)).close())
    } else {
        Shape::circle(at, 5.0)
    };
    canvas.draw(shape.fill(shade).stroke(PAPER, 1.2).class("point"));
}
