//! Of the chapter on the timer's accuracy: seconds a day, powers, oil, accelerations, averages.

use super::kinds::{ANGLE_STEPS, DIFFERENCE, QUADRATURE};
use super::runs::own_reading;
use super::second_routes::contact::ContactModel;
use super::second_routes::motion::SteppedEngagement;
use super::second_routes::rise::SteppedRise;
use super::second_routes::{NEWTON, NEWTON_DIFFERENCE, friction_power, mean_speed, steady, try_halve};
use super::{least, most};
use crate::questions::value;
use crate::rows::{NONE, example, number, number_with, numbers as of_rows, weakest as weakest_of};
use crate::tables::joints::effect;
use crate::tables::timer::{PARTS, lighter, with_torque};
use anyhow::Context;
use geneva_ask::escapement::EscapementQuestion;
use geneva_case1973::rise_times::change;
use geneva_case1973::{Row, rows_with_least_friction, strongest, weakest};
use geneva_documents::meyer::runs::choice::comparable;
use geneva_documents::meyer::runs::table::rows;
use geneva_documents::meyer::terms::MISSING;
use geneva_evidence::{Evidence, Form, GIVEN, Numbers, OwnNumber, RECORD};
use geneva_kinematics::Mechanism;
use geneva_press::book::MakeText;
use std::sync::OnceLock;

