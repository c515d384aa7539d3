//! Do the outlines, turned against each other until they overlap, give the same play in the dwell?
//!
//! Polygons with their corners on the outlines, and insides by counting crossings of a ray. Nothing here uses a formula of
//! the play.

use super::assembly::{Point, is_inside, marched_to_drifted, placed, sized};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, EntryContact, Loop, Play, Sizes};

/// How far the chords of the polygons leave their arcs, in millimetres, for a centre distance of 100 mm.
const CHORD: f64 = 1e-4;

fn turned(points: &[Point], by: f64) -> Vec<Point> {
    let (sin, cos) = by.sin_cos();
    points.iter().map(|p| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y)).collect()
}

fn polygon(of: &Loop) -> Vec<Point> {
    of.corners(CHORD).unwrap()
}

/// Whether a corner of one polygon is in the other.
fn overlap(one: &[Point], other: &[Point]) -> bool {
    let among = |points: &[Point], polygon: &[Point]| {
        let middle = polygon.iter().sum::<Point>() / polygon.len() as f64;
        let reach = polygon.iter().map(|p| (p - middle).norm()).fold(0.0, f64::max);
        points.iter().any(|p| (p - middle).norm() < reach && is_inside(polygon, p))
    };
    among(one, other) || among(other, one)
}

/// The wheel and the parts of the driver at a crank angle.
struct Seen {
    wheel: Vec<Point>,
    driver: Vec<Vec<Point>>,
}

impl Seen {
    fn at(sizes: &Sizes, theta: f64) -> Self {
        let (wheel, disc, pins) = placed(sizes, theta);
        Self { wheel: polygon(&wheel), driver: disc.iter().chain(&pins).map(polygon).collect() }
    }

    /// Whether the wheel, turned by so much, is in the driver.
    fn overlaps(&self, by: f64) -> bool {
        self.driver.iter().any(|part| overlap(&self.wheel, &turned(part, -by)))
    }
}

/// Defaults, several pins, thin pins, much play, and plays that differ.
fn wheels() -> Vec<Sizes> {
    let counts = [(3, 1), (4, 1), (6, 1), (12, 1), (4, 2), (5, 2), (6, 2), (8, 2), (12, 2), (4, 3), (3, 5)];
    let mut all: Vec<_> = counts.map(|(stations, pins)| sized(stations, pins, &Choices::default())).into();
    for (stations, pin, play) in [(6, 4.0, 0.8), (6, 15.0, 6.0), (4, 10.0, 1.0), (8, 9.0, 0.02), (12, 2.0, 0.5)] {
        let choices = Choices { pin_diameter: Some(pin), play: Some(Play::from_slot(play)), ..Choices::default() };
        all.push(sized(stations, 1, &choices));
    }
    let play = Some(Play { slot: 0.5, locking: 0.1, bore: 0.0, pin: 0.0 });
    all.push(sized(6, 2, &Choices { play, ..Choices::default() }));
    let play = Some(Play { slot: 0.1, locking: 0.6, bore: 0.0, pin: 0.0 });
    all.push(sized(5, 1, &Choices { play, ..Choices::default() }));
    all
}

#[test]
fn the_wheel_turns_in_the_dwell_until_it_touches() {
    for sizes in wheels() {
        let (whole, play) = (sizes.dwell_angle().unwrap(), sizes.dwell_play().unwrap());
        // To the middle of the dwell: the other half is its mirror image, and both directions are looked at.
        let half = whole / 2.0;
        for until in [0.01, 0.5 * play.until_entry, 0.99 * play.until_entry, 1.01 * play.until_entry, 0.2, 0.6, half] {
            let until = f64::min(until, half);
            let seen = Seen::at(&sizes, -sizes.wheel.engagement_half_angle() - until);
            for (side, loose) in [1.0, -1.0].into_iter().zip(sizes.dwell_play_at(until).unwrap()) {
                let name = format!(
                    "{} stations, {} pins, pin {}, {:?}, {until} until entry, side {side}: {loose}",
                    sizes.wheel.stations(),
                    sizes.wheel.pins(),
                    sizes.pin_diameter,
                    sizes.play
                );
                for share in [0.0, 0.5, 0.97] {
                    assert!(!seen.overlaps(side * share * loose), "{name} is too much at {share}");
                }
                assert!(seen.overlaps(side * 1.03 * loose), "{name} is too little");
            }
        }
    }
}

