//! What an editor and the server have told each other. Nothing here waits, reads or writes.

use super::buffers::{Change, OpenDocument, changed_text};
use super::checking::{CheckJob, CheckOutcome};
use super::debounce::Debouncer;
use super::findings::{EditedDocument, EditorFeatures, diagnostics, fixes, hover};
use super::framing::Incoming;
use super::languages::{file_of, format_of};
use super::positions::{Position, byte_at, range_from_json};
use super::settings::Settings;
use geneva_host::printable::escape_and_shorten;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How long a text must stay as it is before it is checked.
pub(super) const PAUSE: Duration = Duration::from_millis(300);

/// The error codes of the protocol.
#[derive(Clone, Copy)]
enum ErrorCode {
    Parse = -32700,
    InvalidRequest = -32600,
    MethodNotFound = -32601,
    InvalidParams = -32602,
    NotInitialized = -32002,
}

/// How much of its life a session has behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Stage {
    /// The editor has said nothing about itself yet.
    #[default]
    New,
    Running,
    /// The editor has asked for the end.
    ShutDown,
    /// The process is to end, well if the end was asked for before.
    Ended {
        well: bool,
    },
}

/// A session with an editor.
#[derive(Default)]
pub(super) struct Session {
    stage: Stage,
    features: EditorFeatures,
    /// The settings with which it began.
    first_settings: Settings,
    settings: Settings,
    folders: Vec<PathBuf>,
    documents: BTreeMap<String, OpenDocument>,
    waiting: Debouncer<String, Instant>,
    /// The last number that was given to a state of a document.
    revision: u64,
    /// Whether a document is being checked.
    is_checking: bool,
    /// What was said to be wrong with the file of accepted cases.
    baseline_error: Option<String>,
    /// Languages that were said to be unknown.
    unknown: BTreeSet<String>,
    outgoing: Vec<Value>,
}

/// A request that cannot be answered.
struct Refusal(ErrorCode, String);

fn wrong_parameters(method: &str, wanted: &str) -> Refusal {
    Refusal(ErrorCode::InvalidParams, format!("the parameters of `{method}` need {wanted}"))
}

impl Session {
    /// The messages for the editor, which are taken out.
    pub(super) fn take_outgoing(&mut self) -> Vec<Value> {
        std::mem::take(&mut self.outgoing)
    }

    /// Whether the process is to end, and whether the editor has asked for it as it should.
    pub(super) fn ended(&self) -> Option<bool> {
        match self.stage {
            Stage::Ended { well } => Some(well),
            Stage::New | Stage::Running | Stage::ShutDown => None,
        }
    }

    /// Ends the session, since the editor is gone.
    pub(super) fn end(&mut self) {
        self.stage = Stage::Ended { well: self.stage == Stage::ShutDown };
    }

    /// When something is to be checked; none if nothing is, or if it has to wait for another check.
    pub(super) fn next_due(&self) -> Option<Instant> {
        self.waiting.next_due().filter(|_| !self.is_checking)
    }

    /// The check that is due now, one at a time.
    pub(super) fn next_job(&mut self, now: Instant) -> Option<CheckJob> {
        if self.is_checking || self.stage != Stage::Running {
            return None;
        }
        let address = self.waiting.take_due(now)?;
        let document = self.documents.get(&address)?;
        let file = document.file.clone();
        let top = self.folders.first().cloned();
        let is_above = |folder: &&PathBuf| file.as_deref().is_some_and(|file| file.starts_with(folder));
        let job = CheckJob {
            address,
            revision: document.revision,
            text: document.text.clone(),
            format: document.format,
            folder: self.folders.iter().find(is_above).cloned(),
            file,
            open: self.documents.values().filter_map(OpenDocument::project_file).collect(),
            top,
            settings: self.settings.clone(),
        };
        self.is_checking = true;
        Some(job)
    }

