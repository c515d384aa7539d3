//! The sentences of a text that could be claims, with their places.

use geneva_evidence::number_tokens;

/// A sentence whose numbers stand in one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Sentence {
    /// Its characters, with single spaces.
    pub text: String,
    /// The line that has its numbers, from 0; its first line if it has none.
    pub line: usize,
    /// Where its part in that line begins, in bytes of what the line shows.
    pub at: usize,
}

impl Sentence {
    /// Whether it says a number, in digits or in a word.
    pub(super) fn has_numbers(&self) -> bool {
        !number_tokens(&self.text).is_empty()
    }

    /// Whether it says a number in digits.
    pub(super) fn has_digits(&self) -> bool {
        self.text.contains(|c: char| c.is_ascii_digit())
    }

    /// Whether it says something of a figure.
    pub(super) fn names_a_figure(&self) -> bool {
        let mut words = self.text.split(|c: char| !c.is_alphabetic());
        words.any(|word| ["figure", "figures", "fig", "figs"].contains(&word.to_lowercase().as_str()))
    }
}

/// Fewest words, and most characters, of a sentence that is offered.
const FEWEST_WORDS: usize = 5;
const LONGEST: usize = 240;

/// Signs of markup and of formulas, which a sentence in plain words has not.
const MARKUP: [char; 15] = ['$', '\\', '=', '|', '<', '>', '{', '}', '[', ']', '*', '_', '^', '~', '`'];

/// Words behind which a point ends no sentence.
const ABBREVIATED: [&str; 19] = [
    "fig", "figs", "eq", "eqs", "e.g", "i.e", "vs", "approx", "no", "dr", "mr", "mrs", "prof", "sec", "ch", "p", "pp",
    "cf", "al",
];

/// The sentences in plain words that begin with a capital letter, in their order.
pub(super) fn sentences(shown: &[String]) -> Vec<Sentence> {
    let (mut found, mut paragraph) = (Vec::new(), Vec::new());
    for (number, line) in shown.iter().enumerate() {
        let words = line.trim();
        let is_heading = words.starts_with('#');
        if words.is_empty() || is_heading {
            end(&mut paragraph, &mut found);
        }
        if !is_heading {
            paragraph.extend(line.char_indices().map(|(at, c)| (c, number, at)));
            paragraph.push((' ', number, line.len()));
        }
    }
    end(&mut paragraph, &mut found);
    found
}

/// A character with its line and its byte there.
type Placed = (char, usize, usize);

/// Takes the sentences of a paragraph.
fn end(paragraph: &mut Vec<Placed>, found: &mut Vec<Sentence>) {
    let mut start = 0;
    for at in 0..paragraph.len() {
        if ends_sentence(paragraph, start, at) {
            found.extend(sentence(&paragraph[start..=at]));
            start = at + 1;
        }
    }
    paragraph.clear();
}

fn ends_sentence(paragraph: &[Placed], start: usize, at: usize) -> bool {
    let is_mark = ".?!".contains(paragraph[at].0);
    let mut behind = paragraph[at + 1..].iter().map(|(c, ..)| *c);
    if !is_mark || behind.next().is_some_and(|c| !c.is_whitespace()) {
        return false;
    }
    if behind.find(|c| !c.is_whitespace()).is_some_and(char::is_lowercase) {
        return false;
    }
    let before: String = paragraph[start..at].iter().map(|(c, ..)| *c).collect();
    let word = before.rsplit(|c: char| c.is_whitespace() || c == '(').next().unwrap_or_default().to_lowercase();
    // A letter with a point is an initial.
    let is_initial = word.chars().count() == 1 && word.chars().all(char::is_alphabetic);
    !(is_initial || ABBREVIATED.contains(&word.as_str()))
}

fn sentence(placed: &[Placed]) -> Option<Sentence> {
    let begins = placed.iter().position(|(c, ..)| !c.is_whitespace())?;
    let placed = &placed[begins..];
    let whole: String = placed.iter().map(|(c, ..)| *c).collect();
    let text = whole.split_whitespace().collect::<Vec<_>>().join(" ");
    let is_plain = text.starts_with(char::is_uppercase) && !text.contains(MARKUP) && !text.contains(char::is_control);
    if !is_plain || text.split(' ').count() < FEWEST_WORDS || text.chars().count() > LONGEST {
        return None;
    }
    let (first, last) = (placed.first()?.1, placed.last()?.1);
    let part = |line: usize| placed.iter().filter(|(_, own, _)| *own == line).map(|(c, ..)| *c).collect::<String>();
    let mut with_numbers = (first..=last).filter(|line| !number_tokens(&part(*line)).is_empty());
    let line = with_numbers.next().unwrap_or(first);
    // A number that is cut by the end of a line is another one there.
    if with_numbers.next().is_some() || number_tokens(&part(line)) != number_tokens(&text) {
        return None;
    }
    let at = placed.iter().find(|(_, own, _)| *own == line)?.2;
    Some(Sentence { text, line, at })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_end_where_a_reader_ends_them_and_keep_their_lines() {
        let text = "# Part 2. Of what\nIt is seen in Fig. 3. The fall takes\n2.5 s in all, says\nA. Smith. This is $x$ here now.\n\n\
                    Four of the 5\nare 7 and 8 long.";
        let shown: Vec<String> = text.lines().map(str::to_owned).collect();
        let found = sentences(&shown);
        let said: Vec<(&str, usize, usize)> =
            found.iter().map(|sentence| (sentence.text.as_str(), sentence.line, sentence.at)).collect();
        assert_eq!(said, [("It is seen in Fig. 3.", 1, 0), ("The fall takes 2.5 s in all, says A. Smith.", 2, 0)]);
        assert!(found[0].names_a_figure() && !found[1].names_a_figure() && found[1].has_digits());
    }
}
