//! Terminal velocity, with the worked example, and the law of Stokes.

use crate::kinds::{BALANCE, ENERGY, IN_STEPS, UNITS};
use crate::letters::{AIR_FALL, SPHERE, TERMINAL, force_by_energy, force_by_parcels};
use crate::reader;
use crate::section::{AIR, GRAVITY, at, is_near, law, printed, rounds};
use crate::steps::{gauss, halved, limiting, line, simpson};
use geneva_evidence::tex::Moment;
use geneva_evidence::{Claim, Consequence, Evidence, Finding, Origin, Slip};
use std::f64::consts::PI;

/// The terminal speed of a falling body, by the formula: mass in kg, drag coefficient, area in m².
pub(super) fn terminal([mass, coefficient, area]: [f64; 3]) -> f64 {
    (2.0 * mass * GRAVITY / (AIR * coefficient * area)).sqrt()
}

/// The terminal speed of the same body, moved in steps of time.
pub(super) fn terminal_in_steps([mass, coefficient, area]: [f64; 3]) -> f64 {
    limiting(400.0, |speed| GRAVITY - force_by_parcels([coefficient, AIR, area, speed]) / mass)
}

/// The skydivers of the section: head first, and lying flat.
const HEADFIRST: [f64; 3] = [75.0, 0.70, 0.18];
const FLAT: [f64; 3] = [85.0, 1.0, 0.70];
const LIGHT: [f64; 3] = [50.0, 1.0, 0.70];

/// How the skydiver of 75 kg falls.
const POSTURE: Slip = Slip {
    id: "",
    reason: "Where this skydiver is introduced, in lines 128 and 130, he falls head first.",
    witness: "The speed of 98 m/s belongs to the drag coefficient with which the exercise of line 331 is solved, and that skydiver \
              falls head first too.",
    origin: Origin::Misprint,
    consequence: Consequence::Remark,
    changes: "",
};
/// When drag is not as the square of the speed.
const DENSE: Slip = Slip {
    id: "",
    reason: "In water, a ball of 10 cm that moves at 1 m/s has a Reynolds number of about 100,000, so its drag is as the square of \
             its speed. At the same size and speed, a denser fluid makes the square law better, if it is not more viscous.",
    witness: "By the law of Stokes the ball's drag would be about 0.001 N. The drag coefficient of the table gives nearly 2 N.",
    origin: Origin::Concept,
    consequence: Consequence::Remark,
    changes: "A large or fast body in water has a drag as the square of its speed.",
};

pub(super) fn claims() -> Vec<Claim> {
    [falling(), skydivers(), example(), sizes(), stokes(), lake()].into_iter().flatten().collect()
}

