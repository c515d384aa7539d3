//! Formulas in a chapter.
//!
//! The Markdown parser itself says where they are, so that code and escapes are left alone; a dollar sign
//! that belongs to no formula is an error, since it is one that was not closed.

use std::collections::BTreeSet;
use std::ops::Range;

use anyhow::bail;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

pub use crate::formula::formula;
use crate::html::GLUED;

/// Replaces every `$…$` and `$$…$$` of a chapter by its markup.
///
/// A heading that holds a formula and has no id of its own receives a readable one, `{#…}`, because the
/// id that mdBook would derive from the markup is none. All TeX errors of the chapter are reported at
/// once, each with its line. Call it before placeholders are drawn in, so that the lines are those of
/// the author's file; what is drawn in calls [`formula`].
pub fn render(chapter: &str) -> anyhow::Result<String> {
    let mut edits: Vec<(Range<usize>, String)> = Vec::new();
    let mut errors: Vec<String> = Vec::new();
    // Of what a line has too much or wrong, it says each once.
    let mut complaints: BTreeSet<(usize, &str)> = BTreeSet::new();
    let mut ids = BTreeSet::new();
    let mut heading: Option<Heading> = None;
    let mut in_code = false;
    for (event, range) in Parser::new_ext(chapter, dialect()).into_offset_iter() {
        match event {
            Event::InlineMath(tex) | Event::DisplayMath(tex) => {
                let display = chapter[range.clone()].starts_with("$$");
                note(&mut heading, &tex);
                if let Some(heading) = &mut heading {
                    heading.holds_formula = true;
                }
                // A sign behind a formula does not begin a line.
                let behind = chapter[range.end..].chars().take_while(|c| !display && JOINED.contains(c));
                let signs: String = behind.collect();
                match formula(&tex, display) {
                    Ok(markup) if signs.is_empty() => edits.push((range, markup)),
                    Ok(markup) => {
                        edits.push((range.start..range.end + signs.len(), format!("{GLUED}{markup}{signs}</span>")));
                    }
                    Err(error) => errors.push(format!("line {}: {error:#}", line(chapter, range.start))),
                }
            }
            Event::Start(Tag::Heading { id, classes, attrs, .. }) => {
                let plain = id.is_none() && classes.is_empty() && attrs.is_empty();
                heading = plain.then(Heading::default);
            }
            Event::End(TagEnd::Heading(_)) => {
                if let Some(heading) = heading.take().filter(|heading| heading.holds_formula) {
                    let closing = closing(&chapter[range.clone()]);
                    let closing = range.start + closing.start..range.start + closing.end;
                    edits.push((closing, format!(" {{#{}}}", heading.id(&mut ids))));
                }
            }
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(TagEnd::CodeBlock) => in_code = false,
            Event::Code(text) => note(&mut heading, &text),
            Event::Text(text) => {
                note(&mut heading, &text);
                if !in_code {
                    let stray = stray_dollar(chapter, &range).map(|at| (at, DOLLAR));
                    let faults = stray.into_iter().chain(foreign_delimiter(chapter, &range).map(|at| (at, BRACKET)));
                    complaints.extend(faults.map(|(at, what)| (line(chapter, at), what)));
                }
            }
            Event::Html(html) | Event::InlineHtml(html) => {
                let stray = html.find('$').map(|at| (line(chapter, range.start + at), IN_HTML));
                complaints.extend(stray);
            }
            _ => {}
        }
    }
    errors.extend(complaints.into_iter().map(|(line, what)| format!("line {line}: {what}")));
    if !errors.is_empty() {
        bail!("{}", errors.join("\n"));
    }
    Ok(apply(chapter, &edits))
}

const DOLLAR: &str = "a `$` of no formula (the sign itself is `\\$`, a bar in a table `\\vert`)";
const BRACKET: &str = "a backslash before a bracket, with which mdBook begins or ends a formula: write `$…$` for a formula in a \
                       line and `$$…$$` for one on lines of its own (the backslash itself is `&#92;`)";
