//! Lighter pages: what a browser has to fetch and no reader sees is left out.
//!
//! Nothing depends on it. The book that plain `mdbook build book` makes looks and works the same; its pages
//! are nearly forty kilobytes heavier.

/// Without comments, indentation and line ends; a comment that opens the file, where a licence stands, is kept.
pub(crate) fn style(css: &str) -> String {
    let (opening, mut rest) = match css.find("*/") {
        Some(end) if css.starts_with("/*") => css.split_at(end + 2),
        _ => ("", css),
    };
    let mut bare = String::with_capacity(css.len());
    while let Some((before, after)) = rest.split_once("/*") {
        bare.push_str(before);
        rest = after.split_once("*/").map_or("", |(_, after)| after);
    }
    bare.push_str(rest);
    let mut out = String::from(opening);
    for line in bare.lines().map(str::trim).filter(|line| !line.is_empty()) {
        // A selector or a value that goes on in the next line needs the space.
        out.push_str(line);
        if !line.ends_with(['{', '}', ';', ',']) {
            out.push(' ');
        }
    }
    out
}

/// Without indentation, empty lines and lines that are comments; a comment that opens the file is kept.
pub(crate) fn script(js: &str) -> String {
    let opening = js.lines().take_while(|line| line.starts_with("//")).count();
    let kept = js.lines().enumerate().filter(|(at, line)| {
        let line = line.trim_start();
        !line.is_empty() && (*at < opening || !line.starts_with("//"))
    });
    kept.map(|(_, line)| format!("{}\n", line.trim_start())).collect()
}

/// Without indentation, empty lines and comments around the text of the chapter.
pub(crate) fn page(html: &str) -> String {
    match (html.find("<main>"), html.rfind("</main>")) {
        (Some(start), Some(end)) if start < end => {
            format!("{}{}{}", frame(&html[..start]), &html[start..end], frame(&html[end..]))
        }
        _ => html.to_owned(),
    }
}

fn frame(html: &str) -> String {
    let lines = html.lines().map(str::trim).filter(|line| {
        let comment = line.starts_with("<!-- ") && line.ends_with(" -->");
        let script_comment = line.starts_with("// ");
        // The mark by which a later build knows that the book is its own to replace.
        !line.is_empty() && !script_comment && (!comment || line.contains("mdBook"))
    });
    lines.map(|line| format!("{line}\n")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn styles_keep_their_rules_and_their_licence() {
        let css = "/* Licence */\n/* note */\na,\nb {\n    color: red;\n    margin: 0\n        1px;\n}\n";
        assert_eq!(style(css), "/* Licence */a,b {color: red;margin: 0 1px;}");
        assert_eq!(style("@media print { a { b: c } }\n"), "@media print { a { b: c } }");
    }

    #[test]
    fn scripts_keep_their_lines() {
        let js = "// Licence\n// of it\n\n// note\nf();\n    // note\n    g('// no note');\n";
        assert_eq!(script(js), "// Licence\n// of it\nf();\ng('// no note');\n");
    }

    #[test]
    fn chapters_keep_every_character() {
        let html = "<body>\n   <!-- Sidebar -->\n   <main>\n  <pre>\n\n    // x\n</pre></main>\n\n  </body>\n";
        assert_eq!(page(html), "<body>\n<main>\n  <pre>\n\n    // x\n</pre></main>\n</body>\n");
        assert_eq!(page("<p>\n  a"), "<p>\n  a");
    }
}
