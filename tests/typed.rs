//! Is each number that is typed in a text of ours one that the code knows?
//!
//! Most numbers of the chapters come out of the code by placeholders. The others are typed: angles between pins, sizes in
//! exercises, references. The record `numbers.toml` says of each what it is: a value that the code has, which this test writes into
//! `book/values.json`, or none. `geneva check` compares them; it reads what a reader sees, in the formulas, too.

use crate::book_sources::{stood_written, texts};
use geneva_case1973::likelihood::{LEAST_SPREAD, Law};
use geneva_case1973::{Column, EXPLAINED, Hypothesis, Reset, Row, SixPin, Weighing, rows_of};
use geneva_chapters::{BOOK, questions};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::study::scores;
use geneva_documents::meyer::runs::table::{listing, rows};
use geneva_evidence::numeric_tokens;
use geneva_values::{Record, RecordRequest, check, record};
use pulldown_cmark::{Event, Parser, Tag, TagEnd};

/// The rows with this number of pins.
fn with_pins(pins: u32) -> &'static [Row] {
    let row = rows().iter().find(|row| row.mechanism.pins() == pins).expect("a row");
    rows_of(rows(), row.mechanism)
}

/// The angle between neighbouring pins, in degrees.
fn apart(pins: u32) -> f64 {
    (2.0 * with_pins(pins)[0].mechanism.engagement_half_angle()).to_degrees()
}

/// The angle in degrees after which the program of the thesis resets the driver's angle.
fn reset() -> f64 {
    listing().reset.to_degrees()
}

/// The number of a hypothesis in the table of them.
fn number(hypothesis: Hypothesis) -> f64 {
    let before = scores().iter().position(|score| score.hypothesis == hypothesis).expect("one of the table");
    (before + 1) as f64
}

/// The numbers of the hypotheses that are the best of some, by any weighing of the errors.
fn best(of: impl Fn(&Hypothesis) -> bool) -> Vec<f64> {
    let whole = [Weighing::BY_COLUMN, Weighing::BY_TABLE, Weighing::COARSE];
    let mut best = Vec::new();
    for weighing in whole.into_iter().chain(Weighing::one_row_of_each(rows())) {
        for law in Law::ALL {
            let likely = |score: &&_| weighing.log_likelihood(score, law);
            let some = scores().iter().filter(|score| of(&score.hypothesis));
            let most = some.max_by(|one, other| likely(one).total_cmp(&likely(other))).expect("one");
            best.push(number(most.hypothesis));
        }
    }
    best.sort_by(f64::total_cmp);
    best.dedup();
    best
}

/// A number that the question of this name gives behind a word, as in `--rpm 60`.
fn given(question: &str, word: &str) -> f64 {
    let typed = questions::question(question).expect("a question");
    let mut words = typed.split(' ').skip_while(|typed| *typed != word);
    let number = words.nth(1).unwrap_or_else(|| panic!("`{typed}` has no {word}"));
    number.parse().expect("a number")
}

/// A number of the answer to the question of this name.
fn answered(question: &str, key: &str) -> f64 {
    questions::value(&questions::question(question).expect("a question"), key).expect("a number")
}

/// The number that a claim prints.
fn printed(id: &str) -> f64 {
    let claim = LEDGER.claims().iter().find(|claim| claim.id == id).unwrap_or_else(|| panic!("no claim {id}"));
    numeric_tokens(claim.printed)[0].parse().expect("a number")
}

/// The numbers that the README has from the book, by their names there.
const OF_THE_BOOK: [&str; 14] = [
    "rows",
    "rows.of-no-mechanism",
    "example.as-run",
    "example.right",
    "cells",
    "cells.by-the-program",
    "cells.by-the-mechanisms",
    "claims.wrong",
    "claims.right",
    "claims.wrong-gravely",
    "claims.wrong-lightly",
    "claims.open",
    "claims.copy",
    "slips.grave",
];

