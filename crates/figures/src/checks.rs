//! What holds of every figure, and how tests read a drawing back.

use crate::svg::TEXT_SIZE;
use crate::{Figure, Series};
use nalgebra::Vector2;
use roxmltree::{Document, Node};
use std::f64::consts::PI;

/// Half a unit of the last written digit of a coordinate, in each of a length's four coordinates, with room to spare.
pub(crate) const PIXELS: f64 = 0.02;
/// Most bytes of a figure; of one that moves; of one with a mark for every run under every hypothesis.
const HEAVIEST: usize = 25_000;
const HEAVIEST_MOVING: usize = 32_000;
const HEAVIEST_OF_ALL_RUNS: usize = 40_000;

/// A figure as it is written, for tests that read it back.
pub(crate) struct ParsedDrawing<'a>(Document<'a>);

/// The values of these columns, row by row.
#[track_caller]
pub(crate) fn columns<const N: usize>(series: &Series, names: [&str; N]) -> Vec<[f64; N]> {
    let place = |name: &str| {
        let place = series.columns.iter().position(|column| column.name == name);
        place.unwrap_or_else(|| panic!("no column {name:?} among {:?}", series.columns))
    };
    let places = names.map(place);
    series.rows.iter().map(|row| places.map(|place| row[place])).collect()
}

impl<'a> ParsedDrawing<'a> {
    /// Reads a figure.
    #[track_caller]
    pub(crate) fn parse(figure: &'a Figure) -> Self {
        Self(Document::parse(&figure.svg).expect("well-formed"))
    }

    /// The elements of a class.
    pub(crate) fn elements(&self, class: &str) -> Vec<Node<'_, 'a>> {
        self.0.descendants().filter(|node| node.attribute("class") == Some(class)).collect()
    }

    /// How many elements a class has.
    pub(crate) fn count(&self, class: &str) -> usize {
        self.elements(class).len()
    }

    /// An attribute of the first element of a class, as a number.
    #[track_caller]
    pub(crate) fn number(&self, class: &str, attribute: &str) -> f64 {
        number(&self.elements(class)[0], attribute)
    }

    /// The centre of the first circle of a class.
    #[track_caller]
    pub(crate) fn centre(&self, class: &str) -> Vector2<f64> {
        Vector2::new(self.number(class, "cx"), self.number(class, "cy"))
    }

    /// The corners of the path of this number of a class: see [`corners`].
    #[track_caller]
    pub(crate) fn path(&self, class: &str, number: usize) -> Vec<Vector2<f64>> {
        corners(self.elements(class)[number].attribute("d").expect("a path"), 0.1)
    }

    /// The ends of the first line of a class.
    #[track_caller]
    pub(crate) fn line(&self, class: &str) -> [Vector2<f64>; 2] {
        [["x1", "y1"], ["x2", "y2"]].map(|[x, y]| Vector2::new(self.number(class, x), self.number(class, y)))
    }

    /// The length of the first line of a class.
    #[track_caller]
    pub(crate) fn length(&self, class: &str) -> f64 {
        let [from, to] = self.line(class);
        (to - from).norm()
    }

    /// Tail and tip of an arrow: shaft and head have the class of its name.
    pub(crate) fn arrow(&self, name: &str) -> Option<[Vector2<f64>; 2]> {
        let parts = self.elements(name);
        (parts.len() == 2).then(|| [self.path(name, 0)[0], self.path(name, 1)[0]])
    }

    /// The base line of the first text that says this.
    #[track_caller]
    pub(crate) fn base_line(&self, text: &str) -> f64 {
        let is_text = |node: &Node<'_, '_>| node.tag_name().name() == "text" && words(node) == text;
        number(&self.0.descendants().find(is_text).expect("there"), "y")
    }

    /// All texts.
    pub(crate) fn texts(&self) -> Vec<String> {
        self.0.descendants().filter(|node| node.tag_name().name() == "text").map(|node| words(&node)).collect()
    }
}

/// The value of an attribute.
#[track_caller]
pub(crate) fn number(node: &Node<'_, '_>, attribute: &str) -> f64 {
    node.attribute(attribute).expect("there").parse().expect("a number")
}

/// All that is asked of a figure as a reader is shown it: that it is drawn ([`assert_drawn`]), that no labels overlap or lie outside,
/// and that it is light.
#[track_caller]
pub(crate) fn assert_sound(figure: &Figure) {
    for line in figure.svg.lines().filter(|line| line.contains("linecap=\"square\"")) {
        assert!(!line.contains("h0"), "{}: a mark without a length has no square ends on paper", figure.id);
    }
    assert_drawn(figure);
    labels_inside(figure);
    assert_eq!(overlapping_labels(figure), [], "{}", figure.id);
}

