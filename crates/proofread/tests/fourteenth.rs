//! What the judges of a fourteenth first contact named, as kinds: right chains of ours that must not be listed, beside wrong ones that must.

use crate::report;
use crate::unusual::{listed, unlisted};
use proofread::Doubt;
use proofread::TextFormat::{Html, Latex, Markdown, Notebook, Plain, Xml};

/// A document in CNXML around what is in a paragraph.
fn cnxml(inner: &str) -> String {
    format!(
        "<document xmlns:m=\"http://www.w3.org/1998/Math/MathML\"><content><para>{inner}</para></content></document>"
    )
}

/// A table in MathML, its rows from cells between `|`: numbers, signs, and words in quotes.
fn table(rows: &[&str]) -> String {
    let cell = |cell: &str| {
        let parts = cell.split_whitespace().map(|part| match part {
            "=" | "−" | "+" | "≠" | "(" | ")" | "·" => format!("<m:mo>{part}</m:mo>"),
            part if part.starts_with('\'') => format!("<m:mtext>{}</m:mtext>", part.trim_matches('\'')),
            part => match part.split_once('/') {
                Some((above, below)) => format!("<m:mfrac><m:mn>{above}</m:mn><m:mn>{below}</m:mn></m:mfrac>"),
                None => format!("<m:mn>{part}</m:mn>"),
            },
        });
        format!("<m:mtd>{}</m:mtd>", parts.collect::<String>())
    };
    let row = |row: &&str| format!("<m:mtr>{}</m:mtr>", row.split('|').map(cell).collect::<String>());
    let rows: String = rows.iter().map(row).collect();
    cnxml(&format!("<m:math><m:mtable>{rows}</m:mtable></m:math>"))
}

#[test]
fn cells_with_an_equation_of_their_own_stand_apart() {
    for right in [
        table(&["0.2|=|1/5|||0.2 'is' 'one' 'fifth'"]),
        table(&["7 ( −2 )|=|−14|||( −7 ) ( −2 )|=|14"]),
        table(&["3 · 3|=|9 − 1/3|5 · 5|=|25 − 1/5", "8|=|9 − 1|24|=|25 − 1", "|=|16/2||=|48/2"]),
        table(&["3 + 4|=|7|'so'|7 + 1|=|8"]),
        table(&["2|·|3|=|6|+|0"]),
    ] {
        // The third one says other things in its first row, so only what goes on below counts.
        let listed: Vec<String> = { report(&right, Xml).findings.into_iter() }
            .filter(|of| of.section == proofread::ReportSection::Numbers)
            .map(|of| format!("{} | {}", of.left, of.right))
            .filter(|of| !of.starts_with("3·3") && !of.starts_with("5·5"))
            .collect();
        assert_eq!(listed, [""; 0], "{right}");
    }
    listed(Xml, &[&table(&["3 · 3|=|8|||5 · 5|=|25"]), &table(&["3 · 3|=|9|||5 · 5|=|24"]), &table(&["3|·|4|=|13"])]);
    unlisted(
        Markdown,
        &[
            "$$\n\\begin{array}{c|c|c}\n3 & \\frac{3.5-3}{2}=\\frac{1}{4} & (1-\\frac{1}{4})(1)=\\frac{3}{4} \\\\\n\\end{array}\n$$",
            r"$\begin{aligned} 3\cdot 4 = 12 & 5\cdot 6 = 30\end{aligned}$",
            "12 = 5 + 7\t\t30 = 13 + 17\t\t50 = 19 + 31",
            "Group | Log | Value\n:---: | :---: | ---\nHigh | 2.512 | exp(2.512) = 12.33\nLow | 2.512 + 0.021 = 2.533 | exp(2.533) = 12.59",
        ],
    );
    listed(
        Markdown,
        &[
            "$$\n\\begin{array}{c|c|c}\n3 & \\frac{3.5-3}{2}=\\frac{1}{3} & (1-\\frac{1}{4})(1)=\\frac{3}{4} \\\\\n\\end{array}\n$$",
            r"$\begin{aligned} 3\cdot 4 & = 13\end{aligned}$",
            r"$\begin{aligned} 3\cdot 4 = 12 & + 5 \cdot 6 = 42 + 1\end{aligned}$",
            "112 = 100 + 12\t\t130 = 30 + 101\t\t50 = 19 + 31",
            "Group | Log | Value\n:---: | :---: | ---\nLow | 2.512 + 0.021 = 2.633 | exp(2.533) = 12.59",
        ],
    );
}

