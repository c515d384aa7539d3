//! Where one formula ends and the next one begins: formulas that are cut in two, numbers that continue in the text beside them,
//! and commas that separate no equations.

use crate::{report, verdicts, wrong};
use proofread::TextFormat;

#[test]
fn a_sum_may_go_on_in_the_next_display() {
    let sum =
        "$$S = 20.0 \\ln\\left(\\frac{3.0}{2.0}\\right) + 4.0$$\n\n\\vspace*{-0.3cm}\n\n$$+ 10.0 \\ln 2.0 = 19.0$$";
    for format in [TextFormat::Latex, TextFormat::Markdown] {
        assert_eq!(wrong(sum, format), [""; 0]);
        assert_eq!(report(sum, format).tally.checked, 1);
    }
    // What is put together is checked as a whole.
    assert_eq!(wrong(&sum.replace("19.0", "15.0"), TextFormat::Latex).len(), 1);
    let product = r"It is $2.0 \times$ $3.0 = 6.0$ and $2.0$ $\times 3.0 = 6.0$, or $x = 2 + 2$ $= 4$.";
    assert_eq!(wrong(product, TextFormat::Latex), [""; 0]);
    assert_eq!(report(product, TextFormat::Latex).tally.checked, 3);
}

#[test]
fn a_difference_may_go_on_or_begin_with_its_sign() {
    assert_eq!(wrong("$$y = 10.0 - 2.0$$\n$$- 3.0 = 5.0$$", TextFormat::Latex), [""; 0]);
    assert_eq!(wrong("$$y = 10.0 - 2.0$$\n$$- 3.0 = 5.0 = 4.0$$", TextFormat::Latex), ["5.0 | 4.0"]);
    // With words between them, they are two.
    assert_eq!(wrong("$$y = 10.0 - 2.0$$ But $$- 3.0 = 5.0$$", TextFormat::Latex).len(), 1);
    assert_eq!(wrong("$$y = 10.0$$ \\textbf{But} $$+ 3.0 = 5.0$$", TextFormat::Latex).len(), 1);
}

#[test]
fn a_number_in_a_line_may_go_on_in_a_formula() {
    for text in ["It is 0.52 = 5.2 $\\times10^{-1}$ m.", "about 153,000 = 1.53 $\\times 10^{5}$", "$2 \\cdot$ 4 = 8"] {
        assert_eq!(wrong(text, TextFormat::Markdown), [""; 0], "{text}");
    }
    assert_eq!(wrong(r"a\cos b + 1 = 0", TextFormat::Markdown), [""; 0]);
    for text in ["It is 0.52 = 5.2 by $x$.", "$x$, so 2 + 2 = 5"] {
        assert_eq!(wrong(text, TextFormat::Markdown).len(), 1, "{text}");
    }
}

#[test]
fn space_inside_dollar_signs_is_maths_in_a_notebook_only() {
    let cell = |text: &str| format!(r#"{{"cells":[{{"cell_type":"markdown","source":["{text}"]}}]}}"#);
    let slope = r"$ m = \\frac{150 - 110}{12 - 4} = 5.0$ mA/V";
    assert_eq!(wrong(&cell(slope), TextFormat::Notebook), [""; 0]);
    assert_eq!(report(&cell(slope), TextFormat::Notebook).tally.checked, 1);
    assert_eq!(wrong(&cell(&slope.replace("5.0", "6.0")), TextFormat::Notebook).len(), 1);
    assert_eq!(report("It costs $ 5 and 6 = 7 $ more.", TextFormat::Markdown).tally.formulas, 1);
}

#[test]
fn a_comma_in_an_argument_parts_no_equations() {
    assert_eq!(verdicts(r"H\ket{\frac{1}{2},1} = \frac{5}{2}"), [""; 0]);
    assert_eq!(verdicts(r"f(x), 2 + 2 = 6"), ["inconsistent"]);
}

#[test]
fn terms_behind_an_evaluation_bar_are_added() {
    let two = r"\left.\left(\frac{x^2}{2}\right)\right|_0^2 + \left.\left(3y - \frac{y^2}{2}\right)\right|_1^3";
    assert_eq!(verdicts(&format!("{two} = 4.0")), ["consistent"]);
    assert_eq!(verdicts(&format!("{two} = 5.0")), ["inconsistent"]);
    assert_eq!(verdicts(r"\left.x^2\right|_0^3 - 4 = 5"), ["consistent"]);
}
