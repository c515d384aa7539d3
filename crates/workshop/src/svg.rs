//! The parts in rows as an SVG file to cut: true to scale, a colour for each operation.

use crate::drawing::{in_rows, marks, reach};
use crate::geometry::{Point, point_along};
use crate::offset::offset;
use crate::parts::{MountingError, Part};
use geneva_kinematics::wheel::{Edge, Loop};
use std::f64::consts::PI;
use std::fmt::Write;

/// Colours of the operations, the pure ones that programs for lasers tell apart, and the width of a line in millimetres.
const CUT: &str = "#ff0000";
const ENGRAVE: &str = "#0000ff";
const LINE: f64 = 0.1;
/// Around the drawing, in millimetres.
const MARGIN: f64 = 2.0;

/// The parts to be cut from sheets, in rows that have about the shape of a sheet, in millimetres. Each part is a group whose id is its name; what is engraved
/// comes first and the outer line last, so that no part is loose before its holes are cut.
///
/// Red lines are cut, blue ones are engraved: centre marks and the outlines of pockets. The lines to cut are moved into the waste
/// by half the kerf, the width in millimetres that the beam takes away; with zero they are the outlines.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Mounting, parts, svg_parts};
///
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let list = parts(&sizes, 5.0, &Mounting::default()).expect("bare parts");
/// let text = svg_parts(&list.parts, 0.15).expect("a drawing"); // a kerf of 0.15 mm
/// assert!(text.contains("<g id=\"wheel\""));
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// [`MountingError::Kerf`] for a kerf that is negative, not finite, or too wide for a hollow of a part.
pub fn svg_parts(parts: &[Part], kerf: f64) -> Result<String, MountingError> {
    if !(kerf >= 0.0 && kerf.is_finite()) {
        return Err(MountingError::Kerf { kerf, part: None });
    }
    let placed = in_rows(parts);
    let [[left, right], [bottom, top]] = [0, 1].map(|axis| {
        let ends = placed.iter().map(|(part, at)| reach(part, axis).map(|x| x + at[axis]));
        ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [from, to]| [a.min(from), b.max(to)])
    });
    let (left, top) = (left - MARGIN, top + MARGIN);
    let (width, height) = (right - left + MARGIN, top - bottom + MARGIN);
    let moved = if kerf == 0.0 {
        String::new()
    } else {
        format!(", moved into the waste by half of the cut's width of {} mm", number(kerf))
    };
    let size = reach_of(&placed);
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"{left} {top} {width} \
         {height}\">\n<title>Parts to cut, in millimetres: red is cut{moved}, blue is engraved. All red lines together \
         are {across:.1} mm wide and {up:.1} mm high</title>",
        across = size.x + kerf,
        up = size.y + kerf,
        width = number(width),
        height = number(height),
        left = number(left),
        top = number(-top),
    );
    for (part, at) in placed {
        let words = part.words();
        let _ = writeln!(
            text,
            "<g id=\"{}\" fill=\"none\" stroke-width=\"{LINE}\">\n<title>{words}, {} of it</title>",
            words.replace(' ', "-"),
            part.quantity(),
        );
        let pockets = part.holes.iter().filter_map(|hole| Some(&hole.widening.as_ref()?.outline));
        for mark in marks(part) {
            write(&mut text, &Loop { edges: vec![mark] }, at, ENGRAVE);
        }
        pockets.for_each(|pocket| write(&mut text, pocket, at, ENGRAVE));
        let holes = part.holes.iter().map(|hole| &hole.outline);
        for line in holes.chain([&part.outer]) {
            let path = offset(line, kerf / 2.0).ok_or(MountingError::Kerf { kerf, part: Some(words) })?;
            write(&mut text, &path, at, CUT);
        }
        text += "</g>\n";
    }
    Ok(text + "</svg>\n")
}

/// How wide and high the outer lines of parts are together, in millimetres.
///
/// The title says it, by which the scale is checked: a bar to measure would be one more line that a machine cuts.
fn reach_of(placed: &[(&Part, Point)]) -> Point {
    let points = placed.iter().flat_map(|(part, at)| {
        let along =
            |edge: &Edge| (0..=STEPS).map(|k| f64::from(k) / f64::from(STEPS)).map(|k| point_along(edge, k)).collect();
        part.outer.edges.iter().flat_map(move |edge| -> Vec<Point> { along(edge) }).map(move |p| p + at)
    });
    let corners = points.fold(None, |corners: Option<[Point; 2]>, p| {
        Some(corners.map_or([p; 2], |[least, greatest]| [least.inf(&p), greatest.sup(&p)]))
    });
    corners.map_or(Point::zeros(), |[least, greatest]| greatest - least)
}

