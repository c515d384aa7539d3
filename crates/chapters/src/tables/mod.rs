//! Tables of computed numbers, beside those of the ledger: by name, or for a range of wheels.

mod found;
pub mod joints;
pub mod locking;
mod mimic;
mod quick_return;
pub mod readings;
mod rise_times;
mod runs;
pub mod timer;
mod wheels;

pub use wheels::wheels;

use geneva_press::book::MakeTable;

/// All tables, in the order of the book.
pub const TABLES: &[(&str, MakeTable)] = &[
    ("quick-return-terms", quick_return::terms),
    ("quick-return-branches", quick_return::branches),
    ("jazar-locking-arcs", locking::arcs),
    ("runs-hypotheses", runs::hypotheses),
    ("runs-columns", runs::by_column),
    ("runs-weighings", runs::weighings),
    ("runs-freed", runs::freed),
    ("runs-unexplained", runs::unexplained),
    ("runs-delays", runs::delays),
    ("runs-inertias", runs::inertias),
    ("runs-integrator", runs::integrator),
    ("runs-statistics", runs::statistics),
    ("runs-rise-definitions", rise_times::definitions),
    ("runs-rise-events", rise_times::events),
    ("runs-rise-groups", rise_times::groups),
    ("thesis-terms", rise_times::terms),
    ("runs-six-pin", runs::six_pin),
    ("runs-six-pin-as-headed", runs::six_pin_as_headed),
    ("runs-four-pin", runs::four_pin),
    ("runs-three-pin", runs::three_pin),
    ("joints", joints::speeds),
    ("joints-multiplier", joints::multipliers),
    ("mimic-cards", mimic::cards),
    ("mimic-functions", mimic::functions),
    ("timer-settling", timer::settling),
    ("timer-sensitivity", timer::sensitivity),
    ("timer-accelerations", timer::accelerations),
    ("timer-mean-speed", timer::mean_speed),
    ("found-books", found::textbooks),
    ("found-university-physics", found::university_physics),
    ("found-university-physics-units", found::university_physics_units),
    ("found-college-physics", found::college_physics),
    ("found-statistics", found::introductory_statistics),
    ("found-calculus", found::calculus),
    ("found-prealgebra", found::prealgebra),
    ("found-finance", found::finance),
    ("found-chemistry", found::chemistry),
    ("found-openintro", found::openintro),
    ("found-orcca", found::orcca),
    ("found-apex", found::apex),
    ("found-biostatistics", found::biostatistics),
    ("found-rates", found::measured),
    ("readings", readings::readings),
];
