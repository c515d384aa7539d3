//! Do all routes to the pin's motion agree from entry to exit, not only at the printed instant?
//!
//! Three routes that share no code: the laws of sines and cosines; the pin's place on power series; and the wheel's
//! angular velocity integrated by a library for differential equations. Oracle for the third: the advance of a
//! four-slot wheel is a quarter turn, and the slot's angle follows from the pin's coordinates.

use approx::assert_relative_eq;
use geneva_documents::pin::PinProblem;
use geneva_kinematics::pin_slot::{PinSlot, pin_from_pivot, sliding_product, velocity_ratio};
use geneva_kinematics::{Turn, pin_triangle, pin_vectors};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, System, Vector2};

/// Two routes in floating point: some digits are lost to subtraction near the ends of the engagement.
const ROUTES: f64 = 1e-11;

fn mechanism() -> PinSlot {
    PinProblem::printed().expect("a mechanism").mechanism
}

/// Crank angles θ over the engagement, both ends left out.
fn engagement() -> impl Iterator<Item = f64> {
    let end = mechanism().engagement_half_angle();
    (-199..200).map(move |step| end * f64::from(step) / 200.0)
}

#[test]
fn the_triangle_and_the_vectors_agree() {
    let (mechanism, speed) = (mechanism(), PinProblem::printed().expect("a mechanism").driver_speed);
    let (radius, distance) = (mechanism.crank_radius(), mechanism.centre_distance());
    for theta in engagement() {
        let theta = Turn::from_radians(theta);
        let triangle = pin_triangle::solve(&mechanism, &theta, speed);
        let vectors = pin_vectors::solve(&radius, &distance, &theta.supplement(), &speed).expect("off the pivot");
        let same = |a: f64, b: f64, what: &str| {
            assert!((a - b).abs() <= ROUTES * a.abs().max(b.abs()).max(1.0), "{what}: {a} and {b}");
        };
        let inward = -vectors.position.normalize();
        same(triangle.slot_radius, vectors.position.norm(), "slot radius");
        same(triangle.sine_at_pivot, vectors.position.normalize().y, "sine at the pivot");
        same(triangle.angle_at_pivot, libm::atan2(vectors.position.y, vectors.position.x), "angle at the pivot");
        same(triangle.pin_speed, vectors.pin_velocity.norm(), "speed of the pin");
        same(triangle.slot_point_speed, vectors.slot_point_velocity.norm(), "speed of the slot's point");
        same(triangle.sliding_speed, vectors.sliding_velocity.dot(&inward), "sliding speed");
        same(triangle.follower_speed, -vectors.follower_speed, "speed of the wheel");
        // And the formulas that know no triangle.
        same(triangle.follower_speed, speed * velocity_ratio(&mechanism.ratio(), &theta), "velocity ratio");
        let sliding = sliding_product(&mechanism.ratio(), &theta) / triangle.radius_ratio * triangle.pin_speed;
        same(triangle.sliding_speed, sliding, "sliding product");
    }
}

#[test]
fn the_pin_is_fastest_in_the_slot_at_both_ends_and_at_rest_in_it_in_the_middle() {
    let mechanism = mechanism();
    let end = Turn::from_radians(mechanism.engagement_half_angle());
    let solution = pin_triangle::solve(&mechanism, &end, 1.0);
    assert_relative_eq!(solution.sliding_speed, solution.pin_speed, max_relative = 1e-12);
    let middle = pin_triangle::solve(&mechanism, &Turn::from_radians(0.0), 1.0);
    assert_relative_eq!(middle.slot_point_speed, middle.pin_speed, max_relative = 1e-12);
}

/// Wheel angle and crank angle; the crank is a state, so that the system does not depend on time.
struct Wheel {
    ratio: f64,
}

impl System<f64, Vector2<f64>> for Wheel {
    fn system(&self, _: f64, state: &Vector2<f64>, rates: &mut Vector2<f64>) {
        rates[0] = velocity_ratio(&self.ratio, &Turn::from_radians(state[1]));
        rates[1] = 1.0;
    }
}

#[test]
fn the_integrated_velocity_is_the_angle_and_the_advance_a_quarter_turn() {
    let (ratio, end) = (mechanism().ratio(), mechanism().engagement_half_angle());
    let mut state = Vector2::new(slot_angle(ratio, -end), -end);
    let pieces = 18;
    for piece in 1..=pieces {
        state = integrate(ratio, state, 2.0 * end / f64::from(pieces));
        let theta = -end + 2.0 * end * f64::from(piece) / f64::from(pieces);
        assert!((state[0] - slot_angle(ratio, theta)).abs() < 1e-11, "at {theta}: {}", state[0]);
    }
    assert_relative_eq!(state[0] - slot_angle(ratio, -end), std::f64::consts::FRAC_PI_2, max_relative = 1e-11);
}

/// From 0 with sparse output: dense output from a negative start does not end.
fn integrate(ratio: f64, state: Vector2<f64>, span: f64) -> Vector2<f64> {
    let mut solver = Dop853::new(Wheel { ratio }, 0.0, span, span, state, 1e-13, 1e-13);
    solver.set_output(OutputType::Sparse);
    solver.integrate().expect("a smooth problem");
    *solver.y_out().last().expect("the end")
}

fn slot_angle(ratio: f64, theta: f64) -> f64 {
    let pin = pin_from_pivot(&ratio, &Turn::from_radians(theta));
    libm::atan2(pin.y, pin.x)
}

/// The library's own traps, kept in sight: a right-hand side that uses time is integrated wrongly by `Dop853`.
struct Ramp;

impl System<f64, Vector2<f64>> for Ramp {
    fn system(&self, time: f64, _: &Vector2<f64>, rates: &mut Vector2<f64>) {
        rates[0] = libm::cos(time);
        rates[1] = 0.0;
    }
}

#[test]
fn time_must_not_stand_on_the_right_hand_side_of_dop853() {
    let start = Vector2::new(0.0, 0.0);
    let mut by_eight = Dop853::new(Ramp, 0.0, 1.0, 1.0, start, 1e-10, 1e-10);
    by_eight.set_output(OutputType::Sparse);
    let mut by_five = Dopri5::new(Ramp, 0.0, 1.0, 1.0, start, 1e-10, 1e-10);
    by_five.set_output(OutputType::Sparse);
    by_five.integrate().expect("no error");
    let right = by_five.y_out().last().expect("the end")[0] - libm::sin(1.0);
    // It may give up, or give a wrong number.
    let wrong = by_eight.integrate().ok().and_then(|_| Some(by_eight.y_out().last()?[0] - libm::sin(1.0)));
    assert!(right.abs() < 1e-8, "Dopri5 is off by {right}");
    assert!(wrong.is_none_or(|wrong| wrong.abs() > 1e-6), "Dop853 is off by {wrong:?}: repaired, so time may be used");
}
