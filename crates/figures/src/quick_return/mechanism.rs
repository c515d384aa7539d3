//! The mechanism to scale at an instant.

use super::instant::{LeverState, format_with_unit, lever_acceleration, rate_of, turning};
use super::linkage::{LEVER, LinkagePose, WIDTH, bodies, length, other_branch, wrapped};
use crate::number::degrees;
use crate::parts::{NEAR, along_arc, angle_label, arc, arc_arrow, of_label, part, scale_bar};
use crate::svg::{
    Canvas, DrawingKind, Label, Pixels, Placing, Sense, Shape, heading, leader, positions_around, positions_beside_line,
};
use crate::theme::{DRIVER, FOLLOWER, GRID, INK};
use crate::{Figure, Series, Words};
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Room for the values below the mechanism, its lines and where its columns begin, in pixels.
const VALUES: f64 = 5.0 * LINE + 8.0;
const LINE: f64 = 28.0;
const COLUMNS: [f64; 2] = [24.0, 230.0];
/// From a body to the arrow of its sense, in pixels, and half the arrow's length.
const TO_ARROW: f64 = 15.0;
const HALF_ARROW: f64 = 30.0;
/// The narrowest angle with a mark, in radians.
const NARROWEST: f64 = 0.05;
/// Room for the scale bar above the mechanism.
const SCALE_BAR: f64 = 34.0;

