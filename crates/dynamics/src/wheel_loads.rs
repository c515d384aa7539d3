//! Loads of a Geneva wheel that a driver of constant speed turns: torques, the pin's force, power.
//!
//! Notation: θ crank angle from the middle of the engagement, ω driver speed, J moment of inertia of all that turns with
//! the wheel, M friction torque on the wheel, v, a, j the wheel's velocity, acceleration and jerk ratios, r the pin's
//! distance from the wheel's axis in crank radii.
//!
//! The pin must give the wheel the torque T = J ω² a + M. Its force stands at right angles to the slot and has the arm r
//! about the wheel's axis: F = T / r. What the wheel takes in power the crank gives: its torque is C = T v. The pin has no
//! friction, the parts are stiff and without play, and the locking disc takes what acts on the wheel in the dwell.
//!
//! **Where the greatest are.** The friction is on the side of the inertia while the wheel speeds up and against it while it
//! slows down, so the greatest torque and the greatest force are in the first half, before the middle; the pin can hold
//! the wheel back in the second half only. The torque's extremes are the acceleration's, in closed form. Those of F and C
//! are roots of dF/dθ and dC/dθ, found by bisection to the last place. There is one root in the first half, but for the
//! crank torque of an internal wheel of three stations, which can have two maxima; so a root is looked for in each of 32
//! parts, and the greatest is taken. The tests compare with a fine scan.

use crate::error::{DynamicsError, not_negative, positive};
use crate::steady::quadrature::rule;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::bisection::bisect;
use geneva_kinematics::indexing::Indexing;
use std::f64::consts::TAU;

/// An end of an interval is judged this part of it inside: on the very end some rates vanish.
const INSIDE: f64 = 1e-6;
/// Relative change on doubling the subintervals at which an integral is settled, dimensionless.
const SETTLED: f64 = 1e-13;
/// How often they are doubled at most.
const MOST_DOUBLINGS: u32 = 12;
/// Parts of an interval in each of which an extreme is looked for.
const PARTS: u32 = 32;

/// The loads at one crank angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Torque that the pin gives the wheel, in N m, positive in the sense in which the wheel turns.
    pub wheel_torque: f64,
    /// Force of the pin at right angles to the slot times the crank radius, in N m: divided by the crank radius in metres
    /// it is the force in N. Negative where the pin holds the wheel back, with its other side.
    pub pin_moment: f64,
    /// Torque at the crank in N m, positive while it drives.
    pub crank_torque: f64,
    /// Power at the crank in the SI's unit of power, N m/s: what the driver gives.
    pub power: f64,
}

