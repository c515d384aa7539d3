//! Placeholders in a chapter, and what the ledger and the figures put in their place.
//!
//! A placeholder is `{{key:argument}}` or `{{key}}`. Those of other keys, and the braces of Rust and of mdBook's own
//! `{{#include}}`, are left alone.

use crate::html::escape;
use crate::ledger_pages::{compare, errata, forms, inline, lists, records};
use crate::{figures, maths, measurements, tables};
use anyhow::{bail, ensure};
use std::ops::Range;

/// What is put in the place of a placeholder.
#[derive(Clone, Copy)]
enum Put {
    /// What needs no argument.
    Alone(fn() -> anyhow::Result<String>),
    /// What needs one.
    Of(fn(&str) -> anyhow::Result<String>),
    /// A figure with its number in the chapter.
    Figure,
    /// The number of a figure in this chapter, as a link.
    Reference,
}
use Put::{Alone, Of};

/// Every key, what it says or shows, and how that is made.
const KEYS: &[(&str, &str, Put)] = &[
    ("citation", "what the source is", Of(inline::citation)),
    ("claim", "a claim's printed characters with its verdict", Of(inline::claim)),
    ("compare", "a table of printed against computed numbers, for a source or a list of claims", Of(compare::table)),
    ("consequences", "how many slips there are, by what they do", Alone(errata::summary)),
    ("count", "a number of claims: of a source, or of all", Of(inline::count)),
    ("erratum", "one erratum", Of(errata::one)),
    ("evidence", "the kinds of evidence and how many claims use each", Alone(lists::evidence)),
    ("figure", "a numbered figure", Put::Figure),
    ("forms", "a source's equations, figures and statements with their findings", Of(forms::table)),
    ("grave-errata", "what changes a result or a conclusion, in a table", Alone(errata::grave)),
    ("printed", "a claim's printed characters", Of(inline::printed)),
    (
        "recorded",
        "what the record of the benchmarks says of its making: processor, cores, compiler, date",
        Of(|name| Ok(escape(measurements::said(name)?))),
    ),
    ("records", "what the list of pages puts on this page: claims, slips or lines of sources", Of(records::page)),
    ("ref", "the number of a figure in this chapter, as a link", Put::Reference),
    ("right", "the right number of a claim whose printed one is not", Of(inline::right)),
    ("slips", "a number of slips: of a consequence, or of all but those of the copy", Of(errata::count)),
    ("symbols", "a source's letters and the book's", Of(lists::symbols)),
    ("table", "a chapter's table of computed numbers, by name", Of(tables::by_name)),
    ("tolerances", "the table of tolerances", Alone(lists::tolerances)),
    ("value", "a claim's computed number", Of(inline::value)),
    ("verdict", "a claim's verdict", Of(inline::verdict)),
    ("verdicts", "the classes of verdict and how many claims have each", Alone(lists::verdicts)),
    ("wheels", "a table of wheels, from one number of stations to another", Of(tables::wheels)),
];

/// A placeholder in a chapter.
struct Placeholder<'a> {
    range: Range<usize>,
    key: &'static str,
    /// What the key says or shows.
    what: &'static str,
    put: Put,
    argument: Option<&'a str>,
}

/// Replaces the placeholders of a chapter, whose number (`"1."`, or nothing) its figures bear.
pub fn put_in(chapter: &str, number: &str) -> anyhow::Result<String> {
    let placeholders = placeholders(chapter);
    let is_figure = |placeholder: &&Placeholder| matches!(placeholder.put, Put::Figure);
    let figures: Vec<_> = placeholders.iter().filter(is_figure).filter_map(|figure| figure.argument).collect();
    let (mut edits, mut errors) = (Vec::new(), Vec::new());
    for placeholder in &placeholders {
        match text(placeholder, number, &figures) {
            Ok(text) => edits.push((placeholder.range.clone(), text)),
            Err(error) => errors.push(format!("line {}: {error:#}", maths::line(chapter, placeholder.range.start))),
        }
    }
    ensure!(errors.is_empty(), "{}", errors.join("\n"));
    Ok(maths::apply(chapter, &edits))
}

/// The placeholders of our keys.
fn placeholders(chapter: &str) -> Vec<Placeholder<'_>> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(open) = chapter[from..].find("{{").map(|at| from + at) {
        from = open + 2;
        let Some(inside) = chapter[from..].find("}}").map(|length| &chapter[from..from + length]) else { continue };
        let (name, argument) = match inside.split_once(':') {
            Some((name, argument)) => (name, Some(argument.trim())),
            None => (inside, None),
        };
        if let Some(&(key, what, put)) = KEYS.iter().find(|(key, ..)| *key == name) {
            from += inside.len() + 2;
            found.push(Placeholder { range: open..from, key, what, put, argument });
        }
    }
    found
}

/// What stands for a placeholder in a chapter with this number and these figures, which are numbered in their order.
fn text(placeholder: &Placeholder, number: &str, figures: &[&str]) -> anyhow::Result<String> {
    let place = |name: &str| figures.iter().position(|figure| *figure == name).map(|at| format!("{number}{}", at + 1));
    let Placeholder { key, what, .. } = placeholder;
    match (placeholder.put, placeholder.argument) {
        (Alone(put), None) => put(),
        (Alone(_), Some(argument)) => bail!("`{{{{{key}:{argument}}}}}` takes no argument"),
        (Of(put), Some(argument)) => put(argument),
        (Put::Figure, Some(name)) => figures::html(name, &place(name).unwrap_or_default()),
        (Put::Reference, Some(name)) => match place(name) {
            Some(place) => Ok(format!("<a href=\"#fig-{name}\">Figure&nbsp;{place}</a>")),
            None => bail!("no figure `{name}` in this chapter; it shows: {}", figures.join(", ")),
        },
        (_, None) => bail!("`{{{{{key}}}}}` needs an argument, `{{{{{key}:…}}}}`: {what}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braces_that_are_not_ours_stay() {
        let text = "format!(\"{{}}\") {{#include x}} {{ unclosed";
        assert_eq!(put_in(text, "").expect("nothing to draw"), text);
    }

    #[test]
    fn every_key_is_drawn_or_asks_for_its_argument() {
        for (key, _, put) in KEYS {
            let bare = put_in(&format!("{{{{{key}}}}}"), "");
            assert_eq!(bare.is_ok(), matches!(put, Alone(_)), "{key}: {bare:?}");
        }
    }

    #[test]
    fn an_unknown_id_is_named_with_its_line_and_a_neighbour() {
        let error = put_in("one\n\n{{value:pin.radiuss}}", "").expect_err("no such claim").to_string();
        assert!(
            error.starts_with("line 3:") && error.contains("pin.radiuss") && error.contains("pin.radius`"),
            "{error}"
        );
    }

    #[test]
    fn figures_are_numbered_where_they_stand() {
        let page = put_in("see {{ref:pin-velocity}}\n\n{{figure:pin-position}}\n\n{{figure:pin-velocity}}\n", "1.");
        let page = page.expect("both figures");
        assert!(page.contains("<a href=\"#fig-pin-velocity\">Figure&nbsp;1.2</a>"));
        assert!(page.contains("Figure 1.1"));
        assert!(put_in("{{ref:pin-position}}", "1.").is_err());
    }
}