/// The mechanism at an instant, to scale, with its angles, its senses and the ends of the lever's swing.
///
/// `drive` is in radians per second and its square; `length_unit` the unit of the linkage's lengths. If the lever at
/// its angle has a second place for the pin, the crank's position for it is drawn faintly. Series, one row: θ, φ, β;
/// l, R, r; θ′, θ″, φ′, φ″; the sliding velocity, outwards positive.
pub fn mechanism(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>, length_unit: &str) -> Figure {
    let instant = LeverState::new(linkage, position, drive);
    let layout = LinkagePose::new(linkage, &instant, SCALE_BAR);
    let bottom = SCALE_BAR + layout.height;
    let mut canvas = Canvas::new(WIDTH, bottom + VALUES);
    let mut placing = Placing::new(Vector2::new(6.0, SCALE_BAR), Vector2::new(WIDTH - 6.0, bottom));
    bodies(&mut canvas, &mut placing, &layout, linkage, &instant);
    names(&mut canvas, &mut placing, &layout, linkage, &instant, drive);
    scale_bar(&mut canvas, &Vector2::new(COLUMNS[0], 24.0), layout.view.scale, false, length_unit);
    values(&mut canvas, linkage, &instant, drive, length_unit, bottom);

    let speed_unit = format!("{length_unit}/s");
    let motion = &instant.motion;
    let series = Series::of_one([
        ("theta", "deg", instant.theta().to_degrees()),
        ("phi", "deg", instant.lever_angle.to_degrees()),
        ("beta", "deg", instant.angle_at_pin.to_degrees()),
        ("l", length_unit, linkage.ground()),
        ("R", length_unit, linkage.crank()),
        ("r", length_unit, instant.pin_distance),
        ("theta'", "rad/s", drive.speed),
        ("theta''", "rad/s^2", drive.acceleration),
        ("phi'", "rad/s", motion.velocities.follower_speed),
        ("phi''", "rad/s^2", motion.accelerations.follower_acceleration),
        ("v_rel", &speed_unit, motion.velocities.sliding_velocity.dot(&instant.along)),
    ]);
    let [crank, phi, beta] = [instant.crank_angle, instant.lever_angle, instant.angle_at_pin].map(degrees);
    let (driver, lever) = (drive.speed, instant.lever_speed(drive));
    let kind = match linkage.strokes().swing_limit {
        Some(limit) => format!("swings between −{0} and {0}", degrees(limit)),
        None => "turns round and round".to_owned(),
    };
    let words = Words::new(
        "quick-return-mechanism",
        format!("Quick-return mechanism at a lever angle of {phi}"),
        format!(
            "A crank of {} turns about O2. Its pin slides in the slot of a lever that turns about O4, {} to the left of \
             O2. Counted from the direction O4 to O2, the crank's angle is {crank}, the lever's {phi}, the angle between them at the pin {beta}; the pin is \
             {} from O4. The crank's angular velocity is {}{}; the \
             lever's is {}{}. The lever {kind}.",
            length(linkage.crank(), length_unit),
            length(linkage.ground(), length_unit),
            format_with_unit(instant.pin_distance, length_unit),
            format_with_unit(driver.abs(), "rad/s"),
            turning(driver),
            format_with_unit(lever.abs(), "rad/s"),
            turning(lever)
        ),
        format!(
            "The mechanism to scale at φ = {phi}. The pin P₂ on the crank slides in the slot of the lever. P₄ is the lever's \
             point under the pin, in the same place at this instant. With the same φ the pin could also be at the “other \
             point” of its circle. Counter-clockwise is positive, and θ is counted from the line from O₂ to O₄."
        ),
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

/// Angles, senses and names, the most bound to their places first.
fn names(
    canvas: &mut Canvas,
    placing: &mut Placing,
    at: &LinkagePose,
    linkage: &QuickReturn,
    instant: &LeverState,
    drive: &Drive<f64>,
) {
    let (crank, phi) = (instant.crank_angle, instant.lever_angle);
    let distance = (at.pin - at.pivot).norm();
    let at_pivot = (0.42 * at.view.place(&Vector2::zeros()).metric_distance(&at.axis)).min(0.7 * distance).max(40.0);
    let at_pin = (0.3 * at.crank.min(distance)).clamp(24.0, 44.0);
    let swept = wrapped(crank - phi);
    mark(canvas, placing, &at.pin, at_pin, (phi + PI, phi + PI + swept), false, ("β", instant.angle_at_pin));
    mark(canvas, placing, &at.pivot, at_pivot, (0.0, phi), false, ("φ", phi));
    mark(canvas, placing, &at.axis, (0.42 * at.crank).min(58.0), (PI, crank), true, ("θ", instant.theta()));

    let lever = instant.lever_speed(drive);
    let aside = if linkage.strokes().swing_limit.is_some() { -0.85 * at.side } else { phi - FRAC_PI_2 };
    for (centre, radius, middle, rate, symbol, colour) in [
        (&at.axis, at.crank + TO_ARROW, aside, drive.speed, rate_of("θ").in_colour(DRIVER), DRIVER),
        (&at.pivot, at.lever + LEVER + TO_ARROW, phi, lever, rate_of("φ").in_colour(FOLLOWER), FOLLOWER),
    ] {
        // At rest there is no sense.
        if rate != 0.0 {
            let half = HALF_ARROW / radius * Sense::from_rate(rate).sign();
            of_label(canvas, &symbol, |canvas| {
                arc_arrow(canvas, centre, radius, middle - half, middle + half, colour, 2.5);
            });
            placing.avoid_arc(centre, radius, middle - half, middle + half, 2.0);
            placing.put(canvas, &symbol, positions_around(&(centre + heading(middle) * radius), middle, &NEAR));
        }
    }
    let outwards = phi + FRAC_PI_2 * at.side;
    let pin = Label::words("P").sub("2").and(", P").sub("4");
    placing.put(canvas, &pin, positions_around(&at.pin, outwards, &[12.0, 18.0, 26.0, 36.0, 50.0]));
    for (point, name) in [(&at.pivot, "4"), (&at.axis, "2")] {
        let label = Label::words("O").sub(name);
        placing.put(canvas, &label, positions_around(point, -at.side * 0.5, &[14.0, 20.0, 28.0, 38.0]));
    }
    if let Some(ghost) = other_branch(at, linkage, instant) {
        let places = positions_beside_line(&at.axis, &ghost, &NEAR).into_iter().chain(positions_around(
            &ghost,
            -FRAC_PI_2 * at.side,
            &NEAR,
        ));
        if let Some(place) = placing.put(canvas, &Label::words("other point").in_colour(DRIVER), places) {
            leader(canvas, &place);
        }
    }
    if let Some(limit) = linkage.strokes().swing_limit {
        for angle in [limit, -limit] {
            let end = at.swing_end(angle);
            let from = at.pivot.lerp(&end, 0.3);
            let label = Label::words(&format!("swing end {}", degrees(angle))).in_colour(FOLLOWER);
            placing.put(canvas, &label, positions_beside_line(&from, &end, &NEAR));
        }
    }
}

/// The mark of an angle about a point, with an arrow head if it is counted in one sense, and its label: with the value
/// if it has room within the angle.
fn mark(
    canvas: &mut Canvas,
    placing: &mut Placing,
    centre: &Pixels,
    radius: f64,
    (from, to): (f64, f64),
    counted: bool,
    (symbol, angle): (&str, f64),
) {
    if (to - from).abs() < NARROWEST {
        return;
    }
    part(canvas, symbol, |canvas| {
        if counted && (to - from).abs() * radius > 24.0 {
            arc_arrow(canvas, centre, radius, from, to, INK, 1.5);
        } else {
            arc(canvas, centre, radius, from, to, INK, 1.5);
        }
    });
    placing.avoid_arc(centre, radius, from, to, 1.0);
    let places = |distances: &[f64]| along_arc(centre, radius, (from, to), distances);
    let whole = angle_label(symbol, angle).of_part(symbol);
    if placing.has_room(&whole, places(&NEAR[..3])) {
        placing.put(canvas, &whole, places(&NEAR[..3]));
    } else {
        let middle = (from + to) / 2.0;
        let elsewhere = positions_around(&(centre + heading(middle) * radius), middle, &NEAR);
        placing.put(canvas, &Label::part(symbol), places(&NEAR).into_iter().chain(elsewhere));
    }
}

/// Lengths, angles, and the motion of the two links, in columns below.
fn values(canvas: &mut Canvas, linkage: &QuickReturn, instant: &LeverState, drive: &Drive<f64>, unit: &str, top: f64) {
    let rule = [COLUMNS[0], WIDTH - COLUMNS[0]].map(|x| Vector2::new(x, top));
    canvas.draw(Shape::line(&rule[0], &rule[1]).stroke(GRID, 1.2));
    let columns = [
        vec![
            Label::part("l").and(&format!(" = {}", length(linkage.ground(), unit))),
            Label::part("R").and(&format!(" = {}", length(linkage.crank(), unit))).in_colour(DRIVER),
            angle_label("φ", instant.lever_angle),
            angle_label("θ", instant.theta()),
            angle_label("β", instant.angle_at_pin),
        ],
        vec![
            Label::part("r").and(&format!(" = {}", format_with_unit(instant.pin_distance, unit))).in_colour(FOLLOWER),
            rate_of("θ").and(&format!(" = {}", format_with_unit(drive.speed, "rad/s"))).in_colour(DRIVER),
            rate_of("φ")
                .and(&format!(" = {}", format_with_unit(instant.lever_speed(drive), "rad/s")))
                .in_colour(FOLLOWER),
            lever_acceleration()
                .and(&format!(" = {}", format_with_unit(instant.lever_acceleration(drive), "rad/s²")))
                .in_colour(FOLLOWER),
        ],
    ];
    for (x, labels) in COLUMNS.into_iter().zip(columns) {
        for (k, label) in labels.into_iter().enumerate() {
            let at = Vector2::new(x, top + LINE * (k as f64 + 0.7));
            canvas.label(&at, &Vector2::new(1.0, 0.0), 0.0, &label.bare());
        }
    }
}
