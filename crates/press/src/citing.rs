//! How to cite the book and a claim in it: in words, as BibTeX, and as `CITATION.cff`, from the same facts.

use crate::address::Address;
use crate::book::Book;
use crate::edition::Edition;
use crate::html::escape;
use crate::imprint::Imprint;
use crate::lookup;
use crate::pages::PageRole;

/// The project's `CITATION.cff`, in version 1.2.0 of the Citation File Format. The date is that of the version's release,
/// if it has been released.
pub fn cff(imprint: &Imprint, released: Option<&str>, address: Option<&Address>) -> String {
    let Imprint { title, subtitle, authors, version, .. } = imprint;
    let folded = |lines: &[&str]| lines.iter().map(|line| format!("  {line}\n")).collect::<String>();
    let mut out = format!(
        "cff-version: 1.2.0\nmessage: >-\n{}title: \"{title}. {subtitle}\"\nabstract: >-\n{}type: software\nauthors:\n  - \
         name: {authors}\nversion: {version}\n",
        folded(imprint.request),
        folded(imprint.summary)
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
    for (key, list) in [("license", imprint.program_licences), ("keywords", imprint.keywords)] {
        out.push_str(&format!("{key}:\n"));
        out.extend(list.iter().map(|item| format!("  - {item}\n")));
    }
    out
}

/// A citation file with the sources of this edition by their name in the archive of source code. The file that is committed cannot
/// have it, since the name follows from the commit. Sources that have no such name add nothing.
pub fn cff_of_edition(committed: &str, edition: &Edition) -> String {
    let (Some(id), Some(commit)) = (edition.swhid(), &edition.commit) else { return committed.to_owned() };
    format!("{committed}commit: {commit}\nidentifiers:\n  - {{type: swh, value: \"{id}\"}}\n")
}

/// The book as an entry of BibTeX.
pub fn bibtex(imprint: &Imprint, edition: &Edition, address: Option<&Address>) -> String {
    let mut fields = vec![
        ("author", format!("{{{}}}", imprint.authors)),
        ("title", format!("{}. {}", imprint.title, imprint.subtitle)),
    ];
    if let Some(year) = edition.date.as_deref().and_then(|date| date.get(..4)) {
        fields.push(("year", year.to_owned()));
    }
    fields.push(("note", edition.reference()));
    fields.extend(edition.swhid().map(|id| ("swhid", id)));
    if let Some(address) = address {
        fields.push(("url", address.book.clone()));
    }
    let fields: Vec<_> = fields.iter().map(|(key, value)| format!("  {key} = \"{value}\"")).collect();
    format!("@misc{{{},\n{}\n}}\n", imprint.key, fields.join(",\n"))
}

/// The book in words, as HTML.
pub fn citation_in_words(imprint: &Imprint, edition: &Edition, address: Option<&Address>) -> String {
    let read = address.map_or_else(String::new, |address| format!(" <a href=\"{0}\">{0}</a>.", escape(&address.book)));
    let archived = edition.swhid().map_or_else(String::new, |id| format!(" <code>{id}</code>."));
    format!(
        "{}: <em>{}. {}.</em> {}.{archived}{read}",
        escape(imprint.authors),
        escape(imprint.title),
        escape(imprint.subtitle),
        escape(&edition.words())
    )
}

/// One claim in words, as HTML, with the address of its row in the ledger.
pub fn claim_citation(book: &Book, id: &str, edition: &Edition, address: Option<&Address>) -> anyhow::Result<String> {
    let imprint = &book.imprint;
    let place = book.address_of_claim(lookup::claim(book.ledger, id)?.id);
    let said = escape(&address.map_or_else(|| place.clone(), |address| address.page(&place)));
    Ok(format!(
        "{}: Claim <code>{}</code>. In: <em>{}</em>, {}, <a href=\"{}\">{said}</a>.",
        escape(imprint.authors),
        escape(id),
        escape(imprint.title),
        escape(&edition.words()),
        escape(&place)
    ))
}

/// The foot of every page, which leads to the page of sources if the book has one.
pub fn footer(book: &Book, edition: &Edition, address: Option<&Address>) -> String {
    let read = address
        .map_or_else(String::new, |address| format!(" Read it at <a href=\"{0}\">{0}</a>.", escape(&address.book)));
    let sources = book
        .pages
        .iter()
        .find(|page| page.role == PageRole::Sources)
        .map_or_else(String::new, |page| format!(" <a href=\"{}.html\">{}</a>.", page.name, escape(page.title)));
    let archived = edition.swhid().map_or_else(String::new, |id| format!(" <code>{id}</code>."));
    format!(
        "\n{FOOT}{}, {}.{archived}{read}{sources}{FOOT_END}\n",
        escape(book.imprint.title),
        escape(&edition.words())
    )
}

/// How the foot of a page begins and ends.
const FOOT: &str = "<footer class=\"edition\">";
const FOOT_END: &str = "</footer>";

/// A page without the foot, which alone says from which edition it is.
pub(crate) fn without_foot(page: &str) -> String {
    let split = page.rsplit_once(FOOT).and_then(|(before, rest)| Some((before, rest.split_once(FOOT_END)?)));
    split.map_or_else(|| page.to_owned(), |(before, (_, behind))| format!("{before}{behind}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::{BOOK, IMPRINT};

    const NONE: Edition = Edition::without_commit(IMPRINT.version);

    fn edition() -> Edition {
        Edition { commit: Some("abcdef0".repeat(6)[..40].to_owned()), date: Some("2026-11-26".to_owned()), ..NONE }
    }

    #[test]
    fn the_same_facts_are_in_every_form() {
        let address =
            Address::from_manifest("https://example.org/geneva/", "https://example.org/source").expect("an address");
        for address in [None, Some(&address)] {
            let forms = [
                cff(&IMPRINT, None, address),
                bibtex(&IMPRINT, &edition(), address),
                citation_in_words(&IMPRINT, &edition(), address),
            ];
            for form in &forms {
                let facts = [IMPRINT.title, IMPRINT.authors, IMPRINT.version];
                assert!(facts.iter().all(|fact| form.contains(fact)), "{form}");
                assert_eq!(form.contains("https://example.org/geneva/"), address.is_some(), "{form}");
                assert_eq!(form.contains("http"), address.is_some(), "an address that is none: {form}");
            }
            assert_eq!(forms[0].contains("repository-code: https://example.org/source\n"), address.is_some());
        }
    }

    #[test]
    fn a_claim_is_cited_with_its_address() {
        let address = Address::from_manifest("https://example.org/geneva/", "").expect("an address");
        let id = BOOK.ledger.claims()[0].id;
        let row = format!("ledger.html#{id}");
        let cited = claim_citation(&BOOK, id, &edition(), Some(&address)).expect("a claim");
        assert!(cited.contains(&format!("<a href=\"{row}\">https://example.org/geneva/{row}</a>")), "{cited}");
        let cited = claim_citation(&BOOK, id, &edition(), None).expect("a claim");
        assert!(cited.contains(&format!("<a href=\"{row}\">{row}</a>")), "{cited}");
        assert!(claim_citation(&BOOK, &format!("{id}s"), &edition(), None).is_err());
    }

    #[test]
    fn an_edition_without_a_repository_has_neither_commit_nor_year() {
        let bibtex = |edition: &Edition| bibtex(&IMPRINT, edition, None);
        assert!(!bibtex(&NONE).contains("year") && !bibtex(&NONE).contains("commit"));
        assert!(bibtex(&edition()).contains("year = \"2026\""));
        assert_eq!(NONE.words(), format!("version {}", IMPRINT.version));
        assert_eq!(NONE.reference(), format!("Version {}", IMPRINT.version));
    }

    #[test]
    fn only_sources_as_committed_are_cited_by_their_name_in_an_archive() {
        let id = format!("swh:1:rev:{}", edition().commit.expect("a commit"));
        let forms = |edition: &Edition| {
            let file = cff_of_edition(&cff(&IMPRINT, None, None), edition);
            let said = [bibtex(&IMPRINT, edition, None), citation_in_words(&IMPRINT, edition, None)];
            (said.into_iter().chain([footer(&BOOK, edition, None)]).collect::<Vec<_>>(), file)
        };
        let (sources, changed) = (edition(), Edition { is_changed: true, ..edition() });
        assert!(forms(&sources).1.ends_with(&format!("identifiers:\n  - {{type: swh, value: \"{id}\"}}\n")));
        for without in [&changed, &NONE] {
            assert_eq!(forms(without).1, cff(&IMPRINT, None, None));
        }
        for form in forms(&sources).0 {
            assert!(form.contains(&id) && !form.contains("changed"), "{form}");
        }
        for form in forms(&changed).0 {
            assert!(form.contains("commit abcdef0") && form.contains(", changed") && !form.contains("swh:"), "{form}");
        }
    }

    #[test]
    fn a_page_without_its_foot_is_the_same_in_every_edition() {
        let page = |edition: &Edition| format!("<main>a{}<script></script></main>", footer(&BOOK, edition, None));
        assert_eq!(without_foot(&page(&edition())), "<main>a\n\n<script></script></main>");
        assert_eq!(without_foot(&page(&edition())), without_foot(&page(&NONE)));
        for page in ["<main>a</main>", FOOT] {
            assert_eq!(without_foot(page), page);
        }
    }

    #[test]
    fn the_foot_of_a_page_names_an_address_only_if_there_is_one() {
        let address = Address::from_manifest("https://example.org/geneva/", "").expect("an address");
        let edition = Edition { commit: Some("abcdef0".to_owned()), date: Some("2026-11-26".to_owned()), ..NONE };
        let (without, with) = (footer(&BOOK, &edition, None), footer(&BOOK, &edition, Some(&address)));
        assert!(with.contains(" Read it at <a href=\"https://example.org/geneva/\">https://example.org/geneva/</a>."));
        assert!(!without.contains("http") && !without.contains("Read it"), "{without}");
        for footer in [without, with] {
            let edition = format!("version {}, commit abcdef0 of 2026-11-26.", IMPRINT.version);
            assert!(footer.contains(&edition), "{footer}");
        }
    }
}
