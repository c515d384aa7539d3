//! Escapements without a spring or a pendulum: how their rate depends on the torque.
//!
//! A toothed wheel drives a pallet with inertia to and fro, as in a runaway escapement. At the end of each swing the
//! next tooth meets the pallet's other face, and the two bodies go on together after a blow in which neither rebounds.
//! Besides, a drag may hold the wheel back. The model has no drop, no recoil and no friction at the pallet.

use crate::DynamicsError;
use crate::error::{not_negative, positive};

/// A torque that holds the wheel back: constant, proportional to the speed, and proportional to its square.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drag {
    /// Constant drag torque, as of a dry bearing under a constant load, in the unit of the torque.
    pub constant: f64,
    /// Drag torque over speed, as of oil, in the unit of the torque times the unit of time over a radian.
    pub linear: f64,
    /// Drag torque over the square of the speed, as of a fly in the air, in the unit of the torque times the square of
    /// the unit of time over a square radian.
    pub square: f64,
}

/// A runaway escapement: a wheel, a pallet that it throws to and fro, and a drag.
///
/// ```
/// use geneva_dynamics::timer::runaway::{Drag, Runaway};
///
/// // A wheel of inertia 3, a pallet that counts as 1 at the wheel, 0.1 rad from blow to blow, no drag.
/// let escapement = Runaway::new(3.0, 1.0, 0.1, Drag::default())?;
/// assert_eq!(escapement.speed_retention(), 0.5); // (3 − 1) / (3 + 1) of the speed
/// assert!((escapement.power(1.0)? - 0.5).abs() < 1e-9); // only blows brake: speeds go as the root of the torque
/// let steady = escapement.steady(1.0)?;
/// assert!((steady.after_blow / steady.before_blow - 0.5).abs() < 1e-12);
/// // From blow to blow the torque's work is the gain of energy: 1 · 0.1 = (3 + 1) (ω₂² − ω₁²) / 2.
/// let gain = 2.0 * (steady.before_blow.powi(2) - steady.after_blow.powi(2));
/// assert!((gain - 0.1).abs() < 1e-12);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Runaway {
    wheel: f64,
    pallet: f64,
    beat: f64,
    drag: Drag,
}

/// The steady motion of a runaway escapement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunawayCycle {
    /// Speed of the wheel just after a blow, in radians per unit of time.
    pub after_blow: f64,
    /// Speed of the wheel just before a blow, in radians per unit of time.
    pub before_blow: f64,
    /// Time from blow to blow, in units of time.
    pub period: f64,
    /// Angle from blow to blow over its time, in radians per unit of time.
    pub mean_speed: f64,
}

/// Steps from blow to blow, and how many blows a start from rest may take.
const STEPS: u32 = 400;
const BLOWS: usize = 100_000;
/// Relative change of the speed's square from blow to blow at which the motion counts as steady.
const STEADY: f64 = 1e-14;

impl Runaway {
    /// A runaway escapement of a wheel's moment of inertia, a pallet's moment of inertia reduced to the wheel (times the
    /// square of its speed over the wheel's), the wheel's angle from blow to blow in radians, and a drag.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for a wheel's inertia or an angle that is not positive, [`DynamicsError::Negative`] for a drag that
    /// is, and [`DynamicsError::OutOfRange`] for a pallet that is not lighter than the wheel: it would throw the wheel back.
    pub fn new(wheel: f64, pallet: f64, beat: f64, drag: Drag) -> Result<Self, DynamicsError> {
        let wheel = positive("wheel inertia", wheel)?;
        let beat = positive("angle from blow to blow", beat)?;
        if !(0.0..wheel).contains(&pallet) {
            return Err(DynamicsError::OutOfRange {
                name: "reduced pallet inertia",
                asked: pallet,
                least: 0.0,
                most: wheel,
            });
        }
        for (name, value) in [("constant", drag.constant), ("linear", drag.linear), ("square", drag.square)] {
            not_negative(name, value)?;
        }
        Ok(Self { wheel, pallet, beat, drag })
    }

    /// The part of the wheel's speed that a blow leaves, dimensionless, from 0 to 1.
    ///
    /// The impulse of the blow turns the pallet round: the wheel's speed ω becomes ω' with
    /// I_w (ω − ω') = I_p (ω + ω'), so ω' = ω (I_w − I_p) / (I_w + I_p).
    pub fn speed_retention(&self) -> f64 {
        (self.wheel - self.pallet) / (self.wheel + self.pallet)
    }

