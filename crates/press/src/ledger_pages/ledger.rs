//! The page of all claims: a row for each, and what is known of a claim, which a reader asks for.
//!
//! What is known of all claims together weighs more than all rows. It stands in a script of its own, which the page loads
//! when the first claim is opened. Without scripts every row is there, and `claims.json` has the rest.

use super::errata::forms;
use super::findings::{how, in_words};
use super::inline::{computed, place, rounded, with_unit};
use super::open;
use crate::data::{FOLDER, File};
use crate::formula::broken;
use crate::html::{prose, tex_or_text};
use crate::lookup;
use crate::pages::{SECTIONS, Section, page_of_slip};
use crate::units::tied_without_tags;
use geneva_documents::LEDGER;
use geneva_evidence::{Consequence, Judged, Kind, Truth, Verdict, without_ellipses};
use std::collections::BTreeMap;

/// What filters the rows and opens them, and how they look.
const SCRIPT: &str = include_str!("../../../../book/theme/ledger.js");
const STYLE: &str = include_str!("../../../../book/theme/ledger.css");
const SCRIPT_NAME: &str = "ledger.js";
const STYLE_NAME: &str = "ledger.css";
const DETAILS_NAME: &str = "ledger-details.js";

/// The choice of the sources that the totals of the book's first page are about.
const DOCUMENTS: &str = "documents";
/// The choice of what is wrong only in the copy, and the class of such a row: the first page counts these apart.
const MISCOPIED: &str = "miscopied";

/// All claims, by section and in the order of the sources, with the filter and what it must load.
pub fn page() -> anyhow::Result<String> {
    let sections = SECTIONS.iter().map(section).collect::<anyhow::Result<String>>()?;
    Ok(format!(
        "<link rel=\"stylesheet\" href=\"{FOLDER}/{STYLE_NAME}\">\n\n{}\n\n{sections}\n\n<script src=\"{FOLDER}/{SCRIPT_NAME}\" \
         defer></script>\n",
        filter()
    ))
}

/// The scripts and the style of the page, and what is known of each claim.
pub fn files() -> anyhow::Result<[File; 3]> {
    let details = LEDGER.verdicts().iter().map(|judged| Ok((judged.claim.id, tied_without_tags(&details(judged)?))));
    let details: BTreeMap<_, _> = details.collect::<anyhow::Result<_>>()?;
    // A claim a line, so that two editions can be compared.
    let text = serde_json::to_string(&details)?.replace("\",\"", "\",\n\"");
    Ok([
        File::script(SCRIPT_NAME, SCRIPT.to_owned()),
        File::script(STYLE_NAME, STYLE.to_owned()),
        File::script(DETAILS_NAME, format!("genevaDetails({text});\n")),
    ])
}

