//! What the letters of the problem stand for: exactly, from the lines of crank and lever and power series of the pin's place;
//! and by numbers, from the pin's place by dual numbers.

use super::moving_frame::{Moving, moving};
use super::*;
use crate::triangle::{Triangle, angle};
use geneva_evidence::Vocabulary;
use geneva_evidence::tex::{Moment, Value};
use geneva_kinematics::pin_vectors::path as pin_path;
use geneva_kinematics::quick_return::series::polar_rates;
use geneva_kinematics::{Expression, Jet};
use std::array::from_fn;
use std::sync::OnceLock;

/// Lengths, angles, and the sizes of velocities and accelerations, with a crank at constant speed.
pub(super) const SIZES: Vocabulary = Vocabulary::new(sizes, Evidence::AUTOMATIC_DERIVATIVE, sizes_in_numbers);
/// The vectors of a pin in a straight slot, with a crank that speeds up.
pub(super) const VECTORS: Vocabulary = Vocabulary::new(vectors, Evidence::AUTOMATIC_DERIVATIVE, vectors_in_numbers);
/// All components of the acceleration, with a lever that turns at will: the slot is then curved.
pub(super) const COMPONENTS: Vocabulary =
    Vocabulary::new(components, Evidence::AUTOMATIC_DERIVATIVE, components_in_numbers);
/// A point that moves at will in a frame that moves at will.
pub(super) const FRAME: Vocabulary = Vocabulary::new(frame, Evidence::AUTOMATIC_DERIVATIVE, frame_in_numbers);
/// The point at the frame's origin, through which it moves.
pub(super) const AT_THE_ORIGIN: Vocabulary =
    Vocabulary::new(at_the_origin, Evidence::AUTOMATIC_DERIVATIVE, origin_in_numbers);
/// Units of rotation and of time. Each may have any size, so what a conversion leaves of them is what its characters leave.
pub(super) const UNITS: Vocabulary = Vocabulary::new(units, Evidence::VECTORS, units_in_numbers);

/// Sizes are the parts of vectors in the directions of the source, and nothing is left across these. Towards the pivot the
/// sliding is positive, across the lever what is in the sense of the pin's acceleration.
///
/// The motion is that of axes one apart and of a crank that turns at one, in units of l and ω. Variables: tangent of half the
/// lever's angle, by how much that of the crank's is larger, l, ω.
fn sizes(_: i64) -> Moment<Expression> {
    let [half_lever, gap, ground, speed] = from_fn(Expression::variable);
    let [crank, lever] = [half_lever + gap, half_lever].map(|half| Turn::from_half_tangent(&half));
    let one = Expression::ONE;
    let Triangle { crank_radius, slot_radius, .. } = Triangle::new(one, crank.supplement(), lever);
    let place = pin_path(&crank_radius, &one, &crank.moving::<3>(one));
    let rates = polar_rates(&one, &crank_radius, &crank, &Drive::steady(one)).expect("the pin is off the pivot");
    // The pin as seen from the lever, and the lever's point under the pin.
    let turned = lever.speeding_up(rates.angular_velocity, rates.angular_acceleration);
    let outwards = turned.cos * place.x + turned.sin * place.y;
    let point = turned.direction() * Jet::constant(slot_radius);
    let [[pin_velocity, pin_acceleration], [velocity, acceleration]] = [&place, &point].map(rates_of);
    let (along, across) = (lever.direction(), quarter_turn(&lever.direction()));
    let (arm, tangent) = (crank.direction(), quarter_turn(&crank.direction()));
    let seen = outwards.coefficient(2) * 2;
    let coriolis = pin_acceleration - acceleration - along * seen;
    let beta = Turn { cos: arm.dot(&along), sin: along.perp(&arm) };
    let [velocities, accelerations] = [ground * speed, ground * speed * speed];
    Moment::default()
        .with([("l", ground), ("l_2", crank_radius * ground), ("r", slot_radius * ground)])
        .with([("l_4", slot_radius * ground)])
        .with_angles([(r"\varphi", angle(&lever)), (r"\psi", angle(&crank)), (r"\beta", angle(&beta))])
        // At the crank's axis, from the pin to the pivot.
        .with_angles([(r"\gamma", [-arm.x, arm.y])])
        .with([(r"\omega_2", speed), (r"\omega_4", rates.angular_velocity * speed)])
        .with([(r"\alpha_4", -rates.angular_acceleration * speed * speed), (r"\text{constant}", speed)])
        .with([
            ("v_{P2}", pin_velocity.dot(&tangent) * velocities),
            ("v_{P4}", velocity.dot(&across) * velocities),
            ("v_{P2/P4}", -outwards.rate() * velocities),
        ])
        .with([
            ("A_{P2}^n", -pin_acceleration.dot(&arm) * accelerations),
            ("A_{P2}^t", pin_acceleration.dot(&tangent) * accelerations),
            ("A_{P4}^n", -acceleration.dot(&along) * accelerations),
            ("A_{P4}^t", -acceleration.dot(&across) * accelerations),
            ("A_{P2/P4}^t", -seen * accelerations),
            (r"a_\mathrm{Cor}", -coriolis.dot(&across) * accelerations),
        ])
        .requiring([pin_velocity.dot(&arm), velocity.dot(&along), coriolis.dot(&along)])
}

