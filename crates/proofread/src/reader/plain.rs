//! Lines of plain text with an equals sign, as they come out of a PDF or are typed in a mail.

use super::tags::decode_entities;
use super::words::tokenise_words;
use super::{Formula, FormulaSink, FormulaStyle};
use crate::token::{MathFunction, SourceChar, Span, TOO_LONG, Token, TokenKind, signs};
use crate::unit::{currency, is_percent, joins_share, unit};
use std::ops::Range;

/// Longest line that is read, in bytes.
const LONGEST: usize = 4000;

/// Finds the formulas in lines outside the stretches to skip, which are in their order.
pub(crate) fn read(text: &str, skip: &[Range<usize>], each: &mut FormulaSink<'_>) {
    let mut skipped = skip.iter().peekable();
    let mut start = 0;
    let mut has_open_tables = None;
    let mut lines = text.split_inclusive('\n').peekable();
    while let Some(line) = lines.next() {
        let mut whole = start..start + line.len();
        while skipped.next_if(|range| range.end <= whole.start).is_some() {}
        // A chain that goes on in the next line.
        let next_skipped = skipped.peek().map_or(text.len(), |range| range.start);
        while let Some(next) = lines.next_if(|next| {
            let end = whole.end + next.len();
            end <= next_skipped && end - whole.start <= LONGEST && goes_on_in(&text[whole.clone()], next)
        }) {
            whole.end += next.len();
        }
        start = whole.end;
        let line = &text[whole.clone()];
        // What is between the stretches to skip.
        let mut from = whole.start;
        let mut pieces = Vec::new();
        while let Some(range) = skipped.peek()
            && range.start < whole.end
        {
            if range.start > from {
                pieces.push(from..range.start);
            }
            from = from.max(range.end);
            if range.end > whole.end {
                break;
            }
            skipped.next();
        }
        if from < whole.end {
            pieces.push(from..whole.end);
        }
        let is_tabbed = is_row_of_equations(line);
        let is_spaced = is_row_of_spaced_equations(line);
        let is_row = is_tabbed
            || is_spaced
            || is_row_of_table(line)
            || (line.contains(" | ") && *has_open_tables.get_or_insert_with(|| has_open_table(text)));
        if is_spaced {
            pieces = pieces.into_iter().flat_map(|piece| spaced_cells(text, piece)).collect();
        } else if is_row {
            let mark = if is_tabbed { '\t' } else { '|' };
            pieces = pieces.into_iter().flat_map(|piece| cells(text, piece, mark)).collect();
        }
        for piece in pieces {
            let part = &text[piece.clone()];
            let ends_line = is_row || piece.end == whole.end;
            if !part.contains('=') || !part.contains(|c: char| c.is_ascii_digit()) {
                continue;
            }
            if part.len() > LONGEST {
                let span = Span::new(piece.start, piece.end);
                let unread = Token::new(TokenKind::Unknown(TOO_LONG.to_owned()), span);
                each(Formula { style: FormulaStyle::Plain, ..Formula::new(vec![unread], span) });
            } else {
                line_of(part, piece.start, piece.start == whole.start, &mut |mut formula| {
                    formula.continues = !is_row && piece.start > whole.start && touches(formula.tokens.iter());
                    formula.goes_on = !ends_line && touches(formula.tokens.iter().rev());
                    each(formula);
                });
            }
        }
    }
}

