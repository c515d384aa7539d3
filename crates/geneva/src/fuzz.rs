//! Random command lines: whatever is typed, there is an answer or a refusal in words, and no panic.
//!
//! The options come from the parser itself, so a new one is tried without being named here. `GENEVA_FUZZ` says how many
//! lines are tried, and `GENEVA_FUZZ_SEED` which.

use crate::output::TextLayout;
use crate::{Arguments, Command};
use crate::{claims, completions, coverage, errata, escapement, mimic, quick_return, sweep, wheel};
use anstream::adapter::strip_str;
use clap::CommandFactory;
use fastrand::Rng;
use geneva_host::printable::is_obeyed;
use geneva_mimic::language::DECKS;
use std::ffi::OsString;

/// One of several.
fn pick<T: Clone>(dice: &mut Rng, all: &[T]) -> T {
    all[dice.usize(..all.len())].clone()
}

/// A number that the environment gives, or a usual one.
fn given(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{variable}={text}")))
}

/// Values that are seldom right, and those of other options.
const STRANGE: [&str; 36] = [
    "",
    " ",
    "0",
    "-0",
    "-1",
    "1e-30",
    "1e30",
    "1e31",
    "1e-31",
    "1e308",
    "1e309",
    "1e-320",
    "nan",
    "-inf",
    "−7",
    "0,3",
    "1e",
    "0x10",
    "-",
    "--",
    "?",
    "A=1",
    "=",
    "T=1e300",
    "1:2",
    "1:2:10000001",
    "0:1:3:log",
    ":::",
    "4,4",
    "3,,6",
    "x\u{1b}[31m",
    "\u{7}",
    "\u{202e}",
    "a\nb",
    "９",
    "/",
];

/// Values that are often right.
const USUAL: [&str; 16] =
    ["3", "4", "6", "8", "0.1", "0.3", "2", "10", "45", "-30", "90", "60", "0.05", "0.1:0.4:3", "1:8:4:log", "X=1."];

/// A file for rows in a folder that is taken away.
fn file(folder: &tempfile::TempDir) -> String {
    folder.path().join("rows.csv").to_string_lossy().into_owned()
}

/// A random command line, most of it as the parser wants it.
fn line(dice: &mut Rng, root: &clap::Command) -> Vec<String> {
    let mut line = vec!["geneva".to_owned()];
    let mut command = root;
    while command.has_subcommands() {
        // One that has a command of its own is mostly used without it.
        if command.is_args_conflicts_with_subcommands_set() && dice.usize(..8) != 0 {
            break;
        }
        let all: Vec<_> =
            command.get_subcommands().filter(|of| !["book", "preprocess"].contains(&of.get_name())).collect();
        command = pick(dice, &all);
        line.push(command.get_name().to_owned());
    }
    // What an argument without a name is.
    let decks = DECKS.iter().map(|(name, _)| (*name).to_owned()).chain(["no-deck".to_owned()]).collect::<Vec<_>>();
    let ids = geneva_documents::PIN.claims().iter().map(|claim| claim.id.to_owned()).collect::<Vec<_>>();
    let is_strange = dice.usize(..3) == 0;
    for argument in command.get_arguments() {
        let (name, is_required) = (argument.get_long(), argument.is_required_set());
        if ["help", "version", "output"].contains(&name.unwrap_or_default()) || dice.usize(..4) != 0 && !is_required {
            continue;
        }
        let possible: Vec<_> = argument.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
        let value = match dice.usize(..10) {
            0 if is_strange => pick(dice, &STRANGE).to_owned(),
            1 if is_strange => pick(dice, &USUAL).repeat(40),
            _ if !possible.is_empty() => pick(dice, &possible),
            _ if name.is_none() && command.get_name() == "claims" => pick(dice, &ids),
            _ if name.is_none() => pick(dice, &decks),
            _ => pick(dice, &USUAL).to_owned(),
        };
        line.extend(name.map(|name| format!("--{name}")));
        if argument.get_action().takes_values() {
            line.push(value);
        }
    }
    if is_strange && dice.usize(..4) == 0 {
        let at = 1 + dice.usize(..line.len());
        line.insert(at, pick(dice, &STRANGE).to_owned());
    }
    line
}

