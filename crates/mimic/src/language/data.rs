//! Data cards: the numbers of the constants and parameters.

use super::diagnostic::{Diagnostic, Diagnostics, Problem};
use super::tree::{DataCard, DataFile, Deck, NameCard, Word};
use core::ops::Range;

/// Most runs of one deck.
const MOST_SETS: usize = 100_000;

/// Most numbers that the data of a deck and all its sets may have.
pub(super) const MOST_NUMBERS: usize = 500_000;
/// Most numbers of a data card that are read: more than the names of any CON or PAR card.
const MOST_ON_A_CARD: usize = super::card::LONGEST;

/// What is wrong where no number is.
const NO_NUMBER: &str = "not a number; write it as 2., .05 or 5.E-6, with blanks or commas between numbers";
const EMPTY_PLACE: &str = "no number before this comma; write one, such as 0., or leave the comma out";
const NO_NUMBER_BEHIND_END: &str = "not a number, and everything after END is data; write it as 2., .05 or 5.E-6, with \
                                    blanks or commas between, or put the card before END";

impl DataCard {
    /// Reads a card; none if it is empty, a comment or one that parts deck and data.
    pub(super) fn read(card: usize, line: &str) -> Option<Self> {
        let text = line.trim();
        let mark = text.trim_matches(['<', '>', '*']).to_ascii_uppercase();
        if text.is_empty() || line.starts_with(['*', '/']) || ["EOR", "EOF", "EOI"].contains(&mark.as_str()) {
            return None;
        }
        let signs: Vec<char> = line.chars().collect();
        let mut numbers = Vec::new();
        let mut at = 0;
        let mut is_empty_place = true;
        while at < signs.len() && numbers.len() <= MOST_ON_A_CARD {
            let parts = |sign: char| sign.is_whitespace() || sign == ',';
            let start = at;
            while at < signs.len() && !parts(signs[at]) {
                at += 1;
            }
            if at > start {
                let word: String = signs[start..at].iter().collect();
                let plain = word.chars().all(|sign| sign.is_ascii_digit() || "+-.eE".contains(sign));
                let number = word.parse().ok().filter(|number: &f64| plain && number.is_finite());
                numbers.push((number.ok_or(NO_NUMBER), start..at));
                is_empty_place = false;
            } else {
                at += 1;
                if signs[start] == ',' && core::mem::replace(&mut is_empty_place, true) {
                    numbers.push((Err(EMPTY_PLACE), start..at));
                }
            }
        }
        numbers.shrink_to_fit();
        Some(Self { card, numbers })
    }

    /// Reads the cards on numbered lines. It stops when there are more numbers than a deck may have.
    pub(super) fn read_all<'a>(lines: impl Iterator<Item = (usize, &'a str)>) -> Vec<Self> {
        let mut numbers = 0;
        let cards = lines.filter_map(|(number, line)| Self::read(number, line));
        let bounded = cards.take_while(|card| {
            let goes_on = numbers <= MOST_NUMBERS;
            numbers += card.weight();
            goes_on
        });
        bounded.collect()
    }

    /// How many numbers it counts for.
    fn weight(&self) -> usize {
        self.numbers.len().max(1)
    }
}

/// The numbers of one run, each under its name: those of the CON cards, then those of the PAR cards.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DataSet(pub Vec<(String, f64)>);

impl Deck {
    /// Takes the data cards of another text in place of those behind the deck. Faults tell it by its name.
    pub fn with_data(mut self, name: &str, text: &str) -> Self {
        self.data = DataCard::read_all(text.lines().enumerate().map(|(at, line)| (at + 1, line)));
        self.data_file = Some(DataFile { name: name.to_owned(), text: text.to_owned() });
        self
    }

    /// Whether there is a data card.
    pub fn has_data(&self) -> bool {
        !self.data.is_empty()
    }

