//! A confidence interval beside the estimate, the margin or the standard error that it is made of.

use super::characters::{PARAGRAPH, PlainCharacters};
use super::distribution::{normal_quantile, student_quantile};
use super::scanner::{Comma, PrintedNumber, Scanner};
use super::{Judged, Outcome};
use crate::judge::doubt::Doubt;
use std::ops::Range;

/// A number and where it is.
#[derive(Clone, Copy)]
struct Placed {
    number: PrintedNumber,
    start: usize,
    end: usize,
}

/// Checks the intervals of a text.
pub(super) fn check(plain: &PlainCharacters, out: &mut Vec<Judged>) -> usize {
    let chars = &plain.chars;
    let mut checked = 0;
    for at in 0..chars.len() {
        let found = match chars[at] {
            '±' => around_margin(chars, at),
            'C' | 'c' | 'K' => named_interval(chars, at),
            _ => None,
        };
        let Some(interval) = found else { continue };
        checked += 1;
        out.extend(interval.judge());
    }
    checked
}

/// What an interval is made of.
struct MadeInterval {
    estimate: Placed,
    /// Least and largest half-widths: by the printed margin, or by each quantile that may have been used.
    margins: Vec<[f64; 2]>,
    /// Whether the margin itself is printed.
    has_margin: bool,
    low: Placed,
    high: Placed,
    start: usize,
}

impl MadeInterval {
    /// Whether the estimate is in the middle between the limits.
    fn is_centred(&self) -> bool {
        let (low, high) = (self.low.number, self.high.number);
        self.estimate.number.meets(f64::midpoint(low.low(), high.low()), f64::midpoint(low.high(), high.high()))
    }

    fn judge(&self) -> Option<Judged> {
        let (low, high, estimate) = (self.low.number, self.high.number, self.estimate.number);
        let whole = self.start.min(self.estimate.start)..self.high.end;
        let at = |range: Range<usize>, recomputed: String, why: &str, outcome| Judged {
            left: self.estimate.start..self.estimate.end,
            right: range,
            whole: whole.clone(),
            recomputed,
            why: Some(why.to_owned()),
            outcome,
        };
        let both = self.low.start..self.high.end;
        let decimals = low.decimals.max(high.decimals);
        if self.margins.is_empty() {
            let inside = estimate.high() >= low.low() && estimate.low() <= high.high();
            let centre = f64::midpoint(low.value, high.value);
            let recomputed = format!("centre {centre:.decimals$}");
            return (!inside).then(|| {
                let ordered = low.value < high.value;
                let outcome = if ordered { Outcome::Difference } else { Outcome::Doubt(Doubt::OtherTest) };
                at(both, recomputed, "the estimate is outside its interval", outcome)
            });
        }
        let fits = |margin| fitting_limits(estimate, [low, high], margin);
        let best = self.margins.iter().map(|margin| (*margin, fits(*margin)));
        let best = best.max_by_key(|(_, fits)| fits.iter().filter(|fits| **fits).count());
        let (margin, fits) = best?;
        let half = f64::midpoint(margin[0], margin[1]);
        let recomputed =
            format!("{:.decimals$} to {:.decimals$}", estimate.value - half, estimate.value + half).replace('-', "−");
        match fits {
            // Where the estimate has few digits, the two limits are too far apart or too near.
            [true, true] if self.has_margin && !is_width(low, high, margin) => {
                Some(at(both, recomputed, "the limits are not as far apart as the margin says", Outcome::Difference))
            }
            [true, true] => None,
            // The limits belong to this estimate, but to another margin.
            [false, false] if self.is_centred() => {
                let half = (high.value - low.value) / 2.0;
                let said = format!("the limits are {half:.decimals$} on either side of the estimate");
                self.has_margin.then(|| at(both, recomputed, &said, Outcome::Difference))
            }
            [false, false] => None,
            [true, false] => {
                Some(at(self.high.start..self.high.end, recomputed, "the lower limit agrees", Outcome::Difference))
            }
            [false, true] => {
                Some(at(self.low.start..self.low.end, recomputed, "the upper limit agrees", Outcome::Difference))
            }
        }
    }
}

/// Whether each of the limits is as far from the estimate as one of the margins from least to most.
fn fitting_limits(estimate: PrintedNumber, [low, high]: [PrintedNumber; 2], [least, most]: [f64; 2]) -> [bool; 2] {
    let lower = low.meets(estimate.low() - most, estimate.high() - least);
    let upper = high.meets(estimate.low() + least, estimate.high() + most);
    [lower, upper]
}

