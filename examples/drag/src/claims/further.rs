//! The second half of the additional problems: slopes, circles and blocks.

use crate::kinds::{BALANCE, ENERGY, IN_STEPS};
use crate::letters::{CIRCLE, PULLED};
use crate::section::{GRAVITY, at, is_near, law, printed, rounds, turned};
use crate::steps::{halved, line, moved, pull_to_middle, solved};
use geneva_evidence::{Claim, Consequence, Decimal, Dimension, Evidence, Finding, Origin, Slip, Verdict};
use std::f64::consts::TAU;

/// The force on the crate, from rounded results.
const ROUNDED_FORCE: Slip = Slip {
    id: "",
    reason: "To keep the crate moving takes 1062 N. The printed force is 1200 N less 100 kg times 1.2 m/s², and the 1200 N are rounded \
             to two digits from 1180 N.",
    witness: "A crate moved in steps of time keeps its speed with 1062 N.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Result,
    changes: "The force is 1.7 per cent less.",
};
/// The friction of the crate on the road.
const ROAD: Slip = Slip {
    id: "",
    reason: "From 100 km/h and 50 m, the coefficient is 0.787. With the speed rounded to 27.8 m/s it would be 0.789.",
    witness: "A crate moved in steps of time with a coefficient of 0.787 comes to rest after 50 m.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "",
};
/// The ball that is not on its circle.
const OFF_THE_CIRCLE: Slip = Slip {
    id: "",
    reason: "The ball is on a string of 25.0 cm, so it is always 25.0 cm from the middle of its circle.",
    witness: "The printed tension of 0.48 N belongs to the radius of 25.0 cm.",
    origin: Origin::Unknown,
    consequence: Consequence::Remark,
    changes: "",
};
/// The slope of the pan.
const PAN: Slip = Slip {
    id: "",
    reason: "The pan is the long side of the triangle, so the coefficient is 5.0 over the root of 23.5² - 5.0², which is 0.218. The printed \
             digits are its first ones, and those of 5.0 over 23.5.",
    witness: "A piece of bacon on a pan raised so far begins to slide with a coefficient of 0.2178.",
    origin: Origin::Unknown,
    consequence: Consequence::Result,
    changes: "The coefficient is 0.22.",
};
/// The radius of the turn.
const TURN: Slip = Slip {
    id: "",
    reason: "The radius is 2545 m, which is 2550 m to three digits. The lift of the first answer, rounded to 28,300 N, gives 2544 m.",
    witness: "The force that turns the velocity, by the momentum of a quarter turn, belongs to a radius of 2545 m.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "",
};
/// The index that should be a factor.
const INDEX: Slip = Slip {
    id: "",
    reason: "The speed is the product of A and ω. The ω is printed as an index, and there is no letter with that index.",
    witness: "A letter A alone, with whatever index, is a length and no speed.",
    origin: Origin::Misprint,
    consequence: Consequence::Wording,
    changes: "",
};

pub(super) fn claims() -> Vec<Claim> {
    [crates(), roads(), circles(), blocks()].into_iter().flatten().collect()
}

/// Weight of the crate along its slope, across it, and the greatest friction at rest, in newtons.
fn crate_forces() -> [f64; 3] {
    let [sine, cosine] = turned(37.0);
    let weight = 100.0 * GRAVITY;
    [weight * sine, weight * cosine, weight * sine]
}

/// The force up the slope with which the crate moved in steps of time keeps its speed, up or down the slope.
fn steady_force(up: f64) -> f64 {
    let [sine, cosine] = turned(37.0);
    let kinetic = 0.80 * sine / cosine;
    halved([0.0, 3000.0], |force| {
        let gain = |_: f64| force / 100.0 - GRAVITY * sine - up * kinetic * GRAVITY * cosine;
        line(up, 0.01, gain)[0] < up
    })
}

