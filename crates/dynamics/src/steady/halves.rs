//! Half an engagement, halved and halved again: places and points that do not depend on inertia, friction or torque.
//!
//! The stretches of an engagement that ends at the exit or beyond are among these, unless they are very short.

use super::arc::{Circle, Place};
use super::rule::rule;
use super::stretch::{Points, Spread};
use geneva_kinematics::Mechanism;
use std::ops::Deref;
use std::sync::LazyLock;

/// How often it is halved: then there are 31 parts.
const LEVELS: u32 = 5;

/// A part of the half engagement, from the line of centres to the exit.
#[derive(Debug)]
pub(super) struct Half {
    /// At the lower end, in the middle, at the upper end.
    pub places: [Place; 3],
    pub points: Points,
}

/// By mechanism, then the whole first, then its two halves, then their halves.
static HALVES: LazyLock<[Vec<Half>; 3]> = LazyLock::new(|| {
    Mechanism::ALL.map(|mechanism| {
        let circle = Circle::of(mechanism);
        let mut ends = vec![(0.0, circle.exit)];
        for number in 0..(1 << (LEVELS - 1)) - 1 {
            let (low, high) = ends[number];
            let middle = middle(low, high);
            ends.extend([(low, middle), (middle, high)]);
        }
        let half = |(low, high): (f64, f64)| Half {
            places: [low, middle(low, high), high].map(|w| circle.place(w)),
            points: Points::new(&circle, rule(), low, high, Spread::Even),
        };
        ends.into_iter().map(half).collect()
    })
});

/// Between two w.
pub(super) fn middle(low: f64, high: f64) -> f64 {
    low + (high - low) / 2.0
}

/// All halves of a mechanism. Those of the one with number k have the numbers 2 k + 1 and 2 k + 2.
pub(super) fn halves(mechanism: Mechanism) -> &'static [Half] {
    &HALVES[mechanism.index()]
}

/// Points of something else, or its own.
#[derive(Clone, Debug)]
pub(super) enum Net<'a> {
    Shared(&'a Points),
    Own(Box<Points>),
}

impl Deref for Net<'_> {
    type Target = Points;

    fn deref(&self) -> &Points {
        match self {
            Self::Shared(points) => points,
            Self::Own(points) => points,
        }
    }
}
