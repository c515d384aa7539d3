//! Hours that the escapement gains or loses in a day as its friction changes.

use super::{HOURS, Tested, key, of_friction};
use crate::chart::{Chart, ChartAxis, LineStyle, Panel, Spot, of_mechanism};
use crate::number::{extent, format_trimmed};
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::timer::speed_change;

const STEPS: u32 = 50;
/// How far the x axis goes beyond what is shown, as a part of the friction.
const ROOM: f64 = 0.04;

/// The gain in a day over the coefficient of friction, of escapements that were set right at the friction `set`.
///
/// Marks are the frictions of the runs; `pairs` are frictions of materials and lubricants, with their names, which get a
/// line each. Series, a row for each point of a curve: pins, friction, gain in hours.
///
/// # Errors
///
/// [`FigureError`] if an escapement has no steady motion, or there is none.
pub fn friction(all: &[Tested], set: f64, pairs: &[(f64, &str)]) -> Result<Figure, FigureError> {
    let [mut least, mut most] = super::frictions(all)?;
    for (friction, _) in pairs {
        (least, most) = (least.min(*friction), most.max(*friction));
    }
    let range = least * (1.0 - ROOM)..most * (1.0 + ROOM);
    let steps = ChartAxis::spanning(least, most, 5.0);
    let ticks = steps.ticks.iter().copied().filter(|mark| range.contains(mark)).collect();
    let x = ChartAxis { ticks, range, ..steps }.titled(of_friction());
    let mut rows: Vec<[f64; 3]> = Vec::new();
    let mut curves = Vec::new();
    for one in all {
        let own = one.with_friction(set)?;
        let gain = |friction: f64| Ok((friction, HOURS * speed_change(&own, friction)?));
        let curve: Vec<(f64, f64)> =
            one.steps(least, most, STEPS)?.into_iter().map(gain).collect::<Result<_, FigureError>>()?;
        let marks = one.frictions.iter().copied().map(gain).collect::<Result<Vec<_>, FigureError>>()?;
        let pins = f64::from(one.parameters.mechanism().pins());
        rows.extend(curve.iter().map(|(friction, gain)| [pins, *friction, *gain]));
        curves.push((one, curve, marks));
    }
    let gains = || rows.iter().map(|row| row[2]);
    let [low, high] = extent(gains().chain([0.0]));
    let y = ChartAxis::from_zero(low, high, 5.0).titled(Label::words("gain, hours a day"));
    let mut panel = Panel::new(400.0, &x, &y).horizontal(0.0, LineStyle::thin("set"));
    for (friction, _) in pairs {
        panel = panel.vertical(*friction, LineStyle::thin("pair").dashed("5 4"));
    }
    for (one, curve, marks) in &curves {
        let (stroke, marker) = of_mechanism(one.parameters.mechanism().slots());
        panel = panel.curve(curve.iter().copied(), stroke.wide(2.2).class("rate"));
        panel = panel.marks(marks.iter().copied(), marker.sized(8.0));
        if let Some((_, gain)) = curve.last() {
            let name = Label::words(&one.parameters.mechanism().pins().to_string()).in_colour(marker.colour);
            panel = panel.name(name, Spot::Beside(*gain));
        }
    }
    // Above the curves, which fall.
    let share = |friction: f64| x.share(friction);
    for (friction, name) in pairs {
        let side = if share(*friction) > 0.7 { -0.13 } else { 0.13 };
        let places = (0..8).map(|step| [share(*friction) + side, 0.93 - 0.06 * f64::from(step)]);
        panel = panel.name(Label::words(name), Spot::Free(places.collect()));
    }
    let said = curves.iter().filter_map(|(one, curve, _)| {
        let (first, last) = (curve.first()?, curve.last()?);
        let hours = |gain: f64| crate::number::with_minus_sign(&format_trimmed(gain, 1));
        let pins = one.parameters.mechanism().pins();
        let [from, to] = [first, last]
            .map(|(friction, gain)| format!("{} hours at μ = {}", hours(*gain), format_trimmed(*friction, 2)));
        Some(format!("with {pins} pins from {from} to {to}"))
    });
    let words = Words::new(
        "timer-friction",
        "What the escapement gains or loses in a day as the friction changes",
        format!(
            "Three falling curves over the coefficient of friction, which cross at μ = {}, where the escapements were \
             set. The gain a day falls {}. Three vertical lines mark the frictions of a pair of materials.",
            format_trimmed(set, 2),
            said.collect::<Vec<_>>().join(", ")
        ),
        format!(
            "How the rate of the three mechanisms, set right at μ = {}, changes with the friction in the slot. The \
             rate is computed from the exact steady motion at each friction. The marks are at the friction values of \
             the thesis's runs. The dashed lines are at handbook values for steel on brass ({}), which are static and \
             only a guide, because the pin slides. {}",
            format_trimmed(set, 2),
            pairs
                .iter()
                .map(|(friction, name)| format!("{name} {}", format_trimmed(*friction, 2)))
                .collect::<Vec<_>>()
                .join(", "),
            super::inertias(all)
        ),
    );
    let columns = [("pins", "1"), ("mu", "1"), ("gain", "h")];
    Ok(Chart::new([panel]).key(key(all)).figure(words, Series::new(columns, rows)))
}
