//! Each threshold of the proofreader from both sides: two texts that differ by as little as their digits allow are told apart. What
//! only bounds the work (lengths, depths, counts) is tried in the fuzz test.

use crate::{report, verdicts};
use proofread::{Doubt, TextFormat};

/// Why the first difference in a text is set aside.
fn doubt(text: &str) -> Option<Doubt> {
    report(text, TextFormat::Markdown).findings.first().unwrap_or_else(|| panic!("nothing is read in {text}")).doubt
}

#[track_caller]
fn apart(doubted: &str, counted: &str, why: Doubt) {
    assert_eq!((doubt(doubted), doubt(counted)), (Some(why), None), "{doubted} and {counted}");
}

#[track_caller]
fn judged(cases: &[(&str, &str)]) {
    for (tex, verdict) in cases {
        assert_eq!(verdicts(tex), [*verdict], "{tex}");
    }
}

#[test]
fn a_quantity_is_its_size_within_a_twentieth() {
    apart(r"$-76.00\,\text{N} = 80.00\,\text{N}$", r"$-75.98\,\text{N} = 80.00\,\text{N}$", Doubt::Fragment);
    let deviation = |printed: &str| format!(r"$(76.10-80.00)/80.00 \times 100\% = {printed}\%$");
    apart(&deviation("5.13"), &deviation("5.15"), Doubt::Fragment);
}

#[test]
fn two_bare_numbers_are_far_apart_beyond_seven_tenths_of_the_larger_one() {
    apart("$0.299 = 1.000$", "$0.300 = 1.000$", Doubt::Fragment);
}

#[test]
fn a_number_of_two_digits_is_a_fragment_and_one_of_three_is_none() {
    apart("12 = 4 + 9", "123 = 4 + 9", Doubt::Fragment);
    // A formula that is nothing else has no parts.
    apart("$0 = 4 + 9$", "$12 = 4 + 9$", Doubt::Fragment);
    apart("$9.81(23) = 9.7$", "$9.81(234) = 9.7$", Doubt::Unknown);
    apart("$9.81(2) = 9.7$", "$9.8(2) = 9.7$", Doubt::Unknown);
}

#[test]
fn three_formulas_with_one_factor_are_a_habit_and_two_are_none() {
    let two = r"$1.0+1.0=4.00$ and $2.5\cdot 2=10.00$";
    apart(&format!("{two} and $4.0+2.0=12.00$"), two, Doubt::Habit);
    // The factors are one within half a per cent, and that of a convention.
    apart(&format!("{two} and $4.0+2.0=12.05$"), &format!("{two} and $4.0+2.0=12.07$"), Doubt::Habit);
    let times = |factor: f64, digits: usize| {
        let printed = [2.0, 4.0, 6.0].map(|right| format!("{:.digits$}", right * factor));
        format!("$1.00+1.00={}$ and $2.00\\cdot 2={}$ and $4.00+2.00={}$", printed[0], printed[1], printed[2])
    };
    for (habit, other) in [(9.81, 9.7), (60.0, 59.5), (100.0, 99.0), (3.6, 3.56), (4.19, 4.25), (0.0174533, 0.0176)] {
        apart(&times(habit, 5), &times(other, 5), Doubt::Habit);
    }
    // Ten and a tenth of it are misplaced points.
    apart(&times(0.01, 5), &times(0.1, 5), Doubt::Habit);
    apart(&times(100.0, 3), &times(10.0, 3), Doubt::Habit);
}

#[test]
fn steps_explain_a_quarter_of_what_they_leave_open() {
    judged(&[
        (r"2.3 \cdot 3.1\,\text{m} = 7.062\,\text{m}", "inconsistent"),
        // Bare numbers are given as they are.
        (r"2.3 \cdot 3.1 = 7.063", "inconsistent"),
        ("153/211 = 0.72614", "inconsistent"),
        (r"2.3 \cdot 3.1\,\text{m} = 7.063\,\text{m}", "rounded"),
        (r"2.3 \cdot 3.1\,\text{m} = 7.197\,\text{m}", "rounded"),
        (r"2.3 \cdot 3.1\,\text{m} = 7.198\,\text{m}", "inconsistent"),
        (r"153\,\text{m}/211 = 0.72409\,\text{m}", "inconsistent"),
        (r"153\,\text{m}/211 = 0.72410\,\text{m}", "rounded"),
        (r"153\,\text{m}/211 = 0.72614\,\text{m}", "rounded"),
        (r"153\,\text{m}/211 = 0.72615\,\text{m}", "inconsistent"),
    ]);
}

