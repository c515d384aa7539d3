//! The driver's speed over its angle, engagement by engagement, from rest and from above.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel, Spot};
use crate::escapement::speeds;
use crate::number::{degrees, describe_parameters, format_trimmed, significant};
use crate::svg::Label;
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::{Engagement, SteadyState};
use std::f64::consts::FRAC_PI_4;

/// Engagements from rest, and from above.
const SHOWN: usize = 3;
/// The start from above, in steady entry speeds.
const ABOVE: f64 = 2.0;
/// Marks of the angle to either side of the line of centres.
const MARKS: i32 = 3;
/// Every how many instants of the drawing are a row of the series.
const KEPT: usize = 6;
/// How the engagements from rest look, those from above, and the steady cycle.
const STROKES: [LineStyle; 3] = [
    LineStyle::new(DRIVER).wide(2.0).class("from-rest"),
    LineStyle::new(FOLLOWER).wide(2.0).dashed("8 4").class("from-above"),
    LineStyle::new(CORIOLIS).wide(3.4).dashed("2 4").class("cycle"),
];

/// What they are called.
const NAMES: [&str; 3] = ["from rest", "from twice the steady speed", "steady cycle"];

/// One engagement: angle in degrees and speed, and the switch.
struct Round {
    points: Vec<(f64, f64)>,
    switch: Option<(f64, f64)>,
    end: f64,
}

/// θ' over θ in successive engagements, from rest and from twice the steady speed at entry, with the steady cycle.
///
/// Speeds are over √(K / I_f). Marks show where the contact changes flank; there, and on the line of centres, the sign of
/// the friction changes. Series: θ, then θ' of the engagements from rest, of those from above, and in the steady cycle.
///
/// # Errors
///
/// [`FigureError`] if there is no steady motion or it cannot be followed.
pub fn phase(parameters: &Parameters) -> Result<Figure, FigureError> {
    let engagement = Engagement::new(parameters)?;
    let (steady, unit) = (engagement.steady_state()?, parameters.drive().sqrt());
    let half = parameters.mechanism().engagement_half_angle().to_degrees();
    let round = |entry: f64| -> Result<Round, FigureError> {
        let passage = engagement.passage(entry)?;
        let points: Vec<_> =
            speeds(parameters, entry)?.iter().map(|[theta, speed]| (theta.to_degrees(), speed / unit)).collect();
        let switch = passage.reversal_angle().map(|angle| {
            let angle = angle.to_degrees();
            let pair = points.windows(2).find(|pair| pair[0].0 <= angle && angle <= pair[1].0);
            let speed = pair.map_or(f64::NAN, |pair| {
                let share = (angle - pair[0].0) / (pair[1].0 - pair[0].0);
                pair[0].1 + share * (pair[1].1 - pair[0].1)
            });
            (angle, speed)
        });
        Ok(Round { points, switch: switch.filter(|(_, speed)| speed.is_finite()), end: passage.end_speed() })
    };
    let rounds = |mut entry: f64| -> Result<Vec<Round>, FigureError> {
        let mut rounds = Vec::new();
        for _ in 0..SHOWN {
            rounds.push(round(entry)?);
            entry = rounds.last().map_or(entry, |round| round.end);
        }
        Ok(rounds)
    };
    let (from_rest, from_above) = (rounds(0.0)?, rounds(ABOVE * steady.entry_speed)?);
    let cycle = round(steady.entry_speed)?;

    let panel = panel(half, [&from_rest, &from_above, std::slice::from_ref(&cycle)]);
    let series = series(&from_rest, &from_above, &cycle);
    Ok(Chart::new([panel]).figure(words(parameters, &steady, unit, &cycle), series))
}

