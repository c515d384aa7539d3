//! Statistics and totals: p-values beside their tests, confidence intervals, shares in per cent, and sums in tables.

use proofread::{Doubt, ReportSection, StatisticsTally, TextFormat, find_statistics};

/// What is listed of a text: the printed numbers, with a question mark behind what is set aside.
#[track_caller]
fn listed(text: &str, format: TextFormat) -> Vec<String> {
    let report = find_statistics(text, format).expect("a text");
    let shown = |finding: proofread::ChainFinding| {
        finding.printed + if finding.section == ReportSection::Doubts { "?" } else { "" }
    };
    report.findings.into_iter().map(shown).collect()
}

#[track_caller]
fn markdown(text: &str) -> Vec<String> {
    listed(text, TextFormat::Markdown)
}

fn tally(text: &str, format: TextFormat) -> StatisticsTally {
    find_statistics(text, format).expect("a text").tally
}

/// How a case of statcheck's own tests is judged there and here.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Case {
    /// An error for both.
    Wrong,
    /// No error for both.
    Right,
    /// Read by neither.
    Unread,
    /// An error there and a doubt here: the p-value is that of a one-sided test, which the text doesn't name.
    OneSided,
    /// An error there and none here: p = .000 is the rounded p-value.
    Rounded,
    /// Read here and not there: `;` or a square bracket is a notation of other fields, and the minus sign stands alone.
    WrongHere,
}

