//! What the letters of the handout stand for: exactly, from the pin's place as a power series, with r for the unit of length
//! where no length is printed; and by numbers, from the pin's place by dual numbers.

use super::*;
use crate::duals::{halved, ratio_with_standstill_at};
use crate::triangle::{Triangle, angle};
use geneva_evidence::Vocabulary;
use geneva_evidence::tex::{By, Moment};
use geneva_kinematics::Expression;
use geneva_kinematics::pin_slot::pin_path;
use geneva_kinematics::pin_vectors::quarter_turn;
use nalgebra::Vector2;
use std::array::from_fn;

/// The wheel of any number of stations, with a driver at constant speed.
pub(super) const ANY: Vocabulary = Vocabulary::new(any, Evidence::AUTOMATIC_DERIVATIVE, any_in_numbers);
/// The wheel of four stations, with a driver that speeds up.
pub(super) const FOUR: Vocabulary = Vocabulary::new(four, Evidence::AUTOMATIC_DERIVATIVE, four_in_numbers);
/// The wheel of four stations, with a driver at constant speed.
pub(super) const STEADY_FOUR: Vocabulary =
    Vocabulary::new(steady_four, Evidence::AUTOMATIC_DERIVATIVE, steady_four_in_numbers);
/// The loop through the axes and the pin, for four stations.
pub(super) const LOOP: Vocabulary = Vocabulary::new(closed_loop, Evidence::AUTOMATIC_DERIVATIVE, four_in_numbers);
/// The sizes of the wheel of any number of stations.
pub(super) const SIZES: Vocabulary = Vocabulary::new(sizes, Evidence::AUTOMATIC_DERIVATIVE, any_in_numbers);
/// The sizes of the wheel of four stations.
pub(super) const SIZES_OF_FOUR: Vocabulary =
    Vocabulary::new(sizes_of_four, Evidence::AUTOMATIC_DERIVATIVE, sizes_of_four_in_numbers);
/// Angles that are parts of a turn, and times that are parts of a cycle.
pub(super) const PARTS: Vocabulary = Vocabulary::new(parts, Evidence::LIMIT_CASE, parts_in_numbers);
/// The part of the dwell, with α in degrees.
pub(super) const PARTS_BY_DEGREES: Vocabulary =
    Vocabulary::new(parts_by_degrees, Evidence::LIMIT_CASE, degrees_in_numbers);
/// Angles of the driver as the pin enters and leaves.
pub(super) const ENTRY_AND_EXIT: Vocabulary = Vocabulary::new(entry_and_exit, Evidence::LIMIT_CASE, parts_in_numbers);
/// Where the acceleration is greatest in size, on both sides of the line of centres.
pub(super) const PEAK: Vocabulary = Vocabulary::new(peak, Evidence::AUTOMATIC_DERIVATIVE, peak_in_numbers);
/// Both roots of the condition for it.
pub(super) const ROOTS: Vocabulary = Vocabulary::new(peak, Evidence::AUTOMATIC_DERIVATIVE, roots_in_numbers);
/// Where the acceleration is greatest in size, for the sign of γ's root that belongs to an angle.
pub(super) const PEAK_ANGLE: Vocabulary = Vocabulary::new(peak_angle, Evidence::AUTOMATIC_DERIVATIVE, peak_in_numbers);
/// γ, from the derivative of the acceleration.
pub(super) const COEFFICIENT: Vocabulary =
    Vocabulary::new(coefficient, Evidence::AUTOMATIC_DERIVATIVE, peak_in_numbers);
/// The wheel of six stations at its fastest.
pub(super) const FASTEST: Vocabulary = Vocabulary::new(fastest, Evidence::AUTOMATIC_DERIVATIVE, fastest_in_numbers);

/// A wheel with its axes this many crank radii apart: its letters and the rate of its acceleration.
fn wheel(
    ratio: Expression,
    theta: &Turn<Expression>,
    [speed, acceleration]: [Expression; 2],
) -> (Moment<Expression>, Expression) {
    let advance = Jet::<_, 4>::from_coefficients([Expression::ZERO, speed, acceleration / 2, Expression::ZERO]);
    let path = pin_path(&ratio, &theta.moving_by(&advance));
    let velocity = angular_velocity(&path).expect("the pin is off the wheel's axis");
    let jerk = velocity.coefficient(2) * 2;
    let moment = Moment::default()
        .with([(r"\dot\theta", speed), (r"\ddot\theta", acceleration)])
        .with([(r"\dot\phi", velocity.value()), (r"\ddot\phi", velocity.rate())])
        .changing(By::Time, [("phi''", jerk)])
        .with_angles([(r"\theta", angle(theta))])
        .replacing(r"\tan\phi", path.y.value() / path.x.value());
    (moment, jerk)
}

