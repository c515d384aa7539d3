//! Finding claims and sources by name, with the nearest name in the error.

use anyhow::anyhow;
use geneva_ledger::{Consequence, Judged, Work, verdict, verdicts};

/// The judged claim with this id.
pub fn judged(id: &str) -> anyhow::Result<&'static Judged> {
    verdict(id).ok_or_else(|| {
        let ids = verdicts().iter().map(|judged| judged.claim.id);
        anyhow!("no claim `{id}`{}", nearest(id, ids))
    })
}

/// The source with this slug.
pub fn work(slug: &str) -> anyhow::Result<Work> {
    let found = Work::ALL.iter().find(|work| work.slug() == slug);
    found
        .copied()
        .ok_or_else(|| anyhow!("no source `{slug}`{}", nearest(slug, Work::ALL.iter().map(|work| work.slug()))))
}

/// The consequence with this slug.
pub fn consequence(slug: &str) -> anyhow::Result<Consequence> {
    let found = Consequence::ALL.iter().find(|consequence| consequence.slug() == slug);
    let slugs = Consequence::ALL.iter().map(|consequence| consequence.slug());
    found.copied().ok_or_else(|| anyhow!("no consequence `{slug}`{}", nearest(slug, slugs)))
}

/// The judged claims of a source.
pub fn of_work(work: Work) -> impl Iterator<Item = &'static Judged> {
    verdicts().iter().filter(move |judged| judged.claim.work == work)
}

fn nearest<'a>(name: &str, names: impl Iterator<Item = &'a str>) -> String {
    let closest = names.max_by(|a, b| strsim::jaro(name, a).total_cmp(&strsim::jaro(name, b)));
    closest.map_or_else(String::new, |closest| format!("; the nearest is `{closest}`"))
}
