//! The account of a check: what is printed, what both routes give and refuse, and the verdict beside the record.
//!
//! It is what a reader gets who lets a claim be checked, in a page or at the command line: the same characters in both. The
//! printed characters may be others than those of the document, to see that a check can fail.

use crate::tex::misprints;
use crate::told::finding_on;
use crate::{Check, Claim, Decimal, Judged, Ledger, PlainVerdict, Verdict, judge, judge_characters, sentences};
use std::panic::Location;

/// What was found when a claim was checked, in words.
#[derive(Clone, Debug)]
pub struct Account {
    /// The claim as it was judged.
    pub judged: Judged,
    /// How other characters were taken; none if those that are printed were judged.
    pub taken: Option<Taken>,
    /// What is told, each with its label, as plain text in one line.
    pub lines: Vec<(&'static str, String)>,
}

/// How a check takes characters that are put in the place of the printed ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taken {
    /// They are read, and what is found follows them.
    Read,
    /// They cannot be read, so they are neither right nor wrong.
    Unreadable,
    /// The check finds what it finds of the printed ones: it does not read them, or they say the same to it.
    Unread,
}

/// Most characters that may be put in the place of the printed ones.
pub const MOST_CHARACTERS: usize = 2000;

impl Account {
    /// The account of a claim as it is printed, with a near miss that both routes refuse.
    pub fn for_claim(claim: &'static Claim) -> Self {
        let judged = judge(claim);
        let near_miss = near_miss(&judged);
        Self::with(judged, None, near_miss)
    }

    /// The account of a claim as if other characters were printed in it.
    ///
    /// # Errors
    ///
    /// If there are more than [`MOST_CHARACTERS`]; the message says so.
    pub fn for_characters(claim: &'static Claim, printed: &str) -> Result<Self, String> {
        let count = printed.chars().count();
        if count > MOST_CHARACTERS {
            return Err(format!("{count} characters are too many: give at most {MOST_CHARACTERS}"));
        }
        if printed == claim.printed {
            return Ok(Self::for_claim(claim));
        }
        let judged = judge_characters(claim, printed.to_owned().into());
        // Numbers and equations are read.
        let finds_the_same = || {
            let as_printed = judge(claim);
            judged.findings == as_printed.findings && judged.faults == as_printed.faults
        };
        let may_be_unread = matches!(claim.check, Check::Statement { .. } | Check::Missing { .. });
        let taken = match (may_be_unread && finds_the_same(), judged.is_readable()) {
            (true, _) => Taken::Unread,
            (false, true) => Taken::Read,
            (false, false) => Taken::Unreadable,
        };
        // Of what is not read, it is told what is tried instead.
        let near_miss = if taken == Taken::Unread { near_miss(&judged) } else { None };
        Ok(Self::with(judged, Some(taken), near_miss))
    }

