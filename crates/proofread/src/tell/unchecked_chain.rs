//! Chains that were not checked, as they are listed.

use crate::join::chain::Chain;
use crate::judge::doubt::Doubt;
use crate::judge::unchecked::UncheckedKind;
use crate::reader::Formula;
use crate::tell::finding::{ChainFinding, chain_line};
use crate::token::{Span, Token};

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

    /// A fence of code that is not read, with its language, shown by its first line with an equals sign.
    pub(crate) fn in_fence(text: &str, span: Span, language: String) -> Self {
        let mut lines = text.get(span.range()).unwrap_or_default().lines();
        let line = lines.find(|line| line.contains(['=', '≈'])).unwrap_or_default();
        let chain = line.trim().chars().take(LONGEST_LINE).collect();
        Self { kind: UncheckedKind::Fence, name: language, chain, span, partly: false }
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
            UncheckedKind::Fence if name.is_empty() => "a fence without a language is not read".to_owned(),
            UncheckedKind::Fence => format!("a fence of `{name}` is not read"),
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
    let inner = |token: &Token| token.inner().fold(token.span, |span, inner| span.join(deep_span(inner)));
    tokens.iter().fold(Span::default(), |span, token| span.join(inner(token)))
}
