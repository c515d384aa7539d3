//! What is told of a difference: printed and recomputed in one unit, never by the same characters, and what is told is right.

use crate::report;
use proofread::{ChainFinding, ChainVerdict, CheckOptions, ReportSection, TextFormat, proofread};

fn findings(text: &str) -> Vec<ChainFinding> {
    let options = CheckOptions { hints: 0, agreeing: true, ..CheckOptions::default() };
    proofread(text, TextFormat::Markdown, options).expect("a short text").findings
}

/// The values of the first finding that does not agree, in words.
fn told(tex: &str) -> String {
    let found = findings(&format!("It is ${tex}$."));
    let first = found.iter().find(|of| of.section != ReportSection::Agreeing);
    first.map_or_else(|| "nothing".to_owned(), ChainFinding::values_in_words)
}

#[test]
fn both_sides_are_told_in_one_unit() {
    let expected = [
        (r"0.6 \times 200 = 150\text{ million}", "printed 150 million, recomputed 120 (a factor of 1,250,000)"),
        (r"0.6 \times 200 = 12\text{ thousand}", "printed 12 thousand, recomputed 0.12 thousand (a factor of 100)"),
        (r"2\,\mathrm{m} \cdot 3 = 6\,\mathrm{cm}", "printed 6 cm, recomputed 6 m (the units differ)"),
        (r"2\,\mathrm{m} \cdot 3 = 60\,\mathrm{cm}", "printed 60 cm, recomputed 600 cm (a factor of 10)"),
        (r"\tan 31.0^\circ = 0.609", "printed 0.609, recomputed 0.601"),
        (r"\arcsin 0.500 = 35.0^\circ", "printed 35.0°, recomputed 30.0°"),
        (r"3.0 \cdot 20 = -60", "printed −60, recomputed 60 (the sign differs)"),
        (r"3.0 \cdot 20 = -180", "printed −180, recomputed 60 (the sign differs, and a factor of 3)"),
        (r"12/48 = 22\%", "printed 22%, recomputed 25%"),
        (r"12/48 = 2.5\%", "printed 2.5%, recomputed 25% (a factor of 10)"),
        (r"\$1.25 \cdot 3 = \$4.75", "printed $4.75, recomputed $3.75"),
        (r"2.0\times10^{3} \cdot 3.0 = 6.0\times10^{5}", "printed 6.0 × 10^5, recomputed 6.0 × 10^3 (a factor of 100)"),
        (r"10^{3} \cdot 10^{4} = 10^{12}", "printed 10^12, recomputed 1.0 × 10^7 (a factor of 100,000)"),
        (r"1{,}250 \cdot 3 = 3{,}850", "printed 3,850, recomputed 3,750"),
        (r"1\frac12 + \frac14 = 1.85", "printed 1.85, recomputed 1.75"),
        (r"\frac12 + \frac14 = \frac23", "printed 2/3, recomputed 3/4 (0.75 against 0.667)"),
        (r"1\frac12 + \frac14 = 2\frac34", "printed 2 3/4, recomputed 1 3/4 (1.75 against 2.75, a factor of 1.57)"),
        (r"2 \cdot 3 + 1 = 4 + 4", "recomputed 7 against 8"),
        (r"\sqrt{-4} = 2", "printed 2, but the left side has no value"),
        (r"\frac{3}{0} = 3", "printed 3, but the left side has no value"),
        (r"2\,\mathrm{m} + 3\,\mathrm{s} = 5\,\mathrm{m}", "printed 5 m, but the units differ"),
        (
            r"2.0\,\mathrm{m} \cdot 3.0\,\mathrm{m} = 7.0\,\mathrm{s}",
            "printed 7.0 s, recomputed 6 m^2 (the dimensions differ)",
        ),
        (
            r"4.9\,\mathrm{m/s} \cdot 2.0\,\mathrm{s} = 9.8\,\mathrm{m/s}",
            "printed 9.8 m/s, recomputed 9.8 m (the units differ)",
        ),
        (r"5 \pm 2 = (3, 8)", "printed (3,8), recomputed (3, 7)"),
    ];
    let other: Vec<_> =
        expected.iter().map(|(tex, words)| (tex, told(tex), words)).filter(|(_, told, words)| told != *words).collect();
    assert!(other.is_empty(), "{other:#?}");
}

#[test]
fn a_last_digit_is_the_last_of_three() {
    let verdict = |tex: &str| findings(&format!("${tex}$")).first().map(|of| of.verdict);
    assert_eq!(verdict("43.4 - 29.8 = 13.7"), Some(ChainVerdict::LastDigit));
    for tex in ["2 + 2 = 5", "0.25 + 0.30 = 0.56", "-250 - 250 = -600"] {
        assert_eq!(verdict(tex), Some(ChainVerdict::Inconsistent), "{tex}");
    }
}

