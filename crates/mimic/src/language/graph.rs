//! What needs what: names, definitions, loops, and what is known before the run.

use super::control::{GIVEN, STEPS};
use super::diagnostic::{Diagnostic, MOST_FAULTS, MOST_TOLD, Problem, but_near, nearest_to};
use super::function::{FUNCTIONS, FunctionKind};
use super::sorting::{circle, components};
use super::tree::{CardExpression, Deck, ExpressionCard, ExpressionNode, Statement};
use super::types::Type;
use std::collections::{HashMap, HashSet};

/// Most names that are compared with unknown ones.
const COMPARED: usize = 1_000_000;

/// When a part of an expression is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Region {
    /// With its statement.
    Now,
    /// Behind all statements: what a memory takes in.
    Feed,
    /// Before the run, for the block of this node: what a memory begins with, or a time of its own.
    Start(usize),
}

/// Where the arguments of a node belong.
fn region_of_part(node: &ExpressionNode, at: usize, argument: usize, own: Region) -> Region {
    let ExpressionNode::Call(function, _) = node else { return own };
    match (FUNCTIONS[*function].kind, argument) {
        (FunctionKind::Integral, 1)
        | (FunctionKind::Limited, 1)
        | (FunctionKind::Lag, 2)
        | (FunctionKind::Slope, 2) => Region::Start(at),
        (FunctionKind::Delay, 1 | 2) | (FunctionKind::Sample, 1) => Region::Start(at),
        (FunctionKind::Integral | FunctionKind::Limited | FunctionKind::Lag | FunctionKind::Delay, _) => Region::Feed,
        _ => own,
    }
}

/// The region of each node.
pub(super) fn regions(expression: &CardExpression) -> Vec<Region> {
    let mut found = vec![Region::Now; expression.nodes.len()];
    for (at, (node, _)) in expression.nodes.iter().enumerate().rev() {
        for (argument, part) in node.parts().iter().enumerate() {
            found[*part] = region_of_part(node, at, argument, found[at]);
        }
    }
    found
}

/// A function with a memory of its own: its statement, its node and its place in the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) statement: usize,
    pub(super) node: usize,
    pub(super) kind: FunctionKind,
}

/// The deck as a graph.
pub(super) struct Graph<'a> {
    pub(super) deck: &'a Deck,
    /// The statements that define each name.
    pub(super) definitions: HashMap<&'a str, Vec<usize>>,
    /// The names of CON and PAR cards.
    pub(super) parameters: Vec<&'a str>,
    /// Names that are known though no statement defines them.
    known_without: HashSet<&'a str>,
    pub(super) regions: Vec<Vec<Region>>,
    pub(super) blocks: Vec<Block>,
    /// The blocks of each statement.
    pub(super) blocks_of: Vec<core::ops::Range<usize>>,
    /// The statements that each statement needs at the same time.
    pub(super) needs: Vec<Vec<usize>>,
    /// The statements in order, in groups; a group of several is a loop around an `IMP`, which stands last.
    pub(super) order: Vec<Vec<usize>>,
    /// Statements, and blocks behind them, in the order in which a run begins.
    pub(super) starting: Vec<Vec<usize>>,
    pub(super) is_constant: Vec<bool>,
    pub(super) types: HashMap<&'a str, Type>,
    pub(super) faults: Vec<Diagnostic>,
}

impl<'a> Graph<'a> {
    pub(super) fn new(deck: &'a Deck) -> Self {
        let regions: Vec<_> = deck.statements.iter().map(|statement| regions(&statement.expression)).collect();
        let (mut blocks, mut blocks_of) = (Vec::new(), Vec::new());
        for (statement, of) in deck.statements.iter().enumerate() {
            let first = blocks.len();
            for (node, (part, _)) in of.expression.nodes.iter().enumerate() {
                let ExpressionNode::Call(function, _) = part else { continue };
                let kind = FUNCTIONS[*function].kind;
                if kind.is_memory() || matches!(kind, FunctionKind::Sample | FunctionKind::Slope) {
                    blocks.push(Block { statement, node, kind });
                }
            }
            blocks_of.push(first..blocks.len());
        }
        let parameters = deck.parameters();
        let mut graph = Self {
            deck,
            definitions: HashMap::new(),
            known_without: parameters.iter().copied().chain(GIVEN).chain(STEPS).collect(),
            parameters,
            regions,
            blocks,
            blocks_of,
            needs: Vec::new(),
            order: Vec::new(),
            starting: Vec::new(),
            is_constant: vec![false; deck.statements.len()],
            types: HashMap::new(),
            faults: Vec::new(),
        };
        graph.define();
        graph.check_names();
        graph.sort();
        graph.sort_the_start();
        graph.find_constants();
        graph.find_types();
        graph
    }

