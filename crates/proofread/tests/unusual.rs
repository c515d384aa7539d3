//! Notations that only some texts have, each in a right chain of ours that must not be listed, beside a wrong one that must.

use crate::{assert_told_apart, on_numbers, report};
use proofread::{ReportSection, TextFormat};

fn on(list: ReportSection, text: &str, format: TextFormat) -> Vec<String> {
    let findings = report(text, format).findings;
    findings.into_iter().filter(|of| of.section == list).map(|of| format!("{} | {}", of.left, of.right)).collect()
}

#[track_caller]
pub(crate) fn unlisted(format: TextFormat, texts: &[&str]) {
    for text in texts {
        assert_eq!(on(ReportSection::Numbers, text, format), [""; 0], "{text}");
    }
}

#[track_caller]
pub(crate) fn listed(format: TextFormat, texts: &[&str]) {
    for text in texts {
        assert_ne!(on(ReportSection::Numbers, text, format), [""; 0], "{text}");
    }
}

#[test]
fn a_label_before_a_chain_is_no_factor() {
    unlisted(
        TextFormat::Plain,
        &[
            "5.1 (3 + 4) · 2 = 14",
            "[5] 3 + 4 = 7",
            "Day 3 — 12 · 4 = 48",
            "(1) 5 + 1 = 6 (2) 5 + 2 = 7",
            "2- 5 + 2 = 7",
            "line 12 · 0.05 = 20.60",
        ],
    );
    listed(TextFormat::Plain, &["(3 + 4) · 2 = 15", "12 - 3 · 4 = 13", "5 + 1 = 7"]);
    unlisted(TextFormat::Markdown, &[r"$[2]\ 3\cdot4=12$", r"$2^\circ\ 3\cdot4=12$", r"$(1)\ -3+4=1$"]);
}

#[test]
fn what_is_in_brackets_behind_a_result_is_no_factor() {
    unlisted(
        TextFormat::Markdown,
        &[
            r"$20/2.0=10.0\ (9.97)$",
            r"$\arcsin0.6=36.9^\circ\ (0.644\ \mathrm{rad})$",
            r"$25+273=298\ (298.15)\ \mathrm K$",
            r"$12(0.5)=6.0\ \mathrm W\ (\pm5\%)$",
            r"$1/6=0.1(6)$",
            r"$12.5(3)\times2=25.0(6)$",
            r"$3\times4=12^{(3)}$",
            r"$3\times4=12\hfill(3)$",
            "3 × 5 = 15[2]",
            "3 × 4 = 12 – (1)",
        ],
    );
    listed(TextFormat::Markdown, &[r"$20/2.0=12.0\ (9.97)$", r"$1/6=0.3(6)$", r"$12.5(3)\times2=26.0(6)$"]);
}

#[test]
fn decimals_and_thousands_are_parted_in_many_ways() {
    unlisted(
        TextFormat::Markdown,
        &[
            r"$3{\cdot}5\times2=7{\cdot}0$",
            r"$\log_{10}2=0\cdot3010$",
            r"$1'000+500=1'500$ and $1\:000+500=1\;500$",
            "1,20,000 + 6,000 = 1,26,000",
            r"$1{,}5\cdot2=3{,}0\quad(2.3)$ and $0{,}438\cdot1000=438$",
        ],
    );
    listed(
        TextFormat::Markdown,
        &[r"$3{\cdot}5\times2=8{\cdot}0$", r"$1'000+500=1'600$", "1,20,000 + 6,000 = 1,36,000"],
    );
}

#[test]
fn angles_and_temperatures_lose_their_signs() {
    unlisted(
        TextFormat::Markdown,
        &[
            r"$10.0\cos60^0=5.00$",
            r"$\tan^{-1}(-4/3)=-53.1^\circ=306.9^\circ$",
            r"$255\,\mathrm K=-18\,^\circ\mathrm C$",
            r"$300\,\mathrm K = 27^\circ$C",
            "20C = 293K",
        ],
    );
    listed(
        TextFormat::Markdown,
        &[r"$10.0\cos60^0=6.00$", r"$-53.1^\circ=316.9^\circ$", r"$255\,\mathrm K=-28\,^\circ\mathrm C$"],
    );
}