/// The cases of statcheck's tests on errors, on decision errors and on what is retrieved, by their facts: statistic, degrees of
/// freedom, p-value and verdict. Quantiles that its tests compute have six digits here.
const STATCHECK: [(&str, Case); 96] = [
    // Simple errors.
    ("t(28) = 2.20, p = .03", Case::Wrong),
    ("F(2, 28) = 2.20, p = .15", Case::Wrong),
    ("r(28) = .22, p = .26", Case::Wrong),
    ("chi2(28) = 22.20, p = .79", Case::Wrong),
    (" z = 2.20, p = .04", Case::Wrong),
    ("Q(28) = 22.20, p = .79", Case::Wrong),
    // Negative statistics.
    (" Z = -2.42, p = 0.016", Case::Right),
    ("t(28) = -2.20, p = .03", Case::Wrong),
    // Inexact p-values.
    ("t(28) = 2.20, ns", Case::Wrong),
    ("t(28) = 2.20, p > .05", Case::Wrong),
    ("t(28) = 2.0, p < .05", Case::Right),
    // Decision errors.
    ("t(28) = 1.20, p = .03", Case::Wrong),
    ("t(28) = 2.20, p = .30", Case::Wrong),
    ("t(28) = 2.20, p = .06", Case::Wrong),
    ("F(2, 28) = 22.20, p = .06", Case::Wrong),
    ("F(2, 28) = 2.20, p = .03", Case::Wrong),
    ("r(28) = .22, p = .03", Case::Wrong),
    ("r(28) = .52, p = .06", Case::Wrong),
    ("chi2(28) = 2.20, p = .03", Case::Wrong),
    ("chi2(28) = 52.20, p = .06", Case::Wrong),
    (" z = 1.20, p = .03", Case::Wrong),
    (" z = 2.20, p = .06", Case::Wrong),
    ("Q(28) = 2.20, p = .03", Case::Wrong),
    ("Q(28) = 52.20, p = .06", Case::Wrong),
    ("t(28) = 2.20, p = .11", Case::Wrong),
    ("t(28) = 1.20, p = .09", Case::Wrong),
    ("t(28) = 5.20, p = .02", Case::Wrong),
    ("t(28) = 1.20, p = .005", Case::Wrong),
    ("t(28) = 1.959394, p = .04", Case::Wrong),
    ("t(28) = 2.153933, p = .06", Case::Wrong),
    ("t(28) = 2.048507, p = .06", Case::Wrong),
    ("t(28) = 2.153933, p = .04", Case::Right),
    ("t(28) = 2.048407, p = .05", Case::Right),
    ("t(28) = 1.959394, p = .06", Case::Right),
    ("t(28) = 1.959394, p < .04", Case::OneSided),
    ("t(28) = 1.959394, p < .05", Case::OneSided),
    ("t(28) = 2.048507, p < .0500", Case::Right),
    ("t(28) = 2.153933, p < .06", Case::Right),
    ("t(28) = 2.153933, p > .05", Case::Wrong),
    ("t(28) = 2.048507, p > .05", Case::Wrong),
    ("t(28) = 2.153933, p > .06", Case::Wrong),
    ("t(28) = 2.048507, p > .06", Case::Wrong),
    ("t(28) = 1.959394, p > .05", Case::Right),
    ("t(28) < 2.048307, p = .04", Case::Wrong),
    ("t(28) < 1.959394, p = .05", Case::Wrong),
    ("t(28) < 2.048307, p < .04", Case::Wrong),
    ("t(28) < 1.959394, p < .05", Case::Wrong),
    ("t(28) > 2.153933, p = .06", Case::Wrong),
    ("t(28) > 2.049407, p = .0600", Case::Wrong),
    // Rounding.
    ("t(28) = 2, p = .02", Case::Right),
    ("t(28) = 2, p = .14", Case::Right),
    ("t(28) = 2.2, p = .03", Case::Right),
    ("t(28) = 2.2, p = .04", Case::Right),
    ("t(28) = 2.20, p = .036", Case::Right),
    ("t(28) = 2.20, p = .037", Case::Right),
    // Tests on one side.
    ("t(28) = 2.20, p = .018", Case::OneSided),
    ("t(28) = 2.20, p = .01, one-tailed", Case::Wrong),
    ("t(28) = 2.20, p = .018, one-tailed", Case::Right),
    ("t(28) = 2.20, p = .018, one-sided", Case::Right),
    ("t(28) = 2.20, p = .018, directional", Case::Right),
    // A p-value of zero.
    ("t(28) = 22.20, p = .000", Case::Rounded),
    ("t(28) = 22.20, p < .000", Case::Wrong),
    // Statistics that are exact, below or above a bound.
    ("t(28) = 2.2, p = .036", Case::Right),
    ("t(28) = 2.2, p < .08", Case::Right),
    ("t(28) = 2.2, p > .02", Case::Right),
    ("t(28) = 2.2, p = .08", Case::Wrong),
    ("t(28) = 2.2, p = .02", Case::OneSided),
    ("t(28) = 2.2, p > .08", Case::Wrong),
    ("t(28) = 2.2, p < .02", Case::OneSided),
    ("t(28) < 2.2, p = .08", Case::Right),
    ("t(28) < 2.2, p > .08", Case::Right),
    ("t(28) < 2.2, p < .08", Case::Right),
    ("t(28) < 2.2, p > .02", Case::Right),
    ("t(28) < 2.2, p < .02", Case::Wrong),
    ("t(28) < 2.2, p = .02", Case::Wrong),
    ("t(28) > 2.2, p = .02", Case::Right),
    ("t(28) > 2.2, p > .02", Case::Right),
    ("t(28) > 2.2, p < .02", Case::Right),
    ("t(28) > 2.2, p > .08", Case::Wrong),
    ("t(28) > 2.2, p = .08", Case::Wrong),
    // What is retrieved.
    (" t ( 28 ) = 2.20 , p = .03", Case::Wrong),
    ("F(l, 76) = 23.95, p <.001", Case::Right),
    ("chi_2(28) = 2.20, p = .03", Case::Wrong),
    ("chi2(1, N = 11,455) = 16.78, p <.001", Case::Right),
    ("chi2(1, n = 81) = 3.25, p = 0.07", Case::Right),
    ("Q-within(2) = 2.20, p = .03", Case::Wrong),
    ("t(28) = 2.20, p = .5e-3", Case::Wrong),
    ("t(28) = .2.20, p = .03", Case::Unread),
    ("T(28) = 2.20, p = .03", Case::Unread),
    ("t(28) = 2.20, p = 1.03", Case::Unread),
    ("t(2,28) = 2.20, p = .03", Case::Unread),
    ("t(38) >= 2.25, p = .03", Case::Unread),
    ("z(28) = 2.20, p = .03", Case::Unread),
    ("r(16) = 26.05, p = .10", Case::Unread),
    ("t(28) = 2.20; p = .03", Case::WrongHere),
    ("t[28] = 2.20, p = .03", Case::WrongHere),
];

#[test]
fn verdicts_are_those_of_statcheck_but_for_what_is_meant_to_differ() {
    let mut different = Vec::new();
    for (text, case) in STATCHECK {
        let report = find_statistics(text, TextFormat::Plain).expect("a text");
        let section = report.findings.first().map(|finding| finding.section);
        let wanted = match case {
            Case::Wrong | Case::WrongHere => (1, Some(ReportSection::Statistics)),
            Case::Right | Case::Rounded => (1, None),
            Case::OneSided => (1, Some(ReportSection::Doubts)),
            Case::Unread => (0, None),
        };
        if (report.tally.tests, section) != wanted {
            different.push((text, case, report.tally.tests, section));
        }
    }
    assert_eq!(different, []);
}

