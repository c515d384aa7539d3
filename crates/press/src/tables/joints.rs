//! What a pin of finite radius and rubbing journals make of the thesis's mechanisms.

use crate::html::{Cells, Table, table};
use crate::numbers::signed;
use crate::rows::{parameters, weakest};
use anyhow::Context;
use geneva_dynamics::joints::{Effect, Joints, effects as all_effects, largest_pin_radius};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::comparable;
use std::sync::OnceLock;

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

/// The change of the mean speed of the three mechanisms with such joints.
pub fn speeds() -> anyhow::Result<Table> {
    let caption = "Change of the mean speed compared with ideal joints. Each row is named by the radius of the pin, \
                   and by the radius and friction of both journals. All radii are in crank radii. Inertias are as in the \
                   runs of the thesis, and the friction in the slot is μ = 1/4. Values in brackets exist on paper \
                   only, because the slots would run into one another";
    compared(caption, |effect| signed(100.0 * (effect.mean_speed - 1.0), 1) + "&nbsp;%")
}

/// The multiplier with such joints.
pub fn multipliers() -> anyhow::Result<Table> {
    let caption = "The multiplier with these joints: the fraction of a small difference in the squared speed that is \
                   left after one engagement. Joints, inertias and friction are as in the table of the mean speed";
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
    let found = found(mechanism)?;
    Ok(found.iter().map(|effect| (shown(effect), effect.value >= largest_pin_radius(mechanism))).collect())
}

/// The effects of ideal joints and of those compared on a mechanism of the thesis, found once.
fn found(mechanism: Mechanism) -> anyhow::Result<&'static [Effect]> {
    static FOUND: [OnceLock<Vec<Effect>>; 3] = [const { OnceLock::new() }; 3];
    let kept = Mechanism::ALL.iter().position(|of| *of == mechanism).and_then(|at| FOUND.get(at));
    let kept = kept.context("a mechanism of the thesis")?;
    if kept.get().is_none() {
        let list = std::iter::once(Joints::IDEAL).chain(COMPARED.map(joints));
        let of = parameters(weakest(comparable(mechanism))?)?;
        let all = all_effects(&of, list.map(|joints| (joints.pin_radius, joints)))?;
        return Ok(kept.get_or_init(|| all));
    }
    Ok(kept.get().map_or(&[], Vec::as_slice))
}

/// The effect on a mechanism of the thesis of joints that the tables compare: the radius of the pin, and radius and friction
/// of both journals, radii in crank radii.
///
/// # Errors
///
/// If the tables do not compare such joints.
pub fn effect(mechanism: Mechanism, of: (f64, f64, f64)) -> anyhow::Result<&'static Effect> {
    let at = COMPARED.iter().position(|compared| *compared == of);
    let at = at.with_context(|| format!("the tables compare no joints {of:?}: choose one of {COMPARED:?}"))?;
    found(mechanism)?.get(at + 1).context("one effect for each of the joints")
}

fn joints((pin_radius, journals, friction): (f64, f64, f64)) -> Joints {
    Joints { pin_radius, ..Joints::journals(journals, friction) }
}

fn named((pin, journals, friction): (f64, f64, f64)) -> String {
    let pin = (pin > 0.0).then(|| format!("pin {pin}"));
    let journals = (journals > 0.0).then(|| format!("journals {journals}, friction {friction}"));
    pin.into_iter().chain(journals).collect::<Vec<_>>().join("; ")
}
