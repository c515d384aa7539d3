//! Does a reader get what the pages promise? Opens every page of the book in a browser: at the width of a phone, of a
//! tablet and of two screens, light, dark and on paper, by keyboard alone and without scripts.

pub(crate) mod devtools;
mod formulas;
mod letters;
mod margin;
mod policy;

use devtools::{Browser, Medium};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::sync::{Mutex, OnceLock};
use tempfile::TempDir;

/// The widths of a phone, a tablet and two screens, in pixels, the one last at which most is checked.
const WIDTHS: [u32; 4] = [PHONE, 768, 1920, WIDE];
const PHONE: u32 = 390;

/// From this width on nothing scrolls sideways.
const WIDE: u32 = 1280;

/// A sheet of A4 without the margins that `geneva.css` gives it, in pixels of 1/96 inch.
const SHEET: u32 = 673;

/// Half of its height: what may not break leaves at most as much of a sheet white.
const HALF_A_SHEET: u32 = 480;

/// What finds faults of accessibility: <https://github.com/dequelabs/axe-core>, version 4.11.0.
const AXE: &str = "tests/browser/axe.min.js";

/// What may scroll sideways where the screen is narrow: a formula whose lines are aligned below one another, for no browser
/// breaks its lines, and broken they would not be aligned.
const SCROLLING: &str = ":is(.display, .form):has(mtable)";

/// What a finger hits, in pixels: WCAG 2.2, success criterion 2.5.8.
const TARGET: u32 = 24;

/// The height of the smallest letters of a figure, in pixels, and how far two labels' boxes may touch.
const SMALLEST: u32 = 11;
const TOUCHING: u32 = 2;

/// Units that begin no line, without the number before them.
const UNITS: [&str; 15] = ["mm", "m", "s", "ms", "rad/s", "m/s", "mm/s", "rpm", "N", "kg", "%", "kB", "MB", "V", "Hz"];

/// What is left as it is: kind of fault, page (or none for every page), beginning of the place, and why.
type Exception = (&'static str, Option<&'static str>, &'static str, &'static str);

/// One that is not needed any more is a fault.
const EXCEPTIONS: &[Exception] = &[
    (
        "axe aria-allowed-attr",
        None,
        "#mdbook-sidebar-toggle",
        "mdBook's own: a label that says whether the list is open",
    ),
    ("axe region", None, "#mdbook-menu-bar", "mdBook's own: its bar is no landmark"),
    ("axe region", None, "#mdbook-sidebar-toggle", "mdBook's own: its bar is no landmark"),
];

/// What is wrong with `browser/faulty.html`, and in which ways of showing it.
const FAULTS: &[&str] = &[
    "axe color-contrast #faint: Light 390 1280",
    "axe color-contrast #faint-in-the-dark: Dark 390 1280",
    "axe empty-table-header #no-heading: Light 1280, Dark 390",
    "axe empty-table-header #unnamed-formula: Light 1280, Dark 390",
    "axe scrollable-region-focusable #unreached-scroller: Light 1280, Dark 390",
    "axe target-size #small-summary: Light 1280, Dark 390",
    "console page: Light 1280, Dark 390 1280",
    "cut #cut: Light 390 768 1280 1920, Paper 673",
    "cut #outside: Light 390 768 1280 1920",
    "error page: Dark 390 1280",
    "halo #halo: Dark 1280",
    "keyboard #unreached: Light 1280",
    "keyboard #unseen: Light 1280",
    "letter R: Dark 1280",
    "note #opens-nothing: Light 390 768 1280 1920",
    "note #unseen-note: Light 390 768 1280 1920",
    "overlap #overlap: Light 390 768 1280 1920",
    "overlap #turned: Light 390 768 1280 1920",
    "parted #alone: Light 390 768 1280 1920",
    "parted #unit: Light 390 768 1280 1920",
    "policy page: Light 1280",
    "request page: Light 1280, Dark 390 1280",
    "scheme #dark-right: Dark 1280",
    "scheme #for-the-dark: Dark 1280",
    "scheme page: Dark 1280",
    "scripts page: Light 1280",
    "scroller #unreached-scroller: Light 390 768 1280 1920",
    "small #index: Light 390 768 1280 1920",
    "small #phone: Light 390",
    "small #tiny: Light 390 768 1280 1920",
    "target #small-mark: Light 390",
    "target #small-summary: Light 390",
    "unbroken #unbroken: Paper 673",
    "wide #beside: Light 390",
    "wide #code: Light 390 768 1280 1920",
    "wide #display: Light 1280 1920, Paper 673",
    "wide #folded: Light 390 768 1280 1920, Paper 673",
    "wide #left: Light 390 768 1280 1920",
    "wide #phone-box: Light 390",
    "wide #sheet-box: Paper 673",
    "wide #table: Light 390 768 1280 1920, Paper 673",
    "wide #unreached-scroller: Light 390 768 1280 1920, Paper 673",
    "wide #word: Light 390 768 1280 1920, Paper 673",
    "wide page: Light 390 768 1280 1920, Paper 673",
];

