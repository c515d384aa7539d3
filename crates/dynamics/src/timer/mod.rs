//! What a clockmaker asks of an escapement.
//!
//! How exact is the timer ([`Sensitivities`])? How hard are its members accelerated ([`Accelerations`])? How fast does it
//! settle ([`Settling`])? How hard does the pin strike where it has play ([`Crossing`], [`EntryBlow`])? All answers come
//! from the steady motion, [`steady`](crate::steady). The escapements with which it is compared are in [`runaway`].

mod crossing;
pub mod runaway;

pub use crossing::{Crossing, EntryBlow};

use crate::steady::Engagement;
use crate::{DynamicsError, Inertias, Parameters};
use geneva_kinematics::bisection::try_bisect_times;

/// The greatest value of a quantity, by its size, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignedPeak {
    /// The value, with its sign, in the quantity's own unit.
    pub value: f64,
    /// Crank angle in radians from the line of centres.
    pub angle: f64,
}

/// Accelerations and forces of a steady cycle. Angular accelerations in radians per square of the unit of time; moments
/// in the unit of the torque.
///
/// ```
/// use geneva_dynamics::timer::Accelerations;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// // Twice the torque doubles all accelerations and forces, by the law of similarity.
/// let of = |torque| {
///     let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, torque, 0.2)?;
///     Accelerations::new(&timer)
/// };
/// let (weak, strong) = (of(1.0)?, of(2.0)?);
/// assert!((strong.driver.value / weak.driver.value - 2.0).abs() < 1e-9);
/// assert!((strong.normal_moment.value / weak.normal_moment.value - 2.0).abs() < 1e-9);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerations {
    /// Strongest acceleration of the driver, θ''.
    pub driver: SignedPeak,
    /// Strongest acceleration of the follower, φ''.
    pub follower: SignedPeak,
    /// Normal force between pin and slot times the crank radius.
    pub normal_moment: SignedPeak,
    /// Jump of the follower's acceleration as one pin hands over to the next, in radians per square of the
    /// unit of time: entry less exit.
    pub jump: f64,
}

/// Into how many equal parts of its period the cycle is divided to find what is strongest.
///
/// Where a quantity is smooth at its strongest, the parabola through three instants leaves an error of some millionths.
pub const INSTANTS: usize = 4000;

impl Accelerations {
    /// The accelerations in the steady motion of an escapement; to about four digits where a quantity has a kink at its
    /// strongest, and to more elsewhere.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]: without friction there is no steady state.
    pub fn new(parameters: &Parameters) -> Result<Self, DynamicsError> {
        let lines = Engagement::new(parameters)?.steady_cycle(INSTANTS)?;
        let all = lines.iter().map(|line| Ok((line.angle, at(parameters, line.angle, line.speed)?)));
        let all = all.collect::<Result<Vec<_>, DynamicsError>>()?;
        let jump = match all.as_slice() {
            [(_, first), .., (_, last)] => first[1] - last[1],
            _ => 0.0,
        };
        Ok(Self {
            driver: SignedPeak::new(&all, 0),
            follower: SignedPeak::new(&all, 1),
            normal_moment: SignedPeak::new(&all, 2),
            jump,
        })
    }
}

/// Accelerations of driver and follower and normal force times crank radius.
fn at(parameters: &Parameters, angle: f64, speed: f64) -> Result<[f64; 3], DynamicsError> {
    let driver = parameters.acceleration(angle, speed)?.value;
    let forces = parameters.contact_forces(angle, speed)?;
    Ok([driver, forces.follower_acceleration, forces.normal_moment])
}