/// Keys, numbers and units of what the code has of the numbers that are typed.
fn values() -> Vec<(String, f64, &'static str)> {
    let [three, four, six] = [3, 4, 6].map(apart);
    let reset = reset();
    let slots = |number: u32| 360.0 / f64::from(number);
    let explained = |pins: u32| (with_pins(pins).len() * EXPLAINED.len()) as f64;
    let least = rows().iter().map(|row| row.number(Column::Minimum)).fold(f64::INFINITY, f64::min);
    let degrees = [
        ("pins.three.apart", three),
        ("pins.four.apart", four),
        ("pins.six.apart", six),
        ("pins.three.half", three / 2.0),
        ("pins.four.half", four / 2.0),
        ("pins.six.half", six / 2.0),
        ("reset", reset),
        // Where the reset ends the run of the angle, from where a pin enters.
        ("reset.end.three", reset - three / 2.0),
        ("reset.end.four", reset - four / 2.0),
        ("reset.end.six", reset - six / 2.0),
        // How long the driver goes on to act after a pin has left its slot.
        ("reset.beyond.six", reset - six),
        ("slots.four.apart", slots(4)),
        ("slots.four.half", slots(4) / 2.0),
        ("slots.six.apart", slots(6)),
        // By how much the driver turns while the wheel does.
        ("slots.four.driver", 180.0 - slots(4)),
        ("slots.four.driver.half", 90.0 - slots(4) / 2.0),
        ("slots.five.driver", 180.0 - slots(5)),
        ("slots.eight.driver", 180.0 - slots(8)),
        ("question.ten-before", given("worked-ten-before", "--before-entry")),
        ("question.instant.before", given("instant", "--at").abs()),
        ("quick-return.lever-angle", printed("quick-return.lever-angle")),
    ];
    let lengths = [("question.worked.crank-radius", given("worked", "--crank-radius"))];
    let bare = [
        ("question.worked.rpm", given("worked", "--rpm")),
        ("question.instant.rpm", given("instant", "--rpm")),
        ("spread.parts", 1.0 / LEAST_SPREAD),
        ("explained.three", explained(3)),
        ("explained.six", explained(6)),
        ("odds", libm::round(libm::log(2e4))),
        ("times-smaller", 50.0 * 50.0),
        ("hypothesis.as-run", number(Hypothesis::AS_RUN)),
        ("hypothesis.without-lag", number(Hypothesis::WITHOUT_LAG)),
        ("claims", LEDGER.mirrored().iter().map(|document| document.claims().len()).sum::<usize>() as f64),
        ("drag.claims", geneva_example_drag::LEDGER.claims().len() as f64),
        ("rust", rust_version()),
    ];
    let others = [
        ("question.eight.dwell", answered("eight", "dwell_time_s"), "s"),
        ("rise.share", printed("meyer.fig-10.rise-axis"), "%"),
        ("minimum.least", least, "rad/s"),
        ("example.printed", printed("meyer.app-e.6-pin.mu-0.20.k-0.03.max"), "rad/s"),
        ("elsewhere.way", 2.4 * 12.0 * 12.0 / 2.0, "m"),
        ("elsewhere.twice-the-way", 2.4 * 12.0 * 12.0, "m"),
    ];
    let best_of = |name: &str, of: &dyn Fn(&Hypothesis) -> bool| {
        best(of)
            .into_iter()
            .enumerate()
            .map(|(at, no)| (format!("hypothesis.{name}.{}", at + 1), no, ""))
            .collect::<Vec<_>>()
    };
    let of_the_book = OF_THE_BOOK.map(|name| {
        let text = geneva_press::computed_number(&BOOK, name).expect("a number of the book");
        let unit = if name.starts_with("example.") { "rad/s" } else { "" };
        (name.to_owned(), numeric_tokens(&text)[0].parse().expect("a number"), unit)
    });
    let with = |unit: &'static str| move |(key, number): (&str, f64)| (key.to_owned(), number, unit);
    let mut all: Vec<(String, f64, &str)> = degrees.into_iter().map(with("°")).collect();
    all.extend(lengths.into_iter().map(with("mm")));
    all.extend(bare.into_iter().map(with("")));
    all.extend(others.into_iter().map(|(key, number, unit)| (key.to_owned(), number, unit)));
    all.extend(best_of("other-reset", &|of| of.reset != Reset::QuarterTurn));
    all.extend(best_of("other-inertias", &|of| of.reset == Reset::QuarterTurn && of.six_pin != SixPin::AsDrawn));
    all.extend(of_the_book);
    all
}

