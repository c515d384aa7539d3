//! Does a command that is asked for one source leave the others alone? It is a program of its own, in which nobody has asked for
//! a verdict before.

use geneva_cli::answer;
use geneva_documents::LEDGER;
use geneva_documents::PIN;

#[test]
fn the_claims_and_the_slips_of_a_source_are_judged_without_the_others() {
    for command in ["errata", "claims"] {
        assert_eq!(answer(["geneva", command, "--source", "pin"].map(Into::into)).code, 0, "{command}");
        let others: Vec<&str> = LEDGER
            .judged_until_now()
            .map(|judged| judged.claim)
            .filter(|claim| claim.document != &PIN)
            .map(|claim| claim.id)
            .collect();
        assert!(others.is_empty(), "{command} judges {} of {} claims: {others:?}", others.len(), LEDGER.claims().len());
        assert!(LEDGER.judged_until_now().count() > 0);
    }
}
