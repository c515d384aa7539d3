//! The definitions of a rise time that the study tries, each anew, over the starts in equal steps of the crank.

use super::contact::ContactModel;
use super::motion::{SpeedAt, SteppedEngagement, SteppedPassage};
use super::rise::{SteppedRise, first_least};
use geneva_case1973::{Column, Hypothesis, Row};

/// What a difference is a part of: the value in question, the average terminal velocity, or a hundred units of the tables.
#[derive(Clone, Copy, PartialEq)]
enum PartOf {
    Value,
    Average,
    Units,
}

const ALL_PARTS: [PartOf; 3] = [PartOf::Value, PartOf::Average, PartOf::Units];
const NOT_OF_THE_AVERAGE: [PartOf; 2] = [PartOf::Value, PartOf::Units];

/// An extreme of an engagement: its speed, and the time from rest.
type TimedSpeed = (f64, f64);

/// One engagement of a start.
struct StartTurn {
    start: f64,
    end: f64,
    entry: f64,
    greatest: TimedSpeed,
    least: TimedSpeed,
}

/// The start of a row, with what it comes to.
struct RowStart {
    turns: Vec<StartTurn>,
    first_least: Option<TimedSpeed>,
    /// Time and speed of the lines that are printed.
    lines: Vec<(f64, f64)>,
    /// Greatest, least, entry and mean speed of the motion that repeats itself.
    steady: [f64; 4],
    /// Peak and minimum as printed.
    printed: [f64; 2],
    reset: f64,
    /// Times until the profile is near: for each part of its own value, of the average and of units.
    profiles: Vec<[Option<f64>; 3]>,
}

impl RowStart {
    fn new(hypothesis: &Hypothesis, row: &Row, parts: &[f64]) -> Option<Self> {
        const NEAR: f64 = 1e-6;
        let engagement = SteppedEngagement::new(ContactModel::of_run(hypothesis, row));
        let rise = SteppedRise::new(&engagement)?;
        let steady = &rise.steady;
        let entry = steady.squares[0].sqrt();
        let reset = engagement.model.reset;
        let extremes = [steady.greatest_speed().speed, steady.least_speed().speed];
        let listing = &row.given.listing;
        let (mut turns, mut lines, mut first, mut is_near) = (Vec::new(), Vec::new(), None, false);
        for (start, passage) in rise.passages() {
            let times = passage.times();
            let end = start + times.last()?;
            let timed = |passage: &SteppedPassage<'_>, at: SpeedAt| (at.speed, start + passage.time_at(at.angle));
            if first.is_none() {
                first = first_least(&passage).map(|at| timed(&passage, at));
            }
            while lines.len() as f64 * listing.interval <= end.min(listing.duration * (1.0 + 1e-12)) {
                let time = lines.len() as f64 * listing.interval;
                lines.push((time, passage.speed_after(&times, time - start)));
            }
            if !is_near {
                let [greatest, least] = [passage.greatest_speed(), passage.least_speed()].map(|at| timed(&passage, at));
                turns.push(StartTurn { start, end, entry: passage.squares[0].sqrt(), greatest, least });
                is_near = (passage.end_square().sqrt() / entry - 1.0).abs() <= NEAR;
            }
            if is_near && end > listing.duration {
                break;
            }
        }
        let average = f64::midpoint(extremes[0], extremes[1]);
        let profile = |part: &f64| {
            let wholes = [None, Some(average), Some(100.0 * Column::Peak.unit())];
            wholes.map(|whole| rise.until_all_within(|steady| part * whole.unwrap_or(steady)))
        };
        Some(Self {
            profiles: parts.iter().map(profile).collect(),
            turns,
            first_least: first,
            lines,
            steady: [extremes[0], extremes[1], entry, reset / steady.times().last()?],
            printed: [Column::Peak, Column::Minimum].map(|column| row.number(column)),
            reset,
        })
    }

    /// The first engagement with a speed near a value.
    fn first_near(&self, value: f64, allowed: f64, speed: impl Fn(&StartTurn) -> f64) -> Option<&StartTurn> {
        self.turns.iter().find(|turn| (speed(turn) - value).abs() <= allowed)
    }

