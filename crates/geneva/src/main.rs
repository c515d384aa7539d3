//! The program `geneva`; all of it stands in the library beside it.

use std::process::ExitCode;

fn main() -> ExitCode {
    geneva_cli::main()
}
