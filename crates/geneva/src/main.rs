//! The program `geneva`. Everything it does is in the library beside it.

use std::process::ExitCode;

fn main() -> ExitCode {
    geneva_cli::main()
}
