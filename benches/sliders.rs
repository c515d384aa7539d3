//! How long a reader waits for a picture: from the move of a slider of a live figure until the new picture is on the screen.
//!
//! `cargo bench -p geneva-suite --bench sliders --profile dev -- BOOK OTHER_BOOK` opens the pages of built books, such as
//! `target/book`, in Chromium. In each figure it moves one slider by 40 steps, in a desktop's window and in a phone's. With two
//! books they take turns, step by step, so that what else the machine does hits both alike.
//!
//! A step begins with the event `input` and ends with the second frame that begins after the drawing is in the page: the
//! callback of the first one still runs before the browser lays out and paints, and when the second one's runs, the picture
//! has been handed to the screen. (A `PerformanceObserver` of events sees only a person's, and only the frame that follows the event,
//! while a picture comes frames later, from the module's thread.) The same two frames of an empty page are in the table, too:
//! no picture can come sooner.
//!
//! Chromium slows only the page's own thread down. So the module's thread waits after each answer for as long as a slower
//! processor would have gone on.

#[path = "../tests/browser/devtools.rs"]
#[expect(dead_code, reason = "the tests of the pages use the rest")]
mod devtools;

use devtools::{Browser, Medium};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Steps that are measured, and steps before them for the browser to compile what runs often.
const STEPS: usize = 40;
const FIRST: usize = 8;

/// The figures and their sliders, as pages name them.
const FIGURES: [(&str, &str); 4] =
    [("design", "stations"), ("design", "crank-radius"), ("polygon", "crank"), ("escapement", "friction")];

/// The name of an empty page's rows.
const EMPTY: &str = "empty page";

/// A screen, and how soon a picture shall be on it.
struct Screen {
    name: &'static str,
    size: [u32; 2],
    pixels: u32,
    /// By how much its processor is slower than this machine's.
    slowness: u32,
    /// In milliseconds.
    bound: f64,
}

const SCREENS: [Screen; 2] = [
    Screen { name: "1280 px", size: [1280, 800], pixels: 1, slowness: 1, bound: 50.0 },
    Screen { name: "390 px, 4 × slower", size: [390, 664], pixels: 3, slowness: 4, bound: 100.0 },
];

/// What pages have from the beginning: the module's thread tells how long an answer took, and the page keeps it.
const TIMED: &str = r"
    globalThis.sliders = { module: 0, slowness: 1 };
    const timed = slowness => {
        let begun;
        const own = postMessage;
        addEventListener('message', () => { begun = performance.now() });
        globalThis.postMessage = answer => {
            const took = slowness * (performance.now() - begun);
            while (performance.now() < begun + took);
            own({ ...answer, took });
        };
    };
    globalThis.Blob = class extends Blob {
        constructor(parts, options) {
            super(options?.type === 'text/javascript' ? [`(${timed})(${sliders.slowness});`, ...parts] : parts, options);
        }
    };
    globalThis.Worker = class extends Worker {
        constructor(...all) {
            super(...all);
            this.addEventListener('message', ({ data: { took } }) => { sliders.module = took });
        }
    };
";

/// Shows a figure, moves its slider one step on or, at its end, back, and gives milliseconds to the picture and in the module.
const MOVE: &str = r"(async (name, slider) => {
    const frame = () => new Promise(requestAnimationFrame);
    const figure = document.querySelector(`[data-live='${name}']`);
    const input = figure?.querySelector(`input[name='${slider}']`);
    if (!figure || !input) {
        const start = performance.now();
        await frame();
        await frame();
        return [performance.now() - start, 0];
    }
    if (!sliders.step) {
        sliders.step = Number(input.step);
        figure.scrollIntoView({ behavior: 'instant' });
    }
    const painted = new Promise((done, failed) => new MutationObserver((changes, observer) => {
        if (changes.some(({ target, type }) => type === 'childList' && target.matches('.drawing'))) {
            observer.disconnect();
            frame().then(frame).then(done);
        } else if (figure.matches('.refused')) {
            failed(new Error(figure.querySelector('.message').textContent));
        }
    }).observe(figure, { attributeFilter: ['class'], childList: true, subtree: true }));
    const next = Number(input.value) + sliders.step;
    if (next > input.max || next < input.min) {
        sliders.step *= -1;
    }
    input.value = Number(input.value) + sliders.step;
    const start = performance.now();
    input.dispatchEvent(new Event('input', { bubbles: true }));
    await painted;
    return [performance.now() - start, sliders.module];
})";