/// The centre distance of the wheel whose slots are at ±α as the crank is at right angles to them, in crank radii: the
/// crank's and the slot's part of it.
fn distance_by_parts(alpha: &Turn<Expression>) -> Expression {
    let along = alpha.cos / alpha.sin;
    along * alpha.cos + alpha.sin
}

/// Variables: tangents of α/2 and θ/2, θ'.
fn any(_: i64) -> Moment<Expression> {
    moving().0
}

fn moving() -> (Moment<Expression>, Expression, Turn<Expression>, Turn<Expression>) {
    let [half_alpha, half_theta, speed] = from_fn(Expression::variable);
    let [alpha, theta] = [half_alpha, half_theta].map(|half| Turn::from_half_tangent(&half));
    let ratio = 1 / alpha.sin;
    let (moment, jerk) = wheel(ratio, &theta, [speed, Expression::ZERO]);
    let moment = moment.with_angles([(r"\alpha", angle(&alpha))]).requiring([ratio - distance_by_parts(&alpha)]);
    (moment, jerk, alpha, theta)
}

/// Variables: tangent of θ/2, θ', θ''.
fn four(_: i64) -> Moment<Expression> {
    let [half_theta, speed, acceleration] = from_fn(Expression::variable);
    of_four(half_theta, [speed, acceleration])
}

/// Variables: tangent of θ/2, θ'.
fn steady_four(_: i64) -> Moment<Expression> {
    let [half_theta, speed] = from_fn(Expression::variable);
    of_four(half_theta, [speed, Expression::ZERO])
}

fn of_four(half_theta: Expression, rates: [Expression; 2]) -> Moment<Expression> {
    let (moment, _) = wheel(Expression::root(), &Turn::from_half_tangent(&half_theta), rates);
    moment.giving(r"\sqrt{2}", Expression::root()).requiring([four_stations_apart()]).with_root_of(2)
}

/// What must be zero if the axes of the wheel of four stations are √2 crank radii apart.
fn four_stations_apart() -> Expression {
    let half = Expression::root() / 2;
    Expression::root() - distance_by_parts(&Turn { cos: half, sin: half })
}

/// The loop closes for every distance of the axes in the place of √2 r. Variables: tangents of θ/2 and φ/2, the distance.
fn closed_loop(_: i64) -> Moment<Expression> {
    let [half_theta, half_phi, distance] = from_fn(Expression::variable);
    let Triangle { crank_radius, slot_radius, theta, phi, .. } = Triangle::by_halves(distance, [half_theta, half_phi]);
    Moment::default()
        .with([("r", crank_radius), ("x", slot_radius)])
        .with_angles([(r"\theta", angle(&theta)), (r"\phi", angle(&phi))])
        .replacing(r"\sqrt{2}", distance / crank_radius)
}

/// Variables: tangent of α/2, r.
fn sizes(_: i64) -> Moment<Expression> {
    let [half, radius] = from_fn(Expression::variable);
    let alpha = Turn::from_half_tangent(&half);
    Moment::default()
        .with([("l", radius * distance_by_parts(&alpha)), ("r", radius)])
        .with_angles([(r"\alpha", angle(&alpha))])
}

/// Between two slots at ±45°, the arc is about the driver's axis. Variable: r.
fn sizes_of_four(_: i64) -> Moment<Expression> {
    let ([radius], half) = (from_fn(Expression::variable), Expression::root() / 2);
    let distance = radius * distance_by_parts(&Turn { cos: half, sin: half });
    // Where a circle of the crank's radius about a point of the line of centres goes through the mouth of a slot and
    // through the point of the pin's circle that is next to the wheel.
    let (mouth, nearest) = (Vector2::new(radius * half, radius * half), distance - radius);
    let centre = (mouth.dot(&mouth) - nearest * nearest) / (2 * (mouth.x - nearest));
    Moment::default()
        .with([("r", radius), ("l", distance), (r"\text{arcs}", centre)])
        .giving(r"\sqrt{2}", Expression::root())
        .with_root_of(2)
}

/// N pitches make a turn, and α is half of one. The driver turns by less than half a turn while a pin is in a slot: by 2α
/// less, as [`entry_and_exit`] proves. Variables: π, N, θ'.
fn parts(_: i64) -> Moment<Expression> {
    let [pi, stations, speed] = from_fn(Expression::variable);
    let turn = pi + pi;
    let alpha = turn / stations / 2;
    let dwell = turn - (pi - 2 * alpha);
    Moment::default().with([(r"\pi", pi), ("N", stations), (r"\alpha", alpha)]).with([
        (r"\lambda", dwell / turn),
        (r"\tau", dwell / speed),
        ("T", turn / speed),
    ])
}