    fn with(judged: Judged, taken: Option<Taken>, near_miss: Option<String>) -> Self {
        let claim = judged.claim;
        let mut lines = Vec::new();
        let mut tell = |label, text: String| {
            if !text.is_empty() {
                lines.push((label, in_one_line(&text)));
            }
        };
        tell("Claim", format!("{}, {}: {}", claim.document, claim.locator, claim.meaning));
        if !judged.is_as_printed() {
            tell("Put in", claim.with_unit(&judged.printed));
        }
        tell("Printed", claim.with_unit(claim.printed));
        let evidence = claim.check.evidence();
        let number = |number: f64| claim.with_unit(&judged.rounded(number));
        let routes = evidence.iter().zip(claim.check.places()).zip([judged.computed, judged.witnessed]);
        for (label, ((kind, place), found)) in ["First route", "Second route"].into_iter().zip(routes) {
            let found = found.map_or_else(String::new, |found| format!("{}, ", number(found)));
            tell(label, format!("{found}by {}: {}", kind.name, file_and_line(place)));
        }
        tell("From the source’s rounded steps", judged.from_rounded.map(number).unwrap_or_default());
        let other_right = judged.right_value.filter(|right| judged.computed != Some(*right));
        // What is wrong in characters has others that are right.
        let corrected = || judged.corrected().filter(|_| judged.computed.is_none()).map(|text| claim.with_unit(&text));
        let right = other_right.map(|right| number(right) + &right_routes(claim)).or_else(corrected);
        tell("Right", right.unwrap_or_default());
        match taken {
            Some(Taken::Unread) => tell("Not read", NOT_READ.to_owned()),
            Some(Taken::Unreadable) => tell("Not read", UNREADABLE.to_owned()),
            _ => {}
        }
        tell("Found", found(&judged).join(" "));
        tell("Near miss", near_miss.unwrap_or_default());
        // What the class means is said of documents.
        let meaning = if judged.is_as_printed() { format!(": {}", judged.verdict.meaning()) } else { String::new() };
        tell("Verdict", format!("{}{meaning}", judged.plain().words()));
        tell("Record", record(&judged));
        tell("Stated in", file_and_line(claim.stated_at));
        tell("Test", claim.document.test.to_owned());
        Self { judged, taken, lines }
    }

    /// The account as text: a line for each thing that is told.
    ///
    /// ```no_run
    /// # static LEDGER: geneva_evidence::Ledger = geneva_evidence::Ledger::new(&[], &[]);
    /// let claim = LEDGER.claim("leaflet.fall-time").expect("a claim");
    /// print!("{}", geneva_evidence::Account::for_claim(claim).text());
    /// ```
    pub fn text(&self) -> String {
        self.lines.iter().map(|(label, text)| format!("{label}: {text}\n")).collect()
    }
}

/// A line of our code.
fn file_and_line(place: &Location<'_>) -> String {
    format!("{}:{}", place.file(), place.line())
}

/// The routes to a right number that is not the source's own; empty if it has none of its own.
fn right_routes(claim: &Claim) -> String {
    let Check::Number { right: Some(routes), .. } = &claim.check else { return String::new() };
    let [first, second] =
        routes.each_ref().map(|route| format!("by {}: {}", route.evidence.name, file_and_line(route.stated_at)));
    format!(", {first}, and {second}")
}

/// How a verdict stands to the one on record, in plain words.
fn record(judged: &Judged) -> String {
    let recorded = judged.recorded_plain();
    let verdict = match (judged.is_as_printed(), judged.verdict == judged.claim.expected) {
        (true, true) if judged.faults.is_empty() => "as recorded".to_owned(),
        (true, true) => String::new(),
        (true, false) if recorded != judged.plain() => {
            format!("recorded as {}, but found {}", recorded.words(), judged.plain().words())
        }
        // Two classes that are one word for readers.
        (true, false) => format!("recorded as {}, but found {}", judged.claim.expected, judged.verdict),
        (false, _) => format!("what is printed is {}", recorded.words()),
    };
    let said = [verdict].into_iter().filter(|verdict| !verdict.is_empty()).chain(judged.faults.iter().cloned());
    said.collect::<Vec<_>>().join("; ")
}

/// What is said of characters that a check does not read.
const NOT_READ: &str = "These characters change nothing in what the check finds. It does not read words: it tries what the claim says \
                        and a false version of it.";
/// What is said of characters that cannot be read.
const UNREADABLE: &str = "These characters cannot be read, so they are neither right nor wrong.";

/// What was found of the digits of a number, or of the form of anything else.
fn found(judged: &Judged) -> Vec<String> {
    let mut told = sentences(judged);
    if let Some(value) = judged.computed {
        told.push(match judged.printed.parse::<Decimal>() {
            Ok(printed) => digits(judged, &printed, value) + ".",
            Err(unreadable) => format!("{unreadable}."),
        });
    }
    told
}

