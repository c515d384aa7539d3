//! Which differences are set aside, each in a chain of ours beside one that has the same fault and is read whole.

use crate::report;
use crate::unusual::{listed, unlisted};
use proofread::{CheckOptions, Doubt, ReportSection, TextFormat, proofread};

/// Why the differences in a text are set aside; none for one that counts.
fn doubts(text: &str, format: TextFormat) -> Vec<Option<Doubt>> {
    let findings = report(text, format).findings;
    findings
        .iter()
        .filter(|of| matches!(of.section, ReportSection::Numbers | ReportSection::Doubts))
        .map(|of| of.doubt)
        .collect()
}

#[track_caller]
fn aside(doubt: Doubt, texts: &[&str]) {
    for text in texts {
        assert_eq!(doubts(text, TextFormat::Markdown), [Some(doubt)], "{text}");
    }
}

#[track_caller]
fn counts(texts: &[&str]) {
    for text in texts {
        assert_eq!(doubts(text, TextFormat::Markdown), [None], "{text}");
    }
}

#[test]
fn a_side_that_may_go_on_is_a_doubt() {
    aside(
        Doubt::Cut,
        &[
            r"$1, 2, 3.5 = 6$",
            r"$2 - \sqrt 2, 2, 2 + \sqrt 2 = 0.5858, 2.0000$",
            r"$\displaystyle -(3.0\,\text{J})(2.0) = 7.0\,\text{J}$",
            r"x$3 + 4 = 9$",
            r"$2.5 \cdot 4 = 11.(5)$",
        ],
    );
    counts(&[
        r"$2 \times 3 = 6,\ 4 \times 5 = 21$",
        r"$-10/2 = 5$",
        r"$x = 3$, so $2.5 + 1.5 = 5$",
        "- 2.5 + 1.5 = 5\n",
        "> * 2.5 + 1.5 = 5\n",
        r"Step 3: 12 / 4 = 5",
    ]);
}

#[test]
fn a_unit_that_is_not_known_may_stand_behind_the_formula() {
    aside(
        Doubt::Cut,
        &[r"$15\,\text{V}/100\,\mu\text{A} = 150$\,k\unheard", r"$15\,\text{V}/100\,\mu\text{A} = 150$ kiloohmings"],
    );
    counts(&[
        r"$15\,\text{V}/100\,\mu\text{A} = 150$ and more",
        r"$15\,\text{V}/100\,\mu\text{A} = 160\,\text{k}\Omega$ resistors",
        r"$2.5 + 1.5 = 5$ apples",
    ]);
}

#[test]
fn numbers_that_an_arrow_or_a_word_joins_are_a_doubt() {
    aside(
        Doubt::Cut,
        &[
            "4.6 -> 1.8 = 2.8 eV\n",
            "4.6 --> 1.85 = 2.8 eV\n",
            r"$4.6 \to 1.8 = 2.8\,\text{eV}$",
            "(1/3) of 163.62 = 54.54 cm\n",
        ],
    );
    counts(&["Then 2.5 - 1.5 = 3\n", r"$x \to 2.5 + 1.5 = 3$", "A mean of 2.5 + 1.5 = 3\n"]);
}

#[test]
fn a_rounder_number_behind_an_arrow_takes_nothing_from_the_result() {
    counts(&[
        r"$64{,}000 \div 20{,}000 = 2.3 \rightarrow 2$",
        r"$\frac{1450}{2360} \approx 0.8444 \rightarrow 84.44\%$",
        "It is 47 / 20 = 3.35 → 3.4 metres.",
    ]);
    aside(Doubt::Cut, &[r"$2.5 + 1.5 = 0.5 \rightarrow 1.49$", r"$2.5 + 1.5 = 3 \rightarrow 7$"]);
    unlisted(TextFormat::Markdown, &[r"$64{,}000 \div 20{,}000 = 3.2 \rightarrow 3$"]);
}

#[test]
fn years_in_brackets_and_terms_that_were_rounded_are_a_doubt() {
    aside(
        Doubt::Unknown,
        &["The town had **3.1 million guests** (2015-2018) = 5.4% of all", "So 7 of them (1999-2004) = 35% left"],
    );
    counts(&["The sum (2015-2.018) = 5.4% of all"]);
    aside(
        Doubt::Inputs,
        &[r"$2(0.641+0.027) = 1.337$", r"$2(0.641+0.027) = 1.337\,\text{V}$", r"$3 \cdot (0.55-0.021) = 1.588$"],
    );
    counts(&[r"$2(0.641+0.027) = 1.339$", r"$2(0.64+0.03) = 1.35$", r"$2(0.641+0.027) = 13.37$"]);
}

