//! Places in which chains were once neither read nor counted.

use crate::wrong;
use proofread::{CheckOptions, TextFormat, proofread};

/// Each text holds, and with other digits it does not.
#[track_caller]
fn holds_and_fails(text: &str, right: &str, other: &str, format: TextFormat) {
    let of = |text: &str| {
        let found = proofread(text, format, CheckOptions::default()).expect("it can be read");
        (found.tally.checked, found.findings.len())
    };
    let (holds, fails) = (text.replace("RESULT", right), text.replace("RESULT", other));
    assert_eq!(of(&holds), (1, 0), "{holds}");
    assert_eq!(of(&fails), (1, 1), "{fails}");
}

#[test]
fn displays_of_ieee_have_an_argument_before_their_rows() {
    for name in ["IEEEeqnarray*", "IEEEeqnarray"] {
        for format in [TextFormat::Latex, TextFormat::Markdown] {
            let text = format!("\\begin{{{name}}}{{rCl}}\n 31 \\cdot 7 &=& RESULT\n\\end{{{name}}}");
            holds_and_fails(&text, "217", "218", format);
        }
    }
    let text = "\\begin{empheq}[box=\\fbox]{align*}\n 31 \\cdot 7 &= RESULT\n\\end{empheq}";
    holds_and_fails(text, "217", "218", TextFormat::Latex);
}

#[test]
fn a_sign_of_per_cent_may_lack_its_backslash_in_markdown() {
    for text in [
        r"$$\frac{40-25}{25}\times 100% = RESULT\%$$",
        "$$\n\\frac{40-25}{25}\\times 100%\n= RESULT\\%\n$$",
        r"It is $15% \cdot 400% = RESULT%$.",
    ] {
        holds_and_fails(text, "60", "70", TextFormat::Markdown);
    }
    // A comment is none, wherever it stands, and is counted where a chain may be in it.
    let found = |text: &str, format| {
        let found = proofread(text, format, CheckOptions::default()).expect("it can be read");
        (found.tally.checked, found.findings.len(), found.not_read.total())
    };
    assert_eq!(found("$$4 + 5 = 9 % so 4 = 5\n$$", TextFormat::Markdown), (1, 0, 1));
    assert_eq!(found("$$4 + 5 = 9 % so it is\n$$", TextFormat::Markdown), (1, 0, 0));
    assert_eq!(found("\\[4 + 5 = 9% = 8\n\\]", TextFormat::Latex).1, 0);
}

#[test]
fn a_product_in_a_sum_goes_up_to_the_index_of_the_sum() {
    let sum = r"$$x = \frac{1}{1+\sum_{j=1}^{3}\prod_{k=1}^{j}\frac{k+1}{2k}} = RESULT = 0.303$$";
    let sum = sum.replace("0.303", "\\frac{RESULT}{1}");
    holds_and_fails(&sum, r"\frac{1}{3.25}", r"\frac{1}{3.75}", TextFormat::Markdown);
    holds_and_fails(r"$\sum_{i=1}^{3}\sum_{j=1}^{i} j = RESULT$", "10", "18", TextFormat::Markdown);
    // What is not computed is listed with its reason.
    let options = CheckOptions { unchecked: true, ..CheckOptions::default() };
    let text = r"$x = \frac{1}{\sum_{j=1}^{3}\sum_{k=1}^{j}\sum_{i=1}^{k} i} = \frac{1}{15} = 0.0667$";
    let found = proofread(text, TextFormat::Markdown, options).expect("it can be read");
    assert_eq!(found.findings.len(), 0);
    let names: Vec<&str> = found.unchecked.iter().map(|of| of.name.as_str()).collect();
    assert_eq!(names, ["a sum inside a sum"]);
}

