//! When the driver is where: the time of a passage up to a place, and the place at a time.

use super::rule::{Row, Rule, dot};
use super::stretch::Spread;
use super::walk::{Phase, Piece};

impl Piece<'_> {
    /// w at the start of the piece.
    pub fn start(&self) -> f64 {
        if self.phase == Phase::Approach { self.points.high } else { self.points.low }
    }

    /// w at its end.
    pub fn end(&self) -> f64 {
        if self.phase == Phase::Approach { self.points.low } else { self.points.high }
    }

    /// u at s between −1 and 1.
    pub fn square_between(&self, rule: &Rule, s: f64) -> f64 {
        let (mut squares, shares) = (self.squares, rule.shares(s));
        // From rest u starts as the square of 1 − s: what is to be interpolated is the factor, which has no zero.
        let scale = match self.points.spread {
            Spread::Even => 1.0,
            Spread::FromRest => {
                for (square, point) in squares.iter_mut().zip(&rule.points) {
                    *square /= (1.0 - point) * (1.0 - point);
                }
                (1.0 - s) * (1.0 - s)
            }
        };
        (scale * dot(&shares, &squares)).max(0.0)
    }

    /// Times from the start of the piece at its points, in units of 1/√E, with the whole and the rates.
    pub fn clock(&self, rule: &Rule) -> Clock {
        let rates = self.points.rates(&self.squares);
        let (mut times, whole) = rule.cumulative(&rates);
        if self.phase == Phase::Approach {
            times = times.map(|time| whole - time);
        }
        Clock { times, rates, whole }
    }
}

/// Times over a piece.
#[derive(Clone, Debug)]
pub(super) struct Clock {
    times: Row,
    rates: Row,
    /// How long the piece takes.
    pub whole: f64,
}

impl Clock {
    /// s at a time from 0 to the whole.
    pub fn at(&self, rule: &Rule, backward: bool, time: f64) -> f64 {
        let (mut low, mut high) = (-1.0, 1.0);
        let sign = if backward { -1.0 } else { 1.0 };
        let mut s = sign * (2.0 * time / self.whole - 1.0);
        for _ in 0..60 {
            let shares = rule.shares(s);
            let late = sign * (dot(&shares, &self.times) - time);
            if late > 0.0 {
                high = s;
            } else {
                low = s;
            }
            let next = s - late / dot(&shares, &self.rates);
            let next = if next >= low && next <= high { next } else { low + (high - low) / 2.0 };
            let moved = libm::fabs(next - s);
            s = next;
            if moved <= 1e-9 {
                break;
            }
        }
        s
    }
}
