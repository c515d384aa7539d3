//! Formulas in TeX to tokens. Whatever it does not know becomes a token that says so; it never fails.

use super::comments;
use super::definitions::Macros;
use super::formatting::{self, with_over_fractions};
use super::siunitx;
use super::symbols::{attach_script, merge_letters, pifont_sign, symbol};
use super::words::{number, plain_char, span_of_chars, tokenise_words};
use crate::effort;
use crate::token::{
    ENDLESS, NamedOperation, SourceChar, Span, TOO_DEEP, TOO_LONG, Token, TokenKind, has_number, show, trim_space,
};

/// Deepest nesting of braces, fractions and scripts that is read.
const DEEPEST: usize = 40;
/// Longest formula that is read, in characters.
const LONGEST: usize = 20_000;

/// Reads a formula.
pub(crate) fn formula(signs: &[SourceChar], macros: &Macros<'_>) -> Vec<Token> {
    if signs.len() > LONGEST {
        return vec![token(TokenKind::Unknown(TOO_LONG.to_owned()), span_of_chars(signs))];
    }
    let mut reader = Tex {
        stack: signs.iter().rev().copied().collect(),
        macros,
        expanded: 0,
        outermost: None,
        upright: false,
        has_open_matrix: false,
    };
    reader.tokens(0, &[])
}

pub(super) struct Tex<'m> {
    /// What is still to be read, the next character last.
    pub(super) stack: Vec<SourceChar>,
    pub(super) macros: &'m Macros<'m>,
    /// How many characters macros have added.
    pub(super) expanded: usize,
    /// The macro of the text itself that is being read, and how much of the text is behind it.
    pub(super) outermost: Option<(String, usize)>,
    /// Whether the rest of the group is upright, as behind `\rm`.
    upright: bool,
    /// Whether a matrix was met that has no end near; no other one is looked for then.
    pub(super) has_open_matrix: bool,
}

pub(super) fn token(kind: TokenKind, span: Span) -> Token {
    Token::new(kind, span)
}

