//! Numbers of the page that compares the section with its newest edition: what that prints, and what follows from it.

use crate::kinds::{BALANCE, IN_STEPS};
use crate::letters::force_by_parcels;
use crate::section::{AIR, GRAVITY, turned};
use crate::steps::{halved, limiting, line, solved};
use geneva_evidence::{Evidence, GIVEN, OwnNumber};
use std::sync::LazyLock;

/// Factors of the parachute's drag in kg/s: that of 2022 and the newest one.
const FACTORS: [f64; 2] = [0.750, 7.50];
/// Areas of the squirrel in cm²: that of 2022 and the newest one.
const AREAS: [f64; 2] = [930.0, 650.0];
/// Drag coefficients of the horizontal skydiver, which the problem asked for in 2022, and of the one who falls feet first.
const COEFFICIENTS: [f64; 2] = [1.0, 0.70];
/// Forces on the child in newtons: that of 2022 and the newest one.
const PUSHES: [f64; 2] = [34.0, 13.4];

/// A number that an edition prints and no claim has.
fn quoted(id: &'static str, form: &'static str, number: f64) -> OwnNumber {
    OwnNumber::new(id, form, GIVEN, move || Ok(number))
}

/// The time below the parachute from 98 m/s on, for the 1030 m that are left of 1520 m.
fn parachute_time() -> OwnNumber {
    let [constant, limit] = [82.0 / FACTORS[1], 82.0 * GRAVITY / FACTORS[1]];
    OwnNumber::new("right.time", "{.2}&nbsp;s", Evidence::CLOSED_FORM, move || {
        // Newton's steps towards the time at which the exponential law gives the way.
        Ok((0..50).fold(5.0, |time: f64, _| {
            let gone = -libm::expm1(-time / constant);
            let way = limit * time + (98.0 - limit) * constant * gone;
            time - (way - (1520.0 - 490.0)) / (98.0 + (limit - 98.0) * gone)
        }))
    })
    .with_second_route("the corrected time is wrong in its last digit", IN_STEPS, || {
        let fallen = |time| line(98.0, time, |speed| GRAVITY - FACTORS[1] * speed / 82.0)[1];
        Ok(halved([0.0, 20.0], |time| fallen(time) < 1520.0 - 490.0))
    })
}

/// The terminal speed of the squirrel with this drag coefficient and this area in cm².
fn squirrel(id: &'static str, conclusion: &'static str, [coefficient, area]: [f64; 2]) -> OwnNumber {
    OwnNumber::new(id, "{.1}&nbsp;m/s", Evidence::CLOSED_FORM, move || {
        Ok((2.0 * 0.560 * GRAVITY / (AIR * coefficient * area / 1e4)).sqrt())
    })
    .with_second_route(conclusion, IN_STEPS, move || {
        Ok(limiting(60.0, |speed| GRAVITY - force_by_parcels([coefficient, AIR, area / 1e4, speed]) / 0.560))
    })
}

/// The friction coefficient of the child who slides down at constant speed.
fn child() -> OwnNumber {
    OwnNumber::new("right.friction", "{.2}", Evidence::CLOSED_FORM, || {
        let [sine, cosine] = turned(35.0);
        Ok(sine / cosine - PUSHES[1] / (6.0 * GRAVITY * cosine))
    })
    .with_second_route("the corrected force is possible", BALANCE, || {
        let [sine, cosine] = turned(35.0);
        // The forces level and upright, of the slope and of the friction up the slope.
        let right = [-PUSHES[1] * cosine, 6.0 * GRAVITY - PUSHES[1] * sine];
        let [normal, friction] = solved([[-sine, cosine], [cosine, sine]], right);
        Ok(friction / normal)
    })
}

/// The acceleration of the two blocks while block 1 slides down its slope.
fn sliding_down() -> OwnNumber {
    OwnNumber::new("other.acceleration", "{.1}&nbsp;m/s²", Evidence::CLOSED_FORM, || {
        let [sine, cosine] = turned(37.0);
        Ok((8.0 - 4.0 * sine + 0.40 * 4.0 * cosine) * GRAVITY / 12.0)
    })
    .with_second_route("the answer depends on the direction", BALANCE, || {
        let [sine, cosine] = turned(37.0);
        let normal = 4.0 * GRAVITY * cosine;
        Ok(solved([[4.0, -1.0], [8.0, 1.0]], [0.40 * normal - 4.0 * GRAVITY * sine, 8.0 * GRAVITY])[0])
    })
}

static NUMBERS: LazyLock<Vec<OwnNumber>> = LazyLock::new(|| {
    vec![
        quoted("early.factor", "{.3}", FACTORS[0]),
        quoted("late.factor", "{.2}", FACTORS[1]),
        quoted("late.time", "{.1}&nbsp;s", 10.1),
        parachute_time(),
        quoted("late.spread-area", "{.2}&nbsp;m²", 0.70),
        quoted("early.area", "{.0}&nbsp;cm²", AREAS[0]),
        quoted("late.area", "{.0}&nbsp;cm²", AREAS[1]),
        squirrel("right.first-alone", "the first correction alone is right", [COEFFICIENTS[1], AREAS[0]]),
        squirrel("right.second-alone", "the second correction alone is right", [COEFFICIENTS[0], AREAS[1]]),
        squirrel("right.both", "both corrections together are wrong", [COEFFICIENTS[1], AREAS[1]]),
        quoted("early.push", "{.0}&nbsp;N", PUSHES[0]),
        quoted("late.push", "{.1}&nbsp;N", PUSHES[1]),
        child(),
        sliding_down(),
    ]
});

/// The numbers of the page.
pub(crate) fn own_numbers() -> &'static [OwnNumber] {
    &NUMBERS
}
