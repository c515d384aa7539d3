//! A factor that several formulas of a document leave out: a habit of its author, such as a unit that is understood, and no misprint.

use crate::judge::verdict::PairJudgement;
use crate::order::{NumberKey, sort_by_place};
use crate::token::Span;

/// Factors that a habit of writing leaves out: of units, angles, free fall, and powers of ten.
const OF_CONVENTIONS: [f64; 14] = [
    2.0,
    3.6,
    4.184,
    4.186,
    4.1868,
    9.8,
    9.81,
    12.0,
    24.0,
    60.0,
    3600.0,
    std::f64::consts::PI,
    std::f64::consts::TAU,
    180.0 / std::f64::consts::PI,
];

/// Whether an author may have left out such a factor throughout. Other factors are of errors that are repeated.
fn is_of_convention(factor: f64) -> bool {
    let near = |of: f64| (factor / of - 1.0).abs() < 0.005;
    let power = libm::log10(factor);
    let of_ten = (power - libm::round(power)).abs() < 0.002;
    factor.is_finite() && factor > 0.0 && (of_ten || OF_CONVENTIONS.iter().any(|of| near(*of) || near(1.0 / of)))
}

/// The largest factor that plain arithmetic of whole numbers differs by as easily as by any other amount: such a factor in three sums is a
/// coincidence.
const SMALL: f64 = 6.0;

/// Whether a factor, or its inverse, is a small whole number.
fn is_small(factor: f64) -> bool {
    let size = factor.max(1.0 / factor);
    size <= SMALL && (size - libm::round(size)).abs() < 1e-9
}

/// Whether a side, as it is shown, has nothing but whole numbers and signs of arithmetic: no decimals, letters or units.
fn is_of_whole_numbers(side: &str) -> bool {
    side.chars().all(|c| c.is_ascii_digit() || " +-−·×÷/^()[]{},".contains(c))
}

/// Differences of a document by the factor between their sides.
#[derive(Debug, Default)]
pub(crate) struct Factors(Vec<Factor>);

#[derive(Debug)]
struct Factor {
    finding: usize,
    formula: Span,
    factor: f64,
    sides: [String; 2],
}

/// How many formulas with the same factor show a habit, since misprints hardly repeat.
const HABIT: usize = 3;

impl Factors {
    /// Notes the factor between the sides of a finding, unless they are so near that it says nothing, or both are arithmetic of whole
    /// numbers that differs by a factor of two, as misprints and slips do.
    pub(crate) fn record(&mut self, finding: usize, formula: Span, judgement: &PairJudgement, sides: [&str; 2]) {
        let Some((left, right)) = &judgement.values else { return };
        let (Ok(left), Ok(right)) = (left.number(), right.number()) else { return };
        let factor = left.point / right.point;
        // A misplaced point does repeat.
        let misplaced = [0.1, 10.0].into_iter().any(|ten| (factor.abs() / ten - 1.0).abs() < 0.005);
        let is_slip = is_small(factor.abs()) && sides.iter().all(|side| is_of_whole_numbers(side));
        if !misplaced && !is_slip && is_of_convention(factor.abs()) && !(0.95..1.05).contains(&factor) {
            self.0.push(Factor { finding, formula, factor, sides: sides.map(str::to_owned) });
        }
    }

    /// The findings whose factor at least [`HABIT`] different formulas share.
    pub(crate) fn habits(&self) -> Vec<usize> {
        let mut sorted: Vec<&Factor> = self.0.iter().collect();
        sort_by_place(&mut sorted, |of| NumberKey(of.factor));
        let mut out = Vec::new();
        let same = |one: &Factor, other: &Factor| (one.factor / other.factor - 1.0).abs() < 0.005;
        for group in sorted.chunk_by(|one, other| same(one, other)) {
            let mut kinds: Vec<(Span, &[String; 2])> = Vec::new();
            for of in group.iter() {
                if kinds.len() < HABIT
                    && !kinds.iter().any(|(formula, sides)| *formula == of.formula || *sides == &of.sides)
                {
                    kinds.push((of.formula, &of.sides));
                }
            }
            if kinds.len() >= HABIT {
                out.extend(group.iter().map(|of| of.finding));
            }
        }
        out
    }
}
