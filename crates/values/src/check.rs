//! The check: each entry of a record against its text and its values.

use crate::comparison::{Comparison, as_printed, compare, neighbours_passed, rounded, written_like};
use crate::numbered_text::{PrintedNumber, WORDS};
use crate::places::{Placement, place};
use crate::project::{Project, ProjectText};
use crate::record_file::{NumberEntry, Tie};
use crate::values::{ComputedValue, Values};
use geneva_evidence::{PlainVerdict, nearest_name};
use geneva_exact::Rational;
use geneva_fields::joined_with_and;
use proofread::reader::LeftOut;
use proofread::{LineColumn, LineIndex};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// What was found of a number, an entry or a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FindingKind {
    /// The value rounds to the printed digits; with a second value, both do.
    Right,
    /// The number is no value, and is printed as it is recorded.
    NoValue,
    /// The printed number differs from the rounded value by one unit of its last place.
    LastDigit,
    /// The printed number is another one.
    Stale,
    /// The digits are right, but in another unit or scale.
    UnitOrScale,
    /// The two values disagree, or there is only one of two.
    Open,
    /// Nobody has decided yet what the number is tied to.
    Undecided,
    /// A number that is no value is printed in another way than it is recorded.
    Changed,
    /// The number has no entry.
    Untied,
    /// No value has the key of the entry.
    UnknownKey,
    /// The number of the entry isn't in the text.
    Missing,
}

impl FindingKind {
    /// All kinds with their names and with what they mean.
    pub const ALL: [(Self, &'static str, &'static str); 11] = [
        (Self::Right, "right", "the value rounds to the printed digits"),
        (Self::NoValue, "no-value", "the number is no value and is printed as it is recorded"),
        (Self::LastDigit, "last-digit", "the last printed digit differs by one"),
        (Self::Stale, "stale", "the value is another one now"),
        (Self::UnitOrScale, "unit-or-scale", "the digits are right in another unit or scale"),
        (Self::Open, "open", "the two values disagree, or one of them is missing"),
        (Self::Undecided, "undecided", "the record does not say what the number is tied to"),
        (Self::Changed, "changed", "a number that is no value is printed in another way than it is recorded"),
        (Self::Untied, "untied", "the number belongs to nothing: it has no entry in the record"),
        (Self::UnknownKey, "unknown-key", "no value has the key that the entry names"),
        (Self::Missing, "missing", "the number of the entry is not in the text"),
    ];

    /// Its name in JSON and SARIF.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// What it means.
    pub fn meaning(self) -> &'static str {
        Self::ALL[self as usize].2
    }

    /// Whether there is nothing to do.
    pub fn is_right(self) -> bool {
        matches!(self, Self::Right | Self::NoValue)
    }

    /// Whether what is printed is right, wrong or open.
    pub fn verdict(self) -> PlainVerdict {
        match self {
            Self::Right | Self::NoValue => PlainVerdict::Right,
            Self::LastDigit | Self::Stale | Self::UnitOrScale | Self::Changed => PlainVerdict::Wrong,
            Self::Open | Self::Undecided | Self::Untied | Self::UnknownKey | Self::Missing => PlainVerdict::Open,
        }
    }
}

/// A number, an entry or a value, and what was found of it.
#[derive(Clone, Debug)]
pub struct NumberFinding {
    /// What was found.
    pub kind: FindingKind,
    /// The text, as people are shown its path.
    pub text: PathBuf,
    /// Where the number begins and ends in the text; none if it isn't there.
    pub at: Option<[LineColumn; 2]>,
    /// The words before the number; another number among them is `#`.
    pub before: String,
    /// The printed characters in one spelling, without the unit.
    pub printed: String,
    /// The printed unit in one spelling; empty if there is none.
    pub unit: String,
    /// The key of the value.
    pub key: Option<String>,
    /// What the number is if it is no value: given, a date, a reference, or quoted from a work.
    pub none: Option<String>,
    /// The value as its file has it.
    pub value: Option<String>,
    /// The value of the second file.
    pub second: Option<String>,
    /// How the value would be printed.
    pub write: Option<String>,
    /// What there is to say, in one sentence without a full stop.
    pub message: String,
    /// How many of the two neighbours of a right number its values round to as well.
    pub neighbours_passed: usize,
}

/// All that a check found.
#[derive(Clone, Debug, Default)]
pub struct NumbersReport {
    /// The numbers in the order of the texts, then the entries without one.
    pub findings: Vec<NumberFinding>,
    /// How many texts were read.
    pub texts: usize,
    /// How many files with second values there are.
    pub has_second: bool,
    /// Keys of values that no number is tied to.
    pub unused: Vec<String>,
    /// How many stretches with digits were not read, by kind.
    pub left_out: BTreeMap<LeftOut, usize>,
}