#[test]
fn a_letter_with_a_number_put_in_is_no_unit() {
    unlisted(
        TextFormat::Plain,
        &[
            "f = 1/T = 1/0.02 = 50 Hz",
            "v² = 2*g*h = 2*9.81*5 = 98.1",
            "R = 1/h + 0.1 = 1/10 + 0.1 = 0.2",
            "1/F = 1/D + 1/d",
            "E = 3kT/2 = 3 · 1.38e-23 · 300/2",
        ],
    );
    listed(TextFormat::Plain, &["f = 1/T = 1/0.0200 = 60.0", "12.0 m/4.0 s = 4.0 m/s"]);
}

#[test]
fn words_join_numbers() {
    unlisted(
        TextFormat::Plain,
        &[
            "5 times 3 = 15",
            "the sum of 3 and 4 = 7",
            "28.47 − initial 0.32 = 28.15",
            "interest on 8000 = 8000 · 1.1 − 8000 = 800",
            "24 = 2 by 12",
            "At 22°C = 19.8 torr",
        ],
    );
    unlisted(TextFormat::Plain, &["P = 12 V ×\n0.25 A = 3.0 W", "P = 12 V\n× 0.25 A = 3.0 W"]);
    listed(TextFormat::Plain, &["times\n5 + 3 = 9", "so 5 + 3 = 9", "The interest is 80.5 · 1.100 − 80.5 = 9.05"]);
}

#[test]
fn other_arithmetic_is_not_reckoned_with() {
    unlisted(
        TextFormat::Markdown,
        &[
            r"$5^{-1} = 3$ in $\mathbb{Z}_7$.",
            "In Boolean algebra 1 + 1 = 1.",
            "11111010 + 1 = 11111011, −6 + 1 = 11111011",
            "[7] + [8] = [3]",
            "89-12-30 + 01-00-00 = 90-12-30",
        ],
    );
    unlisted(TextFormat::Plain, &["Sta. 12+50 to Sta. 15+75 = 325 ft", "1914–1918 = 4", "1-1/2 + 2-3/4 = 4-1/4 in"]);
    listed(TextFormat::Markdown, &["$5^{-1} = 3$ in the end.", "1 + 1 = 1", "1-1/2 + 2-3/4 = 5"]);
}

#[test]
fn a_row_that_begins_with_a_sign_or_a_bracket_may_be_an_equation() {
    unlisted(
        TextFormat::Latex,
        &[
            "\\begin{align*} 0.25\\cdot4 &= 1.0 \\\\\n -2\\cdot3 &= -6 \\end{align*}",
            "\\begin{align*} [X] &= 0.35/0.7 = 0.5 \\\\\n [Y] &= 0.6/0.2 = 3 \\end{align*}",
            "\\begin{align*} x &= 3\\cdot4 &&\\text{with 2 of them}\\\\ &= 12 &&\\text{by (3)} \\end{align*}",
        ],
    );
    listed(
        TextFormat::Latex,
        &[
            "\\begin{align*} [X] &= 0.35/0.7 = 0.6 \\\\\n [Y] &= 0.6/0.2 = 3 \\end{align*}",
            "\\begin{align*} x &= 3\\cdot4 &&\\text{with 2 of them}\\\\ &= 13 \\end{align*}",
        ],
    );
}

