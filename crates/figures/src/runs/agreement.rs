//! Printed numbers against computed ones, under two hypotheses side by side.

use crate::chart::{Axis, Chart, Entry, Marker, Panel, Scale, Spot, Stroke, of_mechanism};
use crate::svg::Label;
use crate::theme::FILL;
use crate::{Figure, Series, Words};
use geneva_kinematics::Mechanism;

/// Marks of both axes, and how far beyond the outermost numbers they go.
const MARKS: [f64; 7] = [1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0];
const ROOM: f64 = 1.15;
const ROOM_FOR_OTHERS: f64 = 1.6;
/// Steps of the edges of the strip of one unit.
const STEPS: u32 = 60;
/// Where the count may stand, in shares of the frame.
const COUNT: [[f64; 2]; 3] = [[0.34, 0.92], [0.33, 0.86], [0.32, 0.8]];
const SIZE: f64 = 6.5;

/// One printed number and the computed one, both in units of the last printed place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// The mechanism it is said of.
    pub mechanism: Mechanism,
    /// As printed.
    pub printed: f64,
    /// As computed.
    pub computed: f64,
}

impl Cell {
    /// Whether the two are no more than a unit apart.
    pub fn is_within_one(&self) -> bool {
        (self.printed - self.computed).abs() <= 1.0 + 1e-9
    }
}

/// All cells under one hypothesis.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// The hypothesis, in a few words.
    pub name: String,
    /// The cells.
    pub cells: Vec<Cell>,
}

impl Compared {
    fn count(&self) -> String {
        format!("{} of {}", self.cells.iter().filter(|cell| cell.is_within_one()).count(), self.cells.len())
    }
}

/// Printed numbers against computed ones on logarithmic axes: a panel for each of two hypotheses about the same cells.
///
/// A strip along the diagonal holds the numbers that are off by one unit at most. `unit` says what a unit is, `others`
/// what else is to be said of the runs in the caption. Series, a row for each cell: slots, printed, computed by either.
pub fn agreement(hypotheses: &[Compared; 2], unit: &str, others: &str) -> Figure {
    let values = || hypotheses.iter().flat_map(|one| &one.cells).flat_map(|cell| [cell.printed, cell.computed]);
    let values = || values().filter(|value| *value > 0.0 && value.is_finite());
    let (least, most) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
    let range = if least < most { least / ROOM..most * ROOM } else { 1.0..1000.0 };
    let marks = MARKS.into_iter().filter(|mark| range.contains(mark)).collect();
    let axis = Axis::new(Scale::Logarithmic, range, marks, 0);
    let x = axis.clone().titled(Label::words(&format!("printed, in {unit}")));
    let panels = hypotheses.each_ref().map(|hypothesis| panel(hypothesis, &axis, &x));
    let [before, after] = hypotheses;
    let words = Words::new(
        "runs-agreement",
        "Printed numbers against computed ones, under two hypotheses",
        format!(
            "Two panels with logarithmic axes, printed numbers to the right, computed ones upwards, and a diagonal. \
             Left, computed with {}: four pins lie on the diagonal, six and three pins off it to either side; {} are \
             within one unit. Right, {}: all lie on the diagonal or close to it; {} are within one unit.",
            before.name,
            before.count(),
            after.name,
            after.count()
        ),
        format!(
            "Each mark is one printed number of Appendix E: peak and minimum of the driver's speed and period of 49 \
             runs, in {unit}. On the diagonal the computed number is the printed one. Counted as agreeing are those \
             within one unit of the last printed place, the shaded strip. Left, the mechanisms: the driver's angle is reset as each \
             needs it, and the peaks are the true ones; right, the program as listed: after 90° for all three, and the peaks are the largest on the print-out. {others}"
        )
        .trim_end(),
    );
    let columns = [("n", "1"), ("printed", "unit"), ("own reset", "unit"), ("one reset", "unit")];
    let rows = before.cells.iter().zip(&after.cells);
    let rows = rows.map(|(a, b)| [f64::from(a.mechanism.slots()), a.printed, a.computed, b.computed]);
    Chart::new(panels).in_columns(2).key(key()).figure(words, Series::new(columns, rows))
}

