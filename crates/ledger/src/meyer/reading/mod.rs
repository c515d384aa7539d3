//! Reads the printed characters of a formula and evaluates them.
//!
//! The identities of the formula crates stand for the printed displays, but nothing ties them to the characters.
//! This does: what is printed, or what the erratum puts in its place, is read character by character and evaluated.
//! It knows sums, products, fractions, powers, sines, cosines, bars and letters with dots and subscripts. Brackets
//! may be of any kind; those left open at the end of a line are closed there, and those closed too often are passed
//! over, because a display may be cut into its lines.

use std::collections::BTreeMap;
use std::f64::consts::PI;

/// What each letter stands for at one instant. A dot over a letter is written behind it: `theta'`, `theta''_0`.
pub type Letters = BTreeMap<String, f64>;

/// The value of a formula without an equals sign; not a number if it cannot be read or a letter has no value.
pub fn value(formula: &str, letters: &Letters) -> f64 {
    let Some(tokens) = tokens(formula) else { return f64::NAN };
    let mut reader = Reader { tokens: &tokens, at: 0, bars: 0, letters };
    let value = reader.sum();
    let rest = &tokens[reader.at.min(tokens.len())..];
    if rest.iter().all(|token| *token == Token::Close) { value } else { f64::NAN }
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Letter(char),
    Command(String),
    Sign(char),
    Open,
    Close,
    Bar,
}

/// The characters cut up; `None` if one of them has no meaning here.
fn tokens(formula: &str) -> Option<Vec<Token>> {
    let characters: Vec<char> = formula.chars().collect();
    let (mut tokens, mut at) = (Vec::new(), 0);
    let run = |from: usize, of: fn(char) -> bool| -> String {
        characters[from..].iter().copied().take_while(|c| of(*c)).collect()
    };
    while let Some(&c) = characters.get(at) {
        at += 1;
        match c {
            ' ' | '&' => {}
            '0'..='9' | '.' => {
                let digits = run(at - 1, |c| c.is_ascii_digit() || c == '.');
                at += digits.len() - 1;
                tokens.push(Token::Number(digits.parse().ok()?));
            }
            '(' | '[' | '{' => tokens.push(Token::Open),
            ')' | ']' | '}' => tokens.push(Token::Close),
            '|' => tokens.push(Token::Bar),
            '+' | '-' | '/' | '^' | '_' => tokens.push(Token::Sign(c)),
            '\\' => {
                let name = run(at, |c| c.is_ascii_alphabetic());
                at += name.len();
                match name.as_str() {
                    "" => {
                        match characters.get(at)? {
                            '{' => tokens.push(Token::Open),
                            '}' => tokens.push(Token::Close),
                            '\\' => {}
                            _ => return None,
                        }
                        at += 1;
                    }
                    "left" | "right" => {
                        // A full stop is the bracket that is not there.
                        at += usize::from(characters.get(at) == Some(&'.'));
                    }
                    "quad" => {}
                    "begin" | "end" => at += run(at, |c| c != '}').chars().count() + 1,
                    "text" => {
                        let inside = run(at + 1, |c| c != '}');
                        at += inside.chars().count() + 2;
                        tokens.push(Token::Command(inside));
                    }
                    _ => tokens.push(Token::Command(name)),
                }
            }
            c if c.is_alphabetic() => tokens.push(Token::Letter(c)),
            _ => return None,
        }
    }
    Some(tokens)
}

struct Reader<'a> {
    tokens: &'a [Token],
    at: usize,
    /// How many bars are open.
    bars: usize,
    letters: &'a Letters,
}

