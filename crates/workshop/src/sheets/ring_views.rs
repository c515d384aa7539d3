//! The views of the parts that only an internal wheel has: ring, ring plate and locking segment.

use super::callout::{Row, Side};
use super::dimension::{Measured, PrintedDimension};
use super::ink::Pen;
use super::length::mm;
use super::limits::{DISC, Limits, RIM, SLOT, general_tolerance};
use super::making::Making;
use super::part_views::{LOWER_RIGHT, UPRIGHT, nearest_arc, rim_point};
use super::view::{Target, View};
use crate::geometry::{Point, direction};
use crate::parts::{HolePurpose, Part};
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::{Loop, ToleranceClass, ToleranceLetter};
use std::f64::consts::{FRAC_PI_2, PI};

/// The class of a ring's inner rim, which may be wider: our choice, as of an external wheel's rim.
const INSIDE: ToleranceClass = ToleranceClass { letter: ToleranceLetter::UpperH, grade: 9 };

impl Making<'_> {
    /// The ring, with its slots and locking arcs inside.
    pub(super) fn ring(&self, part: &Part, sizes: &InternalSizes) -> View {
        let mut view = View::new(part, UPRIGHT);
        let inside = view.part.holes.iter().find(|hole| hole.purpose == HolePurpose::Inside);
        let inside = inside.map_or_else(|| Loop { edges: Vec::new() }, |hole| hole.outline.clone());
        let half = sizes.slot_width / 2.0;
        let wall = |x: f64| Point::new(x, sizes.slot_end);
        view.add(Target::Across([wall(-half), wall(half)]), Side::Right, self.slot_rows(sizes.slot_width));
        view.add(
            Target::Along([Point::zeros(), Point::new(0.0, sizes.slot_end)]),
            Side::Left,
            self.slot_end_rows(sizes.slot_width, [self.chain.slot_end, f64::INFINITY]),
        );
        let arc = nearest_arc(&inside, sizes.locking_arc_radius, direction(0.12 * PI));
        view.add(Target::Edge(arc), Side::Right, self.arc_rows(sizes.locking_arc_radius));
        let rim = rim_point(&inside, sizes.mouth_radius, direction(0.9 * PI));
        let size = PrintedDimension::new(Measured::RingInside, "inside Ø", 2.0 * sizes.mouth_radius, "");
        let limits = self.held(Limits::class(INSIDE, 2.0 * sizes.mouth_radius), [f64::INFINITY; 2]);
        view.add(Target::Edge(rim), Side::Left, vec![Row::Size(size.limited(limits))]);
        self.add_outside(&mut view, part, sizes, true);
        view.add_holes(self);
        view.notes.push(self.surface("Slot walls, locking arcs", 1.6));
        if self.is_machined() {
            view.notes.push("Corners of mouths: 0.1 at most.".to_owned());
        }
        if self.mounting.disc_dowels.is_none() {
            view.notes.push("No dowels are drawn: bond ring and ring plate, or drill both together.".to_owned());
        }
        view
    }

    /// The plate that closes the ring.
    pub(super) fn ring_plate(&self, part: &Part, sizes: &InternalSizes) -> View {
        let mut view = View::new(part, UPRIGHT);
        let is_datum = !view.has_bore();
        self.add_outside(&mut view, part, sizes, is_datum);
        view.add_holes(self);
        view.notes.push("It closes the ring on the side away from the driver, both about one axis.".to_owned());
        view
    }

    /// The outside of ring and ring plate, which is the datum where they have no bore.
    fn add_outside(&self, view: &mut View, part: &Part, sizes: &InternalSizes, is_datum: bool) {
        let size = PrintedDimension::new(Measured::Rim, "Ø", 2.0 * sizes.outside_radius, "");
        let limits = self.held(Limits::class(RIM, 2.0 * sizes.outside_radius), [f64::INFINITY; 2]);
        let mut rows = vec![Row::Size(size.limited(limits)), self.thickness(part)];
        if is_datum {
            rows.insert(1, Row::Datum("A"));
        }
        view.add(Target::Edge(direction(LOWER_RIGHT) * sizes.outside_radius), Side::Right, rows);
    }

    /// The locking segment, below the driver's axis as the pin is above it.
    pub(super) fn segment(&self, part: &Part, sizes: &InternalSizes) -> View {
        let mut view = View::new(part, UPRIGHT);
        let ([outer, inner], half) = (sizes.segment_radii, sizes.segment_half_angle());
        let at = |angle: f64, radius: f64| direction(angle - FRAC_PI_2) * radius;
        let free = [f64::INFINITY; 2];
        let size = PrintedDimension::new(Measured::SegmentOuter, "R", outer, "");
        let limits = self.held_radius(Limits::of_radius(DISC, outer), [f64::INFINITY, self.chain.locking]);
        view.add(
            Target::Edge(at(0.5 * half, outer)),
            Side::Right,
            vec![Row::Size(size.limited(limits)), self.thickness(part)],
        );
        let size = PrintedDimension::new(Measured::SegmentInner, "R", inner, "");
        let limits = self.held_radius(Limits::of_radius(SLOT, inner), free);
        let about = Row::Words("both arcs about the driver's axis".to_owned());
        view.add(Target::Edge(at(-0.4 * half, inner)), Side::Left, vec![Row::Size(size.limited(limits)), about]);
        // Longer, it would be in the way of the horns; shorter, it lets go of the wheel a little before the pin has it.
        let chord = 2.0 * outer * libm::sin(half);
        let general = general_tolerance(chord);
        let size = PrintedDimension::new(Measured::SegmentChord, "", chord, "");
        let size = size.limited(self.held(Limits::new([-general, 0.0]), free));
        let words = format!("ends at {}° from one another", mm(2.0 * half.to_degrees()));
        view.add(
            Target::Across([at(-half, outer), at(half, outer)]),
            Side::Right,
            vec![Row::Size(size), Row::Words(words)],
        );
        view.part.marks.push(Point::zeros());
        view.lines.push((Pen::Centre, vec![Point::zeros(), at(0.0, outer)]));
        view.notes.push(self.surface("Outer arc", 1.6));
        let to =
            self.limits.process.map_or(self.chain.crank, |numbers| self.chain.crank.max(numbers.error.value / 2.0));
        view.notes.push(format!("On the plate: the segment's middle in line with axis and pin to {}.", mm(to)));
        if !self.is_one_piece() {
            view.notes.push(
                "No dowels or screws are drawn: bond the segment to the plate, or drill both together.".to_owned(),
            );
        }
        view
    }
}
