//! What is written beside a view: sizes, frames and datums in two columns, with leaders to what they are about.

use super::dimension::PrintedDimension;
use super::ink::{Ink, Pen, SMALL, TEXT, text_width};
use super::limits::LimitOrigin;
use crate::geometry::Point;

/// A line of a callout.
#[derive(Clone, Debug)]
pub(super) enum Row {
    /// Plain words.
    Words(String),
    /// A size with its limits.
    Size(PrintedDimension),
    /// A frame of ISO 1101 with the sign of position: its zone and its datums.
    Position { zone: String, datums: &'static [&'static str], origin: LimitOrigin },
    /// What the callout is about is a datum of this letter.
    Datum(&'static str),
}

/// Heights of rows, of frames, and between callouts, in millimetres.
const ROW: f64 = 4.6;
const FRAME: f64 = 6.0;
const BETWEEN: f64 = 3.0;
/// Height of the boxes of frames and datums, and width of the box of a sign.
const BOX: f64 = 5.0;
/// Behind the text of a size, before its limits.
const SPACE: f64 = 1.0;
/// Before the mark below.
const MARK: f64 = 0.7;

/// Width of the mark behind limits.
fn mark_width(origin: LimitOrigin) -> f64 {
    if origin.mark().is_empty() { 0.0 } else { MARK + text_width(origin.mark(), TEXT) }
}

/// Writes the mark behind limits, if they have one.
fn draw_mark(ink: &mut Ink, origin: LimitOrigin, right: f64, base: f64) {
    if !origin.mark().is_empty() {
        ink.text(Point::new(right + MARK, base), TEXT, origin.mark());
    }
}

impl Row {
    fn height(&self) -> f64 {
        match self {
            Self::Words(_) => ROW,
            Self::Size(size) => match size.limit_words() {
                Some(Err(_)) => FRAME,
                _ => ROW,
            },
            Self::Position { .. } | Self::Datum(_) => FRAME,
        }
    }

    fn width(&self) -> f64 {
        match self {
            Self::Words(text) => text_width(text, TEXT),
            Self::Size(size) => {
                let mark = mark_width(size.origin);
                let limits = match size.limit_words() {
                    None => 0.0,
                    Some(Ok(one)) => text_width(&one, TEXT),
                    Some(Err(both)) => both.map(|text| text_width(&text, SMALL)).into_iter().fold(0.0, f64::max),
                };
                text_width(&size.text, TEXT) + if limits > 0.0 { SPACE + limits } else { 0.0 } + mark
            }
            Self::Position { zone, datums, origin } => {
                let mark = mark_width(*origin);
                BOX + text_width(zone, TEXT) + 2.0 + BOX * datums.len() as f64 + mark
            }
            Self::Datum(_) => 2.0 * BOX,
        }
    }