/// Whether a chain at the end of a full line goes on in the next line, since a sign of a sum, a product or an equation stands at the break.
fn goes_on_in(line: &str, next: &str) -> bool {
    /// Characters from which on a line is full: pieces of a formula in lines of their own are shorter.
    const FULL: usize = 30;
    const BREAKS: [char; 9] = ['=', '≈', '+', '×', '·', '−', '/', '*', 'x'];
    let (line, next) = (line.trim(), next.trim());
    let last = line.rsplit('\n').next().unwrap_or(line);
    let is_full = last.chars().count() >= FULL && next.split_whitespace().nth(1).is_some();
    let is_text = |of: &str| !of.contains('|') && !of.starts_with(['#', '>', '<', '`', '~', ':', '+', '-', '*']);
    let ends = last.strip_suffix(BREAKS).is_some_and(|rest| {
        let before =
            |c: char| c.is_ascii_digit() || "%°²³)".contains(c) || (!last.ends_with('x') && c.is_alphanumeric());
        rest.ends_with(' ') && rest.trim_end().ends_with(before)
    });
    let begins = next.strip_prefix(['=', '≈', '×', '·']).is_some_and(|rest| rest.starts_with(' '));
    let has_digit = |of: &str| of.contains(|c: char| c.is_ascii_digit());
    let ends = ends && next.starts_with(|c: char| c.is_ascii_digit() || "(√".contains(c));
    is_full && is_text(last) && is_text(next) && has_digit(last) && has_digit(next) && (ends || begins)
}

/// Whether a line is a row of a table in Markdown, with a sign at both ends and between its cells.
fn is_row_of_table(line: &str) -> bool {
    let row = line.trim();
    row.starts_with('|') && row.ends_with('|') && row.matches('|').count() > 2
}

/// Whether a text has a table in Markdown without signs at the ends of its rows: below its head is a line of dashes with signs between them.
fn has_open_table(text: &str) -> bool {
    text.lines().any(|line| {
        let line = line.trim();
        line.contains("--") && line.contains('|') && line.chars().all(|c| "-:| \t".contains(c))
    })
}

/// Whether tabs part several whole equations in a line.
fn is_row_of_equations(line: &str) -> bool {
    let mut pieces = line.split('\t').map(str::trim).filter(|piece| piece.contains('='));
    let is_whole = |piece: &str| !piece.starts_with(['=', '+', '*', '/']) && !piece.ends_with(['=', '+', '*', '/']);
    line.contains('\t') && pieces.clone().count() > 1 && pieces.all(is_whole)
}

/// The blanks that part two equations in a line.
const GAP: &str = "    ";

/// Whether several blanks part whole equations in a line, each with digits on both sides.
fn is_row_of_spaced_equations(line: &str) -> bool {
    let line = line.trim();
    let has_digit = |of: &str| of.contains(|c: char| c.is_ascii_digit());
    let is_whole = |piece: &str| {
        let piece = piece.trim();
        piece.split_once('=').is_some_and(|(left, right)| has_digit(left) && has_digit(right))
            && !piece.ends_with(['=', '+', '*', '/', ','])
    };
    line.contains(GAP) && line.split(GAP).all(|piece| piece.trim().is_empty() || is_whole(piece))
}

/// The pieces between such blanks.
fn spaced_cells(text: &str, row: Range<usize>) -> Vec<Range<usize>> {
    let (mut start, mut out) = (row.start, Vec::new());
    for cell in text[row].split(GAP) {
        out.push(start..start + cell.len());
        start += cell.len() + GAP.len();
    }
    out
}

/// The cells of a row, or of a part of it.
fn cells(text: &str, row: Range<usize>, mark: char) -> Vec<Range<usize>> {
    let mut start = row.start;
    let mut out = Vec::new();
    for cell in text[row].split(mark) {
        out.push(start..start + cell.len());
        start += cell.len() + 1;
    }
    out
}

/// Whether a side runs up to the edge of a piece, behind which another formula is, so that it may not be all of a side.
fn touches<'t>(from_edge: impl Iterator<Item = &'t Token>) -> bool {
    let side: Vec<&Token> = from_edge.take_while(|token| !token.is_one_of("=≈")).collect();
    let words = |token: &&&Token| token.is_one_of(";|.,:") || matches!(token.kind, TokenKind::Name(_));
    side.iter().any(|token| !token.is_space()) && !side.iter().any(|token| words(&token))
}

fn is_code(line: &str) -> bool {
    ["==", "!=", "<=", ">=", ":=", "=>", "+=", "-=", "|=", "=\"", "='", "();"].iter().any(|sign| line.contains(sign))
}

