//! A pin on a crank in the slot of a follower, differentiated by another library's dual numbers.
//!
//! A third way to the rates, beside the vector diagrams and the power series: nothing here is shared with them. The
//! frame has its origin at the follower's pivot and its first axis towards the crank's axis.

use nalgebra::Vector2;
use num_dual::{Dual2_64, DualNum, second_derivative};
use std::f64::consts::PI;

/// A function of time with its first two rates.
pub(crate) type Time = Dual2_64;

/// A crank and how it turns, for a follower whose pivot is at the distance `ground` from the crank's axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crank {
    /// Distance of the two axes.
    pub ground: f64,
    /// Distance of the pin from the crank's axis.
    pub radius: f64,
    /// Crank angle at time zero in radians, counter-clockwise from the direction pivot to crank's axis.
    pub angle: f64,
    /// Angular velocity in rad/s.
    pub speed: f64,
    /// Angular acceleration in rad/s².
    pub acceleration: f64,
}

impl Crank {
    /// Where the pin is.
    pub(crate) fn pin(&self, t: Time) -> [Time; 2] {
        let angle = advance(self.speed, self.acceleration, t) + self.angle;
        let (sine, cosine) = sine_and_cosine(angle);
        [cosine * self.radius + self.ground, sine * self.radius]
    }

    /// The angle of the slot, from the direction pivot to crank's axis, in radians.
    pub(crate) fn slot(&self, t: Time) -> Time {
        direction(self.pin(t))
    }

    /// The distance of the pin from the follower's pivot.
    pub(crate) fn distance(&self, t: Time) -> Time {
        let [x, y] = self.pin(t);
        (x * x + y * y).sqrt()
    }

    /// Where the follower's point is that lies under the pin at time zero.
    pub(crate) fn point_under_the_pin(&self, t: Time) -> [Time; 2] {
        let (slot, distance) = (self.slot(t), self.distance(Time::from_re(0.0)).re);
        let (sine, cosine) = sine_and_cosine(slot);
        [cosine * distance, sine * distance]
    }

    /// Distance and slot angle at time zero, each with its two rates.
    pub(crate) fn polar(&self) -> [[f64; 3]; 2] {
        second_derivative(|t| [self.distance(t), self.slot(t)], 0.0).map(<[f64; 3]>::from)
    }

    /// Place, velocity and acceleration of the pin at time zero.
    pub(crate) fn pin_motion(&self) -> [Vector2<f64>; 3] {
        path(|t| self.pin(t))
    }

    /// Place, velocity and acceleration at time zero of the follower's point under the pin.
    pub(crate) fn point_motion(&self) -> [Vector2<f64>; 3] {
        path(|t| self.point_under_the_pin(t))
    }
}

/// The centre distance in crank radii at which a follower stands still with its slot at this angle from the line of centres:
/// found by halving, from where the pin is alone.
pub(crate) fn ratio_with_standstill_at(slot: f64) -> f64 {
    halved([1.0, 1e3], |ratio| {
        // The crank angle at which the slot turns back, and how far it has turned by then.
        let rates = |angle: f64| Crank { ground: ratio, radius: 1.0, angle, speed: 1.0, acceleration: 0.0 }.polar()[1];
        let [angle, _] = halved([PI / 2.0, PI], |angle| rates(angle)[1] > 0.0);
        rates(angle)[0] > slot
    })[0]
}

/// The interval in which a condition that holds at its lower end ceases to hold, halved until nothing is left of it.
pub(crate) fn halved([mut low, mut high]: [f64; 2], holds: impl Fn(f64) -> bool) -> [f64; 2] {
    loop {
        let middle = low.midpoint(high);
        if middle <= low || middle >= high {
            return [low, high];
        }
        if holds(middle) { low = middle } else { high = middle }
    }
}

/// The angle through which something turns that has this angular velocity and acceleration.
pub(crate) fn advance(speed: f64, acceleration: f64, t: Time) -> Time {
    t * speed + t * t * (acceleration / 2.0)
}

/// Place, velocity and acceleration at time zero of a point whose place is given as a function of time.
pub(crate) fn path(place: impl Fn(Time) -> [Time; 2]) -> [Vector2<f64>; 3] {
    let [x, y] = second_derivative(place, 0.0).map(<[f64; 3]>::from);
    std::array::from_fn(|order| Vector2::new(x[order], y[order]))
}

/// A place turned about the origin, counter-clockwise.
pub(crate) fn turned([x, y]: [Time; 2], angle: Time) -> [Time; 2] {
    let (sine, cosine) = sine_and_cosine(angle);
    [x * cosine - y * sine, x * sine + y * cosine]
}

/// Sine and cosine by the addition theorem: their values from the portable library, their rates from the dual numbers.
fn sine_and_cosine(angle: Time) -> (Time, Time) {
    let (sine, cosine) = (libm::sin(angle.re), libm::cos(angle.re));
    let (small_sine, small_cosine) = (angle - angle.re).sin_cos();
    (small_cosine * sine + small_sine * cosine, small_cosine * cosine - small_sine * sine)
}

/// The angle of a direction from the first axis; in the same manner.
fn direction([x, y]: [Time; 2]) -> Time {
    let turned = (y * x.re - x * y.re) / (x * x.re + y * y.re);
    turned.atan() + libm::atan2(y.re, x.re)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crank_about_the_pivot_carries_its_pin_in_a_circle() {
        let crank = Crank { ground: 0.0, radius: 2.0, angle: 0.5, speed: 3.0, acceleration: 4.0 };
        let [distance, slot] = crank.polar();
        let near = |found: [f64; 3], expected: [f64; 3]| {
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-14, "{found} for {expected}");
            }
        };
        near(distance, [2.0, 0.0, 0.0]);
        near(slot, [0.5, 3.0, 4.0]);
        let ([_, velocity, acceleration], e) = (crank.pin_motion(), Vector2::new(0.5f64.cos(), 0.5f64.sin()));
        near([velocity.dot(&e), e.perp(&velocity), 0.0], [0.0, 6.0, 0.0]);
        near([acceleration.dot(&e), e.perp(&acceleration), 0.0], [-18.0, 8.0, 0.0]);
        assert!((crank.point_motion()[2] - acceleration).norm() < 1e-13);
    }
}
