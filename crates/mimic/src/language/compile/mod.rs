//! From a sorted deck to flat code.

mod statement;

use crate::language::code::{Instruction, Operation};
use crate::language::control::STEPS;
use crate::language::diagnostic::Diagnostics;
use crate::language::function::{FUNCTIONS, FunctionKind};
use crate::language::graph::{Graph, Region};
use crate::language::program::{
    Code, Delay, DifferenceQuotient, FALSE, FIRST_STEP, FREE, Finish, Memory, PlotCode, Program, Sample, State,
    StateRule, TIME, TRUE,
};
use crate::language::sorting::{Schedule, SortedStatement};
use crate::language::tree::{CardExpression, Deck, ExpressionCard, ExpressionNode};
use std::collections::HashMap;

impl Program {
    /// Sorts and compiles a deck.
    ///
    /// # Errors
    ///
    /// All that does not fit together: names that no card defines, definitions that clash, loops, truths for numbers.
    pub fn new(deck: &Deck) -> Result<Self, Diagnostics> {
        let mut graph = Graph::new(deck);
        Diagnostics::check(core::mem::take(&mut graph.faults))?;
        Ok(Compiler::new(&graph).program())
    }
}

struct Compiler<'a> {
    graph: &'a Graph<'a>,
    registers: Vec<f64>,
    constants: HashMap<u64, u32>,
    /// The register of each name.
    of_name: HashMap<&'a str, u32>,
    /// The register of each block's value.
    of_block: Vec<u32>,
    /// Of each statement: its code, and the registers of its nodes.
    now: Vec<Code>,
    nodes: Vec<Vec<u32>>,
    /// Of each block: what it begins with.
    start: Vec<Code>,
    feed: Code,
    samples: Vec<Sample>,
    slopes: Vec<DifferenceQuotient>,
    /// The gate of each name that has a memory.
    gates: HashMap<&'a str, u32>,
    /// Of each block that is a difference quotient, the register of its first value.
    slope_starts: HashMap<u32, u32>,
}

impl<'a> Compiler<'a> {
    fn new(graph: &'a Graph<'a>) -> Self {
        let mut compiler = Self {
            graph,
            registers: vec![0.0; FREE as usize],
            constants: HashMap::new(),
            of_name: HashMap::from([("T", TIME), ("FALSE", FALSE), ("TRUE", TRUE)]),
            of_block: Vec::new(),
            now: vec![Code::default(); graph.deck.statements.len()],
            nodes: graph.deck.statements.iter().map(|of| vec![0; of.expression.nodes.len()]).collect(),
            start: vec![Code::default(); graph.blocks.len()],
            feed: Code::default(),
            samples: Vec::new(),
            slopes: Vec::new(),
            gates: HashMap::new(),
            slope_starts: HashMap::new(),
        };
        compiler.registers[TRUE as usize] = 1.0;
        compiler.constants.extend([(0.0_f64.to_bits(), FALSE), (1.0_f64.to_bits(), TRUE)]);
        for (at, name) in STEPS.iter().enumerate() {
            if !graph.definitions.contains_key(name) {
                compiler.of_name.insert(name, FIRST_STEP + at as u32);
            }
        }
        for name in &graph.parameters {
            let register = compiler.register();
            compiler.of_name.insert(name, register);
        }
        compiler.of_block = graph.blocks.iter().map(|_| compiler.register()).collect();
        compiler
    }

    fn register(&mut self) -> u32 {
        self.registers.push(0.0);
        (self.registers.len() - 1) as u32
    }

    fn constant(&mut self, value: f64) -> u32 {
        if let Some(register) = self.constants.get(&value.to_bits()) {
            return *register;
        }
        let register = self.register();
        self.registers[register as usize] = value;
        self.constants.insert(value.to_bits(), register);
        register
    }

    fn program(mut self) -> Program {
        let graph = self.graph;
        for group in &graph.order {
            // Inside a loop around an IMP all know the IMP's name before it is computed.
            if self.implicit(group).is_some() {
                for number in group {
                    let register = self.register();
                    self.of_name.insert(&graph.deck.statements[*number].result.name, register);
                }
            }
            for number in group {
                self.statement(*number);
            }
        }
        for number in graph.order.iter().flatten() {
            self.feeds(*number);
        }
        for block in 0..graph.blocks.len() {
            self.starts(block);
        }
        let mut initial = Code::default();
        for group in &graph.starting {
            self.begin_loop(group, &mut initial);
            for member in group {
                match member.checked_sub(graph.deck.statements.len()) {
                    Some(block) => initial.extend(&self.start[block]),
                    None => initial.extend(&self.now[*member]),
                }
            }
            self.end_loop(group, &mut initial);
        }
        // A difference quotient has its first value by itself.
        for instruction in &mut initial.instructions {
            if instruction.operation == Operation::Slope
                && let Some(start) = self.slope_starts.get(&instruction.to)
            {
                *instruction = Instruction { operation: Operation::Copy, to: instruction.to, from: [*start, 0, 0, 0] };
            }
        }
        let mut each = Code::default();
        for group in graph.order.iter().filter(|group| !graph.is_constant[group[0]]) {
            self.begin_loop(group, &mut each);
            group.iter().for_each(|number| each.extend(&self.now[*number]));
            self.end_loop(group, &mut each);
        }
        each.extend(&self.feed);
        self.assemble(initial, each)
    }

