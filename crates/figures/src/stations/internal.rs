//! The internal wheel and its driver to scale, locked.

use super::pose::count_noun;
use crate::number::significant;
use crate::parts::{self, WIDTH, link, pin_circle, sense};
use crate::svg::{Canvas, DrawingKind, Label, Path, Pixels, Sense, Shape, View, heading};
use crate::theme::{DRIVER, FILL, FOLLOWER, INK};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Half the width of a slot, and the radius of a pin in it, in crank radii.
const HALF_WIDTH: f64 = 0.08;
const PIN: f64 = 0.07;
/// Radius of the locking arcs: the wall between one and a slot is as thick as the slot is wide.
const LOCKING: f64 = 1.0 - 3.0 * HALF_WIDTH;
/// Thickness of the locking segment; of that for three stations, which has less room.
const SEGMENT: f64 = 0.16;
const SEGMENT_OF_THREE: f64 = 0.05;
/// Free space around the wheel, in pixels.
const MARGIN: f64 = 46.0;
/// From the wheel to the arrow of its sense, and from a part to its name, in pixels.
const TO_ARROW: f64 = 16.0;
const TO_NAME: f64 = 10.0;

/// Lengths of an internal wheel and its driver, in crank radii.
#[derive(Clone, Copy, Debug)]
struct Ring {
    stations: u32,
    half_pitch: f64,
    /// Where the slots open.
    mouth: f64,
    /// Where the pin's centre is deepest.
    bottom: f64,
    outside: f64,
    centre: f64,
    /// Inner radius of the locking segment about the driver's axis.
    segment: f64,
}

impl Ring {
    fn new(wheel: &InternalWheel) -> Self {
        let thickness = if wheel.stations() == 3 { SEGMENT_OF_THREE } else { SEGMENT };
        Self {
            stations: wheel.stations(),
            half_pitch: wheel.half_pitch_angle(),
            mouth: wheel.wheel_radius_ratio(),
            bottom: wheel.slot_bottom_ratio(),
            outside: wheel.slot_bottom_ratio() + 3.0 * HALF_WIDTH,
            centre: wheel.centre_distance_ratio(),
            segment: LOCKING - thickness,
        }
    }

    /// Where a locking arc meets the mouth's circle, its centre on the first axis: along and above that axis.
    fn edge(&self) -> (f64, f64) {
        let (c, r) = (self.centre, self.mouth);
        let x = (c * c + r * r - LOCKING * LOCKING) / (2.0 * c);
        (x, (r * r - x * x).max(0.0).sqrt())
    }

    /// Half the angle that the locking segment takes: it fills a locking arc over the whole dwell, and no more.
    fn segment_half_angle(&self) -> f64 {
        FRAC_PI_2 - self.half_pitch
    }

    /// The wheel's inner outline about the view's origin, one slot at this angle.
    fn inside(&self, slot_angle: f64, view: &View) -> Path {
        let at = |angle: f64, x: f64, y: f64| {
            let turn = Turn::from_radians(angle);
            view.place(&Vector2::new(x * turn.cos - y * turn.sin, x * turn.sin + y * turn.cos))
        };
        let tip = (self.mouth * self.mouth - HALF_WIDTH * HALF_WIDTH).sqrt();
        let [mouth, slot, locking] = [self.mouth, HALF_WIDTH, LOCKING].map(|radius| radius * view.scale);
        let (x, y) = self.edge();
        let mut path = Path::start(&at(slot_angle, tip, -HALF_WIDTH));
        for k in 0..self.stations {
            let angle = slot_angle + 2.0 * self.half_pitch * f64::from(k);
            let (between, next) = (angle + self.half_pitch, angle + 2.0 * self.half_pitch);
            path = path.line_to(&at(angle, self.bottom, -HALF_WIDTH));
            path = path.arc_to(slot, Sense::CounterClockwise, &at(angle, self.bottom, HALF_WIDTH));
            path = path.line_to(&at(angle, tip, HALF_WIDTH));
            path = path.arc_to(mouth, Sense::CounterClockwise, &at(between, x, -y));
            path = path.arc(locking, true, Sense::CounterClockwise, &at(between, x, y));
            path = path.arc_to(mouth, Sense::CounterClockwise, &at(next, tip, -HALF_WIDTH));
        }
        path.close()
    }

