//! One step: once whole, once in two halves, and what the difference says.

use crate::StepSolution;
use nalgebra::SVector;

/// The state at `to` from that at `from` by one step of the classical Runge-Kutta method.
///
/// With h = `to` − `from`: x + h/6 (f₁ + 2 f₂ + 2 f₃ + f₄), where f₁ = `first` is the derivative at the start, f₂ and
/// f₃ are two at the middle and f₄ is one at the end. Three evaluations of `rate`. The error of one step is of order
/// h⁵. MEYER, Appendix B.
///
/// ```
/// use geneva_mimic::runge_kutta_step;
/// use nalgebra::Vector1;
///
/// // x' = x from 1: one step of h gives the series of e^h up to h⁴.
/// let (rate, h) = (|_: f64, x: &Vector1<f64>| Ok::<_, std::convert::Infallible>(*x), 0.5);
/// let start = Vector1::new(1.0);
/// let end = runge_kutta_step(rate, 0.0, h, &start, &start)?;
/// let series = 1.0 + h + h.powi(2) / 2.0 + h.powi(3) / 6.0 + h.powi(4) / 24.0;
/// assert!((end[0] - series).abs() < 1e-15);
/// # Ok::<(), std::convert::Infallible>(())
/// ```
///
/// # Errors
///
/// The first error of `rate`.
pub fn runge_kutta_step<F, const D: usize>(
    mut rate: impl FnMut(f64, &SVector<f64, D>) -> Result<SVector<f64, D>, F>,
    from: f64,
    to: f64,
    state: &SVector<f64, D>,
    first: &SVector<f64, D>,
) -> Result<SVector<f64, D>, F> {
    let h = to - from;
    let middle = from + h / 2.0;
    let second = rate(middle, &(state + first * (h / 2.0)))?;
    let third = rate(middle, &(state + second * (h / 2.0)))?;
    let fourth = rate(to, &(state + third * h))?;
    Ok(state + (first + second * 2.0 + third * 2.0 + fourth) * (h / 6.0))
}

/// The two results of one attempt.
pub(crate) struct Attempt<const D: usize> {
    full: SVector<f64, D>,
    halves: SVector<f64, D>,
}

impl<const D: usize> Attempt<D> {
    /// Ten evaluations of `rate`: three for the whole step, three for the first half, four for the second.
    pub(crate) fn new<F>(
        mut rate: impl FnMut(f64, &SVector<f64, D>) -> Result<SVector<f64, D>, F>,
        from: f64,
        to: f64,
        state: &SVector<f64, D>,
        first: &SVector<f64, D>,
    ) -> Result<Self, F> {
        let full = runge_kutta_step(&mut rate, from, to, state, first)?;
        let middle = from + (to - from) / 2.0;
        let half = runge_kutta_step(&mut rate, from, middle, state, first)?;
        let again = rate(middle, &half)?;
        let halves = runge_kutta_step(&mut rate, middle, to, &half, &again)?;
        Ok(Self { full, halves })
    }

    /// The first component that is not finite, with its value.
    pub(crate) fn non_finite(&self) -> Option<(usize, f64)> {
        non_finite(&self.full).or_else(|| non_finite(&self.halves))
    }

    /// The largest difference of a component between the two results, over what is allowed for it.
    ///
    /// Allowed is the tolerance times the component's size by two half steps, or times the floor if that is larger.
    pub(crate) fn excess(&self, relative_tolerance: f64, absolute_floor: f64) -> f64 {
        self.excesses(relative_tolerance, absolute_floor).fold(0.0, f64::max)
    }

    /// The component whose difference is the largest over what is allowed.
    pub(crate) fn worst(&self, relative_tolerance: f64, absolute_floor: f64) -> usize {
        let excesses = self.excesses(relative_tolerance, absolute_floor).enumerate();
        excesses.max_by(|one, other| one.1.total_cmp(&other.1)).map_or(0, |(component, _)| component)
    }

    fn excesses(&self, relative_tolerance: f64, absolute_floor: f64) -> impl Iterator<Item = f64> {
        self.halves.iter().zip(self.full.iter()).map(move |(halves, full)| {
            let difference = (halves - full).abs();
            // Nothing over nothing is no excess.
            if difference > 0.0 { difference / (relative_tolerance * halves.abs().max(absolute_floor)) } else { 0.0 }
        })
    }

    /// The largest size of a component by two half steps.
    pub(crate) fn largest(&self) -> f64 {
        self.halves.amax()
    }

    /// The state that the run goes on with.
    pub(crate) fn solution(&self, kept: StepSolution) -> SVector<f64, D> {
        match kept {
            StepSolution::FullStep => self.full,
            StepSolution::TwoHalfSteps => self.halves,
            // Of the error of the whole step, 1/16 is left in two half steps: their difference is 15 times that.
            StepSolution::Extrapolated => self.halves + (self.halves - self.full) / 15.0,
        }
    }
}

/// The first component that is not finite, with its value.
pub(crate) fn non_finite<const D: usize>(vector: &SVector<f64, D>) -> Option<(usize, f64)> {
    vector.iter().copied().enumerate().find(|(_, value)| !value.is_finite())
}
