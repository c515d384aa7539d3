//! Of many internal wheels that are made with errors, how many turn for certain?
//!
//! Every size is drawn as for an external wheel ([`Assemblies`](crate::wheel::as_built::Assemblies)), those of each slot and each arc
//! by themselves. That an assembly turns is shown by one way to turn it, and where that fails, it may turn in another. So the share
//! that is counted is a lower bound.
//!
//! The way: in the dwell, the ring stands as the arc about the segment has it. A slot that is off the direction of that arc by an angle δ
//! lets the pin in beside its middle, by `R δ` at the rim. As the pin goes deeper, to a distance `x` from the wheel's axis, the ring turns
//! by `δ (1 − R/x)`, and the pin stays `R δ` beside the middle. So the pin needs twice that of a slot's width, slot by slot, and the
//! segment as much more room as it moves in the ring. Where axes or crank are off, the ring is also pushed aside in the dwell, by a share
//! of what the pin would be beside the slot. The clearance over a turn is that of a ring which fills at least what this ring fills: whose
//! slots are all as narrow as the narrowest, less its error, and whose arcs are as narrow as the narrowest, less that of its place.

use crate::indexing::Indexing;
use crate::internal_clearance::{MetPin, RingMotion};
use crate::internal_sizes::InternalSizes;
use crate::wheel::as_built::{BuiltArc, BuiltSlot, ErrorShape, SizeErrors, SplitMix64, Yield};

/// Assemblies of one internal design, each made with errors of its own, with shafts and a pin as loose as the design's plays of bore
/// and pin let them be.
///
/// ```
/// use geneva_kinematics::internal_assemblies::InternalAssemblies;
/// use geneva_kinematics::internal_sizes::InternalSizes;
/// use geneva_kinematics::internal_wheel::InternalWheel;
/// use geneva_kinematics::wheel::as_built::{ErrorShape, SizeErrors};
/// use geneva_kinematics::wheel::{Choices, Play};
///
/// let choices = Choices { play: Some(Play::from_slot(0.4)), ..Choices::default() }; // mm
/// let sizes = InternalSizes::new(InternalWheel::new(6)?, 50.0, &choices)?;
/// let of = |error| InternalAssemblies::new(&sizes, SizeErrors::from_greatest(error), ErrorShape::Normal, 1).count(0..50);
/// assert_eq!(of(0.01).turning, 50); // errors of 0.01 mm are nothing to a play of 0.4 mm
/// assert!(of(0.4).turning < 25);
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct InternalAssemblies {
    drawn: InternalSizes,
    errors: SizeErrors,
    shape: ErrorShape,
    seed: u64,
}

/// Crank angles that are looked at for one assembly; where more would be needed, it is not known to turn.
const ANGLES: u32 = 100_000;

/// Shares of what a pin would come in beside a slot by which the ring is pushed to meet it, dimensionless: one of them is enough.
const SHARES: [f64; 5] = [0.0, 0.5, 0.25, 0.75, 1.0];

/// An internal wheel and its driver as they were made.
#[derive(Clone, Debug, PartialEq)]
pub struct BuiltInternalWheel {
    /// The driver's sizes as it was made, and the ring's as it was drawn.
    pub sizes: InternalSizes,
    /// The slots, counter-clockwise, the first on the first axis; a tip radius is that of the inner rim beside it.
    pub slots: Vec<BuiltSlot>,
    /// The locking arcs, counter-clockwise; the first is between the first two slots.
    pub arcs: Vec<BuiltArc>,
    /// Distance between the axes with the shafts where they are in their bores, in millimetres.
    pub centre_distance: f64,
    /// By how much the middle of the locking segment is off the line through axis and pin, in radians.
    pub segment_error: f64,
}

impl InternalAssemblies {
    /// Assemblies of a design with these greatest errors, so spread, under a seed. Of the errors, that of the disc is one of the
    /// segment's outer radius, that of the crescent one of its inner radius, and that of the tip one of the ring's inner rim.
    pub fn new(drawn: &InternalSizes, errors: SizeErrors, shape: ErrorShape, seed: u64) -> Self {
        Self { drawn: *drawn, errors, shape, seed }
    }

