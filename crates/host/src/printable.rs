//! Text that others wrote, made harmless for a terminal and short enough for a message.

use std::borrow::Cow;
use std::io;
use std::path::Path;

/// Most characters of a value that is told back.
const MOST_SHOWN: usize = 60;

/// Whether a terminal obeys a character instead of showing it: control characters, and those that change the direction of
/// writing.
pub fn is_obeyed(sign: char) -> bool {
    let turns = matches!(sign, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    sign.is_control() || turns || matches!(sign, '\u{2028}' | '\u{2029}')
}

/// `text` with every character that a terminal obeys in words, such as `\u{1b}`.
pub fn escaped(text: &str) -> Cow<'_, str> {
    escaped_but(text, &[])
}

/// Text of more lines: line ends and tabs stay.
pub fn escaped_lines(text: &str) -> Cow<'_, str> {
    escaped_but(text, &['\n', '\t'])
}

fn escaped_but<'a>(text: &'a str, kept: &[char]) -> Cow<'a, str> {
    let is_harmful = |sign: char| is_obeyed(sign) && !kept.contains(&sign);
    if !text.contains(is_harmful) {
        return Cow::Borrowed(text);
    }
    let words = |sign: char| if is_harmful(sign) { sign.escape_unicode().to_string() } else { sign.to_string() };
    Cow::Owned(text.chars().map(words).collect())
}

/// A value as it was typed: harmless, and cut with an ellipsis where it is long.
pub fn escape_and_shorten(typed: &str) -> String {
    let text = escaped(typed);
    if text.chars().count() <= MOST_SHOWN {
        return text.into_owned();
    }
    text.chars().take(MOST_SHOWN - 1).chain(['…']).collect()
}

/// A path as it was typed: harmless. The end of a long one says more than its beginning, so it stays whole.
pub fn shown_path(path: &Path) -> String {
    escaped(&path.to_string_lossy()).into_owned()
}

/// The system's words for an error, without its number and without the names of temporary files.
pub fn in_words(error: &io::Error) -> String {
    if let Some(number) = error.raw_os_error() {
        let words = error.to_string();
        return words.strip_suffix(&format!(" (os error {number})")).map(str::to_owned).unwrap_or(words);
    }
    let within = error.get_ref().and_then(|inner| inner.source()).and_then(|inner| inner.downcast_ref::<io::Error>());
    within.map_or_else(|| error.to_string(), in_words)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_obeys_is_told_in_words() {
        assert_eq!(escaped("a\u{1b}[31m\u{7}\0\u{9b}\u{202e}b\n"), r"a\u{1b}[31m\u{7}\u{0}\u{9b}\u{202e}b\u{a}");
        assert_eq!(escaped_lines("β = 1\n\t2\r"), "β = 1\n\t2\\u{d}");
        assert_eq!(escape_and_shorten(&"1".repeat(3000)).chars().count(), MOST_SHOWN);
        assert!(escape_and_shorten(&"1".repeat(3000)).ends_with('…'));
        assert_eq!(escape_and_shorten("−7"), "−7");
    }

    #[test]
    fn what_the_system_says_has_no_number() {
        let missing = in_words(&std::fs::read("/nowhere/at all").expect_err("nothing is there"));
        assert!(!missing.is_empty() && !missing.contains("os error") && !missing.ends_with(' '), "{missing}");
        let within = tempfile::tempfile_in("/nowhere/at all").expect_err("nothing is there");
        assert!(within.to_string().contains("os error"), "{within}");
        assert!(!in_words(&within).contains("os error"), "{}", in_words(&within));
    }
}
