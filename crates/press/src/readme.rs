//! What the README shows of the book: its picture, and what was found.

use crate::figures;
use crate::html::plain;
use crate::placeholders::{Page, put_in};
use anyhow::Context;

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
pub fn section(heading: &str) -> anyhow::Result<String> {
    let (_, rest) = FIRST_PAGE
        .split_once(&format!("## {heading}\n"))
        .with_context(|| format!("the first page has no section `{heading}`"))?;
    let (section, _) = rest.split_once("\n## ").with_context(|| format!("the first page ends with `{heading}`"))?;
    let (drawn, _) = put_in(&with_images(section)?, Page { name: "preface", number: "" }, &[])?;
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

/// The same with each picture as an image.
fn with_images(markdown: &str) -> anyhow::Result<String> {
    let mut out = markdown.to_owned();
    for name in PICTURES {
        let image = format!("{IMAGE}src=\"book/{name}.svg\" alt=\"{}\" width=\"640\">", figures::by_name(name)?.title);
        out = out.replace(&format!("{{{{picture:{name}}}}}"), &image);
    }
    Ok(out)
}

/// The same with links that lead from the folder of the project.
fn in_the_project(markdown: &str) -> String {
    markdown.replace("](", "](book/src/")
}