/// What is asked of a figure of anything that can be drawn: well-formed, in true numbers, and light.
#[track_caller]
pub(crate) fn assert_drawn(figure: &Figure) {
    well_formed(figure);
    only_numbers(figure);
    let most = match figure.id.as_str() {
        "wheel-motion" | "timer-verge" => HEAVIEST_MOVING,
        "runs-hypotheses" => HEAVIEST_OF_ALL_RUNS,
        _ => HEAVIEST,
    };
    assert!(figure.svg.len() < most, "{}: {} bytes", figure.id, figure.svg.len());
}

/// Well-formed, named and described, in known colours, without scripts and links, fit to stand in Markdown.
#[track_caller]
fn well_formed(figure: &Figure) {
    let document = Document::parse(&figure.svg).expect("well-formed");
    let root = document.root_element();
    let (title, description) = (format!("{}-title", figure.id), format!("{}-desc", figure.id));
    assert_eq!(root.attribute("aria-labelledby"), Some(format!("{title} {description}").as_str()));
    assert_eq!(root.attribute("role"), Some("img"));
    for (id, text) in [(title, &figure.title), (description, &figure.description)] {
        let node = document.descendants().find(|node| node.attribute("id") == Some(&id)).expect("named");
        assert_eq!(node.text(), Some(text.as_str()));
    }
    assert!(figure.svg.lines().all(|line| line.starts_with('<') && line.ends_with('>')), "{}", figure.id);
    for node in document.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        assert!(name.bytes().all(|b| b.is_ascii_lowercase()) && name != "script", "{name}");
        for attribute in ["fill", "stroke"] {
            let colour = node.attribute(attribute).unwrap_or("none");
            let is_mixed = attribute == "stroke" && colour.starts_with("color-mix(in srgb, ");
            let known = colour == "none" || colour == "currentColor" || colour.starts_with("var(--fig-") || is_mixed;
            assert!(known, "{}: {attribute} {colour}", figure.id);
        }
    }
    let mut ids: Vec<_> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    ids.sort_unstable();
    assert!(ids.windows(2).all(|pair| pair[0] != pair[1]), "{}: {ids:?}", figure.id);
    assert!(!figure.svg.contains("href"));
}

/// No negative zero and nothing that is no number, in the drawing and in the series.
#[track_caller]
fn only_numbers(figure: &Figure) {
    let text = figure.svg.clone() + &figure.series.to_text();
    for word in text.split(|c: char| c.is_whitespace() || "\"<>,():%".contains(c)) {
        let value = word.trim_start_matches(['M', 'L', 'A']).trim_end_matches("deg");
        let zero = value.strip_prefix(['-', '−']).is_some_and(|w| w.parse::<f64>() == Ok(0.0));
        assert!(!zero && !["NaN", "inf", "-inf"].contains(&word), "{}: {word}", figure.id);
    }
}

/// The corners of a path of lines and circular arcs; arcs are cut into steps of at most `step` radians.
pub(crate) fn corners(data: &str, step: f64) -> Vec<Vector2<f64>> {
    let mut points: Vec<Vector2<f64>> = Vec::new();
    for part in data.split(" L") {
        for (k, piece) in part.split(" A").enumerate() {
            let piece = piece.trim_end_matches(" Z").trim_start_matches('M');
            let values: Vec<f64> = piece.split(' ').map(|value| value.parse().expect("a number")).collect();
            let to = Vector2::new(values[values.len() - 2], values[values.len() - 1]);
            if k > 0 {
                let from = *points.last().expect("a start");
                arc(from, to, values[0], values[3] > 0.0, values[4] > 0.0, step, &mut points);
            }
            points.push(to);
        }
    }
    points
}

/// Points of an arc between its ends, in the manner of SVG's path data.
fn arc(
    from: Vector2<f64>,
    to: Vector2<f64>,
    radius: f64,
    large: bool,
    sweep: bool,
    step: f64,
    points: &mut Vec<Vector2<f64>>,
) {
    let chord = to - from;
    let height = (radius * radius - chord.norm_squared() / 4.0).max(0.0).sqrt();
    let side = if large == sweep { -1.0 } else { 1.0 };
    let centre = (from + to) / 2.0 + Vector2::new(-chord.y, chord.x).normalize() * height * side;
    let angle = |point: Vector2<f64>| libm::atan2(point.y - centre.y, point.x - centre.x);
    let turn = (angle(to) - angle(from)).rem_euclid(2.0 * PI);
    let turn = if sweep { turn } else { turn - 2.0 * PI };
    // A half circle may be written as either.
    assert!((turn.abs() > PI) == large || (turn.abs() - PI).abs() < 0.1, "the large flag is that of the arc");
    let count = (turn.abs() / step) as u32 + 1;
    for k in 1..count {
        let at = angle(from) + turn * f64::from(k) / f64::from(count);
        points.push(centre + Vector2::new(libm::cos(at), libm::sin(at)) * (centre - from).norm());
    }
}

