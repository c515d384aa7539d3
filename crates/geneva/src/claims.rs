//! The list of claims.

use crate::fields;
use crate::output::{Outcome, TextLayout, count, heading, style, truncate_to_width};
use crate::typed::{self, CommandFormat, Output, formats};
use anyhow::{anyhow, bail};
use clap::Args;
use geneva_chapters::BOOK;
use geneva_documents::LEDGER;
use geneva_evidence::{Account, Claim, Decimal, Document, Judged, PlainVerdict, Verdict, without_ellipses};
use geneva_host::printable::escape_and_shorten;
use geneva_press::lookup::unknown;
use geneva_press::records;

/// Options of `geneva claims`.
#[derive(Args, Debug)]
pub(crate) struct ClaimsArguments {
    /// Check these claims here and now, and tell of each what was found; without any, list all
    #[arg(value_name = "ID", value_parser = claim_with_id, conflicts_with_all = ["source", "verdict"])]
    pub ids: Vec<&'static Claim>,
    /// Check the claim as if these characters were printed in it, to see that its check can fail
    #[arg(long, value_name = "CHARACTERS", requires = "ids", allow_hyphen_values = true)]
    pub printed: Option<String>,
    /// List only the claims of this source
    #[arg(long, value_parser = typed::value_named(LEDGER.documents(), |document| document.slug, |document| document.citation))]
    pub source: Option<&'static Document>,
    /// List only the claims with this verdict, or with this class of verdict in the data
    #[arg(long, value_parser = typed::value_named(WantedVerdict::ALL, WantedVerdict::slug, WantedVerdict::meaning))]
    pub verdict: Option<WantedVerdict>,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "A readable table"),
        (CommandFormat::Json, "An array of objects, with everything known about each claim"),
        (CommandFormat::Csv, "The data of the JSON, one row per claim"),
    ]))]
    pub format: CommandFormat,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// The claims that `--verdict` asks for: with a verdict in plain words, or with a class of verdict in the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WantedVerdict {
    /// A verdict in plain words.
    Plain(PlainVerdict),
    /// A class in the data.
    Class(Verdict),
}

impl WantedVerdict {
    /// All that can be asked for.
    const ALL: &'static [Self] = &[
        Self::Plain(PlainVerdict::Right),
        Self::Plain(PlainVerdict::RightAsRead),
        Self::Plain(PlainVerdict::Wrong),
        Self::Plain(PlainVerdict::WrongInCopy),
        Self::Plain(PlainVerdict::Open),
        Self::Class(Verdict::Reproduced),
        Self::Class(Verdict::Truncated),
        Self::Class(Verdict::FromRounded),
        Self::Class(Verdict::ReadOff),
        Self::Class(Verdict::ReproducedInError),
        Self::Class(Verdict::Corrected),
        Self::Class(Verdict::NotReproduced),
        Self::Class(Verdict::NotReproducible),
    ];

    fn slug(self) -> &'static str {
        match self {
            Self::Plain(verdict) => verdict.slug(),
            Self::Class(class) => class.slug(),
        }
    }

    fn meaning(self) -> &'static str {
        match self {
            Self::Plain(verdict) => verdict.meaning(),
            Self::Class(class) => class.meaning(),
        }
    }

    fn includes(self, judged: &Judged) -> bool {
        match self {
            Self::Plain(verdict) => judged.plain() == verdict,
            Self::Class(class) => judged.verdict == class,
        }
    }
}

/// The claim with this id.
fn claim_with_id(id: &str) -> Result<&'static Claim, String> {
    LEDGER.claim(id).ok_or_else(|| unknown("claim", id, LEDGER.claims().iter().map(|claim| claim.id)).to_string())
}