/// Something wrong with a page, as it was shown.
struct Fault {
    page: String,
    view: (u32, Medium),
    kind: String,
    at: String,
    what: String,
}

/// What the browser tells of a page besides what its elements show: errors, and requests for what is not in its folder.
fn reported(events: &[Value], folder: &str) -> Vec<(&'static str, String)> {
    let mut found = Vec::new();
    for event in events {
        let told = &event["params"];
        let is_bad = |kind: &Value| ["error", "warning", "assert"].iter().any(|bad| kind == bad);
        match event["method"].as_str().unwrap_or_default() {
            "Runtime.exceptionThrown" => {
                let details = &told["exceptionDetails"];
                let text = details["exception"]["description"].as_str().or(details["text"].as_str());
                found.push(("error", text.unwrap_or_default().lines().next().unwrap_or_default().to_owned()));
            }
            "Runtime.consoleAPICalled" if is_bad(&told["type"]) => {
                found.push(("console", told["args"][0]["value"].to_string()));
            }
            "Log.entryAdded" if is_bad(&told["entry"]["level"]) => {
                let [text, url] = ["text", "url"].map(|part| told["entry"][part].as_str().unwrap_or_default());
                found.push(("console", format!("{text} {url}")));
            }
            "Network.requestWillBeSent" => {
                let url = told["request"]["url"].as_str().unwrap_or_default();
                let is_inside = url.strip_prefix(folder).is_some_and(|path| path.starts_with('/'));
                // What the page itself has made, as the script of a thread, comes from nowhere else.
                let is_own = ["data:", "blob:"].iter().any(|scheme| url.starts_with(scheme));
                if !is_inside && !is_own && !url.ends_with(AXE) {
                    found.push(("request", format!("asks for {url}")));
                }
            }
            _ => {}
        }
    }
    found
}

fn address(folder: &Path) -> String {
    format!("file://{}", folder.display())
}

/// Looks at one page in all ways.
struct Look<'a> {
    browser: &'a mut Browser,
    folder: &'a Path,
    page: &'a str,
    view: (u32, Medium),
    opened: (u32, Medium),
    faults: Vec<Fault>,
}

