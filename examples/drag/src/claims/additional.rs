//! The first half of the additional problems: cars, a lift, blocks and barges.

use crate::kinds::{BALANCE, ENERGY, IN_STEPS, UNITS};
use crate::letters::POWERS;
use crate::reader;
use crate::section::{GRAVITY, at, printed, turned};
use crate::steps::{gauss, halved, line, moved, simpson, solved};
use geneva_evidence::{Claim, Consequence, Evidence, Finding, Origin, Slip, Verdict, equal_to};

/// The lift with the speed in round numbers.
const ROUND_SPEED: Slip = Slip {
    id: "",
    reason: "Ten miles per hour are 4.470 m/s, which gives 903 N. The printed force is computed with the rounded 4.5 m/s.",
    witness: "A lift moved in steps of time to 10 mi/h needs 903 N.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "",
};
/// The tension that is cut off.
const CUT_TENSION: Slip = Slip {
    id: "",
    reason: "The tension is 199.5 N, with 9.80 m/s² and the angles of the picture. It is cut off, where rounding gives 200 N.",
    witness: "The forces of both strings along and across, solved together, give 199.5 N.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "",
};
/// The child who would have to be held back.
const CHILD: Slip = Slip {
    id: "",
    reason: "The part of the child's weight along the slope is 33.7 N. With 34 N up the slope, friction would have to pull the child down \
             the slope along which it slides down, and its coefficient would be negative.",
    witness: "A child moved in steps of time without any friction is slowed down by the 34 N.",
    origin: Origin::Unknown,
    consequence: Consequence::Remark,
    changes: "With the printed numbers, the coefficient would be -0.006.",
};

pub(super) fn claims() -> Vec<Claim> {
    [cars(), lift(), strings(), slopes(), barges(), vectors()].into_iter().flatten().collect()
}

fn cars() -> Vec<Claim> {
    vec![
        at("line 404")
            .example("drag.braking", "the final velocity is unreasonable", "final velocity of a braking car")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let speed = 50.0 / 3.6 - 0.400 * 50.0;
                Finding::new(stated.pick(speed < 0.0, speed > 0.0), format!("it is {speed:.1} m/s, backwards"))
            })
            .second_route(ENERGY, |stated| {
                // Half of the square of the speed is used up on this way.
                let way = (50.0 / 3.6_f64).powi(2) / 2.0 / 0.400;
                let time = way / (50.0 / 3.6 / 2.0);
                Finding::new(stated.pick(time < 50.0, time > 50.0), format!("the car stands after {time:.0} s"))
            })
            .but_not("the final velocity is forward"),
        at("line 417")
            .example("drag.flat-curve", "the coefficient of friction is unreasonable", "friction in a flat curve")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let least = 30.0 * 30.0 / (50.0 * GRAVITY);
                Finding::new(least > stated.pick(1.0, 2.0), format!("it is at least {least:.2}"))
            })
            .second_route(IN_STEPS, |stated| {
                let least = crate::steps::pull_to_middle([1.0, 30.0, 50.0]) / GRAVITY;
                Finding::new(
                    least > stated.pick(1.0, 2.0),
                    format!("to turn the velocity takes {least:.2} of the weight"),
                )
            })
            .interpreted_as("A coefficient above 1.0, the one of line 404, is unreasonable")
            .but_not("it is above two"),
    ]
}

/// Mass of the woman in the lift, in kg.
const WOMAN: f64 = 75.0;

