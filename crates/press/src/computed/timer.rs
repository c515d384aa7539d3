//! Of the chapter on the timer's accuracy: seconds a day, powers, oil, accelerations, averages.

use super::escapement::over;
use super::{Number, least, most};
use crate::numbers::{fixed, signed};
use crate::rows::{self, engagement, example, parameters};
use crate::tables::joints::effect;
use crate::tables::timer::{DAY, lighter_times, oiled, settling_times};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::runaway::{Drag, Runaway};
use geneva_dynamics::timer::{Accelerations, Sensitivities};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::{comparable, least_braked, strongest, weakest};
use geneva_ledger::meyer::runs::{Hypothesis, Row};
use geneva_ledger::meyer::terms::MISSING;

/// The numbers of this chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("timer.minutes.friction.least", || Ok(fixed(least(&frictions()?) * DAY / 6000.0, 0))),
    ("timer.minutes.friction.most", || Ok(fixed(most(&frictions()?) * DAY / 6000.0, 0))),
    ("timer.power.least", || Ok(signed(-least(&frictions()?), 2))),
    ("timer.power.most", || Ok(signed(-most(&frictions()?), 2))),
    ("timer.minutes.torque", || Ok(fixed(Sensitivities::new(&parameters(example()?)?)?.torque * DAY / 6000.0, 1))),
    ("timer.two-thirds", || Ok(fixed(HOURS * (1.0 - (2.0_f64 / 3.0).sqrt()), 1))),
    ("timer.brass.castor", || Ok(fixed(STEEL_ON_BRASS[0].0, 2))),
    ("timer.brass.mineral", || Ok(fixed(STEEL_ON_BRASS[1].0, 2))),
    ("timer.brass.dry", || Ok(fixed(STEEL_ON_BRASS[2].0, 2))),
    ("timer.brass.static", || Ok(fixed(CLEAN_AND_DRY[0], 2))),
    ("timer.brass.sliding", || Ok(fixed(CLEAN_AND_DRY[1], 2))),
    ("timer.friction.least", || Ok(fixed(least(&run_with()), 2))),
    ("timer.friction.most", || Ok(fixed(most(&run_with()), 2))),
    ("timer.dry.least", || Ok(fixed(-most(&hours_from_mineral_oil(2)?), 1))),
    ("timer.dry.most", || Ok(fixed(-least(&hours_from_mineral_oil(2)?), 1))),
    ("timer.castor.least", || Ok(fixed(least(&hours_from_mineral_oil(0)?), 1))),
    ("timer.castor.most", || Ok(fixed(most(&hours_from_mineral_oil(0)?), 1))),
    ("timer.reported.foliot", || Ok(REPORTED[0].to_owned())),
    ("timer.reported.verge", || Ok(REPORTED[1].to_owned())),
    ("timer.reported.pendulum", || Ok(REPORTED[2].to_owned())),
    ("timer.reported.chronometer", || Ok(REPORTED[3].to_owned())),
    ("timer.oil.least", || Ok(fixed(100.0 * (least(&oil()?) - 1.0), 0))),
    ("timer.oil.most", || Ok(per_cent(most(&oil()?)))),
    ("timer.settling.least", || Ok(fixed(1e3 * least(&settling_times()?), 0))),
    ("timer.settling.most", || Ok(format!("{}&nbsp;ms", fixed(1e3 * most(&settling_times()?), 0)))),
    ("timer.lighter.gain", || Ok(format!("{}&nbsp;%", fixed(100.0 * (1.0 - least(&lighter_times()?)), 0)))),
    ("timer.lighter.cost", || Ok(fixed(most(&lighter_times()?), 1))),
    ("timer.friction.six", || friction_a_day(Mechanism::SIX_PIN)),
    ("timer.friction.four", || friction_a_day(Mechanism::FOUR_PIN)),
    ("timer.friction.three", || friction_a_day(Mechanism::THREE_PIN)),
    ("timer.runaway-friction", runaway_friction),
    ("timer.governor", || Ok(fixed(governed(BEYOND), 2))),
    ("timer.pin-bias", pin_bias),
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

