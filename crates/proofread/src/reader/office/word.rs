//! Documents of Word: Office Open XML (ECMA-376, part 1), of which the text, its tables and its notes are read.

use super::super::tags::{Tag, next_tag};
use super::super::unread::{UnreadKind, UnreadParts, note};
use super::archive::Archive;
use super::blocks::{BlockPlace, BlockWriter};
use super::formula::symbol;
use super::nodes::{decoded, end_of, parse, plain_text};
use super::omml;
use super::page::MadePage;
use super::word_styles::HeadingStyles;
use std::ops::Range;

/// What a document of Word is called in errors.
const CALLED: &str = ".docx";
/// Deepest nesting of boxes and tables in each other.
const DEEPEST: usize = 8;

/// Reads the document in an archive, and what of it is not read.
pub(super) fn read(mut archive: Archive<'_>) -> Result<(MadePage, UnreadParts), String> {
    let main = main_name(&mut archive)?;
    let document = archive.needed(&main, CALLED)?;
    let folder = main.rsplit_once('/').map_or("", |(folder, _)| folder);
    let beside = |name: &str| if folder.is_empty() { name.to_owned() } else { format!("{folder}/{name}") };
    let headings =
        archive.text(&beside("styles.xml"))?.map_or_else(HeadingStyles::default, |xml| HeadingStyles::read(&xml));
    let mut writer = BlockWriter::default();
    blocks(&document, 0..document.len(), &mut writer, &headings, BlockPlace::Body, 0);
    drop(document);
    for (part, element, kind) in [("footnotes.xml", "footnote", "footnote"), ("endnotes.xml", "endnote", "endnote")] {
        if let Some(notes) = archive.text(&beside(part))? {
            read_notes(&notes, element, kind, &mut writer);
        }
    }
    if let Some(comments) = archive.text(&beside("comments.xml"))? {
        each_element(&comments, "comment", &mut |_, inside| {
            note(&mut writer.unread, UnreadKind::Comment, "", &plain_text(&comments[inside]));
        });
    }
    for name in archive.names() {
        let part = name.strip_prefix(folder).unwrap_or_default().trim_start_matches('/');
        let kind = ["header", "footer"].into_iter().find(|kind| part.starts_with(kind) && part.ends_with(".xml"));
        if let Some(kind) = kind
            && let Some(text) = archive.text(&name)?
        {
            note(&mut writer.unread, UnreadKind::Element, kind, &plain_text(&text));
        }
    }
    Ok((writer.page, writer.unread))
}

/// The name of the part with the text.
fn main_name(archive: &mut Archive<'_>) -> Result<String, String> {
    let relations = archive.text("_rels/.rels")?.unwrap_or_default();
    let mut at = 0;
    while let Some(tag) = next_tag(&relations, at) {
        at = tag.end;
        if tag.name == "relationship"
            && tag.attribute("Type").is_some_and(|kind| kind.ends_with("/officeDocument"))
            && let Some(target) = tag.attribute("Target")
        {
            return Ok(decoded(target).trim_start_matches('/').to_owned());
        }
    }
    Ok("word/document.xml".to_owned())
}

