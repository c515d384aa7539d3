//! Terminal speed over the torque, for several frictions.

use super::{MechanismRuns, PrintedRun};
use crate::chart::{Chart, ChartAxis, LegendEntry, Panel, of_mechanism};
use crate::number::{count_word, degrees, extent, format_fixed, significant};
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::steady::Engagement;

/// Steps of a curve.
const STEPS: u32 = 24;
const DASHES: &str = "9 5";

/// One friction's curves: the mean of the extremes at a torque of one and an inertia of the follower of one.
struct Family {
    friction: f64,
    as_run: f64,
    as_is: Option<f64>,
}

fn mean_of_extremes(engagement: &Engagement) -> Result<f64, FigureError> {
    Ok(engagement.steady_state()?.mean_of_extremes() / engagement.parameters().drive().sqrt())
}

/// Mean of peak and minimum over the torque, a panel for each friction.
///
/// An unbroken curve of what the runs' own reset angle gives, and a dashed one of the mechanism's reset angle if that is
/// another; the runs of the table are marks. Meyer 1973, the lower plots of Figs. 9 to 11, which are lost. Series, a row
/// for each run: friction, torque, then the mean as given, with the runs' reset angle, and with the mechanism's.
///
/// # Errors
///
/// [`FigureError`] if a friction is too great for the mechanism, or zero, or if there is no run.
pub fn over_torque(group: &MechanismRuns) -> Result<Figure, FigureError> {
    let [least, greatest] = group.range(|run| run.torque);
    let mut families = Vec::new();
    for friction in group.frictions() {
        let of = |reset: f64| mean_of_extremes(&group.engagement(friction, least, reset)?);
        families.push(Family { friction, as_run: of(group.reset)?, as_is: group.own_reset().map(of).transpose()? });
    }
    if families.is_empty() {
        return Err(FigureError::Nothing);
    }
    let room = room(least, greatest);
    let x = ChartAxis::spanning(least - room, greatest + room, 3.0);
    let unit = ((greatest + room) / group.inertias.follower()).sqrt();
    let ends = families.iter().flat_map(|one| [Some(one.as_run), one.as_is]).flatten().map(|scaled| scaled * unit);
    let y = ChartAxis::from_zero(0.0, group.runs.iter().map(mean).chain(ends).fold(0.0, f64::max), 3.0);
    let panels: Vec<Panel> = (1..).zip(&families).map(|(number, one)| panel(group, one, number, &x, &y)).collect();
    let (stroke, marker) = of_mechanism(group.mechanism.slots());
    let as_run = stroke.wide(2.4).undashed();
    let mut key = vec![LegendEntry::marks([marker], Label::words("printed"))];
    match group.own_reset() {
        Some(own) => key.extend([
            LegendEntry::curve(as_run, Label::words(&format!("as run, reset after {}", degrees(group.reset)))),
            LegendEntry::curve(as_run.dashed(DASHES), Label::words(&format!("mechanism, after {}", degrees(own)))),
        ]),
        None => key.push(LegendEntry::curve(as_run, Label::words("computed"))),
    }
    let means = all_means(group, &families);
    let words = words(group, families.len(), &means);
    Ok(Chart::new(panels).in_columns(COLUMNS).key(key).figure(words, series(&means)))
}

/// A unit of the tables' speeds, in rad/s.
const UNIT: f64 = 1.0;

/// Panels in a row.
const COLUMNS: usize = 2;

/// How far curves go beyond the least and the greatest torque.
fn room(least: f64, greatest: f64) -> f64 {
    0.04 * (greatest - least).max(1e-3 * greatest)
}

/// The curves of a friction, and its runs.
fn panel(group: &MechanismRuns, family: &Family, number: usize, x: &ChartAxis, y: &ChartAxis) -> Panel {
    let speed = |scaled: f64, torque: f64| scaled * (torque / group.inertias.follower()).sqrt();
    let frictions = group.frictions().len();
    let last = number + COLUMNS > frictions;
    let x = if last { x.clone().titled(Label::words("torque ").and_symbol("K").and(" in in·lb")) } else { x.clone() };
    let title = Label::symbol("μ").and(&format!(" = {}: speed in rad/s", format_fixed(family.friction, 2)));
    let [least, greatest] = group.range(|run| run.torque);
    let room = room(least, greatest);
    let (from, to) = (least - room, greatest + room);
    let torques = (0..=STEPS).map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS));
    let torques: Vec<f64> = torques.filter(|torque| *torque > 0.0).collect();
    let (stroke, marker) = of_mechanism(group.mechanism.slots());
    let curves = [
        (Some(family.as_run), stroke.wide(2.4).undashed().class("as-run")),
        (family.as_is, stroke.wide(2.4).dashed(DASHES).class("as-is")),
    ];
    let mut panel = Panel::new(190.0, &x, &y.clone().titled(title));
    for (scaled, stroke) in curves {
        let Some(scaled) = scaled else { continue };
        panel = panel.curve(torques.iter().map(|torque| (*torque, speed(scaled, *torque))), stroke);
    }
    let own = group.runs.iter().filter(|run| run.friction == family.friction);
    panel.marks(own.map(|run| (run.torque, mean(run))), marker)
}

/// Meyer 1973, chapter II: the average terminal velocity.
fn mean(run: &PrintedRun) -> f64 {
    f64::midpoint(run.peak, run.minimum)
}

