//! A text as one sequence of plain characters: without emphasis, braces and commands of TeX, each character with its place.

use crate::reader::TextFormat;
use crate::token::Span;

/// Stands for a command or a sign that is not understood.
pub(super) const UNKNOWN: char = '\u{1}';
/// Ends a paragraph, a cell or a row.
pub(super) const PARAGRAPH: char = '\n';

/// The characters with their places.
#[derive(Default)]
pub(super) struct PlainCharacters {
    pub chars: Vec<char>,
    places: Vec<Span>,
}

impl PlainCharacters {
    /// The characters of `text`, whose places are counted in it.
    pub(super) fn new(text: &str, format: TextFormat) -> Self {
        let mut out = Self::default();
        let signs: Vec<(usize, char)> = text.char_indices().collect();
        let mut at = 0;
        while at < signs.len() {
            at = out.take(text, &signs, at, format);
        }
        out
    }

    /// Where a stretch of the characters is in the text.
    pub(super) fn span(&self, range: std::ops::Range<usize>) -> Span {
        let last = range.end.saturating_sub(1).max(range.start);
        match (self.places.get(range.start), self.places.get(last)) {
            (Some(start), Some(end)) => start.join(*end),
            _ => self.places.last().copied().unwrap_or_default(),
        }
    }

    /// A stretch as one line.
    pub(super) fn line(&self, range: std::ops::Range<usize>) -> String {
        let shown: String = self.chars.get(range).unwrap_or_default().iter().collect();
        shown.replace(UNKNOWN, "…").replace('-', "−").split_whitespace().collect::<Vec<_>>().join(" ")
    }

    fn push(&mut self, c: char, place: Span) {
        self.chars.push(c);
        self.places.push(place);
    }

    fn space(&mut self, place: Span) {
        if self.chars.last().is_some_and(|last| *last != ' ' && *last != PARAGRAPH) {
            self.push(' ', place);
        }
    }

    fn end_paragraph(&mut self, place: Span) {
        if self.chars.last() == Some(&' ') {
            self.chars.pop();
            self.places.pop();
        }
        if self.chars.last().is_some_and(|last| *last != PARAGRAPH) {
            self.push(PARAGRAPH, place);
        }
    }

    /// Takes one sign or command; the index behind it.
    fn take(&mut self, text: &str, signs: &[(usize, char)], at: usize, format: TextFormat) -> usize {
        let (byte, c) = signs[at];
        let sign = |index: usize| signs.get(index).map_or('\n', |(_, c)| *c);
        let before = at.checked_sub(1).map_or('\n', sign);
        let place = |end: usize| Span::new(byte, signs.get(end).map_or(text.len(), |(byte, _)| *byte));
        let one = place(at + 1);
        match c {
            '\\' => return self.command(text, signs, at),
            '\u{b}' => self.end_paragraph(one),
            c if c.is_whitespace() && !is_narrow(c) => {
                let mut end = at;
                while sign(end).is_whitespace() && end < signs.len() {
                    end += 1;
                }
                let is_blank = signs[at..end].iter().filter(|(_, c)| *c == '\n').count() > 1;
                if is_blank {
                    self.end_paragraph(place(end))
                } else {
                    self.space(place(end))
                }
                return end;
            }
            c if is_narrow(c) => {
                let inside = before.is_ascii_digit() && sign(at + 1).is_ascii_digit();
                if inside { self.push('\u{2009}', one) } else { self.space(one) }
            }
            '~' => self.space(one),
            '$' | '`' | '\u{2062}' | '\u{200b}' => {}
            '{' if sign(at + 1) == ',' && sign(at + 2) == '}' => {
                self.push(',', place(at + 3));
                return at + 3;
            }
            '{' | '}' => {}
            '^' => match end_of_marks(signs, at + 1) {
                Some(end) => return end,
                None => self.push('^', one),
            },
            '*' => {
                let is_product = |c: char| c == ' ' || c.is_ascii_digit();
                if is_product(before) && is_product(sign(at + 1)) && format != TextFormat::Latex {
                    self.push('×', one);
                }
            }
            '_' => {
                let opens = sign(at + 1) == '{' || sign(at + 1).is_alphanumeric() || sign(at + 1) == '\\';
                let is_index =
                    matches!(format, TextFormat::Html | TextFormat::Xml) || (opens && !before.is_whitespace());
                if is_index {
                    self.push('_', one);
                }
            }
            '&' => {
                let entity: String =
                    signs[at + 1..].iter().take(8).map(|(_, c)| *c).take_while(|c| *c != ';').collect();
                let known = ENTITIES.iter().find(|(name, _)| *name == entity);
                match known {
                    Some((_, c)) => {
                        let end = at + 2 + entity.chars().count();
                        if *c == ' ' {
                            self.space(place(end))
                        } else {
                            self.push(*c, place(end))
                        }
                        return end;
                    }
                    None if format == TextFormat::Latex => {}
                    None => self.push('&', one),
                }
            }
            '²' => ['^', '2'].into_iter().for_each(|c| self.push(c, one)),
            '−' | '\u{2010}' | '\u{2011}' => self.push('-', one),
            '⩽' | '≦' => self.push('≤', one),
            '⩾' | '≧' => self.push('≥', one),
            '≃' | '≅' => self.push('≈', one),
            '-' if sign(at + 1) == '-' => {
                self.push('–', place(at + 2));
                return at + 2;
            }
            '𝐴'..='𝑧' => self.push(plain_letter(c), one),
            '𝜒' => self.push('χ', one),
            c => self.push(c, one),
        }
        at + 1
    }

