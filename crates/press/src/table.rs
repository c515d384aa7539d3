//! Tables as lists of columns: each has its head and says what its cell is in every row.

use crate::html::{escape, plain};
use crate::phone_tables::PhoneLayout;
use std::panic::Location;

/// What a table holds, which decides how its cells are set.
#[derive(Clone, Copy)]
pub enum Cells {
    /// Numbers: to the right, on one line.
    Numbers,
    /// Numbers, with words at the head of each row.
    NamedNumbers,
    /// Words: to the left, broken where need be.
    Words,
    /// Words among formulas and addresses that do not break: they need the most room.
    Wide,
    /// A letter, what it stands for, and where it comes from: one line each.
    Letters,
    /// Numbers of several things, each with some rows of its own: rows with the same first cell stand together behind it. The
    /// second cell is the head of its row. So narrow that a phone shows its columns.
    Grouped,
}

/// A table before it is set: cells of HTML, the first of each row its head.
pub struct Table {
    cells: Cells,
    head: Vec<String>,
    rows: Vec<Vec<String>>,
    /// The heads and the rows of its data, if these are not its cells.
    data: Option<(Vec<String>, Vec<Vec<String>>)>,
    /// What is said below it.
    legend: &'static str,
    /// The file that makes it.
    source: &'static str,
}

/// A table that is being made: rows of some kind, to which columns are added from the left. A cell that cannot be made is an
/// error of the table.
pub struct Columns<R> {
    rows: Vec<R>,
    table: Table,
    error: Option<anyhow::Error>,
}

/// What a column says of a row: a cell of HTML, or why there is none.
pub trait IntoCell {
    /// The cell.
    ///
    /// # Errors
    ///
    /// What keeps it from being made.
    fn into_cell(self) -> anyhow::Result<String>;
}

impl IntoCell for String {
    fn into_cell(self) -> anyhow::Result<String> {
        Ok(self)
    }
}

impl IntoCell for &str {
    fn into_cell(self) -> anyhow::Result<String> {
        Ok(self.to_owned())
    }
}

impl IntoCell for usize {
    fn into_cell(self) -> anyhow::Result<String> {
        Ok(self.to_string())
    }
}

impl IntoCell for u32 {
    fn into_cell(self) -> anyhow::Result<String> {
        Ok(self.to_string())
    }
}

impl IntoCell for anyhow::Result<String> {
    fn into_cell(self) -> anyhow::Result<String> {
        self
    }
}

impl<R> Columns<R> {
    /// Adds a column: its head, in HTML, and its cell in each row.
    #[must_use]
    pub fn column<C: IntoCell>(mut self, head: impl Into<String>, cell: impl Fn(&R) -> C) -> Self {
        self.table.head.push(head.into());
        for (row, cells) in self.rows.iter().zip(&mut self.table.rows) {
            match cell(row).into_cell() {
                Ok(cell) => cells.push(cell),
                Err(error) => return Self { error: self.error.or(Some(error)), ..self },
            }
        }
        self
    }

    /// Adds a column for each of some things, from its head and its cell in each row.
    #[must_use]
    pub fn columns<T, C: IntoCell>(
        self,
        of: impl IntoIterator<Item = T>,
        head: impl Fn(&T) -> String,
        cell: impl Fn(&R, &T) -> C,
    ) -> Self {
        of.into_iter().fold(self, |columns, it| columns.column(head(&it), |row| cell(row, &it)))
    }

    /// Gives the table data of its own, in place of its cells: the heads of their columns, and a line for each row.
    #[must_use]
    pub fn with_data<const N: usize>(mut self, heads: [&str; N], line: impl Fn(&R) -> [String; N]) -> Self {
        let lines = self.rows.iter().map(|row| line(row).to_vec()).collect();
        self.table.data = Some((heads.map(str::to_owned).to_vec(), lines));
        self
    }

    /// The table.
    ///
    /// # Errors
    ///
    /// What kept the first of the cells from being made that could not be.
    pub fn finish(self) -> anyhow::Result<Table> {
        self.error.map_or(Ok(self.table), Err)
    }
}

impl Table {
    /// Begins a table with a row for each of these things.
    #[track_caller]
    pub fn with_rows<R>(cells: Cells, rows: impl IntoIterator<Item = R>) -> Columns<R> {
        let rows: Vec<R> = rows.into_iter().collect();
        let table = Self {
            cells,
            head: Vec::new(),
            rows: rows.iter().map(|_| Vec::new()).collect(),
            data: None,
            legend: "",
            source: Location::caller().file(),
        };
        Columns { rows, table, error: None }
    }

