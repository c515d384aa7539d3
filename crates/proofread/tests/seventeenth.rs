//! Kinds of misreading that a seventeenth set of texts showed: each with a right formula, of which nothing is said, and a wrong one beside
//! it that still is listed.

use crate::{assert_told_apart, on_numbers, report};
use proofread::{ReportSection, TextFormat};

#[test]
fn a_colon_divides_in_the_middle_of_a_chain() {
    let chain = |last: &str| {
        format!(
            r"$$\begin{{align*}} (\frac{{5}}{{8}}-\frac{{1}}{{8}}) : \frac{{1}}{{3}} &= \frac{{1}}{{2}} : \frac{{1}}{{3}} \\ &= \frac{{1}}{{2}}\cdot\frac{{3}}{{1}} = {last}\end{{align*}}$$"
        )
    };
    assert_told_apart(&chain(r"\frac{3}{2}"), &chain(r"\frac{5}{2}"), TextFormat::Markdown);
}

#[test]
fn solutions_side_by_side_are_read_down() {
    let rows = |last: &str| {
        let starts = r"<mrow>\amp 6 + 8 \div 2 \times 2 \amp \amp 6 + 8 + 2 \times 2</mrow>";
        let steps = r"<mrow>\amp = 6 + 4 \times 2 \amp \amp = 6 + 8 + 4</mrow>";
        format!(r"<p><md>{starts}{steps}<mrow>\amp = 14 \amp \amp = {last}</mrow></md></p>")
    };
    assert_told_apart(&rows("18"), &rows("17"), TextFormat::Xml);
}

#[test]
fn spaces_part_equations_of_a_row() {
    let row = |third: &str| {
        format!(
            r"$\binom{{4}}{{0}} = 1 \;\; \binom{{4}}{{1}} = 4 \;\; \binom{{4}}{{2}} = {third} \;\; \binom{{4}}{{3}} = 4$"
        )
    };
    assert_told_apart(&row("6"), &row("7"), TextFormat::Latex);
}

#[test]
fn a_sentence_may_name_the_base_of_its_numbers() {
    let thirds = r"\[ \frac13 = 0.1 = 0.0\overline{2} \]";
    let with = |words: &str| format!("Numbers are written {words}: {thirds}");
    assert_told_apart(&with("with respect to basis $3$"), &with("as usual"), TextFormat::Latex);
    assert_ne!(on_numbers(&with("in a basis of the space"), TextFormat::Latex), 0);
}

