//! Terminal speed and rise over friction and ratio of the inertias.

use super::contours::Grid;
use super::error::MotionError;
use crate::escapement::Design;
use crate::figure::{Figure, Words};
use crate::markers::of_mechanism;
use crate::number::{significant, trimmed};
use crate::panel::{Panel, Stroke, WIDTH};
use crate::plot::{Axis, Scale};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::path::Path;
use crate::svg::placing::{Place, Placing, around};
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{DRIVER, FILL, FOLLOWER, INK, PAPER};
use geneva_dynamics::existence::critical_inertia_ratio;
use geneva_dynamics::steady::{Engagement, SteadyState};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use nalgebra::Vector2;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

const KEY: f64 = 10.0;
const HEIGHTS: [u32; 2] = [444, 464];
/// What is shown of μ and of I_D / I_f at least.
const FRICTIONS: Range<f64> = 0.0..0.6;
const INERTIAS: Range<f64> = 0.01..5.0;
/// Columns and rows of the grid; how far above the critical ratio of the inertias it begins.
const COLUMNS: u32 = 56;
const ROWS: u32 = 56;
const CLEAR: f64 = 1.002;
/// Relative error of what is computed for it.
const TOLERANCE: f64 = 1e-6;
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
/// How far the ridge's name may stand from it, in pixels.
const NEAR: [f64; 3] = [13.0, 18.0, 26.0];

/// A value of the steady motion at a torque and an inertia of the follower of one.
type Value = fn(&SteadyState) -> f64;

/// Mean speed, and engagements from rest until a difference of speeds has shrunk to a hundredth.
const VALUES: [Value; 2] = [|steady| steady.mean_speed, |steady| libm::log(LEFT) / libm::log(steady.contraction)];

