//! Are driver and wheel anywhere nearer than the search for the least clearance says?

use super::assembly::{Point, from_edge};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, Crescent, Edge, LockingDisc, Scale, Sizes, TOLERANCE, Wheel};
use source::{Search, greatest_speed_ratio};
use std::cell::Cell;
use std::f64::consts::PI;

/// The search, compiled here by itself because the crate keeps it private.
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../../src/wheel/search.rs"]
mod source;

/// Wheels with their own crescents, and with one that is too shallow: there the least distance is somewhere inside
/// the engagement.
fn assemblies() -> Vec<Sizes> {
    let mut all = Vec::new();
    for (stations, pins) in [(3, 1), (3, 6), (4, 2), (5, 3), (6, 1), (7, 2), (12, 1), (60, 2)] {
        let wheel = Wheel::with_pins(stations, pins).expect("possible");
        let sizes = Sizes::new(wheel, Scale::CentreDistance(100.0), &Choices::default()).expect("it fits");
        all.push(sizes);
        if let Some(LockingDisc { radius, crescent }) = sizes.locking_disc {
            // Through the same edges of the disc, about a centre farther away.
            let (centre, half_angle) = (1.5 * crescent.centre, crescent.half_angle);
            let edge = Point::new(libm::cos(half_angle), libm::sin(half_angle)) * radius;
            let crescent = Crescent { centre, radius: (Point::new(centre, 0.0) - edge).norm(), half_angle };
            let mut shallow = sizes;
            shallow.locking_disc = Some(LockingDisc { radius, crescent });
            all.push(shallow);
        }
    }
    all
}

/// Locking disc and wheel by their outlines, each where its own axis is the origin.
struct Parts<'a> {
    sizes: &'a Sizes,
    disc: LockingDisc,
    on_disc: Vec<Edge>,
    /// Of the slots near the driver.
    on_wheel: Vec<Edge>,
}

impl<'a> Parts<'a> {
    fn new(sizes: &'a Sizes) -> Option<Self> {
        let outline = sizes.outline();
        let near = |edge: &Edge| {
            let middle = edge.start_point() + edge.end_point();
            middle.y.atan2(middle.x).abs() < 5.1 * sizes.wheel.half_pitch_angle()
        };
        let on_wheel = outline.wheel.outer.edges.into_iter().filter(near).collect();
        Some(Self { sizes, disc: sizes.locking_disc?, on_disc: outline.disc?.outer.edges, on_wheel })
    }

    fn engaged(&self) -> f64 {
        self.sizes.wheel.engagement_half_angle()
    }

    /// Distance of a point from the disc, negative in it.
    fn disc_distance(&self, p: &Point) -> f64 {
        let distance = self.on_disc.iter().map(|edge| from_edge(edge, p)).fold(f64::INFINITY, f64::min);
        let pins = self.sizes.wheel.pins();
        let is_cut = (0..pins).any(|pin| {
            let angle = 2.0 * PI * f64::from(pin) / f64::from(pins);
            let centre = Point::new(libm::cos(angle), libm::sin(angle)) * self.disc.crescent.centre;
            (p - centre).norm() < self.disc.crescent.radius
        });
        if p.norm() > self.disc.radius || is_cut { distance } else { -distance }
    }

    /// Distance of a point from the wheel, negative in it.
    fn wheel_distance(&self, p: &Point) -> f64 {
        let distance = self.on_wheel.iter().map(|edge| from_edge(edge, p)).fold(f64::INFINITY, f64::min);
        let half_pitch = self.sizes.wheel.half_pitch_angle();
        let angle = p.y.atan2(p.x);
        let angle = (angle - 2.0 * half_pitch * (angle / (2.0 * half_pitch)).round()).abs();
        let folded = Point::new(libm::cos(angle), libm::sin(angle)) * p.norm();
        let past_end = folded - Point::new(self.sizes.slot_end, 0.0);
        let from_slot = if past_end.x < 0.0 { past_end.norm() } else { folded.y };
        let locking = Point::new(libm::cos(half_pitch), libm::sin(half_pitch)) * self.sizes.centre_distance;
        let is_outside = p.norm() > self.sizes.tip_radius
            || from_slot < self.sizes.slot_width / 2.0
            || (folded - locking).norm() < self.sizes.locking_arc_radius;
        if is_outside { distance } else { -distance }
    }

