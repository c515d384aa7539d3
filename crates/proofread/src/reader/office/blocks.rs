//! Paragraphs, notes and tables of a document, in the order in which they are read.

use super::super::unread::UnreadParts;
use super::page::MadePage;
use std::sync::Arc;

/// Longest part of a heading that is told, in characters.
const LONGEST_HEADING: usize = 60;

/// Where the text that comes stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BlockPlace {
    /// In the body.
    Body,
    /// In a box of text.
    Box,
    /// In a note with this number.
    Note(&'static str, usize),
}

/// The cell that is open.
#[derive(Clone, Copy, Debug, Default)]
struct OpenTable {
    row: usize,
    cell: usize,
    in_cell: bool,
    has_text: bool,
}

/// A page as it is made, paragraph by paragraph.
#[derive(Default)]
pub(super) struct BlockWriter {
    pub page: MadePage,
    pub unread: UnreadParts,
    paragraphs: usize,
    tables: usize,
    boxes: usize,
    table: Option<OpenTable>,
    /// How long page and text were at the start of the paragraph that is open.
    open: Option<[usize; 2]>,
    /// Whether the paragraph that is open is a heading.
    is_heading: bool,
    /// The last heading.
    heading: Option<Arc<str>>,
}

impl BlockWriter {
    pub(super) fn in_paragraph(&self) -> bool {
        self.open.is_some()
    }

    pub(super) fn in_table(&self) -> bool {
        self.table.is_some()
    }

    /// Begins a paragraph.
    pub(super) fn begin_paragraph(&mut self, place: BlockPlace) {
        self.end_paragraph(place);
        match &self.table {
            Some(table) if table.in_cell => self.page.tags(if table.has_text { "<br/>\n" } else { "" }),
            _ => self.page.tags("<p>"),
        }
        self.open = Some([self.page.page.len(), self.page.text.len()]);
        self.is_heading = false;
    }

    /// Makes a heading of the paragraph that is open, unless it is in a table.
    pub(super) fn mark_heading(&mut self) {
        self.is_heading = self.in_paragraph() && !self.in_table();
    }

    /// Says that what comes has another place in the document than behind the last heading.
    pub(super) fn leave_headings(&mut self) {
        self.heading = None;
    }

    /// Ends a paragraph. One without text is none.
    pub(super) fn end_paragraph(&mut self, place: BlockPlace) {
        let Some([_, start]) = self.open.take() else { return };
        let is_empty = self.page.text.get(start..).is_none_or(|text| text.trim().is_empty());
        let cell = self.table.as_mut().filter(|table| table.in_cell);
        if cell.is_none() {
            self.page.tags("</p>\n");
        }
        if is_empty {
            return;
        }
        let label = match (cell, place) {
            (Some(table), _) => {
                table.has_text = true;
                format!("table {}, row {}, cell {}", self.tables, table.row, table.cell)
            }
            (None, BlockPlace::Body) => {
                self.paragraphs += 1;
                format!("paragraph {}", self.paragraphs)
            }
            (None, BlockPlace::Box) => format!("text box {}", self.boxes),
            (None, BlockPlace::Note(kind, number)) => format!("{kind} {number}"),
        };
        let above = if self.is_heading { None } else { self.heading.clone() };
        if self.is_heading {
            let text = self.page.text.get(start..).unwrap_or_default().trim();
            let mut told: String = text.chars().take(LONGEST_HEADING).collect();
            told += if told.len() < text.len() { "…" } else { "" };
            self.heading = Some(told.into());
        }
        self.page.end_line(label, above);
    }

    /// Begins the next box of text.
    pub(super) fn begin_box(&mut self) {
        self.boxes += 1;
    }

    pub(super) fn begin_table(&mut self, place: BlockPlace) {
        self.end_paragraph(place);
        self.tables += 1;
        self.table = Some(OpenTable::default());
        self.page.tags("<table>\n");
    }

    pub(super) fn end_table(&mut self, place: BlockPlace) {
        self.end_cell(place);
        if self.table.take().is_some() {
            self.page.tags("</table>\n");
        }
    }

    pub(super) fn begin_row(&mut self) {
        if let Some(table) = &mut self.table {
            (table.row, table.cell) = (table.row + 1, 0);
            self.page.tags("<tr>");
        }
    }

    pub(super) fn end_row(&mut self, place: BlockPlace) {
        self.end_cell(place);
        if self.table.is_some() {
            self.page.tags("</tr>\n");
        }
    }

    /// Begins a cell that covers so many columns and rows.
    pub(super) fn begin_cell(&mut self, columns: usize, rows: usize) {
        if let Some(table) = &mut self.table {
            table.cell += 1;
            (table.in_cell, table.has_text) = (true, false);
            let span =
                |name: &str, count: usize| if count > 1 { format!(" {name}=\"{count}\"") } else { String::new() };
            self.page.tags(&format!("<td{}{}>", span("colspan", columns), span("rowspan", rows)));
        }
    }

    pub(super) fn end_cell(&mut self, place: BlockPlace) {
        if self.table.as_ref().is_some_and(|table| table.in_cell) {
            self.end_paragraph(place);
            self.page.tags("</td>");
        }
        if let Some(table) = &mut self.table {
            table.in_cell = false;
        }
    }

    /// Adds characters, if a paragraph is open.
    pub(super) fn characters(&mut self, text: &str) {
        if self.in_paragraph() {
            self.page.characters(text);
        }
    }

    /// Adds the end of a line in a paragraph.
    pub(super) fn line_break(&mut self) {
        if self.in_paragraph() {
            self.page.tags("<br/>\n");
            self.page.shown(" ");
        }
    }

    /// Adds a picture or an object, which the text shows by its name.
    pub(super) fn picture(&mut self, name: &str) {
        if self.in_paragraph() {
            self.page.tags("<img/>");
            self.page.shown(&if name.is_empty() { String::new() } else { format!("[{name}]") });
        }
    }
}
