//! Each kind of finding, each with the change that brings it about.

use crate::Project;
use geneva_values::{FindingKind, RecordRequest};

const TEXT: &str = "# 1 Results\n\nThe small period is 2.006 s (see Fig. 3), measured in May 2024 with version 1.2.3.\n\nThe \
    width of the slot is 3.2 mm, and the share of losses is 12.3 %.\n\nA sample of 1,234 swings was taken.\n";
const VALUES: &str =
    r#"{"period": 2.00641, "slot": {"width": "3.2 mm"}, "losses": 0.12345, "swings": 1234, "spare": 77.7}"#;

fn recorded() -> Project {
    let project = Project::new("paper.md", TEXT, VALUES);
    let report = project.record();
    assert!(report.is_changed && report.missing.is_empty());
    project
}

#[test]
fn what_agrees_is_right_and_its_neighbours_are_refused() {
    let project = recorded();
    assert_eq!(project.differing(), Vec::<String>::new());
    let report = project.check();
    assert_eq!((report.count(FindingKind::Right), report.count(FindingKind::NoValue)), (4, 4));
    assert!(report.findings.iter().all(|finding| finding.neighbours_passed == 0));
    assert_eq!(report.unused, ["spare"]);
    let record = project.read("numbers.toml");
    assert!(record.contains("value = \"losses\"\nfactor = \"100\""), "{record}");
    assert!(record.contains("before = \"The small period is\"\nprinted = \"2.006\"\nunit = \"s\""), "{record}");
}

#[test]
fn each_difference_has_its_kind() {
    for (from, to, expected) in [
        ("2.006", "2.007", "last-digit 2.007"),
        ("2.006", "2.06", "stale 2.06"),
        ("2.006", "2.060", "stale 2.060"),
        ("2.006 s", "2006 s", "unit-or-scale 2006"),
        ("3.2 mm", "3.2 cm", "unit-or-scale 3.2"),
        ("3.2 mm", "3.2 s", "unit-or-scale 3.2"),
        ("12.3 %", "0.1 %", "stale 0.1"),
        ("1,234", "1,235", "last-digit 1,235"),
        ("1,234", "−1,234", "unit-or-scale -1,234"),
        ("May 2024", "May 2025", "changed 2025"),
        ("was taken", "was taken, and 55.5 more", "untied 55.5"),
        ("A sample of 1,234 swings was taken.", "", "missing 1,234"),
    ] {
        let project = recorded();
        project.change("paper.md", from, to);
        assert_eq!(project.differing(), [expected], "{from} to {to}");
        assert!(!project.check().is_right());
    }
    // A figure may be numbered anew.
    let project = recorded();
    project.change("paper.md", "Fig. 3", "Fig. 4");
    assert_eq!(project.differing(), Vec::<String>::new());
}

#[test]
fn a_value_that_moves_is_told_with_what_to_write() {
    let project = recorded();
    project.change("values.json", "2.00641", "2.10399");
    let report = project.check();
    let stale = report.findings.iter().find(|finding| finding.kind == FindingKind::Stale).expect("a finding");
    assert_eq!(stale.write.as_deref(), Some("2.104"));
    assert_eq!(stale.message, "printed 2.006 s, period is 2.10399 now; write 2.104 s");
    let place = stale.at.map(|[start, _]| (start.line, start.column));
    assert_eq!(place, Some((3, 21)));
}

#[test]
fn a_key_that_is_gone_is_told_with_the_nearest() {
    let project = recorded();
    project.change("values.json", "\"period\"", "\"periods\"");
    let report = project.check();
    let lost = report.findings.iter().find(|finding| finding.kind == FindingKind::UnknownKey).expect("a finding");
    assert!(lost.message.ends_with("the nearest key is periods"), "{}", lost.message);
}

