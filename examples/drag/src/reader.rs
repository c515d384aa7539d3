//! Equations with exponentials, logarithms, integrals and limits of integration, which the engine's reader does not know.
//!
//! Each of these parts is evaluated by itself, and a letter takes its place. What is left is read by the engine. So a misprint inside
//! such a part changes a number, and is refused like any other.

use geneva_evidence::tex::{self, Moment};

/// How an integral is worked: the area under a curve between two places.
pub(crate) type Rule = fn([f64; 2], &dyn Fn(f64) -> f64) -> f64;

/// Whether an equation holds in all these states; none if it cannot be read.
pub(crate) fn holds(equation: &str, states: &[Moment], rule: Rule) -> Option<bool> {
    let mut all = true;
    for state in states {
        let mut left = Plain { state: state.clone(), rule, made: 0 };
        let sides: Option<Vec<String>> = spelt(equation).split('=').map(|side| left.side(side)).collect();
        all &= tex::holds(&sides?.join("="), [&left.state])?;
    }
    Some(all)
}

/// Whether the left side of `\leq` is nowhere greater than the right one, and equal to it in the last of these states; none if it
/// cannot be read.
pub(crate) fn is_bounded(relation: &str, states: &[Moment]) -> Option<bool> {
    let (sign, [low, high]) = match (relation.split_once(r"\leq"), relation.split_once(r"\geq")) {
        (Some((low, high)), None) => (1.0, [low, high]),
        (None, Some((low, high))) => (-1.0, [low, high]),
        _ => return None,
    };
    let gaps: Vec<f64> = states
        .iter()
        .map(|state| sign * (tex::value_at(high.trim(), state) - tex::value_at(low.trim(), state)))
        .collect();
    if gaps.iter().any(|gap| gap.is_nan()) {
        return None;
    }
    let meets = gaps.last().is_some_and(|gap| gap.abs() < 1e-9);
    Some(meets && gaps.iter().all(|gap| *gap > -1e-9))
}

/// The characters with names that the engine reads: a letter for the viscosity, arrows for unit vectors.
fn spelt(equation: &str) -> String {
    [
        (r"\eta", "η "),
        (r"\hat{i}", r"\vec{i}"),
        (r"\hat{j}", r"\vec{j}"),
        (r"\vec{v}(t)", r"\vec{v}"),
        (r"\vec{r}(t)", r"\vec{r}"),
    ]
    .into_iter()
    .fold(equation.to_owned(), |tex, (from, to)| tex.replace(from, to))
}

/// A state to which letters are added for the parts that are evaluated.
struct Plain {
    state: Moment,
    rule: Rule,
    made: usize,
}

impl Plain {
    /// A side of an equation without what the engine does not know; none if such a part cannot be read.
    fn side(&mut self, side: &str) -> Option<String> {
        if let Some(at) = side.find(r"\right|_") {
            let start = side.find(r"\left.")?;
            let body = side.get(start + r"\left.".len()..at)?;
            let (limits, rest) = limits(&side[at + r"\right|".len()..])?;
            let letter = dashed(body, limits)?;
            let [low, high] = self.ends(limits)?;
            let value = self.at(body, letter, high)? - self.at(body, letter, low)?;
            return Some(format!("{} {} {rest}", &side[..start], self.named(value)));
        }
        if let Some(start) = side.find(r"\int") {
            let (limits, rest) = limits(&side[start + r"\int".len()..])?;
            let [low, high] = self.ends(limits)?;
            let letter = dashed(rest, limits)?;
            let step = format!("d{letter}'");
            if rest.matches(&step).count() != 1 || rest.contains(r"\int") {
                return None;
            }
            let curve = rest.replace(&step, " 1 ");
            self.at(&curve, letter, (low + high) / 2.0)?;
            let value = (self.rule)([low, high], &|place| self.at(&curve, letter, place).unwrap_or(f64::NAN));
            return Some(format!("{} {}", &side[..start], self.named(value)));
        }
        let plain = self.functions(side)?;
        Some(steps_named(&plain))
    }

    /// The value of a formula where a dashed letter stands for this.
    fn at(&self, formula: &str, letter: char, value: f64) -> Option<f64> {
        let state = self.state.clone().with([(&*format!("{letter}'"), value)]);
        Self { state, rule: self.rule, made: 100 }.value(formula)
    }

    /// The value of a formula without an integral; none if it has none.
    fn value(&mut self, formula: &str) -> Option<f64> {
        let plain = self.functions(formula)?;
        Some(tex::value_at(plain.trim(), &self.state)).filter(|value| !value.is_nan())
    }