    /// Adds some HTML below the table.
    pub fn with_legend(self, legend: &'static str) -> Self {
        Self { legend, ..self }
    }

    /// Whether a cell contains this piece of HTML.
    pub fn contains(&self, piece: &str) -> bool {
        self.rows.iter().flatten().any(|cell| cell.contains(piece))
    }

    /// The file that makes it.
    pub fn source(&self) -> &'static str {
        self.source
    }

    /// The table without a number, under a name for screen readers, which is plain text.
    ///
    /// Each cell bears its column's head, which stands beside it where the page is too narrow for columns.
    pub fn html(&self, name: &str) -> String {
        let class = match self.cells {
            Cells::Numbers => "compare",
            Cells::NamedNumbers => "compare named",
            Cells::Words => "listing",
            Cells::Wide => "listing wide",
            Cells::Letters => "listing symbols",
            Cells::Grouped => "grouped",
        };
        let layout = match self.cells {
            Cells::Letters | Cells::Grouped => "",
            _ => match PhoneLayout::of(&self.head, &self.rows) {
                PhoneLayout::Cards if self.fits_in_pairs() => " pairs",
                layout => layout.class(),
            },
        };
        let name = escape(name);
        let mut out =
            format!("<div class=\"{class}{layout}\" role=\"region\" tabindex=\"0\" aria-label=\"{name}\">\n<table>\n");
        out.push_str("<thead><tr>");
        for cell in &self.head {
            out.push_str(&format!("<th scope=\"col\">{cell}</th>"));
        }
        out.push_str("</tr></thead>\n");
        out.push_str(&if matches!(self.cells, Cells::Grouped) { self.groups() } else { self.body() });
        out.push_str("</table>\n</div>");
        if !self.legend.is_empty() {
            out.push_str(&format!("\n{}", self.legend));
        }
        out
    }

    /// The rows, one after the other.
    fn body(&self) -> String {
        let mut out = "<tbody>\n".to_owned();
        for row in &self.rows {
            out.push_str("<tr>");
            for (at, cell) in row.iter().enumerate() {
                if at == 0 {
                    out.push_str(&format!("<th scope=\"row\"{}>{cell}</th>", self.first_label()));
                } else {
                    let label = self.head.get(at).map_or_else(String::new, |head| escape(&plain(head)));
                    // Beside its label a cell is one piece.
                    let cell = if matches!(self.cells, Cells::Words | Cells::Wide | Cells::Letters) {
                        cell
                    } else {
                        &format!("<span>{cell}</span>")
                    };
                    let empty = if is_empty(cell) { " class=\"none\"" } else { "" };
                    out.push_str(&format!("<td data-label=\"{label}\"{empty}>{cell}</td>"));
                }
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody>\n");
        out
    }

    /// The rows, those with the same first cell together behind it.
    fn groups(&self) -> String {
        let mut out = String::new();
        for group in self.rows.chunk_by(|one, other| one.first() == other.first()) {
            out.push_str("<tbody>\n");
            for (at, row) in group.iter().enumerate() {
                let (names, numbers) = row.split_at(row.len().min(2));
                out.push_str("<tr>");
                if let Some(name) = names.first().filter(|_| at == 0) {
                    out.push_str(&format!("<th scope=\"rowgroup\" rowspan=\"{}\">{name}</th>", group.len()));
                }
                out.extend(names.get(1).map(|name| format!("<th scope=\"row\">{name}</th>")));
                out.extend(numbers.iter().map(|number| format!("<td>{number}</td>")));
                out.push_str("</tr>\n");
            }
            out.push_str("</tbody>\n");
        }
        out
    }

    /// Whether a row has so many cells, and all of them with their labels so short, that a card takes two side by side.
    fn fits_in_pairs(&self) -> bool {
        let length = |cell: &String| plain(cell).chars().count();
        let widest = |at: usize| self.rows.iter().filter_map(|row| row.get(at)).map(length).max().unwrap_or(0);
        matches!(self.cells, Cells::Numbers)
            && self.head.len() > 6
            && self.head.iter().enumerate().skip(1).all(|(at, head)| length(head) + widest(at) <= 22)
    }

    /// On a narrow page a number at the head of a row says what it is.
    fn first_label(&self) -> String {
        let label = self.head.first().filter(|_| matches!(self.cells, Cells::Numbers));
        label.map_or_else(String::new, |head| format!(" data-label=\"{} \"", escape(&plain(head))))
    }

    /// The table as CSV: the text of its cells, with `^` before a superscript and a hyphen as the sign of a number, so that
    /// a program can read it.
    pub fn csv(&self) -> anyhow::Result<String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let (head, rows) = self.data.as_ref().map_or((&self.head, &self.rows), |(head, rows)| (head, rows));
        for row in std::iter::once(head).chain(rows) {
            writer.write_record(row.iter().map(|cell| {
                let text = plain(&with_texts(cell).replace("<sup>", "^"));
                let number = text.replace('−', "-");
                if number.parse::<f64>().is_ok() { number } else { text }
            }))?;
        }
        Ok(String::from_utf8(writer.into_inner()?)?)
    }
}

