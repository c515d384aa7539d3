//! What can be said to `geneva escapement`.

use super::typed;
use clap::{Args, ValueEnum};

/// Which escapement, and how.
#[derive(Args, Debug)]
pub struct EscapementArguments {
    /// Number of slots of the follower: 3, 4 or 6; the driver then has 6, 4 or 3 pins
    #[arg(long, value_name = "N", value_parser = typed::slots, allow_negative_numbers = true)]
    pub slots: u32,
    /// Coefficient of friction between pin and slot, above zero; --format csv allows zero
    #[arg(long, value_name = "MU", value_parser = typed::plain, allow_hyphen_values = true)]
    pub friction: f64,
    /// Torque of the spring on the driver, constant, above zero
    #[arg(long, value_name = "K", value_parser = typed::positive, allow_hyphen_values = true)]
    pub torque: f64,
    /// Moment of inertia of the driver about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, allow_hyphen_values = true)]
    pub driver_inertia: f64,
    /// Moment of inertia of the follower about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, allow_hyphen_values = true)]
    pub follower_inertia: f64,
    /// The units of torque and inertias, where they are to be told in SI units too
    #[arg(long, value_enum)]
    pub units: Option<Units>,
    /// Turn of the driver in degrees after which its angle is put back to the pin's entering; another than the default
    /// is not what a mechanism does, but what a program does that folds the angle at a fixed value
    /// [default: 360 over the number of pins]
    #[arg(long, value_name = "D", value_parser = typed::degrees, allow_hyphen_values = true)]
    pub modulus_deg: Option<f64>,
    /// How long the run from rest lasts; only with --format csv
    /// [default: the rise and three periods more, or a hundred engagements if that is less; ten without friction]
    #[arg(long, value_name = "T", value_parser = typed::positive, allow_hyphen_values = true)]
    pub duration: Option<f64>,
    /// Time from line to line of the run; only with --format csv
    /// [default: the round number that puts 100 to 250 lines in the last engagement; more for a long --duration]
    #[arg(long, value_name = "T", value_parser = typed::positive, allow_hyphen_values = true)]
    pub interval: Option<f64>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub format: EscapementFormat,
    /// Which drawing; only with --format svg [default: mechanism]
    #[arg(long, value_enum)]
    pub figure: Option<FigureName>,
}

/// Coherent systems of units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Units {
    /// Inch, pound (a force) and second: torque in in lb, inertias in in lb s²
    InLbS,
    /// Metre, kilogram and second: torque in N m, inertias in kg m²
    Si,
}

/// How to write an escapement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum EscapementFormat {
    /// A sheet for reading, which says what is measured from where
    #[default]
    Text,
    /// An object with all digits: the steady state and the rise from rest
    Json,
    /// The run from rest, a line for each time
    Csv,
    /// A drawing, a file of its own; --figure says which
    Svg,
}

/// What can be drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum FigureName {
    /// The mechanism to scale
    #[default]
    Mechanism,
    /// Normal force and torque of the friction over one engagement of the steady state
    NormalForce,
    /// Speeds of driver and follower over the first engagements from rest, in rad/s and ms: for torques and inertias
    /// with the second in their units
    Run,
}
