//! What a slip does, by its places.

use geneva_documents::LEDGER;
use geneva_evidence::{Consequence, TracedSlip};

/// What contradicts the slip of this id with another consequence on record.
fn faults_as(id: &str, consequence: Consequence) -> String {
    let mut places = LEDGER.slip(id).expect("a slip").clone();
    places.slip.consequence = consequence;
    places.faults().join("\n")
}

#[test]
fn the_slips_of_a_source_are_those_among_all() {
    let ids = |slips: &mut dyn Iterator<Item = &TracedSlip>| -> Vec<(&str, usize)> {
        slips.map(|places| (places.slip.id, places.claims.len())).collect()
    };
    for document in LEDGER.documents() {
        let expected = ids(&mut LEDGER.slips().iter().filter(|places| places.main().claim.document == *document));
        assert_eq!(ids(&mut LEDGER.slips_in(document).iter()), expected, "{document}");
    }
    let one_by_one: Vec<&TracedSlip> = LEDGER.slips().iter().filter_map(|places| LEDGER.slip(places.slip.id)).collect();
    assert_eq!(ids(&mut one_by_one.into_iter()), ids(&mut LEDGER.slips().iter()));
    assert!(LEDGER.slip("no-slip").is_none());
}

#[test]
fn a_result_is_an_answer_that_is_wrong_by_more_than_its_last_digits() {
    let found = faults_as("pin.slot-point-speed", Consequence::Result);
    assert!(found.contains("but no answer changes by half a per cent or more"), "{found}");
    // An answer, but wrong in its last digits alone.
    let found = faults_as("quick-return.pin-speed", Consequence::Result);
    assert!(found.contains("but no answer changes by half a per cent or more"), "{found}");
    let found = faults_as("meyer.app-a.three-slots.centre", Consequence::Result);
    assert!(found.contains("but no printed number changes by half a per cent or more"), "{found}");
    let found = faults_as("jazar.ex-c.formula", Consequence::Number);
    assert!(found.contains("but an answer changes"), "{found}");
    let found = faults_as("quick-return.lever-point-speed-equation", Consequence::Number);
    assert!(found.contains("but no printed number changes"), "{found}");
}

#[test]
fn a_conclusion_is_drawn_by_the_source_and_a_remark_is_not() {
    let found = faults_as("meyer.conclusion.three", Consequence::Remark);
    assert!(found.contains("but the source concludes it"), "{found}");
    let found = faults_as("wild.probsee.steps", Consequence::Conclusion);
    assert!(found.contains("but the source is not known to conclude it"), "{found}");
    let found = faults_as("quick-return.lever-point-speed-equation", Consequence::Remark);
    assert!(found.contains("but no statement is corrected"), "{found}");
    assert!(faults_as("meyer.spring-rate", Consequence::Number).contains("but no printed number changes"));
}
