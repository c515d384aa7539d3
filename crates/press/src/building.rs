//! Building the book and testing its chapters, with mdBook as a library.
//!
//! A reader has either the old book or the new one: pages are made in a hidden folder beside the output, and when all of
//! them are done, the two trade places. Files that no build has written are never removed.

mod exchange;
mod list;
mod output_folder;
mod site;
mod warnings;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Context;
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use mdbook_preprocessor::Preprocessor;

use crate::book::Book;
use crate::cache::Shelf;
use crate::edition::Edition;
use crate::preprocessor::Press;
use crate::{
    address, epub, feed, fingerprints, libraries, minify, modules, phone_tables, policy, print, ro_crate, search,
    spoken,
};
use site::Site;
pub use site::abandon;

/// A book that has been built.
#[derive(Debug)]
pub struct BuiltBook {
    /// Its first page.
    pub first_page: PathBuf,
    /// Folders that hold files which somebody added to the old book just as it was replaced. Usually there are none.
    pub kept: Vec<PathBuf>,
}

/// Builds the pages of a book, whose chapters are in the workspace `root`, into the folder `out`.
///
/// `out` may be absent, empty, or an earlier build and nothing else; anything else is refused before the build begins. When
/// something fails, `out` is as it was. A key in double braces that the book does not have, and an argument that its key does
/// not know, stop the build; the error names file, line and the nearest name.
///
/// What an earlier build by the same program has made of the same texts is taken from `book-cache` below the target
/// directory. The book is the same, byte for byte, as one that is built afresh.
pub fn build(book: &'static Book, root: &Path, out: &Path) -> anyhow::Result<BuiltBook> {
    let shelf = Shelf::open(&modules::target_directory(root, root), book, "pages");
    build_with(book, root, out, Press::new(book), &shelf)
}

/// Builds the pages of a book as [`build`] does, and takes nothing from an earlier build.
pub fn build_afresh(book: &'static Book, root: &Path, out: &Path) -> anyhow::Result<BuiltBook> {
    build_with(book, root, out, Press::afresh(book), &Shelf::empty())
}

/// Builds a book with a preprocessor that takes the place of the command of the same name in `book.toml`.
fn build_with(
    book: &'static Book,
    root: &Path,
    out: &Path,
    preprocessor: impl Preprocessor + 'static,
    shelf: &Shelf,
) -> anyhow::Result<BuiltBook> {
    let mut source = warnings::refuse(|| load(root, preprocessor))?;
    let out = output_folder::find(out, &source.source_dir())?;
    let site = Site::open(&out)?;
    render(book, &mut source, &site.new_book(), shelf).with_context(|| {
        format!("the book in {} does not build; {} is as it was", source.root.display(), out.display())
    })?;
    let kept = site.finish()?;
    Ok(BuiltBook { first_page: out.join("index.html"), kept })
}

/// Makes all files of the book in the folder `new`.
fn render(book: &Book, source: &mut MDBook, new: &Path, shelf: &Shelf) -> anyhow::Result<()> {
    source.config.build.build_dir = new.to_owned();
    without_words_to_search(&mut source.config)?;
    warnings::refuse(|| source.build())?;
    search::write(book, new, shelf)?;
    let edition = Edition::detect(&source.root, &book.imprint);
    let address = address::known(&book.imprint);
    print::write(book, new, &edition, address.as_ref())?;
    epub::write(book, new, &edition, address.as_ref())?;
    finish(book, new, shelf)?;
    ro_crate::write(book, new, &edition)?;
    list::write(new)?;
    shelf.complete();
    Ok(())
}

/// Settings with which mdBook puts no word into its search index, which is made anew afterwards. Its name then says nothing
/// of the chapters, so that a page is the same when only another one changes.
fn without_words_to_search(config: &mut Config) -> anyhow::Result<()> {
    let is_searched = config.html_config().and_then(|html| html.search).is_some_and(|search| search.enable);
    if is_searched {
        let none: BTreeMap<&str, BTreeMap<&str, bool>> = BTreeMap::from([("", BTreeMap::from([("enable", false)]))]);
        config.set("output.html.search.chapter", none)?;
    }
    Ok(())
}