#[test]
fn a_p_value_is_read_in_the_notation_of_any_field() {
    // Each with the p-value that agrees and one that does not.
    for [before, right, wrong] in [
        ["*t*(38) = 2.64, *p* = ", ".012", ".12"],
        ["$t_{28}=2.20$, $p=", "0.036$", "0.063$"],
        ["$t(28) = 2.20, p = ", ".036$", ".36$"],
        ["(t[22] = 2.45; P = ", "0.023)", "0.032)"],
        ["t = 2.05, df = 60, P=", "0.045", "0.45"],
        ["t=2.05 on 60 degrees of freedom, p-value ", "0.045", "0.054"],
        ["t = 2.05 (df = 60, p = ", ".045)", ".054)"],
        ["F(2, 57) = 3.91, p = ", ".026", ".062"],
        ["$F_{2,57} = 3.91$ ($p = ", "0.026$)", "0.26$)"],
        ["*F*(1.5, 43.5) = 6.30, *p* = ", ".0077", ".0078"],
        ["χ²(1, N = 90) = 4.25, p = ", ".039", ".093"],
        ["$\\chi^2_{3} = 7.81$, $p = ", ".050$", ".500$"],
        ["$\\chi_{3}^{2} = 7.81$, $p = ", ".050$", ".500$"],
        ["$\\chi^2(4, N = 250) = 11.30, p = ", ".023$", ".032$"],
        ["a χ² of 3, but $\\chi^2 = 9.0$, $p=", "0.011$ on two degrees of freedom", "0.11$ on two degrees of freedom"],
        ["z = 1.96, p = ", ".05", ".06"],
        ["*z* = −2.19, *p* = ", ".029", ".29"],
        ["r(48) = .31, p = ", ".028", ".28"],
        ["r = .31, n = 50, p = ", ".028", ".28"],
        ["t(28) = (3.46 − 3)/0.20 = 2.30, p = ", ".029", ".92"],
        ["t(76) = 3.87, d = 0.45, p < ", ".001", ".0001"],
        ["t(20) = 5.00, p = ", "6.9 × 10^-5", "6.9 × 10^-4"],
        ["t(28) = 2,20; p = ", "0,036", "0,36"],
        ["t(28) = 2·20, p = ", "0·036", "0·36"],
        ["$t(28) = 2.20, p = ", ".036^{*}$", ".36^{*}$"],
        ["$t(28) = 2.20^*$, $p = ", ".036^{\\ast\\dagger}$", ".36^\\dagger$"],
        ["t(28) = 2.20, p = ", ".036^(∗∗∗)", ".36^(∗∗∗)"],
    ] {
        let text = |p: &str| format!("The groups were compared: {before}{p}.");
        assert_eq!(markdown(&text(right)), [""; 0], "{before}{right}");
        assert_eq!(tally(&text(right), TextFormat::Markdown).tests, 1, "{before}{right}");
        assert_eq!(markdown(&text(wrong)).len(), 1, "{before}{wrong}");
    }
    let page = |p: &str| {
        format!("<p><i>t</i><sub>28</sub> = 2.20, <i>p</i> = {p}; &chi;<sup>2</sup>(1) = 4.25, p &lt; .05</p>")
    };
    assert_eq!(listed(&page(".036"), TextFormat::Html), [""; 0]);
    assert_eq!(tally(&page(".036"), TextFormat::Html).tests, 2);
    assert_eq!(listed(&page(".36"), TextFormat::Html), ["p = .36"]);
    let article = |p: &str| format!("<p><italic>F</italic><sub>(2,63)</sub> = 14.5, <italic>p</italic> = {p}</p>");
    assert_eq!(listed(&article("0.04"), TextFormat::Xml), ["p = 0.04"]);
    let latex = |p: &str| format!("A \\emph{{t}} test: $t(28) = 2.20$, \\textit{{p}} = {p}.");
    assert_eq!(listed(&latex(".036"), TextFormat::Latex), [""; 0]);
    assert_eq!(listed(&latex(".36"), TextFormat::Latex), ["p = .36"]);
}

