//! Kinds of misreading that an eighteenth set of texts showed: each with a right formula, of which nothing is said, and a wrong one beside
//! it that still is listed.

use crate::{report, verdicts};
use proofread::{ReportSection, TextFormat};

/// How many pairs of a text are listed as wrong in their numbers.
fn on_numbers(text: &str, format: TextFormat) -> usize {
    report(text, format).findings.iter().filter(|of| of.section == ReportSection::Numbers).count()
}

/// Nothing in the first text is wrong; in the second one something is.
#[track_caller]
fn assert_told_apart(right: &str, wrong: &str, format: TextFormat) {
    assert_eq!(on_numbers(right, format), 0, "{right}");
    assert_ne!(on_numbers(wrong, format), 0, "{wrong}");
}

#[test]
fn money_is_printed_to_its_cents() {
    for [right, wrong] in [
        [r"$\$101.50 - \$100 = \$1.50$", r"$\$101.50 - \$100 = \$1.95$"],
        [r"$\$102.40 - \$100 = \$2.40$", r"$\$102.40 - \$100 = \$2.04$"],
        [r"$€101.50 - €100 = €1.50$", r"$€101.50 - €100 = €1.95$"],
        [r"$\$200 \times 1.05 = \$210.00$", r"$\$200 \times 1.05 = \$210.50$"],
        [r"$3 \times \$45 = \$135$", r"$3 \times \$45 = \$140$"],
        [r"$\$6/\$13 = 0.46$", r"$\$6/\$13 = 0.64$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    // With the sign before it, a sum is a printed number all the same.
    assert_eq!(verdicts(r"\$1.23 \times 3 = \$3.69"), ["consistent"]);
}

#[test]
fn a_result_with_many_digits_has_exact_operands() {
    for [right, wrong] in [
        ["$294/0.0001 = 2940000$", "$294/0.0001 = 2940002$"],
        [r"$\frac{48}{0.002} = 24000$", r"$\frac{48}{0.002} = 24001$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    // With as many digits in its operands, it may be of others than are printed.
    assert_eq!(on_numbers("$35.21/0.0103 = 3421$", TextFormat::Markdown), 0);
}

#[test]
fn digits_of_a_number_may_be_marked() {
    for [right, wrong] in [
        [r"$0.5 + 0.2250 = 0.7\underline{2}50$", r"$0.5 + 0.2250 = 0.7\underline{3}50$"],
        [r"$100 + 35 = 1\mathbf{3}5$", r"$100 + 35 = 1\mathbf{4}5$"],
        [r"$100 + 45 = 1\color{red}{4}5$", r"$100 + 45 = 1\color{red}{3}5$"],
        [r"$100 + 45 = 1\textcolor{red}{4}5$", r"$100 + 45 = 1\textcolor{red}{3}5$"],
        [r"$3 \times 45 = \underline{1}35$", r"$3 \times 45 = \underline{1}45$"],
        [r"$3 \times 45 = 13\boxed{5}$", r"$3 \times 45 = 13\boxed{4}$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
        assert_eq!(report(right, TextFormat::Markdown).findings[0].section, ReportSection::Agreeing, "{right}");
    }
    // Two numbers in braces are none.
    assert_eq!(on_numbers(r"$35 = {1}\;{36}$", TextFormat::Markdown), 0);
}

#[test]
fn a_letter_may_stand_for_the_modulus() {
    let text = |sum: &str| format!("Let $p = 13$ and reckon modulo $p$.\n\n\\[ 5 + 11 = {sum} \\]");
    assert_told_apart(&text("3"), &text("4"), TextFormat::Latex);
    assert_ne!(on_numbers("Let $q = 13$ and reckon modulo $p$.\n\n\\[ 5 + 11 = 4 \\]", TextFormat::Latex), 0);
}

#[test]
fn conditions_and_sets_end_a_statement() {
    for behind in [
        r"\text{ für } n = 3",
        r"\text{ falls } n = 3",
        r"\text{ pour } n = 3",
        r"\text{ para } n = 3",
        r"\in \mathbb{N}",
        r"\in \{1, 6\}",
        r"\notin \{1, 5\}",
    ] {
        let text = |product: &str| format!(r"$2 \cdot 3 = {product} {behind}$");
        assert_told_apart(&text("6"), &text("7"), TextFormat::Latex);
    }
}

#[test]
fn a_label_may_have_a_range_in_brackets() {
    assert_told_apart("Group 3 (12-15) = 7 people", "So 3 (15-12) = 7 people", TextFormat::Markdown);
    assert_ne!(on_numbers("So 3(12-15) = 7 people", TextFormat::Markdown), 0);
}

#[test]
fn a_low_point_multiplies_a_power_of_ten() {
    assert_told_apart("$3.10^2 = 300$", "$3.10^2 = 310$", TextFormat::Latex);
    assert_told_apart("$3 . 10^2 = 300$", "$3 . 10^2 = 310$", TextFormat::Latex);
    assert_eq!(on_numbers("$3.10^2 = 9.61$", TextFormat::Latex), 0);
}

#[test]
fn words_before_a_side_compute_with_it() {
    for [words, amount, result] in [
        ["Half of", "12", "6"],
        ["die Hälfte von", "12", "6"],
        ["ein Drittel von", "12", "4"],
        ["la moitié de", "12", "6"],
        ["Twice", "12", "24"],
    ] {
        let right = format!(r"{words} $ {amount}\,\text{{m}} = {result}\,\text{{m}}$").replace("$ ", "$");
        let wrong = right.replace(words, "It is");
        assert_told_apart(&right, &wrong, TextFormat::Markdown);
    }
}

#[test]
fn a_temperature_is_converted_with_its_uncertainty() {
    let celsius = |kelvin: &str| format!(r"$(20 \pm 0.5)\,^\circ\mathrm{{C}} = ({kelvin} \pm 0.5)\,\mathrm{{K}}$");
    assert_told_apart(&celsius("293.15"), &celsius("283.15"), TextFormat::Latex);
    let fahrenheit =
        |celsius: &str| format!(r"$(68 \pm 1)\,^\circ\mathrm{{F}} = ({celsius} \pm 0.6)\,^\circ\mathrm{{C}}$");
    assert_told_apart(&fahrenheit("20"), &fahrenheit("30"), TextFormat::Latex);
}

#[test]
fn a_rate_may_have_a_prefix_alone() {
    for [right, wrong] in [
        [r"$8/(25\,\text{M}) = 320\,\text{ns}$", r"$8/(25\,\text{M}) = 330\,\text{ns}$"],
        ["It takes 8/(25 M) = 320 ns.", "It takes 8/(25 M) = 330 ns."],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn a_negative_remainder_is_one_below_the_modulus() {
    let text = |remainder: &str| format!("Let $N = 221$. Reduce everything modulo $N$.\n\n- $162^1 = {remainder}$");
    assert_told_apart(&text("-59"), &text("-58"), TextFormat::Markdown);
}

#[test]
fn bits_have_an_exclusive_or() {
    let text = |words: &str| format!("Mit {words} wird umgeschaltet: für r=1 gilt 1^1=0 und sonst 0^1=1.");
    assert_told_apart(&text("XOR"), &text("Potenzen"), TextFormat::Markdown);
    assert_told_apart("- boolesch: $1+1=1$", "- hier: $1+1=1$", TextFormat::Markdown);
}

#[test]
fn empty_brackets_ask_whether_a_formula_holds() {
    let item = |mark: &str| format!("\\item {mark} $13^7 \\cdot 13^9 = 13^8$");
    for mark in ["( )", "(\\quad)"] {
        assert_told_apart(&item(mark), &item("(a)"), TextFormat::Latex);
    }
}

#[test]
fn a_decimal_comma_leaves_points_to_thousands() {
    let chain = |comma: &str| format!(r"$f = \frac{{300}}{{0{comma}03}} = \frac{{300 \cdot 100}}{{3}} = 10.000$");
    assert_told_apart(&chain(","), &chain(".").replace("10.000", "20.000"), TextFormat::Markdown);
}

#[test]
fn a_cross_denies_rows_that_begin_with_a_sign() {
    let row = |left: &str, right: &str| format!("<mtr><mtd>{left}</mtd><mtd><mo>=</mo></mtd><mtd>{right}</mtd></mtr>");
    let first = row("<mn>0</mn><mo>−</mo><mn>11</mn>", "<mn>12</mn>");
    let rows = |mark: &str| {
        let second = row("<mo>−</mo><mn>11</mn>", &format!("<mn>12</mn><mtext> {mark}</mtext>"));
        format!("<p><math><mtable>{first}{second}</mtable></math></p>")
    };
    assert_told_apart(&rows("✗"), &rows(""), TextFormat::Html);
}

#[test]
fn a_column_of_words_parts_equations_side_by_side() {
    let rows = |last: &str| {
        format!(
            r"$$\begin{{align*}} x &= 6 \cdot 2.5 && \text{{and}} & y &= 6 \cdot (-3)\\ &= 15.0 &&&& = {last} \end{{align*}}$$"
        )
    };
    for format in [TextFormat::Latex, TextFormat::Markdown] {
        assert_told_apart(&rows("-18"), &rows("-17"), format);
        let without = |last: &str| rows(last).replace(r"\text{and} &", "").replace("&&&&", "&&&");
        assert_told_apart(&without("-18"), &without("-17"), format);
    }
}
