//! How near the wheel's horns come to the locking disc, with two cuts in it.

use crate::chart::{Chart, ChartAxis, LineStyle, Panel, kind};
use crate::number::{extent, format_fixed};
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, Crescent, LockingDisc, Play, Scale, Sizes, Wheel};
use std::f64::consts::FRAC_PI_4;
use std::ops::RangeInclusive;

/// Steps of an engagement.
const STEPS: u32 = 360;
/// Diameter of a pin that is as good as none, in crank radii.
const THIN: f64 = 1e-9;

/// A wheel for a pin without thickness and a locking disc of this radius, in crank radii, without any play. None if the disc
/// does not reach into the wheel, or reaches so far that nothing is left of it.
fn sized(wheel: Wheel, disc: f64) -> Option<Sizes> {
    let choices = Choices {
        pin_diameter: Some(THIN),
        play: Some(Play::from_slot(0.0)),
        horn_thickness: Some(1.0 - disc - THIN / 2.0),
        ..Choices::default()
    };
    Sizes::new(wheel, Scale::CrankRadius(1.0), &choices).ok()
}

/// The least distance, in crank radii, of the tips of the horns from a locking disc while the wheel turns; below zero how
/// deep they are in it. The horn before the slot goes as the one behind it, to and fro.
fn gap(sizes: &Sizes, disc: &LockingDisc) -> Result<f64, FigureError> {
    let end = sizes.wheel.engagement_half_angle();
    let least = |from: f64, to: f64| {
        let at = |step: u32| (from + (to - from) * f64::from(step) / f64::from(STEPS)).clamp(-end, end);
        (0..=STEPS).map(at).try_fold((from, f64::INFINITY), |least, crank| {
            let gap = sizes.horn_gap(crank, disc)?;
            Ok::<_, FigureError>(if gap < least.1 { (crank, gap) } else { least })
        })
    };
    // Once more between the neighbours of the least.
    let step = 2.0 * end / f64::from(STEPS);
    let (crank, _) = least(-end, end)?;
    Ok(least(crank - step, crank + step)?.1)
}

/// Number of slots, then the gaps in hundredths of the centre distance: with the circle of the wheel's radius about its
/// axis in the middle of a move, and with the circle whose edges stand where the pin enters.
fn row(sizes: &Sizes, disc: LockingDisc) -> Result<[f64; 3], FigureError> {
    let (c, rim, z) = (sizes.centre_distance, sizes.wheel_radius, disc.radius);
    let [of_wheel, of_edges] = [[c, rim], [c * z, rim * z]].map(|[centre, radius]| {
        let crescent = Crescent { centre, radius, ..disc.crescent };
        Ok::<_, FigureError>(100.0 * gap(sizes, &LockingDisc { crescent, ..disc })? / c)
    });
    Ok([f64::from(sizes.wheel.stations()), of_wheel?, of_edges?])
}

