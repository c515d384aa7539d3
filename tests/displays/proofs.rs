//! The printed characters of the equation of motion, proven or refuted without rounding.
//!
//! The identities of the formula crates stand for the same displays, typed by hand. Here nothing is typed but what the
//! letters are. Half powers and bars go through: the base 1 + a² − 2a cos θ is R², so its half powers are powers of a
//! variable R, and cos θ is (1 + a² − R²)/2a; what stands between bars is taken with either sign. Derivatives are taken
//! by the rules of calculus. The identities stay for all that: they tell one slip of a display from another.

use geneva_kinematics::{Expression, Jet, prove};
use geneva_ledger::tex::{By, Characters, Moment};
use geneva_ledger::{Claim, Verdict, claim};
use std::array::from_fn;

/// The letters of chapter I, with a given sign of what stands between bars.
///
/// Variables: R, a, sin θ, θ', θ'', I_D, I_f, μ, r. That sine and cosine are of one angle is nowhere needed.
fn mechanism(bars: i64) -> Moment<Expression> {
    let [distance, a, sine, speed, acceleration, driver, follower, friction, radius] = from_fn(Expression::variable);
    let square = distance * distance;
    let cosine = (1 + a * a - square) / (2 * a);
    // φ'/θ' = (a cos θ − 1)/R², Eq. (1-7), while θ grows: (cos θ)' = −sin θ and (R²)' = 2 a sin θ.
    let across = a * sine;
    let above = Jet::<Expression, 2>::from_coefficients([a * cosine - 1, -across]);
    let ratio = above / Jet::from_coefficients([square, 2 * across]);
    let (turning, change) = (ratio.value(), ratio.rate());
    let follower_acceleration = change * speed * speed + turning * acceleration;
    // Virtual work: the pin presses at the distance r R from the follower's axis and slides by r dR/dθ = r a sin θ/R.
    let lost = |follower_acceleration: Expression| friction * follower_acceleration * across / square;
    let moving = driver + follower * turning * turning;
    let by_angle = follower * turning * change * speed * speed;
    let growth = moving * acceleration + 2 * by_angle;
    let rubbing = -bars * follower * lost(follower_acceleration);
    let torque = growth - by_angle - rubbing;
    let letters = [
        ("a", a),
        ("r", radius),
        ("R", radius * distance),
        ("theta'", speed),
        ("theta''", acceleration),
        ("phi'", turning * speed),
        ("phi''", follower_acceleration),
        ("I_D", driver),
        ("I_f", follower),
        // Slips for I_f and I_D: any other numbers.
        ("I_P", follower + 1),
        ("I_b", driver + 1),
        ("mu", friction),
        ("N", follower * follower_acceleration / (radius * distance)),
        ("tau_2", rubbing),
        ("K", torque),
        ("T", moving * speed * speed / 2),
        ("dT/dtheta'", moving * speed),
        ("dT/dtheta", by_angle),
        // Eq. (1-19): what multiplies θ'' and θ'², outside the bars and between them.
        ("A", moving / follower),
        ("B", turning * change),
        ("C", lost(change)),
        ("D", lost(turning)),
        ("E", torque / follower),
    ];
    Moment::of(letters.map(|(name, value)| (name.to_owned(), value)).into())
        .changing(By::Time, [("theta", speed), ("theta'", acceleration), ("dT/dtheta'", growth)])
        .changing(By::Angle, [("theta", Expression::ONE)])
        .giving(r"\cos\theta", cosine)
        .giving(r"\sin\theta", sine)
        .giving(r"1 + a^2 - 2a\cos\theta", square)
        .giving(r"(1 + a^2 - 2a\cos\theta)^{1/2}", distance)
        .opening_bars(bars * Expression::ONE)
}

/// Eq. (1-19) by its letters, with S for the sign of what stands between the bars.
///
/// Variables: A + S D, B, C, D, θ', θ'', and a θ that is a slip for θ'.
fn factors(bars: i64) -> Moment<Expression> {
    let [slope, b, c, d, speed, acceleration, angle] = from_fn(Expression::variable);
    let between = c * speed * speed + d * acceleration;
    let a = slope - bars * d;
    let driven = a * acceleration + b * speed * speed + bars * between;
    let letters = [("A", a), ("B", b), ("C", c), ("D", d), ("E", driven), ("F", between)];
    let motion = [("S", bars * Expression::ONE), ("theta", angle), ("theta'", speed), ("theta''", acceleration)];
    Moment::of(letters.into_iter().chain(motion).map(|(name, value)| (name.to_owned(), value)).collect())
        .giving("A + SD", slope)
        .opening_bars(bars * Expression::ONE)
}

