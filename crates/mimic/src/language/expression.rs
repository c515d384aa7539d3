//! Expressions: FORTRAN's signs in FORTRAN's order, names, numbers and functions.
//!
//! `**` binds tightest, from right to left, then * and /, then + and −, from left to right; a sign in front of a term
//! belongs to the whole term, so −A**2 is −(A**2). An expression is a list of nodes, each behind the nodes it needs: no
//! step after reading is recursive.

use super::code::Operation;
use super::control::WORDS;
use super::diagnostic::Problem;
use super::function::{FUNCTIONS, function_named};
use super::token::{CardToken, PlacedToken};
use super::tree::{CardExpression, ExpressionNode};
use core::ops::Range;

/// How deep parentheses may stand in one another.
const DEEPEST: usize = 64;

/// What is wrong, and where.
pub(super) type Problems = Vec<(Range<usize>, Problem)>;

/// Reads an expression that takes all these tokens; `end` is the column behind the last one.
pub(super) fn expression(tokens: &[PlacedToken], end: usize) -> Result<CardExpression, Problems> {
    let mut parser = Parser::new(tokens, end);
    let found = parser.sum();
    let rest = parser.peek().map(|placed| (placed.at.clone(), mismatch("an arithmetic sign or the end", Some(placed))));
    parser.result(found.and_then(|_| rest.map_or(Ok(()), Err)))
}

/// Reads expressions with commas between them, behind an opening parenthesis and up to the closing one, which is the
/// last token.
pub(super) fn list(tokens: &[PlacedToken], end: usize) -> Result<Vec<CardExpression>, Problems> {
    let (mut found, mut problems, mut at) = (Vec::new(), Vec::new(), 0);
    loop {
        let mut parser = Parser::new(&tokens[at..], end);
        let read = parser.sum();
        let next = parser.peek().cloned();
        let read_tokens = parser.at;
        match parser.result(read.map(|_| ())) {
            Ok(expression) => found.push(expression),
            Err(more) => {
                problems.extend(more);
                break;
            }
        }
        at += read_tokens + 1;
        match next {
            Some(sign) if sign.is(',') => {}
            Some(sign) if sign.is(')') => {
                if let Some(more) = tokens.get(at) {
                    problems.push((more.at.clone(), mismatch("the end of the card", Some(more))));
                }
                break;
            }
            other => {
                let columns = other.as_ref().map_or(end..end + 1, |placed| placed.at.clone());
                problems.push((columns, mismatch("a comma or a closing parenthesis", other.as_ref())));
                break;
            }
        }
    }
    if problems.is_empty() { Ok(found) } else { Err(problems) }
}

/// What was due, and what stands there instead.
pub(super) fn mismatch(expected: &'static str, found: Option<&PlacedToken>) -> Problem {
    Problem::Expected { expected, found: found.map_or_else(|| "nothing".to_owned(), PlacedToken::words) }
}

struct Parser<'a> {
    tokens: &'a [PlacedToken],
    at: usize,
    end: usize,
    depth: usize,
    nodes: Vec<(ExpressionNode, Range<usize>)>,
    problems: Problems,
}

type Read<T> = Result<T, (Range<usize>, Problem)>;

impl<'a> Parser<'a> {
    fn new(tokens: &'a [PlacedToken], end: usize) -> Self {
        Self { tokens, at: 0, end, depth: 0, nodes: Vec::new(), problems: Vec::new() }
    }

    fn result(mut self, read: Read<()>) -> Result<CardExpression, Problems> {
        if let Err(problem) = read {
            self.problems.push(problem);
        }
        if self.problems.is_empty() { Ok(CardExpression { nodes: self.nodes }) } else { Err(self.problems) }
    }

