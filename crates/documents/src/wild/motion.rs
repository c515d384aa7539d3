//! How the wheel moves.

use super::fit::{ANY, tried};
use super::*;
use crate::duals::{Crank, Time};
use geneva_evidence::agreement::vanishes;
use geneva_evidence::tex::Moment;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::{pin_from_pivot, velocity_ratio};
use geneva_kinematics::wheel::Wheel;
use geneva_kinematics::{Jet, Turn, angular_velocity};

const TWICE: &str =
    "We differentiate the direction of the pin with dual numbers, which gives the corrected form for 3 to 60 slots.";

/// A moment of the engagement: angles in radians, the rates for a driver of speed one.
#[derive(Clone, Copy)]
struct Instant {
    fit: Fit,
    /// Crank angle from the line of centres.
    crank: f64,
    /// Wheel angle from there, in the opposite sense.
    wheel: f64,
    /// Angular velocity of the wheel.
    speed: f64,
}

/// Parts of the way from the line of centres to the end of the engagement.
const PARTS: [f64; 5] = [-0.9, -0.4, 0.0, 0.3, 0.8];

/// Moments by the formula crate.
fn by_formula(slots: u32) -> Vec<Instant> {
    let fit = Fit::by_wheel(slots);
    let ratio = fit.centres / fit.crank;
    let at = |crank: f64| {
        let turn = Turn::from_radians(crank);
        let pin = pin_from_pivot(&ratio, &turn);
        Instant { fit, crank, wheel: libm::atan2(pin.y, pin.x), speed: velocity_ratio(&ratio, &turn) }
    };
    PARTS.map(|part| at(part * fit.moving / 2.0)).into()
}

/// Moments by coordinates and dual numbers.
fn by_duals(slots: u32) -> Vec<Instant> {
    let fit = Fit::by_vectors(slots);
    let at = |crank: f64| {
        // The pivot is the wheel's axis: the crank turns back while its angle from the line of centres grows.
        let dual = Crank { ground: fit.centres, radius: fit.crank, angle: PI - crank, speed: -1.0, acceleration: 0.0 };
        let [_, [_, speed, _]] = dual.polar();
        Instant { fit, crank, wheel: dual.slot(Time::from(0.0)).re, speed }
    };
    PARTS.map(|part| at(part * fit.moving / 2.0)).into()
}