/// The numbers of this chapter.
pub fn numbers() -> Vec<OwnNumber> {
    let lost = |id, end: End| {
        OwnNumber::new(id, "{.0}", QUADRATURE, move || Ok(end(&minutes_lost(weakest(rows()))?))).with_second_route(
            "friction makes it no clock",
            NEWTON_DIFFERENCE,
            move || Ok(end(&minutes_lost_by_motion(weakest(rows()))?)),
        )
    };
    let power = |id, end: End| {
        OwnNumber::new(id, "{+.2}", QUADRATURE, move || Ok(end(&of_rows(weakest(rows()), "friction_power")?)))
            .with_second_route("the mean speed tells the friction", NEWTON_DIFFERENCE, move || {
                Ok(end(&collect_numbers(weakest(rows()), |row| friction_power(ContactModel::of_row(row)))?))
            })
    };
    let brass = |id, place: usize| OwnNumber::new(id, "{.2}", GIVEN, move || Ok(STEEL_ON_BRASS[place].0));
    let force = |id, end: End| {
        OwnNumber::new(id, "{.0}", QUADRATURE, move || {
            Ok(end(&of_rows(strongest(rows()), "pin_force_ratio")?.into_iter().map(f64::abs).collect::<Vec<_>>()))
        })
        .with_second_route("the pin bears much more than the spring's force", NEWTON, move || {
            let ratio =
                |row: &Row| Ok(steady(ContactModel::of_row(row), |own| Some(own.greatest_force()))? / row.torque());
            Ok(end(&collect_numbers(strongest(rows()), ratio)?))
        })
    };
    let average = |id, end: End| {
        OwnNumber::new(id, "{.1}", QUADRATURE, move || {
            Ok(end(&collect_numbers(weakest(rows()), |row| {
                Ok(number(row, "mean_of_extremes")? / number(row, "mean_speed")?)
            })?))
        })
        .with_second_route("the mean of the extremes is not the mean speed", NEWTON, move || {
            let ratio = |row| {
                let model = ContactModel::of_row(row);
                Ok(steady(model, |own| Some(own.mean_of_extremes()))? / mean_speed(model)?)
            };
            Ok(end(&collect_numbers(weakest(rows()), ratio)?))
        })
    };
    vec![
        lost("timer.minutes.friction.least", least),
        lost("timer.minutes.friction.most", most),
        power("timer.power.least", most),
        power("timer.power.most", least),
        OwnNumber::new("timer.minutes.torque", "{.1}", QUADRATURE, || {
            Ok(number(example()?, "torque_rate_s_a_day")? / 60.0)
        })
        // Speeds go as the root of the torque.
        .with_second_route("the torque makes it no clock", Evidence::CLOSED_FORM, || Ok(0.01 * 60.0 * HOURS / 2.0)),
        OwnNumber::new(
            "timer.two-thirds",
            "{.1}",
            Evidence::CLOSED_FORM,
            || Ok(HOURS * (1.0 - (2.0_f64 / 3.0).sqrt())),
        )
        .with_second_route("a spring that runs down makes it no clock", NEWTON, || {
            let wound = ContactModel::of_row(example()?);
            let run_down = ContactModel { torque: wound.torque * 2.0 / 3.0, ..wound };
            Ok(HOURS * (1.0 - mean_speed(run_down)? / mean_speed(wound)?))
        }),
        brass("timer.brass.castor", 0),
        brass("timer.brass.mineral", 1),
        brass("timer.brass.dry", 2),
        OwnNumber::new("timer.brass.static", "{.2}", GIVEN, || Ok(CLEAN_AND_DRY[0])),
        OwnNumber::new("timer.brass.sliding", "{.2}", GIVEN, || Ok(CLEAN_AND_DRY[1])),
        OwnNumber::new("timer.friction.least", "{.2}", RECORD, || Ok(least(&run_frictions()))),
        OwnNumber::new("timer.friction.most", "{.2}", RECORD, || Ok(most(&run_frictions()))),
        gain_with_oil("timer.dry.least", "dried oil costs hours", 2, |gains| -most(gains)),
        gain_with_oil("timer.dry.most", "dried oil costs hours", 2, |gains| -least(gains)),
        gain_with_oil("timer.castor.least", "another oil makes it faster", 0, least),
        gain_with_oil("timer.castor.most", "another oil makes it faster", 0, most),
        OwnNumber::count("timer.lighter.factors", || Ok(parts().count())),
        OwnNumber::count("timer.lighter.of", || Ok(weakest(rows()).count())),
        lighter_example("timer.lighter.profile.example", PROFILE),
        lighter_runs("timer.lighter.profile.shorter", "{.0}", PROFILE, count_shortened),
        lighter_runs("timer.lighter.profile.gain", "{.0}&nbsp;%", PROFILE, gain),
        lighter_runs("timer.lighter.profile.cost", "{.1}", PROFILE, cost),
        lighter_example("timer.lighter.average.example", AVERAGE),
        lighter_runs("timer.lighter.average.shorter", "{.0}", AVERAGE, count_shortened),
        lighter_runs("timer.lighter.average.gain", "{.0}&nbsp;%", AVERAGE, gain),
        lighter_runs("timer.lighter.average.cost", "{.1}", AVERAGE, cost),
        friction_a_day("timer.friction.six", Mechanism::SIX_PIN),
        friction_a_day("timer.friction.four", Mechanism::FOUR_PIN),
        friction_a_day("timer.friction.three", Mechanism::THREE_PIN),
        // Friction takes a fifth of its torque.
        OwnNumber::new("timer.runaway-friction", "{.1}", Evidence::CLOSED_FORM, || {
            Ok(-value("runaway --friction-share 0.2", "friction_rate_min_a_day")?)
        })
        .with_second_route("a runaway escapement loses less", DIFFERENCE, || {
            // The speed goes as the root of the torque that friction leaves.
            let speed = |more: f64| (1.0 - 0.2 * (1.0 + more)).sqrt();
            const LITTLE: f64 = 1e-4;
            Ok(0.01 * 60.0 * HOURS * (speed(-LITTLE) - speed(LITTLE)) / (2.0 * LITTLE * speed(0.0)))
        }),
        OwnNumber::new("timer.pin-bias", Form::Range("{.0}", "&nbsp;%"), ANGLE_STEPS, || {
            collect_numbers(Mechanism::ALL, pin_bias)
        })
        .with_second_route(
            "without the pin's radius the friction is found too small",
            NEWTON_DIFFERENCE,
            || collect_numbers(Mechanism::ALL, pin_bias_by_motion),
        ),
        longest_rise("timer.rise.profile", "{.0}", 0, |rise| rise.until_profile(MISSING)),
        longest_rise("timer.rise.average", "{.0}&nbsp;ms", 1, |rise| rise.until_average(MISSING)),
        rise_changes("timer.rise.most", "{.1}&nbsp;%", |changes| 100.0 * most(changes)).with_allowance(0.05),
        rise_changes("timer.rise.runs", "{.0}", |changes| {
            changes.iter().filter(|change| **change > PER_CENT).count() as f64
        }),
        OwnNumber::count("timer.rise.of", || Ok(weakest(rows()).count())),
        force("timer.force.least", least),
        force("timer.force.most", most),
        average("timer.average.least", least),
        average("timer.average.most", most),
    ]
}

