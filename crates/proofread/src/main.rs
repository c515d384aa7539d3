//! The program `proofread`. Everything it does is in the library's module `cli`.

use clap::Parser;
use proofread::cli::{self, Streams};
use std::io::{ErrorKind, Write};
use std::process::ExitCode;

/// Recompute every chain of numbers that a text prints.
#[derive(Parser)]
#[command(name = "proofread", version, max_term_width = 100, after_help = cli::EXAMPLES)]
struct Line {
    #[command(flatten)]
    arguments: cli::Arguments,
}

/// The streams of this process, with colours where a terminal shows them.
struct Own;

impl Streams for Own {
    fn print(&mut self, text: &str) -> Result<(), String> {
        let mut stream = anstream::stdout().lock();
        match stream.write_all(text.as_bytes()).and_then(|()| stream.flush()) {
            // Whoever reads has seen enough.
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
            result => result.map_err(|why| format!("cannot write to standard output: {why}")),
        }
    }

    fn tell(&mut self, text: &str) {
        // Nobody is left to be told if this fails.
        let _ = anstream::stderr().lock().write_all(text.as_bytes());
    }
}

fn main() -> ExitCode {
    cli::run(&Line::parse().arguments, &mut Own).into()
}