    /// The distance of the two parts at a crank angle: from the ends of edges, and from the points of the wheel's edges
    /// that are nearest to the centres of the disc's arcs or farthest from them.
    fn apart(&self, theta: f64) -> f64 {
        let phi = self.sizes.wheel.engaged(theta).expect("engaged").angle;
        let axis = Point::new(self.sizes.centre_distance, 0.0);
        let turned = |p: Point, angle: f64| {
            let (sin, cos) = libm::sincos(angle);
            Point::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos)
        };
        let to_wheel = |p: &Point| turned(axis + turned(*p, PI - theta), -phi);
        let to_driver = |p: &Point| turned(turned(*p, phi) - axis, theta - PI);
        let ends = |edges: &[Edge]| edges.iter().map(Edge::start_point).collect::<Vec<_>>();
        let of_disc =
            ends(&self.on_disc).iter().map(|p| self.wheel_distance(&to_wheel(p))).fold(f64::INFINITY, f64::min);
        let mut on_wheel = ends(&self.on_wheel);
        on_wheel.extend(self.on_wheel.iter().map(Edge::end_point));
        for arc in &self.on_disc {
            let Edge::Arc { centre, .. } = arc else { continue };
            let centre = to_wheel(centre);
            for edge in &self.on_wheel {
                let feet = match *edge {
                    Edge::Line { from, to } => {
                        let along = to - from;
                        let foot = from + along * ((centre - from).dot(&along) / along.norm_squared());
                        [foot, foot]
                    }
                    Edge::Arc { centre: of, radius, .. } => {
                        let towards = (centre - of).normalize() * radius;
                        [of + towards, of - towards]
                    }
                };
                on_wheel.extend(feet.into_iter().filter(|foot| from_edge(edge, foot) < 1e-9));
            }
        }
        on_wheel.iter().map(|p| self.disc_distance(&to_driver(p))).fold(of_disc, f64::min)
    }
}

#[test]
fn no_crank_angle_is_nearer_than_is_said() {
    let mut inside = 0;
    for sizes in assemblies() {
        let clearance = sizes.clearance();
        let Some((parts, said)) = Parts::new(&sizes).zip(clearance.crescent) else { continue };
        let end = parts.engaged();
        let share = said.crank_angle / end;
        inside += u32::from(share > 0.001 && share < 0.999);
        // Over the engagement, and closer about the least of these angles and about the one that is said.
        let width = end / 4000.0;
        let over = (0..=4000).map(|step| width * f64::from(step));
        let least = |angles: &mut dyn Iterator<Item = f64>| {
            let all = angles.map(|theta| (parts.apart(theta.clamp(0.0, end)), theta));
            all.fold((f64::INFINITY, 0.0), |least, here| if here.0 < least.0 { here } else { least })
        };
        let (seen, at) = least(&mut over.into_iter());
        let close = |about: f64| (-200..=200).map(move |step| about + width * f64::from(step) / 100.0);
        let seen = seen.min(least(&mut close(at)).0).min(least(&mut close(said.crank_angle)).0);
        assert!(seen >= said.distance - clearance.tolerance, "{seen} {said:?}");
        assert!(said.distance >= seen - 1e-3, "{seen} {said:?}");
        // What is said is the distance there.
        approx::assert_abs_diff_eq!(parts.apart(said.crank_angle), said.distance, epsilon = 1e-9);
    }
    assert!(inside >= 4, "{inside} have their least distance inside the engagement");
}

#[test]
fn distances_change_no_faster_than_is_said() {
    for sizes in assemblies() {
        let Some(parts) = Parts::new(&sizes) else { continue };
        let ratio = sizes.wheel.centre_distance_ratio();
        let width = parts.engaged() / 400.0;
        let seen: Vec<f64> =
            (0..=400).map(|step| parts.apart((width * f64::from(step)).min(parts.engaged()))).collect();
        for (step, pair) in (0..400).zip(seen.windows(2)) {
            let (from, to) = (width * f64::from(step), width * f64::from(step + 1));
            let most = parts.disc.radius + greatest_speed_ratio(ratio, from, to) * sizes.tip_radius;
            assert!((pair[0] - pair[1]).abs() <= most * width, "{from}: {pair:?}");
        }
    }
}

#[test]
fn the_speed_ratio_is_the_wheels() {
    for sizes in assemblies() {
        let (engaged, ratio) = (sizes.wheel.engagement_half_angle(), sizes.wheel.centre_distance_ratio());
        for share in [0.0, 0.3, 0.7, 0.99] {
            let (from, to) = (share * engaged, (share + 0.01) * engaged);
            let most = greatest_speed_ratio(ratio, from, to);
            for within in [0.0, 0.4, 1.0] {
                let speed = sizes.wheel.velocity_ratio((from + within * (to - from)).min(engaged)).unwrap();
                assert!(speed.abs() <= most * (1.0 + 1e-9) + 1e-12, "{speed} {most}");
            }
        }
    }
}

#[test]
fn no_dip_is_narrow_enough_to_be_missed() {
    let (tolerance, places) = (100.0 * TOLERANCE, Cell::new(u32::MAX));
    let search = Search { tolerance, enough: f64::INFINITY, places: &places };
    let speed = 80.0;
    for k in 0..500 {
        let (place, depth) = (f64::from(k) * 0.002 + 0.000_3, 0.01);
        let distance = |theta: f64| 1.0 - (depth - speed * f64::abs(theta - place)).max(0.0);
        let found = search.minimize(0.0, 1.0, None, distance, |_, _| speed);
        assert!(found.value <= 1.0 - depth + tolerance, "{place}: {found:?}");
    }
}