/// What is reported of other timekeepers.
pub const WORDS: &[(&str, MakeText)] = &[
    ("timer.example", || Ok(format!("{} in lb", with_torque(example()?).replace("&nbsp;", " ")))),
    ("timer.reported.foliot", || Ok(REPORTED[0].to_owned())),
    ("timer.reported.verge", || Ok(REPORTED[1].to_owned())),
    ("timer.reported.pendulum", || Ok(REPORTED[2].to_owned())),
    ("timer.reported.chronometer", || Ok(REPORTED[3].to_owned())),
];

/// One of the ends of some numbers, or what else is made of them.
type End = fn(&[f64]) -> f64;

/// A number of each of some rows or mechanisms.
fn collect_numbers<T, U>(all: impl IntoIterator<Item = T>, of: impl Fn(T) -> Numbers<U>) -> Numbers<Vec<U>> {
    all.into_iter().map(of).collect()
}

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
fn run_frictions() -> Vec<f64> {
    weakest(rows()).map(Row::friction).collect()
}

/// A row of a mechanism with the weakest spring and the least friction.
fn row_of(mechanism: Mechanism) -> anyhow::Result<&'static Row> {
    weakest_of(rows_with_least_friction(rows(), mechanism))
}

/// The hours that each mechanism, set right with mineral oil, gains in a day with another of the frictions of steel on brass.
fn gain_with_oil(id: &'static str, conclusion: &'static str, other: usize, end: End) -> OwnNumber {
    let [friction, set] = [other, 1].map(|place| STEEL_ON_BRASS[place].0);
    OwnNumber::new(id, "{.1}", QUADRATURE, move || {
        let gain = |mechanism| {
            let change = |question: &mut EscapementQuestion| {
                (question.friction, question.further.set_friction) = (friction, Some(set));
            };
            Ok(number_with(row_of(mechanism)?, change, "gain_h_a_day")?)
        };
        Ok(end(&collect_numbers(Mechanism::ALL, gain)?))
    })
    .with_second_route(conclusion, NEWTON_DIFFERENCE, move || {
        let gain = |mechanism| {
            let model = ContactModel::of_row(row_of(mechanism)?);
            let with = |friction| mean_speed(ContactModel { friction, ..model });
            Ok(HOURS * (with(friction)? / with(set)? - 1.0))
        };
        Ok(end(&collect_numbers(Mechanism::ALL, gain)?))
    })
}

/// Minutes a day that one per cent more friction costs each of these rows.
fn minutes_lost<'a>(rows: impl Iterator<Item = &'a Row>) -> Numbers {
    Ok(of_rows(rows, "friction_rate_s_a_day")?.iter().map(|rate| -rate / 60.0).collect())
}

/// Minutes a day that one per cent more friction costs each of these rows, from two motions.
fn minutes_lost_by_motion<'a>(rows: impl Iterator<Item = &'a Row>) -> Numbers {
    collect_numbers(rows, |row| Ok(-0.01 * 60.0 * HOURS * friction_power(ContactModel::of_row(row))?))
}

/// Minutes a day that one per cent more friction costs the rows of a mechanism.
fn friction_a_day(id: &'static str, mechanism: Mechanism) -> OwnNumber {
    let own = move || weakest(rows()).filter(move |row| row.mechanism == mechanism);
    OwnNumber::new(id, Form::Range("{.1}", ""), QUADRATURE, move || minutes_lost(own())).with_second_route(
        "friction makes it no clock",
        NEWTON_DIFFERENCE,
        move || minutes_lost_by_motion(own()),
    )
}

