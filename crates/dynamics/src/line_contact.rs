//! Pressure between a pin and the flat wall of its slot: two elastic bodies that touch along a line (Hertz).
//!
//! A cylinder of radius R is pressed on a plane with the force F′ per unit of length. With
//! 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂ the greatest pressure is √(F′ E* / (π R)), and the contact is as wide as
//! 4 F′ / (π times that pressure).
//!
//! What the formula leaves out: the ends of the pin, where the pressure of a real edge is higher; friction; oil; blows; a
//! pin that stands askew; wear; and yielding, which begins below the surface ([`pressure_at_yield`]). It is a first look,
//! not a proof of strength.

use crate::error::{DynamicsError, not_negative, positive};
use std::f64::consts::PI;

/// An elastic material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Name of the material, in one word as it is typed.
    pub name: &'static str,
    /// Modulus of elasticity, in Pa.
    pub modulus: f64,
    /// Poisson's ratio, dimensionless.
    pub poisson: f64,
    /// Density, in kg/m³.
    pub density: f64,
    /// Stress in tension at which it yields, or breaks without yielding, in Pa.
    pub strength: f64,
}

/// Some materials of pins and wheels, with values as textbooks, standards and data sheets print them.
///
/// Modulus and Poisson's ratio of the metals: R. G. Budynas and J. K. Nisbett, *Shigley's Mechanical Engineering Design*, table A-5,
/// physical constants of materials. Densities: customary values, in which textbooks differ by about one per cent; that of phosphor
/// bronze is of the alloy C51000 with five per cent of tin (Concast Metal Products, data sheet: 0.320 lb/in³), where Shigley's table
/// has 8 % less. All strengths are of a soft or weak grade, so a better one carries more:
///
/// | material | strength |
/// |---|---|
/// | steel | yield of AISI 1020, hot rolled (Shigley, table A-20) |
/// | stainless steel | least yield of type 304 (ASTM A269) |
/// | cast iron | tensile strength of class 30 (Shigley, table A-24); it doesn't yield, and bears more than three times as much pressure |
/// | phosphor bronze | yield of C51000, annealed (Copper Development Association, alloys.copper.org: 19 ksi) |
/// | hardened steel | a third of the hardness of 513 HV: 50 HRC, the least of a hardened dowel pin (ASME B18.8.2); the third by D. Tabor, *The Hardness of Metals* |
/// | aluminium | least proof stress of EN AW-6061-T6 (EN 755-2) |
///
/// From memory, as we haven't had the tables before us: the two strengths from Shigley's book, strength and modulus of aluminium, the
/// bending of plywood, and that 50 HRC are 513 HV.
///
/// Plastics creep, and with time and heat they get softer. Acetal: J. M. Margolis (ed.), *Engineering Plastics Handbook*, table 5.5,
/// tensile modulus of the homopolymer at room temperature; its strength is 60 MPa, our choice below what data sheets give. Nylon and
/// acrylic: The Mechanical Engineering Handbook (themechanicalengineeringhandbook.com), *Mechanical Properties of Non-Metals*, with the
/// yield strength. PLA: data of a printed bar in its weaker direction (pro3dcomposites.com: 2,539 MPa, 26 MPa at yield, 1.264 g/cm³).
/// PETG: the low ends for a printed bar (additive.tools: 2 GPa, 44 MPa). Across the layers printed parts bear a third less. MDF: what
/// is asked of a general-purpose board over 6 to 9 mm in bending (risunboard.com, *MDF Classification*, table 4, whose row of bending
/// strength has a wrong heading); its density is our choice. Plywood: the low ends for bending (Forest Products Laboratory, *Wood
/// Handbook*, FPL-GTR-190, table 12-1: from 7 GPa and 34 MPa), and the high end of its density, our choice, as it is the safe side of
/// the inertia. Poisson's ratios of acetal, PLA, PETG, MDF and plywood are
/// assumed: from 0.3 to 0.4 the pressure changes by less than 2.5 % to either side.
pub const MATERIALS: [Material; 13] = [
    material("steel", 207e9, 0.292, 7800.0, 210e6),
    material("stainless-steel", 190e9, 0.305, 7750.0, 205e6),
    material("cast-iron", 100e9, 0.211, 7200.0, 214e6),
    material("phosphor-bronze", 111e9, 0.349, 8860.0, 131e6),
    material("acetal", 3.0e9, 0.35, 1420.0, 60e6),
    material("hardened-steel", 207e9, 0.292, 7800.0, 1677e6),
    material("aluminium", 71.7e9, 0.333, 2710.0, 240e6),
    material("nylon", 1.0e9, 0.3, 1150.0, 60e6),
    material("acrylic", 3.0e9, 0.35, 1200.0, 45e6),
    material("pla", 2.54e9, 0.35, 1264.0, 26e6),
    material("petg", 2.0e9, 0.35, 1270.0, 44e6),
    material("mdf", 2.5e9, 0.3, 750.0, 25e6),
    material("plywood", 7.0e9, 0.3, 600.0, 34e6),
];

