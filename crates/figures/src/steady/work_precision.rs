//! How much work a solver needs for how small an error.

use crate::chart::{Chart, ChartAxis, Panel, kind};
use crate::number::{significant, with_hyphens};
use crate::svg::Label;
use crate::{Figure, Series, Words};
use std::f64::consts::PI;

/// At most so many marks of an axis.
const MARKS: usize = 7;
/// Digits after the point of the numbers of the series.
const DECIMALS: usize = 18;

/// One run of one solver.
#[derive(Clone, Debug, PartialEq)]
pub struct SolverMeasurement {
    /// The solver, in a few words.
    pub contestant: String,
    /// The error that it was asked for.
    pub tolerance: f64,
    /// Evaluations of the right-hand side; none for a solver that does not step along it.
    pub evaluations: Option<u64>,
    /// Time that it took.
    pub milliseconds: f64,
    /// Its error against the known solution, relative.
    pub true_error: f64,
}

impl SolverMeasurement {
    /// Error, evaluations and milliseconds, if they can stand on a logarithmic axis; not a number for evaluations that
    /// are not counted.
    fn point(&self) -> Option<[f64; 3]> {
        let stands = |value: f64| value.is_finite() && value > 0.0;
        let evaluations = self.evaluations.map(|count| count as f64);
        let all = stands(self.true_error) && stands(self.milliseconds) && evaluations.is_none_or(stands);
        all.then_some([self.true_error, evaluations.unwrap_or(f64::NAN), self.milliseconds])
    }
}

