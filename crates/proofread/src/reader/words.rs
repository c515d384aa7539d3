//! Running text to tokens: numbers, words, units, and the signs between them.

use crate::token::{MathFunction, SourceChar, Span, Token, TokenKind};
use crate::unit::is_currency_sign;

/// The sign that a look-alike stands for, or none if it is to be left out.
pub(crate) fn plain_char(c: char) -> Option<char> {
    Some(match c {
        '\u{a0}' | '\u{2000}'..='\u{200a}' | '\u{202f}' | '\u{205f}' | '\u{3000}' => ' ',
        '\u{2061}'..='\u{2064}' | '\u{200b}'..='\u{200d}' | '\u{feff}' | '\u{ad}' => return None,
        'µ' => 'μ',
        '\u{2126}' => 'Ω',
        '−' | '–' | '—' | '‒' | '‐' | '\u{2011}' | '﹣' | '－' => '-',
        'º' | '˚' | '∘' | '◦' => '°',
        '⋅' | '•' | '∙' | '‧' => '·',
        '✕' | '⨯' => '×',
        'ϕ' => 'φ',
        'ϵ' => 'ε',
        '\u{212b}' => 'Å',
        '÷' | '∕' | '⁄' => '/',
        '＝' | '﹦' => '=',
        '√' => '√',
        'ħ' => 'ℏ',
        _ => c,
    })
}

/// The characters with look-alikes replaced.
pub(crate) fn plain_chars(signs: &[SourceChar]) -> Vec<SourceChar> {
    let mut out = Vec::with_capacity(signs.len());
    for sign in signs {
        match sign.c {
            '℃' | '℉' => {
                out.push(SourceChar { c: '°', ..*sign });
                out.push(SourceChar { c: if sign.c == '℃' { 'C' } else { 'F' }, ..*sign });
            }
            c => out.extend(plain_char(c).map(|c| SourceChar { c, ..*sign })),
        }
    }
    out
}

/// The length of the number at the start: digits, commas between groups of three, one point.
pub(crate) fn number_length(signs: &[SourceChar]) -> usize {
    let digit = |at: usize| signs.get(at).is_some_and(|sign| sign.c.is_ascii_digit());
    let is = |at: usize, c: char| signs.get(at).is_some_and(|sign| sign.c == c);
    let mut at = 0;
    while digit(at) {
        at += 1;
    }
    let grouped = |at: usize| is(at, ',') && (1..=3).all(|k| digit(at + k)) && !digit(at + 4);
    if (1..=3).contains(&at) && !(at == 1 && is(0, '0')) {
        // Lakhs and crores: 1,20,000.
        let mut pairs = at;
        while at < 3 && is(pairs, ',') && digit(pairs + 1) && digit(pairs + 2) && is(pairs + 3, ',') {
            pairs += 3;
        }
        if grouped(pairs) {
            at = pairs;
        }
        while grouped(at) {
            at += 4;
        }
    }
    if is(at, '.') && digit(at + 1) {
        at += 1;
        while digit(at) {
            at += 1;
        }
    }
    at
}

/// The token of the number that these characters are.
pub(crate) fn number(signs: &[SourceChar]) -> Token {
    Token::new(TokenKind::Number(signs.iter().map(|sign| sign.c).collect()), span_of_chars(signs))
}

/// The stretch that characters cover.
pub(crate) fn span_of_chars(signs: &[SourceChar]) -> Span {
    signs.iter().fold(Span::default(), |span, sign| span.join(sign.span))
}

fn superscript_char(c: char) -> Option<char> {
    Some(match c {
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10)?,
        '⁻' => '-',
        '⁺' => '+',
        _ => return None,
    })
}

fn subscript_char(c: char) -> Option<char> {
    ('₀'..='₉').contains(&c).then(|| char::from_digit(c as u32 - '₀' as u32, 10)).flatten()
}

fn vulgar(c: char) -> Option<(&'static str, &'static str)> {
    Some(match c {
        '½' => ("1", "2"),
        '⅓' => ("1", "3"),
        '⅔' => ("2", "3"),
        '¼' => ("1", "4"),
        '¾' => ("3", "4"),
        '⅛' => ("1", "8"),
        '⅜' => ("3", "8"),
        '⅝' => ("5", "8"),
        '⅞' => ("7", "8"),
        _ => return None,
    })
}

pub(crate) fn is_greek(c: char) -> bool {
    ('α'..='ω').contains(&c) || ('Α'..='Ω').contains(&c) || c == 'ℏ'
}