/// All engagements over angles of ±`half` degrees, the first two of each kind numbered.
fn panel(half: f64, groups: [&[Round]; 3]) -> Panel {
    let all = groups.iter().flat_map(|rounds| rounds.iter()).flat_map(|round| &round.points);
    let symbol = Label::words("driver's speed ").and_rate("θ", 1).and(" over √(");
    let symbol = symbol.and_symbol("K").and("/").and_symbol("I").sub("f").and(")");
    let y = ChartAxis::from_zero(0.0, all.map(|point| point.1).fold(0.0, f64::max), 5.0).titled(symbol);
    let angle = Label::words("driver angle ").and_symbol("θ").and(" in degrees");
    let x = ChartAxis::of_engagement(half, MARKS).titled(angle);
    let mut panel = Panel::new(406.0, &x, &y).vertical(0.0, LineStyle::thin("centres").dashed("5 4"));
    for (rounds, stroke) in groups.iter().zip(STROKES) {
        panel = rounds.iter().fold(panel, |panel, round| panel.curve(round.points.iter().copied(), stroke));
    }
    for ((rounds, stroke), name) in groups.iter().zip(STROKES).zip(NAMES) {
        let marker = Marker::new(stroke.colour, MarkShape::Diamond).sized(10.0);
        panel = panel.marks(rounds.first().and_then(|round| round.switch), marker);
        for (number, round) in rounds.iter().take(2).enumerate().filter(|_| rounds.len() > 1) {
            let words = if number == 0 { format!("1, {name}") } else { (number + 1).to_string() };
            let label = Label::words(&words).in_colour(stroke.colour);
            panel = panel.name_near(round.points.get(round.points.len() / 10).copied(), FRAC_PI_4, label);
        }
    }
    let [from_rest, _, cycle] = groups;
    let switch = from_rest.first().and_then(|round| round.switch);
    panel = panel.name_near(switch, -FRAC_PI_4, Label::words("contact changes flank"));
    for round in cycle {
        let middle = round.points.iter().copied().skip(round.points.len() * 3 / 4);
        panel = panel.name_near(middle, FRAC_PI_4 * 3.0, Label::words(NAMES[2]).in_colour(STROKES[2].colour));
    }
    let shares = [0.72, 0.28].into_iter().flat_map(|x| [0.94, 0.06, 0.88, 0.12].map(|y| [x, y]));
    panel.name(Label::words("line of centres"), Spot::Free(shares.collect()))
}

fn series(from_rest: &[Round], from_above: &[Round], cycle: &Round) -> Series {
    let columns = [
        ("theta", "deg"),
        ("rest 1", "1"),
        ("rest 2", "1"),
        ("rest 3", "1"),
        ("above 1", "1"),
        ("above 2", "1"),
        ("above 3", "1"),
        ("steady", "1"),
    ];
    let all: Vec<&Round> = from_rest.iter().chain(from_above).collect();
    let rows = cycle.points.iter().enumerate().step_by(KEPT).map(|(k, (theta, speed))| {
        let of = |number: usize| all.get(number).and_then(|round| round.points.get(k)).map_or(0.0, |point| point.1);
        [*theta, of(0), of(1), of(2), of(3), of(4), of(5), *speed]
    });
    Series::new(columns, rows)
}

fn words(parameters: &Parameters, steady: &SteadyState, unit: f64, cycle: &Round) -> Words {
    let switch = cycle.switch.map_or(String::new(), |(angle, _)| {
        format!(
            " Past the line of centres the contact changes flank at {} in the steady cycle.",
            degrees(angle.to_radians())
        )
    });
    Words::new(
        "steady-phase",
        "The driver's speed over its angle, engagement by engagement",
        format!(
            "Speed over angle for {} pins and μ = {}, for three engagements from rest, three from twice the steady \
             speed, and the steady cycle, which enters at {}, falls to {} and rises to {}. The curves from rest \
             approach the cycle from below, the other curves from above; the third of each is close to the steady \
             cycle.{switch}",
            parameters.mechanism().pins(),
            format_trimmed(parameters.friction(), 4),
            significant(steady.entry_speed / unit, 3),
            significant(steady.minimum.speed / unit, 3),
            significant(steady.peak.speed / unit, 3)
        ),
        format!(
            "Three successive engagements from rest (numbered), and three from twice the steady speed. Each begins at \
             the left with the speed at which the one before it ended at the right. The third of each series is close \
             to the steady cycle. At the diamonds the follower begins to run ahead of the pin, and the contact changes \
             flank. {}",
            describe_parameters(parameters)
        ),
    )
}