/// A greatest or least load, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Crank angle in radians from the middle of the engagement.
    pub angle: f64,
    /// The load there, in its own unit.
    pub value: f64,
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
    inertia_torque: f64,
    friction_torque: f64,
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
        let speed = positive("driver speed", driver_speed)?;
        let inertia_torque = not_negative("moment of inertia", inertia)? * speed * speed;
        Ok(Self {
            wheel,
            inertia_torque: not_negative("inertia times the square of the driver speed", inertia_torque)?,
            friction_torque: not_negative("friction torque", friction_torque)?,
            driver_speed: speed,
        })
    }

    /// The loads at a crank angle in radians from the middle of the engagement.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] for an angle at which no pin is in a slot: the locking disc holds the wheel,
    /// and the driver turns free.
    pub fn load(&self, crank: f64) -> Result<Load, KinematicsError> {
        let (motion, pin) = (self.wheel.engaged(crank)?, self.wheel.pin_in_slot(crank)?);
        let wheel_torque = self.inertia_torque * motion.acceleration + self.friction_torque;
        let crank_torque = wheel_torque * motion.velocity;
        let (pin_moment, power) = (wheel_torque / pin.radius, crank_torque * self.driver_speed);
        Ok(Load { wheel_torque, pin_moment, crank_torque, power })
    }

    /// Greatest torque on the wheel while the pin drives it, and while it holds it back, in N m.
    pub fn wheel_torque(&self) -> Peaks {
        let peak = self.wheel.acceleration_peak();
        let of = |sense: f64| Peak {
            angle: sense * peak.angle,
            value: self.friction_torque - sense * self.inertia_torque * peak.ratio,
        };
        Peaks { driving: of(-1.0), braking: Some(of(1.0)).filter(|least| least.value < 0.0) }
    }

    /// Greatest force of the pin times the crank radius, driving and braking, in N m: see [`Load::pin_moment`].
    pub fn pin_moment(&self) -> Peaks {
        self.peaks(|load| load.pin_moment, |crank| self.pin_moment_rate(crank))
    }

    /// Greatest torque at the crank, driving and braking, in N m. Times the driver speed it is the power.
    pub fn crank_torque(&self) -> Peaks {
        self.peaks(|load| load.crank_torque, |crank| self.crank_torque_rate(crank))
    }

    /// Greatest power that the driver gives, in the SI's unit of power, N m/s: its torque's peak times its speed.
    pub fn peak_power(&self) -> f64 {
        self.crank_torque().driving.value * self.driver_speed
    }

    /// Crank angles between which the pin holds the wheel back, in radians: at the first it changes from one side of the
    /// slot to the other, at the second it changes back or leaves. `None` where friction brakes the wheel enough.
    pub fn reversal(&self) -> Option<(f64, f64)> {
        let (peak, end) = (self.wheel.acceleration_peak(), self.wheel.engagement_half_angle());
        if self.inertia_torque * peak.ratio <= self.friction_torque {
            return None;
        }
        let torque = |crank: f64| self.load(crank).map_or(0.0, |load| load.wheel_torque);
        let from = if self.friction_torque > 0.0 { root(torque, 0.0, peak.angle) } else { 0.0 };
        let until = if torque(end) > 0.0 { root(|crank| -torque(crank), peak.angle, end) } else { end };
        Some((from, until))
    }

    /// Mean torque at the crank over the driver's turn, in N m: what friction takes, M times the stations passed over N.
    pub fn mean_crank_torque(&self) -> f64 {
        self.friction_torque * f64::from(self.wheel.pins()) / f64::from(self.wheel.stations())
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
        (square * f64::from(self.wheel.pins()) / TAU).sqrt()
    }

    /// Work of the crank on the wheel over one index, in N m: the torque at the crank, integrated as in
    /// [`rms_crank_torque`](Self::rms_crank_torque).
    pub fn work(&self) -> f64 {
        self.integral(|load| load.crank_torque)
    }

    /// The torque at the crank with a pin that rubs in its slot with this coefficient of friction (zero or more): the greatest, and
    /// the mean over the driver's turn, in N m, at two thousand equal steps of the index.
    ///
    /// The power of the friction, the force of the pin times its speed along the slot, comes on top.
    ///
    /// # Errors
    ///
    /// None for the angles of an index.
    pub fn rubbing_crank_torque(&self, friction: f64) -> Result<(f64, f64), KinematicsError> {
        const STEPS: u32 = 2000;
        let end = self.wheel.engagement_half_angle();
        let (mut peak, mut sum) = (0.0_f64, 0.0);
        for step in 0..STEPS {
            let crank = end * (2.0 * (f64::from(step) + 0.5) / f64::from(STEPS) - 1.0);
            let (load, pin) = (self.load(crank)?, self.wheel.pin_in_slot(crank)?);
            let torque = load.crank_torque + friction * (load.pin_moment * pin.radius_rate).abs();
            peak = peak.max(torque);
            sum += torque * 2.0 * end / f64::from(STEPS);
        }
        Ok((peak, sum * f64::from(self.wheel.pins()) / TAU))
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

    /// r³ times the rate of T / r: r² dT/dθ − T r dr/dθ, of the same sign.
    fn pin_moment_rate(&self, crank: f64) -> f64 {
        let (Ok(motion), Ok(pin)) = (self.wheel.engaged(crank), self.wheel.pin_in_slot(crank)) else { return 0.0 };
        let torque = self.inertia_torque * motion.acceleration + self.friction_torque;
        pin.radius * (pin.radius * self.inertia_torque * motion.jerk - torque * pin.radius_rate)
    }

    /// The rate of T v.
    fn crank_torque_rate(&self, crank: f64) -> f64 {
        let Ok(motion) = self.wheel.engaged(crank) else { return 0.0 };
        let torque = self.inertia_torque * motion.acceleration + self.friction_torque;
        self.inertia_torque * motion.jerk * motion.velocity + torque * motion.acceleration
    }

    /// The integral over one engagement, in the unit of the values.
    fn integral(&self, of: impl Fn(&Load) -> f64) -> f64 {
        let end = self.wheel.engagement_half_angle();
        let with = |parts: u32| {
            let half = end / f64::from(parts);
            let part = |k: u32| {
                let middle = half * f64::from(2 * k + 1) - end;
                let value = |node: f64| self.load(middle + half * node).map_or(0.0, |load| of(&load));
                half * rule().integral(&rule().nodes.map(value))
            };
            (0..parts).map(part).sum::<f64>()
        };
        let scale = end * (self.inertia_torque + self.friction_torque) * self.wheel.peak_velocity();
        let mut sum = with(2);
        for doubling in 2..=MOST_DOUBLINGS {
            let next = with(1 << doubling);
            let change = (next - sum).abs();
            sum = next;
            if change <= SETTLED * sum.abs().max(f64::EPSILON * scale) {
                break;
            }
        }
        sum
    }
}

/// The greatest value between two angles in radians, in its own unit, where its `rate` changes from plus to minus or at an
/// end.
fn greatest(value: impl Fn(f64) -> f64, rate: impl Fn(f64) -> f64, from: f64, until: f64) -> Peak {
    let width = (until - from) / f64::from(PARTS);
    // Both ends exactly, or the last would lie outside of the engagement.
    let bound = |k: u32| if k == PARTS { until } else { from + width * f64::from(k) };
    let of_part = |k: u32| {
        let angle = root(&rate, bound(k), bound(k + 1));
        Peak { angle, value: value(angle) }
    };
    (1..PARTS).map(of_part).fold(of_part(0), |best, peak| if peak.value > best.value { peak } else { best })
}

/// Where `rate` changes from plus to minus between two angles in radians; the first if it does not begin above zero, the
/// last if it does not end below.
fn root(rate: impl Fn(f64) -> f64, from: f64, until: f64) -> f64 {
    let inside = INSIDE * (until - from);
    if rate(from + inside) <= 0.0 {
        return from;
    }
    if rate(until - inside) >= 0.0 {
        return until;
    }
    let [low, high] = bisect([from + inside, until - inside], |angle| rate(angle) > 0.0);
    f64::midpoint(low, high)
}