fn falling() -> Vec<Claim> {
    vec![
        at("line 119")
            .statement("drag.two-forces", "The two forces are weight and drag", "forces on a skydiver")
            .first_route(Evidence::LIMIT_CASE, |stated| {
                // Weight, drag, and the buoyancy that is left out, over the weight of somebody as dense as water.
                let forces = [1.0, 1.0, AIR / 1000.0];
                let felt = forces.iter().filter(|force| **force > stated.pick(0.01, 0.001)).count();
                Finding::new(stated.count() as usize == felt, "the buoyancy of the air is a thousandth of the weight")
            })
            .second_route(IN_STEPS, |stated| {
                // What the buoyancy changes in the fall.
                let fall = |buoyancy: f64| {
                    line(0.0, 30.0, |speed| {
                        GRAVITY * (1.0 - buoyancy) - force_by_parcels([0.7, AIR, 0.18, speed]) / 75.0
                    })[1]
                };
                let matters = (fall(0.0) / fall(AIR / 1000.0) - 1.0).abs() > stated.pick(0.01, 1e-4);
                let felt = 2 + u32::from(matters);
                Finding::new(
                    stated.count() == felt,
                    "without the buoyancy of the air a fall of half a minute is as long",
                )
            })
            .interpreted_as("A force counts if it is at least a hundredth of the weight")
            .but_not("a force of a thousandth of the weight counts too"),
        at("line 119")
            .statement("drag.grows", "The drag grows until it equals the weight", "drag of a falling skydiver")
            .first_route(ENERGY, |stated| {
                let limit = terminal(HEADFIRST);
                let [_, coefficient, area] = HEADFIRST;
                let drag = |part: f64| force_by_energy([coefficient, AIR, area, part * limit]) / (75.0 * GRAVITY);
                let grows = drag(0.5) < drag(0.9) && drag(0.9) < drag(1.0);
                Finding::new(
                    grows && is_near(drag(1.0), stated.pick(1.0, 2.0)),
                    "the power of drag and weight at the terminal speed",
                )
            })
            .second_route(IN_STEPS, |stated| {
                let [mass, coefficient, area] = HEADFIRST;
                let drag = |speed| force_by_parcels([coefficient, AIR, area, speed]) / (mass * GRAVITY);
                let at = |time| drag(line(0.0, time, |speed| GRAVITY * (1.0 - drag(speed)))[0]);
                let grows = at(5.0) < at(10.0) && at(10.0) < at(20.0);
                Finding::new(
                    grows && (at(300.0) - stated.pick(1.0, 2.0)).abs() < 1e-9,
                    "a skydiver moved in steps of time",
                )
            })
            .but_not("the drag grows until it is twice the weight"),
        at("line 119")
            .statement("drag.no-acceleration", "zero net force, zero acceleration", "second law at the terminal speed")
            .first_route(BALANCE, |stated| {
                let [force, acceleration] = stated.numbers()[..] else {
                    return Finding::new(false, "there are no two numbers");
                };
                Finding::new(force / 75.0 == stated.pick(acceleration, acceleration + 1.0), "force over mass")
            })
            .second_route(IN_STEPS, |stated| {
                let [force, acceleration] = stated.numbers()[..] else {
                    return Finding::new(false, "there are no two numbers");
                };
                let gain = line(40.0, 1.0, |_| force / 75.0)[0] - 40.0;
                Finding::new(
                    (gain - stated.pick(acceleration, acceleration + 1.0)).abs() < 1e-9 && force == 0.0,
                    "a body keeps its speed",
                )
            })
            .but_not("with no net force, the acceleration is one"),
        at("line 119")
            .statement("drag.heavier", "A heavier skydiver must go faster", "terminal speeds of two masses")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let faster = terminal([90.0, 0.7, 0.18]) > terminal([60.0, 0.7, 0.18]);
                Finding::new(stated.pick(faster, !faster), "the terminal speed is as the root of the mass")
            })
            .second_route(IN_STEPS, |stated| {
                let faster = terminal_in_steps([90.0, 0.7, 0.18]) > terminal_in_steps([60.0, 0.7, 0.18]);
                Finding::new(stated.pick(faster, !faster), "two skydivers moved in steps of time")
            })
            .interpreted_as("Both have the same area and the same drag coefficient")
            .but_not("a heavier skydiver goes as fast or slower"),
        net_force(),
        law("line 123", "drag.weight-is-drag", "m g = F_D", "weight at the terminal speed", &TERMINAL),
        law("line 125", "drag.weight-law", r"m g = \frac{1}{2} C \rho A v_T^2", "weight and terminal speed", &TERMINAL),
        law("line 127", "drag.terminal-law", r"v_T = \sqrt{\frac{2 m g}{\rho C A}}", "terminal speed", &TERMINAL),
    ]
}

/// The chain of forces: its sides are equal at any speed, and vanish at the terminal speed.
fn net_force() -> Claim {
    let holds = |tex: &str, [falling, terminal]: [&[Moment]; 2]| {
        let (moving, _) = tex.rsplit_once('=')?;
        Some(
            reader::holds(moving, falling, |ends, curve| gauss(ends, curve))?
                && reader::holds(tex, terminal, |ends, curve| gauss(ends, curve))?,
        )
    };
    at("line 121")
        .equation("drag.net-force", r"F_{\text{net}} = m g - F_D = m a = 0", "forces at the terminal speed")
        .evaluated(ENERGY, move |tex| Finding::of_reading(holds(tex, [&AIR_FALL.first, &TERMINAL.first])))
        .read(IN_STEPS, move |tex| holds(tex, [&AIR_FALL.second, &TERMINAL.second]))
}

