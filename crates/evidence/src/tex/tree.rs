//! What a formula says, as a tree, and the tree of its rate of change.

/// A formula, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    /// A number: its digits, and how many of them stand behind the point.
    Number(i64, u32),
    /// A letter with all that hangs on it, in one spelling. See [`super::name`].
    Name(String),
    /// A sign, a function or the rate of change of something.
    Of(Function, Box<Node>),
    /// Two things joined.
    Two(Joint, Box<Node>, Box<Node>),
}

/// What can be done to one thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Minus,
    /// The sign that stands for both.
    PlusMinus,
    /// So many degrees.
    Degrees,
    /// What stands between bars.
    Size,
    Root,
    Sine,
    Cosine,
    Tangent,
    Secant,
    ArcSine,
    ArcCosine,
    ArcTangent,
    /// The derivative of what follows.
    Rate(By),
}

/// What something is differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// d/dt.
    Time,
    /// ∂/∂θ.
    Angle,
    /// ∂/∂θ'.
    Speed,
}

/// How two things are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Joint {
    Plus,
    Times,
    Cross,
    Over,
    Power,
    /// Two coordinates, one below the other.
    Column,
    /// The slope f of two numbers.
    Slope,
}

impl Node {
    /// A whole number.
    pub(super) fn integer(n: i64) -> Self {
        Self::Number(n, 0)
    }

    /// A sign, a function or a rate of this.
    #[must_use]
    pub(super) fn of(self, function: Function) -> Self {
        Self::Of(function, Box::new(self))
    }

    /// This, joined with another.
    #[must_use]
    pub(super) fn join(self, joint: Joint, other: Self) -> Self {
        Self::Two(joint, Box::new(self), Box::new(other))
    }

    /// Visits this and all its parts.
    pub(super) fn visit<'a>(&'a self, visitor: &mut dyn FnMut(&'a Self)) {
        visitor(self);
        match self {
            Self::Number(..) | Self::Name(_) => {}
            Self::Of(_, of) => of.visit(visitor),
            Self::Two(_, left, right) => {
                left.visit(visitor);
                right.visit(visitor);
            }
        }
    }

    /// To which power a part of it is raised in all, by its powers and theirs; of a power that is no number, as high as is proven.
    pub(super) fn highest_power(&self) -> u64 {
        match self {
            Self::Number(..) | Self::Name(_) => 1,
            Self::Of(_, of) => of.highest_power(),
            Self::Two(Joint::Power, base, exponent) => {
                let by = if let Self::Number(digits, 0) = **exponent { digits.unsigned_abs() } else { 16 };
                base.highest_power().saturating_mul(by.max(1)).max(exponent.highest_power())
            }
            Self::Two(_, left, right) => left.highest_power().max(right.highest_power()),
        }
    }

    /// Whether this or a part of it is so.
    pub(super) fn contains(&self, is: impl Fn(&Self) -> bool) -> bool {
        let mut found = false;
        self.visit(&mut |node| found = found || is(node));
        found
    }

    /// Renames each letter of the formula.
    #[must_use]
    pub(super) fn renamed(self, name: &dyn Fn(&str) -> String) -> Self {
        match self {
            Self::Number(..) => self,
            Self::Name(old) => Self::Name(name(&old)),
            Self::Of(function, of) => of.renamed(name).of(function),
            Self::Two(joint, left, right) => left.renamed(name).join(joint, right.renamed(name)),
        }
    }

    /// The derivative: only names are left behind a sign of differentiation. None if no rule is known.
    pub(super) fn rate(&self, by: By) -> Option<Self> {
        use {Function::*, Joint::*};
        let rate = |node: &Self| node.rate(by);
        let (one, two) = (Self::integer(1), Self::integer(2));
        Some(match self {
            Self::Number(..) => Self::integer(0),
            Self::Name(_) => self.clone().of(Rate(by)),
            Self::Of(Rate(_), _) => return None,
            Self::Of(function @ (Minus | PlusMinus | Degrees), of) => rate(of)?.of(*function),
            Self::Of(function, of) => {
                let slope = match function {
                    Size => self.clone().join(Over, (**of).clone()),
                    Root => one.join(Over, two.join(Times, self.clone())),
                    Sine => of.clone().of(Cosine),
                    Cosine => of.clone().of(Sine).of(Minus),
                    Tangent => of.clone().of(Secant).join(Power, two),
                    Secant => self.clone().join(Times, of.clone().of(Tangent)),
                    _ => return None,
                };
                slope.join(Times, rate(of)?)
            }
            Self::Two(joint @ (Plus | Column), left, right) => rate(left)?.join(*joint, rate(right)?),
            Self::Two(joint @ (Times | Cross), left, right) => {
                let (left, right) = ((**left).clone(), (**right).clone());
                rate(&left)?.join(*joint, right.clone()).join(Plus, left.join(*joint, rate(&right)?))
            }
            Self::Two(Over, left, right) => {
                let (above, below) = ((**left).clone(), (**right).clone());
                let first = rate(&above)?.join(Times, below.clone());
                let second = above.join(Times, rate(&below)?).of(Minus);
                first.join(Plus, second).join(Over, below.join(Power, two))
            }
            // The exponents of all sources are constant.
            Self::Two(Power, base, exponent) => {
                let (base, exponent) = ((**base).clone(), (**exponent).clone());
                let lower = exponent.clone().join(Plus, one.of(Minus));
                exponent.join(Times, base.clone().join(Power, lower)).join(Times, rate(&base)?)
            }
            Self::Two(Slope, ..) => return None,
        })
    }
}
