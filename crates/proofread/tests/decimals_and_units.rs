//! Notations of texts that reckon with decimals and units: right chains of ours that must not be listed, beside wrong ones that must.

use crate::report;
use crate::unusual::{listed, unlisted};
use proofread::TextFormat::{Html, Latex, Markdown, Notebook, Plain};
use proofread::{Doubt, ReportSection, TextFormat};

#[track_caller]
fn of_inputs(texts: &[&str]) {
    for text in texts {
        let findings = report(text, Markdown).findings;
        let doubts: Vec<_> =
            findings.iter().filter(|of| of.section != ReportSection::Agreeing).map(|of| of.doubt).collect();
        assert_eq!(doubts, [Some(Doubt::Inputs)], "{text}");
    }
}

#[test]
fn rounded_numbers_leave_some_results_open() {
    of_inputs(&[
        // The same number twice.
        "$1.27^2 = 1.63$",
        "$4\\pi(1.27)^2 = 20.1$",
        // The exponent of e.
        "$e^{-0.37} = 0.692$",
        // Two factors with the digits of the result.
        "$0.9518 \\times 0.387 = 0.369$",
        // Shares, each with its own rounding.
        "$1 - 0.0127 - 0.1176 = 0.8698$",
        // A difference with more digits than its terms.
        "$47.812 - 46.927 = 0.8855$",
    ]);
    listed(
        Markdown,
        &[
            "$1.27^2 = 1.36$",
            "$2.31^2 = 5.341$",
            "$4\\pi(1.27)^2 = 21.2$",
            "$e^{-0.37} = 0.629$",
            "$0.9518 \\times 0.387 = 0.386$",
            "$1 - 0.0127 - 0.1176 = 0.8797$",
            "$12.5 - 3.2 = 9.2$",
            "$47.812 - 46.927 = 0.8955$",
            "$237 \\cdot 195/346 = 133.55$",
        ],
    );
}

#[test]
fn a_text_may_put_a_difference_down_to_rounding() {
    let text = |digits: &str| {
        format!("$\\frac{{0.00803}}{{0.00158}} = 5.082 \\approx {digits}$, computed with values that were not rounded.")
    };
    of_inputs(&[&text("5.077")]);
    listed(Markdown, &[&text("5.707"), "$\\frac{0.00803}{0.00158} = 5.082 \\approx 5.077$, computed with values."]);
}

#[test]
fn the_unit_behind_the_last_term_may_be_that_of_the_sum() {
    unlisted(Latex, &[r"$6^\circ\;15'\;36'' = 6 + \frac{15}{60} + \frac{36}{3600} ~\text{degrees} = 6.26^\circ$"]);
    listed(Latex, &[r"$6 + \frac{15}{60} + \frac{36}{3600} ~\text{degrees} = 6.62^\circ$"]);
}

#[test]
fn a_negative_number_in_braces_is_raised_with_its_sign() {
    unlisted(Latex, &[r"$\frac{{-6}^2}{{3}^2} = 4$"]);
    listed(Latex, &[r"$\frac{{-6}^2}{{3}^2} = 5$", r"$\frac{-6^2}{3^2} = 4$"]);
}

#[test]
fn dots_that_stand_for_no_term_are_those_of_data() {
    unlisted(Markdown, &["$(9 + 6 + \\ldots + 3)/9 = 35/9 = 3.89$"]);
    listed(Markdown, &["$(3 + 6 + \\ldots + 30)/5 = 34$"]);
}

#[test]
fn a_letter_behind_a_quantity_may_name_the_next_one() {
    unlisted(Plain, &["r = 0.3m F = 2500N"]);
    listed(Plain, &["r = 0.3 m = 450 mm"]);
}

#[test]
fn a_bracket_that_closes_nothing_ends_something_else() {
    unlisted(Latex, &[r"\(a_{low}\) = 0.231; \(a_{up}\) = 0.484) = 0.95."]);
    listed(Latex, &[r"(It is 0.5 + 0.484 = 0.95.)"]);
}

#[test]
fn words_for_large_numbers_count_before_a_currency_and_in_other_languages() {
    unlisted(
        Latex,
        &[r"$P = 0.03 \times 100 = 3 \text{ million USD annually}$", r"$2.5 \cdot 4 \cdot 10^6 = 10$ Millionen."],
    );
    listed(
        Latex,
        &[r"$P = 0.03 \times 100 = 4 \text{ million USD annually}$", r"$2.5 \cdot 4 \cdot 10^6 = 11$ Millionen."],
    );
}

#[test]
fn a_share_may_be_rounded_once_more_behind_an_arrow() {
    unlisted(Plain, &["It is about 13% (.305/2.4 = 12.7 --> about 13%)"]);
    listed(Plain, &["It is about 13% (.305/2.4 = 12.7)"]);
}

#[test]
fn per_cent_may_stand_behind_the_formula_and_its_tags() {
    let text = |digits: &str| format!("<p>So <span class=\"math\">\\(R^2 = (-0.934)^2 = {digits}\\)</span>%.</p>");
    unlisted(Html, &[&text("87.2")]);
    listed(Html, &[&text("78.2")]);
}

