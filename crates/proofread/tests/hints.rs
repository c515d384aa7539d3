//! How often a hint is right: slips of many kinds are planted in right chains, and the hint should take the slip back or be withheld.
//!
//! The seeds below 100 were looked at while the rules were made, and those from 100 on were not. `--nocapture` shows the table.

use crate::{readme, report};
use proofread::{CheckOptions, NamePolicy, ReportSection, TextFormat, proofread};
use std::ops::Range;

const RIGHT: &str = include_str!("../judged/right-chains.csv");

/// Whether a difference in numbers is on this list, certain or not.
fn is_difference(list: ReportSection) -> bool {
    matches!(list, ReportSection::Numbers | ReportSection::LessCertain)
}

#[derive(serde::Deserialize)]
struct RightChain {
    #[allow(dead_code, reason = "the column says where a chain belongs")]
    subject: String,
    tex: String,
}

fn right_chains() -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(RIGHT.as_bytes());
    reader.deserialize().map(|row: Result<RightChain, _>| row.expect("a row").tex).collect()
}

/// The kinds of slips.
const KINDS: [&str; 16] = [
    "digit of the result",
    "digit of an operand",
    "swap in the result",
    "swap in an operand",
    "sign",
    "digit lost in the result",
    "digit lost in an operand",
    "digit too many",
    "point of the result",
    "point of an operand",
    "exponent of ten",
    "factor 2",
    "prefix of the unit",
    "another operand",
    "another factor",
    "another result",
];

/// A chain with a slip.
struct Planted {
    text: String,
    /// Words of hints that take it back; none if no single edit does.
    takes_back: Vec<String>,
    /// Where it was planted; empty if it may be anywhere.
    place: Range<usize>,
}

