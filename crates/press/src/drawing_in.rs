//! Placeholders in a chapter, and what the ledger and the figures put in their place.
//!
//! A placeholder is `{{key:argument}}` or `{{key}}`. Those of other keys, and the braces of Rust and of mdBook's own
//! `{{#include}}`, are left alone.

use crate::html::escape;
use crate::ledger_pages::{compare, coverage, errata, forms, inline, lists};
use crate::{drawings, maths, records, tables};
use anyhow::{anyhow, bail};

/// Every key, whether it needs an argument, and what it draws in.
pub const KEYS: &[(&str, bool, &str)] = &[
    ("citation", true, "what the source is"),
    ("claim", true, "a claim's printed characters with its verdict"),
    ("compare", true, "a table of printed against computed numbers, for a source or a list of claims"),
    ("count", true, "a number of claims: of a source, or of all"),
    ("coverage", true, "sources line by line, with the exceptions"),
    ("consequences", false, "how many slips there are, by what they do"),
    ("errata", true, "all slips with these consequences"),
    ("grave-errata", false, "what changes a result or a conclusion, in a table"),
    ("right", true, "the right number of a claim whose printed one is not"),
    ("slips", true, "a number of slips: of a consequence, or of all but those of the copy"),
    ("erratum", true, "one erratum"),
    ("evidence", false, "the kinds of evidence and how many claims use each"),
    ("figure", true, "a numbered figure"),
    ("forms", true, "a source's equations, figures and statements with their findings"),
    ("ledger", true, "the claims of a page of the ledger"),
    ("printed", true, "a claim's printed characters"),
    ("recorded", true, "what the record of the benchmarks says of its making: processor, cores, compiler, date"),
    ("ref", true, "the number of a figure in this chapter, as a link"),
    ("symbols", true, "a source's letters and the book's"),
    ("table", true, "a chapter's table of computed numbers, by name"),
    ("tolerances", false, "the table of tolerances"),
    ("value", true, "a claim's computed number"),
    ("verdict", true, "a claim's verdict"),
    ("wheels", true, "a table of wheels, from one number of stations to another"),
    ("verdicts", false, "the classes of verdict and how many claims have each"),
];

/// Replaces the placeholders of a chapter, whose number (`"1."`, or nothing) its figures bear.
pub fn draw_in(chapter: &str, number: &str) -> anyhow::Result<String> {
    let figures = figures_in(chapter);
    let mut page = String::with_capacity(chapter.len() * 2);
    let mut errors = Vec::new();
    let mut rest = chapter;
    while let Some((before, key, argument, after)) = next_placeholder(rest) {
        page.push_str(before);
        match draw(key, argument, number, &figures) {
            Ok(drawn) => page.push_str(&drawn),
            Err(error) => {
                let at = chapter.len() - rest.len() + before.len();
                errors.push(format!("line {}: {error:#}", maths::line(chapter, at)));
            }
        }
        rest = after;
    }
    page.push_str(rest);
    if errors.is_empty() { Ok(page) } else { Err(anyhow!(errors.join("\n"))) }
}

/// The names of the figures that a chapter shows, in order: their places are their numbers.
fn figures_in(chapter: &str) -> Vec<&str> {
    let mut names = Vec::new();
    let mut rest = chapter;
    while let Some((_, key, argument, after)) = next_placeholder(rest) {
        if key == "figure" {
            names.extend(argument);
        }
        rest = after;
    }
    names
}

/// Text before, key, argument and text behind the next placeholder of one of our keys.
fn next_placeholder(text: &str) -> Option<(&str, &str, Option<&str>, &str)> {
    let mut from = 0;
    while let Some(open) = text[from..].find("{{").map(|at| from + at) {
        let inside = &text[open + 2..];
        if let Some(close) = inside.find("}}") {
            let (key, argument) = match inside[..close].split_once(':') {
                Some((key, argument)) => (key, Some(argument.trim())),
                None => (&inside[..close], None),
            };
            if KEYS.iter().any(|(known, ..)| *known == key) {
                return Some((&text[..open], key, argument, &inside[close + 2..]));
            }
        }
        from = open + 2;
    }
    None
}

fn draw(key: &str, argument: Option<&str>, number: &str, figures: &[&str]) -> anyhow::Result<String> {
    let argument = match (KEYS.iter().find(|(known, ..)| *known == key), argument) {
        (Some((_, true, what)), None) => bail!("`{{{{{key}}}}}` needs an argument, `{{{{{key}:…}}}}`: {what}"),
        (Some((_, false, _)), Some(argument)) => bail!("`{{{{{key}:{argument}}}}}` takes no argument"),
        (_, argument) => argument.unwrap_or_default(),
    };
    let place = |name: &str| figures.iter().position(|figure| *figure == name).map(|at| format!("{number}{}", at + 1));
    match key {
        "citation" => inline::citation(argument),
        "claim" => inline::claim(argument),
        "compare" => compare::table(argument),
        "count" => inline::count(argument),
        "coverage" => coverage::page(argument),
        "consequences" => Ok(errata::summary()),
        "errata" => errata::page(argument),
        "grave-errata" => errata::grave(),
        "erratum" => errata::one(argument),
        "evidence" => Ok(lists::evidence()),
        "figure" => drawings::figure(argument, &place(argument).unwrap_or_default()),
        "forms" => forms::table(argument),
        "ledger" => lists::ledger(argument),
        "printed" => inline::printed(argument),
        "recorded" => Ok(escape(records::said(argument)?)),
        "ref" => match place(argument) {
            Some(place) => Ok(format!("<a href=\"#fig-{argument}\">Figure&nbsp;{place}</a>")),
            None => bail!("no figure `{argument}` in this chapter; it shows: {}", figures.join(", ")),
        },
        "right" => inline::right(argument),
        "slips" => errata::count(argument),
        "symbols" => lists::symbols(argument),
        "table" => tables::by_name(argument),
        "tolerances" => Ok(lists::tolerances()),
        "value" => inline::value(argument),
        "verdict" => inline::verdict(argument),
        "verdicts" => Ok(lists::verdicts()),
        "wheels" => tables::wheels::table(argument),
        _ => bail!("`{key}` is not drawn"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braces_that_are_not_ours_stay() {
        let text = "format!(\"{{}}\") {{#include x}} {{ unclosed";
        assert_eq!(draw_in(text, "").expect("nothing to draw"), text);
    }

    #[test]
    fn every_key_is_drawn_or_asks_for_its_argument() {
        for (key, needs, _) in KEYS {
            let bare = draw_in(&format!("{{{{{key}}}}}"), "");
            assert_eq!(bare.is_err(), *needs, "{key}: {bare:?}");
        }
    }

    #[test]
    fn an_unknown_id_is_named_with_its_line_and_a_neighbour() {
        let error = draw_in("one\n\n{{value:pin.radiuss}}", "").expect_err("no such claim").to_string();
        assert!(
            error.starts_with("line 3:") && error.contains("pin.radiuss") && error.contains("pin.radius`"),
            "{error}"
        );
    }

    #[test]
    fn figures_are_numbered_where_they_stand() {
        let page = draw_in("see {{ref:pin-velocity}}\n\n{{figure:pin-position}}\n\n{{figure:pin-velocity}}\n", "1.");
        let page = page.expect("both figures");
        assert!(page.contains("<a href=\"#fig-pin-velocity\">Figure&nbsp;1.2</a>"));
        assert!(page.contains("Figure 1.1"));
        assert!(draw_in("{{ref:pin-position}}", "1.").is_err());
    }
}