impl NumbersReport {
    /// How many findings there are of a kind.
    pub fn count(&self, kind: FindingKind) -> usize {
        self.findings.iter().filter(|finding| finding.kind == kind).count()
    }

    /// Whether everything is right.
    pub fn is_right(&self) -> bool {
        self.findings.iter().all(|finding| finding.kind.is_right())
    }
}

/// Checks the texts of a record, which is named by its path or its folder. `is_staged` reads all files as they are staged in git.
///
/// # Errors
///
/// A file cannot be read. The message names it, and what to give instead.
pub fn check(record: &Path, is_staged: bool) -> Result<NumbersReport, String> {
    let project = Project::open(record, is_staged)?;
    let (values, second) = project.values()?;
    let texts = project.texts()?;
    let mut report = NumbersReport { texts: texts.len(), has_second: second.is_some(), ..NumbersReport::default() };
    let mut used = BTreeSet::new();
    let mut missing = Vec::new();
    for text in &texts {
        for (kind, count) in &text.numbered.left_out {
            *report.left_out.entry(*kind).or_default() += count;
        }
        let entries: Vec<&NumberEntry> =
            project.record.entries.iter().filter(|entry| entry.text == text.name).collect();
        let placement = place(&entries, &text.numbered);
        let judge = Judge { text, lines: LineIndex::new(&text.source), values: &values, second: second.as_ref() };
        for (at, number) in text.numbered.numbers.iter().enumerate() {
            let entry = placement.of_number[at];
            let is_ambiguous = entry.is_some_and(|entry| placement.is_ambiguous[entry]);
            report.findings.push(judge.number(number, entry.map(|entry| entries[entry]), is_ambiguous));
        }
        missing.extend(missing_entries(&entries, &placement, text));
    }
    report.findings.extend(missing);
    for entry in &project.record.entries {
        match &entry.tie {
            Tie::Value { key, .. } => drop(used.insert(key.as_str())),
            Tie::Candidates(keys) => used.extend(keys.iter().map(String::as_str)),
            Tie::None(_) | Tie::Open => {}
        }
    }
    let keys = values.computed().iter().map(|value| &value.key);
    report.unused = keys.filter(|key| !used.contains(key.as_str())).cloned().collect();
    Ok(report)
}

/// The entries whose number isn't in the text.
fn missing_entries(entries: &[&NumberEntry], placement: &Placement, text: &ProjectText) -> Vec<NumberFinding> {
    let lost = entries.iter().zip(&placement.of_entry).filter(|(_, number)| number.is_none());
    let finding = |(entry, _): (&&NumberEntry, _)| NumberFinding {
        kind: FindingKind::Missing,
        text: text.path.clone(),
        at: None,
        before: entry.before.clone(),
        printed: entry.printed.clone(),
        unit: entry.unit.clone(),
        key: match &entry.tie {
            Tie::Value { key, .. } => Some(key.clone()),
            _ => None,
        },
        none: None,
        value: None,
        second: None,
        write: None,
        message: format!(
            "{} is not in the text, recorded after \"{}\"; take the entry out with `geneva record --prune`",
            with_unit(&entry.printed, &entry.unit),
            entry.before
        ),
        neighbours_passed: 0,
    };
    lost.map(finding).collect()
}

/// A number with its unit behind it.
pub(crate) fn with_unit(number: &str, unit: &str) -> String {
    match unit {
        "" => number.to_owned(),
        "%" | "°" => format!("{number}{unit}"),
        unit => format!("{number} {unit}"),
    }
}

struct Judge<'p> {
    text: &'p ProjectText,
    lines: LineIndex<'p>,
    values: &'p Values,
    second: Option<&'p Values>,
}

