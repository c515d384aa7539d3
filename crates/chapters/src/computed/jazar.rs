//! Of the chapter on the wheel with any number of stations: for what its table of locking arcs is made.

use crate::tables::locking::LOCKING_DISC;
use geneva_evidence::{GIVEN, OwnNumber};

/// The numbers of this chapter.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![OwnNumber::new("jazar.locking-disc", "{.1}", GIVEN, || Ok(LOCKING_DISC))]
}
