//! Questions to a mechanism, and their answers.
//!
//! A question has arguments, and its answer has fields: each with a key, a value, a unit, a name, what it means, and how it is
//! rounded. The command line, the figures that a reader moves and the chapters of the book say the same things of a mechanism
//! because they all ask here. Nothing is read, written or printed here, and no other crate turns a moment into a force, or
//! turns per minute into radians per second.
//!
//! ```
//! use geneva_ask::wheel::{WheelDesign, WheelQuestion};
//!
//! let question = WheelQuestion::parse("--stations 6 --crank-radius 25 --rpm 60 --inertia 0.002")?;
//! let answer = WheelDesign::new(question)?.answer()?;
//! let force = answer.field("peak_pin_force_n").expect("a key of the answer");
//! assert!(force.unit == "N" && force.number().is_some_and(|newtons| newtons > 0.0));
//! # Ok::<(), geneva_ask::Error>(())
//! ```

/// An argument that is impossible here, in words as of `format!`.
macro_rules! refused {
    ($($words:tt)*) => { $crate::Error::Argument(format!($($words)*)) };
}

pub mod escapement;
mod field;
pub mod length_units;
pub mod number_format;
pub mod pin;
pub mod quick_return;
mod sheet;
mod timekeepers;
pub mod typed_number;
pub mod wheel;
pub mod worked;

pub use field::{Item, MechanismReport, Needs, ReportField, Rounding, SheetLine, SheetNumber};
pub use geneva_fields::{DataRow, FieldValue};

use geneva_figures::FigureError;
use geneva_kinematics::wheel::SizesError;
use geneva_kinematics::{EscapementError, KinematicsError};
use std::str::FromStr;

/// Why a question has no answer: what is wrong with it, and what to give instead. Arguments are named as at the command line.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// A mechanism that cannot be built, or has no position.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// An escapement that cannot be built.
    #[error(transparent)]
    Escapement(#[from] EscapementError),
    /// A motion or a load that there is not.
    #[error(transparent)]
    Dynamics(#[from] geneva_dynamics::DynamicsError),
    /// Parts of a wheel that don't fit, with the arguments that change them.
    #[error("{}", wheel::sizes_refusal(error, remedies))]
    Sizes {
        /// Why they don't fit.
        error: SizesError,
        /// The arguments with the values with which they do; of each alone, one is enough.
        remedies: Vec<wheel::FittingValues>,
    },
    /// A drawing that there is not.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// An argument that is impossible here.
    #[error("{0}")]
    Argument(String),
}

/// The answer to a question as it is typed at the command line: `wheel --stations 6`.
///
/// # Errors
///
/// A mechanism that is not asked so, and what is wrong with the arguments.
pub fn answer(question: &str) -> Result<MechanismReport, Error> {
    let (mechanism, arguments) = question.split_once(' ').unwrap_or((question, ""));
    match mechanism {
        "wheel" => match arguments.strip_prefix("check ") {
            Some(measured) => wheel::CheckQuestion::parse(measured)?.answer(),
            None => wheel::WheelDesign::new(wheel::WheelQuestion::parse(arguments)?)?.answer(),
        },
        "pin" => Ok(pin::PinDesign::new(&pin::PinQuestion::parse(arguments)?)?.answer()),
        "quick-return" => {
            quick_return::QuickReturnDesign::new(&quick_return::QuickReturnQuestion::parse(arguments)?)?.answer()
        }
        "escapement" => escapement::EscapementDesign::new(escapement::EscapementQuestion::parse(arguments)?)?.answer(),
        "runaway" => timekeepers::runaway(arguments),
        "governor" => timekeepers::governor(arguments),
        other => {
            Err(refused!("no mechanism {other}; there are wheel, pin, quick-return, escapement, runaway and governor"))
        }
    }
}

/// Further fields to a question: what a chapter or a figure shows, and neither a sheet nor the data have. They may take much longer
/// than the answer.
///
/// # Errors
///
/// As for [`answer`].
pub fn further(question: &str) -> Result<Vec<ReportField>, Error> {
    let (mechanism, arguments) = question.split_once(' ').unwrap_or((question, ""));
    match mechanism {
        "wheel" if arguments.starts_with("check ") => Ok(Vec::new()),
        "wheel" => wheel::WheelDesign::new(wheel::WheelQuestion::parse(arguments)?)?.further(),
        "escapement" => escapement::EscapementDesign::new(escapement::EscapementQuestion::parse(arguments)?)?.further(),
        _ => Ok(Vec::new()),
    }
}

/// Arguments and their values, which stand behind them: `--stations 6 --rpm 60`.
fn pairs(text: &str) -> impl Iterator<Item = Result<(&str, &str), Error>> {
    let mut words = text.split_whitespace();
    std::iter::from_fn(move || {
        let argument = words.next()?;
        let value = words.next().ok_or_else(|| refused!("{argument} has no value; give one"));
        Some(value.map(|value| (argument.trim_start_matches("--"), value)))
    })
}

/// The number that an argument is given.
fn number<T: FromStr>(name: &str, text: &str) -> Result<T, Error> {
    text.replace('−', "-").parse().map_err(|_| {
        let advice = typed_number::advice(text, typed_number::TypedNumber::Plain);
        refused!("--{name} {text}: {}", advice.unwrap_or_else(|| "not a number; give one".to_owned()))
    })
}
