//! By how much printed numbers differ from computed ones, in units of the last printed digit.

use crate::chart::{Chart, ChartAxis, LegendEntry, LineStyle, MarkShape, Marker, Panel, of_mechanism};
use crate::svg::Label;
use crate::theme::FILL;
use crate::{Figure, Series, Words};
use geneva_case1973::{ComparedCell, Score};
use geneva_kinematics::Mechanism;

/// Differences up to this many units have their place on the axis; a mark at its edge stands for a greater one.
const LIMIT: f64 = 300.0;
/// Height of a mechanism's strip, in pixels, and how much of it its marks take.
const STRIP: f64 = 58.0;
const TAKEN: f64 = 0.7;
const SIZE: f64 = 8.0;
/// What a mark beyond the edge is drawn as, for the captions.
const BEYOND: &str = "An arrowhead at the edge is a number that is farther off.";

/// By how much the printed number is greater.
fn residual(cell: &ComparedCell) -> f64 {
    cell.printed - cell.computed
}

/// All cells under one hypothesis.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedCells {
    /// The hypothesis, in a few words.
    pub name: String,
    /// The cells.
    pub cells: Vec<ComparedCell>,
}

impl ComparedCells {
    /// The cells of a score, under this name of its hypothesis.
    pub fn new(name: String, score: &Score) -> Self {
        Self { name, cells: score.cells().collect() }
    }

    /// How many are within one unit, of how many.
    fn count(&self) -> String {
        format!("{} of {}", self.cells.iter().filter(|cell| cell.is_within_one()).count(), self.cells.len())
    }

    /// Whether a difference has no place on the axis.
    fn goes_beyond(&self) -> bool {
        self.cells.iter().any(|cell| residual(cell).abs() > LIMIT)
    }
}

/// Printed numbers less the computed ones, in units of the last printed digit: a panel for each of two hypotheses about
/// the same cells, one under the other.
///
/// In each a strip for every mechanism, over one symmetric logarithmic axis; numbers that differ by one unit at most are on
/// shaded ground. `units` says what a unit is, `others` what else is to be said of the runs in the caption. Series: whatever
/// says of each cell which one it is, and its numbers.
pub fn agreement(hypotheses: &[ComparedCells; 2], series: Series, units: &str, others: &str) -> Figure {
    let [before, after] = hypotheses;
    let beyond = if hypotheses.iter().any(ComparedCells::goes_beyond) { BEYOND } else { "" };
    let words = Words::new(
        "runs-agreement",
        "Printed numbers minus computed ones, in units of the last printed digit",
        format!(
            "Two panels, one above the other, with strips for six, four and three pins. A mark is a printed number; its place \
             from left to right is the printed number minus the computed one. Above, computed for {}: four pins are in the \
             shaded band of one unit either way or close to it, nearly all six pins are to its right and three pins to its \
             left; {} numbers are in the band. Below, computed by {}: nearly all marks are in the band, {}.",
            before.name,
            before.count(),
            after.name,
            after.count()
        ),
        [
            "By how many units of its last digit does each printed number differ from the computed one? Each mark is a peak or \
             a minimum of the driver's speed, or a period, in one of the 49 runs of Appendix E.",
            &format!("A unit is {units}. The shaded band extends one unit either way."),
            "The scale is compressed away from zero.",
            "Above: the real mechanisms, each with its own reset angle and its true peaks. Below: the program as \
             listed, which resets the driver's angle after 90° for all three mechanisms. Its peaks are the largest \
             speeds on its print-out.",
            beyond,
            others,
        ]
        .into_iter()
        .filter(|sentence| !sentence.is_empty())
        .collect::<Vec<_>>()
        .join(" "),
    );
    let x = ChartAxis::symmetric_log(LIMIT);
    let panels = [panel(before, &x.clone().unnumbered()), panel(after, &titled(x))];
    Chart::new(panels).key(key()).figure(words, series)
}

