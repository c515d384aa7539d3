//! Does the book read like English? Counts habits over the running text of all pages but the records.
//!
//! A count says where to read again, and nothing more: good prose is not made by keeping a bound. The bounds are wide enough
//! that well-written technical books keep all of them.

use crate::book_pages::{Piece, pages};
use std::fmt::Write;

/// Pages that list what the ledger has, in the ledger's words.
const RECORDS: [&str; 5] = ["ledger", "coverage", "errata", "404", "print"];

/// Elements whose text is no running text.
const SKIPPED: [&str; 13] = [
    "script", "style", "pre", "table", "svg", "nav", "figure", "template", "form", "button", "select", "footer",
    "noscript",
];

/// Elements that count as one word, whatever is in them.
const AS_A_WORD: [&str; 2] = ["math", "code"];

/// Elements that begin a new piece of text.
const BLOCKS: [&str; 13] =
    ["p", "li", "h1", "h2", "h3", "h4", "summary", "dd", "dt", "blockquote", "div", "section", "details"];

/// Elements without an end.
const EMPTY: [&str; 7] = ["img", "input", "br", "hr", "meta", "link", "wbr"];

/// A sentence of a page.
struct Sentence<'a> {
    page: &'a str,
    text: String,
    /// The words in lower case, without the marks around them.
    words: Vec<String>,
}

impl<'a> Sentence<'a> {
    fn new(page: &'a str, text: String) -> Self {
        let bare = |word: &str| word.trim_matches(|of: char| !of.is_alphanumeric()).replace('’', "'").to_lowercase();
        let words = text.split_whitespace().map(bare).filter(|word| !word.is_empty()).collect();
        Self { page, text, words }
    }

    /// Whether these words stand in it, one after another; each place allows several, parted by `|`.
    fn has(&self, wanted: &str) -> bool {
        let wanted: Vec<Vec<&str>> = wanted.split(' ').map(|place| place.split('|').collect()).collect();
        self.words
            .windows(wanted.len())
            .any(|found| found.iter().zip(&wanted).all(|(word, allowed)| allowed.contains(&word.as_str())))
    }

    fn has_any(&self, wanted: &[&str]) -> bool {
        wanted.iter().any(|wanted| self.has(wanted))
    }

    fn begins(&self, words: &[&str]) -> bool {
        self.words.first().is_some_and(|first| words.contains(&first.as_str()))
    }
}

/// The running text of a page in blocks. A formula or a piece of code counts as one word.
fn blocks(pieces: &[Piece]) -> Vec<String> {
    let mut blocks = vec![String::new()];
    let mut within_main = false;
    // The element that is passed over, and how many of its name are open.
    let mut skipped: Option<(&str, usize)> = None;
    for piece in pieces {
        if let Some((name, open)) = &mut skipped {
            match piece {
                Piece::Start { element, .. } if element == name => *open += 1,
                Piece::End(element) if element == name => *open -= 1,
                _ => {}
            }
            skipped = skipped.filter(|(_, open)| *open > 0);
            continue;
        }
        let last = blocks.last_mut().expect("never empty");
        match piece {
            Piece::Start { element, .. } if element == "main" => within_main = true,
            Piece::End(element) if element == "main" => within_main = false,
            Piece::Start { element, .. } if EMPTY.contains(&element.as_str()) => {}
            Piece::Start { element, attributes } => {
                let is_hidden = attributes.contains_key("popover") || attributes.contains_key("hidden");
                if AS_A_WORD.contains(&element.as_str()) {
                    last.push_str(" X ");
                    skipped = Some((element, 1));
                } else if is_hidden || SKIPPED.contains(&element.as_str()) {
                    skipped = Some((element, 1));
                } else if BLOCKS.contains(&element.as_str()) {
                    blocks.push(String::new());
                }
            }
            Piece::End(element) if BLOCKS.contains(&element.as_str()) => blocks.push(String::new()),
            Piece::Text(text) if within_main => last.push_str(text),
            _ => {}
        }
    }
    blocks
}

/// The sentences of a block: parted where a full stop, a question mark or an exclamation mark is followed by a capital.
fn sentences(block: &str) -> Vec<String> {
    let words: Vec<&str> = block.split_whitespace().collect();
    let ends = |word: &str, next: &str| {
        word.ends_with(['.', '?', '!']) && next.starts_with(|first: char| first.is_uppercase() || "“(".contains(first))
    };
    let parts = words.chunk_by(|word, next| !ends(word, next));
    parts.filter(|words| words.len() >= 3).map(|words| words.join(" ")).collect()
}