/// The form that filters, which the script shows.
fn filter() -> String {
    let option = |value: &str, more: &str, text: &str| format!("<option value=\"{value}\"{more}>{text}</option>");
    let select = |name: &str, label: &str, options: String| {
        format!("<label>{label} <select name=\"{name}\"><option value=\"\">all</option>{options}</select></label>")
    };
    let sources = LEDGER.documents().iter().map(|work| option(work.slug, "", work.title));
    let sources = [option(DOCUMENTS, "", "the four documents")].into_iter().chain(sources).collect();
    let verdicts = Verdict::ALL.iter().map(|verdict| {
        option(verdict.slug(), &format!(" data-truth=\"{}\"", verdict.truth().slug()), &verdict.to_string())
    });
    let [right, wrong, open] =
        [Truth::Right, Truth::Wrong, Truth::Open].map(|truth| option(truth.slug(), "", truth.slug()));
    let truths = [right, wrong, option(MISCOPIED, "", "wrong only in the copy"), open].concat();
    let kinds = Kind::ALL.iter().map(|kind| option(kind.slug(), "", kind_name(*kind))).collect();
    format!(
        "<form class=\"filter\" role=\"search\" aria-label=\"Filter the claims\" hidden><label>Words <input type=\"search\" \
         name=\"words\"></label>{}{}{}{}<p><output></output> <button type=\"reset\">Show all</button></p></form>",
        select("source", "Source", sources),
        select("truth", "Is it right?", truths),
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
fn section(section: &Section) -> anyhow::Result<String> {
    let rows = section.ids().map(|id| row(lookup::judged(id)?)).collect::<anyhow::Result<String>>()?;
    let (title, name, work) = (section.title, section.name, section.work.slug);
    Ok(format!("## {title} {{#{name}}}\n\n<ul class=\"claims\" data-source=\"{work}\">\n{rows}</ul>\n\n"))
}

/// A claim: its id, our verdict, where it stands, what it says, what is printed, and what was found, in a line.
fn row(judged: &Judged) -> anyhow::Result<String> {
    let (claim, verdict) = (judged.claim, judged.verdict);
    let printed = with_unit(&tex_or_text(&without_ellipses(claim))?, claim.unit)?;
    let printed = match computed(judged) {
        Some(computed) => format!("<div>{printed}, computed {computed}{}</div>", right(judged)),
        // A form may be wider than the page; one whose lines are aligned scrolls, and so takes the focus.
        None => {
            let focus = if printed.contains("<mtable") { " tabindex=\"0\"" } else { "" };
            format!("<div class=\"form\"{focus}>{}</div>", broken(&printed))
        }
    };
    let found = found(judged);
    let found = if found.is_empty() { found } else { format!("<small>{found}</small>") };
    let miscopied = if judged.is_miscopied() { format!(" {MISCOPIED}") } else { String::new() };
    Ok(format!(
        "<li id=\"{0}\" class=\"{1} {2}{miscopied}\"><code>{0}</code> <b>{verdict}</b> <small>{3}</small><p>{4}</p>{printed}{found}</li>\n",
        claim.id,
        claim.kind.slug(),
        verdict.slug(),
        place(claim),
        prose(claim.meaning),
    ))
}

/// What is right, where what was computed is not.
fn right(judged: &Judged) -> String {
    let in_error = judged.right_value.filter(|right| judged.computed != Some(*right));
    in_error.map_or_else(String::new, |right| format!(", right {}", rounded(judged, right)))
}

/// What was found, in a line: the mistake, what is missing, or how the printed form holds.
fn found(judged: &Judged) -> String {
    let mistake = mistake(judged).map(|link| format!("Mistake: {link}"));
    let missing = open::group_of(judged).map(|group| format!("Open: {}", group.link()));
    let holds = judged.findings.first().map(|(_, finding)| in_words(&finding.how));
    [mistake, missing, holds].into_iter().flatten().collect::<Vec<_>>().join(". ")
}

/// The mistake that reaches a claim, as a link to where it is told.
fn mistake(judged: &Judged) -> Option<String> {
    let slip = &judged.claim.erratum.as_ref()?.slip;
    let what = match slip.consequence {
        Consequence::Copy => "only in the copy".to_owned(),
        other => other.to_string(),
    };
    Some(format!("<a href=\"{}.html#slip-{}\">{what}</a>", page_of_slip(slip), slip.id))
}

/// All that is known of a claim besides its row.
fn details(judged: &Judged) -> anyhow::Result<String> {
    let (claim, evidence) = (judged.claim, judged.claim.check.evidence());
    let mut out = "<dl>".to_owned();
    let mut entry = |term: &str, text: String| {
        if !text.is_empty() {
            out.push_str(&format!("<dt>{term}</dt><dd>{text}</dd>"));
        }
    };
    let number = |number: f64| with_unit(&rounded(judged, number), claim.unit);
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
            let [printed, corrected] = forms(judged)?;
            entry("Printed", printed);
            entry("Right", corrected);
        }
        entry("Why", prose(erratum.slip.reason));
        entry("Second witness", prose(erratum.slip.witness));
        entry("Mistake", mistake(judged).unwrap_or_default());
    }
    out.push_str("</dl>");
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_claim_has_a_row_and_every_row_has_details() {
        let page = page().expect("a page");
        let [_, _, details] = files().expect("files");
        for judged in LEDGER.verdicts() {
            let id = judged.claim.id;
            let row = format!("<li id=\"{id}\" class=\"{} {}", judged.claim.kind.slug(), judged.verdict.slug());
            assert_eq!(page.matches(&row).count(), 1, "{id}");
            assert_eq!(details.text().matches(&format!("\"{id}\":\"<dl><dt>")).count(), 1, "{id}");
        }
        assert_eq!(page.matches("<li ").count(), LEDGER.verdicts().len());
    }

    #[test]
    fn the_filter_offers_what_the_rows_have() {
        let filter = filter();
        for judged in LEDGER.verdicts() {
            for value in
                [judged.claim.document.slug, judged.verdict.slug(), judged.truth().slug(), judged.claim.kind.slug()]
            {
                assert!(filter.contains(&format!("<option value=\"{value}\"")), "{value}");
            }
        }
    }

    #[test]
    fn a_row_says_in_a_line_what_was_found() {
        for judged in LEDGER.verdicts() {
            let (id, found) = (judged.claim.id, found(judged));
            let says = match judged.truth() {
                Truth::Open => found.starts_with("Open: "),
                Truth::Wrong => judged.claim.erratum.is_some() == found.starts_with("Mistake: "),
                Truth::Right => judged.computed.is_some() || !found.is_empty(),
            };
            assert!(says, "{id}: {found}");
        }
    }
}