impl Look<'_> {
    fn fault(&mut self, kind: &str, at: &str, what: &str) {
        let [page, kind, at, what] = [self.page, kind, at, what].map(str::to_owned);
        self.faults.push(Fault { page, view: self.view, kind, at, what });
    }

    /// Opens the page anew, as it is shown to one who comes with this screen.
    fn open(&mut self, width: u32, medium: Medium) {
        self.events();
        self.view = (width, medium);
        self.opened = self.view;
        self.browser.show(width, medium);
        self.browser.open(&format!("{}/{}", address(self.folder), self.page));
    }

    /// Has the functions of `browser/check.js` in the open page, and everything that is folded opened.
    fn unfold(&mut self) {
        self.browser.evaluate(include_str!("browser/check.js"));
        self.browser.evaluate("geneva.unfold()");
    }

    /// Shows the page that is open in another way.
    fn turn(&mut self, width: u32, medium: Medium) {
        self.view = (width, medium);
        self.browser.turn(width, medium);
    }

    /// Takes note of what has happened since the page was opened.
    fn events(&mut self) {
        self.view = self.opened;
        let events = self.browser.events();
        for (kind, what) in reported(&events, &address(self.folder)) {
            self.fault(kind, "page", &what);
        }
    }

    /// Shows the page for these functions of `browser/check.js`, notes the faults that they find, and gives what one of them
    /// says that finds none.
    fn check(&mut self, checks: &[String]) -> Value {
        let calls: Vec<_> = checks.iter().map(|check| format!("() => geneva.{check}")).collect();
        let said = self.browser.evaluate(&format!("geneva.shown({})", calls.join(", ")));
        for fault in said.as_array().into_iter().flatten().filter_map(Value::as_array).flatten() {
            let part = |name: &str| fault[name].as_str().unwrap_or_default();
            self.fault(part("kind"), part("at"), part("what"));
        }
        said.as_array().into_iter().flatten().find(|of| of.is_object()).cloned().unwrap_or_default()
    }

    /// What is checked in every way of showing a page.
    fn boxes(&self) -> Vec<String> {
        let scrolling = match self.view {
            (_, Medium::Paper) => "",
            (width, _) if width < WIDE => SCROLLING,
            _ => "",
        };
        let mut checks = vec![format!("tooWide({})", json!(scrolling))];
        if self.view.1 != Medium::Paper {
            checks.extend(["drawings()".to_owned(), format!("labels({SMALLEST}, {TOUCHING})"), "notes()".to_owned()]);
            checks.extend([format!("parted({})", json!(UNITS)), "scrollers()".to_owned()]);
        } else {
            checks.push(format!("unbroken({HALF_A_SHEET})"));
        }
        checks
    }

    fn everything(&mut self) {
        // Whatever changes, the width or the medium, has the browser look up all styles anew. So each way is shown once. Of
        // light and dark one is enough where the boxes are looked at, for a style that knew them apart by more than colours
        // would be a fault. The page follows the system from dark to light; that it also follows it back, and begins in the
        // light, is a test of its own.
        self.open(WIDE, Medium::Dark);
        for (letter, what) in letters::touch(self.browser, self.page) {
            self.fault("letter", &letter, &what);
        }
        self.unfold();
        self.browser.evaluate(&format!("geneva.load({})", json!(address(&crate::path(AXE)))));
        self.check(&[self.boxes(), ["contrast()", "schemes()", "halos()"].map(str::to_owned).to_vec()].concat());
        self.turn(SHEET, Medium::Paper);
        self.check(&self.boxes());
        let mut read = Value::Null;
        for width in WIDTHS {
            self.turn(width, Medium::Light);
            let list = if width < WIDE { "closeList()" } else { "openList()" };
            let mut checks = [vec![list.to_owned()], self.boxes()].concat();
            match width {
                PHONE => checks.extend([format!("targets({TARGET})"), "contrast()".to_owned()]),
                WIDE => checks.extend(["content()", "keyboard()", "contrast()", "accessibility()"].map(str::to_owned)),
                _ => {}
            }
            read = self.check(&checks);
        }
        self.policy();
        self.without_scripts(&read);
        self.on_a_phone_in_the_dark();
    }

    /// What axe-core finds depends on the width, and what it finds of colours, on the medium, too.
    fn on_a_phone_in_the_dark(&mut self) {
        self.open(PHONE, Medium::Dark);
        self.unfold();
        self.browser.evaluate(&format!("geneva.load({})", json!(address(&crate::path(AXE)))));
        self.check(&["closeList()", "contrast()", "accessibility()"].map(str::to_owned));
        self.events();
    }

    /// Nothing runs that is put into the page.
    fn policy(&mut self) {
        self.events();
        self.turn(WIDE, Medium::Light);
        self.browser.evaluate("geneva.show()");
        for hole in policy::holes(self.browser) {
            self.fault("policy", "page", &hole);
        }
    }

    /// Without scripts the same can be read.
    fn without_scripts(&mut self, read: &Value) {
        self.browser.run_scripts(false);
        self.open(WIDE, Medium::Light);
        self.unfold();
        let left = self.check(&["content()".to_owned()]);
        self.browser.run_scripts(true);
        for part in ["counts", "text"] {
            let [with, without] = [read, &left].map(|of| of[part].as_str().unwrap_or_default().to_owned());
            // A script puts the rows of the ledger in another order, under headings of its own.
            let is_ordered = self.page == "ledger.html" && part == "text";
            let [with, without] = [with, without].map(|text| if is_ordered { characters_of_rows(&text) } else { text });
            if with != without {
                let from = with.chars().zip(without.chars()).take_while(|(a, b)| a == b).count();
                let [with, without] =
                    [with, without].map(|of| of.chars().skip(from.saturating_sub(10)).take(50).collect::<String>());
                self.fault("scripts", "page", &format!("without scripts “{without}”, with them “{with}”"));
            }
        }
        self.events();
    }
}

