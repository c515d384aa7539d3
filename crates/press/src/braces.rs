//! Double braces that nothing answers: a key that is misspelt, an include of a file that isn't there.
//!
//! mdBook leaves such braces on the page and goes on, so a chapter is asked before anything is put in.

use crate::book::Book;
use crate::fences::is_rust;
use crate::lookup::unknown;
use crate::maths::{dialect, line};
use crate::placeholders::keys;
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};
use std::fs;
use std::ops::Range;
use std::path::Path;

/// mdBook's own words behind `{{#`; the first three take a file.
const DIRECTIVES: [&str; 4] = ["include", "playground", "rustdoc_include", "title"];
/// How to write the braces themselves.
const THEMSELVES: &str = "the braces themselves are `&#123;&#123;`";

/// Where in a chapter double braces are.
#[derive(Clone, Copy, PartialEq, Eq)]
enum BracePlace {
    Text,
    Code,
    Formula,
    /// A program of the chapter, in which braces are those of the language.
    Rust,
}

/// What is wrong with the double braces of a chapter, each with its line. Files are looked for from `folder`, in which the
/// chapter is.
pub(crate) fn faults(book: &Book, chapter: &str, folder: &Path) -> Vec<String> {
    let places = places(chapter);
    let mut faults = Vec::new();
    let mut from = 0;
    while let Some(open) = chapter[from..].find("{{").map(|at| from + at) {
        from = open + 2;
        let place =
            places.iter().rev().find(|(range, _)| range.contains(&open)).map_or(BracePlace::Text, |(_, place)| *place);
        let inside = chapter[from..].find("}}").map(|length| &chapter[from..from + length]);
        // mdBook takes the backslash away and leaves the braces, for a chapter on mdBook.
        let is_escaped = chapter[..open].ends_with('\\') && chapter[from..].starts_with('#');
        let fault = inside.map_or_else(
            || (place == BracePlace::Text).then(|| format!("double braces without an end `}}}}` ({THEMSELVES})")),
            |inside| fault(book, inside, place, folder),
        );
        if let Some(fault) = fault.filter(|_| !is_escaped) {
            faults.push(format!("line {}: {fault}", line(chapter, open)));
        }
    }
    faults
}

/// What is wrong with braces that contain this.
fn fault(book: &Book, inside: &str, place: BracePlace, folder: &Path) -> Option<String> {
    if let Some(directive) = inside.trim_start().strip_prefix('#') {
        return (place != BracePlace::Formula).then(|| misdirected(directive, folder)).flatten();
    }
    let (key, argument) = inside.split_once(':').map_or((inside, None), |(key, argument)| (key, Some(argument)));
    let is_key = !key.is_empty() && key.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-');
    let keys = keys(book).map(|key| key.name);
    let is_known = keys.clone().any(|known| known == key);
    match place {
        BracePlace::Formula if is_known => {
            Some(format!("`{{{{{inside}}}}}` is in a formula, where no number is put in: end the formula before it"))
        }
        BracePlace::Text if !is_known => Some(format!("{} ({THEMSELVES})", unknown("placeholder", key.trim(), keys))),
        BracePlace::Code if !is_known && is_key && argument.is_some() => {
            Some(unknown("placeholder", key, keys).to_string())
        }
        _ => None,
    }
}

/// What is wrong with a word of mdBook and what comes behind it.
fn misdirected(directive: &str, folder: &Path) -> Option<String> {
    let (word, argument) = directive.split_once(char::is_whitespace).unwrap_or((directive, ""));
    if !DIRECTIVES.contains(&word) {
        return Some(format!("mdBook: {}", unknown("word", &format!("#{word}"), DIRECTIVES.iter().copied())));
    }
    let Some(wanted) = argument.split_whitespace().next() else {
        return Some(format!("`{{{{#{word}}}}}` needs something behind the word"));
    };
    if word == "title" {
        return None;
    }
    let (path, part) = wanted.split_once(':').unwrap_or((wanted, ""));
    let part = if word == "playground" { "" } else { part };
    let file = folder.join(path);
    match fs::read_to_string(&file) {
        Ok(text) => (!contains_part(&text, part)).then(|| {
            format!("`{{{{#{word} {wanted}}}}}`: {path} has no `{part}`, which is a line, two with a colon between, or an anchor")
        }),
        Err(why) => Some(format!(
            "`{{{{#{word} {wanted}}}}}`: cannot read {} ({why}); give the path from the chapter's folder",
            file.display()
        )),
    }
}

/// Whether a text has the part that is asked for: a line, some lines, or an anchor. Without any it is the whole text.
fn contains_part(text: &str, part: &str) -> bool {
    let mut ends = part.splitn(3, ':');
    let first = ends.next().unwrap_or_default();
    let number = |end: &str| if end.is_empty() { Some(None) } else { end.parse::<usize>().ok().map(Some) };
    match (number(first), ends.next().map(number)) {
        (Some(first), last) => {
            let last = last.flatten().flatten();
            let lines = text.lines().count();
            let is_line = |end: Option<usize>| end.is_none_or(|line| (1..=lines).contains(&line));
            is_line(first) && is_line(last) && last.is_none_or(|last| first.unwrap_or(1) <= last)
        }
        (None, _) => text.lines().filter_map(|line| line.split_once("ANCHOR:")).any(|(_, name)| {
            let end = name.trim_start().find(|of: char| !(of.is_alphanumeric() || of == '_' || of == '-'));
            name.trim_start().get(..end.unwrap_or(name.trim_start().len())) == Some(first)
        }),
    }
}

