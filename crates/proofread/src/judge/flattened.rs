//! Sides whose exponents and root signs were lost when a page was turned into plain lines: 2.5² as 2.52, √2.0 as 2.0 with the sign in
//! a line above.

use crate::judge::sides::Sides;
use crate::judge::substitution::without_space;
use crate::token::{MathFunction, Span, Token, TokenKind, span_of};

/// Most ways in which the numbers of two sides are read.
const MOST: usize = 16;
/// How far before a formula its root sign may stand, in bytes.
const FARTHEST_ROOT: usize = 60;

/// What two sides in plain lines would be with exponents that are printed as last digits, and with the left side under a root whose
/// sign stands before them in the text.
pub(super) fn with_lost_marks(before: &str, left: &[Token], right: &[Token]) -> Vec<Sides> {
    let raised = with_exponents(left, right);
    let roots: Vec<Sides> = match has_root(before) {
        true => raised.iter().flat_map(|sides| [None, Some("3")].map(|degree| under_root(sides, degree))).collect(),
        false => Vec::new(),
    };
    // What is as it is printed has been judged before.
    raised.into_iter().skip(1).chain(roots).collect()
}

/// Whether what stands without a blank around a place is the same equation twice, as programs copy a formula of a page that has it in two
/// forms: `3×4+1=133×4+1=13`.
pub(super) fn is_doubled(text: &str, around: Span) -> bool {
    let ends = |c: char| c.is_whitespace() || c == '\u{200b}';
    let (start, end) = (around.start as usize, around.end as usize);
    let (Some(before), Some(behind)) = (text.get(..start), text.get(end..)) else { return false };
    let from = before.rfind(ends).map_or(0, |at| at + before[at..].chars().next().map_or(1, char::len_utf8));
    let to = end + behind.find(ends).unwrap_or(behind.len());
    let Some(run) = text.get(from..to).filter(|run| run.len() <= LONGEST_RUN) else { return false };
    run.split_at_checked(run.len() / 2).is_some_and(|(one, other)| one == other && one.contains('='))
}

/// Most bytes of an equation that may stand twice.
const LONGEST_RUN: usize = 400;

/// Whether a root sign stands near the end of a text; of a large one, a `p` in a line of its own is left.
fn has_root(before: &str) -> bool {
    let from = before.len().saturating_sub(FARTHEST_ROOT);
    let near = (from..before.len()).find_map(|at| before.get(at..)).unwrap_or_default();
    near.contains('√') || near.lines().any(|line| line.trim() == "p")
}

/// The sides as they are printed, and with each choice of numbers whose last digits are exponents.
fn with_exponents(left: &[Token], right: &[Token]) -> Vec<Sides> {
    let mut out = vec![[Vec::new(), Vec::new()]];
    for (side, tokens) in [left, right].into_iter().enumerate() {
        for token in tokens {
            let parts = token.number().and_then(base_and_exponent);
            let count = out.len();
            if let Some((base, exponent)) = parts.filter(|_| 2 * count <= MOST) {
                let number = |digits: &str| Token::new(TokenKind::Number(digits.to_owned()), token.span);
                let raised = [number(base), Token::new(TokenKind::Power(vec![number(exponent)]), token.span)];
                out.extend_from_within(..);
                out[count..].iter_mut().for_each(|sides| sides[side].extend_from_slice(&raised));
            }
            out[..count].iter_mut().for_each(|sides| sides[side].push(token.clone()));
        }
    }
    out
}

/// A number whose last digit may be an exponent, or all digits behind a ten.
fn base_and_exponent(digits: &str) -> Option<(&str, &str)> {
    let at = match digits.strip_prefix("10") {
        Some(power) if matches!(power.len(), 1 | 2) => 2,
        _ => digits.len().checked_sub(1)?,
    };
    let (base, exponent) = digits.split_at_checked(at)?;
    let is_whole = !digits.contains(',') && exponent.bytes().all(|byte| byte.is_ascii_digit());
    // Higher powers are rare but for those of ten, and too many numbers would fit by chance.
    let is_exponent = if base == "10" { !exponent.starts_with('0') } else { matches!(exponent, "2" | "3" | "4") };
    let is_base = base.bytes().next_back().is_some_and(|byte| byte.is_ascii_digit());
    (is_whole && is_exponent && is_base).then_some((base, exponent))
}

