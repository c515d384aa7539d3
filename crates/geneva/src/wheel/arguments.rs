//! What can be said to `geneva wheel`.

use clap::{Args, ValueEnum};
use geneva_kinematics::wheel::STATIONS;

/// Which wheel, and how.
#[derive(Args, Debug)]
pub struct WheelArguments {
    /// Number of slots, 3 to 1000: stops in one turn of the wheel
    #[arg(long, value_name = "N", value_parser = stations, allow_negative_numbers = true)]
    pub stations: u32,
    /// Number of evenly spaced pins on the driver; at most 2N/(N − 2), or two would be in slots at once
    #[arg(long, value_name = "P", default_value_t = 1, value_parser = pins, allow_negative_numbers = true)]
    pub pins: u32,
    /// Speed of the driver in turns a minute, above zero; gives times, rad/s and rad/s²
    #[arg(long, value_name = "R", value_parser = number, allow_negative_numbers = true)]
    pub rpm: Option<f64>,
    /// Distance of a pin's centre from the driver's axis in mm, above zero; gives lengths in mm
    #[arg(long, value_name = "MM", value_parser = number, allow_negative_numbers = true)]
    pub crank_radius: Option<f64>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub format: WheelFormat,
}

/// How to write a wheel.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum WheelFormat {
    /// A sheet for reading, which says what is measured from where
    #[default]
    Text,
    /// An object with all digits; null where --rpm or --crank-radius is missing
    Json,
    /// The same, a header and a row
    Csv,
    /// A drawing to scale, a file of its own
    Svg,
}

fn stations(text: &str) -> Result<u32, String> {
    let (least, most) = (STATIONS.start(), STATIONS.end());
    text.parse().map_err(|_| format!("not a number of stations; give a whole number from {least} to {most}"))
}

fn pins(text: &str) -> Result<u32, &'static str> {
    text.parse().map_err(|_| "not a number of pins; give a whole number from 1 up")
}

fn number(text: &str) -> Result<f64, &'static str> {
    text.parse().map_err(|_| "not a number; give one above zero, with a point before its decimals")
}
