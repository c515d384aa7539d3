//! Flat code: a list of instructions over a list of registers, run from the first to the last.

use super::digits::eight_digits;

/// What an instruction does. A truth is 1, its opposite 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    Copy,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Absolute,
    Sine,
    Cosine,
    Tangent,
    ArcTangent,
    SquareRoot,
    Exponential,
    Logarithm,
    Remainder,
    Greatest,
    Least,
    Limit,
    DeadSpace,
    FunctionSwitch,
    LogicalSwitch,
    Not,
    And,
    Or,
    Exclusive,
    /// The difference quotient of the first two since the values in the third and fourth; the result's own register
    /// keeps its value while the second rests.
    Slope,
    /// Passes over so many instructions, which stand in place of the result, unless the first two are true.
    Unless,
    /// Goes back over so many instructions, until the result and the first are equal. The second counts, the third says
    /// over how many, and the fourth is what the result began with.
    Repeat,
}

/// An instruction: where the result goes, and what it is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Instruction {
    pub(super) operation: Operation,
    pub(super) to: u32,
    pub(super) from: [u32; 4],
}

/// How often a loop around `IMP` is repeated at most, and how near the two sides must come: relative to their size, or
/// to so small a part of what it began with that they are nothing beside it.
const REPEATED: f64 = 1000.0;
const NEAR: f64 = 1e-12;
const NOTHING: f64 = 1e-6;

/// Runs the code.
pub(super) fn execute(code: &[Instruction], registers: &mut [f64]) {
    let mut at = 0;
    while let Some(Instruction { operation, to, from }) = code.get(at) {
        at += 1;
        let to = *to as usize;
        // One by one: compiled for size, a call of `map` here takes as long as all that follows.
        let read = |place: usize| registers[from[place] as usize];
        let [a, b, c, d] = [read(0), read(1), read(2), read(3)];
        let value = match operation {
            Operation::Copy => a,
            Operation::Add => a + b,
            Operation::Subtract => a - b,
            Operation::Multiply => a * b,
            Operation::Divide => a / b,
            Operation::Power => libm::pow(a, b),
            Operation::Negate => -a,
            Operation::Absolute => a.abs(),
            Operation::Sine => libm::sin(a),
            Operation::Cosine => libm::cos(a),
            Operation::Tangent => libm::tan(a),
            Operation::ArcTangent => libm::atan2(a, b),
            Operation::SquareRoot => a.sqrt(),
            Operation::Exponential => libm::exp(a),
            Operation::Logarithm => libm::log(a),
            Operation::Remainder => libm::fmod(a, b),
            Operation::Greatest => greatest(a, b),
            Operation::Least => -greatest(-a, -b),
            Operation::Limit => -greatest(-greatest(a, b), -c),
            Operation::DeadSpace => dead_space(a, b, c),
            Operation::FunctionSwitch => switch(a, [b, c, d]),
            Operation::LogicalSwitch => choose(a, b, c),
            Operation::Not => 1.0 - a,
            Operation::And => a * b,
            Operation::Or => a + b - a * b,
            Operation::Exclusive => (a - b).abs(),
            Operation::Slope => slope(registers[to], [a, b], [c, d]),
            Operation::Unless => {
                if a != 1.0 || b != 1.0 {
                    at += to;
                }
                continue;
            }
            Operation::Repeat => {
                let [new, counter] = [from[0] as usize, from[1] as usize];
                let old = registers[to];
                let near = (old - registers[new]).abs() <= NEAR * registers[new].abs().max(NOTHING * d.abs());
                registers[counter] += 1.0;
                if !near && old.is_finite() && registers[counter] < REPEATED {
                    registers[to] = registers[new];
                    at -= c as usize;
                    continue;
                }
                if near { registers[new] } else { f64::NAN }
            }
        };
        registers[to] = value;
    }
}

/// What is no number hides behind nothing.
fn greatest(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

fn dead_space(value: f64, low: f64, high: f64) -> f64 {
    if low.is_nan() || high.is_nan() {
        f64::NAN
    } else if value < low {
        value - low
    } else if value > high {
        value - high
    } else {
        0.0 * value
    }
}

fn switch(value: f64, [below, at, above]: [f64; 3]) -> f64 {
    if value < 0.0 {
        below
    } else if value > 0.0 {
        above
    } else if value == 0.0 {
        at
    } else {
        value
    }
}

fn choose(truth: f64, yes: f64, no: f64) -> f64 {
    if truth == 1.0 {
        yes
    } else if truth.is_nan() {
        truth
    } else {
        no
    }
}

fn slope(last: f64, [a, b]: [f64; 2], [old_a, old_b]: [f64; 2]) -> f64 {
    if b == old_b { last } else { (a - old_a) / (b - old_b) }
}

impl Instruction {
    /// The registers that decide the value: of a switch, only those of the branch that is taken.
    pub(super) fn operands_in_use(&self, registers: &[f64]) -> Vec<u32> {
        let [a, b, c, d] = self.from;
        let value = registers[a as usize];
        match self.operation {
            Operation::FunctionSwitch if value < 0.0 => vec![a, b],
            Operation::FunctionSwitch if value > 0.0 => vec![a, d],
            Operation::FunctionSwitch => vec![a, c],
            Operation::LogicalSwitch if value == 1.0 => vec![a, b],
            Operation::LogicalSwitch => vec![a, c],
            Operation::Limit | Operation::DeadSpace => vec![a, b, c],
            Operation::Slope => vec![a, b],
            Operation::Add
            | Operation::Subtract
            | Operation::Multiply
            | Operation::Divide
            | Operation::Power
            | Operation::ArcTangent
            | Operation::Remainder
            | Operation::Greatest
            | Operation::Least
            | Operation::And
            | Operation::Or
            | Operation::Exclusive => vec![a, b],
            Operation::Repeat => vec![a],
            Operation::Unless => Vec::new(),
            _ => vec![a],
        }
    }

    /// What made a number that is none out of numbers, in words.
    pub(super) fn reason(&self, registers: &[f64]) -> String {
        let [first, b, ..] = self.from.map(|register| registers[register as usize]);
        let (a, other) = (eight_digits(first), eight_digits(b));
        match self.operation {
            Operation::Divide if b == 0.0 => format!("{a} divided by zero"),
            Operation::Divide => format!("{a} divided by {other} is too large"),
            Operation::Remainder => format!("MOD of {a} and {other}"),
            Operation::SquareRoot => format!("the square root of {a}"),
            Operation::Logarithm => format!("the logarithm of {a}"),
            Operation::Exponential => format!("e to the power {a} is too large"),
            Operation::Power => format!("{a} to the power {other}"),
            Operation::Multiply => format!("{a} times {other} is too large"),
            Operation::Repeat => format!(
                "IMP finds no value that its loop gives back: after {b} repetitions it gives back {a}, and what goes in \
                 and what comes back must agree to {NEAR:e} of their size within {REPEATED} repetitions; begin nearer, or \
                 let it give back the middle of both, such as .5*(X+B)"
            ),
            Operation::Slope => "a difference quotient".to_owned(),
            _ => format!("a value from {a} and {other} is too large"),
        }
    }
}
