//! A browser without a window, spoken to by the DevTools protocol over a pipe.

use serde_json::{Value, json};
use std::collections::{BTreeSet, VecDeque};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// How long one answer may take, however busy the machine is.
const PATIENCE: Duration = Duration::from_secs(600);

/// What every page has besides its own scripts. `until` gives the value of a function as soon as it is neither null nor
/// false; tests wait for what they wait for by it, and never for a time. And what a page gives up after some seconds, it gives
/// up only when the test does: how long a reader waits is not what a busy machine is asked.
const WAITING: &str = "globalThis.until = async is => { for (;;) { const found = await is(); if (found) { return found } \
     await new Promise(done => setTimeout(done, 10)) } }; \
     { const own = setTimeout; globalThis.setTimeout = (run, time, ...rest) => own(run, time >= 1000 ? 1e9 : time, ...rest) }";

/// The height of a window, in pixels, where a test does not choose one.
const HEIGHT: u32 = 900;

/// By what names the program goes, where `$CHROMIUM` does not say. The first two have no window that they could show, and
/// so take three quarters of the time.
const NAMES: [&str; 5] =
    ["chromium-headless-shell", "chrome-headless-shell", "chromium", "chromium-browser", "google-chrome"];

/// How a page is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Medium {
    Light,
    Dark,
    Paper,
}

/// How a browser sets letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Letters {
    /// As they are drawn, each as wide as the font's table of widths says.
    Exact,
    /// Put on whole pixels, each as wide as its drawing says. The browser does this on desktops that ask for it, and
    /// without a window.
    OnPixels,
}

/// A process that shows the pages of one test after the other. It ends when its pipe is closed, and its profile goes with it.
struct Process {
    letters: Letters,
    shell: Child,
    /// None once it has been told to end.
    commands: Option<ChildStdin>,
    messages: Receiver<Value>,
    calls: u64,
}

/// Processes that no test uses at the moment. A start takes longer than most tests.
static IDLE: Mutex<Vec<Process>> = Mutex::new(Vec::new());

/// One browser with one page. What it keeps is its own and goes with it: no other test sees it.
pub(crate) struct Browser {
    /// None once another test may have it.
    process: Option<Process>,
    events: VecDeque<Value>,
    tab: Value,
    session: Option<String>,
    /// The places of the pages that have been opened: what pages keep, they keep by place.
    origins: BTreeSet<String>,
    /// The window and the medium of [`Self::show_in`]: what does not change is not told again.
    shown: Option<([u32; 2], Medium)>,
}

/// The program, if there is one. `$CHROMIUM` may be empty, and then there is none.
fn program() -> Option<PathBuf> {
    if let Some(told) = std::env::var_os("CHROMIUM") {
        return (!told.is_empty()).then(|| told.into());
    }
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    NAMES.iter().find_map(|name| folders.iter().map(|folder| folder.join(name)).find(|path| path.is_file()))
}

impl Browser {
    /// A browser with an empty page. Where there is none, this says so and gives none; where one must be, it fails.
    pub(crate) fn start() -> Option<Self> {
        Self::start_with(Letters::Exact)
    }

    /// A browser as [`Self::start`] gives it, which sets letters in this way.
    pub(crate) fn start_with(letters: Letters) -> Option<Self> {
        let started = match program() {
            None => Err(format!("none of {} is installed, and $CHROMIUM does not name one", NAMES.join(", "))),
            Some(_) if !cfg!(unix) => Err("its pipe is laid by a Unix shell".to_owned()),
            Some(program) => {
                Self::from(&program, letters).map_err(|why| format!("{} does not start: {why}", program.display()))
            }
        };
        match started {
            Ok(browser) => Some(browser),
            Err(why) => {
                assert!(std::env::var_os("BROWSER_REQUIRED").is_none(), "no browser: {why}");
                // Not by a macro: what a passing test prints by one is not shown.
                let _ = writeln!(std::io::stderr(), "skipped: the pages are not looked at in a browser: {why}");
                None
            }
        }
    }