#[test]
fn integers_that_were_rounded_to_tens_explain_less() {
    judged(&[
        ("150/210 = 0.7132", "inconsistent"),
        (r"150\,\text{m}/210 = 0.7133\,\text{m}", "rounded"),
        (r"150\,\text{m}/210 = 0.7153\,\text{m}", "rounded"),
        ("150/210 = 0.7154", "inconsistent"),
    ]);
}

#[test]
fn a_result_is_as_coarse_as_its_integers_up_to_a_bound() {
    judged(&[("132/149 = 0.893", "last-digit"), ("91/133 = 0.692", "inconsistent")]);
}

#[test]
fn the_last_digit_is_within_one_unit() {
    judged(&[
        (r"23 \cdot 31 = 711", "inconsistent"),
        (r"23 \cdot 31 = 712", "last-digit"),
        (r"23 \cdot 31 = 714", "last-digit"),
        (r"23 \cdot 31 = 715", "inconsistent"),
        (r"\sqrt{23} = 4.794", "inconsistent"),
        (r"\sqrt{23} = 4.795", "truncated"),
        (r"\sqrt{23} = 4.797", "last-digit"),
        (r"\sqrt{23} = 4.798", "inconsistent"),
    ]);
}

#[test]
fn three_digits_behind_an_approximate_sign_are_meant_to_be_right() {
    judged(&[(r"29/3 \approx 9.6", "approximate"), (r"29/3 \approx 9.9", "inconsistent")]);
    judged(&[(r"5/3 \approx 1.6", "approximate"), (r"5/3 \approx 1.5", "inconsistent")]);
}

#[test]
fn a_sine_is_at_most_one_up_to_the_rounding_of_a_machine() {
    judged(&[
        (r"\arcsin 1.0000001 = 1.571", "consistent"),
        (r"\arcsin 1.0000002 = 1.571", "inconsistent"),
        (r"\arccos 1.0000001 = 0.000", "consistent"),
        (r"\arccos 1.0000002 = 0.000", "inconsistent"),
    ]);
}

#[test]
fn the_size_of_a_unit_is_rounded_by_as_much_as_texts_do() {
    // A unit, another one, its size in it, and how far the two may be apart over the larger one.
    for (unit, other, size, by) in [
        ("\\text{hp}", "W", 746.0, 0.015),
        ("\\text{cal}", "J", 4.186, 0.0012),
        ("\\text{Btu}", "J", 1055.06, 0.0015),
        ("\\text{yr}", "s", 3.155_76e7, 0.003),
        ("\\text{ly}", "m", 9.460_730_472_580_8e15, 0.003),
        ("\\text{mi}", "m", 1609.344, 0.006),
        ("\\text{lb}", "N", 4.448_221_6, 0.003),
        ("\\text{knot}", "m/s", 0.514_444, 0.002),
        ("M_\\odot", "kg", 1.988e30, 0.01),
    ] {
        for (apart, verdict) in [(0.99 * by, "rounded"), (1.01 * by, "inconsistent")] {
            for printed in [size * (1.0 - apart), size / (1.0 - apart)] {
                let text = format!("{printed:.6e}");
                let (digits, power) = text.split_once('e').expect("a power of ten");
                let tex = format!("1.000000\\,{unit} = {digits}\\times10^{{{power}}}\\,\\text{{{other}}}");
                assert_eq!(verdicts(&tex), [verdict], "{tex}");
            }
        }
    }
}

