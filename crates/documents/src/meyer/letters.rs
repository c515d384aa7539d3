//! What the letters of chapter I and its appendices stand for, as exact expressions: the printed characters are proven
//! from these.
//!
//! Half powers and bars go through: the base 1 + a² − 2a cos θ is R², so its half powers are powers of a variable R, and
//! cos θ is (1 + a² − R²)/2a; what stands between bars is taken with either sign. A letter that is a slip for another is
//! any other number.
//!
//! **By another way than the instants.** The [`instants`](super::instants) have the pin by coordinates and the torques
//! from Newton's laws for the two members, in numbers. Here the follower turns by the pose of the formula crate, which
//! is proven from the pin's place there ([`PoseOfThePin`](geneva_dynamics::energy::PoseOfThePin)); the torques follow
//! from the kinetic energy and what sliding takes, and the rates are derivatives by power series. The factors A to E are
//! those that the crate solves the equation with: their displays are proven to be its formulas.

use super::reading::{By, Exact, Moment, decide};
use super::*;
use crate::triangle::Triangle;
use geneva_dynamics::energy::kinetic_energy;
use geneva_dynamics::{Coefficients, Pose, Sign};
use geneva_evidence::Vocabulary;
use geneva_kinematics::{Expression, Jet, angular_velocity, pin_slot};
use std::array::from_fn;

/// The triangle of the two axes and the pin.
pub(super) const TRIANGLE: Vocabulary = Vocabulary::new(triangle, Evidence::VECTORS, instants::moments);
/// The triangle as it moves, for the rates of the follower.
pub(super) const RATES: Vocabulary = Vocabulary::new(moving_triangle, Evidence::VECTORS, instants::moments);

/// The moving mechanism: chapter I from the kinetic energy to Eq. (1-19).
///
/// Variables: R, a, sin θ, θ', θ'', I_D, I_f, μ, r, δθ; θ grows. That sine and cosine are of one angle is nowhere needed.
pub(super) fn mechanism(bars: i64) -> Moment<Expression> {
    let [distance, a, sine, speed, acceleration, driver, follower, friction, radius, turn] =
        from_fn(Expression::variable);
    let square = distance * distance;
    let cosine = (1 + a * a - square) / (2 * a);
    let pose = Pose::from_square(&square, &(a * cosine - 1), &(a * sine));
    let turning = pose.moving_by(&Jet::<_, 2>::variable(Expression::ZERO));
    let ratio = turning.velocity_ratio();
    let speeds = Jet::<_, 2>::from_coefficients([speed, acceleration]);
    // Derivatives of one kinetic energy: by time, by θ, by θ', and that by time.
    let inertias = driver / follower;
    // The pose grows with θ: by time, its rate is θ' times as much.
    let in_time = Jet::from_coefficients([ratio.value(), ratio.rate() * speed]);
    let energy = kinetic_energy(&in_time, &speeds, &Jet::constant(inertias));
    let by_angle = kinetic_energy(&ratio, &Jet::constant(speed), &Jet::constant(inertias)).rate();
    let momentum = kinetic_energy(
        &Jet::<_, 2>::constant(in_time),
        &Jet::variable(speeds),
        &Jet::constant(Jet::constant(inertias)),
    )
    .rate();
    let follower_acceleration = (in_time * speeds).rate();
    // Virtual work of the inertias; the growth of the energy per radian; what friction takes by μ N over R dR/dθ = (R²)'/2.
    let force = driver * acceleration + follower * follower_acceleration * ratio.value();
    let growth = follower * energy.rate() / speed;
    let sliding = turning.radius_squared.rate() / 2;
    let rubbing = -bars * follower * friction * follower_acceleration * sliding / square;
    let torque = force - rubbing;
    let factors = Coefficients::from_pose(&pose, &inertias, &friction, &(torque / follower));
    let momentum_letters = ["dT/dtheta'", "dT/dq'_k"];
    let letters = [
        ("a", a),
        ("r", radius),
        ("R", radius * distance),
        ("theta'", speed),
        ("theta''", acceleration),
        ("phi'", in_time.value() * speed),
        ("phi''", follower_acceleration),
        ("I_D", driver),
        ("I_f", follower),
        ("I_P", follower + 1),
        ("I_b", driver + 1),
        ("mu", friction),
        ("N", follower * follower_acceleration / (radius * distance)),
        ("K", torque),
        // K by virtual work, the torque of the spring by energy.
        ("tau_1", growth - rubbing),
        ("tau_2", rubbing),
        ("tau", growth),
        ("Q_theta", force),
        // The work in a small turn, by Lagrange.
        ("delta theta", turn),
        ("delta W", follower * (momentum.rate() - by_angle) * turn),
        ("h", radius * sliding / distance),
        ("Q_k", force),
        ("T", follower * energy.value()),
        ("dT/dtheta", follower * by_angle),
        ("dT/dq_k", follower * by_angle),
        ("A", factors.a),
        ("B", factors.b),
        ("C", factors.c),
        ("D", factors.d),
        ("E", factors.e),
    ];
    let momenta = momentum_letters.map(|name| (name, follower * momentum.value()));
    let growing = momentum_letters.map(|name| (name, follower * momentum.rate()));
    of(letters.into_iter().chain(momenta))
        .changing(By::Time, [("theta", speed), ("theta'", acceleration)].into_iter().chain(growing))
        .changing(By::Angle, [("theta", Expression::ONE)])
        .giving(r"\cos\theta", cosine)
        .giving(r"\sin\theta", sine)
        // The letters of a and cos run together: another function, and so any number.
        .giving(r"\text{acos}\theta", cosine + 1)
        .giving(r"1 + a^2 - 2a\cos\theta", square)
        .giving(r"(1 + a^2 - 2a\cos\theta)^{1/2}", distance)
        .opening_bars(bars * Expression::ONE)
}