    fn from(program: &Path, letters: Letters) -> Result<Self, String> {
        let idle = IDLE.lock().ok().and_then(|mut idle| {
            let at = idle.iter().position(|process| process.letters == letters)?;
            Some(idle.swap_remove(at))
        });
        // One that has ended in the meantime is replaced.
        idle.and_then(|process| Self::of(process).ok()).map_or_else(|| Self::of(Process::start(program, letters)?), Ok)
    }

    /// A new tab, apart from all that the process has shown.
    ///
    /// It is one more tab of the first one's window: a window of its own, or a profile, takes several times as long.
    fn of(process: Process) -> Result<Self, String> {
        let is_first = process.calls == 0;
        let (events, origins) = (VecDeque::new(), BTreeSet::new());
        let mut browser =
            Self { process: Some(process), events, tab: Value::Null, session: None, origins, shown: None };
        if is_first {
            browser.ask("Target.createTarget", json!({ "url": "about:blank" }))?;
        }
        let mut target = browser.ask("Target.createTarget", json!({ "url": "about:blank" }))?;
        browser.tab = target["targetId"].take();
        let attached = browser.ask("Target.attachToTarget", json!({ "targetId": browser.tab, "flatten": true }))?;
        browser.session = attached["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page", "Runtime", "Log", "Network"] {
            browser.ask(&format!("{domain}.enable"), json!({}))?;
        }
        browser.ask("Page.setLifecycleEventsEnabled", json!({ "enabled": true }))?;
        browser.ask("Page.addScriptToEvaluateOnNewDocument", json!({ "source": WAITING }))?;
        browser.ask("Emulation.setFocusEmulationEnabled", json!({ "enabled": true }))?;
        Ok(browser)
    }

    /// The next message to this page or to the one who asks, waited for until `end`.
    fn message(&mut self, end: Instant) -> Result<Value, String> {
        let process = self.process.as_ref().ok_or("it has ended")?;
        loop {
            let left = end.saturating_duration_since(Instant::now());
            let message = process.messages.recv_timeout(left).map_err(|why| match why {
                RecvTimeoutError::Timeout => format!("no answer within {} s", PATIENCE.as_secs()),
                RecvTimeoutError::Disconnected => "it has ended".to_owned(),
            })?;
            // What a page of an earlier test still had to say is of no concern.
            let of = message["sessionId"].as_str();
            if of.is_none() || of == self.session.as_deref() {
                return Ok(message);
            }
        }
    }

