//! Do a formula and its expression have one value?

use crate::rate;
use geneva_exact::{Expression, Turn, rational};

#[test]
fn nothing_is_lost_by_adding_zero_or_multiplying_by_one() {
    let y = 1 / Expression::variable(0);
    assert_eq!(y + 0, y);
    assert_eq!(1 * y, y);
    assert_eq!(y * Expression::ZERO, Expression::ZERO);
}

#[test]
fn a_formula_and_its_expression_have_one_value() {
    let [ratio, half] = [0, 1].map(Expression::variable);
    let formula = rate(&ratio, &Turn::from_half_tangent(&half));
    let at = [rational(7, 3), rational(-2, 5)];
    let expected = rate(&at[0], &Turn::from_half_tangent(&at[1]));
    assert_eq!(formula.at(&at), expected);
}
