//! Plants errors of one digit in documents and counts how many are noticed: `plant FILE…`.
//!
//! Each pair of sides that agrees is tried twice: once with one digit of its result changed, once with one digit of an
//! operand. The digit is changed in the text itself, so the readers are tried, too. An error is invisible if the side with the
//! changed digit still gives the printed digits of the result, with all numbers as printed: nobody who has only these digits can
//! see it. An error that is only a doubt isn't noticed; one that is less certain is, and is counted by its cause. Each pair has its own dice, so that the digits don't depend on what happens to other pairs. `SEED` chooses other digits,
//! `EVERY` tries one of so many pairs, and `SHOW` lists what stays unseen.

use proofread::{Caveat, ChainVerdict, CheckOptions, NamePolicy, ReportSection, Span, TextFormat, proofread};
use std::collections::BTreeMap;

/// Numbers that look random and are the same each time.
struct Dice(u64);

impl Dice {
    /// The dice of one side.
    fn of(seed: u64, path: &str, side: Span) -> Self {
        let bytes = path.rsplit("modules/").next().unwrap_or(path).bytes().map(u64::from);
        let mut dice = Self(seed);
        for part in bytes.chain([side.start.into(), side.end.into()]) {
            dice.0 ^= part;
            dice.below(1);
        }
        dice
    }

    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n.max(1)
    }
}

/// The digits of a stretch of text that are not inside a tag or a command, nor an exponent of TeX.
fn digits(text: &str, span: Span) -> Vec<usize> {
    let (mut inside, mut out) = (false, Vec::new());
    for (at, c) in text[span.range()].char_indices() {
        match c {
            '<' => inside = true,
            '>' => inside = false,
            c if c.is_ascii_digit() && !inside => out.push(span.start as usize + at),
            _ => {}
        }
    }
    out
}

/// What a cause is called in the counts.
fn name_of(caveat: Option<Caveat>) -> &'static str {
    match caveat {
        Some(Caveat::Uncomputed) => "nothing computed",
        Some(Caveat::Short) => "short",
        Some(Caveat::Slight) => "slight",
        Some(Caveat::Share { .. }) => "a third of the document differs",
        None => "no cause",
    }
}

fn main() {
    let options = CheckOptions { name_policy: NamePolicy::Never, agreeing: true, hints: 0, ..CheckOptions::default() };
    let seed = std::env::var("SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(11);
    let every = std::env::var("EVERY").ok().and_then(|every| every.parse().ok()).unwrap_or(1);
    let mut counts = [[0usize; 3]; 2];
    let mut less_certain: BTreeMap<&str, usize> = BTreeMap::new();
    for path in std::env::args().skip(1) {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let Some(format) = path.rsplit('.').next().and_then(TextFormat::from_extension) else { continue };
        let Ok(report) = proofread(&text, format, options) else { continue };
        for pair in report.findings.iter().filter(|pair| pair.section == ReportSection::Agreeing).step_by(every) {
            for (which, side) in [(0, pair.right_span), (1, pair.left_span)] {
                let is_result = pair.at == side;
                if which == usize::from(is_result) {
                    continue;
                }
                let places = digits(&text, side);
                if places.is_empty() {
                    continue;
                }
                let mut dice = Dice::of(seed, &path, side);
                let at = places[dice.below(places.len())];
                let old = text.as_bytes()[at] - b'0';
                let leading = !text[..at].ends_with(|c: char| c.is_ascii_digit() || c == '.');
                let new = (old + 1 + dice.below(9) as u8) % 10;
                if leading && new == 0 {
                    continue;
                }
                let mut changed = text.clone();
                changed.replace_range(at..=at, &new.to_string());
                // Whether a difference is certain depends on its hint.
                let hinted = CheckOptions { hints: CheckOptions::default().hints, ..options };
                let Ok(after) = proofread(&changed, format, hinted) else { continue };
                let here =
                    |of: &&proofread::ChainFinding| of.left_span == pair.left_span && of.right_span == pair.right_span;
                let seen = after
                    .findings
                    .iter()
                    .any(|of| here(&of) && !matches!(of.section, ReportSection::Agreeing | ReportSection::Doubts));
                let found = after.findings.iter().find(here);
                if let Some(apart) = found.filter(|of| of.section == ReportSection::LessCertain) {
                    *less_certain.entry(name_of(apart.caveat)).or_default() += 1;
                    if std::env::var_os("SHOW").is_some() {
                        println!("less certain, {}: {}", name_of(apart.caveat), apart.chain);
                    }
                }
                let invisible = !seen
                    && found.is_some_and(|of| of.verdict == ChainVerdict::Consistent && of.reading == pair.reading);
                if !seen && std::env::var_os("SHOW").is_some() {
                    let [a, b] = [pair.left.as_str(), pair.right.as_str()];
                    let name = ["result", "operand"][which];
                    match found {
                        None => println!("{name}, unread: {a} = {b} -> {new}"),
                        Some(of) => {
                            let class = if invisible { "invisible" } else { of.verdict.name() };
                            println!("{name}, {class}: {a} = {b} -> {} = {} ({:?})", of.left, of.right, of.recomputed);
                        }
                    }
                }
                counts[which][0] += 1;
                counts[which][1] += usize::from(seen);
                counts[which][2] += usize::from(invisible);
            }
        }
    }
    for (name, [tried, seen, invisible]) in ["results", "operands"].iter().zip(counts) {
        let share = |of: usize| 100.0 * seen as f64 / of.max(1) as f64;
        let visible = tried - invisible;
        println!(
            "{name}: {seen} of {tried} noticed ({:.1} %), of {visible} visible ones ({:.1} %)",
            share(tried),
            share(visible)
        );
    }
    let noticed: usize = counts.iter().map(|count| count[1]).sum();
    let apart: usize = less_certain.values().sum();
    let causes: Vec<String> = less_certain.iter().map(|(cause, count)| format!("{count} {cause}")).collect();
    println!(
        "less certain: {apart} of {noticed} noticed ({:.1} %): {}",
        100.0 * apart as f64 / noticed.max(1) as f64,
        causes.join(", ")
    );
}
