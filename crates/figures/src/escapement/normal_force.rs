//! The force between pin and slot over one engagement, and where the contact changes flank.

use super::engagement::{EngagementState, STEPS, speeds};

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel, Spot};
use crate::number::{degrees, describe_parameters, extent, short, without_noise};
use crate::svg::Label;
use crate::theme::{DRIVER, FILL, FOLLOWER, PAPER};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use std::f64::consts::{FRAC_PI_2, PI};

/// Marks of the angle to either side of the line of centres.
const MARKS: i32 = 3;

/// What is shown of an instant.
type Value = fn(&EngagementState) -> f64;

/// The normal force F, as F R / K, and the size of the friction's torque, −τ₂ / K, for a pin that enters at this speed
/// (θ' ≥ 0).
///
/// The motion between is that of the equation of motion. Strips under the plot tell the flank that the pin bears on
/// and the sign of C θ'² + D θ'', what stands between the bars. Series, from entry to exit: θ, θ', F R/K, −τ₂/K,
/// what stands between the bars over E = K / I_f.
///
/// # Errors
///
/// [`FigureError::Dynamics`] if the speed is negative or so great that the motion cannot be followed, or if the equation
/// of motion has no single solution.
pub fn normal_force(parameters: &Parameters, entry_speed: f64) -> Result<Figure, FigureError> {
    let change = Engagement::new(parameters)?.passage(entry_speed)?.reversal_angle();
    let half = parameters.mechanism().engagement_half_angle();
    let instants: Vec<EngagementState> = speeds(parameters, entry_speed)?
        .into_iter()
        .map(|[theta, speed]| EngagementState::new(parameters, theta, speed))
        .collect::<Result<_, _>>()?;
    let x = ChartAxis::of_engagement(half.to_degrees(), MARKS);
    let angle = Label::words("driver angle ").and_symbol("θ").and(" in degrees");
    let flank = Label::words("pin bears on");
    let bars = Label::words("sign of ").and_symbol("C\u{2009}").and_rate("θ", 1);
    let bars = bars.and("² + ").and_symbol("D\u{2009}").and_rate("θ", 2);
    let panels = [
        forces(&x.clone().titled(angle), &instants, change),
        strip(&x, flank, &ends(-half, &[change], half), 1.0, ["leading flank", "trailing flank"]),
        if parameters.friction() > 0.0 {
            // Past the line of centres the pin slides outwards, and the sum changes sign with the force.
            strip(&x, bars, &ends(-half, &[Some(0.0), change], half), -1.0, ["+", "−"])
        } else {
            strip(&x, bars.and(": zero, for there is no friction"), &[], 1.0, ["+", "−"])
        },
    ];

    let columns = [("theta", "deg"), ("theta'", "1/time"), ("F R/K", "1"), ("-tau_2/K", "1"), ("bars/E", "1")];
    let rows = instants.iter().map(|at| {
        let [normal, friction, bars] = [at.normal, at.friction, at.bars].map(|value| without_noise(value, 1.0));
        [at.theta.to_degrees(), at.speed, normal, friction, bars]
    });
    let greatest = |value: Value| instants.iter().map(value).fold(0.0, f64::max);
    let words = Words::new(
        "escapement-normal-force",
        format!("Force between pin and slot over one engagement, {} slots", parameters.mechanism().slots()),
        format!(
            "Over the driver angle from entry, {}, to exit, {}: the normal force F, as F R / K, at most {} and at \
             least {}, and the size of the friction's torque over K, at most {}. {} Under the plot, strips show the \
             flank and the sign of the quantity between the bars of the equation of motion.",
            degrees(-half),
            degrees(half),
            short(greatest(|at| at.normal), 3),
            short(-greatest(|at| -at.normal), 3),
            short(greatest(|at| at.friction), 3),
            change.map_or("The pin bears on one flank throughout.".to_owned(), |change| format!(
                "The pin changes its flank at θ = {}.",
                degrees(change)
            ))
        ),
        format!(
            "One engagement of the steady state. At first the pin drives the follower (F positive). Then the follower runs \
             ahead and drives the pin, and F changes its sign with the flank. The friction opposes the motion on \
             either flank, so its torque τ₂ is never positive. The dashed curve shows the size of this torque, −τ₂. \
             The quantity between the bars of (1-19) changes its sign with the flank, and also on the line of centres, \
             where the sliding reverses. {}",
            describe_parameters(parameters)
        ),
    );
    Ok(Chart::new(panels).figure(words, Series::new(columns, rows)))
}

