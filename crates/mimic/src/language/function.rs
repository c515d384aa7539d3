//! The functions: one table of all that is known of each, and where it is known from.

use super::code::Operation;

/// Evidence for a word of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WordEvidence {
    /// The thesis uses it, and its text or its results show what it does: MEYER, Appendix B.
    Thesis,
    /// The predators and prey of the encyclopedia use it: <https://en.wikipedia.org/wiki/MIMIC>.
    Encyclopedia,
    /// Both decks use it.
    Both,
    /// Named where languages of this family are described; what it does in detail is assumed.
    Assumed,
}

impl WordEvidence {
    /// The evidence in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Thesis => "the thesis, Appendix B",
            Self::Encyclopedia => "the encyclopedia's deck",
            Self::Both => "both decks",
            Self::Assumed => "as assumed",
        }
    }
}

/// What a function is to the compiler.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FunctionKind {
    /// One instruction with its arguments.
    Plain(Operation),
    /// One instruction for each argument after the first.
    Folded(Operation),
    /// An integral: a component of the state.
    Integral,
    /// An integral that stops at limits.
    Limited,
    /// A lag of first order: a component of the state.
    Lag,
    /// A value of a moment before.
    Delay,
    /// A value taken now and then.
    Sample,
    /// A difference quotient.
    Slope,
    /// A value that makes two equal.
    Implicit,
}

impl FunctionKind {
    /// Whether the value at an instant does not need the arguments of that instant.
    pub(super) fn is_memory(self) -> bool {
        matches!(self, Self::Integral | Self::Limited | Self::Lag | Self::Delay)
    }
}

/// What the arguments of a function are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Signature {
    /// Numbers, and so is the value.
    Numbers,
    /// Truths, and so is the value.
    Truths,
    /// A number, then three of one kind, which is that of the value.
    NumberThenAlike,
    /// A truth, then two of one kind, which is that of the value.
    TruthThenAlike,
}

/// A function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltinFunction {
    /// Its name.
    pub name: &'static str,
    /// Its arguments, as they are called in [`meaning`](Self::meaning).
    pub arguments: &'static str,
    /// What it gives.
    pub meaning: &'static str,
    /// Where it is known from.
    pub evidence: WordEvidence,
    pub(super) least: usize,
    pub(super) most: usize,
    pub(super) takes: Signature,
    pub(super) kind: FunctionKind,
}

impl BuiltinFunction {
    /// How many arguments it takes, in words.
    pub(super) fn arity(&self) -> String {
        let plural = if self.most == 1 { "" } else { "s" };
        let count = match (self.least, self.most) {
            (least, usize::MAX) => format!("{least} or more"),
            (least, most) if least == most => most.to_string(),
            (least, most) => format!("{least} to {most}"),
        };
        format!("{count} argument{plural}: {}({})", self.name, self.arguments)
    }
}

/// Most arguments of a function that takes any number.
const ANY: usize = usize::MAX;

const fn function(
    (name, arguments): (&'static str, &'static str),
    (least, most): (usize, usize),
    (takes, kind): (Signature, FunctionKind),
    evidence: WordEvidence,
    meaning: &'static str,
) -> BuiltinFunction {
    BuiltinFunction { name, arguments, meaning, evidence, least, most, takes, kind }
}

use FunctionKind::{Delay, Folded, Implicit, Integral, Lag, Limited, Plain, Sample, Slope};
use Signature::{NumberThenAlike, Numbers, TruthThenAlike, Truths};
use WordEvidence::{Assumed, Both, Thesis};

