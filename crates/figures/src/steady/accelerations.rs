//! Speeds, accelerations and the force on the pin over one engagement of the steady motion.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{degrees, extent, short, significant, without_noise};
use crate::svg::Label;
use crate::theme::{DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::{Accelerations, SignedPeak};
use std::f64::consts::{FRAC_PI_2, PI};

/// Parts of the period that are drawn.
const PARTS: usize = 360;
/// Marks of the angle to either side of the line of centres.
const MARKS: i32 = 3;
/// Accelerations are drawn in thousands.
const THOUSAND: f64 = 1000.0;

/// One instant: θ in degrees, θ', φ', θ'' and φ'' in thousands, F R / K.
struct Instant {
    angle: f64,
    speeds: [f64; 2],
    accelerations: [f64; 2],
    force: f64,
}

/// Speed and acceleration of driver and follower, and the force between pin and slot, over one engagement of the steady
/// motion: three panels over the driver angle.
///
/// `run` says which run is shown. Rings mark the follower's acceleration at the two ends, between which it jumps as one pin hands over to the next.
/// Series, at equal times: θ, θ', φ', θ'', φ'', F R/K.
///
/// # Errors
///
/// [`FigureError::Dynamics`] if the escapement has no steady state.
pub fn accelerations(parameters: &Parameters, run: &str) -> Result<Figure, FigureError> {
    let mechanism = parameters.mechanism();
    let engagement = Engagement::new(parameters)?;
    let lines = engagement.steady_cycle(PARTS)?;
    let instants = lines.iter().map(|line| instant(parameters, line.angle, line.speed));
    let instants = instants.collect::<Result<Vec<_>, _>>()?;
    let half = mechanism.engagement_half_angle();
    let x = ChartAxis::of_engagement(half.to_degrees(), MARKS);
    let angle = Label::words("driver angle ").and_symbol("θ").and(" in degrees");
    let panels = [
        both(&x, &instants, |at| at.speeds, "speeds ", 1, " in rad/s"),
        jumping(both(&x, &instants, |at| at.accelerations, "accelerations ", 2, " in 1000 rad/s²"), &instants),
        force(&x.clone().titled(angle), &instants),
    ];
    let change = engagement.passage(engagement.steady_state()?.entry_speed)?.reversal_angle();
    let flank = LineStyle::thin("switch").dashed("5 4");
    let panels = panels.map(|panel| match change {
        Some(change) => panel.vertical(change.to_degrees(), flank),
        None => panel,
    });

    let [driver, follower] = [0, 1].map(|k| significant(instants.iter().map(|at| at.speeds[k]).fold(0.0, f64::max), 3));
    let strongest = Accelerations::new(parameters)?;
    let said = |what: SignedPeak, unit: f64| format!("{} at θ = {}", short(what.value / unit, 3), degrees(what.angle));
    let [first, last] = [instants.first(), instants.last()].map(|at| at.map_or(0.0, |at| at.accelerations[1]));
    let words = Words::new(
        "timer-accelerations",
        format!("Speeds, accelerations and pin force over one engagement, {} pins", mechanism.pins()),
        format!(
            "Three panels over the driver angle from {} to {}. Speeds: the driver's is {driver} rad/s at most, the \
             follower's {follower}. Accelerations in 1000 rad/s²: the driver's strongest is {}, the follower's {}; the follower's is {} at \
             entry and {} at exit. The force F R / K is strongest with {}.",
            degrees(-half),
            degrees(half),
            said(strongest.driver, THOUSAND),
            said(strongest.follower, THOUSAND),
            short(first, 3),
            short(last, 3),
            said(strongest.normal_moment, parameters.torque()),
        ),
        format!(
            "One engagement of the steady motion, entry at the left, exit at the right. {}F R / K is the force between \
             pin and slot divided by the spring's force at the crank radius. At the hand-over the follower's \
             acceleration jumps from the right ring to the left one. Shown: {run}.",
            change.map_or_else(String::new, |change| format!(
                "Up to the dashed line at θ = {}, the pin drives the follower. From there on the follower runs ahead \
                 and throws the driver forward, while the pin holds the follower back. ",
                degrees(change)
            ))
        ),
    );
    let series = Series::of_items(
        &instants,
        [
            ("theta", "deg", |at| at.angle),
            ("theta'", "rad/s", |at| at.speeds[0]),
            ("phi'", "rad/s", |at| at.speeds[1]),
            ("theta''", "1000 rad/s^2", |at| at.accelerations[0]),
            ("phi''", "1000 rad/s^2", |at| at.accelerations[1]),
            ("F R/K", "1", |at| at.force),
        ],
    );
    Ok(Chart::new(panels).figure(words, series))
}

fn instant(parameters: &Parameters, angle: f64, speed: f64) -> Result<Instant, FigureError> {
    let forces = parameters.contact_forces(angle, speed)?;
    let ratio = parameters.mechanism().wheel().velocity_ratio(angle).unwrap_or_default();
    let driver = parameters.acceleration(angle, speed)?.value;
    Ok(Instant {
        angle: angle.to_degrees(),
        speeds: [speed, without_noise(ratio, 1.0) * speed],
        accelerations: [driver / THOUSAND, forces.follower_acceleration / THOUSAND],
        force: forces.normal_moment / parameters.torque(),
    })
}

/// A panel with the driver's and the follower's curve, each named.
fn both(
    x: &ChartAxis,
    instants: &[Instant],
    pair: fn(&Instant) -> [f64; 2],
    what: &str,
    order: usize,
    unit: &str,
) -> Panel {
    let values = || instants.iter().flat_map(pair);
    let [least, most] = extent(values().chain([0.0]));
    let y = ChartAxis::from_zero(least, most, 4.0);
    let [theta, phi] =
        [("θ", DRIVER), ("φ", FOLLOWER)].map(|(letter, colour)| Label::rate(letter, order).in_colour(colour));
    let title = Label::words(what).and_label(&theta).and(" and ").and_label(&phi).and(unit);
    let strokes = [LineStyle::new(DRIVER).dashed("10 5"), LineStyle::new(FOLLOWER)];
    let mut panel = Panel::new(190.0, x, &y.titled(title)).horizontal(0.0, LineStyle::thin("zero"));
    let names = [theta.and(" driver"), phi.and(" follower")];
    for (k, stroke) in strokes.into_iter().enumerate() {
        panel = panel.curve(instants.iter().map(|at| (at.angle, pair(at)[k])), stroke);
    }
    for ((k, name), first) in names.into_iter().enumerate().zip([PI - 0.6, FRAC_PI_2]) {
        // Where the curve is far from zero, it is far from the other one as well.
        let far = instants.iter().map(|at| pair(at)[k].abs()).fold(0.0, f64::max);
        let points = instants.iter().filter(|at| pair(at)[k].abs() > 0.4 * far).step_by(4);
        panel = panel.name_near(points.map(|at| (at.angle, pair(at)[k])), first, name);
    }
    panel
}

/// Adds rings at the ends of the follower's acceleration to a panel.
fn jumping(panel: Panel, instants: &[Instant]) -> Panel {
    let ends = [instants.first(), instants.last()].into_iter().flatten().map(|at| (at.angle, at.accelerations[1]));
    panel.marks(ends, Marker::new(FOLLOWER, MarkShape::Ring).sized(10.0).class("hand-over"))
}

/// The force between pin and slot.
fn force(x: &ChartAxis, instants: &[Instant]) -> Panel {
    let values = || instants.iter().map(|at| at.force);
    let [least, most] = extent(values().chain([0.0]));
    let y = ChartAxis::from_zero(least, most, 4.0);
    let symbol = Label::symbol("F").and_symbol("\u{2009}R").and(" / ").and_symbol("K");
    let title = Label::words("force on the pin ").and_label(&symbol);
    Panel::new(190.0, x, &y.titled(title))
        .horizontal(0.0, LineStyle::thin("zero"))
        .curve(instants.iter().map(|at| (at.angle, at.force)), LineStyle::new(RELATIVE).class("force"))
}
