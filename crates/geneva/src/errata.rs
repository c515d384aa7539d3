//! The mistakes in the sources, most serious consequence first.

use crate::fields;
use crate::output::{TextLayout, count, field, heading};
use crate::typed::{self, CommandFormat, Output, formats};
use clap::Args;
use geneva_documents::LEDGER;
use geneva_evidence::Document;
use geneva_evidence::{Consequence, Judged, TracedSlip, without_ellipses};
use geneva_press::records;
use std::slice;

/// Options of `geneva errata`.
#[derive(Args, Debug)]
pub(crate) struct ErrataArguments {
    /// List only the mistakes in this source [default: all sources but wild]
    #[arg(long, value_parser = typed::value_named(LEDGER.documents(), |document| document.slug, |document| document.citation))]
    pub source: Option<&'static Document>,
    /// List only the mistakes with this consequence
    #[arg(long, value_parser = typed::value_named(Consequence::ALL, Consequence::slug, Consequence::meaning), conflicts_with = "all")]
    pub consequence: Option<Consequence>,
    /// Also list what the copy we had has lost or changed; we don't know whether the original has it too
    #[arg(long)]
    pub all: bool,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "Readable paragraphs"),
        (CommandFormat::Json, "An array of objects"),
        (CommandFormat::Csv, "The data of the JSON, one row per mistake"),
        (CommandFormat::Markdown, "A list by source"),
    ]))]
    pub format: CommandFormat,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// The mistakes that are wanted, in the format that is wanted.
pub(crate) fn page(wanted: &ErrataArguments, layout: TextLayout) -> anyhow::Result<String> {
    let of_source = |places: &TracedSlip| {
        wanted.source.map_or(places.is_mirrored(), |source| places.main().claim.document == source)
    };
    // What the copy has lost is no mistake of a source: it is listed only on request.
    let of_consequence = |places: &TracedSlip| match wanted.consequence {
        Some(consequence) => places.slip.consequence == consequence,
        None => wanted.all || places.slip.consequence != Consequence::Copy,
    };
    let all = wanted.source.map_or_else(|| LEDGER.slips().to_vec(), |source| LEDGER.slips_in(source));
    let first = all.first().cloned();
    let slips: Vec<_> = all.into_iter().filter(|places| of_source(places) && of_consequence(places)).collect();
    match wanted.format {
        CommandFormat::Json => fields::json(&slips.iter().map(records::slip).collect::<Vec<_>>()),
        CommandFormat::Csv => {
            // A source without mistakes has the header of the others.
            let header = first.or_else(|| LEDGER.slips().first().cloned());
            fields::csv(header.as_ref().map(records::slip).as_ref(), slips.iter().map(records::slip))
        }
        CommandFormat::Markdown => {
            Ok(markdown(&slips, wanted.source.as_ref().map_or(LEDGER.mirrored(), slice::from_ref)))
        }
        _ => Ok(text(&slips, layout)),
    }
}

/// The verdicts on the claims of the source that is wanted, or on all.
pub(crate) fn wanted_verdicts(wanted: &ErrataArguments) -> Vec<&'static Judged> {
    wanted.source.map_or_else(|| LEDGER.verdicts().to_vec(), |source| LEDGER.verdicts_of(source))
}

/// The mistakes of each consequence, if there are any.
fn by_consequence(slips: &[TracedSlip]) -> impl Iterator<Item = (Consequence, Vec<&TracedSlip>)> {
    let of = |consequence| slips.iter().filter(|places| places.slip.consequence == consequence).collect::<Vec<_>>();
    Consequence::ALL.iter().map(move |consequence| (*consequence, of(*consequence))).filter(|(_, of)| !of.is_empty())
}

fn text(slips: &[TracedSlip], layout: TextLayout) -> String {
    let field = |name, text: &str| field(name, text, layout);
    let bold = heading();
    let mut page = overview(slips, layout);
    for (consequence, of) in by_consequence(slips) {
        page += &layout
            .wrapped("", &format!("{}, {}: {}.", consequence, count(of.len(), "mistake"), consequence.meaning()));
        page.push('\n');
        for places in of {
            let (slip, main) = (&places.slip, places.main());
            page += &layout
                .folded(&format!("{bold}{}{bold:#}  {}, {}\n", slip.id, main.claim.document, main.claim.locator));
            page += &field("printed", &main.claim.with_unit(&without_ellipses(main.claim)));
            page += &field("right", &right(main));
            if !slip.changes.is_empty() {
                page += &field("changes", slip.changes);
            }
            page += &field("origin", slip.origin.slug());
            page += &field("reason", slip.reason);
            page += &field("witness", slip.witness);
            if places.claims.len() > 1 {
                page += &field("places", &others(places));
            }
            page.push('\n');
        }
    }
    page + &count(slips.len(), "mistake") + "\n"
}