/// How near the tips of the wheel's horns come to the locking disc, for two cuts in it that are in use and a disc of this radius
/// in crank radii, between 0 and 1, without any play. For numbers of slots that a wheel can have, as far as the disc
/// reaches into the wheel.
///
/// Series, a row for each: N, and the least gaps in hundredths of the centre distance with a cut of the wheel's radius and
/// with one through the edges.
///
/// # Errors
///
/// [`FigureError::Wheel`] if a tip's place is asked for beyond the engagement, which does not happen.
pub fn locking_cuts(slots: RangeInclusive<u32>, disc: f64) -> Result<Figure, FigureError> {
    let sized = slots.filter_map(|slots| sized(Wheel::new(slots).ok()?, disc));
    let with_disc = sized.filter_map(|sizes| Some((sizes, sizes.locking_disc?)));
    let rows = with_disc.map(|(sizes, disc)| row(&sizes, disc)).collect::<Result<Vec<_>, _>>()?;
    let numbers = || rows.iter().map(|row| row[0]);
    let (first, last) = (numbers().fold(f64::INFINITY, f64::min).min(60.0), numbers().fold(3.0, f64::max));
    let x = ChartAxis::whole(first.min(last) - 0.5..last + 0.5, numbers())
        .titled(Label::words("number of slots ").and_symbol("N"));
    let values = || rows.iter().flat_map(|row| [row[1], row[2]]);
    let [least, most] = extent(values().chain([-1.0, 1.0]));
    let y = ChartAxis::spanning(least, most, 5.0).titled(Label::words("gap in % of the centre distance"));
    let mut panel = Panel::new(340.0, &x, &y).horizontal(0.0, LineStyle::thin("touching"));
    let names = ["arc of the wheel's radius", "arc through the disc's edges"];
    for (number, name) in names.into_iter().enumerate() {
        let (stroke, marker) = kind(1 - number);
        let points = || rows.iter().map(move |row| (row[0], row[number + 1]));
        panel = panel.curve(points(), stroke.wide(1.6)).marks(points(), marker.class("point"));
        panel = panel.name_near(points(), FRAC_PI_4, Label::words(name).in_colour(marker.colour));
    }
    let bites = rows.iter().filter(|row| row[1] < 0.0).count();
    let clears = rows.iter().filter(|row| row[2] >= 0.0).count();
    let words = Words::new(
        "locking-cuts",
        format!("Gap between horns and locking disc, {} to {} slots", format_fixed(first, 0), format_fixed(last, 0)),
        format!(
            "Two rows of points against the number of slots. With a cut of the wheel's radius the horns are in the disc for \
             {bites} of {} numbers of slots. With a cut through the edges they stay clear of it for {clears}.",
            rows.len()
        ),
        format!(
            "The least gap between the tips of the horns and the locking disc while the wheel turns, for a disc with a radius \
             of {} crank radii and no play. Below the thin line the horns overlap the disc.",
            format_fixed(disc, 1)
        ),
    );
    let columns = [("N", "1"), ("gap wheel's radius", "% of c"), ("gap through edges", "% of c")];
    Ok(Chart::new([panel]).figure(words, Series::new(columns, rows)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{assert_drawn, assert_sound};
    use nalgebra::Vector2;

    #[test]
    fn the_gap_is_that_of_the_outlines_at_each_instant() {
        // In the plane of the wheel, its slot along the first axis, the driver's axis going round; by the law of cosines.
        for slots in 3..=18 {
            let wheel = Wheel::new(slots).expect("possible");
            let (k, rim, disc) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio(), 0.7);
            if disc <= k - rim {
                continue;
            }
            let along = (rim * rim + k * k - disc * disc) / (2.0 * k);
            let aside = (rim * rim - along * along).sqrt();
            let (sin, cos) = libm::sincos(wheel.half_pitch_angle());
            let tip = Vector2::new(cos * along + sin * aside, sin * along - cos * aside);
            for [centre, radius, column] in [[k, rim, 1.0], [k * disc, rim * disc, 2.0]] {
                let at = |step: u32, side: f64| {
                    // About as many steps to each crank angle.
                    let pin = k - 1.0 + (rim - k + 1.0) * libm::pow(f64::from(step) / 3000.0, 2.0);
                    let x = (k * k + pin * pin - 1.0) / (2.0 * pin);
                    let axis = Vector2::new(x, side * (k * k - x * x).max(0.0).sqrt());
                    let centre = axis + (Vector2::new(pin, 0.0) - axis) * centre;
                    ((tip - axis).norm() - disc).max(radius - (tip - centre).norm())
                };
                let least = (0..=3000).flat_map(|step| [at(step, 1.0), at(step, -1.0)]).fold(f64::INFINITY, f64::min);
                let sizes = sized(wheel, disc).expect("it reaches");
                let drawn =
                    row(&sizes, sizes.locking_disc.expect("a dwell")).expect("told")[column as usize] * k / 100.0;
                assert!((least - drawn).abs() < 5e-4, "{slots} slots, column {column}: {least} and {drawn}");
            }
        }
    }

    #[test]
    fn any_range_and_any_disc_are_drawn() {
        assert_sound(&locking_cuts(3..=12, 0.7).expect("drawn"));
        for (range, disc) in [(0..=2, 0.7), (5..=5, 0.7), (3..=60, 0.9), (3..=18, 0.2), (3..=6, 0.0)] {
            assert_drawn(&locking_cuts(range, disc).expect("drawn"));
        }
    }
}
