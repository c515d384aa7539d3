//! What a reader reads in the place of each placeholder, as text: a change of a number is seen in the sentence that says it.

use super::{Numbered, Page, Placeholder, Put, Shown, placeholders, shown, text};
use crate::edition::Edition;
use crate::html::plain;
use crate::pages::{Numbering, PAGES};
use anyhow::Context;
use std::fs;
use std::path::Path;

/// Keys of what is a drawing, a form or a record of its own, and no text of a chapter.
const NO_TEXT: [&str; 3] = ["picture", "proofread", "records"];

/// Characters of the chapter before a placeholder by which its sentence is found.
const BEFORE: usize = 40;

/// The pages that have placeholders, with a line for each: words before it, the placeholder, and what is read in its place. Of
/// several rows or paragraphs, each has a line. Figures, and what says which edition this is, only have their names.
///
/// `chapters` is the folder with the Markdown of the pages.
pub fn readings(chapters: &Path) -> anyhow::Result<Vec<(&'static str, String)>> {
    let (mut pages, mut all) = (Vec::new(), Vec::new());
    let mut numbering = Numbering::default();
    for page in PAGES.iter() {
        let number = numbering.next(page.place);
        let file = chapters.join(page.name).with_extension("md");
        let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        all.extend(shown(&text, Page { name: page.name, number: &number, edition: &Edition::NONE, written: &text }));
        pages.push((page.name, number, text));
    }
    let mut found = Vec::new();
    for (name, number, text) in &pages {
        let read = read(text, Page { name, number, edition: &Edition::NONE, written: text }, &all)
            .with_context(|| (*name).to_owned())?;
        if !read.is_empty() {
            found.push((*name, read));
        }
    }
    Ok(found)
}

/// What is read in the place of a chapter's placeholders.
fn read(chapter: &str, page: Page<'_>, all: &[Shown]) -> anyhow::Result<String> {
    let (mut lines, mut from) = (String::new(), 0);
    for placeholder in placeholders(chapter) {
        let range = placeholder.range.clone();
        let before = words_before(&chapter[from..range.start]);
        lines += format!("{before} {}", &chapter[range.clone()]).trim_start();
        match &said(&placeholder, page, all)?[..] {
            [] => {}
            [line] => lines += &format!(" → {line}"),
            rows => rows.iter().for_each(|row| lines += &format!("\n    {row}")),
        }
        lines.push('\n');
        from = range.end;
    }
    Ok(lines)
}

/// The last words of a text on its last line.
fn words_before(text: &str) -> String {
    let line = text.rsplit('\n').next().unwrap_or_default();
    let from = line.char_indices().rev().take(BEFORE).last().map_or(0, |(at, _)| at);
    let cut = if from == 0 { 0 } else { line[from..].find(' ').map_or(from, |at| from + at) };
    line[cut..].trim().to_owned()
}

/// The lines of text that stand for a placeholder.
fn said(placeholder: &Placeholder<'_>, page: Page<'_>, all: &[Shown]) -> anyhow::Result<Vec<String>> {
    let html = match (placeholder.put, placeholder.argument) {
        (Put::Figure | Put::Live | Put::Dated(_) | Put::DatedOf(_), _) => return Ok(Vec::new()),
        _ if NO_TEXT.contains(&placeholder.key) => return Ok(Vec::new()),
        (Numbered(make), Some(argument)) => {
            let table = make(argument)?;
            format!("<p>{}</p>{}", table.caption(), table.html())
        }
        _ => text(placeholder, page, all, &mut Vec::new())?,
    };
    let cells = html.replace("</td>", " | ").replace("</th>", " | ").replace("</dt>", ": ");
    let ends = ["</tr>", "</li>", "</p>", "</summary>", "</dd>", "</div>", "</pre>"];
    let rows = ends.iter().fold(cells, |rows, end| rows.replace(end, "\n"));
    let rows = rows.split('\n').map(|row| plain(row).trim_end_matches([' ', '|']).to_owned());
    Ok(rows.filter(|row| !row.is_empty()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(chapter: &str) -> String {
        let page = Page { name: "pin", number: "1.", edition: &Edition::NONE, written: "" };
        read(chapter, page, &shown(chapter, page)).expect("all are known")
    }

    #[test]
    fn a_placeholder_has_its_words_and_what_is_read_there() {
        let chapter = "A sentence.\nOf the pin that we draw here the radius is {{printed:pin.radius}} and {{ref:pin-velocity}}.\n\n{{figure:pin-velocity}}\n";
        let read = lines(chapter);
        let radius = geneva_documents::LEDGER.claim("pin.radius").expect("a claim").printed;
        assert!(
            read.starts_with(&format!("pin that we draw here the radius is {{{{printed:pin.radius}}}} → {radius}")),
            "{read}"
        );
        assert!(read.contains("\nand {{ref:pin-velocity}} → Figure 1.1\n{{figure:pin-velocity}}\n"), "{read}");
    }

    #[test]
    fn a_table_has_its_caption_and_a_line_for_each_row() {
        let read = lines("{{wheels:3 4}}\n");
        let rows: Vec<_> = read.lines().collect();
        assert!(rows.len() == 5 && rows.iter().any(|row| row.starts_with("    N = 3 |")), "{read}");
    }
}