    /// The locking segment about a point of the page, its middle in this direction.
    fn locking_segment(&self, about: &Pixels, middle: f64, scale: f64) -> Path {
        let half = self.segment_half_angle();
        let at = |radius: f64, angle: f64| about + heading(angle) * (radius * scale);
        let (from, to) = (middle - half, middle + half);
        Path::start(&at(LOCKING, from))
            .arc_to(LOCKING * scale, Sense::CounterClockwise, &at(LOCKING, to))
            .line_to(&at(self.segment, to))
            .arc_to(self.segment * scale, Sense::Clockwise, &at(self.segment, from))
            .close()
    }
}

/// An internal wheel and its driver at rest in the middle of a dwell, to scale.
///
/// Both turn counter-clockwise. The driver's axis lies within the ring, so its shaft ends behind the wheel; the pin and the
/// locking segment stand out from its plate into the wheel's plane. The locking arcs' radius is free: it is such that the
/// wall to a slot is as thick as the slot is wide. Series: N, and the sizes in crank radii.
pub fn internal_mechanism(wheel: &InternalWheel) -> Figure {
    let ring = Ring::new(wheel);
    let scale = (WIDTH / 2.0 - MARGIN) / ring.outside;
    let pivot = Vector2::new(WIDTH / 2.0, WIDTH / 2.0);
    let view = View { origin: pivot, scale };
    let axis = view.place(&Vector2::new(ring.centre, 0.0));
    let mut canvas = Canvas::new(WIDTH, WIDTH);

    draw_wheel(&mut canvas, &ring, &view);
    pin_circle(&mut canvas, &axis, scale);
    let pin = axis - Vector2::new(scale, 0.0);
    let plate = link(&axis, &pin, 1.5 * HALF_WIDTH * scale);
    canvas.draw(Shape::path(plate).tint(DRIVER, 0.12).stroke(DRIVER, 1.3).class("arms"));
    let segment = Shape::path(ring.locking_segment(&axis, 0.0, scale)).tint(DRIVER, 0.22);
    canvas.draw(segment.stroke(DRIVER, 2.0).attribute("stroke-linejoin", "round").class("locking-segment"));
    parts::pin(&mut canvas, &pin, PIN * scale);
    parts::axis(&mut canvas, &pivot, FOLLOWER);
    parts::axis(&mut canvas, &axis, DRIVER);
    names(&mut canvas, &ring, &view, &axis);

    let series = Series::of_one([
        ("N", "1", f64::from(wheel.stations())),
        ("l/r", "1", ring.centre),
        ("mouth/r", "1", ring.mouth),
        ("bottom/r", "1", ring.bottom),
        ("slot/r", "1", wheel.slot_length_ratio()),
        ("locking arc/r", "1", LOCKING),
        ("alpha", "deg", ring.half_pitch.to_degrees()),
        ("index", "deg", 2.0 * wheel.engagement_half_angle().to_degrees()),
    ]);
    let words = Words::new(
        "internal-mechanism",
        format!("Internal Geneva mechanism with {} stations, locked", wheel.stations()),
        format!(
            "A ring with {} that open inwards, and a hollow locking arc between each two. The driver's axis lies {} crank \
             radii from the wheel's, within the ring. Its pin is on the side of the wheel's axis, clear of the slots, and a \
             locking segment on the other side fills a locking arc. Both turn counter-clockwise.",
            count_noun(wheel.stations(), "slot"),
            significant(ring.centre, 4)
        ),
        "The internal wheel to scale, while it is locked. The driver turns inside the wheel, in the same direction, and the \
         pin moves the wheel for more than half of each turn of the driver.",
    );
    words.figure(canvas, DrawingKind::Mechanism, series)
}

fn draw_wheel(canvas: &mut Canvas, ring: &Ring, view: &View) {
    let (left, right) = (Vector2::new(-ring.outside, 0.0), Vector2::new(ring.outside, 0.0));
    let radius = ring.outside * view.scale;
    let rim = Path::start(&view.place(&left))
        .arc_to(radius, Sense::CounterClockwise, &view.place(&right))
        .arc_to(radius, Sense::CounterClockwise, &view.place(&left))
        .close();
    let outline = rim.data().to_owned() + " " + ring.inside(ring.half_pitch, view).data();
    canvas.draw_markup(format!(
        "<path d=\"{outline}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"{}\" stroke-width=\"2\" \
         stroke-linejoin=\"round\" class=\"wheel\"/>",
        FILL.0, FOLLOWER.0
    ));
}

