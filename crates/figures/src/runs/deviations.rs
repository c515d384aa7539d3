//! How far the numbers of a table are from those that several hypotheses give.

use super::agreement::ComparedCells;
use crate::chart::{AxisScale, Chart, ChartAxis, LegendEntry, LineStyle, Panel, Spot, of_mechanism};
use crate::number::short;
use crate::svg::Label;
use crate::theme::FILL;
use crate::{Figure, Series, Words};
use geneva_case1973::ComparedCell;
use geneva_kinematics::Mechanism;

/// The scale, in units of the last place; what is nearer stands at its start.
const LEAST: f64 = 0.01;
const GREATEST: f64 = 1000.0;
/// Height of the strips of a hypothesis, in pixels, and of one mechanism's marks as a part of it.
const HEIGHT: f64 = 48.0;
const STRIP: f64 = 0.24;
/// From the strip of one mechanism to that of the next, in parts of a hypothesis's height.
const PITCH: f64 = 0.29;
const SIZE: f64 = 5.0;

/// How far all printed numbers are from the computed ones under each hypothesis, in units of the last printed place.
///
/// A row for each hypothesis, in it a strip of marks for each mechanism, on one logarithmic axis, with the numbers that
/// are off by one unit at most on a shaded ground and their count at the right. Series, a row for each cell: the
/// number of the hypothesis, slots, printed and computed number.
///
/// # Panics
///
/// Without a hypothesis.
pub fn deviations(hypotheses: &[ComparedCells]) -> Figure {
    let count = hypotheses.len();
    let numbers = || (1..=hypotheses.len()).map(|number| number as f64);
    let x = ChartAxis::new(AxisScale::Logarithmic, LEAST..GREATEST, vec![0.01, 0.1, 1.0, 10.0, 100.0, 1000.0], 2);
    let x = x.titled(Label::words("off by, in units of the last printed place"));
    // The first at the top.
    let y = ChartAxis::whole(count as f64 + 0.5..0.5, numbers()).without_grid();
    let total = hypotheses[0].cells.len();
    let right = y.blank().titled(Label::words(&format!("of {total} within one unit")));
    let panel = Panel::new(HEIGHT * count as f64, &x, &y.titled(Label::words("hypothesis"))).right_axis(right);
    let panel = panel.band(LEAST..1.0, FILL, "one-unit").vertical(1.0, LineStyle::thin("unit"));
    let edges = numbers().skip(1).map(|number| number - 0.5);
    let mut panel = edges.fold(panel, |panel, edge| panel.horizontal(edge, LineStyle::edge()));
    for (strip, mechanism) in Mechanism::ALL.into_iter().enumerate() {
        let marker = of_mechanism(mechanism.slots()).1.sized(SIZE);
        panel = panel.marks(strips(hypotheses, strip, mechanism), marker);
    }
    for (number, one) in numbers().zip(hypotheses) {
        let within = one.cells.iter().filter(|cell| cell.is_within_one()).count();
        panel = panel.name(Label::words(&within.to_string()), Spot::Beside(number));
    }
    let key = Mechanism::ALL.map(|mechanism| {
        let marker = of_mechanism(mechanism.slots()).1;
        LegendEntry::marks([marker], Label::words(&format!("{} pins", mechanism.pins())).in_colour(marker.colour))
    });
    let columns = [("hypothesis", "1"), ("slots", "1"), ("printed", "unit"), ("computed", "unit")];
    let rows = numbers().zip(hypotheses).flat_map(|(number, one)| {
        one.cells.iter().map(move |cell| [number, f64::from(cell.mechanism.slots()), cell.printed, cell.computed])
    });
    Chart::new([panel]).key(key).figure(words(hypotheses), Series::new(columns, rows))
}

fn off(cell: &ComparedCell) -> f64 {
    (cell.printed - cell.computed).abs()
}

/// The marks of a mechanism under all hypotheses: the number of the strip is that of the mechanism.
fn strips(hypotheses: &[ComparedCells], strip: usize, mechanism: Mechanism) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for (row, hypothesis) in hypotheses.iter().enumerate() {
        let own: Vec<_> = hypothesis.cells.iter().filter(|cell| cell.mechanism == mechanism).collect();
        let middle = row as f64 + 1.0 + PITCH * (strip as f64 - 1.0);
        let place = |(k, cell): (usize, &&ComparedCell)| {
            let aside = (k as f64 + 0.5) / own.len() as f64 - 0.5;
            (off(cell).clamp(LEAST, GREATEST), middle + STRIP * aside)
        };
        points.extend(own.iter().enumerate().map(place).filter(|(x, _)| x.is_finite()));
    }
    points
}

fn words(hypotheses: &[ComparedCells]) -> Words {
    let said = hypotheses.iter().enumerate().map(|(number, one)| {
        let within = one.cells.iter().filter(|cell| cell.is_within_one()).count();
        let worst = one.cells.iter().map(off).fold(0.0, f64::max);
        format!("{}, {}: {within} within one unit, the worst off by {}", number + 1, one.name, short(worst, 2))
    });
    Words::new(
        "runs-hypotheses",
        "How far the printed results are from those that each hypothesis gives",
        format!(
            "A row for each hypothesis, on one logarithmic axis of how many units of the last place the printed number \
             differs from the computed one. {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        "Every mark is a printed peak, minimum or period of the 49 runs. Marks to the left of the line differ from the \
         computed number by at most one unit of the last printed digit (1 rad/s or 1 ms). Differences of less than a \
         hundredth of a unit are drawn at the left edge. The hypotheses are numbered as in the table.",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn, assert_sound};

    fn hypothesis(off: f64) -> ComparedCells {
        let cell = |mechanism| ComparedCell { mechanism, printed: 20.0, computed: 20.0 + off };
        ComparedCells { name: "one, two, three".to_owned(), cells: Mechanism::ALL.map(cell).to_vec() }
    }

    #[test]
    fn marks_stand_as_far_from_one_unit_as_they_deviate() {
        let figure = deviations(&[10.0, -0.1, 0.0].map(hypothesis));
        assert_sound(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        let unit = drawing.path("unit", 0)[0].x;
        let marks = drawing.elements("marks");
        assert_eq!(marks.len(), 3);
        for mark in marks {
            let places = mark.attribute("d").expect("a path").split('M').skip(1);
            let places = places.map(|part| {
                let mut numbers = part.split([' ', 'h', 'l']).map(|word| word.parse::<f64>());
                (numbers.next().expect("x").expect("a number"), numbers.next().expect("y").expect("a number"))
            });
            let places: Vec<(f64, f64)> = places.collect();
            // A decade above a unit, a decade below it, and the end of the scale; from the top down.
            let [a, b, c] = [0, 1, 2].map(|k| places[k].0 - unit);
            assert!(a > 50.0 && (a + b).abs() < 0.1 && (c - 2.0 * b).abs() < 0.2, "{a} {b} {c}");
            assert!(places.windows(2).all(|pair| pair[0].1 < pair[1].1), "{places:?}");
        }
        // Two counts of three, and the number of the third hypothesis.
        assert_eq!(drawing.texts().iter().filter(|text| *text == "3").count(), 3);
    }

    #[test]
    fn exact_and_far_off_numbers_are_drawn() {
        for off in [0.0, 1e9] {
            assert_drawn(&deviations(&[hypothesis(off)]));
        }
    }
}