fn parts_by_degrees(_: i64) -> Moment<Expression> {
    let moment = parts(1);
    let alpha = moment.letters()["alpha"] * 180 / moment.letters()["pi"];
    moment.with([(r"\alpha", alpha)])
}

/// The crank is at right angles to the slots, which are at ±α then. Variable: tangent of α/2.
fn entry_and_exit(_: i64) -> Moment<Expression> {
    let alpha = Turn::from_half_tangent(&Expression::variable(0));
    let crank = quarter_turn(&alpha.direction());
    // From the line of centres, which leads from the driver's axis to the wheel's.
    let exit = Turn { cos: -crank.x, sin: crank.y };
    Moment::default().with_angles([
        (r"\alpha", angle(&alpha)),
        (r"\theta_{\text{exit}}", angle(&exit)),
        (r"\theta_{\text{entry}}", angle(&exit.reversed())),
    ])
}

/// The condition for an extreme has the roots c and −2/c, if γ is 2/c − c; it is the condition by [`condition`]. The upper
/// sign is for the first, the lower for the second. Variable: c.
fn peak(sign: i64) -> Moment<Expression> {
    let cosine = Expression::variable(0);
    let gamma = 2 / cosine - cosine;
    let root = if sign > 0 { cosine } else { -2 / cosine };
    Moment::default()
        .with([(r"\gamma", gamma)])
        .replacing(r"\cos\theta", root)
        .giving(r"\sqrt{\gamma^2 + 8}", cosine + 2 / cosine)
        // It is a root.
        .requiring([root * root + gamma * root - 2])
}

fn peak_angle(_: i64) -> Moment<Expression> {
    peak(1)
}

/// The derivative of the acceleration, with what it is that many times as much as the difference of the sides of the printed
/// condition. Variables as in [`any`].
pub(super) fn condition() -> (Moment<Expression>, Expression, Expression) {
    let (moment, jerk, factor, _) = with_factor();
    (moment, factor, jerk)
}

/// The derivative of the acceleration, with what it is that many times as much as the difference of the sides of the printed
/// quadratic: 2 sin α times less than for the condition. Variables as in [`any`].
pub(super) fn quadratic() -> (Moment<Expression>, Expression, Expression) {
    let (moment, jerk, factor, [sine, _]) = with_factor();
    let gamma = (1 + sine * sine) / (2 * sine);
    (moment.with([(r"\gamma", gamma)]), factor * 2 * sine, jerk)
}

/// The derivative, what stands before its braces, sin α and cos θ.
fn with_factor() -> (Moment<Expression>, Expression, Expression, [Expression; 2]) {
    let (moment, jerk, alpha, theta) = moving();
    let speed = moment.letters()["theta'"];
    let square = 1 + alpha.sin * alpha.sin - 2 * alpha.sin * theta.cos;
    let factor = -(speed * speed * speed) * alpha.sin * alpha.cos * alpha.cos / (square * square * square);
    (moment, jerk, factor, [alpha.sin, theta.cos])
}

/// γ is what makes the derivative vanish with c² + γ c − 2: from where it is not zero, by what it is there. Variables as in
/// [`any`].
fn coefficient(_: i64) -> Moment<Expression> {
    let (moment, jerk, factor, [sine, cosine]) = with_factor();
    moment.with([(r"\gamma", (jerk / (factor * 2 * sine) - cosine * cosine + 2) / cosine)])
}

/// The pin is on the line of centres, and the axes are two crank radii apart, as one half is the sine of 30°. Variable: θ'.
fn fastest(_: i64) -> Moment<Expression> {
    let on_the_line = Turn { cos: Expression::ONE, sin: Expression::ZERO };
    let (moment, _) = wheel(2 * Expression::ONE, &on_the_line, [Expression::variable(0), Expression::ZERO]);
    let velocity = moment.letters()["phi'"];
    moment.with([(r"\dot{\phi}_{\rm max}", velocity)])
}

/// Numbers of stations.
const NUMBERS: [u32; 5] = [3, 4, 6, 9, 18];
/// Crank angle over that at entry, angular velocity and angular acceleration of the driver, crank radius.
const STATES: [[f64; 4]; 4] =
    [[-0.9, 0.8, 1.1, 1.3], [-0.35, 2.1, -0.7, 0.7], [0.2, 1.3, 2.3, 2.1], [0.7, 0.6, -1.9, 1.6]];

/// The wheel that stands still with its slots half a pitch from the line of centres: centre distance in crank radii, and
/// the angle of the crank then.
fn made(stations: u32) -> [f64; 2] {
    static FOUND: OnceLock<Vec<[f64; 2]>> = OnceLock::new();
    let found = FOUND.get_or_init(|| {
        let find = |stations: u32| {
            let ratio = ratio_with_standstill_at(PI / f64::from(stations));
            [ratio, halved([0.0, PI / 2.0], |t| rates(ratio, t, [1.0, 0.0])[1] > 0.0)[0]]
        };
        NUMBERS.map(find).into()
    });
    let at = NUMBERS.iter().position(|number| *number == stations);
    at.map_or([f64::NAN; 2], |at| found[at])
}

