//! The demonstration: a vibration with damping, and the name of its first derivative.

use super::*;
use crate::meyer::reading::{Letters, value};
use geneva_dynamics::derivation::{Demonstration, Form};
use geneva_mimic::{Parameters, integrate};

const TEXT: &str = "Appendix B, after the lines of the example";

pub fn claims() -> Vec<Claim> {
    [equations(), lines()].concat()
}

fn equations() -> Vec<Claim> {
    vec![
        dots(
            "meyer.app-b.example",
            "Appendix B, 1st display",
            "the example: a mass on a spring with damping",
            r"m\dot{x} + c\dot{x} + kx = 0",
            || of_a_vibration("meyer.app-b.example"),
            miscopied(
                r"m\ddot{x} + c\dot{x} + kx = 0",
                "The first term needs two dots: the text looks for the derivative of the \
                    highest order, and the program computes the second.",
            ),
        ),
        dots(
            "meyer.app-b.example.solved",
            "Appendix B, 2nd display",
            "the example solved for its highest derivative",
            r"\dot{x} = -(c\dot{x} + kx)/m",
            || of_a_vibration("meyer.app-b.example.solved"),
            miscopied(
                r"\ddot{x} = -(c\dot{x} + kx)/m",
                "The left side needs two dots, as in the first line of program below it.",
            ),
        ),
    ]
}

fn lines() -> Vec<Claim> {
    vec![
        first_derivative(
            Kind::Equation,
            "meyer.app-b.example.second",
            "Appendix B, 3rd display",
            "the second derivative from the first and the place",
            r"2DX = -(C*LDX + K*X)/M",
            r"2DX = -(C*1DX + K*X)/M",
        ),
        first_derivative(
            Kind::Equation,
            "meyer.app-b.example.first",
            "Appendix B, 4th display",
            "the first derivative is the integral of the second",
            r"LDX = INT(2DX, A)",
            r"1DX = INT(2DX, A)",
        ),
        first_derivative(
            Kind::Equation,
            "meyer.app-b.example.place",
            "Appendix B, 5th display",
            "the place is the integral of the first derivative",
            r"X = INT(LDX, B)",
            r"X = INT(1DX, B)",
        ),
        first_derivative(
            Kind::Statement,
            "meyer.app-b.example.names",
            TEXT,
            "names of the first and the second derivative",
            "LDX and 2DX",
            "1DX and 2DX",
        ),
        statement(
            "meyer.app-b.example.initial",
            TEXT,
            "A and B are the values of the first derivative and of the place at the start",
            "A and B are the initial",
            (ClosedForm, || {
                let start = vibration(0.0);
                let found = integrated(start["x"], start["x'"]);
                let end = vibration(1.0);
                Finding::new((found - end["x"]).abs() < 1e-5, "integrated from these two, the closed form is met")
            }),
            (LimitCase, || {
                let start = vibration(0.0);
                let end = vibration(1.0)["x"];
                let exchanged = integrated(start["x'"], start["x"]);
                Finding::new((exchanged - end).abs() > 0.1, "with the two exchanged it is not")
            }),
        ),
        first_derivative(
            Kind::Statement,
            "meyer.app-b.method.name",
            "Appendix B, paragraph on the steps",
            "name of the first derivative",
            "LDX",
            "1DX",
        ),
    ]
}

/// The place after one unit of time, integrated.
fn integrated(place: f64, speed: f64) -> f64 {
    let letters = vibration(0.0);
    let mut system = |_: f64, state: &Vector2<f64>| {
        Vector2::new(state[1], -(letters["c"] * state[1] + letters["k"] * state[0]) / letters["m"])
    };
    let run = integrate(&mut system, Vector2::new(place, speed), &Parameters::new(1.0, 1.0), |_| ());
    run.map_or(f64::NAN, |run| run.last.state[0])
}

/// An overdamped vibration in closed form: two exponentials.
fn vibration(time: f64) -> Letters {
    let (mass, rates) = (1.5, [-0.5, -2.0]);
    let sum = |order: i32| -> f64 {
        rates
            .iter()
            .zip([3.0, -1.0])
            .map(|(rate, part)| part * libm::pow(*rate, order.into()) * libm::exp(rate * time))
            .sum()
    };
    let (damping, stiffness) = (-mass * (rates[0] + rates[1]), mass * rates[0] * rates[1]);
    [("m", mass), ("c", damping), ("k", stiffness), ("x", sum(0)), ("x'", sum(1)), ("x''", sum(2))]
        .map(|(name, value)| (name.to_owned(), value))
        .into()
}

/// Whether the corrected characters hold for the vibration, and the printed ones do not.
fn of_a_vibration(id: &str) -> Finding {
    let holds = |formula: &str| {
        formula.split_once('=').is_some_and(|(left, right)| {
            (0..9).all(|k| {
                let letters = vibration(f64::from(k) / 4.0);
                vanishes(value(left, &letters) - value(right, &letters))
            })
        })
    };
    let found = claim(id).and_then(|claim| Some((claim.printed, claim.erratum.as_ref()?.corrected)));
    Finding::new(
        found.is_some_and(|(printed, corrected)| !holds(printed) && holds(corrected)),
        "a vibration in closed form, put into the corrected characters and into the printed ones",
    )
}

/// A display whose first term has one dot for two.
fn dots(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    read: fn() -> Finding,
    erratum: Erratum,
) -> Claim {
    let proofs: [fn() -> Finding; 2] =
        [|| prove(&Demonstration(Form::Printed)).into(), || prove(&Demonstration(Form::Corrected)).into()];
    let witness = "A vibration in closed form satisfies the corrected equation and not the printed one.";
    slip(id, locator, meaning, printed, proofs, read, Erratum { slip: Slip { witness, ..erratum.slip }, ..erratum })
}

/// A place where the copy has LDX: a typewriter's one, read as an L.
pub fn first_derivative(
    kind: Kind,
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    let check = Check::corrected_equation(
        (LimitCase, || {
            Finding::new(order("LDX").is_some(), "the names of derivatives begin with their order, as 2DX does")
        }),
        || {
            let below = order("2DX").and_then(|order| order.checked_sub(1));
            Finding::new(order("1DX") == below, "the integral of 2DX has the order one less")
        },
        (OtherPlaceInSource, || {
            let named = claim("meyer.listing.speed").is_some_and(|claim| claim.printed == "1DX");
            Finding::new(named, "the program below calls the integral of 2DX so")
        }),
    );
    Claim { kind, ..Claim::statement(WORK, id, locator, meaning, printed, check) }
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected,
            slip: Slip {
                id: "",
                reason: "A typewriter's one has been read as the letter L.",
                witness: "The program has the name with a one.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        })
}

/// The order of the derivative that a name of the program stands for.
fn order(name: &str) -> Option<u32> {
    name.strip_suffix("DX")?.parse().ok()
}