/// All faults of these pages. As many browsers look as the machine has cores for; none, if there is no browser.
fn faults(folder: &Path, pages: &[String]) -> Option<Vec<Fault>> {
    let first = Browser::start()?;
    let pages = Mutex::new(pages.iter());
    let next = || pages.lock().ok().and_then(|mut pages| pages.next());
    let look_on = |mut browser: Browser| {
        let mut found = Vec::new();
        while let Some(page) = next() {
            let view = (WIDE, Medium::Light);
            let mut look = Look { browser: &mut browser, folder, page, view, opened: view, faults: Vec::new() };
            look.everything();
            found.extend(look.faults);
        }
        found
    };
    let others = std::thread::available_parallelism().map_or(1, usize::from).min(4) - 1;
    std::thread::scope(|scope| {
        let others: Vec<_> =
            (0..others).map(|_| scope.spawn(|| Browser::start().map(look_on).unwrap_or_default())).collect();
        let mut found = look_on(first);
        for other in others {
            found.extend(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        Some(found)
    })
}

/// The faults in one list: those of a kind together, each with its pages and all ways of showing them in which it is.
fn list(faults: &[&Fault]) -> String {
    let mut ways: BTreeMap<_, BTreeMap<_, &str>> = BTreeMap::new();
    for fault in faults {
        // How much it is differs from width to width.
        let (what, much) = fault.what.rsplit_once(", by ").unwrap_or((&fault.what, ""));
        let of_one = ways.entry((&fault.kind, &fault.page, &fault.at, what)).or_default();
        of_one.insert((fault.view.1, fault.view.0), much);
    }
    let mut pages: BTreeMap<_, Vec<&str>> = BTreeMap::new();
    for ((kind, page, at, what), of_one) in &ways {
        pages.entry((*kind, views(of_one), *at, *what)).or_default().push(page);
    }
    let mut kinds: BTreeMap<_, Vec<String>> = BTreeMap::new();
    for ((kind, views, at, what), pages) in pages {
        kinds.entry(kind).or_default().push(format!("{} | {views} | {at} | {what}", pages.join(" ")));
    }
    let mut text = String::new();
    for (kind, mut lines) in kinds {
        lines.sort();
        let _ = writeln!(text, "\n== {kind}: {}\n{}", lines.len(), lines.join("\n"));
    }
    text
}

/// In which ways of showing a page a fault is, and how much it is there.
fn views(all: &BTreeMap<(Medium, u32), &str>) -> String {
    let mut media: BTreeMap<Medium, Vec<String>> = BTreeMap::new();
    for ((medium, width), much) in all {
        let much = if much.is_empty() { String::new() } else { format!(" ({much})") };
        media.entry(*medium).or_default().push(format!("{width}{much}"));
    }
    // What is wrong in the light, too, needs no mention.
    let light = media.get(&Medium::Light).cloned().unwrap_or_default();
    media.retain(|medium, widths| *medium != Medium::Dark || widths.iter().any(|width| !light.contains(width)));
    let ways = media.into_iter().map(|(medium, widths)| format!("{medium:?} {}", widths.join(" ")));
    ways.collect::<Vec<_>>().join(", ")
}

/// What has a test of its own.
const APART: [&str; 2] = ["letter", "policy"];

/// All faults of the book's pages, which are opened once for all tests that ask; none, if there is no browser.
fn of_the_book() -> Option<&'static [Fault]> {
    static FOUND: OnceLock<Option<Vec<Fault>>> = OnceLock::new();
    FOUND.get_or_init(|| faults(crate::book_pages::book(), &crate::book_pages::names())).as_deref()
}

/// No page of the book has a fault of this kind.
#[track_caller]
fn assert_none_of_the_book(kind: &str) {
    assert!(APART.contains(&kind));
    let found: Vec<_> = of_the_book().into_iter().flatten().filter(|fault| fault.kind == kind).collect();
    assert!(found.is_empty(), "{}", list(&found));
}

/// The characters of the ledger's rows in whatever order the rows are, without the headings that only a script puts between them.
fn characters_of_rows(text: &str) -> String {
    let headings = [
        "Wrong, and a conclusion changes",
        "Wrong, and a result changes",
        "Wrong, but no result or conclusion changes",
        "Wrong only in our copy",
        "Open",
        "Right",
    ];
    let rows = headings.iter().fold(text.to_owned(), |text, heading| text.replace(heading, ""));
    let mut characters: Vec<char> = rows.chars().filter(|c| !c.is_whitespace()).collect();
    characters.sort_unstable();
    characters.into_iter().collect()
}

#[test]
fn every_page_can_be_read_on_every_screen_and_on_paper() {
    let Some(found) = of_the_book() else { return };
    let mut found: Vec<_> = found.iter().filter(|fault| !APART.contains(&&*fault.kind)).collect();
    let is_excused = |fault: &Fault, (kind, page, at, _): &Exception| {
        fault.kind == *kind && page.is_none_or(|page| page == fault.page) && fault.at.starts_with(at)
    };
    for exception in EXCEPTIONS {
        assert!(found.iter().any(|fault| is_excused(fault, exception)), "not needed any more: {exception:?}");
    }
    found.retain(|fault| !EXCEPTIONS.iter().any(|exception| is_excused(fault, exception)));
    assert!(found.is_empty(), "{}", list(&found));
}

#[test]
fn each_fault_of_a_faulty_page_is_found() {
    let folder = TempDir::new().expect("a folder");
    std::fs::write(folder.path().join("faulty.html"), include_str!("browser/faulty.html")).expect("written");
    let Some(found) = faults(folder.path(), &["faulty.html".to_owned()]) else { return };
    let mut ways: BTreeMap<_, BTreeMap<_, &str>> = BTreeMap::new();
    for fault in &found {
        ways.entry((&*fault.kind, &*fault.at)).or_default().insert((fault.view.1, fault.view.0), "");
    }
    let ways: Vec<_> =
        ways.into_iter().map(|((kind, at), of_one)| format!("{kind} {at}: {}", views(&of_one))).collect();
    assert_eq!(ways, FAULTS, "{}", list(&found.iter().collect::<Vec<_>>()));
}

#[test]
fn a_reader_who_comes_in_the_dark_gets_the_page_that_one_gets_who_turns_it() {
    let Some(mut browser) = Browser::start() else { return };
    let page = format!("{}/pin.html", address(crate::book_pages::book()));
    let colours = "[document.documentElement.className, ...['body', 'main a', 'main svg'].map(of => { const style = \
                   getComputedStyle(document.querySelector(of)); return style.color + style.backgroundColor })]";
    let mut seen = |media: &[Medium]| {
        browser.show(WIDE, media[0]);
        browser.open(&page);
        media.iter().for_each(|medium| browser.turn(WIDE, *medium));
        browser.evaluate(colours)
    };
    let (light, dark) = (seen(&[Medium::Light]), seen(&[Medium::Dark]));
    assert_eq!(seen(&[Medium::Light, Medium::Dark]), dark);
    assert_eq!(seen(&[Medium::Dark, Medium::Light]), light);
    assert_ne!(light, dark);
}

#[test]
fn an_arrow_key_turns_the_page_except_where_something_scrolls_by_it() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(WIDE, Medium::Light);
    browser.open(&format!("{}/pin.html", address(crate::book_pages::book())));
    for (within, turns) in [("main .display", false), ("body", true)] {
        let focus = format!("const at = document.querySelector('{within}'); at.tabIndex = 0; at.focus()");
        browser.evaluate(&format!("{{ {focus} }}"));
        browser.events();
        browser.press("ArrowRight", 39);
        browser.evaluate("null");
        let turned = browser.events().iter().any(|event| event["method"] == "Page.frameRequestedNavigation");
        assert_eq!(turned, turns, "within {within}");
    }
}

