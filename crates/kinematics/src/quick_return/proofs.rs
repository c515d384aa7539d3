//! What the scalar equations of a textbook say of a slotted lever, as identities that can be proven exactly.
//!
//! Frame and letters as in the [module](super); p = R cos φ and q = R sin φ are the crank's components, so that the
//! crank carries its own length. β is the angle at the pin between lever and crank. Roots are avoided by multiplying
//! with r or by squaring. Left sides come from power series, right sides from the diagram's geometry, or the reverse.
//!
//! Where motions are compared, the unit of length is the pin's height over the line of centres, so q is 1, and x is
//! the pin's other coordinate, so l = x − p. That leaves out only positions on the line of centres, and an equation
//! between rational functions that holds everywhere else holds there too. Few variables make short proofs.

use super::motion::{Drive, Motion};
use super::series::{PolarRates, polar_rates};
use crate::pin_vectors::{path, quarter_turn};
use crate::{Expression, Identity, Turn};
use nalgebra::Vector2;

/// Law of sines at the lever's pivot and at the pin: l sin ψ = R sin β, multiplied by r.
///
/// r sin ψ is the pin's height; R r sin β the area of lever and crank, a cross product. Variables: p, q, l.
pub struct LawOfSinesAtThePin;

impl Identity<3> for LawOfSinesAtThePin {
    fn difference(&self, [p, q, ground]: [Expression; 3]) -> Expression {
        let crank = Vector2::new(p, q);
        let lever = crank + Vector2::new(ground, Expression::ZERO);
        ground * lever.y - lever.perp(&crank)
    }
}

/// The lever's length as the sum of two projections: r = l cos ψ + R cos β, multiplied by r.
///
/// Variables: p, q, l.
pub struct LeverAsProjections;

impl Identity<3> for LeverAsProjections {
    fn difference(&self, [p, q, ground]: [Expression; 3]) -> Expression {
        let crank = Vector2::new(p, q);
        let lever = crank + Vector2::new(ground, Expression::ZERO);
        lever.dot(&lever) - ground * lever.x - lever.dot(&crank)
    }
}

/// Which angle a speed is resolved by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResolvedBy {
    /// β, at the pin between lever and crank.
    AngleAtPin,
    /// φ, at the crank's axis between the crank and the line of centres.
    AngleAtAxis,
}

/// Which part of the crank pin's velocity is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Across the lever: that of the lever's point, v cos of the angle.
    Across,
    /// Along the lever: the sliding velocity, v sin of the angle.
    Along,
}

/// A part of the pin's velocity as v cos or v sin of an angle, squared; the part itself from power series.
///
/// True for the angle at the pin, false for the angle at the crank's axis. Variables: p, x, ω.
pub struct ResolvedSpeed {
    /// The angle.
    pub by: ResolvedBy,
    /// The part.
    pub part: Part,
}

impl Identity<3> for ResolvedSpeed {
    fn difference(&self, [p, x, driver]: [Expression; 3]) -> Expression {
        let crank = Vector2::new(p, Expression::ONE);
        let rates = steady(p, x, driver);
        let square = rates.position.dot(&rates.position);
        let pin_speed_squared = crank.dot(&crank) * driver * driver;
        // cos² and sin² of either angle, from scalar and cross products of its two sides.
        let (other, other_square) = match self.by {
            ResolvedBy::AngleAtPin => (rates.position, square),
            ResolvedBy::AngleAtAxis => (Vector2::new(Expression::ONE, Expression::ZERO), Expression::ONE),
        };
        let scale = crank.dot(&crank) * other_square;
        let (found, product) = match self.part {
            Part::Across => (rates.turning, crank.dot(&other)),
            Part::Along => (rates.sliding, crank.perp(&other)),
        };
        found * found * square - pin_speed_squared * product * product / scale
    }
}

/// Along the lever, towards its pivot: sliding acceleration = R ω² cos β − r ψ̇², multiplied by r.
///
/// Variables: p, x, ω.
pub struct AlongTheLever;

