//! What the joints of the thesis's mechanism with four pins cost.

use crate::tables::joints::parameters;
use geneva_dynamics::joints::{Joints, Varied, series};
use geneva_figures::Figure;
use geneva_figures::steady::{Line, losses as drawing};
use geneva_kinematics::Mechanism;

/// Friction of the journals.
const BEARINGS: f64 = 0.2;
/// The largest radius, in crank radii, and how many there are.
const LARGEST: f64 = 0.2;
const RADII: u32 = 8;

/// Mean speed and contraction over the radius of the pin, of the driver's journal, and of the follower's.
pub fn losses() -> anyhow::Result<Figure> {
    let of = parameters(Mechanism::FOUR_PIN)?;
    let journals = Joints { bearing_friction: BEARINGS, ..Joints::IDEAL };
    let varied = [
        ("pin", Joints::IDEAL, Varied::PinRadius),
        ("driver's journal", journals, Varied::DriverJournal),
        ("follower's journal", journals, Varied::FollowerJournal),
    ];
    let (mut speeds, mut contractions) = (Vec::new(), Vec::new());
    for (name, joints, varied) in varied {
        let radii = (0..=RADII).map(|k| LARGEST * f64::from(k) / f64::from(RADII));
        let effects = series(&of, &joints, varied, radii)?;
        let line = |points: Vec<(f64, f64)>| Line { name: name.to_owned(), points };
        speeds.push(line(effects.iter().map(|effect| (effect.value, effect.mean_speed)).collect()));
        contractions.push(line(effects.iter().map(|effect| (effect.value, effect.contraction)).collect()));
    }
    Ok(drawing("radius in crank radii", &speeds, &contractions))
}
