//! The designer's wheel as it turns: with its play, with sizes that are wrong, and with both drawn larger than they are.
//!
//! The wheel stands between the two ends of its free angles. Its drawn angle is that of a wheel without play, and from there
//! as many times its own distance as play and errors are drawn larger. The gaps of pin and locking disc are drawn larger by
//! as much, so parts that touch also touch in the drawing.

use crate::answer::LiveNumber;
use crate::control::{Control, Settings};
use crate::turned::TurnedParts;
use geneva_kinematics::Turn;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Sizes;
use geneva_kinematics::wheel::as_built::{AngleLimit, AsBuiltWheel, BuiltContact, FreeAngles};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// The fold of what turns the wheel.
const TURN: &str = "Watch it turn";

/// Crank, hand and magnifying glass.
pub(crate) const TURNING: [Control; 3] = [
    Control::slider("crank", "crank angle θ", "°", [-180.0, 180.0], 0.5, 0.0).playing(45.0).in_fold(TURN),
    Control::slider("turned", "wheel turned by hand within its play", "%", [-100.0, 100.0], 1.0, 0.0).in_fold(TURN),
    Control::slider("larger", "draw play and errors larger", "times", [1.0, 50.0], 1.0, 1.0).in_fold(TURN),
];

/// What can be typed for an error, in millimetres.
const TYPED: [f64; 2] = [-100.0, 100.0];

const fn length(name: &'static str, label: &'static str) -> Control {
    Control::slider(name, label, "mm", [-0.5, 0.5], 0.005, 0.0).with_typed_range(TYPED)
}

/// An error of each size but the centre distance, which the command has too.
pub(crate) const ERRORS: [Control; 7] = [
    length("crank-radius-error", "crank too long by"),
    length("pin-diameter-error", "pins too thick by"),
    length("slot-width-error", "slots too wide by"),
    Control::slider("slot-direction-error", "slots turned out of place by", "°", [-2.0, 2.0], 0.01, 0.0)
        .with_typed_range([-60.0, 60.0]),
    length("slot-end-error", "slots end too far out by"),
    length("locking-arc-error", "locking arcs, radius too large by"),
    length("locking-disc-error", "locking disc, radius too large by"),
];

/// How wrong each size is, in millimetres and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WrongSizes {
    pub centre_distance: f64,
    pub crank_radius: f64,
    pub pin_diameter: f64,
    pub slot_width: f64,
    pub slot_direction: f64,
    pub slot_end: f64,
    pub locking_arc: f64,
    pub locking_disc: f64,
}

impl WrongSizes {
    pub(crate) fn read(settings: &Settings) -> Result<Self, String> {
        Ok(Self {
            centre_distance: settings.value("centre-error")?,
            crank_radius: settings.value("crank-radius-error")?,
            pin_diameter: settings.value("pin-diameter-error")?,
            slot_width: settings.value("slot-width-error")?,
            slot_direction: settings.value("slot-direction-error")?.to_radians(),
            slot_end: settings.value("slot-end-error")?,
            locking_arc: settings.value("locking-arc-error")?,
            locking_disc: settings.value("locking-disc-error")?,
        })
    }

    /// Whether all sizes are right.
    fn are_none(&self) -> bool {
        let Self { centre_distance, crank_radius, pin_diameter, slot_width, slot_direction, slot_end, .. } = self;
        let all = [centre_distance, crank_radius, pin_diameter, slot_width, slot_direction, slot_end];
        all.into_iter().chain([&self.locking_arc, &self.locking_disc]).all(|error| *error == 0.0)
    }