/// Velocity and acceleration of a point whose place is a power series.
fn rates_of(place: &Vector2<Jet<Expression, 3>>) -> [Vector2<Expression>; 2] {
    [place.map(|series| series.rate()), place.map(|series| series.coefficient(2) * 2)]
}

/// The lever's part follows from the polar coordinates of the pin.
///
/// The unit of length is the pin's height over the line of centres. Variables: the crank's and the pin's other coordinate, ω
/// and its rate.
fn vectors(_: i64) -> Moment<Expression> {
    let [arm, place, speed, acceleration] = from_fn(Expression::variable);
    let (ground, crank) = (place - arm, Turn { cos: arm, sin: Expression::ONE });
    let [pin_velocity, pin_acceleration] =
        rates_of(&pin_path(&Expression::ONE, &ground, &crank.speeding_up(speed, acceleration)));
    let drive = Drive { speed, acceleration };
    let rates = polar_rates(&ground, &Expression::ONE, &crank, &drive).expect("the pin is off the pivot");
    let (along, across) = (rates.position, quarter_turn(&rates.position));
    let point = across * rates.angular_acceleration - along * (rates.angular_velocity * rates.angular_velocity);
    let relative = along * rates.sliding_rate + across * (2 * rates.angular_velocity * rates.sliding);
    let named = |pin, lever, between| {
        Moment::default().with([
            (pin, pin_velocity),
            (lever, across * rates.angular_velocity),
            (between, along * rates.sliding),
        ])
    };
    named("v_{P_2}", "v_{P_4}", "v_{P_2P_4}")
        .with([("a_{P_2}", pin_acceleration), ("a_{P_4}", point), ("a_{P_2P_4}", relative)])
        .with([("a_{P2}", pin_acceleration), ("a_{P4}", point), ("a_{P2/P4}", relative)])
}

/// What is seen from the lever is the power series of the pin's place, turned back.
///
/// Variables: the crank's and the pin's coordinate along the line of centres, the rate of ω, the lever's Ω and its rate. The
/// crank turns at the angular velocity one, which only sets the unit of time.
fn components(_: i64) -> Moment<Expression> {
    let [arm, place, acceleration, turning, growth] = from_fn(Expression::variable);
    let (ground, crank) = (place - arm, Turn { cos: arm, sin: Expression::ONE });
    let path = pin_path(&Expression::ONE, &ground, &crank.speeding_up(Expression::ONE, acceleration));
    let back = Turn { cos: Expression::ONE, sin: Expression::ZERO }.speeding_up(-turning, -growth);
    let seen = Vector2::new(back.cos * path.x - back.sin * path.y, back.sin * path.x + back.cos * path.y);
    let ([_, acceleration], [relative, seen]) = (rates_of(&path), rates_of(&seen));
    let (arm, place) = (crank.direction(), path.map(|series| series.value()));
    // Along the crank and across it, and along what is seen of the velocity and across it.
    let parted = |of: Vector2<Expression>, by: Vector2<Expression>| {
        let along = by * (of.dot(&by) / by.dot(&by));
        [along, of - along]
    };
    let ([normal, tangential], [along, across]) = (parted(acceleration, arm), parted(seen, relative));
    let lever = [-place * (turning * turning), quarter_turn(&place) * growth];
    named_components([[normal, tangential], lever, [across, along]], relative, Value::turning(turning))
}

/// Normal and tangential part of the pin, the lever's point and between them, the relative velocity and Ω, in the letters of
/// the problem and of the solution.
fn named_components<N: geneva_evidence::tex::Number>(
    [pin, lever, between]: [[Vector2<N>; 2]; 3],
    relative: Vector2<N>,
    turning: Value<N>,
) -> Moment<N> {
    let named = |moment: Moment<N>, [two, four, both]: [&str; 3]| {
        [(two, &pin), (four, &lever), (both, &between)].into_iter().fold(
            moment,
            |moment, (index, [normal, tangential])| {
                let names = ["n", "t"].map(|way| format!("a_{{{index}}}^{way}"));
                moment.with([(names[0].as_str(), normal.clone()), (names[1].as_str(), tangential.clone())])
            },
        )
    };
    named(named(Moment::default(), ["P_2", "P_4", "P_2P_4"]), ["P2", "P4", "P2/P4"])
        .with([("v_{P_2P_4}", relative.clone()), ("v_{P2/P4}", relative)])
        .with([(r"\omega_4", turning)])
}

