//! Of the chapter on the timer's accuracy: seconds a day, powers, oil, accelerations, averages.

use super::runs::own_reading;
use super::{Number, least, most, over};
use crate::asked::value;
use crate::numbers::{fixed, signed};
use crate::rows::{NONE, example, number, number_with, numbers, weakest as weakest_of};
use crate::tables::joints::effect;
use crate::tables::timer::{PARTS, lighter};
use anyhow::Context;
use geneva_case1973::rise_times::change;
use geneva_case1973::{Row, rows_with_least_friction, strongest, weakest};
use geneva_documents::meyer::runs::table::rows;
use geneva_documents::meyer::terms::MISSING;
use geneva_kinematics::Mechanism;

/// The numbers of this chapter.
pub const NUMBERS: &[(&str, Number)] = &[
    ("timer.minutes.friction.least", || Ok(fixed(least(&lost()?), 0))),
    ("timer.minutes.friction.most", || Ok(fixed(most(&lost()?), 0))),
    ("timer.power.least", || Ok(signed(most(&numbers(weakest(rows()), "friction_power")?), 2))),
    ("timer.power.most", || Ok(signed(least(&numbers(weakest(rows()), "friction_power")?), 2))),
    ("timer.minutes.torque", || Ok(fixed(number(example()?, "torque_rate_s_a_day")? / 60.0, 1))),
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
    ("timer.lighter.factors", || Ok(parts().count().to_string())),
    ("timer.lighter.of", || Ok(weakest(rows()).count().to_string())),
    ("timer.lighter.profile.example", || example_times(PROFILE)),
    ("timer.lighter.profile.shorter", || shortened(PROFILE)),
    ("timer.lighter.profile.gain", || gain(PROFILE)),
    ("timer.lighter.profile.cost", || cost(PROFILE)),
    ("timer.lighter.average.example", || example_times(AVERAGE)),
    ("timer.lighter.average.shorter", || shortened(AVERAGE)),
    ("timer.lighter.average.gain", || gain(AVERAGE)),
    ("timer.lighter.average.cost", || cost(AVERAGE)),
    ("timer.friction.six", || friction_a_day(Mechanism::SIX_PIN)),
    ("timer.friction.four", || friction_a_day(Mechanism::FOUR_PIN)),
    ("timer.friction.three", || friction_a_day(Mechanism::THREE_PIN)),
    // Friction takes a fifth of its torque.
    ("timer.runaway-friction", || Ok(fixed(-value("runaway --friction-share 0.2", "friction_rate_min_a_day")?, 1))),
    ("timer.pin-bias", pin_bias),
    ("timer.rise.profile", || Ok(fixed(longest_rise(0)?, 0))),
    ("timer.rise.average", || Ok(format!("{}&nbsp;ms", fixed(longest_rise(1)?, 0)))),
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
    weakest(rows()).map(Row::friction).collect()
}

/// The hours that each mechanism, set right with mineral oil, gains in a day with another of the frictions of steel on brass.
fn hours_from_mineral_oil(other: usize) -> anyhow::Result<Vec<f64>> {
    let frictions = format!("--friction {} --set-friction {}", STEEL_ON_BRASS[other].0, STEEL_ON_BRASS[1].0);
    let of =
        |mechanism| number_with(weakest_of(rows_with_least_friction(rows(), mechanism))?, &frictions, "gain_h_a_day");
    Mechanism::ALL.into_iter().map(of).collect()
}

/// Minutes a day that one per cent more friction costs each of these rows.
fn lost_by<'a>(rows: impl Iterator<Item = &'a Row>) -> anyhow::Result<Vec<f64>> {
    Ok(numbers(rows, "friction_rate_s_a_day")?.iter().map(|rate| -rate / 60.0).collect())
}

/// Minutes a day that one per cent more friction costs, of each mechanism and friction.
fn lost() -> anyhow::Result<Vec<f64>> {
    lost_by(weakest(rows()))
}

/// Minutes a day that one per cent more friction costs, from the least to the greatest of a mechanism.
fn friction_a_day(mechanism: Mechanism) -> anyhow::Result<String> {
    over(&lost_by(weakest(rows()).filter(|row| row.mechanism == mechanism))?, 1)
}