impl SignedPeak {
    /// Of one of three quantities at instants that are equally far apart: by the parabola through the strongest and its
    /// neighbours.
    fn new(instants: &[(f64, [f64; 3])], quantity: usize) -> Self {
        let value = |(_, values): &(f64, [f64; 3])| values[quantity];
        let strength = |at: &usize| libm::fabs(value(&instants[*at]));
        let Some(at) = (0..instants.len()).max_by(|a, b| strength(a).total_cmp(&strength(b))) else {
            return Self { value: 0.0, angle: f64::NAN };
        };
        let here = &instants[at];
        let beside = at.checked_sub(1).and_then(|before| Some((instants.get(before)?, instants.get(at + 1)?)));
        let Some((before, after)) = beside else { return Self { value: value(here), angle: here.0 } };
        let along = |a: f64, b: f64, c: f64, shift: f64| b + shift * ((c - a) / 2.0 + shift * (a - 2.0 * b + c) / 2.0);
        let (a, b, c) = (value(before), value(here), value(after));
        let bend = a - 2.0 * b + c;
        let shift = if bend == 0.0 { 0.0 } else { (a - c) / (2.0 * bend) };
        Self { value: along(a, b, c, shift), angle: along(before.0, here.0, after.0, shift) }
    }
}

/// Powers of the mean speed: one per cent more of the quantity makes the speed so many per cent greater.
///
/// d ln(mean speed) / d ln(quantity), all others kept. A timer that runs for a given angle loses as much time as its
/// mean speed gains.
///
/// ```
/// use geneva_dynamics::timer::Sensitivities;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let powers = Sensitivities::new(&timer)?;
/// assert_eq!(powers.torque, 0.5); // speeds go as the root of the torque
/// assert!(powers.friction < 0.0); // friction brakes
/// // Torque and both inertias times one factor change nothing.
/// assert!((powers.torque + powers.driver_inertia + powers.follower_inertia).abs() < 1e-12);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivities {
    /// Power of the mean speed in the torque K, dimensionless: one half, by the law of similarity.
    pub torque: f64,
    /// Power of the mean speed in the friction μ, dimensionless.
    pub friction: f64,
    /// Power of the mean speed in the driver's moment of inertia I_D, dimensionless.
    pub driver_inertia: f64,
    /// Power of the mean speed in the follower's moment of inertia I_f, dimensionless.
    pub follower_inertia: f64,
}

/// Relative change of a quantity by which the powers are found. The solver errs by 10⁻¹², so the rounding of the
/// quotient is about 10⁻⁹; the fourth power of the change, which the second difference leaves over, is 10⁻¹².
const CHANGE: f64 = 1e-3;

impl Sensitivities {
    /// The sensitivities of an escapement, to about nine digits; the one to the torque is exact.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]: without friction there is no steady state. Too near to the critical
    /// friction the neighbours of the escapement have none either.
    pub fn new(parameters: &Parameters) -> Result<Self, DynamicsError> {
        let friction = power(|factor| of(parameters, factor, 1.0))?;
        let driver_inertia = power(|factor| of(parameters, 1.0, factor))?;
        // Speeds are a function of μ and I_D/I_f times √(K/I_f).
        Ok(Self { torque: 0.5, friction, driver_inertia, follower_inertia: -0.5 - driver_inertia })
    }
}

/// The logarithm of the mean speed with this much times the friction and the driver's inertia.
fn of(parameters: &Parameters, friction: f64, driver: f64) -> Result<f64, DynamicsError> {
    let inertias = parameters.inertias();
    let inertias = Inertias::new(inertias.driver() * driver, inertias.follower())?;
    let changed =
        Parameters::new(parameters.mechanism(), inertias, parameters.torque(), parameters.friction() * friction)?;
    Ok(libm::log(Engagement::new(&changed)?.steady_state()?.mean_speed))
}

/// d f / d ln x at x = 1, by differences of the whole and of half the change.
fn power(f: impl Fn(f64) -> Result<f64, DynamicsError>) -> Result<f64, DynamicsError> {
    let slope = |change: f64| -> Result<f64, DynamicsError> {
        Ok((f(libm::exp(change))? - f(libm::exp(-change))?) / (2.0 * change))
    };
    let (whole, half) = (slope(CHANGE)?, slope(CHANGE / 2.0)?);
    Ok(half + (half - whole) / 3.0)
}

