//! What is wrong in the sources: one erratum in its chapter, and the page of all slips by what they do.

use super::findings::how;
use super::inline::{badge, linked_id, with_unit};
use crate::book::Book;
use crate::formula::{breakable, mark_changes, tex_or_text};
use crate::html::{escape, prose};
use crate::lookup;
use crate::numbers::sentence_start;
use crate::page_items::{PageItem, address_of_erratum, anchor_of_erratum};
use crate::table::{Cells, Table};
use anyhow::anyhow;
use geneva_evidence::{Claim, Consequence, Judged, TracedSlip, without_ellipses};

/// The class of the fold with an erratum.
pub(crate) const FOLD: &str = "erratum";
/// The class of a fold with an erratum that has no box on another page.
pub(crate) const TOLD_HERE: &str = "told-here";

/// The erratum of a claim: one line, which opens.
pub fn erratum_fold(book: &Book, id: &str) -> anyhow::Result<String> {
    let judged = lookup::verdict(book.ledger, id)?;
    let erratum = judged.claim.erratum.as_ref().ok_or_else(|| anyhow!("claim `{id}` has no erratum"))?;
    let places =
        book.ledger.slip(erratum.slip.id).ok_or_else(|| anyhow!("slip `{}` has no places", erratum.slip.id))?;
    let told_here = if book.is_boxed(&places.slip) { String::new() } else { format!(" {TOLD_HERE}") };
    Ok(format!(
        "<details class=\"{FOLD}{told_here}\" id=\"{}\">\n<summary>{}</summary>\n{}\n</details>",
        anchor_of_erratum(id),
        in_a_line(book, judged)?,
        entries(book, judged, places, false)?
    ))
}

/// Where a slip shows, and for a number or a few words what is printed there and what is right.
fn in_a_line(book: &Book, judged: &Judged) -> anyhow::Result<String> {
    /// Most characters of a form that stands in a line.
    const SHORT: usize = 24;
    let claim = judged.claim;
    let mut line = format!("<strong>Erratum</strong>, {}: {}", escape(claim.locator), escape(claim.meaning));
    let (printed, corrected) = (without_ellipses(claim), judged.corrected().unwrap_or_default());
    if printed.chars().count() <= SHORT && corrected.chars().count() <= SHORT {
        line += &format!(
            "; printed {}, right {}",
            with_unit(book, &tex_or_text(&printed)?, claim.unit)?,
            right(book, judged)?
        );
    } else {
        // The words before say what the source says.
        line += "; wrong as printed";
    }
    Ok(line)
}

/// All slips of the documents with a consequence, under a heading that says what they do.
pub fn errata_list(book: &Book, consequence: Consequence) -> anyhow::Result<String> {
    let slip = |places: &TracedSlip| Ok(format!("\n{}\n", boxed(book, places)?));
    let slips = book.ledger.slips_of(consequence).map(slip).collect::<anyhow::Result<String>>()?;
    Ok(format!("\n\n## {}\n{slips}", consequence.heading()))
}

/// A line for each slip of the documents that has no box, with a link to the fold of its chapter, or to the ledger where no
/// chapter has one.
pub fn errata_in_chapters(book: &Book, items: &[PageItem]) -> String {
    let all = Consequence::ALL.iter().filter(|of| **of != Consequence::Copy).flat_map(|of| book.ledger.slips_of(*of));
    let lines = all.filter(|places| !book.is_boxed(&places.slip)).map(|places| {
        let (claim, slip) = (places.main().claim, &places.slip);
        let address = address_of_erratum(items, slip.id).unwrap_or_else(|| book.address_of_claim(slip.id));
        format!(
            "<li id=\"slip-{}\"><a href=\"{address}\">{}, {}</a>: {} <small>({})</small></li>\n",
            slip.id,
            sentence_start(claim.document.title),
            escape(claim.locator),
            escape(claim.meaning),
            slip.consequence
        )
    });
    let lines: String = lines.collect();
    if lines.is_empty() {
        return lines;
    }
    format!(
        "\n\n## Told in the chapters {{#in-the-chapters}}\n\nEach line leads to the place where its mistake is explained.\n\n\
         <ul>\n{lines}</ul>\n"
    )
}

/// What changes a result or a conclusion, a row each.
pub fn grave_errata(book: &Book) -> anyhow::Result<Table> {
    let grave = [Consequence::Result, Consequence::Conclusion].into_iter().flat_map(|of| book.ledger.slips_of(of));
    let place = |places: &TracedSlip| {
        let claim = places.main().claim;
        let document = sentence_start(claim.document.title);
        let (locator, meaning) = (escape(claim.locator), escape(claim.meaning));
        format!("<a href=\"#slip-{}\">{document}, {locator}</a>: {meaning}", places.slip.id)
    };
    let printed = |claim: &Claim| with_unit(book, &tex_or_text(&without_ellipses(claim))?, claim.unit);
    Table::with_rows(Cells::Wide, grave)
        .column("Place, and what it says", |places| place(places))
        .column("Printed", |places| printed(places.main().claim))
        .column("Right", |places| right(book, places.main()))
        .column("What it does", |places| prose(places.slip.changes) + &numbers(places))
        .finish()
}

/// How many slips of the documents there are of each consequence, and how many without those of the copy.
pub fn consequences_table(book: &Book) -> anyhow::Result<Table> {
    Table::with_rows(Cells::Words, Consequence::ALL.iter().filter(|of| **of != Consequence::Copy))
        .column("Consequence", |of| of.to_string())
        .column("What it means", |of| of.meaning())
        .column("Mistakes", |of| book.ledger.slips_of(**of).count())
        .column("Claims affected", |of| book.ledger.slips_of(**of).map(|slip| slip.claims.len()).sum::<usize>())
        .finish()
}

