//! Definitions in LaTeX: commands and units that an author names.

use crate::effort;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::sync::Arc;

/// Most definitions that are kept of one text.
const MOST: usize = 2000;

/// A macro of the document: how many arguments it takes, the first one's default if it is optional, and what it stands for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Macro {
    pub arguments: usize,
    pub default: Option<String>,
    pub body: String,
    /// Whether it is a unit of siunitx, which is none outside of a quantity.
    pub unit: bool,
}

/// Most characters that the macros of one formula may add.
const MOST_IN_FORMULA: usize = 20_000;
/// Most characters that the macros of a document may add: so many, and so many more for each of its own.
const MOST_IN_ALL: [usize; 2] = [500_000, 10];

/// Macros by name without the backslash.
pub(crate) type NamedMacros = HashMap<Arc<str>, Arc<Macro>>;

/// The macros of a document: its own, and those that are defined elsewhere.
#[derive(Clone, Debug, Default)]
pub(crate) struct Macros<'d> {
    own: NamedMacros,
    elsewhere: Option<&'d NamedMacros>,
    /// How many characters they may still add.
    left: Cell<usize>,
    /// Those that added too many to a formula, and are not used any more.
    endless: RefCell<NamedMacros>,
    /// Whether the text is in Markdown, where a sign of per cent may lack its backslash.
    markdown: bool,
}

impl<'d> Macros<'d> {
    /// Those that a part of a document of so many bytes defines, and those that are defined for it elsewhere.
    pub(super) fn from_text(part: &str, bytes: usize, elsewhere: Option<&'d NamedMacros>) -> Self {
        let [some, each] = MOST_IN_ALL;
        let left = Cell::new(bytes.saturating_mul(each).saturating_add(some));
        Self { own: named_macros(part), elsewhere, left, ..Self::default() }
    }

    /// These of a text in Markdown.
    pub(super) fn in_markdown(self) -> Self {
        Self { markdown: true, ..self }
    }

    /// Whether the text is in Markdown.
    pub(super) fn is_markdown(&self) -> bool {
        self.markdown
    }

    /// Whether they may add so many characters, `expanded` of them in the formula at hand; these are counted.
    pub(super) fn may_add(&self, characters: usize, expanded: usize) -> bool {
        effort::count_steps(characters);
        let left = self.left.get().checked_sub(characters);
        self.left.set(left.unwrap_or_default());
        left.is_some() && expanded <= MOST_IN_FORMULA
    }

    /// Notes a macro that is not to be used any more.
    pub(super) fn give_up(&self, name: &str) {
        let known = self.own.get_key_value(name).or_else(|| self.elsewhere?.get_key_value(name));
        if let Some((name, of)) = known {
            self.endless.borrow_mut().insert(name.clone(), of.clone());
        }
    }

    /// Whether a macro has been given up.
    pub(super) fn is_endless(&self, name: &str) -> bool {
        self.endless.borrow().contains_key(name)
    }

    /// What a name stands for; the document's own definition counts first.
    pub(super) fn get(&self, name: &str) -> Option<&Macro> {
        self.in_quantity(name).filter(|of| !of.unit)
    }

    /// What a name stands for in a quantity of siunitx.
    pub(super) fn in_quantity(&self, name: &str) -> Option<&Macro> {
        self.own.get(name).or_else(|| self.elsewhere?.get(name)).map(AsRef::as_ref)
    }

    /// All names with what they stand for.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&str, &Macro)> {
        self.own.iter().chain(self.elsewhere.into_iter().flatten()).map(|(name, of)| (name.as_ref(), of.as_ref()))
    }
}

/// What LaTeX texts define: commands, operators, and units of siunitx.
///
/// A document is read with the definitions of other texts, such as its preamble, a file of macros, a package or a class, if they are
/// given in [`CheckOptions::definitions`](crate::CheckOptions::definitions).
///
/// ```
/// use proofread::{Definitions, TextFormat, CheckOptions, proofread};
///
/// let definitions = Definitions::from_latex(r"\newcommand{\half}{\frac{1}{2}} \newcommand{\hint}[1]{}");
/// let options = CheckOptions { definitions: Some(&definitions), ..CheckOptions::default() };
/// let report = proofread(r"\hint{$1 + 1 = 3$} $3\half = 1.5$ and $3\half = 1.6$", TextFormat::Latex, options)?;
/// assert_eq!((report.tally.checked, report.findings.len()), (2, 1));
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Definitions(pub(crate) NamedMacros);

