//! Differences that digits printed elsewhere explain, and what can't be explained by rounding.

use crate::unusual::{listed, unlisted};
use crate::{assert_told_apart, on_numbers, report, verdicts, wrong};
use proofread::TextFormat;

#[track_caller]
fn all(cases: &[(&str, &[&str])]) {
    for (tex, expected) in cases {
        assert_eq!(verdicts(tex), *expected, "{tex}");
    }
}

#[test]
fn a_result_goes_on_with_the_digits_that_it_had() {
    let work = r"$(4900\,\text{N})0.33\,\text{m/s} = 1633.33\,\text{W}$";
    let speed = r"$v = \frac{10.00\,\text{m}}{30.00\,\text{s}} = 0.33\,\text{m/s}$";
    assert_eq!(wrong(work, TextFormat::Markdown).len(), 1);
    assert_eq!(wrong(&format!("{speed}, and {work}"), TextFormat::Markdown), [""; 0]);
    // It had these digits before, not behind, and no others.
    assert_eq!(wrong(&format!("{work}, and {speed}"), TextFormat::Markdown).len(), 1);
    assert_eq!(wrong(&format!("{speed}, and {work}").replace("1633.33", "1633.43"), TextFormat::Markdown).len(), 1);
    // A power of ten belongs to the number.
    let other = speed.replace("0.33", r"0.33\times10^0");
    assert_eq!(wrong(&format!("{other}, and {work}"), TextFormat::Markdown).len(), 1);
}

#[test]
fn a_number_may_have_been_printed_with_more_digits() {
    let ratio = r"$880/10.3 = 85.9$";
    let momentum = r"$(0.410\,\text{kg})(25\,\text{m/s}) = 10.25\,\text{kg m/s}$";
    assert_eq!(wrong(ratio, TextFormat::Markdown).len(), 1);
    assert_eq!(wrong(&format!("{momentum}, and {ratio}"), TextFormat::Markdown), [""; 0]);
    // To these digits it has to round, and all digits of the result have to follow.
    for other in [
        momentum.replace("10.25", "10.15").replace("0.410", "0.406"),
        momentum.replace("10.25", "10.250000") + " or $5$",
    ] {
        let found = wrong(&format!("{other}, and {}", ratio.replace("85.9", "86.0")), TextFormat::Markdown);
        assert_eq!(found.len(), 1, "{other}");
    }
}

#[test]
fn what_was_printed_may_go_in_as_it_was_printed() {
    let side = r"$\frac12\sqrt{20^2+12^2}=11.662$";
    let angle = r"$\cos^{-1}\left(\frac{20-17/2}{11.66}\right)=9.5612^\circ$";
    assert_eq!(wrong(angle, TextFormat::Markdown).len(), 1);
    assert_eq!(wrong(&format!("{side} and {angle}"), TextFormat::Markdown), [""; 0]);
    assert_eq!(wrong(&format!("{side} and {}", angle.replace("5612", "5622")), TextFormat::Markdown).len(), 1);
}

#[test]
fn a_conversion_before_gives_the_digits_that_went_on() {
    let size = r"$\frac{850\,\mathrm{km}}{0.133\,\mathrm{rad}} = 6.41\times10^6\,\mathrm{m}$";
    assert_eq!(wrong(size, TextFormat::Markdown).len(), 1);
    let angle = r"$\alpha = 7.6^\circ = 0.133\,\mathrm{rad}$";
    assert_eq!(wrong(&format!("{angle}, so {size}"), TextFormat::Markdown), [""; 0]);
    assert_eq!(wrong(&format!("{angle}, so {}", size.replace("6.41", "6.45")), TextFormat::Markdown).len(), 1);
}

#[test]
fn a_result_may_come_from_the_first_numbers_of_an_example() {
    let steps = r"$2300/14.7 = 160$, so $(2.0\times10^{-5})(160) = 0.0032$, and $0.0032(250) = 0.78$";
    assert_eq!(wrong(steps, TextFormat::Markdown), [""; 0]);
    assert_eq!(wrong(&steps.replace("14.7", "14.3"), TextFormat::Markdown), ["0.0032(250) | 0.78"]);
}

#[test]
fn a_wrong_result_does_not_go_on() {
    let both = r"$\frac{1}{2}(750 + 0)(2.8) = 1065$, and $\frac{1065}{2\pi} = 167$";
    assert_eq!(wrong(both, TextFormat::Markdown).len(), 2);
}

#[test]
fn constants_of_nature_may_go_in_with_all_their_digits() {
    let energy = r"\frac{\pi^2(1.05\times10^{-34}\,\text{J s})^2}{2(1.67\times10^{-27}\,\text{kg})(1.00\times10^{-14}\,\text{m})^2} = ";
    all(&[
        (&format!(r"{energy}3.26\times10^{{-13}}\,\text{{J}}"), &["consistent"]),
        (&format!(r"{energy}3.28\times10^{{-13}}\,\text{{J}}"), &["rounded"]),
        (&format!(r"{energy}3.31\times10^{{-13}}\,\text{{J}}"), &["inconsistent"]),
        // The same digits with another power of ten are no constant.
        (
            r"\frac{\pi^2(1.05\times10^{-4}\,\text{m})^2}{2(1.67\times10^{-7})(1.00\times10^{-14})^2} = 3.28\times10^{27}\,\text{m}^2",
            &["inconsistent"],
        ),
    ]);
}

#[test]
fn pi_may_go_in_with_two_decimals() {
    all(&[
        (r"2\pi(60) = 376.80", &["rounded"]),
        (r"2\pi(60) = 376.99", &["consistent"]),
        (r"2\pi(60) = 376.90", &["inconsistent"]),
    ]);
}

