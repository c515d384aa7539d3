//! The leaflet: its claims, each with two routes, and its two mistakes.

use crate::letters::{hold_by_means, hold_in_steps};
use crate::steps;
use geneva_evidence::{
    Agreement, Cache, Claim, Consequence, Document, Evidence, Finding, InventoryFile, Locator, Origin, ROUTES, Slip,
    Symbol, Tolerance,
};
use std::f64::consts::{PI, TAU};

/// For what follows from measured sizes and masses of bodies.
static MEASURED: Tolerance = Tolerance {
    name: "measured bodies",
    relative: 1e-3,
    reason: "the Earth is flattened, and a sphere in its place changes gravity by up to a thousandth",
};

/// Equations of motion solved in small steps of time: so many that they agree with a formula as far as arithmetic goes.
pub const IN_STEPS: &Evidence =
    &Evidence::between_routes("in-steps", "steps of time", "an equation of motion solved in small steps of time");

/// What is known of the Earth and the Moon.
pub const BODIES: &Evidence = &Evidence {
    slug: "bodies",
    name: "the bodies",
    meaning: "sizes, masses and densities of the Earth and the Moon",
    agreement: Agreement::Within(&MEASURED),
};

/// The leaflet.
pub static LEAFLET: Document = Document {
    slug: "leaflet",
    title: "leaflet",
    citation: "Falling and swinging, a leaflet for an open day, made up as an example",
    inventory: Some(InventoryFile {
        path: "examples/bodies/leaflet.inventory",
        text: include_str!("../leaflet.inventory"),
    }),
    claims,
    answers: &["leaflet.fall-time", "leaflet.short-period", "leaflet.short-rate"],
    given: || ["leaflet.gravity", "leaflet.moon-gravity"].map(str::to_owned).into(),
    conclusions: &[],
    symbols: &[
        Symbol { printed: "g", ours: "g", meaning: "acceleration of a falling body" },
        Symbol { printed: "h", ours: "h", meaning: "height fallen through" },
        Symbol { printed: "t", ours: "t", meaning: "time of the fall" },
        Symbol { printed: "v", ours: "v", meaning: "speed" },
        Symbol { printed: "m", ours: "m", meaning: "mass" },
        Symbol { printed: "l", ours: "l", meaning: "length of the pendulum" },
        Symbol { printed: "T", ours: "T", meaning: "period, to and fro" },
    ],
    units: &[
        ("acceleration", "m/s²"),
        ("time", "s"),
        ("speed", "m/s"),
        ("speed in kilometres", "km/h"),
        ("height", "m"),
        ("length", "m"),
        ("period", "s"),
        ("swings", ""),
        ("lengthening", "%"),
    ],
    test: "cargo test -p geneva-example-bodies",
    cache: Cache::new(),
};

/// The height of the tower, in metres.
const TOWER: f64 = 50.0;
/// Two digits that have changed places.
const SWAPPED: Slip = Slip {
    id: "",
    reason: "The speed in m/s times 3.6 gives 113 km/h: two digits have changed places.",
    witness: "The body moved in steps of time strikes the ground at 113 km/h.",
    origin: Origin::Misprint,
    consequence: Consequence::Number,
    changes: "The stone is slower.",
};
/// The period of the short pendulum.
const PERIOD: Slip = Slip {
    id: "leaflet.short-period",
    reason: "By the leaflet's own formula the period is half of that of the pendulum of 1 m.",
    witness: "The pendulum moved in steps of time takes 1.00 s.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Result,
    changes: "The pendulum swings faster, 59.8 times a minute.",
};

/// The number that a claim of the leaflet prints.
fn printed(id: &str) -> f64 {
    LEAFLET.printed_number(id)
}

fn gravity() -> f64 {
    printed("leaflet.gravity")
}

/// The period of a pendulum of this length in metres, in seconds.
fn period(length: f64) -> f64 {
    TAU * (length / gravity()).sqrt()
}

