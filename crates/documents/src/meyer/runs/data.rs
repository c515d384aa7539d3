//! The claims of the data of the runs: friction, torque and inertias, found from what is printed of the results.
//!
//! The first route is `fitted` of `geneva-case1973`, the second its witness `gauss_newton`, over the motion in steps.

use super::cache::cached_result;
use super::table::{expected, heading_id, rows};
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::witness::gauss_newton;
use geneva_case1973::{Column, Hypothesis, Row, fitted, rows_of};
use geneva_evidence::{Claim, Locator, Verdict, intern};
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

/// The claims of a row's friction and torque.
pub(super) fn claims(row: &'static Row, place: Locator) -> [Claim; 2] {
    let id = |name: &str| intern(format!("meyer.app-e.{}.{name}", row.slug()));
    let expected = |column| expected(row, column).unwrap_or(Verdict::Reproduced);
    let friction = place
        .value(id("friction"), row.printed(Column::Friction), "", "coefficient of friction of the run, a given value")
        .first_route(QUADRATURE, move || sections(row)[0])
        .second_route(RUNGE_KUTTA, move || tangents(row)[0])
        .with_resolution(move || tangents(row)[1])
        .interpreted_as(FRICTION)
        .expecting(expected(Column::Friction));
    let torque = place
        .value(id("torque"), row.printed(Column::Torque), "in lb/rad", "torque of the spring of the run, a given value")
        .first_route(QUADRATURE, move || sections(row)[1])
        .second_route(RUNGE_KUTTA, move || tangents(row)[2])
        .interpreted_as(TORQUE)
        .expecting(expected(Column::Torque));
    [friction, torque]
}

const FRICTION: &str = "The computed value is the friction that best reproduces the row's minimum and period, with the \
                        printed torque, the inertias as run, and the reset after 90° as in the program. We leave out \
                        the peak, because none of the printed lines need fall on it. The friction is known only as \
                        finely as minimum and period determine it, if each was misread at random by a unit of its last \
                        place.";

const TORQUE: &str = "The computed value is the torque that best reproduces the row's minimum and period, with the printed \
                      friction, the inertias as run, and the reset after 90° as in the program. We leave out the peak, \
                      because none of the printed lines need fall on it.";

/// Friction and torque of a row by golden section.
fn sections(row: &Row) -> [f64; 2] {
    static FOUND: OnceLock<Vec<[f64; 2]>> = OnceLock::new();
    cached_result(&FOUND, row, |row| Some([fitted::friction(row)?, fitted::torque(row)?]))
}

/// Friction, how finely it is known, and torque of a row by Gauss and Newton.
fn tangents(row: &Row) -> [f64; 3] {
    static FOUND: OnceLock<Vec<[f64; 3]>> = OnceLock::new();
    cached_result(&FOUND, row, |row| {
        let friction = gauss_newton::friction(row)?;
        Some([friction.value, friction.reach, gauss_newton::torque(row)?.value])
    })
}

/// The inertias of driver and follower, in in lb s², with which a mechanism's table is reproduced best, by integrals.
pub fn inertias(mechanism: Mechanism) -> [f64; 2] {
    static FOUND: [OnceLock<[f64; 2]>; 3] = [const { OnceLock::new() }; 3];
    found(&FOUND, mechanism, |table, reset| fitted::inertias(table, reset, 1.0))
}

/// The inertias with which a mechanism's table is reproduced best, in steps.
pub(super) fn inertias_in_steps(mechanism: Mechanism) -> [f64; 2] {
    static FOUND: [OnceLock<[f64; 2]>; 3] = [const { OnceLock::new() }; 3];
    found(&FOUND, mechanism, |table, reset| Some(gauss_newton::inertias(table, reset)?.0))
}

/// The inertias of a mechanism's table, reset as the program has it, found once; not numbers if they have no motion.
fn found(
    kept: &'static [OnceLock<[f64; 2]>; 3],
    mechanism: Mechanism,
    of: fn(&[Row], f64) -> Option<[f64; 2]>,
) -> [f64; 2] {
    let find = || {
        let table = rows_of(rows(), mechanism);
        of(table, Hypothesis::WITHOUT_LAG.angle(table.first()?))
    };
    *kept[mechanism.index()].get_or_init(|| find().unwrap_or([f64::NAN; 2]))
}