#[test]
fn a_quantity_in_two_units_has_as_many_parts_as_its_unit() {
    for (large, small, parts) in [
        ("h", "min", 60),
        ("min", "s", 60),
        ("hr", "min", 60),
        ("ft", "in", 12),
        ("lb", "oz", 16),
        ("kg", "g", 1000),
        ("m", "cm", 100),
        ("km", "m", 1000),
    ] {
        for (more, verdict) in [(-2, "inconsistent"), (0, "consistent"), (2, "inconsistent")] {
            let text = format!("2 {large} 3 {small} = {} {small}", 2 * parts + 3 + more);
            let found: Vec<_> =
                report(&text, TextFormat::Markdown).findings.iter().map(|of| of.verdict.name()).collect();
            assert_eq!(found, [verdict], "{text}");
        }
    }
}

#[test]
fn a_mass_counts_as_its_weight_by_three_values_of_gravity() {
    let tex = |newtons: &str| format!(r"10.000\,\text{{kg/cm}}^2 = {newtons}\,\text{{N/cm}}^2");
    for weight in ["98.067", "98.10", "98.00"] {
        judged(&[(&tex(weight), "units")]);
    }
    judged(&[(&tex("98.20"), "dimensions"), (&tex("97.90"), "dimensions")]);
}

#[test]
fn a_result_in_brackets_is_the_same_in_another_unit_within_a_fiftieth() {
    let tex = |centimetres: &str| format!(r"2.000\,\text{{in}} ({centimetres}\,\text{{cm}}) = 5.08\,\text{{cm}}");
    judged(&[(&tex("5.17"), "consistent"), (&tex("5.19"), "units")]);
}

#[test]
fn a_share_in_brackets_is_its_number_within_a_fiftieth() {
    judged(&[
        (r"12.00/24.00\,(1 - 49.1\%) = 0.500", "consistent"),
        (r"12.00/24.00\,(1 - 48.9\%) = 0.500", "inconsistent"),
        (r"12.00/24.00\,(1 - 50.9\%) = 0.500", "consistent"),
        (r"12.00/24.00\,(1 - 51.1\%) = 0.500", "inconsistent"),
    ]);
}

#[test]
fn a_ratio_is_its_level_within_a_fiftieth() {
    judged(&[
        (r"10.00 \cdot 10.00 = 20.40\,\text{dB}", "doubtful"),
        (r"10.00 \cdot 10.00 = 20.42\,\text{dB}", "inconsistent"),
        (r"10.00 \cdot 10.00 = 19.61\,\text{dB}", "doubtful"),
        (r"10.00 \cdot 10.00 = 19.60\,\text{dB}", "inconsistent"),
    ]);
}

/// The verdict on the only pair of a text.
fn only(text: &str) -> Option<&'static str> {
    let found = report(text, TextFormat::Markdown).findings;
    assert!(found.len() <= 1, "{text}");
    found.first().map(|of| of.verdict.name())
}

#[test]
fn what_is_said_of_a_formula_is_said_within_160_bytes_of_it() {
    // With the word and two spaces there are 160 bytes, or one more.
    let before = |between: usize| format!(r"The scale {} $1.00\,\text{{cm}} = 5.00\,\text{{km}}$", "x".repeat(between));
    let behind = |between: usize| format!(r"$1.00\,\text{{cm}} = 5.00\,\text{{km}}$ {} scale", "x".repeat(between));
    let verdicts = [before(153), before(154), behind(153), behind(154)].map(|text| only(&text));
    let [doubtful, inconsistent] = [Some("doubtful"), Some("inconsistent")];
    assert_eq!(verdicts, [doubtful, inconsistent, doubtful, inconsistent]);
}

#[test]
fn rows_are_compared_that_a_line_end_or_an_inferring_word_is_between() {
    let rows = |between: &str| only(&format!(r"$v = 3.0 \cdot 4.0${between}$v = 13.0$"));
    for (between, beyond) in
        [("\n\n", "\n\n\n"), (" so", " or"), (" \u{2192}", "."), ("\n", ","), (" thus", ";"), (" hence", ":")]
    {
        assert_eq!((rows(between), rows(beyond)), (Some("inconsistent"), None), "{between:?} and {beyond:?}");
    }
    // With the signs of both formulas and the second name there are 400 bytes.
    assert_eq!(
        (rows(&format!(" so{}", " ".repeat(390))), rows(&format!(" so{}", " ".repeat(392)))),
        (Some("inconsistent"), None)
    );
}

