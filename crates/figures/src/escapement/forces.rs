//! The forces at one instant: on the pin, at the contact, on the follower.

use super::axes::short;
use super::engagement::{DrawingError, Instant};
use super::force_panels::{contact, follower, pin_and_driver};
use super::pose::{Bodies, Margins, WIDTH};
use super::senses::Senses;
use crate::figure::{Figure, Words};
use crate::number::{degrees, significant, without_noise};
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::label::Label;
use crate::svg::shape::Shape;
use crate::theme::GRID;
use geneva_dynamics::Parameters;
use nalgebra::Vector2;

const MARGINS: Margins = Margins { side: 46.0, above: 48.0, below: 30.0 };
/// Height of the two lower panels and of the values under them, in pixels.
const LOWER: f64 = 330.0;
const VALUES: f64 = 92.0;
const LINE: f64 = 28.0;

/// The forces at a driver angle (θ in radians, within ±π/m) and a driver speed (θ' ≥ 0), in three panels.
///
/// 1, the pin on the driver: the reaction to N across the slot, the friction μ N along it, and its arm c sin φ about the
/// driver's axis. 2, the contact, enlarged: the flank that the pin bears on. 3, the follower by itself with N, R and
/// its angular acceleration. Which way the forces point and which flank it is are those of the equation of motion at
/// this state; the lengths of the arrows are not to scale. The id ends with the flank: leading, trailing or neither.
/// Series: θ, φ, θ', N r/K, μ, friction's torque over K, its arm over r, R/r, φ'' over K / I_f.
///
/// # Errors
///
/// [`DrawingError`] if the angle is beyond ±π/m or not finite, or the speed negative or not finite.
pub fn forces(parameters: &Parameters, crank: f64, speed: f64) -> Result<Figure, DrawingError> {
    let escapement = parameters.mechanism();
    let bodies = Bodies::at(&escapement, crank, MARGINS)?;
    let at = Instant::new(parameters, crank, speed)?;
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
    let columns = [
        ("theta", "deg"),
        ("phi", "deg"),
        ("theta'", "1/time"),
        ("N r/K", "1"),
        ("mu", "1"),
        ("tau_2/K", "1"),
        ("arm/r", "1"),
        ("R/r", "1"),
        ("phi'' I_f/K", "1"),
    ];
    let angles = [crank, bodies.phi].map(f64::to_degrees);
    let row = [angles[0], angles[1], speed, normal, parameters.friction(), friction, arm, distance, acceleration];
    let words = Words {
        id: format!("escapement-forces-{}-{}", escapement.slots(), senses.flank_name()),
        title: format!(
            "Forces between pin and slot at θ = {}, {} slots: {}",
            degrees(crank),
            escapement.slots(),
            senses.flank_words()
        ),
        description: format!(
            "Three panels. 1: the driver with the pin in its slot at θ = {}, φ = {}. {} \
             2: the contact enlarged: {}. 3: the follower by itself, with N at the distance R = {} r from its axis O; \
             N R = I_f φ″. N r / K is {}, the friction's torque over K is {}.",
            degrees(crank),
            degrees(without_noise(bodies.phi, 1.0)),
            senses.said(),
            senses.flank_words(),
            significant(distance, 4),
            short(normal),
            short(friction)
        ),
        caption: format!(
            "Forces at θ = {}: {}. Friction acts on the pin against its sliding; its arm about B is c sin φ, \
             the distance of B from the slot's centre line. What acts through O has no moment and is left out; arrows \
             show directions, not sizes.",
            degrees(crank),
            senses.flank_words()
        ),
    };
    Ok(words.figure(canvas, Kind::Steps, Series::new(columns, [row])))
}

/// The state in numbers, below the panels.
fn values(canvas: &mut Canvas, at: &Bodies, [normal, friction, acceleration]: [f64; 3], top: f64) {
    let rule = [20.0, WIDTH - 20.0].map(|x| Vector2::new(x, top));
    canvas.draw(Shape::line(&rule[0], &rule[1]).stroke(GRID, 1.2));
    let number = |value: f64| format!(" = {}", short(value));
    let angle =
        |symbol: &str, value: f64| Label::symbol(symbol).and(&format!(" = {}", degrees(without_noise(value, 1.0))));
    let over = |label: Label| label.and(" / ").and_symbol("K");
    let columns = [
        (28.0, [angle("θ", at.theta), angle("φ", at.phi)]),
        (
            230.0,
            [
                over(Label::symbol("N").and("\u{2009}").and_symbol("r")).and(&number(normal)),
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
        Label::symbol("φ").and("″ ").and_symbol("I").sub("f").and(" / ").and_symbol("K").and(&number(acceleration));
    canvas.label(&Vector2::new(430.0, top + LINE * 0.8), &Vector2::new(1.0, 0.0), 0.0, &label.bare());
}
