//! Which differences are less certain and stand apart, which stay listed all the same, and what is told once.

use proofread::{Caveat, ChainFinding, CheckOptions, ReportSection, TextFormat, group_findings, proofread};

fn found(text: &str) -> Vec<ChainFinding> {
    proofread(text, TextFormat::Markdown, CheckOptions::default()).expect("a short text").findings
}

/// A document with these chains, each in a sentence of its own, and so many others that agree.
fn document(chains: &[&str], agreeing: usize) -> String {
    let right = (1..=agreeing).map(|n| format!("{n}4 + {n}3 = {}", 20 * n + 7));
    chains.iter().map(|of| (*of).to_owned()).chain(right).map(|of| format!("It is ${of}$.\n\n")).collect()
}

/// The list and the caveat of each difference.
fn lists(text: &str) -> Vec<(ReportSection, Option<Caveat>)> {
    found(text).iter().map(|of| (of.section, of.caveat)).collect()
}

/// What makes a chain less certain in a document in which the others agree.
fn caveat(chain: &str) -> Option<Caveat> {
    let all = lists(&document(&[chain], 9));
    let [(list, caveat)] = all.as_slice() else { panic!("{chain}: {all:?}") };
    assert_eq!(*list == ReportSection::LessCertain, caveat.is_some(), "{chain}");
    *caveat
}

const LISTED: (ReportSection, Option<Caveat>) = (ReportSection::Numbers, None);

#[test]
fn what_a_newcomer_writes_first_is_listed() {
    for chain in [
        "2 + 2 = 5",
        "3^2 = 8",
        r"2\,\mathrm{m} + 2\,\mathrm{m} = 5\,\mathrm{m}",
        r"x = 2 \cdot 4 = 9",
        r"\sqrt{9} = 4",
    ] {
        assert_eq!(lists(&format!("${chain}$")), [LISTED], "{chain}");
    }
}

#[test]
fn each_cause_is_told_beside_a_chain_without_it() {
    for (without, with, cause) in [
        (r"2 \cdot 4\,\mu\mathrm{s} = 10\,\mathrm{mm}", r"4\,\mu\mathrm{s} = 10\,\mathrm{mm}", Caveat::Uncomputed),
        (r"f(1) = 2 + 2 = 5", r"\binom{4}{2} = 5", Caveat::Short),
        (
            r"\frac{2.1512 \cdot 3.7812}{1.9231} + 1.5123^2 = 6.7213",
            r"\frac{2.1512 \cdot 3.7812}{1.9231} + 1.5123^2 = 6.5213",
            Caveat::Slight,
        ),
    ] {
        assert_eq!((caveat(without), caveat(with)), (None, Some(cause)), "{with}");
    }
    // What is in the row before is no part of the chain that is shown.
    let rows = |result: &str| {
        format!("$$\\begin{{aligned}} v_2 &= 3.5 \\cdot 4.25 \\\\ v_2 &= {result} \\end{{aligned}}$$\n\n")
    };
    assert_eq!(lists(&(rows("63.1") + &document(&[], 9))), [LISTED]);
    // One edit that stands out as the slip makes up for each of them.
    assert_eq!(caveat(r"\tan 31.0^\circ = 0.609"), None);
}

#[test]
fn where_a_third_of_a_document_differs_the_first_is_listed_with_the_share() {
    let wrong = ["34.25 + 58.11 = 71.06", r"34.25 \cdot 58.11 = 71.06", r"71.06/34.25 = 58.11"];
    let share = |pairs| Some(Caveat::Share { differing: 3, pairs });
    let [first, other] = [ReportSection::Numbers, ReportSection::LessCertain];
    for agreeing in [0, 6] {
        let pairs = 3 + agreeing;
        let all = lists(&document(&wrong, agreeing));
        assert_eq!(all, [(first, share(pairs)), (other, share(pairs)), (other, share(pairs))], "{agreeing}");
    }
    assert_eq!(lists(&document(&wrong, 7)), [LISTED; 3]);
    assert_eq!(lists(&document(&wrong[..1], 0)), [LISTED]);
    // Another cause is told instead, and one edit that stands out is certain here, too.
    let all = lists(&document(&[wrong[0], r"4\,\mu\mathrm{s} = 10\,\mathrm{mm}", r"\tan 31.0^\circ = 0.609"], 0));
    assert_eq!(all, [(first, share(3)), (other, Some(Caveat::Uncomputed)), LISTED]);
}

#[test]
fn a_document_in_which_everything_is_wrong_is_not_clean() {
    let sums: Vec<String> = (1..=12).map(|n| format!("{n} + {n} = {}", 2 * n + 1)).collect();
    let sums: Vec<&str> = sums.iter().map(String::as_str).collect();
    let all = found(&document(&sums, 0));
    assert!(all.iter().all(|of| of.section == ReportSection::Numbers), "{all:#?}");
    let places: usize = group_findings(all).iter().map(proofread::FindingGroup::place_count).sum();
    assert_eq!(places, 12);
    // Not even if each of them is less certain by itself.
    let all = lists(&document(&[r"4\,\mu\mathrm{s} = 10\,\mathrm{mm}", r"|3| = 4"], 0));
    let share = Some(Caveat::Share { differing: 2, pairs: 2 });
    assert_eq!(all, [(ReportSection::Numbers, share), (ReportSection::LessCertain, Some(Caveat::Uncomputed))]);
}

