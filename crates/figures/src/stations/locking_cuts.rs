//! How near the wheel's horns come to the locking disc, with two cuts in it.

use crate::chart::{Axis, Chart, Entry, Panel, Stroke, kind};
use crate::number::fixed;
use crate::svg::Label;
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::pin_from_pivot;
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::ops::RangeInclusive;

/// Steps of half an engagement; the other half is its mirror image, with the horn on the other side.
const STEPS: u32 = 180;

/// A circle that is cut out of the locking disc: how far its centre is from the driver's axis, towards the pin, and its
/// radius, in crank radii.
struct Cut {
    centre: f64,
    radius: f64,
}

/// The least distance, in crank radii, of the tips of the horns from a locking disc of this radius, without any play,
/// while the wheel turns; below zero how deep they are in it.
fn gap(wheel: &Wheel, disc: f64, cut: &Cut) -> f64 {
    let (k, rim, pitch) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio(), wheel.half_pitch_angle());
    let tip = libm::acos((rim * rim + k * k - disc * disc) / (2.0 * rim * k));
    let end = wheel.engagement_half_angle();
    let at = |crank: f64, side: f64| {
        let pin = pin_from_pivot(&k, &Turn::from_radians(crank));
        let (sin, cos) = libm::sincos(libm::atan2(pin.y, pin.x) + side * (pitch - tip));
        let place = Vector2::new(rim * cos - k, rim * sin);
        let centre = Vector2::new(-libm::cos(crank), libm::sin(crank)) * cut.centre;
        (place.norm() - disc).max(cut.radius - (place - centre).norm())
    };
    let least = |from: f64, to: f64, side: f64| {
        let all = (0..=STEPS).map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS));
        let each = all.map(|crank| (crank, at(crank, side)));
        each.fold((from, f64::INFINITY), |least, this| if this.1 < least.1 { this } else { least })
    };
    // Once more between the neighbours of the least.
    let step = end / f64::from(STEPS);
    let finer = |side: f64| {
        let (crank, _) = least(0.0, end, side);
        least((crank - step).max(0.0), (crank + step).min(end), side).1
    };
    finer(1.0).min(finer(-1.0))
}

/// Number of slots, then the gaps in hundredths of the centre distance: with the circle of the wheel's radius about its
/// axis in the middle of a move, and with the circle whose edges stand where the pin enters.
fn row(wheel: &Wheel, disc: f64) -> [f64; 3] {
    let (k, rim) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
    let cuts = [Cut { centre: k, radius: rim }, Cut { centre: k * disc, radius: rim * disc }];
    let [of_wheel, of_edges] = cuts.map(|cut| 100.0 * gap(wheel, disc, &cut) / k);
    [f64::from(wheel.stations()), of_wheel, of_edges]
}

/// How near the tips of the wheel's horns come to the locking disc, for two customary cuts in it and a disc of this radius
/// in crank radii, between 0 and 1, without any play. For numbers of slots that a wheel can have, as far as the disc
/// reaches into the wheel.
///
/// Series, a row for each: N, and the least gaps in hundredths of the centre distance with a cut of the wheel's radius and
/// with one through the edges.
pub fn locking_cuts(slots: RangeInclusive<u32>, disc: f64) -> Figure {
    let wheels = slots.filter_map(|slots| Wheel::new(slots).ok());
    // A small disc does not come to the rim.
    let reaches = |wheel: &Wheel| disc > wheel.centre_distance_ratio() - wheel.wheel_radius_ratio();
    let rows: Vec<_> = wheels.filter(reaches).map(|wheel| row(&wheel, disc)).collect();
    let numbers = || rows.iter().map(|row| row[0]);
    let (first, last) = (numbers().fold(f64::INFINITY, f64::min).min(60.0), numbers().fold(3.0, f64::max));
    let x = Axis::whole(first.min(last) - 0.5..last + 0.5, numbers())
        .titled(Label::words("number of slots ").and_symbol("N"));
    let values = || rows.iter().flat_map(|row| [row[1], row[2]]);
    let (least, most) = (values().fold(-1.0, f64::min), values().fold(1.0, f64::max));
    let y = Axis::spanning(least, most, 5.0).titled(Label::words("gap in % of the centre distance"));
    let mut panel = Panel::new(340.0, &x, &y).horizontal(0.0, Stroke::thin("touching"));
    let names = ["wheel's radius, about its axis", "through the disc's edges"];
    let mut key = Vec::new();
    for (number, name) in names.into_iter().enumerate() {
        let (stroke, marker) = kind(1 - number);
        let points = || rows.iter().map(move |row| (row[0], row[number + 1]));
        panel = panel.curve(points(), stroke.wide(1.6)).marks(points(), marker.class("point"));
        key.push(Entry::both((stroke.wide(1.6), marker), Label::words(name).shade(marker.shade)));
    }
    let bites = rows.iter().filter(|row| row[1] < 0.0).count();
    let clears = rows.iter().filter(|row| row[2] >= 0.0).count();
    let words = Words::new(
        "locking-cuts",
        format!("Gap between horns and locking disc, {} to {} slots", fixed(first, 0), fixed(last, 0)),
        format!(
            "Two rows of points against the number of slots. With a cut of the wheel's radius the horns are in the disc for \
             {bites} of {} numbers of slots. With a cut through the edges they stay clear of it for {clears}.",
            rows.len()
        ),
        format!(
            "The least gap between the tips of the horns and the locking disc while the wheel turns, for a disc of {} crank \
             radii without any play. Below the thin line the horns are in the disc.",
            fixed(disc, 1)
        ),
    );
    let columns = [("N", "1"), ("gap wheel's radius", "% of c"), ("gap through edges", "% of c")];
    Chart::new([panel]).key(key).figure(words, Series::new(columns, rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{drawn, sound};

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
                let drawn = row(&wheel, disc)[column as usize] * k / 100.0;
                assert!((least - drawn).abs() < 5e-4, "{slots} slots, column {column}: {least} and {drawn}");
            }
        }
    }

    #[test]
    fn any_range_and_any_disc_are_drawn() {
        sound(&locking_cuts(3..=12, 0.7));
        for (range, disc) in [(0..=2, 0.7), (5..=5, 0.7), (3..=60, 0.9), (3..=18, 0.2), (3..=6, 0.0)] {
            drawn(&locking_cuts(range, disc));
        }
    }
}
