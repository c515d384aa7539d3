//! What the library finds in every chain that a person judged: the records in `judged`.
//!
//! The records hold each chain as a short snippet of ours and what the library says of it now. If a change of the library
//! changes that, this test names the chains, and whoever made the change says in the record whether it is for the better.

use proofread::{ChainFinding, CheckOptions, NamePolicy, ReportSection, TextFormat, proofread};

const UNIVERSITY_PHYSICS: &str = include_str!("../judged/university-physics.csv");
const CONTACT: &str = include_str!("../judged/contact.csv");
const ERRATA: &str = include_str!("../judged/errata.csv");
const UNITS: &str = include_str!("../judged/university-physics-units.csv");

/// A judged chain.
#[derive(serde::Deserialize)]
struct Chain {
    chain: String,
    /// For an erratum that its publisher accepted there is no other judgement.
    #[serde(default)]
    judgement: String,
    /// What the snippet is written in.
    format: String,
    /// Empty if the chain itself is the snippet.
    snippet: String,
    /// The list that the library puts it on, or `quiet`.
    now: String,
    /// The hint that the library gave in the whole text.
    #[serde(default)]
    hint: String,
    /// Whether a hint for a misprint names what should be printed.
    #[serde(default)]
    hint_right: String,
}

fn read(record: &str) -> Vec<Chain> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(record.as_bytes());
    reader.deserialize().map(|row| row.expect("a row of the record")).collect()
}

fn all() -> Vec<Chain> {
    [UNIVERSITY_PHYSICS, UNITS, CONTACT, ERRATA].into_iter().flat_map(read).collect()
}

/// What is found in a chain, with at most so many hints.
fn findings(chain: &Chain, hints: usize) -> Vec<ChainFinding> {
    let text = if chain.snippet.is_empty() { &chain.chain } else { &chain.snippet };
    let format = TextFormat::from_name(&chain.format).expect("a format");
    let options = CheckOptions { name_policy: NamePolicy::Never, agreeing: false, hints, ..CheckOptions::default() };
    proofread(text, format, options).expect("a text").findings
}

/// The list of the first finding that is on the most severe list.
fn found(chain: &Chain) -> &'static str {
    let findings = findings(chain, 0);
    let on = |list| findings.iter().any(|finding| finding.section == list);
    [ReportSection::Numbers, ReportSection::Units, ReportSection::Doubts]
        .into_iter()
        .find(|list| on(*list))
        .map_or("quiet", ReportSection::name)
}

#[test]
fn judged_chains_are_found_as_the_records_say() {
    let changed: Vec<String> = all()
        .iter()
        .filter(|chain| found(chain) != chain.now)
        .map(|chain| format!("{} ({}): {}, was {}", chain.chain, chain.judgement, found(chain), chain.now))
        .collect();
    assert!(changed.is_empty(), "other than on record:\n{}", changed.join("\n"));
}

#[test]
fn misprints_are_flagged() {
    let quiet: Vec<_> = all().into_iter().filter(|chain| chain.judgement == "real" && chain.now == "quiet").collect();
    let names: Vec<&str> = quiet.iter().map(|chain| chain.chain.as_str()).collect();
    assert!(names.is_empty(), "a misprint that a run found is not flagged any more: {names:#?}");
}

/// Right hints that are withheld all the same, and why.
const WITHHELD: [(&str, &str); 3] = [
    ("(105.4 − 97.5)/√((37.3^2)/9 + (39.4^2)/11) = 0.56", "a result of two digits agrees with a wrong edit as easily"),
    ("√(8 × 1.38 × 10^23 × 273)/(π × 28.0 × 10^−3/6.02 × 10^23) = 454 m·s^−1", "either exponent would do"),
    ("9 × 2 − 9 − 9 = 8", "either of two nines would do"),
];

#[test]
fn right_hints_for_misprints_stay() {
    let (mut lost, mut wrong, mut right) = (Vec::new(), Vec::new(), 0);
    for chain in all().iter().filter(|chain| chain.judgement == "real" && !chain.hint.is_empty()) {
        assert!(["yes", "no"].contains(&chain.hint_right.as_str()), "{}", chain.chain);
        let findings = findings(chain, 10);
        let hints: Vec<&str> =
            findings.iter().filter_map(|of| of.hint.as_ref()).map(|hint| hint.words.as_str()).collect();
        match (chain.hint_right.as_str(), hints.contains(&chain.hint.as_str())) {
            ("yes", false) if WITHHELD.iter().all(|(of, _)| *of != chain.chain) => {
                lost.push(format!("{}: {hints:?}, not {}", chain.chain, chain.hint));
            }
            ("no", true) => wrong.push(format!("{}: {}", chain.chain, chain.hint)),
            ("yes", true) => right += 1,
            _ => {}
        }
    }
    let told = format!("{right} of {} that are still given", right + wrong.len());
    assert!(crate::readme().contains(&told), "README.md does not say: {told}");
    println!("{} wrong hints are still given: {wrong:#?}", wrong.len());
    assert!(lost.is_empty(), "{} lost: {lost:#?}", lost.len());
}

#[test]
fn what_is_computed_is_never_shown_as_what_is_printed() {
    let squeezed = |text: &str| text.replace(' ', "");
    let mut told = 0;
    for chain in all() {
        for of in findings(&chain, 0).iter().filter(|of| of.section != ReportSection::Agreeing) {
            told += 1;
            assert!(of.recomputed.is_some() || of.difference.is_some(), "{}: nothing is told", chain.chain);
            let alike = of.recomputed.as_deref().is_some_and(|text| squeezed(text) == squeezed(&of.printed));
            assert!(!alike, "{}: {}", chain.chain, of.values_in_words());
        }
    }
    assert!(told > 400, "{told}");
}

#[test]
fn each_judgement_has_a_reason_and_one_of_four_names() {
    for chain in all() {
        assert!(["", "real", "rounding", "convention", "ours"].contains(&chain.judgement.as_str()), "{}", chain.chain);
        assert!(["numbers", "units", "doubts", "quiet"].contains(&chain.now.as_str()), "{}", chain.chain);
    }
}

/// A flag in a text by others, as far as the runs count it.
#[derive(serde::Deserialize)]
struct CountedFlag {
    round: String,
    text: String,
    after: String,
    second_judge: String,
}

/// A run over a text.
#[derive(serde::Deserialize)]
struct CountedRun {
    run: String,
    text: String,
    flags: usize,
}

fn rows<T: serde::de::DeserializeOwned>(record: &str) -> Vec<T> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(record.as_bytes());
    reader.deserialize().map(|row| row.expect("a row of the record")).collect()
}

#[test]
fn the_runs_count_the_flags_that_were_judged() {
    let flags: Vec<CountedFlag> = rows(CONTACT);
    let runs: Vec<CountedRun> = rows(include_str!("../judged/runs.csv"));
    for run in runs.iter().filter(|run| !["old", "new"].contains(&run.run.as_str())) {
        let counts = |flag: &&CountedFlag| match run.run.as_str() {
            "again" => flag.text == run.text && flag.after == "yes",
            name => flag.text == run.text && flag.round == name,
        };
        assert_eq!(flags.iter().filter(counts).count(), run.flags, "{}, {}", run.text, run.run);
    }
}

#[test]
fn two_readers_judge_the_second_round_and_the_ninth_to_the_eleventh() {
    for flag in rows::<CountedFlag>(CONTACT) {
        let by_two = ["second", "ninth", "tenth", "eleventh"].contains(&flag.round.as_str());
        assert_eq!(!flag.second_judge.is_empty(), by_two, "{}, {}", flag.text, flag.round);
    }
}
