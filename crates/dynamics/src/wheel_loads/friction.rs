//! What rubs in a Geneva wheel and its driver, and what it takes.

use crate::error::{DynamicsError, not_negative};

/// All friction of a wheel and its driver, by Coulomb's law: a force as large as the coefficient times the normal force, whatever
/// the speed.
///
/// Lengths are in crank radii, so that a normal force times the crank radius gives a moment.
///
/// ```
/// use geneva_dynamics::wheel_loads::{Friction, WheelLoads};
/// use geneva_kinematics::wheel::Wheel;
///
/// let wheel = Wheel::new(6)?;
/// let (inertia, speed) = (2e-3, 6.0); // kg m² and rad/s
/// let table = Friction::of_wheel(0.1); // N m
/// let pin = Friction { pin: 0.15, pin_radius: 0.1, ..table };
/// let mean = |friction| Ok::<_, Box<dyn std::error::Error>>(WheelLoads::with_friction(&wheel, inertia, friction, speed)?.mean_crank_torque());
/// assert!(mean(pin)? > 1.1 * mean(table)?); // a pin that rubs takes a tenth more, and even more
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// M, a constant torque against the wheel's rotation, in N m: a table's bearing under its weight, a seal, a brake.
    pub wheel_torque: f64,
    /// μ, coefficient of friction of a pin in its slot, dimensionless.
    pub pin: f64,
    /// ρ, radius of a pin that is fast to the driver, in crank radii; zero to below 1. Zero leaves out that the pin turns in its
    /// slot.
    pub pin_radius: f64,
    /// Coefficient of friction of the wheel's bearing times the radius at which it rubs, in crank radii. The bearing carries
    /// the force of the pin.
    pub wheel_bearing: f64,
    /// Coefficient of friction of the driver's bearing times the radius at which it rubs, in crank radii. The bearing carries
    /// the force of the pin.
    pub driver_bearing: f64,
    /// A constant torque against the driver's rotation over its whole turn, in N m.
    pub driver_torque: f64,
    /// What else the locking disc takes of the driver in the dwell, in N m: see [`DwellContact`].
    pub dwell_torque: f64,
}

impl Friction {
    /// Nothing rubs.
    pub const NONE: Self = Self {
        wheel_torque: 0.0,
        pin: 0.0,
        pin_radius: 0.0,
        wheel_bearing: 0.0,
        driver_bearing: 0.0,
        driver_torque: 0.0,
        dwell_torque: 0.0,
    };

    /// Nothing rubs but a constant torque against the wheel's rotation, in N m.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::Friction;
    ///
    /// assert_eq!(Friction::of_wheel(0.0), Friction::NONE);
    /// assert_eq!(Friction::of_wheel(0.5).wheel_torque, 0.5); // N m
    /// ```
    pub const fn of_wheel(torque: f64) -> Self {
        Self { wheel_torque: torque, ..Self::NONE }
    }

    /// All friction, if every part of it is possible.
    pub(super) fn checked(self) -> Result<Self, DynamicsError> {
        for (name, asked) in [
            ("friction torque", self.wheel_torque),
            ("coefficient of friction of the pin", self.pin),
            ("pin radius", self.pin_radius),
            ("friction of the wheel's bearing", self.wheel_bearing),
            ("friction of the driver's bearing", self.driver_bearing),
            ("friction torque on the driver", self.driver_torque),
            ("friction torque of the locking disc", self.dwell_torque),
        ] {
            not_negative(name, asked)?;
        }
        if self.pin_radius < 1.0 { Ok(self) } else { Err(DynamicsError::PinTooThick { asked: self.pin_radius }) }
    }

    /// Whether the friction of no part depends on the pin's force.
    pub(super) fn is_constant(&self) -> bool {
        self.pin == 0.0 && self.wheel_bearing == 0.0 && self.driver_bearing == 0.0
    }

    /// √(1 + μ²): the force that a bearing carries over the pin's normal force.
    pub(super) fn bearing_factor(&self) -> f64 {
        (1.0 + self.pin * self.pin).sqrt()
    }

    /// λ and κ at a place: the arms, in crank radii, of the pin's normal force N about the wheel's axis, with what the wheel's
    /// bearing takes, and about the driver's, with what the pin and the driver's bearing take. The first times N moves the
    /// wheel, the second times N the driver must give.
    pub(super) fn arms(&self, place: &Place, flank: f64) -> [f64; 2] {
        let sliding = place.sliding(self.pin_radius, flank);
        let way = if sliding == 0.0 { 0.0 } else { sliding.signum() };
        let contact = place.radius - self.pin * self.pin_radius * way;
        let factor = self.bearing_factor();
        let wheel = contact - flank * self.wheel_bearing * factor;
        let driver = contact * place.velocity + flank * (self.pin * sliding.abs() + self.driver_bearing * factor);
        [wheel, driver]
    }
}

