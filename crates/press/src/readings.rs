//! What a reader reads in the place of each placeholder, as text: a change of a number is seen in the sentence that says it.

use crate::book::{Book, Expansion};
use crate::cache::Shelf;
use crate::edition::Edition;
use crate::html::plain;
use crate::page_items::PageItem;
use crate::pages::Numbering;
use crate::placeholders::{ChapterContext, Placeholder, caption, expansion, page_items, placeholders};
use anyhow::Context;
use std::fs;
use std::path::Path;

/// Characters of the chapter before a placeholder by which its sentence is found.
const BEFORE: usize = 40;

/// The pages that have placeholders, with a line for each: words before it, the placeholder, and what is read in its place. Of
/// several rows or paragraphs, each has a line. Figures, and what says which edition this is, only have their names.
///
/// `chapters` is the folder with the Markdown of the pages.
pub fn readings(book: &Book, chapters: &Path) -> anyhow::Result<Vec<(&'static str, String)>> {
    let (mut pages, mut all) = (Vec::new(), Vec::new());
    let mut numbering = Numbering::default();
    let edition = Edition::without_commit(book.imprint.version);
    for page in book.pages {
        let number = numbering.next(page.place);
        let file = chapters.join(page.name).with_extension("md");
        let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        let context = ChapterContext { book, name: page.name, number: &number, edition: &edition, written: &text };
        all.extend(page_items(&text, context));
        pages.push((page.name, number, text));
    }
    let mut found = Vec::new();
    for (name, number, text) in &pages {
        let context = ChapterContext { book, name, number, edition: &edition, written: text };
        let lines = reading(text, context, &all).with_context(|| (*name).to_owned())?;
        if !lines.is_empty() {
            found.push((*name, lines));
        }
    }
    Ok(found)
}

/// What is read in the place of a chapter's placeholders.
pub fn reading(chapter: &str, page: ChapterContext<'_>, all: &[PageItem]) -> anyhow::Result<String> {
    let (mut lines, mut from) = (String::new(), 0);
    for placeholder in placeholders(page.book, chapter) {
        let range = placeholder.range.clone();
        let before = words_before(&chapter[from..range.start]);
        // A caption is read in the place of its table.
        let itself = match (placeholder.caption, placeholder.argument) {
            (Some(_), Some(argument)) => format!("{{{{{}:{argument}}}}}", placeholder.key.name),
            _ => chapter[range.clone()].to_owned(),
        };
        lines += format!("{before} {itself}").trim_start();
        match &rows(&placeholder, page, all)?[..] {
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
fn rows(placeholder: &Placeholder<'_>, page: ChapterContext<'_>, all: &[PageItem]) -> anyhow::Result<Vec<String>> {
    let html = match (placeholder.key.expansion, placeholder.argument) {
        (Expansion::Figure | Expansion::Interactive(..) | Expansion::Dated(_) | Expansion::DatedOf(_), _) => {
            return Ok(Vec::new());
        }
        _ if !placeholder.key.is_text => return Ok(Vec::new()),
        (Expansion::Numbered(make), Some(argument)) => {
            let caption = caption(&Shelf::empty(), placeholder, page, all, &mut Vec::new())?;
            format!("<p>{caption}</p>{}", make(page.book, argument)?.html(&plain(&caption)))
        }
        _ => expansion(&Shelf::empty(), placeholder, page, all, &mut Vec::new())?,
    };
    let cells = html.replace("</td>", " | ").replace("</th>", " | ").replace("</dt>", ": ");
    let ends = ["</tr>", "</li>", "</p>", "</summary>", "</dd>", "</div>", "</pre>"];
    let rows = ends.iter().fold(cells, |rows, end| rows.replace(end, "\n"));
    let rows = rows.split('\n').map(|row| plain(row).trim_end_matches([' ', '|']).to_owned());
    Ok(rows.filter(|row| !row.is_empty()).collect())
}