/// Printed numbers less the computed ones under one hypothesis, on the axis of [`agreement`].
///
/// `figure` is its name. Series, a row for each cell: slots, printed, computed.
pub fn one_agreement(figure: &str, hypothesis: &ComparedCells, units: &str) -> Figure {
    let beyond = if hypothesis.goes_beyond() { format!(" {BEYOND}") } else { String::new() };
    let words = Words::new(
        figure,
        format!("Printed numbers minus computed ones: {}", hypothesis.name),
        format!(
            "Strips for six, four and three pins. A mark is a printed number; its place from left to right is the printed \
             number minus the computed one ({}). In the shaded band, one unit either way, are {}.",
            hypothesis.name,
            hypothesis.count()
        ),
        format!(
            "Each mark shows one printed number of Appendix E minus the computed number ({}), in units of the last \
             printed digit ({units}), on a scale that is compressed away from zero. The shaded band, one unit either \
             way, contains {} marks.{beyond}",
            hypothesis.name,
            hypothesis.count()
        ),
    );
    let rows = hypothesis.cells.iter().map(|cell| [f64::from(cell.mechanism.slots()), cell.printed, cell.computed]);
    let series = Series::new([("slots", "1"), ("printed", "unit"), ("computed", "unit")], rows);
    Chart::new([panel(hypothesis, &titled(ChartAxis::symmetric_log(LIMIT)))]).key(key()).figure(words, series)
}

fn titled(x: ChartAxis) -> ChartAxis {
    x.titled(Label::words("printed minus computed, in units of the last digit"))
}

/// The cells of a hypothesis in strips, and the band of one unit.
fn panel(hypothesis: &ComparedCells, x: &ChartAxis) -> Panel {
    let y = ChartAxis::of_kinds(Mechanism::ALL.map(|mechanism| mechanism.pins().to_string()));
    let count = y.blank().titled(Label::words(&format!("{} within ±1", hypothesis.count())));
    let y = y.titled(Label::words(&hypothesis.name));
    let panel = Panel::new(STRIP * Mechanism::ALL.len() as f64, x, &y).right_axis(count);
    let panel = panel.band(-1.0..1.0, FILL, "one-unit").vertical(0.0, LineStyle::thin("zero"));
    (1..).map(f64::from).zip(Mechanism::ALL).fold(panel, |panel, (strip, mechanism)| {
        let panel = if strip > 1.0 { panel.horizontal(strip - 0.5, LineStyle::edge()) } else { panel };
        let points = points(hypothesis, mechanism, strip);
        let beyond =
            |side: f64| points.iter().filter(move |(x, _)| side * x > LIMIT).map(move |(_, y)| (side * LIMIT, *y));
        let [left, right] = [-1.0, 1.0].map(|side| beyond(side).collect::<Vec<_>>());
        let own = of_mechanism(mechanism.slots()).1.sized(SIZE);
        let [to_left, to_right] =
            [MarkShape::Left, MarkShape::Right].map(|mark| Marker { mark, ..own }.sized(11.0).class("beyond"));
        panel.marks(points, own).marks(left, to_left).marks(right, to_right)
    })
}

/// The differences of a mechanism's cells, one below the other in its strip in the order of the tables.
fn points(hypothesis: &ComparedCells, mechanism: Mechanism, strip: f64) -> Vec<(f64, f64)> {
    let own: Vec<&ComparedCell> = hypothesis.cells.iter().filter(|cell| cell.mechanism == mechanism).collect();
    let place = |(k, cell): (usize, &&ComparedCell)| {
        let share = (k as f64 + 0.5) / own.len() as f64 - 0.5;
        (residual(cell), strip + TAKEN * share)
    };
    own.iter().enumerate().map(place).filter(|(x, _)| x.is_finite()).collect()
}

