//! What a print-out shows of peaks that are narrower than its interval.

use crate::escapement::axes::spanning;
use crate::figure::{Figure, Words};
use crate::markers::{Mark, marks};
use crate::number::{fixed, significant, trimmed};
use crate::panel::{Panel, Stroke, WIDTH};
use crate::plot::{Axis, Scale};
use crate::series::Series;
use crate::steady::MotionError;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{DRIVER, FOLLOWER, GRID};
use geneva_dynamics::steady::{Engagement, Extreme};
use nalgebra::Vector2;

/// Peaks that are shown, and how far to either side, in print intervals.
const SHOWN: usize = 5;
const ASIDE: f64 = 3.0;
/// Points of the curve in a print interval.
const FINE: usize = 12;
/// Room for the key, and the heights of the panels, in pixels.
const KEY: f64 = 28.0;
const HEIGHTS: [u32; 2] = [384, 334];
/// What of the peak the upper panel shows below it, in spreads of the printed peaks.
const BELOW: f64 = 4.0;

/// One engagement of the run.
struct Peak {
    number: usize,
    actual: Extreme,
    /// Time and speed of the line with the greatest speed.
    printed: (f64, f64),
}

/// Speed over time about successive peaks with the printed lines on it; and of every engagement the true peak and the
/// greatest printed speed.
///
/// The run starts from rest at entry and is printed at each multiple of the interval up to the duration. Only whole
/// engagements count. Series, a row for each engagement: its number, time and speed of the peak, time and speed of the
/// line with the greatest speed.
///
/// # Errors
///
/// [`MotionError`] if the run cannot be computed or has fewer than six whole engagements.
pub fn aliasing(engagement: &Engagement, interval: f64, duration: f64) -> Result<Figure, MotionError> {
    let fine = engagement.run(interval / FINE as f64, duration)?;
    let fine: Vec<(f64, f64)> = fine.iter().map(|line| (line.time, line.speed)).collect();
    let lines = engagement.run(interval, duration)?;
    let mut peaks: Vec<Peak> = Vec::new();
    let (mut start, mut entry) = (0.0, 0.0);
    loop {
        let passage = engagement.passage(entry)?;
        let end = start + passage.duration();
        if end > duration {
            break;
        }
        let number = peaks.len();
        let of = lines.iter().filter(|line| line.engagement == number).map(|line| (line.time, line.speed));
        let printed = of.fold((start, 0.0), |best, line| if line.1 > best.1 { line } else { best });
        let fastest = passage.fastest();
        peaks.push(Peak { number, actual: Extreme { time: start + fastest.time, ..fastest }, printed });
        (start, entry) = (end, passage.end_speed());
    }
    // The start from rest is left out.
    let shown = peaks.get(1..=SHOWN).ok_or(MotionError::Nothing)?;
    let printed = || peaks.iter().skip(1).map(|peak| peak.printed.1);
    let (least, most) = (printed().fold(f64::INFINITY, f64::min), printed().fold(0.0, f64::max));
    let actual = peaks.iter().skip(1).map(|peak| peak.actual.speed).fold(0.0, f64::max);

    let ([upper, lower], height) = Panel::stack(KEY, HEIGHTS);
    let mut canvas = Canvas::new(f64::from(WIDTH), height);
    let windows = Axis { range: 0.0..SHOWN as f64, marks: Vec::new(), decimals: 0, scale: Scale::Even };
    let upright = |below: f64| spanning(actual - below * (actual - least), actual + 0.2 * (actual - least), 4.0);
    let panel = Panel::new(upper, HEIGHTS[0], windows, upright(BELOW));
    panel.draw(&mut canvas, false);
    near(&mut canvas, &panel, shown, &fine, interval);
    let unit = trimmed(1000.0 * ASIDE * interval, 1);
    panel.name(&mut canvas, &Label::words(&format!("speed in rad/s, {unit} ms to either side of a peak")));

    let last = peaks.len() as f64;
    let marks_at = (0..peaks.len()).map(|k| (k + 1) as f64).collect();
    let numbers = Axis { range: 0.5..last + 0.5, marks: marks_at, decimals: 0, scale: Scale::Even };
    let panel = Panel::new(lower, HEIGHTS[1], numbers, upright(1.3));
    panel.draw(&mut canvas, true);
    each(&mut canvas, &panel, &peaks);
    panel.name(&mut canvas, &Label::words("peaks in rad/s"));
    panel.foot(&mut canvas, &Label::words("number of the engagement"));
    key(&mut canvas);

    let columns =
        [("engagement", "1"), ("t true", "s"), ("peak true", "rad/s"), ("t printed", "s"), ("peak printed", "rad/s")];
    let rows = peaks
        .iter()
        .map(|peak| [(peak.number + 1) as f64, peak.actual.time, peak.actual.speed, peak.printed.0, peak.printed.1]);
    let words = Words {
        id: "runs-aliasing".to_owned(),
        title: "Peaks of the speed, true and as printed".to_owned(),
        description: format!(
            "Above, the driver's speed about five successive peaks: the curve is the same each time, but the printed \
             points, {} ms apart, lie elsewhere on it. Below, for each of {} engagements, the true peak, steady at {} \
             rad/s after the first, and the greatest printed speed, which swings between {} and {} rad/s.",
            trimmed(1000.0 * interval, 3),
            peaks.len(),
            significant(actual, 4),
            significant(least, 4),
            significant(most, 4)
        ),
        caption: format!(
            "A peak falls between two printed lines. The largest printed speed of the run is {} rad/s, the peak is {} \
             rad/s; which engagement is read matters, though all are alike.",
            fixed(printed().fold(peaks.first().map_or(0.0, |peak| peak.printed.1), f64::max), 1),
            fixed(actual, 1)
        ),
    };
    Ok(words.figure(canvas, Kind::Panels, Series::new(columns, rows)))
}

