//! Differences that digits printed elsewhere explain, and what can't be explained by rounding.

use crate::{report, verdicts, wrong};
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
