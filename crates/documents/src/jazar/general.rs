//! The wheel of any number of stations: its sizes and the equations (5.30) to (5.32).

use super::letters::{ANY, PARTS, SIZES};
use super::*;
use geneva_evidence::equal_to;
use geneva_evidence::tex::{by_name, value};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::{Expression, Identity, prove};

const PIN_RADIUS: &str = "We take the pin radius to be r, the radius of the circle on which the pin's centre moves, \
                          because the handout gives no radius of the pin itself.";
const RATIOS: Locator = at("Paragraph before Eq. (5.30)");

pub(super) fn claims() -> Vec<Claim> {
    [sizes(), equations()].concat()
}

fn sizes() -> Vec<Claim> {
    vec![
        RATIOS
            .equation("jazar.centre-distance-ratio", r"1/\sin \alpha", "centre distance over crank radius")
            .rewritten_and_proven(SIZES, equal_to("l/r"))
            .interpreted_as(PIN_RADIUS),
        RATIOS
            .statement(
                "jazar.wheel-radius-ratio",
                r"\text{outside diameter … the latter is } 1/\tan \alpha",
                "the second ratio, which is the outside diameter of the wheel over the pin radius",
            )
            .first_route(Evidence::VECTORS, |stated| {
                for_all_stations(
                    |wheel| {
                        let (radius, alpha) = (entry(wheel).norm(), wheel.half_pitch_angle());
                        let (Some(radii), Some(said)) = (radii(stated), ratio(stated, alpha)) else { return false };
                        agrees(f64::from(radii) * radius, said)
                    },
                    "this form puts the rim where the pin enters",
                )
            })
            .second_route(Evidence::EXACT_IDENTITY, |stated| match radii(stated) {
                Some(radii) => prove(&RimByPythagoras { above: stated.count(), radii: i64::from(radii) }).into(),
                None => Finding::new(false, "neither a radius nor a diameter"),
            })
            .interpreted_as(PIN_RADIUS)
            .corrected(
                r"\text{outside radius … the latter is } 1/\tan \alpha",
                Slip {
                    id: "",
                    reason: "The only other length that the sentence names is the pin radius. If α is half the angle \
                             between two slots, 1/tan α is the ratio of the wheel's outside radius to the pin radius. \
                             The ratio of the outside diameter to the pin radius is twice as great. If by the pin \
                             radius the sentence meant the diameter of the pin's circle, the ratio would be right, but \
                             the handout never mentions that diameter.",
                    witness: "The handout itself says that the outer radius of the four-station wheel is r, the pin \
                              radius. For this wheel α is 45°, and 1/tan 45° is one.",
                    origin: Origin::Misprint,
                    consequence: Consequence::Wording,
                    changes: "",
                },
            ),
        at("Sentence before Eq. (5.30)")
            .equation("jazar.alpha-radians", r"\alpha = \pi/N", "α in radians")
            .in_letters(PARTS),
        at("Sentence before Eq. (5.30)")
            .statement(
                "jazar.generalises",
                "become",
                "Eqs. (5.27) to (5.29) are Eqs. (5.30) to (5.32) in the case of four stations",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let general: [fn(&Wheel, f64) -> f64; 3] = [
                    |w, t| steady_display("jazar.eq-5.30", w, t),
                    |w, t| steady_display("jazar.eq-5.31", w, t),
                    |w, t| steady_display("jazar.eq-5.32", w, t),
                ];
                four_from_general(&general, stated)
            })
            .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                // What Eq. (5.30) gives with its derivatives, by dual numbers.
                let derivatives: [fn(&Wheel, f64) -> f64; 3] =
                    [|w, t| by_duals(w, t)[0], |w, t| by_duals(w, t)[1], |w, t| by_duals(w, t)[2]];
                four_from_general(&derivatives, stated)
            })
            .but_not("Eq. (5.29) as it is in the copy, without its minus sign, is a case of Eq. (5.32)")
            .interpreted_as("We take Eq. (5.29) with the minus sign that it has lost in the copy."),
    ]
}

