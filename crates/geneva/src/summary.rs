//! A summary of all verdicts: a small table, and every claim that no longer matches the record.

use crate::output::{TextLayout, count, field, heading, style};
use geneva_documents::LEDGER;
use geneva_evidence::Document;
use geneva_evidence::{Consequence, Judged, Kind, PlainVerdict, without_ellipses};

/// The verdicts of the documents by source, and each claim, also on pages elsewhere, that no longer matches the record.
pub(crate) fn page(verdicts: &[&Judged], layout: TextLayout) -> String {
    table(verdicts, layout) + "\n" + &differences(verdicts, layout)
}

/// How many statements and examples on pages elsewhere are right and wrong, if all match the record.
fn elsewhere(verdicts: &[&Judged], layout: TextLayout) -> String {
    let tally = |name: &str, examples: bool| {
        let of_kind =
            |judged: &&Judged| !judged.claim.document.is_mirrored() && (judged.claim.kind == Kind::Example) == examples;
        let number =
            |of: &dyn Fn(&Judged) -> bool| verdicts.iter().copied().filter(of_kind).filter(|judged| of(judged)).count();
        let parts = PlainVerdict::ALL.iter().map(|plain| (number(&|judged| judged.plain() == *plain), plain.words()));
        let parts: Vec<_> =
            parts.filter(|(number, _)| *number > 0).map(|(number, what)| format!("{number} {what}")).collect();
        let all = number(&|_| true);
        (all > 0).then(|| format!("{} ({})", count(all, name), parts.join(", ")))
    };
    let tallies: Vec<_> = [tally("statement", false), tally("example", true)].into_iter().flatten().collect();
    if tallies.is_empty() {
        return String::new();
    }
    layout.wrapped(
        "",
        &format!("Elsewhere {}: all verdicts match the record. See geneva claims --source wild", tallies.join(" and ")),
    )
}

/// The row of the claims that no longer match the record.
const CHANGED: &str = "changed since recorded";

fn table(verdicts: &[&Judged], layout: TextLayout) -> String {
    let names = PlainVerdict::ALL.iter().map(|verdict| verdict.words()).chain([CHANGED]);
    let label = names.map(str::len).max().unwrap_or(0);
    let columns: Vec<(&str, Option<&'static Document>)> =
        LEDGER.mirrored().iter().map(|work| (work.slug, Some(*work))).chain([("all", None)]).collect();
    let width = |title: &str| title.len().max(5);
    // Two blanks between columns, or one where they take the room.
    let least: usize = columns.iter().map(|(title, _)| 2 + width(title)).sum();
    let gap = if label + least > layout.width() { 1 } else { 2 };
    let line = |name: &str, cell: &dyn Fn(&str, Option<&'static Document>) -> String| -> String {
        let cell = |(title, work): &(&str, Option<&'static Document>)| {
            format!("{:gap$}{:>width$}", "", cell(title, *work), width = width(title))
        };
        let cells = columns.iter().map(cell);
        format!("{name:<label$}{}", cells.collect::<String>())
    };
    let tally = |wanted: &dyn Fn(&Judged) -> bool, work: Option<&'static Document>| {
        let number = verdicts
            .iter()
            .filter(|judged| {
                work.map_or(judged.claim.document.is_mirrored(), |work| judged.claim.document == work) && wanted(judged)
            })
            .count();
        if number == 0 { "–".to_owned() } else { number.to_string() }
    };

    let bold = heading();
    let mut table = format!("{bold}{}{bold:#}\n", line("verdict", &|title, _| title.to_owned()));
    for verdict in PlainVerdict::ALL {
        let (colour, words) = (style(*verdict), verdict.words());
        let row = line(words, &|_, work| tally(&|judged| judged.plain() == *verdict, work));
        table += &format!("{colour}{}{colour:#}{}\n", &row[..words.len()], &row[words.len()..]);
    }
    table += &format!("\n{}\n", line("all claims", &|_, work| tally(&|_| true, work)));
    table + &format!("{}\n", line(CHANGED, &|_, work| tally(&|judged| !judged.matches_record(), work)))
}

fn differences(verdicts: &[&Judged], layout: TextLayout) -> String {
    let field = |name, text: &str| field(name, text, layout);
    let differing: Vec<_> = verdicts.iter().filter(|judged| !judged.matches_record()).collect();
    if differing.is_empty() {
        let documents = verdicts.iter().filter(|judged| judged.claim.document.is_mirrored()).count();
        let stands = format!("{}: all verdicts match the record.\n", count(documents, "claim"));
        return stands + &layout.wrapped("", &wrong()) + &elsewhere(verdicts, layout);
    }
    let bold = heading();
    let mut page = format!("{} of {} changed since recorded:\n", differing.len(), count(verdicts.len(), "claim"));
    for judged in differing {
        let claim = judged.claim;
        page += &layout.folded(&format!("\n{bold}{}{bold:#}  {}\n", claim.id, claim.locator));
        page += &field("printed", &claim.with_unit(&without_ellipses(claim)));
        if let Some(computed) = judged.computed {
            page += &field("computed", &computed.to_string());
        }
        page += &field("expected", claim.expected.slug());
        page += &field("found", judged.verdict.slug());
        for (form, finding) in &judged.findings {
            let holds = if finding.holds { "holds" } else { "fails" };
            page += &field(form, &format!("{holds}: {}", finding.how));
        }
        for complaint in judged.complaints() {
            page += &layout.wrapped("  - ", &complaint);
        }
    }
    page + "\n"
}

