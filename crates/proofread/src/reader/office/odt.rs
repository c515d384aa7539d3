//! Texts of LibreOffice: OpenDocument (ISO/IEC 26300), of which the text, its tables, its notes and its formulas are read.

use super::super::tags::{Tag, next_tag};
use super::super::unread::{UnreadKind, UnreadParts, note};
use super::archive::Archive;
use super::blocks::{BlockPlace, BlockWriter};
use super::nodes::{decoded, end_of, parse, plain_text};
use super::page::MadePage;
use super::presentation;
use super::word::RunPrint;
use std::collections::HashMap;
use std::ops::Range;

/// What such a text is called in errors.
const CALLED: &str = ".odt";
/// Deepest nesting of boxes, notes and tables in each other.
const DEEPEST: usize = 8;
/// Most spaces that one element stands for.
const MOST_SPACES: usize = 100;

/// Reads the text in an archive, and what of it is not read.
pub(super) fn read(mut archive: Archive<'_>) -> Result<(MadePage, UnreadParts), String> {
    let manifest = archive.text("META-INF/manifest.xml")?.unwrap_or_default();
    if manifest.contains("encryption-data") {
        return Err("the file is encrypted; save it without a password".to_owned());
    }
    let content = archive.needed("content.xml", CALLED)?;
    let body = content.find("<office:body").unwrap_or(0);
    let mut reading = OdtReading {
        xml: &content,
        styles: styles(&content[..body]),
        archive,
        writer: BlockWriter::default(),
        notes: 0,
    };
    reading.blocks(body..content.len(), BlockPlace::Body, 0)?;
    if let Some(pages) = reading.archive.text("styles.xml")? {
        note_headers(&pages, &mut reading.writer.unread);
    }
    Ok((reading.writer.page, reading.writer.unread))
}

/// Counts the headers and footers of pages, which are kept beside the styles.
fn note_headers(xml: &str, unread: &mut UnreadParts) {
    let mut at = 0;
    while let Some(tag) = next_tag(xml, at) {
        at = tag.end;
        let kind =
            ["header", "footer"].into_iter().find(|kind| tag.name == *kind || tag.name == format!("{kind}-left"));
        if let Some(kind) = kind.filter(|_| !tag.closes && !tag.empty) {
            let end = end_of(xml, &tag);
            note(unread, UnreadKind::Element, kind, &plain_text(&xml[tag.end..end]));
            at = end;
        }
    }
}

/// The styles that raise, lower or strike out characters, by their names.
fn styles(xml: &str) -> HashMap<String, RunPrint> {
    let (mut out, mut at, mut name) = (HashMap::new(), 0, String::new());
    while let Some(tag) = next_tag(xml, at) {
        at = tag.end;
        match tag.name.as_str() {
            "style" if !tag.closes => name = tag.attribute("name").unwrap_or_default().to_owned(),
            "text-properties" => {
                let position = tag.attribute("text-position").unwrap_or_default().trim();
                let script = match position.strip_suffix("58%").unwrap_or(position).split_whitespace().next() {
                    Some("super") => Some("sup"),
                    Some("sub") => Some("sub"),
                    Some(height) if height.starts_with('-') => Some("sub"),
                    Some(height) if !height.starts_with('0') => Some("sup"),
                    _ => None,
                };
                let line = tag.attribute("text-line-through-style").unwrap_or("none");
                let struck = line != "none" || tag.attribute("display") == Some("none");
                if script.is_some() || struck {
                    out.insert(name.clone(), RunPrint { script, struck });
                }
            }
            _ => {}
        }
    }
    out
}

struct OdtReading<'x, 'b> {
    xml: &'x str,
    styles: HashMap<String, RunPrint>,
    archive: Archive<'b>,
    writer: BlockWriter,
    notes: usize,
}

