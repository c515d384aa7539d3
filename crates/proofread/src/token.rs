//! The token tree that every reader makes, with the place of each token in the text.

use crate::effort;
use crate::unit::COUNTED;

/// A stretch of the text that was read, in bytes from its start.
///
/// ```
/// use proofread::Span;
///
/// let (left, right) = (Span::new(0, 5), Span::new(8, 9));
/// assert_eq!(&"1 + 1 = 3"[left.range()], "1 + 1");
/// assert_eq!(left.join(right).range(), 0..9);
/// assert_eq!(left.join(Span::default()), left);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The first byte.
    pub start: u32,
    /// One byte behind the last.
    pub end: u32,
}

impl Span {
    /// The stretch from `start` up to `end`.
    pub fn new(start: usize, end: usize) -> Self {
        let narrow = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Self { start: narrow(start), end: narrow(end) }
    }

    /// The bytes as a range, to cut the stretch out of the text.
    pub fn range(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }

    /// The shortest stretch that covers both; an empty one adds nothing.
    pub fn join(self, other: Self) -> Self {
        if self.start >= self.end {
            return other;
        }
        if other.start >= other.end {
            return self;
        }
        Self { start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// A character as it is to be read, and where it was written: an entity or an escape is one character.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SourceChar {
    pub c: char,
    pub span: Span,
}

/// The characters of a text that starts `base` bytes into the document.
pub(crate) fn signs(text: &str, base: usize) -> Vec<SourceChar> {
    text.char_indices().map(|(at, c)| SourceChar { c, span: Span::new(base + at, base + at + c.len_utf8()) }).collect()
}

/// A function that is written by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names are those of the functions")]
pub enum MathFunction {
    Sin,
    Cos,
    Tan,
    Cot,
    Sec,
    Csc,
    Arcsin,
    Arccos,
    Arctan,
    Ln,
    Log,
    /// The logarithm to the base ten and no other.
    Lg,
    /// The logarithm to a base from 2 on.
    LogTo(u8),
    Exp,
    Sinh,
    Cosh,
    Tanh,
    /// The largest of several numbers.
    Max,
    /// The smallest of several numbers.
    Min,
    /// The greatest common divisor of integers.
    Gcd,
    /// The least common multiple of integers.
    Lcm,
}

/// An operation that is written with signs of its own and has two arguments or more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NamedOperation {
    /// A binomial or multinomial coefficient: of how many, and how many are chosen.
    Binomial,
    /// How many ordered choices there are: of how many, and how many are chosen.
    Permutations,
    /// A falling factorial: the number, and how many factors.
    Falling,
    /// A rising factorial: the number, and how many factors.
    Rising,
    /// A sum over an index: the index, its first and its last value.
    Sum,
    /// A product over an index: the index, its first and its last value.
    Product,
    /// A determinant: its rows, each with cells.
    Determinant,
    /// A matrix: its rows, each with cells.
    Matrix,
    /// A number in another base: its digits, and the base.
    InBase,
}

impl NamedOperation {
    /// A name to show.
    pub fn name(self) -> &'static str {
        match self {
            Self::Binomial => "C",
            Self::Permutations => "P",
            Self::Falling => "falling",
            Self::Rising => "rising",
            Self::Sum => "∑",
            Self::Product => "∏",
            Self::Determinant => "det",
            Self::Matrix | Self::InBase => "",
        }
    }
}

impl MathFunction {
    const ALL: [(&'static str, Self); 24] = [
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("cot", Self::Cot),
        ("sec", Self::Sec),
        ("csc", Self::Csc),
        ("arcsin", Self::Arcsin),
        ("arccos", Self::Arccos),
        ("arctan", Self::Arctan),
        ("asin", Self::Arcsin),
        ("acos", Self::Arccos),
        ("atan", Self::Arctan),
        ("ln", Self::Ln),
        ("log", Self::Log),
        ("exp", Self::Exp),
        ("sinh", Self::Sinh),
        ("cosh", Self::Cosh),
        ("tanh", Self::Tanh),
        ("tg", Self::Tan),
        ("lg", Self::Lg),
        ("max", Self::Max),
        ("min", Self::Min),
        ("gcd", Self::Gcd),
        ("lcm", Self::Lcm),
    ];

    /// The function of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, function)| *function)
    }

