//! Progress, on a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::borrow::Cow;
use std::time::Duration;

/// A step under way; its line on standard error vanishes when the value is dropped.
pub(crate) struct Step(ProgressBar);

/// Shows that a step has begun: a turning sign and its name on standard error, or nothing if that is no terminal.
pub(crate) fn step(name: impl Into<Cow<'static, str>>) -> Step {
    let bar = ProgressBar::new_spinner().with_message(name);
    bar.enable_steady_tick(Duration::from_millis(100));
    Step(bar)
}

/// A bar that counts things such as rows; nothing if it is hidden or standard error is not a terminal.
pub(crate) fn bar(count: usize, things: &'static str, hidden: bool) -> Step {
    let bar = if hidden { ProgressBar::hidden() } else { ProgressBar::new(count as u64) };
    let bar = bar.with_message(things);
    // The template is a constant; should it be wrong, the bar has another look.
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {human_pos} of {human_len} {msg}, {eta} to go") {
        bar.set_style(style);
    }
    Step(bar)
}

impl Step {
    /// Counts so many things more.
    pub(crate) fn add(&self, count: usize) {
        self.0.inc(count as u64);
    }
}

impl Drop for Step {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
