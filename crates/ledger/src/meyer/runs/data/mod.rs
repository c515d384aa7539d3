//! The data of the runs, found from what is printed of their results.
//!
//! Friction, torque and inertias are data: no run gives them. But the results depend on them, and so they can be found
//! from the results without being known:
//!
//! - a row's torque, from its minimum and its period, with its friction and the inertias as printed;
//! - a row's friction, from its minimum and its period, with its torque and the inertias as printed;
//! - the two inertias of a mechanism, from all peaks, minima and periods of its table, with its frictions and torques.
//!
//! What is found is where the sum of the squares of the misfits, in units of the last printed place, is least. Both
//! routes look for it over all that can be: by golden section over the solution by integrals (`golden_section`), and by
//! the method of Gauss and Newton over the motion in steps (`gauss_newton`). Both take the steady motion with the
//! inertias of Fig. 11 for six pins, reset after 90°, as the program has it.
//!
//! `freed` asks the opposite: what the right reset angle could explain, whatever the inertias were.

pub mod freed;
mod gauss_newton;
mod golden_section;

use super::cells::{among, leaked};
use super::*;
use crate::Evidence::{Quadrature, RungeKutta};
use std::sync::OnceLock;

/// The results from which a mechanism's inertias are found.
const RESULTS: &[Column] = &[Column::Peak, Column::Minimum, Column::Period];

/// The results from which a row's torque and friction are found: no printed line need fall on a peak.
const BUT_FOR_THE_PEAK: &[Column] = &[Column::Minimum, Column::Period];

/// The claims of a row's friction and torque.
pub(super) fn claims(row: &'static Row, place: Place) -> [Claim; 2] {
    let id = |name: &str| leaked(format!("meyer.app-e.{}.{name}", row.slug()));
    let expected = |column| row.expected(column).unwrap_or(Verdict::Reproduced);
    let friction = place
        .value(id("friction"), row.printed(Column::Friction), "", "coefficient of friction of the run, a given value")
        .by(Quadrature, move || sections(row)[0])
        .by(RungeKutta, move || tangents(row)[0])
        .read_to(move || tangents(row)[1])
        .read_as(FRICTION)
        .expecting(expected(Column::Friction));
    let torque = place
        .value(id("torque"), row.printed(Column::Torque), "in lb/rad", "torque of the spring of the run, a given value")
        .by(Quadrature, move || sections(row)[1])
        .by(RungeKutta, move || tangents(row)[2])
        .read_as(TORQUE)
        .expecting(expected(Column::Torque));
    [friction, torque]
}

const FRICTION: &str = "The computed value is the friction with which the row's minimum and period agree best, with \
                        its torque and the inertias as printed. We leave out the peak, because none of the printed \
                        lines need fall on it. The friction is known as finely as minimum and period tell it, if each \
                        was misread at random by a unit of its last place.";

const TORQUE: &str = "The computed value is the torque with which the row's minimum and period agree best, with its \
                      friction and the inertias as printed. We leave out the peak, because none of the printed lines \
                      need fall on it.";

/// Friction and torque of a row by golden section.
fn sections(row: &Row) -> [f64; 2] {
    static FOUND: OnceLock<Vec<[f64; 2]>> = OnceLock::new();
    among(&FOUND, row, |row| Some([golden_section::friction(row)?, golden_section::torque(row)?]))
}

/// Friction, how finely it is known, and torque of a row by Gauss and Newton.
fn tangents(row: &Row) -> [f64; 3] {
    static FOUND: OnceLock<Vec<[f64; 3]>> = OnceLock::new();
    among(&FOUND, row, |row| {
        let friction = gauss_newton::friction(row)?;
        Some([friction.value, friction.reach, gauss_newton::torque(row)?.value])
    })
}

/// The inertias of driver and follower, in in lb s², with which a mechanism's table is reproduced best, by integrals.
pub fn inertias(mechanism: Mechanism) -> [f64; 2] {
    static FOUND: [OnceLock<[f64; 2]>; 3] = [const { OnceLock::new() }; 3];
    *FOUND[mechanism.index()]
        .get_or_init(|| golden_section::inertias(mechanism, reset(mechanism), 1.0).unwrap_or([f64::NAN; 2]))
}

/// The inertias with which a mechanism's table is reproduced best, in steps.
pub(super) fn inertias_in_steps(mechanism: Mechanism) -> [f64; 2] {
    static FOUND: [OnceLock<[f64; 2]>; 3] = [const { OnceLock::new() }; 3];
    let found = || gauss_newton::inertias(mechanism, reset(mechanism)).map_or([f64::NAN; 2], |(inertias, _)| inertias);
    *FOUND[mechanism.index()].get_or_init(found)
}

