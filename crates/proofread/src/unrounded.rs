//! Numbers that went into a calculation with other digits than are printed: results from before with the digits that they had or
//! that were printed then, constants of nature in full, and 3.14 for π.

use crate::chain::{Relation, Side};
use crate::printed::{self as digits, Mode};
use crate::token::{Kind, Span, Token};
use crate::value::Value;
use crate::verdict::{Verdict, judge};

/// Constants of nature, in units of the SI or with electronvolts: the digits, and the power of ten behind them.
const CONSTANTS: [(&str, i32); 23] = [
    ("2.99792458", 8),      // speed of light, m/s
    ("6.62607015", -34),    // Planck constant, J s
    ("4.135667696", -15),   // Planck constant, eV s
    ("1.054571817", -34),   // reduced Planck constant, J s
    ("6.582119569", -16),   // reduced Planck constant, eV s
    ("1.602176634", -19),   // elementary charge, C
    ("1.380649", -23),      // Boltzmann constant, J/K
    ("8.617333262", -5),    // Boltzmann constant, eV/K
    ("6.02214076", 23),     // Avogadro constant, 1/mol
    ("6.67430", -11),       // constant of gravitation, N m²/kg²
    ("9.1093837139", -31),  // mass of the electron, kg
    ("1.67262192595", -27), // mass of the proton, kg
    ("1.67492750056", -27), // mass of the neutron, kg
    ("1.66053906892", -27), // atomic mass constant, kg
    ("8.8541878188", -12),  // electric constant, F/m
    ("8.9875517862", 9),    // Coulomb constant, N m²/C²
    ("1.25663706127", -6),  // magnetic constant, N/A²
    ("5.670374419", -8),    // Stefan-Boltzmann constant, W/(m² K⁴)
    ("2.897771955", -3),    // Wien's displacement constant, m K
    ("1.0973731568", 7),    // Rydberg constant, 1/m
    ("2.1798723611", -18),  // Rydberg energy, J
    ("5.29177210544", -11), // Bohr radius, m
    ("9.2740100657", -24),  // Bohr magneton, J/T
];

/// What authors put in for π.
const SHORT_PI: [&str; 2] = ["3.14", "3.1416"];

/// Most results that are kept of one example or section.
const MOST: usize = 60;

/// A printed number: its digits and the power of ten behind them.
#[derive(Clone, Debug, PartialEq)]
struct Number {
    digits: String,
    power: Option<String>,
}

impl Number {
    /// Whether it was printed with more decimals than another one, to which it rounds.
    fn rounds_to(&self, other: &Self) -> bool {
        let decimals = |of: &Self| of.digits.split_once('.').map_or(0, |(_, behind)| behind.len());
        let fewer = decimals(other);
        let half = 0.5 * digits::power_of_ten(-(fewer as f64));
        let apart = |(one, two): (f64, f64)| (one - two).abs() <= half * 1.000_001;
        let both = self.digits.parse().ok().zip(other.digits.parse().ok());
        decimals(self) > fewer && self.power == other.power && both.is_some_and(apart)
    }
}

/// A result, and by how much its value before rounding differs from what is printed.
#[derive(Debug)]
struct Printed {
    number: Number,
    /// With the numbers before it as they are printed.
    ratio: f64,
    /// With the numbers before it not rounded either.
    from_start: f64,
}

/// The results of an example or a section, so far.
#[derive(Debug, Default)]
pub(crate) struct Results {
    scope: u32,
    printed: Vec<Printed>,
}

impl Results {
    /// Notes the result of a calculation.
    pub fn note(&mut self, scope: u32, computed: &Side, result: &Side, values: &(Value, Value)) {
        if scope != self.scope {
            self.printed.clear();
            self.scope = scope;
        }
        let Some(number) = alone(&result.tokens) else { return };
        let Some(printed) = digits::Printed::read(&number.digits) else { return };
        let (half, unit) = printed.open(Mode::Result, number.power.is_some());
        let ratio = |(left, right): &(Value, Value), within: f64| {
            let ratio = left.number().ok()?.point / right.number().ok()?.point;
            ((ratio - 1.0).abs() * printed.value <= 1.000_001 * within).then_some(ratio)
        };
        let plain = ratio(values, half);
        let from_start = self.unrounded(&computed.tokens, |of| of.from_start).and_then(|tokens| {
            let values = judge(&tokens, &result.tokens, Relation::Equal, None).values?;
            ratio(&values, unit)
        });
        let (Some(ratio), Some(from_start)) = (plain.or(from_start), from_start.or(plain)) else { return };
        if self.printed.len() >= MOST {
            self.printed.remove(0);
        }
        self.printed.push(Printed { number, ratio, from_start });
    }

    /// Whether a calculation gives all digits of its result if some of its numbers had other digits than are printed.
    pub fn explain(&self, scope: u32, computed: &Side, result: &Side) -> bool {
        let agrees =
            |tokens: Vec<Token>| judge(&tokens, &result.tokens, Relation::Equal, None).verdict == Verdict::Consistent;
        alone(&result.tokens).is_some() && self.readings(scope, &computed.tokens).into_iter().any(agrees)
    }

    fn readings(&self, scope: u32, side: &[Token]) -> Vec<Vec<Token>> {
        let mut out: Vec<Vec<Token>> = SHORT_PI.iter().filter_map(|digits| with_pi(side, digits)).collect();
        let full = changed(side, &constant);
        if scope == self.scope {
            for side in [Some(side), full.as_deref()].into_iter().flatten() {
                out.extend(self.unrounded(side, |of| of.ratio));
                out.extend(self.unrounded(side, |of| of.from_start));
                // With the digits that were printed.
                out.extend(self.unrounded(side, |_| 1.0));
            }
        }
        out.extend(full);
        out
    }

