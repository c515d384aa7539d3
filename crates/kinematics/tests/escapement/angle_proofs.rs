//! Is every line to the follower's angle proven but the printed slip?

use geneva_kinematics::escapement::Form;
use geneva_kinematics::escapement::angle_proofs::AngleStep;
use geneva_kinematics::{Expression, Identity, Turn, pin_slot, prove, rational};

#[test]
fn every_line_is_proven_but_the_printed_slip() {
    for step in AngleStep::ALL {
        match prove(&step) {
            Ok(proof) => println!("{step:?}: {proof}"),
            Err(refutation) => {
                println!("{step:?}: {refutation}");
                assert_eq!(step, AngleStep::CosineSubstituted(Form::Printed));
            }
        }
    }
    assert!(prove(&AngleStep::CosineSubstituted(Form::Printed)).is_err());
}

#[test]
fn the_crossing_is_the_pin_of_the_other_formulas() {
    let halves = [rational(1, 3), rational(1, 4)];
    let [theta, phi] = halves.clone().map(|half| Turn::from_half_tangent(&half));
    let at = [&[rational(1, 1)], &halves[..]].concat();
    let difference = |step: AngleStep| step.difference([0, 1, 2].map(Expression::variable)).at(&at);
    // With its slip, a line is cos φ less a − cos θ: it tells the a of the crossing, and with it r.
    let slip = difference(AngleStep::CosineSubstituted(Form::Printed));
    let ratio = phi.cos.clone() + theta.cos.clone() - slip;
    let crank_radius = rational(1, 1) / ratio.clone();
    let place = pin_slot::pin_from_pivot(&ratio, &theta) * crank_radius.clone();
    let rest = ratio.clone() - theta.cos.clone();
    // Other lines tell where the crossing's pin is seen, and the square of its R.
    let cotangent = rest / theta.sin.clone() - difference(AngleStep::InverseTangent);
    assert_eq!(place.x.clone() / place.y.clone(), cotangent);
    assert_eq!(place.x.clone() / place.y.clone(), phi.cos.clone() / phi.sin);
    let under_root =
        rational(1, 1) + ratio.clone() * ratio.clone() - rational(2, 1) * ratio.clone() * theta.cos.clone();
    let r_squared = crank_radius.clone() * crank_radius;
    let square = difference(AngleStep::SlotRadiusByRoot) + r_squared.clone() * under_root;
    assert_eq!(square, pin_slot::slot_radius_squared(&ratio, &theta) * r_squared);
    assert_eq!(square, place.dot(&place));
    // And its place along the line of centres: c − r cos θ is R cos φ.
    assert_eq!(difference(AngleStep::Projection), rational(0, 1));
}
