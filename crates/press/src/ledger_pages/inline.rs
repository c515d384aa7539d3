//! Pieces of the ledger inside a sentence.

use crate::html::{escape, tex_or_text};
use crate::pages::page_of_claim;
use crate::{lookup, maths, numbers};
use anyhow::anyhow;
use geneva_ledger::{Decimal, Judged, Verdict, claims, in_full};

/// The printed characters with their unit.
pub fn printed(id: &str) -> anyhow::Result<String> {
    let claim = lookup::judged(id)?.claim;
    Ok(format!("<span class=\"claim\">{}</span>", with_unit(&tex_or_text(&in_full(claim))?, claim.unit)?))
}

/// The computed number with its unit.
pub fn value(id: &str) -> anyhow::Result<String> {
    let judged = lookup::judged(id)?;
    let number = computed(judged).ok_or_else(|| anyhow!("claim `{id}` computes no number"))?;
    Ok(format!("<span class=\"claim\">{}</span>", with_unit(&number, judged.claim.unit)?))
}

/// The right number with its unit, where the printed one is not right.
pub fn right(id: &str) -> anyhow::Result<String> {
    let judged = lookup::judged(id)?;
    let right = judged.right_value.ok_or_else(|| anyhow!("claim `{id}` has no other number that is right"))?;
    Ok(format!("<span class=\"claim\">{}</span>", with_unit(&rounded(judged, right), judged.claim.unit)?))
}

/// The printed characters with their unit and verdict.
pub fn claim(id: &str) -> anyhow::Result<String> {
    Ok(format!("{}&nbsp;({})", printed(id)?, verdict(id)?))
}

/// The verdict, as a link to the claim's row in the ledger.
pub fn verdict(id: &str) -> anyhow::Result<String> {
    Ok(linked_badge(lookup::judged(id)?))
}

/// The number of claims of a source, or of `all`.
pub fn count(of: &str) -> anyhow::Result<String> {
    match of {
        "all" => Ok(claims().len().to_string()),
        slug => Ok(lookup::of_work(lookup::work(slug)?).count().to_string()),
    }
}

/// What the source is.
pub fn citation(slug: &str) -> anyhow::Result<String> {
    Ok(escape(lookup::work(slug)?.citation()))
}

/// The verdict of a claim as a badge that leads to the claim's row in the ledger.
pub fn linked_badge(judged: &Judged) -> String {
    let (id, page) = (judged.claim.id, page_of_claim(judged.claim.id));
    format!("<a class=\"to-ledger\" href=\"{page}.html#{id}\">{}</a>", badge(judged.verdict))
}

/// The id of a claim, leading to its row in the ledger.
pub fn linked_id(id: &str) -> String {
    format!("<a href=\"{}.html#{id}\"><code>{id}</code></a>", page_of_claim(id))
}

/// A verdict as a badge: the word, to which style only adds.
pub fn badge(verdict: Verdict) -> String {
    format!("<span class=\"verdict verdict-{verdict}\">{verdict}</span>")
}

/// The computed number, with some places more than the printed one.
pub fn computed(judged: &Judged) -> Option<String> {
    Some(rounded(judged, judged.computed?))
}

/// A number beside the printed one of a claim, with some places more.
pub fn rounded(judged: &Judged, number: f64) -> String {
    let printed: Option<Decimal> = judged.claim.printed.parse().ok();
    let places = match printed {
        // A fraction has no last place to go by.
        Some(_) if judged.claim.printed.contains('/') => 2 * Decimal::MORE_PLACES,
        Some(decimal) => decimal.places() as usize + Decimal::MORE_PLACES,
        None => Decimal::MORE_PLACES,
    };
    numbers::fixed(number, places)
}

/// A number, already HTML, with its unit behind.
pub fn with_unit(number: &str, unit: &str) -> anyhow::Result<String> {
    Ok(match unit {
        "" => number.to_owned(),
        "°" => format!("{number}°"),
        _ if unit.ends_with("^2") => format!("{number}&nbsp;{}²", escape(unit.trim_end_matches("^2"))),
        // Lengths in crank radii have a letter for a unit.
        "R" => format!("{number}&nbsp;{}", maths::formula("R", false)?),
        _ => format!("{number}&nbsp;{}", tex_or_text(unit)?.replace("10&#94;-6", "10<sup>−6</sup>")),
    })
}