impl Reader<'_> {
    fn next(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    /// Whether the next token is this one; if so, it is passed.
    fn pass(&mut self, token: &Token) -> bool {
        let found = self.next() == Some(token);
        self.at += usize::from(found);
        found
    }

    fn sum(&mut self) -> f64 {
        let mut sum = if self.pass(&Token::Sign('-')) {
            -self.product()
        } else {
            self.pass(&Token::Sign('+'));
            self.product()
        };
        loop {
            if self.pass(&Token::Sign('+')) {
                sum += self.product();
            } else if self.pass(&Token::Sign('-')) {
                sum -= self.product();
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut product = self.factor();
        loop {
            match self.next() {
                None | Some(Token::Close | Token::Sign('+' | '-')) => return product,
                Some(Token::Bar) if self.bars > 0 => return product,
                Some(Token::Sign('/')) => {
                    self.at += 1;
                    product /= self.factor();
                }
                Some(_) => product *= self.factor(),
            }
        }
    }

    fn factor(&mut self) -> f64 {
        let base = self.single();
        if self.pass(&Token::Sign('^')) { libm::pow(base, self.single()) } else { base }
    }

    /// A number, a letter, a function or something in brackets, without its exponent.
    fn single(&mut self) -> f64 {
        let Some(token) = self.next().cloned() else { return f64::NAN };
        match token {
            Token::Number(number) => {
                self.at += 1;
                number
            }
            Token::Open => {
                self.at += 1;
                // Bars open outside the bracket do not close inside it.
                let bars = std::mem::take(&mut self.bars);
                let inside = self.sum();
                self.bars = bars;
                self.pass(&Token::Close);
                inside
            }
            Token::Bar => {
                self.at += 1;
                self.bars += 1;
                let inside = self.sum();
                self.bars -= 1;
                self.pass(&Token::Bar);
                inside.abs()
            }
            Token::Command(name) if name == "frac" => {
                self.at += 1;
                let above = self.single();
                above / self.single()
            }
            Token::Command(name) if ["sin", "cos", "tan", "acos"].contains(&name.as_str()) => {
                self.at += 1;
                self.function(&name)
            }
            Token::Letter(_) | Token::Command(_) => self.letter(),
            Token::Sign(_) | Token::Close => {
                self.at += 1;
                f64::NAN
            }
        }
    }

    /// sin x, sin² x or the inverse, with the next single thing for x.
    fn function(&mut self, name: &str) -> f64 {
        let exponent = if self.pass(&Token::Sign('^')) { self.single() } else { 1.0 };
        let argument = self.single();
        match (name, exponent == -1.0) {
            ("sin", true) => libm::asin(argument),
            ("cos", true) | ("acos", _) => libm::acos(argument),
            ("sin", false) => libm::pow(libm::sin(argument), exponent),
            ("cos", false) => libm::pow(libm::cos(argument), exponent),
            ("tan", false) => libm::pow(libm::tan(argument), exponent),
            _ => f64::NAN,
        }
    }

    fn letter(&mut self) -> f64 {
        let mut name = self.name();
        if self.pass(&Token::Sign('_')) {
            name.push('_');
            if self.pass(&Token::Open) {
                while !matches!(self.next(), None | Some(Token::Close)) {
                    name += &self.name();
                }
                self.pass(&Token::Close);
            } else {
                name += &self.name();
            }
        }
        match name.as_str() {
            "pi" => PI,
            _ => self.letters.get(&name).copied().unwrap_or(f64::NAN),
        }
    }

    /// A letter without its subscript, or one token of a subscript.
    fn name(&mut self) -> String {
        let token = self.next().cloned();
        self.at += 1;
        match token {
            Some(Token::Letter(letter)) => letter.to_string(),
            Some(Token::Number(number)) => number.to_string(),
            Some(Token::Sign(sign)) => sign.to_string(),
            Some(Token::Command(dots)) if dots == "dot" || dots == "ddot" => {
                let braced = self.pass(&Token::Open);
                let mut name = self.name();
                if braced {
                    self.pass(&Token::Close);
                }
                name += if dots == "dot" { "'" } else { "''" };
                name
            }
            Some(Token::Command(name)) => name,
            _ => String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(formula: &str) -> f64 {
        let letters =
            [("a", 3.0), ("x", 2.0), ("x'", 5.0), ("x''_0", 7.0), ("I_f", 11.0), ("y_n+1", 13.0), ("theta", 0.5)];
        value(formula, &letters.map(|(name, value)| (name.to_owned(), value)).into())
    }

    #[test]
    fn formulas_are_read_as_they_are_meant() {
        for (formula, expected) in [
            ("2ax", 12.0),
            (r"-a^2 + x", -7.0),
            (r"\frac{a + 1}{x} x^3", 16.0),
            (r"(a-x)/x a", 1.5),
            (r"\dot{x}^2 - \ddot{x}_0", 18.0),
            (r"I_f \left| x - a \right| x", 22.0),
            (r"a|x - \dot{x}|", 9.0),
            (r"\left\{ a \left[ x - 1 \right] \right\}", 3.0),
            (r"\left. \left[ a \right. \\ & \left. + x \right]", 5.0),
            (r"y_{n+1}^{1/2}", 13f64.sqrt()),
            (r"x[a + 2 ( a", 18.0),
            (r"a + x \right] \right]", 5.0),
            (r"\sin^2 \theta + \cos^2\theta a - 2\cos \theta \cos\theta", 1.0),
            (r"\cos^{-1}\left(\frac{1}{x}\right)", PI / 3.0),
            (r"\begin{aligned} a &+ x \\ &+ 1 \end{aligned}", 6.0),
            (r"2\sin(\pi/6)", 1.0),
            (r"\text{acos}\theta", libm::acos(0.5)),
        ] {
            approx(read(formula), expected, formula);
        }
    }

    #[track_caller]
    fn approx(found: f64, expected: f64, formula: &str) {
        assert!((found - expected).abs() < 1e-14 * expected.abs().max(1.0), "{formula}: {found}, not {expected}");
    }

    #[test]
    fn what_cannot_be_read_has_no_value() {
        for formula in ["", "a +", "b", r"\frac{a}", "a = x", "a) x", r"\unknown", "1.2.3", "a!"] {
            assert!(read(formula).is_nan(), "{formula}: {}", read(formula));
        }
    }
}