#[test]
fn behind_an_approximate_sign_only_the_rounding_of_steps_is_forgiven() {
    judged(&[
        (r"(0.7+0.82+0.95)/3 \approx 0.823", "consistent"),
        (r"(0.7+0.82+0.95)/3 \approx 0.833", "inconsistent"),
        (r"17/7 \approx 2.430", "last-digit"),
        // The root goes on as 1.73, and its last digit is the result's.
        (r"5\sqrt{3} \approx 8.65", "approximate"),
        (r"5\sqrt{3} \approx 8.63", "inconsistent"),
        // Of two digits, the second may be rough.
        (r"17/7 \approx 2.5", "approximate"),
        // So are terms that were rounded before they are added.
        (r"0.333 + 0.333 + 0.333 \approx 1.000", "approximate"),
        (r"0.333 + 0.333 + 0.333 \approx 1.003", "inconsistent"),
    ]);
}

#[test]
fn behind_an_approximate_sign_three_digits_are_judged_as_behind_an_equals_sign() {
    for sign in ["=", r"\approx"] {
        let judged = |left: &str, right: &str, verdict: &str| {
            let tex = format!("{left} {sign} {right}");
            assert_eq!(verdicts(&tex), [verdict], "{tex}");
        };
        judged("67/120", "0.558", "consistent");
        judged("67/120", "0.559", "inconsistent");
        // A printed number with no fewer digits is no estimate.
        judged("12.345", "12.3", "consistent");
        judged("12.345", "12.4", "last-digit");
        judged(r"123.45\,\text{m}", r"123\,\text{m}", "consistent");
        judged(r"123.45\,\text{m}", r"122\,\text{m}", "last-digit");
        judged("0.55600", r"55.6\%", "consistent");
        judged("0.55600", r"55.7\%", "last-digit");
    }
    // With fewer digits it is one.
    judged(&[(r"12.3 \approx 12.35", "consistent")]);
}

#[test]
fn a_share_in_per_cent_leaves_as_little_open_as_a_bare_number() {
    judged(&[
        (r"67/120 = 55.8\%", "consistent"),
        (r"67/120 = 55.9\%", "inconsistent"),
        (r"67/120 \approx 55.9\%", "inconsistent"),
        (r"(1+0.05)(1-0.03)-1 = 1.85\%", "consistent"),
        (r"(1+0.05)(1-0.03)-1 = 1.95\%", "inconsistent"),
        // With another unit, the numbers are measured.
        (r"67\,\text{m}/(120\,\text{m}) = 55.9\%", "rounded"),
        // A zero is a rounded one.
        (r"1 - 0.998 = 0\%", "consistent"),
    ]);
}

#[test]
fn a_small_difference_of_rounded_numbers_explains_nothing_by_itself() {
    apart(r"$\frac{0.83-0.78}{0.0142} = 3.61$", r"$\frac{0.83-0.78}{0.0142} = 7.61$", Doubt::Inputs);
    judged(&[
        (r"\frac{0.83-0.78}{0.0142} = 3.52", "consistent"),
        // The terms are exact in a sum alone.
        ("0.83 - 0.78 = 0.06", "inconsistent"),
        (r"\frac{0.83-0.18}{0.0142} = 45.9", "rounded"),
    ]);
}

#[test]
fn the_last_digit_is_one_of_three() {
    judged(&[("24.1 - 12.0 = 12.2", "last-digit"), ("2.4 - 1.2 = 1.3", "inconsistent"), ("2 + 2 = 5", "inconsistent")]);
}

