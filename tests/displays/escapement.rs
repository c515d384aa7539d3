//! The escapement in many states of motion, as the programs compute them: what the letters of its chapter stand for.

use super::spread;
use geneva_dynamics::energy::kinetic_energy;
use geneva_dynamics::equation::{coefficient_a, coefficient_b};
use geneva_dynamics::existence::critical_friction;
use geneva_dynamics::{Inertias, Parameters, Pose, Sign};
use geneva_evidence::tex::{By, Moment};
use geneva_kinematics::escapement::{ContinuousEscapement, possible_pairs};
use geneva_kinematics::{Jet, Mechanism, Turn, pin_slot};

/// All three mechanisms, with many inertias, torques, frictions, angles and speeds.
pub(super) fn states() -> Vec<Moment> {
    (0..45).map(state).collect()
}

/// The escapement at many instants, with the square of the speed as a function of the angle: u' is twice the acceleration.
pub(super) fn over_the_angle() -> Vec<Moment> {
    let squared = |state: Moment| {
        let [speed, angular_acceleration, follower] =
            ["theta'", "theta''", "varphi'"].map(|name| state.letters()[name]);
        state.with([("u", speed * speed), ("u'", 2.0 * angular_acceleration), ("q", follower / speed)])
    };
    states().into_iter().map(squared).collect()
}

/// Other numbers of pins and slots than those of the three mechanisms too, as one pin takes over from the next.
pub(super) fn taking_over(number: usize) -> Moment {
    let pairs = (2..=8).flat_map(|pins| (3..=8).filter_map(move |slots| ContinuousEscapement::new(pins, slots)));
    let pairs: Vec<ContinuousEscapement> = pairs.collect();
    let pair = pairs[number % pairs.len()];
    let (ratio, speed) = (pair.centre_distance_ratio(), 0.2 + 4.0 * spread(number, 5));
    let follower = pin_slot::velocity_ratio(&ratio, &Turn::from_radians(pair.engagement_half_angle())) * speed;
    Moment::default()
        .with([("k", ratio), ("m", f64::from(pair.pins())), ("N", f64::from(pair.slots()))])
        .with([(r"\dot\theta", speed), (r"\dot\varphi", follower)])
}

/// One of the three mechanisms as one pin takes over from the next: the angles, by the pin's place.
pub(super) fn at_the_hand_over(number: usize) -> Moment {
    let mechanism = Mechanism::ALL[number % 3];
    let angle = mechanism.engagement_half_angle();
    let pin = pin_slot::pin_from_pivot(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle));
    Moment::default()
        .with([("m", f64::from(mechanism.pins())), ("N", f64::from(mechanism.slots()))])
        .with([(r"\theta", angle), (r"\varphi", libm::atan2(pin.y, pin.x))])
}

/// One state of the mechanism, of many.
fn state(number: usize) -> Moment {
    let mechanism = Mechanism::ALL[number % 3];
    let between = |which, least: f64, most: f64| least + (most - least) * spread(number, which);
    let inertias = Inertias::new(between(0, 0.1, 2.0), between(1, 0.5, 3.0)).expect("two inertias");
    let limit = critical_friction(mechanism, inertias.ratio()).expect("a limit").friction;
    let (torque, friction) = (between(2, 0.5, 4.0), limit * between(3, 0.1, 0.9));
    let escapement = Parameters::new(mechanism, inertias, torque, friction).expect("an escapement");
    let half = mechanism.engagement_half_angle();
    let angle = half * between(4, -0.98, 0.98);
    let (speed, radius) = (between(5, 0.2, 4.0), between(6, 0.5, 2.0));

    let found = escapement.acceleration(angle, speed).expect("one acceleration");
    let forces = escapement.contact_forces(angle, speed).expect("one acceleration");
    let (pose, factors) = (escapement.pose(angle), escapement.coefficients(angle));
    let pin = pin_slot::pin_from_pivot(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle)) * radius;
    let follower = libm::atan2(pin.y, pin.x);
    let start = escapement.acceleration(-half, 0.0).expect("one acceleration");
    let energy = Energy::of(&pose, speed, found.value, &inertias);
    let all = possible_pairs();
    let (count, pins) = *all.iter().find(|(count, _)| *count == mechanism.slots()).expect("one that is possible");
    let ratio = mechanism.wheel().centre_distance_ratio();
    let velocity = pin_slot::velocity_ratio(&ratio, &Turn::from_radians(angle)) * speed;
    // The equation of motion is put together from the same terms.
    let driven = coefficient_a(&pose, &inertias.ratio()) * found.value + coefficient_b(&pose) * speed * speed;
    approx::assert_relative_eq!(energy.growth - energy.by_angle, driven * inertias.follower(), epsilon = 1e-9);
    approx::assert_abs_diff_eq!(factors.residual(&speed, &found.value, found.sign), 0.0, epsilon = 1e-9);

    Moment::default()
        .with([("k", ratio), ("N", f64::from(count)), ("m", f64::from(pins)), ("R", radius), ("l", ratio * radius)])
        .with([(r"\theta", angle), (r"\dot\theta", speed), (r"\ddot\theta", found.value)])
        .with([(r"\varphi", follower), (r"\dot\varphi", velocity)])
        .with([(r"\ddot\varphi", forces.follower_acceleration), ("r", pin.norm())])
        .with([(r"\theta_0", half), (r"\varphi_0", libm::atan2(libm::sin(half), ratio - libm::cos(half)))])
        .with([("F", forces.normal_force(radius)), (r"\tau_2", -forces.friction_torque)])
        .with([("I_D", inertias.driver()), ("I_f", inertias.follower()), ("K", torque), (r"\mu", friction)])
        .with([("A", factors.a), ("B", factors.b), ("C", factors.c), ("D", factors.d), ("E", factors.e)])
        .with([("S", if found.sign == Sign::Plus { 1.0 } else { -1.0 }), (r"\ddot\theta_0", start.value)])
        .with([("T", energy.value), (r"\frac{\partial T}{\partial\theta}", energy.by_angle)])
        .with([(r"\frac{\partial T}{\partial\dot\theta}", energy.by_speed)])
        .changing(By::Time, [("dT/dtheta'", energy.growth)])
}

/// The kinetic energy and its derivatives, by power series in time and in the speed.
struct Energy {
    value: f64,
    by_angle: f64,
    by_speed: f64,
    /// d/dt of the derivative by the speed.
    growth: f64,
}

impl Energy {
    fn of(pose: &Pose<f64>, speed: f64, angular_acceleration: f64, inertias: &Inertias) -> Self {
        type Time = Jet<f64, 3>;
        let scale = inertias.follower();
        let by_angle = pose.moving_by(&Jet::<f64, 2>::variable(0.0));
        let constants = (Jet::constant(speed), Jet::constant(inertias.ratio()));
        let by_angle = kinetic_energy(&by_angle.velocity_ratio(), &constants.0, &constants.1);
        // Along the motion, with another speed at every instant.
        let moving = pose.moving_by(&Time::from_coefficients([0.0, speed, angular_acceleration / 2.0]));
        let speeds = Jet::<Time, 2>::variable(Time::from_coefficients([speed, angular_acceleration, 0.0]));
        let ratio = Jet::constant(moving.velocity_ratio());
        let by_speed = kinetic_energy(&ratio, &speeds, &Jet::constant(Jet::constant(inertias.ratio()))).rate();
        Self {
            value: scale * by_angle.value(),
            by_angle: scale * by_angle.rate(),
            by_speed: scale * by_speed.value(),
            growth: scale * by_speed.rate(),
        }
    }
}
