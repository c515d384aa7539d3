//! Strength of a pin that stands out of the driver's plate and is pressed from the side, and the least pin that bears a load.
//!
//! A pin of diameter d is fast in the plate. The wheel begins at a gap g from the plate and is as thick as the pin's contact is
//! long, L. Its force F is taken as spread evenly over L, so it acts at g + L/2 from the plate. There the pin bears
//!
//! - bending: σ = 32 F (g + L/2) / (π d³), at its surface (J. E. Shigley and others, stress in a beam: M c / I);
//! - shear: τ = (4/3) F / (π d²/4), in its middle (for a round section 4/3 of the mean).
//!
//! Where one is greatest the other is zero, so each is compared with its own limit: the strength for σ, and by the criterion of von
//! Mises the strength over √3 for τ.
//!
//! What the formulas leave out: how the plate holds the pin, whose edge presses more; notches; fatigue, which allows about half as much
//! in steel and less elsewhere; blows; a pin held at both ends, which bears much more; and for short pins, that a beam is meant to be
//! longer than it is thick.

use crate::error::{DynamicsError, not_negative, positive};
use geneva_kinematics::bisection::bisect;
use std::f64::consts::PI;

/// A pin fast at one end.
///
/// ```
/// use geneva_dynamics::pin_strength::Cantilever;
/// use std::f64::consts::PI;
///
/// let pin = Cantilever::new(0.006, 0.01, 0.001)?; // 6 mm thick; 10 mm of it in the slot, 1 mm from the plate, in m
/// assert!((pin.bending(200.0)? / (32.0 * 200.0 * 0.006 / (PI * 0.006_f64.powi(3))) - 1.0).abs() < 1e-14); // 200 N, in Pa
/// assert!(pin.shear(200.0)? < pin.bending(200.0)?); // Pa
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cantilever {
    diameter: f64,
    lever: f64,
}

/// Length of a pin in its slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PinLength {
    /// So long, in metres, whatever the diameter.
    Given(f64),
    /// As long as the pin is thick.
    Diameter,
}

impl PinLength {
    fn of(self, diameter: f64) -> f64 {
        match self {
            Self::Given(length) => length,
            Self::Diameter => diameter,
        }
    }

    fn checked(self) -> Result<Self, DynamicsError> {
        match self {
            Self::Given(length) => positive("length of the pin in its slot", length).map(Self::Given),
            Self::Diameter => Ok(self),
        }
    }
}

impl Cantilever {
    /// A pin of this diameter that is pressed over this length, which begins at this gap from where the pin is fast; all in metres.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for a diameter or a length, and [`DynamicsError::Negative`] for a gap, that is out of range.
    pub fn new(diameter: f64, length: f64, gap: f64) -> Result<Self, DynamicsError> {
        let diameter = positive("pin diameter", diameter)?;
        let half = positive("length of the pin in its slot", length)? / 2.0;
        Ok(Self { diameter, lever: not_negative("gap between plate and wheel", gap)? + half })
    }

    /// Greatest stress of bending in Pa under this force in N, zero or more.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] for another force.
    pub fn bending(&self, force: f64) -> Result<f64, DynamicsError> {
        let cube = self.diameter * self.diameter * self.diameter;
        Ok(32.0 * not_negative("force", force)? * self.lever / (PI * cube))
    }

    /// Greatest shear stress in Pa under this force in N, zero or more.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] for another force.
    pub fn shear(&self, force: f64) -> Result<f64, DynamicsError> {
        Ok(16.0 * not_negative("force", force)? / (3.0 * PI * self.diameter * self.diameter))
    }

    /// How many times this force in N a pin of this strength (Pa) bears: the less of the strength over the bending stress, and the
    /// strength over √3 times the shear stress. Infinite without a force.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] for a negative force, [`DynamicsError::NotPositive`] for a strength that is not above zero.
    pub fn factor(&self, strength: f64, force: f64) -> Result<f64, DynamicsError> {
        let strength = positive("strength of the pin", strength)?;
        Ok(strength / self.bending(force)?.max(3.0_f64.sqrt() * self.shear(force)?))
    }
}

/// Least diameter in m of a pin whose pressure on a flat wall under a force in N stays within `allowed` (Pa); `modulus` is that of the
/// contact (Pa). By [`LineContact`](crate::line_contact::LineContact) the square of the pressure is 2 F E* / (π d L).
///
/// ```
/// use geneva_dynamics::line_contact::{LineContact, MATERIALS, contact_modulus};
/// use geneva_dynamics::pin_strength::{PinLength, least_diameter_for_pressure};
///
/// let (steel, iron) = (&MATERIALS[0], &MATERIALS[2]);
/// let diameter = least_diameter_for_pressure(1000.0, PinLength::Diameter, contact_modulus(steel, iron), 7e8)?; // m
/// let contact = LineContact::new(diameter / 2.0, diameter, steel, iron)?;
/// assert!((contact.pressure(1000.0)? / 7e8 - 1.0).abs() < 1e-14);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::Negative`] for a negative force, [`DynamicsError::NotPositive`] for what is not above zero.
pub fn least_diameter_for_pressure(
    force: f64,
    length: PinLength,
    modulus: f64,
    allowed: f64,
) -> Result<f64, DynamicsError> {
    let allowed = positive("allowed pressure", allowed)?;
    let modulus = positive("modulus of the contact", modulus)?;
    let area = 2.0 * not_negative("force", force)? * modulus / (PI * allowed * allowed);
    Ok(match length.checked()? {
        PinLength::Given(length) => area / length,
        PinLength::Diameter => area.sqrt(),
    })
}

/// Least diameter in m of a pin that bears a force in N in bending and shear with `strength` (Pa) as its limit; `gap` (m) is between
/// plate and wheel. A factor of safety divides the strength.
///
/// ```
/// use geneva_dynamics::pin_strength::{Cantilever, PinLength, least_diameter_for_strength};
///
/// let diameter = least_diameter_for_strength(1000.0, PinLength::Given(0.01), 0.001, 2e8)?; // m
/// assert!((Cantilever::new(diameter, 0.01, 0.001)?.factor(2e8, 1000.0)? - 1.0).abs() < 1e-12);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::Negative`] for a negative force or gap, [`DynamicsError::NotPositive`] for what is not above zero.
pub fn least_diameter_for_strength(
    force: f64,
    length: PinLength,
    gap: f64,
    strength: f64,
) -> Result<f64, DynamicsError> {
    let strength = positive("strength of the pin", strength)?;
    let (force, gap, length) = (not_negative("force", force)?, not_negative("gap", gap)?, length.checked()?);
    if force == 0.0 {
        return Ok(0.0);
    }
    let breaks = |diameter: f64| {
        let pin = Cantilever { diameter, lever: gap + length.of(diameter) / 2.0 };
        pin.factor(strength, force).is_ok_and(|factor| factor < 1.0)
    };
    // Without a gap and with any length, twice the square root of force over strength and the cube root for the lever are enough.
    let lever = gap + if let PinLength::Given(length) = length { length } else { 0.0 };
    let ample = 4.0 * (force / strength).sqrt() + 4.0 * libm::cbrt(force * lever / strength);
    let [_, least] = bisect([0.0, ample], breaks);
    Ok(least)
}
