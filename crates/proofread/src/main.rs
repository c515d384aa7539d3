//! The program `proofread`. Everything it does is in the library's module `cli`.

use clap::{Args, Command, FromArgMatches};
use proofread::cli::{self, CommandStreams, TextLayout};
use std::borrow::Cow;
use std::io::{ErrorKind, Write};
use std::process::ExitCode;

/// The streams of this process, with colours where a terminal shows them.
struct ProcessStreams;

impl CommandStreams for ProcessStreams {
    fn print(&mut self, text: &str) -> Result<(), String> {
        let mut stream = anstream::stdout().lock();
        match stream.write_all(text.as_bytes()).and_then(|()| stream.flush()) {
            // Whoever reads has seen enough.
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
            result => result.map_err(|why| format!("cannot write to standard output: {why}")),
        }
    }

    fn print_error(&mut self, text: &str) {
        let text = TextLayout::of_errors().map_or(Cow::Borrowed(text), |layout| layout.folded(text).into());
        // Nobody is left to be told if this fails.
        let _ = anstream::stderr().lock().write_all(text.as_bytes());
    }

    fn layout(&self) -> TextLayout {
        TextLayout::of_output()
    }
}

fn main() -> ExitCode {
    let command = Command::new("proofread")
        .version(env!("CARGO_PKG_VERSION"))
        .about("Recompute every chain of numbers that a text prints, with units and to the printed digits")
        .after_help(cli::EXAMPLES);
    let matches = cli::ProofreadArguments::augment_args(command).get_matches();
    match cli::ProofreadArguments::from_arg_matches(&matches) {
        Ok(arguments) => cli::run(&arguments, &mut ProcessStreams).into(),
        Err(error) => error.exit(),
    }
}
