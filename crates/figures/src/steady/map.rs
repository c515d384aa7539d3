//! Terminal speed and rise over friction and ratio of the inertias.

use super::contours::ContourGrid;
use crate::chart::{Chart, ChartAxis, LineStyle, Panel, Spot, of_mechanism};
use crate::escapement::MarkedEscapement;
use crate::number::{count_word, format_trimmed, significant};
use crate::svg::Label;
use crate::theme::{DRIVER, FILL, FOLLOWER, INK};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::existence::critical_inertia_ratio;
use geneva_dynamics::steady::{Engagement, SteadyState};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// What is shown of μ and of I_D / I_f at least.
const FRICTIONS: Range<f64> = 0.0..0.6;
const INERTIAS: Range<f64> = 0.01..5.0;
/// Columns and rows of the grid; how far above the critical ratio of the inertias it begins.
const COLUMNS: u32 = 56;
const ROWS: u32 = 56;
const CLEAR: f64 = 1.002;
/// Relative error of what is computed for it.
const TOLERANCE: f64 = 1e-8;
/// The part of a difference that is left when the motion has risen.
const LEFT: f64 = 0.01;
/// Values that may have a line, and every how many points of a line is a row of the series.
const LEVELS: [f64; 21] =
    [0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0, 15.0, 20.0, 50.0, 100.0];
/// Lines nearer to the last one, as a quotient of their values, are left out of the panels.
const APART: [f64; 2] = [1.19, 1.45];
/// Nor is there a line of a lesser value, where they crowd before the boundary, or that does not reach so far.
const LEAST: [f64; 2] = [0.0, 0.5];
const NARROW: f64 = 0.02;
const KEPT: usize = 6;
/// The lines of both panels, and beside the name of the y axis what they are.
const LINES: [LineStyle; 2] =
    [LineStyle::new(DRIVER).wide(1.8).class("equal"), LineStyle::new(FOLLOWER).wide(1.8).dashed("8 4").class("equal")];
const NAMES: [&str; 2] = ["with lines of equal mean speed", "with lines of equal rise, in engagements"];

/// A value of the steady motion at a torque and an inertia of the follower of one.
type Value = fn(&SteadyState) -> f64;

/// Mean speed, and engagements from rest until a difference of speeds has shrunk to a hundredth.
const VALUES: [Value; 2] = [|steady| steady.mean_speed, |steady| libm::log(LEFT) / libm::log(steady.multiplier)];

/// A line of equal value: its number and its points.
type Line = (f64, Vec<(f64, f64)>);

/// Lines of equal mean terminal speed, in √(K / I_f), and of equal rise, over μ and I_D / I_f.
///
/// A dotted line leads through the ratios of the inertias at which the mean speed is greatest for each friction. The
/// rise is counted in engagements: ln 100 over −ln of the multiplier. On the tinted ground there are angles at which
/// the equation of motion has none or two solutions. Designs of other mechanisms are left out. Series, for every sixth
/// point of each line: which panel, the value, μ, I_D / I_f.
///
/// # Errors
///
/// [`FigureError`] if a design cannot be shown.
pub fn map(mechanism: Mechanism, designs: &[MarkedEscapement]) -> Result<Figure, FigureError> {
    map_within(TOLERANCE, mechanism, designs)
}

/// The map, from steady motions to this relative tolerance.
fn map_within(tolerance: f64, mechanism: Mechanism, designs: &[MarkedEscapement]) -> Result<Figure, FigureError> {
    let own: Vec<&MarkedEscapement> = designs.iter().filter(|design| design.mechanism == mechanism).collect();
    for design in &own {
        shown("I_D / I_f", design.inertia_ratio, INERTIAS)?;
        shown("the friction", design.friction, FRICTIONS)?;
    }
    let grids = grids(tolerance, mechanism)?;
    let lines = [0, 1].map(|k| lines(&grids[k], k));
    let panels = [0, 1].map(|k| panel(mechanism, &own, &grids[k], &lines[k], k));
    let rows = lines.iter().enumerate().flat_map(|(k, lines)| {
        lines.iter().flat_map(move |(value, points)| {
            let kept = points.iter().step_by(KEPT);
            kept.map(move |(friction, inertia)| [(k + 1) as f64, *value, *friction, *inertia])
        })
    });
    let series = Series::new([("panel", "1"), ("value", "1"), ("mu", "1"), ("I_D/I_f", "1")], rows);
    let counts = [0, 1].map(|k| {
        let mut values: Vec<f64> = lines[k].iter().map(|(value, _)| *value).collect();
        values.dedup();
        values.len()
    });
    Ok(Chart::new(panels).figure(words(mechanism, &own, counts, &grids[0].ridge()), series))
}

