//! The section's ledger holds, and would not hold if something in it were wrong.

use geneva_example_drag::LEDGER;

#[test]
fn the_ledger_stands() {
    geneva_evidence::testing::check(&LEDGER);
}
