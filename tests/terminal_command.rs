//! Does all that a reader sees in a terminal fit into it? The program runs in pseudo-terminals of several widths.
#![cfg(unix)]

use crate::geneva;
use geneva_host::layout::columns;
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};
use std::fs::{self, File, OpenOptions};
use std::io::Read;
use std::process::Stdio;

/// Widths that are tried. Answers are no narrower than the first and no wider than the last.
const WIDTHS: [u16; 3] = [60, 80, 100];

const LOADED: &str = "wheel --stations 6 --rpm 360 --crank-radius 25 --inertia 0.002 --friction-torque 0.1 --thickness 10 --density 8860 \
                      --pin-material steel --wheel-material phosphor-bronze --at -20";

/// Command lines, answered and refused; in `@` is a folder with files.
const LINES: [&str; 50] = [
    "claims --source pin",
    "claims --source wild",
    "errata --source jazar",
    "errata --source wild --all",
    "coverage",
    "coverage --source jazar --against @/copy.txt",
    "coverage --source pin --against @/nowhere.txt",
    LOADED,
    "wheel --stations 3",
    "wheel --stations 8 --type spherical --rpm 10",
    "wheel --index-time 1 --dwell-time 2",
    "wheel --stations 6 --index-time 1 --dwell-time 1.8",
    "wheel --stations 2",
    "wheel --stations 6 --crank-radius 25 --pin-diameter 40",
    "wheel --stations 6 --thickness 3",
    "wheel --stations 6 --format dxfs",
    "wheel --rpm",
    "pin --crank-radius 40 --stations 6 --angle -20 --rad-s 8 --steps",
    "quick-return --ground 0.3 --crank 0.1 --crank-angle 75 --rpm 60",
    "quick-return --ground 0.3 --crank 0.1 --lever-angle 75 --rpm 60",
    "escapement --slots 4 --friction 0.3 --torque 2 --driver-inertia 1 --follower-inertia 15",
    "escapement --slots 6 --friction 0.2 --torque 1 --driver-inertia 1 --follower-inertia 5 --reset-deg 90",
    "escapement --slots 4 --friction 3 --torque 2 --driver-inertia 1 --follower-inertia 15",
    "sweep --slots 4 --friction 0.1:0.4:7 --inertia-ratio 0.1 --output @/rows.csv",
    "sweep --slots 4,7 --friction 0.1:0.4:7 --inertia-ratio 0.1",
    "mimic check escapement",
    "mimic check @/text.md",
    "mimic check @/long.deck",
    "mimic sort escapement",
    "mimic decks",
    "mimic functions",
    "mimic run predatos",
    "proofread @/text.md --units --doubts",
    "record @",
    "check @",
    "new @/made --from @/text.md",
    "new @/made --from @/nowhere.md",
    "proofread @/nowhere.md",
    "book build --output @/text.md",
    "book print --output @/nowhere/book.pdf",
    "preprocess supports html",
    "clams",
    "--version",
    "--help",
    "claims --help",
    "wheel --help",
    "sweep --help",
    "mimic run --help",
    "proofread --help",
    "completions --help",
];

/// What is data for a program or a machine, whatever its length, and so is not tried: all formats but the text, and these.
const DATA: [&str; 5] = [
    "sweep, without --output: rows of CSV",
    "coverage --record: an inventory",
    "mimic run: what the line printer printed",
    "mimic decks NAME: the cards of a deck",
    "completions SHELL: a script",
];

/// What the program writes to a terminal of so many columns.
fn shown(words: &[&str], width: u16) -> String {
    let terminal = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).expect("a terminal");
    grantpt(&terminal).and_then(|()| unlockpt(&terminal)).expect("a terminal for this user");
    let name = ptsname(&terminal, Vec::new()).expect("a name");
    let path = std::path::Path::new(name.to_str().expect("a path"));
    let other = OpenOptions::new().read(true).write(true).open(path).expect("the other side");
    let size = Winsize { ws_row: 40, ws_col: width, ws_xpixel: 0, ws_ypixel: 0 };
    tcsetwinsize(&other, size).expect("a size");
    let mut command = geneva(words);
    command.env("TERM", "xterm").stdin(Stdio::null());
    command.stdout(other.try_clone().expect("the same")).stderr(other);
    let mut child = command.spawn().expect("the program runs");
    // The command holds the other side, too.
    drop(command);
    let mut bytes = Vec::new();
    // After the last word the system says that nobody is there any more.
    let _ = File::from(terminal).read_to_end(&mut bytes);
    child.wait().expect("it ends");
    String::from_utf8(bytes).expect("text")
}

/// The lines as they stay: of what shows progress, only what is left.
fn lines(shown: &str) -> impl Iterator<Item = &str> {
    shown.split("\r\n").map(|line| line.rsplit('\r').next().unwrap_or_default())
}

/// A folder whose name is long, with a text to be proofread, the wrong copy of a source, and a deck.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::Builder::new().prefix(&"a-folder-with-a-long-name-".repeat(4)).tempdir().expect("a folder");
    let long = "12.5 + 17.25 + 3.125 + 4.0625 = 36.9375 + 1.5 = 39.0";
    let text = format!(
        "A sum: ${long}$ and then a long tail of text that goes on so that it must be cut somewhere in the line.\n\n\
         Also $2+2=5$, 表表表表表表表表表表表表表表表表表表表表表表表表表表表表表表 $3 \\cdot 4 = 13$ m.\n\n\
         $1.1+2.2+3.3+4.4+5.5+6.6+7.7+8.8+9.9+10.1+11.2+12.3+13.4+14.5+15.6+16.7+17.8+18.9=199.0$\n"
    );
    fs::write(folder.path().join("text.md"), text).expect("written");
    fs::write(folder.path().join("copy.txt"), "1 2 3\n".repeat(10)).expect("written");
    fs::write(folder.path().join("values.json"), "{\"sum\": 38.4375, \"none\": 5}").expect("written");
    let card = format!("X = {}$", "A + ".repeat(30));
    fs::write(folder.path().join("long.deck"), format!("{card}\nEND\n")).expect("written");
    folder
}

#[test]
fn every_answer_in_words_fits_into_the_terminal() {
    let folder = folder();
    let folder = folder.path().to_str().expect("a path");
    for line in LINES {
        let words: Vec<String> = line.split_whitespace().map(|word| word.replace('@', folder)).collect();
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        for width in WIDTHS {
            let shown = shown(&words, width);
            assert!(!shown.trim().is_empty() || line.starts_with("preprocess"), "{line}: nothing is said");
            for told in lines(&shown) {
                assert!(columns(told) <= usize::from(width), "{line}, {width} columns: {}: {told}", columns(told));
            }
        }
    }
}

#[test]
fn a_wider_terminal_is_not_filled_and_a_narrower_one_is_not_followed() {
    let sheet: Vec<&str> = LOADED.split_whitespace().collect();
    let widest = |width| lines(&shown(&sheet, width)).map(columns).max().expect("lines");
    assert_eq!((widest(200), widest(20)), (widest(100), widest(60)));
    // A terminal that does not know its width counts as a pipe.
    assert!(widest(0) > 80);
}

#[test]
fn every_command_is_tried_in_a_terminal() {
    let help = crate::stdout(&["--help"], 0);
    let commands = help.split("Commands:\n").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("commands");
    let names = commands.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let mut known = 0;
    for name in names.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help") {
        let is_tried = LINES.iter().chain(&DATA).any(|line| line.split([' ', ',']).next() == Some(name));
        assert!(is_tried, "{name} is not tried in a terminal");
        known += 1;
    }
    assert!(known > 8, "only {known} commands in the help");
}
