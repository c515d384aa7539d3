//! What the driver and its motor feel: inertia through the wheel, a start in mid-index, how a flywheel evens the speed.

use super::WheelLoads;
use super::search::integral;
use crate::error::{DynamicsError, not_negative, positive};
use geneva_kinematics::indexing::Indexing;
use std::f64::consts::TAU;

/// Steps of an integration over an index, or over what is left of it.
const STEPS: u32 = 400;
/// Turns within which a driver must come to its speed.
const MOST_TURNS: u32 = 100;

/// Moment of inertia of the wheel and what turns with it, as the driver's shaft feels it, in kg m².
///
/// At a velocity ratio v of the wheel it is J v². A gear that turns the motor i times as fast as the driver divides it by i².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflected {
    /// The greatest, in the middle of an index, in kg m².
    pub peak: f64,
    /// The mean over a turn of the driver, with its dwells, in kg m².
    pub mean: f64,
}

/// A start from rest in the middle of an index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunUp {
    /// Time until the driver has its speed, in s.
    pub time: f64,
    /// Angle that the driver turns until then, in radians.
    pub angle: f64,
}

impl<W: Indexing + ?Sized> WheelLoads<'_, W> {
    /// Inertia of the wheel as the driver's shaft feels it.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::WheelLoads;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// // In the middle of an index a wheel of six stations is as fast as its driver.
    /// let wheel = Wheel::new(6)?;
    /// let reflected = WheelLoads::new(&wheel, 2e-3, 0.0, 6.0)?.reflected_inertia(); // of 2e-3 kg m²
    /// assert!((reflected.peak - 2e-3).abs() < 1e-17 && reflected.mean < 0.15 * reflected.peak);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reflected_inertia(&self) -> Reflected {
        let (wheel, end) = (self.wheel, self.wheel.engagement_half_angle());
        let peak = wheel.peak_velocity() * wheel.peak_velocity();
        let square = |crank: f64| wheel.engaged(crank).map_or(0.0, |motion| motion.velocity * motion.velocity);
        let mean = integral(square, &[-end, end], peak) * f64::from(wheel.pins()) / TAU;
        Reflected { peak: self.inertia * peak, mean: self.inertia * mean }
    }

    /// Torque at the crank in N m that just moves wheel and driver from rest in the middle of an index: friction alone resists.
    ///
    /// Friction at rest is taken to be as great as in motion; dry surfaces that have lain still need more.
    pub fn breakaway_torque(&self) -> f64 {
        let at_rest = WheelLoads { inertia: 0.0, inertia_torque: 0.0, ..*self };
        at_rest.load(0.0).map_or(0.0, |load| load.crank_torque)
    }

    /// Torque at the crank in N m that holds the wheel in the middle of an index against a torque on it in N m, as by a table out of
    /// balance: the torque times the greatest velocity ratio. Friction, which would help, is left out.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::WheelLoads;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(4)?; // as it passes, 1/(√2 − 1) times as fast as its driver
    /// let loads = WheelLoads::new(&wheel, 2e-3, 0.0, 6.0)?;
    /// assert!((loads.holding_torque(2.0)? - 2.0 / (2_f64.sqrt() - 1.0)).abs() < 1e-14); // N m
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Negative`] for a negative torque.
    pub fn holding_torque(&self, on_the_wheel: f64) -> Result<f64, DynamicsError> {
        Ok(not_negative("torque on the wheel", on_the_wheel)? * self.wheel.peak_velocity())
    }

    /// By what part of its speed in the dwell the driver is slower in the middle of an index, dimensionless, if `inertia` (kg m²,
    /// above zero) turns with it and no motor evens it out: 1 − 1/√(1 + J v²/inertia). The wheel takes its energy from the driver and
    /// gives it back. Friction is left out: the motor's mean torque pays for it.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::WheelLoads;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?; // v = 1 in the middle
    /// let loads = WheelLoads::new(&wheel, 3e-3, 0.0, 6.0)?;
    /// assert_eq!(loads.speed_droop(1e-3)?, 0.5); // a quarter of the energy is left to the driver, so half of the speed
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for an inertia that is not above zero.
    pub fn speed_droop(&self, inertia: f64) -> Result<f64, DynamicsError> {
        let driver = positive("moment of inertia of the driver", inertia)?;
        // 1 − 1/√(1 + x) without cancellation.
        let excess = self.reflected_inertia().peak / driver;
        let root = (1.0 + excess).sqrt();
        Ok(excess / (root * (root + 1.0)))
    }

    /// A start from rest in the middle of an index with a constant torque (N m) on the driver, with which `inertia` (kg m²) turns:
    /// until it has the speed of these loads. `None` if the torque can't bring it there within a hundred turns.
    ///
    /// The equation of motion, (I + κ/λ J v) dω/dt = K − κ/λ (J ω² a + M) − M_d, K the torque, I the driver's inertia, λ and κ the arms
    /// of the pin's force about both axes with all friction, by Runge-Kutta steps of ω² over the crank angle: 400 in an index.
    ///
    /// ```
    /// use geneva_dynamics::wheel_loads::WheelLoads;
    /// use geneva_kinematics::wheel::Wheel;
    ///
    /// let wheel = Wheel::new(6)?;
    /// let loads = WheelLoads::new(&wheel, 2e-3, 0.0, 6.0)?;
    /// let start = loads.run_up(0.1, 0.01)?.expect("nothing rubs"); // N m and kg m²
    /// assert!(start.time > 0.5 && start.angle > 1.5); // s and rad
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for a torque or an inertia that is not above zero.
    pub fn run_up(&self, torque: f64, inertia: f64) -> Result<Option<RunUp>, DynamicsError> {
        let torque = positive("torque on the driver", torque)?;
        let inertia = positive("moment of inertia of the driver", inertia)?;
        let end = self.wheel.engagement_half_angle();
        let pitch = TAU / f64::from(self.wheel.pins());
        let wanted = self.driver_speed * self.driver_speed;
        let engaged = |crank: f64, square: f64| self.driver_acceleration(torque, inertia, crank, square);
        let dwell = |_: f64, _: f64| (torque - self.dwell_crank_torque()) / inertia;
        let mut run = Run { square: 0.0, time: 0.0, angle: 0.0, wanted };
        let mut from = 0.0;
        for _ in 0..MOST_TURNS * self.wheel.pins() {
            for (low, high) in [(from, end), (end, pitch - end)] {
                let outcome =
                    if low < end { run.over(low, high, STEPS, engaged) } else { run.over(low, high, 1, dwell) };
                match outcome {
                    Outcome::Goes => {}
                    Outcome::Stalls => return Ok(None),
                    Outcome::Arrives => return Ok(Some(RunUp { time: run.time, angle: run.angle })),
                }
            }
            from = -end;
        }
        Ok(None)
    }

    /// dω/dt of the driver in rad/s² at a crank angle of the engagement and a square of its speed.
    fn driver_acceleration(&self, torque: f64, inertia: f64, crank: f64, square: f64) -> f64 {
        let Ok((place, acceleration)) = self.place(crank) else { return 0.0 };
        let held = self.inertia * acceleration * square + self.friction.wheel_torque;
        let drive = torque - self.friction.driver_torque;
        let flank = if inertia * held + self.inertia * place.velocity * drive < 0.0 { -1.0 } else { 1.0 };
        let [wheel, driver] = self.friction.arms(&place, flank);
        let leverage = driver / wheel;
        (drive - leverage * held) / (inertia + leverage * self.inertia * place.velocity)
    }
}