/// Lines of equal mean terminal speed, in √(K / I_f), and of equal rise, over μ and I_D / I_f.
///
/// A dotted line leads through the ratios of the inertias at which the mean speed is greatest for each friction. The
/// rise is counted in engagements: ln 100 over −ln of the contraction. On the tinted ground there are angles at which
/// the equation of motion has none or two solutions. Designs of other mechanisms are left out. Series, for every sixth
/// point of each line: which panel, the value, μ, I_D / I_f.
///
/// # Errors
///
/// [`MotionError`] if a design cannot be shown.
pub fn map(mechanism: Mechanism, designs: &[Design]) -> Result<Figure, MotionError> {
    let own: Vec<&Design> = designs.iter().filter(|design| design.mechanism == mechanism).collect();
    if own.iter().any(|design| !INERTIAS.contains(&design.inertia_ratio) || !FRICTIONS.contains(&design.friction)) {
        return Err(MotionError::Nothing);
    }
    let grids = grids(mechanism)?;
    let level = Axis {
        range: FRICTIONS,
        marks: (0..=6).map(|k| FRICTIONS.end * f64::from(k) / 6.0).collect(),
        decimals: 1,
        scale: Scale::Even,
    };
    let marks = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0].to_vec();
    let left = Axis { range: INERTIAS, marks, decimals: 2, scale: Scale::Logarithmic };
    let (corners, height) = Panel::stack(KEY, HEIGHTS);
    let mut canvas = Canvas::new(f64::from(WIDTH), height);
    let (mut rows, mut shown) = (Vec::new(), [0; 2]);
    for (k, (corner, height)) in corners.into_iter().zip(HEIGHTS).enumerate() {
        let panel = Panel::new(corner, height, level.clone(), left.clone());
        boundary(&mut canvas, &panel, mechanism);
        panel.draw(&mut canvas, true);
        let mut placing = panel.placing();
        let mut last: Option<f64> = None;
        let mut labels = Vec::new();
        for value in LEVELS {
            let lines = grids[k].lines(libm::log(value));
            let reach = lines.iter().flatten().map(|(friction, _)| *friction).fold(0.0, f64::max);
            if last.is_some_and(|last| value < APART[k] * last) || value < LEAST[k] || reach < NARROW {
                continue;
            }
            (last, shown[k]) = (Some(value), shown[k] + 1);
            for line in lines {
                let points: Vec<_> = line.iter().map(|(friction, log)| (*friction, libm::exp(*log))).collect();
                let shade = if k == 0 { DRIVER } else { FOLLOWER };
                let dashes = if k == 0 { None } else { Some("8 4") };
                let places = panel.curve(&mut canvas, &points, Stroke { shade, width: 1.8, dashes, class: "equal" });
                let kept = points.iter().step_by(KEPT);
                rows.extend(kept.map(|(friction, inertia)| [(k + 1) as f64, value, *friction, *inertia]));
                labels.push((Label::words(&trimmed(value, 2)).shade(shade), places));
            }
        }
        if k == 0 {
            let ridge: Vec<_> = grids[0].ridge().iter().map(|(friction, log)| (*friction, libm::exp(*log))).collect();
            let stroke = Stroke { shade: INK, width: 2.2, dashes: Some("2 5"), class: "ridge" };
            let places = panel.curve(&mut canvas, &ridge, stroke);
            let label = Label::words("fastest");
            let late = places.iter().rev().take(places.len() / 2).flat_map(|at| around(at, FRAC_PI_2, &NEAR));
            // Off the lines, which their own labels stand on.
            let mut free = placing.clone();
            labels.iter().for_each(|(_, places)| free.avoid_all(places, 2.0));
            if let Some(Place { point, towards, distance }) = free.put(&mut canvas, &label, late) {
                placing.take(label.extent(label.width(), &point, &towards, distance));
            }
            placing.avoid_all(&places, 2.0);
        }
        let style = of_mechanism(mechanism.slots());
        for design in &own {
            let point = (design.friction, design.inertia_ratio);
            panel.marks(&mut canvas, &[point], style, 10.0);
            let (at, room) = (panel.at(point), Vector2::new(9.0, 9.0));
            placing.take([at - room, at + room]);
        }
        sign(&mut canvas, &mut placing, &panel, mechanism);
        for (label, places) in labels {
            on_line(&mut canvas, &mut placing, &label, &places);
        }
        panel.name(
            &mut canvas,
            &Label::symbol("I").sub("D").and(" / ").and_symbol("I").sub("f").and(&format!("  {}", NAMES[k])),
        );
    }
    Panel::new(corners[1], HEIGHTS[1], level, left).foot(&mut canvas, &Label::words("friction ").and_symbol("μ"));
    Ok(words(mechanism, &own, shown, &grids[0].ridge()).figure(
        canvas,
        Kind::Panels,
        Series::new([("panel", "1"), ("value", "1"), ("mu", "1"), ("I_D/I_f", "1")], rows),
    ))
}

/// What the lines are, beside the name of the upright axis.
const NAMES: [&str; 2] = ["and lines of equal mean speed", "and lines of equal rise, in engagements"];

/// The steady motion of a design with a torque and an inertia of the follower of one.
fn steady(mechanism: Mechanism, inertia: f64, friction: f64) -> Option<SteadyState> {
    let parameters = Parameters::new(mechanism, Inertias::new(inertia, 1.0).ok()?, 1.0, friction).ok()?;
    Engagement::with_tolerance(&parameters, TOLERANCE).ok()?.steady_state().ok()
}

/// Logarithms of both values over μ and the logarithm of I_D / I_f: each column begins where there is one solution.
fn grids(mechanism: Mechanism) -> Result<[Grid; 2], MotionError> {
    let (mut columns, mut heights) = (Vec::new(), Vec::new());
    let mut values = [Vec::new(), Vec::new()];
    // Without friction there is no steady motion: the first column has little, and the next ones are close.
    for column in 0..=COLUMNS {
        let share = (f64::from(column) + 3.0) / (f64::from(COLUMNS) + 3.0);
        let friction = FRICTIONS.end * share * share;
        let low = libm::log((CLEAR * critical_inertia_ratio(mechanism, friction)?).max(INERTIAS.start));
        let height = |row: u32| low + (libm::log(INERTIAS.end) - low) * f64::from(row) / f64::from(ROWS);
        let nodes: Vec<f64> = (0..=ROWS).map(height).collect();
        let states: Vec<_> = nodes.iter().map(|log| steady(mechanism, libm::exp(*log), friction)).collect();
        for (values, value) in values.iter_mut().zip(VALUES) {
            let log =
                |steady: &Option<SteadyState>| steady.as_ref().map_or(f64::NAN, |steady| libm::log(value(steady)));
            values.push(states.iter().map(log).collect());
        }
        columns.push(friction);
        heights.push(nodes);
    }
    Ok(values.map(|values| Grid { columns: columns.clone(), heights: heights.clone(), values }))
}

