//! How far the numbers of a table are from those that several hypotheses give.

use crate::chart::{Axis, Chart, Entry, Panel, Scale, Stroke, of_mechanism};
use crate::number::{significant, with_minus_sign};
use crate::svg::Label;
use crate::{Figure, Series, Words};
use geneva_kinematics::Mechanism;

/// Computed over given, less one, of the three results of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The run's mechanism.
    pub mechanism: Mechanism,
    /// Of the greatest speed.
    pub peak: f64,
    /// Of the least speed.
    pub minimum: f64,
    /// Of the period.
    pub period: f64,
}

/// What one hypothesis makes of all runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviations {
    /// The hypothesis, in a few words.
    pub name: String,
    /// The runs.
    pub runs: Vec<Deviation>,
}

/// A result: its name, and how to find it.
type Result = (&'static str, fn(&Deviation) -> f64);

const RESULTS: [Result; 3] = [("peak", |at| at.peak), ("minimum", |at| at.minimum), ("period", |at| at.period)];

/// The marks of the scale to one side, in per cent; it ends at the first one beyond all deviations.
const MARKS: [f64; 6] = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5];
/// From strip to strip, and how wide a strip is, in parts of a hypothesis's width.
const STRIPS: f64 = 0.29;
const STRIP: f64 = 0.2;
const SIZE: f64 = 5.0;

/// The deviations of all runs under each hypothesis: a panel for each result, a strip of marks for each mechanism.
///
/// The scale is logarithmic to either side and even about zero, so that tens of per cent and tenths can both be seen.
/// Series, a row for each run and hypothesis: number of the hypothesis, slots, the three deviations in per cent.
pub fn deviations(hypotheses: &[Deviations]) -> Figure {
    let all = || hypotheses.iter().flat_map(|one| &one.runs);
    let greatest = all().flat_map(|run| RESULTS.map(|(_, of)| 100.0 * of(run).abs())).fold(0.0, f64::max);
    let last = MARKS.iter().position(|mark| *mark >= greatest).unwrap_or(MARKS.len() - 1).max(1);
    let shown = MARKS.iter().take(last + 1);
    let marks: Vec<f64> = shown.clone().rev().map(|mark| -mark).chain([0.0]).chain(shown.copied()).collect();
    let end = MARKS.get(last).copied().unwrap_or(1.0);
    let count = hypotheses.len().max(1) as f64;
    let x = Axis::whole(0.5..count + 0.5, (0..hypotheses.len()).map(|k| (k + 1) as f64)).without_grid();
    let panels = RESULTS.map(|(name, of)| {
        let title = Label::words(&format!("{name}: computed over printed, less one, in %"));
        let y = Axis::new(Scale::SymmetricLog, -end..end, marks.clone(), 0).titled(title);
        let edges = (1..hypotheses.len()).map(|number| number as f64 + 0.5);
        let panel = edges.fold(Panel::new(210.0, &x, &y), |panel, edge| panel.vertical(edge, Stroke::edge()));
        let panel = panel.horizontal(0.0, Stroke::thin("zero"));
        Mechanism::ALL.into_iter().enumerate().fold(panel, |panel, (number, mechanism)| {
            panel.marks(strip(hypotheses, number, mechanism, of), of_mechanism(mechanism.slots()).1.sized(SIZE))
        })
    });
    let key = Mechanism::ALL.map(|mechanism| {
        let marker = of_mechanism(mechanism.slots()).1;
        Entry::marks([marker], Label::words(&format!("{} pins", mechanism.pins())).shade(marker.shade))
    });
    let notes = hypotheses.iter().enumerate();
    let notes = notes.map(|(k, one)| Label::words(&format!("{}   {}", k + 1, one.name)));
    let columns = [("hypothesis", "1"), ("n", "1"), ("peak", "%"), ("minimum", "%"), ("period", "%")];
    let rows = hypotheses.iter().enumerate().flat_map(|(number, hypothesis)| {
        hypothesis.runs.iter().map(move |run| {
            let [peak, minimum, period] = RESULTS.map(|(_, of)| 100.0 * of(run));
            [(number + 1) as f64, f64::from(run.mechanism.slots()), peak, minimum, period]
        })
    });
    Chart::new(panels).key(key).notes(notes).figure(words(hypotheses), Series::new(columns, rows))
}

