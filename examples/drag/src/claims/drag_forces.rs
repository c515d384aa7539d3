//! The force of drag: its law, and the table of drag coefficients.

use crate::kinds::{ENERGY, IN_STEPS, UNITS};
use crate::letters::{DRAG, force_by_energy, force_by_parcels};
use crate::section::{at, is_near, law, printed};
use crate::steps::{halved, line, simpson};
use geneva_evidence::{Claim, Dimension, Evidence, Finding, Verdict};
use std::f64::consts::PI;

/// A force by the exponent of the speed in it, seen in three times the speed.
fn exponent(force: impl Fn(f64) -> f64) -> f64 {
    libm::log(force(3.0) / force(1.0)) / libm::log(3.0)
}

/// The force on a sphere in creeping flow: as the speed of the fluid that it drags along.
fn creeping(speed: f64) -> f64 {
    simpson([0.0, PI], |angle| 1.5 * speed * 2.0 * PI * libm::sin(angle))
}

pub(super) fn claims() -> Vec<Claim> {
    [opening(), coefficients(), table(), sport()].into_iter().flatten().collect()
}

fn opening() -> Vec<Claim> {
    let body = |speed| [0.9, 1.21, 0.015, speed];
    vec![
        at("line 18")
            .statement("drag.faster-hand", "The faster the hand, the harder it is to move", "drag at two speeds")
            .first_route(ENERGY, move |stated| {
                let more = force_by_energy(body(3.0)) > force_by_energy(body(2.0));
                Finding::new(stated.pick(more, !more), "a faster hand gives more energy to the air that it meets")
            })
            .second_route(IN_STEPS, move |stated| {
                let more = force_by_parcels(body(3.0)) > force_by_parcels(body(2.0));
                Finding::new(stated.pick(more, !more), "a faster hand meets more air, and pushes it harder")
            })
            .but_not("the faster the hand, the easier it is to move"),
        at("line 18")
            .statement("drag.tilted-hand", "A hand that shows only its side has less drag", "drag of two areas")
            .first_route(ENERGY, |stated| {
                let less = force_by_energy([0.9, 1.21, 0.004, 2.0]) < force_by_energy([0.9, 1.21, 0.015, 2.0]);
                Finding::new(stated.pick(less, !less), "a smaller area meets less air")
            })
            .second_route(IN_STEPS, |stated| {
                let less = force_by_parcels([0.9, 1.21, 0.004, 2.0]) < force_by_parcels([0.9, 1.21, 0.015, 2.0]);
                Finding::new(stated.pick(less, !less), "fewer parcels of air get a push")
            })
            .interpreted_as("The drag coefficient is the same")
            .but_not("a hand that shows only its side has more drag"),
        at("line 21")
            .statement("drag.opposes", "Drag always opposes the motion", "direction of the drag")
            .first_route(ENERGY, |stated| {
                // The drag takes power, whichever way the body goes.
                let power = |speed: f64| -force_by_energy(body_of(speed)) * speed.abs();
                let takes = [2.0, -2.0].map(power).iter().all(|power| *power < 0.0);
                Finding::new(stated.pick(takes, !takes), "the fluid gets energy, which the body loses")
            })
            .second_route(IN_STEPS, |stated| {
                let slows = |speed: f64| line(speed, 1.0, |speed| -0.1 * speed * speed.abs())[0].abs() < speed.abs();
                let both = slows(3.0) && slows(-3.0);
                Finding::new(stated.pick(both, !both), "a body moved in steps of time becomes slower both ways")
            })
            .interpreted_as("The motion is the one through the fluid")
            .but_not("drag always helps the motion"),
        at("line 21")
            .statement("drag.depends", "Drag depends on shape, size, speed and fluid", "what the drag depends on")
            .first_route(ENERGY, |stated| {
                let changed = [[1.1, 1.0, 1.0, 1.0], [1.0, 1.1, 1.0, 1.0], [1.0, 1.0, 1.1, 1.0], [1.0, 1.0, 1.0, 1.1]];
                let depends = changed.iter().all(|body| !is_near(force_by_energy(*body), force_by_energy([1.0; 4])));
                Finding::new(stated.pick(depends, !depends), "each of the four changes the energy that the fluid gets")
            })
            .second_route(IN_STEPS, |stated| {
                let changed = [[2.0, 1.0, 1.0, 1.0], [1.0, 2.0, 1.0, 1.0], [1.0, 1.0, 2.0, 1.0], [1.0, 1.0, 1.0, 2.0]];
                let depends = changed.iter().all(|body| force_by_parcels(*body) > force_by_parcels([1.0; 4]));
                Finding::new(
                    stated.pick(depends, !depends),
                    "each of the four changes the push on the parcels of fluid",
                )
            })
            .but_not("drag depends on none of them"),
        at("line 21")
            .statement("drag.square", "F_D is proportional to v^2", "drag and speed of large objects")
            .first_route(ENERGY, |stated| {
                let raised = exponent(|speed| force_by_energy(body_of(speed)));
                Finding::new(
                    is_near(stated.number(), stated.pick(raised, 1.0)),
                    "the energy of the fluid met in a second",
                )
            })
            .second_route(IN_STEPS, |stated| {
                let raised = exponent(|speed| force_by_parcels(body_of(speed)));
                Finding::new(
                    is_near(stated.number(), stated.pick(raised, 1.0)),
                    "the push on the parcels met in a second",
                )
            })
            .but_not("the drag of large objects is as the speed"),
        law("line 23", "drag.law", r"F_D = \frac{1}{2} C \rho A v^2", "drag force", &DRAG),
        at("line 25")
            .statement("drag.density", "Density is mass per unit volume", "density of the fluid")
            .first_route(Evidence::DIMENSION, |stated| {
                let volume = Dimension::LENGTH * Dimension::LENGTH * Dimension::LENGTH;
                let mass = Dimension::FORCE * Dimension::TIME / Dimension::SPEED;
                // From the law, in which the drag coefficient has no dimension.
                let density =
                    Dimension::FORCE / (Dimension::LENGTH * Dimension::LENGTH) / (Dimension::SPEED * Dimension::SPEED);
                let right = density == mass / volume;
                Finding::new(
                    stated.pick(right, density == volume / mass),
                    "the dimension of the density in the drag law",
                )
            })
            .second_route(UNITS, |stated| {
                // The mass of a cubic metre, and of a cubic centimetre, each over its volume.
                let centimetre: f64 = 0.01;
                let cube = centimetre * centimetre * centimetre;
                let [mass, volume] = [1.21 * cube, cube];
                let right = is_near(mass / volume, 1.21);
                Finding::new(
                    stated.pick(right, is_near(volume / mass, 1.21)),
                    "a cubic metre and a cubic centimetre of the same air",
                )
            })
            .but_not("density is volume per unit mass"),
        law("line 25", "drag.general", "F_D = b v^n", "drag force with any exponent", &DRAG),
        law("line 25", "drag.factor", r"b = 0.5 C \rho A", "factor of the square of the speed", &DRAG),
        at("line 25")
            .statement("drag.fast-exponent", "n is 2 at high speed in air", "exponent of the speed for fast objects")
            .first_route(ENERGY, |stated| {
                let raised = exponent(|speed| force_by_energy(body_of(30.0 * speed)));
                Finding::new(
                    is_near(stated.number(), stated.pick(raised, 1.0)),
                    "the energy of the air met in a second",
                )
            })
            .second_route(IN_STEPS, |stated| {
                let raised = exponent(|speed| force_by_parcels(body_of(30.0 * speed)));
                Finding::new(
                    is_near(stated.number(), stated.pick(raised, 1.0)),
                    "the push on the parcels met in a second",
                )
            })
            .but_not("at high speed in air the exponent is that of slow particles"),
        at("line 25")
            .statement(
                "drag.slow-exponent",
                "n is 1 for small particles at low speed",
                "exponent of the speed for slow particles",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let raised = exponent(|speed| 6.0 * PI * speed);
                Finding::new(is_near(stated.number(), stated.pick(raised, 2.0)), "by the law of Stokes")
            })
            .second_route(IN_STEPS, |stated| {
                let raised = exponent(creeping);
                Finding::new(
                    is_near(stated.number(), stated.pick(raised, 2.0)),
                    "pressure and friction over the rings of a sphere",
                )
            })
            .but_not("for small particles at low speed the exponent is that of large objects"),
    ]
}

