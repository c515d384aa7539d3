//! What a run prints, and what a reader takes from it.

use geneva_mimic::Work;

/// One printed line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Time from the start.
    pub time: f64,
    /// Angle in radians through which the driver has turned, unfolded.
    pub turned: f64,
    /// The folded crank angle, in radians from the line of centres.
    pub angle: f64,
    /// Driver's speed.
    pub speed: f64,
    /// Driver's acceleration.
    pub acceleration: f64,
    /// Follower's speed, by the velocity ratio at the folded angle.
    pub follower_speed: f64,
}

/// All lines of a run, and the work that it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Printout {
    /// The lines, the start included.
    pub lines: Vec<Line>,
    /// Steps and evaluations.
    pub work: Work,
}

impl Printout {
    /// The largest printed speed of the driver.
    pub fn largest(&self) -> f64 {
        self.lines.iter().map(|line| line.speed).fold(f64::NEG_INFINITY, f64::max)
    }
}
