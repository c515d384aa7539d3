//! All runs of a mechanism on one curve: peak, minimum and period without the torque and the size of the inertias.

use crate::chart::{Chart, ChartAxis, LegendEntry, LineStyle, Panel, Spot, of_mechanism};
use crate::number::{extent, significant};
use crate::runs::{MechanismRuns, PrintedRun};
use crate::svg::Label;
use crate::theme::INK;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::steady::SteadyState;

/// Steps of a curve.
const STEPS: u32 = 32;
/// Of the runs that were reset at another angle than the mechanism's own.
const DASHES: &str = "5 5";
/// The panels: the beginning of their titles, and the heights of their frames.
const PANELS: [(&str, f64); 3] =
    [("peak speed over √(", 200.0), ("least speed over √(", 200.0), ("period times √(", 230.0)];

/// Peak and minimum over √(K / I_f), and period times the same.
fn scaled(steady: &SteadyState, unit: f64) -> [f64; 3] {
    [steady.peak.speed / unit, steady.minimum.speed / unit, steady.period * unit]
}

fn given(run: &PrintedRun, unit: f64) -> [f64; 3] {
    [run.peak / unit, run.minimum / unit, run.period * unit]
}

/// A run without scale: peak, minimum and period as given, as computed for the run, and as computed for the mechanism.
struct Scaled {
    slots: f64,
    friction: f64,
    printed: [f64; 3],
    as_run: [f64; 3],
    own: [f64; 3],
}

/// A curve over the friction, with all three results at each point.
type Results = Vec<(f64, [f64; 3])>;

/// Peak, minimum and period of every run without scale, over the friction, with the curve of each mechanism.
///
/// Speeds are over √(K / I_f), the period is times that: by the law of similarity nothing but the friction is left in
/// the runs of one mechanism. Where the runs were reset at another angle than the mechanism's own, both curves are
/// drawn. Series, a row for each run: slots, friction, then peak, minimum and period as given, as computed for the run,
/// and as computed for the mechanism.
///
/// # Errors
///
/// [`FigureError`] if there is no run, or one without a steady motion.
pub fn collapse(groups: &[MechanismRuns]) -> Result<Figure, FigureError> {
    let mut runs = Vec::new();
    for group in groups {
        for run in &group.runs {
            let unit = (run.torque / group.inertias.follower()).sqrt();
            let steady = group.engagement(run.friction, run.torque, group.reset)?.steady_state()?;
            let own = match group.own_reset() {
                Some(reset) => group.engagement(run.friction, run.torque, reset)?.steady_state()?,
                None => steady,
            };
            runs.push(Scaled {
                slots: f64::from(group.mechanism.slots()),
                friction: run.friction,
                printed: given(run, unit),
                as_run: scaled(&steady, unit),
                own: scaled(&own, unit),
            });
        }
    }
    let x = frictions(&runs)?;
    let curves = groups.iter().map(|group| both(group, &x)).collect::<Result<Vec<_>, FigureError>>()?;
    let panels = [0, 1, 2].map(|k| panel(groups, &runs, &curves, &x, k));
    let markers = groups.iter().map(|group| of_mechanism(group.mechanism.slots()).1);
    let printed = std::iter::once(LegendEntry::marks(markers, Label::words("printed")));
    let [own, as_run] = [LineStyle::new(INK).wide(2.2), LineStyle::new(INK).wide(1.6).dashed(DASHES)];
    let lines = [(own, "the mechanism"), (as_run, "the program as run")];
    let key = printed.chain(lines.map(|(stroke, name)| LegendEntry::curve(stroke, Label::words(name))));
    let series = Series::of_items(
        &runs,
        [
            ("slots", "1", |run| run.slots),
            ("mu", "1", |run| run.friction),
            ("peak printed", "1", |run| run.printed[0]),
            ("min printed", "1", |run| run.printed[1]),
            ("period printed", "1", |run| run.printed[2]),
            ("peak as run", "1", |run| run.as_run[0]),
            ("min as run", "1", |run| run.as_run[1]),
            ("period as run", "1", |run| run.as_run[2]),
            ("peak", "1", |run| run.own[0]),
            ("min", "1", |run| run.own[1]),
            ("period", "1", |run| run.own[2]),
        ],
    );
    let worst = |k: usize| runs.iter().map(|run| (run.printed[k] / run.as_run[k] - 1.0).abs()).fold(0.0, f64::max);
    let [peak, minimum, period] = [0, 1, 2].map(|k| significant(100.0 * worst(k), 2));
    let of_group = |group: &MechanismRuns| {
        format!("{} with {} pins", significant(group.inertias.ratio(), 2), group.mechanism.pins())
    };
    let inertias = groups.iter().map(of_group).collect::<Vec<_>>().join(", ");
    let words = Words::new(
        "steady-collapse",
        "All runs without the torque: peak, minimum and period over the friction",
        format!(
            "Three panels over the friction μ: peak and minimum over the root of K / I_f, and period times that root. \
             In each an unbroken curve for every mechanism, and a broken one where the program put the driver back at \
             another angle. The {} runs of all torques are on the curves of what was run, one over another. The \
             farthest differ from these curves by {peak} % in the peaks, {minimum} % in the minima and {period} % in \
             the periods.",
            runs.len()
        ),
        format!(
            "The law of similarity: torque and inertias set the scales of speed and time. Divided by these scales, the \
             printed peaks, minima and periods of all torques nearly coincide (marks). The solid curves are for the \
             mechanisms, the dashed curves for the program of 1973, which resets the driver's angle after 90°. Beside \
             each curve is its number of pins. For four pins the two curves are the same. The marks for six and three \
             pins are on the dashed curves, so these numbers come from the program and do not describe the mechanisms. \
             Driver's moment of inertia over the follower's: {inertias}."
        ),
    );
    Ok(Chart::new(panels).key(key).figure(words, series))
}

