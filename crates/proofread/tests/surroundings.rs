//! What stands around a formula: units, brackets, questions, remarks and ends of lines. Of a right formula nothing is said, and a wrong one
//! beside it is listed.

use crate::{assert_told_apart, on_numbers, report};
use proofread::{ReportSection, TextFormat};

/// The chain was compared and is right.
#[track_caller]
fn assert_compared(text: &str, format: TextFormat) {
    let report = report(text, format);
    assert_ne!(report.tally.pairs, 0, "{text}");
    assert_eq!(on_numbers(text, format), 0, "{text}");
}

#[test]
fn slips_by_a_factor_of_two_in_whole_numbers_are_no_habit() {
    let text = |sums: [&str; 3]| sums.map(|sum| format!("It is ${sum}$.\n\n")).concat();
    let slips = text(["(4)(6) + (4)(11) = 24 + 44 + 68", "9/3 + 18/3 = 3 + 6 + 9", "4 + 5 = 18"]);
    assert_eq!(on_numbers(&slips, TextFormat::Markdown), 3);
    // With decimals, a diameter may be meant throughout, or a unit of another size.
    let habit = text(["2.5 + 1.5 = 8.0", "6.0 + 3.0 = 18.0", "3.5 + 1.5 = 10.0"]);
    assert_eq!(on_numbers(&habit, TextFormat::Markdown), 0);
    // So may minutes be left out of whole numbers.
    let minutes = text(["2 + 1 = 180", "4 + 5 = 540", "3 + 4 = 420"]);
    assert_eq!(on_numbers(&minutes, TextFormat::Markdown), 0);
}

