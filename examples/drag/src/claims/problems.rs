//! The problems on drag.

use super::terminal::{terminal, terminal_in_steps};
use crate::kinds::{BALANCE, ENERGY, IN_STEPS, UNITS};
use crate::letters::{SPHERE, force_by_energy, force_by_parcels};
use crate::section::{AIR, GRAVITY, at, is_near, law, printed};
use crate::steps::{halved, line, simpson};
use geneva_evidence::{Claim, Consequence, Dimension, Evidence, Finding, Origin, Slip};
use std::f64::consts::PI;

/// The skydiver of line 331, and the squirrel with the drag coefficient that the problem asks for.
const DIVER: [f64; 3] = [80.0, 0.70, 0.140];
const SQUIRREL: [f64; 3] = [0.560, 1.0, 0.0930];

/// The drag coefficient of the squirrel.
const OTHER_COEFFICIENT: Slip = Slip {
    id: "",
    reason: "The problem asks for the drag coefficient of a horizontal skydiver, which is 1.0 in the table. The printed speed belongs \
             to 0.70, that of the upright skydiver.",
    witness: "A squirrel moved in steps of time with the drag coefficient 1.0 gets no faster than 9.88 m/s.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Result,
    changes: "The squirrel's terminal speed is 9.88 m/s, just less than the speed at which the person falls down.",
};
/// The bacterium's weight in water.
const BUOYANCY: Slip = Slip {
    id: "",
    reason: "The bacterium is only a tenth denser than water. The buoyancy bears ten elevenths of its weight, so the drag is one \
             eleventh of it.",
    witness: "Summed over its surface, the pressure of the water bears ten elevenths of the weight.",
    origin: Origin::Concept,
    consequence: Consequence::Remark,
    changes: "The terminal speed is eleven times less.",
};

pub(super) fn claims() -> Vec<Claim> {
    [skydivers(), cars(), drops(), sinking()].into_iter().flatten().collect()
}

fn skydivers() -> Vec<Claim> {
    vec![
        at("line 333")
            .value("drag.head-speed", "115", "m/s", "speed of a skydiver of 80 kg, head first")
            .first_route(Evidence::CLOSED_FORM, || terminal(DIVER))
            .second_route(IN_STEPS, || terminal_in_steps(DIVER)),
        at("line 333")
            .value("drag.head-speed-road", "414", "km/h", "speed in kilometres per hour of the same skydiver")
            .first_route(UNITS, || 3.6 * terminal(DIVER))
            .second_route(IN_STEPS, || terminal_in_steps(DIVER) * 3600.0 / 1000.0),
        at("line 338")
            .example(
                "drag.pair",
                "the skydivers fall most of the way at their terminal velocities",
                "fall of two skydivers",
            )
            .first_route(ENERGY, |stated| {
                // Half of the way down, energy and work of the drag give the speed.
                let part = |mass: f64| {
                    let limit = terminal([mass, 0.70, 0.140]);
                    (-libm::expm1(-2.0 * GRAVITY * 3000.0 / (limit * limit))).sqrt()
                };
                let slower = part(60.0).min(part(90.0));
                Finding::new(slower > stated.pick(0.99, 0.9999), "their speeds after half of the way")
            })
            .second_route(IN_STEPS, |stated| {
                let part = |mass: f64| {
                    let fall =
                        |time| line(0.0, time, |speed| GRAVITY - force_by_parcels([0.70, AIR, 0.140, speed]) / mass);
                    let time = halved([10.0, 100.0], |time| fall(time)[1] < 3000.0);
                    fall(time)[0] / terminal([mass, 0.70, 0.140])
                };
                Finding::new(part(90.0) > stated.pick(0.99, 0.9999), "the heavier one moved in steps of time")
            })
            .interpreted_as(
                "Their area is that of line 331, and most of the way is half of it, within one per cent of the speed",
            )
            .but_not("they do so within a ten thousandth of the speed"),
        at("line 345")
            .value("drag.squirrel-speed", "11.8", "m/s", "speed of a squirrel after a long fall")
            .first_route(Evidence::CLOSED_FORM, || terminal([0.560, 0.70, 0.0930]))
            .second_route(IN_STEPS, || terminal_in_steps([0.560, 0.70, 0.0930]))
            .right(Evidence::CLOSED_FORM, || terminal(SQUIRREL), IN_STEPS, || terminal_in_steps(SQUIRREL))
            .in_error_for("9.88", OTHER_COEFFICIENT),
        at("line 345")
            .value("drag.person-speed", "9.9", "m/s", "speed of a person after a fall of 5.0 m")
            .first_route(ENERGY, || (2.0 * GRAVITY * 5.0).sqrt())
            .second_route(IN_STEPS, || {
                let time = halved([0.5, 2.0], |time| line(0.0, time, |_| GRAVITY)[1] < 5.0);
                line(0.0, time, |_| GRAVITY)[0]
            }),
    ]
}

