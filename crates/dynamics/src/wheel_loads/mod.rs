//! Loads of a Geneva wheel that a driver of constant speed turns: torques, the pin's force, power, and what friction takes.
//!
//! Notation: θ crank angle from the middle of the engagement, ω driver speed, J moment of inertia of all that turns with
//! the wheel, M constant friction torque on the wheel, v, a, j the wheel's velocity, acceleration and jerk ratios, r the pin's
//! distance from the wheel's axis in crank radii, N the pin's normal force, which stands at right angles to the slot.
//!
//! **Without friction** but for M, the pin must give the wheel the torque T = J ω² a + M. Its force has the arm r about the wheel's
//! axis: N = T / r. What the wheel takes in power the crank gives: its torque is C = T v. The parts are stiff and without play, and
//! the locking disc takes what acts on the wheel in the dwell.
//!
//! **With friction** ([`Friction`]) the pin's surface slides along the wall by s = dr/dθ ± ρ w over the driver's speed, ρ the pin's
//! radius and w how fast it turns in its slot; plus on the wall that drives the wheel, minus on the other. The speed of sliding is
//! known, so friction is too: it is μ |N| against the sliding, at the pin's surface. The wheel's bearing carries N and that friction,
//! |N| √(1 + μ²), and takes b times that, b its coefficient times its radius. So
//!
//! J ω² a + M + b √(1 + μ²) |N| = T = N (r − μ ρ sign s),
//!
//! C = T v + μ |N| |s| + d √(1 + μ²) |N| + M_d,
//!
//! with d for the driver's bearing and M_d for a constant torque on the driver. The sign of N is that of J ω² a + M. It is the model
//! of [`joints`](crate::joints), which derives the arms, at a constant speed. It holds while the pin slides (not for a roller), for
//! balanced parts in a level plane: the weight of a table is in M. Coulomb's law knows no oil and no stick-slip.
//!
//! **Where the greatest are.** The friction is on the side of the inertia while the wheel speeds up and against it while it
//! slows down, so without friction of pin and bearings the greatest torque and the greatest force are in the first half, before the
//! middle; the pin can hold the wheel back in the second half only. The torque's extremes are the acceleration's, in closed form.
//! Those of N and C are roots of dN/dθ and dC/dθ, found by bisection to the last place. There is one root in the first half, but for
//! the crank torque of an internal wheel of three stations, which can have two maxima; so a root is looked for in each of 32
//! parts, and the greatest is taken. With friction of pin or bearings the values have kinks where N or s change their signs; between
//! them the greatest is found by the golden section. The tests compare with a fine scan.

mod drive;
mod friction;
mod search;

pub use drive::{Reflected, RunUp};
pub use friction::{DwellContact, Friction};
pub use search::Peak;

use crate::error::{DynamicsError, not_negative, positive};
use friction::{Place, is_self_locking};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::bisection::bisect;
use geneva_kinematics::indexing::Indexing;
use search::{greatest, greatest_by_section, integral, root};
use std::f64::consts::TAU;

/// The loads at one crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Torque that the pin gives the wheel, in N m, positive in the sense in which the wheel turns.
    pub wheel_torque: f64,
    /// Force of the pin at right angles to the slot times the crank radius, in N m: divided by the crank radius in metres
    /// it is the force in N. Negative where the pin holds the wheel back, with its other side.
    pub pin_moment: f64,
    /// How fast the pin's surface slides outward on the wall that it presses, in crank radii per radian of the crank.
    pub sliding: f64,
    /// Torque at the crank in N m, positive while it drives.
    pub crank_torque: f64,
    /// Power at the crank in the SI's unit of power, N m/s: what the driver gives.
    pub power: f64,
}