impl OdtReading<'_, '_> {
    /// Reads paragraphs and tables.
    fn blocks(&mut self, range: Range<usize>, place: BlockPlace, depth: usize) -> Result<(), String> {
        let xml = self.xml;
        let mut later: Vec<(Range<usize>, BlockPlace)> = Vec::new();
        let mut run = RunPrint::default();
        let mut spans: Vec<RunPrint> = Vec::new();
        let mut at = range.start;
        loop {
            let tag = next_tag(xml, at).filter(|tag| tag.start < range.end);
            let end = tag.as_ref().map_or(range.end, |tag| tag.start).max(at);
            // White space between words is one space, as in HTML.
            self.writer.characters(&decoded(&xml[at..end]));
            let Some(tag) = tag else { break };
            at = tag.end;
            match (tag.name.as_str(), tag.closes) {
                ("p" | "h", true) => {
                    spans.clear();
                    run.set(RunPrint::default(), &mut self.writer);
                    self.writer.end_paragraph(place);
                }
                ("span", true) => {
                    spans.pop();
                    run.set(spans.last().copied().unwrap_or_default(), &mut self.writer);
                }
                ("table-cell", true) => self.writer.end_cell(place),
                ("table-row", true) => self.writer.end_row(place),
                ("table", true) => self.writer.end_table(place),
                (_, true) => {}
                ("p" | "h", _) if !tag.empty => {
                    self.writer.begin_paragraph(place);
                    if tag.name == "h" && place == BlockPlace::Body {
                        self.writer.mark_heading();
                    }
                }
                ("span", _) if !tag.empty => {
                    let outer = spans.last().copied().unwrap_or_default();
                    let own = tag.attribute("style-name").and_then(|name| self.styles.get(name)).copied();
                    let own = own.map_or(outer, |own| RunPrint {
                        script: own.script.or(outer.script),
                        struck: own.struck || outer.struck,
                    });
                    spans.push(own);
                    run.set(own, &mut self.writer);
                }
                ("table", _) if !tag.empty && (self.writer.in_table() || self.writer.in_paragraph()) => {
                    at = end_of(xml, &tag);
                    later.push((tag.start..at, place));
                }
                ("table", _) if !tag.empty => self.writer.begin_table(place),
                ("table-row", _) => self.writer.begin_row(),
                ("table-cell", _) => self.begin_cell(&tag, place),
                ("note", _) if !tag.empty => {
                    at = end_of(xml, &tag);
                    let kind = if tag.attribute("note-class") == Some("endnote") { "endnote" } else { "footnote" };
                    self.notes += 1;
                    later.push((tag.end..at, BlockPlace::Note(kind, self.notes)));
                }
                ("note-citation", _) if !tag.empty => at = end_of(xml, &tag),
                ("text-box", _) if !tag.empty => {
                    at = end_of(xml, &tag);
                    later.push((tag.end..at, BlockPlace::Box));
                }
                ("annotation", _) if !tag.empty => {
                    at = end_of(xml, &tag);
                    note(&mut self.writer.unread, UnreadKind::Comment, "", &plain_text(&xml[tag.end..at]));
                }
                ("tracked-changes", _) if !tag.empty => {
                    at = end_of(xml, &tag);
                    self.deletions(tag.end..at);
                }
                ("frame", _) if !tag.empty => {
                    if let Some(end) = self.formula_in_frame(&tag)? {
                        at = end;
                    }
                }
                ("image", _) => self.writer.picture(""),
                ("s", _) => {
                    let count = tag.attribute("c").and_then(|count| count.parse().ok()).unwrap_or(1usize);
                    self.writer.characters(&" ".repeat(count.min(MOST_SPACES)));
                }
                ("tab", _) => self.writer.characters("\u{2003}"),
                ("line-break", _) => self.writer.line_break(),
                ("title" | "desc" | "ruby-text" | "forms" | "sequence-decls" | "variable-decls", _) if !tag.empty => {
                    at = end_of(xml, &tag);
                }
                _ => {}
            }
        }
        run.set(RunPrint::default(), &mut self.writer);
        if self.writer.in_table() {
            self.writer.end_table(place);
        }
        self.writer.end_paragraph(place);
        self.writer.leave_headings();
        for (range, place) in later {
            if depth >= DEEPEST {
                let text = plain_text(&xml[range]);
                note(&mut self.writer.unread, UnreadKind::Element, "nested too deeply", &text);
                continue;
            }
            if place == BlockPlace::Box {
                self.writer.begin_box();
            }
            self.blocks(range, place, depth + 1)?;
        }
        Ok(())
    }

    fn begin_cell(&mut self, tag: &Tag<'_>, place: BlockPlace) {
        /// Most columns of a table.
        const MOST_COLUMNS: usize = 64;
        let count = |name: &str| tag.attribute(name).and_then(|count| count.parse::<usize>().ok()).unwrap_or(1);
        // Cells without content are written once for several.
        let repeated = if tag.empty { count("number-columns-repeated").clamp(1, MOST_COLUMNS) } else { 1 };
        for _ in 0..repeated {
            self.writer.begin_cell(count("number-columns-spanned"), count("number-rows-spanned"));
            if tag.empty {
                self.writer.end_cell(place);
            }
        }
    }

    /// Counts what was deleted while changes were recorded.
    fn deletions(&mut self, range: Range<usize>) {
        let mut at = range.start;
        while let Some(tag) = next_tag(self.xml, at).filter(|tag| tag.start < range.end) {
            at = tag.end;
            if tag.name == "deletion" && !tag.closes && !tag.empty {
                at = end_of(self.xml, &tag);
                note(&mut self.writer.unread, UnreadKind::Comment, "", &plain_text(&self.xml[tag.end..at]));
            }
        }
    }

    /// Reads the formula in a frame, if it has one, and returns the byte behind the frame.
    fn formula_in_frame(&mut self, frame: &Tag<'_>) -> Result<Option<usize>, String> {
        let Some(tag) = next_tag(self.xml, frame.end).filter(|tag| !tag.closes) else { return Ok(None) };
        let end = end_of(self.xml, frame);
        match tag.name.as_str() {
            "object" => {}
            "object-ole" => {
                self.count_object("OLE object");
                return Ok(Some(end));
            }
            _ => return Ok(None),
        }
        let name = decoded(tag.attribute("href").unwrap_or_default());
        let name = name.trim_start_matches("./").trim_end_matches('/');
        let formula = match name {
            "" => Some(self.xml[tag.end..end].to_owned()),
            name => self.archive.text(&format!("{name}/content.xml"))?,
        };
        let formula = formula.unwrap_or_default();
        let mut at = 0;
        while let Some(tag) = next_tag(&formula, at) {
            at = tag.end;
            if tag.name == "math" && !tag.empty && !tag.closes {
                let (math, _, is_whole) = parse(&formula, tag);
                if self.writer.in_paragraph() {
                    presentation::add(&mut self.writer.page, &math, is_whole);
                }
                return Ok(Some(end));
            }
        }
        self.count_object("embedded object");
        Ok(Some(end))
    }

    fn count_object(&mut self, name: &str) {
        self.writer.unread.count(UnreadKind::Object, name, 1);
        self.writer.picture(name);
    }
}