#[test]
fn what_is_no_test_result_is_not_read() {
    for text in [
        "We see that $t_0 = 3.71$ with a $p$-value $= .5$.",
        "Critical values: $t_{10;\\,0.05}=1.812$, $z_{.05}=1.645$, and p = .2 was chosen.",
        "At t = 3 s the pressure is p = 0.5 bar.",
        "With $r(3) = 0.5$ the answer is different, and we need p = 0.1 to go on with the next question.",
        "t(28) = 2.20. The other variable had p = .4.",
        "The effect was t(28) = 2.20; in the other group the regression coefficient had p = .4.",
        "F(2, 57) = 3.91, F(1, 57) = 2.10, both reported elsewhere.",
        "`t(28) = 2.20, p = .36`",
        "A power and a number that goes on: $t(28) = 2.20$, $p = .3^{2}$, $t(28) = 2.20$, $p = .36^n$, and t(28) = 2.20, p = .36 1.",
    ] {
        assert_eq!(markdown(text), [""; 0], "{text}");
    }
}

#[test]
fn a_p_value_that_may_be_of_another_test_is_a_doubt() {
    let report = |text: &str| find_statistics(text, TextFormat::Markdown).expect("a text").findings;
    let one_sided = report("t(28) = 2.20, p = .018");
    assert_eq!(one_sided[0].doubt, Some(Doubt::OtherTest));
    assert_eq!(report("t(28) = 2.20, p = .018 (one-sided)"), []);
    assert_eq!(report("We test $H_0: \\mu = 3$ against $H_1: \\mu > 3$. It is t(28) = 2.20, p = .018."), []);
    let adjusted = report("With the Bonferroni correction, t(28) = 2.20, p = .108.");
    assert_eq!(adjusted[0].doubt, Some(Doubt::OtherTest));
    let decision = report("t(28) = 2.20, p = .36");
    assert_eq!(decision[0].why.as_deref(), Some("the two are on different sides of 0.05"));
}

#[test]
fn limits_follow_from_estimate_and_margin() {
    for [right, wrong] in [
        [
            "The 95 % limits are 61.5 ± 2.83, i.e. 58.67 and 64.33.",
            "The 95 % limits are 61.5 ± 2.83, i.e. 58.67 and 63.43.",
        ],
        [
            "A 95% CI is $18.4\\pm2.064\\cdot0.7$, that is, $(16.96, 19.84)$.",
            "A 95% CI is $18.4\\pm2.064\\cdot0.7$, that is, $(16.69, 19.84)$.",
        ],
        [
            "A 95% CI is $18.4\\pm1.445$, that is, $(16.96, 19.84)$.",
            "A 95% CI is $18.4\\pm3.445$, that is, $(16.96, 19.84)$.",
        ],
        ["b = 1.24, SE = 0.32, 95% CI [0.61, 1.87]", "b = 1.24, SE = 0.32, 95% CI [0.61, 1.78]"],
        [
            "b = 1.24, SE = 0.32, t(20) = 3.88, 95% CI [0.57, 1.91]",
            "b = 1.24, SE = 0.32, t(20) = 3.88, 95% CI [0.57, 1.19]",
        ],
        ["b = 1.24, SE = 0.32, 90 % CI 0.71 to 1.77", "b = 1.24, SE = 0.32, 90 % CI 0.71 to 1.97"],
        ["b = 1.24, SE = 0.32, 99 % CI 0.42–2.06", "b = 1.24, SE = 0.32, 99 % CI 0.24–2.06"],
        ["It took 1.91 ± 0.19 seconds (95% CI: 1.54–2.28).", "It took 1.91 ± 0.19 seconds (95% CI: 1.54–2.82)."],
        ["M = 1.80, 95% CI [0.45, 3.15]", "M = 4.80, 95% CI [0.45, 3.15]"],
        ["hazard ratio 0.72 (95% CI 0.58–0.89)", "hazard ratio 0.27 (95% CI 0.58–0.89)"],
        ["447 eggs (95% CI: 398–1,196)", "1447 eggs (95% CI: 398–1,196)"],
    ] {
        assert_eq!(markdown(right), [""; 0], "{right}");
        assert!(tally(right, TextFormat::Markdown).intervals > 0, "{right}");
        assert_eq!(markdown(wrong).len(), 1, "{wrong}");
    }
    for text in [
        // Roots, a p-value before an interval, a skewed interval, a ratio, and ± a deviation.
        "$x = 1 \\pm 2$, so $x_1 = 3$, $x_2 = -2$.",
        "a reduction of −2.46 points (p = 0.01, 95% CI −3.72 to −1.21)",
        "odds ratio 3.43, SE = 0.39, 95% CI [1.59, 7.42]",
        "a ratio of 947:447 (95% CI: 698–1196)",
        "The age was 5.2 ± 1.1 years, between 3.1 and 7.9 years, and the 95 % confidence interval is elsewhere.",
    ] {
        assert_eq!(markdown(text), [""; 0], "{text}");
    }
}