    /// Takes what a check found. If the text has changed since, nobody wants to know.
    pub(super) fn take_outcome(&mut self, outcome: CheckOutcome, now: Instant) {
        self.is_checking = false;
        if outcome.definitions_changed {
            self.check_project_files(Some(&outcome.address), now);
        }
        if outcome.baseline_error != self.baseline_error {
            if let Some(why) = &outcome.baseline_error {
                self.show(why);
            }
            self.baseline_error = outcome.baseline_error;
        }
        let features = self.features;
        let Some(document) = self.documents.get_mut(&outcome.address) else { return };
        if document.revision != outcome.revision {
            return;
        }
        let marks = match outcome.checked {
            Ok(checked) => {
                let marks = diagnostics(&checked, &outcome.address, features);
                document.checked = Some(checked);
                marks
            }
            Err(why) => {
                document.checked = None;
                let name = escape_and_shorten(&outcome.address);
                self.outgoing.push(log(MessageKind::Info, &format!("{name} is not checked: {why}")));
                Vec::new()
            }
        };
        self.outgoing.push(published(&outcome.address, &document.version, marks));
    }

    /// Takes what came from the editor.
    pub(super) fn take(&mut self, incoming: Incoming, now: Instant) {
        let message = match incoming {
            Incoming::Message(message) => message,
            Incoming::Malformed(why) => {
                self.outgoing.push(refused(&Value::Null, &Refusal(ErrorCode::Parse, why)));
                return;
            }
        };
        let id = message.get("id").filter(|id| id.is_string() || id.is_number() || id.is_null());
        let params = &message["params"];
        match (message["method"].as_str(), id) {
            (Some(method), Some(id)) => {
                let before = self.outgoing.len();
                let answer = match self.request(method, params) {
                    Ok(result) => json!({ "jsonrpc": "2.0", "id": id, "result": result }),
                    Err(refusal) => refused(id, &refusal),
                };
                // Until it is answered, an editor that starts expects nothing else.
                self.outgoing.insert(before, answer);
            }
            (Some("exit"), None) => self.end(),
            (Some(method), None) if self.stage == Stage::Running && message.get("id").is_none() => {
                if let Err(Refusal(_, why)) = self.notification(method, params, now) {
                    self.outgoing.push(log(MessageKind::Error, &why));
                }
            }
            // What comes too early or too late is to be left out.
            (Some(_), None) if message.get("id").is_none() => {}
            // An answer: nothing is asked of the editor.
            (None, Some(_)) if message.get("result").is_some() || message.get("error").is_some() => {}
            _ => {
                let why = "a message is an object with `method`, a string, and in a request `id`, a number or a string";
                self.outgoing.push(refused(&Value::Null, &Refusal(ErrorCode::InvalidRequest, why.to_owned())));
            }
        }
    }

    fn request(&mut self, method: &str, params: &Value) -> Result<Value, Refusal> {
        match (self.stage, method) {
            (Stage::New, "initialize") => Ok(self.initialize(params)),
            (Stage::New, _) => {
                Err(Refusal(ErrorCode::NotInitialized, "the first request has to be `initialize`".to_owned()))
            }
            (Stage::Running, "initialize") => {
                Err(Refusal(ErrorCode::InvalidRequest, "`initialize` was requested before; once is enough".to_owned()))
            }
            (Stage::Running, "shutdown") => {
                self.stage = Stage::ShutDown;
                Ok(Value::Null)
            }
            (Stage::Running, "textDocument/hover") => self.hover(params),
            (Stage::Running, "textDocument/codeAction") => self.code_actions(params),
            (Stage::Running, _) => {
                let method = escape_and_shorten(method);
                Err(Refusal(ErrorCode::MethodNotFound, format!("`{method}` is not known here")))
            }
            (Stage::ShutDown | Stage::Ended { .. }, _) => Err(Refusal(
                ErrorCode::InvalidRequest,
                "`shutdown` was requested before; only `exit` may follow".to_owned(),
            )),
        }
    }

    fn initialize(&mut self, params: &Value) -> Value {
        self.stage = Stage::Running;
        self.features = EditorFeatures::from_capabilities(&params["capabilities"]);
        let folders = params["workspaceFolders"].as_array().into_iter().flatten().map(|of| &of["uri"]);
        self.folders = folders.chain([&params["rootUri"]]).filter_map(|of| file_of(of.as_str()?)).collect();
        self.settings = self.changed_settings(&Settings::default(), &params["initializationOptions"]);
        self.first_settings = self.settings.clone();
        json!({
            "capabilities": {
                "positionEncoding": self.features.encoding.name(),
                // Opened and closed, every change by its range, and saved without the text.
                "textDocumentSync": { "openClose": true, "change": 2, "save": { "includeText": false } },
                "hoverProvider": true,
                "codeActionProvider": { "codeActionKinds": ["quickfix"] },
            },
            "serverInfo": { "name": "proofread", "version": env!("CARGO_PKG_VERSION") },
        })
    }

