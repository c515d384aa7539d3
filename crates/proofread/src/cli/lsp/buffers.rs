//! Texts that an editor has open, and their changes.

use super::checking::{CheckedText, is_in_project};
use super::positions::{Position, PositionEncoding, byte_at, range_from_json};
use crate::reader::TextFormat;
use serde_json::Value;
use std::path::PathBuf;
use std::sync::Arc;

/// A document that an editor has open.
pub(super) struct OpenDocument {
    pub text: Arc<str>,
    /// Its version, as the editor counts; null if it has none.
    pub version: Value,
    /// What it is like: another number if the text or what is asked of it has changed.
    pub revision: u64,
    pub format: TextFormat,
    pub file: Option<PathBuf>,
    /// What was found last, maybe in an earlier text.
    pub checked: Option<CheckedText>,
}

impl OpenDocument {
    /// Its file with its text, if other files may define something for it, or it for them.
    pub(super) fn project_file(&self) -> Option<(PathBuf, Arc<str>)> {
        let file = self.file.as_ref().filter(|file| is_in_project(self.format, file))?;
        Some((file.clone(), self.text.clone()))
    }
}

/// A change of a text: what stands in a range from now on, or in all of the text.
#[derive(Debug, PartialEq)]
pub(super) struct Change<'c> {
    range: Option<[Position; 2]>,
    text: &'c str,
}

impl<'c> Change<'c> {
    /// A change as the protocol writes it; none if it is none.
    pub(super) fn from_json(value: &'c Value) -> Option<Self> {
        let text = value["text"].as_str()?;
        let range = match value.get("range") {
            None | Some(Value::Null) => None,
            Some(range) => Some(range_from_json(range)?),
        };
        Some(Self { range, text })
    }
}

/// A text after changes, each of which counts in the text after the one before.
pub(super) fn changed_text(text: &str, changes: &[Change<'_>], encoding: PositionEncoding) -> String {
    let mut out = text.to_owned();
    for change in changes {
        match change.range {
            None => change.text.clone_into(&mut out),
            Some(range) => {
                let [start, end] = range.map(|at| byte_at(&out, at, encoding));
                out.replace_range(start.min(end)..start.max(end), change.text);
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn changed(text: &str, changes: &Value, encoding: PositionEncoding) -> Option<String> {
        let changes: Option<Vec<_>> = changes.as_array()?.iter().map(Change::from_json).collect();
        Some(changed_text(text, &changes?, encoding))
    }

    fn range(start: [usize; 2], end: [usize; 2]) -> Value {
        let place = |[line, column]: [usize; 2]| json!({ "line": line, "character": column });
        json!({ "start": place(start), "end": place(end) })
    }

    #[test]
    fn changes_follow_each_other() {
        let changes = json!([
            { "range": range([0, 2], [0, 3]), "text": "y" },
            { "range": range([1, 0], [1, 0]), "text": "new\n" },
            { "range": range([2, 0], [9, 9]), "text": "" },
        ]);
        assert_eq!(changed("𝟙x\nb\n", &changes, PositionEncoding::Utf16).as_deref(), Some("𝟙y\nnew\n"));
        let all = json!([{ "text": "all" }, { "range": range([0, 1], [0, 0]), "text": "t" }]);
        assert_eq!(changed("x", &all, PositionEncoding::Utf8).as_deref(), Some("tll"));
    }

    #[test]
    fn what_is_no_change_is_none() {
        for wrong in [
            json!([{}]),
            json!([{ "text": 1 }]),
            json!([{ "text": "", "range": {} }]),
            json!([{ "text": "", "range": { "start": { "line": -1, "character": 0 }, "end": { "line": 0, "character": 0 } } }]),
            json!([null]),
        ] {
            assert_eq!(changed("x", &wrong, PositionEncoding::Utf16), None, "{wrong}");
        }
    }
}