/// The critical ratio of the inertias over μ, within the panel.
fn critical(mechanism: Mechanism) -> Vec<(f64, f64)> {
    let at = |step: u32| {
        let friction = FRICTIONS.end * f64::from(step) / 90.0;
        (friction, critical_inertia_ratio(mechanism, friction).unwrap_or_default().clamp(INERTIAS.start, INERTIAS.end))
    };
    (0..=90).map(at).collect()
}

/// The ground below the boundary, and the boundary.
fn boundary(canvas: &mut Canvas, panel: &Panel, mechanism: Mechanism) {
    let points = critical(mechanism);
    let end = panel.at((FRICTIONS.end, INERTIAS.start));
    let outline = points.iter().map(|point| panel.at(*point)).fold(None, |path: Option<Path>, at| {
        Some(path.map_or_else(|| Path::start_rounded(&at, 1), |path| path.line_to(&at)))
    });
    if let Some(outline) = outline {
        canvas.draw(Shape::path(outline.line_to(&end).close()).fill(FILL).class("unsound"));
    }
    // As far as it is above the foot of the panel.
    let shown: Vec<_> = points.into_iter().filter(|(_, inertia)| *inertia > INERTIAS.start).collect();
    panel.curve(canvas, &shown, Stroke { shade: INK, width: 2.4, dashes: None, class: "boundary" });
}

/// What the tinted ground is, where it has room.
fn sign(canvas: &mut Canvas, placing: &mut Placing, panel: &Panel, mechanism: Mechanism) {
    let label = Label::words("no single solution").on(FILL).bare();
    let edge: Vec<Pixels> = critical(mechanism).iter().map(|point| panel.at(*point)).collect();
    placing.avoid_all(&edge, 3.0);
    let half = label.width() / 2.0 + 8.0;
    let [_, corner] = panel.corners();
    let spots = [18.0, 30.0, 42.0].map(|up| Place {
        point: Vector2::new(corner.x - half, corner.y - up),
        towards: Pixels::zeros(),
        distance: 0.0,
    });
    if placing.has_room(&label, spots) {
        placing.put(canvas, &label, spots);
    }
}

/// A line's value on the line, where other labels and marks leave room: from its middle on.
fn on_line(canvas: &mut Canvas, placing: &mut Placing, label: &Label, places: &[Pixels]) {
    let count = places.len();
    let order = (0..count).map(|k| if k % 2 == 0 { count / 2 + k / 2 } else { count / 2 - k.div_ceil(2) });
    let spots = order.filter_map(|k| places.get(k)).enumerate().map(|(rank, point)| Place {
        point: *point,
        towards: Pixels::zeros(),
        // Counts as a cost, not as a distance: there is no direction.
        distance: rank as f64,
    });
    if !placing.has_room(label, spots.clone()) {
        return;
    }
    if let Some(place) = placing.put(canvas, &label.clone().bare(), spots) {
        // The line is interrupted: a halo would leave dots of it between the digits.
        let [least, greatest] = label.extent(label.width(), &place.point, &place.towards, 0.0);
        let [b, d] = [Vector2::new(greatest.x, least.y), Vector2::new(least.x, greatest.y)];
        let ground = Path::start_rounded(&least, 1).line_to(&b).line_to(&greatest).line_to(&d).close();
        canvas.draw(Shape::path(ground).fill(PAPER).class("ground"));
    }
}

