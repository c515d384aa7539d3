//! What a pin of finite radius and rubbing journals make of the thesis's mechanisms.

use crate::html::{Cells, Table, table};
use crate::rows::{parameters, weakest};
use geneva_dynamics::joints::{Joints, effects as all_effects, largest_pin_radius};
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

/// Mean speed over that with ideal joints, and multiplier, of the three mechanisms.
pub fn effects() -> anyhow::Result<Table> {
    let joints = |(pin_radius, journals, friction): (f64, f64, f64)| Joints {
        pin_radius,
        ..Joints::journals(journals, friction)
    };
    let mut cells = vec![vec!["ideal".to_owned()]];
    cells.extend(COMPARED.map(|of| vec![named(of)]));
    for mechanism in Mechanism::ALL {
        let parameters = parameters(weakest(comparable(mechanism))?)?;
        let list = std::iter::once(Joints::IDEAL).chain(COMPARED.map(joints));
        let found = all_effects(&parameters, list.map(|joints| (joints.pin_radius, joints)))?;
        for (cells, effect) in cells.iter_mut().zip(found) {
            let numbers = [format!("{:.3}", effect.mean_speed), format!("{:.3}", effect.multiplier)];
            let on_paper = effect.value >= largest_pin_radius(parameters.mechanism());
            cells.extend(numbers.map(|number| if on_paper { format!("({number})") } else { number }));
        }
    }
    let pins = Mechanism::ALL.map(|mechanism| format!("{} pins: mean speed", mechanism.pins()));
    let [first, second, third] = &pins;
    let head = ["Joints", first, "multiplier", second, "multiplier", third, "multiplier"];
    let cells = cells.into_iter().map(Ok);
    table(
        "Mean speed and multiplier with a pin of finite radius and rubbing journals",
        Cells::NamedNumbers,
        &head,
        cells,
    )
}

fn named((pin, journals, friction): (f64, f64, f64)) -> String {
    let pin = (pin > 0.0).then(|| format!("pin {pin}"));
    let journals = (journals > 0.0).then(|| format!("journals {journals}, friction {friction}"));
    pin.into_iter().chain(journals).collect::<Vec<_>>().join("; ")
}
