//! With what blow a pin comes into its slot, the wheel at rest anywhere within its play.
//!
//! While the pin comes in, its slot stops the wheel at angles that change with the crank angle. A wheel that rests at such an angle is
//! met there and then. Its face and the pin close in on each other with the part of the pin's velocity that is across the face.

use super::contact::BuiltContact;
use super::free_angles::Assembled;
use crate::Turn;
use crate::bisection::bisect_times;
use nalgebra::Vector2;

/// The blow with which a pin comes in, over the pin's speed, dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BuiltBlow {
    /// With the wheel in the middle of the play that it has in the middle of the dwell before, dimensionless.
    pub centred: f64,
    /// The greatest with the wheel at rest anywhere that disc and pins let it be, dimensionless.
    pub greatest: f64,
    /// Crank angle by which the pin turns from where its circle would touch a right slot until it meets a wheel in the middle of
    /// its play, in radians: the lost motion; below zero the pin meets the wheel too early.
    pub lost_motion: f64,
    /// What the pin meets there: a wall, with [`BuiltContact::PinOnFace`] the face of a mouth that is there for that, or with
    /// [`BuiltContact::PinAtMouth`] the corner of a mouth, where it should pass freely.
    pub contact: BuiltContact,
}

/// Crank angles at which the entry is looked at, halvings between two of them, and places at which the wheel rests.
const PLACES: u32 = 200;
const HALVINGS: u32 = 40;
const RESTS: u32 = 64;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// What stops the wheel at a crank angle while a pin comes in, in radians.
struct Instant {
    crank_angle: f64,
    /// Least and greatest angle of the wheel.
    rest: [f64; 2],
    /// Greatest and least angle that the pin leaves.
    pin: [f64; 2],
}

/// How a pin meets the wheel.
struct Meeting {
    /// The speed with which pin and face close in on each other, over the pin's speed.
    speed: f64,
    contact: BuiltContact,
}