/// The numbers in a formula that are no exponents, and whether each is in the result.
fn numerals(tex: &str) -> Vec<(Range<usize>, bool)> {
    let result = tex.rfind(" = ").map_or(tex.len(), |at| at + 3);
    let bytes = tex.as_bytes();
    let (mut out, mut at, mut depth) = (Vec::new(), 0, 0);
    while at < bytes.len() {
        match bytes[at] {
            b'^' if bytes.get(at + 1) == Some(&b'{') => depth = 1,
            b'}' => depth = 0,
            b'0'..=b'9' if depth == 0 => {
                let length = bytes[at..].iter().take_while(|byte| byte.is_ascii_digit() || **byte == b'.').count();
                let range = at..at + length;
                let is_exponent = tex[..at].ends_with('^');
                let is_ten = &tex[range.clone()] == "10" && tex[range.end..].starts_with('^');
                let is_index = tex[..at].ends_with(r"\frac");
                if !is_exponent && !is_ten && !is_index {
                    out.push((range.clone(), at >= result));
                }
                at = range.end;
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    out
}

fn is_number(text: &str) -> bool {
    let leads = text.starts_with('0') && text.as_bytes().get(1).is_some_and(u8::is_ascii_digit);
    !leads && !text.starts_with('.') && !text.ends_with('.') && text.contains(|c| ('1'..='9').contains(&c))
}

/// Plants a slip of a kind; none if the chain has no place for it.
fn plant(tex: &str, kind: usize, dice: &mut fastrand::Rng) -> Option<Planted> {
    let before = "It is $";
    let name = KINDS[kind];
    let numbers = numerals(tex);
    let of = |result: bool| {
        numbers.iter().filter(|(_, of)| *of == result).map(|(range, _)| range.clone()).collect::<Vec<_>>()
    };
    let in_result = match name {
        "digit too many" => dice.bool(),
        _ => name.contains("result") || matches!(name, "sign" | "factor 2" | "another factor"),
    };
    let ranges: Vec<Range<usize>> = of(in_result)
        .into_iter()
        .filter(|range| in_result || (range.len() > 1 && !tex[range.clone()].eq("10")))
        .collect();
    let edited = |range: Range<usize>, new: &str, takes_back: Vec<String>| {
        let text = format!("{before}{}{new}{}$.", &tex[..range.start], &tex[range.end..]);
        let place = before.len() + range.start..before.len() + range.start + new.len();
        Some(Planted { text, takes_back, place })
    };
    let numeral = |range: Range<usize>, new: String| {
        let old = &tex[range.clone()];
        if new == old || !is_number(&new) {
            return None;
        }
        let words = vec![format!("`{old}` for `{new}`")];
        edited(range, &new, words)
    };
    if name == "exponent of ten" {
        let starts: Vec<usize> = tex.match_indices("10^{").map(|(at, _)| at).collect();
        let at = *starts.get(dice.usize(0..starts.len().max(1)))? + 4;
        let end = at + tex[at..].find('}')?;
        let old: i32 = tex[at..end].parse().ok()?;
        let new = if dice.bool() { -old } else { old + [-1, 1][dice.usize(0..2)] };
        let words = format!("`10^{old}` for `10^{new}`").replace('-', "−");
        return edited(at - 4..end, &format!("10^{{{new}"), vec![words]).filter(|_| new != 0);
    }
    if name == "prefix of the unit" {
        let at = tex.rfind(r"\mathrm{").filter(|at| Some(*at) > tex.rfind(" = "))? + 8;
        let old = &tex[at..at + tex[at..].find('}')?];
        let pairs = [
            ("m/s", "km/s"),
            ("N", "kN"),
            ("J", "kJ"),
            ("kJ", "J"),
            ("mA", "A"),
            ("W", "mW"),
            ("C", "mC"),
            ("mol", "mmol"),
            ("J/K", "kJ/K"),
            ("Ω", "kΩ"),
        ];
        let new = pairs.iter().find(|(of, _)| *of == old)?.1;
        let first = |unit: &str| unit.split('/').next().unwrap_or_default().to_owned();
        let words = format!("`{}` for `{}`", first(old), first(new));
        return edited(at..at + old.len(), new, vec![words]);
    }
    let range = ranges.get(dice.usize(0..ranges.len().max(1)))?.clone();
    let old = &tex[range.clone()];
    let digits: Vec<usize> = old.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(at, _)| at).collect();
    let at = digits[dice.usize(0..digits.len())];
    let digit = |dice: &mut fastrand::Rng| char::from(b'0' + dice.u8(0..10));
    let like = |value: f64| {
        let decimals = old.split_once('.').map_or(0, |(_, behind)| behind.len());
        format!("{value:.decimals$}")
    };
    match name {
        "digit of the result" | "digit of an operand" => {
            numeral(range, format!("{}{}{}", &old[..at], digit(dice), &old[at + 1..]))
        }
        "swap in the result" | "swap in an operand" => {
            let next = old.as_bytes().get(at + 1).filter(|next| next.is_ascii_digit())?;
            let new = format!("{}{}{}{}", &old[..at], char::from(*next), &old[at..=at], &old[at + 2..]);
            numeral(range, new)
        }
        "sign" => {
            let words = vec!["the opposite sign on one of the two sides".to_owned()];
            match tex[..range.start].strip_suffix('-') {
                Some(start) if start.ends_with("= ") => edited(start.len()..range.end, old, words),
                _ => edited(range.clone(), &format!("-{old}"), words),
            }
        }
        "digit lost in the result" | "digit lost in an operand" => {
            (digits.len() > 2).then(|| numeral(range, format!("{}{}", &old[..at], &old[at + 1..])))?
        }
        "digit too many" => {
            let more = if dice.bool() { '0' } else { char::from(old.as_bytes()[at]) };
            numeral(range, format!("{}{more}{}", &old[..at], &old[at..]))
        }
        "point of the result" | "point of an operand" => {
            let point = old.find('.')?;
            let plain = old.replace('.', "");
            let new = if dice.bool() { point.checked_sub(1)? } else { point + 1 };
            let (whole, behind) = plain.split_at_checked(new)?;
            let whole = whole.trim_start_matches('0');
            let whole = if whole.is_empty() { "0" } else { whole };
            numeral(range, format!("{whole}.{behind}").trim_end_matches('.').to_owned())
        }
        "factor 2" => {
            let value: f64 = old.parse().ok()?;
            let new = like(if dice.bool() { value * 2.0 } else { value / 2.0 });
            let words = vec!["a factor 2 on one of the two sides".to_owned(), format!("`{old}` for `{new}`")];
            edited(range, &new, words).filter(|_| is_number(&new))
        }
        "another operand" | "another result" => {
            let new: String = old.chars().map(|c| if c.is_ascii_digit() { digit(dice) } else { c }).collect();
            let differing = old.chars().zip(new.chars()).filter(|(a, b)| a != b).count();
            edited(range, &new, vec![format!("`{old}` for `{new}`")]).filter(|_| differing > 1 && is_number(&new))
        }
        _ => {
            let value: f64 = old.parse().ok()?;
            let by = [3.0, 4.0, std::f64::consts::PI, 1.0 / 3.0, 0.25, 9.81, 1.5][dice.usize(0..7)];
            let new = like(value * by);
            edited(range, &new, vec![format!("`{old}` for `{new}`")]).filter(|_| is_number(&new))
        }
    }
}

/// What became of the slips of a kind: planted where it is noticed, hints given, and hints that take the slip back.
#[derive(Clone, Copy, Default)]
struct Counts {
    noticed: usize,
    given: usize,
    right: usize,
}

/// One slip in each chain with this seed.
fn measure(seed: u64, show: bool) -> [Counts; KINDS.len()] {
    let options = CheckOptions { name_policy: NamePolicy::Never, ..CheckOptions::default() };
    let mut counts = [Counts::default(); KINDS.len()];
    let mut dice = fastrand::Rng::with_seed(seed);
    for tex in right_chains() {
        let planted = (0..20).find_map(|_| {
            let kind = dice.usize(0..KINDS.len());
            plant(&tex, kind, &mut dice).map(|planted| (kind, planted))
        });
        let Some((kind, planted)) = planted else { continue };
        let findings = proofread(&planted.text, TextFormat::Markdown, options).expect("a short text").findings;
        let Some(finding) = findings.iter().find(|of| is_difference(of.section)) else { continue };
        let count = &mut counts[kind];
        count.noticed += 1;
        let Some(hint) = &finding.hint else { continue };
        count.given += 1;
        let at = hint.at.range();
        let is_there = at.start < planted.place.end && planted.place.start < at.end || hint.words.contains("two sides");
        if is_there && planted.takes_back.contains(&hint.words) {
            count.right += 1;
        } else if show {
            println!("{}: {} -> {}, not {:?}", KINDS[kind], planted.text, hint.words, planted.takes_back);
        }
    }
    counts
}

/// The counts of several seeds together, with a table of the kinds.
fn measured(seeds: Range<u64>, show: bool) -> Counts {
    let mut all = [Counts::default(); KINDS.len()];
    for seed in seeds {
        for (sum, of) in all.iter_mut().zip(measure(seed, show)) {
            *sum =
                Counts { noticed: sum.noticed + of.noticed, given: sum.given + of.given, right: sum.right + of.right };
        }
    }
    for (kind, of) in KINDS.iter().zip(all) {
        println!("{kind:26} {:5} noticed {:5} given {:5} right", of.noticed, of.given, of.right);
    }
    let sum = |of: fn(&Counts) -> usize| all.iter().map(of).sum();
    Counts { noticed: sum(|of| of.noticed), given: sum(|of| of.given), right: sum(|of| of.right) }
}

#[test]
fn nine_of_ten_hints_take_the_slip_back() {
    let seeds = match std::env::var("SEEDS").ok().and_then(|seeds| seeds.parse().ok()) {
        Some(first) => first..first + 4,
        None => 100..101,
    };
    let all = measured(seeds, std::env::var_os("SHOW").is_some());
    println!("{} of {} hints are right, of {} slips", all.right, all.given, all.noticed);
    if std::env::var_os("SEEDS").is_none() {
        let told = format!("{} of {} hints took the slip back, for {} slips", all.right, all.given, all.noticed);
        assert!(readme().contains(&told), "README.md does not say: {told}");
    }
    assert!(all.noticed >= 200 && 5 * all.given >= 2 * all.noticed, "{} hints for {} slips", all.given, all.noticed);
    assert!(10 * all.right >= 9 * all.given, "{} of {} hints are right", all.right, all.given);
}

#[test]
fn no_hint_is_given_where_a_side_was_copied_or_a_whole_sum_differs() {
    let hint = |text: &str| report(text, TextFormat::Markdown).findings[0].hint.is_some();
    assert!(!hint("$200 + 50 = 200$"));
    assert!(!hint(r"$\sqrt{8^2 + 6^2 + 2^2} = 11.00$"));
    assert!(hint(r"$\sqrt{8^2 + 6^2 + 2^2} = 10.189$"));
}
