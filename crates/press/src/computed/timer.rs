//! Of the chapter on the timer's accuracy: seconds a day, powers, oil, accelerations, averages.

use super::{Number, least, most};
use crate::numbers::{fixed, signed};
use crate::rows::{self, engagement, example, parameters};
use crate::tables::timer::{DAY, lighter_times, oiled, settling_times};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::{Accelerations, Sensitivities};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::{least_braked, strongest, weakest};
use geneva_ledger::meyer::runs::{Hypothesis, Row};
use geneva_ledger::meyer::terms::MISSING;

/// The numbers of this chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("timer.day.torque", || Ok(seconds(Sensitivities::new(&parameters(example()?)?)?.torque))),
    ("timer.day.friction.least", || Ok(fixed(DAY * least(&frictions()?) / 100.0, 0))),
    ("timer.day.friction.most", || Ok(seconds(most(&frictions()?)))),
    ("timer.minutes.friction.least", || Ok(fixed(least(&frictions()?) * DAY / 6000.0, 0))),
    ("timer.minutes.friction.most", || Ok(fixed(most(&frictions()?) * DAY / 6000.0, 0))),
    ("timer.power.least", || Ok(signed(-least(&frictions()?), 2))),
    ("timer.power.most", || Ok(signed(-most(&frictions()?), 2))),
    ("timer.minutes.torque", || Ok(fixed(Sensitivities::new(&parameters(example()?)?)?.torque * DAY / 6000.0, 1))),
    ("timer.two-thirds", || Ok(fixed(HOURS * (1.0 - (2.0_f64 / 3.0).sqrt()), 1))),
    ("timer.brass.castor", || Ok(fixed(STEEL_ON_BRASS[0].0, 2))),
    ("timer.brass.mineral", || Ok(fixed(STEEL_ON_BRASS[1].0, 2))),
    ("timer.brass.dry", || Ok(fixed(STEEL_ON_BRASS[2].0, 2))),
    ("timer.friction.least", || Ok(fixed(least(&run_with()), 2))),
    ("timer.friction.most", || Ok(fixed(most(&run_with()), 2))),
    ("timer.dry.least", || Ok(fixed(-most(&hours_from_mineral_oil(2)?), 1))),
    ("timer.dry.most", || Ok(fixed(-least(&hours_from_mineral_oil(2)?), 1))),
    ("timer.castor.least", || Ok(fixed(least(&hours_from_mineral_oil(0)?), 1))),
    ("timer.castor.most", || Ok(fixed(most(&hours_from_mineral_oil(0)?), 1))),
    ("timer.reported.foliot", || Ok(REPORTED[0].to_owned())),
    ("timer.reported.verge", || Ok(REPORTED[1].to_owned())),
    ("timer.reported.pendulum", || Ok(REPORTED[2].to_owned())),
    ("timer.reported.lever", || Ok(REPORTED[3].to_owned())),
    ("timer.oil.least", || Ok(fixed(100.0 * (least(&oil()?) - 1.0), 0))),
    ("timer.oil.most", || Ok(per_cent(most(&oil()?)))),
    ("timer.settling.least", || Ok(fixed(1e3 * least(&settling_times()?), 0))),
    ("timer.settling.most", || Ok(format!("{}&nbsp;ms", fixed(1e3 * most(&settling_times()?), 0)))),
    ("timer.lighter.gain", || Ok(format!("{}&nbsp;%", fixed(100.0 * (1.0 - least(&lighter_times()?)), 0)))),
    ("timer.lighter.cost", || Ok(fixed(most(&lighter_times()?), 1))),
    ("timer.over-torque.six", || over_torque(Mechanism::SIX_PIN)),
    ("timer.over-torque.four", || over_torque(Mechanism::FOUR_PIN)),
    ("timer.over-torque.three", || over_torque(Mechanism::THREE_PIN)),
    ("timer.rise.most", || Ok(format!("{}&nbsp;%", fixed(100.0 * most(&rise_changes()?), 1)))),
    ("timer.rise.runs", || {
        let changes = rise_changes()?;
        Ok(changes.iter().filter(|change| **change > PER_CENT).count().to_string())
    }),
    ("timer.rise.of", || Ok(rise_changes()?.len().to_string())),
    ("timer.force.least", || Ok(fixed(least(&forces()?), 0))),
    ("timer.force.most", || Ok(fixed(most(&forces()?), 0))),
    ("timer.average.least", || Ok(fixed(least(&averages()?), 1))),
    ("timer.average.most", || Ok(fixed(most(&averages()?), 1))),
];

