//! Which lengths and angles a slotted lever can have, how far it swings and how its two strokes share a turn.

use crate::error::length;
use crate::{KinematicsError, Turn};
use std::f64::consts::{FRAC_PI_2, PI};

/// A distance from the pivot, in crank radii, that is zero but for rounding: angles of a half or a quarter turn are
/// not exact in floating point, and their sine or cosine is some units in the sixteenth place.
const ON_PIVOT: f64 = 4.0 * f64::EPSILON;

/// A part of one that rounding may take from it when an angle goes from radians to degrees and back.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A crank and a slotted lever on a common ground.
///
/// ```
/// use geneva_kinematics::quick_return::QuickReturn;
/// use std::f64::consts::FRAC_PI_6;
///
/// let mechanism = QuickReturn::new(200.0, 100.0)?; // distance of the axes and crank in mm
/// let strokes = mechanism.strokes();
/// assert!(strokes.swing_limit.is_some_and(|limit| (limit - FRAC_PI_6).abs() < 1e-15)); // sin 30° = 100 / 200
/// assert!((strokes.time_ratio() - 2.0).abs() < 1e-14); // 240° out, 120° back
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuickReturn {
    ground: f64,
    crank: f64,
}

/// Branch of the lever: at which of the two points where its ray meets the crank's circle the pin is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// The point nearer to the lever's pivot: the lever is on its fast stroke.
    Near,
    /// The point farther from the lever's pivot: the lever is on its slow stroke.
    Far,
}

/// Position of crank, lever and pin at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// Crank angle φ.
    pub crank: Turn<f64>,
    /// Lever angle ψ: the direction from the lever's pivot to the pin.
    pub lever: Turn<f64>,
    /// Distance of the pin from the lever's pivot, r, in the unit of the mechanism.
    pub pin_distance: f64,
}

/// How the lever moves while the crank turns once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strokes {
    /// Greatest lever angle in radians if the lever swings to and fro; `None` if it turns round and round.
    pub swing_limit: Option<f64>,
    /// Crank angle of the slow stroke, in radians.
    pub slow: f64,
    /// Crank angle of the fast stroke, in radians.
    pub fast: f64,
}

impl QuickReturn {
    /// A mechanism from the distance of its two axes and the radius of its crank, in one unit of length.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Length`] for a length that is not positive and finite, [`KinematicsError::Ratio`] for two whose
    /// ratio overflows or underflows.
    pub fn new(ground: f64, crank: f64) -> Result<Self, KinematicsError> {
        let (ground, crank) = (length("ground distance", ground)?, length("crank", crank)?);
        let ratio = ground / crank;
        if !(ratio.is_normal() && (ratio * ratio).is_normal()) {
            return Err(KinematicsError::Ratio { ground, crank });
        }
        Ok(Self { ground, crank })
    }

    /// Distance of the two axes, l, in the unit of the mechanism.
    pub fn ground(&self) -> f64 {
        self.ground
    }

    /// Radius of the crank, R, in the unit of the mechanism.
    pub fn crank(&self) -> f64 {
        self.crank
    }

    /// Distance of the axes over the crank's radius, l / R, dimensionless. Above one the lever swings, below one it turns.
    pub fn ratio(&self) -> f64 {
        self.ground / self.crank
    }

    /// The swing of the lever and the crank angles of its two strokes.
    ///
    /// A lever that swings reverses where the crank is at right angles to it, R = l cos of the crank's angle from the
    /// line of centres. A lever that turns is cut into half turns by the perpendicular to the line of centres.
    pub fn strokes(&self) -> Strokes {
        let ratio = self.ratio();
        let (swing_limit, cosine) =
            if ratio >= 1.0 { (Some(libm::asin(1.0 / ratio)), 1.0 / ratio) } else { (None, ratio) };
        let fast = 2.0 * libm::acos(cosine);
        Strokes { swing_limit, slow: 2.0 * PI - fast, fast }
    }

    /// Position of the parts at a crank angle.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::PinOnPivot`] if the pin is on the lever's pivot.
    pub fn position_at_crank(&self, crank: &Turn<f64>) -> Result<Position, KinematicsError> {
        let ratio = self.ratio();
        let (x, y) = (ratio + crank.cos, crank.sin);
        // Without the platform's hypotenuse: lengths in crank radii are of the order of the ratio.
        let distance = libm::hypot(x, y);
        if distance <= ON_PIVOT {
            return Err(KinematicsError::PinOnPivot);
        }
        let lever = Turn { cos: x / distance, sin: y / distance };
        Ok(Position { crank: *crank, lever, pin_distance: distance * self.crank })
    }

