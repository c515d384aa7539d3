//! What is integrated: a right-hand side, and what it remembers of the points that were kept.

use core::convert::Infallible;
use nalgebra::SVector;

/// A system of D ordinary differential equations of first order, x' = f(t, x).
///
/// Any `FnMut(f64, &SVector<f64, D>) -> SVector<f64, D>` is one. A system that looks back at its own past owns a
/// [`DelayLine`](crate::DelayLine), reads it in [`derivative`](Self::derivative) and writes it in
/// [`accepted`](Self::accepted), and nowhere else: trial steps that are refused then leave no trace.
///
/// ```
/// use geneva_mimic::{DelayError, DelayLine, Extrapolation, Interpolation, SolverParameters, System, integrate};
/// use nalgebra::Vector2;
///
/// /// (1 + s/2) x'' = 1 - t, with s the sign of x'' a moment before.
/// struct Push {
///     old_acceleration: DelayLine<100>,
/// }
///
/// impl System<2> for Push {
///     type Fault = DelayError;
///
///     fn derivative(&mut self, time: f64, state: &Vector2<f64>) -> Result<Vector2<f64>, DelayError> {
///         let sign = if self.old_acceleration.value(time)? < 0.0 { -1.0 } else { 1.0 };
///         Ok(Vector2::new(state[1], (1.0 - time) / (1.0 + 0.5 * sign)))
///     }
///
///     fn accepted(&mut self, time: f64, _: &Vector2<f64>, rate: &Vector2<f64>) -> Result<(), DelayError> {
///         self.old_acceleration.record(time, rate[1])
///     }
/// }
///
/// // With no step longer than the delay, what is read has been kept before.
/// let (print_interval, delay) = (0.125, 0.0125);
/// let old_acceleration = DelayLine::new(delay, 0.0, Interpolation::Linear, Extrapolation::Hold)?;
/// let parameters = SolverParameters { largest_step: delay, initial_step: delay, ..SolverParameters::new(print_interval, 2.0) };
/// let end = integrate(&mut Push { old_acceleration }, Vector2::zeros(), &parameters, |_| ())?;
/// // A gain of 1/3 while it is pushed forwards, a loss of 1 while backwards.
/// assert!((end.last.state[1] + 2.0 / 3.0).abs() < 0.001);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait System<const D: usize> {
    /// Why the system has no derivative, or cannot go on; [`Infallible`] if it always has one.
    type Fault;

    /// The derivative x' at a time and a state.
    ///
    /// Called at trial points too, also beyond the time that is kept at last and at states that are refused later.
    ///
    /// # Errors
    ///
    /// A fault ends the run with [`Cause::System`](crate::Cause::System).
    fn derivative(&mut self, time: f64, state: &SVector<f64, D>) -> Result<SVector<f64, D>, Self::Fault>;

    /// The derivative at a point that is kept: [`derivative`](Self::derivative), unless something in the system changes
    /// at kept points only, and so at this one.
    ///
    /// # Errors
    ///
    /// As those of `derivative`.
    fn kept_derivative(&mut self, time: f64, state: &SVector<f64, D>) -> Result<SVector<f64, D>, Self::Fault> {
        self.derivative(time, state)
    }

    /// Whether something that changes at kept points only would change at this one, the end of a step.
    ///
    /// Such a step is tried shorter until it is as short as
    /// [`SolverParameters::switch_step`](crate::SolverParameters::switch_step) says: the change then comes that late at most. A
    /// system that has nothing of the kind need not say so.
    ///
    /// # Errors
    ///
    /// As those of `derivative`.
    fn switches(&mut self, time: f64, state: &SVector<f64, D>) -> Result<bool, Self::Fault> {
        let _ = (time, state);
        Ok(false)
    }

    /// A point has been kept.
    ///
    /// Called once for each, in order of time, the start included and before it is printed. The call just before was
    /// `kept_derivative` at this point and gave `derivative`: whatever else the system worked out there is that of the
    /// point.
    ///
    /// # Errors
    ///
    /// A fault ends the run with [`Cause::System`](crate::Cause::System).
    fn accepted(
        &mut self,
        time: f64,
        state: &SVector<f64, D>,
        derivative: &SVector<f64, D>,
    ) -> Result<(), Self::Fault> {
        let _ = (time, state, derivative);
        Ok(())
    }
}

impl<F, const D: usize> System<D> for F
where
    F: FnMut(f64, &SVector<f64, D>) -> SVector<f64, D>,
{
    type Fault = Infallible;

    fn derivative(&mut self, time: f64, state: &SVector<f64, D>) -> Result<SVector<f64, D>, Infallible> {
        Ok(self(time, state))
    }
}