fn crates() -> Vec<Claim> {
    vec![
        at("line 550")
            .example("drag.fridge", "the fridge has a coefficient of friction", "friction of a fridge")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [sine, cosine] = turned(35.0);
                let coefficient = (30.0 * GRAVITY * sine - 25.0) / (30.0 * GRAVITY * cosine);
                Finding::new(coefficient > stated.pick(0.0, 0.7), format!("it is {coefficient:.2}"))
            })
            .second_route(BALANCE, |stated| {
                let [sine, cosine] = turned(35.0);
                let [normal, friction] =
                    solved([[cosine, sine], [-sine, cosine]], [30.0 * GRAVITY - 25.0 * sine, -25.0 * cosine]);
                let coefficient = friction / normal;
                Finding::new(
                    coefficient > stated.pick(0.0, 0.7),
                    format!("friction and normal force are as {coefficient:.2}"),
                )
            })
            .but_not("its coefficient is above 0.7, that of the slope"),
        at("line 558")
            .value("drag.crate-static", "0.75", "", "coefficient of the crate at rest")
            .first_route(Evidence::CLOSED_FORM, || libm::tan(37.0_f64.to_radians()))
            .second_route(BALANCE, || {
                let [sine, cosine] = turned(37.0);
                let [normal, friction] = solved([[cosine, sine], [-sine, cosine]], [980.0, 0.0]);
                friction / normal
            }),
        at("line 558")
            .statement("drag.crate-greatest", "1200 N", "greatest force on the crate at rest")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [along, _, friction] = crate_forces();
                let force = stated.pick(along + friction, along);
                Finding::new(rounds(stated, &[(force, 2)]), format!("it is {force:.0} N"))
            })
            .second_route(BALANCE, |stated| {
                let [sine, cosine] = turned(37.0);
                // Force, normal force and friction: along, across, and the limit of the friction.
                let rows = [[1.0, 0.0, -1.0], [0.0, 1.0, 0.0], [0.0, sine / cosine, stated.pick(-1.0, 1.0)]];
                let force = solved(rows, [980.0 * sine, 980.0 * cosine, 0.0])[0];
                Finding::new(rounds(stated, &[(force, 2)]), format!("the forces along and across give {force:.0} N"))
            })
            .interpreted_as("The two zeros at the end do not count")
            .but_not("590 N"),
        at("line 558")
            .value("drag.crate-up", "1.2", "m/s²", "acceleration of the crate up the slope")
            .first_route(Evidence::CLOSED_FORM, || 0.20 * GRAVITY * turned(37.0)[0])
            .second_route(BALANCE, || {
                let [along, _, friction] = crate_forces();
                (along + friction - along - 0.80 * friction) / 100.0
            }),
        at("line 558")
            .value("drag.crate-up-force", "1080", "N", "force that keeps the crate moving up")
            .first_route(Evidence::CLOSED_FORM, || 1.80 * 980.0 * turned(37.0)[0])
            .second_route(IN_STEPS, || steady_force(1.0))
            .rounded(|| 1200.0 - 100.0 * printed("drag.crate-up"))
            .expecting(Verdict::FromRounded)
            .affected_by(ROUNDED_FORCE),
        at("line 558")
            .value("drag.crate-down", "-1.2", "m/s²", "acceleration of the crate down the slope")
            .first_route(Evidence::CLOSED_FORM, || -0.20 * GRAVITY * turned(37.0)[0])
            .second_route(BALANCE, || {
                let [along, _, friction] = crate_forces();
                (0.80 * friction - along) / 100.0
            })
            .interpreted_as("The sign counts up the slope"),
        at("line 558")
            .statement("drag.crate-held", "120 N", "force that keeps the crate from going faster")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let force = stated.pick(0.20, 0.80) * 980.0 * turned(37.0)[0];
                Finding::new(rounds(stated, &[(force, 2)]), format!("it is {force:.0} N"))
            })
            .second_route(IN_STEPS, |stated| {
                let force = steady_force(stated.pick(-1.0, 1.0));
                Finding::new(
                    rounds(stated, &[(force, 2)]),
                    format!("a crate moved in steps of time needs {force:.0} N"),
                )
            })
            .interpreted_as("The zero at the end does not count")
            .but_not("470 N"),
    ]
}

