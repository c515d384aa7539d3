//! A share in per cent beside its parts: `12 of 48 (25 %)`, `12/48, 25.0%`, `Of the 48 patients, 12 (25 %) …`.

use super::characters::{PARAGRAPH, PlainCharacters};
use super::scanner::{Comma, PrintedNumber, Scanner};
use super::{Judged, Outcome};
use crate::judge::doubt::Doubt;
use std::ops::Range;

/// A part with its share, and the whole if it stands beside them.
struct PrintedShare {
    part: f64,
    whole: Option<f64>,
    share: PrintedNumber,
    /// Where the part, the whole and the share are.
    range: Range<usize>,
    /// Where the share is.
    at: Range<usize>,
    /// Whether a word such as *about* stands before both.
    is_rough: bool,
}

/// Whether a word before a place says that what follows is not exact.
fn is_called_rough(chars: &[char], at: usize) -> bool {
    let before: String = chars[at.saturating_sub(16)..at].iter().collect();
    let word = before.trim_end().rsplit(|c: char| !c.is_alphabetic()).next().unwrap_or_default().to_lowercase();
    ["about", "over", "around", "approximately", "nearly", "almost", "roughly", "some"].contains(&word.as_str())
}

/// Whether a part of a whole gives the share.
pub(super) fn is_share(part: f64, whole: f64, share: PrintedNumber) -> bool {
    let computed = 100.0 * part / whole;
    share.meets(computed, computed)
}

/// Checks the shares of a text.
pub(super) fn check(plain: &PlainCharacters, out: &mut Vec<Judged>) -> usize {
    let chars = &plain.chars;
    let (mut at, mut checked, mut sentence) = (0, 0, 0);
    let mut loose: Vec<PrintedShare> = Vec::new();
    while at < chars.len() {
        let here = Scanner::new(chars, at);
        let c = chars[at];
        let ends_sentence = c == PARAGRAPH || (c == '.' && here.ahead(1) == ' ' && !here.ahead(2).is_lowercase());
        if ends_sentence {
            checked += judge_loose(chars, sentence..at, &mut loose, out);
            sentence = at + 1;
        }
        let starts =
            c.is_ascii_digit() && !(here.before().is_alphanumeric() || ".,_^-–/\u{1}$€£".contains(here.before()));
        let found = if starts { printed_share(here) } else { None };
        let Some(share) = found else {
            // The rest of the number is no other one.
            at += 1;
            while starts && at < chars.len() && chars[at].is_ascii_digit() {
                at += 1;
            }
            continue;
        };
        at = share.range.end;
        match share.whole {
            Some(whole) => {
                checked += 1;
                if !is_share(share.part, whole, share.share) {
                    out.push(judged(&share, whole, &outcome_of(&share, whole)));
                }
            }
            None => loose.push(share),
        }
    }
    checked + judge_loose(chars, sentence..chars.len(), &mut loose, out)
}

/// A truncated share is meant to be one, and one that was rounded twice follows its author's digits.
fn outcome_of(share: &PrintedShare, whole: f64) -> Outcome {
    let computed = 100.0 * share.part / whole;
    let is_cut = share.share.is_cut_or_rounded_twice(computed);
    // In 19.2 % (8/10) + …, a rate is multiplied by a share.
    let is_product = share.at.start == share.range.start && (computed - share.share.value).abs() > 0.5 * computed;
    match () {
        () if is_cut || share.is_rough => Outcome::Doubt(Doubt::Truncated),
        () if is_product => Outcome::Doubt(Doubt::OtherParts),
        () => Outcome::Difference,
    }
}

fn judged(share: &PrintedShare, whole: f64, outcome: &Outcome) -> Judged {
    let decimals = share.share.decimals;
    Judged {
        left: share.range.start..share.at.start,
        right: share.at.clone(),
        whole: share.range.clone(),
        recomputed: format!("{:.decimals$}%", 100.0 * share.part / whole),
        why: Some(format!("it is {} of {whole}", share.part)),
        outcome: *outcome,
    }
}

