//! The loads, compared with a fine scan and with laws of mechanics, and at their limits.

mod drive;
mod friction;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use geneva_dynamics::DynamicsError;
use geneva_dynamics::wheel_loads::{Load, Peak, WheelLoads};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use geneva_kinematics::wheel::Wheel;

fn wheels() -> Vec<Box<dyn Indexing>> {
    let mut wheels: Vec<Box<dyn Indexing>> = Vec::new();
    for stations in (3..=13).chain([24, 60, 300]) {
        wheels.push(Box::new(Wheel::new(stations).expect("possible")));
        wheels.push(Box::new(InternalWheel::new(stations).expect("possible")));
        wheels.push(Box::new(SphericalWheel::new(stations).expect("possible")));
    }
    wheels.push(Box::new(Wheel::with_pins(4, 3).expect("possible")));
    wheels
}

const INERTIA: f64 = 0.02;
const SPEED: f64 = 7.0;

/// Frictions from none to more than any inertia of this wheel, in N m.
fn frictions(wheel: &dyn Indexing) -> Vec<f64> {
    let most = INERTIA * SPEED * SPEED * wheel.acceleration_peak().ratio;
    let entry = INERTIA * SPEED * SPEED * wheel.entry_acceleration();
    let between = 0.5 * (most + entry);
    let mut frictions =
        vec![0.0, 0.01 * entry, 0.4 * entry, 0.99 * entry, between, 0.999 * most, 1.5 * most, 20.0 * most];
    if wheel.stations() == 3 {
        // The crank torque of the internal wheel has two maxima for some of these.
        frictions.extend((430..480).step_by(4).map(|k| 1e-3 * f64::from(k) * entry));
    }
    frictions
}

fn scan(loads: &WheelLoads<'_, dyn Indexing>, end: f64, of: fn(&Load) -> f64, steps: i32) -> (f64, f64) {
    let values = (-steps..=steps).map(|k| of(&loads.load(end * (f64::from(k) / f64::from(steps))).expect("engaged")));
    values.fold((f64::NEG_INFINITY, f64::INFINITY), |(most, least), value| (most.max(value), least.min(value)))
}

#[test]
fn every_peak_is_that_of_a_fine_scan() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        for friction in frictions(wheel) {
            let loads = WheelLoads::new(wheel, INERTIA, friction, SPEED).expect("possible");
            let kinds: [fn(&Load) -> f64; 3] =
                [|load| load.wheel_torque, |load| load.pin_moment, |load| load.crank_torque];
            let found = [loads.wheel_torque(), loads.pin_moment(), loads.crank_torque()];
            for (kind, (of, found)) in kinds.into_iter().zip(found).enumerate() {
                let told = format!("{} stations, friction {friction}, load {kind}", wheel.stations());
                let (most, least) = scan(&loads, wheel.engagement_half_angle(), of, 1500);
                let value = |peak: Peak| of(&loads.load(peak.angle).expect("engaged"));
                assert_relative_eq!(value(found.driving), found.driving.value, max_relative = 1e-9);
                assert!(found.driving.value >= most * (1.0 - 1e-12), "{told}: {} below {most}", found.driving.value);
                assert!(found.driving.value <= most * (1.0 + 1e-4), "{told}: {} above {most}", found.driving.value);
                let scale = found.driving.value;
                let braking = found.braking.map_or(0.0, |peak| peak.value);
                // Of the crank torque and the force without a reversal the least is at an end of the engagement.
                let least = least.min(0.0);
                assert!((braking - least).abs() <= 1e-4 * scale, "{told}: {braking} is not {least}");
                assert!(braking <= least + 1e-12 * scale, "{told}: {braking} above {least}");
            }
        }
    }
}

#[test]
fn the_crank_works_what_friction_takes() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        for friction in frictions(wheel) {
            let loads = WheelLoads::new(wheel, INERTIA, friction, SPEED).expect("possible");
            let taken = friction * 2.0 * wheel.half_pitch_angle();
            let scale = INERTIA * SPEED * SPEED * wheel.peak_velocity() * wheel.peak_velocity();
            assert_abs_diff_eq!(loads.work(), taken, epsilon = 1e-12 * (scale + taken));
            let of_a_turn = loads.mean_crank_torque() * std::f64::consts::TAU;
            assert_relative_eq!(of_a_turn, taken * f64::from(wheel.pins()), max_relative = 1e-13);
        }
    }
}