const fn material(name: &'static str, modulus: f64, poisson: f64, density: f64, strength: f64) -> Material {
    Material { name, modulus, poisson, density, strength }
}

/// A pin on a flat wall.
///
/// ```
/// use geneva_dynamics::line_contact::{LineContact, MATERIALS};
/// use std::f64::consts::PI;
///
/// let (steel, bronze) = (&MATERIALS[0], &MATERIALS[3]);
/// let contact = LineContact::new(0.003, 0.01, steel, bronze)?; // a pin of 3 mm radius, over 10 mm, in m
/// let (pressure, width) = (contact.pressure(200.0)?, contact.width(200.0)?); // under 200 N, in Pa and m
/// // Over the width the pressure is half an ellipse, which carries the force.
/// assert!((PI / 4.0 * pressure * width * 0.01 - 200.0).abs() < 1e-10); // N
/// assert!((contact.pressure(800.0)? / pressure - 2.0).abs() < 1e-14); // it goes as the root of the force
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineContact {
    pin_radius: f64,
    length: f64,
    modulus: f64,
}

/// Modulus E* of the contact of two materials, in Pa: 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂.
///
/// ```
/// use geneva_dynamics::line_contact::{MATERIALS, contact_modulus};
///
/// let steel = &MATERIALS[0];
/// let own = steel.modulus / (1.0 - steel.poisson * steel.poisson); // Pa
/// assert!((contact_modulus(steel, steel) / (own / 2.0) - 1.0).abs() < 1e-15); // two alike are half as stiff
/// ```
pub fn contact_modulus(pin: &Material, wall: &Material) -> f64 {
    let compliance = |of: &Material| (1.0 - of.poisson * of.poisson) / of.modulus;
    (compliance(pin) + compliance(wall)).recip()
}

/// The greatest pressure over the yield stress in uniaxial tension at which a body of this Poisson's ratio begins to yield,
/// dimensionless, by the criterion of von Mises. It begins below the surface.
///
/// Under the middle of the contact, at the depth z in half its width, the principal stresses over the greatest pressure
/// are −1/√(1 + z²) into the body, −((1 + 2 z²)/√(1 + z²) − 2 z) across the contact, and ν times their sum along it.
/// K. L. Johnson, *Contact Mechanics*, section 4.2.
///
/// ```
/// use geneva_dynamics::line_contact::pressure_at_yield;
///
/// // For ν = 0.3 Johnson's book gives 1.8, to two digits.
/// assert!((pressure_at_yield(0.3) - 1.8).abs() < 0.05);
/// ```
pub fn pressure_at_yield(poisson: f64) -> f64 {
    let equivalent = |z: f64| {
        let root = (1.0 + z * z).sqrt();
        let (into, across) = (-1.0 / root, 2.0 * z - (1.0 + 2.0 * z * z) / root);
        let along = poisson * (into + across);
        let squares = [into - across, across - along, along - into].map(|difference| difference * difference);
        (squares.iter().sum::<f64>() / 2.0).sqrt()
    };
    (0..=2000).map(|step| equivalent(f64::from(step) / 1000.0)).fold(0.0, f64::max).recip()
}

/// The greatest pressure in Pa at which neither body begins to yield: of each its strength times
/// [`pressure_at_yield`], and of both the less.
///
/// ```
/// use geneva_dynamics::line_contact::{MATERIALS, pressure_at_yield, pressure_limit};
///
/// let (hardened, acetal) = (&MATERIALS[5], &MATERIALS[4]);
/// let limit = acetal.strength * pressure_at_yield(acetal.poisson); // Pa
/// assert_eq!(pressure_limit(hardened, acetal), limit); // the softer yields first
/// ```
pub fn pressure_limit(pin: &Material, wall: &Material) -> f64 {
    let of = |body: &Material| body.strength * pressure_at_yield(body.poisson);
    of(pin).min(of(wall))
}

impl LineContact {
    /// A pin of this radius that touches a wall over this length, both in metres and above zero.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for other lengths, and for materials whose modulus is not positive.
    pub fn new(pin_radius: f64, length: f64, pin: &Material, wall: &Material) -> Result<Self, DynamicsError> {
        Ok(Self {
            pin_radius: positive("pin radius", pin_radius)?,
            length: positive("length of contact", length)?,
            modulus: positive("modulus of the contact", contact_modulus(pin, wall))?,
        })
    }

    /// Greatest pressure in Pa under this force in N, zero or more.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] for another force.
    pub fn pressure(&self, force: f64) -> Result<f64, DynamicsError> {
        let by_length = not_negative("force", force)? / self.length;
        Ok((by_length * self.modulus / (PI * self.pin_radius)).sqrt())
    }

    /// Width of the contact in metres under this force in N, zero or more: small against the pin, or the formula does not
    /// hold. Twice √(4 F′ R / (π E*)).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] for another force.
    pub fn width(&self, force: f64) -> Result<f64, DynamicsError> {
        let by_length = not_negative("force", force)? / self.length;
        Ok(4.0 * (by_length * self.pin_radius / (PI * self.modulus)).sqrt())
    }
}