/// The frame's axes are parallel to the fixed ones at the instant, which may be chosen at will.
///
/// Variables: ω and its rate, place, velocity and acceleration in the frame by their coordinates, and those of the origin.
fn frame(_: i64) -> Moment<Expression> {
    let [speed, growth, x, y, dx, dy, ddx, ddy, at_x, at_y, ..] = from_fn::<_, 14, _>(Expression::variable);
    let [.., rate_x, rate_y, acceleration_x, acceleration_y] = from_fn::<_, 14, _>(Expression::variable);
    in_a_frame(
        [speed, growth],
        [[x, dx, ddx], [y, dy, ddy]],
        [[at_x, rate_x, acceleration_x], [at_y, rate_y, acceleration_y]],
    )
}

fn in_a_frame(
    [speed, growth]: [Expression; 2],
    inside: [[Expression; 3]; 2],
    origin: [[Expression; 3]; 2],
) -> Moment<Expression> {
    let series = |[value, rate, second]: [Expression; 3]| Jet::<_, 3>::from_coefficients([value, rate, second / 2]);
    let turned = Turn { cos: Expression::ONE, sin: Expression::ZERO }.speeding_up(speed, growth);
    let ([x, y], [at_x, at_y]) = (inside.map(series), origin.map(series));
    let whole = Vector2::new(at_x + turned.cos * x - turned.sin * y, at_y + turned.sin * x + turned.cos * y);
    let order = |of: [[Expression; 3]; 2], order: usize| Vector2::new(of[0][order], of[1][order]);
    let [velocity, acceleration] = rates_of(&whole);
    named_frame(
        [whole.map(|series| series.value()), velocity, acceleration],
        [0, 1, 2].map(|at| order(origin, at)),
        [0, 1, 2].map(|at| order(inside, at)),
        [speed, growth],
    )
}

/// The letters of a frame: place, velocity and acceleration of the point, of the origin, and of the point in the frame.
fn named_frame<N: geneva_evidence::tex::Number>(
    whole: [Vector2<N>; 3],
    origin: [Vector2<N>; 3],
    inside: [Vector2<N>; 3],
    [speed, growth]: [N; 2],
) -> Moment<N> {
    let ([r, dr, ddr], [at, rate, acceleration], [p, dp, ddp]) = (whole, origin, inside);
    Moment::default()
        .with([("r_{P2}", r.clone()), ("r_{P4}", at.clone()), ("r_{P2/P4}", p.clone())])
        .with([("v_{P2}", dr.clone()), ("v_{P4}", rate.clone()), ("v_{P2/P4}", dp.clone())])
        .with([("r", r), (r"\dot{r}", dr), (r"\ddot{r}", ddr)])
        .with([("R", at), (r"\dot{R}", rate), (r"\ddot{R}", acceleration)])
        .with([("p", p), (r"\dot{p}", dp), (r"\ddot{p}", ddp)])
        .with([(r"\omega", Value::turning(speed)), (r"\dot{\omega}", Value::turning(growth))])
}

/// Variables as in [`frame`], without a place in it.
fn at_the_origin(_: i64) -> Moment<Expression> {
    let [speed, growth, dx, dy, ddx, ddy, at_x, at_y, rate_x, rate_y, acceleration_x, acceleration_y] =
        from_fn(Expression::variable);
    let zero = Expression::ZERO;
    in_a_frame(
        [speed, growth],
        [[zero, dx, ddx], [zero, dy, ddy]],
        [[at_x, rate_x, acceleration_x], [at_y, rate_y, acceleration_y]],
    )
}

/// The speed of one turn a minute, in radians and seconds.
pub(super) const TURN_A_MINUTE: &str = r"\text{turn a minute}";

/// A turn is two half turns, and a minute has sixty seconds. Variables: π, the radian, the second, the turn, the minute.
fn units(_: i64) -> Moment<Expression> {
    let [half_turn, radian, second, turn, minute] = from_fn(Expression::variable);
    Moment::default()
        .with([(r"\pi", half_turn), (r"\text{rad}", radian), (r"\text{s}", second)])
        .with([(r"\text{rev}", turn), (r"\text{min}", minute)])
        .with([(TURN_A_MINUTE, (half_turn + half_turn) * radian / (60 * second))])
}