    pub(super) fn fault(&mut self, card: usize, columns: core::ops::Range<usize>, problem: Problem) {
        if self.faults.len() < MOST_FAULTS {
            let fault = self.deck.fault(card, columns, problem);
            self.faults.push(fault);
        }
    }

    /// Who defines what, and that no two do without a control variable each.
    fn define(&mut self) {
        let mut on_cards: HashMap<&str, usize> = HashMap::new();
        for group in &self.deck.groups {
            for word in &group.names {
                if let Some(first) = on_cards.insert(&word.name, group.card) {
                    let problem = Problem::DefinedTwice { name: word.name.clone(), first };
                    self.fault(group.card, word.at.clone(), problem);
                }
            }
        }
        // Of each name and control variable, the first card.
        let mut under: HashMap<(&str, Option<&str>), usize> = HashMap::new();
        for (number, statement) in self.deck.statements.iter().enumerate() {
            let word = &statement.result;
            let name = word.name.as_str();
            let control = statement.control.as_ref().map(|word| word.name.as_str());
            let before = self.definitions.entry(name).or_default();
            let clash = match control {
                None => before.first().map(|first| self.deck.statements[*first].card),
                Some(_) => under.get(&(name, None)).or_else(|| under.get(&(name, control))).copied(),
            };
            let first = clash.or_else(|| on_cards.get(name).copied());
            before.push(number);
            under.entry((name, control)).or_insert(statement.card);
            if let Some(first) = first {
                self.fault(statement.card, word.at.clone(), Problem::DefinedTwice { name: word.name.clone(), first });
            }
        }
    }

    pub(super) fn is_known(&self, name: &str) -> bool {
        self.definitions.contains_key(name) || self.known_without.contains(name)
    }

    /// That every name is defined somewhere.
    fn check_names(&mut self) {
        let mut unknown = Vec::new();
        let mut check = |card: usize, name: &str, columns: &core::ops::Range<usize>| {
            if !self.is_known(name) {
                unknown.push((card, name.to_owned(), columns.clone()));
            }
        };
        let in_expression =
            |card: usize, expression: &CardExpression, check: &mut dyn FnMut(usize, &str, &core::ops::Range<usize>)| {
                for (node, columns) in &expression.nodes {
                    if let ExpressionNode::Name(name) = node {
                        check(card, name, columns);
                    }
                }
            };
        for statement in &self.deck.statements {
            in_expression(statement.card, &statement.expression, &mut check);
            if let Some(control) = &statement.control {
                check(statement.card, &control.name, &control.at);
            }
        }
        for (card, names) in self.deck.output_cards.iter().zip(&self.deck.outputs) {
            names.iter().for_each(|word| check(*card, &word.name, &word.at));
        }
        for plot in &self.deck.plots {
            plot.names.iter().for_each(|word| check(plot.card, &word.name, &word.at));
        }
        for listed in self.expression_cards() {
            listed.expressions.iter().for_each(|expression| in_expression(listed.card, expression, &mut check));
        }
        unknown.sort_by_key(|(card, _, columns)| (*card, columns.start));
        let mut known: Vec<&str> = self.definitions.keys().chain(&self.known_without).copied().collect();
        known.sort_unstable();
        // To look for the nearest takes the longer the more names there are; it is for faults that are told.
        let looked_for = MOST_TOLD.min(COMPARED / known.len().max(1) + 1);
        let told: Vec<_> = unknown
            .into_iter()
            .enumerate()
            .map(|(at, (card, name, columns))| {
                let hint = if at < looked_for { self.hint(&name, &known) } else { String::new() };
                (card, columns, Problem::UnknownName { name, hint })
            })
            .collect();
        told.into_iter().for_each(|(card, columns, problem)| self.fault(card, columns, problem));
    }

