//! Places survive edits of the text, and every planted change is noticed.

use crate::Project;
use fastrand::Rng;
use std::fmt::Write;

const WORDS: [&str; 24] = [
    "the", "period", "of", "a", "long", "swing", "is", "at", "most", "with", "drag", "and", "no", "spring", "which",
    "we", "measured", "for", "each", "rod", "in", "water", "oil", "air",
];

/// Paragraphs with numbers, and their values.
fn project(rng: &mut Rng, paragraphs: usize) -> Project {
    let (mut text, mut values) = (String::new(), String::from("{"));
    for paragraph in 0..paragraphs {
        for sentence in 0..rng.usize(2..5) {
            for word in 0..rng.usize(4..12) {
                let _ = write!(text, "{}{}", if word == 0 { "" } else { " " }, WORDS[rng.usize(..WORDS.len())]);
            }
            let number = rng.u32(100_000..999_999);
            let _ = write!(text, " {}.{:03} s here. ", number / 1000, number % 1000);
            let comma = if values.len() > 1 { "," } else { "" };
            let _ = write!(values, "{comma}\"k{paragraph}.{sentence}\": {}.{:03}2", number / 1000, number % 1000);
        }
        text += "\n\n";
    }
    // The same number twice has two candidates: the seed is one of those without.
    let project = Project::new("a.md", &text, &(values + "}"));
    let report = project.record();
    assert_eq!(report.ties.get("value"), Some(&report.numbers), "{:?}", report.ties);
    project
}

#[test]
fn planted_changes_in_two_hundred_places_are_all_noticed() {
    let mut rng = Rng::with_seed(1);
    let project = project(&mut rng, 60);
    let text = project.text();
    let digits: Vec<usize> = text.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(at, _)| at).collect();
    for _ in 0..200 {
        let at = digits[rng.usize(..digits.len())];
        let old = text.as_bytes()[at];
        let new = b'0' + (old - b'0' + rng.u8(1..10)) % 10;
        let changed = format!("{}{}{}", &text[..at], char::from(new), &text[at + 1..]);
        project.write("a.md", &changed);
        let differing = project.differing();
        assert_eq!(differing.len(), 1, "{differing:?} in {}", &changed[at.saturating_sub(60)..at + 20]);
    }
}

#[test]
fn edits_of_the_words_keep_all_places() {
    for seed in 0..12 {
        let mut rng = Rng::with_seed(seed);
        let project = project(&mut rng, 12);
        let text = project.text();
        let all = project.right();
        let mut paragraphs: Vec<String> =
            text.split("\n\n").filter(|text| !text.is_empty()).map(str::to_owned).collect();
        // Sentences come in.
        for paragraph in &mut paragraphs {
            let sentences: Vec<&str> = paragraph.split_inclusive(". ").collect();
            let at = rng.usize(..=sentences.len());
            let (before, after) = sentences.split_at(at);
            *paragraph = format!("{}A new sentence came in. {}", before.concat(), after.concat());
        }
        project.write("a.md", &paragraphs.join("\n\n"));
        assert_eq!((project.right(), project.differing()), (all, Vec::new()), "seed {seed}");
        // Paragraphs move.
        rng.shuffle(&mut paragraphs);
        project.write("a.md", &paragraphs.join("\n\n"));
        assert_eq!((project.right(), project.differing()), (all, Vec::new()), "seed {seed}");
        // Lines are wrapped anew.
        let wrapped: Vec<String> = paragraphs
            .iter()
            .map(|text| {
                text.split(' ')
                    .enumerate()
                    .map(|(at, word)| format!("{word}{}", if at % 5 == 4 { "\n" } else { " " }))
                    .collect()
            })
            .collect();
        project.write("a.md", &wrapped.join("\n\n"));
        assert_eq!((project.right(), project.differing()), (all, Vec::new()), "seed {seed}");
        project.record();
        assert!(!project.record().is_changed, "seed {seed}");
        assert_eq!((project.right(), project.differing()), (all, Vec::new()), "seed {seed}");
    }
}

#[test]
fn among_the_same_words_the_order_decides() {
    let text = "| a | b |\n|---|---|\n| it is 1.25 s | it is 2.25 s |\n| it is 3.25 s | it is 4.25 s |\n";
    let values = r#"{"a": 1.25, "b": 2.25, "c": 3.25, "d": 4.25}"#;
    let project = Project::new("a.md", text, values);
    project.record();
    assert_eq!(project.right(), 4);
    project.change("a.md", "3.25", "3.75");
    assert_eq!(project.differing(), ["stale 3.75"]);
    // A row comes in, and the others keep their entries.
    project.write("a.md", &text.replace("| it is 3", "| it is 7.25 s | it is 8.25 s |\n| it is 3"));
    assert_eq!(project.differing(), ["untied 7.25", "untied 8.25"]);
}

