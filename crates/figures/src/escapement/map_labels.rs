//! What is written on the map of the critical friction.

use super::axes::{along, mark, style};
use super::existence::{Design, STEPS};
use crate::plot::{Plot, Side};
use crate::svg::canvas::Canvas;
use crate::svg::label::Label;
use crate::svg::placing::{Place, Placing, around, leader};
use crate::svg::view::Pixels;
use geneva_kinematics::Mechanism;
use nalgebra::Vector2;

/// How far labels may stand from their points, in pixels.
const NEAR: [f64; 7] = [10.0, 15.0, 22.0, 32.0, 46.0, 64.0, 84.0];

/// Axes, curves, designs.
pub fn names(canvas: &mut Canvas, plot: &Plot, designs: &[&Design]) {
    let (right, down) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0));
    let (inertias, friction) = (&plot.level.range, &plot.left.range);
    let [corner, end] =
        [(inertias.start, friction.end), (inertias.end, friction.start)].map(|(x, y)| plot.place(Side::Left, x, y));
    canvas.label(&(corner - down * 26.0), &right, -48.0, &Label::words("friction ").and_symbol("μ"));
    let axis = Label::words("inertia of the driver over that of the follower, ").and_symbol("I").sub("D");
    let foot = Vector2::new((corner.x + end.x) / 2.0, end.y);
    canvas.label(&foot, &down, 50.0, &axis.and(" / ").and_symbol("I").sub("f"));

    let mut placing = Placing::within(corner + Vector2::new(6.0, 4.0), end - Vector2::new(6.0, 4.0));
    let curves = plot
        .curves
        .iter()
        .map(|curve| -> Vec<Pixels> { curve.points.iter().map(|(x, y)| plot.place(Side::Left, *x, *y)).collect() });
    let curves: Vec<Vec<Pixels>> = curves.collect();
    for points in &curves {
        placing.avoid_all(points, 2.5);
    }
    let at = |design: &Design| plot.place(Side::Left, design.inertia_ratio, design.friction);
    for design in designs {
        let (at, room) = (at(design), Vector2::new(8.0, 8.0));
        mark(canvas, &at, design.mechanism.slots());
        placing.take([at - room, at + room]);
    }
    for (mechanism, points) in Mechanism::ALL.iter().zip(&curves) {
        let label = Label::words(&format!("{} slots", mechanism.slots())).shade(style(mechanism.slots()).0);
        let high: Vec<Pixels> = points.iter().rev().take(STEPS as usize / 2).copied().collect();
        placing.put(canvas, &label, along(&high, &[10.0, 16.0]));
    }
    for design in designs {
        let label = Label::words(&design.name).shade(style(design.mechanism.slots()).0);
        if let Some(place) = placing.put(canvas, &label, around(&at(design), 0.0, &NEAR)) {
            leader(canvas, &place);
        }
    }
    sides(canvas, &mut placing, corner, end - corner);
}

/// What a curve parts: in words, where curves and designs leave room; else the caption says it alone.
fn sides(canvas: &mut Canvas, placing: &mut Placing, corner: Pixels, size: Vector2<f64>) {
    let (above, below) = (["above its curve:", "none or two"], ["below its curve:", "one acceleration"]);
    let mut rows = Vec::new();
    for y in [0.06, 0.1, 0.16, 0.22] {
        rows.push((above, vec![[0.18, y], [0.2, y], [0.24, y]]));
    }
    for y in [0.84, 0.78, 0.9, 0.7, 0.66, 0.6] {
        rows.push((below, vec![[0.78, y], [0.72, y]]));
    }
    // On one line, under designs that take the corner.
    let single = below.join(" ");
    rows.push(([single.as_str(), ""], vec![[0.6, 0.955], [0.5, 0.955]]));
    let mut written = [false; 2];
    for (lines, spots) in rows {
        let done = &mut written[usize::from(lines != above)];
        let labels = lines.map(Label::words);
        for [x, y] in spots {
            let places = [0.0, 26.0].map(|drop| {
                let point = corner + Vector2::new(x * size.x, y * size.y + drop);
                [Place { point, towards: Pixels::zeros(), distance: 0.0 }]
            });
            let wanted = || labels.iter().zip(places).filter(|(label, _)| label.width() > 0.0);
            if !*done && wanted().all(|(label, place)| placing.has_room(label, place)) {
                *done = true;
                for (label, place) in wanted() {
                    placing.put(canvas, label, place);
                }
            }
        }
    }
}
