//! The demonstration: a vibration with damping, and the name of its first derivative.

use super::program::as_formula;
use super::*;
use crate::meyer::letters;
use crate::meyer::reading::{self, By, Letters, Moment, decide};
use crate::meyer::slips::{LOST_DOTS, ONE_AS_L};
use geneva_mimic::{SolverParameters, integrate};

const TEXT: Locator = at("Appendix B, after the lines of the example");

pub(super) fn claims() -> Vec<Claim> {
    [equations(), lines()].concat()
}

fn equations() -> Vec<Claim> {
    vec![
        dots(
            ("meyer.app-b.example", "Appendix B, 1st display"),
            "the example: a mass on a spring with damping",
            r"m\dot{x} + c\dot{x} + kx = 0",
            r"m\ddot{x} + c\dot{x} + kx = 0",
        ),
        dots(
            ("meyer.app-b.example.solved", "Appendix B, 2nd display"),
            "the example solved for its highest derivative",
            r"\dot{x} = -(c\dot{x} + kx)/m",
            r"\ddot{x} = -(c\dot{x} + kx)/m",
        ),
    ]
}

fn lines() -> Vec<Claim> {
    vec![
        line(
            ("meyer.app-b.example.second", at("Appendix B, 3rd display")),
            "the second derivative from the first derivative and the position",
            ["2DX = -(C*LDX + K*X)/M", "2DX = -(C*1DX + K*X)/M"],
        ),
        line(
            ("meyer.app-b.example.first", at("Appendix B, 4th display")),
            "the first derivative is the integral of the second",
            ["LDX = INT(2DX, A)", "1DX = INT(2DX, A)"],
        ),
        line(
            ("meyer.app-b.example.place", at("Appendix B, 5th display")),
            "the position is the integral of the first derivative",
            ["X = INT(LDX, B)", "X = INT(1DX, B)"],
        ),
        first_derivative(
            ("meyer.app-b.example.names", TEXT),
            "names of the first and the second derivative",
            ["LDX and 2DX", "1DX and 2DX"],
        ),
        TEXT.statement(
            "meyer.app-b.example.initial",
            "A and B are the initial",
            "A and B are the values of the first derivative and of the position at the start",
        )
        .first_route(crate::evidence::RUNGE_KUTTA, |stated| {
            let [end, found] = [vibration(1.0)["x"], integrated(stated.pick(["x'", "x"], ["x", "x'"]))];
            Finding::new(
                (found - end).abs() < 1e-5,
                format!("integrated from these two, the position is {found:.5}, and it should be {end:.5}"),
            )
        })
        .second_route(Evidence::CLOSED_FORM, |stated| {
            let [speed, place] = stated.pick(["x'", "x"], ["x", "x'"]);
            let holds = ["1DX = INT(2DX, A)", "X = INT(1DX, B)"].map(|line| vibrates_from([speed, place], line));
            Finding::new(
                holds == [Some(true); 2],
                "we read the lines that integrate and evaluated them for a vibration in closed form",
            )
        })
        .but_not("the two are swapped"),
        at("Appendix B, paragraph on the steps")
            .statement(
                "meyer.app-b.first-acceleration",
                "calculate the initial value of 2DX",
                "the second derivative at the start comes from A and B, the starting values of the first derivative \
                 and of the position",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| first_acceleration(stated, vibration(0.0)["x''"]))
            .second_route(Evidence::LIMIT_CASE, |stated| {
                // How the first derivative changes about the start.
                const STEP: f64 = 1e-3;
                let [before, after] = [-STEP, STEP].map(|time| vibration(time)["x'"]);
                first_acceleration(stated, (after - before) / (2.0 * STEP))
            })
            .but_not("it comes from the position alone"),
        first_derivative(
            ("meyer.app-b.method.name", at("Appendix B, paragraph on the steps")),
            "name of the first derivative",
            ["LDX", "1DX"],
        ),
    ]
}

/// Whether the example's line for the second derivative, put right, gives this number from A and B.
fn first_acceleration(stated: Stated, right: f64) -> Finding {
    let start = vibration(0.0);
    let speed = stated.pick(start["x'"], 0.0);
    let letters = [("M", start["m"]), ("C", start["c"]), ("K", start["k"]), ("1DX", speed), ("X", start["x"])];
    let line = MEYER.lookup("meyer.app-b.example.second").right_characters();
    let formula = as_formula(line.split_once('=').map_or("", |(_, formula)| formula));
    let found = reading::value(&formula, &reading::by_name(letters));
    Finding::new(
        (found - right).abs() < 1e-4,
        format!("the line gives {found:.4}, and the vibration begins with {right:.4}"),
    )
}

/// The place after one unit of time, integrated from what the letters A and B stand for.
fn integrated([speed, place]: [&str; 2]) -> f64 {
    let start = vibration(0.0);
    let mut system = |_: f64, state: &Vector2<f64>| {
        Vector2::new(state[1], -(start["c"] * state[1] + start["k"] * state[0]) / start["m"])
    };
    let run =
        integrate(&mut system, Vector2::new(start[place], start[speed]), &SolverParameters::new(1.0, 1.0), |_| ());
    run.map_or(f64::NAN, |run| run.last.state[0])
}