#[test]
fn a_number_that_is_changed_and_moved_is_reported_once() {
    let project = Project::new(
        "a.md",
        "First we found a width of 3.25 mm in oil.\n\nThen we found a length of 7.75 mm in water.\n",
        r#"{"width": "3.25 mm", "length": "7.75 mm"}"#,
    );
    project.record();
    project.write("a.md", "Then we found a length of 7.75 mm in water.\n\nFirst we found a width of 3.35 mm in oil.\n");
    assert_eq!(project.differing(), ["stale 3.35"]);
}

#[test]
fn a_row_that_comes_into_a_table_of_numbers_moves_no_other() {
    let row = |number: u32| format!("| {number} | {}.{number}7 | 0.{number}{number} |\n", number % 7);
    let table = |rows: &[u32]| {
        format!("Angles:\n\n| a | b | c |\n|---|---|---|\n{}", rows.iter().map(|at| row(*at)).collect::<String>())
    };
    let value = |number: u32| {
        format!("\"a{number}\": {number}, \"b{number}\": {}.{number}7, \"c{number}\": 0.{number}{number}", number % 7)
    };
    let rows = [20, 31, 42, 53, 64, 75];
    let values: Vec<String> = rows.iter().map(|at| value(*at)).collect();
    let project = Project::new("a.md", &table(&rows), &format!("{{{}}}", values.join(", ")));
    project.record();
    assert_eq!(project.right(), 18, "{}", project.read("numbers.toml"));
    for at in 0..=rows.len() {
        let mut more = rows.to_vec();
        more.insert(at, 18);
        project.write("a.md", &table(&more));
        assert_eq!(project.differing(), ["untied 18", "untied 4.187", "untied 0.1818"], "row {at}");
        let mut fewer = rows.to_vec();
        fewer.remove(at.min(5));
        project.write("a.md", &table(&fewer));
        let differing = project.differing();
        assert!(
            differing.len() == 3 && differing.iter().all(|of| of.starts_with("missing")),
            "row {at}: {differing:?}"
        );
    }
    // A cell that changes is one change.
    for (cell, changed) in [("| 42 |", "| 43 |"), ("0.427", "0.437"), ("0.4242", "0.4342")] {
        project.write("a.md", &table(&rows).replacen(cell, changed, 1));
        assert_eq!(project.differing().len(), 1, "{cell}");
    }
}

