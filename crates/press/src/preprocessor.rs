//! The preprocessor that mdBook calls, in process or as a program.

use crate::book::Book;
use crate::cache::Shelf;
use crate::data::PageFile;
use crate::edition::{Edition, SIGN};
use crate::html::escape;
use crate::ledger_pages::ledger;
use crate::page_items::{self, PageItem};
use crate::placeholders::{self, ChapterContext, ENGINE_KEYS};
use crate::{address, braces, chapter_tests, citing, data, fences, maths, modules, record_files, still, verify};
use anyhow::{Context, ensure};
use mdbook_preprocessor::book::{Book as Chapters, Chapter};
use mdbook_preprocessor::errors::Result;
use mdbook_preprocessor::{MDBOOK_VERSION, Preprocessor, PreprocessorContext};
use std::num::NonZero;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// The renderers for which a book is made in its own way: pages, and tests of its programs.
const PAGES: &str = "html";
const TESTS: &str = "test";
/// Bytes of stack of a thread that makes chapters: what a program's first thread has on Linux.
const STACK: usize = 8 << 20;

/// Turns a chapter of a book with formulas and placeholders into one that is all there.
///
/// For pages, formulas become markup and placeholders give way to the ledger's numbers, tables and figures. For tests, the
/// examples are told which crates they may use; the rest stays as it is. Any other renderer gets the chapters of the pages without
/// what can be pressed or moved: folds are open, and programs shortened, as on paper.
#[derive(Clone, Copy)]
pub struct Press {
    book: &'static Book,
    keeps: bool,
}

impl Press {
    /// A preprocessor that takes what an earlier run of the same program made of the same texts, and keeps what it makes, in
    /// `book-cache` below the target directory.
    pub const fn new(book: &'static Book) -> Self {
        Self { book, keeps: true }
    }

    /// A preprocessor that makes everything anew, and keeps nothing.
    pub const fn afresh(book: &'static Book) -> Self {
        Self { book, keeps: false }
    }
}

impl Preprocessor for Press {
    fn name(&self) -> &str {
        self.book.imprint.program
    }