    fn ends(&mut self, [low, high]: [&str; 2]) -> Option<[f64; 2]> {
        Some([self.value(low)?, self.value(high)?])
    }

    /// A name for a number.
    fn named(&mut self, value: f64) -> String {
        let name = format!("J_{{{}}}", self.made);
        self.made += 1;
        self.state = self.state.clone().with([(&*name, value)]);
        name
    }

    /// The formula with letters for its exponentials and logarithms.
    fn functions(&mut self, formula: &str) -> Option<String> {
        let mut plain = formula.to_owned();
        while let Some(at) = plain.find("e^") {
            let (exponent, end) = group(&plain, at + 2)?;
            let value = libm::exp(self.value(&exponent)?);
            plain = format!("{} {} {}", &plain[..at], self.named(value), &plain[end..]);
        }
        while let Some(at) = plain.rfind(r"\ln") {
            let (argument, end) = argument(&plain, at + r"\ln".len())?;
            let value = libm::log(self.value(&argument)?);
            plain = format!("{} {} {}", &plain[..at], self.named(value), &plain[end..]);
        }
        Some(plain)
    }
}

/// Limits below and above, and what is behind them.
fn limits(behind: &str) -> Option<([&str; 2], &str)> {
    let below = behind.strip_prefix('_')?;
    let (low, rest) = one(below)?;
    let (high, rest) = one(rest.strip_prefix('^')?)?;
    Some(([low, high], rest))
}

/// A group in braces without a group in it, or one character, and what is behind it.
fn one(text: &str) -> Option<(&str, &str)> {
    match text.strip_prefix('{') {
        Some(inside) => inside.split_once('}'),
        None => text.chars().next().filter(|c| c.is_alphanumeric()).map(|c| text.split_at(c.len_utf8())),
    }
}

/// The one letter with a dash in a formula. It runs up to the same letter without a dash: any other would say the same, but it would
/// not be the section's way of writing.
fn dashed(formula: &str, [_, high]: [&str; 2]) -> Option<char> {
    let mut found = formula.match_indices('\'').filter_map(|(at, _)| formula[..at].chars().next_back());
    let letter = found.next().filter(|letter| high.chars().eq([*letter]))?;
    found.all(|other| other == letter).then_some(letter)
}

/// The characters of the group that starts at a byte, and the byte behind it.
fn group(text: &str, start: usize) -> Option<(String, usize)> {
    let first = text[start..].chars().next()?;
    let (open, close) = match first {
        '{' => ('{', '}'),
        '(' => ('(', ')'),
        '[' => ('[', ']'),
        other => return Some((other.to_string(), start + other.len_utf8())),
    };
    let mut depth = 0;
    for (at, c) in text[start..].char_indices() {
        depth += i32::from(c == open) - i32::from(c == close);
        if depth == 0 {
            return Some((text[start + 1..start + at].to_owned(), start + at + 1));
        }
    }
    None
}

/// What a logarithm is taken of, and the byte behind it.
fn argument(text: &str, from: usize) -> Option<(String, usize)> {
    let start = from + text[from..].find(|c| c != ' ')?;
    if text[start..].starts_with(r"\frac{") {
        let (above, middle) = group(text, start + r"\frac".len())?;
        let (below, end) = group(text, middle)?;
        return Some((format!(r"\frac{{{above}}}{{{below}}}"), end));
    }
    let length = text[start..].find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len() - start);
    if length > 0 {
        return Some((text[start..start + length].to_owned(), start + length));
    }
    group(text, start).filter(|(_, end)| text[start..*end].is_ascii() && !text[start..].starts_with('\\'))
}

/// The characters with a letter for each small step, such as dt, that is not part of a rate.
fn steps_named(formula: &str) -> String {
    let mut named = formula.to_owned();
    for letter in ["v", "t", "x", "y", "r"] {
        let step = format!("d{letter}");
        let mut from = 0;
        while let Some(at) = named[from..].find(&step).map(|at| from + at) {
            let is_word = named[..at].ends_with(|c: char| c.is_ascii_alphabetic() || c == '\\');
            let is_rate = named[at..].starts_with(&format!("{step}}}{{dt}}"))
                || named[..at].ends_with("}{") && named[at..].starts_with("dt}");
            let to = if is_word || is_rate { step.clone() } else { format!("D_{letter} ") };
            named.replace_range(at..at + step.len(), &to);
            from = at + to.len();
        }
    }
    named
}
