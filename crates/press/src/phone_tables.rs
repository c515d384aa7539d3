//! Tables on a phone. Most stay tables in small print. Where cells hold sentences, each row is a card, and a value stands
//! there behind the head of its column.

use crate::html::{escape, plain};

/// What mdBook puts about a table of Markdown.
const TABLE: &str = "<div class=\"table-wrapper\">";

/// How the rows of a table are set on a phone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PhoneLayout {
    /// In columns, in small print.
    Columns,
    /// In columns with hardly any room between them.
    TightColumns,
    /// Each as a card.
    Cards,
}

impl PhoneLayout {
    /// The layouts in columns with their room for letters in a table of some columns, in pixels, and the size of the print.
    /// The style sheet has the same sizes: a phone is 390 pixels wide, and a table leaves 8 free at each side.
    const COLUMNS: [(Self, f64, f64); 2] = [(Self::Columns, 10.0, 12.5), (Self::TightColumns, 5.0, 12.0)];
    const PHONE: f64 = 374.0;

    /// Lines that a row has at most in columns. What is longer is read as a card.
    const MOST_LINES: f64 = 7.0;

    /// The layout of a table with this head and these rows, in HTML.
    ///
    /// Columns are taken if each is as wide as its longest word, and if the rows are no longer than as cards.
    pub(crate) fn of(head: &[String], rows: &[Vec<String>]) -> Self {
        let columns: Vec<Column> = (0..head.len()).map(|at| Column::of(head, rows, at)).collect();
        let fitting = Self::COLUMNS.into_iter().find(|(_, padding, print)| {
            let room = (Self::PHONE - padding * head.len() as f64) / print;
            Self::is_readable(&columns, room)
        });
        fitting.map_or(Self::Cards, |(layout, ..)| layout)
    }

    /// Whether columns fit into a room as wide as so many letters' sizes, and are the shorter way to show the rows.
    fn is_readable(columns: &[Column], room: f64) -> bool {
        let (least, most) = columns.iter().fold((0.0, 0.0), |(least, most), of| (least + of.least, most + of.most));
        if columns.is_empty() || least > room {
            return false;
        }
        // As a browser does it: what is left goes to those who want more.
        let share = if most > least { ((room - least) / (most - least)).min(1.0) } else { 1.0 };
        let width = |of: &Column| of.least + share * (of.most - of.least);
        let rows = columns.iter().map(|of| of.cells.len()).max().unwrap_or(0);
        let (mut in_columns, mut as_cards, mut longest) = (0.0, 0.0, 0.0_f64);
        for row in 0..rows {
            let cells = || columns.iter().filter_map(|of| of.cells.get(row).map(|cell| (of, *cell)));
            let lines = cells().map(|(of, cell)| (cell / width(of)).ceil()).fold(1.0, f64::max);
            in_columns += lines;
            longest = longest.max(lines);
            as_cards += 1.0 + cells().map(|(of, cell)| ((cell + of.head) / room).ceil()).sum::<f64>();
        }
        longest <= Self::MOST_LINES && in_columns <= as_cards
    }

    /// The class by which the style knows it.
    pub(crate) fn class(self) -> &'static str {
        match self {
            Self::Columns => " columns",
            Self::TightColumns => " columns tight",
            Self::Cards => "",
        }
    }
}

/// The widths of a column, in sizes of its letters.
struct Column {
    head: f64,
    /// Of its longest word.
    least: f64,
    /// Of its longest cell, on one line.
    most: f64,
    cells: Vec<f64>,
}

impl Column {
    fn of(head: &[String], rows: &[Vec<String>], at: usize) -> Self {
        let head = head.get(at).map_or("", String::as_str);
        let cells = || rows.iter().filter_map(|row| row.get(at)).map(String::as_str);
        let longest = |widths: &mut dyn Iterator<Item = f64>| widths.fold(0.0, f64::max);
        let words = |cell| longest(&mut words(cell).iter().map(|word| width(word)));
        let least = longest(&mut std::iter::once(head).chain(cells()).map(words));
        let widths: Vec<f64> = cells().map(|cell| width(&text(cell))).collect();
        let most = longest(&mut widths.iter().copied()).max(least);
        Self { head: width(&text(head)), least, most, cells: widths }
    }
}

/// The text of a cell, with a sign as wide as a digit for each space at which no line breaks.
fn text(cell: &str) -> String {
    let cell = cell.replace("&nbsp;", "_").replace('\u{a0}', "_");
    // What is set on a line of its own, or may be.
    plain(&["<br>", "<wbr>", "<small"].iter().fold(cell, |cell, tag| cell.replace(tag, &format!(" {tag}"))))
}

/// The pieces of a cell between which a line breaks. A formula is one, and so is what says that it does not break.
fn words(cell: &str) -> Vec<String> {
    let is_one = ["<math", "class=\"verdict", "class=\"claim"].iter().any(|sign| cell.contains(sign));
    match is_one {
        true => vec![text(cell)],
        false => text(cell).split_inclusive([' ', '-', '–', '/']).map(|word| word.trim_end().to_owned()).collect(),
    }
}

/// The width of a text in the book's face, in sizes of its letters, a little too great.
fn width(text: &str) -> f64 {
    let of = |c: char| match c {
        ' ' | 'i' | 'j' | 'l' | 'f' | 't' | 'r' | '.' | ',' | ':' | ';' | '\'' | '|' | '(' | ')' => 0.34,
        '0'..='9' | '_' | 'a'..='e' | 'g'..='h' | 'k' | 'n'..='q' | 's' | 'u'..='v' | 'x'..='z' => 0.55,
        'I' | 'J' => 0.4,
        'A'..='Z' | 'm' | 'w' => 0.8,
        _ => 0.65,
    };
    text.chars().map(of).sum()
}

