//! Drag that is as the speed: the integrals, the motorboat, the summary and the key equations.

use super::terminal::terminal_in_steps;
use crate::kinds::{BALANCE, ENERGY, IN_STEPS};
use crate::letters::{BOAT, CIRCLE, DRAG, FALL, FRICTION, LATE_BOAT, LOGARITHM, SLOWED, force_by_energy};
use crate::reader;
use crate::section::{AIR, GRAVITY, SECTION, at, law, printed};
use crate::steps::{halved, line};
use geneva_evidence::{Claim, Consequence, Evidence, Finding, Origin, Slip};

/// Where the integral over the speeds of the boat begins.
const LOWER_LIMIT: Slip = Slip {
    id: "",
    reason: "At the time zero the speed is v_0, as the line before says. From zero, the integral over one over the speed is infinite.",
    witness: "The line that follows, with the logarithm of the speed over v_0, is the integral from v_0.",
    origin: Origin::Misprint,
    consequence: Consequence::Derivation,
    changes: "",
};

pub(super) fn claims() -> Vec<Claim> {
    [fall(), integrals(), boat(), example(), summary(), key_equations()].into_iter().flatten().collect()
}

fn fall() -> Vec<Claim> {
    vec![
        at("line 171")
            .statement("drag.moderate", "In a liquid at moderate speed, the friction is often about -bv", "drag in a liquid")
            .missing(
                "Neither moderate nor often nor how nearly is said. For bodies that are not small, drag in water is as the square of the \
                 speed even when they move slowly",
            ),
        law("line 172", "drag.linear-law", "f_R = -b v", "drag that is as the speed", &FALL),
        at("line 173")
            .statement("drag.two-situations", "Two situations: a motorboat, a small body that sinks slowly", "where drag is as the speed")
            .missing(
                "For the small slow body it follows from the law of Stokes. For the motorboat it would have to be measured: no size is given, \
                 and line 21 has the drag of large objects as the square of the speed",
            ),
        law("line 174", "drag.equation-of-motion", r"m g - b v = m \frac{dv}{dt}", "equation of motion", &FALL),
        at("line 175")
            .statement("drag.matches", "As the speed grows, the friction grows until it matches the weight", "forces in a liquid")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let part = |time: f64| -libm::expm1(-time);
                let grows = part(1.0) < part(2.0) && (part(60.0) - stated.pick(1.0, 0.5)).abs() < 1e-12;
                Finding::new(grows, "friction over weight, by the exponential")
            })
            .second_route(IN_STEPS, |stated| {
                let part = |time| line(0.0, time, |speed| GRAVITY - 2.0 * speed)[0] * 2.0 / GRAVITY;
                let grows = part(0.5) < part(1.0) && (part(30.0) - stated.pick(1.0, 0.5)).abs() < 1e-9;
                Finding::new(grows, "a body moved in steps of time")
            })
            .but_not("the friction grows until it matches half of the weight"),
        law("line 176", "drag.balance", "m g - b v_T = 0", "forces at the terminal speed", &FALL),
        law("line 178", "drag.linear-terminal", r"v_T = \frac{m g}{b}", "terminal speed", &FALL),
        at("line 180")
            .figure("drag.free-body", "weight down, friction up, velocity down, positive y down", "forces on the falling body")
            .first_route(BALANCE, |stated| {
                // Downward is positive: the law of motion of line 174 has this weight, this friction and a positive speed.
                let [weight, speed] = [1.0_f64, 0.5];
                let friction = -0.7 * speed;
                let gain = weight + stated.pick(friction, -friction);
                Finding::new((gain - (1.0 - 0.7 * 0.5)).abs() < 1e-12, "the signs of the law of motion")
            })
            .second_route(ENERGY, |stated| {
                let power = |force: f64, speed: f64| force * speed;
                let gives = power(1.0, 0.5) > 0.0;
                let takes = power(stated.pick(-0.7, 0.7) * 0.5, 0.5) < 0.0;
                Finding::new(gives && takes, "gravity gives power and friction takes it")
            })
            .but_not("weight, friction and velocity all point down"),
    ]
}

