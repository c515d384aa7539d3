//! Kinds of misreading that an eighteenth set of texts showed: each with a right formula, of which nothing is said, and a wrong one beside
//! it that still is listed.

use crate::{assert_told_apart, on_numbers, report, verdicts};
use proofread::{ReportSection, TextFormat};

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

#[test]
fn words_of_a_formula_are_no_number() {
    // In a page with single dollar signs, such a formula is read as a line.
    let line = |words: &str| format!("<p>{words} 2004 = 300 + 20 = 320<br></p>");
    assert_told_apart(&line(r"Sales\:\:in\:\:"), &line("").replace("2004", "200 + 4"), TextFormat::Html);
    let share = |words: &str| format!(r"<p>3\%\:\:{words}\:\:500 = 0.03 * 500 = 15<br></p>");
    assert_eq!(on_numbers(&share("of"), TextFormat::Html), 0);
}

#[test]
fn an_estimate_has_the_exact_value_in_brackets_behind_it() {
    for [right, wrong] in [
        [
            r"$\frac12 + 1 = 1\frac12 \left(1\frac{5}{24}\right)$",
            r"$\frac12 + 1 = 1\frac13 \left(1\frac{5}{24}\right)$",
        ],
        [r"$3 + 2 = 5\; (4\frac78)$", r"$3 + 2 = 6\; (4\frac78)$"],
        [r"$0.5 + 0.2 = 0.7\,(0.68)$", r"$0.5 + 0.2 = 0.8\,(0.68)$"],
        // Far from it, the bracket is a factor.
        [r"$3 + 2 = 5\; (4\frac78)$", r"$3 + 2 = 5\; (2\frac78)$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn a_text_calls_a_formula_false() {
    for [right, wrong, format] in [
        ["we obtain the false statement <q><m>2^2 - 3 = 0</m>.</q>", "we obtain <q><m>2^2 - 3 = 0</m>.</q>", "xml"],
        ["<p>since <m>3 + 7 = 11</m> is a not a true equation.</p>", "<p>since <m>3 + 7 = 11</m> is one.</p>", "xml"],
        ["<p>Plug in: <m>1 + 0 = 0 + 4</m>, impossible.</p>", "<p>Plug in: <m>1 + 0 = 0 + 4</m>, possible.</p>", "xml"],
        [
            "<p>Which of the following are statements?</p> <m>3 + 4 = 8</m>.",
            "<p>Which of the following are sums?</p> <m>3 + 4 = 8</m>.",
            "xml",
        ],
        ["What is wrong with the following? \\item $3 + 5 = 9$", "Reckon the following. \\item $3 + 5 = 9$", "tex"],
        ["c) $3*6 = 6*(-3)$ (falsch) &", "c) $3*6 = 6*(-3)$ (wahr) &", "tex"],
        ["It is $3 + 4 = 8$ ✗", "It is $3 + 4 = 8$ ✓", "md"],
        ["It is $3 + 4 = 8$ Wrong!", "It is $3 + 4 = 8$ Wrong signs are often made.", "md"],
    ] {
        let format = TextFormat::from_extension(format).expect("a format");
        assert_told_apart(right, wrong, format);
    }
}

#[test]
fn a_number_element_may_have_letters() {
    let formula = |first: &str| format!("<math><mn>{first}</mn><mo>+</mo><mn>1</mn><mo>=</mo><mn>7</mn></math>");
    assert_told_apart(&formula("2y"), &formula("2"), TextFormat::Xml);
    assert_told_apart(&formula("2ax"), &formula("2"), TextFormat::Xml);
}

#[test]
fn points_of_a_curve_are_added_by_another_law() {
    for sum in ["(0,2)+(1,0) = (3,4)", "2(4,6) = (7,9)"] {
        let text = |curve: &str| format!("On {curve}, we have ${sum}$.");
        assert_told_apart(&text("this elliptic curve"), &text("this plane"), TextFormat::Latex);
    }
    assert_ne!(on_numbers("On this elliptic curve, $3 + 4 = 8$.", TextFormat::Latex), 0);
}

#[test]
fn bits_have_their_own_sums_and_signs() {
    let field = |sign: &str| format!("Die Nullstellen in {sign}: $1^2+1+1 = 1 + 0$.");
    assert_told_apart(&field("𝔽_2"), &field("𝔽_3"), TextFormat::Latex);
    let element = "<msub><mi>𝔽</mi><mn>2</mn></msub>";
    assert_told_apart(&field(element), &field(&element.replace('2', "3")), TextFormat::Latex);
    let item = |words: &str| format!("- 10 - 11 = 1 {words}: When subtracting");
    assert_told_apart(&item("with a borrow"), &item("in all"), TextFormat::Markdown);
    assert_told_apart("$1000_2 = -8_{10}$", "$1000_2 = -7_{10}$", TextFormat::Markdown);
}

#[test]
fn symbols_of_residues_look_like_fractions() {
    let define = |name: &str| format!("\\newcommand{{\\{name}}}[2]{{\\left(\\frac{{#1}}{{#2}}\\right)}}\n");
    let text = |name: &str| {
        define(name) + &format!("$\\{name}{{3 \\cdot 23}}{{389}} = \\{name}{{3}}{{389}} \\cdot \\{name}{{23}}{{389}}$")
    };
    assert_told_apart(&text("legendre"), &text("quot"), TextFormat::Latex);
    let words = |of: &str| format!("The {of} is $(-1) \\cdot \\left(\\frac{{1}}{{3}}\\right) = -1$.");
    assert_told_apart(&words("Jacobi symbol"), &words("product"), TextFormat::Latex);
}

#[test]
fn cells_that_begin_with_an_approximation_are_apart() {
    let row = |sign: &str| {
        format!(
            r"\[ \begin{{array}}{{ccc}} f & {sign} 1.98 & {sign} 2.71 \\ g & {sign} 3.98 & {sign} 4.71 \end{{array}} \]"
        )
    };
    assert_eq!(on_numbers(&row(r"\approx"), TextFormat::Latex), 0);
    assert_ne!(
        on_numbers(r"\[ \begin{array}{cc} f & \approx 1.98 + 1 \\ & \approx 4.71 \end{array} \]", TextFormat::Latex),
        0
    );
}

#[test]
fn a_row_below_two_solutions_is_another_one() {
    let rows = |or: &str| format!("$$\\begin{{aligned}} x &= 2 + 3 {or} x = 2 - 3 \\\\ &= 5 \\quad \\end{{aligned}}$$");
    assert_eq!(on_numbers(&rows("\\quad \\text{or} \\quad"), TextFormat::Markdown), 0);
    assert_ne!(on_numbers("$$\\begin{aligned} x &= 2 - 3 \\\\ &= 5 \\end{aligned}$$", TextFormat::Markdown), 0);
}

#[test]
fn units_and_dots_have_more_spellings() {
    for [right, wrong] in [
        [
            r"$(\SI{2}{\ampere})^2 \cdot \SI{50}{\milli\Omega} = \SI{0.2}{\watt}$",
            r"$(\SI{2}{\ampere})^2 \cdot \SI{50}{\milli\Omega} = \SI{0.3}{\watt}$",
        ],
        [
            r"$2\,\mathrm{A} \cdot 3\,\mathrm{V}\,\mathrm{mi} = 360\,\mathrm{J}$",
            r"$2\,\mathrm{A} \cdot 3\,\mathrm{V}\,\mathrm{min} = 380\,\mathrm{J}$",
        ],
        [r"$\mathrm{60\,(m)m = 60\left(\frac{1}{1000}\right)m}$", r"$\mathrm{60\,m = 60\left(\frac{1}{1000}\right)m}$"],
        [
            r"$\sin^{-1}\left(\frac{8}{15}\right) \approx 32.2309...^\circ$",
            r"$\sin^{-1}\left(\frac{8}{15}\right) \approx 33.2309...^\circ$",
        ],
    ] {
        assert_told_apart(right, wrong, TextFormat::Latex);
    }
}

#[test]
fn letters_with_coefficients_are_no_units() {
    assert_told_apart("The budget is 100 = 5J + 10N.", "The energy is 60 J = 40 J + 30 J.", TextFormat::Markdown);
}

#[test]
fn a_stroke_with_space_around_it_is_the_outer_one() {
    assert_told_apart("x = -50/7 / -2/7 = 25", "x = -50/7 / -2/7 = 24", TextFormat::Markdown);
}

#[test]
fn a_large_exponent_takes_all_digits() {
    let power = |n: u32| format!(r"$\left(1 - \frac{{1}}{{10^{{{n}}}}}\right)^{{10^{{{n}}}}} \approx e^{{-1}}$");
    assert_told_apart(&power(20), &power(20).replace("10^{20}", "3"), TextFormat::Latex);
}

#[test]
fn textbooks_round_angles_to_degrees() {
    for [right, wrong] in [
        [r"$\frac{3}{4} = \tan 37^\circ$", r"$\frac{3}{4} = \tan 39^\circ$"],
        [r"$\sin 53^\circ = \frac45$", r"$\sin 50^\circ = \frac45$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Latex);
    }
}

#[test]
fn running_text_is_read_in_any_language_of_xml() {
    for text in ["<para>We need 252×16 = 4042 of them.</para>", "<p>So 2*3=7 joules <me>x</me></p>"] {
        assert_ne!(on_numbers(text, TextFormat::Xml), 0, "{text}");
    }
    for text in
        ["<para>We need 252×16 = 4032 of them.</para>", "<p><m>x</m> and <c>2*3=7</c> <program>2*3=7</program></p>"]
    {
        assert_eq!(on_numbers(text, TextFormat::Xml), 0, "{text}");
    }
}

#[test]
fn letters_of_quantities_stand_behind_signs_of_products() {
    assert_told_apart("So h = 150 m = 0.5·g·3^2 here.", "So h = 150 m = 0.5·3 m·3 here.", TextFormat::Markdown);
    assert_told_apart("It is 8/(5.43A°)^3 = 5 × 10^22.", "It is 8/(5.43 m)^3 = 5 × 10^22 m^-3.", TextFormat::Markdown);
}

#[test]
fn a_chunk_ends_with_its_line_of_marks_in_html_and_in_lists_too() {
    for before in [
        "<center>\n```{r}\n\nx <- 1\n```\n</center>\n\n",
        "1. Item.\n\n    ```{r}\nx <- 1\n```\n\n1. ",
        "<div>\n\n```{r}\ny <- 2\n```\n\n</div>\n\n",
    ] {
        let text = |result: &str| format!("{before}So $0.9\\cdot 0.9 = {result}$.\n");
        assert_told_apart(&text("0.81"), &text("0.85"), TextFormat::Markdown);
        let code = before.replace(" 1\n```", " 1\n2 + 2 = 5\n```").replace(" 2\n```", " 2\n2 + 2 = 5\n```");
        let report = report(&code, TextFormat::Markdown);
        assert!(report.findings.is_empty(), "{code}");
        assert_eq!(report.not_read.total(), 1, "{code}");
    }
}
