//! The feed of changed verdicts, for readers who have built on one: what each release says of verdicts and mistakes.

use pulldown_cmark::{Parser, html};

use crate::address;
use crate::changelog::{Release, midnight, releases};
use crate::data::FOLDER;
use crate::epub::identifier;
use crate::html::escape;
use crate::imprint::Imprint;

/// The file of the feed, among the data.
pub(crate) const FILE: &str = "verdicts.atom";
/// The sections of a release in a changelog that say which verdicts changed and what was found wrong.
const SECTIONS: [&str; 2] = ["Verdicts", "Errata"];

/// The feed of a book with this changelog in Atom (RFC 4287): an entry for each release whose changelog has a section *Verdicts* with words in
/// it, the latest first, with that section and the section *Errata*. Nothing if no release has.
///
/// An entry leads to the page of mistakes, if the book has one, and else to the book. It keeps its identifier as long as title and version are the same, so that a feed reader shows it once.
pub(crate) fn atom(imprint: &Imprint, changelog: &str, slips_page: Option<&str>) -> String {
    let releases = releases(changelog);
    let entries: Vec<(&Release<'_>, String)> =
        releases.iter().filter_map(|release| Some((release, content(release)?))).collect();
    let Some((latest, _)) = entries.first() else { return String::new() };
    let address = address::known(imprint).map(|address| address.book);
    let link = |relation: &str, to: &str| match &address {
        Some(book) => format!("<link rel=\"{relation}\" href=\"{}\"/>\n", escape(&format!("{book}{to}"))),
        None => String::new(),
    };
    let mut feed = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<feed xmlns=\"http://www.w3.org/2005/Atom\" xml:lang=\"en\">\n\
         <id>{}</id>\n<title>{}: changed verdicts</title>\n<subtitle>{}</subtitle>\n<updated>{}</updated>\n\
         <author><name>{}</name></author>\n<rights>{}</rights>\n{}{}",
        identifier(&format!("{}, changed verdicts", imprint.title)),
        escape(imprint.title),
        escape(imprint.subtitle),
        midnight(latest.date),
        escape(imprint.authors),
        escape(imprint.licence_words),
        link("self", &format!("{FOLDER}/{FILE}")),
        link("alternate", ""),
    );
    for (release, content) in &entries {
        feed.push_str(&format!(
            "<entry>\n<id>{}</id>\n<title>Verdicts of {}</title>\n<updated>{}</updated>\n{}<content \
             type=\"html\">{}</content>\n</entry>\n",
            identifier(&format!("{}, changed verdicts, {}", imprint.title, release.version)),
            escape(release.version),
            midnight(release.date),
            link("alternate", &slips_page.map_or_else(String::new, |page| format!("{page}.html"))),
            escape(content),
        ));
    }
    feed + "</feed>\n"
}

/// The heading and the words of a section; nothing if it has no words.
fn section<'r>(release: &'r Release<'_>, heading: &str) -> Option<(&'r str, &'r str)> {
    release.sections.iter().copied().find(|(of, text)| *of == heading && !text.is_empty())
}

/// Whether a release says which verdicts changed.
fn says_verdicts(release: &Release<'_>) -> bool {
    section(release, SECTIONS[0]).is_some()
}

/// What a release says of verdicts and mistakes, in HTML; nothing if it says nothing of verdicts.
fn content(release: &Release<'_>) -> Option<String> {
    if !says_verdicts(release) {
        return None;
    }
    let section = |heading: &str| section(release, heading);
    let mut content = String::new();
    for (heading, text) in SECTIONS.into_iter().filter_map(section) {
        content.push_str(&format!("<h2>{}</h2>\n", escape(heading)));
        html::push_html(&mut content, Parser::new(text));
    }
    Some(content)
}

/// A page that names the feed, if there is one, to a reader's program that looks for feeds.
pub(crate) fn with_link_to_the_feed(page: &str, imprint: &Imprint, changelog: &str) -> String {
    if !releases(changelog).iter().any(says_verdicts) {
        return page.to_owned();
    }
    let link = format!(
        "<link rel=\"alternate\" type=\"application/atom+xml\" title=\"{}: changed verdicts\" href=\"{FOLDER}/{FILE}\">\n</head>",
        escape(imprint.title)
    );
    page.replacen("</head>", &link, 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    const CHANGELOG: &str = "# Changelog\n\n## [Unreleased]\n\n### Verdicts\n\n- From right to wrong: `z`.\n\n\
                             ## [0.2.0] - 2026-11-28\n\n### Verdicts\n\n- From right to wrong: `a.b` (1 < 2 & 3).\n\n### Added\n\n- A feed.\n\n\
                             ### Errata\n\n## [0.1.1] - 2026-11-26\n\n### Verdicts\n\n## [0.1.0] - 2026-11-25\n\n### Verdicts\n\n- `c`.\n\n### \
                             Errata\n\n- *d*\n";

    fn texts<'a>(node: roxmltree::Node<'a, 'a>, name: &str) -> Vec<&'a str> {
        node.children()
            .filter(|node| node.has_tag_name(("http://www.w3.org/2005/Atom", name)))
            .filter_map(|node| node.text())
            .collect()
    }

    #[test]
    fn a_feed_has_an_entry_for_each_release_that_says_something_of_verdicts() {
        let feed = atom(&BOOK.imprint, CHANGELOG, None);
        let document = roxmltree::Document::parse(&feed).expect("a feed is XML");
        let root = document.root_element();
        assert_eq!(texts(root, "updated"), ["2026-11-28T00:00:00Z"]);
        let entries: Vec<_> =
            root.children().filter(|node| node.has_tag_name(("http://www.w3.org/2005/Atom", "entry"))).collect();
        let of_entries = |name| entries.iter().flat_map(|entry| texts(*entry, name)).collect::<Vec<_>>();
        assert_eq!(of_entries("title"), ["Verdicts of 0.2.0", "Verdicts of 0.1.0"]);
        assert_eq!(of_entries("updated"), ["2026-11-28T00:00:00Z", "2026-11-25T00:00:00Z"]);
        assert_eq!(
            of_entries("content"),
            [
                "<h2>Verdicts</h2>\n<ul>\n<li>From right to wrong: <code>a.b</code> (1 &lt; 2 &amp; 3).</li>\n</ul>\n",
                "<h2>Verdicts</h2>\n<ul>\n<li><code>c</code>.</li>\n</ul>\n<h2>Errata</h2>\n<ul>\n<li><em>d</em></li>\n</ul>\n",
            ]
        );
        let mut ids = [texts(root, "id"), of_entries("id")].concat();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), 3);
        // What is added to the changelog later changes no identifier.
        let grown = CHANGELOG.replace("## [0.2.0]", "## [0.3.0] - 2026-12-01\n\n### Verdicts\n\n- `e`.\n\n## [0.2.0]");
        let grown = atom(&BOOK.imprint, &grown, None);
        assert!(ids.iter().all(|id| grown.contains(id)));
    }

    #[test]
    fn a_book_without_changed_verdicts_has_no_feed_and_names_none() {
        let page = "<head></head>";
        for changelog in ["", "## [0.1.0] - 2026-11-25\n\n### Added\n\n- A.\n"] {
            assert_eq!(atom(&BOOK.imprint, changelog, None), "");
            assert_eq!(with_link_to_the_feed(page, &BOOK.imprint, changelog), page);
        }
        let named = with_link_to_the_feed(page, &BOOK.imprint, CHANGELOG);
        assert!(named.contains("type=\"application/atom+xml\"") && named.ends_with("</head>"), "{named}");
    }
}
