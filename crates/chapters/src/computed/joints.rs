//! Of the chapter on pins of finite radius and friction in the bearings: per cents of the mean speed.

use super::kinds::ANGLE_STEPS;
use super::second_routes::contact::ContactModel;
use super::second_routes::{NEWTON_DIFFERENCE, mean_speed};
use super::{least, most};
use crate::rows::{number, number_with, weakest};
use crate::tables::joints::{CHANGE, effect};
use geneva_ask::escapement::Further;
use geneva_documents::meyer::runs::choice::comparable;
use geneva_evidence::{Form, GIVEN, Numbers, OwnNumber};
use geneva_kinematics::Mechanism;
use geneva_press::numbers::fixed;

/// Radius of the pin, radius and friction of the journals, of which the chapter speaks first; radii in crank radii.
const WITH_PIN: (f64, f64, f64) = (0.1, 0.0, 0.0);
const WITH_JOURNALS: (f64, f64, f64) = (0.0, 0.1, 0.2);
const WITH_BOTH: (f64, f64, f64) = (0.1, 0.1, 0.2);

/// The numbers of this chapter.
pub(super) fn numbers() -> Vec<OwnNumber> {
    let (faster, slower) = ("a thick pin makes it faster", "journals make it slower");
    let both = |changes: [f64; 3]| most(&changes.map(f64::abs));
    let over = |changes: [f64; 3]| least(&changes);
    let up_to = |changes: [f64; 3]| most(&changes);
    let braked = |changes: [f64; 3]| changes.map(|change| -change);
    vec![
        speed_change_measure("joints.pin.least", Form::Written(without_sign), faster, WITH_PIN, over),
        speed_change_measure("joints.pin.most", Form::Written(per_cent), faster, WITH_PIN, up_to),
        speed_change_measure("joints.journals.least", Form::Written(without_sign), slower, WITH_JOURNALS, move |all| {
            over(braked(all))
        }),
        speed_change_measure("joints.journals.most", Form::Written(per_cent), slower, WITH_JOURNALS, move |all| {
            up_to(braked(all))
        }),
        OwnNumber::new("joints.friction", "{.2}", GIVEN, || {
            Ok(number(weakest(comparable(Mechanism::FOUR_PIN))?, "friction")?)
        }),
        driver_over_follower("joints.driver-over-follower.4", Mechanism::FOUR_PIN),
        driver_over_follower("joints.driver-over-follower.3", Mechanism::THREE_PIN),
        driver_over_follower("joints.driver-over-follower.6", Mechanism::SIX_PIN),
        speed_change_measure("joints.both", Form::Written(per_cent), "together they change little", WITH_BOTH, both),
    ]
}

/// A share in per cent, without the sign behind it.
fn without_sign(shares: &[f64]) -> String {
    shares.iter().map(|share| fixed(100.0 * share, 0)).collect()
}

/// A share in per cent, with a decimal if it is small.
fn per_cent(shares: &[f64]) -> String {
    let one = |share: &f64| format!("{}&nbsp;%", fixed(100.0 * share, if *share < 0.01 { 1 } else { 0 }));
    shares.iter().map(one).collect()
}

/// What a measure makes of the parts of itself by which these joints change the mean speed of each mechanism.
fn speed_change_measure(
    id: &'static str,
    form: Form,
    conclusion: &'static str,
    joints: (f64, f64, f64),
    measure: impl Fn([f64; 3]) -> f64 + Copy + Send + Sync + 'static,
) -> OwnNumber {
    let (pin, radius, friction) = joints;
    let of_all = |of: &dyn Fn(Mechanism) -> Numbers<f64>| -> Numbers<[f64; 3]> {
        let [six, four, three] = Mechanism::ALL.map(of);
        Ok([six?, four?, three?])
    };
    OwnNumber::new(id, form, ANGLE_STEPS, move || {
        Ok(measure(of_all(&|mechanism| Ok(effect(mechanism, joints, CHANGE)?))?))
    })
    .with_second_route(conclusion, NEWTON_DIFFERENCE, move || {
        Ok(measure(of_all(&|mechanism| speed_change(mechanism, pin, [radius * friction; 2]))?))
    })
}

/// By what part of itself a pin of this radius and journals of these radii times their friction change the mean speed, by two
/// motions.
fn speed_change(mechanism: Mechanism, pin_radius: f64, journals: [f64; 2]) -> Numbers<f64> {
    let ideal = ContactModel::of_row(weakest(comparable(mechanism))?);
    Ok(mean_speed(ContactModel { pin_radius, journals, ..ideal })? / mean_speed(ideal)? - 1.0)
}

/// How many times as much of the mean speed the driver's journal takes as the follower's, alone.
fn driver_over_follower(id: &'static str, mechanism: Mechanism) -> OwnNumber {
    let (_, radius, friction) = WITH_JOURNALS;
    OwnNumber::new(id, "{.1}", ANGLE_STEPS, move || {
        let row = weakest(comparable(mechanism))?;
        let lost = |joints| number_with(row, |question| question.further = Further::with_joints(joints), CHANGE);
        Ok(lost([0.0, radius, 0.0, friction])? / lost([0.0, 0.0, radius, friction])?)
    })
    .with_second_route("the driver's bearing costs more", NEWTON_DIFFERENCE, move || {
        let arm = radius * friction;
        Ok(speed_change(mechanism, 0.0, [arm, 0.0])? / speed_change(mechanism, 0.0, [0.0, arm])?)
    })
}
