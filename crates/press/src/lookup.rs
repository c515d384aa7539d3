//! Finding things by name; the error tells the nearest name.

use anyhow::anyhow;
use geneva_evidence::{Claim, Consequence, Document, Judged, Ledger, nearest_name};

/// What bears this name in a list. The error tells the nearest name and all there are.
pub fn find_named<T: Copy>(what: &str, name: &str, list: &[(&str, T)]) -> anyhow::Result<T> {
    let found = list.iter().find(|(known, _)| *known == name).map(|(_, found)| *found);
    found.ok_or_else(|| {
        let names: Vec<_> = list.iter().map(|(name, _)| *name).collect();
        anyhow!("{}; there are: {}", unknown(what, name, names.iter().copied()), names.join(", "))
    })
}

/// The claim with this id, without its verdict.
pub fn claim(ledger: &'static Ledger, id: &str) -> anyhow::Result<&'static Claim> {
    ledger.claim(id).ok_or_else(|| unknown("claim", id, ledger.claims().iter().map(|claim| claim.id)))
}

/// The judged claim with this id.
pub fn verdict(ledger: &'static Ledger, id: &str) -> anyhow::Result<&'static Judged> {
    ledger.verdict(id).ok_or_else(|| unknown("claim", id, ledger.claims().iter().map(|claim| claim.id)))
}

/// The source with this slug.
pub fn document(ledger: &'static Ledger, slug: &str) -> anyhow::Result<&'static Document> {
    let names = || ledger.documents().iter().map(|document| document.slug);
    ledger.document(slug).ok_or_else(|| unknown("source", slug, names()))
}

/// The consequence with this slug.
pub fn consequence(slug: &str) -> anyhow::Result<Consequence> {
    let found = Consequence::ALL.iter().copied().find(|consequence| consequence.slug() == slug);
    found.ok_or_else(|| unknown("consequence", slug, Consequence::ALL.iter().map(|consequence| consequence.slug())))
}

/// The judged claims of a source.
pub fn verdicts_of(ledger: &'static Ledger, document: &'static Document) -> impl Iterator<Item = &'static Judged> {
    ledger.verdicts_of(document).into_iter()
}

/// The judged claims of the mirrored documents: without what is said elsewhere.
pub fn verdicts_of_documents(ledger: &'static Ledger) -> impl Iterator<Item = &'static Judged> {
    ledger.verdicts().iter().copied().filter(|judged| judged.claim.document.is_mirrored())
}

/// That nothing of this kind bears the name, with the nearest that something bears.
pub fn unknown<'a>(what: &str, name: &str, names: impl Iterator<Item = &'a str>) -> anyhow::Error {
    let nearest = nearest_name(name, names).map_or_else(String::new, |closest| format!("; the nearest is `{closest}`"));
    anyhow!("no {what} `{name}`{nearest}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_name_is_answered_with_the_nearest_and_those_there_are() {
        let error = find_named("table", "terms", &[("quick-return-terms", 0), ("joints", 1)]).expect_err("unknown");
        let expected = "no table `terms`; the nearest is `quick-return-terms`; there are: quick-return-terms, joints";
        assert_eq!(error.to_string(), expected);
        let error = consequence("resuld").expect_err("unknown").to_string();
        assert_eq!(error, "no consequence `resuld`; the nearest is `result`");
    }
}
