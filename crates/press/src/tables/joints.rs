//! What a pin of finite radius and rubbing journals make of the thesis's mechanisms.

use crate::html::{Cells, Table, table};
use crate::numbers::signed;
use crate::rows::{parameters, weakest};
use geneva_dynamics::joints::{Effect, Joints, effects as all_effects, largest_pin_radius};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::comparable;

/// Radii in crank radii: of the pin, of both journals, and the friction of the journals.
const COMPARED: [(f64, f64, f64); 8] = [
    (0.05, 0.0, 0.0),
    (0.1, 0.0, 0.0),
    (0.15, 0.0, 0.0),
    (0.0, 0.1, 0.1),
    (0.0, 0.1, 0.2),
    (0.0, 0.2, 0.2),
    (0.1, 0.1, 0.2),
    (0.1, 0.2, 0.2),
];

/// By how much joints change the mean speed of the three mechanisms.
pub fn speeds() -> anyhow::Result<Table> {
    let caption = "What the joints do to the mean speed, against ideal joints. Pin: its radius, in crank radii; journals: \
                   radius of both, in crank radii, and their friction. Inertias as in the runs of the thesis, friction in \
                   the slot μ = 1/4. In brackets: on paper only, for the slots would run into one another";
    compared(caption, |effect| signed(100.0 * (effect.mean_speed - 1.0), 1) + "&nbsp;%")
}

/// The multiplier with such joints.
pub fn multipliers() -> anyhow::Result<Table> {
    let caption = "What the joints do to the multiplier, the part of a difference of speed squared that an engagement \
                   leaves. The same joints, inertias and friction";
    compared(caption, |effect| format!("{:.3}", effect.multiplier))
}

/// What is shown of an effect, for the joints and the mechanisms compared.
fn compared(caption: &str, shown: fn(&Effect) -> String) -> anyhow::Result<Table> {
    let mut cells = vec![vec!["ideal".to_owned()]];
    cells.extend(COMPARED.map(|of| vec![named(of)]));
    for mechanism in Mechanism::ALL {
        for (cells, (number, on_paper)) in cells.iter_mut().zip(effects(mechanism, shown)?) {
            cells.push(if on_paper { format!("({number})") } else { number });
        }
    }
    let pins = Mechanism::ALL.map(|mechanism| format!("{} pins", mechanism.pins()));
    let [first, second, third] = &pins;
    table(caption, Cells::NamedNumbers, &["joints", first, second, third], cells.into_iter().map(Ok))
}

/// What is shown of ideal joints and of those compared, and whether it is on paper only.
fn effects(mechanism: Mechanism, shown: fn(&Effect) -> String) -> anyhow::Result<Vec<(String, bool)>> {
    let list = std::iter::once(Joints::IDEAL).chain(COMPARED.map(joints));
    let of = parameters(weakest(comparable(mechanism))?)?;
    let found = all_effects(&of, list.map(|joints| (joints.pin_radius, joints)))?;
    Ok(found.iter().map(|effect| (shown(effect), effect.value >= largest_pin_radius(mechanism))).collect())
}

fn joints((pin_radius, journals, friction): (f64, f64, f64)) -> Joints {
    Joints { pin_radius, ..Joints::journals(journals, friction) }
}

fn named((pin, journals, friction): (f64, f64, f64)) -> String {
    let pin = (pin > 0.0).then(|| format!("pin {pin}"));
    let journals = (journals > 0.0).then(|| format!("journals {journals}, friction {friction}"));
    pin.into_iter().chain(journals).collect::<Vec<_>>().join("; ")
}