fn cars() -> Vec<Claim> {
    const OPEN: &str = "The section does not say whether the drag coefficient is in this area. If it is not, the car shows no more area than \
                        the spread-out skydiver; if it is, the coefficient of the table is not needed";
    vec![
        at("line 349")
            .statement(
                "drag.engine-force",
                "At constant speed, the engine's force is drag plus rolling resistance",
                "forces on a car",
            )
            .first_route(BALANCE, |stated| {
                let [drag, rolling] = [force_by_energy([0.28, AIR, 2.2, 20.0]), 150.0];
                let gain = stated.pick(drag + rolling, drag) - drag - rolling;
                Finding::new(gain.abs() < 1e-9, "nothing is left to change the speed")
            })
            .second_route(IN_STEPS, |stated| {
                let force = |speed: f64| force_by_parcels([0.28, AIR, 2.2, speed]) + 150.0;
                let engine = stated.pick(force(20.0), force(20.0) - 150.0);
                let speed = line(20.0, 60.0, |speed| (engine - force(speed)) / 1500.0)[0];
                Finding::new((speed - 20.0).abs() < 1e-9, "a car moved in steps of time keeps its speed")
            })
            .but_not("at constant speed the engine's force is the drag alone"),
        at("line 349").value("drag.camry-area", "0.70", "m²", "area of the drag of a Toyota Camry").missing(OPEN),
        at("line 349").value("drag.hummer-area", "2.44", "m²", "area of the drag of a Hummer H2").missing(OPEN),
        at("line 357")
            .value("drag.car-factor", "2.86", "", "ratio of the drags at 110 km/h and at 65 km/h")
            .first_route(Evidence::CLOSED_FORM, || (110.0 / 65.0) * (110.0 / 65.0))
            .second_route(IN_STEPS, || {
                let drag = |speed: f64| force_by_parcels([0.3, AIR, 2.2, speed / 3.6]);
                drag(110.0) / drag(65.0)
            }),
    ]
}

