//! What must hold of the drawings as they are written, read back from the SVG.

use super::{over_the_engagement, position_triangle, velocity_triangle};
use crate::Figure;
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use roxmltree::{Document, Node};
use std::f64::consts::{PI, SQRT_2};

const RADIUS: f64 = 3.0;
const DRIVER: f64 = 7.0;
/// Half a unit of the last written digit of a coordinate, in each of a length's four coordinates, with room to spare.
const PIXELS: f64 = 0.02;

fn mechanism(stations: u32) -> PinSlot {
    PinSlot::new(RADIUS, RADIUS / libm::sin(PI / f64::from(stations))).expect("possible")
}

fn all_three(mechanism: &PinSlot, crank: &Turn<f64>, driver: f64) -> [Figure; 3] {
    [
        position_triangle(mechanism, crank),
        velocity_triangle(mechanism, crank, driver, "m/s"),
        over_the_engagement(mechanism, crank, driver, "m"),
    ]
}

/// Several mechanisms, each at entry, between, on the line of centres, beyond, and at exit.
fn every_figure() -> Vec<Figure> {
    let mut mechanisms: Vec<_> = (3..=8).map(mechanism).collect();
    mechanisms.push(PinSlot::new(RADIUS, 1.47 * RADIUS).expect("possible"));
    let mut figures = Vec::new();
    for mechanism in &mechanisms {
        let half = mechanism.engagement_half_angle();
        for share in [-1.0, -0.6, 0.0, 0.3, 1.0] {
            let crank = Turn::from_radians(PI + share * half);
            for driver in [DRIVER, -DRIVER, 0.0] {
                figures.extend(all_three(mechanism, &crank, driver));
            }
        }
    }
    figures
}

fn named<'a>(document: &'a Document<'a>, class: &str) -> Vec<Node<'a, 'a>> {
    document.descendants().filter(|node| node.attribute("class") == Some(class)).collect()
}

fn number(node: &Node<'_, '_>, attribute: &str) -> f64 {
    node.attribute(attribute).expect("there").parse().expect("a number")
}

/// The first point of a path: "M12.3 45.6 …".
fn start(node: &Node<'_, '_>) -> [f64; 2] {
    let data = node.attribute("d").expect("a path").trim_start_matches('M');
    let mut values = data.split(' ').map(|value| value.parse().expect("a number"));
    [values.next().expect("x"), values.next().expect("y")]
}

#[test]
fn every_figure_is_well_formed_labelled_and_fit_for_markdown() {
    for figure in every_figure() {
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
                let known = colour == "none" || colour == "currentColor" || colour.starts_with("var(--fig-");
                assert!(known, "{}: {attribute} {colour}", figure.id);
            }
        }
        assert!(!figure.svg.contains("href"));
    }
}

#[test]
fn no_figure_shows_a_negative_zero_or_what_is_no_number() {
    for figure in every_figure() {
        let text = figure.svg.clone() + &figure.series.to_text();
        for word in text.split(|c: char| c.is_whitespace() || "\"<>,()".contains(c)) {
            let value = word.trim_start_matches(['M', 'L', 'A']);
            let zero = value.strip_prefix(['-', '−']).is_some_and(|w| w.parse::<f64>() == Ok(0.0));
            assert!(!zero && !["NaN", "inf", "-inf"].contains(&word), "{}: {word}", figure.id);
        }
    }
}

#[test]
fn drawing_twice_gives_the_same_bytes() {
    let (mechanism, crank) = (mechanism(5), Turn::from_radians(2.7));
    assert_eq!(all_three(&mechanism, &crank, DRIVER), all_three(&mechanism, &crank, DRIVER));
}

#[test]
fn the_position_triangle_is_to_scale() {
    let mechanism = mechanism(4);
    let figure = position_triangle(&mechanism, &Turn::from_radians(2.5));
    let document = Document::parse(&figure.svg).expect("well-formed");
    let side = |class: &str| {
        let line = named(&document, class)[0];
        (number(&line, "x2") - number(&line, "x1")).hypot(number(&line, "y2") - number(&line, "y1"))
    };
    let circle = number(&named(&document, "pin-circle")[0], "r");
    assert!((side("side-R") - circle).abs() < PIXELS);
    assert!((side("side-l") - circle * SQRT_2).abs() < PIXELS);
    assert!((side("side-r") - circle * figure.series.rows[0][2]).abs() < PIXELS);
}

#[test]
fn the_arrows_of_the_velocity_triangle_close_and_are_to_scale() {
    let mechanism = mechanism(4);
    let figure = velocity_triangle(&mechanism, &Turn::from_radians(2.5), DRIVER, "m/s");
    let document = Document::parse(&figure.svg).expect("well-formed");
    let ends = |class: &str| {
        let parts = named(&document, class);
        (start(&parts[0]), start(&parts[1]))
    };
    let (pin, slot_point, sliding) = (ends("v-pin"), ends("v-slot-point"), ends("v-sliding"));
    assert_eq!((pin.0, slot_point.1, sliding.1), (slot_point.0, sliding.0, pin.1));
    let bar = named(&document, "scale-bar")[0];
    let length = |(a, b): ([f64; 2], [f64; 2])| (b[0] - a[0]).hypot(b[1] - a[1]);
    let scale = length(pin) / figure.series.rows[0][1];
    for (arrow, column) in [(slot_point, 2), (sliding, 3)] {
        assert!((length(arrow) - scale * figure.series.rows[0][column]).abs() < PIXELS, "column {column}");
    }
    let speed = (number(&bar, "x2") - number(&bar, "x1")) / scale;
    assert!((speed - speed.round()).abs() * scale < PIXELS, "the scale bar stands for {speed}");
}

#[test]
fn the_series_of_the_engagement_has_both_ends_and_every_degree_between() {
    let mechanism = mechanism(4);
    let figure = over_the_engagement(&mechanism, &Turn::from_radians(2.5), DRIVER, "m");
    let rows = &figure.series.rows;
    let degrees = 2.0 * mechanism.engagement_half_angle().to_degrees();
    assert_eq!(rows.len(), degrees.round() as usize + 1);
    for (row, sign) in [(&rows[0], -1.0), (&rows[rows.len() - 1], 1.0)] {
        approx::assert_relative_eq!(row[0], 180.0 + sign * degrees / 2.0, max_relative = 1e-14);
        approx::assert_abs_diff_eq!(row[1], 0.0, epsilon = 1e-14);
        approx::assert_relative_eq!(row[2], -sign * RADIUS * DRIVER, max_relative = 1e-14);
    }
    let document = Document::parse(&figure.svg).expect("well-formed");
    let curves = document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "polyline")));
    let long =
        curves.filter(|node| node.attribute("points").is_some_and(|p| p.split_whitespace().count() == rows.len()));
    assert_eq!(long.count(), 2);
}
