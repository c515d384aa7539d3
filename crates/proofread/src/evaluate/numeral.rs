//! The numbers that a side prints, and the side with other digits in their place.

use crate::decimal::parse_decimal;
use crate::evaluate::printed::power_of_ten;
use crate::token::{Token, TokenKind};

/// A printed number: its digits and the power of ten behind them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Numeral {
    pub digits: String,
    pub power: Option<String>,
}

impl Numeral {
    /// Whether it was printed with more decimals than another one, to which it rounds.
    pub(crate) fn rounds_to(&self, other: &Self) -> bool {
        let decimals = |of: &Self| of.digits.split_once('.').map_or(0, |(_, behind)| behind.len());
        let fewer = decimals(other);
        if decimals(self) <= fewer || self.power != other.power {
            return false;
        }
        let half = 0.5 * power_of_ten(-(fewer as f64));
        let both: Option<(f64, f64)> = parse_decimal(&self.digits).zip(parse_decimal(&other.digits));
        both.is_some_and(|(one, two)| (one - two).abs() <= half * 1.000_001)
    }
}

/// The number at a place, and the place behind it and its power of ten.
pub(crate) fn numeral_at(tokens: &[Token], at: usize) -> Option<(Numeral, usize)> {
    let digits: String = tokens.get(at)?.number()?.chars().filter(|c| *c != ',').collect();
    let mut ahead = (at + 1..tokens.len()).filter(|at| !tokens[*at].is_space());
    let times = ahead.next().filter(|at| tokens[*at].is_one_of("×·*"));
    let ten = times.and_then(|_| ahead.next()).filter(|at| tokens[*at].number() == Some("10"));
    if let Some(ten) = ten
        && let Some(Token { kind: TokenKind::Power(exponent), .. }) = tokens.get(ten + 1)
    {
        let power = exponent.iter().map(|token| match &token.kind {
            TokenKind::Number(digits) => Some(digits.clone()),
            TokenKind::Operator(sign @ ('-' | '+')) => Some(sign.to_string()),
            TokenKind::Space(_) => Some(String::new()),
            _ => None,
        });
        return Some((Numeral { digits, power: power.collect() }, ten + 2));
    }
    Some((Numeral { digits, power: None }, at + 1))
}

/// The tokens with other digits for some of their numbers; none if nothing changes.
pub(crate) fn with_digits(side: &[Token], digits: &dyn Fn(&Numeral) -> Option<String>) -> Option<Vec<Token>> {
    // Most sides have none to replace, and need no copy.
    if !has_digits(side, digits) {
        return None;
    }
    let mut out = side.to_vec();
    replace_digits(&mut out, digits).then_some(out)
}

/// The number at a place that digits may be put in for.
fn replaceable_at(tokens: &[Token], at: usize) -> Option<Numeral> {
    let is_ten = matches!(tokens.get(at + 1), Some(Token { kind: TokenKind::Power(_), .. }))
        && tokens[at].number() == Some("10");
    if is_ten { None } else { numeral_at(tokens, at).map(|(number, _)| number) }
}

fn has_digits(tokens: &[Token], digits: &dyn Fn(&Numeral) -> Option<String>) -> bool {
    (0..tokens.len()).any(|at| {
        let is_power = matches!(tokens[at].kind, TokenKind::Power(_));
        replaceable_at(tokens, at).is_some_and(|number| digits(&number).is_some())
            || (!is_power && tokens[at].inner().any(|inner| has_digits(inner, digits)))
    })
}

fn replace_digits(tokens: &mut [Token], digits: &dyn Fn(&Numeral) -> Option<String>) -> bool {
    let mut any = false;
    for at in 0..tokens.len() {
        if let Some(other) = replaceable_at(tokens, at).and_then(|number| digits(&number)) {
            tokens[at].kind = TokenKind::Number(other);
            any = true;
        }
        if !matches!(tokens[at].kind, TokenKind::Power(_)) {
            for inner in tokens[at].kind.lists() {
                any |= replace_digits(inner, digits);
            }
        }
    }
    any
}

/// Both sides with the numbers exact that both of them print, since such a number stands for one value; none if there are none.
pub(crate) fn with_shared_exact([left, right]: [&[Token]; 2]) -> Option<[Vec<Token>; 2]> {
    let numbers = |side: &[Token]| {
        let found = std::cell::RefCell::new(Vec::new());
        with_digits(side, &|number| {
            found.borrow_mut().push(number.clone());
            None
        });
        found.into_inner()
    };
    let of_left = numbers(left);
    let shared: Vec<Numeral> = numbers(right).into_iter().filter(|number| of_left.contains(number)).collect();
    let exact = |number: &Numeral| {
        let point = if number.digits.contains('.') { "" } else { "." };
        (shared.contains(number) && number.digits.len() > 1).then(|| format!("{}{point}{:0<15}", number.digits, ""))
    };
    Some([with_digits(left, &exact)?, with_digits(right, &exact)?])
}
