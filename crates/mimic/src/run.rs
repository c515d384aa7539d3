//! A run: which steps are tried, which are kept, and what is printed.

use crate::print_times::{PrintTimes, SLIVER};
use crate::step::{Attempt, non_finite};
use crate::{Cause, EarlyStop, IntegrationError, MinStepPolicy, SolverParameters, SolverQuantity, System};
use nalgebra::SVector;

/// A printed point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<const D: usize> {
    /// Its number; the start is number 0.
    pub index: u64,
    /// Its time, in the unit of the right-hand side's time: the number times the print interval, rounded once, or the
    /// run length.
    pub time: f64,
    /// The state there.
    pub state: SVector<f64, D>,
    /// The derivative there.
    pub derivative: SVector<f64, D>,
}

/// The work of a run.
///
/// An attempt takes ten evaluations, three for the whole step and seven for its halves. All of them use one more, at
/// the point they start from: it is made once per kept point, the start included, whatever is refused there. So a run
/// that reaches its end has `evaluations == 10 * (accepted + rejected) + accepted + 1`. What a system evaluates to say
/// whether it [`switches`](System::switches) is not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SolverStats {
    /// Steps that were kept.
    pub accepted: u64,
    /// Steps that were tried and refused.
    pub rejected: u64,
    /// Accepted steps whose error is too large: see [`MinStepPolicy::Continue`].
    pub forced: u64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// The end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<const D: usize> {
    /// The last printed point.
    pub last: Point<D>,
    /// The work of the whole run.
    pub work: SolverStats,
}

/// Integrates the system from `start` at time 0 and hands each printed point to `print`, the start included.
///
/// A step is refused if the whole step and two half steps differ by more than the tolerance in any component, if
/// either is not finite, or if the system [`switches`](System::switches) at its end; it is then tried shorter. The way
/// from point to point of the print grid does not change the times of the points. MEYER, Appendix B, and
/// [`SolverParameters`] for what is not said there.
///
/// ```
/// use geneva_mimic::{SolverParameters, integrate};
/// use nalgebra::Vector1;
///
/// // x' = −x from 1, printed at 0, 0.5, 1, 1.5 and 2.
/// let mut decay = |_: f64, x: &Vector1<f64>| -*x;
/// let mut times = Vec::new();
/// let end = integrate(&mut decay, Vector1::new(1.0), &SolverParameters::new(0.5, 2.0), |point| times.push(point.time))?;
/// assert_eq!(times, [0.0, 0.5, 1.0, 1.5, 2.0]);
/// assert!((end.last.state[0] / (-2_f64).exp() - 1.0).abs() < 1e-5);
/// # Ok::<(), geneva_mimic::IntegrationError<1, std::convert::Infallible>>(())
/// ```
///
/// # Errors
///
/// [`IntegrationError::Parameter`] for a parameter outside its range; [`IntegrationError::EarlyStop`] for a start, or a
/// derivative at a kept point, that is not finite, a step that would have to be smaller than allowed, too many steps,
/// or a fault of the system.
pub fn integrate<S, const D: usize>(
    system: &mut S,
    start: SVector<f64, D>,
    parameters: &SolverParameters,
    mut print: impl FnMut(&Point<D>),
) -> Result<Solution<D>, IntegrationError<D, S::Fault>>
where
    S: System<D>,
{
    parameters.check()?;
    let grid = PrintTimes::new(parameters.print_interval, parameters.run_length);
    let mut run = Integration {
        system,
        parameters,
        time: 0.0,
        state: start,
        derivative: SVector::zeros(),
        largest: 0.0,
        step: parameters.initial_step,
        work: SolverStats::default(),
    };
    run.finite(SolverQuantity::Start, &start)?;
    run.accept(0.0, start)?;
    let mut last = run.point(0);
    print(&last);
    for index in 1..=grid.last {
        run.reach(grid.time(index))?;
        last = run.point(index);
        print(&last);
    }
    Ok(Solution { last, work: run.work })
}

/// A run at the last point that it has accepted.
struct Integration<'a, S, const D: usize> {
    system: &'a mut S,
    parameters: &'a SolverParameters,
    time: f64,
    state: SVector<f64, D>,
    derivative: SVector<f64, D>,
    /// The largest size of a component at an accepted point.
    largest: f64,
    /// What would be tried next if no printed point were in the way.
    step: f64,
    work: SolverStats,
}