    /// A side with the results in it as they were before rounding; none if there are none.
    fn unrounded(&self, side: &[Token], ratio: impl Fn(&Printed) -> f64) -> Option<Vec<Token>> {
        changed(side, &|number| {
            let mut known = self.printed.iter().rev();
            let known = known
                .clone()
                .find(|of| of.number == *number)
                .or_else(|| known.find(|of| of.number.rounds_to(number)))?;
            let value: f64 = known.number.digits.parse().ok()?;
            let digits = format!("{:.15}", value * ratio(known));
            (digits.parse() != number.digits.parse::<f64>()).then_some(digits)
        })
    }
}

/// The number that a side is, with whatever unit, if it has two digits or more.
fn alone(side: &[Token]) -> Option<Number> {
    let at = side.iter().position(|token| token.number().is_some())?;
    let (number, next) = number_at(side, at)?;
    let others = side[next..].iter().any(|token| token.number().is_some() || matches!(token.kind, Kind::Root(..)));
    let significant = number.digits.trim_start_matches(['0', '.']).chars().filter(char::is_ascii_digit).count();
    (!others && significant >= 2).then_some(number)
}

/// The number at a place, and the place behind it and its power of ten.
fn number_at(tokens: &[Token], at: usize) -> Option<(Number, usize)> {
    let digits: String = tokens.get(at)?.number()?.chars().filter(|c| *c != ',').collect();
    let mut ahead = (at + 1..tokens.len()).filter(|at| !tokens[*at].is_space());
    let times = ahead.next().filter(|at| tokens[*at].is_one_of("×·*"));
    let ten = times.and_then(|_| ahead.next()).filter(|at| tokens[*at].number() == Some("10"));
    if let Some(ten) = ten
        && let Some(Token { kind: Kind::Power(exponent), .. }) = tokens.get(ten + 1)
    {
        let power = exponent.iter().map(|token| match &token.kind {
            Kind::Number(digits) => Some(digits.clone()),
            Kind::Operator(sign @ ('-' | '+')) => Some(sign.to_string()),
            Kind::Space(_) => Some(String::new()),
            _ => None,
        });
        return Some((Number { digits, power: power.collect() }, ten + 2));
    }
    Some((Number { digits, power: None }, at + 1))
}

/// The tokens with other digits for some of their numbers; none if nothing changes.
fn changed(side: &[Token], digits: &dyn Fn(&Number) -> Option<String>) -> Option<Vec<Token>> {
    let mut out = side.to_vec();
    change(&mut out, digits).then_some(out)
}

fn change(tokens: &mut [Token], digits: &dyn Fn(&Number) -> Option<String>) -> bool {
    let mut any = false;
    for at in 0..tokens.len() {
        let is_ten =
            matches!(tokens.get(at + 1), Some(Token { kind: Kind::Power(_), .. })) && tokens[at].number() == Some("10");
        if !is_ten && let Some(other) = number_at(tokens, at).and_then(|(number, _)| digits(&number)) {
            tokens[at].kind = Kind::Number(other);
            any = true;
        }
        if !matches!(tokens[at].kind, Kind::Power(_)) {
            for inner in tokens[at].kind.lists() {
                any |= change(inner, digits);
            }
        }
    }
    any
}

/// Both sides with the numbers exact that both of them print, since such a number stands for one value; none if there are none.
pub(crate) fn shared_are_exact([left, right]: [&[Token]; 2]) -> Option<[Vec<Token>; 2]> {
    let numbers = |side: &[Token]| {
        let found = std::cell::RefCell::new(Vec::new());
        changed(side, &|number| {
            found.borrow_mut().push(number.clone());
            None
        });
        found.into_inner()
    };
    let of_left = numbers(left);
    let shared: Vec<Number> = numbers(right).into_iter().filter(|number| of_left.contains(number)).collect();
    let exact = |number: &Number| {
        let point = if number.digits.contains('.') { "" } else { "." };
        (shared.contains(number) && number.digits.len() > 1).then(|| format!("{}{point}{:0<15}", number.digits, ""))
    };
    Some([changed(left, &exact)?, changed(right, &exact)?])
}

/// All digits of a constant of nature, if a number is one that was rounded.
fn constant(number: &Number) -> Option<String> {
    let power: i32 = number.power.as_ref()?.parse().ok()?;
    let decimals = number.digits.split_once('.')?.1.len();
    let rounded = |full: &str| full.parse::<f64>().is_ok_and(|of| format!("{of:.decimals$}") == number.digits);
    let known = CONSTANTS.iter().find(|(full, of)| *of == power && rounded(full))?;
    (decimals >= 1 && known.0 != number.digits).then(|| known.0.to_owned())
}

/// The tokens with digits for π; none if it does not occur.
fn with_pi(side: &[Token], digits: &str) -> Option<Vec<Token>> {
    fn put(tokens: &mut [Token], digits: &str) -> bool {
        let mut any = false;
        for token in tokens {
            if token.kind == Kind::Name("π".to_owned()) {
                let span: Span = token.span;
                let number = Token::new(Kind::Number(digits.to_owned()), span);
                *token = Token::new(Kind::Group(vec![number]), span);
                any = true;
            } else {
                token.kind.lists().into_iter().for_each(|inner| any |= put(inner, digits));
            }
        }
        any
    }
    let mut out = side.to_vec();
    put(&mut out, digits).then_some(out)
}