/// A table with a row of numbers for each name, in every format that has tables.
fn tables(rows: &[(&str, [String; 3])]) -> [(&'static str, String); 4] {
    let cells = |name: &str, numbers: &[String; 3], between: &str| {
        let first = if name.is_empty() { String::new() } else { format!("{name}{between}") };
        format!("{first}{}", numbers.join(between))
    };
    let all = |open: &str, between: &str, close: &str| -> String {
        rows.iter().map(|(name, numbers)| format!("{open}{}{close}\n", cells(name, numbers, between))).collect()
    };
    [
        ("a.md", format!("| a | b | c | d |\n|---|---|---|---|\n{}", all("| ", " | ", " |"))),
        ("a.tex", format!("\\begin{{tabular}}{{rrr}}\n{}\\end{{tabular}}\n", all("", " & ", " \\\\"))),
        ("a.html", format!("<table>\n{}</table>\n", all("<tr><td>", "</td><td>", "</td></tr>"))),
        ("a.txt", all("", "  ", "")),
    ]
}

/// Rows with numbers of two, three and four digits, and their values.
fn rows(names: [&'static str; 5]) -> (Vec<(&'static str, [String; 3])>, String) {
    let number =
        |row: usize, column: usize| format!("{}.{}{}", 3 + 7 * row + column, 1 + (row * 3 + column) % 9, 2 + column);
    let rows: Vec<(&str, [String; 3])> =
        names.into_iter().enumerate().map(|(row, name)| (name, [0, 1, 2].map(|column| number(row, column)))).collect();
    let values: Vec<String> = rows
        .iter()
        .enumerate()
        .flat_map(|(row, (_, numbers))| {
            numbers.iter().enumerate().map(move |(at, of)| format!("\"k{row}.{at}\": {of}"))
        })
        .collect();
    (rows, format!("{{{}}}", values.join(", ")))
}

#[test]
fn numbers_that_change_places_in_a_table_are_found() {
    for names in [["oil", "water", "air", "steel", "ice"], [""; 5]] {
        let (rows, values) = rows(names);
        for (format, (name, text)) in tables(&rows).into_iter().enumerate() {
            let project = Project::new(name, &text, &values);
            project.record();
            assert_eq!(project.right(), 15, "{text}");
            let record = project.read("numbers.toml");
            for one in 0..15 {
                for other in one + 1..15 {
                    let mut changed = rows.clone();
                    let kept = changed[one / 3].1[one % 3].clone();
                    changed[one / 3].1[one % 3] = std::mem::replace(&mut changed[other / 3].1[other % 3], kept);
                    project.write(name, &tables(&changed)[format].1);
                    let differing = project.differing();
                    assert!(!differing.is_empty(), "{one} and {other} in {}", tables(&changed)[format].1);
                    if other == one + 1 {
                        // What is recorded anew keeps the values of their places.
                        project.record();
                        assert!(!project.differing().is_empty(), "{one} recorded: {}", project.read("numbers.toml"));
                        project.write("numbers.toml", &record);
                    }
                    project.write(name, &text);
                }
            }
        }
    }
}

#[test]
fn rows_that_move_as_a_whole_are_followed() {
    for names in [["oil", "water", "air", "steel", "ice"], [""; 5]] {
        let (rows, values) = rows(names);
        for (format, (name, text)) in tables(&rows).into_iter().enumerate() {
            let project = Project::new(name, &text, &values);
            project.record();
            for from in 0..5 {
                for to in 0..5 {
                    let mut moved = rows.clone();
                    let row = moved.remove(from);
                    moved.insert(to, row);
                    project.write(name, &tables(&moved)[format].1);
                    assert_eq!((project.right(), project.differing()), (15, Vec::new()), "{from} to {to} in {name}");
                }
            }
        }
    }
}

/// The example paper as a project, and the numbers of it that are tied to values, each with its first byte.
fn example_paper() -> (Project, String, Vec<(usize, geneva_values::NumberFinding)>) {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/paper");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("a file of the example");
    let paper = read("paper.tex");
    let project = Project::new("paper.tex", &paper, &read("values.json"));
    project.write("second.json", &read("second.json"));
    project.write("numbers.toml", &read("numbers.toml"));
    let start = |finding: &geneva_values::NumberFinding| {
        let at = finding.at.expect("a place")[0];
        paper.split_inclusive('\n').take(at.line - 1).map(str::len).sum::<usize>() + at.column - 1
    };
    let tied = project.check().findings.into_iter().filter(|finding| finding.key.is_some());
    let tied = tied.map(|finding| (start(&finding), finding)).collect();
    (project, paper, tied)
}

#[test]
fn every_other_digit_in_the_example_paper_is_found() {
    let (project, paper, tied) = example_paper();
    let mut tried = 0;
    for (start, number) in tied {
        for at in (start..start + number.printed.len()).filter(|at| paper.as_bytes()[*at].is_ascii_digit()) {
            for digit in ('0'..='9').filter(|digit| !paper[at..].starts_with(*digit)) {
                project.write("paper.tex", &format!("{}{digit}{}", &paper[..at], &paper[at + 1..]));
                assert!(!project.differing().is_empty(), "{digit} at {at}, in {}", number.printed);
                tried += 1;
            }
        }
    }
    assert!(tried >= 400, "only {tried} digits");
}

#[test]
fn numbers_that_change_places_in_the_example_paper_are_found() {
    let (project, paper, tied) = example_paper();
    let mut tried = 0;
    for (at, (first, one)) in tied.iter().enumerate() {
        for (last, other) in tied[at + 1..].iter().filter(|(_, other)| other.unit == one.unit && other.key != one.key) {
            let behind = [first + one.printed.len(), last + other.printed.len()];
            let [before, between, after] = [&paper[..*first], &paper[behind[0]..*last], &paper[behind[1]..]];
            project.write("paper.tex", &format!("{before}{}{between}{}{after}", other.printed, one.printed));
            assert!(!project.differing().is_empty(), "{} and {}", one.printed, other.printed);
            tried += 1;
        }
    }
    assert!(tried >= 20, "only {tried} pairs");
}