/// True error over evaluations, and over milliseconds, on logarithmic axes, for each contestant a curve through its
/// measurements in the order given.
///
/// Measurements without an error or time above zero are left out, and those without evaluations in the first panel.
/// Series: number of the contestant in order of first appearance, tolerance, evaluations or zero, milliseconds, true
/// error.
pub fn work_precision(measurements: &[SolverMeasurement]) -> Figure {
    let mut names: Vec<&str> = Vec::new();
    for one in measurements.iter().filter(|one| one.point().is_some()) {
        if !names.contains(&one.contestant.as_str()) {
            names.push(&one.contestant);
        }
    }
    let of = |name: &str| {
        measurements.iter().filter(|one| one.contestant == name).filter_map(SolverMeasurement::point).collect()
    };
    let families: Vec<Vec<[f64; 3]>> = names.iter().map(|name| of(name)).collect();
    let axis = |column: usize| {
        let values = || families.iter().flatten().map(|point| point[column]).filter(|value| value.is_finite());
        let (least, greatest) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
        let (least, greatest) = if least <= greatest { (least, greatest) } else { (1.0, 10.0) };
        let each = (libm::log10(greatest / least) as usize + 2) / MARKS + 1;
        ChartAxis::decades(least, greatest, each)
    };
    let works = ["evaluations of the right-hand side, all runs together", "time of all runs together, in milliseconds"];
    let panels = [0, 1].map(|k| {
        let work = Label::words(&with_hyphens(works[k]));
        let error = Label::words("largest relative error");
        let panel = Panel::new(290.0, &axis(k + 1).titled(work), &axis(0).titled(error));
        let panel = families.iter().enumerate().fold(panel, |panel, (number, points)| {
            let points = points.iter().map(|point| (point[k + 1], point[0])).filter(|(work, _)| work.is_finite());
            let (stroke, marker) = kind(number);
            panel.curve(points.clone(), stroke.wide(1.8).class("contestant")).marks(points, marker)
        });
        // Named at their ends, once: the looks are the same in both panels.
        let first = |number: usize| (0..=k).find(|k| families[number].iter().any(|point| point[k + 1].is_finite()));
        names.iter().enumerate().filter(|(number, _)| first(*number) == Some(k)).fold(panel, |panel, (number, name)| {
            let points = || families[number].iter().map(|point| (point[k + 1], point[0]));
            let ends = points().take(1).chain(points().next_back());
            panel.name_near(
                ends,
                if number % 2 == 0 { PI } else { 0.0 },
                Label::words(&with_hyphens(name)).in_colour(kind(number).0.colour),
            )
        })
    });
    let best = names.iter().zip(&families).filter_map(|(name, points)| {
        let point = points.iter().min_by(|a, b| a[0].total_cmp(&b[0]))?;
        let [error, work, time] = [0, 1, 2].map(|k| significant(point[k], 2));
        // So small an error is written with its power of ten.
        let error = if point[0] < 1e-3 { format!("{:.0e}", point[0]) } else { error };
        let with = if point[1].is_finite() { format!(" with {work} evaluations") } else { String::new() };
        Some(format!("{name}: {error}{with} in {time} ms"))
    });
    let best: Vec<String> = best.collect();
    let rows = measurements.iter().filter(|one| one.point().is_some()).map(|one| {
        let number = names.iter().position(|name| *name == one.contestant).map_or(0, |at| at + 1);
        [number as f64, one.tolerance, one.evaluations.unwrap_or(0) as f64, one.milliseconds, one.true_error]
    });
    let columns = [("contestant", "1"), ("tolerance", "1"), ("evaluations", "1"), ("time", "ms"), ("error", "1")];
    let words = Words::new(
        "solver-work-precision",
        "Work and precision of the solvers",
        format!(
            "Two panels on logarithmic axes: the true error over the evaluations, and over the time. Down and to the \
             left is better. The smallest errors: {}.",
            best.join("; ")
        ),
        "The largest relative error in the speeds of all runs of all three mechanisms, plotted against the work done. \
         A lower curve means less work for the same error. On a steeper curve, extra work reduces the error more.",
    );
    Chart::new(panels).figure(words, Series::new(columns, rows).to_decimals(DECIMALS))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn, assert_sound, corners};

    /// Solvers of orders 2, 4 and 8, whose errors fall as they must.
    fn made_up(count: usize) -> Vec<SolverMeasurement> {
        let solver = |number: usize| {
            let order = [2.0, 4.0, 8.0][number % 3];
            (1..=6).map(move |k| {
                let steps = libm::exp2(f64::from(k) * 6.0 / order) * 8.0;
                SolverMeasurement {
                    contestant: format!("solver {number}"),
                    tolerance: libm::exp2(-2.0 * f64::from(k)),
                    evaluations: Some((steps * order).round() as u64),
                    milliseconds: 0.001 * steps,
                    true_error: libm::pow(steps, -order),
                }
            })
        };
        (0..count).flat_map(solver).collect()
    }

    #[test]
    fn a_contestant_of_order_p_has_a_line_of_slope_p() {
        for count in [1, 3, 6] {
            let figure = work_precision(&made_up(count));
            assert_sound(&figure);
            assert_eq!(figure.series.rows.len(), 6 * count);
        }
        let figure = work_precision(&made_up(3));
        let drawing = ParsedDrawing::parse(&figure);
        assert_eq!(drawing.count("contestant"), 6);
        // Over the milliseconds, which go as the steps: slopes as the orders, in the same axes.
        let slope = |k: usize| {
            let points = drawing.path("contestant", 3 + k);
            let along = points[points.len() - 1] - points[0];
            along.y / along.x
        };
        assert!((slope(1) / slope(0) - 2.0).abs() < 0.02, "{} {}", slope(1), slope(0));
        assert!((slope(2) / slope(0) - 4.0).abs() < 0.05);
        // Each panel has its own values, on an axis between whole powers of ten.
        for (panel, column) in [(0, 2), (1, 3)] {
            let logs = |row: &Vec<f64>| libm::log10(row[column]);
            let all = || figure.series.rows.iter().map(logs);
            let low = all().fold(f64::INFINITY, f64::min).floor();
            let high = all().fold(f64::NEG_INFINITY, f64::max).ceil();
            // The left axis comes first, the right one is the farthest to the right.
            let axes = drawing.elements("axes")[panel].attribute("d").expect("a path");
            let ends = axes.split('M').skip(1).map(|line| corners(line, 1.0)[0].x);
            let (left, right) = (ends.clone().next().expect("an axis"), ends.fold(0.0, f64::max));
            let curve = drawing.path("contestant", 3 * panel);
            let expected = left + (right - left) * (logs(&figure.series.rows[0]) - low) / (high - low);
            assert!((curve[0].x - expected).abs() < 0.2, "{} for {expected}", curve[0].x);
        }
    }

    #[test]
    fn what_cannot_stand_on_a_logarithmic_axis_is_left_out() {
        let mut some = made_up(2);
        some[0].true_error = 0.0;
        some[3].milliseconds = f64::NAN;
        some[7].evaluations = Some(0);
        assert_eq!(work_precision(&some).series.rows.len(), 9);
        for few in [&some[..0], &some[1..2]] {
            assert_drawn(&work_precision(few));
        }
    }
}
