//! Position, velocity and acceleration of the wheel over one advance.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{degrees, significant, with_minus_sign, without_noise};
use crate::svg::Label;
use crate::theme::{DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, ItemValue, Series, Words};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::f64::consts::{FRAC_PI_2, PI};

/// Rows of the series: at least so many steps, and none longer than a degree.
const LEAST_STEPS: u32 = 90;
/// Degrees between marks of the crank angle.
const MARKS: f64 = 15.0;
/// Degrees of dwell shown before and after the advance, if there are so many.
const DWELL: f64 = 8.0;
/// The dots of the acceleration at entry and exit.
const END: Marker = Marker::new(DRIVER, MarkShape::Disc).sized(11.0).class("indexing-end");

/// φ in radians, φ'/θ' and φ''/θ'² against θ in degrees, from entry to exit, for a driver of constant speed.
///
/// Two panels: φ and φ'/θ', and below them φ''/θ'². A little of the dwell is shown on both sides, so that the jumps of
/// the acceleration at entry and exit can be seen: a filled dot on the advance, an open one on the dwell. Series, in
/// equal steps of at most a degree, both ends included: θ, φ, φ'/θ', φ''/θ'².
pub fn indexing(wheel: &Wheel) -> Figure {
    let instants = instants(wheel);
    let (alpha, peak) = (wheel.half_pitch_angle(), wheel.acceleration_peak());
    let most = wheel.engagement_half_angle().to_degrees();
    let rest = DWELL.min((PI / f64::from(wheel.pins())).to_degrees() - most).max(0.0);
    let panels = [motion(wheel, &instants, most, rest), acceleration(wheel, &instants, most, rest)];
    let words = Words::new(
        "wheel-indexing",
        format!("Position, velocity and acceleration of a wheel with {} stations", wheel.stations()),
        format!(
            "Two panels over the crank angle from {} to {}. Above, the wheel's angle rises from {} rad to {} rad, and its \
             velocity ratio rises from zero to {} on the line of centres and falls back to zero. Below, its acceleration \
             ratio jumps from zero to {} at entry, rises to {} at {}, falls through zero on the line of centres to the \
             opposite values, and jumps back to zero at exit.",
            degrees(-most.to_radians()),
            degrees(most.to_radians()),
            with_minus_sign(&significant(-alpha, 4)),
            significant(alpha, 4),
            significant(wheel.peak_velocity(), 4),
            significant(wheel.entry_acceleration(), 4),
            significant(peak.ratio, 4),
            degrees(-peak.angle)
        ),
        format!(
            "One indexing of a wheel with {} stations, its driver at constant speed. Above: the wheel's angle φ, and its speed \
             divided by the driver's, φ̇/θ̇. Below: its acceleration divided by the square of the driver's speed, φ̈/θ̇². The \
             acceleration jumps at entry and at exit, where the jerk is infinite.",
            wheel.stations()
        ),
    );
    let series = Series::of_items(
        &instants,
        [
            ("theta", "deg", |at| at.theta),
            ("phi", "rad", |at| at.phi),
            ("phi'/theta'", "1", |at| at.velocity),
            ("phi''/theta'^2", "1", |at| at.acceleration),
        ],
    );
    Chart::new(panels).figure(words, series)
}

/// θ in degrees, φ in radians, φ'/θ' and φ''/θ'².
struct Instant {
    theta: f64,
    phi: f64,
    velocity: f64,
    acceleration: f64,
}

/// The wheel from entry to exit, both included, symmetric to the last bit.
fn instants(wheel: &Wheel) -> Vec<Instant> {
    let half = wheel.engagement_half_angle();
    let steps = LEAST_STEPS.max(libm::ceil(2.0 * half.to_degrees() - 1e-9) as u32);
    let instant = |k: u32| {
        // The share is exactly one at both ends.
        let theta = half * ((2.0 * f64::from(k) - f64::from(steps)) / f64::from(steps));
        let motion = wheel.engaged(theta).ok()?;
        Some(Instant {
            theta: theta.to_degrees(),
            phi: motion.angle,
            velocity: without_noise(motion.velocity, 1.0),
            acceleration: motion.acceleration,
        })
    };
    (0..=steps).filter_map(instant).collect()
}

/// The crank angle from one end of what is shown to the other.
fn crank_angles(end: f64) -> ChartAxis {
    let count = ((end + 1e-9) / MARKS) as i32;
    ChartAxis::whole(-end..end, (-count..=count).map(|k| MARKS * f64::from(k)))
}