    /// Code in front of and behind the code of a loop around an IMP.
    fn begin_loop(&mut self, group: &[usize], code: &mut Code) {
        let Some(number) = self.implicit(group) else { return };
        let (card, guess, own, counter) = self.loop_registers(number);
        let copy = |to, from| Instruction { operation: Operation::Copy, to, from: [from, 0, 0, 0] };
        code.push(card, copy(own, guess));
        code.push(card, copy(counter, FALSE));
    }

    fn end_loop(&mut self, group: &[usize], code: &mut Code) {
        let Some(number) = self.implicit(group) else { return };
        let (card, guess, own, counter) = self.loop_registers(number);
        let length: usize = group.iter().map(|of| self.now[*of].instructions.len()).sum();
        let back = self.constant((length + 1) as f64);
        let expression = &self.graph.deck.statements[number].expression;
        let new = expression.whole_call().map_or(0, |(_, arguments)| self.nodes[number][arguments[1]]);
        code.push(card, Instruction { operation: Operation::Repeat, to: own, from: [new, counter, back, guess] });
    }

    fn implicit(&self, group: &[usize]) -> Option<usize> {
        let number = *group.last()?;
        let call = self.graph.deck.statements.get(number)?.expression.whole_call()?;
        (FUNCTIONS[call.0].kind == FunctionKind::Implicit).then_some(number)
    }

    /// The card of an IMP, the register that it begins with, its own and its counter, which is that of its node.
    fn loop_registers(&self, number: usize) -> (usize, u32, u32, u32) {
        let statement = &self.graph.deck.statements[number];
        let guess = statement.expression.whole_call().map_or(0, |(_, arguments)| self.nodes[number][arguments[0]]);
        let own = self.of_name.get(statement.result.name.as_str()).copied().unwrap_or(0);
        (statement.card, guess, own, self.nodes[number][statement.expression.root()])
    }

    /// What the memories of a statement take in.
    fn feeds(&mut self, number: usize) {
        let mut code = Code::default();
        self.nodes_of(number, |region| region == Region::Feed, &mut code);
        self.feed.extend(&code);
    }

    /// What a block begins with: a code whose last instruction sets its value.
    fn starts(&mut self, block: usize) {
        let of = self.graph.blocks[block];
        let card = self.graph.deck.statements[of.statement].card;
        let mut code = Code::default();
        self.nodes_of(of.statement, |region| region == Region::Start(of.node), &mut code);
        let first = self
            .argument(block, if of.kind == FunctionKind::Integral || of.kind == FunctionKind::Limited { 1 } else { 2 });
        let to = self.of_block[block];
        let from = match of.kind {
            FunctionKind::Integral | FunctionKind::Limited | FunctionKind::Lag => first.unwrap_or(FALSE),
            FunctionKind::Slope => {
                self.slope_starts.insert(to, first.unwrap_or(FALSE));
                first.unwrap_or(FALSE)
            }
            _ => FALSE,
        };
        code.push(card, Instruction { operation: Operation::Copy, to, from: [from, 0, 0, 0] });
        self.start[block] = code;
    }

    /// The register of an argument of a block.
    fn argument(&self, block: usize, argument: usize) -> Option<u32> {
        let of = self.graph.blocks[block];
        let node = &self.graph.deck.statements[of.statement].expression.nodes[of.node].0;
        Some(self.nodes[of.statement][*node.parts().get(argument)?])
    }

    fn named(&self, name: &str) -> (String, u32) {
        (name.to_owned(), self.of_name.get(name).copied().unwrap_or(TIME))
    }

    /// Code for expressions that are no statements, and the register of each.
    fn listed(&mut self, listed: &ExpressionCard, code: &mut Code) -> Vec<u32> {
        let mut roots = Vec::new();
        for expression in &listed.expressions {
            let mut parts = vec![0; expression.nodes.len()];
            for at in 0..parts.len() {
                parts[at] = self.node(expression, at, listed.card, None, &parts, code);
            }
            roots.push(parts[expression.root()]);
        }
        roots
    }

