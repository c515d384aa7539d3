//! A record of one sitting as a file: the machine in comments, then the names of the columns, then the lines.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};
use std::{fs, io};

/// The lines that say on what machine and when.
pub(crate) fn machine() -> Vec<String> {
    let processor = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = processor.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let compiler = Command::new("rustc").arg("--version").output();
    let compiler = compiler.map_or_else(|_| String::new(), |output| String::from_utf8_lossy(&output.stdout).into());
    let load = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let since = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let known = |text: &str| if text.trim().is_empty() { "unknown".to_owned() } else { text.trim().to_owned() };
    vec![
        format!("processor: {}", known(processor.map_or("", |(_, name)| name))),
        format!("cores: {}", std::thread::available_parallelism().map_or(0, usize::from)),
        format!("compiler: {}", known(&compiler)),
        format!("date: {}", date(since / 86_400)),
        format!(
            "load at the end, over 1, 5 and 15 minutes: {}",
            known(&load.split(' ').take(3).collect::<Vec<_>>().join(" "))
        ),
    ]
}

/// The date so many days after 1 January 1970, in the Gregorian calendar.
fn date(mut days: u64) -> String {
    let leap = |year: u64| (year.is_multiple_of(4) && !year.is_multiple_of(100)) || year.is_multiple_of(400);
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let mut month = 1;
    for length in [31, 28 + u64::from(leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    format!("{year}-{month:02}-{:02}", days + 1)
}

/// Writes the record beside its place, then puts it there. A relative path starts at the project's root.
pub(crate) fn write(path: &Path, comments: &[String], columns: &str, lines: &[String]) -> io::Result<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    let mut text = String::new();
    for comment in comments {
        let _ = writeln!(text, "# {comment}");
    }
    let _ = writeln!(text, "{columns}");
    for line in lines {
        let _ = writeln!(text, "{line}");
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let beside = path.with_extension("new");
    fs::write(&beside, text)?;
    fs::rename(&beside, &path)?;
    Ok(path)
}
