//! The preprocessor that mdBook calls, in process or as a program.

use crate::edition::Edition;
use crate::html::escape;
use crate::placeholders::Page;
use crate::{address, chapter_tests, data, fences, live, maths, placeholders};
use anyhow::{Context, bail};
use mdbook_preprocessor::book::{Book, Chapter};
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
        if context.renderer == "test" {
            book.for_each_chapter_mut(|chapter| {
                chapter.content = fences::add_extern_crates(&chapter.content, &fences::CRATES);
            });
            return Ok(book);
        }
        let mut programs = String::new();
        book.for_each_chapter_mut(|chapter| {
            let name = Place::of(chapter).name;
            programs += &chapter_tests::take(&name, &chapter.name, &mut chapter.content);
        });
        book.for_each_chapter_mut(|chapter| {
            let name = Place::of(chapter).name;
            chapter_tests::put(&name, &programs, &mut chapter.content);
        });
        let mut errors = Vec::new();
        book.for_each_chapter_mut(|chapter| match maths::render(&chapter.content).with_context(|| file(chapter)) {
            Ok(content) => chapter.content = fences::fold(&content),
            Err(error) => errors.push(format!("{error:#}")),
        });
        let edition = Edition::of(&context.root);
        let shown: Vec<_> = book
            .chapters()
            .flat_map(|chapter| placeholders::shown(&chapter.content, Place::of(chapter).page(&edition)))
            .collect();
        let titles: Vec<_> = book.chapters().map(|chapter| (Place::of(chapter).name, chapter.name.clone())).collect();
        let footer = edition.footer(address::known());
        let mut files = Vec::new();
        book.for_each_chapter_mut(|chapter| {
            let place = Place::of(chapter);
            let beside = neighbours(&titles, &place.name);
            match placeholders::put_in(&chapter.content, place.page(&edition), &shown).with_context(|| file(chapter)) {
                Ok((content, led_to)) => {
                    chapter.content = content + &beside + &footer;
                    files.extend(led_to);
                }
                Err(error) => errors.push(format!("{error:#}")),
            }
        });
        if !errors.is_empty() {
            bail!("{}", errors.join("\n"));
        }
        let chapters = context.root.join(&context.config.book.src);
        // Every verdict is derived for the records, so a book has them only if it leads to them.
        if data::has_place(&chapters) && book.chapters().any(|chapter| data::is_led_to(&chapter.content)) {
            files.extend(data::File::records()?);
        }
        let root = context.root.parent().unwrap_or(&context.root);
        let mut contents = Vec::new();
        book.for_each_chapter_mut(|chapter| contents.push(std::mem::take(&mut chapter.content)));
        files.extend(live::on_pages(&mut contents.iter_mut(), root));
        let mut contents = contents.into_iter();
        book.for_each_chapter_mut(|chapter| chapter.content = contents.next().unwrap_or_default());
        data::write(&chapters, &files)?;
        Ok(book)
    }

    fn supports_renderer(&self, renderer: &str) -> Result<bool> {
        Ok(matches!(renderer, "html" | "test"))
    }
}

/// Links to the pages before and behind the one of this name, by their titles.
fn neighbours(titles: &[(String, String)], page: &str) -> String {
    let Some(at) = titles.iter().position(|(name, _)| name == page) else { return String::new() };
    let link = |at: Option<usize>, rel: &str, what: &str| {
        let (name, title) = titles.get(at?)?;
        Some(format!("<a rel=\"{rel}\" href=\"{name}.html\"><small>{what}</small> {}</a>", escape(title)))
    };
    let links = [link(at.checked_sub(1), "prev", "Previous"), link(Some(at + 1), "next", "Next")];
    let links: Vec<_> = links.into_iter().flatten().collect();
    format!("\n<nav class=\"beside\" aria-label=\"Previous and next page\">{}</nav>\n", links.join(" "))
}

/// The file that a chapter stands in.
fn file(chapter: &Chapter) -> String {
    chapter.source_path.as_deref().map_or_else(|| chapter.name.clone(), |path| path.display().to_string())
}

/// Where a chapter stands: its page, and its number.
struct Place {
    name: String,
    number: String,
}

impl Place {
    fn of(chapter: &Chapter) -> Self {
        let stem = chapter.path.as_deref().and_then(|path| path.file_stem());
        let name = stem.map_or_else(|| chapter.name.clone(), |stem| stem.to_string_lossy().into_owned());
        Self { name, number: chapter.number.as_ref().map_or_else(String::new, ToString::to_string) }
    }

    fn page<'a>(&'a self, edition: &'a Edition) -> Page<'a> {
        Page { name: &self.name, number: &self.number, edition }
    }
}
