//! Why chains were not checked.

use crate::evaluate::binding::single_name;
use crate::evaluate::value::Obstacle;
use crate::join::chain::{Chain, ChainSide, Relation};
use crate::token::{NamedOperation, Token, TokenKind, any, has_number};
use crate::unit::unit;

/// Why a chain was not checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum UncheckedKind {
    /// A command that is not known stands in it.
    Command,
    /// An environment that is not known, such as a matrix, stands in it.
    Environment,
    /// A function that is not known stands in it by its name.
    Function,
    /// It is written in a way that has no meaning here, such as a list or an uncertainty.
    Notation,
    /// A letter in it has no value.
    Letter,
    /// It gives a letter a value, and that is all.
    Definition,
    /// A word in it is no unit that is known.
    Word,
    /// One of its sides goes on outside the formula, or is missing.
    Cut,
    /// The text asks whether it holds, or says that it does not.
    Denied,
    /// The formula was not read to its end.
    Unread,
    /// Two of its sides differ, and the difference is set aside. Only the command lists this among the chains that were not checked;
    /// the library has it among the findings.
    Doubt,
    /// It may be in a fence of code, which is not read. Only the command lists this among the chains that were not checked; the library
    /// counts it among the parts that were not read.
    Fence,
}

impl UncheckedKind {
    /// A name for programs.
    ///
    /// ```
    /// assert_eq!(proofread::UncheckedKind::Letter.name(), "letter");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Command => "command",
            Self::Environment => "environment",
            Self::Function => "function",
            Self::Notation => "notation",
            Self::Letter => "letter",
            Self::Definition => "definition",
            Self::Word => "word",
            Self::Cut => "cut",
            Self::Denied => "denied",
            Self::Unread => "unread",
            Self::Doubt => "doubt",
            Self::Fence => "fence",
        }
    }

    /// Whether chains of this kind are counted by the name of what stands in them, too.
    pub(crate) fn has_names(self) -> bool {
        matches!(self, Self::Command | Self::Environment | Self::Function | Self::Notation)
    }
}

/// Whether a side is a number apart from commands, environments and functions that may not be known: nothing in it is a letter.
pub(crate) fn is_numeric(side: &ChainSide) -> bool {
    has_number(&side.tokens) && first_letter(&side.tokens).is_none()
}

/// The first letter in tokens that stands for a quantity.
fn first_letter(tokens: &[Token]) -> Option<&str> {
    first_letter_but(tokens, &[])
}

/// The first such letter that is none of these indices, nor one of a sum or a product among the tokens.
fn first_letter_but<'t>(tokens: &'t [Token], indices: &[&'t str]) -> Option<&'t str> {
    let own = tokens.iter().filter_map(|token| match &token.kind {
        TokenKind::Call(NamedOperation::Sum | NamedOperation::Product, limits) => single_name(limits.first()?),
        _ => None,
    });
    let indices: Vec<&str> = own.chain(indices.iter().copied()).collect();
    tokens.iter().enumerate().find_map(|(at, token)| match &token.kind {
        TokenKind::Name(name) if matches!(name.as_str(), "π" | "e" | "c") || indices.contains(&name.as_str()) => None,
        TokenKind::Name(name) if is_called(name, tokens, at) => None,
        TokenKind::Name(name) => Some(name.as_str()),
        _ => token.inner().find_map(|inner| first_letter_but(inner, &indices)),
    })
}

/// Whether a name is that of a function: of several letters, with its arguments in brackets behind it.
fn is_called(name: &str, tokens: &[Token], at: usize) -> bool {
    let long = name.chars().count() > 1 && name.chars().all(char::is_alphabetic);
    long && tokens.get(at + 1).is_some_and(|next| next.is_sign('('))
}

/// Signs that have limits, and what they make.
const LARGE_SIGNS: [([&str; 2], &str); 4] = [
    (["\\sum", "∑"], "a sum over an index"),
    (["\\prod", "∏"], "a product over an index"),
    (["\\int", "∫"], "an integral"),
    (["\\lim", "lim"], "a limit"),
];

/// What stands in tokens that has no meaning here: the first such thing.
fn first_unknown(tokens: &[Token], text: &str) -> Option<(UncheckedKind, String)> {
    tokens.iter().enumerate().find_map(|(at, token)| match &token.kind {
        TokenKind::Unknown(name) if name.starts_with('\\') => Some((UncheckedKind::Command, name.clone())),
        TokenKind::Unknown(name) if matches!(name.as_str(), "pmod" | "bmod" | "mod") => {
            Some((UncheckedKind::Command, format!("\\{name}")))
        }
        TokenKind::Unknown(name) if name == "…" => Some((UncheckedKind::Notation, "dots".to_owned())),
        TokenKind::Unknown(name) if name.chars().all(|c| c.is_alphabetic() || c == '*') => {
            Some((UncheckedKind::Environment, name.clone()))
        }
        TokenKind::Unknown(name) => {
            let source = text.get(token.span.range()).unwrap_or_default();
            let large = LARGE_SIGNS.iter().find(|(signs, _)| signs.iter().any(|sign| source.contains(sign)));
            Some((UncheckedKind::Notation, large.map_or(name.clone(), |(_, words)| (*words).to_owned())))
        }
        TokenKind::Table(_) => Some((UncheckedKind::Notation, "a table or a matrix".to_owned())),
        TokenKind::Name(name) | TokenKind::Word(name) if is_called(name, tokens, at) => {
            Some((UncheckedKind::Function, name.clone()))
        }
        _ => token.inner().find_map(|inner| first_unknown(inner, text)),
    })
}

/// The sides of a chain, and what became of them.
pub(crate) struct ChainOutcome<'t> {
    pub text: &'t str,
    pub chain: &'t Chain,
    /// Which sides were compared.
    pub compared: Vec<bool>,
    /// What keeps a side from having a value.
    pub obstacles: Vec<Option<Obstacle>>,
    /// What keeps two sides from being compared.
    pub between: Option<Obstacle>,
}