/// Whether characters are proven for both signs of what stands between bars, and how.
fn decide<const V: usize>(tex: &str, letters: fn(i64) -> Moment<Expression>) -> Result<String, String> {
    let decide = |sign: i64| {
        let characters = Characters::read(tex, &letters(sign)).map_err(|error| error.to_string())?;
        prove::<V>(&characters).map(|proof| proof.to_string()).map_err(|refutation| refutation.to_string())
    };
    decide(1).and(decide(-1))
}

/// The right characters of these displays are proven, and are not any more with one line as it is printed with a slip.
#[track_caller]
fn are_decided<const V: usize>(displays: &[&[&str]], letters: fn(i64) -> Moment<Expression>) {
    for lines in displays {
        let lines = lines.iter().map(|line| claim(&format!("meyer.{line}")).unwrap_or_else(|| panic!("no {line}")));
        let lines: Vec<&'static Claim> = lines.collect();
        let with_printed = |printed: &str| {
            let characters =
                lines.iter().map(|line| if line.id == printed { line.printed } else { line.right_characters() });
            decide::<V>(&characters.collect::<Vec<_>>().join(" "), letters)
        };
        let right = with_printed("");
        println!("{}: {right:?}", lines[0].id);
        assert!(right.is_ok(), "{}: {right:?}", lines[0].id);
        for line in lines.iter().filter(|line| line.expected == Verdict::Corrected) {
            assert!(with_printed(line.id).is_err(), "{} is proven as printed", line.id);
        }
    }
}

#[test]
fn the_characters_of_the_friction_are_proven_without_rounding() {
    let displays: [&[&str]; 7] = [
        &["moments"],
        &["normal-force"],
        &["normal-force.substituted"],
        &["eq-1-13"],
        &["eq-1-12"],
        &["friction-torque.substituted"],
        &["eq-1-14"],
    ];
    are_decided::<9>(&displays, mechanism);
}

#[test]
fn the_characters_of_the_kinetic_energy_are_proven_without_rounding() {
    let displays: [&[&str]; 16] = [
        &["kinetic-energy"],
        &["kinetic-energy.substituted"],
        &["eq-1-16"],
        &["position-rate.set-up"],
        &["momentum"],
        &["momentum-rate.set-up"],
        &[
            "momentum-rate.quotient.first-line",
            "momentum-rate.quotient.second-line",
            "momentum-rate.quotient.third-line",
        ],
        &["momentum-rate.cancelled.first-line", "momentum-rate.cancelled.second-line"],
        &["momentum-rate.factored.first-line", "momentum-rate.factored.second-line"],
        &["momentum-rate"],
        // The slip of the line before these is in a term that the derivative loses.
        &["position-rate.outside"],
        &["position-rate.quotient"],
        &["position-rate.cancelled"],
        &["position-rate.factored"],
        &["position-rate"],
        &["left-side"],
    ];
    are_decided::<9>(&displays, mechanism);
}

#[test]
fn the_characters_of_the_equation_of_motion_are_proven_without_rounding() {
    let displays: [&[&str]; 9] = [
        &["eq-1-17"],
        &["parts-put-in.first-line", "parts-put-in.second-line"],
        &["eq-1-18.first-line", "eq-1-18.second-line"],
        &["factor-a"],
        &["factor-b"],
        &["factor-c"],
        &["factor-d"],
        &["factor-e"],
        &["eq-1-19"],
    ];
    are_decided::<9>(&displays, mechanism);
    let displays: [&[&str]; 6] = [
        &["app-b.eq-1-19"],
        &["app-b.f"],
        &["app-b.with-sign"],
        &["app-b.expanded"],
        &["app-b.collected"],
        &["app-b.solved"],
    ];
    are_decided::<7>(&displays, factors);
}
