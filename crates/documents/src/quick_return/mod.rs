//! The examination problem: a quick-return mechanism, its velocity and acceleration diagrams, the Coriolis term.
//!
//! The claims follow the order of the source: what is given and asked, the position, the equations of the moving frame,
//! the velocities, the accelerations. The instant itself, from the printed values, is [`LeverProblem`].

mod acceleration;
mod coriolis;
mod frames;
mod given;
mod letters;
mod moving_frame;
mod places;
mod position;
mod rounding;
mod symbols;
mod velocity;
mod with_printed_angle;

pub use symbols::SYMBOLS;
pub use with_printed_angle::{WithPrintedAngle, with_printed_angle};

use crate::duals::{Crank, Time, advance, path, turned};
use geneva_evidence::agreement::{agrees, coincide, pair, vanishes};
use geneva_evidence::{
    Cache, Claim, Consequence, Document, Evidence, Finding, InventoryFile, Locator, Origin, Slip, Stated, Verdict,
};
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::quick_return::series::{PolarRates, polar_rates};
use geneva_kinematics::quick_return::{Branch, Drive, LeverMotion, Position, QuickReturn};
use geneva_kinematics::{KinematicsError, Turn};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// An examination problem: velocity and acceleration diagram of a quick-return mechanism.
pub static QUICK_RETURN: Document = Document {
    slug: "quick-return",
    title: "examination problem",
    citation: "Examination problem on the dynamics of machinery with its worked solution: velocity and acceleration \
        diagram of a slotted-lever quick-return mechanism. Copy without drawings, title, author or year.",
    inventory: Some(InventoryFile {
        path: "crates/documents/sources/quick-return.inventory",
        text: include_str!("../../sources/quick-return.inventory"),
    }),
    claims,
    answers: ANSWERS,
    given: Vec::new,
    conclusions: &[],
    symbols: SYMBOLS,
    units: &[
        ("speed of the crank", "r.p.m."),
        ("angular velocity", "rad/s"),
        ("speed of the", "m/s"),
        ("angular acceleration", "rad/s^2"),
        ("acceleration", "m/s^2"),
        ("angle", "°"),
        ("distance", ""),
        ("radius", ""),
    ],
    test: "cargo test -p geneva-documents --test verdicts quick_return_stands",
    cache: Cache::new(),
};

/// A place in this source.
const fn at(locator: &'static str) -> Locator {
    Locator::new(&QUICK_RETURN, locator)
}

/// What the problem asks for: each term of its two equations, and the angular velocity and acceleration of the lever.
pub const ANSWERS: &[&str] = &[
    "quick-return.pin-speed",
    "quick-return.lever-point-speed",
    "quick-return.sliding-speed",
    "quick-return.lever-speed",
    "quick-return.pin-normal",
    "quick-return.pin-tangential",
    "quick-return.lever-normal",
    "quick-return.lever-tangential",
    "quick-return.sliding-normal",
    "quick-return.sliding-acceleration",
    "quick-return.coriolis",
    "quick-return.lever-acceleration",
];

/// The mechanism at the printed instant. Lengths in m, angles from the direction lever pivot → crank axis.
#[derive(Clone, Debug, PartialEq)]
pub struct LeverProblem {
    /// Ground and crank.
    pub linkage: QuickReturn,
    /// Where crank and lever are.
    pub position: Position,
    /// How the crank turns, in rad/s and rad/s².
    pub drive: Drive<f64>,
}

impl LeverProblem {
    /// Builds the instant from the printed values, on the branch that the source takes. Tests also try its mirror image.
    pub fn printed() -> Result<Self, KinematicsError> {
        #[cfg(test)]
        if MIRRORED.get() {
            return Self::mirrored();
        }
        Self::on(Branch::Far)
    }

    /// The printed data on either branch.
    pub fn on(branch: Branch) -> Result<Self, KinematicsError> {
        Self::at(QUICK_RETURN.printed_number("quick-return.lever-angle"), branch)
    }

    /// The mirror image of the printed position, with the crank turning as before: the copy lost the drawing that
    /// would exclude it.
    pub fn mirrored() -> Result<Self, KinematicsError> {
        Self::at(-QUICK_RETURN.printed_number("quick-return.lever-angle"), Branch::Far)
    }

    fn at(lever: f64, branch: Branch) -> Result<Self, KinematicsError> {
        let linkage = QuickReturn::new(
            QUICK_RETURN.printed_number("quick-return.ground"),
            QUICK_RETURN.printed_number("quick-return.crank"),
        )?;
        let position = linkage.position_at_lever_degrees(lever, branch)?;
        Ok(Self {
            linkage,
            position,
            drive: Drive::steady(QUICK_RETURN.printed_number("quick-return.driver-speed") * PI / 30.0),
        })
    }

    /// Solves by the source's own route, closed vector diagrams. `None` if the pin is on the lever's pivot.
    pub fn by_diagrams(&self) -> Option<LeverMotion<f64>> {
        LeverMotion::new(&self.linkage.ground(), &self.linkage.crank(), &self.position.crank, &self.drive)
    }

    /// Solves by a second route, the differentiated loop closure. `None` if the pin is on the lever's pivot.
    pub fn by_series(&self) -> Option<PolarRates<f64>> {
        polar_rates(&self.linkage.ground(), &self.linkage.crank(), &self.position.crank, &self.drive)
    }