fn drops() -> Vec<Claim> {
    let drop = |radius: f64| [1000.0 * 4.0 / 3.0 * PI * radius * radius * radius, 0.45, PI * radius * radius];
    vec![
        at("line 362")
            .statement("drag.drop-area", r"its area is \pi r^2", "area of a drop")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // Of three times the radius, the area that the air meets is as the square of it.
                let raised = libm::log(PI * 9.0 / PI) / libm::log(3.0);
                Finding::new(is_near(stated.number(), stated.pick(raised, 3.0)), "the area of a disc")
            })
            .second_route(IN_STEPS, |stated| {
                // The shadow of a sphere, cut into strips across.
                let shadow = |radius: f64| simpson([0.0, PI], |angle| 2.0 * (radius * libm::sin(angle)).powi(2));
                let raised = libm::log(shadow(3.0) / shadow(1.0)) / libm::log(3.0);
                let is_disc = (shadow(1.0) - PI).abs() < 1e-9;
                Finding::new(
                    is_disc && (stated.number() - stated.pick(raised, 3.0)).abs() < 1e-9,
                    "the shadow of a sphere",
                )
            })
            .interpreted_as("It is the area that faces the air, not that of the drop's surface")
            .but_not("its area is as the cube of the radius"),
        at("line 362")
            .example("drag.drop", "air drag makes a great difference to the drop", "speeds of a rain drop")
            .first_route(Evidence::CLOSED_FORM, move |stated| {
                let ratio = (2.0 * GRAVITY * 5000.0).sqrt() / terminal(drop(0.002));
                Finding::new(ratio > stated.pick(10.0, 100.0), format!("without air it is {ratio:.0} times as fast"))
            })
            .second_route(IN_STEPS, move |stated| {
                let free = line(0.0, (2.0 * 5000.0 / GRAVITY).sqrt(), |_| GRAVITY)[0];
                let ratio = free / terminal_in_steps(drop(0.002));
                Finding::new(
                    ratio > stated.pick(10.0, 100.0),
                    format!("two drops moved in steps of time, {ratio:.0} times as fast"),
                )
            })
            .interpreted_as(
                "A great difference is a factor of ten, and the drag coefficient is that of a sphere in the table",
            )
            .but_not("it makes a factor of a hundred"),
        law("line 370", "drag.stokes-again", r"F_s = 6 \pi r \eta v", "law of Stokes, in the solution", &SPHERE),
        law("line 370", "drag.viscosity-law", r"\eta = \frac{F_s}{6 \pi r v}", "viscosity", &SPHERE),
        at("line 370")
            .statement("drag.viscosity-units", "[η] = kg/(m·s)", "units of viscosity")
            .first_route(Evidence::DIMENSION, |stated| {
                let mass = Dimension::FORCE * Dimension::TIME / Dimension::SPEED;
                let viscosity = Dimension::FORCE / (Dimension::LENGTH * Dimension::SPEED);
                let unit = mass / (Dimension::LENGTH * stated.pick(Dimension::TIME, Dimension::LENGTH));
                Finding::new(viscosity == unit, format!("it is {viscosity}"))
            })
            .second_route(UNITS, |stated| {
                // In centimetres and grams: the force is in dynes, of which a newton has a hundred thousand.
                let ours = 3.0 / (0.7 * 1.3);
                let theirs = 3.0e5 / (70.0 * 130.0);
                // A kilogram by metre and second in grams by centimetre and second.
                let unit = 1000.0 / 100.0_f64.powi(stated.pick(1, 2));
                Finding::new(
                    is_near(ours * unit, theirs),
                    "one viscosity in metres and kilograms, and in centimetres and grams",
                )
            })
            .but_not("the unit is kg/m²"),
    ]
}