fn lift() -> Vec<Claim> {
    // The force that brings her to a speed in 2.00 s, moved in steps of time.
    let force =
        |speed: f64| halved([0.0, 5000.0], move |force| line(0.0, 2.00, |_| force / WOMAN - GRAVITY)[0] < speed);
    vec![
        at("line 412")
            .value("drag.scale", "1860", "N", "force on the scale")
            .first_route(Evidence::CLOSED_FORM, || WOMAN * (GRAVITY + 30.0 / 2.00))
            .second_route(IN_STEPS, move || force(30.0)),
        at("line 412")
            .value("drag.scale-ratio", "2.53", "", "ratio of the force on the scale and the weight")
            .first_route(Evidence::CLOSED_FORM, || (GRAVITY + 15.0) / GRAVITY)
            .second_route(IN_STEPS, move || force(30.0) / (WOMAN * GRAVITY)),
        at("line 412")
            .value("drag.scale-pounds", "418", "lb", "weight in pounds of that force")
            .first_route(UNITS, || 1860.0 / (0.453_592_37 * 9.806_65))
            // A pound of force is a slug's foot by the square of a second; a slug has 32.174 pounds.
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || {
                printed("drag.scale") / (0.453_592_37 * (9.806_65 / 0.3048)) / 0.3048
            }),
        at("line 412")
            .value("drag.usual-scale", "904", "N", "force on the scale in a usual lift")
            .first_route(UNITS, || WOMAN * (GRAVITY + 10.0 * 1609.344 / 3600.0 / 2.00))
            .second_route(IN_STEPS, move || force(10.0 * 1609.344 / 3600.0))
            .rounded(|| WOMAN * (GRAVITY + printed("drag.ten-miles") / 2.00))
            .expecting(Verdict::FromRounded)
            .affected_by(ROUND_SPEED),
        at("line 412")
            .value("drag.usual-pounds", "203", "lb", "weight in pounds of that force")
            .first_route(UNITS, || WOMAN * (GRAVITY + 10.0 * 1609.344 / 3600.0 / 2.00) / (0.453_592_37 * 9.806_65))
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || printed("drag.usual-scale") / 4.448_221_615_260_5),
        at("line 412")
            .value("drag.ten-miles", "4.5", "m/s", "speed of ten miles per hour")
            .first_route(UNITS, || 10.0 * 1.609_344 / 3.6)
            .second_route(Evidence::LIMIT_CASE, || 10.0 * 1760.0 * 3.0 * 12.0 * 2.54 / 100.0 / 60.0 / 60.0),
        at("line 412")
            .value("drag.lift-acceleration", "1.53", "× g", "acceleration over gravity in the lift")
            .first_route(Evidence::CLOSED_FORM, || 30.0 / 2.00 / GRAVITY)
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, || printed("drag.scale-ratio") - 1.0),
        at("line 412")
            .statement("drag.expected-force", "the force is more than you expect", "forces in two lifts")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let more = printed("drag.scale") > 2.0 * printed("drag.usual-scale");
                Finding::new(stated.pick(more, !more), "the two printed forces")
            })
            .second_route(IN_STEPS, move |stated| {
                let more = force(30.0) > 2.0 * force(10.0 * 1609.344 / 3600.0);
                Finding::new(stated.pick(more, !more), "two lifts moved in steps of time")
            })
            .interpreted_as("You expect a usual lift, and more is twice as much")
            .but_not("the force is as expected"),
    ]
}

fn strings() -> Vec<Claim> {
    vec![
        at("line 428")
            .value("drag.string-tension", "199", "N", "force of the lower string")
            .first_route(Evidence::CLOSED_FORM, || {
                // Along the lower string's own direction and across the upper one's.
                5.50 * GRAVITY * turned(40.0)[0] / turned(80.0)[1]
            })
            .second_route(BALANCE, || {
                let [sine, cosine] = turned(40.0);
                solved([[-cosine, sine], [-sine, cosine]], [0.0, 5.50 * GRAVITY])[0]
            })
            .expecting(Verdict::Truncated)
            .affected_by(CUT_TENSION),
        at("line 432")
            .example("drag.lifted-block", "the block on the table moves and stays on it", "forces on two blocks")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [sine, cosine] = turned(30.0);
                let gain = (60.0 * cosine - 4.00 * GRAVITY) / (3.0 * 4.00);
                let pressed = 2.0 * 4.00 * GRAVITY - 60.0 * sine;
                Finding::new(
                    gain > 0.0 && stated.pick(pressed > 0.0, pressed < 0.0),
                    format!("it moves with {gain:.2} m/s²"),
                )
            })
            .second_route(BALANCE, |stated| {
                let [sine, cosine] = turned(30.0);
                // Acceleration, tension and the force of the table.
                let rows = [[8.00, 1.0, 0.0], [4.00, -1.0, 0.0], [0.0, 0.0, 1.0]];
                let [gain, _, pressed] = solved(rows, [60.0 * cosine, -4.00 * GRAVITY, 8.00 * GRAVITY - 60.0 * sine]);
                Finding::new(
                    gain > 0.0 && stated.pick(pressed > 0.0, pressed < 0.0),
                    format!("the table bears {pressed:.0} N"),
                )
            })
            .but_not("the block moves and is lifted off the table"),
        at("line 446")
            .value("drag.block-tension", "15", "N", "force of the connecting string")
            .first_route(Evidence::CLOSED_FORM, || 6.0 * GRAVITY * (1.0 - turned(30.0)[0]) / 2.0)
            .second_route(BALANCE, || {
                let weight = 6.0 * GRAVITY;
                solved([[6.0, -1.0], [6.0, 1.0]], [weight * turned(30.0)[0], weight])[1]
            }),
        at("line 451")
            .example("drag.probe-fuel", "the fuel lasts for the time of the expression", "fuel of a space probe")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                Finding::new(90.0 / 3.00 == stated.pick(30.0, 15.0), "fuel over the rate at which it burns")
            })
            .second_route(IN_STEPS, |stated| {
                let [mass] = moved([20.0 + 90.0], stated.pick(30.0, 15.0), |_, _| [-3.00]);
                Finding::new(
                    (mass - 20.0).abs() < 1e-9,
                    format!("moved in steps of time, the probe then has {mass:.0} kg"),
                )
            })
            .but_not("it lasts for half of that time"),
    ]
}

