//! Numbers that went into a calculation with other digits than are printed: results from before with the digits that they had or
//! that were printed then, constants of nature in full, and 3.14 for π.

use crate::decimal::{fixed, parse_decimal};
use crate::evaluate::numeral::{Numeral, numeral_at, with_digits};
use crate::evaluate::printed::{Mode, PrintedNumber};
use crate::evaluate::value::SideValue;
use crate::join::chain::{ChainSide, Relation};
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::lost_digits::significant;
use crate::judge::verdict::judge;
use crate::token::{Span, Token, TokenKind};

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

/// A result, and by how much its value before rounding differs from what is printed.
#[derive(Debug)]
struct EarlierResult {
    number: Numeral,
    /// With the numbers before it as they are printed.
    ratio: f64,
    /// With the numbers before it not rounded either.
    from_start: f64,
}

/// The results of an example or a section, so far.
#[derive(Debug, Default)]
pub(crate) struct EarlierResults {
    scope: u32,
    printed: Vec<EarlierResult>,
}

impl EarlierResults {
    /// Notes the result of a calculation.
    pub(crate) fn record(
        &mut self,
        scope: u32,
        computed: &ChainSide,
        result: &ChainSide,
        values: &(SideValue, SideValue),
    ) {
        if scope != self.scope {
            self.printed.clear();
            self.scope = scope;
        }
        let Some(number) = alone(&result.tokens) else { return };
        let Some(printed) = PrintedNumber::read(&number.digits) else { return };
        let (half, unit) = printed.open(Mode::Result, number.power.is_some());
        let ratio = |(left, right): &(SideValue, SideValue), within: f64| {
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
        self.printed.push(EarlierResult { number, ratio, from_start });
    }

    /// Whether a calculation gives all digits of its result if some of its numbers had other digits than are printed.
    pub(crate) fn explains(&self, scope: u32, computed: &ChainSide, result: &ChainSide) -> bool {
        let agrees = |tokens: Vec<Token>| {
            judge(&tokens, &result.tokens, Relation::Equal, None).verdict == ChainVerdict::Consistent
        };
        alone(&result.tokens).is_some() && self.readings(scope, &computed.tokens).into_iter().any(agrees)
    }

    fn readings(&self, scope: u32, side: &[Token]) -> Vec<Vec<Token>> {
        let mut out: Vec<Vec<Token>> = SHORT_PI.iter().filter_map(|digits| with_pi(side, digits)).collect();
        let full = with_digits(side, &constant);
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
    fn unrounded(&self, side: &[Token], ratio: impl Fn(&EarlierResult) -> f64) -> Option<Vec<Token>> {
        with_digits(side, &|number| {
            let mut known = self.printed.iter().rev();
            let known = known
                .clone()
                .find(|of| of.number == *number)
                .or_else(|| known.find(|of| of.number.rounds_to(number)))?;
            let value = parse_decimal(&known.number.digits)?;
            let digits = fixed(value * ratio(known), 15);
            (parse_decimal(&digits) != parse_decimal(&number.digits)).then_some(digits)
        })
    }
}

/// The number that a side is, with whatever unit, if it has two digits or more, or is a small decimal.
fn alone(side: &[Token]) -> Option<Numeral> {
    let at = side.iter().position(|token| token.number().is_some())?;
    let (number, next) = numeral_at(side, at)?;
    let others = side[next..].iter().any(|token| token.number().is_some() || matches!(token.kind, TokenKind::Root(..)));
    // One digit behind two places may be rounded, too: 1.39/15 = 0.09.
    let is_open = significant(&number.digits) >= 2 || number.digits.starts_with("0.0");
    (!others && is_open).then_some(number)
}

/// All digits of a constant of nature, if a number is one that was rounded.
fn constant(number: &Numeral) -> Option<String> {
    let power: i32 = number.power.as_ref()?.parse().ok()?;
    let decimals = number.digits.split_once('.')?.1.len();
    let rounded = |full: &str| parse_decimal(full).is_some_and(|of| fixed(of, decimals) == number.digits);
    let known = CONSTANTS.iter().find(|(full, of)| *of == power && rounded(full))?;
    (decimals >= 1 && known.0 != number.digits).then(|| known.0.to_owned())
}

/// The tokens with π as large as these digits; none if it does not occur. It stays there to be seen, since an angle with π is in radians.
fn with_pi(side: &[Token], digits: &str) -> Option<Vec<Token>> {
    fn replace_pi(tokens: &mut [Token], share: &str) -> bool {
        let mut any = false;
        for token in tokens {
            if token.kind == TokenKind::Name("π".to_owned()) {
                let span: Span = token.span;
                let factors = [token.kind.clone(), TokenKind::Operator('·'), TokenKind::Number(share.to_owned())];
                *token = Token::new(TokenKind::Group(factors.map(|kind| Token::new(kind, span)).to_vec()), span);
                any = true;
            } else {
                token.kind.lists().into_iter().for_each(|inner| any |= replace_pi(inner, share));
            }
        }
        any
    }
    let share = parse_decimal(digits)? / std::f64::consts::PI;
    let mut out = side.to_vec();
    replace_pi(&mut out, &fixed(share, 17)).then_some(out)
}
