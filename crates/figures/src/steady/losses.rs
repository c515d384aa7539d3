//! What the size of the joints costs: mean speed and multiplier against it.

use crate::chart::{Chart, ChartAxis, Panel, kind};
use crate::number::{significant, with_hyphens};
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::joints::{Joints, Varied, series};
use std::f64::consts::FRAC_PI_2;

/// A curve of more points has no marks on them.
const MARKED: usize = 16;

/// A named line of one panel.
#[derive(Clone, Debug, PartialEq)]
struct Line {
    /// What it is, in a few words.
    name: String,
    /// Size of the joint, and the value there.
    points: Vec<(f64, f64)>,
}

/// The largest radius, in crank radii, and how many there are besides zero.
const LARGEST: f64 = 0.2;
const RADII: u32 = 8;

/// Mean speed over that of the ideal mechanism, and multiplier, over the radius of the pin, of the driver's journal, and of the
/// follower's: in bearings with this friction, each alone. `shown` says which escapement it is.
///
/// # Errors
///
/// [`FigureError::Dynamics`] if there is no steady motion to compare with.
pub fn losses(parameters: &Parameters, bearing_friction: f64, shown: &str) -> Result<Figure, FigureError> {
    let journals = Joints { bearing_friction, ..Joints::IDEAL };
    let varied = [
        ("pin", Joints::IDEAL, Varied::PinRadius),
        ("driver's journal", journals, Varied::DriverJournal),
        ("follower's journal", journals, Varied::FollowerJournal),
    ];
    let (mut speeds, mut multipliers) = (Vec::new(), Vec::new());
    for (name, joints, varied) in varied {
        let radii = (0..=RADII).map(|k| LARGEST * f64::from(k) / f64::from(RADII));
        let effects = series(parameters, &joints, varied, radii)?;
        let line = |points: Vec<(f64, f64)>| Line { name: name.to_owned(), points };
        speeds.push(line(effects.iter().map(|effect| (effect.value, effect.mean_speed)).collect()));
        multipliers.push(line(effects.iter().map(|effect| (effect.value, effect.multiplier)).collect()));
    }
    Ok(of_lines("radius of pin or journal in crank radii", shown, &speeds, &multipliers))
}

/// Mean speed over that of the ideal mechanism, and multiplier, over the size of a joint.
///
/// `speeds` and `multipliers` are the lines of the two panels; lines of the same name have the same look. `size` says
/// what the joint's size is and its unit, `shown` which escapement it is. Points that are no numbers are left out. Series: panel, number of the line's
/// name in order of first appearance, size, value.
fn of_lines(size: &str, shown: &str, speeds: &[Line], multipliers: &[Line]) -> Figure {
    let groups = [speeds, multipliers];
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
    let x = if least < greatest {
        ChartAxis::spanning(least, greatest, 5.0)
    } else {
        ChartAxis::from_zero(0.0, greatest.max(1.0), 5.0)
    };
    let titles = ["mean speed over ideal mean speed", "multiplier"];
    let panels = [0, 1].map(|k| {
        let values = || groups[k].iter().flat_map(finite).map(|point| point.1);
        let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let y = if low < high {
            ChartAxis::spanning(low, high, 4.0)
        } else {
            ChartAxis::from_zero(0.0, high.max(1.0), 4.0)
        };
        let x = if k == 1 { x.clone().titled(Label::words(size)) } else { x.clone() };
        groups[k].iter().fold(Panel::new(260.0, &x, &y.titled(Label::words(titles[k]))), |panel, line| {
            let (points, (stroke, marker)) = (finite(line), kind(number(line)));
            let panel = panel.curve(points.iter().copied(), stroke.wide(2.2).class("loss"));
            let name = Label::words(&with_hyphens(&line.name)).in_colour(stroke.colour);
            // Named once, where the lines are farthest apart: the looks are the same in both panels.
            let is_named = groups.iter().take(k).any(|lines| lines.iter().any(|other| other.name == line.name));
            let last_half = points.iter().skip(points.len() / 2).copied();
            let falls = points.first().zip(points.last()).is_some_and(|(first, last)| last.1 < first.1);
            let first = if falls { -FRAC_PI_2 } else { FRAC_PI_2 };
            let panel = if is_named { panel } else { panel.name_near(last_half, first, name) };
            if points.len() <= MARKED { panel.marks(points, marker.sized(8.0)) } else { panel }
        })
    });
    let said = groups.into_iter().zip(titles).flat_map(|(lines, title)| {
        lines.iter().filter_map(move |line| {
            let points = finite(line);
            let (first, last) = (points.first()?, points.last()?);
            let [from, to] = [first.1, last.1].map(|value| significant(value, 3));
            Some(format!("{title}, {}: from {from} to {to}", line.name))
        })
    });
    let said: Vec<String> = said.collect();
    let words = Words::new(
        "joints-losses",
        "What the size of the joints costs",
        format!(
            "Two panels over the {size}: the mean speed over the mean speed of the ideal mechanism, and the \
             multiplier. {}.",
            said.join("; ")
        ),
        format!(
            "How the mean speed and the multiplier depend on the {size}. The mean speed is divided by the mean speed \
             of the ideal mechanism. Shown: {shown}."
        ),
    );
    let rows = groups.into_iter().enumerate().flat_map(|(panel, lines)| {
        lines.iter().flat_map(move |line| {
            let points = finite(line).into_iter();
            points.map(move |(x, y)| [(panel + 1) as f64, (number(line) + 1) as f64, x, y])
        })
    });
    let series = Series::new([("panel", "1"), ("line", "1"), ("size", "1"), ("value", "1")], rows);
    Chart::new(panels).figure(words, series)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn, assert_sound};

    fn lines(count: usize, points: i32, value: fn(f64) -> f64) -> Vec<Line> {
        let point = |k: i32| (f64::from(k) / f64::from(points), value(f64::from(k) / f64::from(points)));
        (0..count).map(|n| Line { name: format!("joint {n}"), points: (0..=points).map(point).collect() }).collect()
    }

    #[test]
    fn every_line_is_drawn_where_its_points_are() {
        for (count, points) in [(1, 4), (3, 12), (5, 40)] {
            let (speeds, multipliers) = (lines(count, points, |x| 1.0 - 0.5 * x), lines(count, points, |x| 0.1 + x));
            let figure = of_lines("radius of the pin over the crank", "an example", &speeds, &multipliers);
            assert_sound(&figure);
            let drawing = ParsedDrawing::parse(&figure);
            assert_eq!(drawing.count("loss"), 2 * count);
            // Straight lines are left with two points, falling and rising.
            for k in 0..2 * count {
                let points = drawing.path("loss", k);
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
            let figure = of_lines("size", "nothing", &some, &some);
            assert_drawn(&figure);
        }
    }
}
