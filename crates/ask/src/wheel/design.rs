//! A wheel that a question describes: its kind and numbers, its size, its speed, its load.

use super::fitting::Fit;
use super::friction::{friction, locked};
use super::kind::{AnyWheel, WheelKind};
use super::materials::PartMaterials;
use super::mouth::check_mouth;
use super::question::WheelQuestion;
use super::ranges::refuse_out_of_range;
use super::recommended::recommended_crank_radius;
use super::sized::{own_inertia, own_inertia_of_internal, process_numbers, sizes, with_remedies};
use super::times::SAME;
use crate::Error;
use crate::number_format::{as_typed, number, rounded_down, rounded_up};
use crate::worked::DriverSpeed;
use geneva_dynamics::line_contact::LineContact;
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_figures::Figure;
use geneva_figures::stations::dimensions;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{ProcessNumbers, Yield};
use geneva_kinematics::wheel::{CentreTolerance, ClosestApproach, Scale, SharedTolerance, Sizes};
use std::sync::OnceLock;

/// A wheel, and what its question says about it.
#[derive(Debug)]
pub struct WheelDesign {
    /// The question as it was asked: another one with an option changed is a question, too.
    pub question: WheelQuestion,
    /// Speed of the driver, however it was given.
    pub driver_speed: Option<DriverSpeed>,
    /// The wheel; its lengths are in crank radii.
    pub wheel: AnyWheel,
    /// Crank radius in millimetres.
    pub crank_radius: Option<f64>,
    /// Sizes of the parts of an external wheel.
    pub sizes: Option<Sizes>,
    /// Thickness of the wheel in millimetres, if it has a size.
    pub thickness: Option<f64>,
    /// Of what the parts are made.
    pub materials: PartMaterials,
    /// Moment of inertia of the wheel and what turns with it, in kg m².
    pub inertia: Option<f64>,
    /// The wheel's own part of it, if it has a size.
    pub wheel_inertia: Option<f64>,
    /// The part of the table and all else that turns with the wheel, if it is given.
    pub table_inertia: Option<f64>,
    /// The pin on the wall of its slot, if the wheel has a size.
    pub contact: Option<LineContact>,
    /// What takes long to find, once it has been asked for.
    clearance: OnceLock<Option<(ClosestApproach, f64)>>,
    centre_tolerance: OnceLock<Option<CentreTolerance>>,
    pub(super) turning: OnceLock<Option<Yield>>,
    shared_tolerance: OnceLock<Option<Option<SharedTolerance>>>,
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
        refuse_out_of_range(&question, false, &can_be_run)?;
        refuse_contradictions(&question)?;
        check_mouth(&question)?;
        let table_inertia = table_inertia(&question)?;
        let materials = PartMaterials::of(&question);
        let density = materials.wheel.density;
        let mut wanted = question.scale();
        if let (None, AnyWheel::External(external), true) = (wanted, &wheel, question.recommends_size) {
            wanted = Some(Scale::CrankRadius(recommended_crank_radius(external, &question, table_inertia, density)?));
        }
        let sizes = match (&wheel, wanted) {
            (AnyWheel::External(wheel), Some(wanted)) => {
                let fits = |other: &WheelQuestion| {
                    let is_asked = refuse_contradictions(other).and_then(|()| check_mouth(other)).is_ok();
                    let found = sizes(*wheel, other.scale().unwrap_or(wanted), other).ok().filter(|_| is_asked);
                    found.map_or(Fit::Not, |sizes| Fit::of(sizes.has_sound_walls()))
                };
                let sizes = sizes(*wheel, wanted, &question);
                Some(sizes.map_err(|error| with_remedies(error, &question, &fits))?)
            }
            _ => None,
        };
        let driver_speed = driver_speed(&question, &wheel)?;
        let crank_radius = match (sizes, wanted) {
            (Some(sizes), _) => Some(sizes.crank_radius),
            (None, Some(scale)) => Some(crank_radius(&wheel, scale)?),
            (None, None) => None,
        };
        let thickness = sizes.map(|sizes| question.thickness.unwrap_or_else(|| usual_thickness(sizes.pin_diameter)));
        let wheel_inertia = match &wheel {
            AnyWheel::Internal(wheel) => own_inertia_of_internal(*wheel, crank_radius, density, &question)?,
            _ => own_inertia(sizes.as_ref(), thickness, density)?,
        };
        let contact = sizes.zip(thickness).map(|(sizes, thickness)| {
            let (radius, length) = (sizes.pin_radius() / 1000.0, thickness / 1000.0);
            LineContact::new(radius, length, &materials.pin, &materials.wheel)
        });
        let mut design = Self {
            question,
            driver_speed,
            wheel,
            crank_radius,
            sizes,
            thickness,
            materials,
            inertia: None,
            wheel_inertia,
            table_inertia,
            contact: contact.transpose()?,
            clearance: OnceLock::new(),
            centre_tolerance: OnceLock::new(),
            turning: OnceLock::new(),
            shared_tolerance: OnceLock::new(),
        };
        design.wheel_inertia = design.inertia_with_holes().or(wheel_inertia);
        design.inertia = match (design.question.total_inertia, table_inertia, design.wheel_inertia) {
            // A thickness that the program chose is no reason to refuse what was given.
            (Some(all), _, own) => Some(holds_the_wheel(all, own.filter(|_| design.question.thickness.is_some()))?),
            (None, None, None) => None,
            (None, table, own) => Some(table.unwrap_or(0.0) + own.unwrap_or(0.0)),
        };
        design.refuse_too_light_driver()?;
        Ok(design)
    }

    /// The drawing: in true size with dimensions if the parts have sizes, otherwise not to scale.
    pub fn drawing(&self) -> Figure {
        self.sizes.as_ref().map_or_else(|| self.wheel.drawing(), dimensions)
    }

    /// Speed of the driver in rad/s.
    pub fn speed(&self) -> Option<f64> {
        self.driver_speed.map(DriverSpeed::radians_per_second)
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
        let pin = self.pin_radius();
        let rubbing = |question: &WheelQuestion| friction(question, self.crank_radius, pin, self.sizes.as_ref());
        let loads = |friction| WheelLoads::with_friction(wheel, inertia, friction, speed);
        let turns = |other: &WheelQuestion| rubbing(other).is_ok_and(|friction| loads(friction).is_ok());
        let holds = "friction of pin and wheel's bearing holds the wheel against any force of the pin";
        let found = loads(rubbing(&self.question)?);
        found.map(Some).map_err(|error| locked(error, holds, &self.question, turns))
    }

    /// Radius of the pins in millimetres, of an external wheel with a size or an internal one whose parts have sizes.
    fn pin_radius(&self) -> Option<f64> {
        // It counts where the pin rubs.
        let rubs = self.question.pin_friction.is_some_and(|friction| friction > 0.0);
        let of_internal = || self.internal_sizes().ok().flatten().filter(|_| rubs).map(|sizes| sizes.pin_radius());
        self.sizes.map(|sizes| sizes.pin_radius()).or_else(of_internal)
    }

    /// The force in N of a moment over the crank radius, if that is given.
    pub fn force(&self, moment: f64) -> Option<f64> {
        self.crank_radius.map(|radius| moment / (radius / 1000.0))
    }

    /// Speed of the pins on the crank circle in mm/s, if speed and size are given.
    pub fn pin_speed(&self) -> Option<f64> {
        self.speed().zip(self.crank_radius).map(|(speed, radius)| speed * radius)
    }

    /// The pressure in MPa between pin and slot under a force in N, if thickness and materials are given.
    ///
    /// # Errors
    ///
    /// A force below zero.
    pub fn pressure(&self, force: f64) -> Result<Option<f64>, Error> {
        Ok(self.contact.map(|contact| contact.pressure(force)).transpose()?.map(|pressure| pressure / MEGA))
    }

    /// By how much the axes stand too far apart in millimetres.
    pub fn centre_error(&self) -> f64 {
        self.question.centre_error.unwrap_or(0.0)
    }

    /// The numbers of the process by which the parts are made, if one is named and the wheel has a size.
    ///
    /// # Errors
    ///
    /// A measured play that is not above zero.
    pub(super) fn process_numbers(&self) -> Result<Option<ProcessNumbers>, Error> {
        let of_external = self.sizes.map(|sizes| sizes.centre_distance);
        let of_internal = match &self.wheel {
            AnyWheel::Internal(wheel) => self.crank_radius.map(|radius| radius * wheel.centre_distance_ratio()),
            AnyWheel::External(_) | AnyWheel::Spherical(_) => None,
        };
        let of = |distance| process_numbers(&self.question, distance);
        Ok(of_external.or(of_internal).map(of).transpose()?.flatten())
    }

    /// Gap between wheel and plate along the axes in millimetres, if the wheel has a size.
    pub fn axial_play(&self) -> Option<f64> {
        self.sizes.as_ref().map(|sizes| {
            let of_process = self.process_numbers().ok().flatten();
            let chosen = of_process.map_or(sizes.play.slot, |numbers| numbers.axial_play.value);
            self.question.axial_play.unwrap_or(chosen)
        })
    }

    /// Where driver and wheel come nearest over a whole turn, and the tolerance of the distance in millimetres; none without
    /// sizes, or where it would take too long to find.
    ///
    /// # Errors
    ///
    /// A distance of the axes at which the parts can't work together.
    pub fn clearance(&self) -> Result<Option<(ClosestApproach, f64)>, Error> {
        let Some(sizes) = &self.sizes else { return Ok(None) };
        let centres = sizes.centre_distance + self.centre_error();
        let find = || {
            if let Some(refused) = self.refused_centre_error(sizes) {
                return Err(refused);
            }
            in_time(sizes.least_clearance_within(centres, self.question.effort.clearance))
        };
        once(&self.clearance, find)
    }

    /// The refusal of axes so near or so far apart that the parts are not looked at.
    fn refused_centre_error(&self, sizes: &Sizes) -> Option<Error> {
        let (error, [near, far]) = (self.centre_error(), sizes.centre_distances_looked_at());
        let centres = sizes.centre_distance + error;
        (centres <= near || centres > far).then(|| {
            refused!(
                "--centre-error {}: the axes would be {} mm apart, where the parts are not those of one machine; give \
                 --centre-error from {} to {}",
                as_typed(error),
                number(centres),
                rounded_up(NOT_QUITE * (near - sizes.centre_distance)),
                rounded_down(far - sizes.centre_distance)
            )
        })
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
        once(&self.shared_tolerance, || in_time(sizes.shared_tolerance_within(self.question.effort.tolerance)))
    }
}