/// Static and sliding friction of clean and dry brass on steel, by another table: `physics-fundamentals` in the bibliography.
pub const CLEAN_AND_DRY: [f64; 2] = [0.51, 0.44];

/// The part of a runaway escapement's work that friction takes, where we compare it.
const FRICTION_SHARE: f64 = 0.2;

/// By what factor a governor runs faster than the speed at which its brake begins to touch.
const BEYOND: f64 = 1.1;

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

/// Minutes a day that one per cent more friction costs, from the least to the greatest of a mechanism.
fn friction_a_day(mechanism: Mechanism) -> anyhow::Result<String> {
    let own = weakest().filter(|row| row.mechanism == mechanism);
    over(own.map(|row| Ok(-Sensitivities::new(&parameters(row)?)?.friction * DAY / 6000.0)), 1)
}

/// Minutes a day that one per cent more friction costs a runaway escapement, where friction takes a part of its torque and
/// blows take the rest of its work.
fn runaway_friction() -> anyhow::Result<String> {
    // The steady speed goes as the root of what the friction leaves, whatever the wheel, the pallet and the beat.
    let speed = |friction: f64| {
        let drag = Drag { constant: friction, ..Drag::default() };
        Ok::<_, anyhow::Error>(Runaway::new(1.0, 0.15, 1.0, drag)?.steady(1.0)?.mean_speed)
    };
    let lost = 1.0 - speed(FRICTION_SHARE * (1.0 + PER_CENT))? / speed(FRICTION_SHARE)?;
    Ok(fixed(lost * DAY / 60.0, 1))
}

/// The power of the torque to which a governed speed goes, at a speed over that at which the brake begins to touch.
///
/// The brake presses with what the centrifugal force has beyond the springs, so its torque is proportional to ω² − ω₀².
/// Where it takes all the torque K, d ln ω / d ln K = (1 − ω₀²/ω²)/2.
fn governed(beyond: f64) -> f64 {
    (1.0 - 1.0 / (beyond * beyond)) / 2.0
}

/// The pin that a measurement leaves out, in crank radii.
const LEFT_OUT: f64 = 0.1;

/// By what part of itself the friction is found too small from the mean speed, if the pin's radius is left out: from the
/// least to the greatest of the mechanisms.
fn pin_bias() -> anyhow::Result<String> {
    let of = |mechanism| {
        let own = parameters(rows::weakest(comparable(mechanism))?)?;
        let speed = |friction: f64| {
            let of = Parameters::new(own.mechanism(), own.inertias(), own.torque(), friction)?;
            Ok::<_, anyhow::Error>(Engagement::new(&of)?.steady_state()?.mean_speed)
        };
        let measured = effect(mechanism, (LEFT_OUT, 0.0, 0.0))?.mean_speed * speed(own.friction())?;
        let (mut low, mut high) = (own.friction() / 2.0, own.friction());
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if speed(middle)? > measured { low = middle } else { high = middle }
        }
        Ok(100.0 * (1.0 - low / own.friction()))
    };
    Ok(over(Mechanism::ALL.into_iter().map(of), 0)? + "&nbsp;%")
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_governed_speed_follows_the_torque_as_its_power_says() {
        // The brake holds with ω² − 1, so the speed under a torque is the root of one more than it.
        let speed = |torque: f64| (1.0 + torque).sqrt();
        for beyond in [1.01, BEYOND, 2.0] {
            let torque = beyond * beyond - 1.0;
            let slope = libm::log(speed(torque * 1.0001) / speed(torque / 1.0001)) / (2.0 * libm::log(1.0001));
            assert!((slope - governed(beyond)).abs() < 1e-7, "{beyond}: {slope}");
            assert!(slope < 0.5);
        }
    }
}
