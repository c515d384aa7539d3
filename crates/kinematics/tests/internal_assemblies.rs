//! Do assemblies of internal wheels that are said to turn keep clear, and is their share what plays and errors ask for?

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_assemblies::{BuiltInternalWheel, InternalAssemblies};
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::as_built::{ErrorShape, SizeErrors, Yield};
use geneva_kinematics::wheel::{Choices, Play};
use nalgebra::Vector2;
use std::f64::consts::PI;

fn sizes(stations: u32, play: Play) -> InternalSizes {
    let choices = Choices { play: Some(play), pin_diameter: Some(4.5), ..Choices::default() };
    InternalSizes::new(InternalWheel::new(stations).unwrap(), 30.0, &choices).unwrap()
}

fn share(sizes: &InternalSizes, error: f64) -> f64 {
    InternalAssemblies::new(sizes, SizeErrors::from_greatest(error), ErrorShape::Normal, 1).count(0..200).share()
}

#[test]
fn more_play_lets_more_turn_and_larger_errors_and_looser_bores_and_pins_fewer() {
    for stations in [3, 6, 12] {
        let plays = [0.1, 0.2, 0.4, 0.8].map(|play| share(&sizes(stations, Play::from_slot(play)), 0.1));
        assert!(plays.is_sorted() && plays[3] > plays[0] + 0.5, "{stations}: {plays:?}");
        let with = |play: Play| share(&sizes(stations, play), 0.05);
        let all = Play::from_slot(0.4);
        let bores = [0.6, 0.3, 0.0].map(|bore| with(Play { bore, ..all }));
        assert!(bores.is_sorted() && bores[0] < bores[2] - 0.1, "{stations}: {bores:?}");
        let pins = [0.4, 0.2, 0.0].map(|pin| with(Play { pin, ..all }));
        assert!(pins.is_sorted() && pins[0] < pins[2] - 0.1, "{stations}: {pins:?}");
    }
}

#[test]
fn groups_add_up_and_no_errors_leave_all_turning() {
    let sizes = sizes(6, Play::from_slot(0.3));
    let of = |error| InternalAssemblies::new(&sizes, SizeErrors::from_greatest(error), ErrorShape::Uniform, 5);
    let half = of(0.06);
    assert_eq!(half.count(0..90), half.count(40..90).plus(half.count(0..40)));
    assert_eq!(of(0.0).count(0..10), Yield { tried: 10, turning: 10 });
    assert_eq!(of(100.0).count(0..10).turning, 0);
}

type Point = Vector2<f64>;

fn direction(angle: f64) -> Point {
    Point::new(angle.cos(), angle.sin())
}

fn turned(p: Point, angle: f64) -> Point {
    let by = direction(angle);
    Point::new(by.x * p.x - by.y * p.y, by.y * p.x + by.x * p.y)
}

/// An assembly that is tried at many angles of crank and wheel, by points on its driver and the corners of its ring.
struct Tried {
    made: BuiltInternalWheel,
    /// Points on the pin and on the locking segment, from the driver's axis with the pin's right place on the first axis.
    driver: Vec<Point>,
    /// Corners of slots and tips of horns, in the frame of the wheel.
    corners: Vec<Point>,
    /// How far the wheel is turned from one angle that is tried to the next, in radians.
    step: f64,
}

impl Tried {
    /// Crank angles over a turn, and angles of the wheel to either side of its right place.
    const CRANKS: i32 = 64;
    const BESIDE: i32 = 40;

    fn new(made: BuiltInternalWheel) -> Self {
        let sizes = made.sizes;
        let ([outer, inner], half) = (sizes.segment_radii, sizes.segment_half_angle());
        let pin = Point::new(sizes.crank_radius, 0.0);
        let mut driver: Vec<Point> =
            (0..16).map(|k| pin + direction(PI * f64::from(k) / 8.0) * sizes.pin_radius()).collect();
        for k in -12..=12 {
            let along = direction(PI + made.segment_error + half * f64::from(k) / 12.0);
            driver.extend([along * outer, along * inner]);
        }
        let pitch = 2.0 * sizes.wheel.half_pitch_angle();
        let mut corners = Vec::new();
        for (k, slot) in made.slots.iter().enumerate() {
            let at = pitch * k as f64;
            let beside = (slot.width / 2.0 / slot.tip_radius).asin();
            corners.extend([beside, -beside].map(|by| direction(at + slot.direction_error + by) * slot.tip_radius));
            for (arc, side) in [(&made.arcs[k], 1.0), (&made.arcs[(k + made.arcs.len() - 1) % made.arcs.len()], -1.0)] {
                let (c, r) = (arc.centre, slot.tip_radius);
                let seen = ((c * c + r * r - arc.radius * arc.radius) / (2.0 * c * r)).acos();
                corners.push(direction(at + side * (pitch / 2.0 - seen) + arc.direction_error) * r);
            }
        }
        // Half a millimetre to either side, at the rim.
        let step = 0.5 / sizes.mouth_radius / f64::from(Self::BESIDE);
        Self { made, driver, corners, step }
    }

    /// Whether a point in the frame of the wheel is in the hollow of the ring, or this near to it.
    fn is_in_hollow(&self, p: Point, near: f64) -> bool {
        let BuiltInternalWheel { sizes, slots, arcs, .. } = &self.made;
        let (pitch, far) = (2.0 * sizes.wheel.half_pitch_angle(), p.norm());
        let sector = (p.y.atan2(p.x) / pitch).round();
        let number = (sector as i32).rem_euclid(slots.len() as i32) as usize;
        let slot = &slots[number];
        let in_slot = turned(p, -pitch * sector - slot.direction_error);
        let half = slot.width / 2.0 + near;
        let is_in_arc = |number: usize, middle: f64| {
            let arc = &arcs[number % arcs.len()];
            (p - direction(pitch * middle + arc.direction_error) * arc.centre).norm() < arc.radius + near
        };
        far < slot.tip_radius + near
            || in_slot.y.abs() < half && in_slot.x < slot.end
            || (in_slot - Point::new(slot.end, 0.0)).norm() < half
            || is_in_arc(number, sector + 0.5)
            || is_in_arc(number + arcs.len() - 1, sector - 0.5)
    }

