//! Of the corrected tables: by how much the printed numbers are off.

use super::kinds::{CRANK_STEPS, QUADRATURE};
use super::second_routes::printed_rows::rows_as_mechanisms;
use crate::rows::NONE;
use anyhow::Context;
use geneva_case1973::{Column, EXPLAINED, Hypothesis, Row, rows_of};
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::{Form, Numbers, OwnNumber, RECORD};
use geneva_kinematics::Mechanism;

/// The numbers of the chapter on the corrected tables.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        deviation("never-printed.six.peaks", Mechanism::SIX_PIN, Column::Peak),
        deviation("never-printed.six.minima", Mechanism::SIX_PIN, Column::Minimum),
        deviation("never-printed.six.periods", Mechanism::SIX_PIN, Column::Period),
        deviation("never-printed.three.peaks", Mechanism::THREE_PIN, Column::Peak),
        deviation("never-printed.three.minima", Mechanism::THREE_PIN, Column::Minimum),
        deviation("never-printed.three.periods", Mechanism::THREE_PIN, Column::Period),
        deviation("never-printed.four.peaks", Mechanism::FOUR_PIN, Column::Peak),
        OwnNumber::count("never-printed.four.averages", || Ok(rows_of(rows(), Mechanism::FOUR_PIN).len())),
        OwnNumber::new("never-printed.four.averages.near", "{.0}", QUADRATURE, || averages_near(true_value))
            .with_second_route("the averages are the mechanism's own", CRANK_STEPS, || {
                averages_near(true_value_in_steps)
            }),
        OwnNumber::new("never-printed.three-over-four.printed", QUOTIENTS, RECORD, || quotients(printed_peak))
            .with_second_route("printed, three pins are as fast as four", RECORD, || {
                // Where both tables have the friction and the torque.
                let with = |pins: u32| rows().iter().filter(move |row| row.mechanism.pins() == pins);
                let alike =
                    |one: &Row, other: &Row| one.friction() == other.friction() && one.torque() == other.torque();
                let over = |three: &'static Row| {
                    with(4)
                        .filter(move |four| alike(three, four))
                        .map(|four| three.number(Column::Peak) / four.number(Column::Peak))
                };
                Ok(with(3).flat_map(over).collect::<Vec<_>>())
            }),
        OwnNumber::new("never-printed.three-over-four", QUOTIENTS, QUADRATURE, || {
            quotients(|row| true_value(row, Column::Peak))
        })
        .with_second_route("in truth three pins are slower", CRANK_STEPS, || {
            quotients(|row| true_value_in_steps(row, Column::Peak))
        }),
    ]
}

const QUOTIENTS: Form = Form::Range("{.2}", "");

/// The number that the mechanism of a row has.
fn true_value(row: &Row, column: Column) -> Numbers<f64> {
    Ok(Hypothesis::IDEAL.run(row).context(NONE)?.number(column))
}

/// The number that the mechanism of a row has, in equal steps of the crank.
fn true_value_in_steps(row: &Row, column: Column) -> Numbers<f64> {
    let place = EXPLAINED.iter().position(|known| *known == column);
    let results = rows_as_mechanisms().find(|(known, _)| *known == row).and_then(|(_, results)| results);
    Ok(place.zip(results).map(|(place, results)| results[place]).ok_or(NONE)?)
}

/// The printed peak.
fn printed_peak(row: &Row) -> Numbers<f64> {
    Ok(row.number(Column::Peak))
}

/// Printed over right, less one, in per cent, for the rows of a mechanism.
fn deviation(id: &'static str, mechanism: Mechanism, column: Column) -> OwnNumber {
    let in_per_cent = move |true_value: fn(&Row, Column) -> Numbers<f64>| {
        let off = |row: &Row| Ok(100.0 * (row.number(column) / true_value(row, column)? - 1.0));
        rows_of(rows(), mechanism).iter().map(off).collect::<Numbers>()
    };
    OwnNumber::new(id, Form::Range("{+.0}", "&nbsp;%"), QUADRATURE, move || in_per_cent(true_value))
        .with_second_route("the printed numbers are so far off", CRANK_STEPS, move || in_per_cent(true_value_in_steps))
        // A hundredth of a per cent.
        .with_allowance(0.01)
}

/// The peak of three pins over that of four with the same friction and torque.
fn quotients(peak: impl Fn(&Row) -> Numbers<f64>) -> Numbers {
    let alike = |one: &Row, other: &Row| {
        [Column::Friction, Column::Torque].into_iter().all(|column| one.printed(column) == other.printed(column))
    };
    let pairs = rows_of(rows(), Mechanism::THREE_PIN).iter().filter_map(|three| {
        let four = rows_of(rows(), Mechanism::FOUR_PIN).iter().find(|four| alike(three, four))?;
        Some((three, four))
    });
    pairs.map(|(three, four)| Ok(peak(three)? / peak(four)?)).collect()
}

/// How many means of a printed peak and a printed minimum are within a unit of the tables of the mechanism's own, with four
/// pins.
fn averages_near(true_value: fn(&Row, Column) -> Numbers<f64>) -> Numbers<usize> {
    let off = |row: &Row| {
        let own = [true_value(row, Column::Peak)?, true_value(row, Column::Minimum)?];
        let printed = [Column::Peak, Column::Minimum].map(|column| row.number(column));
        Ok((f64::midpoint(own[0], own[1]) - f64::midpoint(printed[0], printed[1])).abs())
    };
    let off = rows_of(rows(), Mechanism::FOUR_PIN).iter().map(off).collect::<Numbers>()?;
    Ok(off.iter().filter(|off| **off <= Column::Peak.unit()).count())
}
