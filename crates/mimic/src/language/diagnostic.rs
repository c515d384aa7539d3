//! Mistakes in a deck: the card, the columns, what is allowed there, and the nearest known name.

use core::fmt;
use core::ops::Range;
use thiserror::Error;

/// Mistakes at a place of a card.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Problem {
    /// A sign that means nothing here.
    #[error("the character {0:?} has no meaning on a card; use letters, digits, and . + - * / ( ) , =")]
    Sign(char),
    /// Digits that are no number.
    #[error("{0} is not a number; write it as 2., .05, 57.3 or 5.E-6")]
    Number(String),
    /// A card of more characters than can be read.
    #[error("the card has {length} characters, but at most {most} are read; split it with another name")]
    TooLong {
        /// Its characters.
        length: usize,
        /// The most.
        most: usize,
    },
    /// More cards than are read.
    #[error("a deck has at most {0} lines up to its END, and this is one more; shorten it")]
    TooManyCards(usize),
    /// More on the cards than is read.
    #[error(
        "the cards up to here have more than {0} names, numbers and signs, the most that is read; shorten the deck"
    )]
    TooManyWords(usize),
    /// Parentheses in parentheses without end.
    #[error("parentheses are nested more than {0} deep; split the expression with another name")]
    TooDeep(usize),
    /// Something else was due.
    #[error("expected {expected}, but found {found}")]
    Expected {
        /// What was due.
        expected: &'static str,
        /// What stands there.
        found: String,
    },
    /// Two arithmetic signs in a row.
    #[error("two signs in a row; put the second one and its number in parentheses")]
    TwoSigns,
    /// A control field and a result, or a result and a difference.
    #[error(
        "{first} {second} {sign} … may be a result under {first}, or the result {first}; write = after the result, or no \
         blank before the sign"
    )]
    Ambiguous {
        /// The first name.
        first: String,
        /// The second name.
        second: String,
        /// The sign behind them.
        sign: char,
    },
    /// An unknown function.
    #[error("{name} is not a function{}; geneva mimic functions lists them", but_near(.nearest))]
    UnknownFunction {
        /// Its name.
        name: String,
        /// The nearest that is known.
        nearest: Option<String>,
    },
    /// An unknown control card.
    #[error("{name} is not a control card{}; the control cards are CON, PAR, FIN, HDR, OUT, PLO, SCA, ZER and END", but_near(.nearest))]
    UnknownCard {
        /// Its name.
        name: String,
        /// The nearest that is known.
        nearest: Option<String>,
    },
    /// A wrong number of arguments.
    #[error("{name} has {given}, but takes {allowed}")]
    Arguments {
        /// The function or card.
        name: String,
        /// How many are given.
        given: String,
        /// How many it takes.
        allowed: String,
    },
    /// A name that no card defines.
    #[error("no card defines {name}{hint}")]
    UnknownName {
        /// The name.
        name: String,
        /// What may be meant; empty if unknown.
        hint: String,
    },
    /// A control card where an expression is due.
    #[error(
        "{0} is a control card, not a function; write it by itself, without a result or a control variable before it"
    )]
    CardInExpression(String),
    /// A name that is already something else.
    #[error("{name} is {what}; give the result another name")]
    Reserved {
        /// The name.
        name: String,
        /// What it is.
        what: &'static str,
    },
    /// A second definition.
    #[error(
        "{name} is already defined on card {first}; two definitions of one name need two different logical control \
         variables"
    )]
    DefinedTwice {
        /// The name.
        name: String,
        /// The card of the first definition.
        first: usize,
    },
    /// A number where a truth is due, or a truth where a number is due.
    #[error("{what} must be a {expected}, but this is a {found}")]
    Type {
        /// What it is for.
        what: String,
        /// What it must be.
        expected: &'static str,
        /// What it is.
        found: &'static str,
    },
    /// Statements that wait for each other.
    #[error(
        "an algebraic loop: {}; each needs the next at the same time. An INT or a TDL in it would break it",
        circle(.names)
    )]
    Loop {
        /// The names, each of which needs the next, and the last the first.
        names: Vec<String>,
    },
    /// Initial values that wait for each other.
    #[error("an initial value that depends on itself: {}; let one of them begin with a number", circle(.names))]
    InitialLoop {
        /// The names, each of which needs the next.
        names: Vec<String>,
    },
    /// A function where it cannot be.
    #[error("{0}")]
    Misplaced(&'static str),
    /// Something that changes, where it must be known before the run.
    #[error("{what} must be known before the run, but {name} changes with it; use numbers, CON and PAR names")]
    NotConstant {
        /// What must be known.
        what: String,
        /// What changes.
        name: String,
    },
    /// A card that a deck must have.
    #[error("the deck has no {card} card; {why}")]
    Missing {
        /// The card.
        card: &'static str,
        /// What for.
        why: &'static str,
    },
    /// A card that follows nothing.
    #[error("{card} belongs after a PLO card; put it there, once")]
    WithoutPlot {
        /// The card.
        card: &'static str,
    },
    /// Text where the columns of a card part.
    #[error("in a deck with columns, {0}")]
    Column(&'static str),
    /// Data that are not as the cards ask.
    #[error("{0}")]
    Data(String),
}

/// The nearest name, in words behind others.
pub(super) fn but_near(name: &Option<String>) -> String {
    name.as_ref().map_or_else(String::new, |name| format!("; the nearest is {name}"))
}

fn circle(names: &[String]) -> String {
    /// Most names that are told.
    const MOST: usize = 20;
    let first = names.first().map_or("", String::as_str);
    let more = names.len().saturating_sub(MOST);
    let more = if more > 0 { format!(" → … ({more} more)") } else { String::new() };
    format!("{}{more} → {first}", names[..names.len().min(MOST)].join(" → "))
}

/// Whether a printer or a terminal would obey a sign instead of printing it: control characters but the tab, and those
/// that change the direction of writing.
pub(super) fn is_unprintable(sign: char) -> bool {
    let turns = matches!(sign, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    sign != '\t' && sign.is_control() || turns || matches!(sign, '\u{2028}' | '\u{2029}')
}

/// A problem, and where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// The file of data that it is about; none if it is about the deck.
    pub file: Option<String>,
    /// Number of the card in its file, counted from 1; 0 if it is about the whole deck.
    pub card: usize,
    /// The characters that it is about, counted from 0.
    pub columns: Range<usize>,
    /// The card.
    pub text: String,
    /// What is wrong.
    pub problem: Problem,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.card == 0 {
            return write!(f, "{}", self.problem);
        }
        let start = self.columns.start;
        match &self.file {
            Some(file) => write!(f, "{file}, line ")?,
            None => f.write_str("card ")?,
        }
        writeln!(f, "{}, column {}: {}", self.card, start + 1, self.problem)?;
        // A card as wide as a page shows the part in question.
        let cut = start.saturating_sub(60);
        let shown = self.text.chars().skip(cut).take(110);
        let shown: String = shown.map(|sign| if is_unprintable(sign) { '\u{fffd}' } else { sign }).collect();
        let shown = shown.replace('\t', " ");
        let length = self.columns.len().clamp(1, 110 - (start - cut));
        write!(f, "    {}\n    {}{}", shown.trim_end(), " ".repeat(start - cut), "^".repeat(length))
    }
}

