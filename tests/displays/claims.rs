//! The verdict on every equation of a source hangs on its own characters: each misprint changes it. The record of that tells the
//! book.

use crate::book_sources::stood_written;
use geneva_documents::LEDGER;
use geneva_evidence::testing::{Guarded, equation_misprints, further_misprints};
use geneva_evidence::tex::Class;
use geneva_evidence::{Claim, judge};

#[test]
fn every_misprint_in_a_source_is_noticed() {
    let misprints = equation_misprints(Guarded::new(&LEDGER));
    println!("{:?}", misprints.harmless);
    misprints.report.expect(10_000);
    assert!(Class::ALL.iter().all(|class| misprints.refuted.contains_key(class)), "{:?}", misprints.refuted);
    let (refuted, by_both) = (misprints.refuted.values().sum::<usize>(), misprints.refuted_by_both);
    let (unreadable, harmless) = (misprints.unreadable, misprints.harmless.values().sum::<usize>());
    is_recorded(
        "misprints.csv",
        &format!("refuted,{refuted}\nrefuted-by-both,{by_both}\nunreadable,{unreadable}\nharmless,{harmless}\n"),
    );
}

#[test]
fn a_further_misprint_in_a_wrong_equation_is_noticed() {
    let further = further_misprints(Guarded::new(&LEDGER));
    further.report.expect(1000);
    let (noticed, at_the_slip) = (further.refuted.values().sum::<usize>(), further.unreadable);
    is_recorded("misprints-of-wrong.csv", &format!("noticed,{noticed}\nat-the-slip,{at_the_slip}\n"));

    let claim = LEDGER.claim("meyer.eq-1-17").expect("a claim");
    let (wrong, changed) = (claim.printed, claim.printed.replacen("I_D", "I_f", 1));
    assert_ne!(changed, wrong);
    let judged = judge(Box::leak(Box::new(Claim { printed: changed.leak(), ..claim.clone() })));
    assert_eq!(judged.verdict, claim.expected);
    assert!(
        judged.faults.iter().any(|fault| fault.contains("in 2 places, and one is on record")),
        "{:?}",
        judged.faults
    );
}

/// Whether a record of the book is up to date; it is written if it is not.
#[track_caller]
fn is_recorded(name: &str, record: &str) {
    let file = format!("book/records/{name}");
    let stood = stood_written(&file, record);
    assert!(stood, "{file} was not up to date and is now: look at the difference and test again");
}