/// Whether code in a line of text is nothing but arithmetic: `7 * 6 = 42`, but not `i = 0`, `7 // 2 = 3` or `1010 + 1 = 1011`.
pub(super) fn is_arithmetic(code: &str) -> bool {
    /// Most digits behind a point; a program that prints more shows what floating point is like.
    const MOST_DECIMALS: usize = 10;
    let is_sign = |c: char| c.is_ascii_digit() || " .,=()+-−*/×·÷≈".contains(c);
    let numbers = || code.split(|c: char| !c.is_ascii_digit() && !matches!(c, '.' | ',')).filter(|of| !of.is_empty());
    let has_leading_zero = |of: &str| of.len() > 1 && of.starts_with('0') && !of.starts_with("0.");
    let is_binary = |of: &str| of.chars().all(|c| matches!(c, '0' | '1'));
    let decimals = |of: &str| of.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let computes =
        code.contains(['+', '*', '×', '·', '÷', '−']) || code.trim_start_matches([' ', '-']).contains(['-', '/']);
    code.contains('=')
        && computes
        && code.chars().all(is_sign)
        && !is_code(code)
        && !code.contains("//")
        && !numbers().any(|of| has_leading_zero(of) || decimals(of) > MOST_DECIMALS)
        && !(numbers().all(is_binary) && numbers().any(|of| of.len() > 2))
}

/// Reads code in a line of text that is nothing but arithmetic.
pub(super) fn read_code(code: &str, base: usize, each: &mut FormulaSink<'_>) {
    line_of(code, base, false, each);
}

/// Reads a line, or the piece of one that `starts` it or does not.
fn line_of(line: &str, base: usize, starts: bool, each: &mut FormulaSink<'_>) {
    if is_code(line) {
        return;
    }
    let marked = if starts { bullet(line) } else { 0 };
    let (line, base) = (&line[marked..], base + marked);
    let numbered = numbered(line);
    let (line, base) = (&line[numbered..], base + numbered);
    let mut tokens = Vec::new();
    tokenise_words(&shown_signs(line, base), &mut tokens);
    let tokens = interpret_line(tokens);
    let span = Span::new(base, base + line.trim_end().len());
    let mut formula = Formula::new(tokens, span);
    formula.style = FormulaStyle::Plain;
    each(formula);
}

/// The characters of a line as they are shown: without tags that only set them off, with entities as what they stand for, and with raised
/// and lowered characters behind their signs.
fn shown_signs(line: &str, base: usize) -> Vec<SourceChar> {
    const SET_OFF: [&str; 11] = ["b", "strong", "i", "em", "u", "span", "font", "small", "big", "mark", "ins"];
    let decoded = if line.contains('&') { decode_entities(line, base) } else { signs(line, base) };
    let decoded = if line.contains("](") { without_link_marks(&decoded) } else { decoded };
    if !line.contains('<') {
        return decoded;
    }
    let mut out = Vec::with_capacity(decoded.len());
    let mut at = 0;
    while let Some(sign) = decoded.get(at) {
        let end = (sign.c == '<').then(|| decoded[at..].iter().take(80).position(|sign| sign.c == '>')).flatten();
        let inner: String =
            end.map(|end| decoded[at + 1..at + end].iter().map(|sign| sign.c).collect()).unwrap_or_default();
        let (closes, name) = inner.strip_prefix('/').map_or((false, inner.as_str()), |name| (true, name));
        let name = name.split(char::is_whitespace).next().unwrap_or_default().to_ascii_lowercase();
        let script: &[char] = match (name.as_str(), closes) {
            ("sup", false) => &['^', '('],
            ("sub", false) => &['_', '('],
            ("sup" | "sub", true) => &[')'],
            (name, _) if SET_OFF.contains(&name) => &[],
            _ => {
                out.push(*sign);
                at += 1;
                continue;
            }
        };
        out.extend(script.iter().map(|c| SourceChar { c: *c, span: sign.span }));
        at += end.unwrap_or(0) + 1;
    }
    out
}

