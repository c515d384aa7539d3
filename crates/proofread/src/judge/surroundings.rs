//! What the text around a formula says about it.

use crate::decimal::parse_decimal;
use crate::effort;
use crate::evaluate::atom::large_number;
use crate::join::chain::ChainSide;
use crate::join::token_joining::join_tokens;
use crate::reader::{is_noun, tokenise_text, unit_sign};
use crate::token::{Span, Token, TokenKind};
use crate::unit::unit;

/// Most bytes of text that are looked at on each side.
const NEAR: usize = 160;

pub(crate) fn text_around(text: &str, span: Span) -> (String, String) {
    let range = span.range();
    let bound = |mut at: usize| {
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let start = bound(range.start.min(text.len()));
    let end = bound(range.end.clamp(start, text.len()));
    let before = &text[bound(start.saturating_sub(NEAR))..start];
    let after = &text[end..bound((end + NEAR).min(text.len()))];
    effort::count_steps(before.len() + after.len());
    (without_tags(before), without_tags(after))
}

/// The part of a stretch that is at most 600 bytes from a place in it: of a long formula with many equations, what is near one.
pub(super) fn part_near(text: &str, whole: Span, place: Span) -> Span {
    let (from, to) = ((place.start as usize).saturating_sub(600), (place.end as usize).saturating_add(600));
    let (from, to) = (text.ceil_char_boundary(from), text.floor_char_boundary(to));
    Span::new(from.max(whole.start as usize), to.min(whole.end as usize).max(whole.start as usize))
}

/// Most bytes in which a text names what a whole example is about.
const EXAMPLE: usize = 1500;

/// The text of the example so far, up to a place, with its marks.
pub(crate) fn text_before(text: &str, span: Span) -> &str {
    let end = (span.start as usize).min(text.len());
    let before = text.get(text.ceil_char_boundary(end.saturating_sub(EXAMPLE))..end).unwrap_or_default();
    // A search takes less than reading.
    effort::count_steps(before.len() / 32);
    before
}

/// Most places where a name is called that are looked at.
pub(crate) const MOST_CALLS: usize = 20;

/// Whether a side calls P or C as a function of two numbers, and the text before it as one of two letters, as in P(x, y): then it is no
/// number of choices such as P(n, k).
pub(crate) fn calls_function(text: &str, side: Span) -> bool {
    let source = text.get(side.range()).unwrap_or_default().trim_start();
    let Some(call) = ["P(", "C("].into_iter().find(|call| source.starts_with(call)) else { return false };
    let before = text_before(text, side);
    let mut calls =
        before.match_indices(call).take(MOST_CALLS).filter_map(|(at, _)| before[at + call.len()..].split_once(')'));
    calls.any(|(arguments, _)| match arguments.split_once(',').map(|(one, other)| [one.trim(), other.trim()]) {
        Some([one, other]) => {
            let is_letter = |of: &str| of.len() == 1 && of.starts_with(|c: char| c.is_ascii_alphabetic());
            is_letter(one) && is_letter(other) && !matches!(one, "n" | "N" | "m")
        }
        None => false,
    })
}

pub(super) fn without_tags(text: &str) -> String {
    effort::count_steps(text.len() / 8);
    let mut out = String::with_capacity(text.len());
    let mut inside = false;
    // A tag that is cut off at the start is none of the text.
    let text = match (text.find('>'), text.find('<')) {
        (Some(close), open) if open.is_none_or(|open| close < open) && text[..close].contains(['"', '/', ':']) => {
            &text[close + 1..]
        }
        _ => text,
    };
    for c in text.chars() {
        match c {
            '<' => inside = true,
            '>' if inside => inside = false,
            c if !inside => out.push(c),
            _ => {}
        }
    }
    out
}

/// Whether the text of the example so far, or just behind a formula, speaks of groups and their elements.
pub(crate) fn speaks_of_groups(text: &str, span: Span) -> bool {
    example_speaks_of(
        text,
        span,
        &[
            "group",
            "cyclic",
            "generator",
            "the order",
            "has order",
            "order of",
            "mathbb{z}/",
            "mathbb z/",
            "\\mathbb{z}_",
            "abstract algebra",
            "isomorphi",
            "homomorphi",
        ],
    )
}

/// Whether the text has a function for the integers next to a number, or that of the example so far speaks of such integers.
pub(crate) fn speaks_of_integer_parts(text: &str, span: Span) -> bool {
    const WORDS: [&str; 7] =
        ["greatest integer", "least integer", "integer part", "integral part", "floor", "ceiling", "nearest integer"];
    effort::count_steps(text.len() / 32);
    text.contains("greatest integer") || text.contains("least integer") || example_speaks_of(text, span, &WORDS)
}

/// Whether the text of the example so far, or just behind a formula, speaks of coordinates of which only the ratios count.
pub(crate) fn speaks_of_homogeneous_coordinates(text: &str, span: Span) -> bool {
    example_speaks_of(text, span, &["homogeneous", "projective"])
}

/// Whether one of these words stands in the text of the example so far, or just behind a formula.
pub(super) fn example_speaks_of(text: &str, span: Span, words: &[&str]) -> bool {
    let (_, after) = text_around(text, span);
    let near = format!("{} {after}", text_before(text, span)).to_ascii_lowercase();
    words.iter().any(|word| near.contains(word))
}

/// Whether only marks and tags stand between a formula and one before it.
pub(crate) fn follows_formula(text: &str, formula: Span) -> bool {
    let mut before = text.get(..formula.start as usize).unwrap_or_default().trim_end();
    for _ in 0..6 {
        if before.ends_with("</m>") || before.ends_with("</me>") || before.ends_with("$") || before.ends_with("\\)") {
            return true;
        }
        let Some(open) = before.rfind('<').filter(|_| before.ends_with('>')) else { break };
        before = before[..open].trim_end();
    }
    false
}

/// Whether a side begins a display, which does not go on from another one just before it.
pub(crate) fn opens_display(text: &str, formula: Span, side: Span) -> bool {
    let before = text.get(..formula.start as usize).unwrap_or_default().trim_end();
    let mark = text.get(formula.start as usize..side.start as usize).unwrap_or_default().trim();
    matches!(mark, "$$" | "\\[") && !["$$", "\\]", "}"].iter().any(|end| before.ends_with(end))
}

/// Whether the name of a function in running text stands just before a formula: tan $45^\circ$.
pub(crate) fn follows_function(text: &str, formula: Span) -> bool {
    let before = text.get(..formula.start as usize).unwrap_or_default().trim_end();
    let word = before.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    ["sin", "cos", "tan", "cot", "log", "ln", "sqrt", "arctan", "arcsin", "arccos"].contains(&word)
}

/// Whether what stands close before a side shows that it was torn off: a letter before brackets or decimals without a digit before their
/// point, a command of TeX, or a sign of a product.
pub(crate) fn is_torn_off(text: &str, side: &ChainSide) -> bool {
    let before = text.get(..side.span.start as usize).unwrap_or_default();
    let Some(first) = side.tokens.first() else { return false };
    let behind_letter = before.ends_with(|c: char| c.is_alphabetic());
    let is_bracket = first.is_sign('(');
    let is_bare = first.number().is_some_and(|digits| digits.starts_with('.'));
    let word = before.trim_end().trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let is_command = word.ends_with('\\') && word.len() < before.trim_end().len();
    // The sign of a product that is a formula of its own: 1/56 $*$ (93 − 87).
    let is_factor = ["$*$", "$\\times$", "$\\cdot$", "$\\ast$"].iter().any(|sign| before.trim_end().ends_with(sign));
    // Words with spaces of TeX between them: Sales\:\:in\:\:2004.
    let is_spaced = ["\\:", "\\;", "\\,"].iter().any(|space| before.trim_end().ends_with(space));
    (behind_letter && (is_bracket || is_bare)) || is_command || is_factor || is_spaced
}

/// Whether the minus sign of a side is the shaft of an arrow, `<-`.
pub(crate) fn is_behind_tip(text: &str, side: &ChainSide) -> bool {
    let before = text.get(..side.span.start as usize).unwrap_or_default();
    let is_shaft = side.tokens.first().is_some_and(|first| first.is_sign('-'));
    is_shaft && (before.ends_with('<') || before.ends_with("&lt;"))
}

/// Whether the text near a formula speaks of what is true or false.
pub(crate) fn speaks_of_truth(text: &str, span: Span) -> bool {
    let (before, after) = text_around(text, span);
    let near = format!("{before} {after}").to_ascii_lowercase();
    near.split(|c: char| !c.is_alphabetic())
        .any(|word| ["true", "false", "lie", "truth", "believe", "believes", "believed"].contains(&word))
}

/// Whether one of these words stands in the sentence before a place.
pub(crate) fn speaks_before(text: &str, span: Span, words: &[&str]) -> bool {
    let (before, _) = text_around(text, span);
    let sentence = before.rsplit(['?', '!']).next().unwrap_or_default().rsplit(". ").next().unwrap_or_default();
    let sentence = sentence.to_ascii_lowercase();
    words.iter().any(|word| sentence.contains(word))
}

/// Whether one of these words stands in the text just before or behind a place.
pub(crate) fn speaks_around(text: &str, span: Span, words: &[&str]) -> bool {
    let (before, after) = text_around(text, span);
    let near = format!("{before} {after}").to_ascii_lowercase();
    words.iter().any(|word| near.contains(word))
}

/// Whether the text near a formula says that something has no value.
pub(crate) fn calls_undefined(text: &str, span: Span) -> bool {
    const WORDS: [&str; 13] = [
        "undefined",
        "not defined",
        "is not a number",
        "no value",
        "does not exist",
        "doesn't exist",
        "do not exist",
        "not real",
        "no real",
        "not a real",
        "imaginary",
        "by zero",
        "by 0",
    ];
    let (before, after) = text_around(text, span);
    let sentence = before.rsplit(['.', '?', '!']).next().unwrap_or_default();
    let rest = after.split(['.', '?', '!']).next().unwrap_or_default();
    let near = format!("{sentence} {rest}").to_ascii_lowercase();
    WORDS.iter().any(|word| near.contains(word))
}

/// Whether the sign of a factorial ends a formula behind its last side, or stands behind the formula and the sentence goes on.
pub(crate) fn begins_with_factorial(text: &str, side: Span, formula: Span) -> bool {
    let inside = text.get(side.end as usize..formula.end as usize).unwrap_or_default();
    inside.trim_start().starts_with('!') || goes_on_behind_factorial(text, formula)
}

fn goes_on_behind_factorial(text: &str, span: Span) -> bool {
    let rest = text_behind(text, span).strip_prefix('!');
    rest.is_some_and(|rest| {
        let next = rest.trim_start_matches([' ', '~', '\n']);
        !rest.starts_with('!') && (rest.starts_with(['.', ',', ';', ')']) || next.starts_with(char::is_lowercase))
    })
}

/// The text close before a place, up to the marks with which a formula begins.
pub(super) fn words_before(text: &str, span: Span) -> &str {
    let start = (span.start as usize).min(text.len());
    let mut from = start.saturating_sub(NEAR / 2);
    while !text.is_char_boundary(from) {
        from -= 1;
    }
    let marks = |c: char| c.is_whitespace() || "$({[\\~".contains(c);
    text.get(from..start).unwrap_or_default().trim_end_matches(marks)
}

/// The numbers in the words before a place that a preposition joins to it: *17 coins at*.
pub(crate) fn counts_before(text: &str, span: Span) -> Vec<f64> {
    let before = words_before(text, span);
    let clause = before.rsplit(['=', ';', '?', '\n']).next().unwrap_or_default();
    let clause = clause.rsplit(". ").next().unwrap_or_default();
    let joined = ["at", "of", "for", "@", "à", "costing", "worth"].iter().find_map(|word| clause.strip_suffix(word));
    let words = joined.filter(|rest| rest.ends_with([' ', '~', '\u{a0}'])).unwrap_or_default();
    let numbers = words.split(|c: char| !(c.is_ascii_digit() || ",.".contains(c)));
    numbers.filter_map(|number| parse_decimal(&number.trim_matches(['.', ',']).replace(',', ""))).collect()
}

/// Whether the text speaks of a drawing or a map to scale, on which a length stands for another quantity.
pub(crate) fn speaks_of_scale(text: &str, span: Span) -> bool {
    let (before, after) = text_around(text, span);
    let words = format!("{before} {after}").to_ascii_lowercase();
    let mut words = words.split(|c: char| !c.is_alphabetic());
    words.any(|word| {
        ["scale", "scaled", "map", "represents", "represent", "drawing", "drawn", "corresponds"].contains(&word)
    })
}

/// Whether only marks of formulas and space are between two places.
pub(crate) fn are_adjacent(text: &str, first: Span, second: Span) -> bool {
    let between = text.get(first.end as usize..second.start as usize).unwrap_or("…");
    if between.len() > 400 {
        return false;
    }
    // Two items of a list.
    if between.contains("</li>") && between.contains("<li") {
        return false;
    }
    // Two cells of one row.
    let has = |tags: [&str; 2]| tags.iter().any(|tag| between.contains(tag));
    if has(["<entry", "<td"]) && !has(["<row", "<tr"]) {
        return false;
    }
    let plain = without_tags(between);
    if plain.contains(['.', ';', ':']) || plain.contains("\\item") || plain.matches('\n').count() > 2 {
        return false;
    }
    // What the second formula begins with, its name and its equals sign, is between, too.
    let words: Vec<String> = plain
        .split(|c: char| !c.is_alphanumeric() && c != '\\')
        .filter(|word| word.len() > 1 && !word.starts_with('\\'))
        .map(str::to_ascii_lowercase)
        .collect();
    // Two values of a name in a list or a sentence, as in *r = ⅙ for a die and r = ½ for a coin*, are two values.
    let has_arrow = ["→", "⇒", "⟹", "Rightarrow", "implies", "\\to"].iter().any(|arrow| plain.contains(arrow));
    let is_inferred = has_arrow || words.iter().any(|word| INFERRING.contains(&&**word));
    let in_rows = plain.contains("\\\\") || plain.contains("\\cr") || plain.contains('\n') || between.contains("mtr");
    let says_more = words.iter().filter(|word| !INFERRING.contains(&&***word)).any(|word| word.chars().count() > 3);
    !says_more && (is_inferred || (in_rows && words.is_empty() && !plain.contains(',')))
}

/// Words by which a second value of a name follows from the first.
const INFERRING: [&str; 11] =
    ["so", "thus", "hence", "therefore", "then", "which", "is", "that", "ie", "giving", "gives"];

/// The text behind a place, without marks of formulas and tags at its start.
pub(super) fn text_behind(text: &str, span: Span) -> &str {
    let start = text.len().min(span.end as usize);
    let mut end = text.len().min(start + NEAR);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    text.get(start..end).unwrap_or_default()
}

fn skip_space(text: &str) -> &str {
    text.trim_start_matches([' ', '~', '\u{a0}', '\u{202f}', '\u{2009}']).trim_start_matches("\\,")
}

/// The first word of a text with commands for signs of units as these signs: `k\Ohm` and `k$\Omega$` as kΩ.
fn spell_unit_signs(text: &str) -> String {
    let word = text.split(char::is_whitespace).next().unwrap_or_default();
    let mut out = String::new();
    let mut rest = word;
    while let Some(next) = rest.chars().next() {
        let inner = rest.strip_prefix('$').unwrap_or(rest);
        let command = inner.strip_prefix('\\').and_then(|name| {
            let length = name.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(name.len());
            let (name, behind) = (name.get(..length.max(1))?, name.get(length.max(1)..)?);
            let sign = unit_sign(name).map(String::from);
            // A private command is named after its unit.
            sign.or_else(|| unit(name).is_some().then(|| name.to_owned())).map(|sign| (sign, behind))
        });
        match command {
            Some((sign, behind)) => {
                out.push_str(&sign);
                let closed =
                    if inner.len() < rest.len() { behind.strip_prefix('$') } else { behind.strip_prefix("{}") };
                rest = closed.unwrap_or(behind);
            }
            None => {
                out.push(next);
                rest = &rest[next.len_utf8()..];
            }
        }
    }
    out
}

/// Whether what stands directly behind a formula may be a unit that is not known: a noun, or a prefix that touches a command.
pub(crate) fn may_be_unit_behind(text: &str, span: Span) -> bool {
    let rest = skip_space(text_behind(text, span));
    let word = rest.split(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    let is_command = |text: &str| text.strip_prefix('\\').is_some_and(|name| name.starts_with(char::is_alphabetic));
    let prefixed = word.chars().count() == 1 && is_command(&rest[word.len()..]);
    prefixed || (is_noun(word) && word.starts_with(char::is_lowercase) && unit(word).is_none())
}

/// The unit in running text directly behind a formula, as tokens; none if there is none.
pub(crate) fn unit_behind(text: &str, span: Span) -> Vec<Token> {
    let mut rest = skip_space(text_behind(text, span));
    // Tags that close around the formula.
    while let Some((_, behind)) = rest.strip_prefix("</").and_then(|tag| tag.split_once('>')) {
        rest = skip_space(behind);
    }
    let rest = spell_unit_signs(rest);
    let end = rest.find(|c: char| c.is_whitespace() || ",;:<$\\".contains(c)).unwrap_or(rest.len());
    let word = rest[..end].trim_end_matches(['.', ')', '!', '?', '"', '*', '_']);
    let mut tokens = join_tokens(&tokenise_text(word, span.end as usize));
    for token in &mut tokens {
        match token.word() {
            Some("turn" | "turns") => token.kind = TokenKind::Word("revolution".to_owned()),
            Some("percentage") => token.kind = TokenKind::Word("percent".to_owned()),
            _ => {}
        }
    }
    let is_unit = |token: &Token| match &token.kind {
        TokenKind::Word(word) => unit(word).is_some() || large_number(word).is_some(),
        TokenKind::Power(_) | TokenKind::Operator('/' | '·') => true,
        _ => false,
    };
    let first_is_word = tokens.first().is_some_and(|token| token.word().is_some());
    if !first_is_word || !tokens.iter().all(is_unit) {
        return Vec::new();
    }
    tokens.insert(0, Token::new(TokenKind::Space(2), span));
    tokens
}

/// Whether a preposition stands just before a place, so that the quantity there belongs to the words before it: the mass
/// after 90 years.
pub(crate) fn follows_preposition(text: &str, span: Span) -> bool {
    const PREPOSITIONS: [&str; 10] = ["for", "after", "at", "in", "within", "during", "before", "with", "over", "from"];
    let marks = |c: char| c.is_whitespace() || "$({[\\~".contains(c);
    let mut before = text.get(..span.start as usize).unwrap_or_default().trim_end_matches(marks);
    while let Some(open) = before.rfind('<').filter(|_| before.ends_with('>')) {
        before = before[..open].trim_end_matches(marks);
    }
    let word = before.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    PREPOSITIONS.contains(&word.to_ascii_lowercase().as_str())
}

/// Whether the word *and* joins what stands at a place to a number with its noun: 7 shillings and 85 cents.
pub(crate) fn is_second_amount(text: &str, span: Span) -> bool {
    const AND: [&str; 7] = [" and", " et", " und", " e", " y", " og", " och"];
    let before = words_before(text, span);
    let Some(before) = AND.iter().find_map(|and| before.strip_suffix(and)) else { return false };
    let before = before.trim_end_matches([' ', '$']);
    let noun = before.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    let count = before[..before.len() - noun.len()].trim_end_matches([' ', '~', '\u{a0}', '\\', ',']);
    noun.chars().count() > 1 && count.ends_with(|c: char| c.is_ascii_digit())
}

/// Whether a word behind a place joins it to another number: `24 = 2 by 12`.
pub(crate) fn goes_on_in_words(text: &str, span: Span) -> bool {
    const JOINTS: [&str; 10] =
        ["per", "in", "out of", "times", "by", "plus", "minus", "over", "divided by", "multiplied by"];
    let marks = |c: char| c == ' ' || "$)\\~".contains(c);
    let rest = text_behind(text, span).trim_start_matches(marks);
    JOINTS.iter().filter_map(|joint| rest.strip_prefix(joint)).any(|rest| {
        let next = rest.trim_start_matches(|c: char| c == ' ' || "$(\\~".contains(c));
        rest.starts_with([' ', '~']) && next.starts_with(|c: char| c.is_ascii_digit())
    })
}

/// Whether the line below goes on with a sign of a product or a relation.
pub(crate) fn goes_on_below(text: &str, span: Span) -> bool {
    let Some(below) = text_behind(text, span).trim_start_matches([' ', '\r']).strip_prefix('\n') else { return false };
    let below = below.trim_start_matches([' ', '\t', '>']);
    below.strip_prefix(['/', '×', '·', '÷', '=']).is_some_and(|rest| rest.starts_with(' '))
}

/// Whether a comma behind a place leads to a last number, so that two lists may be equal: `6/2, 8/2 = 3, 4`.
pub(crate) fn ends_in_list(text: &str, span: Span) -> bool {
    let rest = text_behind(text, span);
    let next = rest
        .trim_start_matches(['}', ' '])
        .strip_prefix(',')
        .map(|next| next.trim_start_matches(['\\', ' ', ',', '~', ';']));
    next.is_some_and(|next| {
        let clause = next.split(['$', '\n', '&']).next().unwrap_or_default();
        next.starts_with(|c: char| c.is_ascii_digit() || c == '-') && !clause.contains('=')
    })
}

/// Whether three digits stand behind a comma and a blank after a number of up to three, as thousands are sometimes parted: `40, 320`.
pub(crate) fn goes_on_in_thousands(text: &str, span: Span) -> bool {
    let digits = |of: &str| of.chars().take_while(char::is_ascii_digit).count();
    let number = text.get(span.range()).unwrap_or_default();
    let next = text_behind(text, span).strip_prefix(", ");
    (1..=3).contains(&number.len()) && digits(number) == number.len() && next.is_some_and(|next| digits(next) == 3)
}

/// Whether an operator joins a number in running text to what stands before it, on the line before or with words between: the
/// difference of *28.47 − initial 0.32 = 28.15*.
pub(crate) fn is_joined_by_sign(text: &str, span: Span) -> bool {
    let start = (span.start as usize).min(text.len());
    let mut from = start.saturating_sub(NEAR / 2);
    while !text.is_char_boundary(from) {
        from -= 1;
    }
    let before = text.get(from..start).unwrap_or_default();
    let is_sign = |c: char| "+-−–×·*/÷=".contains(c);
    let (above, line) = before.rsplit_once('\n').unwrap_or(("", before));
    let marks = |c: char| c == ' ' || c == '>' || c == '\t';
    let begins = line.trim_start_matches(marks);
    let above = above.rsplit('\n').next().unwrap_or_default().trim_matches(marks);
    if begins.is_empty() && !above.is_empty() {
        let mut last = above.chars().rev();
        let sign = last.next().filter(|c| is_sign(*c));
        // A heading or a rule is underlined with more than one sign.
        return sign.is_some() && last.next() != sign;
    }
    // A product that goes on in the next row looks like an item of a list.
    let sign = begins.trim_end();
    if sign.chars().count() == 1 && sign.starts_with(is_sign) && !above.is_empty() {
        return !above.starts_with(sign)
            && above.contains(|c: char| c.is_ascii_digit())
            && !above.ends_with([':', '.']);
    }
    let words = line.trim_end_matches(|c: char| c.is_alphabetic() || c == ' ' || c == '.');
    let between = &line[words.len()..];
    let times = between.contains(" x ") || between.starts_with("x ");
    let signed = times || (words.ends_with(|c: char| is_sign(c) && c != '=') && between.starts_with(' '));
    let rest = words.trim_end_matches(|c: char| is_sign(c) || c == ' ');
    signed
        && between.contains(char::is_alphabetic)
        && rest.ends_with(|c: char| c.is_alphanumeric() || c == ')')
        && rest.contains(|c: char| c.is_ascii_digit())
}

/// Whether a word that names something stands just before a number in a line, so that the number may belong to its name: the
/// interest on 8000.
pub(crate) fn follows_name(text: &str, span: Span) -> bool {
    const LINKS: &str = " is are was be so that then thus hence therefore get gets have has gives give equals equal result and or \
        where since because if when but as now we it which yields find finds ";
    let start = (span.start as usize).min(text.len());
    let before = text.get(..start).unwrap_or_default();
    let before = before.trim_end_matches([' ', '.']);
    let word = before.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    word.chars().count() > 1 && !LINKS.split_ascii_whitespace().any(|link| link.eq_ignore_ascii_case(word))
}

/// Whether a word that is numbered stands just before a number: line 12.
pub(crate) fn follows_label(text: &str, span: Span) -> bool {
    const LABELS: &str = " line lines row rows eq eqs equation equations step steps column item box no nos number sta station fig figure \
        table section chapter page exercise example problem question part case test trial run room p pp see ";
    let start = (span.start as usize).min(text.len());
    let before = text.get(..start).unwrap_or_default();
    let Some(before) = before.strip_suffix([' ', '\u{a0}', '~']) else { return false };
    let word = before.trim_end_matches(['.', ' ']).rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    !word.is_empty() && LABELS.split_ascii_whitespace().any(|label| label.eq_ignore_ascii_case(word))
}

/// The base of the number at the end of a formula, if the words just behind it name one.
pub(crate) fn named_base(text: &str, span: Span) -> Option<u32> {
    const BASES: [(&str, u32); 4] = [("binary", 2), ("octal", 8), ("hexadecimal", 16), ("hex", 16)];
    let near: String = text_behind(text, span).chars().take(30).collect();
    let near = without_tags(&near);
    let near = near.split(['.', ';', '=', '?', '!']).next().unwrap_or_default();
    let mut words = near.split(|c: char| !c.is_alphabetic());
    words.find_map(|word| BASES.iter().find(|(name, _)| *name == word.to_ascii_lowercase()).map(|(_, base)| *base))
}

/// Words that say which way a quantity points, so that its sign may be left out.
const DIRECTIONS: [&str; 34] = [
    "left",
    "right",
    "up",
    "down",
    "upward",
    "upwards",
    "downward",
    "downwards",
    "north",
    "south",
    "east",
    "west",
    "inward",
    "inwards",
    "outward",
    "outwards",
    "backward",
    "backwards",
    "forward",
    "forwards",
    "below",
    "above",
    "opposite",
    "clockwise",
    "counterclockwise",
    "anticlockwise",
    "toward",
    "towards",
    "away",
    "behind",
    "downhill",
    "released",
    "lost",
    "deceleration",
];

/// Whether the words just behind a place name a direction.
pub(crate) fn names_direction(text: &str, span: Span) -> bool {
    let rest = text_behind(text, span);
    let near: String = rest.chars().take(70).collect();
    // The commands \left and \right are no words, nor are attributes of tags.
    let mut outside = String::new();
    let mut skipped = false;
    for c in without_tags(&near).chars() {
        skipped = if c == '\\' { true } else { skipped && c.is_ascii_alphabetic() };
        outside.push(if skipped { ' ' } else { c });
    }
    let outside = outside.trim_start_matches(['}', '$', ')', ']', ',', ' ']);
    let sentence = outside.split(['=', '$', ';']).next().unwrap_or_default();
    sentence.split(|c: char| !c.is_alphabetic()).any(|word| DIRECTIONS.contains(&word))
}