impl<S: System<D>, const D: usize> Integration<'_, S, D> {
    /// Steps to a printed point.
    fn reach(&mut self, target: f64) -> Result<(), EarlyStop<D, S::Fault>> {
        let parameters = self.parameters;
        // Error of the attempt before, for the case that no other can be made.
        let mut excess = 0.0;
        while self.time < target {
            if self.work.accepted + self.work.rejected >= parameters.most_steps {
                return Err(self.stopped(Cause::TooManySteps { most_steps: parameters.most_steps }));
            }
            let rest = target - self.time;
            let lands = rest <= self.step * (1.0 + SLIVER);
            let cut = rest < self.step * (1.0 - SLIVER);
            let end = if lands { target } else { self.time + self.step };
            let step = end - self.time;
            let smallest_step = parameters.smallest_step;
            if !lands && self.time + step / 4.0 <= self.time {
                return Err(self.stopped(Cause::StepUnderflow { step: self.step, smallest_step, excess }));
            }
            let attempt = self.attempt(end)?;
            let infinite = attempt.non_finite();
            excess = match infinite {
                Some(_) => f64::INFINITY,
                None => attempt.excess(parameters.relative_tolerance, self.floor(&attempt)),
            };
            // The end is rounded, and the step from it may be a little longer than was asked for.
            let asked = step.min(self.step);
            let smallest = asked <= smallest_step * (1.0 + SLIVER);
            let forced = smallest && infinite.is_none() && parameters.at_smallest_step == MinStepPolicy::Continue;
            if excess <= 1.0 || forced {
                let kept = attempt.solution(parameters.kept);
                let switch_step = parameters.switch_step();
                if asked > switch_step * (1.0 + SLIVER) && self.switches(end, &kept)? {
                    self.work.rejected += 1;
                    self.step = (step * parameters.shrink_factor).max(switch_step);
                    continue;
                }
                self.work.accepted += 1;
                self.work.forced += u64::from(excess > 1.0);
                self.accept(end, kept)?;
                // A step cut short by a printed point says nothing of a longer one.
                if excess <= parameters.growth_below && !cut {
                    self.step = (self.step * parameters.growth_factor).min(parameters.largest_step);
                }
                continue;
            }
            self.work.rejected += 1;
            if smallest {
                return Err(self.stopped(match infinite {
                    Some((component, value)) => Cause::NonFinite { quantity: SolverQuantity::State, component, value },
                    None => Cause::StepUnderflow { step, smallest_step, excess },
                }));
            }
            self.step = (step * parameters.shrink_factor).max(smallest_step);
        }
        Ok(())
    }

    /// Both results of a step to this time.
    fn attempt(&mut self, end: f64) -> Result<Attempt<D>, EarlyStop<D, S::Fault>> {
        let Self { system, work, time, state, derivative, .. } = self;
        let rate = |time: f64, state: &SVector<f64, D>| {
            work.evaluations += 1;
            system.derivative(time, state)
        };
        let attempt = Attempt::new(rate, *time, end, state, derivative);
        attempt.map_err(|fault| self.stopped(Cause::System(fault)))
    }

    fn switches(&mut self, time: f64, state: &SVector<f64, D>) -> Result<bool, EarlyStop<D, S::Fault>> {
        self.system.switches(time, state).map_err(|fault| self.stopped(Cause::System(fault)))
    }

    /// Goes on from this point: its derivative is the first of the steps that start here.
    fn accept(&mut self, time: f64, state: SVector<f64, D>) -> Result<(), EarlyStop<D, S::Fault>> {
        self.finite(SolverQuantity::State, &state)?;
        (self.time, self.state) = (time, state);
        self.largest = self.largest.max(state.amax());
        self.work.evaluations += 1;
        let derivative = self.system.kept_derivative(time, &state);
        self.derivative = derivative.map_err(|fault| self.stopped(Cause::System(fault)))?;
        self.finite(SolverQuantity::Derivative, &self.derivative)?;
        let accepted = self.system.accepted(time, &state, &self.derivative);
        accepted.map_err(|fault| self.stopped(Cause::System(fault)))
    }

    /// The size below which a component counts as if it had this size.
    fn floor(&self, attempt: &Attempt<D>) -> f64 {
        self.parameters.absolute_floor.min(self.largest.max(attempt.largest()))
    }

    fn finite(&self, quantity: SolverQuantity, vector: &SVector<f64, D>) -> Result<(), EarlyStop<D, S::Fault>> {
        match non_finite(vector) {
            Some((component, value)) => Err(self.stopped(Cause::NonFinite { quantity, component, value })),
            None => Ok(()),
        }
    }

    fn stopped(&self, cause: Cause<S::Fault>) -> EarlyStop<D, S::Fault> {
        EarlyStop { time: self.time, state: self.state, work: self.work, cause }
    }

    fn point(&self, index: u64) -> Point<D> {
        Point { index, time: self.time, state: self.state, derivative: self.derivative }
    }
}