/// How the time of one step is spent, in milliseconds.
#[derive(Clone, Copy, Default)]
struct Step {
    total: f64,
    /// In the module's thread.
    module: f64,
    /// In the page's thread: scripts with the parser, style with layout, and the rest, most of it paint.
    script: f64,
    layout: f64,
    paint: f64,
}

/// A built book, open in a browser of its own.
struct Book {
    folder: PathBuf,
    browser: Browser,
}

impl Book {
    fn open(folder: &Path) -> Result<Self, String> {
        if !folder.join("index.html").is_file() {
            return Err(format!("{}: there is no index.html; build the book with `cargo run`", folder.display()));
        }
        let folder = folder.canonicalize().map_err(|error| format!("{}: {error}", folder.display()))?;
        let mut browser =
            Browser::start().ok_or("no browser: install Chromium, or name its program in $CHROMIUM".to_owned())?;
        browser.command("Performance.enable", json!({}));
        browser.command("Page.addScriptToEvaluateOnNewDocument", json!({ "source": format!("{{ {TIMED} }}") }));
        Ok(Self { folder, browser })
    }

    /// The page that shows a figure; of the whole book in one page there is no word.
    fn page_of(&self, figure: &str) -> Result<PathBuf, String> {
        let mut pages: Vec<PathBuf> = std::fs::read_dir(&self.folder)
            .map_err(|error| format!("{}: {error}", self.folder.display()))?
            .flatten()
            .map(|entry| entry.path())
            .filter(|path| path.extension().is_some_and(|ending| ending == "html") && !path.ends_with("print.html"))
            .collect();
        pages.sort();
        let marks = ["\"", ""].map(|quote| format!("data-live={quote}{figure}{quote}"));
        let shows = |path: &PathBuf| {
            std::fs::read_to_string(path).is_ok_and(|text| marks.iter().any(|mark| text.contains(mark)))
        };
        pages.into_iter().find(shows).ok_or_else(|| {
            format!(
                "{}: no page has the figure `{figure}`. Its module may not have been compiled: `rustup target add \
                 wasm32-wasip1`, then build the book again with `cargo run`",
                self.folder.display()
            )
        })
    }

    /// Opens a figure's page, or an empty one, on a screen.
    fn show(&mut self, figure: &str, screen: &Screen) -> Result<(), String> {
        let address = match figure {
            EMPTY => "about:blank".to_owned(),
            _ => format!("file://{}", self.page_of(figure)?.display()),
        };
        let browser = &mut self.browser;
        browser.command("Emulation.setCPUThrottlingRate", json!({ "rate": 1 }));
        browser.show_in(screen.size, Medium::Light);
        let [width, height] = screen.size;
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": screen.pixels, "mobile": screen.pixels > 1 });
        browser.command("Emulation.setDeviceMetricsOverride", size);
        browser.open(&address);
        browser.evaluate(&format!("sliders.slowness = {}", screen.slowness));
        browser.command("Emulation.setCPUThrottlingRate", json!({ "rate": screen.slowness }));
        Ok(())
    }

    fn step(&mut self, figure: &str, slider: &str) -> Result<Step, String> {
        let before = self.seconds();
        let taken = self.browser.evaluate(&format!("{MOVE}({}, {})", json!(figure), json!(slider)));
        let after = self.seconds();
        let number = |k: usize| taken[k].as_f64().ok_or_else(|| format!("{figure}: the page gives no time: {taken}"));
        let [script, layout, all] = [0, 1, 2].map(|k| 1000.0 * (after[k] - before[k]));
        Ok(Step { total: number(0)?, module: number(1)?, script, layout, paint: (all - script - layout).max(0.0) })
    }

