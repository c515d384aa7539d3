//! Why a denominator is never zero, and what that does not say: the text between Eqs. (1-18) and (1-19).

use super::instants::{display, statement};
use super::*;
use geneva_dynamics::derivation::{AtOne, BoundAsSquare, OffTheSingularity, SingularAngle};
use geneva_dynamics::equation_proofs::{SignDecider, Slope};
use geneva_dynamics::existence::{critical_friction, least_margin};
use geneva_dynamics::{Coefficients, Pose, Sign, Slots};

const END: &str = "Paragraph before the substitutions of Eq. (1-19)";
/// Driver's inertia over the follower's, for the question how much friction there can be: like discs.
const INERTIA_RATIO: f64 = 1.0;

pub fn claims() -> Vec<Claim> {
    [quantity(), bounds(), slots()].concat()
}

fn quantity() -> Vec<Claim> {
    vec![
        statement(
            "meyer.singularity.quantity",
            "Display after Eq. (1-18)",
            "the quantity whose powers Eq. (1-18) divides by: the square of the \
                    pin's distance from the follower's axis, over r²",
            r"(1 + a^2 - 2a \cos \theta)",
            (ClosedForm, || instants::reads_as("meyer.singularity.quantity", "", "square")),
            (OtherPlaceInSource, || {
                let id = ["meyer.singularity.quantity", "meyer.eq-1-18.first-line", "meyer.eq-1-18.second-line"];
                let [quantity, lines @ ..] = id.map(|id| claim(id).map_or("", |claim| claim.printed));
                Finding::new(lines.iter().all(|line| line.contains(quantity)), "both lines of Eq. (1-18) have it")
            }),
        ),
        display(
            "meyer.singularity.assumed",
            "1st display of θ_∞",
            "condition for an angle at which it would be zero",
            r"1 + a^2 - 2a \cos \theta_\infty = 0",
            || prove(&SingularAngle).into(),
            || at_the_only_ratio("meyer.singularity.assumed"),
        ),
        display(
            "meyer.singularity.angle",
            "2nd display of θ_∞",
            "that angle",
            r"\theta_\infty = \cos^{-1} \left(\frac{1 + a^2}{2a} \right)",
            || prove(&SingularAngle).into(),
            || at_the_only_ratio("meyer.singularity.angle"),
        ),
    ]
}

fn bounds() -> Vec<Claim> {
    vec![
        bound(
            "meyer.singularity.bound",
            "1st inequality",
            "a cosine is at most one",
            r"\left(\frac{1 + a^2}{2a} \right) \leq 1",
            || only_at_one("meyer.singularity.bound"),
        ),
        bound("meyer.singularity.cleared", "2nd inequality", "the same times 2a", r"1 + a^2 \leq 2a", || {
            only_at_one("meyer.singularity.cleared")
        }),
        bound("meyer.singularity.collected", "3rd inequality", "the same on one side", r"a^2 - 2a + 1 \leq 0", || {
            only_at_one("meyer.singularity.collected")
        }),
        bound("meyer.singularity.square", "4th inequality", "the same as a square", r"(a - 1)^2 \leq 0", || {
            only_at_one("meyer.singularity.square")
        }),
        statement(
            "meyer.singularity.only-one",
            "Line after the inequalities",
            "only the ratio one allows it",
            "a = 1",
            (ExactIdentity, || prove(&AtOne).into()),
            (ExactIdentity, || prove(&OffTheSingularity).into()),
        ),
    ]
}

fn slots() -> Vec<Claim> {
    vec![
        display(
            "meyer.singularity.ratio",
            "1st display before the substitutions of Eq. (1-19)",
            "the ratio one by Eq. (1-2)",
            r"a = \frac{1}{\sin(\pi/n)} = 1",
            || prove(&AtOne).into(),
            || slots_of("meyer.singularity.ratio"),
        ),
        display(
            "meyer.singularity.sine",
            "2nd display before the substitutions of Eq. (1-19)",
            "the same for the sine",
            r"\sin\left(\frac{\pi}{n}\right) = 1",
            || prove(&AtOne).into(),
            || slots_of("meyer.singularity.sine"),
        ),
        statement(
            "meyer.singularity.two-slots",
            END,
            "only two slots would give it",
            "n=2",
            (ClosedForm, || slots_of("meyer.singularity.sine")),
            (Vectors, || {
                let ratios = (3..=60).filter_map(|slots| Wheel::new(slots).ok()).map(|w| w.centre_distance_ratio());
                Finding::new(
                    ratios.into_iter().all(|ratio| ratio > 1.0),
                    "the axes of 3 to 60 slots are farther apart than r",
                )
            }),
        ),
        conclusion(),
    ]
}