/// A driver on its way to a speed.
struct Run {
    square: f64,
    time: f64,
    angle: f64,
    wanted: f64,
}

/// How a stretch of the way ends.
enum Outcome {
    Goes,
    Arrives,
    Stalls,
}

impl Run {
    /// Over these crank angles in so many steps, with this acceleration at an angle and a square of the speed.
    fn over(&mut self, from: f64, until: f64, steps: u32, acceleration: impl Fn(f64, f64) -> f64) -> Outcome {
        let step = (until - from) / f64::from(steps);
        for k in 0..steps {
            let crank = from + step * f64::from(k);
            let last = if k + 1 == steps { until } else { crank + step };
            let middle = f64::midpoint(crank, last);
            // d(ω²)/dθ = 2 dω/dt.
            let rate = |at: f64, square: f64| 2.0 * acceleration(at, square);
            let first = rate(crank, self.square);
            let second = rate(middle, self.square + 0.5 * step * first);
            let third = rate(middle, self.square + 0.5 * step * second);
            let fourth = rate(last, self.square + step * third);
            let next = self.square + step / 6.0 * (first + 2.0 * (second + third) + fourth);
            if next <= 0.0 || !next.is_finite() {
                return Outcome::Stalls;
            }
            let arrives = next >= self.wanted;
            let part = if arrives { (self.wanted - self.square) / (next - self.square) } else { 1.0 };
            let reached = if arrives { self.wanted } else { next };
            self.time += 2.0 * part * step / (self.square.sqrt() + reached.sqrt());
            self.angle += part * step;
            self.square = reached;
            if arrives {
                return Outcome::Arrives;
            }
        }
        Outcome::Goes
    }
}
