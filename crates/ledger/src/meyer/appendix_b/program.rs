//! What the lines of the program compute, beside the equation of motion and the mechanism by coordinates.

use super::*;
use geneva_dynamics::{Coefficients, Pose, Sign, Slots};

/// The part of the print interval by which the old acceleration is late.
pub const DELAY_PARTS: u32 = 10;

/// What the lines of the program compute at one instant.
pub struct Program {
    pub g: f64,
    pub h: f64,
    pub i: f64,
    pub j: f64,
    pub l: f64,
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub d: f64,
    pub e: f64,
    pub f: f64,
    pub s: f64,
    pub acceleration: f64,
    pub follower_speed: f64,
}

/// What the program reads, beside the number of slots and the angle.
struct Cards {
    friction: f64,
    torque: f64,
    follower: f64,
    driver: f64,
}

/// Any will do.
const CARDS: Cards = Cards { friction: 0.25, torque: 1.5, follower: 2.0, driver: 1.25 };
/// Speed of the driver in the comparison with the equation of motion.
pub const SPEED: f64 = 1.25;

impl Program {
    /// The lines in their order; the old acceleration is given.
    fn run(slots: f64, x: f64, cards: &Cards, speed: f64, old: f64) -> Self {
        let g = 1.0 / libm::sin(PI / slots);
        let h = g * libm::cos(x) - 1.0;
        let i = g * libm::sin(x);
        let j = 1.0 - g * g;
        let l = 1.0 + g * g - 2.0 * g * libm::cos(x);
        let a = cards.driver / cards.follower + (h * h) / (l * l);
        let b = (i * j * h) / (l * l * l);
        let c = (i * i * cards.friction * j) / (l * l * l);
        let d = (i * cards.friction * h) / (l * l);
        let e = cards.torque / cards.follower;
        let f = c * speed * speed + d * old;
        let s = if f < 0.0 { -1.0 } else { 1.0 };
        let acceleration = (e - (b + s * c) * (speed * speed)) / (a + s * d);
        let follower_speed = h * speed / l;
        Self { g, h, i, j, l, a, b, c, d, e, f, s, acceleration, follower_speed }
    }

    /// With the acceleration of the instant itself for the old one.
    pub fn at(slots: Slots, x: f64) -> Self {
        let old = Truth::at(slots, x).acceleration;
        Self::run(f64::from(slots.count()), x, &CARDS, SPEED, old)
    }

    /// At an instant of chapter I.
    pub fn of(letter: &Value) -> Self {
        let cards =
            Cards { friction: letter("mu"), torque: letter("K"), follower: letter("I_f"), driver: letter("I_D") };
        let slots = PI / libm::asin(1.0 / letter("a"));
        Self::run(slots, letter("theta"), &cards, letter("theta'"), letter("theta''"))
    }
}

/// The same from the equation of motion.
pub struct Truth {
    pub ratio: f64,
    pub pose: Pose<f64>,
    pub coefficients: Coefficients<f64>,
    pub acceleration: f64,
    pub sign: Sign,
}

impl Truth {
    fn at(slots: Slots, x: f64) -> Self {
        let ratio = slots.ratio();
        let pose = Pose::new(&ratio, &Turn::from_radians(x));
        let (inertia, drive) = (CARDS.driver / CARDS.follower, CARDS.torque / CARDS.follower);
        let coefficients = Coefficients::of_pose(&pose, &inertia, &CARDS.friction, &drive);
        let (acceleration, sign) =
            coefficients.acceleration(SPEED).map_or((f64::NAN, Sign::Plus), |found| (found.value, found.sign));
        Self { ratio, pose, coefficients, acceleration, sign }
    }
}

/// Whether a line agrees with the equation of motion, all over the engagements of the three mechanisms.
pub fn by_coefficients(both: fn(&Program, &Truth) -> (f64, f64)) -> Finding {
    let holds = Slots::ALL.iter().all(|slots| {
        (-9..=9).all(|k| {
            let x = slots.engagement_half_angle() * f64::from(k) / 10.0;
            let (a, b) = both(&Program::at(*slots, x), &Truth::at(*slots, x));
            vanishes((a - b) / a.abs().max(b.abs()).max(1.0))
        })
    });
    let how = if holds { "agrees" } else { "differs" };
    Finding::new(holds, format!("{how} at 19 angles of each mechanism"))
}

/// Whether a line agrees with a letter of chapter I at all its instants.
pub fn as_letters(line: fn(&Program) -> f64, name: &'static str) -> Finding {
    let holds = instants().iter().all(|letters| {
        let letter = |name: &str| letters.get(name).copied().unwrap_or(f64::NAN);
        let (a, b) = (line(&Program::of(&letter)), letter(name));
        vanishes((a - b) / a.abs().max(b.abs()).max(1.0))
    });
    Finding::new(holds, format!("against the mechanism by coordinates at {} instants", instants().len()))
}

/// All factors at once, against the equation of motion.
pub fn all_by_coefficients() -> Finding {
    by_coefficients(|lines, at| {
        let c = &at.coefficients;
        let pairs = [
            (lines.h, at.pose.lead),
            (lines.i, at.pose.cross),
            (lines.j, at.pose.shape),
            (lines.l, at.pose.square),
            (lines.a, c.a),
            (lines.b, c.b),
            (lines.c, c.c),
            (lines.d, c.d),
            (lines.e, c.e),
        ];
        (worst(&pairs), 0.0)
    })
}

/// All factors at once, against the mechanism by coordinates.
pub fn all_as_letters() -> Finding {
    equal(
        |letter| {
            let lines = Program::of(letter);
            let factors = [("A", lines.a), ("B", lines.b), ("C", lines.c), ("D", lines.d), ("E", lines.e)];
            (worst(&factors.map(|(name, value)| (value, letter(name)))), 0.0)
        },
        "A to E",
    )
}

/// The greatest difference of a pair, over the larger of the two or one.
fn worst(pairs: &[(f64, f64)]) -> f64 {
    pairs.iter().map(|(a, b)| (a - b).abs() / a.abs().max(b.abs()).max(1.0)).fold(0.0, f64::max)
}
