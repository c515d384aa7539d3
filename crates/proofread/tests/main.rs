//! Does the proofreader find what is wrong, leave alone what is right, and read whatever it is given?

#[cfg(feature = "cli")]
mod action;
mod adjoining;
#[cfg(feature = "cli")]
mod archives;
mod bases;
mod certainty;
mod chains;
#[cfg(feature = "cli")]
mod command;
mod commas;
mod conventions;
mod counted;
mod decimals_and_units;
mod definitions;
mod denied;
mod directives;
mod doubts;
mod formats;
mod fuzz;
mod growth;
mod hints;
#[cfg(feature = "cli")]
mod html;
#[cfg(feature = "cli")]
mod inclusions;
#[cfg(feature = "cli")]
mod integrations;
mod judged;
mod layouts;
#[cfg(feature = "cli")]
mod lsp;
mod mathematics;
mod mathematics_in_texts;
mod messages;
#[cfg(feature = "cli")]
mod neovim;
mod notations;
mod number_forms;
#[cfg(feature = "cli")]
mod office;
mod operations;
mod page_lines;
mod plain;
mod rates;
mod readings;
mod remarks;
mod residues;
mod running;
#[cfg(feature = "cli")]
mod sarif;
mod silent;
#[cfg(feature = "cli")]
mod since;
#[cfg(feature = "cli")]
mod staged;
#[cfg(feature = "statistics")]
mod statistics;
mod structures;
mod surroundings;
mod symbols;
mod thresholds;
#[cfg(feature = "statistics")]
mod totals;
#[cfg(feature = "cli")]
mod typst;
#[cfg(feature = "cli")]
mod unchecked;
mod units;
mod unrounded;
mod unusual;

use proofread::{CheckOptions, CheckReport, NamePolicy, ReportSection, TextFormat, proofread};

/// What is found in a text, with the pairs that agree. What is less certain counts as any other difference: the texts of most tests are
/// shorter than any in which that says something, and `certainty.rs` has those that aren't.
fn report(text: &str, format: TextFormat) -> CheckReport {
    let options = CheckOptions { name_policy: NamePolicy::Once, agreeing: true, ..CheckOptions::default() };
    let mut report = proofread(text, format, options).expect("it can be read");
    let apart = report.findings.iter_mut().filter(|of| of.section == ReportSection::LessCertain);
    apart.for_each(|of| of.section = ReportSection::Numbers);
    report
}

/// The README of the crate in one line.
fn readme() -> String {
    include_str!("../README.md").split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The verdicts of the pairs in a formula of TeX.
fn verdicts(tex: &str) -> Vec<&'static str> {
    report(&format!("$${tex}$$"), TextFormat::Markdown).findings.iter().map(|of| of.verdict.name()).collect()
}

/// What is listed as wrong in a text.
fn wrong(text: &str, format: TextFormat) -> Vec<String> {
    let findings = report(text, format).findings;
    findings
        .into_iter()
        .filter(|of| of.section != ReportSection::Agreeing)
        .map(|of| format!("{} | {}", of.left, of.right))
        .collect()
}

/// How many pairs of a text are listed as wrong in their numbers.
fn on_numbers(text: &str, format: TextFormat) -> usize {
    report(text, format).findings.iter().filter(|of| of.section == ReportSection::Numbers).count()
}

/// Nothing in the first text is wrong; in the second one something is.
#[track_caller]
fn assert_told_apart(right: &str, wrong: &str, format: TextFormat) {
    assert_eq!(on_numbers(right, format), 0, "{right}");
    assert_ne!(on_numbers(wrong, format), 0, "{wrong}");
}

/// A document in CNXML around what is in a paragraph.
fn cnxml(inner: &str) -> String {
    format!(
        "<document xmlns:m=\"http://www.w3.org/1998/Math/MathML\"><content><para>{inner}</para></content></document>"
    )
}

/// A book in PreTeXt around what is in a paragraph.
fn pretext(inner: &str) -> String {
    format!("<pretext><book><chapter><section><p>{inner}</p></section></chapter></book></pretext>")
}