/// A rise time by one of the measures of the thesis: its key, and its place among the times by motion.
type Measure = (&'static str, usize);
const PROFILE: Measure = ("profile_rise_time", 0);
const AVERAGE: Measure = ("average_rise_time", 1);

/// Steps of equal factors from each follower of the figure to the next.
const BETWEEN: usize = 8;

/// How many times lighter the followers are with which the chapter compares those of the runs.
fn parts() -> impl Iterator<Item = f64> {
    // The eighth root of two.
    let factor = 2.0_f64.sqrt().sqrt().sqrt();
    std::iter::successors(Some(factor), move |part| Some(part * factor)).take(BETWEEN * (PARTS.len() - 1))
}

/// The rise times by both measures with the follower as run and with each of the lighter ones, from the motion; worked out once.
fn lighter_by_motion(row: &Row) -> Numbers<Vec<[f64; 2]>> {
    // With light followers the motion is smooth, and a start takes many engagements.
    const STEPS: u32 = 240;
    let own = ContactModel::of_row(row);
    collect_numbers(std::iter::once(1.0).chain(parts()), |part| {
        let [driver, follower] = own.inertias;
        let model = ContactModel { inertias: [driver, follower / part], ..own };
        let engagement = SteppedEngagement::in_steps(model, STEPS);
        let times = || {
            let rise = SteppedRise::new(&engagement)?;
            Some([rise.until_profile(MISSING)?, rise.until_average(MISSING)?])
        };
        Ok(times().ok_or(NONE)?)
    })
}

/// The rise times from the motion, for every mechanism and friction.
fn lighter_runs_by_motion() -> Numbers<&'static [Vec<[f64; 2]>]> {
    static TIMES: OnceLock<Option<Vec<Vec<[f64; 2]>>>> = OnceLock::new();
    Ok(TIMES.get_or_init(|| collect_numbers(weakest(rows()), lighter_by_motion).ok()).as_deref().ok_or(NONE)?)
}

/// The least and the greatest rise time of the example with the compared followers.
fn lighter_example(id: &'static str, (key, place): Measure) -> OwnNumber {
    let ends = |times: &[f64]| [1e3 * least(times), 1e3 * most(times)];
    OwnNumber::new(id, "{.0} and {.0}&nbsp;ms", QUADRATURE, move || {
        let all = std::iter::once(1.0).chain(parts());
        Ok(ends(&collect_numbers(all, |part| Ok(lighter(example()?, part, key)?))?))
    })
    .with_second_route("a lighter follower changes the rise", NEWTON, move || {
        Ok(ends(&lighter_by_motion(example()?)?.iter().map(|times| times[place]).collect::<Vec<_>>()))
    })
}

/// What a measure makes of the rise times with each of the lighter followers over the one as run, for every mechanism and friction.
fn lighter_runs(
    id: &'static str,
    form: &'static str,
    (key, place): Measure,
    measure: fn(&[Vec<f64>]) -> f64,
) -> OwnNumber {
    OwnNumber::new(id, form, QUADRATURE, move || {
        let of = |row| {
            let own = number(row, key)?;
            collect_numbers(parts(), |part| Ok(lighter(row, part, key)? / own))
        };
        Ok(measure(&collect_numbers(weakest(rows()), of)?))
    })
    .with_second_route("a lighter follower seldom shortens the rise much", NEWTON_DIFFERENCE, move || {
        let over_own = |own: &Vec<[f64; 2]>| own[1..].iter().map(|times| times[place] / own[0][place]).collect();
        Ok(measure(&lighter_runs_by_motion()?.iter().map(over_own).collect::<Vec<_>>()))
    })
}

/// For how many mechanisms and frictions some lighter follower makes the rise shorter.
fn count_shortened(times: &[Vec<f64>]) -> f64 {
    times.iter().filter(|own| least(own) < 1.0).count() as f64
}