    fn peek(&self) -> Option<&'a PlacedToken> {
        self.tokens.get(self.at)
    }

    /// The next token if it is one of these signs, which is then passed.
    fn pass(&mut self, signs: &[char]) -> Option<&'a PlacedToken> {
        let next = self.peek().filter(|next| next.is_one_of(signs))?;
        self.at += 1;
        Some(next)
    }

    fn add(&mut self, node: ExpressionNode, at: Range<usize>) -> usize {
        self.nodes.push((node, at));
        self.nodes.len() - 1
    }

    fn span(&self, from: usize, to: usize) -> Range<usize> {
        self.nodes[from].1.start..self.nodes[to].1.end
    }

    fn sum(&mut self) -> Read<usize> {
        let sign = self.pass(&['+', '-']);
        let mut left = self.product()?;
        if let Some(sign) = sign.filter(|sign| sign.is('-')) {
            let at = sign.at.start..self.nodes[left].1.end;
            // A number with its sign is a number.
            left = if let ExpressionNode::Number(number) = self.nodes[left].0 {
                self.nodes[left] = (ExpressionNode::Number(-number), at);
                left
            } else {
                self.add(ExpressionNode::Negative(left), at)
            };
        }
        while let Some(sign) = self.pass(&['+', '-']) {
            let right = self.product()?;
            let operation = if sign.is('+') { Operation::Add } else { Operation::Subtract };
            let at = self.span(left, right);
            left = self.add(ExpressionNode::Binary(operation, [left, right]), at);
        }
        Ok(left)
    }

    fn product(&mut self) -> Read<usize> {
        let mut left = self.power()?;
        while let Some(sign) = self.pass(&['*', '/']) {
            let right = self.power()?;
            let operation = if sign.is('*') { Operation::Multiply } else { Operation::Divide };
            let at = self.span(left, right);
            left = self.add(ExpressionNode::Binary(operation, [left, right]), at);
        }
        Ok(left)
    }

    fn power(&mut self) -> Read<usize> {
        // From right to left, without recursion: first all, then from the last on.
        let mut parts = vec![self.atom()?];
        while self.pass(&['^']).is_some() {
            parts.push(self.atom()?);
        }
        let mut right = parts.pop().unwrap_or_default();
        while let Some(left) = parts.pop() {
            let at = self.nodes[left].1.start..self.nodes[right].1.end;
            right = self.add(ExpressionNode::Binary(Operation::Power, [left, right]), at);
        }
        Ok(right)
    }

    fn atom(&mut self) -> Read<usize> {
        let Some(placed) = self.peek() else {
            return Err((self.end..self.end + 1, mismatch("a name, a number or a parenthesis", None)));
        };
        let at = placed.at.clone();
        if placed.is_one_of(&['+', '-']) {
            return Err((at, Problem::TwoSigns));
        }
        let node = match &placed.token {
            CardToken::Number(number) => ExpressionNode::Number(*number),
            CardToken::Name(name) => {
                self.at += 1;
                return match self.pass(&['(']) {
                    Some(_) => self.call(name, at),
                    None => Ok(self.add(ExpressionNode::Name(name.clone()), at)),
                };
            }
            CardToken::Sign('(') => {
                self.at += 1;
                self.deeper(&at)?;
                let inside = self.sum()?;
                self.close()?;
                return Ok(inside);
            }
            CardToken::Sign(_) => return Err((at, mismatch("a name, a number or a parenthesis", Some(placed)))),
        };
        self.at += 1;
        Ok(self.add(node, at))
    }

    fn deeper(&mut self, at: &Range<usize>) -> Read<()> {
        self.depth += 1;
        if self.depth > DEEPEST { Err((at.clone(), Problem::TooDeep(DEEPEST))) } else { Ok(()) }
    }

    fn close(&mut self) -> Read<usize> {
        let Some(sign) = self.pass(&[')']) else {
            let at = self.peek().map_or(self.end..self.end + 1, |placed| placed.at.clone());
            return Err((at, mismatch("a closing parenthesis", self.peek())));
        };
        self.depth = self.depth.saturating_sub(1);
        Ok(sign.at.end)
    }

    /// A function after its opening parenthesis. An unknown one is reported, and reading goes on.
    fn call(&mut self, name: &str, at: Range<usize>) -> Read<usize> {
        self.deeper(&at)?;
        let mut arguments = Vec::new();
        if !self.peek().is_some_and(|next| next.is(')')) {
            arguments.push(self.sum()?);
            while self.pass(&[',']).is_some() {
                arguments.push(self.sum()?);
            }
        }
        let whole = at.start..self.close()?;
        let Some(function) = function_named(name) else {
            if WORDS.contains(&name) {
                self.problems.push((at, Problem::CardInExpression(name.to_owned())));
                return Ok(self.add(ExpressionNode::Number(1.0), whole));
            }
            let known = FUNCTIONS.iter().map(|function| function.name);
            let nearest = super::diagnostic::nearest_to(name, known);
            self.problems.push((at, Problem::UnknownFunction { name: name.to_owned(), nearest }));
            return Ok(self.add(ExpressionNode::Number(1.0), whole));
        };
        let known = &FUNCTIONS[function];
        let given = arguments.len();
        if !(known.least..=known.most).contains(&given) {
            let given = format!("{given} argument{}", if given == 1 { "" } else { "s" });
            let problem = Problem::Arguments { name: name.to_owned(), given, allowed: known.arity() };
            self.problems.push((whole, problem));
            return Ok(self.add(ExpressionNode::Number(1.0), at));
        }
        Ok(self.add(ExpressionNode::Call(function, arguments), whole))
    }
}