/// Puts the last hand to the style sheets, scripts and pages of a built book. A file has its name when it changes no more, and
/// a page its policy when it names all files as they are.
fn finish(book: &Book, folder: &Path, shelf: &Shelf) -> anyhow::Result<()> {
    rewrite(folder, "css", &|text| Ok(minify::style(text)))?;
    rewrite(folder, "js", &|text| Ok(minify::script(&with_start_at_the_top(text))))?;
    rewrite(folder, "html", &|text| Ok(with_running_head(text)))?;
    rewrite(folder, "html", &|text| {
        let text = spoken::with_named_heads(&phone_tables::labelled(text));
        let text = with_way_to_the_figure(&with_way_past_the_list(&text), book);
        let text = feed::with_link_to_the_feed(&text, &book.imprint, book.changelog);
        Ok(minify::page(&text))
    })?;
    fingerprints::renew(folder)?;
    rewrite(folder, "html", &|page| policy::guarded(page, book.modules, shelf))
}

/// A page that begins with a link past the list of chapters, for readers with a keyboard.
fn with_way_past_the_list(page: &str) -> String {
    // What a page without a list shows is its text.
    if !page.contains("id=\"mdbook-sidebar\"") || !page.contains("id=\"mdbook-content\"") {
        return page.to_owned();
    }
    page.replacen("<body>", "<body>\n<a class=\"skip\" href=\"#mdbook-content\">Skip to the text</a>", 1)
}

/// A script that brings the list of chapters to the chapter of the page by moving the list alone. mdBook asks for the link to be
/// shown, and in some browsers the key Tab then begins behind this link.
fn with_start_at_the_top(script: &str) -> String {
    const SHOWN: &str = "activeSection.scrollIntoView({ block: 'center' });";
    const MOVED: &str = "const [list, link] = [this, activeSection].map(of => of.getBoundingClientRect()); \
                         this.scrollBy(0, link.top - list.top - list.height / 2);";
    script.replace(SHOWN, MOVED)
}

/// A page whose bar names the chapter, as the running head of a book does: mdBook writes the book's title there.
fn with_running_head(page: &str) -> String {
    const HEAD: &str = "<h1 class=\"menu-title\">";
    let title = page.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>"));
    let head = page.split_once(HEAD).and_then(|(before, rest)| Some((before, rest.split_once("</h1>")?)));
    match (title, head) {
        (Some((title, _)), Some((before, (book, rest)))) => {
            let chapter = title.trim().strip_suffix(book.trim()).and_then(|title| title.strip_suffix(" - "));
            format!("{before}{HEAD}{}</h1>{rest}", chapter.unwrap_or(title.trim()))
        }
        _ => page.to_owned(),
    }
}

/// A page that offers a way to its first figure that a reader moves, right behind the title.
fn with_way_to_the_figure(page: &str, book: &Book) -> String {
    let figure = page.split("<figure ").skip(1).filter_map(|rest| rest.split_once('>')).find_map(|(attributes, _)| {
        let moves = book.modules.iter().any(|module| attributes.contains(&format!("{}=\"", module.asking())));
        let id = attributes.split("id=\"").nth(1).and_then(|rest| rest.split('"').next());
        id.filter(|_| moves)
    });
    // The title is the first heading of the text; the bar above it has one, too.
    let title = page.find("<main>").and_then(|main| Some(main + page[main..].find("</h1>")? + "</h1>".len()));
    match (figure, title) {
        (Some(id), Some(at)) => {
            let way = format!("\n<a class=\"skip\" href=\"#{id}\">Skip to the figure</a>");
            format!("{}{way}{}", &page[..at], &page[at..])
        }
        _ => page.to_owned(),
    }
}

/// Writes all files of a kind in a folder and below it anew.
fn rewrite(folder: &Path, kind: &str, change: &dyn Fn(&str) -> anyhow::Result<String>) -> anyhow::Result<()> {
    let entries = fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    for entry in entries {
        let path = entry.with_context(|| format!("cannot read {}", folder.display()))?.path();
        if path.is_dir() {
            rewrite(&path, kind, change)?;
        } else if path.extension().is_some_and(|of| of == kind) {
            let text = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
            let text = change(&text).with_context(|| format!("cannot finish {}", path.display()))?;
            fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
        }
    }
    Ok(())
}