/// The axis of the frictions of all runs.
fn frictions(runs: &[Scaled]) -> Result<ChartAxis, FigureError> {
    let frictions = || runs.iter().map(|run| run.friction);
    let [least, most] = extent(frictions());
    if runs.is_empty() {
        return Err(FigureError::Nothing);
    }
    let room = 0.06 * (most - least).max(0.1 * most);
    let range = (least - room).max(0.5 * least)..most + room;
    let steps = ChartAxis::spanning(range.start, range.end, 4.0);
    Ok(ChartAxis { ticks: steps.ticks.iter().copied().filter(|mark| range.contains(mark)).collect(), range, ..steps })
}

/// The curve of the mechanism as it was run, if that is another than its own, and its own.
fn both(group: &MechanismRuns, x: &ChartAxis) -> Result<[Option<Results>; 2], FigureError> {
    let of = |reset: f64| curve(group, reset, [x.range.start, x.range.end]);
    let as_run = group.own_reset().map(|_| of(group.reset)).transpose()?;
    Ok([as_run, Some(of(group.own_reset().unwrap_or(group.reset))?)])
}

/// The panel of one of the three results.
fn panel(groups: &[MechanismRuns], runs: &[Scaled], curves: &[[Option<Results>; 2]], x: &ChartAxis, k: usize) -> Panel {
    let values = runs.iter().flat_map(|run| [run.printed[k], run.as_run[k]]);
    let values = values.chain(curves.iter().flatten().flatten().flatten().map(|(_, values)| values[k]));
    let (name, height) = PANELS[k];
    let title = Label::words(name).and_symbol("K").and("/").and_symbol("I").sub("f").and(")");
    let last = k + 1 == PANELS.len();
    let title_of_x = Label::words("coefficient of friction ").and_symbol("μ");
    let x = if last { x.clone().titled(title_of_x) } else { x.clone().unnumbered() };
    let mut panel = Panel::new(height, &x, &ChartAxis::from_zero(0.0, values.fold(0.0, f64::max), 4.0).titled(title));
    for (group, both) in groups.iter().zip(curves) {
        let (stroke, marker) = of_mechanism(group.mechanism.slots());
        let stroke = LineStyle { dashes: None, ..stroke };
        for (points, stroke) in both.iter().zip([stroke.wide(1.6).dashed(DASHES), stroke.wide(2.2)]) {
            panel = panel.curve(points.iter().flatten().map(|(friction, values)| (*friction, values[k])), stroke);
        }
        let own = runs.iter().filter(|run| run.slots == f64::from(group.mechanism.slots()));
        panel = panel.marks(own.map(|run| (run.friction, run.printed[k])), marker.sized(8.0));
        if let Some((_, values)) = both[1].as_ref().and_then(|points| points.last()) {
            let label = Label::words(&group.mechanism.pins().to_string()).in_colour(marker.colour);
            panel = panel.name(label, Spot::Beside(values[k]));
        }
    }
    panel
}

/// A mechanism's results without scale, over the friction, if the driver's angle is reset after this angle.
fn curve(group: &MechanismRuns, reset: f64, [from, to]: [f64; 2]) -> Result<Vec<(f64, [f64; 3])>, FigureError> {
    let point = |step: u32| {
        let friction = from + (to - from) * f64::from(step) / f64::from(STEPS);
        let torque = group.inertias.follower();
        Ok((friction, scaled(&group.engagement(friction, torque, reset)?.steady_state()?, 1.0)))
    };
    (0..=STEPS).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound};
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn runs_of_all_torques_fall_together() {
        let groups = Mechanism::ALL.map(|mechanism| {
            let inertias = Inertias::new(2.0, 5.0).expect("sound");
            let mut group = MechanismRuns { mechanism, inertias, reset: FRAC_PI_2, runs: Vec::new() };
            for (friction, torque) in [(0.1, 3.0), (0.1, 12.0), (0.25, 3.0), (0.25, 0.7)] {
                let steady = group.engagement(friction, torque, FRAC_PI_2).expect("sound").steady_state();
                let steady = steady.expect("steady");
                let (peak, minimum) = (steady.peak.speed, steady.minimum.speed);
                group.runs.push(PrintedRun { friction, torque, peak, minimum, rise: 1.0, period: steady.period });
            }
            group
        });
        let figure = collapse(&groups).expect("drawn");
        assert_sound(&figure);
        for pair in figure.series.rows.chunks(2) {
            for (one, other) in pair[0].iter().zip(&pair[1]).skip(2) {
                approx::assert_relative_eq!(*one, *other, max_relative = 1e-9);
            }
        }
        let drawing = ParsedDrawing::parse(&figure);
        // One for four slots, two for six and three, in three panels.
        assert_eq!(drawing.count("curve"), 15);
        assert_eq!(drawing.count("marks"), 9);
        assert_eq!(collapse(&[]), Err(FigureError::Nothing));
    }
}
