//! The numbers behind a figure, and their text.

use crate::number::format_fixed;

/// Digits after the point to which a series is written.
const DECIMALS: usize = 9;

/// What a column of a series holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeriesColumn {
    /// Symbol of the quantity, in ASCII.
    pub name: String,
    /// Its unit; `1` for a pure number, and empty where the words before the row say it.
    pub unit: String,
}

/// A number that a figure takes from an item: from a wheel, say, its radius.
pub type ItemValue<T> = fn(&T) -> f64;

/// A table of numbers with named columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// The columns, in the order of each row's values.
    pub columns: Vec<SeriesColumn>,
    /// The rows; each has one value per column.
    pub rows: Vec<Vec<f64>>,
    /// Digits after the point to which values are written.
    pub decimals: usize,
    /// Words before the numbers, which say what a row is about: a line of heads, then one for each row. May be empty.
    pub words: Vec<Vec<String>>,
}

impl Series {
    /// A series of columns given as (name, unit) and rows of as many values, written to nine decimals.
    pub fn new<const N: usize>(columns: [(&str, &str); N], rows: impl IntoIterator<Item = [f64; N]>) -> Self {
        let columns =
            columns.map(|(name, unit)| SeriesColumn { name: name.to_owned(), unit: unit.to_owned() }).to_vec();
        Self { columns, rows: rows.into_iter().map(|row| row.to_vec()).collect(), decimals: DECIMALS, words: vec![] }
    }

    /// A series with a row for each item: of each column the name, the unit, and the value that it takes from an item.
    pub fn of_items<'a, T: 'a, const N: usize>(
        items: impl IntoIterator<Item = &'a T>,
        columns: [(&str, &str, ItemValue<T>); N],
    ) -> Self {
        let rows = items.into_iter().map(|item| columns.map(|(.., value)| value(item)));
        Self::new(columns.map(|(name, unit, _)| (name, unit)), rows)
    }

    /// A series of one row: name, unit and value of each column.
    pub fn of_one<const N: usize>(columns: [(&str, &str, f64); N]) -> Self {
        Self::new(columns.map(|(name, unit, _)| (name, unit)), [columns.map(|(_, _, value)| value)])
    }

    /// A series of any number of columns, each row with as many values, written to nine decimals.
    pub fn of_columns(columns: impl IntoIterator<Item = (String, &'static str)>, rows: Vec<Vec<f64>>) -> Self {
        let column = |(name, unit): (String, &str)| SeriesColumn { name, unit: unit.to_owned() };
        Self { columns: columns.into_iter().map(column).collect(), rows, decimals: DECIMALS, words: vec![] }
    }

    /// The value of this column in the first row, if there is one.
    pub fn value(&self, name: &str) -> Option<f64> {
        let at = self.columns.iter().position(|column| column.name == name)?;
        self.rows.first()?.get(at).copied()
    }

    /// Sets to how many decimals the numbers are written.
    pub fn to_decimals(self, decimals: usize) -> Self {
        Self { decimals, ..self }
    }

    /// Puts columns of words before the numbers: their heads, and the words of each row.
    pub fn with_words<const N: usize>(self, heads: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> Self {
        let heads = heads.map(str::to_owned).to_vec();
        Self { words: std::iter::once(heads).chain(rows.into_iter().map(|row| row.to_vec())).collect(), ..self }
    }

    /// The cells: heads with their units, then the rows.
    fn cells(&self) -> Vec<Vec<String>> {
        let head = |column: &SeriesColumn| match column.unit.as_str() {
            "" => column.name.clone(),
            unit => format!("{} [{unit}]", column.name),
        };
        let heads = self.columns.iter().map(head).collect();
        let values = self.rows.iter().map(|row| row.iter().map(|value| format_fixed(*value, self.decimals)).collect());
        let numbers = std::iter::once(heads).chain(values).enumerate();
        let whole = |(at, numbers): (usize, Vec<String>)| {
            self.words.get(at).into_iter().flatten().cloned().chain(numbers).collect()
        };
        numbers.map(whole).collect()
    }

    /// The table as text of fixed width: a line of names and units, then one line per row, all flush right.
    ///
    /// Values are rounded to [`decimals`](Self::decimals); zero has no sign. Each line ends with a line feed.
    pub fn to_text(&self) -> String {
        let lines = self.cells();
        let width = |k: usize| lines.iter().filter_map(|line| line.get(k)).map(|cell| cell.chars().count()).max();
        let mut text = String::new();
        for line in &lines {
            let padded = line.iter().enumerate().map(|(k, cell)| format!("{cell:>w$}", w = width(k).unwrap_or(0)));
            text.push_str(&padded.collect::<Vec<_>>().join("  "));
            text.push('\n');
        }
        text
    }

    /// The table as CSV: a line of names and units, then one line per row, to the same decimals. Names have no commas.
    pub fn to_csv(&self) -> String {
        self.cells().iter().map(|line| line.join(",") + "\n").collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stand_flush_right_and_zero_has_no_sign() {
        let series = Series::new([("phi", "deg"), ("v", "m/s")], [[1.0, -0.0], [-12.0, -1e-12]]);
        let expected = "    phi [deg]      v [m/s]\n  1.000000000  0.000000000\n-12.000000000  0.000000000\n";
        assert_eq!(series.to_text(), expected);
        assert_eq!(series.to_csv(), "phi [deg],v [m/s]\n1.000000000,0.000000000\n-12.000000000,0.000000000\n");
    }

    #[test]
    fn words_stand_before_the_numbers_of_their_row() {
        let series = Series::new([("printed", ""), ("right", "s")], [[1.0, 2.0], [3.0, 4.0]]).to_decimals(1);
        let series = series.with_words(["what"], ["peak", "period"].map(|word| [word.to_owned()]));
        assert_eq!(series.to_csv(), "what,printed,right [s]\npeak,1.0,2.0\nperiod,3.0,4.0\n");
        assert_eq!(
            series.to_text(),
            "  what  printed  right [s]\n  peak      1.0        2.0\nperiod      3.0        4.0\n"
        );
    }

    #[test]
    fn items_give_each_row_its_values_under_their_names() {
        let items = [(1.0, -0.0), (-12.0, -1e-12)];
        let series = Series::of_items(&items, [("phi", "deg", |item| item.0), ("v", "m/s", |item| item.1)]);
        assert_eq!(series, Series::new([("phi", "deg"), ("v", "m/s")], items.map(|(phi, v)| [phi, v])));
    }
}