#[test]
fn a_letter_of_the_formula_is_no_unit() {
    let text = |last: &str| {
        format!(
            r"\begin{{align*}} \frac{{2518}}{{234}} &= \frac{{T}}{{287}}\\ 287 \cdot 2518 &= 234{last} \end{{align*}}"
        )
    };
    unlisted(Latex, &[&text("T")]);
    listed(Latex, &[&text("")]);
    listed(Latex, &[r"$V_{out} = \frac{4 \cdot 1.5}{8} = 0.85V$"]);
}

#[test]
fn a_cross_denies_a_row() {
    let text = |mark: &str| {
        format!(
            r"\begin{{align*}} \frac{{13}}{{9}} &= \frac{{15}}{{8}}\\ 1.44 &= 1.88 \quad\text{{{mark}}} \end{{align*}}"
        )
    };
    unlisted(Latex, &[&text(r"\ding{55}"), &text("✗")]);
    assert_eq!(
        report(&text(r"\ding{51}"), Latex).findings.iter().filter(|of| of.section == ReportSection::Numbers).count(),
        2
    );
}

#[test]
fn an_equals_sign_may_lead_to_a_logarithm() {
    unlisted(Latex, &[r"$0.21 = \ln(0.21) = -1.56$"]);
    listed(Latex, &[r"$0.21 = \ln(0.31) = -1.17$", r"$\tan\alpha = \frac{4}{9} = 24.0^\circ$"]);
}

#[test]
fn a_reader_chooses_among_several_values() {
    let item = |value: &str| format!("- $\\ln(1.2) \\approx {value}$\n");
    unlisted(Markdown, &[&["1.2", "2.2", "0.2"].map(item).concat()]);
    listed(Markdown, &[&item("2.2")]);
}

#[test]
fn a_tangent_gives_a_value_of_its_own() {
    let text = |how: &str, value: &str| format!("By {how}, $\\sqrt{{4.5}} \\approx {value}$.");
    unlisted(Markdown, &[&text("linear approximation", "2.125")]);
    listed(Markdown, &[&text("a calculator", "2.125"), &text("linear approximation", "2.725")]);
}

#[test]
fn a_unit_without_a_number_names_a_quantity() {
    unlisted(Latex, &[r"$V = \text{mol} \times 22.4 \text{ L/mol} = (3.52)(22.4) = 78.8 \text{ L}$"]);
    listed(Latex, &[r"$V = 3.52 \text{ mol} \times 22.4 \text{ L/mol} = 87.8 \text{ L}$"]);
}

#[test]
fn blanks_may_stand_around_the_sign_of_a_power_of_ten() {
    unlisted(Markdown, &["where 1 amu = 1.66054 * 10 ^ -24g."]);
    listed(Markdown, &["where 1 amu = 1.66054 * 10 ^ -27g."]);
}

#[test]
fn the_size_of_an_effect_has_no_sign() {
    unlisted(
        Markdown,
        &[
            "Effect size: $d = \\frac{-3.000}{3.117} = 0.962$",
            "The scores differ by $10(-1.26) = 12.6$ points.",
            "Elasticity.\n\n$\\frac{25\\%}{-16.67\\%} \\approx 1.5$",
        ],
    );
    listed(Markdown, &["Effect size: $d = \\frac{-3.000}{3.117} = 0.926$", "It is $10(-1.26) = 12.6$."]);
}

#[test]
fn a_mean_may_run_on_behind_its_sum() {
    unlisted(Markdown, &["Its mean is 1+2+3+4 = 10 / 4 = 2.5."]);
    listed(Markdown, &["Its mean is 1+2+3+4 = 10 / 4 = 2.6."]);
}

#[test]
fn a_product_may_begin_before_its_sign() {
    let cell = |rest: &str| {
        format!(
            "{{\"cells\": [{{\"cell_type\": \"markdown\", \"metadata\": {{}}, \"source\": [\"s = 1/20 {rest} (87.5 - 62.1) = 25.4/20 = 1.27\"]}}], \"metadata\": {{}}, \"nbformat\": 4, \"nbformat_minor\": 5}}"
        )
    };
    unlisted(Notebook, &[&cell("$*$")]);
    listed(Notebook, &[&cell("+")]);
    unlisted(Latex, &[r"$\displaystyle + \frac{3 \times 3220}{4} = 4279$"]);
    listed(Latex, &[r"$\displaystyle \frac{3 \times 3220}{4} = 4279$"]);
}

#[test]
fn a_list_in_brackets_has_no_decimals() {
    let text = |open: &str, close: &str| {
        format!("Es ist $0,5$ und $1,25$. ${open}8,1+\\frac12{close} = {open}9,1+\\frac12{close}$")
    };
    unlisted(Markdown, &[&text("[", "]")]);
    listed(Markdown, &[&text("(", ")")]);
}

#[test]
fn the_torr_is_a_share_of_the_atmosphere() {
    let units = |text: &str, format: TextFormat| {
        report(text, format).findings.iter().filter(|of| of.section != ReportSection::Agreeing).count()
    };
    assert_eq!(units(r"$760\,\text{Torr} = 1\,\text{atm}$", Markdown), 0);
    assert_eq!(units(r"$750\,\text{Torr} = 1.000\,\text{atm}$", Markdown), 1);
}