    fn memory(&self, name: &str, gate: u32, held: &[u32]) -> Memory {
        let own = || self.graph.definitions_of(name).iter().map(|of| &self.graph.deck.statements[*of]);
        Memory {
            card: own().map(|of| of.card).next().unwrap_or(0),
            name: name.to_owned(),
            held: held.binary_search(&self.named(name).1).unwrap_or(0),
            gate,
            controls: own().filter_map(|of| of.control.as_ref()).map(|word| self.named(&word.name).1).collect(),
        }
    }

    fn assemble(mut self, mut initial: Code, mut each: Code) -> Program {
        let graph = self.graph;
        let deck = graph.deck;
        let mut finishes = Vec::new();
        for listed in &deck.finishes {
            let mut code = Code::default();
            let registers = self.listed(listed, &mut code);
            initial.extend(&code);
            each.extend(&code);
            let is_time = registers[0] == TIME;
            let names = listed.expressions[1].nodes.iter().filter_map(|(node, _)| match node {
                ExpressionNode::Name(name) => Some(name.as_str()),
                _ => None,
            });
            let is_run_length = is_time && names.into_iter().all(|name| graph.is_known_before(name));
            finishes.push(Finish { card: listed.card, value: registers[0], limit: registers[1], is_run_length });
        }
        let mut plots = Vec::new();
        for plot in &deck.plots {
            let names = plot.names.iter().map(|word| self.named(&word.name)).collect();
            let scale = plot.scale.as_ref().map(|listed| self.listed(listed, &mut initial));
            let zero = plot.zero.as_ref().map(|listed| self.listed(listed, &mut initial));
            plots.push(PlotCode { names, scale, zero });
        }
        let mut states = Vec::new();
        let mut delays = Vec::new();
        for (number, block) in graph.blocks.iter().enumerate() {
            let statement = &deck.statements[block.statement];
            let register = self.of_block[number];
            let feed = self.argument(number, 0).unwrap_or(FALSE);
            let of = |argument| self.argument(number, argument).unwrap_or(FALSE);
            let more = match block.kind {
                FunctionKind::Integral => StateRule::Nothing,
                FunctionKind::Limited => StateRule::Limits([of(2), of(3)]),
                FunctionKind::Lag => StateRule::TimeConstant(of(1)),
                FunctionKind::Delay => {
                    let points = self.argument(number, 2);
                    delays.push(Delay { card: statement.card, register, feed, delay: of(1), points });
                    continue;
                }
                _ => continue,
            };
            let control = statement.control.as_ref().map(|word| self.named(&word.name).1);
            let name = statement.result.name.clone();
            states.push(State { card: statement.card, name, register, feed, more, control });
        }
        let mut samples = core::mem::take(&mut self.samples);
        for sample in &mut samples {
            sample.interval = self.argument(sample.interval as usize, 1).unwrap_or(TRUE);
        }
        let mut held: Vec<u32> = self.gates.keys().map(|name| self.named(name).1).collect();
        held.extend(
            graph.blocks.iter().zip(&self.of_block).filter(|(of, _)| of.kind == FunctionKind::Slope).map(|(_, of)| *of),
        );
        held.sort_unstable();
        held.dedup();
        let mut memories: Vec<Memory> = self.gates.iter().map(|(name, gate)| self.memory(name, *gate, &held)).collect();
        memories.sort_unstable_by_key(|memory| memory.gate);
        let mut names: Vec<(String, u32)> = self.of_name.iter().map(|(name, of)| ((*name).to_owned(), *of)).collect();
        names.sort_unstable();
        let live = graph.live();
        let sorted = graph.order.iter().flatten().map(|number| {
            let statement = &deck.statements[*number];
            SortedStatement {
                card: statement.card,
                statement: *number,
                result: statement.result.name.clone(),
                control: statement.control.as_ref().map(|word| word.name.clone()),
                when: if graph.is_constant[*number] { Schedule::Once } else { Schedule::Always },
                is_dead: !live[*number],
            }
        });
        let steps = STEPS.map(|name| (self.named(name).1, graph.definitions.contains_key(name)));
        let outputs = deck.outputs.iter().map(|of| of.iter().map(|word| self.named(&word.name)).collect()).collect();
        let parameters = graph.parameters.iter().map(|name| self.named(name)).collect();
        Program {
            text: deck.cards.clone(),
            parameters,
            names,
            states,
            delays,
            samples,
            slopes: self.slopes,
            held,
            memories,
            steps,
            finishes,
            headings: deck.headings.clone(),
            outputs,
            plots,
            sorted: sorted.collect(),
            initial,
            each,
            registers: self.registers,
        }
    }
}