fn shown(name: &'static str, value: f64, range: Range<f64>) -> Result<(), FigureError> {
    let off = FigureError::OffTheMap { name, value, least: range.start, greatest: range.end };
    if range.contains(&value) { Ok(()) } else { Err(off) }
}

/// The lines of a panel that are not too close to one another.
fn lines(grid: &ContourGrid, panel: usize) -> Vec<Line> {
    let mut last: Option<f64> = None;
    let mut shown = Vec::new();
    for value in LEVELS {
        let lines = grid.lines(libm::log(value));
        let reach = lines.iter().flatten().map(|(friction, _)| *friction).fold(0.0, f64::max);
        if last.is_none_or(|last| value >= APART[panel] * last) && value >= LEAST[panel] && reach >= NARROW {
            last = Some(value);
            shown.extend(lines.iter().map(|line| (value, raised(line))));
        }
    }
    shown
}

/// Points with the ratio of the inertias in place of its logarithm.
fn raised(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    points.iter().map(|(friction, log)| (*friction, libm::exp(*log))).collect()
}

fn panel(mechanism: Mechanism, own: &[&MarkedEscapement], grid: &ContourGrid, lines: &[Line], k: usize) -> Panel {
    let marks = (0..=6).map(|k| FRICTIONS.end * f64::from(k) / 6.0);
    let x = ChartAxis { decimals: 1, ..ChartAxis::whole(FRICTIONS, marks) };
    let x = if k == 1 { x.titled(Label::words("coefficient of friction ").and_symbol("μ")) } else { x };
    let title = Label::symbol("I").sub("D").and(" / ").and_symbol("I").sub("f").and(&format!(", {}", NAMES[k]));
    let boundary = critical(mechanism);
    let ground = boundary.iter().copied().chain([(FRICTIONS.end, INERTIAS.start)]);
    // As far as it is above the foot of the panel.
    let above = boundary.iter().copied().filter(|(_, inertia)| *inertia > INERTIAS.start);
    let mut panel = Panel::new(330.0, &x, &ChartAxis::logarithmic(INERTIAS).titled(title))
        .area(ground, FILL, "unsound")
        .curve(above, LineStyle::new(INK).wide(2.4).class("boundary"));
    for (_, points) in lines {
        panel = panel.curve(points.iter().copied(), LINES[k]);
    }
    if k == 0 {
        let ridge = raised(&grid.ridge());
        let late = ridge.iter().rev().take(ridge.len() / 2).copied();
        panel = panel.name_near(late, FRAC_PI_2, Label::words("fastest"));
        panel = panel.curve(ridge, LineStyle::new(INK).wide(2.2).dashed("2 5").class("ridge"));
    }
    for design in own {
        panel = panel.marks([(design.friction, design.inertia_ratio)], of_mechanism(mechanism.slots()).1.sized(10.0));
    }
    let corner = [0.05, 0.09, 0.13].map(|y| [0.79, y]).to_vec();
    panel = panel.name(Label::words("no single solution").bare(), Spot::Free(corner));
    for (value, points) in lines {
        panel =
            panel.name(Label::words(&format_trimmed(*value, 2)).in_colour(LINES[k].colour), Spot::On(points.clone()));
    }
    panel
}

