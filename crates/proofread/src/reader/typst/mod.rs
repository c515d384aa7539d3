//! Documents in Typst: their formulas and their running text, as a page whose places are those of the source.
//!
//! Nothing is compiled. Of code, the values that `#let` gives to names are read, and the text in square brackets.

mod formula;
mod math;
mod scan;
mod symbols;

use super::office::MadePage;
use super::unread::{UnreadKind, UnreadParts, note};
use crate::decimal::parse_decimal;
use crate::token::Span;
use formula::{FormulaWriter, Given, Names};
use math::Part;
use scan::Scan;
use std::ops::Range;
use symbols::sign_named;

/// Deepest nesting of text in code and of code in text.
const DEEPEST: usize = 40;
/// Words that begin a statement, which goes on to the end of its line.
const STATEMENTS: [&str; 10] =
    ["let", "set", "show", "import", "include", "return", "context", "break", "continue", "while"];

/// Reads a document, and what of it is not read.
pub(crate) fn read(source: &str) -> (MadePage, UnreadParts) {
    let mut reading =
        Reading { source, page: MadePage::default(), unread: UnreadParts::default(), names: Names::new(), depth: 0 };
    reading.page.tags("<p>");
    reading.markup(0..source.len());
    reading.page.tags("</p>");
    (reading.page, reading.unread)
}

struct Reading<'t> {
    source: &'t str,
    page: MadePage,
    unread: UnreadParts,
    names: Names,
    depth: usize,
}

