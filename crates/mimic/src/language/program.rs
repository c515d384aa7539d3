//! A program: flat code, and what stands in which register.

use super::code::Instruction;
use super::sorting::SortedStatement;

/// Registers with a fixed place: time, the two truths and the steps.
pub(super) const TIME: u32 = 0;
pub(super) const FALSE: u32 = 1;
pub(super) const TRUE: u32 = 2;
/// DT, DTMIN and DTMAX where no card defines them.
pub(super) const FIRST_STEP: u32 = 3;
/// The first that are free.
pub(super) const FREE: u32 = 6;

/// Instructions, and the card of each.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Code {
    pub(super) instructions: Vec<Instruction>,
    pub(super) cards: Vec<u32>,
}

impl Code {
    pub(super) fn push(&mut self, card: usize, instruction: Instruction) {
        self.instructions.push(instruction);
        self.cards.push(card as u32);
    }

    pub(super) fn extend(&mut self, other: &Self) {
        self.instructions.extend(&other.instructions);
        self.cards.extend(&other.cards);
    }
}

/// A component of the state.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    pub(super) card: usize,
    pub(super) name: String,
    pub(super) register: u32,
    /// What is integrated; for a lag, what is followed.
    pub(super) feed: u32,
    /// Of a lag, its time constant; of a limited integral, its limits.
    pub(super) more: StateRule,
    pub(super) control: Option<u32>,
}

/// What an integral has beside its integrand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StateRule {
    Nothing,
    TimeConstant(u32),
    Limits([u32; 2]),
}

/// A delay: where its value is, what it takes in, how long, and how many values it was asked to keep.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Delay {
    pub(super) card: usize,
    pub(super) register: u32,
    pub(super) feed: u32,
    pub(super) delay: u32,
    pub(super) points: Option<u32>,
}

/// A hold: its value, the time of its next sample, what it takes, and the time between samples.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sample {
    pub(super) card: usize,
    pub(super) held: u32,
    pub(super) next: u32,
    pub(super) feed: u32,
    pub(super) interval: u32,
}

/// A difference quotient: the two values now, and the two at the point before.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DifferenceQuotient {
    pub(super) now: [u32; 2],
    pub(super) before: [u32; 2],
}

/// A result whose cards all stand under control variables. While none of them is true it keeps its value, and it takes
/// another at kept points only.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Memory {
    /// Its first card.
    pub(super) card: usize,
    pub(super) name: String,
    /// Its place among the held registers.
    pub(super) held: usize,
    /// True while its cards count; false over a step that begins with none of its control variables true.
    pub(super) gate: u32,
    pub(super) controls: Vec<u32>,
}

/// When a run ends: the first has reached the second.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finish {
    pub(super) card: usize,
    pub(super) value: u32,
    pub(super) limit: u32,
    /// Whether it is a time that is known before the run.
    pub(super) is_run_length: bool,
}

/// A plot: names, their registers, and the registers of scales and zeros.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlotCode {
    pub(super) names: Vec<(String, u32)>,
    pub(super) scale: Option<Vec<u32>>,
    pub(super) zero: Option<Vec<u32>>,
}

/// A deck that is sorted and compiled: it runs as often as there are data.
///
/// ```
/// use geneva_mimic::language::{CardLayout, Deck, Program, RunOptions, deck_named};
///
/// // Something decays from 1000 with a half-life of 2, printed every half unit of time.
/// let deck = Deck::read(deck_named("decay").expect("a deck of this project"), CardLayout::Free)?;
/// let program = Program::new(&deck)?;
/// assert_eq!((program.parameters(), program.columns().len()), (vec!["START", "HALF"], 3));
/// let runs = program.runs(&deck.data_sets()?, &RunOptions::default())?;
/// assert!((runs[0].rows[4][1] - 500.0).abs() < 0.01); // what is left at the time 2
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    pub(super) text: Vec<String>,
    /// What the registers hold before a run.
    pub(super) registers: Vec<f64>,
    /// Code for the beginning of a run, and for every evaluation.
    pub(super) initial: Code,
    pub(super) each: Code,
    pub(super) parameters: Vec<(String, u32)>,
    /// Names and their registers, for messages.
    pub(super) names: Vec<(String, u32)>,
    pub(super) states: Vec<State>,
    pub(super) delays: Vec<Delay>,
    pub(super) samples: Vec<Sample>,
    pub(super) slopes: Vec<DifferenceQuotient>,
    /// Registers that keep their value while no statement sets them.
    pub(super) held: Vec<u32>,
    pub(super) memories: Vec<Memory>,
    /// DT, DTMIN and DTMAX: their registers, and whether cards define them.
    pub(super) steps: [(u32, bool); 3],
    pub(super) finishes: Vec<Finish>,
    pub(super) headings: Vec<Vec<String>>,
    pub(super) outputs: Vec<Vec<(String, u32)>>,
    pub(super) plots: Vec<PlotCode>,
    pub(super) sorted: Vec<SortedStatement>,
}

impl Program {
    /// The registers that decide what counts, and when a run ends: control variables, limits, both sides of FIN.
    pub(super) fn deciding(&self) -> impl Iterator<Item = u32> {
        let limits = self.states.iter().filter_map(|state| match state.more {
            StateRule::Limits(limits) => Some(limits),
            _ => None,
        });
        let controls = self.memories.iter().flat_map(|memory| memory.controls.iter().copied());
        let ends = self.finishes.iter().flat_map(|finish| [finish.value, finish.limit]);
        controls.chain(self.states.iter().filter_map(|state| state.control)).chain(limits.flatten()).chain(ends)
    }

    /// The statements in the order in which they are computed.
    pub fn execution_order(&self) -> &[SortedStatement] {
        &self.sorted
    }

    /// The names of the CON cards, then those of the PAR cards, in the order of their data.
    pub fn parameters(&self) -> Vec<&str> {
        self.parameters.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// The names of the OUT cards, from left to right.
    pub fn columns(&self) -> Vec<String> {
        self.outputs.iter().flatten().map(|(name, _)| name.clone()).collect()
    }

    /// Number of integrals, and of instructions in an evaluation of their integrands.
    pub fn size(&self) -> (usize, usize) {
        (self.states.len(), self.each.instructions.len())
    }
}