fn slopes() -> Vec<Claim> {
    vec![
        at("line 459")
            .value("drag.bin-force", "12", "N", "force that lets the bin go down")
            .first_route(Evidence::CLOSED_FORM, || 2.0 * 3.0 * GRAVITY * turned(40.0)[0] - 26.0)
            .second_route(BALANCE, || {
                // Friction and force: up with 26 N, and down.
                let along = 3.0 * GRAVITY * turned(40.0)[0];
                solved([[-1.0, 0.0], [1.0, 1.0]], [along - 26.0, along])[1]
            }),
        at("line 464")
            .statement(
                "drag.child",
                "34 N up the slope, and the child slides down at constant speed",
                "force on a sliding child",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let along = 6.0 * GRAVITY * turned(35.0)[0];
                Finding::new(stated.number() <= along, format!("the weight along the slope is {along:.2} N"))
            })
            .second_route(IN_STEPS, |stated| {
                let force = stated.number();
                let speed = line(1.0, 60.0, |_| GRAVITY * turned(35.0)[0] - force / 6.0)[0];
                Finding::new(
                    speed >= 1.0,
                    format!("without friction, a child who slides down at 1 m/s has {speed:.2} m/s a minute later"),
                )
            })
            .corrected("at most 33.7 N up the slope, and the child slides down at constant speed", CHILD),
    ]
}

fn barges() -> Vec<Claim> {
    // Acceleration and tension of two barges in thousands of newtons and of kilograms.
    let towed = |[front, rear]: [[f64; 2]; 2]| solved([[front[0], 1.0], [rear[0], -1.0]], [20.0 - front[1], -rear[1]]);
    vec![
        at("line 476")
            .value("drag.barge-acceleration", "0.40", "m/s²", "acceleration of the barges")
            .first_route(Evidence::CLOSED_FORM, || (20.0 - 8.00 - 10.0) / (2.00 + 3.00))
            .second_route(BALANCE, move || towed([[2.00, 8.00], [3.00, 10.0]])[0]),
        at("line 476")
            .value("drag.barge-tension", "11.2", "× 10³ N", "thousands of newtons in the cable")
            .first_route(Evidence::CLOSED_FORM, || 10.0 + 3.00 * (20.0 - 18.0) / 5.00)
            .second_route(BALANCE, move || towed([[2.00, 8.00], [3.00, 10.0]])[1]),
        at("line 481")
            .example(
                "drag.barges-turned",
                "in the other order the barges gain speed alike",
                "barges in the other order",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let both = (20.0 - 10.0 - 8.00) / stated.pick(5.00, 3.00);
                Finding::new((both - 0.40_f64).abs() < 1e-9, "force and mass of both together are the same")
            })
            .second_route(BALANCE, move |stated| {
                let [gain, tension] = towed([[3.00, 10.0], [2.00, 8.00]]);
                let alike = (gain - stated.pick(0.40, 0.60)).abs() < 1e-9 && tension > 0.0;
                Finding::new(alike, format!("the cable then bears {tension:.1} thousand newtons"))
            })
            .but_not("in the other order they gain speed half as fast again"),
    ]
}