/// How finely the inertias are known: how much they change if each result was misread at random by a unit of its last
/// place.
pub fn uncertainties(mechanism: Mechanism) -> Option<[f64; 2]> {
    gauss_newton::uncertainties(rows_of(rows(), mechanism), inertias_in_steps(mechanism))
}

/// The claims of all inputs of the runs, by id: we know them only from the results.
pub fn inputs() -> impl Iterator<Item = String> {
    let of_rows =
        rows().iter().flat_map(|row| ["friction", "torque"].map(|name| format!("meyer.app-e.{}.{name}", row.slug())));
    let inertias = ["driver", "follower"].into_iter().flat_map(|member| {
        let drawn = ["10", "11"].map(|figure| format!("meyer.fig-{figure}.{member}"));
        Mechanism::ALL.map(|mechanism| heading_id(mechanism, member)).into_iter().chain(drawn)
    });
    of_rows.chain(inertias).chain(["meyer.listing.print-interval".to_owned()])
}

#[cfg(test)]
mod tests {
    use super::super::table::{UNIT, units_in_one};
    use super::*;

    /// The row with other characters in a column.
    fn printing(row: &Row, column: Column, text: &str) -> Row {
        let cell = |of: Column| if of == column { text } else { row.printed(of) };
        Row::read(row.mechanism, &Column::ALL.map(cell).join(" "), row.given).expect("a row")
    }

    /// What both routes find for a row: friction and torque.
    fn found(row: &Row) -> [[f64; 2]; 2] {
        let by_sections = [fitted::friction(row), fitted::torque(row)].map(|found| found.expect("found"));
        let by_tangents = [gauss_newton::friction(row), gauss_newton::torque(row)];
        [by_sections, by_tangents.map(|found| found.expect("found").value)]
    }

    #[test]
    fn what_is_found_does_not_depend_on_what_is_printed() {
        for (row, torque) in [(&rows()[0], ".04"), (&rows()[20], ".07"), (&rows()[48], ".15")] {
            let [sections, tangents] = found(row);
            for (at, column, other) in [(0, Column::Friction, ".33"), (1, Column::Torque, torque)] {
                let [otherwise, again] = found(&printing(row, column, other));
                assert_eq!([otherwise[at], again[at]], [sections[at], tangents[at]], "{column:?}");
                // The other of the two is found with it.
                assert!((otherwise[1 - at] / sections[1 - at] - 1.0).abs() > 0.01, "{column:?}");
            }
        }
    }

    #[test]
    fn the_inputs_are_all_the_given_values_of_the_runs() {
        let mut listed: Vec<String> = inputs().collect();
        let given = crate::MEYER.claims().iter().filter(|claim| claim.meaning.contains("a given value"));
        let mut given: Vec<String> = given.map(|claim| claim.id.to_owned()).collect();
        listed.sort();
        given.sort();
        assert_eq!(listed, given);
    }

    #[test]
    fn what_is_found_depends_on_the_results() {
        let row = &rows()[20];
        let [[friction, torque], _] = found(row);
        let [slower, in_steps] = found(&printing(row, Column::Minimum, "14"));
        assert!(slower[0] > friction + 0.005 && in_steps[0] > friction + 0.005, "{slower:?}");
        assert_eq!(found(&printing(row, Column::Peak, "130"))[0], [friction, torque]);
        let [shorter, in_steps] = found(&printing(row, Column::Period, ".040"));
        assert!(shorter[1] > torque + 0.005 && in_steps[1] > torque + 0.005, "{shorter:?}");
    }

    #[test]
    fn the_printed_inertias_are_those_that_are_found() {
        let millionths = units_in_one(UNIT);
        for mechanism in Mechanism::ALL {
            let in_steps = inertias_in_steps(mechanism);
            let as_drawn = Hypothesis::WITHOUT_LAG.inertias(&rows_of(rows(), mechanism)[0]);
            for (found, printed) in in_steps.iter().zip(as_drawn) {
                assert!((found - printed).abs() * millionths < 0.5, "{in_steps:?}");
            }
            let known_to = uncertainties(mechanism).expect("a table with slopes");
            // So the last digit is decided, and none of the other's.
            assert!(known_to.iter().all(|to| (0.02..0.5).contains(&(to * millionths))), "{known_to:?}");
        }
    }
}
