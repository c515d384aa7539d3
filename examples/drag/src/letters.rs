//! What the letters of the section's equations stand for, for each subject from two places that share no formula.

use crate::kinds::{BALANCE, ENERGY, IN_STEPS};
use crate::steps::{gauss, halved, limiting, line, moved};
use geneva_evidence::Evidence;
use geneva_evidence::tex::{Letters, Moment, Value, by_name};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// States in which the letters of some equations have values, from two places.
pub(crate) struct States {
    /// The kinds of evidence of the two places.
    pub(crate) kinds: [&'static Evidence; 2],
    /// The states from the first place.
    pub(crate) first: LazyLock<Vec<Moment>>,
    /// The states from the second place.
    pub(crate) second: LazyLock<Vec<Moment>>,
}

impl States {
    const fn new(kinds: [&'static Evidence; 2], first: fn() -> Vec<Moment>, second: fn() -> Vec<Moment>) -> Self {
        Self { kinds, first: LazyLock::new(first), second: LazyLock::new(second) }
    }
}

fn state<const N: usize>(values: [(&str, f64); N]) -> Moment {
    Moment::default().with(values)
}

/// The force on a body from the energy of the fluid that it meets: a share of it, the drag coefficient, is carried away.
pub(crate) fn force_by_energy([coefficient, density, area, speed]: [f64; 4]) -> f64 {
    let mass_in_a_second = density * area * speed;
    coefficient * (mass_in_a_second * (speed * speed / 2.0)) / speed
}

/// The force on a body from the parcels of fluid that it meets one after the other in a second: each gets a share of the body's speed,
/// half of the drag coefficient.
pub(crate) fn force_by_parcels([coefficient, density, area, speed]: [f64; 4]) -> f64 {
    const PARCELS: u32 = 50;
    let parcel = density * area * (speed / f64::from(PARCELS));
    (0..PARCELS).map(|_| parcel * (coefficient / 2.0 * speed)).sum()
}

/// The drag law, at a speed.
pub(crate) static DRAG: States = States::new(
    [ENERGY, IN_STEPS],
    || {
        let at = |[coefficient, density, area, speed]: [f64; 4]| {
            let force = force_by_energy([coefficient, density, area, speed]);
            let factor = force / speed / speed;
            let values = [("F_D", force), ("C", coefficient), (r"\rho", density), ("A", area), ("v", speed)];
            state(values).with([("b", factor), ("v^n", speed * speed)])
        };
        vec![at([0.45, 1.21, 0.7, 13.0]), at([1.12, 998.0, 0.031, 2.3])]
    },
    || {
        let at = |[coefficient, density, area, speed]: [f64; 4]| {
            let force = |speed| force_by_parcels([coefficient, density, area, speed]);
            // From twice the speed, at which the force is greater by three times the factor and the square of the speed.
            let factor = (force(2.0 * speed) - force(speed)) / (3.0 * speed.powi(2));
            let values = [("F_D", force(speed)), ("C", coefficient), (r"\rho", density), ("A", area), ("v", speed)];
            state(values).with([("b", factor), ("v^n", speed.powi(2))])
        };
        vec![at([0.7, 1.3, 0.18, 41.0]), at([0.28, 870.0, 2.2, 3.7])]
    },
);

/// A body at its terminal speed in a fluid whose drag is as the square of the speed.
pub(crate) static TERMINAL: States = States::new(
    [ENERGY, IN_STEPS],
    || {
        let at = |[coefficient, density, area, speed, gravity]: [f64; 5]| {
            let force = force_by_energy([coefficient, density, area, speed]);
            // The weight does as much work in a second as the drag takes.
            terminal([coefficient, density, area, speed, gravity, force * speed / (gravity * speed), force])
        };
        vec![at([0.7, 1.21, 0.18, 98.0, 9.8]), at([1.1, 1.4, 0.55, 31.0, 8.7])]
    },
    || {
        let at = |[coefficient, density, area, mass, gravity]: [f64; 5]| {
            let force =
                |speed: f64| if speed > 0.0 { force_by_parcels([coefficient, density, area, speed]) } else { 0.0 };
            let speed = limiting(200.0, |speed| gravity - force(speed) / mass);
            terminal([coefficient, density, area, speed, gravity, mass, force(speed)])
        };
        // Light bodies: what must vanish is as small as the rounding of their weights.
        vec![at([1.0, 1.21, 0.0012, 0.0031, 9.8]), at([0.6, 1.1, 0.0023, 0.0040, 11.0])]
    },
);

fn terminal([coefficient, density, area, speed, gravity, mass, force]: [f64; 7]) -> Moment {
    let values = [("C", coefficient), (r"\rho", density), ("A", area), ("g", gravity), ("m", mass)];
    state(values).with([("v_T", speed), ("v", speed), ("F_D", force), ("a", 0.0), (r"F_{\text{net}}", 0.0)])
}

/// A body that falls from rest in air, before it has its terminal speed.
pub(crate) static AIR_FALL: States = States::new(
    [ENERGY, IN_STEPS],
    || {
        let at = |[coefficient, density, area, mass, time]: [f64; 5]| {
            let gravity = 9.8;
            let limit = (2.0 * mass * gravity / (coefficient * density * area)).sqrt();
            let speed = limit * libm::tanh(gravity * time / limit);
            // What the kinetic energy gains on a metre, after the way on which it has gained so much.
            let way = limit * limit / gravity * libm::log(libm::cosh(gravity * time / limit));
            let gain = mass * gravity * libm::exp(-2.0 * gravity * way / (limit * limit));
            let acceleration = gravity / libm::cosh(gravity * time / limit).powi(2);
            air_fall([mass, gravity, force_by_energy([coefficient, density, area, speed]), acceleration, gain])
        };
        vec![at([0.7, 1.21, 0.18, 75.0, 4.0]), at([1.1, 1.4, 0.55, 43.0, 2.0])]
    },
    || {
        let at = |[coefficient, density, area, mass, time]: [f64; 5]| {
            let gravity = 9.8;
            let force = |speed: f64| force_by_parcels([coefficient, density, area, speed]);
            let gain = |speed: f64| gravity - force(speed) / mass;
            let speed = line(0.0, time, gain)[0];
            // What is left of the weight, since at the terminal speed nothing is.
            let part = speed / limiting(200.0, gain);
            air_fall([mass, gravity, force(speed), gain(speed), mass * gravity * (1.0 - part) * (1.0 + part)])
        };
        vec![at([1.0, 1.21, 0.7, 85.0, 2.5]), at([0.6, 1.1, 1.3, 40.0, 1.0])]
    },
);

fn air_fall([mass, gravity, drag, acceleration, net]: [f64; 5]) -> Moment {
    state([("m", mass), ("g", gravity), ("F_D", drag), ("a", acceleration), (r"F_{\text{net}}", net)])
}

/// A body that falls from rest in a fluid whose drag is as the speed.
pub(crate) static FALL: States = States::new(
    [Evidence::CLOSED_FORM, IN_STEPS],
    || {
        let at = |given: [f64; 4]| {
            let [mass, gravity, factor, time] = given;
            let there = move |time: f64| {
                let left = libm::exp(-factor * time / mass);
                let limit = gravity / (factor / mass);
                [limit * (1.0 - left), limit * time - limit * (mass / factor) * (1.0 - left)]
            };
            falling(given, there(time), gravity / (factor / mass))
                .moving(move |_, later| fall_letters(there(time + later)))
        };
        vec![at([2.3, 9.8, 0.9, 1.7]), at([0.7, 8.1, 1.3, 0.45])]
    },
    || {
        let at = |given: [f64; 4]| {
            let [mass, gravity, factor, time] = given;
            let gain = move |speed: f64| gravity - factor * speed / mass;
            let there = move |time: f64| line(0.0, time, gain);
            let limit = limiting(60.0 * mass / factor, gain);
            falling(given, there(time), limit).moving(move |_, later| fall_letters(there(time + later)))
        };
        vec![at([1.9, 9.8, 1.4, 0.9]), at([3.1, 10.7, 0.8, 2.6])]
    },
);

fn fall_letters([speed, way]: [f64; 2]) -> Letters {
    by_name([("v", speed), ("y", way)])
}

fn falling([mass, gravity, factor, time]: [f64; 4], [speed, way]: [f64; 2], limit: f64) -> Moment {
    let step = 0.37;
    let gain = gravity - factor * speed / mass;
    let values = [("m", mass), ("g", gravity), ("b", factor), ("t", time), ("v", speed), ("y", way), ("v_T", limit)];
    state(values).with([("D_t", step), ("D_v", gain * step), ("D_y", speed * step), ("f_R", -(factor * speed))])
}

/// A boat whose motor has stopped, in water whose drag is as the speed; in the last state after ten times the mass over the factor.
pub(crate) static BOAT: States = States::new([Evidence::CLOSED_FORM, IN_STEPS], || boats(false), || boats(true));

/// The same boat, ten time constants after its motor has stopped.
pub(crate) static LATE_BOAT: States = States::new(
    [Evidence::CLOSED_FORM, IN_STEPS],
    || vec![boat([1.6, 0.8, 4.3, 20.0], false), boat([2.1, 0.7, 3.1, 30.0], false)],
    || vec![boat([1.6, 0.8, 4.3, 20.0], true), boat([2.1, 0.7, 3.1, 30.0], true)],
);

fn boats(in_steps: bool) -> Vec<Moment> {
    vec![boat([1.3, 0.6, 4.0, 1.9], in_steps), boat([2.7, 1.1, 2.2, 0.8], in_steps)]
}

fn boat([mass, factor, start, time]: [f64; 4], in_steps: bool) -> Moment {
    let gain = move |speed: f64| -factor * speed / mass;
    let there = move |time: f64| {
        if in_steps {
            return line(start, time, gain);
        }
        let left = libm::exp(-factor * time / mass);
        [start * left, start / (factor / mass) * (1.0 - left)]
    };
    // Where the body ends: what it had of momentum, over the factor, or the way after a long time.
    let limit = if in_steps { line(start, 60.0 * mass / factor, gain)[1] } else { mass * start / factor };
    let [speed, way] = there(time);
    let step = 0.29;
    let values = [("m", mass), ("b", factor), ("t", time), ("v", speed), ("x", way), ("v_0", start)];
    state(values)
        .with([(r"x_{\max}", limit), ("D_t", step), ("D_v", gain(speed) * step), ("D_x", speed * step)])
        .moving(move |_, later| {
            let [speed, way] = there(time + later);
            by_name([("v", speed), ("x", way)])
        })
}

/// The boat of the worked example, which loses three quarters of its speed in 10 s.
pub(crate) static SLOWED: States = States::new(
    [Evidence::CLOSED_FORM, IN_STEPS],
    || vec![slowed(libm::log(4.0) / 10.0)],
    || vec![slowed(halved([0.0, 1.0], |rate| line(4.0, 10.0, |speed| -rate * speed)[0] > 1.0))],
);

fn slowed(rate: f64) -> Moment {
    // In other units of time and length, which must come out of no equation.
    let [second, metre] = [1.3, 0.7];
    state([("b", rate * 1.7 / second), ("m", 1.7), (r"\text{s}", second), (r"\text{m}", metre)])
}

/// A sphere in a viscous fluid. In creeping flow each part of its surface is dragged along with the same force by area; it is the
/// pressure in front and behind, and the friction at the sides.
pub(crate) static SPHERE: States = States::new(
    [Evidence::CLOSED_FORM, IN_STEPS],
    || {
        let at = |[radius, viscosity, speed]: [f64; 3]| {
            let by_area = 1.5 * viscosity * speed / radius;
            sphere([radius, viscosity, speed, by_area * 4.0 * PI * radius * radius])
        };
        vec![at([0.7, 1.3, 2.1]), at([1.6, 0.4, 0.9])]
    },
    || {
        let at = |[radius, viscosity, speed]: [f64; 3]| {
            let size = 1.5 * viscosity * speed / radius;
            let ring = |angle: f64| {
                let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
                let along = size * cosine * cosine + size * sine * sine;
                along * 2.0 * PI * radius * sine * radius
            };
            sphere([radius, viscosity, speed, gauss([0.0, PI], ring)])
        };
        vec![at([1.1, 0.9, 1.7]), at([0.6, 2.2, 3.0])]
    },
);

fn sphere([radius, viscosity, speed, force]: [f64; 4]) -> Moment {
    state([("r", radius), ("η", viscosity), ("v", speed), ("F_s", force)])
}

/// A body on a circle, held there by one force; and the angle of a road on which the force of the road alone does that.
pub(crate) static CIRCLE: States = States::new(
    [Evidence::VECTORS, IN_STEPS],
    || {
        let at = |[mass, radius, angular_speed, gravity]: [f64; 4]| {
            // The velocity turns as the place does: how far the arrow of the velocity moves in a second.
            let speed = radius * angular_speed;
            let acceleration = speed * angular_speed;
            circle([
                mass,
                radius,
                angular_speed,
                gravity,
                speed,
                mass * acceleration,
                libm::atan2(acceleration, gravity),
            ])
        };
        vec![at([1.4, 2.3, 1.9, 9.8]), at([0.8, 5.1, 0.7, 8.3])]
    },
    || {
        let at = |[mass, radius, force, gravity]: [f64; 4]| {
            // The speed at which a body that is pulled to the middle with this force is after a while still on the circle.
            let after = |speed: f64| {
                let pull = |_, [x, y, u, w]: [f64; 4]| {
                    let by_distance = force / mass / libm::hypot(x, y);
                    [u, w, -x * by_distance, -y * by_distance]
                };
                let [x, y, ..] = moved([radius, 0.0, 0.0, speed], radius / speed, pull);
                libm::hypot(x, y)
            };
            let speed = halved([0.1, 50.0], |speed| after(speed) < radius);
            // Road and weight: the road's force is across the road, and its upright part bears the weight.
            let angle = halved([0.0, 1.5], |angle| mass * gravity * libm::sin(angle) / libm::cos(angle) < force);
            circle([mass, radius, speed / radius, gravity, speed, force, angle])
        };
        vec![at([1.7, 1.2, 3.4, 9.8]), at([0.9, 3.3, 4.5, 10.4])]
    },
);

fn circle([mass, radius, angular_speed, gravity, speed, force, angle]: [f64; 7]) -> Moment {
    let values = [("m", mass), ("r", radius), (r"\omega", angular_speed), ("g", gravity), ("v", speed)];
    state(values).with([("F_c", force), (r"\theta", angle), ("a_c", force / mass), ("a_{c}", force / mass)])
}

/// Friction of a block: at rest, from no pull to the greatest that it bears; and sliding.
pub(crate) static FRICTION: States = States::new(
    [BALANCE, Evidence::VECTORS],
    || {
        // A pull on a level floor that grows.
        let at = |pull: f64| friction([pull, 0.6, 21.0, 0.45 * 21.0, 0.45]);
        [0.0, 4.0, 8.0, 12.6].map(at).into()
    },
    || {
        // A slope that grows steeper, up to the one on which the block begins to slide.
        let steepest = libm::atan(0.75);
        let at = |share: f64| {
            let angle = share * steepest;
            let (along, across) = (libm::sin(angle), libm::cos(angle));
            friction([13.0 * along, libm::tan(steepest), 13.0 * across, 0.4 * 13.0 * across, 0.4])
        };
        [0.0, 0.4, 0.8, 1.0].map(at).into()
    },
);

fn friction([at_rest, greatest, normal, sliding, kinetic]: [f64; 5]) -> Moment {
    state([("f_s", at_rest), (r"\mu_s", greatest), ("N", normal), ("f_k", sliding), (r"\mu_k", kinetic)])
}

/// Logarithms and exponentials.
pub(crate) static LOGARITHM: States = States::new(
    [Evidence::CLOSED_FORM, IN_STEPS],
    || vec![state([("A", 3.7), ("B", 1.9), ("x", libm::log1p(3.7 / 1.9 - 1.0))])],
    // The area under the hyperbola.
    || vec![state([("A", 2.9), ("B", 1.3), ("x", gauss([1.3, 2.9], |place| 1.0 / place))])],
);

/// A motion whose place is given by powers of the time, and a force that grows with the time.
pub(crate) static POWERS: States = States::new(
    [Evidence::CLOSED_FORM, IN_STEPS],
    || {
        let [mass, p, q, n, time] = [1.7_f64, 0.6, 1.1, 0.8, 1.4];
        let force = mass * (3.0 * 2.0 * p * time + 2.0 * q);
        let velocity = [p * time + n * time * time / 2.0, q * time * time / 2.0].map(|part| part / mass);
        let place = [p * time.powi(2) / 2.0 + n * time.powi(3) / 6.0, q * time.powi(3) / 6.0].map(|part| part / mass);
        vec![powers([mass, p, q, n, time, force], velocity, place)]
    },
    || {
        let [mass, p, q, n, time] = [0.9_f64, 1.3, 0.7, 1.9, 0.8];
        // The force on a body whose place is given: from three places, which for a cubic give the middle one's second rate.
        let place = |time: f64| p * time * time * time + q * time * time;
        let step = 0.25;
        let force = mass * (place(time + step) - 2.0 * place(time) + place(time - step)) / (step * step);
        let rate = |now: f64, [u, w, _, _]: [f64; 4]| [(p + n * now) / mass, q * now / mass, u, w];
        let [u, w, x, y] = moved([0.0; 4], time, rate);
        vec![powers([mass, p, q, n, time, force], [u, w], [x, y])]
    },
);

fn powers([mass, p, q, n, time, force]: [f64; 6], velocity: [f64; 2], place: [f64; 2]) -> Moment {
    let vector = |[x, y]: [f64; 2]| Value::Vector([x, y, 0.0]);
    state([("m", mass), ("p", p), ("q", q), ("n", n), ("t", time), ("F", force)]).with([
        (r"\vec{v}", vector(velocity)),
        (r"\vec{r}", vector(place)),
        (r"\vec{i}", vector([1.0, 0.0])),
        (r"\vec{j}", vector([0.0, 1.0])),
    ])
}

/// A body that is shot upwards, where gravity is less the farther it is from the middle of the Earth.
pub(crate) static SHOT: States = States::new(
    [ENERGY, IN_STEPS],
    || {
        let at = |[mass, gravity, ground, start, place]: [f64; 5]| {
            // The work of gravity is the area under its curve.
            let weight = |place: f64| mass * gravity * (ground / place) * (ground / place);
            let work = gauss([ground, place], weight);
            shot([mass, gravity, ground, start, place, weight(place), (start * start - 2.0 * work / mass).sqrt()])
        };
        vec![at([1.3, 9.8, 6.4, 13.0, 7.1]), at([0.7, 8.8, 5.0, 11.0, 5.8])]
    },
    || {
        let at = |[mass, gravity, ground, start, time]: [f64; 5]| {
            let pull = |place: f64| gravity / (place / ground).powi(2);
            let [place, speed] = moved([ground, start], time, |_, [place, speed]| [speed, -pull(place)]);
            shot([mass, gravity, ground, start, place, mass * pull(place), speed])
        };
        vec![at([1.9, 9.8, 6.4, 12.0, 0.1]), at([0.4, 7.9, 4.0, 10.0, 0.2])]
    },
);

fn shot([mass, gravity, ground, start, place, weight, speed]: [f64; 7]) -> Moment {
    let step = 0.31;
    let gain = -weight / mass;
    let values =
        [("m", mass), ("g", gravity), ("r_0", ground), ("v_0", start), ("r", place), ("w", weight), ("v", speed)];
    state(values).with([("a", gain), ("D_r", speed * step), ("D_v", gain * step)])
}

/// A motor boat whose thrust is constant: mass, thrust and drag of the problem.
pub(crate) static THRUST: States = States::new(
    [Evidence::CLOSED_FORM, IN_STEPS],
    || [40.0, 170.0].map(|time| state([("t", time), ("v", 40.0 / 2.0 * -libm::expm1(-2.0 / 200.0 * time))])).into(),
    || {
        let speed = |time| line(0.0, time, |speed| (40.0 - 2.0 * speed) / 200.0)[0];
        [25.0, 110.0].map(|time| state([("t", time), ("v", speed(time))])).into()
    },
);

/// Two blocks on a rough floor, pulled by a force.
pub(crate) static PULLED: States = States::new(
    [Evidence::CLOSED_FORM, BALANCE],
    || {
        // Both together, of 4 kg.
        let at = |[force, friction, gravity]: [f64; 3]| {
            pulled([force, friction, gravity, (force - friction * (4.0 * gravity)) / 4.0])
        };
        vec![at([30.0, 0.3, 9.8]), at([41.0, 0.2, 8.9])]
    },
    || {
        let at = |[force, friction, gravity]: [f64; 3]| {
            // The block of 1 kg and that of 3 kg, with the force of the string between.
            let rows = [[1.0, -1.0], [3.0, 1.0]];
            let right = [-friction * gravity, force - friction * 3.0 * gravity];
            pulled([force, friction, gravity, crate::steps::solved(rows, right)[0]])
        };
        vec![at([27.0, 0.25, 9.8]), at([36.0, 0.4, 10.3])]
    },
);

fn pulled([force, friction, gravity, acceleration]: [f64; 4]) -> Moment {
    state([("F", force), (r"\mu_k", friction), ("g", gravity), ("a", acceleration)])
}
