//! The force between pin and slot over one engagement, and where the contact changes flank.

use super::axes::{along, blank, short, upright};
use super::engagement::{DrawingError, Engagement, Instant, STEPS};
use crate::figure::{Figure, Words};
use crate::number::{degrees, shown, without_noise};
use crate::plot::{Axis, Curve, Plot, Scale, Side};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::path::Path;
use crate::svg::placing::{Placing, around, leader};
use crate::svg::shape::Shape;
use crate::svg::view::Pixels;
use crate::theme::{DRIVER, FILL, FOLLOWER, INK, PAPER};
use geneva_dynamics::Parameters;
use nalgebra::Vector2;
use std::f64::consts::PI;

const SIZE: (u32, u32) = (640, 450);
/// Where the strips under the plot begin, and the height and the distance of each, in pixels.
const STRIPS: f64 = 468.0;
const STRIP: f64 = 30.0;
const PITCH: f64 = 62.0;
/// Marks of the angle to either side of the line of centres.
const MARKS: i32 = 3;
/// How far labels may stand from what they name, in pixels.
const NEAR: [f64; 6] = [10.0, 16.0, 24.0, 36.0, 52.0, 70.0];

/// Stretches of the engagement with one sign of a value.
type Stretches = Vec<([f64; 2], f64)>;

/// The normal force N, as N r / K, and the torque of the friction over K, for a pin that enters at this speed (θ' ≥ 0).
///
/// The motion between is that of the equation of motion. Strips under the plot tell the flank that the pin bears on
/// and the sign of F = C θ'² + D θ'', what stands between the bars. Series, from entry to exit: θ, θ', N r/K, the
/// friction's torque over K, F over E = K / I_f.
///
/// # Errors
///
/// [`DrawingError`] if the speed is negative or so great that the motion cannot be followed.
pub fn normal_force(parameters: &Parameters, entry_speed: f64) -> Result<Figure, DrawingError> {
    let engagement = Engagement::new(parameters, entry_speed)?;
    let instants = engagement.instants()?;
    let [flanks, signs] =
        [engagement.stretches(|at| at.normal)?, engagement.stretches(|at| at.bars)?].map(without_slivers);
    let plot = plot(parameters, &instants);
    let mut canvas = Canvas::new(f64::from(SIZE.0), STRIPS + 2.0 * PITCH);
    plot.draw_on(&mut canvas, &Pixels::zeros(), true);
    switches(&mut canvas, &plot, &flanks);
    names(&mut canvas, &plot, &flanks);
    strip(&mut canvas, &plot, 0, &Label::words("pin bears on"), &flanks, ["leading flank", "trailing flank"]);
    let bars = Label::words("sign of ")
        .and_symbol("F")
        .and(" = ")
        .and_symbol("C\u{2009}")
        .and_symbol("θ")
        .and("\u{200a}′² + ");
    let bars = bars.and_symbol("D\u{2009}").and_symbol("θ").and("\u{200a}″");
    if parameters.friction() > 0.0 {
        strip(&mut canvas, &plot, 1, &bars, &signs, ["+", "−"]);
    } else {
        canvas.label(
            &strip_corner(&plot, 1),
            &Vector2::new(1.0, 0.0),
            0.0,
            &bars.and(": zero, for there is no friction"),
        );
    }

    let n = parameters.mechanism().slots();
    let columns = [("theta", "deg"), ("theta'", "1/time"), ("N r/K", "1"), ("tau_2/K", "1"), ("F/E", "1")];
    let rows = instants.iter().map(|at| {
        [
            at.theta.to_degrees(),
            at.speed,
            without_noise(at.normal, 1.0),
            without_noise(at.friction, 1.0),
            without_noise(at.bars, 1.0),
        ]
    });
    let greatest = |value: fn(&Instant) -> f64| instants.iter().map(value).fold(0.0, f64::max);
    let changes: Vec<String> = flanks.windows(2).map(|pair| degrees(pair[0].0[1])).collect();
    let words = Words {
        id: format!("escapement-normal-force-{n}"),
        title: format!("Force between pin and slot over one engagement, {n} slots"),
        description: format!(
            "Over the driver angle from entry, {}, to exit, {}: the normal force N, as N r / K, at most {} and at \
             least {}, and the friction's torque over K, at most {}. {} Under the plot, strips tell the flank and \
             the sign of F.",
            degrees(-parameters.mechanism().engagement_half_angle()),
            degrees(parameters.mechanism().engagement_half_angle()),
            short(greatest(|at| at.normal)),
            short(-greatest(|at| -at.normal)),
            short(greatest(|at| at.friction)),
            if changes.is_empty() {
                "The pin bears on one flank throughout.".to_owned()
            } else {
                format!("The pin changes its flank at θ = {}.", changes.join(" and "))
            }
        ),
        caption: format!(
            "One engagement. At first the pin drives the follower; then the follower, running ahead, drives the pin, and \
             N changes sign with the flank. The friction acts against the motion on either flank, so its torque is |F| in \
             the equation of motion; F also changes sign on the line of centres, where the sliding turns round. {}",
            shown(parameters)
        ),
    };
    Ok(words.figure(canvas, Kind::Panels, Series::new(columns, rows)))
}

