//! What a run gives, and how a reader with a ruler takes it from the printed lines.

use crate::program::Printout;
use crate::{Column, EXPLAINED};
use geneva_dynamics::steady::PrintedLine;
use geneva_kinematics::bisection::bisect_times;

/// What a run gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// Greatest speed of the driver, in radians per unit of time.
    pub peak: f64,
    /// Least speed of the driver in the steady cycle, in radians per unit of time.
    pub minimum: f64,
    /// Time from one engagement to the next in the steady cycle, in units of time.
    pub period: f64,
    /// When the driver is first at its slowest, in units of time from the start: the rise time, as the text has it.
    pub first_minimum: f64,
}

impl Run {
    /// The number of a column, in the column's own unit; not a number for a column that a run does not give.
    pub fn number(&self, column: Column) -> f64 {
        match column {
            Column::Peak => self.peak,
            Column::Minimum => self.minimum,
            Column::Period => self.period,
            Column::Rise => self.first_minimum,
            Column::Friction | Column::Torque => f64::NAN,
        }
    }

    /// Its peak, minimum and period, each in its own unit: the numbers of [`EXPLAINED`].
    pub fn results(&self) -> [f64; 3] {
        EXPLAINED.map(|column| self.number(column))
    }

    /// Reads a run off its lines: the greatest speed of all lines, least speed (between the lines by a parabola) and
    /// duration of the last whole engagement, and the first minimum.
    ///
    /// The driver's angle is reset after `reset` radians. None if the run has no two hand-overs.
    pub fn read_off(printout: &Printout, reset: f64) -> Option<Self> {
        let lines = &printout.lines;
        let last = (lines.last()?.turned / reset).floor();
        let (start, end) = (passing(lines, (last - 1.0) * reset)?, passing(lines, last * reset)?);
        let own: Vec<f64> =
            lines.iter().filter(|line| line.time >= start && line.time <= end).map(|line| line.speed).collect();
        // At its lowest the speed is smooth.
        let minimum = own.windows(3).map(|w| lowest(w[0], w[1], w[2])).fold(f64::INFINITY, f64::min);
        let first_minimum = slowest(lines)?;
        (last >= 2.0).then(|| Self { peak: printout.largest(), minimum, period: end - start, first_minimum })
    }
}

/// The lowest value of the parabola through three neighbours; the middle one if it is not the lowest of the three.
fn lowest(before: f64, middle: f64, next: f64) -> f64 {
    let bend = before - 2.0 * middle + next;
    if middle < before && middle < next { middle - (next - before) * (next - before) / (8.0 * bend) } else { middle }
}

/// When the driver is first at its slowest: where the printed acceleration changes to plus, as if it were straight
/// between two lines.
fn slowest(lines: &[PrintedLine]) -> Option<f64> {
    let pair = lines.windows(2).find(|w| w[0].acceleration < 0.0 && w[1].acceleration >= 0.0)?;
    let part = pair[0].acceleration / (pair[0].acceleration - pair[1].acceleration);
    Some(pair[0].time + part * (pair[1].time - pair[0].time))
}

/// When the driver has turned so far: between two lines by the cubic through angles and speeds.
fn passing(lines: &[PrintedLine], turned: f64) -> Option<f64> {
    let after = lines.partition_point(|line| line.turned < turned);
    let [a, b] = [lines.get(after.checked_sub(1)?)?, lines.get(after)?];
    let step = b.time - a.time;
    let at = |s: f64| {
        let rest = 1.0 - s;
        rest * rest * ((1.0 + 2.0 * s) * a.turned + s * step * a.speed)
            + s * s * ((1.0 + 2.0 * rest) * b.turned - rest * step * b.speed)
    };
    let [part, _] = bisect_times(50, [0.0, 1.0], |part| at(part) < turned);
    Some(a.time + part * step)
}
