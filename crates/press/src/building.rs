//! Building the book and testing its chapters, with mdBook as a library.
//!
//! A reader either has the old book or the new one: pages are rendered beside the output directory and
//! moved over it when all of them are done.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use mdbook_driver::MDBook;
use mdbook_preprocessor::Preprocessor;
use tempfile::TempDir;

use crate::{libraries, minify, policy, search};

/// Renders the book of the workspace `root` into the directory `out`, and returns the path of its first page.
///
/// `preprocessor` takes the place of the command of the same name in `book.toml`. `out` may be absent,
/// empty, or an earlier build of this book; anything else is refused. When something fails, `out` is as it was.
pub fn build(root: &Path, out: &Path, preprocessor: impl Preprocessor + 'static) -> anyhow::Result<PathBuf> {
    let mut book = load(root, preprocessor)?;
    let title = book.config.book.title.clone().unwrap_or_default();
    let out = whole(out)?;
    let old = standing(&out, &title)?;
    let (beside, new) = beside(&out)?;
    book.config.build.build_dir.clone_from(&new);
    book.build().with_context(|| {
        format!("the book in {} does not build; {} is as it was", book.root.display(), out.display())
    })?;
    search::index(&new)?;
    minify::trim(&new)?;
    policy::add(&new)?;
    replace(&out, &new, old, beside)?;
    Ok(out.join("index.html"))
}

