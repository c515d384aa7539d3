//! The preprocessor that mdBook calls, in process or as a program.

use crate::{fences, maths, placeholders};
use anyhow::{Context, bail};
use mdbook_preprocessor::book::{Book, BookItem, Chapter};
use mdbook_preprocessor::errors::Result;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};

/// Turns a chapter with formulas and placeholders into one that is all there.
///
/// For pages, formulas become markup and placeholders give way to the ledger's numbers, tables and figures. For tests, the
/// examples are told which crates they may use; the rest stays as it is.
pub struct Geneva;

impl Preprocessor for Geneva {
    fn name(&self) -> &str {
        "geneva"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let mut errors = Vec::new();
        book.for_each_mut(|item| {
            let BookItem::Chapter(chapter) = item else { return };
            match content(chapter, &context.renderer) {
                Ok(content) => chapter.content = content,
                Err(error) => errors.push(format!("{error:#}")),
            }
        });
        if !errors.is_empty() {
            bail!("{}", errors.join("\n"));
        }
        Ok(book)
    }

    fn supports_renderer(&self, renderer: &str) -> Result<bool> {
        Ok(matches!(renderer, "html" | "test"))
    }
}

fn content(chapter: &Chapter, renderer: &str) -> Result<String> {
    let file =
        || chapter.source_path.as_deref().map_or_else(|| chapter.name.clone(), |path| path.display().to_string());
    if renderer == "test" {
        return Ok(fences::add_extern_crates(&chapter.content, &fences::CRATES));
    }
    let number = chapter.number.as_ref().map_or_else(String::new, ToString::to_string);
    let with_formulas = maths::render(&chapter.content).with_context(file)?;
    placeholders::put_in(&with_formulas, &number).with_context(file)
}