/// Means of a run: as printed, with the runs' reset angle, and with the mechanism's.
struct Means<'a> {
    run: &'a PrintedRun,
    printed: f64,
    as_run: f64,
    as_is: f64,
}

fn all_means<'a>(group: &'a MechanismRuns, families: &[Family]) -> Vec<Means<'a>> {
    let means = |run: &'a PrintedRun| {
        let family = families.iter().find(|family| family.friction == run.friction)?;
        let unit = (run.torque / group.inertias.follower()).sqrt();
        let as_is = family.as_is.unwrap_or(family.as_run);
        Some(Means { run, printed: mean(run), as_run: family.as_run * unit, as_is: as_is * unit })
    };
    group.runs.iter().filter_map(means).collect()
}

fn series(means: &[Means<'_>]) -> Series {
    Series::of_items(
        means,
        [
            ("mu", "1", |means| means.run.friction),
            ("K", "in lb", |means| means.run.torque),
            ("mean printed", "rad/s", |means| means.printed),
            ("as run", "rad/s", |means| means.as_run),
            ("as is", "rad/s", |means| means.as_is),
        ],
    )
}

fn words(group: &MechanismRuns, frictions: usize, means: &[Means<'_>]) -> Words {
    let pins = group.mechanism.pins();
    let name = count_word(pins);
    let spread = |under: fn(&Means<'_>) -> f64| {
        let quotients = || means.iter().map(|run| run.printed / under(run));
        extent(quotients()).map(|of| significant(of, 3))
    };
    let [low, high] = spread(|means| means.as_run);
    let as_is = if group.own_reset().is_some() {
        let [low, high] = spread(|means| means.as_is);
        format!(" They are {low} to {high} times the right values, which are dashed.")
    } else {
        String::new()
    };
    let inertias = format!(
        "{pins} pins; the driver's inertia is {} · 10⁻⁶ in lb s², and the follower's is {} · 10⁻⁶ in lb s².",
        format_fixed(1e6 * group.inertias.driver(), 0),
        format_fixed(1e6 * group.inertias.follower(), 0)
    );
    let says = match group.own_reset() {
        Some(_) => format!(
            "The printed values (marks) are on the solid line, for which the driver's angle is reset after {}, and not \
             on the dashed line, which is for the mechanism itself.",
            degrees(group.reset)
        ),
        None => {
            let beside = means.iter().filter(|run| (run.printed - run.as_is).abs() > UNIT).count();
            let but = if beside == 0 { String::new() } else { format!(", except for {beside} of them") };
            format!(
                "Here the reset is right, so the printed values (marks) are on the mechanism's own line, to within 1 \
                 rad/s{but}."
            )
        }
    };
    Words::new(
        format!("runs-{name}-pin"),
        format!("Average terminal speed over the torque, {name} pins"),
        format!(
            "A panel for each of {frictions} frictions, over the torque K: the mean of peak and minimum, as printed and as \
             computed. The printed points lie on the rising curve of the runs, from {low} to {high} times its \
             value.{as_is}"
        ),
        format!(
            "{inertias} The speed is the mean of peak and minimum, which the thesis calls average terminal \
                 velocity. {says}"
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound, columns};
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;
    use std::f64::consts::FRAC_PI_2;

    fn group(mechanism: Mechanism, runs: Vec<PrintedRun>) -> MechanismRuns {
        MechanismRuns { mechanism, inertias: Inertias::new(1.0, 2.0).expect("sound"), reset: FRAC_PI_2, runs }
    }

    fn run(friction: f64, torque: f64) -> PrintedRun {
        PrintedRun { friction, torque, peak: 1.5, minimum: 0.5, rise: 5.0, period: 1.0 }
    }

    #[test]
    fn speeds_go_with_the_root_of_the_torque() {
        let runs: Vec<PrintedRun> =
            [0.25, 0.5].into_iter().flat_map(|mu| [1.0, 4.0].map(|torque| run(mu, torque))).collect();
        for mechanism in Mechanism::ALL {
            let figure = over_torque(&group(mechanism, runs.clone())).expect("drawn");
            assert_sound(&figure);
            for pair in columns(&figure.series, ["mu", "K", "as run", "as is"]).chunks(2) {
                let ([_, _, slow_as_run, slow_as_is], [friction, torque, as_run, as_is]) = (pair[0], pair[1]);
                approx::assert_relative_eq!(as_run, 2.0 * slow_as_run, max_relative = 1e-12);
                approx::assert_relative_eq!(as_is, 2.0 * slow_as_is, max_relative = 1e-12);
                // Each number by the engagement itself, at the run's own torque.
                let own = group(mechanism, vec![]).engagement(friction, torque, FRAC_PI_2).expect("sound");
                let steady = own.steady_state().expect("steady");
                approx::assert_relative_eq!(as_run, steady.mean_of_extremes(), max_relative = 1e-9);
            }
            let drawing = ParsedDrawing::parse(&figure);
            let curves = ["as-run", "as-is"].map(|class| drawing.count(class));
            assert_eq!(curves, if mechanism == Mechanism::FOUR_PIN { [2, 0] } else { [2, 2] });
        }
    }

    #[test]
    fn what_has_no_steady_motion_is_an_error() {
        assert_eq!(over_torque(&group(Mechanism::FOUR_PIN, vec![])), Err(FigureError::Nothing));
        for friction in [0.0, 90.0, f64::NAN] {
            assert!(over_torque(&group(Mechanism::FOUR_PIN, vec![run(friction, 1.0)])).is_err(), "{friction}");
        }
    }
}
