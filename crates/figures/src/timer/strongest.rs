//! The greatest accelerations and forces of the steady motion over the friction.

use super::{Curve, Tested, axis, key, of_friction};
use crate::chart::{Chart, ChartAxis, Panel, Spot, of_mechanism};
use crate::number::{extent, significant};
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::timer::Accelerations;

const STEPS: u32 = 15;
/// The quantities of the panels.
const PANELS: usize = 4;

/// The greatest accelerations of driver and follower, the jump of the follower's acceleration as the next pin takes over,
/// and the greatest force on the pin, over the friction.
///
/// Accelerations are times I_f / K and forces over K / R, so that the curves hold for every torque. Sizes, without signs.
/// Marks are the frictions of the runs. Series: pins, friction, and the four quantities.
///
/// # Errors
///
/// [`FigureError`] if an escapement has no steady motion, or there is none.
pub fn strongest(all: &[Tested]) -> Result<Figure, FigureError> {
    let x = axis(all)?;
    let ends = super::frictions(all)?;
    let curves = all.iter().map(|one| one.curve(ends, STEPS, quantities)).collect::<Result<Vec<_>, _>>()?;
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let of = |k: usize| points().map(move |point| point.values[k]);
    let scaled = |words: &str, symbol: &str| {
        Label::words(words).and_rate(symbol, 2).and(" × ").and_symbol("I").sub("f").and(" / ").and_symbol("K")
    };
    let titles = [
        scaled("driver's acceleration ", "θ"),
        scaled("follower's acceleration ", "φ"),
        scaled("follower's jump of ", "φ"),
        Label::words("pin force ").and_symbol("F\u{2009}R").and(" / ").and_symbol("K"),
    ];
    let panels = titles.into_iter().enumerate().map(|(k, title)| {
        let y = ChartAxis::from_zero(0.0, of(k).fold(0.0, f64::max), 3.0).titled(title);
        let x = if k + 1 == PANELS { x.clone().titled(of_friction()) } else { x.clone().unnumbered() };
        curves.iter().fold(Panel::new(185.0, &x, &y), |panel, Curve { slots, points, marks }| {
            let (stroke, marker) = of_mechanism(*slots);
            let panel = panel
                .curve(points.iter().map(|point| point.at(k)), stroke.wide(2.2).class("greatest"))
                .marks(marks.iter().map(|point| point.at(k)), marker.sized(8.0));
            let Some(last) = points.last() else { return panel };
            let name = Label::words(&last.pins.to_string()).in_colour(marker.colour);
            panel.name(name, Spot::Beside(last.values[k]))
        })
    });
    let range = |k: usize| extent(of(k)).map(|value| significant(value, 3));
    let said =
        ["driver's acceleration", "follower's acceleration", "its jump", "force on the pin"].into_iter().enumerate();
    let said = said.map(|(k, name)| {
        let [least, most] = range(k);
        format!("{name} {least} to {most}")
    });
    let words = Words::new(
        "timer-strongest",
        "The greatest accelerations and forces over the friction",
        format!(
            "Four panels over the coefficient of friction, in each a curve for every mechanism, most of them falling. In units \
             of K / I f and of K / R: {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        format!(
            "The greatest magnitudes of the accelerations, of the jump of the follower's acceleration and of the force \
             on the pin in the steady motion. The accelerations are multiplied by the follower's inertia and \
             divided by the torque, and the force is divided by the spring's force at the crank radius. So each curve \
             holds for every spring. For four pins, the driver's curve has a kink. To the right of it, the driver's \
             greatest deceleration (by friction) exceeds the driver's greatest acceleration (by the follower). The \
             marks are at the friction values of the thesis's runs. {}",
            super::inertias(all)
        ),
    );
    let series = Series::of_items(
        points(),
        [
            ("pins", "1", |point| point.pins),
            ("mu", "1", |point| point.friction),
            ("theta'' I_f/K", "1", |point| point.values[0]),
            ("phi'' I_f/K", "1", |point| point.values[1]),
            ("jump I_f/K", "1", |point| point.values[2]),
            ("F R/K", "1", |point| point.values[3]),
        ],
    );
    Ok(Chart::new(panels).key(key(all)).figure(words, series))
}

/// Sizes of the quantities of the panels.
fn quantities(parameters: &Parameters) -> Result<[f64; 4], FigureError> {
    let found = Accelerations::new(parameters)?;
    let [driver, follower, jump] =
        [found.driver.value, found.follower.value, found.jump].map(|a| a.abs() / parameters.drive());
    Ok([driver, follower, jump, found.normal_moment.value.abs() / parameters.torque()])
}
