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
}

/// Some materials of pins and wheels, with values as textbooks print them.
///
/// Metals: R. G. Budynas and J. K. Nisbett, *Shigley's Mechanical Engineering Design*, table A-5, physical constants of
/// materials. Acetal: J. M. Margolis (ed.), *Engineering Plastics Handbook*, table 5.5, tensile modulus of the homopolymer
/// at room temperature; it creeps, and with time and heat its modulus falls. That table has no Poisson's ratio: 0.35 is
/// assumed, and from 0.3 to 0.4 the pressure changes by less than 2.5 % to either side. Densities: customary
/// values, in which textbooks differ by about one per cent; that of phosphor bronze is of the alloy C51000 with five per cent of
/// tin (Concast Metal Products, data sheet: 0.320 lb/in³), where Shigley's table has 8 % less.
pub const MATERIALS: [Material; 5] = [
    Material { name: "steel", modulus: 207e9, poisson: 0.292, density: 7800.0 },
    Material { name: "stainless-steel", modulus: 190e9, poisson: 0.305, density: 7750.0 },
    Material { name: "cast-iron", modulus: 100e9, poisson: 0.211, density: 7200.0 },
    Material { name: "phosphor-bronze", modulus: 111e9, poisson: 0.349, density: 8860.0 },
    Material { name: "acetal", modulus: 3.0e9, poisson: 0.35, density: 1420.0 },
];

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