/// The stretches without those that are only rounding error wide, at the ends.
fn without_slivers(found: Stretches) -> Stretches {
    let mut kept: Stretches = Vec::new();
    for (ends, sign) in found {
        match kept.last_mut() {
            Some(last) if last.1 == sign || ends[1] - ends[0] < 1e-9 => last.0[1] = ends[1],
            _ => kept.push((ends, sign)),
        }
    }
    kept
}

fn plot(parameters: &Parameters, instants: &[Instant]) -> Plot {
    let half = parameters.mechanism().engagement_half_angle().to_degrees();
    let marks = (-MARKS..=MARKS).map(|k| half * f64::from(k) / f64::from(MARKS)).collect();
    let level = Axis { range: -half..half, marks, decimals: 0, scale: Scale::Even };
    let values = || instants.iter().flat_map(|at| [at.normal, at.friction]).chain([0.0]);
    let left = upright(values().fold(0.0, f64::min), values().fold(0.0, f64::max), 4.0);
    let curve = |value: fn(&Instant) -> f64, shade, dashes| Curve {
        points: instants.iter().map(|at| (at.theta.to_degrees(), value(at))).collect(),
        side: Side::Left,
        shade,
        dashes,
    };
    let curves = vec![curve(|at| at.normal, FOLLOWER, None), curve(|at| at.friction, DRIVER, Some([10, 6]))];
    Plot { size: SIZE, level, left: left.clone(), right: blank(&left), curves }
}

/// Where the flank changes: an upright, a circle on the line of no force, and the angle.
fn switches(canvas: &mut Canvas, plot: &Plot, flanks: &Stretches) {
    let range = &plot.left.range;
    for pair in flanks.windows(2) {
        let x = pair[0].0[1].to_degrees();
        let [foot, head] = [range.start, range.end].map(|y| plot.place(Side::Left, x, y));
        canvas.draw(Shape::line(&foot, &head).stroke(INK, 1.3).dashed("5 4").class("switch"));
        canvas.draw(Shape::circle(&plot.place(Side::Left, x, 0.0), 5.0).fill(PAPER).stroke(FOLLOWER, 2.0));
    }
}

