//! A run from rest, on a print grid.

use super::clock::Clock;
use super::engagement::Engagement;
use super::error::SteadyError;
use super::passage::Passage;
use super::walk::{Phase, Piece};

/// One printed line of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Printed {
    /// Units of time from the start.
    pub time: f64,
    /// Angle in radians through which the driver has turned.
    pub turned: f64,
    /// Crank angle in radians from the line of centres.
    pub angle: f64,
    /// Driver's speed θ'.
    pub speed: f64,
    /// Driver's acceleration θ''.
    pub acceleration: f64,
    /// Follower's speed φ'.
    pub follower_speed: f64,
    /// Number of the engagement, from 0.
    pub engagement: usize,
}

/// Most lines of a run.
pub const MOST_PRINTED: usize = 1_000_000;

impl Engagement {
    /// A run from rest, at entry, printed at each multiple of an interval up to a duration, both in units of time.
    ///
    /// The exact motion: no step of time is made, so that nothing but the rounding depends on the interval.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::new`]; [`SteadyError::Time`] for an interval or duration that is not positive and finite; [`SteadyError::TooMany`] for
    /// more than [`MOST_PRINTED`] lines or engagements.
    pub fn run(&self, interval: f64, duration: f64) -> Result<Vec<Printed>, SteadyError> {
        for (name, asked) in [("print interval", interval), ("duration", duration)] {
            if !(asked > 0.0 && asked.is_finite()) {
                return Err(SteadyError::Time { name, asked });
            }
        }
        // A duration within rounding of a multiple is one.
        let count = duration / interval * (1.0 + 1e-12);
        if count >= MOST_PRINTED as f64 {
            return Err(SteadyError::TooMany { name: "printed lines", limit: MOST_PRINTED });
        }
        let last = count.floor() as usize;
        // Lines fall between the points of the rule.
        let engagement = self.refined()?;
        let mut lines = Vec::with_capacity(last + 1);
        let (mut square, mut start) = (0.0, 0.0);
        for number in 0..MOST_PRINTED {
            let passage = engagement.pass(square);
            start = passage.print(&mut lines, Grid { interval, last, number }, start);
            if lines.len() > last {
                return Ok(lines);
            }
            square = passage.end;
        }
        Err(SteadyError::TooMany { name: "engagements", limit: MOST_PRINTED })
    }
}

/// Where lines are printed: at multiples of an interval up to the last, in the engagement of a number.
pub(super) struct Grid {
    pub interval: f64,
    pub last: usize,
    pub number: usize,
}

impl Passage<'_> {
    /// Adds the lines that fall within the passage, which begins at `start`, and gives its end, both in units of 1/√E.
    pub(super) fn print(&self, lines: &mut Vec<Printed>, grid: Grid, mut start: f64) -> f64 {
        for piece in &self.pieces {
            let clock = piece.clock(self.engagement.rule);
            let end = start + clock.whole;
            while lines.len() <= grid.last {
                let time = lines.len() as f64 * grid.interval;
                if time * self.engagement.unit >= end {
                    break;
                }
                lines.push(self.line(piece, &clock, time * self.engagement.unit - start, time, grid.number));
            }
            start = end;
        }
        start
    }

    /// The line at the end of the passage.
    pub(super) fn last_line(&self, time: f64, number: usize) -> Option<Printed> {
        let piece = self.pieces.last()?;
        let clock = piece.clock(self.engagement.rule);
        Some(self.line(piece, &clock, clock.whole, time, number))
    }

    fn line(&self, piece: &Piece<'_>, clock: &Clock, since: f64, time: f64, number: usize) -> Printed {
        let engagement = self.engagement;
        let backward = piece.phase == Phase::Approach;
        let s = clock.at(engagement.rule, backward, since.max(0.0));
        let w = piece.points.at(s);
        let square = piece.square_between(engagement.rule, s);
        let (angle, place) = (engagement.circle.angle(w), engagement.circle.place(w));
        let angle = if backward { -angle } else { angle };
        let slide = if backward { -place.slide } else { place.slide };
        let sigma = if piece.phase == Phase::Driving { engagement.friction } else { -engagement.friction };
        let both = place.lead + sigma * slide;
        let force = 1.0 + both * slide * place.turning() * square;
        let acceleration = force / (engagement.inertia + place.lead * both);
        let speed = self.speed(square);
        let half = engagement.parameters().mechanism().engagement_half_angle();
        Printed {
            time,
            turned: engagement.fold() * number as f64 + (angle + half),
            angle,
            speed,
            acceleration: acceleration * (engagement.unit * engagement.unit),
            follower_speed: place.lead * speed,
            engagement: number,
        }
    }
}