fn skydivers() -> Vec<Claim> {
    vec![
        at("line 129")
            .value("drag.headfirst", "98", "m/s", "speed of a skydiver of 75 kg, head first")
            .first_route(Evidence::CLOSED_FORM, || terminal(HEADFIRST))
            .second_route(IN_STEPS, || terminal_in_steps(HEADFIRST)),
        at("line 129")
            .statement("drag.headfirst-road", "350 km/h", "speed in kilometres per hour, head first")
            .first_route(UNITS, |stated| {
                let speed = stated.pick(3.6, 3.7) * terminal(HEADFIRST);
                Finding::new(rounds(stated, &[(speed, 2)]), format!("the speed is {speed:.1} km/h"))
            })
            .second_route(IN_STEPS, |stated| {
                let speed = terminal_in_steps(HEADFIRST) * 3600.0 / stated.pick(1000.0, 1100.0);
                Finding::new(rounds(stated, &[(speed, 2)]), format!("the way of an hour is {speed:.1} km"))
            })
            .interpreted_as("The zero at the end does not count, since the data have two digits")
            .but_not("360 km/h"),
        at("line 130").value("drag.spread-speed", "200", "km/h", "speed in kilometres per hour of the same skydiver, spread out").missing(
            "The area that he then shows is not given. With the area and the drag coefficient of the example that follows it would be \
             150 km/h",
        ),
        at("line 130")
            .statement("drag.least-area", "In the headfirst position, area and drag are least", "drag of two positions")
            .first_route(ENERGY, |stated| {
                let less = force_by_energy([0.70, AIR, 0.18, 50.0]) < force_by_energy([1.0, AIR, 0.70, 50.0]);
                Finding::new(stated.pick(less, !less), "the air that a skydiver meets at the same speed")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                // Area times drag coefficient from the printed speeds.
                let area = |mass: f64, speed: f64| mass / speed / speed;
                let less = area(75.0, printed("drag.headfirst")) < area(85.0, printed("drag.spread-eagle"));
                Finding::new(stated.pick(less, !less), "the printed terminal speeds of both positions")
            })
            .interpreted_as("The drag is that at the same speed, since at the terminal speed it is always the weight")
            .but_not("head first, area and drag are greatest"),
        at("line 130")
            .statement("drag.larger-area", "The terminal velocity falls as the area grows", "terminal speed and area")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let slower = terminal([75.0, 0.7, 0.36]) < terminal([75.0, 0.7, 0.18]);
                Finding::new(stated.pick(slower, !slower), "the area is under the fraction line")
            })
            .second_route(IN_STEPS, |stated| {
                let slower = terminal_in_steps([75.0, 0.7, 0.5]) < terminal_in_steps([75.0, 0.7, 0.18]);
                Finding::new(stated.pick(slower, !slower), "two skydivers moved in steps of time")
            })
            .but_not("the terminal velocity grows as the area grows"),
        at("line 130")
            .statement("drag.parachute", "With the parachute open it is much smaller", "terminal speed below a parachute")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let much = terminal([75.0, 1.0, 25.0]) < stated.pick(0.5, 0.01) * terminal([75.0, 1.0, 0.70]);
                Finding::new(much, "a parachute of 25 m² against the area of the example")
            })
            .second_route(IN_STEPS, |stated| {
                let much = terminal_in_steps([75.0, 1.0, 25.0]) < stated.pick(0.5, 0.01) * terminal_in_steps([75.0, 1.0, 0.70]);
                Finding::new(much, "a skydiver moved in steps of time, with and without a parachute of 25 m²")
            })
            .interpreted_as("Much smaller is less than half, and a parachute has some 25 m²")
            .but_not("it is less than a hundredth"),
    ]
}