    /// The wheel that is made so: all slots, arcs and pins are wrong by as much.
    fn build(&self, sizes: &Sizes) -> AsBuiltWheel {
        let mut built = AsBuiltWheel::from(sizes);
        built.centre_distance += self.centre_distance;
        built.disc_radius = built.disc_radius.map(|radius| radius + self.locking_disc);
        for slot in built.slots_mut() {
            slot.width += self.slot_width;
            slot.end += self.slot_end;
            slot.direction_error += self.slot_direction;
        }
        built.arcs_mut().iter_mut().for_each(|arc| arc.radius += self.locking_arc);
        for pin in built.pins_mut() {
            pin.crank_radius += self.crank_radius;
            pin.diameter += self.pin_diameter;
        }
        built
    }
}

/// The wheel of the designer with its errors, at a crank angle.
pub(crate) struct WatchedWheel<'a> {
    sizes: &'a Sizes,
    errors: WrongSizes,
    built: AsBuiltWheel,
    /// How many times as large as they are play and errors are drawn.
    larger: f64,
    crank: f64,
    /// Where the wheel is among its free angles, from −1 to 1.
    turned: f64,
}

impl<'a> WatchedWheel<'a> {
    pub(crate) fn new(settings: &Settings, sizes: &'a Sizes) -> Result<Self, String> {
        let errors = WrongSizes::read(settings)?;
        let built = errors.build(sizes);
        built.check().map_err(|_| {
            "errors as large as these leave no wheel: give errors from −0.5 to 0.5 mm, and a direction within 1° of its place"
                .to_owned()
        })?;
        let asked = settings.value("larger")?;
        let (crank, turned) = (settings.value("crank")?.to_radians(), settings.value("turned")? / 100.0);
        let mut watched = Self { sizes, errors, built, larger: 1.0, crank, turned };
        watched.larger = asked.min(watched.most_larger()).max(1.0);
        Ok(watched)
    }

    /// The gap on each side of a pin and on the disc's rim as they are made, in millimetres; below zero they overlap.
    fn gaps(&self) -> [f64; 2] {
        let slot = self.sizes.slot_gap() + (self.errors.slot_width - self.errors.pin_diameter) / 2.0;
        let disc = self.sizes.locking_disc.map_or(0.0, |disc| self.sizes.locking_arc_radius - disc.radius);
        [slot, disc + self.errors.locking_arc - self.errors.locking_disc]
    }

    /// Up to how many times as large they can be drawn: parts stay parts.
    fn most_larger(&self) -> f64 {
        let half = self.sizes.slot_width / 2.0;
        let [slot, disc] = self.gaps();
        let e = &self.errors;
        let room = 0.2 * self.sizes.crank_radius;
        [
            (slot, 0.6 * half),
            (disc, 0.3 * self.sizes.locking_disc.map_or(half, |disc| disc.radius)),
            (e.centre_distance, room),
            (e.crank_radius, room),
            (e.slot_end, 0.5 * (self.sizes.wheel_radius - self.sizes.slot_end)),
            (e.slot_direction, 0.3 * self.sizes.wheel.half_pitch_angle()),
        ]
        .into_iter()
        .map(|(size, most)| if size == 0.0 { f64::INFINITY } else { most / size.abs() })
        .fold(f64::INFINITY, f64::min)
    }

    /// Whether nothing is to be seen that the drawing doesn't show.
    fn is_as_drawn(&self) -> bool {
        self.errors.are_none() && self.larger == 1.0 && self.crank == 0.0 && self.turned == 0.0
    }

    /// Sizes of the wheel whose outline is drawn, and by how much its slots are turned, in radians.
    pub(crate) fn drawn(&self) -> (Sizes, f64) {
        let mut sizes = *self.sizes;
        sizes.slot_end += self.larger * self.errors.slot_end;
        (sizes, self.larger * self.errors.slot_direction)
    }

    /// The crank angle from the nearest line of centres in radians, and by how many pins it is past the first.
    fn event(&self) -> (f64, f64) {
        let pitch = 2.0 * PI / f64::from(self.sizes.wheel.pins());
        let pins = (self.crank / pitch).round();
        (self.crank - pins * pitch, pins)
    }

    fn free(&self, crank: f64) -> Result<FreeAngles, String> {
        self.built.free_angles(0, crank).map_err(|error| error.to_string())
    }