/// What a lighter follower saves at best, in per cent.
fn gain(times: &[Vec<f64>]) -> f64 {
    100.0 * (1.0 - least(&times.concat()))
}

/// How many times as long a lighter follower makes the rise at worst.
fn cost(times: &[Vec<f64>]) -> f64 {
    most(&times.concat())
}

/// The pin that a measurement leaves out, in crank radii.
const LEFT_OUT: (f64, f64, f64) = (0.1, 0.0, 0.0);

/// By how many per cent of itself the friction is found too small from the mean speed, if the pin's radius is left out.
fn pin_bias(mechanism: Mechanism) -> Numbers<f64> {
    let of = |key| effect(mechanism, LEFT_OUT, key);
    Ok(100.0 * (1.0 - of("apparent_friction")? / of("friction")?))
}

/// By how many per cent the friction is found too small, from the motion: with how much less friction a thin pin is as fast as the
/// thick one.
fn pin_bias_by_motion(mechanism: Mechanism) -> Numbers<f64> {
    let thin = ContactModel::of_row(weakest_of(comparable(mechanism))?);
    let sought = mean_speed(ContactModel { pin_radius: LEFT_OUT.0, ..thin })?;
    let faster = |part: f64| -> Numbers<bool> {
        Ok(mean_speed(ContactModel { friction: part * thin.friction, ..thin })? > sought)
    };
    let [low, high] = try_halve(30, [0.5, 1.0], faster)?;
    Ok(100.0 * (1.0 - f64::midpoint(low, high)))
}

/// The longest rise of the thesis's runs as the mechanisms are, by a reading of its own definition, in ms.
fn longest_rise(
    id: &'static str,
    form: &'static str,
    reading: usize,
    until: fn(&SteppedRise<'_>) -> Option<f64>,
) -> OwnNumber {
    OwnNumber::new(id, form, QUADRATURE, move || Ok(1e3 * most(&own_reading(reading)?.ideal.times))).with_second_route(
        "it is up to speed at once",
        NEWTON,
        move || Ok(1e3 * most(&collect_numbers(rows(), |row| rise_by_motion(ContactModel::of_row(row), until))?)),
    )
}

/// A rise time from the motion, in units of time.
fn rise_by_motion(model: ContactModel, until: fn(&SteppedRise<'_>) -> Option<f64>) -> Numbers<f64> {
    let engagement = SteppedEngagement::new(model);
    Ok(SteppedRise::new(&engagement).as_ref().and_then(until).ok_or(NONE)?)
}

const PER_CENT: f64 = 0.01;

/// What a measure makes of the greatest relative changes of the rise time, until the velocity is the steady one at each angle, by one
/// per cent more or less of friction or of an inertia, for each mechanism and friction.
fn rise_changes(id: &'static str, form: &'static str, measure: End) -> OwnNumber {
    OwnNumber::new(id, form, QUADRATURE, move || {
        Ok(measure(&collect_numbers(weakest(rows()), |row| Ok(change(row, MISSING, PER_CENT).context(NONE)?))?))
    })
    .with_second_route("the rise hardly depends on friction and inertias", NEWTON_DIFFERENCE, move || {
        Ok(measure(&collect_numbers(weakest(rows()), |row| change_by_motion(ContactModel::of_row(row)))?))
    })
}

/// The greatest relative change of the rise time, from the motion.
fn change_by_motion(own: ContactModel) -> Numbers<f64> {
    let until = |model| rise_by_motion(model, |rise| rise.until_profile(MISSING));
    let before = until(own)?;
    let ([driver, follower], friction) = (own.inertias, own.friction);
    let changed = [1.0 + PER_CENT, 1.0 - PER_CENT].into_iter().flat_map(|times| {
        [
            ContactModel { friction: friction * times, ..own },
            ContactModel { inertias: [driver * times, follower], ..own },
            ContactModel { inertias: [driver, follower * times], ..own },
        ]
    });
    Ok(most(&collect_numbers(changed, |model| Ok((until(model)? / before - 1.0).abs()))?))
}
