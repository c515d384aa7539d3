//! Of the corrected tables: by how much the printed numbers are off.

use super::Number;
use crate::numbers::signed;
use anyhow::Context;
use geneva_case1973::{Column, Hypothesis, Row, rows_of};
use geneva_documents::meyer::runs::table::rows;
use geneva_kinematics::Mechanism;

/// The numbers of the chapter on the corrected tables.
pub const NUMBERS: &[(&str, Number)] = &[
    ("never-printed.six.peaks", || range(Mechanism::SIX_PIN, Column::Peak)),
    ("never-printed.six.minima", || range(Mechanism::SIX_PIN, Column::Minimum)),
    ("never-printed.six.periods", || range(Mechanism::SIX_PIN, Column::Period)),
    ("never-printed.three.peaks", || range(Mechanism::THREE_PIN, Column::Peak)),
    ("never-printed.three.minima", || range(Mechanism::THREE_PIN, Column::Minimum)),
    ("never-printed.three.periods", || range(Mechanism::THREE_PIN, Column::Period)),
    ("never-printed.four.peaks", || range(Mechanism::FOUR_PIN, Column::Peak)),
    ("never-printed.four.averages", || Ok(rows_of(rows(), Mechanism::FOUR_PIN).len().to_string())),
    ("never-printed.four.averages.near", averages_near),
    ("never-printed.three-over-four.printed", || quotients(|row| Ok(row.number(Column::Peak)))),
    ("never-printed.three-over-four", || quotients(|row| right(row, Column::Peak))),
];

/// The number that the mechanism of a row has.
fn right(row: &Row, column: Column) -> anyhow::Result<f64> {
    Ok(Hypothesis::IDEAL.run(row).context("a run's data make no escapement")?.number(column))
}

/// Least and greatest of some numbers.
fn ends(all: impl Iterator<Item = anyhow::Result<f64>>) -> anyhow::Result<[f64; 2]> {
    let all = all.collect::<anyhow::Result<Vec<_>>>()?;
    Ok([all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(f64::NEG_INFINITY, f64::max)])
}

/// Printed over right, less one, in per cent: from the least to the greatest of a column.
fn range(mechanism: Mechanism, column: Column) -> anyhow::Result<String> {
    let off = |row: &Row| Ok(100.0 * (row.number(column) / right(row, column)? - 1.0));
    let [least, greatest] = ends(rows_of(rows(), mechanism).iter().map(off))?;
    Ok(format!("{} to {}&nbsp;%", signed(least, 0), signed(greatest, 0)))
}

/// The peak of three pins over that of four with the same friction and torque: from the least to the greatest.
fn quotients(peak: impl Fn(&Row) -> anyhow::Result<f64>) -> anyhow::Result<String> {
    let alike = |one: &Row, other: &Row| {
        [Column::Friction, Column::Torque].into_iter().all(|column| one.printed(column) == other.printed(column))
    };
    let pairs = rows_of(rows(), Mechanism::THREE_PIN).iter().filter_map(|three| {
        let four = rows_of(rows(), Mechanism::FOUR_PIN).iter().find(|four| alike(three, four))?;
        Some((three, four))
    });
    let [least, greatest] = ends(pairs.map(|(three, four)| Ok(peak(three)? / peak(four)?)))?;
    Ok(format!("{least:.2} to {greatest:.2}"))
}

/// How many means of a printed peak and a printed minimum are within a unit of the tables of the mechanism's own, with four
/// pins.
fn averages_near() -> anyhow::Result<String> {
    let off = |row: &Row| {
        let own = [right(row, Column::Peak)?, right(row, Column::Minimum)?];
        let printed = [Column::Peak, Column::Minimum].map(|column| row.number(column));
        Ok((f64::midpoint(own[0], own[1]) - f64::midpoint(printed[0], printed[1])).abs())
    };
    let off = rows_of(rows(), Mechanism::FOUR_PIN).iter().map(off).collect::<anyhow::Result<Vec<f64>>>()?;
    Ok(off.iter().filter(|off| **off <= Column::Peak.unit()).count().to_string())
}
