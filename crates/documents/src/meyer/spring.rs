//! Is K a rate of the spring? Some places call the torque a rate, which it is not, and some a constant.

use super::newton::Newton;
use super::runs::table::rows;
use super::slips::SPRING_RATE;
use super::*;
use crate::evidence::RUNGE_KUTTA;
use geneva_case1973::{Column, Hypothesis, Row};
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

/// A place that calls K a rate, to be multiplied by an angle. It is the torque.
pub(super) fn no_rate(
    id: &'static str,
    place: Locator,
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    place
        .statement(id, printed, meaning)
        .first_route(RUNGE_KUTTA, gives_the_periods)
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, in_the_equation)
        .corrected(corrected, SPRING_RATE)
}

/// A place that calls K a constant of the spring. Kindly read, it is the torque that this spring has at any angle.
pub(super) fn constant(id: &'static str, place: Locator, meaning: &'static str, printed: &'static str) -> Claim {
    place
        .statement(id, printed, meaning)
        .first_route(RUNGE_KUTTA, gives_the_periods)
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, in_the_equation)
        .but_not(RATE)
        .interpreted_as(
            "If the torque of a spring is constant, the spring's constant is that torque. (For other springs, the \
             constant is a torque for each radian of winding, which is what the word “rate” elsewhere says of this \
             spring.)",
        )
}

/// What K is not.
const RATE: &str = "a rate, so that the torque is K times the angle turned";

/// A place that has K in inch-pounds per radian, and no word for it: a torque may be so measured.
pub(super) fn torque_per_radian(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
) -> Claim {
    at(locator)
        .statement(id, printed, meaning)
        .first_route(RUNGE_KUTTA, gives_the_periods)
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, in_the_equation)
        .but_not(RATE)
        .interpreted_as("An inch-pound per radian is a unit of torque, as a joule per radian is.")
}

/// Whether the four-pin runs, driven from rest with the torque K or with K times the angle turned, come to the periods
/// that are printed for them.
fn gives_the_periods(stated: Stated) -> Finding {
    static BOTH: OnceLock<[(usize, usize); 2]> = OnceLock::new();
    let both = BOTH.get_or_init(|| {
        [false, true].map(|is_rate| {
            let own = || rows().iter().filter(|row| row.mechanism == Mechanism::FOUR_PIN);
            (own().filter(|row| has_its_period(row, is_rate).unwrap_or(false)).count(), own().count())
        })
    });
    let (near, all) = stated.pick(both[0], both[1]);
    Finding::new(
        near == all,
        format!(
            "if the torque is {}, {near} of {all} runs with four pins have their printed period after {ENGAGEMENTS} \
             engagements",
            stated.pick("K", "K times the angle turned")
        ),
    )
}

const ENGAGEMENTS: u32 = 20;

/// Whether the last engagement takes the printed time, to a unit of its last place, if the torque is K, or K times
/// the angle that the driver has turned.
fn has_its_period(row: &Row, is_rate: bool) -> Option<bool> {
    const STEPS: u32 = 300;
    let at = Hypothesis::IDEAL.parameters(row)?;
    let (half, inertias) = (at.mechanism().engagement_half_angle(), at.inertias());
    let pair = Newton {
        radius: 1.0,
        distance: at.mechanism().centre_distance_ratio(),
        friction: at.friction(),
        driver: inertias.driver(),
        follower: inertias.follower(),
    };
    let engagements = pair.engagements(half, STEPS);
    let mut last = None;
    for engagement in 0..ENGAGEMENTS {
        let before = 2.0 * half * f64::from(engagement);
        let torque = |turned: f64| at.torque() * if is_rate { before + turned } else { 1.0 };
        let entry = last.map_or(0.0, |passage: newton::Passage| passage.end);
        last = Some(engagements.passage(entry, &torque)?);
    }
    Some((last?.duration - row.number(Column::Period)).abs() <= 1e-3)
}

/// What Eq. (1-15) sets equal to the torque of the spring, with K for the torque or for a rate.
fn in_the_equation(stated: Stated) -> Finding {
    const TORQUE: f64 = 1.25;
    let right = MEYER.right_side("meyer.eq-1-15");
    let gives_it = |turned: f64| {
        let letters = [("K".to_owned(), TORQUE / stated.pick(1.0, turned)), ("theta".to_owned(), turned)].into();
        agrees(reading::value(right, &letters), TORQUE)
    };
    let what = stated.pick("a torque", "a torque per unit of angle");
    // Not one radian, at which the two are one.
    Finding::for_all([0.5, 2.0, 4.0], gives_it, |found, all| {
        format!("if K is {what}, Eq. (1-15) gives the right torque at {found} of {all} angles")
    })
}