/// The oldest version of Rust that compiles the project, as a number.
fn rust_version() -> f64 {
    env!("CARGO_PKG_RUST_VERSION").parse().expect("major.minor")
}

/// The values as a file of them. Angles of an arc function may miss a whole number by a last bit.
fn values_file() -> String {
    let line = |(key, number, unit): (String, f64, &str)| {
        let rounded: f64 = format!("{number:.11e}").parse().expect("a number");
        format!("  {:?}: {{\"value\": {rounded}, \"unit\": {unit:?}}}", key)
    };
    format!("{{\n{}\n}}\n", values().into_iter().map(line).collect::<Vec<_>>().join(",\n"))
}

#[test]
fn every_number_typed_in_a_text_is_what_the_record_says() {
    let stood = stood_written("book/values.json", &values_file());
    let known =
        Record::parse(&std::fs::read_to_string(crate::path("numbers.toml")).expect("a record")).expect("a record");
    for (name, _) in texts() {
        let is_known = known.texts.iter().any(|text| text.rsplit('/').next() == Some(&*name));
        assert!(is_known, "{name} is not among the texts of numbers.toml; add it there");
    }
    let report = check(&crate::path("numbers.toml"), false).expect("a record");
    let differing: Vec<String> = { report.findings.iter() }
        .filter(|finding| !finding.kind.is_right())
        .map(|finding| {
            let line = finding.at.map_or(0, |[start, _]| start.line);
            format!("{}:{line}: {}", finding.text.display(), finding.message)
        })
        .collect();
    assert!(
        differing.is_empty(),
        "{}\nPut the text right, or run `cargo run -- record numbers.toml` and decide what the new numbers are",
        differing.join("\n")
    );
    assert_eq!(report.unused, [""; 0], "no text prints these values: take them out of values() in {}", file!());
    let ties = record(&RecordRequest { named: vec![crate::path("numbers.toml")], ..RecordRequest::default() });
    assert!(!ties.expect("a record").is_changed, "numbers.toml was described anew, and stands so now: test again");
    assert!(stood, "book/values.json did not stand as the code has it, and stands so now: test again");
}

/// The running text of a page by blocks, with whether a block is a heading. Formulas, code and placeholders are left out.
fn blocks(markdown: &str) -> Vec<(bool, String)> {
    let mut blocks = Vec::new();
    let (mut text, mut heading, mut code) = (String::new(), false, false);
    for event in Parser::new(markdown) {
        match event {
            Event::Start(Tag::CodeBlock(_)) => code = true,
            Event::End(TagEnd::CodeBlock) => code = false,
            Event::Start(Tag::Heading { .. }) => heading = true,
            Event::End(TagEnd::Heading(_) | TagEnd::Paragraph | TagEnd::Item | TagEnd::HtmlBlock) => {
                blocks.push((heading, std::mem::take(&mut text)));
                heading = false;
            }
            Event::Text(piece) if !code => text.push_str(&piece),
            Event::Html(piece) | Event::InlineHtml(piece) => text.push_str(&piece),
            Event::Code(_) => text.push('…'),
            Event::SoftBreak | Event::HardBreak => text.push(' '),
            _ => {}
        }
    }
    blocks.push((false, text));
    let bare = |text: &str| {
        let text = [("<", ">", ""), ("{{", "}}", "…"), ("{#", "}", ""), ("$$", "$$", "…"), ("$", "$", "…")]
            .iter()
            .fold(text.to_owned(), |text, (open, close, instead)| without(&text, open, close, instead));
        // Identifiers, as m58285.
        let is_identifier = |word: &&str| {
            let word = word.trim_matches(['(', ')', '.', ',']);
            word.starts_with(|c: char| c.is_ascii_alphabetic()) && word.ends_with(|c: char| c.is_ascii_alphanumeric())
        };
        let text = text.replace('’', "'");
        text.split_whitespace()
            .filter(|word| !is_identifier(word) || !word.contains(|c: char| c.is_ascii_digit()))
            .collect::<Vec<_>>()
            .join(" ")
    };
    blocks.iter().map(|(heading, text)| (*heading, bare(text))).collect()
}