/// How many slips of the documents there are of a consequence, or of all but those of the copy.
pub fn slip_count(book: &Book, of_what: &str) -> anyhow::Result<String> {
    let number = match of_what {
        "all" => {
            let told = Consequence::ALL.iter().filter(|of| **of != Consequence::Copy);
            told.map(|of| book.ledger.slips_of(*of).count()).sum()
        }
        slug => book.ledger.slips_of(lookup::consequence(slug)?).count(),
    };
    Ok(number.to_string())
}

/// A slip in a box, in full.
fn boxed(book: &Book, places: &TracedSlip) -> anyhow::Result<String> {
    let (judged, slip) = (places.main(), &places.slip);
    Ok(format!(
        "<aside class=\"erratum\" id=\"slip-{}\" aria-label=\"Erratum {}\">\n<p><strong>{}</strong>: {}. {}</p>\n{}\n</aside>",
        slip.id,
        judged.claim.id,
        escape(judged.claim.locator),
        escape(judged.claim.meaning),
        badge(judged.plain()),
        entries(book, judged, places, true)?
    ))
}

/// What an erratum says; in full also how it was found, and where else the slip shows.
pub fn entries(book: &Book, judged: &Judged, places: &TracedSlip, in_full_detail: bool) -> anyhow::Result<String> {
    let (claim, slip) = (judged.claim, &places.slip);
    let mut out = "<dl>\n".to_owned();
    let mut entry = |term: &str, text: String| out.push_str(&format!("<dt>{term}</dt><dd>{text}</dd>\n"));
    let [printed, corrected] = forms(book, judged)?;
    entry("Printed", printed);
    entry("Right", corrected);
    if !slip.changes.is_empty() {
        entry("What it does", prose(slip.changes) + &numbers(places));
    }
    entry("Why", prose(slip.reason));
    entry("Second witness", prose(slip.witness));
    if in_full_detail {
        explain(book, judged, places, &mut entry)?;
    }
    let id = linked_id(book, claim.id);
    let last = match in_full_detail {
        true => id,
        // Without a box, the row in the ledger says it.
        false if !book.is_boxed(slip) => format!("How it was found: {id}"),
        false => format!("{id}, <a href=\"{}.html#slip-{}\">how it was found</a>", book.page_of_slip(slip), slip.id),
    };
    out.push_str(&format!("</dl>\n<p>{last}</p>"));
    Ok(out)
}

/// The printed characters and what should stand in their place, with what differs between the two marked in each.
pub fn forms(book: &Book, judged: &Judged) -> anyhow::Result<[String; 2]> {
    let (printed, corrected) = (without_ellipses(judged.claim), judged.corrected().unwrap_or_default());
    let form = |of: &str, other: &str| with_unit(book, &breakable(&mark_changes(of, other)?), judged.claim.unit);
    Ok([form(&printed, &corrected)?, form(&corrected, &printed)?])
}

/// Says how an erratum was found.
fn explain(
    book: &Book,
    judged: &Judged,
    places: &TracedSlip,
    entry: &mut impl FnMut(&str, String),
) -> anyhow::Result<()> {
    let (claim, evidence) = (judged.claim, judged.claim.check.evidence());
    for (term, number, kind) in [
        ("Computed", judged.computed, evidence.first()),
        ("Second witness's number", judged.witnessed, evidence.last()),
    ] {
        if let (Some(number), Some(kind)) = (number, kind) {
            entry(term, format!("{} ({})", with_unit(book, &judged.rounded(number), claim.unit)?, kind.name));
        }
    }
    // Where the source's own way leads to another number, the right one rests on more than its printed places.
    if let Some(right) = judged.right_value.filter(|right| judged.computed.is_some_and(|own| own != *right)) {
        entry("Right number, to more digits", with_unit(book, &judged.rounded(right), claim.unit)?);
    }
    if let Some(reading) = claim.reading.filter(|_| judged.findings.is_empty()) {
        entry("How we read it", escape(reading));
    }
    if !judged.findings.is_empty() {
        // With the reading; each route is a paragraph.
        entry("How it was found", format!("<p>{}</p>", how(judged).replace("<br> ", "</p><p>")));
    }
    if places.claims.len() > 1 {
        entry("Other places", others(book, judged, places));
    }
    Ok(())
}

/// What should stand in the place of the printed characters.
pub fn right(book: &Book, judged: &Judged) -> anyhow::Result<String> {
    with_unit(book, &tex_or_text(&judged.corrected().unwrap_or_default())?, judged.claim.unit)
}

/// How many printed numbers a slip makes wrong, and by how much.
fn numbers(places: &TracedSlip) -> String {
    let number = places.wrong_numbers().count();
    let (of, up_to) = match number {
        1 => ("one printed number".to_owned(), ""),
        _ => (format!("{number} printed numbers"), "up to "),
    };
    places.greatest_change().map_or_else(String::new, |change| {
        let decimals = if change < 0.1 { 1 } else { 0 };
        format!(" ({of}, wrong by {up_to}{:.decimals$}&nbsp;%)", 100.0 * change)
    })
}

/// The other claims that a slip reaches; of many in one table only the first.
fn others(book: &Book, judged: &Judged, places: &TracedSlip) -> String {
    const MOST: usize = 8;
    let ids = places.claims.iter().map(|other| other.claim.id).filter(|id| *id != judged.claim.id);
    let links: Vec<_> = ids.clone().take(MOST).map(|id| linked_id(book, id)).collect();
    let more = ids.count() - links.len();
    links.join(", ") + &if more > 0 { format!(" and {more} more") } else { String::new() }
}
