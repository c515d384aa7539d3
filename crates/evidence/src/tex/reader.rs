//! From the pieces of a formula to its tree.
//!
//! Only what displays of mechanics use. A letter with its index and its raised letters is one name; raised numbers are
//! powers. A function takes the next factor with its power, and a stroke the factor behind it alone. What is not
//! understood is named.

use super::pieces::{GREEK, pieces};
use super::tree::{By, Function, Joint, Node};
use super::{Display, Illegible};

type Read<T> = Result<T, Illegible>;

/// Pieces that take the group behind them with them.
const WRAPPERS: [&str; 6] = [r"\mathrm", r"\text", r"\dot", r"\ddot", r"\vec", r"\overrightarrow"];
/// Pieces that say only how a name looks.
const FACES: [&str; 5] = ["{", "}", r"\mathrm", r"\text", r"\rm"];
/// What the name of a single letter begins with that is set upright.
pub(super) const UPRIGHT: &str = "upright ";
/// What closes a bracket that is no bar.
const CLOSING: [&str; 3] = [")", "]", r"\}"];
/// Pieces behind a whole formula, where another may begin.
const ENDS: [&str; 5] = [",", ".", r"\qquad", r"\quad", r"\tag"];

/// How brackets must match.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Brackets {
    /// Each is closed once, by its own kind.
    Matched,
    /// Each is closed once, by any kind.
    OfAnyKind,
    /// Of what is cut out of a longer formula: those left open at the end of a side are closed there, those closed too often
    /// are passed over, and any kind closes any other.
    Cut,
}

/// Reads a display.
pub(super) fn read(tex: &str, brackets: Brackets) -> Read<Display> {
    let pieces = without_layout(tex);
    let pieces: Vec<&str> = pieces.iter().map(String::as_str).collect();
    if depth(&pieces) > DEEPEST {
        return illegible(format!("more than {DEEPEST} parts inside one another"));
    }
    let mut reader = Reader { pieces: &pieces, at: 0, bars: 0, brackets };
    let mut display = Display { tag: None, chains: Vec::new() };
    while let Some(piece) = reader.next() {
        match piece {
            r"\tag" => {
                reader.at += 1;
                display.tag = Some(plain(reader.group()?));
            }
            end if ENDS.contains(&end) => reader.at += 1,
            _ => {
                let mut chain = vec![reader.side()?];
                while reader.takes("=") {
                    chain.push(reader.side()?);
                }
                display.chains.push(chain);
                if let Some(piece) = reader.next().filter(|piece| !ENDS.contains(piece)) {
                    return illegible(format!("`{piece}` behind a whole formula"));
                }
            }
        }
    }
    if display.chains.iter().flatten().any(|side| side.highest_power() > HIGHEST_POWER) {
        return illegible(format!("powers of powers, of more than {HIGHEST_POWER} in all"));
    }
    Ok(display)
}

/// Most parts of a formula inside one another. Each takes room on the stack, of which a page has little.
const DEEPEST: usize = 120;
/// The highest power to which anything is raised, by its powers and theirs: beyond, a proof would not end.
const HIGHEST_POWER: u64 = 4096;

/// How many parts may be inside one another at most: brackets that are open, bars, and signs or functions in a row.
fn depth(pieces: &[&str]) -> usize {
    let (mut open, mut bars, mut in_a_row, mut deepest) = (0_usize, 0, 0_usize, 0);
    for piece in pieces {
        let is_operand = piece.chars().all(char::is_alphanumeric) && !piece.is_empty();
        in_a_row = if is_operand { 0 } else { in_a_row + 1 };
        match *piece {
            "(" | "[" | "{" | r"\{" | r"\left|" => open += 1,
            ")" | "]" | "}" | r"\}" | r"\right|" => {
                open = open.saturating_sub(1);
                in_a_row = 0;
            }
            "|" => bars += 1,
            _ => {}
        }
        deepest = deepest.max(open + bars).max(in_a_row);
    }
    deepest
}

/// The one name that a formula is.
pub(super) fn name(tex: &str) -> Read<String> {
    let pieces = without_layout(tex);
    name_of(&pieces.iter().map(String::as_str).collect::<Vec<_>>())
}

