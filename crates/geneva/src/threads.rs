//! How many threads compute: as many as an option or the variable `RAYON_NUM_THREADS` says, or as the machine has.

use crate::printable::{escape_and_shorten, in_words};
use crate::typed::{self, MOST_THREADS};
use anyhow::{anyhow, ensure};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::env;
use std::error::Error;
use std::num::NonZeroUsize;
use std::thread::available_parallelism;

/// The variable that is read where no option says how many.
const VARIABLE: &str = "RAYON_NUM_THREADS";

/// A number of threads, and what said so.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Threads {
    pub number: usize,
    given: Given,
}

#[derive(Clone, Copy, Debug)]
enum Given {
    Option,
    Variable,
    Neither,
}

impl Threads {
    /// What the option says, or else the variable, or else the machine. Zero in the variable is as good as no variable:
    /// so it is to all programs that read it.
    pub(crate) fn new(option: Option<NonZeroUsize>) -> anyhow::Result<Self> {
        let machine = || available_parallelism().map_or(1, usize::from).min(MOST_THREADS);
        if let Some(number) = option {
            return Ok(Self { number: number.get(), given: Given::Option });
        }
        let Some(value) = env::var_os(VARIABLE) else {
            return Ok(Self { number: machine(), given: Given::Neither });
        };
        let value = value.to_string_lossy();
        if value.trim().parse() == Ok(0_usize) {
            return Ok(Self { number: machine(), given: Given::Neither });
        }
        let number = typed::threads(&value).ok();
        let way_out =
            format!("give an integer from 1 to {MOST_THREADS}, 0 for as many as the machine has, or unset it");
        ensure!(
            number.is_some(),
            "the variable {VARIABLE} is '{}', not a number of threads; {way_out}",
            escape_and_shorten(&value)
        );
        Ok(Self { number: number.map_or(1, NonZeroUsize::get), given: Given::Variable })
    }

    /// The threads themselves.
    ///
    /// # Errors
    ///
    /// The system has no room for so many.
    pub(crate) fn pool(self) -> anyhow::Result<ThreadPool> {
        let Self { number, given } = self;
        let built = ThreadPoolBuilder::new().num_threads(number).build();
        built.map_err(|error| {
            let told = match given {
                Given::Option => format!("--threads {number}: the system cannot start so many threads; give fewer"),
                Given::Variable => {
                    format!("the variable {VARIABLE} is {number}: the system cannot start so many threads; give fewer")
                }
                Given::Neither => {
                    format!("the system cannot start {number} threads, one for each processor; set {VARIABLE} to fewer")
                }
            };
            // The pool's own error says what its cause says.
            match error.source().and_then(|cause| cause.downcast_ref::<std::io::Error>()) {
                Some(cause) => anyhow!("{told}: {}", in_words(cause)),
                None => anyhow!(told),
            }
        })
    }
}
