//! In which forms a number is printed, and which signs beside it belong to it: right chains that must not be listed, beside wrong ones that
//! must.

use crate::unusual::{listed, unlisted};
use crate::{assert_told_apart, on_numbers, report};
use proofread::{ReportSection, TextFormat};

#[test]
fn thousandths_make_mixed_numbers() {
    unlisted(TextFormat::Latex, &[r"$3.472 = 3\frac{472}{1000} = \frac{434}{125}$", r"$12.347 = 12\frac{347}{1000}$"]);
    listed(TextFormat::Latex, &[r"$3.472 = 3\frac{474}{1000}$", r"$1416 = 5\frac{472}{1000}$"]);
}

#[test]
fn a_power_is_no_label() {
    listed(
        TextFormat::Latex,
        &[r"So $10^{\log 1000} = 10^3 = 3$ as expected.", r"\[ 3.9 \times 10^6 = 3200000 \]", r"\[10000=10^9\]"],
    );
    unlisted(
        TextFormat::Latex,
        &[r"So $10^{\log 1000} = 10^3 = 1000$ as expected.", r"\[ 3.9 \times 10^6 = 3900000 \]"],
    );
}

#[test]
fn a_bracket_with_a_subscript_ends() {
    listed(TextFormat::Latex, &[r"\[ [\mathcal T]_{\mathcal B} = 3\cdot 4 = 13 \]"]);
    unlisted(TextFormat::Latex, &[r"\[ [\mathcal T]_{\mathcal B} = 3\cdot 4 = 12 \]"]);
}

#[test]
fn braces_may_hold_a_fractional_part() {
    unlisted(
        TextFormat::Latex,
        &[
            r"$|\{9\pi\} - \{2\pi\}| = |9\pi - 28 - (2\pi - 6)|$",
            r"$\{783\log_3(2)\} - \{298\log_3(2)\} \approx 0.00093$",
        ],
    );
    listed(TextFormat::Latex, &[r"$|\{9\pi\} - \{2\pi\}| = |9\pi - 27 - (2\pi - 6)|$"]);
}

#[test]
fn full_stops_between_functions_are_signs_of_a_product() {
    let product = r"$\tan 10^\circ.\tan 45^\circ.\tan 80^\circ = 1$";
    unlisted(
        TextFormat::Latex,
        &[
            product,
            r"$\sin 30^\circ.\cos 60^\circ = \frac14$",
            r"${\rm cosec}^245^\circ.\sec^230^\circ.\cos 60^\circ = 1\frac{1}{3}$",
        ],
    );
    listed(TextFormat::Latex, &[&product.replace("= 1", "= 3"), r"$\sin 30^\circ.\cos 60^\circ = \frac13$"]);
}

#[test]
fn half_a_power_may_be_typed_with_a_stroke() {
    let speed = "v = (2*30 J / 2 kg)^1/2 = 5.48 m/s";
    unlisted(TextFormat::Markdown, &[speed]);
    listed(TextFormat::Markdown, &[&speed.replace("5.48", "5.58"), "(9 + 7)^1/2 = 9"]);
}

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
fn words_of_a_formula_are_no_number() {
    // In a page with single dollar signs, such a formula is read as a line.
    let line = |words: &str| format!("<p>{words} 2004 = 300 + 20 = 320<br></p>");
    assert_told_apart(&line(r"Sales\:\:in\:\:"), &line("").replace("2004", "200 + 4"), TextFormat::Html);
    let share = |words: &str| format!(r"<p>3\%\:\:{words}\:\:500 = 0.03 * 500 = 15<br></p>");
    assert_eq!(on_numbers(&share("of"), TextFormat::Html), 0);
}

#[test]
fn a_number_element_may_have_letters() {
    let formula = |first: &str| format!("<math><mn>{first}</mn><mo>+</mo><mn>1</mn><mo>=</mo><mn>7</mn></math>");
    assert_told_apart(&formula("2y"), &formula("2"), TextFormat::Xml);
    assert_told_apart(&formula("2ax"), &formula("2"), TextFormat::Xml);
}

#[test]
fn a_stroke_with_space_around_it_is_the_outer_one() {
    assert_told_apart("x = -50/7 / -2/7 = 25", "x = -50/7 / -2/7 = 24", TextFormat::Markdown);
}
