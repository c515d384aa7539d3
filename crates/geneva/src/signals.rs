//! Signals that end the program while it builds the book.

/// Lets the signals that end a program clear up after a build of the book first. After that they end it as ever.
///
/// A signal that the program was told to ignore, as `nohup` does, stays ignored.
#[cfg(unix)]
pub fn clear_up_first() -> anyhow::Result<()> {
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
                // It fails for signals it does not know, and it knows these.
                let _ = emulate_default_handler(signal);
            });
        }
    });
    Ok(())
}

/// Elsewhere there are none. What an ended build leaves, the next one clears.
#[cfg(not(unix))]
pub fn clear_up_first() -> anyhow::Result<()> {
    Ok(())
}

/// Whether the program was started with a signal ignored, as far as the system tells: Linux does.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    ignored >> (signal - 1) & 1 == 1
}