/// Whether the limits are twice the margin apart.
fn is_width(low: PrintedNumber, high: PrintedNumber, [least, most]: [f64; 2]) -> bool {
    let (width, open) = (high.value - low.value, (high.half + low.half) * (1.0 + 1e-9));
    width + open >= 2.0 * least && width - open <= 2.0 * most
}

/// `18.4 ± 2.064 × 0.7`, and an interval close behind.
fn around_margin(chars: &[char], at: usize) -> Option<MadeInterval> {
    const FAR: usize = 80;
    let estimate = number_before(chars, at)?;
    if !is_about_intervals(chars, at) {
        return None;
    }
    let mut here = Scanner::new(chars, at + 1);
    here.skip_space();
    let mut range = factor(&mut here)?;
    for _ in 0..3 {
        let mut behind = here;
        behind.skip_space();
        let times = behind.take_one_of("×·*").is_some();
        behind.skip_space();
        let bracket = behind.peek() == '(';
        if !times && !bracket {
            break;
        }
        let Some(next) = factor(&mut behind) else { break };
        range = [range[0] * next[0], range[1] * next[1]];
        here = behind;
    }
    let end = here.at;
    here.skip_space();
    if "×/√(+-·^\u{1}%".contains(here.peek()) && here.peek() != '(' {
        return None;
    }
    here.at = end;
    while here.at < end + FAR && here.peek() != PARAGRAPH && here.peek() != '±' {
        let mut candidate = here;
        // Then ± has the standard error, not the margin.
        if !here.before().is_alphanumeric()
            && ["CI", "confidence interval"].iter().any(|name| candidate.take_text(name))
        {
            return None;
        }
        let is_start = !(here.before().is_alphanumeric() || here.before() == '.')
            && (here.peek().is_ascii_digit() || "([-.".contains(here.peek()));
        if is_start && let Some((low, high)) = limits(&mut candidate) {
            let (least, most) = (estimate.number.value - range[1], estimate.number.value + range[1]);
            let near = |limit: f64, wanted: f64| (limit - wanted).abs() < range[1];
            let near = [near(low.number.value, least), near(high.number.value, most)];
            let is_it = near == [true; 2]
                || (near != [false; 2] && {
                    let [lower, upper] = fitting_limits(estimate.number, [low.number, high.number], range);
                    lower || upper || low.number.value < high.number.value
                });
            // Then ± has the standard deviation, and the limits are as far away as a known quantile says.
            let is_of_deviation = QUANTILES.into_iter().any(|of| {
                fitting_limits(estimate.number, [low.number, high.number], range.map(|half| of * half)) == [true; 2]
            });
            return (is_it && !is_of_deviation).then_some(MadeInterval {
                estimate,
                margins: vec![range],
                has_margin: true,
                low,
                high,
                start: estimate.start,
            });
        }
        here.at += 1;
    }
    None
}

/// Quantiles of the normal distribution for 90, 95 and 99 per cent.
const QUANTILES: [f64; 3] = [1.645, 1.96, 2.576];

/// Whether the text around speaks of intervals: ± is also that of two roots.
fn is_about_intervals(chars: &[char], at: usize) -> bool {
    const AROUND: usize = 200;
    let around = at.saturating_sub(AROUND)..(at + AROUND).min(chars.len());
    around.into_iter().any(|at| {
        let mut here = Scanner::new(chars, at);
        let is_start = !here.before().is_alphanumeric();
        is_start
            && ["CI", "interval", "confidence", "limits", "margin of error"].iter().any(|word| here.take_text(word))
    })
}

/// A number, also in brackets, as the interval of its digits. A known quantile counts as exact.
fn factor(here: &mut Scanner<'_>) -> Option<[f64; 2]> {
    let bracket = here.take('(');
    here.skip_space();
    let number = here.number(Comma::Groups).filter(|number| number.value > 0.0)?;
    here.skip_space();
    if bracket && !here.take(')') {
        return None;
    }
    Some([number.low().max(0.0), number.high()])
}