fn integrals() -> Vec<Claim> {
    vec![
        law("line 186", "drag.separated", r"\frac{dv}{g - (b/m) v} = dt", "speed and time apart", &FALL),
        law(
            "line 188",
            "drag.integral",
            r"\int_0^v \frac{dv'}{g - (b/m) v'} = \int_0^t dt'",
            "integral over the speed and over the time",
            &FALL,
        ),
        law(
            "line 190",
            "drag.limits",
            r"\left. -\frac{m}{b} \ln(g - \frac{b}{m} v') \right|_0^v = \left. t' \right|_0^t",
            "integral with its limits",
            &FALL,
        ),
        law(
            "line 192",
            "drag.logarithms",
            r"-\frac{m}{b} [\ln(g - \frac{b}{m} v) - \ln g] = t",
            "time by the speed",
            &FALL,
        ),
        law("line 193", "drag.quotient", r"\ln A - \ln B = \ln(A/B)", "logarithm of a quotient", &LOGARITHM),
        law("line 193", "drag.inverse", r"\ln(A/B) = x", "logarithm that is called x", &LOGARITHM),
        law("line 193", "drag.exponential", r"e^x = A/B", "exponential of the logarithm", &LOGARITHM),
        law(
            "line 194",
            "drag.remaining",
            r"\frac{g - (b v/m)}{g} = e^{-b t/m}",
            "what is left of the acceleration",
            &FALL,
        ),
        law("line 196", "drag.speed", r"v = \frac{m g}{b} (1 - e^{-b t/m})", "speed by the time", &FALL),
        at("line 197")
            .statement(
                "drag.long-time",
                "After a long time the speed is the terminal velocity mg/b",
                "speed after a long time",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [mass, factor] = [1.7, 0.6];
                let speed = mass * GRAVITY / factor * -libm::expm1(-factor * 200.0 / mass);
                let limit = stated.pick(mass * GRAVITY / factor, factor * GRAVITY / mass);
                Finding::new((speed / limit - 1.0).abs() < 1e-12, "the exponential has gone")
            })
            .second_route(IN_STEPS, |stated| {
                let [mass, factor] = [2.3, 0.8];
                let speed = line(0.0, 200.0, |speed| GRAVITY - factor * speed / mass)[0];
                let limit = stated.pick(mass * GRAVITY / factor, factor * GRAVITY / mass);
                Finding::new((speed / limit - 1.0).abs() < 1e-9, "a body moved in steps of time")
            })
            .but_not("after a long time the speed is bg/m"),
        law("line 198", "drag.velocity", r"v = \frac{dy}{dt}", "definition of the velocity", &FALL),
        law("line 199", "drag.way-step", r"dy = \frac{m g}{b} (1 - e^{-b t/m}) dt", "small step of the way", &FALL),
        law(
            "line 201",
            "drag.way-integral",
            r"\int_0^y dy' = \frac{m g}{b} \int_0^t (1 - e^{-bt'/m}) dt'",
            "integral over the way and over the time",
            &FALL,
        ),
        law(
            "line 203",
            "drag.way",
            r"y = \frac{m g}{b} t + \frac{m^2 g}{b^2} (e^{-b t/m} - 1)",
            "way by the time",
            &FALL,
        ),
    ]
}