/// Ground, crank over it, crank angle in degrees, angular velocity.
const STATES: [[f64; 4]; 4] =
    [[0.45, 0.44, 70.0, 5.2], [1.2, 0.6, 40.0, 0.7], [2.5, 0.35, 85.0, 1.6], [0.8, 0.75, 55.0, 2.4]];

fn cranks(acceleration: f64) -> impl Iterator<Item = Crank> {
    STATES.into_iter().map(move |[ground, ratio, degrees, speed]| Crank {
        ground,
        radius: ratio * ground,
        angle: degrees.to_radians(),
        speed,
        acceleration,
    })
}

/// Found once for each of the cranks.
fn kept(found: &'static OnceLock<Vec<Moment>>, acceleration: f64, of: fn(Crank) -> Moment) -> &'static [Moment] {
    found.get_or_init(|| cranks(acceleration).map(of).collect())
}

fn sizes_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    kept(&FOUND, 0.0, |crank| {
        let [[distance, sliding, outwards], [lever, turning, growth]] = crank.polar();
        let ([place, velocity, acceleration], [_, carried, point]) = (crank.pin_motion(), crank.point_motion());
        let arm = Turn::from_radians(crank.angle).direction();
        let (along, across) = (place.normalize(), quarter_turn(&place.normalize()));
        let rest = acceleration - point - frames::seen(&crank, Stated::right(""))[2];
        let beta = libm::atan2(place.perp(&arm), place.dot(&arm));
        Moment::default()
            .with([("l", crank.ground), ("l_2", crank.radius), ("r", distance), ("l_4", distance)])
            .with([(r"\varphi", lever), (r"\psi", crank.angle), (r"\beta", beta), (r"\gamma", PI - crank.angle)])
            .with([(r"\omega_2", crank.speed), (r"\omega_4", turning), (r"\alpha_4", -growth)])
            .with([("v_{P2}", velocity.norm()), ("v_{P4}", carried.norm()), ("v_{P2/P4}", -sliding)])
            .with([("A_{P2}^n", acceleration.norm()), ("A_{P2}^t", quarter_turn(&arm).dot(&acceleration))])
            .with([("A_{P4}^n", -along.dot(&point)), ("A_{P4}^t", -across.dot(&point)), ("A_{P2/P4}^t", -outwards)])
            .with([(r"a_\mathrm{Cor}", rest.norm()), (r"\text{constant}", crank.speed)])
    })
}

fn vectors_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    kept(&FOUND, 1.5, |crank| {
        let ([_, velocity, acceleration], [_, carried, point]) = (crank.pin_motion(), crank.point_motion());
        let [[_, sliding, outwards], [slot, turning, _]] = crank.polar();
        let along = Turn::from_radians(slot).direction();
        let relative = along * outwards + quarter_turn(&along) * (2.0 * sliding * turning);
        Moment::default()
            .with([("v_{P_2}", velocity), ("v_{P_4}", carried), ("v_{P_2P_4}", along * sliding)])
            .with([("a_{P_2}", acceleration), ("a_{P_4}", point), ("a_{P_2P_4}", relative)])
            .with([("a_{P2}", acceleration), ("a_{P4}", point), ("a_{P2/P4}", relative)])
    })
}

fn components_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    kept(&FOUND, 7.0, given::components_at_will)
}

/// The components of a lever at will, which has this angular velocity.
pub(super) fn with_parts(parts: [[Vector2<f64>; 2]; 3], relative: Vector2<f64>, turning: f64) -> Moment {
    named_components(parts, relative, Value::turning(turning))
}

fn frame_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<[Moment; 1]> = OnceLock::new();
    FOUND.get_or_init(|| [of_a_frame(moving(1.0))])
}

fn origin_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<[Moment; 1]> = OnceLock::new();
    FOUND.get_or_init(|| [of_a_frame(moving(0.0))])
}

fn of_a_frame(Moving { whole, origin, inside, speed, angular_acceleration }: Moving) -> Moment {
    named_frame(whole, origin, inside, [speed, angular_acceleration])
}

/// A turn is back where it began after four right angles. The sizes of the radian and the second are any.
fn units_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<[Moment; 1]> = OnceLock::new();
    FOUND.get_or_init(|| {
        let (radian, second) = (3.0, 5.0);
        [Moment::default().with([
            (r"\text{rev}", 7.0),
            (r"\text{rad}", radian),
            (r"\text{min}", 11.0),
            (r"\text{s}", second),
            (TURN_A_MINUTE, 4.0 * libm::atan2(1.0, 0.0) * radian / (60.0 * second)),
        ])]
    })
}