/// The number that ends before `at`.
fn number_before(chars: &[char], at: usize) -> Option<Placed> {
    let mut end = at;
    while end > 0 && matches!(chars[end - 1], ' ' | '%' | '°') {
        end -= 1;
    }
    let is_part = |c: char| c.is_ascii_digit() || ".,·".contains(c);
    let start = (0..end).rev().take(30).take_while(|at| is_part(chars[*at])).last()?;
    let signed = start > 0
        && "-–".contains(chars[start - 1])
        && start.checked_sub(2).is_none_or(|at| {
            !chars[at].is_alphanumeric()
                && !")]".contains(chars[at])
                && !(chars[at] == ' ' && at > 0 && (chars[at - 1].is_alphanumeric() || ")]".contains(chars[at - 1])))
        });
    let start = start - usize::from(signed);
    // What stands before the number must not be part of it.
    let outside = start.checked_sub(1).map_or(PARAGRAPH, |at| chars[at]);
    if outside.is_alphanumeric() || "/^_×:∶".contains(outside) {
        return None;
    }
    let mut here = Scanner::new(chars, start);
    let number = here.number(Comma::Groups)?;
    (here.at == end).then_some(Placed { number, start, end })
}

/// `[0.45, 3.15]`, `(0.45; 3.15)`, `0.45 to 3.15`, `0.45–3.15`, `58.67 and 64.33`.
fn limits(here: &mut Scanner<'_>) -> Option<(Placed, Placed)> {
    [Comma::Groups, Comma::Parts].into_iter().find_map(|comma| {
        let mut candidate = *here;
        let found = limits_with(&mut candidate, comma)?;
        *here = candidate;
        Some(found)
    })
}

fn limits_with(here: &mut Scanner<'_>, comma: Comma) -> Option<(Placed, Placed)> {
    let bracket = here.take_one_of("[(");
    here.skip_space();
    let placed = |here: &mut Scanner<'_>| {
        let start = here.at;
        let number = here.number(comma)?;
        Some(Placed { number, start, end: here.at })
    };
    let low = placed(here)?;
    here.skip_space();
    here.take('%');
    here.skip_space();
    let parted = match bracket {
        Some(_) => {
            here.take_one_of(",;–").is_some()
                || here.take_text("to ")
                || (here.peek() == '-' && here.before() != ' ' && here.take('-'))
        }
        None => {
            here.take('–')
                || ["to ", "and "].iter().any(|word| here.take_text(word))
                || (here.peek() == '-' && here.before() != ' ' && here.take('-'))
        }
    };
    if !parted {
        return None;
    }
    here.skip_space();
    let high = placed(here)?;
    here.skip_space();
    here.take('%');
    here.skip_space();
    let close = here.take_one_of(")]");
    if bracket.is_some() && close.is_none() {
        return None;
    }
    let ends = !here.peek().is_alphanumeric() || here.before() == ' ';
    ends.then_some((low, high))
}

/// Most characters from the level to the limits.
const FARTHEST: usize = 30;

/// An interval behind `95% CI` or `95 % confidence interval`.
fn named_interval(chars: &[char], at: usize) -> Option<MadeInterval> {
    let mut here = Scanner::new(chars, at);
    if here.before().is_alphanumeric() {
        return None;
    }
    let named = ["CIs", "CI", "C.I.", "confidence interval", "confidence limits", "KI", "Konfidenzintervall"];
    named.iter().any(|name| here.take_text(name)).then_some(())?;
    if here.peek().is_alphabetic() {
        return None;
    }
    let (level, start) = level_before(chars, at)?;
    let end = here.at;
    // Only marks and short words stand between the name and the limits.
    let (low, high) = loop {
        let mut candidate = here;
        let c = here.peek();
        if here.at > end + FARTHEST || c == PARAGRAPH || c == '±' {
            return None;
        }
        if (c.is_ascii_digit() || "([-.–".contains(c))
            && let Some(limits) = limits(&mut candidate)
        {
            break limits;
        }
        if c.is_ascii_digit() {
            return None;
        }
        if c.is_alphabetic() {
            if !["of", "is", "was", "from", "between", "ranges", "ranging", "at", "as", "the"]
                .contains(&here.word().as_str())
            {
                return None;
            }
            continue;
        }
        here.at += 1;
    };
    let (estimate, margin) = estimate_before(chars, start)?;
    let error = margin.map(|error| (error, None)).or_else(|| standard_error(chars, estimate.start, high.end));
    let margins = match error {
        Some((error, df)) => {
            let p = 1.0 - level / 100.0;
            let quantiles = [Some(normal_quantile(p)), df.map(|df| student_quantile(p, df))];
            quantiles.into_iter().flatten().map(|q| [error.low().max(0.0) * q, error.high() * q]).collect()
        }
        None => Vec::new(),
    };
    Some(MadeInterval { estimate, margins, has_margin: false, low, high, start })
}