/// What a command answers, without printing it; none if it takes too long for this.
fn answered(arguments: Arguments, folder: &tempfile::TempDir) -> Option<anyhow::Result<String>> {
    let layout = TextLayout::default();
    let quick = |source: Option<&'static geneva_evidence::Document>| source.is_some_and(|source| source.slug == "pin");
    Some(match arguments.command? {
        Command::Claims(wanted) if !wanted.ids.is_empty() => {
            let accounts = claims::accounts(&wanted, layout);
            accounts.and_then(|of| of.map_or_else(|| claims::page(&wanted, layout), |(page, _)| Ok(page)))
        }
        Command::Claims(wanted) if quick(wanted.source) => claims::page(&wanted, layout),
        Command::Errata(wanted) if quick(wanted.source) => errata::page(&wanted, layout),
        Command::Coverage(wanted) => coverage::page(&wanted, layout).map(|(page, _)| page),
        Command::Wheel(wanted) => wheel::page(&wanted, layout),
        Command::QuickReturn(wanted) => quick_return::page(&wanted, layout),
        Command::Escapement(wanted) => escapement::page(&wanted, layout),
        Command::Sweep(mut wanted) => {
            wanted.to.output = file(folder);
            wanted.threads = None;
            sweep::write_sweep(&wanted).and_then(|_| Ok(std::fs::read_to_string(file(folder))?))
        }
        Command::Mimic(wanted) => mimic::page(&wanted.action, layout),
        Command::Completions { shell } => completions::script(shell),
        _ => return None,
    })
}

/// The first zero of a text that has a sign: a minus, and digits that are all 0, neither of which is a part of something longer.
fn signed_zero(text: &str) -> Option<&str> {
    let is_part = |sign: char| sign.is_alphanumeric() || matches!(sign, '.' | '-' | '−' | '_' | ')' | '°');
    text.char_indices().filter(|(_, sign)| matches!(sign, '-' | '−')).find_map(|(at, sign)| {
        let digits = &text[at + sign.len_utf8()..];
        let length = digits.find(|sign: char| sign != '0' && sign != '.').unwrap_or(digits.len());
        let is_zero =
            digits.starts_with('0') && !digits[..length].trim_start_matches('0').trim_start_matches('.').contains('.');
        let ends = !digits[length..].starts_with(|sign: char| sign.is_ascii_digit());
        let begins = !text[..at].ends_with(is_part);
        (is_zero && ends && begins).then(|| &text[at..at + sign.len_utf8() + length])
    })
}

#[test]
fn a_zero_with_a_sign_is_found_and_nothing_else() {
    for text in ["-0", "x: -0.0,", "[−0.000]", "-0e0", "a −0 rpm", "\"-0\""] {
        assert!(signed_zero(text).is_some(), "{text}");
    }
    for text in ["-0.5", "-0.05", "0", "1e-05", "2026-01-00", "a-0", "1-0", "-1", "−0.001 rad", "10-0"] {
        assert_eq!(signed_zero(text), None, "{text}");
    }
}

/// Tells the line that was tried, if it panics.
struct Tried(String);

impl Drop for Tried {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("tried: {}", self.0);
        }
    }
}

#[test]
fn fuzz_command_lines_are_answered_or_refused_in_words() {
    let lines = given("GENEVA_FUZZ", 1000);
    let mut dice = Rng::with_seed(given("GENEVA_FUZZ_SEED", 0x5eed));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let root = Arguments::command();
    let (mut answers, mut refusals, mut misread, mut skipped) = (0, 0, 0, 0);
    for _ in 0..lines {
        let line = line(&mut dice, &root);
        let tried = Tried(format!("{line:?}"));
        let told = match crate::parse(line.iter().map(OsString::from)) {
            Err(error) => {
                misread += 1;
                error.render().to_string()
            }
            Ok(arguments) => match answered(arguments, &folder) {
                None => {
                    skipped += 1;
                    continue;
                }
                Some(Ok(page)) => {
                    answers += 1;
                    let page = strip_str(&page).to_string();
                    let is_number = |word: &str| !["NaN", "inf", "-inf", "−inf", "nan", "infinity"].contains(&word);
                    let mut words = page.split([' ', ',', ':', '"', '\n', '(', ')', '[', ']']);
                    assert!(words.all(is_number), "{}", tried.0);
                    assert_eq!(signed_zero(&page), None, "{}", tried.0);
                    page.replace("\r\n", "\n")
                }
                Some(Err(error)) => {
                    refusals += 1;
                    let told = crate::printable::escaped_lines(&crate::printable::chain(&error)).into_owned();
                    assert!(told.len() < 6000 && !told.contains("os error"), "{}: {told}", tried.0);
                    told
                }
            },
        };
        assert!(!told.trim().is_empty(), "{}: {told:?}", tried.0);
        let obeyed = told.chars().find(|sign| is_obeyed(*sign) && !"\n\t".contains(*sign));
        assert_eq!(obeyed, None, "{}: {told:?}", tried.0);
    }
    println!("{lines} lines: {answers} answers, {refusals} refusals, {misread} misread, {skipped} skipped");
    assert!(answers > lines / 20 && refusals > lines / 50 && misread > lines / 20);
}
