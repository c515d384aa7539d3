//! What is going on, on a terminal.

use indicatif::ProgressBar;
use std::time::Duration;

/// A step under way; its line vanishes when the value is dropped.
pub struct Step(ProgressBar);

/// Shows that a step has begun: a turning sign and its name on standard error, or nothing if that is no terminal.
pub fn step(name: &'static str) -> Step {
    let bar = ProgressBar::new_spinner().with_message(name);
    bar.enable_steady_tick(Duration::from_millis(100));
    Step(bar)
}

impl Drop for Step {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
