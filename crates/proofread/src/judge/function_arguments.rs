//! How far the argument of a function or a root reaches where no brackets are printed: over all factors, over the braces of TeX, or over all
//! digits.

use crate::token::{Token, TokenKind};

/// A side in which each function takes all factors behind it, `sin 2 · 30°`; none if there is no such function.
pub(super) fn under_function(side: &[Token]) -> Option<Vec<Token>> {
    let is_function = |token: &Token| matches!(token.kind, TokenKind::Function(_));
    let at = side.iter().position(is_function)?;
    let ends = |token: &Token| token.is_one_of("+-/,;()[]") || is_function(token);
    let end = side[at + 1..].iter().position(ends).map_or(side.len(), |end| at + 1 + end);
    let inner = &side[at + 1..end];
    // A sign at the end joins the function to what comes next.
    let solid = inner.iter().rposition(|token| !token.is_space() && !token.is_one_of("·×")).map_or(0, |last| last + 1);
    let fits = inner[..solid].iter().any(|token| token.is_one_of("·×"))
        && !side.get(end).is_some_and(|next| next.is_one_of("(["));
    let sign = |c| Token::new(TokenKind::Operator(c), side[at].span);
    let rest = under_function(&side[end..]);
    if !fits {
        return rest.map(|rest| [&side[..end], &rest].concat());
    }
    let rest = rest.unwrap_or_else(|| side[end..].to_vec());
    Some([&side[..=at], &[sign('(')], &inner[..solid], &[sign(')')], &inner[solid..], &rest].concat())
}

/// A side in which each function takes all of the braces behind it, which aren't printed: `\\ln{1 + \\frac12}`. None if no sign is in such
/// braces.
pub(super) fn with_braced_arguments(text: &str, side: &[Token]) -> Option<Vec<Token>> {
    let at = side.iter().position(|token| matches!(token.kind, TokenKind::Function(_)))?;
    let start = side[at].span.end as usize;
    let behind = text.get(start..)?;
    let open = start + behind.len() - behind.trim_start().len();
    let length = group_length(text.get(open..)?)?;
    let close = u32::try_from(open + length).ok()?;
    let end = at + 1 + side[at + 1..].iter().take_while(|token| token.span.start < close).count();
    let fits = side[at + 1..end].iter().any(|token| token.is_one_of("+-·×"));
    let sign = |c| Token::new(TokenKind::Operator(c), side[at].span);
    fits.then(|| [&side[..=at], &[sign('(')], &side[at + 1..end], &[sign(')')], &side[end..]].concat())
}

/// Most bytes of the braces behind a function.
const LONGEST_GROUP: usize = 200;

/// The bytes of the braces with which a text begins, up to the closing one; none if it begins with something else.
fn group_length(text: &str) -> Option<usize> {
    let mut depth = 0usize;
    for (at, byte) in text.bytes().enumerate().take(LONGEST_GROUP) {
        match byte {
            b'{' => depth += 1,
            b'}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (at > 0).then_some(at);
        }
    }
    None
}

/// A side with all digits under the root whose braces were left out, `\sqrt 10`; none if there is no such root.
pub(super) fn with_whole_radicand(side: &[Token]) -> Option<Vec<Token>> {
    let mut out: Vec<Token> = Vec::with_capacity(side.len());
    let mut found = false;
    for token in side {
        let mut copy = token.clone();
        for list in copy.kind.lists() {
            if let Some(changed) = with_whole_radicand(list) {
                (*list, found) = (changed, true);
            }
        }
        if let (Some(digits), Some(last)) = (copy.number(), out.last_mut())
            && let TokenKind::Root(of, _) = &mut last.kind
            && let [first] = of.as_mut_slice()
            && first.span.end == copy.span.start
            && let TokenKind::Number(radicand) = &mut first.kind
        {
            radicand.push_str(digits);
            found = true;
        } else {
            out.push(copy);
        }
    }
    found.then_some(out)
}
