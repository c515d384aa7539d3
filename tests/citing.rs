//! Can the book be cited? Looks at `CITATION.cff`, at the foot of every page, and at what the page of sources says.

use geneva_chapters::BOOK;
use geneva_press::imprint::Imprint;
use geneva_press::{address, citing, edition::Edition};

const IMPRINT: &Imprint = &BOOK.imprint;

/// A value in YAML, as far as `CITATION.cff` needs it.
#[derive(Debug, PartialEq)]
enum Yaml {
    Text(String),
    List(Vec<String>),
}

/// Reads keys with a text, a folded text or a list of texts. Anything else is refused.
fn yaml(text: &str) -> Result<Vec<(String, Yaml)>, String> {
    let mut read: Vec<(String, Yaml)> = Vec::new();
    let mut is_folded = false;
    for line in text.lines() {
        let unread = || format!("cannot read the line `{line}`");
        if let Some(item) = line.strip_prefix("  ") {
            match (&mut read.last_mut().ok_or_else(unread)?.1, item.strip_prefix("- ")) {
                (Yaml::Text(folded), _) if is_folded => {
                    folded.push_str(if folded.is_empty() { "" } else { " " });
                    folded.push_str(item);
                }
                (Yaml::List(items), Some(item)) => items.push(item.to_owned()),
                _ => return Err(unread()),
            }
            continue;
        }
        let (key, value) = line.split_once(':').ok_or_else(unread)?;
        if read.iter().any(|(known, _)| known == key) {
            return Err(format!("`{key}` is there twice"));
        }
        is_folded = value == " >-";
        let value = match value {
            "" => Yaml::List(Vec::new()),
            " >-" => Yaml::Text(String::new()),
            _ => {
                let value = value.strip_prefix(' ').ok_or_else(unread)?;
                let quoted = value.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
                // What would be something else than a text.
                let is_bare =
                    !value.contains(": ") && !value.contains(" #") && !value.starts_with(['[', '{', '&', '*']);
                Yaml::Text(quoted.or(is_bare.then_some(value)).ok_or_else(unread)?.to_owned())
            }
        };
        read.push((key.to_owned(), value));
    }
    Ok(read)
}

/// What the schema of the Citation File Format 1.2.0 asks for and a file of ours could get wrong.
/// <https://github.com/citation-file-format/citation-file-format/blob/1.2.0/schema.json>
fn faults(text: &str) -> Vec<String> {
    let read = match yaml(text) {
        Ok(read) => read,
        Err(why) => return vec![why],
    };
    let mut faults = Vec::new();
    for required in ["authors", "cff-version", "message", "title"] {
        if !read.iter().any(|(key, _)| key == required) {
            faults.push(format!("no {required}"));
        }
    }
    let is_url = |url: &str| ["https://", "http://", "ftp://", "sftp://"].iter().any(|scheme| url.starts_with(scheme));
    let is_date = |date: &str| {
        let parts: Vec<_> = date.split('-').collect();
        let lengths: Vec<_> = parts.iter().map(|part| part.len()).collect();
        lengths == [4, 2, 2] && parts.iter().all(|part| part.bytes().all(|digit| digit.is_ascii_digit()))
    };
    let is_commit = |id: &str| id.len() == 40 && id.bytes().all(|of| matches!(of, b'0'..=b'9' | b'a'..=b'f'));
    for (key, value) in &read {
        let is_well = match (key.as_str(), value) {
            ("cff-version", Yaml::Text(version)) => version == "1.2.0",
            ("type", Yaml::Text(kind)) => ["software", "dataset"].contains(&kind.as_str()),
            ("date-released", Yaml::Text(date)) => is_date(date),
            ("commit", Yaml::Text(commit)) => is_commit(commit),
            ("identifiers", Yaml::List(ids)) => ids.iter().all(|id| {
                let value = id.strip_prefix("{type: swh, value: \"swh:1:rev:").and_then(|id| id.strip_suffix("\"}"));
                value.is_some_and(is_commit)
            }),
            ("url" | "repository-code", Yaml::Text(url)) => is_url(url),
            ("title" | "message" | "abstract" | "version", Yaml::Text(text)) => !text.is_empty(),
            // A body needs a name and no more.
            ("authors", Yaml::List(authors)) => {
                !authors.is_empty()
                    && authors.iter().all(|author| author.strip_prefix("name: ").is_some_and(|name| !name.is_empty()))
            }
            ("license", Yaml::List(licences)) => {
                !licences.is_empty()
                    && licences.iter().all(|of| ["MIT", "Apache-2.0", "CC-BY-4.0"].contains(&of.as_str()))
            }
            ("keywords", Yaml::List(words)) => {
                let mut unique = words.clone();
                unique.sort();
                unique.dedup();
                !words.is_empty() && unique.len() == words.len() && words.iter().all(|word| !word.is_empty())
            }
            _ => false,
        };
        if !is_well {
            faults.push(format!("{key}: {value:?}"));
        }
    }
    faults
}

