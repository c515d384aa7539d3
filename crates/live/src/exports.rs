//! What WebAssembly exports: memory for a question, and the answer.
//!
//! A page asks for room by [`room`], writes its question there in UTF-8, calls [`ask`], and reads so many bytes of UTF-8
//! at [`answer`]. Question and answer are those of `module_answer` of the crate. Several crates have these exports, each in a module
//! of its own: the figures that a reader moves, the designer of wheels, its files, and the proofreader.
#![allow(unsafe_code, reason = "the attribute that exports a name; nothing here is an unsafe operation")]

use std::cell::RefCell;

thread_local! {
    static QUESTION: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Room for a question of this many bytes; it holds until the next call.
#[unsafe(no_mangle)]
pub extern "C" fn room(bytes: usize) -> *mut u8 {
    QUESTION.with_borrow_mut(|question| {
        question.clear();
        question.resize(bytes, 0);
        question.as_mut_ptr()
    })
}

/// Answers the question that stands in the room; the length of the answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> usize {
    let question = QUESTION.with_borrow(|question| String::from_utf8_lossy(question).into_owned());
    let text = crate::module_answer(&question);
    ANSWER.with_borrow_mut(|answer| {
        *answer = text;
        answer.len()
    })
}

/// Where the last answer stands; it holds until the next call of [`ask`].
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.as_ptr())
}