#[test]
fn whole_numbers_are_reckoned_exactly_up_to_ten_thousand() {
    judged(&[
        ("4 + 5 = 9", "consistent"),
        ("4 + 5 = 10", "inconsistent"),
        ("60 = 58 + 2", "consistent"),
        ("60 = 58 + 1", "inconsistent"),
        ("12^2 = 140", "inconsistent"),
        ("5! = 100", "inconsistent"),
        (r"\binom{10}{6} = 200", "inconsistent"),
        (r"\sqrt{121} = 10", "inconsistent"),
        (r"2^{10} = 1000", "inconsistent"),
        (r"4 + 5 \approx 10", "consistent"),
        (r"3 \cdot 3.0 = 10", "inconsistent"),
        (r"3 \cdot 3.1 = 10", "consistent"),
        (r"10^2 = 130", "inconsistent"),
        (r"40 \cdot 0.80 = 30", "inconsistent"),
        ("12345678901 + 1 = 12345678905", "inconsistent"),
        (r"2^{40} = 1099511627776", "consistent"),
        (r"4 \cdot 10^{-14} = 3 \cdot 10^{-14}", "inconsistent"),
        (r"4\,\text{m} + 5\,\text{m} = 10\,\text{m}", "consistent"),
        (r"99 \cdot 101 = 9900", "inconsistent"),
        (r"101 \cdot 101 = 10000", "consistent"),
        (r"67 \cdot 1432 = 96000", "consistent"),
    ]);
}

#[test]
fn bare_decimals_leave_less_open_than_measured_ones() {
    judged(&[
        (r"100 \cdot 0.25 = 26", "inconsistent"),
        (r"100\,\text{m} \cdot 0.25 = 26\,\text{m}", "rounded"),
        (r"1.04 \cdot 100 = 105", "last-digit"),
        // Numbers with far fewer digits than the result are meant as they are.
        (r"\sqrt{0.6} = 0.784", "inconsistent"),
        (r"637/96 = 6.63572", "inconsistent"),
        // A logarithm has as many decimals as its argument has digits.
        (r"\ln 2.5 = 0.9163", "consistent"),
        (r"\ln 2.5 = 0.9183", "rounded"),
        (r"\ln 2.5 = 0.9463", "inconsistent"),
    ]);
}

#[test]
fn what_the_digits_hold_is_not_cut_off() {
    judged(&[
        ("3/7 = 0.42", "truncated"),
        ("1/5 = 0.1", "inconsistent"),
        ("5/8 = 0.624", "last-digit"),
        (r"\binom{9}{2} = 30", "inconsistent"),
        ("8/3 = 2", "truncated"),
    ]);
}

#[test]
fn bare_numbers_beside_a_unit_agree_as_numbers_do() {
    judged(&[
        (r"2.5 + 3.1 = 5.6\,\text{mm}", "consistent"),
        (r"2.5 + 3.1 = 5.7\,\text{mm}", "inconsistent"),
        (r"20.00 + 0.0849 = 20.0849\,\text{mm}", "consistent"),
        (r"20.00 + 0.0849 = 20.0809\,\text{mm}", "last-digit"),
        (r"2.5 \cdot 3.1 = 7.75\,\text{mm}", "consistent"),
        (r"2.5 \cdot 3.1 = 8.95\,\text{mm}", "inconsistent"),
        // Volts over kilohms.
        (r"\frac{5.0}{2.0} = 2500\,\text{μA}", "units"),
    ]);
}

#[test]
fn a_conversion_gains_no_digits() {
    judged(&[
        (r"0.5\,\text{m} = 500\,\text{mm}", "consistent"),
        (r"0.5\,\text{m} = 506\,\text{mm}", "inconsistent"),
        (r"0.5\,\text{m} = 0.506\,\text{m}", "truncated"),
        (r"3.5\,\text{cm} = 40\,\text{mm}", "consistent"),
        (r"3.5\,\text{cm} = 41\,\text{mm}", "inconsistent"),
        (r"0.333\,\text{h} = 20\,\text{min}", "consistent"),
        (r"5\,\text{ft} = 152.4\,\text{cm}", "consistent"),
        (r"1609\,\text{m} = 1.6\,\text{km}", "consistent"),
        (r"0.5\,\text{N}\cdot\text{m} = 506\,\text{N}\cdot\text{mm}", "inconsistent"),
    ]);
}
