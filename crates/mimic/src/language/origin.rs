//! Where a number that is none came from: backwards from where it was seen.

use super::code::Operation;
use super::digits::eight_digits;
use super::program::{Code, Program, TIME};
use super::trouble::FaultOrigin;

impl Program {
    /// The text of a card.
    pub(super) fn card_text(&self, card: usize) -> String {
        let text = card.checked_sub(1).and_then(|at| self.text.get(at)).map_or("", |text| text.trim());
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Where what stands in a register came from, which is no number.
    pub(super) fn origin(&self, registers: &[f64], register: u32) -> FaultOrigin {
        let codes = [&self.each, &self.initial];
        let executed = codes.map(|code| executed(code, registers));
        let mut register = register;
        let mut limit = executed.iter().map(Vec::len).sum::<usize>() + 1;
        loop {
            let place = executed.iter().enumerate().find_map(|(which, all)| {
                let code = codes[which];
                all.iter().rev().find(|at| code.instructions[**at].to == register).map(|at| (which, *at))
            });
            let Some((which, at)) = place else { break };
            let instruction = &codes[which].instructions[at];
            let used = instruction.operands_in_use(registers);
            let next = used.into_iter().find(|of| !registers[*of as usize].is_finite() && *of != register);
            limit = limit.saturating_sub(1);
            // Behind the start an integral has its value from its rate: what it began with is not to blame.
            let grown = next.filter(|_| registers[TIME as usize] > 0.0);
            if let Some(state) = self.states.iter().find(|state| Some(state.register) == grown) {
                let reason = format!("{} has grown without bound", state.name);
                return FaultOrigin { card: state.card, text: self.card_text(state.card), reason };
            }
            match next.filter(|_| limit > 0) {
                Some(next) => register = next,
                None => {
                    let card = codes[which].cards[at] as usize;
                    return FaultOrigin { card, text: self.card_text(card), reason: instruction.reason(registers) };
                }
            }
        }
        let value = registers[register as usize];
        let name = self.names.iter().find(|(_, of)| *of == register).map_or("a value", |(name, _)| name.as_str());
        FaultOrigin { card: 0, text: String::new(), reason: format!("{name} is {}", eight_digits(value)) }
    }
}

/// The instructions that were run, with what the registers now hold.
fn executed(code: &Code, registers: &[f64]) -> Vec<usize> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(instruction) = code.instructions.get(at) {
        if instruction.operation == Operation::Unless {
            if instruction.from[..2].iter().any(|of| registers[*of as usize] != 1.0) {
                at += instruction.to as usize;
            }
        } else {
            found.push(at);
        }
        at += 1;
    }
    found
}
