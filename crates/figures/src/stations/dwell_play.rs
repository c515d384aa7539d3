//! How far the wheel turns loosely, over a dwell.

use crate::chart::{Chart, ChartAxis, LineStyle, Panel};
use crate::number::format_fixed;
use crate::svg::Label;
use crate::theme::{DRIVER, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Sizes;
use std::f64::consts::PI;

/// Steps of the crank over the dwell.
const PLACES: u32 = 480;
const HEIGHT: f64 = 300.0;
/// The x axis has at least so many steps.
const STEPS: f64 = 4.0;

/// The wheel's backlash forwards and backwards over a dwell, in degrees, from the pin's leaving to the next pin's entry.
///
/// Series: crank angle since the pin left, both backlashes. It has no rows without a locking disc.
pub fn dwell_play(sizes: &Sizes) -> Figure {
    let whole = sizes.dwell_angle().unwrap_or_default();
    // The places where it is greatest belong to the curves, or they would look lower than they are.
    let greatest = sizes.dwell_play().map(|play| play.until_entry);
    let even = (0..=PLACES).map(|k| (whole * f64::from(k) / f64::from(PLACES)).min(whole));
    let mut since: Vec<f64> = even.chain(greatest.into_iter().flat_map(|until| [until, whole - until])).collect();
    since.sort_by(f64::total_cmp);
    let row = |since: f64| {
        let [forwards, backwards] = sizes.dwell_play_at((whole - since).clamp(0.0, whole))?;
        Some([since.to_degrees(), forwards.to_degrees(), backwards.to_degrees()])
    };
    let rows: Vec<_> = since.into_iter().filter_map(row).collect();
    let most = rows.iter().flat_map(|row| [row[1], row[2]]).fold(0.0, f64::max);
    let x = ChartAxis::of_angles(0.0, whole.to_degrees().max(1.0), STEPS)
        .titled(Label::words("crank angle since the pin left, °"));
    let y = ChartAxis::from_zero(0.0, most, 4.0).titled(Label::words("backlash, °"));
    let points = |column: usize| rows.iter().map(move |row| (row[0], row[column]));
    let (forwards, backwards) = (LineStyle::new(DRIVER).wide(2.0), LineStyle::new(RELATIVE).wide(2.0).dashed("8 6"));
    let first_third = || points(2).take(rows.len() / 3);
    let last_third = || points(1).skip(rows.len() * 2 / 3);
    let panel = Panel::new(HEIGHT, &x, &y)
        .curve(points(2), backwards)
        .curve(points(1), forwards)
        .name_near(first_third(), 0.0, Label::words("backwards").in_colour(backwards.colour))
        .name_near(last_third(), PI, Label::words("forwards, as it indexes").in_colour(forwards.colour));
    let words = Words::new(
        "wheel-dwell-play",
        format!("Backlash in the dwell, {} stations", sizes.wheel.stations()),
        format!(
            "Two curves over the dwell, each flat in the middle. The backlash backwards has a peak of {}° shortly after the \
             pin has left, and the backlash forwards has as high a peak shortly before the next pin enters.",
            format_fixed(most, 2)
        ),
        "How far the wheel can turn to each side in the dwell. In the middle of the dwell, the ends of the locking arc \
         stop the wheel in both directions. Near the ends of the dwell, one direction is blocked only by the edge \
         of the disc's opening, close to the line of centres, or, even nearer to the ends, by a pin. Rigid parts with \
         the play of this chapter's design.",
    );
    let columns = [("crank", "deg"), ("forwards", "deg"), ("backwards", "deg")];
    Chart::new([panel]).figure(words, Series::new(columns, rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::assert_drawn;
    use geneva_kinematics::wheel::{Choices, Scale, Wheel};

    #[test]
    fn one_direction_is_the_mirror_image_of_the_other_and_both_reach_the_greatest() {
        for (stations, pins) in [(3, 1), (6, 1), (6, 2), (12, 2), (4, 4)] {
            let wheel = Wheel::with_pins(stations, pins).expect("possible");
            let sizes = Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices::default()).expect("fits");
            let figure = dwell_play(&sizes);
            let Some(play) = sizes.dwell_play() else { continue };
            assert_drawn(&figure);
            let rows = &figure.series.rows;
            for (row, mirrored) in rows.iter().zip(rows.iter().rev()) {
                assert!((row[1] - mirrored[2]).abs() < 1e-6, "{stations}: {row:?} {mirrored:?}");
            }
            let most = rows.iter().map(|row| row[1]).fold(0.0, f64::max);
            assert!((most / play.greatest.to_degrees() - 1.0).abs() < 1e-6, "{stations}: {most} {play:?}");
        }
    }
}