fn sinking() -> Vec<Claim> {
    // The steel ball: its radius, its speed and its mass.
    const BALL: [f64; 3] = [1.5e-3, 0.60 / 12.0, 7.8e3 * 4.0 / 3.0 * PI * 1.5e-3 * 1.5e-3 * 1.5e-3];
    let diamond = |factor: f64, time: f64| line(0.0, time, move |speed| GRAVITY - factor * speed / 0.0100);
    vec![
        at("line 375")
            .statement("drag.bacterium-weight", "at the terminal velocity of the bacterium in water, drag is weight", "forces on a bacterium")
            .first_route(BALANCE, |stated| {
                // Densities of the bacterium and of water, as the section has them in lines 375 and 362.
                let drag = (1100.0 - 1000.0) / 1100.0;
                let said = if stated.characters().contains("less the buoyancy") { 1.0 - 1000.0 / 1100.0 } else { 1.0 };
                Finding::new((drag / said - 1.0_f64).abs() < 0.05, format!("the drag is {drag:.3} of the weight"))
            })
            .second_route(IN_STEPS, |stated| {
                // The pressure grows with the depth: its upward part over the rings of a sphere of radius 1.
                let ring = |angle: f64| 1000.0 * libm::cos(angle) * libm::cos(angle) * 2.0 * PI * libm::sin(angle);
                let weight = 1100.0 * 4.0 / 3.0 * PI;
                let drag = 1.0 - simpson([0.0, PI], ring) / weight;
                let said = if stated.characters().contains("less the buoyancy") { 1.0 / 11.0 } else { 1.0 };
                Finding::new((drag / said - 1.0).abs() < 0.05, format!("by the pressure of the water, the drag is {drag:.3} of the weight"))
            })
            .corrected("at the terminal velocity of the bacterium in water, drag is weight less the buoyancy", BUOYANCY),
        at("line 380")
            .statement("drag.quickly", "Particles in liquids reach terminal velocity quickly", "time in which the ball is at its terminal speed")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let time = BALL[1] / GRAVITY;
                Finding::new(5.0 * time < stated.pick(0.01, 1e-4) * 12.0, "five time constants, each the speed over the gravity")
            })
            .second_route(IN_STEPS, |stated| {
                let [radius, speed, mass] = BALL;
                let factor = mass * GRAVITY / speed / radius;
                let later = line(0.0, stated.pick(0.01, 1e-4) * 12.0, |speed| GRAVITY - factor * radius * speed / mass)[0];
                Finding::new(later > 0.99 * speed, "the ball moved in steps of time")
            })
            .interpreted_as("It is within a hundredth of that speed after a hundredth of the time")
            .but_not("it is so after a ten thousandth of the time"),
        at("line 383")
            .value("drag.oil-viscosity", "0.76", "kg/(m·s)", "viscosity of the oil")
            .first_route(Evidence::CLOSED_FORM, || {
                let [radius, speed, mass] = BALL;
                mass * GRAVITY / (6.0 * PI * radius * speed)
            })
            .second_route(IN_STEPS, || {
                let [radius, speed, mass] = BALL;
                halved([0.1, 5.0], |viscosity| {
                    let drag = |speed: f64| {
                        let size = 1.5 * viscosity * speed / radius;
                        size * 4.0 * PI * radius * radius
                    };
                    drag(speed) < mass * GRAVITY
                })
            })
            .interpreted_as("The buoyancy of the oil is left out, as everywhere in the section; the density of the oil is not given"),
        at("line 388")
            .example("drag.half-factor", "the lighter skydiver's b is less than that of the heavier skydiver", "factors of two skydivers")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let ratio = 50.0 * GRAVITY / (60.0 * 60.0) / (100.0 * GRAVITY / (60.0 * 60.0));
                Finding::new(stated.pick(ratio < 1.0, ratio > 1.0), "at the same terminal speed it is as the mass")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let less = 50.0 * GRAVITY / 3600.0 < printed("drag.heavy-factor");
                Finding::new(stated.pick(less, !less), "the printed answer for the heavier one")
            })
            .but_not("it is greater"),
        at("line 396")
            .value("drag.diamond-factor", "0.049", "kg/s", "factor of the speed for the diamond")
            .first_route(Evidence::CLOSED_FORM, || 0.0100 * GRAVITY / 2.0)
            .second_route(IN_STEPS, move || halved([0.01, 1.0], |factor| diamond(factor, 20.0)[0] > 2.0)),
        at("line 396")
            .value("drag.diamond-way", "0.57", "m", "way until the diamond has 90 per cent of its terminal speed")
            .first_route(Evidence::CLOSED_FORM, || {
                let constant = 2.0 / GRAVITY;
                2.0 * constant * (libm::log(10.0) - 0.9)
            })
            .second_route(IN_STEPS, move || {
                let factor = 0.0100 * GRAVITY / 2.0;
                let time = halved([0.0, 2.0], |time| diamond(factor, time)[0] < 1.8);
                diamond(factor, time)[1]
            }),
    ]
}