    /// Whether it takes a list of numbers.
    pub(crate) fn takes_list(self) -> bool {
        matches!(self, Self::Max | Self::Min | Self::Gcd | Self::Lcm)
    }

    /// Its usual name.
    pub fn name(self) -> &'static str {
        let known = if matches!(self, Self::LogTo(_)) { Self::Log } else { self };
        Self::ALL.iter().find(|(_, function)| *function == known).map_or("", |(name, _)| name)
    }
}

/// Deepest nesting of tokens in tokens. Whatever reads, joins, shows or evaluates them calls itself as often.
const DEEPEST: u8 = 60;

/// What stands for tokens that would be nested too deeply.
pub(crate) const TOO_DEEP: &str = "nested too deeply";
/// What stands for a formula or line that is too long to be read.
pub(crate) const TOO_LONG: &str = "too long";
/// What stands for the rest of a formula whose macros never end.
pub(crate) const ENDLESS: &str = "macros without end";
/// What stands for a comma between digits that may part decimals or numbers.
pub(crate) const UNDECIDED_COMMA: &str = "numbers with a comma, which may be decimal commas";

/// A token and its place.
#[derive(Debug, PartialEq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it was written.
    pub span: Span,
    /// How many tokens are in each other here at most, without this one.
    nesting: u8,
}

impl Clone for Token {
    fn clone(&self) -> Self {
        effort::count_steps(1);
        Self { kind: self.kind.clone(), ..*self }
    }
}

/// What a token is.
#[derive(Clone, Debug, PartialEq)]
pub enum TokenKind {
    /// A number without a sign, as printed, with its thousands commas.
    Number(String),
    /// A letter that stands for a quantity, with its subscript behind `_`.
    Name(String),
    /// Upright text: a unit, or a word of prose.
    Word(String),
    /// A function's name.
    Function(MathFunction),
    /// Any other single sign: an operator, a relation, a bracket, punctuation.
    Operator(char),
    /// Space, in tenths of an em.
    Space(u8),
    /// The end of a row.
    Line,
    /// The boundary between two cells of a row.
    Cell,
    /// Numerator and denominator.
    Fraction(Vec<Token>, Vec<Token>),
    /// A root: what is under it, and its index, empty for the square root.
    Root(Vec<Token>, Vec<Token>),
    /// Something with a subscript and a superscript; what is missing is empty.
    Scripts(Vec<Token>, Vec<Token>, Vec<Token>),
    /// Something with a sign above or below it.
    Accent(Vec<Token>, String),
    /// What braces hold together.
    Group(Vec<Token>),
    /// The rows of a table, an array or a matrix.
    Table(Vec<Vec<Token>>),
    /// An exponent on whatever precedes it.
    Power(Vec<Token>),
    /// A unit vector: 1, 2 and 3 for i, j and k.
    Basis(u8),
    /// An operation by its name, with its arguments.
    Call(NamedOperation, Vec<Vec<Token>>),
    /// A bar behind an expression, with the lower and the upper limit between which it is taken.
    Limits(Vec<Token>, Vec<Token>),
    /// What has no meaning here.
    Unknown(String),
}

impl Token {
    /// A token at a place. No other way makes one, so that none is nested more deeply than all that goes through tokens can bear:
    /// what would be is unknown.
    pub fn new(kind: TokenKind, span: Span) -> Self {
        effort::count_steps(1);
        let inner = kind.inner().flatten().map(|token| token.nesting + 1);
        match inner.max().unwrap_or(0) {
            nesting if nesting > DEEPEST => Self { kind: TokenKind::Unknown(TOO_DEEP.to_owned()), span, nesting: 0 },
            nesting => Self { kind, span, nesting },
        }
    }

    /// Whether it is this sign.
    pub fn is_sign(&self, sign: char) -> bool {
        self.kind == TokenKind::Operator(sign)
    }

