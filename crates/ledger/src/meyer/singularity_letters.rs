//! What the letters stand for where a denominator of the equation of motion would be zero, exactly.
//!
//! The displays are conditions, so they hold nowhere else. The sides of each are as far apart, but for a factor that is not
//! zero, as something that the mechanism's places tell is from zero: the pin from the follower's axis, or the ratio from one.

use super::hand_over_letters::RATIO;
use super::reading::Moment;
use super::*;
use crate::triangle::angle;
use geneva_kinematics::Expression;
use std::array::from_fn;

/// Letters, the factor, and what vanishes.
pub type Condition = (Moment<Expression>, Expression, Expression);

/// The pin is on the follower's axis. Variables: a, tangent of θ/2.
pub fn on_the_axis() -> Condition {
    let (letters, _, square) = pin();
    (letters, Expression::ONE, square)
}

/// The condition for the cosine alone.
pub fn on_the_axis_by_cosine() -> Condition {
    let (letters, ratio, square) = pin();
    (letters, -2 * ratio, square)
}

/// The letters, the ratio, and the square of the pin's distance from the follower's axis.
fn pin() -> (Moment<Expression>, Expression, Expression) {
    let [ratio, half] = from_fn(Expression::variable);
    let crank = Turn::from_half_tangent(&half);
    let letters = Moment::default().with([("a", ratio)]).with_angles([(r"\theta_\infty", angle(&crank))]);
    (letters, ratio, square_of_distance(ratio, &crank))
}

fn square_of_distance(ratio: Expression, crank: &Turn<Expression>) -> Expression {
    let place = crank.direction() - Vector2::new(ratio, Expression::ZERO);
    place.x * place.x + place.y * place.y
}

/// The pin is on the follower's axis where it is nearest to it, on the line of centres. A square is at most zero only where it
/// is zero. Variable: a.
pub fn nearest_on_the_axis() -> Condition {
    let ratio = Expression::variable(0);
    let nearest = Turn { cos: Expression::ONE, sin: Expression::ZERO };
    (Moment::default().with([("a", ratio)]), Expression::ONE, square_of_distance(ratio, &nearest))
}

/// The condition over 2a, which is positive.
pub fn nearest_on_the_axis_by_cosine() -> Condition {
    let (letters, _, square) = nearest_on_the_axis();
    let twice = 2 * letters.letters()["a"];
    (letters, twice, square)
}

/// The ratio is one. Variables as in [`RATIO`].
pub fn ratio_of_one() -> Condition {
    let letters = (RATIO.exact)(1);
    let ratio = letters.letters()["a"];
    (letters, Expression::ONE, ratio - 1)
}

/// The condition for the sine.
pub fn ratio_of_one_by_sine() -> Condition {
    let (letters, _, vanishing) = ratio_of_one();
    let ratio = letters.letters()["a"];
    (letters, -ratio, vanishing)
}
