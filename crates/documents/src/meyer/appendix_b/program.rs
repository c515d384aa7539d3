//! What the lines of the program compute, beside the equation of motion and the mechanism by coordinates.

use super::*;
use crate::meyer::reading::{self, Letters};
use geneva_dynamics::{Coefficients, Pose, Sign};
use geneva_kinematics::Mechanism;
use geneva_mimic::language::{CardLayout, Deck, Problem};
use std::sync::OnceLock;

// What the lines say, in the letters of mathematics; the names are the program's.
pub(super) const G: &str = r"G = \frac{1}{\sin(\pi/N)}";
pub(super) const H: &str = r"H = G \cos X - 1";
pub(super) const I: &str = r"I = G \sin X";
pub(super) const J: &str = r"J = 1 - G^2";
pub(super) const L: &str = r"L = 1 + G^2 - 2 G \cos X";
pub(super) const A: &str = r"A = \frac{\text{IC}}{\text{IW}} + \frac{H^2}{L^2}";
pub(super) const B: &str = r"B = \frac{I J H}{L^3}";
pub(super) const C: &str = r"C = \frac{I^2 U J}{L^3}";
pub(super) const D: &str = r"D = \frac{I U H}{L^2}";
pub(super) const E: &str = r"E = \frac{K}{\text{IW}}";
pub(super) const F: &str = r"F = C (\text{1DX})^2 + D \text{OLD2DX}";
pub(super) const ACCELERATION: &str = r"\text{2DX} = \frac{E - (B + S C) (\text{1DX})^2}{A + S D}";
pub(super) const FOLLOWER_SPEED: &str = r"\text{PHIDOT} = \frac{H \text{1DX}}{L}";
pub(super) const P: &str = r"P = 1 + G^2 - 2 G \cos \text{X0}";
pub(super) const Q: &str = r"Q = G \cos \text{X0} - 1";
pub(super) const R: &str = r"R = \frac{\text{IC}}{\text{IW}} + \frac{Q^2}{P^2}";
pub(super) const V: &str = r"V = \left| \frac{U G Q \sin \text{X0}}{P^2} \right|";
pub(super) const START: &str = r"\text{2DX} = \frac{E}{R + V}";

/// What the program reads, beside the number of slots and the angle. Any will do.
const CARDS: [(&str, f64); 4] = [("U", 0.25), ("K", 1.5), ("IW", 2.0), ("IC", 1.25)];
/// Speed of the driver in the comparison with the equation of motion.
pub(super) const SPEED: f64 = 1.25;

/// The name that a line gives to what it computes, and the formula.
pub(super) fn named(line: &str) -> (String, &str) {
    let (name, formula) = line.split_once('=').unwrap_or_default();
    (name.trim().trim_start_matches(r"\text{").trim_end_matches('}').to_owned(), formula)
}

/// A formula of a card in the letters of mathematics: its names are words, its stars are left out, SIN, COS and ABS are
/// functions, and the rounded π is π, which is a claim of its own.
pub(super) fn as_formula(card: &str) -> String {
    let (mut formula, mut word) = (String::new(), String::new());
    // For each bracket that is open, whether it closes the bars of ABS.
    let (mut open, mut is_size) = (Vec::new(), false);
    for c in card.chars().chain([' ']) {
        if c.is_ascii_alphanumeric() {
            word.push(c);
            continue;
        }
        let is_name = word.contains(|c: char| c.is_ascii_alphabetic());
        match word.as_str() {
            "SIN" | "COS" => formula += &format!(r"\{}", word.to_lowercase()),
            "ABS" => is_size = true,
            _ if is_name && word.len() > 1 => formula += &format!(r"\text{{{word}}}"),
            _ => formula += &word,
        }
        word.clear();
        match c {
            '*' => {}
            '(' => {
                formula += if is_size { r"\left| " } else { "(" };
                open.push(std::mem::take(&mut is_size));
            }
            ')' => formula += if open.pop() == Some(true) { r" \right|" } else { ")" },
            _ => formula.push(c),
        }
    }
    formula.replace(MEYER.printed_text("meyer.listing.pi"), r"\pi ")
}

/// What a card says as an equation in the letters of mathematics: the name before its first blank equals the formula after it.
/// What is an equation stays as it is, and so does what the language refuses, which equates nothing then.
pub(super) fn as_equation(card: &str) -> String {
    match card.split_once(' ') {
        Some((name, formula)) if !card.contains('=') && is_card(card) => {
            format!("{} = {}", as_formula(name), as_formula(formula))
        }
        _ => card.to_owned(),
    }
}

