//! One quick-return mechanism at an instant: where its parts are, every velocity and acceleration, and its drawings.

mod instant;
mod report;
mod steps;
mod vector;

pub use report::lever_motion;

use crate::number_format::{as_typed, rounded_down};
use crate::worked::DriverSpeed;
use crate::{Error, number, pairs};
use geneva_figures::Figure;
use geneva_figures::quick_return::{acceleration_diagram, mechanism, velocity_diagram};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::quick_return::{Branch, Drive, Position, QuickReturn};

/// What is asked of a quick-return mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuickReturnQuestion {
    /// Distance from the lever's pivot to the crank's axis, in metres.
    pub ground: f64,
    /// Distance from the crank's axis to the pin, in metres.
    pub crank: f64,
    /// Where the mechanism is.
    pub place: LinkageAngle,
    /// Constant speed of the crank, counter-clockwise above zero.
    pub speed: DriverSpeed,
}

/// Where the mechanism is, by one of its two angles in degrees, counter-clockwise from the direction that points from the
/// lever's pivot to the crank's axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkageAngle {
    /// Direction from the crank's axis to the pin.
    Crank(f64),
    /// Direction from the lever's pivot to the pin, and which of the two points on the lever's ray the pin is at.
    Lever(f64, Branch),
}

impl QuickReturnQuestion {
    /// Reads arguments as they are typed: `--ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60`.
    ///
    /// # Errors
    ///
    /// An argument that there is not, one that is missing, and a value that it can't have.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let (mut place, mut branch) = (None, Branch::Far);
        let [mut ground, mut crank] = [None; 2];
        let mut speed = None;
        for pair in pairs(text) {
            match pair? {
                ("ground", value) => ground = Some(number("ground", value)?),
                ("crank", value) => crank = Some(number("crank", value)?),
                ("rpm", value) => speed = Some(DriverSpeed::Rpm(number("rpm", value)?)),
                ("rad-s", value) => speed = Some(DriverSpeed::RadiansPerSecond(number("rad-s", value)?)),
                ("crank-angle", value) => place = Some(LinkageAngle::Crank(number("crank-angle", value)?)),
                ("lever-angle", value) => place = Some(LinkageAngle::Lever(number("lever-angle", value)?, Branch::Far)),
                ("branch", "near") => branch = Branch::Near,
                ("branch", "far") => branch = Branch::Far,
                (name, value) => {
                    return Err(refused!(
                        "--{name} {value}: give --ground, --crank, --rpm or --rad-s, and --crank-angle or --lever-angle, with --branch near \
                         or far"
                    ));
                }
            }
        }
        let missing = |name| move || refused!("--{name} is missing; give it");
        let place = match place.ok_or_else(missing("lever-angle"))? {
            LinkageAngle::Lever(degrees, _) => LinkageAngle::Lever(degrees, branch),
            crank => crank,
        };
        let [ground, crank] =
            [(ground, "ground"), (crank, "crank")].map(|(value, name)| value.ok_or_else(missing(name)));
        Ok(Self { ground: ground?, crank: crank?, place, speed: speed.ok_or_else(missing("rpm"))? })
    }
}

impl LinkageAngle {
    fn degrees(self) -> f64 {
        match self {
            Self::Crank(degrees) | Self::Lever(degrees, _) => degrees,
        }
    }
}

/// The drawings of a quick-return mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuickReturnDrawing {
    /// The mechanism.
    Mechanism,
    /// The velocity diagram.
    Velocity,
    /// The acceleration diagram.
    Acceleration,
}

/// A mechanism at an instant, as its question describes it.
#[derive(Debug)]
pub struct QuickReturnDesign {
    /// The lengths, in metres.
    pub linkage: QuickReturn,
    /// Where the parts are.
    pub position: Position,
    /// The crank's motion, in radians and seconds.
    pub drive: Drive<f64>,
    /// The crank's speed as it was given.
    speed: DriverSpeed,
    place: LinkageAngle,
}

/// Crank radii from the lever's pivot below which rounding would show in the lever's acceleration.
const NEAREST: f64 = 1e-3;

impl QuickReturnDesign {
    /// The mechanism that a question describes.
    ///
    /// # Errors
    ///
    /// What is impossible, with the arguments to change.
    pub fn new(question: &QuickReturnQuestion) -> Result<Self, Error> {
        let linkage = QuickReturn::new(question.ground, question.crank).map_err(|error| impossible(question, error))?;
        let position = match question.place {
            LinkageAngle::Lever(lever, branch) => linkage.position_at_lever_degrees(lever, branch),
            LinkageAngle::Crank(crank) => linkage.position_at_crank_degrees(crank),
        };
        let position = position.map_err(|error| impossible(question, error))?;
        if position.pin_distance >= NEAREST * linkage.crank() {
            let QuickReturnQuestion { speed, place, .. } = *question;
            Ok(Self { linkage, position, drive: Drive::steady(speed.radians_per_second()), speed, place })
        } else {
            Err(too_near(question, &linkage, &position))
        }
    }

    /// One of its drawings.
    pub fn drawing(&self, drawing: QuickReturnDrawing) -> Figure {
        let draw = match drawing {
            QuickReturnDrawing::Mechanism => mechanism,
            QuickReturnDrawing::Velocity => velocity_diagram,
            QuickReturnDrawing::Acceleration => acceleration_diagram,
        };
        draw(&self.linkage, &self.position, &self.drive, "m")
    }
}

/// The library's refusal, in terms of the options and the values that the reader typed.
fn impossible(question: &QuickReturnQuestion, error: KinematicsError) -> Error {
    let (ground, crank) =
        (format!("--ground {}", as_typed(question.ground)), format!("--crank {}", as_typed(question.crank)));
    match error {
        KinematicsError::Angle { name, asked } => {
            let option = if name == "lever angle" { "--lever-angle" } else { "--crank-angle" };
            refused!("{option} {} is not a finite angle; give an angle in degrees", as_typed(asked))
        }
        KinematicsError::BeyondTheSwing { asked, limit, open } => refused!(
            "--lever-angle {} is out of reach: with {ground} and {crank} the lever swings {} −{limit}° and {limit}°; give \
             an angle in this range, or a --crank-angle ({} possible)",
            as_typed(asked),
            if open { "between, but not to," } else { "between" },
            if open { "all but 180° are" } else { "all are" },
            limit = rounded_down(limit),
        ),
        KinematicsError::OnlyFar { .. } => refused!(
            "--branch near: with {crank}, which is at least as long as {ground}, the lever's ray meets the crank's circle \
             only once, at the far point; give --branch far (all lever angles{} are possible)",
            if question.crank > question.ground { "" } else { " between −90° and 90°" },
        ),
        KinematicsError::PinOnPivot => refused!(
            "--crank-angle {}: with {crank}, which is as long as {ground}, the pin is on the lever's pivot, so the lever \
             has no direction; give another angle (all but 180° are possible)",
            as_typed(question.place.degrees())
        ),
        // Lengths that can be typed are possible, and so is their ratio.
        other => other.into(),
    }
}

/// The pin is off the lever's pivot, but not by enough.
fn too_near(question: &QuickReturnQuestion, linkage: &QuickReturn, position: &Position) -> Error {
    let option = match question.place {
        LinkageAngle::Lever(..) => "--lever-angle",
        LinkageAngle::Crank(_) => "--crank-angle",
    };
    refused!(
        "{option} {}: the pin is only {:.1e} crank radii from the lever's pivot, too near to compute the lever's motion; \
         give an angle at which it is at least {NEAREST} crank radii away",
        as_typed(question.place.degrees()),
        position.pin_distance / linkage.crank(),
    )
}
