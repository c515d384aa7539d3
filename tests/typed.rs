//! Is each number that is typed in a chapter's text one that the code knows?
//!
//! Most numbers of the chapters come out of the code by placeholders. The others are typed: angles between pins, sizes in
//! exercises, references. Each of these is in a name, in a reference to something that exists, or in a phrase of a list
//! that says where its numbers come from.

use crate::book_sources::texts;
use geneva_case1973::likelihood::{LEAST_SPREAD, Law};
use geneva_case1973::{Column, EXPLAINED, Hypothesis, Reset, Row, SixPin, Weighing, rows_of};
use geneva_chapters::questions;
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::study::scores;
use geneva_documents::meyer::runs::table::{listing, rows};
use geneva_evidence::numeric_tokens;
use pulldown_cmark::{Event, Parser, Tag, TagEnd};

/// Names with numbers in them: works, standards, licences, machines, dates, identifiers.
const NAMES: &[&str] = &[
    "1973",
    "2026-11-23",
    "AMCP 706-205",
    "Apache 2.0",
    "CC BY 4.0",
    "CC BY-NC-SA 4.0",
    "Control Data 6500",
    "ISO 2768-1",
    "ISO 286",
    "July 2026",
    "June 2026",
    "1964",
    "November 2026",
    "Public License 2.0",
    "Sample Prob. 15.19",
    "September 2022",
    "a manual of 1967",
    "6225f58",
    "theses/1508",
    "the 1960s",
];

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