impl Reading<'_> {
    /// Ends a paragraph, and begins another one.
    fn block(&mut self) {
        self.page.tags("</p>\n<p>");
    }

    /// Something that is cut out of the line.
    fn edge(&mut self, range: Range<usize>) {
        self.page.sign_for("<img/>", Span::new(range.start, range.end));
    }

    /// Text as it is written.
    fn text(&mut self, range: Range<usize>) {
        self.page.characters_at(&self.source[range.clone()], range.start);
    }

    /// Reads text with its marks.
    fn markup(&mut self, range: Range<usize>) {
        if self.depth >= DEEPEST {
            note(&mut self.unread, UnreadKind::Code, "", &self.source[range]);
            return;
        }
        self.depth += 1;
        let mut scan = Scan::new(self.source, range);
        let mut is_line_start = true;
        while !scan.is_at_end() {
            let start = scan.at;
            if is_line_start {
                scan.skip_space();
                if self.source[start..scan.at].matches('\n').count() > 0 {
                    self.page.tags("\n");
                }
                self.line_start(&mut scan);
                is_line_start = false;
                continue;
            }
            let before = self.source[..start].chars().next_back();
            if before != Some(':') && scan.skip_comment() {
                note(&mut self.unread, UnreadKind::Comment, "", &self.source[start..scan.at]);
                continue;
            }
            let Some((c, place)) = scan.next() else { break };
            match c {
                '\n' => {
                    is_line_start = true;
                    if scan.rest().split('\n').next().is_some_and(|line| line.trim().is_empty()) {
                        self.block();
                    } else {
                        self.text(place);
                    }
                }
                '$' => self.formula(&mut scan),
                '`' => self.raw(&mut scan, start),
                '#' => self.code(&mut scan, start),
                '\\' => match scan.next() {
                    Some((next, _)) if next.is_whitespace() => self.page.tags("<br/>\n"),
                    Some((_, place)) => self.text(place),
                    None => {}
                },
                '~' => self.page.sign_for(" ", Span::new(place.start, place.end)),
                '*' | '_' => {
                    let letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
                    if letter(before) && letter(scan.peek()) {
                        self.text(place);
                    }
                }
                '<' if label_length(scan.rest()) > 0 => {
                    scan.at += label_length(scan.rest());
                }
                '@' if scan.peek().is_some_and(char::is_alphabetic) => {
                    while scan.peek().is_some_and(|c| c.is_alphanumeric() || "-_:.".contains(c)) {
                        scan.next();
                    }
                    self.edge(start..scan.at);
                }
                'h' if scan.starts_with("ttp://") || scan.starts_with("ttps://") => {
                    while scan.peek().is_some_and(|c| !c.is_whitespace() && !")]".contains(c)) {
                        scan.next();
                    }
                    self.edge(start..scan.at);
                }
                _ => self.text(place),
            }
        }
        self.depth -= 1;
    }

    /// The marks of a heading or an item at the start of a line.
    fn line_start(&mut self, scan: &mut Scan<'_>) {
        let rest = scan.rest();
        let marks = match rest.chars().next() {
            Some('=') => rest.len() - rest.trim_start_matches('=').len(),
            Some('-' | '+' | '/') => 1,
            Some(c) if c.is_ascii_digit() => {
                let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
                if rest[digits..].starts_with('.') { digits + 1 } else { 0 }
            }
            _ => 0,
        };
        if marks > 0 && rest[marks..].starts_with(' ') {
            let is_heading = rest.starts_with('=');
            self.block();
            scan.at += marks;
            if is_heading {
                // A heading is its line.
                let end = scan.at + scan.rest().find('\n').unwrap_or(scan.rest().len());
                self.markup_in_line(scan.at..end);
                scan.at = end;
                self.block();
            }
        }
    }

    fn markup_in_line(&mut self, range: Range<usize>) {
        // A space before it keeps its first sign from being a mark.
        let inner = self.source[range.clone()].trim_start();
        self.markup(range.end - inner.len()..range.end);
    }

    /// A formula behind its dollar sign.
    fn formula(&mut self, scan: &mut Scan<'_>) {
        let range = formula_range(scan);
        let inside = &self.source[range.clone()];
        let is_display = inside.starts_with(char::is_whitespace) && inside.ends_with(char::is_whitespace);
        if is_display {
            self.block();
        }
        self.write_formula(range);
        if is_display {
            self.block();
        }
    }

    fn write_formula(&mut self, range: Range<usize>) {
        /// Longest formula, in bytes.
        const LONGEST: usize = 20_000;
        if range.len() > LONGEST {
            self.page.tags("<math><unknown-length/></math>");
            return;
        }
        let parts = math::parse(self.source, range);
        FormulaWriter::new(self.source, &mut self.page, &self.names).formula(&parts);
    }

    /// Raw text behind its first mark.
    fn raw(&mut self, scan: &mut Scan<'_>, start: usize) {
        let marks = 1 + scan.rest().bytes().take_while(|byte| *byte == b'`').count();
        scan.at = start + marks;
        if marks == 2 {
            return;
        }
        let fence = "`".repeat(marks);
        let rest = scan.rest();
        let length = rest.find(&fence).unwrap_or(rest.len());
        let inside = &rest[..length];
        let language: String = inside.chars().take_while(|c| c.is_alphanumeric() || "-_".contains(*c)).collect();
        let (kind, name) = if marks > 2 { (UnreadKind::Fence, language.as_str()) } else { (UnreadKind::Code, "") };
        note(&mut self.unread, kind, name, inside);
        scan.at = (scan.at + length + marks).min(scan.end);
        self.edge(start..scan.at);
    }

    /// Code behind its `#`.
    fn code(&mut self, scan: &mut Scan<'_>, start: usize) {
        let word: String = scan.rest().chars().take_while(|c| c.is_alphanumeric() || "_-".contains(*c)).collect();
        if word == "let" {
            let end = statement_end(scan);
            self.definition(scan.at + word.len()..end);
            scan.at = end;
            return;
        }
        if STATEMENTS.contains(&word.as_str()) || word == "if" || word == "for" {
            let begin = scan.at;
            scan.at = statement_end(scan);
            return self.code_text(begin..scan.at);
        }
        let begin = scan.at;
        scan.code_expression();
        let code = &self.source[begin..scan.at];
        if let Some(given) = self.names.get(code) {
            if let Given::Formula(parts) = given {
                let parts = parts.clone();
                let value: String = parts.iter().map(|part| plain(self.source, part)).collect();
                self.page.sign_for(&value, Span::new(start, scan.at));
            } else {
                self.edge(start..scan.at);
            }
            return;
        }
        if scan.at == begin {
            return self.text(start..scan.at);
        }
        // A sign by its name, as in a formula.
        let sign = ["math.", "sym."].iter().find_map(|module| code.strip_prefix(module)).and_then(sign_named);
        if let Some(sign) = sign {
            return self.page.sign_for(&sign, Span::new(start, scan.at));
        }
        match word.as_str() {
            "emph" | "strong" | "text" | "box" | "link" | "underline" | "sub" | "super" => {
                let mark = match word.as_str() {
                    "super" => "sup",
                    "sub" => "sub",
                    _ => "span",
                };
                self.page.tags(&format!("<{mark}>"));
                self.code_text(begin..scan.at);
                self.page.tags(&format!("</{mark}>"));
            }
            "table" | "grid" => {
                self.page.tags("</p>\n");
                self.table(begin..scan.at);
                self.page.tags("<p>");
            }
            _ => {
                self.block();
                self.code_text(begin..scan.at);
                self.block();
            }
        }
    }

    /// What `#let` says behind the word.
    fn definition(&mut self, range: Range<usize>) {
        let text = &self.source[range.clone()];
        let Some(equals) = text.find('=') else { return };
        let name = text[..equals].trim();
        let value = text[equals + 1..].trim().trim_end_matches(';').trim_end();
        let at = range.start + equals + 1 + (text[equals + 1..].len() - text[equals + 1..].trim_start().len());
        let inside = at..at + value.len();
        let is_name = name.chars().all(|c| c.is_alphanumeric() || "_-".contains(c));
        let number = value.strip_prefix('-').unwrap_or(value);
        let is_number = number.starts_with(|c: char| c.is_ascii_digit()) && parse_decimal(number).is_some();
        let is_formula = value.len() > 1 && value.starts_with('$') && value[1..].find('$') == Some(value.len() - 2);
        let given = if is_name && is_number {
            Given::Formula(math::parse(self.source, inside))
        } else if is_name && is_formula {
            Given::Formula(math::parse(self.source, at + 1..at + value.len() - 1))
        } else {
            // The names of a function's arguments stand behind its own.
            self.code_text(inside);
            Given::Other
        };
        let name = name.split(['(', ' ']).next().unwrap_or_default().to_owned();
        self.names.insert(name, given);
    }

    /// Reads the text and the formulas in code; the rest is not read.
    fn code_text(&mut self, range: Range<usize>) {
        if self.depth >= DEEPEST {
            note(&mut self.unread, UnreadKind::Code, "", &self.source[range]);
            return;
        }
        let mut scan = Scan::new(self.source, range.clone());
        let mut code = String::new();
        while !scan.is_at_end() {
            let start = scan.at;
            if scan.skip_comment() {
                note(&mut self.unread, UnreadKind::Comment, "", &self.source[start..scan.at]);
                continue;
            }
            let Some((c, _)) = scan.next() else { break };
            match c {
                '[' => {
                    let inside = content(&mut scan, start);
                    self.markup(inside);
                    self.page.tags(" ");
                }
                '$' => self.formula(&mut scan),
                '"' => drop(scan.string_behind(start)),
                '`' => self.raw(&mut scan, start),
                '(' if ["table", "grid"]
                    .contains(&code.rsplit(|c: char| !c.is_alphanumeric()).next().unwrap_or("")) =>
                {
                    scan.at = start;
                    scan.balanced();
                    self.table(start..scan.at);
                }
                c => code.push(c),
            }
        }
        note(&mut self.unread, UnreadKind::Code, "", &code);
    }

    /// A table with its cells, as far as its columns are counted in it.
    fn table(&mut self, range: Range<usize>) {
        let mut scan = Scan::new(self.source, range.clone());
        let columns = columns(&self.source[range.clone()]);
        self.page.tags("<table>");
        let mut cell = 0;
        while !scan.is_at_end() {
            let start = scan.at;
            if scan.skip_comment() {
                continue;
            }
            let Some((c, _)) = scan.next() else { break };
            if !matches!(c, '[' | '$') {
                if c == '"' {
                    scan.string_behind(start);
                }
                continue;
            }
            self.page.tags(if columns.is_some_and(|columns| cell % columns == 0) { "<tr>" } else { "" });
            self.page.tags("<td>");
            if c == '[' {
                let inside = content(&mut scan, start);
                self.markup(inside);
            } else {
                self.formula(&mut scan);
            }
            self.page.tags("</td>");
            cell += 1;
            self.page.tags(if columns.is_some_and(|columns| cell % columns == 0) { "</tr>\n" } else { "" });
        }
        self.page.tags("</table>\n");
    }
}

