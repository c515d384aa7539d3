//! Does every address of an earlier edition lead to a page and a place that are there?
//!
//! The pages that are gone are listed here with the places on them, so that no redirection can be dropped in silence.

use crate::book_pages::{files, ids, moved, pages};
use geneva_chapters::BOOK;
use geneva_evidence::Consequence;
use std::collections::HashSet;

/// Pages that are gone, with the places on them that have names of their own.
const GONE: &[(&str, &[&str])] = &[
    ("ledger-jazar", &[]),
    ("ledger-meyer", &[]),
    ("ledger-meyer-motion", &[]),
    ("ledger-meyer-study", &[]),
    ("ledger-meyer-program", &[]),
    ("ledger-meyer-runs", &[]),
    ("ledger-meyer-more-runs", &[]),
    ("ledger-wild", &["where-they-were-read"]),
    ("ledger-wild-parts", &[]),
    ("coverage-meyer", &[]),
    ("errata-copy", &[]),
    (
        "errata-small",
        &[
            "a-sentence-that-describes-something-is-false-but-the-source-concludes-nothing-false-from-it",
            "a-printed-number-is-wrong-but-no-answer-is-wrong-by-half-a-per-cent-or-more",
            "a-displayed-equation-is-false-but-nothing-after-it-uses-it-in-that-form",
            "a-label-a-reference-a-unit-or-a-name-is-wrong",
        ],
    ),
    (
        "tests",
        &[
            "pin",
            "jazar",
            "making",
            "quick-return",
            "escapement",
            "program",
            "runs",
            "never-printed",
            "terminal-speed",
            "timer",
            "joints",
        ],
    ),
    ("fields", &["claims", "errata", "coverage", "figures"]),
    (
        "solver",
        &[
            "the-idea-integrals-over-the-angle",
            "how-accurate-it-is",
            "what-it-costs",
            "fig-solver-work-precision",
            "table-solver-speeds",
            "table-solver-maps",
        ],
    ),
    (
        "architecture",
        &["the-crates", "walks", "where-things-are", "how-to-add", "writing-a-chapter", "what-the-tests-keep"],
    ),
];

/// Places of earlier editions on pages that are there, each of which still leads to what has taken its place.
const KEPT: &[(&str, &[&str])] = &[(
    "making",
    &[
        "what-you-need-and-what-you-get",
        "the-moment-of-inertia-of-a-disc",
        "from-the-need-to-the-drawing",
        "1-stations-and-pins-from-index-and-dwell",
        "2-size",
        "3-pin-slot-and-play",
        "4-horn-locking-disc-and-crescent",
        "5-loads",
        "6-clearance-over-the-whole-turn",
        "7-backlash-the-blow-at-entry-and-tolerances",
        "8-the-drawing-number-by-number",
        "when-not-to-use-a-geneva-wheel",
        "more-stations-or-another-kind",
        "exercises",
        "the-tests-behind-this-chapter",
    ],
)];

/// The places of records on a page that is gone: claims of a section of the ledger, and slips.
fn records(page: &str) -> Vec<String> {
    let slips = |is_there: &dyn Fn(Consequence) -> bool| {
        let all = BOOK.ledger.slips().iter().filter(|places| places.is_mirrored());
        all.filter(|places| is_there(places.slip.consequence))
            .map(|places| format!("slip-{}", places.slip.id))
            .collect()
    };
    match page {
        "errata-copy" => slips(&|of| of == Consequence::Copy),
        "errata-small" => {
            use Consequence::{Derivation, Number, Remark, Wording};
            slips(&|of| [Remark, Number, Derivation, Wording].contains(&of))
        }
        _ => {
            let section = page.strip_prefix("ledger-");
            let own = BOOK.sections.iter().filter(|of| section == Some(of.name));
            own.flat_map(|of| of.ids(BOOK.ledger)).map(str::to_owned).collect()
        }
    }
}

/// Where a browser goes from an address, as the page of the redirection has it: a place is looked up, and one that is not found goes
/// along to the new page.
fn followed(page: &str, place: &str) -> String {
    let whole = |page: &str| moved().get(page).unwrap_or_else(|| panic!("{page} leads nowhere"));
    let target = whole(&format!("{page}.html"));
    match moved().get(&format!("{page}.html#{place}")) {
        _ if place.is_empty() => target.clone(),
        Some(target) => target.clone(),
        None => format!("{}#{place}", target.split('#').next().unwrap_or_default()),
    }
}

/// Whether a page of the book has a place; a page always has its beginning.
fn is_there(address: &str) -> bool {
    let (page, place) = address.split_once('#').unwrap_or((address, ""));
    pages().get(page).is_some_and(|page| place.is_empty() || ids(page).iter().any(|id| id == place))
}

#[test]
fn every_place_on_a_page_that_is_gone_leads_to_one_that_is_there() {
    let mut places = 0;
    for (page, own) in GONE {
        assert!(!BOOK.pages.iter().any(|of| of.name == *page), "{page} is a page of the book");
        let all = own.iter().map(|place| (*place).to_owned()).chain(records(page)).chain([String::new()]);
        for place in all {
            let target = followed(page, &place);
            assert!(is_there(&target), "{page}.html#{place} leads to {target}, which is not there");
            places += 1;
        }
    }
    assert!(places > 900, "only {places} places");
    assert!(!is_there("method.html#no-such-place") && !is_there("no-such-page.html"));
}

#[test]
fn every_place_that_a_page_once_had_is_there() {
    for (page, places) in KEPT {
        for place in *places {
            assert!(is_there(&format!("{page}.html#{place}")), "{page}.html#{place}");
        }
    }
}

#[test]
fn every_redirection_is_of_a_page_that_is_gone_and_works_without_scripts() {
    let mut known = HashSet::new();
    for (page, own) in GONE {
        known.insert(format!("{page}.html"));
        known.extend(own.iter().map(|place| format!("{page}.html#{place}")));
    }
    for (from, to) in moved() {
        assert!(known.contains(from), "{from} is on no list of pages that are gone");
        assert!(is_there(to), "{from} leads to {to}, which is not there");
        let (file, _) = from.split_once('#').unwrap_or((from, ""));
        let text = String::from_utf8_lossy(files().get(file).unwrap_or_else(|| panic!("no file {file}")));
        // Without scripts, and with a policy as every page.
        let target = &moved()[file];
        assert!(text.contains(&format!("<meta http-equiv=\"refresh\" content=\"0; URL={target}\">")), "{file}: {text}");
        assert!(
            text.contains(&format!("<a href=\"{target}\">")) && text.contains("Content-Security-Policy"),
            "{file}: {text}"
        );
    }
}
