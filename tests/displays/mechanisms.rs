//! The other mechanisms in many states of motion: what the letters of their chapters stand for.

use super::spread;
use geneva_dynamics::line_contact::{LineContact, MATERIALS, contact_modulus};
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_evidence::tex::{By, Moment, Value};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::quick_return::series::polar_rates;
use geneva_kinematics::quick_return::{Branch, Drive, LeverMotion, QuickReturn};
use geneva_kinematics::wheel::{Choices, Scale, Sizes};
use geneva_kinematics::wheel::{Wheel, acceleration_ratio, gamma, jerk_ratio, unsteady_acceleration};
use geneva_kinematics::{Turn, pin_slot, pin_triangle, pin_vectors};
use geneva_mimic::runge_kutta_step;
use nalgebra::Vector1;
use std::convert::Infallible;
use std::f64::consts::PI;

fn between(number: usize, which: usize, least: f64, most: f64) -> f64 {
    least + (most - least) * spread(number, which)
}

/// A pin in a slot before the line of centres, where θ and φ are negative; at a given ratio of lengths or at many, and at
/// a given size of θ or at many.
pub(super) fn pin(number: usize, ratio: Option<f64>, angle: Option<f64>) -> Moment {
    let radius = between(number, 0, 0.5, 2.0);
    let ratio = ratio.unwrap_or(between(number, 1, 1.1, 4.0));
    let mechanism = pin_slot::PinSlot::new(radius, ratio * radius).expect("a mechanism");
    let angle = angle.unwrap_or(mechanism.engagement_half_angle() * between(number, 2, 0.02, 0.98));
    let (theta, speed) = (Turn::from_radians(angle), between(number, 3, 0.5, 3.0));
    let triangle = pin_triangle::solve(&mechanism, &theta, speed);
    let phi = theta.supplement();
    let vectors = pin_vectors::solve(&radius, &(ratio * radius), &phi, &speed).expect("off the pivot");
    // The driver turns counter-clockwise, the wheel clockwise.
    let rates = polar_rates(&(ratio * radius), &radius, &phi, &Drive::steady(speed)).expect("off the pivot");
    Moment::default()
        .with([
            ("R", radius),
            ("l", ratio * radius),
            ("k", ratio),
            (r"\theta", -angle),
            (r"\varphi", -triangle.angle_at_pivot),
        ])
        .with([("r", triangle.slot_radius), (r"\gamma", triangle.velocity_angle)])
        .with([("v_P", triangle.pin_speed), ("v_{P'}", triangle.slot_point_speed), ("v_{P/S}", triangle.sliding_speed)])
        .with([
            (r"\dot\theta", speed),
            (r"\dot\varphi", triangle.follower_speed),
            (r"\ddot\varphi", -rates.angular_acceleration),
        ])
        .with([("x", vectors.position.x), ("y", vectors.position.y)])
        .with([(r"\dot x", vectors.pin_velocity.x), (r"\dot y", vectors.pin_velocity.y)])
        .with([(r"\vec{v}_P", vectors.pin_velocity), (r"\vec{v}_{P'}", vectors.slot_point_velocity)])
        .with([(r"\vec{v}_{P/S}", vectors.sliding_velocity), (r"\overrightarrow{OP}", vectors.position)])
}

