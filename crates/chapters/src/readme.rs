//! What the README shows of the book: its picture, and what was found.

use crate::figures;
use anyhow::Context;
use geneva_press::Book;
use geneva_press::address::Address;
use geneva_press::edition::Edition;
use geneva_press::html::plain;
use geneva_press::placeholders::{ChapterContext, expand};

const STYLE: &str = include_str!("../../../book/theme/geneva.css");
const FIRST_PAGE: &str = include_str!("../../../book/src/preface.md");

/// The figures that the README shows.
const PICTURES: [&str; 2] = ["wheel-turning", "runs-agreement"];

/// The README's pictures: paths and drawings.
pub fn pictures() -> anyhow::Result<Vec<(String, String)>> {
    PICTURES.iter().map(|name| Ok((format!("book/{name}.svg"), picture(name)?))).collect()
}

/// A figure as a drawing of its own, in the book's colours, light or dark as the reader's system is.
fn picture(name: &str) -> anyhow::Result<String> {
    let colours = |theme: &str| -> anyhow::Result<String> {
        let block = STYLE.split_once(theme).and_then(|(_, rest)| rest.split_once('}'));
        let (block, _) = block.with_context(|| format!("the style has no `{theme}`"))?;
        let colours = block.lines().map(str::trim).filter(|line| line.starts_with("--fig-") && !line.contains("var("));
        Ok(colours.collect())
    };
    let style = format!(
        "<style>svg{{color:#111;{}}}@media (prefers-color-scheme:dark){{svg{{color:#ddd;--fig-paper:#161923;{}}}}}</style>",
        colours("html:not(.js) {")?,
        colours("html.ayu {")?
    );
    let svg = figures::by_name(name)?.svg;
    let (opening, rest) = svg.split_once('\n').context("a drawing of one line")?;
    Ok(format!("{opening}\n{style}\n{rest}"))
}

/// The sections of the first page that the README has, too.
pub const SECTIONS: [&str; 2] = ["What was found", "What else was found"];

/// A section as the first page tells it, in Markdown.
pub fn section(book: &Book, heading: &str) -> anyhow::Result<String> {
    let (_, rest) = FIRST_PAGE
        .split_once(&format!("## {heading}\n"))
        .with_context(|| format!("the first page has no section `{heading}`"))?;
    let (section, _) = rest.split_once("\n## ").with_context(|| format!("the first page ends with `{heading}`"))?;
    let edition = Edition::without_commit(book.imprint.version);
    let context = ChapterContext { book, name: "preface", number: "", edition: &edition, written: section };
    let (drawn, _) = expand(&with_images(&without_choice(section))?, context, &[])?;
    let parts: Vec<_> = drawn.split("\n\n").map(in_markdown).filter(|part| !part.is_empty()).collect();
    Ok(in_the_project(&parts.join("\n\n")))
}

/// A paragraph on one line, a table on its lines, an image as it is.
fn in_markdown(part: &str) -> String {
    if part.starts_with(IMAGE) {
        part.to_owned()
    } else if part.trim_start().starts_with('|') {
        part.trim().lines().map(plain).collect::<Vec<_>>().join("\n")
    } else {
        plain(part)
    }
}

const IMAGE: &str = "<img ";

/// A text in which the picture of both choices stands in place of the two between which a page lets its reader choose.
fn without_choice(markdown: &str) -> String {
    let Some((before, rest)) = markdown.split_once("<div class=\"switch\">") else { return markdown.to_owned() };
    let after = rest.split_once("</div>").map_or("", |(_, after)| after);
    format!("{before}{{{{picture:runs-agreement}}}}{after}")
}

/// Puts an image in place of each picture of a text.
fn with_images(markdown: &str) -> anyhow::Result<String> {
    let mut out = markdown.to_owned();
    for name in PICTURES {
        let image = format!("{IMAGE}src=\"book/{name}.svg\" alt=\"{}\" width=\"640\">", figures::by_name(name)?.title);
        out = out.replace(&format!("{{{{picture:{name}}}}}"), &image);
    }
    Ok(out)
}

/// Makes the links of a text lead from the folder of the project.
fn in_the_project(markdown: &str) -> String {
    markdown.replace("](", "](book/src/")
}

/// Where the README leads a reader who wants the book: in the first variant to its address, in the second to its chapters.
const ONLINE: [&str; 2] = ["**Read the book at <", ">.** The links here lead to its pages."];
const BY_CHAPTERS: &str = "These links lead to the chapters' sources, which have placeholders for numbers and figures. To read the \
                           book itself,\n[build it](#read-it-check-it).";

/// The README with the sections of the first page as they are now, and with links that lead to the book's pages if its address
/// is known, or else to the chapters' sources.
pub fn generate_readme(book: &Book, readme: &str, address: Option<&Address>) -> anyhow::Result<String> {
    let mut out = readme.to_owned();
    for heading in SECTIONS {
        let head = format!("## {heading}\n");
        let (before, rest) = out.split_once(&head).with_context(|| format!("the README has no section `{heading}`"))?;
        let (_, after) = rest.split_once("\n## ").with_context(|| format!("the README ends with `{heading}`"))?;
        out = format!("{before}{head}\n{}\n\n## {after}", section(book, heading)?);
    }
    let place = match (out.find(BY_CHAPTERS), out.find(ONLINE[0])) {
        (Some(at), _) => at..at + BY_CHAPTERS.len(),
        (None, Some(at)) => {
            let length = out[at..].find(ONLINE[1]).context("the README's line on where to read the book has no end")?;
            at..at + length + ONLINE[1].len()
        }
        (None, None) => anyhow::bail!("the README does not say where to read the book: write `{BY_CHAPTERS}`"),
    };
    let line = address.map_or_else(|| BY_CHAPTERS.to_owned(), |at| format!("{}{}{}", ONLINE[0], at.book, ONLINE[1]));
    out.replace_range(place, &line);
    for page in book.pages {
        let source = format!("](book/src/{}.md", page.name);
        if let Some(address) = address {
            out = out.replace(&source, &format!("]({}", address.page(&format!("{}.html", page.name))));
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BOOK;

    const README: &str = include_str!("../../../README.md");

    #[test]
    fn the_readme_leads_to_the_pages_if_their_address_is_known_and_else_to_the_chapters() {
        let address = Address::from_manifest("https://example.org/geneva/", "").expect("an address");
        let (without, with) = (
            generate_readme(&BOOK, README, None).expect("text"),
            generate_readme(&BOOK, README, Some(&address)).expect("text"),
        );
        assert!(without.contains("](book/src/making.md)") && without.contains(BY_CHAPTERS), "{without}");
        assert!(!without.contains("Read the book at"), "{without}");
        assert!(with.contains("**Read the book at <https://example.org/geneva/>.**"), "{with}");
        assert!(with.contains("](https://example.org/geneva/making.html)") && !with.contains("](book/src/"), "{with}");
        // Written again it stays as it is.
        assert_eq!(generate_readme(&BOOK, &without, None).expect("text"), without);
        assert_eq!(generate_readme(&BOOK, &with, Some(&address)).expect("text"), with);
    }
}