    /// Whether it is one of these signs.
    pub fn is_one_of(&self, signs: &str) -> bool {
        matches!(self.kind, TokenKind::Operator(c) if signs.contains(c))
    }

    /// Whether it is space of any width.
    pub fn is_space(&self) -> bool {
        matches!(self.kind, TokenKind::Space(_))
    }

    /// The text of a unit or a word.
    pub fn word(&self) -> Option<&str> {
        match &self.kind {
            TokenKind::Word(text) => Some(text),
            _ => None,
        }
    }

    /// The printed digits of a number.
    pub fn number(&self) -> Option<&str> {
        match &self.kind {
            TokenKind::Number(text) => Some(text),
            _ => None,
        }
    }

    /// The lists of tokens inside it.
    pub fn inner(&self) -> impl Iterator<Item = &[Token]> {
        self.kind.inner()
    }

    /// Changes where it and everything in it was written.
    pub(crate) fn map_spans(&mut self, to: &dyn Fn(Span) -> Span) {
        self.span = to(self.span);
        self.kind.lists().into_iter().flatten().for_each(|token| token.map_spans(to));
    }
}

impl TokenKind {
    /// The lists of tokens inside it.
    fn inner(&self) -> impl Iterator<Item = &[Token]> {
        let none: &[Token] = &[];
        let (few, count, rows): ([&[Token]; 3], usize, &[Vec<Token>]) = match self {
            Self::Fraction(a, b) | Self::Root(a, b) | Self::Limits(a, b) => ([a, b, none], 2, &[]),
            Self::Scripts(a, b, c) => ([a, b, c], 3, &[]),
            Self::Accent(a, _) | Self::Group(a) | Self::Power(a) => ([a, none, none], 1, &[]),
            Self::Table(rows) | Self::Call(_, rows) => ([none; 3], 0, rows),
            _ => ([none; 3], 0, &[]),
        };
        few.into_iter().take(count).chain(rows.iter().map(Vec::as_slice))
    }

    /// Whether there are lists of tokens inside it: most tokens have none.
    fn has_inner(&self) -> bool {
        !matches!(
            self,
            Self::Number(_) | Self::Name(_) | Self::Word(_) | Self::Operator(_) | Self::Space(_) | Self::Unknown(_)
        )
    }

    /// Whether it stands for something that was not read because it went beyond a bound.
    pub(crate) fn is_unread(&self) -> bool {
        matches!(self, Self::Unknown(what) if [TOO_DEEP, TOO_LONG, ENDLESS].contains(&what.as_str()))
    }

    /// The lists of tokens inside it, to change them.
    pub(crate) fn lists(&mut self) -> Vec<&mut Vec<Token>> {
        match self {
            Self::Fraction(a, b) | Self::Root(a, b) | Self::Limits(a, b) => vec![a, b],
            Self::Scripts(a, b, c) => vec![a, b, c],
            Self::Accent(a, _) | Self::Group(a) | Self::Power(a) => vec![a],
            Self::Table(rows) | Self::Call(_, rows) => rows.iter_mut().collect(),
            _ => Vec::new(),
        }
    }
}

/// The tokens without space at either end.
pub(crate) fn trim_space(mut tokens: &[Token]) -> &[Token] {
    while let [first, rest @ ..] = tokens
        && first.is_space()
    {
        tokens = rest;
    }
    while let [rest @ .., last] = tokens
        && last.is_space()
    {
        tokens = rest;
    }
    tokens
}

/// The stretch that tokens cover.
pub(crate) fn span_of(tokens: &[Token]) -> Span {
    tokens.iter().fold(Span::default(), |span, token| span.join(token.span))
}

/// Whether any token here or inside another one is as asked.
pub(crate) fn any(tokens: &[Token], is: &dyn Fn(&TokenKind) -> bool) -> bool {
    let looked_at = |token: &Token| {
        effort::count_steps(1);
        is(&token.kind)
    };
    tokens.iter().any(|token| looked_at(token) || (token.kind.has_inner() && token.inner().any(|inner| any(inner, is))))
}

/// Whether a number is printed anywhere in the tokens.
pub(crate) fn has_number(tokens: &[Token]) -> bool {
    any(tokens, &|kind| matches!(kind, TokenKind::Number(_)))
}