    /// The runs that the data cards ask for. A deck without CON and PAR runs once.
    ///
    /// # Errors
    ///
    /// A number that is none, too few or too many of them.
    pub fn data_sets(&self) -> Result<Vec<DataSet>, Diagnostics> {
        let (constants, parameters): (Vec<_>, Vec<_>) = self.groups.iter().partition(|group| !group.each_run);
        let mut reader = DataReader { deck: self, next: 0 };
        if self.data.iter().map(DataCard::weight).sum::<usize>() > MOST_NUMBERS {
            let words =
                format!("the data have more than {MOST_NUMBERS} numbers up to here, the most that is read; split them");
            return Err(reader.refuse(self.data.len() - 1, 0..1, words));
        }
        let names = self.parameters().len();
        let constants = reader.read(&constants)?;
        let mut sets = Vec::new();
        while sets.is_empty() || (!parameters.is_empty() && reader.next < self.data.len()) {
            let own = reader.read(&parameters)?;
            sets.push(DataSet(constants.iter().cloned().chain(own).collect()));
            let numbers = sets.len() * names;
            if numbers > MOST_NUMBERS {
                let words = format!(
                    "with the CON names in every set, the sets have more than {MOST_NUMBERS} numbers up to here, which is \
                     the most; part the data"
                );
                return Err(reader.refuse(reader.next - 1, 0..1, words));
            }
            if sets.len() > MOST_SETS {
                return Err(reader.refuse(reader.next, 0..1, format!("more than {MOST_SETS} sets; split the data")));
            }
        }
        if reader.next < self.data.len() {
            let (words, columns) = match self.data[reader.next].numbers.first() {
                Some((Err(NO_NUMBER), columns)) => (self.no_number(), columns.clone()),
                _ => ("no card asks for these numbers; a PAR card reads a set for each run", 0..1),
            };
            return Err(reader.refuse(reader.next, columns, words.to_owned()));
        }
        Ok(sets)
    }

    /// What is wrong with a word among the data.
    fn no_number(&self) -> &'static str {
        if self.data_file.is_none() { NO_NUMBER_BEHIND_END } else { NO_NUMBER }
    }
}

/// Data cards as they are read, one behind another.
struct DataReader<'a> {
    deck: &'a Deck,
    next: usize,
}

impl DataReader<'_> {
    /// The numbers of some groups of names.
    fn read(&mut self, groups: &[&NameCard]) -> Result<Vec<(String, f64)>, Diagnostics> {
        let mut found = Vec::new();
        for group in groups {
            let mut names = group.names.iter();
            while names.len() > 0 {
                self.card(group, &mut names, &mut found)?;
            }
        }
        Ok(found)
    }

    /// The numbers of the next card, each for the next name.
    fn card(
        &mut self,
        group: &NameCard,
        names: &mut core::slice::Iter<'_, Word>,
        found: &mut Vec<(String, f64)>,
    ) -> Result<(), Diagnostics> {
        let Some(card) = self.deck.data.get(self.next) else {
            let name = names.as_slice().first().map_or("", |word| word.name.as_str());
            let count = match group.names.len() {
                1 => "1 name".to_owned(),
                names => format!("{names} names"),
            };
            return Err(match &self.deck.data_file {
                None => {
                    let words = format!(
                        "no number is left for {name}: the card has {count}, and as many numbers must follow END"
                    );
                    Diagnostics(vec![self.deck.fault(group.card, 0..1, Problem::Data(words))])
                }
                Some(file) => {
                    let words = format!(
                        "no number is left for {name}: card {} of the deck has {count}, and as many numbers must \
                         stand here",
                        group.card
                    );
                    let line = file.text.lines().count().max(1);
                    let end = file.text.lines().last().map_or(0, |line| line.trim_end().chars().count());
                    self.fault(line, end..end + 1, words)
                }
            });
        };
        for (number, columns) in &card.numbers {
            let number = number.map_err(|words| {
                let words = if words == NO_NUMBER { self.deck.no_number() } else { words };
                self.refuse(self.next, columns.clone(), words.to_owned())
            })?;
            let Some(word) = names.next() else {
                let words = format!(
                    "one number more than card {} {}has names; start a new data card for the numbers of another card",
                    group.card,
                    if self.deck.data_file.is_some() { "of the deck " } else { "" }
                );
                return Err(self.refuse(self.next, columns.clone(), words));
            };
            found.push((word.name.clone(), number));
        }
        self.next += 1;
        Ok(())
    }

    /// A fault on the data card of this number.
    fn refuse(&self, number: usize, columns: Range<usize>, words: String) -> Diagnostics {
        self.fault(self.deck.data.get(number).map_or(0, |card| card.card), columns, words)
    }

    /// A fault on a line of the data.
    fn fault(&self, card: usize, columns: Range<usize>, words: String) -> Diagnostics {
        let problem = Problem::Data(words);
        Diagnostics(vec![match &self.deck.data_file {
            None => self.deck.fault(card, columns, problem),
            Some(file) => {
                let text = card.checked_sub(1).and_then(|at| file.text.lines().nth(at)).unwrap_or_default().to_owned();
                Diagnostic { file: Some(file.name.clone()), card, columns, text, problem }
            }
        }])
    }
}
