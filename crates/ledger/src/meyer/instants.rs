//! The moving mechanism by coordinates, with a value for every letter of chapter I, at a number of instants.
//!
//! Places, velocities and accelerations of the pin are vectors ([`Seen`]); forces follow from Newton's laws for the
//! two members. Nothing here is a display of the source: what a display says is read from its characters.

use super::reading::{Letters, value};
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

/// The letters of chapter I at instants of all three escapements, on both sides of the line of centres.
pub fn instants() -> &'static [Letters] {
    static INSTANTS: OnceLock<Vec<Letters>> = OnceLock::new();
    INSTANTS.get_or_init(|| {
        let each = |escapement: Escapement| {
            [-9, -5, -1, 0, 4, 8].into_iter().flat_map(move |k| {
                DRIVERS.map(|driver| letters(escapement.centre_distance_ratio(), instant(&escapement, k), driver))
            })
        };
        Escapement::all().into_iter().flat_map(each).collect()
    })
}

/// The pin at an angle and a motion of the driver.
fn seen(ratio: f64, angle: f64, (speed, gain): (f64, f64)) -> Seen {
    let crank = Turn::from_radians(angle);
    let from_driver = crank.direction();
    let across = quarter_turn(&from_driver);
    let mirrored = |vector: Vector2<f64>| Vector2::new(-vector.x, vector.y);
    Seen {
        ratio,
        place: mirrored(from_driver - Vector2::new(ratio, 0.0)),
        velocity: mirrored(across * speed),
        acceleration: mirrored(across * gain - from_driver * (speed * speed)),
        crank,
    }
}

fn letters(ratio: f64, angle: f64, driver: (f64, f64)) -> Letters {
    let (speed, gain) = driver;
    let now = seen(ratio, angle, driver);
    // At the speed one and without acceleration of the driver: φ' and φ'' are then derivatives by θ.
    let unit = seen(ratio, angle, (1.0, 0.0));
    let (turning, change) = (unit.turning(), unit.turning_rate());
    // How far the pin slides out per radian, in the unit of length.
    let sliding = RADIUS * unit.place.normalize().dot(&unit.velocity);
    let distance = RADIUS * now.radius();
    let normal = |gain: f64| FOLLOWER_INERTIA * seen(ratio, angle, (speed, gain)).turning_rate() / distance;
    let friction = |gain: f64| FRICTION * normal(gain) * sliding;
    // What the two members ask of the driver's torque beside friction: Newton's laws for each.
    let asked = |gain: f64| {
        let reaction = normal(gain) * distance * turning;
        DRIVER_INERTIA * gain + reaction
    };
    let torque = asked(gain) + friction(gain).abs();
    let moving_inertia = DRIVER_INERTIA + FOLLOWER_INERTIA * turning * turning;
    // h = a cos θ − 1 and l = R²/r², from the pin's place, with their derivatives by θ.
    let square = unit.place.norm_squared();
    let square_change = 2.0 * unit.place.dot(&unit.velocity);
    let (lead, lead_change) = (turning * square, change * square + turning * square_change);
    let square_speed = speed * speed;
    let over_follower = |torque: f64| torque / FOLLOWER_INERTIA;
    [
        ("a", ratio),
        ("r", RADIUS),
        ("c", ratio * RADIUS),
        ("R", distance),
        ("theta", angle),
        ("theta'", speed),
        ("theta''", gain),
        ("phi", now.angle()),
        ("phi'", now.turning()),
        ("phi''", now.turning_rate()),
        ("I_D", DRIVER_INERTIA),
        ("I_f", FOLLOWER_INERTIA),
        ("I_b", ODD),
        ("I_P", ODD),
        ("mu", FRICTION),
        ("h", sliding),
        ("N", normal(gain)),
        ("K", torque),
        ("tau_1", torque),
        ("tau_2", -friction(gain).abs()),
        ("Q_theta", torque - friction(gain).abs()),
        ("tau", torque - friction(gain).abs()),
        ("T", moving_inertia * square_speed / 2.0),
        ("friction", friction(gain)),
        // d/dt ∂T/∂θ', ∂T/∂θ' and ∂T/∂θ.
        (MOMENTUM_RATE.1, moving_inertia * gain + 2.0 * FOLLOWER_INERTIA * turning * change * square_speed),
        (MOMENTUM.1, moving_inertia * speed),
        (POSITION_RATE.1, FOLLOWER_INERTIA * turning * change * square_speed),
        // Parts of displays that are cut into lines.
        ("inertia-term", moving_inertia * gain),
        ("moving-inertia", moving_inertia),
        ("ratio-squared", turning * turning),
        ("speed-term", 2.0 * FOLLOWER_INERTIA * turning * change * square_speed),
        ("half-speed-term", FOLLOWER_INERTIA * turning * change * square_speed),
        ("quotient-lead", speed * FOLLOWER_INERTIA * 2.0 * lead * lead_change * speed / (square * square)),
        ("quotient-square", -lead * lead * 2.0 * square * square_change * speed / (square * square * square * square)),
        ("driving-side", torque - friction(gain).abs()),
        ("inertia-side", asked(gain)),
        ("inertia-side-over", over_follower(asked(gain))),
        ("friction-over", over_follower(friction(gain).abs())),
        ("square", square),
        // Eq. (1-19): what multiplies θ'' and θ'², outside the bars and between them.
        ("A", over_follower(asked(1.0) - asked(0.0))),
        ("B", over_follower(asked(0.0)) / square_speed),
        ("C", over_follower(friction(0.0)) / square_speed),
        ("D", over_follower(friction(1.0) - friction(0.0))),
        ("E", over_follower(torque)),
        ("F", over_follower(friction(gain))),
        ("S", if friction(gain) < 0.0 { -1.0 } else { 1.0 }),
    ]
    .map(|(name, value)| (name.to_owned(), value))
    .into()
}