    fn command(&mut self, text: &str, signs: &[(usize, char)], at: usize) -> usize {
        let length = signs[at + 1..].iter().take_while(|(_, c)| c.is_ascii_alphabetic()).count();
        let place = |end: usize| Span::new(signs[at].0, signs.get(end).map_or(text.len(), |(byte, _)| *byte));
        if length == 0 {
            let end = (at + 2).min(signs.len());
            match signs.get(at + 1).map_or(' ', |(_, c)| *c) {
                ',' | ';' | ':' | ' ' | '>' => self.space(place(end)),
                '\\' => self.space(place(end)),
                c @ ('%' | '#' | '&' | '[' | ']' | '(' | ')' | '_') if !"[]()".contains(c) => self.push(c, place(end)),
                '|' => self.push('|', place(end)),
                _ => {}
            }
            return end;
        }
        let mut end = at + 1 + length;
        let name: String = signs[at + 1..end].iter().map(|(_, c)| *c).collect();
        if signs.get(end).is_some_and(|(_, c)| *c == ' ') && name != "item" {
            end += 1;
        }
        if DROPPED.contains(&name.as_str()) {
            return end;
        }
        match name.as_str() {
            "chi" => self.push('χ', place(end)),
            "Sigma" | "sum" => self.push('Σ', place(end)),
            "le" | "leq" | "leqslant" => self.push('≤', place(end)),
            "ge" | "geq" | "geqslant" => self.push('≥', place(end)),
            "lt" => self.push('<', place(end)),
            "gt" => self.push('>', place(end)),
            "approx" | "simeq" | "doteq" => self.push('≈', place(end)),
            "times" | "cdot" => self.push('×', place(end)),
            "pm" => self.push('±', place(end)),
            "quad" | "qquad" | "newline" | "hfill" => self.space(place(end)),
            "item" | "par" | "section" | "subsection" | "caption" | "footnote" | "hline" => {
                self.end_paragraph(place(end))
            }
            name if GREEK.contains(&name) => self.push('θ', place(end)),
            _ => self.push(UNKNOWN, place(end)),
        }
        end
    }
}

/// The end of a raised mark of significance or of a note, such as `{***}`, from its place behind `^`; none if something else is raised.
fn end_of_marks(signs: &[(usize, char)], at: usize) -> Option<usize> {
    const COMMANDS: [&str; 4] = ["ast", "star", "dagger", "ddagger"];
    let sign = |index: usize| signs.get(index).map_or('\n', |(_, c)| *c);
    let opens = usize::from(matches!(sign(at), '{' | '('));
    let mut end = at + opens;
    loop {
        let name: String = (end + 1..).map(sign).take_while(char::is_ascii_alphabetic).take(8).collect();
        match sign(end) {
            '*' | '∗' | '⋆' | '†' | '‡' | '§' => end += 1,
            '\\' if COMMANDS.contains(&name.as_str()) => end += 1 + name.len(),
            _ => break,
        }
        // One without a brace.
        if opens == 0 && sign(end) != '*' {
            break;
        }
    }
    let closes = usize::from(opens == 1 && matches!(sign(end), '}' | ')'));
    (end > at + opens && closes == opens).then_some(end + closes)
}

fn is_narrow(c: char) -> bool {
    matches!(c, '\u{2009}' | '\u{202f}' | '\u{a0}')
}

fn plain_letter(c: char) -> char {
    let at = u32::from(c).saturating_sub(0x1d434);
    let plain = if at < 26 { 0x41 + at } else { 0x61 + at.saturating_sub(26) };
    char::from_u32(plain).filter(char::is_ascii_alphabetic).unwrap_or(UNKNOWN)
}

/// Commands that say how something looks.
const DROPPED: [&str; 42] = [
    "left",
    "right",
    "mathrm",
    "mathit",
    "mathbf",
    "mathsf",
    "mathnormal",
    "text",
    "textit",
    "textbf",
    "textrm",
    "textsf",
    "textsc",
    "textnormal",
    "textup",
    "emph",
    "operatorname",
    "mbox",
    "displaystyle",
    "textstyle",
    "small",
    "large",
    "big",
    "Big",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "limits",
    "rm",
    "it",
    "bf",
    "em",
    "noindent",
    "centering",
    "bfseries",
    "itshape",
    "normalsize",
    "footnotesize",
    "num",
    "SI",
    "ensuremath",
];

const GREEK: [&str; 24] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "eta",
    "theta",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "rho",
    "sigma",
    "tau",
    "phi",
    "varphi",
    "psi",
    "omega",
    "Delta",
    "Lambda",
    "Phi",
    "Omega",
];

const ENTITIES: [(&str, char); 12] = [
    ("lt", '<'),
    ("gt", '>'),
    ("le", '≤'),
    ("ge", '≥'),
    ("nbsp", ' '),
    ("thinsp", ' '),
    ("minus", '-'),
    ("ndash", '–'),
    ("chi", 'χ'),
    ("plusmn", '±'),
    ("times", '×'),
    ("asymp", '≈'),
];
