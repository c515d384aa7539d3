//! The contact of pin and slot by Newton's laws, in vectors: what accelerates the driver at a crank angle, and with what force.
//!
//! The driver's axis is the origin, the follower's lies on the first axis, and the crank radius is the unit of length. The pin may
//! be thick and the journals may rub. On which flank the pin presses is not decided beforehand: the motion is found with either
//! flank, and the right one is the one on which the pin then presses and does not pull.

use super::halve;
use geneva_case1973::{Hypothesis, Row};
use std::f64::consts::PI;

/// Sizes and loads of an escapement; torque and inertias in units that fit each other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactModel {
    /// Centre distance over crank radius.
    pub ratio: f64,
    /// Crank angle from the line of centres at which the pin leaves its slot, in radians.
    pub half: f64,
    /// Turn of the driver after which the next pin takes over, in radians.
    pub reset: f64,
    /// Moments of inertia of driver and follower.
    pub inertias: [f64; 2],
    /// Torque on the driver.
    pub torque: f64,
    /// Coefficient of friction between pin and slot.
    pub friction: f64,
    /// Radius of the pin in crank radii.
    pub pin_radius: f64,
    /// Radius times friction of the journals of driver and follower, in crank radii.
    pub journals: [f64; 2],
}

/// A straight line in the square of the driver's speed: its value at rest and its growth.
type SquareLine = [f64; 2];

/// What the contact does at a crank angle, if the pin presses on the leading flank and if it presses on the trailing one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flanks {
    /// Twice the driver's acceleration, which is the slope of the square of its speed over the angle.
    slopes: [SquareLine; 2],
    /// Normal force times crank radius, positive on the leading flank.
    forces: [SquareLine; 2],
    /// What the torque is divided by: the inertia that the driver feels.
    pub felt: [f64; 2],
}

/// Crank and slot at a crank angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stance {
    /// The pin's centre.
    pub pin: [f64; 2],
    /// The pin's velocity for each radian of the crank.
    pub velocity: [f64; 2],
    /// Distance of the pin from the follower's axis.
    pub radius: f64,
    /// Along the slot, outward.
    pub along: [f64; 2],
    /// Across the slot, in the sense in which the pin drives the follower.
    pub across: [f64; 2],
    /// The follower's speed over the driver's.
    pub ratio: f64,
    /// The follower's acceleration over the square of a constant speed of the driver.
    pub bend: f64,
}

/// The scalar product of two vectors.
pub(crate) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The moment of a force about the origin, counter-clockwise.
pub(crate) fn moment(place: [f64; 2], force: [f64; 2]) -> f64 {
    place[0] * force[1] - place[1] * force[0]
}