    /// Settings with the options that are given; the editor shows what is wrong with these.
    fn changed_settings(&mut self, from: &Settings, given: &Value) -> Settings {
        let (settings, wrong) = from.changed_by(given);
        wrong.iter().for_each(|why| self.show(why));
        settings
    }

    /// Has the editor show what is wrong.
    fn show(&mut self, why: &str) {
        let params = json!({ "type": MessageKind::Warning as u8, "message": format!("proofread: {why}") });
        self.outgoing.push(notification("window/showMessage", &params));
    }

    fn notification(&mut self, method: &str, params: &Value, now: Instant) -> Result<(), Refusal> {
        match method {
            "textDocument/didOpen" => self.open(params, now),
            "textDocument/didChange" => self.change(params, now),
            "textDocument/didSave" => self.save(params, now),
            "textDocument/didClose" => self.close(params, now),
            "workspace/didChangeConfiguration" => {
                let settings = self.changed_settings(&self.first_settings.clone(), &params["settings"]);
                if settings != self.settings {
                    self.settings = settings;
                    let addresses: Vec<String> = self.documents.keys().cloned().collect();
                    addresses.iter().for_each(|address| self.check_anew(address, now));
                }
                Ok(())
            }
            // Whatever else an editor tells is for other servers.
            _ => Ok(()),
        }
    }

    fn new_revision(&mut self) -> u64 {
        self.revision += 1;
        self.revision
    }

    fn open(&mut self, params: &Value, now: Instant) -> Result<(), Refusal> {
        let of = &params["textDocument"];
        let (Some(address), Some(text)) = (of["uri"].as_str(), of["text"].as_str()) else {
            return Err(wrong_parameters("textDocument/didOpen", "`textDocument` with `uri` and `text`"));
        };
        let language = of["languageId"].as_str().unwrap_or_default();
        let Some(format) = format_of(language, address) else {
            if self.unknown.insert(language.to_owned()) {
                let (language, name) = (escape_and_shorten(language), escape_and_shorten(address));
                let why = format!(
                    "{name} is not checked, since neither its language `{language}` nor its ending tells a format; \
                     languages such as latex, markdown, html, xml and plaintext do"
                );
                self.outgoing.push(log(MessageKind::Info, &why));
            }
            return Ok(());
        };
        let document = OpenDocument {
            text: Arc::from(text),
            version: of["version"].clone(),
            revision: self.new_revision(),
            format,
            file: file_of(address),
            checked: None,
        };
        self.documents.insert(address.to_owned(), document);
        self.waiting.schedule(address.to_owned(), now);
        Ok(())
    }

    fn change(&mut self, params: &Value, now: Instant) -> Result<(), Refusal> {
        let of = &params["textDocument"];
        let (Some(address), Some(changes)) = (of["uri"].as_str(), params["contentChanges"].as_array()) else {
            return Err(wrong_parameters("textDocument/didChange", "`textDocument` with `uri`, and `contentChanges`"));
        };
        let (revision, encoding) = (self.new_revision(), self.features.encoding);
        let Some(document) = self.documents.get_mut(address) else { return Ok(()) };
        let changes: Option<Vec<Change<'_>>> = changes.iter().map(Change::from_json).collect();
        let Some(changes) = changes else {
            // What the editor shows is not known any more.
            self.forget(address);
            let name = escape_and_shorten(address);
            return Err(wrong_parameters(
                "textDocument/didChange",
                &format!(
                    "`text` in each change, and a whole `range` if there is one; open {name} again to have it checked"
                ),
            ));
        };
        document.text = Arc::from(changed_text(&document.text, &changes, encoding));
        (document.version, document.revision) = (of["version"].clone(), revision);
        self.waiting.schedule(address.to_owned(), now + PAUSE);
        Ok(())
    }

    /// Checks a document that was saved, and those that may have definitions from its file.
    fn save(&mut self, params: &Value, now: Instant) -> Result<(), Refusal> {
        let Some(address) = params["textDocument"]["uri"].as_str() else {
            return Err(wrong_parameters("textDocument/didSave", "`textDocument` with `uri`"));
        };
        self.check_anew(address, now);
        self.check_project_files(Some(address), now);
        Ok(())
    }

