//! What a pin of finite radius and rubbing journals make of the thesis's mechanisms.

use crate::rows::{number_with, weakest};
use geneva_ask::escapement::Further;
use geneva_documents::meyer::runs::choice::comparable;
use geneva_kinematics::Mechanism;
use geneva_press::numbers::signed;
use geneva_press::table::{Cells, Table};

/// Ideal joints, and joints compared with them; radii in crank radii: of the pin, of both journals, and the friction of the
/// journals.
const COMPARED: [(f64, f64, f64); 9] = [
    (0.0, 0.0, 0.0),
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
    compared(CHANGE, |change| signed(100.0 * change, 1) + "&nbsp;%")
}

/// The multiplier with such joints.
pub fn multipliers() -> anyhow::Result<Table> {
    compared("joints_multiplier", |multiplier| format!("{multiplier:.3}"))
}

/// How joints change the mean speed, as a part of it.
pub const CHANGE: &str = "joints_speed_change";

/// A number of the joints and the mechanisms compared; in brackets what exists on paper only.
fn compared(key: &str, shown: fn(f64) -> String) -> anyhow::Result<Table> {
    let cell = |joints: &_, mechanism: &Mechanism| {
        let number = shown(effect(*mechanism, *joints, key)?);
        let on_paper = joints.0 >= effect(*mechanism, *joints, "largest_pin_radius")?;
        Ok(if on_paper { format!("({number})") } else { number })
    };
    Table::with_rows(Cells::NamedNumbers, COMPARED)
        .column("joints", |joints| named(*joints))
        .columns(Mechanism::ALL, |mechanism| format!("{} pins", mechanism.pins()), cell)
        .finish()
}

/// A number of a mechanism of the thesis with joints: the radius of the pin, and radius and friction of both journals, radii in
/// crank radii.
pub fn effect(mechanism: Mechanism, (pin, journals, friction): (f64, f64, f64), key: &str) -> anyhow::Result<f64> {
    let joints = Further::with_joints([pin, journals, journals, friction]);
    number_with(weakest(comparable(mechanism))?, |question| question.further = joints, key)
}

fn named((pin, journals, friction): (f64, f64, f64)) -> String {
    let pin = (pin > 0.0).then(|| format!("pin {pin}"));
    let journals = (journals > 0.0).then(|| format!("journals {journals}, friction {friction}"));
    let named: Vec<_> = pin.into_iter().chain(journals).collect();
    if named.is_empty() { "ideal".to_owned() } else { named.join("; ") }
}
