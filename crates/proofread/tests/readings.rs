//! What else a chain may mean: each case is one in which something is left to be understood.

use crate::{report, verdicts};
use proofread::{ReportSection, TextFormat};

/// The list and the verdict of each pair in a text.
fn lists(text: &str) -> Vec<(&'static str, &'static str)> {
    report(text, TextFormat::Markdown).findings.iter().map(|of| (of.section.name(), of.verdict.name())).collect()
}

#[track_caller]
fn all(cases: &[(&str, &[&str])]) {
    for (tex, expected) in cases {
        assert_eq!(verdicts(tex), *expected, "{tex}");
    }
}

#[test]
fn factors_behind_a_stroke_may_all_be_below_it() {
    all(&[
        (r"1/2\pi = 0.159", &["consistent"]),
        (r"1/2\pi = 1.57", &["consistent"]),
        (r"1/2\pi = 0.179", &["inconsistent"]),
        (r"8.0/2(4.0) = 1.0", &["consistent"]),
        (r"1/2\,(3.0)(4.0)^2 = 24", &["consistent"]),
        (r"3/2\sqrt{2} = 1.06", &["consistent"]),
        (r"3/2\sqrt{2} = 1.26", &["inconsistent"]),
    ]);
}

#[test]
fn of_several_readings_the_nearest_is_shown() {
    let findings = report(r"$720^\circ/4\pi = 57.6^\circ$", TextFormat::Markdown).findings;
    assert_eq!(findings[0].recomputed.as_deref(), Some("57.3°"));
}

#[test]
fn a_factor_without_its_unit_is_for_the_list_of_units() {
    all(&[
        (r"\frac{2.50\,\text{V}}{50} = 50\,\text{mA}", &["units"]),
        (r"3\,\text{mA}\,(400 + 600) = 3\,\text{V}", &["units"]),
        (r"\frac{2.50\,\text{V}}{50} = 60\,\text{mA}", &["dimensions"]),
    ]);
}

#[test]
fn a_unit_directly_behind_the_formula_belongs_to_it() {
    for text in [
        r"$3\times10^{-9} / 0.06 = 5 \times 10^{-8} = 50$ nC/m.",
        r"$50\times10^{-9}\times 0.003 = 1.5 \times 10^{-10} = 150$ pC, say.",
        r"It is $0.25 = 25$% of all, or $2.5 \times 10^6 = 2.5$ million.",
        r"$0.9\,\text{m} \cdot 2 = 180$~cm",
    ] {
        let found = lists(text);
        assert!(!found.is_empty() && found.iter().all(|(list, _)| *list == "agreeing"), "{text}: {found:?}");
    }
    let html = "<p><math><mn>2</mn><mo>·</mo><mn>0.3</mn><mtext> m</mtext><mo>=</mo><mn>60</mn></math> cm</p>";
    assert!(report(html, TextFormat::Html).findings.iter().all(|of| of.section == ReportSection::Agreeing));
    // Another number stays wrong, and a word that is no unit changes nothing.
    assert!(lists(r"$3\times10^{-9} / 0.06 = 9 \times 10^{-8} = 90$ nC/m").contains(&("numbers", "inconsistent")));
    assert_eq!(lists(r"$2 + 2 = 7$ here"), [("numbers", "inconsistent")]);
}

#[test]
fn a_percentage_may_be_a_factor() {
    all(&[
        (r"3(0.50\%) = 1.50\%", &["consistent"]),
        (r"3(0.50\%) = 4.90\%", &["inconsistent"]),
        (r"36(15\%) = 36", &["consistent"]),
        (r"7.5\% \times 8.00 = 0.60\,\text{g}\,\text{cm}^{-3}", &["units"]),
        (r"7.5\% \times 8.00 = 0.70\,\text{g}\,\text{cm}^{-3}", &["dimensions"]),
        (r"12/200 \times 100 = 6.0\%", &["consistent"]),
    ]);
    assert_eq!(lists("It is 1.6% of 163.62 = 2.6 and 20% of 45 = 9.\n"), [("agreeing", "consistent"); 2]);
    assert_eq!(lists("It is 1.6% of 163.62 = 2.9.\n"), [("numbers", "inconsistent")]);
}

