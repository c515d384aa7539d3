//! How far a sweep has come, on a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar on standard error, or nothing if that is no terminal; it vanishes when the value is dropped.
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar of so many rows, or nothing in any case if it is hidden.
    pub fn new(rows: usize, hidden: bool) -> Self {
        let bar = if hidden { ProgressBar::hidden() } else { ProgressBar::new(rows as u64) };
        // The template is a constant; should it be wrong, the bar has another look.
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {human_pos} of {human_len} rows, {eta} to go") {
            bar.set_style(style);
        }
        Self(bar)
    }

    /// So many rows more.
    pub fn add(&self, rows: usize) {
        self.0.inc(rows as u64);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
