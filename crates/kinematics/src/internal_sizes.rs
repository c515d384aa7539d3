//! Sizes of an internal wheel and its driver in millimetres, and their outlines.
//!
//! Notation: `a` crank radius, `c` centre distance, `R` wheel radius to the pin's centre at entry, ρ the pin's radius, `h` half
//! the width of a slot, α half the angle between slots.
//!
//! The ring has slots that open inwards and between each two of them a hollow arc about the driver's axis in a dwell. The driver's
//! pin reaches into the slots from its plate, and on the side away from the pin a locking segment fills an arc over the whole
//! dwell. The driver's axis lies within the ring, so its shaft ends in the plate.
//!
//! How thick the segment may be follows from the motion: while the wheel turns, the horns between slots and arcs come near to the
//! driver's axis, and pass between it and the segment.

use crate::error::{KinematicsError, length};
use crate::indexing::Indexing;
use crate::internal_wheel::InternalWheel;
use crate::wheel::{Choices, Edge, Face, Loop, Play, Remedy, ShaftOf, SizesError, THIN};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Diameter of a pin over the crank radius where it is not chosen: our choice, thin enough for three stations.
const OF_CRANK_RADIUS: f64 = 0.15;
/// The clearance at a slot's bottom over the pin's diameter, as of the external wheel.
const OF_BOTTOM: f64 = 0.05;
/// Crank angles over half of an index at which the horns are looked at, and what that leaves open, over the centre distance.
const ANGLES: u32 = 2000;
const LEFT_OPEN: f64 = 1e-5;
/// Beyond the segment's ends, in radians, within which a horn counts as beside it.
const BESIDE: f64 = 0.05;

/// Sizes of an internal wheel and its driver, in millimetres.
///
/// ```
/// use geneva_kinematics::internal_sizes::InternalSizes;
/// use geneva_kinematics::internal_wheel::InternalWheel;
/// use geneva_kinematics::wheel::{Choices, Play};
///
/// let choices = Choices { pin_diameter: Some(8.0), play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
/// let sizes = InternalSizes::new(InternalWheel::new(6)?, 50.0, &choices)?;
/// assert!((sizes.centre_distance - 100.0).abs() < 1e-12); // mm: 50 / sin 30°
/// // Of the crank a half slot and a horn as thick as the pin are left for the locking arc.
/// assert!((sizes.locking_arc_radius - (50.0 - 4.1 - 8.0)).abs() < 1e-12); // mm
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct InternalSizes {
    /// The number of stations.
    pub wheel: InternalWheel,
    /// Distance of the pin's centre from the driver's axis, in millimetres.
    pub crank_radius: f64,
    /// Distance between the axes, in millimetres: a / sin α.
    pub centre_distance: f64,
    /// Distance of the pin's centre from the wheel's axis as it enters, in millimetres: c cos α.
    pub wheel_radius: f64,
    /// Inner radius of the ring, in millimetres: the corners of a slot stand at R along it, h beside its middle.
    pub mouth_radius: f64,
    /// Outer radius of the ring, in millimetres.
    pub outside_radius: f64,
    /// Diameter of the pin, in millimetres.
    pub pin_diameter: f64,
    /// The plays.
    pub play: Play,
    /// Width of a slot, in millimetres.
    pub slot_width: f64,
    /// Distance of the centre of a slot's round end from the wheel's axis, in millimetres: c + a and a clearance.
    pub slot_end: f64,
    /// Thickness of the ring between a slot and a locking arc, in millimetres.
    pub horn_thickness: f64,
    /// Radius of the locking arcs, in millimetres.
    pub locking_arc_radius: f64,
    /// Outer and inner radius of the locking segment about the driver's axis, in millimetres.
    pub segment_radii: [f64; 2],
    /// Radius of the driver's round plate, in millimetres.
    pub plate_radius: f64,
    /// Diameter of the driver's shaft in its plate, in millimetres; zero without one.
    pub plate_shaft: f64,
    /// Diameter of the wheel's shaft in the plate that closes the ring, in millimetres; zero without one.
    pub wheel_shaft: f64,
}

