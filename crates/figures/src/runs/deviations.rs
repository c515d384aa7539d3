//! How far the numbers of a table are from those that several hypotheses give.

use crate::figure::{Figure, Words};
use crate::markers::{marks, of_mechanism};
use crate::number::{significant, with_minus_sign};
use crate::panel::{Panel, WIDTH};
use crate::plot::{Axis, Scale};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use crate::theme::{GRID, INK};
use geneva_kinematics::Mechanism;
use nalgebra::Vector2;

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
/// Height of a panel with its margins, of the line of the key, and of the lines of the names, in pixels.
const HEIGHTS: [u32; 3] = [324, 324, 324];
const KEY: f64 = 26.0;
const LINE: f64 = 27.0;
/// From strip to strip, and how wide a strip is, in parts of a hypothesis's width.
const STRIPS: f64 = 0.29;
const STRIP: f64 = 0.2;
const SIZE: f64 = 5.0;

/// The deviations of all runs under each hypothesis: a panel for each result, a strip of marks for each mechanism.
///
/// The scale is logarithmic to either side and even about zero, so that tens of per cent and tenths can both be seen.
/// Series, a row for each run and hypothesis: number of the hypothesis, slots, the three deviations in per cent.
pub fn deviations(hypotheses: &[Deviations]) -> Figure {
    let (corners, panels_end) = Panel::stack(KEY, HEIGHTS);
    let count = hypotheses.len().max(1) as f64;
    let all = || hypotheses.iter().flat_map(|one| &one.runs);
    let greatest = all().flat_map(|run| RESULTS.map(|(_, of)| 100.0 * of(run).abs())).fold(0.0, f64::max);
    let last = MARKS.iter().position(|mark| *mark >= greatest).unwrap_or(MARKS.len() - 1).max(1);
    let shown = MARKS.iter().take(last + 1);
    let upright: Vec<f64> = shown.clone().rev().map(|mark| -mark).chain([0.0]).chain(shown.copied()).collect();
    let end = upright.last().copied().unwrap_or(1.0);
    let level = Axis { range: 0.5..count + 0.5, marks: Vec::new(), decimals: 0, scale: Scale::Even };
    let left = Axis { range: -end..end, marks: upright, decimals: 0, scale: Scale::Signed };
    let mut canvas = Canvas::new(f64::from(WIDTH), panels_end - 30.0 + LINE * count);
    for (corner, (name, of)) in corners.into_iter().zip(RESULTS) {
        let panel = Panel::new(corner, HEIGHTS[0], level.clone(), left.clone());
        panel.draw(&mut canvas, false);
        let across = |x: f64, y: [f64; 2]| y.map(|y| panel.at((x, y)));
        for number in 1..hypotheses.len() {
            let [from, to] = across(number as f64 + 0.5, [-end, end]);
            canvas.draw(Shape::line(&from, &to).stroke(GRID, 1.2));
        }
        let zero = [0.5, count + 0.5].map(|x| panel.at((x, 0.0)));
        canvas.draw(Shape::line(&zero[0], &zero[1]).stroke(INK, 1.2).class("zero"));
        for (strip, mechanism) in Mechanism::ALL.into_iter().enumerate() {
            let mut points = Vec::new();
            for (number, hypothesis) in hypotheses.iter().enumerate() {
                let own: Vec<_> = hypothesis.runs.iter().filter(|run| run.mechanism == mechanism).collect();
                let middle = number as f64 + 1.0 + STRIPS * (strip as f64 - 1.0);
                let place = |(k, run): (usize, &&Deviation)| {
                    let aside = (k as f64 + 0.5) / own.len() as f64 - 0.5;
                    (middle + STRIP * aside, 100.0 * of(run))
                };
                let finite = |(_, y): &(f64, f64)| y.is_finite();
                points.extend(own.iter().enumerate().map(place).filter(finite));
            }
            panel.marks(&mut canvas, &points, of_mechanism(mechanism.slots()), SIZE);
        }
        for number in 0..hypotheses.len() {
            let foot = panel.at((number as f64 + 1.0, -end));
            canvas.label(&foot, &Vector2::new(0.0, 1.0), 18.0, &Label::words(&(number + 1).to_string()).bare());
        }
        panel.name(&mut canvas, &Label::words(&format!("{name}: computed over printed, less one, in %")));
    }
    key(&mut canvas);
    for (number, hypothesis) in hypotheses.iter().enumerate() {
        let at = Vector2::new(20.0, panels_end - 22.0 + LINE * number as f64);
        let label = Label::words(&format!("{}   {}", number + 1, hypothesis.name));
        canvas.label(&at, &Vector2::new(1.0, 0.0), 0.0, &label.bare());
    }
    let columns = [("hypothesis", "1"), ("n", "1"), ("peak", "%"), ("minimum", "%"), ("period", "%")];
    let rows = hypotheses.iter().enumerate().flat_map(|(number, hypothesis)| {
        hypothesis.runs.iter().map(move |run| {
            let [peak, minimum, period] = RESULTS.map(|(_, of)| 100.0 * of(run));
            [(number + 1) as f64, f64::from(run.mechanism.slots()), peak, minimum, period]
        })
    });
    words(hypotheses).figure(canvas, Kind::Panels, Series::new(columns, rows))
}

/// The marks of the mechanisms, over the first panel.
fn key(canvas: &mut Canvas) {
    for (k, mechanism) in Mechanism::ALL.into_iter().enumerate() {
        let at = Vector2::new(24.0 + 160.0 * k as f64, 18.0);
        marks(canvas, &[at], of_mechanism(mechanism.slots()), 2.0 * SIZE);
        let label = Label::words(&format!("{} pins", mechanism.pins())).shade(of_mechanism(mechanism.slots()).0).bare();
        canvas.label(&at, &Vector2::new(1.0, 0.0), 12.0, &label);
    }
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
    Words {
        id: "runs-hypotheses".to_owned(),
        title: "How far the printed results are from those that each hypothesis gives".to_owned(),
        description: format!(
            "Three panels, for peak, minimum and period. In each a column for every hypothesis, with a strip of marks \
             for each mechanism: computed over printed, less one, in per cent. The largest deviations of peak, minimum \
             and period, in per cent: {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        caption: "Every mark is a run: its computed result over the printed one, less one. The scale is logarithmic \
                  to either side and even near zero. Within a strip, friction and torque rise to the right."
            .to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{labels_inside, named, only_numbers, overlapping_labels, well_formed};
    use roxmltree::Document;

    fn hypothesis(size: f64) -> Deviations {
        let run = |mechanism| Deviation { mechanism, peak: size, minimum: -size, period: 0.0 };
        Deviations { name: "one, two, three".to_owned(), runs: Mechanism::ALL.map(run).to_vec() }
    }

    #[test]
    fn marks_stand_as_far_from_zero_as_they_deviate() {
        let figure = deviations(&[0.4, 0.001, 0.0].map(hypothesis));
        well_formed(&figure);
        only_numbers(&figure);
        labels_inside(&figure);
        assert_eq!(overlapping_labels(&figure), []);
        let document = Document::parse(&figure.svg).expect("well-formed");
        let zeros: Vec<f64> = named(&document, "zero").iter().map(|line| crate::checks::number(line, "y1")).collect();
        // Three mechanisms in each panel, each with the hypotheses in order; the key's come last.
        let marks = named(&document, "marks");
        assert_eq!(marks.len(), 9 + 3);
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
            well_formed(&deviations(&some));
            only_numbers(&deviations(&some));
        }
    }
}
