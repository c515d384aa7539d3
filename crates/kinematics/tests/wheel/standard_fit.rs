//! Are the fits those of the standard's table?

use geneva_kinematics::wheel::{play_of_h8_e8, play_of_h8_e8_at};

#[test]
fn the_fits_are_those_of_the_standards_table() {
    let ranges = [(3.0, 6.0), (6.0, 10.0), (10.0, 18.0), (18.0, 30.0)].map(|(over, up_to)| play_of_h8_e8(over, up_to));
    assert_eq!(ranges, [[0.02, 0.056], [0.025, 0.069], [0.032, 0.086], [0.04, 0.106]]);
}

/// Each range up to and with its end, and what is the standard's own rounding at 30 to 50 mm.
#[test]
fn every_diameter_has_the_fit_of_its_range() {
    for (diameter, least, most) in [
        (0.4, 0.014, 0.042),
        (3.0, 0.014, 0.042),
        (3.01, 0.02, 0.056),
        (18.0, 0.032, 0.086),
        (18.01, 0.04, 0.106),
        (31.0, 0.05 - 0.001, 0.128 - 0.001),
        (80.0, 0.06, 0.152),
        (120.0, 0.072, 0.18),
    ] {
        let found = play_of_h8_e8_at(diameter).expect("a range");
        approx::assert_abs_diff_eq!(found[..], [least, most][..], epsilon = 1e-12);
    }
    assert!([0.0, -1.0, 120.01, f64::NAN].into_iter().all(|diameter| play_of_h8_e8_at(diameter).is_none()));
}