    /// The speed over the wheel's angle from a blow to the next, at equal steps: pairs of an angle in radians and a speed in
    /// radians per unit of time.
    ///
    /// `after_blow` is the speed just after the blow. Where the drag is greater than the torque the speed may fall to zero.
    pub fn between_blows(&self, torque: f64, after_blow: f64) -> Vec<(f64, f64)> {
        let mut square = after_blow * after_blow;
        let mut points = vec![(0.0, after_blow)];
        for k in 1..=STEPS {
            square = self.step(torque, square).0;
            points.push((self.beat * f64::from(k) / f64::from(STEPS), square.max(0.0).sqrt()));
        }
        points
    }

    /// A step of the wheel's angle: the square of the speed at its end, and its time, by Simpson's rule.
    ///
    /// By the balance of energy the square of the speed grows by 2 (K − drag) / (I_w + I_p) for each radian.
    fn step(&self, torque: f64, square: f64) -> (f64, f64) {
        let step = self.beat / f64::from(STEPS);
        let slope = |square: f64| {
            let speed = square.max(0.0).sqrt();
            let drag = self.drag.constant + self.drag.linear * speed + self.drag.square * square;
            2.0 * (torque - drag) / (self.wheel + self.pallet)
        };
        let advance = |from: f64, step: f64| {
            let a = slope(from);
            let b = slope(from + step / 2.0 * a);
            let c = slope(from + step / 2.0 * b);
            let d = slope(from + step * c);
            from + step / 6.0 * (a + 2.0 * b + 2.0 * c + d)
        };
        let (middle, end) = (advance(square, step / 2.0), advance(square, step));
        let [first, middle, last] = [square, middle, end].map(|square| 1.0 / square.sqrt());
        (end, step / 6.0 * (first + 4.0 * middle + last))
    }

    /// The steady motion under a constant torque (> 0), in any unit that fits the inertias.
    ///
    /// ```
    /// use geneva_dynamics::timer::runaway::{Drag, Runaway};
    ///
    /// // With a pallet that weighs nothing, a fly alone brakes: K = 4 and a drag of 1 times the square of the speed.
    /// let fly = Drag { square: 1.0, ..Drag::default() };
    /// let steady = Runaway::new(3.0, 0.0, 0.1, fly)?.steady(4.0)?;
    /// assert!((steady.mean_speed - 2.0).abs() < 1e-9); // where the drag is the torque
    /// # Ok::<(), geneva_dynamics::DynamicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for a torque that is not positive, [`DynamicsError::DragTorque`] if the constant drag is not below the
    /// torque, [`DynamicsError::NoTerminalSpeed`] if neither blows nor drag grow with the speed, and [`DynamicsError::TooMany`] if the motion
    /// is not steady after a hundred thousand blows, or the drag is too strong for the four hundred steps of a beat.
    pub fn steady(&self, torque: f64) -> Result<RunawayCycle, DynamicsError> {
        let torque = positive("torque", torque)?;
        let Drag { constant, linear, square } = self.drag;
        if constant >= torque {
            return Err(DynamicsError::DragTorque { asked: constant, torque });
        }
        if self.pallet == 0.0 && linear == 0.0 && square == 0.0 {
            return Err(DynamicsError::NoTerminalSpeed { multiplier: 1.0 });
        }
        let kept = self.speed_retention() * self.speed_retention();
        // From the speed that the energy of one beat gives, so that no step starts from rest.
        let mut after = kept.max(STEADY) * 2.0 * (torque - constant) * self.beat / (self.wheel + self.pallet);
        for _ in 0..BLOWS {
            let (mut before, mut period) = (after, 0.0);
            for _ in 0..STEPS {
                let (square, time) = self.step(torque, before);
                (before, period) = (square, period + time);
            }
            let next = kept * before;
            // A drag so strong that the steps are too coarse for it.
            if !next.is_finite() || next < 0.0 {
                break;
            }
            if (next - after).abs() <= STEADY * next {
                return Ok(RunawayCycle {
                    after_blow: after.sqrt(),
                    before_blow: before.sqrt(),
                    period,
                    mean_speed: self.beat / period,
                });
            }
            after = next;
        }
        Err(DynamicsError::TooMany { name: "blows", limit: BLOWS })
    }