fn roads() -> Vec<Claim> {
    let start = 100.0 / 3.6;
    vec![
        at("line 573")
            .value("drag.road-friction", "0.789", "", "coefficient of the crate on the road")
            .first_route(ENERGY, move || start * start / (2.0 * GRAVITY * 50.0))
            .second_route(IN_STEPS, move || {
                // The coefficient with which the crate that slides for 50 m comes to rest.
                halved([0.1, 3.0], |coefficient| {
                    let time = start / (coefficient * GRAVITY);
                    line(start, time, |_| -coefficient * GRAVITY)[1] > 50.0
                })
            })
            .corrected("0.787", ROAD),
        at("line 578")
            .example("drag.sled", "the sled gains speed under the force of question (a)", "forces on a sled")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [sine, cosine] = turned(30.0);
                let gain = (33.0 * cosine - stated.pick(0.20, 0.30) * (15.0 * GRAVITY - 33.0 * sine)) / 15.0;
                Finding::new(gain > 0.0, format!("it gains {gain:.2} m/s in a second"))
            })
            .second_route(BALANCE, |stated| {
                let [sine, cosine] = turned(30.0);
                // Acceleration, normal force, friction.
                let rows = [[15.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, stated.pick(0.20, 0.30), -1.0]];
                let [gain, ..] = solved(rows, [33.0 * cosine, 15.0 * GRAVITY - 33.0 * sine, 0.0]);
                Finding::new(gain > 0.0, format!("level and upright, the forces give {gain:.2} m/s²"))
            })
            .but_not("it would gain speed with half as much friction again, too"),
    ]
}

