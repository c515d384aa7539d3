//! What is found in a text, with its places as a page counts them.

use crate::fact::Fact;
use crate::json::{list, object, text};
use crate::question::PageQuestion;
use crate::words;
use proofread::summary::describe_less_certain;
use proofread::{
    ChainFinding, CheckOptions, FindingGroup, LineIndex, ReportSection, TextFormat, group_findings, proofread,
};
use std::ops::Range;

/// Findings that are shown at most.
const MOST_SHOWN: usize = 200;

/// Other places of a finding that are shown at most.
const MOST_PLACES: usize = 20;

/// Findings for which a hint is searched at most.
const MOST_HINTS: usize = 60;

/// What was found in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct PageAnswer {
    /// What the text was read as.
    pub format: TextFormat,
    /// What was checked and what was found, in sentences.
    pub summary: Vec<String>,
    /// The first findings, in the order of the text, and behind them those that are less certain.
    pub findings: Vec<ShownFinding>,
    /// How many differences are less certain, in words; empty if none is.
    pub less_certain: String,
}

/// A finding as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownFinding {
    /// Its list: `numbers`, `units`, `bindings`, `doubts` or `less-certain`.
    pub list: &'static str,
    /// The verdict in words.
    pub verdict: &'static str,
    /// The line of the place to look at, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// The place in the text as a page counts it: in units of UTF-16.
    pub place: Range<usize>,
    /// The chain up to the place, the place, and what is behind it.
    pub chain: [String; 3],
    /// What is known about it.
    pub facts: Vec<Fact>,
    /// The other places of the same shape, the first ones.
    pub others: Vec<ShownPlace>,
    /// How many further ones there are.
    pub more: usize,
}

/// A place of a finding.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownPlace {
    /// The line of the place to look at, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// The place in the text as a page counts it: in units of UTF-16.
    pub place: Range<usize>,
}

impl PageAnswer {
    /// Proofreads the text of a question.
    ///
    /// # Errors
    ///
    /// In words, if the text cannot be read in its format.
    ///
    /// ```
    /// use geneva_proofread_page::{PageAnswer, PageQuestion};
    ///
    /// let answer = PageAnswer::for_question(&PageQuestion::new("It is $2 + 2 = 5$."))?;
    /// let finding = &answer.findings[0];
    /// assert_eq!((finding.line, finding.column, finding.chain.concat().as_str()), (1, 16, "2 + 2 = 5"));
    /// assert!(answer.to_text().starts_with("line 1, column 16: the two sides differ\n"));
    /// # Ok::<(), String>(())
    /// ```
    pub fn for_question(question: &PageQuestion<'_>) -> Result<Self, String> {
        let by_name = || TextFormat::from_extension(question.extension);
        let format = question.format.or_else(by_name).unwrap_or_else(|| TextFormat::recognise(question.text));
        let hints = if question.hints { MOST_HINTS } else { 0 };
        let options = CheckOptions { name_policy: question.name_policy, hints, ..CheckOptions::default() };
        let report = proofread(question.text, format, options).map_err(|why| words::capitalised(&why.to_string()))?;
        let wanted = |finding: &&ChainFinding| match finding.section {
            ReportSection::Units => question.units,
            ReportSection::Doubts => question.doubts,
            // The page folds those that are less certain.
            ReportSection::Numbers
            | ReportSection::Bindings
            | ReportSection::Agreeing
            | ReportSection::Statistics
            | ReportSection::LessCertain => true,
        };
        let mut report = report;
        let mut findings = std::mem::take(&mut report.findings);
        findings.retain(|finding| wanted(&finding));
        let is_folded = |of: &FindingGroup| of.finding.section == ReportSection::LessCertain;
        let (folded, mut found): (Vec<_>, Vec<_>) = group_findings(findings).into_iter().partition(is_folded);
        let less_certain = describe_less_certain(folded.iter().map(FindingGroup::place_count).sum());
        found.extend(folded);
        let mut places = PlacedText::new(question.text);
        let findings = found.iter().take(MOST_SHOWN).map(|group| places.show(group)).collect();
        let mut summary = words::summary(question, format, &report, &found);
        if found.len() > MOST_SHOWN {
            summary.push(format!("The first {MOST_SHOWN} are shown. The command lists them all."));
        }
        if question.hints && found.iter().map(FindingGroup::place_count).sum::<usize>() > MOST_HINTS {
            summary.push(format!("Hints were searched for at most the first {MOST_HINTS}."));
        }
        Ok(Self { format, summary, findings, less_certain: less_certain.unwrap_or_default() })
    }

