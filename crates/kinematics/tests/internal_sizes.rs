//! Do ring and driver of an internal wheel keep clear of each other over a whole turn?
//!
//! Points on one part and their distances from the edges of the other, at crank angles that come as close as the distances and
//! the speed of the fastest point ask for: between two of them nothing can touch. The wheel's angle is from [`InternalWheel`].

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_sizes::{InternalOutline, InternalSizes};
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::{Choices, Edge, Loop, Play, SizesError};
use nalgebra::Vector2;
use std::f64::consts::PI;

type Point = Vector2<f64>;

fn from_edge(edge: &Edge, p: &Point) -> f64 {
    match *edge {
        Edge::Line { from, to } => {
            let along = to - from;
            let share = ((p - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (p - from - along * share).norm()
        }
        Edge::Arc { centre, radius, start, sweep } => {
            let from = p - centre;
            let (begin, length) = if sweep < 0.0 { (start + sweep, -sweep) } else { (start, sweep) };
            if (from.y.atan2(from.x) - begin).rem_euclid(2.0 * PI) <= length {
                (from.norm() - radius).abs()
            } else {
                (p - edge.start_point()).norm().min((p - edge.end_point()).norm())
            }
        }
    }
}

fn least(of: &Loop, p: &Point) -> f64 {
    of.edges.iter().map(|edge| from_edge(edge, p)).fold(f64::INFINITY, f64::min)
}

fn turned(p: &Point, angle: f64) -> Point {
    let (sine, cosine) = angle.sin_cos();
    Point::new(cosine * p.x - sine * p.y, sine * p.x + cosine * p.y)
}

fn is_inside(polygon: &[Point], p: &Point) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crosses =
        |(a, b): &(&Point, &Point)| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    polygon.iter().zip(next).filter(crosses).count() % 2 == 1
}

/// Ring and driver, and points on the segment's outline.
pub(super) struct Pair {
    sizes: InternalSizes,
    /// Distance of the axes.
    axes: f64,
    outline: InternalOutline,
    hollow: Vec<Point>,
    segment: Vec<Point>,
}

impl Pair {
    pub(super) fn new(sizes: InternalSizes) -> Self {
        Self::apart(sizes, sizes.centre_distance)
    }

    /// The parts as sized, with their axes at another distance.
    pub(super) fn apart(sizes: InternalSizes, axes: f64) -> Self {
        let outline = sizes.outline();
        // Chords leave their arcs by much less than the gaps.
        let hollow = outline.ring.holes[0].corners(1e-3).unwrap();
        // A millimetre apart at most.
        let points = |edge: &Edge| -> Vec<Point> {
            (0..=60)
                .map(|k| {
                    let share = f64::from(k) / 60.0;
                    match *edge {
                        Edge::Line { from, to } => from.lerp(&to, share),
                        Edge::Arc { centre, radius, start, sweep } => {
                            centre + turned(&Point::new(radius, 0.0), start + sweep * share)
                        }
                    }
                })
                .collect()
        };
        let segment = outline.segment.outer.edges.iter().flat_map(points).collect();
        Self { sizes, axes, outline, hollow, segment }
    }

    /// The least distance at a crank angle, below zero where something of the driver is in the ring.
    pub(super) fn distance(&self, theta: f64) -> f64 {
        let wheel = &self.sizes.wheel;
        let motion = wheel.motion(0, theta).unwrap();
        let axis = Point::new(self.axes, 0.0);
        let phi = if self.axes == self.sizes.centre_distance {
            motion.angle + 2.0 * wheel.half_pitch_angle() * motion.stations as f64
        } else if theta > wheel.engagement_half_angle() {
            wheel.half_pitch_angle()
        } else {
            let pin = axis + turned(&Point::new(self.sizes.crank_radius, 0.0), theta);
            pin.y.atan2(pin.x)
        };
        let on_ring = |p: &Point| turned(&(turned(p, theta) + axis), -phi);
        let on_driver = |p: &Point| turned(&(turned(p, phi) - axis), -theta);
        let ring = &self.outline.ring.holes[0];
        let signed = |p: &Point| if is_inside(&self.hollow, p) { least(ring, p) } else { -least(ring, p) };
        let pin = signed(&on_ring(&Point::new(self.sizes.crank_radius, 0.0))) - self.sizes.pin_radius();
        let segment = self.segment.iter().map(|p| signed(&on_ring(p))).fold(f64::INFINITY, f64::min);
        let corners = ring.edges.iter().map(|edge| on_driver(&edge.start_point()));
        let corners = corners.map(|p| least(&self.outline.segment.outer, &p)).fold(f64::INFINITY, f64::min);
        pin.min(segment).min(corners)
    }

    /// The least distance over the crank angles between two; nothing is nearer than half of it in between.
    fn certified(&self, from: f64, to: f64) -> f64 {
        let reach = self.sizes.plate_radius;
        let speed = reach + self.sizes.wheel.peak_velocity() * (self.sizes.centre_distance + reach);
        let middle = f64::midpoint(from, to);
        let distance = self.distance(middle);
        if distance <= 0.0 || distance / 2.0 > speed * (to - from) / 2.0 {
            return distance;
        }
        let first = self.certified(from, middle);
        if first <= 0.0 { first } else { first.min(self.certified(middle, to)) }
    }
}

fn sizes(stations: u32, choices: &Choices) -> Result<InternalSizes, SizesError> {
    InternalSizes::new(InternalWheel::new(stations).unwrap(), 30.0, choices)
}

#[test]
fn ring_and_driver_keep_clear_of_each_other_all_the_way_round() {
    let play = Some(Play::from_slot(0.4));
    for (stations, choices) in [
        (3, Choices { play, ..Choices::default() }),
        (4, Choices { play, pin_diameter: Some(6.0), ..Choices::default() }),
        (5, Choices { play, horn_thickness: Some(6.0), ..Choices::default() }),
        (6, Choices { play, pin_diameter: Some(3.0), ..Choices::default() }),
        (12, Choices { play, pin_diameter: Some(3.0), ..Choices::default() }),
    ] {
        let sizes = sizes(stations, &choices).unwrap_or_else(|error| panic!("{stations}: {error}"));
        let least = Pair::new(sizes).certified(0.0, PI);
        assert!(least > 0.1, "{stations} stations, {choices:?}: {least} mm");
        // The pin in its slot has this gap, and the segment in its arc: nothing has more than the least of them.
        assert!(least < 0.2 + 1e-9, "{stations} stations: {least} mm");
    }
}

#[test]
fn a_segment_that_is_too_thick_for_the_horns_would_be_found() {
    let choices = Choices { play: Some(Play::from_slot(0.4)), ..Choices::default() };
    let mut wrong = sizes(3, &choices).unwrap();
    assert!(wrong.segment_radii[0] - wrong.segment_radii[1] < wrong.horn_thickness, "the horns decide");
    wrong.segment_radii[1] -= 1.0;
    assert!(Pair::new(wrong).certified(0.0, PI) < 0.0);
}

#[test]
fn the_ring_has_the_area_between_its_circles_less_slots_and_arcs() {
    for stations in [3, 4, 6, 12, 24] {
        let sizes = sizes(stations, &Choices::default()).unwrap();
        let outline = sizes.outline();
        for face in [&outline.ring, &outline.segment] {
            for of in face.loops() {
                for (edge, next) in of.edges.iter().zip(of.edges.iter().cycle().skip(1)) {
                    let whole = matches!(edge, Edge::Arc { sweep, .. } if sweep.abs() >= 2.0 * PI);
                    assert!(whole || (edge.end_point() - next.start_point()).norm() < 1e-9, "{edge:?} {next:?}");
                }
            }
        }
        // By many points on rays.
        let hollow = outline.ring.holes[0].corners(1e-3).unwrap();
        let cells = 400;
        let step = 2.0 * sizes.outside_radius / f64::from(cells);
        let at = |k: i32| (f64::from(k) + 0.5) * step - sizes.outside_radius;
        let in_ring = |p: &Point| p.norm() < sizes.outside_radius && !is_inside(&hollow, p);
        let count = (0..cells).flat_map(|i| (0..cells).map(move |j| Point::new(at(i), at(j)))).filter(in_ring).count();
        approx::assert_relative_eq!(count as f64 * step * step, outline.ring.area(), max_relative = 5e-3);
    }
}

#[test]
fn what_does_not_fit_is_said() {
    let thick = sizes(3, &Choices { pin_diameter: Some(12.0), ..Choices::default() }).unwrap_err().to_string();
    assert!(thick.contains("locking arcs miss the wheel") && thick.contains("a thinner pin"), "{thick}");
    let play = sizes(6, &Choices { play: Some(Play::from_slot(-0.1)), ..Choices::default() }).unwrap_err().to_string();
    assert!(play.starts_with("slot play"), "{play}");
    let shaft = sizes(6, &Choices { plate_shaft: Some(60.0), ..Choices::default() });
    assert!(matches!(shaft, Err(SizesError::Shaft { .. })));
    for stations in [3, 4, 5, 6, 8, 12, 18, 24, 60] {
        assert!(sizes(stations, &Choices::default()).is_ok(), "{stations} stations");
    }
}