fn circles() -> Vec<Claim> {
    // Mass, speed and circle of the ball.
    const BALL: [f64; 3] = [0.0300, 2.000, 0.250];
    let pull = || BALL[0] * BALL[1] * BALL[1] / BALL[2];
    vec![
        at("line 583")
            .statement(
                "drag.ball-place",
                "at 12.5 cm from the middle of the circle (r = 12.5 cm)",
                "third place of the ball",
            )
            .first_route(Evidence::VECTORS, |stated| {
                let distance = |turn: f64| libm::hypot(25.0 * libm::cos(turn * TAU), 25.0 * libm::sin(turn * TAU));
                let numbers = stated.numbers();
                let there = |number: &f64| [0.0, 0.1, 0.37].iter().any(|turn| is_near(distance(*turn), *number));
                Finding::new(
                    numbers.len() == 2 && numbers.iter().all(there),
                    "each place of the circle is 25.0 cm from its middle",
                )
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let radius = 100.0 * BALL[0] * BALL[1] * BALL[1] / printed("drag.ball-side");
                let numbers = stated.numbers();
                let fits = |number: &f64| (number - radius).abs() < 1e-9;
                Finding::new(
                    numbers.len() == 2 && numbers.iter().all(fits),
                    "the printed tension there belongs to 25.0 cm",
                )
            })
            .corrected("at 25.0 cm from the middle of the circle (r = 25.0 cm)", OFF_THE_CIRCLE),
        at("line 585")
            .value("drag.ball-top", "0.186", "N", "force of the string at the top")
            .first_route(Evidence::CLOSED_FORM, move || pull() - BALL[0] * GRAVITY)
            .second_route(IN_STEPS, || pull_to_middle(BALL) - 0.0300 * GRAVITY),
        at("line 585")
            .value("drag.ball-bottom", "0.774", "N", "force of the string at the bottom")
            .first_route(Evidence::CLOSED_FORM, move || pull() + BALL[0] * GRAVITY)
            .second_route(IN_STEPS, || pull_to_middle(BALL) + 0.0300 * GRAVITY),
        at("line 585")
            .value("drag.ball-side", "0.48", "N", "force of the string at the side")
            .first_route(Evidence::CLOSED_FORM, pull)
            .second_route(IN_STEPS, || pull_to_middle(BALL))
            .interpreted_as("The third place is as high as the middle of the circle"),
        at("line 597")
            .value("drag.cyclist", "13", "m/s", "speed of the stunt cyclist, at least")
            .first_route(Evidence::CLOSED_FORM, || (12.0 * GRAVITY / 0.68).sqrt())
            .second_route(IN_STEPS, || {
                halved([1.0, 50.0], |speed| 0.68 * pull_to_middle([1.0, speed, 12.0]) < GRAVITY)
            }),
        at("line 602")
            .example("drag.spring", "the turned spring has a stretch that it can bear", "spring that turns")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [stiffness, turning] = [0.25 * GRAVITY / 0.050, 0.25 * (2.0 * TAU) * (2.0 * TAU)];
                let stretch = 100.0 * turning * 0.040 / (stiffness - turning);
                Finding::new(stretch > 0.0 && stretch < stated.pick(100.0, 10.0), format!("it is {stretch:.1} cm"))
            })
            .second_route(IN_STEPS, |stated| {
                // The stretch with which the pull of the spring turns the body.
                let stiffness = 0.25 * GRAVITY / 0.050;
                let needed = |stretch: f64| pull_to_middle([0.25, 2.0 * TAU * (0.040 + stretch), 0.040 + stretch]);
                let stretch = 100.0 * halved([0.0, 2.0], |stretch| stiffness * stretch < needed(stretch));
                Finding::new(
                    stretch > 0.0 && stretch < stated.pick(100.0, 10.0),
                    format!("its pull turns the body at {stretch:.1} cm"),
                )
            })
            .interpreted_as("It can bear less than a metre")
            .but_not("its stretch is less than 10 cm"),
        at("line 609")
            .value("drag.bacon", "0.21", "", "coefficient of the bacon on the pan")
            .first_route(Evidence::CLOSED_FORM, || 5.0 / (23.5_f64 * 23.5 - 5.0 * 5.0).sqrt())
            .second_route(BALANCE, || {
                let [sine, cosine] = [5.0 / 23.5, libm::cos(libm::asin(5.0 / 23.5))];
                let [normal, friction] = solved([[cosine, sine], [-sine, cosine]], [1.0, 0.0]);
                friction / normal
            })
            .interpreted_as("The pan's length is measured along the pan")
            .expecting(Verdict::Truncated)
            .affected_by(PAN),
        at("line 613")
            .example("drag.plumb", "the plumb bob hangs at a small angle", "plumb bob in a railway car")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let angle = libm::atan(25.0 * 25.0 / (300.0 * GRAVITY)).to_degrees();
                Finding::new(angle < stated.pick(15.0, 5.0), format!("it is {angle:.1}°"))
            })
            .second_route(IN_STEPS, |stated| {
                let angle = libm::atan2(pull_to_middle([1.0, 25.0, 300.0]), GRAVITY).to_degrees();
                Finding::new(angle < stated.pick(15.0, 5.0), format!("the force that turns the bob gives {angle:.1}°"))
            })
            .interpreted_as("A small angle is less than 15°")
            .but_not("its angle is less than 5°"),
        at("line 621")
            .statement("drag.lift-force", "28,300 N", "lift of the airplane")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let force = 2.50e3 * GRAVITY / stated.pick(turned(30.0)[1], turned(30.0)[0]);
                Finding::new(is_to_three_digits(stated.characters(), force), format!("it is {force:.0} N"))
            })
            .second_route(BALANCE, |stated| {
                let [sine, cosine] = turned(stated.pick(30.0, 60.0));
                // Lift and the force to the middle: level and upright.
                let force = solved([[sine, -1.0], [cosine, 0.0]], [0.0, 2.50e3 * GRAVITY])[0];
                Finding::new(
                    is_to_three_digits(stated.characters(), force),
                    format!("its upright part bears the weight with {force:.0} N"),
                )
            })
            .interpreted_as("The two zeros at the end do not count")
            .but_not("49,000 N"),
        at("line 621")
            .value("drag.turn-radius", "2540", "m", "way from the middle of the turn, its radius")
            .first_route(Evidence::CLOSED_FORM, || {
                let [sine, cosine] = turned(30.0);
                120.0 * 120.0 * cosine / (GRAVITY * sine)
            })
            .second_route(IN_STEPS, || {
                let [sine, cosine] = turned(30.0);
                halved([100.0, 1e4], |radius| pull_to_middle([1.0, 120.0, radius]) > GRAVITY * sine / cosine)
            })
            .corrected("2545", TURN),
        at("line 626")
            .statement("drag.turning-speed", "the speed is the constant A_ω", "speed of a particle on a circle")
            .first_route(Evidence::DIMENSION, |stated| {
                let is_product = stated.characters().contains("Aω");
                let said = Dimension::LENGTH * if is_product { Dimension::ANGULAR_SPEED } else { Dimension::NONE };
                Finding::new(said == Dimension::SPEED, format!("its dimension is {said}"))
            })
            .second_route(IN_STEPS, |stated| {
                let [x, y, ..] = moved([2.0, 0.0, 0.0, 6.0], 0.5, |_, [x, y, u, w]| [u, w, -9.0 * x, -9.0 * y]);
                let on_circle = (libm::hypot(x, y) - 2.0).abs() < 1e-9;
                let said = if stated.characters().contains("Aω") { 2.0 * 3.0 } else { 2.0 };
                Finding::new(
                    on_circle && is_near(said, 6.0),
                    "a body on a circle of 2 m that turns by 3 rad/s has 6 m/s",
                )
            })
            .corrected("the speed is the constant Aω", INDEX),
        law("line 626", "drag.turning-pull", r"a_c = r \omega^2", "acceleration to the middle", &CIRCLE),
    ]
}