impl ChainOutcome<'_> {
    /// Why the chain was not checked, or a part of it; none if all numbers in it were compared.
    pub(crate) fn reason(&self) -> Option<(UncheckedKind, String)> {
        let sides = &self.chain.sides;
        let partly = self.compared.contains(&true);
        let equals = |side: Option<&ChainSide>| {
            side.is_some_and(|side| matches!(side.relation, Some(Relation::Equal | Relation::Approximate)))
        };
        let is_open = |at: &usize| {
            let is_equated = equals(sides.get(*at)) || equals(sides.get(at + 1));
            !self.compared[*at] && is_equated && is_numeric(&sides[*at])
        };
        let open: Vec<usize> = (0..sides.len()).filter(is_open).collect();
        if partly && open.is_empty() {
            return None;
        }
        if (partly || open.len() > 1)
            && let Some(why) = open.iter().find_map(|at| self.of_side(*at))
        {
            return Some(why);
        }
        let letters = sides.iter().filter_map(|side| first_letter(&side.tokens));
        let mut others = sides.iter().filter(|side| single_name(&side.tokens).is_none());
        if let (Some(value), None, Some(name)) =
            (others.next(), others.next(), sides.iter().find_map(|side| single_name(&side.tokens)))
            && is_numeric(value)
            && first_unknown(&value.tokens, self.text).is_none()
        {
            return Some((UncheckedKind::Definition, name.to_owned()));
        }
        let found = { letters }.next().map(|name| (UncheckedKind::Letter, name.to_owned()));
        let found = found.or_else(|| sides.iter().find_map(|side| first_unknown(&side.tokens, self.text)));
        let found = found.or_else(|| of_obstacle(self.between.as_ref()?));
        let found = found.or_else(|| (0..sides.len()).find_map(|at| self.of_side(at)));
        let word = |side: &ChainSide| {
            side.tokens.iter().filter_map(Token::word).find(|word| unit(word).is_none()).map(str::to_owned)
        };
        let found = found.or_else(|| sides.iter().find_map(word).map(|word| (UncheckedKind::Word, word)));
        Some(found.unwrap_or((UncheckedKind::Cut, String::new())))
    }

    /// What keeps a side from having a value.
    fn of_side(&self, at: usize) -> Option<(UncheckedKind, String)> {
        let obstacle = self.obstacles[at].as_ref()?;
        let tokens = &self.chain.sides[at].tokens;
        let listed = |kind: &TokenKind| *kind == TokenKind::Operator(',');
        first_unknown(tokens, self.text).or_else(|| match of_obstacle(obstacle)? {
            (UncheckedKind::Notation, why) if why.ends_with(UNEXPECTED) => {
                let what = if any(tokens, &listed) { "a list in brackets" } else { why.trim_start_matches("it has ") };
                Some((UncheckedKind::Notation, what.to_owned()))
            }
            found => Some(found),
        })
    }
}

/// How the obstacle ends that says least.
const UNEXPECTED: &str = "a sign in a place where none is expected";

fn of_obstacle(obstacle: &Obstacle) -> Option<(UncheckedKind, String)> {
    Some(match obstacle {
        Obstacle::Letter(name) => (UncheckedKind::Letter, name.clone()),
        Obstacle::Word(word) => (UncheckedKind::Word, word.clone()),
        Obstacle::NoNumber => return None,
        other => (UncheckedKind::Notation, other.to_string()),
    })
}

/// Whether anything in the chain was not read to its end.
pub(crate) fn is_unread(chain: &Chain) -> bool {
    chain.sides.iter().any(|side| any(&side.tokens, &TokenKind::is_unread))
}
