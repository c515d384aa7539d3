//! With play between pin and slot: how the pin crosses the gap where the contact changes, and how hard it strikes there and
//! as the next pin enters.
//!
//! The model: in the steady motion without play the force between pin and slot is zero where the contact would change from
//! the leading to the trailing flank. From there on nothing touches. The driver has the torque alone and the follower keeps
//! its speed, until the trailing flank has come across the play. Then the two meet in a blow without rebound and without
//! friction. What the play does to the motion before that, and what comes after the blow, is left out.

use crate::error::positive;
use crate::steady::Engagement;
use crate::{DynamicsError, Parameters};
use geneva_kinematics::bisection::bisect_times;
use geneva_kinematics::{Turn, pin_slot};

/// The free flight of the pin from one flank to the other, and the blow at its end.
///
/// ```
/// use geneva_dynamics::timer::Crossing;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = |torque| Parameters::new(Mechanism::FOUR_PIN, Inertias::new(0.1, 1.0)?, torque, 0.2);
/// let play = 0.001; // crank radii
/// let [weak, strong] = [1.0, 4.0].map(|torque| Crossing::new(&timer(torque)?, play));
/// let (weak, strong) = (weak?.expect("it crosses"), strong?.expect("it crosses"));
/// // Four times the torque: the crossing is at the same angles, in half the time, with the same share of energy.
/// assert!((strong.to - weak.to).abs() < 1e-9 && (strong.duration / weak.duration - 0.5).abs() < 1e-9);
/// assert!((strong.share / weak.share - 1.0).abs() < 1e-9);
/// // The blow takes m v² / 2, where m is the mass of both members at the pin, whose arms are about R and R φ'/θ'.
/// let pose = timer(1.0)?.pose(weak.to);
/// let mass = 1.0 / (pose.radius_squared * (1.0 + pose.velocity_ratio().powi(2) / 0.1));
/// let energy = mass * weak.closing_speed * weak.closing_speed / 2.0;
/// assert!((weak.energy / energy - 1.0).abs() < 0.02); // the better the less play there is
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Crank angle in radians from the line of centres where the pin leaves the leading flank.
    pub from: f64,
    /// Crank angle in radians where the trailing flank strikes the pin.
    pub to: f64,
    /// Duration of the flight, in units of time.
    pub duration: f64,
    /// Speed of the driver where the flight begins, in radians per unit of time.
    pub driver_speed: f64,
    /// Speed of the follower during the flight, in radians per unit of time.
    pub follower_speed: f64,
    /// Speed with which pin and flank meet, across the slot, in crank radii per unit of time.
    pub closing_speed: f64,
    /// Kinetic energy that the blow takes, in the unit of the torque.
    pub energy: f64,
    /// That energy over the work of the torque from one pin to the next, dimensionless.
    pub share: f64,
}

/// Halvings of the interval of time in which the flight ends.
const HALVINGS: u32 = 80;

impl Crossing {
    /// The crossing of a play, in crank radii: the width of the slot less the diameter of the pin. None if the pin leaves the
    /// slot before it has crossed.
    ///
    /// All angles and the share are the same for every torque, by the law of similarity.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::NotPositive`] for a play that is not positive and finite, and as for [`Engagement::steady_state`].
    pub fn new(parameters: &Parameters, play: f64) -> Result<Option<Self>, DynamicsError> {
        let play = positive("play", play)?;
        let engagement = Engagement::new(parameters)?;
        let passage = engagement.passage(engagement.steady_state()?.entry_speed)?;
        let Some((from, driver_speed)) = passage.reversal_angle().zip(passage.reversal_speed()) else {
            return Ok(None);
        };
        let flight = Flight::new(parameters, from, driver_speed);
        // The crank angle grows as driver_speed t + ½ a t²; the exit is where it is half an engagement.
        let left = parameters.mechanism().engagement_half_angle() - from;
        let exit =
            2.0 * left / (driver_speed + (driver_speed * driver_speed + 2.0 * flight.acceleration * left).sqrt());
        if flight.gap(exit) < play {
            return Ok(None);
        }
        // The gap grows all the while, because the driver's pin falls behind ever faster.
        let [low, high] = bisect_times(HALVINGS, [0.0, exit], |time| flight.gap(time) < play);
        let duration = (low + high) / 2.0;
        let (closing_speed, energy) = flight.blow(duration);
        let work = parameters.torque() * 2.0 * parameters.mechanism().engagement_half_angle();
        Ok(Some(Self {
            from,
            to: flight.driver(duration).0,
            duration,
            driver_speed,
            follower_speed: flight.follower_speed,
            closing_speed,
            energy,
            share: energy / work,
        }))
    }
}

