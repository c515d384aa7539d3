//! What a formula says, as a tree.

use super::tokens::{Token, tokens};
use std::f64::consts::PI;

/// A formula, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    Number(f64),
    /// A letter with its index. Dots over it stand behind: `theta'`, `theta''_0`.
    Letter(String),
    Minus(Box<Node>),
    Two(Joint, Box<Node>, Box<Node>),
    Of(Function, Box<Node>),
    /// The derivative of what follows.
    Rate(By, Box<Node>),
    /// The slope f, of two numbers.
    Slope(Box<Node>, Box<Node>),
}

/// How two things are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Joint {
    Plus,
    Times,
    Over,
    Power,
}

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Function {
    Size,
    Sine,
    Cosine,
    Tangent,
    ArcSine,
    ArcCosine,
}

/// What something is differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// d/dt.
    Time,
    /// ∂/∂θ.
    Angle,
    /// ∂/∂θ'.
    Speed,
}

/// Reads a formula without an equals sign; none if it cannot be read.
///
/// Brackets left open at the end are closed there, and those closed too often are passed over.
pub fn read(formula: &str) -> Option<Node> {
    let tokens = tokens(formula)?;
    let mut reader = Reader { tokens: &tokens, at: 0, bars: 0 };
    let node = reader.sum()?;
    tokens[reader.at.min(tokens.len())..].iter().all(|token| *token == Token::Close).then_some(node)
}

struct Reader<'a> {
    tokens: &'a [Token],
    at: usize,
    /// How many bars are open.
    bars: usize,
}

impl<'a> Reader<'a> {
    fn next(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    /// Whether the next token is this one; if so, it is passed.
    fn pass(&mut self, token: &Token) -> bool {
        let found = self.next() == Some(token);
        self.at += usize::from(found);
        found
    }

    fn sum(&mut self) -> Option<Node> {
        let mut sum = if self.pass(&Token::Sign('-')) {
            Node::Minus(Box::new(self.product()?))
        } else {
            self.pass(&Token::Sign('+'));
            self.product()?
        };
        loop {
            sum = if self.pass(&Token::Sign('+')) {
                join(Joint::Plus, sum, self.product()?)
            } else if self.pass(&Token::Sign('-')) {
                join(Joint::Plus, sum, Node::Minus(Box::new(self.product()?)))
            } else {
                return Some(sum);
            };
        }
    }

    fn product(&mut self) -> Option<Node> {
        let mut product = self.factor()?;
        loop {
            product = match self.next() {
                None | Some(Token::Close | Token::Sign('+' | '-' | ';' | ',')) => return Some(product),
                Some(Token::Bar) if self.bars > 0 => return Some(product),
                Some(Token::Sign('/')) => {
                    self.at += 1;
                    join(Joint::Over, product, self.factor()?)
                }
                Some(_) => join(Joint::Times, product, self.factor()?),
            };
        }
    }

    fn factor(&mut self) -> Option<Node> {
        let base = self.single()?;
        Some(if self.pass(&Token::Sign('^')) { join(Joint::Power, base, self.single()?) } else { base })
    }

    /// A number, a letter, a function or something in brackets, without its exponent.
    fn single(&mut self) -> Option<Node> {
        match self.next()?.clone() {
            Token::Number(number) => {
                self.at += 1;
                Some(Node::Number(number))
            }
            Token::Open => {
                self.at += 1;
                // Bars open outside the bracket do not close inside it.
                let bars = std::mem::take(&mut self.bars);
                let inside = self.sum()?;
                self.bars = bars;
                self.pass(&Token::Close);
                Some(inside)
            }
            Token::Bar => {
                self.at += 1;
                self.bars += 1;
                let inside = self.sum()?;
                self.bars -= 1;
                self.pass(&Token::Bar);
                Some(Node::Of(Function::Size, Box::new(inside)))
            }
            Token::Command(name) if name == "frac" => {
                self.at += 1;
                if let Some(derivative) = self.derivative() {
                    return Some(derivative);
                }
                let above = self.single()?;
                Some(join(Joint::Over, above, self.single()?))
            }
            Token::Command(name) if ["sin", "cos", "tan", "acos"].contains(&name.as_str()) => {
                self.at += 1;
                self.function(&name)
            }
            Token::Letter('f') if self.tokens.get(self.at + 1) == Some(&Token::Open) => {
                let start = self.at;
                self.slope().or_else(|| {
                    self.at = start;
                    self.letter()
                })
            }
            Token::Letter(_) | Token::Command(_) => self.letter(),
            Token::Sign(_) | Token::Close => None,
        }
    }

    /// d/dt or ∂/∂θ of the next factor, or ∂T/∂θ as a letter, behind the sign of a fraction. Passes nothing if there is
    /// none.
    fn derivative(&mut self) -> Option<Node> {
        let start = self.at;
        let found = self.operator().or_else(|| {
            self.at = start;
            let [above, below] = [self.differential("partial")?, self.differential("partial")?];
            Some(Node::Letter(format!("d{above}/d{below}")))
        });
        if found.is_none() {
            self.at = start;
        }
        found
    }

    fn operator(&mut self) -> Option<Node> {
        let by = match (self.group()?, self.group()?) {
            ([Token::Letter('d')], [Token::Letter('d'), Token::Letter('t')]) => By::Time,
            ([Token::Command(sign)], [Token::Command(below), of @ ..]) if sign == "partial" && below == "partial" => {
                match whole_letter(of)?.as_str() {
                    "theta" => By::Angle,
                    "theta'" => By::Speed,
                    _ => return None,
                }
            }
            _ => return None,
        };
        Some(Node::Rate(by, Box::new(self.factor()?)))
    }

    /// The letter of a group that is this sign of a differential and a letter.
    fn differential(&mut self, sign: &str) -> Option<String> {
        match self.group()? {
            [Token::Command(found), of @ ..] if found == sign => whole_letter(of),
            _ => None,
        }
    }

    /// What stands in the brackets that open next, which are passed.
    fn group(&mut self) -> Option<&'a [Token]> {
        let start = self.at + 1;
        let mut depth = 0;
        loop {
            match self.next()? {
                Token::Open => depth += 1,
                Token::Close => depth -= 1,
                _ => {}
            }
            self.at += 1;
            if depth == 0 {
                return self.tokens.get(start..self.at - 1);
            }
        }
    }

