//! Small pieces of HTML that survive the Markdown parser.

use std::panic::Location;

/// Text as HTML that stands in Markdown and in HTML blocks alike: no character of it is markup in either, and no dashes
/// or points are joined to a typographer's one.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let (mut before, mut rest) = (' ', text.chars().peekable());
    while let Some(c) = rest.next() {
        let is_one_of_many = before == c || rest.peek() == Some(&c);
        before = c;
        match c {
            '-' | '.' if is_one_of_many => out.push_str(&format!("&#{};", u32::from(c))),
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' | '\'' | '*' | '_' | '`' | '[' | ']' | '\\' | '|' | '~' | '$' | '{' | '}' | '^' => {
                out.push_str(&format!("&#{};", u32::from(c)));
            }
            _ => out.push(c),
        }
    }
    out
}

/// Begins a stretch of a line that does not break.
pub const GLUED: &str = "<span class=\"glued\">";

/// Text as [`escape`] has it, with the index of a letter lowered: what stands behind a single letter and an underscore.
pub fn prose(text: &str) -> String {
    let escaped = escape(text);
    let mut pieces = escaped.split("&#95;");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let mut before = out.chars().rev();
        let is_letter =
            before.next().is_some_and(char::is_alphabetic) && !before.next().is_some_and(char::is_alphanumeric);
        let (index, rest) = match piece.strip_prefix("&#123;").and_then(|of| of.split_once("&#125;")) {
            Some(braced) => braced,
            None => piece.split_at(piece.find(|c: char| !c.is_alphanumeric() && c != '∞').unwrap_or(piece.len())),
        };
        match is_letter && !index.is_empty() {
            true => out += &format!("<sub>{index}</sub>{rest}"),
            false => out += &format!("&#95;{piece}"),
        }
    }
    out
}

/// Several lines of text for a program, as a block.
pub fn code(text: &str) -> String {
    format!("<pre><code class=\"language-text\">{}</code></pre>", escape(text))
}

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
}

/// A table before it is set: cells of HTML, the first of each row its head.
pub struct Table {
    caption: String,
    cells: Cells,
    head: Vec<String>,
    rows: Vec<Vec<String>>,
    /// What is said below it.
    legend: &'static str,
    /// The file that makes it.
    source: &'static str,
}

/// A table with a head under a caption. A row that cannot be made is an error of the table.
#[track_caller]
pub fn table(
    caption: &str,
    cells: Cells,
    head: &[&str],
    rows: impl IntoIterator<Item = anyhow::Result<Vec<String>>>,
) -> anyhow::Result<Table> {
    let source = Location::caller().file();
    let rows = rows.into_iter().collect::<Result<_, _>>()?;
    let head = head.iter().map(|cell| (*cell).to_owned()).collect();
    Ok(Table { caption: caption.to_owned(), cells, head, rows, legend: "", source })
}

impl Table {
    /// Adds some HTML below the table.
    pub fn with_legend(self, legend: &'static str) -> Self {
        Self { legend, ..self }
    }

    /// Whether a cell contains this piece of HTML.
    pub fn contains(&self, piece: &str) -> bool {
        self.rows.iter().flatten().any(|cell| cell.contains(piece))
    }

    /// What it shows, in a few words of plain text.
    pub fn caption(&self) -> &str {
        &self.caption
    }

