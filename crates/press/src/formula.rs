//! One formula, from TeX to markup, while the book is built.
//!
//! A reader's browser receives KaTeX's HTML for the eye and MathML for the screen reader, and runs no script
//! for them. The same TeX gives the same bytes on every run.

use std::collections::BTreeSet;

use anyhow::{Context, anyhow, ensure};
use katex::types::{StrictMode, StrictSetting};
use katex::{KatexContext, Settings};

/// The markup of one formula, on one line; it may stand in HTML and in Markdown alike, table cells included.
///
/// A displayed formula comes in a `<span class="display">` that scrolls when it is wider than the page.
/// What KaTeX accepts but LaTeX would not is an error, not a warning.
pub fn formula(tex: &str, display: bool) -> anyhow::Result<String> {
    thread_local!(static CONTEXT: KatexContext = KatexContext::default());
    check_roots(tex)?;
    let settings = Settings::builder().display_mode(display).strict(StrictSetting::Mode(StrictMode::Error)).build();
    let markup = CONTEXT
        .with(|context| katex::render_to_string(context, tex.trim(), &settings))
        .map_err(|error| anyhow!("{error}"))
        .with_context(|| format!("the formula `{}`", tex.trim()))?;
    check_theme(&markup).with_context(|| format!("the formula `{}`", tex.trim()))?;
    let markup = tidy(&shorter(&markup));
    Ok(if display { format!("<span class=\"display\">{markup}</span>") } else { markup })
}

/// An error for a root of something without braces, `\sqrt 2`, which katex-rs draws through its own root sign.
fn check_roots(tex: &str) -> anyhow::Result<()> {
    for behind in tex.split("\\sqrt").skip(1) {
        let braced = behind.trim_start().starts_with(['{', '[']);
        ensure!(braced, "the formula `{}`: what stands under a root needs braces, \\sqrt{{…}}", tex.trim());
    }
    Ok(())
}

/// The classes of KaTeX whose letters the book's theme does not carry (`book/theme/katex.css`).
const ABSENT: [&str; 12] = [
    "mathfrak",
    "textfrak",
    "mathboldfrak",
    "mathscr",
    "textscr",
    "mathcal",
    "mathtt",
    "texttt",
    "mathsf",
    "textsf",
    "mathboldsf",
    "boldsymbol",
];

/// An error for what the theme has no letters or no size for; otherwise it would look wrong and say nothing.
fn check_theme(markup: &str) -> anyhow::Result<()> {
    for classes in markup.split("class=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        for class in classes.split(' ') {
            ensure!(!ABSENT.contains(&class), "the theme has no letters for `{class}`");
            let size = class.strip_prefix("reset-size").or_else(|| class.strip_prefix("size"));
            let named = size.is_some_and(|size| !["1", "3", "6"].contains(&size));
            ensure!(!named || classes.contains("delimsizing"), "the theme has no size commands such as \\large");
        }
    }
    Ok(())
}

/// Drops from the MathML what HTML does not need: the name space, and the copy of the TeX source that no
/// reader sees or hears.
fn shorter(markup: &str) -> String {
    let markup = match (markup.find("<annotation"), markup.find("</annotation>")) {
        (Some(start), Some(end)) => format!("{}{}", &markup[..start], &markup[end + "</annotation>".len()..]),
        _ => markup.to_owned(),
    };
    markup
        .replace(" xmlns=\"http://www.w3.org/1998/Math/MathML\"", "")
        .replace("<semantics>", "")
        .replace("</semantics>", "")
}

/// Attributes in alphabetical order, since katex-rs writes some of them in an order that changes from run
/// to run; and in the text between tags, whatever Markdown or mdBook would take for its own as an entity.
fn tidy(markup: &str) -> String {
    let mut out = String::with_capacity(markup.len());
    let mut rest = markup;
    while let Some(start) = rest.find('<') {
        shield(&rest[..start], &mut out);
        let end = rest[start..].find('>').map_or(rest.len(), |length| start + length + 1);
        sort_attributes(&rest[start..end], &mut out);
        rest = &rest[end..];
    }
    shield(rest, &mut out);
    out
}

fn shield(text: &str, out: &mut String) {
    for c in text.chars() {
        match c {
            '\n' => out.push(' '),
            '\\' | '`' | '*' | '_' | '[' | ']' | '~' | '|' | '\'' | '"' | '-' | '.' | '^' | '$' | '{' => {
                out.push_str(&format!("&#{};", u32::from(c)));
            }
            _ => out.push(c),
        }
    }
}

fn sort_attributes(tag: &str, out: &mut String) {
    let closing = if tag.ends_with("/>") { "/>" } else { ">" };
    let inside = tag.trim_end_matches(closing);
    let Some((name, attributes)) = inside.split_once(' ') else { return out.push_str(tag) };
    // `a="1" b="2"`: every second quotation mark ends an attribute.
    let mut sorted = BTreeSet::new();
    let mut quoted = attributes.split_inclusive('"');
    while let (Some(key), Some(value)) = (quoted.next(), quoted.next()) {
        sorted.insert(format!("{}{}", key.trim_start(), value.replace('\n', " ").replace('|', "&#124;")));
    }
    out.push_str(name);
    for attribute in sorted {
        out.push(' ');
        out.push_str(&attribute);
    }
    out.push_str(closing);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_latex_would_refuse_is_refused() {
        assert!(formula("é", false).is_err());
        assert!(formula("45°", false).is_ok());
    }

    #[test]
    fn a_root_needs_braces() {
        let error = formula("\\sqrt 2", false).unwrap_err().to_string();
        assert!(error.contains("needs braces"), "{error}");
        assert!(formula("\\sqrt{2} + \\sqrt[3]{x}", false).is_ok());
    }

    #[test]
    fn what_the_theme_cannot_show_is_refused() {
        for tex in ["\\mathcal{L}", "\\mathsf{x}", "{\\large x}", "\\boldsymbol{\\omega}"] {
            assert!(formula(tex, false).is_err(), "{tex}");
        }
        for tex in [
            "\\mathbf{x}^{y^z}",
            "\\Bigl(x\\Bigr)",
            "\\left(\\frac{\\frac ab}{\\frac cd}\\right)",
            "\\sum_{i=1}^n",
            "\\text{if } \\mathrm{d}x",
        ] {
            assert!(formula(tex, true).is_ok(), "{tex}");
        }
    }

    #[test]
    fn the_same_bytes_on_every_run() {
        let tex =
            "\\begin{aligned} a &= \\sqrt{\\frac{b}{c}} \\\\ \\left(\\dot x\\right) &= \\overline{d} \\end{aligned}";
        let once = formula(tex, true).unwrap();
        for _ in 0..20 {
            assert_eq!(std::thread::spawn(move || formula(tex, true).unwrap()).join().unwrap(), once);
        }
        assert!(!once.contains('\n'));
    }
}