    /// sin x, sin² x or the inverse, with the next single thing for x.
    fn function(&mut self, name: &str) -> Option<Node> {
        let exponent = if self.pass(&Token::Sign('^')) { Some(self.single()?) } else { None };
        let inverse = exponent == Some(Node::Minus(Box::new(Node::Number(1.0))));
        let function = match (name, inverse) {
            ("sin", false) => Function::Sine,
            ("cos", false) => Function::Cosine,
            ("tan", false) => Function::Tangent,
            ("sin", true) => Function::ArcSine,
            ("cos", true) | ("acos", false) => Function::ArcCosine,
            _ => return None,
        };
        let value = Node::Of(function, Box::new(self.single()?));
        Some(match exponent {
            Some(exponent) if !inverse => join(Joint::Power, value, exponent),
            _ => value,
        })
    }

    /// f(x; y).
    fn slope(&mut self) -> Option<Node> {
        self.at += 2;
        let bars = std::mem::take(&mut self.bars);
        let first = self.sum()?;
        let second = self.pass(&Token::Sign(';')).then(|| self.sum())??;
        self.bars = bars;
        self.pass(&Token::Close).then(|| Node::Slope(Box::new(first), Box::new(second)))
    }

    fn letter(&mut self) -> Option<Node> {
        let mut name = self.name()?;
        // δθ is one letter.
        if name == "delta" {
            name = format!("delta {}", self.name()?);
        }
        if self.pass(&Token::Sign('_')) {
            name.push('_');
            if self.pass(&Token::Open) {
                while !matches!(self.next(), None | Some(Token::Close)) {
                    name += &self.name()?;
                }
                self.pass(&Token::Close);
            } else {
                name += &self.name()?;
            }
        }
        Some(if name == "pi" { Node::Number(PI) } else { Node::Letter(name) })
    }

    /// A letter without its index, or one token of an index.
    fn name(&mut self) -> Option<String> {
        let token = self.next()?.clone();
        self.at += 1;
        Some(match token {
            Token::Letter(letter) => letter.to_string(),
            Token::Number(number) => number.to_string(),
            Token::Sign(sign) => sign.to_string(),
            Token::Command(dots) if dots == "dot" || dots == "ddot" => {
                let braced = self.pass(&Token::Open);
                let name = self.name()?;
                if braced {
                    self.pass(&Token::Close);
                }
                name + if dots == "dot" { "'" } else { "''" }
            }
            Token::Command(name) => name,
            Token::Open | Token::Close | Token::Bar => return None,
        })
    }
}

/// The one letter that the tokens are.
fn whole_letter(tokens: &[Token]) -> Option<String> {
    let mut reader = Reader { tokens, at: 0, bars: 0 };
    match reader.letter()? {
        Node::Letter(name) if reader.at == tokens.len() => Some(name),
        _ => None,
    }
}

fn join(joint: Joint, left: Node, right: Node) -> Node {
    Node::Two(joint, Box::new(left), Box::new(right))
}