/// All functions.
pub static FUNCTIONS: [BuiltinFunction; 26] = [
    function(
        ("INT", "A, B"),
        (2, 2),
        (Numbers, Integral),
        Both,
        "integral of A over T, which is B at T = 0. The integral stands still while its control variable is false",
    ),
    function(
        ("TDL", "A, B, C"),
        (2, 3),
        (Numbers, Delay),
        Thesis,
        "delay: A at T − B, or 0 if A had no value yet at that time. B must be known before the run. We don't know \
         what C is; it may be how many values are kept",
    ),
    function(
        ("FSW", "A, B, C, D"),
        (4, 4),
        (NumberThenAlike, Plain(Operation::FunctionSwitch)),
        Thesis,
        "function switch: B if A < 0, C if A = 0, D if A > 0",
    ),
    function(
        ("NOT", "A"),
        (1, 1),
        (Truths, Plain(Operation::Not)),
        Thesis,
        "TRUE if A is FALSE, and FALSE if it is TRUE",
    ),
    function(
        ("MOD", "A, B"),
        (2, 2),
        (Numbers, Plain(Operation::Remainder)),
        Thesis,
        "remainder of A divided by B, with the sign of A, as in FORTRAN",
    ),
    function(("ABS", "A"), (1, 1), (Numbers, Plain(Operation::Absolute)), Thesis, "absolute value of A"),
    function(("SIN", "A"), (1, 1), (Numbers, Plain(Operation::Sine)), Thesis, "sine of A radians"),
    function(("COS", "A"), (1, 1), (Numbers, Plain(Operation::Cosine)), Thesis, "cosine of A radians"),
    function(
        ("ATN", "A, B"),
        (1, 2),
        (Numbers, Plain(Operation::ArcTangent)),
        Assumed,
        "angle in radians whose tangent is A; with B, the angle of the point (B, A)",
    ),
    function(("SQR", "A"), (1, 1), (Numbers, Plain(Operation::SquareRoot)), Assumed, "square root of A"),
    function(("EXP", "A"), (1, 1), (Numbers, Plain(Operation::Exponential)), Assumed, "e to the power A"),
    function(("LOG", "A"), (1, 1), (Numbers, Plain(Operation::Logarithm)), Assumed, "natural logarithm of A"),
    function(("MAX", "A, B, ..."), (2, ANY), (Numbers, Folded(Operation::Greatest)), Assumed, "greatest argument"),
    function(("MIN", "A, B, ..."), (2, ANY), (Numbers, Folded(Operation::Least)), Assumed, "least argument"),
    function(
        ("LIM", "A, B, C"),
        (3, 3),
        (Numbers, Plain(Operation::Limit)),
        Assumed,
        "limiter: A, but not below B and not above C",
    ),
    function(
        ("DSP", "A, B, C"),
        (3, 3),
        (Numbers, Plain(Operation::DeadSpace)),
        Assumed,
        "dead space: A − B below B, 0 from B to C, A − C above C",
    ),
    function(
        ("LSW", "A, B, C"),
        (3, 3),
        (TruthThenAlike, Plain(Operation::LogicalSwitch)),
        Assumed,
        "logical switch: B if A is TRUE, C if it is FALSE",
    ),
    function(("AND", "A, B, ..."), (2, ANY), (Truths, Folded(Operation::And)), Assumed, "TRUE if all are TRUE"),
    function(("IOR", "A, B, ..."), (2, ANY), (Truths, Folded(Operation::Or)), Assumed, "TRUE if at least one is TRUE"),
    function(
        ("EOR", "A, B, ..."),
        (2, ANY),
        (Truths, Folded(Operation::Exclusive)),
        Assumed,
        "TRUE if an odd number of the arguments are TRUE",
    ),
    function(
        ("LIN", "A, B, C, D"),
        (4, 4),
        (Numbers, Limited),
        Assumed,
        "limited integral of A over T, which is B at T = 0. The integral stands still while it is below C and A < 0, \
         or above D and A > 0",
    ),
    function(
        ("FTR", "A, B, C"),
        (2, 3),
        (Numbers, Lag),
        Assumed,
        "lag of first order: follows A with the time constant B; at T = 0 it is C, or 0 without C",
    ),
    function(
        ("DER", "A, B, C"),
        (3, 3),
        (Numbers, Slope),
        Assumed,
        "derivative of A with respect to B: the change of A divided by the change of B since the last kept point; C at \
         T = 0; it keeps its value while B does not change",
    ),
    function(
        ("ZOH", "A, B"),
        (2, 2),
        (Numbers, Sample),
        Assumed,
        "zero-order hold: A at the latest time that is a multiple of B, or at the first kept point after that",
    ),
    function(
        ("IMP", "A, B"),
        (2, 2),
        (Numbers, Implicit),
        Assumed,
        "implicit: the value that equals B, where B may depend on this value. IMP evaluates B with the value A, \
         takes the result as the next value, and repeats this until two successive values agree to 1E-12 of their \
         size, but at most 1000 times. IMP must be alone in its expression",
    ),
    function(("TAN", "A"), (1, 1), (Numbers, Plain(Operation::Tangent)), Assumed, "tangent of A radians"),
];

/// The function of this name, by its place in the table.
pub(super) fn function_named(name: &str) -> Option<usize> {
    FUNCTIONS.iter().position(|function| function.name == name)
}
