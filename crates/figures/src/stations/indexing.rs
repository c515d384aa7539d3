//! Position, velocity and acceleration of the wheel over one advance.

use crate::chart::{Axis, Chart, Mark, Marker, Panel, Side, Stroke};
use crate::number::{degrees, significant, with_minus_sign, without_noise};
use crate::svg::Label;
use crate::theme::{DRIVER, FOLLOWER, INK, RELATIVE, Shade};
use crate::{Figure, Series, Words};
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use std::f64::consts::{FRAC_PI_2, PI};

/// Rows of the series: at least so many steps, and none longer than a degree.
const LEAST_STEPS: u32 = 90;
/// Degrees between marks of the crank angle.
const MARKS: f64 = 15.0;
/// Degrees of dwell shown before and after the advance, if there are so many.
const DWELL: f64 = 8.0;
/// The dots of the acceleration at entry and exit.
const END: Marker = Marker::new(DRIVER, Mark::Disc).sized(11.0).class("indexing-end");

/// φ in radians, φ'/θ' and φ''/θ'² against θ in degrees, from entry to exit, for a driver of constant speed.
///
/// φ and φ'/θ' are read at the left, φ''/θ'² at the right; zero is at one height. A little of the dwell is shown on
/// both sides, so that the jumps of the acceleration at entry and exit can be seen: a filled dot on the advance, an
/// open one on the dwell. Series, in equal steps of at most a degree, both ends included: θ, φ, φ'/θ', φ''/θ'².
pub fn indexing(wheel: &Wheel) -> Figure {
    let rows = rows(wheel);
    let (alpha, peak) = (wheel.half_pitch_angle(), acceleration_peak(wheel));
    let most = wheel.engagement_half_angle().to_degrees();
    let rest = DWELL.min((PI / f64::from(wheel.pins())).to_degrees() - most).max(0.0);
    let panel = curves(wheel, &rows, most, rest);
    let words = Words::new(
        "wheel-indexing",
        format!("Position, velocity and acceleration of a wheel with {} stations", wheel.stations()),
        format!(
            "Three curves over the crank angle from {} to {}. The wheel's angle rises from {} rad to {} rad. Its \
             velocity ratio rises from zero to {} on the line of centres and falls back to zero. Its acceleration ratio \
             jumps from zero to {} at entry, rises to {} at {}, falls through zero on the line of centres to the \
             opposite values, and jumps back to zero at exit.",
            degrees(-most.to_radians()),
            degrees(most.to_radians()),
            with_minus_sign(&significant(-alpha, 4)),
            significant(alpha, 4),
            significant(peak_velocity(wheel), 4),
            significant(entry_acceleration(wheel), 4),
            significant(peak.ratio, 4),
            degrees(-peak.angle)
        ),
        "One advance at constant driver speed: the wheel's angle, and its velocity and acceleration over the driver's \
         speed and its square. The acceleration jumps at both ends; there the jerk is infinite.",
    );
    let columns = [("theta", "deg"), ("phi", "rad"), ("phi'/theta'", "1"), ("phi''/theta'^2", "1")];
    Chart::new([panel]).figure(words, Series::new(columns, rows))
}

/// θ in degrees, φ in radians, φ'/θ', φ''/θ'²; from entry to exit, both included, symmetric to the last bit.
pub(super) fn rows(wheel: &Wheel) -> Vec<[f64; 4]> {
    let half = wheel.engagement_half_angle();
    let steps = LEAST_STEPS.max(libm::ceil(2.0 * half.to_degrees() - 1e-9) as u32);
    let row = |k: u32| {
        // The share is exactly one at both ends.
        let theta = half * ((2.0 * f64::from(k) - f64::from(steps)) / f64::from(steps));
        let motion = wheel.engaged(theta).ok()?;
        let velocity = without_noise(motion.velocity, 1.0);
        Some([theta.to_degrees(), motion.angle, velocity, motion.acceleration])
    };
    (0..=steps).filter_map(row).collect()
}

/// The three curves with their names; entry and exit at ±`most` degrees, with so much of the dwell beyond.
fn curves(wheel: &Wheel, rows: &[[f64; 4]], most: f64, rest: f64) -> Panel {
    let (alpha, end) = (wheel.half_pitch_angle(), most + rest);
    let count = ((end + 1e-9) / MARKS) as i32;
    let angle = Label::words("crank angle ").and_symbol("θ").and(" in degrees");
    let x = Axis::whole(-end..end, (-count..=count).map(|k| MARKS * f64::from(k))).titled(angle);
    let [position, velocity, acceleration] = symbols();
    let left = Axis::symmetric(alpha.max(peak_velocity(wheel)));
    let right = Axis::symmetric(acceleration_peak(wheel).ratio).titled(acceleration.clone());
    let dwells = rest > 0.0;
    let column = |k: usize| rows.iter().map(move |row| (row[0], row[k]));
    let extended = |k: usize, value: f64| {
        let before = dwells.then_some((-end, -value));
        before.into_iter().chain(column(k)).chain(dwells.then_some((end, value)))
    };
    let driver = Stroke::new(DRIVER).dashed("12 6");
    let mut panel = Panel::new(366.0, &x, &left.titled(position.clone().and(", ").and_label(&velocity).shade(INK)))
        .right(right)
        .curve(extended(1, alpha), Stroke::new(RELATIVE).dashed("3 5"))
        .curve(extended(2, 0.0), Stroke::new(FOLLOWER))
        .curve_on(Side::Right, column(3), driver);
    for (sense, jump, name) in [(-1.0, entry_acceleration(wheel), "entry"), (1.0, -entry_acceleration(wheel), "exit")] {
        let theta = sense * most;
        if dwells {
            let jumps = Stroke::new(DRIVER).wide(1.3).dashed("2 3").class("jump");
            panel = panel
                .vertical(theta, Stroke::thin("end").wide(1.0).dashed("1 4"))
                .curve_on(Side::Right, [(sense * end, 0.0), (theta, 0.0)], driver.class("dwell"))
                .curve_on(Side::Right, [(theta, 0.0), (theta, jump)], jumps)
                .marks([(theta, 0.0)], Marker { mark: Mark::Ring, ..END }.sized(10.0).class("dwell-end"));
        }
        panel = panel.marks_on(Side::Right, [(theta, jump)], END);
        if dwells {
            let foot = 0.94 * panel_foot(wheel);
            panel = panel.near([(theta, foot)], if sense < 0.0 { 0.0 } else { PI }, Label::words(name));
        }
    }
    let part =
        |from: f64, to: f64| rows.iter().filter(move |row| row[0] >= from * most && row[0] <= to * most).step_by(3);
    panel
        .near(part(0.1, 0.5).map(|row| (row[0], row[2])), 0.5, velocity)
        .near(part(0.5, 1.0).map(|row| (row[0], row[1])), FRAC_PI_2, position)
        .near_on(Side::Right, part(-1.0, -0.1).map(|row| (row[0], row[3])), PI - 0.5, acceleration)
}

/// The least value of the left axis.
fn panel_foot(wheel: &Wheel) -> f64 {
    Axis::symmetric(wheel.half_pitch_angle().max(peak_velocity(wheel))).range.start
}

/// The symbols of the three curves: φ, φ'/θ' and φ''/θ'².
fn symbols() -> [Label; 3] {
    let shaded = |shade: Shade| Label::symbol("φ").shade(shade);
    [
        shaded(RELATIVE).and(" in rad"),
        shaded(FOLLOWER).and("′ / ").and_symbol("θ").and("\u{200a}′"),
        shaded(DRIVER).and("″ / ").and_symbol("θ").and("\u{200a}′²"),
    ]
}
