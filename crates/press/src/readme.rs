//! What the README shows of the book: its picture, and what was found.

use crate::figures;
use crate::html::plain;
use crate::placeholders::{Page, put_in};
use anyhow::Context;

const STYLE: &str = include_str!("../../../book/theme/geneva.css");
const FIRST_PAGE: &str = include_str!("../../../book/src/preface.md");

/// The turning wheel as a drawing of its own, in the book's colours, light or dark as the reader's system is.
pub fn picture() -> anyhow::Result<String> {
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
    let svg = figures::by_name("wheel-turning")?.svg;
    let (opening, rest) = svg.split_once('\n').context("a drawing of one line")?;
    Ok(format!("{opening}\n{style}\n{rest}"))
}

/// What was found, as the first page tells it, in Markdown.
pub fn findings() -> anyhow::Result<String> {
    let (_, rest) =
        FIRST_PAGE.split_once("## What was found\n").context("the first page does not say what was found")?;
    let (section, _) = rest.split_once("\n## ").context("the first page ends with what was found")?;
    let (drawn, _) = put_in(section, Page { name: "preface", number: "" }, &[])?;
    let paragraphs = drawn.split("\n\n").map(plain).filter(|paragraph| !paragraph.is_empty());
    let paragraphs: Vec<_> = paragraphs.map(|paragraph| in_the_project(&paragraph)).collect();
    Ok(paragraphs.join("\n\n"))
}

/// The same with links that lead from the folder of the project.
fn in_the_project(markdown: &str) -> String {
    markdown.replace("](", "](book/src/")
}
