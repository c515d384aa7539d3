//! The speed at the end of an engagement over that at its start, and how motion from rest climbs to the fixed point.

use super::error::MotionError;
use crate::escapement::axes::{short, upright};
use crate::figure::{Figure, Words};
use crate::number::{shown, significant, trimmed};
use crate::panel::{Panel, Stroke, WIDTH};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::placing::{Place, around, leader};
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER, INK, PAPER};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_4, PI};

const HEIGHT: u32 = 600;
/// The axes go so far beyond the fixed point, in parts of it; steps of a curve.
const BEYOND: f64 = 1.7;
const STEPS: u32 = 60;
/// Steps of the staircase.
const STAIRS: usize = 5;
const NEAR: [f64; 8] = [12.0, 18.0, 26.0, 36.0, 50.0, 66.0, 84.0, 104.0];

/// u at exit over u at entry, where u is the square of the driver's speed over K / I_f: with friction, and without.
///
/// The curve crosses the diagonal once, at the steady motion; a staircase leads to it from rest. Without friction the
/// curve runs beside the diagonal: every engagement adds the same. Series: u at entry, u at exit with and without
/// friction.
///
/// # Errors
///
/// [`MotionError`] without friction, where there is no fixed point, or if the motion cannot be computed.
pub fn hand_over(parameters: &Parameters) -> Result<Figure, MotionError> {
    let engagement = Engagement::new(parameters)?;
    let free = Parameters::new(parameters.mechanism(), parameters.inertias(), parameters.torque(), 0.0)?;
    let free = Engagement::new(&free)?;
    let drive = parameters.drive();
    let next = |of: &Engagement, u: f64| -> Result<f64, MotionError> {
        let speed = of.hand_over((u * drive).sqrt())?;
        Ok(speed * speed / drive)
    };
    let steady = engagement.steady_state()?;
    let fixed = steady.entry_speed * steady.entry_speed / drive;
    let gain = next(&free, 0.0)?;
    // Wide enough to see that the curve without friction keeps its distance.
    let axis = upright(0.0, (BEYOND * fixed).max(1.3 * gain), 5.0);
    let end = axis.range.end;
    let mut rows = Vec::new();
    for step in 0..=STEPS {
        let u = end * f64::from(step) / f64::from(STEPS);
        rows.push([u, next(&engagement, u)?, next(&free, u)?]);
    }
    let mut stairs = vec![(0.0, 0.0)];
    let mut u = 0.0;
    for _ in 0..STAIRS {
        let exit = next(&engagement, u)?;
        stairs.extend([(u, exit), (exit, exit)]);
        u = exit;
    }

    let panel = Panel::new(Vector2::new(0.0, 0.0), HEIGHT, axis.clone(), axis.clone());
    let mut canvas = Canvas::new(f64::from(WIDTH), f64::from(HEIGHT));
    panel.draw(&mut canvas, true);
    let mut placing = panel.placing();
    let mut curve = |canvas: &mut Canvas, points: &[(f64, f64)], stroke: Stroke| {
        let places = panel.curve(canvas, points, stroke);
        placing.avoid_all(&places, 2.0);
        places
    };
    let top = axis.range.end;
    let diagonal = Stroke { shade: INK, width: 1.2, dashes: Some("7 5"), class: "diagonal" };
    let line =
        curve(&mut canvas, &(0..=20).map(|k| f64::from(k) / 20.0 * top).map(|u| (u, u)).collect::<Vec<_>>(), diagonal);
    let column = |k: usize| rows.iter().map(|row| (row[0], row[k])).collect::<Vec<_>>();
    let stroke = |shade, dashes, class| Stroke { shade, width: 2.6, dashes, class };
    let without = curve(&mut canvas, &column(2), stroke(FOLLOWER, Some("3 4"), "free"));
    let with = curve(&mut canvas, &column(1), stroke(DRIVER, None, "braked"));
    let stairs_stroke = Stroke { shade: CORIOLIS, width: 1.6, dashes: None, class: "stairs" };
    curve(&mut canvas, &stairs, stairs_stroke);
    let at = panel.at((fixed, fixed));
    canvas.draw(Shape::circle(&at, 6.0).fill(PAPER).stroke(DRIVER, 2.2).class("fixed-point"));
    placing.take([at - Vector2::new(7.0, 7.0), at + Vector2::new(7.0, 7.0)]);
    let label = Label::words(&format!("steady: {}", significant(fixed, 3))).shade(DRIVER);
    if let Some(place) = placing.put(&mut canvas, &label, around(&at, -FRAC_PI_4, &NEAR)) {
        leader(&mut canvas, &place);
    }
    let stairs_at = panel.at(stairs.get(1).copied().unwrap_or_default());
    let label = Label::words("from rest").shade(CORIOLIS);
    if let Some(place) = placing.put(&mut canvas, &label, around(&stairs_at, FRAC_PI_4, &NEAR)) {
        leader(&mut canvas, &place);
    }
    let mu = |mu: f64| Label::symbol("μ").and(&format!(" = {}", trimmed(mu, 4)));
    let names = [
        (mu(parameters.friction()).shade(DRIVER), with, PI / 2.0),
        (mu(0.0).shade(FOLLOWER), without, PI),
        (Label::words("exit as entry"), line, -FRAC_PI_4),
    ];
    for (label, points, first) in names {
        let from = points.len() / 2;
        let nearby = points.iter().skip(from).rev().step_by(3).take(12);
        let places: Vec<Place> = nearby.flat_map(|point: &Pixels| around(point, first, &NEAR[..5])).collect();
        placing.put(&mut canvas, &label, places);
    }
    let symbol = || Label::symbol("θ").and("\u{200a}′² ").and_symbol("I").sub("f").and(" / ").and_symbol("K");
    panel.name(&mut canvas, &symbol().and(" at exit"));
    panel.foot(&mut canvas, &symbol().and(" at entry"));

    let contraction = short(steady.contraction);
    let words = Words {
        id: "steady-hand-over".to_owned(),
        title: "What an engagement makes of the square of the speed".to_owned(),
        description: format!(
            "The square of the driver's speed at exit over that at entry, both over K / I_f, for {} pins and μ = {}. \
             The curve rises little and crosses the diagonal once, at {}; there its slope is {contraction}. A \
             staircase from rest is there after a few steps. Without friction the curve lies {} above the diagonal \
             throughout and never meets it.",
            parameters.mechanism().pins(),
            trimmed(parameters.friction(), 4),
            significant(fixed, 4),
            significant(gain, 4)
        ),
        caption: format!(
            "One engagement takes the square of the speed at entry to that at exit. With friction all motions are \
             drawn to one: near it a difference shrinks to {contraction} of itself each time. Without friction each \
             engagement adds the same, and there is no terminal speed. {}",
            shown(parameters)
        ),
    };
    let columns = [("u entry", "1"), ("u exit", "1"), ("without friction", "1")];
    Ok(words.figure(canvas, Kind::Plot, Series::new(columns, rows)))
}
