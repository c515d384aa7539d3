//! The open claims, by what they lack.

use super::findings::how;
use super::inline::{linked_id, place};
use crate::book::{Book, OpenGroup};
use crate::html::escape;
use crate::lookup::{unknown, verdicts_of_documents};
use crate::numbers::sentence_start;
use crate::pages::PageRole;
use geneva_evidence::{Judged, Truth};

/// A link to the section of a group.
pub fn link(book: &Book, group: &OpenGroup) -> String {
    let page = book.page_of_role(PageRole::OpenClaims).unwrap_or_default();
    let file = if page.is_empty() { String::new() } else { format!("{page}.html") };
    format!("<a href=\"{file}#{}\">{}</a>", group.name, escape(group.title))
}

/// Whether a group has the claim with this id.
pub fn has(group: &OpenGroup, id: &str) -> bool {
    group.ids.iter().any(|pattern| fits(pattern, id))
}

/// Whether an id is of this pattern, in which a star stands for any characters.
pub fn fits(pattern: &str, id: &str) -> bool {
    match pattern.split_once('*') {
        Some((start, end)) => id.starts_with(start) && id.ends_with(end),
        None => pattern == id,
    }
}

/// The group of an open claim.
pub fn group_of<'a>(book: &'a Book, judged: &Judged) -> Option<&'a OpenGroup> {
    let open = judged.truth() == Truth::Open;
    book.open_groups.iter().find(|group| open && has(group, judged.claim.id))
}

/// The open claims of the group with this name.
fn claims(book: &Book, name: &str) -> anyhow::Result<Vec<&'static Judged>> {
    let names = || book.open_groups.iter().map(|group| group.name);
    let group = book.open_groups.iter().find(|group| group.name == name);
    let group = group.ok_or_else(|| unknown("group of open claims", name, names()))?;
    let is_own = |judged: &&Judged| group_of(book, judged).is_some_and(|of| of.name == group.name);
    Ok(verdicts_of_documents(book.ledger).filter(is_own).collect())
}

/// How many open claims the group with this name has.
pub fn open_count(book: &Book, name: &str) -> anyhow::Result<String> {
    Ok(claims(book, name)?.len().to_string())
}

/// What a claim says, as a sentence begins.
fn sentence(judged: &Judged) -> String {
    escape(&sentence_start(judged.claim.meaning))
}

/// The open claims of a group, those that lack the same thing together.
pub fn open_list(book: &Book, name: &str) -> anyhow::Result<String> {
    /// Most claims that are named one by one.
    const FEW: usize = 3;
    let mut by_reason: Vec<(String, Vec<&Judged>)> = Vec::new();
    for judged in claims(book, name)? {
        let reason = how(judged);
        match by_reason.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, all)) => all.push(judged),
            None => by_reason.push((reason, vec![judged])),
        }
    }
    let items = by_reason.iter().map(|(reason, all)| {
        let ids = all.iter().map(|judged| linked_id(book, judged.claim.id)).collect::<Vec<_>>().join(", ");
        let what = all
            .iter()
            .take(FEW)
            .map(|judged| format!("<strong>{}</strong> ({})", sentence(judged), place(book, judged.claim)));
        let names = if all.len() > FEW {
            format!("<strong>{}</strong>, in {} places", sentence(all[0]), all.len())
        } else {
            what.collect::<Vec<_>>().join("; ")
        };
        let ids = if all.len() > FEW {
            format!("<details><summary>All {} claims</summary>{ids}</details>", all.len())
        } else {
            format!(" <small>{ids}</small>")
        };
        format!("<li>{names}. {reason}{ids}</li>\n")
    });
    Ok(format!("<ul class=\"open-claims\">\n{}</ul>", items.collect::<String>()))
}
