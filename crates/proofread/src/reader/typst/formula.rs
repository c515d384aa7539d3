//! A formula of Typst as MathML, each part of which has its place in the source.

use super::math::Part;
use super::symbols::{Named, named};
use crate::reader::office::MadePage;
use crate::token::Span;
use std::collections::HashMap;
use std::ops::Range;

/// What `#let` gives to a name.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Given {
    /// A formula or a number, as parts of the source.
    Formula(Vec<Part>),
    /// Something else.
    Other,
}

/// What the names of a document stand for.
pub(super) type Names = HashMap<String, Given>;

/// Deepest use of names in the values of names.
const DEEPEST_NAMES: usize = 8;
/// Most parts that are put in for names in one formula.
const MOST_PUT_IN: usize = 2000;

/// Writes formulas to a page.
pub(super) struct FormulaWriter<'w> {
    pub source: &'w str,
    pub page: &'w mut MadePage,
    pub names: &'w Names,
    /// The place of the name for which something is put in.
    stands_for: Option<Range<usize>>,
    depth: usize,
    put_in: usize,
}

impl<'w> FormulaWriter<'w> {
    pub(super) fn new(source: &'w str, page: &'w mut MadePage, names: &'w Names) -> Self {
        Self { source, page, names, stands_for: None, depth: 0, put_in: 0 }
    }

    /// Writes a whole formula.
    pub(super) fn formula(&mut self, parts: &[Part]) {
        self.page.tags("<math>");
        self.rows(parts);
        self.page.tags("</math>");
    }

    /// Writes parts, as a table where they have rows.
    fn rows(&mut self, parts: &[Part]) {
        let rows: Vec<&[Part]> = parts.split(|part| *part == Part::Break).collect();
        if rows.len() < 2 && !parts.contains(&Part::Align) {
            return self.parts(parts);
        }
        self.page.tags("<mtable>");
        for row in rows {
            self.page.tags("<mtr>");
            for cell in row.split(|part| *part == Part::Align) {
                self.page.tags("<mtd>");
                self.parts(cell);
                self.page.tags("</mtd>");
            }
            self.page.tags("</mtr>");
        }
        self.page.tags("</mtable>");
    }

    fn parts(&mut self, parts: &[Part]) {
        for (at, part) in parts.iter().enumerate() {
            // Space is printed beside numbers and text alone.
            let is_wide = |at: usize| matches!(parts.get(at), Some(Part::Number(_) | Part::Text(_)));
            if matches!(part, Part::Space(_)) && !is_wide(at + 1) && !at.checked_sub(1).is_some_and(is_wide) {
                continue;
            }
            self.part(part);
        }
    }

    fn element(&mut self, name: &str, parts: &[Part]) {
        self.page.tags(&format!("<{name}>"));
        self.parts(parts);
        self.page.tags(&format!("</{name}>"));
    }

    /// A leaf with the characters that stand at its place, or that stand for what is there.
    fn leaf(&mut self, element: &str, characters: &str, range: &Range<usize>) {
        self.page.tags(&format!("<{element}>"));
        let place = self.stands_for.as_ref().unwrap_or(range);
        if self.stands_for.is_none() && self.source.get(range.clone()) == Some(characters) {
            self.page.characters_at(characters, range.start);
        } else {
            let escaped = characters.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
            self.page.sign_for(&escaped, Span::new(place.start, place.end));
        }
        self.page.tags(&format!("</{}>", element.split(' ').next().unwrap_or_default()));
    }

    /// Something that is not known, by its name.
    fn unknown(&mut self, name: &str, range: &Range<usize>) {
        let name: String = name.chars().filter(|c| c.is_ascii_alphanumeric() || "-.".contains(*c)).collect();
        self.leaf(&format!("unknown-{name}"), "", range);
    }

