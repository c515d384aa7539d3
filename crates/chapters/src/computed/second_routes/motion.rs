//! The motion of an escapement over its engagements, in equal steps of the crank.
//!
//! The square u of the driver's speed has twice the acceleration for its slope over the angle. A step is the classical one of
//! Runge and Kutta. Where the sliding turns, a step ends.

use super::contact::{ContactModel, Flanks};

/// Steps of an engagement.
const STEPS: u32 = 600;

/// A step: its first angle, its length, and the contact at its start, in its middle and at its end.
struct CrankStep {
    from: f64,
    length: f64,
    flanks: [Flanks; 3],
}

/// An escapement with the steps of its engagement.
pub(crate) struct SteppedEngagement {
    /// The escapement.
    pub model: ContactModel,
    steps: Vec<CrankStep>,
}

/// An engagement as it was gone through: u at the ends of the steps, the first of which is the entry.
pub(crate) struct SteppedPassage<'a> {
    of: &'a SteppedEngagement,
    /// The squares of the speeds, one more than there are steps.
    pub squares: Vec<f64>,
}

/// A speed, and the angle at which the driver has it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpeedAt {
    /// Crank angle from the line of centres, in radians.
    pub angle: f64,
    /// Speed of the driver, in radians per unit of time.
    pub speed: f64,
}

impl SteppedEngagement {
    /// The steps of an escapement's engagement.
    pub(crate) fn new(model: ContactModel) -> Self {
        Self::in_steps(model, STEPS)
    }

    /// About so many steps.
    pub(crate) fn in_steps(model: ContactModel, count: u32) -> Self {
        let (start, end) = (-model.half, model.reset - model.half);
        let turns = model.turns().into_iter().filter(|turn| (start + 1e-9..end - 1e-9).contains(turn));
        let ends: Vec<f64> = std::iter::once(start).chain(turns).chain([end]).collect();
        let mut steps = Vec::new();
        for piece in ends.windows(2) {
            let (from, to) = (piece[0], piece[1]);
            let count = (f64::from(count) * (to - from) / model.reset).ceil().max(2.0);
            let (length, beside) = ((to - from) / count, f64::midpoint(from, to));
            for k in 0..count as u32 {
                let from = from + length * f64::from(k);
                let flanks = [0.0, 0.5, 1.0].map(|part| model.flanks(from + part * length, beside));
                steps.push(CrankStep { from, length, flanks });
            }
        }
        Self { model, steps }
    }

    /// The engagement with this square of the speed at entry.
    pub(crate) fn passage(&self, first: f64) -> SteppedPassage<'_> {
        let mut squares = vec![first];
        let mut square = first;
        for CrankStep { length, flanks: [start, middle, end], .. } in &self.steps {
            let one = start.slope(square);
            let two = middle.slope(square + length / 2.0 * one);
            let three = middle.slope(square + length / 2.0 * two);
            let four = end.slope(square + length * three);
            square += length / 6.0 * (one + 2.0 * (two + three) + four);
            squares.push(square);
        }
        SteppedPassage { of: self, squares }
    }

    /// The engagement that ends as it begins; none if none is found.
    pub(crate) fn steady_passage(&self) -> Option<SteppedPassage<'_>> {
        const TRIALS: u32 = 60;
        let gain = |first: f64| {
            let passage = self.passage(first);
            (passage.end_square() - first, passage)
        };
        let mut tried = (0.0, gain(0.0).0);
        let mut first = tried.1;
        for _ in 0..TRIALS {
            let (more, passage) = gain(first);
            if more.abs() <= 1e-12 * first {
                return Some(passage);
            }
            // What an engagement adds is nearly a straight line in what it begins with.
            let next = first - more * (first - tried.0) / (more - tried.1);
            tried = (first, more);
            first = next;
        }
        None
    }

    /// Part of a small difference of the squares of two speeds that the engagement that repeats itself leaves.
    pub(crate) fn multiplier(&self) -> Option<f64> {
        const PART: f64 = 1e-3;
        let first = self.steady_passage()?.squares[0];
        let [more, less] = [1.0 + PART, 1.0 - PART].map(|times| self.passage(times * first).end_square());
        Some((more - less) / (2.0 * PART * first))
    }

    /// Mean speed of the steady motion: the reset angle over the time that it takes.
    pub(crate) fn mean_speed(&self) -> Option<f64> {
        Some(self.model.reset / self.steady_passage()?.times().last()?)
    }
}

