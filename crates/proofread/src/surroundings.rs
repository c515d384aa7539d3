//! What the text around a formula says about it.

use crate::token::Span;

/// Most bytes of text that are looked at on each side.
const NEAR: usize = 160;

fn around(text: &str, span: Span) -> (String, String) {
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
    (without_tags(before), without_tags(after))
}

fn without_tags(text: &str) -> String {
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

/// Whether the text asks if the formula holds, or says that it does not.
pub(crate) fn meant_false(text: &str, span: Span) -> bool {
    let (before, after) = around(text, span);
    let sentence = before.rsplit(['.', '?', '!']).next().unwrap_or_default().to_lowercase();
    let rest = after.split_once(['.', '?', '!']).map_or(after.as_str(), |(rest, _)| rest).to_lowercase();
    let asked = after.find(['.', '?', '!']).is_some_and(|at| after[at..].starts_with('?'));
    let mut words = sentence.split(|c: char| !c.is_alphabetic());
    let question = words.any(|word| ["is", "are", "does", "do", "can", "could", "will", "whether"].contains(&word));
    if asked && question {
        return true;
    }
    const DENIALS: [&str; 9] = [
        "is false",
        "not true",
        "a false statement",
        "contradiction",
        "incorrect",
        "is wrong",
        "not equal",
        "is not a solution",
        "is inconsistent",
    ];
    DENIALS.iter().any(|denial| rest.contains(denial))
}

/// Whether only marks of formulas and space are between two places.
pub(crate) fn adjoin(text: &str, first: Span, second: Span) -> bool {
    let between = text.get(first.end as usize..second.start as usize).unwrap_or("…");
    if between.len() > 400 {
        return false;
    }
    let plain = without_tags(between);
    // The name and the equals sign of the second formula are between, too.
    let words = plain.split(|c: char| !c.is_alphanumeric()).filter(|word| word.chars().count() > 3).count();
    words == 0 && !plain.contains(['.', ';', ':']) && plain.matches('\n').count() <= 2
}