/// Hands over the elements of this name, each with its tag and the place of its content.
fn each_element(xml: &str, name: &str, each: &mut dyn FnMut(&Tag<'_>, Range<usize>)) {
    let mut at = 0;
    while let Some(tag) = next_tag(xml, at) {
        at = tag.end;
        if tag.name == name && !tag.closes && !tag.empty {
            let end = end_of(xml, &tag);
            each(&tag, tag.end..end);
            at = end;
        }
    }
}

fn read_notes(xml: &str, element: &str, kind: &'static str, writer: &mut BlockWriter) {
    let mut number = 0;
    each_element(xml, element, &mut |tag, inside| {
        // Of these types are the lines between text and notes.
        if tag.attribute("type").is_none_or(|kind| kind == "normal") {
            number += 1;
            blocks(xml, inside, writer, &HeadingStyles::default(), BlockPlace::Note(kind, number), 0);
        }
    });
}

/// Elements that hold settings, or what is told elsewhere.
const SKIPPED: [&str; 12] = [
    "sectpr",
    "tblpr",
    "tblgrid",
    "trpr",
    "sdtpr",
    "sdtendpr",
    "instrtext",
    "fallback",
    "rt",
    "numpicbullet",
    "comment",
    "rprchange",
];

/// Reads paragraphs and tables.
fn blocks(
    xml: &str,
    range: Range<usize>,
    writer: &mut BlockWriter,
    headings: &HeadingStyles,
    place: BlockPlace,
    depth: usize,
) {
    let mut later: Vec<(Range<usize>, BlockPlace)> = Vec::new();
    let mut run = RunPrint::default();
    let mut at = range.start;
    while let Some(tag) = next_tag(xml, at).filter(|tag| tag.start < range.end) {
        at = tag.end;
        let name = tag.name.as_str();
        if tag.closes {
            match name {
                "p" => {
                    run.set(RunPrint::default(), writer);
                    writer.end_paragraph(place);
                }
                "r" => run.set(RunPrint::default(), writer),
                "tc" => writer.end_cell(place),
                "tr" => writer.end_row(place),
                "tbl" => writer.end_table(place),
                _ => {}
            }
            continue;
        }
        match name {
            "p" if !tag.empty => writer.begin_paragraph(place),
            "tbl" if !tag.empty && (writer.in_table() || writer.in_paragraph()) => {
                at = end_of(xml, &tag);
                later.push((tag.start..at, place));
            }
            "tbl" if !tag.empty => writer.begin_table(place),
            "tr" => writer.begin_row(),
            "tc" if !tag.empty => {
                let columns = properties(xml, tag.end, "tcpr", "gridspan").and_then(|count| count.parse().ok());
                writer.begin_cell(columns.unwrap_or(1), 1);
            }
            "ppr" if !tag.empty => {
                at = end_of(xml, &tag);
                if place == BlockPlace::Body && headings.has(&xml[tag.end..at]) {
                    writer.mark_heading();
                }
            }
            "tcpr" if !tag.empty => at = end_of(xml, &tag),
            "txbxcontent" if !tag.empty => {
                at = end_of(xml, &tag);
                later.push((tag.end..at, BlockPlace::Box));
            }
            "rpr" if !tag.empty => {
                at = end_of(xml, &tag);
                run.set(RunPrint::read(&xml[tag.end..at]), writer);
            }
            "t" if !tag.empty => {
                let end = next_tag(xml, at).map_or(xml.len(), |next| next.start);
                writer.characters(&decoded(&xml[at..end]));
                at = end;
            }
            "omath" if !tag.empty => {
                let (formula, end, is_whole) = parse(xml, tag);
                if writer.in_paragraph() {
                    omml::add(&mut writer.page, &formula, is_whole);
                }
                at = end;
            }
            "del" | "movefrom" if !tag.empty => {
                at = end_of(xml, &tag);
                note(&mut writer.unread, UnreadKind::Comment, "", &plain_text(&xml[tag.end..at]));
            }
            "oleobject" => {
                let program = decoded(tag.attribute("ProgID").unwrap_or("OLE object"));
                writer.unread.count(UnreadKind::Object, &program, 1);
                writer.picture(&program);
            }
            "drawing" | "pict" => writer.picture(""),
            "sym" => writer.characters(symbol(tag.attribute("char")).encode_utf8(&mut [0; 4])),
            "tab" | "ptab" => writer.characters("\u{2003}"),
            "br" | "cr" => writer.line_break(),
            "nobreakhyphen" => writer.characters("-"),
            _ if SKIPPED.contains(&name) && !tag.empty => at = end_of(xml, &tag),
            _ => {}
        }
    }
    run.set(RunPrint::default(), writer);
    if writer.in_table() {
        writer.end_table(place);
    }
    writer.end_paragraph(place);
    writer.leave_headings();
    for (range, place) in later {
        if depth >= DEEPEST {
            note(&mut writer.unread, UnreadKind::Element, "nested too deeply", &plain_text(&xml[range]));
            continue;
        }
        if place == BlockPlace::Box {
            writer.begin_box();
        }
        blocks(xml, range, writer, headings, place, depth + 1);
    }
}

/// The value of a property of the element whose content begins here.
fn properties<'t>(xml: &'t str, at: usize, holder: &str, name: &str) -> Option<&'t str> {
    let open = next_tag(xml, at).filter(|tag| tag.name == holder && !tag.empty && !tag.closes)?;
    let mut at = open.end;
    loop {
        let tag = next_tag(xml, at).filter(|tag| tag.name != holder)?;
        if tag.name == name {
            return tag.attribute("val");
        }
        at = tag.end;
    }
}

/// How the characters of a run are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct RunPrint {
    /// The element of HTML for raised or lowered characters.
    pub script: Option<&'static str>,
    /// Whether the characters are struck out or hidden.
    pub struck: bool,
}

impl RunPrint {
    fn read(properties: &str) -> Self {
        let (mut out, mut at) = (Self::default(), 0);
        while let Some(tag) = next_tag(properties, at) {
            at = tag.end;
            let value = tag.attribute("val");
            let is_on = !tag.closes && !matches!(value, Some("0" | "off" | "false"));
            match tag.name.as_str() {
                "rprchange" => at = end_of(properties, &tag),
                "vertalign" => {
                    out.script = match value {
                        Some("superscript") => Some("sup"),
                        Some("subscript") => Some("sub"),
                        _ => None,
                    }
                }
                "strike" | "dstrike" | "vanish" => out.struck |= is_on,
                _ => {}
            }
        }
        out
    }

    /// Changes how the characters that follow are printed.
    pub(super) fn set(&mut self, new: Self, writer: &mut BlockWriter) {
        if *self == new || !writer.in_paragraph() {
            return;
        }
        let tag = |name: &str, slash: &str| format!("<{slash}{name}>");
        let marks = [(self.script, "/"), (self.struck.then_some("s"), "/")];
        marks.into_iter().filter_map(|(name, slash)| Some(tag(name?, slash))).for_each(|tag| writer.page.tags(&tag));
        let marks = [(new.struck.then_some("s"), ""), (new.script, "")];
        marks.into_iter().filter_map(|(name, slash)| Some(tag(name?, slash))).for_each(|tag| writer.page.tags(&tag));
        writer.page.shown(if new.script == Some("sup") { "^" } else { "" });
        *self = new;
    }
}