fn all() -> Vec<Sentence<'static>> {
    let mut all = Vec::new();
    for (page, pieces) in pages() {
        if RECORDS.iter().any(|record| page.starts_with(record)) {
            continue;
        }
        for block in blocks(pieces) {
            // Labels and lists of names have no end of a sentence.
            if !block.trim_end().ends_with(['.', ':', '?', '!', ')']) || block.split_whitespace().count() < 4 {
                continue;
            }
            all.extend(sentences(&block).into_iter().map(|text| Sentence::new(page, text)));
        }
    }
    all
}

/// A habit, and whether a sentence has it.
type Habit = (&'static str, f64, fn(&Sentence<'_>) -> bool);

/// What stilted prose is full of, and the most of it in a hundred sentences.
const AT_MOST: &[Habit] = &[
    ("a pronoun without its noun: that of, those with, the one that", 1.5, |of| {
        of.has_any(&["that|those of|with|in|at|on|for|by", "the one|ones of|with|that|the"])
    }),
    ("a clause for a subject: Who takes …, What it prints …", 0.3, |of| {
        let goes_on = ["is", "are", "does", "do", "happens", "would", "can", "makes", "if"];
        of.begins(&["who", "whoever", "what"])
            && of.text.ends_with('.')
            && !of.words.get(1).is_some_and(|next| goes_on.contains(&next.as_str()))
    }),
    ("stands, lies, is told for says, gives, contains", 0.5, |of| {
        of.has_any(&["stand|stands|lie|lies in|on|at|behind|beside|under|for|below|above|with|by", "is|are told"])
    }),
    ("comes out, is off, the other way round", 0.5, |of| {
        of.has_any(&[
            "come|comes out",
            "is|are|be off",
            "read otherwise",
            "the other way round",
            "one way or the other",
        ])
    }),
    ("an impersonal somebody", 0.5, |of| of.has_any(&["nobody|somebody", "no one", "it is said|told|asked|shown"])),
    ("so and the same for what they stand for", 0.5, |of| of.has_any(&["is|are|does so", "the like"])),
    ("a semicolon", 4.0, |of| of.text.contains(';')),
    ("more than 35 words", 8.0, |of| of.text.split_whitespace().count() > 35),
];

/// What holds sentences together and speaks to a reader, and the least of it in a hundred sentences.
const AT_LEAST: &[Habit] = &[
    ("a word that connects: because, but, although, for example", 18.0, |of| {
        of.has_any(&[
            "because|therefore|however|although|though|instead|while|since|but|thus|hence",
            "for example|instance",
            "so that",
            "which means",
            "as a result",
        ])
    }),
    ("we or you", 20.0, |of| {
        of.words.iter().any(|word| {
            let word = word.split('\'').next().unwrap_or(word);
            ["we", "our", "us", "you", "your"].contains(&word)
        })
    }),
];

/// How often habits are found, in a hundred sentences, if it is too often or too seldom; with some places.
fn outside(sentences: &[Sentence<'_>]) -> String {
    let mut report = String::new();
    for (habits, is_bad) in [(AT_MOST, f64::gt as fn(&f64, &f64) -> bool), (AT_LEAST, f64::lt)] {
        for (name, bound, has) in habits {
            let found: Vec<_> = sentences.iter().filter(|of| has(of)).collect();
            let rate = 100.0 * found.len() as f64 / sentences.len().max(1) as f64;
            if is_bad(&rate, bound) {
                let _ = writeln!(report, "{name}: {rate:.1} in a hundred sentences, the bound is {bound:.1}");
                for of in found.iter().take(5) {
                    let _ = writeln!(report, "    {}: {}", of.page, of.text);
                }
            }
        }
    }
    report
}

#[test]
fn the_prose_keeps_its_bounds() {
    let sentences = all();
    assert!(sentences.len() > 1000, "only {} sentences were found", sentences.len());
    let report = outside(&sentences);
    assert!(report.is_empty(), "{report}");
}

#[test]
fn each_habit_is_noticed() {
    let of = |text: &str| Sentence::new("made-up", text.to_owned());
    let stilted = [
        "The speed is that of the driver.",
        "Who takes the one for the other plans a slow machine.",
        "The reason is told behind the table.",
        "The numbers come out to one unit.",
        "Nobody says that an example is right.",
        "With four pins it is so.",
        "The wheel rests; the driver turns.",
        &"word ".repeat(40),
    ];
    for (text, (name, _, has)) in stilted.iter().zip(AT_MOST) {
        assert!(has(&of(text)), "{name}: {text}");
        assert!(!has(&of("We turn the driver because the wheel must move.")), "{name}");
    }
    for (_, _, has) in AT_LEAST {
        assert!(has(&of("But we turn the driver.")) && !has(&of("The driver turns the wheel.")));
    }
    // Text that has none of what good prose has is outside of every lower bound, and its report says where it looked.
    let poor: Vec<_> = (0..50).map(|_| of("The driver turns the wheel.")).collect();
    assert_eq!(outside(&poor).lines().count(), AT_LEAST.len());
}