#[test]
fn a_gap_may_part_two_equations() {
    let gap = |left: &str, right: &str| {
        cnxml(&format!(
            "<m:math><m:mn>12</m:mn><m:mo>/</m:mo><m:mn>24</m:mn><m:mo>=</m:mo>{left}<m:mspace width=\"0.5em\"/><m:mn>9</m:mn>\
             <m:mo>/</m:mo><m:mn>12</m:mn><m:mo>=</m:mo>{right}</m:math>"
        ))
    };
    let fraction = |above: u8, below: u8| format!("<m:mfrac><m:mn>{above}</m:mn><m:mn>{below}</m:mn></m:mfrac>");
    unlisted(Xml, &[&gap(&fraction(1, 2), &fraction(3, 4))]);
    listed(Xml, &[&gap(&fraction(1, 2), &fraction(2, 4)), &gap(&fraction(1, 3), &fraction(3, 4))]);
    let entries = |value: &str| {
        format!(
            "<document><table><row><entry>Solve.</entry>\n<entry><math><mi>y</mi><mo>=</mo><mo>−</mo><mfrac><mn>7</mn><mn>2</mn></mfrac>\
             </math></entry>\n<entry><math><mi>y</mi><mo>=</mo><mn>{value}</mn></math></entry></row></table></document>"
        )
    };
    unlisted(Xml, &[&entries("4")]);
}

#[test]
fn columns_of_alignat_belong_to_their_rows() {
    unlisted(
        Latex,
        &[
            "\\begin{alignat*}{7}\n\\cos(0)&=1 &&\\implies &\\sec(0)&=1\n\\\\\n\\sin(0)&=0 &&\\implies &\\tan(0)&=0\n\\end{alignat*}",
            "\\begin{alignat*}{3}\ng(x)&\\approx g(a) &\n &&&=2\\\\\ng(x)&\\approx g(a)+g'(a)(x-a) &\n &=2+3\\tfrac{\\pi}{100} &\n &=2.094248\n\\end{alignat*}",
        ],
    );
    listed(Latex, &["\\begin{alignat*}{7}\n3\\cdot 4&=13 &&\\implies &5\\cdot 6&=30\n\\end{alignat*}"]);
}

#[test]
fn thousandths_make_mixed_numbers() {
    unlisted(Latex, &[r"$3.472 = 3\frac{472}{1000} = \frac{434}{125}$", r"$12.347 = 12\frac{347}{1000}$"]);
    listed(Latex, &[r"$3.472 = 3\frac{474}{1000}$", r"$1416 = 5\frac{472}{1000}$"]);
}

#[test]
fn what_stands_behind_approximately_may_be_exact_and_coarse() {
    let doubt = |text: &str| report(text, Latex).findings.iter().find_map(|of| of.doubt);
    for text in [
        r"$\sqrt{5}\approx \dfrac{5}{2}$",
        r"$\log(1.08)\approx \log(1)=0$",
        r"$2\tan(0.9) \approx 2\tan\left(\dfrac{\pi}{4}\right)=2$",
    ] {
        unlisted(Latex, &[text]);
        assert_eq!(doubt(text), Some(Doubt::Approximation), "{text}");
    }
    listed(Latex, &[r"$\sqrt{5} = \dfrac{5}{2}$", r"$\sqrt{5} \approx 2.546$", r"$\frac{7}{3} \approx 2.433$"]);
}

#[test]
fn a_row_that_is_denied_denies_those_above() {
    let check = |last: &str| {
        format!(
            "<section><md><mrow>\\sqrt{{9+7}} \\amp = -4</mrow><mrow>\\sqrt{{16}} \\amp = -4</mrow><mrow>4 \\amp = -4{last}</mrow></md></section>"
        )
    };
    unlisted(Xml, &[&check(r" \qquad \text{which is false}")]);
    listed(Xml, &[&check("")]);
    unlisted(Xml, &[&table(&["3 · 4|=|5 − 7", "12|≠|−2"])]);
    listed(Xml, &[&table(&["3 · 4|=|5 − 7", "12|=|−2"])]);
    unlisted(
        Markdown,
        &[
            r"$9 \cancel{=} 81^2$, so $(81, 9) \notin R$",
            "Use parentheses to make the following statements true.\n\n1. $4 + 3^2 \\cdot 5 = 65$",
        ],
    );
    listed(Markdown, &["Here are sums.\n\n1. $4 + 3^2 \\cdot 5 = 65$"]);
}