/// The content of square brackets that begin at `start`, behind which the place moves.
fn content(scan: &mut Scan<'_>, start: usize) -> Range<usize> {
    scan.at = start;
    scan.balanced();
    let end = if scan.at > start + 1 && scan.text()[..scan.at].ends_with(']') { scan.at - 1 } else { scan.at };
    start + 1..end.max(start + 1)
}

/// How many columns a table has.
fn columns(code: &str) -> Option<usize> {
    const MOST: usize = 64;
    let (_, rest) = code.split_once("columns:")?;
    let rest = rest.trim_start();
    let count = match rest.strip_prefix('(') {
        Some(list) => {
            let list = list.split(')').next().unwrap_or_default();
            list.split(',').filter(|column| !column.trim().is_empty()).count()
        }
        None => rest.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()?,
    };
    (1..=MOST).contains(&count).then_some(count)
}

/// The content of a formula behind its dollar sign, behind whose end the place moves.
fn formula_range(scan: &mut Scan<'_>) -> Range<usize> {
    let start = scan.at;
    while !scan.is_at_end() {
        if scan.skip_comment() {
            continue;
        }
        let Some((c, place)) = scan.next() else { break };
        match c {
            '$' => return start..place.start,
            '\\' => drop(scan.next()),
            '"' => drop(scan.string_behind(place.start)),
            _ => {}
        }
    }
    start..scan.end
}