/// Entry and exit at ±`most` degrees, with their names at this height, if there is a dwell beyond them.
fn ends(mut panel: Panel, most: f64, rest: f64, height: f64) -> Panel {
    for (sense, name) in [(-1.0, "entry"), (1.0, "exit")].into_iter().filter(|_| rest > 0.0) {
        panel = panel.vertical(sense * most, LineStyle::thin("end").wide(1.0).dashed("1 4"));
        panel = panel.name_near([(sense * most, height)], if sense < 0.0 { 0.0 } else { PI }, Label::words(name));
    }
    panel
}

/// The instants between two parts of the way to an end, every third.
fn part(instants: &[Instant], most: f64, from: f64, to: f64) -> impl Iterator<Item = &Instant> {
    instants.iter().filter(move |at| at.theta >= from * most && at.theta <= to * most).step_by(3)
}

/// The upper panel: angle and speed, entry and exit at ±`most` degrees, with so much of the dwell beyond.
fn motion(wheel: &Wheel, instants: &[Instant], most: f64, rest: f64) -> Panel {
    let (alpha, end) = (wheel.half_pitch_angle(), most + rest);
    let [position, velocity, _] = symbols();
    let y = ChartAxis::from_zero(-alpha, wheel.peak_velocity().max(alpha), 4.0);
    let head = y.range.end - 0.1 * (y.range.end - y.range.start);
    let extended = |curve: ItemValue<Instant>, value: f64| {
        let dwell = |sense: f64| (rest > 0.0).then_some((sense * end, sense * value));
        let inside = instants.iter().map(move |at| (at.theta, curve(at)));
        dwell(-1.0).into_iter().chain(inside).chain(dwell(1.0))
    };
    let title = Label::words("angle ").and_label(&position).and(" and speed ").and_label(&velocity);
    let panel = Panel::new(240.0, &crank_angles(end), &y.titled(title))
        .horizontal(0.0, LineStyle::thin("zero"))
        .curve(extended(|at| at.phi, alpha), LineStyle::new(RELATIVE).dashed("3 5"))
        .curve(extended(|at| at.velocity, 0.0), LineStyle::new(FOLLOWER));
    ends(panel, most, rest, head)
        .name_near(part(instants, most, 0.1, 0.5).map(|at| (at.theta, at.velocity)), 0.5, velocity)
        .name_near(part(instants, most, -1.0, -0.4).map(|at| (at.theta, at.phi)), FRAC_PI_2, position)
}

/// The lower panel: the acceleration and its jumps.
fn acceleration(wheel: &Wheel, instants: &[Instant], most: f64, rest: f64) -> Panel {
    let end = most + rest;
    let [.., acceleration] = symbols();
    let y = ChartAxis::symmetric(wheel.acceleration_peak().ratio);
    let foot = 0.88 * y.range.start;
    let angle = Label::words("crank angle ").and_symbol("θ").and(" in degrees");
    let title = Label::words("acceleration ").and_label(&acceleration);
    let curve = LineStyle::new(DRIVER);
    let mut panel = Panel::new(240.0, &crank_angles(end).titled(angle), &y.titled(title))
        .horizontal(0.0, LineStyle::thin("zero"))
        .curve(instants.iter().map(|at| (at.theta, at.acceleration)), curve);
    for (sense, jump) in [(-1.0, wheel.entry_acceleration()), (1.0, -wheel.entry_acceleration())] {
        let theta = sense * most;
        if rest > 0.0 {
            let jumps = LineStyle::new(DRIVER).wide(1.3).dashed("2 3").class("jump");
            panel = panel
                .curve([(sense * end, 0.0), (theta, 0.0)], curve.class("dwell"))
                .curve([(theta, 0.0), (theta, jump)], jumps)
                .marks([(theta, 0.0)], Marker { mark: MarkShape::Ring, ..END }.sized(10.0).class("dwell-end"));
        }
        panel = panel.marks([(theta, jump)], END);
    }
    ends(panel, most, rest, foot)
}

/// The symbols of the three curves: φ, φ'/θ' and φ''/θ'².
fn symbols() -> [Label; 3] {
    [
        Label::symbol("φ").in_colour(RELATIVE).and(" in rad"),
        Label::rate("φ", 1).in_colour(FOLLOWER).and(" / ").and_rate("θ", 1),
        Label::rate("φ", 2).in_colour(DRIVER).and(" / ").and_rate("θ", 1).and("²"),
    ]
}
