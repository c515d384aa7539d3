//! The pages and sections of this book against its ledger.

use crate::BOOK;
use geneva_evidence::Consequence;
use geneva_press::ledger_pages::records;
use geneva_press::pages::PageRole;

#[test]
fn every_claim_stands_in_one_section() {
    let listed: Vec<_> = BOOK.ledger_sections().iter().flat_map(|section| section.ids(BOOK.ledger)).collect();
    for claim in BOOK.ledger.claims() {
        assert_eq!(listed.iter().filter(|id| **id == claim.id).count(), 1, "{}", claim.id);
    }
    assert_eq!(listed.len(), BOOK.ledger.claims().len());
}

#[test]
fn every_slip_that_is_not_the_copys_has_its_place_on_the_page_of_slips() {
    let slips = BOOK.pages.iter().filter(|page| matches!(page.role, PageRole::Slips(_)));
    assert_eq!(slips.map(|page| page.name).collect::<Vec<_>>(), ["errata"]);
    let page = records::page(&BOOK, "errata", &[]).expect("a page");
    let (mut boxes, mut lines) = (0, 0);
    for places in BOOK.ledger.slips().iter().filter(|places| places.is_mirrored()) {
        let (id, is_of_copy) = (places.slip.id, places.slip.consequence == Consequence::Copy);
        assert_eq!(page.matches(&format!(" id=\"slip-{id}\"")).count(), usize::from(!is_of_copy), "{id}");
        assert_eq!(BOOK.page_of_slip(&places.slip), if is_of_copy { "coverage" } else { "errata" }, "{id}");
        boxes += usize::from(page.contains(&format!("<aside class=\"erratum\" id=\"slip-{id}\"")));
        lines += usize::from(page.contains(&format!("<li id=\"slip-{id}\">")));
    }
    assert_eq!(boxes, BOOK.ledger.slips().iter().filter(|of| of.is_mirrored() && BOOK.is_boxed(&of.slip)).count());
    assert!(boxes >= 10 && lines >= 10, "{boxes} boxes, {lines} lines");
}

#[test]
fn each_kind_of_record_that_is_listed_whole_has_one_page() {
    let named =
        |role: PageRole| BOOK.pages.iter().filter(|page| page.role == role).map(|page| page.name).collect::<Vec<_>>();
    assert_eq!(named(PageRole::Claims), ["ledger"]);
    assert_eq!(named(PageRole::Coverage), ["coverage"]);
    assert_eq!(named(PageRole::OpenClaims), ["open"]);
    assert_eq!(named(PageRole::SlipsElsewhere), ["errata-elsewhere"]);
    for page in ["errata", "errata-elsewhere", "open", "ledger", "mimic"] {
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