/// Steps along an edge: of a circle, a tenth of a thousandth of its radius is lost at most.
const STEPS: u32 = 256;

/// A number with as many digits as a machine has use for: millionths of a millimetre.
fn number(x: f64) -> String {
    let text = format!("{x:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn write(text: &mut String, of: &Loop, at: Point, colour: &str) {
    let _ = writeln!(text, "<path d=\"{}\" stroke=\"{colour}\"/>", path_data(of, at));
}

/// The data of a path along a line that is moved, in millimetres; SVG's second axis points down.
pub(crate) fn path_data(of: &Loop, at: Point) -> String {
    let point = |p: Point| format!("{} {}", number(p.x + at.x), number(-(p.y + at.y)));
    let Some(first) = of.edges.first() else { return String::new() };
    let mut path = format!("M{}", point(first.start_point()));
    for edge in &of.edges {
        match *edge {
            Edge::Line { to, .. } => {
                let _ = write!(path, "L{}", point(to));
            }
            Edge::Arc { centre, radius, start, sweep } => {
                // A whole circle has no ends, so it is written as two halves.
                let count = if sweep.abs() >= 2.0 * PI { 2 } else { 1 };
                let piece = sweep / f64::from(count);
                for k in 0..count {
                    let edge = Edge::Arc { centre, radius, start: start + piece * f64::from(k), sweep: piece };
                    let (is_long, is_clockwise) = (u8::from(piece.abs() > PI), u8::from(sweep < 0.0));
                    let r = number(radius);
                    let _ = write!(path, "A{r} {r} 0 {is_long} {is_clockwise} {}", point(edge.end_point()));
                }
            }
        }
    }
    let is_closed = of.edges.last().is_some_and(|last| (last.end_point() - first.start_point()).norm() < 1e-6);
    if is_closed {
        path.push('Z');
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::point_along;
    use crate::parts::{BasePlate, Fastener, Mounting, Pattern, ScrewHole, Thread, parts};
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    use roxmltree::{Document, Node};

    fn list() -> Vec<Part> {
        let sizes = Sizes::new(Wheel::with_pins(6, 2).unwrap(), Scale::CrankRadius(50.0), &Choices::default()).unwrap();
        let fastener = Fastener::Screw(Thread::M4, ScrewHole::NutTrap);
        let mounting = Mounting {
            wheel_hub: Some(Pattern { count: 4, circle: 24.0, fastener }),
            base: Some(BasePlate { screws: Some(Thread::M4), ..BasePlate::default() }),
            ..Mounting::default()
        };
        parts(&sizes, 5.0, &mounting).unwrap().parts
    }

    /// The pieces of a path as a reader of SVG sees them, with the second axis turned up again.
    fn edges(path: &str) -> Vec<Edge> {
        let spaced: String =
            path.chars().map(|c| if c.is_alphabetic() { format!(" {c} ") } else { c.to_string() }).collect();
        let words: Vec<&str> = spaced.split_whitespace().collect();
        let number = |k: usize| words[k].parse::<f64>().unwrap();
        let (mut at, mut k, mut found) = (Point::zeros(), 0, Vec::new());
        while k < words.len() {
            let (to, length) = match words[k] {
                "M" => (Point::new(number(k + 1), -number(k + 2)), 3),
                "L" => {
                    let to = Point::new(number(k + 1), -number(k + 2));
                    found.push(Edge::Line { from: at, to });
                    (to, 3)
                }
                "A" => {
                    let (radius, to) = (number(k + 1), Point::new(number(k + 6), -number(k + 7)));
                    let (is_long, is_clockwise) = (number(k + 4) == 1.0, number(k + 5) == 1.0);
                    // The centre is to the left of the chord for a short arc counter-clockwise.
                    let chord = to - at;
                    let far = (radius * radius - chord.norm_squared() / 4.0).max(0.0).sqrt();
                    let side = if is_long == is_clockwise { 1.0 } else { -1.0 };
                    let centre = at + chord / 2.0 + Point::new(-chord.y, chord.x).normalize() * far * side;
                    let angle = |p: Point| (p.y - centre.y).atan2(p.x - centre.x);
                    let turn = (angle(to) - angle(at)).rem_euclid(2.0 * PI);
                    let sweep = if is_clockwise { turn - 2.0 * PI } else { turn };
                    found.push(Edge::Arc { centre, radius, start: angle(at), sweep });
                    (to, 8)
                }
                "Z" => (at, 1),
                other => panic!("{other}"),
            };
            (at, k) = (to, k + length);
        }
        found
    }

    #[test]
    fn a_reader_of_the_format_finds_the_outlines_true_to_scale() {
        let list = list();
        let text = svg_parts(&list, 0.0).unwrap();
        let document = Document::parse(&text).unwrap();
        let root = document.root_element();
        let sizes = ["width", "height"].map(|name| root.attribute(name).unwrap().strip_suffix("mm").unwrap());
        let view: Vec<&str> = root.attribute("viewBox").unwrap().split(' ').collect();
        assert_eq!(sizes, [view[2], view[3]], "one unit is one millimetre");
        let groups: Vec<Node> = root.children().filter(|node| node.has_tag_name("g")).collect();
        // As a machine's program measures them: all that is cut.
        let cut = root.descendants().filter(|node| node.attribute("stroke") == Some(CUT));
        let points: Vec<Point> = cut
            .flat_map(|node| edges(node.attribute("d").unwrap()))
            .flat_map(|edge| (0..=512).map(move |k| point_along(&edge, f64::from(k) / 512.0)))
            .collect();
        let across = |of: fn(&Point) -> f64| {
            let all = || points.iter().map(of);
            all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
        };
        let said = format!("{:.1} mm wide and {:.1} mm high", across(|p| p.x), across(|p| p.y));
        assert!(text.contains(&said), "{said}");
        let names: Vec<_> = groups.iter().filter_map(|group| group.attribute("id")).collect();
        assert_eq!(names, ["wheel", "locking-disc", "driver-plate", "base-plate"]);
        let [width, height] = [0, 1].map(|k| sizes[k].parse::<f64>().unwrap());
        assert!((0.7..2.9).contains(&(width / height)), "{width} by {height} mm is no sheet");
        // No two parts overlap.
        for (k, (part, at)) in in_rows(&list).into_iter().enumerate() {
            for (other, its) in in_rows(&list).into_iter().skip(k + 1) {
                let is_apart = |axis: usize| {
                    let ([a, b], [c, d]) = (reach(part, axis), reach(other, axis));
                    b + at[axis] < c + its[axis] || d + its[axis] < a + at[axis]
                };
                assert!(is_apart(0) || is_apart(1), "{} {}", part.words(), other.words());
            }
        }
        let placed = in_rows(&list);
        for (group, (part, at)) in groups.into_iter().zip(placed) {
            let paths = |colour: &str| -> Vec<Vec<Edge>> {
                let of_colour = group.children().filter(|node| node.attribute("stroke") == Some(colour));
                of_colour.map(|path| edges(path.attribute("d").unwrap())).collect()
            };
            let (cut, engraved) = (paths(CUT), paths(ENGRAVE));
            let pockets = part.holes.iter().filter(|hole| hole.widening.is_some()).count();
            assert_eq!(engraved.len(), 2 * part.marks.len() + pockets);
            let face = part.face();
            let drawn: Vec<&Loop> = face.holes.iter().chain([&face.outer]).collect();
            assert_eq!(cut.len(), drawn.len());
            for (read, ours) in cut.iter().zip(drawn) {
                for p in read.iter().flat_map(|edge| [0.0, 0.3, 0.7].map(|part| point_along(edge, part))) {
                    let far = ours.edges.iter().map(|edge| crate::geometry::distance(edge, p - at));
                    assert!(far.fold(f64::INFINITY, f64::min) < 2e-6);
                    let [left, top, width, height] = [0, 1, 2, 3].map(|k| view[k].parse::<f64>().unwrap());
                    assert!(p.x > left && p.x < left + width && -p.y > top && -p.y < top + height);
                }
                let whole = crate::geometry::area(&Loop { edges: read.clone() });
                approx::assert_relative_eq!(whole, crate::geometry::area(ours), max_relative = 1e-6);
            }
        }
    }

    #[test]
    fn a_kerf_makes_parts_larger_and_holes_smaller_and_is_refused_if_it_is_too_wide() {
        let list = list();
        let areas = |kerf: f64| -> Vec<f64> {
            let text = svg_parts(&list, kerf).unwrap();
            let document = Document::parse(&text).unwrap();
            let red = document.descendants().filter(|node| node.attribute("stroke") == Some(CUT));
            red.map(|node| crate::geometry::area(&Loop { edges: edges(node.attribute("d").unwrap()) })).collect()
        };
        for (bare, cut) in areas(0.0).into_iter().zip(areas(0.2)) {
            // Outer lines run counter-clockwise, holes clockwise: both grow with their sign.
            assert!(cut > bare, "{cut} {bare}");
        }
        for wrong in [-0.1, f64::NAN, f64::INFINITY, 9.0] {
            assert!(matches!(svg_parts(&list, wrong), Err(MountingError::Kerf { .. })));
        }
    }
}