const IN_HTML: &str = "a `$` in HTML, where no formula is set: leave a blank line between the tag and the formula (the sign itself \
                       is `&#36;`)";

/// Signs that stand close behind a formula or a mark: a line does not break before them.
pub const JOINED: [char; 7] = [',', '.', ';', ':', ')', '?', '’'];

/// Markdown as mdBook reads it, and formulas besides.
pub(crate) fn dialect() -> Options {
    Options::ENABLE_MATH
        | Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
}

/// A heading while its parts go by.
#[derive(Default)]
struct Heading {
    text: String,
    holds_formula: bool,
}

fn note(heading: &mut Option<Heading>, text: &str) {
    if let Some(heading) = heading {
        heading.text.push_str(text);
    }
}

/// A dollar sign in running text that no backslash precedes: a formula that was not closed, or not balanced.
fn stray_dollar(chapter: &str, text: &Range<usize>) -> Option<usize> {
    let at = text.start + chapter[text.clone()].find('$')?;
    (!chapter[..at].ends_with('\\')).then_some(at)
}

/// A bracket in running text behind a backslash of its own, as in `\\(a\\)`: where MathJax is used, mdBook takes it for the end of a formula.
fn foreign_delimiter(chapter: &str, text: &Range<usize>) -> Option<usize> {
    let brackets = chapter[text.clone()].match_indices(['(', ')', '[', ']']).map(|(at, _)| text.start + at);
    brackets.into_iter().find(|at| chapter[..*at].ends_with("\\\\"))
}

impl Heading {
    /// An id of letters and digits joined by hyphens, different from those in `taken`.
    fn id(&self, taken: &mut BTreeSet<String>) -> String {
        let words: Vec<String> = self
            .text
            .split(|c: char| !c.is_alphanumeric())
            .filter(|word| !word.is_empty())
            .map(str::to_lowercase)
            .collect();
        let stem = words.join("-");
        let mut id = stem.clone();
        let mut count = 1;
        while !taken.insert(id.clone()) {
            id = format!("{stem}-{count}");
            count += 1;
        }
        id
    }
}

/// What follows the title on the line of a heading: closing `#`s and blanks, or nothing.
fn closing(heading: &str) -> Range<usize> {
    let line = heading.lines().next().unwrap_or_default();
    let open = line.trim_end().trim_end_matches('#');
    let title = if open.ends_with(' ') { open } else { line };
    title.trim_end().len()..line.len()
}

/// The line of the chapter, from 1, in which the byte `at` stands.
pub(crate) fn line(chapter: &str, at: usize) -> usize {
    chapter[..at].matches('\n').count() + 1
}