/// The one name that pieces are, with what hangs on it.
fn name_of(pieces: &[&str]) -> Read<String> {
    match Reader::inside(pieces, Reader::factor)? {
        Node::Name(name) => Ok(name),
        _ => illegible(format!("`{}` where a name should be", plain(pieces))),
    }
}

/// The pieces without those that only say where to print the others: lines of one formula, not of a column. Units in
/// one word, one over the other, become two words.
fn without_layout(tex: &str) -> Vec<String> {
    let (mut in_column, mut in_word, mut starts_line) = (false, false, false);
    let mut kept: Vec<String> = Vec::new();
    for piece in pieces(tex) {
        let piece = piece.text;
        in_column = (in_column || piece == r"\begin{pmatrix}") && piece != r"\end{pmatrix}";
        in_word = (in_word || piece == r"\text") && piece != "}";
        let layout = match piece.as_str() {
            "&" | r"\begin{aligned}" | r"\end{aligned}" => true,
            r"\\" => !in_column,
            r"\quad" => starts_line,
            _ => false,
        };
        starts_line = layout;
        match piece.as_str() {
            _ if layout => {}
            "/" if in_word => kept.extend(["}", "/", r"\text", "{"].map(str::to_owned)),
            _ => kept.push(piece),
        }
    }
    kept
}

/// The characters of a name, without braces, type faces and backslashes.
fn plain(pieces: &[&str]) -> String {
    let kept = pieces.iter().filter(|piece| !FACES.contains(piece));
    kept.map(|piece| piece.trim_start_matches('\\')).collect()
}

fn illegible<T>(what: impl Into<String>) -> Read<T> {
    Err(Illegible(what.into()))
}

/// A place in the pieces of a formula.
struct Reader<'a> {
    pieces: &'a [&'a str],
    at: usize,
    /// How many plain bars are open.
    bars: usize,
    brackets: Brackets,
}