/// A formula for the motion, for any number of slots, all over the engagement.
fn motion(
    place: Locator,
    id: &'static str,
    printed: &'static str,
    meaning: &'static str,
    letters: fn(&Instant) -> Vec<(&'static str, f64)>,
) -> Claim {
    let moments = |instants: fn(u32) -> Vec<Instant>| {
        move |slots| instants(slots).iter().map(|instant| Moment::default().with(letters(instant))).collect()
    };
    let (first, second) =
        ((Evidence::CLOSED_FORM, moments(by_formula)), (Evidence::AUTOMATIC_DERIVATIVE, moments(by_duals)));
    tried(place, id, printed, meaning, ANY, first, second)
}

pub(super) fn claims() -> Vec<Claim> {
    [formulas(), statements()].concat()
}

/// The letters of the speed that lacks a factor.
fn speed(of: &Instant) -> Vec<(&'static str, f64)> {
    let ratio = of.fit.crank / of.fit.centres;
    vec![(r"\omega_{out}", 3.0 * of.speed), (r"\omega_{in}", 3.0), (r"\alpha", of.crank), ("r", ratio)]
}

/// The letters of the speed that lacks a factor, on the line of centres, for a wheel of so many slots.
pub(super) fn greatest_speed(slots: u32) -> Option<Vec<(&'static str, f64)>> {
    by_formula(slots).iter().find(|instant| instant.crank == 0.0).map(speed)
}

fn formulas() -> Vec<Claim> {
    vec![
        motion(
            MISCELLANEOUS,
            "wild.firgelli-form.speed",
            r"\omega_{out} = \omega_{in} \frac{\cos\alpha - r}{1 + r^2 - 2 r \cos\alpha}",
            "speed of the wheel, where r is the crank radius over the centre distance and α the driver's angle from \
             the line of centres",
            speed,
        )
        .corrected(
            r"\omega_{out} = \omega_{in} r \frac{\cos\alpha - r}{1 + r^2 - 2 r \cos\alpha}",
            Slip {
                origin: Origin::Misprint,
                ..slip(
                    "A factor r is missing before the fraction. Any derivation from the wheel's angle gives this \
                     factor.",
                    TWICE,
                    "The speed is too high by a factor of the centre distance over the crank radius: 1.4 times the \
                     right speed with four slots, and twice the right speed with six. Loads that grow as the square of \
                     the speed are four times too high with six slots.",
                )
            },
        ),
        motion(
            RIGID,
            "wild.oxiphysics.speed",
            r"\omega_g/\omega_d = \frac{r \cos\phi}{\sqrt{d^2 + r^2 - 2 d r \sin\phi}}",
            "speed of the wheel over the speed of the driver, for crank radius r, centre distance d and driver's angle \
             φ from the line of centres",
            |of| {
                let fit = of.fit;
                let speeds = [(r"\omega_g", 3.0 * of.speed), (r"\omega_d", 3.0)];
                [&speeds[..], &[("r", fit.crank), ("d", fit.centres), (r"\phi", of.crank)]].concat()
            },
        )
        .interpreted_as(
            "The page measures the driver's angle from the line of centres. Measuring from any other place does not \
             make the formula right, because even with the best choice the ratio for six slots differs from the right \
             ratio by up to 0.50.",
        )
        .corrected(
            r"\omega_g/\omega_d = \frac{r (d \cos\phi - r)}{d^2 + r^2 - 2 d r \cos\phi}",
            slip(
                "The wheel's speed is the pin's speed across the slot, divided by the pin's distance from the wheel's \
                 axis. Both this speed and this distance depend on the cosine of the driver's angle from the line of \
                 centres. The printed ratio cannot be the ratio of the speeds, because it is not zero where the pin \
                 enters.",
                TWICE,
                "On the line of centres, the printed formula gives too small a ratio: less than one half with six \
                 slots, although the true ratio is one. At entry the printed ratio is not zero, as if the pin struck \
                 the wheel. Another module of the same library has the right formula.",
            ),
        )
        .in_places(4),
        motion(
            CONSTRAINTS,
            "wild.oxiphysics.right-speed",
            r"\omega_w = \omega \frac{r (a \cos\phi - r)}{a^2 + r^2 - 2 a r \cos\phi}",
            "speed of the wheel, in another module of the library",
            |of| {
                let fit = of.fit;
                let speeds = [(r"\omega_w", 3.0 * of.speed), (r"\omega", 3.0)];
                [&speeds[..], &[("r", fit.crank), ("a", fit.centres), (r"\phi", of.crank)]].concat()
            },
        ),
        motion(
            STYLE_SHEET,
            "wild.style-sheet.angle",
            r"\beta = \tan^{-1} \frac{r \sin\alpha}{C - r \cos\alpha}",
            "angle of the wheel while the pin is in a slot",
            |of| vec![(r"\beta", of.wheel), ("r", of.fit.crank), ("C", of.fit.centres), (r"\alpha", of.crank)],
        ),
        motion(
            COSMO,
            "wild.cosmo.angle",
            r"\beta = \sin^{-1} \frac{b \sin\gamma}{\sqrt{a^2 + b^2 - 2 a b \cos\gamma}}",
            "angle of the wheel while the pin is in a slot, by the law of sines",
            |of| vec![(r"\beta", of.wheel), ("b", of.fit.crank), ("a", of.fit.centres), (r"\gamma", of.crank)],
        ),
    ]
}

fn statements() -> Vec<Claim> {
    vec![
        KMODDL
            .statement(
                "wild.kmoddl.smooth",
                "right angle",
                "with a right angle at the pin, the pin slides into the slot smoothly",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                starts(stated, |ratio, crank| velocity_ratio(&ratio, &Turn::from_radians(crank)))
            })
            .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| starts(stated, rate_by_duals))
            .interpreted_as("“Smoothly” means here that the wheel starts from rest.")
            .but_not("the wheel does so with an angle of 80° at the pin"),
        SPECTRA
            .statement(
                "wild.spectraquest.tangent",
                "tangent to the circle",
                "for a finite acceleration the slot must touch the circle of the pin's centre",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                crosses(stated, |ratio, crank| velocity_ratio(&ratio, &Turn::from_radians(crank)))
            })
            .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| crosses(stated, rate_by_duals))
            .interpreted_as(
                "A slot that does not touch the circle sets the wheel in motion with a jump of its speed. We tried \
                 slots that meet the circle at 1° to 30°.",
            )
            .but_not("a slot that crosses it at 10° will do"),
        WIKISUM
            .statement(
                "wild.wikisum.jump",
                "discontinuity in the acceleration",
                "the wheel's acceleration jumps as the pin enters and leaves",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                jumps(stated, |wheel| [1.0, -1.0].map(|sign| sign * wheel.entry_acceleration()))
            })
            .second_route(Evidence::JET, |stated| {
                jumps(stated, |wheel| [-1.0, 1.0].map(|end| acceleration(wheel, end * wheel.engagement_half_angle())))
            })
            .but_not("the acceleration begins and ends at zero"),
        SOURCEBOOK
            .statement(
                "wild.sourcebook.maxima",
                "only in the region",
                "the acceleration has its extremes on the part of the turn that belongs to the external wheel",
            )
            .first_route(Evidence::JET, |stated| extremes(stated, acceleration))
            .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| extremes(stated, acceleration_by_duals))
            .interpreted_as(
                "We look for the places where the curve is level, over a whole turn of the crank in a slot without \
                 end.",
            )
            .but_not("the acceleration has its extremes on the part that belongs to the internal wheel"),
    ]
}