/// The chapter with these places replaced, which follow one another.
pub(crate) fn apply(chapter: &str, edits: &[(Range<usize>, String)]) -> String {
    let mut page = String::with_capacity(chapter.len() * 4);
    let mut at = 0;
    for (range, text) in edits {
        page.push_str(&chapter[at..range.start]);
        page.push_str(text);
        at = range.end;
    }
    page.push_str(&chapter[at..]);
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page as mdBook's Markdown parser makes it.
    fn page(chapter: &str) -> String {
        let rendered = render(chapter).unwrap();
        let mut html = String::new();
        pulldown_cmark::html::push_html(&mut html, Parser::new_ext(&rendered, dialect() - Options::ENABLE_MATH));
        html
    }

    #[test]
    fn formulas_are_mathml() {
        let html = page("The ratio $m = \\sin\\alpha$ and\n\n$$\\frac{a}{b}$$\n");
        assert_eq!(html.matches("<math").count(), 2);
        assert_eq!(html.matches("<span class=\"display\">").count(), 1);
        assert!(!html.contains('$'));
    }

    #[test]
    fn code_and_escapes_stay() {
        let html = page("`$x$` costs 5\\$, and \\$y\\$.\n\n```rust\nlet a = \"$x$\";\n```\n");
        assert!(!html.contains("<math"));
    }

    #[test]
    fn formulas_stand_in_tables_lists_quotations_and_headings() {
        let html = page("| a | b |\n|---|---|\n| $\\lvert x\\rvert_1$ | $\\omega_2'$ |\n");
        assert_eq!((html.matches("<math").count(), html.matches("<td>").count()), (2, 2));
        let html = page("1. First\n\n   $$\n   a\n   = b\n   $$\n\n2. Second\n\n> $$\n> c\n> $$\n");
        assert_eq!((html.matches("<math").count(), html.matches("<li>").count()), (2, 2));
        assert!(html.contains("<blockquote>\n<p><span class=\"display\">"));
        let html = page("## The ratio $\\omega_2/\\omega_1$ ##\n\nText\n\n## Of $a$ {#own}\n");
        assert!(html.contains("<h2 id=\"the-ratio-omega-2-omega-1\">"), "{html}");
        assert!(html.contains("<h2 id=\"own\">"));
    }

    #[test]
    fn equal_headings_receive_different_ids() {
        let html = page("## $a$\n\n## $a$\n");
        assert!(html.contains("id=\"a\"") && html.contains("id=\"a-1\""), "{html}");
    }

    #[test]
    fn nothing_in_a_formula_is_taken_for_markdown() {
        let html = page("$a*b*c_d e_f[f](g)'''...--$ and $\\text{{{x}} `y` \"z\" ~ }$\n");
        assert!(!html.contains("<em>") && !html.contains("<a ") && !html.contains("<code>"), "{html}");
        assert!(!html.contains('–') && !html.contains('…'));
    }

    #[test]
    fn every_error_has_its_line() {
        let error = render("# T\n\nIn $\\frac 1$ and\n\n$$\n\\nosuch\n$$\n").unwrap_err().to_string();
        let lines: Vec<&str> = error.lines().filter(|line| line.starts_with("line ")).collect();
        assert_eq!(lines.len(), 2, "{error}");
        assert!(lines[0].starts_with("line 3: the formula `\\frac 1`"), "{error}");
        assert!(lines[1].starts_with("line 5: the formula `\\nosuch`"), "{error}");
    }

    #[test]
    fn a_line_with_many_stray_dollars_is_named_once() {
        let error =
            render("a\n\nDo you mean $14 or $40? It costs $5 and then $6.\n\nAnd $7.\n").unwrap_err().to_string();
        let lines: Vec<_> = error.lines().map(|line| line.split_once(':').map(|(line, _)| line)).collect();
        assert_eq!(lines, [Some("line 3"), Some("line 5")], "{error}");
    }

    #[test]
    fn the_delimiters_of_mdbook_are_refused_with_the_ones_to_write() {
        for chapter in ["a\n\n\\\\(a_1\\\\) is\n", "a\n\nthe\n\\\\[ a_1 \\\\] is\n", "| a |\n|---|\n| \\\\(x |\n"] {
            let error = render(chapter).unwrap_err().to_string();
            assert!(error.starts_with("line ") && error.contains("`$…$`") && error.contains("`&#92;`"), "{error}");
            assert_eq!(error.lines().count(), 1, "{error}");
        }
        let code = "`\\\\(a\\\\)` and \\(b\\) and \\\\ [c](d.md)\n\n```text\n\\\\[ a \\\\]\n```\n";
        assert!(render(code).is_ok(), "code, brackets and a backslash alone");
    }

    #[test]
    fn a_formula_in_html_is_an_error() {
        let error = render("a\n\n<div>\n$x$ is\n</div>\n").unwrap_err().to_string();
        assert!(error.starts_with("line 4: a `$` in HTML"), "{error}");
        assert!(render("<div>\n\n$x$ is\n\n</div>\n").is_ok());
    }

    #[test]
    fn a_formula_without_an_end_is_an_error() {
        for chapter in ["Text\n\nIn $x and so on.\n", "a\n\nIn $\\frac{1$.\n", "| a |\n|---|\n| $|x|$ |\n"] {
            let error = render(chapter).unwrap_err().to_string();
            assert!(error.starts_with("line 3: a `$` of no formula"), "{error}");
        }
    }
}
