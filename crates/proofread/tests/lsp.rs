//! The server for editors, as an editor meets it: the program at the other end of two pipes.

use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

/// After which time a message that does not come has failed a test. Nothing else depends on it.
const PATIENCE: Duration = Duration::from_secs(600);

/// An editor.
struct Editor {
    server: Child,
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    last_id: u64,
    /// What columns count, as the server says.
    encoding: String,
}

fn read(stream: &mut impl BufRead) -> Option<Value> {
    let mut length = None;
    loop {
        let mut line = String::new();
        stream.read_line(&mut line).ok().filter(|bytes| *bytes > 0)?;
        match line.trim_end().split_once(": ") {
            Some(("Content-Length", value)) => length = value.parse().ok(),
            _ => break,
        }
    }
    let mut body = vec![0; length.expect("a length")];
    stream.read_exact(&mut body).ok()?;
    Some(serde_json::from_slice(&body).expect("JSON"))
}

impl Editor {
    fn start() -> Self {
        let mut server = Command::new(env!("CARGO_BIN_EXE_proofread"))
            .args(["lsp", "--stdio"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut output = BufReader::new(server.stdout.take().expect("a pipe"));
        let (sender, messages) = channel();
        std::thread::spawn(move || {
            while let Some(message) = read(&mut output) {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        let input = server.stdin.take();
        Self { server, input, messages, last_id: 0, encoding: String::new() }
    }

    /// An editor that has introduced itself, with these options and abilities besides the usual ones.
    fn introduced(options: &Value, general: &Value) -> Self {
        let mut editor = Self::start();
        let text = json!({
            "publishDiagnostics": { "relatedInformation": true },
            "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": ["quickfix"] } } },
        });
        let workspace = json!({ "workspaceEdit": { "documentChanges": true } });
        let capabilities = json!({ "general": general, "textDocument": text, "workspace": workspace });
        let params = json!({ "processId": null, "rootUri": null, "capabilities": capabilities, "initializationOptions": options });
        let answer = editor.request("initialize", &params);
        let offered = &answer["result"]["capabilities"];
        let sync = json!({ "openClose": true, "change": 2, "save": { "includeText": false } });
        assert_eq!((&offered["textDocumentSync"], &offered["hoverProvider"]), (&sync, &json!(true)));
        assert_eq!(offered["codeActionProvider"], json!({ "codeActionKinds": ["quickfix"] }));
        assert_eq!(answer["result"]["serverInfo"]["name"], "proofread");
        editor.encoding = offered["positionEncoding"].as_str().expect("a name").to_owned();
        editor.notify("initialized", &json!({}));
        editor
    }

    fn write(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("open");
        input.write_all(bytes).and_then(|()| input.flush()).expect("the program reads");
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.write(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    fn notify(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// The next message that fits.
    fn next(&mut self, fits: impl Fn(&Value) -> bool) -> Value {
        loop {
            let message = self.messages.recv_timeout(PATIENCE).expect("a message");
            if fits(&message) {
                return message;
            }
        }
    }

    fn request(&mut self, method: &str, params: &Value) -> Value {
        self.last_id += 1;
        let id = self.last_id;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        self.next(|message| message["id"] == id)
    }

    fn open(&mut self, uri: &str, language: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": language, "version": 1, "text": text });
        self.notify("textDocument/didOpen", &json!({ "textDocument": document }));
    }

    fn change(&mut self, uri: &str, version: u64, changes: &Value) {
        let document = json!({ "uri": uri, "version": version });
        self.notify("textDocument/didChange", &json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// The marks that are shown for a version of a document.
    fn marks(&mut self, uri: &str, version: u64) -> Vec<Value> {
        let of = |message: &Value| {
            let params = &message["params"];
            message["method"] == "textDocument/publishDiagnostics"
                && params["uri"] == uri
                && params["version"] == version
        };
        self.next(of)["params"]["diagnostics"].as_array().expect("a list").clone()
    }

    fn fixes(&mut self, uri: &str, range: &Value) -> Vec<Value> {
        let params = json!({ "textDocument": { "uri": uri }, "range": range, "context": { "diagnostics": [] } });
        self.request("textDocument/codeAction", &params)["result"].as_array().expect("a list").clone()
    }

    fn hover(&mut self, uri: &str, line: u64, character: u64) -> Value {
        let position = json!({ "line": line, "character": character });
        let params = json!({ "textDocument": { "uri": uri }, "position": position });
        self.request("textDocument/hover", &params)["result"].clone()
    }

    /// The exit code after the end of what the editor says.
    fn code(mut self) -> Option<i32> {
        self.input = None;
        self.server.wait().expect("it ends").code()
    }

    /// Ends as the protocol wants it.
    fn finish(mut self) {
        assert_eq!(self.request("shutdown", &Value::Null)["result"], Value::Null);
        self.notify("exit", &Value::Null);
        assert_eq!(self.code(), Some(0));
    }
}

impl Drop for Editor {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

fn range(line: u64, from: u64, to: u64) -> Value {
    json!({ "start": { "line": line, "character": from }, "end": { "line": line, "character": to } })
}

const NOTES: &str = "untitled:notes";

#[test]
fn a_finding_is_marked_explained_and_mended() {
    let mut editor = Editor::introduced(&Value::Null, &Value::Null);
    editor.open(NOTES, "markdown", "It is $1 + 1 = 2$.\n");
    assert_eq!(editor.marks(NOTES, 1), [] as [Value; 0]);
    let change = json!([{ "range": range(1, 0, 0), "text": "It is $\\tan 31.0^\\circ = 0.609$." }]);
    editor.change(NOTES, 2, &change);
    let marks = editor.marks(NOTES, 2);
    let message = "the two sides differ: printed 0.609, recomputed 0.601\ntan 31.0° against 0.609";
    let other =
        json!([{ "location": { "uri": NOTES, "range": range(1, 7, 22) }, "message": "the other side: tan 31.0°" }]);
    let mark = json!({
        "range": range(1, 25, 30),
        "severity": 2,
        "code": "inconsistent",
        "source": "proofread",
        "message": message,
        "relatedInformation": other,
    });
    assert_eq!(marks, std::slice::from_ref(&mark));

    let hover = editor.hover(NOTES, 1, 27);
    assert_eq!((&hover["range"], &hover["contents"]["kind"]), (&range(1, 25, 30), &json!("plaintext")));
    let told = hover["contents"]["value"].as_str().expect("text");
    for line in
        ["printed 0.609, recomputed 0.601", "read as: tan 31.0° = 0.609", "hint: `0.601` for `0.609` would agree"]
    {
        assert!(told.lines().any(|of| of == line), "{line}\nis not in\n{told}");
    }
    assert_eq!(editor.hover(NOTES, 0, 9), Value::Null);

    assert_eq!(editor.fixes(NOTES, &range(0, 0, 5)), [] as [Value; 0]);
    let fixes = editor.fixes(NOTES, &range(1, 27, 27));
    let edits = json!([{ "range": range(1, 25, 30), "newText": "0.601" }]);
    let fix = json!({
        "title": "Write `0.601` for `0.609`",
        "kind": "quickfix",
        "diagnostics": [mark],
        "isPreferred": true,
        "edit": { "documentChanges": [{ "textDocument": { "uri": NOTES, "version": 2 }, "edits": edits }] },
    });
    assert_eq!(fixes, [fix]);
    editor.change(NOTES, 3, &json!([{ "range": range(1, 25, 30), "text": "0.601" }]));
    // Before its check, a text has no findings of an earlier one.
    assert_eq!(editor.fixes(NOTES, &range(1, 27, 27)), [] as [Value; 0]);
    assert_eq!(editor.marks(NOTES, 3), [] as [Value; 0]);
    editor.finish();
}

#[test]
fn columns_are_counted_as_the_editor_wants_it() {
    let text = "𝟙𝟚 β $2 + 2 = 5$";
    for (offered, chosen, from) in [
        (json!({}), "utf-16", 16),
        (json!({ "positionEncodings": ["utf-16"] }), "utf-16", 16),
        (json!({ "positionEncodings": ["utf-8", "utf-16"] }), "utf-8", 21),
    ] {
        let mut editor = Editor::introduced(&Value::Null, &offered);
        assert_eq!(editor.encoding, chosen);
        editor.open(NOTES, "markdown", text);
        assert_eq!(editor.marks(NOTES, 1)[0]["range"], range(0, from, from + 1), "{chosen}");
        // The same columns in a change: the five becomes a four.
        editor.change(NOTES, 2, &json!([{ "range": range(0, from, from + 1), "text": "4" }]));
        assert_eq!(editor.marks(NOTES, 2), [] as [Value; 0], "{chosen}");
        editor.finish();
    }
}

#[test]
fn options_say_what_is_listed() {
    let text = "$2/3 = 0.66$ and $1.5\\ \\mathrm{m} + 1.5\\ \\mathrm{m} = 3.0\\ \\mathrm{s}$";
    let codes = |marks: &[Value]| -> Vec<(String, u64)> {
        let code = |mark: &Value| Some((mark["code"].as_str()?.to_owned(), mark["severity"].as_u64()?));
        marks.iter().filter_map(code).collect()
    };
    let mut editor = Editor::introduced(&json!({ "units": true, "bindings": "sometimes" }), &Value::Null);
    let told = editor.next(|message| message["method"] == "window/showMessage");
    let wanted = "proofread: the option `bindings` is `\"sometimes\"`; give \"never\" or \"once\" or \"always\"";
    assert_eq!((&told["params"]["message"], &told["params"]["type"]), (&json!(wanted), &json!(2)));
    editor.open(NOTES, "markdown", text);
    assert_eq!(codes(&editor.marks(NOTES, 1)), [("units".to_owned(), 3)]);
    let settings = json!({ "settings": { "proofread": { "doubts": true, "units": false } } });
    editor.notify("workspace/didChangeConfiguration", &settings);
    let marks = editor.marks(NOTES, 1);
    assert_eq!(codes(&marks), [("truncated".to_owned(), 4)]);
    let told = editor.hover(NOTES, 0, 8)["contents"]["value"].as_str().expect("text").to_owned();
    assert!(told.contains("set aside: "), "{told}");
    editor.finish();
}

#[test]
fn a_text_in_an_unknown_language_is_told_and_left_alone() {
    let mut editor = Editor::introduced(&Value::Null, &Value::Null);
    editor.open("file:///a.py", "python", "# 2 + 2 = 5");
    let told = editor.next(|message| message["method"] == "window/logMessage");
    let message = told["params"]["message"].as_str().expect("text");
    assert!(message.starts_with("file:///a.py is not checked, since neither its language `python`"), "{message}");
    editor.change("file:///a.py", 2, &json!([{ "text": "x" }]));
    assert_eq!(editor.hover("file:///a.py", 0, 0), Value::Null);
    editor.finish();
}

#[test]
fn what_is_malformed_is_refused_and_what_follows_is_answered() {
    let mut editor = Editor::start();
    let refused = |editor: &mut Editor| editor.next(|message| !message["error"].is_null())["error"]["code"].clone();
    // Too early.
    assert_eq!(editor.request("textDocument/hover", &json!({}))["error"]["code"], -32002);
    editor.write(b"Content-Length: 8\r\n\r\n{\"id\": 1");
    assert_eq!(refused(&mut editor), -32700);
    editor.write(b"Hello\r\n\r\n");
    assert_eq!(refused(&mut editor), -32700);
    for wrong in [json!([]), json!(7), json!({}), json!({ "id": [1], "method": "shutdown" }), json!({ "method": 1 })] {
        editor.send(&wrong);
        assert_eq!(refused(&mut editor), -32600, "{wrong}");
    }
    editor.request("initialize", &json!({ "capabilities": 7, "workspaceFolders": [1, { "uri": [] }], "rootUri": 3 }));
    assert_eq!(editor.request("initialize", &json!({}))["error"]["code"], -32600);
    assert_eq!(editor.request("textDocument/rename", &json!({}))["error"]["code"], -32601);
    for wrong in
        [Value::Null, json!([]), json!({ "position": {} }), json!({ "position": { "line": 1e300, "character": 0 } })]
    {
        assert_eq!(editor.request("textDocument/hover", &wrong)["error"]["code"], -32602, "{wrong}");
        assert_eq!(editor.request("textDocument/codeAction", &wrong)["error"]["code"], -32602, "{wrong}");
    }
    for method in ["didOpen", "didChange", "didSave", "didClose"] {
        editor.notify(&format!("textDocument/{method}"), &json!({ "textDocument": 7 }));
        let told = editor.next(|message| message["method"] == "window/logMessage");
        assert!(told["params"]["message"].as_str().is_some_and(|why| why.contains(method)), "{told}");
    }
    // Nothing waits that could be cancelled, and no answer is owed to a notification that is not known.
    editor.notify("$/cancelRequest", &json!({ "id": 1 }));
    editor.notify("workspace/didChangeWatchedFiles", &json!({}));
    editor.send(&json!({ "jsonrpc": "2.0", "id": 99, "result": null }));
    // After a change that cannot be made, the text is not known any more.
    editor.open(NOTES, "markdown", "$2 + 2 = 5$");
    assert_eq!(editor.marks(NOTES, 1).len(), 1);
    editor.change(NOTES, 2, &json!([{ "range": { "start": {} }, "text": "" }]));
    let gone = editor.next(|message| message["method"] == "textDocument/publishDiagnostics");
    assert_eq!(gone["params"]["diagnostics"], json!([]));
    assert_eq!(editor.hover(NOTES, 0, 9), Value::Null);
    editor.request("shutdown", &Value::Null);
    assert_eq!(editor.request("textDocument/hover", &json!({}))["error"]["code"], -32600);
    editor.notify("exit", &Value::Null);
    assert_eq!(editor.code(), Some(0));
}

#[test]
fn an_editor_that_is_gone_has_not_asked_for_the_end() {
    assert_eq!(Editor::introduced(&Value::Null, &Value::Null).code(), Some(1));
    let mut editor = Editor::start();
    editor.notify("exit", &Value::Null);
    assert_eq!(editor.code(), Some(1));
}

fn address(file: &Path) -> String {
    format!("file://{}", file.display())
}

#[test]
fn a_chapter_is_read_with_the_macros_of_texts_that_are_open_and_of_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().canonicalize().expect("a folder").join(name);
    fs::write(file("main.tex"), "\\documentclass{book}\\input{macros}\\begin{document}\\input{one}\\end{document}")
        .expect("written");
    fs::write(file("macros.tex"), "\\newcommand{\\two}{2}").expect("written");
    let chapter = "It is $\\two + 3 = 6$.";
    fs::write(file("one.tex"), chapter).expect("written");
    let (one, macros) = (address(&file("one.tex")), address(&file("macros.tex")));

    let mut editor = Editor::introduced(&Value::Null, &Value::Null);
    editor.open(&one, "latex", chapter);
    assert_eq!(editor.marks(&one, 1).len(), 1);
    // A text that is open counts before its file, and is heard when it changes.
    editor.open(&macros, "latex", "\\newcommand{\\two}{2}");
    assert_eq!(editor.marks(&macros, 1), [] as [Value; 0]);
    editor.change(&macros, 2, &json!([{ "text": "\\newcommand{\\two}{3}" }]));
    assert_eq!(editor.marks(&one, 1), [] as [Value; 0]);
    // When it is closed, the file counts again.
    editor.notify("textDocument/didClose", &json!({ "textDocument": { "uri": macros } }));
    assert_eq!(editor.marks(&one, 1).len(), 1);
    // A file that has changed is read again.
    fs::write(file("macros.tex"), "\\newcommand{\\two}{ 3 }").expect("written");
    editor.notify("textDocument/didSave", &json!({ "textDocument": { "uri": one } }));
    assert_eq!(editor.marks(&one, 1), [] as [Value; 0]);
    editor.finish();
}

#[test]
fn a_file_may_have_the_name_of_the_command() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("lsp"), "$2 + 2 = 5$").expect("written");
    let run = |line: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_proofread"));
        let out = command.args(line).current_dir(folder.path()).stdin(Stdio::null()).output().expect("it runs");
        (out.status.code(), String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr))
    };
    for line in [&["./lsp", "--input", "markdown"][..], &["--input", "markdown", "lsp"]] {
        let (code, told) = run(line);
        assert!(code == Some(1) && told.contains("printed 5, recomputed 4"), "{line:?}: {told}");
    }
    let (code, told) = run(&["lsp", "notes.md"]);
    assert!(code == Some(2) && told.contains("notes.md"), "{told}");
    let (code, told) = run(&["lsp", "--help"]);
    assert!(code == Some(0) && told.contains("./lsp") && told.contains("bindings"), "{told}");
    let (code, told) = run(&["--help"]);
    assert!(code == Some(0) && told.contains("Serve an editor"), "{told}");
    // Nobody is there.
    assert_eq!(run(&["lsp"]), (Some(1), String::new()));
}
