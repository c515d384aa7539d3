//! What can be asked of a deck, and changed in it, between reading and compiling.

use super::control::STEPS;
use super::diagnostic::{Diagnostic, Problem};
use super::sorting::SortedStatement;
use super::tree::{CardExpression, Deck, ExpressionNode, Statement, Word};
use core::ops::Range;

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
    pub fn expression_of(&self, sorted: &SortedStatement) -> String {
        let own = self.statements.get(sorted.statement);
        let Some(own) = own.filter(|of| of.result.name == sorted.result) else { return String::new() };
        if let [(ExpressionNode::Number(number), _)] = own.expression.nodes[..] {
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
        statement.expression = CardExpression::number(value, statement.expression.columns());
        true
    }

    /// DT, DTMIN and DTMAX have a value without a card.
    fn set_step(&mut self, name: &str, value: f64) -> bool {
        let free = STEPS.contains(&name) && !self.statements.iter().any(|statement| statement.result.name == name);
        if free {
            let result = Word { name: name.to_owned(), at: 0..0 };
            let expression = CardExpression::number(value, 0..0);
            self.statements.push(Statement { card: 0, control: None, result, expression });
        }
        free
    }

    /// A fault at some columns of a card.
    pub(super) fn fault(&self, card: usize, columns: Range<usize>, problem: Problem) -> Diagnostic {
        let text = card.checked_sub(1).and_then(|at| self.cards.get(at)).cloned().unwrap_or_default();
        Diagnostic { file: None, card, columns, text, problem }
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