impl InternalSizes {
    /// The sizes of a wheel from its crank radius in millimetres and the designer's choices. A driver's shaft in the plane of the
    /// wheel is none, and the mouths of the slots are sharp.
    ///
    /// # Errors
    ///
    /// As of [`Sizes::new`](crate::wheel::Sizes::new).
    pub fn new(wheel: InternalWheel, crank_radius: f64, choices: &Choices) -> Result<Self, SizesError> {
        let (ratio, radius) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
        let a = length("crank radius", crank_radius)?;
        let (c, wheel_radius) = (length("centre distance", a * ratio)?, length("wheel radius", a * radius)?);
        let pin_diameter = length("pin diameter", choices.pin_diameter.unwrap_or(OF_CRANK_RADIUS * a))?;
        let play = choices.play.unwrap_or_else(|| Play::from_slot((c / 1000.0).min(pin_diameter / 20.0)));
        let bottom = choices.bottom_clearance.unwrap_or(OF_BOTTOM * pin_diameter);
        for (name, asked) in [
            ("slot play", play.slot),
            ("locking play", play.locking),
            ("bore play", play.bore),
            ("play of a pin", play.pin),
            ("clearance at the slot's bottom", bottom),
        ] {
            if !(asked >= 0.0 && asked.is_finite()) {
                return Err(SizesError::Play { name, asked });
            }
        }
        let slot_width = pin_diameter + play.slot;
        let half = slot_width / 2.0;
        let of_arc = choices.locking_arc_radius.map(|radius| a - half - radius);
        let horn = of_arc.or(choices.horn_thickness).unwrap_or(pin_diameter);
        let horn_thickness = length("horn thickness", horn)?;
        let mouth_radius = libm::hypot(wheel_radius, half);
        let locking_arc_radius = a - half - horn_thickness;
        let fits = |room: f64, what, remedies| {
            if room > 0.0 { Ok(()) } else { Err(SizesError::DoesNotFit { what, by: -room, remedies }) }
        };
        let thinner = &[Remedy::ThinnerPin, Remedy::ThinnerHorn];
        fits(locking_arc_radius + mouth_radius - c, "the locking arcs miss the wheel", thinner)?;
        let slot_end = c + a + bottom;
        let mut sizes = Self {
            wheel,
            crank_radius: a,
            centre_distance: c,
            wheel_radius,
            mouth_radius,
            outside_radius: slot_end + half + pin_diameter,
            pin_diameter,
            play,
            slot_width,
            slot_end,
            horn_thickness,
            locking_arc_radius,
            segment_radii: [0.0; 2],
            plate_radius: a + pin_diameter,
            plate_shaft: 0.0,
            wheel_shaft: 0.0,
        };
        let outer = locking_arc_radius - play.locking / 2.0;
        fits(outer, "the play leaves no locking segment", &[Remedy::LessPlay])?;
        // As far as the horns move when the wheel is turned through half its slot play where the pin is least deep.
        let swing = play.slot / 2.0 * mouth_radius / wheel_radius;
        let inner = sizes.farthest_horn(outer) + play.locking / 2.0 + swing + LEFT_OPEN * c;
        fits(outer - inner, "the horns of the wheel leave no locking segment", thinner)?;
        // As thick as the horns, where the motion leaves room for that.
        sizes.segment_radii = [outer, inner.max(outer - horn_thickness)];
        sizes.plate_shaft = shaft(ShaftOf::Plate, choices.plate_shaft, 2.0 * a - pin_diameter - play.bore)?;
        sizes.wheel_shaft = shaft(ShaftOf::Wheel, choices.wheel_shaft, 2.0 * sizes.outside_radius - play.bore)?;
        Ok(sizes)
    }

    /// Radius of the pin, in millimetres: half its diameter.
    pub fn pin_radius(&self) -> f64 {
        self.pin_diameter / 2.0
    }

    /// Diameter of the bore for a shaft of this diameter, in millimetres; zero without a shaft.
    pub fn bore(&self, shaft: f64) -> f64 {
        if shaft > 0.0 { shaft + self.play.bore } else { 0.0 }
    }