fn example() -> Vec<Claim> {
    let at_rest = "forces of the example";
    vec![
        law("line 134", "drag.strategy-net", r"F_{\text{net}} = 0", "net force at the terminal speed", &TERMINAL),
        law("line 134", "drag.strategy", r"m g = \frac{1}{2} C \rho A v^2", at_rest, &TERMINAL),
        at("line 137")
            .value("drag.spread-eagle", "44", "m/s", "speed of a skydiver of 85 kg, spread out")
            .first_route(Evidence::CLOSED_FORM, || terminal(FLAT))
            .second_route(IN_STEPS, || terminal_in_steps(FLAT)),
        at("line 139")
            .statement("drag.consistent", "This agrees with the earlier value", "speeds of two skydivers")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let ratio = (75.0 / 85.0 * (1.0 * 0.70) / (0.70 * 0.18_f64)).sqrt();
                let printed = printed("drag.headfirst") / printed("drag.spread-eagle");
                Finding::new((printed / ratio - 1.0).abs() < stated.pick(0.02, 1e-9), "the ratio of the two printed speeds")
            })
            .second_route(IN_STEPS, |stated| {
                let ratio = terminal_in_steps(HEADFIRST) / terminal_in_steps(FLAT);
                let printed = printed("drag.headfirst") / printed("drag.spread-eagle");
                Finding::new((printed / ratio - 1.0).abs() < stated.pick(0.02, 1e-9), "both skydivers moved in steps of time")
            })
            .interpreted_as("The earlier value is that of the skydiver of 75 kg, and both follow from one law to their two digits")
            .but_not("the two printed values agree to nine digits"),
        at("line 139")
            .statement("drag.posture", "The 75-kg skydiver went feet first, at 98 m/s", "posture of the first skydiver")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let [mass, _, speed] = stated.numbers()[..] else { return Finding::new(false, "there are no three numbers") };
                let fits = rounds_to(terminal([mass, 0.70, 0.18]), speed);
                Finding::new(fits && stated.characters().contains("head first"), "lines 128 and 130 have him head first")
            })
            .second_route(IN_STEPS, |stated| {
                let [mass, _, speed] = stated.numbers()[..] else { return Finding::new(false, "there are no three numbers") };
                // The drag coefficient of the headfirst skydiver in the exercise of line 331, from the printed answer.
                let coefficient = 2.0 * 80.0 * GRAVITY / (AIR * 0.140 * printed("drag.head-speed").powi(2));
                let fits = rounds_to(terminal_in_steps([mass, coefficient, 0.18]), speed);
                let said = stated.characters().contains("head first");
                Finding::new(fits && said, "his speed belongs to the drag coefficient of the headfirst skydiver of line 331")
            })
            .corrected("The 75-kg skydiver went head first, at 98 m/s", POSTURE),
        at("line 139")
            .statement("drag.lighter", "He weighed less, but had less area and so less drag", "weight and drag of two skydivers")
            .first_route(ENERGY, |stated| {
                let less = force_by_energy([0.70, AIR, 0.18, 60.0]) < force_by_energy([1.0, AIR, 0.70, 60.0]);
                Finding::new(75.0 < 85.0 && stated.pick(less, !less), "the air that both meet at the same speed")
            })
            .second_route(BALANCE, |stated| {
                // At the terminal speeds the drags are the weights.
                let less = 75.0 * GRAVITY < 85.0 * GRAVITY;
                Finding::new(stated.pick(less, !less), "at the terminal speeds the drags are the weights")
            })
            .interpreted_as("The drag is that at the same speed; at the terminal speeds it is less, too, but because he weighs less")
            .but_not("he weighed less, and had more drag"),
        at("line 147")
            .value("drag.light-spread-eagle", "34", "m/s", "speed of a skydiver of 50 kg, spread out")
            .first_route(Evidence::CLOSED_FORM, || terminal(LIGHT))
            .second_route(IN_STEPS, || terminal_in_steps(LIGHT)),
    ]
}

/// Whether a number rounds to a whole one.
fn rounds_to(value: f64, whole: f64) -> bool {
    is_near(libm::round(value), whole)
}

