//! The words that say a number: the one list of them, for the inventories and for the sentences that are checked.
//!
//! A word is on the list if another word of the list in its place would say how many, which one, how often or which part
//! differently. *One* is always on it, though it often only points at something: the inventory says which it is. *Both*
//! and *pair* say two. *Second* is on it, because it is an ordinal as often as a unit of time. *Seconds* is always the
//! unit, so it isn't. *Couple* isn't either: in mechanics it is a torque. Words that only compare or deny, such as
//! *several*, *next* and *no*, say no number, and the Roman numerals of chapters are no words.

/// Cardinal numbers.
const CARDINALS: [(&str, f64); 31] = [
    ("zero", 0.0),
    ("one", 1.0),
    ("two", 2.0),
    ("three", 3.0),
    ("four", 4.0),
    ("five", 5.0),
    ("six", 6.0),
    ("seven", 7.0),
    ("eight", 8.0),
    ("nine", 9.0),
    ("ten", 10.0),
    ("eleven", 11.0),
    ("twelve", 12.0),
    ("thirteen", 13.0),
    ("fourteen", 14.0),
    ("fifteen", 15.0),
    ("sixteen", 16.0),
    ("seventeen", 17.0),
    ("eighteen", 18.0),
    ("nineteen", 19.0),
    ("twenty", 20.0),
    ("thirty", 30.0),
    ("forty", 40.0),
    ("fifty", 50.0),
    ("sixty", 60.0),
    ("seventy", 70.0),
    ("eighty", 80.0),
    ("ninety", 90.0),
    ("hundred", 1e2),
    ("thousand", 1e3),
    ("million", 1e6),
];

/// Ordinal numbers. In the plural they are fractions.
const ORDINALS: [(&str, f64); 23] = [
    ("first", 1.0),
    ("second", 2.0),
    ("third", 3.0),
    ("fourth", 4.0),
    ("fifth", 5.0),
    ("sixth", 6.0),
    ("seventh", 7.0),
    ("eighth", 8.0),
    ("ninth", 9.0),
    ("tenth", 10.0),
    ("eleventh", 11.0),
    ("twelfth", 12.0),
    ("thirteenth", 13.0),
    ("fourteenth", 14.0),
    ("fifteenth", 15.0),
    ("sixteenth", 16.0),
    ("seventeenth", 17.0),
    ("eighteenth", 18.0),
    ("nineteenth", 19.0),
    ("twentieth", 20.0),
    ("hundredth", 1e2),
    ("thousandth", 1e3),
    ("millionth", 1e6),
];

/// Fractions and multiples. In this order no two neighbours say the same.
const OTHERS: [(&str, f64); 11] = [
    ("half", 0.5),
    ("quarter", 0.25),
    ("single", 1.0),
    ("double", 2.0),
    ("triple", 3.0),
    ("once", 1.0),
    ("twice", 2.0),
    ("thrice", 3.0),
    ("both", 2.0),
    ("dozen", 12.0),
    ("pair", 2.0),
];

/// All words of the list in the singular, each with its number.
fn words() -> impl Iterator<Item = (&'static str, f64)> {
    CARDINALS.into_iter().chain(ORDINALS).chain(OTHERS)
}

/// The number that a word says, in the singular or in the plural, in large or in small letters.
pub fn number_in_word(word: &str) -> Option<f64> {
    let word = word.to_ascii_lowercase();
    let says = |wanted: &str| words().find(|(other, _)| *other == wanted).map(|(_, number)| number);
    let (number, singular) = (says(&word), singular(&word));
    match (number, ORDINALS.iter().find(|(ordinal, _)| *ordinal == singular)) {
        (Some(number), _) => Some(number),
        (None, Some(("second", _))) => None,
        (None, Some((_, parts))) => Some(1.0 / parts),
        (None, None) => says(singular),
    }
}

/// The next word of the list, in the singular; none if the word is not on it.
pub fn next_number_word(word: &str) -> Option<&'static str> {
    number_in_word(word)?;
    let word = word.to_ascii_lowercase();
    let all: Vec<_> = words().map(|(word, _)| word).collect();
    let at = all.iter().position(|other| *other == word || *other == singular(&word))?;
    all.get((at + 1) % all.len()).copied()
}

/// The singular of a word in small letters, if it has the ending of a plural.
fn singular(word: &str) -> &str {
    if word == "halves" { "half" } else { word.strip_suffix('s').unwrap_or(word) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_say_their_numbers_in_the_singular_and_in_the_plural() {
        for (word, number) in [
            ("zero", 0.0),
            ("FOUR", 4.0),
            ("Eighteen", 18.0),
            ("ones", 1.0),
            ("hundreds", 100.0),
            ("second", 2.0),
            ("thirds", 1.0 / 3.0),
            ("half", 0.5),
            ("halves", 0.5),
            ("quarters", 0.25),
            ("twice", 2.0),
            ("both", 2.0),
        ] {
            assert_eq!(number_in_word(word), Some(number), "{word}");
        }
        for word in ["", "s", "seconds", "couple", "someone", "none", "next", "several", "no", "II"] {
            assert_eq!(number_in_word(word), None, "{word}");
            assert_eq!(next_number_word(word), None, "{word}");
        }
    }

    #[test]
    fn the_next_word_says_another_number() {
        let mut word = "zero";
        for _ in words() {
            let next = next_number_word(word).expect("a word of the list");
            assert_ne!(number_in_word(next), number_in_word(word), "{word}, {next}");
            word = next;
        }
        assert_eq!(word, "zero", "each word comes once");
        assert_eq!(next_number_word("Quarters"), Some("single"));
    }
}
