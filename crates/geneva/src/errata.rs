//! The list of errata, in the order of the ledger.

use crate::arguments::ErrataFormat;
use crate::claims::with_unit;
use crate::output::{count, field, heading};
use crate::record::ErratumRow;
use geneva_ledger::{Erratum, Judged, Work, in_full};

/// All errata, as they are wanted.
pub fn page(format: ErrataFormat) -> anyhow::Result<String> {
    let verdicts = geneva_ledger::verdicts();
    match format {
        ErrataFormat::Text => Ok(text(verdicts)),
        ErrataFormat::Json => {
            let rows: Vec<_> = verdicts.iter().filter_map(ErratumRow::of).collect();
            Ok(serde_json::to_string_pretty(&rows)? + "\n")
        }
        ErrataFormat::Markdown => Ok(markdown(verdicts)),
    }
}

/// The claims that carry an erratum, with it.
fn errata(verdicts: &[Judged]) -> impl Iterator<Item = (&Judged, &Erratum)> {
    verdicts.iter().filter_map(|judged| Some((judged, judged.claim.erratum.as_ref()?)))
}

fn text(verdicts: &[Judged]) -> String {
    let bold = heading();
    let mut page = String::new();
    for (judged, erratum) in errata(verdicts) {
        let claim = judged.claim;
        page += &format!("{bold}{}{bold:#}  {}\n", claim.id, claim.locator);
        page += &field("printed", &with_unit(&in_full(claim), claim.unit));
        page += &field("corrected", &with_unit(erratum.corrected, claim.unit));
        page += &field("severity", erratum.severity.slug());
        page += &field("reason", erratum.reason);
        page += &field("witness", erratum.witness);
        if !erratum.inherited_by.is_empty() {
            page += &field("inherited by", &erratum.inherited_by.join(", "));
        }
        page.push('\n');
    }
    let number = errata(verdicts).count();
    page + &if number == 1 { "1 erratum\n".to_owned() } else { format!("{number} errata\n") }
}

fn markdown(verdicts: &[Judged]) -> String {
    let mut page = "# Errata\n".to_owned();
    for work in Work::ALL {
        let of_work: Vec<_> = errata(verdicts).filter(|(judged, _)| judged.claim.work == *work).collect();
        page += &format!("\n## {work}\n\n{}\n\n", work.citation());
        if of_work.is_empty() {
            page += &format!("No erratum in {}.\n", count(work.claims().len(), "claim"));
        }
        for (judged, erratum) in of_work {
            let claim = judged.claim;
            page += &format!("- **{}** ({}, {}). ", claim.locator, code(claim.id), erratum.severity);
            page += &format!(
                "For {} read {}. ",
                code(&with_unit(&in_full(claim), claim.unit)),
                code(&with_unit(erratum.corrected, claim.unit))
            );
            page += &format!("{} *Witness:* {}", erratum.reason, erratum.witness);
            if !erratum.inherited_by.is_empty() {
                let ids: Vec<_> = erratum.inherited_by.iter().map(|id| code(id)).collect();
                page += &format!(" *Inherited by* {}.", ids.join(", "));
            }
            page.push('\n');
        }
    }
    page
}

/// Characters as they stand, whatever they mean in Markdown.
fn code(characters: &str) -> String {
    let longest_run = characters.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest_run + 1);
    let space = if longest_run > 0 { " " } else { "" };
    format!("{fence}{space}{characters}{space}{fence}")
}

#[cfg(test)]
mod tests {
    use super::code;

    #[test]
    fn backticks_in_printed_characters_do_not_end_the_code() {
        assert_eq!(code(r"l=\sqrt{2} R"), r"`l=\sqrt{2} R`");
        assert_eq!(code("a``b"), "``` a``b ```");
    }
}
