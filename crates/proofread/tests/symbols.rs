//! Signs that mean something else than their usual arithmetic: each kind in a chain of ours that must not be listed, beside one that must.

use crate::report;
use proofread::{ReportSection, TextFormat};

/// Whether anything is on the list of numbers.
fn is_listed(text: &str) -> bool {
    report(text, TextFormat::Markdown).findings.iter().any(|of| of.section == ReportSection::Numbers)
}

#[track_caller]
fn told_apart(quiet: &[&str], loud: &[&str]) {
    for text in quiet {
        assert!(!is_listed(text), "{text}");
    }
    for text in loud {
        assert!(is_listed(text), "{text}");
    }
}

#[test]
fn a_quotient_by_zero_may_be_shown_to_have_no_value() {
    told_apart(
        &[
            r"$m = \frac{7-3}{5-5} = \frac{4}{0}$",
            r"$\frac{8-2}{3-3} = 6$ would be a slope, but it is undefined",
            r"$\sqrt{9-25} = 4$ is not real",
        ],
        &[r"$m = \frac{7-3}{5-5} = 4$", r"$\frac{6}{0} = 0$", r"$\sqrt{9-25} = 4$"],
    );
}

#[test]
fn pi_may_be_a_name() {
    told_apart(
        &[r"$\pi(2) = 3\pi(1)$", r"$\pi(50) = 15$", r"$\pi(1) = 0.25$"],
        &[r"The area is $\pi(4)^2 = 52.27$", r"The girth is $\pi(4) = 12.87$", r"$2\pi(5) = 34.1$"],
    );
}

#[test]
fn an_angle_in_brackets_behind_a_number_belongs_to_the_function() {
    told_apart(&[r"$\cos 2(\frac{2\pi}{3}) = -0.500$"], &[r"$\cos 2(\frac{2\pi}{3}) = -0.600$"]);
}

#[test]
fn a_pair_is_no_number_with_a_decimal_comma() {
    told_apart(&[r"$(3-5,3+5) = (-2,8)$"], &[r"Es ist $1{,}5 + 2 = 3{,}6$."]);
}

#[test]
fn a_name_may_have_a_digit_in_it() {
    told_apart(&[r"$\text{R2 Value} = 3 \times 0.3 = 0.9$"], &[r"$\text{R2 Value} = 3 \times 0.3 = 0.7$"]);
}

#[test]
fn words_before_a_price_may_count_it() {
    told_apart(
        &[r"13 stamps at $\$0.75 = \$9.75$", r"Two fifths of $2.5$ million $= 1.0$ million"],
        &[r"13 stamps at $\$0.75 = \$9.95$"],
    );
}

#[test]
fn a_factorial_sign_may_stand_behind_the_formula() {
    told_apart(
        &[r"There are $4\cdot3\cdot2\cdot1=4$! orders."],
        &[r"There are $4\cdot3\cdot2\cdot1=3$! orders.", "Wrong: $2+2=5$!"],
    );
}

#[test]
fn a_price_may_stand_below_a_price() {
    told_apart(&[r"$\frac{1}{\$8/\$20} = 2.5$"], &[r"$\frac{1}{\$8/\$20} = 3.5$"]);
}

#[test]
fn fractions_in_brackets_may_be_residue_symbols() {
    told_apart(
        &[r"$\left(\frac{3}{11}\right) = 1$", r"$\left(\frac{7}{19}\right) = -\left(\frac{19}{7}\right)$"],
        &[r"$\left(\frac{3}{11}\right) = 0.37$", r"$\left(\frac{1}{2}\right)\left(\frac{1}{3}\right) = \frac{1}{5}$"],
    );
}

#[test]
fn two_equations_may_stand_on_a_line() {
    told_apart(&[r"$4\cdot6 = 24 \ \ -4(6) = -24$"], &[r"$31\cdot4 = 124 = -31(4)$"]);
}

#[test]
fn a_chain_may_be_false_on_purpose() {
    told_apart(
        &[
            r"**Common mistake.** Many compute $(1+2)^3 = 1^3+2^3 = 9$.",
            r"Wrong on purpose: $\frac14+\frac14=\frac28$.",
            r"A student wrote $\sqrt{9+16}=3+4$.",
        ],
        &[
            r"**Common mistake.** Many compute $(1+2)^3 = 1^3+2^3$. In fact $(1+2)^3=28$.",
            r"The student council has $4+4=9$ members.",
        ],
    );
}

#[test]
fn a_large_number_may_be_understood() {
    told_apart(
        &[r"Sales $= 0.7 \times 300 = 210 \text{ million}$"],
        &[r"Sales $= 0.7 \times 300 = 270 \text{ million}$"],
    );
}
