//! What the text says of Geneva wheels before the first equation.

use super::*;
use geneva_kinematics::pin_proofs::{StandstillOfFourSlots, four_slot_entry_misfit};
use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::wheel::Phase;
use geneva_kinematics::wheel_proofs::LoopClosure;
use geneva_kinematics::{Field, Rational, Surd, prove};

const INDEXING: &str = "1st paragraph";
const VARIETIES: &str = "2nd paragraph";
const SIMPLE: &str = "Paragraph on Fig. 5.28";
const CAPTION: &str = "Fig. 5.28, caption";
const MODEL: &str = "Paragraph below Fig. 5.28";

pub fn claims() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "jazar.one-direction",
            INDEXING,
            "the wheel never turns back",
            "same direction",
            Check::equation(
                (Series, || {
                    for_all_stations(|wheel| engagement(wheel).all(|t| by_series(wheel, t)[1] >= 0.0), "φ̇ ≥ 0")
                }),
                (LimitCase, || for_all_stations(never_goes_back, "the wheel's angle never falls over two turns")),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.slider-crank",
            VARIETIES,
            "while it advances it is an inverted slider crank: the pin is on a crank and in a slot through the wheel's axis",
            "inverted slider crank",
            Check::equation(
                (ExactIdentity, || prove(&LoopClosure { along: true }).into()),
                (Vectors, || {
                    for_all_stations(|w| engagement(w).all(|t| in_the_slot(w, t)), "the pin lies on the slot's line")
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.journal-bearing",
            VARIETIES,
            "while it holds, the wheel's arc and the driver's journal are a bearing: they have the same centre",
            "journal bearing",
            Check::equation(
                (Vectors, || for_all_stations(concentric, "an arc has its centre on the driver's axis in the dwell")),
                (LimitCase, || {
                    for_all_stations(
                        |w| w.at(0, PI).is_ok_and(|m| m.phase == Phase::Dwell),
                        "the wheel is locked when the pin points away",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.quarter-turn",
            SIMPLE,
            "the wheel of four advances a quarter turn for every turn of the driver",
            "one-quarter turn",
            Check::equation(
                (Vectors, || same(of(4, |wheel| 2.0 * by_series(wheel, wheel.engagement_half_angle())[0]), PI / 2.0)),
                (ClosedForm, || same(of(4, |wheel| 2.0 * wheel.half_station()), PI / 2.0)),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.tangent-entry",
            SIMPLE,
            "unless the slot is tangent to the pin's circle at entry and exit, the acceleration there is infinite",
            "tangent",
            Check::equation(
                (LimitCase, || {
                    // A slot at 45° and a centre distance of 1.3 radii: the pin enters across, the wheel starts with a jump.
                    let jump = start_of_a_quartered_wheel(1.3);
                    Finding::new(
                        jump.abs() > 0.1,
                        format!("at l = 1.3 r the wheel starts with the speed {jump:.3} θ̇ at once"),
                    )
                }),
                (ExactIdentity, || prove(&StandstillOfFourSlots).into()),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.centre-distance",
            SIMPLE,
            "centre distance of the wheel of four",
            r"\sqrt{2}r",
            Check::equation(
                (ExactIdentity, || {
                    type WithTwo = Surd<Rational, 2>;
                    let misfit = four_slot_entry_misfit(&WithTwo::root());
                    Finding::new(
                        misfit == WithTwo::integer(0),
                        "with the root exact the pin enters at rest on its circle",
                    )
                }),
                (ClosedForm, || same(of(4, Wheel::centre_distance_ratio), 2f64.sqrt())),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.wheel-radius",
            SIMPLE,
            "outer radius of the wheel of four: the crank radius",
            "outer radius r",
            Check::equation(
                (ClosedForm, || same(of(4, Wheel::wheel_radius_ratio), 1.0)),
                (Vectors, || same(of(4, |wheel| entry(wheel).norm()), 1.0)),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.cutout-centres",
            SIMPLE,
            "radius of the circle of the locking arcs' centres, four stations",
            r"\sqrt{2}r",
            Check::equation(
                (ClosedForm, || same(of(4, Wheel::locking_centres_ratio), 2f64.sqrt())),
                (Vectors, || {
                    // In the dwell an arc is concentric with the driver, which is where the pin's circle has its centre.
                    same(
                        of(4, |wheel| {
                            (entry(wheel) + Turn::from_radians(wheel.engagement_half_angle()).direction()).norm()
                        }),
                        2f64.sqrt(),
                    )
                }),
            ),
        ),
        Claim::figure(
            WORK,
            "jazar.fig-5.28",
            CAPTION,
            "a four-station wheel advances for a quarter of the cycle and is locked for three quarters",
            "one-quarter, three-quarters",
            Check::equation(
                (ClosedForm, || same(of(4, Wheel::motion_fraction), 0.25)),
                (LimitCase, || same(of(4, locked_part), 0.75)),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.speeds-up-then-slows-down",
            MODEL,
            "the wheel accelerates and then decelerates; smoothly, but for the jumps at the ends",
            "accelerates and then decelerates",
            Check::equation(
                (Series, || {
                    for_all_stations(
                        |wheel| changes_sign_once(wheel, |w, t| by_series(w, t)[2]),
                        "φ̈ changes sign once, at θ = 0",
                    )
                }),
                (ClosedForm, || {
                    for_all_stations(
                        |wheel| changes_sign_once(wheel, |w, t| w.engaged(t).map_or(f64::NAN, |m| m.acceleration)),
                        "the same by the formula",
                    )
                }),
            ),
        ),
    ]
}

/// Crank angles over the engagement, the ends left out.
fn engagement(wheel: &Wheel) -> impl Iterator<Item = f64> {
    let end = wheel.engagement_half_angle();
    (-10..=10).map(move |step| end * f64::from(step) / 11.0)
}

/// Whether the direction of the pin is that of a slot which turns with the wheel, by the formula's angle.
fn in_the_slot(wheel: &Wheel, crank: f64) -> bool {
    let pin = pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(crank));
    let slot = wheel.engaged(crank).map_or(f64::NAN, |motion| motion.angle);
    vanishes(pin.perp(&Turn::from_radians(slot).direction()))
}

/// Whether the centre of the arc between two slots lies on the driver's axis while the wheel is locked.
fn concentric(wheel: &Wheel) -> bool {
    // In the wheel the arc is half a station behind the slot that the pin has left.
    let arc = wheel.at(0, PI).map_or(f64::NAN, |motion| motion.angle.abs()) - wheel.half_station();
    let centre = Turn::from_radians(arc).direction() * wheel.locking_centres_ratio();
    vanishes((centre - nalgebra::Vector2::new(wheel.centre_distance_ratio(), 0.0)).norm())
}

fn never_goes_back(wheel: &Wheel) -> bool {
    let angle = |turns: i64, crank: f64| {
        wheel.at(turns, crank).map_or(f64::NAN, |m| m.stations as f64 * 2.0 * wheel.half_station() + m.angle)
    };
    let crank = |step: i32| PI * f64::from(step) / 25.0;
    let angles: Vec<f64> = [0, 1].iter().flat_map(|n| (-25..25).map(move |k| angle(*n, crank(k)))).collect();
    angles.windows(2).all(|pair| pair[0] <= pair[1] + crate::tolerance::CLOSURE.relative)
}

/// The wheel's speed over the driver's as a pin enters a slot at 45°, for another centre distance.
fn start_of_a_quartered_wheel(ratio: f64) -> f64 {
    // k − cos θ = sin θ on the side of the driver: cos θ = (k + √(2 − k²)) / 2.
    let cos = (ratio + (2.0 - ratio * ratio).sqrt()) / 2.0;
    velocity_ratio(&ratio, &Turn { cos, sin: cos - ratio })
}

/// Part of a turn of the driver in which the wheel is locked, by counting.
fn locked_part(wheel: &Wheel) -> f64 {
    let steps = 4000;
    let middles = (0..steps).map(|k| PI * (2.0 * (f64::from(k) + 0.5) / f64::from(steps) - 1.0));
    let locked = middles.filter(|t| wheel.at(0, *t).is_ok_and(|m| m.phase == Phase::Dwell)).count();
    locked as f64 / f64::from(steps)
}

fn changes_sign_once(wheel: &Wheel, acceleration: fn(&Wheel, f64) -> f64) -> bool {
    engagement(wheel).all(|t| acceleration(wheel, t) * t <= 0.0)
}
