//! The warnings of mdBook: each stops the build, in mdBook's words.
//!
//! mdBook tells what it cannot do (read a file that a chapter includes, close a tag, load a style sheet) as an event of
//! `tracing`, and goes on. Whoever listens to none gets a book with a hole and no word on it.

use anyhow::{anyhow, bail};
use std::fmt::{Debug, Write};
use std::sync::{Arc, Mutex, PoisonError};
use tracing_core::dispatcher::{Dispatch, with_default};
use tracing_core::field::{Field, Visit};
use tracing_core::metadata::LevelFilter;
use tracing_core::span::{Attributes, Id, Record};
use tracing_core::{Event, Level, Metadata, Subscriber};

/// Does this work of mdBook, and fails if mdBook warns of something on the way.
pub(super) fn refuse<T>(work: impl FnOnce() -> anyhow::Result<T>) -> anyhow::Result<T> {
    let listener = Listener::default();
    let heard = Arc::clone(&listener.heard);
    let done = with_default(&Dispatch::new(listener), work);
    let heard = std::mem::take(&mut *heard.lock().unwrap_or_else(PoisonError::into_inner));
    if heard.is_empty() {
        return done;
    }
    let heard = heard.join("\n");
    match done {
        Ok(_) => bail!("mdBook warns, and a book with a warning is not built; correct what it names:\n{heard}"),
        Err(why) => Err(anyhow!("mdBook warns:\n{heard}").context(format!("{why:#}"))),
    }
}

/// Keeps the warnings and errors of the thread that it listens to.
#[derive(Default)]
struct Listener {
    heard: Arc<Mutex<Vec<String>>>,
}

impl Subscriber for Listener {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        *metadata.level() <= Level::WARN
    }

    fn max_level_hint(&self) -> Option<LevelFilter> {
        Some(LevelFilter::WARN)
    }

    fn event(&self, event: &Event<'_>) {
        let mut words = Words::default();
        event.record(&mut words);
        self.heard.lock().unwrap_or_else(PoisonError::into_inner).push(words.0);
    }

    fn new_span(&self, _: &Attributes<'_>) -> Id {
        Id::from_u64(1)
    }

    fn record(&self, _: &Id, _: &Record<'_>) {}

    fn record_follows_from(&self, _: &Id, _: &Id) {}

    fn enter(&self, _: &Id) {}

    fn exit(&self, _: &Id) {}
}

/// The message of an event, and its further fields with their names.
#[derive(Default)]
struct Words(String);

impl Visit for Words {
    fn record_debug(&mut self, field: &Field, value: &dyn Debug) {
        // Writing to a string does not fail.
        let _ = match field.name() {
            "message" => write!(self.0, "{value:?}"),
            name => write!(self.0, " {name}: {value:?}"),
        };
    }
}
