//! Thirty chains of ours that pdflatex has set and pdftotext has turned into lines: inline and displayed, with fractions, powers,
//! roots, units and tables, once with right results and once with wrong ones.

use proofread::{CheckOptions, ReportSection, TextFormat, proofread};

const RIGHT: [&str; 2] = [include_str!("texts/page-right.txt"), include_str!("texts/page-right-layout.txt")];
const WRONG: [&str; 2] = [include_str!("texts/page-wrong.txt"), include_str!("texts/page-wrong-layout.txt")];

/// The right sides of what is listed as wrong, or would be if less of the page were.
fn listed(text: &str, format: TextFormat) -> Vec<String> {
    let findings = proofread(text, format, CheckOptions::default()).expect("a text").findings;
    findings
        .into_iter()
        .filter(|of| matches!(of.section, ReportSection::Numbers | ReportSection::LessCertain))
        .map(|of| of.right)
        .collect()
}

/// How many pairs differ, with those that are set aside.
fn different(text: &str, format: TextFormat) -> usize {
    proofread(text, format, CheckOptions::default()).expect("a text").findings.len()
}

#[test]
fn nothing_right_is_listed_of_a_page_and_what_stays_on_its_line_is_checked() {
    for ((right, wrong), listed_wrong) in RIGHT.into_iter().zip(WRONG).zip([21, 20]) {
        assert_eq!(listed(right, TextFormat::Plain), [""; 0]);
        let found = listed(wrong, TextFormat::Plain);
        for result in ["13.8", "418", "3.5", "19", "0.609", "38.5 %", "14 m", "12 m/s", "21.12", "44", "18"] {
            assert!(found.iter().any(|of| of == result), "{result}: {found:?}");
        }
        assert_eq!(found.len(), listed_wrong, "{found:#?}");
    }
}

#[test]
fn marks_that_a_page_has_lost_are_put_back_only_in_plain_lines_and_where_they_fit() {
    for (text, right, wrong) in [
        ("The area 2.52 = RESULT is printed.", "6.25", "6.35"),
        ("A chain 34 − 1 = RESULT here.", "80", "82"),
        ("It is 1.53 + 22 = RESULT here.", "7.375", "7.735"),
        ("√\n\nA length 625 = RESULT here.", "25", "35"),
        ("√\n3\n\nA length 2744 = RESULT here.", "14", "24"),
        ("p\n32 + 42 = RESULT\n", "5", "6"),
    ] {
        assert_eq!(different(&text.replace("RESULT", right), TextFormat::Plain), 0, "{text}");
        assert_eq!(different(&text.replace("RESULT", right), TextFormat::Markdown), 1, "{text}");
        assert_eq!(different(&text.replace("RESULT", wrong), TextFormat::Plain), 1, "{text}");
    }
    // Without its sign nothing is a root.
    assert_eq!(different("A length 625 = 25 here.", TextFormat::Plain), 1);
}
