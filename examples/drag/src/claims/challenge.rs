//! The challenge problems, and the glossary.

use crate::kinds::{BALANCE, ENERGY, IN_STEPS};
use crate::letters::{FALL, SHOT, THRUST};
use crate::section::{GRAVITY, at, law};
use crate::steps::{halved, limiting, line, pull_to_middle};
use geneva_evidence::{Claim, Consequence, Evidence, Finding, Origin, Slip};
use std::f64::consts::TAU;

/// The terminal speed below the parachute.
const TENFOLD: Slip = Slip {
    id: "",
    reason: "With b = 0.750, the weight of 82.0 kg over b is 1071 m/s. The printed speed would need b = 7.50.",
    witness: "A skydiver moved in steps of time with b = 0.750 approaches 1071 m/s.",
    origin: Origin::Misprint,
    consequence: Consequence::Result,
    changes: "Either b or the speed is wrong by a factor of ten, and with it the time in the air.",
};
/// The time below the parachute.
const AT_ONCE: Slip = Slip {
    id: "",
    reason: "The printed time is the remaining 1030 m over 107 m/s, as if the skydiver had his terminal speed at once. He begins with \
             98 m/s and needs 7.8 s with b = 0.750, and 10.2 s with b = 7.50.",
    witness: "A skydiver moved in steps of time from 98 m/s falls through 1030 m in 7.8 s.",
    origin: Origin::Concept,
    consequence: Consequence::Result,
    changes: "With the printed b, the skydiver is on the ground after 7.8 s.",
};

/// Mass over b of the skydiver, in seconds.
const TIME_CONSTANT: f64 = 82.0 / 0.750;

pub(super) fn claims() -> Vec<Claim> {
    [earth(), turns(), parachute(), resistance()].into_iter().flatten().collect()
}

fn earth() -> Vec<Claim> {
    vec![
        law("line 687", "drag.far-weight", r"w = \frac{m g r_0^2}{r^2}", "weight by the distance", &SHOT),
        law("line 687", "drag.chain", "a dr = v dv", "small steps of place and speed", &SHOT),
        law(
            "line 690",
            "drag.shot",
            r"v = \sqrt{v_0^2 - 2 g r_0 \left(1 - \frac{r_0}{r}\right)}",
            "velocity by the distance",
            &SHOT,
        ),
    ]
}

fn turns() -> Vec<Claim> {
    vec![
        at("line 695")
            .example("drag.centrifuge", "the cage swings out nearly level", "cage of a centrifuge")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let angle = libm::atan(1.0 / 10.0).to_degrees();
                Finding::new(angle < stated.pick(10.0, 1.0), format!("it hangs {angle:.1}° below the level"))
            })
            .second_route(IN_STEPS, |stated| {
                let speed = halved([1.0, 200.0], |speed| pull_to_middle([1.0, speed, 15.0]) < 10.0 * GRAVITY);
                let angle = libm::atan2(GRAVITY, pull_to_middle([1.0, speed, 15.0])).to_degrees();
                Finding::new(angle < stated.pick(10.0, 1.0), format!("it turns by {:.2} rad/s", speed / 15.0))
            })
            .interpreted_as("Nearly level is less than 10°")
            .but_not("it hangs less than 1° below the level"),
        at("line 696")
            .figure(
                "drag.centrifuge-forces",
                "the arm's force up and to the left, weight down, net force left",
                "forces in a centrifuge",
            )
            .first_route(Evidence::VECTORS, |stated| {
                let [arm, weight] = [[-10.0, stated.pick(1.0, -1.0)], [0.0, -1.0]];
                Finding::new(arm[1] + weight[1] == 0.0 && arm[0] + weight[0] < 0.0, "the sum of the arrows is level")
            })
            .second_route(BALANCE, |stated| {
                // The cage does not move up or down.
                let upright = stated.pick(1.0, -1.0) * GRAVITY - GRAVITY;
                Finding::new(upright == 0.0, "the upright forces cancel")
            })
            .but_not("the arm's force down and to the left"),
        law_of_steps(),
        at("line 706")
            .value("drag.stopping-way", "78.7", "m", "way until the car stands")
            .first_route(ENERGY, || (100.0 / 3.6_f64).powi(2) / (2.0 * 0.500 * GRAVITY))
            .second_route(IN_STEPS, || {
                let speed = 100.0 / 3.6;
                line(speed, speed / (0.500 * GRAVITY), |_| -0.500 * GRAVITY)[1]
            }),
        at("line 711")
            .example("drag.bank", "an airplane can fly the bank angle", "bank angle of an airplane")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let angle = libm::atan(200.0 * TAU / 240.0 / GRAVITY).to_degrees();
                Finding::new(angle < stated.pick(45.0, 20.0), format!("it is {angle:.0}°"))
            })
            .second_route(IN_STEPS, |stated| {
                let radius = 200.0 * 240.0 / TAU;
                let angle = libm::atan2(pull_to_middle([1.0, 200.0, radius]), GRAVITY).to_degrees();
                Finding::new(angle < stated.pick(45.0, 20.0), format!("on a circle of {radius:.0} m it is {angle:.0}°"))
            })
            .interpreted_as("The turn is a whole circle, and an airplane flies angles below 45°")
            .but_not("it is less than 20°"),
    ]
}