/// The quick-return mechanism on the branch of the source, its lever above the line of centres.
pub(super) fn quick_return(number: usize, acceleration: f64) -> Moment {
    let (crank, speed) = (between(number, 0, 0.5, 2.0), between(number, 1, 0.5, 3.0));
    let ground = crank * between(number, 2, 1.2, 3.0);
    let linkage = QuickReturn::new(ground, crank).expect("a linkage");
    let strokes = linkage.strokes();
    let limit = strokes.swing_limit.expect("it swings");
    let lever = limit * between(number, 3, 0.05, 0.95);
    let position = linkage.position_at_lever_degrees(lever.to_degrees(), Branch::Far).expect("within the swing");
    let drive = Drive { speed, acceleration };
    let motion = LeverMotion::new(&ground, &crank, &position.crank, &drive).expect("off the pivot");
    let (velocities, terms) = (&motion.velocities, &motion.accelerations);
    // As the source counts: towards the pivot along the lever; across it, as the pin's acceleration points.
    let (along, across) = (position.lever.direction(), pin_vectors::quarter_turn(&position.lever.direction()));
    let turning = velocities.follower_speed;
    let rates = polar_rates(&ground, &crank, &position.crank, &drive).expect("off the pivot");
    let distance = rates.position.norm();
    Moment::default()
        .with([(r"\dot r", rates.sliding * distance), (r"\ddot r", rates.sliding_rate * distance)])
        .with([(r"\dot\theta", speed), (r"\dot\varphi", turning), (r"\ddot\varphi", rates.angular_acceleration)])
        .with([("k", linkage.ratio()), ("l", ground), ("R", crank), ("r", position.pin_distance), (r"\varphi", lever)])
        .with([(r"\theta", position.crank.radians() - PI), (r"\beta", position.angle_at_pin())])
        .with([("v_2", velocities.pin_velocity.norm())])
        .with([("v_4", velocities.slot_point_velocity.norm()), (r"v_\mathrm{rel}", velocities.sliding_velocity.norm())])
        .with([(r"a_2^\mathrm{n}", motion.pin_normal.norm()), (r"a_4^\mathrm{n}", terms.follower_normal.norm())])
        .with([(r"a_2^\mathrm{t}", motion.pin_tangential.norm()), (r"a_\mathrm{Cor}", terms.coriolis.norm())])
        .with([(r"a_\mathrm{rel}^\mathrm{t}", -along.dot(&terms.sliding_tangential))])
        .with([(r"a_4^\mathrm{t}", -across.dot(&terms.follower_tangential))])
        .with([(r"t_\mathrm{slow}", strokes.slow / speed), (r"t_\mathrm{fast}", strokes.fast / speed)])
        .with([(r"\varphi_\mathrm{max}", limit)])
        .with([(r"\vec{v}_2", velocities.pin_velocity), (r"\vec{v}_4", velocities.slot_point_velocity)])
        .with([(r"\vec{v}_\mathrm{rel}", velocities.sliding_velocity), (r"\vec{a}_2^\mathrm{n}", motion.pin_normal)])
        .with([(r"\vec{a}_2^\mathrm{t}", motion.pin_tangential), (r"\vec{a}_4^\mathrm{n}", terms.follower_normal)])
        .with([(r"\vec{a}_4^\mathrm{t}", terms.follower_tangential), (r"\vec{a}_\mathrm{Cor}", terms.coriolis)])
        .with([(r"\vec{a}_\mathrm{rel}^\mathrm{n}", terms.sliding_normal)])
        .with([(r"\vec{a}_\mathrm{rel}^\mathrm{t}", terms.sliding_tangential)])
        .with([(r"\vec{r}", velocities.position), (r"\vec{a}_2", motion.pin_normal + motion.pin_tangential)])
        .with([(r"\vec{a}_4", terms.follower_normal + terms.follower_tangential)])
        // As seen by one who moves along and does not turn.
        .with([(r"\vec{a}_{2/4}", terms.sliding_tangential + terms.coriolis)])
        .with([
            (r"\gamma_2", PI - position.crank.radians()),
            (r"a_\mathrm{rel}^\mathrm{n}", terms.sliding_normal.norm()),
        ])
        .with([(r"\vec{\omega}_4", Value::turning(turning))])
}

/// When to look at a wheel.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum When {
    /// Within the advance, the driver at constant speed.
    Steady,
    /// Within the advance, the driver speeding up or slowing down.
    Unsteady,
    /// At the peaks of acceleration and deceleration, the driver at constant speed.
    AtPeak,
}

/// A wheel of many numbers of stations, or of one.
pub(super) fn wheel(number: usize, stations: Option<u32>, when: When) -> Moment {
    let wheel = Wheel::new(stations.unwrap_or(3 + number as u32 % 16)).expect("a wheel");
    let half = wheel.engagement_half_angle();
    let angle = match when {
        When::AtPeak if number.is_multiple_of(2) => wheel.acceleration_peak().angle,
        When::AtPeak => -wheel.acceleration_peak().angle,
        When::Steady | When::Unsteady => half * between(number, 0, -0.98, 0.98),
    };
    let angular_acceleration = if when == When::Unsteady { between(number, 3, -4.0, 4.0) } else { 0.0 };
    let (radius, speed) = (between(number, 1, 0.5, 2.0), between(number, 2, 0.5, 3.0));
    let (ratio, crank) = (wheel.centre_distance_ratio(), Turn::from_radians(angle));
    let pin = pin_slot::pin_from_pivot(&ratio, &crank) * radius;
    let entry = acceleration_ratio(&ratio, &Turn::from_radians(-half)) * speed * speed;
    let cycle = 2.0 * PI / speed;
    Moment::default()
        .with([("N", f64::from(wheel.stations())), (r"\alpha", wheel.half_pitch_angle()), ("k", ratio)])
        .with([("R", radius), ("l", ratio * radius), ("r", pin.norm()), (r"\gamma", gamma(&wheel))])
        .with([(r"\theta", angle), (r"\dot\theta", speed), (r"\ddot\theta", angular_acceleration)])
        .with([(r"\varphi", libm::atan2(pin.y, pin.x))])
        .with([(r"\dot\varphi", pin_slot::velocity_ratio(&ratio, &crank) * speed)])
        .with([(r"\ddot\varphi", unsteady_acceleration(&ratio, &crank, &speed, &angular_acceleration))])
        .changing(By::Time, [("varphi''", jerk_ratio(&ratio, &crank) * speed * speed * speed)])
        .with([(r"\text{wheel radius}", wheel.wheel_radius_ratio() * radius)])
        .with([(r"\text{pin travel}", wheel.slot_length_ratio() * radius)])
        .with([
            (r"\text{moving time}", wheel.indexing_time(speed).expect("a speed")),
            (r"\text{dwell time}", wheel.dwell_time(speed).expect("a speed")),
        ])
        .with([(r"\theta_{\text{exit}}", half), (r"\theta_{\text{entry}}", -half)])
        .with([
            (r"\lambda", wheel.dwell_fraction()),
            (r"\tau", wheel.dwell_time(speed).expect("a speed")),
            ("T", cycle),
        ])
        .with([(r"\text{arcs}", wheel.locking_centres_ratio() * radius)])
        .with([(r"\dot\varphi_{\max}", wheel.peaks(speed).expect("a speed").0)])
        .with_instant("entry", [(r"\ddot\varphi", entry), (r"\dot\theta", speed)])
}

