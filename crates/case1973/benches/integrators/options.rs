//! What the command line of a bench with a record asks for.

use std::path::PathBuf;

/// The options.
#[derive(Default)]
pub(crate) struct BenchOptions {
    /// Whether it is run as a bench. As a test it only shows that it works.
    pub is_bench: bool,
    /// How many turns, if that is said.
    pub rounds: Option<u32>,
    /// Where a record is wanted, if one is.
    pub record: Option<PathBuf>,
}

impl BenchOptions {
    /// Reads the arguments behind the program's name.
    pub(crate) fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self::default();
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--bench" => options.is_bench = true,
                "--record" => options.record = Some(arguments.next().ok_or("--record needs a file")?.into()),
                "--rounds" => {
                    let count = arguments.next().and_then(|count| count.parse().ok());
                    options.rounds =
                        Some(count.filter(|count| *count > 0).ok_or("--rounds needs a number above zero")?);
                }
                // What a test runner says to every test.
                "--test" | "--nocapture" => {}
                other => return Err(format!("{other}: the options are --record FILE and --rounds N")),
            }
        }
        Ok(options)
    }
}