/// The marks of a mechanism under all hypotheses: the number of the strip is that of the mechanism.
fn strip(hypotheses: &[Deviations], number: usize, mechanism: Mechanism, of: fn(&Deviation) -> f64) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for (column, hypothesis) in hypotheses.iter().enumerate() {
        let own: Vec<_> = hypothesis.runs.iter().filter(|run| run.mechanism == mechanism).collect();
        let middle = column as f64 + 1.0 + STRIPS * (number as f64 - 1.0);
        let place = |(k, run): (usize, &&Deviation)| {
            let aside = (k as f64 + 0.5) / own.len() as f64 - 0.5;
            (middle + STRIP * aside, 100.0 * of(run))
        };
        points.extend(own.iter().enumerate().map(place).filter(|(_, y)| y.is_finite()));
    }
    points
}

fn words(hypotheses: &[Deviations]) -> Words {
    let worst = |hypothesis: &Deviations, of: fn(&Deviation) -> f64| {
        hypothesis.runs.iter().map(of).fold(0.0, |worst: f64, one| if one.abs() > worst.abs() { one } else { worst })
    };
    let said = hypotheses.iter().enumerate().map(|(number, hypothesis)| {
        let [peak, minimum, period] =
            RESULTS.map(|(_, of)| with_minus_sign(&significant(100.0 * worst(hypothesis, of), 2)));
        format!("{}, {}: {peak}, {minimum}, {period}", number + 1, hypothesis.name)
    });
    Words::new(
        "runs-hypotheses",
        "How far the printed results are from those that each hypothesis gives",
        format!(
            "Three panels, for peak, minimum and period. In each a column for every hypothesis, with a strip of marks \
             for each mechanism: computed over printed, less one, in per cent. The largest deviations of peak, minimum \
             and period, in per cent: {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        "Every mark is a run: its computed result over the printed one, less one. The scale is logarithmic to either \
         side and even near zero. Within a strip, friction and torque rise to the right.",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{Drawing, drawn, sound};

    fn hypothesis(size: f64) -> Deviations {
        let run = |mechanism| Deviation { mechanism, peak: size, minimum: -size, period: 0.0 };
        Deviations { name: "one, two, three".to_owned(), runs: Mechanism::ALL.map(run).to_vec() }
    }

    #[test]
    fn marks_stand_as_far_from_zero_as_they_deviate() {
        let figure = deviations(&[0.4, 0.001, 0.0].map(hypothesis));
        sound(&figure);
        let drawing = Drawing::of(&figure);
        let zeros = [0, 1, 2].map(|panel| drawing.path("zero", panel)[0].y);
        // Three mechanisms in each panel, each with the hypotheses in order.
        let marks = drawing.all("marks");
        assert_eq!(marks.len(), 9);
        for panel in 0..3 {
            let data = marks[3 * panel].attribute("d").expect("a path");
            let heights = data.split('M').skip(1).map(|part| {
                let height = part.split([' ', 'h']).nth(1).expect("two coordinates");
                zeros[panel] - height.parse::<f64>().expect("a number")
            });
            let heights: Vec<f64> = heights.collect();
            assert_eq!(heights.len(), 3);
            let expected = [1.0, -1.0, 0.0][panel];
            assert!(heights[2].abs() < 0.06 && heights[0] * expected >= 0.0, "{heights:?}");
            if panel < 2 {
                // The scale: arsinh of twice the per cents.
                let quotient = libm::asinh(80.0) / libm::asinh(0.2);
                assert!((heights[0] / heights[1] / quotient - 1.0).abs() < 0.02, "{heights:?} for {quotient}");
            }
        }
    }

    #[test]
    fn nothing_and_far_too_much_are_drawn() {
        for some in [vec![], vec![hypothesis(0.0)], vec![hypothesis(1e9)]] {
            drawn(&deviations(&some));
        }
    }
}