    /// Angle of a wheel without play whose sizes are right, in radians.
    fn right_angle(&self, crank: f64) -> f64 {
        let wheel = &self.sizes.wheel;
        if crank.abs() >= wheel.engagement_half_angle() {
            return wheel.half_pitch_angle() * crank.signum();
        }
        let pin = Turn::from_radians(crank);
        libm::atan2(self.sizes.crank_radius * pin.sin, self.sizes.centre_distance - self.sizes.crank_radius * pin.cos)
    }

    /// The parts as they stand at the crank angle.
    pub(crate) fn parts(&self) -> Result<TurnedParts, String> {
        let (crank, pins) = self.event();
        let free = self.free(crank)?;
        let right = self.right_angle(crank);
        let is_free = |limit: &AngleLimit| limit.contact == BuiltContact::Nothing;
        let (middle, half) = if is_free(&free.forward) || is_free(&free.backward) {
            (right, 0.0)
        } else {
            (free.middle(), free.width().max(0.0) / 2.0)
        };
        let most = 0.9 * self.sizes.wheel.half_pitch_angle();
        let enlarged = |angle: f64| right + (self.larger * (angle - right)).clamp(-most, most);
        let drawn = enlarged(middle + self.turned * half);
        let [slot, disc] = self.gaps();
        let pin = self.sizes.slot_width / 2.0 - self.larger * slot;
        let disc_scale =
            self.sizes.locking_disc.map_or(1.0, |of| (self.sizes.locking_arc_radius - self.larger * disc) / of.radius);
        let jams = free.width() < 0.0;
        let mut touching = Vec::new();
        if jams || (half > 0.0 && self.turned >= 1.0) {
            touching.push((&free.forward, 1.0));
        }
        if jams || (half > 0.0 && self.turned <= -1.0) {
            touching.push((&free.backward, -1.0));
        }
        let contacts = touching.iter().filter_map(|(limit, side)| self.contact(limit, *side, crank, drawn, pin));
        let redraws = self.errors.slot_direction != 0.0 || self.errors.slot_end != 0.0;
        let parts = TurnedParts {
            driver: self.crank.to_degrees(),
            wheel: (drawn + 2.0 * pins * self.sizes.wheel.half_pitch_angle()).to_degrees(),
            centre_distance: self.sizes.centre_distance,
            apart: self.larger * self.errors.centre_distance,
            pin_scale: pin / self.sizes.pin_radius(),
            pins_out: self.larger * self.errors.crank_radius,
            disc_scale,
            half_free: (self.larger * half).to_degrees(),
            contacts: contacts.map(|at| [at.x, at.y]).collect(),
            words: self.words(&free, right, &touching),
            jams,
            moved_by: if redraws { vec!["crank", "turned"] } else { vec!["crank", "turned", "larger"] },
        };
        let numbers = [parts.wheel, parts.driver, parts.pin_scale, parts.disc_scale, parts.apart, parts.pins_out];
        if numbers.into_iter().all(f64::is_finite) {
            Ok(parts)
        } else {
            Err("these numbers are too large or too small to compute with: give others".to_owned())
        }
    }

