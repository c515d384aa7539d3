//! Small pieces of HTML that survive the Markdown parser.

use crate::maths;

/// Text as HTML that stands in Markdown and in HTML blocks alike: no character of it is markup in either.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
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

/// A piece of TeX as markup if it is TeX, else as text.
pub fn tex_or_text(text: &str) -> anyhow::Result<String> {
    let is_tex = text.contains(['\\', '{', '=']);
    if is_tex { maths::formula(text, false) } else { Ok(escape(text)) }
}

/// What a table holds, which decides how its cells are set.
#[derive(Clone, Copy)]
pub enum Cells {
    /// Numbers: to the right, on one line.
    Numbers,
    /// The same, with words at the head of each row.
    NamedNumbers,
    /// Words: to the left, broken where need be.
    Words,
}

/// A table with a head, which scrolls inside itself, under a name for screen readers.
///
/// The cells are HTML already; the first of each row is its head. A row that cannot be made is an error of the table.
pub fn table(
    name: &str,
    cells: Cells,
    head: &[&str],
    rows: impl IntoIterator<Item = anyhow::Result<Vec<String>>>,
) -> anyhow::Result<String> {
    let class = match cells {
        Cells::Numbers => "compare",
        Cells::NamedNumbers => "compare named",
        Cells::Words => "listing",
    };
    let name = escape(name);
    let mut out = format!("<div class=\"{class}\" role=\"region\" tabindex=\"0\" aria-label=\"{name}\">\n<table>\n");
    out.push_str("<thead><tr>");
    for cell in head {
        out.push_str(&format!("<th scope=\"col\">{cell}</th>"));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
    for row in rows {
        out.push_str("<tr>");
        for (at, cell) in row?.iter().enumerate() {
            let (open, close) = if at == 0 { ("th scope=\"row\"", "th") } else { ("td", "td") };
            out.push_str(&format!("<{open}>{cell}</{close}>"));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody>\n</table>\n</div>");
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_character_is_left_that_markdown_or_html_would_take() {
        assert_eq!(escape("a<b & c_d*e"), "a&lt;b &amp; c&#95;d&#42;e");
        assert_eq!(tex_or_text("10 mm").expect("text"), "10 mm");
        assert!(tex_or_text(r"\sqrt{2}").expect("TeX").contains("math"));
    }
}
