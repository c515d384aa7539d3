//! The factors of a formula: brackets, fractions, functions, columns, and letters with all that hangs on them.

use super::tex::{Reader, plain};
use super::tree::{Function, Joint, Node, at, join};
use geneva_ledger::GREEK;

impl<'a> Reader<'a> {
    /// A factor without its powers.
    pub fn factor(&mut self) -> Result<Node, String> {
        let piece = self.next().ok_or("the end where a factor should stand")?;
        self.at += 1;
        match piece {
            "(" | "[" | r"\{" | "|" | r"\left|" => self.bracket(piece),
            r"\frac" | r"\tfrac" => self.fraction(),
            r"\sqrt" => Ok(Node::Of(Function::Root, Box::new(self.group().and_then(|group| self.inside(group))?))),
            r"\begin{pmatrix}" => self.column(),
            r"\sin" => self.function(Function::Sine, Some(Function::ArcSine)),
            r"\cos" => self.function(Function::Cosine, Some(Function::ArcCosine)),
            r"\tan" => self.function(Function::Tangent, Some(Function::ArcTangent)),
            r"\sec" => self.function(Function::Secant, None),
            r"\pi" => Ok(Node::Number(std::f64::consts::PI)),
            "{" => {
                self.at -= 1;
                let group = self.group()?;
                self.inside(group)
            }
            number if number.starts_with(|c: char| c.is_ascii_digit()) => {
                number.parse().map(Node::Number).map_err(|_| format!("the number {number}"))
            }
            _ => {
                self.at -= 1;
                let letter = self.letter()?;
                Ok(self.call(&letter).unwrap_or(letter))
            }
        }
    }

    /// A function of two arguments, if a pair in brackets follows its letter.
    fn call(&mut self, letter: &Node) -> Option<Node> {
        let Node::Name(name) = letter else { return None };
        let (start, bars) = (self.at, self.bars);
        let mut pair = || {
            self.needs("(").ok()?;
            let first = self.sum().ok()?;
            self.needs(",").ok()?;
            let second = self.sum().ok()?;
            self.needs(")").ok()?;
            Some(Node::Call(name.clone(), Box::new(first), Box::new(second)))
        };
        let call = pair();
        if call.is_none() {
            (self.at, self.bars) = (start, bars);
        }
        call
    }

    fn bracket(&mut self, open: &str) -> Result<Node, String> {
        let close = match open {
            "(" => ")",
            "[" => "]",
            r"\{" => r"\}",
            r"\left|" => r"\right|",
            _ => "|",
        };
        let bar = usize::from(open == "|");
        let outside = std::mem::replace(&mut self.bars, bar);
        let node = self.sum()?;
        self.needs(close)?;
        self.bars = outside;
        if close == ")" || close == "]" || close == r"\}" {
            return Ok(node);
        }
        let node = if self.takes("_") { at(node, &plain(self.group()?)) } else { node };
        Ok(Node::Of(Function::Size, Box::new(node)))
    }

    /// A fraction; derivatives are written as fractions too.
    fn fraction(&mut self) -> Result<Node, String> {
        let (above, below) = (self.group()?, self.group()?);
        if above == ["d"] && below == ["d", "t"] {
            return Ok(Node::Of(Function::Rate, Box::new(self.power()?)));
        }
        if let (["d", of @ ..], ["d", "t"]) = (&strs(above)[..], &strs(below)[..]) {
            let of: Vec<String> = of.iter().map(|piece| (*piece).to_owned()).collect();
            let node = Reader { pieces: &of, at: 0, bars: 0 }.power()?;
            return Ok(Node::Of(Function::Rate, Box::new(node)));
        }
        let is_small = |pieces: &[String]| pieces.len() > 1 && pieces[0] == "d";
        if above.first().is_some_and(|piece| piece == r"\partial") || is_small(above) && is_small(below) {
            return Ok(Node::Name(format!("{}/{}", plain(above), plain(below))));
        }
        Ok(join(Joint::Over, self.inside(above)?, self.inside(below)?))
    }

    fn function(&mut self, function: Function, inverse: Option<Function>) -> Result<Node, String> {
        let raised = if self.takes("^") { Some(self.group()?) } else { None };
        if raised.is_some_and(|raised| raised == ["-", "1"]) {
            let inverse = inverse.ok_or("an inverse")?;
            return Ok(Node::Of(inverse, Box::new(self.power()?)));
        }
        let value = Node::Of(function, Box::new(self.power()?));
        match raised {
            Some(raised) => Ok(join(Joint::Power, value, self.inside(raised)?)),
            None => Ok(value),
        }
    }

    fn column(&mut self) -> Result<Node, String> {
        let first = self.sum()?;
        self.needs(r"\\")?;
        let second = self.sum()?;
        self.needs(r"\end{pmatrix}")?;
        Ok(Node::Column(Box::new(first), Box::new(second)))
    }

    /// A letter with its accents, its index and what of its exponent is a name.
    fn letter(&mut self) -> Result<Node, String> {
        let piece = self.next().unwrap_or_default();
        let mut name = match piece {
            r"\dot" | r"\ddot" | r"\vec" | r"\overrightarrow" => {
                self.at += 1;
                format!("{piece}{{{}}}", plain(self.group()?))
            }
            r"\mathrm" | r"\text" => {
                self.at += 1;
                plain(self.group()?)
            }
            _ if GREEK.contains(&piece) || piece.chars().all(char::is_alphabetic) => plain(self.group()?),
            _ => return Err(format!("`{piece}`")),
        };
        loop {
            let start = self.at;
            if self.takes("_") {
                name += &format!("_{{{}}}", plain(self.group()?));
            } else if self.takes("'") {
                name.push('\'');
            } else if self.takes("^") {
                let raised = self.group()?;
                if !raised
                    .iter()
                    .all(|piece| piece.chars().all(char::is_alphabetic) || piece == r"\mathrm" || "{}".contains(piece))
                {
                    self.at = start;
                    return Ok(Node::Name(name));
                }
                name += &format!("^{{{}}}", plain(raised));
            } else {
                return Ok(Node::Name(name));
            }
        }
    }
}

fn strs(pieces: &[String]) -> Vec<&str> {
    pieces.iter().map(String::as_str).collect()
}