/// Some body at a speed.
fn body_of(speed: f64) -> [f64; 4] {
    [0.9, 1.21, 0.5, speed.abs()]
}

fn coefficients() -> Vec<Claim> {
    vec![
        at("line 31")
            .statement("drag.mileage", "With less drag, a car goes farther on its fuel", "drag and the use of fuel")
            .first_route(ENERGY, |stated| {
                // The work on each metre, with the same rolling resistance.
                let way = |coefficient| 1.0 / (150.0 + force_by_energy([coefficient, 1.21, 2.2, 28.0]));
                let farther = way(0.28) > way(0.36);
                Finding::new(stated.pick(farther, !farther), "the work of the engine on each metre")
            })
            .second_route(IN_STEPS, |stated| {
                // A car that coasts with the same energy goes farther.
                let way = |coefficient| line(28.0, 10.0, |speed| {
                    -(150.0 + force_by_parcels([coefficient, 1.21, 2.2, speed.max(0.1)])) / 1500.0
                })[1];
                let farther = way(0.28) > way(0.36);
                Finding::new(stated.pick(farther, !farther), "the way in which a coasting car uses up its energy")
            })
            .but_not("with less drag, a car goes less far on its fuel"),
        at("line 36")
            .statement("drag.top-speed", "Shape decides the top speed", "top speed and shape")
            .first_route(ENERGY, |stated| {
                // The power of an engine against drag alone: the cube of the speed.
                let top = |coefficient: f64| libm::cbrt(60_000.0 / force_by_energy([coefficient, 1.21, 2.0, 1.0]));
                let faster = top(0.25) > top(0.5) * 1.2;
                Finding::new(stated.pick(faster, !faster), "with half of the drag coefficient, the same power gives a quarter more speed")
            })
            .second_route(IN_STEPS, |stated| {
                let top = |coefficient: f64| {
                    halved([1.0, 200.0], |speed| force_by_parcels([coefficient, 1.21, 2.0, speed]) * speed < 60_000.0)
                };
                let faster = top(0.25) > top(0.5) * 1.2;
                Finding::new(stated.pick(faster, !faster), "the speed at which the drag takes all the power")
            })
            .interpreted_as("A sled or car with half of the drag coefficient gains more than a fifth in speed")
            .but_not("the shape makes no difference to the top speed"),
        at("line 45")
            .statement("drag.dimensionless", "The drag coefficient is dimensionless", "dimension of the drag coefficient")
            .first_route(Evidence::DIMENSION, |stated| {
                let mass = Dimension::FORCE * Dimension::TIME / Dimension::SPEED;
                let volume = Dimension::LENGTH * Dimension::LENGTH * Dimension::LENGTH;
                let below = mass / volume * Dimension::LENGTH * Dimension::LENGTH * Dimension::SPEED * Dimension::SPEED;
                let left = Dimension::FORCE / below;
                Finding::new(left == stated.pick(Dimension::NONE, Dimension::FORCE), format!("what is left is {left}"))
            })
            .second_route(UNITS, |stated| {
                // The same car in metres, kilograms and seconds, and in feet, pounds and seconds.
                let coefficient = |force: f64, density: f64, area: f64, speed: f64| 2.0 * force / (density * area * speed * speed);
                let (foot, pound) = (0.3048, 0.453_592_37);
                let ours = coefficient(200.0, 1.21, 2.2, 25.0);
                let theirs = coefficient(
                    200.0 / pound / foot,
                    1.21 / pound * foot * foot * foot,
                    2.2 / foot / foot,
                    25.0 / foot,
                );
                let same = is_near(ours, theirs);
                Finding::new(stated.pick(same, !same), "a car has the same drag coefficient in other units")
            })
            .but_not("the drag coefficient is a force"),
        at("line 45").value("drag.highway-power", "50", "%", "share of the power that goes into air drag").missing(
            "The section gives neither the car's mass and rolling resistance nor the speed, and does not say whether it is the \
             power of the engine or of the wheels",
        ),
        at("line 45")
            .statement("drag.efficient-speed", "Fuel lasts longest at about 70 to 80 km/h", "most efficient speed")
            .missing(
                "Drag alone makes a slower car always more efficient. What makes it less so is the engine, of which the section \
                 gives nothing",
            ),
        at("line 45")
            .statement("drag.slow-miles", "45 mi/h", "speed in miles per hour that is about 70 km/h")
            .first_route(UNITS, |stated| {
                let speed = stated.pick(70.0, 80.0) / 1.609_344;
                Finding::new(stated.number() == in_fives(speed), format!("it is {speed:.1} mi/h"))
            })
            // Inch, foot, yard, mile.
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let speed = stated.pick(70.0, 80.0) * 1e5 / 2.54 / 12.0 / 3.0 / 1760.0;
                Finding::new(stated.number() == in_fives(speed), format!("by inches, it is {speed:.1} mi/h"))
            })
            .interpreted_as("The section says about, and all of its speeds on roads are in steps of five")
            .but_not("the speed of 80 km/h is meant"),
        at("line 45")
            .value("drag.fast-miles", "50", "mi/h", "speed in miles per hour that is about 80 km/h")
            .first_route(UNITS, || 80.0 / 1.609_344)
            .second_route(Evidence::LIMIT_CASE, || 80.0 * 1e5 / 2.54 / 12.0 / 3.0 / 1760.0),
        at("line 45")
            .value("drag.limit", "90", "km/h", "speed in kilometres per hour that is about 55 mi/h")
            .first_route(UNITS, || 55.0 * 1.609_344)
            .second_route(Evidence::LIMIT_CASE, || 55.0 * 1760.0 * 3.0 * 12.0 * 2.54 / 1e5)
            .with_resolution(|| 2.5)
            .interpreted_as("The section says about, and all of its speeds on roads are in steps of five")
            .expecting(Verdict::ReadOff),
    ]
}