    fn run(&self, context: &PreprocessorContext, mut chapters: Chapters) -> Result<Chapters> {
        let book = self.book;
        book.check(ENGINE_KEYS)?;
        check_version(book, context)?;
        let folder = context.root.join(&context.config.book.src);
        if context.renderer == TESTS {
            let mut errors = Vec::new();
            chapters.for_each_chapter_mut(|chapter| errors.extend(misbraced(book, chapter, &folder)));
            ensure!(errors.is_empty(), "{}", errors.join("\n"));
            chapters.for_each_chapter_mut(|chapter| {
                chapter.content = fences::add_extern_crates(&chapter.content, book.examples.crates);
            });
            return Ok(chapters);
        }
        let root = context.root.parent().unwrap_or(&context.root);
        let shelf = if self.keeps {
            Shelf::open(&modules::target_directory(root, root), book, "chapters")
        } else {
            Shelf::empty()
        };
        let mut errors = Vec::new();
        let mut written = Vec::new();
        chapters.for_each_chapter_mut(|chapter| {
            written.push(chapter.content.clone());
            errors.extend(misbraced(book, chapter, &folder));
            chapter_tests::fold_programs(&mut chapter.content);
            let set = shelf.text("formulas", &[&chapter.content], || {
                maths::render(&chapter.content).map(|content| fences::fold(&content))
            });
            match set {
                Ok(content) => chapter.content = content,
                Err(error) => errors.push(located(chapter, &error)),
            }
        });
        let is_page = context.renderer == PAGES;
        let edition = Edition::detect(&context.root, &book.imprint);
        let items: Vec<_> = chapters
            .chapters()
            .flat_map(|chapter| {
                let place = ChapterPlace::of(chapter);
                placeholders::page_items(&chapter.content, place.context(book, &edition, ""))
            })
            .collect();
        let titles: Vec<_> =
            chapters.chapters().map(|chapter| (ChapterPlace::of(chapter).name, chapter.name.clone())).collect();
        let footer = citing::footer(book, &edition, address::known(&book.imprint).as_ref());
        let listed = page_items::listed(&items);
        let mut texts = Vec::new();
        let mut written = written.into_iter();
        chapters.for_each_chapter_mut(|chapter| {
            let content = std::mem::take(&mut chapter.content);
            let written = written.next().unwrap_or_default();
            texts.push(ChapterText { place: ChapterPlace::of(chapter), content, written });
        });
        let expand = |text: &ChapterText, shelf: &Shelf| {
            expanded(shelf, &text.content, text.place.context(book, &edition, &text.written), &items, &listed)
        };
        let chapters_of = |shelf: &Shelf| in_threads(shelf, &texts, &expand);
        let has_modules = is_page && errors.is_empty();
        let (made, modules) = if has_modules {
            // Cargo takes a lock for each profile, so that modules of two profiles are compiled side by side.
            let [figures, checks] = [shelf.branch(), shelf.branch()];
            let (made, figures, checks) = thread::scope(|scope| {
                let figures = scope.spawn(move || (modules::packed_modules(book, root, &figures), figures));
                let checks = scope.spawn(move || (verify::packed_checks(book, root, &checks), checks));
                (chapters_of(&shelf), joined(figures.join()), joined(checks.join()))
            });
            shelf.take_in(figures.1);
            shelf.take_in(checks.1);
            (made?, Some((figures.0, checks.0)))
        } else {
            (chapters_of(&shelf)?, None)
        };
        let mut files = Vec::new();
        let mut made = texts.iter().zip(made);
        chapters.for_each_chapter_mut(|chapter| match made.next() {
            Some((text, Ok((content, led_to)))) => {
                chapter.content = match is_page {
                    true => content + &neighbours(&titles, &text.place.name) + &footer,
                    false => still::markdown(book, &content),
                };
                files.extend(led_to);
            }
            Some((_, Err(error))) => errors.push(located(chapter, &error)),
            None => {}
        });
        ensure!(errors.is_empty(), "{}", errors.join("\n"));
        // Every verdict is derived for the records, so a book has them only if it leads to them.
        if data::has_place(&folder) && chapters.chapters().any(|chapter| data::is_led_to(&chapter.content)) {
            files.extend(record_files::of_edition(book, &edition, &shelf)?);
            files.extend(data::recall(&shelf, "details", &[], || Ok(ledger::files(book)?.into()))?);
        }
        if let Some((figures, checks)) = modules {
            let mut contents = Vec::new();
            chapters.for_each_chapter_mut(|chapter| contents.push(std::mem::take(&mut chapter.content)));
            files.extend(modules::load_into_pages(book, &mut contents.iter_mut(), figures));
            files.extend(verify::load_into_pages(book, &mut contents.iter_mut(), checks, &shelf)?);
            let mut contents = contents.into_iter();
            chapters.for_each_chapter_mut(|chapter| chapter.content = contents.next().unwrap_or_default());
        }
        data::write(&folder, &files)?;
        shelf.complete();
        Ok(chapters)
    }

    /// Every renderer is answered: mdBook would leave out in silence whoever says no, and render the chapters without it.
    fn supports_renderer(&self, _: &str) -> Result<bool> {
        Ok(true)
    }
}

/// A chapter's text with formulas set, and as it was written.
struct ChapterText {
    place: ChapterPlace,
    content: String,
    written: String,
}

/// A chapter without placeholders, with the files to which it leads.
type Expanded = Result<(String, Vec<PageFile>)>;

/// What becomes of each text, in their order. The threads take the next text in turn, and the shelf takes in what each has made.
fn in_threads(
    shelf: &Shelf,
    texts: &[ChapterText],
    expand: &(dyn Fn(&ChapterText, &Shelf) -> Expanded + Sync),
) -> Result<Vec<Expanded>> {
    let next = AtomicUsize::new(0);
    let work = |branch: Shelf| {
        let mut made = Vec::new();
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            let Some(text) = texts.get(at) else { return (made, branch) };
            made.push((at, expand(text, &branch)));
        }
    };
    let threads = thread::available_parallelism().map_or(1, NonZero::get).min(texts.len());
    let mut all: Vec<_> = thread::scope(|scope| {
        let branches = (0..threads).map(|_| shelf.branch()).collect::<Vec<_>>();
        let threads = branches.into_iter().map(|branch| {
            thread::Builder::new()
                .stack_size(STACK)
                .spawn_scoped(scope, || work(branch))
                .context("no thread for chapters")
        });
        let at_work = threads.collect::<Result<Vec<_>>>()?;
        let mut all = Vec::new();
        for done in at_work {
            let (made, branch) = joined(done.join());
            shelf.take_in(branch);
            all.extend(made);
        }
        Ok::<_, anyhow::Error>(all)
    })?;
    all.sort_by_key(|(at, _)| *at);
    Ok(all.into_iter().map(|(_, made)| made).collect())
}

