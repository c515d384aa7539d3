//! Test statistics as they are printed: `t(28) = 2.20`, `\chi^2_{3} = 7.81`, `F(2, 57) = 3.91`, `z = 1.96`, `r(48) = .31`.

use super::characters::{PARAGRAPH, UNKNOWN};
use super::distribution::{chi_squared_upper, fisher_upper, normal_two_sided, student_two_sided};
use super::scanner::{Comma, PrintedNumber, Scanner};

/// Which distribution a statistic has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TestKind {
    Student,
    Fisher,
    ChiSquared,
    Normal,
    Correlation,
}

/// How a printed number is related to what it is printed for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Comparison {
    Equal,
    Less,
    Greater,
}

/// A statistic with what is known of its degrees of freedom.
#[derive(Clone, Debug)]
pub(super) struct TestStatistic {
    pub kind: TestKind,
    pub comparison: Comparison,
    pub value: PrintedNumber,
    /// Degrees of freedom, dimensionless.
    pub freedom: Vec<f64>,
    /// Number of observations, for a correlation without degrees of freedom.
    pub observations: Option<f64>,
    /// Behind the value.
    pub end: usize,
}

impl TestStatistic {
    /// Whether the degrees of freedom are known that the distribution needs.
    pub(super) fn is_complete(&self) -> bool {
        match self.kind {
            TestKind::Normal => self.freedom.is_empty(),
            TestKind::Fisher => self.freedom.len() == 2,
            TestKind::Correlation => {
                self.value.value.abs() < 1.0 && self.freedom.len() <= 1 && self.correlation_freedom().is_some()
            }
            TestKind::Student | TestKind::ChiSquared => self.freedom.len() == 1,
        }
    }

    fn correlation_freedom(&self) -> Option<f64> {
        self.freedom.first().copied().or(self.observations.map(|n| n - 2.0)).filter(|df| *df > 0.0)
    }

    /// The two-sided p-value of a statistic of this size, and of χ² and F the upper one.
    pub(super) fn p_value(&self, statistic: f64) -> f64 {
        let first = self.freedom.first().copied().unwrap_or(1.0);
        match self.kind {
            TestKind::Normal => normal_two_sided(statistic),
            TestKind::Student => student_two_sided(statistic, first),
            TestKind::ChiSquared => chi_squared_upper(statistic, first),
            TestKind::Fisher => fisher_upper(statistic, first, self.freedom.get(1).copied().unwrap_or(1.0)),
            TestKind::Correlation => {
                let df = self.correlation_freedom().unwrap_or(1.0);
                let share = (1.0 - statistic * statistic).max(0.0);
                if share == 0.0 { 0.0 } else { student_two_sided(statistic * libm::sqrt(df / share), df) }
            }
        }
    }

    /// The least and the largest p-value that the printed digits of the statistic leave open.
    pub(super) fn p_range(&self) -> [f64; 2] {
        let size = self.value.value.abs();
        let least = (size - self.value.half).max(0.0);
        [self.p_value(size + self.value.half), self.p_value(least)]
    }

    /// Whether each tail of the distribution may be looked at by itself.
    pub(super) fn has_two_sides(&self) -> bool {
        matches!(self.kind, TestKind::Normal | TestKind::Student | TestKind::Correlation)
    }
}

/// A statistic with its value, if one begins at `at`.
pub(super) fn test_statistic(chars: &[char], at: usize) -> Option<TestStatistic> {
    let mut here = Scanner::new(chars, at);
    if here.before().is_alphanumeric() || matches!(here.before(), '_' | '^' | '\\' | '.' | UNKNOWN | '/') {
        return None;
    }
    let kind = name(&mut here)?;
    let mut freedom = Vec::new();
    let mut observations = None;
    for _ in 0..3 {
        here.skip_space();
        match here.peek() {
            '_' if freedom.is_empty() => {
                here.at += 1;
                let brackets = (0..2).take_while(|_| here.take('(')).count();
                match in_list(&mut here, kind) {
                    // No statistic has zero degrees of freedom: t_0 is the one that was computed.
                    Some(list) => freedom = if list.contains(&0.0) { Vec::new() } else { list },
                    None if here.word().is_empty() => return None,
                    None => {}
                }
                if !(0..brackets).all(|_| here.take(')')) {
                    return None;
                }
            }
            '^' if kind == TestKind::ChiSquared => {
                here.at += 1;
                squared(&mut here).then_some(())?;
            }
            '(' | '[' if freedom.is_empty() => (freedom, observations) = in_brackets(&mut here, kind)?,
            _ => {}
        }
    }
    here.skip_space();
    let comparison = comparison(&mut here)?;
    let value = final_value(&mut here)?;
    if kind == TestKind::Normal && !freedom.is_empty() {
        return None;
    }
    Some(TestStatistic { kind, comparison, value, freedom, observations, end: here.at })
}