impl<'a> Reader<'a> {
    fn next(&self) -> Option<&'a str> {
        self.pieces.get(self.at).copied()
    }

    fn takes(&mut self, piece: &str) -> bool {
        let found = self.next() == Some(piece);
        self.at += usize::from(found);
        found
    }

    fn needs(&mut self, piece: &str) -> Read<()> {
        match self.next() {
            _ if self.takes(piece) => Ok(()),
            None | Some("=") if self.brackets == Brackets::Cut => Ok(()),
            Some(other)
                if self.brackets != Brackets::Matched && [other, piece].iter().all(|piece| CLOSING.contains(piece)) =>
            {
                self.at += 1;
                Ok(())
            }
            next => illegible(format!("`{}` where `{piece}` should be", next.unwrap_or("the end"))),
        }
    }

    /// The pieces of a group in braces, or one piece with all that it takes.
    fn group(&mut self) -> Read<&'a [&'a str]> {
        let start = self.at;
        let mut depth = 0;
        while let Some(piece) = self.next() {
            self.at += 1;
            depth += i32::from(piece == "{") - i32::from(piece == "}");
            match depth {
                0 if self.pieces[start] == "{" => return Ok(&self.pieces[start + 1..self.at - 1]),
                0 if WRAPPERS.contains(&piece) => {}
                0 => return Ok(&self.pieces[start..self.at]),
                _ => {}
            }
        }
        illegible("the end where a group should be")
    }

    /// What all of these pieces say.
    fn inside<T>(pieces: &'a [&'a str], read: impl Fn(&mut Self) -> Read<T>) -> Read<T> {
        let mut reader = Self { pieces, at: 0, bars: 0, brackets: Brackets::Matched };
        let found = read(&mut reader)?;
        match reader.next() {
            None => Ok(found),
            Some(piece) => illegible(format!("`{piece}` in a group")),
        }
    }

    fn side(&mut self) -> Read<Node> {
        let side = self.sum()?;
        while self.brackets == Brackets::Cut
            && self.next().is_some_and(|piece| piece == r"\right|" || CLOSING.contains(&piece))
        {
            self.at += 1;
        }
        Ok(side)
    }

    fn sum(&mut self) -> Read<Node> {
        let mut sum = self.term()?;
        while let Some("+" | "-" | r"\pm") = self.next() {
            sum = sum.join(Joint::Plus, self.term()?);
        }
        Ok(sum)
    }

    /// A product with its sign, if it has one.
    fn term(&mut self) -> Read<Node> {
        let sign = match self.next() {
            Some("-") => Some(Function::Minus),
            Some(r"\pm") => Some(Function::PlusMinus),
            _ => None,
        };
        self.at += usize::from(sign.is_some() || self.next() == Some("+"));
        let product = self.product()?;
        Ok(if let Some(sign) = sign { product.of(sign) } else { product })
    }

    fn product(&mut self) -> Read<Node> {
        let mut product = self.power()?;
        while let Some(piece) = self.next() {
            let joint = match piece {
                "/" => Joint::Over,
                r"\times" => Joint::Cross,
                r"\cdot" => Joint::Times,
                _ if self.starts_factor(piece) => Joint::Times,
                _ => break,
            };
            self.at += usize::from(["/", r"\times", r"\cdot"].contains(&piece));
            // A row of crosses is worked from the right.
            let next = if joint == Joint::Cross { self.product()? } else { self.power()? };
            product = product.join(joint, next);
        }
        Ok(product)
    }

    fn starts_factor(&self, piece: &str) -> bool {
        let ends = ["+", "-", r"\pm", "=", ";", ")", "]", "}", r"\}", r"\right|", r"\\", r"\end{pmatrix}"];
        !ends.contains(&piece) && !ENDS.contains(&piece) && (piece != "|" || self.bars == 0)
    }

    /// A factor with its powers.
    fn power(&mut self) -> Read<Node> {
        let mut factor = self.factor()?;
        while self.takes("^") {
            factor = match self.group()? {
                [r"\circ"] => factor.of(Function::Degrees),
                raised => factor.join(Joint::Power, Self::inside(raised, Self::sum)?),
            };
        }
        Ok(factor)
    }

    /// A factor without its powers.
    fn factor(&mut self) -> Read<Node> {
        use Function::*;
        let Some(piece) = self.next() else { return illegible("the end where a factor should be") };
        let start = self.at;
        self.at += 1;
        match piece {
            "(" => self.bracket(")", Self::sum),
            "[" => self.bracket("]", Self::sum),
            r"\{" => self.bracket(r"\}", Self::sum),
            "|" => self.size("|"),
            r"\left|" => self.size(r"\right|"),
            r"\frac" | r"\tfrac" => self.fraction(),
            r"\sqrt" => Ok(Self::inside(self.group()?, Self::sum)?.of(Root)),
            r"\sin" => self.function(Sine, Some(ArcSine)),
            r"\cos" => self.function(Cosine, Some(ArcCosine)),
            r"\tan" => self.function(Tangent, Some(ArcTangent)),
            r"\sec" => self.function(Secant, None),
            r"\begin{pmatrix}" => self.bracket(r"\end{pmatrix}", |reader| {
                let first = reader.sum()?;
                reader.needs(r"\\")?;
                Ok(first.join(Joint::Column, reader.sum()?))
            }),
            "f" if self.takes("(") => self.bracket(")", |reader| {
                let first = reader.sum()?;
                if !reader.takes(",") {
                    reader.needs(";")?;
                }
                Ok(first.join(Joint::Slope, reader.sum()?))
            }),
            // A number without a figure before its point.
            "." => {
                let behind = self.next().unwrap_or_default();
                self.at += 1;
                decimal("0", behind)
            }
            number if number.starts_with(|c: char| c.is_ascii_digit()) => {
                let (whole, behind) = number.split_once('.').unwrap_or((number, ""));
                decimal(whole, behind)
            }
            _ => {
                self.at = start;
                match self.group()? {
                    [r"\text", "{", "a", "c", "o", "s", "}"] => self.function(ArcCosine, None),
                    group if piece == "{" => Self::inside(group, Self::sum),
                    letter => self.letter(letter),
                }
            }
        }
    }

    /// What stands in a bracket that is open.
    fn bracket(&mut self, close: &str, read: impl Fn(&mut Self) -> Read<Node>) -> Read<Node> {
        // Bars open outside the bracket do not close inside it.
        let outside = std::mem::replace(&mut self.bars, usize::from(close == "|"));
        let inside = read(self)?;
        self.needs(close)?;
        self.bars = outside;
        Ok(inside)
    }

    /// What stands between bars; an index names the instant at which it does.
    fn size(&mut self, close: &str) -> Read<Node> {
        let mut inside = self.bracket(close, Self::sum)?;
        if self.takes("_") {
            let instant = plain(self.group()?);
            inside = inside.renamed(&|name| super::name_at(name, &instant));
        }
        Ok(inside.of(Function::Size))
    }

    /// A fraction; derivatives are written as fractions too.
    fn fraction(&mut self) -> Read<Node> {
        Ok(match (self.group()?, self.group()?) {
            (["d"], ["d", "t"]) => self.power()?.of(Function::Rate(By::Time)),
            (["d", of @ ..], ["d", "t"]) => Self::inside(of, Self::power)?.of(Function::Rate(By::Time)),
            ([r"\partial"], [r"\partial", by @ ..]) => match name_of(by)?.as_str() {
                "theta" => self.power()?.of(Function::Rate(By::Angle)),
                "theta'" => self.power()?.of(Function::Rate(By::Speed)),
                other => return illegible(format!("a derivative by `{other}`")),
            },
            ([r"\partial", of @ ..], [r"\partial", by @ ..]) | (["d", of @ ..], ["d", by @ ..]) => {
                Node::Name(format!("d{}/d{}", name_of(of)?, name_of(by)?))
            }
            (above, below) => Self::inside(above, Self::sum)?.join(Joint::Over, Self::inside(below, Self::sum)?),
        })
    }

    /// A function of the next factor, its power or its inverse.
    fn function(&mut self, function: Function, inverse: Option<Function>) -> Read<Node> {
        let raised = if self.takes("^") { Some(self.group()?) } else { None };
        let of = self.power()?;
        match (raised, inverse) {
            (None, _) => Ok(of.of(function)),
            (Some(["-", "1"]), Some(inverse)) => Ok(of.of(inverse)),
            (Some(["-", "1"]), None) => illegible(format!("an inverse of {function:?}")),
            (Some(raised), _) => Ok(of.of(function).join(Joint::Power, Self::inside(raised, Self::sum)?)),
        }
    }

    /// A letter with its accents, its index and what of its exponent is a name; π is a name too.
    fn letter(&mut self, letter: &'a [&'a str]) -> Read<Node> {
        let mut name = match letter {
            [r"\dot", of @ ..] => name_of(of)? + "'",
            [r"\ddot", of @ ..] => name_of(of)? + "''",
            [r"\vec" | r"\overrightarrow", of @ ..] => format!("vec {}", plain(of)),
            // A small step of what follows.
            [r"\delta"] => format!("delta {}", name_of(self.group()?)?),
            // A letter that is set upright is another letter than the same in italics.
            [r"\mathrm" | r"\text", "{", piece, "}"] if piece.chars().count() == 1 => format!("{UPRIGHT}{piece}"),
            [r"\mathrm" | r"\text", ..] => plain(letter),
            [piece] if *piece == r"\pi" || GREEK.contains(piece) || piece.chars().all(char::is_alphabetic) => {
                plain(letter)
            }
            _ => return illegible(format!("`{}` where a letter should be", letter.concat())),
        };
        loop {
            let start = self.at;
            if self.takes("_") {
                name += &format!("_{}", plain(self.group()?));
            } else if self.takes("'") {
                // Not the dots of a rate.
                name.push('′');
            } else if self.takes("^") {
                let raised = self.group()?;
                if !raised.iter().all(|piece| FACES.contains(piece) || piece.chars().all(char::is_alphabetic)) {
                    self.at = start;
                    return Ok(Node::Name(name));
                }
                name += &format!("^{}", plain(raised));
            } else {
                return Ok(Node::Name(name));
            }
        }
    }
}

/// A number from its digits before and behind the point.
fn decimal(whole: &str, behind: &str) -> Read<Node> {
    match format!("{whole}{behind}").parse() {
        Ok(digits) => Ok(Node::Number(digits, behind.len() as u32)),
        Err(_) => illegible(format!("`{whole}.{behind}` where a number should be")),
    }
}