/// How the digits of a number stand to what was computed.
fn digits(judged: &Judged, printed: &Decimal, value: f64) -> String {
    let computed = judged.rounded(value);
    let as_right = |told: String| match judged.right_value {
        Some(right) if right != value && !printed.is_rounding_of(right) => {
            format!("{told}; the right number is {}", judged.rounded(right))
        }
        _ => told,
    };
    if printed.is_rounding_of(value) {
        return as_right(format!("These digits are a rounding of {computed}"));
    }
    let no_rounding = format!("These digits are not a rounding of {computed}");
    if let Some(right) = judged.right_value.filter(|right| *right != value && printed.is_rounding_of(*right)) {
        let right = judged.rounded(right);
        return format!("{no_rounding}, which the source’s own way gives, but of the right number, {right}");
    }
    as_right(match (judged.verdict, judged.from_rounded) {
        (Verdict::Truncated, _) => format!("{no_rounding}, but its first digits, cut off"),
        (Verdict::ReadOff, _) => format!("{no_rounding}, but as near to it as they could be read off"),
        (_, Some(rounded)) if printed.is_rounding_of(rounded) => {
            format!("{no_rounding}, but of what the source’s own rounded steps give")
        }
        _ => no_rounding,
    })
}

/// A neighbour of what is printed and what the routes say of it; none where nothing is checked.
fn near_miss(judged: &Judged) -> Option<String> {
    let claim = judged.claim;
    match &claim.check {
        Check::Number { resolution, .. } => {
            let (first, second) = (judged.computed?, judged.witnessed?);
            let printed: Decimal = claim.printed.parse().ok()?;
            let reach = resolution.as_ref().map_or(0.0, |run| run());
            let unit = printed.unit_in_last_place().to_f64_fast();
            let nearest = (2.0 * reach / unit) as u32 + 1;
            let accepts = |digits: &Decimal, value: f64| {
                digits.is_rounding_of(value)
                    || reach == 0.0 && digits.is_truncation_of(value)
                    || (value - digits.to_f64()).abs() <= reach && reach > 0.0
            };
            // Beside digits that were cut off stand the rounded ones, which are right.
            let is_right = |digits: &Decimal| judged.right_value.is_some_and(|right| digits.is_rounding_of(right));
            let refused = |near: &String| {
                let refuses =
                    |digits: &Decimal| !accepts(digits, first) && !accepts(digits, second) && !is_right(digits);
                near.parse().is_ok_and(|digits| refuses(&digits))
            };
            // So many units of the last place more, or less.
            let beside =
                |step: u32| [1.0, -1.0].map(|side| printed.like(printed.to_f64() + side * f64::from(step) * unit));
            // A fraction has no last place.
            let last = claim.printed.rfind(|c: char| c.is_ascii_digit())?;
            let digits = (1..10).filter_map(|step| with_next_digit(claim.printed, last, step));
            let near = (nearest..nearest + MOST_STEPS).flat_map(beside).filter(|_| !claim.printed.contains('/'));
            let near = near.chain(digits).find(refused)?;
            Some(format!("{near} in its place: {}", refusals([false; 2])))
        }
        Check::Equation { .. } => {
            let refused = |tex: &str| claim.read_with(tex) == Some([Some(false); 2]);
            let misprint = misprints(claim.right_characters()).into_iter().find(|misprint| refused(&misprint.tex))?;
            let change = misprint.change.split_once(": ").map_or(&*misprint.change, |(_, change)| change);
            Some(format!("{} ({change}): {}", misprint.tex, refusals([false; 2])))
        }
        Check::Statement { neighbour, .. } => {
            let names = match neighbour {
                Some(_) => ["neighbour", "neighbour by the witness"],
                None => ["as printed", "as printed by the witness"],
            };
            let [first, second] = names.map(|name| finding_on(judged, name).map(|found| found.holds));
            Some(format!("{}: {}", neighbour.unwrap_or("what is printed itself"), refusals([first?, second?])))
        }
        Check::Missing { .. } => None,
    }
}

