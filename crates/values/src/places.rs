//! Which number of a text an entry means: by the words around it, so that edits elsewhere change nothing.

use crate::numbered_text::{NumberedText, PrintedNumber, WORDS};
use crate::record_file::{NumberEntry, Place};
use std::collections::HashMap;

/// Where the entries of a text are in it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Placement {
    /// For each entry its number, if it was found.
    pub of_entry: Vec<Option<usize>>,
    /// For each number its entry, if there is one.
    pub of_number: Vec<Option<usize>>,
    /// Whether an entry was found by the order alone, among others with the same words and other digits.
    pub is_ambiguous: Vec<bool>,
}

/// The words around a number, in few words and in many.
struct Surroundings {
    short: [String; 2],
    long: [String; 2],
}

/// What entries and numbers must have in common.
#[derive(Clone, Copy)]
enum Criterion {
    /// All words that are recorded, of a description in many words or in few, and perhaps the printed characters.
    All { long: bool, printed: bool, strength: Option<Strength> },
    /// So many words before and after, and perhaps the printed characters.
    Some { before: usize, after: usize, printed: bool },
    /// The printed characters alone.
    Printed(Strength),
}

/// Whether words say where a number is. Between the cells of a table there are only numbers, so a row that comes in gives each
/// the words of another; there the printed characters say more.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Strength {
    Weak,
    Strong,
}

/// From the surest to the least sure. Each looks at what those before it have left.
const CRITERIA: [Criterion; 17] = [
    Criterion::All { long: true, printed: true, strength: None },
    Criterion::All { long: false, printed: true, strength: None },
    Criterion::All { long: true, printed: false, strength: Some(Strength::Strong) },
    Criterion::All { long: false, printed: false, strength: Some(Strength::Strong) },
    Criterion::Some { before: 3, after: 2, printed: true },
    Criterion::Some { before: 3, after: 0, printed: true },
    Criterion::Some { before: 0, after: 3, printed: true },
    Criterion::Printed(Strength::Weak),
    Criterion::All { long: true, printed: false, strength: Some(Strength::Weak) },
    Criterion::All { long: false, printed: false, strength: Some(Strength::Weak) },
    Criterion::Some { before: 3, after: 1, printed: false },
    Criterion::Some { before: 1, after: 3, printed: false },
    Criterion::Some { before: 3, after: 0, printed: false },
    Criterion::Some { before: 0, after: 3, printed: false },
    Criterion::Some { before: 1, after: 0, printed: true },
    Criterion::Some { before: 0, after: 1, printed: true },
    Criterion::Printed(Strength::Strong),
];

/// The words nearest to a number: the last of those before it, or the first of those after it.
fn nearest_words(words: [&str; 2], most: [usize; 2]) -> [Vec<&str>; 2] {
    let last = words[0].rsplit(' ').filter(|word| !word.is_empty()).take(most[0]).collect();
    let first = words[1].split(' ').filter(|word| !word.is_empty()).take(most[1]).collect();
    [last, first]
}

fn strength(words: [&str; 2]) -> Strength {
    /// Fewest words that are no numbers.
    const FEWEST: usize = 4;
    let near = nearest_words(words, WORDS[0]);
    let count = near.iter().flatten().filter(|word| **word != "#").count();
    if count < FEWEST { Strength::Weak } else { Strength::Strong }
}

/// What identifies a number under a criterion; none if it has too few words.
fn key(criterion: Criterion, words: [&str; 2], printed: &str, unit: &str) -> Option<String> {
    let characters = |with_printed: bool| if with_printed { format!("{printed}\n{unit}") } else { String::new() };
    match criterion {
        Criterion::All { printed, strength: asked, .. } => {
            let fits = asked.is_none_or(|asked| asked == strength(words));
            fits.then(|| format!("{}\n{}\n{}", words[0], words[1], characters(printed)))
        }
        Criterion::Some { before, after, printed } => {
            let [last, first] = nearest_words(words, [before, after]);
            let is_whole = last.len() == before && first.len() == after;
            let says_something = last.iter().chain(&first).any(|word| *word != "#");
            let join = |words: Vec<&str>| words.join(" ");
            (is_whole && says_something).then(|| format!("{}\n{}\n{}", join(last), join(first), characters(printed)))
        }
        Criterion::Printed(asked) => {
            let digits = printed.bytes().filter(u8::is_ascii_digit).skip_while(|byte| *byte == b'0').count();
            let fits = asked == strength(words) && (asked == Strength::Weak || digits > 2);
            fits.then(|| characters(true))
        }
    }
}