/// A text with something else for each piece between two marks.
fn without(text: &str, open: &str, close: &str, instead: &str) -> String {
    let mut left = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(open) {
        let Some((_, behind)) = after.split_once(close) else { break };
        left.push_str(before);
        left.push_str(instead);
        rest = behind;
    }
    left + rest
}

/// The number with a full stop or a colon at the start of a block, as in `3. Torque` and `Step 3: …`, and what follows.
fn ordinal(block: &str) -> Option<(u32, &str)> {
    let block = block.strip_prefix("Step ").unwrap_or(block);
    let (number, rest) = block.split_once(['.', ':'])?;
    Some((number.parse().ok()?, rest))
}

/// Words before the numbers of a reference.
const REFERENCES: [&str; 9] =
    ["Step ", "step ", "Steps ", "steps ", "Exercise ", "Fig. ", "Figs. ", "No. ", "Conclusion "];

/// The references in a text, each with its word and its numbers.
fn references(text: &str) -> Vec<(&'static str, Vec<String>)> {
    let mut found = Vec::new();
    for word in REFERENCES {
        for (at, _) in text.match_indices(word) {
            let numbers = &text[at + word.len()..];
            // Numbers with commas, “to”, “and” and “or” between them.
            let mut end = 0;
            while let Some(length) = next_number(&numbers[end..]) {
                end += length;
            }
            // In capitals it names something, and otherwise a step may be one of time.
            let tokens = numeric_tokens(&numbers[..end]);
            found.push((
                word,
                tokens.into_iter().filter(|token| !token.contains('.') || word.starts_with("Fig")).collect(),
            ));
        }
    }
    found
}

/// The length of a number at the start of a text, with the joining word before it.
fn next_number(text: &str) -> Option<usize> {
    let rest = [", ", " to ", " and ", " or "].iter().find_map(|joint| text.strip_prefix(joint)).unwrap_or(text);
    let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    // A figure of a chapter-wise numbering, as 5.30.
    let part = rest[digits..].strip_prefix('.').map_or(0, |part| {
        let digits = part.find(|c: char| !c.is_ascii_digit()).unwrap_or(part.len());
        if digits == 0 { 0 } else { digits + 1 }
    });
    (digits > 0).then(|| text.len() - rest.len() + digits + part)
}

#[test]
fn every_reference_to_a_number_exists() {
    let mut wrong = Vec::new();
    let known: Vec<&str> = LEDGER.claims().iter().map(|claim| claim.locator).collect();
    for (file, markdown) in texts() {
        let page = file.trim_end_matches(".md");
        // The number of the last heading, and of the last numbered paragraph.
        let mut last = [0; 2];
        let mut text = String::new();
        for (heading, block) in blocks(&markdown) {
            let rest = match ordinal(&block) {
                Some((number, rest)) => {
                    let last = &mut last[usize::from(!heading)];
                    if number != *last + 1 {
                        wrong.push(format!("{page}: “{block}” follows number {last}"));
                    }
                    *last = number;
                    rest
                }
                None => &block,
            };
            text.push_str(rest);
            text.push('\n');
        }
        for (word, numbers) in references(&text) {
            for number in numbers {
                let exists = match word {
                    "Exercise " => number.parse::<u32>().is_ok_and(|number| number <= last[1]),
                    "Fig. " | "Figs. " => known.iter().any(|place| names(place, "Fig. ", &number)),
                    "No. " => number.parse::<usize>().is_ok_and(|number| number <= scores().len()),
                    "Conclusion " => known.iter().any(|place| names(place, "Conclusion ", &number)),
                    _ => number.parse::<u32>().is_ok_and(|number| number <= last[0]),
                };
                if !exists {
                    wrong.push(format!("{page}: there is no {word}{number}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether a place in a source is, or is in, what a word and a number name.
fn names(place: &str, word: &str, number: &str) -> bool {
    place.split_once(word).is_some_and(|(_, behind)| {
        let end = behind.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(behind.len());
        behind[..end].trim_end_matches('.') == number
    })
}