fn conclusion() -> Claim {
    Claim::statement(
        WORK,
        "meyer.singularity.conclusion",
        END,
        "the equation of motion has no singularities",
        "contains no singularities",
        Check::corrected_equation(
            (ClosedForm, || {
                let [_, beyond] = solutions_about_the_limit();
                Finding::new(
                    beyond == [1, 1],
                    format!(
                        "with a little more than the critical friction there are {} to {} solutions",
                        beyond[0], beyond[1]
                    ),
                )
            }),
            || {
                // A − |D| in closed form at the limit, and why its sign decides.
                let at_the_limit = Slots::ALL.iter().all(|slots| {
                    critical_friction(*slots, INERTIA_RATIO).is_ok_and(|critical| {
                        [(0.99, true), (1.01, false)].iter().all(|(part, sound)| {
                            least_margin(*slots, INERTIA_RATIO, part * critical.friction)
                                .is_ok_and(|least| (least.margin > 0.0) == *sound)
                        })
                    })
                });
                let slopes = all_proven(&Sign::BOTH.map(Slope));
                let signs = all_proven(&Sign::BOTH.map(SignDecider));
                let holds = at_the_limit && slopes.holds && signs.holds;
                Finding::new(holds, format!("the left side grows with the acceleration by A ± D: {}", slopes.how))
            },
            (LimitCase, || {
                let [below, beyond] = solutions_about_the_limit();
                Finding::new(
                    below == [1, 1] && beyond != [1, 1],
                    "counted at 400 angles: one solution everywhere below the critical \
                            friction, none or two beyond it",
                )
            }),
        ),
    )
    .expecting(Verdict::Corrected)
    .with_erratum(Erratum {
        corrected: "contains no zero denominators; it has one solution at every angle if \
                and only if A > |D| there",
        slip: Slip {
            id: "",
            reason: "What is shown is that nothing is divided by zero. But the factor of the \
                driver's acceleration is A + D or A − D, and with enough friction one \
                of them is zero somewhere: then there is no acceleration, or more than \
                one. The lighter the driver beside the follower, the less friction this \
                takes.",
            witness: "Solutions of Eq. (1-19) were counted on either side of the limit.",
            origin: Origin::Concept,
            consequence: Consequence::Conclusion,
            changes: "",
        },
    })
}

/// One of the four inequalities; all are one statement.
fn bound(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    read: fn() -> Finding,
) -> Claim {
    display(id, locator, meaning, printed, || prove(&BoundAsSquare).into(), read)
}

/// Whether the two sides of a display about θ_∞ agree for the one ratio for which there is such an angle, 0.
fn at_the_only_ratio(id: &str) -> Finding {
    let letters = [("a", 1.0), ("theta_infty", 0.0)].map(|(name, value)| (name.to_owned(), value)).into();
    let printed = claim(id).map_or("", |claim| claim.printed);
    let sides: Vec<f64> = printed.split('=').map(|side| reading::value(side, &letters)).collect();
    Finding::new(
        sides.len() == 2 && vanishes(sides[0] - sides[1]),
        "the printed characters, read and evaluated for the one ratio that has such an angle, a = 1",
    )
}

/// Whether an inequality, read and evaluated, holds for the ratio one and for no other of many.
fn only_at_one(id: &str) -> Finding {
    let printed = claim(id).map_or("", |claim| claim.printed);
    let holds = |ratio: f64| {
        let letters = [("a".to_owned(), ratio)].into();
        printed
            .split_once(r"\leq")
            .is_some_and(|(left, right)| reading::value(left, &letters) <= reading::value(right, &letters))
    };
    let found: Vec<f64> = (1..=80).map(|k| f64::from(k) / 16.0).filter(|ratio| holds(*ratio)).collect();
    Finding::new(found == [1.0], "read and evaluated for 80 ratios from 1/16 to 5, it holds for 1 only")
}

/// Whether a display about the number of slots, read and evaluated, holds for two slots and for no other of many.
fn slots_of(id: &str) -> Finding {
    let printed = claim(id).map_or("", |claim| claim.printed);
    let holds = |slots: u32| {
        let letters = [("a", 1.0), ("n", f64::from(slots))].map(|(name, value)| (name.to_owned(), value)).into();
        let sides: Vec<f64> = printed.split('=').map(|side| reading::value(side, &letters)).collect();
        sides.windows(2).all(|pair| agrees(pair[0], pair[1]))
    };
    let found: Vec<u32> = (1..=100).filter(|slots| holds(*slots)).collect();
    Finding::new(found == [2], "read and evaluated for 1 to 100 slots, it holds for 2 only")
}

/// The least and the greatest number of solutions at rest while a pin is engaged: just below the friction at which A
/// reaches |D|, and just above. The least A − |D| over the angles gives that friction.
fn solutions_about_the_limit() -> [[usize; 2]; 2] {
    let angles = || (0..400).map(|k| Slots::Four.engagement_half_angle() * f64::from(k) / 400.0);
    let at = |angle: f64, friction: f64| {
        let pose = Pose::new(&Slots::Four.ratio(), &Turn::from_radians(angle));
        Coefficients::of_pose(&pose, &INERTIA_RATIO, &friction, &1.0)
    };
    // D is proportional to the friction.
    let limit = angles().map(|angle| at(angle, 1.0)).map(|c| c.a / c.d.abs()).fold(f64::INFINITY, f64::min);
    [0.99, 1.01].map(|part| {
        let counts: Vec<usize> = angles().map(|angle| count(&at(angle, part * limit))).collect();
        [counts.iter().copied().min().unwrap_or(0), counts.iter().copied().max().unwrap_or(0)]
    })
}

/// How many accelerations from rest obey the equation with the sign that their own friction has.
fn count(c: &Coefficients<f64>) -> usize {
    let obeys = |sign: f64| {
        let gain = c.e / (c.a + sign * c.d);
        sign * c.d * gain > 0.0
    };
    if c.d == 0.0 { 1 } else { [1.0, -1.0].iter().filter(|sign| obeys(**sign)).count() }
}
