//! What is special at an instant: which stroke, whether the lever is at rest, whether the pin is on the line of centres.

use geneva_kinematics::quick_return::{Branch, Position, QuickReturn};

/// Cosine of the angle at the pin that is zero as near as a typed lever angle can tell: at the end of the swing the
/// angle at the pin changes with the root of the lever's angle, and the root of one rounding is much larger than it.
const AT_REST: f64 = 4e-8;

/// Sine or cosine of a typed angle that is zero but for rounding.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The part of the crank's turn at an instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// The longer part.
    Slow,
    /// The shorter part.
    Fast,
    /// Where one ends and the other begins.
    End,
}

/// What is so at an instant, at any speed.
#[derive(Clone, Copy, Debug)]
pub struct Instant {
    /// On which branch the pin is.
    pub branch: Branch,
    /// On which stroke the lever is.
    pub stroke: Stroke,
    /// Whether the lever swings to and fro; otherwise it turns.
    pub swings: bool,
    /// Whether the crank is as long as the ground distance: the lever turns at half the speed of the crank.
    pub half_speed: bool,
    /// Whether the lever is at the end of its swing, where it is at rest.
    pub lever_at_rest: bool,
    /// Whether the pin is on the line through both axes, where it does not slide.
    pub on_centre_line: bool,
}

impl Stroke {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Slow => "slow",
            Self::Fast => "fast",
            Self::End => "end",
        }
    }
}

impl Instant {
    /// What is so with the parts there.
    pub fn of(linkage: &QuickReturn, position: &Position) -> Self {
        let ratio = linkage.ratio();
        let (swings, half_speed) = (ratio > 1.0, ratio == 1.0);
        // The ray of a lever whose pivot is not outside of the crank's circle leaves the circle once.
        let branch = if swings { position.branch() } else { Branch::Far };
        let (crank, lever) = (&position.crank, &position.lever);
        let across = crank.cos * lever.cos + crank.sin * lever.sin;
        let lever_at_rest = swings && across.abs() <= AT_REST;
        let stroke = match branch {
            _ if lever_at_rest => Stroke::End,
            Branch::Near => Stroke::Fast,
            Branch::Far if swings || half_speed => Stroke::Slow,
            Branch::Far if lever.cos.abs() <= ROUNDING => Stroke::End,
            Branch::Far if lever.cos < 0.0 => Stroke::Fast,
            Branch::Far => Stroke::Slow,
        };
        Self { branch, stroke, swings, half_speed, lever_at_rest, on_centre_line: crank.sin.abs() <= ROUNDING }
    }

    /// Whether the lever neither speeds up nor slows down.
    pub fn steady_lever(&self) -> bool {
        self.on_centre_line || self.half_speed
    }
}