fn key() -> [LegendEntry; 3] {
    Mechanism::ALL.map(|mechanism| {
        let marker = of_mechanism(mechanism.slots()).1;
        LegendEntry::marks([marker], Label::words(&format!("{} pins", mechanism.pins())).in_colour(marker.colour))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn, assert_sound};

    fn compared(name: &str, off: f64) -> ComparedCells {
        let cell = |mechanism| ComparedCell { mechanism, printed: 30.0, computed: 30.0 - off };
        ComparedCells { name: name.to_owned(), cells: Mechanism::ALL.map(cell).to_vec() }
    }

    /// The numbers of a cell.
    fn numbers() -> Series {
        Series::new([("printed", "1")], [[30.0]])
    }

    /// Where the first mark of each path of a class is.
    fn places(drawing: &ParsedDrawing<'_>, class: &str) -> Vec<[f64; 2]> {
        let place = |data: &str| {
            let mut numbers = data.trim_start_matches('M').split([' ', 'h', 'l', 'L']).map(|word| word.parse::<f64>());
            [0, 1].map(|_| numbers.next().expect("two").expect("a number"))
        };
        drawing.elements(class).iter().map(|mark| place(mark.attribute("d").expect("a path"))).collect()
    }

    #[test]
    fn marks_are_as_far_from_zero_as_printed_and_computed_differ() {
        let figure = agreement(&[compared("own angle", 10.0), compared("90°", -0.5)], numbers(), "1 rad/s", "Made up.");
        assert_sound(&figure);
        assert!(figure.caption.ends_with("Made up.") && !figure.caption.contains(BEYOND));
        let drawing = ParsedDrawing::parse(&figure);
        let texts = drawing.texts();
        for count in ["0 of 3 within ±1", "3 of 3 within ±1", "6", "4", "3"] {
            assert!(texts.iter().any(|text| text == count), "{texts:?}");
        }
        let zero = drawing.path("zero", 0)[0].x;
        let band = drawing.path("one-unit", 0);
        let unit = (band[2].x - zero).abs();
        let marks = places(&drawing, "marks");
        assert_eq!(marks.len(), 6);
        for (k, [x, _]) in marks.iter().enumerate() {
            let expected = if k < 3 { 2.0 * unit } else { -0.5 * unit };
            assert!((x - zero - expected).abs() < 0.2, "{x} {zero} {unit}");
        }
        // Six pins at the top, three at the foot of each panel.
        assert!(marks[..3].windows(2).all(|pair| pair[0][1] < pair[1][1]), "{marks:?}");
    }

    #[test]
    fn what_is_beyond_the_axis_is_an_arrowhead_at_its_edge() {
        let off = |off: f64| one_agreement("agreement", &compared("own angle", off), "1 rad/s");
        for (off, side) in [(off(1e4), 1.0), (off(-1e4), -1.0)] {
            assert_sound(&off);
            assert!(off.caption.ends_with(BEYOND));
            let drawing = ParsedDrawing::parse(&off);
            let zero = drawing.path("zero", 0)[0].x;
            let edge = drawing.path("edge", 0).iter().map(|end| side * (end.x - zero)).fold(0.0, f64::max);
            let beyond = places(&drawing, "beyond");
            assert_eq!((beyond.len(), drawing.count("marks")), (3, 0));
            assert!(beyond.iter().all(|[x, _]| (side * (x - zero) - edge).abs() < 7.0), "{beyond:?} {edge}");
        }
    }

    #[test]
    fn a_unit_is_a_unit_at_either_side() {
        let cell = |computed| ComparedCell { mechanism: Mechanism::FOUR_PIN, printed: 17.0, computed };
        assert!([16.0, 16.3, 18.0].into_iter().all(|computed| cell(computed).is_within_one()));
        assert!([15.99, 18.01, f64::NAN].into_iter().all(|computed| !cell(computed).is_within_one()));
    }

    #[test]
    fn nothing_is_drawn_too() {
        let nothing = ComparedCells { name: "nothing".to_owned(), cells: vec![] };
        assert_drawn(&agreement(&[nothing.clone(), nothing], numbers(), "1 rad/s", ""));
    }
}