    /// Seconds that the page's thread has spent: on scripts, on style and layout, on all.
    fn seconds(&mut self) -> [f64; 3] {
        let metrics = self.browser.command("Performance.getMetrics", json!({}));
        let of = |name: &str| -> f64 {
            let all = metrics["metrics"].as_array().map_or(&[][..], Vec::as_slice);
            all.iter().find(|metric| metric["name"] == name).and_then(|metric| metric["value"].as_f64()).unwrap_or(0.0)
        };
        [of("ScriptDuration"), of("LayoutDuration") + of("RecalcStyleDuration"), of("TaskDuration")]
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// A row of the table.
fn row(figure: &str, screen: &Screen, steps: &[Vec<Step>]) -> Vec<String> {
    let part = |steps: &[Step], of: fn(&Step) -> f64| median(steps.iter().map(of).collect());
    let mut cells = vec![figure.to_owned(), screen.name.to_owned()];
    for steps in steps {
        let worst = steps.iter().map(|step| step.total).fold(0.0, f64::max);
        cells.extend([part(steps, |step| step.total), worst].map(|time| format!("{time:.1}")));
    }
    if let [one, other] = steps {
        cells.push(format!("{:.2}", part(one, |step| step.total) / part(other, |step| step.total)));
    }
    let first = &steps[0];
    let total = part(first, |step| step.total);
    let spent: [fn(&Step) -> f64; 4] = [|step| step.module, |step| step.script, |step| step.layout, |step| step.paint];
    cells.extend(spent.map(|of| format!("{:.0} %", 100.0 * part(first, of) / total)));
    cells.push(if total > screen.bound { format!("over {} ms", screen.bound) } else { String::new() });
    cells
}

fn print(rows: &[Vec<String>]) {
    let width = |column: usize| rows.iter().map(|cells| cells[column].chars().count()).max().unwrap_or(0);
    for cells in rows {
        let cells = cells.iter().enumerate().map(|(column, cell)| {
            let width = width(column);
            if column < 2 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        println!("{}", cells.collect::<Vec<_>>().join("  ").trim_end());
    }
}

fn run(folders: &[PathBuf], steps: usize) -> Result<(), String> {
    let mut books = folders.iter().map(|folder| Book::open(folder)).collect::<Result<Vec<_>, _>>()?;
    let mut head = vec!["figure".to_owned(), "window".to_owned()];
    for k in 1..=books.len() {
        head.extend([format!("median {k}"), format!("worst {k}")]);
    }
    head.extend((books.len() == 2).then(|| "ratio".to_owned()));
    head.extend(["module", "script", "layout", "paint", ""].map(str::to_owned));
    let mut rows = vec![head];
    for (figure, slider) in [(EMPTY, "")].into_iter().chain(FIGURES) {
        for screen in &SCREENS {
            for book in &mut books {
                book.show(figure, screen)?;
            }
            let mut taken = vec![Vec::new(); books.len()];
            for step in 0..FIRST + steps {
                for (book, taken) in books.iter_mut().zip(&mut taken) {
                    let time = book.step(figure, slider)?;
                    if step >= FIRST {
                        taken.push(time);
                    }
                }
            }
            rows.push(row(figure, screen, &taken));
        }
    }
    for (k, book) in books.iter().enumerate() {
        println!("book {}: {}", k + 1, book.folder.display());
    }
    println!("milliseconds of {steps} steps; shares of the median of book 1, the rest is waiting for a frame");
    print(&rows);
    Ok(())
}

fn main() -> ExitCode {
    let (options, folders): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|argument| argument.starts_with("--"));
    let is_bench = options.iter().any(|option| option == "--bench");
    let mut folders: Vec<PathBuf> = folders.into_iter().map(PathBuf::from).collect();
    if folders.is_empty() {
        folders.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("target/book"));
    }
    let outcome = if folders.len() > 2 {
        Err("give one folder of a built book, or two to compare".to_owned())
    } else {
        // As a test it only shows that it works.
        run(&folders, if is_bench { STEPS } else { 2 })
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            if is_bench { ExitCode::FAILURE } else { ExitCode::SUCCESS }
        }
    }
}
