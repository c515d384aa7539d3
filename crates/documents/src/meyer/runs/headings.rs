//! The moments of inertia above the tables and on the axes of Figs. 10 and 11.
//!
//! Inertias are data. Here they are found from all results of a table, without being known: see [`data`].

use super::data;
use super::table::{UNIT, drawn, headed, heading_id, rows, units_in_one};
use crate::MEYER;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use crate::meyer::at;
use crate::meyer::slips::{RESET_ANGLE, SWAPPED_INERTIAS};
use geneva_case1973::witness::steps::cycle_of_row;
use geneva_case1973::{Column, Hypothesis, Row};
use geneva_evidence::{Claim, Finding, Locator, Stated, intern};
use geneva_kinematics::Mechanism;

/// The members, in the order of the headings.
const MEMBERS: [&str; 2] = ["driver", "follower"];

/// The claims of a table's heading.
pub(crate) fn claims(mechanism: Mechanism) -> Vec<Claim> {
    let numbers = headed(mechanism);
    let place = at(intern(format!("Appendix E, heading of the {}-pin mechanism", mechanism.pins())));
    let of = |member: usize| inertia(place, intern(heading_id(mechanism, MEMBERS[member])), numbers, mechanism, member);
    let [driver, follower] = [0, 1].map(of);
    match mechanism {
        Mechanism::SIX_PIN => {
            vec![driver.corrected(numbers[1], SWAPPED_INERTIAS), follower.corrected(numbers[0], SWAPPED_INERTIAS)]
        }
        _ => vec![driver, follower],
    }
}

/// The inertia of a member, of the pair with which the table comes out best.
fn inertia(place: Locator, id: &'static str, numbers: [&'static str; 2], mechanism: Mechanism, member: usize) -> Claim {
    let meaning = intern(format!("moment of inertia of the {} in the runs, a given value", MEMBERS[member]));
    place
        .value(id, numbers[member], UNIT, meaning)
        .first_route(QUADRATURE, move || data::inertias(mechanism)[member] * units_in_one(UNIT))
        .second_route(RUNGE_KUTTA, move || data::inertias_in_steps(mechanism)[member] * units_in_one(UNIT))
        .interpreted_as(
            "The computed value belongs to the pair of inertias that best reproduces all peaks, minima and periods in \
             the table.",
        )
}

/// What the headings say the tables are of.
pub(crate) fn of_headings() -> Claim {
    at("Appendix E, headings of the six-pin and the three-pin mechanism")
        .statement(
            "meyer.app-e.mechanisms",
            "Six Pin Mechanism",
            "the tables for six and three pins describe the mechanisms named above them",
        )
        .first_route(QUADRATURE, |stated| {
            counted(&hypothesis(stated), "minima", 1.0, |of, row| {
                Some(of.engagement(row)?.steady_state().ok()?.minimum.speed - row.number(Column::Minimum))
            })
        })
        .second_route(RUNGE_KUTTA, |stated| {
            counted(&hypothesis(stated), "periods", 1e-3, |of, row| {
                let [_, time, _] = cycle_of_row(of, row)?;
                Some(time - row.number(Column::Period))
            })
        })
        .interpreted_as(
            "The claim is that the runs below this heading are runs of the mechanism that the heading names, and \
             likewise below the heading for three pins.",
        )
        .corrected(
            "Six Pin Mechanism, with the driver's angle reset after 90° (and likewise the Three Pin Mechanism)",
            RESET_ANGLE,
        )
}

/// The mechanism as it is, or as the correction has it: reset after what it gives, which must be the listing's angle.
fn hypothesis(stated: Stated) -> Hypothesis {
    let listed = MEYER.printed_number("meyer.listing.quarter-turn").to_degrees();
    let is_listed = stated.decimals().iter().any(|angle| angle.is_rounding_of(listed));
    if stated.pick(is_listed, false) { Hypothesis::WITHOUT_LAG } else { Hypothesis::IDEAL }
}

/// Whether all rows with six and three pins come out to one unit.
fn counted(of: &Hypothesis, what: &str, unit: f64, off: fn(&Hypothesis, &Row) -> Option<f64>) -> Finding {
    Finding::for_all(
        rows().iter().filter(|row| row.mechanism != Mechanism::FOUR_PIN),
        |row| off(of, row).is_some_and(|off| off.abs() <= unit * (1.0 + 1e-9)),
        |near, all| format!("{near} of {all} {what} agree to one unit"),
    )
}

/// The claims of the axes of Figs. 10 and 11.
pub(crate) fn of_figures() -> Vec<Claim> {
    let of = |mechanism: Mechanism| {
        let (figure, numbers) = drawn(mechanism)?;
        let place = at(intern(format!("Fig. {figure}, upper plot")));
        let ids = MEMBERS.map(|member| intern(format!("meyer.fig-{figure}.{member}")));
        Some([0, 1].map(|member| inertia(place, ids[member], numbers, mechanism, member)))
    };
    [Mechanism::FOUR_PIN, Mechanism::SIX_PIN].into_iter().filter_map(of).flatten().collect()
}
