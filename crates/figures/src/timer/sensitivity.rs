//! What one per cent more of torque, friction or inertia does to the rate.

use super::{Curve, MINUTES, Tested, axis, key, of_friction};
use crate::chart::{Chart, ChartAxis, LineStyle, Panel, of_mechanism};
use crate::number::{extent, format_trimmed, with_minus_sign};
use crate::svg::Label;
use crate::theme::INK;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
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
    let curves = all.iter().map(|one| one.curve(ends, STEPS, quantities)).collect::<Result<Vec<_>, _>>()?;
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let of = |k: usize| points().map(move |point| point.values[k]);
    let all_values = || (0..CHANGED.len()).flat_map(of);
    let [lowest, highest] = extent(all_values().chain([0.0]));
    let y = ChartAxis::from_zero(ROOM * lowest, highest, 5.0);
    let y = y.titled(Label::words("gain for 1 % more, minutes a day"));
    let mut panel = Panel::new(430.0, &x, &y).horizontal(0.0, LineStyle::thin("none"));
    for Curve { slots, points, marks } in &curves {
        let (stroke, marker) = of_mechanism(*slots);
        for k in 1..CHANGED.len() {
            panel = panel.curve(points.iter().map(|point| point.at(k)), stroke.wide(2.0).class("gain"));
            panel = panel.marks(marks.iter().map(|point| point.at(k)), marker.sized(7.0));
        }
    }
    // The torque's is the same for all.
    let torque = of(0).next().unwrap_or_default();
    panel = panel.curve(ends.map(|friction| (friction, torque)), LineStyle::new(INK).class("of-torque"));
    for (k, (name, side)) in CHANGED.iter().enumerate() {
        let middle = (ends[0] + ends[1]) / 2.0;
        let [least, most] = extent(of(k));
        let height = if *side > 0.0 { most } else { least };
        panel = panel.name_near([(middle, height)], *side, Label::words(name));
    }
    let said = CHANGED.iter().enumerate().map(|(k, (name, _))| {
        let minutes = |value: f64| with_minus_sign(&format_trimmed(value, 1));
        let [least, most] = extent(of(k)).map(minutes);
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
    let series = Series::of_items(
        points(),
        [
            ("pins", "1", |point| point.pins),
            ("mu", "1", |point| point.friction),
            ("gain K", "min", |point| point.values[0]),
            ("gain mu", "min", |point| point.values[1]),
            ("gain I_D", "min", |point| point.values[2]),
            ("gain I_f", "min", |point| point.values[3]),
        ],
    );
    Ok(Chart::new([panel]).key(key(all)).figure(words, series))
}

/// Minutes a day that one per cent more of each of [`CHANGED`] gains.
fn quantities(parameters: &Parameters) -> Result<[f64; 4], FigureError> {
    let found = Sensitivities::new(parameters)?;
    let powers = [found.torque, found.friction, found.driver_inertia, found.follower_inertia];
    Ok(powers.map(|power| MINUTES * power / 100.0))
}
