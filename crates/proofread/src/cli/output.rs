//! Streams, exit codes, and text that no terminal obeys.

use clap::builder::styling::{AnsiColor, Style};
use geneva_host::printable::{escaped, is_obeyed};

pub use geneva_host::layout::TextLayout;

/// Where the words of the command go. Both take colours, which the caller strips where no terminal shows them.
pub trait CommandStreams {
    /// Takes text for standard output.
    ///
    /// # Errors
    ///
    /// If it cannot be written, with the reason.
    fn print(&mut self, text: &str) -> Result<(), String>;

    /// Takes text for standard error.
    fn print_error(&mut self, text: &str);

    /// How the text for standard output is laid out: as in a pipe, unless the stream says otherwise.
    fn layout(&self) -> TextLayout {
        TextLayout::default()
    }
}

/// How the command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RunStatus {
    /// Nothing was found.
    Clean,
    /// Something was found.
    Found,
    /// An argument or an input is wrong.
    Failed,
}

impl RunStatus {
    pub(super) fn code(self) -> u8 {
        match self {
            Self::Clean => 0,
            Self::Found => 1,
            Self::Failed => 2,
        }
    }
}

/// An error message with its mark.
pub(crate) fn format_error(message: &str) -> String {
    let red = AnsiColor::Red.on_default().bold();
    format!("{red}error:{red:#} {}\n", escaped(message))
}

/// A style for headings.
pub(crate) fn bold_style() -> Style {
    Style::new().bold()
}

/// A line of a text in which one sign stands for each that a terminal would obey, so that it is as long as it was.
pub(crate) fn printable(text: &str) -> String {
    let shown = |c: char| match c {
        '\t' => ' ',
        c if is_obeyed(c) => '\u{fffd}',
        c => c,
    };
    text.chars().map(shown).collect()
}

/// A text with a capital letter at its start.
pub(super) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default() + letters.as_str()
}
