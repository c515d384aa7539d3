//! The contact's moments and its sliding against the vectors that they come from, as identities.
//!
//! The pin is at e R from the follower's axis, with e = (−cos φ, sin φ) and n = (sin φ, cos φ) across it; the driver's
//! axis is at (−a, 0) from the follower's. R, a and φ are free, so the crank has any length. The driver turns
//! counter-clockwise at the speed one.
//!
//! ```
//! use geneva_dynamics::Sign;
//! use geneva_dynamics::joints::contact_proofs::PowerLost;
//! use geneva_kinematics::prove;
//!
//! // What driver and follower don't share, friction takes.
//! assert!(prove(&PowerLost { flank: Sign::Plus, sliding: Sign::Minus }).is_ok());
//! ```

use super::Reach;
use crate::Sign;
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::{Expression, Identity, Turn};
use nalgebra::Vector2;

/// Vectors at one instant, from the follower's axis.
struct Scene {
    along: Vector2<Expression>,
    across: Vector2<Expression>,
    pin: Vector2<Expression>,
    driver_axis: Vector2<Expression>,
}

impl Scene {
    fn new(distance: Expression, radius: Expression, half: Expression) -> Self {
        let Turn { cos, sin } = Turn::from_half_tangent(&half);
        let along = Vector2::new(-cos, sin);
        Self {
            across: Vector2::new(sin, cos),
            pin: along * radius,
            along,
            driver_axis: Vector2::new(-distance, Expression::ZERO),
        }
    }

    /// R, φ'/θ' and dR/dθ from the velocity of the pin's centre.
    fn reach(&self, radius: Expression) -> Reach<Expression> {
        let velocity = quarter_turn(&(self.pin - self.driver_axis));
        Reach { radius, ratio: velocity.dot(&self.across) / radius, slide: velocity.dot(&self.along) }
    }

    /// The point of contact for a pin of this radius.
    fn contact(&self, pin: Expression, flank: Sign) -> Vector2<Expression> {
        self.pin + self.across * flank.apply(pin)
    }

    /// The force on the follower for N = s, so that |N| is one.
    fn force(&self, friction: Expression, flank: Sign, sliding: Sign) -> Vector2<Expression> {
        self.across * flank.apply(Expression::ONE) + self.along * sliding.apply(friction)
    }

    /// Velocity of the driver at the contact less that of the follower.
    fn relative_velocity(&self, contact: &Vector2<Expression>, reach: &Reach<Expression>) -> Vector2<Expression> {
        let driver = quarter_turn(&(contact - self.driver_axis));
        // The follower turns clockwise.
        let follower = quarter_turn(contact) * -reach.ratio;
        driver - follower
    }
}

/// The axis that a moment is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointAxis {
    /// The follower's.
    Follower,
    /// The driver's.
    Driver,
}

/// The moment of the contact's force about the follower's axis, or that of the opposite force at the same point about
/// the driver's. Variables: a, R, tan(φ/2), ρ, μ.
pub struct ContactMoment {
    /// The axis.
    pub axis: JointAxis,
    /// The flank, s.
    pub flank: Sign,
    /// The sense of the sliding, σ.
    pub sliding: Sign,
}

impl Identity<5> for ContactMoment {
    fn difference(&self, [distance, radius, half, pin, friction]: [Expression; 5]) -> Expression {
        let scene = Scene::new(distance, radius, half);
        let (contact, force) = (scene.contact(pin, self.flank), scene.force(friction, self.flank, self.sliding));
        let arms = scene.reach(radius).arms(&pin, &friction, self.flank, self.sliding);
        match self.axis {
            // φ grows clockwise.
            JointAxis::Follower => -contact.perp(&force) - self.flank.apply(arms.follower),
            JointAxis::Driver => (contact - scene.driver_axis).perp(&-force) + self.flank.apply(arms.driver),
        }
    }
}

/// The surfaces slide along the slot as told, and do not part or meet. Variables: a, R, tan(φ/2), ρ.
pub enum Sliding {
    /// Relative velocity along the slot, on this flank.
    Along(Sign),
    /// Relative velocity across the slot, on this flank: none.
    Across(Sign),
}

impl Identity<4> for Sliding {
    fn difference(&self, [distance, radius, half, pin]: [Expression; 4]) -> Expression {
        let scene = Scene::new(distance, radius, half);
        let reach = scene.reach(radius);
        let (Self::Along(flank) | Self::Across(flank)) = *self;
        let velocity = scene.relative_velocity(&scene.contact(pin, flank), &reach);
        match self {
            Self::Along(flank) => velocity.dot(&scene.along) - reach.sliding(&pin, *flank),
            Self::Across(_) => velocity.dot(&scene.across),
        }
    }
}

/// What the driver gives less what the follower gets is friction times sliding: κ − q λ = σ μ s w/θ' before the
/// journals. Variables: R, q, dR/dθ, ρ, μ.
pub struct PowerLost {
    /// The flank, s.
    pub flank: Sign,
    /// The sense of the sliding, σ.
    pub sliding: Sign,
}

impl Identity<5> for PowerLost {
    fn difference(&self, [radius, ratio, slide, pin, friction]: [Expression; 5]) -> Expression {
        let reach = Reach { radius, ratio, slide };
        let arms = reach.arms(&pin, &friction, self.flank, self.sliding);
        let lost = friction * reach.sliding(&pin, self.flank);
        arms.driver - ratio * arms.follower - self.flank.times(self.sliding).apply(lost)
    }
}