impl Identity<3> for AlongTheLever {
    fn difference(&self, [p, x, driver]: [Expression; 3]) -> Expression {
        let rates = steady(p, x, driver);
        let square = rates.position.dot(&rates.position);
        let inwards = driver * driver * rates.position.dot(&Vector2::new(p, Expression::ONE));
        let centripetal = rates.turning * rates.turning * square;
        -(rates.sliding_rate * square) - (inwards - centripetal)
    }
}

/// Across the lever, clockwise: tangential acceleration = R ω² sin β − 2 ψ̇ v, multiplied by r; v towards the pivot.
///
/// Variables: p, x, ω.
pub struct AcrossTheLever;

impl Identity<3> for AcrossTheLever {
    fn difference(&self, [p, x, driver]: [Expression; 3]) -> Expression {
        let rates = steady(p, x, driver);
        let square = rates.position.dot(&rates.position);
        let across = driver * driver * rates.position.perp(&Vector2::new(p, Expression::ONE));
        let coriolis = 2 * rates.turning * -(rates.sliding * square);
        -(rates.turning_rate * square) - (across - coriolis)
    }
}

/// The pin's velocity is that of the lever's point and that of sliding: R ω across the crank = ψ̇ × r + ṙ e, a component.
///
/// The right side is from power series. Variables: p, x, ω.
pub struct TermsOfTheVelocity {
    /// Whether to compare along the line of centres or across it.
    pub first: bool,
}

impl Identity<3> for TermsOfTheVelocity {
    fn difference(&self, [p, x, driver]: [Expression; 3]) -> Expression {
        let rates = steady(p, x, driver);
        let pin = quarter_turn(&Vector2::new(p, Expression::ONE)) * driver;
        let sum = quarter_turn(&rates.position) * rates.turning + rates.position * rates.sliding;
        component(pin - sum, self.first)
    }
}

/// The pin's acceleration is the sum of its terms in a straight slot, with so many times ψ̇ × v between them. Two makes it
/// true.
///
/// The left side is the second derivative of R e(φ), a component of it. Variables: p, x, ω, ω̇.
pub struct TermsOfTheAcceleration {
    /// Whether to compare along the line of centres or across it.
    pub first: bool,
    /// How many times ψ̇ × v is counted.
    pub coriolis: i64,
}

impl Identity<4> for TermsOfTheAcceleration {
    fn difference(&self, [p, x, speed, acceleration]: [Expression; 4]) -> Expression {
        let drive = Drive { speed, acceleration };
        let (ground, crank) = placed(p, x);
        let pin = crank.speeding_up(speed, acceleration).direction().map(|series| series.coefficient(2) * 2);
        let rates = polar_rates(&ground, &Expression::ONE, &crank, &drive).expect("the pin is off the pivot");
        let across = quarter_turn(&rates.position);
        let normal = -(rates.position * (rates.turning * rates.turning));
        let tangential = across * rates.turning_rate;
        let relative = rates.position * rates.sliding_rate;
        let coriolis = across * (self.coriolis * rates.turning * rates.sliding);
        component(pin - (tangential + normal + relative + coriolis), self.first)
    }
}

/// The terms of the acceleration in a slot of any shape: the follower turns at will, at Ω with the angular acceleration Ω̇,
/// and the pin's acceleration as seen from it, normal and tangential together, is what it is. Two makes it true.
///
/// (a_2ⁿ + a_2ᵗ) = (a_4ⁿ + a_4ᵗ) + (a_relⁿ + a_relᵗ + c Ω × v_rel), a component. The left side is that of a crank of
/// speed one with the angular acceleration ω̇; what is seen from the follower is the power series of the pin's place, turned
/// back. Variables: p, x, ω̇, Ω, Ω̇.
pub struct TermsInAnySlot {
    /// Whether to compare along the line of centres or across it.
    pub first: bool,
    /// How many times Ω × v_rel is counted.
    pub coriolis: i64,
}

impl Identity<5> for TermsInAnySlot {
    fn difference(&self, variables: [Expression; 5]) -> Expression {
        let InAnySlot { turning, relative, rest } = InAnySlot::new(variables);
        component(rest - quarter_turn(&relative) * (self.coriolis * turning), self.first)
    }
}

/// The Coriolis acceleration has the magnitude c Ω v_rel, squared: what the pin's acceleration has beside that of the
/// follower's point and that seen from the follower. Two makes it true, or minus two.
///
/// Variables: p, x, ω̇, Ω, Ω̇.
pub struct CoriolisMagnitude {
    /// How many times Ω v_rel is counted.
    pub coriolis: i64,
}

