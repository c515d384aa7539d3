//! What the size of the joints costs: mean speed and contraction against it.

use crate::escapement::axes::{spanning, upright};
use crate::figure::{Figure, Words};
use crate::markers::kind;
use crate::number::significant;
use crate::panel::{Panel, Stroke, WIDTH};
use crate::samples::{Samples, dashes};
use crate::series::{Column, Series};
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;

const HEIGHTS: [u32; 2] = [374, 404];
const SIZE: f64 = 8.0;
/// A curve of more points has no marks on them.
const MARKED: usize = 16;

/// A named line of one panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it is, in a few words.
    pub name: String,
    /// Size of the joint, and the value there.
    pub points: Vec<(f64, f64)>,
}

/// Mean speed over that of the ideal mechanism, and contraction, over the size of a joint.
///
/// `speeds` and `contractions` are the lines of the two panels; lines of the same name have the same look. `size` says
/// what the joint's size is and its unit. Points that are no numbers are left out. Series: panel, number of the line's
/// name in order of first appearance, size, value.
pub fn losses(size: &str, speeds: &[Line], contractions: &[Line]) -> Figure {
    let groups = [speeds, contractions];
    let mut names: Vec<&str> = Vec::new();
    for line in groups.into_iter().flatten() {
        if !names.contains(&line.name.as_str()) {
            names.push(&line.name);
        }
    }
    let number = |line: &Line| names.iter().position(|name| *name == line.name).unwrap_or(0);
    let finite = |line: &Line| -> Vec<(f64, f64)> {
        line.points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite()).collect()
    };
    let all = || groups.into_iter().flatten().flat_map(finite);
    let sizes = || all().map(|point| point.0);
    let (least, greatest) = (sizes().fold(f64::INFINITY, f64::min), sizes().fold(f64::NEG_INFINITY, f64::max));
    let level = if least < greatest { spanning(least, greatest, 5.0) } else { upright(0.0, greatest.max(1.0), 5.0) };
    let key = Samples::new(&names);
    let (corners, height) = Panel::stack(key.height(), HEIGHTS);
    let mut canvas = Canvas::new(f64::from(WIDTH), height);
    let titles = ["mean speed over the ideal one", "contraction"];
    for (k, (corner, lines)) in corners.into_iter().zip(groups).enumerate() {
        let values = || lines.iter().flat_map(finite).map(|point| point.1);
        let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let left = if low < high { spanning(low, high, 4.0) } else { upright(0.0, high.max(1.0), 4.0) };
        let panel = Panel::new(corner, HEIGHTS[k], level.clone(), left);
        panel.draw(&mut canvas, true);
        for line in lines {
            let (points, style) = (finite(line), kind(number(line)));
            let stroke = Stroke { shade: style.0, width: 2.2, dashes: dashes(number(line)), class: "loss" };
            panel.curve(&mut canvas, &points, stroke);
            if points.len() <= MARKED {
                panel.marks(&mut canvas, &points, style, SIZE);
            }
        }
        panel.name(&mut canvas, &Label::words(titles[k]));
        if k == 1 {
            panel.foot(&mut canvas, &Label::words(size));
        }
    }
    key.draw(&mut canvas, 2.2);
    let said = groups.into_iter().zip(titles).flat_map(|(lines, title)| {
        lines.iter().filter_map(move |line| {
            let points = finite(line);
            let (first, last) = (points.first()?, points.last()?);
            let [from, to] = [first.1, last.1].map(|value| significant(value, 3));
            Some(format!("{title}, {}: from {from} to {to}", line.name))
        })
    });
    let said: Vec<String> = said.collect();
    let words = Words {
        id: "joints-losses".to_owned(),
        title: "What the size of the joints costs".to_owned(),
        description: format!(
            "Two panels over the {size}: the mean speed over that of the ideal mechanism, and the contraction. {}.",
            said.join("; ")
        ),
        caption: format!("Mean speed over that of the ideal mechanism, and contraction, over the {size}."),
    };
    let rows = groups.into_iter().enumerate().flat_map(|(panel, lines)| {
        lines.iter().flat_map(move |line| {
            let points = finite(line).into_iter();
            points.map(move |(x, y)| vec![(panel + 1) as f64, (number(line) + 1) as f64, x, y])
        })
    });
    let columns = [("panel", "1"), ("line", "1"), ("size", "1"), ("value", "1")];
    let column = |(name, unit): (&str, &str)| Column { name: name.to_owned(), unit: unit.to_owned() };
    let series = Series { columns: columns.map(column).to_vec(), rows: rows.collect(), ..Series::new([("", "")], []) };
    words.figure(canvas, Kind::Panels, series)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{labels_inside, named, only_numbers, overlapping_labels, well_formed};
    use roxmltree::Document;

    fn lines(count: usize, points: i32, value: fn(f64) -> f64) -> Vec<Line> {
        let point = |k: i32| (f64::from(k) / f64::from(points), value(f64::from(k) / f64::from(points)));
        (0..count).map(|n| Line { name: format!("joint {n}"), points: (0..=points).map(point).collect() }).collect()
    }

    #[test]
    fn every_line_is_drawn_where_its_points_are() {
        for (count, points) in [(1, 4), (3, 12), (5, 40)] {
            let (speeds, contractions) = (lines(count, points, |x| 1.0 - 0.5 * x), lines(count, points, |x| 0.1 + x));
            let figure = losses("radius of the pin over the crank", &speeds, &contractions);
            well_formed(&figure);
            only_numbers(&figure);
            labels_inside(&figure);
            assert_eq!(overlapping_labels(&figure), []);
            let document = Document::parse(&figure.svg).expect("well-formed");
            let curves = named(&document, "loss");
            assert_eq!(curves.len(), 2 * count);
            // Straight lines are left with two points, falling and rising.
            for (k, curve) in curves.iter().enumerate() {
                let points = crate::checks::corners(curve.attribute("d").expect("a path"), 1.0);
                assert_eq!(points.len(), 2);
                assert_eq!(points[1].y > points[0].y, k < count);
            }
            assert_eq!(figure.series.rows.len(), 2 * count * (points as usize + 1));
        }
    }

    #[test]
    fn nothing_and_no_numbers_are_drawn_too() {
        let odd =
            vec![Line { name: "odd".to_owned(), points: vec![(f64::NAN, 1.0), (0.5, f64::INFINITY), (0.25, 0.5)] }];
        for some in [vec![], odd] {
            let figure = losses("size", &some, &some);
            well_formed(&figure);
            only_numbers(&figure);
        }
    }
}