    /// The place of a contact in the drawing, in millimetres from the wheel's axis.
    fn contact(&self, limit: &AngleLimit, side: f64, crank: f64, wheel: f64, pin: f64) -> Option<Vector2<f64>> {
        let at = |radius: f64, angle: f64| Turn::from_radians(angle).direction() * radius;
        let sizes = self.sizes;
        let slot = wheel + self.larger * self.errors.slot_direction;
        let axis = Vector2::new(sizes.centre_distance + self.larger * self.errors.centre_distance, 0.0);
        let pin_centre = axis + at(sizes.crank_radius + self.larger * self.errors.crank_radius, PI - crank);
        match limit.contact {
            BuiltContact::PinOnWall => Some(pin_centre - at(pin, slot + side * PI / 2.0)),
            BuiltContact::PinAtMouth | BuiltContact::PinOnFace => {
                let half = libm::asin((sizes.slot_width / 2.0 / sizes.tip_radius).min(1.0));
                Some(at(sizes.tip_radius, slot - side * half))
            }
            BuiltContact::PinAtBottom => Some(at(self.drawn().0.slot_end - sizes.slot_width / 2.0, slot)),
            BuiltContact::DiscInArc | BuiltContact::OpeningEdge | BuiltContact::Crescent => {
                // Where the disc's rim is as far from the wheel's axis; forwards it stops the horn on the right of the wheel's way.
                let disc = sizes.locking_disc?.radius;
                let c = sizes.centre_distance;
                let cosine = (c * c + limit.radius * limit.radius - disc * disc) / (2.0 * c * limit.radius);
                Some(at(limit.radius, -side * libm::acos(cosine.clamp(-1.0, 1.0))))
            }
            BuiltContact::Nothing => None,
        }
    }

    /// What is to be seen.
    fn words(&self, free: &FreeAngles, right: f64, touching: &[(&AngleLimit, f64)]) -> String {
        if self.is_as_drawn() {
            return String::new();
        }
        let mut words = if self.larger > 1.0 {
            format!("Play and errors are drawn {} times as large as they are. ", (10.0 * self.larger).round() / 10.0)
        } else {
            String::new()
        };
        let degrees = |angle: f64| LiveNumber::significant("", angle.to_degrees(), 3, "°").text;
        let side = |side: f64| if side > 0.0 { "forwards" } else { "backwards" };
        if free.width() < 0.0 {
            let overlap = LiveNumber::significant("", -free.room(), 2, "mm").text;
            words += &format!(
                "It jams here: forwards {}, backwards {}. They would have to overlap by {overlap}.",
                named(free.forward.contact),
                named(free.backward.contact)
            );
            return words;
        }
        words += &format!(
            "Here the wheel is free from {} to {}.",
            degrees(free.backward.angle - right),
            degrees(free.forward.angle - right)
        );
        for (limit, at) in touching {
            words += &format!(" It is stopped {} by {}.", side(*at), named(limit.contact));
        }
        words
    }

    /// What errors do over a whole turn: whether the wheel turns, or where it jams first. Nothing to say without errors.
    pub(crate) fn verdict(&self) -> Result<Option<String>, String> {
        if self.errors.are_none() {
            return Ok(None);
        }
        // All slots, arcs and pins are alike.
        let (tightest, can_miss) = self.built.tightest_place(0).map_err(|error| error.to_string())?;
        Ok(Some(match Some(tightest).filter(|place| place.free.width() < 0.0) {
            Some(jam) => format!(
                "With these errors the wheel jams, worst at a crank angle of {}: forwards {}, backwards {}.",
                LiveNumber::new("", jam.crank_angle.to_degrees(), 1, "°").text,
                named(jam.free.forward.contact),
                named(jam.free.backward.contact)
            ),
            None if can_miss => {
                "With these errors the wheel turns, but within its play a pin can meet its rim instead of a slot."
                    .to_owned()
            }
            None => "With these errors the wheel still turns.".to_owned(),
        }))
    }
}

/// What stops the wheel, in words.
fn named(contact: BuiltContact) -> &'static str {
    match contact {
        BuiltContact::PinOnWall => "the pin on the wall of its slot",
        BuiltContact::PinAtMouth => "the pin at a corner of its slot",
        BuiltContact::PinOnFace => "the pin on the mouth of its slot",
        BuiltContact::PinAtBottom => "the pin at the bottom of its slot",
        BuiltContact::DiscInArc => "the locking disc in its arc",
        BuiltContact::OpeningEdge => "an edge of the disc's opening in an arc",
        BuiltContact::Crescent => "a horn in the opening of the disc",
        BuiltContact::Nothing => "nothing",
    }
}
