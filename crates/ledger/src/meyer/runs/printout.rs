//! What somebody with a ruler reads off a run's printed lines.

use super::motion::Run;
use super::steps;
use geneva_dynamics::program::{Line, Printout};

impl Run {
    /// From the lines of a run whose driver's angle is reset after `reset` radians: the greatest speed of all, and the
    /// least speed and the duration of the last whole engagement. None if the run has no two hand-overs.
    pub fn read_off(printout: &Printout, reset: f64) -> Option<Self> {
        let lines = &printout.lines;
        let last = (lines.last()?.turned / reset).floor();
        let (start, end) = (passing(lines, (last - 1.0) * reset)?, passing(lines, last * reset)?);
        let own: Vec<f64> =
            lines.iter().filter(|line| line.time >= start && line.time <= end).map(|line| line.speed).collect();
        // Between the lines by a parabola: at its lowest the speed is smooth.
        let minimum = own.windows(3).map(|w| steps::lowest(w[0], w[1], w[2])).fold(f64::INFINITY, f64::min);
        let first_minimum = slowest(lines)?;
        (last >= 2.0).then_some(Self { peak: printout.largest(), minimum, period: end - start, first_minimum })
    }
}

/// When the driver is first at its slowest: where the printed acceleration changes to plus, as if it were straight
/// between two lines.
fn slowest(lines: &[Line]) -> Option<f64> {
    let pair = lines.windows(2).find(|w| w[0].acceleration < 0.0 && w[1].acceleration >= 0.0)?;
    let part = pair[0].acceleration / (pair[0].acceleration - pair[1].acceleration);
    Some(pair[0].time + part * (pair[1].time - pair[0].time))
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

#[cfg(test)]
mod tests {
    use super::super::*;
    use super::*;
    use geneva_dynamics::program::Program;

    #[test]
    fn what_is_read_off_is_what_the_solver_has() {
        for row in [&rows()[0], &rows()[16], &rows()[40]] {
            let [solved, read] =
                [Hypothesis::WITHOUT_LAG.run(row), Hypothesis::WITHOUT_LAG.by_program(row, &motion::usual())]
                    .map(|run| run.expect("a run"));
            assert!((read.peak / solved.peak - 1.0).abs() < 2e-4, "{read:?} {solved:?}");
            // With few engagements the last one is not quite the steady one.
            assert!((read.period / solved.period - 1.0).abs() < 3e-3, "{read:?} {solved:?}");
            assert!((read.minimum / solved.minimum - 1.0).abs() < 5e-3, "{read:?} {solved:?}");
        }
    }

    #[test]
    fn the_time_of_a_hand_over_is_exact_where_the_angle_is_a_cubic() {
        let line = |time: f64| Line {
            time,
            turned: time * time * time + time,
            angle: 0.0,
            speed: 3.0 * time * time + 1.0,
            acceleration: 6.0 * time,
            follower_speed: 0.0,
        };
        let lines: Vec<Line> = (0..5).map(|k| line(f64::from(k) / 2.0)).collect();
        for time in [0.1, 0.7, 1.2, 1.9] {
            let found = passing(&lines, line(time).turned).expect("between two lines");
            assert!((found - time).abs() < 1e-12, "{found} for {time}");
        }
        assert!(passing(&lines, -1.0).is_none() && passing(&lines, 99.0).is_none());
    }

    #[test]
    fn a_run_without_two_hand_overs_has_no_period() {
        let parameters = Hypothesis::WITHOUT_LAG.parameters(&rows()[0]).expect("an escapement");
        let integrator = geneva_mimic::Parameters::new(interval(), 40.0 * interval());
        let program = Program::of(&parameters);
        let short = program.run(&integrator).expect("a run");
        assert!(Run::read_off(&short, program.reset).is_none());
    }
}
