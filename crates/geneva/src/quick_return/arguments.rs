//! What can be said to `geneva quick-return`.

use clap::{Args, ValueEnum};

/// Which mechanism, at which instant, and how.
#[derive(Args, Debug)]
pub struct QuickReturnArguments {
    /// Distance of the crank's axis from the lever's pivot in metres, above zero
    #[arg(long, value_name = "M", value_parser = length, allow_hyphen_values = true)]
    pub ground: f64,
    /// Distance of the pin from the crank's axis in metres, above zero; with one below the ground distance the lever
    /// swings to and fro, with one above it the lever turns round and round
    #[arg(long, value_name = "M", value_parser = length, allow_hyphen_values = true)]
    pub crank: f64,
    /// Where the mechanism is: one of the two.
    #[command(flatten)]
    pub angle: Angle,
    /// Which of the two points where the lever's ray meets the crank's circle the pin is at; only with --lever-angle
    /// [default: far]
    #[arg(long, value_enum, requires = "lever_angle", conflicts_with = "crank_angle")]
    pub branch: Option<BranchName>,
    /// Speed of the crank in turns a minute, counter-clockwise above zero and clockwise below; constant
    #[arg(long, value_name = "R", value_parser = speed, allow_hyphen_values = true)]
    pub rpm: f64,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub format: QuickReturnFormat,
    /// Which drawing; only with --format svg [default: mechanism]
    #[arg(long, value_enum)]
    pub figure: Option<FigureName>,
}

/// Where the mechanism is, by one of its two angles.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct Angle {
    /// Direction from the crank's axis to the pin in degrees, counter-clockwise from the direction that points from
    /// the lever's pivot to the crank's axis; this or --lever-angle
    #[arg(long, value_name = "DEG", value_parser = degrees, allow_hyphen_values = true)]
    pub crank_angle: Option<f64>,
    /// Direction from the lever's pivot to the pin in degrees, counter-clockwise from the same direction; this
    /// or --crank-angle
    #[arg(long, value_name = "DEG", value_parser = degrees, allow_hyphen_values = true)]
    pub lever_angle: Option<f64>,
}

/// Where the pin is on the lever's ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum BranchName {
    /// The one nearer to the lever's pivot: the lever is on its fast stroke
    Near,
    /// The one farther from it: the lever is on its slow stroke
    #[default]
    Far,
}

/// How to write a mechanism.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum QuickReturnFormat {
    /// A sheet for reading, which says what is measured from where and in which sense
    #[default]
    Text,
    /// An object with all digits; a vector that is zero has null for its direction
    Json,
    /// A drawing to scale, a file of its own; --figure says which
    Svg,
}

/// What can be drawn.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum FigureName {
    /// The mechanism
    #[default]
    Mechanism,
    /// The velocity diagram
    Velocity,
    /// The acceleration diagram
    Acceleration,
}

fn length(text: &str) -> Result<f64, &'static str> {
    number(text).ok_or("not a length; give metres above zero, with a point before the decimals")
}

fn degrees(text: &str) -> Result<f64, &'static str> {
    number(text).ok_or("not an angle; give degrees, with a point before the decimals")
}

fn speed(text: &str) -> Result<f64, &'static str> {
    number(text).ok_or("not a speed; give turns a minute, with a point before the decimals")
}

/// A number, with either of the signs for minus: the sheet has the typographer's.
fn number(text: &str) -> Option<f64> {
    text.replace('−', "-").parse().ok()
}