fn boat() -> Vec<Claim> {
    vec![
        law("line 210", "drag.boat-motion", r"m \frac{dv}{dt} = -b v", "equation of motion of the boat", &BOAT),
        law(
            "line 212",
            "drag.boat-separated",
            r"\frac{dv}{v} = -\frac{b}{m} dt",
            "speed and time of the boat apart",
            &BOAT,
        ),
        law(
            "line 214",
            "drag.boat-integral",
            r"\int_0^v \frac{dv'}{v'} = -\frac{b}{m} \int_0^t dt'",
            "integral over the boat's speed",
            &BOAT,
        )
        .corrected(r"\int_{v_0}^v \frac{dv'}{v'} = -\frac{b}{m} \int_0^t dt'", LOWER_LIMIT)
        .in_places(2),
        law(
            "line 216",
            "drag.boat-logarithm",
            r"\ln\frac{v}{v_0} = -\frac{b}{m} t",
            "logarithm of the boat's speed",
            &BOAT,
        ),
        law("line 218", "drag.boat-speed", r"v = v_0 e^{-b t/m}", "speed of the boat by the time", &BOAT),
        law("line 220", "drag.boat-velocity", r"\frac{dx}{dt} = v_0 e^{-b t/m}", "velocity of the boat", &BOAT),
        law("line 222", "drag.boat-step", r"dx = v_0 e^{-b t/m} dt", "small step of the boat's way", &BOAT),
        law(
            "line 224",
            "drag.boat-way-integral",
            r"\int_0^x dx' = v_0 \int_0^t e^{-bt'/m} dt'",
            "integral over the boat's way",
            &BOAT,
        ),
        law(
            "line 226",
            "drag.boat-position",
            r"x = \left. -\frac{m v_0}{b} e^{-bt'/m} \right|_0^t = \frac{m v_0}{b} (1 - e^{-b t/m})",
            "place of the boat by the time",
            &BOAT,
        ),
        at("line 227")
            .statement("drag.boat-decay", "As time grows, e^{-bt/m} goes to 0", "exponential after a long time")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let left = libm::exp(stated.pick(-700.0, 0.0));
                Finding::new((left - stated.number()).abs() < 1e-12, "its value for 700 time constants")
            })
            .second_route(IN_STEPS, |stated| {
                let left = line(1.0, stated.pick(60.0, 0.0), |speed| -speed)[0];
                Finding::new((left - stated.number()).abs() < 1e-12, "a boat moved in steps for 60 time constants")
            })
            .but_not("at the beginning it is already so"),
        law("line 228", "drag.boat-limit", r"x_{\max} = \frac{m v_0}{b}", "way of the boat in the end", &BOAT),
        at("line 229")
            .statement(
                "drag.boat-infinite",
                "The boat takes infinitely long to get there",
                "time to the boat's last place",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let before = [1.0, 10.0, 30.0].iter().all(|time| -libm::expm1(-time) < 1.0);
                Finding::new(stated.pick(before, !before), "at every time, an exponential is missing")
            })
            .second_route(IN_STEPS, |stated| {
                let before = [1.0, 10.0, 25.0].iter().all(|time| line(1.0, *time, |speed| -speed)[0] > 0.0);
                Finding::new(stated.pick(before, !before), "a boat moved in steps of time still moves")
            })
            .but_not("the boat gets there after thirty time constants"),
        law("line 230", "drag.late-speed", r"v = v_0 e^{-10}", "speed after ten time constants", &LATE_BOAT),
        at("line 230")
            .value("drag.late-part", "4.5", "× 10⁻⁵", "remaining part of the speed after ten time constants")
            .first_route(Evidence::CLOSED_FORM, || 1e5 * libm::exp(-10.0))
            .second_route(IN_STEPS, || 1e5 * line(1.0, 10.0, |speed| -speed)[0]),
        law("line 232", "drag.late-place", r"x = x_{\max} (1 - e^{-10})", "place after ten time constants", &LATE_BOAT),
        at("line 232")
            .value("drag.late-way", "0.99995", "", "part of the way after ten time constants")
            .first_route(Evidence::CLOSED_FORM, || -libm::expm1(-10.0))
            .second_route(IN_STEPS, || line(1.0, 10.0, |speed| -speed)[1]),
    ]
}

fn example() -> Vec<Claim> {
    let rate = || halved([0.0, 1.0], |rate| line(4.0, 10.0, |speed| -rate * speed)[0] > 1.0);
    vec![
        law(
            "line 234",
            "drag.slowed",
            r"1.0 \,\text{m}/\text{s} = (4.0 \,\text{m}/\text{s}) e^{-(b/m)(10 \,\text{s})}",
            "speeds of the boat",
            &SLOWED,
        ),
        law(
            "line 235",
            "drag.slowed-logarithm",
            r"\ln 0.25 = -\ln 4.0 = -\frac{b}{m} (10 \,\text{s})",
            "logarithm of the boat's speeds",
            &SLOWED,
        ),
        law(
            "line 237",
            "drag.slowed-rate",
            r"\frac{b}{m} = \frac{1}{10} \ln 4.0 \,\text{s}^{-1}",
            "rate of the boat",
            &SLOWED,
        ),
        at("line 237")
            .value("drag.boat-rate", "0.14", "s⁻¹", "rate of slowing of the boat")
            .first_route(Evidence::CLOSED_FORM, || libm::log(4.0) / 10.0)
            .second_route(IN_STEPS, rate),
        at("line 239")
            .value("drag.boat-way", "29", "m", "way of the boat until it stops")
            .first_route(Evidence::CLOSED_FORM, || 40.0 / libm::log(4.0))
            .second_route(IN_STEPS, move || {
                let rate = rate();
                line(4.0, 300.0, move |speed| -rate * speed)[1]
            }),
        at("line 242")
            .statement("drag.limiting", "The terminal velocity is the limiting velocity", "two names of a speed")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let limit = 2.0 * GRAVITY * -libm::expm1(stated.pick(-300.0, -1.0));
                Finding::new(
                    (limit / (GRAVITY / 0.5) - 1.0).abs() < 1e-12,
                    "the speed after a long time, and the balance of forces",
                )
            })
            .second_route(IN_STEPS, |stated| {
                let limit = line(0.0, stated.pick(200.0, 2.0), |speed| GRAVITY - 0.5 * speed)[0];
                Finding::new((0.5 * limit / GRAVITY - 1.0).abs() < 1e-9, "after a long time the drag is the weight")
            })
            .but_not("it is the velocity after one time constant"),
        at("line 250")
            .value("drag.heavy-factor", "0.27", "kg/m", "factor of the square of the speed, for 100 kg")
            .first_route(Evidence::CLOSED_FORM, || 100.0 * GRAVITY / (60.0 * 60.0))
            .second_route(IN_STEPS, || {
                // The area of a skydiver with drag coefficient 1 who falls so fast, moved in steps of time.
                let area = halved([0.01, 5.0], |area| terminal_in_steps([100.0, 1.0, area]) > 60.0);
                force_by_energy([1.0, AIR, area, 60.0]) / (60.0 * 60.0)
            }),
    ]
}

