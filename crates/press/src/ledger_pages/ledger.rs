//! The page of all claims: a row for each, and what is known of a claim, which a reader asks for.
//!
//! What is known of all claims together weighs more than all rows. It stands in a script of its own, which the page loads
//! when the first claim is opened. Without scripts every row is there, and `claims.json` has the rest.

use super::errata::forms;
use super::findings::{how, with_minus_signs};
use super::inline::{computed, place, with_unit};
use super::open;
use crate::book::Book;
use crate::data::{FOLDER, PageFile};
use crate::formula::{breakable, tex_or_text};
use crate::html::prose;
use crate::lookup;
use crate::nowrap_units::tied_without_tags;
use crate::numbers::in_words;
use crate::pages::LedgerSection;
use geneva_evidence::{Consequence, Judged, Kind, PlainVerdict, without_ellipses};
use std::collections::BTreeMap;

/// What filters the rows and opens them, and how they look.
const SCRIPT: &str = include_str!("../../theme/ledger.js");
const STYLE: &str = include_str!("../../theme/ledger.css");
const SCRIPT_NAME: &str = "ledger.js";
const STYLE_NAME: &str = "ledger.css";
const DETAILS_NAME: &str = "ledger-details.js";

/// The choice of the sources that the totals of the book's first page are about.
const DOCUMENTS: &str = "documents";
/// All claims, by section and in the order of the sources, with the filter and what it must load.
pub fn page(book: &Book) -> anyhow::Result<String> {
    let sections = book.ledger_sections();
    let sections = sections.iter().map(|of| section(book, of)).collect::<anyhow::Result<String>>()?;
    Ok(format!(
        "<link rel=\"stylesheet\" href=\"{FOLDER}/{STYLE_NAME}\">\n\n{}\n\n{sections}\n\n<script src=\"{FOLDER}/{SCRIPT_NAME}\" \
         defer></script>\n",
        filter(book)
    ))
}

/// The scripts and the style of the page, and what is known of each claim.
pub fn files(book: &Book) -> anyhow::Result<[PageFile; 3]> {
    let verdicts = book.ledger.verdicts().iter();
    let details = verdicts.map(|judged| Ok((judged.claim.id, tied_without_tags(&details(book, judged)?))));
    let details: BTreeMap<_, _> = details.collect::<anyhow::Result<_>>()?;
    // A claim a line, so that two editions can be compared.
    let text = serde_json::to_string(&details)?.replace("\",\"", "\",\n\"");
    Ok([
        PageFile::text_file(SCRIPT_NAME, SCRIPT.to_owned()),
        PageFile::text_file(STYLE_NAME, STYLE.to_owned()),
        PageFile::text_file(DETAILS_NAME, format!("genevaDetails({text});\n")),
    ])
}

/// The form that filters, which the script shows.
pub fn filter(book: &Book) -> String {
    let option = |value: &str, text: &str| format!("<option value=\"{value}\">{text}</option>");
    let select = |name: &str, label: &str, options: String| {
        format!("<label>{label} <select name=\"{name}\"><option value=\"\">all</option>{options}</select></label>")
    };
    let documents = book.ledger.documents();
    let sources = documents.iter().map(|document| option(document.slug, document.title));
    // By these words the totals of the documents that are mirrored are told from what is said elsewhere.
    let mirrored = match book.ledger.mirrored().len() {
        1 => "the document".to_owned(),
        count => format!("the {} documents", in_words(count)),
    };
    let documents = format!("in {mirrored}");
    let sources = [option(DOCUMENTS, &mirrored)].into_iter().chain(sources).collect();
    let verdicts = PlainVerdict::ALL.iter().map(|verdict| {
        // A reading that is right is right, too, as in the totals of the first page.
        let (words, is_counted): (_, fn(PlainVerdict, PlainVerdict) -> bool) = match verdict {
            PlainVerdict::Right => ("right or right as read", |of, it| of.truth() == it.truth()),
            other => (other.words(), |of, it| of == it),
        };
        let all = lookup::verdicts_of_documents(book.ledger);
        let count = all.filter(|judged| is_counted(judged.plain(), *verdict)).count();
        option(verdict.slug(), &format!("{words} ({count} {documents})"))
    });
    let kinds = Kind::ALL.iter().map(|kind| option(kind.slug(), kind_name(*kind))).collect();
    let command = book.ledger_crate.map_or("", |of| of.account_command);
    format!(
        "<form class=\"filter\" role=\"search\" aria-label=\"Filter the claims\" data-documents=\"{documents}\" \
         data-command=\"{command}\" hidden><label>Words <input type=\"search\" \
         name=\"words\"></label>{}{}{}<label>Order <select name=\"order\"><option value=\"\">what changes most first</option><option \
         value=\"source\">as in the sources</option></select></label><p><output></output> <button type=\"reset\">Show all</button></p></form>",
        select("source", "Source", sources),
        select("verdict", "Verdict", verdicts.collect()),
        select("kind", "Kind", kinds)
    )
}

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Value => "number",
        Kind::Equation => "equation",
        Kind::Figure => "figure",
        Kind::Statement => "statement",
        Kind::Example => "example",
    }
}