/// Speed of the wheel by dual numbers, for a driver of speed one and a ratio of centre distance to crank radius.
fn rate_by_duals(ratio: f64, crank: f64) -> f64 {
    Crank { ground: ratio, radius: 1.0, angle: PI - crank, speed: -1.0, acceleration: 0.0 }.polar()[1][1]
}

/// Whether the wheel is at rest as the pin comes to the slot: with a right angle between slot and crank, or with 80°.
fn starts(stated: Stated, speed: impl Fn(f64, f64) -> f64) -> Finding {
    let at_pin = stated.pick(PI / 2.0, 4.0 * PI / 9.0);
    let worst = ANY.map(|slots| speed_at_entry(slots, at_pin, &speed));
    let worst = worst.fold(0.0, f64::max);
    let how = if vanishes(worst) { "no speed".to_owned() } else { format!("up to {worst:.3} of the driver's speed") };
    Finding::new(vanishes(worst), format!("with 3 to 60 slots, the wheel has {how} as the pin enters"))
}

/// Speed of the wheel as the pin comes to a slot with this angle between slot and crank. By the law of sines in the triangle
/// of the axes and the pin.
fn speed_at_entry(slots: u32, at_pin: f64, speed: &impl Fn(f64, f64) -> f64) -> f64 {
    let at_wheel = PI / f64::from(slots);
    speed(libm::sin(at_pin) / libm::sin(at_wheel), PI - at_wheel - at_pin).abs()
}