/// The moving mechanism where the bars belong to |τ_2|, because the torque of friction is never positive.
pub(super) fn opposed(bars: i64) -> Moment<Expression> {
    mechanism(bars).opening_bars(-Expression::ONE)
}

/// The triangle of the two axes and the pin, with N sin φ of this sign: the torque of friction up to Eq. (1-12).
pub(super) fn triangle(bars: i64) -> Moment<Expression> {
    triangle_with(bars, -bars)
}

/// The triangle for displays of the torque's size, where N sin φ is positive.
pub(super) fn size(_: i64) -> Moment<Expression> {
    triangle_with(1, 1)
}

/// The triangle by the crossing of its lines. How far the pin slides per radian comes from its place.
///
/// Variables: tangents of θ/2 and φ/2, N, μ, r.
fn triangle_with(bars: i64, sense: i64) -> Moment<Expression> {
    let [half_theta, half_phi, normal, friction, radius] = from_fn(Expression::variable);
    let (Triangle { theta, phi, .. }, [ratio, distance]) = crossing([half_theta, half_phi]);
    let place = pin_slot::pin_path(&ratio, &theta.moving::<2>(Expression::ONE));
    let sliding = radius * (place.x * place.x + place.y * place.y).rate() / (2 * distance);
    let letters = [
        ("a", ratio),
        ("r", radius),
        ("c", ratio * radius),
        ("R", radius * distance),
        ("N", normal),
        ("mu", friction),
        ("h", sliding),
        ("tau_2", sense * friction * normal * sliding),
    ];
    of(letters)
        .giving(r"\sin\theta", theta.sin)
        .giving(r"\cos\theta", theta.cos)
        .giving(r"\sin\phi", phi.sin)
        .giving(r"\cos\phi", phi.cos)
        .giving(r"\tan\phi", phi.sin / phi.cos)
        .giving(r"(1 + a^2 - 2a\cos\theta)^{1/2}", distance)
        .opening_bars(bars * Expression::ONE)
}

/// The triangle with its centre distance and the pin's distance from the follower's axis in crank radii.
fn crossing(halves: [Expression; 2]) -> (Triangle, [Expression; 2]) {
    let triangle = Triangle::by_halves(Expression::ONE, halves);
    let lengths = [Expression::ONE, triangle.slot_radius].map(|length| length / triangle.crank_radius);
    (triangle, lengths)
}

/// The triangle as it moves: the follower's angular velocity is what the pin's velocity has across the slot, over the pin's
/// distance. Variables: tangents of θ/2 and φ/2, θ', θ''.
fn moving_triangle(_: i64) -> Moment<Expression> {
    let [half_theta, half_phi, speed, acceleration] = from_fn(Expression::variable);
    let (Triangle { theta, phi, .. }, [ratio, distance]) = crossing([half_theta, half_phi]);
    let place = pin_slot::pin_path(&ratio, &theta.speeding_up(speed, acceleration));
    let follower = angular_velocity(&place).expect("the pin is off the follower's axis");
    of([
        ("a", ratio),
        ("theta'", speed),
        ("theta''", acceleration),
        ("phi'", follower.value()),
        ("phi''", follower.rate()),
    ])
    .changing(By::Time, [("theta", speed), ("phi", follower.value())])
    .giving(r"\sin\theta", theta.sin)
    .giving(r"\cos\theta", theta.cos)
    .giving(r"\tan\phi", phi.sin / phi.cos)
    .giving(r"\sec\phi", 1 / phi.cos)
    .giving(r"1 + a^2 - 2a\cos\theta", distance * distance)
}