/// A load's greatest, and its least if it reverses: the greatest of the other sign.
///
/// ```
/// use geneva_kinematics::indexing::Indexing;
/// use geneva_dynamics::wheel_loads::WheelLoads;
/// use geneva_kinematics::wheel::Wheel;
///
/// // Without friction the pin brakes the wheel as hard as it drove it, and from the line of centres on.
/// let wheel = Wheel::new(6)?;
/// let loads = WheelLoads::new(&wheel, 1e-3, 0.0, 10.0)?; // kg m², N m, rad/s
/// let torque = loads.wheel_torque(); // N m
/// assert!(torque.braking.is_some_and(|braking| braking.value == -torque.driving.value));
/// assert_eq!(loads.reversal(), Some((0.0, wheel.engagement_half_angle()))); // rad
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peaks {
    /// The greatest load while the pin drives the wheel.
    pub driving: Peak,
    /// The greatest load while the pin holds the wheel back; none if it never does.
    pub braking: Option<Peak>,
}

impl Peaks {
    /// The greatest size of the load, whether the pin drives the wheel or holds it back, in N m.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::{Peak, Peaks};
    ///
    /// let peaks = Peaks { driving: Peak { angle: -0.3, value: 5.0 }, braking: Some(Peak { angle: 0.3, value: -6.0 }) };
    /// assert_eq!(peaks.greatest(), 6.0); // with friction in the slot, a pin may press harder as it brakes
    /// ```
    pub fn greatest(&self) -> f64 {
        self.driving.value.abs().max(self.braking.map_or(0.0, |braking| braking.value.abs()))
    }
}

/// A wheel with what it carries, and its driver's speed.
///
/// ```
/// use geneva_kinematics::indexing::Indexing;
/// use geneva_dynamics::wheel_loads::WheelLoads;
/// use geneva_kinematics::wheel::Wheel;
/// use std::f64::consts::PI;
///
/// let wheel = Wheel::new(4)?;
/// let loads = WheelLoads::new(&wheel, 1e-3, 0.5, 10.0)?; // kg m², N m, rad/s
/// // As the pin enters: the inertia asks for J ω² tan 45°, the friction for 0.5 N m.
/// let entry = loads.load(-wheel.engagement_half_angle())?;
/// assert!((entry.wheel_torque - (1e-3 * 10.0 * 10.0 + 0.5)).abs() < 1e-12); // N m
/// assert!(entry.power.abs() < 1e-12); // N m/s: the wheel is still at rest
/// // On the line of centres only friction is left, and the pin is √2 − 1 crank radii from the wheel's axis.
/// assert!((loads.load(0.0)?.pin_moment - 0.5 / (2_f64.sqrt() - 1.0)).abs() < 1e-12); // N m
/// // Over an index the inertia gives back what it took; friction takes its torque times a quarter of a turn.
/// assert!((loads.work() - 0.5 * PI / 2.0).abs() < 1e-12); // N m
/// assert_eq!(loads.mean_crank_torque(), 0.5 / 4.0); // N m
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct WheelLoads<'w, W: Indexing + ?Sized> {
    wheel: &'w W,
    inertia: f64,
    inertia_torque: f64,
    friction: Friction,
    driver_speed: f64,
}

impl<'w, W: Indexing + ?Sized> WheelLoads<'w, W> {
    /// A wheel whose moment of inertia with all that turns with it is `inertia` (kg m², zero or more), on which friction
    /// acts with a torque of `friction_torque` (N m, zero or more), driven at `driver_speed` (rad/s, above zero).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] and [`DynamicsError::NotPositive`] for other values, and for what is not finite.
    pub fn new(wheel: &'w W, inertia: f64, friction_torque: f64, driver_speed: f64) -> Result<Self, DynamicsError> {
        Self::with_friction(wheel, inertia, Friction::of_wheel(friction_torque), driver_speed)
    }