/// The mistakes that change a result or a conclusion, a few lines each: the first screen.
fn overview(slips: &[TracedSlip], layout: TextLayout) -> String {
    let bold = heading();
    let mut page = String::new();
    for (consequence, of) in by_consequence(slips) {
        if consequence > Consequence::Conclusion {
            break;
        }
        page += &layout.folded(&format!("{bold}{}{bold:#}\n", consequence.heading()));
        for places in of {
            let main = places.main();
            let numbers = places.greatest_change().map_or_else(String::new, |change| {
                let wrong = places.wrong_numbers().count();
                let up_to = if wrong == 1 { "" } else { "up to " };
                format!("; {} wrong by {up_to}{}", count(wrong, "number"), percent(change))
            });
            let says = format!("{} -> {}{numbers}", main.claim.with_unit(&without_ellipses(main.claim)), right(main));
            page += &layout.wrapped(&format!("  {}  ", places.slip.id), &says);
        }
        page.push('\n');
    }
    page
}

/// What should be printed instead.
fn right(judged: &Judged) -> String {
    judged.claim.with_unit(&judged.corrected().unwrap_or_default())
}

/// A share in per cent, to two significant digits.
fn percent(share: f64) -> String {
    let places = if share >= 0.1 {
        0
    } else if share >= 0.01 {
        1
    } else {
        2
    };
    format!("{:.places$} %", 100.0 * share)
}

/// The other claims that a mistake reaches; of many in one table only how many.
fn others(places: &TracedSlip) -> String {
    const MOST: usize = 8;
    let ids: Vec<_> = places.claims.iter().skip(1).map(|judged| judged.claim.id).collect();
    let (shown, rest) = ids.split_at(ids.len().min(MOST));
    let more = if rest.is_empty() { String::new() } else { format!(" and {} more", rest.len()) };
    shown.join(", ") + &more
}

fn markdown(slips: &[TracedSlip], works: &[&'static Document]) -> String {
    let mut page = "# Errata\n".to_owned();
    for work in works {
        page += &format!("\n## {work}\n\n{}\n", work.citation);
        let of_work: Vec<_> = slips.iter().filter(|places| places.main().claim.document == *work).cloned().collect();
        if of_work.is_empty() {
            page += &format!("\nNothing to list among {}.\n", count(work.claims().len(), "claim"));
        }
        for (consequence, of) in by_consequence(&of_work) {
            page += &format!("\n### {}\n\n", consequence.heading());
            for places in of {
                let (slip, main) = (&places.slip, places.main());
                let printed = main.claim.with_unit(&without_ellipses(main.claim));
                page += &format!("- **{}** ({}, {}). ", main.claim.locator, code(slip.id), slip.origin);
                page += &format!("For {} read {}. {}", code(&printed), code(&right(main)), slip.reason);
                if !slip.changes.is_empty() {
                    page += &format!(" *Changes:* {}", slip.changes);
                }
                page += &format!(" *Witness:* {}", slip.witness);
                if places.claims.len() > 1 {
                    page += &format!(" *Other places:* {}.", others(places));
                }
                page.push('\n');
            }
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
    use super::*;
    use crate::{Arguments, Command};
    use clap::Parser;

    #[test]
    fn backticks_in_printed_characters_do_not_end_the_code() {
        assert_eq!(code(r"l=\sqrt{2} R"), r"`l=\sqrt{2} R`");
        assert_eq!(code("a``b"), "``` a``b ```");
    }

    #[test]
    fn a_share_keeps_two_digits() {
        assert_eq!([0.9, 0.0165, 0.0017].map(percent), ["90 %", "1.7 %", "0.17 %"]);
    }

    /// The ids of the mistakes that are listed for these options.
    fn listed(options: &[&str]) -> Vec<String> {
        let line = [&["geneva", "errata", "--format", "json"], options].concat();
        let Some(Command::Errata(wanted)) = Arguments::parse_from(line).command else { panic!("{options:?}") };
        let rows: Vec<serde_json::Value> =
            serde_json::from_str(&page(&wanted, TextLayout::default()).expect("a page")).expect("an array");
        rows.iter().map(|row| row["id"].as_str().expect("an id").to_owned()).collect()
    }

    #[test]
    fn the_options_select_the_mistakes_of_the_ledger() {
        let expected = |wanted: &dyn Fn(&TracedSlip) -> bool| -> Vec<_> {
            LEDGER.slips().iter().filter(|places| wanted(places)).map(|places| places.slip.id.to_owned()).collect()
        };
        assert_eq!(listed(&["--all"]), expected(&TracedSlip::is_mirrored));
        let no_copy = |places: &TracedSlip| places.is_mirrored() && places.slip.consequence != Consequence::Copy;
        assert_eq!(listed(&[]), expected(&no_copy));
        for consequence in Consequence::ALL {
            let own = expected(&|places| places.is_mirrored() && places.slip.consequence == *consequence);
            assert_eq!(listed(&["--consequence", consequence.slug()]), own, "{consequence}");
        }
        for source in LEDGER.documents() {
            let own = expected(&|places| places.main().claim.document == *source);
            assert_eq!(listed(&["--source", source.slug, "--all"]), own, "{source}");
        }
    }
}
