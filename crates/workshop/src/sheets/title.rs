//! Frame, title block, scale bar and notes of a sheet.

use super::ink::{Ink, Pen, SMALL, TEXT, text_width, wrapped};
use super::length::mm;
use super::paper::{DrawingScale, Paper};
use super::text::{SheetMaterial, SheetText};
use crate::geometry::Point;
use crate::parts::Part;

/// Room outside of the frame: on the left for punched holes, and on the other sides, in millimetres. ISO 5457.
const MARGINS: [f64; 2] = [20.0, 10.0];
/// Width of the title block by ISO 7200, and heights of its rows and of the strip with the scale bar, in millimetres.
const BLOCK: f64 = 180.0;
const ROW: f64 = 10.5;
const BAR: f64 = 9.0;
/// Height of a line of notes, in millimetres.
const NOTE: f64 = 3.6;
/// Font of headings of fields, in millimetres.
const HEADING: f64 = 1.9;
/// Length of the scale bar, in millimetres.
const RULER: f64 = 50.0;

/// Least and greatest corner of the frame, and height at which the strip below the drawing begins.
pub(super) fn frame(paper: Paper) -> ([Point; 2], f64) {
    let [width, height] = paper.size();
    let corners = [Point::new(MARGINS[0], MARGINS[1]), Point::new(width - MARGINS[1], height - MARGINS[1])];
    (corners, corners[1].y - 3.0 * ROW - BAR)
}

/// What the title block says about one sheet.
pub(super) struct Title<'a> {
    pub text: &'a SheetText<'a>,
    /// The part, or none for all in place.
    pub part: Option<&'a Part>,
    pub name: &'a str,
    /// Its material, or none where a list says it.
    pub material: Option<SheetMaterial<'a>>,
    /// Class of the general tolerances.
    pub general: &'a str,
    pub scale: DrawingScale,
    pub paper: Paper,
    /// Which sheet it is, and of how many.
    pub sheet: [usize; 2],
}

impl Title<'_> {
    /// Draws the frame, the title block, the scale bar and the notes. Whether the notes had room.
    pub(super) fn draw(&self, ink: &mut Ink, notes: &[String]) -> bool {
        let ([least, greatest], strip) = frame(self.paper);
        ink.rectangle(Pen::Thick, least, greatest);
        let left = greatest.x - BLOCK;
        let top = greatest.y - 3.0 * ROW;
        ink.rectangle(Pen::Thick, Point::new(left, top), greatest);
        let pieces = self.part.map_or_else(|| "1".to_owned(), |part| part.quantity().to_string());
        let thickness = self.part.map_or_else(String::new, |part| format!("{} mm", mm(part.thickness)));
        let is_length = self.part.is_some_and(|part| !part.is_cut());
        let size = [if is_length { "Length" } else { "Thickness" }, thickness.as_str()];
        let material = self.material.map_or("as listed", |material| material.name);
        // What is no metal has no hardness on a drawing.
        let hardness: &[(f64, [&str; 2])] = match self.material.and_then(|material| material.hardness) {
            Some(hardness) => &[(50.0, ["Material", material]), (35.0, ["Hardness", hardness])],
            None => &[(85.0, ["Material", material])],
        };
        let mut second = hardness.to_vec();
        let scale = self.scale.to_string();
        let sheet = format!("{} of {}", self.sheet[0], self.sheet[1]);
        second.extend([
            (30.0, size),
            (20.0, ["Pieces", &pieces]),
            (25.0, ["Scale", &scale]),
            (20.0, ["Sheet", &sheet]),
        ]);
        let rows: [&[(f64, [&str; 2])]; 3] = [
            &[(115.0, ["Project", self.text.project]), (65.0, ["Part", self.name])],
            &second,
            &[
                (45.0, ["Drawn, date", ""]),
                (45.0, ["Checked, date", ""]),
                (30.0, ["General tolerances", self.general]),
                (20.0, ["Units", "mm"]),
                (15.0, ["Paper", self.paper.name()]),
                (25.0, ["Projection", ""]),
            ],
        ];
        for (k, row) in rows.iter().enumerate() {
            let (mut x, y) = (left, top + ROW * k as f64);
            for (width, [heading, value]) in row.iter() {
                ink.rectangle(Pen::Thin, Point::new(x, y), Point::new(x + width, y + ROW));
                ink.text(Point::new(x + 1.0, y + 2.6), HEADING, heading);
                if !value.is_empty() {
                    let font = TEXT.min(TEXT * (width - 3.0) / text_width(value, TEXT));
                    ink.text(Point::new(x + 1.5, y + 8.0), font, value);
                }
                x += width;
            }
        }
        first_angle(ink, Point::new(greatest.x - 12.0, greatest.y - 4.2));
        ruler(ink, Point::new(left, top - 3.0));
        let lines = notes
            .iter()
            .enumerate()
            .flat_map(|(k, note)| wrapped(&format!("{}. {note}", k + 1), SMALL, left - least.x - 4.0));
        let mut y = strip + NOTE;
        for line in lines {
            ink.text(Point::new(least.x + 2.0, y), SMALL, &line);
            y += NOTE;
        }
        y - NOTE <= greatest.y - 1.0
    }
}

/// The sign of first-angle projection: a cone from the side, and from its thin end to the right of it. ISO 5456-2.
fn first_angle(ink: &mut Ink, middle: Point) {
    let (wide, thin) = (2.6, 1.3);
    let [a, b] = [middle - Point::new(9.0, 0.0), middle - Point::new(3.0, 0.0)];
    let at = |p: Point, y: f64| Point::new(p.x, p.y + y);
    ink.line(Pen::Thin, &[at(a, -thin), at(b, -wide), at(b, wide), at(a, thin), at(a, -thin)]);
    let eye = middle + Point::new(4.0, 0.0);
    ink.circle(Pen::Thin, eye, wide);
    ink.circle(Pen::Thin, eye, thin);
    ink.line(Pen::Centre, &[a - Point::new(1.0, 0.0), b + Point::new(1.0, 0.0)]);
    for arm in [Point::new(3.4, 0.0), Point::new(0.0, 3.4)] {
        ink.line(Pen::Centre, &[eye - arm, eye + arm]);
    }
}

/// A bar of 50 mm on paper with a mark at every ten.
fn ruler(ink: &mut Ink, left: Point) {
    let at = |x: f64, y: f64| left + Point::new(x, y);
    ink.line(Pen::Thin, &[at(0.0, 0.0), at(RULER, 0.0)]);
    for k in 0..=5 {
        let height = if k % 5 == 0 { 3.0 } else { 1.8 };
        let x = RULER * f64::from(k) / 5.0;
        ink.line(Pen::Thin, &[at(x, 0.0), at(x, -height)]);
    }
    let words = "50 mm on paper. Print at 100 %, and measure this bar before you measure anything else.";
    ink.text(at(RULER + 3.0, 0.0), SMALL, words);
}
