//! Which of the printed rows the book shows where not all are shown, for what the thesis prints besides.

use super::table::rows;
use crate::MEYER;
use geneva_case1973::{Hypothesis, Row, rows_of, with_friction};
use geneva_kinematics::Mechanism;

/// A friction with which all three mechanisms were run with nearly the same torques, as printed.
const COMMON_FRICTION: &str = ".25";

/// The rows of a mechanism with a friction that the others were run with too, by rising torque.
pub fn comparable(mechanism: Mechanism) -> Option<&'static [Row]> {
    with_friction(rows(), mechanism, COMMON_FRICTION)
}

/// The four-pin rows that may be the run drawn in Fig. 8, which the thesis does not name.
///
/// Their first minimum rounds to the rise time printed for the figure. None if the motion of a row has no solution.
pub fn of_fig_8() -> Option<Vec<&'static Row>> {
    that_may_be_of_fig_8(&Hypothesis::WITHOUT_LAG)
}

fn that_may_be_of_fig_8(hypothesis: &Hypothesis) -> Option<Vec<&'static Row>> {
    let printed = MEYER.printed_decimal("meyer.fig-8.rise");
    let mut fitting = Vec::new();
    for row in rows_of(rows(), Mechanism::FOUR_PIN) {
        let first = hypothesis.engagement(row)?.first_minimum().ok()??;
        if printed.is_rounding_of(first.time) {
            fitting.push(row);
        }
    }
    Some(fitting)
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_case1973::{Column, least_braked};

    #[test]
    fn two_runs_may_be_that_of_fig_8_and_the_table_gives_both_another_rise_time() {
        let printed = MEYER.printed_decimal("meyer.fig-8.rise");
        for hypothesis in [Hypothesis::WITHOUT_LAG, Hypothesis::IDEAL] {
            let fitting = that_may_be_of_fig_8(&hypothesis).expect("solved");
            assert_eq!(fitting.len(), 2);
            assert!(fitting.iter().all(|row| !printed.is_rounding_of(row.number(Column::Rise))));
        }
    }

    #[test]
    fn each_mechanism_has_its_rows_and_examples() {
        assert_eq!(Mechanism::ALL.map(|of| rows_of(rows(), of).len()).iter().sum::<usize>(), rows().len());
        for mechanism in Mechanism::ALL {
            for own in [least_braked(rows(), mechanism), comparable(mechanism)].map(|own| own.expect("rows")) {
                assert!(own.len() > 3 && own.iter().all(|row| row.mechanism == mechanism));
            }
        }
    }
}