#[test]
fn grams_that_may_be_free_fall_are_a_doubt() {
    aside(Doubt::Unknown, &["a = (1/3)g = 10/3 m/s²\n", r"$0.5\,\text{g} = 4.9\,\text{m/s}^2$"]);
    counts(&["m = (1/4) g = 0.35 g\n", r"$0.5\,\text{g} = 4.9\,\text{m/s}$"]);
}

#[test]
fn a_number_that_may_be_a_part_is_a_doubt() {
    aside(
        Doubt::Fragment,
        &[
            r"$1 = 0.08$",
            r"$0 = 5/9$",
            r"$10 = (4 \times 1)/40$",
            r"$0.67 = 6.7$",
            r"$74.5\,\text{J} = 19$ lamps",
            r"$-79.2\,\text{N} = 80\,\text{N}$",
        ],
    );
    counts(&[r"$4! = 12$", r"$0.67 = 0.76$", r"$5/6 = 1/6$", r"$\cos 90^\circ = 1$", r"$10.5 = 4.5 + 5$"]);
}

#[test]
fn numbers_beside_what_is_not_known_are_a_doubt() {
    aside(
        Doubt::Unknown,
        &[
            r"$\begin{unheard} 3 \end{unheard}, \quad 2.5 + 1.5 = 5$",
            r"$2.5 + 1.5 = 5 \quad \dots$",
            "{5.5 + 1.5} = 8\n",
            r"$9.81(2) = 9.7$",
        ],
    );
    counts(&[
        r"$4.5(2) = 8$",
        r"${2.5 + 1.5} = 5$",
        r"$\unheard x, \quad 2.5 + 1.5 = 5$",
        r"$\boxed{x} = 2.5 + 1.5 = 5$",
    ]);
}

#[test]
fn what_is_cut_off_is_a_doubt() {
    aside(Doubt::Truncated, &[r"$1/18 = 0.0555$", r"$20/12 = 1.66\,\Omega$"]);
    counts(&[r"$1/18 = 0.0565$", r"$20/12 = 1.76\,\Omega$"]);
}

#[test]
fn three_formulas_with_the_same_factor_are_a_habit() {
    let of = |chains: &[&str]| {
        doubts(&chains.iter().map(|of| format!("It is ${of}$.\n\n")).collect::<String>(), TextFormat::Markdown)
    };
    let habit = Some(Doubt::Habit);
    assert_eq!(of(&["2.5 + 1.5 = 48", "6.0 + 3.0 = 108", "3.5 + 1.5 = 60"]), [habit; 3]);
    assert_eq!(of(&["2.5 + 1.5 = 48", "6.0 + 3.0 = 108", "3.5 + 1.5 = 61"]), [None; 3]);
    // The same misprint again says nothing about others.
    assert_eq!(of(&["2.5 + 1.5 = 48"; 3]), [None; 3]);
    // No convention leaves out a factor of seven: it is the author's error each time.
    assert_eq!(of(&["2.5 + 1.5 = 28", "6.0 + 3.0 = 63", "3.5 + 1.5 = 35"]), [None; 3]);
}

#[test]
fn points_are_misplaced_more_than_once() {
    let text = "$2.5 + 1.5 = 40$\n\n$6.0 + 3.0 = 90$\n\n$3.5 + 1.5 = 50$\n";
    assert_eq!(doubts(text, TextFormat::Markdown), [None; 3]);
}

#[test]
fn a_doubt_is_counted_and_has_no_hint() {
    let report = proofread("$1, 2, 3.5 = 6.5$ and $1/18 = 0.0555$", TextFormat::Markdown, CheckOptions::default())
        .expect("a text");
    assert_eq!((report.tally.doubts, report.findings.len()), (2, 2));
    assert!(report.findings.iter().all(|of| of.hint.is_none() && of.section == ReportSection::Doubts));
}

