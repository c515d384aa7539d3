//! Errata: one in its chapter, and the page of all.

use super::forms::how;
use super::inline::{badge, linked_id, rounded, with_unit};
use super::lookup;
use crate::html::{Cells, escape, table, tex_or_text};
use anyhow::anyhow;
use geneva_ledger::{Erratum, Judged, Severity, in_full, verdicts};

/// One erratum, as a box.
pub fn one(id: &str) -> anyhow::Result<String> {
    let judged = lookup::judged(id)?;
    let erratum = judged.claim.erratum.as_ref().ok_or_else(|| anyhow!("claim `{id}` has no erratum"))?;
    boxed(judged, erratum)
}

/// All errata of the sources with these slugs, with spaces between.
pub fn page(slugs: &str) -> anyhow::Result<String> {
    let mut out = String::new();
    for slug in slugs.split_whitespace() {
        let work = lookup::work(slug)?;
        out.push_str(&format!("\n\n## Source {work}\n\n{}\n", escape(work.citation())));
        for judged in lookup::of_work(work) {
            if let Some(erratum) = &judged.claim.erratum {
                out.push_str(&format!("\n{}\n", boxed(judged, erratum)?));
            }
        }
    }
    Ok(out)
}

fn boxed(judged: &Judged, erratum: &Erratum) -> anyhow::Result<String> {
    let claim = judged.claim;
    let mut out = format!(
        "<aside class=\"erratum\" aria-label=\"Erratum {}\">\n<p><strong>Erratum, {}.</strong> {}: {}. {}</p>\n<dl>\n",
        claim.id,
        erratum.severity,
        escape(claim.locator),
        escape(claim.meaning),
        badge(judged.verdict),
    );
    let mut entry = |term: &str, text: String| out.push_str(&format!("<dt>{term}</dt><dd>{text}</dd>\n"));
    entry("Printed", with_unit(&tex_or_text(&in_full(claim))?, claim.unit)?);
    entry("Should be", with_unit(&tex_or_text(erratum.corrected)?, claim.unit)?);
    let evidence = claim.check.evidence();
    for (term, number, kind) in [
        ("Computed", judged.computed, evidence.first()),
        ("Second witness's number", judged.witnessed, evidence.last()),
    ] {
        if let (Some(number), Some(kind)) = (number, kind) {
            entry(term, format!("{} ({kind})", with_unit(&rounded(judged, number), claim.unit)?));
        }
    }
    entry("Why", escape(erratum.reason));
    entry("Second witness", escape(erratum.witness));
    if !judged.findings.is_empty() {
        entry("How it was found", how(judged));
    }
    if !erratum.inherited_by.is_empty() {
        let links: Vec<_> = erratum.inherited_by.iter().map(|id| linked_id(id)).collect();
        entry("Inherited by", links.join(", "));
    }
    out.push_str(&format!("</dl>\n<p>{}</p>\n</aside>", linked_id(claim.id)));
    Ok(out)
}

/// How many errata there are of each severity.
pub fn summary() -> String {
    let rows: Vec<_> = Severity::ALL
        .iter()
        .map(|severity| {
            let graded = verdicts().iter().filter_map(|judged| judged.claim.erratum.as_ref());
            let count = graded.filter(|erratum| erratum.severity == *severity).count();
            vec![severity.to_string(), meaning(*severity).to_owned(), count.to_string()]
        })
        .collect();
    table("Errata by kind of slip", Cells::Words, &["Kind of slip", "What it means", "Errata"], &rows)
}

fn meaning(severity: Severity) -> &'static str {
    match severity {
        Severity::Transcription => "the copy lost or changed a character; the original is not to blame",
        Severity::Typographical => {
            "a slip of the pen or a misprint of the source: a wrong or missing word, sign or symbol"
        }
        Severity::Arithmetical => "a wrong or carelessly rounded computation",
        Severity::Conceptual => "a wrong idea",
    }
}
