//! Wheel and driver in their true size, with dimensions in millimetres.

use super::pose::count_noun;
use crate::figure::Figure;
use crate::number::{format_trimmed, with_minus_sign};
use crate::parts::{self, axis};
use crate::svg::{Canvas, DASHED, DrawingKind, Label, PIXELS_PER_MILLIMETRE, Path, Pixels, Sense, Shape, View};
use crate::theme::{Colour, DRIVER, FILL, FOLLOWER, GRID, INK, PAPER};
use crate::{Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Edge, Face, Loop, Mouth, Outline, Sizes};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Width of the two bodies on a page, in pixels.
const ON_A_PAGE: f64 = 560.0;
/// Free space at the edges, and from the bodies to the first line of dimensions, in pixels.
const MARGIN: f64 = 30.0;
const TO_FIRST: f64 = 32.0;
/// From one line of dimensions, or of words, to the next.
const ROW: f64 = 36.0;
const LINE: f64 = 30.0;
/// From a dimension line to its name, and from where to where nothing else is above the line, in pixels: a name's letters with
/// their descenders.
const OFF_LINE: f64 = 10.0;
const GROUND: [f64; 2] = [3.0, 28.0];
/// Coordinates are written to so many decimals of a pixel.
const DECIMALS: usize = 3;
/// Digits after the point of a dimension in millimetres.
const DIGITS: usize = 3;
/// Width of a column of the list, in pixels.
const COLUMN: f64 = 285.0;
/// Free space beside a dimension's name, and how much two that share an end may overlap, in pixels.
const AIR: f64 = 4.0;
const TOUCHING: f64 = 1e-6;

/// Wheel and driver in their true size, assembled, with a pin deepest in its slot.
///
/// Dimensions along the line of centres stand above and below; what has no room there is listed. Series: the same
/// numbers, in millimetres.
pub fn dimensions(sizes: &Sizes) -> Figure {
    draw_at_scale(sizes, PIXELS_PER_MILLIMETRE, DrawingKind::TrueSize, &sizes.outline())
}

/// Wheel and driver as large as a page has room for.
///
/// Only the dimensions along the line of centres are in the drawing. Series: as of [`dimensions`].
pub fn dimensions_on_a_page(sizes: &Sizes) -> Figure {
    with_outline_on_a_page(sizes, &sizes.outline())
}

/// The drawing of a wheel that is made wrong: dimensions of `sizes`, and the outline of `made` with each slot `turned` by an
/// angle in radians out of its place.
pub fn dimensions_of_a_wrong_wheel(sizes: &Sizes, made: &Sizes, turned: f64) -> Figure {
    let mut outline = made.outline();
    // Where the rim begins beside a slot's mouth.
    let rim = made.mouth_face().map(|face| face.end_point());
    let corner = rim.map_or_else(
        || libm::asin((made.slot_width / 2.0 / made.tip_radius).min(1.0)),
        |rim| libm::atan2(rim.y, rim.x),
    ) + TOUCHING;
    let (pitch, reach) = (2.0 * made.wheel.half_pitch_angle(), made.tip_radius * libm::sin(corner));
    let in_slot = |p: &Vector2<f64>| {
        let angle = libm::atan2(p.y, p.x);
        // By the distance beside the slot's middle: the ends of its walls near the axis are as far as those at the rim.
        (p.norm() * libm::sin(angle - pitch * (angle / pitch).round())).abs() <= reach
    };
    let place = |p: Vector2<f64>| {
        let turn = Turn::from_radians(turned);
        if in_slot(&p) { Vector2::new(turn.cos * p.x - turn.sin * p.y, turn.sin * p.x + turn.cos * p.y) } else { p }
    };
    for edge in &mut outline.wheel.outer.edges {
        let (from, to) = (edge.start_point(), edge.end_point());
        *edge = match *edge {
            Edge::Line { .. } => Edge::Line { from: place(from), to: place(to) },
            Edge::Arc { .. } if in_slot(&from) && in_slot(&to) => edge.transform(turned, Vector2::zeros()),
            Edge::Arc { centre, radius, start, sweep } if in_slot(&from) => {
                Edge::Arc { centre, radius, start: start + turned, sweep: sweep - turned }
            }
            Edge::Arc { centre, radius, start, sweep } if in_slot(&to) => {
                Edge::Arc { centre, radius, start, sweep: sweep + turned }
            }
            arc => arc,
        };
    }
    with_outline_on_a_page(sizes, &outline)
}