    /// Whether nothing overlaps, but for what the wheel moves in half a step.
    fn is_free(&self, crank: f64, wheel: f64) -> bool {
        let sizes = &self.made.sizes;
        let axis = Point::new(self.made.centre_distance, 0.0);
        let near = |p: &Point| p.norm() * self.step / 2.0;
        let is_driver_free = self.driver.iter().all(|p| {
            let p = turned(turned(*p, crank) + axis, -wheel);
            self.is_in_hollow(p, near(&p))
        });
        let ([outer, inner], half) = (sizes.segment_radii, sizes.segment_half_angle());
        is_driver_free
            && self.corners.iter().all(|corner| {
                let near = near(corner);
                let p = turned(turned(*corner, wheel) - axis, -crank);
                let from_end = {
                    let beside = turned(p, PI - self.made.segment_error);
                    half - beside.y.atan2(beside.x).abs()
                };
                let far = p.norm();
                let in_segment = far < outer - near && far > inner + near && far * from_end.sin() > near;
                let in_segment = in_segment && from_end > 0.0;
                !in_segment && (p - Point::new(sizes.crank_radius, 0.0)).norm() > sizes.pin_radius() - near
            })
    }

    /// Whether the wheel gets through a turn of its own, pushed to either side as it may be.
    fn turns(&self) -> bool {
        let sizes = &self.made.sizes;
        let (wheel, pitch) = (&sizes.wheel, 2.0 * sizes.wheel.half_pitch_angle());
        let mut reached: Vec<bool> = vec![true; 2 * Self::BESIDE as usize + 1];
        for index in 0..self.made.slots.len() {
            for k in 0..=Self::CRANKS {
                let crank = PI * (2.0 * f64::from(k) / f64::from(Self::CRANKS) - 1.0);
                let right = if crank.abs() > wheel.engagement_half_angle() {
                    wheel.half_pitch_angle().copysign(crank)
                } else {
                    let pin = direction(crank) * sizes.crank_radius + Point::new(self.made.centre_distance, 0.0);
                    pin.y.atan2(pin.x)
                };
                let is_free = |k: usize| {
                    let by = f64::from(k as i32 - Self::BESIDE);
                    self.is_free(crank, right + pitch * index as f64 + self.step * by)
                };
                // What is free beside what is reached is reached, too; one step is for what the crank moved.
                let mut next = vec![false; reached.len()];
                let last = reached.len() - 1;
                for k in 0..=last {
                    let is_beside = reached[k.saturating_sub(1)] || reached[k] || reached[(k + 1).min(last)];
                    next[k] = (is_beside || k > 0 && next[k - 1]) && is_free(k);
                }
                for k in (1..=last).rev() {
                    next[k - 1] |= next[k] && is_free(k - 1);
                }
                reached = next;
                if !reached.contains(&true) {
                    return false;
                }
            }
        }
        true
    }
}

#[test]
fn what_turns_for_certain_turns_when_it_is_tried_and_is_more_than_half_of_what_turns() {
    let designs = [
        (3, 0.3, 0.1),
        (4, 0.3, 0.1),
        (5, 0.3, 0.15),
        (6, 0.4, 0.2),
        (6, 0.2, 0.08),
        (8, 0.4, 0.15),
        (10, 0.3, 0.1),
        (12, 0.4, 0.15),
    ];
    let (mut certain, mut turning) = (0, 0);
    for (stations, play, error) in designs {
        let sizes = sizes(stations, Play { bore: 0.05, pin: 0.03, ..Play::from_slot(play) });
        let assemblies = InternalAssemblies::new(&sizes, SizeErrors::from_greatest(error), ErrorShape::Normal, 3);
        for number in 0..12 {
            let made = assemblies.assembly(number);
            let is_certain = made.turns_for_certain();
            let turns = Tried::new(made).turns();
            assert!(turns || !is_certain, "{stations} stations, {number}: said to turn for certain, and it jams");
            certain += u32::from(is_certain);
            turning += u32::from(turns);
        }
    }
    // Some jam, or it would not be seen whether they are told from those that turn.
    assert!(turning < 90 && 2 * certain > turning, "{certain} of {turning} that turn");
}

#[test]
fn what_jams_when_it_is_tried_is_found() {
    let sizes = sizes(6, Play::from_slot(0.3));
    let exact = InternalAssemblies::new(&sizes, SizeErrors::from_greatest(0.0), ErrorShape::Normal, 1).assembly(0);
    assert!(Tried::new(exact.clone()).turns() && exact.turns_for_certain());
    let changes: [fn(&mut BuiltInternalWheel); 6] = [
        |made| made.slots[2].width -= 0.4,
        |made| made.slots[4].direction_error += 0.6 / made.sizes.mouth_radius,
        |made| made.slots[1].end -= 0.6,
        |made| made.arcs[3].radius -= 0.4,
        |made| made.arcs[0].centre -= 0.4,
        |made| made.centre_distance += 0.5,
    ];
    for (number, change) in changes.iter().enumerate() {
        let mut made = exact.clone();
        change(&mut made);
        assert!(!made.turns_for_certain(), "change {number}");
        assert!(!Tried::new(made).turns(), "change {number} is not seen");
    }
}