/// Whether no slot that meets the pin's circle at 1°, 10° or 30°, from either side, lets the wheel start from rest; or
/// whether one at 10° does.
fn crosses(stated: Stated, speed: impl Fn(f64, f64) -> f64) -> Finding {
    let least = |degrees: &[f64]| {
        let pins = degrees.iter().flat_map(|by| [90.0 - by, 90.0 + by]).map(f64::to_radians);
        // The pin's triangle must have an angle left at the driver.
        let all =
            pins.flat_map(|pin| ANY.filter(move |slots| pin + PI / f64::from(*slots) < PI).map(move |n| (n, pin)));
        all.map(|(slots, pin)| speed_at_entry(slots, pin, &speed)).fold(f64::INFINITY, f64::min)
    };
    let least = least(stated.pick(&[1.0, 10.0, 30.0], &[10.0]));
    let holds = stated.pick(!vanishes(least), vanishes(least));
    Finding::new(
        holds,
        format!(
            "with 3 to 60 slots, a slot that crosses the circle starts the wheel with at least {least:.4} of the \
             driver's speed"
        ),
    )
}

/// Whether the acceleration has jumped as the pin enters and as it leaves, for all wheels; or is that of a wheel at rest.
fn jumps(stated: Stated, at_the_ends: impl Fn(&Wheel) -> [f64; 2]) -> Finding {
    let least = |end: usize| {
        let all = ANY.filter_map(|slots| Wheel::new(slots).ok()).map(|wheel| at_the_ends(&wheel)[end].abs());
        all.fold(f64::INFINITY, f64::min)
    };
    let ends = [0, 1].map(least);
    let holds = ends.iter().all(|least| stated.pick(!vanishes(*least), vanishes(*least)));
    let [enters, leaves] = ends;
    Finding::new(
        holds,
        format!(
            "with 3 to 60 slots, the acceleration is at least {enters:.4} of the driver's speed squared as the pin \
             enters and {leaves:.4} as it leaves"
        ),
    )
}

/// The wheel's acceleration at a crank angle, by power series, for a driver of speed one.
fn acceleration(wheel: &Wheel, crank: f64) -> f64 {
    let turn = Turn::from_radians(crank).moving::<4>(1.0);
    let pin = pin_from_pivot(&Jet::constant(wheel.centre_distance_ratio()), &turn);
    angular_velocity(&pin).and_then(|speed| speed.derivative(1)).unwrap_or(f64::NAN)
}

/// The wheel's acceleration at a crank angle, by dual numbers.
fn acceleration_by_duals(wheel: &Wheel, crank: f64) -> f64 {
    let ratio = 1.0 / libm::sin(PI / f64::from(wheel.stations()));
    Crank { ground: ratio, radius: 1.0, angle: PI - crank, speed: -1.0, acceleration: 0.0 }.polar()[1][2]
}

/// Whether the slope of the acceleration changes its sign on the external part of the turn and not on the other; or the
/// reverse.
fn extremes(stated: Stated, acceleration: impl Fn(&Wheel, f64) -> f64) -> Finding {
    // The internal part is where an internal wheel is driven: the rest of the turn.
    let turning_points = |wheel: &Wheel, from: f64, to: f64| {
        let at = |step: u32| acceleration(wheel, from + (to - from) * f64::from(step) / 720.0);
        let all: Vec<f64> = (0..=720).map(at).collect();
        let rises: Vec<bool> = all.windows(2).map(|pair| pair[1] > pair[0]).collect();
        rises.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    let all = ANY.filter_map(|slots| Wheel::new(slots).ok()).map(|wheel| {
        let end = wheel.engagement_half_angle();
        [turning_points(&wheel, -end, end), turning_points(&wheel, end, 2.0 * PI - end)]
    });
    let all: Vec<_> = all.collect();
    let [with, without] = stated.pick([0, 1], [1, 0]);
    let holds = all.iter().all(|points| points[with] == 2 && points[without] == 0);
    let [external, internal] = [0, 1].map(|part| all.iter().map(|points| points[part]).sum::<usize>());
    Finding::new(
        holds,
        format!(
            "with 3 to 60 slots, we found {external} extremes on the external part and {internal} on the internal part"
        ),
    )
}