    /// Half the angle of the locking segment, in radians: it fills a locking arc over the whole dwell.
    pub fn segment_half_angle(&self) -> f64 {
        FRAC_PI_2 - self.wheel.half_pitch_angle()
    }

    /// The gap between pin and wall on either side of the pin in the middle of its slot, in millimetres: half of the slot's play.
    pub fn slot_gap(&self) -> f64 {
        self.play.slot / 2.0
    }

    /// The gap between the locking segment and the middle of the locking arc in the dwell, in millimetres: half of the locking play.
    pub fn locking_gap(&self) -> f64 {
        self.play.locking / 2.0
    }

    /// Between pin and bottom of the slot where the pin is deepest, in millimetres.
    pub fn bottom_gap(&self) -> f64 {
        self.slot_end + self.slot_width / 2.0 - self.centre_distance - self.crank_radius - self.pin_radius()
    }

    /// Whether all that is left of the parts can be made: horn, locking segment and the plate between pin and bore are at least a fifth
    /// of the pin thick, and the locking arcs reach into the ring by as much. That is our choice, as of an external wheel.
    pub fn has_sound_walls(&self) -> bool {
        // But for rounding.
        let least = (1.0 - 1e-9) * THIN * self.pin_diameter;
        let [outer, inner] = self.segment_radii;
        let reach = self.locking_arc_radius + self.mouth_radius - self.centre_distance;
        let to_pin = self.crank_radius - self.pin_radius() - self.bore(self.plate_shaft) / 2.0;
        [self.horn_thickness, outer - inner, reach, to_pin].into_iter().all(|wall| wall >= least)
    }

    /// Angle of the ends of a locking arc from its middle, seen from the wheel's axis, in radians, and seen from the arc's centre
    /// away from the wheel's axis.
    pub(crate) fn locking_ends(&self) -> [f64; 2] {
        let (c, r, arc) = (self.centre_distance, self.mouth_radius, self.locking_arc_radius);
        let x = (c * c + r * r - arc * arc) / (2.0 * c);
        let y = (r * r - x * x).max(0.0).sqrt();
        [libm::atan2(y, x), libm::atan2(y, x - c)]
    }

    /// How far a horn's tip comes from the driver's axis at most while it is beside the segment, in millimetres, of tips that are
    /// nearer than the segment's outer radius.
    fn farthest_horn(&self, outer: f64) -> f64 {
        let half_pitch = self.wheel.half_pitch_angle();
        let tip = half_pitch - self.locking_ends()[0];
        let most = self.wheel.engagement_half_angle();
        let mut farthest: f64 = 0.0;
        for k in 0..=ANGLES {
            let theta = most * f64::from(k) / f64::from(ANGLES);
            let (a, c) = (self.crank_radius, self.centre_distance);
            let phi = libm::atan2(a * libm::sin(theta), c + a * libm::cos(theta));
            // A tip that near to the driver's axis is seen from the wheel's within half a pitch of the line of centres.
            let slots = (-1..=1).map(|slot| phi + 2.0 * half_pitch * f64::from(slot));
            for at in slots.flat_map(|slot| [slot - tip, slot + tip]) {
                let (sine, cosine) = libm::sincos(at);
                let (x, y) = (self.mouth_radius * cosine - c, self.mouth_radius * sine);
                let far = libm::hypot(x, y);
                // From the middle of the segment, which is opposite to the pin.
                let angle = libm::atan2(y, x) - theta;
                let beside = PI - (angle - 2.0 * PI * libm::floor(angle / (2.0 * PI)));
                if beside.abs() < self.segment_half_angle() + BESIDE && far < outer {
                    farthest = farthest.max(far);
                }
            }
        }
        farthest
    }

    /// The outlines of ring, locking segment, driver's plate and pin, in millimetres, each about its own axis.
    ///
    /// The ring has the middle of one slot, the driver its pin, on the first axis. In the assembly the wheel's axis is the origin,
    /// the driver's is at (c, 0), the wheel is turned by φ and the driver by θ.
    pub fn outline(&self) -> InternalOutline {
        let circle = |radius| Loop::circle(Vector2::zeros(), radius, false);
        let pin = Loop::circle(Vector2::new(self.crank_radius, 0.0), self.pin_radius(), false);
        InternalOutline {
            ring: Face { outer: circle(self.outside_radius), holes: vec![self.inside()] },
            segment: Face { outer: self.segment(), holes: Vec::new() },
            plate: Face { outer: circle(self.plate_radius), holes: Vec::new() },
            pin,
        }
    }

