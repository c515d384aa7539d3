//! How the extremes fall with the number of stations.

use crate::figure::{Figure, Words};
use crate::plot::{Axis, Curve, Plot, Scale, Side};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::path::Path;
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{DRIVER, FOLLOWER, PAPER, RELATIVE, Shade};
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use nalgebra::Vector2;
use std::ops::{Range, RangeInclusive};

const SIZE: (u32, u32) = (640, 520);
/// Part of the plot's width, left of the first point, that the curves' names take.
const NAMES: f64 = 0.22;
/// How many marks the level axis has room for.
const MARKS: f64 = 6.0;
/// Columns of the series: peak velocity, peak acceleration, entry acceleration.
const CURVES: [(usize, Shade); 3] = [(7, DRIVER), (5, FOLLOWER), (6, RELATIVE)];

/// Peak velocity, entry acceleration and peak acceleration of the wheel, over the driver's speed and its square, for
/// each number of stations in the range that a wheel can have, with one pin. The upright axis is logarithmic.
///
/// Series, a row for each: N, fractions of motion and of dwell, centre distance and wheel radius in crank radii, peak
/// velocity, entry acceleration, peak acceleration, and the crank angle of that peak.
pub fn extremes(stations: RangeInclusive<u32>) -> Figure {
    let rows: Vec<_> = stations.filter_map(|n| Wheel::new(n).ok()).map(|wheel| row(&wheel)).collect();
    let plot = plot(&rows);
    let mut canvas = plot.canvas();
    for (column, shade) in CURVES {
        for row in &rows {
            mark(&mut canvas, &plot.place(Side::Left, row[0], row[column]), column, shade);
        }
    }
    names(&mut canvas, &plot, &rows);

    let columns = [
        ("N", "1"),
        ("motion", "1"),
        ("dwell", "1"),
        ("l/r", "1"),
        ("wheel/r", "1"),
        ("peak phi'/theta'", "1"),
        ("entry phi''/theta'^2", "1"),
        ("peak phi''/theta'^2", "1"),
        ("theta of peak", "deg"),
    ];
    let [first, last] = [rows.first(), rows.last()].map(|row| row.map_or(0.0, |row| row[0]));
    let words = Words {
        id: "wheel-extremes".to_owned(),
        title: format!("Extremes of velocity and acceleration for {first} to {last} stations"),
        description: format!(
            "Three falling rows of points on a logarithmic axis against the number of stations from {first} to {last}: \
             the peak acceleration falls most, the peak velocity less, and the acceleration at entry, the lowest of \
             the three, least. {}",
            crossing(&rows)
        ),
        caption: "More stations, gentler motion: peak velocity over the driver's speed; peak acceleration and \
                  acceleration at entry over its square. The dotted lines only lead the eye."
            .to_owned(),
    };
    words.figure(canvas, Kind::Plot, Series::new(columns, rows))
}

/// Where the ratio of the peak acceleration comes to lie below that of the peak velocity.
fn crossing(rows: &[[f64; 9]]) -> String {
    match rows.windows(2).find(|pair| pair[0][7] >= pair[0][5] && pair[1][7] < pair[1][5]) {
        Some(pair) => format!("From {} stations on, the first lies below the second.", pair[1][0]),
        None => String::new(),
    }
}

fn row(wheel: &Wheel) -> [f64; 9] {
    let peak = acceleration_peak(wheel);
    [
        f64::from(wheel.stations()),
        wheel.motion_fraction(),
        wheel.dwell_fraction(),
        wheel.centre_distance_ratio(),
        wheel.wheel_radius_ratio(),
        peak_velocity(wheel),
        entry_acceleration(wheel),
        peak.ratio,
        peak.angle.to_degrees(),
    ]
}

