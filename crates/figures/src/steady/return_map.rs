//! The speed at the end of an engagement over that at its start, and how motions climb and fall to the fixed point.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{describe_parameters, format_trimmed, short, significant};
use crate::svg::{DASHED, Label};
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER, INK};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Where the staircase from above starts, and how far the axes go at least, in fixed points.
const ABOVE: f64 = 2.0;
const BEYOND: f64 = 2.1;
/// Steps of a curve, and of a staircase; how many of the latter are numbered.
const STEPS: u32 = 60;
const STAIRS: usize = 5;
const NUMBERED: usize = 2;

/// u at exit over u at entry, where u is the square of the driver's speed over K / I_f: with friction, and without.
///
/// The curve crosses the diagonal once, at the steady motion; staircases lead to it from rest and from above, and marks
/// show each engagement. Without friction the curve runs beside the diagonal: every engagement adds the same. Series: u
/// at entry, u at exit with and without friction.
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
    let added = next(&free, 0.0)?;
    // Wide enough to see that the curve without friction keeps its distance.
    let axis = ChartAxis::from_zero(0.0, (BEYOND * fixed).max(1.3 * added), 5.0);
    let end = axis.range.end;
    let mut rows = Vec::new();
    for step in 0..=STEPS {
        let u = end * f64::from(step) / f64::from(STEPS);
        rows.push([u, next(&engagement, u)?, next(&free, u)?]);
    }
    let mut stairs =
        [0.0, ABOVE * fixed].map(|start| Stairs { corners: vec![(start, start)], engagements: Vec::new() });
    for stairs in &mut stairs {
        let mut u = stairs.corners[0].0;
        for _ in 0..STAIRS {
            let exit = next(&engagement, u)?;
            stairs.corners.extend([(u, exit), (exit, exit)]);
            stairs.engagements.push((u, exit));
            u = exit;
        }
    }

    let symbol = |end: &str| {
        let label = Label::words("square of the speed at ").and(end).and(", ").and_rate("θ", 1);
        label.and("² ").and_symbol("I").sub("f").and(" / ").and_symbol("K")
    };
    let mu = |mu: f64| Label::symbol("μ").and(&format!(" = {}", format_trimmed(mu, 4)));
    let column = |k: usize| rows.iter().map(move |row| (row[0], row[k]));
    let late = |k: usize| rows.iter().rev().step_by(3).map(move |row| (row[0], row[k]));
    let fixed_point = Marker::new(DRIVER, MarkShape::Ring).sized(12.0).class("fixed-point");
    let axes = ["entry", "exit"].map(|end| axis.clone().titled(symbol(end)));
    let mut panel = Panel::new(486.0, &axes[0], &axes[1])
        .curve([(0.0, 0.0), (end, end)], LineStyle::thin("diagonal").dashed(DASHED))
        .curve(column(2), LineStyle::new(FOLLOWER).dashed("3 4").class("free"))
        .curve(column(1), LineStyle::new(DRIVER).class("braked"));
    for stairs in &stairs {
        panel = panel.curve(stairs.corners.iter().copied(), LineStyle::new(CORIOLIS).wide(1.6).class("stairs")).marks(
            stairs.engagements.iter().copied(),
            Marker::new(CORIOLIS, MarkShape::Disc).sized(6.0).class("engagement"),
        );
    }
    panel = panel.marks([(fixed, fixed)], fixed_point).name_near(
        [(fixed, fixed)],
        -FRAC_PI_4,
        Label::words(&format!("steady: {}", significant(fixed, 3))).in_colour(DRIVER),
    );
    for (stairs, (name, towards)) in stairs.iter().zip([("from rest", FRAC_PI_4), ("from above", -FRAC_PI_2)]) {
        for (number, point) in stairs.engagements.iter().take(NUMBERED).enumerate() {
            let name = if number == 0 { format!("1, {name}") } else { (number + 1).to_string() };
            panel = panel.name_near([*point], towards, Label::words(&name).in_colour(CORIOLIS));
        }
    }
    let panel = panel
        .name_near(late(1), FRAC_PI_2, mu(parameters.friction()).in_colour(DRIVER))
        .name_near(late(2), PI, mu(0.0).in_colour(FOLLOWER))
        .name_near(late(0), -FRAC_PI_4, Label::words("exit as entry").in_colour(INK));
    let multiplier = short(steady.multiplier, 3);
    let words = Words::new(
        "steady-return-map",
        "What an engagement makes of the square of the speed",
        format!(
            "The square of the driver's speed at exit against its square at entry, both in units of K / \
             I_f, for {} pins and μ = {}. \
             The curve rises little and crosses the diagonal once, at {}; there its slope is {multiplier}. One \
             staircase climbs to that point from rest, another falls to it from {} times the square; both are there \
             after a few steps. Without friction the curve lies {} above the diagonal throughout and never meets it.",
            parameters.mechanism().pins(),
            format_trimmed(parameters.friction(), 4),
            significant(fixed, 4),
            format_trimmed(ABOVE, 1),
            significant(added, 4)
        ),
        format!(
            "The solid line shows the square of the speed at the end of an engagement as a function of the square of \
             the speed at its start. Where the curve crosses the dashed diagonal, the motion is steady. To follow a \
             motion, go up or down to the curve and then across to the diagonal, where the next engagement begins. For \
             a start from rest and for one above the steady speed, the first two engagements are numbered. Near the \
             crossing a small difference shrinks to {multiplier} of its size in each engagement. Without friction \
             (dotted) each engagement adds the same amount, and there is no crossing. {}",
            describe_parameters(parameters)
        ),
    );
    let columns = [("u entry", "1"), ("u exit", "1"), ("without friction", "1")];
    Ok(Chart::new([panel]).figure(words, Series::new(columns, rows)))
}

/// Engagement after engagement: up or down to the curve and across to the diagonal.
struct Stairs {
    corners: Vec<(f64, f64)>,
    /// u at entry and at exit of each.
    engagements: Vec<(f64, f64)>,
}
