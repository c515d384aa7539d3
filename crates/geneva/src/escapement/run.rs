//! The run from rest, a line for each time.

use super::SETTLED;
use crate::fields::{self, Row};
use crate::typed::{as_typed, rounded};
use anyhow::{anyhow, ensure};
use geneva_dynamics::Error;
use geneva_dynamics::steady::{Engagement, MOST_PRINTED, Printed};

/// Periods that follow the rise.
const PERIODS: f64 = 3.0;
/// Most engagements of a run whose duration was not asked for.
const MOST_ENGAGEMENTS: usize = 100;
/// Engagements without a steady state.
const WITHOUT_END: usize = 10;
/// Lines in an engagement, at least, and lines in a run, at most, if the interval was not asked for.
const LINES: f64 = 100.0;
const MOST_LINES: f64 = 20_000.0;

/// One line.
fn row(printed: &Printed) -> Row {
    Row(vec![
        ("time", rounded(printed.time).into()),
        ("engagement", printed.engagement.into()),
        ("turned_deg", printed.turned.to_degrees().into()),
        ("angle_deg", printed.angle.to_degrees().into()),
        ("speed", printed.speed.into()),
        ("acceleration", printed.acceleration.into()),
        ("follower_speed", printed.follower_speed.into()),
    ])
}

/// A header and the lines.
pub fn csv(engagement: &Engagement, duration: Option<f64>, interval: Option<f64>) -> anyhow::Result<String> {
    let (duration, interval) = match (duration, interval) {
        (Some(duration), Some(interval)) => (duration, interval),
        (duration, interval) => {
            let usual = usual(engagement)?;
            let duration = duration.unwrap_or(usual.duration);
            (
                duration,
                interval.unwrap_or_else(|| round((usual.engagement.min(duration) / LINES).max(duration / MOST_LINES))),
            )
        }
    };
    ensure!(
        interval <= duration,
        "--interval {} is longer than the run, which lasts {}; give a shorter interval, or a longer --duration",
        as_typed(interval),
        as_typed(duration)
    );
    let lines = engagement.run(interval, duration).map_err(|error| refused(duration, interval, error))?;
    fields::csv(lines.first().map(row).as_ref(), lines.iter().map(row))
}

/// What is taken where nothing was asked for.
struct Usual {
    /// Of the run.
    duration: f64,
    /// Of its last engagement.
    engagement: f64,
}

fn usual(engagement: &Engagement) -> anyhow::Result<Usual> {
    let steady = match engagement.steady_state() {
        Ok(steady) => Some(steady),
        Err(Error::NoTerminalSpeed { .. }) => None,
        Err(error) => return Err(error.into()),
    };
    let (most, enough) = match steady {
        Some(steady) => (MOST_ENGAGEMENTS, steady.entry_speed * (1.0 - SETTLED)),
        None => (WITHOUT_END, f64::INFINITY),
    };
    let mut usual = Usual { duration: 0.0, engagement: 0.0 };
    let mut speed = 0.0;
    for _ in 0..most {
        let passage = engagement.passage(speed)?;
        usual.engagement = passage.duration();
        usual.duration += usual.engagement;
        speed = passage.end_speed();
        if speed >= enough {
            usual.duration += PERIODS * steady.map_or(0.0, |steady| steady.period);
            break;
        }
    }
    Ok(usual)
}

/// The greatest of 1, 2 and 5 times a power of ten that is not above a time, above zero.
fn round(time: f64) -> f64 {
    let power = format!("{time:e}").split_once('e').map_or_else(String::new, |(_, power)| power.to_owned());
    let candidates = [5, 2, 1].map(|digit| format!("{digit}e{power}").parse().unwrap_or(time));
    candidates.into_iter().find(|candidate| *candidate <= time).unwrap_or(time)
}

/// The library's refusal of a run, in terms of the options.
fn refused(duration: f64, interval: f64, error: Error) -> anyhow::Error {
    match error {
        Error::TooMany { name, .. } => anyhow!(
            "--duration {} with --interval {} gives more than {MOST_PRINTED} {name}; give a shorter duration or a longer interval",
            as_typed(duration),
            as_typed(interval)
        ),
        other => other.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::round;

    #[test]
    fn an_interval_is_a_round_number() {
        assert_eq!([0.7, 1.0, 19.0, 4e-7, 9.99e20].map(round), [0.5, 1.0, 10.0, 2e-7, 5e20]);
    }
}