/// Axes, curves and switches.
fn names(canvas: &mut Canvas, plot: &Plot, flanks: &Stretches) {
    let (right, down) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0));
    let (angles, forces) = (&plot.level.range, &plot.left.range);
    let at = |x: f64, y: f64| plot.place(Side::Left, x, y);
    let corner = at(angles.start, forces.end);
    let part = |top: Label, over: &str| top.and(over).and_symbol("K");
    canvas.label(&(corner - down * 26.0), &right, -48.0, &Label::words("parts of the driving torque ").and_symbol("K"));
    let foot = at(0.0, forces.start);
    canvas.label(&foot, &down, 50.0, &Label::words("driver angle ").and_symbol("θ").and(" in degrees"));
    let zero = [angles.start, angles.end].map(|x| at(x, 0.0));
    canvas.draw(Shape::line(&zero[0], &zero[1]).stroke(INK, 1.2).class("zero"));
    let end = at(angles.end, forces.start);
    let mut placing = Placing::within(corner + Vector2::new(8.0, 6.0), end - Vector2::new(8.0, 6.0));
    placing.avoid(&zero[0], &zero[1], 1.0);
    let curves: Vec<Vec<Pixels>> =
        plot.curves.iter().map(|curve| curve.points.iter().map(|(x, y)| at(*x, *y)).collect()).collect();
    for points in &curves {
        placing.avoid_all(points, 2.5);
    }
    for pair in flanks.windows(2) {
        let angle = pair[0].0[1];
        let x = angle.to_degrees();
        placing.avoid(&at(x, forces.start), &at(x, forces.end), 1.5);
        let label = Label::words("flank changes: ").and_symbol("θ").and(&format!(" = {}", degrees(angle)));
        if let Some(place) = placing.put(canvas, &label, around(&at(x, 0.0), PI / 4.0, &NEAR)) {
            leader(canvas, &place);
        }
    }
    let labels = [
        part(Label::symbol("N").and_symbol("\u{2009}r"), " / ").shade(FOLLOWER),
        part(Label::words("friction ").and_symbol("τ").sub("2"), " / ").shade(DRIVER),
    ];
    for ((label, points), share) in labels.iter().zip(&curves).zip([0.25, 0.2]) {
        let first = (share * f64::from(STEPS)) as usize;
        let nearby: Vec<Pixels> = points.iter().skip(first).step_by(12).take(8).copied().collect();
        if let Some(place) = placing.put(canvas, label, along(&nearby, &NEAR[..4])) {
            leader(canvas, &place);
        }
    }
}

/// Where a strip's name begins.
fn strip_corner(plot: &Plot, number: usize) -> Pixels {
    Vector2::new(plot.place(Side::Left, plot.level.range.start, 0.0).x, STRIPS + PITCH * number as f64)
}

/// One strip: its name, and its stretches with the words for a positive and for a negative value.
fn strip(canvas: &mut Canvas, plot: &Plot, number: usize, name: &Label, stretches: &Stretches, words: [&str; 2]) {
    let corner = strip_corner(plot, number);
    canvas.label(&corner, &Vector2::new(1.0, 0.0), 0.0, &name.clone().bare());
    let top = corner.y + 14.0;
    for (ends, sign) in stretches {
        let [left, right] = ends.map(|theta| plot.place(Side::Left, theta.to_degrees(), 0.0).x);
        let corners = [(left, top), (right, top), (right, top + STRIP), (left, top + STRIP)];
        let [a, b, c, d] = corners.map(|(x, y)| Vector2::new(x, y));
        let outline = Path::start(&a).line_to(&b).line_to(&c).line_to(&d).close();
        let (ground, word, class) =
            if *sign > 0.0 { (FILL, words[0], "positive") } else { (PAPER, words[1], "negative") };
        canvas.draw(Shape::path(outline).fill(ground).stroke(INK, 1.2).class(class));
        let label = Label::words(word).bare();
        let short = Label::words(word.split(' ').next().unwrap_or_default()).bare();
        let middle = Vector2::new((left + right) / 2.0, top + STRIP / 2.0);
        // Beside the strip at its right end, if it is too short for the words.
        let (at, towards, label) = if label.width() < right - left {
            (middle, Pixels::zeros(), label)
        } else if short.width() < right - left {
            (middle, Pixels::zeros(), short)
        } else {
            (Vector2::new(right, middle.y), Vector2::new(1.0, 0.0), short)
        };
        canvas.label(&at, &towards, if towards.x > 0.0 { 5.0 } else { 0.0 }, &label);
    }
}