/// What a thread has made; its panic goes on in this one.
fn joined<T>(done: thread::Result<T>) -> T {
    done.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

/// A chapter without placeholders, and the files to which it leads. Unless it says so itself, it is the same in every edition;
/// only the descriptions of its files name the edition.
fn expanded(shelf: &Shelf, chapter: &str, page: ChapterContext<'_>, items: &[PageItem], listed: &str) -> Expanded {
    const ANY: Edition = Edition::without_commit(SIGN);
    let is_dated = placeholders::is_dated(page.book, chapter);
    let edition = if is_dated { page.edition } else { &ANY };
    let dated = if is_dated { format!("{edition:?}") } else { String::new() };
    let mut texts = shelf
        .recall("chapter", &[chapter, page.name, page.number, listed, &dated], || {
            let page = ChapterContext { edition, ..page };
            let (content, files) = placeholders::expand_with(shelf, chapter, page, items)?;
            Ok([content].into_iter().chain(data::as_texts(files)).collect())
        })?
        .into_iter();
    let content = texts.next().unwrap_or_default();
    let words = page.edition.words();
    let files = data::from_texts(texts).map(|file| file.with_text(|text| text.replace(&ANY.words(), &words)));
    Ok((content, files.collect()))
}

/// Refuses an mdBook that may mean something else by what it says.
fn check_version(book: &Book, context: &PreprocessorContext) -> Result<()> {
    let program = book.imprint.program;
    let PreprocessorContext { mdbook_version, .. } = context;
    // Before 1.0, the second number changes when the format does.
    let format = |version: &str| version.splitn(3, '.').take(2).map(str::to_owned).collect::<Vec<_>>();
    ensure!(
        format(mdbook_version) == format(MDBOOK_VERSION),
        "mdBook {mdbook_version} calls a preprocessor for mdBook {MDBOOK_VERSION}, whose books may have another format: install \
         it with `cargo install mdbook --version {MDBOOK_VERSION}`, or build the book with `{program} book`"
    );
    Ok(())
}

/// What is wrong with the double braces of a chapter below this folder, each with its file and line.
fn misbraced(book: &Book, chapter: &Chapter, chapters: &Path) -> Vec<String> {
    let folder = chapters.join(chapter.source_path.as_deref().and_then(Path::parent).unwrap_or(Path::new("")));
    let faults = braces::faults(book, &chapter.content, &folder);
    faults.into_iter().map(|fault| format!("{}: {fault}", file(chapter))).collect()
}

/// The errors of a chapter, each on a line that names its own line and here receives the file.
fn located(chapter: &Chapter, error: &anyhow::Error) -> String {
    let file = file(chapter);
    format!("{file}: {error:#}").replace("\nline ", &format!("\n{file}: line "))
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
struct ChapterPlace {
    name: String,
    number: String,
}

impl ChapterPlace {
    fn of(chapter: &Chapter) -> Self {
        let stem = chapter.path.as_deref().and_then(|path| path.file_stem());
        let name = stem.map_or_else(|| chapter.name.clone(), |stem| stem.to_string_lossy().into_owned());
        Self { name, number: chapter.number.as_ref().map_or_else(String::new, ToString::to_string) }
    }

    fn context<'a>(&'a self, book: &'a Book, edition: &'a Edition, written: &'a str) -> ChapterContext<'a> {
        ChapterContext { book, name: &self.name, number: &self.number, edition, written }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;
    use mdbook_preprocessor::book::BookItem;
    use mdbook_preprocessor::config::Config;

    /// What becomes of a chapter of this text for this renderer, or what is wrong, asked by an mdBook of this version.
    fn asked(text: &str, renderer: &str, version: &str) -> std::result::Result<String, String> {
        let mut context = PreprocessorContext::new("nowhere/book".into(), Config::default(), renderer.to_owned());
        context.mdbook_version = version.to_owned();
        let chapter = Chapter::new("Only", text.to_owned(), "only.md", Vec::new());
        let book = Chapters::new_with_items(vec![BookItem::Chapter(chapter)]);
        let book = Press::new(&BOOK).run(&context, book).map_err(|error| format!("{error:#}"))?;
        Ok(book.chapters().map(|chapter| chapter.content.clone()).collect())
    }

    #[test]
    fn any_other_renderer_gets_everything_that_stands_still() {
        let text = "# Only *one*\n\nTwice 21 is {{double:21}}, $x^2$, {{claim:leaflet.time}}.\n\n{{figure:circle}}\n\n{{table:rows; \
                    Rows}}\n\n| a |\n|---|\n| {{ref:rows}} |\n\n```text\nlet a = b::<C>();\n```\n\n## The tests behind this \
                    chapter\n\n```rust\n// One is one.\nassert_eq!(1, 1);\n```\n";
        for renderer in ["markdown", "epub", "pandoc", "of my own"] {
            assert!(Press::new(&BOOK).supports_renderer(renderer).expect("an answer"), "{renderer} would be left out");
            let chapter = asked(text, renderer, MDBOOK_VERSION).expect("a chapter");
            for part in [
                "# Only *one*\n",
                "Twice 21 is 42",
                "<msup>",
                "2.02",
                "<svg></svg>",
                "Table\u{a0}1",
                "<span>2</span>",
                "let a = b::<C>();",
                "<summary>One is one.</summary>",
            ] {
                assert!(chapter.contains(part), "{renderer}: no `{part}` in {chapter}");
            }
            for part in ["{{", "<button", "popover", "<script", "assert_eq", "class=\"edition\"", "class=\"beside\""] {
                assert!(!chapter.contains(part), "{renderer}: `{part}` in {chapter}");
            }
        }
        assert!(asked("# Only\n", TESTS, MDBOOK_VERSION).is_ok());
    }

    #[test]
    fn an_mdbook_with_another_format_is_refused_with_the_command_that_installs_the_right_one() {
        for version in ["0.6.0", "0.4.52", "1.0.0", "0.50.4", ""] {
            let error = asked("# Only\n", PAGES, version).expect_err("another format");
            assert!(error.contains(&format!("mdBook {version} calls")), "{error}");
            assert!(error.contains(&format!("cargo install mdbook --version {MDBOOK_VERSION}")), "{error}");
        }
        assert!(asked("# Only\n", PAGES, "0.5.99").is_ok());
    }

    #[test]
    fn the_programs_at_the_end_of_a_chapter_are_folded_on_its_page_and_not_for_their_tests() {
        let text = "# Only\n\n## The tests behind this chapter\n\n```rust\n// One is one.\nassert_eq!(1, 1);\n```\n";
        let page = asked(text, PAGES, MDBOOK_VERSION).expect("a page");
        let fold = page.find("id=\"the-tests-behind-this-chapter\"").expect("a fold");
        let program = page.find("<summary>One is one.</summary>").expect("a program");
        assert!(fold < program && !page.contains("## The tests"), "{page}");
        assert!(asked(text, TESTS, MDBOOK_VERSION).expect("tests").contains("## The tests"));
    }

    #[test]
    fn every_fault_of_a_chapter_has_its_file_and_line() {
        let text = "# Only\n\n$x and\n\n{{clain:pin.radius}}\n\n{{#include no.md}}\n\n{{computed:pin.radiuss}}\n\n\\\\(a\\\\)\n";
        let error = asked(text, PAGES, MDBOOK_VERSION).expect_err("five faults");
        let mut lines: Vec<_> =
            error.lines().map(|line| line.split(": ").take(2).collect::<Vec<_>>().join(" ")).collect();
        lines.sort_by_key(|line| line.rsplit(' ').next().and_then(|number| number.parse::<u8>().ok()));
        assert_eq!(
            lines,
            ["only.md line 3", "only.md line 5", "only.md line 7", "only.md line 9", "only.md line 11"],
            "{error}"
        );
        let error = asked("# Only\n\n{{#include no.md}}\n", TESTS, MDBOOK_VERSION).expect_err("an include");
        assert!(error.starts_with("only.md: line 3: "), "{error}");
    }
}