/// A vector turned by a right angle, counter-clockwise.
fn quarter_turned([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

/// One vector and so much of another.
pub(crate) fn add_scaled(a: [f64; 2], times: f64, b: [f64; 2]) -> [f64; 2] {
    [a[0] + times * b[0], a[1] + times * b[1]]
}

impl ContactModel {
    /// The escapement of a printed row as the mechanism is.
    pub(crate) fn of_row(row: &Row) -> Self {
        Self::of_run(&Hypothesis::IDEAL, row)
    }

    /// The escapement of a printed row by a hypothesis: its inertias and its reset.
    pub(crate) fn of_run(hypothesis: &Hypothesis, row: &Row) -> Self {
        let opening = PI / f64::from(row.mechanism.slots());
        Self {
            ratio: 1.0 / opening.sin(),
            half: PI / 2.0 - opening,
            reset: hypothesis.angle(row),
            inertias: hypothesis.inertias(row),
            torque: row.torque(),
            friction: row.friction(),
            pin_radius: 0.0,
            journals: [0.0; 2],
        }
    }

    /// Crank and slot at a crank angle from the line of centres, in radians.
    pub(crate) fn stance(&self, angle: f64) -> Stance {
        Stance::new(self.ratio, angle)
    }

    /// Speed with which the pin's surface slides outward on a flank (1 or −1), over the driver's speed.
    fn sliding(&self, angle: f64, flank: f64) -> f64 {
        let Stance { along, across, ratio, pin, .. } = self.stance(angle);
        let touching = add_scaled(pin, flank * self.pin_radius, across);
        let of_slot = quarter_turned([touching[0] - self.ratio, touching[1]]);
        // The slot turns clockwise.
        dot(quarter_turned(touching), along) + ratio * dot(of_slot, along)
    }

    /// The crank angles within the engagement at which the sliding turns, in order: the ends of pieces in which all is smooth.
    pub(crate) fn turns(&self) -> Vec<f64> {
        const PLACES: u32 = 200;
        let end = self.reset - self.half;
        let angle = |k: u32| -self.half + (self.half + end) * f64::from(k) / f64::from(PLACES);
        let mut found = Vec::new();
        for flank in [1.0, -1.0] {
            for k in 0..PLACES {
                let [low, high] = [angle(k), angle(k + 1)];
                let outward = |angle: f64| self.sliding(angle, flank) > 0.0;
                if outward(low) == outward(high) {
                    continue;
                }
                let at_first = outward(low);
                found.push(halve(50, [low, high], |angle| outward(angle) == at_first)[1]);
            }
        }
        found.sort_by(f64::total_cmp);
        found.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        found
    }

    /// The contact at a crank angle, where the pin slides in the sense in which it does at the angle `beside`.
    pub(crate) fn flanks(&self, angle: f64, beside: f64) -> Flanks {
        let stance = self.stance(angle);
        let [driver, follower] = self.inertias;
        let load = (1.0 + self.friction * self.friction).sqrt();
        let mut flanks = Flanks { slopes: [[0.0; 2]; 2], forces: [[0.0; 2]; 2], felt: [0.0; 2] };
        for (at, flank) in [1.0, -1.0].into_iter().enumerate() {
            // On the follower, for each unit of the normal force: across the slot, and with the sliding along it.
            let along = flank * self.friction * self.sliding(beside, flank).signum();
            let force = add_scaled(stance.across, along, stance.along);
            let place = add_scaled(stance.pin, flank * self.pin_radius, stance.across);
            let from_follower = [place[0] - self.ratio, place[1]];
            // Clockwise on the follower and against the driver; a journal brakes with the size of the force.
            let drives = -moment(from_follower, force) - flank * self.journals[1] * load;
            let brakes = moment(place, force) + flank * self.journals[0] * load;
            let lever = brakes / drives;
            let felt = driver + lever * follower * stance.ratio;
            let acceleration = [self.torque / felt, -lever * follower * stance.bend / felt];
            let asked = [stance.ratio * acceleration[0], stance.bend + stance.ratio * acceleration[1]];
            flanks.felt[at] = felt;
            flanks.slopes[at] = acceleration.map(|part| 2.0 * part);
            flanks.forces[at] = asked.map(|part| follower * part / drives);
        }
        flanks
    }
}

impl Stance {
    /// Crank and slot for a centre distance over crank radius, at a crank angle from the line of centres, in radians.
    pub(crate) fn new(distance: f64, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let pin = [cosine, sine];
        let from_follower = [cosine - distance, sine];
        let radius = dot(from_follower, from_follower).sqrt();
        let along = from_follower.map(|part| part / radius);
        let across = [along[1], -along[0]];
        let velocity = quarter_turned(pin);
        let ratio = dot(across, velocity) / radius;
        // Across the slot the pin has the follower's acceleration and Coriolis's.
        let bend = (-dot(across, pin) - 2.0 * dot(along, velocity) * ratio) / radius;
        Self { pin, velocity, radius, along, across, ratio, bend }
    }
}

impl Flanks {
    /// Which flank the pin presses on at a square of the speed: 0 is the leading one.
    fn pressed(&self, square: f64) -> usize {
        usize::from(value_at(self.forces[0], square) < 0.0)
    }

    /// The slope of the square of the speed over the angle.
    pub(crate) fn slope(&self, square: f64) -> f64 {
        let square = square.max(0.0);
        value_at(self.slopes[self.pressed(square)], square)
    }

    /// Normal force times crank radius, positive on the leading flank, in the unit of the torque.
    pub(crate) fn force(&self, square: f64) -> f64 {
        let square = square.max(0.0);
        value_at(self.forces[self.pressed(square)], square)
    }
}

impl Flanks {
    /// Normal force times crank radius if the pin bore on the leading flank: below zero where it does not.
    pub(crate) fn leading_force(&self, square: f64) -> f64 {
        value_at(self.forces[0], square)
    }
}

/// The value of a line.
fn value_at([start, growth]: SquareLine, square: f64) -> f64 {
    start + growth * square
}

/// Crank angles of the engagement at which it is asked whether the motion is determined.
const ANGLES: u32 = 3000;

impl ContactModel {
    /// Whether there is one acceleration at each angle of the engagement: whether the driver feels an inertia above zero on either
    /// flank.
    fn is_determined(&self) -> bool {
        let angle = |k: u32| self.half * f64::from(k) / f64::from(ANGLES);
        (0..=ANGLES).map(angle).all(|angle| [angle, -angle].iter().all(|angle| self.felt(*angle) > 0.0))
    }

    /// The lesser of the inertias that the driver feels on the two flanks.
    fn felt(&self, angle: f64) -> f64 {
        let [leading, trailing] = self.flanks(angle, angle).felt;
        leading.min(trailing)
    }

    /// The least friction with which the motion is not determined.
    pub(crate) fn critical_friction(&self) -> f64 {
        greatest_below(10.0, |friction| Self { friction, ..*self }.is_determined())
    }

    /// The least inertia of the driver over the follower's with which the motion is determined.
    pub(crate) fn critical_inertia_ratio(&self) -> f64 {
        let [_, follower] = self.inertias;
        greatest_below(10.0, |ratio| !Self { inertias: [ratio * follower, follower], ..*self }.is_determined())
    }
}

/// Where a condition that holds from zero on ends, below a number.
fn greatest_below(most: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, most);
    for _ in 0..40 {
        let middle = f64::midpoint(low, high);
        *(if holds(middle) { &mut low } else { &mut high }) = middle;
    }
    f64::midpoint(low, high)
}
