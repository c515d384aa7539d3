//! Are the limits those of ISO 286, by its formulas and by tables of fits?

use geneva_kinematics::wheel::{ToleranceClass, ToleranceLetter};

/// The ends of the standard's ranges in millimetres.
const UP_TO: [f64; 13] = [3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0];

/// The limits in micrometres of a letter and a grade at the end of each range.
fn limits(letter: ToleranceLetter, grade: u32) -> [[f64; 2]; 13] {
    UP_TO.map(|size| {
        let limits = ToleranceClass { letter, grade }.limits(size).expect("a size of the standard");
        limits.map(|limit| (1000.0 * limit).round())
    })
}

/// The widths of a grade in micrometres.
fn widths(grade: u32) -> [f64; 13] {
    limits(ToleranceLetter::UpperH, grade).map(|[_, above]| above)
}

/// The geometric mean of a range; that of the first is from 1 mm on.
fn mean(range: usize) -> f64 {
    (range.checked_sub(1).map_or(1.0, |before| UP_TO[before]) * UP_TO[range]).sqrt()
}

/// Micrometres as the standard rounds them: to 1 up to 100, to 5 up to 200, and then to 10.
fn rounded(x: f64) -> f64 {
    let step = if x <= 100.0 {
        1.0
    } else if x <= 200.0 {
        5.0
    } else {
        10.0
    };
    (x / step).round() * step
}

/// Which values of a row differ from the formula's: the range, and the difference in micrometres.
fn differences(row: &[f64; 13], formula: impl Fn(f64, usize) -> f64) -> Vec<(usize, f64)> {
    let of = |k: usize| (k, row[k] - rounded(formula(mean(k), k)));
    (0..13).map(of).filter(|(_, by)| *by != 0.0).collect()
}

#[test]
fn grades_are_multiples_of_the_tolerance_unit_but_where_the_standard_rounds_otherwise() {
    let unit = |mean: f64| 0.45 * mean.cbrt() + 0.001 * mean;
    let factors = [7.0, 10.0, 16.0, 25.0, 40.0, 64.0, 100.0];
    let found: Vec<_> =
        (5..=11).zip(factors).map(|(grade, k)| differences(&widths(grade), |mean, _| k * unit(mean))).collect();
    let expected: [&[(usize, f64)]; 7] = [
        &[],
        &[(0, 1.0), (1, 1.0), (11, 1.0), (12, 1.0)],
        &[(0, 1.0), (2, 1.0), (3, 1.0), (12, 1.0)],
        &[],
        &[(0, 3.0), (1, 1.0)],
        &[(0, 5.0), (1, 1.0), (2, 1.0), (3, 1.0)],
        &[(0, 6.0), (1, 2.0), (5, 5.0), (6, 5.0), (11, 10.0), (12, 10.0)],
    ];
    assert_eq!(found, expected);
}

#[test]
fn letters_follow_their_formulas_but_where_the_standard_rounds_otherwise() {
    use ToleranceLetter::{LowerE, LowerF, LowerG, LowerM, UpperP};
    let above = |letter, grade| limits(letter, grade).map(|[_, above]| -above);
    let (e, f, g) = (above(LowerE, 8), above(LowerF, 8), above(LowerG, 8));
    let (m, p) = (limits(LowerM, 6).map(|[below, _]| below), above(UpperP, 9));
    let (it6, it7) = (widths(6), widths(7));
    let power = |factor: f64, exponent: f64| move |mean: f64, _: usize| factor * mean.powf(exponent);
    assert_eq!(differences(&e, power(11.0, 0.41)), [(5, 1.0), (9, 1.0), (11, 5.0)]);
    assert_eq!(differences(&f, power(5.5, 0.41)), [(0, -1.0), (9, 1.0), (10, 1.0), (11, 1.0), (12, 1.0)]);
    assert_eq!(differences(&g, power(2.5, 0.34)), [(0, -1.0)]);
    // From the grades: IT7 less IT6, and IT7 with none to five more.
    assert_eq!(differences(&m, |_, k| it7[k] - it6[k]), [(0, -2.0)]);
    for k in 1..13 {
        assert!((0.0..=5.0).contains(&(p[k] - it7[k])), "{k}");
    }
}

#[test]
fn limits_are_those_that_tables_of_fits_print() {
    use ToleranceLetter::{LowerF, LowerG, LowerH, LowerM, UpperH, UpperJs, UpperP};
    // Size, then lower and upper limit in micrometres, as printed in tables of preferred fits.
    for (letter, grade, size, lower, upper) in [
        (UpperH, 7, 10.0, 0.0, 15.0),
        (UpperH, 8, 40.0, 0.0, 39.0),
        (LowerH, 6, 8.0, -9.0, 0.0),
        (LowerM, 6, 10.0, 6.0, 15.0),
        (LowerM, 6, 3.0, 2.0, 8.0),
        (LowerG, 6, 25.0, -20.0, -7.0),
        (LowerF, 7, 60.0, -60.0, -30.0),
        (UpperJs, 9, 8.0, -18.0, 18.0),
        (UpperJs, 9, 3.0, -12.0, 12.0),
        (UpperJs, 9, 3.0 + 1e-12, -12.0, 12.0),
        (UpperJs, 5, 2.0, -2.0, 2.0),
        (UpperP, 9, 8.0, -51.0, -15.0),
        (UpperP, 7, 10.0, -24.0, -9.0),
        (UpperP, 7, 3.0, -16.0, -6.0),
        (UpperP, 7, 100.0, -59.0, -24.0),
    ] {
        let [below, above] = ToleranceClass { letter, grade }.limits(size).expect("a size of the standard");
        assert!(
            (below * 1000.0 - lower).abs() < 1e-9 && (above * 1000.0 - upper).abs() < 1e-9,
            "{letter:?}{grade} {size}"
        );
    }
}

#[test]
fn beyond_the_tables_there_are_no_limits() {
    let class = |grade| ToleranceClass { letter: ToleranceLetter::UpperH, grade };
    for size in [0.0, -1.0, 500.1, f64::NAN, f64::INFINITY] {
        assert_eq!(class(8).limits(size), None);
    }
    for grade in [0, 4, 12] {
        assert_eq!(class(grade).limits(10.0), None);
    }
}
