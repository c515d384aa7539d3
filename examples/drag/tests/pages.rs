//! The book of the section is built, and claims can be checked in its pages.

use geneva_example_drag::{BOOK, LEDGER};
use std::path::Path;

#[test]
fn a_reader_can_check_each_claim_in_the_pages() {
    let out = tempfile::TempDir::new().expect("a folder");
    let first =
        geneva_press::build(&BOOK, Path::new(env!("CARGO_MANIFEST_DIR")), &out.path().join("book")).expect("built");
    let read = |name: &str| std::fs::read_to_string(first.first_page.with_file_name(name)).ok();
    let errata = read("errata.html").expect("a page");
    for judged in LEDGER.verdicts().iter().filter(|judged| judged.claim.erratum.is_some()) {
        assert!(errata.contains(judged.claim.id), "{} is not among the errata", judged.claim.id);
    }
    let Some(module) = read("data/verify-module.js") else {
        assert!(std::env::var_os("LIVE_REQUIRED").is_none(), "no claim can be checked in the pages");
        return;
    };
    for judged in LEDGER.verdicts() {
        let recorded = format!("\"{}\":\"{}\"", judged.claim.id, judged.recorded_plain().words());
        assert!(module.contains(&recorded), "{recorded} is not on record in the page");
    }
    for page in ["falling.html", "slowing.html", "ledger.html"] {
        let page = read(page).expect("a page");
        assert!(page.contains("<script src=\"data/verify.js\"") && page.contains("wasm-unsafe-eval"), "{page}");
    }
}
