//! Speeds, accelerations and the force on the pin over one engagement of the steady motion.

use crate::chart::{Axis, Chart, Mark, Marker, Panel, Stroke};
use crate::number::{degrees, short, significant, without_noise};
use crate::svg::Label;
use crate::theme::{DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::{Accelerations, Strongest};
use std::f64::consts::{FRAC_PI_2, PI};

/// Parts of the period that are drawn.
const PARTS: usize = 360;
/// Marks of the angle to either side of the line of centres.
const MARKS: i32 = 3;
/// Accelerations are drawn in thousands.
const THOUSAND: f64 = 1000.0;

/// One instant: θ in degrees, θ', φ', θ'' and φ'' in thousands, F R / K.
type Row = [f64; 6];

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
    let rows = lines.iter().map(|line| row(parameters, line.angle, line.speed)).collect::<Result<Vec<Row>, _>>()?;
    let half = mechanism.engagement_half_angle();
    let x = Axis::of_engagement(half.to_degrees(), MARKS);
    let angle = Label::words("driver angle ").and_symbol("θ").and(" in degrees");
    let panels = [
        both(&x, &rows, [1, 2], "speeds ", 1, " in rad/s"),
        jumping(both(&x, &rows, [3, 4], "accelerations ", 2, " in 1000 rad/s²"), &rows),
        force(&x.clone().titled(angle), &rows),
    ];
    let change = engagement.passage(engagement.steady_state()?.entry_speed)?.reversal_angle();
    let flank = Stroke::thin("switch").dashed("5 4");
    let panels = panels.map(|panel| match change {
        Some(change) => panel.vertical(change.to_degrees(), flank),
        None => panel,
    });

    let greatest = |column: usize| significant(rows.iter().map(|row| row[column]).fold(0.0, f64::max), 3);
    let strongest = Accelerations::new(parameters)?;
    let said = |what: Strongest, unit: f64| format!("{} at θ = {}", short(what.value / unit, 3), degrees(what.angle));
    let [first, last] = [rows.first(), rows.last()].map(|row| row.map_or(0.0, |row| row[4]));
    let words = Words::new(
        "timer-accelerations",
        format!("Speeds, accelerations and pin force over one engagement, {} pins", mechanism.pins()),
        format!(
            "Three panels over the driver angle from {} to {}. Speeds: the driver's is {} rad/s at most, the follower's \
             {}. Accelerations in 1000 rad/s²: the driver's strongest is {}, the follower's {}; the follower's is {} at \
             entry and {} at exit. The force F R / K is strongest with {}.",
            degrees(-half),
            degrees(half),
            greatest(1),
            greatest(2),
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
                 and throws the driver on, while the pin holds the follower back. ",
                degrees(change)
            ))
        ),
    );
    let columns = [
        ("theta", "deg"),
        ("theta'", "rad/s"),
        ("phi'", "rad/s"),
        ("theta''", "1000 rad/s^2"),
        ("phi''", "1000 rad/s^2"),
        ("F R/K", "1"),
    ];
    Ok(Chart::new(panels).figure(words, Series::new(columns, rows)))
}

fn row(parameters: &Parameters, angle: f64, speed: f64) -> Result<Row, FigureError> {
    let forces = parameters.contact_forces(angle, speed)?;
    let ratio = parameters.mechanism().wheel().velocity_ratio(angle).unwrap_or_default();
    let driver = parameters.acceleration(angle, speed)?.value;
    Ok([
        angle.to_degrees(),
        speed,
        without_noise(ratio, 1.0) * speed,
        driver / THOUSAND,
        forces.follower_acceleration / THOUSAND,
        forces.normal_moment / parameters.torque(),
    ])
}

/// A panel with the driver's and the follower's curve, each named.
fn both(x: &Axis, rows: &[Row], columns: [usize; 2], what: &str, order: usize, unit: &str) -> Panel {
    let values = || rows.iter().flat_map(|row| columns.map(|column| row[column]));
    let y = Axis::from_zero(values().fold(0.0, f64::min), values().fold(0.0, f64::max), 4.0);
    let [theta, phi] =
        [("θ", DRIVER), ("φ", FOLLOWER)].map(|(letter, colour)| Label::rate(letter, order).in_colour(colour));
    let title = Label::words(what).and_label(&theta).and(" and ").and_label(&phi).and(unit);
    let strokes = [Stroke::new(DRIVER).dashed("10 5"), Stroke::new(FOLLOWER)];
    let mut panel = Panel::new(190.0, x, &y.titled(title)).horizontal(0.0, Stroke::thin("zero"));
    let names = [theta.and(" driver"), phi.and(" follower")];
    for (column, stroke) in columns.into_iter().zip(strokes) {
        panel = panel.curve(rows.iter().map(|row| (row[0], row[column])), stroke);
    }
    for ((column, name), first) in columns.into_iter().zip(names).zip([PI - 0.6, FRAC_PI_2]) {
        // Where the curve is far from zero, it is far from the other one as well.
        let far = rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        let points = rows.iter().filter(|row| row[column].abs() > 0.4 * far).step_by(4);
        panel = panel.near(points.map(|row| (row[0], row[column])), first, name);
    }
    panel
}

/// Adds rings at the ends of the follower's acceleration to a panel.
fn jumping(panel: Panel, rows: &[Row]) -> Panel {
    let ends = [rows.first(), rows.last()].into_iter().flatten().map(|row| (row[0], row[4]));
    panel.marks(ends, Marker::new(FOLLOWER, Mark::Ring).sized(10.0).class("hand-over"))
}

/// The force between pin and slot.
fn force(x: &Axis, rows: &[Row]) -> Panel {
    let values = || rows.iter().map(|row| row[5]);
    let y = Axis::from_zero(values().fold(0.0, f64::min), values().fold(0.0, f64::max), 4.0);
    let symbol = Label::symbol("F").and_symbol("\u{2009}R").and(" / ").and_symbol("K");
    let title = Label::words("force on the pin ").and_label(&symbol);
    Panel::new(190.0, x, &y.titled(title))
        .horizontal(0.0, Stroke::thin("zero"))
        .curve(rows.iter().map(|row| (row[0], row[5])), Stroke::new(RELATIVE).class("force"))
}
