//! The printed characters of the friction and of Appendix B, proven or refuted without rounding.
//!
//! The identities of the formula crates stand for the same displays, typed by hand. Here nothing is typed but what the
//! letters are. Half powers and bars go through: the base 1 + a² − 2a cos θ is R², so its half powers are powers of a
//! variable R, and cos θ is (1 + a² − R²)/2a; what stands between bars is taken with either sign. The identities stay,
//! for all that: they tell one slip of a display from another, and say what stands against what.

use geneva_kinematics::{Field, Jet, Proof, Refutation, prove};
use geneva_ledger::tex::{Characters, Exact, LettersOverAnyField, Moment};
use geneva_ledger::{Verdict, claim};

/// The mechanism with friction, with a given sign of what stands between bars.
///
/// Variables: R, a, sin θ, θ', θ'', r, I_f, μ, and two letters that are slips for others: I_P and the rate of φ.
struct Friction {
    bars: i64,
}

impl LettersOverAnyField<8> for Friction {
    fn at<S: Field>(
        &self,
        [distance, ratio, sine, speed, gain, radius, inertia, friction]: &[S; 8],
    ) -> Moment<Exact<S>> {
        let two = || S::integer(2);
        let square = distance.clone() * distance.clone();
        let cosine = (S::one() + ratio.clone() * ratio.clone() - square.clone()) / (two() * ratio.clone());
        // Eq. (1-7), φ' = θ' (a cos θ − 1)/R², over the motion: (cos θ)' = −sin θ θ' and (R²)' = 2 a sin θ θ'.
        let turning = ratio.clone() * sine.clone() * speed.clone();
        let above = Jet::<S, 2>::from_coefficients([ratio.clone() * cosine.clone() - S::one(), -turning.clone()]);
        let below = Jet::from_coefficients([square.clone(), two() * turning]);
        let follower_gain = (Jet::from_coefficients([speed.clone(), gain.clone()]) * above / below).rate();
        // Moments on the follower: the pin presses at the distance r R from its axis.
        let force = inertia.clone() * follower_gain.clone() / (radius.clone() * distance.clone());
        // Virtual work: the pin slides by dR/dθ = a sin θ/R, in crank radii.
        let sliding = radius.clone() * ratio.clone() * sine.clone() / distance.clone();
        let lost = friction.clone() * S::integer(self.bars) * force.clone() * sliding;
        let letters = [
            ("a", ratio.clone()),
            ("r", radius.clone()),
            ("R", radius.clone() * distance.clone()),
            ("theta'", speed.clone()),
            ("theta''", gain.clone()),
            ("phi''", follower_gain),
            ("I_f", inertia.clone()),
            // A slip for I_f: any other number.
            ("I_P", inertia.clone() + S::one()),
            ("mu", friction.clone()),
            ("N", force),
            ("tau_2", -lost),
        ];
        Moment::of(letters.map(|(name, value)| (name.to_owned(), Exact(value))).into())
            .giving(r"\cos\theta", Exact(cosine))
            .giving(r"\sin\theta", Exact(sine.clone()))
            .giving(r"1 + a^2 - 2a\cos\theta", Exact(square))
            .giving(r"(1 + a^2 - 2a\cos\theta)^{1/2}", Exact(distance.clone()))
            .opening_bars(Exact(S::integer(self.bars)))
    }
}

/// Eq. (1-19) by its letters, with S for the sign of what stands between the bars.
///
/// Variables: A + S D, B, C, D, θ', θ'', and a θ that is a slip for θ'.
struct Factors {
    bars: i64,
}

impl LettersOverAnyField<7> for Factors {
    fn at<S: Field>(&self, [slope, b, c, d, speed, gain, angle]: &[S; 7]) -> Moment<Exact<S>> {
        let sign = S::integer(self.bars);
        let square = speed.clone() * speed.clone();
        let between = c.clone() * square.clone() + d.clone() * gain.clone();
        let a = slope.clone() - sign.clone() * d.clone();
        let driven = a.clone() * gain.clone() + b.clone() * square + sign.clone() * between.clone();
        let letters = [("A", a), ("B", b.clone()), ("C", c.clone()), ("D", d.clone()), ("E", driven), ("F", between)];
        let motion =
            [("S", sign.clone()), ("theta", angle.clone()), ("theta'", speed.clone()), ("theta''", gain.clone())];
        Moment::of(letters.into_iter().chain(motion).map(|(name, value)| (name.to_owned(), Exact(value))).collect())
            .giving("A + SD", Exact(slope.clone()))
            .opening_bars(Exact(sign))
    }
}

/// What becomes of characters for both signs between the bars: proven if they are for both.
fn decide<const V: usize, L: LettersOverAnyField<V>>(
    tex: &str,
    letters: impl Fn(i64) -> L,
) -> Vec<Result<Proof, Refutation>> {
    let decide = |sign: i64| {
        let letters = letters(sign);
        let characters = Characters::read(tex, &letters).unwrap_or_else(|error| panic!("{tex}: {error}"));
        prove(&characters)
    };
    [1, -1].map(decide).into()
}

/// The right characters of these claims are proven, and the printed ones refuted where they are not the same.
#[track_caller]
fn are_decided<const V: usize, L: LettersOverAnyField<V>>(ids: &[&str], letters: impl Fn(i64) -> L) {
    for id in ids {
        let claim = claim(id).unwrap_or_else(|| panic!("no {id}"));
        let right = decide(claim.right_characters(), &letters);
        println!("{id}: {}", right[0].as_ref().map_or_else(ToString::to_string, ToString::to_string));
        assert!(right.iter().all(Result::is_ok), "{id}: {right:?}");
        if claim.expected == Verdict::Corrected {
            let printed = decide(claim.printed, &letters);
            assert!(printed.iter().any(Result::is_err), "{id} is proven as printed");
        }
    }
}

#[test]
fn the_characters_of_the_friction_are_proven_without_rounding() {
    let ids = [
        "meyer.moments",
        "meyer.normal-force",
        "meyer.slot-radius",
        "meyer.normal-force.substituted",
        "meyer.eq-1-13",
        "meyer.eq-1-12",
        "meyer.friction-torque.substituted",
        "meyer.eq-1-14",
    ];
    are_decided(&ids, |bars| Friction { bars });
}

#[test]
fn the_characters_of_appendix_b_are_proven_without_rounding() {
    let ids =
        ["eq-1-19", "f", "with-sign", "expanded", "collected", "solved"].map(|part| format!("meyer.app-b.{part}"));
    are_decided(&ids.each_ref().map(String::as_str), |bars| Factors { bars });
}