/// The three derivatives of the kinetic energy, as printed, and the letters that they are read as.
const MOMENTUM_RATE: (&str, &str) = (r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right)", "X");
const MOMENTUM: (&str, &str) = (r"\frac{\partial T}{\partial \dot{\theta}}", "Y");
const POSITION_RATE: (&str, &str) = (r"\frac{\partial T}{\partial \theta}", "Z");

/// Whether all sides of the equation in this claim are equal at all instants: of the correction, if there is one.
///
/// If there is, the printed characters must not hold.
pub fn reads(id: &str) -> Finding {
    characters(id, &|formula, letters| {
        let sides: Vec<f64> = formula.split('=').map(|side| value(side, letters)).collect();
        (sides.len() > 1).then(|| sides.windows(2).map(|pair| apart(pair[0], pair[1])).fold(0.0, f64::max))
    })
}

/// Whether what stands in this claim behind the last of these characters has the value of a letter at all instants.
pub fn reads_as(id: &str, behind: &str, letter: &str) -> Finding {
    characters(id, &|formula, letters| {
        let part = if behind.is_empty() { formula } else { formula.rsplit_once(behind)?.1 };
        Some(apart(value(part, letters), *letters.get(letter)?))
    })
}

/// The greatest misfit over all instants decides; `None` is a formula that cannot be read.
fn characters(id: &str, misfit: &dyn Fn(&str, &Letters) -> Option<f64>) -> Finding {
    let Some(claim) = claim(id) else { return Finding::new(false, "no such claim") };
    let holds = |formula: &str| {
        let formula = [MOMENTUM_RATE, MOMENTUM, POSITION_RATE]
            .iter()
            .fold(formula.to_owned(), |formula, (printed, letter)| formula.replace(printed, letter));
        instants()
            .iter()
            .all(|letters| misfit(&formula, letters).is_some_and(|m| m <= crate::tolerance::ROUTES.relative))
    };
    let count = instants().len();
    match &claim.erratum {
        None => Finding::new(
            holds(claim.printed),
            format!("the printed characters, read and evaluated at {count} instants"),
        ),
        Some(erratum) => Finding::new(
            holds(erratum.corrected) && !holds(claim.printed),
            format!("the corrected characters hold at {count} instants, the printed ones do not"),
        ),
    }
}

/// How far two numbers are apart, over the larger or one; infinite for what is not a number.
fn apart(a: f64, b: f64) -> f64 {
    let misfit = (a - b).abs() / a.abs().max(b.abs()).max(1.0);
    if misfit.is_nan() { f64::INFINITY } else { misfit }
}

/// A display that holds: an identity, and its characters evaluated.
pub fn display(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    proof: fn() -> Finding,
    read: fn() -> Finding,
) -> Claim {
    Claim::equation(WORK, id, locator, meaning, printed, Check::equation((ExactIdentity, proof), (ClosedForm, read)))
}

/// A display with a slip: refuted as printed, proven as corrected, and the characters of both evaluated.
pub fn slip(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    [as_printed, put_right]: [fn() -> Finding; 2],
    read: fn() -> Finding,
    erratum: Erratum,
) -> Claim {
    let check = Check::corrected_equation((ExactIdentity, as_printed), put_right, (ClosedForm, read));
    Claim::equation(WORK, id, locator, meaning, printed, check).expecting(Verdict::Corrected).with_erratum(erratum)
}

/// The erratum of a display that the copy has changed and whose characters have been evaluated.
pub fn miscopied(corrected: &'static str, reason: &'static str) -> Erratum {
    let witness = "The corrected characters, read and evaluated, agree with Newton's laws \
            for the two members; the printed ones do not.";
    Erratum {
        corrected,
        slip: Slip { id: "", reason, witness, origin: Origin::Copy, consequence: Consequence::Copy, changes: "" },
    }
}

/// The same, where the source itself has it so.
pub fn misprinted(corrected: &'static str, reason: &'static str) -> Erratum {
    let Erratum { slip, .. } = miscopied(corrected, reason);
    Erratum { corrected, slip: Slip { origin: Origin::Misprint, consequence: Consequence::Derivation, ..slip } }
}

/// A statement that holds, with its two routes.
pub fn statement(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    first: (Evidence, fn() -> Finding),
    second: (Evidence, fn() -> Finding),
) -> Claim {
    Claim::statement(WORK, id, locator, meaning, printed, Check::equation(first, second))
}

/// The value of a letter at one instant.
pub type Value<'a> = dyn Fn(&str) -> f64 + 'a;

/// Whether two numbers made of the letters are equal at all instants.
pub fn equal(both: fn(&Value) -> (f64, f64), how: &str) -> Finding {
    let worst = instants().iter().map(|letters| {
        let letter = |name: &str| letters.get(name).copied().unwrap_or(f64::NAN);
        let (a, b) = both(&letter);
        apart(a, b)
    });
    let holds = worst.fold(0.0, f64::max) <= crate::tolerance::ROUTES.relative;
    Finding::new(holds, format!("{how}: {} at {} instants", if holds { "agrees" } else { "differs" }, instants().len()))
}
