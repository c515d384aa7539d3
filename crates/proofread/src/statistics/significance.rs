//! A p-value beside the test statistic that it was computed from.
//!
//! A reported p agrees if some statistic that is printed so has a p that is printed so; the rule is that of the program statcheck.

use super::characters::{PARAGRAPH, PlainCharacters};
use super::scanner::{Comma, PrintedNumber, Scanner};
use super::test_statistic::{Comparison, TestKind, TestStatistic, comparison, test_statistic};
use super::{Judged, Outcome};
use crate::judge::doubt::Doubt;
use std::ops::Range;

/// A p-value as it is printed.
struct PrintedP {
    comparison: Comparison,
    number: PrintedNumber,
    range: Range<usize>,
}

/// What the document says about its tests.
pub(super) struct TestContext {
    one_sided: bool,
    /// Whether p-values may be those of fewer degrees of freedom than are printed, as repeated measures need them.
    corrects_freedom: bool,
    /// Whether p-values may be adjusted for several comparisons.
    compares_several: bool,
}

impl TestContext {
    pub(super) fn of(plain: &PlainCharacters) -> Self {
        let text: String = plain.chars.iter().collect::<String>().to_lowercase().replace('-', " ");
        let has = |words: &[&str]| words.iter().any(|word| text.contains(word));
        Self {
            one_sided: has(&[
                "one sided",
                "onesided",
                "one tailed",
                "onetailed",
                "1 sided",
                "1 tailed",
                "directional",
                "einseitig",
                "upper tail",
                "lower tail",
                "left tailed",
                "right tailed",
                "right tail",
                "left tail",
            ]) || has_directed_hypothesis(&text),
            corrects_freedom: has(&["geisser", "huynh", "sphericity"]),
            compares_several: has(&["bonferroni", "holm", "pairwise", "post hoc", "posthoc", "multiple comparison"]),
        }
    }
}

/// Whether the text around a place speaks of p-values that do not follow from the statistic alone.
fn is_near_adjustment(chars: &[char], at: usize) -> bool {
    const AROUND: usize = 300;
    let around = chars.get(at.saturating_sub(AROUND)..(at + AROUND).min(chars.len())).unwrap_or_default();
    let text: String = around.iter().collect::<String>().to_lowercase();
    ADJUSTED.iter().any(|word| text.contains(word))
}

/// Numbers of tests for which a p-value is multiplied.
const MULTIPLES: [f64; 2] = [2.0, 3.0];

/// Words for p-values that are not those of the statistic beside them.
const ADJUSTED: [&str; 20] = [
    "bonferroni",
    "holm",
    "tukey",
    "adjusted",
    "corrected p",
    "correction",
    "fdr",
    "false discovery",
    "permutation",
    "bootstrap",
    "monte carlo",
    "exact test",
    "exact p",
    "randomisation",
    "randomization",
    "simulat",
    "greenhouse",
    "huynh",
    "šidák",
    "sidak",
];

fn has_directed_hypothesis(text: &str) -> bool {
    ["h_1", "h_a", "h1", "ha:", "h_{a}", "h_{1}"].iter().any(|name| {
        text.match_indices(name).take(100).any(|(at, _)| {
            let rest: String =
                text[at + name.len()..].chars().take(40).take_while(|c| *c != PARAGRAPH && *c != ',').collect();
            rest.contains(['<', '>'])
        })
    })
}

/// Checks each p-value that stands behind a statistic; the answer is where those are that were compared, each with its statistic.
pub(super) fn check(plain: &PlainCharacters, out: &mut Vec<Judged>) -> Vec<Range<usize>> {
    let context = TestContext::of(plain);
    let (mut at, mut checked) = (0, Vec::new());
    while at < plain.chars.len() {
        let found = "tFzZrQχXxcC".contains(plain.chars[at]).then(|| test_statistic(&plain.chars, at)).flatten();
        let Some(mut test) = found else {
            at += 1;
            continue;
        };
        let start = at;
        at = test.end;
        let Some(p) = p_value_behind(&plain.chars, &mut test) else { continue };
        if !test.is_complete() || p.number.value > 1.0 {
            continue;
        }
        checked.push(start..p.range.end);
        if let Some(judged) = judge(&test, &p, &context, &plain.chars, start) {
            out.push(judged);
        }
        at = p.range.end;
    }
    checked
}

