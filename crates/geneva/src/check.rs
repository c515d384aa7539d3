//! `geneva check`: the numbers of texts against the values that they are tied to.

use crate::output::{Outcome, TextLayout};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Options of `geneva check`.
#[derive(Args, Debug)]
pub(crate) struct CheckArguments {
    /// A record, or its folder
    #[arg(default_value = ".", value_name = "DIR")]
    pub record: PathBuf,
    /// Read texts, values and record as they are staged in git
    #[arg(long)]
    pub staged: bool,
    /// Output format
    #[arg(long, value_enum, default_value = "text")]
    pub format: CheckFormat,
}

/// How findings are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CheckFormat {
    /// What differs, and a summary
    Text,
    /// An object with all numbers and the counts
    Json,
    /// What differs, for code review
    Sarif,
}

/// What differs, and whether anything does.
pub(crate) fn page(wanted: &CheckArguments, layout: TextLayout) -> anyhow::Result<(String, Outcome)> {
    let report = geneva_values::check(&wanted.record, wanted.staged).map_err(anyhow::Error::msg)?;
    let page = match wanted.format {
        CheckFormat::Text => geneva_values::check_text(&report, layout),
        CheckFormat::Json => geneva_values::check_json(&report),
        CheckFormat::Sarif => geneva_values::check_sarif(&report),
    };
    Ok((page, Outcome::as_recorded_if(report.is_right())))
}
