//! Formulas that are in MathML already, as OpenDocument has them.

use super::formula::{self, Letters, accent, bracketed, element_shown_as, leaves};
use super::nodes::Node;
use super::page::MadePage;

/// Adds a formula; one that is not whole says so.
pub(super) fn add(page: &mut MadePage, of: &Node<'_>, is_whole: bool) {
    page.tags("<math>");
    nodes(page, &of.children);
    page.tags(if is_whole { "</math>" } else { "<unknown-nesting/></math>" });
}

fn nodes(page: &mut MadePage, of: &[Node<'_>]) {
    of.iter().for_each(|of| node(page, of));
}

fn open(page: &mut MadePage, of: &Node<'_>) {
    let name: String = of.name.chars().filter(char::is_ascii_alphanumeric).collect();
    page.tags(&format!("<{name}"));
    for attribute in ["mathvariant", "open", "close", "width", "linebreak", "notation", "linethickness"] {
        let value = of.attribute(attribute).unwrap_or_default();
        if !value.is_empty() && !value.contains(['<', '>', '"', '&']) {
            page.tags(&format!(" {attribute}=\"{value}\""));
        }
    }
    page.tags(">");
}

fn close(page: &mut MadePage, of: &Node<'_>) {
    let name: String = of.name.chars().filter(char::is_ascii_alphanumeric).collect();
    page.tags(&format!("</{name}>"));
}

fn node(page: &mut MadePage, of: &Node<'_>) {
    let children = of.children.as_slice();
    match (of.name.as_str(), children) {
        ("annotation" | "annotation-xml" | "mphantom" | "none" | "mprescripts", _) => {}
        ("semantics", [shown, ..]) => node(page, shown),
        ("mspace", _) => {
            open(page, of);
            close(page, of);
            page.shown(" ");
        }
        ("mfrac", [above, below]) => {
            open(page, of);
            argument(page, above);
            page.shown("/");
            argument(page, below);
            close(page, of);
        }
        ("msqrt", _) => {
            page.tags("<msqrt>");
            page.shown("√");
            bracketed(page, &mut |page| nodes(page, children));
            page.tags("</msqrt>");
        }
        ("mroot", [inside, degree]) if degree.children.is_empty() => {
            let at = page.text.len();
            page.shown(&format!("{}√", degree.text.trim()));
            page.tags("<mroot>");
            argument(page, inside);
            formula::add_at(page, &leaves(degree.text.trim(), Letters::Italic), at);
            page.tags("</mroot>");
        }
        ("mroot", [inside, degree]) => {
            page.tags("<mroot>");
            page.shown("√");
            argument(page, inside);
            page.shown(" to the root ");
            argument(page, degree);
            page.tags("</mroot>");
        }
        ("mover", [base, sign]) if !sign.text.trim().is_empty() => {
            page.tags("<mover><mrow>");
            node(page, base);
            page.tags("</mrow>");
            element_shown_as(page, "mo", accent(sign.text.trim()), "");
            page.tags("</mover>");
        }
        ("msup" | "msub" | "msubsup" | "munder" | "mover" | "munderover", [base, scripts @ ..]) => {
            open(page, of);
            page.tags("<mrow>");
            node(page, base);
            page.tags("</mrow>");
            for (at, script) in scripts.iter().enumerate() {
                let is_above = matches!(of.name.as_str(), "msup" | "mover") || at == 1;
                page.shown(if is_above { "^" } else { "_" });
                argument(page, script);
            }
            close(page, of);
        }
        ("mtable", rows) => {
            page.tags("<mtable>");
            for (at, row) in rows.iter().enumerate() {
                page.shown(if at > 0 { "; " } else { "" });
                page.tags("<mtr>");
                for (at, cell) in row.children.iter().enumerate() {
                    page.shown(if at > 0 { "  " } else { "" });
                    node(page, cell);
                }
                page.tags("</mtr>");
            }
            page.tags("</mtable>");
        }
        (_, []) => {
            open(page, of);
            let text = if of.name == "mtext" { of.text.as_str() } else { of.text.trim() };
            page.characters(text);
            close(page, of);
        }
        _ => {
            open(page, of);
            nodes(page, children);
            close(page, of);
        }
    }
}

fn argument(page: &mut MadePage, of: &Node<'_>) {
    bracketed(page, &mut |page| node(page, of));
}