/// Compiles and runs every Rust block of a book, whose chapters are in the workspace `root`.
///
/// rustdoc needs exactly one library for each crate, and a `target` directory may hold several; so Cargo is
/// asked for those of one build of the examples' package, and they are linked into `target/book-libs`. mdBook
/// itself writes what rustdoc says about a failing block to standard error.
pub fn test(book: &'static Book, root: &Path) -> anyhow::Result<()> {
    let mut source = warnings::refuse(|| load(root, Press::afresh(book)))?;
    let libraries = libraries::link(root, book.examples.package)?;
    let path = libraries
        .to_str()
        .with_context(|| format!("{} is not UTF-8: move the workspace to a path that is", libraries.display()))?;
    warnings::refuse(|| source.test(vec![path]))
        .with_context(|| format!("the blocks of the book in {}", source.root.display()))
}

fn load(root: &Path, preprocessor: impl Preprocessor + 'static) -> anyhow::Result<MDBook> {
    let source = root.join("book");
    let source = source
        .canonicalize()
        .with_context(|| format!("no book at {}: name the directory that holds `book`", source.display()))?;
    let mut book =
        MDBook::load(&source).with_context(|| format!("cannot load {}", source.join("book.toml").display()))?;
    book.with_preprocessor(preprocessor);
    Ok(book)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pages::generate_summary;
    use crate::samples::BOOK;
    use anyhow::ensure;
    use mdbook_preprocessor::PreprocessorContext;
    use mdbook_preprocessor::book::Book as Chapters;
    use std::fs;
    use tempfile::TempDir;

    mod cache;

    /// Adds nothing, or fails.
    struct Still {
        fails: bool,
    }

    impl Preprocessor for Still {
        fn name(&self) -> &str {
            BOOK.imprint.program
        }

        fn run(&self, _: &PreprocessorContext, book: Chapters) -> anyhow::Result<Chapters> {
            ensure!(!self.fails, "chapter.md: line 3: no such claim");
            Ok(book)
        }
    }

    /// A workspace with a book of one chapter; its preprocessor command would fail.
    fn workspace() -> TempDir {
        let root = TempDir::new().unwrap();
        let source = root.path().join("book/src");
        fs::create_dir_all(&source).unwrap();
        let settings = "[book]\ntitle = \"A trial\"\n[preprocessor.sample]\ncommand = \"false\"\n";
        fs::write(root.path().join("book/book.toml"), settings).unwrap();
        fs::write(source.join("SUMMARY.md"), "- [Chapter](chapter.md)\n").unwrap();
        fs::write(source.join("chapter.md"), "# Chapter\n\nText.\n").unwrap();
        root
    }

    fn attempt(root: &TempDir, out: &str, fails: bool) -> Result<PathBuf, String> {
        let built = build_with(&BOOK, root.path(), &root.path().join(out), Still { fails }, &Shelf::empty());
        built.map(|built| built.first_page).map_err(|error| format!("{error:#}"))
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// A workspace with a book of one chapter, at which the preprocessor looks.
    fn workspace_of(chapter: &str) -> TempDir {
        let root = workspace();
        let source = root.path().join("book/src");
        fs::remove_file(source.join("chapter.md")).unwrap();
        let (summary_path, summary) = generate_summary(&BOOK.pages[1..]);
        assert!(summary_path.ends_with("src/SUMMARY.md"));
        fs::write(source.join("SUMMARY.md"), summary).unwrap();
        for page in &BOOK.pages[1..] {
            let text = match page.name {
                "pin" => chapter,
                "about" => "# Sources\n\n{{works}}\n",
                "errata" => "# Errata\n\n{{records:errata}}\n",
                "ledger" => "# All claims\n\n{{records:ledger}}\n",
                _ => "# Another\n\nText.\n",
            };
            fs::write(source.join(page.name).with_extension("md"), text).unwrap();
        }
        root
    }

    #[test]
    fn a_book_has_its_own_keys_figures_tables_and_works() {
        let root = workspace_of(
            "# Chapter\n\nTwice 21 is {{double:21}} as in {{cite:johnson}}.\n\n{{figure:circle}}\n\n{{table:rows; Rows}}\n\nSee {{ref:rows}}. \
             It takes {{claim:leaflet.time}}.\n\n{{erratum:leaflet.speed}}\n\n{{compare:leaflet; Printed and computed}}\n",
        );
        let first = build(&BOOK, root.path(), &root.path().join("out")).expect("built").first_page;
        let read = |file: &str| fs::read_to_string(first.with_file_name(file)).expect(file);
        let page = read("pin.html");
        for part in [
            "Twice 21 is 42",
            "about.html#work-johnson",
            "<svg></svg>",
            "<strong>Figure\u{a0}1.1.</strong>",
            "<h1 class=\"menu-title\">A chapter</h1>",
            "<a href=\"#table-rows\">Table\u{a0}1.1</a>",
            "A sample, version 1.2.3",
            "2.02\u{a0}s</span>",
            "href=\"errata.html#slip-leaflet.speed\"",
        ] {
            assert!(page.contains(part), "the page has no `{part}`: {page}");
        }
        assert!(read("about.html").contains("<li id=\"work-johnson\">"));
        assert!(read("errata.html").contains("id=\"slip-leaflet.speed\""));
        let ledger = read("ledger.html");
        assert_eq!(ledger.matches("<li id=\"leaflet.").count(), BOOK.ledger.claims().len());
        assert!(ledger.contains("<option value=\"documents\">the document</option>"), "{ledger}");
        assert_eq!(read("data/circle.csv"), "x\n1\n");
        assert_eq!(read("data/table-rows.csv"), "x,y\n1,2\n");
        assert!(read("data/claims.json").contains("\"title\": \"A sample\""));
        assert!(read(print::FILE).contains("<p class=\"title\">A sample</p>"));
    }

    #[test]
    fn an_unknown_key_and_a_misspelt_argument_stop_the_build_with_file_line_and_the_nearest_name() {
        for (braces, why) in [
            ("{{doubel:21}}", "no placeholder `doubel`; the nearest is `double`"),
            ("{{figure:circel}}", "no figure `circel`; the nearest is `circle`"),
            ("{{table:row}}", "no table `row`; the nearest is `rows`"),
            ("{{cite:jonson}}", "no work `jonson`; the nearest is `johnson`"),
        ] {
            let root = workspace_of(&format!("# Chapter\n\nOf {braces}.\n"));
            let error = build(&BOOK, root.path(), &root.path().join("out")).expect_err(braces);
            let error = format!("{error:#}");
            assert!(error.contains(&format!("pin.md: line 3: {why}")), "{error}");
            assert_eq!(names(root.path()), ["book"], "a book is there");
        }
    }

    #[test]
    fn a_book_is_built_and_built_again() {
        let root = workspace();
        let first = attempt(&root, "new/place/out", false).unwrap();
        assert!(first.is_file() && first.ends_with("new/place/out/index.html"));
        let (page, list) = (fs::read(&first).unwrap(), fs::read_to_string(first.with_file_name(list::NAME)).unwrap());
        assert!(list.lines().any(|line| line == "chapter.html") && list.lines().any(|line| line.starts_with("css/")));

        // A page of an older book goes away with it.
        fs::write(first.with_file_name("stale.html"), "").unwrap();
        fs::write(first.with_file_name(list::NAME), format!("{list}stale.html\n")).unwrap();
        attempt(&root, "new/place/out", false).unwrap();
        assert_eq!(fs::read(&first).unwrap(), page);
        assert_eq!(fs::read_to_string(first.with_file_name(list::NAME)).unwrap(), list);
        assert!(!first.with_file_name("stale.html").exists());
        assert_eq!(names(&root.path().join("new/place")), ["out"]);
    }

    #[test]
    fn files_of_others_in_the_output_stop_the_build_before_it_begins() {
        let root = workspace();
        let first = attempt(&root, "out", false).unwrap();
        let out = first.parent().unwrap();
        let page = fs::read(&first).unwrap();
        for folder in [".git", "photos"] {
            fs::create_dir(out.join(folder)).unwrap();
        }
        let mine = ["CNAME", "MY_NOTES.txt", ".git/HEAD", "photos/one.jpg"].map(|file| out.join(file));
        mine.iter().for_each(|file| fs::write(file, "mine").unwrap());
        // This build would fail.
        let error = attempt(&root, "out", true).unwrap_err();
        assert!(error.contains("`.git/`, `CNAME`, `MY_NOTES.txt`, `photos/`. Move the rest out"), "{error}");
        assert!(mine.iter().all(|file| fs::read(file).unwrap() == b"mine"));
        assert_eq!(fs::read(&first).unwrap(), page);
        assert_eq!(names(root.path()), ["book", "out"]);
    }

    #[test]
    fn a_page_with_the_phrases_of_the_book_is_no_book() {
        let root = workspace();
        fs::create_dir(root.path().join("out")).unwrap();
        fs::write(root.path().join("out/index.html"), "<!-- Book generated using mdBook --> A trial").unwrap();
        fs::write(root.path().join("out/thesis.txt"), "mine").unwrap();
        let error = attempt(&root, "out", false).unwrap_err();
        assert!(error.contains("did not write: `index.html`, `thesis.txt`. Delete them if"), "{error}");
        assert_eq!(names(&root.path().join("out")), ["index.html", "thesis.txt"]);
        assert_eq!(names(root.path()), ["book", "out"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_the_output_stays_a_link() {
        let root = workspace();
        fs::create_dir(root.path().join("real")).unwrap();
        std::os::unix::fs::symlink("real", root.path().join("out")).unwrap();
        for _ in 0..2 {
            attempt(&root, "out", false).unwrap();
            assert!(root.path().join("out").is_symlink() && root.path().join("real/index.html").is_file());
        }
        assert_eq!(names(root.path()), ["book", "out", "real"]);
    }

    #[test]
    fn an_empty_directory_is_filled() {
        let root = workspace();
        fs::create_dir(root.path().join("out")).unwrap();
        attempt(&root, "out", false).unwrap();
    }

    #[test]
    fn a_failed_build_leaves_the_old_book() {
        let root = workspace();
        let first = attempt(&root, "out", false).unwrap();
        let page = fs::read_to_string(&first).unwrap();
        let error = attempt(&root, "out", true).unwrap_err();
        assert!(error.contains("line 3: no such claim") && error.contains("is as it was"), "{error}");
        assert_eq!(fs::read_to_string(&first).unwrap(), page);
        assert_eq!(names(root.path()), ["book", "out"]);
    }

    #[test]
    fn what_mdbook_warns_of_stops_the_build_in_its_words() {
        let root = workspace();
        let source = root.path().join("book/src");
        let chapter = |text: &str| fs::write(source.join("chapter.md"), text).unwrap();
        // The preprocessor of this book looks at nothing, so that mdBook meets the fault.
        for (text, words) in [
            ("# Chapter\n\n{{#include nofile.txt}}\n", ["Error updating", "{{#include nofile.txt}}", "nofile.txt)"]),
            ("# Chapter\n\n<div>\n\nText.\n", ["unclosed", "<div>", "chapter"]),
        ] {
            chapter(text);
            let error = attempt(&root, "out", false).unwrap_err();
            assert!(error.contains("mdBook warns") && words.iter().all(|word| error.contains(word)), "{error}");
            assert_eq!(names(root.path()), ["book"]);
        }
        fs::write(source.join("SUMMARY.md"), "- [Chapter](chapter.md) and more\n").unwrap();
        chapter("# Chapter\n\nText.\n");
        attempt(&root, "out", false).unwrap();
    }

    #[test]
    fn a_place_that_cannot_be_used_stops_the_build_before_it_begins() {
        let root = workspace();
        fs::write(root.path().join("file"), "").unwrap();
        for (out, why) in [
            ("book", "holds files that this command did not write: `book.toml`, `src/`"),
            ("book/src/out", "is in the folder of the chapters"),
            ("file", "is not a folder"),
            ("file/out", "cannot make the folder"),
        ] {
            let error = attempt(&root, out, true).unwrap_err();
            assert!(error.contains(why) && error.contains("choose another output folder"), "{error}");
        }
        assert_eq!(names(root.path()), ["book", "file"]);
        assert_eq!(names(&root.path().join("book")), ["book.toml", "src"]);
    }

    #[test]
    fn a_missing_book_is_named() {
        let root = TempDir::new().unwrap();
        let error = attempt(&root, "out", false).unwrap_err();
        assert!(error.contains("no book at"), "{error}");
        assert!(names(root.path()).is_empty());
    }
}
