//! The printed speeds and periods of Appendix E, each beside what the program of 1973 gives and what is right.

use crate::lookup::judged;
use anyhow::Context;
use geneva_case1973::{Column, Row, slug};

/// A printed peak, minimum or period of a run.
pub(crate) struct PrintedCell {
    /// Its run.
    pub row: &'static Row,
    /// The claim of the printed number.
    pub id: &'static str,
    /// What it is, in a word.
    pub quantity: &'static str,
    /// Its column in the tables.
    pub column: Column,
    /// What the program gives as it was run, in the printed unit.
    pub as_run: f64,
    /// What the real mechanism does, in the printed unit.
    pub right: f64,
}

/// The columns in which the cells are data.
pub(crate) const HEADS: [&str; 7] = ["mechanism", "mu", "K", "quantity", "printed", "as_run", "right"];

/// The quantities: of each its column, its word, and the end of its claims' ids.
const QUANTITIES: [(Column, &str, &str); 3] =
    [(Column::Peak, "peak", "max"), (Column::Minimum, "minimum", "min"), (Column::Period, "period", "period")];

/// The cells of these runs, row by row, with the numbers of the ledger.
pub(crate) fn of_rows(rows: &'static [Row]) -> anyhow::Result<Vec<PrintedCell>> {
    let cells = rows.iter().flat_map(|row| QUANTITIES.map(|quantity| (row, quantity)));
    let cell = |(row, (column, quantity, end)): (&'static Row, (Column, &'static str, &str))| {
        let judged = judged(&format!("meyer.app-e.{}.{end}", row.slug()))?;
        let number = |number: Option<f64>| number.with_context(|| format!("{}: no such number", judged.claim.id));
        let id = judged.claim.id;
        Ok(PrintedCell {
            row,
            id,
            quantity,
            column,
            as_run: number(judged.computed)?,
            right: number(judged.right_value)?,
        })
    };
    cells.map(cell).collect()
}

impl PrintedCell {
    /// The characters that are printed.
    pub(crate) fn printed(&self) -> &'static str {
        self.row.printed(self.column)
    }

    /// A number of this quantity to one decimal more than are printed.
    pub(crate) fn to_places(&self, number: f64) -> String {
        let places = self.printed().split_once('.').map_or(0, |(_, decimals)| decimals.len());
        format!("{number:.*}", places + 1)
    }

    /// Friction or torque of the run, with a digit before the point.
    pub(crate) fn given(&self, column: Column) -> String {
        format!("0{}", self.row.printed(column).trim_start_matches('0'))
    }

    /// What stands before the cell's numbers in data: mechanism, friction, torque, quantity, printed characters.
    pub(crate) fn words(&self) -> [String; 5] {
        let [friction, torque] = [Column::Friction, Column::Torque].map(|column| self.given(column));
        [slug(self.row.mechanism), friction, torque, self.quantity.to_owned(), self.printed().to_owned()]
    }
}
