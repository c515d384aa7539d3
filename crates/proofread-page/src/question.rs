//! The question of a page: a line of options, and the text.

use proofread::{NamePolicy, TextFormat};

/// Bytes of a text that are read at most: a megabyte.
pub const MOST_BYTES: usize = 1_000_000;

/// Bytes of a line of options that are read at most.
const MOST_OPTIONS: usize = 1000;

/// Why a longer text is refused, and what to do with it.
pub fn too_long_message() -> String {
    format!(
        "This text is longer than {} MB, which is all that the page takes at once. Give a part of it, or use the command.",
        MOST_BYTES / 1_000_000
    )
}

/// Which values that the text gives to names are put into formulas, by the word of the option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamePolicyChoice {
    /// The word.
    pub word: &'static str,
    /// What it means to a reader.
    pub label: &'static str,
    /// What the proofreader is told.
    pub name_policy: NamePolicy,
}

impl NamePolicyChoice {
    /// Every choice, the one of a form that nobody has touched first: as in the command, none are used.
    pub const ALL: [Self; 3] = [
        Self { word: "never", label: "never", name_policy: NamePolicy::Never },
        Self { word: "once", label: "in a short text, if a name has one value", name_policy: NamePolicy::Once },
        Self { word: "always", label: "everywhere, the latest value of a name", name_policy: NamePolicy::Always },
    ];
}

/// A text, and what a reader wants to know about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PageQuestion<'t> {
    /// What it is written in, if the reader says so.
    pub format: Option<TextFormat>,
    /// The ending of its file's name, if it comes from a file.
    pub extension: &'t str,
    /// Which values of names are used.
    pub name_policy: NamePolicy,
    /// Whether numbers are listed that agree although their units do not.
    pub units: bool,
    /// Whether differences are listed that are set aside as doubts.
    pub doubts: bool,
    /// Whether hints are wanted, which take longer than the rest.
    pub hints: bool,
    /// The text.
    pub text: &'t str,
}

impl<'t> PageQuestion<'t> {
    /// A text, and otherwise the page's options as they are at first.
    ///
    /// ```
    /// use geneva_proofread_page::PageQuestion;
    ///
    /// let question = PageQuestion::new("2 + 2 = 5");
    /// assert_eq!((question.format, question.doubts, question.units), (None, true, false));
    /// ```
    pub fn new(text: &'t str) -> Self {
        Self {
            format: None,
            extension: "",
            name_policy: NamePolicyChoice::ALL[0].name_policy,
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
    ///
    /// ```
    /// use geneva_proofread_page::PageQuestion;
    ///
    /// let question = PageQuestion::parse("units=yes hints=no\n2 + 2 = 5")?;
    /// assert_eq!((question.text, question.units, question.hints), ("2 + 2 = 5", true, false));
    /// assert!(PageQuestion::parse("format=word\n").is_err());
    /// # Ok::<(), String>(())
    /// ```
    pub fn parse(question: &'t str) -> Result<Self, String> {
        let (options, text) = question.split_once('\n').unwrap_or((question, ""));
        if text.len() > MOST_BYTES {
            return Err(too_long_message());
        }
        if options.len() > MOST_OPTIONS {
            return Err(format!(
                "The line of options before the text has more than {MOST_OPTIONS} bytes. Give fewer options."
            ));
        }
        let mut read = Self::new(text);
        for option in options.split_whitespace() {
            let (name, value) = option.split_once('=').unwrap_or((option, ""));
            match name {
                "format" if value == "recognised" => read.format = None,
                "format" => {
                    let known = TextFormat::ALL.map(|(name, _)| name);
                    read.format = Some(TextFormat::from_name(value).ok_or_else(|| one_of(name, value, &known))?);
                }
                "extension" => read.extension = value,
                "bindings" => {
                    let known = NamePolicyChoice::ALL.map(|of| of.word);
                    let found = NamePolicyChoice::ALL.iter().find(|of| of.word == value);
                    read.name_policy = found.ok_or_else(|| one_of(name, value, &known))?.name_policy;
                }
                "units" => read.units = parse_switch(name, value)?,
                "doubts" => read.doubts = parse_switch(name, value)?,
                "hints" => read.hints = parse_switch(name, value)?,
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

fn parse_switch(name: &str, value: &str) -> Result<bool, String> {
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
            PageQuestion::parse("format=latex bindings=never units=yes extension=md\n\nunits=no\n1 = 2").expect("read");
        assert_eq!(question.text, "\nunits=no\n1 = 2");
        assert_eq!(
            (question.format, question.name_policy, question.units),
            (Some(TextFormat::Latex), NamePolicy::Never, true)
        );
        assert_eq!(PageQuestion::parse(""), Ok(PageQuestion::new("")));
        assert_eq!(PageQuestion::parse("format=recognised\n1"), Ok(PageQuestion::new("1")));
    }

    #[test]
    fn what_is_not_known_is_named_with_what_is() {
        for (options, words) in [
            ("format=word", "format `word`: give one of markdown, latex, xml, html, notebook, plain, csv"),
            ("bindings=<b>", "bindings `<b>`: give one of never, once, always"),
            ("units", "units ``: give one of yes, no"),
            ("x\u{1b}=1", "option `x\\u{1b}`: give one of format, extension, bindings, units, doubts, hints"),
        ] {
            assert_eq!(PageQuestion::parse(options), Err(words.to_owned()));
        }
        assert_eq!(PageQuestion::parse(&format!("\n{}", "x".repeat(MOST_BYTES + 1))), Err(too_long_message()));
        let told = PageQuestion::parse(&format!("extension={}\n", "x".repeat(3000))).expect_err("too many");
        assert!(told.starts_with("The line of options before the text has more than 1000 bytes."), "{told}");
    }
}
