//! What is said of a text and of a finding.

use crate::fact::Fact;
use crate::question::PageQuestion;
use proofread::summary::{
    describe_count, describe_doubts, describe_findings, describe_less_certain, describe_partly_checked_chains,
    describe_unchecked_chains, describe_unit_differences, describe_unread_formulas, describe_unread_parts,
};
use proofread::{Caveat, ChainFinding, CheckReport, FindingGroup, ReportSection, TextFormat};

/// What a format is called in a sentence and in the list of choices.
pub fn name_of_format(format: TextFormat) -> &'static str {
    match format {
        TextFormat::Markdown => "Markdown with TeX",
        TextFormat::Latex => "LaTeX",
        TextFormat::Xml => "XML with MathML",
        TextFormat::Html => "HTML",
        TextFormat::Notebook => "Jupyter notebook",
        TextFormat::Plain => "plain lines",
        TextFormat::Csv => "a table with commas",
    }
}

/// What was checked and what was found, in sentences.
pub(crate) fn summary(
    question: &PageQuestion<'_>,
    format: TextFormat,
    report: &CheckReport,
    found: &[FindingGroup],
) -> Vec<String> {
    // What is less certain is folded, and told in a sentence of its own.
    let is_listed = |group: &&FindingGroup| group.finding.section != ReportSection::LessCertain;
    let listed = || found.iter().filter(is_listed);
    let in_list = |list: ReportSection| listed().filter(|group| group.finding.section == list).count();
    let places = listed().map(FindingGroup::place_count).sum();
    let mut said = vec![describe_findings(in_list, places).map_or("Nothing found.".to_owned(), |said| said + ".")];
    said.extend(describe_less_certain(report.tally.less_certain).map(|said| said + "."));
    let tally = &report.tally;
    let checkable = tally.checkable.max(tally.checked);
    said.push(match (checkable, tally.checked) {
        (0, _) => {
            format!("Read as {}, the text has no chain of numbers that arithmetic can check.", name_of_format(format))
        }
        (1, 1) => format!(
            "Read as {}, the text has 1 chain that arithmetic can check, and it was checked.",
            name_of_format(format)
        ),
        (all, checked) => {
            let left = match all - checked {
                0 => "all were checked".to_owned(),
                1 => "1 could not be evaluated".to_owned(),
                left => format!("{left} could not be evaluated"),
            };
            let all = describe_count(all, "chain");
            format!("Read as {}, the text has {all} that arithmetic can check, and {left}.", name_of_format(format))
        }
    });
    said.extend(describe_unchecked_chains(&report.not_checked));
    said.extend(describe_partly_checked_chains(tally));
    said.extend(describe_unread_formulas(tally));
    said.extend(describe_unread_parts(&report.not_read));
    said.extend(describe_unit_differences(tally).filter(|_| !question.units).map(|said| said + "."));
    said.extend(describe_doubts(tally).filter(|_| !question.doubts).map(|said| said + "."));
    said
}

/// What is known about a finding, beyond its chain.
pub(crate) fn facts(finding: &ChainFinding) -> Vec<Fact> {
    let mut facts = vec![Fact { label: "printed", text: finding.printed.clone() }];
    let mut say = |label, text: Option<String>| facts.extend(text.map(|text| Fact { label, text }));
    say("recomputed", finding.recomputed_in_words().or_else(|| finding.difference.clone()));
    let is_apart = finding.section == ReportSection::LessCertain;
    say(if is_apart { "less certain" } else { "note" }, finding.caveat.map(Caveat::reason));
    say("set aside", finding.doubt.map(|doubt| doubt.reason().to_owned()));
    say("why", finding.why.clone());
    say("hint", finding.hint.as_ref().map(|hint| format!("{} would agree", in_quotes(&hint.words))));
    let listed = |words: &[&str]| (!words.is_empty()).then(|| words.join(", "));
    say("nearest reading", listed(&finding.reading));
    let names: Vec<&str> = finding.names.iter().map(String::as_str).collect();
    say("with value of", listed(&names));
    facts
}

/// Words in which formulas stand between backticks, with quotation marks instead.
fn in_quotes(words: &str) -> String {
    let pieces = words.split('`').enumerate();
    pieces.fold(String::new(), |text, (at, piece)| text + ["", "“", "”"][if at == 0 { 0 } else { 2 - at % 2 }] + piece)
}

/// A sentence with a capital letter, and a point at its end.
pub(crate) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|first| first.to_ascii_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", letters.as_str().trim_end_matches('.'))
}
