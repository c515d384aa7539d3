//! Why a crescent about the wheel's axis bites: how far a horn's tip stays from it, and from the one that is cut instead.

use crate::chart::{Chart, ChartAxis, LineStyle, Panel};
use crate::number::extent;
use crate::svg::Label;
use crate::theme::{DRIVER, INK, RELATIVE};
use crate::{Figure, FigureError, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Crescent, LockingDisc, Sizes};
use std::f64::consts::FRAC_PI_4;

/// Steps of the crank from the middle of the engagement to its end.
const PLACES: u32 = 120;
const HEIGHT: f64 = 330.0;
/// The x axis has at least so many steps.
const STEPS: f64 = 4.0;

/// Gaps in millimetres between a horn's tip and two crescents, while the tip is within the locking disc's circle: an arc
/// about the wheel's axis in mid-index, of the rim's radius and the gap of the locking arcs, and the crescent of these
/// sizes. Below zero the tip is in the disc.
///
/// Series: crank angle, both gaps.
///
/// # Errors
///
/// [`FigureError::Wheel`] if the tip's place is asked for beyond the engagement, which does not happen.
pub fn crescent(sizes: &Sizes) -> Result<Figure, FigureError> {
    let mut rows = Vec::new();
    let end = sizes.wheel.engagement_half_angle();
    if let Some(disc) = sizes.locking_disc {
        let radius = sizes.tip_radius + sizes.play.locking / 2.0;
        let crescent = Crescent { centre: sizes.centre_distance, radius, ..disc.crescent };
        let about_axis = LockingDisc { crescent, ..disc };
        for k in 0..=PLACES {
            let crank = (end * f64::from(k) / f64::from(PLACES)).min(end);
            if sizes.horn_tip(crank)?.norm() < disc.radius {
                rows.push([crank.to_degrees(), sizes.horn_gap(crank, &about_axis)?, sizes.horn_gap(crank, &disc)?]);
            }
        }
    }
    let gaps = || rows.iter().flat_map(|row| [row[1], row[2]]);
    let [least, most] = extent(gaps().chain([0.0]));
    let x = ChartAxis::of_angles(0.0, end.to_degrees(), STEPS)
        .titled(Label::words("crank angle ").and_symbol("θ").and(", °"));
    let y = ChartAxis::from_zero(least, most, 4.0).titled(Label::words("gap at the horn’s tip, mm"));
    let points = |column: usize| rows.iter().map(move |row| (row[0], row[column]));
    let (bites, passes) = (LineStyle::new(DRIVER).wide(2.0).dashed("8 6"), LineStyle::new(RELATIVE).wide(2.0));
    let panel = Panel::new(HEIGHT, &x, &y)
        .curve(points(1), bites)
        .curve(points(2), passes)
        .horizontal(0.0, LineStyle::new(INK))
        .name_near(points(1), -FRAC_PI_4, Label::words("arc about the wheel’s axis").in_colour(bites.colour))
        .name_near(points(2), 3.0 * FRAC_PI_4, Label::words("the crescent of the drawing").in_colour(passes.colour));
    let words = Words::new(
        "wheel-crescent",
        format!("Gap between a horn's tip and the crescent, {} stations", sizes.wheel.stations()),
        "Two curves over the crank angle while the tip of a horn is within the locking disc. For the arc about the wheel's axis the gap \
         falls below zero over a part of the engagement: the disc bites into the horn. For the other crescent it stays above \
         zero.",
        "The gap between the crescent and the tip of the horn behind the slot. The curves cover the crank angles, past \
         the line of centres, at which this tip is inside the circle of the locking disc. Where the gap is below zero, \
         the disc bites into the horn. That happens if the crescent is an arc whose radius is the radius of the \
         wheel's rim plus the gap of the locking disc, and whose centre is on the wheel's axis in mid-index. For the \
         horn in front of the slot, the curves are mirrored about the line of centres. \
         Rigid parts, pin in the middle of its slot.",
    );
    let columns = [("theta", "deg"), ("gap about axis", "mm"), ("gap", "mm")];
    Ok(Chart::new([panel]).figure(words, Series::new(columns, rows)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::assert_drawn;
    use geneva_kinematics::wheel::{Choices, Scale, Wheel};

    #[test]
    fn the_arc_about_the_axis_bites_and_the_other_keeps_the_clearance() {
        for stations in 3..=18 {
            let wheel = Wheel::new(stations).expect("possible");
            let sizes = Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices::default()).expect("fits");
            let figure = crescent(&sizes).expect("drawn");
            assert_drawn(&figure);
            let least = |column: usize| figure.series.rows.iter().map(|row| row[column]).fold(f64::INFINITY, f64::min);
            assert!(least(1) < 0.0, "{stations}: {}", least(1));
            // The clearance is of the whole outlines, by another way.
            let clearance = sizes.clearance();
            let proven = clearance.crescent.expect("a disc").distance - clearance.tolerance;
            assert!(least(2) >= proven && least(2) > 0.0, "{stations}: {} {proven}", least(2));
        }
    }
}
