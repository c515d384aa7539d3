//! Whole sessions, by a made-up time.

use super::super::checking::{CheckedText, Checker};
use super::*;

struct Trial {
    session: Session,
    start: Instant,
}

impl Trial {
    fn new() -> Self {
        let mut trial = Self { session: Session::default(), start: Instant::now() };
        trial.tell(0, "initialize", &json!({}));
        trial.session.take_outgoing();
        trial
    }

    fn at(&self, ms: u64) -> Instant {
        self.start + Duration::from_millis(ms)
    }

    fn tell(&mut self, ms: u64, method: &str, params: &Value) {
        let mut message = json!({ "method": method, "params": params });
        if method == "initialize" {
            message["id"] = json!(1);
        }
        self.session.take(Incoming::Message(message), self.at(ms));
    }

    fn open(&mut self, ms: u64, uri: &str, text: &str) {
        let of = json!({ "uri": uri, "languageId": "markdown", "version": 1, "text": text });
        self.tell(ms, "textDocument/didOpen", &json!({ "textDocument": of }));
    }

    fn change(&mut self, ms: u64, uri: &str, version: u64, text: &str) {
        let of = json!({ "uri": uri, "version": version });
        let params = json!({ "textDocument": of, "contentChanges": [{ "text": text }] });
        self.tell(ms, "textDocument/didChange", &params);
    }

    /// The text of the check that begins at a time.
    fn begun(&mut self, ms: u64) -> Option<CheckJob> {
        self.session.next_job(self.at(ms))
    }

    /// The versions of the marks and how many there are, after a check has ended.
    fn published(&mut self, ms: u64, job: &CheckJob) -> Vec<(Value, usize)> {
        let outcome = Checker::default().check(job);
        self.session.take_outcome(outcome, self.at(ms));
        let marks = |message: Value| {
            let params = &message["params"];
            Some((params["version"].clone(), params["diagnostics"].as_array()?.len()))
        };
        self.session.take_outgoing().into_iter().filter_map(marks).collect()
    }
}

#[test]
fn a_text_is_checked_after_a_pause_that_each_change_begins_anew() {
    let mut trial = Trial::new();
    trial.open(0, "a", "$2 + 2 = 5$");
    let job = trial.begun(0).expect("at once");
    assert_eq!(trial.published(1, &job), [(json!(1), 1)]);
    trial.change(1000, "a", 2, "$2 + 2 = 6$");
    trial.change(1200, "a", 3, "$2 + 2 = 4$");
    assert_eq!(trial.session.next_due(), Some(trial.at(1500)));
    assert!(trial.begun(1499).is_none());
    let job = trial.begun(1500).expect("it is due");
    assert_eq!(&*job.text, "$2 + 2 = 4$");
    assert_eq!(trial.published(1501, &job), [(json!(3), 0)]);
    assert!(trial.session.next_due().is_none() && trial.begun(9000).is_none());
}

#[test]
fn what_was_found_in_an_earlier_text_is_dropped() {
    let mut trial = Trial::new();
    trial.open(0, "a", "$2 + 2 = 5$");
    let early = trial.begun(0).expect("at once");
    trial.change(10, "a", 2, "$2 + 2 = 6$");
    assert_eq!(trial.published(20, &early), []);
    // Opened again, it has the same version and is not the same.
    let job = trial.begun(310).expect("it is due");
    trial.tell(320, "textDocument/didClose", &json!({ "textDocument": { "uri": "a" } }));
    trial.session.take_outgoing();
    trial.open(330, "a", "$1 + 1 = 2$");
    assert_eq!(trial.published(340, &job), []);
    let job = trial.begun(350).expect("at once");
    assert_eq!(trial.published(360, &job), [(json!(1), 0)]);
}

#[test]
fn one_check_waits_for_another_and_takes_the_text_as_it_is_then() {
    let mut trial = Trial::new();
    trial.open(0, "a", "$2 + 2 = 5$");
    let first = trial.begun(0).expect("at once");
    trial.open(1, "b", "$2 + 2 = 6$");
    assert!(trial.session.next_due().is_none() && trial.begun(500).is_none());
    trial.change(600, "b", 2, "$2 + 2 = 4$");
    assert_eq!(trial.published(700, &first), [(json!(1), 1)]);
    assert!(trial.begun(899).is_none());
    let second = trial.begun(900).expect("it is due");
    assert_eq!((second.address.as_str(), &*second.text), ("b", "$2 + 2 = 4$"));
}

#[test]
fn a_text_that_is_closed_is_not_checked_and_loses_its_marks() {
    let mut trial = Trial::new();
    trial.open(0, "a", "$2 + 2 = 5$");
    trial.tell(1, "textDocument/didClose", &json!({ "textDocument": { "uri": "a" } }));
    assert!(trial.begun(500).is_none());
    let gone = notification("textDocument/publishDiagnostics", &json!({ "uri": "a", "diagnostics": [] }));
    assert_eq!(trial.session.take_outgoing(), [gone]);
}