/// How deep a point lies inside a closed outline: its distance from the outline, negative outside.
pub(crate) fn depth(point: &Vector2<f64>, outline: &[Vector2<f64>]) -> f64 {
    // Plain numbers: this runs millions of times in unoptimised tests.
    let (mut inside, mut near) = (false, f64::INFINITY);
    let (x, y) = (point.x, point.y);
    let Some(last) = outline.last() else { return f64::NEG_INFINITY };
    let (mut ax, mut ay) = (last.x, last.y);
    for b in outline {
        let (dx, dy) = (b.x - ax, b.y - ay);
        let square = dx * dx + dy * dy;
        let along = if square > 0.0 { (((x - ax) * dx + (y - ay) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
        let (ox, oy) = (x - ax - along * dx, y - ay - along * dy);
        near = near.min(ox * ox + oy * oy);
        if (ay > y) != (b.y > y) && x < ax + dx * (y - ay) / dy {
            inside = !inside;
        }
        (ax, ay) = (b.x, b.y);
    }
    if inside { near.sqrt() } else { -near.sqrt() }
}

/// How deep one of two closed outlines reaches into the other: the greatest depth of a point of either's boundary within the
/// other, looked for at many points of each side; negative if they are apart.
pub(crate) fn overlap(one: &[Vector2<f64>], other: &[Vector2<f64>]) -> f64 {
    const POINTS: u32 = 24;
    let deepest = |of: &[Vector2<f64>], within: &[Vector2<f64>]| {
        let mut most = f64::NEG_INFINITY;
        for (k, from) in of.iter().enumerate() {
            let to = of[(k + 1) % of.len()];
            for share in (0..POINTS).map(|k| f64::from(k) / f64::from(POINTS)) {
                most = most.max(depth(&from.lerp(&to, share), within));
            }
        }
        most
    };
    deepest(one, other).max(deepest(other, one))
}

/// The room that a text of ours takes, by a guess at its letters: its least and its greatest corner.
///
/// `None` for a text within a group: the numbers of the axes of a chart.
fn text_area(node: &Node<'_, '_>) -> Option<[Vector2<f64>; 2]> {
    if !node.has_tag_name(("http://www.w3.org/2000/svg", "text")) || node.parent()? != node.document().root_element() {
        return None;
    }
    let (mut width, mut x) = (0.0_f64, 0.0_f64);
    for span in node.children().filter(Node::is_element) {
        let size = span.attribute("font-size").map_or(TEXT_SIZE, |size| size.parse().expect("a number"));
        x += span.attribute("dx").map_or(0.0, |dx| dx.parse().expect("a number"));
        x += span.text().unwrap_or_default().chars().count() as f64 * 0.54 * size;
        width = width.max(x);
    }
    let left = match node.attribute("text-anchor") {
        Some("start") => number(node, "x"),
        Some("end") => number(node, "x") - width,
        _ => number(node, "x") - width / 2.0,
    };
    let base = number(node, "y");
    Some([Vector2::new(left, base - 15.0), Vector2::new(left + width, base + 4.0)])
}

/// Every label lies within the image, but for some pixels of the guess at its letters.
#[track_caller]
pub(crate) fn labels_inside(figure: &Figure) {
    let document = Document::parse(&figure.svg).expect("well-formed");
    let view = document.root_element().attribute("viewBox").expect("there").to_owned();
    let size: Vec<f64> = view.split(' ').map(|value| value.parse().expect("a number")).collect();
    for node in document.descendants() {
        if let Some([least, greatest]) = text_area(&node) {
            let inside = least.x > -3.0 && least.y > -3.0 && greatest.x < size[2] + 3.0 && greatest.y < size[3] + 3.0;
            assert!(inside, "{}: {} at {least:?} to {greatest:?}", figure.id, words(&node));
        }
    }
}

/// The pairs of labels that overlap.
fn overlapping_labels(figure: &Figure) -> Vec<(String, String)> {
    let document = Document::parse(&figure.svg).expect("well-formed");
    let labels: Vec<_> =
        document.descendants().filter_map(|node| text_area(&node).map(|area| (words(&node), area))).collect();
    let mut pairs = Vec::new();
    for (k, (one, a)) in labels.iter().enumerate() {
        for (other, b) in labels.iter().skip(k + 1) {
            let common = a[1].inf(&b[1]) - a[0].sup(&b[0]);
            if common.x > 0.0 && common.y > 0.0 {
                pairs.push((one.clone(), other.clone()));
            }
        }
    }
    pairs
}

/// The text of a node and of all within it.
fn words(node: &Node<'_, '_>) -> String {
    node.descendants().filter(Node::is_text).filter_map(|text| text.text()).collect()
}
