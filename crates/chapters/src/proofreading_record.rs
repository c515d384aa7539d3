//! What proofreading found in texts by others: the judgements and measurements that the crate `proofread` keeps.

use anyhow::Context;
use serde::de::DeserializeOwned;

const UNIVERSITY_PHYSICS: &str = include_str!("../../proofread/judged/university-physics.csv");
const UNITS: &str = include_str!("../../proofread/judged/university-physics-units.csv");
const CONTACT: &str = include_str!("../../proofread/judged/contact.csv");
const ERRATA: &str = include_str!("../../proofread/judged/errata.csv");
const RUNS: &str = include_str!("../../proofread/judged/runs.csv");

/// What a person who read a flag in its context says of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Judgement {
    /// The text is wrong as printed.
    Real,
    /// The author rounded on the way or cut digits off.
    Rounding,
    /// A convention of the field, such as a sign or a unit that is understood.
    Convention,
    /// The program misread the text.
    Ours,
}

/// Whether something is so, as the records write it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Answer {
    /// It is.
    Yes,
    /// It isn't.
    No,
}

/// A flag in the textbook on which the program was tuned.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct Flag {
    /// The module of the book.
    pub module: String,
    /// The element in the module's file, by its id.
    pub element: String,
    /// The two sides that differ, as the program read them.
    pub chain: String,
    /// What the left side gives, to as many digits as are printed; empty if there is no such number.
    #[serde(default)]
    pub recomputed: String,
    /// The single edit that would make the chain agree; empty without one.
    #[serde(default)]
    pub hint: String,
    /// Whether the hint of a misprint names what should be printed.
    pub hint_right: Option<Answer>,
    /// Whether the chain is in the newest state.
    pub printed_new: Answer,
    /// Whether the program flags it in the old state.
    pub flagged_old: Answer,
    /// Whether the program flags it in the newest state.
    pub flagged_new: Answer,
    /// What the reader says.
    pub judgement: Judgement,
    /// Why, or what should be printed.
    pub why: String,
}

/// A flag on the unit in the newest state of the textbook.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct UnitFlag {
    /// The module of the book.
    pub module: String,
    /// The element in the module's file, by its id.
    pub element: String,
    /// The two sides.
    pub chain: String,
    /// What the reader says.
    pub judgement: Judgement,
    /// Why, or what should be printed.
    pub why: String,
}

/// A flag at first contact with a text.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct Contact {
    /// `first` to `eleventh`; `again` if only a run after repairs raised it, `publisher` in another book by the publisher of the tuning
    /// text.
    pub round: String,
    /// The text.
    pub text: String,
    /// The file in it, by its path.
    pub file: String,
    /// The line of the result in the file.
    pub line: u32,
    /// The two sides that differ, as the program read them.
    pub chain: String,
    /// Whether the hint of a misprint names what should be printed.
    pub hint_right: Option<Answer>,
    /// Whether the program flags it after the repairs.
    pub after: Answer,
    /// What the reader says.
    pub judgement: Judgement,
    /// What a second reader says who did not know the first judgement; none in rounds with one reader.
    pub second_judge: Option<Judgement>,
    /// Whether the fault of the text behind it is the fault behind a flag above.
    pub repeats: Answer,
    /// Why, or what should be printed.
    pub why: String,
}

/// A mistake that the book's publisher corrected.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct PublishedErratum {
    /// `number` or `unit`.
    pub kind: String,
    /// The list on which the program puts the place, or `no`.
    pub found: String,
}

/// A run of the program over a text.
#[derive(Clone, Debug, serde::Deserialize)]
pub(crate) struct ToolRun {
    /// Its name.
    pub run: String,
    /// The text, by the name that the contacts use.
    pub text: String,
    /// Formulas or lines.
    pub formulas: u32,
    /// Chains that arithmetic can check.
    pub checkable: u32,
    /// Chains that were checked.
    pub checked: u32,
    /// Flags on the number.
    #[cfg(test)]
    pub flags: u32,
    /// Results in which one digit was changed on purpose.
    pub results: Option<u32>,
    /// How many changed results were flagged.
    pub results_noticed: Option<u32>,
    /// How many changed results still agree to their printed digits, so that nobody could notice them.
    pub results_invisible: Option<u32>,
    /// Operands in which one digit was changed on purpose.
    pub operands: Option<u32>,
    /// How many changed operands were flagged.
    pub operands_noticed: Option<u32>,
    /// How many changed operands don't change the result in its printed digits, so that nobody could notice them.
    pub operands_invisible: Option<u32>,
}