impl SteppedPassage<'_> {
    /// The square of the speed at the end.
    pub(crate) fn end_square(&self) -> f64 {
        self.squares.last().copied().unwrap_or(f64::NAN)
    }

    /// The crank angles at the ends of the steps.
    pub(crate) fn angles(&self) -> Vec<f64> {
        let end = self.of.model.reset - self.of.model.half;
        self.of.steps.iter().map(|step| step.from).chain([end]).collect()
    }

    /// The times at the ends of the steps, from the entry.
    pub(crate) fn times(&self) -> Vec<f64> {
        let mut times = vec![0.0];
        let mut time = 0.0;
        for (step, ends) in self.of.steps.iter().zip(self.squares.windows(2)) {
            time +=
                step.length * mean_slowness(ends, [0, 2].map(|at| step.length * step.flanks[at].slope(ends[at / 2])));
            times.push(time);
        }
        times
    }

    /// The time from the entry at which the driver is at an angle.
    pub(crate) fn time_at(&self, angle: f64) -> f64 {
        let (angles, times) = (self.angles(), self.times());
        let next = angles.partition_point(|known| *known < angle).clamp(1, angles.len() - 1);
        let part = (angle - angles[next - 1]) / (angles[next] - angles[next - 1]);
        times[next - 1] + part * (times[next] - times[next - 1])
    }

    /// The speed at a time from the entry, by the cubic through the speeds and accelerations at the ends of the step.
    pub(crate) fn speed_after(&self, times: &[f64], time: f64) -> f64 {
        let next = times.partition_point(|known| *known < time).clamp(1, times.len() - 1);
        let (step, ends) = (&self.of.steps[next - 1], [self.squares[next - 1], self.squares[next]]);
        let length = times[next] - times[next - 1];
        let part = (time - times[next - 1]) / length;
        let [first, last] = ends.map(|square| square.max(0.0).sqrt());
        let [gain, more] =
            [step.flanks[0].slope(ends[0]), step.flanks[2].slope(ends[1])].map(|slope| slope / 2.0 * length);
        let rest = 1.0 - part;
        rest * rest * ((1.0 + 2.0 * part) * first + part * gain)
            + part * part * ((1.0 + 2.0 * rest) * last - rest * more)
    }

    /// The speeds at the ends of the steps.
    pub(crate) fn speeds(&self) -> Vec<f64> {
        self.squares.iter().map(|square| square.max(0.0).sqrt()).collect()
    }

    /// Least speed within the engagement, where it changes from less to more; at the ends if it never does.
    pub(crate) fn least_speed(&self) -> SpeedAt {
        self.extreme(-1.0, |_, square| square.max(0.0).sqrt())
    }

    /// Greatest speed.
    pub(crate) fn greatest_speed(&self) -> SpeedAt {
        self.extreme(1.0, |_, square| square.max(0.0).sqrt())
    }

    /// The mean of least and greatest speed.
    pub(crate) fn mean_of_extremes(&self) -> f64 {
        f64::midpoint(self.least_speed().speed, self.greatest_speed().speed)
    }

    /// Normal force times crank radius where it is greatest by its size.
    pub(crate) fn greatest_force(&self) -> f64 {
        self.extreme(1.0, |flanks, square| flanks.force(square).abs()).speed
    }

    /// Where the pin leaves the leading flank for the trailing one; none if it never does.
    pub(crate) fn reversal(&self) -> Option<SpeedAt> {
        for (step, ends) in self.of.steps.iter().zip(self.squares.windows(2)) {
            // What the leading flank would have to do goes smoothly through zero.
            let [before, after] = [step.flanks[0].leading_force(ends[0]), step.flanks[2].leading_force(ends[1])];
            if before > 0.0 && after <= 0.0 {
                let part = before / (before - after);
                let square = ends[0] + part * (ends[1] - ends[0]);
                return Some(SpeedAt { angle: step.from + part * step.length, speed: square.sqrt() });
            }
        }
        None
    }

    /// Where a quantity times a sign is greatest: at an end, or by the parabola through three neighbours.
    fn extreme(&self, sign: f64, quantity: impl Fn(&Flanks, f64) -> f64) -> SpeedAt {
        let angles = self.angles();
        let last = self.of.steps.len() - 1;
        let value = |k: usize| {
            let flanks = if k > last { &self.of.steps[last].flanks[2] } else { &self.of.steps[k].flanks[0] };
            sign * quantity(flanks, self.squares[k])
        };
        let values: Vec<f64> = (0..self.squares.len()).map(value).collect();
        let best = (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(0);
        let (mut angle, mut found) = (angles[best], values[best]);
        if best > 0 && best < values.len() - 1 {
            let [left, right] = [angles[best - 1] - angle, angles[best + 1] - angle];
            let [below, above] = [values[best - 1] - found, values[best + 1] - found];
            // Through the neighbours as c x + d x².
            let bend = (above / right - below / left) / (right - left);
            let rise = below / left - bend * left;
            if bend < 0.0 {
                angle -= rise / (2.0 * bend);
                found -= rise * rise / (4.0 * bend);
            }
        }
        SpeedAt { angle, speed: sign * found }
    }
}

/// The mean of 1/√u over a step, from u at its ends and what u would rise by along the slope at each end.
///
/// With the square of a number for the part of the step, so that it may begin at rest.
fn mean_slowness(ends: &[f64], rises: [f64; 2]) -> f64 {
    // Gauss's rule with four points from −1 to 1: their sizes and weights.
    const POINTS: [(f64, f64); 2] =
        [(0.861_136_311_594_052_6, 0.347_854_845_137_453_85), (0.339_981_043_584_856_3, 0.652_145_154_862_546_1)];
    let square = |part: f64| {
        let rest = 1.0 - part;
        let [first, last] =
            [ends[0] * (1.0 + 2.0 * part) + rises[0] * part, ends[1] * (1.0 + 2.0 * rest) - rises[1] * rest];
        rest * rest * first + part * part * last
    };
    let slowness = |root: f64| 2.0 * root / square(root * root).sqrt();
    let both = |size: f64| slowness(f64::midpoint(1.0, -size)) + slowness(f64::midpoint(1.0, size));
    POINTS.iter().map(|(size, weight)| weight / 2.0 * both(*size)).sum()
}
