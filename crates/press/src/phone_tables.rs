//! Tables of Markdown whose cells bear the heads of their columns: on a phone each row is a card, and a value stands there
//! behind what it is a value of.

use crate::html::{escape, plain};

/// What mdBook puts about a table of Markdown.
const TABLE: &str = "<div class=\"table-wrapper\">";

/// A page with labels in the cells of its tables.
pub(crate) fn labelled(page: &str) -> String {
    let mut parts = page.split(TABLE);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (table, rest) = part.split_at(part.find("</table>").unwrap_or(0));
        out.extend([TABLE, &with_labels(table), rest]);
    }
    out
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
        assert_eq!(cards.replace(" data-label=\"size b \"", "").replace(" data-label=\"what \"", ""), page);
        let page = "<div class=\"table-wrapper\"><table><thead><tr><th>slots</th><th>3</th></tr></thead><tbody>\n\
                    <tr><td>share</td><td>0.2</td></tr>\n</tbody></table>\n</div>";
        assert!(labelled(page).contains("<td data-label=\"slots 3 \">0.2</td>"), "{}", labelled(page));
    }
}
