//! Appendix D: the acceleration at the start.

use super::instants::{display, slip, statement};
use super::reading::{Letters, value};
use super::*;
use geneva_dynamics::derivation::{Form, StartAtEntry, StartingAcceleration, StartingEquation, StartingLine};
use geneva_dynamics::{Coefficients, Pose, Sign, Slots};

const LETTERS: &str = "Appendix D, line after the 1st equation";
const SIGN: &str = "Appendix D, lines after the 2nd equation";

pub fn claims() -> Vec<Claim> {
    [given(), equations()].concat()
}

fn given() -> Vec<Claim> {
    vec![
        statement(
            "meyer.app-d.from-rest",
            "Appendix D, 1st display",
            "the driver starts from rest",
            r"\dot{\theta}_0 = 0",
            (OtherPlaceInSource, || {
                Finding::new(numbers("meyer.app-b.from-rest") == [0], "Appendix B has it after the program")
            }),
            (ExactIdentity, || prove(&StartAtEntry).into()),
        ),
        statement(
            "meyer.app-d.angles",
            "Appendix D, 2nd display",
            "driver's angle at the start",
            r"\theta_0 = -30^\circ, -45^\circ, -60^\circ",
            (LimitCase, || {
                let printed = numbers("meyer.app-d.angles");
                let same = Escapement::all()
                    .iter()
                    .zip(printed.iter().skip(1))
                    .all(|(at, angle)| agrees(180.0 / f64::from(at.pins()), f64::from(*angle)));
                Finding::new(same && printed.len() == 4, "180° over the number of pins, for six, four and three")
            }),
            (Vectors, || {
                let printed = numbers("meyer.app-d.angles");
                let still = Escapement::all()
                    .iter()
                    .zip(printed.iter().skip(1))
                    .all(|(at, angle)| vanishes(Seen::new(at, -f64::from(*angle).to_radians()).turning()));
                Finding::new(still, "the pin moves along its slot at these angles")
            }),
        ),
        Claim::statement(
            WORK,
            "meyer.app-d.order",
            "Appendix D, line after the 2nd display",
            "numbers of pins, in the order of the angles",
            "three, four, or six pins",
            Check::corrected_equation(
                (LimitCase, || in_the_order_of_the_angles([3, 4, 6])),
                || in_the_order_of_the_angles([6, 4, 3]),
                (OtherPlaceInSource, || {
                    let angle = |pins: &str| numbers(&format!("meyer.app-a.{pins}-slots.theta")).last().copied();
                    let given = ["three", "four", "six"].map(angle);
                    let here: Vec<_> = numbers("meyer.app-d.angles").into_iter().skip(1).take(3).map(Some).collect();
                    Finding::new(given[..] == here[..], "Appendix A has 30°, 45° and 60° for three, four and six slots")
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "six, four, or three pins",
            slip: Slip {
                id: "",
                reason: "The angle is 180° over the number of pins: 30° belongs to six pins and \
                    60° to three. The numbers are those of the slots.",
                witness: "Appendix A gives the angles by the number of slots.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
    ]
}

fn equations() -> Vec<Claim> {
    vec![
        starting(
            "meyer.app-d.at-rest",
            "Appendix D, 1st equation",
            "Eq. (1-19) at rest",
            r"A\ddot{\theta} + |D\dot{\theta}| = E",
            [|| proven(StartingLine::Bars, Form::Printed), || proven(StartingLine::Bars, Form::Corrected)],
            || at_the_start("meyer.app-d.at-rest"),
            r"A\ddot{\theta} + |D\ddot{\theta}| = E",
        ),
        statement(
            "meyer.app-d.letters",
            LETTERS,
            "V is D at the start; in the program it is the size of D. Both are zero, \
                    because a pin enters where a cos θ = 1",
            "V be the value of D",
            (ExactIdentity, || prove(&StartAtEntry).into()),
            (Vectors, || exactly(|at| is_zero(&at.entering.across), "where the pin moves along its slot, D is zero")),
        ),
        starting(
            "meyer.app-d.with-letters",
            "Appendix D, 2nd equation",
            "the same with the letters of the start",
            r"R\ddot{\theta} + |V\dot{\theta}| = E",
            [
                || proven(StartingLine::StartingLetters, Form::Printed),
                || proven(StartingLine::StartingLetters, Form::Corrected),
            ],
            || at_the_start("meyer.app-d.with-letters"),
            r"R\ddot{\theta} + |V\ddot{\theta}| = E",
        ),
        statement(
            "meyer.app-d.forwards",
            SIGN,
            "the driver starts in the direction of the torque",
            "must always be positive",
            (ClosedForm, || {
                let holds = poses().all(|c| c.acceleration(0.0).is_ok_and(|found| found.value > 0.0));
                Finding::new(holds, "from rest the acceleration is positive at every angle of the engagement")
            }),
            (LimitCase, || {
                // Going back, both terms on the left would be less than E: A θ'' + |D θ''| = (A − |D|) θ'' < 0 there.
                Finding::new(
                    poses().all(|c| c.a > c.d.abs() && c.e > 0.0),
                    "going back, the left side would be negative",
                )
            }),
        ),
        starting(
            "meyer.app-d.outside",
            "Appendix D, 3rd equation",
            "the same with the acceleration outside the bars",
            r"R\ddot{\theta} + |V|\dot{\theta} = E",
            [|| proven(StartingLine::Outside, Form::Printed), || proven(StartingLine::Outside, Form::Corrected)],
            || at_the_start("meyer.app-d.outside"),
            r"R\ddot{\theta} + |V|\ddot{\theta} = E",
        ),
        display(
            "meyer.app-d.acceleration",
            "Appendix D, 4th equation",
            "the acceleration at the start; with V = 0 it is K over the driver's inertia",
            r"\ddot{\theta}_0 = \frac{E}{R + |V|}",
            || all_proven(&Sign::BOTH.map(|sign| StartingAcceleration { sign })),
            || {
                let read = claim("meyer.app-d.acceleration").and_then(|claim| claim.printed.split_once('='));
                let holds = read
                    .is_some_and(|(_, right)| rests().iter().all(|rest| agrees(value(right, rest), rest["theta''"])));
                Finding::new(holds, "the printed characters, read and evaluated from rest")
            },
        ),
        statement(
            "meyer.app-d.always-positive",
            "Appendix D, last sentence",
            "R is positive, so that the first acceleration is in the direction of the torque",
            "in the direction of the torque K",
            (ClosedForm, || Finding::new(poses().all(|c| c.a > 0.0), "a ratio of inertias and a square")),
            (ExactIdentity, || prove(&StartAtEntry).into()),
        ),
    ]
}

/// A display that has one dot for two.
fn starting(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    proofs: [fn() -> Finding; 2],
    read: fn() -> Finding,
    corrected: &'static str,
) -> Claim {
    slip(
        id,
        locator,
        meaning,
        printed,
        proofs,
        read,
        Erratum {
            corrected,
            slip: Slip {
                id: "",
                reason: "D multiplies the acceleration in Eq. (1-19); one of its two dots is \
                    lost. The speed is zero here, and the term with it.",
                witness: "The last equation of the appendix, read and evaluated, follows from the \
                    corrected one only.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        },
    )
}

fn proven(line: StartingLine, dots: Form) -> Finding {
    all_proven(&Sign::BOTH.map(|sign| StartingEquation { line, dots, sign }))
}

/// Coefficients all over the engagements, for some friction.
fn poses() -> impl Iterator<Item = Coefficients<f64>> {
    Slots::ALL.into_iter().flat_map(|slots| {
        (-10..=10).map(move |k| {
            let angle = slots.engagement_half_angle() * f64::from(k) / 10.0;
            let pose = Pose::new(&slots.ratio(), &Turn::from_radians(angle));
            Coefficients::of_pose(&pose, &0.75, &0.25, &1.5)
        })
    })
}

/// The letters of the appendix at rest. The start itself has D = 0, which would hide every slip: so all angles.
fn rests() -> Vec<Letters> {
    poses()
        .map(|c| {
            let gain = c.acceleration(0.0).map_or(f64::NAN, |found| found.value);
            [("A", c.a), ("R", c.a), ("D", c.d), ("V", c.d), ("E", c.e), ("theta'", 0.0), ("theta''", gain)]
                .map(|(name, value)| (name.to_owned(), value))
                .into()
        })
        .collect()
}

/// Whether the corrected characters hold from rest at all angles, and the printed ones do not.
fn at_the_start(id: &str) -> Finding {
    let holds = |formula: &str| {
        formula
            .split_once('=')
            .is_some_and(|(left, right)| rests().iter().all(|rest| vanishes(value(left, rest) - value(right, rest))))
    };
    let found = claim(id).and_then(|claim| Some((claim.printed, claim.erratum.as_ref()?.corrected)));
    Finding::new(
        found.is_some_and(|(printed, corrected)| !holds(printed) && holds(corrected)),
        "the corrected characters, read and evaluated from rest at 63 poses, hold; the printed ones do not",
    )
}

/// Whether these numbers of pins go with the printed angles.
fn in_the_order_of_the_angles(pins: [u32; 3]) -> Finding {
    let angles = numbers("meyer.app-d.angles");
    let fit = pins.iter().zip(angles.iter().skip(1)).all(|(pins, angle)| pins * angle == 180);
    Finding::new(fit && angles.len() == 4, "180° over the number of pins")
}
