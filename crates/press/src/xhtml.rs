//! HTML as XML has it: XHTML, with its drawings and formulas inside.
//!
//! A tokenizer of HTML gives every name in small letters; XML has to know the capitals of SVG again.

/// The name spaces of the elements with which another language begins.
const NAME_SPACES: [(&str, &str); 2] =
    [("svg", "http://www.w3.org/2000/svg"), ("math", "http://www.w3.org/1998/Math/MathML")];

/// The elements and attributes of SVG whose names have capitals, as the HTML standard lists them, without filters and animation.
const CAPITALS: [&str; 25] = [
    "baseProfile",
    "clipPath",
    "clipPathUnits",
    "foreignObject",
    "gradientTransform",
    "gradientUnits",
    "lengthAdjust",
    "linearGradient",
    "markerHeight",
    "markerUnits",
    "markerWidth",
    "maskContentUnits",
    "maskUnits",
    "pathLength",
    "patternContentUnits",
    "patternTransform",
    "patternUnits",
    "preserveAspectRatio",
    "radialGradient",
    "refX",
    "refY",
    "spreadMethod",
    "startOffset",
    "textLength",
    "textPath",
];

/// The file of a page in an ebook.
pub(crate) fn file_name(page: &str) -> String {
    format!("{page}.xhtml")
}

/// Text that is no markup in XML, between tags and between quotation marks. Characters that XML does not have are left out.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' | '\r' => out.push(c),
            '\0'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => {}
            _ => out.push(c),
        }
    }
    out
}

/// What MathML 3 allows on no fraction and no table, but on an `mstyle` around it.
const OF_MSTYLE: [&str; 2] = ["displaystyle", "scriptlevel"];
/// What SVG 1.1 knows as a property of CSS only.
const OF_STYLE: &str = "paint-order";

/// Writes a tag that begins an element, and gives what ends it; an element that `ends_here` is whole. Inside a drawing, names have
/// the capitals of SVG. What cannot be the name of an attribute is left out.
pub(crate) fn start_tag(
    out: &mut String,
    name: &str,
    attributes: &[(String, String)],
    is_drawn: bool,
    ends_here: bool,
) -> String {
    let name = if is_drawn { with_capitals(name) } else { name };
    let written = |key: &str, value: &str| format!(" {key}=\"{}\"", escape(&without_variables(value)));
    let (mut own, mut around, mut style) = (String::new(), String::new(), String::new());
    if let Some((_, space)) = NAME_SPACES.iter().find(|(of, _)| *of == name) {
        own.push_str(&written("xmlns", space));
    }
    for (key, value) in attributes.iter().filter(|(key, _)| key != "xmlns" && is_name(key)) {
        match if is_drawn { with_capitals(key) } else { key } {
            key if OF_MSTYLE.contains(&key) && !["math", "mstyle"].contains(&name) => {
                around.push_str(&written(key, value))
            }
            OF_STYLE => style = format!("{OF_STYLE}: {value}; {style}"),
            "style" => style.push_str(value),
            key => own.push_str(&written(key, value)),
        }
    }
    if !style.is_empty() {
        own.push_str(&written("style", style.trim_end_matches([';', ' '])));
    }
    let (before, behind) = match around.is_empty() {
        true => (String::new(), ""),
        false => (format!("<mstyle{around}>"), "</mstyle>"),
    };
    out.push_str(&format!("{before}<{name}{own}"));
    if ends_here {
        out.push_str(&format!("/>{behind}"));
        return String::new();
    }
    out.push('>');
    format!("</{name}>{behind}")
}

fn with_capitals(name: &str) -> &str {
    match name {
        "viewbox" => "viewBox",
        _ => CAPITALS.iter().find(|of| of.eq_ignore_ascii_case(name)).unwrap_or(&name),
    }
}

fn is_name(key: &str) -> bool {
    key.starts_with(|c: char| c.is_ascii_alphabetic())
        && key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_'))
}

/// A value in which each variable of CSS has given way to what stands for it where it is not set: `var(--ink, #111)` is `#111`.
/// Readers for ebooks know no variables.
fn without_variables(value: &str) -> String {
    let mut out = String::with_capacity(value.len());
    let mut rest = value;
    while let Some((before, inside)) = rest.split_once("var(--") {
        out.push_str(before);
        let parts = inside.split_once(')').and_then(|(inside, after)| Some((inside.split_once(',')?.1, after)));
        let Some((instead, after)) = parts else {
            out.push_str("var(--");
            rest = inside;
            continue;
        };
        out.push_str(instead.trim());
        rest = after;
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tag(name: &str, attributes: &[(&str, &str)], is_drawn: bool) -> String {
        let attributes: Vec<_> = attributes.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
        let mut out = String::new();
        start_tag(&mut out, name, &attributes, is_drawn, true);
        out
    }

    #[test]
    fn a_tag_has_the_capitals_name_space_and_quotation_marks_of_xml() {
        let drawing = tag("svg", &[("xmlns", "x"), ("viewbox", "0 0 1 1"), ("width", "1")], true);
        assert_eq!(drawing, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\" width=\"1\"/>");
        assert_eq!(tag("lineargradient", &[("gradientunits", "a")], true), "<linearGradient gradientUnits=\"a\"/>");
        assert_eq!(tag("p", &[("viewbox", "a \"<&>"), ("a\"b", "c")], false), "<p viewbox=\"a &quot;&lt;&amp;&gt;\"/>");
        assert_eq!(
            tag("text", &[("paint-order", "stroke"), ("style", "a: b")], true),
            "<text style=\"paint-order: stroke; a: b\"/>"
        );
        assert_eq!(tag("mfrac", &[("displaystyle", "true")], false), "<mstyle displaystyle=\"true\"><mfrac/></mstyle>");
        assert!(tag("math", &[], false).contains(" xmlns=\"http://www.w3.org/1998/Math/MathML\""));
    }

    #[test]
    fn text_has_only_characters_of_xml() {
        assert_eq!(escape("a\u{1}b\u{ffff}\n<"), "ab\n&lt;");
    }

    #[test]
    fn a_variable_gives_way_to_what_stands_for_it() {
        assert_eq!(tag("p", &[("fill", "var(--fig-2, #b3400e)")], false), "<p fill=\"#b3400e\"/>");
        assert_eq!(tag("p", &[("style", "a: var(--b); c: var(--d, e)")], false), "<p style=\"a: var(--b); c: e\"/>");
        assert_eq!(without_variables("var(--"), "var(--");
    }
}
