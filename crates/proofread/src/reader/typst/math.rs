//! Typst's math mode: a formula's source to a tree.

use crate::reader::typst::scan::{Scan, is_name_start};
use std::ops::Range;

/// Deepest nesting of groups and arguments.
const DEEPEST: usize = 50;

/// A part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Part {
    /// A number, as it is printed.
    Number(Range<usize>),
    /// A single letter or sign.
    Sign(char, Range<usize>),
    /// Text in quotes, without them.
    Text(Range<usize>),
    /// A name of several letters, with its modifiers behind points.
    Name(Range<usize>),
    /// A name with its arguments in brackets, in rows.
    Call(Range<usize>, Vec<Vec<Vec<Part>>>),
    /// A group in brackets, of which the first part is the open one and the last the closed one.
    Group(Vec<Part>),
    /// A fraction, whose brackets are not printed.
    Fraction(Vec<Part>, Vec<Part>),
    /// Something with an index and an exponent; what is missing is empty.
    Scripts(Vec<Part>, Vec<Part>, Vec<Part>),
    /// Something that code puts in.
    Code(Range<usize>),
    /// Space.
    Space(Range<usize>),
    /// The edge of a column.
    Align,
    /// The end of a row.
    Break,
    /// What is nested too deeply.
    TooDeep,
}

/// The parts of a formula that takes this stretch of the source.
pub(super) fn parse(source: &str, range: Range<usize>) -> Vec<Part> {
    let mut parser = MathParser { scan: Scan::new(source, range), depth: 0 };
    let mut out = Vec::new();
    while !parser.scan.is_at_end() {
        out.extend(parser.parts(&[]));
        // A closing bracket without an open one.
        if let Some((c, range)) = parser.scan.next() {
            out.push(Part::Sign(c, range));
        }
    }
    out
}

struct MathParser<'t> {
    scan: Scan<'t>,
    depth: usize,
}