#[test]
fn what_is_struck_out_is_no_text() {
    unlisted(
        TextFormat::Markdown,
        &["~~3 × 4 = 13~~ 3 × 4 = 12", "<del>3 × 4 = 13</del>", "<!-- 3 × 4 = 13 -->", "see http://a.org/?q=3+4=8"],
    );
    unlisted(TextFormat::Latex, &[r"\iffalse $2+2=5$ \fi $2+2=4$"]);
    listed(TextFormat::Markdown, &["3 × 4 = 13", "~ 3 × 4 = 13 ~", "$x~~y$ and 3 × 4 = 13"]);
    listed(TextFormat::Latex, &[r"\iffalse $2+2=4$ \fi $2+2=5$"]);
}

#[test]
fn a_step_between_may_be_rounded() {
    unlisted(TextFormat::Markdown, &[r"$1.00 \times 1454.95\,\text{Pa} = 1450\,\text{Pa} = 1.455\,\text{kPa}$"]);
    listed(TextFormat::Markdown, &[r"$1.00 \times 1454.95\,\text{Pa} = 1450\,\text{Pa} = 1.435\,\text{kPa}$"]);
}

#[test]
fn prefixes_are_understood_with_the_units() {
    let right = r"$I=\frac{5-1.0}{10+190}=20\,\mathrm{\mu A}$";
    unlisted(TextFormat::Latex, &[right]);
    assert_eq!(on(ReportSection::Units, right, TextFormat::Latex).len(), 1);
    listed(TextFormat::Latex, &[r"$I=\frac{5-1.0}{10+190}=30\,\mathrm{\mu A}$"]);
}

#[test]
fn a_quotient_may_end_before_a_power_of_ten() {
    unlisted(TextFormat::Latex, &[r"$\frac{60/20 \times 10^6}{(10.0)^2}=30\times10^3$"]);
    unlisted(TextFormat::Latex, &[r"$15000/(\pi/4\times10^2)=191$"]);
    listed(
        TextFormat::Latex,
        &[r"$\frac{60/20 \times 10^6}{(10.0)^2}=40\times10^3$", r"$15000/(\pi/4\times10^2)=291$"],
    );
}

#[test]
fn what_a_document_sets_to_nothing_is_not_printed() {
    let text = |body: &str| format!("\\newcommand{{\\hint}}[1]{body}\n\\hint{{ $2+2=5$ }}");
    unlisted(TextFormat::Latex, &[&text("{}")]);
    listed(TextFormat::Latex, &[&text("{#1}"), &format!("{} $3+3=7$", text("{}"))]);
}

#[test]
fn two_columns_go_on_in_their_own_rows_if_the_first_row_does() {
    let rows =
        |last: &str| format!("\\begin{{align*}} a &= 2\\cdot3 & &= 6 \\\\ b &= 4\\cdot5 & &= {last} \\end{{align*}}");
    unlisted(TextFormat::Latex, &[&rows("20")]);
    listed(TextFormat::Latex, &[&rows("21")]);
}

#[test]
fn a_decimal_in_brackets_says_a_fraction_once_more() {
    unlisted(TextFormat::Markdown, &["$x = 0.75/1 = 3/4 (0.75)$"]);
    listed(TextFormat::Markdown, &["$x = 0.75/1 = 3/4 (0.74)$", "$x = 0.75/1 = 3/5 (0.6)$"]);
}

#[test]
fn a_byte_and_a_deviation_by_its_size_are_doubts() {
    for text in ["$10000011 = -2^7 + 2^1 + 2^0 = -125$", r"$$\frac{4.9-5.0}{5.0}\times100\%=2.0\%$$"] {
        unlisted(TextFormat::Markdown, &[text]);
        assert_eq!(on(ReportSection::Doubts, text, TextFormat::Markdown).len(), 1, "{text}");
    }
    listed(TextFormat::Markdown, &["$131 = -2^7 + 2^1 + 2^0 = -125$", r"$$\frac{4.9-5.0}{5.0}\times100\%=3.0\%$$"]);
}