impl Definitions {
    /// The definitions in a text, be it a document, a part of one, a package or a class.
    ///
    /// If a name is defined twice, the last definition counts, unless it drops arguments that the one before keeps. What the program can't use is left out: names with other signs than
    /// letters, and arguments that are more than mandatory or optional ones in brackets.
    pub fn from_latex(text: &str) -> Self {
        Self(named_macros(text))
    }

    /// Adds the definitions of a text that is read later; where both define a name, the later definition counts.
    ///
    /// ```
    /// use proofread::Definitions;
    ///
    /// let mut both = Definitions::from_latex(r"\newcommand{\half}{0.5}");
    /// both.add(&Definitions::from_latex(r"\newcommand{\half}{\frac{1}{2}}"));
    /// assert_eq!(both, Definitions::from_latex(r"\newcommand{\half}{\frac{1}{2}}"));
    /// ```
    pub fn add(&mut self, later: &Self) {
        self.0.extend(later.0.iter().map(|(name, of)| (name.clone(), of.clone())));
    }
}

/// Commands, without their backslash, that define another one.
const DEFINING: [&str; 11] = [
    "newcommand",
    "renewcommand",
    "providecommand",
    "DeclareRobustCommand",
    "NewDocumentCommand",
    "RenewDocumentCommand",
    "ProvideDocumentCommand",
    "DeclareDocumentCommand",
    "DeclareMathOperator",
    "DeclareSIUnit",
    "def",
];

/// Whether a command, without its backslash, defines another one.
pub(crate) fn defines(command: &str) -> bool {
    DEFINING.contains(&command)
}

/// Whether a command that defines another one may be in a text, also in one whose backslashes are escaped.
pub(super) fn may_define(text: &str) -> bool {
    text.match_indices('\\').any(|(at, _)| DEFINING.iter().any(|command| text[at + 1..].starts_with(command)))
}

/// Where a drawing ends that begins behind the backslash; what it defines holds in it alone.
fn end_of_drawing(rest: &str) -> Option<usize> {
    const DRAWINGS: [&str; 4] = ["tikzpicture", "axis", "circuitikz", "pspicture"];
    let inner = rest.strip_prefix("begin{")?;
    let name = DRAWINGS.into_iter().find(|name| inner.strip_prefix(name).is_some_and(|rest| rest.starts_with('}')))?;
    Some(rest.find(&format!("\\end{{{name}}}")).unwrap_or(rest.len()))
}

/// The macros that a text defines.
pub(crate) fn named_macros(text: &str) -> NamedMacros {
    let mut out = NamedMacros::new();
    let mut at = 0;
    while let Some(found) = text.as_bytes()[at..].iter().position(|c| b"\\%".contains(c)).map(|found| at + found) {
        at = found + 1;
        let rest = &text[at..];
        if text.as_bytes()[found] == b'%' {
            at += rest.find('\n').unwrap_or(rest.len());
            continue;
        }
        let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        if length == 0 {
            // What is escaped begins nothing.
            at += rest.chars().next().map_or(0, char::len_utf8);
        } else if let Some(end) = end_of_drawing(rest) {
            at += end;
        } else if defines(&rest[..length])
            && let Some((name, meaning, end)) = definition(text, found)
        {
            // A version for some readers hides what the author has written for others.
            let hides = meaning.arguments > 0 && meaning.body.trim().is_empty();
            let shown = hides && out.get(name.as_str()).is_some_and(|of: &Arc<Macro>| !of.body.trim().is_empty());
            if out.len() < MOST && !shown {
                out.insert(name.into(), Arc::new(meaning));
            }
            at = end;
        } else {
            at += length;
        }
    }
    // What stands for itself would never end.
    out.retain(|name, of| {
        let uses = of
            .body
            .match_indices(&format!("\\{name}"))
            .any(|(at, found)| !of.body[at + found.len()..].starts_with(|c: char| c.is_ascii_alphabetic()));
        !uses
    });
    out
}