/// The characters of a line without the marks of its links and images in Markdown, `[` and `](address)`.
fn without_link_marks(signs: &[SourceChar]) -> Vec<SourceChar> {
    let (mut out, mut open): (Vec<SourceChar>, Vec<usize>) = (Vec::with_capacity(signs.len()), Vec::new());
    let mut at = 0;
    while let Some(sign) = signs.get(at) {
        let is_next = |c: char| signs.get(at + 1).is_some_and(|next| next.c == c);
        match sign.c {
            '[' => open.push(out.len()),
            ']' => {
                let from = open.pop();
                let end = signs[at..].iter().position(|sign| sign.c == ')').filter(|_| is_next('('));
                // What is in the brackets is no factor.
                let is_address = |end: &usize| {
                    let inside = &signs[at + 2..at + end];
                    inside.iter().any(|sign| sign.c.is_alphabetic() || "#/".contains(sign.c))
                };
                if let (Some(from), Some(end)) = (from, end.filter(is_address)) {
                    out.remove(from);
                    if from.checked_sub(1).is_some_and(|mark| out[mark].c == '!') {
                        out.remove(from - 1);
                    }
                    at += end + 1;
                    continue;
                }
            }
            _ => {}
        }
        out.push(*sign);
        at += 1;
    }
    out
}

/// The bytes of the marks of a list or a quotation before a line, as in `- 4 + 4 = 8`.
fn bullet(line: &str) -> usize {
    let mut rest = line.trim_start();
    while let Some(behind) = ["- ", "* ", "+ ", "> ", "• ", "– "].iter().find_map(|mark| rest.strip_prefix(mark)) {
        rest = behind.trim_start();
    }
    line.len() - rest.len()
}

/// The bytes of a number or letter with a bracket or a point before a line, as in `2) 4 + 4 = 8` or `2. 4 + 4 = 8`.
fn numbered(line: &str) -> usize {
    let rest = line.trim_start().trim_start_matches('(');
    let length = rest.chars().take_while(char::is_ascii_alphanumeric).count();
    let label = rest.get(..length).unwrap_or_default();
    let short = (1..=2).contains(&length) && (length == 1 || label.chars().all(|c| c.is_ascii_digit()));
    let closes = rest[length..].starts_with(") ") || rest[length..].starts_with(". ");
    if short && closes { line.len() - rest.len() + length + 1 } else { 0 }
}

/// Words between formulas that look like units.
const PROSE: [&str; 12] = ["a", "in", "at", "as", "A", "I", "min", "per", "t", "d", "e", "u"];

/// Words that may stand behind a result without belonging to it.
const BEHIND: &str = " a after also an and are as at because before but by can does exactly for from gives has have hence here if in is \
    it its may must not now of on only or our per should since so than that the then there therefore this thus to true was we \
    what when where which while will with without wrong would yet you correct incorrect false approximately about means shows \
    yields holds ";

/// Whether a word may be what is counted, and not one of those that go on with a sentence.
pub(crate) fn is_noun(word: &str) -> bool {
    word.len() > 2 && !BEHIND.split_ascii_whitespace().any(|known| known.eq_ignore_ascii_case(word))
}

/// Whether what stands last takes an exponent: a ten, or a unit behind a number or another unit.
fn lost_its_exponent(out: &[Token]) -> bool {
    match out.last() {
        Some(Token { kind: TokenKind::Number(text), .. }) => text == "10",
        Some(Token { kind: TokenKind::Word(word), .. }) => unit(word).is_some(),
        _ => false,
    }
}

/// Whether what follows a minus sign makes an arrow of it.
fn is_arrow(mut rest: impl Iterator<Item = Token>) -> bool {
    rest.find(|token| !token.is_sign('-')).is_some_and(|token| token.is_sign('>'))
}

