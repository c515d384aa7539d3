//! Printing: streams, colours, exit codes, lines of a readable length, and drawings without a page.

use crate::CommandOutput;
use crate::destination::{Destination, STANDARD_OUTPUT, UNWRITABLE};
use crate::printable::{chain, escaped_lines};
use crate::version;
use anstream::adapter::strip_str;
use anyhow::Context;
use clap::builder::styling::{AnsiColor, Style};
use clap::error::ErrorKind;
use geneva_evidence::PlainVerdict;
use geneva_host::layout::{columns, first_columns};
use std::borrow::Cow;
use std::io::{self, Write};
use std::process::ExitCode;

pub(crate) use geneva_ask::number_format::count;
pub(crate) use geneva_host::layout::TextLayout;

/// What a command found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Everything matches the record, or there was nothing to compare.
    AsRecorded,
    /// Something differs from the record.
    Differs,
    /// The command failed, and the reader has been told why.
    Failed,
}

impl Outcome {
    /// `AsRecorded` if it is, otherwise `Differs`.
    pub fn as_recorded_if(it_is: bool) -> Self {
        if it_is { Self::AsRecorded } else { Self::Differs }
    }

    /// The exit code that says so.
    pub fn code(self) -> u8 {
        match self {
            Self::AsRecorded => 0,
            Self::Differs => 1,
            // As clap exits on bad usage.
            Self::Failed => 2,
        }
    }
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(outcome.code())
    }
}

/// Where the words of a command go.
pub(crate) trait OutputStreams {
    /// Takes text for standard output.
    fn print(&mut self, text: &str) -> anyhow::Result<()>;

    /// Takes text for standard error.
    fn write_stderr(&mut self, text: &str);

    /// How the text for standard output is laid out.
    fn layout(&self) -> TextLayout;
}

/// The streams of this process.
pub(crate) struct ProcessStreams;

// A standard output that is closed (`>&-`) cannot be told from one that nobody wants to see: the runtime opens /dev/null in
// its place before `main`, for reading and writing, and so do others who give a program /dev/null, such as Python's
// `subprocess.DEVNULL`. So it counts as /dev/null.

impl OutputStreams for ProcessStreams {
    /// Writes text without its colours unless a terminal shows them and `NO_COLOR` is not set.
    ///
    /// A reader that has seen enough and closes the pipe is no error.
    fn print(&mut self, text: &str) -> anyhow::Result<()> {
        let mut stream = anstream::stdout().lock();
        match stream.write_all(text.as_bytes()).and_then(|()| stream.flush()) {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            result => result.context(UNWRITABLE),
        }
    }

    fn write_stderr(&mut self, text: &str) {
        let text = TextLayout::of_errors().map_or(Cow::Borrowed(text), |layout| layout.folded(text).into());
        // Nobody is left to be told if this fails.
        let _ = anstream::stderr().lock().write_all(text.as_bytes());
    }

    fn layout(&self) -> TextLayout {
        TextLayout::of_output()
    }
}

impl OutputStreams for CommandOutput {
    fn print(&mut self, text: &str) -> anyhow::Result<()> {
        self.stdout += &strip_str(text).to_string();
        Ok(())
    }

    fn write_stderr(&mut self, text: &str) {
        self.stderr += &strip_str(text).to_string();
    }

    fn layout(&self) -> TextLayout {
        TextLayout::default()
    }
}

/// How the text of an answer is laid out that goes where it was asked for: to standard output, or to a file.
pub(crate) fn layout_for(asked: &str, streams: &dyn OutputStreams) -> TextLayout {
    if asked == STANDARD_OUTPUT { streams.layout() } else { TextLayout::default() }
}

/// Writes a whole answer where it was asked for: to standard output, or to a file without colours.
pub(crate) fn write_output(text: &str, asked: &str, streams: &mut dyn OutputStreams) -> anyhow::Result<()> {
    if asked == STANDARD_OUTPUT {
        return streams.print(text);
    }
    let mut destination = Destination::new(asked)?;
    for piece in strip_str(text) {
        destination.add(piece.as_bytes())?;
    }
    destination.finish()?;
    Ok(())
}

/// Writes an error and its causes to standard error.
pub(crate) fn complain(error: &anyhow::Error, streams: &mut dyn OutputStreams) {
    let red = AnsiColor::Red.on_default().bold();
    streams.write_stderr(&format!("{red}error:{red:#} {}\n", escaped_lines(&chain(error))));
}

/// Answers what asks for help or for the version, and says what is wrong with a command line.
pub(crate) fn explain(error: &clap::Error, streams: &mut dyn OutputStreams) -> anyhow::Result<Outcome> {
    if error.kind() == ErrorKind::DisplayVersion {
        streams.print(&streams.layout().folded(&version::page()))?;
        return Ok(Outcome::AsRecorded);
    }
    let text = error.render().ansi().to_string();
    if error.use_stderr() {
        streams.write_stderr(&text);
        return Ok(Outcome::Failed);
    }
    streams.print(&streams.layout().folded(&text))?;
    Ok(Outcome::AsRecorded)
}

/// How a verdict is coloured; the colour repeats what the word says.
pub(crate) fn style(verdict: PlainVerdict) -> Style {
    let colour = match verdict {
        PlainVerdict::Right => AnsiColor::Green,
        PlainVerdict::RightAsRead => AnsiColor::Cyan,
        PlainVerdict::Wrong => AnsiColor::Red,
        PlainVerdict::WrongInCopy => AnsiColor::Magenta,
        PlainVerdict::Open => AnsiColor::Yellow,
    };
    colour.on_default()
}

/// The style of headings.
pub(crate) fn heading() -> Style {
    Style::new().bold()
}

/// A name and its text, which is broken into lines under one another.
pub(crate) fn field(name: &str, text: &str, layout: TextLayout) -> String {
    layout.wrapped(&format!("  {name:<14}"), text)
}

/// `text` in `width` columns, cut with an ellipsis if it is longer.
pub(crate) fn truncate_to_width(text: &str, width: usize) -> String {
    if columns(text) <= width {
        return format!("{text}{}", " ".repeat(width - columns(text)));
    }
    let kept = first_columns(text, width.saturating_sub(1));
    format!("{kept}…{}", " ".repeat(width.saturating_sub(1 + columns(kept))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_cut_says_so() {
        assert_eq!(truncate_to_width("β = 42°", 7), "β = 42°");
        assert_eq!(truncate_to_width("β = 42°", 5), "β = …");
        assert_eq!(truncate_to_width("β", 3), "β  ");
    }
}
