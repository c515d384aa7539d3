//! The error beside an answer when a claim no longer matches the record.

use crate::output::{OutputStreams, TextLayout, count};
use clap::builder::styling::AnsiColor;
use geneva_evidence::Judged;

/// At most this many claims are named.
const MOST: usize = 10;

/// Names on standard error the claims that no longer match the record, if there are any.
pub(crate) fn report_differing<'a>(verdicts: impl IntoIterator<Item = &'a Judged>, streams: &mut dyn OutputStreams) {
    let differing: Vec<_> = verdicts.into_iter().filter(|judged| !judged.matches_record()).collect();
    if !differing.is_empty() {
        streams.write_stderr(&page(&differing));
    }
}

/// A line or two for each claim: the recorded verdict, the derived one, and where the claim is stated. A narrower terminal has its
/// lines folded, as all that it is told.
fn page(differing: &[&Judged]) -> String {
    let layout = TextLayout::default();
    let red = AnsiColor::Red.on_default().bold();
    let matches = if differing.len() == 1 { "matches" } else { "match" };
    let mut page = format!("{red}error:{red:#} {} no longer {matches} the record\n", count(differing.len(), "claim"));
    for judged in differing.iter().take(MOST) {
        let (claim, at) = (judged.claim, judged.claim.stated_at);
        if judged.verdict == claim.expected {
            page += &format!("  {}: still {}, but\n", claim.id, claim.expected);
            judged.faults.iter().for_each(|fault| page += &layout.wrapped("    ", fault));
        } else {
            page += &format!("  {}: recorded as {}, now {}\n", claim.id, claim.expected, judged.verdict);
        }
        page += &format!("    {}:{}\n", at.file(), at.line());
    }
    if let Some(more) = differing.len().checked_sub(MOST).filter(|more| *more > 0) {
        page += &format!("  and {more} more\n");
    }
    page + &layout.wrapped("", REMEDY)
}

const REMEDY: &str = "Compare the printed characters with the source. If they are right, either the calculation or the \
                      recorded verdict is wrong. Run `geneva` without arguments to see what each check found.";

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_documents::PIN;
    use geneva_evidence::{Evidence, Locator, judge};

    /// A claim that no source makes, with these digits for seven thirds.
    fn judged(printed: &'static str) -> Judged {
        let claim = Locator::new(&PIN, "Nowhere, line 1")
            .value("pin.made-up", printed, "mm", "seven thirds")
            .first_route(Evidence::CLOSED_FORM, || 7.0 / 3.0)
            .second_route(Evidence::LIMIT_CASE, || 7.0 / 3.0);
        judge(Box::leak(Box::new(claim)))
    }

    #[test]
    fn a_claim_that_differs_is_named_with_both_verdicts_and_its_file() {
        let page = page(&[&judged("2.43")]);
        for part in [
            "1 claim no longer matches the record\n",
            "  pin.made-up: recorded as reproduced, now not-reproduced\n",
            "differing.rs:",
            "Compare the printed characters",
        ] {
            assert!(page.contains(part), "{part} is not in:\n{page}");
        }
    }

    #[test]
    fn ten_are_named_and_the_others_counted() {
        let one = judged("2.43");
        for (all, more) in [(10, None), (11, Some("  and 1 more\n"))] {
            let page = page(&vec![&one; all]);
            assert_eq!(page.matches("pin.made-up").count(), MOST, "{page}");
            assert_eq!(page.contains(" more\n"), more.is_some(), "{page}");
            assert!(more.is_none_or(|more| page.contains(more)), "{page}");
        }
    }
}