#[test]
fn what_is_said_at_a_brace_is_no_exponent() {
    counts(&[r"$\overbrace{1 + 2}^{3} + 4 = 8$"]);
    assert_eq!(doubts(r"$\overbrace{1 + 2}^{3} + 4 = 7$", TextFormat::Markdown), []);
}

#[test]
fn a_stroke_may_end_the_argument_of_a_logarithm() {
    assert_eq!(doubts(r"$\ln 2/5 = 0.139$ and $\ln 2/5 = -0.916$", TextFormat::Markdown), []);
    counts(&[r"$\ln 2/5 = 0.193$", r"$\sin 30^\circ/2 = 0.35$"]);
}

#[test]
fn a_product_may_leave_out_watts_and_hours() {
    assert_eq!(doubts(r"$60 \times 1460 = 87.6\,\text{kW}\,\text{h}$", TextFormat::Markdown), []);
    counts(&[r"$60 \times 1460 = 86.7\,\text{kW}\,\text{h}$"]);
}

#[test]
fn a_power_of_ten_alone_is_an_order_of_magnitude() {
    assert_eq!(doubts(r"$e^{-23.0} \approx 10^{-10}$", TextFormat::Markdown), []);
    counts(&[r"$e^{-23.0} \approx 10^{-12}$", r"$2.0 \times 17.0 = 10^2$"]);
}

#[test]
fn a_ratio_may_be_given_in_decibels() {
    assert_eq!(doubts(r"$1/\sqrt 2 = -3\,\text{dB}$", TextFormat::Markdown), []);
    counts(&[r"$1/\sqrt 2 = -6\,\text{dB}$"]);
}

#[test]
fn uncertainties_in_per_cent_are_a_doubt() {
    let quotient = r"$R=\frac{5.00\text{ V}\,(\pm1\%)}{0.250\text{ A}\,(\pm2\%)}=20.0\,\Omega\,(\pm3\%)$";
    aside(Doubt::Unknown, &[quotient]);
    counts(&[r"$R=\frac{5.00\text{ V}}{0.250\text{ A}}=21.0\,\Omega$"]);
}

#[test]
fn what_stands_behind_approximately_may_be_exact_and_coarse() {
    let doubt = |text: &str| report(text, TextFormat::Latex).findings.iter().find_map(|of| of.doubt);
    for text in [
        r"$\sqrt{5}\approx \dfrac{5}{2}$",
        r"$\log(1.08)\approx \log(1)=0$",
        r"$2\tan(0.9) \approx 2\tan\left(\dfrac{\pi}{4}\right)=2$",
    ] {
        unlisted(TextFormat::Latex, &[text]);
        assert_eq!(doubt(text), Some(Doubt::Approximation), "{text}");
    }
    listed(
        TextFormat::Latex,
        &[r"$\sqrt{5} = \dfrac{5}{2}$", r"$\sqrt{5} \approx 2.546$", r"$\frac{7}{3} \approx 2.433$"],
    );
}

/// Each kind of flag that was real in less than two of five cases at first contact.
#[test]
fn flags_that_were_seldom_real_are_doubts() {
    let doubt = |text: &str| report(text, TextFormat::Markdown).findings.iter().find_map(|of| of.doubt);
    for (text, why) in [
        // Digits that are not printed in a result of many.
        (r"$P = 0.9137\cdot 0.53164 = 0.4857632$", Doubt::Inputs),
        // A sign that is left out.
        ("We find the difference between scores, e.g., $2-5 = 3$ here.", Doubt::Fragment),
        ("Factor A has $t^2=-3.12^2 = 9.73$.", Doubt::Fragment),
        // A factor that only changes a number to per cent.
        (r"$80\% = \frac{80}{100} = .8 = .8*100 = 80\%$", Doubt::Fragment),
    ] {
        unlisted(TextFormat::Markdown, &[text]);
        assert_eq!(doubt(text), Some(why), "{text}");
    }
    listed(
        TextFormat::Markdown,
        &[
            r"$P = 0.9137\cdot 0.53164 = 0.4957632$",
            r"$768\pi = 2413.3$",
            r"$0.5\times 0.2\times 54.6^2=309.136$",
            "We find the sum, e.g., $2-5 = 3$ here.",
            "Factor A has $-3.12^2 = 9.73$.",
            r"$.8 = .7*100 + 10 = 80\%$",
        ],
    );
}