fn words(mechanism: Mechanism, own: &[&Design], shown: [usize; 2], ridge: &[(f64, f64)]) -> Words {
    let [least, greatest] = [f64::min, f64::max].map(|pick| {
        let ratios = ridge.iter().map(|(_, log)| libm::exp(*log));
        significant(ratios.reduce(pick).unwrap_or_default(), 2)
    });
    let pins = mechanism.pins();
    let name = match pins {
        3 => "three",
        4 => "four",
        _ => "six",
    };
    let said = own.iter().filter_map(|design| {
        let steady = steady(mechanism, design.inertia_ratio, design.friction)?;
        let [speed, rise] = VALUES.map(|value| significant(value(&steady), 3));
        let (friction, inertia) = (trimmed(design.friction, 4), trimmed(design.inertia_ratio, 4));
        Some(format!("at μ = {friction}, I_D / I_f = {inertia}: mean speed {speed}, rise {rise}"))
    });
    let said: Vec<String> = said.collect();
    Words {
        id: format!("steady-map-{name}-pin"),
        title: format!("Mean terminal speed and rise over friction and inertias, {name} pins"),
        description: format!(
            "Two maps with the friction μ to the right and I_D / I_f upwards, on a logarithmic axis: {} lines of \
             equal mean speed and {} lines of equal rise. With more friction the speed falls and the rise is shorter; \
             with a heavier driver the rise is longer. The mean speed is greatest at a ratio of the inertias of \
             {least} to {greatest}, by friction. In a corner with much friction and a light driver the equation of \
             motion has no single solution.{}",
            shown[0],
            shown[1],
            if said.is_empty() { String::new() } else { format!(" Marked: {}.", said.join("; ")) }
        ),
        caption: format!(
            "{pins} pins. Above, lines of equal mean terminal speed, in units of the root of the \
             torque over the follower's inertia; below, lines of equal number of engagements until a difference of speeds has shrunk to a hundredth. Marked: the runs; dotted: the ratio \
             of the inertias at which the mean speed is greatest. On the tinted ground the equation of motion has no \
             single solution."
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{labels_inside, named, only_numbers, overlapping_labels, well_formed};
    use roxmltree::Document;

    fn design(mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> Design {
        Design { name: String::new(), mechanism, inertia_ratio, friction }
    }

    #[test]
    fn the_value_is_the_same_along_a_line() {
        for mechanism in Mechanism::ALL {
            let designs = [design(mechanism, 0.5, 0.125), design(mechanism, 0.25, 0.25)];
            let figure = map(mechanism, &designs).expect("drawn");
            well_formed(&figure);
            only_numbers(&figure);
            labels_inside(&figure);
            assert_eq!(overlapping_labels(&figure), [], "{}", figure.id);
            assert!(figure.svg.len() < 25_000, "{}: {} bytes", figure.id, figure.svg.len());
            let rows = &figure.series.rows;
            for row in rows {
                let state = steady(mechanism, row[3], row[2]).expect("sound");
                let value = VALUES[row[0] as usize - 1](&state);
                // The grid is straight between its nodes.
                assert!((value / row[1] - 1.0).abs() < 0.04, "{mechanism:?} {row:?} {value}");
                assert!(row[3] >= critical_inertia_ratio(mechanism, row[2]).expect("a ratio"), "{row:?}");
            }
            assert!([1.0, 2.0].iter().all(|panel| rows.iter().filter(|row| row[0] == *panel).count() > 40));
            let document = Document::parse(&figure.svg).expect("well-formed");
            // Two designs in two panels; a square or a diamond has a rim of its own class.
            assert_eq!(named(&document, "marks").len(), 4);
        }
    }

    #[test]
    fn what_the_words_say_of_friction_and_inertia_holds() {
        for mechanism in Mechanism::ALL {
            let [speed, rise] = grids(mechanism).expect("grids");
            let falls = |pair: [f64; 2]| pair.iter().any(|value| value.is_nan()) || pair[1] < pair[0];
            for (column, values) in rise.values.iter().enumerate() {
                assert!(values.windows(2).all(|pair| falls([pair[1], pair[0]])), "{mechanism:?} {column}");
            }
            // At one ratio of the inertias: the top row is the same in all columns.
            let top = |grid: &Grid| grid.values.iter().map(|values| values[ROWS as usize]).collect::<Vec<_>>();
            let ridge = speed.ridge();
            assert!(ridge.len() > 50, "{mechanism:?}: {}", ridge.len());
            for (friction, log) in ridge.iter().step_by(8) {
                let mean = |log: f64| steady(mechanism, libm::exp(log), *friction).expect("sound").mean_speed;
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
            assert_eq!(map(Mechanism::FOUR_PIN, &[far]), Err(MotionError::Nothing));
        }
    }
}