/// Whether the digits agree, if the p-value of the statistic may be anything from `low` to `high`.
fn agrees(test: Comparison, p: &PrintedP, [low, high]: [f64; 2]) -> bool {
    let reported = p.number.value;
    let slack = 1e-12;
    match (test, p.comparison) {
        (Comparison::Equal, Comparison::Equal) => p.number.meets(low, high),
        (Comparison::Equal, Comparison::Less) => reported >= low - slack,
        (Comparison::Equal, Comparison::Greater) => reported <= high + slack,
        // A statistic below a bound has a p-value above another one.
        (Comparison::Less, Comparison::Equal) => p.number.high() >= high - slack,
        (Comparison::Less, Comparison::Less) => reported >= high - slack,
        (Comparison::Greater, Comparison::Equal) => p.number.low() <= low + slack,
        (Comparison::Greater, Comparison::Greater) => reported <= low + slack,
        (Comparison::Less, Comparison::Greater) | (Comparison::Greater, Comparison::Less) => true,
    }
}

fn judge(test: &TestStatistic, p: &PrintedP, context: &TestContext, chars: &[char], start: usize) -> Option<Judged> {
    let range = test.p_range();
    let is_impossible = p.comparison == Comparison::Less && p.number.value <= 0.0;
    if agrees(test.comparison, p, range) && !is_impossible {
        return None;
    }
    let halves = [range[0] / 2.0, range[1] / 2.0];
    let other = [1.0 - halves[1], 1.0 - halves[0]];
    let is_other_tail = test.has_two_sides() && p.comparison == Comparison::Equal && agrees(test.comparison, p, other);
    let is_one_sided =
        !is_impossible && p.comparison != Comparison::Greater && (agrees(test.comparison, p, halves) || is_other_tail);
    if is_one_sided && context.one_sided {
        return None;
    }
    let exact = test.p_value(test.value.value.abs());
    let digits = p.number.decimals.max(2);
    let mut recomputed = if exact < 0.5 * libm::pow(10.0, -(digits as f64)) {
        format!("p = {exact:.1e}").replace("e-", " × 10^−")
    } else {
        format!("p = {}", told_apart(exact, p.number.value, digits))
    };
    if test.has_two_sides() {
        recomputed += if is_one_sided { ", or half of it on one side" } else { " (two-sided)" };
    }
    let why = if is_one_sided {
        Some("it is the p-value of a one-sided test, and the text names none".to_owned())
    } else {
        let crosses = (p.comparison == Comparison::Equal || p.comparison == Comparison::Less)
            && (p.number.value <= 0.05) != (exact <= 0.05);
        let crosses = crosses || (p.comparison == Comparison::Greater && p.number.value >= 0.05 && exact <= 0.05);
        crosses.then(|| "the two are on different sides of 0.05".to_owned())
    };
    let is_one_sided = is_one_sided && test.comparison == Comparison::Equal;
    // The ratio of two variances is compared on both sides.
    let both_tails = [2.0 * range[0].min(1.0 - range[0]), 2.0 * range[1].min(1.0 - range[1])];
    let both_tails = [both_tails[0].min(both_tails[1]), both_tails[0].max(both_tails[1])];
    let is_of_variances = test.kind == TestKind::Fisher && !is_impossible && agrees(test.comparison, p, both_tails);
    // A correction that the methods name, pages before: of the degrees of freedom, p grows, and of several tests it is a multiple.
    let grows = p.comparison == Comparison::Equal && p.number.value > range[1];
    let is_multiple = |times: f64| agrees(test.comparison, p, range.map(|p| (times * p).min(1.0)));
    let is_corrected = test.kind == TestKind::Fisher
        && context.corrects_freedom
        && test.freedom.first().is_some_and(|first| *first > 1.0)
        && grows;
    let is_adjusted =
        context.compares_several && test.has_two_sides() && grows && MULTIPLES.into_iter().any(is_multiple);
    let is_other = is_one_sided || is_of_variances || is_corrected || is_adjusted;
    let outcome = match is_other || is_near_adjustment(chars, start) {
        true => Outcome::Doubt(Doubt::OtherTest),
        false if is_cut(test, p, exact) => Outcome::Doubt(Doubt::Truncated),
        false => Outcome::Difference,
    };
    Some(Judged { left: start..test.end, right: p.range.clone(), whole: start..p.range.end, recomputed, why, outcome })
}

/// Whether the p-value of the statistic as it is printed, on either side or on both, is cut off or rounded twice.
fn is_cut(test: &TestStatistic, p: &PrintedP, exact: f64) -> bool {
    let is_equal = test.comparison == Comparison::Equal && p.comparison == Comparison::Equal && p.number.value > 0.0;
    // Two digits say on which side of a bound it is.
    is_equal && p.number.decimals > 2 && p.number.is_cut_or_rounded_twice(exact)
}

