//! The figures that a reader moves.
//!
//! A page asks a question, `wheel?stations=6&crank=-20`, and gets a drawing and numbers as JSON: of the same functions that drew and
//! tested the figures that stand still. There is no formula and no drawing here: this crate reads the arguments, asks
//! `geneva-ask`, `geneva-case1973` or the mechanism's own crate, and writes down what they give. It holds no number that a
//! source prints; where a figure needs one, it comes with the question.
//!
//! Compiled for WebAssembly it is what a page loads ([`exports`](self) is the interface there); compiled for the machine at
//! hand it is what the book's still figures and the tests call. Both give the same characters.

mod answer;
mod arguments;
mod control;
mod design;
mod escapement;
#[cfg(target_family = "wasm")]
mod exports;
mod mistake;
mod pin;
mod polygon;
mod turned;
mod watch;
mod wheel;

pub use answer::{LiveNumber, LiveQuantity, LiveReply, Progress, round_for_box};
pub use arguments::LiveArguments;
pub use control::{Control, ControlKind, ControlSide, Live, LiveFile, PointerDrag, Preset, ToleranceTable};
pub use turned::{ToleranceRow, ToleranceState, TurnedParts};

/// All figures that a reader moves, in the order of the book.
pub const LIVE: [&Live; 6] =
    [&pin::LIVE, &wheel::LIVE, &design::LIVE, &polygon::LIVE, &mistake::LIVE, &escapement::LIVE];

/// The figure of this name.
pub fn by_name(name: &str) -> Option<&'static Live> {
    LIVE.into_iter().find(|live| live.name == name)
}

/// The answer to a question, `name?arguments`, as a JSON object: see [`LiveReply::to_json`]. The question
/// `name.wheel.dxf?arguments` asks for the file with that name, and the answer holds it as `file` or, if it is no text, as `base64`;
/// `name.turned` asks for `turned` alone, and `name.tolerances` for the rows of tolerances. A question that cannot be answered gets `error`:
/// what is wrong, and what to give.
pub fn answer(question: &str) -> String {
    match asked(question) {
        Ok(answer) => answer,
        Err(message) => answer::object("error", &message),
    }
}

/// Bytes of a question that are read at most.
const MOST_BYTES: usize = 1 << 16;

fn asked(question: &str) -> Result<String, String> {
    if question.len() > MOST_BYTES {
        return Err(format!("the question has {} bytes: give {MOST_BYTES} at most", question.len()));
    }
    let (name, arguments) = question.split_once('?').unwrap_or((question, ""));
    let arguments = LiveArguments::parse(arguments)?;
    let (name, part) = name.split_once('.').map_or((name, None), |(name, part)| (name, Some(part)));
    let live = by_name(name).ok_or_else(|| {
        let names: Vec<_> = LIVE.iter().map(|live| live.name).collect();
        format!("no figure `{}`: there are {}", arguments::quoted(name), names.join(", "))
    })?;
    match part {
        Some("turned") => {
            live.turned_parts(&arguments).map(|parts| parts.map_or("null".to_owned(), |parts| parts.to_json()))
        }
        Some("tolerances") => {
            let rows = live.tolerance_rows(&arguments)?;
            Ok(answer::array(rows.iter().map(ToleranceRow::to_json)))
        }
        Some(file) => live.file(file, &arguments).map(answer::file_object),
        None => live.answer(&arguments).map(|answer| answer.to_json()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_has_so_many_bytes_at_most() {
        let of = |bytes: usize| answer(&"x".repeat(bytes));
        assert!(of(MOST_BYTES).contains("no figure") && of(MOST_BYTES + 1).contains("65537 bytes: give 65536"));
    }
}