/// Whether a number with its unit is this one, rounded to three digits that count.
fn is_to_three_digits(characters: &str, value: f64) -> bool {
    let number = characters.split(' ').next().and_then(|number| number.parse::<Decimal>().ok());
    number.is_some_and(|number| is_near(number.to_f64(), crate::section::to_digits(value, 3)))
}

fn blocks() -> Vec<Claim> {
    vec![
        at("line 637")
            .value("drag.pulled-blocks", "25", "N", "force on the two blocks")
            .first_route(Evidence::CLOSED_FORM, || {
                let [sine, cosine] = turned(60.0);
                4.0 * (2.0 + 0.25 * GRAVITY) / (cosine + 0.25 * sine)
            })
            .second_route(BALANCE, || {
                let [sine, cosine] = turned(60.0);
                // Force, tension, and the floor's force on the block of 3.0 kg.
                let rows = [[cosine, -1.0, -0.25], [0.0, 1.0, 0.0], [sine, 0.0, 1.0]];
                solved(rows, [3.0 * 2.0, 1.0 * 2.0 + 0.25 * GRAVITY, 3.0 * GRAVITY])[0]
            }),
        at("line 642")
            .example("drag.string-taut", "the blocks move and the string is taut", "two blocks on a rough floor")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let gain = (stated.pick(10.0, 5.0) - 0.20 * 2.0 * GRAVITY - 0.30 * GRAVITY) / 3.0;
                Finding::new(gain > 0.0, format!("they gain {gain:.2} m/s in a second"))
            })
            .second_route(BALANCE, |stated| {
                let rows = [[1.0, 1.0], [2.0, -1.0]];
                let [gain, tension] = solved(rows, [stated.pick(10.0, 5.0) - 0.30 * GRAVITY, -0.20 * 2.0 * GRAVITY]);
                Finding::new(gain > 0.0 && tension > 0.0, format!("the string bears {tension:.1} N"))
            })
            .but_not("half of the force would do"),
        at("line 651")
            .figure("drag.block-forces", "F to the left, friction on each block to the right", "forces on two blocks")
            .first_route(BALANCE, |stated| {
                // Both blocks go to the left: with the friction of line 656, they gain less speed than without it.
                let friction = stated.pick(-1.0, 1.0) * 0.2 * GRAVITY * 4.0;
                Finding::new((30.0 + friction) / 4.0 < 30.0 / 4.0, "the friction makes the acceleration less")
            })
            .second_route(ENERGY, |stated| {
                let power = stated.pick(-1.0, 1.0) * 0.2 * GRAVITY * 4.0 * 1.5;
                Finding::new(power < 0.0, "friction takes power from what moves to the left")
            })
            .but_not("F and the friction to the left"),
        law(
            "line 656",
            "drag.blocks-acceleration",
            r"a = \frac{F}{4} - \mu_k g",
            "acceleration of two blocks",
            &PULLED,
        ),
        at("line 672")
            .value("drag.truck-way", "11", "m", "way of the truck in 3.0 s")
            .first_route(Evidence::CLOSED_FORM, || 0.24 * GRAVITY * 3.0 * 3.0 / 2.0)
            .second_route(IN_STEPS, || line(0.0, 3.0, |_| 0.24 * GRAVITY)[1]),
        at("line 676")
            .example("drag.double-slope", "the system moves", "carts on a double slope")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [left, right] = [turned(37.0), turned(53.0)];
                let friction = stated.pick(0.30, 0.60);
                let force = 15.0 * (right[0] - 0.16 * right[1]) - 10.0 * (left[0] + friction * left[1]);
                Finding::new(force > 0.0, format!("to the right, with {:.2} m/s²", force * GRAVITY / 25.0))
            })
            .second_route(BALANCE, |stated| {
                let [left, right] = [turned(37.0), turned(53.0)];
                let friction = stated.pick(0.30, 0.60);
                let forces =
                    [-10.0 * GRAVITY * (left[0] + friction * left[1]), 15.0 * GRAVITY * (right[0] - 0.16 * right[1])];
                let [gain, tension] = solved([[10.0, -1.0], [15.0, 1.0]], forces);
                Finding::new(gain > 0.0 && tension > 0.0, format!("the string bears {tension:.0} N"))
            })
            .but_not("it would move with twice the friction on the left, too"),
    ]
}