impl Judge<'_> {
    fn number(&self, number: &PrintedNumber, entry: Option<&NumberEntry>, is_ambiguous: bool) -> NumberFinding {
        let mut finding = NumberFinding {
            kind: FindingKind::Untied,
            text: self.text.path.clone(),
            at: Some(self.lines.line_columns(number.span)),
            before: self.text.numbered.words_around(number, WORDS[0])[0].clone(),
            printed: number.printed.clone(),
            unit: number.unit.clone(),
            key: None,
            none: None,
            value: None,
            second: None,
            write: None,
            message: String::new(),
            neighbours_passed: 0,
        };
        let shown = with_unit(&number.printed, &number.unit);
        match entry.map(|entry| (&entry.tie, entry)) {
            None => {
                finding.message =
                    format!("{shown} belongs to nothing; run `geneva record` to propose what it is tied to")
            }
            Some((Tie::Open, _)) => {
                finding.kind = FindingKind::Undecided;
                finding.message = format!("{shown} is open in the record; give it a `value` or a `none`");
            }
            Some((Tie::Candidates(keys), _)) => {
                finding.kind = FindingKind::Undecided;
                finding.message = format!("{shown} may be any of {}; choose one as its `value`", joined_with_and(keys));
            }
            Some((Tie::None(kind), entry)) => {
                let is_same = entry.printed == number.printed && entry.unit == number.unit;
                // Sections and figures are numbered anew by others.
                let may_change = kind == "reference";
                finding.kind = if is_same || may_change { FindingKind::NoValue } else { FindingKind::Changed };
                finding.none = Some(kind.clone());
                let before = with_unit(&entry.printed, &entry.unit);
                finding.message = match is_same {
                    true => format!("{shown} is no value: {kind}"),
                    false => {
                        format!("printed {shown}, recorded {before} as {kind}; run `geneva record` if that is meant")
                    }
                };
            }
            Some((Tie::Value { key, factor }, _)) => self.value(number, key, factor.as_ref(), &mut finding),
        }
        if is_ambiguous && !finding.kind.is_right() {
            finding.message += " (the same words are around other numbers, so the order decided which is meant)";
        }
        finding
    }

    fn value(&self, number: &PrintedNumber, key: &str, factor: Option<&Rational>, finding: &mut NumberFinding) {
        finding.key = Some(key.to_owned());
        let shown = with_unit(&number.printed, &number.unit);
        let Some(value) = self.values.get(key) else {
            let near = nearest_name(key, self.values.computed().iter().map(|value| value.key.as_str()));
            let near = near.map(|near| format!("; the nearest key is {near}")).unwrap_or_default();
            finding.kind = FindingKind::UnknownKey;
            finding.message = format!("{shown} is tied to {key}, which no file of values has{near}");
            return;
        };
        finding.value = Some(value_shown(value));
        let target = as_printed(number, value, factor);
        let comparison = compare(number, value, factor);
        finding.kind = kind_of(&comparison);
        finding.write = target.as_ref().filter(|_| comparison != Comparison::Right).map(|of| written_like(number, of));
        finding.message = told(&shown, key, value, &comparison, finding.write.as_deref(), &number.unit);
        if comparison == Comparison::Right {
            finding.neighbours_passed = neighbours_passed(number, value, factor);
        }
        let Some(second) = self.second else { return };
        let Some(other) = second.get(key) else {
            finding.kind = FindingKind::Open;
            finding.write = None;
            finding.message = format!("{shown} has one value {key} = {}, and no second one", value_shown(value));
            return;
        };
        finding.second = Some(value_shown(other));
        let second = compare(number, other, factor);
        let places = number.decimal.places();
        let agree = || {
            let [one, two] = [target, as_printed(number, other, factor)];
            one.zip(two).is_some_and(|(one, two)| rounded(&one, places) == rounded(&two, places))
        };
        match (comparison == Comparison::Right, second == Comparison::Right) {
            (true, true) => {
                let passed = neighbours_passed(number, other, factor);
                finding.neighbours_passed = finding.neighbours_passed.min(passed);
            }
            (false, false) if agree() => {
                finding.message += &format!("; the second value {} agrees", value_shown(other))
            }
            _ => {
                finding.kind = FindingKind::Open;
                finding.write = None;
                finding.message = format!(
                    "printed {shown}, but the two values of {key} disagree: {} and {}",
                    value_shown(value),
                    value_shown(other)
                );
            }
        }
    }
}

fn kind_of(comparison: &Comparison) -> FindingKind {
    match comparison {
        Comparison::Right => FindingKind::Right,
        Comparison::LastDigit => FindingKind::LastDigit,
        Comparison::Scaled(_) | Comparison::OtherQuantity => FindingKind::UnitOrScale,
        Comparison::Other => FindingKind::Stale,
    }
}

/// A value as its file has it, with its unit.
fn value_shown(value: &ComputedValue) -> String {
    with_unit(&value.characters, value.unit.as_deref().unwrap_or_default())
}

fn told(
    shown: &str,
    key: &str,
    value: &ComputedValue,
    comparison: &Comparison,
    write: Option<&str>,
    unit: &str,
) -> String {
    let computed = value_shown(value);
    let write = write.map(|write| with_unit(write, unit)).unwrap_or_default();
    match comparison {
        Comparison::Right => format!("{shown} is {key} = {computed}"),
        Comparison::LastDigit => format!("printed {shown}, {key} is {computed}: the last digit is off; write {write}"),
        Comparison::Other => format!("printed {shown}, {key} is {computed} now; write {write}"),
        Comparison::Scaled(by) => {
            format!("printed {shown}, {key} is {computed}: the printed number is the value times {by}; write {write}")
        }
        Comparison::OtherQuantity => {
            format!("printed {shown}, {key} is {computed}: the units measure different things")
        }
    }
}
