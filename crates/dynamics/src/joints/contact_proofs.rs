//! The contact's moments and its sliding against the vectors that they come from, as identities.
//!
//! The pin is at e R from the follower's axis, with e = (−cos φ, sin φ) and n = (sin φ, cos φ) across it; the driver's
//! axis is at (−a, 0) from the follower's. R, a and φ are free, so the crank has any length. The driver turns
//! counter-clockwise at the speed one.

use super::{Arms, Reach};
use crate::Sign;
use geneva_kinematics::{Field, Identity, Turn};
use nalgebra::Vector2;

/// Vectors at one instant, from the follower's axis.
struct Scene<S> {
    along: Vector2<S>,
    across: Vector2<S>,
    pin: Vector2<S>,
    driver_axis: Vector2<S>,
}

fn dot<S: Field>(a: &Vector2<S>, b: &Vector2<S>) -> S {
    a.x.clone() * b.x.clone() + a.y.clone() * b.y.clone()
}

/// Counter-clockwise moment of a force at an arm.
fn moment<S: Field>(arm: &Vector2<S>, force: &Vector2<S>) -> S {
    arm.x.clone() * force.y.clone() - arm.y.clone() * force.x.clone()
}

/// A quarter of a turn counter-clockwise: the velocity for the angular velocity one.
fn turned<S: Field>(arm: &Vector2<S>) -> Vector2<S> {
    Vector2::new(-arm.y.clone(), arm.x.clone())
}

fn times<S: Field>(vector: &Vector2<S>, factor: &S) -> Vector2<S> {
    Vector2::new(vector.x.clone() * factor.clone(), vector.y.clone() * factor.clone())
}

fn plus<S: Field>(a: &Vector2<S>, b: &Vector2<S>) -> Vector2<S> {
    Vector2::new(a.x.clone() + b.x.clone(), a.y.clone() + b.y.clone())
}

fn less<S: Field>(a: &Vector2<S>, b: &Vector2<S>) -> Vector2<S> {
    plus(a, &times(b, &-S::one()))
}

impl<S: Field> Scene<S> {
    fn new(distance: &S, radius: &S, half: &S) -> Self {
        let Turn { cos, sin } = Turn::from_half_tangent(half);
        let along = Vector2::new(-cos.clone(), sin.clone());
        Self {
            across: Vector2::new(sin, cos),
            pin: times(&along, radius),
            along,
            driver_axis: Vector2::new(-distance.clone(), S::zero()),
        }
    }

    /// R, φ'/θ' and dR/dθ from the velocity of the pin's centre.
    fn reach(&self, radius: &S) -> Reach<S> {
        let velocity = turned(&less(&self.pin, &self.driver_axis));
        Reach {
            radius: radius.clone(),
            ratio: dot(&velocity, &self.across) / radius.clone(),
            slide: dot(&velocity, &self.along),
        }
    }

    /// The point of contact for a pin of this radius.
    fn contact(&self, pin: &S, flank: Sign) -> Vector2<S> {
        plus(&self.pin, &times(&self.across, &flank.of(pin.clone())))
    }

    /// The force on the follower for N = s, so that |N| is one.
    fn force(&self, friction: &S, flank: Sign, sliding: Sign) -> Vector2<S> {
        let normal = times(&self.across, &flank.of(S::one()));
        plus(&normal, &times(&self.along, &sliding.of(friction.clone())))
    }

    /// Velocity of the driver at the contact less that of the follower.
    fn relative_velocity(&self, contact: &Vector2<S>, reach: &Reach<S>) -> Vector2<S> {
        let driver = turned(&less(contact, &self.driver_axis));
        // The follower turns clockwise.
        let follower = times(&turned(contact), &-reach.ratio.clone());
        less(&driver, &follower)
    }
}

/// The moment of the contact's force about the follower's axis. Variables: a, R, tan(φ/2), ρ, μ.
pub struct FollowerArm {
    /// The flank, s.
    pub flank: Sign,
    /// The sense of the sliding, σ.
    pub sliding: Sign,
}

impl Identity<5> for FollowerArm {
    fn difference<S: Field>(&self, [distance, radius, half, pin, friction]: &[S; 5]) -> S {
        let scene = Scene::new(distance, radius, half);
        let force = scene.force(friction, self.flank, self.sliding);
        // φ grows clockwise.
        let turning = -moment(&scene.contact(pin, self.flank), &force);
        let Arms { follower, .. } = scene.reach(radius).arms(pin, friction, self.flank, self.sliding);
        turning - self.flank.of(follower)
    }
}

/// The moment of the opposite force at the same point about the driver's axis. Variables: a, R, tan(φ/2), ρ, μ.
pub struct DriverArm {
    /// The flank, s.
    pub flank: Sign,
    /// The sense of the sliding, σ.
    pub sliding: Sign,
}

impl Identity<5> for DriverArm {
    fn difference<S: Field>(&self, [distance, radius, half, pin, friction]: &[S; 5]) -> S {
        let scene = Scene::new(distance, radius, half);
        let back = times(&scene.force(friction, self.flank, self.sliding), &-S::one());
        let turning = moment(&less(&scene.contact(pin, self.flank), &scene.driver_axis), &back);
        let Arms { driver, .. } = scene.reach(radius).arms(pin, friction, self.flank, self.sliding);
        turning + self.flank.of(driver)
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
    fn difference<S: Field>(&self, [distance, radius, half, pin]: &[S; 4]) -> S {
        let scene = Scene::new(distance, radius, half);
        let reach = scene.reach(radius);
        let (Self::Along(flank) | Self::Across(flank)) = *self;
        let velocity = scene.relative_velocity(&scene.contact(pin, flank), &reach);
        match self {
            Self::Along(flank) => dot(&velocity, &scene.along) - reach.sliding(pin, *flank),
            Self::Across(_) => dot(&velocity, &scene.across),
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
    fn difference<S: Field>(&self, [radius, ratio, slide, pin, friction]: &[S; 5]) -> S {
        let reach = Reach { radius: radius.clone(), ratio: ratio.clone(), slide: slide.clone() };
        let arms = reach.arms(pin, friction, self.flank, self.sliding);
        let lost = friction.clone() * reach.sliding(pin, self.flank);
        arms.driver - ratio.clone() * arms.follower - self.flank.times(self.sliding).of(lost)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::proving::holds;

    #[test]
    fn the_arms_and_the_sliding_are_those_of_the_vectors() {
        for flank in Sign::BOTH {
            holds("sliding", &Sliding::Along(flank));
            holds("no parting", &Sliding::Across(flank));
            for sliding in Sign::BOTH {
                holds("follower", &FollowerArm { flank, sliding });
                holds("driver", &DriverArm { flank, sliding });
                holds("power", &PowerLost { flank, sliding });
            }
        }
    }
}
