//! `geneva proofread`: the command of the crate `proofread`, on this program's streams.

use crate::output::{Outcome, OutputStreams};
use proofread::cli::{self, ProofreadArguments};

/// Streams that count as those of the command.
struct Through<'s>(&'s mut dyn OutputStreams);

impl cli::CommandStreams for Through<'_> {
    fn print(&mut self, text: &str) -> Result<(), String> {
        self.0.print(text).map_err(|error| format!("{error:#}"))
    }

    fn print_error(&mut self, text: &str) {
        self.0.write_stderr(text);
    }

    fn layout(&self) -> cli::TextLayout {
        self.0.layout()
    }
}

/// Runs the command, which says all there is to say.
pub(crate) fn run(arguments: &ProofreadArguments, streams: &mut dyn OutputStreams) -> Outcome {
    match cli::run(arguments, &mut Through(streams)) {
        0 => Outcome::AsRecorded,
        1 => Outcome::Differs,
        _ => Outcome::Failed,
    }
}