/// How many neighbours of a number are tried to either side.
const MOST_STEPS: u32 = 10;

/// Which of two routes refuse, of which it is known whether they accept.
fn refusals(accepted: [bool; 2]) -> &'static str {
    match accepted {
        [false, false] => "both routes refuse it",
        [false, true] => "the first route refuses it, the second accepts it",
        [true, false] => "the first route accepts it, the second refuses it",
        [true, true] => "both routes accept it",
    }
}

/// Characters with a digit at this place that is greater by so many, without a carry. None if that is the same digit again.
pub(crate) fn with_next_digit(printed: &str, at: usize, step: u32) -> Option<String> {
    let digit = printed[at..].chars().next()?.to_digit(10)?;
    let next = char::from_digit((digit + step) % 10, 10).filter(|_| step < 10)?;
    let mut other = printed.to_owned();
    other.replace_range(at..=at, next.encode_utf8(&mut [0; 4]));
    Some(other)
}

/// Text in one line, without a character that a terminal or a page would obey.
fn in_one_line(text: &str) -> String {
    let turns =
        |c: char| matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            c if c.is_control() || turns(c) => out.extend(c.escape_unicode()),
            c => out.push(c),
        }
    }
    out
}

impl Ledger {
    /// The reply to a question, as text: what a page asks that lets claims be checked.
    ///
    /// `list` gives the ids of all claims with their recorded verdicts, a line each, and `printed ID` the printed characters.
    /// `judge ID` derives the verdict. `account ID` gives its account, and with more lines that of the characters in them. Between
    /// the parts of a line stands a tab. The first line of a check is the derived verdict and the recorded one in plain words,
    /// `holds` or `differs`, and what contradicts the record; of other characters it may be `unread` or `unreadable` instead. A question that cannot be
    /// answered gets `error` and what to give.
    pub fn reply(&'static self, question: &str) -> String {
        self.replied(question).unwrap_or_else(|message| format!("error\t{}", in_one_line(&message)))
    }

    fn replied(&'static self, question: &str) -> Result<String, String> {
        let (line, characters) = question.split_once('\n').map_or((question, None), |(line, rest)| (line, Some(rest)));
        let (word, id) = line.split_once(' ').unwrap_or((line, ""));
        let claim = || self.claim(id).ok_or_else(|| format!("no claim has the id `{id}`"));
        let head = |judged: &Judged, taken: Option<Taken>| {
            let holds = match taken {
                Some(Taken::Unread) => "unread",
                Some(Taken::Unreadable) => "unreadable",
                _ if judged.matches_record() => "holds",
                _ => "differs",
            };
            let [found, recorded] = [judged.plain(), judged.recorded_plain()].map(PlainVerdict::words);
            let complaints = if judged.matches_record() { String::new() } else { in_one_line(&record(judged)) };
            format!("{found}\t{recorded}\t{holds}\t{complaints}")
        };
        match (word, characters) {
            ("list", None) => {
                let lines = self.claims().iter().map(|claim| format!("{}\t{}", claim.id, claim.expected));
                Ok(lines.collect::<Vec<_>>().join("\n"))
            }
            ("printed", None) => Ok(claim()?.printed.to_owned()),
            ("judge", None) => Ok(head(&judge(claim()?), None)),
            ("account", characters) => {
                let account = match characters {
                    Some(characters) => Account::for_characters(claim()?, characters)?,
                    None => Account::for_claim(claim()?),
                };
                let lines = account.lines.iter().map(|(label, text)| format!("\n{label}\t{text}"));
                Ok(head(&account.judged, account.taken) + &lines.collect::<String>())
            }
            _ => Err(
                "ask `list`, `printed ID`, `judge ID`, or `account ID` with other characters in the lines behind it"
                    .to_owned(),
            ),
        }
    }
}
