//! A wheel made from the options: its kind and numbers, its size, its speed, its load.

use super::WheelArguments;
use super::kind::{AnyWheel, Kind};
use crate::typed::as_typed;
use anyhow::{anyhow, bail};
use geneva_dynamics::line_contact::LineContact;
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_figures::Figure;
use geneva_figures::stations::dimensions;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, Play, Remedy, Scale, ShaftOf, Sizes, SizesError};
use std::f64::consts::PI;

/// A wheel, and what the options say about it.
pub struct Made {
    pub wheel: AnyWheel,
    pub rpm: Option<f64>,
    /// Crank radius in millimetres.
    pub crank_radius: Option<f64>,
    /// Sizes of the parts of an external wheel.
    pub sizes: Option<Sizes>,
    /// Moment of inertia of the wheel and what turns with it, in kg m².
    pub inertia: Option<f64>,
    /// The wheel's own part of it, if thickness and density are given.
    pub wheel_inertia: Option<f64>,
    /// In N m.
    pub friction_torque: Option<f64>,
    /// The pin on the wall of its slot, if thickness and materials are given.
    contact: Option<LineContact>,
}

impl Made {
    pub fn new(wanted: &WheelArguments) -> anyhow::Result<Self> {
        let Some(stations) = wanted.stations else { bail!("the number of stations is missing; give --stations N") };
        let kind = wanted.kind.unwrap_or(Kind::External);
        let wheel = AnyWheel::new(kind, stations, wanted.pins.unwrap_or(1))?;
        let scale = scale(wanted);
        let sizes = match (&wheel, scale) {
            (AnyWheel::External(wheel), Some(scale)) => {
                Some(Sizes::new(*wheel, scale, &choices(wanted)).map_err(|error| with_options(&error, wanted))?)
            }
            _ => None,
        };
        let crank_radius = match (sizes, scale) {
            (Some(sizes), _) => Some(sizes.crank_radius),
            (None, Some(scale)) => Some(crank_radius(&wheel, scale)?),
            (None, None) => None,
        };
        let wheel_inertia = match (sizes, wanted.thickness, wanted.density) {
            (Some(sizes), Some(thickness), Some(density)) => {
                Some(sizes.outline().wheel.moment_of_inertia(thickness, density)?)
            }
            _ => None,
        };
        let inertia = match (wheel_inertia, wanted.inertia) {
            (Some(wheel), others) => Some(wheel + others.unwrap_or(0.0)),
            (None, all) => all,
        };
        let contact = match (sizes, wanted.thickness, wanted.pin_material, wanted.wheel_material) {
            (Some(sizes), Some(thickness), Some(pin), Some(wall)) => {
                Some(LineContact::new(sizes.pin_radius() / 1000.0, thickness / 1000.0, &pin, &wall)?)
            }
            _ => None,
        };
        let friction_torque = wanted.friction_torque;
        Ok(Self { wheel, rpm: wanted.rpm, crank_radius, sizes, inertia, wheel_inertia, friction_torque, contact })
    }

    /// The drawing: in true size with dimensions if the parts have sizes, otherwise not to scale.
    pub fn drawing(&self) -> Figure {
        self.sizes.as_ref().map_or_else(|| self.wheel.drawing(), dimensions)
    }

    /// Speed of the driver in rad/s.
    pub fn speed(&self) -> Option<f64> {
        self.rpm.map(|rpm| rpm * PI / 30.0)
    }

    /// Torques and forces, if speed and inertia are given.
    pub fn loads(&self) -> anyhow::Result<Option<WheelLoads<'_, dyn Indexing + '_>>> {
        let (Some(speed), Some(inertia)) = (self.speed(), self.inertia) else { return Ok(None) };
        let friction = self.friction_torque.unwrap_or(0.0);
        Ok(Some(WheelLoads::new(self.wheel.indexing(), inertia, friction, speed)?))
    }

    /// The force in N of a moment over the crank radius, if that is given.
    pub fn force(&self, moment: f64) -> Option<f64> {
        self.crank_radius.map(|radius| moment / (radius / 1000.0))
    }

    /// The pressure in MPa between pin and slot under a force in N, if thickness and materials are given.
    pub fn pressure(&self, force: f64) -> anyhow::Result<Option<f64>> {
        Ok(self.contact.map(|contact| contact.pressure(force)).transpose()?.map(|pressure| pressure / MEGA))
    }
}

/// Pascals of a megapascal.
const MEGA: f64 = 1e6;

/// The one length that was given.
fn scale(wanted: &WheelArguments) -> Option<Scale> {
    let crank = wanted.crank_radius.map(Scale::CrankRadius);
    let centres = wanted.centre_distance.map(Scale::CentreDistance);
    crank.or(centres).or(wanted.wheel_radius.map(Scale::WheelRadius))
}

fn choices(wanted: &WheelArguments) -> Choices {
    Choices {
        pin_diameter: wanted.pin_diameter,
        play: wanted.play.map(Play::of),
        bottom_clearance: wanted.bottom_clearance,
        horn_thickness: wanted.horn,
        wheel_shaft: wanted.wheel_shaft,
        driver_shaft: wanted.driver_shaft,
    }
}

/// The error about sizes that don't fit, with the options that change them, as they were typed.
fn with_options(error: &SizesError, wanted: &WheelArguments) -> anyhow::Error {
    let of = |remedy: &Remedy| match remedy {
        Remedy::ThinnerPin => ("--pin-diameter", wanted.pin_diameter),
        Remedy::ThinnerHorn => ("--horn", wanted.horn),
        Remedy::LessPlay => ("--play", wanted.play),
        Remedy::LessDepth => ("--bottom-clearance", wanted.bottom_clearance),
    };
    let options = match error {
        SizesError::DoesNotFit { remedies, .. } => remedies.iter().map(of).collect(),
        SizesError::Shaft { name: ShaftOf::Wheel, .. } => vec![("--wheel-shaft", wanted.wheel_shaft)],
        SizesError::Shaft { name: ShaftOf::Driver, .. } => vec![("--driver-shaft", wanted.driver_shaft)],
        SizesError::Kinematics(_) | SizesError::Play { .. } => return anyhow!("{error}"),
    };
    let typed =
        |(option, value): &(&str, Option<f64>)| format!("{option} {}", value.map_or_else(|| "MM".to_owned(), as_typed));
    anyhow!("{error} ({})", options.iter().map(typed).collect::<Vec<_>>().join(", "))
}

/// The crank radius in millimetres of a wheel of this scale.
fn crank_radius(wheel: &AnyWheel, scale: Scale) -> anyhow::Result<f64> {
    Ok(match scale {
        Scale::CrankRadius(radius) => radius,
        Scale::WheelRadius(radius) => radius / wheel.wheel_radius_ratio(),
        Scale::CentreDistance(distance) => match wheel.centre_distance_ratio() {
            Some(ratio) => distance / ratio,
            None => bail!(
                "--centre-distance {}: the axes of a spherical wheel cross, so there is no distance between them; give \
                 --crank-radius or --wheel-radius instead",
                as_typed(distance)
            ),
        },
    })
}