fn claims() -> Vec<Claim> {
    [laws(), falls(), sentences(), pendulums()].into_iter().flatten().collect()
}

/// Whether two numbers are equal, as far as arithmetic goes.
fn is_near(a: f64, b: f64) -> bool {
    ROUTES.agrees(a, b)
}

fn laws() -> Vec<Claim> {
    let equation = |line, id, printed, meaning| {
        let here = Locator::new(&LEAFLET, line);
        here.equation(id, printed, meaning)
            .evaluated(Evidence::CLOSED_FORM, hold_by_means)
            .read(IN_STEPS, hold_in_steps)
    };
    vec![
        Locator::new(&LEAFLET, "line 5")
            .value("leaflet.gravity", "9.81", "m/s²", "acceleration of a falling body")
            // Normal gravity of 1980 over the latitude.
            .first_route(Evidence::CLOSED_FORM, || {
                let square = 0.5;
                9.780_326_771_5 * (1.0 + 0.001_931_851_353 * square) / (1.0 - 0.006_694_380_022_9_f64 * square).sqrt()
            })
            // Mass of the Earth over the square of its radius at this latitude, less the pull outwards of its turning.
            .second_route(BODIES, || {
                let (radius, turning) = (6.3675e6, TAU / 86_164.1);
                3.986_004e14 / (radius * radius) - turning * turning * radius * 0.5
            })
            .interpreted_as("at sea level at a latitude of 45°"),
        equation("line 7", "leaflet.speed-law", "v = g t", "speed of a falling body"),
        equation("line 9", "leaflet.height-law", r"h = \frac{1}{2} g t^2", "height fallen through"),
        equation("line 11", "leaflet.speed-height", "v^2 = 2 g h", "speed by the height"),
        equation("line 13", "leaflet.energy", r"m g h = \frac{1}{2} m v^2", "energy of a falling body"),
        equation("line 25", "leaflet.period-law", r"T = 2 \pi \sqrt{\frac{l}{g}}", "period of a pendulum"),
        equation("line 27", "leaflet.length-law", r"l = \frac{g T^2}{4 \pi^2}", "length of a pendulum"),
    ]
}

fn falls() -> Vec<Claim> {
    let at = |line| Locator::new(&LEAFLET, line);
    vec![
        at("line 15")
            .value("leaflet.fall-time", "3.19", "s", "time of the fall from the tower")
            .first_route(Evidence::CLOSED_FORM, || (2.0 * TOWER / gravity()).sqrt())
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || TOWER / (printed("leaflet.impact-speed") / 2.0)),
        at("line 16")
            .value("leaflet.impact-speed", "31.3", "m/s", "speed at the ground")
            .first_route(Evidence::CLOSED_FORM, || (2.0 * gravity() * TOWER).sqrt())
            .second_route(IN_STEPS, move || steps::fall(gravity(), steps::fall_time(gravity(), TOWER))[1]),
        at("line 16")
            .value("leaflet.impact-speed-road", "131", "km/h", "speed in kilometres per hour at the ground")
            .first_route(Evidence::CLOSED_FORM, || 3.6 * (2.0 * gravity() * TOWER).sqrt())
            .second_route(IN_STEPS, move || {
                steps::fall(gravity(), steps::fall_time(gravity(), TOWER))[1] * 3600.0 / 1000.0
            })
            .corrected("113", SWAPPED),
        at("line 17")
            .value("leaflet.half-way", "12.5", "m", "height fallen through in half the time")
            .first_route(Evidence::LIMIT_CASE, || TOWER / 4.0)
            .second_route(IN_STEPS, move || steps::fall(gravity(), steps::fall_time(gravity(), TOWER) / 2.0)[0]),
        at("line 18")
            .value("leaflet.two-seconds", "19.6", "m", "height fallen through in two seconds")
            .first_route(Evidence::CLOSED_FORM, || gravity() * 4.0 / 2.0)
            .second_route(IN_STEPS, move || steps::fall(gravity(), 2.0)[0]),
        at("line 18")
            .value("leaflet.third-second", "24.5", "m", "height fallen through in the third second")
            .first_route(Evidence::CLOSED_FORM, || gravity() * (9.0 - 4.0) / 2.0)
            .second_route(IN_STEPS, move || steps::fall(gravity(), 3.0)[0] - steps::fall(gravity(), 2.0)[0]),
        at("line 22")
            .value("leaflet.moon-gravity", "1.62", "m/s²", "acceleration of a falling body on the Moon")
            .first_route(BODIES, || 4.9028e12 / 1.7374e6 / 1.7374e6)
            // From the mean density, in kilograms per cubic metre.
            .second_route(BODIES, || 4.0 / 3.0 * PI * 6.6743e-11 * 3344.0 * 1.7374e6),
        at("line 22")
            .value("leaflet.moon-time", "7.86", "s", "time of the fall on the Moon")
            .first_route(Evidence::CLOSED_FORM, || (2.0 * TOWER / printed("leaflet.moon-gravity")).sqrt())
            .second_route(IN_STEPS, move || steps::fall_time(printed("leaflet.moon-gravity"), TOWER)),
    ]
}

