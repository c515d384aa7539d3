//! What play, and an error of the centre distance, do to the wheel: how far it turns loosely, and with what blow the pin
//! comes in.

use super::sizes::Sizes;
use crate::KinematicsError;
use nalgebra::Vector2;

type Point = Vector2<f64>;

/// What of the wheel the pin meets first as it comes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryContact {
    /// The wall that it then pushes.
    DrivingWall,
    /// The other wall: the wheel is pushed back, against the locking disc.
    OtherWall,
    /// A corner of the slot's mouth, or the rim beside it.
    Mouth,
}

/// The first contact of a pin that comes to the wheel at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// What it meets.
    pub contact: EntryContact,
    /// Crank angle from the line of centres, in radians.
    pub crank_angle: f64,
    /// Speed with which pin and wheel close in on each other, across their faces, over the pin's speed, dimensionless.
    pub closing_speed: f64,
    /// Angular velocity over the driver's that the wheel must take on at once, dimensionless; negative if backwards, which
    /// the locking disc does not allow.
    pub velocity_jump: f64,
}

impl Sizes {
    /// How far the wheel at rest can turn to either side before its locking arc meets the locking disc, in radians. None
    /// without a disc; zero without locking play.
    ///
    /// The tips of the locking arc meet the disc first.
    pub fn dwell_backlash(&self) -> Option<f64> {
        let disc = self.locking_disc?;
        // The angle at the wheel's axis of the point of the rim that is at the disc's radius from the driver's axis.
        let (c, rim, z) = (self.centre_distance, self.tip_radius, disc.radius);
        let square = (z - (c - rim)) * (z + (c - rim)) / (4.0 * c * rim);
        Some(self.locking_end_angle() - 2.0 * libm::asin(square.max(0.0).sqrt().min(1.0)))
    }

    /// How far the wheel can turn to either side before a wall of the slot meets the pin, at a crank angle of the
    /// engagement in radians; in radians.
    ///
    /// The gap over the pin's distance from the wheel's axis: greatest on the line of centres.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::OutsideEngagement`] beyond the ends, and for what is not finite.
    pub fn index_backlash(&self, crank_angle: f64) -> Result<f64, KinematicsError> {
        self.wheel.engaged(crank_angle)?;
        let (a, c) = (self.crank_radius, self.centre_distance);
        let half = libm::sin(crank_angle / 2.0);
        // r² = (c − a)² + 4 a c sin²(θ/2).
        let r = ((c - a) * (c - a) + 4.0 * a * c * half * half).sqrt();
        Ok(libm::asin((self.slot_gap() / r).min(1.0)))
    }

    /// How a pin comes to the wheel at rest if the axes are farther apart than they should be, in millimetres, or nearer
    /// (below zero). `None` if the pin does not meet a slot, its mouth or the rim beside it.
    ///
    /// In the slot's own frame the pin's centre is at (c' cos α − a sin τ, c' sin α − a cos τ), τ the crank angle from the
    /// nominal entry. Each face is met at an angle τ in closed form; the first counts. Play alone makes a blow: a pin
    /// that is a gap g away from the wall meets it at cos τ = 1 − g/a.
    pub fn entry(&self, centre_error: f64) -> Option<Entry> {
        let (a, rho, gap) = (self.crank_radius, self.pin_radius(), self.slot_gap());
        let (sin, cos) = libm::sincos(self.wheel.half_pitch_angle());
        let centre = self.centre_distance + centre_error;
        if !(centre > a && centre.is_finite()) {
            return None;
        }
        // c' sin α − a, in which nothing cancels.
        let beyond = centre_error * sin;
        let axis = Point::new(centre * cos, a + beyond);
        let pin = |tau: f64| axis - Point::new(libm::sin(tau), libm::cos(tau)) * a;
        let (mouth, half) = (self.wheel_radius, self.slot_width / 2.0);

        let mut met: Vec<(f64, EntryContact, Point)> = Vec::new();
        // Walls: a (1 − cos τ) = ±gap − beyond, as it goes out to one wall or comes in to the other.
        let sine_of_half = |height: f64| (height / (2.0 * a)).sqrt();
        if (0.0..=2.0 * a).contains(&(gap - beyond)) {
            let tau = 2.0 * libm::asin(sine_of_half(gap - beyond));
            met.push((tau, EntryContact::DrivingWall, Point::new(0.0, -1.0)));
        }
        if (0.0..=2.0 * a).contains(&(-gap - beyond)) {
            let tau = -2.0 * libm::asin(sine_of_half(-gap - beyond));
            met.push((tau, EntryContact::OtherWall, Point::new(0.0, 1.0)));
        }
        met.retain(|(tau, ..)| pin(*tau).x <= mouth);
        for corner in [Point::new(mouth, half), Point::new(mouth, -half)] {
            let from = axis - corner;
            let reach = (from.norm_squared() + a * a - rho * rho) / (2.0 * a * from.norm());
            if reach <= 1.0 {
                let tau = libm::atan2(from.x, from.y) - libm::acos(reach);
                let normal = (pin(tau) - corner) / rho;
                if normal.x >= 0.0 {
                    met.push((tau, EntryContact::Mouth, normal));
                }
            }
        }
        let rim = self.tip_radius + rho;
        let sine = (centre * centre + a * a - rim * rim) / (2.0 * a * centre);
        if sine.abs() <= 1.0 {
            let tau = libm::asin(sine) - self.wheel.half_pitch_angle();
            let at = pin(tau);
            let angle = libm::atan2(at.y, at.x).abs();
            if (self.corner_angle()..=self.tip_angle()).contains(&angle) {
                met.push((tau, EntryContact::Mouth, at / rim));
            }
        }
        let (tau, contact, normal) = met.into_iter().min_by(|one, other| one.0.total_cmp(&other.0))?;
        let velocity = Point::new(-libm::cos(tau), libm::sin(tau));
        let closing_speed = -velocity.dot(&normal);
        let touching = pin(tau) - normal * rho;
        Some(Entry {
            contact,
            crank_angle: tau - self.wheel.engagement_half_angle(),
            closing_speed,
            velocity_jump: -a * closing_speed / touching.perp(&normal),
        })
    }
}
