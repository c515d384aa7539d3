//! The rates beside the program: `judged/rates.csv` is what the records give, and README says what it says.

use proofread::{Caveat, DifferenceEvidence, chain_shape};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Flags at first contact, each with its judgement.
const FLAGS: &str = include_str!("../judged/contact-by-subject.csv");
/// Errors that others reported or corrected, each with whether the program sees it.
const REPORTED: &str = include_str!("../judged/reported.csv");
/// Counts of planted digits and of displayed equalities, text by text.
const COUNTED: &str = include_str!("../judged/counted.csv");
const README: &str = include_str!("../README.md");

/// The contact whose rates are told: the last one.
const LAST: &str = "twenty-first";
/// The contacts at which differences of one shape were one flag before any were drawn.
const DRAWN_BY_SHAPE: [&str; 4] = ["eighteenth", "nineteenth", "twentieth", "twenty-first"];
/// All contacts whose flags are on record.
const CONTACTS: [&str; 12] = [
    "twelfth",
    "thirteenth",
    "fourteenth",
    "fifteenth",
    "sixteenth",
    "sixteenth, later",
    "seventeenth",
    "seventeenth, later",
    "eighteenth",
    "nineteenth",
    "twentieth",
    "twenty-first",
];
/// What targets are set for, and what is told beside them.
const TARGETED: [(&str, &str); 7] = [
    ("flags", "all"),
    ("faults", "all"),
    ("flags", "mathematics"),
    ("flags", "physics and engineering"),
    ("planted", "all"),
    ("reported", "all"),
    ("displayed", "all"),
];

#[derive(serde::Deserialize)]
struct Flag {
    contact: String,
    text: String,
    kind: String,
    file: String,
    list: String,
    chain: String,
    judgement: String,
    repeats: String,
    hint: String,
    hint_right: String,
    slight: String,
    document_pairs: Option<usize>,
    document_differing: Option<usize>,
    confidence: String,
}

impl Flag {
    fn is_real(&self) -> bool {
        self.judgement == "real"
    }

    /// Whether the program of its contact set it apart. That of the seventeenth contact listed what it called less certain.
    fn is_apart(&self) -> bool {
        self.confidence == "less certain" && self.contact != "seventeenth"
    }

    /// What makes it less certain. What the record doesn't say of its document counts as nothing against it.
    fn caveat(&self) -> Option<Caveat> {
        let evidence = DifferenceEvidence {
            chain: &self.chain,
            has_hint: !self.hint.is_empty(),
            is_slight: self.slight == "yes",
            pairs: self.document_pairs.unwrap_or_default(),
            differing: self.document_differing.unwrap_or_default(),
        };
        evidence.caveat()
    }
}

#[derive(serde::Deserialize)]
struct Reported {
    contact: String,
    kind: String,
    visible: String,
    seen: String,
}

#[derive(serde::Deserialize)]
struct Counted {
    contact: String,
    measure: String,
    kind: String,
    good: u32,
    tried: u32,
}

fn read<T: serde::de::DeserializeOwned>(record: &str) -> Vec<T> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(record.as_bytes());
    reader.deserialize().map(|row| row.expect("a row of the record")).collect()
}

/// Good ones and all, by measure and kind of text, in the order in which they are told.
#[derive(Default)]
struct Rates(Vec<(&'static str, String, u32, u32)>);

impl Rates {
    /// Adds the rates of a measure by the kinds of its texts, the one with most first, and of all.
    fn add(&mut self, measure: &'static str, cases: impl Iterator<Item = (String, u32, u32)>) {
        let mut by_kind: BTreeMap<String, (u32, u32)> = BTreeMap::new();
        for (kind, good, tried) in cases {
            let sum = by_kind.entry(kind).or_default();
            *sum = (sum.0 + good, sum.1 + tried);
        }
        let all = by_kind.values().fold((0, 0), |sum, of| (sum.0 + of.0, sum.1 + of.1));
        let mut kinds: Vec<_> = by_kind.into_iter().collect();
        kinds.sort_by_key(|(_, (_, tried))| std::cmp::Reverse(*tried));
        let kinds = if kinds.len() > 1 { kinds } else { Vec::new() };
        for (kind, (good, tried)) in kinds.into_iter().chain([("all".to_owned(), all)]) {
            self.0.push((measure, kind, good, tried));
        }
    }

    fn of(&self, measure: &str, kind: &str) -> (u32, u32) {
        let found = self.0.iter().find(|rate| rate.0 == measure && rate.1 == kind);
        found.map(|rate| (rate.2, rate.3)).unwrap_or_else(|| panic!("no rate of {measure} in {kind}"))
    }

    /// Good ones of a hundred.
    fn share(&self, measure: &str, kind: &str) -> f64 {
        let (good, tried) = self.of(measure, kind);
        100.0 * f64::from(good) / f64::from(tried)
    }

    fn percent(&self, measure: &str, kind: &str) -> String {
        format!("{:.0}", self.share(measure, kind))
    }

    fn written(&self) -> String {
        let mut out = "# How often the program was right at the last first contact, by what was measured and the kind of text. Made from the \
             other records by tests/rates.rs; see README.md.\nmeasure,subject,good,tried\n"
            .to_owned();
        for (measure, kind, good, tried) in &self.0 {
            out += &format!("{measure},{kind},{good},{tried}\n");
        }
        out
    }
}

/// The contacts that count, without what was added later.
fn counted_contacts() -> Vec<&'static str> {
    CONTACTS.into_iter().filter(|contact| !contact.ends_with("later")).collect()
}

fn last_five() -> Vec<&'static str> {
    let contacts = counted_contacts();
    contacts[contacts.len() - 5..].to_vec()
}

