//! What Appendix B says in number words: the orders of derivatives, the parts of an interval, and when SMT is true.

use super::contact::{SMALL_TIME, in_force, listed};
use super::*;

pub(super) fn claims() -> Vec<Claim> {
    vec![orders(), subintervals(), until_zero()]
}

fn orders() -> Claim {
    at("Appendix B, after the lines of the example")
        .statement(
            "meyer.app-b.example.orders",
            "first and second derivatives",
            "the two names of the example stand for its first and its second derivative, in this order",
        )
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let right = MEYER.lookup("meyer.app-b.example.names").right_characters();
            let digits: Vec<f64> = numeric_tokens(right).iter().filter_map(|digits| digits.parse().ok()).collect();
            Finding::new(
                !digits.is_empty() && digits == in_order(stated),
                "the names begin with the orders of the derivatives that they stand for",
            )
        })
        .second_route(Evidence::LIMIT_CASE, |stated| {
            let integrals = ["meyer.app-b.example.place", "meyer.app-b.example.first"].map(integral);
            let [Some((place, first)), Some((integrated, second))] = integrals else {
                return Finding::not_evaluated("a line of the example integrates nothing");
            };
            let chained = place == "X" && first == integrated && second != first;
            Finding::new(
                chained && in_order(stated) == [1.0, 2.0],
                format!("the position is one integral of {first} and two of {second}"),
            )
        })
        .but_not("they stand for the second and the first")
}

/// The two orders that are said, or these in the reverse order.
fn in_order(stated: Stated) -> Vec<f64> {
    let said = stated.numbers();
    stated.pick(said.clone(), said.into_iter().rev().collect())
}

/// What a line of the example integrates, and the name of the integral: the integral first.
fn integral(id: &str) -> Option<(&'static str, &'static str)> {
    let (name, behind) = MEYER.lookup(id).right_characters().split_once(" = INT(")?;
    Some((name, behind.split_once(',')?.0))
}

fn subintervals() -> Claim {
    at("Appendix B, paragraph on the subintervals")
        .statement(
            "meyer.app-b.method.four",
            "four subintervals",
            "an interval is divided into four parts, one for each slope",
        )
        .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let widths = MEYER.printed_integers("meyer.app-b.method.widths");
            let whole: f64 = widths.iter().map(|part| 1.0 / f64::from(*part)).sum();
            Finding::new(
                widths.len() == stated.pick(stated.count() as usize, 3) && agrees(whole, 1.0),
                format!("{} widths are printed, which together make {whole:.0} interval", widths.len()),
            )
        })
        .second_route(Evidence::CLOSED_FORM, |stated| {
            let slopes = reading::letters_in(MEYER.right_side("meyer.app-b.method.step"));
            let slopes = slopes.iter().filter(|letter| letter.starts_with("f_")).count();
            Finding::new(
                slopes == stated.pick(stated.count() as usize, 3),
                format!("the formula of a step has {slopes} slopes"),
            )
        })
        .but_not("it is divided into three")
}

fn until_zero() -> Claim {
    at("Appendix B, paragraphs before the program")
        .statement(
            "meyer.app-b.until-zero",
            "less than or equal to zero, and false when T is greater than zero",
            "SMT is true up to the time zero, and false after it",
        )
        .first_route(crate::evidence::PROGRAM, |stated| {
            let lines = in_force(SMALL_TIME, "NOT(REST)").unwrap_or_default();
            let holds =
                !lines.is_empty() && lines.iter().all(|[time, rest, _]| is_true(stated, *time) == Some(*rest == 1.0));
            Finding::new(holds, "at each line of a run, we printed whether the deck's start expression is true")
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let said = [-1.0, 0.0, 1.0].map(|time| is_true(stated, time));
            Finding::new(
                listed().any(|truths| truths.map(Some) == said),
                "we compared the listing's values before, at and after the time zero",
            )
        })
        .but_not("it is false at the time zero")
}

/// Whether SMT is true at a time, by both halves of what is said; nothing if they contradict each other.
fn is_true(stated: Stated, time: f64) -> Option<bool> {
    let [up_to, after] = stated.numbers()[..] else { return None };
    let is_true = stated.pick(time <= up_to, time < up_to);
    (stated.pick(time > after, time >= after) != is_true).then_some(is_true)
}