/// Whether the language reads a card, in a deck where other cards define its names. A blank keeps the name C from making it a
/// comment.
fn is_card(card: &str) -> bool {
    let faults = Deck::read(&format!(" {card}\n END"), CardLayout::Free).map_or_else(|faults| faults.0, |_| Vec::new());
    let of_card = faults.into_iter().filter(|fault| fault.card == 1);
    of_card.map(|fault| fault.problem).all(|problem| matches!(problem, Problem::UnknownName { .. }))
}

/// Evaluates a line, and adds what it computes to the letters.
fn run(line: &str, letters: &mut Letters) {
    let (name, formula) = named(line);
    let value = reading::value(formula, letters);
    letters.insert(name, value);
}

/// What the lines of the motion compute, in their order; the old acceleration is given.
fn motion(mut letters: Letters) -> Letters {
    for line in [G, H, I, J, L, A, B, C, D, E, F] {
        run(line, &mut letters);
    }
    let sign = if letters["F"] < 0.0 { -1.0 } else { 1.0 };
    letters.insert("S".to_owned(), sign);
    for line in [ACCELERATION, FOLLOWER_SPEED] {
        run(line, &mut letters);
    }
    letters
}

/// What a line of the start computes, from the ratio G, the angle X0 and the cards.
pub(crate) fn start_line(name: &str, letters: &Letters) -> f64 {
    let mut letters = letters.clone();
    for line in [P, Q, R, V] {
        run(line, &mut letters);
    }
    letters.get(name).copied().unwrap_or(f64::NAN)
}

/// The formula of the line for the first acceleration.
pub(crate) fn start_formula() -> &'static str {
    named(START).1
}

/// What the lines of the motion compute at an angle, with the acceleration at that instant in place of the old one.
pub(super) fn at(mechanism: Mechanism, x: f64) -> Letters {
    let old = Truth::at(mechanism, x).acceleration;
    let motion_of = [("N", f64::from(mechanism.slots())), ("X", x), ("1DX", SPEED), ("OLD2DX", old)];
    motion(reading::by_name(CARDS.into_iter().chain(motion_of)))
}

/// The program's quantities at an angle, from the equation of motion.
pub(super) struct Truth {
    pub ratio: f64,
    pub pose: Pose<f64>,
    pub coefficients: Coefficients<f64>,
    pub acceleration: f64,
    pub sign: Sign,
}

impl Truth {
    fn at(mechanism: Mechanism, x: f64) -> Self {
        let ratio = mechanism.centre_distance_ratio();
        let pose = Pose::new(&ratio, &Turn::from_radians(x));
        let [friction, torque, follower, driver] = CARDS.map(|(_, value)| value);
        let coefficients = Coefficients::from_pose(&pose, &(driver / follower), &friction, &(torque / follower));
        let (acceleration, sign) =
            coefficients.acceleration(SPEED).map_or((f64::NAN, Sign::Plus), |found| (found.value, found.sign));
        Self { ratio, pose, coefficients, acceleration, sign }
    }
}

/// Whether lines agree with the equation of motion, all over the engagements of the three mechanisms.
pub(super) fn by_coefficients<const N: usize>(pairs: impl Fn(&Letters, &Truth) -> [(f64, f64); N]) -> Finding {
    // The program's lines are computed once for all that is asked of them.
    static AT: OnceLock<Vec<(Letters, Truth)>> = OnceLock::new();
    let all = AT.get_or_init(|| {
        let of = |mechanism: Mechanism| {
            (-9..=9).map(move |k| {
                let x = mechanism.engagement_half_angle() * f64::from(k) / 10.0;
                (at(mechanism, x), Truth::at(mechanism, x))
            })
        };
        Mechanism::ALL.into_iter().flat_map(of).collect()
    });
    let holds = all.iter().all(|(letters, truth)| {
        pairs(letters, truth).iter().all(|(a, b)| vanishes((a - b) / a.abs().max(b.abs()).max(1.0)))
    });
    let how = if holds { "agrees with the mechanism at each" } else { "differs from the mechanism at some" };
    Finding::new(holds, format!("the program {how} of 19 angles, with all three mechanisms"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_card_is_an_equation_if_the_language_reads_it() {
        let read = as_equation("C 2.*(I*U)/L");
        assert_eq!(read.split_whitespace().collect::<Vec<_>>(), ["C", "=", "2.(IU)/L"]);
        for card in ["C 2.(I*U)/L", "C 2.*I(*U)/L", "C 2.*(I*)U/L", "C 2.*(I*U)/L,", "C 2.*(I*U/L", "C I+*U"] {
            assert_eq!(as_equation(card), card);
        }
    }
}
