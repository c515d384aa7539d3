//! The pages and sections of this book against its ledger.

use crate::BOOK;
use geneva_evidence::Consequence;
use geneva_press::pages::{Page, PageRole};

#[test]
fn every_claim_stands_in_one_section() {
    let listed: Vec<_> = BOOK.ledger_sections().iter().flat_map(|section| section.ids(BOOK.ledger)).collect();
    for claim in BOOK.ledger.claims() {
        assert_eq!(listed.iter().filter(|id| **id == claim.id).count(), 1, "{}", claim.id);
    }
    assert_eq!(listed.len(), BOOK.ledger.claims().len());
}

#[test]
fn every_slip_that_is_not_the_copys_stands_on_one_page() {
    for consequence in Consequence::ALL {
        let tells = |page: &&Page| matches!(page.role, PageRole::Slips(told) if told.contains(consequence));
        let pages = usize::from(*consequence != Consequence::Copy);
        assert_eq!(BOOK.pages.iter().filter(tells).count(), pages, "{consequence}");
    }
}

#[test]
fn each_kind_of_record_that_is_listed_whole_has_one_page() {
    let named =
        |role: PageRole| BOOK.pages.iter().filter(|page| page.role == role).map(|page| page.name).collect::<Vec<_>>();
    assert_eq!(named(PageRole::Claims), ["ledger"]);
    assert_eq!(named(PageRole::Coverage), ["coverage"]);
    assert_eq!(named(PageRole::OpenClaims), ["open"]);
    assert_eq!(named(PageRole::SlipsElsewhere), ["errata-elsewhere"]);
    for page in ["errata", "errata-small", "errata-elsewhere", "open", "ledger", "solver"] {
        assert!(BOOK.is_looked_up(page), "{page}");
    }
    for page in ["pin", "method", "about", "glossary"] {
        assert!(!BOOK.is_looked_up(page), "{page}");
    }
}

#[test]
fn the_book_has_what_the_builder_needs() {
    BOOK.check(geneva_press::placeholders::ENGINE_KEYS).expect("sound");
}
