//! What is said of a text and of a finding.

use crate::answer::Fact;
use crate::question::Question;
use proofread::summary::{count, doubts, findings, others, units_alone, unread};
use proofread::{Finding, Format, List, Tally};

/// What a format is called in a sentence and in the list of choices.
pub fn name_of_format(format: Format) -> &'static str {
    match format {
        Format::Markdown => "Markdown with TeX",
        Format::Latex => "LaTeX",
        Format::Xml => "XML with MathML",
        Format::Html => "HTML",
        Format::Notebook => "Jupyter notebook",
        Format::Plain => "plain lines",
    }
}

/// What was checked and what was found, in sentences.
pub(crate) fn summary(question: &Question<'_>, format: Format, tally: &Tally, found: &[&Finding]) -> Vec<String> {
    let in_list = |list: List| found.iter().filter(|finding| finding.list == list).count();
    let mut said = vec![findings(in_list).map_or("Nothing found.".to_owned(), |said| said + ".")];
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
            let all = count(all, "chain");
            format!("Read as {}, the text has {all} that arithmetic can check, and {left}.", name_of_format(format))
        }
    });
    said.extend(others(tally));
    said.extend(unread(tally));
    said.extend(units_alone(tally).filter(|_| !question.units).map(|said| said + "."));
    said.extend(doubts(tally).filter(|_| !question.doubts).map(|said| said + "."));
    said
}

/// What is known about a finding, beyond its chain.
pub(crate) fn facts(finding: &Finding) -> Vec<Fact> {
    let mut facts = vec![Fact { label: "printed", text: finding.printed.clone() }];
    let mut say = |label, text: Option<String>| facts.extend(text.map(|text| Fact { label, text }));
    say("recomputed", finding.recomputed.clone());
    say("set aside", finding.doubt.map(|doubt| doubt.words().to_owned()));
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
    let first = letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", letters.as_str().trim_end_matches('.'))
}
