//! The moving mechanism by coordinates, with a value for every letter of chapter I, at a number of instants.
//!
//! Places, velocities and accelerations of the pin are vectors ([`PinKinematics`]); forces follow from Newton's laws for the
//! two members. Nothing here is a display of the source: what a display says is read from its characters.

use super::reading::{By, Letters, Moment};
use super::*;
use std::sync::OnceLock;

/// Speeds and accelerations of the driver: braked and driven hard, so that the pin presses on either flank.
const DRIVERS: [(f64, f64); 3] = [DRIVER, (1.25, 8.0), (0.5, -3.0)];
/// Radius of the circle of the pins. Like all the following: any number will do.
const RADIUS: f64 = 1.5;
/// Moment of inertia of the driver.
const DRIVER_INERTIA: f64 = 0.75;
/// Moment of inertia of the follower.
const FOLLOWER_INERTIA: f64 = 1.75;
/// Coefficient of friction.
const FRICTION: f64 = 0.375;
/// What stands for a letter that the copy has put in the place of another.
const ODD: f64 = 2.25;
/// A small turn of the driver: a virtual displacement, in radians.
const TURN: f64 = 0.03125;

/// The letters of chapter I at instants of all three escapements, on both sides of the line of centres; and shortly
/// before and after each, at other angles and at other speeds.
pub(super) fn moments() -> &'static [Moment] {
    static MOMENTS: OnceLock<Vec<Moment>> = OnceLock::new();
    MOMENTS.get_or_init(|| {
        let each = |escapement: Mechanism| {
            [-9, -5, -1, 0, 4, 8].into_iter().flat_map(move |k| {
                let (ratio, angle) = (escapement.centre_distance_ratio(), instant(&escapement, k));
                DRIVERS.map(|driver| {
                    Moment::of(letters(ratio, angle, driver)).moving(|by, step| {
                        let (speed, angular_acceleration) = driver;
                        match by {
                            By::Time => {
                                let there = angle + speed * step + angular_acceleration * step * step / 2.0;
                                letters(ratio, there, (speed + angular_acceleration * step, angular_acceleration))
                            }
                            By::Angle => letters(ratio, angle + step, driver),
                            By::Speed => letters(ratio, angle, (speed + step, angular_acceleration)),
                        }
                    })
                })
            })
        };
        Mechanism::ALL.into_iter().flat_map(each).collect()
    })
}

/// The letters of chapter I at all instants.
pub(super) fn instants() -> impl ExactSizeIterator<Item = &'static Letters> {
    moments().iter().map(Moment::letters)
}

