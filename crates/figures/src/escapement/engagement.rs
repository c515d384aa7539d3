//! The motion over one engagement, and the forces on the way.

use geneva_dynamics::{EquationError, Parameters};
use geneva_kinematics::escapement::EscapementError;
use geneva_mimic::{AtSmallestStep, IntegrationError, System, integrate};
use nalgebra::Vector1;
use std::fmt;

/// Steps from entry to exit that are kept; an even number, so that one ends on the line of centres.
pub const STEPS: u32 = 180;
/// Error of a step over the square of the speed: far below what a drawing shows.
const TOLERANCE: f64 = 1e-10;

/// Why there is no drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum DrawingError {
    /// The angle is beyond the engagement.
    Escapement(EscapementError),
    /// The speed is negative or not finite.
    Equation(EquationError),
    /// The motion could not be followed.
    Integration(IntegrationError<1, EquationError>),
}

impl fmt::Display for DrawingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Escapement(error) => error.fmt(f),
            Self::Equation(error) => error.fmt(f),
            Self::Integration(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for DrawingError {}

impl From<EscapementError> for DrawingError {
    fn from(error: EscapementError) -> Self {
        Self::Escapement(error)
    }
}

impl From<EquationError> for DrawingError {
    fn from(error: EquationError) -> Self {
        Self::Equation(error)
    }
}

/// What acts at one instant, over the driving torque K.
#[derive(Clone, Copy, Debug)]
pub struct Instant {
    /// θ, in radians.
    pub theta: f64,
    /// θ', in radians per unit of time.
    pub speed: f64,
    /// N r / K; positive where the pin drives the follower.
    pub normal: f64,
    /// Torque of the friction over K, never negative.
    pub friction: f64,
    /// What stands between the bars of the equation of motion, C θ'² + D θ'', over E = K / I_f.
    pub bars: f64,
    /// φ'' over the same.
    pub follower_acceleration: f64,
}

impl Instant {
    /// The forces at an angle and a speed.
    pub fn new(parameters: &Parameters, theta: f64, speed: f64) -> Result<Self, EquationError> {
        let forces = parameters.contact_forces(theta, speed)?;
        let gain = parameters.acceleration(theta, speed)?.value;
        let (torque, drive) = (parameters.torque(), parameters.drive());
        Ok(Self {
            theta,
            speed,
            normal: forces.normal_moment / torque,
            friction: forces.friction_torque / torque,
            bars: parameters.coefficients(theta).between_the_bars(&speed, &gain) / drive,
            follower_acceleration: forces.follower_acceleration / drive,
        })
    }
}

/// One engagement, from entry to exit.
pub struct Engagement {
    parameters: Parameters,
    /// θ, w = θ'² I_f / K and its rate with θ, at equal steps of θ.
    states: Vec<[f64; 3]>,
}

/// dw/dθ = 2 θ'' I_f / K: the equation of motion with the square of the speed over the angle, which is smooth from rest.
struct SquareOverAngle(Parameters);

impl SquareOverAngle {
    fn speed(&self, square: f64) -> f64 {
        (square.max(0.0) * self.0.drive()).sqrt()
    }
}

impl System<1> for SquareOverAngle {
    type Fault = EquationError;

    fn derivative(&mut self, advance: f64, square: &Vector1<f64>) -> Result<Vector1<f64>, EquationError> {
        let theta = advance - self.0.mechanism().engagement_half_angle();
        let gain = self.0.acceleration(theta, self.speed(square[0]))?.value;
        Ok(Vector1::new(2.0 * gain / self.0.drive()))
    }
}

impl Engagement {
    /// The motion of a driver that has this speed (≥ 0) as a pin enters.
    pub fn new(parameters: &Parameters, entry_speed: f64) -> Result<Self, DrawingError> {
        let half = parameters.mechanism().engagement_half_angle();
        parameters.acceleration(-half, entry_speed)?;
        let start = Vector1::new(entry_speed * (entry_speed / parameters.drive()));
        let step = 2.0 * half / f64::from(STEPS);
        let run = geneva_mimic::Parameters {
            relative_tolerance: TOLERANCE,
            at_smallest_step: AtSmallestStep::Continue,
            ..geneva_mimic::Parameters::new(step, 2.0 * half)
        };
        let mut states = Vec::new();
        integrate(&mut SquareOverAngle(*parameters), start, &run, |point| {
            // Counted from the line of centres, so that both halves have the same angles.
            let theta = half * ((2.0 * point.index as f64 - f64::from(STEPS)) / f64::from(STEPS));
            states.push([theta, point.state[0], point.derivative[0]]);
        })
        .map_err(DrawingError::Integration)?;
        Ok(Self { parameters: *parameters, states })
    }

    /// All instants that were kept.
    pub fn instants(&self) -> Result<Vec<Instant>, EquationError> {
        self.states.iter().map(|[theta, square, _]| self.instant(*theta, *square)).collect()
    }

    /// Where a value changes its sign, with its sign between the changes: ends of stretches and the sign on each.
    pub fn stretches(&self, value: fn(&Instant) -> f64) -> Result<Vec<([f64; 2], f64)>, EquationError> {
        let sign = |pair: usize, share: f64| -> Result<(f64, f64), EquationError> {
            let (theta, square) = self.between(pair, share);
            Ok((theta, value(&self.instant(theta, square)?).signum()))
        };
        let ends = [self.states.first(), self.states.last()].map(|state| state.map_or(0.0, |state| state[0]));
        let mut stretches: Vec<([f64; 2], f64)> = Vec::new();
        let mut start = ends[0];
        // Signs are asked for between the kept instants: at the ends and on the line of centres values may be zero.
        for pair in 0..self.states.len().saturating_sub(2) {
            let (before, after) = (sign(pair, 0.5)?.1, sign(pair + 1, 0.5)?.1);
            if before != after {
                let (mut low, mut high) = (pair as f64 + 0.5, pair as f64 + 1.5);
                for _ in 0..60 {
                    let middle = (low + high) / 2.0;
                    let whole = middle as usize;
                    if sign(whole, middle - whole as f64)?.1 == before { low = middle } else { high = middle }
                }
                let change = self.between(high as usize, high - libm::floor(high)).0;
                stretches.push(([start, change], before));
                start = change;
            }
        }
        let last = sign(self.states.len().saturating_sub(2), 0.5)?.1;
        stretches.push(([start, ends[1]], last));
        Ok(stretches)
    }

    fn instant(&self, theta: f64, square: f64) -> Result<Instant, EquationError> {
        Instant::new(&self.parameters, theta, SquareOverAngle(self.parameters).speed(square))
    }

    /// θ and w at a share of the way from a kept instant to the next: the cubic through values and rates.
    fn between(&self, pair: usize, share: f64) -> (f64, f64) {
        let (Some(a), Some(b)) = (self.states.get(pair), self.states.get(pair + 1)) else { return (0.0, 0.0) };
        let (width, rest) = (b[0] - a[0], 1.0 - share);
        let ends = a[1] * rest * rest * (1.0 + 2.0 * share) + b[1] * share * share * (1.0 + 2.0 * rest);
        let rates = width * share * rest * (a[2] * rest - b[2] * share);
        (a[0] + share * width, ends + rates)
    }
}