#[test]
fn the_greatest_is_greatest_and_the_middle_holds_as_long_as_is_said() {
    for sizes in wheels() {
        let (whole, play) = (sizes.dwell_angle().unwrap(), sizes.dwell_play().unwrap());
        let [forwards, backwards] = sizes.dwell_play_at(whole / 2.0).unwrap();
        assert_eq!([forwards, backwards], [play.middle; 2]);
        let mut most = 0.0_f64;
        for step in 0..=4000 {
            let until = (whole * f64::from(step) / 4000.0).min(whole);
            let both = sizes.dwell_play_at(until).unwrap();
            most = both.into_iter().fold(most, f64::max);
            let from_middle = (until / whole - 0.5).abs();
            let more = both.into_iter().any(|play_here| play_here > play.middle * (1.0 + 1e-9));
            if from_middle < 0.5 * play.held - 1e-9 {
                assert!(!more, "{} {until}", sizes.wheel.stations());
            } else if from_middle > 0.5 * play.held + 1e-3 && from_middle < 0.5 * play.held + 0.02 {
                assert!(more, "{} {until}", sizes.wheel.stations());
            }
        }
        assert!(most <= play.greatest * (1.0 + 1e-9) && most > 0.98 * play.greatest, "{most} {play:?}");
        let [at_greatest, _] = sizes.dwell_play_at(play.until_entry).unwrap();
        approx::assert_relative_eq!(at_greatest, play.greatest, max_relative = 1e-9);
    }
}

#[test]
fn without_play_there_is_none_and_without_a_dwell_nothing_is_told() {
    let tight = sized(6, 1, &Choices { play: Some(Play::from_slot(0.0)), ..Choices::default() });
    let play = tight.dwell_play().unwrap();
    assert!(play.middle.abs() < 1e-12 && play.greatest < 1e-6, "{play:?}");
    let no_dwell = sized(4, 4, &Choices::default());
    assert!(no_dwell.dwell_play().is_none() && no_dwell.knock().is_none());
    let whole = tight.dwell_angle().unwrap();
    assert!([-0.1, whole + 0.1, f64::NAN].into_iter().all(|until| tight.dwell_play_at(until).is_none()));
}

/// A wheel that turns beyond its slot's corner is seen to be out of the pin's way: the pin meets its rim.
#[test]
fn a_wheel_that_can_miss_the_pin_is_found() {
    for sizes in wheels() {
        let play = sizes.dwell_play().unwrap();
        let seen = sizes.drifted_entry(0.0, 0.9999 * play.greatest).unwrap();
        let (theta, _) = marched_to_drifted(&sizes, 0.0, 0.9999 * play.greatest).unwrap();
        let beside = sizes.wheel.half_pitch_angle() - 0.9999 * play.greatest;
        let (c, a) = (sizes.centre_distance, sizes.crank_radius);
        // The direction of the pin from the slot's middle as it first touches.
        let pin = Point::new(c - a * theta.cos(), a * theta.sin());
        let from_slot = pin.y.atan2(pin.x) + beside;
        let misses = from_slot < -(sizes.slot_width / 2.0).atan2(sizes.wheel_radius);
        assert_eq!(misses, play.can_miss, "{} {}: {seen:?}", sizes.wheel.stations(), sizes.pin_diameter);
    }
    assert!(wheels().iter().any(|sizes| sizes.dwell_play().unwrap().can_miss));
}

#[test]
fn the_pin_knocks_where_its_path_meets_the_turned_wheel() {
    let mut met = Vec::new();
    for sizes in wheels() {
        let (play, knock) = (sizes.dwell_play().unwrap(), sizes.knock().unwrap());
        for share in [-0.9, -0.4, 0.3, 0.6, 0.9] {
            let drift = share * if share > 0.5 { play.greatest } else { play.middle };
            let found = sizes.drifted_entry(0.0, drift).unwrap();
            let (theta, rate) = marched_to_drifted(&sizes, 0.0, drift).unwrap();
            approx::assert_relative_eq!(found.crank_angle, theta, epsilon = 2e-5);
            approx::assert_relative_eq!(found.closing_speed, rate, epsilon = 3e-3);
            met.push(found.contact);
        }
        assert_eq!(knock.centred, sizes.entry(0.0).unwrap().closing_speed);
        for step in 0..=1000 {
            let share = f64::from(step) / 1000.0;
            let speed = |drift: f64| sizes.drifted_entry(0.0, drift).unwrap().closing_speed;
            let within = speed(play.middle * (2.0 * share - 1.0));
            assert!(within <= knock.within * (1.0 + 1e-3), "{within} {knock:?}");
            let drifted = speed(play.greatest * share);
            assert!(drifted <= knock.drifted * (1.0 + 1e-3), "{drifted} {knock:?}");
        }
    }
    assert!(met.contains(&EntryContact::Mouth) && met.contains(&EntryContact::DrivingWall));
}
