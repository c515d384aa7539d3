//! Parameters of a run, and their defaults.

use crate::{AllowedRange, ParameterError};

/// The most that [`SolverParameters::most_steps`] may be: up to here the multiples of the print interval are well apart.
pub const MOST_STEPS: u64 = 1_000_000_000_000;

/// Value of a step with which the run goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StepSolution {
    /// The whole step: order 4, the larger error of the two.
    FullStep,
    /// The two half steps: order 4, a sixteenth of the error of the whole step.
    TwoHalfSteps,
    /// The two half steps and a fifteenth of their difference from the whole one (Richardson): order 5.
    Extrapolated,
}

/// Action if the error is too large and the step cannot be made smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MinStepPolicy {
    /// End the run with an error.
    Stop,
    /// Keep the step all the same and count it: [`SolverStats::forced`](crate::SolverStats::forced).
    Continue,
}

/// Parameters of a run.
///
/// The thesis gives the print interval `DT`, the run length and the relative error. The other fields are named because
/// it does not give them: a result that depends on them is not a result of the thesis. MEYER, Appendix B.
///
/// ```
/// use geneva_mimic::{SolverParameters, integrate};
/// use nalgebra::Vector1;
///
/// // A smaller tolerance costs more steps.
/// let mut decay = |_: f64, x: &Vector1<f64>| -*x;
/// let usual = SolverParameters::new(1.0, 2.0);
/// let fine = SolverParameters { relative_tolerance: 1e-9, ..usual };
/// let [few, many] = [usual, fine].map(|of| integrate(&mut decay, Vector1::new(1.0), &of, |_| ()));
/// assert!(few?.work.accepted < many?.work.accepted);
/// # Ok::<(), geneva_mimic::IntegrationError<1, std::convert::Infallible>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolverParameters {
    /// `DT`, time between printed points, in the unit of the right-hand side's time, positive. No step passes a printed
    /// point.
    pub print_interval: f64,
    /// Time of the last printed point, in the same unit, positive; the start is at 0.
    ///
    /// If it is no multiple of the print interval, the last interval is shorter. Within rounding of a multiple it is
    /// taken for the multiple.
    pub run_length: f64,
    /// Largest difference of the whole step from two half steps, over the size of the component, dimensionless; between
    /// 0 and 1.
    ///
    /// Default 5·10⁻⁶, from the thesis.
    pub relative_tolerance: f64,
    /// Size below which a component is judged as if it had this size, or the largest that any has had in the run if that
    /// is smaller; not negative, in the unit of the components.
    ///
    /// Default 10⁻³. Without it a component that passes zero would stop the run; with it the test asks for 5·10⁻⁹
    /// there, which the rounding of sums of the order of one does not disturb. Where all is small, as with charges in
    /// coulombs, the test goes by the largest.
    pub absolute_floor: f64,
    /// The next step is longer if the error was at most this part of the tolerance, dimensionless; from 0 to 1.
    ///
    /// Default 1/64. A step twice as long has 32 times the error; the 2 left over is a margin, so that a longer step is
    /// not refused at once.
    pub growth_below: f64,
    /// What the step is multiplied by when it grows, dimensionless; at least 1, where 1 is never.
    ///
    /// Default 2: halves and doubles of the print interval meet the printed points without a remainder.
    pub growth_factor: f64,
    /// What a refused step is multiplied by, dimensionless; between 0 and 1.
    ///
    /// Default 1/2, for the same reason.
    pub shrink_factor: f64,
    /// Smallest step that is tried, in the unit of the right-hand side's time, positive, unless less is left to the
    /// next printed point.
    ///
    /// Default 2⁻³⁰ of the print interval. To pass a switch within the tolerance takes some 18 halvings; 12 more are
    /// for a switch that is large for the state. A step that time in `f64` cannot tell from zero is too small in any
    /// case.
    pub smallest_step: f64,
    /// Largest step, in the same unit, at least the smallest.
    ///
    /// Default: the print interval, beyond which no step goes.
    pub largest_step: f64,
    /// First step that is tried, in the same unit, from the smallest to the largest.
    ///
    /// Default: the largest. It is judged as any other, and a few halvings find the right one.
    pub initial_step: f64,
    /// Which value is kept.
    ///
    /// Default: two half steps. It is the better of the two that the thesis says are computed; of a third it says
    /// nothing.
    pub kept: StepSolution,
    /// What happens when the smallest step is not small enough.
    ///
    /// Default: the run stops. A number that misses its tolerance should not pass for one that meets it.
    pub at_smallest_step: MinStepPolicy,
    /// Most attempts at a step, refused ones included; from 1 to [`MOST_STEPS`].
    ///
    /// Default 10⁷, some seconds' work for a few components. It bounds what an ill-chosen print interval or tolerance can cost.
    pub most_steps: u64,
}

