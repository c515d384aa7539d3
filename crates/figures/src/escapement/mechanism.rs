//! The whole mechanism to scale.

use super::pose::{EscapementMargins, EscapementPose, half_angle, id};
use crate::number::{degrees, significant, without_noise};
use crate::parts::{NEAR, WIDTH, angle};
use crate::svg::{Canvas, DrawingKind, Label, Placing, Shape, positions_around};
use crate::theme::{DRIVER, FOLLOWER};
use crate::{Figure, FigureError, Series, Words};
use geneva_kinematics::Mechanism;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

const MARGINS: EscapementMargins = EscapementMargins { side: 46.0, above: 44.0, below: 24.0 };
/// Radii of the marks of the half angles, in pixels: at the driver's axis and at the follower's.
const MARKS: [f64; 2] = [62.0, 46.0];

/// Driver with all pins and follower with all slots at a driver angle (θ in radians, within ±π/m), to scale.
///
/// Dashed lines lead from both axes to where a pin leaves and where it enters; they make the half angles π/m and π/n with
/// the line of centres. The widths of slots, pins and the hollows between the slots are free. Series: n, m, c/r, rim/r,
/// π/m, π/n, θ, φ, R/r.
///
/// # Errors
///
/// [`FigureError::Escapement`] if the angle is beyond ±π/m or not finite.
pub fn mechanism(escapement: &Mechanism, crank: f64) -> Result<Figure, FigureError> {
    let bodies = EscapementPose::at_driver_angle(escapement, crank, MARGINS)?;
    let mut canvas = Canvas::new(WIDTH, bodies.height);
    let mut placing = bodies.placing();
    bodies.draw_driver(&mut canvas, 1.8);
    bodies.draw_follower(&mut canvas, 2.0);
    bodies.draw_line_of_centres(&mut canvas);
    half_angles(&mut canvas, &mut placing, &bodies, escapement);
    bodies.draw_pins(&mut canvas);
    bodies.draw_axes(&mut canvas);
    bodies.draw_senses(&mut canvas);
    names(&mut canvas, &mut placing, &bodies, escapement);

    let (n, m) = (escapement.slots(), escapement.pins());
    let distance = (bodies.layout.pins[0] - bodies.layout.follower_axis).norm();
    let (ratio, rim) = (escapement.centre_distance_ratio(), escapement.rim_radius());
    let series = Series::of_one([
        ("slots", "1", f64::from(n)),
        ("pins", "1", f64::from(m)),
        ("c/r", "1", ratio),
        ("rim/r", "1", rim),
        ("theta_0", "deg", escapement.engagement_half_angle().to_degrees()),
        ("phi_0", "deg", escapement.follower_half_angle().to_degrees()),
        ("theta", "deg", crank.to_degrees()),
        ("phi", "deg", bodies.phi.to_degrees()),
        ("R/r", "1", distance),
    ]);
    let words = Words::new(
        id("mechanism", escapement),
        format!("Geneva escapement with {m} pins and {n} slots"),
        format!(
            "At the left the driver, a disc with {m} pins all round, turning counter-clockwise about B. At the right \
             the follower, a star with {n} slots, turning clockwise about O, {} crank radii from B; its rim has a \
             radius of {}. Lines from B and O to the places where a pin enters and leaves make angles of {} \
             and {} with the line of centres. The engaged pin is at θ = {}, its slot at φ = {}.",
            significant(ratio, 4),
            significant(rim, 4),
            degrees(escapement.engagement_half_angle()),
            degrees(escapement.follower_half_angle()),
            degrees(crank),
            degrees(without_noise(bodies.phi, 1.0))
        ),
        format!(
            "The escapement with {m} pins and {n} slots, to scale. The driver, at the left, turns counter-clockwise, the \
             follower clockwise. A pin enters where the lower dashed lines cross, π/{m} before the line of centres, \
             and leaves where the upper ones cross, π/{m} past it."
        ),
    );
    Ok(words.figure(canvas, DrawingKind::Mechanism, series))
}

/// Lines to the places of entry and exit, and their angles with the line of centres.
fn half_angles(canvas: &mut Canvas, placing: &mut Placing, at: &EscapementPose, escapement: &Mechanism) {
    let (theta, phi) = (escapement.engagement_half_angle(), escapement.follower_half_angle());
    for sense in [1.0, -1.0] {
        let place = at.on_driver(1.0, sense * theta);
        for (centre, colour) in [(&at.axis, DRIVER), (&at.pivot, FOLLOWER)] {
            canvas.draw(Shape::line(centre, &place).stroke(colour, 1.3).dashed("10 4").class("half-angle"));
            placing.avoid(centre, &place, 1.0);
        }
    }
    let [driver, follower] = MARKS;
    let label = |count| Label::words(&half_angle(count));
    angle(canvas, placing, &at.axis, driver, (0.0, theta), &label(escapement.pins()));
    angle(canvas, placing, &at.pivot, follower, (PI, PI - phi), &label(escapement.slots()));
}

/// Names of the bodies above them, and of the axes.
fn names(canvas: &mut Canvas, placing: &mut Placing, at: &EscapementPose, escapement: &Mechanism) {
    let (row, right) = (20.0, Vector2::new(1.0, 0.0));
    let driver = Label::words(&format!("driver, {} pins", escapement.pins())).in_colour(DRIVER);
    canvas.label(&Vector2::new(0.0, row), &right, 14.0, &driver);
    let follower = Label::words(&format!("follower, {} slots", escapement.slots())).in_colour(FOLLOWER);
    canvas.label(&Vector2::new(WIDTH, row), &-right, 14.0, &follower);
    placing.put(canvas, &Label::words("B"), positions_around(&at.axis, -FRAC_PI_2 - 0.4, &NEAR));
    placing.put(canvas, &Label::words("O"), positions_around(&at.pivot, -FRAC_PI_2 + 0.4, &NEAR));
}
