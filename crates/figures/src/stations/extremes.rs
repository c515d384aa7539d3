//! How the extremes fall with the number of stations.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::svg::Label;
use crate::theme::{Colour, DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, ItemValue, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// Part of the frame's width, left of the first point, that the curves' names take.
const NAMES: f64 = 0.35;
/// How many marks the x axis has room for.
const MARKS: f64 = 6.0;
/// A curve: the quantity, its order, and the curve's colour, mark and name.
type Curve = (ItemValue<Wheel>, usize, Colour, MarkShape, &'static str);

const CURVES: [Curve; 3] = [
    (peak_acceleration, 2, DRIVER, MarkShape::Disc, "peak "),
    (Wheel::peak_velocity, 1, FOLLOWER, MarkShape::Ring, "peak "),
    (Wheel::entry_acceleration, 2, RELATIVE, MarkShape::Diamond, "entry "),
];

/// Peak velocity, entry acceleration and peak acceleration of the wheel, over the driver's speed and its square, for
/// each number of stations in the range that a wheel can have, with one pin. The y axis is logarithmic.
///
/// Series, a row for each: N, fractions of motion and of dwell, centre distance and wheel radius in crank radii, peak
/// velocity, entry acceleration, peak acceleration, and the crank angle of that peak.
pub fn extremes(stations: RangeInclusive<u32>) -> Figure {
    let wheels: Vec<_> = stations.filter_map(|n| Wheel::new(n).ok()).collect();
    let [first, last] = [wheels.first(), wheels.last()].map(|wheel| wheel.map_or(0.0, stations_of));
    let room = (last - first).max(1.0) * NAMES / (1.0 - NAMES);
    let each = libm::ceil((last - first) / MARKS).max(1.0) as u32;
    let marks = wheels.iter().map(stations_of).filter(|n| *n == first || (*n as u32).is_multiple_of(each));
    let x = ChartAxis::whole(first - room..last + 0.06 * room, marks)
        .titled(Label::words("number of stations ").and_symbol("N"));
    let values = || wheels.iter().flat_map(|wheel| CURVES.map(|(value, ..)| value(wheel)));
    let y = ChartAxis::logarithmic_about(values().fold(f64::INFINITY, f64::min)..values().fold(0.0, f64::max))
        .titled(Label::words("over the driver's speed, or over its square"));
    let mut panel = Panel::new(426.0, &x, &y);
    let points = |value: ItemValue<Wheel>| wheels.iter().map(move |wheel| (stations_of(wheel), value(wheel)));
    for (value, _, colour, mark, _) in CURVES {
        panel = panel.curve(points(value), LineStyle::new(colour).wide(2.0).dashed("8 6"));
        panel = panel.marks(points(value), Marker::new(colour, mark).class("point"));
    }
    for (value, order, colour, _, name) in CURVES {
        let power = if order == 1 { "" } else { "²" };
        let label = Label::words(name)
            .and_rate("φ", order)
            .and(" / ")
            .and_rate("θ", 1)
            .and(power)
            .and("\u{a0}")
            .in_colour(colour);
        panel = panel.name_near(points(value).take(1), PI, label);
    }
    let series = Series::of_items(
        &wheels,
        [
            ("N", "1", stations_of),
            ("motion", "1", Wheel::motion_fraction),
            ("dwell", "1", Wheel::dwell_fraction),
            ("l/r", "1", Wheel::centre_distance_ratio),
            ("wheel/r", "1", Wheel::wheel_radius_ratio),
            ("peak phi'/theta'", "1", Wheel::peak_velocity),
            ("entry phi''/theta'^2", "1", Wheel::entry_acceleration),
            ("peak phi''/theta'^2", "1", peak_acceleration),
            ("theta of peak", "deg", |wheel| wheel.acceleration_peak().angle.to_degrees()),
        ],
    );
    let words = Words::new(
        "wheel-extremes",
        format!("Extremes of velocity and acceleration for {first} to {last} stations"),
        format!(
            "Three falling rows of points on a logarithmic axis against the number of stations from {first} to {last}: \
             the peak acceleration falls most, the peak velocity less, and the acceleration at entry, the lowest of \
             the three, least. {}",
            crossing(&wheels)
        ),
        "More stations make the motion gentler. The curves show the wheel's peak speed, divided by the \
         driver's constant speed, and its peak acceleration and the jump of its acceleration at entry, both divided \
         by the square of the driver's speed. The number of stations is an integer, so the dashed lines only join \
         the marks.",
    );
    Chart::new([panel]).figure(words, series)
}

fn stations_of(wheel: &Wheel) -> f64 {
    f64::from(wheel.stations())
}

fn peak_acceleration(wheel: &Wheel) -> f64 {
    wheel.acceleration_peak().ratio
}

/// Where the ratio of the peak acceleration comes to lie below that of the peak velocity.
fn crossing(wheels: &[Wheel]) -> String {
    let below = |wheel: &Wheel| peak_acceleration(wheel) < wheel.peak_velocity();
    match wheels.windows(2).find(|pair| !below(&pair[0]) && below(&pair[1])) {
        Some([_, wheel]) => format!("From {} stations on, the first lies below the second.", wheel.stations()),
        _ => String::new(),
    }
}