fn plot(rows: &[[f64; 9]]) -> Plot {
    let (first, last) = match rows {
        [first, .., last] => (first[0], last[0]),
        [only] => (only[0], only[0] + 1.0),
        [] => (0.0, 1.0),
    };
    let room = (last - first) * NAMES / (1.0 - NAMES - 0.03);
    let each = libm::ceil((last - first) / MARKS).max(1.0) as u32;
    let level = Axis {
        range: first - room..last + 0.03 * (last - first + room),
        marks: rows.iter().map(|row| row[0]).filter(|n| *n == first || (*n as u32).is_multiple_of(each)).collect(),
        decimals: 0,
        scale: Scale::Even,
    };
    let values = || rows.iter().flat_map(|row| CURVES.map(|(column, _)| row[column]));
    let upright = logarithmic(values().fold(f64::INFINITY, f64::min)..values().fold(0.0, f64::max));
    let curve = |(column, shade)| Curve {
        points: rows.iter().map(|row| (row[0], row[column])).collect(),
        side: Side::Left,
        shade,
        dashes: Some([4, 5]),
    };
    Plot { size: SIZE, level, left: upright.clone(), right: upright, curves: CURVES.map(curve).to_vec() }
}

/// A logarithmic axis over whole steps of 1, 2 and 5 times powers of ten that holds all values of the range.
fn logarithmic(values: Range<f64>) -> Axis {
    let steps = (-9..9).flat_map(|k| {
        let decade = format!("1e{k}").parse::<f64>().unwrap_or(1.0);
        [1.0, 2.0, 5.0].map(|m| m * decade)
    });
    let steps: Vec<f64> = steps.collect();
    let low = steps.iter().copied().filter(|step| *step <= values.start).fold(steps[0], f64::max);
    let high = steps.iter().copied().filter(|step| *step >= values.end && *step > low).fold(f64::INFINITY, f64::min);
    let high = if high.is_finite() { high } else { 10.0 * low };
    let marks = steps.into_iter().filter(|step| (low..=high).contains(step)).collect();
    Axis { range: low..high, marks, decimals: 9, scale: Scale::Logarithmic }
}

/// A point of a curve: filled, open, or a diamond.
fn mark(canvas: &mut Canvas, at: &Pixels, column: usize, shade: Shade) {
    let shape = match column {
        7 => Shape::circle(at, 4.5).fill(shade),
        5 => Shape::circle(at, 4.5).stroke(shade, 2.0).fill(PAPER),
        _ => {
            let corner = |x: f64, y: f64| at + Vector2::new(x, y) * 5.5;
            let path = Path::start(&corner(0.0, -1.0)).line_to(&corner(1.0, 0.0)).line_to(&corner(0.0, 1.0));
            Shape::path(path.line_to(&corner(-1.0, 0.0)).close()).fill(shade)
        }
    };
    canvas.draw(shape.class("point"));
}

/// The curves' names before their first points, and the axes'.
fn names(canvas: &mut Canvas, plot: &Plot, rows: &[[f64; 9]]) {
    let (left, down) = (Vector2::new(-1.0, 0.0), Vector2::new(0.0, 1.0));
    if let Some(first) = rows.first() {
        for (column, shade) in CURVES {
            let at = plot.place(Side::Left, first[0], first[column]);
            let (words, symbol) = match column {
                7 => ("greatest", "″ / "),
                5 => ("greatest", "′ / "),
                _ => ("at entry", "″ / "),
            };
            let square = if column == 5 { "\u{200a}′" } else { "\u{200a}′²" };
            let symbol = Label::symbol("φ").and(symbol).and_symbol("θ").and(square).shade(shade);
            canvas.label(&(at - down * 12.0), &left, 14.0, &Label::words(words).shade(shade));
            canvas.label(&(at + down * 12.0), &left, 14.0, &symbol);
        }
    }
    let middle = (plot.level.range.start + plot.level.range.end) / 2.0;
    let foot = plot.place(Side::Left, middle, plot.left.range.start);
    canvas.label(&foot, &down, 50.0, &Label::words("number of stations ").and_symbol("N"));
}
