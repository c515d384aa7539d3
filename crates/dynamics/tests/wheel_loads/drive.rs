//! What the driver feels: compared with the equation of motion, integrated by other rules, and with the balance of energy.

use super::{SPEED, wheels};
use approx::assert_relative_eq;
use geneva_dynamics::wheel_loads::{Friction, WheelLoads};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::TAU;

const INERTIA: f64 = 0.02;

#[test]
fn the_reflected_inertia_has_the_wheels_energy() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        let loads = WheelLoads::new(wheel, INERTIA, 0.4, SPEED).unwrap();
        let reflected = loads.reflected_inertia();
        let (end, steps) = (wheel.engagement_half_angle(), 4000);
        let velocity = |step: i32| wheel.engaged(end * f64::from(step) / f64::from(steps)).unwrap().velocity;
        let squares = || (-steps..=steps).map(|step| velocity(step) * velocity(step));
        assert_relative_eq!(reflected.peak, INERTIA * squares().fold(0.0, f64::max), max_relative = 1e-12);
        let mean = squares().sum::<f64>() * end / f64::from(steps) * f64::from(wheel.pins()) / TAU;
        assert_relative_eq!(reflected.mean, INERTIA * mean, max_relative = 1e-5);
    }
}

/// The driver's speed without motor and friction, by Heun's rule in time from the entry to the line of centres.
#[test]
fn a_flywheel_gives_the_wheel_its_energy() {
    for stations in [3, 4, 6, 12] {
        let wheel = Wheel::new(stations).unwrap();
        let loads = WheelLoads::new(&wheel, INERTIA, 0.0, SPEED).unwrap();
        for flywheel in [0.05, 0.5, 20.0] {
            let rate = |crank: f64, speed: f64| {
                let motion = wheel.engaged(crank.min(0.0)).unwrap();
                let own = flywheel + INERTIA * motion.velocity * motion.velocity;
                -INERTIA * motion.velocity * motion.acceleration * speed * speed / own
            };
            let (mut crank, mut speed, step) = (-wheel.engagement_half_angle(), SPEED, 2e-6);
            while crank < 0.0 {
                let first = rate(crank, speed);
                let second = rate(crank + step * speed, speed + step * first);
                crank += step * (speed + 0.5 * step * first);
                speed += step * 0.5 * (first + second);
            }
            assert_relative_eq!(loads.speed_droop(flywheel).unwrap(), 1.0 - speed / SPEED, max_relative = 1e-4);
        }
        assert!(loads.speed_droop(0.0).is_err());
    }
}

#[test]
fn a_start_without_friction_takes_the_energy_of_both() {
    let wheel = Wheel::new(6).unwrap();
    let loads = WheelLoads::new(&wheel, INERTIA, 0.0, SPEED).unwrap();
    // So much that it arrives in the first dwell: only the driver has energy then.
    let (driver, end) = (0.05, wheel.engagement_half_angle());
    let torque = 0.5 * driver * SPEED * SPEED / (1.5 * end);
    let start = loads.run_up(torque, driver).unwrap().unwrap();
    assert_relative_eq!(start.angle, 1.5 * end, max_relative = 1e-9);
    // Within the first half index: of both.
    let torque = 4.0;
    let start = loads.run_up(torque, driver).unwrap().unwrap();
    assert!(start.angle < end);
    let velocity = wheel.engaged(start.angle).unwrap().velocity;
    let energy = 0.5 * (driver + INERTIA * velocity * velocity) * SPEED * SPEED;
    assert_relative_eq!(torque * start.angle, energy, max_relative = 2e-3);
}

/// By Heun's rule in time, with the pin's force from the wheel's law of motion and a search for the driver's acceleration that obeys
/// both laws: nothing is solved in closed form.
#[test]
fn a_start_with_friction_is_that_of_both_laws_of_motion() {
    let wheel = Wheel::new(4).unwrap();
    let friction = Friction {
        pin: 0.15,
        pin_radius: 0.1,
        wheel_bearing: 0.01,
        driver_bearing: 0.02,
        driver_torque: 0.1,
        dwell_torque: 0.05,
        ..Friction::of_wheel(0.3)
    };
    let loads = WheelLoads::with_friction(&wheel, INERTIA, friction, SPEED).unwrap();
    let (torque, driver) = (2.0, 0.2);
    let end = wheel.engagement_half_angle();
    let factor = 0.15_f64.hypot(1.0);
    let acceleration = |crank: f64, speed: f64| {
        let from_middle = if crank > TAU - end { crank - TAU } else { crank };
        let Ok(motion) = wheel.engaged(from_middle) else { return (torque - 0.15) / driver };
        let pin = wheel.pin_in_slot(from_middle).unwrap();
        // What is left over of the driver's law of motion at a guess of its acceleration.
        let left = |guess: f64| {
            let needs = INERTIA * (motion.acceleration * speed * speed + motion.velocity * guess) + 0.3;
            let flank = if needs < 0.0 { -1.0 } else { 1.0 };
            let sliding = pin.radius_rate + flank * 0.1 * (1.0 + motion.velocity);
            let arm = pin.radius - 0.15 * 0.1 * sliding.signum();
            let force = needs / (arm - flank * 0.01 * factor);
            let wheel_takes = force * arm * motion.velocity;
            let rubs = force.abs() * (0.15 * sliding.abs() + 0.02 * factor);
            torque - 0.1 - wheel_takes - rubs - driver * guess
        };
        let (mut low, mut high) = (-1e4, 1e4);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if left(middle) > 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    let (mut time, mut crank, mut turned, mut speed, step) = (0.0, 0.0, 0.0, 0.0, 5e-5);
    while speed < SPEED {
        let first = acceleration(crank, speed);
        let next = (crank + step * speed) % TAU;
        let second = acceleration(next, speed + step * first);
        let way = step * (speed + 0.5 * step * first);
        (crank, turned, speed, time) =
            ((crank + way) % TAU, turned + way, speed + 0.5 * step * (first + second), time + step);
    }
    let start = loads.run_up(torque, driver).unwrap().unwrap();
    assert_relative_eq!(start.time, time, max_relative = 2e-3);
    assert_relative_eq!(start.angle, turned, max_relative = 4e-3);
    // Less than it takes to get loose, or to keep on, never arrives.
    let breakaway = loads.breakaway_torque();
    assert!(loads.run_up(0.99 * breakaway, driver).unwrap().is_none());
    assert!(loads.run_up(1.3 * breakaway, driver).unwrap().is_some());
}

#[test]
fn a_stop_in_mid_index_is_held_against_the_wheels_torque_by_virtual_work() {
    let wheel = Wheel::new(5).unwrap();
    let loads = WheelLoads::new(&wheel, INERTIA, 0.0, SPEED).unwrap();
    // A small turn of the driver and what the wheel turns with it.
    let small = 1e-5;
    let turned = wheel.engaged(small).unwrap().angle - wheel.engaged(-small).unwrap().angle;
    assert_relative_eq!(loads.holding_torque(3.0).unwrap(), 3.0 * turned / (2.0 * small), max_relative = 1e-8);
    assert!(loads.holding_torque(-1.0).is_err());
    assert_eq!(loads.breakaway_torque(), 0.0);
    let rubs = WheelLoads::new(&wheel, INERTIA, 2.0, SPEED).unwrap();
    assert_relative_eq!(rubs.breakaway_torque(), 2.0 * wheel.peak_velocity(), max_relative = 1e-14);
}