/// The definition that begins with the backslash at `at`: name, meaning, and the byte behind it.
pub(crate) fn definition(text: &str, at: usize) -> Option<(String, Macro, usize)> {
    let command: String = text[at + 1..].chars().take_while(char::is_ascii_alphabetic).collect();
    let mut rest = DefinitionText { text, at: at + 1 + command.len() };
    rest.skip("*");
    if command == "DeclareSIUnit" {
        rest.bracketed_text();
    }
    let name = match rest.braced() {
        Some(name) => name.trim().trim_start_matches('\\').to_owned(),
        None => rest.command()?,
    };
    let mut meaning = Macro::default();
    if command == "def" {
        while rest.skip("#") {
            rest.at += 1;
            meaning.arguments += 1;
        }
    } else if command.ends_with("DocumentCommand") {
        (meaning.arguments, meaning.default) = signature(&rest.braced()?)?;
    } else if let Some(count) = rest.bracketed_text() {
        meaning.arguments = count.trim().parse().ok().filter(|count| *count <= 9)?;
        meaning.default = rest.bracketed_text();
    }
    meaning.body = rest.braced()?;
    meaning.unit = command == "DeclareSIUnit";
    if command == "DeclareMathOperator" {
        meaning.body = format!("\\mathrm{{{}}}", meaning.body);
    }
    let usable =
        !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic()) && name != "text" && name != "mathrm";
    usable.then_some((name, meaning, rest.at))
}

/// The arguments of a document command such as `O{2} m m`: how many, and the first one's default if it is optional.
fn signature(text: &str) -> Option<(usize, Option<String>)> {
    let mut rest = DefinitionText { text: text.trim(), at: 0 };
    let default = if rest.skip("O") { Some(rest.braced()?) } else { None };
    let kinds = rest.text[rest.at..].chars().filter(|c| !c.is_whitespace() && *c != '+');
    let count = kinds.clone().count() + usize::from(default.is_some());
    (count <= 9 && kinds.clone().all(|c| c == 'm')).then_some((count, default))
}

/// Where the group ends whose signs behind the opening one are given with their places.
pub(crate) fn closing(signs: impl Iterator<Item = (usize, char)>, open: char, close: char) -> Option<usize> {
    let (mut depth, mut escaped) = (1usize, false);
    for (at, c) in signs {
        if escaped {
            escaped = false;
        } else if c == '\\' {
            escaped = true;
        } else if c == open {
            depth += 1;
        } else if c == close {
            depth -= 1;
            if depth == 0 {
                return Some(at);
            }
        }
    }
    None
}

struct DefinitionText<'t> {
    text: &'t str,
    at: usize,
}

impl DefinitionText<'_> {
    fn skip(&mut self, what: &str) -> bool {
        let found = self.text.get(self.at..).is_some_and(|rest| rest.starts_with(what));
        self.at += if found { what.len() } else { 0 };
        found
    }

    fn braced(&mut self) -> Option<String> {
        self.text_between('{', '}')
    }

    fn bracketed_text(&mut self) -> Option<String> {
        self.text_between('[', ']')
    }

    fn text_between(&mut self, open: char, close: char) -> Option<String> {
        let rest = self.text.get(self.at..)?;
        let space = rest.len() - rest.trim_start().len();
        let inner = rest[space..].strip_prefix(open)?;
        let at = closing(inner.char_indices().take(2000), open, close)?;
        self.at += space + 1 + at + 1;
        Some(inner[..at].to_owned())
    }

    fn command(&mut self) -> Option<String> {
        let rest = self.text.get(self.at..)?;
        let space = rest.len() - rest.trim_start().len();
        let name: String = rest[space..].strip_prefix('\\')?.chars().take_while(char::is_ascii_alphabetic).collect();
        self.at += space + 1 + name.len();
        Some(name)
    }
}
