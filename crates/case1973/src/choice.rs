//! Which rows stand for the others where not all are shown.

use crate::{Column, Row, series};
use geneva_kinematics::Mechanism;

/// The table of a mechanism: its rows, which stand together among the rows of all tables. Empty if there is none.
pub fn rows_of(rows: &[Row], mechanism: Mechanism) -> &[Row] {
    let mut tables = rows.chunk_by(|one, other| one.mechanism == other.mechanism);
    tables.find(|table| table[0].mechanism == mechanism).unwrap_or_default()
}

/// For each mechanism and friction the row with the weakest spring.
pub fn weakest(rows: &[Row]) -> impl Iterator<Item = &Row> {
    series(rows).filter_map(<[Row]>::first)
}

/// For each mechanism and friction the row with the strongest spring.
pub fn strongest(rows: &[Row]) -> impl Iterator<Item = &Row> {
    series(rows).filter_map(<[Row]>::last)
}

/// The rows of a mechanism with the least friction, by rising torque; their engagements differ longest.
pub fn least_braked(rows: &[Row], mechanism: Mechanism) -> Option<&[Row]> {
    let own = series(rows).filter(|own| own[0].mechanism == mechanism);
    own.min_by(|a, b| a[0].friction().total_cmp(&b[0].friction()))
}

/// The rows of a mechanism with a friction, as printed, that the others were run with too, by rising torque.
pub fn with_friction<'a>(rows: &'a [Row], mechanism: Mechanism, friction: &str) -> Option<&'a [Row]> {
    series(rows).find(|own| own[0].mechanism == mechanism && own[0].printed(Column::Friction) == friction)
}