/// The windows about the peaks.
fn near(canvas: &mut Canvas, panel: &Panel, shown: &[Peak], fine: &[(f64, f64)], interval: f64) {
    let [least, greatest] = panel.corners();
    for (window, peak) in shown.iter().enumerate() {
        let middle = window as f64 + 0.5;
        let inside = |(time, _): &&(f64, f64)| ((time - peak.actual.time) / interval).abs() <= ASIDE;
        let place =
            |(time, speed): &(f64, f64)| (middle + (time - peak.actual.time) / interval / (2.0 * ASIDE + 0.4), *speed);
        if window > 0 {
            let x = panel.at((window as f64, 1.0)).x;
            let edge = Shape::line(&Vector2::new(x, least.y), &Vector2::new(x, greatest.y));
            canvas.draw(edge.stroke(GRID, 1.2));
        }
        let curve: Vec<_> = fine.iter().filter(inside).map(place).collect();
        panel.curve(canvas, &curve, Stroke { shade: FOLLOWER, width: 2.2, dashes: None, class: "speed" });
        let grid = fine.iter().step_by(FINE).filter(inside);
        let points: Vec<_> =
            grid.map(place).filter(|point| (least.y..=greatest.y).contains(&panel.at(*point).y)).collect();
        panel.marks(canvas, &points, (DRIVER, Mark::Square), 8.0);
        peak_mark(canvas, &panel.at(place(&(peak.actual.time, peak.actual.speed))));
        let foot = Vector2::new(panel.at((middle, 1.0)).x, greatest.y);
        canvas.label(&foot, &Vector2::new(0.0, 1.0), 18.0, &Label::words(&(peak.number + 1).to_string()).bare());
    }
}

/// All engagements.
fn each(canvas: &mut Canvas, panel: &Panel, peaks: &[Peak]) {
    let point = |peak: &Peak, speed: f64| ((peak.number + 1) as f64, speed);
    let printed: Vec<_> = peaks.iter().map(|peak| point(peak, peak.printed.1)).collect();
    panel.curve(canvas, &printed, Stroke { shade: DRIVER, width: 1.2, dashes: Some("3 3"), class: "swing" });
    let [least, greatest] = panel.corners();
    let inside = |at: &Pixels| (least.y..=greatest.y).contains(&at.y);
    let shown = |point: &&(f64, f64)| inside(&panel.at(**point));
    panel.marks(canvas, &printed.iter().filter(shown).copied().collect::<Vec<_>>(), (DRIVER, Mark::Square), 8.0);
    for peak in peaks {
        let at = panel.at(point(peak, peak.actual.speed));
        if inside(&at) {
            peak_mark(canvas, &at);
        }
    }
}

/// A true peak: a ring.
fn peak_mark(canvas: &mut Canvas, at: &Pixels) {
    canvas.draw(Shape::circle(at, 6.0).stroke(FOLLOWER, 2.0).class("peak"));
}

fn key(canvas: &mut Canvas) {
    let right = Vector2::new(1.0, 0.0);
    let at = |x: f64| Vector2::new(x, 18.0);
    peak_mark(canvas, &at(24.0));
    canvas.label(&at(24.0), &right, 14.0, &Label::words("true peak").bare());
    marks(canvas, &[at(190.0)], (DRIVER, Mark::Square), 8.0);
    canvas.label(&at(190.0), &right, 12.0, &Label::words("printed").bare());
    let line = Shape::line(&at(320.0), &at(360.0)).stroke(FOLLOWER, 2.2);
    canvas.draw(line);
    canvas.label(&at(360.0), &right, 10.0, &Label::words("speed").bare());
}