/// The same for one hypothesis, on axes of the printed numbers alone, so that hypotheses can be compared one after another.
///
/// Series, a row for each cell: slots, printed, computed.
pub fn one_agreement(hypothesis: &Compared, unit: &str) -> Figure {
    let printed = || hypothesis.cells.iter().map(|cell| cell.printed).filter(|value| *value > 0.0);
    let (least, most) = (printed().fold(f64::INFINITY, f64::min), printed().fold(0.0, f64::max));
    let range = if least < most { least / ROOM_FOR_OTHERS..most * ROOM_FOR_OTHERS } else { 1.0..1000.0 };
    let marks = MARKS.into_iter().filter(|mark| range.contains(mark)).collect();
    let axis = Axis::new(Scale::Logarithmic, range, marks, 0);
    let x = axis.clone().titled(Label::words(&format!("printed, in {unit}")));
    let words = Words::new(
        "live-mistake",
        format!("Printed numbers against computed ones: {}", hypothesis.name),
        format!(
            "Logarithmic axes, printed numbers to the right, computed ones upwards, and a diagonal. Computed with {}, {} are \
             within one unit of the last printed place.",
            hypothesis.name,
            hypothesis.count()
        ),
        format!(
            "Each mark is one printed number of Appendix E in {unit}, against the computed one. Computed with {}: {} agree \
             within a unit of the last printed place, the shaded strip.",
            hypothesis.name,
            hypothesis.count()
        ),
    );
    let rows = hypothesis.cells.iter().map(|cell| [f64::from(cell.mechanism.slots()), cell.printed, cell.computed]);
    let series = Series::new([("n", "1"), ("printed", "unit"), ("computed", "unit")], rows);
    Chart::new([panel(hypothesis, &axis, &x)]).key(key()).figure(words, series)
}

/// The cells of a hypothesis, the diagonal and the strip of one unit about it.
fn panel(hypothesis: &Compared, axis: &Axis, x: &Axis) -> Panel {
    let y = axis.clone().titled(Label::words(&format!("computed: {}", hypothesis.name)));
    let panel = Panel::new(330.0, x, &y).area(strip(axis), FILL, "one-unit");
    let ends = [axis.range.start, axis.range.end];
    let panel = panel.curve(ends.map(|end| (end, end)), Stroke::thin("diagonal"));
    let panel = Mechanism::ALL.into_iter().fold(panel, |panel, mechanism| {
        let own = hypothesis.cells.iter().filter(|cell| cell.mechanism == mechanism);
        panel.marks(own.map(|cell| (cell.printed, cell.computed)), marker(mechanism))
    });
    panel.name(Label::words(&format!("{} agree", hypothesis.count())), Spot::Free(COUNT.to_vec()))
}

fn key() -> [Entry; 3] {
    Mechanism::ALL.map(|mechanism| {
        let marker = of_mechanism(mechanism.slots()).1;
        Entry::marks([marker], Label::words(&format!("{} pins", mechanism.pins())).shade(marker.shade))
    })
}

fn marker(mechanism: Mechanism) -> Marker {
    of_mechanism(mechanism.slots()).1.sized(SIZE)
}

/// What is within one unit of the diagonal, as far as it lies between the ends of the axes.
fn strip(axis: &Axis) -> Vec<(f64, f64)> {
    let (start, end) = (axis.range.start, axis.range.end);
    let at = |step: u32| axis.value_at(f64::from(step) / f64::from(STEPS));
    let above = (0..=STEPS).map(|step| (at(step), (at(step) + 1.0).min(end)));
    let below = (0..=STEPS).rev().map(|step| (at(step), (at(step) - 1.0).max(start)));
    above.chain(below).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{Drawing, drawn, sound};

    fn compared(name: &str, quotient: f64) -> Compared {
        let cell = |(k, mechanism)| {
            let printed = 9.0 * f64::from(k);
            Cell { mechanism, printed, computed: quotient * printed }
        };
        Compared { name: name.to_owned(), cells: (1..).zip(Mechanism::ALL).map(cell).collect() }
    }

    #[test]
    fn what_agrees_lies_on_the_diagonal_and_what_is_too_high_above_it() {
        let figure = agreement(&[compared("own angle", 1.5), compared("90°", 1.0)], "units", "Made up.");
        sound(&figure);
        assert!(figure.caption.ends_with("Made up."));
        let drawing = Drawing::of(&figure);
        let texts = drawing.texts();
        assert!(texts.contains(&"0 of 3 agree".to_owned()) && texts.contains(&"3 of 3 agree".to_owned()), "{texts:?}");
        for (panel, above) in [(0, true), (1, false)] {
            let diagonal = drawing.path("diagonal", panel);
            let [from, to] = [diagonal[0], diagonal[1]];
            for mark in drawing.all("marks").iter().skip(3 * panel).take(3) {
                let data = mark.attribute("d").expect("a path").split('M').nth(1).expect("a mark");
                let at: Vec<f64> =
                    data.split([' ', 'h', 'l']).take(2).map(|word| word.parse().expect("a number")).collect();
                let share = (at[0] - from.x) / (to.x - from.x);
                let off = from.y + share * (to.y - from.y) - at[1];
                assert_eq!(off > 20.0, above, "{off} in panel {panel}");
            }
        }
    }

    #[test]
    fn a_unit_is_a_unit_at_either_side() {
        let cell = |computed| Cell { mechanism: Mechanism::FOUR_PIN, printed: 17.0, computed };
        assert!([16.0, 16.3, 18.0].into_iter().all(|computed| cell(computed).is_within_one()));
        assert!([15.99, 18.01, f64::NAN].into_iter().all(|computed| !cell(computed).is_within_one()));
    }

    #[test]
    fn nothing_is_drawn_too() {
        let nothing = Compared { name: "nothing".to_owned(), cells: vec![] };
        drawn(&agreement(&[nothing.clone(), nothing], "units", ""));
    }
}