fn sizes() -> Vec<Claim> {
    let person = [56.0, 1.0, 0.70];
    vec![
        at("line 151")
            .statement("drag.person-falls", "A person does not reach a terminal velocity", "fall of a person from a branch")
            .first_route(Evidence::CLOSED_FORM, move |stated| {
                let limit = terminal(person);
                let part = (-libm::expm1(-2.0 * GRAVITY * 5.0 / limit / limit)).sqrt();
                Finding::new(part < stated.pick(0.9, 0.1), format!("the person strikes the ground at {part:.2} of it"))
            })
            .second_route(IN_STEPS, move |stated| {
                let [mass, coefficient, area] = person;
                let fall = |time| line(0.0, time, |speed| GRAVITY - force_by_parcels([coefficient, AIR, area, speed]) / mass);
                let time = halved([0.5, 3.0], |time| fall(time)[1] < 5.0);
                let part = fall(time)[0] / terminal_in_steps(person);
                Finding::new(part < stated.pick(0.9, 0.1), format!("moved in steps of time, the person gets to {part:.2} of it"))
            })
            .interpreted_as("The person has the mass of the exercise of line 342 and the area of the spread-out skydiver")
            .but_not("a person gets to less than a tenth of it"),
        at("line 151").statement("drag.squirrel-falls", "The squirrel does", "fall of a squirrel from a branch").missing(
            "Neither the size of this small squirrel nor what counts as reaching is said. The squirrel of line 342 strikes the ground at \
             0.80 of its terminal speed",
        ),
        at("line 153")
            .statement("drag.tenth", "Each way by ten: weight a thousandth, surface a hundredth", "weight and surface of a smaller animal")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let [ways, weight, surface] = stated.numbers()[..] else { return Finding::new(false, "there are no three numbers") };
                let holds = is_near(weight, ways.powi(3)) && is_near(surface, stated.pick(ways.powi(2), ways));
                Finding::new(holds, "three factors for a weight, two for a surface")
            })
            .second_route(Evidence::VECTORS, |stated| {
                let [ways, weight, surface] = stated.numbers()[..] else { return Finding::new(false, "there are no three numbers") };
                let [a, b, c] = [7.0, 5.0, 3.0];
                let skin = |a: f64, b: f64, c: f64| 2.0 * (a * b + b * c + c * a);
                let (small, part) = ([a, b, c].map(|side: f64| side / ways), [1.0 / weight, 1.0 / surface]);
                let volume = is_near(small[0] * small[1] * small[2], a * b * c * part[0]);
                let area = is_near(skin(small[0], small[1], small[2]), skin(a, b, c) * part[1]);
                Finding::new(volume && stated.pick(area, !area), "a box with all its edges shortened")
            })
            .but_not("the surface is reduced as the length"),
        at("line 153")
            .statement("drag.relatively", "The resistance is relatively ten times greater", "drag over weight of a smaller animal")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let times = (1.0 / 100.0) / stated.pick(1.0 / 1000.0, 1.0 / 10_000.0);
                Finding::new(is_near(stated.number(), times), "a hundredth over a thousandth")
            })
            .second_route(ENERGY, |stated| {
                let relative = |length: f64| force_by_energy([1.0, AIR, length * length, 5.0]) / (length * length * length);
                let times = relative(0.1) / relative(stated.pick(1.0, 10.0));
                Finding::new(is_near(stated.number(), times), "the air that both animals meet at the same speed, over their weights")
            })
            .interpreted_as("Both move at the same speed")
            .but_not("the resistance is relatively a hundred times greater"),
    ]
}

/// Density and viscosity of water.
const WATER: [f64; 2] = [1000.0, 1.0e-3];

