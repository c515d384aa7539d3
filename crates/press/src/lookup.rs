//! Finding things by name; the error tells the nearest name or all there are.

use anyhow::anyhow;
use geneva_documents::LEDGER;
use geneva_evidence::Document;
use geneva_evidence::{Claim, Consequence, Judged};

/// What bears this name in a list.
pub fn named<T: Copy>(what: &str, name: &str, list: &[(&str, T)]) -> anyhow::Result<T> {
    let found = list.iter().find(|(known, _)| *known == name).map(|(_, found)| *found);
    found.ok_or_else(|| {
        let names: Vec<_> = list.iter().map(|(name, _)| *name).collect();
        anyhow!("no {what} `{name}`; there are: {}", names.join(", "))
    })
}

/// The claim with this id, without its verdict.
pub fn claim(id: &str) -> anyhow::Result<&'static Claim> {
    let found = LEDGER.claims().iter().copied().find(|claim| claim.id == id);
    found.ok_or_else(|| unknown("claim", id, LEDGER.claims().iter().map(|claim| claim.id)))
}

/// The judged claim with this id.
pub fn judged(id: &str) -> anyhow::Result<&'static Judged> {
    LEDGER.verdict(id).ok_or_else(|| unknown("claim", id, LEDGER.claims().iter().map(|claim| claim.id)))
}

/// The source with this slug.
pub fn work(slug: &str) -> anyhow::Result<&'static Document> {
    let found = LEDGER.documents().iter().copied().find(|work| work.slug == slug);
    found.ok_or_else(|| unknown("source", slug, LEDGER.documents().iter().map(|work| work.slug)))
}

/// The consequence with this slug.
pub fn consequence(slug: &str) -> anyhow::Result<Consequence> {
    let found = Consequence::ALL.iter().copied().find(|consequence| consequence.slug() == slug);
    found.ok_or_else(|| unknown("consequence", slug, Consequence::ALL.iter().map(|consequence| consequence.slug())))
}

/// The judged claims of a source.
pub fn of_work(work: &'static Document) -> impl Iterator<Item = &'static Judged> {
    LEDGER.verdicts_of(work).into_iter()
}

/// The judged claims of the documents: without what is said elsewhere.
pub fn of_documents() -> impl Iterator<Item = &'static Judged> {
    LEDGER.verdicts().iter().copied().filter(|judged| judged.claim.document.is_mirrored())
}

/// That nothing of this kind bears the name, with the nearest that something bears.
pub fn unknown<'a>(what: &str, name: &str, names: impl Iterator<Item = &'a str>) -> anyhow::Error {
    let closest = names.max_by(|a, b| strsim::jaro(name, a).total_cmp(&strsim::jaro(name, b)));
    let nearest = closest.map_or_else(String::new, |closest| format!("; the nearest is `{closest}`"));
    anyhow!("no {what} `{name}`{nearest}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_name_is_answered_with_those_there_are() {
        let error = named("table", "terms", &[("quick-return-terms", 0), ("joints", 1)]).expect_err("unknown");
        assert_eq!(error.to_string(), "no table `terms`; there are: quick-return-terms, joints");
        let error = work("jasar").expect_err("unknown").to_string();
        assert_eq!(error, "no source `jasar`; the nearest is `jazar`");
    }
}