#[test]
fn a_fraction_behind_an_approximation_is_near() {
    for [right, wrong] in [
        [r"$\sqrt5 \approx 9/4$", r"$\sqrt5 \approx 7/2$"],
        [r"$\cos(1.318) \approx 1/4$", r"$\cos(1.318) \approx 0/2501$"],
        [r"$0.2501 \approx \frac14$", r"$0.2501 \approx -\frac14$"],
        [r"$\ln 1.08 \approx \ln 1$", r"$\ln 1.08 \approx 1/3$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn a_formula_goes_on_behind_a_unit_or_a_bracket() {
    for [right, wrong] in [
        ["So $97$% $= 0.97$ holds.", "So $97$% $= 0.96$ holds."],
        [r"So $97$\% $= 0.97$ holds.", r"So $97$\% $= 0.96$ holds."],
        ["It is $3 \\cdot 2$ m $= 600$ cm.", "It is $3 \\cdot 2$ m $= 500$ cm."],
        ["It is $0.96$ ($10$ ounces) $= 9.6$.", "It is $0.96$ ($10$ ounces) $= 9.7$."],
        ["It is $0.96$ (10 ounces) $= 9.6$.", "It is $0.96$ (10 ounces) $= 9.7$."],
        ["It is $v = 36$ km/h $= 10$ m/s.", "It is $v = 36$ km/h $= 11$ m/s."],
    ] {
        for format in [TextFormat::Markdown, TextFormat::Latex] {
            if right.contains('%') && format == TextFormat::Latex && !right.contains('\\') {
                continue;
            }
            assert_told_apart(right, wrong, format);
            assert_compared(right, format);
        }
    }
    for [right, wrong] in [
        ["<p>So <m>97</m>%<m>=0.97</m>.</p>", "<p>So <m>97</m>%<m>=0.96</m>.</p>"],
        ["<p><m>0.96</m> (<m>10</m> ounces) <m>=9.6</m></p>", "<p><m>0.96</m> (<m>10</m> ounces) <m>=9.7</m></p>"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Xml);
        assert_compared(right, TextFormat::Xml);
    }
    assert_told_apart(r"<p>It is \(5\) m \(= 500\) cm.</p>", r"<p>It is \(5\) m \(= 600\) cm.</p>", TextFormat::Html);
    // Other words, sentences and paragraphs part formulas.
    for text in ["$3$ apples $= 4$", "It is $3$. $= 4$", "It is $3$ m\n\n$= 4$ m", "It is $3$ in $= 4$"] {
        assert_eq!(report(text, TextFormat::Markdown).tally.pairs, 0, "{text}");
    }
    // The formula in a bracket of its own is read by itself.
    assert_told_apart("$x$ is $3$ ($2 + 1 = 3$) here", "$x$ is $3$ ($2 + 1 = 4$) here", TextFormat::Markdown);
    assert_told_apart("$3$ ($2$) ($2 + 1 = 3$)", "$3$ ($2$) ($2 + 1 = 4$)", TextFormat::Markdown);
}

#[test]
fn a_question_in_what_follows_does_not_ask_about_a_formula() {
    for (asks, says) in [
        (r"Is it true that $3 + 4 = 8$ in all cases?", r"\subtask{It is $3 + 4 = 8$} \subtask{What is it?}"),
        (r"Is it so, and does $3 + 4 = 8$ \emph{always} hold?", r"\question{It is $3 + 4 = 8$} \question{Why?}"),
        (r"Is it so that $3 + 4 = 8$ \textbf{or not?}", r"It is $3 + 4 = 8$ \section{Why?}"),
        (r"Does \[3 + 4 = 8\] hold?", "It is $3 + 4 = 8$\n\nWhy?"),
        ("Does\n\n\\[3 + 4 = 8\\]\n\nhold?", "It is $3 + 4 = 8$ \\subsection*{What is next?}"),
    ] {
        assert_told_apart(asks, says, TextFormat::Latex);
    }
    assert_told_apart(
        "<p>Is it true that <m>3 + 4 = 8</m> for all of them?</p>",
        "<p>It is <m>3 + 4 = 8</m></p><p>Why?</p>",
        TextFormat::Xml,
    );
    assert_told_apart("Is it true that $3 + 4 = 8$\nholds?", "It is $3 + 4 = 8$\n# Why?", TextFormat::Markdown);
}

#[test]
fn a_question_for_a_number_does_not_ask_whether_an_equation_holds() {
    for start in ["How many numbers below 90 share a factor with", "There are some. How many of them are prime to"] {
        let text = |product: &str| format!("{start} $90 = {product}$?");
        assert_told_apart(&text(r"2 \times 3^2 \times 5"), &text(r"2 \times 3^2 \times 7"), TextFormat::Markdown);
    }
    for text in ["Is it true that $90 = 2 \\times 7$?", "Which is right, $4 + 5 = 8$?"] {
        assert_eq!(on_numbers(text, TextFormat::Markdown), 0, "{text}");
    }
}

#[test]
fn a_product_may_be_broken_behind_its_sign() {
    let text = |result: &str| {
        format!(
            "Then of these throws about one in four will be such a one, or 1/4 x\n1/4 x 1/4 = {result}. Remember that.\n"
        )
    };
    assert_told_apart(&text("1/64"), &text("1/63"), TextFormat::Markdown);
    let letter = "The value that we look for here is called x\n1/4 x 1/4 = 1/16. Remember that.\n";
    assert_eq!(on_numbers(letter, TextFormat::Markdown), 0);
}

#[test]
fn an_entry_of_a_matrix_is_no_number_of_choices() {
    assert_eq!(on_numbers("The prices are C(1,1) = 5.4321 and C(2,1) = 3.25.", TextFormat::Plain), 0);
    assert_ne!(on_numbers("There are C(4,2) = 7 of them.", TextFormat::Plain), 0);
    assert_ne!(on_numbers("$C(4,2) = 0.500^2 \\cdot 20$", TextFormat::Markdown), 0);
}

#[test]
fn quotients_and_products_of_units_are_read() {
    for [right, wrong] in [
        [r"$2 \cdot 3\,\si{\frac{1}{s}} = 6\,\si{Hz}$", r"$2 \cdot 3\,\si{\frac{1}{s}} = 7\,\si{Hz}$"],
        [
            r"$\SI{72}{\frac{\kilo\metre}{\hour}} = \SI{20}{\metre\per\second}$",
            r"$\SI{72}{\frac{\kilo\metre}{\hour}} = \SI{25}{\metre\per\second}$",
        ],
        [r"$2 \cdot 3\,\si{Vs} = 6\,\si{\weber}$", r"$2 \cdot 3\,\si{Vs} = 7\,\si{\weber}$"],
        [
            r"$3\,\mathrm{V} \cdot 2\,\mathrm{A} = 6\,\mathrm{VA}$",
            r"$3\,\mathrm{V} \cdot 2\,\mathrm{A} = 7\,\mathrm{VA}$",
        ],
        [
            r"$\SI{2}{\ampere}\cdot\SI{85}{\m\Omega} = \SI{170}{\milli\volt}$",
            r"$\SI{2}{\ampere}\cdot\SI{85}{\m\Omega} = \SI{180}{\milli\volt}$",
        ],
    ] {
        assert_told_apart(right, wrong, TextFormat::Latex);
        assert_compared(right, TextFormat::Latex);
    }
    // However deep they nest, they end.
    let deep = format!(r"$\si{{{}s{}}} = 3$", r"\frac{1}{".repeat(5000), "}".repeat(5000));
    assert_eq!(on_numbers(&deep, TextFormat::Latex), 0);
}

#[test]
fn a_number_with_an_inverse_unit_is_a_printed_one() {
    for [right, wrong] in [
        [r"$26.6/\text{s} = 1595/\text{min}$", r"$26.6/\text{s} = 1605/\text{min}$"],
        [
            r"$26.6\,\frac{1}{\text{s}} = 1595\,\frac{1}{\text{min}}$",
            r"$26.6\,\frac{1}{\text{s}} = 1605\,\frac{1}{\text{min}}$",
        ],
        [
            r"$\SI{26.6}{\frac{1}{s}} = \SI{1595}{\frac{1}{min}}$",
            r"$\SI{26.6}{\frac{1}{s}} = \SI{1605}{\frac{1}{min}}$",
        ],
    ] {
        assert_told_apart(right, wrong, TextFormat::Latex);
        assert_compared(right, TextFormat::Latex);
    }
}

#[test]
fn a_thousand_has_a_letter_of_its_own() {
    for [right, wrong] in [
        [r"$48\text{k} = 48000$", r"$48\text{k} = 49000$"],
        [r"$12 \cdot 4\text{k} = 48\text{k}$", r"$12 \cdot 4\text{k} = 49\text{k}$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
        assert_compared(right, TextFormat::Markdown);
    }
    // A letter apart, or an italic one, is a unit or a quantity.
    for text in [r"$27\,\text{k} = 300$", "$48k = 49000$"] {
        assert_eq!(on_numbers(text, TextFormat::Markdown), 0, "{text}");
    }
}

#[test]
fn arrows_have_short_names() {
    for arrow in [r"\RA", r"\Ra", r"\Rarr", r"\ra", r"\imp"] {
        let text = |sum: &str| format!("$3 + 4 = 7 {arrow} 2 + 2 = {sum}$");
        assert_told_apart(&text("4"), &text("5"), TextFormat::Latex);
        assert_compared(&text("4"), TextFormat::Latex);
    }
    // A definition of its own comes first.
    assert_eq!(on_numbers("\\newcommand{\\ra}{x}$3 + 4 = 8\\ra$", TextFormat::Latex), 0);
}

#[test]
fn a_stroke_with_space_in_the_source_is_the_outer_one() {
    assert_told_apart("$-100/3 / -4/3 = 25$", "$-100/3 / -4/3 = 24$", TextFormat::Latex);
    assert_ne!(on_numbers("$-100/3/-4/3 = 25$", TextFormat::Latex), 0);
}

#[test]
fn digits_that_a_computer_loses_are_not_compared() {
    for [right, wrong] in [
        [r"$10^{22} + 1 - 10^{22} = 1$", r"$10^{2} + 1 - 10^{2} = 2$"],
        [r"$(1 - 10^{-22})^{10^{22}} \approx e^{-1}$", r"$(1 - 10^{-2})^{10^{2}} \approx e^{1}$"],
        [r"$12345678901234567 - 12345678901234566 = 1$", r"$12345678901 - 12345678900 = 2$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Latex);
        assert_eq!(report(right, TextFormat::Latex).tally.pairs, 0, "{right}");
    }
    assert_compared("$2^{20} - 2^{20} = 0$", TextFormat::Latex);
}

#[test]
fn a_factor_is_told_by_its_change() {
    for [right, wrong] in [
        [r"$1.1^2 = 1.21 = 21\%$", r"$1.1^2 = 1.21 = 22\%$"],
        [r"$1.40 = 40\%$", r"$1.40 = 45\%$"],
        [r"$1.02^{10} = 21.9\%$", r"$1.02^{10} = 21.5\%$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn per_cent_beside_a_number_is_all_of_it() {
    assert_told_apart(r"$97\% = 0.97$", r"$97\% = 0.96$", TextFormat::Markdown);
    // What a share amounts to is something else.
    assert_eq!(on_numbers(r"$5\% = 12$", TextFormat::Markdown), 0);
}

#[test]
fn what_is_counted_may_be_taken_up_to_the_next_whole_number() {
    for words in ["It needs full turns.", "This is rounded up.", "We take the next whole number."] {
        let text = |words: &str| format!("$N = 2157/4.79 = 451$. {words}");
        assert_told_apart(&text(words), &text("It is a number."), TextFormat::Markdown);
        let far = text(words).replace("451", "452");
        assert_ne!(on_numbers(&far, TextFormat::Markdown), 0, "{far}");
    }
}

#[test]
fn a_cell_with_an_approximation_begins_nothing_for_the_next_one() {
    let row = |value: &str| {
        format!(r"\[ \begin{{array}}{{cc}} T = \frac12(1 + 3) \approx {value} & \approx 2.71 \end{{array}} \]")
    };
    assert_told_apart(&row("2.00"), &row("3.00"), TextFormat::Latex);
}

#[test]
fn angles_are_in_radians_by_their_whole_name() {
    for [right, wrong] in [
        [r"$30^\circ = 0.5236\text{ radians}$", r"$30^\circ = 0.6236\text{ radians}$"],
        [r"$1.22/3.00 = 0.407\text{ radians}$", r"$1.22/3.00 = 0.470\text{ radians}$"],
        [r"$36^\circ = \frac{\pi}{5}\text{ radians}$", r"$36^\circ = \frac{\pi}{6}\text{ radians}$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
        assert_compared(right, TextFormat::Markdown);
    }
}

#[test]
fn a_remark_says_to_how_many_digits_a_result_is_given() {
    for remark in [r"\text{ (to 3 s.f.)}", r"\text{ (3 sf)}", r"\text{ (1 d.p.)}", "(3 \\text{ significant figures})"] {
        let text = |result: &str| format!(r"$4 \cdot 4.03 = {result} {remark}$");
        assert_told_apart(&text("16.1"), &text("16.7"), TextFormat::Latex);
        assert_compared(&text("16.1"), TextFormat::Latex);
    }
    // A number in a bracket is a factor.
    assert_compared(r"$4 (3) = 12$", TextFormat::Latex);
}

#[test]
fn a_sentence_begins_behind_a_result() {
    for word in ["Yes", "Now", "We", "Simplify", "Wir", "Sei"] {
        let text = |sum: &str| format!("<p>10 + 20 + 13 = {sum} {word} it is.</p>");
        assert_told_apart(&text("43"), &text("44"), TextFormat::Html);
        assert_compared(&text("43"), TextFormat::Html);
    }
}

#[test]
fn a_whole_unit_of_the_last_digit_is_not_cut_off() {
    for [right, wrong] in [
        [r"$0.5\,\text{kg} = 500\,\text{g}$", r"$0.5\,\text{kg} = 600\,\text{g}$"],
        [r"$30^\circ = 0.52\,\text{rad}$", r"$30^\circ = 0.6236\,\text{rad}$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    // What goes beyond by less is cut off.
    assert_eq!(on_numbers("$1/18 = 0.0555$", TextFormat::Markdown), 0);
}

#[test]
fn a_line_that_ends_in_a_document_by_openstax_ends_for_its_arithmetic() {
    let paragraph = |line: &str| format!("<para>Mean = 0.12 mm\n<newline/>{line}\n<newline/>as above</para>");
    assert_told_apart(&paragraph("0.12 mm x 60 = 7.2 mm"), &paragraph("0.12 mm x 60 = 8.2 mm"), TextFormat::Xml);
}

#[test]
fn products_and_quotients_of_italic_letters_are_units() {
    for [right, wrong] in [
        ["$c = 2.5/0.0125 = 200 m/s$", "$c = 2.5/0.0125 = 300 m/s$"],
        [
            r"$c_1 = \frac{m}{A_1\rho_1} = 2.5/0.01227 = 203.7m/s$",
            r"$c_1 = \frac{m}{A_1\rho_1} = 2.5/0.01827 = 203.7m/s$",
        ],
        [r"$Q_w = 4kg/s/1000 kg/m^3 = 0.004m^3/s$", r"$Q_w = 4kg/s/1000 kg/m^3 = 8.004m^3/s$"],
        [r"$Q_{air} = 30 m/s\times 0.2m^2 = 6m^3/s$", r"$Q_{air} = 90 m/s\times 0.2m^2 = 6m^3/s$"],
        [
            r"$$m = 2.0 \space kg + 3.0 \space kg = 5.0 \space kg$$",
            r"$$m = 2.0 \space kg + 3.0 \space kg = 6.0 \space kg$$",
        ],
        [r"$I R = 20A (5m\Omega) = 100mV$", r"$I R = 20A (5m\Omega) = 200mV$"],
        [
            r"$P = 10 \space bar \times \frac{100,000 \space Pa}{1 \space bar} = 1,000,000 \space Pa$",
            r"$P = 10 \space bar \times \frac{100,000 \space Pa}{1 \space bar} = 1,200,000 \space Pa$",
        ],
        [r"$F = 65\,kg \cdot 9.81\,\frac{m}{s^2} = 638\,N$", r"$F = 65\,kg \cdot 9.81\,\frac{m}{s^2} = 738\,N$"],
        [
            r"$w = -0.987 atm (+2 \space L) = -1.974 \space L \space atm$",
            r"$w = -0.987 atm (+2 \space L) = -1.874 \space L \space atm$",
        ],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
        assert_compared(right, TextFormat::Markdown);
    }
}

#[test]
fn italic_letters_that_give_other_dimensions_are_no_units() {
    for text in [
        "$4.2N - 1.2N = (0.05m - 0.02m)m$",
        "$(2l+1) = 2(3)+1$",
        "$100 = 5J + 10N$",
        r"$4000\,kg \cdot 2\,m = 7\,J$",
        r"$\frac{\pi - 0.3239}{8\pi}T = 0.4484\,T$",
        r"$3A + 5m/s = 7m/s$",
    ] {
        let report = report(text, TextFormat::Markdown);
        assert_eq!((report.tally.pairs, report.findings.len()), (0, 0), "{text}");
    }
}

#[test]
fn numbers_that_differ_are_no_matter_of_units() {
    // What a difference leaves open has zero in it, so that it agrees with anything times a large enough factor.
    for [right, wrong] in [
        [r"$\frac{481.1 - 5(9.8)^2}{4} = 0.225$", r"$\frac{481.1 - 5(9.8)^2}{4} = 9.3$"],
        [r"$\frac{32.1-2(4.0)^2}{4} = 0.025$", r"$\frac{32.1-2(4.0)^2}{4} = 7.0$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn dollar_signs_in_the_columns_of_a_table_are_no_formulas() {
    for table in [r"tabular}{>{$}c<{$}}", r"tabular}[t]{|>{$}r<{$}|l|}", r"tabularx}{\textwidth}{>{$}c<{$}X}"] {
        let name = table.split('}').next().unwrap_or_default();
        let text = |sum: &str| format!("\\begin{{{table}\n a & b\n\\end{{{name}}} It is ${sum}$ there.");
        assert_told_apart(&text("2+2=4"), &text("2+2=5"), TextFormat::Latex);
        assert_compared(&text("2+2=4"), TextFormat::Latex);
    }
}

#[test]
fn brackets_may_be_those_of_integer_parts_and_orders_of_elements() {
    for [right, wrong] in [
        ["By the greatest integer function, $[-1.4] + [0.8] = -2 + 0$.", "In all, $[-1.4] + [0.8] = -2 + 0$."],
        [
            "By the greatest integer function it is so. And $(49,000)(1,200) = 58,800,000$.",
            "By the greatest integer function it is so. And $(49,000)(1,200) = 49,000$.",
        ],
        ["The least integer function gives $[2.27) + [0.63) = 3 + 1$.", "It is $[2.27] + [0.63] = 3 + 1$."],
        [r"In $(\mathbb Z/20)^\times$ it is $|-9| = 2$.", r"Of course it is $|-9| + 0.5 = 2.5$."],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn two_pairs_in_a_product_are_no_decimals() {
    let right = r"It is $(0,3)\cdot(1/2,5) = 0 + 15 = 15$.";
    let wrong = r"It is $(0.3)\cdot(1/2.5) = 0 + 15 = 15$.";
    assert_told_apart(right, wrong, TextFormat::Markdown);
    assert_told_apart(right, &right.replace("15 = 15", "15 = 16"), TextFormat::Markdown);
}

#[test]
fn a_factor_of_degrees_stands_before_an_angle_in_radians() {
    for [right, wrong] in [
        [
            r"$360^\circ - \frac{180}{\pi}\tan^{-1}(3/4) \approx 323^\circ$",
            r"$360^\circ - \frac{180}{\pi}\tan^{-1}(3/4) \approx 333^\circ$",
        ],
        [r"$90^\circ + \frac{180}{\pi}\arctan(1) = 135^\circ$", r"$90^\circ + \frac{180}{\pi}\arctan(1) = 145^\circ$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn a_logarithm_with_a_capital_has_its_base_behind_it() {
    assert_told_apart("Log10(1,000) = 3", "Log10(1,000) = 4", TextFormat::Plain);
    assert_told_apart("Log2(32) = 5", "Log2(32) = 6", TextFormat::Plain);
}

#[test]
fn a_number_and_a_word_with_a_hyphen_are_one_word() {
    assert_told_apart(
        r"$\text{3-day rate} = 1.000695 - 1 = 0.000695$",
        r"$\text{3-day rate} = 1.000695 - 1 = 0.000795$",
        TextFormat::Markdown,
    );
    assert_told_apart(r"$\text{5-2} = 3$", r"$\text{5-2} = 4$", TextFormat::Markdown);
}

#[test]
fn a_letter_behind_a_power_of_two_is_one_of_binary_sizes() {
    assert_told_apart("2^37 = 2^7 G", "2^37 = 2^8", TextFormat::Plain);
}

#[test]
fn a_result_with_decimals_and_a_power_of_ten_is_rounded() {
    assert_told_apart(
        r"$\frac{(0.15)^2}{(0.025)^3} = 1.4\times10^3$",
        r"$\frac{(0.15)^2}{(0.025)^3} = 1.6\times10^3$",
        TextFormat::Markdown,
    );
}

#[test]
fn rounded_terms_change_the_last_digit_of_a_sum() {
    let listed = |text: &str| {
        let found = report(text, TextFormat::Markdown).findings;
        found.iter().any(|of| matches!(of.section, ReportSection::Numbers | ReportSection::LessCertain))
    };
    for [right, wrong] in [
        ["$15 - 6.7188 = 8.2813$", "$15 - 6.7188 = 8.2811$"],
        ["$6.65 + 0.05 + 7.03 + 7.76 + 0.06 + 8.21 = 29.75$", "$6.65 + 0.05 + 7.03 + 7.76 + 0.06 + 8.21 = 29.74$"],
    ] {
        assert!(!listed(right) && listed(wrong), "{right} {wrong}");
    }
    // What was rounded up does not end in a five.
    assert!(listed("$1 - 0.9294 = 0.0707$"));
    // A few terms of two decimals add up to theirs.
    assert!(listed("$12.34 + 5.67 = 18.02$"));
}

#[test]
fn what_is_counted_or_labelled_cancels() {
    for [right, wrong] in [
        [
            r"$100\text{ g water}\times\frac{1\text{ mol water}}{18.0\text{ g water}} = 5.56\text{ mol water}$",
            "5.56|5.96",
        ],
        [r"$\frac{0.16\text{ mol methanol}}{0.750\text{ L solution}} = 0.21\text{ M}$", "0.21|0.31"],
        [r"$\frac{-494\text{ MeV}}{56} = -8.82\text{ MeV/nucleon}$", "494|498"],
        [r"$\frac{25{,}000 \text{ units}}{500 \text{ mL}} = 50 \text{ units/mL}$", "= 50|= 40"],
        [r"$3 \text{ tsp} \times 5 \text{ mL/tsp} = 15 \text{ mL}$", "15|16"],
        [r"$1200 \text{ mg/day} \times \frac{1 \text{ day}}{2 \text{ doses}} = 600 \text{ mg/dose}$", "600|500"],
        [
            r"$637.2\,\text{g}\,\ce{NH3}\times\frac{1\,\text{mol}\,\ce{NH3}}{17.03\,\text{g}\,\ce{NH3}}=37.42\,\text{mol}$",
            "37.42|38.42",
        ],
        [r"$1/10 = 0.1 \text{ Gyr}^{-1}$", "0.1|6.1"],
        [r"$2.0\text{ Myr} + 500\text{ kyr} = 2.5\text{ Myr}$", "2.5|2.7"],
    ] {
        let (from, to) = wrong.split_once('|').expect("two numbers");
        let wrong = right.replace(from, to);
        assert_told_apart(right, &wrong, TextFormat::Markdown);
        assert_compared(right, TextFormat::Markdown);
    }
    // Other things are counted on the two sides, or what one side says is no label.
    for text in [
        r"$3 \text{ apples} + 4 \text{ pears} = 8 \text{ fruits}$",
        r"$2 \cdot 3 \text{ units/mL} \cdot 4\text{ mL} = 9 \text{ doses}$",
        r"$5\text{ km east} + 3\text{ km west} = 2\text{ km east}$",
        r"$2\text{ mol Al} = 3\text{ mol Cl2}$",
    ] {
        assert_eq!(on_numbers(text, TextFormat::Markdown), 0, "{text}");
    }
    let shown = report(r"$2 \cdot 3 \text{ units/mL} \cdot 4\text{ mL} = 25 \text{ units}$", TextFormat::Markdown);
    assert!(shown.findings.iter().any(|of| of.right == "25 units"), "{:?}", shown.findings);
}

#[test]
fn an_approximation_with_many_digits_is_meant_to_be_right() {
    for [right, wrong] in [
        [
            r"$\sqrt{1670^2+108000^2}\approx 108,013\text{ km/h}$",
            r"$\sqrt{1670^2+108600^2}\approx 108,013\text{ km/h}$",
        ],
        [r"$7.15/3.55 \approx 2.0$", r"$7.15/3.95 \approx 2.0$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    // A whole number may count pieces.
    assert_eq!(on_numbers(r"$7.15/3.95 \approx 2$", TextFormat::Markdown), 0);
}
