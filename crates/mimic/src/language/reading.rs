//! How cards are read into a deck.

use super::card::{CardLayout, Fields, LONGEST, fields, is_comment};
use super::control::reserved_meaning;
use super::diagnostic::{Diagnostic, Diagnostics, MOST_FAULTS, Problem};
use super::expression::{Problems, expression, list, mismatch};
use super::graph::Graph;
use super::token::PlacedToken;
use super::tree::{
    CardExpression, DataCard, Deck, ExpressionCard, ExpressionNode, NameCard, PlotCards, Statement, Word,
};
use std::collections::HashSet;

/// Most lines of a deck up to its END, and most names, numbers and signs on them.
const MOST_CARDS: usize = 110_000;
const MOST_WORDS: usize = 910_000;
/// Most lines of a deck and its data that can be shown in a message.
const MOST_LINES: usize = MOST_CARDS + super::data::MOST_NUMBERS + 1;

impl Deck {
    /// Reads a deck and the data cards behind it.
    ///
    /// # Errors
    ///
    /// All that is wrong with its cards, each looked at by itself; then also names that no card defines, and names that
    /// are defined twice. Whatever else is wrong with cards that fit together badly, [`Program::new`](super::Program::new)
    /// tells.
    pub fn read(text: &str, layout: CardLayout) -> Result<Self, Diagnostics> {
        let mut reading = DeckReader {
            deck: Self::empty(text),
            faults: Vec::new(),
            lost: HashSet::new(),
            headings: Vec::new(),
            has_lost_output: false,
            has_end_card: false,
            has_print_card: false,
        };
        let mut ended = false;
        let mut lines = text.lines().enumerate().map(|(at, line)| (at + 1, line));
        let mut words = 0;
        while !ended && let Some((number, line)) = lines.next() {
            let card: Vec<char> = without_page_breaks(line.trim_end()).collect();
            words += if is_comment(&card, layout) { 0 } else { words_on(&card) };
            let too_large = if number > MOST_CARDS {
                Some(Problem::TooManyCards(MOST_CARDS))
            } else {
                (words > MOST_WORDS).then_some(Problem::TooManyWords(MOST_WORDS))
            };
            if let Some(problem) = too_large {
                let fault = reading.deck.fault(number, 0..1, problem);
                return Err(Diagnostics(reading.faults.into_iter().chain([fault]).collect()));
            }
            if is_comment(&card, layout) {
                reading.note_a_hidden_statement(number, &card, layout);
            } else if !card.iter().all(|sign| sign.is_whitespace()) {
                ended = reading.card(number, &card, layout);
            }
        }
        reading.deck.data = DataCard::read_all(lines);
        reading.whole(ended);
        if !reading.faults.is_empty() {
            reading.add_what_else_is_wrong();
        }
        Diagnostics::check(reading.faults)?;
        Ok(reading.deck)
    }

    fn empty(text: &str) -> Self {
        Self {
            cards: text.lines().take(MOST_LINES).map(|line| without_page_breaks(line).collect()).collect(),
            statements: Vec::new(),
            groups: Vec::new(),
            finishes: Vec::new(),
            headings: Vec::new(),
            outputs: Vec::new(),
            output_cards: Vec::new(),
            plots: Vec::new(),
            data: Vec::new(),
            data_file: None,
            notes: Vec::new(),
            hidden_c: None,
        }
    }
}

/// The signs of a line. A page break, which a copy of a longer text may have, is a blank.
fn without_page_breaks(line: &str) -> impl Iterator<Item = char> {
    line.chars().map(|sign| if sign == '\u{c}' { ' ' } else { sign })
}

/// How many names, numbers and signs are on a card, of those that can be read.
fn words_on(card: &[char]) -> usize {
    let is_word = |sign: char| sign.is_alphanumeric() || sign == '.';
    let readable = &card[..card.len().min(LONGEST)];
    let begins = |(at, sign): &(usize, &char)| !is_word(**sign) || *at == 0 || !is_word(readable[*at - 1]);
    readable.iter().enumerate().filter(|(_, sign)| !sign.is_whitespace()).filter(begins).count()
}

/// A deck while it is read.
struct DeckReader {
    deck: Deck,
    faults: Vec<Diagnostic>,
    /// Whether there is a FIN card, and an OUT or PLO card, be it one that cannot be read.
    has_end_card: bool,
    has_print_card: bool,
    /// Names on cards that could not be read: they may have been defined there.
    lost: HashSet<String>,
    /// The HDR cards, and whether there is an OUT card that could not be read.
    headings: Vec<(usize, Word)>,
    has_lost_output: bool,
}

impl DeckReader {
    fn all(&mut self, card: usize, problems: Problems) {
        let room = MOST_FAULTS.saturating_sub(self.faults.len());
        for (columns, problem) in problems.into_iter().take(room) {
            let fault = self.deck.fault(card, columns, problem);
            self.faults.push(fault);
        }
    }

