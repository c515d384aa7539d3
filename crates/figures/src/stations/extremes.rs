//! How the extremes fall with the number of stations.

use crate::chart::{Axis, Chart, Mark, Marker, Panel, Stroke};
use crate::svg::Label;
use crate::theme::{Colour, DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// Part of the frame's width, left of the first point, that the curves' names take.
const NAMES: f64 = 0.35;
/// How many marks the x axis has room for.
const MARKS: f64 = 6.0;
/// Columns of the series with their colours, marks and names: peak acceleration, peak velocity, entry acceleration.
const CURVES: [(usize, Colour, Mark, &str); 3] =
    [(7, DRIVER, Mark::Disc, "peak "), (5, FOLLOWER, Mark::Ring, "peak "), (6, RELATIVE, Mark::Diamond, "entry ")];

/// Peak velocity, entry acceleration and peak acceleration of the wheel, over the driver's speed and its square, for
/// each number of stations in the range that a wheel can have, with one pin. The y axis is logarithmic.
///
/// Series, a row for each: N, fractions of motion and of dwell, centre distance and wheel radius in crank radii, peak
/// velocity, entry acceleration, peak acceleration, and the crank angle of that peak.
pub fn extremes(stations: RangeInclusive<u32>) -> Figure {
    let rows: Vec<_> = stations.filter_map(|n| Wheel::new(n).ok()).map(|wheel| row(&wheel)).collect();
    let [first, last] = [rows.first(), rows.last()].map(|row| row.map_or(0.0, |row| row[0]));
    let room = (last - first).max(1.0) * NAMES / (1.0 - NAMES);
    let each = libm::ceil((last - first) / MARKS).max(1.0) as u32;
    let marks = rows.iter().map(|row| row[0]).filter(|n| *n == first || (*n as u32).is_multiple_of(each));
    let x = Axis::whole(first - room..last + 0.06 * room, marks)
        .titled(Label::words("number of stations ").and_symbol("N"));
    let values = || rows.iter().flat_map(|row| CURVES.map(|(column, ..)| row[column]));
    let y = Axis::logarithmic_about(values().fold(f64::INFINITY, f64::min)..values().fold(0.0, f64::max))
        .titled(Label::words("over the driver's speed, or over its square"));
    let mut panel = Panel::new(426.0, &x, &y);
    let points = |column: usize| rows.iter().map(move |row| (row[0], row[column]));
    for (column, colour, mark, _) in CURVES {
        panel = panel.curve(points(column), Stroke::new(colour).wide(2.0).dashed("8 6"));
        panel = panel.marks(points(column), Marker::new(colour, mark).class("point"));
    }
    for (column, colour, _, name) in CURVES {
        let (order, power) = if column == 5 { (1, "") } else { (2, "²") };
        let label = Label::words(name).and_rate("φ", order).and(" / ").and_rate("θ", 1).and(power).in_colour(colour);
        panel = panel.near(points(column).take(1), PI, label);
    }
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
    let words = Words::new(
        "wheel-extremes",
        format!("Extremes of velocity and acceleration for {first} to {last} stations"),
        format!(
            "Three falling rows of points on a logarithmic axis against the number of stations from {first} to {last}: \
             the peak acceleration falls most, the peak velocity less, and the acceleration at entry, the lowest of \
             the three, least. {}",
            crossing(&rows)
        ),
        "More stations make the motion gentler. The wheel's peak speed is divided by the driver's speed, which is \
         constant. The peak acceleration and the jump in acceleration at entry are divided by the square of the \
         driver's speed. The number of stations is an integer, so the dashed lines only join the marks.",
    );
    Chart::new([panel]).figure(words, Series::new(columns, rows))
}

/// Where the ratio of the peak acceleration comes to lie below that of the peak velocity.
fn crossing(rows: &[[f64; 9]]) -> String {
    match rows.windows(2).find(|pair| pair[0][7] >= pair[0][5] && pair[1][7] < pair[1][5]) {
        Some(pair) => format!("From {} stations on, the first lies below the second.", pair[1][0]),
        None => String::new(),
    }
}

fn row(wheel: &Wheel) -> [f64; 9] {
    let peak = wheel.acceleration_peak();
    [
        f64::from(wheel.stations()),
        wheel.motion_fraction(),
        wheel.dwell_fraction(),
        wheel.centre_distance_ratio(),
        wheel.wheel_radius_ratio(),
        wheel.peak_velocity(),
        wheel.entry_acceleration(),
        peak.ratio,
        peak.angle.to_degrees(),
    ]
}
