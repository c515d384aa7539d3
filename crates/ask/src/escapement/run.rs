//! The run from rest, a line for each time.

use super::{EscapementDesign, SETTLED};
use crate::number_format::{as_typed, rounded};
use crate::{DataRow, Error};
use geneva_dynamics::DynamicsError as Motion;
use geneva_dynamics::steady::{Engagement, MOST_PRINTED, PrintedLine};

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
fn row(printed: &PrintedLine) -> DataRow {
    DataRow(vec![
        ("time", rounded(printed.time).into()),
        ("engagement", printed.engagement.into()),
        ("turned_deg", printed.turned.to_degrees().into()),
        ("angle_deg", printed.angle.to_degrees().into()),
        ("speed", printed.speed.into()),
        ("acceleration", printed.acceleration.into()),
        ("follower_speed", printed.follower_speed.into()),
    ])
}

impl EscapementDesign {
    /// The run from rest, a row for each time: so long, with so much time between the rows, in the unit of time of torque and
    /// inertias. What is missing follows from the rise.
    ///
    /// # Errors
    ///
    /// An interval that is longer than the run, and a run of too many rows or engagements.
    pub fn run(&self, duration: Option<f64>, interval: Option<f64>) -> Result<Vec<DataRow>, Error> {
        let engagement = &self.engagement;
        let (duration, interval) = match (duration, interval) {
            (Some(duration), Some(interval)) => (duration, interval),
            (duration, interval) => {
                let usual = usual(engagement)?;
                let duration = duration.unwrap_or(usual.duration);
                let round = || round((usual.engagement.min(duration) / LINES).max(duration / MOST_LINES));
                (duration, interval.unwrap_or_else(round))
            }
        };
        if interval > duration {
            return Err(refused!(
                "--interval {} is longer than the run, which lasts {}; give a shorter interval, or a longer --duration",
                as_typed(interval),
                as_typed(duration)
            ));
        }
        let lines = engagement.run(interval, duration).map_err(|error| refused(duration, interval, error))?;
        Ok(lines.iter().map(row).collect())
    }
}

/// What is taken where nothing was asked for.
struct Usual {
    /// Of the run.
    duration: f64,
    /// Of its last engagement.
    engagement: f64,
}

fn usual(engagement: &Engagement) -> Result<Usual, Error> {
    let steady = match engagement.steady_state() {
        Ok(steady) => Some(steady),
        Err(Motion::NoTerminalSpeed { .. }) => None,
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
fn refused(duration: f64, interval: f64, error: Motion) -> Error {
    match error {
        Motion::TooMany { name, .. } => refused!(
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