fn letters(ratio: f64, angle: f64, driver: (f64, f64)) -> Letters {
    let (speed, angular_acceleration) = driver;
    let now = PinKinematics::driven(ratio, angle, driver);
    // At the speed one and without acceleration of the driver: φ' and φ'' are then derivatives by θ.
    let unit = PinKinematics::driven(ratio, angle, (1.0, 0.0));
    let (turning, change) = (unit.angular_velocity(), unit.angular_acceleration());
    // How far the pin slides out per radian, in the unit of length.
    let sliding = RADIUS * unit.place.normalize().dot(&unit.velocity);
    let distance = RADIUS * now.radius();
    let normal = |angular_acceleration: f64| {
        FOLLOWER_INERTIA * PinKinematics::driven(ratio, angle, (speed, angular_acceleration)).angular_acceleration()
            / distance
    };
    let friction = |angular_acceleration: f64| FRICTION * normal(angular_acceleration) * sliding;
    // What the two members ask of the driver's torque beside friction: Newton's laws for each.
    let asked = |angular_acceleration: f64| {
        let reaction = normal(angular_acceleration) * distance * turning;
        DRIVER_INERTIA * angular_acceleration + reaction
    };
    let torque = asked(angular_acceleration) + friction(angular_acceleration).abs();
    let moving_inertia = DRIVER_INERTIA + FOLLOWER_INERTIA * turning * turning;
    let square_speed = speed * speed;
    // The growth of the kinetic energy, and what is lost by sliding: per radian of the driver.
    let grown = DRIVER_INERTIA * angular_acceleration
        + FOLLOWER_INERTIA * now.angular_velocity() * now.angular_acceleration() / speed;
    let lost =
        FRICTION * normal(angular_acceleration).abs() * (RADIUS * now.place.normalize().dot(&now.velocity)).abs()
            / speed;
    let over_follower = |torque: f64| torque / FOLLOWER_INERTIA;
    reading::by_name([
        ("a", ratio),
        ("r", RADIUS),
        ("c", ratio * RADIUS),
        ("R", distance),
        ("theta", angle),
        ("theta'", speed),
        ("theta''", angular_acceleration),
        ("phi", now.angle()),
        ("phi'", now.angular_velocity()),
        ("phi''", now.angular_acceleration()),
        ("I_D", DRIVER_INERTIA),
        ("I_f", FOLLOWER_INERTIA),
        ("I_b", ODD),
        ("I_P", ODD),
        ("mu", FRICTION),
        ("h", sliding),
        ("N", normal(angular_acceleration)),
        // By forces, and by energy.
        ("K", torque),
        ("tau_1", grown + lost),
        ("tau_2", -friction(angular_acceleration).abs()),
        ("Q_theta", grown),
        // The one coordinate that there is, by its general name.
        ("q_k", angle),
        ("q'_k", speed),
        ("q''_k", angular_acceleration),
        ("Q_k", grown),
        ("dT/dq'_k", moving_inertia * speed),
        ("dT/dq_k", FOLLOWER_INERTIA * turning * change * square_speed),
        ("tau", torque - friction(angular_acceleration).abs()),
        // A small turn, and the work of the inertias in it.
        ("delta theta", TURN),
        (
            "delta W",
            DRIVER_INERTIA * angular_acceleration * TURN
                + FOLLOWER_INERTIA * now.angular_acceleration() * turning * TURN,
        ),
        ("T", moving_inertia * square_speed / 2.0),
        ("friction", friction(angular_acceleration)),
        ("dT/dtheta'", moving_inertia * speed),
        ("dT/dtheta", FOLLOWER_INERTIA * turning * change * square_speed),
        // The square of the pin's distance, in crank radii.
        ("square", unit.place.norm_squared()),
        // Eq. (1-19): what multiplies θ'' and θ'², outside the bars and between them.
        ("A", over_follower(asked(1.0) - asked(0.0))),
        ("B", over_follower(asked(0.0)) / square_speed),
        ("C", over_follower(friction(0.0)) / square_speed),
        ("D", over_follower(friction(1.0) - friction(0.0))),
        ("E", over_follower(torque)),
        ("F", over_follower(friction(angular_acceleration))),
        ("S", if friction(angular_acceleration) < 0.0 { -1.0 } else { 1.0 }),
    ])
}

/// What each letter stands for at one instant; not a number if it stands for nothing.
pub(super) fn letters_of(moment: &Moment) -> impl Fn(&str) -> f64 {
    |name: &str| moment.letters().get(name).copied().unwrap_or(f64::NAN)
}

/// Whether an equation holds at all instants; none if it cannot be read.
pub(super) fn holds(tex: &str) -> Option<bool> {
    reading::holds(tex, moments())
}

/// Whether an equation of joined lines holds at all instants; none if it cannot be read.
pub(super) fn joined_hold(tex: &str) -> Option<bool> {
    reading::joined_holds(tex, moments())
}

/// Whether an equation holds at all instants, and the expression after the last of these operators is this one.
pub(super) fn holds_of(tex: &str, operator: &str, this: &str) -> Option<bool> {
    let Some((_, of)) = tex.rsplit_once(operator) else { return holds(tex) };
    match [holds(tex), holds(&format!("{this} = {of}"))] {
        [Some(true), Some(true)] => Some(true),
        [Some(false), _] | [_, Some(false)] => Some(false),
        _ => None,
    }
}

/// How far two numbers are apart, over the larger or one; infinite for what is not a number.
fn apart(a: f64, b: f64) -> f64 {
    let misfit = (a - b).abs() / a.abs().max(b.abs()).max(1.0);
    if misfit.is_nan() { f64::INFINITY } else { misfit }
}

/// A character of a display that the copy has lost or changed, found by evaluating the characters.
pub(super) const fn miscopied(reason: &'static str) -> Slip {
    let witness = "The corrected characters, read and evaluated, agree with Newton's laws for the two members, but \
                   the printed ones do not.";
    Slip { id: "", reason, witness, origin: Origin::Copy, consequence: Consequence::Copy, changes: "" }
}

/// The value of a letter at one instant.
pub(super) type Value<'a> = dyn Fn(&str) -> f64 + 'a;

/// Whether two numbers made of the letters are equal at all instants.
pub(super) fn equal(both: impl Fn(&Value) -> (f64, f64), how: &str) -> Finding {
    let worst = instants().map(|letters| {
        let letter = |name: &str| letters.get(name).copied().unwrap_or(f64::NAN);
        let (a, b) = both(&letter);
        apart(a, b)
    });
    let holds = worst.fold(0.0, f64::max) <= geneva_evidence::ROUTES.relative;
    Finding::new(holds, format!("{how} {} at {} instants", if holds { "agree" } else { "differ" }, instants().len()))
}
