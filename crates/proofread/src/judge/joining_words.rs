//! Words before a side that join it to what stands there: half *of* 12, *twice* 3, 5 *times* 3.

use crate::judge::surroundings::words_before;
use crate::token::Span;
use crate::unit::unit;

/// Words for what is computed of a number behind *of*, in several languages.
const OPERATIONS: &str = "root square cube half third quarter logarithm sine cosine tangent reciprocal inverse double triple \
    tenth fifth hundredth wurzel quadrat logarithmus kehrwert hälfte drittel viertel fünftel zehntel \
    doppelte dreifache racine carré moitié tiers quart dixième raíz raiz cuadrado mitad tercio metade \
    metà helft wortel hälften";

/// Words for *of* behind these.
const OF: [&str; 9] = ["of", "von", "aus", "de", "di", "van", "uit", "av", "af"];

/// Words for how many times the number behind them is meant.
const MULTIPLES: [&str; 9] = ["twice", "thrice", "double", "triple", "half", "doppelt", "zweimal", "dreimal", "halb"];

/// Whether a number and a word just before a place join it to what stands there: `5 times 3 = 15`, `80 % of 20 = 16`.
pub(crate) fn is_joined_by_word(text: &str, span: Span) -> bool {
    const JOINTS: [&str; 11] =
        ["divided by", "multiplied by", "of", "to", "times", "plus", "minus", "over", "per", "by", "less"];
    const BOTH: [&str; 6] = ["sum of", "mean of", "average of", "product of", "difference of", "between"];
    let before = words_before(text, span);
    // The sum of 3 and 4 = 7.
    let clause = before.rsplit(['.', '=', ';']).next().unwrap_or_default();
    let both = BOTH.iter().any(|words| clause.contains(words));
    let last_word = |of: &str| of.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default().to_lowercase();
    let last = last_word(before);
    // Twice 3 = 6.
    if MULTIPLES.contains(&last.as_str()) {
        return true;
    }
    // The square root of 100 · 300 = 173.
    if let Some(before) = before.strip_suffix(&last).filter(|_| OF.contains(&last.as_str()))
        && OPERATIONS.split_ascii_whitespace().any(|word| word == last_word(before.trim_end()))
    {
        return true;
    }
    let joint = JOINTS.iter().find_map(|joint| before.strip_suffix(joint));
    let joint = joint.or_else(|| before.strip_suffix("and").filter(|_| both));
    let Some(rest) = joint.filter(|rest| rest.ends_with(|c: char| c.is_whitespace() || c == '~')) else { return false };
    let rest = rest.trim_end_matches(|c: char| c.is_whitespace() || "$)\\~".contains(c));
    const PARTS: [&str; 12] = [
        "half", "third", "thirds", "quarter", "quarters", "fourth", "fourths", "fifth", "fifths", "sixth", "eighth",
        "tenth",
    ];
    let part = rest.rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default();
    if PARTS.contains(&part) {
        return true;
    }
    let counted = |rest: &str| rest.ends_with(|c: char| c.is_ascii_digit());
    let word = rest.rsplit(|c: char| !(c.is_alphabetic() || c == '%')).next().unwrap_or_default();
    let before_word =
        rest[..rest.len() - word.len()].trim_end_matches(|c: char| c.is_whitespace() || "$\\~".contains(c));
    counted(rest) || (unit(word).is_some() && counted(before_word))
}
