//! Printing: streams, colours, exit codes, lines of a readable length, and drawings without a page.

use crate::Answer;
use crate::destination::Destination;
use crate::printable::{chain, escaped_lines};
use crate::version;
use anstream::adapter::strip_str;
use anyhow::Context;
use clap::builder::styling::{AnsiColor, Style};
use clap::error::ErrorKind;
use geneva_ledger::Verdict;
use std::io::{self, Write};
use std::process::ExitCode;

pub use geneva_ask::written::count;

/// Characters in a line of text.
pub const WIDTH: usize = 100;

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
pub trait Streams {
    /// Takes text for standard output.
    fn print(&mut self, text: &str) -> anyhow::Result<()>;

    /// Takes text for standard error.
    fn tell(&mut self, text: &str);
}

/// The streams of this process.
pub struct Own;

/// The message if standard output takes nothing.
pub const UNWRITABLE: &str = "cannot write to standard output";

// A standard output that is closed (`>&-`) cannot be told from one that nobody wants to see: the runtime opens /dev/null in
// its place before `main`, for reading and writing, and so do others who give a program /dev/null, such as Python's
// `subprocess.DEVNULL`. So it counts as /dev/null.

impl Streams for Own {
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

    fn tell(&mut self, text: &str) {
        // Nobody is left to be told if this fails.
        let _ = anstream::stderr().lock().write_all(text.as_bytes());
    }
}

impl Streams for Answer {
    fn print(&mut self, text: &str) -> anyhow::Result<()> {
        self.stdout += &strip_str(text).to_string();
        Ok(())
    }

    fn tell(&mut self, text: &str) {
        self.stderr += &strip_str(text).to_string();
    }
}

/// What is asked for instead of a file.
pub const STANDARD_OUTPUT: &str = "-";

/// Writes a whole answer where it was asked for: to standard output, or to a file without colours.
pub fn write(text: &str, asked: &str, streams: &mut dyn Streams) -> anyhow::Result<()> {
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
pub fn complain(error: &anyhow::Error, streams: &mut dyn Streams) {
    let red = AnsiColor::Red.on_default().bold();
    streams.tell(&format!("{red}error:{red:#} {}\n", escaped_lines(&chain(error))));
}

/// Answers what asks for help or for the version, and says what is wrong with a command line.
pub fn explain(error: &clap::Error, streams: &mut dyn Streams) -> anyhow::Result<Outcome> {
    if error.kind() == ErrorKind::DisplayVersion {
        streams.print(&version::page())?;
        return Ok(Outcome::AsRecorded);
    }
    let text = error.render().ansi().to_string();
    if error.use_stderr() {
        streams.tell(&text);
        return Ok(Outcome::Failed);
    }
    streams.print(&text)?;
    Ok(Outcome::AsRecorded)
}

/// How a verdict is coloured; the colour repeats what the word says.
pub fn style(verdict: Verdict) -> Style {
    let colour = match verdict {
        Verdict::Reproduced => AnsiColor::Green,
        Verdict::Truncated | Verdict::FromRounded | Verdict::ReadOff => AnsiColor::Yellow,
        Verdict::ReproducedInError => AnsiColor::Magenta,
        Verdict::Corrected => AnsiColor::Cyan,
        Verdict::NotReproduced | Verdict::NotReproducible => AnsiColor::Red,
    };
    colour.on_default()
}

/// The style of headings.
pub fn heading() -> Style {
    Style::new().bold()
}

/// A name and its text, which is broken into lines under one another.
pub fn field(name: &str, text: &str) -> String {
    wrapped(&format!("  {name:<14}"), text)
}

/// `text` in lines of at most [`WIDTH`] characters: behind `lead`, then under it.
pub fn wrapped(lead: &str, text: &str) -> String {
    let indent = lead.chars().count();
    let mut lines = vec![lead.to_owned()];
    let mut length = indent;
    for word in text.split_whitespace() {
        let (word_length, first) = (word.chars().count(), length == indent);
        if !first && length + 1 + word_length > WIDTH {
            lines.push(" ".repeat(indent));
            length = indent;
        }
        let Some(line) = lines.last_mut() else { break };
        if length > indent {
            line.push(' ');
            length += 1;
        }
        line.push_str(word);
        length += word_length;
    }
    lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// `text` in `width` characters, cut with an ellipsis if it is longer.
pub fn cut(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return format!("{text:<width$}");
    }
    let kept: String = text.chars().take(width.saturating_sub(1)).collect();
    format!("{kept}…")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_text_is_broken_between_words_and_stays_under_its_beginning() {
        let text = wrapped("  - ", &"word ".repeat(40));
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH));
        assert!(text.lines().skip(1).all(|line| line.starts_with("    word")));
        assert_eq!(text.split_whitespace().count(), 41);
    }

    #[test]
    fn a_word_longer_than_the_line_stays_whole() {
        let word = "x".repeat(2 * WIDTH);
        assert_eq!(wrapped("", &word), format!("{word}\n"));
        assert_eq!(wrapped("a ", ""), "a\n");
    }

    #[test]
    fn what_is_cut_says_so() {
        assert_eq!(cut("β = 42°", 7), "β = 42°");
        assert_eq!(cut("β = 42°", 5), "β = …");
        assert_eq!(cut("β", 3), "β  ");
    }
}
