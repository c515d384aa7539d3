//! The motion over the whole engagement: the follower's speed and the pin's speed along the slot.

use super::instant::Instant;
use crate::chart::{Axis, Chart, Mark, Marker, Panel, Side, Stroke};
use crate::number::{degrees, significant, with_minus_sign, without_noise};
use crate::svg::Label;
use crate::theme::{FOLLOWER, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Degrees between marks of the crank angle.
const MARKS: f64 = 15.0;

/// The follower's angular velocity over the driver's, and the pin's speed along the slot, from entry to exit.
///
/// The given instant (`crank` is φ, counter-clockwise from the direction O → B) is marked if it is within the
/// engagement. `driver_speed` is the driver's angular velocity in radians per second, counter-clockwise positive;
/// `length_unit` the unit of the mechanism's lengths. Series, in steps of about a degree from entry to exit:
/// φ; ω_S/ω_D, positive where the two turn the same way; speed along the slot, positive towards the follower's
/// pivot; r/R.
pub fn over_the_engagement(mechanism: &PinSlot, crank: &Turn<f64>, driver_speed: f64, length_unit: &str) -> Figure {
    let speed_unit = format!("{length_unit}/s");
    let rows = rows(mechanism, driver_speed);
    let instant = Instant::new(mechanism, crank, driver_speed);
    let half = mechanism.engagement_half_angle();
    let mut panel = curves(&rows, half.to_degrees(), &speed_unit);
    if (instant.crank_angle - PI).abs() <= half + 1e-9 {
        panel = mark(panel, &instant, &speed_unit);
    }
    panel = names(panel, &rows, &instant);
    let columns = [("phi", "deg"), ("omega_S/omega_D", "1"), ("v_P/S", speed_unit.as_str()), ("r/R", "1")];
    let [entry, exit] = [PI - half, PI + half].map(degrees);
    let lowest = Instant::new(mechanism, &Turn::from_radians(PI), 1.0).speed_ratio;
    let lowest = with_minus_sign(&significant(lowest, 4));
    let words = Words::new(
        "pin-engagement",
        "Speeds of the follower and along the slot over the engagement",
        format!(
            "Two curves over the crank angle from {entry} to {exit}. The follower's angular velocity over the driver's \
             is zero at both ends and falls to {lowest} on the line of centres; the pin's speed along the slot goes \
             from the pin's full speed inwards, through zero on the line of centres, to its full speed outwards."
        ),
        "Over the engagement. The follower starts and stops at rest; the pin turns round in the slot where the \
         follower is fastest. Negative ratio: the two turn in opposite senses. Sliding towards O is positive.",
    );
    Chart::new([panel]).figure(words, Series::new(columns, rows))
}

/// φ in degrees, ω_S/ω_D, speed along the slot, r/R; from entry to exit, both included.
fn rows(mechanism: &PinSlot, driver_speed: f64) -> Vec<[f64; 4]> {
    let half = mechanism.engagement_half_angle();
    let steps = libm::ceil(2.0 * half.to_degrees() - 1e-9).max(2.0) as u32;
    let row = |k: u32| {
        // Symmetric about the line of centres to the last bit.
        let before = half * (f64::from(steps) - 2.0 * f64::from(k)) / f64::from(steps);
        let instant = Instant::new(mechanism, &Turn::from_radians(before).supplement(), driver_speed);
        [180.0 - before.to_degrees(), instant.speed_ratio, instant.inward_speed, instant.radius_ratio]
    };
    (0..=steps).map(row).collect()
}

fn curves(rows: &[[f64; 4]], half: f64, speed_unit: &str) -> Panel {
    let each = f64::from(((half / MARKS / 4.0).ceil() as u32).max(1)) * MARKS;
    let count = ((half + 1e-9) / each) as i32;
    let x = Axis::whole(180.0 - half..180.0 + half, (-count..=count).map(|k| 180.0 + each * f64::from(k)));
    let greatest = |k: usize| rows.iter().map(|row| row[k].abs()).fold(0.0, f64::max);
    let [ratio, sliding] = symbols();
    let points = |k: usize| rows.iter().map(move |row| (row[0], row[k]));
    let angle = Label::words("crank angle ").and_symbol("φ").and(" in degrees");
    Panel::new(336.0, &x.titled(angle), &Axis::symmetric(greatest(1)).titled(ratio))
        .right(Axis::symmetric(greatest(2)).titled(sliding.and(&format!(" in {speed_unit}"))))
        .curve(points(1), Stroke::new(FOLLOWER))
        .curve_on(Side::Right, points(2), Stroke::new(RELATIVE).dashed("10 6"))
}

/// The symbols of the two curves.
fn symbols() -> [Label; 2] {
    let ratio = Label::symbol("ω").sub("S").and(" / ").and_symbol("ω").sub("D").shade(FOLLOWER);
    [ratio, Label::symbol("v").sub("P/S").shade(RELATIVE)]
}

/// Each curve's symbol, in the half that the instant is not in.
fn names(panel: Panel, rows: &[[f64; 4]], instant: &Instant) -> Panel {
    let late = instant.crank_angle <= PI;
    let part =
        |k: usize| rows.iter().filter(move |row| (row[0] > 180.0) == late).step_by(3).map(move |row| (row[0], row[k]));
    let [ratio, sliding] = symbols();
    panel.near(part(1), FRAC_PI_2, ratio).near_on(Side::Right, part(2), -FRAC_PI_2, sliding)
}

/// Marks the instant on both curves.
fn mark(panel: Panel, instant: &Instant, speed_unit: &str) -> Panel {
    let x = instant.crank_angle.to_degrees();
    let ratio = without_noise(instant.speed_ratio, 1.0);
    let speed = without_noise(instant.inward_speed, instant.pin_velocity.norm());
    let [at_left, at_right] = [FOLLOWER, RELATIVE].map(|shade| Marker::new(shade, Mark::Disc).sized(11.0));
    let text = |text: String, marker: &Marker| Label::words(&text).shade(marker.shade);
    let name = Label::symbol("φ").and(&format!(" = {}", degrees(instant.crank_angle)));
    let written = [significant(ratio, 4), format!("{} {speed_unit}", significant(speed, 4))];
    let [ratio_text, speed_text] = written;
    panel
        .vertical(x, Stroke::thin("instant").dashed("3 4"))
        .marks([(x, ratio)], at_left)
        .marks_on(Side::Right, [(x, speed)], at_right)
        .near([(x, ratio)], FRAC_PI_4, text(ratio_text, &at_left))
        .near_on(Side::Right, [(x, speed)], FRAC_PI_4, text(speed_text, &at_right))
        .near_on(Side::Right, [(x, -0.9 * instant.pin_velocity.norm())], 0.0, name)
}