/// Where a statement ends: with its line, but for what is in brackets.
fn statement_end(scan: &Scan<'_>) -> usize {
    let mut here = Scan::new(scan.text(), scan.at..scan.end);
    while let Some(c) = here.peek() {
        match c {
            '\n' | ';' => break,
            '(' | '[' | '{' => here.balanced(),
            '"' => {
                let mark = here.at;
                here.next();
                here.string_behind(mark);
            }
            '$' => {
                here.next();
                formula_range(&mut here);
            }
            _ if here.skip_comment() => {}
            _ => drop(here.next()),
        }
    }
    here.at
}

/// How long a label is behind its open bracket.
fn label_length(rest: &str) -> usize {
    let length = rest.bytes().take_while(|byte| byte.is_ascii_alphanumeric() || b"-_:.".contains(byte)).count();
    if length > 0 && rest.starts_with(|c: char| c.is_ascii_alphabetic()) && rest[length..].starts_with('>') {
        length + 1
    } else {
        0
    }
}

/// The value of a name in running text.
fn plain(source: &str, part: &Part) -> String {
    match part {
        Part::Number(range) | Part::Text(range) => source[range.clone()].to_owned(),
        Part::Sign(c, _) => c.to_string().replace('<', "&lt;").replace('&', "&amp;"),
        Part::Space(_) => " ".to_owned(),
        // More than a quantity is no running text.
        _ => "\u{fffc}".to_owned(),
    }
}