    /// Reads a card; whether it was END.
    fn card(&mut self, number: usize, card: &[char], layout: CardLayout) -> bool {
        match fields(card, layout) {
            Err(problems) => {
                let (tokens, _) = super::token::tokens(card, 0..card.len().min(LONGEST));
                let first = tokens.first().and_then(PlacedToken::name).unwrap_or("");
                self.seen(first);
                self.has_lost_output |= first == "OUT";
                self.lost.extend(tokens.iter().filter_map(PlacedToken::name).map(str::to_owned));
                self.all(number, problems);
            }
            Ok(Fields::Statement { control, result, expression: tokens }) => {
                if let Some(what) = reserved_meaning(&result.name) {
                    let problem = Problem::Reserved { name: result.name.clone(), what };
                    self.all(number, vec![(result.at.clone(), problem)]);
                }
                match expression(&tokens, card.len()) {
                    Ok(expression) => {
                        self.deck.statements.push(Statement { card: number, control, result, expression });
                    }
                    Err(problems) => {
                        // The name is defined all the same: those who use it are not to blame.
                        let expression = CardExpression::number(1.0, 0..0);
                        self.deck.statements.push(Statement { card: number, control, result, expression });
                        for (_, problem) in &problems {
                            if let Problem::CardInExpression(word) = problem {
                                self.seen(word);
                            }
                        }
                        self.all(number, problems);
                    }
                }
            }
            Ok(Fields::Control { word, rest }) => return self.control(number, &word, &rest, card),
        }
        false
    }

    fn seen(&mut self, word: &str) {
        self.has_end_card |= word == "FIN";
        self.has_print_card |= word == "OUT" || word == "PLO";
    }

    fn control(&mut self, card: usize, word: &Word, rest: &[PlacedToken], text: &[char]) -> bool {
        self.seen(&word.name);
        match word.name.as_str() {
            "END" => return true,
            "CON" | "PAR" => {
                if let Some(names) = self.names(card, word, rest, text, 1) {
                    for name in &names {
                        if let Some(what) = reserved_meaning(&name.name) {
                            let problem = Problem::Reserved { name: name.name.clone(), what };
                            self.all(card, vec![(name.at.clone(), problem)]);
                        }
                    }
                    self.deck.groups.push(NameCard { card, each_run: word.name == "PAR", names });
                }
            }
            "OUT" => match self.names(card, word, rest, text, 1) {
                Some(names) => {
                    self.deck.outputs.push(names);
                    self.deck.output_cards.push(card);
                }
                None => self.has_lost_output = true,
            },
            "PLO" => {
                if let Some(names) = self.names(card, word, rest, text, 2) {
                    self.deck.plots.push(PlotCards { card, names, scale: None, zero: None });
                }
            }
            "HDR" => self.heading(card, word, text),
            _ => match list(rest, text.len()) {
                Ok(expressions) => self.listed(card, word, expressions),
                Err(problems) => self.all(card, problems),
            },
        }
        false
    }

    /// The names between parentheses.
    fn names(
        &mut self,
        card: usize,
        word: &Word,
        rest: &[PlacedToken],
        text: &[char],
        least: usize,
    ) -> Option<Vec<Word>> {
        let read = list(rest, text.len());
        let expressions = read
            .map_err(|problems| {
                self.lost.extend(rest.iter().filter_map(PlacedToken::name).map(str::to_owned));
                self.all(card, problems);
            })
            .ok()?;
        let mut names = Vec::new();
        for expression in &expressions {
            match &expression.nodes[..] {
                [(ExpressionNode::Name(name), at)] => names.push(Word { name: name.clone(), at: at.clone() }),
                _ => {
                    let found = "an expression".to_owned();
                    let problem = Problem::Expected { expected: "a name", found };
                    self.all(card, vec![(expression.columns(), problem)]);
                    return None;
                }
            }
        }
        if names.len() < least {
            let allowed = "two names or more: X, and what is plotted against it".to_owned();
            self.count(card, word, names.len(), allowed);
            return None;
        }
        Some(names)
    }

    fn count(&mut self, card: usize, word: &Word, given: usize, allowed: String) {
        let problem = Problem::Arguments { name: word.name.clone(), given: given.to_string(), allowed };
        self.all(card, vec![(word.at.clone(), problem)]);
    }

    /// The words of a heading: whatever stands between the parentheses and the commas.
    fn heading(&mut self, card: usize, word: &Word, text: &[char]) {
        let text: String = text[word.at.end..].iter().collect();
        let text = text.trim();
        match text.strip_prefix('(').and_then(|text| text.strip_suffix(')')) {
            Some(inside) => {
                self.deck.headings.push(inside.split(',').map(|word| word.trim().replace('\t', " ")).collect());
                self.headings.push((card, word.clone()));
            }
            None => {
                let end = word.at.end + text.chars().count();
                self.all(card, vec![(end..end + 1, mismatch("a closing parenthesis", None))]);
            }
        }
    }