/// A chain of random numbers with a wrong result.
fn wrong_chain(dice: &mut fastrand::Rng) -> String {
    let number = |dice: &mut fastrand::Rng| match dice.u8(0..5) {
        0 => dice.u32(2..100).to_string(),
        1 => format!("{}.{}", dice.u32(0..100), dice.u32(1..10)),
        2 => format!("{}.{:02}", dice.u32(1..20), dice.u32(1..100)),
        3 => format!("0.{:03}", dice.u32(101..1000)),
        _ => dice.u32(100..3000).to_string(),
    };
    let (one, other) = (number(dice), number(dice));
    let value = |text: &str| text.parse::<f64>().expect("a number");
    let (sign, result) = match dice.u8(0..4) {
        0 => ("+", value(&one) + value(&other)),
        1 => (r"\cdot", value(&one) * value(&other)),
        2 => ("/", value(&one) / value(&other)),
        _ => ("-", value(&one) - value(&other)),
    };
    let wrong = match dice.u8(0..7) {
        0 => result * 1000.0,
        1 => result / 10.0,
        2 => -result,
        3 => result * 2.0,
        4 => result * 1.07,
        5 => result + 1.0,
        _ => result * dice.f64() * 3.0,
    };
    let places = dice.usize(0..5);
    let (unit, in_unit) = [
        ("", ""),
        (r"\,\mathrm{m}", r"\,\mathrm{m}"),
        (r"\,\mathrm{m}", r"\,\mathrm{km}"),
        (r"\,\mathrm{min}", r"\,\mathrm{s}"),
        ("", r"\%"),
        ("", r"\text{ million}"),
        ("", r"^\circ"),
        (r"\,\mathrm{kg}", r"\,\mathrm{s}"),
        ("", r"\times10^{-3}"),
    ][dice.usize(0..9)];
    let other_unit = if matches!(sign, "+" | "-") { unit } else { "" };
    format!("{one}{unit} {sign} {other}{other_unit} = {wrong:.places$}{in_unit}")
}

/// Text as it is shown, as TeX.
fn in_tex(shown: &str) -> String {
    let mut text = shown.replace('−', "-").replace('×', r"\times").replace('%', r"\%").replace('°', r"^\circ");
    if let Some((before, power)) = text.clone().split_once("10^") {
        let end = power.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(power.len());
        text = format!("{before}10^{{{}}}{}", &power[..end], &power[end..]);
    }
    match text.split_once(' ') {
        Some((number, unit)) => format!(r"{number}\text{{ {unit}}}"),
        None => text,
    }
}

#[test]
fn printed_and_recomputed_never_look_alike_and_the_recomputed_agrees() {
    let mut dice = fastrand::Rng::with_seed(20_261_129);
    let (mut told, mut tried, mut disagreeing) = (0, 0, Vec::new());
    for _ in 0..6000 {
        let tex = wrong_chain(&mut dice);
        let text = format!("It is ${tex}$.");
        for of in findings(&text).iter().filter(|of| of.section != ReportSection::Agreeing) {
            told += 1;
            let Some(recomputed) = &of.recomputed else {
                assert!(of.difference.is_some() || of.why.is_some(), "{tex}: nothing is told");
                continue;
            };
            let squeezed = |text: &str| text.replace(' ', "");
            assert_ne!(squeezed(&of.printed), squeezed(recomputed), "{tex}");
            if let Some((one, other)) = recomputed.split_once(" against ") {
                assert_ne!(one, other, "{tex}");
                continue;
            }
            // In another unit it can't stand in the place of the printed one.
            if matches!(of.verdict, ChainVerdict::Units | ChainVerdict::Dimensions)
                || of.printed.starts_with(['0', '−']) && of.factor.is_none()
            {
                continue;
            }
            tried += 1;
            let mut mended = text.clone();
            mended.replace_range(of.at.start as usize..text.len() - 2, &in_tex(recomputed));
            let agrees = findings(&mended).iter().all(|of| of.section == ReportSection::Agreeing);
            if !agrees || findings(&mended).is_empty() {
                disagreeing.push(format!("{text} -> {mended} ({})", of.values_in_words()));
            }
        }
    }
    assert!(told > 3000 && tried > 2000, "{told} findings, {tried} tried");
    assert!(
        disagreeing.is_empty(),
        "{} of {tried}: {:#?}",
        disagreeing.len(),
        &disagreeing[..disagreeing.len().min(12)]
    );
}

#[test]
fn a_value_far_below_the_printed_one_is_shown_as_it_is() {
    let found =
        report(r"$6.63 \times 10^{-34} \times 480 \times 10^{-9} = 3.2 \times 10^{40}$", TextFormat::Latex).findings;
    assert_eq!(found[0].recomputed.as_deref(), Some("3.2 × 10^−40"));
}

#[test]
fn what_was_not_read_is_shown_as_dots_and_commands_keep_their_names() {
    let shown =
        |text: &str| report(text, TextFormat::Latex).findings.into_iter().map(|of| of.chain).collect::<Vec<_>>();
    assert_eq!(shown(r"$3 \times 1.2\times 10^12 = 4$"), ["3 × 1.2 × 10^1 2 = 4"]);
    assert_eq!(shown(r"$\log_3(2) = 0.7$"), ["log_3 (2) = 0.7"]);
    assert_eq!(shown(r"$\quux x = 2 \cdot 3 = 7$"), [r"\quux x = 2·3 = 7"]);
}

#[test]
fn limits_with_pi_are_no_degrees() {
    let found = report(r"$$\left[x+\sin x\right]_0^{2\pi} = 6.5$$", TextFormat::Markdown).findings;
    assert_eq!(found[0].recomputed.as_deref(), Some("6.3"));
}
