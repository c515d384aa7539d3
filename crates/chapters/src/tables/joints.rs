//! What a pin of finite radius and rubbing journals make of the thesis's mechanisms.

use crate::rows::{number_with, weakest};
use geneva_ask::escapement::Further;
use geneva_documents::meyer::runs::choice::comparable;
use geneva_kinematics::Mechanism;
use geneva_press::html::{Cells, Table, table};
use geneva_press::numbers::signed;

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
    let caption = "Change of the mean speed compared with ideal joints. Each row is named by the radius of the pin, \
                   and by the radius and friction of both journals. All radii are given in units of the crank radius. \
                   Inertias are as in the runs of the thesis, and the friction in the slot is μ = 1/4. Values in \
                   brackets exist on paper only, because the slots would run into one another";
    compared(caption, CHANGE, |change| signed(100.0 * change, 1) + "&nbsp;%")
}

/// The multiplier with such joints.
pub fn multipliers() -> anyhow::Result<Table> {
    let caption = "The multiplier with different joints: the fraction of a small difference in the squared speed that \
                   is left after one engagement. Joints, inertias and friction are as in the table of the mean speed";
    compared(caption, "joints_multiplier", |multiplier| format!("{multiplier:.3}"))
}

/// How joints change the mean speed, as a part of it.
pub const CHANGE: &str = "joints_speed_change";

/// A number of the joints and the mechanisms compared; in brackets what exists on paper only.
fn compared(caption: &str, key: &str, shown: fn(f64) -> String) -> anyhow::Result<Table> {
    let rows = COMPARED.map(|of| {
        let mut cells = vec![named(of)];
        for mechanism in Mechanism::ALL {
            let number = shown(effect(mechanism, of, key)?);
            let on_paper = of.0 >= effect(mechanism, of, "largest_pin_radius")?;
            cells.push(if on_paper { format!("({number})") } else { number });
        }
        Ok(cells)
    });
    let pins = Mechanism::ALL.map(|mechanism| format!("{} pins", mechanism.pins()));
    let [first, second, third] = &pins;
    table(caption, Cells::NamedNumbers, &["joints", first, second, third], rows)
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