#[test]
fn a_comma_before_three_digits_may_part_decimals() {
    for [right, wrong] in [
        ["Der Quarz schwingt mit 500 MHz / 9 = 55,556 MHz.", "Der Quarz schwingt mit 500 MHz / 9 = 54,556 MHz."],
        [r"$\sqrt{62} \approx 7,874$", r"$\sqrt{62} \approx 7,884$"],
        [
            r"$\qty{150}{\mega\hertz} + \qty{1,350}{\giga\hertz} = \qty{1,5}{\giga\hertz}$",
            r"$\qty{150}{\mega\hertz} + \qty{1,350}{\giga\hertz} = \qty{1,6}{\giga\hertz}$",
        ],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    // In siunitx it does in any case, so that the sum is checked.
    let sum = r"$\qty{150}{\mega\hertz} + \qty{1,350}{\giga\hertz} = \qty{1,5}{\giga\hertz}$";
    assert_eq!(report(sum, TextFormat::Markdown).findings[0].section, ReportSection::Agreeing);
}

#[test]
fn a_word_for_and_parts_equations() {
    for and in ["und", "et", "och", "и"] {
        let pair = |first: &str| format!(r"$2+2={first} \text{{ {and} }} v=3$");
        assert_told_apart(&pair("4"), &pair("5"), TextFormat::Latex);
    }
}

#[test]
fn a_time_may_begin_in_the_formula_before() {
    let time = |and: &str| format!(r"$2\,min$ {and} $15\,sec=135\,s$");
    for and in ["and", "et", "und"] {
        assert_told_apart(&time(and), r"It is $15\,sec=135\,s$", TextFormat::Markdown);
    }
}

#[test]
fn a_share_is_taken_of_a_whole_in_several_languages() {
    for of in ["von", "van", "de", "of"] {
        let share = |amount: &str| format!("Hier 5 % {of} 20 km = {amount} km.");
        assert_told_apart(&share("1"), &share("2"), TextFormat::Markdown);
        assert_eq!(report(&share("1"), TextFormat::Markdown).findings[0].section, ReportSection::Agreeing);
    }
}

#[test]
fn signs_of_a_country_or_a_field_have_their_meaning() {
    for [right, wrong] in [
        [r"$6\mathrm{~t} = 360\mathrm{~min}$", r"$6\mathrm{~t} = 350\mathrm{~min}$"],
        [r"$k \le 3^{\lg 7} \approx 21.85$", r"$k \le 3^{\lg 7} \approx 22.85$"],
        ["Round 2 (2014/15) = 3120; it was small.", "It is 2 (30/15) = 6; it was small."],
        ["x1 =  70   x2=0", "area =  70   x2=0"],
        [r"$7\cancel \equiv 2 \mod 6$", r"$7 \equiv 2 \mod 6$"],
        [r"$\frac{\pi(2)-\pi(1)}{2-1} = \frac{2-3}{2-1}$", r"$\frac{\pi 2-\pi}{2-1} = \frac{2-3}{2-1}$"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn a_sign_of_per_cent_may_be_lost() {
    let share = |words: &str, result: &str| format!("The return{words} is $.6(.10) + .4(.05) = .06 + .02 = {result}$.");
    assert_told_apart(&share(" in percent", "8.0"), &share("", "8.0"), TextFormat::Markdown);
    assert_ne!(on_numbers(&share(" in percent", "9.0"), TextFormat::Markdown), 0);
    let end = |result: &str| format!("About $1 - (1 - 0.1)^2 = {result}%$ of them.");
    assert_told_apart(&end("19.0"), &end("25.0"), TextFormat::Markdown);
}

#[test]
fn limits_with_pi_are_no_degrees() {
    let found = report(r"$$\left[x+\sin x\right]_0^{2\pi} = 6.5$$", TextFormat::Markdown).findings;
    assert_eq!(found[0].recomputed.as_deref(), Some("6.3"));
}

#[test]
fn code_in_an_environment_of_its_own_is_not_read() {
    let code = |name: &str| format!("\\begin{{{name}}}\n2 + 2 = 5\n\\end{{{name}}}\n");
    assert_told_apart(&code("pythoncode"), &code("remark"), TextFormat::Latex);
}

#[test]
fn a_sign_beside_a_number_may_belong_to_something_else() {
    for [right, wrong] in [
        // An event in braces.
        [r"$1 - P{ Y \ge 1} = 1 - .3$", r"$P{ Y \ge 1} = 1 - .3 = .8$"],
        // A low point for times.
        ["$2.3-1^2=5$", "$2.3-1^2=6$"],
        // A copied page.
        ["* A: 3×4+1=133×4+1=13", "* A: 3×4+1=133×4+2=13"],
        // A unit that is not known.
        ["R = 80 km / (2 × 10^8 m/s) = 4 × 10^7bps", "R = 80 km / (2 × 10^8 m/s) = 4 × 10^7 s"],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    let pair = |sum: &str| {
        format!(r"<p><m>2,5+1,5=4</m>, <m>2,75-1,25={sum}</m> and <m>\vec v+\vec v = (2+2,1+1) = (2,4)</m></p>")
    };
    assert_told_apart(&pair("1,5"), &pair("1,6"), TextFormat::Xml);
}

#[test]
fn no_hint_is_given_where_a_side_was_copied_or_a_whole_sum_differs() {
    let hint = |text: &str| report(text, TextFormat::Markdown).findings[0].hint.is_some();
    assert!(!hint("$200 + 50 = 200$"));
    assert!(!hint(r"$\sqrt{8^2 + 6^2 + 2^2} = 11.00$"));
    assert!(hint(r"$\sqrt{8^2 + 6^2 + 2^2} = 10.189$"));
}