#[test]
fn the_first_press_of_the_tab_key_offers_a_way_past_the_list_of_chapters() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(WIDE, Medium::Light);
    browser.open(&format!("{}/pin.html", address(crate::book_pages::book())));
    browser.press("Tab", 9);
    let at = "(() => { const at = document.activeElement, { top, height } = at.getBoundingClientRect(); \
              return [at.textContent, top >= 0 && height >= 24] })()";
    assert_eq!(browser.evaluate(at), json!(["Skip to the text", true]));
    browser.command(
        "Input.dispatchKeyEvent",
        json!({ "type": "keyDown", "key": "Enter", "text": "\r", "windowsVirtualKeyCode": 13 }),
    );
    browser.press("Tab", 9);
    assert_eq!(browser.evaluate("document.activeElement.closest('main') !== null"), json!(true));
}

#[test]
fn a_page_with_a_figure_to_move_offers_a_way_to_it_right_behind_the_title() {
    let Some(mut browser) = Browser::start() else { return };
    browser.show(WIDE, Medium::Light);
    for page in ["making.html", "quick-return.html"] {
        browser.open(&format!("{}/{page}", address(crate::book_pages::book())));
        // Behind the title, which leads to itself.
        browser.evaluate("{ document.querySelector('main h1 a').focus() }");
        browser.press("Tab", 9);
        let at = "[document.activeElement.textContent, document.activeElement.getBoundingClientRect().top >= 0]";
        assert_eq!(browser.evaluate(at), json!(["Skip to the figure", true]), "{page}");
        browser.command(
            "Input.dispatchKeyEvent",
            json!({ "type": "keyDown", "key": "Enter", "text": "\r", "windowsVirtualKeyCode": 13 }),
        );
        browser.press("Tab", 9);
        let is_within = "document.activeElement.closest('figure')?.matches('[data-live]') ?? false";
        assert_eq!(browser.evaluate(is_within), json!(true), "{page}");
    }
}