impl SolverParameters {
    /// How near a change that comes at kept points only is located: 2⁻²⁴ of the print interval, or the smallest step if
    /// that is longer; in the unit of the right-hand side's time.
    ///
    /// A rate that changes so late misses less than 10⁻⁷ of what it adds in a print interval.
    pub fn switch_step(&self) -> f64 {
        (self.print_interval / 16_777_216.0).max(self.smallest_step)
    }

    /// A run of this length, printed at this interval, all else by default. Nothing is checked before the run.
    pub fn new(print_interval: f64, run_length: f64) -> Self {
        Self {
            print_interval,
            run_length,
            relative_tolerance: 5e-6,
            absolute_floor: 1e-3,
            growth_below: 1.0 / 64.0,
            growth_factor: 2.0,
            shrink_factor: 0.5,
            smallest_step: print_interval / 1_073_741_824.0,
            largest_step: print_interval,
            initial_step: print_interval,
            kept: StepSolution::TwoHalfSteps,
            at_smallest_step: MinStepPolicy::Stop,
            most_steps: 10_000_000,
        }
    }

    /// A run with steps of one length, shorter only where a printed point is nearer; no step is refused for its error.
    ///
    /// Steps that miss the tolerance are counted: [`SolverStats::forced`](crate::SolverStats::forced).
    pub fn with_fixed_step(step: f64, print_interval: f64, run_length: f64) -> Self {
        Self {
            smallest_step: step,
            largest_step: step,
            initial_step: step,
            at_smallest_step: MinStepPolicy::Continue,
            ..Self::new(print_interval, run_length)
        }
    }

    /// The first parameter that is outside its range, as an error.
    ///
    /// # Errors
    ///
    /// [`ParameterError::Range`], [`ParameterError::MostSteps`], and [`ParameterError::PrintedPoints`] for more printed
    /// points than steps.
    pub fn check(&self) -> Result<(), ParameterError> {
        let steps = AllowedRange::FromTo(self.smallest_step, self.largest_step);
        let asked = [
            ("print_interval", self.print_interval, AllowedRange::Positive),
            ("run_length", self.run_length, AllowedRange::Positive),
            ("relative_tolerance", self.relative_tolerance, AllowedRange::Between(0.0, 1.0)),
            ("absolute_floor", self.absolute_floor, AllowedRange::FromTo(0.0, f64::MAX)),
            ("growth_below", self.growth_below, AllowedRange::FromTo(0.0, 1.0)),
            ("growth_factor", self.growth_factor, AllowedRange::FromTo(1.0, f64::MAX)),
            ("shrink_factor", self.shrink_factor, AllowedRange::Between(0.0, 1.0)),
            ("smallest_step", self.smallest_step, AllowedRange::Positive),
            ("largest_step", self.largest_step, AllowedRange::FromTo(self.smallest_step, f64::MAX)),
            ("initial_step", self.initial_step, steps),
        ];
        if let Some(&(name, asked, allowed)) = asked.iter().find(|(_, asked, allowed)| !allowed.includes(*asked)) {
            return Err(ParameterError::Range { name, asked, allowed });
        }
        if !(1..=MOST_STEPS).contains(&self.most_steps) {
            return Err(ParameterError::MostSteps(self.most_steps));
        }
        let points = self.run_length / self.print_interval;
        if points > self.most_steps as f64 {
            return Err(ParameterError::PrintedPoints { points, most_steps: self.most_steps });
        }
        Ok(())
    }
}
