//! Finding what this book's ledger has by name; the error tells the nearest name or all there are.

use geneva_documents::LEDGER;
use geneva_evidence::{Claim, Document, Judged};
use geneva_press::lookup;

pub(crate) use geneva_press::lookup::{find_named, unknown};

/// The claim with this id, without its verdict.
pub(crate) fn claim(id: &str) -> anyhow::Result<&'static Claim> {
    lookup::claim(&LEDGER, id)
}

/// The judged claim with this id.
pub(crate) fn judged(id: &str) -> anyhow::Result<&'static Judged> {
    lookup::verdict(&LEDGER, id)
}

/// The judged claims of a source.
pub(crate) fn of_work(work: &'static Document) -> impl Iterator<Item = &'static Judged> {
    lookup::verdicts_of(&LEDGER, work)
}

/// The judged claims of the documents: without what is said elsewhere.
pub(crate) fn of_documents() -> impl Iterator<Item = &'static Judged> {
    lookup::verdicts_of_documents(&LEDGER)
}