fn with_outline_on_a_page(sizes: &Sizes, outline: &Outline) -> Figure {
    let length = sizes.tip_radius + sizes.centre_distance + sizes.plate_radius;
    draw_at_scale(sizes, ON_A_PAGE / length, DrawingKind::Mechanism, outline)
}

fn draw_at_scale(sizes: &Sizes, scale: f64, kind: DrawingKind, outline: &Outline) -> Figure {
    let is_true = matches!(kind, DrawingKind::TrueSize);
    let (c, reach) = (sizes.centre_distance, sizes.plate_radius);
    let (above, below) = along(sizes);
    let (above, below) = (Rows::of(above, scale), Rows::of(below, scale));
    let left = above.left.min(below.left).min(-sizes.tip_radius * scale);
    let right = above.right.max(below.right).max((c + reach) * scale).max(left + COLUMN);
    let half = sizes.tip_radius.max(reach) * scale;
    let listed = list(sizes);
    let in_drawing = if is_true { listed.as_slice() } else { &[] };
    let lines = in_drawing.len().div_ceil(((right - left) / COLUMN).max(1.0) as usize);
    let width = right - left + 2.0 * MARGIN;
    let pivot = Vector2::new(MARGIN - left, MARGIN + above.height() + half);
    let words = pivot.y + half + below.height() + MARGIN;

    let view = View { origin: pivot, scale };
    let list = if is_true { LINE * lines as f64 + MARGIN } else { 0.0 };
    let mut canvas = Canvas::new(width, words + list);
    bodies(&mut canvas, sizes, outline, &view);
    above.draw(&mut canvas, &view, -half, -1.0);
    below.draw(&mut canvas, &view, half, 1.0);
    let unit = Label::words(if is_true { "scale 1 : 1, lengths in mm" } else { "lengths in mm" });
    canvas.label(&Pixels::new(MARGIN, words - 0.5 * LINE), &Pixels::new(1.0, 0.0), 0.0, &unit);
    for (k, (name, value)) in in_drawing.iter().enumerate() {
        let (column, line) = (k / lines, k % lines);
        let at = Pixels::new(MARGIN + COLUMN * column as f64, words + LINE * (line as f64 + 0.5));
        canvas.label(
            &at,
            &Pixels::new(1.0, 0.0),
            0.0,
            &Label::words(&format!("{name} {}", format_trimmed(*value, DIGITS))),
        );
    }

    let (stations, pins) = (sizes.wheel.stations(), count_noun(sizes.wheel.pins(), "pin"));
    let words = Words::new(
        "wheel-dimensions",
        format!("Geneva wheel with {stations} stations and {pins}{}", if is_true { ", in true size" } else { "" }),
        with_minus_sign(&format!(
            "At the left the wheel, at the right the driver with a pin deepest in its slot{}. Centre distance {} mm, crank radius {} mm, wheel radius {} mm; slots {} mm wide, pins {} mm in diameter.",
            if is_true { ", to be printed in true size" } else { "" },
            format_trimmed(c, DIGITS),
            format_trimmed(sizes.crank_radius, DIGITS),
            format_trimmed(sizes.wheel_radius, DIGITS),
            format_trimmed(sizes.slot_width, DIGITS),
            format_trimmed(sizes.pin_diameter, DIGITS)
        )),
        if is_true {
            "Wheel and driver in true size; lengths in millimetres. The plate turns behind the wheel."
        } else {
            "Wheel and driver to scale; lengths in millimetres. The plate turns behind the wheel."
        },
    );
    let drawn = above.dimensions.iter().chain(&below.dimensions).map(|(_, of)| (of.name, of.to - of.from));
    let numbers: Vec<(&str, f64)> = drawn.chain(listed.iter().copied()).collect();
    let columns = numbers.iter().map(|(name, _)| (name.replace(' ', "-"), unit_of(name)));
    let series = Series::of_columns(columns, vec![numbers.iter().map(|(_, value)| *value).collect()]);
    words.figure(canvas, kind, series)
}

