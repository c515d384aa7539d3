//! A wheel that a question describes: its kind and numbers, its size, its speed, its load.

use super::WheelQuestion;
use super::kind::{AnyWheel, WheelKind};
use crate::Error;
use crate::number_format::{as_typed, rounded_up};
use crate::worked::DriverSpeed;
use geneva_dynamics::line_contact::{LineContact, Material};
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_figures::Figure;
use geneva_figures::stations::dimensions;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{
    CentreTolerance, Choices, ClosestApproach, Play, Remedy, Scale, ShaftOf, SharedTolerance, Sizes, SizesError,
    Warning, Wheel,
};
use std::sync::OnceLock;

/// A wheel, and what its question says about it.
#[derive(Debug)]
pub struct WheelDesign {
    /// The question.
    pub question: WheelQuestion,
    /// The wheel; its lengths are in crank radii.
    pub wheel: AnyWheel,
    /// Crank radius in millimetres.
    pub crank_radius: Option<f64>,
    /// Sizes of the parts of an external wheel.
    pub sizes: Option<Sizes>,
    /// Moment of inertia of the wheel and what turns with it, in kg m².
    pub inertia: Option<f64>,
    /// The wheel's own part of it, if thickness and density are given.
    pub wheel_inertia: Option<f64>,
    /// The pin on the wall of its slot, if thickness and materials are given.
    pub contact: Option<LineContact>,
    /// What takes long to find, once it has been asked for.
    clearance: OnceLock<Option<(ClosestApproach, f64)>>,
    centre_tolerance: OnceLock<Option<CentreTolerance>>,
}

impl WheelDesign {
    /// The wheel that a question describes.
    ///
    /// # Errors
    ///
    /// What is missing or impossible, with the arguments to change.
    pub fn new(question: WheelQuestion) -> Result<Self, Error> {
        let Some(stations) = question.stations else {
            return Err(refused!("the number of stations is missing; give --stations N"));
        };
        let kind = question.kind.unwrap_or(WheelKind::External);
        let wheel = AnyWheel::new(kind, stations, question.pins.unwrap_or(1))?;
        let scale = scale(&question);
        let sizes = match (&wheel, scale) {
            (AnyWheel::External(wheel), Some(scale)) => {
                Some(sizes(*wheel, scale, &question).map_err(|error| with_arguments(error, &question))?)
            }
            _ => None,
        };
        let crank_radius = match (sizes, scale) {
            (Some(sizes), _) => Some(sizes.crank_radius),
            (None, Some(scale)) => Some(crank_radius(&wheel, scale)?),
            (None, None) => None,
        };
        let own = |density| own_inertia(sizes.as_ref(), question.thickness, density);
        let wheel_inertia = question.density.map(own).transpose()?.flatten();
        let inertia = match (wheel_inertia, question.inertia) {
            (Some(wheel), others) => Some(wheel + others.unwrap_or(0.0)),
            (None, all) => all,
        };
        if let (None, Some(all), Some(material)) = (question.density, question.inertia, question.wheel_material) {
            holds_the_wheel(all, own(material.density)?, material)?;
        }
        let contact = match (sizes, question.thickness, question.pin_material, question.wheel_material) {
            (Some(sizes), Some(thickness), Some(pin), Some(wall)) => {
                Some(LineContact::new(sizes.pin_radius() / 1000.0, thickness / 1000.0, &pin, &wall)?)
            }
            _ => None,
        };
        let (clearance, centre_tolerance) = (OnceLock::new(), OnceLock::new());
        Ok(Self { question, wheel, crank_radius, sizes, inertia, wheel_inertia, contact, clearance, centre_tolerance })
    }

    /// The drawing: in true size with dimensions if the parts have sizes, otherwise not to scale.
    pub fn drawing(&self) -> Figure {
        self.sizes.as_ref().map_or_else(|| self.wheel.drawing(), dimensions)
    }

    /// Speed of the driver in rad/s.
    pub fn speed(&self) -> Option<f64> {
        self.question.speed().map(DriverSpeed::radians_per_second)
    }

    /// Times of an index and of a dwell of its wheel in s, if the speed is given.
    ///
    /// The wheel is an argument so that a page for wheels of one kind loads no code for the others.
    ///
    /// # Errors
    ///
    /// A speed that no driver has.
    pub fn times(&self, wheel: &(impl Indexing + ?Sized)) -> Result<Option<[f64; 2]>, Error> {
        let times = |speed| Ok([wheel.indexing_time(speed)?, wheel.dwell_time(speed)?]);
        self.speed().map(times).transpose()
    }