/// Compiles and runs every Rust block of the book of the workspace `root`.
///
/// rustdoc needs exactly one library for each crate, and a `target` directory may hold several; so Cargo is
/// asked for those of one build of the root package, and they are linked into `target/book-libs`. After
/// this, plain `mdbook test book -L target/book-libs` works too. mdBook itself writes what rustdoc says
/// about a failing block to standard error.
pub fn test(root: &Path, preprocessor: impl Preprocessor + 'static) -> anyhow::Result<()> {
    let mut book = load(root, preprocessor)?;
    let libraries = libraries::link(root)?;
    let path = libraries
        .to_str()
        .with_context(|| format!("{} is not UTF-8: move the workspace to a path that is", libraries.display()))?;
    book.test(vec![path]).with_context(|| format!("the blocks of the book in {}", book.root.display()))
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

/// `out` as an absolute path, links resolved, its parent made when absent.
fn whole(out: &Path) -> anyhow::Result<PathBuf> {
    if let Ok(out) = out.canonicalize() {
        return Ok(out);
    }
    let out = std::path::absolute(out).with_context(|| format!("not a path: `{}`", out.display()))?;
    let (Some(parent), Some(name)) = (out.parent(), out.file_name()) else {
        bail!("{} cannot be an output directory: name another", out.display());
    };
    fs::create_dir_all(parent)
        .with_context(|| format!("cannot make {}: choose another output directory", parent.display()))?;
    Ok(parent.canonicalize()?.join(name))
}

/// Whether something stands at `out`; an error unless it may be replaced.
fn standing(out: &Path, title: &str) -> anyhow::Result<bool> {
    if !out.exists() {
        return Ok(false);
    }
    ensure!(out.is_dir(), "{} is not a directory: choose another output directory", out.display());
    let empty = fs::read_dir(out)
        .with_context(|| format!("cannot read {}: choose another output directory", out.display()))?
        .next()
        .is_none();
    // A first page made by mdBook under this book's title: ours, whoever ran mdBook.
    let ours = fs::read_to_string(out.join("index.html"))
        .is_ok_and(|page| page.contains("Book generated using mdBook") && page.contains(title));
    ensure!(
        empty || ours,
        "{} holds files and no build of this book; it stays as it is: empty it or choose another output directory",
        out.display()
    );
    Ok(true)
}

/// A temporary directory on the file system of `out`, and the path of the new book in it.
fn beside(out: &Path) -> anyhow::Result<(TempDir, PathBuf)> {
    let parent = out.parent().with_context(|| format!("{} has no parent directory", out.display()))?;
    let beside = tempfile::Builder::new().prefix(".geneva-book-").tempdir_in(parent).with_context(|| {
        format!("cannot write in {}: choose another output directory; {} is as it was", parent.display(), out.display())
    })?;
    let new = beside.path().join("new");
    Ok((beside, new))
}

/// Moves `new` to `out`; the old book waits in `beside` until that is done.
fn replace(out: &Path, new: &Path, old: bool, beside: TempDir) -> anyhow::Result<()> {
    let aside = beside.path().join("old");
    if old {
        fs::rename(out, &aside)
            .with_context(|| format!("cannot move {} aside: choose another output directory", out.display()))?;
    }
    let Err(error) = fs::rename(new, out) else { return Ok(()) };
    if old && fs::rename(&aside, out).is_err() {
        let kept = beside.keep().join("old");
        bail!("cannot move the new book to {}: {error}; the old one is in {}", out.display(), kept.display());
    }
    bail!("cannot move the new book to {}: {error}; choose another output directory", out.display());
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdbook_preprocessor::PreprocessorContext;
    use mdbook_preprocessor::book::Book;

    /// Adds nothing, or fails.
    struct Still {
        fails: bool,
    }

    impl Preprocessor for Still {
        fn name(&self) -> &str {
            "geneva"
        }

        fn run(&self, _: &PreprocessorContext, book: Book) -> anyhow::Result<Book> {
            ensure!(!self.fails, "chapter.md: line 3: no such claim");
            Ok(book)
        }
    }

    /// A workspace with a book of one chapter; its preprocessor command would fail.
    fn workspace() -> TempDir {
        let root = TempDir::new().unwrap();
        let source = root.path().join("book/src");
        fs::create_dir_all(&source).unwrap();
        let settings = "[book]\ntitle = \"A trial\"\n[preprocessor.geneva]\ncommand = \"false\"\n";
        fs::write(root.path().join("book/book.toml"), settings).unwrap();
        fs::write(source.join("SUMMARY.md"), "- [Chapter](chapter.md)\n").unwrap();
        fs::write(source.join("chapter.md"), "# Chapter\n\nText.\n").unwrap();
        root
    }

    fn attempt(root: &TempDir, out: &str, fails: bool) -> Result<PathBuf, String> {
        build(root.path(), &root.path().join(out), Still { fails }).map_err(|error| format!("{error:#}"))
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_book_is_built_and_built_again() {
        let root = workspace();
        let first = attempt(&root, "new/place/out", false).unwrap();
        assert!(first.is_file() && first.ends_with("new/place/out/index.html"));
        let page = fs::read_to_string(&first).unwrap();
        fs::write(first.with_file_name("stale.html"), "").unwrap();
        attempt(&root, "new/place/out", false).unwrap();
        assert_eq!(fs::read_to_string(&first).unwrap(), page);
        assert!(!first.with_file_name("stale.html").exists());
        assert_eq!(names(&root.path().join("new/place")), ["out"]);
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
    fn what_is_not_this_book_is_not_replaced() {
        let root = workspace();
        let error = attempt(&root, "book", false).unwrap_err();
        assert!(error.contains("holds files and no build of this book"), "{error}");
        fs::write(root.path().join("index.html"), "<title>Mine</title>").unwrap();
        assert!(attempt(&root, "", false).unwrap_err().contains("no build of this book"));
        let error = attempt(&root, "index.html", false).unwrap_err();
        assert!(error.contains("is not a directory"), "{error}");
        assert_eq!(names(root.path()), ["book", "index.html"]);
    }

    #[test]
    fn a_place_where_nothing_can_be_written_is_named() {
        let root = workspace();
        fs::write(root.path().join("file"), "").unwrap();
        let error = attempt(&root, "file/out", false).unwrap_err();
        assert!(error.contains("file") && error.contains("choose another output directory"), "{error}");
    }

    #[test]
    fn a_missing_book_is_named() {
        let root = TempDir::new().unwrap();
        let error = attempt(&root, "out", false).unwrap_err();
        assert!(error.contains("no book at"), "{error}");
        assert!(names(root.path()).is_empty());
    }
}