    fn close(&mut self, params: &Value, now: Instant) -> Result<(), Refusal> {
        let Some(address) = params["textDocument"]["uri"].as_str() else {
            return Err(wrong_parameters("textDocument/didClose", "`textDocument` with `uri`"));
        };
        self.forget(address);
        self.check_project_files(None, now);
        Ok(())
    }

    /// Takes a document and its marks away.
    fn forget(&mut self, address: &str) {
        self.waiting.cancel(&address.to_owned());
        if self.documents.remove(address).is_some() {
            self.outgoing.push(published(address, &Value::Null, Vec::new()));
        }
    }

    fn check_anew(&mut self, address: &str, now: Instant) {
        let revision = self.new_revision();
        if let Some(document) = self.documents.get_mut(address) {
            document.revision = revision;
            self.waiting.schedule(address.to_owned(), now);
        }
    }

    /// Checks the documents that may have definitions from other files, but one. Those that wait after a change wait on.
    fn check_project_files(&mut self, but: Option<&str>, now: Instant) {
        let mut revision = self.revision;
        for (address, document) in &mut self.documents {
            if document.project_file().is_some() && Some(address.as_str()) != but {
                revision += 1;
                document.revision = revision;
                self.waiting.schedule_also(address.clone(), now);
            }
        }
        self.revision = revision;
    }

    /// A document whose findings belong to its text as it is now.
    fn checked_document(&self, params: &Value, method: &str) -> Result<Option<(&str, &OpenDocument)>, Refusal> {
        let Some(address) = params["textDocument"]["uri"].as_str() else {
            return Err(wrong_parameters(method, "`textDocument` with `uri`"));
        };
        let known = self.documents.get_key_value(address).map(|(address, document)| (address.as_str(), document));
        Ok(known.filter(|(_, of)| of.checked.as_ref().is_some_and(|checked| Arc::ptr_eq(&checked.text, &of.text))))
    }

    fn hover(&self, params: &Value) -> Result<Value, Refusal> {
        const METHOD: &str = "textDocument/hover";
        let position = Position::from_json(&params["position"])
            .ok_or_else(|| wrong_parameters(METHOD, "`position` with `line` and `character`"))?;
        let document = self.checked_document(params, METHOD)?;
        let Some(checked) = document.and_then(|(_, of)| of.checked.as_ref()) else { return Ok(Value::Null) };
        Ok(hover(checked, byte_at(&checked.text, position, self.features.encoding), self.features))
    }

    fn code_actions(&self, params: &Value) -> Result<Value, Refusal> {
        const METHOD: &str = "textDocument/codeAction";
        let range = range_from_json(&params["range"])
            .ok_or_else(|| wrong_parameters(METHOD, "`range` with `start` and `end`"))?;
        let document = self.checked_document(params, METHOD)?;
        let Some((address, document)) = document else { return Ok(json!([])) };
        let Some(checked) = &document.checked else { return Ok(json!([])) };
        // An editor may want other kinds of actions alone.
        let is_wanted = match params["context"]["only"].as_array() {
            Some(kinds) => kinds.iter().any(|kind| kind == "quickfix" || kind == ""),
            None => true,
        };
        if !is_wanted {
            return Ok(json!([]));
        }
        let [start, end] = range.map(|at| byte_at(&checked.text, at, self.features.encoding));
        let edited = EditedDocument { address, version: &document.version, format: document.format };
        Ok(fixes(checked, &(start.min(end)..start.max(end)), &edited, self.features).into())
    }
}

/// How an editor is to show a message.
#[derive(Clone, Copy)]
enum MessageKind {
    Error = 1,
    Warning = 2,
    Info = 3,
}

fn notification(method: &str, params: &Value) -> Value {
    json!({ "jsonrpc": "2.0", "method": method, "params": params })
}

/// A message for the editor's log.
fn log(kind: MessageKind, message: &str) -> Value {
    notification("window/logMessage", &json!({ "type": kind as u8, "message": message }))
}

/// The marks of a document, with its version if it has one.
fn published(address: &str, version: &Value, marks: Vec<Value>) -> Value {
    let mut params = json!({ "uri": address, "diagnostics": marks });
    if version.is_number() {
        params["version"] = version.clone();
    }
    notification("textDocument/publishDiagnostics", &params)
}

fn refused(id: &Value, Refusal(code, why): &Refusal) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": *code as i32, "message": why } })
}

#[cfg(test)]
mod tests;
