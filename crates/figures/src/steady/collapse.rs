//! All runs of a mechanism on one curve: peak, minimum and period without the torque and the size of the inertias.

use super::error::MotionError;
use crate::escapement::axes::{spanning, upright};
use crate::figure::{Figure, Words};
use crate::markers::{marks, of_mechanism};
use crate::number::significant;
use crate::panel::{Panel, Stroke, WIDTH};
use crate::runs::{Group, Run};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use geneva_dynamics::steady::SteadyState;
use nalgebra::Vector2;

const KEY: f64 = 28.0;
const HEIGHTS: [u32; 3] = [314, 314, 344];
/// Steps of a curve.
const STEPS: u32 = 32;
const SIZE: f64 = 8.0;
/// Of the runs that were put back at another angle than the mechanism's own.
const DASHES: &str = "5 5";

/// Peak and minimum over √(K / I_f), and period times the same.
fn scaled(steady: &SteadyState, unit: f64) -> [f64; 3] {
    [steady.peak.speed / unit, steady.minimum.speed / unit, steady.period * unit]
}

fn given(run: &Run, unit: f64) -> [f64; 3] {
    [run.peak / unit, run.minimum / unit, run.period * unit]
}

/// Peak, minimum and period of every run without scale, over the friction, with the curve of each mechanism.
///
/// Speeds are over √(K / I_f), the period is times that: by the law of similarity nothing but the friction is left in
/// the runs of one mechanism. Where the runs were put back at another angle than the mechanism's own, both curves are
/// drawn. Series, a row for each run: slots, friction, then peak, minimum and period as given, as computed for the run,
/// and as computed for the mechanism.
///
/// # Errors
///
/// [`MotionError`] if there is no run, or one without a steady motion.
pub fn collapse(groups: &[Group]) -> Result<Figure, MotionError> {
    let mut rows: Vec<[f64; 11]> = Vec::new();
    for group in groups {
        for run in &group.runs {
            let unit = (run.torque / group.inertias.follower()).sqrt();
            let steady = group.engagement(run.friction, run.torque, group.fold)?.steady_state()?;
            let own = match group.own_fold() {
                Some(fold) => group.engagement(run.friction, run.torque, fold)?.steady_state()?,
                None => steady,
            };
            let ([a, b, c], [d, e, f], [g, h, i]) = (given(run, unit), scaled(&steady, unit), scaled(&own, unit));
            rows.push([f64::from(group.mechanism.slots()), run.friction, a, b, c, d, e, f, g, h, i]);
        }
    }
    let frictions = || rows.iter().map(|row| row[1]);
    let (least, most) = (frictions().fold(f64::INFINITY, f64::min), frictions().fold(0.0, f64::max));
    if rows.is_empty() {
        return Err(MotionError::Nothing);
    }
    let room = 0.06 * (most - least).max(0.1 * most);
    let level = spanning((least - room).max(0.5 * least), most + room, 4.0);
    let range = (least - room).max(0.5 * least)..most + room;
    let level = crate::plot::Axis {
        marks: level.marks.iter().copied().filter(|mark| range.contains(mark)).collect(),
        range: range.clone(),
        ..level
    };
    let drawn = |fold: Option<f64>, group: &Group| -> Result<_, MotionError> {
        fold.map(|fold| curve(group, fold, [range.start, range.end])).transpose()
    };
    let own = |group: &Group| drawn(Some(group.own_fold().unwrap_or(group.fold)), group);
    let as_run = |group: &Group| drawn(group.own_fold().map(|_| group.fold), group);
    let curves = groups.iter().map(|of| Ok([own(of)?, as_run(of)?])).collect::<Result<Vec<_>, MotionError>>()?;
    let (corners, height) = Panel::stack(KEY, HEIGHTS);
    let mut canvas = Canvas::new(f64::from(WIDTH), height);
    for (k, (corner, height)) in corners.into_iter().zip(HEIGHTS).enumerate() {
        let values = rows.iter().flat_map(|row| [row[2 + k], row[5 + k]]);
        let values = values.chain(curves.iter().flatten().flatten().flatten().map(|(_, values)| values[k]));
        let panel = Panel::new(corner, height, level.clone(), upright(0.0, values.fold(0.0, f64::max), 4.0));
        panel.draw(&mut canvas, k == 2);
        let mut ends = Vec::new();
        for (group, both) in groups.iter().zip(&curves) {
            let (shade, mark) = of_mechanism(group.mechanism.slots());
            let mut line = Vec::new();
            for (points, (width, dashes)) in both.iter().rev().zip([(1.6, Some(DASHES)), (2.2, None)]) {
                let Some(points) = points else { continue };
                line = points.iter().map(|(friction, values)| (*friction, values[k])).collect();
                panel.curve(&mut canvas, &line, Stroke { shade, width, dashes, class: "curve" });
            }
            let own = rows.iter().filter(|row| row[0] == f64::from(group.mechanism.slots()));
            let own: Vec<_> = own.map(|row| (row[1], row[2 + k])).collect();
            panel.marks(&mut canvas, &own, (shade, mark), SIZE);
            if let Some((_, value)) = line.last() {
                ends.push((*value, Label::words(&format!("{}", group.mechanism.pins())), shade));
            }
        }
        panel.beside(&mut canvas, ends);
        let unit = |label: Label| label.and_symbol("K").and("/").and_symbol("I").sub("f").and(")");
        panel.name(
            &mut canvas,
            &match k {
                0 => unit(Label::words("peak over √(")),
                1 => unit(Label::words("minimum over √(")),
                _ => unit(Label::words("period times √(")),
            },
        );
        if k == 2 {
            panel.foot(&mut canvas, &Label::words("friction ").and_symbol("μ"));
        }
    }
    for (k, group) in groups.iter().enumerate() {
        let (at, style) = (Vector2::new(24.0 + 160.0 * k as f64, 18.0), of_mechanism(group.mechanism.slots()));
        marks(&mut canvas, &[at], style, 10.0);
        let label = Label::words(&format!("{} pins", group.mechanism.pins())).shade(style.0).bare();
        canvas.label(&at, &Vector2::new(1.0, 0.0), 12.0, &label);
    }
    let columns = [
        ("n", "1"),
        ("mu", "1"),
        ("peak printed", "1"),
        ("min printed", "1"),
        ("period printed", "1"),
        ("peak as run", "1"),
        ("min as run", "1"),
        ("period as run", "1"),
        ("peak", "1"),
        ("min", "1"),
        ("period", "1"),
    ];
    let worst = |k: usize| rows.iter().map(|row| (row[2 + k] / row[5 + k] - 1.0).abs()).fold(0.0, f64::max);
    let [peak, minimum, period] = [0, 1, 2].map(|k| significant(100.0 * worst(k), 2));
    let words = Words {
        id: "steady-collapse".to_owned(),
        title: "All runs without the torque: peak, minimum and period over the friction".to_owned(),
        description: format!(
            "Three panels over the friction μ: peak and minimum over the root of K / I_f, and period times that root. \
             In each an unbroken curve for every mechanism, and a broken one where the program put the driver back at \
             another angle. On the curves of what was run lie the {} runs of all torques, one over another. The farthest \
             from these are off by {peak} % for the peaks, {minimum} % for the minima and {period} % for the periods.",
            rows.len()
        ),
        caption:
            "The law of similarity: measured in the units that torque and inertias make, runs of all torques fall \
             together, and each mechanism has one curve (unbroken). The points are the printed rows. Those of six and three \
             pins lie on the broken curves, for a driver that is put back after 90° as the program does, and not on those of \
             the mechanisms. What is left is rounding and, in the peaks, the time between two printed lines."
                .to_owned(),
    };
    Ok(words.figure(canvas, Kind::Panels, Series::new(columns, rows)))
}

