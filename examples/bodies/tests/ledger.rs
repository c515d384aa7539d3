//! The leaflet's ledger holds, and would not hold if something in it were wrong.

use geneva_example_bodies::LEDGER;

#[test]
fn the_ledger_stands() {
    geneva_evidence::testing::check(&LEDGER);
}