/// A p-value with two digits behind its zeros or more, and with as many as it takes to tell it from the printed one.
fn told_apart(exact: f64, printed: f64, decimals: usize) -> String {
    const MOST: usize = 8;
    let written = |decimals: usize| format!("{exact:.decimals$}");
    let is_enough = |decimals: &usize| {
        let is_other = written(*decimals).parse::<f64>().is_ok_and(|value| value != printed);
        is_other && exact * libm::pow(10.0, *decimals as f64) >= 9.5
    };
    written((decimals..MOST).find(is_enough).unwrap_or(MOST))
}

/// Whether nanoseconds follow at once on the value of `t` with an index, which then is a time: `t_2 = 6 ns`.
fn is_time(chars: &[char], end: usize, unit: usize) -> bool {
    let is_indexed = chars[..end].iter().rev().take(LONGEST_TIME).take_while(|c| **c != 't').any(|c| *c == '_');
    is_indexed && chars[end..unit].iter().all(|c| c.is_whitespace())
}

/// Most characters of a time with an index.
const LONGEST_TIME: usize = 20;

/// Most characters between a statistic and its p-value.
const FARTHEST: usize = 160;

/// The p-value behind a statistic, with what is said about its degrees of freedom before and behind it.
fn p_value_behind(chars: &[char], test: &mut TestStatistic) -> Option<PrintedP> {
    let mut here = Scanner::new(chars, test.end);
    let mut is_direct = true;
    while here.at < test.end + FARTHEST && !here.is_at_end() {
        let c = here.peek();
        if c == PARAGRAPH {
            return None;
        }
        if c == '.' && here.ahead(1) == ' ' && here.ahead(2).is_uppercase() && here.ahead(2) != 'P' {
            return None;
        }
        if !c.is_alphanumeric() {
            // A number may begin with its point.
            let is_number = c == '.' && here.ahead(1).is_ascii_digit() && here.number(Comma::Groups).is_some();
            here.at += usize::from(!is_number);
            continue;
        }
        if c.is_ascii_digit() {
            number_in_gap(&mut here, test)?;
            is_direct = false;
            continue;
        }
        let start = here.at;
        let word = here.word();
        if word.is_empty() {
            // A digit of another script, or a fraction in one sign.
            return None;
        }
        match word.as_str() {
            "p" | "P" => {
                let p = printed_p(&mut here, start)?;
                if test.freedom.is_empty() {
                    freedom_behind(here, test);
                }
                return Some(p);
            }
            "ns" if is_time(chars, test.end, start) => return None,
            "ns" | "NS" if is_direct => return Some(not_significant(start..here.at)),
            "n" if is_direct && here.peek() == '.' && here.ahead(1) == 's' => {
                return Some(not_significant(start..here.at + 2));
            }
            "df" | "DF" | "ν" => freedom_named(&mut here, test)?,
            "d" if here.take_text(".f.") || here.take_text(".f") => freedom_named(&mut here, test)?,
            "n" | "N" => {
                here.skip_space();
                if here.take('=') {
                    here.skip_space();
                    test.observations = here.number(Comma::Groups).map(|number| number.value).or(test.observations);
                }
            }
            word if numeral(word).is_some() => {
                let count = numeral(word).unwrap_or_default();
                freedom_in_words(&mut here, count, test);
            }
            "t" | "F" | "z" | "Z" | "χ" | "U" | "W" | "T" | "H" => {
                // Another statistic has its own p-value.
                here.skip_space();
                if "=(^_[<>".contains(here.peek()) {
                    return None;
                }
            }
            "r" | "Q" if here.peek() == '(' => return None,
            word if word.chars().count() <= 3 || BETWEEN.contains(&word.to_lowercase().as_str()) => {}
            _ => return None,
        }
        is_direct = false;
    }
    None
}

/// Words that may stand between a statistic and its p-value.
const BETWEEN: [&str; 36] = [
    "with",
    "which",
    "gives",
    "giving",
    "yields",
    "yielding",
    "having",
    "degrees",
    "freedom",
    "tailed",
    "sided",
    "value",
    "values",
    "corresponding",
    "associated",
    "where",
    "and",
    "two",
    "both",
    "thus",
    "hence",
    "therefore",
    "respectively",
    "cohen",
    "cramer",
    "cramér",
    "partial",
    "from",
    "this",
    "that",
    "have",
    "has",
    "resulting",
    "whose",
    "probability",
    "leads",
];

