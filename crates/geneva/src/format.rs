//! Options that commands share: in which format an answer is written, and where it goes.

use anyhow::bail;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

/// Where the output goes.
#[derive(Args, Debug)]
pub struct Output {
    /// Write to this file, or to standard output (-); an existing file is replaced once the new one is complete
    #[arg(long, value_name = "FILE", default_value = "-")]
    pub output: String,
}

/// Output formats. A word means the same to every command that knows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Readable text.
    Text,
    /// Text as a line printer wrote it.
    Print,
    /// Everything known, with all digits.
    Json,
    /// A series: one row per claim, mistake or time.
    Csv,
    /// The numbers of one mechanism: one row per field, as CSV.
    Fields,
    /// A drawing as a standalone file.
    Svg,
    /// A drawing for cutting machines.
    Dxf,
    /// A model for OpenSCAD.
    Scad,
    /// A mesh for printing.
    Stl,
    /// Markdown for a page.
    Markdown,
}

impl Format {
    /// Its name at the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Print => "print",
            Self::Json => "json",
            Self::Csv => "csv",
            Self::Fields => "fields",
            Self::Svg => "svg",
            Self::Dxf => "dxf",
            Self::Scad => "scad",
            Self::Stl => "stl",
            Self::Markdown => "markdown",
        }
    }

    /// Refuses an option that applies to this format only, if another is wanted; `what` is what it applies to.
    pub fn only_with(self, wanted: Self, option: &str, typed: Option<String>, what: &str) -> anyhow::Result<()> {
        match typed {
            Some(typed) if wanted != self => {
                bail!("{option} {typed} applies only to {what}; give --format {} with it, or leave it out", self.name())
            }
            _ => Ok(()),
        }
    }
}

/// The formats of a command, each with its help. A command without a series says what to use instead of CSV.
pub fn formats(known: &'static [(Format, &'static str)]) -> impl TypedValueParser<Value = Format> {
    let has_series = known.iter().any(|(format, _)| *format == Format::Csv);
    let names = known.iter().map(|(format, told)| PossibleValue::new(format.name()).help(*told));
    let refused = (!has_series).then(|| PossibleValue::new(Format::Csv.name()).hide(true));
    PossibleValuesParser::new(names.chain(refused)).try_map(move |name| {
        let format = known.iter().map(|(format, _)| *format).find(|format| format.name() == name);
        format.ok_or(
            "csv is for a series of rows, but this is a single mechanism; use fields for its numbers, one \
                   in each row, or json",
        )
    })
}

/// The name of a value as it is typed.
pub fn name_of(value: impl ValueEnum) -> Option<String> {
    Some(value.to_possible_value()?.get_name().to_owned())
}
