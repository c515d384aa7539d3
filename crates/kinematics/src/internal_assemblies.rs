//! Of many internal wheels that are made with errors, how many turn for certain?
//!
//! Every size is drawn as for an external wheel ([`Assemblies`](crate::wheel::as_built::Assemblies)), those of each slot and each arc by
//! themselves. The clearance over a turn is found for a ring whose slots and arcs are all alike, so it is found for a ring all of
//! whose slots and arcs are as narrow, as shallow and as far from their places as the worst of this ring. The wheel is in the middle
//! of its play and is not pushed aside. Where nothing touches then, the assembly turns; where something does, it may still turn. So
//! the share that is counted is a lower bound.

use crate::indexing::Indexing;
use crate::internal_sizes::InternalSizes;
use crate::wheel::as_built::{ErrorShape, SizeErrors, SplitMix64, Yield};

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
/// assert!(of(0.3).turning < 25);
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

/// An assembly as its clearance is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BuiltInternalWheel {
    /// Its sizes, those of slots and arcs the worst of all of them, but for the distance between the axes.
    pub sizes: InternalSizes,
    /// Distance between the axes with the shafts where they are in their bores, in millimetres.
    pub centre_distance: f64,
    /// By how much the middle of the locking segment is off the line through axis and pin, in radians.
    pub segment_error: f64,
    /// How far at most a slot is off its place between the arcs, at the ring's inner rim, in millimetres.
    pub slot_error: f64,
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
        let (mut sizes, errors, play) = (self.drawn, self.errors, self.drawn.play);
        let mut error = |greatest: f64| greatest * self.shape.draw(&mut random);
        let centres = sizes.centre_distance + error(errors.centre_distance);
        sizes.crank_radius += error(errors.crank_radius);
        sizes.pin_diameter += error(errors.pin_diameter);
        sizes.segment_radii[0] += error(errors.disc_radius);
        sizes.segment_radii[1] += error(errors.crescent_radius);
        let along = error(errors.place);
        let (mut least, mut slot_error) = ([f64::INFINITY; 4], 0.0_f64);
        for _ in 0..sizes.wheel.stations() {
            let slot = [errors.slot_width, errors.slot_end, errors.tip_radius].map(&mut error);
            let arc = error(errors.arc_radius) - error(errors.place).abs();
            for (least, found) in least.iter_mut().zip(slot.into_iter().chain([arc])) {
                *least = least.min(found);
            }
            // The slot's own place, and that of the arc beside it.
            slot_error = slot_error.max((error(errors.place) - error(errors.place)).abs());
        }
        let [width, end, rim, arc] = least;
        // As if the slot's error took some of its width on either side.
        sizes.slot_width += width - 2.0 * slot_error;
        sizes.play.slot = sizes.slot_width - sizes.pin_diameter;
        sizes.slot_end += end;
        sizes.mouth_radius += rim;
        sizes.locking_arc_radius += arc;

        let [wheel, driver] = [0; 2].map(|_| random.next_within(play.bore / 2.0));
        let shift = random.next_within(play.pin);
        let distance = (driver - wheel + nalgebra::Vector2::new(centres, 0.0)).norm();
        let segment_error = along / sizes.segment_radii[0] - libm::atan2(shift.y, sizes.crank_radius + shift.x);
        sizes.crank_radius = libm::hypot(sizes.crank_radius + shift.x, shift.y);
        BuiltInternalWheel { sizes, centre_distance: distance, segment_error, slot_error }
    }

    /// How many of the assemblies with these numbers turn for certain.
    pub fn count(&self, numbers: std::ops::Range<u64>) -> Yield {
        let turns = |number: &u64| {
            let BuiltInternalWheel { sizes, centre_distance, segment_error, slot_error } = self.assembly(*number);
            sizes.is_clear(centre_distance, segment_error, slot_error, ANGLES).unwrap_or(false)
        };
        let tried = numbers.end.saturating_sub(numbers.start);
        Yield { tried, turning: numbers.filter(turns).count() as u64 }
    }
}