/// What was found of each of the claims that are wanted by their ids, and whether all match the record. None if none is wanted so.
pub(crate) fn accounts(wanted: &ClaimsArguments, layout: TextLayout) -> anyhow::Result<Option<(String, Outcome)>> {
    if wanted.ids.is_empty() {
        return Ok(None);
    }
    CommandFormat::Text.only_with(
        wanted.format,
        "--printed",
        wanted.printed.as_deref().map(escape_and_shorten),
        "text",
    )?;
    if wanted.format != CommandFormat::Text {
        return Ok(None);
    }
    let accounts = match (&wanted.printed, &wanted.ids[..]) {
        (None, ids) => ids.iter().map(|claim| Account::for_claim(claim)).collect::<Vec<_>>(),
        (Some(characters), [claim]) => {
            vec![Account::for_characters(claim, characters).map_err(|why| anyhow!("--printed: {why}"))?]
        }
        (Some(_), ids) => bail!("--printed is about one claim, and {} are named: name one", ids.len()),
    };
    let texts: Vec<String> = accounts.iter().map(|account| layout.folded(&account.text())).collect();
    let holds = accounts.iter().all(|account| account.judged.matches_record());
    Ok(Some((texts.join("\n"), Outcome::as_recorded_if(holds))))
}

/// The claims that are wanted, in the format that is wanted.
pub(crate) fn page(wanted: &ClaimsArguments, layout: TextLayout) -> anyhow::Result<String> {
    let of_verdict = |judged: &&Judged| wanted.verdict.is_none_or(|verdict| verdict.includes(judged));
    let rows: Vec<_> = wanted_verdicts(wanted).into_iter().filter(of_verdict).collect();
    let row = |judged| records::claim(BOOK.ledger, judged);
    match wanted.format {
        CommandFormat::Json => fields::json(&rows.into_iter().map(row).collect::<Vec<_>>()),
        CommandFormat::Csv => fields::csv(
            LEDGER.claims().first().and_then(|claim| LEDGER.verdict(claim.id)).map(row).as_ref(),
            rows.into_iter().map(row),
        ),
        _ => Ok(table(&rows, layout)),
    }
}

/// The verdicts on the claims that are wanted by their ids, on those of the source that is wanted, or on all.
pub(crate) fn wanted_verdicts(wanted: &ClaimsArguments) -> Vec<&'static Judged> {
    if !wanted.ids.is_empty() {
        return wanted.ids.iter().filter_map(|claim| LEDGER.verdict(claim.id)).collect();
    }
    wanted.source.map_or_else(|| LEDGER.verdicts().to_vec(), |source| LEDGER.verdicts_of(source))
}

/// Before a claim that no longer matches the record.
const DIFFERS: char = '!';
/// How far the second line of a claim is set in.
const SET_IN: usize = 6;
/// Columns of the printed characters, with fewer of which a claim gets two lines.
const LEAST_PRINTED: usize = 12;

/// A line for each claim, under the place in the source, or two where the terminal is too narrow for one. Ids and verdicts are
/// never cut.
fn table(rows: &[&Judged], layout: TextLayout) -> String {
    let longest = |length: fn(&Judged) -> usize| rows.iter().map(|judged| length(judged)).max().unwrap_or(0);
    let id = longest(|judged| judged.claim.id.len());
    let verdict = PlainVerdict::ALL.iter().map(|verdict| verdict.words().len()).max().unwrap_or(0);
    let beside = layout.width().saturating_sub(2 + id + 2 + 2 + verdict);
    let computed = longest(|judged| computed(judged).map_or(0, |number| number.len())).max("computed".len());
    let is_beside = beside >= LEAST_PRINTED + 2 + computed;
    // Under an id there is room up to the end of the line.
    let middle = if is_beside { beside } else { layout.width().saturating_sub(SET_IN) };
    let printed = middle.saturating_sub(2 + computed);
    let before_verdict = if is_beside { id } else { layout.width().saturating_sub(2 + 2 + verdict) };

    let bold = heading();
    let head = [format!("{:<before_verdict$}", "id"), format!("{:<printed$}  {:>computed$}", "printed", "computed")];
    let line = |mark: char, [id, what]: [&str; 2], verdict: &str| {
        if is_beside {
            format!("{mark} {id}  {what}  {verdict}")
        } else {
            layout.folded(&format!("{mark} {id}  {verdict}\n{:SET_IN$}{what}", ""))
        }
    };
    let mut page = format!("{bold}{}{bold:#}\n", line(' ', [&head[0], &head[1]], "verdict"));
    let mut place = None;
    for judged in rows {
        let (claim, colour) = (judged.claim, style(judged.plain()));
        if place.replace((claim.document, claim.locator)) != Some((claim.document, claim.locator)) {
            page += &layout.folded(&format!("{}, {}\n", claim.document, claim.locator));
        }
        let what = match self::computed(judged) {
            Some(number) => {
                format!(
                    "{}  {number:>computed$}",
                    truncate_to_width(&claim.with_unit(&without_ellipses(claim)), printed)
                )
            }
            // A form has nothing to set beside it.
            None => truncate_to_width(&claim.with_unit(&without_ellipses(claim)), middle),
        };
        let mark = if judged.matches_record() { ' ' } else { DIFFERS };
        let id = format!("{:<before_verdict$}", claim.id);
        let verdict = format!("{colour}{}{colour:#}", judged.plain().words());
        page += &format!("{}\n", line(mark, [&id, &what], &verdict).trim_end());
    }
    page += &format!("{}\n", count(rows.len(), "claim"));
    let differing = rows.iter().filter(|judged| !judged.matches_record()).count();
    if differing > 0 {
        page += &format!(
            "{DIFFERS} {} of them no longer as recorded: the verdict differs, or a witness disagrees\n",
            differing
        );
    }
    page
}

