//! Of the chapter on the timer's accuracy: seconds a day, powers, oil, accelerations, averages.

use super::{Number, least, most};
use crate::numbers::{fixed, signed};
use crate::rows::{engagement, example, parameters};
use crate::tables::timer::{DAY, oiled, settling_times};
use geneva_dynamics::timer::{Accelerations, Sensitivities};
use geneva_ledger::meyer::runs::Hypothesis;
use geneva_ledger::meyer::runs::choice::{strongest, weakest};

/// The numbers of this chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("timer.day.torque", || Ok(seconds(Sensitivities::new(&parameters(example()?)?)?.torque))),
    ("timer.day.friction.least", || Ok(fixed(DAY * least(&frictions()?) / 100.0, 0))),
    ("timer.day.friction.most", || Ok(seconds(most(&frictions()?)))),
    ("timer.minutes.friction.least", || Ok(fixed(least(&frictions()?) * DAY / 6000.0, 0))),
    ("timer.minutes.friction.most", || Ok(fixed(most(&frictions()?) * DAY / 6000.0, 0))),
    ("timer.power.least", || Ok(signed(-least(&frictions()?), 2))),
    ("timer.power.most", || Ok(signed(-most(&frictions()?), 2))),
    ("timer.oil.least", || Ok(fixed(100.0 * (least(&oil()?) - 1.0), 0))),
    ("timer.oil.most", || Ok(per_cent(most(&oil()?)))),
    ("timer.settling.least", || Ok(fixed(1e3 * least(&settling_times()?), 0))),
    ("timer.settling.most", || Ok(format!("{}&nbsp;ms", fixed(1e3 * most(&settling_times()?), 0)))),
    ("timer.force.least", || Ok(fixed(least(&forces()?), 0))),
    ("timer.force.most", || Ok(fixed(most(&forces()?), 0))),
    ("timer.average.least", || Ok(fixed(least(&averages()?), 1))),
    ("timer.average.most", || Ok(fixed(most(&averages()?), 1))),
];

fn seconds(power: f64) -> String {
    format!("{}&nbsp;s", fixed(DAY * power / 100.0, 0))
}

fn per_cent(factor: f64) -> String {
    format!("{}&nbsp;%", fixed(100.0 * (factor - 1.0), 0))
}

/// By what power of the friction the mean speed falls, of each mechanism and friction.
fn frictions() -> anyhow::Result<Vec<f64>> {
    weakest().map(|row| Ok(-Sensitivities::new(&parameters(row)?)?.friction)).collect()
}

/// How many times as fast each is with half the friction.
fn oil() -> anyhow::Result<Vec<f64>> {
    weakest().map(|row| oiled(&parameters(row)?)).collect()
}

/// The greatest force on the pin over that of the spring at the crank radius.
fn forces() -> anyhow::Result<Vec<f64>> {
    strongest().map(|row| Ok(Accelerations::new(&parameters(row)?)?.normal_moment.value.abs() / row.torque())).collect()
}

/// The mean of peak and minimum over the mean speed.
fn averages() -> anyhow::Result<Vec<f64>> {
    weakest()
        .map(|row| {
            let steady = engagement(row, &Hypothesis::IDEAL)?.steady_state()?;
            Ok(steady.mean_of_extremes() / steady.mean_speed)
        })
        .collect()
}
