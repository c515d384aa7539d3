//! What the problem gives: the data, and how far apart the axes must be.

use super::*;
use crate::{Check, Consequence, Erratum, Origin, Slip, Verdict};
use geneva_kinematics::pin_proofs::{StandstillOfFourSlots, four_slot_entry_misfit};
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::{Field, Rational, Surd, prove, rational};

const STATEMENT: &str = "Problem, 1st paragraph";
const QUESTION: &str = "Problem, 2nd paragraph";

pub fn claims() -> Vec<Claim> {
    vec![
        Claim::value(
            WORK,
            "pin.driver-speed",
            STATEMENT,
            "angular velocity of the driver, a datum; the printed speed and radius give it back",
            ("10", "rad/s"),
            Check::number(
                (OtherPlaceInSource, || printed("pin.pin-speed") / printed("pin.crank-radius")),
                (OtherPlaceInSource, || printed("pin.follower-speed") / ratio_at_the_instant()),
            ),
        ),
        Claim::statement(
            WORK,
            "pin.standstill",
            STATEMENT,
            "a four-slot wheel stands still as the pin enters and leaves a slot if l is √2 R",
            "four slots",
            Check::equation(
                (ExactIdentity, only_the_root_of_two),
                (Jet, || {
                    let wheel = entry_of_a_wheel_in_quarters();
                    Finding::new(wheel == Some(true), "power series at β = ±45° with √2 exact: ω_S is zero at both")
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "pin.centre-distance",
            STATEMENT,
            "centre distance of a four-slot wheel that starts and stops from rest",
            r"l=1 \overline{2} R",
            Check::corrected_equation(
                (ExactIdentity, || {
                    // Two readings of the characters: one times two, and 1.222…
                    let misfits = [rational(2, 1), rational(11, 9)].map(|ratio| four_slot_entry_misfit(&ratio));
                    let holds = misfits.contains(&rational(0, 1));
                    Finding::new(
                        holds,
                        format!("off its circle by {} and {} if l/R is 2 or 1.222…", misfits[0], misfits[1]),
                    )
                }),
                || Finding::new(is_root_of_two_exact(), "exactly on its circle if l/R is √2"),
                (OtherPlaceInSource, || {
                    let found = ratio_from_printed_radius();
                    Finding::new(
                        found.0 <= 2f64.sqrt() && 2f64.sqrt() <= found.1,
                        format!("the printed r² wants l/R between {:.4} and {:.4}", found.0, found.1),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"l=\sqrt{2} R",
            slip: Slip {
                id: "",
                reason: "The root sign came out of the copy as the digit one, and its bar over the two.",
                witness: "The printed value of r² leads back to l/R = √2 within its digits, and to no other reading.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        }),
        Claim::value(
            WORK,
            "pin.crank-angle",
            QUESTION,
            "crank angle φ from the direction OB, a datum; the angle at B and the direction of v_P give it back",
            ("150", "°"),
            Check::number(
                (OtherPlaceInSource, || 180.0 - printed("pin.angle-at-driver")),
                (OtherPlaceInSource, || 90.0 + printed("pin.pin-velocity-direction")),
            ),
        ),
        Claim::statement(
            WORK,
            "pin.letter-f",
            QUESTION,
            "the letter f names the crank angle",
            "f",
            Check::corrected_equation(
                (OtherPlaceInSource, || {
                    Finding::new(
                        symbols::is_unambiguous("f"),
                        "the letter f stands for the crank angle and for an arrow",
                    )
                }),
                || Finding::new(symbols::ours_are_unambiguous(), "each of the book's symbols stands for one thing"),
                (OtherPlaceInSource, || {
                    let (angle, behind) = (printed("pin.crank-angle"), printed("pin.slot-point-velocity-direction"));
                    Finding::new(angle != behind, format!("f is {angle}° here and stands before {behind}° there"))
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "φ",
            slip: Slip {
                id: "",
                reason: "Greek letters and arrows came out of the copy as Latin letters: f for φ, and f for an arrow \
                    as well.",
                witness: "The angle printed behind the second f is another one.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        }),
    ]
}

/// The wheel's speed over the driver's by the closed form, from the angle alone.
fn ratio_at_the_instant() -> f64 {
    let crank = Turn::from_degrees(printed("pin.crank-angle"));
    velocity_ratio(&std::f64::consts::SQRT_2, &crank.supplement())
}

fn only_the_root_of_two() -> Finding {
    match prove(&StandstillOfFourSlots) {
        Ok(proof) => {
            Finding::new(is_root_of_two_exact(), format!("(k² − 1)(k² − 2) = 0: {proof}; k = 1 is no mechanism"))
        }
        refuted => refuted.into(),
    }
}

type WithTwo = Surd<Rational, 2>;

fn is_root_of_two_exact() -> bool {
    four_slot_entry_misfit(&WithTwo::root()) == WithTwo::integer(0)
}

/// Whether the wheel stands still at β = ±45°, where θ is ±45° too, by the pin's place differentiated over √2.
fn entry_of_a_wheel_in_quarters() -> Option<bool> {
    let half_root = WithTwo::root() / WithTwo::integer(2);
    let (one, root) = (WithTwo::integer(1), WithTwo::root());
    let enters = Turn { cos: -half_root.clone(), sin: half_root };
    let mut still = true;
    for crank in [enters.clone(), enters.reversed()] {
        let motion = pin_vectors::solve(&one, &root, &crank, &one)?;
        let on_the_diagonal = motion.position.x.clone() * motion.position.x.clone()
            == motion.position.y.clone() * motion.position.y.clone();
        still &= on_the_diagonal && motion.follower_speed == WithTwo::integer(0);
    }
    Some(still)
}

/// The interval of l/R that the printed digits of r² allow: k² − 2 k cos θ + 1 = r²/R² solved for the larger k.
fn ratio_from_printed_radius() -> (f64, f64) {
    let cosine = Turn::from_degrees(printed("pin.angle-at-driver")).cos;
    let half_unit =
        decimal("pin.radius-squared").map_or(f64::NAN, |decimal| decimal.unit_in_last_place().approximate() / 2.0);
    let ratio = |square: f64| cosine + (square - 1.0 + cosine * cosine).sqrt();
    let square = printed("pin.radius-squared");
    (ratio(square - half_unit), ratio(square + half_unit))
}