    fn part(&mut self, part: &Part) {
        match part {
            Part::Number(range) => {
                let digits = self.source[range.clone()].replace('\\', "");
                self.leaf("mn", &digits, range);
            }
            Part::Sign(c, range) => {
                let element = if c.is_alphabetic() || "°%".contains(*c) { "mi" } else { "mo" };
                let sign = if *c == '-' { '−' } else { *c };
                let is_printed = self.source.get(range.clone()).is_some_and(|text| text.len() == c.len_utf8());
                self.leaf(element, &if is_printed { *c } else { sign }.to_string(), range);
            }
            Part::Text(range) => {
                let text = self.source[range.clone()].replace('\\', "");
                self.leaf("mtext", &text, range);
            }
            Part::Name(range) => self.name(range),
            Part::Call(range, rows) => self.call(range, rows),
            Part::Group(inside) => self.parts(inside),
            Part::Fraction(above, below) => {
                self.page.tags("<mfrac>");
                self.element("mrow", above);
                self.element("mrow", below);
                self.page.tags("</mfrac>");
            }
            Part::Scripts(base, sub, sup) if sub.is_empty() && sup.is_empty() => self.parts(base),
            Part::Scripts(base, sub, sup) => {
                self.page.tags("<msubsup>");
                for part in [base, sub, sup] {
                    self.element("mrow", part);
                }
                self.page.tags("</msubsup>");
            }
            Part::Code(range) => {
                let code = self.source[range.clone()].trim_start_matches('#').to_owned();
                match self.names.get(&code) {
                    Some(Given::Formula(value)) => self.put_in(value, range),
                    _ => self.unknown(code.split(['(', '[', '.']).next().unwrap_or_default(), range),
                }
            }
            Part::Space(_) => self.page.tags("<mspace/>"),
            Part::Align | Part::Break => {}
            Part::TooDeep => self.page.tags("<unknown-nesting/>"),
        }
    }

    /// Writes what a name stands for, at the place of the name.
    fn put_in(&mut self, value: &'w [Part], range: &Range<usize>) {
        self.put_in += value.len();
        if self.depth >= DEEPEST_NAMES || self.put_in > MOST_PUT_IN {
            return self.unknown("nested", range);
        }
        let outer = self.stands_for.clone();
        self.stands_for = Some(outer.clone().unwrap_or_else(|| range.clone()));
        self.depth += 1;
        self.parts(value);
        self.depth -= 1;
        self.stands_for = outer;
    }

    fn name(&mut self, range: &Range<usize>) {
        let name = self.source[range.clone()].to_owned();
        if let Some(given) = self.names.get(&name) {
            return match given {
                Given::Formula(value) => self.put_in(value, range),
                Given::Other => self.unknown(&name, range),
            };
        }
        match named(&name) {
            Some(Named::Sign(element, sign)) => self.leaf(element, &sign.to_string(), range),
            Some(Named::Unit(unit)) => self.leaf("mtext", unit, range),
            Some(Named::Space(width)) => self.page.tags(&format!("<mspace width=\"{width}em\"/>")),
            Some(Named::Operator) => self.leaf("mi", &name, range),
            None => self.unknown(&name, range),
        }
    }