#[test]
fn an_exponent_belongs_to_the_last_letter() {
    let chain = |result: &str| {
        format!(
            "<p><math><msup><mrow><mn>4</mn><mi>π</mi></mrow><mn>2</mn></msup><mo>=</mo><mn>{result}</mn></math></p>"
        )
    };
    unlisted(TextFormat::Html, &[&chain("39.5")]);
    listed(TextFormat::Html, &[&chain("157.9")]);
    unlisted(TextFormat::Latex, &["${4\\pi}^2 = 39.5$"]);
}

#[test]
fn a_column_that_is_added_is_no_fraction() {
    let sum = |first: &str| {
        format!(
            "<p><math><mfrac><mrow>{first}<mn>13.7</mn></mrow><mn>15.2</mn></mfrac><mo>=</mo><mn>15.2</mn></math></p>"
        )
    };
    unlisted(TextFormat::Html, &[&sum("<mo>+</mo>")]);
    listed(TextFormat::Html, &[&sum("")]);
}

#[test]
fn a_column_with_strokes_is_a_fraction_of_fractions() {
    let column = |notation: &str| {
        let cell = |inner: &str| format!("<mtr><mtd>{inner}</mtd></mtr>");
        let top = format!("<mfrac><mn>7</mn><menclose notation='{notation}'><mn>100</mn></menclose></mfrac>");
        let rows = [cell(&top), cell("<mn>40</mn>"), cell("<mn>100</mn>")].concat();
        format!(
            "<p><math><mi>p</mi><mo>=</mo><mtable>{rows}</mtable><mo>=</mo><mfrac><mn>7</mn><mn>40</mn></mfrac></math></p>"
        )
    };
    unlisted(TextFormat::Html, &[&column("bottom")]);
    listed(TextFormat::Html, &[&column("circle")]);
}

#[test]
fn a_letter_in_a_sum_is_no_unit() {
    let right = "<p><math><mn>25</mn><mo>+</mo><mn>4</mn><mo>=</mo><mtext>A</mtext><mo>+</mo><mn>1</mn></math></p>";
    unlisted(TextFormat::Html, &[right]);
    listed(TextFormat::Html, &[&right.replace("<mtext>A</mtext>", "<mn>27</mn>")]);
}

#[test]
fn a_bracket_before_a_formula_may_be_a_factor() {
    let text = |before: &str| {
        format!(
            "<p>The area is {before}<math><mfrac><mn>2</mn><mn>5</mn></mfrac><mo>=</mo><mfrac><mn>4</mn><mn>5</mn></mfrac></math></p>"
        )
    };
    unlisted(TextFormat::Html, &[&text("(4 − 2)")]);
    assert_eq!(on(ReportSection::Doubts, &text("(4 − 2)"), TextFormat::Html).len(), 1);
    listed(TextFormat::Html, &[&text("")]);
}

#[test]
fn kilograms_in_a_pressure_are_their_weight() {
    let chain = |result: &str| format!(r"$1.0\,\text{{kg/cm}}^2 = {result}\,\text{{N/m}}^2$");
    assert_eq!(on(ReportSection::Units, &chain(r"9.8\times10^4"), TextFormat::Markdown).len(), 1);
    listed(TextFormat::Markdown, &[&chain(r"8.9\times10^4")]);
}

#[test]
fn what_replaces_a_number_struck_out_is_no_exponent() {
    unlisted(TextFormat::Latex, &[r"$\frac{35-5}{1}=\cancel{30}^{\ 5}$"]);
    listed(TextFormat::Latex, &[r"$\frac{35-5}{1}=\cancel{31}$", r"$\frac{35-5}{1}=30^{\ 5}$"]);
}

#[test]
fn decibels_are_as_coarse_as_they_are_printed() {
    unlisted(TextFormat::Latex, &[r"$K=\frac{5}{2\cdot4} = -4$ dB, so"]);
    listed(TextFormat::Latex, &[r"$K=\frac{5}{2\cdot4} = -5$ dB, so", r"$K=\frac{5}{2\cdot4} = -4$, so"]);
}