/// Shares of one sentence whose whole stands elsewhere in it.
fn judge_loose(chars: &[char], sentence: Range<usize>, loose: &mut Vec<PrintedShare>, out: &mut Vec<Judged>) -> usize {
    let loose = std::mem::take(loose);
    if loose.is_empty() || sentence.is_empty() {
        return 0;
    }
    // Several parts of several wholes, in their order.
    let in_order = chars[sentence.clone()].iter().collect::<String>().contains("respectively");
    let Some(whole) = whole_of(chars, sentence) else { return 0 };
    let fits: Vec<bool> = loose.iter().map(|share| is_share(share.part, whole, share.share)).collect();
    let agreeing = fits.iter().filter(|fits| **fits).count();
    for (share, _) in loose.iter().zip(&fits).filter(|(_, fits)| !**fits) {
        let outcome = match agreeing > 0 && 2 * agreeing >= fits.len() && !in_order {
            true => outcome_of(share, whole),
            false => Outcome::Doubt(Doubt::OtherParts),
        };
        out.push(judged(share, whole, &outcome));
    }
    fits.len()
}

/// The number behind *of the* in a sentence, if there is one such number.
fn whole_of(chars: &[char], sentence: Range<usize>) -> Option<f64> {
    let mut found = None;
    for at in sentence {
        let mut here = Scanner::new(chars, at);
        if !here.before().is_alphabetic() && here.take_text("of ") {
            for word in ["the ", "these ", "those ", "all ", "our ", "total "] {
                here.take_text(word);
            }
            if let Some(number) = here.number(Comma::Groups).filter(|number| number.is_whole() && number.value > 1.0) {
                here.skip_space();
                if here.peek() != '%' && !here.peek().is_ascii_digit() {
                    if found.is_some_and(|found| found != number.value) {
                        return None;
                    }
                    found = Some(number.value);
                }
            }
        }
    }
    found
}

/// Largest share that is read.
const MOST_PERCENT: f64 = 1000.0;

/// A part, or a share with its part in brackets behind it.
fn printed_share(mut here: Scanner<'_>) -> Option<PrintedShare> {
    let start = here.at;
    let is_rough = is_called_rough(here.chars, start);
    let first = here.number(Comma::Groups)?;
    let first_end = here.at;
    here.skip_space();
    if is_percent(&mut here) {
        // 25 % (12/48)
        here.skip_space();
        here.take('(').then_some(())?;
        here.take_text("n = ");
        let part = here.number(Comma::Groups).filter(|number| number.is_whole())?;
        let whole = whole_behind(&mut here)?;
        here.skip_space();
        let ends = matches!(here.peek(), ')' | ',' | ';');
        let fits = ends && whole > 0.0 && first.value <= MOST_PERCENT;
        return fits.then_some(PrintedShare {
            part: part.value,
            whole: Some(whole),
            share: first,
            range: start..here.at,
            at: start..first_end,
            is_rough,
        });
    }
    if !first.is_whole() || here.ahead(0) == '.' {
        return None;
    }
    here.at = first_end;
    let whole = whole_behind(&mut here);
    // One or two words for what is counted.
    here.skip_space();
    for _ in 0..3 {
        if whole.is_some() && here.peek().is_alphabetic() && !here.word().is_empty() {
            here.skip_space();
        }
    }
    let opened = here.take_one_of("([");
    let with_comma = opened.is_none() && whole.is_some() && here.take(',');
    (opened.is_some() || with_comma).then_some(())?;
    here.skip_space();
    let at = here.at;
    let share = here.number(Comma::Groups).filter(|share| (0.0..=MOST_PERCENT).contains(&share.value))?;
    here.skip_space();
    is_percent(&mut here).then_some(())?;
    let end = here.at;
    let closes = match here.peek() {
        ')' | ']' | ';' | ',' => true,
        '.' => opened.is_none() && !here.ahead(1).is_ascii_digit(),
        c => opened.is_none() && c == PARAGRAPH,
    };
    let fits = closes && whole.is_none_or(|whole| whole > 0.0);
    fits.then_some(PrintedShare { part: first.value, whole, share, range: start..end, at: at..end, is_rough })
}

/// `/48`, `of 48`, `out of 48`, `of the 48`.
fn whole_behind(here: &mut Scanner<'_>) -> Option<f64> {
    let start = *here;
    let mut found = here.take('/');
    if !found {
        here.skip_space();
        found = here.take('/') || here.take_text("out of ") || here.take_text("of ");
    }
    here.skip_space();
    here.take_text("the ");
    let whole = if found { here.number(Comma::Groups).filter(|number| number.is_whole()) } else { None };
    let is_number = !matches!(here.peek(), '/' | '%' | '^' | '-' | '–') && !here.peek().is_alphanumeric();
    match whole.filter(|_| is_number) {
        Some(whole) => Some(whole.value),
        None => {
            *here = start;
            None
        }
    }
}

fn is_percent(here: &mut Scanner<'_>) -> bool {
    here.take('%') || here.take_text("per cent") || here.take_text("percent")
}