    /// Power of the torque to which the mean speed goes near this torque, dimensionless:
    /// d ln(mean speed) / d ln(torque).
    ///
    /// # Errors
    ///
    /// As for [`steady`](Self::steady).
    pub fn power(&self, torque: f64) -> Result<f64, DynamicsError> {
        const CHANGE: f64 = 1e-3;
        let log = |factor: f64| Ok::<_, DynamicsError>(libm::log(self.steady(torque * factor)?.mean_speed));
        Ok((log(libm::exp(CHANGE))? - log(libm::exp(-CHANGE))?) / (2.0 * CHANGE))
    }
}

/// The power of the friction to which the mean speed of a runaway escapement goes, if friction takes this part of its torque
/// and blows take the rest of its work: dimensionless, and negative.
///
/// The speed goes as the root of what the friction leaves, whatever the wheel, the pallet and the beat: with the part f it is
/// −f / (2 (1 − f)).
///
/// ```
/// use geneva_dynamics::timer::runaway::{Drag, Runaway, friction_power};
///
/// // A tenth of the torque, and a ten-thousandth more.
/// let speed = |friction| Runaway::new(3.0, 1.0, 0.1, Drag { constant: friction, ..Drag::default() })?.steady(1.0);
/// let (before, after) = (speed(0.1)?.mean_speed, speed(0.1 * 1.0001)?.mean_speed);
/// assert!(((after / before - 1.0) / 0.0001 - friction_power(0.1)?).abs() < 1e-5);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::OutOfRange`] for a part that is not from 0 to below 1.
pub fn friction_power(part: f64) -> Result<f64, DynamicsError> {
    if !(0.0..1.0).contains(&part) {
        return Err(DynamicsError::OutOfRange { name: "friction over torque", asked: part, least: 0.0, most: 1.0 });
    }
    Ok(-part / (2.0 * (1.0 - part)))
}

/// The power of the torque to which a governed speed goes, at this many times the speed at which the brake begins to touch:
/// dimensionless, from 0 to 1/2.
///
/// The brake presses with what the centrifugal force has beyond the springs, so its torque is proportional to ω² − ω₀². Where
/// it takes all the torque K, d ln ω / d ln K = (1 − ω₀²/ω²)/2.
///
/// ```
/// use geneva_dynamics::timer::runaway::governed_power;
///
/// // The brake holds with ω² − 1, so the speed under a torque is the root of one more than the torque.
/// let speed = |torque: f64| (1.0 + torque).sqrt();
/// let torque = 1.1 * 1.1 - 1.0;
/// let change = (speed(torque * 1.0001) / speed(torque) - 1.0) / 0.0001;
/// assert!((change - governed_power(1.1)?).abs() < 1e-5);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::OutOfRange`] for a quotient that is below 1 or not finite.
pub fn governed_power(beyond: f64) -> Result<f64, DynamicsError> {
    if !(beyond >= 1.0 && beyond.is_finite()) {
        return Err(DynamicsError::OutOfRange {
            name: "speed over the least braked",
            asked: beyond,
            least: 1.0,
            most: f64::MAX,
        });
    }
    Ok((1.0 - 1.0 / (beyond * beyond)) / 2.0)
}

/// The power of the torque to which the rate of a verge with a foliot goes, if its only loss is a drag in proportion to
/// the foliot's speed: from 1/3 under a strong torque to 1 under a weak one, dimensionless.
///
/// The torque ±μ changes its sign as the foliot passes the angles ∓φ₀. With the time 1/γ in which the drag alone would
/// stop the foliot as the unit, the half period T obeys μ (T − 2 tanh(T/2)) = 2 φ₀, and the power is
/// (T − 2 tanh(T/2)) / (T tanh²(T/2)). `half_period` is T, positive. The limits are those of Hoyng and Nieuwenhuizen,
/// arXiv 1604.06681.
///
/// ```
/// use geneva_dynamics::timer::runaway::foliot_power;
///
/// assert!((foliot_power(1e-3)? - 1.0 / 3.0).abs() < 1e-6); // strong torque, short half period
/// assert!((foliot_power(1e6)? - 1.0).abs() < 1e-5); // weak torque, long half period
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::NotPositive`] for a half period that is not positive.
pub fn foliot_power(half_period: f64) -> Result<f64, DynamicsError> {
    let time = positive("half period", half_period)?;
    let tanh = libm::tanh(time / 2.0);
    // Below this the difference loses its digits, and the series T³/12 − T⁵/120 is exact.
    let difference =
        if time < 0.02 { time * time * time * (1.0 / 12.0 - time * time / 120.0) } else { time - 2.0 * tanh };
    Ok(difference / (time * tanh * tanh))
}
