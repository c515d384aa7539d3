//! Do numbers with square roots multiply and divide exactly?

use geneva_exact::{Field, Rational, Surd, rational};
use num_traits::One;

type WithTwo = Surd<Rational, 2>;
type WithTwoAndThree = Surd<WithTwo, 3>;

#[test]
fn roots_multiply_and_divide_exactly() {
    let two = WithTwoAndThree::from_plain(WithTwo::root());
    let three = WithTwoAndThree::root();
    let six = two.clone() * three.clone();
    assert_eq!(six.clone() * six.clone(), WithTwoAndThree::integer(6));
    assert_eq!(six.clone() / three, two);
    let odd = six + WithTwoAndThree::integer(1);
    assert_eq!(odd.clone() / odd.clone(), WithTwoAndThree::one());
    approx::assert_relative_eq!(odd.approximate(), 1.0 + 6f64.sqrt(), max_relative = 1e-15);
}

#[test]
fn one_over_a_root_is_rationalised() {
    let inverse = WithTwo::one() / WithTwo::root();
    assert_eq!(inverse, WithTwo { plain: rational(0, 1), rooted: rational(1, 2) });
}
