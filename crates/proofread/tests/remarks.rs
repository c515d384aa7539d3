//! What stands beside a chain and is no part of it: arguments of commands, reasons, lists, and digits or terms that are left out.

use crate::{report, verdicts, wrong};
use proofread::TextFormat;

#[test]
fn an_equals_sign_in_an_argument_is_part_of_the_argument() {
    for tex in [
        r"\pr{X = 1} = 0.45",
        r"\pr{X=1,Y=2} = \frac{4}{7}",
        r"p = \pr{X=3} \\ = \frac{49}{100}",
        r"\myvec{a&b&c}\myvec{3\\2\\-6} = 0",
        r"E\foo{\left.Y\right| X=2} = 6",
    ] {
        assert_eq!(verdicts(tex), [""; 0], "{tex}");
    }
    // A command around all of a formula only dresses it up.
    assert_eq!(verdicts(r"\answer{x = 2 + 3 = 6.5}"), ["inconsistent"]);
}

#[test]
fn a_remark_at_the_end_of_a_row_is_not_the_side_of_the_next_row() {
    for tex in [
        r"P &= p_1 + p_2 \qquad \because q = 0 \\ &= 0.31 + 0.20",
        r"p(k) &= f(k)\ \forall\ 1 \leq k \leq 10 \\ &= \frac{4}{40}",
        r"\mu &= E[X_i], \ i = 0, 1 \\ &= \frac{1}{2}",
    ] {
        assert_eq!(verdicts(tex), [""; 0], "{tex}");
    }
    // The chain before the remark goes on.
    assert_eq!(verdicts(r"2 + 3 &= 5 \quad \because q = 0 \\ 4 + 4 &= 9"), ["consistent", "inconsistent"]);
    assert_eq!(verdicts(r"2 + 3\ \because q = 0 \\ &= 8"), ["inconsistent"]);
    assert_eq!(verdicts(r"x = 3, \; 2 + 2 \\ = 7"), ["inconsistent"]);
    // The sign of for all may be a volume.
    assert_eq!(wrong("-   Q = ∀/t = 1.15/33.0 = 0.0355", TextFormat::Markdown).len(), 1);
}

#[test]
fn dots_stand_for_terms_or_for_digits() {
    assert_eq!(verdicts(r"0.5 + 0.5 + 0.375 + ... + 0.0078 = 1.98"), [""; 0]);
    assert_eq!(verdicts(r"1360 \times \frac{1}{9.3^2} = 15.72... \approx 16"), ["consistent", "consistent"]);
}

#[test]
fn a_result_may_be_repeated_in_another_unit() {
    let sum = r"$0.50\,\text{m} + 0.05\,\text{m} = 0.55\,\text{m}\ (55\,\text{cm})$";
    assert_eq!(wrong(sum, TextFormat::Markdown), [""; 0]);
    assert_eq!(wrong(&sum.replace("0.55", "0.65"), TextFormat::Markdown).len(), 1);
}

#[test]
fn a_factor_may_stand_outside_of_the_formula() {
    assert_eq!(wrong(r"2$(3.0) + 1.0 = 7.0$", TextFormat::Markdown), [""; 0]);
    assert_eq!(wrong(r"2 $(3.0) + 1.0 = 7.0$", TextFormat::Markdown).len(), 1);
}

#[test]
fn a_display_goes_on_from_a_display() {
    let text = "\\begin{align} = 1 + x \\end{align}\nFrom $ x = 0 $\n\\begin{align} = 1 + 0 \\end{align}";
    assert_eq!(wrong(text, TextFormat::Latex), [""; 0]);
    assert_eq!(report("$$2 + 2$$\n$$= 5$$", TextFormat::Latex).tally.checked, 1);
}

#[test]
fn small_marks_have_their_meaning() {
    for (tex, expected) in [
        (r"\qty{70}{\micro m} = \qty{7.0e-5}{m}", "consistent"),
        (r"\qty{70}{\micro m} = \qty{7.0e-4}{m}", "inconsistent"),
        (r"\qty{8.8e26}{m} = 10^{26.9}\,\unit{m}", "consistent"),
        (r"\qty{2.8e26}{m} = 10^{26.9}\,\unit{m}", "inconsistent"),
        (r"\mathrm{e}^{-23} = 1.03\times10^{-10}", "consistent"),
        (r"\mathrm{e}^{-23} = 1.13\times10^{-10}", "inconsistent"),
    ] {
        assert_eq!(verdicts(tex), [expected], "{tex}");
    }
    // A point close between letters is a product.
    assert_eq!(verdicts("p.d+a.(-1)=0"), [""; 0]);
}
