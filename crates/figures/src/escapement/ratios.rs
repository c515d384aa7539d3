//! The follower's speed over the driver's through one engagement.

use super::axes::{blank, style, upright};
use crate::figure::{Figure, Words};
use crate::number::{significant, trimmed};
use crate::plot::{Axis, Curve, Plot, Scale, Side};
use crate::series::{Column, Series};
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use geneva_kinematics::Mechanism;
use geneva_kinematics::wheel::peak_velocity;
use nalgebra::Vector2;

const SIZE: (u32, u32) = (640, 480);
/// Steps from entry to exit; an even number.
const STEPS: u32 = 160;
/// Where the names of the curves begin, in parts of the half angle; length of a piece of curve before a name, and from
/// name to name, in pixels.
const KEY: f64 = 0.16;
const SAMPLE: f64 = 30.0;
const LINE: f64 = 28.0;

/// φ'/θ' of each escapement over θ / (π/m), from entry to exit.
///
/// The mean of each curve is m/n turns of the follower per turn of the driver. The square of the ratio is the weight of
/// the follower's inertia in the kinetic energy: I_D + (φ'/θ')² I_f. Series: θ/(π/m), then for each escapement φ'/θ'
/// and its square.
pub fn ratios(escapements: &[Mechanism]) -> Figure {
    let rows: Vec<Vec<f64>> = (0..=STEPS).map(|k| row(escapements, k)).collect();
    let greatest = escapements.iter().map(|one| peak_velocity(&one.wheel())).fold(0.0, f64::max);
    let left = upright(0.0, greatest.max(1e-3), 4.0);
    let marks = [-2, -1, 0, 1, 2].map(|k| f64::from(k) / 2.0).to_vec();
    let level = Axis { range: -1.0..1.0, marks, decimals: 1, scale: Scale::Even };
    let mut shown: Vec<(usize, &Mechanism)> = Vec::new();
    for (k, one) in escapements.iter().enumerate() {
        // No two curves of a plot have the same colour.
        if shown.iter().all(|(_, other)| *other != one) {
            shown.push((k, one));
        }
    }
    let curve = |(k, one): &(usize, &Mechanism)| {
        let (shade, dashes) = style(one.slots());
        let points = rows.iter().map(|row| (row[0], row[1 + 2 * k])).collect();
        Curve { points, side: Side::Left, shade, dashes }
    };
    let right = blank(&left);
    let plot = Plot { size: SIZE, level, left, right, curves: shown.iter().map(curve).collect() };
    let mut canvas = plot.canvas();
    names(&mut canvas, &plot, &shown);

    let mut columns = vec![("theta/(pi/m)".to_owned(), "1")];
    for one in escapements {
        let n = one.slots();
        columns.extend([(format!("phi'/theta' n={n}"), "1"), (format!("squared n={n}"), "1")]);
    }
    let column = |(name, unit): (String, &str)| Column { name, unit: unit.to_owned() };
    let series = Series { columns: columns.into_iter().map(column).collect(), rows, ..Series::new([("", "")], []) };
    let each: Vec<String> = shown.iter().map(|(_, one)| said(one)).collect();
    let words = Words {
        id: "escapement-ratios".to_owned(),
        title: "The follower's speed over the driver's through one engagement".to_owned(),
        description: format!(
            "Curves over the driver angle in parts of its half angle, from −1, entry, to 1, exit. Each is symmetric, \
             zero at both ends and greatest on the line of centres. {}.",
            each.join("; ")
        ),
        caption: "The follower stands still at every hand-over and is fastest on the line of centres: with few slots \
                  in short bursts, with more slots gently. The mean is m/n, pins over slots."
            .to_owned(),
    };
    words.figure(canvas, Kind::Plot, series)
}

/// θ/(π/m), and for each escapement the ratio and its square.
fn row(escapements: &[Mechanism], k: u32) -> Vec<f64> {
    // Both halves have the same angles.
    let share = (2.0 * f64::from(k) - f64::from(STEPS)) / f64::from(STEPS);
    let ratio = |one: &Mechanism| one.wheel().velocity_ratio(share * one.engagement_half_angle()).unwrap_or_default();
    let both = |ratio: f64| [ratio, ratio * ratio];
    std::iter::once(share).chain(escapements.iter().flat_map(|one| both(ratio(one)))).collect()
}

fn mean(one: &Mechanism) -> String {
    trimmed(f64::from(one.pins()) / f64::from(one.slots()), 3)
}

fn said(one: &Mechanism) -> String {
    let peak = significant(peak_velocity(&one.wheel()), 4);
    format!("{} slots, {} pins: greatest {peak}, mean {}", one.slots(), one.pins(), mean(one))
}

/// Axes, peaks, and the names of the curves with their means.
fn names(canvas: &mut Canvas, plot: &Plot, shown: &[(usize, &Mechanism)]) {
    let (right, down) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0));
    let corner = plot.place(Side::Left, -1.0, plot.left.range.end) - down * 26.0;
    canvas.label(&corner, &right, -48.0, &Label::symbol("φ").and("′ / ").and_symbol("θ").and("\u{200a}′"));
    let foot = plot.place(Side::Left, 0.0, plot.left.range.start);
    let axis = Label::words("driver angle ").and_symbol("θ").and(" / (π/").and_symbol("m").and("): entry −1, exit 1");
    canvas.label(&foot, &down, 50.0, &axis);
    for (k, (_, one)) in shown.iter().enumerate() {
        let (shade, dashes) = style(one.slots());
        let peak = peak_velocity(&one.wheel());
        let at = plot.place(Side::Left, 0.0, peak);
        canvas.draw(Shape::circle(&at, 4.5).fill(shade).class("peak"));
        canvas.label(&at, &-down, 15.0, &Label::words(&significant(peak, 3)).shade(shade));
        // The names stand in the corner, each with a piece of its curve.
        let start = plot.place(Side::Left, KEY, plot.left.range.end) + down * (26.0 + LINE * k as f64);
        let sample = Shape::line(&start, &(start + right * SAMPLE)).stroke(shade, 3.0).class("sample");
        canvas.draw(
            dashes.map_or(sample.clone(), |dashes| sample.dashed(&dashes.map(|length| length.to_string()).join(" "))),
        );
        let name = Label::words(&format!("{} slots: mean {}", one.slots(), mean(one))).shade(shade);
        canvas.label(&(start + right * SAMPLE), &right, 9.0, &name);
    }
}
