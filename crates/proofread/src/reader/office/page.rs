//! A page in HTML, made out of a document in another format, beside the text that the document's author sees.
//!
//! The page is what is proofread, with formulas in MathML. The text has a line for each paragraph, and each place of the page has
//! one in the text.

use super::super::LONGEST;
use crate::token::Span;
use std::sync::Arc;

/// What a line of the text is in the document.
#[derive(Debug)]
struct LineLabel {
    /// Such as `paragraph 12`.
    name: String,
    /// The heading above it.
    heading: Option<Arc<str>>,
}

/// A stretch of the page and the stretch of the text that it shows, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct ShownPlace {
    page: Span,
    text: Span,
}

/// A document made out of another format: what is proofread, and what its findings are told by.
#[derive(Debug, Default)]
pub(crate) struct MadePage {
    /// The page in HTML.
    pub page: String,
    /// The text as its author sees it.
    pub text: String,
    /// What each line of the text is in the document; none if the lines are those of the file.
    labels: Vec<LineLabel>,
    places: Vec<ShownPlace>,
}

impl MadePage {
    /// Whether the page is longer than what is read, so that no more is added.
    fn is_full(&self) -> bool {
        self.page.len() > LONGEST || self.text.len() > LONGEST
    }

    /// Adds tags, which the text does not show.
    pub(in crate::reader) fn tags(&mut self, tags: &str) {
        if !self.is_full() {
            self.page.push_str(tags);
        }
    }

    /// Adds characters that the page has at a place of the text.
    pub(in crate::reader) fn characters_at(&mut self, characters: &str, at: usize) {
        let mut at = at;
        for c in characters.chars() {
            if self.is_full() {
                return;
            }
            let start = self.page.len();
            match c {
                '<' => self.page.push_str("&lt;"),
                '>' => self.page.push_str("&gt;"),
                '&' => self.page.push_str("&amp;"),
                c => self.page.push(c),
            }
            let shown = ShownPlace { page: Span::new(start, self.page.len()), text: Span::new(at, at + c.len_utf8()) };
            at += c.len_utf8();
            self.place(shown);
        }
    }

    /// Adds characters of the page that stand for a stretch of the text as a whole.
    pub(in crate::reader) fn sign_for(&mut self, characters: &str, text: Span) {
        let start = self.page.len();
        self.tags(characters);
        self.places.push(ShownPlace { page: Span::new(start, self.page.len()), text });
    }

    fn place(&mut self, shown: ShownPlace) {
        let is_verbatim = |of: &ShownPlace| of.page.range().len() == of.text.range().len();
        match self.places.last_mut() {
            Some(last)
                if is_verbatim(last)
                    && is_verbatim(&shown)
                    && last.page.end == shown.page.start
                    && last.text.end == shown.text.start =>
            {
                last.page.end = shown.page.end;
                last.text.end = shown.text.end;
            }
            _ => self.places.push(shown),
        }
    }

    /// Adds characters to the page and to the text. A line of the text is a paragraph, so that white space in it is a space.
    pub(in crate::reader) fn characters(&mut self, characters: &str) {
        for c in characters.chars() {
            if self.is_full() {
                return;
            }
            let c = if c.is_control() { ' ' } else { c };
            let at = self.text.len();
            self.text.push(c);
            self.characters_at(c.encode_utf8(&mut [0; 4]), at);
        }
    }

    /// Adds what the text shows alone.
    pub(in crate::reader) fn shown(&mut self, characters: &str) {
        if !self.is_full() {
            self.text.push_str(characters);
        }
    }

    /// Takes a bracket out of the text that was not needed, with what is between these bytes.
    pub(in crate::reader) fn close_gap(&mut self, start: usize, end: usize) {
        if end > self.text.len() || start > end {
            return;
        }
        self.text.drain(start..end);
        let Span { end: length, .. } = Span::new(start, end);
        let gap = length - Span::new(start, start).start;
        for of in self.places.iter_mut().rev().take_while(|of| of.text.start >= length) {
            of.text.start -= gap;
            of.text.end -= gap;
        }
    }

    /// Ends a line of the text, which is called so and stands under a heading.
    pub(in crate::reader) fn end_line(&mut self, name: String, heading: Option<Arc<str>>) {
        if !self.is_full() {
            self.text.push('\n');
            self.labels.push(LineLabel { name, heading });
        }
    }

    /// Where a stretch of the page is in the text.
    pub(crate) fn span_in_text(&self, span: Span) -> Span {
        let first = self.places.partition_point(|of| of.page.end <= span.start);
        let behind = self.places.partition_point(|of| of.page.start < span.end);
        let within = |of: &ShownPlace, byte: u32| {
            let is_verbatim = of.page.range().len() == of.text.range().len();
            (is_verbatim && of.page.start <= byte && byte <= of.page.end).then(|| of.text.start + byte - of.page.start)
        };
        let covered = self.places.get(first..behind).unwrap_or_default();
        // A root has its degree behind it on the page, and before it on the line.
        let start = covered.iter().map(|of| within(of, span.start).unwrap_or(of.text.start)).min();
        let end = covered.iter().map(|of| within(of, span.end).unwrap_or(of.text.end)).max();
        match (start, end) {
            (Some(start), Some(end)) => Span { start, end: end.max(start) },
            _ => self.places.get(first).or(self.places.last()).map_or_else(Span::default, |near| near.text),
        }
    }

    /// What the line with this number, from 1, is called in the document: `under ‘Results’, paragraph 12`, or `paragraph 12` without a
    /// heading above it.
    pub(crate) fn label(&self, line: usize) -> Option<String> {
        let LineLabel { name, heading } = self.labels.get(line.checked_sub(1)?)?;
        Some(heading.as_ref().map_or_else(|| name.clone(), |heading| format!("under ‘{heading}’, {name}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_place_of_the_page_has_one_in_the_text() {
        let mut made = MadePage::default();
        made.tags("<p>");
        made.characters("a < b: ");
        made.tags("<math><mfrac><mn>");
        made.characters("10");
        made.tags("</mn>");
        made.shown("/");
        made.tags("<mn>");
        made.characters("4");
        made.tags("</mn></mfrac></math></p>");
        made.end_line("paragraph 1".to_owned(), None);
        assert_eq!(made.text, "a < b: 10/4\n");
        let shown = |part: &str| {
            let at = made.page.find(part).expect("a part of the page");
            &made.text[made.span_in_text(Span::new(at, at + part.len())).range()]
        };
        assert_eq!(shown("&lt; b"), "< b");
        assert_eq!(shown("<mfrac><mn>10</mn><mn>4</mn></mfrac>"), "10/4");
        assert_eq!(shown("<mn>4</mn>"), "4");
        assert_eq!(shown("0"), "0");
        assert_eq!(made.label(1).as_deref(), Some("paragraph 1"));
        assert_eq!((made.label(0), made.label(2)), (None, None));
        made.end_line("table 1, row 2, cell 3".to_owned(), Some("Results".into()));
        assert_eq!(made.label(2).as_deref(), Some("under ‘Results’, table 1, row 2, cell 3"));
        assert_eq!(MadePage::default().span_in_text(Span::new(3, 4)), Span::default());
    }
}
