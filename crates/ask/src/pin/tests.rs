//! A pin in its slot: against vectors, at both ends, and what is refused.

use super::*;
use crate::worked::plain;
use geneva_kinematics::pin_slot::{sliding_product, slot_radius_squared, velocity_ratio};

fn design(arguments: &str) -> PinDesign {
    PinDesign::new(&PinQuestion::parse(arguments).expect("arguments")).expect("possible")
}

#[test]
fn the_triangle_agrees_with_the_formulas_all_over_the_engagement() {
    for stations in [3, 4, 5, 8, 24] {
        for share in -20..=20 {
            let half = 90.0 - 180.0 / f64::from(stations);
            let angle = half * f64::from(share) / 20.0;
            let at = design(&format!("--crank-radius 37 --stations {stations} --angle {angle} --rad-s 2.5"));
            let (ratio, crank) = (at.mechanism.ratio(), Turn::from_degrees(angle));
            let distance = slot_radius_squared(&ratio, &crank).sqrt();
            let inwards = -sliding_product(&ratio, &crank) / distance * 37.0 * 2.5;
            approx::assert_abs_diff_eq!(at.wheel_speed(), velocity_ratio(&ratio, &crank) * 2.5, epsilon = 1e-11);
            approx::assert_abs_diff_eq!(at.sliding_speed(), inwards, epsilon = 1e-11 * 37.0);
        }
    }
}

#[test]
fn both_origins_and_both_units_of_speed_ask_the_same() {
    let of = |angle: &str, speed: &str| design(&format!("--crank-radius 40 --stations 6 {angle} {speed} --unit in"));
    let one = of("--angle -20", "--rpm 60");
    let other = of("--angle-from-extension 160", "--rad-s 6.283185307179586");
    assert_eq!(one.theta, other.theta);
    approx::assert_relative_eq!(one.wheel_speed(), other.wheel_speed(), max_relative = 1e-14);
    assert_eq!(one.answer().field("sliding_speed").map(|field| field.unit), Some("in/s"));
    for (origin, angle, theta) in [
        (AngleOrigin::Extension, 510.0, -30.0),
        (AngleOrigin::Extension, 0.0, 180.0),
        (AngleOrigin::LineOfCentres, 350.0, -10.0),
    ] {
        assert_eq!(origin.from_line_of_centres(angle), theta);
    }
}

#[test]
fn at_both_ends_the_wheel_rests_and_in_the_middle_the_pin_does() {
    for (angle, moving, sliding) in
        [(-45.0, "just entering", true), (45.0, "just leaving", true), (0.0, "opposite", false)]
    {
        let at = design(&format!("--crank-radius 5 --stations 4 --angle {angle} --rpm 30"));
        assert!(at.turning_in_words().contains(moving), "{angle}");
        assert_eq!(at.sliding_speed() != 0.0, sliding, "{angle}");
        assert!(at.steps().iter().all(|step| !step.lines.is_empty()));
    }
}

#[test]
fn a_problem_with_numbers_of_ones_own_is_written_out() {
    // By hand: r² = 1600 + 6400 − 6400 cos 20°, v = 320, and φ̇ = 8 (2 cos 20° − 1) / (5 − 4 cos 20°).
    let at = design("--crank-radius 40 --centre-distance 80 --angle-from-extension 160 --rad-s 8");
    let lines: Vec<String> = at.steps().iter().flat_map(|step| step.lines.iter().map(|line| plain(line))).collect();
    for line in [
        "θ = 160° − 180° = −20°, so |θ| = 20°",
        "r² = R² + l² − 2 R l cos|θ| = 40² + 80² − 2 · 40 · 80 · cos 20° = 1985.97 mm²",
        "r = √(1985.97 mm²) = 44.5642 mm",
        "v_P = R θ̇ = 40 · 8 = 320 mm/s",
        "φ̇ = v_P′ / r = 252.582 / 44.5642 = 5.66782 rad/s",
        "Opposite to the driver.",
    ] {
        assert!(lines.iter().any(|known| known == line), "{line}\n{}", lines.join("\n"));
    }
}

#[test]
fn what_is_impossible_says_what_to_give() {
    for (arguments, words) in [
        ("--crank-radius 40 --stations 6 --angle 70 --rpm 1", "from θ = −60° to 60° only"),
        ("--crank-radius 40 --stations 6 --angle-from-extension 90 --rpm 1", "from 120"),
        ("--crank-radius 40 --stations 2 --angle 0 --rpm 1", "give 3 to 100"),
        ("--crank-radius 40 --centre-distance 40 --angle 0 --rpm 1", "give more than --crank-radius 40"),
        ("--crank-radius 0 --stations 6 --angle 0 --rpm 1", "not a length above zero"),
        ("--crank-radius 4 --stations 6 --angle 0 --rpm -1", "--rpm -1: the driver must turn"),
        ("--crank-radius 4 --stations 6 --angle NaN --rad-s 1", "only"),
        ("--crank-radius 4 --stations 6 --rad-s 1", "--angle is missing"),
        ("--crank-radius 4 --stations 6 --angle 0 --rad-s 1 --unit mile", "give one of mm"),
        ("--crank 4", "give --crank-radius"),
    ] {
        let why = PinQuestion::parse(arguments).and_then(|question| PinDesign::new(&question)).expect_err("refused");
        assert!(why.to_string().contains(words), "{arguments}: {why}");
    }
}