/// Pages, phrases in which numbers are typed, and these numbers as the code has them, without their signs. There are none
/// where the numbers come from no code: a definition, a choice of ours, or what somebody else says.
fn phrases() -> Vec<(&'static str, &'static str, Vec<f64>)> {
    let [three, four, six] = [3, 4, 6].map(apart);
    let reset = reset();
    // How long the driver goes on to act after a pin has left its slot, and how far past the line of centres a pin is let go.
    let beyond = reset - six;
    let dropped = reset - three / 2.0;
    let slots = |number: u32| 360.0 / f64::from(number);
    let explained = |pins: u32| (with_pins(pins).len() * EXPLAINED.len()) as f64;
    vec![
        ("about", "in the format EPUB 3", vec![]),
        ("pin", "one formula gives exactly 1/√6", vec![]),
        ("pin", "the axes are √2 R apart", vec![]),
        ("pin", "Four slots are 90° apart", vec![slots(4)]),
        ("pin", "the slot makes an angle of 45°", vec![slots(4) / 2.0]),
        ("pin", "the angle of 45° requires", vec![slots(4) / 2.0]),
        ("pin", "The angles are exactly 30° and 45°", vec![]),
        ("pin", "Six slots are 60° apart", vec![slots(6)]),
        ("jazar", "wheels with 3 to 18 stations", vec![]),
        ("jazar", "stands still for 1.5 s each time", vec![answered("eight", "dwell_time_s")]),
        ("joints", "a coefficient of friction of 0.2.", vec![]),
        ("making", "turns a minute (rpm): 60 divided", vec![]),
        ("making", "one pin and 60 turns a minute", vec![given("worked", "--rpm")]),
        (
            "making",
            "With a crank radius of 25 mm the axes are 50 mm apart",
            vec![given("worked", "--crank-radius"), answered("worked", "centre_distance_mm")],
        ),
        ("making", "with up to 60 stations", vec![]),
        ("making", "so the driver makes 60 turns a minute", vec![given("worked", "--rpm")]),
        ("making", "| 4 | … | … | | 5 | … | … | | 6 | … | … | | 8 | … | … | | 10 | … | … | | 12 | … | … |", vec![]),
        ("making", "3 to 6 mm | 6 to 10 mm | 10 to 18 mm | 18 to 30 mm", vec![]),
        ("making", "Stations | 3 | 4 | 5 | 6 | 8 | 10 | 12 |", vec![]),
        ("making", "At the peak torque and 60 turns a minute", vec![given("worked", "--rpm")]),
        ("making", "phosphor bronze, 10 mm thick", vec![given("worked", "--thickness")]),
        ("making", "a Poisson's ratio of 0.3", vec![]),
        ("making", "and … at 10°.", vec![given("worked-ten-before", "--before-entry")]),
        ("making", "above 6 and up to 30 mm they allow ±0.2 mm in class m (medium) and ±0.1 mm in class f", vec![]),
        ("making", "centre distance | 50 mm |", vec![answered("worked", "centre_distance_mm")]),
        ("making", "crank radius | 25 mm |", vec![given("worked", "--crank-radius")]),
        ("making", "| 1 | 1; two leave no dwell", vec![]),
        (
            "making",
            "six slots makes 200 turns a minute. The crank is 20° before",
            vec![given("instant", "--rpm"), given("instant", "--at").abs()],
        ),
        (
            "making",
            "has its axis 120 mm from the driver's axis. The driver makes 30 turns a minute",
            vec![given("sized", "--centre-distance"), given("sized", "--rpm")],
        ),
        (
            "making",
            "its driver makes 120 turns a minute. The axes are 150 mm apart",
            vec![given("loaded", "--rpm"), given("loaded", "--centre-distance")],
        ),
        ("making", "with its driver at 120 turns a minute", vec![given("worked-twice-as-fast", "--rpm")]),
        ("making", "the axes are to be 80 mm apart", vec![given("second", "--centre-distance")]),
        ("quick-return", "its factor 2", vec![]),
        ("quick-return", "the factor 2", vec![]),
        ("quick-return", "the same factor 2", vec![]),
        ("quick-return", "where does the 2 come from", vec![]),
        ("quick-return", "Where the 2 comes from", vec![]),
        ("quick-return", "The 2 appears by itself", vec![]),
        ("quick-return", "The crank, link 2,", vec![]),
        ("quick-return", "the lever, link 4,", vec![]),
        ("quick-return", "by 90° in the sense", vec![]),
        ("quick-return", "turns faster than at 20°", vec![printed("quick-return.lever-angle")]),
        ("program", "−1 if its first argument is negative, +1 if", vec![]),
        ("program", "six pins, 60° apart, starts with … at −30°.", vec![six, six / 2.0]),
        (
            "program",
            "runs from −30° to 60°. At 30° the pin leaves its slot",
            vec![six / 2.0, reset - six / 2.0, six / 2.0],
        ),
        ("program", "through the air for another 30°", vec![beyond]),
        (
            "program",
            "follow each other every 90°, but six pins every 60° and three pins every 120°",
            vec![four, six, three],
        ),
        ("program", "lets go of the pin 30° past the line of centres", vec![dropped]),
        ("program", "| 6 | 60° | −30° to 60° |", vec![6.0, six, six / 2.0, reset - six / 2.0]),
        ("program", "| 4 | 90° | −45° to 45° | 0: at rest |", vec![4.0, four, four / 2.0, reset - four / 2.0, 0.0]),
        ("program", "| 3 | 120° | −60° to 30° |", vec![3.0, three, three / 2.0, dropped]),
        ("program", "gives 90° for all three mechanisms", vec![reset]),
        ("program", "with the weights 1, 2, 2, 1:", vec![]),
        ("program", "the driver's angle is reset after 90°", vec![reset]),
        ("runs", "relative deviation (printed/computed − 1)", vec![]),
        ("runs", "One per cent of 100 rad/s is a unit of the tables", vec![]),
        ("runs", "resets the driver's angle after 90° for all three mechanisms", vec![reset]),
        ("runs", "the driver's angle reset after 90°.", vec![reset]),
        ("runs", "resets the driver's angle after 90°, which", vec![reset]),
        ("runs", "the reset after 90°", vec![reset]),
        ("runs", "With the reset after 90°", vec![reset]),
        ("runs", "to either side of 90°", vec![reset]),
        (
            "runs",
            "a minimum printed as 8 rad/s",
            vec![rows().iter().map(|row| row.number(Column::Minimum)).fold(f64::INFINITY, f64::min)],
        ),
        ("runs", "no spread below 1/256 of a unit", vec![1.0, 1.0 / LEAST_SPREAD]),
        ("runs", "of 48 numbers with six pins", vec![explained(6)]),
        ("runs", "of 48 with three", vec![explained(3)]),
        ("runs", "99 per cent", vec![printed("meyer.fig-10.rise-axis")]),
        ("mistake", "the driver's angle after every 90°", vec![reset]),
        ("mistake", "The reset at 90° is correct for four pins", vec![four]),
        ("mistake", "Six pins are 60° apart, and three pins 120°", vec![six, three]),
        ("mistake", "resets all three mechanisms after 90°", vec![reset]),
        ("mistake", "A difference of 10 means odds of twenty thousand to one", vec![libm::round(libm::log(2e4))]),
        ("mistake", "between 90° and the correct angles", vec![reset]),
        ("never-printed", "reset the driver's angle after 90°", vec![reset]),
        ("never-printed", "acts on the follower for 30° after leaving the slot", vec![beyond]),
        ("never-printed", "During these 30°", vec![beyond]),
        ("never-printed", "drops its pin 30° past the line of centres", vec![dropped]),
        ("never-printed", "its pins are 60° apart and not 90°", vec![six, reset]),
        ("timer", "The columns “to 1 %” give", vec![]),
        ("timer", "a coefficient of friction of about 0.1", vec![]),
        ("timer", "a rise from 50 ms to 1 ms, both inertias must be 2500 times smaller", vec![50.0, 1.0, 50.0 * 50.0]),
        ("wild", "With four slots that is 45°", vec![slots(4) / 2.0]),
        ("wild", "the driver's axis is 45° as well", vec![90.0 - slots(4) / 2.0]),
        ("wild", "turns by the same 90°", vec![180.0 - slots(4)]),
        ("wild", "turn by 108° with five and by 135° with eight", vec![180.0 - slots(5), 180.0 - slots(8)]),
        ("method", "after 90°, as the program does", vec![reset]),
        ("method", "of degrees 2 and 4", vec![]),
        ("method", "the degree is at most 2 in one variable and at most 4 in another", vec![]),
        ("method", "more than 300 numbers", vec![]),
        ("found", "We aimed at 70 % real errors", vec![]),
        ("found", "2.40 m/s² × (12.0 s)² = 172.80 m", vec![2.4, 12.0, 2.4 * 12.0 * 12.0 / 2.0]),
        ("found", "left side is 345.6 m", vec![2.4 * 12.0 * 12.0]),
        ("proofread", "the chain 1 sin 30°/sin 60° =", vec![]),
        ("proofread", "(as in 1 = 0.08)", vec![]),
        ("proofread", "x = 2y + 1", vec![]),
        ("errata-elsewhere", "for 3 to 60 slots", vec![]),
        ("architecture", "up to 12 existing ones", vec![]),
        ("solver", "(SIAM Review 50, 2008)", vec![]),
        ("solver", "on 49 escapements like the ones", vec![rows().len() as f64]),
        ("solver", "at 64 instants", vec![]),
        // A test compares these with the record.
        ("solver", "takes 4 µs", vec![]),
        ("solver", "by a factor of 2600 or more", vec![]),
        ("solver", "31 to 2000 times smaller and costs 1.8 to 3.7 times the work", vec![]),
        ("mimic", "the result is 0 or FALSE", vec![]),
        ("mimic", "This time is 2−24", vec![]),
        (
            "mimic",
            "begin in column 11, the equals signs are in column 17, and the expressions begin in column 19. We take columns 10 to 16",
            vec![],
        ),
        ("mimic", "printed as 1 or 0.", vec![]),
        ("mimic", "below 0.001 is treated as if it were 0.001", vec![]),
        ("mimic", "which is … over 230", vec![]),
        ("mimic", "and gives 0 before the start", vec![]),
        ("mimic", "up to 300 million steps", vec![]),
        ("runs", "for … .25 and more", vec![]),
        ("runs", "for … .20, ends it", vec![]),
        ("runs", "and … .35 the time", vec![]),
        (
            "runs",
            "the program as listed means No. 10, and the best combination means No. 8.",
            vec![number(Hypothesis::AS_RUN), number(Hypothesis::WITHOUT_LAG)],
        ),
        ("runs", "but only No. 8 has the exact sign", vec![number(Hypothesis::WITHOUT_LAG)]),
        ("runs", "the best combination, No. 8,", vec![number(Hypothesis::WITHOUT_LAG)]),
        ("runs", "with another reset, No. 3 or 4 is best", best(|of| of.reset != Reset::QuarterTurn)),
        (
            "runs",
            "with other inertias, No. 5 or 6.",
            best(|of| of.reset == Reset::QuarterTurn && of.six_pin != SixPin::AsDrawn),
        ),
    ]
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

/// Takes the references out of a text, and returns each with its word and its numbers.
fn references(text: &mut String) -> Vec<(&'static str, Vec<String>)> {
    let mut found = Vec::new();
    for word in REFERENCES {
        let mut from = 0;
        while let Some(at) = text[from..].find(word).map(|at| from + at) {
            let numbers = &text[at + word.len()..];
            // Numbers with commas, “to”, “and” and “or” between them.
            let mut end = 0;
            while let Some(length) = next_number(&numbers[end..]) {
                end += length;
            }
            let tokens = numeric_tokens(&numbers[..end]);
            if tokens.is_empty() {
                from = at + word.len();
            } else {
                found.push((word, tokens));
                text.replace_range(at..at + word.len() + end, "");
                from = at;
            }
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
fn every_number_typed_in_a_chapter_is_a_name_a_reference_or_in_a_phrase_of_the_list() {
    let mut wrong = Vec::new();
    let phrases = phrases();
    for (page, phrase, numbers) in &phrases {
        let typed: Vec<f64> = numeric_tokens(phrase).iter().map(|token| token.parse().expect("a number")).collect();
        let alike = |(typed, known): (&f64, &f64)| (typed - known).abs() < 5e-4;
        if !numbers.is_empty() && (typed.len() != numbers.len() || !typed.iter().zip(numbers).all(alike)) {
            wrong.push(format!("{page}: “{phrase}” has {typed:?}, and the code {numbers:?}"));
        }
    }
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
        for name in NAMES {
            text = text.replace(name, "");
        }
        let mut of_page: Vec<&str> =
            phrases.iter().filter(|(of, ..)| *of == page).map(|(_, phrase, _)| *phrase).collect();
        // A longer phrase may have a shorter one in it.
        of_page.sort_by_key(|phrase| std::cmp::Reverse(phrase.len()));
        for phrase in of_page {
            if !text.contains(phrase) {
                wrong.push(format!("{page}: “{phrase}” is not in it"));
            }
            text = text.replace(phrase, "");
        }
        for (word, numbers) in references(&mut text) {
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
        // Numbers of equations, as (1-7) and (5.32).
        for place in known.iter().flat_map(|place| place.split(' ')) {
            let number = place.trim_matches(|c: char| !matches!(c, '(' | ')') && !c.is_ascii_digit());
            if number.starts_with('(') && number.ends_with(')') {
                text = text.replace(number, "");
            }
        }
        for token in numeric_tokens(&text) {
            let at = text.find(&token).expect("it was found there");
            let around: String = text[..at].chars().rev().take(40).collect::<Vec<_>>().into_iter().rev().collect();
            wrong.push(format!("{page}: {token} behind “{around}” has no reason"));
        }
    }
    assert!(
        wrong.is_empty(),
        "{}\nTake a placeholder, or add a phrase with the numbers that it has to phrases() in {}",
        wrong.join("\n"),
        file!()
    );
}

/// Whether a place in a source is, or is in, what a word and a number name.
fn names(place: &str, word: &str, number: &str) -> bool {
    place.split_once(word).is_some_and(|(_, behind)| {
        let end = behind.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(behind.len());
        behind[..end].trim_end_matches('.') == number
    })
}
