//! Chains that were not checked, and why not.

use crate::binding::single_name;
use crate::chain::{Chain, ChainSide, Relation};
use crate::doubt::Doubt;
use crate::finding::{ChainFinding, chain_line};
use crate::reader::Formula;
use crate::token::{Span, Token, TokenKind, any, has_number};
use crate::unit::unit;
use crate::value::Obstacle;

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
    /// Two of its sides differ, and the difference is set aside.
    Doubt,
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
        }
    }

    /// Whether chains of this kind are counted by the name of what stands in them, too.
    pub(crate) fn has_names(self) -> bool {
        matches!(self, Self::Command | Self::Environment | Self::Function | Self::Notation)
    }
}

/// A chain that was not checked, or not all of it, and why.
///
/// ```
/// use proofread::{CheckOptions, TextFormat, UncheckedKind, proofread};
///
/// let options = CheckOptions { unchecked: true, ..CheckOptions::default() };
/// let report = proofread(r"So $2 + 2 = 4$ and $\foo{7} = 36$.", TextFormat::Markdown, options)?;
/// let [chain] = report.unchecked.as_slice() else { panic!("one chain") };
/// assert_eq!((chain.kind, chain.name.as_str()), (UncheckedKind::Command, "\\foo"));
/// assert_eq!(chain.reason(), "`\\foo` is not known");
/// assert_eq!((report.tally.checked, report.tally.checkable), (1, 2));
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UncheckedChain {
    /// Why it was not checked.
    pub kind: UncheckedKind,
    /// What stands in it: the command, the environment, the function, the notation in words, the letter, the word, or the reason to
    /// set a difference aside. Empty where there is none.
    pub name: String,
    /// The chain, as one line.
    pub chain: String,
    /// Its place in the text.
    pub span: Span,
    /// Whether other sides of it were compared.
    pub partly: bool,
}

/// Longest line of a chain, in characters.
const LONGEST_LINE: usize = 300;

impl UncheckedChain {
    pub(crate) fn new((kind, name): (UncheckedKind, String), chain: &Chain, source_text: &str, partly: bool) -> Self {
        let span = chain.sides.iter().fold(Span::default(), |span, side| span.join(side.span));
        let line = source(chain, source_text).unwrap_or_else(|| chain_line(chain));
        Self { kind, name, chain: line.chars().take(LONGEST_LINE).collect(), span, partly }
    }

    /// A formula that was not read to its end.
    pub(crate) fn unread(text: &str, formula: &Formula) -> Self {
        let source = text.get(formula.span.range()).unwrap_or_default();
        let start = source.split_whitespace().flat_map(|word| word.chars().chain([' '])).take(LONGEST_LINE / 4);
        let chain = start.collect::<String>() + "…";
        Self { kind: UncheckedKind::Unread, name: String::new(), chain, span: formula.span, partly: false }
    }

    /// A difference that is set aside.
    pub(crate) fn set_aside(finding: &ChainFinding, doubt: Doubt) -> Self {
        let (kind, name, chain) = (UncheckedKind::Doubt, doubt.reason().to_owned(), finding.chain.clone());
        Self { kind, name, chain, span: finding.span, partly: false }
    }

    /// The reason in words.
    pub fn reason(&self) -> String {
        let name = &self.name;
        match self.kind {
            UncheckedKind::Command => format!("`{name}` is not known"),
            UncheckedKind::Environment => format!("the environment `{name}` is not known"),
            UncheckedKind::Function => format!("the function `{name}` is not known"),
            UncheckedKind::Letter if name.is_empty() => "a letter has no value".to_owned(),
            UncheckedKind::Letter => format!("the letter {name} has no value"),
            UncheckedKind::Definition => format!("it only gives {name} a value"),
            UncheckedKind::Word => format!("`{name}` is no known unit"),
            UncheckedKind::Notation => name.clone(),
            UncheckedKind::Cut => "a side goes on outside the formula, or is missing".to_owned(),
            UncheckedKind::Denied => "the text asks whether it holds, or says that it does not".to_owned(),
            UncheckedKind::Unread => "too long, nested too deeply, or with macros that never end".to_owned(),
            UncheckedKind::Doubt => format!("set aside, since {name}"),
        }
    }
}

/// Longest chain that is shown as it is written, in bytes.
const LONGEST_SOURCE: usize = 2000;

/// The chain as it is written, on one line; none if it is long, or its braces cannot be closed.
fn source(chain: &Chain, text: &str) -> Option<String> {
    let span = chain.sides.iter().fold(Span::default(), |span, side| span.join(deep_span(&side.tokens)));
    let (mut start, mut end) = (span.start as usize, span.end as usize);
    if end.saturating_sub(start) > LONGEST_SOURCE {
        return None;
    }
    let closes_first = |part: &str| part.find('}').is_some_and(|close| !part[..close].contains('{'));
    if closes_first(text.get(start..end)?) {
        start = text[..start].rfind('\\').filter(|at| at + 40 > start)?;
    }
    let excess = |part: &str| part.matches('{').count().saturating_sub(part.matches('}').count());
    for _ in 0..excess(text.get(start..end)?) {
        end += usize::from(text.as_bytes().get(end) == Some(&b'}'));
    }
    let part = text.get(start..end).filter(|part| !part.is_empty() && excess(part) == 0)?;
    Some(part.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// The stretch that tokens and those inside them cover.
fn deep_span(tokens: &[Token]) -> Span {
    let inner = |token: &Token| token.inner().into_iter().fold(token.span, |span, inner| span.join(deep_span(inner)));
    tokens.iter().fold(Span::default(), |span, token| span.join(inner(token)))
}

/// Whether a side is a number apart from commands, environments and functions that may not be known: nothing in it is a letter.
pub(crate) fn is_numeric(side: &ChainSide) -> bool {
    has_number(&side.tokens) && first_letter(&side.tokens).is_none()
}

/// The first letter in tokens that stands for a quantity.
fn first_letter(tokens: &[Token]) -> Option<&str> {
    tokens.iter().enumerate().find_map(|(at, token)| match &token.kind {
        TokenKind::Name(name) if matches!(name.as_str(), "π" | "e" | "c") => None,
        TokenKind::Name(name) if is_called(name, tokens, at) => None,
        TokenKind::Name(name) => Some(name.as_str()),
        _ => token.inner().into_iter().find_map(first_letter),
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
        _ => token.inner().into_iter().find_map(|inner| first_unknown(inner, text)),
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
