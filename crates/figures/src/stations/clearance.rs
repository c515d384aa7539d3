//! Do wheel and driver, as they are drawn, keep clear of each other all the way round?

use super::driver::Driver;
use super::pose::WheelPose;
use crate::checks::{corners, depth};
use crate::star::Star;
use crate::svg::View;
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Pixels to a crank radius: outlines are written to hundredths of a pixel.
const SCALE: f64 = 2000.0;
/// Arcs are cut into chords of this angle, in radians.
const CHORD: f64 = 0.06;
/// How deep one body may seem to lie in the other because of the chords, in crank radii. In the dwell they touch.
const TOUCHING: f64 = 1e-3;
/// Positions looked at from the middle of a dwell to the middle of the next.
const POSITIONS: i32 = 30;

/// The corners of an outline in crank radii, y upwards.
fn outline(data: &str) -> Vec<Vector2<f64>> {
    corners(data, CHORD).iter().map(|at| Vector2::new(at.x, -at.y) / SCALE).collect()
}

fn turned(point: &Vector2<f64>, turn: &Turn<f64>) -> Vector2<f64> {
    Vector2::new(turn.cos * point.x - turn.sin * point.y, turn.sin * point.x + turn.cos * point.y)
}

fn check(stations: u32, pins: u32) {
    let wheel = Wheel::with_pins(stations, pins).expect("possible");
    let star = Star::of_wheel(&wheel);
    let driver = Driver::of_wheel(&wheel, &star);
    let view = View { origin: Vector2::zeros(), scale: SCALE };
    let body = outline(star.outline(0.0, &view).data());
    let crank = WheelPose::crank_direction(0.0);
    let locking_disc = driver.locking_disc_outline(crank, &view).map(|path| outline(path.data())).unwrap_or_default();
    let centres = Vector2::new(star.centre, 0.0);
    for k in -POSITIONS..=POSITIONS {
        let theta = driver.pitch() / 2.0 * f64::from(k) / f64::from(POSITIONS);
        let motion = wheel.motion(0, theta).expect("in the turn");
        let phi = Turn::from_radians(motion.angle + 2.0 * wheel.half_pitch_angle() * motion.stations as f64);
        // The driver turns clockwise for a growing θ.
        let turn = Turn::from_radians(-theta);
        let on_driver = |point: &Vector2<f64>| turned(&(turned(point, &phi) - centres), &turn.reversed());
        let on_wheel = |point: &Vector2<f64>| turned(&(turned(point, &turn) + centres), &phi.reversed());
        let place = format!("{stations} stations, {pins} pins, θ = {theta}");
        for point in body.iter().map(on_driver).filter(|at| at.norm() < driver.locking_disc - TOUCHING) {
            assert!(locking_disc.is_empty() || depth(&point, &locking_disc) < TOUCHING, "{place}: wheel at {point}");
        }
        for point in locking_disc.iter().map(on_wheel).filter(|at| at.norm() < star.rim) {
            assert!(depth(&point, &body) < TOUCHING, "{place}: locking disc at {point}");
        }
        for pin in driver.pin_directions(crank) {
            let direction = Turn::from_radians(pin);
            let at = on_wheel(&Vector2::new(direction.cos, direction.sin));
            if at.norm() < star.rim + 2.0 * driver.pin {
                assert!(depth(&at, &body) <= -driver.pin, "{place}: pin at {at}");
            }
        }
    }
}

#[test]
fn wheel_and_driver_keep_clear_of_each_other_all_the_way_round() {
    for stations in 3..=18 {
        check(stations, 1);
        let most = (1..=6).rev().find(|pins| Wheel::with_pins(stations, *pins).is_ok()).expect("one at least");
        for pins in 2..=most {
            check(stations, pins);
        }
    }
}

#[test]
fn locking_disc_slots_and_axis_have_room() {
    for stations in 3..=60 {
        let wheel = Wheel::new(stations).expect("possible");
        let star = Star::of_wheel(&wheel);
        let driver = Driver::of_wheel(&wheel, &star);
        // The wall is as thick as the slot is wide; the locking disc passes inside the pins; the cut-out leaves an
        // axis.
        let wall = 1.0 - star.half_width - driver.locking_disc;
        approx::assert_relative_eq!(wall, 2.0 * star.half_width, max_relative = 1e-12);
        assert!(driver.locking_disc + driver.pin < 1.0 && driver.pin < star.half_width);
        assert!(driver.depth > 0.0 && driver.depth < star.centre - star.rim, "{stations}");
        // At entry the edge of the cut-out is on the line of centres: the cut-out and the locking disc make up the
        // turn.
        let edge = Vector2::new(libm::cos(driver.half_angle), libm::sin(driver.half_angle)) * driver.locking_disc;
        let from_cut = (edge - Vector2::new(driver.cut_centre, 0.0)).norm();
        approx::assert_relative_eq!(from_cut, driver.cut_radius, max_relative = 1e-12);
        assert!(star.locking_half_angle() + driver.half_angle < PI, "{stations}: the locking disc fills a locking arc");
    }
}