fn summary() -> Vec<Claim> {
    vec![
        at("line 259")
            .statement(
                "drag.summary-stokes",
                "In water, a bacterium's drag is by the law of Stokes",
                "drag of a bacterium",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // Size and speed of line 161.
                let size = stated.pick(1e-6, 1.0);
                let reynolds = 1000.0 * size * (printed("drag.bacterium-speed") * size) / 1e-3;
                Finding::new(reynolds < 0.1, format!("the Reynolds number is {reynolds:.1e}"))
            })
            .second_route(ENERGY, |stated| {
                // What a sphere of a micrometre, or of a metre, loses by pushing water away and by viscosity, in its own length a second.
                let size = stated.pick(1e-6, 1.0);
                let pushed = force_by_energy([0.45, 1000.0, size * size, size]);
                let viscous = 9.42 * 1e-3 * size * size;
                Finding::new(pushed < 0.1 * viscous, "the water that it pushes away takes almost none of the power")
            })
            .but_not("so is that of a swimmer"),
    ]
}

fn key_equations() -> Vec<Claim> {
    vec![
        at("line 264")
            .statement("drag.key-words", "half C rho A v squared; 6 pi r eta v", "numbers in the key equations")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let numbers = stated.numbers();
                Finding::new(
                    numbers == [stated.pick(1.0, 2.0) / 2.0, 2.0 + 4.0],
                    "friction is four parts of six, and pressure two",
                )
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let [half, two] = SECTION.printed_integers("drag.law")[..2] else {
                    return Finding::new(false, "no fraction");
                };
                let six = SECTION.printed_integers("drag.stokes").first().copied().unwrap_or_default();
                let numbers = [stated.pick(f64::from(half), 2.0) / f64::from(two), f64::from(six)];
                Finding::new(stated.numbers() == numbers, "lines 23 and 158")
            })
            .but_not("the drag law has no half"),
        at("line 272")
            .equation("drag.static-friction", r"f_s \leq \mu_s N", "friction of a body at rest")
            .evaluated(FRICTION.kinds[0], |tex| Finding::of_reading(reader::is_bounded(tex, &FRICTION.first)))
            .read(FRICTION.kinds[1], |tex| reader::is_bounded(tex, &FRICTION.second)),
        law("line 276", "drag.kinetic-friction", r"f_k = \mu_k N", "friction of a sliding body", &FRICTION),
        law("line 280", "drag.centripetal-speed", r"F_c = m \frac{v^2}{r}", "centripetal force by the speed", &CIRCLE),
        law(
            "line 280",
            "drag.centripetal-turning",
            r"F_c = m r \omega^2",
            "centripetal force by the angular speed",
            &CIRCLE,
        ),
        law("line 284", "drag.banked", r"\tan\theta = \frac{v^2}{r g}", "angle of a banked curve", &CIRCLE),
        law("line 288", "drag.law-again", r"F_D = \frac{1}{2} C \rho A v^2", "drag force, in the list", &DRAG),
    ]
}