    fn call(&mut self, range: &Range<usize>, rows: &[Vec<Vec<Part>>]) {
        let name = self.source[range.clone()].to_owned();
        let arguments: Vec<&[Part]> =
            rows.iter().flatten().map(Vec::as_slice).filter(|argument| !self.is_named(argument)).collect();
        if self.names.contains_key(&name) {
            return self.unknown(&name, range);
        }
        match (name.as_str(), arguments.as_slice()) {
            ("frac", [above, below]) => {
                self.page.tags("<mfrac>");
                self.element("mrow", above);
                self.element("mrow", below);
                self.page.tags("</mfrac>");
            }
            ("binom", [above, below]) => {
                self.page.tags("<mfrac linethickness=\"0\">");
                self.element("mrow", above);
                self.element("mrow", below);
                self.page.tags("</mfrac>");
            }
            ("sqrt", [inside]) => self.element("msqrt", inside),
            ("root", [inside]) => self.element("msqrt", inside),
            ("root", [degree, inside]) => {
                self.page.tags("<mroot>");
                self.element("mrow", inside);
                self.element("mrow", degree);
                self.page.tags("</mroot>");
            }
            ("abs", [inside]) => self.between('|', '|', range, inside),
            ("floor", [inside]) => self.between('⌊', '⌋', range, inside),
            ("ceil", [inside]) => self.between('⌈', '⌉', range, inside),
            ("upright" | "rm", [inside]) => self.upright(inside),
            ("op", [inside, ..]) => self.operator(inside),
            (
                "lr" | "italic" | "bold" | "sans" | "serif" | "mono" | "display" | "inline" | "script" | "sscript"
                | "limits" | "scripts" | "cancel" | "stretch" | "text",
                [inside],
            ) => self.parts(inside),
            ("class", [_, inside]) => self.parts(inside),
            ("overline" | "macron", [inside]) => self.over(inside, '¯', range),
            ("hat", [inside]) => self.over(inside, '^', range),
            ("arrow", [inside]) => self.over(inside, '→', range),
            ("dot", [inside]) => self.over(inside, '˙', range),
            ("dot.double", [inside]) => self.over(inside, '¨', range),
            ("vec", cells) => {
                let open = self.delimiter(rows);
                self.matrix(&cells.iter().map(|cell| vec![*cell]).collect::<Vec<_>>(), open, range);
            }
            ("mat", _) => {
                let open = self.delimiter(rows);
                let cells = |row: &'_ Vec<Vec<Part>>| -> Vec<Vec<Part>> {
                    row.iter().filter(|cell| !self.is_named(cell)).cloned().collect()
                };
                let rows: Vec<Vec<Vec<Part>>> = rows.iter().map(cells).filter(|row| !row.is_empty()).collect();
                let rows: Vec<Vec<&[Part]>> = rows.iter().map(|row| row.iter().map(Vec::as_slice).collect()).collect();
                self.matrix(&rows, open, range);
            }
            (_, arguments) if named(&name).is_some() => {
                // A sign or function whose brackets are printed: sin(30 degree), max(2, 5).
                self.name(range);
                self.leaf("mo", "(", range);
                for (at, argument) in arguments.iter().enumerate() {
                    if at > 0 {
                        self.leaf("mo", ",", range);
                    }
                    self.parts(argument);
                }
                self.leaf("mo", ")", range);
            }
            _ => self.unknown(&name, range),
        }
    }

    /// Whether an argument has a name: `delim: "["`.
    fn is_named(&self, argument: &[Part]) -> bool {
        let mut parts = argument.iter().filter(|part| !matches!(part, Part::Space(_)));
        let is_name =
            |part: &Part| matches!(part, Part::Name(_)) || matches!(part, Part::Sign(c, _) if c.is_alphabetic());
        parts.next().is_some_and(is_name) && matches!(parts.next(), Some(Part::Sign(':', _)))
    }

    /// The bracket before a matrix or vector.
    fn delimiter(&self, rows: &[Vec<Vec<Part>>]) -> Option<char> {
        let given = rows.iter().flatten().find(|argument| self.is_named(argument));
        match given.and_then(|argument| argument.last()) {
            Some(Part::Text(range)) => self.source[range.clone()].chars().next(),
            Some(Part::Code(_)) => None,
            _ => Some('('),
        }
    }

    fn matrix(&mut self, rows: &[Vec<&[Part]>], open: Option<char>, range: &Range<usize>) {
        let close = open.map(|open| match open {
            '(' => ')',
            '[' => ']',
            '{' => '}',
            other => other,
        });
        open.into_iter().for_each(|open| self.leaf("mo", &open.to_string(), range));
        self.page.tags("<mtable notation=\"matrix\">");
        for row in rows {
            self.page.tags("<mtr>");
            row.iter().for_each(|cell| self.element("mtd", cell));
            self.page.tags("</mtr>");
        }
        self.page.tags("</mtable>");
        close.into_iter().for_each(|close| self.leaf("mo", &close.to_string(), range));
    }

    fn between(&mut self, open: char, close: char, range: &Range<usize>, inside: &[Part]) {
        self.leaf("mo", &open.to_string(), range);
        self.parts(inside);
        self.leaf("mo", &close.to_string(), range);
    }

    fn over(&mut self, inside: &[Part], sign: char, range: &Range<usize>) {
        self.page.tags("<mover>");
        self.element("mrow", inside);
        self.leaf("mo", &sign.to_string(), range);
        self.page.tags("</mover>");
    }

    /// Letters that are printed upright, as units are.
    fn upright(&mut self, inside: &[Part]) {
        for part in inside {
            match part {
                Part::Sign(c, range) if c.is_alphabetic() => self.leaf("mtext", &c.to_string(), range),
                Part::Name(range) if !self.names.contains_key(&self.source[range.clone()]) => {
                    let name = self.source[range.clone()].to_owned();
                    match named(&name) {
                        Some(Named::Sign("mi", letter)) => self.leaf("mtext", &letter.to_string(), range),
                        _ => self.name(range),
                    }
                }
                other => self.part(other),
            }
        }
    }

    fn operator(&mut self, inside: &[Part]) {
        match inside {
            [Part::Text(range)] => {
                let name = self.source[range.clone()].to_owned();
                self.leaf("mi", &name, range);
            }
            other => self.parts(other),
        }
    }
}
