//! The motion over the whole engagement: the wheel's speed and acceleration, and the pin's speed along the slot.

use super::instant::PinState;
use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{degrees, extent, short, significant, without_noise};
use crate::svg::Label;
use crate::theme::{Colour, FOLLOWER, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use geneva_kinematics::wheel::acceleration_ratio;
use std::f64::consts::{FRAC_PI_4, PI};

/// Degrees between marks of the crank angle.
const MARKS: f64 = 15.0;
/// At least so many steps of a y axis.
const STEPS: f64 = 5.0;

/// The wheel's angular velocity and acceleration and the pin's speed along the slot, from entry to exit.
///
/// The wheel's rates are positive clockwise: the wheel of a driver that turns counter-clockwise has a velocity that is
/// never negative. The given instant (`crank` is counter-clockwise from the direction O → B) is marked if it is
/// within the engagement. `driver_speed` is the driver's constant angular velocity in radians per second,
/// counter-clockwise positive; `length_unit` the unit of the mechanism's lengths. Series, in steps of about a degree
/// from entry to exit: θ; φ′; φ″; speed along the slot, positive towards the follower's pivot; r/R.
pub fn over_the_engagement(mechanism: &PinSlot, crank: &Turn<f64>, driver_speed: f64, length_unit: &str) -> Figure {
    let speed_unit = format!("{length_unit}/s");
    let rows = rows(mechanism, driver_speed);
    let half = mechanism.engagement_half_angle();
    let now = row(mechanism, crank, driver_speed);
    let within = now[0].abs() <= half.to_degrees() + 1e-6;
    let panels = [1, 2, 3].map(|column| panel(&rows, column, within.then_some(&now), &speed_unit));
    let columns =
        [("theta", "deg"), ("phi'", "rad/s"), ("phi''", "rad/s^2"), ("v_P/S", speed_unit.as_str()), ("r/R", "1")];
    let [entry, exit] = [-half, half].map(degrees);
    let [_, fastest, ..] = row(mechanism, &Turn::from_radians(PI), driver_speed);
    let [_, _, jump, ..] = rows.first().copied().unwrap_or_default();
    let driver = format!("{} rad/s", short(driver_speed, 3));
    let words = Words::new(
        "pin-engagement",
        "Motion of the wheel and of the pin in its slot over the engagement",
        format!(
            "Three curves over the crank angle from {entry} to {exit}, for a driver at {driver}. The wheel's angular \
             velocity is zero at both ends and reaches {} rad/s on the line of centres. Its angular acceleration jumps \
             to {} rad/s² at entry, is zero on the line of centres and jumps back to zero at exit. The pin's speed along \
             the slot goes from the pin's full speed inwards, through zero on the line of centres, to its full speed \
             outwards.",
            short(fastest.abs(), 4),
            short(jump.abs(), 4),
        ),
        format!(
            "The whole engagement at a driver speed of {driver}. The wheel starts from rest and comes to rest, but its acceleration jumps at both ends. Where the \
             wheel is fastest, the pin stops in the slot and turns back.{}",
            if within {
                format!(" The dotted line marks the instant θ = {}.", degrees(now[0].to_radians()))
            } else {
                String::new()
            }
        ),
    );
    Chart::new(panels).figure(words, Series::new(columns, rows))
}

/// θ in degrees, φ′, φ″, speed along the slot, r/R; from entry to exit, both included.
fn rows(mechanism: &PinSlot, driver_speed: f64) -> Vec<[f64; 5]> {
    let half = mechanism.engagement_half_angle();
    let steps = libm::ceil(2.0 * half.to_degrees() - 1e-9).max(2.0) as u32;
    let at = |k: u32| {
        // Symmetric about the line of centres to the last bit.
        let before = half * (f64::from(steps) - 2.0 * f64::from(k)) / f64::from(steps);
        let mut row = row(mechanism, &Turn::from_radians(before).supplement(), driver_speed);
        row[0] = -before.to_degrees();
        row
    };
    (0..=steps).map(at).collect()
}

/// θ in degrees, φ′, φ″, speed along the slot, r/R at one crank angle. The wheel's rates are positive clockwise.
fn row(mechanism: &PinSlot, crank: &Turn<f64>, driver_speed: f64) -> [f64; 5] {
    let instant = PinState::new(mechanism, crank, driver_speed);
    let positive = |value: f64| if value == 0.0 { 0.0 } else { value };
    // The supplement is −θ: the sine changes its sign.
    let acceleration = acceleration_ratio(&mechanism.ratio(), &crank.supplement()) * driver_speed * driver_speed;
    [
        (instant.crank_angle - PI).to_degrees(),
        positive(-instant.speed_ratio * driver_speed),
        positive(-acceleration),
        positive(instant.inward_speed),
        instant.radius_ratio,
    ]
}

/// One curve with the instant, if that is within the engagement.
fn panel(rows: &[[f64; 5]], column: usize, now: Option<&[f64; 5]>, speed_unit: &str) -> Panel {
    let (symbol, unit, way, colour) = match column {
        1 => (Label::rate("φ", 1), "rad/s", "clockwise", FOLLOWER),
        2 => (Label::rate("φ", 2), "rad/s²", "clockwise", FOLLOWER),
        _ => (Label::symbol("v").sub("P/S"), speed_unit, "towards O", RELATIVE),
    };
    let values = || rows.iter().map(|row| row[column]);
    let [least, greatest] = extent(values().chain([0.0]));
    let y = if least == greatest { ChartAxis::symmetric(0.0) } else { ChartAxis::from_zero(least, greatest, STEPS) };
    let title = symbol.and(&format!(" in {unit}, {way} positive")).in_colour(colour);
    let x = x_axis(rows);
    let angle = Label::words("crank angle ").and_symbol("θ").and(" in degrees");
    let x = if column == 3 { x.titled(angle) } else { x.unnumbered() };
    let mut panel = Panel::new(150.0, &x, &y.titled(title))
        .curve(rows.iter().map(|row| (row[0], row[column])), LineStyle::new(colour));
    if let Some(now) = now {
        panel = mark(panel, (now[0], now[column]), greatest.max(-least), colour);
    }
    panel
}

fn x_axis(rows: &[[f64; 5]]) -> ChartAxis {
    let half = rows.last().map_or(0.0, |row| row[0]);
    let each = f64::from(((half / MARKS / 4.0).ceil() as u32).max(1)) * MARKS;
    let count = ((half + 1e-9) / each) as i32;
    ChartAxis::whole(-half..half, (-count..=count).map(|k| each * f64::from(k)))
}

/// Marks the instant on a curve, with its value.
fn mark(panel: Panel, (x, y): (f64, f64), scale: f64, colour: Colour) -> Panel {
    let y = without_noise(y, scale);
    panel
        .vertical(x, LineStyle::thin("instant").dashed("3 4"))
        .marks([(x, y)], Marker::new(colour, MarkShape::Disc).sized(11.0))
        .name_near([(x, y)], FRAC_PI_4, Label::words(&significant(y, 4)).in_colour(colour))
}