    fn ask(&mut self, method: &str, parameters: Value) -> Result<Value, String> {
        let process = self.process.as_mut().ok_or("it has ended")?;
        process.calls += 1;
        let call = process.calls;
        let mut command = json!({ "id": call, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            command["sessionId"] = json!(session);
        }
        let pipe = process.commands.as_mut().ok_or("it has ended")?;
        let sent = pipe.write_all(format!("{command}\0").as_bytes()).and_then(|()| pipe.flush());
        sent.map_err(|error| format!("{method}: {error}"))?;
        let end = Instant::now() + PATIENCE;
        loop {
            let mut message = self.message(end).map_err(|why| format!("{method}: {why}"))?;
            if message["id"] == call {
                let error = &message["error"]["message"];
                return if error.is_null() { Ok(message["result"].take()) } else { Err(format!("{method}: {error}")) };
            }
            self.events.push_back(message);
        }
    }

    /// What a command of the protocol gives.
    #[track_caller]
    pub(crate) fn command(&mut self, method: &str, parameters: Value) -> Value {
        self.ask(method, parameters).unwrap_or_else(|why| panic!("the browser: {why}"))
    }

    /// Shows pages from now on at this width, on this medium. The page that is open changes with it.
    pub(crate) fn show(&mut self, width: u32, medium: Medium) {
        self.show_in([width, HEIGHT], medium);
    }

    /// Shows pages from now on in a window of this width and height, on this medium.
    pub(crate) fn show_in(&mut self, window: [u32; 2], medium: Medium) {
        self.size(window);
        self.medium(medium);
        self.shown = Some((window, medium));
    }

    fn size(&mut self, [width, height]: [u32; 2]) {
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.command("Emulation.setDeviceMetricsOverride", size);
    }

    fn medium(&mut self, medium: Medium) {
        let (media, scheme) = match medium {
            Medium::Light => ("screen", "light"),
            Medium::Dark => ("screen", "dark"),
            Medium::Paper => ("print", "light"),
        };
        // Still: what slides into its place would be measured on its way.
        let features = json!([
            { "name": "prefers-color-scheme", "value": scheme },
            { "name": "prefers-reduced-motion", "value": "reduce" },
        ]);
        self.command("Emulation.setEmulatedMedia", json!({ "media": media, "features": features }));
    }

    /// Shows the page that is open at this width, on this medium, and waits until its scripts know. Whatever changes has the
    /// browser look up all styles anew, so what stays is not told again.
    pub(crate) fn turn(&mut self, width: u32, medium: Medium) {
        let window = [width, HEIGHT];
        let (is_new_size, is_new_medium) = self.shown.map_or((true, true), |(size, of)| (size != window, of != medium));
        if is_new_size {
            self.size(window);
        }
        if is_new_medium {
            self.turn_to(medium);
        }
        self.shown = Some((window, medium));
    }

    fn turn_to(&mut self, medium: Medium) {
        let is_dark = medium == Medium::Dark;
        self.evaluate(&format!(
            "globalThis.scheme = matchMedia('(prefers-color-scheme: dark)'); globalThis.turned = scheme.matches === {is_dark} || \
             new Promise(done => scheme.addEventListener('change', () => done(true), {{ once: true }})); null"
        ));
        self.medium(medium);
        self.evaluate("turned");
    }

    /// Whether the scripts of pages that are opened from now on run. Those of [`Self::evaluate`] do.
    pub(crate) fn run_scripts(&mut self, run: bool) {
        self.command("Emulation.setScriptExecutionDisabled", json!({ "value": !run }));
    }

    /// Opens a page, and waits until it is loaded with its fonts.
    #[track_caller]
    pub(crate) fn open(&mut self, address: &str) {
        let path = address.find("://").map_or(0, |at| at + 3);
        let end = address[path..].find('/').map_or(address.len(), |at| path + at);
        self.origins.insert(address[..end].to_owned());
        let opened = self.command("Page.navigate", json!({ "url": address }));
        assert!(opened["errorText"].is_null(), "the browser: {address}: {}", opened["errorText"]);
        let end = Instant::now() + PATIENCE;
        let is_loaded = |event: &Value| {
            let what = &event["params"];
            event["method"] == "Page.lifecycleEvent" && what["name"] == "load" && what["loaderId"] == opened["loaderId"]
        };
        while !self.events.iter().any(is_loaded) {
            let event = self.message(end).unwrap_or_else(|why| panic!("the browser: {address}: {why}"));
            self.events.push_back(event);
        }
        self.evaluate("document.fonts.ready.then(() => null)");
    }

    /// The value of an expression in the page; of a promise, what it promises.
    #[track_caller]
    pub(crate) fn evaluate(&mut self, expression: &str) -> Value {
        let asked = json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let mut answer = self.command("Runtime.evaluate", asked);
        let wrong = &answer["exceptionDetails"];
        assert!(wrong.is_null(), "the browser: {wrong:#}");
        answer["result"]["value"].take()
    }

    /// The page that is open as a PDF, by the size and margins that its style asks for, with an outline of its headings.
    #[track_caller]
    pub(crate) fn print(&mut self) -> Vec<u8> {
        let wanted = json!({
            "preferCSSPageSize": true, "printBackground": true, "generateDocumentOutline": true, "generateTaggedPDF": true,
        });
        let printed = self.command("Page.printToPDF", wanted);
        bytes(printed["data"].as_str().unwrap_or_default())
    }

    /// Waits until the browser is at an address that ends so.
    #[track_caller]
    pub(crate) fn arrive(&mut self, ending: &str) {
        let end = Instant::now() + PATIENCE;
        // Whatever changes the address after it has been asked for is told by a message.
        while !self.address().is_some_and(|address| address.ends_with(ending)) {
            let event = self.message(end).unwrap_or_else(|why| panic!("the browser: {ending}: {why}"));
            self.events.push_back(event);
        }
    }

    /// Where the browser is. While it goes from one page to another, there is none.
    fn address(&mut self) -> Option<String> {
        let history = self.ask("Page.getNavigationHistory", json!({})).ok()?;
        let now = usize::try_from(history["currentIndex"].as_u64()?).ok()?;
        history["entries"][now]["url"].as_str().map(str::to_owned)
    }

    /// Presses a key: its name, and its number on a keyboard.
    pub(crate) fn press(&mut self, key: &str, number: u8) {
        for kind in ["rawKeyDown", "keyUp"] {
            let event = json!({ "type": kind, "key": key, "code": key, "windowsVirtualKeyCode": number });
            self.command("Input.dispatchKeyEvent", event);
        }
    }

    /// What has happened since the last call, as the protocol tells it.
    pub(crate) fn events(&mut self) -> Vec<Value> {
        self.events.drain(..).collect()
    }
}

/// What stands in a text of base 64.
fn bytes(text: &str) -> Vec<u8> {
    const SIGNS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let (mut out, mut bits, mut count) = (Vec::new(), 0_u32, 0);
    for value in text.bytes().filter_map(|sign| SIGNS.iter().position(|of| *of == sign)) {
        bits = bits << 6 | value as u32;
        count += 6;
        if count >= 8 {
            count -= 8;
            out.push((bits >> count & 0xff) as u8);
        }
    }
    out
}

impl Browser {
    /// Closes the tab, and has the process forget what its pages kept.
    fn leave(&mut self) -> Option<Process> {
        // No page is left that could keep something again.
        self.ask("Page.navigate", json!({ "url": "about:blank" })).ok()?;
        for origin in std::mem::take(&mut self.origins) {
            let all = json!({ "origin": origin, "storageTypes": "all" });
            self.ask("Storage.clearDataForOrigin", all).ok()?;
        }
        self.session = None;
        self.ask("Target.closeTarget", json!({ "targetId": self.tab })).ok()?;
        self.process.take()
    }

