//! Friction of pin, bearings and disc: compared with the vectors of forces, with the escapement's equation of motion, with where the
//! energy goes, and with a fine scan.

use super::{SPEED, wheels};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use geneva_dynamics::joints::{Escapement, Joints};
use geneva_dynamics::wheel_loads::{DwellContact, Friction, Load, WheelLoads};
use geneva_dynamics::{DynamicsError, Inertias, Parameters};
use geneva_kinematics::Mechanism;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::TAU;

const INERTIA: f64 = 0.02;

const ALL: Friction = Friction {
    wheel_torque: 0.3,
    pin: 0.15,
    pin_radius: 0.12,
    wheel_bearing: 0.02,
    driver_bearing: 0.03,
    driver_torque: 0.05,
    dwell_torque: 0.02,
};

/// Some of it, and all.
fn frictions() -> [Friction; 6] {
    [
        Friction { pin: 0.2, ..Friction::NONE },
        Friction { pin: 0.2, pin_radius: 0.1, ..Friction::of_wheel(0.1) },
        Friction { wheel_bearing: 0.05, ..Friction::of_wheel(0.1) },
        Friction { driver_bearing: 0.05, driver_torque: 0.2, ..Friction::NONE },
        Friction { driver_torque: 0.2, dwell_torque: 0.1, ..Friction::of_wheel(0.4) },
        ALL,
    ]
}

type Vector = [f64; 2];

fn cross(one: Vector, other: Vector) -> f64 {
    one[0] * other[1] - one[1] * other[0]
}

/// Velocity of a point of a body that turns about `axis`.
fn velocity(speed: f64, axis: Vector, point: Vector) -> Vector {
    [-speed * (point[1] - axis[1]), speed * (point[0] - axis[0])]
}

/// Of planar wheels: the forces as vectors at the point where pin and wall touch, and their moments about both axes as cross products.
#[test]
fn the_forces_balance_about_both_axes() {
    for stations in [3, 4, 6, 11] {
        let (external, internal) = (Wheel::new(stations).unwrap(), InternalWheel::new(stations).unwrap());
        let axes = [external.centre_distance_ratio(), internal.centre_distance_ratio()];
        let (mut forward, mut held) = (0, 0);
        for (wheel, centres, sense) in [(&external as &dyn Indexing, axes[0], -1.0), (&internal, axes[1], 1.0)] {
            for friction in frictions() {
                let loads = WheelLoads::with_friction(wheel, INERTIA, friction, SPEED).unwrap();
                for step in -9..=9 {
                    let crank = wheel.engagement_half_angle() * (f64::from(step) + 0.31) / 10.0;
                    // The driver turns counterclockwise at speed 1, the wheel at `rate`. External: the pin is deepest at the right of
                    // the driver's axis; internal: too, and the wheel's axis is at its left.
                    let pin = [crank.cos(), crank.sin()];
                    let axis = [-sense * centres, 0.0];
                    let slot: Vector = [pin[0] - axis[0], pin[1] - axis[1]];
                    let radius = slot[0].hypot(slot[1]);
                    let along = [slot[0] / radius, slot[1] / radius];
                    let motion = wheel.engaged(crank).unwrap();
                    let rate = sense * motion.velocity;
                    // Across the slot, in the sense in which the wheel turns.
                    let across = [-sense * along[1], sense * along[0]];
                    let load = loads.load(crank).unwrap();
                    let flank = load.pin_moment.signum();
                    let touch = [0, 1].map(|k| pin[k] + flank * friction.pin_radius * across[k]);
                    let [of_pin, of_wall] = [velocity(1.0, [0.0; 2], touch), velocity(rate, axis, touch)];
                    let sliding = (0..2).map(|k| (of_pin[k] - of_wall[k]) * along[k]).sum::<f64>();
                    let closing = (0..2).map(|k| (of_pin[k] - of_wall[k]) * across[k]).sum::<f64>();
                    assert_abs_diff_eq!(closing, 0.0, epsilon = 1e-12);
                    assert_abs_diff_eq!(sliding, load.sliding, epsilon = 1e-12);
                    let rub = friction.pin * load.pin_moment.abs() * sliding.signum();
                    let force = [0, 1].map(|k| load.pin_moment * across[k] + rub * along[k]);
                    let size = force[0].hypot(force[1]);
                    let on_wheel = sense * cross([touch[0] - axis[0], touch[1] - axis[1]], force);
                    let needs = INERTIA * SPEED * SPEED * motion.acceleration + friction.wheel_torque;
                    assert_relative_eq!(on_wheel, needs + friction.wheel_bearing * size, epsilon = 1e-12);
                    assert_relative_eq!(on_wheel, load.wheel_torque, epsilon = 1e-12);
                    let on_driver = -cross(touch, force);
                    let given = -on_driver + friction.driver_bearing * size + friction.driver_torque;
                    assert_relative_eq!(given, load.crank_torque, epsilon = 1e-12);
                    *(if flank > 0.0 { &mut forward } else { &mut held }) += 1;
                }
            }
        }
        assert!(forward > 100 && held > 30, "{stations}: {forward} and {held}");
    }
}