/// Adds the names of quantities among the tokens and inside them, without π and e.
pub(crate) fn collect_names(tokens: &[Token], out: &mut Vec<String>) {
    for token in tokens {
        if let TokenKind::Name(name) = &token.kind
            && !matches!(name.as_str(), "π" | "e")
        {
            out.push(name.clone());
        }
        token.inner().for_each(|inner| collect_names(inner, out));
    }
}

/// The tokens as one line of text.
pub(crate) fn show(tokens: &[Token]) -> String {
    let mut text = String::new();
    show_into(tokens, &mut text);
    let mut out = String::with_capacity(text.len());
    for word in text.split_whitespace() {
        if !out.is_empty() {
            out.push(' ');
        }
        out.push_str(word);
    }
    out
}

/// Whether tokens are one token of such a kind and nothing else, with or without braces.
fn is_only(tokens: &[Token], is: fn(&TokenKind) -> bool) -> bool {
    match tokens {
        [Token { kind: TokenKind::Group(inner), .. }] => is_only(inner, is),
        [only] => is(&only.kind),
        _ => false,
    }
}

/// Whether tokens are a fraction and nothing else, which needs brackets wherever a sign before it takes only one number.
fn is_quotient(tokens: &[Token]) -> bool {
    is_only(tokens, |of| matches!(of, TokenKind::Fraction(..)))
}

