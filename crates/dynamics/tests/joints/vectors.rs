//! The instant from vectors: positions, velocities and forces, and a linear system instead of the closed formulas.

use super::*;
use geneva_dynamics::Sign;
use geneva_kinematics::Turn;
use nalgebra::{Matrix3, Vector2, Vector3};

/// Counter-clockwise moment of a force at an arm.
fn moment(arm: Vector2<f64>, force: Vector2<f64>) -> f64 {
    arm.x * force.y - arm.y * force.x
}

/// The velocity of an arm that turns counter-clockwise at the speed one.
fn turned(arm: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-arm.y, arm.x)
}

/// One instant with the contact on one flank.
struct Instant {
    /// Unit vectors along the slot and across it.
    along: Vector2<f64>,
    across: Vector2<f64>,
    /// From the driver's and from the follower's axis to the point of contact.
    from_driver: Vector2<f64>,
    from_follower: Vector2<f64>,
    speed: f64,
    follower_speed: f64,
    /// Velocity of the pin's surface less that of the slot's side, along the slot.
    sliding: f64,
    /// Velocity of the same across the slot.
    parting: f64,
    /// θ'', φ'' and N r.
    solution: Vector3<f64>,
    /// Force of the contact on the follower.
    force: Vector2<f64>,
}

impl Instant {
    fn new(parameters: &Parameters, joints: &Joints, angle: f64, speed: f64, flank: Sign) -> Self {
        let Turn { cos, sin } = Turn::from_radians(angle);
        let pin = Vector2::new(cos, sin);
        let reach = pin - Vector2::new(parameters.mechanism().centre_distance_ratio(), 0.0);
        let (radius, along) = (reach.norm(), reach.normalize());
        // The follower turns clockwise.
        let across = Vector2::new(along.y, -along.x);
        let velocity = turned(pin) * speed;
        let (outward, follower_speed) = (velocity.dot(&along), velocity.dot(&across) / radius);
        let side = flank.apply(1.0);
        let offset = across * (side * joints.pin_radius);
        let (from_driver, from_follower) = (pin + offset, reach + offset);
        let relative = turned(from_driver) * speed - turned(from_follower) * -follower_speed;
        let sliding = relative.dot(&along);
        let friction = parameters.friction() * side * Sign::from_number(sliding).apply(1.0);
        // Per unit of N; |N| is `side` times N.
        let force = across + along * friction;
        let bearing = |journal: f64| side * joints.bearing_friction * journal * force.norm();
        let inertias = parameters.inertias();
        // Unknowns: θ'', φ'', N. Rows: the pin stays in the slot; moments on the follower; moments on the driver.
        let system = Matrix3::new(
            -turned(pin).dot(&across),
            radius,
            0.0,
            0.0,
            inertias.follower(),
            moment(from_follower, force) + bearing(joints.follower_journal),
            inertias.driver(),
            0.0,
            moment(from_driver, force) + bearing(joints.driver_journal),
        );
        let across_rate = -(pin * (speed * speed)).dot(&across) - 2.0 * outward * follower_speed;
        let known =
            Vector3::new(across_rate, -joints.follower_drag_torque, parameters.torque() - joints.driver_drag_torque);
        let solution = system.lu().solve(&known).expect("three independent equations");
        let force = force * solution[2];
        let parting = relative.dot(&across);
        Self { along, across, from_driver, from_follower, speed, follower_speed, sliding, parting, solution, force }
    }
}

/// θ'' from the vectors alone, by the flank that the normal force agrees with.
pub(super) fn angular_acceleration(escapement: &Escapement, angle: f64, speed: f64) -> f64 {
    let (parameters, joints) = (escapement.parameters(), escapement.joints());
    let solution = |flank| Instant::new(parameters, &joints, angle, speed, flank).solution;
    let [leading, trailing] = Sign::BOTH.map(solution);
    if leading[2] >= 0.0 { leading[0] } else { trailing[0] }
}

/// The flanks that agree with the normal force that they lead to, of an escapement that may jam.
pub(super) fn solutions(parameters: &Parameters, joints: &Joints, angle: f64, speed: f64) -> Vec<Sign> {
    let agrees = |flank: &Sign| flank.apply(Instant::new(parameters, joints, angle, speed, *flank).solution[2]) >= 0.0;
    Sign::BOTH.into_iter().filter(agrees).collect()
}

