//! The mechanism to scale at an instant.

use super::bodies::bodies;
use super::instant::{Instant, turning, written};
use super::links::{Layout, WIDTH, length};
use super::names::{VALUES, names, scale_bar, values};
use crate::figure::{Figure, Words};
use crate::number::degrees;
use crate::series::Series;
use crate::svg::canvas::{Canvas, Kind};
use crate::svg::placing::Placing;
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn};
use nalgebra::Vector2;

/// Room for the scale bar above the mechanism.
const SCALE_BAR: f64 = 34.0;

/// The mechanism at an instant, to scale, with its angles, its senses and the ends of the lever's swing.
///
/// `drive` is in radians per second and its square; `length_unit` the unit of the linkage's lengths. If the lever at
/// its angle has a second place for the pin, the crank's position for it is drawn faintly. Series, one row: φ, ψ, β;
/// l, R, r; ω₂, α₂, ω₄, α₄; the sliding velocity, outwards positive.
pub fn mechanism(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>, length_unit: &str) -> Figure {
    let instant = Instant::new(linkage, position, drive);
    let layout = Layout::new(linkage, &instant, SCALE_BAR);
    let bottom = SCALE_BAR + layout.height;
    let mut canvas = Canvas::new(WIDTH, bottom + VALUES);
    let mut placing = Placing::within(Vector2::new(6.0, SCALE_BAR), Vector2::new(WIDTH - 6.0, bottom));
    bodies(&mut canvas, &mut placing, &layout, linkage, &instant);
    names(&mut canvas, &mut placing, &layout, linkage, &instant, drive);
    scale_bar(&mut canvas, &layout, length_unit);
    values(&mut canvas, linkage, &instant, drive, length_unit, bottom);

    let speed_unit = format!("{length_unit}/s");
    let columns = [
        ("phi", "deg"),
        ("psi", "deg"),
        ("beta", "deg"),
        ("l", length_unit),
        ("R", length_unit),
        ("r", length_unit),
        ("omega_2", "rad/s"),
        ("alpha_2", "rad/s^2"),
        ("omega_4", "rad/s"),
        ("alpha_4", "rad/s^2"),
        ("v_P2P4", speed_unit.as_str()),
    ];
    let angles = [instant.crank_angle, instant.lever_angle, instant.angle_at_pin].map(f64::to_degrees);
    let motion = &instant.motion;
    let sliding = motion.velocities.sliding_velocity.dot(&instant.along);
    let row = [
        angles[0],
        angles[1],
        angles[2],
        linkage.ground(),
        linkage.crank(),
        instant.pin_distance,
        drive.speed,
        drive.acceleration,
        motion.velocities.follower_speed,
        motion.accelerations.follower_acceleration,
        sliding,
    ];
    let [phi, psi, beta] = [instant.crank_angle, instant.lever_angle, instant.angle_at_pin].map(degrees);
    let (omega_2, omega_4) = (drive.speed, instant.lever_speed(drive));
    let kind = match linkage.strokes().swing_limit {
        Some(limit) => format!("swings between −{0} and {0}", degrees(limit)),
        None => "turns round and round".to_owned(),
    };
    let words = Words {
        id: "quick-return-mechanism".to_owned(),
        title: format!("Quick-return mechanism at a lever angle of {psi}"),
        description: format!(
            "A crank of {} turns about O2. Its pin slides in the slot of a lever that turns about O4, {} to the left of \
             O2. The crank's angle is {phi}, the lever's {psi}, the angle between them at the pin {beta}; the pin is \
             {} from O4. The crank's angular velocity is {}{}; the \
             lever's is {}{}. The lever {kind}.",
            length(linkage.crank(), length_unit),
            length(linkage.ground(), length_unit),
            written(instant.pin_distance, length_unit),
            written(omega_2.abs(), "rad/s"),
            turning(omega_2),
            written(omega_4.abs(), "rad/s"),
            turning(omega_4)
        ),
        caption:
            "The mechanism to scale. The pin P2 on the crank slides in the slot; P4 is the lever's point under it, \
                  at the same place at this instant."
                .to_owned(),
    };
    words.figure(canvas, Kind::Mechanism, Series::new(columns, [row]))
}