/// Friction at which the plot over the friction is set right: one that the thesis ran with all three mechanisms.
pub const SET: f64 = 0.25;

/// Static coefficients of friction of steel on brass, from the CRC Handbook as Hahn quotes it for watchmakers: `hahn` in the
/// bibliography.
pub const STEEL_ON_BRASS: [(f64, &str); 3] = [(0.11, "castor oil"), (0.19, "mineral oil"), (0.35, "dry")];

/// What is reported of other timekeepers: verge and foliot, clocks and watches before the pendulum, the factor that the
/// pendulum gained, and the mean daily rate of a chronometer; `wikipedia-verge`, `canter`, `blumenthal` and `iso-3159` in the
/// bibliography.
const REPORTED: [&str; 4] = [
    "1 to 2 hours by some estimates, minutes in modern experiments with carefully kept clocks",
    "15 to 30 minutes",
    "30",
    "−4 to +6 seconds",
];

/// Hours of a day.
const HOURS: f64 = 24.0;

/// The frictions of the runs.
fn run_with() -> Vec<f64> {
    weakest().map(Row::friction).collect()
}

/// The hours that each mechanism, set right with mineral oil, gains in a day with another of the frictions of steel on brass.
fn hours_from_mineral_oil(other: usize) -> anyhow::Result<Vec<f64>> {
    let speed = |own: &Parameters, friction: f64| {
        let of = Parameters::new(own.mechanism(), own.inertias(), own.torque(), friction)?;
        Ok::<_, anyhow::Error>(Engagement::new(&of)?.steady_state()?.mean_speed)
    };
    let of = |mechanism| {
        let own = parameters(rows::weakest(least_braked(mechanism))?)?;
        Ok(HOURS * (speed(&own, STEEL_ON_BRASS[other].0)? / speed(&own, STEEL_ON_BRASS[1].0)? - 1.0))
    };
    Mechanism::ALL.into_iter().map(of).collect()
}

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

/// The power of the friction over that of the torque, from the least to the greatest of a mechanism.
fn over_torque(mechanism: Mechanism) -> anyhow::Result<String> {
    let own = weakest().filter(|row| row.mechanism == mechanism);
    let quotients = own.map(|row| {
        let found = Sensitivities::new(&parameters(row)?)?;
        Ok(-found.friction / found.torque)
    });
    let quotients = quotients.collect::<anyhow::Result<Vec<_>>>()?;
    Ok(format!("{:.2} to {:.2}", least(&quotients), most(&quotients)))
}

const PER_CENT: f64 = 0.01;

/// The greatest relative change of the rise time, until the velocity is the steady one at each angle, by one per cent more
/// of friction or of an inertia, for each mechanism and friction.
fn rise_changes() -> anyhow::Result<Vec<f64>> {
    let rise = |of: &Parameters| Ok::<_, anyhow::Error>(Engagement::new(of)?.until_profile(MISSING)?);
    weakest()
        .map(|row| {
            let own = parameters(row)?;
            let (before, inertias, more) = (rise(&own)?, own.inertias(), 1.0 + PER_CENT);
            let mut changes = Vec::new();
            for (friction, driver, follower) in [(more, 1.0, 1.0), (1.0, more, 1.0), (1.0, 1.0, more)] {
                let inertias = Inertias::new(inertias.driver() * driver, inertias.follower() * follower)?;
                let changed = Parameters::new(own.mechanism(), inertias, own.torque(), own.friction() * friction)?;
                changes.push((rise(&changed)? / before - 1.0).abs());
            }
            Ok(most(&changes))
        })
        .collect()
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
