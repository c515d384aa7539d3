//! mdBook's preprocessor for the numbers of a book: two pages, on where they come from and on what is wrong.

use crate::output::{Outcome, OutputStreams};
use crate::preprocess::{PreprocessorQuestion, read_book};
use anyhow::Context;
use clap::Args;
use geneva_host::printable::shown_path;
use geneva_values::{NumbersReport, TextLink, check, coverage_page, errata_page};
use mdbook_preprocessor::PreprocessorContext;
use mdbook_preprocessor::book::{Book, BookItem, Chapter};
use std::path::{Path, PathBuf};

/// The name of the preprocessor in `book.toml`.
const NAME: &str = "numbers";
/// Where the record is if `book.toml` doesn't say it, from the root of the book.
const RECORD: &str = "numbers.toml";

/// The two pages: the placeholder that a chapter may have for one, and the chapter that is added if none has it.
const PAGES: [(&str, &str, &str, Page); 2] = [
    ("{{numbers:errata}}", "Numbers that are wrong", "numbers-errata.md", errata_page),
    ("{{numbers:coverage}}", "Where the numbers come from", "numbers-coverage.md", coverage_page),
];

type Page = fn(&NumbersReport, &TextLink<'_>) -> String;

/// Options of `geneva numbers`, as mdBook gives them.
#[derive(Args, Debug)]
pub(crate) struct NumberPagesArguments {
    /// A question instead of a book.
    #[command(subcommand)]
    pub question: Option<PreprocessorQuestion>,
}

/// Answers the question, or adds the pages to the book on standard input.
pub(crate) fn run(call: &NumberPagesArguments, streams: &mut dyn OutputStreams) -> anyhow::Result<Outcome> {
    if call.question.is_some() {
        return Ok(Outcome::AsRecorded);
    }
    let (context, mut book) = read_book("to compare numbers, run `geneva check`")?;
    let record: Option<PathBuf> = context
        .config
        .get(&format!("preprocessor.{NAME}.record"))
        .with_context(|| format!("book.toml: `record` of [preprocessor.{NAME}] must be a path in quotation marks"))?;
    let record = context.root.join(record.as_deref().unwrap_or(Path::new(RECORD)));
    let report = check(&record, false).map_err(anyhow::Error::msg)?;
    add_pages(&context, &mut book, &report);
    if !report.is_right() {
        // For those who build the book; mdBook shows what its preprocessors say here.
        let layout = streams.layout();
        streams.write_stderr(&geneva_values::check_text(&report, layout));
    }
    streams.print(&serde_json::to_string(&book)?)?;
    Ok(Outcome::AsRecorded)
}

/// Puts the pages in the place of their placeholders, or behind the last chapter.
fn add_pages(context: &PreprocessorContext, book: &mut Book, report: &NumbersReport) {
    let chapters = Chapters::of(context, book);
    for (placeholder, title, path, page) in PAGES {
        let mut is_placed = false;
        book.for_each_chapter_mut(|chapter| {
            if chapter.content.contains(placeholder) {
                let up = chapter.path.as_deref().map_or(0, |path| path.components().count().saturating_sub(1));
                let page = page(report, &|text| chapters.link(text, up));
                chapter.content = chapter.content.replace(placeholder, &page);
                is_placed = true;
            }
        });
        if !is_placed {
            let content = format!("# {title}\n\n{}", page(report, &|text| chapters.link(text, 0)));
            book.push_item(BookItem::Chapter(Chapter::new(title, content, path, Vec::new())));
        }
    }
}

/// The files of the chapters.
struct Chapters {
    /// The folder of the book.
    root: PathBuf,
    /// Title, file and path in the book of each chapter.
    all: Vec<(String, PathBuf, PathBuf)>,
}

impl Chapters {
    fn of(context: &PreprocessorContext, book: &mut Book) -> Self {
        let source = context.root.join(&context.config.book.src);
        let mut all = Vec::new();
        book.for_each_chapter_mut(|chapter| {
            if let (Some(file), Some(path)) = (&chapter.source_path, &chapter.path)
                && let Ok(whole) = source.join(file).canonicalize()
            {
                all.push((chapter.name.clone(), whole, path.clone()));
            }
        });
        Self { root: context.root.clone(), all }
    }

    /// The title of a text that is a chapter, with its address from a chapter so many folders below the top; the path of another.
    fn link(&self, text: &Path, up: usize) -> (String, Option<String>) {
        let other = || shown_path(text.strip_prefix(&self.root).unwrap_or(text));
        let whole = text.canonicalize().ok();
        let chapter = whole.and_then(|whole| self.all.iter().find(|(_, file, _)| *file == whole));
        let Some((title, _, path)) = chapter else { return (other(), None) };
        let names: Vec<_> = path.components().map(|part| part.as_os_str().to_string_lossy()).collect();
        (title.clone(), Some(format!("{}{}", "../".repeat(up), names.join("/"))))
    }
}