/// The steady motion of a design with a torque and an inertia of the follower of one.
fn steady(tolerance: f64, mechanism: Mechanism, inertia: f64, friction: f64) -> Option<SteadyState> {
    let parameters = Parameters::new(mechanism, Inertias::new(inertia, 1.0).ok()?, 1.0, friction).ok()?;
    Engagement::with_tolerance(&parameters, tolerance).ok()?.steady_state().ok()
}

/// Logarithms of both values over μ and the logarithm of I_D / I_f: each column begins where there is one solution.
fn grids(tolerance: f64, mechanism: Mechanism) -> Result<[ContourGrid; 2], FigureError> {
    let (mut columns, mut heights) = (Vec::new(), Vec::new());
    let mut values = [Vec::new(), Vec::new()];
    // Without friction there is no steady motion: the first column has little, and the next ones are close.
    for column in 0..=COLUMNS {
        let share = (f64::from(column) + 3.0) / (f64::from(COLUMNS) + 3.0);
        let friction = FRICTIONS.end * share * share;
        let low = libm::log((CLEAR * critical_inertia_ratio(mechanism, friction)?).max(INERTIAS.start));
        let height = |row: u32| low + (libm::log(INERTIAS.end) - low) * f64::from(row) / f64::from(ROWS);
        let nodes: Vec<f64> = (0..=ROWS).map(height).collect();
        let states: Vec<_> = nodes.iter().map(|log| steady(tolerance, mechanism, libm::exp(*log), friction)).collect();
        for (values, value) in values.iter_mut().zip(VALUES) {
            let log =
                |steady: &Option<SteadyState>| steady.as_ref().map_or(f64::NAN, |steady| libm::log(value(steady)));
            values.push(states.iter().map(log).collect());
        }
        columns.push(friction);
        heights.push(nodes);
    }
    Ok(values.map(|values| ContourGrid { columns: columns.clone(), heights: heights.clone(), values }))
}

/// The critical ratio of the inertias over μ, within the panel.
fn critical(mechanism: Mechanism) -> Vec<(f64, f64)> {
    let at = |step: u32| {
        let friction = FRICTIONS.end * f64::from(step) / 90.0;
        (friction, critical_inertia_ratio(mechanism, friction).unwrap_or_default().clamp(INERTIAS.start, INERTIAS.end))
    };
    (0..=90).map(at).collect()
}

