//! Speeds of driver and follower over time, from rest.

use crate::chart::{Chart, ChartAxis, LegendEntry, LineStyle, MarkShape, Marker, Panel};
use crate::number::{format_fixed, significant};
use crate::svg::Label;
use crate::theme::{DRIVER, FOLLOWER, INK};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Pose;
use geneva_dynamics::steady::{Engagement, Extreme};
use geneva_kinematics::Turn;

/// Engagements that are shown, lines of the run in each, and every how many of them is a row of the series.
const ENGAGEMENTS: usize = 5;
const LINES: f64 = 200.0;
const KEPT: usize = 5;
/// The driver has reached its steady motion where an engagement ends so near it.
const SETTLED: f64 = 1e-9;

/// The driver's first minimum from rest: in the first engagement, once the follower has its speed.
///
/// # Errors
///
/// [`FigureError`] if there is no such place.
pub fn first_minimum(engagement: &Engagement) -> Result<Extreme, FigureError> {
    engagement.first_minimum()?.ok_or(FigureError::Nothing)
}

/// θ' and φ' over time from rest, with the first minimum of the driver's speed marked.
///
/// φ' is counted in the follower's own sense, against the driver's: it is not negative while a pin is in its slot.
/// `others` is what else is to be said of the run in the caption. Meyer 1973, Fig. 8, which is lost. Series, at
/// every fifth instant: time, θ', φ'.
///
/// # Errors
///
/// [`FigureError`] if there is no steady motion.
pub fn speeds(engagement: &Engagement, others: &str) -> Result<Figure, FigureError> {
    let rise = engagement.rise(SETTLED)?;
    let steady = rise.steady;
    let Extreme { time: first, speed: first_speed, .. } = first_minimum(engagement)?;
    let begin = rise.cycles.first().map_or(0.0, |cycle| cycle.end);
    let duration = begin + (ENGAGEMENTS - 1) as f64 * steady.period;
    let lines = engagement.run(steady.period / LINES, duration)?;
    let ratio = engagement.parameters().mechanism().centre_distance_ratio();
    // From the geometry of the pose, which holds beyond the exit too.
    let rows: Vec<[f64; 3]> = lines
        .iter()
        .map(|line| {
            let pose = Pose::new(&ratio, &Turn::from_radians(line.angle));
            [line.time, line.speed, pose.velocity_ratio() * line.speed]
        })
        .collect();
    let ms = |time: f64| 1000.0 * time;
    let least = rows.iter().map(|row| row[2]).fold(0.0, f64::min);
    let most = rows.iter().flat_map(|row| [row[1], row[2]]).fold(steady.peak.speed, f64::max);
    let y = ChartAxis::from_zero(if least < -1e-3 * most { least } else { 0.0 }, most, 5.0);
    let steps = ChartAxis::from_zero(0.0, ms(duration) / 1.04, 5.0);
    let ticks = steps.ticks.iter().copied().filter(|mark| *mark <= ms(duration)).collect();
    let x = ChartAxis { range: 0.0..ms(duration), ticks, ..steps };
    let column = |k: usize| rows.iter().map(move |row| (ms(row[0]), row[k]));
    let follower = LineStyle::new(FOLLOWER).wide(2.2).dashed("7 4").class("follower");
    let driver = LineStyle::new(DRIVER).class("driver");
    let minimum = Marker::new(INK, MarkShape::Ring).sized(12.0).class("first-minimum");
    let panel =
        Panel::new(366.0, &x.titled(Label::words("time from rest in ms")), &y.titled(Label::words("speeds in rad/s")))
            .horizontal(0.0, LineStyle::thin("zero"))
            .curve(column(2), follower)
            .curve(column(1), driver)
            .marks([(ms(first), first_speed)], minimum);
    let symbol =
        |name: &str, letter: &str, stroke: &LineStyle| Label::words(name).and_rate(letter, 1).in_colour(stroke.colour);
    let key = [
        LegendEntry::curve(driver, symbol("driver ", "θ", &driver)),
        LegendEntry::curve(follower, symbol("follower ", "φ", &follower).and(", in its own sense")),
        LegendEntry::marks([minimum], Label::words(&format!("first minimum, after {} ms", format_fixed(ms(first), 1)))),
    ];
    let greatest = rows.iter().map(|row| row[2]).fold(0.0, f64::max);
    let words = Words::new(
        "runs-speeds",
        "Speeds of driver and follower over time, from rest",
        format!(
            "Two curves over time, from rest through {ENGAGEMENTS} engagements. The driver's speed rises, and then \
             swings between {} and {} rad/s in every engagement. The follower starts and stops in each, turning the \
             other way, at up to {} rad/s. A ring marks the driver's first minimum, in the first engagement, after {} \
             ms.",
            significant(steady.minimum.speed, 3),
            significant(steady.peak.speed, 3),
            significant(greatest, 3),
            format_fixed(ms(first), 1)
        ),
        format!(
            "A run from rest. The driver slows down while it speeds the follower up, and speeds up again as the \
             follower comes to rest. The follower turns opposite to the driver, and the figure counts its speed as \
             positive. {others}"
        )
        .trim_end(),
    );
    let columns = [("t", "s"), ("theta'", "rad/s"), ("phi'", "rad/s")];
    Ok(Chart::new([panel]).key(key).figure(words, Series::new(columns, rows.into_iter().step_by(KEPT))))
}