    /// The answer as a JSON object: `format`; `summary`, a list of sentences; `less_certain`, how many differences are so; `findings`, each with `list`, `verdict`, `line`,
    /// `column`, `from` and `to`, `chain` in three pieces, `facts`, a list of `label` and `text`, `others`, the first of the other
    /// places with `line`, `column`, `from` and `to`, and `more`, how many there are beside these; `text`, all of it to be copied.
    pub fn to_json(&self) -> String {
        let finding = |shown: &ShownFinding| {
            let fact = |fact: &Fact| object([("label", text(fact.label)), ("text", text(&fact.text))]);
            let other = |of: &ShownPlace| {
                object([
                    ("line", of.line.to_string()),
                    ("column", of.column.to_string()),
                    ("from", of.place.start.to_string()),
                    ("to", of.place.end.to_string()),
                ])
            };
            object([
                ("list", text(shown.list)),
                ("verdict", text(shown.verdict)),
                ("line", shown.line.to_string()),
                ("column", shown.column.to_string()),
                ("from", shown.place.start.to_string()),
                ("to", shown.place.end.to_string()),
                ("chain", list(shown.chain.iter().map(|piece| text(piece)))),
                ("facts", list(shown.facts.iter().map(fact))),
                ("others", list(shown.others.iter().map(other))),
                ("more", shown.more.to_string()),
            ])
        };
        object([
            ("format", text(self.format.name())),
            ("summary", list(self.summary.iter().map(|sentence| text(sentence)))),
            ("less_certain", text(&self.less_certain)),
            ("findings", list(self.findings.iter().map(finding))),
            ("text", text(&self.to_text())),
        ])
    }

    /// The answer as plain text.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for ShownFinding { verdict, line, column, chain, facts, others, more, .. } in &self.findings {
            text += &format!("line {line}, column {column}: {verdict}\n    {}\n", chain.concat());
            for Fact { label, text: said } in facts {
                text += &format!("    {label}: {said}\n");
            }
            for ShownPlace { line, column, .. } in others {
                text += &format!("    also: line {line}, column {column}\n");
            }
            if *more > 0 {
                text += &format!("    and {more} more\n");
            }
            text.push('\n');
        }
        text + &self.summary.join("\n") + "\n"
    }
}

/// Places of a text, asked for in their order.
struct PlacedText<'t> {
    text: &'t str,
    lines: LineIndex<'t>,
    /// How far the text was counted: bytes, and units of UTF-16.
    counted: (usize, usize),
}

impl<'t> PlacedText<'t> {
    fn new(text: &'t str) -> Self {
        Self { text, lines: LineIndex::new(text), counted: (0, 0) }
    }

    fn utf16(&mut self, at: usize) -> usize {
        let (bytes, _) = self.counted;
        let units = |text: &str| text.encode_utf16().count();
        let (from, before) = if at < bytes { (0, 0) } else { self.counted };
        let count = before + self.text.get(from..at).map_or(0, units);
        self.counted = (at, count);
        count
    }

    fn place(&mut self, finding: &ChainFinding) -> ShownPlace {
        let [start, _] = self.lines.line_columns(finding.at);
        let place = self.utf16(finding.at.start as usize)..self.utf16(finding.at.end as usize);
        ShownPlace { line: start.line, column: start.column, place }
    }

    fn show(&mut self, group: &FindingGroup) -> ShownFinding {
        let finding = &group.finding;
        let ShownPlace { line, column, place } = self.place(finding);
        let (chain, marked) = (&finding.chain, finding.marked.clone());
        let pieces = [0..marked.start, marked.clone(), marked.end..chain.len()];
        ShownFinding {
            list: finding.section.name(),
            verdict: finding.verdict.description(),
            line,
            column,
            place,
            chain: pieces.map(|piece| chain.get(piece).unwrap_or_default().to_owned()),
            facts: words::facts(finding),
            others: group.others.iter().take(MOST_PLACES).map(|other| self.place(other)).collect(),
            more: group.others.len().saturating_sub(MOST_PLACES),
        }
    }
}