/// The level in per cent before the name of an interval, and where it begins.
fn level_before(chars: &[char], at: usize) -> Option<(f64, usize)> {
    let mut end = at;
    while end > 0 && matches!(chars[end - 1], ' ' | '-' | '(') {
        end -= 1;
    }
    let percent = end.checked_sub(1).filter(|at| chars[*at] == '%')?;
    let level = number_before(chars, percent)?;
    (50.0..100.0).contains(&level.number.value).then_some((level.number.value, level.start))
}

/// The number directly before the level, if it is an estimate by its name, and what stands behind ± beside it.
fn estimate_before(chars: &[char], level: usize) -> Option<(Placed, Option<PrintedNumber>)> {
    let mut end = level;
    // Marks, and a unit.
    while end > 0 && matches!(chars[end - 1], ' ' | '(' | '[' | ',' | ';') {
        end -= 1;
    }
    // A standard error may stand between the two.
    for _ in 0..3 {
        let unit =
            (0..end).rev().take(10).take_while(|at| chars[*at].is_alphabetic() || "/%".contains(chars[*at])).count();
        let mut before = end - unit;
        while before > 0 && chars[before - 1] == ' ' {
            before -= 1;
        }
        let estimate = number_before(chars, before)?;
        let mut name = estimate.start;
        while name > 0 && " =≈<>:".contains(chars[name - 1]) {
            name -= 1;
        }
        if name > 0 && chars[name - 1] == '±' {
            return Some((number_before(chars, name - 1)?, Some(estimate.number)));
        }
        let word = (0..name)
            .rev()
            .take(12)
            .take_while(|at| chars[*at].is_alphabetic() || chars[*at] == '.')
            .map(|at| chars[at]);
        let word: String = word.collect::<Vec<_>>().into_iter().rev().collect();
        let mut start = name - word.chars().count();
        // So may a test statistic.
        let open = (0..name).rev().take(12).find(|at| chars[*at] == '(').filter(|_| name > 0 && chars[name - 1] == ')');
        let tested = open.and_then(|open| open.checked_sub(1)).filter(|at| "tz".contains(chars[*at]));
        start = tested.unwrap_or(start);
        if matches!(word.as_str(), "SE" | "S.E." | "s.e." | "t" | "z") || tested.is_some() {
            end = start;
            while end > 0 && matches!(chars[end - 1], ' ' | '(' | '[' | ',' | ';') {
                end -= 1;
            }
            continue;
        }
        // A part of a whole.
        let before_word = chars[..start].iter().rev().find(|c| **c != ' ');
        if word == "of" && before_word.is_some_and(char::is_ascii_digit) {
            return None;
        }
        const OTHERS: [&str; 15] =
            ["p", "P", "t", "z", "F", "n", "N", "df", "SD", "SEM", "s", "k", "to", "and", "value"];
        // Nor is a standard error that is called so.
        let near: String = chars[name.saturating_sub(40)..name].iter().collect();
        if ["standard error", "standard deviation"].iter().any(|words| near.contains(words)) {
            return None;
        }
        // A range, a power or a test is no estimate.
        let outside = name.checked_sub(1).map_or(' ', |at| chars[at]);
        let is_other = OTHERS.contains(&word.as_str()) || ")]–^\u{1}×/+-".contains(outside);
        return (!is_other).then_some((estimate, None));
    }
    None
}

/// The standard error near an interval, with degrees of freedom if some are near.
fn standard_error(chars: &[char], from: usize, to: usize) -> Option<(PrintedNumber, Option<f64>)> {
    const AROUND: usize = 60;
    let sentence = from.saturating_sub(AROUND)..(to + AROUND).min(chars.len());
    let (mut error, mut freedom, mut errors) = (None, None, 0);
    for at in sentence {
        let mut here = Scanner::new(chars, at);
        if here.before().is_alphanumeric() {
            continue;
        }
        if ["SE", "S.E.", "s.e.", "standard error"].iter().any(|name| here.take_text(name))
            && !here.peek().is_alphabetic()
        {
            here.take_text("_");
            here.word();
            here.skip_space();
            here.take_one_of("=:");
            here.skip_space();
            if let Some(number) = here.number(Comma::Parts).filter(|number| number.value > 0.0) {
                errors += 1;
                error = Some(number);
            }
        } else if here.take('t') && here.take('(') {
            freedom = here.number(Comma::Parts).map(|number| number.value).filter(|_| here.peek() == ')').or(freedom);
        } else if here.take_text("df") {
            here.skip_space();
            here.take('=');
            here.skip_space();
            freedom = here.number(Comma::Parts).map(|number| number.value).filter(|df| *df > 0.0).or(freedom);
        }
    }
    error.filter(|_| errors == 1).map(|error| (error, freedom))
}