#[test]
fn a_value_half_way_passes_with_its_neighbour_which_is_told() {
    let project = Project::new("a.txt", "The ratio is 0.13 here.", r#"{"ratio": 0.125}"#);
    project.record();
    let report = project.check();
    assert!(report.is_right());
    assert_eq!(report.findings[0].neighbours_passed, 1);
    let said = geneva_values::check_text(&report, Default::default());
    assert!(said.contains("so would be its neighbour") && said.contains("refused its neighbours: 0 of 1"), "{said}");
}

#[test]
fn what_nobody_has_decided_is_not_right() {
    let project = Project::new(
        "a.txt",
        "The ratio is 0.125, the rate 4.56 and the width 9.87 mm.",
        r#"{"a": 0.125, "b": 0.1251}"#,
    );
    let report = project.record();
    assert_eq!((report.ties.get("candidates"), report.ties.get("open")), (Some(&1), Some(&2)));
    assert_eq!(project.differing(), ["undecided 0.125", "undecided 4.56", "undecided 9.87"]);
}

#[test]
fn digits_that_fit_by_chance_are_not_proposed() {
    let project = Project::new("a.txt", "There are 3 pins and 17 slots.", r#"{"a": 3.04, "slots": 17}"#);
    let report = project.record();
    assert_eq!((report.ties.get("value"), report.ties.get("open")), (Some(&1), Some(&1)));
}

#[test]
fn recording_twice_changes_nothing_and_keeps_what_people_write() {
    let project = recorded();
    let first = project.read("numbers.toml");
    assert!(!project.record().is_changed);
    assert_eq!(project.read("numbers.toml"), first);
    project.change("numbers.toml", "value = \"period\"", "value = 'spare' # ours");
    project.change("numbers.toml", "none = \"date\"", "none = \"quoted from the diary\"");
    project.change("paper.md", "2.006", "2.016");
    project.write("paper.md", &format!("New: 77.7 of 5.55.\n\n{}", project.text()));
    let report = project.record();
    assert_eq!((report.added, report.moved), (2, 1));
    let record = project.read("numbers.toml");
    assert!(record.contains("value = 'spare' # ours") && record.contains("printed = \"2.016\""), "{record}");
    assert!(record.contains("none = \"quoted from the diary\""));
    assert!(!project.record().is_changed);
}

#[test]
fn entries_whose_numbers_are_gone_are_kept_until_pruned() {
    let project = recorded();
    project.change("paper.md", "A sample of 1,234 swings was taken.\n", "");
    let report = project.record();
    assert_eq!(report.missing.len(), 1);
    assert!(project.read("numbers.toml").contains("1,234"));
    let pruned = project.record_with(RecordRequest { prune: true, ..RecordRequest::default() }).expect("a record");
    assert_eq!(pruned.missing.len(), 1);
    assert!(!project.read("numbers.toml").contains("1,234"));
    assert_eq!(project.differing(), Vec::<String>::new());
}

#[test]
fn ties_that_may_be_by_chance_are_told() {
    let values = |count: usize| {
        let mut rng = fastrand::Rng::with_seed(7);
        let all: Vec<String> =
            (0..count).map(|at| format!("\"k{at}\": {}.{:06}", rng.u32(0..100), rng.u32(0..999_999))).collect();
        format!("{{{}}}", all.join(", "))
    };
    let mut rng = fastrand::Rng::with_seed(8);
    let text: String =
        (0..400).map(|at| format!("Word{at} number is {}.{:02} here.\n\n", rng.u32(0..100), rng.u32(0..99))).collect();
    // None of the numbers has to do with a value.
    for count in [20, 500, 2_000] {
        let report = Project::new("a.md", &text, &values(count)).record();
        let tied = report.ties.get("value").copied().unwrap_or_default() as f64;
        assert!(
            (report.by_chance - tied).abs() <= 3.0 + tied / 3.0,
            "{count} values: {tied} tied, told {}",
            report.by_chance
        );
    }
    let few = Project::new("a.md", "The width is 4.57 mm.\n", r#"{"width": 4.5678, "height": 7.1}"#);
    assert_eq!(few.record().by_chance, 0.0);
    assert!(!few.read("numbers.toml").contains("by chance"));
}