/// A length along the line of centres, from and to places from the wheel's axis, in millimetres.
#[derive(Clone, Copy, Debug)]
struct Dimension {
    name: &'static str,
    from: f64,
    to: f64,
}

impl Dimension {
    fn label(&self) -> Label {
        let letter = match self.name {
            "crank radius" => "R",
            "centre distance" => "l",
            _ => "",
        };
        Label::words(&format!("{} {}", self.name, format_trimmed(self.to - self.from, DIGITS))).of_part(letter)
    }
}

/// The dimensions above and below the bodies.
fn along(sizes: &Sizes) -> (Vec<Dimension>, Vec<Dimension>) {
    let c = sizes.centre_distance;
    let of = |name, from, to| Dimension { name, from, to };
    let mut above = vec![
        of("slot depth", sizes.slot_end - sizes.slot_width / 2.0, sizes.wheel_radius),
        of("wheel radius", 0.0, sizes.wheel_radius),
        of("plate radius", c, c + sizes.plate_radius),
    ];
    above.extend(sizes.locking_disc.map(|disc| of("locking disc radius", c, c + disc.radius)));
    let below = vec![
        of("tip radius", -sizes.tip_radius, 0.0),
        of("slot end", 0.0, sizes.slot_end),
        of("crank radius", sizes.deepest(), c),
        of("centre distance", 0.0, c),
    ];
    (above, below)
}

/// Dimensions in rows in which neither they nor their names overlap.
struct Rows {
    /// Each with the number of its row from the bodies.
    dimensions: Vec<(usize, Dimension)>,
    count: usize,
    /// How far they reach from the wheel's axis, in pixels.
    left: f64,
    right: f64,
}

impl Rows {
    /// Each dimension in the row nearest to the bodies that has room.
    fn of(dimensions: Vec<Dimension>, scale: f64) -> Self {
        let mut rows: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut placed = Vec::new();
        for dimension in dimensions {
            let [from, to] = [dimension.from, dimension.to].map(|x| x * scale);
            let (middle, half) = ((from + to) / 2.0, dimension.label().width() / 2.0 + AIR);
            let [from, to] = [from.min(middle - half), to.max(middle + half)];
            let is_free = |row: &Vec<[f64; 2]>| row.iter().all(|[a, b]| *b <= from + TOUCHING || *a >= to - TOUCHING);
            let row = rows.iter().position(is_free).unwrap_or(rows.len());
            if row == rows.len() {
                rows.push(Vec::new());
            }
            if let Some(row) = rows.get_mut(row) {
                row.push([from, to]);
            }
            placed.push((row, dimension));
        }
        let left = rows.iter().flatten().map(|[from, _]| *from).fold(0.0, f64::min);
        let right = rows.iter().flatten().map(|[_, to]| *to).fold(0.0, f64::max);
        Self { dimensions: placed, count: rows.len(), left, right }
    }

    fn height(&self) -> f64 {
        TO_FIRST + ROW * self.count as f64
    }

