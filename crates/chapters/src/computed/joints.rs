//! Of the chapter on pins of finite radius and friction in the bearings: per cents of the mean speed.

use super::{Number, least, most};
use crate::numbers::fixed;
use crate::rows::{number, number_with, weakest};
use crate::tables::joints::{CHANGE, effect};
use geneva_documents::meyer::runs::choice::comparable;
use geneva_kinematics::Mechanism;

/// Radius of the pin, radius and friction of the journals, of which the chapter speaks first; radii in crank radii.
const WITH_PIN: (f64, f64, f64) = (0.1, 0.0, 0.0);
const WITH_JOURNALS: (f64, f64, f64) = (0.0, 0.1, 0.2);
const WITH_BOTH: (f64, f64, f64) = (0.1, 0.1, 0.2);

/// The numbers of this chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("joints.pin.least", || Ok(fixed(100.0 * least(&with(WITH_PIN)?), 0))),
    ("joints.pin.most", || Ok(per_cent(most(&with(WITH_PIN)?)))),
    ("joints.journals.least", || Ok(fixed(100.0 * least(&slower()?), 0))),
    ("joints.journals.most", || Ok(per_cent(most(&slower()?)))),
    ("joints.friction", || Ok(number(weakest(comparable(Mechanism::FOUR_PIN))?, "friction")?.to_string())),
    ("joints.driver-over-follower.4", || driver_over_follower(Mechanism::FOUR_PIN)),
    ("joints.driver-over-follower.3", || driver_over_follower(Mechanism::THREE_PIN)),
    ("joints.driver-over-follower.6", || driver_over_follower(Mechanism::SIX_PIN)),
    ("joints.both", || Ok(per_cent(most(&with(WITH_BOTH)?.map(f64::abs))))),
];

fn per_cent(share: f64) -> String {
    format!("{}&nbsp;%", fixed(100.0 * share, if share < 0.01 { 1 } else { 0 }))
}

/// By what part journals slow down each mechanism.
fn slower() -> anyhow::Result<[f64; 3]> {
    Ok(with(WITH_JOURNALS)?.map(|change| -change))
}

/// By what part of itself these joints change the mean speed of each mechanism.
fn with(joints: (f64, f64, f64)) -> anyhow::Result<[f64; 3]> {
    let mut changes = [0.0; 3];
    for (change, mechanism) in changes.iter_mut().zip(Mechanism::ALL) {
        *change = effect(mechanism, joints, CHANGE)?;
    }
    Ok(changes)
}

/// How many times as much of the mean speed the driver's journal takes as the follower's, alone.
fn driver_over_follower(mechanism: Mechanism) -> anyhow::Result<String> {
    let (_, radius, friction) = WITH_JOURNALS;
    let row = weakest(comparable(mechanism))?;
    let lost = |journal| number_with(row, &format!("--{journal} {radius} --bearing-friction {friction}"), CHANGE);
    Ok(fixed(lost("driver-journal")? / lost("follower-journal")?, 1))
}
