//! The escapement as a timekeeper: what changes its rate, how hard its members are driven, and two other
//! escapements without a spring: a runaway escapement and a verge with its foliot.

mod friction;
mod runaway;
mod sensitivity;
mod settling;
mod strongest;
#[cfg(test)]
mod tests;
mod torque;
mod verge;

pub use friction::friction;
pub use runaway::runaway;
pub use sensitivity::sensitivity;
pub use settling::settling;
pub use strongest::strongest;
pub use torque::torque;
pub use verge::verge;

use crate::FigureError;
use crate::chart::{ChartAxis, LegendEntry, of_mechanism};
use crate::number::extent;
use crate::svg::Label;
use geneva_case1973::{Hypothesis, Row};
use geneva_dynamics::Parameters;
use geneva_dynamics::existence::critical_friction;

/// Hours and minutes of a day.
const HOURS: f64 = 24.0;
const MINUTES: f64 = 1440.0;
/// How near to the critical friction a curve goes, as a part of it.
const NEAREST: f64 = 0.995;

/// An escapement and the frictions with which it was run.
#[derive(Clone, Debug, PartialEq)]
pub struct Tested {
    /// The escapement with one of the frictions.
    pub parameters: Parameters,
    /// The frictions, rising.
    pub frictions: Vec<f64>,
}

impl Tested {
    /// The printed runs of a mechanism, as it is. None without rows.
    pub fn from_rows(rows: &[Row]) -> Option<Self> {
        let mut frictions: Vec<f64> = rows.iter().map(Row::friction).collect();
        frictions.sort_by(f64::total_cmp);
        frictions.dedup();
        Some(Self { parameters: Hypothesis::IDEAL.parameters(rows.first()?)?, frictions })
    }

    /// The escapement with another friction.
    fn with_friction(&self, friction: f64) -> Result<Parameters, FigureError> {
        Ok(self.parameters.with_friction(friction)?)
    }

    /// The quantities at so many steps of friction between the ends, and at the frictions of the runs.
    fn curve(
        &self,
        [from, to]: [f64; 2],
        steps: u32,
        quantities: impl Fn(&Parameters) -> Result<[f64; 4], FigureError>,
    ) -> Result<Curve, FigureError> {
        let mechanism = self.parameters.mechanism();
        let pins = f64::from(mechanism.pins());
        let point = |friction| Ok(Point { pins, friction, values: quantities(&self.with_friction(friction)?)? });
        let points = |frictions: &[f64]| frictions.iter().copied().map(point).collect::<Result<Vec<_>, FigureError>>();
        let curve = points(&self.steps(from, to, steps)?)?;
        Ok(Curve { slots: mechanism.slots(), points: curve, marks: points(&self.frictions)? })
    }

    /// So many steps of friction from one to another, or to where the escapement jams.
    fn steps(&self, from: f64, to: f64, steps: u32) -> Result<Vec<f64>, FigureError> {
        let critical = critical_friction(self.parameters.mechanism(), self.parameters.inertias().ratio())?.friction;
        let end = to.min(NEAREST * critical);
        Ok((0..=steps).map(|k| from + (end - from) * f64::from(k) / f64::from(steps)).collect())
    }
}

/// Four quantities of an escapement over the friction: at the points of its curve, and at the frictions of its runs.
struct Curve {
    slots: u32,
    points: Vec<Point>,
    marks: Vec<Point>,
}

/// One escapement at one friction.
struct Point {
    pins: f64,
    friction: f64,
    values: [f64; 4],
}

impl Point {
    /// Where the point is in a panel of this quantity.
    fn at(&self, quantity: usize) -> (f64, f64) {
        (self.friction, self.values[quantity])
    }
}

/// The least and the greatest friction of all runs.
fn frictions(all: &[Tested]) -> Result<[f64; 2], FigureError> {
    let frictions = || all.iter().flat_map(|one| one.frictions.iter().copied());
    let ends = extent(frictions());
    if ends[0] < ends[1] { Ok(ends) } else { Err(FigureError::Nothing) }
}

/// The axis of the frictions of all runs, with some room at both ends.
fn axis(all: &[Tested]) -> Result<ChartAxis, FigureError> {
    let [least, most] = frictions(all)?;
    let room = 0.06 * (most - least);
    let steps = ChartAxis::spanning(least, most, 3.0);
    let range = least - room..most + room;
    Ok(ChartAxis { ticks: steps.ticks.iter().copied().filter(|mark| range.contains(mark)).collect(), range, ..steps })
}

/// The title of an axis of frictions.
fn of_friction() -> Label {
    Label::words("coefficient of friction ").and_symbol("μ")
}

/// What the colours stand for: the mechanisms.
fn key(all: &[Tested]) -> Vec<LegendEntry> {
    let entry = |one: &Tested| {
        let look = of_mechanism(one.parameters.mechanism().slots());
        LegendEntry::curve_with_marks(
            look,
            Label::words(&format!("{} pins", one.parameters.mechanism().pins())).in_colour(look.1.colour),
        )
    };
    all.iter().map(entry).collect()
}

/// The ratios of the inertias, as a caption ends.
fn inertias(all: &[Tested]) -> String {
    let of = |one: &Tested| {
        let ratio = crate::number::significant(one.parameters.inertias().ratio(), 2);
        format!("{ratio} with {} pins", one.parameters.mechanism().pins())
    };
    format!(
        "Ratio of the driver's moment of inertia to the follower's: {}.",
        all.iter().map(of).collect::<Vec<_>>().join(", ")
    )
}