/// The blow with which a pin enters: the follower is at rest in the middle of its play, and nothing holds it.
///
/// ```
/// use geneva_dynamics::timer::EntryBlow;
/// use geneva_dynamics::{Inertias, Parameters};
/// use geneva_kinematics::Mechanism;
///
/// let timer = Parameters::new(Mechanism::FOUR_PIN, Inertias::new(2.0, 1.0)?, 1.0, 0.2)?;
/// let blow = EntryBlow::new(&timer, 0.02)?; // play in crank radii
/// assert!((blow.late.cos() - 0.99).abs() < 1e-12); // half the play is crossed when 1 − cos τ is 0.01
/// assert!(EntryBlow::new(&timer, 0.01)?.share < blow.share); // less play, a softer blow
/// // The flank has the arm 1 − sin τ about the follower's axis, the pin sin τ about the driver's.
/// let (flank, pin) = (1.0 - blow.late.sin(), blow.late.sin());
/// let mass = 1.0 / (flank * flank / 1.0 + pin * pin / 2.0); // that meet, with I_f = 1 and I_D = 2
/// assert!((blow.energy - mass * blow.closing_speed * blow.closing_speed / 2.0).abs() < 1e-12);
/// # Ok::<(), geneva_dynamics::DynamicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EntryBlow {
    /// How far the crank has turned past the entry when the pin meets the leading flank, in radians.
    pub late: f64,
    /// Speed with which pin and flank meet, across the slot, in crank radii per unit of time.
    pub closing_speed: f64,
    /// Kinetic energy that the blow takes, in the unit of the torque.
    pub energy: f64,
    /// That energy over the work of the torque from one pin to the next, dimensionless.
    pub share: f64,
}

impl EntryBlow {
    /// The blow of a pin that enters with the speed of the steady motion without play, for a play in crank radii: the width
    /// of the slot less the diameter of the pin.
    ///
    /// As it enters, the pin moves along the slot. When the crank has turned by τ more, sin τ of its speed is across the slot,
    /// and it has crossed 1 − cos τ, which is half the play.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::OutOfRange`] for a play that is not between 0 and 1, and as for [`Engagement::steady_state`].
    pub fn new(parameters: &Parameters, play: f64) -> Result<Self, DynamicsError> {
        if !(play > 0.0 && play < 1.0) {
            return Err(DynamicsError::OutOfRange { name: "play", asked: play, least: 0.0, most: 1.0 });
        }
        let (inertias, torque) = (parameters.inertias(), parameters.torque());
        let half = parameters.mechanism().engagement_half_angle();
        let cosine = 1.0 - play / 2.0;
        let (late, across) = (libm::acos(cosine), (1.0 - cosine * cosine).sqrt());
        let entry = Engagement::new(parameters)?.steady_state()?.entry_speed;
        let square = entry * entry + 2.0 * torque / inertias.driver() * late;
        // The pin has gone inwards by sin τ, so the flank's arm is that much shorter.
        let flank = parameters.pose(half).radius_squared.sqrt() - across;
        let mobility = flank * flank / inertias.follower() + across * across / inertias.driver();
        let energy = 0.5 * across * across * square / mobility;
        Ok(Self { late, closing_speed: across * square.sqrt(), energy, share: energy / (torque * 2.0 * half) })
    }
}

/// Driver and follower while nothing touches.
struct Flight<'a> {
    of: &'a Parameters,
    /// Crank angle and driver's speed at the start.
    start: (f64, f64),
    /// The driver's, K / I_D.
    acceleration: f64,
    /// Of the slot's centre line from the line of centres, at the start.
    slot: f64,
    follower_speed: f64,
}

impl<'a> Flight<'a> {
    fn new(of: &'a Parameters, angle: f64, speed: f64) -> Self {
        let acceleration = of.torque() / of.inertias().driver();
        let follower_speed = of.pose(angle).velocity_ratio() * speed;
        Self { of, start: (angle, speed), acceleration, slot: pin_direction(of, angle), follower_speed }
    }

    /// Crank angle and speed of the driver at a time from the start.
    fn driver(&self, time: f64) -> (f64, f64) {
        let (angle, speed) = self.start;
        (angle + time * (speed + 0.5 * self.acceleration * time), speed + self.acceleration * time)
    }

    /// By how much the slot's centre line is ahead of the pin at a time from the start, in radians about the follower's axis.
    fn ahead(&self, time: f64) -> f64 {
        self.slot + self.follower_speed * time - pin_direction(self.of, self.driver(time).0)
    }

    /// How far the pin has fallen behind across the slot, in crank radii.
    fn gap(&self, time: f64) -> f64 {
        self.of.pose(self.driver(time).0).radius_squared.sqrt() * libm::sin(self.ahead(time))
    }

    /// Closing speed across the slot and the energy that a blow without rebound takes at a time from the start.
    ///
    /// Where the slot is δ ahead, the flank has the arm a = r cos δ about the follower's axis, and the pin moves across the
    /// slot by b = q r cos δ − dr/dθ sin δ for each radian of the driver. So the two close in with a φ' − b θ' and meet with
    /// the mass 1 / (a²/I_f + b²/I_D).
    fn blow(&self, time: f64) -> (f64, f64) {
        let (angle, speed) = self.driver(time);
        let (pose, inertias, ahead) = (self.of.pose(angle), self.of.inertias(), self.ahead(time));
        let radius = pose.radius_squared.sqrt();
        let flank = radius * libm::cos(ahead);
        let pin = pose.velocity_ratio() * flank - pose.k_sin_theta / radius * libm::sin(ahead);
        let closing = flank * self.follower_speed - pin * speed;
        let mobility = flank * flank / inertias.follower() + pin * pin / inertias.driver();
        (closing, 0.5 * closing * closing / mobility)
    }
}

/// Angle of the pin as seen from the follower's axis, from the line of centres.
fn pin_direction(of: &Parameters, angle: f64) -> f64 {
    let pin = pin_slot::pin_from_pivot(&of.mechanism().centre_distance_ratio(), &Turn::from_radians(angle));
    libm::atan2(pin.y, pin.x)
}
