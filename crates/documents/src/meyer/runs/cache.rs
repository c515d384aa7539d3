//! Results of all rows, kept once they are computed: a cell, a route and a test ask for them again and again.

use super::table::{position, rows};
use geneva_case1973::Row;
use std::sync::OnceLock;

/// The results of all rows, in the order of the tables, each computed once.
pub(super) type CachedResults<const N: usize> = OnceLock<Vec<[f64; N]>>;

/// The results of a row; not numbers if it has none, as there is no such motion.
pub(super) fn cached_result<const N: usize>(
    results: &'static CachedResults<N>,
    row: &Row,
    compute: fn(&Row) -> Option<[f64; N]>,
) -> [f64; N] {
    let all = results.get_or_init(|| rows().iter().map(|row| compute(row).unwrap_or([f64::NAN; N])).collect());
    position(row).map_or([f64::NAN; N], |own| all[own])
}