fn names(canvas: &mut Canvas, ring: &Ring, view: &View, axis: &Pixels) {
    let scale = view.scale;
    let turns = [("φ", FOLLOWER, view.origin, ring.outside * scale + TO_ARROW, PI)];
    for (letter, colour, about, radius, middle) in turns {
        sense(canvas, &about, radius, middle, 1.0, &Label::symbol(letter).in_colour(colour));
    }
    // Beside the arm, clear of the segment.
    sense(canvas, axis, 0.42 * scale, 0.72 * PI, 1.0, &Label::symbol("θ").in_colour(DRIVER));
    let on_wheel = |radius: f64, angle: f64| view.origin + heading(angle) * (radius * scale);
    // The slot and the locking arc nearest to where their names have room: below and above, outside of the ring.
    let step = 2.0 * ring.half_pitch;
    let nearest = |first: f64, wanted: f64| first + libm::round((wanted - first) / step) * step;
    for (name, radius, angle) in [
        ("slot", ring.bottom, nearest(ring.half_pitch, 1.4 * PI)),
        ("locking arc", ring.centre + LOCKING, nearest(0.0, 0.55 * PI)),
    ] {
        let (at, end) = (on_wheel(radius, angle), on_wheel(ring.outside + TO_NAME / scale, angle));
        canvas.draw(Shape::line(&at, &end).stroke(INK, 1.0));
        canvas.draw(Shape::circle(&at, 2.5).fill(INK));
        canvas.label(&end, &heading(angle), 0.6 * TO_NAME, &Label::words(name));
    }
    let pin = axis + Vector2::new(-scale, 1.5 * HALF_WIDTH * scale);
    canvas.label(&pin, &Vector2::new(0.0, 1.0), TO_NAME, &Label::words("pin"));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{PIXELS, ParsedDrawing, assert_drawn, assert_sound, corners, depth};

    #[test]
    fn it_is_drawn_in_true_numbers_and_legibly() {
        for stations in 3..=18 {
            let figure = internal_mechanism(&InternalWheel::new(stations).expect("possible"));
            assert_drawn(&figure);
            if (4..=8).contains(&stations) {
                assert_sound(&figure);
            }
        }
    }

    #[test]
    fn it_is_to_scale() {
        for stations in 3..=18 {
            let wheel = InternalWheel::new(stations).expect("possible");
            let figure = internal_mechanism(&wheel);
            let drawing = ParsedDrawing::parse(&figure);
            let (axis, crank) = (drawing.centre("pin-circle"), drawing.number("pin-circle", "r"));
            let centres = axis.x - WIDTH / 2.0;
            assert!((centres - wheel.centre_distance_ratio() * crank).abs() < PIXELS * (1.0 + centres / crank));
            assert!((drawing.centre("pin") - axis + Vector2::new(crank, 0.0)).norm() < PIXELS);
        }
    }

    /// Pin and locking segment keep clear of the wheel over a whole turn, but for the chords of arcs and rounding.
    #[test]
    fn wheel_and_driver_keep_clear_of_each_other_all_the_way_round() {
        const SCALE: f64 = 1000.0;
        let view = View { origin: Vector2::zeros(), scale: SCALE };
        let plane = |data: &str| -> Vec<Vector2<f64>> {
            corners(data, 0.03).iter().map(|at| Vector2::new(at.x, -at.y) / SCALE).collect()
        };
        for stations in [3, 4, 6, 12] {
            let wheel = InternalWheel::new(stations).expect("possible");
            let ring = Ring::new(&wheel);
            let inside = plane(ring.inside(0.0, &view).data());
            let segment = plane(ring.locking_segment(&Vector2::zeros(), PI, SCALE).data());
            for step in -40..=40 {
                let theta = PI * f64::from(step) / 40.0;
                let motion = wheel.motion(0, theta).expect("in the turn");
                let phi = Turn::from_radians(motion.angle + 2.0 * ring.half_pitch * motion.stations as f64);
                let turn = Turn::from_radians(theta);
                let turned = |at: &Vector2<f64>, by: &Turn<f64>| {
                    Vector2::new(by.cos * at.x - by.sin * at.y, by.sin * at.x + by.cos * at.y)
                };
                let on_wheel =
                    |at: &Vector2<f64>| turned(&(turned(at, &turn) + Vector2::new(ring.centre, 0.0)), &phi.reversed());
                let pin = on_wheel(&Vector2::new(1.0, 0.0));
                assert!(depth(&pin, &inside) > PIN, "{stations} stations, θ = {theta}: pin at {pin}");
                for at in segment.iter().map(on_wheel) {
                    assert!(depth(&at, &inside) > -1e-3, "{stations} stations, θ = {theta}: segment at {at}");
                }
            }
        }
    }
}