#[test]
fn a_number_that_both_sides_print_is_one_value() {
    all(&[
        (r"(2.50)(4.17)(3.0) = (2.50)(12.5)", &["rounded"]),
        (r"(2.50)(4.17)(3.0) = (2.50)(12.6)", &["inconsistent"]),
        (r"25(1)^2 + 40(2)^2 = 25 + 160", &["consistent"]),
        (r"\left(\frac{\sin(4.77)}{4.77}\right)^2 = \left(\frac{-0.9983}{4.77}\right)^2", &["rounded"]),
        (r"\left(\frac{\sin(4.77)}{4.77}\right)^2 = \left(\frac{-0.9985}{4.77}\right)^2", &["inconsistent"]),
    ]);
}

#[test]
fn a_conversion_has_no_steps_on_which_to_round() {
    all(&[
        (r"195\,880\,\text{Pa} = 195.88\,\text{kPa}", &["consistent"]),
        (r"195\,880\,\text{Pa} = 195.89\,\text{kPa}", &["last-digit"]),
        // A quantity that is converted isn't rounded to tens before.
        (r"50\,\text{km/h} = 13.9\,\text{m/s}", &["consistent"]),
        (r"50\,\text{km/h} = 15.2\,\text{m/s}", &["inconsistent"]),
        (r"30\,\text{kW} = 41.5\,\text{hp}", &["inconsistent"]),
        (r"1290\,\text{g} = 1.29\,\text{kg}", &["consistent"]),
        (r"1290\,\text{g} = 1.28\,\text{kg}", &["last-digit"]),
        (r"96\,\text{km/h} = 26.67\,\text{m/s}", &["consistent"]),
        // The size of a horsepower is rounded.
        (r"1\,\text{hp} = 735\,\text{W}", &["rounded"]),
    ]);
}

#[test]
fn what_has_no_real_value_equals_nothing() {
    for tex in [
        r"\sqrt{1 - (5/2)^2} = 1.4",
        r"48.0/0.000 = 120",
        r"\sin^{-1} 1.5 = 49^\circ",
        r"\ln(-2.0) = 0.69",
        r"(2.0 - 3.5)^{1/2} = 1.2",
    ] {
        let findings = report(&format!("$${tex}$$"), TextFormat::Markdown).findings;
        assert_eq!(findings.len(), 1, "{tex}");
        assert_eq!(findings[0].verdict.name(), "inconsistent", "{tex}");
        assert!(findings[0].why.is_some(), "{tex}");
    }
    // Of ± one sign may have a value, what rounding lets be zero has one, and a letter may be anything.
    for tex in [r"\sqrt{2 \pm 3} = 2.24", r"\sqrt{1.00 - 1.00} = 0", r"\sqrt{-4} = 2i", r"\frac{5}{0} = \infty"] {
        assert!(verdicts(tex).iter().all(|verdict| *verdict != "inconsistent"), "{tex}: {:?}", verdicts(tex));
    }
}

#[test]
fn logarithms_have_any_base() {
    all(&[
        (r"\log_2 8 = 3", &["consistent"]),
        (r"\log_2 8 = 5", &["inconsistent"]),
        (r"3\log_{16} 4.0 = 1.5", &["consistent"]),
    ]);
}

#[test]
fn a_count_of_electrons_leaves_the_sign_of_their_charge_out() {
    all(&[
        (r"(3.75\times10^{21}\,\text{e})(1.602\times10^{-19}\,\text{C/e}) = -601\,\text{C}", &["doubtful"]),
        (r"\frac{3.750\times10^{21}\,\text{e}}{6.242\times10^{18}\,\text{e/C}} = -600.8\,\text{C}", &["doubtful"]),
        (r"\frac{3.750\times10^{21}}{6.242\times10^{18}}\,\text{C} = -600.8\,\text{C}", &["inconsistent"]),
    ]);
}

#[test]
fn pi_may_be_taken_as_a_fraction_or_as_few_decimals() {
    unlisted(
        TextFormat::Latex,
        &[
            r"The volume is $\frac{4}{3}\pi \times 64 = 268.19$.",
            r"The volume is $\frac{4}{3}\pi \times 64 = 267.95$.",
            r"$\pi \times 7^2 = 154\,\mathrm{cm}$",
        ],
    );
    listed(TextFormat::Latex, &[r"The volume is $\frac{4}{3}\pi \times 64 = 268.91$.", r"$\pi \times 7^2 = 156$"]);
}

#[test]
fn dots_behind_decimals_leave_the_next_digit_open() {
    unlisted(
        TextFormat::Latex,
        &[
            r"$1/17 \approx 0.0588\dots$",
            r"$\frac{5}{7}\approx 0.7143\dots$",
            r"$7\text{ cm}-(2.3411\dots\text{ cm})\approx 4.6588\dots\text{ cm}$",
            r"$2.282\times(0.55\dots)\approx 1.25\dots$",
            r"$1/3 = 0.333\dots$",
            r"$2/3 = 0.66\dots$",
        ],
    );
    listed(TextFormat::Latex, &[r"$1/17 \approx 0.0598\dots$", r"$1/3 = 0.353\dots$", r"$2/3 = 0.77\dots$"]);
}

#[test]
fn estimates_have_more_digits_than_are_printed() {
    unlisted(
        TextFormat::Markdown,
        &[
            "The odds ratio is $e^{-0.41} = 0.661$.",
            r"$Z = \frac{-0.0241}{0.0063} = -3.81$",
            r"$F = \frac{4.21\times10^{10}}{5.33\times10^8} = 78.91$",
        ],
    );
    listed(
        TextFormat::Markdown,
        &["The odds ratio is $e^{-0.41} = 0.681$.", r"$Z = \frac{-0.0241}{0.0063} = -3.61$", "$e^{-0.41} = 0.661$"],
    );
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
