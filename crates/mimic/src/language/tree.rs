//! The syntax tree: what stands on the cards of a deck once they are read.

use super::code::Operation;
use core::ops::Range;

/// A deck as it was read: every card is understood by itself, and nothing is known yet of how they fit together.
#[derive(Clone, Debug, PartialEq)]
pub struct Deck {
    pub(super) cards: Vec<String>,
    pub(super) statements: Vec<Statement>,
    pub(super) groups: Vec<NameCard>,
    pub(super) finishes: Vec<ExpressionCard>,
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

/// A statement: a result and its expression, perhaps under a control variable.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Statement {
    pub(super) card: usize,
    pub(super) control: Option<Word>,
    pub(super) result: Word,
    pub(super) expression: CardExpression,
}

/// The names of one CON or PAR card.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NameCard {
    pub(super) card: usize,
    /// Whether they are read for each run.
    pub(super) each_run: bool,
    pub(super) names: Vec<Word>,
}

/// A card with expressions.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ExpressionCard {
    pub(super) card: usize,
    pub(super) expressions: Vec<CardExpression>,
}

/// A PLO card, and the SCA and ZER cards behind it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlotCards {
    pub(super) card: usize,
    pub(super) names: Vec<Word>,
    pub(super) scale: Option<ExpressionCard>,
    pub(super) zero: Option<ExpressionCard>,
}

/// A name and its columns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Word {
    pub(super) name: String,
    pub(super) at: Range<usize>,
}

/// A part of an expression; numbers of nodes are those of earlier ones.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ExpressionNode {
    /// A number.
    Number(f64),
    /// A name.
    Name(String),
    /// The opposite of a node.
    Negative(usize),
    /// Two nodes and what is done with them.
    Binary(Operation, [usize; 2]),
    /// A function, by its place in the table, and its arguments.
    Call(usize, Vec<usize>),
}

impl ExpressionNode {
    /// The nodes that it needs.
    pub(super) fn parts(&self) -> &[usize] {
        match self {
            Self::Number(_) | Self::Name(_) => &[],
            Self::Negative(part) => core::slice::from_ref(part),
            Self::Binary(_, parts) => parts,
            Self::Call(_, arguments) => arguments,
        }
    }
}

/// An expression: the last node is the whole. It is never empty.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CardExpression {
    pub(super) nodes: Vec<(ExpressionNode, Range<usize>)>,
}

impl CardExpression {
    /// A number that stands alone.
    pub(super) fn number(value: f64, at: Range<usize>) -> Self {
        Self { nodes: vec![(ExpressionNode::Number(value), at)] }
    }

    /// The node of the whole.
    pub(super) fn root(&self) -> usize {
        self.nodes.len() - 1
    }

    /// The columns from its first sign to its last.
    pub(super) fn columns(&self) -> Range<usize> {
        let start = self.nodes.iter().map(|(_, at)| at.start).min().unwrap_or(0);
        start..self.nodes.iter().map(|(_, at)| at.end).max().unwrap_or(0)
    }

    /// The function that the whole is, if it is one.
    pub(super) fn whole_call(&self) -> Option<(usize, &[usize])> {
        match self.nodes.last() {
            Some((ExpressionNode::Call(function, arguments), _)) => Some((*function, arguments)),
            _ => None,
        }
    }
}

/// The numbers of one data card, with their columns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DataCard {
    pub(super) card: usize,
    /// Each number, or what is wrong where one should be.
    pub(super) numbers: Vec<(Result<f64, &'static str>, Range<usize>)>,
}

/// A text with data cards, by itself.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DataFile {
    pub(super) name: String,
    pub(super) text: String,
}