/// The claims of a section; every row can be linked to by the claim's id.
fn section(book: &Book, section: &LedgerSection) -> anyhow::Result<String> {
    let ids = section.ids(book.ledger).into_iter();
    let rows = ids.map(|id| row(book, lookup::verdict(book.ledger, id)?)).collect::<anyhow::Result<String>>()?;
    let (title, name, source) = (section.title, section.name, section.document);
    let is_mirrored = book.ledger.document(source).is_some_and(|document| document.is_mirrored());
    let mirrored = if is_mirrored { " data-mirrored" } else { "" };
    let words = book.ledger.document(source).map_or("", |document| document.title);
    Ok(format!(
        "## {title} {{#{name}}}\n\n<ul class=\"claims\" data-source=\"{source}\" data-title=\"{words}\"{mirrored}>\n{rows}</ul>\n\n"
    ))
}

/// A claim: its id, our verdict, where it stands, what it says, what is printed, and what was found, in a line.
///
/// For the filter and the order its classes are its kind, its plain verdict and, if it is wrong, what the mistake changes.
fn row(book: &Book, judged: &Judged) -> anyhow::Result<String> {
    let (claim, verdict) = (judged.claim, judged.plain());
    let printed = with_unit(book, &tex_or_text(&without_ellipses(claim))?, claim.unit)?;
    let printed = match computed(judged) {
        Some(computed) => format!("<div>{printed}, computed {computed}{}</div>", right(judged)),
        // A form may be wider than the page; one whose lines are aligned scrolls, and so takes the focus.
        None => {
            let focus = if printed.contains("<mtable") { " tabindex=\"0\"" } else { "" };
            format!("<div class=\"form\"{focus}>{}</div>", breakable(&printed))
        }
    };
    let found = finding_in_a_line(book, judged);
    let found = if found.is_empty() { found } else { format!("<small>{found}</small>") };
    let changes = claim.erratum.as_ref().filter(|_| verdict == PlainVerdict::Wrong);
    let changes = changes.map_or_else(String::new, |erratum| format!(" {}", erratum.slip.consequence));
    Ok(format!(
        "<li id=\"{0}\" class=\"{1} {verdict}{changes}\"><code>{0}</code> <b>{2}</b> <small>{3}</small><p>{4}</p>{printed}{found}</li>\n",
        claim.id,
        claim.kind.slug(),
        verdict.words(),
        place(book, claim),
        prose(claim.meaning),
    ))
}

/// What is right, where what was computed is not.
fn right(judged: &Judged) -> String {
    let in_error = judged.right_value.filter(|right| judged.computed != Some(*right));
    in_error.map_or_else(String::new, |right| format!(", right {}", judged.rounded(right)))
}

/// What was found, in a line: the mistake, what is missing, or how the printed form holds.
pub fn finding_in_a_line(book: &Book, judged: &Judged) -> String {
    let mistake = mistake(book, judged).map(|link| format!("Mistake: {link}"));
    let missing = open::group_of(book, judged).map(|group| format!("Open: {}", open::link(book, group)));
    let holds = judged.findings.first().map(|(_, finding)| with_minus_signs(&finding.how));
    [mistake, missing, holds].into_iter().flatten().collect::<Vec<_>>().join(". ")
}

/// The mistake that reaches a claim, as a link to where it is told.
fn mistake(book: &Book, judged: &Judged) -> Option<String> {
    let slip = &judged.claim.erratum.as_ref()?.slip;
    let what = match slip.consequence {
        Consequence::Copy => "only in the copy".to_owned(),
        other => other.to_string(),
    };
    Some(format!("<a href=\"{}.html#slip-{}\">{what}</a>", book.page_of_slip(slip), slip.id))
}

/// All that is known of a claim besides its row.
fn details(book: &Book, judged: &Judged) -> anyhow::Result<String> {
    let (claim, evidence) = (judged.claim, judged.claim.check.evidence());
    let mut out = "<dl>".to_owned();
    let mut entry = |term: &str, text: String| {
        if !text.is_empty() {
            out.push_str(&format!("<dt>{term}</dt><dd>{text}</dd>"));
        }
    };
    let number = |number: f64| with_unit(book, &judged.rounded(number), claim.unit);
    for (term, value, kind) in [
        ("Computed", judged.computed, evidence.first()),
        ("Second route", judged.witnessed, evidence.last()),
        ("From the source’s rounded steps", judged.from_rounded, None),
        ("Right", judged.right_value, None),
    ] {
        if let Some(value) = value {
            let kind = kind.map_or_else(String::new, |kind| format!(" ({})", kind.name));
            entry(term, number(value)? + &kind);
        }
    }
    if judged.computed.is_none() {
        entry("Two routes", evidence.iter().map(|kind| kind.name).collect::<Vec<_>>().join(", "));
    }
    let missing = if evidence.is_empty() { "What is missing" } else { "How it was checked" };
    entry(missing, how(judged));
    if let Some(erratum) = &claim.erratum {
        if judged.corrected().is_some() {
            let [printed, corrected] = forms(book, judged)?;
            entry("Printed", printed);
            entry("Right", corrected);
        }
        entry("Why", prose(erratum.slip.reason));
        entry("Second witness", prose(erratum.slip.witness));
        entry("Mistake", mistake(book, judged).unwrap_or_default());
    }
    out.push_str("</dl>");
    Ok(out)
}
