//! Nothing that a file contains stops the program, and no file takes long.

use crate::Project;
use fastrand::Rng;
use geneva_values::{NumberedText, Record, Values};
use proofread::TextFormat;

const PIECES: [&str; 60] = [
    "1",
    "2.5",
    "−3",
    "1,234",
    "1{,}234",
    "e5",
    "\\times10^{",
    "}",
    "{",
    "[",
    "]",
    "(",
    ")",
    "^",
    "_",
    "\\",
    "\\SI{",
    "}{",
    "%",
    "\\%",
    "$",
    "$$",
    "\\[",
    "\n",
    "\n\n",
    " ",
    "mm",
    "m/s^2",
    "s⁻¹",
    "°",
    "Fig. ",
    "Eq. (",
    "2024-05-17",
    "1.2.3",
    "4th",
    "<p>",
    "</p>",
    "<!--",
    "-->",
    "<",
    ">",
    "&nbsp;",
    "&#55;",
    "<sup>",
    "```",
    "`",
    "](",
    "~~",
    "é",
    "表",
    "\u{1d7d9}",
    "\u{301}",
    "'",
    "\"",
    "\\begin{verbatim}",
    "\\end{document}",
    "\\newcommand",
    "\\frac{",
    "/",
    ".",
];

#[test]
fn no_text_stops_the_reader() {
    let mut rng = Rng::with_seed(7);
    for round in 0..3000 {
        let text: String = (0..rng.usize(..40)).map(|_| PIECES[rng.usize(..PIECES.len())]).collect();
        for (_, format) in TextFormat::ALL {
            let Ok(numbered) = NumberedText::read(&text, format) else { continue };
            for number in &numbered.numbers {
                let range = number.span.range();
                assert!(text.get(range.clone()).is_some(), "round {round}: {range:?} of {text:?}");
            }
        }
    }
}

#[test]
fn no_values_or_record_stop_the_reader() {
    const PARTS: [&str; 30] = [
        "{",
        "}",
        "[",
        "]",
        "\"a\"",
        ":",
        ",",
        "1",
        "-",
        "1e400",
        "1e-1000",
        "1e99999999999",
        "NaN",
        "Infinity",
        "\"3 mm\"",
        "\"value\"",
        "\"unit\"",
        "null",
        "\n",
        " ",
        "a",
        "=",
        "[[number]]\n",
        "texts = [\"a\"]\n",
        "values = [\"b\"]\n",
        "'",
        "é",
        "name,value\n",
        "x,1\n",
        "#",
    ];
    let mut rng = Rng::with_seed(8);
    for _ in 0..5000 {
        let text: String = (0..rng.usize(..20)).map(|_| PARTS[rng.usize(..PARTS.len())]).collect();
        for name in ["v.json", "v.csv", "v.toml"] {
            let _ = Values::default().add(name, &text);
        }
        let _ = Record::parse(&text);
    }
}

/// A text of `count` numbers that all differ, and its values.
fn large(count: usize) -> Project {
    let mut rng = Rng::with_seed(9);
    let (mut text, mut values) = (String::new(), Vec::new());
    for at in 0..count {
        let number = 10.0 + at as f64 / 7.0;
        let filler: String = (0..30).map(|_| ["time ", "rod ", "long ", "mass "][rng.usize(..4)]).collect();
        text += &format!("The number {filler}is {number:.5} in this place. ");
        if at % 5 == 0 {
            text += "\n\n";
        }
        values.push(format!("\"k{at}\": {number:.9}"));
    }
    Project::new("a.md", &text, &format!("{{{}}}", values.join(",")))
}

#[test]
fn each_number_is_compared_with_few_values() {
    for count in [400, 1600] {
        let project = large(count);
        let report = project.record();
        assert_eq!(report.ties.get("value"), Some(&count));
        assert!(report.compared < 2 * count, "{} comparisons of {count} numbers", report.compared);
        assert_eq!(project.right(), count);
    }
}

#[test]
fn among_values_that_are_all_the_same_few_are_compared() {
    let text = "it is 1.25 s ".repeat(3000);
    let values: Vec<String> = (0..3000).map(|at| format!("\"k{at}\": 1.25")).collect();
    let project = Project::new("a.md", &text, &format!("{{{}}}", values.join(",")));
    let report = project.record();
    assert_eq!(report.ties.get("candidates"), Some(&3000));
    assert!(report.compared <= 64 * 3000, "{}", report.compared);
    assert!(!project.record().is_changed);
}
