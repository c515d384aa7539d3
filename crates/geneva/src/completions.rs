//! Completions for a shell.

use crate::Arguments;
use clap::CommandFactory;
use clap_complete::Shell;

/// The shell's script.
pub(crate) fn script(shell: Shell) -> anyhow::Result<String> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "geneva", &mut script);
    Ok(String::from_utf8(script)?)
}