/// The escapement has an equation of motion of its own: with our crank torque as its torque, its driver keeps its speed.
#[test]
fn an_escapement_with_this_torque_keeps_its_speed() {
    let mut compared = 0;
    for (mechanism, stations) in [(Mechanism::SIX_PIN, 3), (Mechanism::FOUR_PIN, 4), (Mechanism::THREE_PIN, 6)] {
        let wheel = Wheel::new(stations).unwrap();
        let friction =
            Friction { pin_radius: 0.05, wheel_bearing: 0.01, driver_bearing: 0.02, dwell_torque: 0.0, ..ALL };
        let loads = WheelLoads::with_friction(&wheel, INERTIA, friction, SPEED).unwrap();
        let joints = Joints {
            pin_radius: 0.05,
            driver_journal: 0.2,
            follower_journal: 0.1,
            bearing_friction: 0.1,
            driver_drag_torque: friction.driver_torque,
            follower_drag_torque: friction.wheel_torque,
        };
        for step in -49..50 {
            let crank = wheel.engagement_half_angle() * f64::from(step) / 50.0;
            let load = loads.load(crank).unwrap();
            if load.crank_torque <= friction.driver_torque {
                continue;
            }
            let inertias = Inertias::new(0.5, INERTIA).unwrap();
            let timer = Parameters::new(mechanism, inertias, load.crank_torque, friction.pin).unwrap();
            let motion = Escapement::new(&timer, joints).unwrap().motion(crank, SPEED).unwrap();
            assert_abs_diff_eq!(motion.angular_acceleration, 0.0, epsilon = 1e-9);
            assert_relative_eq!(motion.normal_moment, load.pin_moment, max_relative = 1e-9, epsilon = 1e-9);
            compared += 1;
        }
    }
    assert!(compared > 150, "{compared}");
}

/// The crank's work over a turn is what each thing that rubs takes, each summed at equal steps.
#[test]
fn the_mean_torque_pays_for_all_friction() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        for friction in frictions() {
            let loads = WheelLoads::with_friction(wheel, INERTIA, friction, SPEED).unwrap();
            let (end, steps) = (wheel.engagement_half_angle(), 20_000);
            let mut taken = 0.0;
            for step in 0..steps {
                let crank = end * (2.0 * (f64::from(step) + 0.5) / f64::from(steps) - 1.0);
                let (load, motion) = (loads.load(crank).unwrap(), wheel.engaged(crank).unwrap());
                let size = load.pin_moment.abs();
                let carried = size * friction.pin.hypot(1.0);
                let of_wheel = (friction.wheel_torque + friction.wheel_bearing * carried) * motion.velocity;
                let of_pin = friction.pin * size * load.sliding.abs();
                taken += (of_wheel + of_pin + friction.driver_bearing * carried) * 2.0 * end / f64::from(steps);
            }
            let pins = f64::from(wheel.pins());
            let dwell = friction.dwell_torque * (TAU - 2.0 * end * pins);
            let whole = taken * pins + dwell + friction.driver_torque * TAU;
            assert_relative_eq!(loads.mean_crank_torque() * TAU, whole, max_relative = 2e-5);
        }
    }
}

#[test]
fn every_peak_with_friction_is_that_of_a_fine_scan() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        for friction in frictions() {
            let loads = WheelLoads::with_friction(wheel, INERTIA, friction, SPEED).unwrap();
            let kinds: [fn(&Load) -> f64; 3] =
                [|load| load.wheel_torque, |load| load.pin_moment, |load| load.crank_torque];
            let found = [loads.wheel_torque(), loads.pin_moment(), loads.crank_torque()];
            for (of, found) in kinds.into_iter().zip(found) {
                let (most, least) = super::scan(&loads, wheel.engagement_half_angle(), of, 1500);
                let (driving, braking) = (found.driving.value, found.braking.map_or(0.0, |peak| peak.value));
                assert!(driving >= most * (1.0 - 1e-12) && driving <= most * (1.0 + 1e-3), "{driving} for {most}");
                let least = least.min(0.0);
                let near = braking <= least + 1e-12 * driving && (braking - least).abs() <= 3e-3 * driving;
                assert!(near, "{} stations, {friction:?}: {braking} for {least}, {driving}", wheel.stations());
            }
            let [sliding, power] = loads.greatest_sliding();
            let by_scan = |of: fn(&Load) -> f64| super::scan(&loads, wheel.engagement_half_angle(), of, 1500).0 * SPEED;
            assert_relative_eq!(sliding.value, by_scan(|load| load.sliding.abs()), max_relative = 1e-3);
            assert_relative_eq!(
                power.value,
                by_scan(|load| (load.sliding * load.pin_moment).abs()),
                max_relative = 1e-3
            );
        }
    }
}

