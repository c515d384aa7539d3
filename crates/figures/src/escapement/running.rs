//! The escapement at an instant of its run from rest, above its speed and the force between pin and slot.

use super::pose::{EscapementMargins, EscapementPose};
use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{degrees, describe_parameters, extent, format_fixed, significant};
use crate::svg::{Canvas, Label, Shape};
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER, INK};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::forces::Flank;
use geneva_dynamics::steady::{Engagement, PrintedLine};

/// Engagements that are shown, and instants in all of them.
const SHOWN: usize = 6;
const INSTANTS: usize = 600;
/// Height of the mechanism, and its margins, in pixels.
const HEIGHT: f64 = 300.0;
const MARGINS: EscapementMargins = EscapementMargins { side: 8.0, above: 8.0, below: 8.0 };
/// Heights of the two frames, in pixels.
const FRAMES: [f64; 2] = [170.0, 110.0];
/// Where a curve stands at the instant.
const HERE: Marker = Marker::new(INK, MarkShape::Disc).sized(11.0).class("here");
/// The driver's speed, and the force while the pin bears on either flank.
const SPEED: LineStyle = LineStyle::new(DRIVER).class("speed");
const LEADING: LineStyle = LineStyle::new(FOLLOWER).class("leading");
const TRAILING: LineStyle = LineStyle::new(CORIOLIS).class("trailing");

/// One instant: the line of the run, and F R / K.
struct Instant {
    line: PrintedLine,
    normal: f64,
}

/// The escapement after a share (0 to 1) of the time of its first six engagements from rest, a mark where the pin bears on
/// the slot; the driver's speed over time, and the normal force F as F R / K: positive on the leading flank of the slot.
///
/// Series, at equal times: time, crank angle, θ', F R/K.
///
/// # Errors
///
/// [`FigureError`] if there is no steady motion, or the share is not between 0 and 1.
pub fn running(engagement: &Engagement, share: f64) -> Result<Figure, FigureError> {
    let parameters = engagement.parameters();
    let steady = engagement.steady_state()?;
    let (mut duration, mut entry, mut starts) = (0.0, 0.0, Vec::new());
    for _ in 0..SHOWN {
        starts.push(duration);
        let passage = engagement.passage(entry)?;
        (duration, entry) = (duration + passage.duration(), passage.end_speed());
    }
    // The last line is an instant before the end.
    let instants = engagement.run(duration / INSTANTS as f64, duration * (1.0 - 0.5 / INSTANTS as f64))?;
    let instants =
        instants.into_iter().map(|line| instant(parameters, line)).collect::<Result<Vec<_>, FigureError>>()?;
    let at = if (0.0..=1.0).contains(&share) { (share * INSTANTS as f64) as usize } else { usize::MAX };
    let now = instants.get(at.min(INSTANTS - 1)).filter(|_| at != usize::MAX).ok_or(FigureError::Share(share))?;

    let panels = panels(&instants, now, &starts, [steady.minimum.speed, steady.peak.speed], duration);
    let bodies = EscapementPose::of_height(&parameters.mechanism(), now.line.angle, HEIGHT, MARGINS)?;
    let (m, speed) = (parameters.mechanism().pins(), significant(now.line.speed, 4));
    let words = Words::new(
        "live-escapement",
        format!("A Geneva escapement with {m} pins, {} ms after its start", format_fixed(1000.0 * now.line.time, 1)),
        format!(
            "Above, the mechanism to scale at a driver angle of {}. Below it, over the time of six engagements from \
             rest, the driver's speed, {speed} rad/s at this instant, between dashed lines at {} and {} rad/s, the least and \
             the greatest of the steady motion; and at the foot the normal force, positive where the pin drives the follower.",
            degrees(now.line.angle),
            significant(steady.minimum.speed, 4),
            significant(steady.peak.speed, 4)
        ),
        format!(
            "The first six engagements from rest. In the middle is the driver's speed, with dashed lines at its \
             minimum and maximum in the steady motion. At the foot is the force between pin and slot, F R / K: \
             positive on the leading flank, negative on the trailing flank. The mark in the drawing shows where the \
             pin presses on the slot. {}",
            describe_parameters(parameters)
        ),
    );
    let columns = [("t", "s"), ("theta", "deg"), ("theta'", "rad/s"), ("F R/K", "1")];
    let rows =
        instants.iter().step_by(4).map(|at| [at.line.time, at.line.angle.to_degrees(), at.line.speed, at.normal]);
    let series = Series::new(columns, rows.collect::<Vec<_>>());
    let flank = flank(now.normal);
    Ok(Chart::new(panels).figure_below(words, series, HEIGHT, |canvas: &mut Canvas| {
        bodies.draw_driver(canvas, 1.8);
        bodies.draw_follower(canvas, 2.0);
        bodies.draw_line_of_centres(canvas);
        bodies.draw_pins(canvas);
        bodies.draw_axes(canvas);
        if let Some((side, stroke)) = flank {
            let [from, to] = bodies.flank(side);
            canvas.draw(Shape::line(&from, &to).stroke(stroke.colour, 5.0).class("bearing-flank"));
        }
    }))
}