/// The unit vector at the start, as the number of its axis, and how many characters it is.
fn basis(signs: &[SourceChar]) -> Option<(u8, usize)> {
    let hat = signs.get(1).is_some_and(|next| next.c == '\u{302}');
    Some(match (signs.first()?.c, hat) {
        ('î', _) => (1, 1),
        ('ĵ', _) | ('ŷ', _) => (2, 1),
        ('ẑ', _) => (3, 1),
        ('i' | 'x', true) => (1, 2),
        ('j' | 'y', true) => (2, 2),
        ('k' | 'z', true) => (3, 2),
        _ => return None,
    })
}

/// The length of a number such as `0x1F` at the start.
fn hexadecimal(signs: &[SourceChar]) -> Option<usize> {
    let marked = signs.first()?.c == '0' && signs.get(1)?.c == 'x' && signs.get(2)?.c.is_ascii_hexdigit();
    marked.then(|| 2 + signs[2..].iter().take_while(|sign| sign.c.is_ascii_hexdigit()).count())
}

fn in_word(c: char) -> bool {
    c.is_ascii_alphabetic() || is_greek(c) || matches!(c, 'Å' | 'ℓ') || (c.is_alphabetic() && !c.is_ascii())
}

/// Whether a sign joins a number and a word to one word: 3-day.
fn is_hyphen(signs: &[SourceChar], before: Option<&Token>) -> bool {
    /// Letters from which on it is a word, and no unit or quantity.
    const SHORTEST: usize = 3;
    let word: String = signs[1..].iter().map(|sign| sign.c).take_while(char::is_ascii_alphabetic).collect();
    before.is_some_and(|before| before.number().is_some() && before.span.end == signs[0].span.start)
        && word.len() >= SHORTEST
        && word.chars().all(|c| c.is_ascii_lowercase())
        && MathFunction::from_name(&word).is_none()
}

/// Reads running text. What it makes of a word is a unit or prose, never a letter of a formula, except Greek ones.
pub(crate) fn tokenise_words(signs: &[SourceChar], out: &mut Vec<Token>) {
    let signs = plain_chars(signs);
    let mut at = 0;
    while let Some(&SourceChar { c, span }) = signs.get(at) {
        let rest = &signs[at..];
        let length = number_length(rest);
        if let Some(length) = hexadecimal(rest) {
            out.push(Token::new(TokenKind::Unknown("a hexadecimal number".to_owned()), span_of_chars(&rest[..length])));
            at += length;
            continue;
        }
        if length > 0 {
            out.push(number(&rest[..length]));
            at += length;
            continue;
        }
        let run = |is: &dyn Fn(char) -> bool| rest.iter().take_while(|sign| is(sign.c)).count().max(1);
        let mut taken = 1;
        if let Some((axis, length)) = basis(rest) {
            taken = length;
            out.push(Token::new(TokenKind::Basis(axis), span_of_chars(&rest[..length])));
        } else if in_word(c) {
            let all = run(&in_word);
            taken = (1..all).find(|at| basis(&rest[*at..]).is_some()).unwrap_or(all);
            let letter = |sign: &SourceChar| sign.c.is_ascii_alphabetic();
            let digits = rest[taken..].iter().take_while(|sign| sign.c.is_ascii_digit()).count();
            let longer = rest[taken + digits..].iter().take_while(|sign| letter(sign)).count();
            if digits > 0 && taken > 1 && longer > 1 {
                taken += digits + longer;
                out.push(Token::new(
                    TokenKind::Unknown("a name with digits in it".to_owned()),
                    span_of_chars(&rest[..taken]),
                ));
            } else {
                word(&rest[..taken], out);
                taken += typed(&rest[taken..], out);
            }
        } else if c.is_whitespace() {
            taken = run(&char::is_whitespace);
            out.push(Token::new(TokenKind::Space(2), span_of_chars(&rest[..taken])));
        } else if c == '°' {
            let scale = rest.get(1).filter(|next| "CF".contains(next.c));
            let ends = rest.get(2).is_none_or(|after| !after.c.is_ascii_lowercase());
            match scale.filter(|_| ends) {
                Some(next) => {
                    taken = 2;
                    out.push(Token::new(TokenKind::Word(format!("°{}", next.c)), span.join(next.span)));
                }
                None => out.push(Token::new(TokenKind::Word("°".to_owned()), span)),
            }
        } else if c == '%' || is_currency_sign(c) {
            out.push(Token::new(TokenKind::Word(c.to_string()), span));
        } else if superscript_char(c).is_some() {
            taken = run(&|c| superscript_char(c).is_some());
            let signs: Vec<SourceChar> = rest[..taken]
                .iter()
                .filter_map(|sign| superscript_char(sign.c).map(|c| SourceChar { c, ..*sign }))
                .collect();
            let mut exponent = Vec::new();
            tokenise_words(&signs, &mut exponent);
            out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), exponent), span_of_chars(&signs)));
        } else if let Some((above, below)) = vulgar(c) {
            let part = |text: &str| vec![Token::new(TokenKind::Number(text.to_owned()), span)];
            out.push(Token::new(TokenKind::Fraction(part(above), part(below)), span));
        } else if c == '…' || rest.iter().take(3).filter(|sign| sign.c == '.').count() == 3 {
            taken = if c == '…' { 1 } else { 3 };
            out.push(Token::new(TokenKind::Unknown("…".to_owned()), span_of_chars(&rest[..taken])));
        } else if c == '-' && is_hyphen(rest, out.last()) {
            out.push(Token::new(TokenKind::Unknown("a number in a word".to_owned()), span));
        } else {
            out.push(Token::new(TokenKind::Operator(c), span));
        }
        at += taken;
    }
}