fn sentences() -> Vec<Claim> {
    let at = |line| Locator::new(&LEAFLET, line);
    vec![
        at("line 17")
            .statement(
                "leaflet.quarter",
                r"After half the time \ldots a quarter of the height",
                "height fallen through in half the time",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let part = |numbers: &[f64]| stated.pick(numbers[1], 0.5) == numbers[0] * numbers[0];
                let numbers = stated.numbers();
                Finding::new(numbers.len() == 2 && part(&numbers), "the height is as the square of the time")
            })
            .second_route(IN_STEPS, move |stated| {
                let numbers = stated.numbers();
                let part = |time| steps::fall(gravity(), time)[0] / steps::fall(gravity(), 1.0)[0];
                let holds = numbers.len() == 2 && is_near(part(numbers[0]), stated.pick(numbers[1], 0.5));
                Finding::new(holds, "a body moved in steps of time has fallen so far")
            })
            .but_not("after half the time, half of the height"),
        at("line 19")
            .statement("leaflet.odd-numbers", "1 : 3 : 5", "ways in successive seconds")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let ways = stated.pick(stated.numbers(), vec![1.0, 2.0, 3.0]);
                let squares = [1.0, 4.0 - 1.0, 9.0 - 4.0];
                Finding::new(ways == squares, "the differences of successive squares are 1, 3 and 5")
            })
            .second_route(IN_STEPS, move |stated| {
                let height = |time: f64| steps::fall(gravity(), time)[0];
                let ways = stated.pick(stated.numbers(), vec![1.0, 2.0, 3.0]);
                let moved = [1.0, 2.0, 3.0].map(|time| (height(time) - height(time - 1.0)) / height(1.0));
                let holds = ways.len() == 3 && ways.iter().zip(moved).all(|(way, moved)| is_near(*way, moved));
                Finding::new(holds, "a body moved in steps of time goes these ways")
            })
            .but_not("the ways are as 1 : 2 : 3"),
        at("line 20")
            .statement("leaflet.heavy", "A heavy stone falls as fast as a light stone", "falls of two masses")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // By the energy, mass times gravity times height is half the mass times the square of the speed.
                let speed = |mass: f64| (2.0 * mass * gravity() * TOWER / mass).sqrt();
                let ratio = speed(8.0) / speed(2.0);
                Finding::new(
                    stated.pick(is_near(ratio, 1.0), ratio > 1.0 && !is_near(ratio, 1.0)),
                    "the mass drops out of the energy",
                )
            })
            .second_route(IN_STEPS, move |stated| {
                let time = |mass: f64| steps::fall_time(mass * gravity() / mass, TOWER);
                let ratio = time(2.0) / time(8.0);
                let holds = stated.pick(is_near(ratio, 1.0), ratio > 1.0 && !is_near(ratio, 1.0));
                Finding::new(holds, "the force of gravity grows with the mass")
            })
            .but_not("a heavy stone falls faster"),
        at("line 21").value("leaflet.air", "0.04", "s", "time by which air lengthens the fall").missing(
            "The leaflet says neither how large nor how heavy the stone is, and the drag of the air depends on both",
        ),
    ]
}