    /// Torques and forces of its wheel, if speed and inertia are given.
    ///
    /// # Errors
    ///
    /// A speed, an inertia or a friction that no wheel has.
    pub fn loads<'w, W: Indexing + ?Sized>(&self, wheel: &'w W) -> Result<Option<WheelLoads<'w, W>>, Error> {
        let (Some(speed), Some(inertia)) = (self.speed(), self.inertia) else { return Ok(None) };
        let friction = self.question.friction_torque.unwrap_or(0.0);
        Ok(Some(WheelLoads::new(wheel, inertia, friction, speed)?))
    }

    /// The force in N of a moment over the crank radius, if that is given.
    pub fn force(&self, moment: f64) -> Option<f64> {
        self.crank_radius.map(|radius| moment / (radius / 1000.0))
    }

    /// Speed of the pins on the crank circle in mm/s, if speed and size are given.
    pub fn pin_speed(&self) -> Option<f64> {
        self.speed().zip(self.crank_radius).map(|(speed, radius)| speed * radius)
    }

    /// Moment of inertia, in kg m², of what turns with the wheel, if it is given and the wheel's own is known besides.
    pub fn table_inertia(&self) -> Option<f64> {
        self.question.inertia.filter(|_| self.wheel_inertia.is_some())
    }

    /// The pressure in MPa between pin and slot under a force in N, if thickness and materials are given.
    ///
    /// # Errors
    ///
    /// A force below zero.
    pub fn pressure(&self, force: f64) -> Result<Option<f64>, Error> {
        Ok(self.contact.map(|contact| contact.pressure(force)).transpose()?.map(|pressure| pressure / MEGA))
    }

    /// What a maker should know about sizes that do fit: also that the play which the program chose is more than a fit has.
    pub fn warnings(&self) -> Vec<Warning> {
        let Some(sizes) = &self.sizes else { return Vec::new() };
        let loose = sizes.looser_than_fit().filter(|_| self.question.play.is_none());
        sizes.warnings().into_iter().chain(loose).collect()
    }

    /// Where driver and wheel come nearest over a whole turn, and the tolerance of the distance in millimetres; none without
    /// sizes, or where it would take too long to find.
    ///
    /// # Errors
    ///
    /// A distance of the axes at which the parts can't work together.
    pub fn clearance(&self) -> Result<Option<(ClosestApproach, f64)>, Error> {
        let Some(sizes) = &self.sizes else { return Ok(None) };
        let centres = sizes.centre_distance + self.question.centre_error;
        let find = || in_time(sizes.least_clearance_within(centres, self.question.effort.clearance));
        once(&self.clearance, find)
    }

    /// By how much the axes may be nearer and farther; none without sizes, or where it would take too long to find.
    ///
    /// # Errors
    ///
    /// A distance of the axes at which the parts can't work together.
    pub fn centre_tolerance(&self) -> Result<Option<CentreTolerance>, Error> {
        let Some(sizes) = &self.sizes else { return Ok(None) };
        once(&self.centre_tolerance, || in_time(sizes.centre_tolerance_within(self.question.effort.tolerance)))
    }

    /// How far all sizes may be wrong together: none if it would take too long to find, and none within it without sizes, without
    /// a disc, or where loose bores or too little play leave no room for errors.
    ///
    /// # Errors
    ///
    /// A distance of the axes at which the parts can't work together.
    pub fn shared_tolerance(&self) -> Result<Option<Option<SharedTolerance>>, Error> {
        let Some(sizes) = &self.sizes else { return Ok(Some(None)) };
        in_time(sizes.shared_tolerance_within(self.question.effort.tolerance))
    }
}

/// Pascals of a megapascal.
const MEGA: f64 = 1e6;

/// Moment of inertia of the wheel alone, in kg m², if size and thickness are given.
fn own_inertia(sizes: Option<&Sizes>, thickness: Option<f64>, density: f64) -> Result<Option<f64>, Error> {
    let outline = sizes.zip(thickness);
    Ok(outline.map(|(sizes, thickness)| sizes.outline().wheel.moment_of_inertia(thickness, density)).transpose()?)
}