/// A page with labels in the cells of its tables, and with the layout of each on a phone.
pub(crate) fn labelled(page: &str) -> String {
    let mut parts = page.split(TABLE);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (table, rest) = part.split_at(part.find("</table>").unwrap_or(0));
        let (head, body) = table.split_at(table.find("</thead>").unwrap_or(0));
        let head_cells = cells(head, "<th");
        let rows: Vec<_> = body.split("<tr>").skip(1).map(|row| cells(row, "<td")).collect();
        let class = PhoneLayout::of(&head_cells, &rows).class();
        out.push_str(&TABLE.replace("wrapper", &format!("wrapper{class}")));
        out.extend([&with_labels(table), rest]);
    }
    out
}

/// The cells of a row, each with what is behind its name in its tag.
fn cells(row: &str, tag: &str) -> Vec<String> {
    row.split(tag).skip(1).filter(|cell| cell.starts_with(['>', ' '])).map(|cell| format!("<{cell}")).collect()
}

/// A table with the head of its column in each cell. What stands first in a row is its name and needs no head, unless it is
/// a number.
fn with_labels(table: &str) -> String {
    let (head, body) = table.split_at(table.find("</thead>").unwrap_or(0));
    let mut heads: Vec<String> = head.split("<th").skip(2).map(|cell| escape(&plain(&format!("<{cell}")))).collect();
    // A number at the head of a column is one of what the first head says.
    if let Some((first, numbers)) = heads.split_first_mut()
        && numbers.iter().all(|head| head.starts_with(|c: char| c.is_ascii_digit()))
    {
        numbers.iter_mut().for_each(|head| *head = format!("{first} {head}"));
    }
    let mut out = head.to_owned();
    for (k, row) in body.split("<tr>").enumerate() {
        if k > 0 {
            out.push_str("<tr>");
        }
        let mut cells = row.split("<td");
        out.push_str(cells.next().unwrap_or_default());
        for (at, cell) in cells.enumerate() {
            let is_name = at == 0 && !plain(&format!("<{cell}")).starts_with(|c: char| c.is_ascii_digit());
            let label = heads.get(at).filter(|_| !is_name);
            out.push_str("<td");
            if let Some(label) = label {
                out.push_str(&format!(" data-label=\"{label} \""));
            }
            out.push_str(cell);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cell_but_a_name_bears_the_head_of_its_column() {
        let page = "<p>a</p><div class=\"table-wrapper\"><table><thead><tr><th>what</th><th style=\"text-align: right\">size \
                    <code>b</code></th></tr></thead><tbody>\n<tr><td>pin</td><td style=\"text-align: right\">1</td></tr>\n\
                    <tr><td>2</td><td></td></tr>\n</tbody></table>\n</div><td>";
        let cards = labelled(page);
        assert!(
            cards.contains("<tr><td>pin</td><td data-label=\"size b \" style=\"text-align: right\">1</td></tr>"),
            "{cards}"
        );
        assert!(cards.contains("<tr><td data-label=\"what \">2</td><td data-label=\"size b \"></td></tr>"), "{cards}");
        let bare = cards.replace(" data-label=\"size b \"", "").replace(" data-label=\"what \"", "");
        assert_eq!(bare.replace("table-wrapper columns", "table-wrapper"), page);
        let page = "<div class=\"table-wrapper\"><table><thead><tr><th>slots</th><th>3</th></tr></thead><tbody>\n\
                    <tr><td>share</td><td>0.2</td></tr>\n</tbody></table>\n</div>";
        assert!(labelled(page).contains("<td data-label=\"slots 3 \">0.2</td>"), "{}", labelled(page));
    }

    fn layout(head: &[&str], row: &[&str]) -> PhoneLayout {
        let owned = |cells: &[&str]| cells.iter().map(|cell| (*cell).to_owned()).collect::<Vec<_>>();
        PhoneLayout::of(&owned(head), &vec![owned(row); 5])
    }

    #[test]
    fn numbers_stay_in_columns_as_long_as_they_fit() {
        let (head, row) = (["greatest speed"; 12], ["−1234.5"; 12]);
        assert_eq!(layout(&head[..4], &row[..4]), PhoneLayout::Columns);
        let layouts: Vec<_> = (1..=12).map(|count| layout(&head[..count], &row[..count])).collect();
        assert!(layouts.contains(&PhoneLayout::TightColumns) && layouts[11] == PhoneLayout::Cards, "{layouts:?}");
        assert!(layouts.is_sorted_by_key(|layout| *layout as u8), "{layouts:?}");
    }

    #[test]
    fn a_sentence_is_read_as_a_card_and_a_few_words_in_a_column() {
        let head = ["What", "Value", "Why"];
        assert_eq!(layout(&head, &["pin", "2.5&nbsp;mm", "as printed"]), PhoneLayout::Columns);
        let sentence =
            "The program resets the driver's angle every quarter turn, whatever the number of pins. ".repeat(8);
        assert_eq!(layout(&head, &["pin", "2.5&nbsp;mm", &sentence]), PhoneLayout::Cards);
        // A formula does not break, and neither does a number before its unit.
        let long = "1&nbsp;2".repeat(20);
        assert_eq!(layout(&head, &["pin", &long, "as printed"]), PhoneLayout::Cards);
        let long = format!("<math><mi>{}</mi></math>", "x y ".repeat(16));
        assert_eq!(layout(&head, &["pin", &long, "as printed"]), PhoneLayout::Cards);
    }
}
