//! How to cite the book and a claim in it: in words, as BibTeX, and as `CITATION.cff`, from the same facts.

use crate::address::Address;
use crate::edition::Edition;
use crate::html::escape;
use crate::lookup;
use crate::pages::address_of_claim;

/// The title of the book.
pub const TITLE: &str = "Geneva, verified";
/// What is below the title.
pub const SUBTITLE: &str = "Four texts on Geneva-type mechanisms, computed again";
/// Who answers for it.
pub const AUTHORS: &str = "The authors of Geneva, verified";
/// The version of the project.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
/// What the book is about, in two lines for `CITATION.cff`.
const ABSTRACT: [&str; 2] = [
    "A book about Geneva mechanisms in which every number, equation, figure and statement of its sources that can be",
    "checked has a verdict, which a test derives.",
];
/// The licence of the book's text, figures and data, as SPDX names it.
pub const LICENCE: &str = "CC-BY-4.0";
/// Where its text is.
pub const LICENCE_ADDRESS: &str = "https://creativecommons.org/licenses/by/4.0/";
/// The licences of the programs, either of which may be chosen, which is what a list means in a CFF file.
const LICENCES: [&str; 2] = ["MIT", "Apache-2.0"];
const KEYWORDS: [&str; 4] = ["Geneva mechanism", "intermittent motion", "kinematics", "reproducibility"];

/// The project's `CITATION.cff`, in version 1.2.0 of the Citation File Format. The date is that of the version's release,
/// if it has been released.
pub fn cff(released: Option<&str>, address: Option<&Address>) -> String {
    let mut out = format!(
        "cff-version: 1.2.0\nmessage: >-\n  If you use a verdict or a number of this book, please cite it. Its text,\n  figures and \
         data are under CC BY 4.0, its programs under MIT or Apache 2.0.\ntitle: \"{TITLE}. {SUBTITLE}\"\nabstract: >-\n  \
         {}\n  {}\ntype: software\nauthors:\n  - name: {AUTHORS}\nversion: {VERSION}\n",
        ABSTRACT[0], ABSTRACT[1]
    );
    if let Some(date) = released {
        out.push_str(&format!("date-released: \"{date}\"\n"));
    }
    if let Some(address) = address {
        out.push_str(&format!("url: {}\n", address.book));
        if !address.source.is_empty() {
            out.push_str(&format!("repository-code: {}\n", address.source));
        }
    }
    for (key, list) in [("license", &LICENCES[..]), ("keywords", &KEYWORDS[..])] {
        out.push_str(&format!("{key}:\n"));
        out.extend(list.iter().map(|item| format!("  - {item}\n")));
    }
    out
}

/// The book as an entry of BibTeX.
pub fn bibtex(edition: &Edition, address: Option<&Address>) -> String {
    let mut fields = vec![("author", format!("{{{AUTHORS}}}")), ("title", format!("{TITLE}. {SUBTITLE}"))];
    if let Some(year) = edition.date.as_deref().and_then(|date| date.get(..4)) {
        fields.push(("year", year.to_owned()));
    }
    fields.push(("note", edition.reference()));
    fields.extend(edition.swhid().map(|id| ("swhid", id)));
    if let Some(address) = address {
        fields.push(("url", address.book.clone()));
    }
    let fields: Vec<_> = fields.iter().map(|(key, value)| format!("  {key} = \"{value}\"")).collect();
    format!("@misc{{geneva-verified,\n{}\n}}\n", fields.join(",\n"))
}

/// The book in words, as HTML.
pub fn in_words(edition: &Edition, address: Option<&Address>) -> String {
    let read = address.map_or_else(String::new, |address| format!(" <a href=\"{0}\">{0}</a>.", escape(&address.book)));
    let archived = edition.swhid().map_or_else(String::new, |id| format!(" <code>{id}</code>."));
    format!(
        "{}: <em>{}. {}.</em> {}.{archived}{read}",
        escape(AUTHORS),
        escape(TITLE),
        escape(SUBTITLE),
        escape(&edition.words())
    )
}

/// One claim in words, as HTML, with the address of its row in the ledger.
pub fn claim(id: &str, edition: &Edition, address: Option<&Address>) -> anyhow::Result<String> {
    let place = address_of_claim(lookup::judged(id)?.claim.id);
    let said = escape(&address.map_or_else(|| place.clone(), |address| address.page(&place)));
    Ok(format!(
        "{}: Claim <code>{}</code>. In: <em>{}</em>, {}, <a href=\"{}\">{said}</a>.",
        escape(AUTHORS),
        escape(id),
        escape(TITLE),
        escape(&edition.words()),
        escape(&place)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edition() -> Edition {
        Edition {
            commit: Some("abcdef0".repeat(6)[..40].to_owned()),
            date: Some("2026-11-26".to_owned()),
            is_changed: false,
        }
    }

    #[test]
    fn the_same_facts_are_in_every_form() {
        let address = Address::of("https://example.org/geneva/", "https://example.org/source").expect("an address");
        for address in [None, Some(&address)] {
            let forms = [cff(None, address), bibtex(&edition(), address), in_words(&edition(), address)];
            for form in &forms {
                assert!(form.contains(TITLE) && form.contains(AUTHORS) && form.contains(VERSION), "{form}");
                assert_eq!(form.contains("https://example.org/geneva/"), address.is_some(), "{form}");
                assert_eq!(form.contains("http"), address.is_some(), "an address that is none: {form}");
            }
            assert_eq!(forms[0].contains("repository-code: https://example.org/source\n"), address.is_some());
        }
    }

    #[test]
    fn a_claim_is_cited_with_its_address() {
        let address = Address::of("https://example.org/geneva/", "").expect("an address");
        let cited = claim("pin.radius", &edition(), Some(&address)).expect("a claim");
        assert!(
            cited.contains("<a href=\"ledger.html#pin.radius\">https://example.org/geneva/ledger.html#pin.radius</a>"),
            "{cited}"
        );
        let cited = claim("pin.radius", &edition(), None).expect("a claim");
        assert!(cited.contains("<a href=\"ledger.html#pin.radius\">ledger.html#pin.radius</a>"), "{cited}");
        assert!(claim("pin.radiuss", &edition(), None).is_err());
    }

    #[test]
    fn an_edition_without_a_repository_has_neither_commit_nor_year() {
        let bare = Edition::default();
        assert!(!bibtex(&bare, None).contains("year") && !bibtex(&bare, None).contains("commit"));
        assert!(bibtex(&edition(), None).contains("year = \"2026\""));
        assert_eq!(bare.words(), format!("version {VERSION}"));
        assert_eq!(bare.reference(), format!("Version {VERSION}"));
    }

    #[test]
    fn only_sources_as_committed_are_cited_by_their_name_in_an_archive() {
        let id = format!("swh:1:rev:{}", edition().commit.expect("a commit"));
        let forms = |edition: &Edition| [bibtex(edition, None), in_words(edition, None)];
        for form in forms(&edition()) {
            assert!(form.contains(&id) && !form.contains("changed"), "{form}");
        }
        for form in forms(&Edition { is_changed: true, ..edition() }) {
            assert!(form.contains("commit abcdef0") && form.contains(", changed") && !form.contains("swh:"), "{form}");
        }
    }
}