/// An overdamped vibration in closed form: two exponentials.
fn vibration(time: f64) -> Letters {
    let (mass, rates) = (1.5, [-0.5, -3.0]);
    let sum = |order: i32| -> f64 {
        rates
            .iter()
            .zip([3.0, -1.0])
            .map(|(rate, part)| part * libm::pow(*rate, order.into()) * libm::exp(rate * time))
            .sum()
    };
    let (damping, stiffness) = (-mass * (rates[0] + rates[1]), mass * rates[0] * rates[1]);
    let motion = [("x", sum(0)), ("x'", sum(1)), ("x''", sum(2))];
    reading::by_name([("m", mass), ("c", damping), ("k", stiffness)].into_iter().chain(motion))
}

/// Whether a display holds for the vibration.
fn vibrates(tex: &str) -> Option<bool> {
    let moments: Vec<Moment> = (0..9).map(|k| Moment::of(vibration(f64::from(k) / 4.0))).collect();
    reading::holds(tex, &moments)
}

/// What a line of the program says as equations: one that holds throughout, and one for the start if the line integrates.
/// What INT integrates, and from what, are names between brackets. None if something would start from itself.
fn equations_of(line: &str) -> Option<(String, Option<String>)> {
    let integral = line.split_once("INT(").and_then(|(before, rest)| {
        let (of, from) = rest.trim().strip_suffix(')')?.split_once(',')?;
        Some([before.trim().strip_suffix('=')?, of, from].map(str::trim))
    });
    let Some([result, of, from]) = integral else { return Some((as_formula(line), None)) };
    if result == from {
        return None;
    }
    // d/dt of the result is what is integrated, and at the start the result is what it starts from.
    let [result, of, from] = [result, of, from].map(as_formula);
    Some((format!(r"\frac{{d}}{{dt}} {result} = {of}"), Some(format!("{result} = {from}"))))
}

/// Whether a line of the program holds for the vibration, if A and B are its letters for the start.
fn vibrates_from([speed, place]: [&str; 2], line: &str) -> Option<bool> {
    // What the copy has for 1DX is any number.
    const ODD: f64 = 2.25;
    let letters = |time: f64| -> Letters {
        let (now, start) = (vibration(time), vibration(0.0));
        let named = [("M", now["m"]), ("C", now["c"]), ("K", now["k"]), ("X", now["x"]), ("1DX", now["x'"])];
        let rest = [("2DX", now["x''"]), ("A", start[speed]), ("B", start[place]), ("LDX", ODD)];
        reading::by_name(named.into_iter().chain(rest))
    };
    let moving = |time: f64| {
        Moment::of(letters(time)).moving(|by, step| if by == By::Time { letters(time + step) } else { Letters::new() })
    };
    let moments: Vec<Moment> = (0..9).map(|k| moving(f64::from(k) / 4.0)).collect();
    let (throughout, start) = equations_of(line)?;
    let held = [Some(reading::holds(&throughout, &moments)), start.map(|start| reading::holds(&start, &moments[..1]))];
    held.into_iter().flatten().try_fold(true, |all, holds| Some(holds? && all))
}

/// A display whose second derivative has one dot for two.
fn dots(
    (id, locator): (&'static str, &'static str),
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    at(locator)
        .equation(id, printed, meaning)
        .proven_by(letters::vibration)
        .read(Evidence::CLOSED_FORM, vibrates)
        .corrected(corrected, LOST_DOTS)
}

/// A line of program that has LDX for 1DX, as printed and put right.
fn line((id, place): (&'static str, Locator), meaning: &'static str, [printed, corrected]: [&'static str; 2]) -> Claim {
    place
        .equation(id, printed, meaning)
        .decided(vibrates_exactly)
        .read(Evidence::CLOSED_FORM, |line| vibrates_from(["x'", "x"], line))
        .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || named_in_the_listing("1DX"))
        .corrected(corrected, ONE_AS_L)
}

/// Whether a line of the program is proven for any vibration, if A and B are its speed and its place at the start.
fn vibrates_exactly(line: &str) -> Finding {
    match equations_of(line) {
        Some((throughout, Some(start))) => {
            decide(&throughout, letters::vibration_of_program).and(decide(&start, letters::vibration_at_start))
        }
        Some((throughout, None)) => decide(&throughout, letters::vibration_of_program),
        None => Finding::of_reading(None),
    }
}

/// A place in the text where the copy has LDX.
pub(super) fn first_derivative(
    (id, place): (&'static str, Locator),
    meaning: &'static str,
    [printed, corrected]: [&'static str; 2],
) -> Claim {
    place
        .statement(id, printed, meaning)
        .first_route(Evidence::LIMIT_CASE, |stated| {
            let [name, above] = [stated.pick("1DX", "LDX"), "2DX"].map(order);
            let holds = name.is_some() && name == above.and_then(|above| above.checked_sub(1));
            Finding::new(
                holds,
                match name {
                    Some(order) => format!("the name begins with the order {order}, and the order of 2DX is one more"),
                    None => "the name does not begin with the order of a derivative".to_owned(),
                },
            )
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| named_in_the_listing(stated.pick("1DX", "LDX")))
        .corrected(corrected, ONE_AS_L)
}

/// Whether the listing calls the driver's speed so.
fn named_in_the_listing(name: &str) -> Finding {
    let listed =
        MEYER.printed_text("meyer.listing.angle").trim_start_matches("INT(").split(',').next().unwrap_or_default();
    Finding::new(listed == name, format!("the listing integrates {listed} to the driver's angle"))
}

/// The order of the derivative that a name of the program stands for.
fn order(name: &str) -> Option<u32> {
    name.strip_suffix("DX")?.parse().ok()
}
