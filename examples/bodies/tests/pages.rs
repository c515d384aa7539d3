//! The book of the example has what every book has, without a line of its own: claims that are checked in the page.

use geneva_example_bodies::{BOOK, LEDGER};
use std::path::Path;

#[test]
fn a_reader_can_check_each_claim_in_the_pages() {
    let out = tempfile::TempDir::new().expect("a folder");
    let first =
        geneva_press::build(&BOOK, Path::new(env!("CARGO_MANIFEST_DIR")), &out.path().join("book")).expect("built");
    let read = |name: &str| std::fs::read_to_string(first.first_page.with_file_name(name)).ok();
    let Some(module) = read("data/verify-module.js") else {
        assert!(std::env::var_os("LIVE_REQUIRED").is_none(), "no claim can be checked in the pages");
        return;
    };
    for judged in LEDGER.verdicts() {
        let recorded = format!("\"{}\":\"{}\"", judged.claim.id, judged.recorded_plain().slug());
        assert!(module.contains(&recorded), "{recorded} is not on record in the page");
    }
    for page in ["falling.html", "swinging.html", "ledger.html"] {
        let page = read(page).expect("a page");
        assert!(page.contains("<script src=\"data/verify.js\"") && page.contains("wasm-unsafe-eval"), "{page}");
    }
}
