//! Which paragraphs of Word are headings: those of an outline level, by their style or by themselves (ECMA-376, part 1, 17.3.1.20).

use super::super::tags::next_tag;
use super::nodes::{decoded, end_of};
use std::collections::{HashMap, HashSet};

/// The number of the level that stands for running text.
const NO_LEVEL: &str = "9";
/// Most styles that are based on each other.
const MOST_BASES: usize = 16;

/// The styles of headings, by their identifiers.
#[derive(Debug, Default)]
pub(super) struct HeadingStyles {
    /// None if the document does not describe its styles.
    described: Option<HashSet<String>>,
}

/// What the properties of a paragraph say.
#[derive(Debug, Default)]
struct ParagraphProperties {
    style: Option<String>,
    /// Whether it has an outline level; none if that is not said.
    has_level: Option<bool>,
}

impl ParagraphProperties {
    fn read(xml: &str) -> Self {
        let (mut out, mut at) = (Self::default(), 0);
        while let Some(tag) = next_tag(xml, at) {
            at = tag.end;
            match tag.name.as_str() {
                // How it looked before a change.
                "pprchange" if !tag.empty && !tag.closes => at = end_of(xml, &tag),
                "pstyle" => out.style = tag.attribute("val").map(decoded),
                "outlinelvl" => out.has_level = tag.attribute("val").map(|level| level != NO_LEVEL),
                _ => {}
            }
        }
        out
    }
}

impl HeadingStyles {
    /// Reads the part of a document that describes its styles.
    pub(super) fn read(xml: &str) -> Self {
        let (mut headings, mut bases, mut at) = (HashSet::new(), HashMap::new(), 0);
        while let Some(tag) = next_tag(xml, at) {
            at = tag.end;
            if tag.name != "style" || tag.closes || tag.empty {
                continue;
            }
            at = end_of(xml, &tag);
            let Some(id) = tag.attribute("styleId").map(decoded) else { continue };
            let inside = &xml[tag.end..at];
            let (mut is_heading, mut inner) = (None, 0);
            while let Some(tag) = next_tag(inside, inner) {
                inner = tag.end;
                let value = tag.attribute("val").unwrap_or_default();
                match tag.name.as_str() {
                    // In every language, the styles that come with Word have these names in the file.
                    "name" if value.to_ascii_lowercase().starts_with("heading ") => is_heading = Some(true),
                    "basedon" => drop(bases.insert(id.clone(), decoded(value))),
                    "outlinelvl" => is_heading = Some(value != NO_LEVEL),
                    _ => {}
                }
            }
            match is_heading {
                Some(true) => drop(headings.insert(id)),
                Some(false) => drop(bases.remove(&id)),
                None => {}
            }
        }
        let is_based_on_heading = |id: &String| {
            let mut base = Some(id);
            (0..MOST_BASES).any(|_| {
                base = base.and_then(|id| bases.get(id));
                base.is_some_and(|id| headings.contains(id))
            })
        };
        let based: Vec<String> = bases.keys().filter(|id| is_based_on_heading(id)).cloned().collect();
        headings.extend(based);
        Self { described: Some(headings) }
    }

    /// Whether a paragraph with these properties is a heading.
    pub(super) fn has(&self, properties: &str) -> bool {
        let said = ParagraphProperties::read(properties);
        let by_style = || match (&said.style, &self.described) {
            (Some(style), Some(headings)) => headings.contains(style),
            (Some(style), None) => style.strip_prefix("Heading").is_some_and(|level| level.parse::<u8>().is_ok()),
            (None, _) => false,
        };
        said.has_level.unwrap_or_else(by_style)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_are_known_by_their_level_in_any_language() {
        let xml = "<w:styles><w:style w:styleId=\"Standard\"><w:name w:val=\"Normal\"/></w:style>\
            <w:style w:styleId=\"berschrift1\"><w:name w:val=\"heading 1\"/><w:basedOn w:val=\"Standard\"/></w:style>\
            <w:style w:styleId=\"Eigene\"><w:name w:val=\"Eigene\"/><w:basedOn w:val=\"berschrift1\"/></w:style>\
            <w:style w:styleId=\"Kasten\"><w:name w:val=\"Kasten\"/><w:basedOn w:val=\"berschrift1\"/><w:pPr><w:outlineLvl w:val=\"9\"/></w:pPr></w:style>\
            <w:style w:styleId=\"A\"><w:name w:val=\"A\"/><w:basedOn w:val=\"B\"/></w:style>\
            <w:style w:styleId=\"B\"><w:name w:val=\"B\"/><w:basedOn w:val=\"A\"/></w:style></w:styles>";
        let styles = HeadingStyles::read(xml);
        let style = |id: &str| format!("<w:pStyle w:val=\"{id}\"/>");
        for id in ["berschrift1", "Eigene"] {
            assert!(styles.has(&style(id)), "{id}");
        }
        for id in ["Standard", "Kasten", "A", "Heading1"] {
            assert!(!styles.has(&style(id)), "{id}");
        }
        assert!(
            styles.has("<w:outlineLvl w:val=\"1\"/>")
                && !styles.has(&(style("Eigene") + "<w:outlineLvl w:val=\"9\"/>"))
        );
        assert!(!styles.has(&format!("<w:pPrChange><w:pPr>{}</w:pPr></w:pPrChange>", style("Eigene"))));
        let without = HeadingStyles::default();
        assert!(without.has(&style("Heading2")) && !without.has(&style("Headings")) && !without.has(""));
    }
}
