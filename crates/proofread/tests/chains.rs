//! Chains as they were printed, with the verdict that each must have.
//!
//! The errata are those of *University Physics* (OpenStax) that its publisher corrected after September 2022, by module; the
//! four slips at the end are of the sources that this project reads.

use crate::verdicts;

#[track_caller]
fn all(cases: &[(&str, &[&str])]) {
    for (tex, expected) in cases {
        assert_eq!(verdicts(tex), *expected, "{tex}");
    }
}

#[test]
fn accepted_errata_are_found() {
    all(&[
        // m58748, m58494, m58348, m58587, m58305
        (r"\frac{(4.0\times10^{-2}\,\text{H})(5.0\,\text{A})}{50} = 4.0\times10^{-5}\,\text{Wb}", &["inconsistent"]),
        (r"(2.0\,\text{A})^2(6000\,\Omega) = 24.000\,\text{W}", &["inconsistent"]),
        (r"2.65\times10^{11} + 3.32\times10^{10} = 2.95\times10^{11}\,\text{J}", &["inconsistent"]),
        ("4(2) + 2 = 6", &["inconsistent"]),
        (r"\tan 31.0^\circ = 0.609", &["inconsistent"]),
        // m58335, m58327, m58512, m58601, m58580
        (r"\frac{5.0\,\text{m/s}^2}{(6)9.8\,\text{m/s}^2} = 0.43\,\text{m}", &["dimensions"]),
        (r"\frac{0 - (733.0)^2}{2(73.3)} = 3665.2\,\text{rad}", &["inconsistent"]),
        (r"\sin^{-1}\left[\frac{1.000\sin 43.2^\circ}{1.530}\right] = 26.4^\circ", &["last-digit"]),
        (r"\frac{4.5\times10^{-1}\,\text{A}}{2.2\times10^{-8}\,\text{A}} = 2.0\times10^8", &["inconsistent"]),
        (r"\left(\frac{0.050}{1.700\times10^{-68}}\right)^{1/2} = 1.2\times10^{33}", &["inconsistent"]),
        // m58572, m58373, m58392, m58719
        (
            r"(7.0888 - 1)(9.11\times10^{-31}\,\text{kg})(3.00\times10^8\,\text{m/s}^2) = 4.9922\times10^{-13}\,\text{J}",
            &["dimensions"],
        ),
        (r"\sqrt{\frac{2\,\text{kg}(9.8\,\text{m/s})}{0.006\,\text{kg/m}}} = 57.15\,\text{m/s}", &["units"]),
        (
            r"\frac{4.0026\times10^{-3}\,\text{kg/mol}}{6.02\times10^{23}\,\text{mol}} = 6.65\times10^{-27}\,\text{kg}",
            &["units"],
        ),
        (r"(12.5\,\text{N/m}^2)\left(\frac{8}{3}\right) = 33.3\,\text{J}", &["units"]),
        // m58387, with an evaluation bar
        (
            r"(6.04\times10^{-4}\,\text{J/K}^4)T^4\Big|_{5\,\text{K}}^{15\,\text{K}} = 0.302\,\text{J}",
            &["inconsistent"],
        ),
    ]);
}

#[test]
fn misprints_that_still_stand_are_found() {
    all(&[
        (r"2.40\,\text{m/s}^2(12.0\,\text{s})^2 = 172.80\,\text{m}", &["inconsistent"]),
        (r"43.4 - 29.8 = 13.8\,\text{km/s}", &["last-digit"]),
        (r"(46.6\,\text{W})(86.400\,\text{s}) = 4.03\times10^6\,\text{J}", &["inconsistent"]),
        (
            r"\frac{24\,\text{V} - 12\,\text{V}}{10.0\,\Omega + 30.0\,\Omega + 10.0\,\Omega} = 0.20\,\text{A}",
            &["inconsistent"],
        ),
        (r"\frac{3.00\times10^8\,\text{m/s}}{2(2.45\times10^9\,\text{Hz})} = 6.02\,\text{cm}", &["inconsistent"]),
        (r"239.052157\,\text{u} - 239.046526\,\text{u} = 0.0005631\,\text{u}", &["inconsistent"]),
        (r"\frac{1000\,\text{MeV}}{8.62\times10^{11}\,\text{MeV/K}} = 1.2\times10^{13}\,\text{K}", &["inconsistent"]),
        ("1 - 0.241 = 0.722", &["inconsistent"]),
        ("0.25^4 \\cdot 0.75 = 0.0117", &["inconsistent"]),
        ("10^{10} = 1024", &["inconsistent"]),
    ]);
}