/// The ends of the parts of an engagement that these angles make.
fn ends(first: f64, changes: &[Option<f64>], last: f64) -> Vec<f64> {
    std::iter::once(first).chain(changes.iter().copied().flatten()).chain([last]).collect()
}

/// Both curves, and where the flank changes.
fn forces(x: &ChartAxis, instants: &[EngagementState], change: Option<f64>) -> Panel {
    let values = || instants.iter().flat_map(|at| [at.normal, at.friction]);
    let [least, most] = extent(values().chain([0.0]));
    let y = ChartAxis::from_zero(least, most, 4.0);
    let y = y.titled(Label::words("moments in torques ").and_symbol("K").and(" of the spring"));
    // Where the words about the change of the flank stand: high above the curves there.
    let aloft = 0.75 * y.range.end;
    let mut panel = Panel::new(336.0, x, &y).horizontal(0.0, LineStyle::thin("zero"));
    let normal = Label::symbol("F").and_symbol("\u{2009}R").and(" / ").and_symbol("K");
    let friction = Label::words("friction −").and_symbol("τ").sub("2").and(" / ").and_symbol("K");
    let curves: [(Value, LineStyle, Label); 2] = [
        (|at| at.normal, LineStyle::new(FOLLOWER), normal.in_colour(FOLLOWER)),
        (|at| at.friction, LineStyle::new(DRIVER).dashed("10 6"), friction.in_colour(DRIVER)),
    ];
    let points = |value: Value| instants.iter().map(move |at| (at.theta.to_degrees(), value(at)));
    for (value, stroke, _) in &curves {
        panel = panel.curve(points(*value), *stroke);
    }
    if let Some(change) = change {
        let marker = Marker::new(FOLLOWER, MarkShape::Ring).sized(10.0);
        panel = panel.vertical(change.to_degrees(), LineStyle::thin("switch").dashed("5 4"));
        panel = panel.marks([(change.to_degrees(), 0.0)], marker);
        let label = Label::words("flank changes: ").and_symbol("θ").and(&format!(" = {}", degrees(change)));
        panel = panel.name_near([(change.to_degrees(), aloft)], PI, label);
    }
    for ((value, _, label), (share, side)) in curves.into_iter().zip([(0.25, FRAC_PI_2), (0.06, -FRAC_PI_2)]) {
        let first = (share * f64::from(STEPS)) as usize;
        panel = panel.name_near(points(value).skip(first).step_by(12), side, label);
    }
    panel
}

/// A strip: its name, and its parts with the words for a positive and for a negative value, the first of this sign.
fn strip(x: &ChartAxis, name: Label, ends: &[f64], mut sign: f64, words: [&str; 2]) -> Panel {
    let y = ChartAxis::whole(0.0..1.0, []).titled(name);
    let mut panel = Panel::new(30.0, &ChartAxis { ticks: Vec::new(), ..x.clone() }, &y);
    for part in ends.windows(2).map(|pair| [pair[0].to_degrees(), pair[1].to_degrees()]) {
        let (colour, class, word) =
            if sign > 0.0 { (FILL, "positive", words[0]) } else { (PAPER, "negative", words[1]) };
        panel = panel.band(part[0]..part[1], colour, class).vertical(part[0], LineStyle::thin("end"));
        panel = panel.name(Label::words(word).bare(), Spot::Within(part[0]..part[1], 0.5));
        sign = -sign;
    }
    panel
}