/// The sides with all of the left one under a root of this degree, which is two if none is given.
fn under_root([left, right]: &Sides, degree: Option<&str>) -> Sides {
    let span = span_of(left);
    let degree = degree.map(|degree| Token::new(TokenKind::Number(degree.to_owned()), span));
    let root = Token::new(TokenKind::Root(left.clone(), degree.into_iter().collect()), span);
    [vec![root], right.clone()]
}

/// A side with what stands behind the stroke in an exponent that was typed without brackets, `(9 + 7)^1/2`; none if there is no such
/// exponent behind brackets.
pub(super) fn with_whole_exponents(side: &[Token]) -> Option<Vec<Token>> {
    let mut out = side.to_vec();
    let at = out.windows(4).position(|of| {
        let [close, power, stroke, below] = of else { return false };
        let raised = matches!(&power.kind, TokenKind::Power(above) if matches!(above.as_slice(), [one] if one.number() == Some("1")));
        close.is_sign(')') && raised && stroke.is_sign('/') && matches!(below.number(), Some("2" | "3" | "4"))
    })?;
    let below: Vec<Token> = out.drain(at + 2..at + 4).skip(1).collect();
    let span = side[at + 1].span;
    let one = Token::new(TokenKind::Number("1".to_owned()), span);
    let half = Token::new(TokenKind::Fraction(vec![one], below), span);
    out[at + 1] = Token::new(TokenKind::Power(vec![half]), span);
    Some(out)
}

/// A side with the base of a logarithm that is printed close before its number, `log101,000` or `log28`; none if there is none.
pub(super) fn with_base_of_logarithm(side: &[Token]) -> Option<Vec<Token>> {
    let mut out = side.to_vec();
    let mut found = false;
    for at in 1..out.len() {
        let (before, behind) = out.split_at_mut(at);
        let (Some(name), TokenKind::Number(digits)) = (before.last_mut(), &mut behind[0].kind) else { continue };
        if name.kind != TokenKind::Function(MathFunction::Log) {
            continue;
        }
        // The comma of a thousand stays where it is.
        for (base, function) in [("10", MathFunction::Lg), ("2", MathFunction::LogTo(2))] {
            let rest = digits.strip_prefix(base).filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
            if let Some(rest) = rest.map(str::to_owned) {
                (name.kind, *digits, found) = (TokenKind::Function(function), rest, true);
                break;
            }
        }
    }
    found.then_some(out)
}

/// A side with all factors behind a root sign under it, whose bar is lost in running text; none if there is no such sign.
pub(super) fn under_root_sign(side: &[Token]) -> Option<Vec<Token>> {
    let at = side.iter().position(|token| token.is_sign('√'))?;
    if side.get(at + 1)?.is_sign('(') {
        return None;
    }
    let ends = |token: &Token| token.is_one_of("+-");
    let end = side[at..].iter().position(ends).map_or(side.len(), |end| at + end);
    let sign = |c| Token::new(TokenKind::Operator(c), side[at].span);
    Some([&side[..=at], &[sign('(')], &side[at + 1..end], &[sign(')')], &side[end..]].concat())
}

/// Whether exponents may have lost their place in running text: (6.38 × 106)2 for (6.38 × 10⁶)².
pub(super) fn has_lost_exponents(side: &[Token]) -> bool {
    let solid = without_space(side);
    solid.windows(2).any(|pair| {
        let touches = pair[0].span.end == pair[1].span.start;
        let digits = pair[1].number().unwrap_or_default();
        let power = pair[0].is_one_of("×·")
            && digits.len() > 2
            && digits.len() < 5
            && digits.starts_with("10")
            && digits.chars().all(|c| c.is_ascii_digit())
            && digits.trim_end_matches('0') != "1";
        power || (touches && pair[0].is_sign(')') && matches!(digits, "2" | "3" | "4"))
    })
}
