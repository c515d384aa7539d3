//! Special instants: which stroke, whether the lever is at rest, whether the pin is on the line of centres; and these facts
//! in words.

use geneva_kinematics::quick_return::{Branch, Position, QuickReturn};

/// Cosine of the angle at the pin that is zero as near as a typed lever angle can tell: at the end of the swing the
/// angle at the pin changes with the root of the lever's angle, and the root of one rounding is much larger than it.
const AT_REST: f64 = 4e-8;

/// Sine or cosine of a typed angle that is zero but for rounding.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Why a vector that need not be zero is reported as zero.
pub(super) const NOT_TOLD: &str = "too small to tell from zero";

/// The part of the crank's turn at an instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stroke {
    /// The longer part.
    Slow,
    /// The shorter part.
    Fast,
    /// Where one ends and the other begins.
    End,
}

/// Facts about an instant that hold at any speed.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeverInstant {
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
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Slow => "slow",
            Self::Fast => "fast",
            Self::End => "end",
        }
    }
}

impl LeverInstant {
    /// The facts for the parts in this position.
    pub(super) fn new(linkage: &QuickReturn, position: &Position) -> Self {
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
    pub(super) fn steady_lever(&self) -> bool {
        self.on_centre_line || self.half_speed
    }

    /// Which of the points on its ray the pin is at.
    pub(super) fn branch_in_words(&self) -> &'static str {
        match self.branch {
            _ if self.lever_at_rest => "near and far coincide: the lever is tangent to the crank's circle",
            _ if !self.swings => "far: the lever's ray meets the crank's circle only once",
            Branch::Near => "near: of the two points on the lever's ray, the one nearer to its pivot",
            Branch::Far => "far: of the two points on the lever's ray, the one farther from its pivot",
        }
    }

    /// Which stroke the lever is on, and what that means.
    pub(super) fn stroke_in_words(&self) -> &'static str {
        match (self.stroke, self.swings) {
            (Stroke::End, true) => "between the strokes: the lever reverses at the end of its swing",
            (Stroke::Slow, true) => "slow: the lever turns with the crank",
            (Stroke::Fast, true) => "fast: the lever turns against the crank",
            _ if self.half_speed => "the only stroke: the lever turns with the crank, at half its speed",
            (Stroke::End, false) => "between the strokes: the lever is at right angles to the line of centres",
            (Stroke::Slow, false) => "slow: the lever is on the side of the crank's axis",
            (Stroke::Fast, false) => "fast: the lever is on the side away from the crank's axis",
        }
    }

    /// Why the lever neither speeds up nor slows down.
    pub(super) fn no_angular_acceleration(&self) -> &'static str {
        match self {
            Self { half_speed: true, .. } => "the lever turns at half the crank's speed",
            Self { on_centre_line: true, .. } => "the pin is on the line of centres",
            _ => NOT_TOLD,
        }
    }

    /// Why the pin does not slide.
    pub(super) fn no_sliding(&self) -> &'static str {
        if self.on_centre_line { "the pin is on the line of centres" } else { NOT_TOLD }
    }

    /// Why the sliding neither speeds up nor slows down.
    pub(super) fn steady_sliding(&self) -> &'static str {
        match (self.stroke, self.swings) {
            (Stroke::End, true) => "the lever is at rest, the crank across it",
            (Stroke::End, false) => "the lever turns as fast as the crank",
            _ => NOT_TOLD,
        }
    }
}
