//! Small pieces of HTML that survive the Markdown parser.

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
}