/// The rise times by the two measures of the thesis.
const PROFILE: &str = "profile_rise_time";
const AVERAGE: &str = "average_rise_time";

/// Steps of equal factors from each follower of the figure to the next.
const BETWEEN: usize = 8;

/// How many times lighter the followers are with which the chapter compares those of the runs.
fn parts() -> impl Iterator<Item = f64> {
    // The eighth root of two.
    let factor = 2.0_f64.sqrt().sqrt().sqrt();
    std::iter::successors(Some(factor), move |part| Some(part * factor)).take(BETWEEN * (PARTS.len() - 1))
}

/// The least and the greatest rise time of the example with the compared followers.
fn example_times(measure: &str) -> anyhow::Result<String> {
    let all = std::iter::once(1.0).chain(parts());
    let times = all.map(|part| lighter(example()?, part, measure)).collect::<anyhow::Result<Vec<f64>>>()?;
    Ok(format!("{} and {}&nbsp;ms", fixed(1e3 * least(&times), 0), fixed(1e3 * most(&times), 0)))
}

/// The rise time with each of the lighter followers over the one as run, for every mechanism and friction.
fn lighter_times(measure: &str) -> anyhow::Result<Vec<Vec<f64>>> {
    let of = |row| {
        let own = number(row, measure)?;
        parts().map(|part| Ok(lighter(row, part, measure)? / own)).collect()
    };
    weakest(rows()).map(of).collect()
}

/// For how many mechanisms and frictions some lighter follower makes the rise shorter.
fn shortened(measure: &str) -> anyhow::Result<String> {
    Ok(lighter_times(measure)?.iter().filter(|own| least(own) < 1.0).count().to_string())
}

/// What a lighter follower saves at best.
fn gain(measure: &str) -> anyhow::Result<String> {
    Ok(format!("{}&nbsp;%", fixed(100.0 * (1.0 - least(&lighter_times(measure)?.concat())), 0)))
}

/// How many times as long a lighter follower makes the rise at worst.
fn cost(measure: &str) -> anyhow::Result<String> {
    Ok(fixed(most(&lighter_times(measure)?.concat()), 1))
}

/// The pin that a measurement leaves out, in crank radii.
const LEFT_OUT: (f64, f64, f64) = (0.1, 0.0, 0.0);

/// By what part of itself the friction is found too small from the mean speed, if the pin's radius is left out: from the
/// least to the greatest of the mechanisms.
fn pin_bias() -> anyhow::Result<String> {
    let of = |mechanism| {
        Ok(100.0 * (1.0 - effect(mechanism, LEFT_OUT, "apparent_friction")? / effect(mechanism, LEFT_OUT, "friction")?))
    };
    let all = Mechanism::ALL.into_iter().map(of).collect::<anyhow::Result<Vec<f64>>>()?;
    Ok(over(&all, 0)? + "&nbsp;%")
}

/// The longest rise of the thesis's runs as the mechanisms are, by a reading of its own definition, in ms.
fn longest_rise(reading: usize) -> anyhow::Result<f64> {
    Ok(1e3 * most(&own_reading(reading)?.ideal.times))
}

const PER_CENT: f64 = 0.01;

/// The greatest relative change of the rise time, until the velocity is the steady one at each angle, by one per cent more
/// or less of friction or of an inertia, for each mechanism and friction.
fn rise_changes() -> anyhow::Result<Vec<f64>> {
    weakest(rows()).map(|row| change(row, MISSING, PER_CENT).context(NONE)).collect()
}

/// The greatest force on the pin over that of the spring at the crank radius.
fn forces() -> anyhow::Result<Vec<f64>> {
    Ok(numbers(strongest(rows()), "pin_force_ratio")?.into_iter().map(f64::abs).collect())
}

/// The mean of peak and minimum over the mean speed.
fn averages() -> anyhow::Result<Vec<f64>> {
    weakest(rows()).map(|row| Ok(number(row, "mean_of_extremes")? / number(row, "mean_speed")?)).collect()
}