    /// The assembly with a number.
    pub fn assembly(&self, number: u64) -> BuiltInternalWheel {
        let mut random = SplitMix64::of_index(self.seed, number);
        let (drawn, mut sizes, errors, play) = (self.drawn, self.drawn, self.errors, self.drawn.play);
        let mut error = |greatest: f64| greatest * self.shape.draw(&mut random);
        let centres = sizes.centre_distance + error(errors.centre_distance);
        sizes.crank_radius += error(errors.crank_radius);
        sizes.pin_diameter += error(errors.pin_diameter);
        sizes.segment_radii[0] += error(errors.disc_radius);
        sizes.segment_radii[1] += error(errors.crescent_radius);
        let along = error(errors.place);
        let slots = (0..sizes.wheel.stations()).map(|_| BuiltSlot {
            direction_error: error(errors.place) / drawn.mouth_radius,
            width: drawn.slot_width + error(errors.slot_width),
            end: drawn.slot_end + error(errors.slot_end),
            tip_radius: drawn.mouth_radius + error(errors.tip_radius),
        });
        let slots = slots.collect();
        let arcs = (0..sizes.wheel.stations()).map(|_| BuiltArc {
            direction_error: error(errors.place) / drawn.centre_distance,
            radius: drawn.locking_arc_radius + error(errors.arc_radius),
            centre: drawn.centre_distance + error(errors.place),
        });
        let arcs = arcs.collect();

        let [wheel, driver] = [0; 2].map(|_| random.next_within(play.bore / 2.0));
        let shift = random.next_within(play.pin);
        let centre_distance = (driver - wheel + nalgebra::Vector2::new(centres, 0.0)).norm();
        let segment_error = along / sizes.segment_radii[0] - libm::atan2(shift.y, sizes.crank_radius + shift.x);
        sizes.crank_radius = libm::hypot(sizes.crank_radius + shift.x, shift.y);
        BuiltInternalWheel { sizes, slots, arcs, centre_distance, segment_error }
    }

    /// How many of the assemblies with these numbers turn for certain.
    pub fn count(&self, numbers: std::ops::Range<u64>) -> Yield {
        let tried = numbers.end.saturating_sub(numbers.start);
        Yield { tried, turning: numbers.filter(|number| self.assembly(*number).turns_for_certain()).count() as u64 }
    }
}

impl BuiltInternalWheel {
    /// Whether it is certain that it turns. Where it is not, the wheel may turn all the same, above all if it is pushed aside.
    pub fn turns_for_certain(&self) -> bool {
        let (filled, off) = self.filled();
        SHARES.into_iter().any(|pushed| {
            let motion = RingMotion::Met(MetPin { off, pushed });
            filled.is_clear(self.centre_distance, self.segment_error, motion, ANGLES).unwrap_or(false)
        })
    }

    /// The sizes of a ring with slots and arcs that are all alike, which fills at least what this one fills, as the slots need it for a
    /// pin; and how far at most a slot is off its place at the inner rim, in millimetres.
    fn filled(&self) -> (InternalSizes, f64) {
        let mut filled = self.sizes;
        let (rim, mut most) = (filled.mouth_radius, 0.0_f64);
        let all =
            [&mut filled.slot_width, &mut filled.slot_end, &mut filled.mouth_radius, &mut filled.locking_arc_radius];
        all.into_iter().for_each(|least| *least = f64::INFINITY);
        let mut before = self.arcs.last();
        for (slot, arc) in self.slots.iter().zip(&self.arcs) {
            let off = |arc: &BuiltArc| rim * (slot.direction_error - arc.direction_error).abs();
            let beside = off(arc).max(before.map_or(0.0, off));
            before = Some(arc);
            most = most.max(beside);
            filled.slot_width = filled.slot_width.min(slot.width - 2.0 * beside);
            filled.slot_end = filled.slot_end.min(slot.end);
            filled.mouth_radius = filled.mouth_radius.min(slot.tip_radius);
            let within = arc.radius - (arc.centre - filled.centre_distance).abs();
            filled.locking_arc_radius = filled.locking_arc_radius.min(within);
        }
        filled.play.slot = filled.slot_width - filled.pin_diameter;
        // The corners of the slots, which are on the rim.
        let corner = filled.mouth_radius * filled.mouth_radius - filled.slot_width * filled.slot_width / 4.0;
        filled.wheel_radius = corner.max(0.0).sqrt();
        (filled, most)
    }
}