#[test]
fn a_share_follows_from_its_parts() {
    for [right, wrong] in [
        ["It was 12 of 48 (25 %).", "It was 12 of 48 (52 %)."],
        ["It was 12/48 (25.0%).", "It was 12/48 (26.0%)."],
        ["It was 12 out of 48 patients (25%).", "It was 12 out of 48 patients (35%)."],
        ["It was found in 25.0% (12/48).", "It was found in 20.5% (12/48)."],
        ["It was 15 out of 18 (83.3%, 95% CI: 58.6–96.4).", "It was 15 out of 18 (84.3%, 95% CI: 58.6–96.4)."],
        ["all\n\n8/23, 35%\n\nnone", "all\n\n8/23, 45%\n\nnone"],
        ["In 1,108 of 2,345 (47.2 per cent) it was.", "In 1,108 of 2,345 (42.7 per cent) it was."],
        [
            "Of the 37 respondents, 12 (32.4%) agreed, 12 (32.4%) disagreed and 13 (35.1%) were undecided.",
            "Of the 37 respondents, 12 (32.4%) agreed, 12 (34.2%) disagreed and 13 (35.1%) were undecided.",
        ],
    ] {
        assert_eq!(markdown(right), [""; 0], "{right}");
        assert!(tally(right, TextFormat::Markdown).shares > 0, "{right}");
        assert_eq!(markdown(wrong).len(), 1, "{wrong}");
    }
    for text in [
        "On 12/48 (a date) it grew by 3 (20%).",
        "It was 12 of 48 (95% CI 10–40).",
        "In 2019, 12 (20%) of them left.",
        "About 5 of 10 rose by 20%.",
        "Version 2/3 of it, 5% faster, came later.",
    ] {
        assert_eq!(markdown(text), [""; 0], "{text}");
    }
    // Truncated, and of another whole.
    assert_eq!(markdown("It was 13/48 (27.0%)."), ["27.0%?"]);
    assert_eq!(markdown("Of the 37 respondents, 12 (40.0%) agreed."), ["40.0%?"]);
}

/// Whatever is read, there is no panic, and every place is inside the text.
#[test]
fn mangled_texts_are_read_to_their_end() {
    let seed = "*t*(28) = 2.20, *p* = .36; $\\chi^2_{3} = 7.81$, $p < .05$ on two degrees of freedom, 12 of 48 (25 %), 61.5 ± 2.83 \
                (95% CI: 58.67–64.33), F(2, 57) = 3.91e5\n\n| a | b | Total |\n|--|--|--|\n| x | 4 (50%) | 8 |\n| Total | 4 | 8 |\n\n\
                \\begin{tabular}{lr} A & \\multicolumn{2}{c}{3} \\\\ Total & 3 \\\\[2pt] \\end{tabular} <table><tr><th rowspan=9>A</th>\
                <td colspan=\"3\">4&nbsp;</td></tr><tr><td>Total</td></tr></table> \"1,2\";3\nΣ;5 × 10^-400, 9999999999999999999999999999999999.5";
    let pieces = [
        "(",
        ")",
        "[",
        "{",
        "}",
        "$",
        "|",
        "&",
        "\\\\",
        "\\begin{tabular}",
        "\\end{tabular}",
        "<td>",
        "</table>",
        "±",
        "p = ",
        "t(",
        "95% CI ",
        "0",
        ".",
        ",",
        "\n",
        "\n\n",
        "χ",
        "_",
        "^",
        "e",
        "%",
        "−",
        "\u{2009}",
        "\"",
        "\u{b}",
    ];
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..3000 {
        let mut text: Vec<char> = seed.chars().collect();
        for _ in 0..random.usize(1..12) {
            let at = random.usize(0..text.len());
            let end = (at + random.usize(0..9)).min(text.len());
            text.splice(at..end, random.choice(pieces).unwrap_or_default().chars());
        }
        let text: String = text.into_iter().collect();
        for (_, format) in TextFormat::ALL {
            for finding in find_statistics(&text, format).map(|report| report.findings).unwrap_or_default() {
                for span in [finding.at, finding.span, finding.left_span, finding.right_span] {
                    assert!(text.get(span.range()).is_some(), "{format:?} {span:?} {text:?}");
                }
            }
        }
    }
}

