//! What somebody with a ruler reads off a run's printed lines.

use super::motion::Run;
use geneva_dynamics::program::{Line, Printout};

impl Run {
    /// From the lines of a run whose driver is put back after `fold` radians: the greatest speed of all, and least speed
    /// and duration of the last whole engagement. None if the run has no two hand-overs.
    pub fn read_off(printout: &Printout, fold: f64) -> Option<Self> {
        let lines = &printout.lines;
        let last = (lines.last()?.turned / fold).floor();
        let (start, end) = (passing(lines, (last - 1.0) * fold)?, passing(lines, last * fold)?);
        let own = lines.iter().filter(|line| line.time >= start && line.time <= end);
        let minimum = own.map(|line| line.speed).fold(f64::INFINITY, f64::min);
        (last >= 2.0).then_some(Self { peak: printout.largest(), minimum, period: end - start })
    }
}

/// When the driver has turned so far: between two lines by the cubic through angles and speeds.
fn passing(lines: &[Line], turned: f64) -> Option<f64> {
    let after = lines.partition_point(|line| line.turned < turned);
    let [a, b] = [lines.get(after.checked_sub(1)?)?, lines.get(after)?];
    let step = b.time - a.time;
    let at = |s: f64| {
        let rest = 1.0 - s;
        rest * rest * ((1.0 + 2.0 * s) * a.turned + s * step * a.speed)
            + s * s * ((1.0 + 2.0 * rest) * b.turned - rest * step * b.speed)
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        *(if at(middle) < turned { &mut low } else { &mut high }) = middle;
    }
    Some(a.time + low * step)
}