    /// Moment of inertia about their axis, in kg m², of the ring and of the plate that closes it, both of this thickness in millimetres
    /// and of this density in kg/m³. The plate is as large as the ring and has the bore of the wheel's shaft.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Length`] and [`KinematicsError::Size`] for what is not positive and finite.
    pub fn moment_of_inertia(&self, thickness: f64, density: f64) -> Result<f64, KinematicsError> {
        let ring = self.outline().ring;
        let bore = self.bore(self.wheel_shaft);
        let holes = (bore > 0.0).then(|| Loop::circle(Vector2::zeros(), bore / 2.0, true));
        let plate = Face { outer: ring.outer.clone(), holes: holes.into_iter().collect() };
        Ok(ring.moment_of_inertia(thickness, density)? + plate.moment_of_inertia(thickness, density)?)
    }

    /// The inner line of the ring, clockwise.
    fn inside(&self) -> Loop {
        let half_pitch = self.wheel.half_pitch_angle();
        let (half, end, mouth) = (self.slot_width / 2.0, self.slot_end, self.wheel_radius);
        let corner = libm::atan2(half, mouth);
        let [seen, opening] = self.locking_ends();
        let tip = half_pitch - seen;
        let line = |from, to| Edge::Line { from: Vector2::from(from), to: Vector2::from(to) };
        let round = |start, sweep| Edge::Arc { centre: Vector2::zeros(), radius: self.mouth_radius, start, sweep };
        let (sine, cosine) = libm::sincos(half_pitch);
        // Clockwise from the locking arc behind a slot to the slot's lower corner.
        let sector = [
            Edge::Arc {
                centre: Vector2::new(cosine, sine) * self.centre_distance,
                radius: self.locking_arc_radius,
                start: half_pitch + opening,
                sweep: -2.0 * opening,
            },
            round(tip, corner - tip),
            line([mouth, half], [end, half]),
            Edge::Arc { centre: Vector2::new(end, 0.0), radius: half, start: FRAC_PI_2, sweep: -PI },
            line([end, -half], [mouth, -half]),
            round(-corner, corner - tip),
        ];
        let slots = (0..self.wheel.stations()).map(|slot| -2.0 * half_pitch * f64::from(slot));
        Loop { edges: slots.flat_map(|slot| sector.map(|edge| edge.transform(slot, Vector2::zeros()))).collect() }
    }

    /// The locking segment, counter-clockwise.
    fn segment(&self) -> Loop {
        let ([outer, inner], half) = (self.segment_radii, self.segment_half_angle());
        let arc = |radius, start, sweep| Edge::Arc { centre: Vector2::zeros(), radius, start, sweep };
        let (out, back) = (arc(outer, PI - half, 2.0 * half), arc(inner, PI + half, -2.0 * half));
        let line = |from: &Edge, to: &Edge| Edge::Line { from: from.end_point(), to: to.start_point() };
        Loop { edges: vec![out, line(&out, &back), back, line(&back, &out)] }
    }
}

/// The outlines of an internal wheel and its driver, each about its own axis.
#[derive(Clone, Debug, PartialEq)]
pub struct InternalOutline {
    /// The ring, with its slots inside.
    pub ring: Face,
    /// The driver's locking segment, in the plane of the ring.
    pub segment: Face,
    /// The driver's plate, behind the ring.
    pub plate: Face,
    /// The driver's pin, in the plane of the ring.
    pub pin: Loop,
}

fn shaft(name: ShaftOf, asked: Option<f64>, most: f64) -> Result<f64, SizesError> {
    match asked {
        None => Ok(0.0),
        Some(asked) if length("shaft's diameter", asked)? < most => Ok(asked),
        Some(asked) => Err(SizesError::Shaft { name, asked, most }),
    }
}
