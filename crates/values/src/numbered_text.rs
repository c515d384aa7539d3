//! All numbers of a text in their order, each with the words around it.

use crate::numeral::{Form, Numeral, numeral_at, run};
use crate::role::{self, Role};
use geneva_evidence::Decimal;
use proofread::reader::{LeftOut, ROW_END, shown_text};
use proofread::{Span, TextFormat};

/// Most numbers of one text.
pub const MOST_NUMBERS: usize = 200_000;
/// Words before and after a number that are recorded: usually, and where others have the same words around them.
pub(crate) const WORDS: [[usize; 2]; 2] = [[5, 3], [12, 12]];

/// A number as a text prints it.
#[derive(Clone, Debug)]
pub struct PrintedNumber {
    /// Where the digits are in the file, with a power of ten but without the unit.
    pub span: Span,
    /// The digits with sign, commas and point.
    pub decimal: Decimal,
    /// The characters in one spelling, such as `1,234` or `1.5e-3`.
    pub printed: String,
    /// The digits without the power of ten.
    pub digits: String,
    /// The power of ten that the digits are multiplied by.
    pub exponent: i32,
    /// The unit in one spelling; empty if none is printed.
    pub unit: String,
    /// What the number seems to be if it is no result.
    pub role: Option<Role>,
    /// Whether it is the first number of its row or line.
    pub(crate) opens_row: bool,
    /// Whether there is a word between the beginning of its row and the number.
    pub(crate) is_named: bool,
    item: usize,
}

/// What a text consists of, for the words around a number.
#[derive(Clone, Copy, Debug)]
enum Item {
    Word(Span),
    Number,
    Break,
}

/// The numbers of a text and the words between them.
pub struct NumberedText {
    shown: String,
    items: Vec<Item>,
    /// The numbers in the order of the text.
    pub numbers: Vec<PrintedNumber>,
    /// Stretches that contain digits and were not read, by kind.
    pub left_out: Vec<(LeftOut, usize)>,
}

impl NumberedText {
    /// Reads a text.
    ///
    /// # Errors
    ///
    /// The text is too long or no notebook where it should be one, or it has too many numbers.
    ///
    /// ```
    /// use geneva_values::NumberedText;
    /// use proofread::TextFormat;
    ///
    /// let text = NumberedText::read("It swings in $2.006\\,\\mathrm{s}$, see Fig. 3.", TextFormat::Markdown)?;
    /// let [period, figure] = &*text.numbers else { panic!("two numbers") };
    /// assert_eq!((&*period.printed, &*period.unit), ("2.006", "s"));
    /// assert!(figure.role.is_some());
    /// # Ok::<(), String>(())
    /// ```
    pub fn read(text: &str, format: TextFormat) -> Result<Self, String> {
        let source = shown_text(text, format).map_err(|why| why.to_string())?;
        let shown = source.text().to_owned();
        let row_end = if shown.contains(ROW_END) { ROW_END } else { '\n' };
        let mut scan = Scan {
            text: &shown,
            items: Vec::new(),
            numbers: Vec::new(),
            row_end,
            is_new_row: true,
            row_start: 0,
            in_formula: false,
        };
        scan.all()?;
        let Scan { items, mut numbers, .. } = scan;
        for number in &mut numbers {
            number.span = source.span_in_file(number.span);
        }
        let left_out = LeftOut::ALL.map(|(_, kind)| (kind, source.left_out(kind)));
        let left_out = left_out.into_iter().filter(|(_, count)| *count > 0).collect();
        Ok(Self { shown, items, numbers, left_out })
    }

    /// The words before a number and after it in its paragraph, at most so many; another number is `#`.
    pub(crate) fn words_around(&self, number: &PrintedNumber, most: [usize; 2]) -> [String; 2] {
        let before = self.items[..number.item].iter().rev();
        let after = self.items[number.item + 1..].iter();
        let mut before = self.words(before, most[0]);
        before.reverse();
        [before.join(" "), self.words(after, most[1]).join(" ")]
    }

    fn words<'i>(&'i self, items: impl Iterator<Item = &'i Item>, most: usize) -> Vec<&'i str> {
        let word = |item: &Item| match item {
            Item::Word(span) => self.shown.get(span.range()).unwrap_or_default(),
            Item::Number | Item::Break => "#",
        };
        items.take_while(|item| !matches!(item, Item::Break)).take(most).map(word).collect()
    }
}

struct Scan<'t> {
    text: &'t str,
    items: Vec<Item>,
    numbers: Vec<PrintedNumber>,
    /// What ends a row: [`ROW_END`] if the text has one, otherwise the end of a line.
    row_end: char,
    /// Whether a row has begun since the last number.
    is_new_row: bool,
    /// How many items there were when the row began.
    row_start: usize,
    /// Whether the place is in a formula in TeX.
    in_formula: bool,
}

