//! External, internal and spherical wheels of the same number of stations compared.

use crate::chart::{Chart, ChartAxis, LegendEntry, MarkShape, Marker, Panel};
use crate::number::extent;
use crate::svg::Label;
use crate::theme::{CORIOLIS, Colour, DRIVER, FOLLOWER};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use geneva_kinematics::wheel::Wheel;
use std::ops::RangeInclusive;

/// The kinds with their colours and marks.
const KINDS: [(&str, Colour, MarkShape); 3] = [
    ("external", DRIVER, MarkShape::Disc),
    ("internal", FOLLOWER, MarkShape::Ring),
    ("spherical", CORIOLIS, MarkShape::Diamond),
];
/// Height of a frame in pixels.
const HEIGHT: f64 = 250.0;
/// Marks of the x axis stand so many stations apart.
const EACH: u32 = 3;

/// What is compared of one wheel: dwell, peak acceleration, peak jerk, force of the pin.
type Compared = [f64; 4];

/// Dwell, peak acceleration, peak jerk and the pin's greatest force over the number of stations, for each kind of wheel
/// with one pin.
///
/// The force is that of the inertia alone, without friction, for wheels of one radius: times the wheel's radius, over
/// the moment of inertia and the square of the driver's speed. Series, a row for each N: the four of the external wheel,
/// of the internal one, of the spherical one.
///
/// # Errors
///
/// [`FigureError::Wheel`] for a number of stations that no wheel has.
pub fn kinds(stations: RangeInclusive<u32>) -> Result<Figure, FigureError> {
    let (first, last) = (*stations.start(), *stations.end());
    let rows = stations.map(row).collect::<Result<Vec<_>, FigureError>>()?;
    let symbol =
        |order: usize, power: &str| Label::words("peak ").and_rate("φ", order).and(" / ").and_rate("θ", 1).and(power);
    let panels = [
        Label::words("dwell, of a turn"),
        symbol(2, "²"),
        symbol(3, "³"),
        Label::words("pin force × radius / ").and_symbol("J").and("\u{200a}").and_rate("θ", 1).and("²"),
    ];
    let panels = panels.into_iter().enumerate().map(|(quantity, title)| {
        let marks = (first..=last).filter(|n| n.is_multiple_of(EACH)).map(f64::from);
        let x = ChartAxis::whole(f64::from(first) - 0.7..f64::from(last) + 0.7, marks)
            .titled(Label::words("number of stations ").and_symbol("N"));
        let values = || rows.iter().flat_map(move |(_, kinds)| kinds.iter().map(move |of| of[quantity]));
        let [least, most] = extent(values());
        let y = if quantity == 0 {
            ChartAxis::from_zero(0.0, most, 4.0)
        } else {
            ChartAxis::logarithmic_about(least..most)
        };
        KINDS.iter().enumerate().fold(Panel::new(HEIGHT, &x, &y.titled(title)), |panel, (kind, (_, colour, mark))| {
            let points = rows.iter().map(move |(n, kinds)| (*n, kinds[kind][quantity]));
            panel.marks(points, Marker::new(*colour, *mark).class("point"))
        })
    });
    let key = KINDS.map(|(name, colour, mark)| LegendEntry::marks([Marker::new(colour, mark)], Label::words(name)));
    let columns = KINDS.iter().flat_map(|(name, ..)| {
        ["dwell", "peak phi''/theta'^2", "peak phi'''/theta'^3", "F R/(J theta'^2)"]
            .map(|quantity| (format!("{name} {quantity}"), "1"))
    });
    let columns = std::iter::once(("N".to_owned(), "1")).chain(columns);
    let series = rows.iter().map(|(n, kinds)| std::iter::once(*n).chain(kinds.iter().flatten().copied()).collect());
    let words = Words::new(
        "wheel-kinds",
        format!("External, internal and spherical wheels of {first} to {last} stations compared"),
        "Four charts against the number of stations. The external wheel has the longest dwell, which falls towards half a \
         turn. The spherical wheel always dwells for half a turn. The internal wheel has the shortest dwell, which rises \
         towards half a turn. Peak acceleration, peak jerk and force of the pin fall with the number of stations; with few \
         stations they are by far the greatest for the external wheel, and near each other for the other two.",
        "Three kinds of wheel with one pin and a driver at constant speed, compared by dwell, peak acceleration, peak \
         jerk (apart from the ends, where the acceleration jumps) and the pin's greatest force. The force is multiplied by the wheel's \
         radius and divided by the moment of inertia and the square of the driver's speed. Rigid parts, no play, no \
         friction.",
    );
    Ok(Chart::new(panels).in_columns(2).key(key).figure(words, Series::of_columns(columns, series.collect())))
}

/// The number of stations, and what is compared of the three kinds.
fn row(stations: u32) -> Result<(f64, [Compared; 3]), FigureError> {
    let (external, internal) = (Wheel::new(stations)?, InternalWheel::new(stations)?);
    let spherical = SphericalWheel::new(stations)?;
    let compared = [
        compared(&external, external.wheel_radius_ratio())?,
        compared(&internal, internal.wheel_radius_ratio())?,
        compared(&spherical, spherical.sphere_radius_ratio())?,
    ];
    Ok((f64::from(stations), compared))
}

fn compared(wheel: &dyn Indexing, radius_ratio: f64) -> Result<Compared, FigureError> {
    let force = WheelLoads::new(wheel, 1.0, 0.0, 1.0)?.pin_moment().driving.value * radius_ratio;
    Ok([wheel.dwell_fraction(), wheel.acceleration_peak().ratio, wheel.jerk_peak().ratio, force])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{assert_drawn, columns};

    #[test]
    fn the_chart_is_drawn_and_its_forces_are_torques_over_arms() {
        let figure = kinds(3..=18).expect("possible");
        assert_drawn(&figure);
        assert!(kinds(2..=5).is_err());
        let names = ["N", "external F R/(J theta'^2)", "internal F R/(J theta'^2)", "spherical F R/(J theta'^2)"];
        for [stations, forces @ ..] in columns(&figure.series, names) {
            let alpha = std::f64::consts::PI / stations;
            let (sin, cos) = libm::sincos(alpha);
            // The greatest torque over the arm, looked for at many angles, from the angle of the wheel alone.
            let force = |radius: f64, end: f64, place: &dyn Fn(f64) -> [f64; 2]| {
                let angle = |crank: f64| {
                    let [x, y] = place(crank);
                    libm::atan2(y, x)
                };
                let h = 1e-4;
                let at = |k: u32| {
                    let crank = -end + h + (end - h) * f64::from(k) / 4000.0;
                    let torque = (angle(crank - h) - 2.0 * angle(crank) + angle(crank + h)) / (h * h);
                    let [x, y] = place(crank);
                    radius * torque / libm::hypot(x, y)
                };
                (0..=4000).map(at).fold(0.0, f64::max)
            };
            let quarter = std::f64::consts::FRAC_PI_2;
            let external = force(cos / sin, quarter - alpha, &|t| [1.0 / sin - libm::cos(t), libm::sin(t)]);
            let internal = force(cos / sin, quarter + alpha, &|t| [1.0 / sin + libm::cos(t), libm::sin(t)]);
            let spherical = force(1.0 / sin, quarter, &|t| [cos / sin, libm::sin(t)]);
            for (drawn, expected) in forces.into_iter().zip([external, internal, spherical]) {
                approx::assert_relative_eq!(drawn, expected, max_relative = 1e-3);
            }
        }
    }
}
