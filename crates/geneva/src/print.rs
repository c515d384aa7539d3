//! The book as a PDF, printed by a browser.

use crate::output::OutputStreams;
use crate::{progress, signals, workspace};
use anyhow::{Context, bail, ensure};
use clap::Args;
use geneva_chapters::BOOK;
use geneva_press::print::{self, numbers};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Options of `geneva book print`.
#[derive(Args, Debug, Default)]
pub(crate) struct PrintArguments {
    /// Write this file; one that is there is replaced once the new one is complete
    /// [default: target/geneva-verified.pdf in the workspace]
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// By what names the browser goes, where `$CHROMIUM` does not say.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];
/// How often the document is printed at most. The second time has the numbers of the first, which move nothing.
const PRINTS: usize = 4;

/// Prints the book: builds it in a folder of its own, has a browser print the document, puts the numbers of the pages into
/// its contents, and has it printed again.
pub(crate) fn run(wanted: &PrintArguments, streams: &mut dyn OutputStreams) -> anyhow::Result<()> {
    let browser = browser()?;
    let root = workspace::root()?;
    let out = wanted.output.clone().unwrap_or_else(|| root.join("target").join("geneva-verified.pdf"));
    let parent = out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    ensure!(
        parent.is_dir() && !out.is_dir(),
        "cannot write {}: name a file in a folder that is there with --output",
        out.display()
    );
    let folder = tempfile::tempdir().context("cannot make a folder for a while")?;
    let book = folder.path().join("book");
    {
        let _step = progress::step("building the book");
        signals::clear_up_first()?;
        geneva_press::build(&BOOK, &root, &book)?;
    }
    let document = book.join(print::FILE);
    // mdBook has a document of this name, too.
    let is_ours = fs::read_to_string(&document).is_ok_and(|text| numbers::has_contents(&text));
    ensure!(
        is_ours,
        "the book in {} has no page to be printed: no chapter of the list of pages is in it",
        root.display()
    );
    let pdf = folder.path().join("book.pdf");
    let pages = {
        let _step = progress::step("printing");
        let mut before = numbers::PageNumbers::new();
        let mut left = PRINTS;
        loop {
            left -= 1;
            print_once(&browser, folder.path(), &document, &pdf)?;
            let printed = fs::read(&pdf).with_context(|| format!("cannot read {}", pdf.display()))?;
            let places =
                numbers::places(&printed).with_context(|| format!("what {} has printed", browser.display()))?;
            if places == before {
                break numbers::pages(&printed)?;
            }
            ensure!(left > 0, "the numbers in the contents move the pages: print {} in a browser instead", print::FILE);
            let text = fs::read_to_string(&document).with_context(|| format!("cannot read {}", document.display()))?;
            fs::write(&document, numbers::numbered(&text, &places)?)
                .with_context(|| format!("cannot write {}", document.display()))?;
            before = places;
        }
    };
    // The file takes its place only when it is complete.
    let whole =
        tempfile::NamedTempFile::new_in(parent).with_context(|| format!("cannot write in {}", parent.display()))?;
    fs::copy(&pdf, whole.path()).with_context(|| format!("cannot write {}", out.display()))?;
    whole.persist(&out).with_context(|| format!("cannot write {}", out.display()))?;
    streams.print(&streams.layout().folded(&format!("The book is in {}, {pages} pages.\n", out.display())))
}

/// Has the browser print the document.
fn print_once(browser: &Path, folder: &Path, document: &Path, pdf: &Path) -> anyhow::Result<()> {
    let _ = fs::remove_file(pdf);
    let mut command = Command::new(browser);
    command
        // Without a sandbox: it does not start for root or in a container, and only our own page is shown.
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"])
        .args([
            "--disable-component-update",
            "--disable-sync",
            "--disable-extensions",
            "--host-resolver-rules=MAP * ~NOTFOUND",
        ])
        .args(["--no-pdf-header-footer", "--generate-pdf-document-outline", "--font-render-hinting=none"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("--print-to-pdf={}", pdf.display()))
        .arg(format!("file://{}", document.display()))
        .stdin(Stdio::null())
        .stdout(Stdio::null());
    let output = command.output().with_context(|| format!("cannot start {}", browser.display()))?;
    if !output.status.success() || !pdf.is_file() {
        let said = String::from_utf8_lossy(&output.stderr);
        bail!(
            "{} printed nothing ({}): {}",
            browser.display(),
            output.status,
            said.lines().last().unwrap_or("it does not say why")
        );
    }
    Ok(())
}

/// The browser.
fn browser() -> anyhow::Result<PathBuf> {
    let named = env::var_os("CHROMIUM").filter(|name| !name.is_empty()).map(PathBuf::from);
    let folders: Vec<PathBuf> = env::var_os("PATH").map(|path| env::split_paths(&path).collect()).unwrap_or_default();
    let installed =
        || NAMES.iter().find_map(|name| folders.iter().map(|folder| folder.join(name)).find(|path| path.is_file()));
    named.or_else(installed).with_context(|| {
        format!(
            "printing needs Chromium or Chrome, and none of {} is installed: install one, or name its program in $CHROMIUM",
            NAMES.join(", ")
        )
    })
}
