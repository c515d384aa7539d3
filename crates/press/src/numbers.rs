//! Numbers as the pages show them.

pub use geneva_evidence::number_format::{fixed, signed, significant, with_minus_sign};

/// A number of things as a sentence says it: a small one in a word.
pub fn in_words(count: usize) -> String {
    const WORDS: [&str; 10] = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"];
    WORDS.get(count).map_or_else(|| count.to_string(), |word| (*word).to_owned())
}

/// Words as a sentence begins with them.
pub fn sentence_start(words: &str) -> String {
    let mut rest = words.chars();
    let first = rest.next().into_iter().flat_map(char::to_uppercase);
    first.chain(rest).collect()
}