#[test]
fn the_torque_changes_sign_where_it_is_said_to() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        for friction in frictions(wheel) {
            let loads = WheelLoads::new(wheel, INERTIA, friction, SPEED).expect("possible");
            let (from, until) = loads.reversal().unwrap_or((f64::INFINITY, f64::INFINITY));
            let end = wheel.engagement_half_angle();
            for step in -500..=500 {
                let crank = end * (f64::from(step) / 500.0);
                let torque = loads.load(crank).expect("engaged").wheel_torque;
                // Where the torque is zero but for rounding it has no sign.
                if torque.abs() > 1e-9 * loads.wheel_torque().driving.value {
                    let braked = (from..=until).contains(&crank);
                    assert_eq!(torque < 0.0, braked, "{} stations, {friction}: {torque} at {crank}", wheel.stations());
                }
            }
        }
    }
}

/// By another rule on many more places: the trapezoids'.
#[test]
fn the_mean_square_is_that_of_another_rule() {
    for wheel in wheels() {
        let wheel = wheel.as_ref();
        for friction in frictions(wheel) {
            let loads = WheelLoads::new(wheel, INERTIA, friction, SPEED).expect("possible");
            let (end, steps) = (wheel.engagement_half_angle(), 4_000);
            let torque = |k: i32| loads.load(end * (f64::from(k) / f64::from(steps))).expect("engaged").crank_torque;
            // The torque is zero at both ends, so every place counts alike.
            let sum: f64 = (-steps..=steps).map(|k| torque(k) * torque(k)).sum();
            let mean = sum * end / f64::from(steps) * f64::from(wheel.pins()) / std::f64::consts::TAU;
            assert_relative_eq!(loads.rms_crank_torque(), mean.sqrt(), max_relative = 1e-5);
        }
    }
}

/// Newton's second law in the rotating frame: across the slot the pin's force turns the wheel, and nothing else does.
#[test]
fn a_light_wheel_with_a_mass_at_the_pin_is_pushed_as_the_mass_is() {
    // All inertia of the wheel is a mass that happens to be where the pin is: m r² = J.
    let wheel = Wheel::new(5).expect("possible");
    let crank = -0.31;
    let pin = wheel.pin_in_slot(crank).expect("engaged");
    let (mass, radius) = (2.0, 0.04);
    let arm = pin.radius * radius;
    let loads = WheelLoads::new(&wheel, mass * arm * arm, 0.0, SPEED).expect("possible");
    let force = loads.load(crank).expect("engaged").pin_moment / radius;
    let across = mass * arm * SPEED * SPEED * wheel.engaged(crank).expect("engaged").acceleration;
    assert_relative_eq!(force, across, max_relative = 1e-13);
}

#[test]
fn without_inertia_the_load_is_the_friction_alone() {
    let wheel = Wheel::new(6).expect("possible");
    let loads = WheelLoads::new(&wheel, 0.0, 3.0, SPEED).expect("possible");
    assert_eq!(loads.reversal(), None);
    assert_eq!(loads.wheel_torque().driving.value, 3.0);
    // The pin is nearest to the wheel's axis on the line of centres, and the wheel is fastest there.
    for (peaks, value) in [
        (loads.pin_moment(), 3.0 / (Wheel::centre_distance_ratio(&wheel) - 1.0)),
        (loads.crank_torque(), 3.0 * wheel.peak_velocity()),
    ] {
        assert_abs_diff_eq!(peaks.driving.angle, 0.0, epsilon = 1e-6);
        assert_relative_eq!(peaks.driving.value, value, max_relative = 1e-12);
        assert_eq!(peaks.braking, None);
    }
    let free = WheelLoads::new(&wheel, 0.0, 0.0, SPEED).expect("possible");
    assert_eq!([free.rms_crank_torque(), free.work(), free.crank_torque().driving.value], [0.0; 3]);
}