/// Whether the number ahead may be the exponent of a unit before it: one digit, behind which no unit is, as in s-1 but not in 35cm-10cm.
fn is_exponent(out: &[Token], mut ahead: impl Iterator<Item = Token>) -> bool {
    let of_unit = out.last().is_some_and(|last| last.word().is_some());
    let digits = ahead.next();
    let short = digits.as_ref().and_then(Token::number).is_some_and(|digits| digits.len() == 1);
    let unit_behind = ahead.next().is_some_and(|next| next.word().is_some_and(|word| unit(word).is_some()));
    !of_unit || (short && !unit_behind)
}

/// Whether a numbered x stands at the left of an equals sign and behind no number: x1 = 70.
fn names_numbered_x(tokens: &[Token]) -> bool {
    let mut solid = tokens.iter().filter(|token| !token.is_space());
    let mut before: Option<&Token> = None;
    while let Some(token) = solid.next() {
        let mut behind = solid.clone();
        let (digit, sign) = (behind.next(), behind.next());
        let touches = digit.is_some_and(|digit| digit.number().is_some() && digit.span.start == token.span.end);
        let free = before.is_none_or(|before| before.number().is_none());
        if token.word() == Some("x") && touches && free && sign.is_some_and(|sign| sign.is_sign('=')) {
            return true;
        }
        before = Some(token);
    }
    false
}

