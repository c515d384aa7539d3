//! Options of a command stay in one piece where their line breaks: a browser would break them behind their hyphens.

use crate::html::{GLUED, escape};
use crate::maths::apply;
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// A page in Markdown and HTML, in the code of which no line breaks within an option of a command.
pub(crate) fn in_one_piece(page: &str) -> String {
    let mut edits = Vec::new();
    let mut command = None;
    for (event, range) in Parser::new_ext(page, Options::ENABLE_TABLES | Options::ENABLE_GFM).into_offset_iter() {
        match event {
            Event::Code(text) if text.contains("--") => edits.push((range, format!("<code>{}</code>", escape(&text)))),
            // In a list or a quotation a block of HTML would not stay one.
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info)))
                if &*info == "sh" && (range.start == 0 || page[..range.start].ends_with('\n')) =>
            {
                command = Some(String::new());
            }
            Event::Text(text) => {
                if let Some(command) = &mut command {
                    command.push_str(&text);
                }
            }
            Event::End(TagEnd::CodeBlock) => {
                if let Some(text) = command.take() {
                    edits.push((range, format!("<pre><code class=\"language-sh\">{}</code></pre>\n", escape(&text))));
                }
            }
            _ => {}
        }
    }
    glued(&apply(page, &edits))
}

/// HTML with a box that does not break around each option within `code`.
fn glued(html: &str) -> String {
    let mut pieces = html.split("<code");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (code, behind) = piece.split_at(piece.find("</code>").unwrap_or(0));
        out += "<code";
        out += &with_boxes(code);
        out += behind;
    }
    out
}

fn with_boxes(code: &str) -> String {
    const HYPHENS: [&str; 2] = ["--", "&#45;&#45;"];
    /// Most letters of a value that stays with its option.
    const SHORT: usize = 12;
    let value = |from: usize| {
        let behind = code[from..].strip_prefix(' ').filter(|value| !HYPHENS.iter().any(|of| value.starts_with(of)));
        let length = behind.map_or(0, |value| value.find([' ', '\n', '\\', '&', '<']).unwrap_or(value.len()));
        if (1..=SHORT).contains(&length) { from + 1 + length } else { from }
    };
    let begins = |at: usize| {
        let hyphens = HYPHENS.into_iter().find(|hyphens| code[at..].starts_with(hyphens))?;
        let name = code[at + hyphens.len()..].find(|c: char| !c.is_ascii_alphanumeric() && c != '-');
        let end = name.map_or(code.len(), |length| at + hyphens.len() + length);
        (end > at + hyphens.len()).then(|| value(end))
    };
    let (mut out, mut at) = (String::new(), 0);
    for (start, _) in code.char_indices() {
        let is_first = start >= at && !code[..start].ends_with(['-', ';']) || start == 0;
        if let Some(end) = begins(start).filter(|_| is_first) {
            out += &format!("{}{GLUED}{}</span>", &code[at..start], &code[start..end]);
            at = end;
        }
    }
    out + &code[at..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_option_of_a_command_has_its_box() {
        let hyphens = "&#45;&#45;";
        let boxed = |option: &str| format!("{GLUED}{hyphens}{option}</span>");
        let inline = in_one_piece("Run `geneva --at-dtmin stop --kept`, or `a - b`.");
        assert_eq!(
            inline,
            format!("Run <code>geneva {} {}</code>, or `a - b`.", boxed("at-dtmin stop"), boxed("kept"))
        );
        let block = in_one_piece("```sh\ncargo run -- wheel --pins 2 \\\n    --wheel-material phosphor-bronze\n```\n");
        let expected = format!(
            "<pre><code class=\"language-sh\">cargo run {hyphens} wheel {} &#92;\n    {} phosphor-bronze\n</code></pre>",
            boxed("pins 2"),
            boxed("wheel-material")
        );
        assert_eq!(block.trim_end(), expected);
        assert_eq!(
            in_one_piece("<td><code>--x</code> --y</td>"),
            format!("<td><code>{GLUED}--x</span></code> --y</td>")
        );
        for left in ["```rust\nlet a = \"--b\";\n```\n", "words -- and --more", "`x--`"] {
            assert_eq!(in_one_piece(left).replace("<code>x&#45;&#45;</code>", "`x--`"), left);
        }
    }
}
