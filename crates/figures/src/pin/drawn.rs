//! What must hold of the drawings as they are written, read back from the SVG.

use super::{over_the_engagement, position_triangle, velocity_triangle};
use crate::Figure;
use crate::checks::{named, number, only_numbers, start, well_formed};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use roxmltree::Document;
use std::f64::consts::{PI, SQRT_2};

const RADIUS: f64 = 3.0;
const DRIVER: f64 = 7.0;
/// Half a unit of the last written digit of a coordinate, in each of a length's four coordinates, with room to spare.
const PIXELS: f64 = 0.02;

fn mechanism(stations: u32) -> PinSlot {
    PinSlot::new(RADIUS, RADIUS / libm::sin(PI / f64::from(stations))).expect("possible")
}

fn all_three(mechanism: &PinSlot, crank: &Turn<f64>, driver: f64) -> [Figure; 3] {
    [
        position_triangle(mechanism, crank),
        velocity_triangle(mechanism, crank, driver, "m/s"),
        over_the_engagement(mechanism, crank, driver, "m"),
    ]
}

/// Several mechanisms, each at entry, between, on the line of centres, beyond, and at exit.
fn every_figure() -> Vec<Figure> {
    let mut mechanisms: Vec<_> = (3..=8).map(mechanism).collect();
    mechanisms.push(PinSlot::new(RADIUS, 1.47 * RADIUS).expect("possible"));
    let mut figures = Vec::new();
    for mechanism in &mechanisms {
        let half = mechanism.engagement_half_angle();
        for share in [-1.0, -0.6, 0.0, 0.3, 1.0] {
            let crank = Turn::from_radians(PI + share * half);
            for driver in [DRIVER, -DRIVER, 0.0] {
                figures.extend(all_three(mechanism, &crank, driver));
            }
        }
    }
    figures
}

#[test]
fn every_figure_is_well_formed_labelled_and_fit_for_markdown() {
    every_figure().iter().for_each(well_formed);
}

#[test]
fn no_figure_shows_a_negative_zero_or_what_is_no_number() {
    every_figure().iter().for_each(only_numbers);
}

#[test]
fn drawing_twice_gives_the_same_bytes() {
    let (mechanism, crank) = (mechanism(5), Turn::from_radians(2.7));
    assert_eq!(all_three(&mechanism, &crank, DRIVER), all_three(&mechanism, &crank, DRIVER));
}

#[test]
fn the_position_triangle_is_to_scale() {
    let mechanism = mechanism(4);
    let figure = position_triangle(&mechanism, &Turn::from_radians(2.5));
    let document = Document::parse(&figure.svg).expect("well-formed");
    let side = |class: &str| {
        let line = named(&document, class)[0];
        (number(&line, "x2") - number(&line, "x1")).hypot(number(&line, "y2") - number(&line, "y1"))
    };
    let circle = number(&named(&document, "pin-circle")[0], "r");
    assert!((side("side-R") - circle).abs() < PIXELS);
    assert!((side("side-l") - circle * SQRT_2).abs() < PIXELS);
    assert!((side("side-r") - circle * figure.series.rows[0][2]).abs() < PIXELS);
}

#[test]
fn the_arrows_of_the_velocity_triangle_close_and_are_to_scale() {
    let mechanism = mechanism(4);
    let figure = velocity_triangle(&mechanism, &Turn::from_radians(2.5), DRIVER, "m/s");
    let document = Document::parse(&figure.svg).expect("well-formed");
    let ends = |class: &str| {
        let parts = named(&document, class);
        (start(&parts[0]), start(&parts[1]))
    };
    let (pin, slot_point, sliding) = (ends("v-pin"), ends("v-slot-point"), ends("v-sliding"));
    assert_eq!((pin.0, slot_point.1, sliding.1), (slot_point.0, sliding.0, pin.1));
    let bar = named(&document, "scale-bar")[0];
    let length = |(a, b): ([f64; 2], [f64; 2])| (b[0] - a[0]).hypot(b[1] - a[1]);
    let scale = length(pin) / figure.series.rows[0][1];
    for (arrow, column) in [(slot_point, 2), (sliding, 3)] {
        assert!((length(arrow) - scale * figure.series.rows[0][column]).abs() < PIXELS, "column {column}");
    }
    let speed = (number(&bar, "x2") - number(&bar, "x1")) / scale;
    assert!((speed - speed.round()).abs() * scale < PIXELS, "the scale bar stands for {speed}");
}

#[test]
fn the_series_of_the_engagement_has_both_ends_and_every_degree_between() {
    let mechanism = mechanism(4);
    let figure = over_the_engagement(&mechanism, &Turn::from_radians(2.5), DRIVER, "m");
    let rows = &figure.series.rows;
    let degrees = 2.0 * mechanism.engagement_half_angle().to_degrees();
    assert_eq!(rows.len(), degrees.round() as usize + 1);
    for (row, sign) in [(&rows[0], -1.0), (&rows[rows.len() - 1], 1.0)] {
        approx::assert_relative_eq!(row[0], 180.0 + sign * degrees / 2.0, max_relative = 1e-14);
        approx::assert_abs_diff_eq!(row[1], 0.0, epsilon = 1e-14);
        approx::assert_relative_eq!(row[2], -sign * RADIUS * DRIVER, max_relative = 1e-14);
    }
    let document = Document::parse(&figure.svg).expect("well-formed");
    let curves = document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "polyline")));
    let long =
        curves.filter(|node| node.attribute("points").is_some_and(|p| p.split_whitespace().count() == rows.len()));
    assert_eq!(long.count(), 2);
}