#[test]
fn the_mean_square_with_friction_is_that_of_another_rule() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        for friction in frictions() {
            let loads = WheelLoads::with_friction(wheel, INERTIA, friction, SPEED).unwrap();
            let (end, steps) = (wheel.engagement_half_angle(), 20_000);
            let torque = |step: i32| {
                let crank = end * (2.0 * (f64::from(step) + 0.5) / f64::from(steps) - 1.0);
                loads.load(crank).unwrap().crank_torque
            };
            let index: f64 =
                (0..steps).map(|step| torque(step) * torque(step)).sum::<f64>() * 2.0 * end / f64::from(steps);
            let pins = f64::from(wheel.pins());
            let dwell = (friction.driver_torque + friction.dwell_torque).powi(2) * (TAU - 2.0 * end * pins);
            let right = ((index * pins + dwell) / TAU).sqrt();
            assert_relative_eq!(loads.rms_crank_torque(), right, max_relative = 1e-4);
        }
    }
}

#[test]
fn friction_of_the_pin_adds_what_the_work_along_its_slot_is() {
    let wheel = Wheel::with_pins(6, 2).unwrap();
    let with = |pin: f64| {
        let friction = Friction { pin, ..Friction::of_wheel(0.1) };
        WheelLoads::with_friction(&wheel, 2e-3, friction, 6.0).unwrap()
    };
    let [none, little, much] = [0.0, 0.15, 0.3].map(|pin| with(pin).mean_crank_torque());
    // Of a pin that is a point the force doesn't depend on the friction, so twice the friction takes twice as much.
    assert_relative_eq!(much - none, 2.0 * (little - none), max_relative = 1e-12);
    assert!(with(0.15).crank_torque().driving.value > with(0.0).crank_torque().driving.value);
    // Nothing rubs: nothing is needed in the mean.
    assert_eq!(WheelLoads::new(&wheel, 2e-3, 0.0, 6.0).unwrap().mean_crank_torque(), 0.0);
}

/// Torque on the wheel, force of the disc and friction as vectors.
#[test]
fn the_locking_disc_holds_the_wheel_and_brakes_the_driver() {
    let disc = DwellContact { centre_distance: 0.05, radius: 0.019, end_angle: 0.6, friction: 0.2 };
    let (held, bearing) = (1.5, 0.001);
    let force = disc.force(held).unwrap();
    // The driver's axis at the origin, the wheel's at (c, 0); the disc turns counterclockwise, so it drags the wheel clockwise about
    // its own axis, which is the wheel's sense. The arc's end that stops the wheel is the one below.
    let touch = [0.019 * 0.6_f64.cos(), -0.019 * 0.6_f64.sin()];
    let outward = [0.6_f64.cos(), -(0.6_f64.sin())];
    let onward = [0.6_f64.sin(), 0.6_f64.cos()];
    let on_wheel = [0, 1].map(|k| force * (outward[k] + 0.2 * onward[k]));
    let moment = cross([touch[0] - 0.05, touch[1]], on_wheel);
    // It turns the wheel back, counterclockwise.
    assert_relative_eq!(moment, held, max_relative = 1e-12);
    let brakes = cross(touch, on_wheel) + bearing * on_wheel[0].hypot(on_wheel[1]);
    assert_relative_eq!(disc.driver_torque(held, bearing).unwrap(), brakes, max_relative = 1e-12);
    let sticky = DwellContact { friction: 3.0, ..disc };
    assert!(matches!(sticky.force(1.0), Err(DynamicsError::SelfLocking { .. })));
    assert!(matches!(disc.force(-1.0), Err(DynamicsError::Negative { .. })));
}

#[test]
fn impossible_friction_is_refused() {
    let wheel = Wheel::new(4).unwrap();
    let refused = |friction: Friction| WheelLoads::with_friction(&wheel, 1.0, friction, 1.0).err();
    for wrong in [-0.1, f64::NAN, f64::INFINITY] {
        for friction in [
            Friction { pin: wrong, ..Friction::NONE },
            Friction { pin_radius: wrong, ..Friction::NONE },
            Friction { wheel_bearing: wrong, ..Friction::NONE },
            Friction { driver_bearing: wrong, ..Friction::NONE },
            Friction { driver_torque: wrong, ..Friction::NONE },
            Friction { dwell_torque: wrong, ..Friction::NONE },
        ] {
            assert!(matches!(refused(friction), Some(DynamicsError::Negative { .. })), "{friction:?}");
        }
    }
    let thick = Friction { pin_radius: 1.0, ..Friction::NONE };
    assert!(matches!(refused(thick), Some(DynamicsError::PinTooThick { .. })));
    // The pin comes to √2 − 1 crank radii from the wheel's axis.
    let [free, stuck] = [0.414, 0.415].map(|wheel_bearing| refused(Friction { wheel_bearing, ..Friction::NONE }));
    assert!(free.is_none() && matches!(stuck, Some(DynamicsError::SelfLocking { .. })), "{stuck:?}");
}