/// A wheel with what it carries, its pin on the wall of its slot, and the blow with which that comes in.
pub(super) fn making(number: usize) -> Moment {
    // Before the line of centres, where the pin drives the wheel.
    let wheel = Wheel::with_pins(3 + number as u32 % 16, 1 + number as u32 % 2).expect("a wheel");
    let radius = between(number, 1, 20.0, 60.0);
    let sizes = Sizes::new(wheel, Scale::CrankRadius(radius), &Choices::default()).expect("fits");
    let half = wheel.engagement_half_angle();
    let (crank, speed) = (half * between(number, 0, -0.98, -0.02), between(number, 2, 0.5, 3.0));
    let (inertia, friction) = (between(number, 3, 0.1, 2.0), between(number, 4, 0.1, 2.0));
    let loads = WheelLoads::new(&wheel, inertia, friction, speed).expect("loads");
    let load = loads.load(crank).expect("in the slot");
    let motion = wheel.engaged(crank).expect("in the slot");
    let arm = wheel.pin_in_slot(crank).expect("in the slot").radius * radius;
    let force = load.pin_moment / radius;
    let (pin, wall) = (MATERIALS[number % 5], MATERIALS[(number / 5) % 5]);
    let thickness = between(number, 5, 3.0, 20.0);
    let contact = LineContact::new(sizes.pin_radius(), thickness, &pin, &wall).expect("a contact");
    let entry = sizes.entry(0.0).expect("meets the slot");
    let ratio = wheel.dwell_time(speed).expect("a speed") / wheel.indexing_time(speed).expect("a speed");
    Moment::default()
        .with([("N", f64::from(wheel.stations())), ("m", f64::from(wheel.pins())), ("q", ratio)])
        .with([("T", load.wheel_torque), ("J", inertia), ("M", friction), ("F", force), ("r", arm)])
        .with([(r"\text{crank torque}", load.crank_torque), (r"\dot\theta", speed)])
        .with([(r"\dot\varphi", motion.velocity * speed), (r"\ddot\varphi", motion.acceleration * speed * speed)])
        .with([("E", contact_modulus(&pin, &wall)), (r"\rho", sizes.pin_radius()), ("w", thickness)])
        .with([("E_1", pin.modulus), (r"\nu_1", pin.poisson), ("E_2", wall.modulus), (r"\nu_2", wall.poisson)])
        .with([(r"p_{\max}", contact.pressure(force).expect("presses"))])
        .with([(r"\tau", entry.crank_angle + half), ("g", sizes.slot_gap()), ("R", radius)])
}

/// One step of the integration, its four slopes as the program asks for them.
pub(super) fn step(number: usize) -> Moment {
    let slope: fn(f64, f64) -> f64 = |x, y| libm::sin(2.0 * x) + x * y - y * y / 3.0;
    let [x, y, h] = [between(number, 0, -1.0, 1.0), between(number, 1, -1.0, 1.0), between(number, 2, 0.1, 0.5)];
    let mut slopes = vec![slope(x, y)];
    let rate = |x: f64, y: &Vector1<f64>| {
        slopes.push(slope(x, y.x));
        Ok::<_, Infallible>(Vector1::new(slope(x, y.x)))
    };
    let Ok(next) = runge_kutta_step(rate, x, x + h, &Vector1::new(y), &Vector1::new(slope(x, y)));
    Moment::default().sloping(slope).with([("x_n", x), ("y_n", y), ("h", h), ("y_{n+1}", next.x)]).with([
        ("f_1", slopes[0]),
        ("f_2", slopes[1]),
        ("f_3", slopes[2]),
        ("f_4", slopes[3]),
    ])
}