/// All mistakes of a deck, in the order of its cards.
#[derive(Clone, Debug, PartialEq, Error)]
pub struct Diagnostics(pub Vec<Diagnostic>);

/// Most faults that are collected of cards, and of what does not fit together.
pub(super) const MOST_FAULTS: usize = 50_000;

/// Most faults that are listed, the first ones; the others are counted.
pub(super) const MOST_TOLD: usize = 50;

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, fault) in self.0.iter().take(MOST_TOLD).enumerate() {
            if number > 0 {
                writeln!(f)?;
            }
            write!(f, "{fault}")?;
        }
        match self.0.len().saturating_sub(MOST_TOLD) {
            0 => Ok(()),
            more => write!(f, "\nand {more} more; {} in all", self.0.len()),
        }
    }
}

impl Diagnostics {
    /// These in the order of the cards, if there are any.
    pub(super) fn check(mut faults: Vec<Diagnostic>) -> Result<(), Self> {
        faults.sort_by_key(|fault| (fault.card, fault.columns.start));
        faults.dedup();
        if faults.is_empty() { Ok(()) } else { Err(Self(faults)) }
    }
}

/// Names of functions in other languages, and their names in MIMIC.
const ELSEWHERE: [(&str, &str); 5] = [("LN", "LOG"), ("ALOG", "LOG"), ("SQRT", "SQR"), ("ATAN", "ATN"), ("TIME", "T")];

/// The known name that is nearest to a word, if one is near: the name of the same thing in another language, or one in
/// which at most two characters differ, are missing, are too many or are swapped.
///
/// ```
/// use geneva_mimic::language::nearest_to;
///
/// assert_eq!(nearest_to("SQRT", ["SIN", "SQR"]).as_deref(), Some("SQR")); // another language's name
/// assert_eq!(nearest_to("SNI", ["SIN", "SQR"]).as_deref(), Some("SIN")); // two letters swapped
/// assert_eq!(nearest_to("VELOCITY", ["SIN", "SQR"]), None);
/// ```
pub fn nearest_to<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    let known: Vec<&str> = known.into_iter().collect();
    let same = ELSEWHERE.iter().find(|(other, _)| *other == word).map(|(_, own)| *own);
    if let Some(same) = same.filter(|same| known.contains(same)) {
        return Some(same.to_owned());
    }
    let signs = word.chars().count();
    let most = if signs < 3 { 1 } else { 2 };
    let may_be = |name: &&str| *name != word && name.chars().count().abs_diff(signs) <= most;
    let near = known.into_iter().filter(may_be).map(|name| (strsim::osa_distance(word, name), name));
    near.filter(|(distance, name)| *distance <= most && *distance < name.len().max(word.len()))
        .min()
        .map(|(_, name)| name.to_owned())
}
