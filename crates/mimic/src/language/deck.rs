//! A deck: statements, parameters, the end of the run, and what is printed and plotted.

use super::card::Word;
use super::control::STEPS;
use super::data::{DataCard, DataFile};
use super::expression::{Expression, Node};
use super::fault::{Fault, Problem};
use super::sorting::Sorted;
use core::ops::Range;

/// A statement: a result and its expression, perhaps under a control variable.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Statement {
    pub(super) card: usize,
    pub(super) control: Option<Word>,
    pub(super) result: Word,
    pub(super) expression: Expression,
}

/// The names of one CON or PAR card.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Group {
    pub(super) card: usize,
    /// Whether they are read for each run.
    pub(super) each_run: bool,
    pub(super) names: Vec<Word>,
}

/// A card with expressions.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Listed {
    pub(super) card: usize,
    pub(super) expressions: Vec<Expression>,
}

/// A PLO card, and the SCA and ZER cards behind it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlotCards {
    pub(super) card: usize,
    pub(super) names: Vec<Word>,
    pub(super) scale: Option<Listed>,
    pub(super) zero: Option<Listed>,
}

/// Plot of one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What is plotted against what: X, then the others.
    pub names: Vec<String>,
    /// Of each, the change from line to line or from column to column, in its own unit; none to choose it.
    pub scale: Option<Vec<f64>>,
    /// Of each, the value on the first line or in the first column, in its own unit; none to choose it.
    pub zero: Option<Vec<f64>>,
}

/// A deck as it was read: every card is understood by itself, and nothing is known yet of how they fit together.
#[derive(Clone, Debug, PartialEq)]
pub struct Deck {
    pub(super) cards: Vec<String>,
    pub(super) statements: Vec<Statement>,
    pub(super) groups: Vec<Group>,
    pub(super) finishes: Vec<Listed>,
    pub(super) headings: Vec<Vec<String>>,
    pub(super) outputs: Vec<Vec<Word>>,
    pub(super) output_cards: Vec<usize>,
    pub(super) plots: Vec<PlotCards>,
    pub(super) data: Vec<DataCard>,
    /// Where the data are from, if they do not stand behind the deck.
    pub(super) data_file: Option<DataFile>,
    pub(super) notes: Vec<String>,
    /// The note of a comment that could define C.
    pub(super) hidden_c: Option<String>,
}

impl Deck {
    /// Notes on a deck without mistakes: comments that could be statements.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The names of the CON cards, then those of the PAR cards, in the order of their data.
    pub fn parameters(&self) -> Vec<&str> {
        let of = |each_run: bool| self.groups.iter().filter(move |group| group.each_run == each_run);
        of(false).chain(of(true)).flat_map(|group| group.names.iter().map(|word| word.name.as_str())).collect()
    }

    /// The names that a statement defines, and those of the steps, in the order of the cards.
    pub fn results(&self) -> impl Iterator<Item = &str> {
        self.statements.iter().map(|statement| statement.result.name.as_str()).chain(STEPS)
    }

    /// The expression of a statement as its card has it; the number alone if it has been [`set`](Self::set).
    pub fn expression_of(&self, sorted: &Sorted) -> String {
        let own = self.statements.get(sorted.statement);
        let Some(own) = own.filter(|of| of.result.name == sorted.result) else { return String::new() };
        if let [(Node::Number(number), _)] = own.expression.nodes[..] {
            return number.to_string();
        }
        let text = own.card.checked_sub(1).and_then(|at| self.cards.get(at)).map_or("", String::as_str);
        // From the first sign behind the fields on: parentheses are no part of the nodes.
        let start = [Some(&own.result), own.control.as_ref()].into_iter().flatten().map(|word| word.at.end).max();
        let text: String = text.chars().skip(start.unwrap_or(0)).collect();
        text.trim_start_matches([' ', '\t', '=']).trim_end().replace('\t', " ")
    }

    /// Defines a name as a number, in place of its card: the only one that defines it, and under no control variable.
    ///
    /// False if there is no such card; nothing is changed then.
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        let mut own = self.statements.iter_mut().filter(|statement| statement.result.name == name);
        let (Some(statement), None) = (own.next(), own.next()) else {
            return self.set_step(name, value);
        };
        if statement.control.is_some() {
            return false;
        }
        statement.expression = Expression::number(value, statement.expression.columns());
        true
    }

    /// DT, DTMIN and DTMAX have a value without a card.
    fn set_step(&mut self, name: &str, value: f64) -> bool {
        let free = STEPS.contains(&name) && !self.statements.iter().any(|statement| statement.result.name == name);
        if free {
            let result = Word { name: name.to_owned(), at: 0..0 };
            let expression = Expression::number(value, 0..0);
            self.statements.push(Statement { card: 0, control: None, result, expression });
        }
        free
    }

    /// A fault at some columns of a card.
    pub(super) fn fault(&self, card: usize, columns: Range<usize>, problem: Problem) -> Fault {
        let text = card.checked_sub(1).and_then(|at| self.cards.get(at)).cloned().unwrap_or_default();
        Fault { file: None, card, columns, text, problem }
    }
}

/// The deck in a text that has it among other things: from its first CON or PAR card to its END card.
///
/// ```
/// use geneva_mimic::language::listing_in;
///
/// let text = "A program follows.\nCON(K)\nFIN(T,K)\nEND\nIt was run once.\n";
/// assert_eq!(listing_in(text), Some("CON(K)\nFIN(T,K)\nEND\n"));
/// assert_eq!(listing_in("No program."), None);
/// ```
pub fn listing_in(text: &str) -> Option<&str> {
    let lines = || {
        text.split_inclusive('\n').scan(0, |end, line| {
            let start = *end;
            *end += line.len();
            Some((start, *end, line.trim()))
        })
    };
    let opens = |line: &str| ["CON(", "PAR("].iter().any(|word| line.starts_with(word));
    let (start, ..) = lines().find(|(_, _, line)| opens(line))?;
    let (_, end, _) = lines().find(|(at, _, line)| *at > start && *line == "END")?;
    Some(&text[start..end])
}
