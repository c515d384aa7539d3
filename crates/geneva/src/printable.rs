//! Text that others wrote, made harmless for a terminal, and errors in one line.

pub(crate) use geneva_host::printable::{escape_and_shorten, escaped, escaped_lines, in_words, shown_path};

use std::io;

/// An error and its causes in one line, each once, and the system's words without their number.
pub(crate) fn chain(error: &anyhow::Error) -> String {
    let mut said = Vec::new();
    for cause in error.chain() {
        match cause.downcast_ref::<io::Error>() {
            // What is behind it has been said with it.
            Some(system) => {
                said.push(in_words(system));
                break;
            }
            None => said.push(cause.to_string()),
        }
    }
    said.join(": ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::Context;

    #[test]
    fn what_the_system_says_has_no_number() {
        let missing = std::fs::read("/nowhere/at all").context("a file").expect_err("nothing is there");
        let told = chain(&missing);
        assert!(told.starts_with("a file: ") && !told.contains("os error") && !told.ends_with(": "), "{told}");
    }
}
