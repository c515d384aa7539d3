//! What the number of stations decides: the times of moving and dwelling, and the size.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::svg::Label;
use crate::theme::{Colour, DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, FigureError, ItemValue, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::FRAC_PI_2;
use std::ops::RangeInclusive;

/// The curves of a panel: quantity, colour, mark, side of the name, name.
type Curves = [(ItemValue<Wheel>, Colour, MarkShape, f64, &'static str); 2];

const TIMES: Curves = [
    (Wheel::motion_fraction, DRIVER, MarkShape::Disc, -FRAC_PI_2, "the wheel moves"),
    (Wheel::dwell_fraction, FOLLOWER, MarkShape::Square, 0.8, "the wheel dwells"),
];
const SIZES: Curves = [
    (Wheel::centre_distance_ratio, RELATIVE, MarkShape::Diamond, FRAC_PI_2, "centre distance"),
    (Wheel::wheel_radius_ratio, FOLLOWER, MarkShape::Square, -FRAC_PI_2, "wheel radius"),
];

/// The parts of a turn for which the wheel moves and dwells, and its centre distance and radius in crank radii, over the
/// number of stations, with one pin.
///
/// Series: N, parts of motion and of dwell, centre distance, wheel radius.
///
/// # Errors
///
/// [`FigureError::Wheel`] for a number of stations that no wheel has.
pub fn choice(stations: RangeInclusive<u32>) -> Result<Figure, FigureError> {
    let (first, last) = (*stations.start(), *stations.end());
    let wheels = stations.map(Wheel::new).collect::<Result<Vec<_>, _>>()?;
    let number = |wheel: &Wheel| f64::from(wheel.stations());
    let marks = (first..=last).filter(|n| n.is_multiple_of(3)).map(f64::from);
    let x = ChartAxis::whole(f64::from(first) - 0.7..f64::from(last) + 0.7, marks);
    let panel = |curves: &Curves, x: &ChartAxis, title: &str| {
        let values = || curves.iter().flat_map(|(value, ..)| wheels.iter().map(value));
        let y = ChartAxis::from_zero(0.0, values().fold(0.0, f64::max), 4.0).titled(Label::words(title));
        curves.iter().fold(Panel::new(230.0, x, &y), |panel, (value, colour, mark, side, name)| {
            let points = || wheels.iter().map(|wheel| (number(wheel), value(wheel)));
            panel
                .curve(points(), LineStyle::new(*colour).wide(2.0).dashed("8 6"))
                .marks(points(), Marker::new(*colour, *mark).class("point"))
                .name_near(points().skip(wheels.len() / 6), *side, Label::words(name).in_colour(*colour))
        })
    };
    let title = Label::words("number of stations ").and_symbol("N");
    let panels = [
        panel(&TIMES, &x.clone().unnumbered(), "part of a turn of the driver"),
        panel(&SIZES, &x.titled(title), "in crank radii"),
    ];
    let words = Words::new(
        "wheel-choice",
        format!("Times and sizes of wheels with {first} to {last} stations"),
        "Two panels against the number of stations. Above, the part of a turn for which the wheel moves rises towards one \
         half, and the part for which it dwells falls towards one half. Below, centre distance and wheel radius rise nearly in \
         proportion to the number of stations.",
        "Times and sizes of wheels with one pin: more stations make the dwell shorter and, for the same crank, the \
         wheel larger. The number of stations is an integer, so the dashed lines only join the marks.",
    );
    let series = Series::of_items(
        &wheels,
        [
            ("N", "1", number),
            ("motion", "1", Wheel::motion_fraction),
            ("dwell", "1", Wheel::dwell_fraction),
            ("l/r", "1", Wheel::centre_distance_ratio),
            ("wheel/r", "1", Wheel::wheel_radius_ratio),
        ],
    );
    Ok(Chart::new(panels).figure(words, series))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound, columns};

    #[test]
    fn the_wheel_moves_for_the_rest_of_its_dwell_and_a_wheel_of_two_stations_is_refused() {
        for stations in [3..=18, 4..=9] {
            let figure = choice(stations.clone()).expect("wheels");
            assert_sound(&figure);
            assert_eq!(ParsedDrawing::parse(&figure).count("point"), 4);
            assert_eq!(figure.series.rows.len(), stations.count());
            for [motion, dwell, distance, radius] in columns(&figure.series, ["motion", "dwell", "l/r", "wheel/r"]) {
                assert!((motion + dwell - 1.0).abs() < 1e-12 && distance > radius);
            }
        }
        assert!(choice(2..=4).is_err());
    }
}