fn name(here: &mut Scanner<'_>) -> Option<TestKind> {
    let start = *here;
    let word = here.word();
    let kind = match word.as_str() {
        "t" => TestKind::Student,
        "F" => TestKind::Fisher,
        "z" | "Z" => TestKind::Normal,
        "r" => TestKind::Correlation,
        "Q" | "Qw" | "Qb" | "Qwithin" | "Qbetween" => {
            let dash = *here;
            if !(here.take('-') && matches!(here.word().as_str(), "within" | "between" | "w" | "b")) {
                *here = dash;
            }
            TestKind::ChiSquared
        }
        "χ" | "X" | "x" | "chi" | "Chi" => {
            if here.peek() == '-' || (word.len() >= 3 && here.peek() == ' ') {
                here.at += 1;
            }
            let named = ["squared", "square"].iter().any(|word| here.take_text(word));
            here.skip_space();
            let index = *here;
            if !named && !squared(here) {
                // The index before the exponent.
                *here = index;
                let is_letter = matches!(word.as_str(), "χ" | "chi");
                if !(is_letter && here.peek() == '_') {
                    return None;
                }
            }
            return Some(TestKind::ChiSquared);
        }
        _ => {
            *here = start;
            return None;
        }
    };
    let behind = *here;
    here.take_one_of("- ");
    let is_named = ["value", "statistic", "score", "ratio", "test"].contains(&here.word().as_str());
    if !is_named {
        *here = behind;
    }
    Some(kind)
}

/// Takes `^2`, `2` or `^(2)`.
fn squared(here: &mut Scanner<'_>) -> bool {
    here.take('^');
    let as_index = here.take('_');
    let bracket = here.take('(');
    here.skip_space();
    let two = here.take('2') && !here.peek().is_ascii_digit();
    // Before the exponent it has two degrees of freedom.
    two && (!bracket || here.take(')')) && !(as_index && here.peek() == '^')
}

/// Degrees of freedom behind an index sign.
fn in_list(here: &mut Scanner<'_>, kind: TestKind) -> Option<Vec<f64>> {
    let mut list = vec![here.number(Comma::Parts)?.value];
    while kind == TestKind::Fisher && list.len() < 2 {
        let gap = *here;
        here.take_one_of(",;");
        here.skip_space();
        match here.number(Comma::Parts) {
            Some(number) => list.push(number.value),
            None => {
                *here = gap;
                break;
            }
        }
    }
    Some(list)
}

/// Degrees of freedom in brackets, and the number of observations beside them.
fn in_brackets(here: &mut Scanner<'_>, kind: TestKind) -> Option<(Vec<f64>, Option<f64>)> {
    let close = if here.take('(') { ')' } else { here.take('[').then_some(']')? };
    let (mut freedom, mut observations) = (Vec::new(), None);
    for _ in 0..4 {
        here.skip_space();
        let word = here.word();
        let is_one = matches!(word.as_str(), "l" | "I") && kind == TestKind::Fisher;
        if is_one {
            // A one that was read as a letter.
            freedom.push(1.0);
        } else {
            if word.eq_ignore_ascii_case("df") {
                here.take_one_of("12");
            }
            here.skip_space();
            here.take('=');
            here.skip_space();
            let comma = if matches!(word.as_str(), "N" | "n") { Comma::Groups } else { Comma::Parts };
            let number = here.number(comma)?;
            match word.as_str() {
                "" | "df" | "DF" | "ν" if number.value > 0.0 => freedom.push(number.value),
                "N" | "n" => observations = Some(number.value),
                _ => return None,
            }
        }
        here.skip_space();
        if here.take(close) {
            let most = if kind == TestKind::Fisher { 2 } else { 1 };
            return (freedom.len() <= most).then_some((freedom, observations));
        }
        here.take_one_of(",;")?;
    }
    None
}

/// `=`, `<`, `>`; what is neither or both is none.
pub(super) fn comparison(here: &mut Scanner<'_>) -> Option<Comparison> {
    let found = match here.take_one_of("=<>≈≤≥")? {
        '=' | '≈' => Comparison::Equal,
        '<' | '≤' => Comparison::Less,
        _ => Comparison::Greater,
    };
    (!"=<>".contains(here.peek())).then_some(found)
}

/// The value behind the sign; if something is computed there, the value at the end of the chain.
fn final_value(here: &mut Scanner<'_>) -> Option<PrintedNumber> {
    /// Most characters of a computation that is skipped.
    const LONGEST: usize = 200;
    let start = here.at;
    loop {
        here.skip_space();
        let number = here.number(Comma::Groups);
        let behind = here.peek();
        let ends = match behind {
            ' ' if here.ahead(1) == '(' => !(here.ahead(2).is_ascii_digit() || "-.".contains(here.ahead(2))),
            ' ' => !"=≈×+-±/–\u{1}".contains(here.ahead(1)),
            c => ",;:.)]!?".contains(c) || c == PARAGRAPH,
        };
        if let (Some(number), true) = (number, ends) {
            return Some(number);
        }
        while !matches!(here.peek(), '=' | '≈' | PARAGRAPH | ';') {
            here.at += 1;
        }
        if here.at - start > LONGEST || here.take_one_of("=≈").is_none() {
            return None;
        }
    }
}