/// The formulas and the code of a chapter.
fn places(chapter: &str) -> Vec<(Range<usize>, BracePlace)> {
    let mut found = Vec::new();
    for (event, range) in Parser::new_ext(chapter, dialect()).into_offset_iter() {
        match event {
            Event::InlineMath(_) | Event::DisplayMath(_) => found.push((range, BracePlace::Formula)),
            Event::Code(_) => found.push((range, BracePlace::Code)),
            Event::Start(Tag::CodeBlock(kind)) => {
                let is_rust = matches!(&kind, CodeBlockKind::Fenced(info) if is_rust(info));
                found.push((range, if is_rust { BracePlace::Rust } else { BracePlace::Code }));
            }
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;
    use tempfile::TempDir;

    /// The faults of a chapter in a folder with the file `deck.mim`, of three lines with an anchor.
    fn found(chapter: &str) -> Vec<String> {
        let folder = TempDir::new().expect("a folder");
        fs::write(folder.path().join("deck.mim"), "one\n* ANCHOR: here\nthree\n").expect("writable");
        faults(&BOOK, chapter, folder.path())
    }

    #[test]
    fn a_misspelt_key_is_named_with_its_line_and_the_nearest() {
        for chapter in
            ["a\n\nof {{clain:pin.radius}} mm\n", "a\n\n`{{clain:pin.radius}}`\n", "```text\n\n{{clain:x}}\n```\n"]
        {
            let faults = found(chapter);
            assert_eq!(faults.len(), 1, "{chapter}: {faults:?}");
            assert!(faults[0].starts_with("line 3: no placeholder `clain`; the nearest is `claim`"), "{faults:?}");
        }
        for (wrong, nearest) in
            [("{{Claim:x}}", "claim"), ("{{ claim:x }}", "claim"), ("{{bibtx}}", "bibtex"), ("{{tests}}", "")]
        {
            let faults = found(wrong);
            assert!(faults.len() == 1 && faults[0].contains(&format!("nearest is `{nearest}")), "{wrong}: {faults:?}");
        }
        let faults = found("a {{claim:pin.radius} b\n");
        assert!(faults.len() == 1 && faults[0].contains("without an end"), "{faults:?}");
    }

    #[test]
    fn known_keys_and_the_braces_of_programs_are_left_alone() {
        for chapter in [
            "{{claim:pin.radius}} and {{verdict:pin.radius}}, {{bibtex}}\n",
            "```rust\nformat!(\"{{clain:x}} {{}}\");\n```\n",
            "`format!(\"{{}}\")` and `{{ x }}`\n",
            "```text\nJSON: {\"a\":{\"b\":{}}}\n```\n",
            "$\\text{{{x}}}$ and $\\frac{{a}}{{b}}$\n",
            "\\{{#include of a chapter on mdBook}}\n",
        ] {
            assert_eq!(found(chapter), Vec::<String>::new(), "{chapter}");
        }
    }

    #[test]
    fn a_number_cannot_be_put_into_a_formula() {
        let faults = found("a\n\n$x = {{computed:pin.radius}}$\n");
        assert!(
            faults.len() == 1 && faults[0].starts_with("line 3: `{{computed:pin.radius}}` is in a formula"),
            "{faults:?}"
        );
    }

    #[test]
    fn an_include_that_leads_nowhere_is_named_with_its_line() {
        for whole in ["deck.mim", "deck.mim:2", "deck.mim:1:2", "deck.mim::3", "deck.mim:2:", "deck.mim:here"] {
            assert_eq!(found(&format!("```text\n{{{{#include {whole}}}}}\n```\n")), Vec::<String>::new(), "{whole}");
        }
        for (braces, why) in [
            ("{{#include no.mim}}", "cannot read "),
            ("{{#playground no.rs}}", "cannot read "),
            ("{{#rustdoc_include ../no.rs:here}}", "cannot read "),
            ("{{#include deck.mim:4}}", "has no `4`"),
            ("{{#include deck.mim:2:9}}", "has no `2:9`"),
            ("{{#include deck.mim:3:1}}", "has no `3:1`"),
            ("{{#include deck.mim:her}}", "has no `her`"),
            ("{{#inclde deck.mim}}", "no word `#inclde`; the nearest is `include`"),
            ("{{#include}}", "needs something behind the word"),
        ] {
            for chapter in [format!("a\n\n{braces}\n"), format!("```text\n\n{braces}\n```\n")] {
                let faults = found(&chapter);
                assert_eq!(faults.len(), 1, "{chapter}: {faults:?}");
                assert!(faults[0].starts_with("line 3: ") && faults[0].contains(why), "{chapter}: {faults:?}");
            }
        }
    }
}