/// The day on which this version was released, by the changelog.
fn released() -> Option<String> {
    let changelog = std::fs::read_to_string(crate::path("CHANGELOG.md")).expect("the changelog");
    let head = format!("## [{}] - ", IMPRINT.version);
    changelog.lines().find_map(|line| line.strip_prefix(&head).map(str::to_owned))
}

#[test]
fn the_citation_file_says_what_the_book_says_and_what_its_format_asks_for() {
    let path = crate::path("CITATION.cff");
    let expected = citing::cff(IMPRINT, released().as_deref(), address::settled(IMPRINT).as_ref());
    assert_eq!(faults(&expected), Vec::<String>::new(), "{expected}");
    let there = std::fs::read_to_string(&path).unwrap_or_default();
    if there != expected {
        std::fs::write(&path, &expected).expect("written");
        panic!(
            "CITATION.cff was not as version, changelog and Cargo.toml have it, and is so now: look at the difference"
        );
    }
}

#[test]
fn the_citation_file_is_sound_with_an_address_and_without_and_a_faulty_one_is_refused() {
    let address = address::Address::of_github("owner/geneva").expect("an address");
    let edition = Edition { commit: Some("abcdef0123".repeat(4)), ..Edition::without_commit(IMPRINT.version) };
    for (date, address) in [(None, None), (Some("2026-11-23"), Some(&address))] {
        let committed = citing::cff(IMPRINT, date, address);
        let of_edition = citing::cff_of_edition(&committed, &edition);
        assert!(of_edition.starts_with(&committed) && of_edition.contains("swh:1:rev:"), "{of_edition}");
        for file in [committed, of_edition] {
            assert_eq!(faults(&file), Vec::<String>::new());
        }
    }
    let sound = citing::cff_of_edition(&citing::cff(IMPRINT, Some("2026-11-23"), Some(&address)), &edition);
    for (right, wrong) in [
        ("cff-version: 1.2.0", "cff-version: 1.1.0"),
        ("title: \"Geneva, verified.", "name: \"Geneva, verified."),
        ("2026-11-23", "23 November 2026"),
        ("type: software", "type: book"),
        ("url: https://", "url: "),
        ("repository-code:", "repository_code:"),
        ("  - name: The authors of Geneva, verified\n", ""),
        ("  - name: ", "  - "),
        ("  - MIT", "  - Mine"),
        ("  - kinematics", "  - reproducibility"),
        ("keywords:\n", "title: Another\nkeywords:\n"),
        ("message: >-\n  If", "message: [If"),
        ("value: \"swh:1:rev:", "value: \"swh:1:"),
        ("commit: abc", "commit: ABC"),
    ] {
        let faulty = sound.replacen(right, wrong, 1);
        assert_ne!(faulty, sound, "{right}");
        assert!(!faults(&faulty).is_empty(), "{wrong} is not noticed");
    }
}

#[test]
fn every_page_says_at_its_foot_which_version_and_commit_it_is() {
    let edition = Edition::detect(&crate::path("book"), IMPRINT);
    let archived = edition.swhid().map_or_else(String::new, |id| format!(" {id}."));
    let expected = format!("{}, {}.{archived}", IMPRINT.title, edition.words());
    for (name, page) in crate::book_pages::pages() {
        let foot: Vec<_> = crate::book_pages::within(page, "footer").into_iter().map(crate::book_pages::text).collect();
        assert_eq!(foot.len(), 1, "{name} has {} feet", foot.len());
        assert!(foot[0].starts_with(&expected), "{name}: {}", foot[0]);
    }
}

#[test]
fn the_page_of_sources_says_how_to_cite_the_book_and_a_claim() {
    let page = &crate::book_pages::pages()["about.html"];
    let said: String = crate::book_pages::within(page, "main").into_iter().map(crate::book_pages::text).collect();
    let edition = Edition::detect(&crate::path("book"), IMPRINT);
    let address = address::known(IMPRINT);
    for part in [
        &*citing::bibtex(IMPRINT, &edition, address.as_ref()),
        &format!("{}: {}. {}. {}.", IMPRINT.authors, IMPRINT.title, IMPRINT.subtitle, edition.words()),
        "Claim pin.slot-point-speed. In: ",
        "ledger.html#pin.slot-point-speed",
    ] {
        assert!(said.contains(part), "the page does not say `{part}`");
    }
    // An address that is not settled is not there, not even as an empty one.
    assert!(address.is_some() || !said.contains("url = "), "an address that is none");
}
