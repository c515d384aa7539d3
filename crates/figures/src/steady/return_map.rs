//! The speed at the end of an engagement over that at its start, and how motion from rest climbs to the fixed point.

use crate::chart::{Axis, Chart, Mark, Marker, Panel, Stroke};
use crate::number::{short, shown, significant, trimmed};
use crate::svg::{DASHED, Label};
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// The axes go so far beyond the fixed point, in parts of it; steps of a curve.
const BEYOND: f64 = 1.7;
const STEPS: u32 = 60;
/// Steps of the staircase.
const STAIRS: usize = 5;

/// u at exit over u at entry, where u is the square of the driver's speed over K / I_f: with friction, and without.
///
/// The curve crosses the diagonal once, at the steady motion; a staircase leads to it from rest. Without friction the
/// curve runs beside the diagonal: every engagement adds the same. Series: u at entry, u at exit with and without
/// friction.
///
/// # Errors
///
/// [`FigureError`] without friction, where there is no fixed point, or if the motion cannot be computed.
pub fn return_map(parameters: &Parameters) -> Result<Figure, FigureError> {
    let engagement = Engagement::new(parameters)?;
    let free = Parameters::new(parameters.mechanism(), parameters.inertias(), parameters.torque(), 0.0)?;
    let free = Engagement::new(&free)?;
    let drive = parameters.drive();
    let next = |of: &Engagement, u: f64| -> Result<f64, FigureError> {
        let speed = of.return_map((u * drive).sqrt())?;
        Ok(speed * speed / drive)
    };
    let steady = engagement.steady_state()?;
    let fixed = steady.entry_speed * steady.entry_speed / drive;
    let angular_acceleration = next(&free, 0.0)?;
    // Wide enough to see that the curve without friction keeps its distance.
    let axis = Axis::from_zero(0.0, (BEYOND * fixed).max(1.3 * angular_acceleration), 5.0);
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

    let symbol = || Label::symbol("θ").and("\u{200a}′² ").and_symbol("I").sub("f").and(" / ").and_symbol("K");
    let mu = |mu: f64| Label::symbol("μ").and(&format!(" = {}", trimmed(mu, 4)));
    let column = |k: usize| rows.iter().map(move |row| (row[0], row[k]));
    let late = |k: usize| rows.iter().rev().step_by(3).map(move |row| (row[0], row[k]));
    let start = stairs.get(1).copied();
    let point = Marker::new(DRIVER, Mark::Ring).sized(12.0).class("fixed-point");
    let axes = ["at entry", "at exit"].map(|end| axis.clone().titled(symbol().and(" ").and(end)));
    let panel = Panel::new(486.0, &axes[0], &axes[1])
        .curve([(0.0, 0.0), (end, end)], Stroke::thin("diagonal").dashed(DASHED))
        .curve(column(2), Stroke::new(FOLLOWER).dashed("3 4").class("free"))
        .curve(column(1), Stroke::new(DRIVER).class("braked"))
        .curve(stairs, Stroke::new(CORIOLIS).wide(1.6).class("stairs"))
        .marks([(fixed, fixed)], point)
        .near([(fixed, fixed)], -FRAC_PI_4, Label::words(&format!("steady: {}", significant(fixed, 3))).shade(DRIVER))
        .near(start, FRAC_PI_4, Label::words("from rest").shade(CORIOLIS))
        .near(late(1), FRAC_PI_2, mu(parameters.friction()).shade(DRIVER))
        .near(late(2), PI, mu(0.0).shade(FOLLOWER))
        .near(late(0), -FRAC_PI_4, Label::words("exit as entry"));
    let multiplier = short(steady.multiplier, 3);
    let words = Words::new(
        "steady-return-map",
        "What an engagement makes of the square of the speed",
        format!(
            "The square of the driver's speed at exit over that at entry, both over K / I_f, for {} pins and μ = {}. \
             The curve rises little and crosses the diagonal once, at {}; there its slope is {multiplier}. A \
             staircase from rest is there after a few steps. Without friction the curve lies {} above the diagonal \
             throughout and never meets it.",
            parameters.mechanism().pins(),
            trimmed(parameters.friction(), 4),
            significant(fixed, 4),
            significant(angular_acceleration, 4)
        ),
        format!(
            "One engagement takes the square of the speed at entry to that at exit. With friction all motions are \
             drawn to one: near it a difference shrinks to {multiplier} of itself each time. Without friction each \
             engagement adds the same, and there is no terminal speed. {}",
            shown(parameters)
        ),
    );
    let columns = [("u entry", "1"), ("u exit", "1"), ("without friction", "1")];
    Ok(Chart::new([panel]).figure(words, Series::new(columns, rows)))
}