/// Makes letters, exponents, products and separators of what running text writes with words and signs.
fn interpret_line(tokens: Vec<Token>) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::new();
    // Whether any unit is on the line that is nothing else.
    let has_units = tokens.iter().filter_map(Token::word).any(|word| unit(word).is_some() && !PROSE.contains(&word));
    let behind_number = |of: &[Token]| match of {
        [Token { kind: TokenKind::Number(_), .. }, space, Token { kind: TokenKind::Word(word), .. }]
            if space.is_space() =>
        {
            Some(word.clone())
        }
        _ => None,
    };
    let behind_numbers: Vec<String> = tokens.windows(3).filter_map(behind_number).collect();
    let names_x = names_numbered_x(&tokens);
    let mut rest = tokens.into_iter().peekable();
    while let Some(token) = rest.next() {
        let next_is = |is: &dyn Fn(&Token) -> bool, rest: &mut std::iter::Peekable<std::vec::IntoIter<Token>>| {
            rest.peek().is_some_and(is)
        };
        let span = token.span;
        match token.kind.clone() {
            TokenKind::Operator('^') => {
                let mut exponent = Vec::new();
                // With blanks around it, the sign is that of a program, but for a power of ten: 10 ^ -24.
                let solid = out.iter().rposition(|token| !token.is_space());
                if let Some(ten) = solid.filter(|at| out[*at].number() == Some("10")) {
                    out.truncate(ten + 1);
                    while rest.next_if(Token::is_space).is_some() {}
                }
                let signed = next_is(&|next| next.is_one_of("+-"), &mut rest);
                exponent.extend(rest.next_if(|_| signed));
                if let Some(open) = rest.next_if(|next| next.is_one_of("({")) {
                    let mut depth = 1usize;
                    for inner in rest.by_ref() {
                        depth += usize::from(inner.is_one_of("({"));
                        depth -= usize::from(inner.is_one_of(")}"));
                        if depth == 0 {
                            break;
                        }
                        exponent.push(inner);
                    }
                    let _ = open;
                } else {
                    exponent.extend(rest.next_if(|next| !next.is_space()));
                }
                out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), exponent), span));
            }
            TokenKind::Operator('*') => {
                if let Some(second) = rest.next_if(|next| next.is_sign('*')) {
                    // A power as in a program, 2.0**3, or a mark of bold text.
                    let of = out.last().is_some_and(|last| {
                        last.span.end == span.start
                            && (last.number().is_some() || last.is_sign(')') || matches!(last.kind, TokenKind::Name(_)))
                    });
                    let sign = rest.next_if(|next| of && next.is_sign('-') && next.span.start == second.span.end);
                    let from = sign.as_ref().map_or(second.span.end, |sign| sign.span.end);
                    let raised = rest.next_if(|next| of && next.number().is_some() && next.span.start == from);
                    let mut exponent: Vec<Token> = sign.into_iter().chain(raised).collect();
                    if exponent.is_empty()
                        && rest.next_if(|next| of && next.is_sign('(') && next.span.start == from).is_some()
                    {
                        exponent.extend(rest.by_ref().take_while(|next| !next.is_sign(')')));
                    }
                    if !exponent.is_empty() {
                        out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), exponent), span));
                    }
                    continue;
                }
                out.push(Token::new(TokenKind::Operator('·'), span));
            }
            TokenKind::Word(word) => {
                let before = out.iter().rev().find(|token| !token.is_space());
                let touching = out.last().is_some_and(|last| !last.is_space());
                let follows_number = before.is_some_and(|token| matches!(token.kind, TokenKind::Number(_)));
                let follows_unit = before.is_some_and(|token| match &token.kind {
                    TokenKind::Number(_) => true,
                    TokenKind::Word(word) => unit(word).is_some(),
                    TokenKind::Scripts(..) | TokenKind::Basis(_) => true,
                    TokenKind::Operator(c) => ")]/·".contains(*c),
                    _ => false,
                });
                // 1.5e-3
                let exponent = touching && follows_number && matches!(word.as_str(), "e" | "E");
                let ahead: Vec<Token> = rest.clone().take(2).collect();
                let sign = usize::from(ahead.first().is_some_and(|token| token.is_one_of("+-")));
                let power =
                    ahead.get(sign).filter(|token| token.number().is_some_and(|text| !text.contains(['.', ','])));
                if let Some(power) = power.filter(|power| exponent && power.span.start <= span.end + 1) {
                    let raised: Vec<Token> = ahead[..sign].iter().chain([power]).cloned().collect();
                    out.push(Token::new(TokenKind::Operator('×'), span));
                    out.push(Token::new(TokenKind::Number("10".to_owned()), span));
                    out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), raised), span));
                    rest.nth(sign);
                    continue;
                }
                let mut after = rest.clone().skip_while(Token::is_space);
                let next = after.next();
                let before_number =
                    next.as_ref().is_some_and(|next| matches!(next.kind, TokenKind::Number(_)) || next.is_sign('('));
                // Beside an x1, the second of 70   x2 = 0 is a name.
                let is_second_name = names_x && !touching && rest.peek().is_some_and(|next| !next.is_space());
                if word == "x" && follows_unit && before_number && !is_second_name {
                    out.push(Token::new(TokenKind::Operator('×'), span));
                    continue;
                }
                let calls = rest.peek().is_some_and(|next| next.is_sign('('));
                let single = word.chars().count() == 1;
                let before_word = next.as_ref().is_some_and(|next| next.word().is_some());
                let letter = single && !(before_word && PROSE.contains(&word.as_str()));
                let before_equals = next.as_ref().is_some_and(|next| next.is_sign('='));
                // 5 A, but not: 5 A block slides.
                let closes = match word.as_str() {
                    "min" => true,
                    "A" | "u" | "in" | "e" if !before_word => {
                        let doubtful = word == "e" || (word != "in" && before_equals);
                        let repeated = behind_numbers.iter().filter(|of| **of == word).count() > 1;
                        has_units || repeated || !doubtful
                    }
                    _ => false,
                };
                // 2 % of 50
                let counted = before.is_some_and(|before| before.number().is_some() || before.is_sign(')'));
                let percent = before.and_then(Token::word).is_some_and(is_percent);
                let before_price = next.as_ref().and_then(Token::word).is_some_and(|sign| currency(sign).is_some());
                let of_numbers = (counted && before_number) || (percent && (before_number || before_price));
                let power_of_e = word == "e" && rest.peek().is_some_and(|next| next.is_sign('^'));
                // 348Tc is a product with a letter.
                let glued = touching && follows_number && unit(&word).is_none() && word.chars().count() < 4;
                let named = letter || glued || ((before_equals || calls) && !follows_unit);
                // A column of mercury: 760 mm Hg.
                let is_column =
                    word == "Hg" && before.and_then(Token::word).is_some_and(|of| matches!(of, "mm" | "cm" | "in"));
                let kind = if power_of_e {
                    TokenKind::Name(word)
                } else if word == "pi" {
                    TokenKind::Name("π".to_owned())
                } else if word == "sqrt" {
                    TokenKind::Operator('√')
                } else if let Some(function) =
                    MathFunction::from_name(&word).filter(|_| word != "sec" && (calls || !word.starts_with('m')))
                {
                    TokenKind::Function(function)
                } else if is_column
                    || (before_number && currency(&word).is_some())
                    || (follows_unit
                        && unit(&word).is_some()
                        && (touching || closes || !PROSE.contains(&word.as_str())))
                {
                    TokenKind::Word(word)
                } else if named {
                    TokenKind::Name(word)
                } else if of_numbers && (word == "of" || (percent && joins_share(&word))) {
                    TokenKind::Word(word)
                } else if word == "mod" {
                    // The modulus alone says how the whole line is meant.
                    if (counted || follows_number) && before_number {
                        TokenKind::Word(word)
                    } else {
                        TokenKind::Unknown(word)
                    }
                } else if before.is_some_and(|of| of.number().is_some() || (of.is_sign(')') && before_equals))
                    && is_noun(&word)
                {
                    // What is counted has no unit that is known.
                    TokenKind::Word(word)
                } else {
                    // Prose, or a unit that is not known.
                    TokenKind::Operator(';')
                };
                out.push(Token::new(kind, span));
            }
            // An exponent that is not raised any more: m/s2.
            TokenKind::Number(ref digits)
                if matches!(digits.as_str(), "2" | "3")
                    && out.last().is_some_and(|last| {
                        last.span.end == span.start
                            && last.word().is_some_and(|word| unit(word).is_some() && word != "e")
                    }) =>
            {
                out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), vec![token.clone()]), span));
            }
            // Another column of a text that is set in columns.
            TokenKind::Space(_)
                if span.end - span.start >= 4
                    && next_is(&|next| next.is_one_of("=("), &mut rest)
                    && out.iter().any(|token| token.is_sign('=')) =>
            {
                out.push(Token::new(TokenKind::Operator(';'), span));
            }
            // An arrow between two states: 4.6 -> 1.8.
            TokenKind::Operator('-') if is_arrow(rest.clone()) => {
                while rest.next_if(|next| next.is_sign('-')).is_some() {}
                rest.next();
                out.push(Token::new(TokenKind::Operator('→'), span));
            }
            // Exponents that are not raised any more: 10-3 and s-1.
            TokenKind::Operator('-')
                if next_is(&|next| next.number().is_some() && next.span.start == span.end, &mut rest)
                    && is_exponent(&out, rest.clone())
                    && out.last().is_some_and(|last| last.span.end == span.start)
                    && lost_its_exponent(&out) =>
            {
                let times = out.iter().rev().skip(1).find(|token| !token.is_space()).is_some_and(|of| of.is_sign('×'));
                let ten = out.last().is_some_and(|last| last.number().is_some());
                if times || !ten {
                    let mut raised = vec![Token::new(TokenKind::Operator('-'), span)];
                    raised.extend(rest.next());
                    out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), raised), span));
                } else {
                    out.push(Token::new(TokenKind::Unknown("ten to a power, or a difference".to_owned()), span));
                }
            }
            // In running text, space parts two numbers.
            TokenKind::Space(_) if next_is(&|next| next.number().is_some(), &mut rest) => {
                let number = out.last().is_some_and(|last| last.number().is_some());
                out.push(Token::new(TokenKind::Space(if number { 6 } else { 2 }), span));
            }
            kind => out.push(Token::new(kind, span)),
        }
    }
    out
}