    /// Position of the parts at a crank angle in degrees, of any size and sign.
    ///
    /// ```
    /// use geneva_kinematics::quick_return::{Branch, QuickReturn};
    ///
    /// let mechanism = QuickReturn::new(200.0, 100.0)?; // mm
    /// let far = mechanism.position_at_crank_degrees(0.0)?;
    /// assert_eq!((far.pin_distance, far.branch()), (300.0, Branch::Far)); // mm: 200 + 100
    /// let near = mechanism.position_at_crank_degrees(180.0)?;
    /// assert!((near.pin_distance - 100.0).abs() < 1e-12 && near.branch() == Branch::Near); // mm: 200 − 100
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Angle`] if it is not finite, [`KinematicsError::PinOnPivot`] if the pin is on the lever's pivot.
    pub fn position_at_crank_degrees(&self, degrees: f64) -> Result<Position, KinematicsError> {
        if !degrees.is_finite() {
            return Err(KinematicsError::Angle { name: "crank angle", asked: degrees });
        }
        self.position_at_crank(&Turn::from_degrees(degrees % 360.0))
    }

    /// Position of the parts at a lever angle in degrees, on one of the two branches.
    ///
    /// By the law of sines R sin β = l sin ψ, with β the angle at the pin between lever and crank: acute on the far
    /// branch, obtuse on the near one.
    ///
    /// ```
    /// use geneva_kinematics::quick_return::{Branch, QuickReturn};
    ///
    /// let mechanism = QuickReturn::new(200.0, 100.0)?; // mm: the lever swings by 30° to either side
    /// let along = mechanism.position_at_lever_degrees(0.0, Branch::Near)?;
    /// assert!((along.crank.degrees().abs() - 180.0).abs() < 1e-12); // the crank points to the lever's pivot
    /// let [near, far] = [Branch::Near, Branch::Far].map(|branch| mechanism.position_at_lever_degrees(15.0, branch));
    /// // Half-way between the two places of the pin is the foot of the perpendicular from the crank's axis.
    /// let sum = near?.pin_distance + far?.pin_distance; // mm
    /// assert!((sum - 2.0 * 200.0 * 15_f64.to_radians().cos()).abs() < 1e-12);
    /// assert!(mechanism.position_at_lever_degrees(31.0, Branch::Near).is_err());
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Angle`] if the angle is not finite, [`KinematicsError::BeyondTheSwing`] if the lever does not
    /// reach it, [`KinematicsError::OnlyFar`] if there is no near branch.
    pub fn position_at_lever_degrees(&self, degrees: f64, branch: Branch) -> Result<Position, KinematicsError> {
        if !degrees.is_finite() {
            return Err(KinematicsError::Angle { name: "lever angle", asked: degrees });
        }
        let lever = Turn::from_degrees(degrees % 360.0);
        let ratio = self.ratio();
        let height = ratio * lever.sin;
        let half_chord_squared = match (1.0 - height) * (1.0 + height) {
            // The end of the swing, as printed in degrees, is some units in the sixteenth place off.
            beyond if (-ROUNDING..0.0).contains(&beyond) => 0.0,
            square => square,
        };
        let limit = self.strokes().swing_limit.unwrap_or(FRAC_PI_2).to_degrees();
        let beyond = KinematicsError::BeyondTheSwing { asked: degrees, limit, open: ratio <= 1.0 };
        if ratio >= 1.0 && (lever.cos <= 0.0 || half_chord_squared < 0.0) {
            return Err(beyond);
        }
        let half_chord = half_chord_squared.sqrt();
        let middle = ratio * lever.cos;
        // The two distances multiply to k² − 1; the one that would be a difference is taken from that product.
        let product = (ratio - 1.0) * (ratio + 1.0);
        let far = if middle >= 0.0 { middle + half_chord } else { product / (middle - half_chord) };
        let distance = match branch {
            Branch::Far => far,
            Branch::Near if ratio > 1.0 => product / far,
            Branch::Near => return Err(KinematicsError::OnlyFar { asked: degrees }),
        };
        if distance <= ON_PIVOT {
            return Err(beyond);
        }
        let crank = Turn { cos: distance * lever.cos - ratio, sin: distance * lever.sin };
        Ok(Position { crank, lever, pin_distance: distance * self.crank })
    }
}

impl Strokes {
    /// Time of the slow stroke over that of the fast one, at constant crank speed, dimensionless.
    pub fn time_ratio(&self) -> f64 {
        self.slow / self.fast
    }
}

impl Position {
    /// On which branch the pin is: the far one if the angle at the pin between lever and crank is acute.
    pub fn branch(&self) -> Branch {
        let cosine = self.crank.cos * self.lever.cos + self.crank.sin * self.lever.sin;
        if cosine < 0.0 { Branch::Near } else { Branch::Far }
    }

    /// Angle at the pin between lever and crank, β, in radians.
    pub fn angle_at_pin(&self) -> f64 {
        self.lever.reversed().plus(&self.crank).radians().abs()
    }
}