/// Eq. (1-19) by its letters, with S for the sign of the expression between the bars, as the crate has the equation.
///
/// Variables: A + S D, B, C, D, θ', θ'', and a θ that is a slip for θ'.
pub(super) fn factors(bars: i64) -> Moment<Expression> {
    let [slope, b, c, d, speed, acceleration, angle] = from_fn(Expression::variable);
    let (a, e) = (slope - bars * d, driven([slope, b, c, d], [speed, acceleration], bars));
    let between = c * speed * speed + d * acceleration;
    let letters = [("A", a), ("B", b), ("C", c), ("D", d), ("E", e), ("F", between)];
    let motion = [("S", bars * Expression::ONE), ("theta", angle), ("theta'", speed), ("theta''", acceleration)];
    of(letters.into_iter().chain(motion)).giving("A + SD", slope).opening_bars(bars * Expression::ONE)
}

/// The start, for an acceleration that is positive: Appendix D. R and V are A and D there.
///
/// Variables: A + S D, B, C, D, θ'', and a θ' that is not zero, for the term that a slip makes of it.
pub(super) fn start(bars: i64) -> Moment<Expression> {
    let [slope, b, c, d, acceleration, speed] = from_fn(Expression::variable);
    let (a, e) = (slope - bars * d, driven([slope, b, c, d], [Expression::ZERO, acceleration], bars));
    let letters = [("A", a), ("R", a), ("D", d), ("V", d), ("E", e)];
    let motion = [("theta'", speed), ("theta''", acceleration), ("theta''_0", acceleration)];
    of(letters.into_iter().chain(motion)).opening_bars(bars * Expression::ONE)
}

/// The start in the program's letters, whose V is the size of D.
pub(super) fn start_of_program(bars: i64) -> Moment<Expression> {
    let start = start(bars);
    let size = bars * start.letters()["D"];
    let letters = start.letters().iter().map(|(name, value)| (name.as_str(), *value));
    of(letters.chain([("V", size), ("2DX", start.letters()["theta''"])]))
}

/// E by Eq. (1-19) as the crate has it, from A + S D and the other factors, for this speed and acceleration.
fn driven([slope, b, c, d]: [Expression; 4], [speed, acceleration]: [Expression; 2], bars: i64) -> Expression {
    let sign = if bars > 0 { Sign::Plus } else { Sign::Minus };
    let undriven = Coefficients { a: slope - bars * d, b, c, d, e: Expression::ZERO };
    undriven.residual(&speed, &acceleration, sign)
}

/// The vibration of Appendix B's example. Variables: m, c, k, x, x'.
pub(super) fn vibration(_: i64) -> Moment<Expression> {
    let [mass, damping, stiffness, place, speed] = from_fn(Expression::variable);
    let acceleration = -(damping * speed + stiffness * place) / mass;
    of([("m", mass), ("c", damping), ("k", stiffness), ("x", place), ("x'", speed), ("x''", acceleration)])
}

/// The vibration in the program's letters. Variables as in [`vibration`], then those at the start, and LDX, which is a slip for
/// 1DX, with its rate.
pub(super) fn vibration_of_program(bars: i64) -> Moment<Expression> {
    let vibration = vibration(bars);
    let letter = |name: &str| vibration.letters()[name];
    let [start_speed, start_place, odd, odd_rate] = from_fn(|index| Expression::variable(5 + index));
    let names = [("M", "m"), ("C", "c"), ("K", "k"), ("X", "x"), ("1DX", "x'"), ("2DX", "x''")];
    of(names.map(|(name, ours)| (name, letter(ours))))
        .with([("A", start_speed), ("B", start_place), (r"\text{LDX}", odd)])
        .changing(By::Time, [("X", letter("x'")), ("1DX", letter("x''")), ("LDX", odd_rate)])
}

/// The vibration at its start, where A and B are its speed and its place. Variables as in [`vibration_of_program`].
pub(super) fn vibration_at_start(bars: i64) -> Moment<Expression> {
    let moment = vibration_of_program(bars);
    let [speed, place] = ["1DX", "X"].map(|name| moment.letters()[name]);
    moment.with([("A", speed), ("B", place)])
}

fn of<'a>(letters: impl IntoIterator<Item = (&'a str, Expression)>) -> Moment<Expression> {
    Moment::of(reading::by_name(letters))
}

/// Whether an equation is proven, and the expression after the last of these operators is this one.
pub(super) fn proven_of(tex: &str, operator: &str, this: &str, letters: Exact) -> Finding {
    let whole = decide(tex, letters);
    match tex.rsplit_once(operator) {
        Some((_, of)) if whole.holds => decide(&format!("{this} = {of}"), letters),
        _ => whole,
    }
}
