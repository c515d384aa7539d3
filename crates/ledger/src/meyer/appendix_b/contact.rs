//! The equation solved for its highest derivative, and how the program knows the sign of the friction.

use super::program::{DELAY_PARTS, all_as_letters, all_by_coefficients};
use super::*;
use crate::meyer::runs;
use geneva_dynamics::derivation::{BarsOpened, BarsReprinted, Form, Opening};
use geneva_dynamics::equation_proofs::SignDecider;
use geneva_dynamics::{Inertias, Parameters, Sign, Slots};

const PROGRAM: &str = "Appendix B, paragraphs before the program";

pub fn claims() -> Vec<Claim> {
    [solved(), lines(), described()].concat()
}

fn solved() -> Vec<Claim> {
    vec![
        slip(
            "meyer.app-b.eq-1-19",
            "Appendix B, Eq. (1-19) repeated",
            "the equation of motion",
            r"A\ddot{\theta} + B\dot{\theta}^2 + C\theta^2 + D\dot{\theta} = E",
            [|| reprinted(Form::Printed), || reprinted(Form::Corrected)],
            || reads("meyer.app-b.eq-1-19"),
            miscopied(
                r"A\ddot{\theta} + B\dot{\theta}^2 + |C\dot{\theta}^2 + D\ddot{\theta}| = E",
                "Two dots and both bars are lost. Eq. (1-19) has them where it is \
                        derived, and without the bars there would be nothing to eliminate.",
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.app-b.cannot-be-solved",
            "Appendix B, line after Eq. (1-19) repeated",
            "with its bars the equation has no solution for the acceleration in closed form",
            "cannot be solved",
            Check::corrected_equation(
                (ClosedForm, || {
                    let found = equal(
                        |letter| (solution(letter), letter("theta''")),
                        "the sign worked out beforehand, and the acceleration with it",
                    );
                    Finding::new(!found.holds, found.how)
                }),
                || all_proven(&Sign::BOTH.map(SignDecider)),
                (Vectors, || {
                    equal(
                        |letter| (decider(letter).signum(), letter("friction").signum()),
                        "the sign worked out beforehand and that of the friction",
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: r"\text{can be solved: } S \text{ is the sign of } A C \dot{\theta}^2 + D (E - B \dot{\theta}^2)", slip: Slip {
 id: "",
reason: "On either side of the kink the equation is linear in the acceleration. As long as A > |D| \
                    it has one solution, and F (A + S D) is the quantity above whichever sign S has: so the sign \
                    is known before the acceleration is. The detour over an old value of the acceleration is not \
                    needed.",
witness: "The sign so found is that of the friction of the moving mechanism, and the acceleration is \
                    its own.",
origin: Origin::Concept,
consequence: Consequence::Conclusion,
changes: "",
} }),
    ]
}

fn lines() -> Vec<Claim> {
    vec![
        display(
            "meyer.app-b.f",
            "Appendix B, display of F",
            "what stands between the bars",
            r"F = (C\dot{\theta}^2 + D\ddot{\theta})",
            || opened(Opening::WithSign),
            || reads("meyer.app-b.f"),
        ),
        display(
            "meyer.app-b.s",
            "Appendix B, display of S",
            "its sign; where F is zero either value will do",
            r"\begin{aligned} S &= +1 && \text{if } F > 0 \\ S &= -1 && \text{if } F < 0 \end{aligned}",
            || opened(Opening::WithSign),
            || {
                // The printed values, for the printed conditions.
                let values = numbers("meyer.app-b.s");
                let size = f64::from(values.first().copied().unwrap_or(0));
                let found = equal(|letter| (letter("S") * letter("F"), letter("F").abs()), "S F and the size of F");
                Finding::new(found.holds && size == 1.0 && values == [1, 0, 1, 0], found.how)
            },
        ),
        display(
            "meyer.app-b.with-sign",
            "Appendix B, 1st display after S",
            "the equation with S for the bars",
            r"A\ddot{\theta} + B\dot{\theta}^2 + S(C\dot{\theta}^2 + D\ddot{\theta}) = E",
            || opened(Opening::WithSign),
            || reads("meyer.app-b.with-sign"),
        ),
        display(
            "meyer.app-b.expanded",
            "Appendix B, 2nd display after S",
            "the same multiplied out",
            r"A\ddot{\theta} + B\dot{\theta}^2 + SC\dot{\theta}^2 + SD\ddot{\theta} = E",
            || opened(Opening::Expanded),
            || reads("meyer.app-b.expanded"),
        ),
        display(
            "meyer.app-b.collected",
            "Appendix B, 3rd display after S",
            "the same collected",
            r"\ddot{\theta}(A+SD) + \dot{\theta}^2(B+SC) = E",
            || opened(Opening::Collected),
            || reads("meyer.app-b.collected"),
        ),
        display(
            "meyer.app-b.solved",
            "Appendix B, 4th display after S",
            "the acceleration",
            r"\ddot{\theta} = \frac{E - (B+SC)\dot{\theta}^2}{A+SD}",
            || opened(Opening::Solved),
            || reads("meyer.app-b.solved"),
        ),
    ]
}

fn described() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "meyer.app-b.first-seven-cards",
            PROGRAM,
            "seven control cards come first, and data cards at the end",
            "first seven cards",
            Check::Missing {
                reason: "The program in the copy begins with five comments and the parameters \
                        and ends without data. Control cards and data cards are either lost or \
                        were not printed",
            },
        )
        .expecting(Verdict::NotReproducible),
        statement(
            "meyer.app-b.letters",
            PROGRAM,
            "the program's letters G to L are the factors of Eq. (1-18), A to E those of Eq. (1-19)",
            "G,H,I,J, and L",
            (ClosedForm, all_by_coefficients),
            (Vectors, all_as_letters),
        ),
        Claim::statement(
            WORK,
            "meyer.app-b.simultaneous",
            PROGRAM,
            "the sign of the friction cannot be computed from the same instant's \
                    acceleration, because two equations would have to be solved together",
            "cannot solve simultaneous equations",
            Check::corrected_equation(
                (ClosedForm, || {
                    let found = equal(|letter| (solution(letter), letter("theta''")), "both equations solved together");
                    Finding::new(!found.holds, found.how)
                }),
                || all_proven(&Sign::BOTH.map(SignDecider)),
                (ClosedForm, || {
                    let sound = Inertias::new(1.0, 2.0).and_then(|both| Parameters::new(Slots::Four, both, 1.0, 0.25));
                    let solved = sound.is_ok_and(|sound| {
                        (-9..=9).all(|k| {
                            let angle = Slots::Four.engagement_half_angle() * f64::from(k) / 9.0;
                            sound.acceleration(angle, 1.0).is_ok_and(|found| {
                                let c = sound.coefficients(angle);
                                let left = c.a * found.value + c.b + (c.c + c.d * found.value).abs();
                                vanishes(left - c.e)
                            })
                        })
                    });
                    Finding::new(
                        solved,
                        "the explicit solution, put into the equation with its bars, satisfies \
                            it",
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "the two equations can be solved beforehand",
            slip: Slip {
                id: "",
                reason: "They are linear for either sign, and which sign is right can be told \
                    from A, B, C, D, E and the speed. Taking the sign from an old \
                    acceleration brings in a small delay where the friction changes its \
                    sign.",
                witness: "The explicit solution satisfies the equation with its bars.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
        statement(
            "meyer.app-b.delay",
            PROGRAM,
            "the old acceleration is that of a tenth of the print interval before",
            "t-DT/10",
            (OtherPlaceInSource, || {
                let same = DELAY_PARTS == 10 && numbers("meyer.app-b.delay") == [DELAY_PARTS];
                Finding::new(same, "the program's delay is DT/10 too")
            }),
            (LimitCase, || {
                // The sign is then late by the delay at most: small against the time of an engagement.
                let delay = runs::delay();
                Finding::new(delay < 1e-4, format!("it is late by {:.0} millionths of a second", delay * 1e6))
            }),
        ),
        statement(
            "meyer.app-b.small-time",
            PROGRAM,
            "SMT is true until the time zero and false after it",
            "SMT",
            (LimitCase, || {
                // FSW picks one of three values by the sign of the first. One order of the three fits S and SMT.
                let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
                let (signs, truths) = ([-1.0, 1.0, 1.0], [true, true, false]);
                let fits = |order: &&[usize; 3]| {
                    let [negative, zero, positive] = **order;
                    signs[negative] < 0.0
                        && signs[positive] > 0.0
                        && truths[negative]
                        && truths[zero]
                        && !truths[positive]
                };
                let found: Vec<_> = orders.iter().filter(fits).collect();
                Finding::new(
                    found == [&[0, 1, 2]],
                    "values for negative, zero, positive is the one order that fits S and \
                        SMT",
                )
            }),
            (OtherPlaceInSource, || {
                let shut = claim("meyer.app-b.large-time").is_some_and(|claim| claim.printed.starts_with("LGT"));
                Finding::new(shut, "LGT, its opposite, shuts off the equation of motion at the start")
            }),
        ),
    ]
}

/// A C θ'² + D (E − B θ'²) from the letters of an instant.
fn decider(letter: &Value) -> f64 {
    let square = letter("theta'") * letter("theta'");
    letter("A") * letter("C") * square + letter("D") * (letter("E") - letter("B") * square)
}

/// The acceleration with that sign, from the letters of an instant.
fn solution(letter: &Value) -> f64 {
    let (sign, square) = (decider(letter).signum(), letter("theta'") * letter("theta'"));
    (letter("E") - (letter("B") + sign * letter("C")) * square) / (letter("A") + sign * letter("D"))
}

fn opened(line: Opening) -> Finding {
    all_proven(&Sign::BOTH.map(|sign| BarsOpened { line, sign }))
}

fn reprinted(form: Form) -> Finding {
    all_proven(&Sign::BOTH.map(|contact| BarsReprinted { dots: form, bars: form, contact }))
}