    /// The times by all definitions with a part, by the computed steady speeds or by the printed ones; the first number says whether
    /// the part is one of a velocity.
    fn times(&self, place: usize, part: f64, is_printed: bool) -> Vec<(bool, Option<f64>)> {
        let [peak, minimum] = if is_printed { self.printed } else { [self.steady[0], self.steady[1]] };
        let average = f64::midpoint(peak, minimum);
        let allowed = |of: PartOf, value: f64| match of {
            PartOf::Value => part * value,
            PartOf::Average => part * average,
            PartOf::Units => part * 100.0 * Column::Peak.unit(),
        };
        let until_peak =
            |of| self.first_near(peak, allowed(of, peak), |turn| turn.greatest.0).map(|turn| turn.greatest.1);
        let until_least =
            |of| self.first_near(minimum, allowed(of, minimum), |turn| turn.least.0).map(|turn| turn.least.1);
        let mut times = Vec::new();
        for of in ALL_PARTS {
            let is_of_velocity = of != PartOf::Units;
            let first = self.first_least.filter(|(speed, _)| (speed - minimum).abs() <= allowed(of, minimum));
            let extremes = [first.map(|(_, time)| time), until_peak(of), until_least(of)];
            times.extend([until_peak(of), until_least(of)].map(|time| (is_of_velocity, time)));
            times.push((is_of_velocity, extremes.into_iter().flatten().min_by(f64::total_cmp)));
        }
        for of in NOT_OF_THE_AVERAGE {
            let is_of_velocity = of != PartOf::Units;
            let allowed = allowed(of, average);
            // The start at rest is no minimum.
            let least = |turn: &StartTurn| match self.first_least {
                Some((speed, time)) if turn.start == 0.0 && time < turn.end => speed,
                _ => turn.least.0,
            };
            let by_average = self.first_near(average, allowed, |turn| f64::midpoint(turn.greatest.0, least(turn)));
            times.push((is_of_velocity, by_average.map(|turn| turn.end)));
            let passed = self.lines.iter().find(|(_, speed)| *speed >= average - allowed);
            times.push((is_of_velocity, passed.map(|(time, _)| *time)));
        }
        if !is_printed {
            let [.., entry, mean] = self.steady;
            for (at, of) in ALL_PARTS.into_iter().enumerate() {
                let is_of_velocity = of != PartOf::Units;
                let by_entry = self.first_near(entry, allowed(of, entry), |turn| turn.entry).map(|turn| turn.start);
                let by_mean = self.first_near(mean, allowed(of, mean), |turn| self.reset / (turn.end - turn.start));
                let found =
                    [self.profiles[place][at], by_entry, by_mean.map(|turn| turn.end), by_mean.map(|turn| turn.start)];
                times.extend(found.map(|time| (is_of_velocity, time)));
            }
        }
        times
    }

    /// The times of events that need no part, and of two for which this one may be missing.
    fn events(&self, missing: f64) -> [Option<f64>; 5] {
        let largest = self.lines.iter().map(|(_, speed)| *speed).fold(0.0, f64::max);
        let near_largest = self.lines.iter().find(|(_, speed)| *speed >= (1.0 - missing) * largest);
        let minimum = self.lines.windows(3).find(|lines| {
            let [before, here, after] = [lines[0].1, lines[1].1, lines[2].1];
            here < before && here <= after && (here / self.steady[1] - 1.0).abs() <= missing
        });
        [
            self.first_least.map(|(_, time)| time),
            self.turns.get(1).map(|turn| turn.least.1),
            self.turns.first().map(|turn| turn.greatest.1),
            near_largest.map(|(time, _)| *time),
            minimum.map(|lines| lines[1].0),
        ]
    }
}

/// How many rows the best of all definitions explains, of the runs or of the mechanisms: of all of them, and of those that let this
/// part of a velocity be missing. None if a row has no steady motion.
pub(crate) fn most_explained(rows: &[Row], missing: f64) -> Option<[usize; 2]> {
    let parts = [missing / 2.0, missing, 2.0 * missing, 5.0 * missing];
    let mut most = [0, 0];
    for hypothesis in [Hypothesis::WITHOUT_LAG, Hypothesis::IDEAL] {
        let start = |row| RowStart::new(&hypothesis, row, &parts);
        let starts = rows.iter().map(start).collect::<Option<Vec<_>>>()?;
        // A row's times, definition by definition, in one order for all rows.
        let times = |start: &RowStart| {
            let mut times: Vec<(bool, Option<f64>)> = start.events(missing).map(|time| (false, time)).to_vec();
            for (place, part) in parts.into_iter().enumerate() {
                for is_printed in [false, true] {
                    let own = start.times(place, part, is_printed);
                    times.extend(own.into_iter().map(|(of_velocity, time)| (of_velocity && part == missing, time)));
                }
            }
            times
        };
        let all: Vec<_> = starts.iter().map(times).collect();
        for definition in 0..all.first()?.len() {
            let is_near = |(row, times): &(&Row, &Vec<(bool, Option<f64>)>)| {
                times[definition].1.is_some_and(|time| row.misfit(Column::Rise, time).abs() <= 1.0 + 1e-9)
            };
            let count = rows.iter().zip(&all).filter(is_near).count();
            most[0] = most[0].max(count);
            if all[0][definition].0 {
                most[1] = most[1].max(count);
            }
        }
    }
    Some(most)
}