#[test]
fn a_text_that_cannot_be_read_is_told_in_the_log() {
    let mut trial = Trial::new();
    trial.open(0, "a", "");
    let job = trial.begun(0).expect("at once");
    let outcome = CheckOutcome {
        address: job.address,
        revision: job.revision,
        checked: Err::<CheckedText, _>("it is no notebook".to_owned()),
        definitions_changed: false,
        baseline_error: None,
    };
    trial.session.take_outcome(outcome, trial.at(1));
    let [told, marks] = trial.session.take_outgoing().try_into().expect("two messages");
    assert_eq!(told["params"]["message"], "a is not checked: it is no notebook");
    assert_eq!(marks["params"]["diagnostics"], json!([]));
}

/// Something that may stand in a message, right or wrong.
fn random_value(dice: &mut fastrand::Rng, depth: usize) -> Value {
    const KEYS: [&str; 12] = [
        "textDocument",
        "uri",
        "text",
        "version",
        "languageId",
        "contentChanges",
        "range",
        "start",
        "end",
        "position",
        "line",
        "character",
    ];
    match dice.usize(..if depth == 0 { 7 } else { 10 }) {
        0 => Value::Null,
        1 => json!(dice.i64(-2..9)),
        2 => json!(dice.f64() * 1e30),
        3 => json!(u64::MAX),
        4 => json!("a"),
        5 => json!("β $2 + 2 = 5$\r\n𝟙\r$\\tan 31.0^\\circ = 0.609$"),
        6 => json!(true),
        7 => (0..dice.usize(..3)).map(|_| random_value(dice, depth - 1)).collect(),
        _ => {
            let mut key = || KEYS[dice.usize(..KEYS.len())].to_owned();
            let keys: Vec<String> = (0..4).map(|_| key()).collect();
            keys.into_iter().map(|key| (key, random_value(dice, depth - 1))).collect()
        }
    }
}

#[test]
fn no_message_is_too_strange() {
    const METHODS: [&str; 8] = [
        "textDocument/didOpen",
        "textDocument/didChange",
        "textDocument/didSave",
        "textDocument/didClose",
        "textDocument/hover",
        "textDocument/codeAction",
        "workspace/didChangeConfiguration",
        "initialize",
    ];
    let mut dice = fastrand::Rng::with_seed(7);
    let mut trial = Trial::new();
    let mut answered = 0;
    for turn in 0..4_000_u64 {
        if turn % 16 == 0 {
            trial.open(turn, "a", "β $2 + 2 = 5$\r\n𝟙 $\\tan 31.0^\\circ = 0.609$");
        }
        if let Some(job) = trial.begun(turn) {
            trial.published(turn, &job);
        }
        let mut place = || json!({ "line": dice.u64(..4), "character": dice.u64(..40) });
        let range = json!({ "start": place(), "end": place() });
        let mut params = json!({
            "textDocument": { "uri": "a", "version": turn },
            "position": place(),
            "range": range,
            "contentChanges": [{ "range": range, "text": "7" }, { "range": range, "text": "" }],
        });
        if dice.bool() {
            let keys = ["textDocument", "position", "range", "contentChanges", "context", "settings"];
            params[keys[dice.usize(..keys.len())]] = random_value(&mut dice, 3);
        }
        let mut message = json!({ "method": METHODS[dice.usize(..METHODS.len())], "params": params });
        if dice.bool() {
            message["id"] = json!(turn);
        }
        if dice.usize(..9) == 0 {
            message = random_value(&mut dice, 2);
        }
        trial.session.take(Incoming::Message(message), trial.at(turn));
        answered += trial.session.take_outgoing().iter().filter(|of| of["result"].is_object()).count();
    }
    // Some of the texts were whole enough to be explained.
    assert!(answered > 4, "{answered}");
    assert_eq!(trial.session.ended(), None);
}

#[test]
fn accepted_cases_are_left_out_and_a_file_that_cannot_be_read_is_told_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let top = folder.path().canonicalize().expect("a folder");
    let [address, root] = ["/src/a.md", ""].map(|name| format!("file://{}{name}", top.display()));
    std::fs::create_dir(top.join("src")).expect("made");
    let case = json!({ "file": "src/a.md", "case": "inconsistent: 2+2 | 5", "why": "" });
    std::fs::write(top.join("cases.jsonl"), format!("{case}\n")).expect("written");
    let marks = |baseline: &str| {
        let mut trial = Trial { session: Session::default(), start: Instant::now() };
        let options = json!({ "rootUri": root, "initializationOptions": { "baseline": baseline } });
        trial.tell(0, "initialize", &options);
        trial.open(0, &address, "$2 + 2 = 5$ and $2 + 2 = 6$");
        let mut found = Vec::new();
        for ms in [0, 1000] {
            let job = trial.begun(ms).expect("it is due");
            trial.session.take_outcome(Checker::default().check(&job), trial.at(ms));
            found.extend(trial.session.take_outgoing());
            trial.change(ms + 500, &address, 2, "$2 + 2 = 5$ and $2 + 2 = 6$");
        }
        let shown = found.iter().filter(|message| message["method"] == "window/showMessage").count();
        let counts = found.iter().filter_map(|message| Some(message["params"]["diagnostics"].as_array()?.len()));
        (counts.collect::<Vec<_>>(), shown)
    };
    assert_eq!(marks("cases.jsonl"), (vec![1, 1], 0));
    assert_eq!(marks("none.jsonl"), (vec![2, 2], 1));
}
