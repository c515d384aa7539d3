//! Integrates differential equations as MIMIC did, the simulation language of the 1973 computations: from Rust by
//! [`integrate`], or from the text of a deck by [`language`].
//!
//! ```
//! use geneva_mimic::{SolverParameters, integrate};
//! use nalgebra::Vector2;
//!
//! // x'' = -x from x = 1 at rest, printed every half unit of time until 3.
//! let mut spring = |_: f64, state: &Vector2<f64>| Vector2::new(state[1], -state[0]);
//! let mut printed = 0;
//! let parameters = SolverParameters::new(0.5, 3.0);
//! let end = integrate(&mut spring, Vector2::new(1.0, 0.0), &parameters, |point| {
//!     assert_eq!(point.time, point.index as f64 * 0.5);
//!     printed += 1;
//! })?;
//! assert_eq!((printed, end.last.time), (7, 3.0));
//! assert!((end.last.state[0] - 3_f64.cos()).abs() < 1e-4);
//! # Ok::<(), geneva_mimic::IntegrationError<2, std::convert::Infallible>>(())
//! ```
//!
//! What is known of MIMIC is in MEYER, Appendix B: the classical method of order four; the error of a step
//! judged by taking it once whole and once in two halves; a relative error below 5·10⁻⁶; results printed every `DT`
//! until the run ends; a time delay `TDL` for a value of a moment before. What is not known is a parameter here, with
//! a default and the reason for it: see [`SolverParameters`].
//!
//! Units are those of your equations. The integrator allocates nothing: states have a fixed size, and results are handed
//! to a closure. A delay line grows to the capacity that it is given. No function of the platform's mathematics is called,
//! so results are the same bits everywhere, as long as the right-hand side's are.
//!
//! # Where to look
//!
//! | question | item |
//! |---|---|
//! | a run, printed point by point | [`integrate`] with [`SolverParameters`] |
//! | one classical step of order four | [`runge_kutta_step`] |
//! | a system that remembers: time delays | [`System`], [`DelayLine`] |
//! | the text of a deck, from cards to a printout | [`language`] |
//!
//! This crate knows nothing of mechanisms, claims or books.

#![warn(clippy::missing_errors_doc)]

mod delay;
mod error;
pub mod language;
mod parameters;
mod print_times;
mod run;
mod step;
mod system;

pub use delay::{DelayError, DelayLine, Extrapolation, Interpolation};
pub use error::{AllowedRange, Cause, EarlyStop, IntegrationError, ParameterError, SolverQuantity};
pub use parameters::{MOST_STEPS, MinStepPolicy, SolverParameters, StepSolution};
pub use run::{Point, Solution, SolverStats, integrate};
pub use step::runge_kutta_step;
pub use system::System;