/// What is typed behind the name of a function: the base in `log2(8)`, or the exponent in `cos2(60)` and `sin-1(0.5)`. How many characters
/// it is.
fn typed(rest: &[SourceChar], out: &mut Vec<Token>) -> usize {
    let Some(Token { kind: TokenKind::Function(function), .. }) = out.last_mut() else { return 0 };
    let minus = usize::from(rest.first().is_some_and(|sign| sign.c == '-'));
    let digits: String = rest[minus..].iter().map(|sign| sign.c).take_while(char::is_ascii_digit).collect();
    let taken = minus + digits.len();
    if rest.get(taken).is_none_or(|sign| sign.c != '(') {
        return 0;
    }
    match (*function, minus, digits.as_str()) {
        (MathFunction::Log, 0, "2") => *function = MathFunction::LogTo(2),
        (MathFunction::Log, 0, "10") => *function = MathFunction::Lg,
        (_, 0, "2") | (_, 1, "1") => {
            let exponent =
                if minus == 1 { vec![Token::new(TokenKind::Operator('-'), rest[0].span)] } else { Vec::new() };
            let exponent = exponent.into_iter().chain([number(&rest[minus..taken])]).collect();
            out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), exponent), span_of_chars(&rest[..taken])));
        }
        _ => return 0,
    }
    taken
}

fn word(signs: &[SourceChar], out: &mut Vec<Token>) {
    let text: String = signs.iter().map(|sign| sign.c).collect();
    let span = span_of_chars(signs);
    let subscript: String = signs.iter().filter_map(|sign| subscript_char(sign.c)).collect();
    let kind = if !subscript.is_empty() {
        let base: String = signs.iter().map(|sign| sign.c).filter(|c| subscript_char(*c).is_none()).collect();
        TokenKind::Name(format!("{base}_{subscript}"))
    } else if text == "Log" {
        TokenKind::Function(MathFunction::Log)
    } else if let Some(function) = MathFunction::from_name(&text)
        .filter(|function| *function != MathFunction::Sec && !(function.takes_list() && text.starts_with('m')))
    {
        TokenKind::Function(function)
    } else {
        let mut letters = text.chars();
        match (letters.next(), letters.next()) {
            (Some(c), None) if is_greek(c) && c != 'Ω' && c != 'μ' => TokenKind::Name(text),
            _ => TokenKind::Word(text),
        }
    };
    out.push(Token::new(kind, span));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::{show, signs};

    fn read(text: &str) -> Vec<Token> {
        let mut out = Vec::new();
        tokenise_words(&signs(text, 0), &mut out);
        out
    }

    #[test]
    fn numbers_keep_their_commas_and_leave_a_full_stop() {
        for (text, length) in
            [("1,234.5 m", 7), ("12,34", 2), ("3.", 1), (".5", 2), ("1,2345", 1), ("0,123", 1), ("x", 0)]
        {
            assert_eq!(number_length(&signs(text, 0)), length, "{text}");
        }
    }

    #[test]
    fn every_token_knows_its_bytes() {
        let text = "9.8 m/s² − 20 °C";
        for token in read(text) {
            assert!(text.get(token.span.range()).is_some(), "{token:?}");
        }
        assert_eq!(show(&read(text)), "9.8 m/s^2 − 20 °C");
        assert_eq!(&text[read(text)[4].span.range()], "s");
    }
}