/// How many mistakes the sources have, by consequence. What the copy has lost is not among them.
fn wrong() -> String {
    let of = |consequence| LEDGER.slips_of(consequence).count();
    let told = Consequence::ALL.iter().filter(|consequence| **consequence != Consequence::Copy);
    let all: usize = told.clone().map(|consequence| of(*consequence)).sum();
    let parts: Vec<_> = told.map(|consequence| format!("{} {consequence}", of(*consequence))).collect();
    format!("{} in the sources ({}). See geneva errata", count(all, "mistake"), parts.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Arguments, Command, claims, errata};
    use clap::Parser;
    use geneva_documents::{PIN, WILD};
    use geneva_evidence::{Evidence, Locator, judge};
    use geneva_host::layout::columns;

    /// A claim that no source makes, with these digits for seven thirds.
    fn judged(printed: &'static str) -> Judged {
        judged_in(&PIN, printed)
    }

    /// An example that is right, and that no source builds.
    fn example() -> Judged {
        let fits =
            |stated: geneva_evidence::Stated| geneva_evidence::Finding::new(stated.pick(true, false), "seven thirds");
        let claim = Locator::new(&WILD, "Nowhere")
            .example("wild.made-up", "7/3", "sizes")
            .first_route(Evidence::CLOSED_FORM, fits)
            .second_route(Evidence::LIMIT_CASE, fits)
            .but_not("8/3");
        judge(Box::leak(Box::new(claim)))
    }

    fn judged_in(work: &'static Document, printed: &'static str) -> Judged {
        let place = Locator::new(work, "Nowhere, line 1");
        let claim = place
            .value("pin.made-up", printed, "mm", "seven thirds")
            .first_route(Evidence::CLOSED_FORM, || 7.0 / 3.0)
            .second_route(Evidence::LIMIT_CASE, || 7.0 / 3.0);
        judge(Box::leak(Box::new(claim)))
    }

    #[test]
    fn a_claim_that_differs_is_shown_with_all_that_is_known() {
        let page = page(&[&judged("2.33"), &judged("2.43")], TextLayout::default());
        for part in
            ["1 of 2 claims", "2.43 mm", "expected      reproduced", "found         not-reproduced", "recorded as"]
        {
            assert!(page.contains(part), "{part} is not in:\n{page}");
        }
        assert_eq!(page.matches("Nowhere, line 1").count(), 1);
    }

    #[test]
    fn every_list_of_claims_and_mistakes_fits_into_every_terminal() {
        let all = LEDGER.verdicts();
        for width in [60, 80, 100] {
            let layout = TextLayout::for_columns(width);
            let pages = ["claims", "errata --all", "errata --source wild --all"].map(|line| {
                let line = ["geneva"].into_iter().chain(line.split(' '));
                match Arguments::parse_from(line).command {
                    Some(Command::Claims(wanted)) => claims::page(&wanted, layout),
                    Some(Command::Errata(wanted)) => errata::page(&wanted, layout),
                    other => panic!("{other:?}"),
                }
            });
            let pages = pages.into_iter().map(|page| page.expect("a page")).chain([page(all, layout)]);
            for line in pages.collect::<String>().lines() {
                assert!(columns(line) <= width, "{width} columns: {line}");
            }
        }
    }

    #[test]
    fn nothing_is_said_of_claims_that_match_the_record() {
        let page = page(&[&judged("2.33")], TextLayout::default());
        assert!(page.contains("\n1 claim: all verdicts match the record.\n"), "{page}");
        // Behind a list that may fill its line.
        assert!(page.ends_with("geneva errata\n"), "{page}");
    }

    #[test]
    fn what_is_said_elsewhere_has_a_line_of_its_own_and_no_column() {
        let page = page(
            &[&judged("2.33"), &judged_in(&WILD, "2.33"), &judged_in(&WILD, "2.33"), &example()],
            TextLayout::default(),
        );
        assert!(page.contains("\n1 claim: all verdicts match the record.\n"), "{page}");
        assert!(
            page.contains("\nElsewhere 2 statements (2 right) and 1 example (1 right): all verdicts match"),
            "{page}"
        );
        let total = page.lines().find(|line| line.starts_with("all claims")).expect("a total");
        let numbers: Vec<_> = total.split_whitespace().filter(|word| *word != "–").collect();
        assert_eq!(numbers, ["all", "claims", "1", "1"], "{page}");
    }
}