    /// Writes the row from its left end, its upper edge at this height.
    fn draw(&self, ink: &mut Ink, left: f64, top: f64) {
        let height = self.height();
        let base = top + height / 2.0 + 0.358 * TEXT;
        match self {
            Self::Words(text) => ink.text(Point::new(left, base), TEXT, text),
            Self::Size(size) => {
                ink.text(Point::new(left, base), TEXT, &size.text);
                let mut right = left + text_width(&size.text, TEXT) + SPACE;
                match size.limit_words() {
                    None => {}
                    Some(Ok(one)) => {
                        ink.text(Point::new(right, base), TEXT, &one);
                        right += text_width(&one, TEXT);
                    }
                    Some(Err([upper, lower])) => {
                        let middle = top + height / 2.0;
                        ink.text(Point::new(right, middle - 0.4), SMALL, &upper);
                        ink.text(Point::new(right, middle + 2.2), SMALL, &lower);
                        right += text_width(&upper, SMALL).max(text_width(&lower, SMALL));
                    }
                }
                draw_mark(ink, size.origin, right, base);
            }
            Self::Position { zone, datums, origin } => {
                let (upper, lower) = (top + (height - BOX) / 2.0, top + (height + BOX) / 2.0);
                let mut cells = vec![BOX, text_width(zone, TEXT) + 2.0];
                cells.extend(datums.iter().map(|_| BOX));
                let mut x = left;
                let texts: Vec<&str> = ["", zone].into_iter().chain(datums.iter().copied()).collect();
                for (width, text) in cells.into_iter().zip(texts) {
                    ink.rectangle(Pen::Thin, Point::new(x, upper), Point::new(x + width, lower));
                    if text.is_empty() {
                        let middle = Point::new(x + width / 2.0, (upper + lower) / 2.0);
                        ink.circle(Pen::Thin, middle, 1.1);
                        for arm in [Point::new(1.9, 0.0), Point::new(0.0, 1.9)] {
                            ink.line(Pen::Thin, &[middle - arm, middle + arm]);
                        }
                    } else {
                        let inset = (width - text_width(text, TEXT)) / 2.0;
                        ink.text(Point::new(x + inset, base), TEXT, text);
                    }
                    x += width;
                }
                draw_mark(ink, *origin, x, base);
            }
            Self::Datum(letter) => {
                let (upper, lower) = (top + (height - BOX) / 2.0, top + (height + BOX) / 2.0);
                let middle = (upper + lower) / 2.0;
                let corner = |x: f64, y: f64| Point::new(left + x, middle + y);
                ink.line(Pen::Solid, &[corner(0.5, -1.5), corner(0.5, 1.5), corner(3.0, 0.0)]);
                ink.line(Pen::Thin, &[corner(3.0, 0.0), corner(BOX, 0.0)]);
                ink.rectangle(Pen::Thin, Point::new(left + BOX, upper), Point::new(left + 2.0 * BOX, lower));
                let inset = (BOX - text_width(letter, TEXT)) / 2.0;
                ink.text(Point::new(left + BOX + inset, base), TEXT, letter);
            }
        }
    }
}

/// The side of a view on which something is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// Rows beside a view, and the place on paper to which they belong.
#[derive(Clone, Debug)]
pub(super) struct Callout {
    pub rows: Vec<Row>,
    pub side: Side,
    pub target: Point,
    /// Whether the leader ends with an arrow at an edge; else it ends at a dimension line.
    pub has_arrow: bool,
}

impl Callout {
    fn height(&self) -> f64 {
        self.rows.iter().map(Row::height).sum()
    }

    /// Width of its widest row, in millimetres.
    pub(super) fn width(&self) -> f64 {
        self.rows.iter().map(Row::width).fold(0.0, f64::max)
    }

    fn draw(&self, ink: &mut Ink, edge: f64, top: f64) {
        let mut y = top;
        for row in &self.rows {
            let left = if self.side == Side::Right { edge } else { edge - row.width() };
            row.draw(ink, left, y);
            y += row.height();
        }
        let out = if self.side == Side::Right { -1.0 } else { 1.0 };
        let middle = top + self.rows.first().map_or(0.0, Row::height) / 2.0;
        let (start, bend) = (Point::new(edge + out, middle), Point::new(edge + 4.0 * out, middle));
        ink.line(Pen::Thin, &[start, bend, self.target]);
        if self.has_arrow {
            ink.arrow(self.target, bend);
        }
    }
}

/// Writes callouts into two columns whose inner edges are given, between two heights, each as near to its target as the others
/// let it. Whether there was room.
pub(super) fn draw_columns(ink: &mut Ink, callouts: &[Callout], edges: [f64; 2], [from, to]: [f64; 2]) -> bool {
    let mut has_room = true;
    for (side, edge) in [Side::Left, Side::Right].into_iter().zip(edges) {
        let mut column: Vec<&Callout> = callouts.iter().filter(|callout| callout.side == side).collect();
        column.sort_by(|a, b| a.target.y.total_cmp(&b.target.y));
        let mut tops: Vec<f64> = Vec::new();
        let mut free = from;
        for callout in &column {
            let top = (callout.target.y - callout.height() / 2.0).max(free);
            free = top + callout.height() + BETWEEN;
            tops.push(top);
        }
        let mut floor = to;
        for (top, callout) in tops.iter_mut().zip(&column).rev() {
            *top = top.min(floor - callout.height());
            floor = *top - BETWEEN;
        }
        has_room &= floor >= from - BETWEEN;
        column.iter().zip(tops).for_each(|(callout, top)| callout.draw(ink, edge, top));
    }
    has_room
}