fn pendulums() -> Vec<Claim> {
    let at = |line| Locator::new(&LEAFLET, line);
    vec![
        at("line 28")
            .value("leaflet.long-period", "2.01", "s", "period of the pendulum of 1 m")
            .first_route(Evidence::CLOSED_FORM, || period(1.0))
            .second_route(IN_STEPS, move || steps::small_period(gravity(), 1.0)),
        at("line 28")
            .value("leaflet.long-rate", "29.9", "", "swings a minute of the pendulum of 1 m")
            .first_route(Evidence::CLOSED_FORM, || 60.0 / period(1.0))
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || 60.0 / printed("leaflet.long-period")),
        at("line 29")
            .value("leaflet.short-period", "1.04", "s", "period of the pendulum of 0.25 m")
            .first_route(Evidence::CLOSED_FORM, || period(0.25))
            .second_route(IN_STEPS, move || steps::small_period(gravity(), 0.25))
            .corrected("1.00", PERIOD),
        at("line 29")
            .value("leaflet.short-rate", "57.7", "", "swings a minute of the pendulum of 0.25 m")
            .first_route(Evidence::CLOSED_FORM, || 60.0 / printed("leaflet.short-period"))
            .second_route(Evidence::LIMIT_CASE, || {
                // Whole swings, and the part of a swing that is left of the minute.
                let period = printed("leaflet.short-period");
                let whole = (60.0 / period).floor();
                whole + (60.0 - whole * period) / period
            })
            .right(
                Evidence::CLOSED_FORM,
                || 60.0 / period(0.25),
                IN_STEPS,
                move || 60.0 / steps::small_period(gravity(), 0.25),
            )
            .in_error(PERIOD),
        at("line 30")
            .value("leaflet.clock-length", "0.994", "m", "length of the pendulum of 2 s")
            .first_route(Evidence::CLOSED_FORM, || gravity() / (PI * PI))
            // The period is as the root of the length.
            .second_route(IN_STEPS, move || (2.0 / steps::small_period(gravity(), 1.0)).powi(2)),
        at("line 31")
            .statement("leaflet.four-times", "Four times the length gives twice the period", "periods of two lengths")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let numbers = stated.numbers();
                let holds = numbers.len() == 2 && is_near(numbers[0].sqrt(), stated.pick(numbers[1], 4.0));
                Finding::new(holds, "the period is as the root of the length")
            })
            .second_route(IN_STEPS, move |stated| {
                let numbers = stated.numbers();
                let ratio = |length| steps::small_period(gravity(), length) / steps::small_period(gravity(), 1.0);
                let holds = numbers.len() == 2 && is_near(ratio(numbers[0]), stated.pick(numbers[1], 4.0));
                Finding::new(holds, "pendulums moved in steps of time swing so")
            })
            .but_not("four times the length gives four times the period"),
        at("line 32")
            .value("leaflet.wide-swing", "7.3", "%", "lengthening of the period by a swing of 60° to each side")
            // The arithmetic and the geometric mean of 1 and cos 30°, taken again and again.
            .first_route(Evidence::CLOSED_FORM, || {
                let means = (0..6).fold([1.0, 0.75_f64.sqrt()], |[a, b]: [f64; 2], _| [(a + b) / 2.0, (a * b).sqrt()]);
                100.0 * (1.0 / means[0] - 1.0)
            })
            .second_route(IN_STEPS, steps::lengthening),
    ]
}
