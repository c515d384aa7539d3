//! The question of a page: a line of options, and the text.

use proofread::{Follow, Format};

/// Bytes of a text that are read at most: a megabyte.
pub const MOST_BYTES: usize = 1_000_000;

/// Bytes of a line of options that are read at most.
const MOST_OPTIONS: usize = 1000;

/// Why a longer text is refused, and what to do with it.
pub fn too_long() -> String {
    format!(
        "This text is longer than {} MB, which is all that the page takes at once. Give a part of it, or use the command.",
        MOST_BYTES / 1_000_000
    )
}

/// Which values that the text gives to names are put into formulas, by the word of the option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bindings {
    /// The word.
    pub word: &'static str,
    /// What it means to a reader.
    pub label: &'static str,
    /// What the proofreader is told.
    pub follow: Follow,
}

impl Bindings {
    /// Every choice, the usual one first.
    pub const ALL: [Self; 3] = [
        Self { word: "once", label: "in a short text, if a name has one value", follow: Follow::Once },
        Self { word: "always", label: "everywhere, the latest value of a name", follow: Follow::Always },
        Self { word: "never", label: "never", follow: Follow::Never },
    ];
}

/// A text, and what a reader wants to know about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Question<'t> {
    /// What it is written in, if the reader says so.
    pub format: Option<Format>,
    /// The ending of its file's name, if it comes from a file.
    pub extension: &'t str,
    /// Which values of names are used.
    pub follow: Follow,
    /// Whether numbers are listed that agree although their units do not.
    pub units: bool,
    /// Whether differences are listed that are set aside as doubts.
    pub doubts: bool,
    /// Whether hints are wanted, which take longer than the rest.
    pub hints: bool,
    /// The text.
    pub text: &'t str,
}

impl<'t> Question<'t> {
    /// A text, and otherwise the page's options as they are at first.
    pub fn about(text: &'t str) -> Self {
        Self {
            format: None,
            extension: "",
            follow: Bindings::ALL[0].follow,
            units: false,
            doubts: true,
            hints: true,
            text,
        }
    }

    /// Reads options up to the end of the first line, and behind it the text.
    ///
    /// The options are words such as `format=latex extension=tex bindings=never units=yes doubts=no hints=no`, with blanks between them, and
    /// each may be missing. A format `recognised` is the same as none.
    ///
    /// # Errors
    ///
    /// If the text is longer than [`MOST_BYTES`], or an option or its value is not known.
    pub fn parse(question: &'t str) -> Result<Self, String> {
        let (options, text) = question.split_once('\n').unwrap_or((question, ""));
        if text.len() > MOST_BYTES {
            return Err(too_long());
        }
        if options.len() > MOST_OPTIONS {
            return Err(format!(
                "The line of options before the text has more than {MOST_OPTIONS} bytes. Give fewer options."
            ));
        }
        let mut read = Self::about(text);
        for option in options.split_whitespace() {
            let (name, value) = option.split_once('=').unwrap_or((option, ""));
            match name {
                "format" if value == "recognised" => read.format = None,
                "format" => {
                    let known = Format::ALL.map(|(name, _)| name);
                    read.format = Some(Format::named(value).ok_or_else(|| one_of(name, value, &known))?);
                }
                "extension" => read.extension = value,
                "bindings" => {
                    let known = Bindings::ALL.map(|of| of.word);
                    let found = Bindings::ALL.iter().find(|of| of.word == value);
                    read.follow = found.ok_or_else(|| one_of(name, value, &known))?.follow;
                }
                "units" => read.units = yes(name, value)?,
                "doubts" => read.doubts = yes(name, value)?,
                "hints" => read.hints = yes(name, value)?,
                _ => {
                    return Err(one_of(
                        "option",
                        name,
                        &["format", "extension", "bindings", "units", "doubts", "hints"],
                    ));
                }
            }
        }
        Ok(read)
    }
}

fn yes(name: &str, value: &str) -> Result<bool, String> {
    match value {
        "yes" => Ok(true),
        "no" => Ok(false),
        _ => Err(one_of(name, value, &["yes", "no"])),
    }
}

fn one_of(name: &str, value: &str, known: &[&str]) -> String {
    let quoted: String = value.chars().take(40).flat_map(char::escape_debug).collect();
    format!("{name} `{quoted}`: give one of {}", known.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_end_with_the_first_line() {
        let question =
            Question::parse("format=latex bindings=never units=yes extension=md\n\nunits=no\n1 = 2").expect("read");
        assert_eq!(question.text, "\nunits=no\n1 = 2");
        assert_eq!((question.format, question.follow, question.units), (Some(Format::Latex), Follow::Never, true));
        assert_eq!(Question::parse(""), Ok(Question::about("")));
        assert_eq!(Question::parse("format=recognised\n1"), Ok(Question::about("1")));
    }

    #[test]
    fn what_is_not_known_is_named_with_what_is() {
        for (options, words) in [
            ("format=word", "format `word`: give one of markdown, latex, xml, html, notebook, plain"),
            ("bindings=<b>", "bindings `<b>`: give one of once, always, never"),
            ("units", "units ``: give one of yes, no"),
            ("x\u{1b}=1", "option `x\\u{1b}`: give one of format, extension, bindings, units, doubts, hints"),
        ] {
            assert_eq!(Question::parse(options), Err(words.to_owned()));
        }
        assert_eq!(Question::parse(&format!("\n{}", "x".repeat(MOST_BYTES + 1))), Err(too_long()));
        let told = Question::parse(&format!("extension={}\n", "x".repeat(3000))).expect_err("too many");
        assert!(told.starts_with("The line of options before the text has more than 1000 bytes."), "{told}");
    }
}