#[test]
fn digits_in_brackets_side_by_side_are_cycles() {
    unlisted(Markdown, &["The product is $[(124)(13)](14) = (13)(24) = (123)(142)$."]);
    listed(Markdown, &["The product is $(124)(13) = 1712$."]);
}

#[test]
fn running_text_is_read_as_it_is_shown() {
    unlisted(
        Markdown,
        &[
            "Here 2 atm = 202.65 kPa = 1520 mm Hg.",
            "The scale: 1 unit = 20 <b>÷</b> 80 = 0.25 µm.",
            "The probability is 2/5 &times; 7/24 = 7/60. The area is 0.6 &times; 0.3 = 0.18.",
            "There are 9<sup>4</sup> = 6,561.",
        ],
    );
    listed(
        Markdown,
        &[
            "Here 2 atm = 202.65 kPa = 1620 mm Hg.",
            "The scale: 1 unit = 20 <b>÷</b> 80 = 0.35 µm.",
            "The probability is 2/5 &times; 7/24 = 7/61.",
            "There are 9<sup>4</sup> = 262,144.",
            "The rest is 19 (70 - 52 = 19). Next.",
        ],
    );
    let cell = r#"{"cells": [{"cell_type": "markdown", "metadata": {}, "source": ["It is 2/5 &times; 7/24 = 7/60.\n"]}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}"#;
    unlisted(Notebook, &[cell]);
    listed(Notebook, &[&cell.replace("7/60", "7/61")]);
    unlisted(
        Plain,
        &[
            "The rest is 18 (70 - 52 = 18).",
            "So P (X = 2) = 0.3 and f(x = 3) = 9.",
            "Codes (1 = yes, 2 = no) and 3 (= 1 + 2).",
        ],
    );
    listed(Plain, &["The rest (70 - 52 = 19) is here."]);
    listed(Html, &["<p>The rest (70 - 52 = 19) is here.</p>"]);
    listed(Latex, &["The rest (70 - 52 = 19) is here.", r"so the point $(x=\log_2 2^3=3, y=3\cdot 4 = 13)$ is"]);
}

#[test]
fn a_sign_of_degrees_on_one_term_is_for_all() {
    unlisted(Latex, &[r"$90-21.5^\circ = 68.5$"]);
    unlisted(Markdown, &["130.05° − 80.25 − 30 = 19.80°"]);
    listed(Latex, &[r"$90-21.5^\circ = 78.5$"]);
    listed(Markdown, &["130.05° − 80.25 − 30 = 29.80°"]);
}

#[test]
fn upright_sec_without_an_argument_is_the_second() {
    unlisted(
        Markdown,
        &[
            r"$$112000\,\text{sec} \times \frac{1\,\text{hour}}{3600\,\text{sec}} = 31.11\,\text{hours}$$",
            r"$\text{sec}(60^\circ) = 2$",
        ],
    );
    listed(
        Markdown,
        &[
            r"$$112000\,\text{sec} \times \frac{1\,\text{hour}}{3600\,\text{sec}} = 41.11\,\text{hours}$$",
            r"$\text{sec}(60^\circ) = 3$",
        ],
    );
}

#[test]
fn letters_behind_numbers_are_units_where_the_chain_makes_sense() {
    listed(
        Latex,
        &[
            r"$R = \frac{12.40mm+12.44mm+12.45mm}{3} = 12.83mm$",
            r"$Q=0.5\cdot 4186\cdot(100-30)=166510J$",
            r"$17 - 273 = -246K$",
            r"$V = \frac{2.5 \times 1.5}{1.7} = 2.31m^3$",
            r"$15\% \times 110g = 15g$",
            r"$u = 132.4 \times 0.05 = 0.00662V$",
            r"$E_k=\frac12\times0.2\times54.6^2=309.136\ J$",
            r"$\Delta H = \Delta H_{(1)} - \Delta H_{(2)} = (-383.5kJ) - (-253.5kJ) = -120kJ$",
        ],
    );
    unlisted(
        Latex,
        &[
            r"$R = \frac{12.40mm+12.44mm+12.45mm}{3} = 12.43mm$",
            r"$123.4mm = 0.1234m$",
            r"$10 + 4 = 2V$",
            r"$5m = 20$",
            r"$2m \cdot 3m = 6m$",
            r"$6 + 2m = 10m$",
            r"$12 - 2s = 4s$",
        ],
    );
}

