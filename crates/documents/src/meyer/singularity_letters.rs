//! What the letters stand for where a denominator of the equation of motion would be zero: exactly and by numbers.
//!
//! The displays are conditions, so they hold nowhere else. Exactly, the sides of each are as far apart, but for a factor that is
//! not zero, as the pin is from the follower's axis, or the ratio from one. By numbers, ratios, angles and slots are tried.

use super::hand_over_letters::RATIO;
use super::reading::Moment;
use super::*;
use crate::triangle::angle;
use geneva_kinematics::Expression;
use nalgebra::Complex;
use std::array::from_fn;

/// Letters, the factor, and what vanishes.
pub(super) type Condition = (Moment<Expression>, Expression, Expression);

/// The pin is on the follower's axis. Variables: a, tangent of θ/2.
pub(super) fn on_the_axis() -> Condition {
    let (letters, _, square) = pin();
    (letters, Expression::ONE, square)
}

/// The condition for the cosine alone.
pub(super) fn on_the_axis_by_cosine() -> Condition {
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
pub(super) fn nearest_on_the_axis() -> Condition {
    let ratio = Expression::variable(0);
    let nearest = Turn { cos: Expression::ONE, sin: Expression::ZERO };
    (Moment::default().with([("a", ratio)]), Expression::ONE, square_of_distance(ratio, &nearest))
}

/// The condition over 2a, which is positive.
pub(super) fn nearest_on_the_axis_by_cosine() -> Condition {
    let (letters, _, square) = nearest_on_the_axis();
    let twice = 2 * letters.letters()["a"];
    (letters, twice, square)
}

/// The ratio is one. Variables as in [`RATIO`].
pub(super) fn ratio_of_one() -> Condition {
    let letters = (RATIO.exact)(1);
    let ratio = letters.letters()["a"];
    (letters, Expression::ONE, ratio - 1)
}

/// The condition for the sine.
pub(super) fn ratio_of_one_by_sine() -> Condition {
    let (letters, _, vanishing) = ratio_of_one();
    let ratio = letters.letters()["a"];
    (letters, -ratio, vanishing)
}

/// An inequality as an equation of the lesser side and the greater one, in this order; none if it is no inequality.
pub(super) fn at_most(tex: &str) -> Option<String> {
    let lesser_first = tex.split_once(r"\leq");
    let [lesser, greater] = match tex.split_once(r"\geq") {
        Some((greater, lesser)) => [lesser, greater],
        None => lesser_first?.into(),
    };
    Some(format!("{lesser} = {greater}"))
}

/// Ratios of the axes' distance to the pins' radius, from 1/16 to 5.
pub(super) fn ratios() -> impl Iterator<Item = f64> {
    (1..=80).map(|k| f64::from(k) / 16.0)
}

/// Whether an inequality allows a ratio; none if it cannot be read.
pub(super) fn allows(inequality: &str, ratio: f64) -> Option<bool> {
    let letters = reading::by_name([("a", ratio)]);
    let sides = |relation: &str| {
        let (left, right) = inequality.split_once(relation)?;
        let values = [left, right].map(|side| reading::value(side, &letters));
        values.iter().all(|value| value.is_finite()).then_some(values)
    };
    match (sides(r"\leq"), sides(r"\geq")) {
        (Some([left, right]), _) => Some(left <= right),
        (_, Some([left, right])) => Some(left >= right),
        _ => None,
    }
}

/// Whether an inequality allows the ratio one and no other.
pub(super) fn only_for_one(inequality: &str) -> Option<bool> {
    let allowed: Vec<bool> = ratios().map(|ratio| allows(inequality, ratio)).collect::<Option<_>>()?;
    Some(ratios().zip(allowed).all(|(ratio, allowed)| allowed == (ratio == 1.0)))
}

/// Whether a display of θ_∞ holds. The cosine of that angle is greater than one unless a = 1, so it is imaginary.
pub(super) fn with_imaginary_angles(tex: &str) -> Option<bool> {
    let moments = [1.0, 1.25, 1.5, 2.0, 3.5].map(|ratio: f64| {
        // cosh(ln a) = (a + 1/a)/2.
        let letters = [("a", Complex::new(ratio, 0.0)), (r"\theta_\infty", Complex::new(0.0, libm::log(ratio)))];
        Moment::default().with(letters)
    });
    reading::holds(tex, &moments)
}

/// For which numbers of slots, of 1 to 100, a display holds if the ratio is one; none if it cannot be read.
pub(super) fn slots_that_satisfy(display: &str) -> Option<Vec<u32>> {
    let holds = |slots: u32| reading::holds(display, &[Moment::default().with([("a", 1.0), ("n", f64::from(slots))])]);
    let found: Vec<(u32, bool)> = (1..=100).map(|slots| Some((slots, holds(slots)?))).collect::<Option<_>>()?;
    Some(found.into_iter().filter(|(_, holds)| *holds).map(|(slots, _)| slots).collect())
}

/// Whether a display holds for two slots and for no other number, if the ratio is one.
pub(super) fn only_for_two(display: &str) -> Option<bool> {
    slots_that_satisfy(display).map(|found| found == [2])
}