/// Whether the wheel of a question can be run. How it is mounted is looked at where its parts are listed.
fn can_be_run(question: &WheelQuestion) -> bool {
    WheelDesign::new(question.clone()).is_ok_and(|design| {
        let is_placed = design.sizes.as_ref().is_none_or(|sizes| design.refused_centre_error(sizes).is_none());
        is_placed && design.loads(design.wheel.indexing()).is_ok()
    })
}

/// Of a limit that is refused itself, what is told, dimensionless.
const NOT_QUITE: f64 = 1.0 - 1e-5;
/// Pascals of a megapascal.
const MEGA: f64 = 1e6;

/// A moment of inertia of everything that turns, unless it is less than the wheel's own.
fn holds_the_wheel(all: f64, wheel: Option<f64>) -> Result<f64, Error> {
    let Some(wheel) = wheel.filter(|wheel| all < *wheel) else { return Ok(all) };
    Err(refused!(
        "--total-inertia {}: the wheel alone has {} kg m², so with everything that turns with it, it has more; give that, or give \
         the inertia of the table alone with --inertia",
        as_typed(all),
        rounded_up(wheel)
    ))
}

/// The moment of inertia, in kg m², of what turns with the wheel, in one of the ways to say it.
fn table_inertia(question: &WheelQuestion) -> Result<Option<f64>, Error> {
    match (question.table_mass, question.table_diameter) {
        (Some(mass), Some(diameter)) => {
            let radius = diameter / 2.0 / 1000.0;
            Ok(Some(mass * radius * radius / 2.0))
        }
        (None, None) => Ok(question.inertia),
        (Some(mass), None) => {
            Err(refused!("--table-mass {}: the table's size is missing; add --table-diameter MM", as_typed(mass)))
        }
        (None, Some(diameter)) => {
            Err(refused!("--table-diameter {}: the table's mass is missing; add --table-mass KG", as_typed(diameter)))
        }
    }
}

