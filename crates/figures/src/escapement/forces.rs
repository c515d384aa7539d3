//! The forces at one instant: on the pin, at the contact, on the follower.

use super::engagement::{EngagementState, speed_at};
use super::force_panels::{contact, follower, pin_and_driver};
use super::force_senses::Senses;
use super::pose::{EscapementMargins, EscapementPose};
use crate::number::{degrees, describe_parameters, short, significant, without_noise};
use crate::parts::{WIDTH, angle_label};
use crate::svg::{Canvas, DrawingKind, Label, Shape};
use crate::theme::GRID;
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::steady::Engagement;
use nalgebra::Vector2;

const MARGINS: EscapementMargins = EscapementMargins { side: 46.0, above: 48.0, below: 30.0 };
/// Height of the two lower panels and of the values under them, in pixels.
const LOWER: f64 = 330.0;
const VALUES: f64 = 92.0;
const LINE: f64 = 28.0;

/// The forces in the steady motion, at this part (from above −1 to 1) of the half angle of the engagement from the line of
/// centres.
///
/// # Errors
///
/// [`FigureError`] if there is no steady motion, or the part is beyond its limits.
pub fn steady_forces(parameters: &Parameters, part: f64) -> Result<Figure, FigureError> {
    let crank = part * parameters.mechanism().engagement_half_angle();
    let entry_speed = Engagement::new(parameters)?.steady_state()?.entry_speed;
    forces(parameters, crank, speed_at(parameters, entry_speed, crank)?)
}

/// The forces at a driver angle (θ in radians, within ±π/m) and a driver speed (θ' ≥ 0), in three panels.
///
/// 1, the pin on the driver: the reaction to F across the slot, the friction μ |F| along it, and its arm l sin φ about the
/// driver's axis. 2, the contact, enlarged: the flank that the pin bears on. 3, the follower by itself with F, r and
/// its angular acceleration. Which way the forces point and which flank it is are those of the equation of motion at
/// this state; the lengths of the arrows are not to scale.
/// Series: θ, φ, θ', F R/K, μ, −τ₂/K, its arm over R, r/R, φ'' over K / I_f.
///
/// # Errors
///
/// [`FigureError`] if the angle is beyond ±π/m or not finite, or the speed negative or not finite.
pub(super) fn forces(parameters: &Parameters, crank: f64, speed: f64) -> Result<Figure, FigureError> {
    let escapement = parameters.mechanism();
    let bodies = EscapementPose::at_driver_angle(&escapement, crank, MARGINS)?;
    let at = EngagementState::new(parameters, crank, speed)?;
    let normal = without_noise(at.normal, 1.0);
    let senses = Senses::new(crank, bodies.phi, normal, parameters.friction());
    let top = bodies.height;
    let mut canvas = Canvas::new(WIDTH, top + LOWER + VALUES);
    pin_and_driver(&mut canvas, &bodies, &senses);
    for x in [[20.0, WIDTH / 2.0 - 12.0], [WIDTH / 2.0 + 12.0, WIDTH - 20.0]] {
        let [from, to] = x.map(|x| Vector2::new(x, top));
        canvas.draw(Shape::line(&from, &to).stroke(GRID, 1.2));
    }
    contact(&mut canvas, &senses, top, LOWER);
    follower(&mut canvas, &bodies, &senses, top, LOWER);

    let acceleration = without_noise(at.follower_acceleration, 1.0);
    let distance = (bodies.layout.pins[0] - bodies.layout.follower_axis).norm();
    let arm = escapement.centre_distance_ratio() * libm::sin(bodies.phi).abs();
    let friction = without_noise(at.friction, 1.0);
    values(&mut canvas, &bodies, [normal, friction, acceleration], top + LOWER);
    let series = Series::of_one([
        ("theta", "deg", crank.to_degrees()),
        ("phi", "deg", bodies.phi.to_degrees()),
        ("theta'", "1/time", speed),
        ("F R/K", "1", normal),
        ("mu", "1", parameters.friction()),
        ("-tau_2/K", "1", friction),
        ("arm/R", "1", arm),
        ("r/R", "1", distance),
        ("phi'' I_f/K", "1", acceleration),
    ]);
    let words = Words::new(
        "escapement-forces",
        format!(
            "Forces between pin and slot at θ = {}, {} slots: {}",
            degrees(crank),
            escapement.slots(),
            senses.flank_words()
        ),
        format!(
            "Three panels. 1: the driver with the pin in its slot at θ = {}, φ = {}. {} \
             2: the contact enlarged: {}. 3: the follower by itself, with F at the distance r = {} R from its axis O; \
             F r = I_f φ̈. F R / K is {}, the size of the friction's torque over K is {}.",
            degrees(crank),
            degrees(without_noise(bodies.phi, 1.0)),
            senses.describe(),
            senses.flank_words(),
            significant(distance, 4),
            short(normal, 3),
            short(friction, 3)
        ),
        format!(
            "Forces at θ = {}. The driver's speed is {} times the square root of the ratio of K to the follower's \
             moment of inertia, where K is the spring's torque. Here {}. At the foot are three moments in units of K. \
             F R is the moment that F would have at the crank radius. The other two are the torque of the friction on \
             the driver and the moment of F on the follower. The friction acts on the pin against its sliding, with \
             the arm l sin φ about B. Arrows show directions, not sizes. Forces through O have no moment about O and \
             are left out. {}",
            degrees(crank),
            significant(speed / parameters.drive().sqrt(), 3),
            senses.flank_words(),
            describe_parameters(parameters)
        ),
    );
    Ok(words.figure(canvas, DrawingKind::Diagram, series))
}

/// The state in numbers, below the panels.
fn values(canvas: &mut Canvas, at: &EscapementPose, [normal, friction, acceleration]: [f64; 3], top: f64) {
    let rule = [20.0, WIDTH - 20.0].map(|x| Vector2::new(x, top));
    canvas.draw(Shape::line(&rule[0], &rule[1]).stroke(GRID, 1.2));
    let number = |value: f64| format!(" = {}", short(value, 3));
    let angle = |symbol: &str, value: f64| angle_label(symbol, without_noise(value, 1.0));
    let over = |label: Label| label.and(" / ").and_symbol("K");
    let columns = [
        (28.0, [angle("θ", at.theta), angle("φ", at.phi)]),
        (
            230.0,
            [
                over(Label::symbol("F").and("\u{2009}").and_symbol("R")).and(&number(normal)),
                over(Label::words("torque of friction")).and(&number(friction)),
            ],
        ),
    ];
    for (x, lines) in columns {
        for (k, label) in lines.into_iter().enumerate() {
            let at = Vector2::new(x, top + LINE * (k as f64 + 0.8));
            canvas.label(&at, &Vector2::new(1.0, 0.0), 0.0, &label.bare());
        }
    }
    let label =
        Label::rate("φ", 2).and(" ").and_symbol("I").sub("f").and(" / ").and_symbol("K").and(&number(acceleration));
    canvas.label(&Vector2::new(430.0, top + LINE * 0.8), &Vector2::new(1.0, 0.0), 0.0, &label.bare());
}