/// A mechanism's results without scale, over the friction, if the driver is put back after this angle.
fn curve(group: &Group, fold: f64, [from, to]: [f64; 2]) -> Result<Vec<(f64, [f64; 3])>, MotionError> {
    let point = |step: u32| {
        let friction = from + (to - from) * f64::from(step) / f64::from(STEPS);
        let torque = group.inertias.follower();
        Ok((friction, scaled(&group.engagement(friction, torque, fold)?.steady_state()?, 1.0)))
    };
    (0..=STEPS).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{labels_inside, named, only_numbers, overlapping_labels, well_formed};
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;
    use roxmltree::Document;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn runs_of_all_torques_fall_together() {
        let groups = Mechanism::ALL.map(|mechanism| {
            let inertias = Inertias::new(2.0, 5.0).expect("sound");
            let mut group = Group { mechanism, inertias, fold: FRAC_PI_2, runs: Vec::new() };
            for (friction, torque) in [(0.1, 3.0), (0.1, 12.0), (0.25, 3.0), (0.25, 0.7)] {
                let steady = group.engagement(friction, torque, FRAC_PI_2).expect("sound").steady_state();
                let steady = steady.expect("steady");
                let (peak, minimum) = (steady.peak.speed, steady.minimum.speed);
                group.runs.push(Run { friction, torque, peak, minimum, rise: 1.0, period: steady.period });
            }
            group
        });
        let figure = collapse(&groups).expect("drawn");
        well_formed(&figure);
        only_numbers(&figure);
        labels_inside(&figure);
        assert_eq!(overlapping_labels(&figure), []);
        for pair in figure.series.rows.chunks(2) {
            for (one, other) in pair[0].iter().zip(&pair[1]).skip(2) {
                approx::assert_relative_eq!(*one, *other, max_relative = 1e-9);
            }
        }
        let document = Document::parse(&figure.svg).expect("well-formed");
        // One for four slots, two for six and three, in three panels.
        assert_eq!(named(&document, "curve").len(), 15);
        assert_eq!(named(&document, "marks").len(), 12);
        assert_eq!(collapse(&[]), Err(MotionError::Nothing));
    }
}