/// The computed number with some places more than are printed.
fn computed(judged: &Judged) -> Option<String> {
    let number = judged.computed?;
    Some(match judged.claim.printed.parse::<Decimal>() {
        Ok(printed) => format!("{number:.*}", printed.places() as usize + Decimal::MORE_PLACES),
        Err(_) => number.to_string(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Arguments, Command};
    use clap::Parser;
    use geneva_documents::{LEDGER, PIN};
    use geneva_evidence::{Evidence, Locator, judge};

    /// The ids of the claims that are listed for these options.
    fn listed(options: &[&str]) -> Vec<String> {
        let line = [&["geneva", "claims", "--format", "json"], options].concat();
        let Some(Command::Claims(wanted)) = Arguments::parse_from(line).command else { panic!("{options:?}") };
        let rows: Vec<serde_json::Value> =
            serde_json::from_str(&page(&wanted, TextLayout::default()).expect("a page")).expect("an array");
        rows.iter().map(|row| row["id"].as_str().expect("an id").to_owned()).collect()
    }

    #[test]
    fn a_claim_whose_witness_disagrees_is_marked_though_its_verdict_is_the_recorded_one() {
        let claim = |witness: fn() -> f64| {
            let claim = Locator::new(&PIN, "Nowhere, line 1")
                .value("pin.made-up", "2.33", "mm", "seven thirds")
                .first_route(Evidence::CLOSED_FORM, || 7.0 / 3.0)
                .second_route(Evidence::LIMIT_CASE, witness);
            judge(Box::leak(Box::new(claim)))
        };
        let (sound, doubtful) = (claim(|| 7.0 / 3.0), claim(|| 2.5));
        assert!(doubtful.verdict == Verdict::Reproduced && !doubtful.matches_record(), "{doubtful:?}");
        let page = table(&[&sound, &doubtful], TextLayout::default());
        let rows: Vec<_> = page.lines().filter(|line| line.contains("pin.made-up")).collect();
        assert!(rows[0].starts_with("  pin.made-up") && rows[1].starts_with("! pin.made-up"), "{page}");
        assert!(
            page.ends_with(
                "2 claims\n! 1 of them no longer as recorded: the verdict differs, or a witness disagrees\n"
            )
        );
        assert!(!table(&[&sound], TextLayout::default()).contains('!'), "{page}");
    }

    #[test]
    fn a_claim_gets_two_lines_where_one_would_leave_its_printed_characters_too_little() {
        let claim = Locator::new(&PIN, "Nowhere, line 1")
            .value("pin.made-up-with-a-name-of-thirty-eight", "2.33", "mm", "seven thirds")
            .first_route(Evidence::CLOSED_FORM, || 7.0 / 3.0)
            .second_route(Evidence::LIMIT_CASE, || 7.0 / 3.0);
        let judged = judge(Box::leak(Box::new(claim)));
        let verdict = PlainVerdict::ALL.iter().map(|verdict| verdict.words().len()).max().expect("verdicts");
        // Mark, id, printed characters, "computed" and verdict, with two blanks between.
        let needed = 2 + judged.claim.id.len() + 2 + LEAST_PRINTED + 2 + "computed".len() + 2 + verdict;
        assert!((61..=100).contains(&needed), "{needed}");
        let has_one = |columns: usize| {
            let page = table(&[&judged], TextLayout::for_columns(columns));
            page.lines().any(|line| line.contains(judged.claim.id) && line.contains("2.33"))
        };
        assert!(has_one(needed) && !has_one(needed - 1), "{needed}");
    }

    /// What is told of single claims, and whether all match the record.
    fn told(options: &[&str]) -> anyhow::Result<Option<(String, Outcome)>> {
        let line = [&["geneva", "claims"], options].concat();
        let Some(Command::Claims(wanted)) = Arguments::try_parse_from(line)?.command else { panic!("{options:?}") };
        accounts(&wanted, TextLayout::default())
    }

    #[test]
    fn a_claim_is_told_as_in_a_page_to_the_letter_with_whatever_characters() {
        let as_told =
            |reply: &str| reply.lines().skip(1).map(|line| line.replacen('\t', ": ", 1) + "\n").collect::<String>();
        for claim in PIN.claims() {
            let (page, outcome) = told(&[claim.id]).expect("told").expect("an account");
            assert_eq!(page, as_told(&LEDGER.reply(&format!("account {}", claim.id))));
            assert_eq!(outcome, Outcome::AsRecorded, "{page}");
        }
        for characters in ["3", "-1", "", "\u{1b}[31m", "<b>", PIN.printed_text("pin.radius")] {
            let (page, outcome) = told(&["pin.radius", "--printed", characters]).expect("told").expect("an account");
            assert_eq!(page, as_told(&LEDGER.reply(&format!("account pin.radius\n{characters}"))));
            assert_eq!(outcome, Outcome::as_recorded_if(characters == PIN.printed_text("pin.radius")), "{page}");
            assert!(!page.contains('\u{1b}'), "{page}");
        }
    }

    #[test]
    fn what_cannot_be_told_of_a_claim_is_refused_with_what_to_do() {
        let long = "9".repeat(geneva_evidence::MOST_CHARACTERS + 1);
        for (options, why) in [
            (&["pin.radios"][..], "the nearest is `pin.radius`"),
            (&["pin.radius", "--source", "pin"], "cannot be used with"),
            (&["--printed", "3"], "<ID>"),
            (&["pin.radius", "pin.pin-speed", "--printed", "3"], "name one"),
            (&["pin.radius", "--printed", "3", "--format", "json"], "--format text"),
            (&["pin.radius", "--printed", &long], "give at most 2000"),
        ] {
            let error = told(options).map(|_| ()).expect_err(why);
            assert!(error.to_string().contains(why), "{options:?}: {error}");
        }
        assert_eq!(listed(&["pin.radius", "pin.pin-speed"]), ["pin.radius", "pin.pin-speed"]);
    }

    #[test]
    fn every_source_and_every_verdict_select_their_claims() {
        for work in LEDGER.documents() {
            for verdict in WantedVerdict::ALL {
                let is_wanted = |judged: &&Judged| judged.claim.document == *work && verdict.includes(judged);
                let expected: Vec<_> =
                    LEDGER.verdicts().iter().copied().filter(is_wanted).map(|judged| judged.claim.id).collect();
                let found = listed(&["--source", work.slug, "--verdict", verdict.slug()]);
                assert_eq!(found, expected, "{work} {verdict:?}");
            }
        }
        let asked = WantedVerdict::ALL.len();
        assert_eq!(asked, PlainVerdict::ALL.len() + Verdict::ALL.len());
    }
}
