//! Which number of a text an entry means: by the words around it, so that edits elsewhere change nothing.

use crate::alignment::aligned;
use crate::numbered_text::{NumberedText, PrintedNumber, WORDS};
use crate::record_file::{NumberEntry, Place};
use std::collections::{HashMap, HashSet};

/// Most numbers of a row that is followed to another place.
const LONGEST_ROW: usize = 64;

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
    /// All words that are recorded, of a description in many words or in few, and perhaps the printed characters. The words must say
    /// where the number is.
    All { long: bool, printed: bool },
    /// The order, where there are hardly words.
    Order,
    /// So many words before and after, and perhaps the printed characters.
    Some { before: usize, after: usize, printed: bool },
    /// The printed characters alone, between words that say something.
    Printed,
}

/// From the surest to the least sure. Each looks at what those before it have left.
const CRITERIA: [Criterion; 15] = [
    Criterion::All { long: true, printed: true },
    Criterion::All { long: false, printed: true },
    Criterion::All { long: true, printed: false },
    Criterion::All { long: false, printed: false },
    Criterion::Order,
    Criterion::Some { before: 3, after: 2, printed: true },
    Criterion::Some { before: 3, after: 0, printed: true },
    Criterion::Some { before: 0, after: 3, printed: true },
    Criterion::Some { before: 3, after: 1, printed: false },
    Criterion::Some { before: 1, after: 3, printed: false },
    Criterion::Some { before: 3, after: 0, printed: false },
    Criterion::Some { before: 0, after: 3, printed: false },
    Criterion::Some { before: 1, after: 0, printed: true },
    Criterion::Some { before: 0, after: 1, printed: true },
    Criterion::Printed,
];

/// The words nearest to a number: the last of those before it, or the first of those after it.
fn nearest_words(words: [&str; 2], most: [usize; 2]) -> [Vec<&str>; 2] {
    let last = words[0].rsplit(' ').filter(|word| !word.is_empty()).take(most[0]).collect();
    let first = words[1].split(' ').filter(|word| !word.is_empty()).take(most[1]).collect();
    [last, first]
}

/// Whether the words around a number say where it is. Between the cells of a table there are only numbers, so a row that comes in
/// gives each of them the words of another.
fn say_where(words: [&str; 2]) -> bool {
    /// Fewest words that are no numbers.
    const FEWEST: usize = 4;
    let near = nearest_words(words, WORDS[0]);
    let is_word = |word: &&&str| **word != "#";
    // The heads of a table's columns are before each row that may be its first.
    let heads_a_row = !near[1].is_empty() && near[1].iter().filter(is_word).count() == 0;
    near.iter().flatten().filter(is_word).count() >= FEWEST && !heads_a_row
}

/// What identifies a number under a criterion; none if it has too few words.
fn key(criterion: Criterion, words: [&str; 2], printed: &str, unit: &str) -> Option<String> {
    let characters = |with_printed: bool| if with_printed { format!("{printed}\n{unit}") } else { String::new() };
    match criterion {
        Criterion::All { printed, .. } => {
            say_where(words).then(|| format!("{}\n{}\n{}", words[0], words[1], characters(printed)))
        }
        Criterion::Order => None,
        Criterion::Some { before, after, printed } => {
            let [last, first] = nearest_words(words, [before, after]);
            let is_whole = last.len() == before && first.len() == after;
            let says_something = last.iter().chain(&first).any(|word| *word != "#");
            let join = |words: Vec<&str>| words.join(" ");
            (is_whole && says_something).then(|| format!("{}\n{}\n{}", join(last), join(first), characters(printed)))
        }
        Criterion::Printed => {
            let digits = printed.bytes().filter(u8::is_ascii_digit).skip_while(|byte| *byte == b'0').count();
            (say_where(words) && digits > 2).then(|| characters(true))
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
        if matches!(criterion, Criterion::Order) {
            place_by_order(entries, numbers, &surroundings, &mut placement);
            continue;
        }
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

/// Pairs entries with numbers that have hardly words around them: those in the same order in the record and in the text, those
/// between them, and rows that were moved as a whole.
fn place_by_order(
    entries: &[&NumberEntry],
    numbers: &[PrintedNumber],
    surroundings: &[Surroundings],
    placement: &mut Placement,
) {
    let mine: Vec<usize> = (0..entries.len()).filter(|at| placement.of_entry[*at].is_none()).collect();
    let found: Vec<usize> = (0..numbers.len()).filter(|at| placement.of_number[*at].is_none()).collect();
    let words = |at: usize| [&*surroundings[at].long[0], &*surroundings[at].long[1]];
    let old: Vec<(&str, &str)> = mine.iter().map(|at| (&*entries[*at].printed, &*entries[*at].unit)).collect();
    let new: Vec<(&str, &str)> = found.iter().map(|at| (&*numbers[*at].printed, &*numbers[*at].unit)).collect();
    for (one, other, is_sure) in aligned(&old, &new) {
        let (entry, number) = (mine[one], found[other]);
        let say = [say_where([&entries[entry].before, &entries[entry].after]), say_where(words(number))];
        // Where there are words, those that follow say more.
        let counts = if old[one] == new[other] { say != [true; 2] } else { say == [false; 2] };
        if counts {
            placement.of_entry[entry] = Some(number);
            placement.of_number[number] = Some(entry);
            placement.is_ambiguous[entry] = !is_sure && old[one] != new[other];
        }
    }
    // A row that begins behind the same word as before, or with a number, and has the same numbers up to its end.
    let mut rows: HashMap<Vec<(&str, &str)>, Vec<usize>> = HashMap::new();
    let mut at = 0;
    while at < found.len() {
        let length = 1 + found[at + 1..].iter().take_while(|number| !numbers[**number].opens_row).count();
        let row = at..at + length;
        let is_whole = numbers[found[at]].opens_row
            && found[row.end - 1] - found[at] + 1 == length
            && numbers.get(found[row.end - 1] + 1).is_none_or(|next| next.opens_row);
        if is_whole && row.clone().all(|at| placement.of_number[found[at]].is_none()) {
            rows.entry(new[row].to_vec()).or_default().push(found[at]);
        }
        at += length;
    }
    let label = |words: &str| words.rsplit(' ').next().unwrap_or_default().to_owned();
    let mut lengths: Vec<usize> = rows.keys().map(Vec::len).filter(|length| *length <= LONGEST_ROW).collect();
    lengths.sort_unstable();
    lengths.dedup();
    let first: HashSet<(&str, &str)> = rows.keys().filter_map(|row| row.first().copied()).collect();
    for start in (0..mine.len()).filter(|at| first.contains(&old[*at])) {
        for length in lengths.iter().rev().filter(|length| start + **length <= mine.len()) {
            let run = start..start + length;
            if run.clone().any(|at| placement.of_entry[mine[at]].is_some()) {
                continue;
            }
            let Some(places) = rows.get_mut(&old[run.clone()]) else { continue };
            let before = label(&entries[mine[start]].before);
            // A row that has no name is known by its numbers, if it has several.
            let fits = |number: &usize| match numbers[*number].is_named {
                true => label(words(*number)[0]) == before,
                false => *length > 1,
            };
            let Some(place) = places.iter().position(fits) else { continue };
            let first = places.swap_remove(place);
            for (offset, at) in run.enumerate() {
                placement.of_entry[mine[at]] = Some(first + offset);
                placement.of_number[first + offset] = Some(mine[at]);
            }
            break;
        }
    }
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
