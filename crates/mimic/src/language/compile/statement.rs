//! The code of a statement.

use super::*;

impl Compiler<'_> {
    /// The code of a statement: what it computes now.
    pub(super) fn statement(&mut self, number: usize) {
        let statement = &self.graph.deck.statements[number];
        let mut code = Code::default();
        self.nodes_of(number, |region| region == Region::Now, &mut code);
        let root = self.nodes[number][statement.expression.root()];
        let name = statement.result.name.as_str();
        let is_only = self.graph.definitions.get(name).is_some_and(|all| all.len() == 1);
        if self.implicit(&[number]).is_some() {
            // Its value comes from the end of its loop.
        } else if is_only && self.graph.is_at_hand(number) && !self.of_name.contains_key(name) {
            self.of_name.insert(name, root);
            self.now[number] = code;
            return;
        } else {
            let to = match self.of_name.get(name) {
                Some(register) => *register,
                None => self.register(),
            };
            self.of_name.insert(name, to);
            match code.instructions.last_mut().filter(|last| last.to == root && last.operation != Operation::Slope) {
                // The last instruction can write where the name is.
                Some(last) => {
                    last.to = to;
                    let root_node = statement.expression.root();
                    self.nodes[number][root_node] = to;
                }
                None => {
                    let copy = Instruction { operation: Operation::Copy, to, from: [root, 0, 0, 0] };
                    code.push(statement.card, copy);
                }
            }
        }
        if let Some(control) = &statement.control {
            let control = self.of_name.get(control.name.as_str()).copied().unwrap_or(FALSE);
            let gate = match self.gates.get(name) {
                Some(gate) => *gate,
                None => self.register(),
            };
            self.gates.insert(name, gate);
            self.registers[gate as usize] = 1.0;
            let over = code.instructions.len() as u32;
            let unless = Instruction { operation: Operation::Unless, to: over, from: [control, gate, 0, 0] };
            let mut guarded = Code::default();
            guarded.push(statement.card, unless);
            guarded.extend(&code);
            code = guarded;
        }
        self.now[number] = code;
    }

    /// Code for the nodes of some regions of a statement.
    pub(super) fn nodes_of(&mut self, number: usize, wanted: impl Fn(Region) -> bool, code: &mut Code) {
        let statement = &self.graph.deck.statements[number];
        for at in 0..statement.expression.nodes.len() {
            if wanted(self.graph.regions[number][at]) {
                let block = self.graph.block_at(number, at);
                let parts = core::mem::take(&mut self.nodes[number]);
                let register = self.node(&statement.expression, at, statement.card, block, &parts, code);
                self.nodes[number] = parts;
                self.nodes[number][at] = register;
            }
        }
    }

    /// The register of a node whose parts have theirs.
    pub(super) fn node(
        &mut self,
        expression: &CardExpression,
        at: usize,
        card: usize,
        block: Option<usize>,
        parts: &[u32],
        code: &mut Code,
    ) -> u32 {
        let node = &expression.nodes[at].0;
        let mut from = [0; 4];
        let operation = match node {
            ExpressionNode::Number(number) => return self.constant(*number),
            ExpressionNode::Name(name) => return self.of_name.get(name.as_str()).copied().unwrap_or(TIME),
            ExpressionNode::Negative(_) => Operation::Negate,
            ExpressionNode::Binary(operation, _) => *operation,
            ExpressionNode::Call(function, arguments) => match FUNCTIONS[*function].kind {
                FunctionKind::Plain(operation) => {
                    if operation == Operation::ArcTangent {
                        from[1] = TRUE;
                    }
                    operation
                }
                FunctionKind::Folded(operation) => return self.folded(operation, arguments, card, parts, code),
                FunctionKind::Sample => return self.sample(block, arguments, card, parts, code),
                FunctionKind::Slope => return self.slope(block, arguments, card, parts, code),
                FunctionKind::Implicit => return self.register(),
                _ => return block.map_or(TIME, |block| self.of_block[block]),
            },
        };
        for (place, part) in from.iter_mut().zip(node.parts()) {
            *place = parts[*part];
        }
        let mut operation = operation;
        // A square is a product, as FORTRAN makes of it.
        if let ExpressionNode::Binary(Operation::Power, [base, exponent]) = node
            && expression.nodes[*exponent].0 == ExpressionNode::Number(2.0)
        {
            operation = Operation::Multiply;
            from = [parts[*base], parts[*base], 0, 0];
        }
        let to = self.register();
        code.push(card, Instruction { operation, to, from });
        to
    }

    fn folded(
        &mut self,
        operation: Operation,
        arguments: &[usize],
        card: usize,
        parts: &[u32],
        code: &mut Code,
    ) -> u32 {
        let mut so_far = parts[arguments[0]];
        for argument in &arguments[1..] {
            let to = self.register();
            code.push(card, Instruction { operation, to, from: [so_far, parts[*argument], 0, 0] });
            so_far = to;
        }
        so_far
    }

    /// A hold is a switch between what it holds and what it takes.
    fn sample(
        &mut self,
        block: Option<usize>,
        arguments: &[usize],
        card: usize,
        parts: &[u32],
        code: &mut Code,
    ) -> u32 {
        let feed = parts[arguments[0]];
        let [next, late, to] = [self.register(), self.register(), self.register()];
        let held = block.map_or(to, |block| self.of_block[block]);
        code.push(card, Instruction { operation: Operation::Subtract, to: late, from: [TIME, next, 0, 0] });
        let switch = Operation::FunctionSwitch;
        code.push(card, Instruction { operation: switch, to, from: [late, held, feed, feed] });
        self.samples.push(Sample { card, held, next, feed, interval: block.map_or(0, |block| block as u32) });
        to
    }

    fn slope(&mut self, block: Option<usize>, arguments: &[usize], card: usize, parts: &[u32], code: &mut Code) -> u32 {
        let now = [parts[arguments[0]], parts[arguments[1]]];
        let before = [self.register(), self.register()];
        let to = block.map_or(TIME, |block| self.of_block[block]);
        code.push(card, Instruction { operation: Operation::Slope, to, from: [now[0], now[1], before[0], before[1]] });
        self.slopes.push(DifferenceQuotient { now, before });
        to
    }
}