fn stokes() -> Vec<Claim> {
    vec![
        at("line 154")
            .statement(
                "drag.dense",
                "no square law if the object is very small, is very slow, or is in a denser medium than air",
                "where the square law of drag ends",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // The diameter of the ball is 0.1 m, and its speed 1 m/s.
                let reynolds = WATER[0] * 1.0 * 0.1 / WATER[1];
                let by_itself = stated.characters().contains("or is in a denser medium");
                Finding::new(!by_itself || reynolds < 1.0, "for a ball of 10 cm at 1 m/s in water, inertia counts 100,000 times as much as viscosity")
            })
            .second_route(IN_STEPS, |stated| {
                let [density, viscosity] = WATER;
                let slow = 1.5 * viscosity * simpson([0.0, PI], |angle| 2.0 * PI * 0.05 * libm::sin(angle));
                let fast = force_by_parcels([printed("drag.table-sphere"), density, PI * 0.05 * 0.05, 1.0]);
                let by_itself = stated.characters().contains("or is in a denser medium");
                Finding::new(!by_itself || slow > fast, "the ball's drag by the table's coefficient is 1900 times that of creeping flow")
            })
            .interpreted_as("Each of the three conditions is enough by itself, as the word or says")
            .corrected("no square law if the object is so small and slow that viscosity decides", DENSE),
        at("line 154")
            .statement("drag.linear", "Then the drag is just as the velocity", "drag of small slow objects")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let times = 6.0 * PI * 3.0 / (6.0 * PI);
                Finding::new(is_near(times, stated.pick(3.0, 9.0)), "by the law of Stokes")
            })
            .second_route(IN_STEPS, |stated| {
                let force = |speed: f64| simpson([0.0, PI], |angle| 1.5 * speed * 2.0 * PI * libm::sin(angle));
                Finding::new((force(3.0) / force(1.0) - stated.pick(3.0, 9.0)).abs() < 1e-9, "three times the speed, over the rings of a sphere")
            })
            .but_not("then the drag is as the square of the velocity"),
        law("line 158", "drag.stokes", r"F_s = 6 \pi r \eta v", "drag of a small sphere", &SPHERE),
        at("line 161")
            .statement("drag.only-constant", "Many small objects move only at a constant speed", "time in which a bacterium is at its terminal speed")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // Mass over drag factor: a radius of a micrometre, as dense as in line 375.
                let radius: f64 = 1e-6;
                let time = 2.0 * radius * radius * 1100.0 / (9.0 * WATER[1]);
                Finding::new(time < stated.pick(1e-5, 1e-9), format!("its time constant is {:.2} millionths of a second", time * 1e6))
            })
            .second_route(IN_STEPS, |stated| {
                let radius: f64 = 1e-6;
                let mass = 1100.0 * 4.0 / 3.0 * PI * radius * radius * radius;
                let gain = |speed: f64| GRAVITY * 0.1 - 6.0 * PI * WATER[1] * radius * speed / mass;
                let reached = line(0.0, stated.pick(1e-5, 1e-9), gain)[0] / line(0.0, 1e-4, gain)[0];
                Finding::new(reached > 0.99, "a bacterium moved in steps of time")
            })
            .interpreted_as("The speed is constant after a hundred thousandth of a second")
            .but_not("a thousand millionth of a second is enough"),
        at("line 161").value("drag.bacterium-speed", "2", "μm/s", "speed in micrometres per second of a bacterium").missing(
            "It is not said how dense the bacterium is and whether its size of 1 μm is the radius or the diameter. By the law of Stokes in \
             water, with the density of line 375, all readings are from 0.05 μm/s to 2.4 μm/s",
        ),
    ]
}

fn lake() -> Vec<Claim> {
    vec![
        at("line 162")
            .statement("drag.sediment", "Sediment can sink faster", "speeds of sediment and of bacteria")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let faster = 5.0 > printed("drag.bacterium-speed");
                Finding::new(stated.pick(faster, !faster), "the two printed speeds")
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                // Under water, the weight is as the difference of densities: quartz, and a bacterium.
                let speed = |density: f64| 2.0 / 9.0 * (density - WATER[0]) * GRAVITY * 1e-12 / WATER[1];
                let faster = speed(2650.0) > speed(1100.0);
                Finding::new(stated.pick(faster, !faster), "a grain of quartz of the same size, by the law of Stokes")
            })
            .but_not("sediment sinks more slowly"),
        at("line 162")
            .statement("drag.days", "It can take days to reach the bottom", "time of sinking in a lake")
            .first_route(UNITS, |stated| {
                let days = 10.0 / 5e-6 / 86_400.0;
                Finding::new(days > stated.pick(2.0, 200.0), format!("{days:.0} days for 10 m"))
            })
            .second_route(IN_STEPS, |stated| {
                let sunk = line(5e-6, stated.pick(2.0, 200.0) * 24.0 * 60.0 * 60.0, |_| 0.0)[1];
                Finding::new(sunk < 10.0, format!("in this time it sinks by {sunk:.2} m"))
            })
            .interpreted_as("The lake is 10 m deep, and days are more than two")
            .but_not("it takes more than two hundred days"),
        at("line 163")
            .statement("drag.streamlined", "A streamlined shape has less drag", "drag of a streamlined shape")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let less = printed("drag.table-airfoil") < printed("drag.table-sphere");
                Finding::new(stated.pick(less, !less), "an airfoil and a sphere in the table")
            })
            .second_route(IN_STEPS, |stated| {
                let drag = |id| force_by_parcels([printed(id), AIR, 0.1, 10.0]);
                let less = drag("drag.table-airfoil") < drag("drag.table-plate");
                Finding::new(
                    stated.pick(less, !less),
                    "the push of an airfoil and of a plate on the air that they meet",
                )
            })
            .but_not("a streamlined shape has more drag"),
    ]
}