#[test]
fn one_test_leaves_nothing_for_the_next_in_the_same_browser() {
    let Some(mut browser) = Browser::start() else { return };
    let page = format!("{}/pin.html", address(crate::book_pages::book()));
    let served = format!("{}/pin.html", crate::live::module::served(crate::book_pages::book()));
    let kept = "[localStorage.length, sessionStorage.length, (await indexedDB.databases()).length, document.cookie, \
                matchMedia('(prefers-color-scheme: dark)').matches, innerWidth === 390, history.length]";
    let look = |browser: &mut Browser, page: &str| {
        browser.open(page);
        browser.evaluate(&format!("(async () => {kept})()"))
    };
    let first = [&page, &served].map(|page| look(&mut browser, page));
    browser.show(PHONE, Medium::Dark);
    for page in [&page, &served] {
        browser.open(page);
        browser.evaluate(
            "localStorage.setItem('one', 1); sessionStorage.setItem('one', 1); document.cookie = 'one=1'; \
             new Promise(done => { indexedDB.open('one').onsuccess = () => done(null) })",
        );
        let left = browser.evaluate(&format!("(async () => {kept})()"));
        assert!((0..3).all(|k| left[k].as_u64() > Some(0)), "{left}");
    }
    let Some(mut next) = browser.again() else { panic!("the browser has ended") };
    assert_eq!([&page, &served].map(|page| look(&mut next, page)), first);
}