#[test]
fn slips_of_the_sources_are_found() {
    all(&[
        (r"1/18 = 0.0555", &["truncated"]),
        (r"\frac{1}{\sin(\pi/3)} = 1.156", &["last-digit"]),
        (r"\frac{1\cdot\sin 30^\circ}{\sin 60^\circ} = 0.557", &["inconsistent"]),
    ]);
    let rows = "v = 500 \\sin 17.6^\\circ \\\\ v = 251.2";
    assert_eq!(verdicts(rows), ["inconsistent"]);
    assert_eq!(verdicts(&rows.replace("251", "151")), ["consistent"]);
}

#[test]
fn every_plausible_reading_is_tried() {
    all(&[
        (r"\sin 30 = 0.5", &["consistent"]),
        (r"\sin 0.5236 = 0.500", &["consistent"]),
        (r"2\frac{3}{4} = 2.75", &["consistent"]),
        (r"2\,\frac{3}{4} = 1.5", &["consistent"]),
        (r"3.0\pm 1.0 = 2.0", &[]),
        (r"\pm\sqrt{4.0} = -2.0", &["consistent"]),
        (
            r"(2.0\,\text{kg})(4186\,\text{J/kg}\cdot{}^\circ\text{C})(10\,{}^\circ\text{C}) = 83720\,\text{J}",
            &["consistent"],
        ),
        (r"20.0\,{}^\circ\text{C} = 293\,\text{K}", &["consistent"]),
        (r"10.0\,\text{rev/s} = 62.8\,\text{rad/s}", &["consistent"]),
        (r"2300/14.7\,\text{atm} = 156\,\text{atm}", &["consistent"]),
        (r"3.0\,\text{m} = 300\,\text{cm} (1.4)", &["consistent"]),
        (r"2\,\text{min}\,30\,\text{s} = 150\,\text{s}", &["consistent"]),
        (r"5! = 120", &["consistent"]),
        (r"\left[\frac{x^3}{3}\right]_0^2 = 2.67", &["consistent"]),
        (r"\frac{x^3}{3}\Big|_0^2 = 2.77", &["inconsistent"]),
        (r"(3.0\hat{i} + 4.0\hat{j})\cdot(1.0\hat{i} + 2.0\hat{j}) = 11", &["consistent"]),
        (r"(1.0\hat{i})\times(2.0\hat{j}) = 2.0\hat{k}", &["consistent"]),
    ]);
}

#[test]
fn digits_leave_open_what_they_leave_open() {
    all(&[
        (r"\frac{1}{3} = 0.33", &["consistent"]),
        (r"\frac{2}{3} = 0.66", &["truncated"]),
        (r"2.0 \times 3.33 = 6.7", &["consistent"]),
        (r"0.25 \times 20.00 \sin 45^\circ = 3.53", &["rounded"]),
        (r"\pi \approx \frac{22}{7}", &[]),
        (r"\frac{22}{7} \approx 3.1", &["consistent"]),
        (r"1234 \approx 1200", &["consistent"]),
        (r"5280 \approx 5400", &["approximate"]),
        (r"80.93 + 450.0 = 530.98", &["last-digit"]),
        (r"27 - 20 = 6", &["inconsistent"]),
        (r"270 - 20 = 251", &["last-digit"]),
        // Nothing is rounded on the way in a sum, nor are integers if the result is much finer.
        (r"150.1 - 75.0 = 75.0", &["last-digit"]),
        (r"160^\circ + 47^\circ = 208^\circ", &["last-digit"]),
        (r"(4.73\,\text{J}) - (-2.28\,\text{J}) = 7.00\,\text{J}", &["last-digit"]),
        (r"(150.1)(75.0) = 11260", &["consistent"]),
        (r"\frac{80}{3} + 0.125 = 26.731", &["inconsistent"]),
        (r"400/3 = 130", &["consistent"]),
        // Not said to be equal.
        (r"3 \neq 7", &[]),
        (r"2 + 2 < 5", &[]),
        ("x = 5.0", &[]),
        ("a + b = 3.0", &[]),
    ]);
}

#[test]
fn numbers_that_were_split_are_joined() {
    all(&[
        (r"35{,}200 + 1 = 35{,}201", &["consistent"]),
        (r"35\,200 + 1 = 35\,201", &["consistent"]),
        (r"12{,}5 + 1 = 13{,}5", &["consistent"]),
        (r"(2.0\,\mu\text{C})(3.0\,\text{V}) = 6.0\,\mu\text{J}", &["consistent"]),
        (r"5.0\,\text{Nm} / 2.0\,\text{m} = 2.5\,\text{N}", &["consistent"]),
        (r"760\,\text{mm Hg} = 1.013\times10^5\,\text{Pa}", &["consistent"]),
    ]);
}