/// The rates of the last contact, and beside them that of all flags of the last five.
fn told() -> Rates {
    let mut told = rates(&[LAST]);
    let (good, tried) = rates(&last_five()).of("flags", "all");
    let at = told.0.iter().position(|rate| rate.0 == "apart").expect("a rate of what stood apart");
    told.0.insert(at, ("five", "all".to_owned(), good, tried));
    told
}

/// The rates of some contacts together.
fn rates(contacts: &[&str]) -> Rates {
    let is_counted = |contact: &String| contacts.contains(&contact.as_str());
    let flags: Vec<Flag> = read(FLAGS);
    let (apart, flags): (Vec<Flag>, Vec<Flag>) =
        flags.into_iter().filter(|flag| is_counted(&flag.contact)).partition(Flag::is_apart);
    let real = |flag: &Flag| u32::from(flag.is_real());
    let on = |list: &'static str| flags.iter().filter(move |flag| flag.list == list);
    let mut rates = Rates::default();
    rates.add("flags", on("numbers").map(|flag| (flag.kind.clone(), real(flag), 1)));
    let first = on("numbers").filter(|flag| flag.repeats == "no");
    rates.add("faults", first.map(|flag| ("all".to_owned(), real(flag), 1)));
    rates.add("apart", apart.iter().map(|flag| ("all".to_owned(), real(flag), 1)));
    rates.add("statistics", on("statistics").map(|flag| ("all".to_owned(), real(flag), 1)));
    let hinted = flags.iter().filter(|flag| flag.is_real() && !flag.hint.is_empty());
    rates.add("hints", hinted.map(|flag| ("all".to_owned(), u32::from(flag.hint_right == "yes"), 1)));
    let reported: Vec<Reported> = read(REPORTED);
    let visible = reported.iter().filter(|of| is_counted(&of.contact) && of.visible == "yes");
    rates.add("reported", visible.map(|of| (of.kind.clone(), u32::from(of.seen == "yes"), 1)));
    let counted: Vec<Counted> = read(COUNTED);
    for measure in ["planted", "displayed"] {
        let of = counted.iter().filter(|of| is_counted(&of.contact) && of.measure == measure);
        rates.add(measure, of.map(|of| (of.kind.clone(), of.good, of.tried)));
    }
    rates
}

#[test]
fn the_rates_are_those_of_the_records() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("judged/rates.csv");
    let (written, now) = (std::fs::read_to_string(&path).unwrap_or_default(), told().written());
    if written != now {
        std::fs::write(&path, &now).expect("judged/rates.csv can be written");
    }
    assert_eq!(written, now, "judged/rates.csv is written anew; look at what has changed");
}

#[test]
fn the_readme_says_how_reliable_the_program_is() {
    let readme = README.split_whitespace().collect::<Vec<_>>().join(" ");
    let rates = told();
    let percent = |measure: &str, kind: &str| format!("{} %", rates.percent(measure, kind));
    let counted = |measure: &str| {
        let (good, tried) = rates.of(measure, "all");
        format!("{good} of {tried}")
    };
    for phrase in [
        format!("{} flags on numbers were real, {}", counted("flags"), percent("flags", "all")),
        format!("{} in mathematics", percent("flags", "mathematics")),
        format!("{} in physics and engineering", percent("flags", "physics and engineering")),
        format!("{} in statistics", percent("flags", "statistics")),
        format!("{} on the list of statistics", counted("statistics")),
        format!("{} that stood apart", counted("apart")),
        format!("{} in the last five contacts together, {}", counted("five"), percent("five", "all")),
        format!("{} hints", counted("hints")),
        format!("{} errors that others had reported", counted("reported")),
        format!("{} of planted digits", percent("planted", "all")),
        format!("{} of displayed equalities", percent("displayed", "all")),
    ] {
        assert!(readme.contains(&phrase), "{phrase}");
    }
}

