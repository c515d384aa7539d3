//! The whole book as one document to be printed, `print.html`: title page, contents, all chapters in their order.
//!
//! It is made from the finished pages, as they stand where nothing moves (`still.rs`). The pages that only list records are left
//! out: the ledger and the coverage of the sources. Links lead to places in the document. A link to a page that is left out
//! leads to the book's address if that is known. Otherwise its words are printed without a link.

pub mod numbers;

use crate::address::Address;
use crate::book::Book;
use crate::edition::Edition;
use crate::html::escape;
use crate::modules;
use crate::pages::{Numbering, PagePlace};
use crate::still::{self, Medium, PageSetting, StillPage};
use anyhow::Context;
use std::fs;
use std::path::Path;

/// The document's file in the book.
pub const FILE: &str = "print.html";
/// The style sheet that it alone loads.
const STYLE: (&str, &str) = ("theme/print.css", include_str!("../theme/print.css"));

/// A chapter as it stands where nothing moves.
pub(crate) struct StillChapter {
    /// Its page.
    pub(crate) name: &'static str,
    /// With a point behind it, or empty.
    pub(crate) number: String,
    /// Its title.
    pub(crate) title: &'static str,
    /// The part of the book that begins with this chapter.
    pub(crate) part: Option<&'static str>,
    /// Its text.
    pub(crate) page: StillPage,
}

impl StillChapter {
    /// Number and title.
    pub(crate) fn heading(&self) -> String {
        format!("{} {}", self.number, self.title).trim().to_owned()
    }
}

/// What is before the text of a built page, and the text.
fn head_and_main(folder: &Path, page: &str) -> anyhow::Result<Option<[String; 2]>> {
    let path = folder.join(format!("{page}.html"));
    if !path.is_file() {
        return Ok(None);
    }
    let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let (head, main) = text.split_once("<main>").with_context(|| format!("{} has no text", path.display()))?;
    let (main, _) = main.split_once("</main>").with_context(|| format!("{} has no end", path.display()))?;
    Ok(Some([head.to_owned(), main.to_owned()]))
}

/// The chapters that are printed, of those that are built in this folder.
pub(crate) fn chapters(
    book: &Book,
    folder: &Path,
    medium: Medium,
    address: Option<&Address>,
) -> anyhow::Result<Vec<StillChapter>> {
    let mut chapters = Vec::new();
    let (mut numbering, mut part) = (Numbering::default(), "");
    for page in book.pages.iter().filter(|page| page.is_printed) {
        let Some([_, main]) = head_and_main(folder, page.name)? else { continue };
        let number = numbering.next(page.place);
        let of = match page.place {
            PagePlace::In(of) => of,
            PagePlace::Behind => "Appendices",
            PagePlace::Before | PagePlace::Below => part,
        };
        let begins = (std::mem::replace(&mut part, of) != of).then_some(of);
        let still = still::set(&main, PageSetting { book, page: page.name, number: &number, medium, address });
        chapters.push(StillChapter { name: page.name, number, title: page.title, part: begins, page: still });
    }
    Ok(chapters)
}

/// Writes the document of a book into the folder in which it is built. Where none of its pages is there, there is none.
pub fn write(book: &Book, folder: &Path, edition: &Edition, address: Option<&Address>) -> anyhow::Result<()> {
    let chapters = chapters(book, folder, Medium::Paper, address)?;
    let Some(first) = chapters.first() else { return Ok(()) };
    let [head, _] = head_and_main(folder, first.name)?.unwrap_or_default();
    let is_style = |line: &&str| line.contains("rel=\"stylesheet\"") && !line.contains("highlight");
    let mut styles = head.lines().map(str::trim).filter(is_style).collect::<Vec<_>>().join("\n");
    // What is live is set by a sheet of its own, which is there where it is.
    for style in modules::styles(book).filter(|style| folder.join(style).is_file()) {
        styles.push_str(&format!("\n<link rel=\"stylesheet\" href=\"{style}\">"));
    }
    for (name, text) in [STYLE, (FILE, &*document(book, &styles, &chapters, edition, address))] {
        let path = folder.join(name);
        // Only a book with sheets of its own has a folder for them.
        fs::create_dir_all(path.parent().unwrap_or(folder))
            .with_context(|| format!("cannot make the folder of {}", path.display()))?;
        fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    Ok(())
}

/// The whole document.
fn document(
    book: &Book,
    styles: &str,
    chapters: &[StillChapter],
    edition: &Edition,
    address: Option<&Address>,
) -> String {
    let imprint = &book.imprint;
    let mut contents = String::new();
    for chapter in chapters {
        if let Some(part) = chapter.part {
            contents.push_str(&format!("<li class=\"of-part\">{}</li>\n", escape(part)));
        }
        contents.push_str(&line(chapter.name, "of-chapter", &chapter.heading()));
        for (id, title) in &chapter.page.sections {
            contents.push_str(&line(id, "of-section", title));
        }
    }
    let read = address.map_or_else(String::new, |at| format!("\n<p><a href=\"{0}\">{0}</a></p>", escape(&at.book)));
    let chapters: String = chapters
        .iter()
        .map(|chapter| {
            format!("<section class=\"printed\" id=\"{}\">\n{}\n</section>\n", chapter.name, chapter.page.html)
        })
        .collect();
    format!(
        "<!DOCTYPE HTML>\n<html lang=\"en\" class=\"light\">\n<head>\n<meta charset=\"UTF-8\">\n<title>{title} (to be printed)</title>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n{styles}\n<link rel=\"stylesheet\" href=\"{style}\">\n\
         </head>\n<body>\n<div class=\"content\">\n<header class=\"title-page\">\n<p class=\"title\">{title}</p>\n<p \
         class=\"subtitle\">{subtitle}</p>\n<p>{authors}</p>\n<p>{edition}</p>{read}\n<p class=\"notice\">This is the whole book for \
         paper. The marks ✓ ≈ ✗ ? say that we checked what is before them: right, right as finely as we could read it off, wrong, \
         open. The ledger of all claims, the coverage of the sources and the data are not printed, and of an example in Rust you \
         see only the line that says what it shows. Text and figures: {licence}.</p>\n</header>\n<nav class=\"contents\" \
         aria-label=\"Contents\">\n<h1 id=\"contents\">Contents</h1>\n<ol>\n{contents}</ol>\n</nav>\n<main>\n{chapters}</main>\n<footer \
         class=\"edition\">{title}, {edition}.{archived}</footer>\n</div>\n</body>\n</html>\n",
        title = escape(imprint.title),
        subtitle = escape(imprint.subtitle),
        authors = escape(imprint.authors),
        edition = escape(&edition.words()),
        archived = edition.swhid().map_or_else(String::new, |id| format!(" <code>{id}</code>.")),
        licence = escape(imprint.licence_words),
        style = STYLE.0,
    )
}

/// A line of the contents. What prints the document puts the number of the page at its end.
fn line(id: &str, class: &str, title: &str) -> String {
    let title = escape(title.trim());
    format!(
        "<li class=\"{class}\"><a href=\"#{id}\">{title}</a> <span class=\"at\" data-page-of=\"{id}\"></span></li>\n"
    )
}
