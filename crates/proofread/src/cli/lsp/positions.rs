//! Places in a text as an editor counts them: lines from 0, and columns in bytes or in the units of UTF-16.

use crate::token::Span;
use serde_json::{Value, json};

/// What a column counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum PositionEncoding {
    /// Bytes.
    Utf8,
    /// Units of UTF-16, of which a character outside the basic plane has two. Every editor knows them.
    #[default]
    Utf16,
}

impl PositionEncoding {
    /// Its name in the protocol.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "utf-8",
            Self::Utf16 => "utf-16",
        }
    }

    /// The first one that we know among those that an editor offers, in the order in which it likes them.
    pub(super) fn first_of(offered: &Value) -> Self {
        let known = |name: &Value| [Self::Utf8, Self::Utf16].into_iter().find(|of| name == of.name());
        offered.as_array().into_iter().flatten().find_map(known).unwrap_or_default()
    }

    fn units_of(self, c: char) -> usize {
        match self {
            Self::Utf8 => c.len_utf8(),
            Self::Utf16 => c.len_utf16(),
        }
    }
}

/// A line and a column, both from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Position {
    pub line: usize,
    pub column: usize,
}

impl Position {
    /// A position as the protocol writes it; none if it is none.
    pub(super) fn from_json(value: &Value) -> Option<Self> {
        let part = |name: &str| value[name].as_u64().and_then(|of| usize::try_from(of).ok());
        Some(Self { line: part("line")?, column: part("character")? })
    }

    fn to_json(self) -> Value {
        json!({ "line": self.line, "character": self.column })
    }
}

/// Where a range of the protocol begins and ends; none if it is none.
pub(super) fn range_from_json(value: &Value) -> Option<[Position; 2]> {
    Some([Position::from_json(&value["start"])?, Position::from_json(&value["end"])?])
}

/// The byte of a position. Behind the end of a line it is that end, and behind the last line the end of the text; within a
/// character, it is the character's first byte.
pub(super) fn byte_at(text: &str, position: Position, encoding: PositionEncoding) -> usize {
    let mut start = 0;
    for _ in 0..position.line {
        match line_end(&text[start..]) {
            Some((_, next)) => start += next,
            None => return text.len(),
        }
    }
    let line = &text[start..];
    let line = &line[..line_end(line).map_or(line.len(), |(end, _)| end)];
    let mut column = 0;
    for (at, c) in line.char_indices() {
        column += encoding.units_of(c);
        if column > position.column {
            return start + at;
        }
    }
    start + line.len()
}

/// Where the first line of a text ends, and where the next one begins; none if there is no other. A line ends with `\n`,
/// `\r\n` or `\r`.
fn line_end(text: &str) -> Option<(usize, usize)> {
    let end = text.bytes().position(|byte| matches!(byte, b'\n' | b'\r'))?;
    let is_both = text[end..].starts_with("\r\n");
    Some((end, end + 1 + usize::from(is_both)))
}

/// Bytes of a text between two places at which its units are counted.
const STEP: usize = 256;

/// The lines of a text, to find the positions of many bytes.
pub(super) struct PositionIndex<'t> {
    text: &'t str,
    encoding: PositionEncoding,
    starts: Vec<usize>,
    /// How many units begin before each [`STEP`]th byte: a line may be as long as the text.
    counts: Vec<usize>,
}

/// How many units of UTF-16 begin in these bytes of UTF-8.
fn units_in(bytes: &[u8]) -> usize {
    let units = |byte: &u8| match byte {
        0x80..=0xbf => 0,
        0xf0.. => 2,
        _ => 1,
    };
    bytes.iter().map(units).sum()
}

impl<'t> PositionIndex<'t> {
    pub(super) fn new(text: &'t str, encoding: PositionEncoding) -> Self {
        let mut starts = vec![0];
        let mut start = 0;
        while let Some((_, next)) = line_end(&text[start..]) {
            start += next;
            starts.push(start);
        }
        let mut counted = 0;
        let count = |bytes: &[u8]| {
            counted += units_in(bytes);
            counted
        };
        let counts = std::iter::once(0).chain(text.as_bytes().chunks(STEP).map(count)).collect();
        Self { text, encoding, starts, counts }
    }

    fn units_before(&self, at: usize) -> usize {
        match self.encoding {
            PositionEncoding::Utf8 => at,
            PositionEncoding::Utf16 => {
                let step = at / STEP;
                let rest = self.text.as_bytes().get(step * STEP..at).unwrap_or_default();
                self.counts.get(step).copied().unwrap_or_default() + units_in(rest)
            }
        }
    }

    /// The position of a byte.
    pub(super) fn position(&self, at: usize) -> Position {
        let at = (0..=at.min(self.text.len())).rfind(|at| self.text.is_char_boundary(*at)).unwrap_or_default();
        let line = self.starts.partition_point(|start| *start <= at).saturating_sub(1);
        let start = self.starts.get(line).copied().unwrap_or_default();
        Position { line, column: self.units_before(at) - self.units_before(start) }
    }

    /// A stretch as a range of the protocol.
    pub(super) fn range(&self, span: Span) -> Value {
        let [start, end] = [span.start, span.end].map(|at| self.position(at as usize).to_json());
        json!({ "start": start, "end": end })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_and_positions_are_each_other_s_inverse() {
        let text = format!("a𝟙β\r\n\n\r{}\nend 𝟘", "x𝟙".repeat(500));
        for encoding in [PositionEncoding::Utf8, PositionEncoding::Utf16] {
            let index = PositionIndex::new(&text, encoding);
            for (at, c) in text.char_indices().chain([(text.len(), ' ')]) {
                let place = index.position(at);
                // Between the two characters of a line's end is no place.
                if !(c == '\n' && text[..at].ends_with('\r')) {
                    assert_eq!(byte_at(&text, place, encoding), at, "{encoding:?} {place:?}");
                }
            }
        }
    }

    #[test]
    fn a_character_outside_the_basic_plane_has_two_units() {
        let text = "𝟙β = 2";
        for (encoding, column) in [(PositionEncoding::Utf16, 3), (PositionEncoding::Utf8, 6)] {
            assert_eq!(PositionIndex::new(text, encoding).position(6), Position { line: 0, column });
        }
        // Within it is its start, and behind the line its end.
        let within = Position { line: 0, column: 1 };
        assert_eq!(byte_at(text, within, PositionEncoding::Utf16), 0);
        assert_eq!(byte_at(text, Position { line: 0, column: 99 }, PositionEncoding::Utf16), text.len());
        assert_eq!(byte_at("a\nb", Position { line: 0, column: 9 }, PositionEncoding::Utf16), 1);
        assert_eq!(byte_at(text, Position { line: 7, column: 0 }, PositionEncoding::Utf16), text.len());
    }

    #[test]
    fn the_editor_s_first_known_encoding_counts() {
        let first = |offered: &[&str]| PositionEncoding::first_of(&json!(offered));
        assert_eq!(first(&["utf-32", "utf-8", "utf-16"]), PositionEncoding::Utf8);
        assert_eq!(first(&["utf-16", "utf-8"]), PositionEncoding::Utf16);
        assert_eq!(first(&["utf-32"]), PositionEncoding::Utf16);
        assert_eq!(PositionEncoding::first_of(&Value::Null), PositionEncoding::Utf16);
    }
}