impl MathParser<'_> {
    /// Parts up to one of these signs, or to a closing bracket.
    fn parts(&mut self, ends: &[char]) -> Vec<Part> {
        let mut out: Vec<Part> = Vec::new();
        // How many fractions are in each other.
        let mut strokes = 0;
        while let Some(c) = self.scan.peek() {
            if ends.contains(&c) || (c == ')' && !ends.is_empty()) || (c == ')' && self.depth > 0) {
                break;
            }
            if c == '/' && !self.scan.starts_with("//") && !self.scan.starts_with("/*") {
                self.scan.next();
                self.scan.skip_space();
                while matches!(out.last(), Some(Part::Space(_))) {
                    out.pop();
                }
                let above = out.pop().map(unbracketed).unwrap_or_default();
                let below = self.operand().map(unbracketed).unwrap_or_default();
                strokes = if matches!(above.as_slice(), [Part::Fraction(..)]) { strokes + 1 } else { 0 };
                out.push(if strokes < DEEPEST { Part::Fraction(above, below) } else { Part::TooDeep });
                continue;
            }
            out.extend(self.operand());
        }
        out
    }

    /// An atom with its scripts.
    fn operand(&mut self) -> Option<Part> {
        let mut base = self.atom()?;
        if matches!(base, Part::Space(_) | Part::Align | Part::Break) {
            return Some(base);
        }
        base = self.with_factorial(base);
        let (mut sub, mut sup) = (Vec::new(), Vec::new());
        let mut bases = 0;
        loop {
            let before = self.scan.at;
            self.scan.skip_space();
            let Some(mark) = self.scan.peek().filter(|c| "_^".contains(*c)) else {
                self.scan.at = before;
                break;
            };
            self.scan.next();
            self.scan.skip_space();
            let script = self.atom().map(|atom| self.with_factorial(atom)).map(unbracketed).unwrap_or_default();
            let place = if mark == '_' { &mut sub } else { &mut sup };
            if !place.is_empty() {
                bases += 1;
                if bases > DEEPEST {
                    base = Part::TooDeep;
                }
                base = Part::Scripts(vec![base], std::mem::take(&mut sub), std::mem::take(&mut sup));
            }
            *(if mark == '_' { &mut sub } else { &mut sup }) = script;
        }
        Some(if sub.is_empty() && sup.is_empty() { base } else { Part::Scripts(vec![base], sub, sup) })
    }

    /// A part with the sign of a factorial that touches it; it binds before a stroke and an exponent.
    fn with_factorial(&mut self, part: Part) -> Part {
        if !self.scan.starts_with("!")
            || self.scan.starts_with("!=")
            || matches!(part, Part::Sign(c, _) if !c.is_alphanumeric())
        {
            return part;
        }
        let sign = self.scan.next().map(|(c, range)| Part::Sign(c, range));
        Part::Scripts([part].into_iter().chain(sign).collect(), Vec::new(), Vec::new())
    }

    fn atom(&mut self) -> Option<Part> {
        let start = self.scan.at;
        if self.scan.skip_comment() {
            return Some(Part::Space(start..self.scan.at));
        }
        let (c, range) = self.scan.next()?;
        Some(match c {
            c if c.is_whitespace() => {
                self.scan.skip_space();
                Part::Space(start..self.scan.at)
            }
            '~' => Part::Space(range),
            '&' => Part::Align,
            '\\' => match self.scan.peek() {
                None => Part::Break,
                Some(next) if next.is_whitespace() => Part::Break,
                Some(_) => self.scan.next().map(|(c, range)| Part::Sign(c, range))?,
            },
            '"' => Part::Text(self.scan.string_behind(start)),
            '#' => {
                self.scan.code_expression();
                Part::Code(start..self.scan.at)
            }
            c if c.is_ascii_digit() => Part::Number(self.number(start)),
            c if is_name_start(c) => self.name(start),
            '(' | '[' | '{' => self.group(c, range),
            '.' if self.scan.starts_with("..") => self.several(start, 2, '…'),
            '!' if self.scan.starts_with("=") => self.several(start, 1, '≠'),
            '<' if self.scan.starts_with("=>") => self.several(start, 2, '⇔'),
            '<' if self.scan.starts_with("=") => self.several(start, 1, '≤'),
            '>' if self.scan.starts_with("=") => self.several(start, 1, '≥'),
            '=' if self.scan.starts_with(">") => self.several(start, 1, '⇒'),
            '-' if self.scan.starts_with(">") => self.several(start, 1, '→'),
            c => Part::Sign(c, range),
        })
    }

    /// A sign that is written with so many more characters.
    fn several(&mut self, start: usize, more: usize, sign: char) -> Part {
        for _ in 0..more {
            self.scan.next();
        }
        Part::Sign(sign, start..self.scan.at)
    }

    /// The end of a number, with its point and the commas between its thousands, as far as these are escaped.
    fn number(&mut self, start: usize) -> Range<usize> {
        let digits = |scan: &mut Scan<'_>| {
            while scan.peek().is_some_and(|c| c.is_ascii_digit()) {
                scan.next();
            }
        };
        digits(&mut self.scan);
        while self.scan.starts_with("\\,") && self.scan.digits_at(self.scan.at + 2) == 3 {
            self.scan.at += 2;
            digits(&mut self.scan);
        }
        if self.scan.starts_with(".") && self.scan.digits_at(self.scan.at + 1) > 0 {
            self.scan.at += 1;
            digits(&mut self.scan);
        }
        start..self.scan.at
    }

    /// A letter, or a name of several; with arguments, if a bracket follows at once.
    fn name(&mut self, start: usize) -> Part {
        let c = self.scan.text()[start..].chars().next().unwrap_or_default();
        while self.scan.peek().is_some_and(|c| c.is_ascii_alphanumeric()) && c.is_ascii_alphabetic() {
            self.scan.next();
        }
        while self.scan.starts_with(".") && self.scan.letter_at(self.scan.at + 1) {
            self.scan.next();
            while self.scan.peek().is_some_and(|c| c.is_ascii_alphanumeric()) {
                self.scan.next();
            }
        }
        let range = start..self.scan.at;
        // A letter is printed as it is, whatever follows; digits behind it are a number.
        if !self.scan.text()[range.clone()].chars().nth(1).is_some_and(|c| c.is_ascii_alphabetic()) {
            self.scan.at = start + c.len_utf8();
            let letter = Part::Sign(c, start..self.scan.at);
            return match self.scan.peek() {
                Some('(') => match self.scan.next().map(|(c, range)| self.group(c, range)) {
                    Some(Part::Group(inside)) => {
                        Part::Scripts(vec![letter, Part::Group(inside)], Vec::new(), Vec::new())
                    }
                    _ => letter,
                },
                _ => letter,
            };
        }
        if self.scan.peek() != Some('(') {
            return Part::Name(range);
        }
        self.scan.next();
        if self.depth >= DEEPEST {
            return Part::TooDeep;
        }
        self.depth += 1;
        let mut rows = vec![Vec::new()];
        loop {
            self.scan.skip_space();
            let mut argument = self.parts(&[',', ';', ')']);
            argument.truncate(argument.len() - usize::from(matches!(argument.last(), Some(Part::Space(_)))));
            let mark = self.scan.next().map(|(c, _)| c);
            let is_empty = argument.is_empty();
            if let Some(row) = rows.last_mut().filter(|row| !is_empty || (mark == Some(',') && !row.is_empty())) {
                row.push(argument);
            }
            match mark {
                Some(',') => {}
                Some(';') => rows.push(Vec::new()),
                _ => break,
            }
        }
        self.depth -= 1;
        rows.retain(|row| !row.is_empty());
        Part::Call(range, rows)
    }

    /// A group behind its open bracket.
    fn group(&mut self, open: char, range: Range<usize>) -> Part {
        let close = match open {
            '(' => ')',
            '[' => ']',
            _ => '}',
        };
        if self.depth >= DEEPEST {
            return Part::TooDeep;
        }
        self.depth += 1;
        let mut inside = vec![Part::Sign(open, range)];
        // An interval may be open on one side.
        inside.extend(self.parts(&[')', ']', '}']));
        self.depth -= 1;
        match self.scan.peek() {
            Some(c) if c == close || ")]}".contains(c) => {
                inside.extend(self.scan.next().map(|(c, range)| Part::Sign(c, range)));
                Part::Group(inside)
            }
            _ => Part::Group(inside),
        }
    }
}

/// The parts in a group in round brackets, and any other part as it is: the brackets of a numerator are not printed.
fn unbracketed(part: Part) -> Vec<Part> {
    match part {
        Part::Group(mut inside)
            if matches!(inside.first(), Some(Part::Sign('(', _)))
                && matches!(inside.last(), Some(Part::Sign(')', _))) =>
        {
            inside.pop();
            inside.remove(0);
            inside
        }
        other => vec![other],
    }
}