#[test]
fn a_power_is_no_label() {
    listed(
        Latex,
        &[r"So $10^{\log 1000} = 10^3 = 3$ as expected.", r"\[ 3.9 \times 10^6 = 3200000 \]", r"\[10000=10^9\]"],
    );
    unlisted(Latex, &[r"So $10^{\log 1000} = 10^3 = 1000$ as expected.", r"\[ 3.9 \times 10^6 = 3900000 \]"]);
}

#[test]
fn a_subscript_may_be_a_base() {
    unlisted(Markdown, &[r"$1101_2 = 13_{10}$", r"$327_8 = 3\times 8^2 + 2 \times 8 + 7$", r"$101_{\text{two}} = 5$"]);
    listed(Markdown, &[r"$1101_2 = 14_{10}$", r"$327_8 = 3\times 8^2 + 2 \times 8 + 8$", r"$101_{\text{two}} = 6$"]);
}

#[test]
fn a_bracket_with_a_subscript_ends() {
    listed(Latex, &[r"\[ [\mathcal T]_{\mathcal B} = 3\cdot 4 = 13 \]"]);
    unlisted(Latex, &[r"\[ [\mathcal T]_{\mathcal B} = 3\cdot 4 = 12 \]"]);
}

#[cfg(feature = "cli")]
#[test]
fn what_stays_open_is_listed_as_unchecked() {
    use proofread::{CheckOptions, TextFormat, proofread};
    let unchecked = |text: &str, format: TextFormat| {
        let options = CheckOptions { unchecked: true, ..CheckOptions::default() };
        let report = proofread(text, format, options).expect("a text");
        report.unchecked.into_iter().map(|chain| (chain.kind, chain.name)).collect::<Vec<_>>()
    };
    for text in [r"$$1^2 (0.8) + 2^2 (0.2) =4.8$$", r"$\log_{10}(100) = 6$"] {
        let found = unchecked(text, Markdown);
        assert!(found.iter().any(|(_, name)| name.starts_with("sides that may agree")), "{text}: {found:?}");
    }
    assert_eq!(unchecked("$2 + 2 = 4$", Markdown), []);
}

#[test]
fn a_value_far_below_the_printed_one_is_shown_as_it_is() {
    let found = report(r"$6.63 \times 10^{-34} \times 480 \times 10^{-9} = 3.2 \times 10^{40}$", Latex).findings;
    assert_eq!(found[0].recomputed.as_deref(), Some("3.2 × 10^−40"));
}

#[test]
fn square_brackets_may_be_places_or_classes() {
    unlisted(
        Markdown,
        &[
            "I write place values in square brackets, so [6][3] = 63, and [4][12] = [5][2] = 52.",
            "e.g. 13 × 17 = [1 × 2][3 × 7] = [2][21] = 221",
            "$$+4 + -1 = [(5,1)] + [(1,2)] = [(5+1, 1+2)] = [(6,3)] = [(4,1)]$$",
            "For example, what if $3^5 = 6^3$; then wouldn't we need both?",
            "Since $31 = 14 + 17$, we have $31^3 = (14^3 + 17^3)$. This fallacy is known.",
        ],
    );
    listed(Markdown, &["$[6][3] + 45 = 64$", "We have $31^3 = (14^3 + 17^3)$. This is known."]);
}

/// Each kind of flag that was real in less than two of five cases at first contact.
#[test]
fn flags_that_were_seldom_real_are_doubts() {
    let doubt = |text: &str| report(text, Markdown).findings.iter().find_map(|of| of.doubt);
    for (text, why) in [
        // Digits that are not printed in a result of many.
        (r"$P = 0.9137\cdot 0.53164 = 0.4857632$", Doubt::Inputs),
        // A sign that is left out.
        ("We find the difference between scores, e.g., $2-5 = 3$ here.", Doubt::Fragment),
        ("Factor A has $t^2=-3.12^2 = 9.73$.", Doubt::Fragment),
        // A factor that only changes a number to per cent.
        (r"$80\% = \frac{80}{100} = .8 = .8*100 = 80\%$", Doubt::Fragment),
    ] {
        unlisted(Markdown, &[text]);
        assert_eq!(doubt(text), Some(why), "{text}");
    }
    listed(
        Markdown,
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