/// Finds the entries of a text in it.
pub(crate) fn place(entries: &[&NumberEntry], text: &NumberedText) -> Placement {
    let numbers = &text.numbers;
    let around = |number: &PrintedNumber| {
        let [short, long] = WORDS.map(|most| text.words_around(number, most));
        Surroundings { short, long }
    };
    let surroundings: Vec<Surroundings> = numbers.iter().map(around).collect();
    let mut placement = Placement {
        of_entry: vec![None; entries.len()],
        of_number: vec![None; numbers.len()],
        is_ambiguous: vec![false; entries.len()],
    };
    for criterion in CRITERIA {
        let mut groups: HashMap<String, [Vec<usize>; 2]> = HashMap::new();
        for (at, entry) in entries.iter().enumerate().filter(|(at, _)| placement.of_entry[*at].is_none()) {
            if let Some(key) = key(criterion, [&entry.before, &entry.after], &entry.printed, &entry.unit) {
                groups.entry(key).or_default()[0].push(at);
            }
        }
        if groups.is_empty() {
            continue;
        }
        for (at, number) in numbers.iter().enumerate().filter(|(at, _)| placement.of_number[*at].is_none()) {
            let [before, after] = match criterion {
                Criterion::All { long: false, .. } => &surroundings[at].short,
                _ => &surroundings[at].long,
            };
            let group =
                key(criterion, [before, after], &number.printed, &number.unit).and_then(|key| groups.get_mut(&key));
            if let Some(group) = group {
                group[1].push(at);
            }
        }
        for [mine, found] in groups.into_values() {
            pair(criterion, mine, found, entries, numbers, &mut placement);
        }
    }
    placement
}

/// Pairs entries with numbers that cannot be told apart by a criterion: in their order if there are as many, otherwise first by
/// what they print.
fn pair(
    criterion: Criterion,
    mut mine: Vec<usize>,
    mut found: Vec<usize>,
    entries: &[&NumberEntry],
    numbers: &[PrintedNumber],
    placement: &mut Placement,
) {
    let is_same = |entry: usize, number: usize| {
        entries[entry].printed == numbers[number].printed && entries[entry].unit == numbers[number].unit
    };
    let mut tie = |entry: usize, number: usize, ambiguous: bool| {
        placement.of_entry[entry] = Some(number);
        placement.of_number[number] = Some(entry);
        placement.is_ambiguous[entry] = ambiguous;
    };
    if mine.len() != found.len() {
        let mut by_printed: HashMap<(&str, &str), Vec<usize>> = HashMap::new();
        for number in found.iter().rev() {
            by_printed.entry((&numbers[*number].printed, &numbers[*number].unit)).or_default().push(*number);
        }
        mine.retain(|entry| {
            let key = (&*entries[*entry].printed, &*entries[*entry].unit);
            match by_printed.get_mut(&key).and_then(Vec::pop) {
                Some(number) => {
                    tie(*entry, number, false);
                    false
                }
                None => true,
            }
        });
        found = by_printed.into_values().flatten().collect();
        found.sort_unstable();
        if !matches!(criterion, Criterion::All { .. }) {
            return;
        }
    }
    let alone = mine.len() == 1 && found.len() == 1;
    for (entry, number) in mine.into_iter().zip(found) {
        tie(entry, number, !alone && !is_same(entry, number));
    }
}

/// How each number of a text is described: in few words, or in many if others have the same few words around them.
pub(crate) fn descriptions(name: &str, text: &NumberedText) -> Vec<Place> {
    let short: Vec<[String; 2]> = text.numbers.iter().map(|number| text.words_around(number, WORDS[0])).collect();
    let mut count: HashMap<&[String; 2], usize> = HashMap::new();
    for words in &short {
        *count.entry(words).or_default() += 1;
    }
    let describe = |(number, words): (&PrintedNumber, &[String; 2])| {
        let is_unique = count.get(words) == Some(&1);
        let [before, after] = if is_unique { words.clone() } else { text.words_around(number, WORDS[1]) };
        Place { text: name.to_owned(), before, printed: number.printed.clone(), unit: number.unit.clone(), after }
    };
    text.numbers.iter().zip(&short).map(describe).collect()
}