/// The part of a lever that is rounding: what is left of it is none.
const ROUNDING: f64 = 1e-12;

/// Whether friction takes all of a lever, both in the same unit: a rest that is only rounding would give forces without end.
pub(super) fn is_self_locking(taken: f64, lever: f64) -> bool {
    taken >= lever * (1.0 - ROUNDING)
}

/// Place and rates of a pin in its slot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// r, distance from the wheel's axis, in crank radii.
    pub radius: f64,
    /// dr/dθ, in crank radii per radian.
    pub radius_rate: f64,
    /// How fast the pin turns in its slot, over the driver's speed, dimensionless.
    pub turning: f64,
    /// v, the wheel's velocity ratio, dimensionless.
    pub velocity: f64,
}

impl Place {
    /// How fast the pin's surface slides outward on the wall of this flank (1 or −1), in crank radii per radian.
    pub(super) fn sliding(&self, pin_radius: f64, flank: f64) -> f64 {
        self.radius_rate + flank * pin_radius * self.turning
    }
}

/// The locking disc in an arc of the wheel while a torque on the wheel presses them together.
///
/// A torque L on the wheel turns it through its play until an end of the arc rests on the disc. There the disc pushes with a force
/// D, straight away from the driver's axis: the arm of D about the wheel's axis is c sin β, c the centre distance and β the angle of the
/// arc's end from the line of centres, seen from the driver, with the wheel so turned. The end is then on the disc and on the rim of the
/// wheel, whose radius is R: cos β = (c² + r² − R²)/(2 c r). As drawn, it is the play of one side farther from the driver. The disc rubs with μ D; the arm of that about the wheel's axis is
/// c cos β − r, r the disc's radius. If the friction drives the wheel on, D (c sin β − μ (c cos β − r)) = L. The driver needs
/// μ D r, and what its bearing takes: its friction arm times D √(1 + μ²).
///
/// The end of the arc rests on the disc in the middle part of the dwell only. The number is taken for the whole dwell, and for the
/// sense of L in which it is greater.
///
/// ```
/// use geneva_dynamics::wheel_loads::DwellContact;
/// use std::f64::consts::FRAC_PI_6;
///
/// let disc = DwellContact { centre_distance: 0.05, radius: 0.02, end_angle: FRAC_PI_6, friction: 0.0 }; // m and rad
/// assert_eq!(disc.force(1.0)?, 1.0 / (0.05 * FRAC_PI_6.sin())); // N: under 1 N m, at an arm of 25 mm
/// assert_eq!(disc.driver_torque(1.0, 0.0)?, 0.0); // nothing rubs
/// assert!(DwellContact { friction: 0.15, ..disc }.driver_torque(1.0, 0.0)? > 0.15 * 0.02 * disc.force(1.0)?); // N m
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DwellContact {
    /// c, distance between the axes, in metres.
    pub centre_distance: f64,
    /// r, radius of the disc, in metres.
    pub radius: f64,
    /// β, angle from the line of centres, seen from the driver's axis, of the end of a locking arc that rests on the disc, in radians.
    pub end_angle: f64,
    /// μ, coefficient of friction of disc and arc, dimensionless.
    pub friction: f64,
}

impl DwellContact {
    /// Force in N with which the end of an arc presses on the disc under a torque on the wheel, in N m.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] for a torque or a friction below zero; [`DynamicsError::SelfLocking`] where the friction of the
    /// disc would draw the arc in, whatever the torque. Its arms are in m.
    pub fn force(&self, torque: f64) -> Result<f64, DynamicsError> {
        not_negative("torque on the wheel in the dwell", torque)?;
        not_negative("coefficient of friction of the locking disc", self.friction)?;
        let (sin, cos) = (libm::sin(self.end_angle), libm::cos(self.end_angle));
        let lever = self.centre_distance * sin;
        let taken = self.friction * (self.centre_distance * cos - self.radius);
        if is_self_locking(taken, lever) {
            return Err(DynamicsError::SelfLocking { taken, lever });
        }
        Ok(torque / (lever - taken))
    }

    /// Torque in N m that the driver needs in the dwell under a torque on the wheel, in N m, if its bearing's coefficient of
    /// friction times the radius at which it rubs is `bearing`, in m.
    ///
    /// # Errors
    ///
    /// As for [`force`](Self::force), and a bearing below zero.
    pub fn driver_torque(&self, torque: f64, bearing: f64) -> Result<f64, DynamicsError> {
        let bearing = not_negative("friction of the driver's bearing", bearing)?;
        let factor = (1.0 + self.friction * self.friction).sqrt();
        Ok(self.force(torque)? * (self.friction * self.radius + bearing * factor))
    }
}