/// A run of the command on a file with a text, with these options; its exit code and what it says.
#[cfg(feature = "cli")]
fn told(file: &std::path::Path, text: &str, options: &[&str]) -> (u8, String) {
    std::fs::write(file, text).expect("written");
    let (code, out, told) = crate::command::run(&[options, &[file.to_str().expect("UTF-8")]].concat());
    (code, out + &told)
}

#[test]
#[cfg(feature = "cli")]
fn what_is_less_certain_is_counted_and_listed_on_request() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.md");
    let right = "$2 + 2 = 4$";
    let (code, out) = told(&file, &format!("{right} and $|3| = 4$.\n"), &[]);
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("Nothing found.\n1 less certain difference; --less-certain lists them.\n"), "{out}");
    let (code, out) = told(&file, &format!("{right} and $|3| = 4$.\n"), &["--less-certain"]);
    assert_eq!(code, 1, "{out}");
    assert!(out.contains("1 finding: 1 less certain.\n") && out.contains("  = less certain: neither side"), "{out}");
    assert!(!out.contains("lists them"), "{out}");
    let (code, out) = told(&file, "$2 + 2 = 5$\n\n$7 + 2 = 5$\n\n$43.25/2 = 38.17$\n", &[]);
    assert_eq!(code, 1, "{out}");
    let words = out.split_whitespace().collect::<Vec<_>>().join(" ");
    for said in [
        "= note: 3 of 3 pairs of this document differ, which is mostly a notation that is not known here; --less-certain lists the others",
        "= also: at 1 more place of the same shape: line 3",
        "1 finding at 2 places: 1 on a number. 1 less certain difference; --less-certain lists them.",
    ] {
        assert!(words.contains(said), "{said}\n{out}");
    }
}

#[test]
#[cfg(feature = "cli")]
fn a_new_place_is_told_where_others_of_its_shape_are_accepted_or_old() {
    let folder = tempfile::tempdir().expect("a folder");
    let (file, cases) = (folder.path().join("a.md"), folder.path().join("accepted.jsonl"));
    let cases = cases.to_str().expect("UTF-8");
    let text = "$2 + 2 = 5$\n\n$7 + 2 = 5$\n\n$43.25/2 = 38.17$\n";
    let old = |out: &str| out.contains("3 cases left out as accepted.");
    assert_eq!(told(&file, text, &["--accept", cases]), (0, format!("3 cases accepted in {cases}\n")));
    let (code, out) = told(&file, text, &["--baseline", cases]);
    assert!(code == 0 && old(&out) && out.contains("Nothing found."), "{out}");
    // Although the share of the document makes it less certain: it is the first one that is new.
    for new in ["$8 + 2 = 5$", "$1.5^2 + 2 = 7.8$"] {
        let (code, out) = told(&file, &format!("{text}\n{new}\n"), &["--baseline", cases]);
        assert!(code == 1 && old(&out) && out.contains("1 finding: 1 on a number."), "{out}");
        assert!(out.contains("a.md:7:"), "{out}");
    }
    if !crate::command::git(folder.path(), &["init", "-q"]) {
        println!("skipped: there is no git here");
        return;
    }
    told(&file, text, &[]);
    assert!(crate::command::git(folder.path(), &["add", "."]));
    assert!(crate::command::git(folder.path(), &["commit", "-q", "-m", "first"]));
    let (code, out) = told(&file, &format!("{text}\n$8 + 2 = 5$\n"), &["--since", "HEAD"]);
    assert!(code == 1 && out.contains("1 finding: 1 on a number.") && out.contains("a.md:7:"), "{out}");
    // What was less certain before is nothing new when more pairs agree.
    let right = (1..=9).map(|n| format!("$1{n} + 3 = {}$\n\n", 13 + n)).collect::<String>();
    let (code, out) = told(&file, &format!("{text}\n{right}"), &["--since", "HEAD"]);
    assert!(code == 0 && out.contains("Nothing found."), "{out}");
}

#[test]
fn differences_of_one_shape_are_told_once() {
    let groups = |chains: &[&str]| -> Vec<Vec<String>> {
        let groups = group_findings(found(&document(chains, 30)));
        groups.iter().map(|group| group.places().map(|of| of.printed.clone()).collect()).collect()
    };
    let same = ["34.25 + 58.11 = 71.06", "1.5 + 2.25 = 8.06", "105 + 317 = 981"];
    assert_eq!(groups(&same), [["71.06", "8.06", "981"]]);
    for other in [
        "34.25 - 58.11 = 71.06",
        r"\sqrt{34.25} + 58.11 = 71.06",
        "34.25 + 58.11 = 71.06 + 3",
        r"34.25\,\mathrm{m} + 58.11\,\mathrm{m} = 71.06\,\mathrm{m}",
    ] {
        assert_eq!(groups(&[same[0], other, same[1]]).len(), 2, "{other}");
    }
    // A hint of another kind, or one where there is none beside it, is told by itself.
    assert_eq!(groups(&[r"\tan 31.0^\circ = 0.609", r"\tan 31.0^\circ = 0.235"]).len(), 2);
}
