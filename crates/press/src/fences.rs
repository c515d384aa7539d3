//! Code blocks: what a chapter's Rust needs to compile, and which blocks have no language.

use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};

use crate::html::escape;
use crate::maths::{apply, line};

/// The crates that a chapter may use.
pub const CRATES: [&str; 8] = [
    "geneva_kinematics",
    "geneva_dynamics",
    "geneva_mimic",
    "geneva_case1973",
    "geneva_documents",
    "geneva_figures",
    "approx",
    "nalgebra",
];

/// Names `crates` on the first line of each Rust block that will be compiled.
///
/// For the renderer `test` only: `mdbook test` gives rustdoc a folder of libraries but names none of them,
/// so `use geneva_kinematics::…` would not resolve. No line is added, so that the lines in messages stay
/// the author's; a hidden first line stays hidden.
pub fn add_extern_crates(chapter: &str, crates: &[&str]) -> String {
    let declarations: String =
        crates.iter().map(|name| format!("#[allow(unused_extern_crates)] extern crate {name}; ")).collect();
    let mut out = String::with_capacity(chapter.len());
    let mut at = 0;
    let mut pending = false;
    for (event, range) in Parser::new_ext(chapter, dialect()).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => pending = is_rust(&info),
            Event::Start(Tag::CodeBlock(CodeBlockKind::Indented)) => pending = true,
            Event::Text(_) if pending => {
                if let Some(offset) = first_item(&chapter[range.clone()]) {
                    out.push_str(&chapter[at..range.start + offset]);
                    out.push_str(&declarations);
                    at = range.start + offset;
                    pending = false;
                }
            }
            Event::End(_) => pending = false,
            _ => {}
        }
    }
    out.push_str(&chapter[at..]);
    out
}

/// Folds each Rust block under its first line, a comment that says what the block shows.
pub fn fold(chapter: &str) -> String {
    let mut edits = Vec::new();
    for (event, range) in Parser::new_ext(chapter, dialect()).into_offset_iter() {
        let Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) = event else { continue };
        let block = &chapter[range.clone()];
        let Some((summary, rest)) = headed(block).filter(|_| is_rust(&info)) else { continue };
        let (opening, _) = block.split_once('\n').unwrap_or((block, ""));
        let folded = format!(
            "<details class=\"proof\">\n<summary>{}</summary>\n\n{opening}\n{rest}\n\n</details>\n",
            escape(summary)
        );
        edits.push((range, folded));
    }
    apply(chapter, &edits)
}

/// What the first line of a block says if it is a comment, and the lines behind it.
pub fn headed(block: &str) -> Option<(&str, &str)> {
    let (_, inside) = block.split_once('\n')?;
    let (first, rest) = inside.split_once('\n')?;
    Some((first.strip_prefix("// ")?, rest))
}

/// A code block that says no language.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Untagged {
    /// Its first line in the chapter, from 1.
    pub line: usize,
    /// Whether it is a block by indentation, which cannot say one, or a fence.
    pub indented: bool,
}

/// The code blocks without a language; rustdoc would take each for a Rust test.
pub fn untagged(chapter: &str) -> Vec<Untagged> {
    Parser::new_ext(chapter, dialect())
        .into_offset_iter()
        .filter_map(|(event, range)| match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Indented)) => {
                Some(Untagged { line: line(chapter, range.start), indented: true })
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if tags(&info).next().is_none() => {
                Some(Untagged { line: line(chapter, range.start), indented: false })
            }
            _ => None,
        })
        .collect()
}

/// Whether a fence with this info string is compiled by rustdoc as Rust.
pub(crate) fn is_rust(info: &str) -> bool {
    let mut rust = tags(info).next().is_none();
    for tag in tags(info) {
        match tag {
            "rust" => rust = true,
            "ignore" => return false,
            _ => {}
        }
    }
    rust
}

fn tags(info: &str) -> impl Iterator<Item = &str> {
    info.split([',', ' ', '\t']).filter(|tag| !tag.is_empty())
}

/// Where the first item may be put in front: after inner attributes, blank lines and the mark of a hidden line.
fn first_item(code: &str) -> Option<usize> {
    let mut start = 0;
    for line in code.split_inclusive('\n') {
        let shown = line.trim_start();
        let item = shown.strip_prefix("# ").map_or(shown, str::trim_start);
        if !(item.trim().is_empty() || item.trim() == "#" || item.starts_with("#![") || item.starts_with("//!")) {
            return Some(start + line.len() - item.len());
        }
        start += line.len();
    }
    None
}

fn dialect() -> pulldown_cmark::Options {
    use pulldown_cmark::Options;
    Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES | Options::ENABLE_TASKLISTS | Options::ENABLE_DEFINITION_LIST
}

#[cfg(test)]
mod tests {
    use super::*;

    const DECLARED: &str = "#[allow(unused_extern_crates)] extern crate a; ";

    fn declared(chapter: &str) -> String {
        add_extern_crates(chapter, &["a"]).replace(DECLARED, "<A>")
    }

    #[test]
    fn each_rust_block_names_the_crates_once() {
        let chapter = "```rust\nuse a::B;\nlet x = 1;\n```\n\n```rust,should_panic\nf();\n```\n";
        assert_eq!(declared(chapter), "```rust\n<A>use a::B;\nlet x = 1;\n```\n\n```rust,should_panic\n<A>f();\n```\n");
    }

    #[test]
    fn other_languages_are_left_alone() {
        for chapter in ["```text\nx\n```\n", "```rust,ignore\nx\n```\n", "```toml\n[a]\n```\n", "Prose, `code`.\n"] {
            assert_eq!(declared(chapter), chapter);
        }
    }

    #[test]
    fn a_block_is_folded_under_what_it_shows() {
        let folded = fold("a\n\n```rust\n// One is *one*.\nassert_eq!(1, 1);\n```\n");
        let expected = "a\n\n<details class=\"proof\">\n<summary>One is &#42;one&#42;.</summary>\n\n```rust\nassert_eq!(1, \
                        1);\n```\n\n</details>\n";
        assert!(folded.trim_end() == expected.trim_end(), "{folded}");
        for left in ["```rust\nf();\n```\n", "```text\n// x\ny\n```\n"] {
            assert_eq!(fold(left), left);
        }
    }

    #[test]
    fn hidden_lines_attributes_and_indentation_are_kept() {
        assert_eq!(declared("```rust\n# use a::B;\nf();\n```\n"), "```rust\n# <A>use a::B;\nf();\n```\n");
        assert_eq!(
            declared("```rust\n#![allow(unused)]\n\nf();\n```\n"),
            "```rust\n#![allow(unused)]\n\n<A>f();\n```\n"
        );
        assert_eq!(declared("- item\n\n  ```rust\n  f();\n  ```\n"), "- item\n\n  ```rust\n  <A>f();\n  ```\n");
        assert_eq!(
            declared("```rust\n#[derive(Debug)]\nstruct S;\n```\n"),
            "```rust\n<A>#[derive(Debug)]\nstruct S;\n```\n"
        );
    }

    #[test]
    fn blocks_without_a_language_are_found() {
        let chapter = "# T\n\n```\nx\n```\n\nText\n\n    y\n\n```text\nz\n```\n\n```rust\n```\n";
        let expected = [Untagged { line: 3, indented: false }, Untagged { line: 9, indented: true }];
        assert_eq!(untagged(chapter), expected);
    }
}
