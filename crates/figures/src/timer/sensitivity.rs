//! What one per cent more of torque, friction or inertia does to the rate.

use super::{MINUTES, Tested, axis, key, of_friction};
use crate::chart::{Axis, Chart, Panel, Stroke, of_mechanism};
use crate::number::{trimmed, with_minus_sign};
use crate::svg::Label;
use crate::theme::INK;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::timer::Sensitivities;
use std::f64::consts::FRAC_PI_2;

const STEPS: u32 = 12;
/// The y axis goes so many times as far down as the lowest curve: its name stands below it.
const ROOM: f64 = 1.2;
/// What is changed by one per cent, and on which side of the curves its name stands.
const CHANGED: [(&str, f64); 4] = [
    ("torque", FRAC_PI_2),
    ("friction", FRAC_PI_2),
    ("driver's inertia", FRAC_PI_2),
    ("follower's inertia", -FRAC_PI_2),
];

/// Minutes that the escapement gains in a day for one per cent more of each quantity, over the friction.
///
/// Curves for torque, friction and the two inertias, in the colours of the mechanisms; that of the torque is the same for
/// all. Marks are the frictions of the runs. Series: pins, friction, and the gain in minutes for torque, friction, driver's
/// and follower's inertia.
///
/// # Errors
///
/// [`FigureError`] if an escapement has no steady motion, or there is none.
pub fn sensitivity(all: &[Tested]) -> Result<Figure, FigureError> {
    let x = axis(all)?.titled(of_friction());
    let ends = super::frictions(all)?;
    let mut rows: Vec<[f64; 6]> = Vec::new();
    let mut curves = Vec::new();
    for one in all {
        let row = |friction: f64| {
            let found = Sensitivities::new(&one.with(friction)?)?;
            let powers = [found.torque, found.friction, found.driver_inertia, found.follower_inertia];
            let [a, b, c, d] = powers.map(|power| MINUTES * power / 100.0);
            Ok([f64::from(one.parameters.mechanism().pins()), friction, a, b, c, d])
        };
        let curve: Vec<[f64; 6]> =
            one.steps(ends[0], ends[1], STEPS)?.into_iter().map(row).collect::<Result<_, FigureError>>()?;
        let marks = one.frictions.iter().copied().map(row).collect::<Result<Vec<_>, FigureError>>()?;
        rows.extend(curve.iter());
        curves.push((one, curve, marks));
    }
    let of = |k: usize| rows.iter().map(move |row| row[2 + k]);
    let all_values = || (0..CHANGED.len()).flat_map(of);
    let y = Axis::from_zero(ROOM * all_values().fold(0.0, f64::min), all_values().fold(0.0, f64::max), 5.0);
    let y = y.titled(Label::words("gain for 1 % more, minutes a day"));
    let mut panel = Panel::new(430.0, &x, &y).horizontal(0.0, Stroke::thin("none"));
    for (one, curve, marks) in &curves {
        let (stroke, marker) = of_mechanism(one.parameters.mechanism().slots());
        for k in 1..CHANGED.len() {
            panel = panel.curve(curve.iter().map(|row| (row[1], row[2 + k])), stroke.wide(2.0).class("gain"));
            panel = panel.marks(marks.iter().map(|row| (row[1], row[2 + k])), marker.sized(7.0));
        }
    }
    // The torque's is the same for all.
    let torque = rows.first().map_or(0.0, |row| row[2]);
    panel = panel.curve(ends.map(|friction| (friction, torque)), Stroke::new(INK).class("of-torque"));
    for (k, (name, side)) in CHANGED.iter().enumerate() {
        let middle = (ends[0] + ends[1]) / 2.0;
        let values = || curves.iter().flat_map(|(_, curve, _)| curve.iter()).map(|row| row[2 + k]);
        let height = if *side > 0.0 {
            values().fold(f64::NEG_INFINITY, f64::max)
        } else {
            values().fold(f64::INFINITY, f64::min)
        };
        panel = panel.near([(middle, height)], *side, Label::words(name));
    }
    let said = CHANGED.iter().enumerate().map(|(k, (name, _))| {
        let minutes = |value: f64| with_minus_sign(&trimmed(value, 1));
        let [least, most] = [of(k).fold(f64::INFINITY, f64::min), of(k).fold(f64::NEG_INFINITY, f64::max)].map(minutes);
        if least == most { format!("{name} {least}") } else { format!("{name} {least} to {most}") }
    });
    let words = Words::new(
        "timer-sensitivity",
        "Minutes that the timer gains in a day for one per cent more of each quantity",
        format!(
            "Four groups of curves over the coefficient of friction, one curve for each mechanism. Minutes a day for one per \
             cent more: {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        format!(
            "What one per cent more of each quantity does to the rate. The gain from one per cent more torque is the \
             same for every mechanism at every friction, so its line is level. It is also the same for weak and strong \
             springs. More friction costs about as much as more torque gains (somewhat less with four pins), and more \
             inertia of the follower costs most. The marks are at the friction values of the thesis's runs. {}",
            super::inertias(all)
        ),
    );
    let columns =
        [("pins", "1"), ("mu", "1"), ("gain K", "min"), ("gain mu", "min"), ("gain I_D", "min"), ("gain I_f", "min")];
    Ok(Chart::new([panel]).key(key(all)).figure(words, Series::new(columns, rows)))
}