fn not_significant(range: Range<usize>) -> PrintedP {
    let number = PrintedNumber { value: 0.05, half: 0.0, decimals: 2 };
    PrintedP { comparison: Comparison::Greater, number, range }
}

/// `p = .036`, `p-value 0.036`, `P < 0.05`, `p-value of 0.036`.
fn printed_p(here: &mut Scanner<'_>, start: usize) -> Option<PrintedP> {
    here.take_one_of("-– ");
    let named = here.take_text("values") || here.take_text("value") || here.take_text("val");
    here.skip_space();
    let comparison = match comparison(here) {
        Some(comparison) => comparison,
        None if named || here.ahead(0).is_ascii_digit() => {
            let words = ["of about", "of", "is about", "is", "was", "equals", "equal to"];
            words.iter().any(|word| here.take_text(word));
            here.skip_space();
            here.take('=');
            if !named { return None } else { Comparison::Equal }
        }
        None => return None,
    };
    here.skip_space();
    let number = here.number(Comma::Groups)?;
    // A computation, a unit or per cent.
    let mut behind = *here;
    behind.skip_space();
    // Digits behind a blank may belong to it: those of an exponent's base stand apart in a formula of an office file.
    let goes_on = "×+-±/%=^".contains(behind.peek()) || behind.peek().is_ascii_digit() || here.peek().is_alphanumeric();
    let is_probability = number.value >= 0.0 && !goes_on && number.decimals > 0;
    is_probability.then_some(PrintedP { comparison, number, range: start..here.at })
}

/// A number between the two, which may be of degrees of freedom.
fn number_in_gap(here: &mut Scanner<'_>, test: &mut TestStatistic) -> Option<()> {
    let Some(number) = here.number(Comma::Groups) else {
        here.at += 1;
        return Some(());
    };
    freedom_in_words(here, number.value, test);
    Some(())
}

/// Takes `degrees of freedom` or `df` behind a number.
fn freedom_in_words(here: &mut Scanner<'_>, count: f64, test: &mut TestStatistic) {
    let mut behind = *here;
    behind.skip_space();
    let named = ["degrees of freedom", "degree of freedom", "d.f.", "df"].iter().any(|word| behind.take_text(word));
    if named && test.freedom.is_empty() && count > 0.0 {
        test.freedom.push(count);
        *here = behind;
    }
}

/// Takes the numbers behind `df`.
fn freedom_named(here: &mut Scanner<'_>, test: &mut TestStatistic) -> Option<()> {
    here.take('_');
    here.take_one_of("12");
    here.skip_space();
    here.take_one_of("=:");
    here.skip_space();
    let given = !test.freedom.is_empty() && test.kind != TestKind::Fisher;
    let number = here.number(Comma::Parts)?;
    if given {
        return (test.freedom == [number.value]).then_some(());
    }
    test.freedom.push(number.value);
    let mut behind = *here;
    behind.take_one_of(",;");
    behind.skip_space();
    if test.kind == TestKind::Fisher
        && test.freedom.len() < 2
        && let Some(number) = behind.number(Comma::Parts)
        && number.is_whole()
    {
        test.freedom.push(number.value);
        *here = behind;
    }
    (test.freedom.len() <= 2).then_some(())
}

/// Degrees of freedom that are told behind the p-value.
fn freedom_behind(mut here: Scanner<'_>, test: &mut TestStatistic) {
    const FAR: usize = 40;
    let end = here.at + FAR;
    while here.at < end && !here.is_at_end() && !matches!(here.peek(), PARAGRAPH | '.' | '=') {
        if here.peek().is_ascii_digit() {
            match here.number(Comma::Groups) {
                Some(number) => freedom_in_words(&mut here, number.value, test),
                None => return,
            }
        } else if here.peek().is_alphabetic() {
            match here.word().as_str() {
                "df" | "DF" => {
                    let _ = freedom_named(&mut here, test);
                    return;
                }
                "on" | "with" | "and" | "for" | "at" | "degrees" | "of" | "freedom" => {}
                word => match numeral(word) {
                    Some(count) => freedom_in_words(&mut here, count, test),
                    None => return,
                },
            }
        } else {
            here.at += 1;
        }
    }
}

fn numeral(word: &str) -> Option<f64> {
    const NAMES: [&str; 10] = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
    NAMES.iter().position(|name| *name == word).map(|at| at as f64 + 1.0)
}