/// Whether a cell says nothing, or only says so, by a dash: a card leaves it out.
fn is_empty(cell: &str) -> bool {
    ["", "–"].contains(&plain(cell).as_str())
}

/// Markup in which each formula that says its text gives way to it: a `span` with an attribute `data-text`.
fn with_texts(html: &str) -> String {
    let mut pieces = html.split("<span data-text=\"");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (text, markup) = piece.split_once('"').unwrap_or((piece, ""));
        out += text;
        out += markup.split_once("</span>").map_or("", |(_, behind)| behind);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::bail;

    #[test]
    fn the_data_of_a_table_are_its_words() {
        let table = Table::with_rows(Cells::NamedNumbers, [()])
            .column("What", |()| escape("a_1 & b"))
            .column("Size, mm", |()| "<a href=\"x\">2.5</a>&nbsp;mm")
            .finish()
            .expect("a table");
        assert_eq!(table.csv().expect("data"), "What,\"Size, mm\"\na_1 & b,2.5 mm\n");
        let formula = "<span data-text=\"3 × 10&#94;−25 m\"><math></math></span>";
        let table = Table::with_rows(Cells::Numbers, ["−31.5"])
            .column("Less", |less| *less)
            .column("Small", |_| formula)
            .finish()
            .expect("a table");
        assert_eq!(table.csv().expect("data"), "Less,Small\n-31.5,3 × 10^−25 m\n");
    }

    #[test]
    fn rows_with_the_same_first_cell_stand_together_and_the_data_may_have_columns_of_their_own() {
        let table = Table::with_rows(Cells::Grouped, [("a", 1_u32), ("a", 2), ("b", 1)])
            .column("What", |(what, _)| *what)
            .column("Number", |(_, number)| *number)
            .column("Square", |(_, number)| number * number)
            .with_data(["what", "sum"], |(what, number)| [(*what).to_owned(), (number + number).to_string()])
            .finish()
            .expect("a table");
        let html = table.html("Squares");
        assert_eq!(html.matches("<tbody>").count(), 2, "{html}");
        let first = "<tr><th scope=\"rowgroup\" rowspan=\"2\">a</th><th scope=\"row\">1</th><td>1</td></tr>\n<tr><th \
                     scope=\"row\">2</th><td>4</td></tr>\n</tbody>";
        assert!(html.contains(first), "{html}");
        assert!(html.contains("<th scope=\"rowgroup\" rowspan=\"1\">b</th>"), "{html}");
        assert_eq!(table.csv().expect("data"), "what,sum\na,2\na,4\nb,2\n");
    }

    #[test]
    fn each_column_says_its_cell_in_every_row_and_the_first_that_cannot_stops_the_table() {
        let squares = |last: u32| {
            Table::with_rows(Cells::Numbers, 1..=last)
                .column("n", |n| *n)
                .columns(
                    [2, 3],
                    |power| format!("to the power {power}"),
                    |n, power| match n.checked_pow(*power) {
                        Some(number) => Ok(number.to_string()),
                        None => bail!("{n} to the power {power} is too large"),
                    },
                )
                .finish()
        };
        let csv = squares(3).expect("a table").csv().expect("data");
        assert_eq!(csv, "n,to the power 2,to the power 3\n1,1,1\n2,4,8\n3,9,27\n");
        let error = squares(70_000).err().expect("an error").to_string();
        assert_eq!(error, "65536 to the power 2 is too large");
    }
}
