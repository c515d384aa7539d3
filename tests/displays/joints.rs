//! The escapement with a pin of finite radius and rubbing journals: what the letters of its chapter stand for.

use super::spread;
use geneva_dynamics::existence::critical_friction;
use geneva_dynamics::joints::{Escapement, Joints};
use geneva_dynamics::{Inertias, Parameters, Sign};
use geneva_evidence::tex::Moment;
use geneva_kinematics::Mechanism;
use geneva_kinematics::{Turn, pin_slot};

/// All three mechanisms, with many joints, on both flanks and with both senses of sliding.
pub(super) fn states() -> Vec<Moment> {
    (0..60).map(state).collect()
}

fn state(number: usize) -> Moment {
    let mechanism = Mechanism::ALL[number % 3];
    let between = |which, least: f64, most: f64| least + (most - least) * spread(number, which);
    let inertias = Inertias::new(between(0, 0.1, 2.0), between(1, 0.5, 3.0)).expect("two inertias");
    let limit = critical_friction(mechanism, inertias.ratio()).expect("a limit").friction.min(1.0);
    let (torque, friction) = (between(2, 1.0, 4.0), limit * between(3, 0.1, 0.5));
    let parameters = Parameters::new(mechanism, inertias, torque, friction).expect("an escapement");
    let joints = Joints {
        pin_radius: between(4, 0.01, 0.1),
        driver_journal: between(5, 0.01, 0.1),
        follower_journal: between(6, 0.01, 0.1),
        bearing_friction: between(7, 0.01, 0.2),
        driver_drag_torque: between(8, 0.01, 0.2),
        follower_drag_torque: between(9, 0.01, 0.1),
    };
    let escapement = Escapement::new(&parameters, joints).expect("it neither locks nor jams");
    let angle = mechanism.engagement_half_angle() * between(10, -0.98, 0.98);
    let speed = between(11, 0.2, 4.0);
    let motion = escapement.motion(angle, speed).expect("one motion");

    let (ratio, crank) = (mechanism.centre_distance_ratio(), Turn::from_radians(angle));
    let (radius, slide) = {
        let radius = pin_slot::pin_from_pivot(&ratio, &crank).norm();
        (radius, ratio * crank.sin / radius)
    };
    let q = pin_slot::velocity_ratio(&ratio, &crank);
    let load = joints.bearing_friction * (1.0 + friction * friction).sqrt();
    // The arms are what the moments and the force say they are.
    let moment = inertias.follower() * motion.follower_acceleration + joints.follower_drag_torque;
    let follower_arm = moment / motion.normal_moment;
    let driver_arm =
        (torque - joints.driver_drag_torque - inertias.driver() * motion.angular_acceleration) / motion.normal_moment;
    let sign = |sign: Sign| if sign == Sign::Plus { 1.0 } else { -1.0 };

    Moment::default()
        .with([("r", radius), (r"\dot r", slide * speed), (r"\frac{dr}{d\theta}", slide)])
        .with([("k", ratio), (r"\theta", angle)])
        .with([("q", q), ("p", parameters.pose(angle).acceleration_ratio()), (r"\dot\varphi", q * speed)])
        .with([
            (r"\dot\theta", speed),
            (r"\ddot\theta", motion.angular_acceleration),
            (r"\ddot\varphi", motion.follower_acceleration),
        ])
        .with([("w", motion.sliding * speed), ("F", motion.normal_moment), ("M", moment)])
        .with([("s", sign(motion.flank)), (r"\sigma", sign(Sign::from_number(motion.sliding)))])
        .with([(r"\kappa_f", follower_arm), (r"\kappa_D", driver_arm), (r"\kappa", driver_arm / follower_arm)])
        .with([("I_D", inertias.driver()), ("I_f", inertias.follower()), ("K", torque), (r"\mu", friction)])
        .with([("G", joints.driver_drag_torque), ("H", joints.follower_drag_torque), (r"\rho", joints.pin_radius)])
        .with([("b_D", load * joints.driver_journal), ("b_f", load * joints.follower_journal)])
}