/// The letters of one state, of a driver that has the angular acceleration only if it is unsteady.
fn state(stations: u32, [part, speed, driver_acceleration, radius]: [f64; 4]) -> Moment {
    let [ratio, end] = made(stations);
    let crank = part * end;
    let [angle, velocity, acceleration, jerk] = rates(ratio, crank, [speed, driver_acceleration]);
    let (across, along) = (libm::sin(crank), ratio - libm::cos(crank));
    Moment::default()
        .with([(r"\alpha", PI / f64::from(stations)), (r"\theta", crank), (r"\phi", angle)])
        .with([
            (r"\dot\theta", speed),
            (r"\ddot\theta", driver_acceleration),
            (r"\dot\phi", velocity),
            (r"\ddot\phi", acceleration),
        ])
        .with([("r", radius), ("x", radius * libm::hypot(across, along)), ("l", ratio * radius)])
        .changing(By::Time, [("phi''", jerk)])
}

fn any_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let steady = |stations| move |[part, speed, _, radius]: [f64; 4]| state(stations, [part, speed, 0.0, radius]);
        NUMBERS.into_iter().flat_map(|stations| STATES.map(steady(stations))).collect()
    })
}

fn four_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<[Moment; 4]> = OnceLock::new();
    FOUND.get_or_init(|| STATES.map(|at| state(4, at)))
}

fn steady_four_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<[Moment; 4]> = OnceLock::new();
    FOUND.get_or_init(|| STATES.map(|[part, speed, _, radius]| state(4, [part, speed, 0.0, radius])))
}

fn sizes_of_four_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let sizes = |radius: f64| {
            // The centre of the arc is the driver's axis while the wheel is locked.
            let distance = radius * made(4)[0];
            Moment::default().with([("r", radius), ("l", distance), (r"\text{arcs}", distance)])
        };
        [0.75, 1.5].map(sizes).into()
    })
}

/// Where the wheel of these many stations begins and ceases to move.
fn parts_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let part = |stations: u32| {
            let ([_, end], speed) = (made(stations), 1.75);
            let (dwell, turn) = (2.0 * (PI - end), 2.0 * PI);
            Moment::default()
                .with([("N", f64::from(stations)), (r"\alpha", rates(made(stations)[0], end, [1.0, 0.0])[0])])
                .with([(r"\lambda", dwell / turn), (r"\tau", dwell / speed), ("T", turn / speed)])
                .with([(r"\theta_{\text{exit}}", end), (r"\theta_{\text{entry}}", -end)])
        };
        NUMBERS.map(part).into()
    })
}

fn degrees_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    let by_degrees = |moment: &Moment| {
        let alpha = moment.letters()["alpha"].to_degrees();
        moment.clone().with([(r"\alpha", alpha)])
    };
    FOUND.get_or_init(|| parts_in_numbers().iter().map(by_degrees).collect())
}

/// The peaks of the acceleration by dual numbers, of which γ is told by the angle.
fn peak_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let peaks = |stations: u32| {
            let [ratio, end] = made(stations);
            let peak = halved([0.0, end], |t| rates(ratio, t, [1.0, 0.0])[3] < 0.0)[0];
            let cosine = libm::cos(peak);
            [-1.0, 1.0].map(|side| {
                state(stations, [side * peak / end, 1.25, 0.0, 1.0])
                    .with([(r"\gamma", (2.0 - cosine * cosine) / cosine)])
            })
        };
        NUMBERS.into_iter().flat_map(peaks).collect()
    })
}

/// The peaks, and the other root of the condition: the two roots have the product −2, so no angle has the other one.
fn roots_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let other = |peak: &Moment| {
            let letters = peak.letters();
            Moment::default()
                .with([(r"\gamma", letters["gamma"])])
                .replacing(r"\cos\theta", -2.0 / libm::cos(letters["theta"]))
        };
        peak_in_numbers().iter().flat_map(|peak| [peak.clone(), other(peak)]).collect()
    })
}

/// The greatest velocity of all angles.
fn fastest_in_numbers() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let ([ratio, end], speed) = (made(6), 1.75);
        let velocity = |part: i32| rates(ratio, end * f64::from(part) / 20.0, [speed, 0.0])[1];
        let most = (-20..=20).map(velocity).fold(0.0, f64::max);
        vec![Moment::default().with([(r"\dot\theta", speed), (r"\dot{\phi}_{\rm max}", most)])]
    })
}