/// Thickness in millimetres of a wheel of which none is given: as thick as its pin is wide, in whole millimetres if it has one.
fn usual_thickness(pin_diameter: f64) -> f64 {
    if pin_diameter < 1.0 { pin_diameter } else { libm::ceil(pin_diameter) }
}

/// The speed of the driver: the one that is given, or that which the time of an index or of a dwell asks for.
fn driver_speed(question: &WheelQuestion, wheel: &AnyWheel) -> Result<Option<DriverSpeed>, Error> {
    let wheel = wheel.indexing();
    let (time, option, fraction) = match (question.index_time, question.dwell_time) {
        (None, None) => return Ok(question.speed()),
        (Some(time), _) => (time, "index-time", wheel.motion_fraction()),
        (None, Some(time)) => (time, "dwell-time", wheel.dwell_fraction()),
    };
    if fraction <= SAME {
        return Err(refused!(
            "--{option} {}: with {} pins the wheel has no dwell; give fewer --pins, or --index-time",
            as_typed(time),
            wheel.pins()
        ));
    }
    Ok(Some(DriverSpeed::Rpm(60.0 * fraction / (time * f64::from(wheel.pins())))))
}

/// What is found at the first time, and kept.
pub(super) fn once<T: Copy>(kept: &OnceLock<T>, find: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
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

/// Arguments that say the same: of each of these, one is given.
const SAY_THE_SAME: [&[&str]; 5] = [
    &["crank-radius", "centre-distance", "wheel-radius", "outside-diameter"],
    &["rpm", "rad-s", "index-time", "dwell-time"],
    &["inertia", "total-inertia", "table-mass"],
    &["horn", "locking-arc-radius"],
    &["play", "slot-width"],
];

/// Refuses two arguments that say the same.
fn refuse_contradictions(question: &WheelQuestion) -> Result<(), Error> {
    let given = question.numbers();
    for group in SAY_THE_SAME {
        let mut of_group = given.iter().filter(|(argument, _)| group.contains(&argument.name));
        if let (Some((one, value)), Some((other, second))) = (of_group.next(), of_group.next()) {
            return Err(refused!(
                "--{} {} and --{} {} say the same in two ways; leave one of them out",
                one.name,
                as_typed(*value),
                other.name,
                as_typed(*second)
            ));
        }
    }
    Ok(())
}

/// The error of a number that is not finite, by its key.
pub(super) fn too_large(key: &str) -> Error {
    refused!("`{key}` of this wheel is too large or too small to compute with; give other sizes, speeds or inertias",)
}

/// The crank radius in millimetres of a wheel of this scale.
fn crank_radius(wheel: &AnyWheel, scale: Scale) -> Result<f64, Error> {
    Ok(match scale {
        Scale::CrankRadius(radius) => radius,
        Scale::WheelRadius(radius) => radius / wheel.wheel_radius_ratio(),
        Scale::OutsideDiameter(diameter) => {
            return Err(refused!(
                "--outside-diameter {}: only external wheels have parts in mm, and so an outside diameter; give --crank-radius or \
                 --wheel-radius",
                as_typed(diameter)
            ));
        }
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
