//! The greatest accelerations and forces of the steady motion over the friction.

use super::{Tested, axis, key, of_friction};
use crate::chart::{Axis, Chart, Panel, Spot, of_mechanism};
use crate::number::significant;
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};
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
    let mut rows: Vec<[f64; 6]> = Vec::new();
    let mut curves = Vec::new();
    for one in all {
        let row = |friction: f64| {
            let of = one.with(friction)?;
            let found = Accelerations::new(&of)?;
            let [driver, follower, jump] =
                [found.driver.value, found.follower.value, found.jump].map(|a| a.abs() / of.drive());
            let force = found.normal_moment.value.abs() / of.torque();
            Ok([f64::from(one.parameters.mechanism().pins()), friction, driver, follower, jump, force])
        };
        let curve: Vec<[f64; 6]> =
            one.steps(ends[0], ends[1], STEPS)?.into_iter().map(row).collect::<Result<_, FigureError>>()?;
        let marks = one.frictions.iter().copied().map(row).collect::<Result<Vec<_>, FigureError>>()?;
        rows.extend(curve.iter());
        curves.push((one, curve, marks));
    }
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
        let most = rows.iter().map(|row| row[2 + k]).fold(0.0, f64::max);
        let y = Axis::from_zero(0.0, most, 3.0).titled(title);
        let x = if k + 1 == PANELS { x.clone().titled(of_friction()) } else { x.clone().unnumbered() };
        curves.iter().fold(Panel::new(185.0, &x, &y), |panel, (one, curve, marks)| {
            let (stroke, marker) = of_mechanism(one.parameters.mechanism().slots());
            let panel = panel
                .curve(curve.iter().map(|row| (row[1], row[2 + k])), stroke.wide(2.2).class("greatest"))
                .marks(marks.iter().map(|row| (row[1], row[2 + k])), marker.sized(8.0));
            let name = Label::words(&one.parameters.mechanism().pins().to_string()).in_colour(marker.colour);
            panel.name(name, Spot::Beside(curve.last().map_or(0.0, |row| row[2 + k])))
        })
    });
    let range = |k: usize| {
        let values = || rows.iter().map(|row| row[2 + k]);
        [values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max)].map(|value| significant(value, 3))
    };
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
            "The greatest accelerations and the greatest force on the pin in the steady motion, without their signs. \
             The accelerations are multiplied by the follower's inertia and divided by the torque, and the force is \
             divided by the spring's force at the crank radius. So each curve holds for every spring. The kink in the \
             four-pin curve is where the driver's greatest deceleration, caused by friction, overtakes its greatest \
             acceleration, caused by the follower pushing it forward. The marks are at the friction values of the \
             thesis's runs. {}",
            super::inertias(all)
        ),
    );
    let columns =
        [("pins", "1"), ("mu", "1"), ("theta'' I_f/K", "1"), ("phi'' I_f/K", "1"), ("jump I_f/K", "1"), ("F R/K", "1")];
    Ok(Chart::new(panels).key(key(all)).figure(words, Series::new(columns, rows)))
}
