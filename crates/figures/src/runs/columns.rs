//! How many cells of each column of a table several hypotheses give.

use crate::chart::{Chart, ChartAxis, LegendEntry, LineStyle, MarkShape, Marker, Panel};
use crate::svg::Label;
use crate::theme::{Colour, DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, Series, Words};

/// The columns of the table: their names, colours and marks.
const COLUMNS: [(&str, Colour, MarkShape); 3] = [
    ("peaks", DRIVER, MarkShape::Disc),
    ("minima", FOLLOWER, MarkShape::Square),
    ("periods", RELATIVE, MarkShape::Diamond),
];
/// Height of the strip of a hypothesis, in pixels, and from one column's line to the next as a part of it.
const HEIGHT: f64 = 46.0;
const PITCH: f64 = 0.25;

/// What a hypothesis gives of one column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// Cells that agree to the printed digit.
    pub exact: usize,
    /// Cells within one unit of the last printed place.
    pub within_one: usize,
}

/// How many cells of each column are right, a row for each hypothesis: peaks, minima and periods.
///
/// A line goes from the cells that agree to the printed digit to those within one unit, where its mark is. `of` is how many a
/// column has. Series: the number of the hypothesis, then exact and within one for each column.
pub fn columns(hypotheses: &[[Count; 3]], of: usize) -> Figure {
    let count = hypotheses.len();
    let numbers = || (1..=hypotheses.len()).map(|number| number as f64);
    let x = ChartAxis::from_zero(0.0, of as f64, 5.0);
    let ticks = x.ticks.iter().copied().filter(|mark| *mark < of as f64 - 2.0).chain([of as f64]).collect();
    let x = ChartAxis { range: -0.02 * of as f64..1.03 * of as f64, ticks, ..x }
        .titled(Label::words("cells right, of the column"));
    let y = ChartAxis::whole(count as f64 + 0.5..0.5, numbers()).without_grid().titled(Label::words("hypothesis"));
    let panel = Panel::new(HEIGHT * count as f64, &x, &y);
    let mut panel = numbers().skip(1).fold(panel, |panel, number| panel.horizontal(number - 0.5, LineStyle::edge()));
    for (column, (_, colour, mark)) in COLUMNS.iter().enumerate() {
        let height = |row: usize| row as f64 + 1.0 + PITCH * (column as f64 - 1.0);
        for (row, counts) in hypotheses.iter().enumerate() {
            let ends = [counts[column].exact, counts[column].within_one].map(|cells| (cells as f64, height(row)));
            panel = panel.curve(ends, LineStyle::new(*colour).wide(2.0).class("cells"));
        }
        let marks = hypotheses.iter().enumerate().map(|(row, counts)| (counts[column].within_one as f64, height(row)));
        panel = panel.marks(marks, Marker::new(*colour, *mark));
    }
    let key = COLUMNS.map(|(name, colour, mark)| {
        LegendEntry::curve_with_marks(
            (LineStyle::new(colour).wide(2.0), Marker::new(colour, mark)),
            Label::words(name).in_colour(colour),
        )
    });
    let said = hypotheses.iter().enumerate().map(|(row, counts)| {
        let [peaks, minima, periods] = counts.map(|count| count.within_one);
        format!("{}: {peaks} peaks, {minima} minima, {periods} periods", row + 1)
    });
    let words = Words::new(
        "runs-columns",
        "How many peaks, minima and periods each hypothesis gives",
        format!(
            "A row for each hypothesis, in it three lines with a mark. Cells within one unit of the last place: {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        format!(
            "Each column of the printed tables by itself. A mark shows how many of the column's {of} cells a \
             hypothesis gives to within one unit of the last digit. The line to the mark begins at the number of cells \
             that agree to the printed digit. The hypotheses are numbered as in the table; all three mechanisms \
             are counted together."
        ),
    );
    let names = [
        ("hypothesis", "1"),
        ("peaks exact", "1"),
        ("peaks", "1"),
        ("minima exact", "1"),
        ("minima", "1"),
        ("periods exact", "1"),
        ("periods", "1"),
    ];
    let rows = hypotheses.iter().enumerate().map(|(row, [a, b, c])| {
        let of = |count: &Count| [count.exact as f64, count.within_one as f64];
        let ([a, b], [c, d], [e, f]) = (of(a), of(b), of(c));
        [row as f64 + 1.0, a, b, c, d, e, f]
    });
    Chart::new([panel]).key(key).figure(words, Series::new(names, rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound};

    #[test]
    fn marks_stand_farther_right_the_more_cells_are_right() {
        let of = |within_one: usize| [Count { exact: within_one / 2, within_one }; 3];
        let figure = columns(&[of(10), of(49), of(30)], 49);
        assert_sound(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        assert_eq!(["cells", "marks"].map(|class| drawing.count(class)), [9, 3]);
        let ends = [0, 1, 2].map(|row| drawing.path("cells", row)[1].x);
        assert!(ends[1] > ends[2] && ends[2] > ends[0], "{ends:?}");
        for row in 0..3 {
            let line = drawing.path("cells", row);
            assert!(line[0].x < line[1].x && (line[0].y - line[1].y).abs() < 0.1);
        }
    }
}