/// A number rounded to a multiple of five.
fn in_fives(number: f64) -> f64 {
    5.0 * libm::round(number / 5.0)
}

/// The rows of the table: the claim, the object and the drag coefficient. Of those without routes nothing else in the section follows.
const ROWS: [(&str, &str, &str, &str); 12] = [
    ("line 60", "drag.table-airfoil", "0.05", "coefficient of an airfoil"),
    ("line 64", "drag.table-camry", "0.28", "coefficient of a Toyota Camry"),
    ("line 68", "drag.table-focus", "0.32", "coefficient of a Ford Focus"),
    ("line 72", "drag.table-civic", "0.36", "coefficient of a Honda Civic"),
    ("line 76", "drag.table-ferrari", "0.37", "coefficient of a Ferrari Testarossa"),
    ("line 80", "drag.table-ram", "0.43", "coefficient of a Dodge Ram"),
    ("line 84", "drag.table-sphere", "0.45", "coefficient of a sphere"),
    ("line 88", "drag.table-hummer", "0.64", "coefficient of a Hummer H2"),
    ("line 92", "drag.table-feet", "0.70", "coefficient of a skydiver who falls upright"),
    ("line 96", "drag.table-bicycle", "0.90", "coefficient of a bicycle"),
    ("line 100", "drag.table-horizontal", "1.0", "coefficient of a skydiver who lies flat"),
    ("line 104", "drag.table-plate", "1.12", "coefficient of a round flat plate"),
];