/// The force at a line of the run.
fn instant(parameters: &Parameters, line: PrintedLine) -> Result<Instant, FigureError> {
    let forces = parameters.contact_forces(line.angle, line.speed)?;
    let normal = if forces.flank == Flank::Neither { 0.0 } else { forces.normal_moment / parameters.torque() };
    Ok(Instant { line, normal })
}

/// On which side of the slot the pin bears, ahead of it (1) or behind (−1), and the colour of that force.
fn flank(normal: f64) -> Option<(f64, LineStyle)> {
    match normal {
        normal if normal > 0.0 => Some((1.0, LEADING)),
        normal if normal < 0.0 => Some((-1.0, TRAILING)),
        _ => None,
    }
}

fn panels(instants: &[Instant], now: &Instant, starts: &[f64], steady: [f64; 2], duration: f64) -> Vec<Panel> {
    let ms = |time: f64| 1000.0 * time;
    let most = instants.iter().map(|at| at.line.speed).fold(steady[1], f64::max);
    let forces = || instants.iter().map(|at| at.normal);
    let [least_force, most_force] = extent(forces().chain([0.0]));
    let steps = ChartAxis::from_zero(0.0, ms(duration) / 1.04, 4.0);
    let ticks = steps.ticks.iter().copied().filter(|mark| *mark <= ms(duration)).collect();
    let x = ChartAxis { range: 0.0..ms(duration), ticks, ..steps };
    let y =
        ChartAxis::from_zero(0.0, most, 4.0).titled(Label::words("driver's speed in rad/s").in_colour(SPEED.colour));
    let mut speed = Panel::new(FRAMES[0], &x.clone().unnumbered(), &y);
    let title = Label::words("force ").and_symbol("F\u{2009}R").and(" / ").and_symbol("K");
    let y = ChartAxis::from_zero(least_force, most_force, 3.0).titled(title);
    let mut force = Panel::new(FRAMES[1], &x.titled(Label::words("time from rest in ms")), &y);
    for start in starts.iter().skip(1) {
        speed = speed.vertical(ms(*start), LineStyle::thin("entry"));
        force = force.vertical(ms(*start), LineStyle::thin("entry"));
    }
    for level in steady {
        speed = speed.horizontal(level, LineStyle::new(DRIVER).wide(1.3).dashed("5 4").class("steady"));
    }
    speed = speed.curve(instants.iter().map(|at| (ms(at.line.time), at.line.speed)), SPEED);
    force = force.horizontal(0.0, LineStyle::thin("zero"));
    for part in instants.chunk_by(|a, b| (a.normal < 0.0) == (b.normal < 0.0)) {
        let stroke = if part[0].normal < 0.0 { TRAILING } else { LEADING };
        force = force.curve(part.iter().map(|at| (ms(at.line.time), at.normal)), stroke);
    }
    let time = ms(now.line.time);
    vec![speed.marks([(time, now.line.speed)], HERE), force.marks([(time, now.normal)], HERE)]
}