#[test]
fn decimals_may_stand_in_groups_and_ohms_behind_comments() {
    holds_and_fails(r"$\frac{1}{4000} = RESULT$", r"0.000\,25", r"0.000\,35", TextFormat::Latex);
    holds_and_fails(r"$2.5 \cdot 3.7 = RESULT$", r"9\,.25", r"9\,.35", TextFormat::Latex);
    let ohm = "\\unit{k%\n%TCIMACRO{\\U{3a9}}%\n%BeginExpansion\n\\Omega%\n%EndExpansion\n}";
    let law = format!("$4\\unit{{mA}} \\cdot 3{ohm} = RESULT\\unit{{V}}$");
    holds_and_fails(&law, "12", "14", TextFormat::Latex);
    let law = r"$4\unit{A} \cdot 3\unit{\Omega} = RESULT\unit{V}$";
    holds_and_fails(law, "12", "14", TextFormat::Latex);
}

#[test]
fn texts_of_links_and_captions_are_read() {
    for text in [
        "See [31 × 7 = RESULT](a.html) there.",
        "![Cost: 31 × 7 = RESULT](a.png)",
        "As [told](b.html#x), it is 31 × 7 = RESULT here.",
    ] {
        holds_and_fails(text, "217", "218", TextFormat::Markdown);
    }
    // An address is no text, and a bracket behind another one is a factor.
    assert_eq!(wrong("See [there](a.html?1+1=3) for 2 + 2 = 4.", TextFormat::Markdown), [""; 0]);
    holds_and_fails("So [2 + 3](4) = RESULT.", "20", "21", TextFormat::Plain);
}

#[test]
fn grid_tables_have_totals() {
    let table = "+-------+------+\n| Item  | Cost |\n+=======+======+\n| Pens  | 1250 |\n+-------+------+\n| Paper | 3025 |\n\
        +-------+------+\n| Ink   | 4700 |\n+-------+------+\n| Total | 8975 |\n+-------+------+\n";
    let listed = |text: &str| proofread::find_statistics(text, TextFormat::Markdown).expect("a text").findings.len();
    assert_eq!(listed(table), 0);
    assert_eq!(listed(&table.replace("8975", "9875")), 1);
}

#[test]
fn arithmetic_in_code_is_read() {
    for (text, right, other) in [
        ("It is `7 * 6 = RESULT` here.", "42", "41"),
        ("So `2**11 (= RESULT)`.", "2,048", "1,024"),
        ("The sum is `7 + 15 = RESULT` metres.", "22", "23"),
        ("Thus ``96 / 4 - 3 = RESULT``", "21", "22"),
    ] {
        holds_and_fails(text, right, other, TextFormat::Markdown);
    }
    // What only a program means is code.
    for code in [
        "i = 0",
        "7 // 2 = 3",
        "1010 + 0001 = 1111",
        "0.1 + 0.2 = 0.30000000000000004",
        "5 ^ 3 = 6",
        "x = 2 + 3",
        "1 + 1 == 3",
    ] {
        assert_eq!(wrong(&format!("Then `{code}` there."), TextFormat::Markdown), [""; 0], "{code}");
    }
}

#[test]
fn two_equal_digits_before_dots_are_no_period() {
    assert_eq!(
        wrong(r"$1/17 \approx 0.0588\dots$, $3/29 \approx 0.1034\dots$, $1/3 = 0.33\dots$", TextFormat::Markdown),
        [""; 0]
    );
    assert_eq!(wrong(r"$1/17 \approx 0.0577\dots$", TextFormat::Markdown).len(), 1);
    assert_eq!(wrong(r"$1/3 = 0.3334\dots$", TextFormat::Markdown).len(), 1);
}

#[test]
fn a_word_for_a_large_number_before_a_currency_may_count_the_other_side() {
    assert_eq!(wrong("So 40 − 15 = 25 thousand dollars.", TextFormat::Markdown), [""; 0]);
    assert_eq!(wrong("So 40 − 15 = 27 thousand dollars.", TextFormat::Markdown).len(), 1);
}