/// Refuses a moment of inertia of everything that turns if it is less than the wheel's own.
fn holds_the_wheel(all: f64, wheel: Option<f64>, material: Material) -> Result<(), Error> {
    let Some(wheel) = wheel.filter(|wheel| all < *wheel) else { return Ok(()) };
    let Material { name, density, .. } = material;
    Err(refused!(
        "--inertia {}: a wheel of {name} alone has {} kg m², so with everything that turns with it, it has more; give that, or \
         add --density {} if the wheel is to be added to what you gave",
        as_typed(all),
        rounded_up(wheel),
        as_typed(density)
    ))
}

/// What is found at the first time, and kept.
fn once<T: Copy>(kept: &OnceLock<T>, find: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    match kept.get() {
        Some(found) => Ok(*found),
        None => find().map(|found| *kept.get_or_init(|| found)),
    }
}

/// What was found, if it was found in time.
fn in_time<T>(found: Result<T, KinematicsError>) -> Result<Option<T>, Error> {
    match found {
        Err(KinematicsError::TooManyAngles { .. }) => Ok(None),
        found => Ok(found.map(Some)?),
    }
}

/// The one length that was given.
pub(super) fn scale(question: &WheelQuestion) -> Option<Scale> {
    let crank = question.crank_radius.map(Scale::CrankRadius);
    let centres = question.centre_distance.map(Scale::CentreDistance);
    crank.or(centres).or(question.wheel_radius.map(Scale::WheelRadius))
}

/// What was chosen of the parts.
pub(super) fn choices(question: &WheelQuestion) -> Choices {
    Choices {
        pin_diameter: question.pin_diameter,
        play: question.play.map(Play::from_slot),
        bottom_clearance: question.bottom_clearance,
        horn_thickness: question.horn,
        wheel_shaft: question.wheel_shaft,
        driver_shaft: question.driver_shaft,
        plate_shaft: question.plate_shaft,
    }
}

fn sizes(wheel: Wheel, scale: Scale, question: &WheelQuestion) -> Result<Sizes, SizesError> {
    let choices = choices(question);
    let Some(bore) = question.bore_play else { return Sizes::new(wheel, scale, &choices) };
    // The other play is the one that it has without.
    let others =
        Sizes::new(wheel, scale, &Choices { wheel_shaft: None, driver_shaft: None, plate_shaft: None, ..choices })?;
    Sizes::new(wheel, scale, &Choices { play: Some(Play { bore, ..others.play }), ..choices })
}

/// The error about sizes that don't fit, with the arguments that change them, as they were given.
pub(super) fn with_arguments(error: SizesError, question: &WheelQuestion) -> Error {
    let of = |remedy: &Remedy| match remedy {
        Remedy::ThinnerPin => ("pin-diameter", question.pin_diameter),
        Remedy::ThinnerHorn => ("horn", question.horn),
        Remedy::LessPlay => ("play", question.play),
        Remedy::LessDepth => ("bottom-clearance", question.bottom_clearance),
    };
    let arguments = match error {
        SizesError::DoesNotFit { remedies, .. } => remedies.iter().map(of).collect(),
        SizesError::Shaft { name: ShaftOf::Wheel, .. } => vec![("wheel-shaft", question.wheel_shaft)],
        SizesError::Shaft { name: ShaftOf::Driver, .. } => vec![("driver-shaft", question.driver_shaft)],
        SizesError::Shaft { name: ShaftOf::Plate, .. } => vec![("plate-shaft", question.plate_shaft)],
        SizesError::Kinematics(_) | SizesError::Play { .. } => Vec::new(),
    };
    Error::Sizes { error, arguments }
}

/// The error of numbers that are not finite.
pub(super) fn too_large() -> Error {
    refused!(
        "some number of this wheel is too large or too small to compute with; give other sizes, speeds or inertias",
    )
}

/// The crank radius in millimetres of a wheel of this scale.
fn crank_radius(wheel: &AnyWheel, scale: Scale) -> Result<f64, Error> {
    Ok(match scale {
        Scale::CrankRadius(radius) => radius,
        Scale::WheelRadius(radius) => radius / wheel.wheel_radius_ratio(),
        Scale::CentreDistance(distance) => match wheel.centre_distance_ratio() {
            Some(ratio) => distance / ratio,
            None => {
                return Err(refused!(
                    "--centre-distance {}: the axes of a spherical wheel cross, so there is no distance between them; give \
                     --crank-radius or --wheel-radius instead",
                    as_typed(distance)
                ));
            }
        },
    })
}