impl Assembled<'_> {
    /// Crank angles between which the pin of an event comes in, in radians.
    fn entry_range(&self, event: i64) -> Option<[f64; 2]> {
        let pin = self.built.pins()[self.pin_of(event)];
        let (a, c) = (pin.crank_radius, self.built.centre_distance);
        let [one, other] = self.mouth(self.slot_of(event)).reach(pin.diameter / 2.0);
        let reach = one.max(other);
        let cosine = (a * a + c * c - reach * reach) / (2.0 * a * c);
        (cosine.abs() < 1.0).then(|| [pin.direction_error - libm::acos(cosine), pin.direction_error])
    }

    /// How the pin of an event meets a wheel that it stops backwards (side 1) or forwards (side 0).
    fn meeting(&self, event: i64, theta: f64, side: usize) -> Option<Meeting> {
        let place = self.pin_place(event, theta);
        let (room, contact) = place.rooms[side]?;
        let number = self.slot_of(event);
        let sign = if side == 1 { 1.0 } else { -1.0 };
        let wheel = place.beside - sign * room;
        // In the slot's frame.
        let pin = self.built.pins()[self.pin_of(event)];
        let centre = Turn::from_radians(sign * room).direction() * place.distance;
        let normal = match contact {
            BuiltContact::PinAtMouth | BuiltContact::PinOnFace => self.mouth(number).normal(side, centre),
            BuiltContact::PinAtBottom => {
                let from = Vector2::new(self.built.slots()[number].end, 0.0) - centre;
                from / from.norm()
            }
            _ => Vector2::new(0.0, -sign),
        };
        let (sin, cos) = libm::sincos(theta - pin.direction_error);
        let turned = Turn::from_radians(wheel + self.built.slots()[number].direction_error);
        let velocity = Vector2::new(turned.cos * sin + turned.sin * cos, turned.cos * cos - turned.sin * sin);
        Some(Meeting { speed: (-velocity.dot(&normal)).max(0.0), contact })
    }

    pub(super) fn entry_blow(&self, event: i64) -> Option<BuiltBlow> {
        let [from, to] = self.entry_range(event)?;
        let at = |k: u32| from + (to - from) * f64::from(k) / f64::from(PLACES);
        let instants: Vec<Instant> = (0..=PLACES).map(|k| self.instant(event, at(k))).collect();
        let (late, Meeting { speed: centred, contact }) = self.centred_entry(event, at)?;
        let [(first, least), (last, most)] = [1.0, -1.0].map(|sign| self.farthest_rest(event, from, sign));
        let mut met =
            vec![self.first_meeting(event, least, first, &instants), self.first_meeting(event, most, last, &instants)];
        for k in 1..RESTS {
            let wheel = least + (most - least) * f64::from(k) / f64::from(RESTS);
            let can_be = instants.iter().find(|instant| (instant.rest[0]..=instant.rest[1]).contains(&wheel));
            met.push(can_be.and_then(|since| self.first_meeting(event, wheel, since.crank_angle, &instants)));
        }
        let greatest = met.into_iter().flatten().map(|(_, speed)| speed).fold(centred, f64::max);
        Some(BuiltBlow { centred, greatest, lost_motion: late - self.tangent(), contact })
    }

    /// From when on and where the wheel rests farthest forwards (sign −1) or backwards (sign 1) until the pin would enter a right
    /// slot, in radians.
    fn farthest_rest(&self, event: i64, from: f64, sign: f64) -> (f64, f64) {
        let to = self.tangent();
        let rest = |angle: f64| {
            let [low, high] = self.instant(event, angle).rest;
            if low > high {
                f64::INFINITY
            } else if sign > 0.0 {
                low
            } else {
                -high
            }
        };
        let at = |k: u32| from + (to - from) * f64::from(k.min(PLACES)) / f64::from(PLACES);
        let best = (0..=PLACES).min_by(|one, other| rest(at(*one)).total_cmp(&rest(at(*other)))).unwrap_or(0);
        let (mut low, mut high) = (at(best.saturating_sub(1)), at(best + 1));
        for _ in 0..HALVINGS {
            let inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
            if rest(inner[0]) < rest(inner[1]) { high = inner[1] } else { low = inner[0] }
        }
        let angle = [low, high, at(best)]
            .into_iter()
            .fold(at(best), |one, other| if rest(other) < rest(one) { other } else { one });
        (angle, sign * rest(angle))
    }

    fn instant(&self, event: i64, crank_angle: f64) -> Instant {
        let mut free = self.unstopped(event);
        self.stop_by_disc(event, crank_angle, &mut free);
        let pin = [0, 1].map(|side| self.pin_limit(event, crank_angle, side));
        let rest = [free.backward.angle.max(pin[1]), free.forward.angle.min(pin[0])];
        Instant { crank_angle, rest, pin }
    }

    /// Where the pin alone stops the wheel forwards (side 0) or backwards (side 1).
    fn pin_limit(&self, event: i64, crank_angle: f64, side: usize) -> f64 {
        let place = self.pin_place(event, crank_angle);
        let sign = if side == 0 { 1.0 } else { -1.0 };
        place.rooms[side].map_or(sign * f64::INFINITY, |(room, _)| place.beside + sign * room)
    }

    /// Where the pin first meets a wheel that rests at an angle since a crank angle, and with what speed.
    fn first_meeting(&self, event: i64, wheel: f64, since: f64, instants: &[Instant]) -> Option<(f64, f64)> {
        let is_met = |pin: [f64; 2]| wheel > pin[0] || wheel < pin[1];
        let after = instants.iter().position(|instant| instant.crank_angle > since)?;
        let met = after + instants[after..].iter().position(|instant| is_met(instant.pin))?;
        let before = if met > after { instants[met - 1].crank_angle } else { since };
        let side = usize::from(wheel < instants[met].pin[1]);
        let is_free = |angle: f64| {
            let limit = self.pin_limit(event, angle, side);
            if side == 0 { wheel <= limit } else { wheel >= limit }
        };
        let [_, angle] = bisect_times(HALVINGS, [before, instants[met].crank_angle], is_free);
        self.meeting(event, angle, side).map(|met| (angle, met.speed))
    }

    /// The crank angle at which a pin moves along a right slot of a wheel that rests where it should, in radians.
    fn tangent(&self) -> f64 {
        self.half_pitch - std::f64::consts::FRAC_PI_2
    }

    /// The crank angle at which the pin meets a wheel in the middle of its play, in radians, and how.
    fn centred_entry(&self, event: i64, at: impl Fn(u32) -> f64) -> Option<(f64, Meeting)> {
        let wheel = self.free(event, -self.pin_pitch / 2.0).middle();
        let side = |angle: f64| {
            let pin = [0, 1].map(|side| self.pin_limit(event, angle, side));
            if wheel > pin[0] { Some(0) } else { (wheel < pin[1]).then_some(1) }
        };
        let first = (0..=PLACES).find(|k| side(at(*k)).is_some())?;
        let [_, angle] =
            bisect_times(HALVINGS, [at(first.saturating_sub(1)), at(first)], |angle| side(angle).is_none());
        Some((angle, self.meeting(event, angle, side(angle)?)?))
    }
}
