//! Are the bounds on the degrees of an expression as low as they should be?

use geneva_exact::{Expression, Turn};

fn x() -> Expression {
    Expression::variable(0)
}

#[test]
fn fractions_over_one_divisor_keep_it() {
    let Turn { cos, sin } = Turn::from_half_tangent(&x());
    assert_eq!((cos.degrees(1), sin.degrees(1)), (vec![2], vec![1]));
    assert_eq!((cos + sin).degrees(1), [2]);
    assert_eq!((cos * sin + cos).degrees(1), [4]);
    // Over another divisor both numerators are raised.
    assert_eq!((cos + 1 / x()).degrees(1), [3]);
}

#[test]
fn a_divisor_that_is_multiplied_by_cancels() {
    let divisor = x() * x() + 1;
    assert_eq!((x() / divisor * divisor).degrees(1), [1]);
    assert_eq!(((x() / divisor) / (1 / divisor)).degrees(1), [1]);
}

#[test]
fn each_variable_is_counted_by_itself() {
    let y = Expression::variable(1);
    assert_eq!(((x() * x() - y) / (x() * y)).degrees(2), [2, 1]);
    // Nothing of the denominator is forgotten: against its own square it counts.
    assert_eq!((1 / (x() * y) + 1 / (x() * y * y)).degrees(2), [1, 2]);
}
