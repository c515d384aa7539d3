//! The figures that a reader moves.
//!
//! A page asks a question, `wheel?stations=6&crank=-20`, and gets a drawing and numbers as JSON: of the same functions that drew and
//! tested the figures that stand still. There is no formula and no drawing here: this crate reads the arguments, asks
//! `geneva-ask`, `geneva-case1973` or the mechanism's own crate, and writes down what they give. It holds no number that a
//! source prints; where a figure needs one, it comes with the question.
//!
//! Compiled for WebAssembly it is what a page loads ([`exports`](self) is the interface there), but for the designer of wheels:
//! `geneva-live-design` and `geneva-live-files` are modules of their own. Compiled for the machine at hand it is what the book's still
//! figures and the tests call. Both give the same characters.

mod answer;
mod arguments;
mod assemblies;
mod control;
mod design;
mod escapement;
#[cfg(all(target_family = "wasm", feature = "exports"))]
mod exports;
mod given;
mod json;
mod mistake;
mod page_words;
mod pin;
mod polygon;
mod question;
mod turned;
mod watch;
mod wheel;

pub use answer::{LiveNumber, LiveQuantity, LiveReply, Progress, round_for_box};
pub use arguments::LiveArguments;
pub use control::{Control, ControlKind, ControlSide, Live, LiveFile, PointerDrag, Preset, ToleranceTable};
pub use design::{LIVE as DESIGN, NUMBERS_FILE, SHEET_FILE, wheel_for_a_file};
pub use json::text_object;
pub use page_words::words as refusal;
pub use question::LiveQuestion;
pub use turned::{ToleranceRow, ToleranceState, TurnedParts};

/// All figures that a reader moves, in the order of the book.
pub const LIVE: [&Live; 6] = [&pin::LIVE, &wheel::LIVE, &DESIGN, &polygon::LIVE, &mistake::LIVE, &escapement::LIVE];

/// The figures that this crate answers when it is a module: all but the designer of wheels, which would be half of it.
#[cfg(all(target_family = "wasm", feature = "exports"))]
const OWN: [&Live; 5] = [&pin::LIVE, &wheel::LIVE, &polygon::LIVE, &mistake::LIVE, &escapement::LIVE];

#[cfg(all(target_family = "wasm", feature = "exports"))]
fn module_answer(question: &str) -> String {
    answer_among(&OWN, question)
}

/// The figure of this name.
pub fn by_name(name: &str) -> Option<&'static Live> {
    LIVE.into_iter().find(|live| live.name == name)
}

/// The answer to a question, `name?arguments`, as a JSON object: see [`LiveReply::to_json`]. The question `name.motion?arguments`
/// asks for what [`Live::answer_in_motion`] gives, `name.turned` for `turned` alone, and `name.tolerances` for the rows of tolerances. A question that cannot be answered gets `error`:
/// what is wrong, and what to give. Files are made by `geneva-live-files`.
pub fn answer(question: &str) -> String {
    answer_among(&LIVE, question)
}

/// The answer to a question to one of these figures: see [`answer()`]. A module that has fewer figures is smaller.
pub fn answer_among(figures: &[&Live], question: &str) -> String {
    match asked(figures, question) {
        Ok(answer) => answer,
        Err(message) => text_object("error", &message),
    }
}

fn asked(figures: &[&Live], question: &str) -> Result<String, String> {
    let LiveQuestion { name, part, arguments } = LiveQuestion::parse(question)?;
    let live = figures.iter().find(|live| live.name == name).ok_or_else(|| {
        let names: Vec<_> = figures.iter().map(|live| live.name).collect();
        format!("no figure `{}`: there are {}", arguments::quoted(name), names.join(", "))
    })?;
    match part {
        Some("turned") => {
            live.turned_parts(&arguments).map(|parts| parts.map_or("null".to_owned(), |parts| parts.to_json()))
        }
        Some("tolerances") => {
            let rows = live.tolerance_rows(&arguments)?;
            Ok(json::array(rows.iter().map(ToleranceRow::to_json)))
        }
        Some("motion") => live.answer_in_motion(&arguments).map(|answer| answer.to_json()),
        Some(part) => {
            Err(format!("no part `{}` of a figure: there are motion, turned, tolerances", arguments::quoted(part)))
        }
        None => live.answer(&arguments).map(|answer| answer.to_json()),
    }
}