fn equations() -> Vec<Claim> {
    vec![
        at("Eq. (5.30)")
            .equation(
                "jazar.eq-5.30",
                concat!(
                    r"\phi = \tan^{-1} \left(\frac{\sin \alpha \sin \theta}{1 - \sin \alpha \cos \theta} ",
                    r"\right)"
                ),
                "wheel angle, N stations",
            )
            .in_letters(ANY),
        at("Eq. (5.31)")
            .equation(
                "jazar.eq-5.31",
                concat!(
                    r"\dot{\phi} = \dot{\theta} \sin \alpha ",
                    r"\left(\frac{\cos \theta - \sin \alpha}{1 + \sin^2 \alpha - 2 \sin \alpha \cos ",
                    r"\theta} \right)",
                ),
                "angular velocity of the wheel, N stations",
            )
            .in_letters(ANY),
        at("Eq. (5.32)")
            .equation(
                "jazar.eq-5.32",
                concat!(
                    r"\ddot{\phi} = -\dot{\theta}^2 ",
                    r"\frac{\sin \alpha \cos^2 \alpha \sin \theta}{(1 + \sin^2 \alpha - 2 \sin \alpha ",
                    r"\cos \theta)^2}",
                ),
                "angular acceleration of the wheel, N stations",
            )
            .in_letters(ANY),
    ]
}

/// What is left out between the length and its ratio, which the sentence before gives another one.
const BETWEEN: &str = " … the latter is } ";

/// How many outside radii the length is of which the characters give the ratio.
fn radii(stated: Stated) -> Option<u32> {
    match stated.characters().split_once(BETWEEN)?.0 {
        r"\text{outside radius" => Some(1),
        r"\text{outside diameter" => Some(2),
        _ => None,
    }
}

/// The ratio that the characters give, for this α.
fn ratio(stated: Stated, alpha: f64) -> Option<f64> {
    let (_, formula) = stated.characters().split_once(BETWEEN)?;
    Some(value(formula, &by_name([("alpha", alpha)])))
}

/// Pythagoras at entry: the square of so many outside radii, in crank radii, is that of `above` over tan α.
/// Variable: tangent of α/2.
struct RimByPythagoras {
    /// What stands above the tangent.
    above: u32,
    /// How many outside radii.
    radii: i64,
}

impl Identity<1> for RimByPythagoras {
    fn difference(&self, [half]: [Expression; 1]) -> Expression {
        let alpha = Turn::from_half_tangent(&half);
        let distance = 1 / alpha.sin;
        let tangent = alpha.sin / alpha.cos;
        self.radii * self.radii * (distance * distance - 1) - i64::from(self.above * self.above) / (tangent * tangent)
    }
}

/// Whether general formulas give Eqs. (5.27) to (5.29) for four stations, the last with its sign or as printed.
fn four_from_general(general: &[fn(&Wheel, f64) -> f64; 3], stated: Stated) -> Finding {
    let sign = stated.pick(-1.0, 1.0);
    let four = [("jazar.eq-5.27", 1.0), ("jazar.eq-5.28", 1.0), ("jazar.eq-5.29", sign)];
    about_four(|wheel| {
        let apart = |at: usize, t| general[at](wheel, t) - four[at].1 * steady_display(four[at].0, wheel, t);
        let agree = |at: usize| thirds(wheel).all(|t| vanishes(apart(at, t)));
        let names = ["(5.27)", "(5.28)", "(5.29)"];
        let differing: Vec<_> = (0..3).filter(|at| !agree(*at)).map(|at| names[at]).collect();
        let how = if differing.is_empty() {
            "all three equations agree".into()
        } else {
            format!("{} differs", differing.join(", "))
        };
        Finding::new(differing.is_empty(), how)
    })
}

/// Some crank angles of the engagement, none of them zero.
fn thirds(wheel: &Wheel) -> impl Iterator<Item = f64> {
    let end = wheel.engagement_half_angle();
    [-1.0, -2.0 / 3.0, -1.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].into_iter().map(move |part| part * end)
}