    /// What the next test gets that has this process.
    pub(crate) fn again(mut self) -> Option<Self> {
        self.leave().and_then(|process| Self::of(process).ok())
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // After a failed test nobody knows what the process is about.
        let left = if self.process.is_none() || std::thread::panicking() { None } else { self.leave() };
        if let (Some(process), Ok(mut idle)) = (left, IDLE.lock()) {
            idle.push(process);
        }
    }
}

impl Process {
    fn start(program: &Path, letters: Letters) -> Result<Self, String> {
        let hinting = match letters {
            Letters::Exact => "none",
            Letters::OnPixels => "full",
        };
        let profile = TempDir::new().map_err(|error| error.to_string())?.keep();
        // The browser reads commands from its file 3 and answers on its file 4. The shell clears up after it, also when the
        // test program has ended.
        let mut shell = Command::new("sh")
            .args(["-c", r#"profile="$0"; "$@" 3<&0 4>&1 </dev/null >/dev/null 2>&1; rm -rf "$profile""#])
            .arg(&profile)
            .arg(program)
            // No sandbox: it does not start for root or in a container, and only pages of our own are shown.
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--hide-scrollbars"])
            .args(["--no-first-run", "--mute-audio", "--disable-background-networking", "--disable-component-update"])
            // A page that asks for something elsewhere is found out, and gets nothing; this machine serves pages in a test.
            .args([
                "--disable-extensions",
                "--disable-sync",
                "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
            ])
            .arg("--allow-file-access-from-files")
            .arg(format!("--font-render-hinting={hinting}"))
            // Nobody waits for a page: helpers that collect garbage beside its scripts only take processors from others.
            .arg("--js-flags=--single-threaded")
            .arg(format!("--user-data-dir={}", profile.display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| error.to_string())?;
        let (Some(commands), Some(answers)) = (shell.stdin.take(), shell.stdout.take()) else {
            return Err("it has no pipe".to_owned());
        };
        let (sender, messages) = channel();
        std::thread::spawn(move || {
            for message in BufReader::new(answers).split(0).map_while(Result::ok) {
                let told = serde_json::from_slice(&message).map(|message| sender.send(message));
                if !matches!(told, Ok(Ok(()))) {
                    break;
                }
            }
        });
        Ok(Self { letters, shell, commands: Some(commands), messages, calls: 0 })
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // It ends with its pipe, and the shell with it.
        drop(self.commands.take());
        let _ = self.shell.wait();
    }
}
