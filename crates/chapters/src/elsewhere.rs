//! What is said on pages elsewhere: what is wrong in a table and in folds, and where it was read.

use crate::lookup;
use anyhow::{Context, anyhow};
use geneva_documents::WILD;
use geneva_documents::wild;
use geneva_evidence::{Claim, Judged, Kind, Slip, Truth, without_ellipses};
use geneva_press::Book;
use geneva_press::formula::{breakable, tex_or_text};
use geneva_press::html::{escape, prose};
use geneva_press::ledger_pages::errata::{entries, right};
use geneva_press::ledger_pages::inline::{badge, linked_page, with_unit};
use geneva_press::table::{Cells, Table};

/// What is wrong that is stated, a row for each slip.
pub fn wrong_statements(book: &Book) -> anyhow::Result<Table> {
    slips(book, |judged| !is_example(judged))
}

/// What is wrong in examples that are built, a row for each slip.
pub fn wrong_examples(book: &Book) -> anyhow::Result<Table> {
    slips(book, is_example)
}

fn slips(book: &Book, of: fn(&Judged) -> bool) -> anyhow::Result<Table> {
    let main = |(judged, slip): &(&Judged, &Slip)| judged.claim.id == slip.id && of(judged);
    let printed = |claim: &Claim, slip: &Slip| {
        let printed = with_unit(book, &tex_or_text(&without_ellipses(claim))?, claim.unit)?;
        Ok(format!(
            "<a href=\"#slip-{}\">{}</a><div class=\"form\" data-label=\"As printed\">{}</div>",
            slip.id,
            prose(claim.meaning),
            breakable(&printed)
        ))
    };
    let right = |judged, slip: &Slip| Ok(format!("{} <div>{}</div>", right(book, judged)?, prose(slip.changes)));
    Table::with_rows(Cells::Wide, statements_with_slips().filter(main))
        .column("As printed", |(judged, slip)| printed(judged.claim, slip))
        .column("Right, and what the mistake does", |(judged, slip)| right(judged, slip))
        .finish()
}

/// Whether it is the sizes of an example, which nobody says are right.
fn is_example(judged: &Judged) -> bool {
    judged.claim.kind == Kind::Example
}

/// Each address, how much of it was taken, and how many of its statements and of its examples are right and wrong.
pub fn addresses() -> anyhow::Result<Table> {
    let mut all: Vec<(&str, [usize; 4])> = Vec::new();
    for judged in lookup::of_work(&WILD) {
        let (address, _) = read(judged)?;
        let at = all.iter().position(|(known, _)| *known == address).unwrap_or_else(|| {
            all.push((address, [0; 4]));
            all.len() - 1
        });
        all[at].1[2 * usize::from(is_example(judged)) + usize::from(judged.truth() == Truth::Wrong)] += 1;
    }
    let count = |number: usize| if number == 0 { "–".to_owned() } else { number.to_string() };
    let counted = ["Right", "Wrong", "Examples right", "Examples wrong"];
    Table::with_rows(Cells::Wide, all)
        .column("Page or program", |(address, _)| linked_page(address))
        .column("Taken from it", |(address, _)| match wild::is_taken_whole(address) {
            true => "every formula",
            false => "single statements",
        })
        .column("Content", |(address, _)| wild::content(address).map_or_else(|| "–".to_owned(), identifier))
        .columns(
            counted.into_iter().enumerate(),
            |(_, head)| (*head).to_owned(),
            |(_, counts), (at, _)| count(counts[*at]),
        )
        .finish()
}

/// An identifier of a content, which may be broken behind every eighth character of its number.
fn identifier(content: &str) -> String {
    let (kind, number) = content.rsplit_once(':').unwrap_or(("", content));
    let parts: Vec<&str> = (0..number.len()).step_by(8).map(|at| &number[at..number.len().min(at + 8)]).collect();
    format!("<small>{}:<wbr>{}</small>", escape(kind), parts.join("<wbr>"))
}

/// Every statement and example that is wrong in a fold, by what it is about. The ledger has the others.
pub fn statement_folds(book: &Book) -> anyhow::Result<String> {
    let subject = |(title, claims): &wild::Subject| {
        let all = claims();
        let wrong = all.iter().filter(|claim| claim.erratum.is_some());
        let folds = wrong.map(|claim| fold(book, lookup::judged(claim.id)?)).collect::<anyhow::Result<String>>()?;
        Ok(if folds.is_empty() { folds } else { format!("\n\n### {title}\n\n{folds}") })
    };
    wild::SUBJECTS.iter().map(subject).collect()
}