    /// Draws them on one side (−1 above, 1 below) of the bodies, whose edge is so far from the line of centres. Where an
    /// extension line goes by a name, it is broken there.
    fn draw(&self, canvas: &mut Canvas, view: &View, edge: f64, side: f64) {
        let at = |x: f64| view.place(&Vector2::new(x, 0.0));
        let offset = |row: usize| Pixels::new(0.0, edge + side * (TO_FIRST + ROW * row as f64));
        for (row, dimension) in &self.dimensions {
            parts::of_label(canvas, &dimension.label(), |canvas| {
                parts::extension_lines(canvas, &at(dimension.from), &at(dimension.to), &offset(*row));
            });
        }
        for (row, dimension) in &self.dimensions {
            let (from, to, label) =
                (at(dimension.from) + offset(*row), at(dimension.to) + offset(*row), dimension.label());
            let (middle, half) = ((from + to) / 2.0, label.width() / 2.0 + AIR);
            let corner = |x: f64, y: f64| middle + Pixels::new(x * half, -y);
            let ground = Path::start(&corner(-1.0, GROUND[0]))
                .line_to(&corner(1.0, GROUND[0]))
                .line_to(&corner(1.0, GROUND[1]))
                .line_to(&corner(-1.0, GROUND[1]))
                .close();
            canvas.draw(Shape::path(ground).fill(PAPER).class("ground"));
        }
        for (row, dimension) in &self.dimensions {
            let (label, mut middle) = (dimension.label(), Pixels::zeros());
            parts::of_label(canvas, &label, |canvas| {
                let (from, to) = (at(dimension.from) + offset(*row), at(dimension.to) + offset(*row));
                middle = parts::dimension_line(canvas, &from, &to);
            });
            canvas.label(&middle, &Pixels::new(0.0, -1.0), OFF_LINE, &label);
        }
    }
}

/// The one dimension that is no length.
const CHAMFER_ANGLE: &str = "chamfer angle in degrees";

fn unit_of(name: &str) -> &'static str {
    match name {
        "stations" | "pins" => "1",
        CHAMFER_ANGLE => "deg",
        _ => "mm",
    }
}

/// What has no room on the drawing.
fn list(sizes: &Sizes) -> Vec<(&'static str, f64)> {
    let cut = sizes.locking_disc.map(|disc| disc.crescent);
    let cut =
        cut.into_iter().flat_map(|cut| [("crescent radius", cut.radius), ("crescent centre from driver", cut.centre)]);
    let mouth = match sizes.mouth {
        Mouth::Sharp => [None; 2],
        Mouth::Chamfer { width, angle } => [Some(("slot chamfer", width)), Some((CHAMFER_ANGLE, angle.to_degrees()))],
        Mouth::Round { radius } => [Some(("slot mouth radius", radius)), None],
        Mouth::LeadIn { length, flare } => [Some(("slot mouth length", length)), Some(("slot mouth flare", flare))],
    };
    let bore = |name, diameter: f64| (diameter > 0.0).then_some((name, diameter));
    [
        ("stations", f64::from(sizes.wheel.stations())),
        ("pins", f64::from(sizes.wheel.pins())),
        ("pin diameter", sizes.pin_diameter),
        ("slot width", sizes.slot_width),
        ("slot play", sizes.play.slot),
        ("locking play", sizes.play.locking),
        ("bore play", sizes.play.bore),
        ("slot bottom clearance", sizes.bottom_clearance),
        ("locking arc radius", sizes.locking_arc_radius),
        ("horn thickness", sizes.horn_thickness),
        ("web between slots", sizes.web),
    ]
    .into_iter()
    .chain(mouth.into_iter().flatten())
    .chain(cut)
    .chain(bore("wheel bore diameter", sizes.wheel_bore()))
    .chain(bore("driver bore diameter", sizes.driver_bore()))
    .collect()
}

/// Both parts with a pin on the line of centres, and the lines that tell where their axes and the pin's circle are.
fn bodies(canvas: &mut Canvas, sizes: &Sizes, outline: &Outline, view: &View) {
    let axis_at = Vector2::new(sizes.centre_distance, 0.0);
    let driver = |face: &Face| face.transform(PI, axis_at);
    let face = |canvas: &mut Canvas, face: &Face, fill: Colour, line: Colour, opacity: &str, class: &'static str| {
        let shape =
            Shape::path(path(face.loops(), view)).fill(fill).attribute("fill-opacity", opacity).stroke(line, 1.5);
        canvas.draw(shape.attribute("fill-rule", "evenodd").attribute("stroke-linejoin", "round").class(class));
    };
    face(canvas, &driver(&outline.plate), DRIVER, DRIVER, "0.1", "plate");
    face(canvas, &outline.wheel, FILL, FOLLOWER, "1", "wheel");
    if let Some(disc) = &outline.disc {
        face(canvas, &driver(disc), DRIVER, DRIVER, "0.22", "locking-disc");
    }
    for pin in &outline.pins {
        let pin = path(std::iter::once(&pin.transform(PI, axis_at)), view);
        canvas.draw(Shape::path(pin).fill(PAPER).stroke(INK, 1.5).class("pin"));
    }
    let (pivot, centre) = (view.origin, view.place(&axis_at));
    let circle = Shape::circle(&centre, sizes.crank_radius * view.scale).stroke(GRID, 1.0).dashed(DASHED);
    canvas.draw(circle.class("pin-circle"));
    canvas.draw(Shape::line(&pivot, &centre).stroke(GRID, 1.0).dashed(DASHED).class("line-of-centres"));
    axis(canvas, &pivot, FOLLOWER);
    axis(canvas, &centre, DRIVER);
}

