//! Signals that end the program while it builds the book.

/// Clears up after a build of the book when a signal ends the program, which then still dies of that signal.
///
/// A signal that the program was told to ignore, as `nohup` does, stays ignored.
#[cfg(unix)]
pub(crate) fn clear_up_first() -> anyhow::Result<()> {
    use anyhow::Context;
    use geneva_press::building;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    let mut signals = Signals::new([SIGHUP, SIGINT, SIGTERM].into_iter().filter(|signal| !is_ignored(*signal)))
        .context("cannot watch for signals")?;
    std::thread::spawn(move || {
        for signal in signals.forever() {
            building::abandon(|| {
                // It only fails for signals that it does not know.
                let _ = emulate_default_handler(signal);
            });
        }
    });
    Ok(())
}

/// Does nothing on other systems, where the next build clears up.
#[cfg(not(unix))]
pub fn clear_up_first() -> anyhow::Result<()> {
    Ok(())
}

/// Whether the program was started with a signal ignored. Only Linux tells.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    ignored >> (signal - 1) & 1 == 1
}