/// The chain rule of the hint, for a body whose speed changes.
fn law_of_steps() -> Claim {
    at("line 703")
        .statement("drag.chain-rule", "dv/dt = (dv/dx)(dx/dt) = v dv/dx", "chain rule for the speed")
        .first_route(Evidence::CLOSED_FORM, |stated| {
            // A speed that is as the root of the way: half of the factor's square is the acceleration.
            let [factor, way] = [3.0_f64, 4.0_f64];
            let speed = factor * way.sqrt();
            let by_way = factor / (2.0 * way.sqrt());
            let product = stated.pick(speed, way) * by_way;
            Finding::new((product - factor * factor / 2.0).abs() < 1e-12, "a body with a constant acceleration")
        })
        .second_route(IN_STEPS, |stated| {
            let gain = |speed: f64| -0.3 * speed;
            let [[early, from], [late, to]] = [0.999, 1.001].map(|time| line(5.0, time, gain));
            let [speed, way] = line(5.0, 1.0, gain);
            let product = stated.pick(speed, way) * (late - early) / (to - from);
            Finding::new((product / gain(speed) - 1.0).abs() < 1e-6, "a braked body moved in steps of time")
        })
        .but_not("dv/dt = x dv/dx")
}

/// Speed and way of the skydiver, from the speed at which his parachute opens.
fn below(time: f64) -> [f64; 2] {
    line(98.0, time, |speed| GRAVITY - speed / TIME_CONSTANT)
}

fn parachute() -> Vec<Claim> {
    vec![
        at("line 719")
            .value("drag.parachute-speed", "98", "m/s", "speed of the skydiver after 10.0 s")
            .first_route(Evidence::CLOSED_FORM, || GRAVITY * 10.0)
            .second_route(IN_STEPS, || line(0.0, 10.0, |_| GRAVITY)[0]),
        at("line 719")
            .value("drag.parachute-fall", "490", "m", "way of the skydiver in 10.0 s")
            .first_route(ENERGY, || 98.0 * 98.0 / 2.0 / GRAVITY)
            .second_route(IN_STEPS, || line(0.0, 10.0, |_| GRAVITY)[1]),
        at("line 719")
            .value("drag.parachute-limit", "107", "m/s", "speed of the skydiver after a long time")
            .first_route(BALANCE, || 82.0 * GRAVITY / 0.750)
            .second_route(IN_STEPS, || limiting(40.0 * TIME_CONSTANT, |speed| GRAVITY - speed / TIME_CONSTANT))
            .corrected("1071", TENFOLD),
        at("line 719")
            .value("drag.parachute-time", "9.6", "s", "time below the parachute")
            .first_route(Evidence::CLOSED_FORM, || {
                // Newton's steps towards the time at which the exponential law gives 1520 m less 490 m.
                let limit = GRAVITY * TIME_CONSTANT;
                (0..50).fold(5.0, |time: f64, _| {
                    let left = libm::exp(-time / TIME_CONSTANT);
                    let speed = limit + (98.0 - limit) * left;
                    let way = limit * time + (98.0 - limit) * TIME_CONSTANT * (1.0 - left);
                    time - (way - (1520.0 - 490.0)) / speed
                })
            })
            .second_route(IN_STEPS, || halved([0.0, 20.0], |time| below(time)[1] < 1520.0 - 490.0))
            .corrected("7.8", AT_ONCE),
    ]
}

fn resistance() -> Vec<Claim> {
    vec![
        law("line 723", "drag.bead-law", r"v = \frac{m g}{b} (1 - e^{-b t/m})", "speed of a bead in shampoo", &FALL),
        law("line 731", "drag.thrust-speed", r"v = 20.0 (1 - e^{-0.01 t})", "speed of a motor boat", &THRUST),
        at("line 731")
            .value("drag.thrust-limit", "20", "m/s", "speed of the motor boat in the end")
            .first_route(BALANCE, || 40.0 / 2.0)
            .second_route(IN_STEPS, || limiting(4000.0, |speed| (40.0 - 2.0 * speed) / 200.0)),
        at("line 743")
            .statement(
                "drag.glossary",
                "at the terminal velocity, weight is balanced by drag",
                "terminal velocity in the glossary",
            )
            .first_route(BALANCE, |stated| {
                let drag = stated.pick(1.0, 0.9) * 75.0 * GRAVITY;
                Finding::new((75.0 * GRAVITY - drag).abs() < 1e-9, "with no net force the velocity stays")
            })
            .second_route(IN_STEPS, |stated| {
                let speed = limiting(60.0, |speed| GRAVITY - 0.5 * speed);
                Finding::new(
                    (0.5 * speed - stated.pick(1.0, 0.9) * GRAVITY).abs() < 1e-9,
                    "a body moved in steps of time",
                )
            })
            .interpreted_as("The buoyancy is left out, as line 119 says for air")
            .but_not("nine tenths of the weight are balanced by drag"),
    ]
}
