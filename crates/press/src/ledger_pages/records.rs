//! What the pages of the records list: all claims, all slips, the sources line by line.

use super::errata;
use super::findings::how;
use super::inline::{badge, computed, place, rounded, with_unit};
use crate::formula::broken;
use crate::html::{Cells, escape, table, tex_or_text};
use crate::lookup;
use crate::pages::{PAGES, Records, Section, page_of_claim, page_of_slip};
use anyhow::{Context, bail};
use geneva_ledger::{Entry, Judged, Work, in_full};

/// What the list of pages puts on the page of this name.
pub fn page(name: &str) -> anyhow::Result<String> {
    let page = PAGES.iter().find(|page| page.name == name).with_context(|| format!("no page `{name}` in the list"))?;
    match &page.records {
        Records::None => bail!("the list of pages puts no records on `{name}`"),
        Records::Claims(sections) => sections.iter().map(claims).collect(),
        Records::Slips(consequences) => consequences.iter().map(errata::all).collect(),
        Records::Lines(works) => works.iter().map(lines).collect(),
    }
}

/// The claims of a section; every row can be linked to by the claim's id.
fn claims(section: &Section) -> anyhow::Result<String> {
    let head = ["Claim", "Verdict and evidence", "Printed and computed"];
    let title = format!("Source {}: {}", section.work, section.title);
    let rows = section.ids().map(|id| claim(lookup::judged(id)?));
    Ok(format!("## {title}\n\n{}\n\n", table(&title, Cells::Words, &head, rows)?.html()))
}

fn claim(judged: &Judged) -> anyhow::Result<Vec<String>> {
    let claim = judged.claim;
    let evidence: Vec<_> = claim.check.evidence().iter().map(ToString::to_string).collect();
    let evidence = evidence.join(", ");
    let checked = match (judged.computed, evidence.is_empty()) {
        (Some(_), _) => evidence,
        (None, true) => how(judged),
        (None, false) => format!("<details><summary>{evidence}</summary>{}</details>", how(judged)),
    };
    let name =
        format!("<code id=\"{0}\">{0}</code> <small>{1}: {2}</small>", claim.id, place(claim), escape(claim.meaning));
    let printed = with_unit(&tex_or_text(&in_full(claim))?, claim.unit)?;
    // A form needs more room than a column of numbers has.
    let (name, numbers) = match computed(judged) {
        Some(computed) => (name, format!("{printed}<br>computed {computed}{}", right(judged))),
        None => (format!("{name}<div class=\"form\">{}</div>", broken(&printed)), "–".to_owned()),
    };
    Ok(vec![name, format!("{}{} <div>{checked}</div>", badge(judged.verdict), slip(judged)), numbers])
}

/// What is right, where what was computed is not.
fn right(judged: &Judged) -> String {
    let in_error = judged.right_value.filter(|right| judged.computed != Some(*right));
    in_error.map_or_else(String::new, |right| format!("<br>right {}", rounded(judged, right)))
}

/// The slip that reaches a claim, as a link to where it is told.
fn slip(judged: &Judged) -> String {
    let Some(erratum) = &judged.claim.erratum else { return String::new() };
    let page = page_of_slip(&erratum.slip);
    format!("<br><a href=\"{page}.html#slip-{}\">{}</a>", erratum.slip.id, erratum.slip.consequence)
}

/// A source line by line: which claims stand where, and what is no claim, with the reason.
fn lines(work: &Work) -> anyhow::Result<String> {
    let lines = work.inventory()?;
    let numbers: usize = lines.iter().map(|line| line.numbers.len()).sum();
    if let Some(line) = lines.iter().find(|line| !line.is_accounted_for()) {
        bail!("line {} of {work} has numbers that nothing accounts for", line.number);
    }
    let all = lines.iter().map(|line| {
        // As text, not as code: there are many on a page.
        let link = |id: &str| format!("<a href=\"{}.html#{id}\">{id}</a>", page_of_claim(id));
        let claims: Vec<_> = line.entries.iter().filter_map(|entry| entry.claimed()).map(link).collect();
        Ok(vec![
            line.number.to_string(),
            if claims.is_empty() { "–".to_owned() } else { claims.join(", ") },
            line.numbers.len().to_string(),
        ])
    });
    let exceptions = lines.iter().flat_map(|line| {
        line.entries.iter().filter_map(|entry| match entry {
            Entry::Exception { id, reason, .. } => {
                Some(Ok(vec![format!("<code>{id}</code>"), line.number.to_string(), escape(reason)]))
            }
            _ => None,
        })
    });
    Ok(format!(
        "## Source {work}\n\n{} claims, with the labels of equations and figures and the exceptions below, account for \
         all {numbers} numbers in {} lines.\n\n{}\n\n### No claims: {work}\n\n{}\n\n",
        lookup::of_work(*work).count(),
        lines.len(),
        table(&format!("Lines of {work}"), Cells::Words, &["Line", "Claims", "Numbers"], all)?.html(),
        table(
            &format!("Exceptions of {work}"),
            Cells::Words,
            &["Exception", "Line", "Why there is nothing to check"],
            exceptions
        )?
        .html(),
    ))
}