    /// A wheel as of [`new`](Self::new), with everything that rubs.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::{Friction, WheelLoads};
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// let pin = Friction { pin: 0.2, ..Friction::of_wheel(1.0) }; // a pin that is a point
    /// let loads = WheelLoads::with_friction(&wheel, 0.0, pin, 10.0)?; // no inertia, at 10 rad/s
    /// // As the pin enters, it slides along the slot at its whole speed. It presses with 1 N m over the wheel's radius of √3.
    /// let entry = loads.load(-wheel.engagement_half_angle())?;
    /// assert!((entry.crank_torque - 0.2 / 3_f64.sqrt()).abs() < 1e-12); // N m
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new), for negative frictions too; [`DynamicsError::PinTooThick`]; and [`DynamicsError::SelfLocking`] if
    /// friction can hold the wheel against any force of the pin.
    pub fn with_friction(
        wheel: &'w W,
        inertia: f64,
        friction: Friction,
        driver_speed: f64,
    ) -> Result<Self, DynamicsError> {
        let speed = positive("driver speed", driver_speed)?;
        let inertia_torque = not_negative("moment of inertia", inertia)? * speed * speed;
        let inertia_torque = not_negative("inertia times the square of the driver speed", inertia_torque)?;
        let friction = friction.checked()?;
        let radius = |crank: f64| wheel.pin_in_slot(crank).map_or(0.0, |pin| pin.radius);
        let lever = radius(0.0).min(radius(wheel.engagement_half_angle()));
        let taken = friction.pin * friction.pin_radius + friction.wheel_bearing * friction.bearing_factor();
        if is_self_locking(taken, lever) && taken > 0.0 {
            return Err(DynamicsError::SelfLocking { taken, lever });
        }
        Ok(Self { wheel, inertia, inertia_torque, friction, driver_speed: speed })
    }

    /// What rubs.
    pub fn friction(&self) -> Friction {
        self.friction
    }

    /// The loads at a crank angle in radians from the middle of the engagement.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] for an angle at which no pin is in a slot: the locking disc holds the wheel,
    /// and the driver turns free.
    pub fn load(&self, crank: f64) -> Result<Load, KinematicsError> {
        let (place, acceleration) = self.place(crank)?;
        let friction = &self.friction;
        let demand = self.inertia_torque * acceleration + friction.wheel_torque;
        let flank = if demand < 0.0 { -1.0 } else { 1.0 };
        let factor = friction.bearing_factor();
        let pin_moment = demand / friction.arms(&place, flank)[0];
        let size = pin_moment.abs();
        let wheel_torque = demand + friction.wheel_bearing * factor * size;
        let sliding = place.sliding(friction.pin_radius, flank);
        let rubbing = size * (friction.pin * sliding.abs() + friction.driver_bearing * factor);
        let crank_torque = wheel_torque * place.velocity + rubbing + friction.driver_torque;
        Ok(Load { wheel_torque, pin_moment, sliding, crank_torque, power: crank_torque * self.driver_speed })
    }

    /// Where the pin is, and the wheel's acceleration ratio.
    fn place(&self, crank: f64) -> Result<(Place, f64), KinematicsError> {
        let (motion, pin) = (self.wheel.engaged(crank)?, self.wheel.pin_in_slot(crank)?);
        let (radius, radius_rate, turning) = (pin.radius, pin.radius_rate, pin.turning);
        Ok((Place { radius, radius_rate, turning, velocity: motion.velocity }, motion.acceleration))
    }

    /// Greatest torque on the wheel while the pin drives it, and while it holds it back, in N m.
    pub fn wheel_torque(&self) -> Peaks {
        if self.friction.wheel_bearing > 0.0 {
            return self.searched(|load| load.wheel_torque);
        }
        let peak = self.wheel.acceleration_peak();
        let of = |sense: f64| Peak {
            angle: sense * peak.angle,
            value: self.friction.wheel_torque - sense * self.inertia_torque * peak.ratio,
        };
        Peaks { driving: of(-1.0), braking: Some(of(1.0)).filter(|least| least.value < 0.0) }
    }

    /// Greatest force of the pin times the crank radius, driving and braking, in N m: see [`Load::pin_moment`].
    pub fn pin_moment(&self) -> Peaks {
        if self.friction.is_constant() {
            self.peaks(|load| load.pin_moment, |crank| self.pin_moment_rate(crank))
        } else {
            self.searched(|load| load.pin_moment)
        }
    }

    /// Greatest torque at the crank in an index, driving and braking, in N m. Times the driver speed it is the power. In the dwell
    /// it is [`dwell_crank_torque`](Self::dwell_crank_torque).
    pub fn crank_torque(&self) -> Peaks {
        if self.friction.is_constant() && self.friction.driver_torque == 0.0 {
            self.peaks(|load| load.crank_torque, |crank| self.crank_torque_rate(crank))
        } else {
            self.searched(|load| load.crank_torque)
        }
    }

    /// Torque at the crank in the dwell, in N m: what the locking disc and the driver's own friction take.
    pub fn dwell_crank_torque(&self) -> f64 {
        self.friction.driver_torque + self.friction.dwell_torque
    }

    /// Greatest speed of the pin's surface on the wall of its slot over the crank radius, in rad/s, and the greatest product of that
    /// speed and the pin's force times the crank radius, in the SI's unit of power, N m/s.
    pub fn greatest_sliding(&self) -> [Peak; 2] {
        let of = |of: fn(&Load) -> f64| {
            let value = |crank: f64| self.load(crank).map_or(0.0, |load| of(&load) * self.driver_speed);
            greatest_by_section(value, &self.kinks())
        };
        [of(|load| load.sliding.abs()), of(|load| (load.sliding * load.pin_moment).abs())]
    }

    /// Greatest power that the driver gives, in the SI's unit of power, N m/s: its torque's peak times its speed.
    pub fn peak_power(&self) -> f64 {
        self.crank_torque().driving.value * self.driver_speed
    }

    /// Crank angles between which the pin holds the wheel back, in radians: at the first it changes from one side of the
    /// slot to the other, at the second it changes back or leaves. `None` where friction brakes the wheel enough.
    pub fn reversal(&self) -> Option<(f64, f64)> {
        let (peak, end) = (self.wheel.acceleration_peak(), self.wheel.engagement_half_angle());
        let held = self.friction.wheel_torque;
        if self.inertia_torque * peak.ratio <= held {
            return None;
        }
        let demand =
            |crank: f64| self.wheel.engaged(crank).map_or(0.0, |at| self.inertia_torque * at.acceleration + held);
        let from = if held > 0.0 { root(demand, 0.0, peak.angle) } else { 0.0 };
        let until = if demand(end) > 0.0 { root(|crank| -demand(crank), peak.angle, end) } else { end };
        Some((from, until))
    }

    /// Mean torque at the crank over the driver's turn, in N m: what friction takes. Of a friction M on the wheel alone it is M times
    /// the stations passed over N.
    pub fn mean_crank_torque(&self) -> f64 {
        let (friction, pins) = (&self.friction, f64::from(self.wheel.pins()));
        if friction.is_constant() {
            let of_wheel = friction.wheel_torque * pins / f64::from(self.wheel.stations());
            return of_wheel + friction.driver_torque + friction.dwell_torque * self.wheel.dwell_fraction();
        }
        self.work() * pins / TAU + self.dwell_crank_torque() * self.wheel.dwell_fraction()
    }

    /// Root of the mean square of the torque at the crank over the driver's turn, in N m: what heats a motor.
    ///
    /// By the Gauss-Legendre rule of sixteen nodes on subintervals that are doubled until the result changes by less than
    /// a relative 10⁻¹³.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::WheelLoads;
    /// use geneva_kinematics::indexing::Indexing;
    /// use geneva_kinematics::spherical_wheel::SphericalWheel;
    ///
    /// // With many stations the wheel moves as a Scotch yoke: M tan α cos θ over half of the turn, whose RMS is M tan α / 2.
    /// let wheel = SphericalWheel::new(1000)?;
    /// let loads = WheelLoads::new(&wheel, 0.0, 2.0, 10.0)?; // no inertia, 2 N m of friction, 10 rad/s
    /// assert!((loads.rms_crank_torque() / wheel.peak_velocity() - 1.0).abs() < 1e-4); // N m
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn rms_crank_torque(&self) -> f64 {
        let square = self.integral(|load| load.crank_torque * load.crank_torque);
        let dwell = self.dwell_crank_torque();
        (square * f64::from(self.wheel.pins()) / TAU + dwell * dwell * self.wheel.dwell_fraction()).sqrt()
    }

    /// Work of the crank on the wheel over one index, in N m: the torque at the crank, integrated as in
    /// [`rms_crank_torque`](Self::rms_crank_torque).
    pub fn work(&self) -> f64 {
        self.integral(|load| load.crank_torque)
    }

    /// The greatest in the first half, and the least where the pin holds the wheel back.
    fn peaks(&self, of: fn(&Load) -> f64, rate: impl Fn(f64) -> f64) -> Peaks {
        let value = |crank: f64| self.load(crank).map_or(0.0, |load| of(&load));
        let driving = greatest(value, &rate, -self.wheel.engagement_half_angle(), 0.0);
        let braking = self.reversal().map(|(from, until)| {
            let peak = greatest(|crank| -value(crank), |crank| -rate(crank), from, until);
            Peak { value: -peak.value, ..peak }
        });
        Peaks { driving, braking }
    }

    /// The greatest and the least of what has kinks.
    fn searched(&self, of: fn(&Load) -> f64) -> Peaks {
        let (pieces, value) = (self.pieces(), |crank: f64| self.load(crank).map_or(0.0, |load| of(&load)));
        let least = greatest_by_section(|crank| -value(crank), &pieces);
        let braking = Some(Peak { value: -least.value, ..least }).filter(|least| least.value < 0.0);
        Peaks { driving: greatest_by_section(value, &pieces), braking }
    }

    /// Crank angles in radians, rising, between which every load is smooth.
    fn pieces(&self) -> Vec<f64> {
        let end = self.wheel.engagement_half_angle();
        if self.friction.is_constant() { vec![-end, end] } else { self.kinks() }
    }

    /// Both ends of the engagement in radians, and where the pin changes sides or the sliding of its surface its sense.
    fn kinks(&self) -> Vec<f64> {
        let end = self.wheel.engagement_half_angle();
        let sliding =
            |crank: f64| self.place(crank).map_or(0.0, |(place, _)| place.sliding(self.friction.pin_radius, 1.0));
        // On the line of centres the centre of the pin doesn't slide, so the sign is that of the turning.
        let turned = sliding(0.0);
        let mut pieces = vec![-end, 0.0, end];
        if turned != 0.0 {
            let [before, after] = bisect([-end, 0.0], |crank| sliding(crank) * turned < 0.0);
            let at = f64::midpoint(before, after);
            pieces.extend([at, -at]);
        }
        pieces.extend(self.reversal().into_iter().flat_map(<[f64; 2]>::from));
        pieces.sort_by(f64::total_cmp);
        pieces.dedup();
        pieces
    }

    /// r³ times the rate of T / r: r² dT/dθ − T r dr/dθ, of the same sign.
    fn pin_moment_rate(&self, crank: f64) -> f64 {
        let (Ok(motion), Ok(pin)) = (self.wheel.engaged(crank), self.wheel.pin_in_slot(crank)) else { return 0.0 };
        let torque = self.inertia_torque * motion.acceleration + self.friction.wheel_torque;
        pin.radius * (pin.radius * self.inertia_torque * motion.jerk - torque * pin.radius_rate)
    }

    /// The rate of T v.
    fn crank_torque_rate(&self, crank: f64) -> f64 {
        let Ok(motion) = self.wheel.engaged(crank) else { return 0.0 };
        let torque = self.inertia_torque * motion.acceleration + self.friction.wheel_torque;
        self.inertia_torque * motion.jerk * motion.velocity + torque * motion.acceleration
    }

    /// The integral over one engagement, in the unit of the values.
    fn integral(&self, of: impl Fn(&Load) -> f64) -> f64 {
        let value = |crank: f64| self.load(crank).map_or(0.0, |load| of(&load));
        let size = (self.inertia_torque + self.friction.wheel_torque) * self.wheel.peak_velocity();
        integral(value, &self.pieces(), size)
    }
}