    /// What an unknown name may be meant for: a comment that begins with C, a product, or the nearest known name.
    fn hint(&self, name: &str, known: &[&str]) -> String {
        if let Some(note) = self.deck.hidden_c.as_ref().filter(|_| name == "C") {
            return format!("; {note}");
        }
        let factor = name.trim_start_matches(|sign: char| sign.is_ascii_digit());
        if factor.len() < name.len() && known.contains(&factor) {
            return format!("; if it is a product, write {}.*{factor}", &name[..name.len() - factor.len()]);
        }
        but_near(&nearest_to(name, known.iter().copied()))
    }

    /// All cards with expressions that are no statements.
    pub(super) fn expression_cards(&self) -> impl Iterator<Item = &'a ExpressionCard> + use<'a> {
        let plots = self.deck.plots.iter().flat_map(|plot| plot.scale.iter().chain(&plot.zero));
        self.deck.finishes.iter().chain(plots)
    }

    pub(super) fn definitions_of(&self, name: &str) -> &[usize] {
        self.definitions.get(name).map_or(&[], Vec::as_slice)
    }

    /// The names in some regions of a statement, in the order of its signs.
    pub(super) fn names_in(&self, statement: usize, wanted: impl Fn(Region) -> bool) -> Vec<&'a str> {
        let nodes = &self.deck.statements[statement].expression.nodes;
        let regions = &self.regions[statement];
        let named = nodes.iter().zip(regions).filter(|(_, region)| wanted(**region));
        named
            .filter_map(|((node, _), _)| if let ExpressionNode::Name(name) = node { Some(name.as_str()) } else { None })
            .collect()
    }

    fn is_implicit(&self, statement: usize) -> bool {
        let whole = self.deck.statements[statement].expression.whole_call();
        whole.is_some_and(|(function, _)| FUNCTIONS[function].kind == FunctionKind::Implicit)
    }

    /// Whether the result is what its expression is at any instant: it stands under no control variable, or is the only
    /// one of its name and an integral as a whole, which rests by itself while its control variable is not true.
    pub(super) fn is_at_hand(&self, statement: usize) -> bool {
        let Statement { control, result, expression, .. } = &self.deck.statements[statement];
        let kind = expression.whole_call().map(|(function, _)| FUNCTIONS[function].kind);
        let is_integral = matches!(kind, Some(FunctionKind::Integral | FunctionKind::Limited | FunctionKind::Lag));
        control.is_none() || is_integral && self.definitions_of(&result.name).len() == 1
    }

    /// The order of the statements, and loops.
    fn sort(&mut self) {
        for number in 0..self.deck.statements.len() {
            let control = self.deck.statements[number].control.as_ref().filter(|_| !self.is_at_hand(number));
            let names = self.names_in(number, |region| region == Region::Now);
            let names = names.into_iter().chain(control.map(|word| word.name.as_str()));
            let mut needs: Vec<usize> = names.flat_map(|name| self.definitions_of(name).iter().copied()).collect();
            needs.dedup();
            self.needs.push(needs);
        }
        for group in components(&self.needs) {
            let first = group[0];
            let is_loop = group.len() > 1 || self.needs[first].contains(&first);
            if !is_loop && !self.is_implicit(first) {
                self.order.push(group);
                continue;
            }
            let implicit: Vec<usize> = group.iter().copied().filter(|of| self.is_implicit(*of)).collect();
            match implicit[..] {
                [one] => self.arrange_around(one, group),
                [] => {
                    let names = circle(&group, &self.needs);
                    let names = names.iter().map(|of| self.deck.statements[*of].result.name.clone()).collect();
                    let Statement { card, result, .. } = &self.deck.statements[first];
                    self.fault(*card, result.at.clone(), Problem::Loop { names });
                }
                [_, second, ..] => {
                    let Statement { card, expression, .. } = &self.deck.statements[second];
                    let problem = Problem::Misplaced("a loop can have only one IMP, but there are two in one loop");
                    self.fault(*card, expression.columns(), problem);
                }
            }
        }
    }

    /// The order of a loop that an `IMP` closes.
    fn arrange_around(&mut self, implicit: usize, group: Vec<usize>) {
        let inside: HashMap<usize, usize> =
            group.iter().filter(|of| **of != implicit).enumerate().map(|(at, of)| (*of, at)).collect();
        let others: Vec<usize> = group.iter().copied().filter(|of| *of != implicit).collect();
        let needs: Vec<Vec<usize>> = others
            .iter()
            .map(|of| self.needs[*of].iter().filter_map(|other| inside.get(other).copied()).collect())
            .collect();
        let mut ordered = Vec::new();
        for part in components(&needs) {
            if part.len() > 1 || needs[part[0]].contains(&part[0]) {
                let names = circle(&part, &needs);
                let names = names.iter().map(|of| self.deck.statements[others[*of]].result.name.clone()).collect();
                let Statement { card, result, .. } = &self.deck.statements[others[part[0]]];
                return self.fault(*card, result.at.clone(), Problem::Loop { names });
            }
            ordered.push(others[part[0]]);
        }
        // The first value must not need the loop.
        let Statement { card, expression, control, .. } = &self.deck.statements[implicit];
        let guess = expression.whole_call().and_then(|(_, arguments)| arguments.first().copied()).unwrap_or(0);
        let begins_free = match &expression.nodes[guess].0 {
            ExpressionNode::Number(_) => true,
            ExpressionNode::Name(name) => !self.definitions_of(name).iter().any(|of| group.contains(of)),
            _ => false,
        };
        if !begins_free || control.is_some() {
            let problem = Problem::Misplaced(
                "IMP can't be under a control variable, and begins with a number, or a name that its loop does not change",
            );
            return self.fault(*card, expression.columns(), problem);
        }
        ordered.push(implicit);
        self.order.push(ordered);
    }

    /// The order in which a run begins: statements, and what the blocks begin with.
    fn sort_the_start(&mut self) {
        let statements = self.deck.statements.len();
        let mut needs = self.needs.clone();
        for (number, block) in self.blocks.iter().enumerate() {
            if self.regions[block.statement][block.node] == Region::Now {
                needs[block.statement].push(statements + number);
            }
            let own = self.names_in(block.statement, |region| region == Region::Start(block.node));
            let mut own: Vec<usize> = own.iter().flat_map(|name| self.definitions_of(name).iter().copied()).collect();
            let inner = self.blocks_of[block.statement].clone();
            let inside = |at: &usize| self.regions[block.statement][self.blocks[*at].node] == Region::Start(block.node);
            own.extend(inner.filter(inside).map(|at| statements + at));
            needs.push(own);
        }
        let mut rank = vec![usize::MAX; statements];
        for (at, group) in self.order.iter().enumerate() {
            group.iter().for_each(|of| rank[*of] = at);
        }
        for group in components(&needs) {
            let is_loop = group.len() > 1 || needs[group[0]].contains(&group[0]);
            let with_blocks = group.iter().any(|of| *of >= statements);
            if is_loop && with_blocks {
                let way = circle(&group, &needs);
                let statement = |of: usize| if of < statements { of } else { self.blocks[of - statements].statement };
                let mut names: Vec<String> =
                    way.iter().map(|of| self.deck.statements[statement(*of)].result.name.clone()).collect();
                names.dedup();
                let first = statement(group[0]);
                let Statement { card, result, .. } = &self.deck.statements[first];
                self.fault(*card, result.at.clone(), Problem::InitialLoop { names });
                continue;
            }
            // A loop around an IMP has its order already; one without is a fault.
            let known = rank.get(group[0]).and_then(|rank| self.order.get(*rank));
            self.starting.push(known.filter(|_| is_loop).cloned().unwrap_or(group));
        }
    }

    /// The number of the block at a node of a statement.
    pub(super) fn block_at(&self, statement: usize, node: usize) -> Option<usize> {
        self.blocks_of[statement].clone().find(|at| self.blocks[*at].node == node)
    }
}
