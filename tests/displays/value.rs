//! What a formula comes to, once its names have values: numbers, and vectors of space.

use super::state::State;
use super::tree::{Chain, Display, Function, Joint, Node};
use nalgebra::Vector3;

/// A number or a vector, with the size of what it was made of: the measure of its rounding.
#[derive(Clone, Copy, Debug)]
pub struct Value {
    pub what: What,
    size: f64,
}

/// A number or a vector.
#[derive(Clone, Copy, Debug)]
pub enum What {
    Number(f64),
    Vector(Vector3<f64>),
}

/// How far two sides may be apart, in parts of the size of what they are made of.
const TOLERANCE: f64 = 1e-10;

impl Value {
    pub fn new(what: What) -> Self {
        Self { what, size: what.norm() }
    }

    fn number(number: f64, size: f64) -> Self {
        Self { what: What::Number(number), size: size.max(number.abs()) }
    }

    fn scalar(&self) -> Result<f64, String> {
        match self.what {
            What::Number(number) => Ok(number),
            What::Vector(_) => Err("a vector where a number should stand".into()),
        }
    }

    fn times(self, factor: f64) -> Self {
        let what = match self.what {
            What::Number(number) => What::Number(number * factor),
            What::Vector(vector) => What::Vector(vector * factor),
        };
        Self { what, size: self.size * factor.abs() }
    }

    fn plus(self, other: Self) -> Result<Self, String> {
        let what = match (self.what, other.what) {
            (What::Number(one), What::Number(other)) => What::Number(one + other),
            (What::Vector(one), What::Vector(other)) => What::Vector(one + other),
            // Nothing is nothing of either kind.
            (What::Vector(one), What::Number(0.0)) | (What::Number(0.0), What::Vector(one)) => What::Vector(one),
            _ => return Err("a number added to a vector".into()),
        };
        Ok(Self { what, size: self.size + other.size })
    }

    /// Whether two values are the same, within rounding.
    fn is(self, other: Self) -> bool {
        let gap = self.plus(other.times(-1.0));
        gap.is_ok_and(|gap| gap.size.is_finite() && gap.what.norm() <= TOLERANCE * gap.size)
    }
}

impl What {
    fn norm(&self) -> f64 {
        match self {
            Self::Number(number) => number.abs(),
            Self::Vector(vector) => vector.norm(),
        }
    }
}

/// Whether all chains of a display hold in all states. A chain of one says nothing, and is an error.
pub fn holds(display: &Display, states: &[State]) -> Result<bool, String> {
    if display.chains.is_empty() || display.chains.iter().any(|chain| chain.len() < 2) {
        return Err("it equates nothing".into());
    }
    for (chain, state) in display.chains.iter().flat_map(|chain| states.iter().map(move |state| (chain, state))) {
        if !agrees(chain, state)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether all sides of a chain are the same in a state; where a double sign stands, for one of the signs.
fn agrees(chain: &Chain, state: &State) -> Result<bool, String> {
    for sign in [1.0, -1.0] {
        let sides: Vec<Value> = chain.iter().map(|side| evaluate(side, state, sign)).collect::<Result<_, _>>()?;
        if sides.windows(2).all(|pair| pair[0].is(pair[1])) {
            return Ok(true);
        }
    }
    Ok(false)
}

fn evaluate(node: &Node, state: &State, sign: f64) -> Result<Value, String> {
    match node {
        Node::Number(number) => Ok(Value::new(What::Number(*number))),
        Node::Name(name) => state.value(name).ok_or_else(|| format!("the name {name}")),
        Node::Column(first, second) => {
            let (first, second) = (evaluate(first, state, sign)?, evaluate(second, state, sign)?);
            let vector = Vector3::new(first.scalar()?, second.scalar()?, 0.0);
            Ok(Value { what: What::Vector(vector), size: first.size + second.size })
        }
        Node::Call(name, first, second) => {
            let function = state.function(name).ok_or_else(|| format!("the function {name}"))?;
            let (first, second) = (evaluate(first, state, sign)?.scalar()?, evaluate(second, state, sign)?.scalar()?);
            Ok(Value::new(What::Number(function(first, second))))
        }
        Node::Of(Function::Rate, of) => rate(of, state, sign),
        Node::Of(function, of) => apply(*function, evaluate(of, state, sign)?, sign),
        Node::Two(joint, left, right) => {
            let (left, right) = (evaluate(left, state, sign)?, evaluate(right, state, sign)?);
            combine(*joint, left, right)
        }
    }
}

fn apply(function: Function, of: Value, sign: f64) -> Result<Value, String> {
    match (function, of.what) {
        (Function::Minus, _) => return Ok(of.times(-1.0)),
        (Function::PlusMinus, _) => return Ok(of.times(sign)),
        (Function::Size, what) => return Ok(Value::number(what.norm(), of.size)),
        _ => {}
    }
    let number = of.scalar()?;
    let value = match function {
        Function::Degrees => return Ok(of.times(1f64.to_radians())),
        Function::Root => number.sqrt(),
        Function::Sine => libm::sin(number),
        Function::Cosine => libm::cos(number),
        Function::Tangent => libm::tan(number),
        Function::Secant => 1.0 / libm::cos(number),
        Function::ArcSine => libm::asin(number),
        Function::ArcCosine => libm::acos(number),
        Function::ArcTangent => libm::atan(number),
        Function::Minus | Function::PlusMinus | Function::Size | Function::Rate => unreachable!(),
    };
    Ok(Value::number(value, 1.0))
}

fn combine(joint: Joint, left: Value, right: Value) -> Result<Value, String> {
    let size = left.size * right.size;
    match (joint, left.what, right.what) {
        (Joint::Plus, ..) => left.plus(right),
        (Joint::Cross, What::Vector(one), What::Vector(other)) => {
            Ok(Value { what: What::Vector(one.cross(&other)), size })
        }
        (Joint::Times | Joint::Cross, What::Number(factor), _) => Ok(Value { size, ..right.times(factor) }),
        (Joint::Times | Joint::Cross, _, What::Number(factor)) => Ok(Value { size, ..left.times(factor) }),
        (Joint::Times, ..) => Err("two vectors side by side".into()),
        (Joint::Over, ..) => Ok(left.times(1.0 / right.scalar()?)),
        (Joint::Power, ..) => {
            let (base, power) = (left.scalar()?, right.scalar()?);
            Ok(Value::number(libm::pow(base, power), libm::pow(left.size, power)))
        }
    }
}

/// The rate of change, from the states shortly before and after: a difference that is right to the eighth order.
fn rate(of: &Node, state: &State, sign: f64) -> Result<Value, String> {
    let step = 1.0 / 1024.0;
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = Value::new(What::Number(0.0));
    for (steps, weight) in (1..).zip(weights) {
        for direction in [1.0, -1.0] {
            let there = evaluate(of, &state.later(direction * f64::from(steps) * step), sign)?;
            sum = sum.plus(there.times(direction * weight / step))?;
        }
    }
    Ok(sum)
}