    /// Sets up a third route, with dual numbers, for the witnesses.
    fn by_duals(&self) -> Crank {
        Crank {
            ground: self.linkage.ground(),
            radius: self.linkage.crank(),
            angle: self.position.crank.radians(),
            speed: self.drive.speed,
            acceleration: self.drive.acceleration,
        }
    }

    /// The vector from the crank's axis to the pin.
    fn arm(&self) -> Vector2<f64> {
        self.position.crank.direction() * self.linkage.crank()
    }
}

/// All claims of the problem and its solution, in the order of the source.
pub fn claims() -> Vec<Claim> {
    let parts =
        [given::claims, position::claims, places::claims, frames::claims, velocity::claims, acceleration::claims];
    parts.map(|claims| claims()).concat()
}

/// A quantity of the diagrams at the printed instant.
fn diagram(quantity: fn(&LeverMotion<f64>) -> f64) -> f64 {
    LeverProblem::printed().ok().and_then(|instant| instant.by_diagrams()).map_or(f64::NAN, |motion| quantity(&motion))
}

/// A quantity of the differentiated loop closure at the printed instant.
fn series(quantity: fn(&PolarRates<f64>) -> f64) -> f64 {
    LeverProblem::printed().ok().and_then(|instant| instant.by_series()).map_or(f64::NAN, |rates| quantity(&rates))
}

/// What is found at the printed instant.
fn at_the_instant(find: impl Fn(&LeverProblem) -> Option<Finding>) -> Finding {
    LeverProblem::printed().ok().and_then(|instant| find(&instant)).unwrap_or_else(nowhere)
}

/// What is found at the printed instant and at its mirror image; it must hold at both.
fn in_both_drawings(find: impl Fn(&LeverProblem) -> Option<Finding>) -> Finding {
    let [drawn, mirrored] = [LeverProblem::printed(), LeverProblem::mirrored()]
        .map(|instant| instant.ok().and_then(|instant| find(&instant)).unwrap_or_else(nowhere));
    Finding::new(drawn.holds && mirrored.holds, both_drawings(&drawn.how, &mirrored.how))
}

/// What is found at the printed instant from where the pin is, by dual numbers.
fn from_duals(find: impl Fn(&Crank) -> Finding) -> Finding {
    at_the_instant(|instant| Some(find(&instant.by_duals())))
}

fn nowhere() -> Finding {
    Finding::new(false, "there is no such position")
}

/// A finding in two drawings, which is said once if both give it.
fn both_drawings(drawn: &str, mirrored: &str) -> String {
    if drawn == mirrored {
        format!("in the printed position and in its mirror image, {drawn}")
    } else {
        format!("{drawn}, and in the mirror image {mirrored}")
    }
}

/// The components of a vector.
fn in_words(vector: &Vector2<f64>) -> String {
    format!("({:.3}, {:.3})", vector.x, vector.y)
}

/// Two vectors that must agree, by their components.
fn alike(a: &Vector2<f64>, b: &Vector2<f64>) -> Finding {
    Finding::new(coincide(a, b), pair("vector", &in_words(a), &in_words(b)))
}

/// A quantity of the position at the printed instant.
fn position_of(quantity: fn(&Position) -> f64) -> f64 {
    LeverProblem::printed().map_or(f64::NAN, |instant| quantity(&instant.position))
}

/// r, the distance of the pin from the lever's pivot, by the differentiated loop closure.
fn radius(rates: &PolarRates<f64>) -> f64 {
    rates.position.norm()
}

/// The sine of an angle in degrees.
fn sine(degrees: f64) -> f64 {
    Turn::from_degrees(degrees).sin
}

/// The cosine of an angle in degrees.
fn cosine(degrees: f64) -> f64 {
    Turn::from_degrees(degrees).cos
}

/// An angle in degrees from its sine.
fn arcsine(sine: f64) -> f64 {
    libm::asin(sine).to_degrees()
}

/// β in degrees for a lever angle in degrees, by the law of sines with the printed lengths; the acute one.
fn angle_at_pin(lever: f64) -> f64 {
    arcsine(
        QUICK_RETURN.printed_number("quick-return.ground") * sine(lever)
            / QUICK_RETURN.printed_number("quick-return.crank"),
    )
}

/// The lever's length for a lever angle in degrees, by the projections of ground and crank.
fn projected_length(lever: f64) -> f64 {
    QUICK_RETURN.printed_number("quick-return.ground") * cosine(lever)
        + QUICK_RETURN.printed_number("quick-return.crank") * cosine(angle_at_pin(lever))
}

/// An angle in degrees from its cosine.
fn arccosine(cosine: f64) -> f64 {
    libm::acos(cosine).to_degrees()
}

#[cfg(test)]
thread_local! {
    /// Whether a test tries the mirror image on this thread.
    static MIRRORED: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::{Check, judge};

    #[test]
    fn what_is_not_open_stands_in_the_mirror_image_too() {
        let (mut tried, mut fail) = (0, Vec::new());
        for claim in QUICK_RETURN.claims().iter() {
            if matches!(claim.check, Check::Missing { .. }) {
                continue;
            }
            MIRRORED.set(true);
            let judged = judge(claim);
            MIRRORED.set(false);
            if !judged.matches_record() {
                fail.push(format!("{}: {}", claim.id, judged.complaints().join("; ")));
            }
            tried += 1;
        }
        assert!(fail.is_empty(), "{}", fail.join("\n"));
        assert!(tried > 50, "only {tried} were tried");
    }
}