#[test]
fn an_angle_behind_a_stroke_is_one_of_a_phasor() {
    let chain =
        |sign: &str| format!(r"$10\underline{{/30{sign}}}\cdot2\underline{{/-10{sign}}}=20\underline{{/20{sign}}}$");
    unlisted(TextFormat::Latex, &[&chain(r"^\circ")]);
    listed(TextFormat::Latex, &[&chain(""), r"$360^\circ/30^\circ = 13$"]);
}

#[test]
fn an_angle_in_brackets_belongs_to_the_function() {
    unlisted(TextFormat::Latex, &[r"$30\cos 2(30^\circ) = 15.0$", r"$4\sin 30^\circ(2.0) = 4.0$"]);
    listed(TextFormat::Latex, &[r"$30\cos 2(30^\circ) = 15.1$", r"$4\sin 30^\circ(2.0) = 4.5$"]);
}

#[test]
fn a_private_command_behind_a_formula_may_be_a_unit() {
    unlisted(TextFormat::Latex, &[r"$370.4\times30 = 11.11$\kW{} here"]);
    listed(TextFormat::Latex, &[r"$370.4\times30 = 12.11$\kW{} here", r"$370.4\times30 = 11.11$\foo{} here"]);
}

#[test]
fn two_lists_may_be_equal() {
    unlisted(TextFormat::Latex, &[r"$a, b=\frac{12\cdot4}{6},\ \frac{12\cdot2}{6}=8,\ 4$ kN"]);
    listed(TextFormat::Latex, &[r"$a=\frac{12\cdot4}{6},\ \frac{12\cdot2}{6}=8$ kN"]);
}

#[test]
fn numbers_of_equations_are_a_doubt() {
    let text = "$(1)+(2)=(4)$";
    unlisted(TextFormat::Latex, &[text]);
    assert_eq!(on(ReportSection::Doubts, text, TextFormat::Latex).len(), 1);
    listed(TextFormat::Latex, &["$(1)+(2)=4$"]);
}

#[test]
fn au_may_be_a_unit_of_mass() {
    unlisted(TextFormat::Latex, &[r"$14.00\text{ au} = 2.32\times10^{-26}\text{ kg}$"]);
    listed(TextFormat::Latex, &[r"$14.00\text{ au} = 2.32\times10^{12}\text{ m}$"]);
}

#[test]
fn what_a_drawing_defines_holds_in_it_alone() {
    let text = |name: &str| format!("\\begin{{{name}}} \\def\\d{{7}} \\end{{{name}}} $\\d + 1.5 = 8.6$");
    unlisted(TextFormat::Latex, &[&text("tikzpicture"), &text("axis")]);
    listed(TextFormat::Latex, &[&text("center")]);
}

#[test]
fn a_comma_is_the_sign_of_decimals_in_quantities() {
    unlisted(TextFormat::Latex, &[r"$\SI{0,002}{A}+\SI{0,003}{A} = \SI{0,005}{A}$"]);
    listed(TextFormat::Latex, &[r"$\SI{0,002}{A}+\SI{0,003}{A} = \SI{0,006}{A}$"]);
}

#[test]
fn an_exponent_behind_brackets_may_belong_to_the_function() {
    unlisted(
        TextFormat::Latex,
        &[r"$1 + \frac{\pi^2}{\ln(0.05)^2} = 2.0997$", r"$\ln(3.0^2) = 2.2$", r"$\sin(30^\circ)^2 = 0.25$"],
    );
    listed(TextFormat::Latex, &[r"$1 + \frac{\pi^2}{\ln(0.05)^2} = 2.1997$", r"$\sin(30^\circ)^2 = 0.35$"]);
}

#[test]
fn directions_differ_by_whole_turns() {
    unlisted(TextFormat::Latex, &[r"$-(180^\circ + 180^\circ)-180^\circ = 180^\circ$"]);
    listed(TextFormat::Latex, &[r"$-(180^\circ + 180^\circ)-180^\circ = 170^\circ$"]);
}