#[test]
fn a_sum_of_fractions_is_not_rounded_to_zero() {
    let found = |text: &str| {
        let options = CheckOptions::default();
        let findings = proofread(text, TextFormat::Markdown, options).expect("it can be read").findings;
        findings.iter().map(|of| of.section.name()).collect::<Vec<_>>()
    };
    assert_eq!(found("$1/5 - 1/2 = 0$"), ["numbers"]);
    assert_eq!(found(r"$\frac13 + \frac16 - \frac12 = 0$"), [""; 0]);
    assert_eq!(found(r"$\sqrt{2} \cdot \sqrt{2} - 2 = 0$"), [""; 0]);
    // An integer division.
    assert_eq!(found("$1/4 = 0$"), ["doubts"]);
    assert_eq!(found(r"$0.3 - 1/4 = 0$, $1/5 - 1/2 \approx 0$"), [""; 0]);
}

#[test]
fn a_chain_goes_on_in_the_next_line() {
    for format in [TextFormat::Markdown, TextFormat::Plain] {
        holds_and_fails("For all of the pumps it is 31 × 7 =\nRESULT hours in all.", "217", "218", format);
        holds_and_fails(
            "All of these are one product, 1.21 × 2.50 ×\n4 × 2.10 = RESULT, as told.",
            "25.41",
            "75.41",
            format,
        );
        holds_and_fails("All of these are one product, 12 × 25\n× 4 = RESULT, as told.", "1200", "1300", format);
    }
    // What stands in short lines, in lists or below a heading is not one line.
    for text in [
        "We know 1.5 + 2 =\n7\n2",
        "A heading of 3 lamps for 12 pumps\n===\n4 = 4",
        "The pumps of the house number 12 +\n- 4 + 4 = 8",
    ] {
        assert_eq!(wrong(text, TextFormat::Plain), [""; 0], "{text}");
    }
}

#[test]
fn shortcodes_of_hugo_are_no_part_of_a_formula() {
    holds_and_fails("It remains {{< math >}}$ 9 - 5 = RESULT ${{< /math >}}.", "4", "3", TextFormat::Markdown);
    let before = "So {{< math >}}$ 42 \\bmod 13 ${{< /math >}} or ";
    holds_and_fails(
        &format!("{before}{{{{< math >}}}}$ 42 - 39 = RESULT ${{{{< /math >}}}}."),
        "3",
        "4",
        TextFormat::Markdown,
    );
    holds_and_fails("Text.\n\n{{< math >}}$9 - 5 = RESULT${{< /math >}}", "4", "3", TextFormat::Markdown);
    holds_and_fails("So:\n\n$\n2^5 = RESULT \\\\\n$\n", "32", "31", TextFormat::Markdown);
}

#[test]
fn columns_a_calculation_that_runs_on_and_binary_multiples_are_told_apart() {
    let found = |text: &str| {
        let options = CheckOptions::default();
        let findings = proofread(text, TextFormat::Markdown, options).expect("it can be read").findings;
        findings.iter().map(|of| of.section.name()).collect::<Vec<_>>()
    };
    assert_eq!(found(r"$\binom{8+15}{14+25} = \binom{23}{39}$"), [""; 0]);
    assert_eq!(found(r"$\binom{8+15}{14+25} = \binom{23}{29}$"), ["numbers"]);
    assert_eq!(found(r"$\binom{5}{2} = \binom{5}{3}$, $\binom{3}{5} = 0$"), [""; 0]);
    assert_eq!(found("So $95-64=31-16=15-8=7$."), ["doubts"; 2]);
    // Each step must go on with the result.
    assert_eq!(found("So $95-64=32-16=16$."), ["numbers"]);
    assert_eq!(found("So $95-64=31-16$."), ["numbers"]);
    assert_eq!(found("So 2^40 = 1T, 2^16 = 64 K and 2^20 = 1 M."), [""; 0]);
    assert_eq!(found("So 2^41 = 1T."), ["numbers"]);
}

#[test]
fn degrees_of_temperature_may_lack_their_scale() {
    assert_eq!(wrong("It costs about 0.5 g × 4.184 J/g/K × 230° = 480 J, roughly.", TextFormat::Plain), [""; 0]);
}
