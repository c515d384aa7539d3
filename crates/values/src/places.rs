//! Which number of a text an entry means: by the words around it, so that edits elsewhere change nothing.

use crate::numbered_text::{NumberedText, PrintedNumber, WORDS};
use crate::record_file::{Entry, Place};
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
    /// All words that are recorded, where a number is described in many words, and in few.
    Long,
    Short,
    /// So many words before and after, and perhaps the printed characters.
    Some {
        before: usize,
        after: usize,
        printed: bool,
    },
    /// The printed characters alone.
    Printed,
}

/// From the surest to the least sure. Each looks at what those before it have left.
const CRITERIA: [Criterion; 13] = [
    Criterion::Long,
    Criterion::Short,
    Criterion::Some { before: 3, after: 2, printed: true },
    Criterion::Some { before: 3, after: 0, printed: true },
    Criterion::Some { before: 0, after: 3, printed: true },
    Criterion::Some { before: 3, after: 2, printed: false },
    Criterion::Some { before: 3, after: 1, printed: false },
    Criterion::Some { before: 1, after: 3, printed: false },
    Criterion::Some { before: 3, after: 0, printed: false },
    Criterion::Some { before: 0, after: 3, printed: false },
    Criterion::Some { before: 1, after: 0, printed: true },
    Criterion::Some { before: 0, after: 1, printed: true },
    Criterion::Printed,
];

/// What identifies a number under a criterion; none if it has too few words.
fn key(criterion: Criterion, words: [&str; 2], printed: &str, unit: &str) -> Option<String> {
    match criterion {
        Criterion::Long | Criterion::Short => Some(format!("{}\n{}", words[0], words[1])),
        Criterion::Some { before, after, printed: with_printed } => {
            let last: Vec<&str> = words[0].rsplit(' ').filter(|word| !word.is_empty()).take(before).collect();
            let first: Vec<&str> = words[1].split(' ').filter(|word| !word.is_empty()).take(after).collect();
            let is_whole = last.len() == before && first.len() == after;
            let says_something = last.iter().chain(&first).any(|word| *word != "#");
            let (printed, unit) = if with_printed { (printed, unit) } else { ("", "") };
            (is_whole && says_something).then(|| format!("{}\n{}\n{printed}\n{unit}", last.join(" "), first.join(" ")))
        }
        Criterion::Printed => {
            let digits = printed.bytes().filter(u8::is_ascii_digit).skip_while(|byte| *byte == b'0').count();
            (digits > 2).then(|| format!("{printed}\n{unit}"))
        }
    }
}

/// Finds the entries of a text in it.
pub(crate) fn place(entries: &[&Entry], text: &NumberedText) -> Placement {
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
                Criterion::Short => &surroundings[at].short,
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
    entries: &[&Entry],
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
        if !matches!(criterion, Criterion::Long | Criterion::Short) {
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
