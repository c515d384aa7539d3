//! What a print-out shows of peaks that are narrower than its interval.

use crate::chart::{Chart, ChartAxis, LegendEntry, LineStyle, MarkShape, Marker, Panel};
use crate::number::{extent, format_fixed, format_trimmed, significant};
use crate::svg::Label;
use crate::theme::{DRIVER, FOLLOWER};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::steady::{Engagement, Extreme};

/// Peaks that are shown, and how far to either side, in print intervals.
const SHOWN: usize = 5;
const ASIDE: f64 = 3.0;
/// Points of the curve in a print interval.
const FINE: usize = 12;
/// What of the peak the upper panel shows below it, in spreads of the printed peaks.
const BELOW: f64 = 4.0;
/// A true peak, a printed line, and the speed between.
const TRUE: Marker = Marker::new(FOLLOWER, MarkShape::Circle).sized(12.0).class("peak");
const PRINTED: Marker = Marker::new(DRIVER, MarkShape::Square).sized(8.0);
const SPEED: LineStyle = LineStyle::new(FOLLOWER).wide(2.2).class("speed");

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
/// [`FigureError`] if the run cannot be computed or has fewer than six whole engagements.
pub fn aliasing(engagement: &Engagement, interval: f64, duration: f64) -> Result<Figure, FigureError> {
    let fine = engagement.run(interval / FINE as f64, duration)?;
    let fine: Vec<(f64, f64)> = fine.iter().map(|line| (line.time, line.speed)).collect();
    let peaks = peaks(engagement, interval, duration)?;
    // The start from rest is left out.
    let shown = peaks.get(1..=SHOWN).ok_or(FigureError::Nothing)?;
    let printed = || peaks.iter().skip(1).map(|peak| peak.printed.1);
    let [least, most] = extent(printed());
    let actual = peaks.iter().skip(1).map(|peak| peak.actual.speed).fold(0.0, f64::max);
    let y = |below: f64| ChartAxis::spanning(actual - below * (actual - least), actual + 0.2 * (actual - least), 4.0);
    let label = Label::words;
    let chart = Chart::new([near(shown, &fine, interval, y(BELOW)), each(&peaks, y(1.3))]).key([
        LegendEntry::marks([TRUE], label("true peak")),
        LegendEntry::marks([PRINTED], label("printed")),
        LegendEntry::curve(SPEED, label("speed")),
    ]);

    let columns =
        [("engagement", "1"), ("t true", "s"), ("peak true", "rad/s"), ("t printed", "s"), ("peak printed", "rad/s")];
    let rows = peaks
        .iter()
        .map(|peak| [(peak.number + 1) as f64, peak.actual.time, peak.actual.speed, peak.printed.0, peak.printed.1]);
    // The first engagement from which on all true peaks have the digits of the last.
    let other = peaks.iter().rposition(|peak| format_fixed(peak.actual.speed, 1) != format_fixed(actual, 1));
    let settled = other.map_or(1, |at| at + 2);
    let words = Words::new(
        "runs-aliasing",
        "Peaks of the speed, true and as printed",
        format!(
            "Above, the driver's speed about five successive peaks: the curve is the same each time, but the printed \
             points, {} ms apart, lie elsewhere on it. Below, for each of {} engagements, the true peak, {} rad/s from \
             engagement {settled} on, and the greatest printed speed, which swings between {} and {} rad/s.",
            format_trimmed(1000.0 * interval, 3),
            peaks.len(),
            significant(actual, 4),
            significant(least, 4),
            significant(most, 4)
        ),
        format!(
            "The driver's speed around five peaks of one run, and the lines of its print-out. From engagement {settled} on, \
             all true peaks are {} rad/s, but the printed peaks swing between {} and {} rad/s, because \
             the print-out seldom has a line at the peak. {} Torque K = {} in lb.",
            format_fixed(actual, 1),
            format_fixed(least, 1),
            format_fixed(most, 1),
            crate::number::describe_parameters(engagement.parameters()),
            significant(engagement.parameters().torque(), 2)
        ),
    );
    Ok(chart.figure(words, Series::new(columns, rows)))
}

/// The engagements of a run from rest that end within the duration.
fn peaks(engagement: &Engagement, interval: f64, duration: f64) -> Result<Vec<Peak>, FigureError> {
    let lines = engagement.run(interval, duration)?;
    let mut peaks = Vec::new();
    let (mut start, mut entry) = (0.0, 0.0);
    loop {
        let passage = engagement.passage(entry)?;
        let end = start + passage.duration();
        if end > duration {
            return Ok(peaks);
        }
        let number = peaks.len();
        let of = lines.iter().filter(|line| line.engagement == number).map(|line| (line.time, line.speed));
        let printed = of.fold((start, 0.0), |best, line| if line.1 > best.1 { line } else { best });
        let fastest = passage.fastest();
        peaks.push(Peak { number, actual: Extreme { time: start + fastest.time, ..fastest }, printed });
        (start, entry) = (end, passage.end_speed());
    }
}

/// The windows about the peaks, each numbered.
fn near(shown: &[Peak], fine: &[(f64, f64)], interval: f64, y: ChartAxis) -> Panel {
    let number = |peak: &Peak| (peak.number + 1) as f64;
    let ends = [shown.first(), shown.last()].map(|peak| peak.map_or(0.0, number));
    let x = ChartAxis::whole(ends[0] - 0.5..ends[1] + 0.5, shown.iter().map(number)).without_grid();
    let unit = format_trimmed(1000.0 * ASIDE * interval, 1);
    let title = Label::words(&format!("speed in rad/s, {unit} ms to either side of a peak"));
    let mut panel = Panel::new(270.0, &x, &y.titled(title));
    for peak in shown {
        let inside = |(time, _): &&(f64, f64)| ((time - peak.actual.time) / interval).abs() <= ASIDE;
        let place = |(time, speed): &(f64, f64)| {
            (number(peak) + (time - peak.actual.time) / interval / (2.0 * ASIDE + 0.4), *speed)
        };
        panel = panel
            .vertical(number(peak) + 0.5, LineStyle::edge())
            .curve(fine.iter().filter(inside).map(place), SPEED)
            .marks(fine.iter().step_by(FINE).filter(inside).map(place), PRINTED)
            .marks([(number(peak), peak.actual.speed)], TRUE);
    }
    panel
}

/// All engagements.
fn each(peaks: &[Peak], y: ChartAxis) -> Panel {
    let numbers = || (1..=peaks.len()).map(|number| number as f64);
    let x = ChartAxis::whole(0.5..peaks.len() as f64 + 0.5, numbers()).titled(Label::words("number of the engagement"));
    let printed = || numbers().zip(peaks.iter().map(|peak| peak.printed.1));
    Panel::new(220.0, &x, &y.titled(Label::words("peaks in rad/s")))
        .curve(printed(), LineStyle::new(DRIVER).wide(1.2).dashed("3 3").class("swing"))
        .marks(printed(), PRINTED)
        .marks(numbers().zip(peaks.iter().map(|peak| peak.actual.speed)), TRUE)
}
