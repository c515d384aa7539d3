//! A test piece that tells the play a machine needs: a ladder of slots, each wider than the pins by its rung.
//!
//! The pins are tried in one slot after the other; the least play with which they run from end to end is the machine's.

use crate::KinematicsError;
use crate::error::length;
use crate::wheel::{Edge, Face, Loop};
use nalgebra::Vector2;
use std::f64::consts::PI;

type Point = Vector2<f64>;

/// How much wider each slot of the ladder is than the one before it, in millimetres.
pub const RUNG: f64 = 0.05;
/// How many slots the ladder has.
const RUNGS: u32 = 12;
/// Pins that are made with it: one may come out worse than another.
const PINS: u32 = 3;

/// The outlines of a test piece, in millimetres.
///
/// ```
/// use geneva_kinematics::wheel::as_built::TestPiece;
///
/// let piece = TestPiece::new(6.0)?; // mm, the pin's diameter
/// assert_eq!((piece.plays.len(), piece.plate.holes.len()), (12, 12));
/// assert!((piece.plays[11] - 0.6).abs() < 1e-12); // mm
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TestPiece {
    /// The plate with a slot for each play, the narrowest first, and each slot as long as three pins.
    pub plate: Face,
    /// The pins, beside the plate.
    pub pins: Vec<Face>,
    /// Strokes to engrave: the play of each slot in hundredths of a millimetre, below it.
    pub strokes: Vec<[Point; 2]>,
    /// Play of each slot, in millimetres.
    pub plays: Vec<f64>,
}

/// The strokes of a digit, as a number of seven segments: top, upper right, lower right, bottom, lower left, upper left, middle.
const SEGMENTS: [[u8; 7]; 10] = [
    [1, 1, 1, 1, 1, 1, 0],
    [0, 1, 1, 0, 0, 0, 0],
    [1, 1, 0, 1, 1, 0, 1],
    [1, 1, 1, 1, 0, 0, 1],
    [0, 1, 1, 0, 0, 1, 1],
    [1, 0, 1, 1, 0, 1, 1],
    [1, 0, 1, 1, 1, 1, 1],
    [1, 1, 1, 0, 0, 0, 0],
    [1, 1, 1, 1, 1, 1, 1],
    [1, 1, 1, 1, 0, 1, 1],
];

/// A digit at a place, its lower left corner, so high.
fn digit(value: u32, at: Point, height: f64) -> Vec<[Point; 2]> {
    let (w, h) = (height / 2.0, height);
    let p = |x: f64, y: f64| at + Point::new(x * w, y * h);
    let lines = [
        [p(0.0, 1.0), p(1.0, 1.0)],
        [p(1.0, 1.0), p(1.0, 0.5)],
        [p(1.0, 0.5), p(1.0, 0.0)],
        [p(0.0, 0.0), p(1.0, 0.0)],
        [p(0.0, 0.5), p(0.0, 0.0)],
        [p(0.0, 1.0), p(0.0, 0.5)],
        [p(0.0, 0.5), p(1.0, 0.5)],
    ];
    let lit = SEGMENTS[(value % 10) as usize];
    lines.into_iter().zip(lit).filter(|(_, lit)| *lit == 1).map(|(line, _)| line).collect()
}

/// A slot with round ends, clockwise: from a point upwards, between the centres of its ends.
fn slot(bottom: Point, long: f64, width: f64) -> Loop {
    let half = width / 2.0;
    let top = bottom + Point::new(0.0, long);
    let right = Point::new(half, 0.0);
    Loop {
        edges: vec![
            Edge::Line { from: bottom - right, to: top - right },
            Edge::Arc { centre: top, radius: half, start: PI, sweep: -PI },
            Edge::Line { from: top + right, to: bottom + right },
            Edge::Arc { centre: bottom, radius: half, start: 0.0, sweep: -PI },
        ],
    }
}

fn rectangle(corners: [Point; 4]) -> Loop {
    let edges = (0..4).map(|k| Edge::Line { from: corners[k], to: corners[(k + 1) % 4] });
    Loop { edges: edges.collect() }
}

impl TestPiece {
    /// The test piece for pins of a diameter, in millimetres: slots with a play of 0.05 to 0.6 mm.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Length`] for a diameter that is not positive and finite.
    pub fn new(pin_diameter: f64) -> Result<Self, KinematicsError> {
        let d = length("pin diameter", pin_diameter)?;
        // Walls of half a pin between slots; digits below them.
        let (step, long, digits) = (1.5 * d + 0.6, 2.0 * d, d / 2.0);
        let plays: Vec<f64> = (1..=RUNGS).map(|k| RUNG * f64::from(k)).collect();
        let middle = |k: usize| step * (k as f64 + 0.5) + d / 2.0;
        let foot = 2.0 * digits + d;
        let holes =
            plays.iter().enumerate().map(|(k, play)| slot(Point::new(middle(k), foot), long, d + play)).collect();
        let strokes = plays.iter().enumerate().flat_map(|(k, play)| {
            let hundredths = libm::round(100.0 * play) as u32;
            let at = Point::new(middle(k) - 0.75 * digits, digits / 2.0);
            let second = at + Point::new(digits, 0.0);
            [digit(hundredths / 10, at, digits), digit(hundredths, second, digits)].concat()
        });
        let strokes = strokes.collect();
        let (wide, high) = (step * f64::from(RUNGS) + d, foot + long + d + 0.6);
        let corners = [[0.0, 0.0], [wide, 0.0], [wide, high], [0.0, high]].map(Point::from);
        let pin = |k: u32| {
            let centre = Point::new(d * (1.0 + 2.0 * f64::from(k)), high + d * 1.5);
            Face { outer: Loop::circle(centre, d / 2.0, false), holes: vec![] }
        };
        Ok(Self {
            plate: Face { outer: rectangle(corners), holes },
            pins: (0..PINS).map(pin).collect(),
            strokes,
            plays,
        })
    }
}
