//! The examination problem: a quick-return mechanism, its velocity and acceleration diagrams, the Coriolis term.
//!
//! The claims stand in the order of the source: what is given and asked, the position, the equations of the moving
//! frame, the velocities, the accelerations. The instant itself, from the printed data, is [`Instant`].

mod acceleration;
mod frames;
mod given;
mod had_been;
mod inventory;
mod position;
mod symbols;
mod velocity;

pub use had_been::{HadBeen, had_been};
pub use inventory::INVENTORY;
pub use symbols::SYMBOLS;

use crate::checks::{agrees, decimal, printed, rounds, same, vanishes};
use crate::{Check, Claim, Consequence, Erratum, Evidence, Finding, Origin, Slip, Verdict, Work};
use geneva_kinematics::Turn;
use geneva_kinematics::quick_return::series::{PolarRates, polar_rates};
use geneva_kinematics::quick_return::{Branch, Drive, LinkageError, Motion, Position, QuickReturn};
use std::f64::consts::PI;

const WORK: Work = Work::QuickReturn;

/// The mechanism at the printed instant. Lengths in m, angles from the direction lever pivot → crank axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// Ground and crank.
    pub linkage: QuickReturn,
    /// Where crank and lever are.
    pub position: Position,
    /// How the crank turns, in rad/s and rad/s².
    pub drive: Drive<f64>,
}

impl Instant {
    /// The instant of the printed data, on the branch that the source takes.
    pub fn printed() -> Result<Self, LinkageError> {
        Self::on(Branch::Far)
    }

    /// The printed data on either branch.
    pub fn on(branch: Branch) -> Result<Self, LinkageError> {
        Self::at(printed("quick-return.lever-angle"), branch)
    }

    /// The mirror image of the printed position, with the crank turning as before: the copy lost the drawing that
    /// would exclude it.
    pub fn mirrored() -> Result<Self, LinkageError> {
        Self::at(-printed("quick-return.lever-angle"), Branch::Far)
    }

    fn at(lever: f64, branch: Branch) -> Result<Self, LinkageError> {
        let linkage = QuickReturn::new(printed("quick-return.ground"), printed("quick-return.crank"))?;
        let position = linkage.at_lever_degrees(lever, branch)?;
        Ok(Self { linkage, position, drive: Drive::steady(printed("quick-return.driver-speed") * PI / 30.0) })
    }

    /// The route of the source: closed vector diagrams. `None` if the pin is on the lever's pivot.
    pub fn by_diagrams(&self) -> Option<Motion<f64>> {
        Motion::at(&self.linkage.ground(), &self.linkage.crank(), &self.position.crank, &self.drive)
    }

    /// The other route: the loop closure differentiated. `None` if the pin is on the lever's pivot.
    pub fn by_series(&self) -> Option<PolarRates<f64>> {
        polar_rates(&self.linkage.ground(), &self.linkage.crank(), &self.position.crank, &self.drive)
    }
}

/// All claims of the problem and its solution, in the order of the source.
pub fn claims() -> Vec<Claim> {
    [given::claims(), position::claims(), frames::claims(), velocity::claims(), acceleration::claims()].concat()
}

/// The erratum of a number whose last digits come from rounded steps.
fn rounded(corrected: &'static str, reason: &'static str) -> Erratum {
    let witness = "The loop closure differentiated by power series gives the corrected digits too.";
    Erratum {
        corrected,
        slip: Slip {
            id: "",
            reason,
            witness,
            origin: Origin::Arithmetic,
            consequence: Consequence::Result,
            changes: "",
        },
    }
}

/// A quantity of the diagrams at the printed instant.
fn diagram(quantity: fn(&Motion<f64>) -> f64) -> f64 {
    Instant::printed().ok().and_then(|instant| instant.by_diagrams()).map_or(f64::NAN, |motion| quantity(&motion))
}

/// A quantity of the differentiated loop closure at the printed instant.
fn series(quantity: fn(&PolarRates<f64>) -> f64) -> f64 {
    Instant::printed().ok().and_then(|instant| instant.by_series()).map_or(f64::NAN, |rates| quantity(&rates))
}

/// A quantity of the position at the printed instant.
fn position_of(quantity: fn(&Position) -> f64) -> f64 {
    Instant::printed().map_or(f64::NAN, |instant| quantity(&instant.position))
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

/// An angle in degrees from its cosine.
fn arccosine(cosine: f64) -> f64 {
    libm::acos(cosine).to_degrees()
}

use Evidence::{ClosedForm, ExactIdentity, Jet as Series, LimitCase, OtherPlaceInSource, Vectors};
