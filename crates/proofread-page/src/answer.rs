//! What is found in a text, with its places as a page counts them.

use crate::question::Question;
use crate::words;
use proofread::{Finding, Format, Lines, List, Options, proofread};
use serde_json::json;
use std::ops::Range;

/// Findings that are shown at most.
const MOST_SHOWN: usize = 200;

/// Findings for which a hint is searched at most.
const MOST_HINTS: usize = 60;

/// What was found in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// What the text was read as.
    pub format: Format,
    /// What was checked and what was found, in sentences.
    pub summary: Vec<String>,
    /// The first findings, in the order of the text.
    pub findings: Vec<Shown>,
}

/// A finding as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// Its list: `numbers`, `units`, `bindings` or `doubts`.
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
}

/// Something known about a finding.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// What it is: printed, recomputed, hint and so on.
    pub label: &'static str,
    /// What is said.
    pub text: String,
}

impl Answer {
    /// Proofreads the text of a question.
    ///
    /// # Errors
    ///
    /// In words, if the text cannot be read in its format.
    pub fn to(question: &Question<'_>) -> Result<Self, String> {
        let by_name = || Format::of_extension(question.extension);
        let format = question.format.or_else(by_name).unwrap_or_else(|| Format::of_text(question.text));
        let hints = if question.hints { MOST_HINTS } else { 0 };
        let options = Options { follow: question.follow, hints, ..Options::default() };
        let report = proofread(question.text, format, options).map_err(|why| words::capitalised(&why.to_string()))?;
        let wanted = |finding: &&Finding| match finding.list {
            List::Units => question.units,
            List::Doubts => question.doubts,
            List::Numbers | List::Bindings | List::Agreeing => true,
        };
        let found: Vec<&Finding> = report.findings.iter().filter(wanted).collect();
        let mut places = Places::new(question.text);
        let findings = found.iter().take(MOST_SHOWN).map(|finding| places.shown(finding)).collect();
        let mut summary = words::summary(question, format, &report.tally, &found);
        if found.len() > MOST_SHOWN {
            summary.push(format!("The first {MOST_SHOWN} are shown. The command lists them all."));
        }
        if question.hints && found.len() > MOST_HINTS {
            summary.push(format!("Hints were searched for at most the first {MOST_HINTS}."));
        }
        Ok(Self { format, summary, findings })
    }

    /// The answer as a JSON object: `format`; `summary`, a list of sentences; `findings`, each with `list`, `verdict`, `line`,
    /// `column`, `from` and `to`, `chain` in three pieces, and `facts`, a list of `label` and `text`; `text`, all of it to be
    /// copied.
    pub fn to_json(&self) -> String {
        let finding = |shown: &Shown| {
            let fact = |fact: &Fact| json!({ "label": fact.label, "text": fact.text });
            json!({
                "list": shown.list,
                "verdict": shown.verdict,
                "line": shown.line,
                "column": shown.column,
                "from": shown.place.start,
                "to": shown.place.end,
                "chain": shown.chain,
                "facts": shown.facts.iter().map(fact).collect::<Vec<_>>(),
            })
        };
        json!({
            "format": self.format.name(),
            "summary": self.summary,
            "findings": self.findings.iter().map(finding).collect::<Vec<_>>(),
            "text": self.to_text(),
        })
        .to_string()
    }

    /// The answer as plain text.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for Shown { verdict, line, column, chain, facts, .. } in &self.findings {
            text += &format!("line {line}, column {column}: {verdict}\n    {}\n", chain.concat());
            for Fact { label, text: said } in facts {
                text += &format!("    {label}: {said}\n");
            }
            text.push('\n');
        }
        text + &self.summary.join("\n") + "\n"
    }
}

/// Places of a text, asked for in their order.
struct Places<'t> {
    text: &'t str,
    lines: Lines<'t>,
    /// How far the text was counted: bytes, and units of UTF-16.
    counted: (usize, usize),
}

impl<'t> Places<'t> {
    fn new(text: &'t str) -> Self {
        Self { text, lines: Lines::new(text), counted: (0, 0) }
    }

    fn utf16(&mut self, at: usize) -> usize {
        let (bytes, _) = self.counted;
        let units = |text: &str| text.encode_utf16().count();
        let (from, before) = if at < bytes { (0, 0) } else { self.counted };
        let count = before + self.text.get(from..at).map_or(0, units);
        self.counted = (at, count);
        count
    }

    fn shown(&mut self, finding: &Finding) -> Shown {
        let [start, _] = self.lines.places(finding.at);
        let place = self.utf16(finding.at.start as usize)..self.utf16(finding.at.end as usize);
        let (chain, marked) = (&finding.chain, finding.marked.clone());
        let pieces = [0..marked.start, marked.clone(), marked.end..chain.len()];
        Shown {
            list: finding.list.name(),
            verdict: finding.verdict.words(),
            line: start.line,
            column: start.column,
            place,
            chain: pieces.map(|piece| chain.get(piece).unwrap_or_default().to_owned()),
            facts: words::facts(finding),
        }
    }
}