fn read<T: DeserializeOwned>(record: &str) -> anyhow::Result<Vec<T>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(record.as_bytes());
    reader.deserialize().map(|row| row.context("a record of what proofreading found")).collect()
}

/// The run of this name.
pub(crate) fn run(name: &str) -> anyhow::Result<ToolRun> {
    runs()?.into_iter().find(|run| run.run == name).with_context(|| format!("no run is named `{name}`"))
}

/// The flags on a number in the tuning text.
pub(crate) fn flags() -> anyhow::Result<Vec<Flag>> {
    read(UNIVERSITY_PHYSICS)
}

/// The flags on a unit in its newest state.
pub(crate) fn unit_flags() -> anyhow::Result<Vec<UnitFlag>> {
    read(UNITS)
}

/// The flags at first contact.
pub(crate) fn contacts() -> anyhow::Result<Vec<Contact>> {
    read(CONTACT)
}

/// The errata that arithmetic can see.
pub(crate) fn errata() -> anyhow::Result<Vec<PublishedErratum>> {
    read(ERRATA)
}

/// The runs.
pub(crate) fn runs() -> anyhow::Result<Vec<ToolRun>> {
    read(RUNS)
}

/// The 95 % interval of Wilson for a share of `all`, as fractions.
pub(crate) fn wilson(part: usize, all: usize) -> (f64, f64) {
    const Z: f64 = 1.959_963_984_540_054;
    let n = all as f64;
    if all == 0 {
        return (0.0, 1.0);
    }
    let share = part as f64 / n;
    let scale = 1.0 + Z * Z / n;
    let centre = (share + Z * Z / (2.0 * n)) / scale;
    let half = Z * (share * (1.0 - share) / n + Z * Z / (4.0 * n * n)).sqrt() / scale;
    (centre - half, centre + half)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_is_wilsons() {
        let (low, high) = wilson(15, 21);
        assert!((low - 0.500).abs() < 5e-4 && (high - 0.862).abs() < 5e-4, "{low} {high}");
        assert_eq!(wilson(0, 0), (0.0, 1.0));
    }

    #[test]
    fn two_readers_judge_the_second_round_and_the_last_three() {
        for flag in contacts().expect("read") {
            let by_two = ["second", "ninth", "tenth", "eleventh"].contains(&flag.round.as_str());
            assert_eq!(flag.second_judge.is_some(), by_two, "{}: {}", flag.text, flag.why);
        }
    }

    #[test]
    fn the_runs_count_the_flags_that_were_judged() {
        let contacts = contacts().expect("read");
        let is_contact = |run: &&ToolRun| !["old", "new", "again"].contains(&run.run.as_str());
        for run in runs().expect("read").iter().filter(is_contact) {
            let judged = contacts.iter().filter(|flag| flag.round == run.run && flag.text == run.text).count();
            assert_eq!(judged, run.flags as usize, "{}", run.text);
        }
        for run in runs().expect("read").iter().filter(|run| run.run == "again") {
            let such = |flag: &&Contact| flag.text == run.text && flag.after == Answer::Yes;
            assert_eq!(contacts.iter().filter(such).count(), run.flags as usize, "{} after the repairs", run.text);
        }
        let flags = flags().expect("read");
        let flagged = |of: fn(&Flag) -> Answer| flags.iter().filter(|flag| of(flag) == Answer::Yes).count();
        for (name, count) in [("old", flagged(|flag| flag.flagged_old)), ("new", flagged(|flag| flag.flagged_new))] {
            assert_eq!(count, run(name).expect("a run").flags as usize, "{name}");
        }
    }
}
