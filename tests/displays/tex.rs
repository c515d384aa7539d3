//! Formulas as they stand between dollar signs: the pieces of TeX, and what they mean.
//!
//! Only what displays of mechanics use. A letter with its index and its raised letters is one name; raised numbers are
//! powers. A function takes the next factor. What is not understood is named.

use super::tree::{Display, Function, Joint, Node, join};
use geneva_ledger::pieces;

/// Reads a display.
pub fn read(tex: &str) -> Result<Display, String> {
    let pieces: Vec<String> = pieces(tex).into_iter().map(|piece| piece.text).collect();
    let mut reader = Reader { pieces: &pieces, at: 0, bars: 0 };
    let mut display = Display { tag: None, chains: Vec::new() };
    while let Some(piece) = reader.next() {
        match piece {
            "," | "." | r"\qquad" | r"\quad" => reader.at += 1,
            r"\tag" => {
                reader.at += 1;
                display.tag = Some(plain(reader.group()?));
            }
            _ => {
                let mut chain = vec![reader.sum()?];
                while reader.takes("=") {
                    chain.push(reader.sum()?);
                }
                display.chains.push(chain);
                let ends = [",", ".", r"\qquad", r"\quad", r"\tag"];
                if let Some(piece) = reader.next().filter(|piece| !ends.contains(piece)) {
                    return Err(format!("`{piece}` behind a whole formula"));
                }
            }
        }
    }
    Ok(display)
}

/// The one spelling of a name.
pub fn name(tex: &str) -> String {
    match read(tex).map(|display| display.chains.into_iter().flatten().collect::<Vec<_>>()).as_deref() {
        Ok([Node::Name(name)]) => name.clone(),
        other => panic!("{tex} is not one name: {other:?}"),
    }
}

/// A place in the pieces of a formula.
pub struct Reader<'a> {
    pub pieces: &'a [String],
    pub at: usize,
    /// How many plain bars are open.
    pub bars: usize,
}

impl<'a> Reader<'a> {
    pub fn next(&self) -> Option<&'a str> {
        self.pieces.get(self.at).map(String::as_str)
    }

    pub fn takes(&mut self, piece: &str) -> bool {
        let found = self.next() == Some(piece);
        self.at += usize::from(found);
        found
    }

    pub fn needs(&mut self, piece: &str) -> Result<(), String> {
        if self.takes(piece) { Ok(()) } else { Err(format!("`{piece}` where {:?} stands", self.next())) }
    }

    /// The pieces of a group in braces, or one piece.
    pub fn group(&mut self) -> Result<&'a [String], String> {
        let start = self.at;
        let mut depth = 0;
        while let Some(piece) = self.next() {
            self.at += 1;
            depth += i32::from(piece == "{") - i32::from(piece == "}");
            match depth {
                0 if piece == "{" || piece == "}" => return Ok(&self.pieces[start + 1..self.at - 1]),
                // A command that takes a group takes its own with it.
                0 if WRAPPERS.contains(&piece) => continue,
                0 => return Ok(&self.pieces[start..self.at]),
                _ => {}
            }
        }
        Err("the end where a group should stand".into())
    }

    pub fn inside(&self, pieces: &'a [String]) -> Result<Node, String> {
        let mut reader = Reader { pieces, at: 0, bars: 0 };
        let node = reader.sum()?;
        match reader.next() {
            None => Ok(node),
            Some(piece) => Err(format!("`{piece}` in a group")),
        }
    }

    pub fn sum(&mut self) -> Result<Node, String> {
        let mut sum: Option<Node> = None;
        loop {
            let sign = match self.next() {
                Some("-") => Some(Function::Minus),
                Some(r"\pm") => Some(Function::PlusMinus),
                Some("+") => None,
                _ if sum.is_none() => {
                    sum = Some(self.product()?);
                    continue;
                }
                _ => break,
            };
            self.at += 1;
            let term = self.product()?;
            let term = match sign {
                Some(sign) => Node::Of(sign, Box::new(term)),
                None => term,
            };
            sum = Some(match sum {
                Some(sum) => join(Joint::Plus, sum, term),
                None => term,
            });
        }
        sum.ok_or_else(|| "no term".into())
    }

    fn product(&mut self) -> Result<Node, String> {
        let mut product = self.power()?;
        loop {
            let joint = match self.next() {
                Some("/") => Joint::Over,
                // A row of crosses is worked from the right.
                Some(r"\times") => {
                    self.at += 1;
                    return Ok(join(Joint::Cross, product, self.product()?));
                }
                Some(r"\cdot") => Joint::Times,
                Some(piece) if self.starts_factor(piece) => {
                    product = join(Joint::Times, product, self.power()?);
                    continue;
                }
                _ => return Ok(product),
            };
            self.at += 1;
            product = join(joint, product, self.power()?);
        }
    }

    fn starts_factor(&self, piece: &str) -> bool {
        let ends = ["+", "-", r"\pm", "=", ",", ".", ")", "]", "}", r"\}", r"\right|", r"\qquad", r"\quad", r"\tag"];
        !ends.contains(&piece) && ![r"\\", r"\end{pmatrix}"].contains(&piece) && (piece != "|" || self.bars == 0)
    }

    /// A factor with its powers.
    pub fn power(&mut self) -> Result<Node, String> {
        let mut factor = self.factor()?;
        while self.takes("^") {
            let raised = self.group()?;
            factor = if raised == [r"\circ"] {
                Node::Of(Function::Degrees, Box::new(factor))
            } else {
                join(Joint::Power, factor, self.inside(raised)?)
            };
        }
        Ok(factor)
    }
}

const WRAPPERS: [&str; 6] = [r"\mathrm", r"\text", r"\dot", r"\ddot", r"\vec", "\\rm"];

/// The characters of a name, without the braces and the type face.
pub fn plain(pieces: &[String]) -> String {
    let faces = ["{", "}", r"\mathrm", r"\text", r"\rm"];
    pieces.iter().map(String::as_str).filter(|piece| !faces.contains(piece)).collect()
}
