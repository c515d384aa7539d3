//! Are the chapters written as chapters should be? Looks at the Markdown, before anything is drawn in.

use geneva_ledger::{Consequence, Decimal, Verdict, numeric_tokens, slips, verdicts};
use geneva_press::fences;
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};

fn chapters() -> Vec<(String, String)> {
    geneva_suite::CHAPTERS
        .iter()
        .map(|file| {
            let text = std::fs::read_to_string(crate::path("book").join(file)).expect("a chapter");
            ((*file).to_owned(), text)
        })
        .collect()
}

#[test]
fn the_chapters_that_are_tested_are_those_of_the_table_of_contents() {
    let summary = std::fs::read_to_string(crate::path("book/src/SUMMARY.md")).expect("a table of contents");
    let listed: Vec<_> = Parser::new(&summary)
        .filter_map(|event| match event {
            Event::Start(Tag::Link { dest_url, .. }) => Some(format!("src/{dest_url}")),
            _ => None,
        })
        .collect();
    assert_eq!(listed, geneva_suite::CHAPTERS);
}

#[test]
fn every_block_of_code_names_its_language_and_runs_if_it_is_rust() {
    for (file, text) in chapters() {
        let untagged = fences::untagged(&text);
        assert!(untagged.is_empty(), "{file}: blocks without a language: {untagged:?}");
        for event in Parser::new(&text) {
            let Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(tags))) = event else { continue };
            for tag in ["ignore", "no_run", "compile_fail", "should_panic"] {
                assert!(!tags.contains(tag), "{file}: a block marked {tags}; every example runs");
            }
        }
    }
}

#[test]
fn no_decimal_of_the_ledger_is_typed_in_a_chapter() {
    for (file, text) in chapters() {
        for (at, line) in text.lines().enumerate() {
            for token in numeric_tokens(line) {
                let computed = |typed: &Decimal| {
                    verdicts().iter().find(|judged| judged.computed.is_some_and(|number| typed.is_rounding_of(number)))
                };
                let typed = token.parse().ok().filter(|_| crate::is_telling(&token));
                let owner = crate::owner(&token).or_else(|| typed.as_ref().and_then(computed).map(|j| j.claim.id));
                assert!(owner.is_none(), "{file}, line {}: {token} belongs to {owner:?}", at + 1);
            }
        }
    }
}

#[test]
fn every_figure_is_shown_in_some_chapter() {
    let all: String = chapters().into_iter().map(|(_, text)| text).collect();
    for name in geneva_press::drawings::NAMES {
        assert!(all.contains(&format!("{{{{figure:{name}}}}}")), "{name} is drawn and not shown");
    }
}

#[test]
fn every_slip_is_told_in_some_chapter() {
    // The errata pages draw all; a chapter must at least speak of one place of each that is not the copy's.
    let all: String = chapters().into_iter().map(|(_, text)| text).collect();
    let told =
        |id: &str| ["erratum", "verdict", "claim"].iter().any(|key| all.contains(&format!("{{{{{key}:{id}}}}}")));
    // A number whose last digits come from rounded steps is told by the table that shows both.
    let tables = || all.split("{{compare:").skip(1).filter_map(|rest| rest.split("}}").next());
    let shown = |id: &str| tables().flat_map(str::split_whitespace).any(|shown| shown == id);
    for places in slips().iter().filter(|places| places.slip.consequence != Consequence::Copy) {
        let is_told = |judged: &&geneva_ledger::Judged| {
            told(judged.claim.id) || judged.verdict == Verdict::FromRounded && shown(judged.claim.id)
        };
        assert!(places.claims.iter().any(is_told), "{} is not told", places.slip.id);
    }
}