fn words(mechanism: Mechanism, own: &[&MarkedEscapement], shown: [usize; 2], ridge: &[(f64, f64)]) -> Words {
    let [least, greatest] = [f64::min, f64::max].map(|pick| {
        let ratios = ridge.iter().map(|(_, log)| libm::exp(*log));
        significant(ratios.reduce(pick).unwrap_or_default(), 2)
    });
    let pins = mechanism.pins();
    let name = count_word(pins);
    let said = own.iter().filter_map(|design| {
        let steady = steady(TOLERANCE, mechanism, design.inertia_ratio, design.friction)?;
        let [speed, rise] = VALUES.map(|value| significant(value(&steady), 3));
        let (friction, inertia) = (format_trimmed(design.friction, 4), format_trimmed(design.inertia_ratio, 4));
        Some(format!("at μ = {friction}, I_D / I_f = {inertia}: mean speed {speed}, rise {rise}"))
    });
    let said: Vec<String> = said.collect();
    Words::new(
        format!("steady-map-{name}-pin"),
        format!("Mean terminal speed and rise by the small difference over friction and inertias, {name} pins"),
        format!(
            "Two maps with the friction μ to the right and I_D / I_f upwards, on a logarithmic axis: {} lines of equal \
             mean speed and {} lines of equal rise by the small difference. With more friction the speed falls and \
             this rise is shorter; with a heavier driver it is longer. The mean speed is greatest at a ratio of the inertias of {least} to \
             {greatest}, by friction. In a corner with much friction and a light driver the equation of motion has no \
             single solution.{}",
            shown[0],
            shown[1],
            if said.is_empty() { String::new() } else { format!(" Marked: {}.", said.join("; ")) }
        ),
        format!(
            "{pins} pins and {} slots. Above are lines of equal mean speed in the steady state, in units of the square \
             root of the ratio of the spring's torque to the follower's moment of inertia. Below are lines of equal \
             rise by the small difference: the number of engagements in which a small difference from the steady speed \
             shrinks to a hundredth of its size. The marks are the runs of the thesis.",
            mechanism.slots()
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound, columns};

    fn design(mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> MarkedEscapement {
        MarkedEscapement { mechanism, inertia_ratio, friction }
    }

    #[test]
    fn a_tolerance_ten_times_finer_gives_the_same_digits() {
        for mechanism in Mechanism::ALL {
            let [usual, finer] = [TOLERANCE, TOLERANCE / 10.0]
                .map(|tolerance| map_within(tolerance, mechanism, &[]).expect("drawn").series.to_text());
            assert_eq!(usual, finer, "{mechanism:?}");
        }
    }

    #[test]
    fn the_value_is_the_same_along_a_line() {
        for mechanism in Mechanism::ALL {
            let designs = [design(mechanism, 0.5, 0.125), design(mechanism, 0.25, 0.25)];
            let figure = map(mechanism, &designs).expect("drawn");
            assert_sound(&figure);
            let rows = columns(&figure.series, ["panel", "value", "mu", "I_D/I_f"]);
            for row @ [panel, level, friction, inertia_ratio] in &rows {
                let state = steady(TOLERANCE, mechanism, *inertia_ratio, *friction).expect("sound");
                let value = VALUES[*panel as usize - 1](&state);
                // The grid is straight between its nodes.
                assert!((value / level - 1.0).abs() < 0.04, "{mechanism:?} {row:?} {value}");
                assert!(*inertia_ratio >= critical_inertia_ratio(mechanism, *friction).expect("a ratio"), "{row:?}");
            }
            assert!([1.0, 2.0].iter().all(|panel| rows.iter().filter(|[own, ..]| own == panel).count() > 40));
            let drawing = ParsedDrawing::parse(&figure);
            // Two designs in two panels; a square or a diamond has a rim of its own class.
            assert_eq!(drawing.count("marks"), 4);
        }
    }

    #[test]
    fn what_the_words_say_of_friction_and_inertia_holds() {
        for mechanism in Mechanism::ALL {
            let [speed, rise] = grids(TOLERANCE, mechanism).expect("grids");
            let falls = |pair: [f64; 2]| pair.iter().any(|value| value.is_nan()) || pair[1] < pair[0];
            for (column, values) in rise.values.iter().enumerate() {
                assert!(values.windows(2).all(|pair| falls([pair[1], pair[0]])), "{mechanism:?} {column}");
            }
            // At one ratio of the inertias: the top row is the same in all columns.
            let top = |grid: &ContourGrid| grid.values.iter().map(|values| values[ROWS as usize]).collect::<Vec<_>>();
            let ridge = speed.ridge();
            assert!(ridge.len() > 50, "{mechanism:?}: {}", ridge.len());
            for (friction, log) in ridge.iter().step_by(8) {
                let mean =
                    |log: f64| steady(TOLERANCE, mechanism, libm::exp(log), *friction).expect("sound").mean_speed;
                assert!(
                    [-0.2, 0.2].iter().all(|aside| mean(log + aside) < mean(*log)),
                    "{mechanism:?} {friction} {log}"
                );
            }
            for grid in [&speed, &rise] {
                assert!(top(grid).windows(2).all(|pair| falls([pair[0], pair[1]])), "{mechanism:?}");
            }
        }
    }

    #[test]
    fn a_design_off_the_map_is_an_error() {
        for far in [
            design(Mechanism::FOUR_PIN, 9.0, 0.125),
            design(Mechanism::FOUR_PIN, 0.5, 0.75),
            design(Mechanism::FOUR_PIN, f64::NAN, 0.1),
        ] {
            assert!(matches!(map(Mechanism::FOUR_PIN, &[far]), Err(FigureError::OffTheMap { .. })));
        }
    }
}