#[test]
fn a_letter_e_that_is_set_is_no_number() {
    unlisted(TextFormat::Latex, &["$e^{-1}=1$"]);
    listed(TextFormat::Latex, &["$e^{-1}=0.47$", "$2e^{-1}=1$"]);
}

#[test]
fn a_unit_with_two_meanings_is_a_doubt_if_its_dimension_differs() {
    let text = |unit: &str| format!(r"$8.01\times10^{{-30}}\,\mathrm{{C\,m}} = 2.4\,\mathrm{{{unit}}}$");
    unlisted(TextFormat::Latex, &[&text("D")]);
    listed(TextFormat::Latex, &[&text("V")]);
}

#[test]
fn a_name_without_its_unit_says_nothing_of_dimensions() {
    let text = |last: &str| format!(r"$t=0$ $x(t) = (3 \text{{ m/s}})t+2 \text{{ m}}$ {last}");
    unlisted(TextFormat::Latex, &[&text("")]);
    listed(TextFormat::Latex, &[&text(r"$(3 \text{ m/s})+2 \text{ m} = 6\text{ m}$")]);
}

#[test]
fn letters_at_a_number_in_running_text_are_a_factor() {
    unlisted(TextFormat::Markdown, &["51*420 - 30 = 348Tc\n"]);
    listed(TextFormat::Markdown, &["51*420 - 30 = 348 Tc\n", "51*420 - 30 = 348W\n"]);
}

#[test]
fn a_letter_behind_a_digit_may_be_the_base_of_the_logarithms() {
    let peak = |value: &str| format!("The peak is at **S = 1/(2e) ≈ {value}** there.");
    assert_told_apart(&peak("0.184"), &peak("0.194"), TextFormat::Markdown);
    let third = |value: &str| format!("It is 1/(3e) = {value} here.");
    assert_told_apart(&third("0.123"), &third("0.132"), TextFormat::Markdown);
}

#[test]
fn a_hyphen_or_a_stroke_may_stand_in_a_name() {
    let period = |years: &str| format!("It is relative to a base period (currently {years} = 100).");
    assert_told_apart(&period("1982-1984"), &period("1984-1982"), TextFormat::Markdown);
    let codes = |codes: &str| format!("Lost packets ({codes} = 0-100%).");
    assert_told_apart(&codes("0-255"), &codes("255-3"), TextFormat::Markdown);
    let network = |words: &str| format!("It follows {words} with the **10/8 = 4,096** rule.");
    assert_told_apart(&network("the IP plan"), &network("a plan"), TextFormat::Markdown);
    let quotient = |quotient: &str, rest: &str| format!("$3 \\div 2 = {quotient}$ {rest}");
    assert_told_apart(&quotient("1", "remainder 1"), &quotient("3", "remainder 1"), TextFormat::Markdown);
    assert_ne!(on_numbers(&quotient("1", "exactly"), TextFormat::Markdown), 0);
}

#[test]
fn a_negative_number_may_be_added_without_brackets() {
    unlisted(TextFormat::Markdown, &[r"$$5 \cdot 3 + -4 \cdot 2 = 7$$", r"$\sqrt{3^2 + -2^2 + 2^2 + 7^2} = 8.124$"]);
    listed(TextFormat::Markdown, &[r"$$5 \cdot 3 + -4 \cdot 2 = 8$$"]);
}

#[test]
fn a_display_may_begin_with_a_minus_sign() {
    unlisted(TextFormat::Latex, &[r"So we have \[ -2.5 \times 4 = -10 \] here."]);
    listed(TextFormat::Latex, &[r"So we have \[ -2.5 \times 4 = -11 \] here."]);
    // One that goes on from a display does not.
    unlisted(TextFormat::Latex, &[r"\[ 1 + 2 \] \[ -2.5 \times 4 = -11 \]"]);
}
