//! Masses of wheel and driver, and the driver's own moment of inertia.

use super::design::WheelDesign;
use crate::number_format::{as_typed, rounded_up};
use crate::worked::DriverSpeed;
use crate::{Error, Needs, ReportField, Rounding};
use geneva_dynamics::line_contact::Material;
use geneva_workshop::Layer;

/// Millimetres of a metre.
const MILLI: f64 = 1000.0;
/// Cubic metres of a cubic millimetre.
const CUBIC: f64 = 1e-9;

/// Masses of the parts with all their holes, without shafts, screws and dowels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PartMasses {
    /// Mass of the wheel, of an internal one with the plate that closes it, in kg.
    pub wheel: f64,
    /// Mass of locking disc, plate and pins, in kg.
    pub driver: f64,
    /// Moment of inertia of locking disc, plate and pins about the driver's axis, in kg m².
    pub driver_inertia: f64,
}

/// What runs around outermost, and of what it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rim {
    /// Its greatest speed over that of the driver, in m.
    pub reach: f64,
    /// Its material.
    pub material: Material,
}

impl Rim {
    /// Speed of the driver in rad/s at which spinning alone stresses it as much as its material bears. A thin ring has density times rim
    /// speed squared; a disc with a bore has at most that, too.
    pub(super) fn most(&self) -> f64 {
        (self.material.strength / self.material.density).sqrt() / self.reach
    }
}

impl WheelDesign {
    /// The rims of wheel and driver's plate with these radii in mm.
    pub(super) fn rims(&self, wheel: f64, plate: f64) -> [Rim; 2] {
        let peak = self.wheel.indexing().peak_velocity();
        let rim = |reach: f64, material| Rim { reach: reach / MILLI, material };
        [rim(peak * wheel, self.materials.wheel), rim(plate, self.materials.driver)]
    }

    /// Speeds of the driver in turns per minute that the rims of wheel and driver's plate bear; none without a size and a thickness.
    fn rim_limits(&self) -> Option<[f64; 2]> {
        self.made_thickness()?;
        let of_internal =
            || self.internal_sizes().ok().flatten().map(|sizes| [sizes.outside_radius, sizes.plate_radius]);
        let [wheel, plate] = self.sizes.map(|sizes| [sizes.tip_radius, sizes.plate_radius]).or_else(of_internal)?;
        Some(self.rims(wheel, plate).map(|rim| DriverSpeed::RadiansPerSecond(rim.most()).rpm()))
    }

    /// The masses of the parts; none without a size and a thickness, and where they can't be mounted as it is asked for.
    pub(super) fn masses(&self) -> Option<PartMasses> {
        self.made_thickness()?;
        let internal = self.internal_sizes().ok()?;
        let list = self.listed_with(internal.as_ref(), &self.mounting().ok()?)?.ok()?.parts;
        let arm = self.crank_radius? / MILLI;
        let plate = list.iter().find(|part| part.layer == Layer::Plate).map_or(0.0, |part| part.thickness);
        let mut masses = PartMasses { wheel: 0.0, driver: 0.0, driver_inertia: 0.0 };
        for part in &list {
            let pieces = part.quantity() as f64;
            let mass = |density: f64| pieces * part.volume() * CUBIC * density;
            match part.layer {
                Layer::Wheel | Layer::RingPlate => masses.wheel += mass(self.materials.wheel.density),
                Layer::LockingDisc | Layer::LockingSegment | Layer::Plate => {
                    masses.driver += mass(self.materials.driver.density);
                    masses.driver_inertia += pieces * part.moment_of_inertia(self.materials.driver.density);
                }
                Layer::Pins => {
                    // In one piece with the plate they fill its holes, too.
                    let longer = if part.is_joined { 1.0 + plate / part.thickness } else { 1.0 };
                    let density = longer * self.materials.pin.density;
                    masses.driver += mass(density);
                    // About the driver's axis, by the parallel axis theorem.
                    masses.driver_inertia += pieces * part.moment_of_inertia(density) + mass(density) * arm * arm;
                }
                Layer::BasePlate | Layer::Centres | Layer::Pockets | Layer::TestPiece => {}
            }
        }
        Some(masses)
    }

    /// Refuses a moment of inertia of everything that turns with the driver that is less than the driver's own.
    ///
    /// # Errors
    ///
    /// The argument, its value, and the least that the driver has.
    pub(super) fn refuse_too_light_driver(&self) -> Result<(), Error> {
        // A thickness that the program chose is no reason to refuse what was given.
        let Some(given) = self.question.driver_inertia.filter(|_| self.question.thickness.is_some()) else {
            return Ok(());
        };
        match self.masses().filter(|masses| given < masses.driver_inertia) {
            Some(masses) => Err(refused!(
                "--driver-inertia {}: locking disc, plate and pins alone have {} kg m², so with everything that turns with them, they have \
                 more; give that, or a lighter --driver-material or --driver-density",
                as_typed(given),
                rounded_up(masses.driver_inertia)
            )),
            None => Ok(()),
        }
    }
}

/// The fields of the masses, of the driver's own moment of inertia, and of the speeds that the rims bear.
pub(super) fn fields(design: &WheelDesign) -> Vec<ReportField> {
    let masses = design.masses();
    let materials = &design.materials;
    let of = |value: fn(PartMasses) -> f64| masses.map(value);
    let limits = design.rim_limits();
    let rim = |key, part: usize| {
        ReportField::in_unit(key, limits.map(|limits| limits[part]), "rpm").rounded(Rounding::Limit(3))
    };
    let without = "with their holes, without shaft, screws and dowels";
    let driver = if materials.driver == materials.pin {
        format!("of locking disc, plate and pins of {}, {without}", materials.driver.name)
    } else {
        format!("of locking disc and plate of {} and pins of {}, {without}", materials.driver.name, materials.pin.name)
    };
    [
        ReportField::in_unit("wheel_mass_kg", of(|masses| masses.wheel), "kg")
            .line("mass of the wheel", format!("of {}, with its holes, without shaft, screws and dowels", materials.wheel.name)),
        ReportField::in_unit("driver_mass_kg", of(|masses| masses.driver), "kg").line("mass of the driver", driver),
        ReportField::in_unit("driver_own_inertia_kgm2", of(|masses| masses.driver_inertia), "kg m²")
            .line("inertia of the driver", "of the same parts about the driver's axis"),
        rim("wheel_rim_limit_rpm", 0).line(
            "speed limit",
            "of the driver, at which spinning alone stresses the wheel's rim as much as its material bears: density × rim speed²",
        ),
        rim("driver_rim_limit_rpm", 1).line("", "the same of the driver's plate"),
    ]
    .map(|field| field.needing(Needs::SIZE))
    .to_vec()
}