/// A wrong statement in one line, which opens. The one in which a slip is made bears the slip's anchor.
fn fold(book: &Book, judged: &Judged) -> anyhow::Result<String> {
    let claim = judged.claim;
    let (address, day) = read(judged)?;
    let erratum = claim.erratum.as_ref().context("nothing is wrong with it")?;
    let anchor = if erratum.slip.id == claim.id { format!(" id=\"slip-{}\"", claim.id) } else { String::new() };
    let inner = entries(book, judged, book.ledger.slip(erratum.slip.id).context("a slip without places")?, true)?;
    Ok(format!(
        "<details class=\"erratum\"{anchor}>\n<summary>{}: {} {}</summary>\n<p><a href=\"{}\">Address</a>, as read on \
         {day}</p>\n{inner}\n</details>\n\n",
        escape(whose(address)),
        prose(claim.meaning),
        badge(judged.plain()),
        escape(address)
    ))
}

/// Host of a page, owner and name of a repository.
fn whose(address: &str) -> &str {
    let path = address.split_once("://").map_or(address, |(_, path)| path).trim_start_matches("www.");
    let (path, parts) = path.strip_prefix("github.com/").map_or((path, 1), |path| (path, 2));
    let end = path.match_indices('/').nth(parts - 1).map_or(path.len(), |(at, _)| at);
    &path[..end]
}

/// The statements that a slip reaches.
fn statements_with_slips() -> impl Iterator<Item = (&'static Judged, &'static Slip)> {
    lookup::of_work(&WILD).filter_map(|judged| Some((judged, &judged.claim.erratum.as_ref()?.slip)))
}

/// Address and day of a statement.
fn read(judged: &Judged) -> anyhow::Result<(&'static str, &'static str)> {
    wild::read(judged.claim.locator).ok_or_else(|| anyhow!("`{}` has no address", judged.claim.id))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BOOK;
    use geneva_press::html::plain;
    use geneva_press::ledger_pages::inline::linked_id;

    #[test]
    fn every_wrong_statement_has_a_fold_and_every_slip_an_anchor() {
        let page = statement_folds(&BOOK).expect("folds");
        let all: Vec<_> = lookup::of_work(&WILD).filter(|judged| judged.truth() == Truth::Wrong).collect();
        assert_eq!(page.matches("<details").count(), all.len());
        for judged in &all {
            let name = format!("<p>{}", linked_id(&BOOK, judged.claim.id));
            assert_eq!(page.matches(&name).count(), 1, "{}", judged.claim.id);
        }
        let slips: Vec<_> = all.iter().filter_map(|judged| Some(judged.claim.erratum.as_ref()?.slip.id)).collect();
        let tables = [wrong_statements(&BOOK), wrong_examples(&BOOK)].map(|table| table.expect("a table"));
        for id in &slips {
            assert_eq!(page.matches(&format!(" id=\"slip-{id}\"")).count(), 1, "{id}");
            let rows = tables.iter().filter(|table| table.contains(&format!("\"#slip-{id}\""))).count();
            assert_eq!(rows, 1, "{id}");
        }
        assert_eq!(slips.len(), all.len());
    }

    #[test]
    fn every_address_has_a_row_that_counts_its_statements() {
        let csv = addresses().expect("a table").csv().expect("data");
        let rows = || csv.lines().skip(1).map(|row| row.rsplit(',').take(4));
        let counted: usize = rows().flatten().filter_map(|cell| cell.parse::<usize>().ok()).sum();
        assert_eq!(counted, lookup::of_work(&WILD).count());
    }

    #[test]
    fn an_address_is_named_by_its_owner_and_its_last_part() {
        for (address, name) in [
            ("https://www.a.org", "a.org"),
            ("https://a.org/b.html", "a.org/b.html"),
            ("http://a.org/b/c/d/", "a.org/…/d"),
            ("https://github.com/a/b/blob/0123/c/d.py", "a/b/…/d.py"),
            ("https://github.com/a/b/pull/7", "a/b, request 7"),
        ] {
            assert_eq!(plain(&linked_page(address)), name);
        }
        for (address, name) in [
            ("https://www.a.org", "a.org"),
            ("http://a.org/b/", "a.org"),
            ("https://github.com/a/b/blob/0123/c/d.py", "a/b"),
        ] {
            assert_eq!(whose(address), name);
        }
    }
}