#[test]
fn every_record_names_its_contact_and_judges_each_flag() {
    for flag in read::<Flag>(FLAGS) {
        assert!(CONTACTS.contains(&flag.contact.as_str()), "{}", flag.contact);
        assert!(["real", "rounding", "convention", "purpose", "misread"].contains(&flag.judgement.as_str()));
        assert!(["yes", "no"].contains(&flag.repeats.as_str()));
    }
}

/// Real flags on numbers and all of them.
type Count = (u32, u32);

/// The flags on numbers: the certain ones, those that are less certain by the share of their document alone, those that are less certain by
/// something else, and those that the program tells together with one above them in the record.
fn by_certainty(is_counted: impl Fn(&Flag) -> bool) -> [Count; 4] {
    let mut counts = [(0, 0); 4];
    let mut told = BTreeSet::new();
    for flag in read::<Flag>(FLAGS).iter().filter(|flag| flag.list == "numbers" && is_counted(flag)) {
        let caveat = flag.caveat();
        let document = (flag.contact.clone(), flag.text.clone(), flag.file.clone());
        let is_new = told.insert((document, chain_shape(&flag.chain), flag.hint.is_empty(), caveat.is_some()))
            || DRAWN_BY_SHAPE.contains(&flag.contact.as_str());
        let count = &mut counts[match caveat {
            _ if !is_new => 3,
            None => 0,
            Some(Caveat::Share { .. }) => 1,
            Some(_) => 2,
        }];
        *count = (count.0 + u32::from(flag.is_real()), count.1 + 1);
    }
    counts
}

#[test]
fn certain_flags_are_real_more_often_at_each_contact() {
    let record = include_str!("../judged/README.md");
    let of = |(real, all): Count| format!("{real} of {all}");
    let mut rows = String::new();
    for contact in CONTACTS {
        let counts = by_certainty(|flag| flag.contact == contact);
        rows += &format!("| {contact} | {} |\n", counts.map(of).join(" | "));
    }
    let all = by_certainty(|_| true);
    rows += &format!("| all | {} |\n", all.map(of).join(" | "));
    assert!(record.contains(&rows), "judged/README.md has other counts than\n{rows}");
    let readme = README.split_whitespace().collect::<Vec<_>>().join(" ");
    let [certain, share, other, again] = all;
    for count in [certain, (share.0 + other.0, share.1 + other.1), again].map(of) {
        assert!(readme.contains(&count), "{count}");
    }
    let rate = |(real, all): Count| f64::from(real) / f64::from(all);
    assert!(rate(certain) > 0.65 && [share, other, again].into_iter().all(|count| rate(count) < 0.5));
}

#[test]
fn the_record_tells_each_contact_beside_the_targets() {
    let record = include_str!("../judged/README.md");
    let mut rows = String::new();
    let row = |name: &str, contacts: &[&str]| {
        let rates = rates(contacts);
        format!("| {name} | {} |\n", TARGETED.map(|(measure, kind)| rates.percent(measure, kind)).join(" | "))
    };
    for contact in counted_contacts() {
        rows += &row(contact, &[contact]);
    }
    rows += &row("last five together", &last_five());
    let five: Vec<Rates> = last_five().into_iter().map(|contact| rates(&[contact])).collect();
    let range = TARGETED.map(|(measure, kind)| {
        let shares = || five.iter().map(|rates| rates.share(measure, kind));
        format!("{:.0} to {:.0}", shares().fold(100.0, f64::min), shares().fold(0.0, f64::max))
    });
    rows += &format!("| least to most of the five | {} |\n", range.join(" | "));
    assert!(record.contains(&rows), "judged/README.md has other shares than\n{rows}");
}

#[test]
fn a_list_is_on_by_default_if_half_of_its_flags_are_real() {
    let flags: Vec<Flag> = read(FLAGS);
    let counted = |contacts: &[&str]| {
        let those = flags.iter().filter(|flag| flag.list == "statistics" && contacts.contains(&flag.contact.as_str()));
        those.fold((0, 0), |(real, all): Count, flag| (real + u32::from(flag.is_real()), all + 1))
    };
    let (real, all) =
        counted(&["fifteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth", "twentieth", LAST]);
    let readme = README.split_whitespace().collect::<Vec<_>>().join(" ");
    let told = format!(
        "{real} of {all} in the last seven contacts ({} of {} in the last one)",
        counted(&[LAST]).0,
        counted(&[LAST]).1
    );
    assert!(readme.contains(&told), "{told}");
    let share = |(real, all): Count| f64::from(real) / f64::from(all);
    let help = format!("{real} of the {all} that this list found in new texts were real");
    assert!(include_str!("../src/cli/arguments.rs").contains(&help), "{help}");
    for count in [(real, all), counted(&CONTACTS)] {
        assert!((0.5..0.67).contains(&share(count)), "{count:?}");
    }
}