impl Scan<'_> {
    fn all(&mut self) -> Result<(), String> {
        let mut at = 0;
        let mut previous = None;
        while let Some(c) = self.text[at..].chars().next() {
            let next = self.step(c, previous, at)?.max(at + c.len_utf8());
            previous = self.text[at..next].chars().next_back();
            at = next;
        }
        Ok(())
    }

    /// Takes what begins at a place; the byte behind it.
    fn step(&mut self, c: char, previous: Option<char>, at: usize) -> Result<usize, String> {
        let rest = &self.text[at..];
        let behind = at + c.len_utf8();
        let is_glued =
            previous.is_some_and(|c| c.is_alphanumeric() || matches!(c, ')' | '}' | ']' | '-' | '−' | '–' | '.'));
        match c {
            '\n' => {
                let spaces = rest.find(|c: char| !c.is_whitespace()).unwrap_or(rest.len());
                if rest[..spaces].matches('\n').count() > 1 && !matches!(self.items.last(), None | Some(Item::Break)) {
                    self.items.push(Item::Break);
                    self.in_formula = false;
                }
                if rest[..spaces].contains(self.row_end) {
                    (self.is_new_row, self.row_start) = (true, self.items.len());
                }
                return Ok(at + spaces);
            }
            '0'..='9' => return self.number(at),
            '-' | '−' | '+' if !is_glued && self.text[behind..].starts_with(|c: char| c.is_ascii_digit()) => {
                return self.number(at);
            }
            '.' if !is_glued && self.text[behind..].starts_with(|c: char| c.is_ascii_digit()) => {
                return self.number(at);
            }
            '$' => {
                self.in_formula = !self.in_formula;
                return Ok(behind + usize::from(rest.starts_with("$$")));
            }
            '\\' if rest[1..].starts_with(['(', '[', ')', ']']) => {
                self.in_formula = rest[1..].starts_with(['(', '[']);
                return Ok(at + 2);
            }
            '^' => return Ok(script_end(self.text, behind)),
            '_' if previous.is_some_and(|c| c.is_alphanumeric() || matches!(c, '}' | ')')) => {
                return Ok(script_end(self.text, behind));
            }
            '\\' => {
                let letters = rest[1..].bytes().take_while(u8::is_ascii_alphabetic).count();
                return Ok(at + 1 + letters.max(usize::from(rest.len() > 1 && rest.is_char_boundary(2))));
            }
            '=' | '≈' | '<' | '>' => self.items.push(Item::Word(Span::new(at, behind))),
            c if c.is_alphabetic() => {
                let end = self.word_end(at);
                self.items.push(Item::Word(Span::new(at, end)));
                return Ok(end);
            }
            _ => {}
        }
        Ok(behind)
    }

    /// The byte behind a word or a name such as `x2` or `v1.2.3`.
    fn word_end(&self, at: usize) -> usize {
        let is_of_word = |c: char| c.is_alphanumeric() || matches!(c, '\'' | '’');
        let mut end = at;
        loop {
            let rest = &self.text[end..];
            end += rest.find(|c| !is_of_word(c)).unwrap_or(rest.len());
            let ends_in_digit = self.text[at..end].ends_with(|c: char| c.is_ascii_digit());
            let goes_on = self.text[end..].starts_with(['.', '_']) && run(self.text, end + 1) > end + 1;
            if !(ends_in_digit && goes_on) {
                return end;
            }
            end += 1;
        }
    }

    fn number(&mut self, at: usize) -> Result<usize, String> {
        let text = self.text;
        let starts_with_point = text[at..].starts_with('.');
        let read = if starts_with_point {
            let end = run(text, at + 1);
            Some(Numeral {
                digits: format!("0{}", &text[at..end]),
                ..numeral_at(text, at + 1).unwrap_or_else(|| empty(end))
            })
            .filter(|read| read.end == end)
        } else {
            numeral_at(text, at)
        };
        let Some(read) = read else { return Ok(run(text, at + 1)) };
        let decimal = match read.form {
            // Only the characters count of what is no quantity.
            Form::Date | Form::Name => "0".parse(),
            Form::Plain | Form::Coefficient => read.digits.trim_start_matches('+').parse(),
        };
        let Ok(decimal) = decimal else {
            return Ok(read.end);
        };
        if self.numbers.len() == MOST_NUMBERS {
            return Err(format!("the text has more than {MOST_NUMBERS} numbers; split it"));
        }
        let before = self.items.iter().rev().take_while(|item| !matches!(item, Item::Break)).take(2);
        let before: Vec<&str> = before
            .map(|item| match item {
                Item::Word(span) => &text[span.range()],
                Item::Number | Item::Break => "#",
            })
            .collect();
        let last_role = self.numbers.last().and_then(|last| last.role);
        let role = role::role_of(text, at, &read, &before, last_role);
        let role = role.or_else(|| (self.in_formula && role::is_among_letters(text, at, &read)).then_some(Role::Given));
        let is_named = self.items[self.row_start..].iter().any(|item| matches!(item, Item::Word(_)));
        self.items.push(Item::Number);
        self.numbers.push(PrintedNumber {
            span: Span::new(at, read.end),
            decimal,
            printed: format!("{}{}", read.digits, read.scale),
            digits: read.digits,
            exponent: read.exponent,
            unit: read.unit,
            role,
            opens_row: std::mem::take(&mut self.is_new_row),
            is_named,
            item: self.items.len() - 1,
        });
        // What touches a name belongs to it.
        let end = if read.form == Form::Name { read.end + letters(text, read.end) } else { read.whole_end };
        Ok(end)
    }
}

fn empty(end: usize) -> Numeral {
    Numeral {
        digits: String::new(),
        exponent: 0,
        scale: String::new(),
        unit: String::new(),
        end,
        whole_end: end,
        form: Form::Plain,
    }
}

/// Bytes of letters and digits at a place.
fn letters(text: &str, at: usize) -> usize {
    text[at..].find(|c: char| !c.is_alphanumeric()).unwrap_or(text.len() - at)
}

/// The byte behind an index or an exponent, whose sign is before `at`.
fn script_end(text: &str, at: usize) -> usize {
    /// Longest script, in bytes.
    const LONGEST: usize = 200;
    let close = match text.as_bytes().get(at) {
        Some(b'{') => b'}',
        Some(b'(') => b')',
        Some(b'0'..=b'9') => return run(text, at),
        Some(b'-') => return run(text, at + 1),
        _ => return at,
    };
    let end = text.as_bytes()[at..].iter().take(LONGEST).position(|byte| *byte == close || *byte == b'\n');
    end.map_or(at, |end| at + end + 1)
}
