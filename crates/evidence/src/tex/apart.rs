//! How far the sides of an equation are apart, for a proof: numbers, the parts of vectors, and sums of angles as turns.

use super::number::Number;
use super::tree::{Function, Joint, Node};
use super::value::Value;
use super::{Illegible, Moment};

impl<N: Number> Moment<N> {
    /// The sides of two equal things, each less the other: their parts, if they are vectors. An inverse function is undone
    /// on both sides, and angles are proven as turns.
    pub(super) fn apart(&self, [left, right]: [&Node; 2], sign: i64) -> Result<Vec<N>, Illegible> {
        if let (Some([a, b]), Some([x, y])) = (self.turn(left), self.turn(right)) {
            // Turned forth by one and back by the other.
            let cos = a.clone() * x.clone() + b.clone() * y.clone();
            return Ok(vec![b * x - a * y, cos - N::integer(1)]);
        }
        let undone = |node: &Node, other: &Node| undone(node).map(|(of, function)| [other.clone().of(function), of]);
        if let Some([one, other]) = undone(left, right).or_else(|| undone(right, left)) {
            return Ok(vec![self.value(&one, sign)?.number()? - self.value(&other, sign)?.number()?]);
        }
        let minus = self.value(right, sign)?.times(N::integer(-1));
        Ok(match self.value(left, sign)?.plus(minus)? {
            Value::Number(number) => vec![number],
            Value::Vector(parts) => parts.into(),
        })
    }

    /// The cosine and the sine of a sum of angles; none if it is another thing.
    fn turn(&self, node: &Node) -> Option<[N; 2]> {
        let [zero, one] = [0, 1].map(N::integer);
        let plus = |[a, b]: [N; 2], [x, y]: [N; 2]| [a.clone() * x.clone() - b.clone() * y.clone(), b * x + a * y];
        let times =
            |turn: [N; 2], count: i64| (0..count).fold([one.clone(), zero.clone()], |sum, _| plus(sum, turn.clone()));
        let quarters = |count: i64| times([zero.clone(), one.clone()], count.rem_euclid(4));
        if self.angles.is_empty() {
            return None;
        }
        match node {
            Node::Name(name) if name == "pi" => Some(quarters(2)),
            Node::Name(name) => self.angles.get(name).cloned(),
            Node::Of(Function::Minus, of) => self.turn(of).map(|[cos, sin]| [cos, -sin]),
            Node::Of(Function::Degrees, of) => match **of {
                Node::Number(degrees, 0) if degrees % 90 == 0 => Some(quarters(degrees / 90)),
                _ => None,
            },
            Node::Two(Joint::Plus, left, right) => Some(plus(self.turn(left)?, self.turn(right)?)),
            Node::Two(Joint::Times, factor, of) => match **factor {
                Node::Number(count, 0) if (0..=8).contains(&count) => Some(times(self.turn(of)?, count)),
                _ => None,
            },
            Node::Two(Joint::Over, of, by) if **by == Node::integer(2) && **of == Node::Name("pi".to_owned()) => {
                Some(quarters(1))
            }
            _ => None,
        }
    }
}

/// What an inverse function is of, and the function that undoes it. The cosine does not see which of two signs is meant.
fn undone(node: &Node) -> Option<(Node, Function)> {
    match node {
        Node::Of(Function::ArcTangent, of) => Some(((**of).clone(), Function::Tangent)),
        Node::Of(Function::ArcCosine, of) => Some(((**of).clone(), Function::Cosine)),
        Node::Of(Function::PlusMinus, of) => undone(of).filter(|(_, function)| *function == Function::Cosine),
        _ => None,
    }
}