/// Loops as one path.
fn path<'a>(loops: impl Iterator<Item = &'a Loop>, view: &View) -> Path {
    loops.fold(Path::empty(DECIMALS), |path, of| {
        let Some(first) = of.edges.first() else { return path };
        let path = of.edges.iter().fold(path.again_at(&view.place(&first.start_point())), |path, edge| match *edge {
            Edge::Line { to, .. } => path.line_to(&view.place(&to)),
            Edge::Arc { centre, radius, start, sweep } => {
                // A whole circle has no ends to draw it between: two halves.
                let halves = if sweep.abs() > 1.5 * PI { 2 } else { 1 };
                (1..=halves).fold(path, |path, half| {
                    let part = sweep / f64::from(halves);
                    let arc = Edge::Arc { centre, radius, start, sweep: part * f64::from(half) };
                    path.arc(
                        radius * view.scale,
                        part.abs() > PI,
                        Sense::from_rate(sweep),
                        &view.place(&arc.end_point()),
                    )
                })
            }
        });
        path.close()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn};
    use geneva_kinematics::wheel::{Choices, Scale, Wheel};

    fn sizes(stations: u32, pins: u32, a: f64) -> Sizes {
        let wheel = Wheel::with_pins(stations, pins).expect("possible");
        Sizes::new(wheel, Scale::CrankRadius(a), &Choices::default()).expect("fits")
    }

    #[test]
    fn slots_out_of_place_are_drawn_out_of_place_and_arcs_stay() {
        for (stations, turned) in [(4, 0.05), (6, -0.03), (12, 0.02)] {
            let sizes = sizes(stations, 1, 25.0);
            let (right, wrong) = (dimensions_on_a_page(&sizes), dimensions_of_a_wrong_wheel(&sizes, &sizes, turned));
            assert_drawn(&wrong);
            let corners = |figure: &Figure| {
                let drawing = ParsedDrawing::parse(figure);
                let [pivot, _] = drawing.line("line-of-centres");
                let data =
                    drawing.elements("wheel")[0].attribute("d").expect("a path").split('Z').next().expect("a loop");
                // Of the drawing's y axis, which points down.
                let of = crate::checks::corners(data.trim(), 1e3).into_iter().map(|p| p - pivot);
                of.map(|p| (p.norm(), libm::atan2(-p.y, p.x))).collect::<Vec<_>>()
            };
            let (right, wrong) = (corners(&right), corners(&wrong));
            assert_eq!(right.len(), wrong.len());
            let (mut out, mut stay) = (0, 0);
            for ((radius, angle), (other, at)) in right.iter().zip(&wrong) {
                assert!((radius - other).abs() < 0.01, "{radius} {other}");
                let moved = (at - angle + PI).rem_euclid(2.0 * PI) - PI;
                // Numbers of a drawing have two decimals.
                out += usize::from(((moved - turned) * radius).abs() < 0.02);
                stay += usize::from((moved * radius).abs() < 0.01);
            }
            // The ends of two walls of each slot, and of an arc.
            assert!(out >= 4 * stations as usize && stay >= 2 * stations as usize, "{stations}: {out} {stay}");
        }
        let sizes = sizes(6, 1, 25.0);
        assert_eq!(dimensions_of_a_wrong_wheel(&sizes, &sizes, 0.0).svg, dimensions_on_a_page(&sizes).svg);
    }

    #[test]
    fn mouths_are_drawn_and_listed() {
        let of = |mouth| {
            let choices = Choices { mouth, ..Choices::default() };
            Sizes::new(Wheel::new(6).expect("possible"), Scale::CrankRadius(25.0), &choices).expect("fits")
        };
        for (mouth, listed) in [
            (Mouth::Chamfer { width: 2.0, angle: 0.5 }, "slot chamfer 2"),
            (Mouth::Round { radius: 1.5 }, "slot mouth radius 1.5"),
            (Mouth::LeadIn { length: 5.0, flare: 0.5 }, "slot mouth length 5"),
        ] {
            let sizes = of(mouth);
            let figure = dimensions(&sizes);
            assert_drawn(&figure);
            let drawing = ParsedDrawing::parse(&figure);
            let [pivot, centre] = drawing.line("line-of-centres");
            let scale = (centre - pivot).norm() / sizes.centre_distance;
            let data = drawing.elements("wheel")[0].attribute("d").expect("a path").to_owned();
            let outline = data.split('Z').next().expect("a loop").trim();
            let corners = crate::checks::corners(outline, 0.02);
            let is_drawn = |x: f64, y: f64| {
                let at = pivot + Vector2::new(x, y) * scale;
                corners.iter().any(|corner| (corner - at).norm() < 0.005 * scale)
            };
            let half = sizes.slot_width / 2.0;
            let wall = sizes.wheel_radius - sizes.mouth_length();
            assert!(is_drawn(wall, half) && is_drawn(wall, -half), "{mouth:?}");
            assert!(!is_drawn(sizes.wheel_radius, half), "{mouth:?}: the sharp corner");
            assert!(drawing.texts().contains(&listed.to_owned()), "{mouth:?}: {:?}", drawing.texts());
        }
    }

    #[test]
    fn a_millimetre_is_a_millimetre() {
        for (stations, pins, a) in [(3, 1, 50.0), (4, 4, 20.0), (6, 2, 50.0), (12, 1, 30.0), (18, 1, 5.0), (6, 1, 0.8)]
        {
            let sizes = sizes(stations, pins, a);
            let figure = dimensions(&sizes);
            assert_drawn(&figure);
            let document = roxmltree::Document::parse(&figure.svg).expect("well-formed");
            let root = document.root_element();
            let millimetres = |name: &str| -> f64 {
                root.attribute(name).and_then(|size| size.strip_suffix("mm")).expect("mm").parse().expect("a number")
            };
            let view: Vec<f64> =
                root.attribute("viewBox").expect("there").split(' ').map(|x| x.parse().expect("a number")).collect();
            let scale = millimetres("width") / view[2];
            approx::assert_relative_eq!(scale, millimetres("height") / view[3], max_relative = 1e-4);
            let drawing = ParsedDrawing::parse(&figure);
            let near = |read: f64, size: f64| assert!((read * scale - size).abs() < 0.01, "{} {size}", read * scale);
            near(drawing.number("pin-circle", "r"), sizes.crank_radius);
            near(drawing.length("line-of-centres"), sizes.centre_distance);
            let [pivot, centre] = drawing.line("line-of-centres");
            // Outlines read back: of the outermost loop the farthest and the nearest point.
            let farthest = |class: &str, from: &Vector2<f64>| {
                let node = &drawing.elements(class)[0];
                let data = node.attribute("d").expect("a path").split('Z').next().expect("a loop").trim().to_owned();
                crate::checks::corners(&data, 0.02).iter().map(|p| (p - from).norm()).fold(0.0, f64::max)
            };
            near(farthest("wheel", &pivot), sizes.tip_radius);
            near(farthest("plate", &centre), sizes.plate_radius);
            if let Some(disc) = sizes.locking_disc {
                near(farthest("locking-disc", &centre), disc.radius);
            }
            assert_eq!(drawing.count("pin") as u32, pins);
            let texts = drawing.texts();
            let said = format!("centre distance {}", format_trimmed(sizes.centre_distance, DIGITS));
            assert!(texts.contains(&said), "{texts:?}");
            assert_eq!(texts.len(), figure.series.columns.len() + 1);
        }
    }
}