#[test]
fn loads_grow_with_the_square_of_the_speed_and_with_the_inertia() {
    let wheel = InternalWheel::new(5).expect("possible");
    let of = |inertia: f64, speed: f64| {
        let loads = WheelLoads::new(&wheel, inertia, 0.0, speed).expect("possible");
        [loads.crank_torque().driving.value, loads.pin_moment().driving.value, loads.rms_crank_torque()]
    };
    for (one, many) in of(1.0, 2.0).into_iter().zip(of(3.0, 10.0)) {
        assert_relative_eq!(75.0 * one, many, max_relative = 1e-12);
    }
}

#[test]
fn without_friction_the_mean_square_is_the_same_part_of_the_peak_at_any_inertia_and_speed() {
    for stations in [3, 6, 8, 12] {
        let wheel = Wheel::new(stations).unwrap();
        let share = |inertia: f64, speed: f64| {
            let loads = WheelLoads::new(&wheel, inertia, 0.0, speed).unwrap();
            loads.rms_crank_torque() / loads.crank_torque().driving.value
        };
        assert_relative_eq!(share(0.37, 21.0), share(1.0, 1.0), max_relative = 1e-9);
    }
}

#[test]
fn what_no_wheel_can_carry_is_refused() {
    let wheel = Wheel::new(4).expect("possible");
    let refused = |inertia: f64, friction: f64, speed: f64| WheelLoads::new(&wheel, inertia, friction, speed).err();
    for wrong in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(wrong, 0.0, 1.0), Some(DynamicsError::Negative { .. })), "{wrong}");
        assert!(matches!(refused(1.0, wrong, 1.0), Some(DynamicsError::Negative { .. })), "{wrong}");
        assert!(matches!(refused(1.0, 0.0, wrong), Some(DynamicsError::NotPositive { .. })), "{wrong}");
    }
    assert!(matches!(refused(1.0, 0.0, 0.0), Some(DynamicsError::NotPositive { .. })));
    assert!(matches!(refused(1.0, 0.0, 1e200), Some(DynamicsError::Negative { .. })));
    let loads = WheelLoads::new(&wheel, 1.0, 0.0, 1.0).expect("possible");
    assert!(matches!(loads.load(1.0), Err(KinematicsError::OutsideEngagement { .. })));
}

/// R. C. Hibbeler, *Engineering Mechanics: Dynamics*, problem 16-49: a wheel of four slots, whose driver of r = 100 mm turns at 2 rad/s;
/// the axes are √2 r apart, so that it rests as the pin enters (the text that we read has lost the root). The manual of its solutions, read at coursehero.com, closes the loop by r cos θ + s cos φ = √2 r and
/// r sin θ = s sin φ, and differentiates both. At θ = 30° that gives the wheel's speed, and so what a torque on it asks of the driver.
#[test]
fn the_wheel_of_hibbeler_asks_for_the_torque_that_virtual_work_says() {
    let (r, driver, theta) = (0.1, 2.0, 30_f64.to_radians());
    let (along, across) = (2_f64.sqrt() * r - r * theta.cos(), r * theta.sin());
    let (s, phi) = (along.hypot(across), across.atan2(along));
    // −r sin θ ω + s' cos φ − s sin φ ω' = 0 and r cos θ ω = s' sin φ + s cos φ ω': two equations for s' and ω'.
    let (right, up) = (r * theta.sin() * driver, r * theta.cos() * driver);
    let wheel_speed = (up * phi.cos() - right * phi.sin()) / s;
    assert_relative_eq!(wheel_speed, 0.816, max_relative = 1e-3);
    let wheel = Wheel::new(4).expect("possible");
    let loads = WheelLoads::new(&wheel, 0.0, 1.5, driver).expect("possible");
    let load = loads.load(-theta).expect("engaged");
    assert_relative_eq!(load.crank_torque, 1.5 * wheel_speed / driver, max_relative = 1e-12);
    assert_relative_eq!(load.pin_moment / r, 1.5 / s, max_relative = 1e-12);
}