fn table() -> Vec<Claim> {
    let cells = || ROWS.map(|(_, id, ..)| printed(id));
    // What the description counts and lists: columns, rows, the head's row and columns, and each row with its coefficient.
    let listed = move |from_the_end: bool| {
        let mut numbers = vec![2.0, 13.0, 1.0, 1.0, 2.0];
        let mut cells = cells();
        if from_the_end {
            cells.reverse();
        }
        for (row, cell) in (2..).zip(cells) {
            numbers.push(f64::from(row));
            // The words for the upright skydiver.
            numbers.extend((row == 10).then_some(1.0));
            numbers.push(cell);
        }
        numbers
    };
    let description = at("line 46")
        .statement(
            "drag.table-description",
            "two columns and thirteen rows; head in the first row, of the first and second column; second 0.05, third 0.28, \
             fourth 0.32, fifth 0.36, sixth 0.37, seventh 0.43, eighth 0.45, ninth H2 0.64, tenth first 0.70, eleventh 0.90, \
             twelfth 1.0, thirteenth 1.12",
            "what the description of the table lists",
        )
        .first_route(Evidence::LIMIT_CASE, move |stated| {
            Finding::new(stated.numbers() == listed(stated.pick(false, true)), "row by row, it lists what the table has")
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, move |stated| {
            let numbers = stated.numbers();
            let counts = numbers.len() == 5 + 2 * ROWS.len() + 1 && numbers.starts_with(&[2.0, 1.0 + ROWS.len() as f64, 1.0, 1.0, 2.0]);
            // Behind the counts: rows, and coefficients, which are smaller than the number of any row.
            let (coefficients, rows): (Vec<f64>, Vec<f64>) =
                numbers.iter().skip(5).filter(|number| **number != 1.0).partition(|number| **number < 1.5);
            let expected: Vec<f64> = cells().into_iter().filter(|cell| *cell != 1.0).collect();
            let sorted = coefficients.is_sorted() && stated.pick(true, !coefficients.is_sorted());
            let in_order = rows.len() == ROWS.len() && rows.windows(2).all(|pair| pair[1] == pair[0] + 1.0) && rows[0] == 2.0;
            let ones = numbers.iter().skip(5).filter(|number| **number == 1.0).count() == 2;
            Finding::new(counts && sorted && in_order && ones && coefficients == expected, "rows and coefficients grow alike")
        })
        .but_not("the coefficients are listed from the last row to the first");
    let mut claims = vec![description];
    for (line, id, coefficient, meaning) in ROWS {
        let cell = at(line).value(id, coefficient, "", meaning);
        claims.push(match id {
            "drag.table-feet" => cell
                .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                    2.0 * 75.0 * 9.80 / (1.21 * 0.18 * printed("drag.headfirst").powi(2))
                })
                .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                    2.0 * 80.0 * 9.80 / 1.21 / 0.140 / printed("drag.head-speed") / printed("drag.head-speed")
                })
                .interpreted_as("A skydiver who falls upright has the same drag head first and feet first"),
            "drag.table-horizontal" => cell
                .first_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                    2.0 * 85.0 * 9.80 / (1.21 * 0.70 * printed("drag.spread-eagle").powi(2))
                })
                .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                    2.0 * 50.0 * 9.80
                        / 1.21
                        / 0.70
                        / printed("drag.light-spread-eagle")
                        / printed("drag.light-spread-eagle")
                }),
            _ => cell.missing(
                "It is measured, and the section names no measurement, no speed and nothing else that follows from it",
            ),
        });
    }
    claims
}

fn sport() -> Vec<Claim> {
    vec![at("line 114").value("drag.suit", "10", "%", "decrease of the drag by a suit").missing(
        "It is measured, and the section gives no measurement: neither the drag with the suit nor the drag without it",
    )]
}
