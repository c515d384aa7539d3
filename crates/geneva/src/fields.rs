//! An answer as a sheet for reading. In JSON its fields are an object; what has many rows of its own, such as a cycle or a run, is
//! a series.

use crate::output::{TextLayout, heading};
use crate::typed::CommandFormat;
use anyhow::bail;
use clap::{Args, ValueEnum};
use geneva_ask::MechanismReport;
use geneva_ask::length_units::TypedLengths;

pub(crate) use geneva_press::fields::{DataRow, csv, json};

/// An answer as a sheet for reading, with the numbers under one another.
pub(crate) fn sheet(answer: &MechanismReport, layout: TextLayout) -> String {
    let bold = heading();
    answer.sheet(|lead, text| layout.wrapped(lead, text), [&format!("{bold}"), &format!("{bold:#}")])
}

/// An answer as a sheet with lengths in this unit: millimetres, with inches beside them if these are asked for.
pub(crate) fn with_lengths_in(unit: SheetUnit, answer: MechanismReport) -> MechanismReport {
    match unit {
        SheetUnit::Mm => answer,
        SheetUnit::In => answer.beside_inches(),
    }
}

/// A refusal with lengths in the units in which they were typed; `lengths` are the names of all options that are lengths.
pub(crate) fn in_typed_units(refused: anyhow::Error, typed: &TypedLengths, lengths: &[&str]) -> anyhow::Error {
    let said = refused.to_string();
    let told = typed.in_their_units(&said, lengths);
    // What the system says has causes, and no lengths.
    if told == said || refused.chain().count() > 1 { refused } else { anyhow::Error::msg(told) }
}

/// Units of the lengths on a sheet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum SheetUnit {
    /// Millimetres
    #[default]
    Mm,
    /// Millimetres, and inches beside them
    In,
}

/// The unit of the lengths on a sheet, as an option.
#[derive(Args, Debug)]
pub(crate) struct SheetUnitArgument {
    /// Unit of the lengths on the sheet; all other formats and all files are in millimetres
    #[arg(long, value_name = "UNIT", default_value = "mm")]
    pub unit: SheetUnit,
}

impl SheetUnitArgument {
    /// Refuses inches where no sheet is wanted.
    pub(crate) fn reject_without_sheet(&self, format: CommandFormat) -> anyhow::Result<()> {
        if self.unit == SheetUnit::In && format != CommandFormat::Text {
            bail!("--unit in has no effect on --format {}, whose lengths are in mm; leave it out", format.name());
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use anstream::adapter::strip_str;

    #[test]
    fn a_sheet_for_a_file_is_that_of_a_pipe() {
        for question in [
            "wheel --stations 6",
            "wheel --stations 4 --crank-radius 40 --rpm 60 --inertia 0.002 --play 0 --at -20 --at 30",
            "wheel --stations 400 --crank-radius 5",
            "wheel --stations 5 --type spherical --rpm 60",
        ] {
            let answer = geneva_ask::answer(question).expect(question);
            assert_eq!(answer.plain_sheet(), strip_str(&sheet(&answer, TextLayout::default())).to_string());
        }
    }
}
