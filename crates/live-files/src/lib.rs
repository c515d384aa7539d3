//! The files that a figure of the page makes.
//!
//! Most readers move a figure and take no file away, so the page loads what makes files only for the first one. This crate finds
//! the wheel of the page's settings as `geneva-live` does, and lets `geneva-ask` make the file. There is no shape and no number
//! here.
//!
//! Compiled for WebAssembly it is what a page loads; compiled for the machine at hand it is what the tests call. Both give
//! the same bytes.

#[cfg(target_family = "wasm")]
#[path = "../../live/src/exports.rs"]
mod exports;

#[cfg(target_family = "wasm")]
use answer as module_answer;

use geneva_ask::wheel::SHAPE_FILES;
use geneva_live::{LiveArguments, LiveQuestion, NUMBERS_FILE, SHEET_FILE, refusal, text_object, wheel_for_a_file};

/// The figure that has files.
const FIGURE: &str = "design";

/// The file with this name of the figure with this name, made with these arguments.
///
/// ```
/// use geneva_live::LiveArguments;
///
/// let arguments = LiveArguments::parse("stations=8")?;
/// let file = geneva_live_files::file("design", "wheel.step", &arguments)?;
/// assert!(file.starts_with(b"ISO-10303-21"));
/// # Ok::<(), String>(())
/// ```
///
/// # Errors
///
/// What is wrong with the arguments, what cannot be made, and a name of none of the figure's files.
pub fn file(figure: &str, name: &str, arguments: &LiveArguments) -> Result<Vec<u8>, String> {
    let shape = SHAPE_FILES.iter().find(|file| file.name == name);
    if figure != FIGURE || (shape.is_none() && name != NUMBERS_FILE && name != SHEET_FILE) {
        let shapes: String = SHAPE_FILES.iter().map(|file| format!("{}, ", file.name)).collect();
        return Err(format!(
            "a question for no file: after the figure `{FIGURE}` there are {shapes}{SHEET_FILE}, {NUMBERS_FILE}"
        ));
    }
    let wheel = wheel_for_a_file(arguments)?;
    match shape {
        Some(shape) => (shape.make)(&wheel),
        None if name == NUMBERS_FILE => wheel.answer().map(|answer| answer.table().into_bytes()),
        None => wheel.answer().map(|answer| answer.plain_sheet().into_bytes()),
    }
    .map_err(refusal)
}

/// The answer to a question such as `design.wheel.dxf?stations=6`, as a JSON object: the file as `file` or, if it is no text, as
/// `base64`. A question that cannot be answered gets `error`: what is wrong, and what to give.
///
/// ```
/// assert!(geneva_live_files::answer("design.wheel.dxf?stations=6").starts_with("{\"file\":"));
/// assert!(geneva_live_files::answer("design.wheel.dxf?stations=x").starts_with("{\"error\":"));
/// ```
pub fn answer(question: &str) -> String {
    let made = LiveQuestion::parse(question)
        .and_then(|LiveQuestion { name, part, arguments }| file(name, part.unwrap_or_default(), &arguments));
    match made {
        Ok(file) => file_object(file),
        Err(message) => text_object("error", &message),
    }
}

/// A file as a JSON object: its text, or bytes that are no text in base64.
fn file_object(file: Vec<u8>) -> String {
    match String::from_utf8(file) {
        Ok(text) => text_object("file", &text),
        Err(bytes) => text_object("base64", &base64(bytes.as_bytes())),
    }
}

/// Bytes as RFC 4648, section 4, has them.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits = three.iter().fold(0_u32, |bits, byte| bits << 8 | u32::from(*byte)) << (8 * (3 - three.len()));
        for digit in 0..4 {
            let at = (bits >> (18 - 6 * digit) & 63) as usize;
            text.push(if digit <= three.len() { char::from(DIGITS[at]) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_that_are_no_text_are_in_base64() {
        // The examples of RFC 4648, section 10.
        let examples =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (bytes, text) in examples {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
        assert_eq!(file_object(vec![0xff, 0xfe, 0xfd]), "{\"base64\":\"//79\"}");
        assert_eq!(file_object(b"0".to_vec()), "{\"file\":\"0\"}");
    }
}
