//! The spherical wheel and its driver in space, in the middle of an index.

use super::pose::count_noun;
use crate::number::{degrees, significant};
use crate::parts::{self, WIDTH};
use crate::svg::{Canvas, DrawingKind, Label, LabelPosition, Path, Pixels, Shape, View, leader};
use crate::theme::{Colour, DRIVER, FILL, FOLLOWER, INK, PAPER};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use nalgebra::{Vector2, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Where it is seen from: degrees to the side of the driver's axis, and above the plane of the wheel's rim.
const SIDE: f64 = -38.0;
const ABOVE: f64 = 24.0;
/// Half the width of a slot, and the locking arc's angular radius, over half the pitch angle.
const HALF_WIDTH: f64 = 0.1;
const LOCKING: f64 = 0.72;
/// Distance of the driver's plate from the centre over that of the pin's circle.
const PLATE: f64 = 1.35;
/// Angular radius of the plate over that of the pin's circle.
const PLATE_RADIUS: f64 = 1.12;
/// From the centre to the end of the wheel's axis, and from the plate to that of the driver's, in radii of the sphere.
const AXIS: f64 = 1.3;
const BEYOND_PLATE: f64 = 1.1;
/// Degrees between points of a curve.
const STEP: f64 = 6.0;
/// Free space above and below the sphere, in pixels.
const MARGIN: f64 = 40.0;
const HEIGHT: f64 = 500.0;
/// Free space at its left, and at its right, where the name of the driver's axis is, in pixels.
const SIDES: [f64; 2] = [16.0, 164.0];

/// Parallel projection: the directions of the page in space.
struct Sight {
    right: Vector3<f64>,
    up: Vector3<f64>,
    towards: Vector3<f64>,
    view: View,
}

impl Sight {
    /// Sphere and driver as large as they have room.
    fn new(alpha: f64) -> Self {
        let (side, above) = (Turn::from_degrees(SIDE), Turn::from_degrees(ABOVE));
        let towards = Vector3::new(above.cos * side.cos, above.cos * side.sin, above.sin);
        let right = Vector3::new(-side.sin, side.cos, 0.0);
        let up = towards.cross(&right);
        let ends = [Vector3::z() * AXIS, right, -right, driver_axis(alpha)];
        let shown = ends.into_iter().chain(circle(PLATE_RADIUS * alpha, PLATE, 0.0, 2.0 * PI));
        let points = shown.map(|at| Vector2::new(at.dot(&right), at.dot(&up)));
        let [left, rest] = SIDES;
        let room = Vector2::new(WIDTH - left - rest, HEIGHT - 2.0 * MARGIN);
        let centre = Vector2::new(left + room.x / 2.0, HEIGHT / 2.0);
        Self { right, up, towards, view: View::fitting(points, room, centre) }
    }

    fn place(&self, at: &Vector3<f64>) -> Pixels {
        self.view.place(&Vector2::new(at.dot(&self.right), at.dot(&self.up)))
    }

    fn outline(&self, points: impl IntoIterator<Item = Vector3<f64>>) -> Path {
        Path::through(&points.into_iter().map(|at| self.place(&at)).collect::<Vec<_>>(), 1)
    }

    fn curve(&self, points: &[Vector3<f64>]) -> Path {
        points.iter().fold(Path::empty(1), |path, at| {
            if path.is_empty() { path.again_at(&self.place(at)) } else { path.line_to(&self.place(at)) }
        })
    }
}

/// A point of the unit sphere at this longitude and latitude, in radians.
fn on_sphere(longitude: f64, latitude: f64) -> Vector3<f64> {
    let (long, lat) = (Turn::from_radians(longitude), Turn::from_radians(latitude));
    Vector3::new(lat.cos * long.cos, lat.cos * long.sin, lat.sin)
}

/// Angles from one to another, in radians, no further apart than a step.
fn angles(from: f64, to: f64) -> impl DoubleEndedIterator<Item = f64> {
    let count = libm::ceil((to - from).to_degrees() / STEP).max(1.0) as u32;
    (0..=count).map(move |k| from + (to - from) * f64::from(k) / f64::from(count))
}

/// Angles over half a turn, for circles that are small on the page.
fn half_turn() -> impl Iterator<Item = f64> {
    (0..=16).map(|k| PI * f64::from(k) / 16.0)
}

/// The circle about the driver's axis of this angular radius, at a distance from the centre, between two crank angles.
fn circle(radius: f64, distance: f64, from: f64, to: f64) -> impl Iterator<Item = Vector3<f64>> {
    let size = Turn::from_radians(radius);
    angles(from, to).map(move |angle| {
        let turn = Turn::from_radians(angle);
        Vector3::new(size.cos, size.sin * turn.sin, size.sin * turn.cos) * distance
    })
}

/// The end of the driver's axis.
fn driver_axis(alpha: f64) -> Vector3<f64> {
    Vector3::x() * (PLATE * libm::cos(alpha) + BEYOND_PLATE)
}

/// A spherical wheel and its driver with the pin deepest in its slot, seen from the side and from above.
///
/// The wheel is the upper half of a sphere and turns about the vertical axis; the driver turns about a level one through
/// the same centre. Series: N, pins, the sphere's radius and the slot's length along its meridian in crank radii, α.
pub fn spherical_mechanism(wheel: &SphericalWheel) -> Figure {
    let alpha = wheel.half_pitch_angle();
    let sight = Sight::new(alpha);
    let mut canvas = Canvas::new(WIDTH, HEIGHT);
    draw_wheel(&mut canvas, &sight, wheel.stations(), alpha);
    draw_driver(&mut canvas, &sight, wheel.pins(), alpha);
    names(&mut canvas, &sight, alpha);
    let series = Series::of_one([
        ("N", "1", f64::from(wheel.stations())),
        ("pins", "1", f64::from(wheel.pins())),
        ("sphere/r", "1", wheel.sphere_radius_ratio()),
        ("slot/r", "1", wheel.slot_length_ratio()),
        ("alpha", "deg", alpha.to_degrees()),
    ]);
    let words = Words::new(
        "spherical-mechanism",
        format!(
            "Spherical Geneva mechanism with {} stations and {}",
            wheel.stations(),
            count_noun(wheel.pins(), "pin")
        ),
        format!(
            "Half a sphere that turns about a vertical axis, with {} along meridians, which open at its level rim, and a \
             hollow locking arc between each two. A driver turns about a level axis through the sphere's centre. Its pin \
             points to that centre at {} to the driver's axis, and is deepest in a slot. The sphere's radius is {} crank \
             radii.",
            count_noun(wheel.stations(), "slot"),
            degrees(alpha),
            significant(wheel.sphere_radius_ratio(), 4)
        ),
        "The spherical wheel, to scale in parallel projection. The axes cross at right angles in the sphere's centre, and \
         the pin is in a slot for half of each turn of the driver, whatever the number of slots.",
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

fn draw_wheel(canvas: &mut Canvas, sight: &Sight, stations: u32, alpha: f64) {
    // What is seen of the half sphere: its outline above, from one end of the rim's width to the other, and the rim's
    // nearer half below.
    let above = angles(0.0, PI).map(|angle| {
        let turn = Turn::from_radians(angle);
        sight.right * turn.cos + sight.up * turn.sin
    });
    let ends = libm::atan2(sight.right.y, sight.right.x);
    let rim = angles(ends - PI, ends).map(|angle| on_sphere(angle, 0.0));
    let dome = sight.outline(above.chain(rim));
    canvas
        .draw(Shape::path(dome).fill(FILL).stroke(FOLLOWER, 2.0).attribute("stroke-linejoin", "round").class("wheel"));
    for k in 0..stations {
        let slot = 2.0 * alpha * f64::from(k);
        cut(canvas, sight, &slot_outline(slot, alpha), "slot");
        cut(canvas, sight, &locking_outline(slot + alpha, LOCKING * alpha), "locking-arc");
    }
}

/// A slot along its meridian: its sides are as far from it everywhere as at the rim, and it ends in half a circle.
fn slot_outline(longitude: f64, alpha: f64) -> Vec<Vector3<f64>> {
    let half = HALF_WIDTH * alpha;
    let (along, aside) = (on_sphere(longitude, 0.0), on_sphere(longitude + FRAC_PI_2, 0.0));
    let side = |lat: f64, sense: f64| {
        let turn = Turn::from_radians(lat);
        let middle = along * turn.cos + Vector3::z() * turn.sin;
        (middle + aside * (sense * libm::tan(half))).normalize()
    };
    let (end, northwards) = (on_sphere(longitude, alpha), on_sphere(longitude, alpha + FRAC_PI_2));
    let round = half_turn().map(move |angle| {
        let turn = Turn::from_radians(angle);
        (end + (aside * turn.cos + northwards * turn.sin) * libm::tan(half)).normalize()
    });
    let up = angles(0.0, alpha).map(|lat| side(lat, 1.0));
    let down = angles(0.0, alpha).rev().map(|lat| side(lat, -1.0));
    up.chain(round).chain(down).collect()
}

/// The part above the rim of a circle about a point of the rim.
fn locking_outline(longitude: f64, radius: f64) -> Vec<Vector3<f64>> {
    let (middle, aside) = (on_sphere(longitude, 0.0), on_sphere(longitude + FRAC_PI_2, 0.0));
    let size = Turn::from_radians(radius);
    let at = |angle: f64| {
        let turn = Turn::from_radians(angle);
        middle * size.cos + (aside * turn.cos + Vector3::z() * turn.sin) * size.sin
    };
    half_turn().map(at).collect()
}

/// A cut in the sphere from the rim up and back to the rim, if it is wholly on the side that is seen.
fn cut(canvas: &mut Canvas, sight: &Sight, edge: &[Vector3<f64>], class: &str) {
    let (Some(first), Some(last)) = (edge.first(), edge.last()) else { return };
    if edge.iter().all(|at| at.dot(&sight.towards) > 0.0) {
        let [from, to] = [last, first].map(|at| libm::atan2(at.y, at.x));
        let turn = libm::remainder(to - from, 2.0 * PI);
        let along_rim = (0..=6).map(|k| f64::from(k) / 6.0).map(|share| on_sphere(from + share * turn, 0.0));
        let open = sight.outline(edge.iter().copied().chain(along_rim));
        canvas.draw(Shape::path(open).fill(PAPER).stroke(PAPER, 4.0).class("open"));
        let edge = Shape::path(sight.curve(edge)).stroke(FOLLOWER, 1.5).attribute("stroke-linejoin", "round");
        canvas.draw(edge.class(class));
    }
}

fn draw_driver(canvas: &mut Canvas, sight: &Sight, pins: u32, alpha: f64) {
    let pin_circle = sight.outline(circle(alpha, 1.0, 0.0, 2.0 * PI));
    canvas.draw(Shape::path(pin_circle).stroke(DRIVER, 1.3).dashed("2 4").class("pin-circle"));
    if pins == 1 {
        // Opposite to the pin, a half disc that fills a locking arc while the pin is below the rim.
        let segment = sight.outline(circle(LOCKING * alpha, 1.0, FRAC_PI_2, 1.5 * PI));
        let segment = Shape::path(segment).tint(DRIVER, 0.22).stroke(DRIVER, 1.5);
        canvas.draw(segment.class("locking-segment"));
    }
    for k in 0..pins {
        let angle = PI * f64::from(k);
        let turn = Turn::from_radians(angle);
        let size = Turn::from_radians(alpha);
        let pin = Vector3::new(size.cos, 0.0, size.sin * turn.cos);
        let (inner, outer) = (sight.place(&(pin * 0.94)), sight.place(&(pin * PLATE)));
        for (colour, width) in [(INK, 9.0), (PAPER, 6.0)] {
            canvas.draw(
                Shape::line(&inner, &outer).stroke(colour, width).attribute("stroke-linecap", "round").class("pin"),
            );
        }
    }
    let plate = sight.outline(circle(PLATE_RADIUS * alpha, PLATE, 0.0, 2.0 * PI));
    canvas.draw(Shape::path(plate).tint(DRIVER, 0.1).stroke(DRIVER, 2.0).class("driver"));
}

fn names(canvas: &mut Canvas, sight: &Sight, alpha: f64) {
    let (plate, end) = (Vector3::x() * (PLATE * libm::cos(alpha)), driver_axis(alpha));
    let top = Vector3::z() * AXIS;
    dashed(canvas, &sight.place(&Vector3::zeros()), &sight.place(&top), FOLLOWER);
    dashed(canvas, &sight.place(&Vector3::zeros()), &sight.place(&end), DRIVER);
    parts::axis(canvas, &sight.place(&plate), DRIVER);
    let right = Vector2::new(1.0, 0.0);
    canvas.label(&sight.place(&top), &right, 10.0, &Label::words("wheel’s axis").in_colour(FOLLOWER));
    canvas.label(&sight.place(&end), &Vector2::new(0.4, 0.9), 14.0, &Label::words("driver’s axis").in_colour(DRIVER));
    let pin = on_sphere(0.0, alpha) * PLATE;
    // Beyond the wheel's outline.
    let place = LabelPosition { point: sight.place(&pin), towards: Vector2::new(0.8, -0.6), distance: 62.0 };
    canvas.label(&place.point, &place.towards, place.distance, &Label::words("pin"));
    leader(canvas, &place);
}

fn dashed(canvas: &mut Canvas, from: &Pixels, to: &Pixels, colour: Colour) {
    canvas.draw(Shape::line(from, to).stroke(colour, 1.3).dashed("9 3 2 3").class("axis"));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{assert_drawn, assert_sound};

    #[test]
    fn it_is_drawn_in_true_numbers_and_legibly() {
        for stations in 3..=18 {
            for pins in [1, 2] {
                let figure = spherical_mechanism(&SphericalWheel::with_pins(stations, pins).expect("possible"));
                assert_drawn(&figure);
                if (4..=8).contains(&stations) {
                    assert_sound(&figure);
                }
            }
        }
    }

    #[test]
    fn a_slot_is_as_wide_as_at_the_rim_and_as_deep_as_the_pin_goes() {
        for stations in [3, 4, 8] {
            let alpha = PI / f64::from(stations);
            let outline = slot_outline(0.7, alpha);
            let (along, half) = (on_sphere(0.7 + FRAC_PI_2, 0.0), HALF_WIDTH * alpha);
            for at in &outline {
                approx::assert_relative_eq!(at.norm(), 1.0, max_relative = 1e-12);
                assert!(libm::asin(at.dot(&along)).abs() <= half * (1.0 + 1e-9));
            }
            let deepest = outline.iter().map(|at| libm::asin(at.z)).fold(0.0, f64::max);
            approx::assert_relative_eq!(deepest, alpha + half, max_relative = 1e-9);
        }
    }
}
