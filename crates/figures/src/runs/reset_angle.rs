//! How many printed numbers come out, over the angle after which the program resets the driver.

use crate::chart::{AxisScale, Chart, ChartAxis, LegendEntry, LineStyle, Panel, of_mechanism};
use crate::svg::Label;
use crate::{Figure, Series, Words};
use geneva_kinematics::Mechanism;

/// What a mechanism's table says of the reset angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Scan {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// How many numbers its table has.
    pub cells: usize,
    /// Reset angles in degrees, and how many of the numbers come out with each.
    pub counts: Vec<(f64, usize)>,
}

/// The counts over the reset angle, a curve for each mechanism, which all have the same angles.
///
/// Series: the reset angle in degrees, and the count of each mechanism in the order given.
///
/// # Panics
///
/// Without a mechanism or without an angle.
pub fn reset_angle(scans: &[Scan]) -> Figure {
    let angles: Vec<f64> = scans[0].counts.iter().map(|(at, _)| *at).collect();
    let range = angles[0]..angles[angles.len() - 1];
    let most = scans.iter().map(|scan| scan.cells as f64).fold(0.0, f64::max);
    let x = ChartAxis::new(AxisScale::Linear, range.clone(), tens(range.start, range.end), 0);
    let x = x.titled(Label::words("reset angle of the program, in degrees"));
    let y = ChartAxis::new(AxisScale::Linear, 0.0..1.05 * most, tens(0.0, most), 0);
    let y = y.titled(Label::words("printed numbers within one unit"));
    let panel = scans.iter().fold(Panel::new(300.0, &x, &y), |panel, scan| {
        panel.curve(scan.counts.iter().map(|(at, count)| (*at, *count as f64)), stroke(scan.mechanism))
    });
    let key = scans.iter().map(|scan| {
        let name = Label::words(&format!("{} pins, of {}", scan.mechanism.pins(), scan.cells));
        LegendEntry::curve(stroke(scan.mechanism), name)
    });
    let best: Vec<String> = scans.iter().map(best_angles).collect();
    let words = Words::new(
        "runs-reset-angle",
        "How many printed numbers are reproduced, over the reset angle",
        format!(
            "A curve for each mechanism over the reset angle from {} to {} degrees. Each has a sharp peak: {}.",
            range.start,
            range.end,
            best.join("; ")
        ),
        format!(
            "How many peaks, minima and periods of Appendix E are reproduced to within one unit if the program \
             resets at another angle, in steps of half a degree? The greatest counts: {}. Computed with the true peaks and, for 6 pins, the \
             inertias of the thesis's Fig. 11.",
            best.join("; ")
        ),
    );
    let columns = std::iter::once(("reset".to_owned(), "deg"))
        .chain(scans.iter().map(|scan| (format!("{} pins", scan.mechanism.pins()), "1")));
    let row = |(at, angle): (usize, &f64)| {
        let counts = scans.iter().map(|scan| scan.counts[at].1 as f64);
        std::iter::once(*angle).chain(counts).collect()
    };
    let rows = angles.iter().enumerate().map(row).collect();
    Chart::new([panel]).key(key).figure(words, Series::of_columns(columns, rows))
}

fn stroke(mechanism: Mechanism) -> LineStyle {
    of_mechanism(mechanism.slots()).0
}

/// Where most of a mechanism's numbers come out, at one angle or at several, and how many.
fn best_angles(scan: &Scan) -> String {
    let most = scan.counts.iter().map(|(_, count)| *count).max().unwrap_or_default();
    let angles = scan.counts.iter().filter(|(_, count)| *count == most).map(|(at, _)| format!("{at}°"));
    let angles = angles.collect::<Vec<_>>().join(" and ");
    format!("{most} of {} with {} pins, at {angles}", scan.cells, scan.mechanism.pins())
}

/// The tens from one number to another.
fn tens(from: f64, to: f64) -> Vec<f64> {
    (0..).map(|k| 10.0 * ((from / 10.0).ceil() + f64::from(k))).take_while(|ten| *ten <= to).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::assert_sound;

    #[test]
    fn the_angle_with_most_numbers_is_told() {
        let scan = |mechanism, best: u32| Scan {
            mechanism,
            cells: 48,
            counts: (60..=120).map(|at| (f64::from(at), 40 - best.abs_diff(at).min(40) as usize)).collect(),
        };
        let figure = reset_angle(&[scan(Mechanism::SIX_PIN, 70), scan(Mechanism::THREE_PIN, 90)]);
        assert_sound(&figure);
        assert!(figure.caption.contains("40 of 48 with 6 pins, at 70°"), "{}", figure.caption);
        // Two angles that do equally well are both told.
        let tie = Scan { mechanism: Mechanism::SIX_PIN, cells: 48, counts: vec![(89.5, 47), (90.0, 47), (90.5, 44)] };
        assert_eq!(best_angles(&tie), "47 of 48 with 6 pins, at 89.5° and 90°");
        assert_eq!(figure.series.rows[30], [90.0, 20.0, 40.0]);
    }
}
