//! Numbers and truths: which of the two a name is, and whether it is used as that.

use super::diagnostic::Problem;
use super::function::{FUNCTIONS, Signature};
use super::tree::{CardExpression, ExpressionNode};
use core::ops::Range;

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    Number,
    Truth,
}

impl Type {
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::Truth => "truth (TRUE or FALSE)",
        }
    }

    /// A problem unless it is the type that is wanted.
    pub(super) fn must_be(self, wanted: Self, what: impl FnOnce() -> String) -> Result<(), Problem> {
        if self == wanted {
            return Ok(());
        }
        Err(Problem::Type { what: what(), expected: wanted.words(), found: self.words() })
    }
}

/// The type of each node, and what does not fit. A name whose type is not known yet is taken for a number: it is one
/// that an INT or a TDL of a later card gives.
pub(super) fn types(
    expression: &CardExpression,
    of_name: impl Fn(&str) -> Option<Type>,
) -> (Type, Vec<(Range<usize>, Problem)>) {
    let mut problems = Vec::new();
    let mut found: Vec<Type> = Vec::with_capacity(expression.nodes.len());
    for (node, _) in &expression.nodes {
        let mut check = |part: usize, wanted: Type, what: &dyn Fn() -> String| {
            if let Err(problem) = found[part].must_be(wanted, what) {
                problems.push((expression.nodes[part].1.clone(), problem));
            }
        };
        let kind = match node {
            ExpressionNode::Number(_) => Type::Number,
            ExpressionNode::Name(name) => of_name(name).unwrap_or(Type::Number),
            ExpressionNode::Negative(part) => {
                check(*part, Type::Number, &|| "what a sign stands before".to_owned());
                Type::Number
            }
            ExpressionNode::Binary(_, parts) => {
                for part in parts {
                    check(*part, Type::Number, &|| "what is computed with".to_owned());
                }
                Type::Number
            }
            ExpressionNode::Call(function, arguments) => {
                let function = &FUNCTIONS[*function];
                let first_own = match function.takes {
                    Signature::Numbers => Type::Number,
                    Signature::Truths => Type::Truth,
                    Signature::NumberThenAlike | Signature::TruthThenAlike => found[arguments[1]],
                };
                let letters = ["A", "B", "C", "D"];
                for (at, argument) in arguments.iter().enumerate() {
                    let wanted = match (function.takes, at) {
                        (Signature::NumberThenAlike, 0) => Type::Number,
                        (Signature::TruthThenAlike, 0) => Type::Truth,
                        _ => first_own,
                    };
                    let letter = letters.get(at).copied().unwrap_or("every argument");
                    check(*argument, wanted, &|| format!("{letter} of {}({})", function.name, function.arguments));
                }
                first_own
            }
        };
        found.push(kind);
    }
    (found.last().copied().unwrap_or(Type::Number), problems)
}
