//! Do the closed forms and the search agree with the outlines themselves, looked at point by point?
//!
//! Points on the edges of one part and their distances from the edges of the other, at many crank angles; the wheel's
//! angle from [`Wheel::at`], insides by counting crossings of a ray. Nothing here uses the regions or the search.

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{
    Choices, Crescent, Edge, EntryContact, Face, LockingDisc, Loop, PinEntry, Play, Scale, Sizes, Wheel,
};
use nalgebra::Vector2;
use std::f64::consts::PI;

pub(super) type Point = Vector2<f64>;

/// Spacing of the points on edges, in millimetres, for a centre distance of 100 mm.
const SPACING: f64 = 0.25;

pub(super) fn sized(stations: u32, pins: u32, choices: &Choices) -> Sizes {
    Sizes::new(Wheel::with_pins(stations, pins).unwrap(), Scale::CentreDistance(100.0), choices).unwrap()
}

pub(super) fn from_edge(edge: &Edge, p: &Point) -> f64 {
    match *edge {
        Edge::Line { from, to } => {
            let along = to - from;
            let share = ((p - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (p - from - along * share).norm()
        }
        Edge::Arc { centre, radius, start, sweep } => {
            let from = p - centre;
            let (begin, length) = if sweep < 0.0 { (start + sweep, -sweep) } else { (start, sweep) };
            let ends = (p - edge.start_point()).norm().min((p - edge.end_point()).norm());
            if (from.y.atan2(from.x) - begin).rem_euclid(2.0 * PI) <= length {
                ends.min((from.norm() - radius).abs())
            } else {
                ends
            }
        }
    }
}

pub(super) fn points(edges: &[Edge]) -> Vec<Point> {
    let along = |edge: &Edge| -> Vec<Point> {
        let length = match *edge {
            Edge::Line { from, to } => (to - from).norm(),
            Edge::Arc { radius, sweep, .. } => radius * sweep.abs(),
        };
        let count = (length / SPACING).ceil().max(1.0) as u32;
        let at = |k: u32| {
            let share = f64::from(k) / f64::from(count);
            match *edge {
                Edge::Line { from, to } => from.lerp(&to, share),
                Edge::Arc { centre, radius, start, sweep } => {
                    let angle: f64 = start + sweep * share;
                    centre + Point::new(angle.cos(), angle.sin()) * radius
                }
            }
        };
        (0..=count).map(at).collect()
    };
    edges.iter().flat_map(along).collect()
}

pub(super) fn is_inside(polygon: &[Point], p: &Point) -> bool {
    let (mut is_inside, mut before) = (false, polygon.last());
    for b in polygon {
        if let Some(a) = before
            && (a.y > p.y) != (b.y > p.y)
            && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
        {
            is_inside = !is_inside;
        }
        before = Some(b);
    }
    is_inside
}

/// Least distance of two loops in the places where they lie, negative if points of one lie in the other.
pub(super) fn between(one: &Loop, other: &Loop) -> f64 {
    let mut least = f64::INFINITY;
    for (a, b) in [(one, other), (other, one)] {
        let polygon = b.corners(1e-4).unwrap();
        let middle = polygon.iter().sum::<Point>() / polygon.len() as f64;
        let reach = polygon.iter().map(|corner| (corner - middle).norm()).fold(0.0, f64::max) + 1.0;
        for p in points(&a.edges).iter().filter(|p| (**p - middle).norm() < reach) {
            let distance = b.edges.iter().map(|edge| from_edge(edge, p)).fold(f64::INFINITY, f64::min);
            least = least.min(if is_inside(&polygon, p) { -distance } else { distance });
        }
    }
    least
}

/// The wheel's loop without the slots that are far from the driver.
fn near_driver(wheel: &Loop, sizes: &Sizes) -> Loop {
    let axis = Point::new(sizes.centre_distance, 0.0);
    let near = |edge: &Edge| {
        let reach = sizes.crank_radius + sizes.pin_diameter;
        [edge.start_point(), edge.end_point()].iter().any(|p| (p - axis).norm() < 1.5 * reach)
    };
    Loop { edges: wheel.edges.iter().filter(|edge| near(edge)).copied().collect() }
}

pub(super) fn placed(sizes: &Sizes, theta: f64) -> (Loop, Option<Loop>, Vec<Loop>) {
    let outline = sizes.outline();
    let motion = sizes.wheel.motion(0, theta).unwrap();
    let phi = motion.angle + 2.0 * sizes.wheel.half_pitch_angle() * motion.stations as f64;
    let axis = Point::new(sizes.centre_distance, 0.0);
    let on_driver = |part: &Loop| part.transform(PI - theta, axis);
    let wheel = outline.wheel.outer.transform(phi, Point::zeros());
    (wheel, outline.disc.map(|disc| on_driver(&disc.outer)), outline.pins.iter().map(on_driver).collect())
}

#[track_caller]
pub(super) fn check(sizes: &Sizes, steps: i32) {
    let clearance = sizes.clearance();
    let (mut crescent, mut resting, mut pins) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    for step in -steps..=steps {
        let theta = PI / f64::from(sizes.wheel.pins()) * f64::from(step) / f64::from(steps) * 0.999_999;
        let (wheel, disc, all_pins) = placed(sizes, theta);
        // For insides the whole outline, for distances what is near.
        let whole = wheel.corners(1e-3).unwrap();
        let near = near_driver(&wheel, sizes);
        if let Some(disc) = disc {
            let polygon = disc.corners(1e-4).unwrap();
            let mut least = f64::INFINITY;
            for p in points(&disc.edges) {
                let distance = near.edges.iter().map(|edge| from_edge(edge, &p)).fold(f64::INFINITY, f64::min);
                least = least.min(if distance < 3.0 && is_inside(&whole, &p) { -distance } else { distance });
            }
            for p in points(&near.edges) {
                let distance = disc.edges.iter().map(|edge| from_edge(edge, &p)).fold(f64::INFINITY, f64::min);
                least = least.min(if is_inside(&polygon, &p) { -distance } else { distance });
            }
            let into = if theta.abs() <= sizes.wheel.engagement_half_angle() { &mut crescent } else { &mut resting };
            *into = into.min(least);
        }
        for pin in all_pins {
            pins = pins.min(near.edges.iter().map(|edge| from_edge(edge, &centre(&pin))).fold(f64::INFINITY, f64::min));
        }
    }
    let name = format!("{} stations, {} pins", sizes.wheel.stations(), sizes.wheel.pins());
    let nearest_pin = clearance.pin_outside.map_or(f64::INFINITY, |of| of.distance).min(clearance.pin_in_slot.distance);
    let found = [
        (Some(nearest_pin), pins - sizes.pin_radius()),
        (clearance.crescent.map(|of| of.distance), crescent),
        (clearance.locking_disc.map(|of| of.distance), resting),
    ];
    for (said, seen) in found {
        let Some(said) = said else { continue };
        assert!(seen >= said - clearance.tolerance - 1e-9, "{name}: {seen} seen, {said} said");
        assert!(seen <= said + 0.01, "{name}: {seen} seen, {said} said");
    }
}

fn centre(pin: &Loop) -> Point {
    let Some(Edge::Arc { centre, .. }) = pin.edges.first() else { panic!("a pin is a circle") };
    *centre
}

#[test]
fn the_outlines_are_as_near_as_is_said() {
    for (stations, pins) in [(3, 1), (3, 6), (4, 3), (5, 2), (6, 1), (6, 2), (8, 1), (12, 2), (30, 1)] {
        check(&sized(stations, pins, &Choices::default()), 60);
    }
    let play = Some(Play { slot: 0.4, locking: 1.0, bore: 0.0, pin: 0.0 });
    check(&sized(6, 1, &Choices { play, pin_diameter: Some(14.0), ..Choices::default() }), 60);
    check(
        &sized(4, 1, &Choices { play, pin_diameter: Some(12.0), horn_thickness: Some(3.0), ..Choices::default() }),
        150,
    );
}

/// The sizes with the crescent that is often drawn: of the wheel's radius, about the wheel's axis in mid-index.
fn customary(stations: u32, pin: f64) -> Sizes {
    let choices = Choices { pin_diameter: Some(pin), play: Some(Play::from_slot(0.0)), ..Choices::default() };
    with_customary_cut(sized(stations, 1, &choices))
}

fn with_customary_cut(mut sizes: Sizes) -> Sizes {
    let (c, r, z) = (sizes.centre_distance, sizes.tip_radius, sizes.locking_disc.unwrap().radius);
    let half_angle = ((z * z + c * c - r * r) / (2.0 * c * z)).acos();
    sizes.locking_disc = Some(LockingDisc { radius: z, crescent: Crescent { centre: c, radius: r, half_angle } });
    sizes
}

#[test]
fn the_customary_crescent_bites_as_deep_as_a_tips_path_tells() {
    // Worked out elsewhere, from the path of points of the rim in the driver's plane: a pin of 8 mm, a horn as thick, no
    // play, and a rim that is cut at the pin's centre.
    for (stations, depth) in [(3, 0.2478), (6, 0.5259), (12, 1.1794)] {
        let choices = Choices { pin_diameter: Some(8.0), play: Some(Play::from_slot(0.0)), ..Choices::default() };
        let mut sizes = sized(stations, 1, &choices);
        sizes.tip_radius = sizes.wheel_radius;
        sizes.wheel_radius = (sizes.tip_radius * sizes.tip_radius - 16.0).sqrt();
        let found = with_customary_cut(sizes).clearance().crescent.unwrap();
        approx::assert_relative_eq!(found.distance, -depth, epsilon = 3e-4);
    }
}

#[test]
fn the_customary_crescent_bites() {
    for (stations, pin) in [(3, 8.0), (4, 14.0), (6, 10.0), (8, 11.0), (12, 7.0)] {
        let wrong = customary(stations, pin);
        let found = wrong.clearance().crescent.unwrap();
        let (wheel, disc, _) = placed(&wrong, found.crank_angle);
        let seen = between(&wheel, &disc.unwrap());
        println!("{stations} stations: {found:?}, seen {seen}");
        assert!(found.distance < -0.1 && found.crank_angle > 0.01, "{found:?}");
        approx::assert_relative_eq!(found.distance, seen, max_relative = 1e-3);
        // Nowhere deeper.
        for step in 0..60 {
            let theta = wrong.wheel.engagement_half_angle() * f64::from(step) / 60.0;
            let (wheel, disc, _) = placed(&wrong, theta);
            assert!(between(&wheel, &disc.unwrap()) > found.distance - 0.01);
        }
        // With the cut of ours the same parts without play touch and no more.
        let choices = Choices { pin_diameter: Some(pin), play: Some(Play::from_slot(0.0)), ..Choices::default() };
        let ours = sized(stations, 1, &choices);
        assert!(ours.clearance().closest_approach().distance.abs() < 1e-9, "{:?}", ours.clearance());
    }
}

#[test]
fn a_wrong_centre_distance_takes_the_play() {
    for stations in [3, 4, 6, 12] {
        let sizes = sized(stations, 1, &Choices { bottom_clearance: Some(0.0), ..Choices::default() });
        for error in [-0.3, -0.02, 0.02, 0.3] {
            let clearance = sizes.clearance_at(sizes.centre_distance + error).unwrap();
            let gap = sizes.play.locking / 2.0;
            let locking = clearance.locking_disc.unwrap().distance;
            if error < 0.0 {
                approx::assert_relative_eq!(locking, gap + error, epsilon = 1e-9);
            } else {
                // Farther from the bottom of its arc, and nearly as near as before to the arc's ends.
                assert!(locking > gap && locking < gap + error, "{stations}: {locking}");
            }
            let bottom = sizes.play.slot / 2.0 + error.min(0.0);
            approx::assert_relative_eq!(clearance.pin_in_slot.distance, bottom, epsilon = 1e-9);
            assert_eq!(clearance.closest_approach().distance < 0.0, f64::abs(error) > gap, "{stations}: {clearance:?}");
        }
        assert!(sizes.clearance_at(sizes.crank_radius).is_err() && sizes.clearance_at(f64::NAN).is_err());
    }
}

#[test]
fn the_wheel_turns_loosely_until_it_touches() {
    for stations in [3, 4, 6, 12] {
        let play = Some(Play { slot: 0.2, locking: 0.3, bore: 0.1, pin: 0.0 });
        let sizes = sized(stations, 1, &Choices { play, pin_diameter: Some(7.0), ..Choices::default() });
        let touches = |theta: f64, by: f64| {
            let (wheel, _, pins) = placed(&sizes, theta);
            // What is turned into the other part is seen as soon as points of it are inside.
            between(&wheel.transform(by, Point::zeros()), &pins[0])
        };
        for share in [0.0, 0.5, 0.95] {
            let theta = share * sizes.wheel.engagement_half_angle();
            let loose = sizes.index_backlash(theta).unwrap();
            assert!(touches(theta, 0.9 * loose) > 0.0 && touches(theta, -0.9 * loose) > 0.0);
            approx::assert_relative_eq!(touches(theta, loose), 0.0, epsilon = 1e-3);
        }
        assert!(sizes.index_backlash(3.0).is_err());
    }
}

/// The first contact with the wheel in the middle of its play, found by going along the pin's path in short steps.
pub(super) fn marched(sizes: &Sizes, error: f64) -> Option<(f64, f64)> {
    marched_to_drifted(sizes, error, 0.0)
}

/// The first contact with a wheel that has turned forwards by an angle.
pub(super) fn marched_to_drifted(sizes: &Sizes, error: f64, drift: f64) -> Option<(f64, f64)> {
    let wheel = sizes.outline().wheel.outer.transform(drift - sizes.wheel.half_pitch_angle(), Point::zeros());
    let axis = Point::new(sizes.centre_distance + error, 0.0);
    let wheel = near_driver(&wheel, sizes);
    let entry = sizes.wheel.engagement_half_angle();
    let at = |theta: f64| axis + Point::new(-theta.cos(), theta.sin()) * sizes.crank_radius;
    let gap = |theta: f64| {
        let p = at(theta);
        wheel.edges.iter().map(|edge| from_edge(edge, &p)).fold(f64::INFINITY, f64::min) - sizes.pin_radius()
    };
    let step = 2e-6;
    let mut theta = -entry - 0.5;
    while theta < -entry + 0.5 {
        let here = gap(theta);
        if here < 2.0 * step * sizes.crank_radius {
            // The rate at which the gap closes, over the pin's speed.
            let rate = (here - gap(theta + step)) / (step * sizes.crank_radius);
            if here + gap(theta + step) <= 0.0 || gap(theta + 3.0 * step) < 0.0 {
                return Some((theta, rate));
            }
        }
        theta += step.max(here / sizes.crank_radius / 2.0);
    }
    None
}

#[test]
fn the_pin_comes_in_where_its_path_meets_the_wheel() {
    let mut met = Vec::new();
    for stations in [3, 4, 6, 12] {
        let sizes = sized(stations, 1, &Choices::default());
        // Just so near that the pin touches the other wall as it comes in; a little nearer it meets its corner.
        let other_wall = -(sizes.slot_gap() + 1e-6) / libm::sin(sizes.wheel.half_pitch_angle());
        for error in [-1.0, -0.2, other_wall, 0.0, 0.03, 0.2, 1.0] {
            let PinEntry { contact, crank_angle, closing_speed, velocity_jump, .. } = sizes.entry(error).unwrap();
            let (theta, rate) = marched(&sizes, error).unwrap();
            println!("{stations} stations, {error} mm: {contact:?} {crank_angle} {closing_speed} {velocity_jump}");
            approx::assert_relative_eq!(crank_angle, theta, epsilon = 2e-5);
            approx::assert_relative_eq!(closing_speed, rate, epsilon = 2e-3);
            // What the wheel's point must take on is the pin's own speed across.
            let distance = sizes.crank_radius * closing_speed / velocity_jump.abs();
            assert!(distance <= sizes.tip_radius * (1.0 + 1e-9), "{stations}: {distance}");
            if contact == EntryContact::DrivingWall {
                assert!(velocity_jump > 0.0 && distance > 0.9 * sizes.wheel_radius);
            }
            met.push(contact);
        }
    }
    for contact in [EntryContact::DrivingWall, EntryContact::OtherWall, EntryContact::Mouth] {
        assert!(met.contains(&contact), "{contact:?} is never met");
    }
}

#[test]
fn areas_are_those_of_fine_polygons() {
    let of_polygon = |face: &Face| {
        face.loops().fold((0.0, 0.0), |(area, moment), of| {
            let corners = of.corners(1e-7).unwrap();
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).fold((area, moment), |(area, moment), (a, b)| {
                let cross = a.perp(b);
                (area + cross / 2.0, moment + cross * (a.dot(a) + a.dot(b) + b.dot(b)) / 12.0)
            })
        })
    };
    for (stations, pins) in [(3, 1), (4, 2), (6, 1), (17, 2)] {
        let outline = sized(stations, pins, &Choices::default()).outline();
        for face in [Some(&outline.wheel), outline.disc.as_ref(), Some(&outline.plate)].into_iter().flatten() {
            let (area, moment) = of_polygon(face);
            approx::assert_relative_eq!(face.area(), area, max_relative = 1e-7);
            approx::assert_relative_eq!(face.second_moment(), moment, max_relative = 1e-7);
            let moved = face.transform(0.7, Point::new(3.0, -5.0));
            approx::assert_relative_eq!(moved.area(), face.area(), max_relative = 1e-12);
            // Steiner's theorem, for faces whose centroid is on the axis by symmetry.
            if pins > 1 || stations > 17 {
                let farther = face.second_moment() + face.area() * 34.0;
                approx::assert_relative_eq!(moved.second_moment(), farther, max_relative = 1e-12);
            }
        }
        for face in [&outline.wheel, &outline.plate] {
            for of in face.loops() {
                let next = of.edges.iter().cycle().skip(1);
                for (edge, after) in of.edges.iter().zip(next) {
                    assert!(
                        (edge.end_point() - after.start_point()).norm() < 1e-12 * 200.0,
                        "{stations}: a gap after {edge:?}"
                    );
                }
            }
        }
    }
    let plate = Face { outer: Loop::circle(Point::zeros(), 10.0, false), holes: Vec::new() };
    let steel = 7850.0;
    approx::assert_relative_eq!(
        plate.moment_of_inertia(5.0, steel).unwrap(),
        0.5 * (PI * 0.01 * 0.01 * 0.005 * steel) * 0.01 * 0.01,
        max_relative = 1e-12
    );
    assert!(plate.moment_of_inertia(0.0, steel).is_err() && plate.moment_of_inertia(1.0, f64::NAN).is_err());
}
