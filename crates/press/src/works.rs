//! The works of others on which a sentence of a book leans: citations, the list, and the list as data.
//!
//! A work is cited where a sentence needs it and listed once, on the page of sources.

use crate::book::{Book, CitedWork};
use crate::fields::DataRow;
use crate::html::escape;
use crate::lookup;
use crate::pages::PageRole;
use anyhow::{Context, ensure};

fn work_of_key(works: &'static [CitedWork], key: &str) -> anyhow::Result<&'static CitedWork> {
    let found = works.iter().find(|work| work.key == key);
    found.ok_or_else(|| lookup::unknown("work", key, works.iter().map(|work| work.key)))
}

/// A citation that leads to the list, for example `[Johnson, 1985, chapter 6]`. What comes after a semicolon says where in
/// the work.
pub fn cite(book: &Book, argument: &str) -> anyhow::Result<String> {
    let (key, place) = argument.split_once(';').map_or((argument, ""), |(key, place)| (key, place));
    let work = work_of_key(book.works, key.trim())?;
    let page = book.page_of_role(PageRole::Sources).context("no page of the book has `PageRole::Sources`")?;
    let parts = [work.short, work.year, place.trim()].into_iter().filter(|part| !part.is_empty());
    let words = escape(&parts.collect::<Vec<_>>().join(", "));
    Ok(format!("<a class=\"cite\" href=\"{page}.html#work-{}\">&#91;{words}&#93;</a>", work.key))
}

/// The list of all works.
pub fn works_list(book: &Book) -> anyhow::Result<String> {
    let items = book.works.iter().map(|work| {
        let title = escape(work.title);
        let title =
            if work.address.is_empty() { title } else { format!("<a href=\"{}\">{title}</a>", escape(work.address)) };
        let year = if work.year.is_empty() { String::new() } else { format!(", {}", work.year) };
        let (authors, published) = (escape(work.authors), escape(work.published));
        format!("<li id=\"work-{}\">{authors}: <em>{title}</em>, {published}{year}</li>", work.key)
    });
    Ok(format!("<ul class=\"works\">\n{}\n</ul>", items.collect::<Vec<_>>().join("\n")))
}

/// The list as data, with where and when each work's details were read.
pub fn rows(works: &'static [CitedWork]) -> impl Iterator<Item = DataRow> {
    works.iter().map(|work| {
        DataRow(vec![
            ("key", work.key.into()),
            ("authors", work.authors.into()),
            ("title", work.title.into()),
            ("published", work.published.into()),
            ("year", work.year.into()),
            ("address", work.address.into()),
            ("read_at", work.read.into()),
            ("read_on", work.read_on.into()),
        ])
    })
}

/// Holds the citations of all chapters against the list: each is in it, and each work is cited.
pub fn check<'a>(works: &'static [CitedWork], chapters: impl IntoIterator<Item = &'a str>) -> anyhow::Result<()> {
    let mut cited = Vec::new();
    for chapter in chapters {
        for rest in chapter.split("{{cite:").skip(1) {
            let (argument, _) = rest.split_once("}}").context("a citation has no end")?;
            cited.push(work_of_key(works, argument.split(';').next().unwrap_or_default().trim())?.key);
        }
    }
    let idle: Vec<_> = works.iter().map(|work| work.key).filter(|key| !cited.contains(key)).collect();
    ensure!(
        idle.is_empty(),
        "no chapter cites {}: cite it where a sentence leans on it, or take it off the list",
        idle.join(", ")
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    #[test]
    fn a_citation_leads_to_the_list_and_an_unknown_one_is_refused() {
        let cited = cite(&BOOK, "johnson; chapter 6").expect("a work");
        assert_eq!(cited, "<a class=\"cite\" href=\"about.html#work-johnson\">&#91;Johnson, 1985, chapter 6&#93;</a>");
        assert!(works_list(&BOOK).expect("a list").contains("<li id=\"work-johnson\">"));
        assert!(cite(&BOOK, "jonson").expect_err("unknown").to_string().contains("`johnson`"));
    }

    #[test]
    fn a_work_that_no_chapter_cites_is_refused() {
        let all: String = BOOK.works.iter().map(|work| format!("{{{{cite:{}; page 1}}}}", work.key)).collect();
        check(BOOK.works, [all.as_str()]).expect("each is cited");
        let without = all.replacen("{{cite:alon; page 1}}", "", 1);
        let error = check(BOOK.works, [without.as_str()]).expect_err("one is not");
        assert!(error.to_string().contains("no chapter cites alon"));
        assert!(check(BOOK.works, [all.as_str(), "{{cite:nobody}}"]).is_err());
    }
}
