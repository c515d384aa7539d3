//! In which order the terms of the acceleration are laid end to end: one in which they do not cross.

use super::steps::Direction;
use crate::theme::{FOLLOWER, RELATIVE};
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::quick_return::LeverMotion;
use nalgebra::Vector2;

/// The place of the Coriolis term in an order in which neighbours are at right angles and the two terms of unknown
/// length follow one another.
///
/// Read backwards each order gives the same drawing, turned by half a turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// Lever normal, lever tangential, sliding, Coriolis: the last one is drawn back from the common tip.
    Last,
    /// Coriolis, lever normal, lever tangential, sliding.
    First,
    /// Lever normal, Coriolis, sliding, lever tangential.
    Second,
}

/// The terms of the lever's side, each with its tail.
#[derive(Clone, Debug)]
pub(super) struct Laid {
    pub order: Order,
    pub lever_normal: Vector2<f64>,
    pub lever_tangential: Vector2<f64>,
    pub sliding: Vector2<f64>,
    pub coriolis: Vector2<f64>,
    /// Where the two terms of unknown length meet.
    pub meeting: Vector2<f64>,
}

impl Laid {
    /// The first of the orders with the fewest crossings.
    pub(super) fn new(motion: &LeverMotion<f64>) -> Self {
        use Order::{First, Last, Second};
        let mut best = Self::in_order(motion, Last);
        for order in [First, Second] {
            let other = Self::in_order(motion, order);
            if other.crossings(motion) < best.crossings(motion) {
                best = other;
            }
        }
        best
    }

    fn in_order(motion: &LeverMotion<f64>, order: Order) -> Self {
        let terms = &motion.accelerations;
        let [n, t, s, c] = [terms.follower_normal, terms.follower_tangential, terms.sliding_tangential, terms.coriolis];
        let zero = Vector2::zeros();
        let (lever_normal, lever_tangential, sliding, coriolis, meeting) = match order {
            // What is known of the other end is laid back from the tip of the pin's acceleration.
            Order::Last => (zero, n, n + t, motion.pin_normal + motion.pin_tangential - c, n + t),
            Order::First => (c, c + n, c + n + t, zero, c + n + t),
            Order::Second => (zero, n + c + s, n + c, n, n + c + s),
        };
        Self { order, lever_normal, lever_tangential, sliding, coriolis, meeting }
    }

    /// The lines on which the two terms lie: the one from the end of what is known at the pole, the other through
    /// the end of what is known at the tip.
    pub(super) fn directions(&self, motion: &LeverMotion<f64>, along: Vector2<f64>) -> [Direction; 2] {
        let tip = motion.pin_normal + motion.pin_tangential;
        let (across_from, along_from) = match self.order {
            Order::Last => (self.lever_tangential, self.coriolis),
            Order::First => (self.lever_tangential, tip),
            Order::Second => (tip, self.sliding),
        };
        let meeting = self.meeting;
        let direction = |name, words, from, along, colour| Direction { name, words, from, along, meeting, colour };
        [
            direction("across", "⊥ lever", across_from, quarter_turn(&along), FOLLOWER),
            direction("along", "∥ lever", along_from, along, RELATIVE),
        ]
    }

    /// How many pairs of vectors cross.
    fn crossings(&self, motion: &LeverMotion<f64>) -> usize {
        let terms = &motion.accelerations;
        let lines = [
            (Vector2::zeros(), motion.pin_normal),
            (motion.pin_normal, motion.pin_tangential),
            (self.lever_normal, terms.follower_normal),
            (self.lever_tangential, terms.follower_tangential),
            (self.sliding, terms.sliding_tangential),
            (self.coriolis, terms.coriolis),
        ];
        let pairs =
            lines.iter().enumerate().flat_map(|(k, one)| lines.iter().skip(k + 1).map(move |other| (one, other)));
        pairs.filter(|(one, other)| cross(one, other)).count()
    }
}

/// Whether two vectors at their tails cross, by more than rounding.
fn cross(one: &(Vector2<f64>, Vector2<f64>), other: &(Vector2<f64>, Vector2<f64>)) -> bool {
    let apart = |(tail, vector): &(Vector2<f64>, Vector2<f64>), (from, along): &(Vector2<f64>, Vector2<f64>)| {
        let [a, b] = [from - tail, from + along - tail].map(|end| vector.perp(&end));
        a * b < 0.0 && a.abs().min(b.abs()) > 1e-9 * vector.norm() * along.norm()
    };
    apart(one, other) && apart(other, one)
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::Turn;
    use geneva_kinematics::quick_return::Drive;

    #[test]
    fn touching_is_not_crossing() {
        let at = |x: f64, y: f64, u: f64, v: f64| (Vector2::new(x, y), Vector2::new(u, v));
        assert!(cross(&at(0.0, 0.0, 2.0, 2.0), &at(0.0, 2.0, 2.0, -2.0)));
        assert!(!cross(&at(0.0, 0.0, 2.0, 2.0), &at(2.0, 2.0, 1.0, -2.0)));
        assert!(!cross(&at(0.0, 0.0, 2.0, 2.0), &at(1.0, 1.0, 3.0, 3.0)));
    }

    #[test]
    fn in_every_order_the_last_term_ends_where_the_pin_s_acceleration_does() {
        let drive = Drive { speed: 3.0, acceleration: -5.0 };
        for degrees in (0..360).step_by(13) {
            let motion =
                LeverMotion::new(&1.9, &1.0, &Turn::from_degrees(f64::from(degrees)), &drive).expect("off the pivot");
            let (tip, terms) = (motion.pin_normal + motion.pin_tangential, &motion.accelerations);
            for order in [Order::Last, Order::First, Order::Second] {
                let laid = Laid::in_order(&motion, order);
                let end = match order {
                    Order::Last => laid.coriolis + terms.coriolis,
                    Order::First => laid.sliding + terms.sliding_tangential,
                    Order::Second => laid.lever_tangential + terms.follower_tangential,
                };
                assert!((end - tip).norm() < 1e-12 * tip.norm(), "{order:?} at {degrees}°");
            }
        }
    }

    #[test]
    fn hardly_any_position_is_left_with_a_crossing() {
        let crossings = |degrees: u32| {
            let crank = Turn::from_degrees(f64::from(degrees));
            let motion = LeverMotion::new(&1.9, &1.0, &crank, &Drive::steady(3.0)).expect("off the pivot");
            Laid::new(&motion).crossings(&motion)
        };
        assert!((0..360).map(crossings).filter(|count| *count > 0).count() < 36);
    }
}