/// By what part of itself the mean speed of an escapement is greater with another friction, dimensionless.
///
/// ```
/// use geneva_dynamics::timer::speed_change;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// assert_eq!(speed_change(&timer, 0.2)?, 0.0);
/// assert!(speed_change(&timer, 0.1)? > 0.0 && speed_change(&timer, 0.3)? < 0.0); // friction brakes
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// As for [`Parameters::new`] and [`Engagement::steady_state`].
pub fn speed_change(parameters: &Parameters, friction: f64) -> Result<f64, DynamicsError> {
    Ok(mean_speed(&parameters.with_friction(friction)?)? / mean_speed(parameters)? - 1.0)
}

fn mean_speed(parameters: &Parameters) -> Result<f64, DynamicsError> {
    Ok(Engagement::new(parameters)?.steady_state()?.mean_speed)
}

/// The friction, dimensionless, with which an escapement would run so many times as fast as with its own.
///
/// ```
/// use geneva_dynamics::timer::{apparent_friction, speed_change};
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let ratio = 1.0 + speed_change(&timer, 0.15)?;
/// assert!((apparent_friction(&timer, ratio)? - 0.15).abs() < 1e-9);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
///
/// # Errors
///
/// [`DynamicsError::OutOfRange`] for a ratio that is not from 1 to what a hundredth of the friction gives, and as for
/// [`Engagement::steady_state`].
pub fn apparent_friction(parameters: &Parameters, ratio: f64) -> Result<f64, DynamicsError> {
    /// The least friction, as a part of its own, and halvings of the interval.
    const LEAST: f64 = 0.01;
    const HALVINGS: u32 = 50;
    let ends = [LEAST * parameters.friction(), parameters.friction()];
    let most = 1.0 + speed_change(parameters, ends[0])?;
    if !(1.0..=most).contains(&ratio) {
        return Err(DynamicsError::OutOfRange { name: "mean speed over its own", asked: ratio, least: 1.0, most });
    }
    // The less friction, the faster.
    let faster = |friction| Ok::<_, DynamicsError>(1.0 + speed_change(parameters, friction)? > ratio);
    let [low, high] = try_bisect_times(HALVINGS, ends, faster)?;
    Ok(f64::midpoint(low, high))
}

/// Settling: how an escapement forgets the way it was started.
///
/// ```
/// use geneva_dynamics::timer::Settling;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let settling = Settling::new(&timer)?;
/// assert!((settling.engagements(settling.multiplier) - 1.0).abs() < 1e-12); // that is what a multiplier is
/// assert!((settling.engagements(0.01) / settling.engagements(0.1) - 2.0).abs() < 1e-12);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settling {
    /// Factor by which one engagement reduces a small difference of two speeds, dimensionless.
    pub multiplier: f64,
    /// Time that an engagement takes in the steady motion, in units of time.
    pub period: f64,
}

impl Settling {
    /// The settling of an escapement.
    ///
    /// # Errors
    ///
    /// As for [`Engagement::steady_state`]: without friction there is no steady state.
    pub fn new(parameters: &Parameters) -> Result<Self, DynamicsError> {
        let steady = Engagement::new(parameters)?.steady_state()?;
        Ok(Self { multiplier: steady.multiplier, period: steady.period })
    }

    /// Engagements, dimensionless and not rounded, until a small difference is down to this part of itself, which is
    /// between 0 and 1.
    pub fn engagements(&self, part: f64) -> f64 {
        libm::log(part) / libm::log(self.multiplier)
    }

    /// Time until a small difference is down to this part of itself, in units of time, counted as if each engagement took a
    /// period.
    ///
    /// A start from rest lasts longer than its first engagement, however small the number is here.
    pub fn time(&self, part: f64) -> f64 {
        self.engagements(part) * self.period
    }
}