#[test]
fn a_unit_behind_the_formula_may_be_a_command_or_a_turn() {
    for text in [
        r"$15\,\text{V}/100\,\mu\text{A} = 150$\,k\Ohm.",
        r"$15\,\text{V}/100\,\mu\text{A} = 150$ k$\Omega$, so",
        r"$15\,\text{V}/3\,\text{A} = 5$~\ohm{}",
        r"$3/200 = 1.5$\%",
        r"$2\pi\,\text{rad} = 1$ turn",
        r"$6\pi\,\text{rad} = 3$ turns.",
    ] {
        let found = lists(text);
        assert!(!found.is_empty() && found.iter().all(|(list, _)| *list == "agreeing"), "{text}: {found:?}");
    }
    for text in [r"$15\,\text{V}/100\,\mu\text{A} = 160$\,k\Ohm.", r"$2\pi\,\text{rad} = 2$ turns", r"$3/200 = 1.9$\%"]
    {
        let found = lists(text);
        assert!(found.iter().any(|(list, _)| *list == "numbers"), "{text}: {found:?}");
    }
}

#[test]
fn words_may_say_the_sign() {
    for text in [
        r"$-7\ \mathsf{N} = 7\ \mathsf{N}\ \mathsf{\textit{to the left}}$",
        r"$3\,\text{m} - 8\,\text{m} = 5\,\text{m}$ downwards",
        r"$2.0\,\text{m/s} - 6.0\,\text{m/s} = 4.0\,\text{m/s}$, due west",
    ] {
        assert_eq!(lists(text), [("agreeing", "doubtful")], "{text}");
    }
    for text in
        [r"$\left(3 - 8\right) = 5$ and $\left(1\right)$", r"$3\,\text{m} - 8\,\text{m} = 6\,\text{m}$ downwards"]
    {
        assert!(lists(text).contains(&("numbers", "inconsistent")), "{text}");
    }
}

#[test]
fn particles_may_count_as_their_charge_and_pounds_as_a_mass() {
    all(&[
        (r"2.0\,\text{A} = 1.248\times10^{19}\,\text{electrons}/\text{s}", &["consistent"]),
        (r"2.0\,\text{A} = 1.348\times10^{19}\,\text{electrons}/\text{s}", &["inconsistent"]),
        (r"3\,\text{electrons} + 2\,\text{electrons} = 5\,\text{electrons}", &["consistent"]),
        (r"22.0\,\text{lb} = 9.98\,\text{kg}", &["consistent"]),
        (r"22.0\,\text{lb} = 97.9\,\text{N}", &["consistent"]),
        (r"22.0\,\text{lb} = 9.78\,\text{kg}", &["inconsistent"]),
    ]);
}

#[test]
fn a_vector_may_begin_in_the_formula_before() {
    all(&[
        (r"- 2.0\,\text{N}\,\hat{j} = -3.0\,\text{N}\,\hat{i} - 2.0\,\text{N}\,\hat{j}", &["doubtful"]),
        (r"- 2.3\,\text{N}\,\hat{j} = -3.0\,\text{N}\,\hat{i} - 2.0\,\text{N}\,\hat{j}", &["inconsistent"]),
        (r"3.0\hat{i} + 2.0\hat{j} = 2.0\hat{j}", &["inconsistent"]),
    ]);
}

#[test]
fn what_is_cut_off_is_called_so() {
    all(&[
        (r"179.2\,\text{s} = 2.98\,\text{min}", &["truncated"]),
        (r"2.986 = 2.98", &["truncated"]),
        (r"2.98 = 2.986", &["truncated"]),
        (r"179.2\,\text{s} = 2.97\,\text{min}", &["inconsistent"]),
    ]);
}

#[test]
fn behind_approximately_equal_three_digits_are_meant() {
    all(&[
        (r"\frac{22}{7} \approx 3.142", &["truncated"]),
        (r"\frac{22}{7} \approx 3.2", &["approximate"]),
        (r"\frac{22}{7} \approx 3", &["consistent"]),
        (r"0.952 \approx 1", &["approximate"]),
        (r"\frac{22}{7} \approx 3.18", &["inconsistent"]),
    ]);
}

