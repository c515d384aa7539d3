//! The printed characters of the equation of motion, proven or refuted without rounding.
//!
//! The identities of the formula crates stand for the same displays, typed by hand. Here nothing is typed but what the
//! letters are. Half powers and bars go through: the base 1 + a² − 2a cos θ is R², so its half powers are powers of a
//! variable R, and cos θ is (1 + a² − R²)/2a; what stands between bars is taken with either sign. Derivatives are taken
//! by the rules of calculus. The identities stay for all that: they tell one slip of a display from another.

use geneva_kinematics::{Field, Jet, prove};
use geneva_ledger::tex::{By, Characters, Exact, ExactLetters, Moment};
use geneva_ledger::{Verdict, claim};

/// The mechanism of chapter I, with a given sign of what stands between bars.
///
/// Variables: R, a, sin θ, θ', θ'', I_D, I_f, μ, r. That sine and cosine are of one angle is nowhere needed.
struct Mechanism {
    bars: i64,
}

impl ExactLetters<9> for Mechanism {
    fn at<S: Field>(&self, variables: &[S; 9]) -> Moment<Exact<S>> {
        let [distance, a, sine, speed, acceleration, driver, follower, friction, radius] = variables.clone().map(Exact);
        let number = |n: i64| Exact(S::integer(n));
        let square = distance.clone() * distance.clone();
        let cosine = (number(1) + a.clone() * a.clone() - square.clone()) / (number(2) * a.clone());
        // φ'/θ' = (a cos θ − 1)/R², Eq. (1-7), while θ grows: (cos θ)' = −sin θ and (R²)' = 2 a sin θ.
        let across = a.clone() * sine.clone();
        let above = Jet::<S, 2>::from_coefficients([(a.clone() * cosine.clone() - number(1)).0, (-across.clone()).0]);
        let below = Jet::from_coefficients([square.clone().0, (number(2) * across.clone()).0]);
        let ratio = above / below;
        let [turning, change] = [ratio.value(), ratio.rate()].map(Exact);
        let square_speed = speed.clone() * speed.clone();
        let follower_acceleration = change.clone() * square_speed.clone() + turning.clone() * acceleration.clone();
        // Moments on the follower: the pin presses at the distance r R from its axis.
        let force = follower.clone() * follower_acceleration.clone() / (radius.clone() * distance.clone());
        // Virtual work: the pin slides by r dR/dθ = r a sin θ/R, so that r cancels.
        let lost = |follower_acceleration: Exact<S>| {
            friction.clone() * follower_acceleration * across.clone() / square.clone()
        };
        let moving = driver.clone() + follower.clone() * turning.clone() * turning.clone();
        let momentum = moving.clone() * speed.clone();
        let by_angle = follower.clone() * turning.clone() * change.clone() * square_speed.clone();
        let growth = moving.clone() * acceleration.clone() + number(2) * by_angle.clone();
        let rubbing = number(-self.bars) * follower.clone() * lost(follower_acceleration.clone());
        let torque = growth.clone() - by_angle.clone() - rubbing.clone();
        let letters = [
            ("a", a),
            ("r", radius.clone()),
            ("R", radius.clone() * distance.clone()),
            ("theta'", speed.clone()),
            ("theta''", acceleration.clone()),
            ("phi'", turning.clone() * speed.clone()),
            ("phi''", follower_acceleration),
            ("I_D", driver.clone()),
            ("I_f", follower.clone()),
            // Slips for I_f and I_D: any other numbers.
            ("I_P", follower.clone() + number(1)),
            ("I_b", driver.clone() + number(1)),
            ("mu", friction.clone()),
            ("N", force),
            ("tau_2", rubbing),
            ("K", torque.clone()),
            ("T", moving.clone() * square_speed / number(2)),
            ("dT/dtheta'", momentum),
            ("dT/dtheta", by_angle),
            // Eq. (1-19): what multiplies θ'' and θ'², outside the bars and between them.
            ("A", moving / follower.clone()),
            ("B", turning.clone() * change.clone()),
            ("C", lost(change)),
            ("D", lost(turning)),
            ("E", torque / follower),
        ];
        let rates = [("theta", speed.clone()), ("theta'", acceleration), ("dT/dtheta'", growth)];
        Moment::of(letters.map(|(name, value)| (name.to_owned(), value)).into())
            .changing(By::Time, rates)
            .changing(By::Angle, [("theta", number(1))])
            .giving(r"\cos\theta", cosine)
            .giving(r"\sin\theta", sine)
            .giving(r"1 + a^2 - 2a\cos\theta", square)
            .giving(r"(1 + a^2 - 2a\cos\theta)^{1/2}", distance)
            .opening_bars(number(self.bars))
    }
}

/// Eq. (1-19) by its letters, with S for the sign of what stands between the bars.
///
/// Variables: A + S D, B, C, D, θ', θ'', and a θ that is a slip for θ'.
struct Factors {
    bars: i64,
}

impl ExactLetters<7> for Factors {
    fn at<S: Field>(&self, variables: &[S; 7]) -> Moment<Exact<S>> {
        let [slope, b, c, d, speed, acceleration, angle] = variables.clone().map(Exact);
        let sign = Exact(S::integer(self.bars));
        let square = speed.clone() * speed.clone();
        let between = c.clone() * square.clone() + d.clone() * acceleration.clone();
        let a = slope.clone() - sign.clone() * d.clone();
        let driven = a.clone() * acceleration.clone() + b.clone() * square + sign.clone() * between.clone();
        let letters = [("A", a), ("B", b), ("C", c), ("D", d), ("E", driven), ("F", between)];
        let motion = [("S", sign.clone()), ("theta", angle), ("theta'", speed), ("theta''", acceleration)];
        Moment::of(letters.into_iter().chain(motion).map(|(name, value)| (name.to_owned(), value)).collect())
            .giving("A + SD", slope)
            .opening_bars(sign)
    }
}

/// Whether characters are proven for both signs of what stands between bars, and how.
fn decide<const V: usize, L: ExactLetters<V>>(tex: &str, letters: &impl Fn(i64) -> L) -> Result<String, String> {
    let decide = |sign: i64| {
        let letters = letters(sign);
        let characters = Characters::read(tex, &letters).map_err(|error| error.to_string())?;
        prove(&characters).map(|proof| proof.to_string()).map_err(|refutation| refutation.to_string())
    };
    decide(1).and(decide(-1))
}

/// The right characters of these displays are proven, and are not any more with one line as it is printed with a slip.
#[track_caller]
fn are_decided<const V: usize, L: ExactLetters<V>>(displays: &[&[&str]], letters: impl Fn(i64) -> L) {
    for lines in displays {
        let lines = lines.iter().map(|line| claim(&format!("meyer.{line}")).unwrap_or_else(|| panic!("no {line}")));
        let lines: Vec<_> = lines.collect();
        let with_printed = |printed: &str| {
            let characters = |line: &&'static geneva_ledger::Claim| {
                if line.id == printed { line.printed } else { line.right_characters() }
            };
            decide(&lines.iter().map(characters).collect::<Vec<_>>().join(" "), &letters)
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
    are_decided(&displays, |bars| Mechanism { bars });
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
    are_decided(&displays, |bars| Mechanism { bars });
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
    are_decided(&displays, |bars| Mechanism { bars });
    let displays: [&[&str]; 6] = [
        &["app-b.eq-1-19"],
        &["app-b.f"],
        &["app-b.with-sign"],
        &["app-b.expanded"],
        &["app-b.collected"],
        &["app-b.solved"],
    ];
    are_decided(&displays, |bars| Factors { bars });
}