fn show_into(tokens: &[Token], out: &mut String) {
    effort::count_steps(tokens.len());
    let bracketed = |inner: &[Token], out: &mut String| {
        let signed = matches!(inner, [sign, Token { kind: TokenKind::Number(_) | TokenKind::Name(_), .. }] if sign.is_one_of("+-"));
        let plain = (inner.len() <= 1 || signed) && !(is_quotient(inner) && out.ends_with(['√', '/', '^', '_']));
        out.push_str(if plain { "" } else { "(" });
        show_into(inner, out);
        out.push_str(if plain { "" } else { ")" });
    };
    for (at, token) in tokens.iter().enumerate() {
        match &token.kind {
            TokenKind::Unknown(text) if text == UNDECIDED_COMMA => out.push(','),
            // What stands for a piece that was not read is no part of the chain.
            TokenKind::Unknown(text) if text.contains(' ') => out.push('…'),
            TokenKind::Unknown(text) => {
                out.push_str(text);
                // The name of a command ends before a letter or a digit.
                let is_command = text.starts_with('\\') && text.ends_with(|c: char| c.is_ascii_alphabetic());
                let is_joined = tokens.get(at + 1).is_some_and(|next| {
                    matches!(next.kind, TokenKind::Name(_) | TokenKind::Number(_) | TokenKind::Unknown(_))
                });
                out.push_str(if is_command && is_joined { " " } else { "" });
            }
            // An exponent without braces takes one digit.
            TokenKind::Number(text)
                if tokens[..at].last().is_some_and(|before| matches!(before.kind, TokenKind::Power(_))) =>
            {
                out.extend([" ", text]);
            }
            TokenKind::Number(text) | TokenKind::Name(text) => out.push_str(text),
            TokenKind::Word(text) => {
                if !text.starts_with(['°', '%']) && !out.ends_with(['/', '·', '(', '^', '-']) {
                    out.push(' ');
                }
                out.push_str(text.trim_start_matches(COUNTED));
            }
            TokenKind::Function(function) => {
                out.push_str(if out.ends_with(['(', '/', '√']) { "" } else { " " });
                out.push_str(function.name());
                if let MathFunction::LogTo(base) = function {
                    out.push_str(&format!("_{base}"));
                }
                let raised = tokens.get(at + 1).is_some_and(|next| matches!(next.kind, TokenKind::Power(_)));
                out.push_str(if raised { "" } else { " " });
            }
            TokenKind::Operator('-' | '+') if at == 0 || tokens[at - 1].is_one_of("([/·×") => {
                out.push(if token.is_sign('-') { '−' } else { '+' });
            }
            TokenKind::Operator('-') => out.push_str(" − "),
            TokenKind::Operator(c) if "=≈+×±⇒".contains(*c) => out.extend([' ', *c, ' ']),
            TokenKind::Operator(c) => out.push(*c),
            TokenKind::Space(0) | TokenKind::Cell => {}
            TokenKind::Space(_) | TokenKind::Line => out.push(' '),
            TokenKind::Fraction(above, below) => {
                // A mixed number: 2 1/2, not 21/2.
                out.push_str(if out.ends_with(|c: char| c.is_ascii_digit()) { " " } else { "" });
                bracketed(above, out);
                out.push('/');
                bracketed(below, out);
            }
            TokenKind::Root(of, index) => {
                show_into(index, out);
                out.push('√');
                bracketed(of, out);
            }
            TokenKind::Scripts(base, sub, sup) => {
                // Of a root or a quotient a bare exponent would be that of its last number.
                let is_open =
                    !sup.is_empty() && (is_quotient(base) || is_only(base, |of| matches!(of, TokenKind::Root(..))));
                out.push_str(if is_open { "(" } else { "" });
                show_into(base, out);
                out.push_str(if is_open { ")" } else { "" });
                for (mark, script) in [('_', sub), ('^', sup)] {
                    if !script.is_empty() {
                        out.push(mark);
                        bracketed(script, out);
                    }
                }
            }
            TokenKind::Accent(base, sign) => {
                show_into(base, out);
                out.push_str(sign);
            }
            TokenKind::Group(inner) => show_into(inner, out),
            TokenKind::Table(rows) => {
                for row in rows {
                    out.push(' ');
                    show_into(row, out);
                }
            }
            TokenKind::Call(NamedOperation::InBase, arguments) => {
                for (at, of) in arguments.iter().enumerate() {
                    out.push_str(if at > 0 { "_" } else { "" });
                    show_into(of, out);
                }
            }
            TokenKind::Call(operation, arguments) => {
                out.push_str(operation.name());
                out.push('(');
                for (at, argument) in arguments.iter().enumerate() {
                    out.push_str(if at > 0 { "; " } else { "" });
                    for (cell, of) in argument.split(|token| token.kind == TokenKind::Cell).enumerate() {
                        out.push_str(if cell > 0 { ", " } else { "" });
                        show_into(of, out);
                    }
                }
                out.push(')');
            }
            TokenKind::Power(exponent) => {
                out.push('^');
                bracketed(exponent, out);
            }
            TokenKind::Basis(which) => out.push_str(["", "î", "ĵ", "k̂"].get(usize::from(*which)).unwrap_or(&"")),
            TokenKind::Limits(from, to) => {
                out.push_str("|_");
                bracketed(from, out);
                out.push('^');
                bracketed(to, out);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reader::{self, TextFormat};

    fn shown(tex: &str) -> String {
        let mut out = String::new();
        let text = format!("${tex}$");
        reader::read(&text, TextFormat::Markdown, &mut |formula| out += &show(&formula.tokens)).expect("a formula");
        out
    }

    #[test]
    fn what_is_shown_means_what_was_read() {
        for (tex, line) in [
            (r"\sqrt{\frac{8}{2}}", "√(8/2)"),
            (r"\sqrt{\frac{3.1^2+4.2^2}{2}}", "√((3.1^2 + 4.2^2)/2)"),
            (r"\sqrt[3]{\frac{16}{2}}", "3√(16/2)"),
            (r"\frac{\sqrt{8}}{2}", "√8/2"),
            (r"\sqrt{8}", "√8"),
            (r"\sqrt{8+1}", "√(8 + 1)"),
            (r"\frac{8}{\frac{2}{3}}", "8/(2/3)"),
            (r"\frac{\frac{8}{2}}{3}", "8/2/3"),
            (r"4^{\frac{1}{2}}", "4^(1/2)"),
            (r"4^{-2}", "4^−2"),
            (r"{\sqrt{4}}^2", "(√4)^2"),
            (r"\sqrt{4^2}", "√4^2"),
        ] {
            assert_eq!(shown(tex), line, "{tex}");
        }
    }
}