    /// The file that makes it.
    pub fn source(&self) -> &'static str {
        self.source
    }

    /// The table without a number, under a name for screen readers.
    ///
    /// Each cell bears its column's head, which stands beside it where the page is too narrow for columns.
    pub fn html(&self) -> String {
        let class = match self.cells {
            Cells::Numbers if self.fits_in_pairs() => "compare pairs",
            Cells::Numbers => "compare",
            Cells::NamedNumbers => "compare named",
            Cells::Words => "listing",
            Cells::Wide => "listing wide",
        };
        let name = escape(&self.caption);
        let mut out =
            format!("<div class=\"{class}\" role=\"region\" tabindex=\"0\" aria-label=\"{name}\">\n<table>\n");
        out.push_str("<thead><tr>");
        for cell in &self.head {
            out.push_str(&format!("<th scope=\"col\">{cell}</th>"));
        }
        out.push_str("</tr></thead>\n<tbody>\n");
        for row in &self.rows {
            out.push_str("<tr>");
            for (at, cell) in row.iter().enumerate() {
                if at == 0 {
                    out.push_str(&format!("<th scope=\"row\"{}>{cell}</th>", self.first_label()));
                } else {
                    let label = self.head.get(at).map_or_else(String::new, |head| escape(&plain(head)));
                    // Beside its label a cell is one piece.
                    let cell = if matches!(self.cells, Cells::Words | Cells::Wide) {
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
        out.push_str("</tbody>\n</table>\n</div>");
        if !self.legend.is_empty() {
            out.push_str(&format!("\n{}", self.legend));
        }
        out
    }

    /// Whether a row has so many cells, and all of them with their labels so short, that a card takes two side by side.
    fn fits_in_pairs(&self) -> bool {
        let length = |cell: &String| plain(cell).chars().count();
        let widest = |at: usize| self.rows.iter().filter_map(|row| row.get(at)).map(length).max().unwrap_or(0);
        self.head.len() > 6 && self.head.iter().enumerate().skip(1).all(|(at, head)| length(head) + widest(at) <= 22)
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
        for row in std::iter::once(&self.head).chain(&self.rows) {
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

/// The text of a piece of HTML, without its tags.
pub fn plain(html: &str) -> String {
    let mut text = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find(['<', '&']) {
        text.push_str(&rest[..at]);
        let (end, is_tag) = if rest[at..].starts_with('<') { ('>', true) } else { (';', false) };
        let Some(length) = rest[at..].find(end) else { break };
        if !is_tag {
            text.push(character(&rest[at + 1..at + length]));
        }
        rest = &rest[at + length + 1..];
    }
    text.push_str(rest);
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The character that an entity stands for, of those that the pages have.
fn character(entity: &str) -> char {
    let numbered = entity.strip_prefix('#').and_then(|number| number.parse().ok()).and_then(char::from_u32);
    numbered.unwrap_or(match entity {
        "amp" => '&',
        "lt" => '<',
        "gt" => '>',
        "quot" => '"',
        _ => ' ',
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_character_is_left_that_markdown_or_html_would_take() {
        assert_eq!(escape("a<b & c_d*e"), "a&lt;b &amp; c&#95;d&#42;e");
        assert_eq!(escape("--set a-b ... c."), "&#45;&#45;set a-b &#46;&#46;&#46; c.");
        assert_eq!(prose("I_f/I_D and y_{n+1}"), "I<sub>f</sub>/I<sub>D</sub> and y<sub>n+1</sub>");
        assert_eq!(prose("a name_of_it, _ and x_"), escape("a name_of_it, _ and x_"));
    }

    #[test]
    fn the_data_of_a_table_are_its_words() {
        let rows = [Ok(vec![escape("a_1 & b"), "<a href=\"x\">2.5</a>&nbsp;mm".to_owned()])];
        let table = table("Two", Cells::NamedNumbers, &["What", "Size, mm"], rows).expect("a table");
        assert_eq!(table.csv().expect("data"), "What,\"Size, mm\"\na_1 & b,2.5 mm\n");
        let formula = "<span data-text=\"3 × 10&#94;−25 m\"><math></math></span>";
        let rows = [Ok(vec!["−31.5".to_owned(), formula.to_owned()])];
        let table = super::table("Three", Cells::Numbers, &["Less", "Small"], rows).expect("a table");
        assert_eq!(table.csv().expect("data"), "Less,Small\n-31.5,3 × 10^−25 m\n");
    }
}