/// Escapements, angles and speeds of all kinds, with the instant on the flank that the normal force agrees with.
fn for_instants(mut check: impl FnMut(&Escapement, f64, &Instant, Sign)) {
    let (mut spread, mut seen) = (Spread(0.0), [0; 4]);
    for round in 0..2_000 {
        let mechanism = Mechanism::ALL[round % 3];
        let parameters = parameters(mechanism, spread.between(0.05, 2.0), spread.between(0.0, 0.35));
        let mut joints = spread.joints();
        if round % 7 == 0 {
            joints = Joints { pin_radius: joints.pin_radius, ..Joints::IDEAL };
        }
        let Ok(escapement) = Escapement::new(&parameters, joints) else { continue };
        for _ in 0..4 {
            let angle = mechanism.engagement_half_angle() * spread.between(-0.999, 0.999);
            let speed = spread.between(0.0, 4.0);
            let sound: Vec<_> = Sign::BOTH
                .into_iter()
                .map(|flank| (flank, Instant::new(&parameters, &joints, angle, speed, flank)))
                .filter(|(flank, instant)| flank.apply(instant.solution[2]) >= 0.0)
                .collect();
            assert_eq!(sound.len(), 1, "{escapement:?} {angle} {speed}");
            let (flank, instant) = &sound[0];
            seen[usize::from(*flank == Sign::Plus) + 2 * usize::from(instant.sliding > 0.0)] += 1;
            check(&escapement, angle, instant, *flank);
        }
    }
    println!("on the trailing and leading flank, inward and outward: {seen:?} instants");
    assert!(seen.iter().all(|count| *count > 100), "{seen:?}");
}

#[test]
fn newton_and_euler_say_the_same_by_vectors() {
    for_instants(|escapement, angle, instant, flank| {
        let motion = escapement.motion(angle, instant.speed).expect("one acceleration");
        assert_eq!(motion.flank, flank);
        let ours = [
            motion.angular_acceleration,
            motion.follower_acceleration,
            motion.normal_moment,
            motion.sliding * instant.speed,
        ];
        let witness = [instant.solution[0], instant.solution[1], instant.solution[2], instant.sliding];
        let scale = 1.0 + instant.speed * instant.speed + witness.iter().fold(0.0, |most, one| one.abs().max(most));
        for (ours, witness) in ours.into_iter().zip(witness) {
            assert!((ours - witness).abs() < 1e-12 * scale, "{escapement:?} {angle} {ours} {witness}");
        }
    });
}

#[test]
fn the_surfaces_neither_part_nor_meet_and_the_forces_are_opposite() {
    for_instants(|escapement, angle, instant, _| {
        let scale = 1.0 + instant.speed + instant.force.norm() * (1.0 + instant.speed);
        assert!(instant.parting.abs() < 1e-13 * scale, "{angle} {}", instant.parting);
        // What the two forces do, each at the velocity of the body that it acts on, is what friction takes.
        let on_driver = (-instant.force).dot(&(turned(instant.from_driver) * instant.speed));
        let on_follower = instant.force.dot(&(turned(instant.from_follower) * -instant.follower_speed));
        let lost = escapement.power(angle, instant.speed).expect("sound").sliding;
        assert!((on_driver + on_follower + lost).abs() < 1e-12 * scale, "{angle} {on_driver} {on_follower} {lost}");
        // The friction alone is along the slot, against the sliding on the driver and with it on the follower.
        let along = instant.along.dot(&instant.force);
        let size = escapement.parameters().friction() * instant.across.dot(&instant.force).abs();
        assert!((along.abs() - size).abs() < 1e-12 * scale);
        assert!(along * instant.sliding >= 0.0);
    });
}

#[test]
fn the_power_of_the_spring_goes_into_motion_and_friction() {
    for_instants(|escapement, angle, instant, _| {
        let power = escapement.power(angle, instant.speed).expect("sound");
        let inertias = escapement.parameters().inertias();
        let growth = inertias.driver() * instant.speed * instant.solution[0]
            + inertias.follower() * instant.follower_speed * instant.solution[1];
        let scale = 1.0 + power.input.abs() + power.losses() + instant.speed * instant.speed * instant.speed;
        assert!((power.growth() - growth).abs() < 1e-12 * scale, "{angle} {power:?} {growth}");
        // Each loss from vectors.
        let (joints, load) = (escapement.joints(), instant.force.norm());
        let journal = |radius: f64, drag_torque: f64| joints.bearing_friction * radius * load + drag_torque;
        let driver = journal(joints.driver_journal, joints.driver_drag_torque) * instant.speed;
        let follower = journal(joints.follower_journal, joints.follower_drag_torque) * instant.follower_speed;
        for (ours, witness) in [(power.driver_bearing, driver), (power.follower_bearing, follower)] {
            assert!((ours - witness).abs() < 1e-12 * scale, "{ours} {witness}");
        }
        assert!(power.sliding >= 0.0 && power.driver_bearing >= 0.0 && power.follower_bearing >= 0.0);
    });
}