fn vectors() -> Vec<Claim> {
    let force = equal_to("F");
    let again = force.clone();
    let both = |line, id, printed, meaning| {
        at(line)
            .equation(id, printed, meaning)
            .evaluated(POWERS.kinds[0], |tex| {
                Finding::of_reading(reader::holds(tex, &POWERS.first, |ends, curve| gauss(ends, curve)))
            })
            .read(POWERS.kinds[1], |tex| reader::holds(tex, &POWERS.second, |ends, curve| simpson(ends, curve)))
    };
    // From the velocity and the force, over 3.0 s.
    const OBJECT: f64 = 2.0;
    let end = || moved([4.0, 0.0], 3.0, |_, _| [2.0, 4.0].map(|force| force / OBJECT));
    vec![
        at("line 489")
            .equation("drag.force-of-place", "m (6 p t + 2 q)", "force on a body whose place is given")
            .evaluated(POWERS.kinds[0], move |tex| {
                Finding::of_reading(reader::holds(&force(tex), &POWERS.first, |ends, curve| gauss(ends, curve)))
            })
            .read(POWERS.kinds[1], move |tex| {
                reader::holds(&again(tex), &POWERS.second, |ends, curve| simpson(ends, curve))
            }),
        both(
            "line 502",
            "drag.car-velocity",
            r"\vec{v}(t) = \left(\frac{p t}{m} + \frac{n t^2}{2 m}\right) \hat{i} + \left(\frac{q t^2}{2 m}\right) \hat{j}",
            "velocity of an electric car",
        ),
        both(
            "line 502",
            "drag.car-place",
            r"\vec{r}(t) = \left(\frac{p t^2}{2 m} + \frac{n t^3}{6 m}\right) \hat{i} + \left(\frac{q t^3}{6 m}\right) \hat{j}",
            "place of an electric car",
        ),
        at("line 514")
            .value("drag.object-speed", "9.2", "m/s", "speed of an object after 3.0 s")
            .first_route(Evidence::VECTORS, || libm::hypot(4.0 + 2.0 * 3.0 / OBJECT, 4.0 * 3.0 / OBJECT))
            .second_route(ENERGY, move || {
                // The work of the force on its way, besides the energy at the beginning.
                let [speed, other] = end();
                let way = [(4.0 + speed) / 2.0 * 3.0, other / 2.0 * 3.0];
                (4.0 * 4.0 + 2.0 * (2.0 * way[0] + 4.0 * way[1]) / 2.0).sqrt()
            }),
        at("line 527")
            .value("drag.belt-time", "1.3", "s", "time until the box no longer slips")
            .first_route(Evidence::CLOSED_FORM, || 3.4 / (0.27 * GRAVITY))
            .second_route(IN_STEPS, || halved([0.0, 10.0], |time| line(0.0, time, |_| 0.27 * GRAVITY)[0] < 3.4)),
        at("line 532")
            .example("drag.pushed-up", "the block goes up the slope", "block pushed up a slope")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [sine, cosine] = turned(30.0);
                let [along, across] = [200.0 * cosine - 98.0 * sine, 98.0 * cosine + 200.0 * sine];
                let gain = (along - stated.pick(0.50, 1.0) * across) / 10.0;
                Finding::new(gain > 0.0, format!("it gains {gain:.1} m/s in a second"))
            })
            .second_route(BALANCE, |stated| {
                let [sine, cosine] = turned(30.0);
                // Along and upright: acceleration along the slope, and the force of the slope across it.
                let friction = stated.pick(0.50, 1.0);
                let rows = [[10.0 * cosine, sine + friction * cosine], [10.0 * sine, friction * sine - cosine]];
                let [gain, _] = solved(rows, [200.0, -98.0]);
                Finding::new(gain > 0.0, format!("the forces level and upright give {gain:.1} m/s²"))
            })
            .but_not("with a coefficient of friction of 1 it would go up too"),
        at("line 546")
            .value("drag.two-block-acceleration", "3.5", "m/s²", "acceleration of the two blocks")
            .first_route(Evidence::CLOSED_FORM, || {
                let [sine, cosine] = turned(37.0);
                (8.0 - 4.0 * sine - 0.40 * 4.0 * cosine) * GRAVITY / 12.0
            })
            .second_route(BALANCE, || {
                let [sine, cosine] = turned(37.0);
                let rows = [[4.0, -1.0], [8.0, 1.0]];
                solved(rows, [-4.0 * GRAVITY * sine - 0.40 * 4.0 * GRAVITY * cosine, 8.0 * GRAVITY])[0]
            }),
    ]
}