/// Text of about a size.
type Grown<'g> = &'g dyn Fn(usize) -> String;

/// If time grew with the square of the text, this test would not end in the patience of whoever runs it.
#[test]
fn long_texts_are_read_to_their_end() {
    let cells = |size: usize| {
        format!("| a | b | Total |\n|--|--|--|\n{}| Total | 4 | 8 |\n", "| x | 4 (50%) | 8 |\n".repeat(size / 20))
    };
    let grown: [(&str, TextFormat, Grown<'_>); 8] = [
        ("tests", TextFormat::Plain, &|size| "t(28) = 2.20, p = .36; ".repeat(size / 23)),
        ("names alone", TextFormat::Plain, &|size| "t(28) = 2.20, ".repeat(size / 14)),
        ("chains", TextFormat::Plain, &|size| "t = 1+".repeat(size / 6)),
        ("intervals", TextFormat::Plain, &|size| "95% CI ± 4 ".repeat(size / 11)),
        ("shares", TextFormat::Plain, &|size| "of the 12 (25%), ".repeat(size / 17)),
        ("cells", TextFormat::Markdown, &cells),
        ("tables that do not end", TextFormat::Latex, &|size| "\\begin{tabular}{l} ".repeat(size / 19)),
        ("braces", TextFormat::Html, &|size| "<td rowspan=5000>{\\".repeat(size / 19)),
    ];
    for (name, format, grown) in grown {
        let report = find_statistics(&grown(1_000_000), format);
        assert!(report.is_ok(), "{name}");
    }
}

#[test]
fn a_recomputed_p_value_has_the_digits_that_tell_it_from_the_printed_one() {
    let recomputed = |text: &str| {
        let report = find_statistics(text, TextFormat::Markdown).expect("it can be read");
        report.findings.into_iter().filter_map(|finding| finding.recomputed).collect::<Vec<_>>()
    };
    for (text, p) in [
        ("t(28) = 2.20, p = .36", "p = 0.036 (two-sided)"),
        ("t(28) = 2.20, p = .3", "p = 0.036 (two-sided)"),
        ("t(28) = 0.50, p = .36", "p = 0.62 (two-sided)"),
        ("t(28) = 2.200, p < .036", "p = 0.0362, or half of it on one side"),
    ] {
        assert_eq!(recomputed(text), [p], "{text}");
    }
}

#[test]
fn what_is_cut_off_or_rounded_twice_is_a_doubt() {
    let only = |text: &str| {
        let found = listed(text, TextFormat::Markdown);
        assert_eq!(found.len(), 1, "{text}: {found:?}");
        found[0].ends_with('?')
    };
    for text in [
        "A share of 85.3% (52/61) was positive.",
        "Of them 7 of 52 (14%) failed.",
        "A drop was seen: F(1,25) = 11.30, p = .003.",
        "The effect was marginal (z = 1.834, p = .066).",
        "Of 1840 women and 920 men, 110 (6.0%) and 184 (20.0%) subjects had the disease, respectively.",
    ] {
        assert!(only(text), "{text}");
    }
    for text in [
        "A share of 85.4% (52/61) was positive.",
        "Of them 7 of 52 (15%) failed.",
        "A drop was seen: F(1,25) = 11.30, p = .004.",
        "The effect was marginal (z = 1.836, p = .05).",
    ] {
        assert!(!only(text), "{text}");
    }
}

#[test]
fn a_time_with_an_index_is_no_statistic() {
    assert_eq!(markdown("At ($t_2 = 6 \\,ns$) it is X = 0."), [""; 0]);
    assert_eq!(markdown("The effect was clear, $t_2 = 6.0, ns$.").len(), 1);
}

#[test]
fn a_standard_deviation_may_stand_behind_the_sign() {
    let spends = |limits: &str| format!("It will spend 52.37 ± 8.42, with 95% confidence between {limits}.");
    assert_eq!(markdown(&spends("36 and 69")), [""; 0]);
    assert_eq!(markdown(&spends("41 and 64")).len(), 1);
}
