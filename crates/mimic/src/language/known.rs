//! What is known of the statements before a run: which never change, which are numbers and which truths, and which
//! nothing needs.

use super::control::STEPS;
use super::diagnostic::Problem;
use super::function::{FUNCTIONS, FunctionKind};
use super::graph::{Graph, Region};
use super::tree::ExpressionNode;
use super::types::{Type, types};

impl Graph<'_> {
    /// Whether a name is known before the run, and does not change with it.
    pub(super) fn is_known_before(&self, name: &str) -> bool {
        name != "T" && self.definitions_of(name).iter().all(|of| self.is_constant[*of])
    }

    pub(super) fn find_constants(&mut self) {
        for group in self.order.clone() {
            // Inside a loop around an IMP each waits for the others.
            group.iter().for_each(|of| self.is_constant[*of] = true);
            let constant = group.iter().all(|of| {
                let has_memory = !self.blocks_of[*of].is_empty();
                let is_free = self.deck.statements[*of].control.is_none();
                let mut names = self.names_in(*of, |_| true).into_iter();
                let known =
                    |name: &str| name != "T" && self.definitions_of(name).iter().all(|other| self.is_constant[*other]);
                !has_memory && is_free && names.all(known)
            });
            group.iter().for_each(|of| self.is_constant[*of] = constant);
        }
        let mut found = Vec::new();
        for (number, statement) in self.deck.statements.iter().enumerate() {
            if STEPS.contains(&statement.result.name.as_str())
                && (!self.is_constant[number] || statement.control.is_some())
            {
                found.push((
                    statement.card,
                    statement.expression.columns(),
                    statement.result.name.clone(),
                    number,
                    None,
                ));
            }
        }
        for block in self.blocks.iter().filter(|block| matches!(block.kind, FunctionKind::Delay | FunctionKind::Sample))
        {
            let statement = &self.deck.statements[block.statement];
            let what = if block.kind == FunctionKind::Delay {
                "the delay of a TDL"
            } else {
                "the time between samples of a ZOH"
            };
            found.push((
                statement.card,
                statement.expression.nodes[block.node].1.clone(),
                what.to_owned(),
                block.statement,
                Some(block.node),
            ));
        }
        for (card, columns, what, statement, node) in found {
            let names = self.names_in(statement, |region| node.is_none_or(|node| region == Region::Start(node)));
            let changes = names.into_iter().find(|name| !self.is_known_before(name));
            let by_itself = node.is_none().then_some("a function of time");
            if let Some(name) = changes.or(by_itself).map(str::to_owned) {
                self.fault(card, columns, Problem::NotConstant { what, name });
            }
        }
        self.check_plots();
    }

    /// That scales are known before the run.
    fn check_plots(&mut self) {
        let mut told = Vec::new();
        for listed in self.deck.plots.iter().flat_map(|plot| plot.scale.iter().chain(&plot.zero)) {
            for expression in &listed.expressions {
                let names = expression.nodes.iter().filter_map(|(node, columns)| match node {
                    ExpressionNode::Name(name) => Some((name, columns)),
                    _ => None,
                });
                for (name, columns) in names.filter(|(name, _)| !self.is_known_before(name)) {
                    let problem = Problem::NotConstant { what: "a scale of a plot".to_owned(), name: name.clone() };
                    told.push((listed.card, columns.clone(), problem));
                }
            }
        }
        told.into_iter().for_each(|(card, columns, problem)| self.fault(card, columns, problem));
    }

    /// Numbers and truths; functions where they cannot be.
    pub(super) fn find_types(&mut self) {
        self.types.extend([("TRUE", Type::Truth), ("FALSE", Type::Truth)]);
        for number in self.order.iter().flatten() {
            let statement = &self.deck.statements[*number];
            let (found, _) = types(&statement.expression, |name| self.types.get(name).copied());
            self.types.entry(&statement.result.name).or_insert(found);
        }
        let mut told = Vec::new();
        // What an algebraic loop leaves without a type is told as that loop.
        let has_none = |name: &str| self.definitions.contains_key(name) && !self.types.contains_key(name);
        for (number, statement) in self.deck.statements.iter().enumerate() {
            let control = statement.control.as_ref().map(|word| word.name.as_str());
            if self.names_in(number, |_| true).into_iter().chain(control).any(has_none) {
                continue;
            }
            let of_name = |name: &str| self.types.get(name).copied();
            let (found, problems) = types(&statement.expression, of_name);
            told.extend(problems.into_iter().map(|(columns, problem)| (statement.card, columns, problem)));
            let own = of_name(&statement.result.name).unwrap_or(found);
            if let Err(problem) = found.must_be(own, || format!("{}, as on its other card,", statement.result.name)) {
                told.push((statement.card, statement.expression.columns(), problem));
            }
            if let Some(control) = &statement.control {
                let of_control = of_name(&control.name).unwrap_or(Type::Number);
                let known = self.is_known(&control.name);
                if let Err(problem) = of_control.must_be(Type::Truth, || "a logical control variable".to_owned())
                    && known
                {
                    told.push((statement.card, control.at.clone(), problem));
                }
            }
            for (at, (node, columns)) in statement.expression.nodes.iter().enumerate() {
                let ExpressionNode::Call(function, _) = node else { continue };
                if FUNCTIONS[*function].kind == FunctionKind::Implicit && at != statement.expression.root() {
                    let problem = Problem::Misplaced("IMP must be alone in its expression; give its value a name");
                    told.push((statement.card, columns.clone(), problem));
                }
            }
        }
        for listed in self.expression_cards() {
            for expression in &listed.expressions {
                let (found, problems) = types(expression, |name| self.types.get(name).copied());
                told.extend(problems.into_iter().map(|(columns, problem)| (listed.card, columns, problem)));
                if let Err(problem) = found.must_be(Type::Number, || "what a card compares or scales".to_owned()) {
                    told.push((listed.card, expression.columns(), problem));
                }
                for (node, columns) in &expression.nodes {
                    let ExpressionNode::Call(function, _) = node else { continue };
                    let kind = FUNCTIONS[*function].kind;
                    if !matches!(kind, FunctionKind::Plain(_) | FunctionKind::Folded(_)) {
                        let problem =
                            Problem::Misplaced("a function with a memory needs a card of its own; give it a name");
                        told.push((listed.card, columns.clone(), problem));
                    }
                }
            }
        }
        told.into_iter().for_each(|(card, columns, problem)| self.fault(card, columns, problem));
    }

    /// The statements on which something depends that is printed, plotted or ends the run.
    pub(super) fn live(&self) -> Vec<bool> {
        let mut live = vec![false; self.deck.statements.len()];
        let words = self.deck.outputs.iter().flatten().chain(self.deck.plots.iter().flat_map(|plot| &plot.names));
        let mut names: Vec<&str> = words.map(|word| word.name.as_str()).chain(STEPS).collect();
        for listed in self.expression_cards() {
            names.extend(listed.expressions.iter().flat_map(|of| &of.nodes).filter_map(|(node, _)| match node {
                ExpressionNode::Name(name) => Some(name.as_str()),
                _ => None,
            }));
        }
        while let Some(name) = names.pop() {
            for &number in self.definitions_of(name) {
                if !live[number] {
                    live[number] = true;
                    names.extend(self.names_in(number, |_| true));
                    names.extend(self.deck.statements[number].control.as_ref().map(|word| word.name.as_str()));
                }
            }
        }
        live
    }
}