impl Identity<5> for CoriolisMagnitude {
    fn difference(&self, variables: [Expression; 5]) -> Expression {
        let InAnySlot { turning, relative, rest } = InAnySlot::new(variables);
        let product = self.coriolis * turning;
        rest.dot(&rest) - product * product * relative.dot(&relative)
    }
}

/// The motion of a pin on a crank of speed one, seen from a follower that turns at will.
struct InAnySlot {
    /// Ω.
    turning: Expression,
    /// v_rel.
    relative: Vector2<Expression>,
    /// The pin's acceleration, less that of the follower's point and that seen from the follower.
    rest: Vector2<Expression>,
}

impl InAnySlot {
    /// For the variables p, x, ω̇, Ω, Ω̇.
    fn new([p, x, acceleration, turning, growth]: [Expression; 5]) -> Self {
        let (ground, crank) = placed(p, x);
        let path = path(&Expression::ONE, &ground, &crank.speeding_up(Expression::ONE, acceleration));
        let back = Turn { cos: Expression::ONE, sin: Expression::ZERO }.speeding_up(-turning, -growth);
        let seen = Vector2::new(back.cos * path.x - back.sin * path.y, back.sin * path.x + back.cos * path.y);
        let place = Vector2::new(x, Expression::ONE);
        let arm = Vector2::new(p, Expression::ONE);
        let pin = quarter_turn(&arm) * acceleration - arm;
        let point = quarter_turn(&place) * growth - place * (turning * turning);
        let rest = pin - point - seen.map(|series| series.coefficient(2) * 2);
        Self { turning, relative: seen.map(|series| series.rate()), rest }
    }
}

fn component(vector: Vector2<Expression>, first: bool) -> Expression {
    if first { vector.x } else { vector.y }
}

/// What of the motion is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compared {
    /// ψ̇.
    LeverSpeed,
    /// ψ̈.
    LeverAcceleration,
    /// ṙ, multiplied by r.
    Sliding,
    /// r̈, multiplied by r.
    SlidingAcceleration,
    /// The Coriolis term's first component.
    Coriolis,
}

/// The closed diagrams and the differentiated loop closure give one motion. Variables: p, x, ω, ω̇.
pub struct DiagramAgainstSeries(
    /// What is compared.
    pub Compared,
);

impl Identity<4> for DiagramAgainstSeries {
    fn difference(&self, [p, x, speed, acceleration]: [Expression; 4]) -> Expression {
        let drive = Drive { speed, acceleration };
        let (ground, crank) = placed(p, x);
        let rates = polar_rates(&ground, &Expression::ONE, &crank, &drive).expect("the pin is off the pivot");
        let Motion { velocities, accelerations, .. } =
            Motion::at(&ground, &Expression::ONE, &crank, &drive).expect("the pin is off the pivot");
        let square = rates.position.dot(&rates.position);
        match self.0 {
            Compared::LeverSpeed => velocities.follower_speed - rates.turning,
            Compared::LeverAcceleration => accelerations.follower_acceleration - rates.turning_rate,
            Compared::Sliding => velocities.sliding_velocity.dot(&rates.position) - rates.sliding * square,
            Compared::SlidingAcceleration => {
                accelerations.sliding_tangential.dot(&rates.position) - rates.sliding_rate * square
            }
            Compared::Coriolis => {
                let across = quarter_turn(&rates.position).x;
                accelerations.coriolis.x - 2 * rates.turning * rates.sliding * across
            }
        }
    }
}

/// The ground distance and the crank, of length one times its own, for a pin at (x, 1) and a crank (p, 1).
fn placed(p: Expression, x: Expression) -> (Expression, Turn<Expression>) {
    (x - p, Turn { cos: p, sin: Expression::ONE })
}

/// The rates at constant crank speed, for the variables p, x, ω.
fn steady(p: Expression, x: Expression, driver: Expression) -> PolarRates<Expression> {
    let (ground, crank) = placed(p, x);
    polar_rates(&ground, &Expression::ONE, &crank, &Drive::steady(driver)).expect("the pin is off the pivot")
}
