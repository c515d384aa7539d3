//! What must hold of the drawings as they are written, read back from the SVG.

use super::{over_the_engagement, position_triangle, velocities_at_the_pin, velocity_triangle};
use crate::checks::{PIXELS, ParsedDrawing, assert_drawn};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use std::f64::consts::{PI, SQRT_2};

const RADIUS: f64 = 3.0;
const DRIVER: f64 = 7.0;

fn mechanism(stations: u32) -> PinSlot {
    PinSlot::new(RADIUS, RADIUS / libm::sin(PI / f64::from(stations))).expect("possible")
}

#[test]
fn mechanisms_are_drawn_at_entry_between_and_at_exit_turning_either_way() {
    let mut mechanisms: Vec<_> = (3..=8).map(mechanism).collect();
    mechanisms.push(PinSlot::new(RADIUS, 1.47 * RADIUS).expect("possible"));
    for mechanism in &mechanisms {
        for share in [-1.0, -0.6, 0.0, 0.3, 1.0] {
            let crank = Turn::from_radians(PI + share * mechanism.engagement_half_angle());
            assert_drawn(&position_triangle(mechanism, &crank));
            for driver in [DRIVER, -DRIVER, 0.0] {
                assert_drawn(&velocity_triangle(mechanism, &crank, driver, "m/s"));
                assert_drawn(&over_the_engagement(mechanism, &crank, driver, "m"));
            }
            for driver in [DRIVER, -DRIVER] {
                assert_drawn(&velocities_at_the_pin(mechanism, &crank, driver, "m/s"));
            }
        }
    }
}

#[test]
fn the_position_triangle_is_to_scale() {
    let figure = position_triangle(&mechanism(4), &Turn::from_radians(2.5));
    let drawing = ParsedDrawing::parse(&figure);
    let circle = drawing.number("pin-circle", "r");
    for (side, length) in [("side-R", 1.0), ("side-l", SQRT_2), ("side-r", figure.series.rows[0][2])] {
        assert!((drawing.length(side) - circle * length).abs() < PIXELS, "{side}");
    }
}

#[test]
fn the_arrows_of_the_velocity_triangle_close_and_are_to_scale() {
    let figure = velocity_triangle(&mechanism(4), &Turn::from_radians(2.5), DRIVER, "m/s");
    let drawing = ParsedDrawing::parse(&figure);
    let [pin, slot_point, sliding] =
        ["v-pin", "v-slot-point", "v-sliding"].map(|name| drawing.arrow(name).expect("an arrow"));
    assert_eq!((pin[0], slot_point[1], sliding[1]), (slot_point[0], sliding[0], pin[1]));
    let row = &figure.series.rows[0];
    let scale = (pin[1] - pin[0]).norm() / row[1];
    for (arrow, column) in [(slot_point, 2), (sliding, 3)] {
        assert!(((arrow[1] - arrow[0]).norm() - scale * row[column]).abs() < PIXELS, "column {column}");
    }
    let speed = drawing.length("scale-bar") / scale;
    assert!((speed - speed.round()).abs() * scale < PIXELS, "the scale bar stands for {speed}");
}

#[test]
fn the_series_of_the_engagement_has_both_ends_and_every_degree_between() {
    let mechanism = mechanism(4);
    let figure = over_the_engagement(&mechanism, &Turn::from_radians(2.5), DRIVER, "m");
    let rows = &figure.series.rows;
    let degrees = 2.0 * mechanism.engagement_half_angle().to_degrees();
    assert_eq!(rows.len(), degrees.round() as usize + 1);
    let [first, last] = [&rows[0], &rows[rows.len() - 1]];
    for (row, sign) in [(first, -1.0), (last, 1.0)] {
        approx::assert_relative_eq!(row[0], sign * degrees / 2.0, max_relative = 1e-14);
        approx::assert_abs_diff_eq!(row[1], 0.0, epsilon = 1e-13);
        approx::assert_relative_eq!(row[3], -sign * RADIUS * DRIVER, max_relative = 1e-14);
    }
    // The acceleration is the rate of the velocity: it goes up to the line of centres and down again.
    let second = DRIVER / (1f64).to_radians();
    for (before, after) in rows.iter().zip(&rows[1..]) {
        let mean = (before[2] + after[2]) / 2.0;
        let rate = (after[1] - before[1]) / (after[0] - before[0]) * second;
        assert!((rate - mean).abs() < 2e-3 * first[2].max(DRIVER * DRIVER * 5.0), "{rate} and {mean} at {}", before[0]);
    }
    assert!(first[2] > 0.0 && last[2] == -first[2]);
    // The curves go from one side of the frame to the other.
    let drawing = ParsedDrawing::parse(&figure);
    let [speed, acceleration, sliding] = [0, 1, 2].map(|number| drawing.path("curve", number));
    assert!((speed[0].x - sliding[0].x).abs() < PIXELS && sliding[0].y < sliding[sliding.len() - 1].y);
    assert!((speed[0].y - speed[speed.len() - 1].y).abs() < 0.11, "at rest at both ends");
    assert!(acceleration[0].y < acceleration[acceleration.len() - 1].y, "it speeds up first");
}

#[test]
fn the_velocities_at_the_pin_close_and_the_pins_has_one_length_at_every_angle() {
    let mechanism = mechanism(4);
    let mut lengths = Vec::new();
    for degrees in [-40.0, -20.0, 10.0, 35.0] {
        let crank = Turn::from_degrees(180.0 + degrees);
        let figure = velocities_at_the_pin(&mechanism, &crank, DRIVER, "m/s");
        let drawing = ParsedDrawing::parse(&figure);
        let [pin, across, along] =
            ["v-pin", "v-slot-point", "v-sliding"].map(|name| drawing.arrow(name).expect("an arrow"));
        assert_eq!((pin[0], across[1], along[1]), (across[0], along[0], pin[1]));
        let row = &figure.series.rows[0];
        let share = (across[1] - across[0]).norm() / (pin[1] - pin[0]).norm();
        assert!((share - row[2] / row[1]).abs() < 0.01, "{degrees}");
        lengths.push((pin[1] - pin[0]).norm());
    }
    assert!(lengths.iter().all(|length| (length - lengths[0]).abs() < PIXELS), "{lengths:?}");
}