    /// FIN, SCA and ZER.
    fn listed(&mut self, card: usize, word: &Word, expressions: Vec<CardExpression>) {
        let given = expressions.len();
        let listed = ExpressionCard { card, expressions };
        if word.name == "FIN" {
            if given != 2 {
                return self.count(
                    card,
                    word,
                    given,
                    "two: the run ends when the first has reached the second".to_owned(),
                );
            }
            return self.deck.finishes.push(listed);
        }
        let Some(plot) = self.deck.plots.last_mut() else {
            let card_name = if word.name == "SCA" { "SCA" } else { "ZER" };
            return self.all(card, vec![(word.at.clone(), Problem::WithoutPlot { card: card_name })]);
        };
        let wanted = plot.names.len();
        let place = if word.name == "SCA" { &mut plot.scale } else { &mut plot.zero };
        if place.is_some() {
            let card_name = if word.name == "SCA" { "SCA" } else { "ZER" };
            return self.all(card, vec![(word.at.clone(), Problem::WithoutPlot { card: card_name })]);
        }
        *place = Some(listed);
        if given != wanted {
            self.count(card, word, given, format!("{wanted}, one for each name of its PLO card"));
        }
    }

    /// A comment that reads as a statement is told: a C in column 1 may be meant for a name.
    fn note_a_hidden_statement(&mut self, number: usize, card: &[char], layout: CardLayout) {
        if !matches!(card.first(), Some('C' | 'c')) {
            return;
        }
        let hidden = match layout {
            CardLayout::Free => {
                let (tokens, problems) = super::token::tokens(card, 1..card.len());
                let tokens = &tokens[usize::from(tokens.first().is_some_and(|first| first.is('=')))..];
                let is_expression = problems.is_empty() && !tokens.is_empty() && expression(tokens, card.len()).is_ok();
                is_expression.then(|| "to define C".to_owned())
            }
            // A C with blanks behind it is a card that was taken out.
            CardLayout::Columns if card.get(1).is_none_or(|next| next.is_whitespace()) => None,
            CardLayout::Columns => match fields(card, layout) {
                Ok(Fields::Control { word, .. }) => Some(format!("a {} card", word.name)),
                Ok(Fields::Statement { control: Some(control), expression: tokens, .. }) => {
                    expression(&tokens, card.len()).is_ok().then(|| format!("to count under {}", control.name))
                }
                _ => None,
            },
        };
        if let Some(meant) = hidden {
            let note = format!(
                "card {number} is a comment, because it has a C in column 1; if it is {meant}, begin it in column 2"
            );
            if layout == CardLayout::Free {
                self.deck.hidden_c.get_or_insert_with(|| note.clone());
            }
            self.deck.notes.push(note);
        }
    }

    /// Faults that are no consequence of those that were found: so that all can be mended at once.
    fn add_what_else_is_wrong(&mut self) {
        let graph = Graph::new(&self.deck);
        let is_another = |fault: &Diagnostic| match &fault.problem {
            Problem::UnknownName { name, .. } => !self.lost.contains(name),
            Problem::DefinedTwice { .. } => true,
            _ => false,
        };
        self.faults.extend(graph.faults.into_iter().filter(is_another));
    }

    /// What a deck must have.
    fn whole(&mut self, ended: bool) {
        let (has_end_card, has_print_card) = (self.has_end_card, self.has_print_card);
        let mut missing = |card, why| {
            let problem = Problem::Missing { card, why };
            self.faults.push(Diagnostic { file: None, card: 0, columns: 0..0, text: String::new(), problem });
        };
        if !ended {
            missing("END", "put one after the last card, and data cards after it");
        }
        if !has_end_card {
            missing("FIN", "say when a run ends, such as FIN(T,10.)");
        }
        if !has_print_card {
            missing("OUT", "say what to print, such as OUT(T,X)");
        }
        let headings = if self.has_lost_output { Vec::new() } else { core::mem::take(&mut self.headings) };
        for (number, (card, word)) in headings.iter().enumerate() {
            let given = self.deck.headings.get(number).map_or(0, Vec::len);
            let wanted = self.deck.outputs.get(number).map(Vec::len);
            if wanted != Some(given) {
                let allowed = match wanted {
                    Some(wanted) => format!("{wanted}, one for each name of the OUT card of the same number"),
                    None => format!("none, because there is no OUT card with its number, {}", number + 1),
                };
                self.count(*card, word, given, allowed);
            }
        }
    }
}