/// How finely the inertias are known: how much they change if each result was misread at random by a unit of its last
/// place.
pub fn uncertainties(mechanism: Mechanism) -> Option<[f64; 2]> {
    gauss_newton::uncertainties(mechanism, inertias_in_steps(mechanism))
}

/// The claims of all inputs of the runs, by id: we know them only from the results.
pub fn inputs() -> impl Iterator<Item = String> {
    let of_rows =
        rows().iter().flat_map(|row| ["friction", "torque"].map(|name| format!("meyer.app-e.{}.{name}", row.slug())));
    let inertias = ["driver", "follower"].into_iter().flat_map(|member| {
        let drawn = ["10", "11"].map(|figure| format!("meyer.fig-{figure}.{member}"));
        Mechanism::ALL.map(|mechanism| motion::heading(mechanism, member)).into_iter().chain(drawn)
    });
    of_rows.chain(inertias).chain(["meyer.listing.print-interval".to_owned()])
}

/// By how many units of its last place a computed result is off.
fn misfit(row: &Row, column: Column, computed: f64) -> f64 {
    (computed - row.number(column)) / column.unit()
}

/// After which angle the driver's angle is reset.
fn reset(mechanism: Mechanism) -> f64 {
    Hypothesis::WITHOUT_LAG.angle(mechanism)
}

/// The printed inertias of driver and follower, in in lb s².
fn printed_inertias(row: &Row) -> [f64; 2] {
    Hypothesis::WITHOUT_LAG.inertias(row.mechanism)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What both routes find for a row: friction and torque.
    fn found(row: &Row) -> [[f64; 2]; 2] {
        let by_sections =
            [golden_section::friction(row), golden_section::torque(row)].map(|found| found.expect("found"));
        let by_tangents = [gauss_newton::friction(row), gauss_newton::torque(row)];
        [by_sections, by_tangents.map(|found| found.expect("found").value)]
    }

    #[test]
    fn what_is_found_does_not_depend_on_what_is_printed() {
        for (row, torque) in [(&rows()[0], ".04"), (&rows()[20], ".07"), (&rows()[48], ".15")] {
            let [sections, tangents] = found(row);
            for (at, column, other) in [(0, Column::Friction, ".33"), (1, Column::Torque, torque)] {
                let [otherwise, again] = found(&row.printing(column, other));
                assert_eq!([otherwise[at], again[at]], [sections[at], tangents[at]], "{column:?}");
                // The other of the two is found with it.
                assert!((otherwise[1 - at] / sections[1 - at] - 1.0).abs() > 0.01, "{column:?}");
            }
        }
    }

    #[test]
    fn the_inputs_are_all_the_given_values_of_the_runs() {
        let mut listed: Vec<String> = inputs().collect();
        let given = crate::claims().iter().filter(|claim| claim.meaning.contains("a given value"));
        let mut given: Vec<String> = given.map(|claim| claim.id.to_owned()).collect();
        listed.sort();
        given.sort();
        assert_eq!(listed, given);
    }

    #[test]
    fn what_is_found_depends_on_the_results() {
        let row = &rows()[20];
        let [[friction, torque], _] = found(row);
        let [slower, in_steps] = found(&row.printing(Column::Minimum, "14"));
        assert!(slower[0] > friction + 0.005 && in_steps[0] > friction + 0.005, "{slower:?}");
        assert_eq!(found(&row.printing(Column::Peak, "130"))[0], [friction, torque]);
        let [shorter, in_steps] = found(&row.printing(Column::Period, ".040"));
        assert!(shorter[1] > torque + 0.005 && in_steps[1] > torque + 0.005, "{shorter:?}");
    }

    #[test]
    fn the_printed_inertias_are_those_that_are_found() {
        let millionths = motion::units_in_one(headings::UNIT);
        for mechanism in Mechanism::ALL {
            let in_steps = inertias_in_steps(mechanism);
            let as_drawn = Hypothesis::WITHOUT_LAG.inertias(mechanism);
            for (found, printed) in in_steps.iter().zip(as_drawn) {
                assert!((found - printed).abs() * millionths < 0.5, "{in_steps:?}");
            }
            let known_to = uncertainties(mechanism).expect("a table with slopes");
            // So the last digit is decided, and none of the other's.
            assert!(known_to.iter().all(|to| (0.02..0.5).contains(&(to * millionths))), "{known_to:?}");
        }
    }
}
