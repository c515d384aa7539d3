//! Do a sign and its number agree?

use geneva_dynamics::Sign;

#[test]
fn a_sign_and_its_number_agree() {
    for number in [-3.0, 2.0, 0.0, -0.0] {
        assert_eq!(Sign::from_number(number).apply(number), f64::abs(number));
    }
    assert_eq!(Sign::Minus.times(Sign::Minus), Sign::Plus);
    assert_eq!(Sign::Minus.times(Sign::Plus), Sign::Minus);
}
