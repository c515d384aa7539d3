//! The outlines of a wheel and its driver as they were made.

use super::parts::{AsBuiltWheel, BuiltArc, BuiltSlot};
use crate::Turn;
use crate::indexing::Indexing;
use crate::wheel::{Edge, Face, Loop, Outline};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

type Point = Vector2<f64>;

fn round(centre: Point, radius: f64, start: f64, sweep: f64) -> Edge {
    Edge::Arc { centre, radius, start, sweep }
}

/// Half the angle of a locking arc's opening at a rim, seen from the wheel's axis, in radians.
fn opening(arc: &BuiltArc, rim: f64) -> f64 {
    let cosine = (rim * rim + arc.centre * arc.centre - arc.radius * arc.radius) / (2.0 * rim * arc.centre);
    libm::acos(cosine.clamp(-1.0, 1.0))
}

impl AsBuiltWheel {
    /// The outlines, in millimetres, each part about its own axis and without bores: the wheel with slot 0 on the first axis as
    /// drawn, the driver with pin 0 there. The plate is as large as the pins need.
    ///
    /// Where a locking arc leaves no rim beside a slot, the outline crosses itself; such a wheel has no horn to be drawn.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::AsBuiltWheel;
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { wheel_shaft: None, ..Choices::default() };
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?; // mm
    /// let (drawn, built) = (sizes.outline().wheel.outer, AsBuiltWheel::from(&sizes).outline().wheel.outer);
    /// assert_eq!(drawn.edges.len(), built.edges.len());
    /// let apart = |(one, other): (&geneva_kinematics::wheel::Edge, &geneva_kinematics::wheel::Edge)| (one.start_point() - other.start_point()).norm();
    /// assert!(drawn.edges.iter().zip(&built.edges).map(apart).all(|apart| apart < 1e-9)); // mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn outline(&self) -> Outline {
        let disc = self.disc_radius.map(|disc| Face { outer: self.disc_loop(disc), holes: vec![] });
        let reach = self.pins().iter().map(|pin| pin.crank_radius + pin.diameter).fold(0.0, f64::max);
        let pitch = 2.0 * PI / self.pins().len() as f64;
        let pins = self.pins().iter().zip(0..).map(|(pin, k)| {
            let direction = Turn::from_radians(pitch * f64::from(k) + pin.direction_error).direction();
            Loop::circle(direction * pin.crank_radius, pin.diameter / 2.0, false)
        });
        Outline {
            wheel: Face { outer: self.wheel_loop(), holes: vec![] },
            disc,
            plate: Face { outer: Loop::circle(Point::zeros(), reach, false), holes: vec![] },
            pins: pins.collect(),
        }
    }

    fn wheel_loop(&self) -> Loop {
        let (slots, arcs) = (self.slots(), self.arcs());
        let half_pitch = self.wheel().half_pitch_angle();
        let slot_at = |k: usize| 2.0 * half_pitch * k as f64 + slots[k % slots.len()].direction_error;
        let mut edges = Vec::new();
        for (k, (slot, arc)) in slots.iter().zip(arcs).enumerate() {
            let (direction, next) = (slot_at(k), &slots[(k + 1) % slots.len()]);
            edges.extend(slot_edges(slot).map(|edge| edge.transform(direction, Point::zeros())));
            let middle = half_pitch * (2 * k + 1) as f64 + arc.direction_error;
            let corner = |slot: &BuiltSlot| libm::asin((slot.width / (2.0 * slot.tip_radius)).min(1.0));
            let ends = [middle - opening(arc, slot.tip_radius), middle + opening(arc, next.tip_radius)];
            let rim = |radius, from, to| round(Point::zeros(), radius, from, to - from);
            edges.push(rim(slot.tip_radius, direction + corner(slot), ends[0]));
            let centre = Turn::from_radians(middle).direction() * arc.centre;
            let seen = [(ends[0], slot.tip_radius), (ends[1], next.tip_radius)].map(|(angle, radius)| {
                let from = Turn::from_radians(angle - middle).direction() * radius - Point::new(arc.centre, 0.0);
                // From the direction to the wheel's axis.
                libm::atan2(-from.y, -from.x)
            });
            edges.push(round(centre, arc.radius, middle + PI + seen[0], seen[1] - seen[0]));
            // The last slot's neighbour is the first, a turn on.
            let next_at = 2.0 * half_pitch * (k + 1) as f64 + next.direction_error;
            edges.push(rim(next.tip_radius, ends[1], next_at - corner(next)));
        }
        Loop { edges }
    }

    fn disc_loop(&self, disc: f64) -> Loop {
        let pitch = 2.0 * PI / self.pins().len() as f64;
        let cuts: Vec<(f64, f64, f64, f64)> = self
            .pins()
            .iter()
            .zip(0..)
            .map(|(pin, k)| {
                let cut = pin.crescent;
                let cosine =
                    (disc * disc + cut.centre * cut.centre - cut.radius * cut.radius) / (2.0 * disc * cut.centre);
                let half = libm::acos(cosine.clamp(-1.0, 1.0));
                (pitch * f64::from(k) + cut.direction_error, half, cut.centre, cut.radius)
            })
            .collect();
        let mut edges = Vec::new();
        for (k, (direction, half, q, radius)) in cuts.iter().enumerate() {
            let seen = libm::atan2(disc * libm::sin(*half), q - disc * libm::cos(*half));
            let centre = Turn::from_radians(*direction).direction() * *q;
            edges.push(round(centre, *radius, direction + PI + seen, -2.0 * seen));
            let (next, next_half, ..) = cuts[(k + 1) % cuts.len()];
            let next = if k + 1 == cuts.len() { next + 2.0 * PI } else { next };
            edges.push(round(Point::zeros(), disc, direction + half, next - next_half - direction - half));
        }
        Loop { edges }
    }
}

/// Walls and end of a slot whose middle is the first axis.
fn slot_edges(slot: &BuiltSlot) -> [Edge; 3] {
    let half = slot.width / 2.0;
    let mouth = (slot.tip_radius * slot.tip_radius - half * half).max(0.0).sqrt();
    let line = |from: [f64; 2], to: [f64; 2]| Edge::Line { from: from.into(), to: to.into() };
    [
        line([mouth, -half], [slot.end, -half]),
        round(Point::new(slot.end, 0.0), half, -FRAC_PI_2, -PI),
        line([slot.end, half], [mouth, half]),
    ]
}
