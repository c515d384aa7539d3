//! `geneva record`: ties the numbers of texts to values.

use crate::output::TextLayout;
use clap::Args;
use geneva_values::RecordRequest;
use std::path::PathBuf;

/// Options of `geneva record`.
#[derive(Args, Debug)]
pub(crate) struct RecordArguments {
    /// A folder with texts and a file of values, or texts
    #[arg(required = true, value_name = "FILE")]
    pub named: Vec<PathBuf>,
    /// A file of computed values in JSON, CSV or TOML [default: values.json, values.csv or values.toml in the folder]
    #[arg(long, value_name = "FILE")]
    pub values: Vec<PathBuf>,
    /// A file of the same values, computed in a second way [default: second.json, second.csv or second.toml in the folder]
    #[arg(long, value_name = "FILE")]
    pub second: Vec<PathBuf>,
    /// The record to write [default: numbers.toml beside the first text]
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Take out the entries whose numbers are no longer in the texts
    #[arg(long)]
    pub prune: bool,
}

/// Writes the record, and says what is in it.
pub(crate) fn page(wanted: RecordArguments, layout: TextLayout) -> anyhow::Result<String> {
    let RecordArguments { named, values, second, record, prune } = wanted;
    let request = RecordRequest { named, values, second, record, prune };
    let report = geneva_values::record(&request).map_err(anyhow::Error::msg)?;
    Ok(geneva_values::record_text(&report, layout))
}