#[test]
fn a_unit_that_is_understood_is_for_the_list_of_units() {
    all(&[
        (r"\frac{0.026}{2}(-0.5) = -6.5\,\text{meV}", &["units"]),
        (r"\frac{0.026}{2}(-0.5) = -7.5\,\text{meV}", &["inconsistent"]),
        (r"\sqrt{(16)(4\times10^{-6})} = 80\,\mu\text{m}", &["units"]),
        (r"\sqrt{(16)(4\times10^{-6})} = 90\,\mu\text{m}", &["inconsistent"]),
        // A centimetre is not understood beside metres, nor any unit beside one that is computed.
        (r"3 \times 40 = 1.2\,\text{m}", &["inconsistent"]),
        (r"0.2 \times 3 = 200\,\text{meV} \times 4", &["inconsistent"]),
        (r"62.8\,\text{rad} = \frac{62.8}{2\pi}", &["units"]),
        (r"62.8\,\text{rad} = \frac{63.8}{2\pi}", &["inconsistent"]),
        (r"62.8\,\text{rad} = 9.995", &["inconsistent"]),
        (r"\frac{2.0\times10^{-9}}{24.0} = 5.0\times10^{16}", &["units"]),
        (r"\frac{2.0\times10^{-9}}{24.0} = 6.0\times10^{16}", &["inconsistent"]),
    ]);
}

#[test]
fn a_quantity_behind_a_preposition_may_belong_to_the_words() {
    for text in [
        r"The mass left after $60\,\text{days} = (\frac12)^2\times80\,\text{g} = 20\,\text{g}$",
        r"$$P(2<X<3)\text{ for 10 events}=0.9^{10}$$",
        r"<p>The mass left after <em>$60\,\text{days} = (\frac12)^2\times80\,\text{g}$</em></p>",
    ] {
        let found = lists(text);
        assert!(!found.is_empty() && found.iter().all(|(list, _)| *list == "agreeing"), "{text}: {found:?}");
    }
    for text in [
        // No preposition, a quantity of one kind on both sides, and the next pair of the chain.
        r"The mass $60\,\text{days} = (\frac12)^2\times80\,\text{g}$",
        r"The time for $60\,\text{s} = 2 \times 40\,\text{s}$",
        r"The time for $1\,\text{gallon} = 3.9\,\text{liters}$",
        r"The mass left after $60\,\text{days} = (\frac12)^2\times80\,\text{g} = 30\,\text{g}$",
    ] {
        assert!(lists(text).iter().any(|(list, _)| *list == "numbers"), "{text}");
    }
}

#[test]
fn the_words_behind_a_number_may_name_its_base() {
    for text in [
        r"$1 \times 4 + 0 \times 2 + 1 \times 1 = 101$ in binary",
        r"$8 + 2 = 12$ in octal",
        r"$2 \times 16 + 3 = 23$ (hexadecimal)",
    ] {
        assert_eq!(lists(text), [("agreeing", "doubtful")], "{text}");
    }
    for text in [
        r"$1 \times 4 + 0 \times 2 + 1 \times 1 = 111$ in binary",
        r"$1 \times 4 + 0 \times 2 + 1 \times 1 = 201$ in binary",
        r"$1 \times 4 + 0 \times 2 + 1 \times 1 = 101$. In binary it is shorter.",
    ] {
        assert_eq!(lists(text), [("numbers", "inconsistent")], "{text}");
    }
}

#[test]
fn what_rounding_leaves_is_no_difference() {
    all(&[
        (r"\sin(6\pi) = \sin(0) = 0", &["consistent", "consistent"]),
        (r"\cos(\frac{5\pi}{2}) = \cos(\frac{\pi}{2})", &["consistent"]),
        (r"\tan(3\pi) = \sin(2\pi)", &["consistent"]),
        (r"0.1 + 0.2 - 0.3 = \sin(0)", &["consistent"]),
        (r"\sin(6.1\pi) = \sin(0)", &["inconsistent"]),
    ]);
}

#[test]
fn a_parsec_has_206265_astronomical_units() {
    all(&[
        (r"1\,\text{pc} = 206265\,\text{AU}", &["consistent"]),
        (r"1\,\text{pc} = 206256\,\text{AU}", &["inconsistent"]),
        (r"1\,\text{ly} = 9.4607\times10^{15}\,\text{m}", &["consistent"]),
    ]);
}