impl Tex<'_> {
    pub(super) fn peek(&self) -> Option<SourceChar> {
        self.stack.last().copied()
    }

    /// The `n`th next character.
    pub(super) fn ahead(&self, n: usize) -> Option<char> {
        let at = self.stack.len().checked_sub(n + 1)?;
        self.stack.get(at).map(|sign| sign.c)
    }

    pub(super) fn skip_space(&mut self) {
        while self.peek().is_some_and(|sign| sign.c.is_whitespace()) {
            self.stack.pop();
        }
    }

    /// The name behind a backslash that has been taken.
    fn command_name(&mut self) -> String {
        let mut name = String::new();
        while let Some(sign) = self.peek().filter(|sign| sign.c.is_ascii_alphabetic()) {
            name.push(sign.c);
            self.stack.pop();
        }
        if name.is_empty() {
            name.extend(self.stack.pop().map(|sign| sign.c));
        } else if self.peek().is_some_and(|sign| sign.c == '*') && self.macros.get(&name).is_none() {
            self.stack.pop();
        }
        name
    }

    /// The characters of a group, or the next character or command.
    pub(super) fn raw_group(&mut self) -> Vec<SourceChar> {
        self.skip_space();
        let Some(first) = self.stack.pop() else { return Vec::new() };
        if first.c == '\\' {
            let mut out = vec![first];
            let letter = |n: &usize| self.ahead(*n).is_some_and(|c| c.is_ascii_alphabetic());
            let letters = (0..self.stack.len()).take_while(letter).count().max(1);
            out.extend((0..letters).filter_map(|_| self.stack.pop()));
            return out;
        }
        if first.c != '{' {
            return vec![first];
        }
        self.take_until('{', '}')
    }

    /// The characters up to the bracket that closes one that has been taken.
    fn take_until(&mut self, open: char, close: char) -> Vec<SourceChar> {
        let (mut out, mut depth, mut braces) = (Vec::new(), 1usize, 0usize);
        while let Some(sign) = self.stack.pop() {
            effort::count_steps(1);
            if sign.c == '\\' {
                out.push(sign);
                out.extend(self.stack.pop());
                continue;
            }
            if sign.c == close && (close == '}' || braces == 0) {
                depth -= 1;
                if depth == 0 {
                    break;
                }
            } else if sign.c == open {
                depth += 1;
            } else if sign.c == '{' {
                braces += 1;
            } else if sign.c == '}' {
                braces = braces.saturating_sub(1);
            }
            out.push(sign);
        }
        out
    }

    pub(super) fn optional(&mut self) -> Option<Vec<SourceChar>> {
        self.skip_space();
        (self.peek()?.c == '[').then(|| {
            self.stack.pop();
            self.take_until('[', ']')
        })
    }

    pub(super) fn argument(&mut self, depth: usize) -> Vec<Token> {
        self.skip_space();
        match self.peek().map(|sign| sign.c) {
            Some('{') => {
                self.stack.pop();
                self.tokens(depth + 1, &['}'])
            }
            // Commands without braces nest, too: \sqrt\sqrt\sqrt 2.
            Some('\\') if depth >= DEEPEST => {
                let span = span_of_chars(&self.raw_group());
                vec![token(TokenKind::Unknown(TOO_DEEP.to_owned()), span)]
            }
            Some('\\') => {
                let mut out = Vec::new();
                self.command(depth + 1, &mut out);
                out
            }
            Some(c) => {
                let taken: Vec<SourceChar> = self.stack.pop().into_iter().collect();
                let span = span_of_chars(&taken);
                let Some(c) = plain_char(c) else { return Vec::new() };
                vec![match c {
                    '0'..='9' => number(&taken),
                    '°' | '%' => token(TokenKind::Word(c.to_string()), span),
                    c if c.is_alphabetic() => token(TokenKind::Name(c.to_string()), span),
                    c => token(TokenKind::Operator(c), span),
                }]
            }
            None => Vec::new(),
        }
    }

    /// Tokens up to one of `ends`, which is taken, or to the end. A sign of per cent that ends the formula is no comment.
    fn tokens(&mut self, depth: usize, ends: &[char]) -> Vec<Token> {
        let mut out: Vec<Token> = Vec::new();
        // From here on, what is in the group is upright.
        let mut upright: Option<usize> = None;
        if depth > DEEPEST {
            let span = self.peek().map_or(Span::default(), |sign| sign.span);
            if ends == ['}'] {
                self.take_until('{', '}');
            } else {
                self.stack.clear();
            }
            return vec![token(TokenKind::Unknown(TOO_DEEP.to_owned()), span)];
        }
        while let Some(sign) = self.peek() {
            let (c, span) = (sign.c, sign.span);
            if ends.contains(&c) {
                self.stack.pop();
                break;
            }
            match c {
                '~' | '%' if c == '~' || self.stack.len() == 1 => {
                    self.stack.pop();
                    out.push(token(if c == '~' { TokenKind::Space(2) } else { TokenKind::Word("%".to_owned()) }, span));
                }
                '%' if self.is_percent(&out) => {
                    self.stack.pop();
                    out.push(token(TokenKind::Word("%".to_owned()), span));
                }
                '%' => while self.stack.pop().is_some_and(|sign| sign.c != '\n') {},
                '&' => {
                    self.stack.pop();
                    out.push(token(TokenKind::Cell, span));
                }
                '{' => {
                    self.stack.pop();
                    if self.ahead(0) == Some(',') && self.ahead(1) == Some('}') {
                        self.stack.truncate(self.stack.len() - 2);
                        out.push(token(TokenKind::Operator(','), span));
                        continue;
                    }
                    let inner = self.tokens(depth + 1, &['}']);
                    self.push_group(inner, span, &mut out);
                }
                // The end of a group that is none, or a mark of a formula in text in a formula.
                '}' | '$' => {
                    self.stack.pop();
                }
                '^' | '_' => {
                    self.stack.pop();
                    let factorial = if c == '^' { self.factorial_power() } else { None };
                    let mut script = self.argument(depth);
                    if let Some(operation) = factorial {
                        script = vec![token(TokenKind::Call(operation, vec![without_line(script)]), span)];
                    }
                    attach_script(&mut out, c == '^', script, span);
                }
                '\'' | '′' => {
                    self.stack.pop();
                    out.push(token(TokenKind::Operator('′'), span));
                }
                '\\' => {
                    self.command(depth, &mut out);
                    if std::mem::take(&mut self.upright) {
                        upright = upright.or(Some(out.len()));
                    }
                }
                _ if self.number(&mut out) => {}
                _ => {
                    self.stack.pop();
                    let Some(c) = plain_char(c) else { continue };
                    out.push(match c {
                        c if c.is_whitespace() => token(TokenKind::Space(0), span),
                        '°' => token(TokenKind::Word("°".to_owned()), span),
                        '*' => token(TokenKind::Operator('·'), span),
                        c if c.is_alphabetic() => token(TokenKind::Name(c.to_string()), span),
                        c => token(TokenKind::Operator(c), span),
                    });
                }
            }
            if out.last().is_some_and(|last| matches!(last.kind, TokenKind::Cell | TokenKind::Line)) {
                make_upright(&mut out, &mut upright);
            }
        }
        make_upright(&mut out, &mut upright);
        with_over_fractions(out)
    }

    /// Whether the sign of per cent ahead lacks its backslash, as it may in Markdown behind a digit.
    fn is_percent(&self, before: &[Token]) -> bool {
        let is_behind_digit = before.last().is_some_and(|last| last.number().is_some());
        self.macros.is_markdown() && is_behind_digit && {
            let ahead = self.stack.iter().rev().skip(1).map(|sign| sign.c);
            comments::is_percent_behind_digit(&ahead.take(comments::FAR).take_while(|c| *c != '\n').collect::<String>())
        }
    }

    fn command(&mut self, depth: usize, out: &mut Vec<Token>) {
        let Some(slash) = self.stack.pop() else { return };
        let from = self.stack.len();
        let last = self.peek().map_or(slash.span, |sign| sign.span);
        let name = self.command_name();
        let letters = if last == slash.span { 0 } else { 1 + from.saturating_sub(self.stack.len()) as u32 };
        let span = Span { start: slash.span.start, end: last.end.max(slash.span.start + letters) };
        if let Some(used) = self.macros.get(&name) {
            if self.macros.is_endless(&name) || !self.expand(&name, used, span) {
                self.stack.clear();
                out.push(token(TokenKind::Unknown(ENDLESS.to_owned()), span));
            }
            return;
        }
        let push = |out: &mut Vec<Token>, kind: TokenKind| out.push(token(kind, span));
        match name.as_str() {
            "frac" | "dfrac" | "tfrac" | "cfrac" | "sfrac" | "nicefrac" => {
                let (above, below) = (self.argument(depth), self.argument(depth));
                push(out, TokenKind::Fraction(above, below));
            }
            "sqrt" => {
                let index = self.optional();
                let index =
                    index.map(|signs| self.read_inside(signs.into_iter().rev().collect(), depth)).unwrap_or_default();
                let of = self.argument(depth);
                push(out, TokenKind::Root(of, index));
            }
            "text" | "textrm" | "mathrm" | "textit" | "operatorname" | "mbox" | "textbf" | "texttt" | "mathsf"
            | "textsf" | "hbox" | "textnormal" | "mathtt" | "textup" | "mathup" | "symup" | "symrm" | "textsc"
            | "textmd" | "ce" => self.read_upright(&name, depth, out),
            "underbrace" | "overbrace" | "underbracket" | "overbracket" => {
                let inner = self.argument(depth);
                push(out, TokenKind::Group(inner));
                self.skip_space();
                // What is said at the brace.
                if matches!(self.ahead(0), Some('_' | '^')) {
                    self.stack.pop();
                    self.argument(depth);
                }
            }
            "rm" | "upshape" | "rmfamily" => self.upright = true,
            "intertext" | "shortintertext" => {
                self.raw_group();
                push(out, TokenKind::Line);
            }
            "hspace" | "hskip" | "kern" | "mspace" | "mkern" => {
                let length = self.length();
                push(out, TokenKind::Space(formatting::space_width(&length).max(2)));
            }
            // The number of an equation.
            "eqno" | "leqno" => while self.stack.pop().is_some() {},
            "genfrac" => {
                (0..4).for_each(|_| drop(self.raw_group()));
                let (above, below) = (self.argument(depth), self.argument(depth));
                push(out, TokenKind::Fraction(above, below));
            }
            "overline" | "bar" | "vec" | "dot" | "ddot" | "hat" | "tilde" | "widehat" | "overrightarrow"
            | "widetilde" | "acute" => {
                let sign = match name.as_str() {
                    "hat" | "widehat" => "^",
                    "vec" | "overrightarrow" => "→",
                    "dot" => "˙",
                    "ddot" => "¨",
                    _ => "¯",
                };
                let base = self.argument(depth);
                push(out, TokenKind::Accent(base, sign.to_owned()));
            }
            "circ" | "degree" | "degrees" | "deg" | "textdegree" | "degreeCelsius" | "celsius" | "textcelsius" => {
                push(out, TokenKind::Word(if name.ends_with("elsius") { "°C" } else { "°" }.to_owned()));
            }
            "ang" => {
                let signs = self.raw_group();
                if signs.iter().any(|sign| sign.c == ';') {
                    push(out, TokenKind::Unknown("an angle with minutes".to_owned()));
                } else {
                    tokenise_words(&signs, out);
                    push(out, TokenKind::Word("°".to_owned()));
                }
            }
            // The brackets of the package physics.
            "qty" | "quantity" if self.peek().is_some_and(|next| "([|".contains(next.c)) => {}
            "mathring" | "r" => {
                let of = self.argument(depth);
                match show(&of).as_str() {
                    "A" => push(out, TokenKind::Word("Å".to_owned())),
                    _ => push(out, TokenKind::Accent(of, "˚".to_owned())),
                }
            }
            "cancelto" => {
                let (_to, of) = (self.argument(depth), self.argument(depth));
                push(out, TokenKind::Group(of));
            }
            "cancel" | "bcancel" | "xcancel" => {
                let of = self.argument(depth);
                // An equals sign that is struck out denies what it says.
                if matches!(trim_space(&of), [only] if only.is_one_of("=≡")) {
                    push(out, TokenKind::Operator('≠'));
                    return;
                }
                // What stands above or below a number that is struck out takes its place.
                let replaced = has_number(&of) && self.peek().is_some_and(|next| "^_".contains(next.c));
                push(
                    out,
                    if replaced { TokenKind::Unknown("a number struck out".to_owned()) } else { TokenKind::Group(of) },
                );
            }
            "num" | "SI" | "qty" | "si" | "unit" | "SIrange" | "qtyrange" | "numrange" | "numlist" => {
                let options = self.optional().unwrap_or_default();
                // A power of another base than ten.
                if options.iter().map(|sign| sign.c).collect::<String>().contains("-base") {
                    push(out, TokenKind::Unknown("a base that is set by an option".to_owned()));
                }
                // The number of the package units.
                if name == "unit"
                    && options.first().is_some_and(|sign| sign.c.is_ascii_digit() || "-.$".contains(sign.c))
                {
                    let number = self.read_inside(options.into_iter().rev().collect(), depth);
                    out.push(token(TokenKind::Group(number), span));
                }
                self.quantity(&name, depth, out);
            }
            // A place that is kept free, and filled elsewhere.
            "phantom" | "hphantom" => {
                // The width of digits or signs only moves others.
                let is_named = self.raw_group().iter().any(|sign| sign.c.is_ascii_alphabetic());
                if is_named {
                    push(out, TokenKind::Unknown("a place that is kept free".to_owned()));
                }
            }
            "unitfrac" => {
                let number = self.optional().unwrap_or_default();
                let number = self.read_inside(number.into_iter().rev().collect(), depth);
                push(out, TokenKind::Group(number));
                push(out, TokenKind::Space(2));
                let [above, below] = [self.argument(depth), self.argument(depth)].map(|part| {
                    let mut words = Vec::new();
                    merge_letters(part, &mut words);
                    words
                });
                push(out, TokenKind::Fraction(above, below));
            }
            "quad" => push(out, TokenKind::Space(10)),
            "qquad" | "hfill" | "hfil" => push(out, TokenKind::Space(20)),
            "," | ";" | ":" | " " | ">" | "enspace" | "thinspace" | "space" | "\n" | "/" | "-" | "\t" => {
                push(out, TokenKind::Space(2))
            }
            "%" | "$" => push(out, TokenKind::Word(name)),
            "{" | "}" | "|" | "#" | "_" => push(out, TokenKind::Operator(name.chars().next().unwrap_or('|'))),
            "&" | "!" => {}
            "amp" => push(out, TokenKind::Cell),
            "\\" | "newline" | "cr" | "tabularnewline" => {
                self.row_space();
                push(out, TokenKind::Line);
            }
            "begin" | "end" => self.environment(&name, span, depth, out),
            "square" | "Box" if !self.ends() => push(out, TokenKind::Unknown("a box to fill in".to_owned())),
            "checkmark" | "square" | "Box" | "blacksquare" | "qed" => push(out, TokenKind::Space(2)),
            "ding" => {
                let number: String = self.raw_group().iter().map(|sign| sign.c).collect();
                push(out, pifont_sign(number.trim()));
            }
            "pmod" => push(out, TokenKind::Unknown(name)),
            "bmod" | "mod" => push(out, TokenKind::Word("mod".to_owned())),
            "binom" | "dbinom" | "tbinom" => {
                let arguments = vec![self.argument(depth), self.argument(depth)];
                push(out, TokenKind::Call(NamedOperation::Binomial, arguments));
            }
            // One of four sizes.
            "mathchoice" => {
                let shown = self.argument(depth);
                (0..3).for_each(|_| drop(self.raw_group()));
                push(out, TokenKind::Group(shown));
            }
            name if self.takes_definition(name) => {}
            name => {
                if let Some(command) = formatting::formatting_command(name) {
                    self.format_argument(name, command, span, depth, out);
                } else if let Some(sign) = formatting::long_arrow_sign(name) {
                    self.optional();
                    self.raw_group();
                    push(out, TokenKind::Operator(sign));
                } else {
                    push(out, symbol(name));
                }
            }
        }
    }

    /// Whether nothing but space and full stops is left.
    fn ends(&self) -> bool {
        self.stack.iter().all(|sign| sign.c.is_whitespace() || ".,}$&\\".contains(sign.c))
    }

    fn quantity(&mut self, command: &str, depth: usize, out: &mut Vec<Token>) {
        if command.ends_with("range") || command.ends_with("list") {
            self.raw_group();
            out.push(token(TokenKind::Unknown("a range".to_owned()), Span::default()));
            return;
        }
        if !matches!(command, "si" | "unit") {
            let number = self.raw_group();
            siunitx::number(&number, out);
        }
        if command != "num" {
            let raw = comments::without_comments(&self.raw_group());
            let place = span_of_chars(&raw);
            let unit = siunitx::unit(&siunitx::expand_named_units(raw, self.macros), self.macros);
            let inner = self.read_inside(unit.into_iter().rev().collect(), depth);
            out.push(token(TokenKind::Space(2), place));
            merge_letters(inner, out);
        }
    }

    /// Reads characters, the last one first, as a formula inside this one.
    pub(super) fn read_inside(&mut self, reversed: Vec<SourceChar>, depth: usize) -> Vec<Token> {
        let outer = std::mem::replace(&mut self.stack, reversed);
        let inner = self.tokens(depth + 1, &[]);
        self.stack = outer;
        inner
    }

    fn environment(&mut self, command: &str, span: Span, depth: usize, out: &mut Vec<Token>) {
        let name: String = self.raw_group().iter().map(|sign| sign.c).collect();
        let base = name.trim_end_matches('*');
        // Where a block of rows stands in its line: \begin{aligned}[t].
        let places = |c: Option<char>| matches!(c, Some('t' | 'b' | 'c'));
        if command == "begin" && self.ahead(0) == Some('[') && places(self.ahead(1)) && self.ahead(2) == Some(']') {
            self.optional();
        }
        let held =
            |out: &[Token]| out.iter().rev().find(|token| !token.is_space()).is_some_and(|of| of.is_one_of("(["));
        let is_matrix = base.ends_with("matrix") || (base == "array" && held(out));
        if command == "begin" && base == "array" && is_matrix {
            self.raw_group();
        }
        if command == "begin" && is_matrix && self.matrix(&name, span, depth, out) {
            return;
        }
        if command == "begin" && matches!(base, "array" | "tabular" | "alignat" | "alignedat") {
            self.optional();
            self.skip_space();
            if self.ahead(0) == Some('{') {
                self.raw_group();
            }
        }
        const ROWS: [&str; 16] = [
            "aligned",
            "align",
            "split",
            "gather",
            "gathered",
            "eqnarray",
            "equation",
            "multline",
            "array",
            "flalign",
            "alignat",
            "alignedat",
            "math",
            "displaymath",
            "dcases",
            "subequations",
        ];
        out.push(token(if ROWS.contains(&base) { TokenKind::Line } else { TokenKind::Unknown(name) }, span));
    }
}

/// Makes words of the letters from `upright` on.
fn make_upright(out: &mut Vec<Token>, upright: &mut Option<usize>) {
    if let Some(from) = upright.take() {
        let letters = out.split_off(from.min(out.len()));
        merge_letters(letters, out);
    }
}

/// What a line is drawn above or below.
fn without_line(script: Vec<Token>) -> Vec<Token> {
    match script.as_slice() {
        [Token { kind: TokenKind::Accent(inner, _) | TokenKind::Group(inner), .. }] => inner.clone(),
        _ => script,
    }
}
